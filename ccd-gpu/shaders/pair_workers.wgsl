// Generated from ccd-shaders by `cargo xtask shaders`: not to be edited.
struct type_7 {
    member: array<u32, 3>,
    member_1: u32,
    member_2: array<u32, 4>,
    member_3: f32,
    member_4: f32,
    member_5: f32,
    member_6: f32,
    member_7: array<u32, 2>,
    member_8: array<array<u32, 2>, 3>,
    member_9: array<u32, 2>,
    member_10: array<u32, 2>,
    member_11: f32,
    member_12: f32,
    member_13: f32,
    member_14: array<u32, 2>,
    member_15: array<u32, 2>,
    member_16: array<u32, 2>,
}

struct type_8 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_9 {
    member: u32,
    member_1: u32,
}

struct type_11 {
    member: array<u32>,
}

struct type_17 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
}

struct type_19 {
    member: array<type_17>,
}

struct type_20 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
    member_7: u32,
    member_8: u32,
    member_9: u32,
    member_10: u32,
    member_11: u32,
    member_12: u32,
    member_13: u32,
    member_14: u32,
    member_15: u32,
    member_16: u32,
    member_17: u32,
    member_18: u32,
}

struct type_21 {
    member: type_7,
    member_1: type_8,
    member_2: type_20,
}

struct type_22 {
    member: type_21,
}

struct type_24 {
    member: array<array<u32, 2>, 4>,
    member_1: array<array<u32, 2>, 4>,
}

struct type_26 {
    member: array<u32, 2>,
    member_1: u32,
}

struct type_27 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: array<u32, 2>,
    member_3: array<u32, 2>,
}

struct type_30 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_22;
@group(0) @binding(6) 
var<storage, read_write> front: type_11;
@group(0) @binding(5) 
var<storage, read_write> pairs: type_30;
@group(0) @binding(1) 
var<storage> a: type_19;
@group(0) @binding(2) 
var<storage> b: type_19;
@group(0) @binding(3) 
var<storage, read_write> control: type_30;
@group(0) @binding(4) 
var<storage, read_write> nodes: type_30;
var<workgroup> shared_: array<atomic<u32>, 22>;
var<workgroup> state: array<u32, 1>;
var<workgroup> stack: array<u32, 2048>;
var<workgroup> sums: array<u32, 256>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_212_: type_9;
    var phi_296_: u32;
    var phi_297_: u32;
    var phi_433_: u32;
    var phi_434_: u32;
    var phi_435_: u32;
    var phi_436_: u32;
    var phi_437_: u32;
    var phi_457_: u32;
    var phi_458_: u32;
    var phi_541_: array<u32, 2>;
    var phi_542_: array<u32, 2>;
    var phi_715_: type_24;
    var phi_716_: type_24;
    var phi_717_: bool;
    var phi_718_: type_24;
    var phi_719_: bool;
    var phi_779_: bool;
    var phi_780_: bool;
    var phi_781_: bool;
    var phi_782_: bool;
    var phi_783_: bool;
    var phi_784_: bool;
    var phi_979_: type_24;
    var phi_980_: bool;
    var phi_981_: type_24;
    var phi_982_: bool;
    var phi_1189_: type_24;
    var phi_1190_: type_24;
    var phi_1191_: type_24;
    var phi_1192_: bool;
    var phi_1193_: type_24;
    var phi_1194_: type_24;
    var phi_1195_: bool;
    var phi_1199_: type_24;
    var phi_1210_: array<array<u32, 2>, 4>;
    var phi_1246_: type_26;
    var phi_1247_: type_26;
    var phi_1283_: type_26;
    var phi_1284_: type_26;
    var phi_1320_: type_26;
    var phi_1321_: type_26;
    var phi_1357_: type_26;
    var phi_1358_: type_26;
    var phi_1386_: type_26;
    var phi_1387_: type_26;
    var phi_1388_: type_26;
    var phi_1389_: type_26;
    var phi_1390_: type_26;
    var phi_1720_: array<u32, 3>;
    var phi_1729_: array<u32, 3>;
    var phi_1738_: array<u32, 3>;
    var phi_1456_: type_9;
    var phi_1459_: u32;
    var phi_1461_: u32;
    var phi_1463_: u32;
    var phi_1460_: u32;
    var phi_1502_: u32;
    var phi_1462_: u32;
    var phi_1464_: u32;
    var local: u32;
    var phi_1529_: type_9;
    var phi_1532_: u32;
    var phi_1534_: u32;
    var phi_1536_: u32;
    var phi_1533_: u32;
    var phi_1575_: u32;
    var phi_1535_: u32;
    var phi_1537_: u32;
    var local_1: u32;
    var phi_1589_: u32;
    var phi_1812_: type_27;
    var phi_2047_: type_9;
    var phi_2211_: type_9;
    var phi_2375_: type_9;
    var phi_2539_: type_9;
    var phi_2592_: bool;
    var phi_2593_: bool;
    var phi_2621_: u32;
    var phi_2741_: type_9;
    var phi_2859_: type_9;
    var phi_2964_: type_9;
    var phi_3080_: bool;
    var phi_3081_: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e59 = id_2;
    let _e60 = n_2;
    let _e61 = lane_2;
    let _e73 = ((_e59.y * _e60.x) + _e59.x);
    let _e75 = params.member.member_2;
    let _e77 = params.member.member_1;
    let _e80 = (_e77.member_1 % 2u);
    let _e82 = atomicLoad((&control.member[_e77.member_1]));
    let _e84 = select(_e82, _e75.member_3, (_e75.member_3 < _e82));
    let _e85 = (_e80 * _e75.member_3);
    let _e87 = ((1u - _e80) * _e75.member_3);
    if (_e61 == 0u) {
        atomicStore((&shared_[0u]), 0u);
        atomicStore((&shared_[5u]), 0u);
        atomicStore((&shared_[15u]), 0u);
        atomicStore((&shared_[16u]), 0u);
    }
    phi_212_ = type_9(0u, _e75.member_12);
    loop {
        let _e96 = phi_212_;
        let _e99 = (_e96.member < _e96.member_1);
        if (bitcast<i32>(select(0u, 1u, _e99)) != 0i) {
            if (_e61 == 0u) {
                let _e119 = atomicLoad((&shared_[0u]));
                let _e121 = select(_e119, 128u, (128u < _e119));
                if (_e75.member_9 > 0u) {
                    if (select(type_9().member_1, _e96.member, _e99) >= 16u) {
                        let _e126 = atomicLoad((&control.member[(1024u + _e77.member_1)]));
                        phi_296_ = select(0u, 2u, select(false, ((_e126 * 100u) >= (_e75.member_9 << bitcast<u32>((_e75.member_7 & 31u)))), (_e75.member_9 > 0u)));
                    } else {
                        phi_296_ = 0u;
                    }
                    let _e136 = phi_296_;
                    phi_297_ = _e136;
                } else {
                    phi_297_ = 0u;
                }
                let _e138 = phi_297_;
                let _e139 = (128u - _e121);
                if (_e138 == 0u) {
                    if (_e139 > 0u) {
                        let _e143 = atomicLoad((&shared_[5u]));
                        if (_e75.member_6 == 0u) {
                            let _e204 = (select(0u, ((((_e84 - 1u) - _e73) >> bitcast<u32>((_e75.member_7 & 31u))) + 1u), (_e73 < _e84)) - _e143);
                            let _e206 = select(_e204, _e139, (_e139 < _e204));
                            atomicStore((&shared_[3u]), (_e73 + (_e143 << bitcast<u32>((_e75.member_7 & 31u)))));
                            atomicStore((&shared_[4u]), (1u << bitcast<u32>((_e75.member_7 & 31u))));
                            atomicStore((&shared_[5u]), (_e143 + _e206));
                            phi_435_ = _e206;
                        } else {
                            if (_e75.member_6 == 2u) {
                                let _e179 = (((_e84 + (1u << bitcast<u32>((_e75.member_7 & 31u)))) - 1u) >> bitcast<u32>((_e75.member_7 & 31u)));
                                let _e180 = (_e73 * _e179);
                                let _e182 = select(_e180, _e84, (_e84 < _e180));
                                let _e183 = (_e84 - _e182);
                                let _e186 = (select(_e179, _e183, (_e183 < _e179)) - _e143);
                                let _e188 = select(_e186, _e139, (_e139 < _e186));
                                atomicStore((&shared_[3u]), (_e182 + _e143));
                                atomicStore((&shared_[4u]), 1u);
                                atomicStore((&shared_[5u]), (_e143 + _e188));
                                phi_434_ = _e188;
                            } else {
                                if (_e143 == 0u) {
                                    let _e150 = (_e84 >> bitcast<u32>(((_e75.member_7 + 2u) & 31u)));
                                    let _e152 = select(_e75.member_8, _e150, (_e75.member_8 < _e150));
                                    let _e154 = select(_e152, 128u, (128u < _e152));
                                    let _e156 = select(_e154, _e139, (_e139 < _e154));
                                    let _e159 = atomicAdd((&control.member[(512u + _e77.member_1)]), _e156);
                                    let _e162 = (_e84 - select(_e159, _e84, (_e84 < _e159)));
                                    let _e164 = select(_e162, _e156, (_e156 < _e162));
                                    atomicStore((&shared_[3u]), _e159);
                                    atomicStore((&shared_[4u]), 1u);
                                    atomicStore((&shared_[5u]), select(0u, 1u, (_e164 < _e156)));
                                    phi_433_ = _e164;
                                } else {
                                    phi_433_ = 0u;
                                }
                                let _e171 = phi_433_;
                                phi_434_ = _e171;
                            }
                            let _e195 = phi_434_;
                            phi_435_ = _e195;
                        }
                        let _e219 = phi_435_;
                        phi_436_ = _e219;
                    } else {
                        phi_436_ = 0u;
                    }
                    let _e221 = phi_436_;
                    phi_437_ = _e221;
                } else {
                    phi_437_ = 0u;
                }
                let _e223 = phi_437_;
                if (_e138 == 0u) {
                    if ((_e121 + _e223) == 0u) {
                        if (_e75.member_9 > 0u) {
                            let _e230 = atomicAdd((&control.member[(1024u + _e77.member_1)]), 1u);
                        }
                        phi_457_ = 1u;
                    } else {
                        phi_457_ = _e138;
                    }
                    let _e232 = phi_457_;
                    phi_458_ = _e232;
                } else {
                    phi_458_ = _e138;
                }
                let _e234 = phi_458_;
                atomicStore((&shared_[1u]), _e121);
                atomicStore((&shared_[2u]), _e223);
                atomicStore((&shared_[6u]), 0u);
                atomicStore((&shared_[7u]), 0u);
                atomicStore((&shared_[8u]), 0u);
                state[0u] = _e234;
            }
            let _e242 = workgroupUniformLoad((&state[0u]));
            if (_e242 != 0u) {
                phi_2592_ = false;
            } else {
                let _e245 = atomicLoad((&shared_[1u]));
                let _e247 = atomicLoad((&shared_[2u]));
                if (_e61 < _e245) {
                    let _e270 = atomicLoad((&shared_[0u]));
                    let _e273 = (2u * ((_e270 - 1u) - _e61));
                    let _e275 = stack[_e273];
                    let _e278 = stack[(_e273 + 1u)];
                    phi_542_ = array<u32, 2>(_e275, _e278);
                } else {
                    if (_e61 < (_e245 + _e247)) {
                        let _e252 = atomicLoad((&shared_[3u]));
                        let _e255 = atomicLoad((&shared_[4u]));
                        let _e259 = (2u * (_e85 + (_e252 + ((_e61 - _e245) * _e255))));
                        let _e262 = atomicLoad((&nodes.member[(4u + _e259)]));
                        let _e265 = atomicLoad((&nodes.member[(_e259 + 5u)]));
                        phi_541_ = array<u32, 2>(_e262, _e265);
                    } else {
                        phi_541_ = array<u32, 2>(4294967295u, 4294967295u);
                    }
                    let _e268 = phi_541_;
                    phi_542_ = _e268;
                }
                let _e281 = phi_542_;
                let _e284 = params.member.member_2.member;
                let _e288 = params.member.member_2.member;
                let _e289 = (_e288 == 0u);
                let _e295 = params.member.member.member[select(1u, 0u, _e289)];
                let _e296 = (_e295 - 1u);
                let _e300 = params.member.member.member[select(1u, 2u, _e289)];
                let _e301 = (_e300 - 1u);
                let _e304 = params.member.member_2.member_1;
                if (_e281[0] != 4294967295u) {
                    let _e312 = a.member[_e281[0]];
                    let _e314 = b.member[_e281[1]];
                    if (_e284 == 1u) {
                        if (_e281[0] == _e281[1]) {
                            if (_e312.member_3 == 4294967295u) {
                                phi_715_ = type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)));
                            } else {
                                let _e320 = a.member[_e312.member_1];
                                let _e323 = a.member[_e312.member_3];
                                let _e326 = !((_e320.member_3 == 4294967295u));
                                let _e337 = type_24(array<array<u32, 2>, 4>(array<u32, 2>(select(4294967295u, _e312.member_1, _e326), select(4294967295u, _e312.member_1, _e326)), type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[1], type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[2], type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[3]), type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1);
                                let _e349 = type_24(array<array<u32, 2>, 4>(_e337.member[0], array<u32, 2>(_e312.member_1, _e337.member[1][1]), _e337.member[2], _e337.member[3]), _e337.member_1);
                                let _e357 = type_24(array<array<u32, 2>, 4>(_e349.member[0], array<u32, 2>(_e312.member_1, _e312.member_3), _e349.member[2], _e349.member[3]), _e349.member_1);
                                let _e360 = !((_e323.member_3 == 4294967295u));
                                let _e371 = type_24(array<array<u32, 2>, 4>(_e357.member[0], _e357.member[1], array<u32, 2>(select(4294967295u, _e312.member_3, _e360), select(4294967295u, _e312.member_3, _e360)), _e357.member[3]), _e357.member_1);
                                let _e374 = type_24(_e371.member, _e371.member);
                                let _e401 = ((((((_e320.member[0] <= _e323.member_2[0]) && (_e323.member[0] <= _e320.member_2[0])) && (_e320.member[1] <= _e323.member_2[1])) && (_e323.member[1] <= _e320.member_2[1])) && (_e320.member[2] <= _e323.member_2[2])) && (_e323.member[2] <= _e320.member_2[2]));
                                phi_715_ = type_24(_e374.member, array<array<u32, 2>, 4>(_e374.member_1[0], array<u32, 2>(select(4294967295u, _e312.member_1, _e401), select(4294967295u, _e312.member_3, _e401)), _e374.member_1[2], _e374.member_1[3]));
                            }
                            let _e413 = phi_715_;
                            phi_716_ = _e413;
                            phi_717_ = false;
                        } else {
                            phi_716_ = type_24();
                            phi_717_ = true;
                        }
                        let _e415 = phi_716_;
                        let _e417 = phi_717_;
                        phi_718_ = _e415;
                        phi_719_ = _e417;
                    } else {
                        phi_718_ = type_24();
                        phi_719_ = true;
                    }
                    let _e419 = phi_718_;
                    let _e421 = phi_719_;
                    if _e421 {
                        let _e424 = !((_e312.member_3 == 4294967295u));
                        let _e427 = !((_e314.member_3 == 4294967295u));
                        if select(_e427, true, _e424) {
                            if _e424 {
                                if _e427 {
                                    if (select(0u, 1u, (_e304 == 0u)) == 0u) {
                                        let _e456 = ((((_e314.member_2[0] - _e314.member[0]) * (_e314.member_2[1] - _e314.member[1])) * (_e314.member_2[2] - _e314.member[2])) > (((_e312.member_2[0] - _e312.member[0]) * (_e312.member_2[1] - _e312.member[1])) * (_e312.member_2[2] - _e312.member[2])));
                                        phi_779_ = _e456;
                                        phi_780_ = !(_e456);
                                    } else {
                                        phi_779_ = _e427;
                                        phi_780_ = _e424;
                                    }
                                    let _e459 = phi_779_;
                                    let _e461 = phi_780_;
                                    phi_781_ = _e459;
                                    phi_782_ = _e461;
                                } else {
                                    phi_781_ = _e427;
                                    phi_782_ = _e424;
                                }
                                let _e463 = phi_781_;
                                let _e465 = phi_782_;
                                phi_783_ = _e463;
                                phi_784_ = _e465;
                            } else {
                                phi_783_ = _e427;
                                phi_784_ = _e424;
                            }
                            let _e467 = phi_783_;
                            let _e469 = phi_784_;
                            if _e469 {
                                if _e467 {
                                    let _e472 = a.member[_e312.member_1];
                                    let _e477 = a.member[_e312.member_3];
                                    let _e482 = b.member[_e314.member_1];
                                    let _e487 = b.member[_e314.member_3];
                                    let _e525 = ((((((_e472.member[0] <= _e482.member_2[0]) && (_e482.member[0] <= _e472.member_2[0])) && (_e472.member[1] <= _e482.member_2[1])) && (_e482.member[1] <= _e472.member_2[1])) && (_e472.member[2] <= _e482.member_2[2])) && (_e482.member[2] <= _e472.member_2[2]));
                                    let _e551 = ((((((_e472.member[0] <= _e487.member_2[0]) && (_e487.member[0] <= _e472.member_2[0])) && (_e472.member[1] <= _e487.member_2[1])) && (_e487.member[1] <= _e472.member_2[1])) && (_e472.member[2] <= _e487.member_2[2])) && (_e487.member[2] <= _e472.member_2[2]));
                                    let _e577 = ((((((_e477.member[0] <= _e482.member_2[0]) && (_e482.member[0] <= _e477.member_2[0])) && (_e477.member[1] <= _e482.member_2[1])) && (_e482.member[1] <= _e477.member_2[1])) && (_e477.member[2] <= _e482.member_2[2])) && (_e482.member[2] <= _e477.member_2[2]));
                                    let _e603 = ((((((_e477.member[0] <= _e487.member_2[0]) && (_e487.member[0] <= _e477.member_2[0])) && (_e477.member[1] <= _e487.member_2[1])) && (_e487.member[1] <= _e477.member_2[1])) && (_e477.member[2] <= _e487.member_2[2])) && (_e487.member[2] <= _e477.member_2[2]));
                                    phi_979_ = type_24(array<array<u32, 2>, 4>(array<u32, 2>(_e312.member_1, _e314.member_1), array<u32, 2>(_e312.member_1, _e314.member_3), array<u32, 2>(_e312.member_3, _e314.member_1), array<u32, 2>(_e312.member_3, _e314.member_3)), array<array<u32, 2>, 4>(array<u32, 2>(select(4294967295u, _e312.member_1, _e525), select(4294967295u, _e314.member_1, _e525)), array<u32, 2>(select(4294967295u, _e312.member_1, _e551), select(4294967295u, _e314.member_3, _e551)), array<u32, 2>(select(4294967295u, _e312.member_3, _e577), select(4294967295u, _e314.member_1, _e577)), array<u32, 2>(select(4294967295u, _e312.member_3, _e603), select(4294967295u, _e314.member_3, _e603))));
                                    phi_980_ = false;
                                } else {
                                    phi_979_ = type_24();
                                    phi_980_ = true;
                                }
                                let _e610 = phi_979_;
                                let _e612 = phi_980_;
                                phi_981_ = _e610;
                                phi_982_ = _e612;
                            } else {
                                phi_981_ = type_24();
                                phi_982_ = true;
                            }
                            let _e614 = phi_981_;
                            let _e616 = phi_982_;
                            if _e616 {
                                if _e469 {
                                    let _e706 = a.member[_e312.member_1];
                                    let _e711 = a.member[_e312.member_3];
                                    let _e720 = type_24(array<array<u32, 2>, 4>(array<u32, 2>(_e312.member_1, _e281[1]), array<u32, 2>(_e312.member_3, _e281[1]), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1);
                                    let _e745 = ((((((_e706.member[0] <= _e314.member_2[0]) && (_e314.member[0] <= _e706.member_2[0])) && (_e706.member[1] <= _e314.member_2[1])) && (_e314.member[1] <= _e706.member_2[1])) && (_e706.member[2] <= _e314.member_2[2])) && (_e314.member[2] <= _e706.member_2[2]));
                                    let _e755 = type_24(_e720.member, array<array<u32, 2>, 4>(array<u32, 2>(select(4294967295u, _e312.member_1, _e745), select(4294967295u, _e281[1], _e745)), _e720.member_1[1], _e720.member_1[2], _e720.member_1[3]));
                                    let _e780 = ((((((_e711.member[0] <= _e314.member_2[0]) && (_e314.member[0] <= _e711.member_2[0])) && (_e711.member[1] <= _e314.member_2[1])) && (_e314.member[1] <= _e711.member_2[1])) && (_e711.member[2] <= _e314.member_2[2])) && (_e314.member[2] <= _e711.member_2[2]));
                                    phi_1189_ = type_24(_e755.member, array<array<u32, 2>, 4>(_e755.member_1[0], array<u32, 2>(select(4294967295u, _e312.member_3, _e780), select(4294967295u, _e281[1], _e780)), _e755.member_1[2], _e755.member_1[3]));
                                } else {
                                    let _e619 = b.member[_e314.member_1];
                                    let _e624 = b.member[_e314.member_3];
                                    let _e633 = type_24(array<array<u32, 2>, 4>(array<u32, 2>(_e281[0], _e314.member_1), array<u32, 2>(_e281[0], _e314.member_3), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1);
                                    let _e658 = ((((((_e312.member[0] <= _e619.member_2[0]) && (_e619.member[0] <= _e312.member_2[0])) && (_e312.member[1] <= _e619.member_2[1])) && (_e619.member[1] <= _e312.member_2[1])) && (_e312.member[2] <= _e619.member_2[2])) && (_e619.member[2] <= _e312.member_2[2]));
                                    let _e668 = type_24(_e633.member, array<array<u32, 2>, 4>(array<u32, 2>(select(4294967295u, _e281[0], _e658), select(4294967295u, _e314.member_1, _e658)), _e633.member_1[1], _e633.member_1[2], _e633.member_1[3]));
                                    let _e693 = ((((((_e312.member[0] <= _e624.member_2[0]) && (_e624.member[0] <= _e312.member_2[0])) && (_e312.member[1] <= _e624.member_2[1])) && (_e624.member[1] <= _e312.member_2[1])) && (_e312.member[2] <= _e624.member_2[2])) && (_e624.member[2] <= _e312.member_2[2]));
                                    phi_1189_ = type_24(_e668.member, array<array<u32, 2>, 4>(_e668.member_1[0], array<u32, 2>(select(4294967295u, _e281[0], _e693), select(4294967295u, _e314.member_3, _e693)), _e668.member_1[2], _e668.member_1[3]));
                                }
                                let _e792 = phi_1189_;
                                phi_1190_ = _e792;
                            } else {
                                phi_1190_ = _e614;
                            }
                            let _e794 = phi_1190_;
                            phi_1191_ = _e794;
                            phi_1192_ = false;
                        } else {
                            phi_1191_ = type_24();
                            phi_1192_ = true;
                        }
                        let _e796 = phi_1191_;
                        let _e798 = phi_1192_;
                        phi_1193_ = _e796;
                        phi_1194_ = type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)));
                        phi_1195_ = _e798;
                    } else {
                        phi_1193_ = type_24();
                        phi_1194_ = _e419;
                        phi_1195_ = true;
                    }
                    let _e800 = phi_1193_;
                    let _e802 = phi_1194_;
                    let _e804 = phi_1195_;
                    if _e804 {
                        phi_1199_ = _e802;
                    } else {
                        phi_1199_ = _e800;
                    }
                    let _e806 = phi_1199_;
                    let _e810 = params.member.member_2.member_4;
                    if (_e810 > 0u) {
                        phi_1210_ = _e806.member;
                    } else {
                        phi_1210_ = _e806.member_1;
                    }
                    let _e814 = phi_1210_;
                    let _e826 = select(select(2u, 1u, select(true, select(true, false, (_e806.member_1[0][1] >= _e301)), (_e806.member_1[0][0] >= _e296))), 0u, (_e806.member_1[0][0] == 4294967295u));
                    let _e827 = type_26(_e806.member_1[0], _e826);
                    if (_e826 == 0u) {
                        if (_e814[0][0] != 4294967295u) {
                            phi_1246_ = type_26(_e814[0], 3u);
                        } else {
                            phi_1246_ = _e827;
                        }
                        let _e833 = phi_1246_;
                        phi_1247_ = _e833;
                    } else {
                        phi_1247_ = _e827;
                    }
                    let _e835 = phi_1247_;
                    let _e847 = select(select(2u, 1u, select(true, select(true, false, (_e806.member_1[1][1] >= _e301)), (_e806.member_1[1][0] >= _e296))), 0u, (_e806.member_1[1][0] == 4294967295u));
                    let _e848 = type_26(_e806.member_1[1], _e847);
                    if (_e847 == 0u) {
                        if (_e814[1][0] != 4294967295u) {
                            phi_1283_ = type_26(_e814[1], 3u);
                        } else {
                            phi_1283_ = _e848;
                        }
                        let _e854 = phi_1283_;
                        phi_1284_ = _e854;
                    } else {
                        phi_1284_ = _e848;
                    }
                    let _e856 = phi_1284_;
                    let _e868 = select(select(2u, 1u, select(true, select(true, false, (_e806.member_1[2][1] >= _e301)), (_e806.member_1[2][0] >= _e296))), 0u, (_e806.member_1[2][0] == 4294967295u));
                    let _e869 = type_26(_e806.member_1[2], _e868);
                    if (_e868 == 0u) {
                        if (_e814[2][0] != 4294967295u) {
                            phi_1320_ = type_26(_e814[2], 3u);
                        } else {
                            phi_1320_ = _e869;
                        }
                        let _e875 = phi_1320_;
                        phi_1321_ = _e875;
                    } else {
                        phi_1321_ = _e869;
                    }
                    let _e877 = phi_1321_;
                    let _e889 = select(select(2u, 1u, select(true, select(true, false, (_e806.member_1[3][1] >= _e301)), (_e806.member_1[3][0] >= _e296))), 0u, (_e806.member_1[3][0] == 4294967295u));
                    let _e890 = type_26(_e806.member_1[3], _e889);
                    if (_e889 == 0u) {
                        if (_e814[3][0] != 4294967295u) {
                            phi_1357_ = type_26(_e814[3], 3u);
                        } else {
                            phi_1357_ = _e890;
                        }
                        let _e896 = phi_1357_;
                        phi_1358_ = _e896;
                    } else {
                        phi_1358_ = _e890;
                    }
                    let _e898 = phi_1358_;
                    if (select(select(2u, 1u, select(true, select(true, false, (_e281[1] >= _e301)), (_e281[0] >= _e296))), 0u, (_e281[0] == 4294967295u)) == 2u) {
                        phi_1386_ = type_26(_e281, 2u);
                    } else {
                        phi_1386_ = _e835;
                    }
                    let _e912 = phi_1386_;
                    phi_1387_ = _e912;
                    phi_1388_ = _e898;
                    phi_1389_ = _e877;
                    phi_1390_ = _e856;
                } else {
                    phi_1387_ = type_26(array<u32, 2>(4294967295u, 4294967295u), 0u);
                    phi_1388_ = type_26(array<u32, 2>(4294967295u, 4294967295u), 0u);
                    phi_1389_ = type_26(array<u32, 2>(4294967295u, 4294967295u), 0u);
                    phi_1390_ = type_26(array<u32, 2>(4294967295u, 4294967295u), 0u);
                }
                let _e914 = phi_1387_;
                let _e916 = phi_1388_;
                let _e918 = phi_1389_;
                let _e920 = phi_1390_;
                if (_e75.member_11 == 1u) {
                    let _e1099 = select(0u, (((select(0u, 1u, (_e914.member_1 >= 2u)) + select(0u, 1u, (_e920.member_1 >= 2u))) + select(0u, 1u, (_e918.member_1 >= 2u))) + select(0u, 1u, (_e916.member_1 >= 2u))), (_e75.member_4 > 0u));
                    let _e1102 = ((((select(0u, 1u, (_e914.member_1 == 1u)) + select(0u, 1u, (_e920.member_1 == 1u))) + select(0u, 1u, (_e918.member_1 == 1u))) + select(0u, 1u, (_e916.member_1 == 1u))) | ((((select(0u, 1u, (_e914.member_1 == 2u)) + select(0u, 1u, (_e920.member_1 == 2u))) + select(0u, 1u, (_e918.member_1 == 2u))) + select(0u, 1u, (_e916.member_1 == 2u))) << bitcast<u32>(16i)));
                    sums[_e61] = _e1102;
                    phi_1456_ = type_9(0u, 7u);
                    phi_1459_ = 0u;
                    phi_1461_ = 1u;
                    phi_1463_ = _e1102;
                    phi_1460_ = 128u;
                    loop {
                        let _e1105 = phi_1456_;
                        let _e1107 = phi_1459_;
                        let _e1109 = phi_1461_;
                        let _e1111 = phi_1463_;
                        let _e1113 = phi_1460_;
                        local = _e1111;
                        let _e1116 = (_e1105.member < _e1105.member_1);
                        let _e1127 = (bitcast<i32>(select(0u, 1u, _e1116)) != 0i);
                        if _e1127 {
                            workgroupBarrier();
                            if (_e61 >= _e1109) {
                                let _e1132 = sums[((_e1107 + _e61) - _e1109)];
                                phi_1502_ = (_e1111 + _e1132);
                            } else {
                                phi_1502_ = _e1111;
                            }
                            let _e1135 = phi_1502_;
                            sums[(_e1113 + _e61)] = _e1135;
                            phi_1462_ = (_e1109 * 2u);
                            phi_1464_ = _e1135;
                        } else {
                            phi_1462_ = u32();
                            phi_1464_ = u32();
                        }
                        let _e1140 = phi_1462_;
                        let _e1142 = phi_1464_;
                        continue;
                        continuing {
                            phi_1456_ = type_9(select(_e1105.member, (_e1105.member + 1u), _e1116), select(_e1105.member_1, _e1105.member_1, _e1116));
                            phi_1459_ = _e1113;
                            phi_1461_ = _e1140;
                            phi_1463_ = _e1142;
                            phi_1460_ = _e1107;
                            break if !(_e1127);
                        }
                    }
                    workgroupBarrier();
                    let _e1145 = local;
                    let _e1146 = (_e1145 - _e1102);
                    if (_e61 == 0u) {
                        let _e1149 = sums[255u];
                        atomicStore((&shared_[6u]), (_e1149 & 65535u));
                        atomicStore((&shared_[7u]), (_e1149 >> bitcast<u32>(16i)));
                    }
                    if (_e75.member_4 > 0u) {
                        sums[_e61] = _e1099;
                        phi_1529_ = type_9(0u, 7u);
                        phi_1532_ = 0u;
                        phi_1534_ = 1u;
                        phi_1536_ = _e1099;
                        phi_1533_ = 128u;
                        loop {
                            let _e1159 = phi_1529_;
                            let _e1161 = phi_1532_;
                            let _e1163 = phi_1534_;
                            let _e1165 = phi_1536_;
                            let _e1167 = phi_1533_;
                            local_1 = _e1165;
                            let _e1170 = (_e1159.member < _e1159.member_1);
                            let _e1181 = (bitcast<i32>(select(0u, 1u, _e1170)) != 0i);
                            if _e1181 {
                                workgroupBarrier();
                                if (_e61 >= _e1163) {
                                    let _e1186 = sums[((_e1161 + _e61) - _e1163)];
                                    phi_1575_ = (_e1165 + _e1186);
                                } else {
                                    phi_1575_ = _e1165;
                                }
                                let _e1189 = phi_1575_;
                                sums[(_e1167 + _e61)] = _e1189;
                                phi_1535_ = (_e1163 * 2u);
                                phi_1537_ = _e1189;
                            } else {
                                phi_1535_ = u32();
                                phi_1537_ = u32();
                            }
                            let _e1194 = phi_1535_;
                            let _e1196 = phi_1537_;
                            continue;
                            continuing {
                                phi_1529_ = type_9(select(_e1159.member, (_e1159.member + 1u), _e1170), select(_e1159.member_1, _e1159.member_1, _e1170));
                                phi_1532_ = _e1167;
                                phi_1534_ = _e1194;
                                phi_1536_ = _e1196;
                                phi_1533_ = _e1161;
                                break if !(_e1181);
                            }
                        }
                        workgroupBarrier();
                        let _e1199 = local_1;
                        if (_e61 == 0u) {
                            let _e1203 = sums[255u];
                            atomicStore((&shared_[8u]), _e1203);
                        }
                        phi_1589_ = (_e1199 - _e1099);
                    } else {
                        phi_1589_ = 0u;
                    }
                    let _e1206 = phi_1589_;
                    let _e1207 = (_e1146 & 65535u);
                    let _e1209 = (_e1146 >> bitcast<u32>(16i));
                    let _e1217 = (_e1207 + select(0u, 1u, (_e914.member_1 == 1u)));
                    let _e1221 = (_e1209 + select(0u, 1u, (_e914.member_1 == 2u)));
                    let _e1225 = (_e1206 + select(0u, 1u, (_e914.member_1 >= 2u)));
                    let _e1233 = (_e1217 + select(0u, 1u, (_e920.member_1 == 1u)));
                    let _e1237 = (_e1221 + select(0u, 1u, (_e920.member_1 == 2u)));
                    let _e1241 = (_e1225 + select(0u, 1u, (_e920.member_1 >= 2u)));
                    phi_1812_ = type_27(array<u32, 2>(select(_e1209, _e1207, (_e914.member_1 == 1u)), _e1206), array<u32, 2>(select(_e1221, _e1217, (_e920.member_1 == 1u)), _e1225), array<u32, 2>(select(_e1237, _e1233, (_e918.member_1 == 1u)), _e1241), array<u32, 2>(select((_e1237 + select(0u, 1u, (_e918.member_1 == 2u))), (_e1233 + select(0u, 1u, (_e918.member_1 == 1u))), (_e916.member_1 == 1u)), (_e1241 + select(0u, 1u, (_e918.member_1 >= 2u)))));
                } else {
                    let _e960 = (((select(0u, 1u, (_e914.member_1 == 1u)) + select(0u, 1u, (_e920.member_1 == 1u))) + select(0u, 1u, (_e918.member_1 == 1u))) + select(0u, 1u, (_e916.member_1 == 1u)));
                    let _e964 = (((select(0u, 1u, (_e914.member_1 == 2u)) + select(0u, 1u, (_e920.member_1 == 2u))) + select(0u, 1u, (_e918.member_1 == 2u))) + select(0u, 1u, (_e916.member_1 == 2u)));
                    let _e970 = select(0u, (((select(0u, 1u, (_e914.member_1 >= 2u)) + select(0u, 1u, (_e920.member_1 >= 2u))) + select(0u, 1u, (_e918.member_1 >= 2u))) + select(0u, 1u, (_e916.member_1 >= 2u))), (_e75.member_4 > 0u));
                    if (_e960 > 0u) {
                        let _e973 = atomicAdd((&shared_[6u]), _e960);
                        phi_1720_ = array<u32, 3>(_e973, 0u, 0u);
                    } else {
                        phi_1720_ = array<u32, 3>(0u, 0u, 0u);
                    }
                    let _e976 = phi_1720_;
                    if (_e964 > 0u) {
                        let _e979 = atomicAdd((&shared_[7u]), _e964);
                        phi_1729_ = array<u32, 3>(_e976[0], _e979, _e976[2]);
                    } else {
                        phi_1729_ = _e976;
                    }
                    let _e984 = phi_1729_;
                    if (_e970 > 0u) {
                        let _e987 = atomicAdd((&shared_[8u]), _e970);
                        phi_1738_ = array<u32, 3>(_e984[0], _e984[1], _e987);
                    } else {
                        phi_1738_ = _e984;
                    }
                    let _e992 = phi_1738_;
                    let _e1004 = (_e992[0] + select(0u, 1u, (_e914.member_1 == 1u)));
                    let _e1009 = (_e992[1] + select(0u, 1u, (_e914.member_1 == 2u)));
                    let _e1014 = (_e992[2] + select(0u, 1u, (_e914.member_1 >= 2u)));
                    let _e1022 = (_e1004 + select(0u, 1u, (_e920.member_1 == 1u)));
                    let _e1026 = (_e1009 + select(0u, 1u, (_e920.member_1 == 2u)));
                    let _e1030 = (_e1014 + select(0u, 1u, (_e920.member_1 >= 2u)));
                    phi_1812_ = type_27(array<u32, 2>(select(_e992[1], _e992[0], (_e914.member_1 == 1u)), _e992[2]), array<u32, 2>(select(_e1009, _e1004, (_e920.member_1 == 1u)), _e1014), array<u32, 2>(select(_e1026, _e1022, (_e918.member_1 == 1u)), _e1030), array<u32, 2>(select((_e1026 + select(0u, 1u, (_e918.member_1 == 2u))), (_e1022 + select(0u, 1u, (_e918.member_1 == 1u))), (_e916.member_1 == 1u)), (_e1030 + select(0u, 1u, (_e918.member_1 >= 2u)))));
                }
                let _e1264 = phi_1812_;
                workgroupBarrier();
                if (_e61 == 0u) {
                    let _e1267 = atomicLoad((&shared_[6u]));
                    let _e1269 = atomicLoad((&shared_[7u]));
                    let _e1271 = atomicLoad((&shared_[8u]));
                    let _e1273 = atomicLoad((&shared_[1u]));
                    let _e1275 = atomicLoad((&shared_[2u]));
                    let _e1277 = atomicLoad((&shared_[15u]));
                    atomicStore((&shared_[15u]), (_e1277 + 1u));
                    let _e1281 = atomicLoad((&shared_[16u]));
                    atomicStore((&shared_[16u]), ((_e1281 + _e1273) + _e1275));
                    let _e1286 = atomicLoad((&shared_[0u]));
                    let _e1287 = (_e1286 - _e1273);
                    let _e1289 = (_e75.member_10 - _e1287);
                    let _e1291 = select(_e1267, _e1289, (_e1289 < _e1267));
                    atomicStore((&shared_[9u]), _e1287);
                    atomicStore((&shared_[10u]), _e1291);
                    atomicStore((&shared_[0u]), (_e1287 + _e1291));
                    if (_e1267 > _e1291) {
                        let _e1297 = (_e1267 - _e1291);
                        if (_e75.member_13 == 0u) {
                        } else {
                            let _e1301 = atomicMax((&control.member[1536u]), 4294967295u);
                        }
                        let _e1304 = atomicAdd((&control.member[(_e77.member_1 + 1u)]), _e1297);
                        let _e1307 = atomicMax((&nodes.member[0u]), (_e1304 + _e1297));
                        if ((_e1304 + _e1297) < _e1304) {
                            let _e1311 = atomicAdd((&nodes.member[2u]), 1u);
                        }
                        atomicStore((&shared_[11u]), _e1304);
                    }
                    if (_e1269 > 0u) {
                        let _e1315 = atomicAdd((&pairs.member[0u]), _e1269);
                        if ((_e1315 + _e1269) < _e1315) {
                            let _e1319 = atomicAdd((&pairs.member[2u]), 1u);
                        }
                        atomicStore((&shared_[12u]), _e1315);
                    }
                    if (_e1271 > 0u) {
                        let _e1323 = atomicAdd((&control.member[1537u]), _e1271);
                        if ((_e1323 + _e1271) < _e1323) {
                            let _e1327 = atomicAdd((&control.member[1538u]), 1u);
                        }
                        atomicStore((&shared_[13u]), _e1323);
                    }
                }
                workgroupBarrier();
                if (_e914.member_1 == 1u) {
                    let _e1390 = atomicLoad((&shared_[10u]));
                    if (_e1264.member[0] < _e1390) {
                        let _e1410 = atomicLoad((&shared_[9u]));
                        let _e1413 = (2u * (_e1410 + _e1264.member[0]));
                        stack[_e1413] = _e914.member[0];
                        stack[(_e1413 + 1u)] = _e914.member[1];
                    } else {
                        let _e1394 = atomicLoad((&shared_[11u]));
                        let _e1397 = ((_e1394 + _e1264.member[0]) - _e1390);
                        if (_e1397 < _e75.member_3) {
                            let _e1400 = (_e87 + _e1397);
                            if (_e1400 < 4294967295u) {
                                let _e1404 = (2u * _e1400);
                                atomicStore((&nodes.member[(4u + _e1404)]), _e914.member[0]);
                                atomicStore((&nodes.member[(_e1404 + 5u)]), _e914.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e914.member_1 == 0u) {
                    } else {
                        if (_e914.member_1 == 2u) {
                            let _e1339 = a.member[_e914.member[0]];
                            let _e1343 = b.member[_e914.member[1]];
                            let _e1347 = params.member.member_2.member;
                            if (_e1347 == 1u) {
                                let _e1350 = (_e1339.member_1 < _e1343.member_1);
                                phi_2047_ = type_9(select(_e1343.member_1, _e1339.member_1, _e1350), select(_e1339.member_1, _e1343.member_1, _e1350));
                            } else {
                                phi_2047_ = type_9(_e1339.member_1, _e1343.member_1);
                            }
                            let _e1355 = phi_2047_;
                            let _e1359 = params.member.member_1;
                            let _e1362 = atomicLoad((&shared_[12u]));
                            let _e1364 = (_e1362 + _e1264.member[0]);
                            if (_e1364 < _e1359.member_3) {
                                let _e1366 = (2u * _e1364);
                                atomicStore((&pairs.member[(4u + _e1366)]), _e1355.member);
                                atomicStore((&pairs.member[(_e1366 + 5u)]), _e1355.member_1);
                            }
                        }
                        if (_e75.member_4 > 0u) {
                            let _e1374 = atomicLoad((&shared_[13u]));
                            let _e1376 = (_e1374 + _e1264.member[1]);
                            if (_e1376 < _e75.member_4) {
                                let _e1383 = (2u * ((_e75.member_5 * _e75.member_4) + _e1376));
                                front.member[_e1383] = _e914.member[0];
                                front.member[(_e1383 + 1u)] = _e914.member[1];
                            }
                        }
                    }
                }
                if (_e920.member_1 == 1u) {
                    let _e1480 = atomicLoad((&shared_[10u]));
                    if (_e1264.member_1[0] < _e1480) {
                        let _e1500 = atomicLoad((&shared_[9u]));
                        let _e1503 = (2u * (_e1500 + _e1264.member_1[0]));
                        stack[_e1503] = _e920.member[0];
                        stack[(_e1503 + 1u)] = _e920.member[1];
                    } else {
                        let _e1484 = atomicLoad((&shared_[11u]));
                        let _e1487 = ((_e1484 + _e1264.member_1[0]) - _e1480);
                        if (_e1487 < _e75.member_3) {
                            let _e1490 = (_e87 + _e1487);
                            if (_e1490 < 4294967295u) {
                                let _e1494 = (2u * _e1490);
                                atomicStore((&nodes.member[(4u + _e1494)]), _e920.member[0]);
                                atomicStore((&nodes.member[(_e1494 + 5u)]), _e920.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e920.member_1 == 0u) {
                    } else {
                        if (_e920.member_1 == 2u) {
                            let _e1429 = a.member[_e920.member[0]];
                            let _e1433 = b.member[_e920.member[1]];
                            let _e1437 = params.member.member_2.member;
                            if (_e1437 == 1u) {
                                let _e1440 = (_e1429.member_1 < _e1433.member_1);
                                phi_2211_ = type_9(select(_e1433.member_1, _e1429.member_1, _e1440), select(_e1429.member_1, _e1433.member_1, _e1440));
                            } else {
                                phi_2211_ = type_9(_e1429.member_1, _e1433.member_1);
                            }
                            let _e1445 = phi_2211_;
                            let _e1449 = params.member.member_1;
                            let _e1452 = atomicLoad((&shared_[12u]));
                            let _e1454 = (_e1452 + _e1264.member_1[0]);
                            if (_e1454 < _e1449.member_3) {
                                let _e1456 = (2u * _e1454);
                                atomicStore((&pairs.member[(4u + _e1456)]), _e1445.member);
                                atomicStore((&pairs.member[(_e1456 + 5u)]), _e1445.member_1);
                            }
                        }
                        if (_e75.member_4 > 0u) {
                            let _e1464 = atomicLoad((&shared_[13u]));
                            let _e1466 = (_e1464 + _e1264.member_1[1]);
                            if (_e1466 < _e75.member_4) {
                                let _e1473 = (2u * ((_e75.member_5 * _e75.member_4) + _e1466));
                                front.member[_e1473] = _e920.member[0];
                                front.member[(_e1473 + 1u)] = _e920.member[1];
                            }
                        }
                    }
                }
                if (_e918.member_1 == 1u) {
                    let _e1570 = atomicLoad((&shared_[10u]));
                    if (_e1264.member_2[0] < _e1570) {
                        let _e1590 = atomicLoad((&shared_[9u]));
                        let _e1593 = (2u * (_e1590 + _e1264.member_2[0]));
                        stack[_e1593] = _e918.member[0];
                        stack[(_e1593 + 1u)] = _e918.member[1];
                    } else {
                        let _e1574 = atomicLoad((&shared_[11u]));
                        let _e1577 = ((_e1574 + _e1264.member_2[0]) - _e1570);
                        if (_e1577 < _e75.member_3) {
                            let _e1580 = (_e87 + _e1577);
                            if (_e1580 < 4294967295u) {
                                let _e1584 = (2u * _e1580);
                                atomicStore((&nodes.member[(4u + _e1584)]), _e918.member[0]);
                                atomicStore((&nodes.member[(_e1584 + 5u)]), _e918.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e918.member_1 == 0u) {
                    } else {
                        if (_e918.member_1 == 2u) {
                            let _e1519 = a.member[_e918.member[0]];
                            let _e1523 = b.member[_e918.member[1]];
                            let _e1527 = params.member.member_2.member;
                            if (_e1527 == 1u) {
                                let _e1530 = (_e1519.member_1 < _e1523.member_1);
                                phi_2375_ = type_9(select(_e1523.member_1, _e1519.member_1, _e1530), select(_e1519.member_1, _e1523.member_1, _e1530));
                            } else {
                                phi_2375_ = type_9(_e1519.member_1, _e1523.member_1);
                            }
                            let _e1535 = phi_2375_;
                            let _e1539 = params.member.member_1;
                            let _e1542 = atomicLoad((&shared_[12u]));
                            let _e1544 = (_e1542 + _e1264.member_2[0]);
                            if (_e1544 < _e1539.member_3) {
                                let _e1546 = (2u * _e1544);
                                atomicStore((&pairs.member[(4u + _e1546)]), _e1535.member);
                                atomicStore((&pairs.member[(_e1546 + 5u)]), _e1535.member_1);
                            }
                        }
                        if (_e75.member_4 > 0u) {
                            let _e1554 = atomicLoad((&shared_[13u]));
                            let _e1556 = (_e1554 + _e1264.member_2[1]);
                            if (_e1556 < _e75.member_4) {
                                let _e1563 = (2u * ((_e75.member_5 * _e75.member_4) + _e1556));
                                front.member[_e1563] = _e918.member[0];
                                front.member[(_e1563 + 1u)] = _e918.member[1];
                            }
                        }
                    }
                }
                if (_e916.member_1 == 1u) {
                    let _e1660 = atomicLoad((&shared_[10u]));
                    if (_e1264.member_3[0] < _e1660) {
                        let _e1680 = atomicLoad((&shared_[9u]));
                        let _e1683 = (2u * (_e1680 + _e1264.member_3[0]));
                        stack[_e1683] = _e916.member[0];
                        stack[(_e1683 + 1u)] = _e916.member[1];
                    } else {
                        let _e1664 = atomicLoad((&shared_[11u]));
                        let _e1667 = ((_e1664 + _e1264.member_3[0]) - _e1660);
                        if (_e1667 < _e75.member_3) {
                            let _e1670 = (_e87 + _e1667);
                            if (_e1670 < 4294967295u) {
                                let _e1674 = (2u * _e1670);
                                atomicStore((&nodes.member[(4u + _e1674)]), _e916.member[0]);
                                atomicStore((&nodes.member[(_e1674 + 5u)]), _e916.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e916.member_1 == 0u) {
                    } else {
                        if (_e916.member_1 == 2u) {
                            let _e1609 = a.member[_e916.member[0]];
                            let _e1613 = b.member[_e916.member[1]];
                            let _e1617 = params.member.member_2.member;
                            if (_e1617 == 1u) {
                                let _e1620 = (_e1609.member_1 < _e1613.member_1);
                                phi_2539_ = type_9(select(_e1613.member_1, _e1609.member_1, _e1620), select(_e1609.member_1, _e1613.member_1, _e1620));
                            } else {
                                phi_2539_ = type_9(_e1609.member_1, _e1613.member_1);
                            }
                            let _e1625 = phi_2539_;
                            let _e1629 = params.member.member_1;
                            let _e1632 = atomicLoad((&shared_[12u]));
                            let _e1634 = (_e1632 + _e1264.member_3[0]);
                            if (_e1634 < _e1629.member_3) {
                                let _e1636 = (2u * _e1634);
                                atomicStore((&pairs.member[(4u + _e1636)]), _e1625.member);
                                atomicStore((&pairs.member[(_e1636 + 5u)]), _e1625.member_1);
                            }
                        }
                        if (_e75.member_4 > 0u) {
                            let _e1644 = atomicLoad((&shared_[13u]));
                            let _e1646 = (_e1644 + _e1264.member_3[1]);
                            if (_e1646 < _e75.member_4) {
                                let _e1653 = (2u * ((_e75.member_5 * _e75.member_4) + _e1646));
                                front.member[_e1653] = _e916.member[0];
                                front.member[(_e1653 + 1u)] = _e916.member[1];
                            }
                        }
                    }
                }
                phi_2592_ = true;
            }
            let _e1690 = phi_2592_;
            phi_2593_ = _e1690;
        } else {
            phi_2593_ = false;
        }
        let _e1692 = phi_2593_;
        continue;
        continuing {
            phi_212_ = type_9(select(_e96.member, (_e96.member + 1u), _e99), select(_e96.member_1, _e96.member_1, _e99));
            break if !(_e1692);
        }
    }
    if (_e61 == 0u) {
        if (_e75.member_6 == 0u) {
            let _e1707 = atomicLoad((&shared_[5u]));
            phi_2621_ = (select(0u, ((((_e84 - 1u) - _e73) >> bitcast<u32>((_e75.member_7 & 31u))) + 1u), (_e73 < _e84)) - _e1707);
        } else {
            phi_2621_ = 0u;
        }
        let _e1710 = phi_2621_;
        atomicStore((&shared_[14u]), _e1710);
        let _e1713 = atomicLoad((&shared_[0u]));
        let _e1714 = (_e1713 + _e1710);
        if (_e75.member_6 == 2u) {
            let _e1741 = (((_e84 + (1u << bitcast<u32>((_e75.member_7 & 31u)))) - 1u) >> bitcast<u32>((_e75.member_7 & 31u)));
            let _e1742 = (_e73 * _e1741);
            let _e1745 = (_e84 - select(_e1742, _e84, (_e84 < _e1742)));
            let _e1754 = ((1540u + (2u * (1u << bitcast<u32>((_e75.member_7 & 31u))))) + (2u * _e73));
            let _e1756 = atomicLoad((&shared_[0u]));
            atomicStore((&control.member[_e1754]), _e1756);
            let _e1760 = atomicLoad((&shared_[5u]));
            atomicStore((&control.member[(_e1754 + 1u)]), (select(_e1741, _e1745, (_e1745 < _e1741)) - _e1760));
        } else {
            if (_e1714 > 0u) {
                if (_e75.member_13 == 0u) {
                } else {
                    let _e1721 = atomicMax((&control.member[1536u]), 4294967295u);
                }
                let _e1724 = atomicAdd((&control.member[(_e77.member_1 + 1u)]), _e1714);
                let _e1727 = atomicMax((&nodes.member[0u]), (_e1724 + _e1714));
                if ((_e1724 + _e1714) < _e1724) {
                    let _e1731 = atomicAdd((&nodes.member[2u]), 1u);
                }
                atomicStore((&shared_[17u]), _e1724);
            }
        }
        let _e1766 = atomicLoad((&shared_[15u]));
        let _e1768 = atomicAdd((&control.member[(1540u + (2u * _e73))]), _e1766);
        let _e1772 = atomicLoad((&shared_[16u]));
        let _e1774 = atomicAdd((&control.member[((2u * _e73) + 1541u)]), _e1772);
    }
    workgroupBarrier();
    let _e1776 = atomicLoad((&shared_[0u]));
    let _e1778 = atomicLoad((&shared_[17u]));
    let _e1780 = atomicLoad((&shared_[14u]));
    phi_2741_ = type_9(0u, 8u);
    loop {
        let _e1782 = phi_2741_;
        let _e1785 = (_e1782.member < _e1782.member_1);
        let _e1798 = (bitcast<i32>(select(0u, 1u, _e1785)) != 0i);
        if _e1798 {
            let _e1800 = ((select(type_9().member_1, _e1782.member, _e1785) * 128u) + _e61);
            if (_e1800 < _e1776) {
                let _e1804 = stack[(2u * _e1800)];
                let _e1808 = stack[((2u * _e1800) + 1u)];
                if (_e75.member_6 == 2u) {
                    let _e1840 = ((((((1540u + (2u * (1u << bitcast<u32>((_e75.member_7 & 31u))))) + (2u * (1u << bitcast<u32>((_e75.member_7 & 31u))))) + (1u << bitcast<u32>((_e75.member_7 & 31u)))) + 1u) + (_e73 * 2048u)) + (2u * _e1800));
                    atomicStore((&control.member[_e1840]), _e1804);
                    atomicStore((&control.member[(_e1840 + 1u)]), _e1808);
                } else {
                    let _e1811 = (_e1778 + _e1800);
                    if (_e1811 < _e75.member_3) {
                        let _e1814 = (_e87 + _e1811);
                        if (_e1814 < 4294967295u) {
                            let _e1816 = (2u * _e1814);
                            atomicStore((&nodes.member[(4u + _e1816)]), _e1804);
                            atomicStore((&nodes.member[(_e1816 + 5u)]), _e1808);
                        }
                    }
                }
            }
        }
        continue;
        continuing {
            phi_2741_ = type_9(select(_e1782.member, (_e1782.member + 1u), _e1785), select(_e1782.member_1, _e1782.member_1, _e1785));
            break if !(_e1798);
        }
    }
    let _e1846 = atomicLoad((&shared_[5u]));
    let _e1847 = (_e1780 / 128u);
    phi_2859_ = type_9(0u, select(_e1847, (_e1847 + 1u), ((_e1780 % 128u) > 0u)));
    loop {
        let _e1854 = phi_2859_;
        let _e1857 = (_e1854.member < _e1854.member_1);
        let _e1870 = (bitcast<i32>(select(0u, 1u, _e1857)) != 0i);
        if _e1870 {
            let _e1872 = ((select(type_9().member_1, _e1854.member, _e1857) * 128u) + _e61);
            if (_e1872 < _e1780) {
                let _e1881 = (2u * ((_e85 + _e73) + ((_e1846 + _e1872) << bitcast<u32>((_e75.member_7 & 31u)))));
                let _e1884 = atomicLoad((&nodes.member[(4u + _e1881)]));
                let _e1887 = atomicLoad((&nodes.member[(_e1881 + 5u)]));
                let _e1889 = ((_e1778 + _e1776) + _e1872);
                if (_e1889 < _e75.member_3) {
                    let _e1892 = (_e87 + _e1889);
                    if (_e1892 < 4294967295u) {
                        let _e1894 = (2u * _e1892);
                        atomicStore((&nodes.member[(4u + _e1894)]), _e1884);
                        atomicStore((&nodes.member[(_e1894 + 5u)]), _e1887);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_2859_ = type_9(select(_e1854.member, (_e1854.member + 1u), _e1857), select(_e1854.member_1, _e1854.member_1, _e1857));
            break if !(_e1870);
        }
    }
    if (_e75.member_6 == 1u) {
        if (_e1846 == 0u) {
            phi_2964_ = type_9(0u, _e84);
            loop {
                let _e1905 = phi_2964_;
                let _e1908 = (_e1905.member < _e1905.member_1);
                if (bitcast<i32>(select(0u, 1u, _e1908)) != 0i) {
                    let _e1922 = atomicAdd((&control.member[(512u + _e77.member_1)]), 1u);
                    if (_e1922 >= _e84) {
                        phi_3080_ = false;
                    } else {
                        let _e1925 = (2u * (_e85 + _e1922));
                        let _e1928 = atomicLoad((&nodes.member[(4u + _e1925)]));
                        let _e1931 = atomicLoad((&nodes.member[(_e1925 + 5u)]));
                        if (_e75.member_13 == 0u) {
                        } else {
                            let _e1935 = atomicMax((&control.member[1536u]), 4294967295u);
                        }
                        let _e1938 = atomicAdd((&control.member[(_e77.member_1 + 1u)]), 1u);
                        let _e1941 = atomicMax((&nodes.member[0u]), (_e1938 + 1u));
                        if ((_e1938 + 1u) < _e1938) {
                            let _e1945 = atomicAdd((&nodes.member[2u]), 1u);
                        }
                        if (_e1938 < _e75.member_3) {
                            let _e1948 = (_e87 + _e1938);
                            if (_e1948 < 4294967295u) {
                                let _e1950 = (2u * _e1948);
                                atomicStore((&nodes.member[(4u + _e1950)]), _e1928);
                                atomicStore((&nodes.member[(_e1950 + 5u)]), _e1931);
                            }
                        }
                        phi_3080_ = true;
                    }
                    let _e1956 = phi_3080_;
                    phi_3081_ = _e1956;
                } else {
                    phi_3081_ = false;
                }
                let _e1958 = phi_3081_;
                continue;
                continuing {
                    phi_2964_ = type_9(select(_e1905.member, (_e1905.member + 1u), _e1908), select(_e1905.member_1, _e1905.member_1, _e1908));
                    break if !(_e1958);
                }
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn pair_workers(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}

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
    member: array<array<f32, 3>, 3>,
    member_1: array<f32, 3>,
    member_2: array<f32, 3>,
    member_3: array<f32, 3>,
    member_4: array<f32, 3>,
    member_5: f32,
}

struct type_28 {
    member: vec4<f32>,
    member_1: vec4<f32>,
    member_2: vec4<f32>,
    member_3: vec4<f32>,
}

struct type_30 {
    member: array<type_28>,
}

struct type_31 {
    member: array<f32, 3>,
    member_1: array<array<f32, 3>, 3>,
    member_2: array<f32, 3>,
}

struct type_33 {
    member: array<u32, 2>,
    member_1: u32,
}

struct type_34 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: array<u32, 2>,
    member_3: array<u32, 2>,
}

struct type_37 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_22;
@group(0) @binding(6) 
var<storage, read_write> pairs: type_37;
@group(0) @binding(3) 
var<storage> oriented: type_30;
@group(0) @binding(7) 
var<storage, read_write> front: type_11;
@group(0) @binding(4) 
var<storage, read_write> control: type_37;
@group(0) @binding(1) 
var<storage> a: type_19;
@group(0) @binding(2) 
var<storage> b: type_19;
var<workgroup> shared_: array<atomic<u32>, 22>;
var<workgroup> state: array<u32, 1>;
var<workgroup> stack: array<u32, 2048>;
var<workgroup> sums: array<u32, 256>;
@group(0) @binding(5) 
var<storage, read_write> nodes: type_37;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_26;
    var local_1: array<array<u32, 2>, 4>;
    var phi_254_: type_9;
    var phi_338_: u32;
    var phi_339_: u32;
    var phi_475_: u32;
    var phi_476_: u32;
    var phi_477_: u32;
    var phi_478_: u32;
    var phi_479_: u32;
    var phi_499_: u32;
    var phi_500_: u32;
    var phi_583_: array<u32, 2>;
    var phi_584_: array<u32, 2>;
    var phi_757_: type_24;
    var phi_758_: type_24;
    var phi_759_: bool;
    var phi_760_: type_24;
    var phi_761_: bool;
    var phi_821_: bool;
    var phi_822_: bool;
    var phi_823_: bool;
    var phi_824_: bool;
    var phi_825_: bool;
    var phi_826_: bool;
    var phi_1021_: type_24;
    var phi_1022_: bool;
    var phi_1023_: type_24;
    var phi_1024_: bool;
    var phi_1231_: type_24;
    var phi_1232_: type_24;
    var phi_1233_: type_24;
    var phi_1234_: bool;
    var phi_1235_: type_24;
    var phi_1236_: type_24;
    var phi_1237_: bool;
    var phi_1241_: type_24;
    var phi_1335_: type_9;
    var phi_1548_: type_31;
    var phi_1692_: type_31;
    var phi_3593_: bool;
    var phi_3595_: bool;
    var phi_3596_: bool;
    var phi_3597_: bool;
    var phi_3598_: bool;
    var phi_3639_: array<array<u32, 2>, 4>;
    var phi_3675_: type_33;
    var phi_3676_: type_33;
    var phi_3712_: type_33;
    var phi_3713_: type_33;
    var phi_3749_: type_33;
    var phi_3750_: type_33;
    var phi_3786_: type_33;
    var phi_3787_: type_33;
    var phi_3815_: type_33;
    var phi_3816_: type_33;
    var phi_3817_: type_33;
    var phi_3818_: type_33;
    var phi_3819_: type_33;
    var phi_4149_: array<u32, 3>;
    var phi_4158_: array<u32, 3>;
    var phi_4167_: array<u32, 3>;
    var phi_3885_: type_9;
    var phi_3888_: u32;
    var phi_3890_: u32;
    var phi_3892_: u32;
    var phi_3889_: u32;
    var phi_3931_: u32;
    var phi_3891_: u32;
    var phi_3893_: u32;
    var local_2: u32;
    var phi_3958_: type_9;
    var phi_3961_: u32;
    var phi_3963_: u32;
    var phi_3965_: u32;
    var phi_3962_: u32;
    var phi_4004_: u32;
    var phi_3964_: u32;
    var phi_3966_: u32;
    var local_3: u32;
    var phi_4018_: u32;
    var phi_4241_: type_34;
    var phi_4476_: type_9;
    var phi_4640_: type_9;
    var phi_4804_: type_9;
    var phi_4968_: type_9;
    var phi_5021_: bool;
    var phi_5022_: bool;
    var phi_5050_: u32;
    var phi_5170_: type_9;
    var phi_5288_: type_9;
    var phi_5393_: type_9;
    var phi_5509_: bool;
    var phi_5510_: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e75 = id_2;
    let _e76 = n_2;
    let _e77 = lane_2;
    let _e90 = ((_e75.y * _e76.x) + _e75.x);
    let _e92 = params.member.member_2;
    let _e94 = params.member.member_1;
    let _e97 = (_e94.member_1 % 2u);
    let _e99 = atomicLoad((&control.member[_e94.member_1]));
    let _e101 = select(_e99, _e92.member_3, (_e92.member_3 < _e99));
    let _e102 = (_e97 * _e92.member_3);
    let _e104 = ((1u - _e97) * _e92.member_3);
    if (_e77 == 0u) {
        atomicStore((&shared_[0u]), 0u);
        atomicStore((&shared_[5u]), 0u);
        atomicStore((&shared_[15u]), 0u);
        atomicStore((&shared_[16u]), 0u);
    }
    phi_254_ = type_9(0u, _e92.member_12);
    loop {
        let _e113 = phi_254_;
        let _e116 = (_e113.member < _e113.member_1);
        if (bitcast<i32>(select(0u, 1u, _e116)) != 0i) {
            if (_e77 == 0u) {
                let _e136 = atomicLoad((&shared_[0u]));
                let _e138 = select(_e136, 128u, (128u < _e136));
                if (_e92.member_9 > 0u) {
                    if (select(type_9().member_1, _e113.member, _e116) >= 16u) {
                        let _e143 = atomicLoad((&control.member[(1024u + _e94.member_1)]));
                        phi_338_ = select(0u, 2u, select(false, ((_e143 * 100u) >= (_e92.member_9 << bitcast<u32>((_e92.member_7 & 31u)))), (_e92.member_9 > 0u)));
                    } else {
                        phi_338_ = 0u;
                    }
                    let _e153 = phi_338_;
                    phi_339_ = _e153;
                } else {
                    phi_339_ = 0u;
                }
                let _e155 = phi_339_;
                let _e156 = (128u - _e138);
                if (_e155 == 0u) {
                    if (_e156 > 0u) {
                        let _e160 = atomicLoad((&shared_[5u]));
                        if (_e92.member_6 == 0u) {
                            let _e221 = (select(0u, ((((_e101 - 1u) - _e90) >> bitcast<u32>((_e92.member_7 & 31u))) + 1u), (_e90 < _e101)) - _e160);
                            let _e223 = select(_e221, _e156, (_e156 < _e221));
                            atomicStore((&shared_[3u]), (_e90 + (_e160 << bitcast<u32>((_e92.member_7 & 31u)))));
                            atomicStore((&shared_[4u]), (1u << bitcast<u32>((_e92.member_7 & 31u))));
                            atomicStore((&shared_[5u]), (_e160 + _e223));
                            phi_477_ = _e223;
                        } else {
                            if (_e92.member_6 == 2u) {
                                let _e196 = (((_e101 + (1u << bitcast<u32>((_e92.member_7 & 31u)))) - 1u) >> bitcast<u32>((_e92.member_7 & 31u)));
                                let _e197 = (_e90 * _e196);
                                let _e199 = select(_e197, _e101, (_e101 < _e197));
                                let _e200 = (_e101 - _e199);
                                let _e203 = (select(_e196, _e200, (_e200 < _e196)) - _e160);
                                let _e205 = select(_e203, _e156, (_e156 < _e203));
                                atomicStore((&shared_[3u]), (_e199 + _e160));
                                atomicStore((&shared_[4u]), 1u);
                                atomicStore((&shared_[5u]), (_e160 + _e205));
                                phi_476_ = _e205;
                            } else {
                                if (_e160 == 0u) {
                                    let _e167 = (_e101 >> bitcast<u32>(((_e92.member_7 + 2u) & 31u)));
                                    let _e169 = select(_e92.member_8, _e167, (_e92.member_8 < _e167));
                                    let _e171 = select(_e169, 128u, (128u < _e169));
                                    let _e173 = select(_e171, _e156, (_e156 < _e171));
                                    let _e176 = atomicAdd((&control.member[(512u + _e94.member_1)]), _e173);
                                    let _e179 = (_e101 - select(_e176, _e101, (_e101 < _e176)));
                                    let _e181 = select(_e179, _e173, (_e173 < _e179));
                                    atomicStore((&shared_[3u]), _e176);
                                    atomicStore((&shared_[4u]), 1u);
                                    atomicStore((&shared_[5u]), select(0u, 1u, (_e181 < _e173)));
                                    phi_475_ = _e181;
                                } else {
                                    phi_475_ = 0u;
                                }
                                let _e188 = phi_475_;
                                phi_476_ = _e188;
                            }
                            let _e212 = phi_476_;
                            phi_477_ = _e212;
                        }
                        let _e236 = phi_477_;
                        phi_478_ = _e236;
                    } else {
                        phi_478_ = 0u;
                    }
                    let _e238 = phi_478_;
                    phi_479_ = _e238;
                } else {
                    phi_479_ = 0u;
                }
                let _e240 = phi_479_;
                if (_e155 == 0u) {
                    if ((_e138 + _e240) == 0u) {
                        if (_e92.member_9 > 0u) {
                            let _e247 = atomicAdd((&control.member[(1024u + _e94.member_1)]), 1u);
                        }
                        phi_499_ = 1u;
                    } else {
                        phi_499_ = _e155;
                    }
                    let _e249 = phi_499_;
                    phi_500_ = _e249;
                } else {
                    phi_500_ = _e155;
                }
                let _e251 = phi_500_;
                atomicStore((&shared_[1u]), _e138);
                atomicStore((&shared_[2u]), _e240);
                atomicStore((&shared_[6u]), 0u);
                atomicStore((&shared_[7u]), 0u);
                atomicStore((&shared_[8u]), 0u);
                state[0u] = _e251;
            }
            let _e259 = workgroupUniformLoad((&state[0u]));
            if (_e259 != 0u) {
                phi_5021_ = false;
            } else {
                let _e262 = atomicLoad((&shared_[1u]));
                let _e264 = atomicLoad((&shared_[2u]));
                if (_e77 < _e262) {
                    let _e287 = atomicLoad((&shared_[0u]));
                    let _e290 = (2u * ((_e287 - 1u) - _e77));
                    let _e292 = stack[_e290];
                    let _e295 = stack[(_e290 + 1u)];
                    phi_584_ = array<u32, 2>(_e292, _e295);
                } else {
                    if (_e77 < (_e262 + _e264)) {
                        let _e269 = atomicLoad((&shared_[3u]));
                        let _e272 = atomicLoad((&shared_[4u]));
                        let _e276 = (2u * (_e102 + (_e269 + ((_e77 - _e262) * _e272))));
                        let _e279 = atomicLoad((&nodes.member[(4u + _e276)]));
                        let _e282 = atomicLoad((&nodes.member[(_e276 + 5u)]));
                        phi_583_ = array<u32, 2>(_e279, _e282);
                    } else {
                        phi_583_ = array<u32, 2>(4294967295u, 4294967295u);
                    }
                    let _e285 = phi_583_;
                    phi_584_ = _e285;
                }
                let _e298 = phi_584_;
                let _e301 = params.member.member_2.member;
                let _e305 = params.member.member_2.member;
                let _e306 = (_e305 == 0u);
                let _e312 = params.member.member.member[select(1u, 0u, _e306)];
                let _e313 = (_e312 - 1u);
                let _e317 = params.member.member.member[select(1u, 2u, _e306)];
                let _e318 = (_e317 - 1u);
                let _e321 = params.member.member_2.member_1;
                if (_e298[0] != 4294967295u) {
                    let _e329 = a.member[_e298[0]];
                    let _e331 = b.member[_e298[1]];
                    if (_e301 == 1u) {
                        if (_e298[0] == _e298[1]) {
                            if (_e329.member_3 == 4294967295u) {
                                phi_757_ = type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)));
                            } else {
                                let _e337 = a.member[_e329.member_1];
                                let _e340 = a.member[_e329.member_3];
                                let _e343 = !((_e337.member_3 == 4294967295u));
                                let _e354 = type_24(array<array<u32, 2>, 4>(array<u32, 2>(select(4294967295u, _e329.member_1, _e343), select(4294967295u, _e329.member_1, _e343)), type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[1], type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[2], type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[3]), type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1);
                                let _e366 = type_24(array<array<u32, 2>, 4>(_e354.member[0], array<u32, 2>(_e329.member_1, _e354.member[1][1]), _e354.member[2], _e354.member[3]), _e354.member_1);
                                let _e374 = type_24(array<array<u32, 2>, 4>(_e366.member[0], array<u32, 2>(_e329.member_1, _e329.member_3), _e366.member[2], _e366.member[3]), _e366.member_1);
                                let _e377 = !((_e340.member_3 == 4294967295u));
                                let _e388 = type_24(array<array<u32, 2>, 4>(_e374.member[0], _e374.member[1], array<u32, 2>(select(4294967295u, _e329.member_3, _e377), select(4294967295u, _e329.member_3, _e377)), _e374.member[3]), _e374.member_1);
                                let _e391 = type_24(_e388.member, _e388.member);
                                let _e418 = ((((((_e337.member[0] <= _e340.member_2[0]) && (_e340.member[0] <= _e337.member_2[0])) && (_e337.member[1] <= _e340.member_2[1])) && (_e340.member[1] <= _e337.member_2[1])) && (_e337.member[2] <= _e340.member_2[2])) && (_e340.member[2] <= _e337.member_2[2]));
                                phi_757_ = type_24(_e391.member, array<array<u32, 2>, 4>(_e391.member_1[0], array<u32, 2>(select(4294967295u, _e329.member_1, _e418), select(4294967295u, _e329.member_3, _e418)), _e391.member_1[2], _e391.member_1[3]));
                            }
                            let _e430 = phi_757_;
                            phi_758_ = _e430;
                            phi_759_ = false;
                        } else {
                            phi_758_ = type_24();
                            phi_759_ = true;
                        }
                        let _e432 = phi_758_;
                        let _e434 = phi_759_;
                        phi_760_ = _e432;
                        phi_761_ = _e434;
                    } else {
                        phi_760_ = type_24();
                        phi_761_ = true;
                    }
                    let _e436 = phi_760_;
                    let _e438 = phi_761_;
                    if _e438 {
                        let _e441 = !((_e329.member_3 == 4294967295u));
                        let _e444 = !((_e331.member_3 == 4294967295u));
                        if select(_e444, true, _e441) {
                            if _e441 {
                                if _e444 {
                                    if (select(0u, 1u, (_e321 == 0u)) == 0u) {
                                        let _e473 = ((((_e331.member_2[0] - _e331.member[0]) * (_e331.member_2[1] - _e331.member[1])) * (_e331.member_2[2] - _e331.member[2])) > (((_e329.member_2[0] - _e329.member[0]) * (_e329.member_2[1] - _e329.member[1])) * (_e329.member_2[2] - _e329.member[2])));
                                        phi_821_ = _e473;
                                        phi_822_ = !(_e473);
                                    } else {
                                        phi_821_ = _e444;
                                        phi_822_ = _e441;
                                    }
                                    let _e476 = phi_821_;
                                    let _e478 = phi_822_;
                                    phi_823_ = _e476;
                                    phi_824_ = _e478;
                                } else {
                                    phi_823_ = _e444;
                                    phi_824_ = _e441;
                                }
                                let _e480 = phi_823_;
                                let _e482 = phi_824_;
                                phi_825_ = _e480;
                                phi_826_ = _e482;
                            } else {
                                phi_825_ = _e444;
                                phi_826_ = _e441;
                            }
                            let _e484 = phi_825_;
                            let _e486 = phi_826_;
                            if _e486 {
                                if _e484 {
                                    let _e489 = a.member[_e329.member_1];
                                    let _e494 = a.member[_e329.member_3];
                                    let _e499 = b.member[_e331.member_1];
                                    let _e504 = b.member[_e331.member_3];
                                    let _e542 = ((((((_e489.member[0] <= _e499.member_2[0]) && (_e499.member[0] <= _e489.member_2[0])) && (_e489.member[1] <= _e499.member_2[1])) && (_e499.member[1] <= _e489.member_2[1])) && (_e489.member[2] <= _e499.member_2[2])) && (_e499.member[2] <= _e489.member_2[2]));
                                    let _e568 = ((((((_e489.member[0] <= _e504.member_2[0]) && (_e504.member[0] <= _e489.member_2[0])) && (_e489.member[1] <= _e504.member_2[1])) && (_e504.member[1] <= _e489.member_2[1])) && (_e489.member[2] <= _e504.member_2[2])) && (_e504.member[2] <= _e489.member_2[2]));
                                    let _e594 = ((((((_e494.member[0] <= _e499.member_2[0]) && (_e499.member[0] <= _e494.member_2[0])) && (_e494.member[1] <= _e499.member_2[1])) && (_e499.member[1] <= _e494.member_2[1])) && (_e494.member[2] <= _e499.member_2[2])) && (_e499.member[2] <= _e494.member_2[2]));
                                    let _e620 = ((((((_e494.member[0] <= _e504.member_2[0]) && (_e504.member[0] <= _e494.member_2[0])) && (_e494.member[1] <= _e504.member_2[1])) && (_e504.member[1] <= _e494.member_2[1])) && (_e494.member[2] <= _e504.member_2[2])) && (_e504.member[2] <= _e494.member_2[2]));
                                    phi_1021_ = type_24(array<array<u32, 2>, 4>(array<u32, 2>(_e329.member_1, _e331.member_1), array<u32, 2>(_e329.member_1, _e331.member_3), array<u32, 2>(_e329.member_3, _e331.member_1), array<u32, 2>(_e329.member_3, _e331.member_3)), array<array<u32, 2>, 4>(array<u32, 2>(select(4294967295u, _e329.member_1, _e542), select(4294967295u, _e331.member_1, _e542)), array<u32, 2>(select(4294967295u, _e329.member_1, _e568), select(4294967295u, _e331.member_3, _e568)), array<u32, 2>(select(4294967295u, _e329.member_3, _e594), select(4294967295u, _e331.member_1, _e594)), array<u32, 2>(select(4294967295u, _e329.member_3, _e620), select(4294967295u, _e331.member_3, _e620))));
                                    phi_1022_ = false;
                                } else {
                                    phi_1021_ = type_24();
                                    phi_1022_ = true;
                                }
                                let _e627 = phi_1021_;
                                let _e629 = phi_1022_;
                                phi_1023_ = _e627;
                                phi_1024_ = _e629;
                            } else {
                                phi_1023_ = type_24();
                                phi_1024_ = true;
                            }
                            let _e631 = phi_1023_;
                            let _e633 = phi_1024_;
                            if _e633 {
                                if _e486 {
                                    let _e723 = a.member[_e329.member_1];
                                    let _e728 = a.member[_e329.member_3];
                                    let _e737 = type_24(array<array<u32, 2>, 4>(array<u32, 2>(_e329.member_1, _e298[1]), array<u32, 2>(_e329.member_3, _e298[1]), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1);
                                    let _e762 = ((((((_e723.member[0] <= _e331.member_2[0]) && (_e331.member[0] <= _e723.member_2[0])) && (_e723.member[1] <= _e331.member_2[1])) && (_e331.member[1] <= _e723.member_2[1])) && (_e723.member[2] <= _e331.member_2[2])) && (_e331.member[2] <= _e723.member_2[2]));
                                    let _e772 = type_24(_e737.member, array<array<u32, 2>, 4>(array<u32, 2>(select(4294967295u, _e329.member_1, _e762), select(4294967295u, _e298[1], _e762)), _e737.member_1[1], _e737.member_1[2], _e737.member_1[3]));
                                    let _e797 = ((((((_e728.member[0] <= _e331.member_2[0]) && (_e331.member[0] <= _e728.member_2[0])) && (_e728.member[1] <= _e331.member_2[1])) && (_e331.member[1] <= _e728.member_2[1])) && (_e728.member[2] <= _e331.member_2[2])) && (_e331.member[2] <= _e728.member_2[2]));
                                    phi_1231_ = type_24(_e772.member, array<array<u32, 2>, 4>(_e772.member_1[0], array<u32, 2>(select(4294967295u, _e329.member_3, _e797), select(4294967295u, _e298[1], _e797)), _e772.member_1[2], _e772.member_1[3]));
                                } else {
                                    let _e636 = b.member[_e331.member_1];
                                    let _e641 = b.member[_e331.member_3];
                                    let _e650 = type_24(array<array<u32, 2>, 4>(array<u32, 2>(_e298[0], _e331.member_1), array<u32, 2>(_e298[0], _e331.member_3), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1);
                                    let _e675 = ((((((_e329.member[0] <= _e636.member_2[0]) && (_e636.member[0] <= _e329.member_2[0])) && (_e329.member[1] <= _e636.member_2[1])) && (_e636.member[1] <= _e329.member_2[1])) && (_e329.member[2] <= _e636.member_2[2])) && (_e636.member[2] <= _e329.member_2[2]));
                                    let _e685 = type_24(_e650.member, array<array<u32, 2>, 4>(array<u32, 2>(select(4294967295u, _e298[0], _e675), select(4294967295u, _e331.member_1, _e675)), _e650.member_1[1], _e650.member_1[2], _e650.member_1[3]));
                                    let _e710 = ((((((_e329.member[0] <= _e641.member_2[0]) && (_e641.member[0] <= _e329.member_2[0])) && (_e329.member[1] <= _e641.member_2[1])) && (_e641.member[1] <= _e329.member_2[1])) && (_e329.member[2] <= _e641.member_2[2])) && (_e641.member[2] <= _e329.member_2[2]));
                                    phi_1231_ = type_24(_e685.member, array<array<u32, 2>, 4>(_e685.member_1[0], array<u32, 2>(select(4294967295u, _e298[0], _e710), select(4294967295u, _e331.member_3, _e710)), _e685.member_1[2], _e685.member_1[3]));
                                }
                                let _e809 = phi_1231_;
                                phi_1232_ = _e809;
                            } else {
                                phi_1232_ = _e631;
                            }
                            let _e811 = phi_1232_;
                            phi_1233_ = _e811;
                            phi_1234_ = false;
                        } else {
                            phi_1233_ = type_24();
                            phi_1234_ = true;
                        }
                        let _e813 = phi_1233_;
                        let _e815 = phi_1234_;
                        phi_1235_ = _e813;
                        phi_1236_ = type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)));
                        phi_1237_ = _e815;
                    } else {
                        phi_1235_ = type_24();
                        phi_1236_ = _e436;
                        phi_1237_ = true;
                    }
                    let _e817 = phi_1235_;
                    let _e819 = phi_1236_;
                    let _e821 = phi_1237_;
                    if _e821 {
                        phi_1241_ = _e819;
                    } else {
                        phi_1241_ = _e817;
                    }
                    let _e823 = phi_1241_;
                    let _e827 = params.member.member_2.member;
                    let _e828 = (_e827 == 0u);
                    let _e834 = params.member.member.member[select(1u, 0u, _e828)];
                    let _e835 = (_e834 - 1u);
                    let _e839 = params.member.member.member[select(1u, 2u, _e828)];
                    let _e840 = (_e839 - 1u);
                    let _e843 = params.member.member_2.member;
                    let _e844 = (_e843 == 0u);
                    let _e850 = params.member.member.member_2[select(1u, 0u, _e844)];
                    let _e854 = params.member.member.member_2[select(1u, 2u, _e844)];
                    let _e857 = params.member.member_2.member;
                    local_1 = array<array<u32, 2>, 4>(array<u32, 2>(_e823.member_1[0][0], _e823.member_1[0][1]), array<u32, 2>(_e823.member_1[1][0], _e823.member_1[1][1]), array<u32, 2>(_e823.member_1[2][0], _e823.member_1[2][1]), array<u32, 2>(_e823.member_1[3][0], _e823.member_1[3][1]));
                    phi_1335_ = type_9(0u, 4u);
                    loop {
                        let _e877 = phi_1335_;
                        let _e880 = (_e877.member < _e877.member_1);
                        let _e891 = select(type_9().member_1, _e877.member, _e880);
                        let _e893 = (bitcast<i32>(select(0u, 1u, _e880)) != 0i);
                        if _e893 {
                            let _e895 = local_1[_e891];
                            if (_e895[0] != 4294967295u) {
                                if select(false, (_e895[0] == _e895[1]), (_e857 == 1u)) {
                                    phi_3597_ = bool();
                                    phi_3598_ = true;
                                } else {
                                    if select(true, select(true, false, (_e895[1] >= _e840)), (_e895[0] >= _e835)) {
                                        if (_e895[0] < _e835) {
                                            let _e975 = oriented.member[(_e850 + _e895[0])];
                                            phi_1548_ = type_31(array<f32, 3>(_e975.member.x, _e975.member.y, _e975.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e975.member.w, _e975.member_1.x, _e975.member_1.y), array<f32, 3>(_e975.member_1.z, _e975.member_1.w, _e975.member_2.x), array<f32, 3>(_e975.member_2.y, _e975.member_2.z, _e975.member_2.w)), array<f32, 3>(_e975.member_3.x, _e975.member_3.y, _e975.member_3.z));
                                        } else {
                                            let _e907 = a.member[_e895[0]];
                                            let _e922 = ((_e907.member[0] * 0.5f) + (_e907.member_2[0] * 0.5f));
                                            let _e923 = ((_e907.member[1] * 0.5f) + (_e907.member_2[1] * 0.5f));
                                            let _e924 = ((_e907.member[2] * 0.5f) + (_e907.member_2[2] * 0.5f));
                                            let _e927 = select(_e907.member_2[0], _e922, (_e922 < _e907.member_2[0]));
                                            let _e930 = select(_e907.member_2[1], _e923, (_e923 < _e907.member_2[1]));
                                            let _e933 = select(_e907.member_2[2], _e924, (_e924 < _e907.member_2[2]));
                                            let _e936 = select(_e907.member[0], _e927, (_e927 > _e907.member[0]));
                                            let _e939 = select(_e907.member[1], _e930, (_e930 > _e907.member[1]));
                                            let _e942 = select(_e907.member[2], _e933, (_e933 > _e907.member[2]));
                                            let _e945 = (_e907.member_2[0] - _e936);
                                            let _e947 = (_e907.member_2[1] - _e939);
                                            let _e949 = (_e907.member_2[2] - _e942);
                                            let _e951 = (_e936 - _e907.member[0]);
                                            let _e953 = (_e939 - _e907.member[1]);
                                            let _e955 = (_e942 - _e907.member[2]);
                                            let _e963 = (1f + (0.000000059604645f * 4f));
                                            let _e967 = (0.000000000000000000000000000000000000011754944f * 8f);
                                            phi_1548_ = type_31(array<f32, 3>(_e936, _e939, _e942), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((select(_e951, _e945, (_e945 > _e951)) * _e963) + _e967), ((select(_e953, _e947, (_e947 > _e953)) * _e963) + _e967), ((select(_e955, _e949, (_e949 > _e955)) * _e963) + _e967)));
                                        }
                                        let _e1014 = phi_1548_;
                                        if (_e895[1] < _e840) {
                                            let _e1085 = oriented.member[(_e854 + _e895[1])];
                                            phi_1692_ = type_31(array<f32, 3>(_e1085.member.x, _e1085.member.y, _e1085.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e1085.member.w, _e1085.member_1.x, _e1085.member_1.y), array<f32, 3>(_e1085.member_1.z, _e1085.member_1.w, _e1085.member_2.x), array<f32, 3>(_e1085.member_2.y, _e1085.member_2.z, _e1085.member_2.w)), array<f32, 3>(_e1085.member_3.x, _e1085.member_3.y, _e1085.member_3.z));
                                        } else {
                                            let _e1017 = b.member[_e895[1]];
                                            let _e1032 = ((_e1017.member[0] * 0.5f) + (_e1017.member_2[0] * 0.5f));
                                            let _e1033 = ((_e1017.member[1] * 0.5f) + (_e1017.member_2[1] * 0.5f));
                                            let _e1034 = ((_e1017.member[2] * 0.5f) + (_e1017.member_2[2] * 0.5f));
                                            let _e1037 = select(_e1017.member_2[0], _e1032, (_e1032 < _e1017.member_2[0]));
                                            let _e1040 = select(_e1017.member_2[1], _e1033, (_e1033 < _e1017.member_2[1]));
                                            let _e1043 = select(_e1017.member_2[2], _e1034, (_e1034 < _e1017.member_2[2]));
                                            let _e1046 = select(_e1017.member[0], _e1037, (_e1037 > _e1017.member[0]));
                                            let _e1049 = select(_e1017.member[1], _e1040, (_e1040 > _e1017.member[1]));
                                            let _e1052 = select(_e1017.member[2], _e1043, (_e1043 > _e1017.member[2]));
                                            let _e1055 = (_e1017.member_2[0] - _e1046);
                                            let _e1057 = (_e1017.member_2[1] - _e1049);
                                            let _e1059 = (_e1017.member_2[2] - _e1052);
                                            let _e1061 = (_e1046 - _e1017.member[0]);
                                            let _e1063 = (_e1049 - _e1017.member[1]);
                                            let _e1065 = (_e1052 - _e1017.member[2]);
                                            let _e1073 = (1f + (0.000000059604645f * 4f));
                                            let _e1077 = (0.000000000000000000000000000000000000011754944f * 8f);
                                            phi_1692_ = type_31(array<f32, 3>(_e1046, _e1049, _e1052), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((select(_e1061, _e1055, (_e1055 > _e1061)) * _e1073) + _e1077), ((select(_e1063, _e1057, (_e1057 > _e1063)) * _e1073) + _e1077), ((select(_e1065, _e1059, (_e1059 > _e1065)) * _e1073) + _e1077)));
                                        }
                                        let _e1124 = phi_1692_;
                                        let _e1129 = (_e1124.member[0] - _e1014.member[0]);
                                        let _e1132 = (_e1124.member[1] - _e1014.member[1]);
                                        let _e1135 = (_e1124.member[2] - _e1014.member[2]);
                                        local = type_26(array<array<f32, 3>, 3>(array<f32, 3>((((_e1124.member_1[0][0] * _e1014.member_1[0][0]) + (_e1124.member_1[0][1] * _e1014.member_1[0][1])) + (_e1124.member_1[0][2] * _e1014.member_1[0][2])), (((_e1124.member_1[1][0] * _e1014.member_1[0][0]) + (_e1124.member_1[1][1] * _e1014.member_1[0][1])) + (_e1124.member_1[1][2] * _e1014.member_1[0][2])), (((_e1124.member_1[2][0] * _e1014.member_1[0][0]) + (_e1124.member_1[2][1] * _e1014.member_1[0][1])) + (_e1124.member_1[2][2] * _e1014.member_1[0][2]))), array<f32, 3>((((_e1124.member_1[0][0] * _e1014.member_1[1][0]) + (_e1124.member_1[0][1] * _e1014.member_1[1][1])) + (_e1124.member_1[0][2] * _e1014.member_1[1][2])), (((_e1124.member_1[1][0] * _e1014.member_1[1][0]) + (_e1124.member_1[1][1] * _e1014.member_1[1][1])) + (_e1124.member_1[1][2] * _e1014.member_1[1][2])), (((_e1124.member_1[2][0] * _e1014.member_1[1][0]) + (_e1124.member_1[2][1] * _e1014.member_1[1][1])) + (_e1124.member_1[2][2] * _e1014.member_1[1][2]))), array<f32, 3>((((_e1124.member_1[0][0] * _e1014.member_1[2][0]) + (_e1124.member_1[0][1] * _e1014.member_1[2][1])) + (_e1124.member_1[0][2] * _e1014.member_1[2][2])), (((_e1124.member_1[1][0] * _e1014.member_1[2][0]) + (_e1124.member_1[1][1] * _e1014.member_1[2][1])) + (_e1124.member_1[1][2] * _e1014.member_1[2][2])), (((_e1124.member_1[2][0] * _e1014.member_1[2][0]) + (_e1124.member_1[2][1] * _e1014.member_1[2][1])) + (_e1124.member_1[2][2] * _e1014.member_1[2][2])))), array<f32, 3>((((_e1014.member_1[0][0] * _e1129) + (_e1014.member_1[0][1] * _e1132)) + (_e1014.member_1[0][2] * _e1135)), (((_e1014.member_1[1][0] * _e1129) + (_e1014.member_1[1][1] * _e1132)) + (_e1014.member_1[1][2] * _e1135)), (((_e1014.member_1[2][0] * _e1129) + (_e1014.member_1[2][1] * _e1132)) + (_e1014.member_1[2][2] * _e1135))), array<f32, 3>((((_e1124.member_1[0][0] * _e1129) + (_e1124.member_1[0][1] * _e1132)) + (_e1124.member_1[0][2] * _e1135)), (((_e1124.member_1[1][0] * _e1129) + (_e1124.member_1[1][1] * _e1132)) + (_e1124.member_1[1][2] * _e1135)), (((_e1124.member_1[2][0] * _e1129) + (_e1124.member_1[2][1] * _e1132)) + (_e1124.member_1[2][2] * _e1135))), array<f32, 3>(_e1014.member_2[0], _e1014.member_2[1], _e1014.member_2[2]), array<f32, 3>(_e1124.member_2[0], _e1124.member_2[1], _e1124.member_2[2]), ((((((select(_e1129, -(_e1129), (_e1129 < 0f)) + select(_e1132, -(_e1132), (_e1132 < 0f))) + select(_e1135, -(_e1135), (_e1135 < 0f))) + (((select(_e1014.member_2[0], -(_e1014.member_2[0]), (_e1014.member_2[0] < 0f)) + select(_e1014.member_2[1], -(_e1014.member_2[1]), (_e1014.member_2[1] < 0f))) + select(_e1014.member_2[2], -(_e1014.member_2[2]), (_e1014.member_2[2] < 0f))) + ((select(_e1124.member_2[0], -(_e1124.member_2[0]), (_e1124.member_2[0] < 0f)) + select(_e1124.member_2[1], -(_e1124.member_2[1]), (_e1124.member_2[1] < 0f))) + select(_e1124.member_2[2], -(_e1124.member_2[2]), (_e1124.member_2[2] < 0f))))) * 2f) * (0.000000059604645f * 128f)) + (0.000000000000000000000000000000000000011754944f * 128f)));
                                        let _e1387 = local.member[0u][0u];
                                        let _e1391 = local.member[0u][1u];
                                        let _e1395 = local.member[0u][2u];
                                        let _e1399 = local.member[1u][0u];
                                        let _e1403 = local.member[1u][1u];
                                        let _e1407 = local.member[1u][2u];
                                        let _e1411 = local.member[2u][0u];
                                        let _e1415 = local.member[2u][1u];
                                        let _e1419 = local.member[2u][2u];
                                        let _e1421 = local.member_3;
                                        let _e1426 = local.member_4;
                                        let _e1432 = local.member_1[0u];
                                        let _e1451 = (select(_e1432, -(_e1432), (_e1432 < 0f)) - (_e1421[0] + (((select(_e1387, -(_e1387), (_e1387 < 0f)) * _e1426[0]) + (select(_e1391, -(_e1391), (_e1391 < 0f)) * _e1426[1])) + (select(_e1395, -(_e1395), (_e1395 < 0f)) * _e1426[2]))));
                                        let _e1454 = local.member_1[1u];
                                        let _e1473 = (select(_e1454, -(_e1454), (_e1454 < 0f)) - (_e1421[1] + (((select(_e1399, -(_e1399), (_e1399 < 0f)) * _e1426[0]) + (select(_e1403, -(_e1403), (_e1403 < 0f)) * _e1426[1])) + (select(_e1407, -(_e1407), (_e1407 < 0f)) * _e1426[2]))));
                                        let _e1476 = local.member_1[2u];
                                        let _e1495 = (select(_e1476, -(_e1476), (_e1476 < 0f)) - (_e1421[2] + (((select(_e1411, -(_e1411), (_e1411 < 0f)) * _e1426[0]) + (select(_e1415, -(_e1415), (_e1415 < 0f)) * _e1426[1])) + (select(_e1419, -(_e1419), (_e1419 < 0f)) * _e1426[2]))));
                                        let _e1498 = local.member_2[0u];
                                        let _e1517 = (select(_e1498, -(_e1498), (_e1498 < 0f)) - (_e1426[0] + (((select(_e1387, -(_e1387), (_e1387 < 0f)) * _e1421[0]) + (select(_e1399, -(_e1399), (_e1399 < 0f)) * _e1421[1])) + (select(_e1411, -(_e1411), (_e1411 < 0f)) * _e1421[2]))));
                                        let _e1520 = local.member_2[1u];
                                        let _e1539 = (select(_e1520, -(_e1520), (_e1520 < 0f)) - (_e1426[1] + (((select(_e1391, -(_e1391), (_e1391 < 0f)) * _e1421[0]) + (select(_e1403, -(_e1403), (_e1403 < 0f)) * _e1421[1])) + (select(_e1415, -(_e1415), (_e1415 < 0f)) * _e1421[2]))));
                                        let _e1542 = local.member_2[2u];
                                        let _e1561 = (select(_e1542, -(_e1542), (_e1542 < 0f)) - (_e1426[2] + (((select(_e1395, -(_e1395), (_e1395 < 0f)) * _e1421[0]) + (select(_e1407, -(_e1407), (_e1407 < 0f)) * _e1421[1])) + (select(_e1419, -(_e1419), (_e1419 < 0f)) * _e1421[2]))));
                                        let _e1563 = select(_e1473, _e1451, (_e1451 > _e1473));
                                        let _e1565 = select(_e1495, _e1563, (_e1563 > _e1495));
                                        let _e1567 = select(_e1539, _e1517, (_e1517 > _e1539));
                                        let _e1569 = select(_e1561, _e1567, (_e1567 > _e1561));
                                        let _e1573 = local.member_5;
                                        if (select(_e1569, _e1565, (_e1565 > _e1569)) > _e1573) {
                                            phi_3593_ = true;
                                        } else {
                                            let _e1578 = local.member[1u][0u];
                                            let _e1581 = local.member_1[2u];
                                            let _e1586 = local.member[2u][0u];
                                            let _e1589 = local.member_1[1u];
                                            let _e1591 = ((_e1578 * _e1581) - (_e1586 * _e1589));
                                            let _e1595 = local.member[2u][0u];
                                            let _e1601 = local.member_3[1u];
                                            let _e1606 = local.member[1u][0u];
                                            let _e1612 = local.member_3[2u];
                                            let _e1618 = local.member[0u][2u];
                                            let _e1624 = local.member_4[1u];
                                            let _e1629 = local.member[0u][1u];
                                            let _e1635 = local.member_4[2u];
                                            let _e1642 = (select(_e1591, -(_e1591), (_e1591 < 0f)) - (((select(_e1595, -(_e1595), (_e1595 < 0f)) * _e1601) + (select(_e1606, -(_e1606), (_e1606 < 0f)) * _e1612)) + ((select(_e1618, -(_e1618), (_e1618 < 0f)) * _e1624) + (select(_e1629, -(_e1629), (_e1629 < 0f)) * _e1635))));
                                            let _e1646 = local.member[1u][1u];
                                            let _e1649 = local.member_1[2u];
                                            let _e1654 = local.member[2u][1u];
                                            let _e1657 = local.member_1[1u];
                                            let _e1659 = ((_e1646 * _e1649) - (_e1654 * _e1657));
                                            let _e1663 = local.member[2u][1u];
                                            let _e1669 = local.member_3[1u];
                                            let _e1674 = local.member[1u][1u];
                                            let _e1680 = local.member_3[2u];
                                            let _e1686 = local.member[0u][0u];
                                            let _e1692 = local.member_4[2u];
                                            let _e1697 = local.member[0u][2u];
                                            let _e1703 = local.member_4[0u];
                                            let _e1710 = (select(_e1659, -(_e1659), (_e1659 < 0f)) - (((select(_e1663, -(_e1663), (_e1663 < 0f)) * _e1669) + (select(_e1674, -(_e1674), (_e1674 < 0f)) * _e1680)) + ((select(_e1686, -(_e1686), (_e1686 < 0f)) * _e1692) + (select(_e1697, -(_e1697), (_e1697 < 0f)) * _e1703))));
                                            let _e1714 = local.member[1u][2u];
                                            let _e1717 = local.member_1[2u];
                                            let _e1722 = local.member[2u][2u];
                                            let _e1725 = local.member_1[1u];
                                            let _e1727 = ((_e1714 * _e1717) - (_e1722 * _e1725));
                                            let _e1731 = local.member[2u][2u];
                                            let _e1737 = local.member_3[1u];
                                            let _e1742 = local.member[1u][2u];
                                            let _e1748 = local.member_3[2u];
                                            let _e1754 = local.member[0u][1u];
                                            let _e1760 = local.member_4[0u];
                                            let _e1765 = local.member[0u][0u];
                                            let _e1771 = local.member_4[1u];
                                            let _e1778 = (select(_e1727, -(_e1727), (_e1727 < 0f)) - (((select(_e1731, -(_e1731), (_e1731 < 0f)) * _e1737) + (select(_e1742, -(_e1742), (_e1742 < 0f)) * _e1748)) + ((select(_e1754, -(_e1754), (_e1754 < 0f)) * _e1760) + (select(_e1765, -(_e1765), (_e1765 < 0f)) * _e1771))));
                                            let _e1782 = local.member[2u][0u];
                                            let _e1785 = local.member_1[0u];
                                            let _e1790 = local.member[0u][0u];
                                            let _e1793 = local.member_1[2u];
                                            let _e1795 = ((_e1782 * _e1785) - (_e1790 * _e1793));
                                            let _e1799 = local.member[0u][0u];
                                            let _e1805 = local.member_3[2u];
                                            let _e1810 = local.member[2u][0u];
                                            let _e1816 = local.member_3[0u];
                                            let _e1822 = local.member[1u][2u];
                                            let _e1828 = local.member_4[1u];
                                            let _e1833 = local.member[1u][1u];
                                            let _e1839 = local.member_4[2u];
                                            let _e1846 = (select(_e1795, -(_e1795), (_e1795 < 0f)) - (((select(_e1799, -(_e1799), (_e1799 < 0f)) * _e1805) + (select(_e1810, -(_e1810), (_e1810 < 0f)) * _e1816)) + ((select(_e1822, -(_e1822), (_e1822 < 0f)) * _e1828) + (select(_e1833, -(_e1833), (_e1833 < 0f)) * _e1839))));
                                            let _e1850 = local.member[2u][1u];
                                            let _e1853 = local.member_1[0u];
                                            let _e1858 = local.member[0u][1u];
                                            let _e1861 = local.member_1[2u];
                                            let _e1863 = ((_e1850 * _e1853) - (_e1858 * _e1861));
                                            let _e1867 = local.member[0u][1u];
                                            let _e1873 = local.member_3[2u];
                                            let _e1878 = local.member[2u][1u];
                                            let _e1884 = local.member_3[0u];
                                            let _e1890 = local.member[1u][0u];
                                            let _e1896 = local.member_4[2u];
                                            let _e1901 = local.member[1u][2u];
                                            let _e1907 = local.member_4[0u];
                                            let _e1914 = (select(_e1863, -(_e1863), (_e1863 < 0f)) - (((select(_e1867, -(_e1867), (_e1867 < 0f)) * _e1873) + (select(_e1878, -(_e1878), (_e1878 < 0f)) * _e1884)) + ((select(_e1890, -(_e1890), (_e1890 < 0f)) * _e1896) + (select(_e1901, -(_e1901), (_e1901 < 0f)) * _e1907))));
                                            let _e1918 = local.member[2u][2u];
                                            let _e1921 = local.member_1[0u];
                                            let _e1926 = local.member[0u][2u];
                                            let _e1929 = local.member_1[2u];
                                            let _e1931 = ((_e1918 * _e1921) - (_e1926 * _e1929));
                                            let _e1935 = local.member[0u][2u];
                                            let _e1941 = local.member_3[2u];
                                            let _e1946 = local.member[2u][2u];
                                            let _e1952 = local.member_3[0u];
                                            let _e1958 = local.member[1u][1u];
                                            let _e1964 = local.member_4[0u];
                                            let _e1969 = local.member[1u][0u];
                                            let _e1975 = local.member_4[1u];
                                            let _e1982 = (select(_e1931, -(_e1931), (_e1931 < 0f)) - (((select(_e1935, -(_e1935), (_e1935 < 0f)) * _e1941) + (select(_e1946, -(_e1946), (_e1946 < 0f)) * _e1952)) + ((select(_e1958, -(_e1958), (_e1958 < 0f)) * _e1964) + (select(_e1969, -(_e1969), (_e1969 < 0f)) * _e1975))));
                                            let _e1986 = local.member[0u][0u];
                                            let _e1989 = local.member_1[1u];
                                            let _e1994 = local.member[1u][0u];
                                            let _e1997 = local.member_1[0u];
                                            let _e1999 = ((_e1986 * _e1989) - (_e1994 * _e1997));
                                            let _e2003 = local.member[1u][0u];
                                            let _e2009 = local.member_3[0u];
                                            let _e2014 = local.member[0u][0u];
                                            let _e2020 = local.member_3[1u];
                                            let _e2026 = local.member[2u][2u];
                                            let _e2032 = local.member_4[1u];
                                            let _e2037 = local.member[2u][1u];
                                            let _e2043 = local.member_4[2u];
                                            let _e2050 = (select(_e1999, -(_e1999), (_e1999 < 0f)) - (((select(_e2003, -(_e2003), (_e2003 < 0f)) * _e2009) + (select(_e2014, -(_e2014), (_e2014 < 0f)) * _e2020)) + ((select(_e2026, -(_e2026), (_e2026 < 0f)) * _e2032) + (select(_e2037, -(_e2037), (_e2037 < 0f)) * _e2043))));
                                            let _e2054 = local.member[0u][1u];
                                            let _e2057 = local.member_1[1u];
                                            let _e2062 = local.member[1u][1u];
                                            let _e2065 = local.member_1[0u];
                                            let _e2067 = ((_e2054 * _e2057) - (_e2062 * _e2065));
                                            let _e2071 = local.member[1u][1u];
                                            let _e2077 = local.member_3[0u];
                                            let _e2082 = local.member[0u][1u];
                                            let _e2088 = local.member_3[1u];
                                            let _e2094 = local.member[2u][0u];
                                            let _e2100 = local.member_4[2u];
                                            let _e2105 = local.member[2u][2u];
                                            let _e2111 = local.member_4[0u];
                                            let _e2118 = (select(_e2067, -(_e2067), (_e2067 < 0f)) - (((select(_e2071, -(_e2071), (_e2071 < 0f)) * _e2077) + (select(_e2082, -(_e2082), (_e2082 < 0f)) * _e2088)) + ((select(_e2094, -(_e2094), (_e2094 < 0f)) * _e2100) + (select(_e2105, -(_e2105), (_e2105 < 0f)) * _e2111))));
                                            let _e2122 = local.member[0u][2u];
                                            let _e2125 = local.member_1[1u];
                                            let _e2130 = local.member[1u][2u];
                                            let _e2133 = local.member_1[0u];
                                            let _e2135 = ((_e2122 * _e2125) - (_e2130 * _e2133));
                                            let _e2139 = local.member[1u][2u];
                                            let _e2145 = local.member_3[0u];
                                            let _e2150 = local.member[0u][2u];
                                            let _e2156 = local.member_3[1u];
                                            let _e2162 = local.member[2u][1u];
                                            let _e2168 = local.member_4[0u];
                                            let _e2173 = local.member[2u][0u];
                                            let _e2179 = local.member_4[1u];
                                            let _e2186 = (select(_e2135, -(_e2135), (_e2135 < 0f)) - (((select(_e2139, -(_e2139), (_e2139 < 0f)) * _e2145) + (select(_e2150, -(_e2150), (_e2150 < 0f)) * _e2156)) + ((select(_e2162, -(_e2162), (_e2162 < 0f)) * _e2168) + (select(_e2173, -(_e2173), (_e2173 < 0f)) * _e2179))));
                                            let _e2188 = select(_e1710, _e1642, (_e1642 > _e1710));
                                            let _e2190 = select(_e1778, _e2188, (_e2188 > _e1778));
                                            let _e2192 = select(_e1914, _e1846, (_e1846 > _e1914));
                                            let _e2194 = select(_e1982, _e2192, (_e2192 > _e1982));
                                            let _e2196 = select(_e2194, _e2190, (_e2190 > _e2194));
                                            let _e2198 = select(_e2118, _e2050, (_e2050 > _e2118));
                                            let _e2200 = select(_e2186, _e2198, (_e2198 > _e2186));
                                            let _e2204 = local.member_5;
                                            phi_3593_ = (select(_e2200, _e2196, (_e2196 > _e2200)) > _e2204);
                                        }
                                        let _e2207 = phi_3593_;
                                        phi_3595_ = !(_e2207);
                                        phi_3596_ = false;
                                    } else {
                                        phi_3595_ = bool();
                                        phi_3596_ = true;
                                    }
                                    let _e2210 = phi_3595_;
                                    let _e2212 = phi_3596_;
                                    phi_3597_ = _e2210;
                                    phi_3598_ = _e2212;
                                }
                                let _e2214 = phi_3597_;
                                let _e2216 = phi_3598_;
                                if select(_e2214, true, _e2216) {
                                } else {
                                    local_1[_e891] = array<u32, 2>(4294967295u, 4294967295u);
                                }
                            }
                        }
                        continue;
                        continuing {
                            phi_1335_ = type_9(select(_e877.member, (_e877.member + 1u), _e880), select(_e877.member_1, _e877.member_1, _e880));
                            break if !(_e893);
                        }
                    }
                    let _e2220 = local_1;
                    let _e2224 = array<u32, 2>(_e2220[0][0], _e2220[0][1]);
                    let _e2228 = array<u32, 2>(_e2220[1][0], _e2220[1][1]);
                    let _e2232 = array<u32, 2>(_e2220[2][0], _e2220[2][1]);
                    let _e2236 = array<u32, 2>(_e2220[3][0], _e2220[3][1]);
                    let _e2240 = params.member.member_2.member_4;
                    if (_e2240 > 0u) {
                        phi_3639_ = _e823.member;
                    } else {
                        phi_3639_ = array<array<u32, 2>, 4>(_e2224, _e2228, _e2232, _e2236);
                    }
                    let _e2244 = phi_3639_;
                    let _e2252 = select(select(2u, 1u, select(true, select(true, false, (_e2220[0][1] >= _e318)), (_e2220[0][0] >= _e313))), 0u, (_e2220[0][0] == 4294967295u));
                    let _e2253 = type_33(_e2224, _e2252);
                    if (_e2252 == 0u) {
                        if (_e2244[0][0] != 4294967295u) {
                            phi_3675_ = type_33(_e2244[0], 3u);
                        } else {
                            phi_3675_ = _e2253;
                        }
                        let _e2259 = phi_3675_;
                        phi_3676_ = _e2259;
                    } else {
                        phi_3676_ = _e2253;
                    }
                    let _e2261 = phi_3676_;
                    let _e2269 = select(select(2u, 1u, select(true, select(true, false, (_e2220[1][1] >= _e318)), (_e2220[1][0] >= _e313))), 0u, (_e2220[1][0] == 4294967295u));
                    let _e2270 = type_33(_e2228, _e2269);
                    if (_e2269 == 0u) {
                        if (_e2244[1][0] != 4294967295u) {
                            phi_3712_ = type_33(_e2244[1], 3u);
                        } else {
                            phi_3712_ = _e2270;
                        }
                        let _e2276 = phi_3712_;
                        phi_3713_ = _e2276;
                    } else {
                        phi_3713_ = _e2270;
                    }
                    let _e2278 = phi_3713_;
                    let _e2286 = select(select(2u, 1u, select(true, select(true, false, (_e2220[2][1] >= _e318)), (_e2220[2][0] >= _e313))), 0u, (_e2220[2][0] == 4294967295u));
                    let _e2287 = type_33(_e2232, _e2286);
                    if (_e2286 == 0u) {
                        if (_e2244[2][0] != 4294967295u) {
                            phi_3749_ = type_33(_e2244[2], 3u);
                        } else {
                            phi_3749_ = _e2287;
                        }
                        let _e2293 = phi_3749_;
                        phi_3750_ = _e2293;
                    } else {
                        phi_3750_ = _e2287;
                    }
                    let _e2295 = phi_3750_;
                    let _e2303 = select(select(2u, 1u, select(true, select(true, false, (_e2220[3][1] >= _e318)), (_e2220[3][0] >= _e313))), 0u, (_e2220[3][0] == 4294967295u));
                    let _e2304 = type_33(_e2236, _e2303);
                    if (_e2303 == 0u) {
                        if (_e2244[3][0] != 4294967295u) {
                            phi_3786_ = type_33(_e2244[3], 3u);
                        } else {
                            phi_3786_ = _e2304;
                        }
                        let _e2310 = phi_3786_;
                        phi_3787_ = _e2310;
                    } else {
                        phi_3787_ = _e2304;
                    }
                    let _e2312 = phi_3787_;
                    if (select(select(2u, 1u, select(true, select(true, false, (_e298[1] >= _e318)), (_e298[0] >= _e313))), 0u, (_e298[0] == 4294967295u)) == 2u) {
                        phi_3815_ = type_33(_e298, 2u);
                    } else {
                        phi_3815_ = _e2261;
                    }
                    let _e2326 = phi_3815_;
                    phi_3816_ = _e2326;
                    phi_3817_ = _e2312;
                    phi_3818_ = _e2295;
                    phi_3819_ = _e2278;
                } else {
                    phi_3816_ = type_33(array<u32, 2>(4294967295u, 4294967295u), 0u);
                    phi_3817_ = type_33(array<u32, 2>(4294967295u, 4294967295u), 0u);
                    phi_3818_ = type_33(array<u32, 2>(4294967295u, 4294967295u), 0u);
                    phi_3819_ = type_33(array<u32, 2>(4294967295u, 4294967295u), 0u);
                }
                let _e2328 = phi_3816_;
                let _e2330 = phi_3817_;
                let _e2332 = phi_3818_;
                let _e2334 = phi_3819_;
                if (_e92.member_11 == 1u) {
                    let _e2513 = select(0u, (((select(0u, 1u, (_e2328.member_1 >= 2u)) + select(0u, 1u, (_e2334.member_1 >= 2u))) + select(0u, 1u, (_e2332.member_1 >= 2u))) + select(0u, 1u, (_e2330.member_1 >= 2u))), (_e92.member_4 > 0u));
                    let _e2516 = ((((select(0u, 1u, (_e2328.member_1 == 1u)) + select(0u, 1u, (_e2334.member_1 == 1u))) + select(0u, 1u, (_e2332.member_1 == 1u))) + select(0u, 1u, (_e2330.member_1 == 1u))) | ((((select(0u, 1u, (_e2328.member_1 == 2u)) + select(0u, 1u, (_e2334.member_1 == 2u))) + select(0u, 1u, (_e2332.member_1 == 2u))) + select(0u, 1u, (_e2330.member_1 == 2u))) << bitcast<u32>(16i)));
                    sums[_e77] = _e2516;
                    phi_3885_ = type_9(0u, 7u);
                    phi_3888_ = 0u;
                    phi_3890_ = 1u;
                    phi_3892_ = _e2516;
                    phi_3889_ = 128u;
                    loop {
                        let _e2519 = phi_3885_;
                        let _e2521 = phi_3888_;
                        let _e2523 = phi_3890_;
                        let _e2525 = phi_3892_;
                        let _e2527 = phi_3889_;
                        local_2 = _e2525;
                        let _e2530 = (_e2519.member < _e2519.member_1);
                        let _e2541 = (bitcast<i32>(select(0u, 1u, _e2530)) != 0i);
                        if _e2541 {
                            workgroupBarrier();
                            if (_e77 >= _e2523) {
                                let _e2546 = sums[((_e2521 + _e77) - _e2523)];
                                phi_3931_ = (_e2525 + _e2546);
                            } else {
                                phi_3931_ = _e2525;
                            }
                            let _e2549 = phi_3931_;
                            sums[(_e2527 + _e77)] = _e2549;
                            phi_3891_ = (_e2523 * 2u);
                            phi_3893_ = _e2549;
                        } else {
                            phi_3891_ = u32();
                            phi_3893_ = u32();
                        }
                        let _e2554 = phi_3891_;
                        let _e2556 = phi_3893_;
                        continue;
                        continuing {
                            phi_3885_ = type_9(select(_e2519.member, (_e2519.member + 1u), _e2530), select(_e2519.member_1, _e2519.member_1, _e2530));
                            phi_3888_ = _e2527;
                            phi_3890_ = _e2554;
                            phi_3892_ = _e2556;
                            phi_3889_ = _e2521;
                            break if !(_e2541);
                        }
                    }
                    workgroupBarrier();
                    let _e2559 = local_2;
                    let _e2560 = (_e2559 - _e2516);
                    if (_e77 == 0u) {
                        let _e2563 = sums[255u];
                        atomicStore((&shared_[6u]), (_e2563 & 65535u));
                        atomicStore((&shared_[7u]), (_e2563 >> bitcast<u32>(16i)));
                    }
                    if (_e92.member_4 > 0u) {
                        sums[_e77] = _e2513;
                        phi_3958_ = type_9(0u, 7u);
                        phi_3961_ = 0u;
                        phi_3963_ = 1u;
                        phi_3965_ = _e2513;
                        phi_3962_ = 128u;
                        loop {
                            let _e2573 = phi_3958_;
                            let _e2575 = phi_3961_;
                            let _e2577 = phi_3963_;
                            let _e2579 = phi_3965_;
                            let _e2581 = phi_3962_;
                            local_3 = _e2579;
                            let _e2584 = (_e2573.member < _e2573.member_1);
                            let _e2595 = (bitcast<i32>(select(0u, 1u, _e2584)) != 0i);
                            if _e2595 {
                                workgroupBarrier();
                                if (_e77 >= _e2577) {
                                    let _e2600 = sums[((_e2575 + _e77) - _e2577)];
                                    phi_4004_ = (_e2579 + _e2600);
                                } else {
                                    phi_4004_ = _e2579;
                                }
                                let _e2603 = phi_4004_;
                                sums[(_e2581 + _e77)] = _e2603;
                                phi_3964_ = (_e2577 * 2u);
                                phi_3966_ = _e2603;
                            } else {
                                phi_3964_ = u32();
                                phi_3966_ = u32();
                            }
                            let _e2608 = phi_3964_;
                            let _e2610 = phi_3966_;
                            continue;
                            continuing {
                                phi_3958_ = type_9(select(_e2573.member, (_e2573.member + 1u), _e2584), select(_e2573.member_1, _e2573.member_1, _e2584));
                                phi_3961_ = _e2581;
                                phi_3963_ = _e2608;
                                phi_3965_ = _e2610;
                                phi_3962_ = _e2575;
                                break if !(_e2595);
                            }
                        }
                        workgroupBarrier();
                        let _e2613 = local_3;
                        if (_e77 == 0u) {
                            let _e2617 = sums[255u];
                            atomicStore((&shared_[8u]), _e2617);
                        }
                        phi_4018_ = (_e2613 - _e2513);
                    } else {
                        phi_4018_ = 0u;
                    }
                    let _e2620 = phi_4018_;
                    let _e2621 = (_e2560 & 65535u);
                    let _e2623 = (_e2560 >> bitcast<u32>(16i));
                    let _e2631 = (_e2621 + select(0u, 1u, (_e2328.member_1 == 1u)));
                    let _e2635 = (_e2623 + select(0u, 1u, (_e2328.member_1 == 2u)));
                    let _e2639 = (_e2620 + select(0u, 1u, (_e2328.member_1 >= 2u)));
                    let _e2647 = (_e2631 + select(0u, 1u, (_e2334.member_1 == 1u)));
                    let _e2651 = (_e2635 + select(0u, 1u, (_e2334.member_1 == 2u)));
                    let _e2655 = (_e2639 + select(0u, 1u, (_e2334.member_1 >= 2u)));
                    phi_4241_ = type_34(array<u32, 2>(select(_e2623, _e2621, (_e2328.member_1 == 1u)), _e2620), array<u32, 2>(select(_e2635, _e2631, (_e2334.member_1 == 1u)), _e2639), array<u32, 2>(select(_e2651, _e2647, (_e2332.member_1 == 1u)), _e2655), array<u32, 2>(select((_e2651 + select(0u, 1u, (_e2332.member_1 == 2u))), (_e2647 + select(0u, 1u, (_e2332.member_1 == 1u))), (_e2330.member_1 == 1u)), (_e2655 + select(0u, 1u, (_e2332.member_1 >= 2u)))));
                } else {
                    let _e2374 = (((select(0u, 1u, (_e2328.member_1 == 1u)) + select(0u, 1u, (_e2334.member_1 == 1u))) + select(0u, 1u, (_e2332.member_1 == 1u))) + select(0u, 1u, (_e2330.member_1 == 1u)));
                    let _e2378 = (((select(0u, 1u, (_e2328.member_1 == 2u)) + select(0u, 1u, (_e2334.member_1 == 2u))) + select(0u, 1u, (_e2332.member_1 == 2u))) + select(0u, 1u, (_e2330.member_1 == 2u)));
                    let _e2384 = select(0u, (((select(0u, 1u, (_e2328.member_1 >= 2u)) + select(0u, 1u, (_e2334.member_1 >= 2u))) + select(0u, 1u, (_e2332.member_1 >= 2u))) + select(0u, 1u, (_e2330.member_1 >= 2u))), (_e92.member_4 > 0u));
                    if (_e2374 > 0u) {
                        let _e2387 = atomicAdd((&shared_[6u]), _e2374);
                        phi_4149_ = array<u32, 3>(_e2387, 0u, 0u);
                    } else {
                        phi_4149_ = array<u32, 3>(0u, 0u, 0u);
                    }
                    let _e2390 = phi_4149_;
                    if (_e2378 > 0u) {
                        let _e2393 = atomicAdd((&shared_[7u]), _e2378);
                        phi_4158_ = array<u32, 3>(_e2390[0], _e2393, _e2390[2]);
                    } else {
                        phi_4158_ = _e2390;
                    }
                    let _e2398 = phi_4158_;
                    if (_e2384 > 0u) {
                        let _e2401 = atomicAdd((&shared_[8u]), _e2384);
                        phi_4167_ = array<u32, 3>(_e2398[0], _e2398[1], _e2401);
                    } else {
                        phi_4167_ = _e2398;
                    }
                    let _e2406 = phi_4167_;
                    let _e2418 = (_e2406[0] + select(0u, 1u, (_e2328.member_1 == 1u)));
                    let _e2423 = (_e2406[1] + select(0u, 1u, (_e2328.member_1 == 2u)));
                    let _e2428 = (_e2406[2] + select(0u, 1u, (_e2328.member_1 >= 2u)));
                    let _e2436 = (_e2418 + select(0u, 1u, (_e2334.member_1 == 1u)));
                    let _e2440 = (_e2423 + select(0u, 1u, (_e2334.member_1 == 2u)));
                    let _e2444 = (_e2428 + select(0u, 1u, (_e2334.member_1 >= 2u)));
                    phi_4241_ = type_34(array<u32, 2>(select(_e2406[1], _e2406[0], (_e2328.member_1 == 1u)), _e2406[2]), array<u32, 2>(select(_e2423, _e2418, (_e2334.member_1 == 1u)), _e2428), array<u32, 2>(select(_e2440, _e2436, (_e2332.member_1 == 1u)), _e2444), array<u32, 2>(select((_e2440 + select(0u, 1u, (_e2332.member_1 == 2u))), (_e2436 + select(0u, 1u, (_e2332.member_1 == 1u))), (_e2330.member_1 == 1u)), (_e2444 + select(0u, 1u, (_e2332.member_1 >= 2u)))));
                }
                let _e2678 = phi_4241_;
                workgroupBarrier();
                if (_e77 == 0u) {
                    let _e2681 = atomicLoad((&shared_[6u]));
                    let _e2683 = atomicLoad((&shared_[7u]));
                    let _e2685 = atomicLoad((&shared_[8u]));
                    let _e2687 = atomicLoad((&shared_[1u]));
                    let _e2689 = atomicLoad((&shared_[2u]));
                    let _e2691 = atomicLoad((&shared_[15u]));
                    atomicStore((&shared_[15u]), (_e2691 + 1u));
                    let _e2695 = atomicLoad((&shared_[16u]));
                    atomicStore((&shared_[16u]), ((_e2695 + _e2687) + _e2689));
                    let _e2700 = atomicLoad((&shared_[0u]));
                    let _e2701 = (_e2700 - _e2687);
                    let _e2703 = (_e92.member_10 - _e2701);
                    let _e2705 = select(_e2681, _e2703, (_e2703 < _e2681));
                    atomicStore((&shared_[9u]), _e2701);
                    atomicStore((&shared_[10u]), _e2705);
                    atomicStore((&shared_[0u]), (_e2701 + _e2705));
                    if (_e2681 > _e2705) {
                        let _e2711 = (_e2681 - _e2705);
                        if (_e92.member_13 == 0u) {
                        } else {
                            let _e2715 = atomicMax((&control.member[1536u]), 4294967295u);
                        }
                        let _e2718 = atomicAdd((&control.member[(_e94.member_1 + 1u)]), _e2711);
                        let _e2721 = atomicMax((&nodes.member[0u]), (_e2718 + _e2711));
                        if ((_e2718 + _e2711) < _e2718) {
                            let _e2725 = atomicAdd((&nodes.member[2u]), 1u);
                        }
                        atomicStore((&shared_[11u]), _e2718);
                    }
                    if (_e2683 > 0u) {
                        let _e2729 = atomicAdd((&pairs.member[0u]), _e2683);
                        if ((_e2729 + _e2683) < _e2729) {
                            let _e2733 = atomicAdd((&pairs.member[2u]), 1u);
                        }
                        atomicStore((&shared_[12u]), _e2729);
                    }
                    if (_e2685 > 0u) {
                        let _e2737 = atomicAdd((&control.member[1537u]), _e2685);
                        if ((_e2737 + _e2685) < _e2737) {
                            let _e2741 = atomicAdd((&control.member[1538u]), 1u);
                        }
                        atomicStore((&shared_[13u]), _e2737);
                    }
                }
                workgroupBarrier();
                if (_e2328.member_1 == 1u) {
                    let _e2804 = atomicLoad((&shared_[10u]));
                    if (_e2678.member[0] < _e2804) {
                        let _e2824 = atomicLoad((&shared_[9u]));
                        let _e2827 = (2u * (_e2824 + _e2678.member[0]));
                        stack[_e2827] = _e2328.member[0];
                        stack[(_e2827 + 1u)] = _e2328.member[1];
                    } else {
                        let _e2808 = atomicLoad((&shared_[11u]));
                        let _e2811 = ((_e2808 + _e2678.member[0]) - _e2804);
                        if (_e2811 < _e92.member_3) {
                            let _e2814 = (_e104 + _e2811);
                            if (_e2814 < 4294967295u) {
                                let _e2818 = (2u * _e2814);
                                atomicStore((&nodes.member[(4u + _e2818)]), _e2328.member[0]);
                                atomicStore((&nodes.member[(_e2818 + 5u)]), _e2328.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e2328.member_1 == 0u) {
                    } else {
                        if (_e2328.member_1 == 2u) {
                            let _e2753 = a.member[_e2328.member[0]];
                            let _e2757 = b.member[_e2328.member[1]];
                            let _e2761 = params.member.member_2.member;
                            if (_e2761 == 1u) {
                                let _e2764 = (_e2753.member_1 < _e2757.member_1);
                                phi_4476_ = type_9(select(_e2757.member_1, _e2753.member_1, _e2764), select(_e2753.member_1, _e2757.member_1, _e2764));
                            } else {
                                phi_4476_ = type_9(_e2753.member_1, _e2757.member_1);
                            }
                            let _e2769 = phi_4476_;
                            let _e2773 = params.member.member_1;
                            let _e2776 = atomicLoad((&shared_[12u]));
                            let _e2778 = (_e2776 + _e2678.member[0]);
                            if (_e2778 < _e2773.member_3) {
                                let _e2780 = (2u * _e2778);
                                atomicStore((&pairs.member[(4u + _e2780)]), _e2769.member);
                                atomicStore((&pairs.member[(_e2780 + 5u)]), _e2769.member_1);
                            }
                        }
                        if (_e92.member_4 > 0u) {
                            let _e2788 = atomicLoad((&shared_[13u]));
                            let _e2790 = (_e2788 + _e2678.member[1]);
                            if (_e2790 < _e92.member_4) {
                                let _e2797 = (2u * ((_e92.member_5 * _e92.member_4) + _e2790));
                                front.member[_e2797] = _e2328.member[0];
                                front.member[(_e2797 + 1u)] = _e2328.member[1];
                            }
                        }
                    }
                }
                if (_e2334.member_1 == 1u) {
                    let _e2894 = atomicLoad((&shared_[10u]));
                    if (_e2678.member_1[0] < _e2894) {
                        let _e2914 = atomicLoad((&shared_[9u]));
                        let _e2917 = (2u * (_e2914 + _e2678.member_1[0]));
                        stack[_e2917] = _e2334.member[0];
                        stack[(_e2917 + 1u)] = _e2334.member[1];
                    } else {
                        let _e2898 = atomicLoad((&shared_[11u]));
                        let _e2901 = ((_e2898 + _e2678.member_1[0]) - _e2894);
                        if (_e2901 < _e92.member_3) {
                            let _e2904 = (_e104 + _e2901);
                            if (_e2904 < 4294967295u) {
                                let _e2908 = (2u * _e2904);
                                atomicStore((&nodes.member[(4u + _e2908)]), _e2334.member[0]);
                                atomicStore((&nodes.member[(_e2908 + 5u)]), _e2334.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e2334.member_1 == 0u) {
                    } else {
                        if (_e2334.member_1 == 2u) {
                            let _e2843 = a.member[_e2334.member[0]];
                            let _e2847 = b.member[_e2334.member[1]];
                            let _e2851 = params.member.member_2.member;
                            if (_e2851 == 1u) {
                                let _e2854 = (_e2843.member_1 < _e2847.member_1);
                                phi_4640_ = type_9(select(_e2847.member_1, _e2843.member_1, _e2854), select(_e2843.member_1, _e2847.member_1, _e2854));
                            } else {
                                phi_4640_ = type_9(_e2843.member_1, _e2847.member_1);
                            }
                            let _e2859 = phi_4640_;
                            let _e2863 = params.member.member_1;
                            let _e2866 = atomicLoad((&shared_[12u]));
                            let _e2868 = (_e2866 + _e2678.member_1[0]);
                            if (_e2868 < _e2863.member_3) {
                                let _e2870 = (2u * _e2868);
                                atomicStore((&pairs.member[(4u + _e2870)]), _e2859.member);
                                atomicStore((&pairs.member[(_e2870 + 5u)]), _e2859.member_1);
                            }
                        }
                        if (_e92.member_4 > 0u) {
                            let _e2878 = atomicLoad((&shared_[13u]));
                            let _e2880 = (_e2878 + _e2678.member_1[1]);
                            if (_e2880 < _e92.member_4) {
                                let _e2887 = (2u * ((_e92.member_5 * _e92.member_4) + _e2880));
                                front.member[_e2887] = _e2334.member[0];
                                front.member[(_e2887 + 1u)] = _e2334.member[1];
                            }
                        }
                    }
                }
                if (_e2332.member_1 == 1u) {
                    let _e2984 = atomicLoad((&shared_[10u]));
                    if (_e2678.member_2[0] < _e2984) {
                        let _e3004 = atomicLoad((&shared_[9u]));
                        let _e3007 = (2u * (_e3004 + _e2678.member_2[0]));
                        stack[_e3007] = _e2332.member[0];
                        stack[(_e3007 + 1u)] = _e2332.member[1];
                    } else {
                        let _e2988 = atomicLoad((&shared_[11u]));
                        let _e2991 = ((_e2988 + _e2678.member_2[0]) - _e2984);
                        if (_e2991 < _e92.member_3) {
                            let _e2994 = (_e104 + _e2991);
                            if (_e2994 < 4294967295u) {
                                let _e2998 = (2u * _e2994);
                                atomicStore((&nodes.member[(4u + _e2998)]), _e2332.member[0]);
                                atomicStore((&nodes.member[(_e2998 + 5u)]), _e2332.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e2332.member_1 == 0u) {
                    } else {
                        if (_e2332.member_1 == 2u) {
                            let _e2933 = a.member[_e2332.member[0]];
                            let _e2937 = b.member[_e2332.member[1]];
                            let _e2941 = params.member.member_2.member;
                            if (_e2941 == 1u) {
                                let _e2944 = (_e2933.member_1 < _e2937.member_1);
                                phi_4804_ = type_9(select(_e2937.member_1, _e2933.member_1, _e2944), select(_e2933.member_1, _e2937.member_1, _e2944));
                            } else {
                                phi_4804_ = type_9(_e2933.member_1, _e2937.member_1);
                            }
                            let _e2949 = phi_4804_;
                            let _e2953 = params.member.member_1;
                            let _e2956 = atomicLoad((&shared_[12u]));
                            let _e2958 = (_e2956 + _e2678.member_2[0]);
                            if (_e2958 < _e2953.member_3) {
                                let _e2960 = (2u * _e2958);
                                atomicStore((&pairs.member[(4u + _e2960)]), _e2949.member);
                                atomicStore((&pairs.member[(_e2960 + 5u)]), _e2949.member_1);
                            }
                        }
                        if (_e92.member_4 > 0u) {
                            let _e2968 = atomicLoad((&shared_[13u]));
                            let _e2970 = (_e2968 + _e2678.member_2[1]);
                            if (_e2970 < _e92.member_4) {
                                let _e2977 = (2u * ((_e92.member_5 * _e92.member_4) + _e2970));
                                front.member[_e2977] = _e2332.member[0];
                                front.member[(_e2977 + 1u)] = _e2332.member[1];
                            }
                        }
                    }
                }
                if (_e2330.member_1 == 1u) {
                    let _e3074 = atomicLoad((&shared_[10u]));
                    if (_e2678.member_3[0] < _e3074) {
                        let _e3094 = atomicLoad((&shared_[9u]));
                        let _e3097 = (2u * (_e3094 + _e2678.member_3[0]));
                        stack[_e3097] = _e2330.member[0];
                        stack[(_e3097 + 1u)] = _e2330.member[1];
                    } else {
                        let _e3078 = atomicLoad((&shared_[11u]));
                        let _e3081 = ((_e3078 + _e2678.member_3[0]) - _e3074);
                        if (_e3081 < _e92.member_3) {
                            let _e3084 = (_e104 + _e3081);
                            if (_e3084 < 4294967295u) {
                                let _e3088 = (2u * _e3084);
                                atomicStore((&nodes.member[(4u + _e3088)]), _e2330.member[0]);
                                atomicStore((&nodes.member[(_e3088 + 5u)]), _e2330.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e2330.member_1 == 0u) {
                    } else {
                        if (_e2330.member_1 == 2u) {
                            let _e3023 = a.member[_e2330.member[0]];
                            let _e3027 = b.member[_e2330.member[1]];
                            let _e3031 = params.member.member_2.member;
                            if (_e3031 == 1u) {
                                let _e3034 = (_e3023.member_1 < _e3027.member_1);
                                phi_4968_ = type_9(select(_e3027.member_1, _e3023.member_1, _e3034), select(_e3023.member_1, _e3027.member_1, _e3034));
                            } else {
                                phi_4968_ = type_9(_e3023.member_1, _e3027.member_1);
                            }
                            let _e3039 = phi_4968_;
                            let _e3043 = params.member.member_1;
                            let _e3046 = atomicLoad((&shared_[12u]));
                            let _e3048 = (_e3046 + _e2678.member_3[0]);
                            if (_e3048 < _e3043.member_3) {
                                let _e3050 = (2u * _e3048);
                                atomicStore((&pairs.member[(4u + _e3050)]), _e3039.member);
                                atomicStore((&pairs.member[(_e3050 + 5u)]), _e3039.member_1);
                            }
                        }
                        if (_e92.member_4 > 0u) {
                            let _e3058 = atomicLoad((&shared_[13u]));
                            let _e3060 = (_e3058 + _e2678.member_3[1]);
                            if (_e3060 < _e92.member_4) {
                                let _e3067 = (2u * ((_e92.member_5 * _e92.member_4) + _e3060));
                                front.member[_e3067] = _e2330.member[0];
                                front.member[(_e3067 + 1u)] = _e2330.member[1];
                            }
                        }
                    }
                }
                phi_5021_ = true;
            }
            let _e3104 = phi_5021_;
            phi_5022_ = _e3104;
        } else {
            phi_5022_ = false;
        }
        let _e3106 = phi_5022_;
        continue;
        continuing {
            phi_254_ = type_9(select(_e113.member, (_e113.member + 1u), _e116), select(_e113.member_1, _e113.member_1, _e116));
            break if !(_e3106);
        }
    }
    if (_e77 == 0u) {
        if (_e92.member_6 == 0u) {
            let _e3121 = atomicLoad((&shared_[5u]));
            phi_5050_ = (select(0u, ((((_e101 - 1u) - _e90) >> bitcast<u32>((_e92.member_7 & 31u))) + 1u), (_e90 < _e101)) - _e3121);
        } else {
            phi_5050_ = 0u;
        }
        let _e3124 = phi_5050_;
        atomicStore((&shared_[14u]), _e3124);
        let _e3127 = atomicLoad((&shared_[0u]));
        let _e3128 = (_e3127 + _e3124);
        if (_e92.member_6 == 2u) {
            let _e3155 = (((_e101 + (1u << bitcast<u32>((_e92.member_7 & 31u)))) - 1u) >> bitcast<u32>((_e92.member_7 & 31u)));
            let _e3156 = (_e90 * _e3155);
            let _e3159 = (_e101 - select(_e3156, _e101, (_e101 < _e3156)));
            let _e3168 = ((1540u + (2u * (1u << bitcast<u32>((_e92.member_7 & 31u))))) + (2u * _e90));
            let _e3170 = atomicLoad((&shared_[0u]));
            atomicStore((&control.member[_e3168]), _e3170);
            let _e3174 = atomicLoad((&shared_[5u]));
            atomicStore((&control.member[(_e3168 + 1u)]), (select(_e3155, _e3159, (_e3159 < _e3155)) - _e3174));
        } else {
            if (_e3128 > 0u) {
                if (_e92.member_13 == 0u) {
                } else {
                    let _e3135 = atomicMax((&control.member[1536u]), 4294967295u);
                }
                let _e3138 = atomicAdd((&control.member[(_e94.member_1 + 1u)]), _e3128);
                let _e3141 = atomicMax((&nodes.member[0u]), (_e3138 + _e3128));
                if ((_e3138 + _e3128) < _e3138) {
                    let _e3145 = atomicAdd((&nodes.member[2u]), 1u);
                }
                atomicStore((&shared_[17u]), _e3138);
            }
        }
        let _e3180 = atomicLoad((&shared_[15u]));
        let _e3182 = atomicAdd((&control.member[(1540u + (2u * _e90))]), _e3180);
        let _e3186 = atomicLoad((&shared_[16u]));
        let _e3188 = atomicAdd((&control.member[((2u * _e90) + 1541u)]), _e3186);
    }
    workgroupBarrier();
    let _e3190 = atomicLoad((&shared_[0u]));
    let _e3192 = atomicLoad((&shared_[17u]));
    let _e3194 = atomicLoad((&shared_[14u]));
    phi_5170_ = type_9(0u, 8u);
    loop {
        let _e3196 = phi_5170_;
        let _e3199 = (_e3196.member < _e3196.member_1);
        let _e3212 = (bitcast<i32>(select(0u, 1u, _e3199)) != 0i);
        if _e3212 {
            let _e3214 = ((select(type_9().member_1, _e3196.member, _e3199) * 128u) + _e77);
            if (_e3214 < _e3190) {
                let _e3218 = stack[(2u * _e3214)];
                let _e3222 = stack[((2u * _e3214) + 1u)];
                if (_e92.member_6 == 2u) {
                    let _e3254 = ((((((1540u + (2u * (1u << bitcast<u32>((_e92.member_7 & 31u))))) + (2u * (1u << bitcast<u32>((_e92.member_7 & 31u))))) + (1u << bitcast<u32>((_e92.member_7 & 31u)))) + 1u) + (_e90 * 2048u)) + (2u * _e3214));
                    atomicStore((&control.member[_e3254]), _e3218);
                    atomicStore((&control.member[(_e3254 + 1u)]), _e3222);
                } else {
                    let _e3225 = (_e3192 + _e3214);
                    if (_e3225 < _e92.member_3) {
                        let _e3228 = (_e104 + _e3225);
                        if (_e3228 < 4294967295u) {
                            let _e3230 = (2u * _e3228);
                            atomicStore((&nodes.member[(4u + _e3230)]), _e3218);
                            atomicStore((&nodes.member[(_e3230 + 5u)]), _e3222);
                        }
                    }
                }
            }
        }
        continue;
        continuing {
            phi_5170_ = type_9(select(_e3196.member, (_e3196.member + 1u), _e3199), select(_e3196.member_1, _e3196.member_1, _e3199));
            break if !(_e3212);
        }
    }
    let _e3260 = atomicLoad((&shared_[5u]));
    let _e3261 = (_e3194 / 128u);
    phi_5288_ = type_9(0u, select(_e3261, (_e3261 + 1u), ((_e3194 % 128u) > 0u)));
    loop {
        let _e3268 = phi_5288_;
        let _e3271 = (_e3268.member < _e3268.member_1);
        let _e3284 = (bitcast<i32>(select(0u, 1u, _e3271)) != 0i);
        if _e3284 {
            let _e3286 = ((select(type_9().member_1, _e3268.member, _e3271) * 128u) + _e77);
            if (_e3286 < _e3194) {
                let _e3295 = (2u * ((_e102 + _e90) + ((_e3260 + _e3286) << bitcast<u32>((_e92.member_7 & 31u)))));
                let _e3298 = atomicLoad((&nodes.member[(4u + _e3295)]));
                let _e3301 = atomicLoad((&nodes.member[(_e3295 + 5u)]));
                let _e3303 = ((_e3192 + _e3190) + _e3286);
                if (_e3303 < _e92.member_3) {
                    let _e3306 = (_e104 + _e3303);
                    if (_e3306 < 4294967295u) {
                        let _e3308 = (2u * _e3306);
                        atomicStore((&nodes.member[(4u + _e3308)]), _e3298);
                        atomicStore((&nodes.member[(_e3308 + 5u)]), _e3301);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_5288_ = type_9(select(_e3268.member, (_e3268.member + 1u), _e3271), select(_e3268.member_1, _e3268.member_1, _e3271));
            break if !(_e3284);
        }
    }
    if (_e92.member_6 == 1u) {
        if (_e3260 == 0u) {
            phi_5393_ = type_9(0u, _e101);
            loop {
                let _e3319 = phi_5393_;
                let _e3322 = (_e3319.member < _e3319.member_1);
                if (bitcast<i32>(select(0u, 1u, _e3322)) != 0i) {
                    let _e3336 = atomicAdd((&control.member[(512u + _e94.member_1)]), 1u);
                    if (_e3336 >= _e101) {
                        phi_5509_ = false;
                    } else {
                        let _e3339 = (2u * (_e102 + _e3336));
                        let _e3342 = atomicLoad((&nodes.member[(4u + _e3339)]));
                        let _e3345 = atomicLoad((&nodes.member[(_e3339 + 5u)]));
                        if (_e92.member_13 == 0u) {
                        } else {
                            let _e3349 = atomicMax((&control.member[1536u]), 4294967295u);
                        }
                        let _e3352 = atomicAdd((&control.member[(_e94.member_1 + 1u)]), 1u);
                        let _e3355 = atomicMax((&nodes.member[0u]), (_e3352 + 1u));
                        if ((_e3352 + 1u) < _e3352) {
                            let _e3359 = atomicAdd((&nodes.member[2u]), 1u);
                        }
                        if (_e3352 < _e92.member_3) {
                            let _e3362 = (_e104 + _e3352);
                            if (_e3362 < 4294967295u) {
                                let _e3364 = (2u * _e3362);
                                atomicStore((&nodes.member[(4u + _e3364)]), _e3342);
                                atomicStore((&nodes.member[(_e3364 + 5u)]), _e3345);
                            }
                        }
                        phi_5509_ = true;
                    }
                    let _e3370 = phi_5509_;
                    phi_5510_ = _e3370;
                } else {
                    phi_5510_ = false;
                }
                let _e3372 = phi_5510_;
                continue;
                continuing {
                    phi_5393_ = type_9(select(_e3319.member, (_e3319.member + 1u), _e3322), select(_e3319.member_1, _e3319.member_1, _e3322));
                    break if !(_e3372);
                }
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn pair_workers_oriented(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}

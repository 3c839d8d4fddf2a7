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

struct type_15 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
}

struct type_17 {
    member: array<type_15>,
}

struct type_18 {
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

struct type_19 {
    member: type_7,
    member_1: type_8,
    member_2: type_18,
}

struct type_20 {
    member: type_19,
}

struct type_22 {
    member: array<array<u32, 2>, 4>,
    member_1: array<array<u32, 2>, 4>,
}

struct type_24 {
    member: array<array<f32, 3>, 3>,
    member_1: array<f32, 3>,
    member_2: array<f32, 3>,
    member_3: array<f32, 3>,
    member_4: array<f32, 3>,
    member_5: f32,
}

struct type_26 {
    member: vec4<f32>,
    member_1: vec4<f32>,
    member_2: vec4<f32>,
    member_3: vec4<f32>,
}

struct type_28 {
    member: array<type_26>,
}

struct type_29 {
    member: array<f32, 3>,
    member_1: array<array<f32, 3>, 3>,
    member_2: array<f32, 3>,
}

struct type_32 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_20;
@group(0) @binding(1) 
var<storage> a_nodes: type_17;
@group(0) @binding(2) 
var<storage> b_nodes: type_17;
@group(0) @binding(3) 
var<storage> oriented: type_28;
@group(0) @binding(4) 
var<storage> input: type_11;
@group(0) @binding(6) 
var<storage, read_write> output: type_32;
@group(0) @binding(7) 
var<storage, read_write> pairs: type_32;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(5) 
var<storage, read_write> levels: type_32;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_24;
    var local_1: array<array<u32, 2>, 4>;
    var phi_220_: type_9;
    var phi_422_: type_22;
    var phi_423_: type_22;
    var phi_424_: bool;
    var phi_425_: type_22;
    var phi_426_: bool;
    var phi_486_: bool;
    var phi_487_: bool;
    var phi_488_: bool;
    var phi_489_: bool;
    var phi_490_: bool;
    var phi_491_: bool;
    var phi_686_: type_22;
    var phi_687_: bool;
    var phi_688_: type_22;
    var phi_689_: bool;
    var phi_896_: type_22;
    var phi_897_: type_22;
    var phi_898_: type_22;
    var phi_899_: bool;
    var phi_900_: type_22;
    var phi_901_: type_22;
    var phi_902_: bool;
    var phi_906_: type_22;
    var phi_1000_: type_9;
    var phi_1213_: type_29;
    var phi_1357_: type_29;
    var phi_3258_: bool;
    var phi_3260_: bool;
    var phi_3261_: bool;
    var phi_3262_: bool;
    var phi_3263_: bool;
    var phi_3324_: array<u32, 2>;
    var phi_3325_: array<u32, 2>;
    var phi_3326_: array<u32, 2>;
    var phi_3327_: array<u32, 2>;
    var phi_3361_: u32;
    var phi_3395_: u32;
    var phi_3429_: u32;
    var phi_3463_: u32;
    var phi_3614_: type_9;
    var phi_3728_: type_9;
    var phi_3842_: type_9;
    var phi_3956_: type_9;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e42 = id_2;
    let _e43 = n_2;
    let _e44 = lane_2;
    let _e60 = (_e43.x * _e43.y);
    let _e63 = params.member.member_1.member_1;
    let _e66 = params.member.member_2.member;
    let _e67 = (_e66 == 0u);
    let _e73 = params.member.member.member[select(1u, 0u, _e67)];
    let _e74 = (_e73 - 1u);
    let _e78 = params.member.member.member[select(1u, 2u, _e67)];
    let _e79 = (_e78 - 1u);
    let _e81 = atomicLoad((&levels.member[_e63]));
    let _e84 = params.member.member_1.member_2;
    let _e89 = params.member.member_1.member_2;
    let _e90 = (_e60 * 128u);
    if (_e90 == 0u) {
        return;
    }
    let _e92 = (_e89 / _e90);
    if (_e90 == 0u) {
        return;
    }
    phi_220_ = type_9(0u, select(_e92, (_e92 + 1u), ((_e89 % _e90) > 0u)));
    loop {
        let _e100 = phi_220_;
        let _e103 = (_e100.member < _e100.member_1);
        let _e116 = (bitcast<i32>(select(0u, 1u, _e103)) != 0i);
        if _e116 {
            let _e120 = (((((_e42.y * _e43.x) + _e42.x) + (select(type_9().member_1, _e100.member, _e103) * _e60)) * 128u) + _e44);
            if (_e44 == 0u) {
                atomicStore((&counters[0u]), 0u);
                atomicStore((&counters[1u]), 0u);
            }
            workgroupBarrier();
            if (_e120 < select(_e81, _e84, (_e84 < _e81))) {
                let _e125 = (2u * _e120);
                let _e128 = input.member[(4u + _e125)];
                let _e131 = input.member[(_e125 + 5u)];
                let _e134 = params.member.member_2.member_1;
                let _e139 = params.member.member_2.member;
                let _e142 = a_nodes.member[_e128];
                let _e144 = b_nodes.member[_e131];
                if (_e139 == 1u) {
                    if (_e128 == _e131) {
                        if (_e142.member_3 == 4294967295u) {
                            phi_422_ = type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)));
                        } else {
                            let _e150 = a_nodes.member[_e142.member_1];
                            let _e153 = a_nodes.member[_e142.member_3];
                            let _e156 = !((_e150.member_3 == 4294967295u));
                            let _e167 = type_22(array<array<u32, 2>, 4>(array<u32, 2>(select(4294967295u, _e142.member_1, _e156), select(4294967295u, _e142.member_1, _e156)), type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[1], type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[2], type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[3]), type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1);
                            let _e179 = type_22(array<array<u32, 2>, 4>(_e167.member[0], array<u32, 2>(_e142.member_1, _e167.member[1][1]), _e167.member[2], _e167.member[3]), _e167.member_1);
                            let _e187 = type_22(array<array<u32, 2>, 4>(_e179.member[0], array<u32, 2>(_e142.member_1, _e142.member_3), _e179.member[2], _e179.member[3]), _e179.member_1);
                            let _e190 = !((_e153.member_3 == 4294967295u));
                            let _e201 = type_22(array<array<u32, 2>, 4>(_e187.member[0], _e187.member[1], array<u32, 2>(select(4294967295u, _e142.member_3, _e190), select(4294967295u, _e142.member_3, _e190)), _e187.member[3]), _e187.member_1);
                            let _e204 = type_22(_e201.member, _e201.member);
                            let _e231 = ((((((_e150.member[0] <= _e153.member_2[0]) && (_e153.member[0] <= _e150.member_2[0])) && (_e150.member[1] <= _e153.member_2[1])) && (_e153.member[1] <= _e150.member_2[1])) && (_e150.member[2] <= _e153.member_2[2])) && (_e153.member[2] <= _e150.member_2[2]));
                            phi_422_ = type_22(_e204.member, array<array<u32, 2>, 4>(_e204.member_1[0], array<u32, 2>(select(4294967295u, _e142.member_1, _e231), select(4294967295u, _e142.member_3, _e231)), _e204.member_1[2], _e204.member_1[3]));
                        }
                        let _e243 = phi_422_;
                        phi_423_ = _e243;
                        phi_424_ = false;
                    } else {
                        phi_423_ = type_22();
                        phi_424_ = true;
                    }
                    let _e245 = phi_423_;
                    let _e247 = phi_424_;
                    phi_425_ = _e245;
                    phi_426_ = _e247;
                } else {
                    phi_425_ = type_22();
                    phi_426_ = true;
                }
                let _e249 = phi_425_;
                let _e251 = phi_426_;
                if _e251 {
                    let _e254 = !((_e142.member_3 == 4294967295u));
                    let _e257 = !((_e144.member_3 == 4294967295u));
                    if select(_e257, true, _e254) {
                        if _e254 {
                            if _e257 {
                                if (select(0u, 1u, (_e134 == 0u)) == 0u) {
                                    let _e286 = ((((_e144.member_2[0] - _e144.member[0]) * (_e144.member_2[1] - _e144.member[1])) * (_e144.member_2[2] - _e144.member[2])) > (((_e142.member_2[0] - _e142.member[0]) * (_e142.member_2[1] - _e142.member[1])) * (_e142.member_2[2] - _e142.member[2])));
                                    phi_486_ = _e286;
                                    phi_487_ = !(_e286);
                                } else {
                                    phi_486_ = _e257;
                                    phi_487_ = _e254;
                                }
                                let _e289 = phi_486_;
                                let _e291 = phi_487_;
                                phi_488_ = _e289;
                                phi_489_ = _e291;
                            } else {
                                phi_488_ = _e257;
                                phi_489_ = _e254;
                            }
                            let _e293 = phi_488_;
                            let _e295 = phi_489_;
                            phi_490_ = _e293;
                            phi_491_ = _e295;
                        } else {
                            phi_490_ = _e257;
                            phi_491_ = _e254;
                        }
                        let _e297 = phi_490_;
                        let _e299 = phi_491_;
                        if _e299 {
                            if _e297 {
                                let _e302 = a_nodes.member[_e142.member_1];
                                let _e307 = a_nodes.member[_e142.member_3];
                                let _e312 = b_nodes.member[_e144.member_1];
                                let _e317 = b_nodes.member[_e144.member_3];
                                let _e355 = ((((((_e302.member[0] <= _e312.member_2[0]) && (_e312.member[0] <= _e302.member_2[0])) && (_e302.member[1] <= _e312.member_2[1])) && (_e312.member[1] <= _e302.member_2[1])) && (_e302.member[2] <= _e312.member_2[2])) && (_e312.member[2] <= _e302.member_2[2]));
                                let _e381 = ((((((_e302.member[0] <= _e317.member_2[0]) && (_e317.member[0] <= _e302.member_2[0])) && (_e302.member[1] <= _e317.member_2[1])) && (_e317.member[1] <= _e302.member_2[1])) && (_e302.member[2] <= _e317.member_2[2])) && (_e317.member[2] <= _e302.member_2[2]));
                                let _e407 = ((((((_e307.member[0] <= _e312.member_2[0]) && (_e312.member[0] <= _e307.member_2[0])) && (_e307.member[1] <= _e312.member_2[1])) && (_e312.member[1] <= _e307.member_2[1])) && (_e307.member[2] <= _e312.member_2[2])) && (_e312.member[2] <= _e307.member_2[2]));
                                let _e433 = ((((((_e307.member[0] <= _e317.member_2[0]) && (_e317.member[0] <= _e307.member_2[0])) && (_e307.member[1] <= _e317.member_2[1])) && (_e317.member[1] <= _e307.member_2[1])) && (_e307.member[2] <= _e317.member_2[2])) && (_e317.member[2] <= _e307.member_2[2]));
                                phi_686_ = type_22(array<array<u32, 2>, 4>(array<u32, 2>(_e142.member_1, _e144.member_1), array<u32, 2>(_e142.member_1, _e144.member_3), array<u32, 2>(_e142.member_3, _e144.member_1), array<u32, 2>(_e142.member_3, _e144.member_3)), array<array<u32, 2>, 4>(array<u32, 2>(select(4294967295u, _e142.member_1, _e355), select(4294967295u, _e144.member_1, _e355)), array<u32, 2>(select(4294967295u, _e142.member_1, _e381), select(4294967295u, _e144.member_3, _e381)), array<u32, 2>(select(4294967295u, _e142.member_3, _e407), select(4294967295u, _e144.member_1, _e407)), array<u32, 2>(select(4294967295u, _e142.member_3, _e433), select(4294967295u, _e144.member_3, _e433))));
                                phi_687_ = false;
                            } else {
                                phi_686_ = type_22();
                                phi_687_ = true;
                            }
                            let _e440 = phi_686_;
                            let _e442 = phi_687_;
                            phi_688_ = _e440;
                            phi_689_ = _e442;
                        } else {
                            phi_688_ = type_22();
                            phi_689_ = true;
                        }
                        let _e444 = phi_688_;
                        let _e446 = phi_689_;
                        if _e446 {
                            if _e299 {
                                let _e531 = a_nodes.member[_e142.member_1];
                                let _e536 = a_nodes.member[_e142.member_3];
                                let _e565 = ((((((_e531.member[0] <= _e144.member_2[0]) && (_e144.member[0] <= _e531.member_2[0])) && (_e531.member[1] <= _e144.member_2[1])) && (_e144.member[1] <= _e531.member_2[1])) && (_e531.member[2] <= _e144.member_2[2])) && (_e144.member[2] <= _e531.member_2[2]));
                                let _e575 = type_22(type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member, array<array<u32, 2>, 4>(array<u32, 2>(select(4294967295u, _e142.member_1, _e565), select(4294967295u, _e131, _e565)), type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[1], type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[2], type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[3]));
                                let _e600 = ((((((_e536.member[0] <= _e144.member_2[0]) && (_e144.member[0] <= _e536.member_2[0])) && (_e536.member[1] <= _e144.member_2[1])) && (_e144.member[1] <= _e536.member_2[1])) && (_e536.member[2] <= _e144.member_2[2])) && (_e144.member[2] <= _e536.member_2[2]));
                                phi_896_ = type_22(_e575.member, array<array<u32, 2>, 4>(_e575.member_1[0], array<u32, 2>(select(4294967295u, _e142.member_3, _e600), select(4294967295u, _e131, _e600)), _e575.member_1[2], _e575.member_1[3]));
                            } else {
                                let _e449 = b_nodes.member[_e144.member_1];
                                let _e454 = b_nodes.member[_e144.member_3];
                                let _e483 = ((((((_e142.member[0] <= _e449.member_2[0]) && (_e449.member[0] <= _e142.member_2[0])) && (_e142.member[1] <= _e449.member_2[1])) && (_e449.member[1] <= _e142.member_2[1])) && (_e142.member[2] <= _e449.member_2[2])) && (_e449.member[2] <= _e142.member_2[2]));
                                let _e493 = type_22(type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member, array<array<u32, 2>, 4>(array<u32, 2>(select(4294967295u, _e128, _e483), select(4294967295u, _e144.member_1, _e483)), type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[1], type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[2], type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[3]));
                                let _e518 = ((((((_e142.member[0] <= _e454.member_2[0]) && (_e454.member[0] <= _e142.member_2[0])) && (_e142.member[1] <= _e454.member_2[1])) && (_e454.member[1] <= _e142.member_2[1])) && (_e142.member[2] <= _e454.member_2[2])) && (_e454.member[2] <= _e142.member_2[2]));
                                phi_896_ = type_22(_e493.member, array<array<u32, 2>, 4>(_e493.member_1[0], array<u32, 2>(select(4294967295u, _e128, _e518), select(4294967295u, _e144.member_3, _e518)), _e493.member_1[2], _e493.member_1[3]));
                            }
                            let _e612 = phi_896_;
                            phi_897_ = _e612;
                        } else {
                            phi_897_ = _e444;
                        }
                        let _e614 = phi_897_;
                        phi_898_ = _e614;
                        phi_899_ = false;
                    } else {
                        phi_898_ = type_22();
                        phi_899_ = true;
                    }
                    let _e616 = phi_898_;
                    let _e618 = phi_899_;
                    phi_900_ = _e616;
                    phi_901_ = type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)));
                    phi_902_ = _e618;
                } else {
                    phi_900_ = type_22();
                    phi_901_ = _e249;
                    phi_902_ = true;
                }
                let _e620 = phi_900_;
                let _e622 = phi_901_;
                let _e624 = phi_902_;
                if _e624 {
                    phi_906_ = _e622;
                } else {
                    phi_906_ = _e620;
                }
                let _e626 = phi_906_;
                let _e630 = params.member.member_2.member;
                let _e631 = (_e630 == 0u);
                let _e637 = params.member.member.member[select(1u, 0u, _e631)];
                let _e638 = (_e637 - 1u);
                let _e642 = params.member.member.member[select(1u, 2u, _e631)];
                let _e643 = (_e642 - 1u);
                let _e646 = params.member.member_2.member;
                let _e647 = (_e646 == 0u);
                let _e653 = params.member.member.member_2[select(1u, 0u, _e647)];
                let _e657 = params.member.member.member_2[select(1u, 2u, _e647)];
                let _e660 = params.member.member_2.member;
                local_1 = array<array<u32, 2>, 4>(array<u32, 2>(_e626.member_1[0][0], _e626.member_1[0][1]), array<u32, 2>(_e626.member_1[1][0], _e626.member_1[1][1]), array<u32, 2>(_e626.member_1[2][0], _e626.member_1[2][1]), array<u32, 2>(_e626.member_1[3][0], _e626.member_1[3][1]));
                phi_1000_ = type_9(0u, 4u);
                loop {
                    let _e680 = phi_1000_;
                    let _e683 = (_e680.member < _e680.member_1);
                    let _e694 = select(type_9().member_1, _e680.member, _e683);
                    let _e696 = (bitcast<i32>(select(0u, 1u, _e683)) != 0i);
                    if _e696 {
                        let _e698 = local_1[_e694];
                        if (_e698[0] != 4294967295u) {
                            if select(false, (_e698[0] == _e698[1]), (_e660 == 1u)) {
                                phi_3262_ = bool();
                                phi_3263_ = true;
                            } else {
                                if select(true, select(true, false, (_e698[1] >= _e643)), (_e698[0] >= _e638)) {
                                    if (_e698[0] < _e638) {
                                        let _e778 = oriented.member[(_e653 + _e698[0])];
                                        phi_1213_ = type_29(array<f32, 3>(_e778.member.x, _e778.member.y, _e778.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e778.member.w, _e778.member_1.x, _e778.member_1.y), array<f32, 3>(_e778.member_1.z, _e778.member_1.w, _e778.member_2.x), array<f32, 3>(_e778.member_2.y, _e778.member_2.z, _e778.member_2.w)), array<f32, 3>(_e778.member_3.x, _e778.member_3.y, _e778.member_3.z));
                                    } else {
                                        let _e710 = a_nodes.member[_e698[0]];
                                        let _e725 = ((_e710.member[0] * 0.5f) + (_e710.member_2[0] * 0.5f));
                                        let _e726 = ((_e710.member[1] * 0.5f) + (_e710.member_2[1] * 0.5f));
                                        let _e727 = ((_e710.member[2] * 0.5f) + (_e710.member_2[2] * 0.5f));
                                        let _e730 = select(_e710.member_2[0], _e725, (_e725 < _e710.member_2[0]));
                                        let _e733 = select(_e710.member_2[1], _e726, (_e726 < _e710.member_2[1]));
                                        let _e736 = select(_e710.member_2[2], _e727, (_e727 < _e710.member_2[2]));
                                        let _e739 = select(_e710.member[0], _e730, (_e730 > _e710.member[0]));
                                        let _e742 = select(_e710.member[1], _e733, (_e733 > _e710.member[1]));
                                        let _e745 = select(_e710.member[2], _e736, (_e736 > _e710.member[2]));
                                        let _e748 = (_e710.member_2[0] - _e739);
                                        let _e750 = (_e710.member_2[1] - _e742);
                                        let _e752 = (_e710.member_2[2] - _e745);
                                        let _e754 = (_e739 - _e710.member[0]);
                                        let _e756 = (_e742 - _e710.member[1]);
                                        let _e758 = (_e745 - _e710.member[2]);
                                        let _e766 = (1f + (0.000000059604645f * 4f));
                                        let _e770 = (0.000000000000000000000000000000000000011754944f * 8f);
                                        phi_1213_ = type_29(array<f32, 3>(_e739, _e742, _e745), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((select(_e754, _e748, (_e748 > _e754)) * _e766) + _e770), ((select(_e756, _e750, (_e750 > _e756)) * _e766) + _e770), ((select(_e758, _e752, (_e752 > _e758)) * _e766) + _e770)));
                                    }
                                    let _e817 = phi_1213_;
                                    if (_e698[1] < _e643) {
                                        let _e888 = oriented.member[(_e657 + _e698[1])];
                                        phi_1357_ = type_29(array<f32, 3>(_e888.member.x, _e888.member.y, _e888.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e888.member.w, _e888.member_1.x, _e888.member_1.y), array<f32, 3>(_e888.member_1.z, _e888.member_1.w, _e888.member_2.x), array<f32, 3>(_e888.member_2.y, _e888.member_2.z, _e888.member_2.w)), array<f32, 3>(_e888.member_3.x, _e888.member_3.y, _e888.member_3.z));
                                    } else {
                                        let _e820 = b_nodes.member[_e698[1]];
                                        let _e835 = ((_e820.member[0] * 0.5f) + (_e820.member_2[0] * 0.5f));
                                        let _e836 = ((_e820.member[1] * 0.5f) + (_e820.member_2[1] * 0.5f));
                                        let _e837 = ((_e820.member[2] * 0.5f) + (_e820.member_2[2] * 0.5f));
                                        let _e840 = select(_e820.member_2[0], _e835, (_e835 < _e820.member_2[0]));
                                        let _e843 = select(_e820.member_2[1], _e836, (_e836 < _e820.member_2[1]));
                                        let _e846 = select(_e820.member_2[2], _e837, (_e837 < _e820.member_2[2]));
                                        let _e849 = select(_e820.member[0], _e840, (_e840 > _e820.member[0]));
                                        let _e852 = select(_e820.member[1], _e843, (_e843 > _e820.member[1]));
                                        let _e855 = select(_e820.member[2], _e846, (_e846 > _e820.member[2]));
                                        let _e858 = (_e820.member_2[0] - _e849);
                                        let _e860 = (_e820.member_2[1] - _e852);
                                        let _e862 = (_e820.member_2[2] - _e855);
                                        let _e864 = (_e849 - _e820.member[0]);
                                        let _e866 = (_e852 - _e820.member[1]);
                                        let _e868 = (_e855 - _e820.member[2]);
                                        let _e876 = (1f + (0.000000059604645f * 4f));
                                        let _e880 = (0.000000000000000000000000000000000000011754944f * 8f);
                                        phi_1357_ = type_29(array<f32, 3>(_e849, _e852, _e855), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((select(_e864, _e858, (_e858 > _e864)) * _e876) + _e880), ((select(_e866, _e860, (_e860 > _e866)) * _e876) + _e880), ((select(_e868, _e862, (_e862 > _e868)) * _e876) + _e880)));
                                    }
                                    let _e927 = phi_1357_;
                                    let _e932 = (_e927.member[0] - _e817.member[0]);
                                    let _e935 = (_e927.member[1] - _e817.member[1]);
                                    let _e938 = (_e927.member[2] - _e817.member[2]);
                                    local = type_24(array<array<f32, 3>, 3>(array<f32, 3>((((_e927.member_1[0][0] * _e817.member_1[0][0]) + (_e927.member_1[0][1] * _e817.member_1[0][1])) + (_e927.member_1[0][2] * _e817.member_1[0][2])), (((_e927.member_1[1][0] * _e817.member_1[0][0]) + (_e927.member_1[1][1] * _e817.member_1[0][1])) + (_e927.member_1[1][2] * _e817.member_1[0][2])), (((_e927.member_1[2][0] * _e817.member_1[0][0]) + (_e927.member_1[2][1] * _e817.member_1[0][1])) + (_e927.member_1[2][2] * _e817.member_1[0][2]))), array<f32, 3>((((_e927.member_1[0][0] * _e817.member_1[1][0]) + (_e927.member_1[0][1] * _e817.member_1[1][1])) + (_e927.member_1[0][2] * _e817.member_1[1][2])), (((_e927.member_1[1][0] * _e817.member_1[1][0]) + (_e927.member_1[1][1] * _e817.member_1[1][1])) + (_e927.member_1[1][2] * _e817.member_1[1][2])), (((_e927.member_1[2][0] * _e817.member_1[1][0]) + (_e927.member_1[2][1] * _e817.member_1[1][1])) + (_e927.member_1[2][2] * _e817.member_1[1][2]))), array<f32, 3>((((_e927.member_1[0][0] * _e817.member_1[2][0]) + (_e927.member_1[0][1] * _e817.member_1[2][1])) + (_e927.member_1[0][2] * _e817.member_1[2][2])), (((_e927.member_1[1][0] * _e817.member_1[2][0]) + (_e927.member_1[1][1] * _e817.member_1[2][1])) + (_e927.member_1[1][2] * _e817.member_1[2][2])), (((_e927.member_1[2][0] * _e817.member_1[2][0]) + (_e927.member_1[2][1] * _e817.member_1[2][1])) + (_e927.member_1[2][2] * _e817.member_1[2][2])))), array<f32, 3>((((_e817.member_1[0][0] * _e932) + (_e817.member_1[0][1] * _e935)) + (_e817.member_1[0][2] * _e938)), (((_e817.member_1[1][0] * _e932) + (_e817.member_1[1][1] * _e935)) + (_e817.member_1[1][2] * _e938)), (((_e817.member_1[2][0] * _e932) + (_e817.member_1[2][1] * _e935)) + (_e817.member_1[2][2] * _e938))), array<f32, 3>((((_e927.member_1[0][0] * _e932) + (_e927.member_1[0][1] * _e935)) + (_e927.member_1[0][2] * _e938)), (((_e927.member_1[1][0] * _e932) + (_e927.member_1[1][1] * _e935)) + (_e927.member_1[1][2] * _e938)), (((_e927.member_1[2][0] * _e932) + (_e927.member_1[2][1] * _e935)) + (_e927.member_1[2][2] * _e938))), array<f32, 3>(_e817.member_2[0], _e817.member_2[1], _e817.member_2[2]), array<f32, 3>(_e927.member_2[0], _e927.member_2[1], _e927.member_2[2]), ((((((select(_e932, -(_e932), (_e932 < 0f)) + select(_e935, -(_e935), (_e935 < 0f))) + select(_e938, -(_e938), (_e938 < 0f))) + (((select(_e817.member_2[0], -(_e817.member_2[0]), (_e817.member_2[0] < 0f)) + select(_e817.member_2[1], -(_e817.member_2[1]), (_e817.member_2[1] < 0f))) + select(_e817.member_2[2], -(_e817.member_2[2]), (_e817.member_2[2] < 0f))) + ((select(_e927.member_2[0], -(_e927.member_2[0]), (_e927.member_2[0] < 0f)) + select(_e927.member_2[1], -(_e927.member_2[1]), (_e927.member_2[1] < 0f))) + select(_e927.member_2[2], -(_e927.member_2[2]), (_e927.member_2[2] < 0f))))) * 2f) * (0.000000059604645f * 128f)) + (0.000000000000000000000000000000000000011754944f * 128f)));
                                    let _e1190 = local.member[0u][0u];
                                    let _e1194 = local.member[0u][1u];
                                    let _e1198 = local.member[0u][2u];
                                    let _e1202 = local.member[1u][0u];
                                    let _e1206 = local.member[1u][1u];
                                    let _e1210 = local.member[1u][2u];
                                    let _e1214 = local.member[2u][0u];
                                    let _e1218 = local.member[2u][1u];
                                    let _e1222 = local.member[2u][2u];
                                    let _e1224 = local.member_3;
                                    let _e1229 = local.member_4;
                                    let _e1235 = local.member_1[0u];
                                    let _e1254 = (select(_e1235, -(_e1235), (_e1235 < 0f)) - (_e1224[0] + (((select(_e1190, -(_e1190), (_e1190 < 0f)) * _e1229[0]) + (select(_e1194, -(_e1194), (_e1194 < 0f)) * _e1229[1])) + (select(_e1198, -(_e1198), (_e1198 < 0f)) * _e1229[2]))));
                                    let _e1257 = local.member_1[1u];
                                    let _e1276 = (select(_e1257, -(_e1257), (_e1257 < 0f)) - (_e1224[1] + (((select(_e1202, -(_e1202), (_e1202 < 0f)) * _e1229[0]) + (select(_e1206, -(_e1206), (_e1206 < 0f)) * _e1229[1])) + (select(_e1210, -(_e1210), (_e1210 < 0f)) * _e1229[2]))));
                                    let _e1279 = local.member_1[2u];
                                    let _e1298 = (select(_e1279, -(_e1279), (_e1279 < 0f)) - (_e1224[2] + (((select(_e1214, -(_e1214), (_e1214 < 0f)) * _e1229[0]) + (select(_e1218, -(_e1218), (_e1218 < 0f)) * _e1229[1])) + (select(_e1222, -(_e1222), (_e1222 < 0f)) * _e1229[2]))));
                                    let _e1301 = local.member_2[0u];
                                    let _e1320 = (select(_e1301, -(_e1301), (_e1301 < 0f)) - (_e1229[0] + (((select(_e1190, -(_e1190), (_e1190 < 0f)) * _e1224[0]) + (select(_e1202, -(_e1202), (_e1202 < 0f)) * _e1224[1])) + (select(_e1214, -(_e1214), (_e1214 < 0f)) * _e1224[2]))));
                                    let _e1323 = local.member_2[1u];
                                    let _e1342 = (select(_e1323, -(_e1323), (_e1323 < 0f)) - (_e1229[1] + (((select(_e1194, -(_e1194), (_e1194 < 0f)) * _e1224[0]) + (select(_e1206, -(_e1206), (_e1206 < 0f)) * _e1224[1])) + (select(_e1218, -(_e1218), (_e1218 < 0f)) * _e1224[2]))));
                                    let _e1345 = local.member_2[2u];
                                    let _e1364 = (select(_e1345, -(_e1345), (_e1345 < 0f)) - (_e1229[2] + (((select(_e1198, -(_e1198), (_e1198 < 0f)) * _e1224[0]) + (select(_e1210, -(_e1210), (_e1210 < 0f)) * _e1224[1])) + (select(_e1222, -(_e1222), (_e1222 < 0f)) * _e1224[2]))));
                                    let _e1366 = select(_e1276, _e1254, (_e1254 > _e1276));
                                    let _e1368 = select(_e1298, _e1366, (_e1366 > _e1298));
                                    let _e1370 = select(_e1342, _e1320, (_e1320 > _e1342));
                                    let _e1372 = select(_e1364, _e1370, (_e1370 > _e1364));
                                    let _e1376 = local.member_5;
                                    if (select(_e1372, _e1368, (_e1368 > _e1372)) > _e1376) {
                                        phi_3258_ = true;
                                    } else {
                                        let _e1381 = local.member[1u][0u];
                                        let _e1384 = local.member_1[2u];
                                        let _e1389 = local.member[2u][0u];
                                        let _e1392 = local.member_1[1u];
                                        let _e1394 = ((_e1381 * _e1384) - (_e1389 * _e1392));
                                        let _e1398 = local.member[2u][0u];
                                        let _e1404 = local.member_3[1u];
                                        let _e1409 = local.member[1u][0u];
                                        let _e1415 = local.member_3[2u];
                                        let _e1421 = local.member[0u][2u];
                                        let _e1427 = local.member_4[1u];
                                        let _e1432 = local.member[0u][1u];
                                        let _e1438 = local.member_4[2u];
                                        let _e1445 = (select(_e1394, -(_e1394), (_e1394 < 0f)) - (((select(_e1398, -(_e1398), (_e1398 < 0f)) * _e1404) + (select(_e1409, -(_e1409), (_e1409 < 0f)) * _e1415)) + ((select(_e1421, -(_e1421), (_e1421 < 0f)) * _e1427) + (select(_e1432, -(_e1432), (_e1432 < 0f)) * _e1438))));
                                        let _e1449 = local.member[1u][1u];
                                        let _e1452 = local.member_1[2u];
                                        let _e1457 = local.member[2u][1u];
                                        let _e1460 = local.member_1[1u];
                                        let _e1462 = ((_e1449 * _e1452) - (_e1457 * _e1460));
                                        let _e1466 = local.member[2u][1u];
                                        let _e1472 = local.member_3[1u];
                                        let _e1477 = local.member[1u][1u];
                                        let _e1483 = local.member_3[2u];
                                        let _e1489 = local.member[0u][0u];
                                        let _e1495 = local.member_4[2u];
                                        let _e1500 = local.member[0u][2u];
                                        let _e1506 = local.member_4[0u];
                                        let _e1513 = (select(_e1462, -(_e1462), (_e1462 < 0f)) - (((select(_e1466, -(_e1466), (_e1466 < 0f)) * _e1472) + (select(_e1477, -(_e1477), (_e1477 < 0f)) * _e1483)) + ((select(_e1489, -(_e1489), (_e1489 < 0f)) * _e1495) + (select(_e1500, -(_e1500), (_e1500 < 0f)) * _e1506))));
                                        let _e1517 = local.member[1u][2u];
                                        let _e1520 = local.member_1[2u];
                                        let _e1525 = local.member[2u][2u];
                                        let _e1528 = local.member_1[1u];
                                        let _e1530 = ((_e1517 * _e1520) - (_e1525 * _e1528));
                                        let _e1534 = local.member[2u][2u];
                                        let _e1540 = local.member_3[1u];
                                        let _e1545 = local.member[1u][2u];
                                        let _e1551 = local.member_3[2u];
                                        let _e1557 = local.member[0u][1u];
                                        let _e1563 = local.member_4[0u];
                                        let _e1568 = local.member[0u][0u];
                                        let _e1574 = local.member_4[1u];
                                        let _e1581 = (select(_e1530, -(_e1530), (_e1530 < 0f)) - (((select(_e1534, -(_e1534), (_e1534 < 0f)) * _e1540) + (select(_e1545, -(_e1545), (_e1545 < 0f)) * _e1551)) + ((select(_e1557, -(_e1557), (_e1557 < 0f)) * _e1563) + (select(_e1568, -(_e1568), (_e1568 < 0f)) * _e1574))));
                                        let _e1585 = local.member[2u][0u];
                                        let _e1588 = local.member_1[0u];
                                        let _e1593 = local.member[0u][0u];
                                        let _e1596 = local.member_1[2u];
                                        let _e1598 = ((_e1585 * _e1588) - (_e1593 * _e1596));
                                        let _e1602 = local.member[0u][0u];
                                        let _e1608 = local.member_3[2u];
                                        let _e1613 = local.member[2u][0u];
                                        let _e1619 = local.member_3[0u];
                                        let _e1625 = local.member[1u][2u];
                                        let _e1631 = local.member_4[1u];
                                        let _e1636 = local.member[1u][1u];
                                        let _e1642 = local.member_4[2u];
                                        let _e1649 = (select(_e1598, -(_e1598), (_e1598 < 0f)) - (((select(_e1602, -(_e1602), (_e1602 < 0f)) * _e1608) + (select(_e1613, -(_e1613), (_e1613 < 0f)) * _e1619)) + ((select(_e1625, -(_e1625), (_e1625 < 0f)) * _e1631) + (select(_e1636, -(_e1636), (_e1636 < 0f)) * _e1642))));
                                        let _e1653 = local.member[2u][1u];
                                        let _e1656 = local.member_1[0u];
                                        let _e1661 = local.member[0u][1u];
                                        let _e1664 = local.member_1[2u];
                                        let _e1666 = ((_e1653 * _e1656) - (_e1661 * _e1664));
                                        let _e1670 = local.member[0u][1u];
                                        let _e1676 = local.member_3[2u];
                                        let _e1681 = local.member[2u][1u];
                                        let _e1687 = local.member_3[0u];
                                        let _e1693 = local.member[1u][0u];
                                        let _e1699 = local.member_4[2u];
                                        let _e1704 = local.member[1u][2u];
                                        let _e1710 = local.member_4[0u];
                                        let _e1717 = (select(_e1666, -(_e1666), (_e1666 < 0f)) - (((select(_e1670, -(_e1670), (_e1670 < 0f)) * _e1676) + (select(_e1681, -(_e1681), (_e1681 < 0f)) * _e1687)) + ((select(_e1693, -(_e1693), (_e1693 < 0f)) * _e1699) + (select(_e1704, -(_e1704), (_e1704 < 0f)) * _e1710))));
                                        let _e1721 = local.member[2u][2u];
                                        let _e1724 = local.member_1[0u];
                                        let _e1729 = local.member[0u][2u];
                                        let _e1732 = local.member_1[2u];
                                        let _e1734 = ((_e1721 * _e1724) - (_e1729 * _e1732));
                                        let _e1738 = local.member[0u][2u];
                                        let _e1744 = local.member_3[2u];
                                        let _e1749 = local.member[2u][2u];
                                        let _e1755 = local.member_3[0u];
                                        let _e1761 = local.member[1u][1u];
                                        let _e1767 = local.member_4[0u];
                                        let _e1772 = local.member[1u][0u];
                                        let _e1778 = local.member_4[1u];
                                        let _e1785 = (select(_e1734, -(_e1734), (_e1734 < 0f)) - (((select(_e1738, -(_e1738), (_e1738 < 0f)) * _e1744) + (select(_e1749, -(_e1749), (_e1749 < 0f)) * _e1755)) + ((select(_e1761, -(_e1761), (_e1761 < 0f)) * _e1767) + (select(_e1772, -(_e1772), (_e1772 < 0f)) * _e1778))));
                                        let _e1789 = local.member[0u][0u];
                                        let _e1792 = local.member_1[1u];
                                        let _e1797 = local.member[1u][0u];
                                        let _e1800 = local.member_1[0u];
                                        let _e1802 = ((_e1789 * _e1792) - (_e1797 * _e1800));
                                        let _e1806 = local.member[1u][0u];
                                        let _e1812 = local.member_3[0u];
                                        let _e1817 = local.member[0u][0u];
                                        let _e1823 = local.member_3[1u];
                                        let _e1829 = local.member[2u][2u];
                                        let _e1835 = local.member_4[1u];
                                        let _e1840 = local.member[2u][1u];
                                        let _e1846 = local.member_4[2u];
                                        let _e1853 = (select(_e1802, -(_e1802), (_e1802 < 0f)) - (((select(_e1806, -(_e1806), (_e1806 < 0f)) * _e1812) + (select(_e1817, -(_e1817), (_e1817 < 0f)) * _e1823)) + ((select(_e1829, -(_e1829), (_e1829 < 0f)) * _e1835) + (select(_e1840, -(_e1840), (_e1840 < 0f)) * _e1846))));
                                        let _e1857 = local.member[0u][1u];
                                        let _e1860 = local.member_1[1u];
                                        let _e1865 = local.member[1u][1u];
                                        let _e1868 = local.member_1[0u];
                                        let _e1870 = ((_e1857 * _e1860) - (_e1865 * _e1868));
                                        let _e1874 = local.member[1u][1u];
                                        let _e1880 = local.member_3[0u];
                                        let _e1885 = local.member[0u][1u];
                                        let _e1891 = local.member_3[1u];
                                        let _e1897 = local.member[2u][0u];
                                        let _e1903 = local.member_4[2u];
                                        let _e1908 = local.member[2u][2u];
                                        let _e1914 = local.member_4[0u];
                                        let _e1921 = (select(_e1870, -(_e1870), (_e1870 < 0f)) - (((select(_e1874, -(_e1874), (_e1874 < 0f)) * _e1880) + (select(_e1885, -(_e1885), (_e1885 < 0f)) * _e1891)) + ((select(_e1897, -(_e1897), (_e1897 < 0f)) * _e1903) + (select(_e1908, -(_e1908), (_e1908 < 0f)) * _e1914))));
                                        let _e1925 = local.member[0u][2u];
                                        let _e1928 = local.member_1[1u];
                                        let _e1933 = local.member[1u][2u];
                                        let _e1936 = local.member_1[0u];
                                        let _e1938 = ((_e1925 * _e1928) - (_e1933 * _e1936));
                                        let _e1942 = local.member[1u][2u];
                                        let _e1948 = local.member_3[0u];
                                        let _e1953 = local.member[0u][2u];
                                        let _e1959 = local.member_3[1u];
                                        let _e1965 = local.member[2u][1u];
                                        let _e1971 = local.member_4[0u];
                                        let _e1976 = local.member[2u][0u];
                                        let _e1982 = local.member_4[1u];
                                        let _e1989 = (select(_e1938, -(_e1938), (_e1938 < 0f)) - (((select(_e1942, -(_e1942), (_e1942 < 0f)) * _e1948) + (select(_e1953, -(_e1953), (_e1953 < 0f)) * _e1959)) + ((select(_e1965, -(_e1965), (_e1965 < 0f)) * _e1971) + (select(_e1976, -(_e1976), (_e1976 < 0f)) * _e1982))));
                                        let _e1991 = select(_e1513, _e1445, (_e1445 > _e1513));
                                        let _e1993 = select(_e1581, _e1991, (_e1991 > _e1581));
                                        let _e1995 = select(_e1717, _e1649, (_e1649 > _e1717));
                                        let _e1997 = select(_e1785, _e1995, (_e1995 > _e1785));
                                        let _e1999 = select(_e1997, _e1993, (_e1993 > _e1997));
                                        let _e2001 = select(_e1921, _e1853, (_e1853 > _e1921));
                                        let _e2003 = select(_e1989, _e2001, (_e2001 > _e1989));
                                        let _e2007 = local.member_5;
                                        phi_3258_ = (select(_e2003, _e1999, (_e1999 > _e2003)) > _e2007);
                                    }
                                    let _e2010 = phi_3258_;
                                    phi_3260_ = !(_e2010);
                                    phi_3261_ = false;
                                } else {
                                    phi_3260_ = bool();
                                    phi_3261_ = true;
                                }
                                let _e2013 = phi_3260_;
                                let _e2015 = phi_3261_;
                                phi_3262_ = _e2013;
                                phi_3263_ = _e2015;
                            }
                            let _e2017 = phi_3262_;
                            let _e2019 = phi_3263_;
                            if select(_e2017, true, _e2019) {
                            } else {
                                local_1[_e694] = array<u32, 2>(4294967295u, 4294967295u);
                            }
                        }
                    }
                    continue;
                    continuing {
                        phi_1000_ = type_9(select(_e680.member, (_e680.member + 1u), _e683), select(_e680.member_1, _e680.member_1, _e683));
                        break if !(_e696);
                    }
                }
                let _e2023 = local_1;
                let _e2046 = (select(select(2u, 1u, select(true, select(true, false, (_e131 >= _e79)), (_e128 >= _e74))), 0u, (_e128 == 4294967295u)) == 2u);
                phi_3324_ = array<u32, 2>(_e2023[3][0], _e2023[3][1]);
                phi_3325_ = array<u32, 2>(_e2023[2][0], _e2023[2][1]);
                phi_3326_ = array<u32, 2>(_e2023[1][0], _e2023[1][1]);
                phi_3327_ = array<u32, 2>(select(_e2023[0][0], _e128, _e2046), select(_e2023[0][1], _e131, _e2046));
            } else {
                phi_3324_ = array<u32, 2>(4294967295u, 4294967295u);
                phi_3325_ = array<u32, 2>(4294967295u, 4294967295u);
                phi_3326_ = array<u32, 2>(4294967295u, 4294967295u);
                phi_3327_ = array<u32, 2>(4294967295u, 4294967295u);
            }
            let _e2051 = phi_3324_;
            let _e2053 = phi_3325_;
            let _e2055 = phi_3326_;
            let _e2057 = phi_3327_;
            let _e2067 = select(select(2u, 1u, select(true, select(true, false, (_e2057[1] >= _e79)), (_e2057[0] >= _e74))), 0u, (_e2057[0] == 4294967295u));
            if (_e2067 == 0u) {
                phi_3361_ = 0u;
            } else {
                let _e2072 = atomicAdd((&counters[select(1u, 0u, (_e2067 == 1u))]), 1u);
                phi_3361_ = _e2072;
            }
            let _e2074 = phi_3361_;
            let _e2084 = select(select(2u, 1u, select(true, select(true, false, (_e2055[1] >= _e79)), (_e2055[0] >= _e74))), 0u, (_e2055[0] == 4294967295u));
            if (_e2084 == 0u) {
                phi_3395_ = 0u;
            } else {
                let _e2089 = atomicAdd((&counters[select(1u, 0u, (_e2084 == 1u))]), 1u);
                phi_3395_ = _e2089;
            }
            let _e2091 = phi_3395_;
            let _e2101 = select(select(2u, 1u, select(true, select(true, false, (_e2053[1] >= _e79)), (_e2053[0] >= _e74))), 0u, (_e2053[0] == 4294967295u));
            if (_e2101 == 0u) {
                phi_3429_ = 0u;
            } else {
                let _e2106 = atomicAdd((&counters[select(1u, 0u, (_e2101 == 1u))]), 1u);
                phi_3429_ = _e2106;
            }
            let _e2108 = phi_3429_;
            let _e2118 = select(select(2u, 1u, select(true, select(true, false, (_e2051[1] >= _e79)), (_e2051[0] >= _e74))), 0u, (_e2051[0] == 4294967295u));
            if (_e2118 == 0u) {
                phi_3463_ = 0u;
            } else {
                let _e2123 = atomicAdd((&counters[select(1u, 0u, (_e2118 == 1u))]), 1u);
                phi_3463_ = _e2123;
            }
            let _e2125 = phi_3463_;
            workgroupBarrier();
            if (_e44 == 0u) {
                let _e2128 = atomicLoad((&counters[0u]));
                let _e2130 = atomicLoad((&counters[1u]));
                if (_e2128 > 0u) {
                    let _e2134 = atomicAdd((&levels.member[(_e63 + 1u)]), _e2128);
                    let _e2137 = atomicMax((&output.member[0u]), (_e2134 + _e2128));
                    if ((_e2134 + _e2128) < _e2134) {
                        let _e2141 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[2u]), _e2134);
                }
                if (_e2130 > 0u) {
                    let _e2145 = atomicAdd((&pairs.member[0u]), _e2130);
                    if ((_e2145 + _e2130) < _e2145) {
                        let _e2149 = atomicAdd((&pairs.member[2u]), 1u);
                    }
                    atomicStore((&counters[3u]), _e2145);
                }
            }
            workgroupBarrier();
            let _e2152 = atomicLoad((&counters[2u]));
            let _e2154 = atomicLoad((&counters[3u]));
            let _e2164 = select(select(2u, 1u, select(true, select(true, false, (_e2057[1] >= _e79)), (_e2057[0] >= _e74))), 0u, (_e2057[0] == 4294967295u));
            if (_e2164 == 1u) {
                let _e2202 = params.member.member_2.member_3;
                let _e2203 = (_e2152 + _e2074);
                if (_e2203 < _e2202) {
                    let _e2205 = (2u * _e2203);
                    atomicStore((&output.member[(4u + _e2205)]), _e2057[0]);
                    atomicStore((&output.member[(_e2205 + 5u)]), _e2057[1]);
                }
            } else {
                if (_e2164 == 2u) {
                    let _e2169 = params.member.member_1.member_3;
                    let _e2170 = (_e2154 + _e2074);
                    let _e2173 = a_nodes.member[_e2057[0]];
                    let _e2177 = b_nodes.member[_e2057[1]];
                    let _e2181 = params.member.member_2.member;
                    if (_e2181 == 1u) {
                        let _e2184 = (_e2173.member_1 < _e2177.member_1);
                        phi_3614_ = type_9(select(_e2177.member_1, _e2173.member_1, _e2184), select(_e2173.member_1, _e2177.member_1, _e2184));
                    } else {
                        phi_3614_ = type_9(_e2173.member_1, _e2177.member_1);
                    }
                    let _e2189 = phi_3614_;
                    if (_e2170 < _e2169) {
                        let _e2193 = (2u * _e2170);
                        atomicStore((&pairs.member[(4u + _e2193)]), _e2189.member);
                        atomicStore((&pairs.member[(_e2193 + 5u)]), _e2189.member_1);
                    }
                }
            }
            let _e2219 = select(select(2u, 1u, select(true, select(true, false, (_e2055[1] >= _e79)), (_e2055[0] >= _e74))), 0u, (_e2055[0] == 4294967295u));
            if (_e2219 == 1u) {
                let _e2257 = params.member.member_2.member_3;
                let _e2258 = (_e2152 + _e2091);
                if (_e2258 < _e2257) {
                    let _e2260 = (2u * _e2258);
                    atomicStore((&output.member[(4u + _e2260)]), _e2055[0]);
                    atomicStore((&output.member[(_e2260 + 5u)]), _e2055[1]);
                }
            } else {
                if (_e2219 == 2u) {
                    let _e2224 = params.member.member_1.member_3;
                    let _e2225 = (_e2154 + _e2091);
                    let _e2228 = a_nodes.member[_e2055[0]];
                    let _e2232 = b_nodes.member[_e2055[1]];
                    let _e2236 = params.member.member_2.member;
                    if (_e2236 == 1u) {
                        let _e2239 = (_e2228.member_1 < _e2232.member_1);
                        phi_3728_ = type_9(select(_e2232.member_1, _e2228.member_1, _e2239), select(_e2228.member_1, _e2232.member_1, _e2239));
                    } else {
                        phi_3728_ = type_9(_e2228.member_1, _e2232.member_1);
                    }
                    let _e2244 = phi_3728_;
                    if (_e2225 < _e2224) {
                        let _e2248 = (2u * _e2225);
                        atomicStore((&pairs.member[(4u + _e2248)]), _e2244.member);
                        atomicStore((&pairs.member[(_e2248 + 5u)]), _e2244.member_1);
                    }
                }
            }
            let _e2274 = select(select(2u, 1u, select(true, select(true, false, (_e2053[1] >= _e79)), (_e2053[0] >= _e74))), 0u, (_e2053[0] == 4294967295u));
            if (_e2274 == 1u) {
                let _e2312 = params.member.member_2.member_3;
                let _e2313 = (_e2152 + _e2108);
                if (_e2313 < _e2312) {
                    let _e2315 = (2u * _e2313);
                    atomicStore((&output.member[(4u + _e2315)]), _e2053[0]);
                    atomicStore((&output.member[(_e2315 + 5u)]), _e2053[1]);
                }
            } else {
                if (_e2274 == 2u) {
                    let _e2279 = params.member.member_1.member_3;
                    let _e2280 = (_e2154 + _e2108);
                    let _e2283 = a_nodes.member[_e2053[0]];
                    let _e2287 = b_nodes.member[_e2053[1]];
                    let _e2291 = params.member.member_2.member;
                    if (_e2291 == 1u) {
                        let _e2294 = (_e2283.member_1 < _e2287.member_1);
                        phi_3842_ = type_9(select(_e2287.member_1, _e2283.member_1, _e2294), select(_e2283.member_1, _e2287.member_1, _e2294));
                    } else {
                        phi_3842_ = type_9(_e2283.member_1, _e2287.member_1);
                    }
                    let _e2299 = phi_3842_;
                    if (_e2280 < _e2279) {
                        let _e2303 = (2u * _e2280);
                        atomicStore((&pairs.member[(4u + _e2303)]), _e2299.member);
                        atomicStore((&pairs.member[(_e2303 + 5u)]), _e2299.member_1);
                    }
                }
            }
            let _e2329 = select(select(2u, 1u, select(true, select(true, false, (_e2051[1] >= _e79)), (_e2051[0] >= _e74))), 0u, (_e2051[0] == 4294967295u));
            if (_e2329 == 1u) {
                let _e2367 = params.member.member_2.member_3;
                let _e2368 = (_e2152 + _e2125);
                if (_e2368 < _e2367) {
                    let _e2370 = (2u * _e2368);
                    atomicStore((&output.member[(4u + _e2370)]), _e2051[0]);
                    atomicStore((&output.member[(_e2370 + 5u)]), _e2051[1]);
                }
            } else {
                if (_e2329 == 2u) {
                    let _e2334 = params.member.member_1.member_3;
                    let _e2335 = (_e2154 + _e2125);
                    let _e2338 = a_nodes.member[_e2051[0]];
                    let _e2342 = b_nodes.member[_e2051[1]];
                    let _e2346 = params.member.member_2.member;
                    if (_e2346 == 1u) {
                        let _e2349 = (_e2338.member_1 < _e2342.member_1);
                        phi_3956_ = type_9(select(_e2342.member_1, _e2338.member_1, _e2349), select(_e2338.member_1, _e2342.member_1, _e2349));
                    } else {
                        phi_3956_ = type_9(_e2338.member_1, _e2342.member_1);
                    }
                    let _e2354 = phi_3956_;
                    if (_e2335 < _e2334) {
                        let _e2358 = (2u * _e2335);
                        atomicStore((&pairs.member[(4u + _e2358)]), _e2354.member);
                        atomicStore((&pairs.member[(_e2358 + 5u)]), _e2354.member_1);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_220_ = type_9(select(_e100.member, (_e100.member + 1u), _e103), select(_e100.member_1, _e100.member_1, _e103));
            break if !(_e116);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn expand_pairs_oriented(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}

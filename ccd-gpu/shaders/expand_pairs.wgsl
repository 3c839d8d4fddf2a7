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

struct type_25 {
    member: array<atomic<u32>>,
}

@group(0) @binding(3) 
var<storage> input: type_11;
@group(0) @binding(0) 
var<storage> params: type_20;
@group(0) @binding(1) 
var<storage> a_nodes: type_17;
@group(0) @binding(2) 
var<storage> b_nodes: type_17;
@group(0) @binding(5) 
var<storage, read_write> output: type_25;
@group(0) @binding(6) 
var<storage, read_write> pairs: type_25;
@group(0) @binding(4) 
var<storage, read_write> levels: type_25;
var<workgroup> counters: array<atomic<u32>, 4>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_178_: type_9;
    var phi_380_: type_22;
    var phi_381_: type_22;
    var phi_382_: bool;
    var phi_383_: type_22;
    var phi_384_: bool;
    var phi_444_: bool;
    var phi_445_: bool;
    var phi_446_: bool;
    var phi_447_: bool;
    var phi_448_: bool;
    var phi_449_: bool;
    var phi_644_: type_22;
    var phi_645_: bool;
    var phi_646_: type_22;
    var phi_647_: bool;
    var phi_854_: type_22;
    var phi_855_: type_22;
    var phi_856_: type_22;
    var phi_857_: bool;
    var phi_858_: type_22;
    var phi_859_: type_22;
    var phi_860_: bool;
    var phi_864_: type_22;
    var phi_895_: array<u32, 2>;
    var phi_896_: array<u32, 2>;
    var phi_897_: array<u32, 2>;
    var phi_898_: array<u32, 2>;
    var phi_932_: u32;
    var phi_966_: u32;
    var phi_1000_: u32;
    var phi_1034_: u32;
    var phi_1185_: type_9;
    var phi_1299_: type_9;
    var phi_1413_: type_9;
    var phi_1527_: type_9;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e26 = id_2;
    let _e27 = n_2;
    let _e28 = lane_2;
    let _e43 = (_e27.x * _e27.y);
    let _e46 = params.member.member_1.member_1;
    let _e49 = params.member.member_2.member;
    let _e50 = (_e49 == 0u);
    let _e56 = params.member.member.member[select(1u, 0u, _e50)];
    let _e57 = (_e56 - 1u);
    let _e61 = params.member.member.member[select(1u, 2u, _e50)];
    let _e62 = (_e61 - 1u);
    let _e64 = atomicLoad((&levels.member[_e46]));
    let _e67 = params.member.member_1.member_2;
    let _e72 = params.member.member_1.member_2;
    let _e73 = (_e43 * 128u);
    if (_e73 == 0u) {
        return;
    }
    let _e75 = (_e72 / _e73);
    if (_e73 == 0u) {
        return;
    }
    phi_178_ = type_9(0u, select(_e75, (_e75 + 1u), ((_e72 % _e73) > 0u)));
    loop {
        let _e83 = phi_178_;
        let _e86 = (_e83.member < _e83.member_1);
        let _e99 = (bitcast<i32>(select(0u, 1u, _e86)) != 0i);
        if _e99 {
            let _e103 = (((((_e26.y * _e27.x) + _e26.x) + (select(type_9().member_1, _e83.member, _e86) * _e43)) * 128u) + _e28);
            if (_e28 == 0u) {
                atomicStore((&counters[0u]), 0u);
                atomicStore((&counters[1u]), 0u);
            }
            workgroupBarrier();
            if (_e103 < select(_e64, _e67, (_e67 < _e64))) {
                let _e108 = (2u * _e103);
                let _e111 = input.member[(4u + _e108)];
                let _e114 = input.member[(_e108 + 5u)];
                let _e117 = params.member.member_2.member_1;
                let _e122 = params.member.member_2.member;
                let _e125 = a_nodes.member[_e111];
                let _e127 = b_nodes.member[_e114];
                if (_e122 == 1u) {
                    if (_e111 == _e114) {
                        if (_e125.member_3 == 4294967295u) {
                            phi_380_ = type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)));
                        } else {
                            let _e133 = a_nodes.member[_e125.member_1];
                            let _e136 = a_nodes.member[_e125.member_3];
                            let _e139 = !((_e133.member_3 == 4294967295u));
                            let _e150 = type_22(array<array<u32, 2>, 4>(array<u32, 2>(select(4294967295u, _e125.member_1, _e139), select(4294967295u, _e125.member_1, _e139)), type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[1], type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[2], type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[3]), type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1);
                            let _e162 = type_22(array<array<u32, 2>, 4>(_e150.member[0], array<u32, 2>(_e125.member_1, _e150.member[1][1]), _e150.member[2], _e150.member[3]), _e150.member_1);
                            let _e170 = type_22(array<array<u32, 2>, 4>(_e162.member[0], array<u32, 2>(_e125.member_1, _e125.member_3), _e162.member[2], _e162.member[3]), _e162.member_1);
                            let _e173 = !((_e136.member_3 == 4294967295u));
                            let _e184 = type_22(array<array<u32, 2>, 4>(_e170.member[0], _e170.member[1], array<u32, 2>(select(4294967295u, _e125.member_3, _e173), select(4294967295u, _e125.member_3, _e173)), _e170.member[3]), _e170.member_1);
                            let _e187 = type_22(_e184.member, _e184.member);
                            let _e214 = ((((((_e133.member[0] <= _e136.member_2[0]) && (_e136.member[0] <= _e133.member_2[0])) && (_e133.member[1] <= _e136.member_2[1])) && (_e136.member[1] <= _e133.member_2[1])) && (_e133.member[2] <= _e136.member_2[2])) && (_e136.member[2] <= _e133.member_2[2]));
                            phi_380_ = type_22(_e187.member, array<array<u32, 2>, 4>(_e187.member_1[0], array<u32, 2>(select(4294967295u, _e125.member_1, _e214), select(4294967295u, _e125.member_3, _e214)), _e187.member_1[2], _e187.member_1[3]));
                        }
                        let _e226 = phi_380_;
                        phi_381_ = _e226;
                        phi_382_ = false;
                    } else {
                        phi_381_ = type_22();
                        phi_382_ = true;
                    }
                    let _e228 = phi_381_;
                    let _e230 = phi_382_;
                    phi_383_ = _e228;
                    phi_384_ = _e230;
                } else {
                    phi_383_ = type_22();
                    phi_384_ = true;
                }
                let _e232 = phi_383_;
                let _e234 = phi_384_;
                if _e234 {
                    let _e237 = !((_e125.member_3 == 4294967295u));
                    let _e240 = !((_e127.member_3 == 4294967295u));
                    if select(_e240, true, _e237) {
                        if _e237 {
                            if _e240 {
                                if (select(0u, 1u, (_e117 == 0u)) == 0u) {
                                    let _e269 = ((((_e127.member_2[0] - _e127.member[0]) * (_e127.member_2[1] - _e127.member[1])) * (_e127.member_2[2] - _e127.member[2])) > (((_e125.member_2[0] - _e125.member[0]) * (_e125.member_2[1] - _e125.member[1])) * (_e125.member_2[2] - _e125.member[2])));
                                    phi_444_ = _e269;
                                    phi_445_ = !(_e269);
                                } else {
                                    phi_444_ = _e240;
                                    phi_445_ = _e237;
                                }
                                let _e272 = phi_444_;
                                let _e274 = phi_445_;
                                phi_446_ = _e272;
                                phi_447_ = _e274;
                            } else {
                                phi_446_ = _e240;
                                phi_447_ = _e237;
                            }
                            let _e276 = phi_446_;
                            let _e278 = phi_447_;
                            phi_448_ = _e276;
                            phi_449_ = _e278;
                        } else {
                            phi_448_ = _e240;
                            phi_449_ = _e237;
                        }
                        let _e280 = phi_448_;
                        let _e282 = phi_449_;
                        if _e282 {
                            if _e280 {
                                let _e285 = a_nodes.member[_e125.member_1];
                                let _e290 = a_nodes.member[_e125.member_3];
                                let _e295 = b_nodes.member[_e127.member_1];
                                let _e300 = b_nodes.member[_e127.member_3];
                                let _e338 = ((((((_e285.member[0] <= _e295.member_2[0]) && (_e295.member[0] <= _e285.member_2[0])) && (_e285.member[1] <= _e295.member_2[1])) && (_e295.member[1] <= _e285.member_2[1])) && (_e285.member[2] <= _e295.member_2[2])) && (_e295.member[2] <= _e285.member_2[2]));
                                let _e364 = ((((((_e285.member[0] <= _e300.member_2[0]) && (_e300.member[0] <= _e285.member_2[0])) && (_e285.member[1] <= _e300.member_2[1])) && (_e300.member[1] <= _e285.member_2[1])) && (_e285.member[2] <= _e300.member_2[2])) && (_e300.member[2] <= _e285.member_2[2]));
                                let _e390 = ((((((_e290.member[0] <= _e295.member_2[0]) && (_e295.member[0] <= _e290.member_2[0])) && (_e290.member[1] <= _e295.member_2[1])) && (_e295.member[1] <= _e290.member_2[1])) && (_e290.member[2] <= _e295.member_2[2])) && (_e295.member[2] <= _e290.member_2[2]));
                                let _e416 = ((((((_e290.member[0] <= _e300.member_2[0]) && (_e300.member[0] <= _e290.member_2[0])) && (_e290.member[1] <= _e300.member_2[1])) && (_e300.member[1] <= _e290.member_2[1])) && (_e290.member[2] <= _e300.member_2[2])) && (_e300.member[2] <= _e290.member_2[2]));
                                phi_644_ = type_22(array<array<u32, 2>, 4>(array<u32, 2>(_e125.member_1, _e127.member_1), array<u32, 2>(_e125.member_1, _e127.member_3), array<u32, 2>(_e125.member_3, _e127.member_1), array<u32, 2>(_e125.member_3, _e127.member_3)), array<array<u32, 2>, 4>(array<u32, 2>(select(4294967295u, _e125.member_1, _e338), select(4294967295u, _e127.member_1, _e338)), array<u32, 2>(select(4294967295u, _e125.member_1, _e364), select(4294967295u, _e127.member_3, _e364)), array<u32, 2>(select(4294967295u, _e125.member_3, _e390), select(4294967295u, _e127.member_1, _e390)), array<u32, 2>(select(4294967295u, _e125.member_3, _e416), select(4294967295u, _e127.member_3, _e416))));
                                phi_645_ = false;
                            } else {
                                phi_644_ = type_22();
                                phi_645_ = true;
                            }
                            let _e423 = phi_644_;
                            let _e425 = phi_645_;
                            phi_646_ = _e423;
                            phi_647_ = _e425;
                        } else {
                            phi_646_ = type_22();
                            phi_647_ = true;
                        }
                        let _e427 = phi_646_;
                        let _e429 = phi_647_;
                        if _e429 {
                            if _e282 {
                                let _e514 = a_nodes.member[_e125.member_1];
                                let _e519 = a_nodes.member[_e125.member_3];
                                let _e548 = ((((((_e514.member[0] <= _e127.member_2[0]) && (_e127.member[0] <= _e514.member_2[0])) && (_e514.member[1] <= _e127.member_2[1])) && (_e127.member[1] <= _e514.member_2[1])) && (_e514.member[2] <= _e127.member_2[2])) && (_e127.member[2] <= _e514.member_2[2]));
                                let _e558 = type_22(type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member, array<array<u32, 2>, 4>(array<u32, 2>(select(4294967295u, _e125.member_1, _e548), select(4294967295u, _e114, _e548)), type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[1], type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[2], type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[3]));
                                let _e583 = ((((((_e519.member[0] <= _e127.member_2[0]) && (_e127.member[0] <= _e519.member_2[0])) && (_e519.member[1] <= _e127.member_2[1])) && (_e127.member[1] <= _e519.member_2[1])) && (_e519.member[2] <= _e127.member_2[2])) && (_e127.member[2] <= _e519.member_2[2]));
                                phi_854_ = type_22(_e558.member, array<array<u32, 2>, 4>(_e558.member_1[0], array<u32, 2>(select(4294967295u, _e125.member_3, _e583), select(4294967295u, _e114, _e583)), _e558.member_1[2], _e558.member_1[3]));
                            } else {
                                let _e432 = b_nodes.member[_e127.member_1];
                                let _e437 = b_nodes.member[_e127.member_3];
                                let _e466 = ((((((_e125.member[0] <= _e432.member_2[0]) && (_e432.member[0] <= _e125.member_2[0])) && (_e125.member[1] <= _e432.member_2[1])) && (_e432.member[1] <= _e125.member_2[1])) && (_e125.member[2] <= _e432.member_2[2])) && (_e432.member[2] <= _e125.member_2[2]));
                                let _e476 = type_22(type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member, array<array<u32, 2>, 4>(array<u32, 2>(select(4294967295u, _e111, _e466), select(4294967295u, _e127.member_1, _e466)), type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[1], type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[2], type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[3]));
                                let _e501 = ((((((_e125.member[0] <= _e437.member_2[0]) && (_e437.member[0] <= _e125.member_2[0])) && (_e125.member[1] <= _e437.member_2[1])) && (_e437.member[1] <= _e125.member_2[1])) && (_e125.member[2] <= _e437.member_2[2])) && (_e437.member[2] <= _e125.member_2[2]));
                                phi_854_ = type_22(_e476.member, array<array<u32, 2>, 4>(_e476.member_1[0], array<u32, 2>(select(4294967295u, _e111, _e501), select(4294967295u, _e127.member_3, _e501)), _e476.member_1[2], _e476.member_1[3]));
                            }
                            let _e595 = phi_854_;
                            phi_855_ = _e595;
                        } else {
                            phi_855_ = _e427;
                        }
                        let _e597 = phi_855_;
                        phi_856_ = _e597;
                        phi_857_ = false;
                    } else {
                        phi_856_ = type_22();
                        phi_857_ = true;
                    }
                    let _e599 = phi_856_;
                    let _e601 = phi_857_;
                    phi_858_ = _e599;
                    phi_859_ = type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)));
                    phi_860_ = _e601;
                } else {
                    phi_858_ = type_22();
                    phi_859_ = _e232;
                    phi_860_ = true;
                }
                let _e603 = phi_858_;
                let _e605 = phi_859_;
                let _e607 = phi_860_;
                if _e607 {
                    phi_864_ = _e605;
                } else {
                    phi_864_ = _e603;
                }
                let _e609 = phi_864_;
                let _e622 = (select(select(2u, 1u, select(true, select(true, false, (_e114 >= _e62)), (_e111 >= _e57))), 0u, (_e111 == 4294967295u)) == 2u);
                phi_895_ = _e609.member_1[3];
                phi_896_ = _e609.member_1[2];
                phi_897_ = _e609.member_1[1];
                phi_898_ = array<u32, 2>(select(_e609.member_1[0][0], _e111, _e622), select(_e609.member_1[0][1], _e114, _e622));
            } else {
                phi_895_ = array<u32, 2>(4294967295u, 4294967295u);
                phi_896_ = array<u32, 2>(4294967295u, 4294967295u);
                phi_897_ = array<u32, 2>(4294967295u, 4294967295u);
                phi_898_ = array<u32, 2>(4294967295u, 4294967295u);
            }
            let _e629 = phi_895_;
            let _e631 = phi_896_;
            let _e633 = phi_897_;
            let _e635 = phi_898_;
            let _e645 = select(select(2u, 1u, select(true, select(true, false, (_e635[1] >= _e62)), (_e635[0] >= _e57))), 0u, (_e635[0] == 4294967295u));
            if (_e645 == 0u) {
                phi_932_ = 0u;
            } else {
                let _e650 = atomicAdd((&counters[select(1u, 0u, (_e645 == 1u))]), 1u);
                phi_932_ = _e650;
            }
            let _e652 = phi_932_;
            let _e662 = select(select(2u, 1u, select(true, select(true, false, (_e633[1] >= _e62)), (_e633[0] >= _e57))), 0u, (_e633[0] == 4294967295u));
            if (_e662 == 0u) {
                phi_966_ = 0u;
            } else {
                let _e667 = atomicAdd((&counters[select(1u, 0u, (_e662 == 1u))]), 1u);
                phi_966_ = _e667;
            }
            let _e669 = phi_966_;
            let _e679 = select(select(2u, 1u, select(true, select(true, false, (_e631[1] >= _e62)), (_e631[0] >= _e57))), 0u, (_e631[0] == 4294967295u));
            if (_e679 == 0u) {
                phi_1000_ = 0u;
            } else {
                let _e684 = atomicAdd((&counters[select(1u, 0u, (_e679 == 1u))]), 1u);
                phi_1000_ = _e684;
            }
            let _e686 = phi_1000_;
            let _e696 = select(select(2u, 1u, select(true, select(true, false, (_e629[1] >= _e62)), (_e629[0] >= _e57))), 0u, (_e629[0] == 4294967295u));
            if (_e696 == 0u) {
                phi_1034_ = 0u;
            } else {
                let _e701 = atomicAdd((&counters[select(1u, 0u, (_e696 == 1u))]), 1u);
                phi_1034_ = _e701;
            }
            let _e703 = phi_1034_;
            workgroupBarrier();
            if (_e28 == 0u) {
                let _e706 = atomicLoad((&counters[0u]));
                let _e708 = atomicLoad((&counters[1u]));
                if (_e706 > 0u) {
                    let _e712 = atomicAdd((&levels.member[(_e46 + 1u)]), _e706);
                    let _e715 = atomicMax((&output.member[0u]), (_e712 + _e706));
                    if ((_e712 + _e706) < _e712) {
                        let _e719 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[2u]), _e712);
                }
                if (_e708 > 0u) {
                    let _e723 = atomicAdd((&pairs.member[0u]), _e708);
                    if ((_e723 + _e708) < _e723) {
                        let _e727 = atomicAdd((&pairs.member[2u]), 1u);
                    }
                    atomicStore((&counters[3u]), _e723);
                }
            }
            workgroupBarrier();
            let _e730 = atomicLoad((&counters[2u]));
            let _e732 = atomicLoad((&counters[3u]));
            let _e742 = select(select(2u, 1u, select(true, select(true, false, (_e635[1] >= _e62)), (_e635[0] >= _e57))), 0u, (_e635[0] == 4294967295u));
            if (_e742 == 1u) {
                let _e780 = params.member.member_2.member_3;
                let _e781 = (_e730 + _e652);
                if (_e781 < _e780) {
                    let _e783 = (2u * _e781);
                    atomicStore((&output.member[(4u + _e783)]), _e635[0]);
                    atomicStore((&output.member[(_e783 + 5u)]), _e635[1]);
                }
            } else {
                if (_e742 == 2u) {
                    let _e747 = params.member.member_1.member_3;
                    let _e748 = (_e732 + _e652);
                    let _e751 = a_nodes.member[_e635[0]];
                    let _e755 = b_nodes.member[_e635[1]];
                    let _e759 = params.member.member_2.member;
                    if (_e759 == 1u) {
                        let _e762 = (_e751.member_1 < _e755.member_1);
                        phi_1185_ = type_9(select(_e755.member_1, _e751.member_1, _e762), select(_e751.member_1, _e755.member_1, _e762));
                    } else {
                        phi_1185_ = type_9(_e751.member_1, _e755.member_1);
                    }
                    let _e767 = phi_1185_;
                    if (_e748 < _e747) {
                        let _e771 = (2u * _e748);
                        atomicStore((&pairs.member[(4u + _e771)]), _e767.member);
                        atomicStore((&pairs.member[(_e771 + 5u)]), _e767.member_1);
                    }
                }
            }
            let _e797 = select(select(2u, 1u, select(true, select(true, false, (_e633[1] >= _e62)), (_e633[0] >= _e57))), 0u, (_e633[0] == 4294967295u));
            if (_e797 == 1u) {
                let _e835 = params.member.member_2.member_3;
                let _e836 = (_e730 + _e669);
                if (_e836 < _e835) {
                    let _e838 = (2u * _e836);
                    atomicStore((&output.member[(4u + _e838)]), _e633[0]);
                    atomicStore((&output.member[(_e838 + 5u)]), _e633[1]);
                }
            } else {
                if (_e797 == 2u) {
                    let _e802 = params.member.member_1.member_3;
                    let _e803 = (_e732 + _e669);
                    let _e806 = a_nodes.member[_e633[0]];
                    let _e810 = b_nodes.member[_e633[1]];
                    let _e814 = params.member.member_2.member;
                    if (_e814 == 1u) {
                        let _e817 = (_e806.member_1 < _e810.member_1);
                        phi_1299_ = type_9(select(_e810.member_1, _e806.member_1, _e817), select(_e806.member_1, _e810.member_1, _e817));
                    } else {
                        phi_1299_ = type_9(_e806.member_1, _e810.member_1);
                    }
                    let _e822 = phi_1299_;
                    if (_e803 < _e802) {
                        let _e826 = (2u * _e803);
                        atomicStore((&pairs.member[(4u + _e826)]), _e822.member);
                        atomicStore((&pairs.member[(_e826 + 5u)]), _e822.member_1);
                    }
                }
            }
            let _e852 = select(select(2u, 1u, select(true, select(true, false, (_e631[1] >= _e62)), (_e631[0] >= _e57))), 0u, (_e631[0] == 4294967295u));
            if (_e852 == 1u) {
                let _e890 = params.member.member_2.member_3;
                let _e891 = (_e730 + _e686);
                if (_e891 < _e890) {
                    let _e893 = (2u * _e891);
                    atomicStore((&output.member[(4u + _e893)]), _e631[0]);
                    atomicStore((&output.member[(_e893 + 5u)]), _e631[1]);
                }
            } else {
                if (_e852 == 2u) {
                    let _e857 = params.member.member_1.member_3;
                    let _e858 = (_e732 + _e686);
                    let _e861 = a_nodes.member[_e631[0]];
                    let _e865 = b_nodes.member[_e631[1]];
                    let _e869 = params.member.member_2.member;
                    if (_e869 == 1u) {
                        let _e872 = (_e861.member_1 < _e865.member_1);
                        phi_1413_ = type_9(select(_e865.member_1, _e861.member_1, _e872), select(_e861.member_1, _e865.member_1, _e872));
                    } else {
                        phi_1413_ = type_9(_e861.member_1, _e865.member_1);
                    }
                    let _e877 = phi_1413_;
                    if (_e858 < _e857) {
                        let _e881 = (2u * _e858);
                        atomicStore((&pairs.member[(4u + _e881)]), _e877.member);
                        atomicStore((&pairs.member[(_e881 + 5u)]), _e877.member_1);
                    }
                }
            }
            let _e907 = select(select(2u, 1u, select(true, select(true, false, (_e629[1] >= _e62)), (_e629[0] >= _e57))), 0u, (_e629[0] == 4294967295u));
            if (_e907 == 1u) {
                let _e945 = params.member.member_2.member_3;
                let _e946 = (_e730 + _e703);
                if (_e946 < _e945) {
                    let _e948 = (2u * _e946);
                    atomicStore((&output.member[(4u + _e948)]), _e629[0]);
                    atomicStore((&output.member[(_e948 + 5u)]), _e629[1]);
                }
            } else {
                if (_e907 == 2u) {
                    let _e912 = params.member.member_1.member_3;
                    let _e913 = (_e732 + _e703);
                    let _e916 = a_nodes.member[_e629[0]];
                    let _e920 = b_nodes.member[_e629[1]];
                    let _e924 = params.member.member_2.member;
                    if (_e924 == 1u) {
                        let _e927 = (_e916.member_1 < _e920.member_1);
                        phi_1527_ = type_9(select(_e920.member_1, _e916.member_1, _e927), select(_e916.member_1, _e920.member_1, _e927));
                    } else {
                        phi_1527_ = type_9(_e916.member_1, _e920.member_1);
                    }
                    let _e932 = phi_1527_;
                    if (_e913 < _e912) {
                        let _e936 = (2u * _e913);
                        atomicStore((&pairs.member[(4u + _e936)]), _e932.member);
                        atomicStore((&pairs.member[(_e936 + 5u)]), _e932.member_1);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_178_ = type_9(select(_e83.member, (_e83.member + 1u), _e86), select(_e83.member_1, _e83.member_1, _e86));
            break if !(_e99);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn expand_pairs(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}

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

struct type_13 {
    member: array<array<u32, 4>, 8>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_14 {
    member: type_7,
    member_1: type_8,
    member_2: type_13,
}

struct type_15 {
    member: type_14,
}

struct type_16 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_18 {
    member: array<type_16>,
}

struct type_20 {
    member: array<type_8>,
}

struct type_22 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_24 {
    member: array<type_22>,
}

struct type_25 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
}

struct type_27 {
    member: array<type_25>,
}

@group(0) @binding(0) 
var<storage> params: type_15;
@group(0) @binding(1) 
var<storage> branches: type_20;
@group(0) @binding(2) 
var<storage> block_nodes: type_24;
@group(0) @binding(3) 
var<storage> leaves: type_18;
@group(0) @binding(4) 
var<storage, read_write> nodes: type_27;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_120_: type_9;
    var phi_123_: type_22;
    var phi_125_: u32;
    var phi_127_: u32;
    var phi_121_: type_9;
    var phi_150_: type_9;
    var phi_169_: u32;
    var phi_179_: bool;
    var phi_183_: u32;
    var phi_184_: u32;
    var phi_187_: type_9;
    var phi_190_: type_22;
    var phi_188_: type_9;
    var phi_213_: type_9;
    var phi_251_: f32;
    var phi_258_: f32;
    var phi_265_: f32;
    var phi_273_: f32;
    var phi_280_: f32;
    var phi_287_: f32;
    var phi_191_: type_22;
    var phi_292_: type_9;
    var phi_295_: type_22;
    var phi_293_: type_9;
    var phi_318_: type_9;
    var phi_356_: f32;
    var phi_363_: f32;
    var phi_370_: f32;
    var phi_378_: f32;
    var phi_385_: f32;
    var phi_392_: f32;
    var phi_296_: type_22;
    var phi_399_: u32;
    var phi_404_: u32;
    var phi_124_: type_22;
    var phi_126_: u32;
    var phi_128_: u32;
    var local: type_22;
    var local_1: type_22;
    var local_2: type_22;
    var local_3: type_22;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e20 = id_2;
    let _e21 = n_2;
    let _e22 = lane_2;
    let _e34 = ((((_e20.y * _e21.x) + _e20.x) * 256u) + _e22);
    let _e38 = params.member.member.member[1u];
    if ((_e34 + 1u) < _e38) {
        let _e42 = branches.member[_e34];
        phi_120_ = type_9(0u, 8u);
        phi_123_ = type_22(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        phi_125_ = (_e42.member_3 + 1u);
        phi_127_ = _e42.member_2;
        loop {
            let _e48 = phi_120_;
            let _e50 = phi_123_;
            let _e52 = phi_125_;
            let _e54 = phi_127_;
            local = _e50;
            local_1 = _e50;
            if (_e48.member < _e48.member_1) {
                phi_121_ = type_9((_e48.member + 1u), _e48.member_1);
                phi_150_ = type_9(1u, _e48.member);
            } else {
                phi_121_ = _e48;
                phi_150_ = type_9(0u, type_9().member_1);
            }
            let _e66 = phi_121_;
            let _e68 = phi_150_;
            let _e72 = (bitcast<i32>(_e68.member) != 0i);
            if _e72 {
                let _e73 = (_e54 % 32u);
                if (_e73 == 0u) {
                    phi_169_ = _e54;
                } else {
                    phi_169_ = (_e54 + (32u - _e73));
                }
                let _e78 = phi_169_;
                let _e80 = ((_e52 / 32u) * 32u);
                if (_e78 < _e80) {
                    let _e83 = params.member.member_2.member_2;
                    phi_179_ = (_e68.member_1 < _e83);
                } else {
                    phi_179_ = false;
                }
                let _e86 = phi_179_;
                if _e86 {
                    phi_183_ = _e80;
                    phi_184_ = _e78;
                } else {
                    phi_183_ = _e52;
                    phi_184_ = _e52;
                }
                let _e88 = phi_183_;
                let _e90 = phi_184_;
                phi_187_ = type_9(_e54, _e90);
                phi_190_ = _e50;
                loop {
                    let _e93 = phi_187_;
                    let _e95 = phi_190_;
                    local_2 = _e95;
                    if (_e93.member < _e93.member_1) {
                        phi_188_ = type_9((_e93.member + 1u), _e93.member_1);
                        phi_213_ = type_9(1u, _e93.member);
                    } else {
                        phi_188_ = _e93;
                        phi_213_ = type_9(0u, type_9().member_1);
                    }
                    let _e107 = phi_188_;
                    let _e109 = phi_213_;
                    let _e113 = (bitcast<i32>(_e109.member) != 0i);
                    if _e113 {
                        let _e117 = params.member.member_2.member[_e68.member_1][1u];
                        let _e120 = block_nodes.member[(_e117 + _e109.member_1)];
                        if (_e95.member[0] < _e120.member[0]) {
                            phi_251_ = _e95.member[0];
                        } else {
                            phi_251_ = _e120.member[0];
                        }
                        let _e127 = phi_251_;
                        if (_e95.member[1] < _e120.member[1]) {
                            phi_258_ = _e95.member[1];
                        } else {
                            phi_258_ = _e120.member[1];
                        }
                        let _e134 = phi_258_;
                        if (_e95.member[2] < _e120.member[2]) {
                            phi_265_ = _e95.member[2];
                        } else {
                            phi_265_ = _e120.member[2];
                        }
                        let _e141 = phi_265_;
                        if (_e95.member_1[0] > _e120.member_1[0]) {
                            phi_273_ = _e95.member_1[0];
                        } else {
                            phi_273_ = _e120.member_1[0];
                        }
                        let _e149 = phi_273_;
                        if (_e95.member_1[1] > _e120.member_1[1]) {
                            phi_280_ = _e95.member_1[1];
                        } else {
                            phi_280_ = _e120.member_1[1];
                        }
                        let _e156 = phi_280_;
                        if (_e95.member_1[2] > _e120.member_1[2]) {
                            phi_287_ = _e95.member_1[2];
                        } else {
                            phi_287_ = _e120.member_1[2];
                        }
                        let _e163 = phi_287_;
                        phi_191_ = type_22(array<f32, 3>(_e127, _e134, _e141), array<f32, 3>(_e149, _e156, _e163));
                    } else {
                        phi_191_ = type_22();
                    }
                    let _e167 = phi_191_;
                    continue;
                    continuing {
                        phi_187_ = _e107;
                        phi_190_ = _e167;
                        break if !(_e113);
                    }
                }
                phi_292_ = type_9(_e88, _e52);
                let _e312 = local_2;
                phi_295_ = _e312;
                loop {
                    let _e171 = phi_292_;
                    let _e173 = phi_295_;
                    local_3 = _e173;
                    if (_e171.member < _e171.member_1) {
                        phi_293_ = type_9((_e171.member + 1u), _e171.member_1);
                        phi_318_ = type_9(1u, _e171.member);
                    } else {
                        phi_293_ = _e171;
                        phi_318_ = type_9(0u, type_9().member_1);
                    }
                    let _e185 = phi_293_;
                    let _e187 = phi_318_;
                    let _e191 = (bitcast<i32>(_e187.member) != 0i);
                    if _e191 {
                        let _e195 = params.member.member_2.member[_e68.member_1][1u];
                        let _e198 = block_nodes.member[(_e195 + _e187.member_1)];
                        if (_e173.member[0] < _e198.member[0]) {
                            phi_356_ = _e173.member[0];
                        } else {
                            phi_356_ = _e198.member[0];
                        }
                        let _e205 = phi_356_;
                        if (_e173.member[1] < _e198.member[1]) {
                            phi_363_ = _e173.member[1];
                        } else {
                            phi_363_ = _e198.member[1];
                        }
                        let _e212 = phi_363_;
                        if (_e173.member[2] < _e198.member[2]) {
                            phi_370_ = _e173.member[2];
                        } else {
                            phi_370_ = _e198.member[2];
                        }
                        let _e219 = phi_370_;
                        if (_e173.member_1[0] > _e198.member_1[0]) {
                            phi_378_ = _e173.member_1[0];
                        } else {
                            phi_378_ = _e198.member_1[0];
                        }
                        let _e227 = phi_378_;
                        if (_e173.member_1[1] > _e198.member_1[1]) {
                            phi_385_ = _e173.member_1[1];
                        } else {
                            phi_385_ = _e198.member_1[1];
                        }
                        let _e234 = phi_385_;
                        if (_e173.member_1[2] > _e198.member_1[2]) {
                            phi_392_ = _e173.member_1[2];
                        } else {
                            phi_392_ = _e198.member_1[2];
                        }
                        let _e241 = phi_392_;
                        phi_296_ = type_22(array<f32, 3>(_e205, _e212, _e219), array<f32, 3>(_e227, _e234, _e241));
                    } else {
                        phi_296_ = type_22();
                    }
                    let _e245 = phi_296_;
                    continue;
                    continuing {
                        phi_292_ = _e185;
                        phi_295_ = _e245;
                        break if !(_e191);
                    }
                }
                if _e86 {
                    phi_399_ = (_e78 / 32u);
                } else {
                    phi_399_ = 0u;
                }
                let _e249 = phi_399_;
                if _e86 {
                    phi_404_ = (_e80 / 32u);
                } else {
                    phi_404_ = 0u;
                }
                let _e252 = phi_404_;
                let _e326 = local_3;
                phi_124_ = _e326;
                phi_126_ = _e252;
                phi_128_ = _e249;
            } else {
                phi_124_ = type_22();
                phi_126_ = u32();
                phi_128_ = u32();
            }
            let _e254 = phi_124_;
            let _e256 = phi_126_;
            let _e258 = phi_128_;
            continue;
            continuing {
                phi_120_ = _e66;
                phi_123_ = _e254;
                phi_125_ = _e256;
                phi_127_ = _e258;
                break if !(_e72);
            }
        }
        let _e261 = local;
        let _e265 = local_1;
        nodes.member[_e34] = type_25(_e261.member, _e42.member, _e265.member_1, _e42.member_1);
    }
    if (_e34 < _e38) {
        let _e275 = params.member.member_2.member[0u][1u];
        let _e276 = (_e275 + _e34);
        let _e278 = block_nodes.member[_e276];
        let _e283 = leaves.member[_e276];
        nodes.member[((_e38 - 1u) + _e34)] = type_25(_e278.member, _e283.member_1, _e278.member_1, 4294967295u);
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn branch_boxes(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}

struct type_8 {
    member: array<u32, 3>,
    member_1: u32,
    member_2: array<u32, 4>,
    member_3: f32,
    member_4: f32,
    member_5: f32,
    member_6: f32,
    member_7: array<u32, 2>,
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
    member_18: array<array<u32, 2>, 3>,
    member_19: array<u32, 2>,
    member_20: array<array<u32, 4>, 8>,
}

struct type_9 {
    member: type_8,
}

struct type_11 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_13 {
    member: array<type_11>,
}

struct type_14 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_16 {
    member: array<type_14>,
}

struct type_19 {
    member: u32,
    member_1: u32,
}

struct type_20 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_22 {
    member: array<type_20>,
}

struct type_23 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
}

struct type_25 {
    member: array<type_23>,
}

@group(0) @binding(0) 
var<storage> params: type_9;
@group(0) @binding(1) 
var<storage> branches: type_22;
@group(0) @binding(2) 
var<storage> block_nodes: type_13;
@group(0) @binding(3) 
var<storage> leaves: type_16;
@group(0) @binding(4) 
var<storage, read_write> out: type_25;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_119_: type_19;
    var phi_122_: type_11;
    var phi_124_: u32;
    var phi_126_: u32;
    var phi_120_: type_19;
    var phi_149_: type_19;
    var phi_168_: u32;
    var phi_178_: bool;
    var phi_182_: u32;
    var phi_183_: u32;
    var phi_186_: type_19;
    var phi_189_: type_11;
    var phi_187_: type_19;
    var phi_212_: type_19;
    var phi_251_: f32;
    var phi_258_: f32;
    var phi_265_: f32;
    var phi_273_: f32;
    var phi_280_: f32;
    var phi_287_: f32;
    var phi_190_: type_11;
    var phi_292_: type_19;
    var phi_295_: type_11;
    var phi_293_: type_19;
    var phi_318_: type_19;
    var phi_357_: f32;
    var phi_364_: f32;
    var phi_371_: f32;
    var phi_379_: f32;
    var phi_386_: f32;
    var phi_393_: f32;
    var phi_296_: type_11;
    var phi_400_: u32;
    var phi_405_: u32;
    var phi_123_: type_11;
    var phi_125_: u32;
    var phi_127_: u32;
    var local: type_11;
    var local_1: type_11;
    var local_2: type_11;
    var local_3: type_11;
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
    let _e37 = params.member.member[1u];
    if ((_e34 + 1u) < _e37) {
        let _e41 = branches.member[_e34];
        phi_119_ = type_19(0u, 8u);
        phi_122_ = type_11(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        phi_124_ = (_e41.member_3 + 1u);
        phi_126_ = _e41.member_2;
        loop {
            let _e46 = phi_119_;
            let _e48 = phi_122_;
            let _e50 = phi_124_;
            let _e52 = phi_126_;
            local = _e48;
            local_1 = _e48;
            if (_e46.member < _e46.member_1) {
                phi_120_ = type_19((_e46.member + 1u), _e46.member_1);
                phi_149_ = type_19(1u, _e46.member);
            } else {
                phi_120_ = _e46;
                phi_149_ = type_19(0u, type_19().member_1);
            }
            let _e64 = phi_120_;
            let _e66 = phi_149_;
            let _e70 = (bitcast<i32>(_e66.member) != 0i);
            if _e70 {
                let _e71 = (_e52 % 32u);
                if (_e71 == 0u) {
                    phi_168_ = _e52;
                } else {
                    phi_168_ = (_e52 + (32u - _e71));
                }
                let _e76 = phi_168_;
                let _e78 = ((_e50 / 32u) * 32u);
                if (_e76 < _e78) {
                    let _e81 = params.member.member_9;
                    phi_178_ = (_e66.member_1 < _e81);
                } else {
                    phi_178_ = false;
                }
                let _e84 = phi_178_;
                if _e84 {
                    phi_182_ = _e78;
                    phi_183_ = _e76;
                } else {
                    phi_182_ = _e50;
                    phi_183_ = _e50;
                }
                let _e86 = phi_182_;
                let _e88 = phi_183_;
                phi_186_ = type_19(_e52, _e88);
                phi_189_ = _e48;
                loop {
                    let _e91 = phi_186_;
                    let _e93 = phi_189_;
                    local_2 = _e93;
                    if (_e91.member < _e91.member_1) {
                        phi_187_ = type_19((_e91.member + 1u), _e91.member_1);
                        phi_212_ = type_19(1u, _e91.member);
                    } else {
                        phi_187_ = _e91;
                        phi_212_ = type_19(0u, type_19().member_1);
                    }
                    let _e105 = phi_187_;
                    let _e107 = phi_212_;
                    let _e111 = (bitcast<i32>(_e107.member) != 0i);
                    if _e111 {
                        let _e115 = params.member.member_20[_e66.member_1][1u];
                        let _e118 = block_nodes.member[(_e115 + _e107.member_1)];
                        if (_e93.member[0] < _e118.member[0]) {
                            phi_251_ = _e93.member[0];
                        } else {
                            phi_251_ = _e118.member[0];
                        }
                        let _e125 = phi_251_;
                        if (_e93.member[1] < _e118.member[1]) {
                            phi_258_ = _e93.member[1];
                        } else {
                            phi_258_ = _e118.member[1];
                        }
                        let _e132 = phi_258_;
                        if (_e93.member[2] < _e118.member[2]) {
                            phi_265_ = _e93.member[2];
                        } else {
                            phi_265_ = _e118.member[2];
                        }
                        let _e139 = phi_265_;
                        if (_e93.member_1[0] > _e118.member_1[0]) {
                            phi_273_ = _e93.member_1[0];
                        } else {
                            phi_273_ = _e118.member_1[0];
                        }
                        let _e147 = phi_273_;
                        if (_e93.member_1[1] > _e118.member_1[1]) {
                            phi_280_ = _e93.member_1[1];
                        } else {
                            phi_280_ = _e118.member_1[1];
                        }
                        let _e154 = phi_280_;
                        if (_e93.member_1[2] > _e118.member_1[2]) {
                            phi_287_ = _e93.member_1[2];
                        } else {
                            phi_287_ = _e118.member_1[2];
                        }
                        let _e161 = phi_287_;
                        phi_190_ = type_11(array<f32, 3>(_e125, _e132, _e139), array<f32, 3>(_e147, _e154, _e161));
                    } else {
                        phi_190_ = type_11();
                    }
                    let _e165 = phi_190_;
                    continue;
                    continuing {
                        phi_186_ = _e105;
                        phi_189_ = _e165;
                        break if !(_e111);
                    }
                }
                phi_292_ = type_19(_e86, _e50);
                let _e309 = local_2;
                phi_295_ = _e309;
                loop {
                    let _e169 = phi_292_;
                    let _e171 = phi_295_;
                    local_3 = _e171;
                    if (_e169.member < _e169.member_1) {
                        phi_293_ = type_19((_e169.member + 1u), _e169.member_1);
                        phi_318_ = type_19(1u, _e169.member);
                    } else {
                        phi_293_ = _e169;
                        phi_318_ = type_19(0u, type_19().member_1);
                    }
                    let _e183 = phi_293_;
                    let _e185 = phi_318_;
                    let _e189 = (bitcast<i32>(_e185.member) != 0i);
                    if _e189 {
                        let _e193 = params.member.member_20[_e66.member_1][1u];
                        let _e196 = block_nodes.member[(_e193 + _e185.member_1)];
                        if (_e171.member[0] < _e196.member[0]) {
                            phi_357_ = _e171.member[0];
                        } else {
                            phi_357_ = _e196.member[0];
                        }
                        let _e203 = phi_357_;
                        if (_e171.member[1] < _e196.member[1]) {
                            phi_364_ = _e171.member[1];
                        } else {
                            phi_364_ = _e196.member[1];
                        }
                        let _e210 = phi_364_;
                        if (_e171.member[2] < _e196.member[2]) {
                            phi_371_ = _e171.member[2];
                        } else {
                            phi_371_ = _e196.member[2];
                        }
                        let _e217 = phi_371_;
                        if (_e171.member_1[0] > _e196.member_1[0]) {
                            phi_379_ = _e171.member_1[0];
                        } else {
                            phi_379_ = _e196.member_1[0];
                        }
                        let _e225 = phi_379_;
                        if (_e171.member_1[1] > _e196.member_1[1]) {
                            phi_386_ = _e171.member_1[1];
                        } else {
                            phi_386_ = _e196.member_1[1];
                        }
                        let _e232 = phi_386_;
                        if (_e171.member_1[2] > _e196.member_1[2]) {
                            phi_393_ = _e171.member_1[2];
                        } else {
                            phi_393_ = _e196.member_1[2];
                        }
                        let _e239 = phi_393_;
                        phi_296_ = type_11(array<f32, 3>(_e203, _e210, _e217), array<f32, 3>(_e225, _e232, _e239));
                    } else {
                        phi_296_ = type_11();
                    }
                    let _e243 = phi_296_;
                    continue;
                    continuing {
                        phi_292_ = _e183;
                        phi_295_ = _e243;
                        break if !(_e189);
                    }
                }
                if _e84 {
                    phi_400_ = (_e76 / 32u);
                } else {
                    phi_400_ = 0u;
                }
                let _e247 = phi_400_;
                if _e84 {
                    phi_405_ = (_e78 / 32u);
                } else {
                    phi_405_ = 0u;
                }
                let _e250 = phi_405_;
                let _e323 = local_3;
                phi_123_ = _e323;
                phi_125_ = _e250;
                phi_127_ = _e247;
            } else {
                phi_123_ = type_11();
                phi_125_ = u32();
                phi_127_ = u32();
            }
            let _e252 = phi_123_;
            let _e254 = phi_125_;
            let _e256 = phi_127_;
            continue;
            continuing {
                phi_119_ = _e64;
                phi_122_ = _e252;
                phi_124_ = _e254;
                phi_126_ = _e256;
                break if !(_e70);
            }
        }
        let _e259 = local;
        let _e263 = local_1;
        out.member[_e34] = type_23(_e259.member, _e41.member, _e263.member_1, _e41.member_1);
    }
    if (_e34 < _e37) {
        let _e272 = params.member.member_20[0u][1u];
        let _e273 = (_e272 + _e34);
        let _e275 = block_nodes.member[_e273];
        let _e280 = leaves.member[_e273];
        out.member[((_e37 - 1u) + _e34)] = type_23(_e275.member, _e280.member_1, _e275.member_1, 4294967295u);
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn branch_boxes(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}

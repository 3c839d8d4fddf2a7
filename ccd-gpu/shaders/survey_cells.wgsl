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

struct type_11 {
    member: array<u32>,
}

struct type_14 {
    member: i32,
    member_1: i32,
}

struct type_15 {
    member: u32,
    member_1: i32,
}

struct type_17 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_19 {
    member: array<type_17>,
}

struct type_20 {
    member: u32,
}

struct type_21 {
    member: type_7,
    member_1: type_8,
    member_2: type_20,
}

struct type_22 {
    member: type_21,
}

struct type_25 {
    member: array<atomic<u32>>,
}

@group(0) @binding(2) 
var<storage> keys: type_11;
@group(0) @binding(0) 
var<storage> params: type_22;
@group(0) @binding(1) 
var<storage> boxes: type_19;
@group(0) @binding(3) 
var<storage, read_write> survey: type_25;
var<workgroup> sums: array<atomic<u32>, 4>;

fn function_(param: f32, param_1: f32) -> f32 {
    var phi_589_: bool;
    var phi_593_: f32;

    if (param != param) {
        phi_589_ = true;
    } else {
        phi_589_ = (param_1 >= param);
    }
    let _e6 = phi_589_;
    if _e6 {
        phi_593_ = param_1;
    } else {
        phi_593_ = param;
    }
    let _e8 = phi_593_;
    return _e8;
}

fn function_1(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_17;
    var phi_134_: type_14;
    var phi_137_: u32;
    var phi_139_: u32;
    var phi_160_: bool;
    var phi_166_: type_15;
    var phi_135_: type_14;
    var phi_180_: type_15;
    var phi_209_: u32;
    var phi_210_: u32;
    var phi_211_: u32;
    var phi_212_: u32;
    var phi_213_: bool;
    var phi_138_: u32;
    var phi_140_: u32;
    var phi_214_: bool;
    var phi_217_: type_14;
    var phi_220_: u32;
    var phi_222_: u32;
    var phi_243_: bool;
    var phi_249_: type_15;
    var phi_218_: type_14;
    var phi_263_: type_15;
    var phi_292_: u32;
    var phi_293_: u32;
    var phi_294_: u32;
    var phi_295_: u32;
    var phi_296_: bool;
    var phi_221_: u32;
    var phi_223_: u32;
    var phi_297_: bool;
    var local_1: u32;
    var local_2: u32;
    var phi_303_: u32;
    var phi_323_: u32;
    var phi_342_: u32;
    var phi_361_: u32;
    var phi_365_: type_9;
    var phi_366_: type_9;
    var phi_389_: type_9;
    var phi_537_: f32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e37 = id_2;
    let _e38 = n_2;
    let _e39 = lane_2;
    if (_e39 < 3u) {
        atomicStore((&sums[_e39]), 0u);
    }
    workgroupBarrier();
    let _e52 = ((((_e37.y * _e38.x) + _e37.x) * 256u) + _e39);
    let _e56 = params.member.member.member_2[3u];
    if (_e52 < _e56) {
        let _e59 = keys.member[_e52];
        phi_134_ = type_14(0i, 32i);
        phi_137_ = 0u;
        phi_139_ = _e56;
        loop {
            let _e62 = phi_134_;
            let _e64 = phi_137_;
            let _e66 = phi_139_;
            local_1 = _e64;
            if (_e62.member < _e62.member_1) {
                let _e73 = (_e62.member + 1i);
                if ((false == (_e73 > _e62.member)) != false) {
                    phi_160_ = true;
                } else {
                    phi_160_ = false;
                }
                let _e78 = phi_160_;
                if _e78 {
                    phi_166_ = type_15(0u, type_15().member_1);
                } else {
                    phi_166_ = type_15(1u, _e73);
                }
                let _e83 = phi_166_;
                phi_135_ = type_14(_e83.member_1, _e62.member_1);
                phi_180_ = type_15(1u, _e62.member);
            } else {
                phi_135_ = _e62;
                phi_180_ = type_15(0u, type_15().member_1);
            }
            let _e89 = phi_135_;
            let _e91 = phi_180_;
            if (bitcast<i32>(_e91.member) != 0i) {
                if (_e64 >= _e66) {
                    phi_211_ = u32();
                    phi_212_ = u32();
                    phi_213_ = false;
                } else {
                    let _e98 = (_e64 + ((_e66 - _e64) / 2u));
                    let _e100 = keys.member[_e98];
                    if (_e100 < (_e59 + 1u)) {
                        phi_209_ = (_e98 + 1u);
                        phi_210_ = _e66;
                    } else {
                        phi_209_ = _e64;
                        phi_210_ = _e98;
                    }
                    let _e104 = phi_209_;
                    let _e106 = phi_210_;
                    phi_211_ = _e104;
                    phi_212_ = _e106;
                    phi_213_ = true;
                }
                let _e108 = phi_211_;
                let _e110 = phi_212_;
                let _e112 = phi_213_;
                phi_138_ = _e108;
                phi_140_ = _e110;
                phi_214_ = _e112;
            } else {
                phi_138_ = u32();
                phi_140_ = u32();
                phi_214_ = false;
            }
            let _e114 = phi_138_;
            let _e116 = phi_140_;
            let _e118 = phi_214_;
            continue;
            continuing {
                phi_134_ = _e89;
                phi_137_ = _e114;
                phi_139_ = _e116;
                break if !(_e118);
            }
        }
        phi_217_ = type_14(0i, 32i);
        phi_220_ = 0u;
        phi_222_ = _e56;
        loop {
            let _e121 = phi_217_;
            let _e123 = phi_220_;
            let _e125 = phi_222_;
            local_2 = _e123;
            if (_e121.member < _e121.member_1) {
                let _e132 = (_e121.member + 1i);
                if ((false == (_e132 > _e121.member)) != false) {
                    phi_243_ = true;
                } else {
                    phi_243_ = false;
                }
                let _e137 = phi_243_;
                if _e137 {
                    phi_249_ = type_15(0u, type_15().member_1);
                } else {
                    phi_249_ = type_15(1u, _e132);
                }
                let _e142 = phi_249_;
                phi_218_ = type_14(_e142.member_1, _e121.member_1);
                phi_263_ = type_15(1u, _e121.member);
            } else {
                phi_218_ = _e121;
                phi_263_ = type_15(0u, type_15().member_1);
            }
            let _e148 = phi_218_;
            let _e150 = phi_263_;
            if (bitcast<i32>(_e150.member) != 0i) {
                if (_e123 >= _e125) {
                    phi_294_ = u32();
                    phi_295_ = u32();
                    phi_296_ = false;
                } else {
                    let _e157 = (_e123 + ((_e125 - _e123) / 2u));
                    let _e159 = keys.member[_e157];
                    if (_e159 < _e59) {
                        phi_292_ = (_e157 + 1u);
                        phi_293_ = _e125;
                    } else {
                        phi_292_ = _e123;
                        phi_293_ = _e157;
                    }
                    let _e163 = phi_292_;
                    let _e165 = phi_293_;
                    phi_294_ = _e163;
                    phi_295_ = _e165;
                    phi_296_ = true;
                }
                let _e167 = phi_294_;
                let _e169 = phi_295_;
                let _e171 = phi_296_;
                phi_221_ = _e167;
                phi_223_ = _e169;
                phi_297_ = _e171;
            } else {
                phi_221_ = u32();
                phi_223_ = u32();
                phi_297_ = false;
            }
            let _e173 = phi_221_;
            let _e175 = phi_223_;
            let _e177 = phi_297_;
            continue;
            continuing {
                phi_217_ = _e148;
                phi_220_ = _e173;
                phi_222_ = _e175;
                break if !(_e177);
            }
        }
        let _e180 = local_1;
        let _e182 = local_2;
        let _e183 = (_e180 - _e182);
        if (16777215u < _e183) {
            phi_303_ = 16777215u;
        } else {
            phi_303_ = _e183;
        }
        let _e186 = phi_303_;
        let _e188 = atomicAdd((&sums[0u]), _e186);
        let _e190 = atomicLoad((&survey.member[6u]));
        if ((_e190 >> bitcast<u32>(31i)) == 1u) {
            phi_323_ = (_e190 & 2147483647u);
        } else {
            phi_323_ = ~(_e190);
        }
        let _e197 = phi_323_;
        let _e200 = atomicLoad((&survey.member[7u]));
        if ((_e200 >> bitcast<u32>(31i)) == 1u) {
            phi_342_ = (_e200 & 2147483647u);
        } else {
            phi_342_ = ~(_e200);
        }
        let _e207 = phi_342_;
        let _e210 = atomicLoad((&survey.member[8u]));
        if ((_e210 >> bitcast<u32>(31i)) == 1u) {
            phi_361_ = (_e210 & 2147483647u);
        } else {
            phi_361_ = ~(_e210);
        }
        let _e217 = phi_361_;
        phi_365_ = type_9(0u, 3u);
        loop {
            let _e220 = phi_365_;
            if (_e220.member < _e220.member_1) {
                phi_366_ = type_9((_e220.member + 1u), _e220.member_1);
                phi_389_ = type_9(1u, _e220.member);
            } else {
                phi_366_ = _e220;
                phi_389_ = type_9(0u, type_9().member_1);
            }
            let _e232 = phi_366_;
            let _e234 = phi_389_;
            let _e237 = (bitcast<i32>(_e234.member) != 0i);
            if _e237 {
            }
            continue;
            continuing {
                phi_365_ = _e232;
                break if !(_e237);
            }
        }
        let _e240 = boxes.member[_e52];
        local = type_17(array<f32, 3>(_e240.member[0], _e240.member[1], _e240.member[2]), array<f32, 3>(_e240.member_1[0], _e240.member_1[1], _e240.member_1[2]));
        let _e254 = local.member_1[0u];
        let _e258 = local.member[0u];
        let _e263 = local.member_1[1u];
        let _e267 = local.member[1u];
        let _e272 = local.member_1[2u];
        let _e276 = local.member[2u];
        let _e279 = function_(bitcast<f32>(_e197), bitcast<f32>(_e207));
        let _e280 = function_(_e279, bitcast<f32>(_e217));
        let _e281 = function_(((_e254 * 0.5f) - (_e258 * 0.5f)), ((_e263 * 0.5f) - (_e267 * 0.5f)));
        let _e282 = function_(_e281, ((_e272 * 0.5f) - (_e276 * 0.5f)));
        if (_e280 > 0f) {
            phi_537_ = ((_e282 / _e280) * 65536f);
        } else {
            phi_537_ = 0f;
        }
        let _e287 = phi_537_;
        let _e294 = atomicAdd((&sums[1u]), select(select(u32(_e287), 0u, (_e287 < 0f)), 4294967295u, (_e287 > 4294967000f)));
        let _e296 = atomicMax((&sums[2u]), _e183);
    }
    workgroupBarrier();
    if (_e39 < 2u) {
        let _e303 = (2u * _e39);
        let _e306 = atomicLoad((&sums[_e39]));
        let _e308 = atomicAdd((&survey.member[(9u + _e303)]), _e306);
        if ((_e308 + _e306) < _e308) {
            let _e313 = atomicAdd((&survey.member[(_e303 + 10u)]), 1u);
        }
    } else {
        if (_e39 == 2u) {
            let _e300 = atomicLoad((&sums[2u]));
            let _e302 = atomicMax((&survey.member[13u]), _e300);
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn survey_cells(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_1(id, n, lane);
}

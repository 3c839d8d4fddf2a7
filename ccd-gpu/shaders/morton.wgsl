struct type_6 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_13 {
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

struct type_15 {
    member: type_13,
}

struct type_19 {
    member: array<type_6>,
}

struct type_23 {
    member: array<u32>,
}

struct type_30 {
    member: u32,
    member_1: u32,
}

struct type_35 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: f32,
}

var<private> id_1: vec3<u32>;
var<private> n_1: vec3<u32>;
var<private> lane_1: u32;
@group(0) @binding(0) 
var<storage> params: type_15;
@group(0) @binding(1) 
var<storage> boxes: type_19;
@group(0) @binding(2) 
var<storage> words: type_23;
@group(0) @binding(3) 
var<storage, read_write> keys: type_23;
@group(0) @binding(4) 
var<storage, read_write> order: type_23;

fn function_() {
    var local: array<u32, 3>;
    var local_1: type_6;
    var local_2: type_6;
    var local_3: type_35;
    var local_4: type_6;
    var phi_134_: u32;
    var phi_135_: u32;
    var phi_138_: type_30;
    var phi_139_: type_30;
    var phi_162_: type_30;
    var phi_188_: u32;
    var phi_214_: u32;
    var phi_248_: type_30;
    var phi_251_: f32;
    var phi_249_: type_30;
    var phi_274_: type_30;
    var phi_304_: f32;
    var phi_252_: f32;
    var local_5: f32;
    var local_6: f32;
    var phi_314_: f32;
    var phi_355_: type_30;
    var phi_356_: type_30;
    var phi_379_: type_30;
    var phi_442_: u32;
    var phi_443_: u32;

    let _e50 = id_1;
    let _e51 = n_1;
    let _e52 = lane_1;
    let _e64 = ((((_e50.y * _e51.x) + _e50.x) * 256u) + _e52);
    let _e67 = params.member.member_2[3u];
    if (_e64 < _e67) {
        let _e71 = params.member.member_2[2u];
        if (_e64 >= _e71) {
            phi_135_ = 2u;
        } else {
            let _e74 = params.member.member_2[1u];
            if (_e64 >= _e74) {
                phi_134_ = 1u;
            } else {
                phi_134_ = 0u;
            }
            let _e77 = phi_134_;
            phi_135_ = _e77;
        }
        let _e79 = phi_135_;
        local_2 = type_6(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        phi_138_ = type_30(0u, 3u);
        loop {
            let _e81 = phi_138_;
            if (_e81.member < _e81.member_1) {
                phi_139_ = type_30((_e81.member + 1u), _e81.member_1);
                phi_162_ = type_30(1u, _e81.member);
            } else {
                phi_139_ = _e81;
                phi_162_ = type_30(0u, type_30().member_1);
            }
            let _e95 = phi_139_;
            let _e97 = phi_162_;
            let _e101 = (bitcast<i32>(_e97.member) != 0i);
            if _e101 {
                let _e103 = words.member[_e97.member_1];
                let _e104 = ~(_e103);
                if ((_e104 >> bitcast<u32>(31i)) == 1u) {
                    phi_188_ = (_e104 & 2147483647u);
                } else {
                    phi_188_ = ~(_e104);
                }
                let _e111 = phi_188_;
                if (_e97.member_1 < 3u) {
                } else {
                    return;
                }
                local_2.member[_e97.member_1] = bitcast<f32>(_e111);
                let _e118 = words.member[(3u + _e97.member_1)];
                if ((_e118 >> bitcast<u32>(31i)) == 1u) {
                    phi_214_ = (_e118 & 2147483647u);
                } else {
                    phi_214_ = ~(_e118);
                }
                let _e125 = phi_214_;
                if (_e97.member_1 < 3u) {
                } else {
                    return;
                }
                local_2.member_1[_e97.member_1] = bitcast<f32>(_e125);
            }
            continue;
            continuing {
                phi_138_ = _e95;
                break if !(_e101);
            }
        }
        let _e131 = local_2;
        local_4 = _e131;
        phi_248_ = type_30(0u, 3u);
        phi_251_ = 0f;
        loop {
            let _e133 = phi_248_;
            let _e135 = phi_251_;
            local_5 = _e135;
            local_6 = _e135;
            if (_e133.member < _e133.member_1) {
                phi_249_ = type_30((_e133.member + 1u), _e133.member_1);
                phi_274_ = type_30(1u, _e133.member);
            } else {
                phi_249_ = _e133;
                phi_274_ = type_30(0u, type_30().member_1);
            }
            let _e149 = phi_249_;
            let _e151 = phi_274_;
            let _e155 = (bitcast<i32>(_e151.member) != 0i);
            if _e155 {
                if (_e151.member_1 < 3u) {
                } else {
                    return;
                }
                let _e159 = local_4.member_1[_e151.member_1];
                if (_e151.member_1 < 3u) {
                } else {
                    return;
                }
                let _e164 = local_4.member[_e151.member_1];
                let _e166 = ((_e159 * 0.5f) - (_e164 * 0.5f));
                if (_e166 > _e135) {
                    phi_304_ = _e166;
                } else {
                    phi_304_ = _e135;
                }
                let _e169 = phi_304_;
                phi_252_ = _e169;
            } else {
                phi_252_ = f32();
            }
            let _e171 = phi_252_;
            continue;
            continuing {
                phi_248_ = _e149;
                phi_251_ = _e171;
                break if !(_e155);
            }
        }
        let _e174 = local_5;
        if (_e174 > 0.000000000000000000000000000001f) {
            let _e178 = local_6;
            phi_314_ = ((0.5f * 1024f) / _e178);
        } else {
            phi_314_ = 0f;
        }
        let _e181 = phi_314_;
        let _e183 = local_4.member;
        local_3 = type_35(_e183, _e181, (1024f - 1f));
        let _e189 = boxes.member[_e64];
        local_1 = type_6(array<f32, 3>(_e189.member[0], _e189.member[1], _e189.member[2]), array<f32, 3>(_e189.member_1[0], _e189.member_1[1], _e189.member_1[2]));
        local = array<u32, 3>(0u, 0u, 0u);
        phi_355_ = type_30(0u, 3u);
        loop {
            let _e202 = phi_355_;
            if (_e202.member < _e202.member_1) {
                phi_356_ = type_30((_e202.member + 1u), _e202.member_1);
                phi_379_ = type_30(1u, _e202.member);
            } else {
                phi_356_ = _e202;
                phi_379_ = type_30(0u, type_30().member_1);
            }
            let _e216 = phi_356_;
            let _e218 = phi_379_;
            let _e222 = (bitcast<i32>(_e218.member) != 0i);
            if _e222 {
                if (_e218.member_1 < 3u) {
                } else {
                    return;
                }
                let _e226 = local_1.member[_e218.member_1];
                if (_e218.member_1 < 3u) {
                } else {
                    return;
                }
                let _e231 = local_1.member_1[_e218.member_1];
                if (_e218.member_1 < 3u) {
                } else {
                    return;
                }
                let _e237 = local_3.member[_e218.member_1];
                let _e240 = local_3.member_1;
                let _e241 = ((((_e226 * 0.5f) + (_e231 * 0.5f)) - _e237) * _e240);
                let _e243 = local_3.member_2;
                if (_e241 >= _e243) {
                    let _e254 = local_3.member_2;
                    phi_443_ = select(select(u32(_e254), 0u, (_e254 < 0f)), 4294967295u, (_e254 > 4294967000f));
                } else {
                    if (_e241 > 0f) {
                        phi_442_ = select(select(u32(_e241), 0u, (_e241 < 0f)), 4294967295u, (_e241 > 4294967000f));
                    } else {
                        phi_442_ = 0u;
                    }
                    let _e252 = phi_442_;
                    phi_443_ = _e252;
                }
                let _e261 = phi_443_;
                if (_e218.member_1 < 3u) {
                } else {
                    return;
                }
                local[_e218.member_1] = _e261;
            }
            continue;
            continuing {
                phi_355_ = _e216;
                break if !(_e222);
            }
        }
        let _e265 = local;
        let _e269 = (_e265[0] & 1023u);
        let _e273 = ((_e269 | (_e269 << bitcast<u32>(16i))) & 50331903u);
        let _e277 = ((_e273 | (_e273 << bitcast<u32>(8i))) & 50393103u);
        let _e281 = ((_e277 | (_e277 << bitcast<u32>(4i))) & 51130563u);
        let _e288 = (_e265[1] & 1023u);
        let _e292 = ((_e288 | (_e288 << bitcast<u32>(16i))) & 50331903u);
        let _e296 = ((_e292 | (_e292 << bitcast<u32>(8i))) & 50393103u);
        let _e300 = ((_e296 | (_e296 << bitcast<u32>(4i))) & 51130563u);
        let _e308 = (_e265[2] & 1023u);
        let _e312 = ((_e308 | (_e308 << bitcast<u32>(16i))) & 50331903u);
        let _e316 = ((_e312 | (_e312 << bitcast<u32>(8i))) & 50393103u);
        let _e320 = ((_e316 | (_e316 << bitcast<u32>(4i))) & 51130563u);
        keys.member[_e64] = ((_e79 << bitcast<u32>(30i)) | (((((_e281 | (_e281 << bitcast<u32>(2i))) & 153391689u) << bitcast<u32>(2i)) | (((_e300 | (_e300 << bitcast<u32>(2i))) & 153391689u) << bitcast<u32>(1i))) | ((_e320 | (_e320 << bitcast<u32>(2i))) & 153391689u)));
        order.member[_e64] = _e64;
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn morton(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    id_1 = id;
    n_1 = n;
    lane_1 = lane;
    function_();
}

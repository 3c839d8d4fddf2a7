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

struct type_14 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_16 {
    member: array<type_14>,
}

struct type_17 {
    member: type_14,
    member_1: array<f32, 3>,
}

struct type_18 {
    member: u32,
    member_1: u32,
    member_2: u32,
}

struct type_19 {
    member: type_7,
    member_1: type_8,
    member_2: type_18,
}

struct type_20 {
    member: type_19,
}

@group(0) @binding(1) 
var<storage> boxes: type_16;
@group(0) @binding(0) 
var<storage> params: type_20;
@group(0) @binding(2) 
var<storage> survey: type_11;
@group(0) @binding(3) 
var<storage, read_write> keys: type_11;
@group(0) @binding(4) 
var<storage, read_write> order: type_11;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<u32, 3>;
    var local_1: type_14;
    var local_2: type_14;
    var local_3: type_14;
    var local_4: type_17;
    var local_5: type_14;
    var phi_136_: u32;
    var phi_137_: u32;
    var phi_231_: u32;
    var phi_250_: u32;
    var phi_269_: u32;
    var phi_274_: type_9;
    var phi_275_: type_9;
    var phi_298_: type_9;
    var phi_324_: u32;
    var phi_350_: u32;
    var phi_394_: type_9;
    var phi_395_: type_9;
    var phi_418_: type_9;
    var phi_469_: f32;
    var phi_474_: f32;
    var phi_515_: type_9;
    var phi_516_: type_9;
    var phi_539_: type_9;
    var phi_599_: u32;
    var phi_600_: u32;
    var phi_619_: u32;
    var phi_191_: f32;
    var phi_192_: f32;
    var phi_198_: u32;
    var phi_208_: u32;
    var phi_620_: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e46 = id_2;
    let _e47 = n_2;
    let _e48 = lane_2;
    let _e60 = ((((_e46.y * _e47.x) + _e46.x) * 256u) + _e48);
    let _e64 = params.member.member.member_2[3u];
    if (_e60 < _e64) {
        let _e69 = params.member.member.member_2[2u];
        if (_e60 >= _e69) {
            phi_137_ = 2u;
        } else {
            let _e72 = params.member.member.member_2[1u];
            if (_e60 >= _e72) {
                phi_136_ = 1u;
            } else {
                phi_136_ = 0u;
            }
            let _e75 = phi_136_;
            phi_137_ = _e75;
        }
        let _e77 = phi_137_;
        let _e79 = boxes.member[_e60];
        local_5 = type_14(array<f32, 3>(_e79.member[0], _e79.member[1], _e79.member[2]), array<f32, 3>(_e79.member_1[0], _e79.member_1[1], _e79.member_1[2]));
        let _e93 = params.member.member_2.member;
        if (_e93 == 1u) {
            let _e297 = survey.member[6u];
            if (_e297 == 0u) {
                let _e308 = local_5.member[0u];
                phi_192_ = _e308;
            } else {
                if (_e297 == 1u) {
                    let _e304 = local_5.member[1u];
                    phi_191_ = _e304;
                } else {
                    let _e302 = local_5.member[2u];
                    phi_191_ = _e302;
                }
                let _e306 = phi_191_;
                phi_192_ = _e306;
            }
            let _e310 = phi_192_;
            let _e311 = bitcast<u32>(_e310);
            if (_e311 == 2147483648u) {
                phi_198_ = 0u;
            } else {
                phi_198_ = _e311;
            }
            let _e314 = phi_198_;
            let _e316 = bitcast<u32>(bitcast<f32>(_e314));
            if ((_e316 >> bitcast<u32>(31i)) == 1u) {
                phi_208_ = ~(_e316);
            } else {
                phi_208_ = (_e316 | 2147483648u);
            }
            let _e323 = phi_208_;
            phi_620_ = (_e323 >> bitcast<u32>(2i));
        } else {
            if (_e93 == 2u) {
                let _e97 = survey.member[6u];
                if ((_e97 >> bitcast<u32>(31i)) == 1u) {
                    phi_231_ = (_e97 & 2147483647u);
                } else {
                    phi_231_ = ~(_e97);
                }
                let _e104 = phi_231_;
                let _e107 = survey.member[7u];
                if ((_e107 >> bitcast<u32>(31i)) == 1u) {
                    phi_250_ = (_e107 & 2147483647u);
                } else {
                    phi_250_ = ~(_e107);
                }
                let _e114 = phi_250_;
                let _e117 = survey.member[8u];
                if ((_e117 >> bitcast<u32>(31i)) == 1u) {
                    phi_269_ = (_e117 & 2147483647u);
                } else {
                    phi_269_ = ~(_e117);
                }
                let _e124 = phi_269_;
                local_2 = type_14(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                phi_274_ = type_9(0u, 3u);
                loop {
                    let _e127 = phi_274_;
                    if (_e127.member < _e127.member_1) {
                        phi_275_ = type_9((_e127.member + 1u), _e127.member_1);
                        phi_298_ = type_9(1u, _e127.member);
                    } else {
                        phi_275_ = _e127;
                        phi_298_ = type_9(0u, type_9().member_1);
                    }
                    let _e139 = phi_275_;
                    let _e141 = phi_298_;
                    let _e145 = (bitcast<i32>(_e141.member) != 0i);
                    if _e145 {
                        let _e147 = survey.member[_e141.member_1];
                        let _e148 = ~(_e147);
                        if ((_e148 >> bitcast<u32>(31i)) == 1u) {
                            phi_324_ = (_e148 & 2147483647u);
                        } else {
                            phi_324_ = ~(_e148);
                        }
                        let _e155 = phi_324_;
                        local_2.member[_e141.member_1] = bitcast<f32>(_e155);
                        let _e161 = survey.member[(3u + _e141.member_1)];
                        if ((_e161 >> bitcast<u32>(31i)) == 1u) {
                            phi_350_ = (_e161 & 2147483647u);
                        } else {
                            phi_350_ = ~(_e161);
                        }
                        let _e168 = phi_350_;
                        local_2.member_1[_e141.member_1] = bitcast<f32>(_e168);
                    }
                    continue;
                    continuing {
                        phi_274_ = _e139;
                        break if !(_e145);
                    }
                }
                let _e173 = local_2;
                local_4 = type_17(_e173, array<f32, 3>(bitcast<f32>(_e104), bitcast<f32>(_e114), bitcast<f32>(_e124)));
                local_1.member = array<f32, 3>(0f, 0f, 0f);
                local_1.member_1 = array<f32, 3>(0f, 0f, 0f);
                phi_394_ = type_9(0u, 3u);
                loop {
                    let _e179 = phi_394_;
                    if (_e179.member < _e179.member_1) {
                        phi_395_ = type_9((_e179.member + 1u), _e179.member_1);
                        phi_418_ = type_9(1u, _e179.member);
                    } else {
                        phi_395_ = _e179;
                        phi_418_ = type_9(0u, type_9().member_1);
                    }
                    let _e191 = phi_395_;
                    let _e193 = phi_418_;
                    let _e197 = (bitcast<i32>(_e193.member) != 0i);
                    if _e197 {
                        let _e201 = local_4.member.member[_e193.member_1];
                        let _e205 = local_4.member.member_1[_e193.member_1];
                        let _e210 = (((_e205 * 0.5f) - (_e201 * 0.5f)) * (1f / 1024f));
                        let _e213 = local_4.member_1[_e193.member_1];
                        let _e216 = local_4.member_1[_e193.member_1];
                        let _e218 = (_e213 + (_e216 * 0.00390625f));
                        if (_e210 > _e218) {
                            phi_469_ = _e210;
                        } else {
                            phi_469_ = _e218;
                        }
                        let _e221 = phi_469_;
                        if (0.000000000000000000000000000006310887f > _e221) {
                            phi_474_ = 0.000000000000000000000000000006310887f;
                        } else {
                            phi_474_ = _e221;
                        }
                        let _e224 = phi_474_;
                        local_1.member[_e193.member_1] = (_e201 * 0.25f);
                        local_1.member_1[_e193.member_1] = (1f / _e224);
                    }
                    continue;
                    continuing {
                        phi_394_ = _e191;
                        break if !(_e197);
                    }
                }
                let _e232 = local_1;
                local_3 = _e232;
                local = array<u32, 3>(0u, 0u, 0u);
                phi_515_ = type_9(0u, 3u);
                loop {
                    let _e234 = phi_515_;
                    if (_e234.member < _e234.member_1) {
                        phi_516_ = type_9((_e234.member + 1u), _e234.member_1);
                        phi_539_ = type_9(1u, _e234.member);
                    } else {
                        phi_516_ = _e234;
                        phi_539_ = type_9(0u, type_9().member_1);
                    }
                    let _e246 = phi_516_;
                    let _e248 = phi_539_;
                    let _e252 = (bitcast<i32>(_e248.member) != 0i);
                    if _e252 {
                        let _e255 = local_3.member[_e248.member_1];
                        let _e258 = local_5.member[_e248.member_1];
                        let _e263 = local_5.member_1[_e248.member_1];
                        let _e269 = local_3.member_1[_e248.member_1];
                        let _e270 = ((((_e258 * 0.25f) - _e255) + ((_e263 * 0.25f) - _e255)) * _e269);
                        if (_e270 >= 1023f) {
                            phi_600_ = 1023u;
                        } else {
                            if (_e270 > 0f) {
                                phi_599_ = select(select(u32(_e270), 0u, (_e270 < 0f)), 4294967295u, (_e270 > 4294967000f));
                            } else {
                                phi_599_ = 0u;
                            }
                            let _e279 = phi_599_;
                            phi_600_ = _e279;
                        }
                        let _e281 = phi_600_;
                        local[_e248.member_1] = _e281;
                    }
                    continue;
                    continuing {
                        phi_515_ = _e246;
                        break if !(_e252);
                    }
                }
                let _e284 = local;
                phi_619_ = (((_e284[2] << bitcast<u32>(20u)) | (_e284[1] << bitcast<u32>(10u))) | _e284[0]);
            } else {
                phi_619_ = 0u;
            }
            let _e295 = phi_619_;
            phi_620_ = _e295;
        }
        let _e327 = phi_620_;
        keys.member[_e60] = ((_e77 << bitcast<u32>(30u)) | _e327);
        order.member[_e60] = _e60;
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn interval_keys(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}

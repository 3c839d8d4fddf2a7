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

struct type_10 {
    member: array<u32>,
}

struct type_12 {
    member: u32,
    member_1: u32,
}

struct type_15 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_17 {
    member: array<type_15>,
}

struct type_20 {
    member: array<array<array<u32, 2>, 6>>,
}

struct type_21 {
    member: u32,
}

struct type_22 {
    member: type_7,
    member_1: type_8,
    member_2: type_21,
}

struct type_23 {
    member: type_22,
}

struct type_25 {
    member: array<array<u32, 3>>,
}

struct type_28 {
    member: array<atomic<u32>>,
}

@group(0) @binding(3) 
var<storage> bodies: type_10;
@group(0) @binding(4) 
var<storage> keys: type_20;
@group(0) @binding(5) 
var<storage> input: type_10;
@group(0) @binding(6) 
var<storage, read_write> output: type_28;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(0) 
var<storage> params: type_23;
@group(0) @binding(1) 
var<storage> boxes: type_17;
@group(0) @binding(2) 
var<storage> elements: type_25;

fn function_(param: array<u32, 2>, param_1: array<u32, 2>) -> array<u32, 2> {
    var phi_105_: bool;
    var phi_106_: bool;
    var phi_110_: array<u32, 2>;

    if (param[1] > param_1[1]) {
        phi_106_ = true;
    } else {
        if (param[1] == param_1[1]) {
            phi_105_ = (param[0] > param_1[0]);
        } else {
            phi_105_ = false;
        }
        let _e14 = phi_105_;
        phi_106_ = _e14;
    }
    let _e16 = phi_106_;
    if _e16 {
        phi_110_ = param_1;
    } else {
        phi_110_ = param;
    }
    let _e18 = phi_110_;
    return _e18;
}

fn function_1(param_2: array<u32, 2>, param_3: array<u32, 2>) -> array<u32, 2> {
    var phi_129_: bool;
    var phi_130_: bool;
    var phi_134_: array<u32, 2>;

    if (param_3[1] > param_2[1]) {
        phi_130_ = true;
    } else {
        if (param_3[1] == param_2[1]) {
            phi_129_ = (param_3[0] > param_2[0]);
        } else {
            phi_129_ = false;
        }
        let _e14 = phi_129_;
        phi_130_ = _e14;
    }
    let _e16 = phi_130_;
    if _e16 {
        phi_134_ = param_3;
    } else {
        phi_134_ = param_2;
    }
    let _e18 = phi_134_;
    return _e18;
}

fn function_2(param_4: array<u32, 2>, param_5: array<u32, 2>) -> array<u32, 2> {
    var phi_153_: bool;
    var phi_154_: bool;
    var phi_158_: array<u32, 2>;

    if (param_4[1] > param_5[1]) {
        phi_154_ = true;
    } else {
        if (param_4[1] == param_5[1]) {
            phi_153_ = (param_4[0] > param_5[0]);
        } else {
            phi_153_ = false;
        }
        let _e14 = phi_153_;
        phi_154_ = _e14;
    }
    let _e16 = phi_154_;
    if _e16 {
        phi_158_ = param_5;
    } else {
        phi_158_ = param_4;
    }
    let _e18 = phi_158_;
    return _e18;
}

fn function_3(param_6: array<u32, 2>, param_7: array<u32, 2>) -> array<u32, 2> {
    var phi_177_: bool;
    var phi_178_: bool;
    var phi_182_: array<u32, 2>;

    if (param_7[1] > param_6[1]) {
        phi_178_ = true;
    } else {
        if (param_7[1] == param_6[1]) {
            phi_177_ = (param_7[0] > param_6[0]);
        } else {
            phi_177_ = false;
        }
        let _e14 = phi_177_;
        phi_178_ = _e14;
    }
    let _e16 = phi_178_;
    if _e16 {
        phi_182_ = param_7;
    } else {
        phi_182_ = param_6;
    }
    let _e18 = phi_182_;
    return _e18;
}

fn function_4(param_8: array<u32, 2>, param_9: array<u32, 2>) -> array<u32, 2> {
    var phi_201_: bool;
    var phi_202_: bool;
    var phi_206_: array<u32, 2>;

    if (param_8[1] > param_9[1]) {
        phi_202_ = true;
    } else {
        if (param_8[1] == param_9[1]) {
            phi_201_ = (param_8[0] > param_9[0]);
        } else {
            phi_201_ = false;
        }
        let _e14 = phi_201_;
        phi_202_ = _e14;
    }
    let _e16 = phi_202_;
    if _e16 {
        phi_206_ = param_9;
    } else {
        phi_206_ = param_8;
    }
    let _e18 = phi_206_;
    return _e18;
}

fn function_5(param_10: array<u32, 2>, param_11: array<u32, 2>) -> array<u32, 2> {
    var phi_225_: bool;
    var phi_226_: bool;
    var phi_230_: array<u32, 2>;

    if (param_11[1] > param_10[1]) {
        phi_226_ = true;
    } else {
        if (param_11[1] == param_10[1]) {
            phi_225_ = (param_11[0] > param_10[0]);
        } else {
            phi_225_ = false;
        }
        let _e14 = phi_225_;
        phi_226_ = _e14;
    }
    let _e16 = phi_226_;
    if _e16 {
        phi_230_ = param_11;
    } else {
        phi_230_ = param_10;
    }
    let _e18 = phi_230_;
    return _e18;
}

fn function_6(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_272_: u32;
    var phi_282_: u32;
    var phi_289_: u32;
    var phi_305_: u32;
    var phi_326_: u32;
    var phi_327_: u32;
    var phi_330_: type_12;
    var phi_331_: type_12;
    var phi_354_: type_12;
    var phi_475_: bool;
    var phi_482_: bool;
    var phi_490_: bool;
    var phi_511_: bool;
    var phi_512_: bool;
    var phi_557_: bool;
    var phi_564_: bool;
    var phi_568_: bool;
    var phi_701_: bool;
    var phi_702_: bool;
    var phi_792_: bool;
    var phi_793_: bool;
    var phi_884_: bool;
    var phi_885_: bool;
    var phi_975_: bool;
    var phi_976_: bool;
    var phi_1068_: bool;
    var phi_1069_: bool;
    var phi_1159_: bool;
    var phi_1160_: bool;
    var phi_1164_: bool;
    var phi_1165_: bool;
    var phi_1166_: bool;
    var phi_1170_: bool;
    var phi_1171_: bool;
    var phi_1172_: bool;
    var phi_1173_: bool;
    var phi_1174_: bool;
    var phi_1178_: bool;
    var phi_1190_: u32;
    var phi_1191_: bool;
    var phi_1192_: u32;
    var phi_1193_: bool;
    var phi_1194_: type_12;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e25 = id_2;
    let _e26 = n_2;
    let _e27 = lane_2;
    let _e39 = ((_e25.y * _e26.x) + _e25.x);
    let _e42 = (_e26.x * _e26.y);
    let _e45 = params.member.member_1.member_2;
    let _e47 = input.member[0u];
    if (_e45 < _e47) {
        phi_272_ = _e45;
    } else {
        phi_272_ = _e47;
    }
    let _e50 = phi_272_;
    let _e52 = params.member.member_1.member_1;
    if (_e50 > _e52) {
        let _e55 = params.member.member_1.member_1;
        phi_282_ = (_e50 - _e55);
    } else {
        phi_282_ = 0u;
    }
    let _e58 = phi_282_;
    let _e60 = params.member.member_1.member;
    if (_e60 < _e58) {
        phi_289_ = _e60;
    } else {
        phi_289_ = _e58;
    }
    let _e63 = phi_289_;
    let _e64 = (_e63 / 128u);
    if ((_e63 % 128u) > 0u) {
        phi_305_ = (_e64 + 1u);
    } else {
        phi_305_ = _e64;
    }
    let _e69 = phi_305_;
    if (_e69 > _e39) {
        let _e71 = (_e69 - _e39);
        if (_e42 == 0u) {
            return;
        }
        let _e73 = (_e71 / _e42);
        if (_e42 == 0u) {
            return;
        }
        if ((_e71 % _e42) > 0u) {
            phi_326_ = (_e73 + 1u);
        } else {
            phi_326_ = _e73;
        }
        let _e79 = phi_326_;
        phi_327_ = _e79;
    } else {
        phi_327_ = 0u;
    }
    let _e81 = phi_327_;
    phi_330_ = type_12(0u, _e81);
    loop {
        let _e84 = phi_330_;
        if (_e84.member < _e84.member_1) {
            phi_331_ = type_12((_e84.member + 1u), _e84.member_1);
            phi_354_ = type_12(1u, _e84.member);
        } else {
            phi_331_ = _e84;
            phi_354_ = type_12(0u, type_12().member_1);
        }
        let _e96 = phi_331_;
        let _e98 = phi_354_;
        let _e102 = (bitcast<i32>(_e98.member) != 0i);
        if _e102 {
            let _e106 = (((_e39 + (_e98.member_1 * _e42)) * 128u) + _e27);
            if (_e27 == 0u) {
                atomicStore((&counters[0u]), 0u);
                atomicStore((&counters[1u]), 0u);
            }
            workgroupBarrier();
            if (_e106 < _e63) {
                let _e112 = params.member.member_1.member_1;
                let _e114 = (2u * (_e112 + _e106));
                let _e117 = input.member[(4u + _e114)];
                let _e120 = input.member[(_e114 + 5u)];
                let _e123 = elements.member[_e120];
                let _e127 = params.member.member.member_2[2u];
                let _e130 = boxes.member[_e117];
                let _e132 = boxes.member[(_e127 + _e120)];
                let _e135 = params.member.member.member_1;
                if ((_e135 & 1u) != 0u) {
                    if (_e123[0] == _e117) {
                        phi_475_ = true;
                    } else {
                        phi_475_ = (_e123[0] == _e117);
                    }
                    let _e142 = phi_475_;
                    if (_e123[1] == _e117) {
                        phi_482_ = true;
                    } else {
                        phi_482_ = (_e123[1] == _e117);
                    }
                    let _e147 = phi_482_;
                    if (_e123[2] == _e117) {
                        phi_490_ = true;
                    } else {
                        phi_490_ = (_e123[2] == _e117);
                    }
                    let _e153 = phi_490_;
                    if ((_e142 || _e147) || _e153) {
                        phi_511_ = false;
                    } else {
                        phi_511_ = true;
                    }
                    let _e156 = phi_511_;
                    phi_512_ = _e156;
                } else {
                    phi_512_ = true;
                }
                let _e158 = phi_512_;
                if _e158 {
                    let _e160 = params.member.member.member_1;
                    if ((_e160 & 2u) != 0u) {
                        let _e164 = params.member.member.member_1;
                        let _e168 = bodies.member[_e117];
                        let _e171 = bodies.member[_e123[0]];
                        if ((_e168 / 2u) != (_e171 / 2u)) {
                            phi_557_ = true;
                        } else {
                            phi_557_ = ((_e164 & 4u) != 0u);
                        }
                        let _e176 = phi_557_;
                        if _e176 {
                            phi_564_ = (((_e168 & _e171) & 1u) == 0u);
                        } else {
                            phi_564_ = false;
                        }
                        let _e181 = phi_564_;
                        phi_568_ = _e181;
                    } else {
                        phi_568_ = true;
                    }
                    let _e183 = phi_568_;
                    if _e183 {
                        let _e185 = params.member.member.member_1;
                        if ((_e185 & 32u) != 0u) {
                            let _e189 = params.member.member.member_6;
                            let _e230 = (((((_e130.member_1[0] - _e132.member[0]) > _e189) && ((_e132.member_1[0] - _e130.member[0]) > _e189)) && (((_e130.member_1[1] - _e132.member[1]) > _e189) && ((_e132.member_1[1] - _e130.member[1]) > _e189))) && (((_e130.member_1[2] - _e132.member[2]) > _e189) && ((_e132.member_1[2] - _e130.member[2]) > _e189)));
                            if _e230 {
                                phi_1164_ = bool();
                            } else {
                                let _e232 = keys.member[_e117];
                                let _e235 = keys.member[_e117];
                                let _e237 = function_(_e232[0], _e235[0]);
                                let _e239 = keys.member[_e117];
                                let _e241 = function_(_e237, _e239[0]);
                                let _e244 = keys.member[_e123[0]];
                                let _e248 = keys.member[_e123[1]];
                                let _e250 = function_1(_e244[3], _e248[3]);
                                let _e253 = keys.member[_e123[2]];
                                let _e255 = function_1(_e250, _e253[3]);
                                if (_e241[1] > _e255[1]) {
                                    phi_702_ = true;
                                } else {
                                    if (_e241[1] == _e255[1]) {
                                        phi_701_ = (_e241[0] > _e255[0]);
                                    } else {
                                        phi_701_ = false;
                                    }
                                    let _e266 = phi_701_;
                                    phi_702_ = _e266;
                                }
                                let _e268 = phi_702_;
                                let _e272 = keys.member[_e123[0]];
                                let _e276 = keys.member[_e123[1]];
                                let _e278 = function_(_e272[0], _e276[0]);
                                let _e281 = keys.member[_e123[2]];
                                let _e283 = function_(_e278, _e281[0]);
                                let _e285 = keys.member[_e117];
                                let _e288 = keys.member[_e117];
                                let _e290 = function_1(_e285[3], _e288[3]);
                                let _e292 = keys.member[_e117];
                                let _e294 = function_1(_e290, _e292[3]);
                                if (_e283[1] > _e294[1]) {
                                    phi_793_ = true;
                                } else {
                                    if (_e283[1] == _e294[1]) {
                                        phi_792_ = (_e283[0] > _e294[0]);
                                    } else {
                                        phi_792_ = false;
                                    }
                                    let _e305 = phi_792_;
                                    phi_793_ = _e305;
                                }
                                let _e307 = phi_793_;
                                let _e311 = keys.member[_e117];
                                let _e314 = keys.member[_e117];
                                let _e316 = function_2(_e311[1], _e314[1]);
                                let _e318 = keys.member[_e117];
                                let _e320 = function_2(_e316, _e318[1]);
                                let _e323 = keys.member[_e123[0]];
                                let _e327 = keys.member[_e123[1]];
                                let _e329 = function_3(_e323[4], _e327[4]);
                                let _e332 = keys.member[_e123[2]];
                                let _e334 = function_3(_e329, _e332[4]);
                                if (_e320[1] > _e334[1]) {
                                    phi_885_ = true;
                                } else {
                                    if (_e320[1] == _e334[1]) {
                                        phi_884_ = (_e320[0] > _e334[0]);
                                    } else {
                                        phi_884_ = false;
                                    }
                                    let _e345 = phi_884_;
                                    phi_885_ = _e345;
                                }
                                let _e347 = phi_885_;
                                let _e351 = keys.member[_e123[0]];
                                let _e355 = keys.member[_e123[1]];
                                let _e357 = function_2(_e351[1], _e355[1]);
                                let _e360 = keys.member[_e123[2]];
                                let _e362 = function_2(_e357, _e360[1]);
                                let _e364 = keys.member[_e117];
                                let _e367 = keys.member[_e117];
                                let _e369 = function_3(_e364[4], _e367[4]);
                                let _e371 = keys.member[_e117];
                                let _e373 = function_3(_e369, _e371[4]);
                                if (_e362[1] > _e373[1]) {
                                    phi_976_ = true;
                                } else {
                                    if (_e362[1] == _e373[1]) {
                                        phi_975_ = (_e362[0] > _e373[0]);
                                    } else {
                                        phi_975_ = false;
                                    }
                                    let _e384 = phi_975_;
                                    phi_976_ = _e384;
                                }
                                let _e386 = phi_976_;
                                let _e391 = keys.member[_e117];
                                let _e394 = keys.member[_e117];
                                let _e396 = function_4(_e391[2], _e394[2]);
                                let _e398 = keys.member[_e117];
                                let _e400 = function_4(_e396, _e398[2]);
                                let _e403 = keys.member[_e123[0]];
                                let _e407 = keys.member[_e123[1]];
                                let _e409 = function_5(_e403[5], _e407[5]);
                                let _e412 = keys.member[_e123[2]];
                                let _e414 = function_5(_e409, _e412[5]);
                                if (_e400[1] > _e414[1]) {
                                    phi_1069_ = true;
                                } else {
                                    if (_e400[1] == _e414[1]) {
                                        phi_1068_ = (_e400[0] > _e414[0]);
                                    } else {
                                        phi_1068_ = false;
                                    }
                                    let _e425 = phi_1068_;
                                    phi_1069_ = _e425;
                                }
                                let _e427 = phi_1069_;
                                let _e431 = keys.member[_e123[0]];
                                let _e435 = keys.member[_e123[1]];
                                let _e437 = function_4(_e431[2], _e435[2]);
                                let _e440 = keys.member[_e123[2]];
                                let _e442 = function_4(_e437, _e440[2]);
                                let _e444 = keys.member[_e117];
                                let _e447 = keys.member[_e117];
                                let _e449 = function_5(_e444[5], _e447[5]);
                                let _e451 = keys.member[_e117];
                                let _e453 = function_5(_e449, _e451[5]);
                                if (_e442[1] > _e453[1]) {
                                    phi_1160_ = true;
                                } else {
                                    if (_e442[1] == _e453[1]) {
                                        phi_1159_ = (_e442[0] > _e453[0]);
                                    } else {
                                        phi_1159_ = false;
                                    }
                                    let _e464 = phi_1159_;
                                    phi_1160_ = _e464;
                                }
                                let _e466 = phi_1160_;
                                phi_1164_ = (((!(_e268) && !(_e307)) && (!(_e347) && !(_e386))) && (!(_e427) && !(_e466)));
                            }
                            let _e471 = phi_1164_;
                            phi_1165_ = _e471;
                            phi_1166_ = _e230;
                        } else {
                            phi_1165_ = bool();
                            phi_1166_ = true;
                        }
                        let _e473 = phi_1165_;
                        let _e475 = phi_1166_;
                        if _e475 {
                            phi_1170_ = false;
                        } else {
                            phi_1170_ = true;
                        }
                        let _e477 = phi_1170_;
                        phi_1171_ = _e473;
                        phi_1172_ = _e477;
                    } else {
                        phi_1171_ = false;
                        phi_1172_ = true;
                    }
                    let _e479 = phi_1171_;
                    let _e481 = phi_1172_;
                    phi_1173_ = _e479;
                    phi_1174_ = _e481;
                } else {
                    phi_1173_ = false;
                    phi_1174_ = true;
                }
                let _e483 = phi_1173_;
                let _e485 = phi_1174_;
                if _e485 {
                    phi_1178_ = _e483;
                } else {
                    phi_1178_ = true;
                }
                let _e487 = phi_1178_;
                if _e487 {
                    let _e489 = atomicAdd((&counters[1u]), 1u);
                    let _e491 = atomicAdd((&counters[0u]), 1u);
                    phi_1190_ = _e491;
                    phi_1191_ = true;
                } else {
                    phi_1190_ = 0u;
                    phi_1191_ = false;
                }
                let _e493 = phi_1190_;
                let _e495 = phi_1191_;
                phi_1192_ = _e493;
                phi_1193_ = _e495;
                phi_1194_ = type_12(_e117, _e120);
            } else {
                phi_1192_ = 0u;
                phi_1193_ = false;
                phi_1194_ = type_12(0u, 0u);
            }
            let _e497 = phi_1192_;
            let _e499 = phi_1193_;
            let _e501 = phi_1194_;
            workgroupBarrier();
            if (_e27 == 0u) {
                let _e504 = atomicLoad((&counters[0u]));
                let _e506 = atomicLoad((&counters[1u]));
                if (_e504 > 0u) {
                    let _e509 = atomicAdd((&output.member[0u]), _e504);
                    if ((_e509 + _e504) < _e509) {
                        let _e513 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[2u]), _e509);
                }
                if (_e506 > 0u) {
                    let _e517 = atomicAdd((&output.member[1u]), _e506);
                    if ((_e517 + _e506) < _e517) {
                        let _e521 = atomicAdd((&output.member[3u]), 1u);
                    }
                }
            }
            workgroupBarrier();
            if _e499 {
                let _e523 = params.member.member_1.member_3;
                let _e525 = atomicLoad((&counters[2u]));
                let _e526 = (_e525 + _e497);
                if (_e526 < _e523) {
                    let _e530 = (2u * _e526);
                    atomicStore((&output.member[(4u + _e530)]), _e501.member);
                    atomicStore((&output.member[(_e530 + 5u)]), _e501.member_1);
                }
            }
        }
        continue;
        continuing {
            phi_330_ = _e96;
            break if !(_e102);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn list_listed_vertex_face(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_6(id, n, lane);
}

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
    member: array<array<u32, 2>>,
}

struct type_17 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_19 {
    member: array<type_17>,
}

struct type_22 {
    member: array<array<array<u32, 2>, 6>>,
}

struct type_23 {
    member: u32,
}

struct type_24 {
    member: type_7,
    member_1: type_8,
    member_2: type_23,
}

struct type_25 {
    member: type_24,
}

struct type_28 {
    member: array<atomic<u32>>,
}

@group(0) @binding(3) 
var<storage> bodies: type_10;
@group(0) @binding(4) 
var<storage> keys: type_22;
@group(0) @binding(5) 
var<storage> input: type_10;
@group(0) @binding(6) 
var<storage, read_write> output: type_28;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(0) 
var<storage> params: type_25;
@group(0) @binding(1) 
var<storage> boxes: type_19;
@group(0) @binding(2) 
var<storage> elements: type_15;

fn function_(param: array<u32, 2>, param_1: array<u32, 2>) -> array<u32, 2> {
    var phi_104_: bool;
    var phi_105_: bool;
    var phi_109_: array<u32, 2>;

    if (param[1] > param_1[1]) {
        phi_105_ = true;
    } else {
        if (param[1] == param_1[1]) {
            phi_104_ = (param[0] > param_1[0]);
        } else {
            phi_104_ = false;
        }
        let _e14 = phi_104_;
        phi_105_ = _e14;
    }
    let _e16 = phi_105_;
    if _e16 {
        phi_109_ = param_1;
    } else {
        phi_109_ = param;
    }
    let _e18 = phi_109_;
    return _e18;
}

fn function_1(param_2: array<u32, 2>, param_3: array<u32, 2>) -> array<u32, 2> {
    var phi_128_: bool;
    var phi_129_: bool;
    var phi_133_: array<u32, 2>;

    if (param_3[1] > param_2[1]) {
        phi_129_ = true;
    } else {
        if (param_3[1] == param_2[1]) {
            phi_128_ = (param_3[0] > param_2[0]);
        } else {
            phi_128_ = false;
        }
        let _e14 = phi_128_;
        phi_129_ = _e14;
    }
    let _e16 = phi_129_;
    if _e16 {
        phi_133_ = param_3;
    } else {
        phi_133_ = param_2;
    }
    let _e18 = phi_133_;
    return _e18;
}

fn function_2(param_4: array<u32, 2>, param_5: array<u32, 2>) -> array<u32, 2> {
    var phi_152_: bool;
    var phi_153_: bool;
    var phi_157_: array<u32, 2>;

    if (param_4[1] > param_5[1]) {
        phi_153_ = true;
    } else {
        if (param_4[1] == param_5[1]) {
            phi_152_ = (param_4[0] > param_5[0]);
        } else {
            phi_152_ = false;
        }
        let _e14 = phi_152_;
        phi_153_ = _e14;
    }
    let _e16 = phi_153_;
    if _e16 {
        phi_157_ = param_5;
    } else {
        phi_157_ = param_4;
    }
    let _e18 = phi_157_;
    return _e18;
}

fn function_3(param_6: array<u32, 2>, param_7: array<u32, 2>) -> array<u32, 2> {
    var phi_176_: bool;
    var phi_177_: bool;
    var phi_181_: array<u32, 2>;

    if (param_7[1] > param_6[1]) {
        phi_177_ = true;
    } else {
        if (param_7[1] == param_6[1]) {
            phi_176_ = (param_7[0] > param_6[0]);
        } else {
            phi_176_ = false;
        }
        let _e14 = phi_176_;
        phi_177_ = _e14;
    }
    let _e16 = phi_177_;
    if _e16 {
        phi_181_ = param_7;
    } else {
        phi_181_ = param_6;
    }
    let _e18 = phi_181_;
    return _e18;
}

fn function_4(param_8: array<u32, 2>, param_9: array<u32, 2>) -> array<u32, 2> {
    var phi_200_: bool;
    var phi_201_: bool;
    var phi_205_: array<u32, 2>;

    if (param_8[1] > param_9[1]) {
        phi_201_ = true;
    } else {
        if (param_8[1] == param_9[1]) {
            phi_200_ = (param_8[0] > param_9[0]);
        } else {
            phi_200_ = false;
        }
        let _e14 = phi_200_;
        phi_201_ = _e14;
    }
    let _e16 = phi_201_;
    if _e16 {
        phi_205_ = param_9;
    } else {
        phi_205_ = param_8;
    }
    let _e18 = phi_205_;
    return _e18;
}

fn function_5(param_10: array<u32, 2>, param_11: array<u32, 2>) -> array<u32, 2> {
    var phi_224_: bool;
    var phi_225_: bool;
    var phi_229_: array<u32, 2>;

    if (param_11[1] > param_10[1]) {
        phi_225_ = true;
    } else {
        if (param_11[1] == param_10[1]) {
            phi_224_ = (param_11[0] > param_10[0]);
        } else {
            phi_224_ = false;
        }
        let _e14 = phi_224_;
        phi_225_ = _e14;
    }
    let _e16 = phi_225_;
    if _e16 {
        phi_229_ = param_11;
    } else {
        phi_229_ = param_10;
    }
    let _e18 = phi_229_;
    return _e18;
}

fn function_6(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_271_: u32;
    var phi_281_: u32;
    var phi_288_: u32;
    var phi_304_: u32;
    var phi_325_: u32;
    var phi_326_: u32;
    var phi_329_: type_12;
    var phi_330_: type_12;
    var phi_353_: type_12;
    var phi_508_: bool;
    var phi_514_: bool;
    var phi_520_: bool;
    var phi_521_: bool;
    var phi_565_: bool;
    var phi_572_: bool;
    var phi_576_: bool;
    var phi_706_: bool;
    var phi_707_: bool;
    var phi_794_: bool;
    var phi_795_: bool;
    var phi_883_: bool;
    var phi_884_: bool;
    var phi_971_: bool;
    var phi_972_: bool;
    var phi_1061_: bool;
    var phi_1062_: bool;
    var phi_1149_: bool;
    var phi_1150_: bool;
    var phi_1154_: bool;
    var phi_1155_: bool;
    var phi_1156_: bool;
    var phi_1160_: bool;
    var phi_1161_: bool;
    var phi_1162_: bool;
    var phi_1163_: bool;
    var phi_1164_: bool;
    var phi_1168_: bool;
    var phi_1180_: u32;
    var phi_1181_: bool;
    var phi_1182_: u32;
    var phi_1183_: bool;
    var phi_1184_: type_12;
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
        phi_271_ = _e45;
    } else {
        phi_271_ = _e47;
    }
    let _e50 = phi_271_;
    let _e52 = params.member.member_1.member_1;
    if (_e50 > _e52) {
        let _e55 = params.member.member_1.member_1;
        phi_281_ = (_e50 - _e55);
    } else {
        phi_281_ = 0u;
    }
    let _e58 = phi_281_;
    let _e60 = params.member.member_1.member;
    if (_e60 < _e58) {
        phi_288_ = _e60;
    } else {
        phi_288_ = _e58;
    }
    let _e63 = phi_288_;
    let _e64 = (_e63 / 128u);
    if ((_e63 % 128u) > 0u) {
        phi_304_ = (_e64 + 1u);
    } else {
        phi_304_ = _e64;
    }
    let _e69 = phi_304_;
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
            phi_325_ = (_e73 + 1u);
        } else {
            phi_325_ = _e73;
        }
        let _e79 = phi_325_;
        phi_326_ = _e79;
    } else {
        phi_326_ = 0u;
    }
    let _e81 = phi_326_;
    phi_329_ = type_12(0u, _e81);
    loop {
        let _e84 = phi_329_;
        if (_e84.member < _e84.member_1) {
            phi_330_ = type_12((_e84.member + 1u), _e84.member_1);
            phi_353_ = type_12(1u, _e84.member);
        } else {
            phi_330_ = _e84;
            phi_353_ = type_12(0u, type_12().member_1);
        }
        let _e96 = phi_330_;
        let _e98 = phi_353_;
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
                let _e123 = elements.member[_e117];
                let _e125 = elements.member[_e120];
                let _e135 = params.member.member.member_2[1u];
                let _e139 = params.member.member.member_2[1u];
                let _e142 = boxes.member[(_e135 + _e117)];
                let _e144 = boxes.member[(_e139 + _e120)];
                let _e147 = params.member.member.member_1;
                if ((_e147 & 1u) != 0u) {
                    if (_e125[0] == _e123[0]) {
                        phi_508_ = true;
                    } else {
                        phi_508_ = (_e125[0] == _e123[1]);
                    }
                    let _e153 = phi_508_;
                    if (_e125[1] == _e123[0]) {
                        phi_514_ = true;
                    } else {
                        phi_514_ = (_e125[1] == _e123[1]);
                    }
                    let _e157 = phi_514_;
                    if (_e153 || _e157) {
                        phi_520_ = false;
                    } else {
                        phi_520_ = true;
                    }
                    let _e160 = phi_520_;
                    phi_521_ = _e160;
                } else {
                    phi_521_ = true;
                }
                let _e162 = phi_521_;
                if _e162 {
                    let _e164 = params.member.member.member_1;
                    if ((_e164 & 2u) != 0u) {
                        let _e168 = params.member.member.member_1;
                        let _e172 = bodies.member[_e123[0]];
                        let _e174 = bodies.member[_e125[0]];
                        if ((_e172 / 2u) != (_e174 / 2u)) {
                            phi_565_ = true;
                        } else {
                            phi_565_ = ((_e168 & 4u) != 0u);
                        }
                        let _e179 = phi_565_;
                        if _e179 {
                            phi_572_ = (((_e172 & _e174) & 1u) == 0u);
                        } else {
                            phi_572_ = false;
                        }
                        let _e184 = phi_572_;
                        phi_576_ = _e184;
                    } else {
                        phi_576_ = true;
                    }
                    let _e186 = phi_576_;
                    if _e186 {
                        let _e188 = params.member.member.member_1;
                        if ((_e188 & 32u) != 0u) {
                            let _e192 = params.member.member.member_6;
                            let _e233 = (((((_e142.member_1[0] - _e144.member[0]) > _e192) && ((_e144.member_1[0] - _e142.member[0]) > _e192)) && (((_e142.member_1[1] - _e144.member[1]) > _e192) && ((_e144.member_1[1] - _e142.member[1]) > _e192))) && (((_e142.member_1[2] - _e144.member[2]) > _e192) && ((_e144.member_1[2] - _e142.member[2]) > _e192)));
                            if _e233 {
                                phi_1154_ = bool();
                            } else {
                                let _e235 = keys.member[_e123[0]];
                                let _e238 = keys.member[_e123[1]];
                                let _e240 = function_(_e235[0], _e238[0]);
                                let _e242 = keys.member[_e123[1]];
                                let _e244 = function_(_e240, _e242[0]);
                                let _e246 = keys.member[_e125[0]];
                                let _e249 = keys.member[_e125[1]];
                                let _e251 = function_1(_e246[3], _e249[3]);
                                let _e253 = keys.member[_e125[1]];
                                let _e255 = function_1(_e251, _e253[3]);
                                if (_e244[1] > _e255[1]) {
                                    phi_707_ = true;
                                } else {
                                    if (_e244[1] == _e255[1]) {
                                        phi_706_ = (_e244[0] > _e255[0]);
                                    } else {
                                        phi_706_ = false;
                                    }
                                    let _e266 = phi_706_;
                                    phi_707_ = _e266;
                                }
                                let _e268 = phi_707_;
                                let _e271 = keys.member[_e125[0]];
                                let _e274 = keys.member[_e125[1]];
                                let _e276 = function_(_e271[0], _e274[0]);
                                let _e278 = keys.member[_e125[1]];
                                let _e280 = function_(_e276, _e278[0]);
                                let _e282 = keys.member[_e123[0]];
                                let _e285 = keys.member[_e123[1]];
                                let _e287 = function_1(_e282[3], _e285[3]);
                                let _e289 = keys.member[_e123[1]];
                                let _e291 = function_1(_e287, _e289[3]);
                                if (_e280[1] > _e291[1]) {
                                    phi_795_ = true;
                                } else {
                                    if (_e280[1] == _e291[1]) {
                                        phi_794_ = (_e280[0] > _e291[0]);
                                    } else {
                                        phi_794_ = false;
                                    }
                                    let _e302 = phi_794_;
                                    phi_795_ = _e302;
                                }
                                let _e304 = phi_795_;
                                let _e308 = keys.member[_e123[0]];
                                let _e311 = keys.member[_e123[1]];
                                let _e313 = function_2(_e308[1], _e311[1]);
                                let _e315 = keys.member[_e123[1]];
                                let _e317 = function_2(_e313, _e315[1]);
                                let _e319 = keys.member[_e125[0]];
                                let _e322 = keys.member[_e125[1]];
                                let _e324 = function_3(_e319[4], _e322[4]);
                                let _e326 = keys.member[_e125[1]];
                                let _e328 = function_3(_e324, _e326[4]);
                                if (_e317[1] > _e328[1]) {
                                    phi_884_ = true;
                                } else {
                                    if (_e317[1] == _e328[1]) {
                                        phi_883_ = (_e317[0] > _e328[0]);
                                    } else {
                                        phi_883_ = false;
                                    }
                                    let _e339 = phi_883_;
                                    phi_884_ = _e339;
                                }
                                let _e341 = phi_884_;
                                let _e344 = keys.member[_e125[0]];
                                let _e347 = keys.member[_e125[1]];
                                let _e349 = function_2(_e344[1], _e347[1]);
                                let _e351 = keys.member[_e125[1]];
                                let _e353 = function_2(_e349, _e351[1]);
                                let _e355 = keys.member[_e123[0]];
                                let _e358 = keys.member[_e123[1]];
                                let _e360 = function_3(_e355[4], _e358[4]);
                                let _e362 = keys.member[_e123[1]];
                                let _e364 = function_3(_e360, _e362[4]);
                                if (_e353[1] > _e364[1]) {
                                    phi_972_ = true;
                                } else {
                                    if (_e353[1] == _e364[1]) {
                                        phi_971_ = (_e353[0] > _e364[0]);
                                    } else {
                                        phi_971_ = false;
                                    }
                                    let _e375 = phi_971_;
                                    phi_972_ = _e375;
                                }
                                let _e377 = phi_972_;
                                let _e382 = keys.member[_e123[0]];
                                let _e385 = keys.member[_e123[1]];
                                let _e387 = function_4(_e382[2], _e385[2]);
                                let _e389 = keys.member[_e123[1]];
                                let _e391 = function_4(_e387, _e389[2]);
                                let _e393 = keys.member[_e125[0]];
                                let _e396 = keys.member[_e125[1]];
                                let _e398 = function_5(_e393[5], _e396[5]);
                                let _e400 = keys.member[_e125[1]];
                                let _e402 = function_5(_e398, _e400[5]);
                                if (_e391[1] > _e402[1]) {
                                    phi_1062_ = true;
                                } else {
                                    if (_e391[1] == _e402[1]) {
                                        phi_1061_ = (_e391[0] > _e402[0]);
                                    } else {
                                        phi_1061_ = false;
                                    }
                                    let _e413 = phi_1061_;
                                    phi_1062_ = _e413;
                                }
                                let _e415 = phi_1062_;
                                let _e418 = keys.member[_e125[0]];
                                let _e421 = keys.member[_e125[1]];
                                let _e423 = function_4(_e418[2], _e421[2]);
                                let _e425 = keys.member[_e125[1]];
                                let _e427 = function_4(_e423, _e425[2]);
                                let _e429 = keys.member[_e123[0]];
                                let _e432 = keys.member[_e123[1]];
                                let _e434 = function_5(_e429[5], _e432[5]);
                                let _e436 = keys.member[_e123[1]];
                                let _e438 = function_5(_e434, _e436[5]);
                                if (_e427[1] > _e438[1]) {
                                    phi_1150_ = true;
                                } else {
                                    if (_e427[1] == _e438[1]) {
                                        phi_1149_ = (_e427[0] > _e438[0]);
                                    } else {
                                        phi_1149_ = false;
                                    }
                                    let _e449 = phi_1149_;
                                    phi_1150_ = _e449;
                                }
                                let _e451 = phi_1150_;
                                phi_1154_ = (((!(_e268) && !(_e304)) && (!(_e341) && !(_e377))) && (!(_e415) && !(_e451)));
                            }
                            let _e456 = phi_1154_;
                            phi_1155_ = _e456;
                            phi_1156_ = _e233;
                        } else {
                            phi_1155_ = bool();
                            phi_1156_ = true;
                        }
                        let _e458 = phi_1155_;
                        let _e460 = phi_1156_;
                        if _e460 {
                            phi_1160_ = false;
                        } else {
                            phi_1160_ = true;
                        }
                        let _e462 = phi_1160_;
                        phi_1161_ = _e458;
                        phi_1162_ = _e462;
                    } else {
                        phi_1161_ = false;
                        phi_1162_ = true;
                    }
                    let _e464 = phi_1161_;
                    let _e466 = phi_1162_;
                    phi_1163_ = _e464;
                    phi_1164_ = _e466;
                } else {
                    phi_1163_ = false;
                    phi_1164_ = true;
                }
                let _e468 = phi_1163_;
                let _e470 = phi_1164_;
                if _e470 {
                    phi_1168_ = _e468;
                } else {
                    phi_1168_ = true;
                }
                let _e472 = phi_1168_;
                if _e472 {
                    let _e474 = atomicAdd((&counters[1u]), 1u);
                    let _e476 = atomicAdd((&counters[0u]), 1u);
                    phi_1180_ = _e476;
                    phi_1181_ = true;
                } else {
                    phi_1180_ = 0u;
                    phi_1181_ = false;
                }
                let _e478 = phi_1180_;
                let _e480 = phi_1181_;
                phi_1182_ = _e478;
                phi_1183_ = _e480;
                phi_1184_ = type_12(_e117, _e120);
            } else {
                phi_1182_ = 0u;
                phi_1183_ = false;
                phi_1184_ = type_12(0u, 0u);
            }
            let _e482 = phi_1182_;
            let _e484 = phi_1183_;
            let _e486 = phi_1184_;
            workgroupBarrier();
            if (_e27 == 0u) {
                let _e489 = atomicLoad((&counters[0u]));
                let _e491 = atomicLoad((&counters[1u]));
                if (_e489 > 0u) {
                    let _e494 = atomicAdd((&output.member[0u]), _e489);
                    if ((_e494 + _e489) < _e494) {
                        let _e498 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[2u]), _e494);
                }
                if (_e491 > 0u) {
                    let _e502 = atomicAdd((&output.member[1u]), _e491);
                    if ((_e502 + _e491) < _e502) {
                        let _e506 = atomicAdd((&output.member[3u]), 1u);
                    }
                }
            }
            workgroupBarrier();
            if _e484 {
                let _e508 = params.member.member_1.member_3;
                let _e510 = atomicLoad((&counters[2u]));
                let _e511 = (_e510 + _e482);
                if (_e511 < _e508) {
                    let _e515 = (2u * _e511);
                    atomicStore((&output.member[(4u + _e515)]), _e486.member);
                    atomicStore((&output.member[(_e515 + 5u)]), _e486.member_1);
                }
            }
        }
        continue;
        continuing {
            phi_329_ = _e96;
            break if !(_e102);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn list_listed_edge_edge(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_6(id, n, lane);
}

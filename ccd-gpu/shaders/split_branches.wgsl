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
    member: array<vec4<u32>>,
}

struct type_18 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
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
var<storage> keys: type_11;
@group(0) @binding(0) 
var<storage> params: type_20;
var<workgroup> begins: array<u32, 256>;
@group(0) @binding(2) 
var<storage> levels: type_11;
@group(0) @binding(3) 
var<storage> present: type_11;
@group(0) @binding(4) 
var<storage> table: type_11;
@group(0) @binding(5) 
var<storage> entries: type_11;
@group(0) @binding(6) 
var<storage> list: type_11;
@group(0) @binding(7) 
var<storage, read_write> branches: type_17;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<u32, 3>;
    var phi_125_: u32;
    var phi_130_: u32;
    var phi_133_: type_9;
    var phi_136_: u32;
    var phi_134_: type_9;
    var phi_159_: type_9;
    var phi_137_: u32;
    var local_1: u32;
    var phi_249_: type_9;
    var phi_252_: u32;
    var phi_250_: type_9;
    var phi_275_: type_9;
    var phi_297_: u32;
    var phi_298_: u32;
    var phi_253_: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_353_: u32;
    var phi_370_: u32;
    var phi_401_: bool;
    var phi_402_: bool;
    var phi_423_: bool;
    var phi_424_: bool;
    var phi_431_: u32;
    var phi_432_: u32;
    var phi_433_: u32;
    var phi_443_: u32;
    var phi_449_: u32;
    var phi_525_: u32;
    var phi_527_: u32;
    var phi_581_: u32;
    var phi_583_: u32;
    var phi_588_: u32;
    var phi_590_: u32;
    var phi_605_: bool;
    var phi_614_: u32;
    var phi_652_: u32;
    var phi_654_: u32;
    var phi_660_: u32;
    var phi_591_: u32;
    var phi_661_: bool;
    var local_4: u32;
    var phi_668_: u32;
    var phi_671_: u32;
    var phi_686_: bool;
    var phi_695_: u32;
    var phi_733_: u32;
    var phi_735_: u32;
    var phi_741_: u32;
    var phi_669_: u32;
    var phi_672_: u32;
    var local_5: u32;
    var local_6: u32;
    var phi_749_: bool;
    var local_7: u32;
    var local_8: u32;
    var phi_758_: u32;
    var phi_796_: u32;
    var phi_798_: u32;
    var phi_800_: u32;
    var phi_803_: u32;
    var phi_826_: u32;
    var phi_834_: bool;
    var phi_843_: u32;
    var phi_881_: u32;
    var phi_883_: u32;
    var phi_889_: u32;
    var phi_801_: u32;
    var phi_804_: u32;
    var local_9: u32;
    var local_10: u32;
    var phi_895_: u32;
    var phi_896_: u32;
    var local_11: u32;
    var local_12: u32;
    var phi_903_: u32;
    var phi_913_: u32;
    var phi_919_: u32;
    var local_13: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e31 = id_2;
    let _e32 = n_2;
    let _e33 = lane_2;
    let _e48 = ((((_e31.y * _e32.x) + _e31.x) * 256u) + _e33);
    let _e51 = params.member.member_2.member;
    let _e55 = params.member.member.member[_e51];
    let _e56 = (_e55 - 1u);
    let _e57 = (_e56 / 256u);
    if ((_e56 % 256u) > 0u) {
        phi_125_ = (_e57 + 1u);
    } else {
        phi_125_ = _e57;
    }
    let _e62 = phi_125_;
    if (96u < _e33) {
        phi_130_ = 96u;
    } else {
        phi_130_ = _e33;
    }
    let _e65 = phi_130_;
    phi_133_ = type_9(0u, _e65);
    phi_136_ = 0u;
    loop {
        let _e68 = phi_133_;
        let _e70 = phi_136_;
        local_1 = _e70;
        if (_e68.member < _e68.member_1) {
            phi_134_ = type_9((_e68.member + 1u), _e68.member_1);
            phi_159_ = type_9(1u, _e68.member);
        } else {
            phi_134_ = _e68;
            phi_159_ = type_9(0u, type_9().member_1);
        }
        let _e82 = phi_134_;
        let _e84 = phi_159_;
        let _e88 = (bitcast<i32>(_e84.member) != 0i);
        if _e88 {
            let _e92 = table.member[((256u * _e62) + _e84.member_1)];
            phi_137_ = (_e70 + _e92);
        } else {
            phi_137_ = u32();
        }
        let _e95 = phi_137_;
        continue;
        continuing {
            phi_133_ = _e82;
            phi_136_ = _e95;
            break if !(_e88);
        }
    }
    let _e99 = local_1;
    begins[_e33] = _e99;
    workgroupBarrier();
    let _e101 = list.member[0u];
    let _e104 = params.member.member_1.member_3;
    let _e105 = (_e101 <= _e104);
    if (_e48 < _e56) {
        if _e105 {
            let _e108 = levels.member[_e48];
            let _e110 = present.member[0u];
            let _e112 = present.member[1u];
            let _e114 = present.member[2u];
            local = array<u32, 3>(_e110, _e112, _e114);
            phi_249_ = type_9(0u, 3u);
            phi_252_ = 0u;
            loop {
                let _e117 = phi_249_;
                let _e119 = phi_252_;
                local_2 = _e119;
                local_3 = _e119;
                if (_e117.member < _e117.member_1) {
                    phi_250_ = type_9((_e117.member + 1u), _e117.member_1);
                    phi_275_ = type_9(1u, _e117.member);
                } else {
                    phi_250_ = _e117;
                    phi_275_ = type_9(0u, type_9().member_1);
                }
                let _e131 = phi_250_;
                let _e133 = phi_275_;
                let _e137 = (bitcast<i32>(_e133.member) != 0i);
                if _e137 {
                    let _e138 = (32u * _e133.member_1);
                    if (_e108 >= (_e138 + 32u)) {
                        phi_298_ = 4294967295u;
                    } else {
                        if (_e108 > _e138) {
                            phi_297_ = ((1u << bitcast<u32>(((_e108 - _e138) & 31u))) - 1u);
                        } else {
                            phi_297_ = 0u;
                        }
                        let _e148 = phi_297_;
                        phi_298_ = _e148;
                    }
                    let _e150 = phi_298_;
                    let _e152 = local[_e133.member_1];
                    phi_253_ = (_e119 + countOneBits((_e152 & _e150)));
                } else {
                    phi_253_ = u32();
                }
                let _e157 = phi_253_;
                continue;
                continuing {
                    phi_249_ = _e131;
                    phi_252_ = _e157;
                    break if !(_e137);
                }
            }
            let _e160 = local_2;
            let _e162 = begins[_e160];
            let _e165 = local_3;
            let _e168 = begins[(_e165 + 1u)];
            let _e171 = entries.member[_e48];
            let _e172 = (4u + _e171);
            let _e174 = list.member[_e172];
            if (_e172 > (4u + _e162)) {
                let _e178 = list.member[(_e171 + 3u)];
                phi_353_ = (_e178 + 1u);
            } else {
                phi_353_ = 0u;
            }
            let _e181 = phi_353_;
            if ((_e171 + 5u) < (4u + _e168)) {
                let _e186 = list.member[(_e171 + 5u)];
                phi_370_ = _e186;
            } else {
                phi_370_ = _e56;
            }
            let _e188 = phi_370_;
            let _e189 = (_e181 == 0u);
            let _e190 = (_e188 == _e56);
            if _e189 {
                phi_402_ = true;
            } else {
                if _e190 {
                    phi_401_ = false;
                } else {
                    let _e192 = levels.member[_e188];
                    let _e195 = levels.member[(_e181 - 1u)];
                    phi_401_ = (_e192 > _e195);
                }
                let _e198 = phi_401_;
                phi_402_ = _e198;
            }
            let _e200 = phi_402_;
            let _e202 = levels.member[_e174];
            if (_e202 != _e108) {
                phi_433_ = 4294967295u;
            } else {
                if _e189 {
                    if _e190 {
                        phi_423_ = false;
                    } else {
                        phi_423_ = true;
                    }
                    let _e205 = phi_423_;
                    phi_424_ = _e205;
                } else {
                    phi_424_ = true;
                }
                let _e207 = phi_424_;
                if _e207 {
                    if _e200 {
                        phi_431_ = _e188;
                    } else {
                        phi_431_ = _e181;
                    }
                    let _e209 = phi_431_;
                    phi_432_ = _e209;
                } else {
                    phi_432_ = 0u;
                }
                let _e211 = phi_432_;
                phi_433_ = _e211;
            }
            let _e213 = phi_433_;
            let _e214 = (_e174 + 1u);
            if (_e181 == _e174) {
                phi_443_ = (_e56 + _e181);
            } else {
                phi_443_ = _e174;
            }
            let _e218 = phi_443_;
            if (_e214 == _e188) {
                phi_449_ = (_e56 + _e214);
            } else {
                phi_449_ = _e214;
            }
            let _e222 = phi_449_;
            branches.member[_e213] = vec4<u32>(_e218, _e222, _e181, _e188);
        }
    }
    if (_e48 < _e56) {
        if _e105 {
        } else {
            let _e228 = params.member.member_2.member;
            let _e232 = params.member.member.member_2[_e228];
            if (1u < (_e55 - _e48)) {
                let _e235 = (_e48 + 1u);
                let _e238 = keys.member[(_e232 + _e48)];
                let _e241 = keys.member[(_e232 + _e235)];
                let _e242 = (_e238 ^ _e241);
                let _e247 = select((bitcast<u32>(31i) - firstLeadingBit(_e242)), 32u, (_e242 == 0u));
                if (_e247 < 32u) {
                    phi_525_ = _e247;
                } else {
                    let _e249 = (_e48 ^ _e235);
                    phi_525_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e249)), 32u, (_e249 == 0u)));
                }
                let _e257 = phi_525_;
                phi_527_ = (1u + _e257);
            } else {
                phi_527_ = 0u;
            }
            let _e260 = phi_527_;
            if (1u <= _e48) {
                let _e262 = (_e48 - 1u);
                let _e265 = keys.member[(_e232 + _e48)];
                let _e268 = keys.member[(_e232 + _e262)];
                let _e269 = (_e265 ^ _e268);
                let _e274 = select((bitcast<u32>(31i) - firstLeadingBit(_e269)), 32u, (_e269 == 0u));
                if (_e274 < 32u) {
                    phi_581_ = _e274;
                } else {
                    let _e276 = (_e48 ^ _e262);
                    phi_581_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e276)), 32u, (_e276 == 0u)));
                }
                let _e284 = phi_581_;
                phi_583_ = (1u + _e284);
            } else {
                phi_583_ = 0u;
            }
            let _e287 = phi_583_;
            let _e288 = (_e260 > _e287);
            if _e288 {
                phi_588_ = _e287;
            } else {
                phi_588_ = _e260;
            }
            let _e290 = phi_588_;
            phi_590_ = 2u;
            loop {
                let _e292 = phi_590_;
                local_4 = _e292;
                if (_e292 < _e55) {
                    if _e288 {
                        phi_605_ = (_e292 < (_e55 - _e48));
                    } else {
                        phi_605_ = (_e292 <= _e48);
                    }
                    let _e298 = phi_605_;
                    if _e298 {
                        if _e288 {
                            phi_614_ = (_e48 + _e292);
                        } else {
                            phi_614_ = (_e48 - _e292);
                        }
                        let _e302 = phi_614_;
                        let _e305 = keys.member[(_e232 + _e48)];
                        let _e308 = keys.member[(_e232 + _e302)];
                        let _e309 = (_e305 ^ _e308);
                        let _e314 = select((bitcast<u32>(31i) - firstLeadingBit(_e309)), 32u, (_e309 == 0u));
                        if (_e314 < 32u) {
                            phi_652_ = _e314;
                        } else {
                            let _e316 = (_e48 ^ _e302);
                            phi_652_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e316)), 32u, (_e316 == 0u)));
                        }
                        let _e324 = phi_652_;
                        phi_654_ = (1u + _e324);
                    } else {
                        phi_654_ = 0u;
                    }
                    let _e327 = phi_654_;
                    let _e328 = (_e327 > _e290);
                    if _e328 {
                        phi_660_ = (_e292 * 2u);
                    } else {
                        phi_660_ = u32();
                    }
                    let _e331 = phi_660_;
                    phi_591_ = _e331;
                    phi_661_ = _e328;
                } else {
                    phi_591_ = u32();
                    phi_661_ = false;
                }
                let _e333 = phi_591_;
                let _e335 = phi_661_;
                continue;
                continuing {
                    phi_590_ = _e333;
                    break if !(_e335);
                }
            }
            let _e338 = local_4;
            phi_668_ = (_e338 / 2u);
            phi_671_ = 0u;
            loop {
                let _e341 = phi_668_;
                let _e343 = phi_671_;
                local_5 = _e343;
                local_6 = _e343;
                local_7 = _e343;
                local_8 = _e343;
                local_13 = _e343;
                local_9 = _e343;
                local_10 = _e343;
                let _e344 = (_e341 > 0u);
                if _e344 {
                    let _e345 = (_e343 + _e341);
                    if _e288 {
                        phi_686_ = (_e345 < (_e55 - _e48));
                    } else {
                        phi_686_ = (_e345 <= _e48);
                    }
                    let _e350 = phi_686_;
                    if _e350 {
                        if _e288 {
                            phi_695_ = (_e48 + _e345);
                        } else {
                            phi_695_ = (_e48 - _e345);
                        }
                        let _e354 = phi_695_;
                        let _e357 = keys.member[(_e232 + _e48)];
                        let _e360 = keys.member[(_e232 + _e354)];
                        let _e361 = (_e357 ^ _e360);
                        let _e366 = select((bitcast<u32>(31i) - firstLeadingBit(_e361)), 32u, (_e361 == 0u));
                        if (_e366 < 32u) {
                            phi_733_ = _e366;
                        } else {
                            let _e368 = (_e48 ^ _e354);
                            phi_733_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e368)), 32u, (_e368 == 0u)));
                        }
                        let _e376 = phi_733_;
                        phi_735_ = (1u + _e376);
                    } else {
                        phi_735_ = 0u;
                    }
                    let _e379 = phi_735_;
                    if (_e379 > _e290) {
                        phi_741_ = (_e343 + _e341);
                    } else {
                        phi_741_ = _e343;
                    }
                    let _e383 = phi_741_;
                    phi_669_ = (_e341 / 2u);
                    phi_672_ = _e383;
                } else {
                    phi_669_ = u32();
                    phi_672_ = u32();
                }
                let _e386 = phi_669_;
                let _e388 = phi_672_;
                continue;
                continuing {
                    phi_668_ = _e386;
                    phi_671_ = _e388;
                    break if !(_e344);
                }
            }
            if _e288 {
                let _e395 = local_6;
                phi_749_ = (_e395 < (_e55 - _e48));
            } else {
                let _e391 = local_5;
                phi_749_ = (_e391 <= _e48);
            }
            let _e398 = phi_749_;
            if _e398 {
                if _e288 {
                    let _e403 = local_8;
                    phi_758_ = (_e48 + _e403);
                } else {
                    let _e400 = local_7;
                    phi_758_ = (_e48 - _e400);
                }
                let _e406 = phi_758_;
                let _e409 = keys.member[(_e232 + _e48)];
                let _e412 = keys.member[(_e232 + _e406)];
                let _e413 = (_e409 ^ _e412);
                let _e418 = select((bitcast<u32>(31i) - firstLeadingBit(_e413)), 32u, (_e413 == 0u));
                if (_e418 < 32u) {
                    phi_796_ = _e418;
                } else {
                    let _e420 = (_e48 ^ _e406);
                    phi_796_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e420)), 32u, (_e420 == 0u)));
                }
                let _e428 = phi_796_;
                phi_798_ = (1u + _e428);
            } else {
                phi_798_ = 0u;
            }
            let _e431 = phi_798_;
            let _e579 = local_13;
            phi_800_ = _e579;
            phi_803_ = 0u;
            loop {
                let _e433 = phi_800_;
                let _e435 = phi_803_;
                local_11 = _e435;
                local_12 = _e435;
                let _e436 = (_e433 > 1u);
                if _e436 {
                    let _e437 = (_e433 / 2u);
                    if ((_e433 % 2u) > 0u) {
                        phi_826_ = (_e437 + 1u);
                    } else {
                        phi_826_ = _e437;
                    }
                    let _e442 = phi_826_;
                    let _e443 = (_e435 + _e442);
                    if _e288 {
                        phi_834_ = (_e443 < (_e55 - _e48));
                    } else {
                        phi_834_ = (_e443 <= _e48);
                    }
                    let _e448 = phi_834_;
                    if _e448 {
                        if _e288 {
                            phi_843_ = (_e48 + _e443);
                        } else {
                            phi_843_ = (_e48 - _e443);
                        }
                        let _e452 = phi_843_;
                        let _e455 = keys.member[(_e232 + _e48)];
                        let _e458 = keys.member[(_e232 + _e452)];
                        let _e459 = (_e455 ^ _e458);
                        let _e464 = select((bitcast<u32>(31i) - firstLeadingBit(_e459)), 32u, (_e459 == 0u));
                        if (_e464 < 32u) {
                            phi_881_ = _e464;
                        } else {
                            let _e466 = (_e48 ^ _e452);
                            phi_881_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e466)), 32u, (_e466 == 0u)));
                        }
                        let _e474 = phi_881_;
                        phi_883_ = (1u + _e474);
                    } else {
                        phi_883_ = 0u;
                    }
                    let _e477 = phi_883_;
                    if (_e477 > _e431) {
                        phi_889_ = (_e435 + _e442);
                    } else {
                        phi_889_ = _e435;
                    }
                    let _e481 = phi_889_;
                    phi_801_ = _e442;
                    phi_804_ = _e481;
                } else {
                    phi_801_ = u32();
                    phi_804_ = u32();
                }
                let _e483 = phi_801_;
                let _e485 = phi_804_;
                continue;
                continuing {
                    phi_800_ = _e483;
                    phi_803_ = _e485;
                    break if !(_e436);
                }
            }
            if _e288 {
                let _e491 = local_10;
                phi_895_ = _e48;
                phi_896_ = (_e48 + _e491);
            } else {
                let _e488 = local_9;
                phi_895_ = (_e48 - _e488);
                phi_896_ = _e48;
            }
            let _e494 = phi_895_;
            let _e496 = phi_896_;
            if _e288 {
                let _e501 = local_12;
                phi_903_ = ((_e48 + _e501) + 1u);
            } else {
                let _e498 = local_11;
                phi_903_ = (_e48 - _e498);
            }
            let _e505 = phi_903_;
            let _e506 = (_e55 - 1u);
            let _e507 = (_e505 - 1u);
            if (_e494 == _e507) {
                phi_913_ = (_e506 + _e494);
            } else {
                phi_913_ = _e507;
            }
            let _e511 = phi_913_;
            if (_e505 == _e496) {
                phi_919_ = (_e506 + _e505);
            } else {
                phi_919_ = _e505;
            }
            let _e515 = phi_919_;
            branches.member[_e48] = vec4<u32>(_e511, _e515, _e494, _e496);
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn split_branches(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}

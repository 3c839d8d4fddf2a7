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

struct type_14 {
    member: f32,
    member_1: f32,
}

struct type_16 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_18 {
    member: array<type_16>,
}

struct type_20 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_22 {
    member: array<type_20>,
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
    member: array<array<array<u32, 2>, 6>>,
}

struct type_31 {
    member: array<array<f64, 3>>,
}

struct type_32 {
    member: array<f64, 3>,
    member_1: array<f64, 3>,
}

@group(0) @binding(0) 
var<storage> params: type_25;
@group(0) @binding(1) 
var<storage> positions: type_31;
@group(0) @binding(2) 
var<storage, read_write> paths: type_18;
@group(0) @binding(3) 
var<storage, read_write> keys: type_28;
@group(0) @binding(4) 
var<storage, read_write> boxes: type_22;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_20;
    var local_1: type_20;
    var local_2: array<f64, 3>;
    var local_3: array<f64, 3>;
    var local_4: type_16;
    var local_5: type_32;
    var local_6: type_32;
    var phi_188_: f64;
    var phi_195_: f64;
    var phi_202_: f64;
    var phi_210_: f64;
    var phi_217_: f64;
    var phi_224_: f64;
    var phi_254_: type_9;
    var phi_255_: type_9;
    var phi_278_: type_9;
    var phi_305_: bool;
    var phi_322_: f64;
    var phi_323_: f64;
    var phi_324_: f64;
    var phi_351_: bool;
    var phi_368_: f64;
    var phi_369_: f64;
    var phi_370_: f64;
    var phi_425_: type_9;
    var phi_426_: type_9;
    var phi_449_: type_9;
    var phi_536_: bool;
    var phi_537_: u32;
    var phi_538_: bool;
    var phi_539_: u32;
    var phi_540_: bool;
    var phi_541_: u32;
    var phi_542_: bool;
    var phi_543_: u32;
    var phi_556_: type_14;
    var phi_604_: bool;
    var phi_605_: u32;
    var phi_606_: bool;
    var phi_607_: u32;
    var phi_608_: bool;
    var phi_609_: u32;
    var phi_610_: bool;
    var phi_611_: u32;
    var phi_624_: type_14;
    var phi_644_: bool;
    var phi_645_: bool;
    var phi_649_: bool;
    var phi_650_: bool;
    var phi_654_: f32;
    var phi_716_: bool;
    var phi_717_: u32;
    var phi_718_: bool;
    var phi_719_: u32;
    var phi_720_: bool;
    var phi_721_: u32;
    var phi_722_: bool;
    var phi_723_: u32;
    var phi_736_: type_14;
    var phi_784_: bool;
    var phi_785_: u32;
    var phi_786_: bool;
    var phi_787_: u32;
    var phi_788_: bool;
    var phi_789_: u32;
    var phi_790_: bool;
    var phi_791_: u32;
    var phi_804_: type_14;
    var phi_824_: bool;
    var phi_825_: bool;
    var phi_829_: bool;
    var phi_830_: bool;
    var phi_834_: f32;
    var phi_888_: bool;
    var phi_889_: bool;
    var phi_896_: array<u32, 2>;
    var phi_897_: bool;
    var phi_898_: array<u32, 2>;
    var phi_899_: bool;
    var phi_905_: array<u32, 2>;
    var phi_924_: bool;
    var phi_925_: bool;
    var phi_932_: array<u32, 2>;
    var phi_933_: bool;
    var phi_934_: array<u32, 2>;
    var phi_935_: bool;
    var phi_941_: array<u32, 2>;
    var phi_960_: bool;
    var phi_961_: bool;
    var phi_968_: array<u32, 2>;
    var phi_969_: bool;
    var phi_970_: array<u32, 2>;
    var phi_971_: bool;
    var phi_977_: array<u32, 2>;
    var phi_996_: bool;
    var phi_997_: bool;
    var phi_1004_: array<u32, 2>;
    var phi_1005_: bool;
    var phi_1006_: array<u32, 2>;
    var phi_1007_: bool;
    var phi_1013_: array<u32, 2>;
    var phi_1032_: bool;
    var phi_1033_: bool;
    var phi_1040_: array<u32, 2>;
    var phi_1041_: bool;
    var phi_1042_: array<u32, 2>;
    var phi_1043_: bool;
    var phi_1049_: array<u32, 2>;
    var phi_1068_: bool;
    var phi_1069_: bool;
    var phi_1076_: array<u32, 2>;
    var phi_1077_: bool;
    var phi_1078_: array<u32, 2>;
    var phi_1079_: bool;
    var phi_1085_: array<u32, 2>;
    var phi_1091_: type_9;
    var phi_1092_: type_9;
    var phi_1115_: type_9;
    var phi_1176_: bool;
    var phi_1177_: u32;
    var phi_1178_: bool;
    var phi_1179_: u32;
    var phi_1180_: bool;
    var phi_1181_: u32;
    var phi_1182_: bool;
    var phi_1183_: u32;
    var phi_1196_: type_14;
    var phi_1203_: f32;
    var phi_1208_: f32;
    var phi_1269_: bool;
    var phi_1270_: u32;
    var phi_1271_: bool;
    var phi_1272_: u32;
    var phi_1273_: bool;
    var phi_1274_: u32;
    var phi_1275_: bool;
    var phi_1276_: u32;
    var phi_1289_: type_14;
    var phi_1296_: f32;
    var phi_1301_: f32;
    var phi_1334_: type_9;
    var phi_1335_: type_9;
    var phi_1358_: type_9;
    var phi_1379_: bool;
    var phi_1402_: bool;
    var phi_1406_: f32;
    var phi_1415_: f32;
    var phi_1436_: bool;
    var phi_1459_: bool;
    var phi_1463_: f32;
    var phi_1472_: f32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e52 = id_2;
    let _e53 = n_2;
    let _e54 = lane_2;
    let _e66 = ((((_e52.y * _e53.x) + _e52.x) * 256u) + _e54);
    let _e70 = params.member.member.member[0u];
    if (_e66 < _e70) {
        let _e74 = positions.member[_e66];
        let _e77 = params.member.member.member[0u];
        let _e80 = positions.member[(_e77 + _e66)];
        if (_e74[0] < _e80[0]) {
            phi_188_ = _e74[0];
        } else {
            phi_188_ = _e80[0];
        }
        let _e86 = phi_188_;
        if (_e74[1] < _e80[1]) {
            phi_195_ = _e74[1];
        } else {
            phi_195_ = _e80[1];
        }
        let _e91 = phi_195_;
        if (_e74[2] < _e80[2]) {
            phi_202_ = _e74[2];
        } else {
            phi_202_ = _e80[2];
        }
        let _e96 = phi_202_;
        if (_e74[0] > _e80[0]) {
            phi_210_ = _e74[0];
        } else {
            phi_210_ = _e80[0];
        }
        let _e101 = phi_210_;
        if (_e74[1] > _e80[1]) {
            phi_217_ = _e74[1];
        } else {
            phi_217_ = _e80[1];
        }
        let _e106 = phi_217_;
        if (_e74[2] > _e80[2]) {
            phi_224_ = _e74[2];
        } else {
            phi_224_ = _e80[2];
        }
        let _e111 = phi_224_;
        let _e113 = params.member.member.member_9;
        let _e120 = bitcast<f64>(((u64(_e113[1]) * 4294967296lu) + u64(_e113[0])));
        if (_e120 > f64(0f)) {
            local_5 = type_32(array<f64, 3>(_e86, _e91, _e96), array<f64, 3>(_e101, _e106, _e111));
            phi_254_ = type_9(0u, 3u);
            loop {
                let _e130 = phi_254_;
                if (_e130.member < _e130.member_1) {
                    phi_255_ = type_9((_e130.member + 1u), _e130.member_1);
                    phi_278_ = type_9(1u, _e130.member);
                } else {
                    phi_255_ = _e130;
                    phi_278_ = type_9(0u, type_9().member_1);
                }
                let _e142 = phi_255_;
                let _e144 = phi_278_;
                let _e148 = (bitcast<i32>(_e144.member) != 0i);
                if _e148 {
                    let _e151 = local_5.member[_e144.member_1];
                    let _e153 = -((_e151 - _e120));
                    let _e154 = bitcast<u64>(_e153);
                    if ((_e154 & 9218868437227405312lu) == 9218868437227405312lu) {
                        phi_305_ = (_e153 < 0.0lf);
                    } else {
                        phi_305_ = true;
                    }
                    let _e159 = phi_305_;
                    if _e159 {
                        if (_e153 > 0.0lf) {
                            phi_323_ = bitcast<f64>((_e154 + 1lu));
                        } else {
                            if (_e153 < 0.0lf) {
                                phi_322_ = bitcast<f64>((_e154 - 1lu));
                            } else {
                                phi_322_ = 5e-324lf;
                            }
                            let _e165 = phi_322_;
                            phi_323_ = _e165;
                        }
                        let _e169 = phi_323_;
                        phi_324_ = _e169;
                    } else {
                        phi_324_ = _e153;
                    }
                    let _e171 = phi_324_;
                    local_5.member[_e144.member_1] = -(_e171);
                    let _e177 = local_5.member_1[_e144.member_1];
                    let _e178 = (_e177 + _e120);
                    let _e179 = bitcast<u64>(_e178);
                    if ((_e179 & 9218868437227405312lu) == 9218868437227405312lu) {
                        phi_351_ = (_e178 < 0.0lf);
                    } else {
                        phi_351_ = true;
                    }
                    let _e184 = phi_351_;
                    if _e184 {
                        if (_e178 > 0.0lf) {
                            phi_369_ = bitcast<f64>((_e179 + 1lu));
                        } else {
                            if (_e178 < 0.0lf) {
                                phi_368_ = bitcast<f64>((_e179 - 1lu));
                            } else {
                                phi_368_ = 5e-324lf;
                            }
                            let _e190 = phi_368_;
                            phi_369_ = _e190;
                        }
                        let _e194 = phi_369_;
                        phi_370_ = _e194;
                    } else {
                        phi_370_ = _e178;
                    }
                    let _e196 = phi_370_;
                    local_5.member_1[_e144.member_1] = _e196;
                }
                continue;
                continuing {
                    phi_254_ = _e142;
                    break if !(_e148);
                }
            }
        } else {
            local_5 = type_32(array<f64, 3>(_e86, _e91, _e96), array<f64, 3>(_e101, _e106, _e111));
        }
        let _e200 = local_5;
        local_6 = _e200;
        local_2 = array<f64, 3>(_e74[0], _e74[1], _e74[2]);
        local_3 = array<f64, 3>(_e80[0], _e80[1], _e80[2]);
        local_4.member = array<f32, 4>(0f, 0f, 0f, 0f);
        local_4.member_1 = array<f32, 4>(0f, 0f, 0f, 0f);
        phi_425_ = type_9(0u, 3u);
        loop {
            let _e213 = phi_425_;
            if (_e213.member < _e213.member_1) {
                phi_426_ = type_9((_e213.member + 1u), _e213.member_1);
                phi_449_ = type_9(1u, _e213.member);
            } else {
                phi_426_ = _e213;
                phi_449_ = type_9(0u, type_9().member_1);
            }
            let _e225 = phi_426_;
            let _e227 = phi_449_;
            let _e231 = (bitcast<i32>(_e227.member) != 0i);
            if _e231 {
                let _e234 = params.member.member.member_8[_e227.member_1];
                let _e241 = bitcast<f64>(((u64(_e234[1]) * 4294967296lu) + u64(_e234[0])));
                let _e243 = params.member.member.member_10;
                let _e250 = bitcast<f64>(((u64(_e243[1]) * 4294967296lu) + u64(_e243[0])));
                let _e252 = local_2[_e227.member_1];
                let _e254 = ((_e252 - _e241) * _e250);
                let _e255 = bitcast<u64>(_e254);
                let _e256 = u32(_e255);
                let _e258 = u32((_e255 / 4294967296lu));
                let _e259 = (_e258 & 2147483648u);
                let _e262 = ((_e258 >> bitcast<u32>(20i)) & 2047u);
                let _e268 = (((_e258 & 1048575u) << bitcast<u32>(3i)) | (_e256 >> bitcast<u32>(29i)));
                let _e269 = (_e256 & 536870911u);
                if (_e262 == 2047u) {
                    phi_542_ = false;
                    phi_543_ = (2139095040u | _e268);
                } else {
                    if (_e262 > 1150u) {
                        phi_540_ = true;
                        phi_541_ = 2139095039u;
                    } else {
                        if (_e262 > 896u) {
                            phi_538_ = (_e269 != 0u);
                            phi_539_ = (((_e262 - 896u) << bitcast<u32>(23i)) | _e268);
                        } else {
                            if (_e262 >= 873u) {
                                let _e277 = (8388608u | _e268);
                                let _e278 = (897u - _e262);
                                phi_536_ = (((_e277 & ((1u << bitcast<u32>((_e278 & 31u))) - 1u)) | _e269) != 0u);
                                phi_537_ = (_e277 >> bitcast<u32>((_e278 & 31u)));
                            } else {
                                phi_536_ = (((_e258 & 2147483647u) | _e256) != 0u);
                                phi_537_ = 0u;
                            }
                            let _e290 = phi_536_;
                            let _e292 = phi_537_;
                            phi_538_ = _e290;
                            phi_539_ = _e292;
                        }
                        let _e299 = phi_538_;
                        let _e301 = phi_539_;
                        phi_540_ = _e299;
                        phi_541_ = _e301;
                    }
                    let _e303 = phi_540_;
                    let _e305 = phi_541_;
                    phi_542_ = _e303;
                    phi_543_ = _e305;
                }
                let _e308 = phi_542_;
                let _e310 = phi_543_;
                let _e312 = bitcast<f32>((_e259 | _e310));
                let _e316 = bitcast<f32>(((_e259 | _e310) + select(0u, 1u, _e308)));
                if (_e259 == 0u) {
                    phi_556_ = type_14(_e312, _e316);
                } else {
                    phi_556_ = type_14(_e316, _e312);
                }
                let _e321 = phi_556_;
                let _e323 = bitcast<u64>(_e254);
                let _e324 = u32(_e323);
                let _e326 = u32((_e323 / 4294967296lu));
                let _e327 = (_e326 & 2147483648u);
                let _e330 = ((_e326 >> bitcast<u32>(20i)) & 2047u);
                let _e336 = (((_e326 & 1048575u) << bitcast<u32>(3i)) | (_e324 >> bitcast<u32>(29i)));
                let _e337 = (_e324 & 536870911u);
                if (_e330 == 2047u) {
                    phi_610_ = false;
                    phi_611_ = (2139095040u | _e336);
                } else {
                    if (_e330 > 1150u) {
                        phi_608_ = true;
                        phi_609_ = 2139095039u;
                    } else {
                        if (_e330 > 896u) {
                            phi_606_ = (_e337 != 0u);
                            phi_607_ = (((_e330 - 896u) << bitcast<u32>(23i)) | _e336);
                        } else {
                            if (_e330 >= 873u) {
                                let _e345 = (8388608u | _e336);
                                let _e346 = (897u - _e330);
                                phi_604_ = (((_e345 & ((1u << bitcast<u32>((_e346 & 31u))) - 1u)) | _e337) != 0u);
                                phi_605_ = (_e345 >> bitcast<u32>((_e346 & 31u)));
                            } else {
                                phi_604_ = (((_e326 & 2147483647u) | _e324) != 0u);
                                phi_605_ = 0u;
                            }
                            let _e358 = phi_604_;
                            let _e360 = phi_605_;
                            phi_606_ = _e358;
                            phi_607_ = _e360;
                        }
                        let _e367 = phi_606_;
                        let _e369 = phi_607_;
                        phi_608_ = _e367;
                        phi_609_ = _e369;
                    }
                    let _e371 = phi_608_;
                    let _e373 = phi_609_;
                    phi_610_ = _e371;
                    phi_611_ = _e373;
                }
                let _e376 = phi_610_;
                let _e378 = phi_611_;
                let _e380 = bitcast<f32>((_e327 | _e378));
                let _e384 = bitcast<f32>(((_e327 | _e378) + select(0u, 1u, _e376)));
                if (_e327 == 0u) {
                    phi_624_ = type_14(_e380, _e384);
                } else {
                    phi_624_ = type_14(_e384, _e380);
                }
                let _e389 = phi_624_;
                let _e392 = (_e254 - f64(_e321.member));
                let _e394 = (f64(_e389.member_1) - _e254);
                if (_e392 < _e394) {
                    phi_650_ = true;
                } else {
                    if (_e392 == _e394) {
                        if ((bitcast<u32>(_e321.member) & 1u) == 0u) {
                            phi_644_ = false;
                        } else {
                            phi_644_ = true;
                        }
                        let _e401 = phi_644_;
                        phi_645_ = _e401;
                    } else {
                        phi_645_ = true;
                    }
                    let _e403 = phi_645_;
                    if _e403 {
                        phi_649_ = false;
                    } else {
                        phi_649_ = true;
                    }
                    let _e405 = phi_649_;
                    phi_650_ = _e405;
                }
                let _e407 = phi_650_;
                if _e407 {
                    phi_654_ = _e321.member;
                } else {
                    phi_654_ = _e389.member_1;
                }
                let _e409 = phi_654_;
                local_4.member[_e227.member_1] = _e409;
                let _e413 = local_3[_e227.member_1];
                let _e415 = ((_e413 - _e241) * _e250);
                let _e416 = bitcast<u64>(_e415);
                let _e417 = u32(_e416);
                let _e419 = u32((_e416 / 4294967296lu));
                let _e420 = (_e419 & 2147483648u);
                let _e423 = ((_e419 >> bitcast<u32>(20i)) & 2047u);
                let _e429 = (((_e419 & 1048575u) << bitcast<u32>(3i)) | (_e417 >> bitcast<u32>(29i)));
                let _e430 = (_e417 & 536870911u);
                if (_e423 == 2047u) {
                    phi_722_ = false;
                    phi_723_ = (2139095040u | _e429);
                } else {
                    if (_e423 > 1150u) {
                        phi_720_ = true;
                        phi_721_ = 2139095039u;
                    } else {
                        if (_e423 > 896u) {
                            phi_718_ = (_e430 != 0u);
                            phi_719_ = (((_e423 - 896u) << bitcast<u32>(23i)) | _e429);
                        } else {
                            if (_e423 >= 873u) {
                                let _e438 = (8388608u | _e429);
                                let _e439 = (897u - _e423);
                                phi_716_ = (((_e438 & ((1u << bitcast<u32>((_e439 & 31u))) - 1u)) | _e430) != 0u);
                                phi_717_ = (_e438 >> bitcast<u32>((_e439 & 31u)));
                            } else {
                                phi_716_ = (((_e419 & 2147483647u) | _e417) != 0u);
                                phi_717_ = 0u;
                            }
                            let _e451 = phi_716_;
                            let _e453 = phi_717_;
                            phi_718_ = _e451;
                            phi_719_ = _e453;
                        }
                        let _e460 = phi_718_;
                        let _e462 = phi_719_;
                        phi_720_ = _e460;
                        phi_721_ = _e462;
                    }
                    let _e464 = phi_720_;
                    let _e466 = phi_721_;
                    phi_722_ = _e464;
                    phi_723_ = _e466;
                }
                let _e469 = phi_722_;
                let _e471 = phi_723_;
                let _e473 = bitcast<f32>((_e420 | _e471));
                let _e477 = bitcast<f32>(((_e420 | _e471) + select(0u, 1u, _e469)));
                if (_e420 == 0u) {
                    phi_736_ = type_14(_e473, _e477);
                } else {
                    phi_736_ = type_14(_e477, _e473);
                }
                let _e482 = phi_736_;
                let _e484 = bitcast<u64>(_e415);
                let _e485 = u32(_e484);
                let _e487 = u32((_e484 / 4294967296lu));
                let _e488 = (_e487 & 2147483648u);
                let _e491 = ((_e487 >> bitcast<u32>(20i)) & 2047u);
                let _e497 = (((_e487 & 1048575u) << bitcast<u32>(3i)) | (_e485 >> bitcast<u32>(29i)));
                let _e498 = (_e485 & 536870911u);
                if (_e491 == 2047u) {
                    phi_790_ = false;
                    phi_791_ = (2139095040u | _e497);
                } else {
                    if (_e491 > 1150u) {
                        phi_788_ = true;
                        phi_789_ = 2139095039u;
                    } else {
                        if (_e491 > 896u) {
                            phi_786_ = (_e498 != 0u);
                            phi_787_ = (((_e491 - 896u) << bitcast<u32>(23i)) | _e497);
                        } else {
                            if (_e491 >= 873u) {
                                let _e506 = (8388608u | _e497);
                                let _e507 = (897u - _e491);
                                phi_784_ = (((_e506 & ((1u << bitcast<u32>((_e507 & 31u))) - 1u)) | _e498) != 0u);
                                phi_785_ = (_e506 >> bitcast<u32>((_e507 & 31u)));
                            } else {
                                phi_784_ = (((_e487 & 2147483647u) | _e485) != 0u);
                                phi_785_ = 0u;
                            }
                            let _e519 = phi_784_;
                            let _e521 = phi_785_;
                            phi_786_ = _e519;
                            phi_787_ = _e521;
                        }
                        let _e528 = phi_786_;
                        let _e530 = phi_787_;
                        phi_788_ = _e528;
                        phi_789_ = _e530;
                    }
                    let _e532 = phi_788_;
                    let _e534 = phi_789_;
                    phi_790_ = _e532;
                    phi_791_ = _e534;
                }
                let _e537 = phi_790_;
                let _e539 = phi_791_;
                let _e541 = bitcast<f32>((_e488 | _e539));
                let _e545 = bitcast<f32>(((_e488 | _e539) + select(0u, 1u, _e537)));
                if (_e488 == 0u) {
                    phi_804_ = type_14(_e541, _e545);
                } else {
                    phi_804_ = type_14(_e545, _e541);
                }
                let _e550 = phi_804_;
                let _e553 = (_e415 - f64(_e482.member));
                let _e555 = (f64(_e550.member_1) - _e415);
                if (_e553 < _e555) {
                    phi_830_ = true;
                } else {
                    if (_e553 == _e555) {
                        if ((bitcast<u32>(_e482.member) & 1u) == 0u) {
                            phi_824_ = false;
                        } else {
                            phi_824_ = true;
                        }
                        let _e562 = phi_824_;
                        phi_825_ = _e562;
                    } else {
                        phi_825_ = true;
                    }
                    let _e564 = phi_825_;
                    if _e564 {
                        phi_829_ = false;
                    } else {
                        phi_829_ = true;
                    }
                    let _e566 = phi_829_;
                    phi_830_ = _e566;
                }
                let _e568 = phi_830_;
                if _e568 {
                    phi_834_ = _e482.member;
                } else {
                    phi_834_ = _e550.member_1;
                }
                let _e570 = phi_834_;
                local_4.member_1[_e227.member_1] = _e570;
            }
            continue;
            continuing {
                phi_425_ = _e225;
                break if !(_e231);
            }
        }
        let _e574 = local_4;
        paths.member[_e66] = type_16(array<f32, 4>(_e574.member[0], _e574.member[1], _e574.member[2], _e574.member[3]), array<f32, 4>(_e574.member_1[0], _e574.member_1[1], _e574.member_1[2], _e574.member_1[3]));
        let _e590 = local_6.member;
        let _e595 = local_6.member_1;
        let _e599 = bitcast<u64>(_e590[0]);
        let _e600 = u32(_e599);
        let _e602 = u32((_e599 / 4294967296lu));
        if ((_e602 >> bitcast<u32>(31i)) == 0u) {
            phi_898_ = array<u32, 2>();
            phi_899_ = true;
        } else {
            if (_e602 == 2147483648u) {
                if (_e600 == 0u) {
                    phi_888_ = false;
                } else {
                    phi_888_ = true;
                }
                let _e609 = phi_888_;
                phi_889_ = _e609;
            } else {
                phi_889_ = true;
            }
            let _e611 = phi_889_;
            if _e611 {
                phi_896_ = array<u32, 2>(~(_e600), ~(_e602));
                phi_897_ = false;
            } else {
                phi_896_ = array<u32, 2>();
                phi_897_ = true;
            }
            let _e616 = phi_896_;
            let _e618 = phi_897_;
            phi_898_ = _e616;
            phi_899_ = _e618;
        }
        let _e620 = phi_898_;
        let _e622 = phi_899_;
        if _e622 {
            phi_905_ = array<u32, 2>(_e600, (_e602 | 2147483648u));
        } else {
            phi_905_ = _e620;
        }
        let _e626 = phi_905_;
        let _e627 = bitcast<u64>(_e590[1]);
        let _e628 = u32(_e627);
        let _e630 = u32((_e627 / 4294967296lu));
        if ((_e630 >> bitcast<u32>(31i)) == 0u) {
            phi_934_ = array<u32, 2>();
            phi_935_ = true;
        } else {
            if (_e630 == 2147483648u) {
                if (_e628 == 0u) {
                    phi_924_ = false;
                } else {
                    phi_924_ = true;
                }
                let _e637 = phi_924_;
                phi_925_ = _e637;
            } else {
                phi_925_ = true;
            }
            let _e639 = phi_925_;
            if _e639 {
                phi_932_ = array<u32, 2>(~(_e628), ~(_e630));
                phi_933_ = false;
            } else {
                phi_932_ = array<u32, 2>();
                phi_933_ = true;
            }
            let _e644 = phi_932_;
            let _e646 = phi_933_;
            phi_934_ = _e644;
            phi_935_ = _e646;
        }
        let _e648 = phi_934_;
        let _e650 = phi_935_;
        if _e650 {
            phi_941_ = array<u32, 2>(_e628, (_e630 | 2147483648u));
        } else {
            phi_941_ = _e648;
        }
        let _e654 = phi_941_;
        let _e655 = bitcast<u64>(_e590[2]);
        let _e656 = u32(_e655);
        let _e658 = u32((_e655 / 4294967296lu));
        if ((_e658 >> bitcast<u32>(31i)) == 0u) {
            phi_970_ = array<u32, 2>();
            phi_971_ = true;
        } else {
            if (_e658 == 2147483648u) {
                if (_e656 == 0u) {
                    phi_960_ = false;
                } else {
                    phi_960_ = true;
                }
                let _e665 = phi_960_;
                phi_961_ = _e665;
            } else {
                phi_961_ = true;
            }
            let _e667 = phi_961_;
            if _e667 {
                phi_968_ = array<u32, 2>(~(_e656), ~(_e658));
                phi_969_ = false;
            } else {
                phi_968_ = array<u32, 2>();
                phi_969_ = true;
            }
            let _e672 = phi_968_;
            let _e674 = phi_969_;
            phi_970_ = _e672;
            phi_971_ = _e674;
        }
        let _e676 = phi_970_;
        let _e678 = phi_971_;
        if _e678 {
            phi_977_ = array<u32, 2>(_e656, (_e658 | 2147483648u));
        } else {
            phi_977_ = _e676;
        }
        let _e682 = phi_977_;
        let _e683 = bitcast<u64>(_e595[0]);
        let _e684 = u32(_e683);
        let _e686 = u32((_e683 / 4294967296lu));
        if ((_e686 >> bitcast<u32>(31i)) == 0u) {
            phi_1006_ = array<u32, 2>();
            phi_1007_ = true;
        } else {
            if (_e686 == 2147483648u) {
                if (_e684 == 0u) {
                    phi_996_ = false;
                } else {
                    phi_996_ = true;
                }
                let _e693 = phi_996_;
                phi_997_ = _e693;
            } else {
                phi_997_ = true;
            }
            let _e695 = phi_997_;
            if _e695 {
                phi_1004_ = array<u32, 2>(~(_e684), ~(_e686));
                phi_1005_ = false;
            } else {
                phi_1004_ = array<u32, 2>();
                phi_1005_ = true;
            }
            let _e700 = phi_1004_;
            let _e702 = phi_1005_;
            phi_1006_ = _e700;
            phi_1007_ = _e702;
        }
        let _e704 = phi_1006_;
        let _e706 = phi_1007_;
        if _e706 {
            phi_1013_ = array<u32, 2>(_e684, (_e686 | 2147483648u));
        } else {
            phi_1013_ = _e704;
        }
        let _e710 = phi_1013_;
        let _e711 = bitcast<u64>(_e595[1]);
        let _e712 = u32(_e711);
        let _e714 = u32((_e711 / 4294967296lu));
        if ((_e714 >> bitcast<u32>(31i)) == 0u) {
            phi_1042_ = array<u32, 2>();
            phi_1043_ = true;
        } else {
            if (_e714 == 2147483648u) {
                if (_e712 == 0u) {
                    phi_1032_ = false;
                } else {
                    phi_1032_ = true;
                }
                let _e721 = phi_1032_;
                phi_1033_ = _e721;
            } else {
                phi_1033_ = true;
            }
            let _e723 = phi_1033_;
            if _e723 {
                phi_1040_ = array<u32, 2>(~(_e712), ~(_e714));
                phi_1041_ = false;
            } else {
                phi_1040_ = array<u32, 2>();
                phi_1041_ = true;
            }
            let _e728 = phi_1040_;
            let _e730 = phi_1041_;
            phi_1042_ = _e728;
            phi_1043_ = _e730;
        }
        let _e732 = phi_1042_;
        let _e734 = phi_1043_;
        if _e734 {
            phi_1049_ = array<u32, 2>(_e712, (_e714 | 2147483648u));
        } else {
            phi_1049_ = _e732;
        }
        let _e738 = phi_1049_;
        let _e739 = bitcast<u64>(_e595[2]);
        let _e740 = u32(_e739);
        let _e742 = u32((_e739 / 4294967296lu));
        if ((_e742 >> bitcast<u32>(31i)) == 0u) {
            phi_1078_ = array<u32, 2>();
            phi_1079_ = true;
        } else {
            if (_e742 == 2147483648u) {
                if (_e740 == 0u) {
                    phi_1068_ = false;
                } else {
                    phi_1068_ = true;
                }
                let _e749 = phi_1068_;
                phi_1069_ = _e749;
            } else {
                phi_1069_ = true;
            }
            let _e751 = phi_1069_;
            if _e751 {
                phi_1076_ = array<u32, 2>(~(_e740), ~(_e742));
                phi_1077_ = false;
            } else {
                phi_1076_ = array<u32, 2>();
                phi_1077_ = true;
            }
            let _e756 = phi_1076_;
            let _e758 = phi_1077_;
            phi_1078_ = _e756;
            phi_1079_ = _e758;
        }
        let _e760 = phi_1078_;
        let _e762 = phi_1079_;
        if _e762 {
            phi_1085_ = array<u32, 2>(_e740, (_e742 | 2147483648u));
        } else {
            phi_1085_ = _e760;
        }
        let _e766 = phi_1085_;
        keys.member[_e66] = array<array<u32, 2>, 6>(_e626, _e654, _e682, _e710, _e738, _e766);
        local_1 = type_20(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        phi_1091_ = type_9(0u, 3u);
        loop {
            let _e770 = phi_1091_;
            if (_e770.member < _e770.member_1) {
                phi_1092_ = type_9((_e770.member + 1u), _e770.member_1);
                phi_1115_ = type_9(1u, _e770.member);
            } else {
                phi_1092_ = _e770;
                phi_1115_ = type_9(0u, type_9().member_1);
            }
            let _e782 = phi_1092_;
            let _e784 = phi_1115_;
            let _e788 = (bitcast<i32>(_e784.member) != 0i);
            if _e788 {
                let _e791 = local_6.member[_e784.member_1];
                let _e792 = bitcast<u64>(_e791);
                let _e793 = u32(_e792);
                let _e795 = u32((_e792 / 4294967296lu));
                let _e796 = (_e795 & 2147483648u);
                let _e799 = ((_e795 >> bitcast<u32>(20i)) & 2047u);
                let _e805 = (((_e795 & 1048575u) << bitcast<u32>(3i)) | (_e793 >> bitcast<u32>(29i)));
                let _e806 = (_e793 & 536870911u);
                if (_e799 == 2047u) {
                    phi_1182_ = false;
                    phi_1183_ = (2139095040u | _e805);
                } else {
                    if (_e799 > 1150u) {
                        phi_1180_ = true;
                        phi_1181_ = 2139095039u;
                    } else {
                        if (_e799 > 896u) {
                            phi_1178_ = (_e806 != 0u);
                            phi_1179_ = (((_e799 - 896u) << bitcast<u32>(23i)) | _e805);
                        } else {
                            if (_e799 >= 873u) {
                                let _e814 = (8388608u | _e805);
                                let _e815 = (897u - _e799);
                                phi_1176_ = (((_e814 & ((1u << bitcast<u32>((_e815 & 31u))) - 1u)) | _e806) != 0u);
                                phi_1177_ = (_e814 >> bitcast<u32>((_e815 & 31u)));
                            } else {
                                phi_1176_ = (((_e795 & 2147483647u) | _e793) != 0u);
                                phi_1177_ = 0u;
                            }
                            let _e827 = phi_1176_;
                            let _e829 = phi_1177_;
                            phi_1178_ = _e827;
                            phi_1179_ = _e829;
                        }
                        let _e836 = phi_1178_;
                        let _e838 = phi_1179_;
                        phi_1180_ = _e836;
                        phi_1181_ = _e838;
                    }
                    let _e840 = phi_1180_;
                    let _e842 = phi_1181_;
                    phi_1182_ = _e840;
                    phi_1183_ = _e842;
                }
                let _e845 = phi_1182_;
                let _e847 = phi_1183_;
                let _e849 = bitcast<f32>((_e796 | _e847));
                let _e853 = bitcast<f32>(((_e796 | _e847) + select(0u, 1u, _e845)));
                if (_e796 == 0u) {
                    phi_1196_ = type_14(_e849, _e853);
                } else {
                    phi_1196_ = type_14(_e853, _e849);
                }
                let _e858 = phi_1196_;
                let _e860 = -(290000000000000000000000000000000000000f);
                if (_e858.member > _e860) {
                    phi_1203_ = _e858.member;
                } else {
                    phi_1203_ = _e860;
                }
                let _e863 = phi_1203_;
                if (_e863 < 290000000000000000000000000000000000000f) {
                    phi_1208_ = _e863;
                } else {
                    phi_1208_ = 290000000000000000000000000000000000000f;
                }
                let _e866 = phi_1208_;
                local_1.member[_e784.member_1] = _e866;
                let _e871 = local_6.member_1[_e784.member_1];
                let _e872 = bitcast<u64>(_e871);
                let _e873 = u32(_e872);
                let _e875 = u32((_e872 / 4294967296lu));
                let _e876 = (_e875 & 2147483648u);
                let _e879 = ((_e875 >> bitcast<u32>(20i)) & 2047u);
                let _e885 = (((_e875 & 1048575u) << bitcast<u32>(3i)) | (_e873 >> bitcast<u32>(29i)));
                let _e886 = (_e873 & 536870911u);
                if (_e879 == 2047u) {
                    phi_1275_ = false;
                    phi_1276_ = (2139095040u | _e885);
                } else {
                    if (_e879 > 1150u) {
                        phi_1273_ = true;
                        phi_1274_ = 2139095039u;
                    } else {
                        if (_e879 > 896u) {
                            phi_1271_ = (_e886 != 0u);
                            phi_1272_ = (((_e879 - 896u) << bitcast<u32>(23i)) | _e885);
                        } else {
                            if (_e879 >= 873u) {
                                let _e894 = (8388608u | _e885);
                                let _e895 = (897u - _e879);
                                phi_1269_ = (((_e894 & ((1u << bitcast<u32>((_e895 & 31u))) - 1u)) | _e886) != 0u);
                                phi_1270_ = (_e894 >> bitcast<u32>((_e895 & 31u)));
                            } else {
                                phi_1269_ = (((_e875 & 2147483647u) | _e873) != 0u);
                                phi_1270_ = 0u;
                            }
                            let _e907 = phi_1269_;
                            let _e909 = phi_1270_;
                            phi_1271_ = _e907;
                            phi_1272_ = _e909;
                        }
                        let _e916 = phi_1271_;
                        let _e918 = phi_1272_;
                        phi_1273_ = _e916;
                        phi_1274_ = _e918;
                    }
                    let _e920 = phi_1273_;
                    let _e922 = phi_1274_;
                    phi_1275_ = _e920;
                    phi_1276_ = _e922;
                }
                let _e925 = phi_1275_;
                let _e927 = phi_1276_;
                let _e929 = bitcast<f32>((_e876 | _e927));
                let _e933 = bitcast<f32>(((_e876 | _e927) + select(0u, 1u, _e925)));
                if (_e876 == 0u) {
                    phi_1289_ = type_14(_e929, _e933);
                } else {
                    phi_1289_ = type_14(_e933, _e929);
                }
                let _e938 = phi_1289_;
                let _e940 = -(290000000000000000000000000000000000000f);
                if (_e938.member_1 > _e940) {
                    phi_1296_ = _e938.member_1;
                } else {
                    phi_1296_ = _e940;
                }
                let _e943 = phi_1296_;
                if (_e943 < 290000000000000000000000000000000000000f) {
                    phi_1301_ = _e943;
                } else {
                    phi_1301_ = 290000000000000000000000000000000000000f;
                }
                let _e946 = phi_1301_;
                local_1.member_1[_e784.member_1] = _e946;
            }
            continue;
            continuing {
                phi_1091_ = _e782;
                break if !(_e788);
            }
        }
        let _e950 = local_1;
        local = _e950;
        phi_1334_ = type_9(0u, 3u);
        loop {
            let _e952 = phi_1334_;
            if (_e952.member < _e952.member_1) {
                phi_1335_ = type_9((_e952.member + 1u), _e952.member_1);
                phi_1358_ = type_9(1u, _e952.member);
            } else {
                phi_1335_ = _e952;
                phi_1358_ = type_9(0u, type_9().member_1);
            }
            let _e964 = phi_1335_;
            let _e966 = phi_1358_;
            let _e970 = (bitcast<i32>(_e966.member) != 0i);
            if _e970 {
                let _e973 = local.member[_e966.member_1];
                if (_e973 < 0.000000000000000000000000000000000000011754944f) {
                    phi_1379_ = (_e973 > -(0.000000000000000000000000000000000000011754944f));
                } else {
                    phi_1379_ = false;
                }
                let _e978 = phi_1379_;
                if _e978 {
                    let _e984 = local_6.member[_e966.member_1];
                    let _e986 = bitcast<u64>(-(_e984));
                    let _e989 = u32((_e986 / 4294967296lu));
                    if ((_e989 >> bitcast<u32>(31i)) == 0u) {
                        phi_1402_ = ((u32(_e986) | _e989) != 0u);
                    } else {
                        phi_1402_ = false;
                    }
                    let _e996 = phi_1402_;
                    if _e996 {
                        phi_1406_ = 0.000000000000000000000000000000000000011754944f;
                    } else {
                        phi_1406_ = 0f;
                    }
                    let _e998 = phi_1406_;
                    phi_1415_ = -(_e998);
                } else {
                    let _e981 = local.member[_e966.member_1];
                    phi_1415_ = _e981;
                }
                let _e1001 = phi_1415_;
                local.member[_e966.member_1] = _e1001;
                let _e1006 = local.member_1[_e966.member_1];
                if (_e1006 < 0.000000000000000000000000000000000000011754944f) {
                    phi_1436_ = (_e1006 > -(0.000000000000000000000000000000000000011754944f));
                } else {
                    phi_1436_ = false;
                }
                let _e1011 = phi_1436_;
                if _e1011 {
                    let _e1017 = local_6.member_1[_e966.member_1];
                    let _e1018 = bitcast<u64>(_e1017);
                    let _e1021 = u32((_e1018 / 4294967296lu));
                    if ((_e1021 >> bitcast<u32>(31i)) == 0u) {
                        phi_1459_ = ((u32(_e1018) | _e1021) != 0u);
                    } else {
                        phi_1459_ = false;
                    }
                    let _e1028 = phi_1459_;
                    if _e1028 {
                        phi_1463_ = 0.000000000000000000000000000000000000011754944f;
                    } else {
                        phi_1463_ = 0f;
                    }
                    let _e1030 = phi_1463_;
                    phi_1472_ = _e1030;
                } else {
                    let _e1014 = local.member_1[_e966.member_1];
                    phi_1472_ = _e1014;
                }
                let _e1032 = phi_1472_;
                local.member_1[_e966.member_1] = _e1032;
            }
            continue;
            continuing {
                phi_1334_ = _e964;
                break if !(_e970);
            }
        }
        let _e1036 = local;
        boxes.member[_e66] = type_20(array<f32, 3>(_e1036.member[0], _e1036.member[1], _e1036.member[2]), array<f32, 3>(_e1036.member_1[0], _e1036.member_1[1], _e1036.member_1[2]));
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn place_vertices(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}

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

struct type_15 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_17 {
    member: array<type_15>,
}

struct type_19 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_21 {
    member: array<type_19>,
}

struct type_22 {
    member: u32,
}

struct type_23 {
    member: type_7,
    member_1: type_8,
    member_2: type_22,
}

struct type_24 {
    member: type_23,
}

struct type_27 {
    member: array<array<array<u32, 2>, 6>>,
}

struct type_30 {
    member: array<array<f64, 3>>,
}

struct type_31 {
    member: array<f64, 3>,
    member_1: array<f64, 3>,
}

@group(0) @binding(0) 
var<storage> params: type_24;
@group(0) @binding(1) 
var<storage> positions: type_30;
@group(0) @binding(2) 
var<storage, read_write> paths: type_17;
@group(0) @binding(3) 
var<storage, read_write> keys: type_27;
@group(0) @binding(4) 
var<storage, read_write> boxes: type_21;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_19;
    var local_1: type_19;
    var local_2: array<f64, 3>;
    var local_3: array<f64, 3>;
    var local_4: type_15;
    var local_5: type_31;
    var local_6: array<f64, 3>;
    var local_7: array<f64, 3>;
    var local_8: type_31;
    var local_9: type_31;
    var phi_195_: type_9;
    var phi_261_: array<u32, 2>;
    var phi_262_: bool;
    var phi_303_: array<u32, 2>;
    var phi_304_: bool;
    var phi_374_: type_9;
    var phi_534_: type_9;
    var phi_645_: bool;
    var phi_646_: u32;
    var phi_647_: bool;
    var phi_648_: u32;
    var phi_649_: bool;
    var phi_650_: u32;
    var phi_651_: bool;
    var phi_652_: u32;
    var phi_713_: bool;
    var phi_714_: u32;
    var phi_715_: bool;
    var phi_716_: u32;
    var phi_717_: bool;
    var phi_718_: u32;
    var phi_719_: bool;
    var phi_720_: u32;
    var phi_825_: bool;
    var phi_826_: u32;
    var phi_827_: bool;
    var phi_828_: u32;
    var phi_829_: bool;
    var phi_830_: u32;
    var phi_831_: bool;
    var phi_832_: u32;
    var phi_893_: bool;
    var phi_894_: u32;
    var phi_895_: bool;
    var phi_896_: u32;
    var phi_897_: bool;
    var phi_898_: u32;
    var phi_899_: bool;
    var phi_900_: u32;
    var phi_1007_: array<u32, 2>;
    var phi_1008_: bool;
    var phi_1043_: array<u32, 2>;
    var phi_1044_: bool;
    var phi_1079_: array<u32, 2>;
    var phi_1080_: bool;
    var phi_1115_: array<u32, 2>;
    var phi_1116_: bool;
    var phi_1151_: array<u32, 2>;
    var phi_1152_: bool;
    var phi_1187_: array<u32, 2>;
    var phi_1188_: bool;
    var phi_1200_: type_9;
    var phi_1285_: bool;
    var phi_1286_: u32;
    var phi_1287_: bool;
    var phi_1288_: u32;
    var phi_1289_: bool;
    var phi_1290_: u32;
    var phi_1291_: bool;
    var phi_1292_: u32;
    var phi_1378_: bool;
    var phi_1379_: u32;
    var phi_1380_: bool;
    var phi_1381_: u32;
    var phi_1382_: bool;
    var phi_1383_: u32;
    var phi_1384_: bool;
    var phi_1385_: u32;
    var phi_1443_: type_9;
    var phi_1524_: f32;
    var phi_1581_: f32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e55 = id_2;
    let _e56 = n_2;
    let _e57 = lane_2;
    let _e69 = ((((_e55.y * _e56.x) + _e55.x) * 256u) + _e57);
    let _e73 = params.member.member.member[0u];
    if (_e69 < _e73) {
        let _e77 = positions.member[_e69];
        let _e80 = params.member.member.member[0u];
        let _e83 = positions.member[(_e80 + _e69)];
        local_6 = array<f64, 3>(_e77[0], _e77[1], _e77[2]);
        local_7 = array<f64, 3>(_e83[0], _e83[1], _e83[2]);
        let _e94 = local_6;
        local_8.member = _e94;
        let _e96 = local_7;
        local_8.member_1 = _e96;
        phi_195_ = type_9(0u, 3u);
        loop {
            let _e98 = phi_195_;
            let _e101 = (_e98.member < _e98.member_1);
            let _e112 = select(type_9().member_1, _e98.member, _e101);
            let _e114 = (bitcast<i32>(select(0u, 1u, _e101)) != 0i);
            if _e114 {
                let _e116 = local_6[_e112];
                let _e117 = bitcast<u64>(_e116);
                let _e118 = u32(_e117);
                let _e120 = u32((_e117 / 4294967296lu));
                if ((_e120 >> bitcast<u32>(31i)) == 0u) {
                    phi_261_ = array<u32, 2>();
                    phi_262_ = true;
                } else {
                    let _e127 = select(true, select(true, false, (_e118 == 0u)), (_e120 == 2147483648u));
                    phi_261_ = array<u32, 2>(select(array<u32, 2>()[0], ~(_e118), _e127), select(array<u32, 2>()[1], ~(_e120), _e127));
                    phi_262_ = select(true, false, _e127);
                }
                let _e137 = phi_261_;
                let _e139 = phi_262_;
                let _e144 = select(_e137[1], (_e120 | 2147483648u), _e139);
                let _e146 = local_7[_e112];
                let _e147 = bitcast<u64>(_e146);
                let _e148 = u32(_e147);
                let _e150 = u32((_e147 / 4294967296lu));
                if ((_e150 >> bitcast<u32>(31i)) == 0u) {
                    phi_303_ = array<u32, 2>();
                    phi_304_ = true;
                } else {
                    let _e157 = select(true, select(true, false, (_e148 == 0u)), (_e150 == 2147483648u));
                    phi_303_ = array<u32, 2>(select(array<u32, 2>()[0], ~(_e148), _e157), select(array<u32, 2>()[1], ~(_e150), _e157));
                    phi_304_ = select(true, false, _e157);
                }
                let _e167 = phi_303_;
                let _e169 = phi_304_;
                let _e174 = select(_e167[1], (_e150 | 2147483648u), _e169);
                if select(select(false, (select(_e137[0], _e118, _e139) > select(_e167[0], _e148, _e169)), (_e144 == _e174)), true, (_e144 > _e174)) {
                    let _e181 = local_7[_e112];
                    local_8.member[_e112] = _e181;
                    let _e185 = local_6[_e112];
                    local_8.member_1[_e112] = _e185;
                }
            }
            continue;
            continuing {
                phi_195_ = type_9(select(_e98.member, (_e98.member + 1u), _e101), select(_e98.member_1, _e98.member_1, _e101));
                break if !(_e114);
            }
        }
        let _e190 = params.member.member.member_9;
        let _e197 = bitcast<f64>(((u64(_e190[1]) * 4294967296lu) + u64(_e190[0])));
        if (_e197 > f64(0f)) {
            let _e201 = local_8;
            local_5 = _e201;
            phi_374_ = type_9(0u, 3u);
            loop {
                let _e203 = phi_374_;
                let _e206 = (_e203.member < _e203.member_1);
                let _e217 = select(type_9().member_1, _e203.member, _e206);
                let _e219 = (bitcast<i32>(select(0u, 1u, _e206)) != 0i);
                if _e219 {
                    let _e222 = local_5.member[_e217];
                    let _e224 = -((_e222 - _e197));
                    let _e225 = bitcast<u64>(_e224);
                    local_5.member[_e217] = -(select(_e224, select(select(5e-324lf, bitcast<f64>((_e225 - 1lu)), (_e224 < 0.0lf)), bitcast<f64>((_e225 + 1lu)), (_e224 > 0.0lf)), select(true, (_e224 < 0.0lf), ((_e225 & 9218868437227405312lu) == 9218868437227405312lu))));
                    let _e244 = local_5.member_1[_e217];
                    let _e245 = (_e244 + _e197);
                    let _e246 = bitcast<u64>(_e245);
                    local_5.member_1[_e217] = select(_e245, select(select(5e-324lf, bitcast<f64>((_e246 - 1lu)), (_e245 < 0.0lf)), bitcast<f64>((_e246 + 1lu)), (_e245 > 0.0lf)), select(true, (_e245 < 0.0lf), ((_e246 & 9218868437227405312lu) == 9218868437227405312lu)));
                }
                continue;
                continuing {
                    phi_374_ = type_9(select(_e203.member, (_e203.member + 1u), _e206), select(_e203.member_1, _e203.member_1, _e206));
                    break if !(_e219);
                }
            }
        } else {
            let _e200 = local_8;
            local_5 = _e200;
        }
        let _e263 = local_5;
        local_9 = _e263;
        local_2 = array<f64, 3>(_e77[0], _e77[1], _e77[2]);
        local_3 = array<f64, 3>(_e83[0], _e83[1], _e83[2]);
        local_4.member = array<f32, 4>(0f, 0f, 0f, 0f);
        local_4.member_1 = array<f32, 4>(0f, 0f, 0f, 0f);
        phi_534_ = type_9(0u, 3u);
        loop {
            let _e276 = phi_534_;
            let _e279 = (_e276.member < _e276.member_1);
            let _e290 = select(type_9().member_1, _e276.member, _e279);
            let _e292 = (bitcast<i32>(select(0u, 1u, _e279)) != 0i);
            if _e292 {
                let _e295 = params.member.member.member_8[_e290];
                let _e302 = bitcast<f64>(((u64(_e295[1]) * 4294967296lu) + u64(_e295[0])));
                let _e304 = params.member.member.member_10;
                let _e311 = bitcast<f64>(((u64(_e304[1]) * 4294967296lu) + u64(_e304[0])));
                let _e313 = local_2[_e290];
                let _e315 = ((_e313 - _e302) * _e311);
                let _e316 = bitcast<u64>(_e315);
                let _e317 = u32(_e316);
                let _e319 = u32((_e316 / 4294967296lu));
                let _e320 = (_e319 & 2147483648u);
                let _e323 = ((_e319 >> bitcast<u32>(20i)) & 2047u);
                let _e329 = (((_e319 & 1048575u) << bitcast<u32>(3i)) | (_e317 >> bitcast<u32>(29i)));
                let _e330 = (_e317 & 536870911u);
                if (_e323 == 2047u) {
                    phi_651_ = false;
                    phi_652_ = (2139095040u | _e329);
                } else {
                    if (_e323 > 1150u) {
                        phi_649_ = true;
                        phi_650_ = 2139095039u;
                    } else {
                        if (_e323 > 896u) {
                            phi_647_ = (_e330 != 0u);
                            phi_648_ = (((_e323 - 896u) << bitcast<u32>(23i)) | _e329);
                        } else {
                            if (_e323 >= 873u) {
                                let _e338 = (8388608u | _e329);
                                let _e339 = (897u - _e323);
                                phi_645_ = (((_e338 & ((1u << bitcast<u32>((_e339 & 31u))) - 1u)) | _e330) != 0u);
                                phi_646_ = (_e338 >> bitcast<u32>((_e339 & 31u)));
                            } else {
                                phi_645_ = (((_e319 & 2147483647u) | _e317) != 0u);
                                phi_646_ = 0u;
                            }
                            let _e351 = phi_645_;
                            let _e353 = phi_646_;
                            phi_647_ = _e351;
                            phi_648_ = _e353;
                        }
                        let _e360 = phi_647_;
                        let _e362 = phi_648_;
                        phi_649_ = _e360;
                        phi_650_ = _e362;
                    }
                    let _e364 = phi_649_;
                    let _e366 = phi_650_;
                    phi_651_ = _e364;
                    phi_652_ = _e366;
                }
                let _e369 = phi_651_;
                let _e371 = phi_652_;
                let _e379 = select(bitcast<f32>(((_e320 | _e371) + select(0u, 1u, _e369))), bitcast<f32>((_e320 | _e371)), (_e320 == 0u));
                let _e380 = bitcast<u64>(_e315);
                let _e381 = u32(_e380);
                let _e383 = u32((_e380 / 4294967296lu));
                let _e384 = (_e383 & 2147483648u);
                let _e387 = ((_e383 >> bitcast<u32>(20i)) & 2047u);
                let _e393 = (((_e383 & 1048575u) << bitcast<u32>(3i)) | (_e381 >> bitcast<u32>(29i)));
                let _e394 = (_e381 & 536870911u);
                if (_e387 == 2047u) {
                    phi_719_ = false;
                    phi_720_ = (2139095040u | _e393);
                } else {
                    if (_e387 > 1150u) {
                        phi_717_ = true;
                        phi_718_ = 2139095039u;
                    } else {
                        if (_e387 > 896u) {
                            phi_715_ = (_e394 != 0u);
                            phi_716_ = (((_e387 - 896u) << bitcast<u32>(23i)) | _e393);
                        } else {
                            if (_e387 >= 873u) {
                                let _e402 = (8388608u | _e393);
                                let _e403 = (897u - _e387);
                                phi_713_ = (((_e402 & ((1u << bitcast<u32>((_e403 & 31u))) - 1u)) | _e394) != 0u);
                                phi_714_ = (_e402 >> bitcast<u32>((_e403 & 31u)));
                            } else {
                                phi_713_ = (((_e383 & 2147483647u) | _e381) != 0u);
                                phi_714_ = 0u;
                            }
                            let _e415 = phi_713_;
                            let _e417 = phi_714_;
                            phi_715_ = _e415;
                            phi_716_ = _e417;
                        }
                        let _e424 = phi_715_;
                        let _e426 = phi_716_;
                        phi_717_ = _e424;
                        phi_718_ = _e426;
                    }
                    let _e428 = phi_717_;
                    let _e430 = phi_718_;
                    phi_719_ = _e428;
                    phi_720_ = _e430;
                }
                let _e433 = phi_719_;
                let _e435 = phi_720_;
                let _e443 = select(bitcast<f32>((_e384 | _e435)), bitcast<f32>(((_e384 | _e435) + select(0u, 1u, _e433))), (_e384 == 0u));
                let _e445 = (_e315 - f64(_e379));
                let _e447 = (f64(_e443) - _e315);
                local_4.member[_e290] = select(_e443, _e379, select(select(true, false, select(true, select(true, false, ((bitcast<u32>(_e379) & 1u) == 0u)), (_e445 == _e447))), true, (_e445 < _e447)));
                let _e461 = local_3[_e290];
                let _e463 = ((_e461 - _e302) * _e311);
                let _e464 = bitcast<u64>(_e463);
                let _e465 = u32(_e464);
                let _e467 = u32((_e464 / 4294967296lu));
                let _e468 = (_e467 & 2147483648u);
                let _e471 = ((_e467 >> bitcast<u32>(20i)) & 2047u);
                let _e477 = (((_e467 & 1048575u) << bitcast<u32>(3i)) | (_e465 >> bitcast<u32>(29i)));
                let _e478 = (_e465 & 536870911u);
                if (_e471 == 2047u) {
                    phi_831_ = false;
                    phi_832_ = (2139095040u | _e477);
                } else {
                    if (_e471 > 1150u) {
                        phi_829_ = true;
                        phi_830_ = 2139095039u;
                    } else {
                        if (_e471 > 896u) {
                            phi_827_ = (_e478 != 0u);
                            phi_828_ = (((_e471 - 896u) << bitcast<u32>(23i)) | _e477);
                        } else {
                            if (_e471 >= 873u) {
                                let _e486 = (8388608u | _e477);
                                let _e487 = (897u - _e471);
                                phi_825_ = (((_e486 & ((1u << bitcast<u32>((_e487 & 31u))) - 1u)) | _e478) != 0u);
                                phi_826_ = (_e486 >> bitcast<u32>((_e487 & 31u)));
                            } else {
                                phi_825_ = (((_e467 & 2147483647u) | _e465) != 0u);
                                phi_826_ = 0u;
                            }
                            let _e499 = phi_825_;
                            let _e501 = phi_826_;
                            phi_827_ = _e499;
                            phi_828_ = _e501;
                        }
                        let _e508 = phi_827_;
                        let _e510 = phi_828_;
                        phi_829_ = _e508;
                        phi_830_ = _e510;
                    }
                    let _e512 = phi_829_;
                    let _e514 = phi_830_;
                    phi_831_ = _e512;
                    phi_832_ = _e514;
                }
                let _e517 = phi_831_;
                let _e519 = phi_832_;
                let _e527 = select(bitcast<f32>(((_e468 | _e519) + select(0u, 1u, _e517))), bitcast<f32>((_e468 | _e519)), (_e468 == 0u));
                let _e528 = bitcast<u64>(_e463);
                let _e529 = u32(_e528);
                let _e531 = u32((_e528 / 4294967296lu));
                let _e532 = (_e531 & 2147483648u);
                let _e535 = ((_e531 >> bitcast<u32>(20i)) & 2047u);
                let _e541 = (((_e531 & 1048575u) << bitcast<u32>(3i)) | (_e529 >> bitcast<u32>(29i)));
                let _e542 = (_e529 & 536870911u);
                if (_e535 == 2047u) {
                    phi_899_ = false;
                    phi_900_ = (2139095040u | _e541);
                } else {
                    if (_e535 > 1150u) {
                        phi_897_ = true;
                        phi_898_ = 2139095039u;
                    } else {
                        if (_e535 > 896u) {
                            phi_895_ = (_e542 != 0u);
                            phi_896_ = (((_e535 - 896u) << bitcast<u32>(23i)) | _e541);
                        } else {
                            if (_e535 >= 873u) {
                                let _e550 = (8388608u | _e541);
                                let _e551 = (897u - _e535);
                                phi_893_ = (((_e550 & ((1u << bitcast<u32>((_e551 & 31u))) - 1u)) | _e542) != 0u);
                                phi_894_ = (_e550 >> bitcast<u32>((_e551 & 31u)));
                            } else {
                                phi_893_ = (((_e531 & 2147483647u) | _e529) != 0u);
                                phi_894_ = 0u;
                            }
                            let _e563 = phi_893_;
                            let _e565 = phi_894_;
                            phi_895_ = _e563;
                            phi_896_ = _e565;
                        }
                        let _e572 = phi_895_;
                        let _e574 = phi_896_;
                        phi_897_ = _e572;
                        phi_898_ = _e574;
                    }
                    let _e576 = phi_897_;
                    let _e578 = phi_898_;
                    phi_899_ = _e576;
                    phi_900_ = _e578;
                }
                let _e581 = phi_899_;
                let _e583 = phi_900_;
                let _e591 = select(bitcast<f32>((_e532 | _e583)), bitcast<f32>(((_e532 | _e583) + select(0u, 1u, _e581))), (_e532 == 0u));
                let _e593 = (_e463 - f64(_e527));
                let _e595 = (f64(_e591) - _e463);
                local_4.member_1[_e290] = select(_e591, _e527, select(select(true, false, select(true, select(true, false, ((bitcast<u32>(_e527) & 1u) == 0u)), (_e593 == _e595))), true, (_e593 < _e595)));
            }
            continue;
            continuing {
                phi_534_ = type_9(select(_e276.member, (_e276.member + 1u), _e279), select(_e276.member_1, _e276.member_1, _e279));
                break if !(_e292);
            }
        }
        let _e609 = local_4;
        paths.member[_e69] = type_15(array<f32, 4>(_e609.member[0], _e609.member[1], _e609.member[2], _e609.member[3]), array<f32, 4>(_e609.member_1[0], _e609.member_1[1], _e609.member_1[2], _e609.member_1[3]));
        let _e625 = local_9.member;
        let _e630 = local_9.member_1;
        let _e634 = bitcast<u64>(_e625[0]);
        let _e635 = u32(_e634);
        let _e637 = u32((_e634 / 4294967296lu));
        if ((_e637 >> bitcast<u32>(31i)) == 0u) {
            phi_1007_ = array<u32, 2>();
            phi_1008_ = true;
        } else {
            let _e644 = select(true, select(true, false, (_e635 == 0u)), (_e637 == 2147483648u));
            phi_1007_ = array<u32, 2>(select(array<u32, 2>()[0], ~(_e635), _e644), select(array<u32, 2>()[1], ~(_e637), _e644));
            phi_1008_ = select(true, false, _e644);
        }
        let _e654 = phi_1007_;
        let _e656 = phi_1008_;
        let _e663 = bitcast<u64>(_e625[1]);
        let _e664 = u32(_e663);
        let _e666 = u32((_e663 / 4294967296lu));
        if ((_e666 >> bitcast<u32>(31i)) == 0u) {
            phi_1043_ = array<u32, 2>();
            phi_1044_ = true;
        } else {
            let _e673 = select(true, select(true, false, (_e664 == 0u)), (_e666 == 2147483648u));
            phi_1043_ = array<u32, 2>(select(array<u32, 2>()[0], ~(_e664), _e673), select(array<u32, 2>()[1], ~(_e666), _e673));
            phi_1044_ = select(true, false, _e673);
        }
        let _e683 = phi_1043_;
        let _e685 = phi_1044_;
        let _e692 = bitcast<u64>(_e625[2]);
        let _e693 = u32(_e692);
        let _e695 = u32((_e692 / 4294967296lu));
        if ((_e695 >> bitcast<u32>(31i)) == 0u) {
            phi_1079_ = array<u32, 2>();
            phi_1080_ = true;
        } else {
            let _e702 = select(true, select(true, false, (_e693 == 0u)), (_e695 == 2147483648u));
            phi_1079_ = array<u32, 2>(select(array<u32, 2>()[0], ~(_e693), _e702), select(array<u32, 2>()[1], ~(_e695), _e702));
            phi_1080_ = select(true, false, _e702);
        }
        let _e712 = phi_1079_;
        let _e714 = phi_1080_;
        let _e721 = bitcast<u64>(_e630[0]);
        let _e722 = u32(_e721);
        let _e724 = u32((_e721 / 4294967296lu));
        if ((_e724 >> bitcast<u32>(31i)) == 0u) {
            phi_1115_ = array<u32, 2>();
            phi_1116_ = true;
        } else {
            let _e731 = select(true, select(true, false, (_e722 == 0u)), (_e724 == 2147483648u));
            phi_1115_ = array<u32, 2>(select(array<u32, 2>()[0], ~(_e722), _e731), select(array<u32, 2>()[1], ~(_e724), _e731));
            phi_1116_ = select(true, false, _e731);
        }
        let _e741 = phi_1115_;
        let _e743 = phi_1116_;
        let _e750 = bitcast<u64>(_e630[1]);
        let _e751 = u32(_e750);
        let _e753 = u32((_e750 / 4294967296lu));
        if ((_e753 >> bitcast<u32>(31i)) == 0u) {
            phi_1151_ = array<u32, 2>();
            phi_1152_ = true;
        } else {
            let _e760 = select(true, select(true, false, (_e751 == 0u)), (_e753 == 2147483648u));
            phi_1151_ = array<u32, 2>(select(array<u32, 2>()[0], ~(_e751), _e760), select(array<u32, 2>()[1], ~(_e753), _e760));
            phi_1152_ = select(true, false, _e760);
        }
        let _e770 = phi_1151_;
        let _e772 = phi_1152_;
        let _e779 = bitcast<u64>(_e630[2]);
        let _e780 = u32(_e779);
        let _e782 = u32((_e779 / 4294967296lu));
        if ((_e782 >> bitcast<u32>(31i)) == 0u) {
            phi_1187_ = array<u32, 2>();
            phi_1188_ = true;
        } else {
            let _e789 = select(true, select(true, false, (_e780 == 0u)), (_e782 == 2147483648u));
            phi_1187_ = array<u32, 2>(select(array<u32, 2>()[0], ~(_e780), _e789), select(array<u32, 2>()[1], ~(_e782), _e789));
            phi_1188_ = select(true, false, _e789);
        }
        let _e799 = phi_1187_;
        let _e801 = phi_1188_;
        keys.member[_e69] = array<array<u32, 2>, 6>(array<u32, 2>(select(_e654[0], _e635, _e656), select(_e654[1], (_e637 | 2147483648u), _e656)), array<u32, 2>(select(_e683[0], _e664, _e685), select(_e683[1], (_e666 | 2147483648u), _e685)), array<u32, 2>(select(_e712[0], _e693, _e714), select(_e712[1], (_e695 | 2147483648u), _e714)), array<u32, 2>(select(_e741[0], _e722, _e743), select(_e741[1], (_e724 | 2147483648u), _e743)), array<u32, 2>(select(_e770[0], _e751, _e772), select(_e770[1], (_e753 | 2147483648u), _e772)), array<u32, 2>(select(_e799[0], _e780, _e801), select(_e799[1], (_e782 | 2147483648u), _e801)));
        local_1 = type_19(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        phi_1200_ = type_9(0u, 3u);
        loop {
            let _e811 = phi_1200_;
            let _e814 = (_e811.member < _e811.member_1);
            let _e825 = select(type_9().member_1, _e811.member, _e814);
            let _e827 = (bitcast<i32>(select(0u, 1u, _e814)) != 0i);
            if _e827 {
                let _e830 = local_9.member[_e825];
                let _e831 = bitcast<u64>(_e830);
                let _e832 = u32(_e831);
                let _e834 = u32((_e831 / 4294967296lu));
                let _e835 = (_e834 & 2147483648u);
                let _e838 = ((_e834 >> bitcast<u32>(20i)) & 2047u);
                let _e844 = (((_e834 & 1048575u) << bitcast<u32>(3i)) | (_e832 >> bitcast<u32>(29i)));
                let _e845 = (_e832 & 536870911u);
                if (_e838 == 2047u) {
                    phi_1291_ = false;
                    phi_1292_ = (2139095040u | _e844);
                } else {
                    if (_e838 > 1150u) {
                        phi_1289_ = true;
                        phi_1290_ = 2139095039u;
                    } else {
                        if (_e838 > 896u) {
                            phi_1287_ = (_e845 != 0u);
                            phi_1288_ = (((_e838 - 896u) << bitcast<u32>(23i)) | _e844);
                        } else {
                            if (_e838 >= 873u) {
                                let _e853 = (8388608u | _e844);
                                let _e854 = (897u - _e838);
                                phi_1285_ = (((_e853 & ((1u << bitcast<u32>((_e854 & 31u))) - 1u)) | _e845) != 0u);
                                phi_1286_ = (_e853 >> bitcast<u32>((_e854 & 31u)));
                            } else {
                                phi_1285_ = (((_e834 & 2147483647u) | _e832) != 0u);
                                phi_1286_ = 0u;
                            }
                            let _e866 = phi_1285_;
                            let _e868 = phi_1286_;
                            phi_1287_ = _e866;
                            phi_1288_ = _e868;
                        }
                        let _e875 = phi_1287_;
                        let _e877 = phi_1288_;
                        phi_1289_ = _e875;
                        phi_1290_ = _e877;
                    }
                    let _e879 = phi_1289_;
                    let _e881 = phi_1290_;
                    phi_1291_ = _e879;
                    phi_1292_ = _e881;
                }
                let _e884 = phi_1291_;
                let _e886 = phi_1292_;
                let _e894 = select(bitcast<f32>(((_e835 | _e886) + select(0u, 1u, _e884))), bitcast<f32>((_e835 | _e886)), (_e835 == 0u));
                let _e895 = -(290000000000000000000000000000000000000f);
                let _e897 = select(_e895, _e894, (_e894 > _e895));
                local_1.member[_e825] = select(290000000000000000000000000000000000000f, _e897, (_e897 < 290000000000000000000000000000000000000f));
                let _e904 = local_9.member_1[_e825];
                let _e905 = bitcast<u64>(_e904);
                let _e906 = u32(_e905);
                let _e908 = u32((_e905 / 4294967296lu));
                let _e909 = (_e908 & 2147483648u);
                let _e912 = ((_e908 >> bitcast<u32>(20i)) & 2047u);
                let _e918 = (((_e908 & 1048575u) << bitcast<u32>(3i)) | (_e906 >> bitcast<u32>(29i)));
                let _e919 = (_e906 & 536870911u);
                if (_e912 == 2047u) {
                    phi_1384_ = false;
                    phi_1385_ = (2139095040u | _e918);
                } else {
                    if (_e912 > 1150u) {
                        phi_1382_ = true;
                        phi_1383_ = 2139095039u;
                    } else {
                        if (_e912 > 896u) {
                            phi_1380_ = (_e919 != 0u);
                            phi_1381_ = (((_e912 - 896u) << bitcast<u32>(23i)) | _e918);
                        } else {
                            if (_e912 >= 873u) {
                                let _e927 = (8388608u | _e918);
                                let _e928 = (897u - _e912);
                                phi_1378_ = (((_e927 & ((1u << bitcast<u32>((_e928 & 31u))) - 1u)) | _e919) != 0u);
                                phi_1379_ = (_e927 >> bitcast<u32>((_e928 & 31u)));
                            } else {
                                phi_1378_ = (((_e908 & 2147483647u) | _e906) != 0u);
                                phi_1379_ = 0u;
                            }
                            let _e940 = phi_1378_;
                            let _e942 = phi_1379_;
                            phi_1380_ = _e940;
                            phi_1381_ = _e942;
                        }
                        let _e949 = phi_1380_;
                        let _e951 = phi_1381_;
                        phi_1382_ = _e949;
                        phi_1383_ = _e951;
                    }
                    let _e953 = phi_1382_;
                    let _e955 = phi_1383_;
                    phi_1384_ = _e953;
                    phi_1385_ = _e955;
                }
                let _e958 = phi_1384_;
                let _e960 = phi_1385_;
                let _e968 = select(bitcast<f32>((_e909 | _e960)), bitcast<f32>(((_e909 | _e960) + select(0u, 1u, _e958))), (_e909 == 0u));
                let _e969 = -(290000000000000000000000000000000000000f);
                let _e971 = select(_e969, _e968, (_e968 > _e969));
                local_1.member_1[_e825] = select(290000000000000000000000000000000000000f, _e971, (_e971 < 290000000000000000000000000000000000000f));
            }
            continue;
            continuing {
                phi_1200_ = type_9(select(_e811.member, (_e811.member + 1u), _e814), select(_e811.member_1, _e811.member_1, _e814));
                break if !(_e827);
            }
        }
        let _e977 = local_1;
        local = _e977;
        phi_1443_ = type_9(0u, 3u);
        loop {
            let _e979 = phi_1443_;
            let _e982 = (_e979.member < _e979.member_1);
            let _e993 = select(type_9().member_1, _e979.member, _e982);
            let _e995 = (bitcast<i32>(select(0u, 1u, _e982)) != 0i);
            if _e995 {
                let _e998 = local.member[_e993];
                if select(false, (_e998 > -(0.000000000000000000000000000000000000011754944f)), (_e998 < 0.000000000000000000000000000000000000011754944f)) {
                    let _e1008 = local_9.member[_e993];
                    let _e1010 = bitcast<u64>(-(_e1008));
                    let _e1013 = u32((_e1010 / 4294967296lu));
                    phi_1524_ = -(select(0f, 0.000000000000000000000000000000000000011754944f, select(false, ((u32(_e1010) | _e1013) != 0u), ((_e1013 >> bitcast<u32>(31i)) == 0u))));
                } else {
                    let _e1005 = local.member[_e993];
                    phi_1524_ = _e1005;
                }
                let _e1023 = phi_1524_;
                local.member[_e993] = _e1023;
                let _e1028 = local.member_1[_e993];
                if select(false, (_e1028 > -(0.000000000000000000000000000000000000011754944f)), (_e1028 < 0.000000000000000000000000000000000000011754944f)) {
                    let _e1038 = local_9.member_1[_e993];
                    let _e1039 = bitcast<u64>(_e1038);
                    let _e1042 = u32((_e1039 / 4294967296lu));
                    phi_1581_ = select(0f, 0.000000000000000000000000000000000000011754944f, select(false, ((u32(_e1039) | _e1042) != 0u), ((_e1042 >> bitcast<u32>(31i)) == 0u)));
                } else {
                    let _e1035 = local.member_1[_e993];
                    phi_1581_ = _e1035;
                }
                let _e1051 = phi_1581_;
                local.member_1[_e993] = _e1051;
            }
            continue;
            continuing {
                phi_1443_ = type_9(select(_e979.member, (_e979.member + 1u), _e982), select(_e979.member_1, _e979.member_1, _e982));
                break if !(_e995);
            }
        }
        let _e1055 = local;
        boxes.member[_e69] = type_19(array<f32, 3>(_e1055.member[0], _e1055.member[1], _e1055.member[2]), array<f32, 3>(_e1055.member_1[0], _e1055.member_1[1], _e1055.member_1[2]));
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn place_vertices(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}

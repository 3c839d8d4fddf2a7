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

struct type_18 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: array<u32, 2>,
}

struct type_19 {
    member: type_7,
    member_1: type_8,
    member_2: type_18,
}

struct type_20 {
    member: type_19,
}

struct type_22 {
    member: array<u32, 5>,
    member_1: u32,
}

struct type_23 {
    member: array<u32, 3>,
    member_1: u32,
    member_2: array<u32, 3>,
    member_3: u32,
}

struct type_25 {
    member: array<type_23>,
}

struct type_28 {
    member: array<atomic<u32>>,
}

@group(0) @binding(4) 
var<storage> input: type_10;
@group(0) @binding(0) 
var<storage> params: type_20;
@group(0) @binding(2) 
var<storage> regions: type_10;
@group(0) @binding(5) 
var<storage, read_write> vf: type_28;
@group(0) @binding(6) 
var<storage, read_write> ee: type_28;
@group(0) @binding(7) 
var<storage, read_write> counts: type_28;
var<workgroup> shared_: array<atomic<u32>, 12>;
@group(0) @binding(1) 
var<storage> triangles: type_25;
@group(0) @binding(3) 
var<storage> boxes: type_17;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_149_: u32;
    var phi_159_: u32;
    var phi_166_: u32;
    var phi_187_: u32;
    var phi_208_: u32;
    var phi_209_: u32;
    var phi_212_: type_12;
    var phi_213_: type_12;
    var phi_236_: type_12;
    var phi_330_: bool;
    var phi_337_: bool;
    var phi_341_: bool;
    var phi_360_: bool;
    var phi_367_: bool;
    var phi_375_: bool;
    var phi_385_: bool;
    var phi_392_: bool;
    var phi_400_: bool;
    var phi_411_: bool;
    var phi_418_: bool;
    var phi_426_: bool;
    var phi_432_: bool;
    var phi_433_: bool;
    var phi_469_: bool;
    var phi_470_: bool;
    var phi_521_: bool;
    var phi_528_: bool;
    var phi_536_: bool;
    var phi_577_: u32;
    var phi_578_: u32;
    var phi_595_: bool;
    var phi_602_: bool;
    var phi_610_: bool;
    var phi_651_: u32;
    var phi_652_: u32;
    var phi_670_: bool;
    var phi_677_: bool;
    var phi_685_: bool;
    var phi_726_: u32;
    var phi_727_: u32;
    var phi_730_: u32;
    var phi_731_: u32;
    var phi_732_: u32;
    var phi_733_: u32;
    var phi_775_: bool;
    var phi_782_: bool;
    var phi_790_: bool;
    var phi_831_: u32;
    var phi_832_: u32;
    var phi_849_: bool;
    var phi_856_: bool;
    var phi_864_: bool;
    var phi_905_: u32;
    var phi_906_: u32;
    var phi_924_: bool;
    var phi_931_: bool;
    var phi_939_: bool;
    var phi_980_: u32;
    var phi_981_: u32;
    var phi_985_: u32;
    var phi_986_: u32;
    var phi_987_: u32;
    var phi_988_: u32;
    var phi_1036_: type_15;
    var phi_1058_: type_15;
    var phi_1080_: type_15;
    var phi_1110_: type_15;
    var phi_1117_: bool;
    var phi_1123_: bool;
    var phi_1156_: bool;
    var phi_1162_: bool;
    var phi_1197_: bool;
    var phi_1203_: bool;
    var phi_1253_: type_15;
    var phi_1260_: bool;
    var phi_1266_: bool;
    var phi_1300_: bool;
    var phi_1306_: bool;
    var phi_1341_: bool;
    var phi_1347_: bool;
    var phi_1398_: type_15;
    var phi_1405_: bool;
    var phi_1411_: bool;
    var phi_1446_: bool;
    var phi_1452_: bool;
    var phi_1487_: bool;
    var phi_1493_: bool;
    var phi_1525_: u32;
    var phi_1526_: u32;
    var phi_1527_: u32;
    var phi_1528_: u32;
    var phi_1531_: type_22;
    var phi_1532_: type_22;
    var phi_1533_: type_22;
    var phi_1534_: bool;
    var phi_1535_: type_22;
    var phi_1536_: type_22;
    var phi_1537_: bool;
    var phi_1541_: type_22;
    var phi_1590_: u32;
    var phi_1591_: u32;
    var phi_1592_: u32;
    var phi_1593_: u32;
    var phi_1594_: u32;
    var phi_1595_: type_12;
    var phi_1650_: type_12;
    var phi_1653_: u32;
    var phi_1651_: type_12;
    var phi_1676_: type_12;
    var phi_1769_: u32;
    var phi_1770_: u32;
    var phi_1783_: u32;
    var phi_1784_: u32;
    var phi_1791_: type_12;
    var phi_1753_: u32;
    var phi_1754_: u32;
    var phi_1795_: type_12;
    var phi_1734_: u32;
    var phi_1735_: u32;
    var phi_1796_: type_12;
    var phi_1811_: u32;
    var phi_1654_: u32;
    var phi_1814_: type_12;
    var phi_1817_: u32;
    var phi_1815_: type_12;
    var phi_1840_: type_12;
    var phi_1931_: u32;
    var phi_1932_: u32;
    var phi_1945_: u32;
    var phi_1946_: u32;
    var phi_1953_: type_12;
    var phi_1915_: u32;
    var phi_1916_: u32;
    var phi_1957_: type_12;
    var phi_1896_: u32;
    var phi_1897_: u32;
    var phi_1958_: type_12;
    var phi_1973_: u32;
    var phi_1818_: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e47 = id_2;
    let _e48 = n_2;
    let _e49 = lane_2;
    let _e62 = ((_e47.y * _e48.x) + _e47.x);
    let _e65 = (_e48.x * _e48.y);
    let _e69 = params.member.member_2.member_1;
    let _e71 = params.member.member_1.member_2;
    let _e73 = input.member[0u];
    if (_e71 < _e73) {
        phi_149_ = _e71;
    } else {
        phi_149_ = _e73;
    }
    let _e76 = phi_149_;
    let _e78 = params.member.member_1.member_1;
    if (_e76 > _e78) {
        let _e81 = params.member.member_1.member_1;
        phi_159_ = (_e76 - _e81);
    } else {
        phi_159_ = 0u;
    }
    let _e84 = phi_159_;
    let _e86 = params.member.member_1.member;
    if (_e86 < _e84) {
        phi_166_ = _e86;
    } else {
        phi_166_ = _e84;
    }
    let _e89 = phi_166_;
    if (_e49 < 5u) {
        atomicStore((&shared_[_e49]), 0u);
    }
    workgroupBarrier();
    let _e92 = (_e89 / 128u);
    if ((_e89 % 128u) > 0u) {
        phi_187_ = (_e92 + 1u);
    } else {
        phi_187_ = _e92;
    }
    let _e97 = phi_187_;
    if (_e97 > _e62) {
        let _e99 = (_e97 - _e62);
        if (_e65 == 0u) {
            return;
        }
        let _e101 = (_e99 / _e65);
        if (_e65 == 0u) {
            return;
        }
        if ((_e99 % _e65) > 0u) {
            phi_208_ = (_e101 + 1u);
        } else {
            phi_208_ = _e101;
        }
        let _e107 = phi_208_;
        phi_209_ = _e107;
    } else {
        phi_209_ = 0u;
    }
    let _e109 = phi_209_;
    phi_212_ = type_12(0u, _e109);
    loop {
        let _e112 = phi_212_;
        if (_e112.member < _e112.member_1) {
            phi_213_ = type_12((_e112.member + 1u), _e112.member_1);
            phi_236_ = type_12(1u, _e112.member);
        } else {
            phi_213_ = _e112;
            phi_236_ = type_12(0u, type_12().member_1);
        }
        let _e124 = phi_213_;
        let _e126 = phi_236_;
        let _e130 = (bitcast<i32>(_e126.member) != 0i);
        if _e130 {
            let _e134 = (((_e62 + (_e126.member_1 * _e65)) * 128u) + _e49);
            if (_e49 == 0u) {
                atomicStore((&shared_[5u]), 0u);
                atomicStore((&shared_[6u]), 0u);
            }
            workgroupBarrier();
            if (_e134 < _e89) {
                let _e140 = params.member.member_1.member_1;
                let _e142 = (2u * (_e140 + _e134));
                let _e145 = input.member[(4u + _e142)];
                let _e148 = input.member[(_e142 + 5u)];
                let _e153 = triangles.member[_e145];
                let _e155 = triangles.member[_e148];
                let _e157 = params.member.member.member_1;
                if ((_e157 & 2u) != 0u) {
                    let _e163 = params.member.member.member_1;
                    if ((_e153.member_3 / 2u) != (_e155.member_3 / 2u)) {
                        phi_330_ = true;
                    } else {
                        phi_330_ = ((_e163 & 4u) != 0u);
                    }
                    let _e170 = phi_330_;
                    if _e170 {
                        phi_337_ = (((_e153.member_3 & _e155.member_3) & 1u) == 0u);
                    } else {
                        phi_337_ = false;
                    }
                    let _e175 = phi_337_;
                    phi_341_ = _e175;
                } else {
                    phi_341_ = true;
                }
                let _e177 = phi_341_;
                if _e177 {
                    let _e179 = params.member.member_2.member;
                    if ((_e179 & 1u) != 0u) {
                        if (_e155.member[0] == _e153.member[0]) {
                            phi_360_ = true;
                        } else {
                            phi_360_ = (_e155.member[0] == _e153.member[0]);
                        }
                        let _e189 = phi_360_;
                        if (_e155.member[1] == _e153.member[0]) {
                            phi_367_ = true;
                        } else {
                            phi_367_ = (_e155.member[1] == _e153.member[0]);
                        }
                        let _e194 = phi_367_;
                        if (_e155.member[2] == _e153.member[0]) {
                            phi_375_ = true;
                        } else {
                            phi_375_ = (_e155.member[2] == _e153.member[0]);
                        }
                        let _e200 = phi_375_;
                        if (_e155.member[0] == _e153.member[1]) {
                            phi_385_ = true;
                        } else {
                            phi_385_ = (_e155.member[0] == _e153.member[1]);
                        }
                        let _e209 = phi_385_;
                        if (_e155.member[1] == _e153.member[1]) {
                            phi_392_ = true;
                        } else {
                            phi_392_ = (_e155.member[1] == _e153.member[1]);
                        }
                        let _e214 = phi_392_;
                        if (_e155.member[2] == _e153.member[1]) {
                            phi_400_ = true;
                        } else {
                            phi_400_ = (_e155.member[2] == _e153.member[1]);
                        }
                        let _e220 = phi_400_;
                        if (_e155.member[0] == _e153.member[2]) {
                            phi_411_ = true;
                        } else {
                            phi_411_ = (_e155.member[0] == _e153.member[2]);
                        }
                        let _e230 = phi_411_;
                        if (_e155.member[1] == _e153.member[2]) {
                            phi_418_ = true;
                        } else {
                            phi_418_ = (_e155.member[1] == _e153.member[2]);
                        }
                        let _e235 = phi_418_;
                        if (_e155.member[2] == _e153.member[2]) {
                            phi_426_ = true;
                        } else {
                            phi_426_ = (_e155.member[2] == _e153.member[2]);
                        }
                        let _e241 = phi_426_;
                        if ((((_e189 || _e194) || _e200) || ((_e209 || _e214) || _e220)) || ((_e230 || _e235) || _e241)) {
                            phi_432_ = false;
                        } else {
                            phi_432_ = true;
                        }
                        let _e245 = phi_432_;
                        phi_433_ = _e245;
                    } else {
                        phi_433_ = true;
                    }
                    let _e247 = phi_433_;
                    if _e247 {
                        let _e249 = params.member.member_2.member;
                        if ((_e249 & 2u) != 0u) {
                            let _e253 = regions.member[_e145];
                            let _e255 = regions.member[_e148];
                            if (_e253 == _e255) {
                                phi_469_ = (_e253 != 4294967295u);
                            } else {
                                phi_469_ = false;
                            }
                            let _e259 = phi_469_;
                            phi_470_ = _e259;
                        } else {
                            phi_470_ = false;
                        }
                        let _e261 = phi_470_;
                        if _e261 {
                            phi_1531_ = type_22();
                        } else {
                            let _e264 = countOneBits((_e153.member_1 & 7u));
                            let _e267 = countOneBits((_e155.member_1 & 7u));
                            let _e270 = params.member.member.member[2u];
                            if (_e148 < _e270) {
                                if (_e264 > 0u) {
                                    let _e275 = params.member.member.member_2[2u];
                                    let _e278 = boxes.member[(_e275 + _e148)];
                                    if ((_e153.member_1 & 1u) == 1u) {
                                        if (_e155.member[0] == _e153.member[0]) {
                                            phi_521_ = true;
                                        } else {
                                            phi_521_ = (_e155.member[0] == _e153.member[0]);
                                        }
                                        let _e289 = phi_521_;
                                        if (_e155.member[1] == _e153.member[0]) {
                                            phi_528_ = true;
                                        } else {
                                            phi_528_ = (_e155.member[1] == _e153.member[0]);
                                        }
                                        let _e294 = phi_528_;
                                        if (_e155.member[2] == _e153.member[0]) {
                                            phi_536_ = true;
                                        } else {
                                            phi_536_ = (_e155.member[2] == _e153.member[0]);
                                        }
                                        let _e300 = phi_536_;
                                        if ((_e289 || _e294) || _e300) {
                                            phi_577_ = 0u;
                                        } else {
                                            let _e303 = boxes.member[_e153.member[0]];
                                            phi_577_ = select(0u, 1u, ((((((_e303.member[0] <= _e278.member_1[0]) && (_e278.member[0] <= _e303.member_1[0])) && (_e303.member[1] <= _e278.member_1[1])) && (_e278.member[1] <= _e303.member_1[1])) && (_e303.member[2] <= _e278.member_1[2])) && (_e278.member[2] <= _e303.member_1[2])));
                                        }
                                        let _e341 = phi_577_;
                                        phi_578_ = _e341;
                                    } else {
                                        phi_578_ = 0u;
                                    }
                                    let _e343 = phi_578_;
                                    if (((_e153.member_1 >> bitcast<u32>(1u)) & 1u) == 1u) {
                                        if (_e155.member[0] == _e153.member[1]) {
                                            phi_595_ = true;
                                        } else {
                                            phi_595_ = (_e155.member[0] == _e153.member[1]);
                                        }
                                        let _e356 = phi_595_;
                                        if (_e155.member[1] == _e153.member[1]) {
                                            phi_602_ = true;
                                        } else {
                                            phi_602_ = (_e155.member[1] == _e153.member[1]);
                                        }
                                        let _e361 = phi_602_;
                                        if (_e155.member[2] == _e153.member[1]) {
                                            phi_610_ = true;
                                        } else {
                                            phi_610_ = (_e155.member[2] == _e153.member[1]);
                                        }
                                        let _e367 = phi_610_;
                                        if ((_e356 || _e361) || _e367) {
                                            phi_651_ = 0u;
                                        } else {
                                            let _e370 = boxes.member[_e153.member[1]];
                                            phi_651_ = (select(0u, 1u, ((((((_e370.member[0] <= _e278.member_1[0]) && (_e278.member[0] <= _e370.member_1[0])) && (_e370.member[1] <= _e278.member_1[1])) && (_e278.member[1] <= _e370.member_1[1])) && (_e370.member[2] <= _e278.member_1[2])) && (_e278.member[2] <= _e370.member_1[2]))) << bitcast<u32>(1u));
                                        }
                                        let _e410 = phi_651_;
                                        phi_652_ = _e410;
                                    } else {
                                        phi_652_ = 0u;
                                    }
                                    let _e412 = phi_652_;
                                    if (((_e153.member_1 >> bitcast<u32>(2u)) & 1u) == 1u) {
                                        if (_e155.member[0] == _e153.member[2]) {
                                            phi_670_ = true;
                                        } else {
                                            phi_670_ = (_e155.member[0] == _e153.member[2]);
                                        }
                                        let _e426 = phi_670_;
                                        if (_e155.member[1] == _e153.member[2]) {
                                            phi_677_ = true;
                                        } else {
                                            phi_677_ = (_e155.member[1] == _e153.member[2]);
                                        }
                                        let _e431 = phi_677_;
                                        if (_e155.member[2] == _e153.member[2]) {
                                            phi_685_ = true;
                                        } else {
                                            phi_685_ = (_e155.member[2] == _e153.member[2]);
                                        }
                                        let _e437 = phi_685_;
                                        if ((_e426 || _e431) || _e437) {
                                            phi_726_ = 0u;
                                        } else {
                                            let _e440 = boxes.member[_e153.member[2]];
                                            phi_726_ = (select(0u, 1u, ((((((_e440.member[0] <= _e278.member_1[0]) && (_e278.member[0] <= _e440.member_1[0])) && (_e440.member[1] <= _e278.member_1[1])) && (_e278.member[1] <= _e440.member_1[1])) && (_e440.member[2] <= _e278.member_1[2])) && (_e278.member[2] <= _e440.member_1[2]))) << bitcast<u32>(2u));
                                        }
                                        let _e480 = phi_726_;
                                        phi_727_ = _e480;
                                    } else {
                                        phi_727_ = 0u;
                                    }
                                    let _e482 = phi_727_;
                                    phi_730_ = _e264;
                                    phi_731_ = ((_e343 | _e412) | _e482);
                                } else {
                                    phi_730_ = 0u;
                                    phi_731_ = 0u;
                                }
                                let _e485 = phi_730_;
                                let _e487 = phi_731_;
                                phi_732_ = _e485;
                                phi_733_ = _e487;
                            } else {
                                phi_732_ = 0u;
                                phi_733_ = 0u;
                            }
                            let _e489 = phi_732_;
                            let _e491 = phi_733_;
                            let _e494 = params.member.member.member[2u];
                            if (_e145 < _e494) {
                                if (_e267 > 0u) {
                                    let _e500 = params.member.member.member_2[2u];
                                    let _e503 = boxes.member[(_e500 + _e145)];
                                    if ((_e155.member_1 & 1u) == 1u) {
                                        if (_e153.member[0] == _e155.member[0]) {
                                            phi_775_ = true;
                                        } else {
                                            phi_775_ = (_e153.member[0] == _e155.member[0]);
                                        }
                                        let _e514 = phi_775_;
                                        if (_e153.member[1] == _e155.member[0]) {
                                            phi_782_ = true;
                                        } else {
                                            phi_782_ = (_e153.member[1] == _e155.member[0]);
                                        }
                                        let _e519 = phi_782_;
                                        if (_e153.member[2] == _e155.member[0]) {
                                            phi_790_ = true;
                                        } else {
                                            phi_790_ = (_e153.member[2] == _e155.member[0]);
                                        }
                                        let _e525 = phi_790_;
                                        if ((_e514 || _e519) || _e525) {
                                            phi_831_ = 0u;
                                        } else {
                                            let _e528 = boxes.member[_e155.member[0]];
                                            phi_831_ = select(0u, 1u, ((((((_e528.member[0] <= _e503.member_1[0]) && (_e503.member[0] <= _e528.member_1[0])) && (_e528.member[1] <= _e503.member_1[1])) && (_e503.member[1] <= _e528.member_1[1])) && (_e528.member[2] <= _e503.member_1[2])) && (_e503.member[2] <= _e528.member_1[2])));
                                        }
                                        let _e566 = phi_831_;
                                        phi_832_ = _e566;
                                    } else {
                                        phi_832_ = 0u;
                                    }
                                    let _e568 = phi_832_;
                                    if (((_e155.member_1 >> bitcast<u32>(1u)) & 1u) == 1u) {
                                        if (_e153.member[0] == _e155.member[1]) {
                                            phi_849_ = true;
                                        } else {
                                            phi_849_ = (_e153.member[0] == _e155.member[1]);
                                        }
                                        let _e581 = phi_849_;
                                        if (_e153.member[1] == _e155.member[1]) {
                                            phi_856_ = true;
                                        } else {
                                            phi_856_ = (_e153.member[1] == _e155.member[1]);
                                        }
                                        let _e586 = phi_856_;
                                        if (_e153.member[2] == _e155.member[1]) {
                                            phi_864_ = true;
                                        } else {
                                            phi_864_ = (_e153.member[2] == _e155.member[1]);
                                        }
                                        let _e592 = phi_864_;
                                        if ((_e581 || _e586) || _e592) {
                                            phi_905_ = 0u;
                                        } else {
                                            let _e595 = boxes.member[_e155.member[1]];
                                            phi_905_ = (select(0u, 1u, ((((((_e595.member[0] <= _e503.member_1[0]) && (_e503.member[0] <= _e595.member_1[0])) && (_e595.member[1] <= _e503.member_1[1])) && (_e503.member[1] <= _e595.member_1[1])) && (_e595.member[2] <= _e503.member_1[2])) && (_e503.member[2] <= _e595.member_1[2]))) << bitcast<u32>(1u));
                                        }
                                        let _e635 = phi_905_;
                                        phi_906_ = _e635;
                                    } else {
                                        phi_906_ = 0u;
                                    }
                                    let _e637 = phi_906_;
                                    if (((_e155.member_1 >> bitcast<u32>(2u)) & 1u) == 1u) {
                                        if (_e153.member[0] == _e155.member[2]) {
                                            phi_924_ = true;
                                        } else {
                                            phi_924_ = (_e153.member[0] == _e155.member[2]);
                                        }
                                        let _e651 = phi_924_;
                                        if (_e153.member[1] == _e155.member[2]) {
                                            phi_931_ = true;
                                        } else {
                                            phi_931_ = (_e153.member[1] == _e155.member[2]);
                                        }
                                        let _e656 = phi_931_;
                                        if (_e153.member[2] == _e155.member[2]) {
                                            phi_939_ = true;
                                        } else {
                                            phi_939_ = (_e153.member[2] == _e155.member[2]);
                                        }
                                        let _e662 = phi_939_;
                                        if ((_e651 || _e656) || _e662) {
                                            phi_980_ = 0u;
                                        } else {
                                            let _e665 = boxes.member[_e155.member[2]];
                                            phi_980_ = (select(0u, 1u, ((((((_e665.member[0] <= _e503.member_1[0]) && (_e503.member[0] <= _e665.member_1[0])) && (_e665.member[1] <= _e503.member_1[1])) && (_e503.member[1] <= _e665.member_1[1])) && (_e665.member[2] <= _e503.member_1[2])) && (_e503.member[2] <= _e665.member_1[2]))) << bitcast<u32>(2u));
                                        }
                                        let _e705 = phi_980_;
                                        phi_981_ = _e705;
                                    } else {
                                        phi_981_ = 0u;
                                    }
                                    let _e707 = phi_981_;
                                    phi_985_ = (_e489 + _e267);
                                    phi_986_ = (_e491 | (((_e568 | _e637) | _e707) << bitcast<u32>(3i)));
                                } else {
                                    phi_985_ = _e489;
                                    phi_986_ = _e491;
                                }
                                let _e713 = phi_985_;
                                let _e715 = phi_986_;
                                phi_987_ = _e713;
                                phi_988_ = _e715;
                            } else {
                                phi_987_ = _e489;
                                phi_988_ = _e491;
                            }
                            let _e717 = phi_987_;
                            let _e719 = phi_988_;
                            let _e723 = countOneBits((_e153.member_1 >> bitcast<u32>(3i)));
                            let _e727 = countOneBits((_e155.member_1 >> bitcast<u32>(3i)));
                            if (_e723 > 0u) {
                                if (_e727 > 0u) {
                                    let _e734 = params.member.member.member_2[1u];
                                    if (((_e155.member_1 >> bitcast<u32>(3u)) & 1u) == 1u) {
                                        let _e750 = boxes.member[(_e734 + _e155.member_2[0])];
                                        phi_1036_ = _e750;
                                    } else {
                                        phi_1036_ = type_15(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                                    }
                                    let _e752 = phi_1036_;
                                    if (((_e155.member_1 >> bitcast<u32>(4u)) & 1u) == 1u) {
                                        let _e760 = boxes.member[(_e734 + _e155.member_2[1])];
                                        phi_1058_ = _e760;
                                    } else {
                                        phi_1058_ = type_15(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                                    }
                                    let _e762 = phi_1058_;
                                    if (((_e155.member_1 >> bitcast<u32>(5u)) & 1u) == 1u) {
                                        let _e770 = boxes.member[(_e734 + _e155.member_2[2])];
                                        phi_1080_ = _e770;
                                    } else {
                                        phi_1080_ = type_15(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                                    }
                                    let _e772 = phi_1080_;
                                    if (((_e153.member_1 >> bitcast<u32>(3u)) & 1u) == 1u) {
                                        let _e788 = boxes.member[(_e734 + _e153.member_2[0])];
                                        phi_1110_ = _e788;
                                    } else {
                                        phi_1110_ = type_15(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                                    }
                                    let _e790 = phi_1110_;
                                    if (_e155.member[0] == _e153.member[0]) {
                                        phi_1117_ = true;
                                    } else {
                                        phi_1117_ = (_e155.member[0] == _e153.member[1]);
                                    }
                                    let _e794 = phi_1117_;
                                    if (_e155.member[1] == _e153.member[0]) {
                                        phi_1123_ = true;
                                    } else {
                                        phi_1123_ = (_e155.member[1] == _e153.member[1]);
                                    }
                                    let _e798 = phi_1123_;
                                    if (_e155.member[1] == _e153.member[0]) {
                                        phi_1156_ = true;
                                    } else {
                                        phi_1156_ = (_e155.member[1] == _e153.member[1]);
                                    }
                                    let _e841 = phi_1156_;
                                    if (_e155.member[2] == _e153.member[0]) {
                                        phi_1162_ = true;
                                    } else {
                                        phi_1162_ = (_e155.member[2] == _e153.member[1]);
                                    }
                                    let _e845 = phi_1162_;
                                    if (_e155.member[2] == _e153.member[0]) {
                                        phi_1197_ = true;
                                    } else {
                                        phi_1197_ = (_e155.member[2] == _e153.member[1]);
                                    }
                                    let _e891 = phi_1197_;
                                    if (_e155.member[0] == _e153.member[0]) {
                                        phi_1203_ = true;
                                    } else {
                                        phi_1203_ = (_e155.member[0] == _e153.member[1]);
                                    }
                                    let _e895 = phi_1203_;
                                    if (((_e153.member_1 >> bitcast<u32>(4u)) & 1u) == 1u) {
                                        let _e945 = boxes.member[(_e734 + _e153.member_2[1])];
                                        phi_1253_ = _e945;
                                    } else {
                                        phi_1253_ = type_15(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                                    }
                                    let _e947 = phi_1253_;
                                    if (_e155.member[0] == _e153.member[1]) {
                                        phi_1260_ = true;
                                    } else {
                                        phi_1260_ = (_e155.member[0] == _e153.member[2]);
                                    }
                                    let _e951 = phi_1260_;
                                    if (_e155.member[1] == _e153.member[1]) {
                                        phi_1266_ = true;
                                    } else {
                                        phi_1266_ = (_e155.member[1] == _e153.member[2]);
                                    }
                                    let _e955 = phi_1266_;
                                    if (_e155.member[1] == _e153.member[1]) {
                                        phi_1300_ = true;
                                    } else {
                                        phi_1300_ = (_e155.member[1] == _e153.member[2]);
                                    }
                                    let _e1000 = phi_1300_;
                                    if (_e155.member[2] == _e153.member[1]) {
                                        phi_1306_ = true;
                                    } else {
                                        phi_1306_ = (_e155.member[2] == _e153.member[2]);
                                    }
                                    let _e1004 = phi_1306_;
                                    if (_e155.member[2] == _e153.member[1]) {
                                        phi_1341_ = true;
                                    } else {
                                        phi_1341_ = (_e155.member[2] == _e153.member[2]);
                                    }
                                    let _e1050 = phi_1341_;
                                    if (_e155.member[0] == _e153.member[1]) {
                                        phi_1347_ = true;
                                    } else {
                                        phi_1347_ = (_e155.member[0] == _e153.member[2]);
                                    }
                                    let _e1054 = phi_1347_;
                                    if (((_e153.member_1 >> bitcast<u32>(5u)) & 1u) == 1u) {
                                        let _e1105 = boxes.member[(_e734 + _e153.member_2[2])];
                                        phi_1398_ = _e1105;
                                    } else {
                                        phi_1398_ = type_15(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                                    }
                                    let _e1107 = phi_1398_;
                                    if (_e155.member[0] == _e153.member[2]) {
                                        phi_1405_ = true;
                                    } else {
                                        phi_1405_ = (_e155.member[0] == _e153.member[0]);
                                    }
                                    let _e1111 = phi_1405_;
                                    if (_e155.member[1] == _e153.member[2]) {
                                        phi_1411_ = true;
                                    } else {
                                        phi_1411_ = (_e155.member[1] == _e153.member[0]);
                                    }
                                    let _e1115 = phi_1411_;
                                    if (_e155.member[1] == _e153.member[2]) {
                                        phi_1446_ = true;
                                    } else {
                                        phi_1446_ = (_e155.member[1] == _e153.member[0]);
                                    }
                                    let _e1161 = phi_1446_;
                                    if (_e155.member[2] == _e153.member[2]) {
                                        phi_1452_ = true;
                                    } else {
                                        phi_1452_ = (_e155.member[2] == _e153.member[0]);
                                    }
                                    let _e1165 = phi_1452_;
                                    if (_e155.member[2] == _e153.member[2]) {
                                        phi_1487_ = true;
                                    } else {
                                        phi_1487_ = (_e155.member[2] == _e153.member[0]);
                                    }
                                    let _e1211 = phi_1487_;
                                    if (_e155.member[0] == _e153.member[2]) {
                                        phi_1493_ = true;
                                    } else {
                                        phi_1493_ = (_e155.member[0] == _e153.member[0]);
                                    }
                                    let _e1215 = phi_1493_;
                                    phi_1525_ = (_e717 + (_e723 * _e727));
                                    phi_1526_ = (_e719 | (((((((select(0u, 1u, (!((_e794 || _e798)) && ((((((_e790.member[0] <= _e752.member_1[0]) && (_e752.member[0] <= _e790.member_1[0])) && (_e790.member[1] <= _e752.member_1[1])) && (_e752.member[1] <= _e790.member_1[1])) && (_e790.member[2] <= _e752.member_1[2])) && (_e752.member[2] <= _e790.member_1[2])))) | (select(0u, 1u, (!((_e841 || _e845)) && ((((((_e790.member[0] <= _e762.member_1[0]) && (_e762.member[0] <= _e790.member_1[0])) && (_e790.member[1] <= _e762.member_1[1])) && (_e762.member[1] <= _e790.member_1[1])) && (_e790.member[2] <= _e762.member_1[2])) && (_e762.member[2] <= _e790.member_1[2])))) << bitcast<u32>(1i))) | (select(0u, 1u, (!((_e891 || _e895)) && ((((((_e790.member[0] <= _e772.member_1[0]) && (_e772.member[0] <= _e790.member_1[0])) && (_e790.member[1] <= _e772.member_1[1])) && (_e772.member[1] <= _e790.member_1[1])) && (_e790.member[2] <= _e772.member_1[2])) && (_e772.member[2] <= _e790.member_1[2])))) << bitcast<u32>(2i))) | (((select(0u, 1u, (!((_e951 || _e955)) && ((((((_e947.member[0] <= _e752.member_1[0]) && (_e752.member[0] <= _e947.member_1[0])) && (_e947.member[1] <= _e752.member_1[1])) && (_e752.member[1] <= _e947.member_1[1])) && (_e947.member[2] <= _e752.member_1[2])) && (_e752.member[2] <= _e947.member_1[2])))) << bitcast<u32>(3i)) | (select(0u, 1u, (!((_e1000 || _e1004)) && ((((((_e947.member[0] <= _e762.member_1[0]) && (_e762.member[0] <= _e947.member_1[0])) && (_e947.member[1] <= _e762.member_1[1])) && (_e762.member[1] <= _e947.member_1[1])) && (_e947.member[2] <= _e762.member_1[2])) && (_e762.member[2] <= _e947.member_1[2])))) << bitcast<u32>(4i))) | (select(0u, 1u, (!((_e1050 || _e1054)) && ((((((_e947.member[0] <= _e772.member_1[0]) && (_e772.member[0] <= _e947.member_1[0])) && (_e947.member[1] <= _e772.member_1[1])) && (_e772.member[1] <= _e947.member_1[1])) && (_e947.member[2] <= _e772.member_1[2])) && (_e772.member[2] <= _e947.member_1[2])))) << bitcast<u32>(5i)))) | (select(0u, 1u, (!((_e1111 || _e1115)) && ((((((_e1107.member[0] <= _e752.member_1[0]) && (_e752.member[0] <= _e1107.member_1[0])) && (_e1107.member[1] <= _e752.member_1[1])) && (_e752.member[1] <= _e1107.member_1[1])) && (_e1107.member[2] <= _e752.member_1[2])) && (_e752.member[2] <= _e1107.member_1[2])))) << bitcast<u32>(6i))) | (select(0u, 1u, (!((_e1161 || _e1165)) && ((((((_e1107.member[0] <= _e762.member_1[0]) && (_e762.member[0] <= _e1107.member_1[0])) && (_e1107.member[1] <= _e762.member_1[1])) && (_e762.member[1] <= _e1107.member_1[1])) && (_e1107.member[2] <= _e762.member_1[2])) && (_e762.member[2] <= _e1107.member_1[2])))) << bitcast<u32>(7i))) | (select(0u, 1u, (!((_e1211 || _e1215)) && ((((((_e1107.member[0] <= _e772.member_1[0]) && (_e772.member[0] <= _e1107.member_1[0])) && (_e1107.member[1] <= _e772.member_1[1])) && (_e772.member[1] <= _e1107.member_1[1])) && (_e1107.member[2] <= _e772.member_1[2])) && (_e772.member[2] <= _e1107.member_1[2])))) << bitcast<u32>(8i))) << bitcast<u32>(6u)));
                                } else {
                                    phi_1525_ = _e717;
                                    phi_1526_ = _e719;
                                }
                                let _e1262 = phi_1525_;
                                let _e1264 = phi_1526_;
                                phi_1527_ = _e1262;
                                phi_1528_ = _e1264;
                            } else {
                                phi_1527_ = _e717;
                                phi_1528_ = _e719;
                            }
                            let _e1266 = phi_1527_;
                            let _e1268 = phi_1528_;
                            phi_1531_ = type_22(array<u32, 5>(1u, 0u, 0u, _e1266, 0u), _e1268);
                        }
                        let _e1272 = phi_1531_;
                        phi_1532_ = type_22(array<u32, 5>(1u, 0u, 1u, 0u, 0u), 0u);
                        phi_1533_ = _e1272;
                        phi_1534_ = _e261;
                    } else {
                        phi_1532_ = type_22(array<u32, 5>(1u, 1u, 0u, 0u, 0u), 0u);
                        phi_1533_ = type_22();
                        phi_1534_ = true;
                    }
                    let _e1274 = phi_1532_;
                    let _e1276 = phi_1533_;
                    let _e1278 = phi_1534_;
                    phi_1535_ = _e1274;
                    phi_1536_ = _e1276;
                    phi_1537_ = _e1278;
                } else {
                    phi_1535_ = type_22(array<u32, 5>(0u, 0u, 0u, 0u, 0u), 0u);
                    phi_1536_ = type_22();
                    phi_1537_ = true;
                }
                let _e1280 = phi_1535_;
                let _e1282 = phi_1536_;
                let _e1284 = phi_1537_;
                if _e1284 {
                    phi_1541_ = _e1280;
                } else {
                    phi_1541_ = _e1282;
                }
                let _e1286 = phi_1541_;
                if (_e1286.member[0] == 0u) {
                } else {
                    let _e1299 = atomicAdd((&shared_[0u]), _e1286.member[0]);
                }
                if (_e1286.member[1] == 0u) {
                } else {
                    let _e1302 = atomicAdd((&shared_[1u]), _e1286.member[1]);
                }
                if (_e1286.member[2] == 0u) {
                } else {
                    let _e1305 = atomicAdd((&shared_[2u]), _e1286.member[2]);
                }
                if (_e1286.member[3] == 0u) {
                } else {
                    let _e1308 = atomicAdd((&shared_[3u]), _e1286.member[3]);
                }
                if (_e1286.member[4] == 0u) {
                } else {
                    let _e1311 = atomicAdd((&shared_[4u]), _e1286.member[4]);
                }
                if (_e1286.member_1 == 0u) {
                    phi_1590_ = 0u;
                    phi_1591_ = 0u;
                } else {
                    let _e1317 = atomicAdd((&shared_[5u]), countOneBits((_e1286.member_1 & 63u)));
                    let _e1321 = atomicAdd((&shared_[6u]), countOneBits((_e1286.member_1 & 4294967232u)));
                    phi_1590_ = _e1321;
                    phi_1591_ = _e1317;
                }
                let _e1323 = phi_1590_;
                let _e1325 = phi_1591_;
                phi_1592_ = _e1323;
                phi_1593_ = _e1325;
                phi_1594_ = _e1286.member_1;
                phi_1595_ = type_12(_e145, _e148);
            } else {
                phi_1592_ = 0u;
                phi_1593_ = 0u;
                phi_1594_ = 0u;
                phi_1595_ = type_12(0u, 0u);
            }
            let _e1327 = phi_1592_;
            let _e1329 = phi_1593_;
            let _e1331 = phi_1594_;
            let _e1333 = phi_1595_;
            workgroupBarrier();
            if (_e49 == 0u) {
                let _e1336 = atomicLoad((&shared_[5u]));
                let _e1338 = atomicLoad((&shared_[6u]));
                if (_e1336 > 0u) {
                    let _e1341 = atomicAdd((&vf.member[0u]), _e1336);
                    if ((_e1341 + _e1336) < _e1341) {
                        let _e1345 = atomicAdd((&vf.member[2u]), 1u);
                    }
                    atomicStore((&shared_[7u]), _e1341);
                }
                if (_e1338 > 0u) {
                    let _e1349 = atomicAdd((&ee.member[0u]), _e1338);
                    if ((_e1349 + _e1338) < _e1349) {
                        let _e1353 = atomicAdd((&ee.member[2u]), 1u);
                    }
                    atomicStore((&shared_[8u]), _e1349);
                }
            }
            workgroupBarrier();
            if (_e1331 == 0u) {
            } else {
                let _e1357 = atomicLoad((&shared_[7u]));
                let _e1360 = atomicLoad((&shared_[8u]));
                phi_1650_ = type_12(0u, 6u);
                phi_1653_ = (_e1329 + _e1357);
                loop {
                    let _e1363 = phi_1650_;
                    let _e1365 = phi_1653_;
                    if (_e1363.member < _e1363.member_1) {
                        phi_1651_ = type_12((_e1363.member + 1u), _e1363.member_1);
                        phi_1676_ = type_12(1u, _e1363.member);
                    } else {
                        phi_1651_ = _e1363;
                        phi_1676_ = type_12(0u, type_12().member_1);
                    }
                    let _e1377 = phi_1651_;
                    let _e1379 = phi_1676_;
                    let _e1383 = (bitcast<i32>(_e1379.member) != 0i);
                    if _e1383 {
                        if (((_e1331 >> bitcast<u32>((_e1379.member_1 & 31u))) & 1u) == 1u) {
                            let _e1390 = params.member.member_1.member_3;
                            let _e1394 = triangles.member[_e1333.member];
                            let _e1396 = triangles.member[_e1333.member_1];
                            if (_e1379.member_1 < 3u) {
                                if (_e1379.member_1 == 0u) {
                                    phi_1735_ = _e1394.member[0];
                                } else {
                                    if (_e1379.member_1 == 1u) {
                                        phi_1734_ = _e1394.member[1];
                                    } else {
                                        phi_1734_ = _e1394.member[2];
                                    }
                                    let _e1447 = phi_1734_;
                                    phi_1735_ = _e1447;
                                }
                                let _e1450 = phi_1735_;
                                phi_1796_ = type_12(_e1450, _e1333.member_1);
                            } else {
                                if (_e1379.member_1 < 6u) {
                                    let _e1429 = (_e1379.member_1 - 3u);
                                    if (_e1429 == 0u) {
                                        phi_1754_ = _e1396.member[0];
                                    } else {
                                        if (_e1429 == 1u) {
                                            phi_1753_ = _e1396.member[1];
                                        } else {
                                            phi_1753_ = _e1396.member[2];
                                        }
                                        let _e1435 = phi_1753_;
                                        phi_1754_ = _e1435;
                                    }
                                    let _e1438 = phi_1754_;
                                    phi_1795_ = type_12(_e1438, _e1333.member);
                                } else {
                                    let _e1403 = (_e1379.member_1 - 6u);
                                    let _e1404 = (_e1403 / 3u);
                                    if (_e1404 == 0u) {
                                        phi_1770_ = _e1394.member_2[0];
                                    } else {
                                        if (_e1404 == 1u) {
                                            phi_1769_ = _e1394.member_2[1];
                                        } else {
                                            phi_1769_ = _e1394.member_2[2];
                                        }
                                        let _e1410 = phi_1769_;
                                        phi_1770_ = _e1410;
                                    }
                                    let _e1413 = phi_1770_;
                                    let _e1414 = (_e1403 % 3u);
                                    if (_e1414 == 0u) {
                                        phi_1784_ = _e1396.member_2[0];
                                    } else {
                                        if (_e1414 == 1u) {
                                            phi_1783_ = _e1396.member_2[1];
                                        } else {
                                            phi_1783_ = _e1396.member_2[2];
                                        }
                                        let _e1420 = phi_1783_;
                                        phi_1784_ = _e1420;
                                    }
                                    let _e1423 = phi_1784_;
                                    if (_e1413 < _e1423) {
                                        phi_1791_ = type_12(_e1413, _e1423);
                                    } else {
                                        phi_1791_ = type_12(_e1423, _e1413);
                                    }
                                    let _e1428 = phi_1791_;
                                    phi_1795_ = _e1428;
                                }
                                let _e1441 = phi_1795_;
                                phi_1796_ = _e1441;
                            }
                            let _e1453 = phi_1796_;
                            if (_e1365 < _e1390) {
                                let _e1457 = (2u * _e1365);
                                atomicStore((&vf.member[(4u + _e1457)]), _e1453.member);
                                atomicStore((&vf.member[(_e1457 + 5u)]), _e1453.member_1);
                            }
                            phi_1811_ = (_e1365 + 1u);
                        } else {
                            phi_1811_ = _e1365;
                        }
                        let _e1464 = phi_1811_;
                        phi_1654_ = _e1464;
                    } else {
                        phi_1654_ = u32();
                    }
                    let _e1466 = phi_1654_;
                    continue;
                    continuing {
                        phi_1650_ = _e1377;
                        phi_1653_ = _e1466;
                        break if !(_e1383);
                    }
                }
                phi_1814_ = type_12(6u, 15u);
                phi_1817_ = (_e1327 + _e1360);
                loop {
                    let _e1469 = phi_1814_;
                    let _e1471 = phi_1817_;
                    if (_e1469.member < _e1469.member_1) {
                        phi_1815_ = type_12((_e1469.member + 1u), _e1469.member_1);
                        phi_1840_ = type_12(1u, _e1469.member);
                    } else {
                        phi_1815_ = _e1469;
                        phi_1840_ = type_12(0u, type_12().member_1);
                    }
                    let _e1483 = phi_1815_;
                    let _e1485 = phi_1840_;
                    let _e1489 = (bitcast<i32>(_e1485.member) != 0i);
                    if _e1489 {
                        if (((_e1331 >> bitcast<u32>((_e1485.member_1 & 31u))) & 1u) == 1u) {
                            let _e1498 = triangles.member[_e1333.member];
                            let _e1500 = triangles.member[_e1333.member_1];
                            if (_e1485.member_1 < 3u) {
                                if (_e1485.member_1 == 0u) {
                                    phi_1897_ = _e1498.member[0];
                                } else {
                                    if (_e1485.member_1 == 1u) {
                                        phi_1896_ = _e1498.member[1];
                                    } else {
                                        phi_1896_ = _e1498.member[2];
                                    }
                                    let _e1551 = phi_1896_;
                                    phi_1897_ = _e1551;
                                }
                                let _e1554 = phi_1897_;
                                phi_1958_ = type_12(_e1554, _e1333.member_1);
                            } else {
                                if (_e1485.member_1 < 6u) {
                                    let _e1533 = (_e1485.member_1 - 3u);
                                    if (_e1533 == 0u) {
                                        phi_1916_ = _e1500.member[0];
                                    } else {
                                        if (_e1533 == 1u) {
                                            phi_1915_ = _e1500.member[1];
                                        } else {
                                            phi_1915_ = _e1500.member[2];
                                        }
                                        let _e1539 = phi_1915_;
                                        phi_1916_ = _e1539;
                                    }
                                    let _e1542 = phi_1916_;
                                    phi_1957_ = type_12(_e1542, _e1333.member);
                                } else {
                                    let _e1507 = (_e1485.member_1 - 6u);
                                    let _e1508 = (_e1507 / 3u);
                                    if (_e1508 == 0u) {
                                        phi_1932_ = _e1498.member_2[0];
                                    } else {
                                        if (_e1508 == 1u) {
                                            phi_1931_ = _e1498.member_2[1];
                                        } else {
                                            phi_1931_ = _e1498.member_2[2];
                                        }
                                        let _e1514 = phi_1931_;
                                        phi_1932_ = _e1514;
                                    }
                                    let _e1517 = phi_1932_;
                                    let _e1518 = (_e1507 % 3u);
                                    if (_e1518 == 0u) {
                                        phi_1946_ = _e1500.member_2[0];
                                    } else {
                                        if (_e1518 == 1u) {
                                            phi_1945_ = _e1500.member_2[1];
                                        } else {
                                            phi_1945_ = _e1500.member_2[2];
                                        }
                                        let _e1524 = phi_1945_;
                                        phi_1946_ = _e1524;
                                    }
                                    let _e1527 = phi_1946_;
                                    if (_e1517 < _e1527) {
                                        phi_1953_ = type_12(_e1517, _e1527);
                                    } else {
                                        phi_1953_ = type_12(_e1527, _e1517);
                                    }
                                    let _e1532 = phi_1953_;
                                    phi_1957_ = _e1532;
                                }
                                let _e1545 = phi_1957_;
                                phi_1958_ = _e1545;
                            }
                            let _e1557 = phi_1958_;
                            if (_e1471 < _e69) {
                                let _e1561 = (2u * _e1471);
                                atomicStore((&ee.member[(4u + _e1561)]), _e1557.member);
                                atomicStore((&ee.member[(_e1561 + 5u)]), _e1557.member_1);
                            }
                            phi_1973_ = (_e1471 + 1u);
                        } else {
                            phi_1973_ = _e1471;
                        }
                        let _e1568 = phi_1973_;
                        phi_1818_ = _e1568;
                    } else {
                        phi_1818_ = u32();
                    }
                    let _e1570 = phi_1818_;
                    continue;
                    continuing {
                        phi_1814_ = _e1483;
                        phi_1817_ = _e1570;
                        break if !(_e1489);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_212_ = _e124;
            break if !(_e130);
        }
    }
    workgroupBarrier();
    if (_e49 < 5u) {
        let _e1575 = atomicLoad((&shared_[_e49]));
        if (_e1575 > 0u) {
            let _e1577 = (_e49 * 4u);
            let _e1579 = atomicAdd((&counts.member[_e1577]), _e1575);
            if ((_e1579 + _e1575) < _e1579) {
                let _e1584 = atomicAdd((&counts.member[(_e1577 + 2u)]), 1u);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn expand_triangles(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}

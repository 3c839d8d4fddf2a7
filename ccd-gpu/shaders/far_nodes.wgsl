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

struct type_15 {
    member: array<array<u32, 4>, 8>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_16 {
    member: type_7,
    member_1: type_8,
    member_2: type_15,
}

struct type_17 {
    member: type_16,
}

struct type_20 {
    member: array<vec4<u32>>,
}

struct type_22 {
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_24 {
    member: array<type_22>,
}

struct type_25 {
    member: vec4<u32>,
    member_1: vec4<u32>,
    member_2: vec4<u32>,
    member_3: vec4<u32>,
}

struct type_27 {
    member: array<type_25>,
}

struct type_29 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

@group(0) @binding(0) 
var<storage> params: type_17;
@group(0) @binding(1) 
var<storage> branches: type_20;
@group(0) @binding(2) 
var<storage> block_nodes: type_24;
@group(0) @binding(3) 
var<storage> far: type_11;
@group(0) @binding(4) 
var<storage, read_write> nodes: type_27;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_124_: u32;
    var phi_127_: type_9;
    var phi_128_: type_9;
    var phi_151_: type_9;
    var phi_202_: u32;
    var phi_207_: type_9;
    var phi_210_: type_29;
    var phi_212_: u32;
    var phi_214_: u32;
    var phi_208_: type_9;
    var phi_237_: type_9;
    var phi_256_: u32;
    var phi_266_: bool;
    var phi_270_: u32;
    var phi_271_: u32;
    var phi_288_: u32;
    var phi_291_: type_9;
    var phi_294_: type_29;
    var phi_292_: type_9;
    var phi_317_: type_9;
    var phi_377_: u32;
    var phi_399_: u32;
    var phi_421_: u32;
    var phi_442_: f32;
    var phi_447_: f32;
    var phi_452_: f32;
    var phi_457_: f32;
    var phi_462_: f32;
    var phi_467_: f32;
    var phi_472_: f32;
    var phi_477_: f32;
    var phi_482_: f32;
    var phi_487_: f32;
    var phi_492_: f32;
    var phi_497_: f32;
    var phi_502_: f32;
    var phi_507_: f32;
    var phi_512_: f32;
    var phi_517_: f32;
    var phi_522_: f32;
    var phi_527_: f32;
    var phi_533_: f32;
    var phi_539_: f32;
    var phi_545_: f32;
    var phi_552_: f32;
    var phi_558_: f32;
    var phi_564_: f32;
    var phi_295_: type_29;
    var phi_583_: u32;
    var phi_586_: type_9;
    var phi_589_: type_29;
    var phi_587_: type_9;
    var phi_612_: type_9;
    var phi_672_: u32;
    var phi_694_: u32;
    var phi_716_: u32;
    var phi_737_: f32;
    var phi_742_: f32;
    var phi_747_: f32;
    var phi_752_: f32;
    var phi_757_: f32;
    var phi_762_: f32;
    var phi_767_: f32;
    var phi_772_: f32;
    var phi_777_: f32;
    var phi_782_: f32;
    var phi_787_: f32;
    var phi_792_: f32;
    var phi_797_: f32;
    var phi_802_: f32;
    var phi_807_: f32;
    var phi_812_: f32;
    var phi_817_: f32;
    var phi_822_: f32;
    var phi_828_: f32;
    var phi_834_: f32;
    var phi_840_: f32;
    var phi_847_: f32;
    var phi_853_: f32;
    var phi_859_: f32;
    var phi_590_: type_29;
    var phi_866_: u32;
    var phi_871_: u32;
    var phi_211_: type_29;
    var phi_213_: u32;
    var phi_215_: u32;
    var phi_877_: type_9;
    var phi_880_: type_29;
    var phi_882_: u32;
    var phi_884_: u32;
    var phi_878_: type_9;
    var phi_907_: type_9;
    var phi_926_: u32;
    var phi_936_: bool;
    var phi_940_: u32;
    var phi_941_: u32;
    var phi_958_: u32;
    var phi_961_: type_9;
    var phi_964_: type_29;
    var phi_962_: type_9;
    var phi_987_: type_9;
    var phi_1047_: u32;
    var phi_1069_: u32;
    var phi_1091_: u32;
    var phi_1112_: f32;
    var phi_1117_: f32;
    var phi_1122_: f32;
    var phi_1127_: f32;
    var phi_1132_: f32;
    var phi_1137_: f32;
    var phi_1142_: f32;
    var phi_1147_: f32;
    var phi_1152_: f32;
    var phi_1157_: f32;
    var phi_1162_: f32;
    var phi_1167_: f32;
    var phi_1172_: f32;
    var phi_1177_: f32;
    var phi_1182_: f32;
    var phi_1187_: f32;
    var phi_1192_: f32;
    var phi_1197_: f32;
    var phi_1203_: f32;
    var phi_1209_: f32;
    var phi_1215_: f32;
    var phi_1222_: f32;
    var phi_1228_: f32;
    var phi_1234_: f32;
    var phi_965_: type_29;
    var phi_1253_: u32;
    var phi_1256_: type_9;
    var phi_1259_: type_29;
    var phi_1257_: type_9;
    var phi_1282_: type_9;
    var phi_1342_: u32;
    var phi_1364_: u32;
    var phi_1386_: u32;
    var phi_1407_: f32;
    var phi_1412_: f32;
    var phi_1417_: f32;
    var phi_1422_: f32;
    var phi_1427_: f32;
    var phi_1432_: f32;
    var phi_1437_: f32;
    var phi_1442_: f32;
    var phi_1447_: f32;
    var phi_1452_: f32;
    var phi_1457_: f32;
    var phi_1462_: f32;
    var phi_1467_: f32;
    var phi_1472_: f32;
    var phi_1477_: f32;
    var phi_1482_: f32;
    var phi_1487_: f32;
    var phi_1492_: f32;
    var phi_1498_: f32;
    var phi_1504_: f32;
    var phi_1510_: f32;
    var phi_1517_: f32;
    var phi_1523_: f32;
    var phi_1529_: f32;
    var phi_1260_: type_29;
    var phi_1536_: u32;
    var phi_1541_: u32;
    var phi_881_: type_29;
    var phi_883_: u32;
    var phi_885_: u32;
    var local: type_29;
    var phi_1552_: u32;
    var local_1: type_29;
    var phi_1560_: u32;
    var local_2: type_29;
    var local_3: type_29;
    var phi_1566_: u32;
    var phi_1599_: bool;
    var phi_1600_: bool;
    var local_4: type_29;
    var local_5: type_29;
    var local_6: type_29;
    var local_7: type_29;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e24 = id_2;
    let _e25 = n_2;
    let _e26 = lane_2;
    let _e33 = far.member[0u];
    let _e37 = params.member.member.member[1u];
    let _e38 = (_e37 - 1u);
    let _e42 = ((_e25.x * _e25.y) * 128u);
    if (_e42 == 0u) {
        return;
    }
    let _e44 = (_e33 / _e42);
    if (_e42 == 0u) {
        return;
    }
    if ((_e33 % _e42) > 0u) {
        phi_124_ = (_e44 + 1u);
    } else {
        phi_124_ = _e44;
    }
    let _e50 = phi_124_;
    phi_127_ = type_9(0u, _e50);
    loop {
        let _e53 = phi_127_;
        if (_e53.member < _e53.member_1) {
            phi_128_ = type_9((_e53.member + 1u), _e53.member_1);
            phi_151_ = type_9(1u, _e53.member);
        } else {
            phi_128_ = _e53;
            phi_151_ = type_9(0u, type_9().member_1);
        }
        let _e65 = phi_128_;
        let _e67 = phi_151_;
        if (bitcast<i32>(_e67.member) != 0i) {
            let _e80 = (((_e67.member_1 * _e42) + (((_e24.y * _e25.x) + _e24.x) * 128u)) + _e26);
            if (_e80 >= _e33) {
                phi_1599_ = false;
            } else {
                let _e84 = far.member[(4u + _e80)];
                let _e86 = branches.member[_e84];
                if (_e86.x >= _e38) {
                    phi_202_ = (_e86.x - _e38);
                } else {
                    phi_202_ = _e86.x;
                }
                let _e94 = phi_202_;
                phi_207_ = type_9(0u, 8u);
                phi_210_ = type_29(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                phi_212_ = (_e94 + 1u);
                phi_214_ = _e86.z;
                loop {
                    let _e98 = phi_207_;
                    let _e100 = phi_210_;
                    let _e102 = phi_212_;
                    let _e104 = phi_214_;
                    local = _e100;
                    local_1 = _e100;
                    if (_e98.member < _e98.member_1) {
                        phi_208_ = type_9((_e98.member + 1u), _e98.member_1);
                        phi_237_ = type_9(1u, _e98.member);
                    } else {
                        phi_208_ = _e98;
                        phi_237_ = type_9(0u, type_9().member_1);
                    }
                    let _e116 = phi_208_;
                    let _e118 = phi_237_;
                    let _e122 = (bitcast<i32>(_e118.member) != 0i);
                    if _e122 {
                        let _e123 = (_e104 % 32u);
                        if (_e123 == 0u) {
                            phi_256_ = _e104;
                        } else {
                            phi_256_ = (_e104 + (32u - _e123));
                        }
                        let _e128 = phi_256_;
                        let _e130 = ((_e102 / 32u) * 32u);
                        if (_e128 < _e130) {
                            let _e133 = params.member.member_2.member_2;
                            phi_266_ = (_e118.member_1 < _e133);
                        } else {
                            phi_266_ = false;
                        }
                        let _e136 = phi_266_;
                        if _e136 {
                            phi_270_ = _e130;
                            phi_271_ = _e128;
                        } else {
                            phi_270_ = _e102;
                            phi_271_ = _e102;
                        }
                        let _e138 = phi_270_;
                        let _e140 = phi_271_;
                        let _e141 = (_e140 - _e104);
                        let _e142 = (_e141 / 4u);
                        if ((_e141 % 4u) > 0u) {
                            phi_288_ = (_e142 + 1u);
                        } else {
                            phi_288_ = _e142;
                        }
                        let _e147 = phi_288_;
                        phi_291_ = type_9(0u, _e147);
                        phi_294_ = _e100;
                        loop {
                            let _e150 = phi_291_;
                            let _e152 = phi_294_;
                            local_4 = _e152;
                            if (_e150.member < _e150.member_1) {
                                phi_292_ = type_9((_e150.member + 1u), _e150.member_1);
                                phi_317_ = type_9(1u, _e150.member);
                            } else {
                                phi_292_ = _e150;
                                phi_317_ = type_9(0u, type_9().member_1);
                            }
                            let _e164 = phi_292_;
                            let _e166 = phi_317_;
                            let _e170 = (bitcast<i32>(_e166.member) != 0i);
                            if _e170 {
                                let _e176 = params.member.member_2.member[_e118.member_1][1u];
                                let _e177 = (_e176 + (_e104 + (4u * _e166.member_1)));
                                let _e181 = params.member.member_2.member[_e118.member_1][1u];
                                let _e183 = ((_e181 + _e140) - 1u);
                                let _e185 = block_nodes.member[_e177];
                                let _e198 = (_e177 + 1u);
                                if (_e183 < _e198) {
                                    phi_377_ = _e183;
                                } else {
                                    phi_377_ = _e198;
                                }
                                let _e201 = phi_377_;
                                let _e203 = block_nodes.member[_e201];
                                let _e216 = (_e177 + 2u);
                                if (_e183 < _e216) {
                                    phi_399_ = _e183;
                                } else {
                                    phi_399_ = _e216;
                                }
                                let _e219 = phi_399_;
                                let _e221 = block_nodes.member[_e219];
                                let _e234 = (_e177 + 3u);
                                if (_e183 < _e234) {
                                    phi_421_ = _e183;
                                } else {
                                    phi_421_ = _e234;
                                }
                                let _e237 = phi_421_;
                                let _e239 = block_nodes.member[_e237];
                                if (_e185.member.x < _e203.member.x) {
                                    phi_442_ = _e185.member.x;
                                } else {
                                    phi_442_ = _e203.member.x;
                                }
                                let _e254 = phi_442_;
                                if (_e185.member.y < _e203.member.y) {
                                    phi_447_ = _e185.member.y;
                                } else {
                                    phi_447_ = _e203.member.y;
                                }
                                let _e257 = phi_447_;
                                if (_e185.member_1.x < _e203.member_1.x) {
                                    phi_452_ = _e185.member_1.x;
                                } else {
                                    phi_452_ = _e203.member_1.x;
                                }
                                let _e260 = phi_452_;
                                if (_e185.member_1.y > _e203.member_1.y) {
                                    phi_457_ = _e185.member_1.y;
                                } else {
                                    phi_457_ = _e203.member_1.y;
                                }
                                let _e263 = phi_457_;
                                if (_e185.member_2.x > _e203.member_2.x) {
                                    phi_462_ = _e185.member_2.x;
                                } else {
                                    phi_462_ = _e203.member_2.x;
                                }
                                let _e266 = phi_462_;
                                if (_e185.member_2.y > _e203.member_2.y) {
                                    phi_467_ = _e185.member_2.y;
                                } else {
                                    phi_467_ = _e203.member_2.y;
                                }
                                let _e269 = phi_467_;
                                if (_e221.member.x < _e239.member.x) {
                                    phi_472_ = _e221.member.x;
                                } else {
                                    phi_472_ = _e239.member.x;
                                }
                                let _e272 = phi_472_;
                                if (_e221.member.y < _e239.member.y) {
                                    phi_477_ = _e221.member.y;
                                } else {
                                    phi_477_ = _e239.member.y;
                                }
                                let _e275 = phi_477_;
                                if (_e221.member_1.x < _e239.member_1.x) {
                                    phi_482_ = _e221.member_1.x;
                                } else {
                                    phi_482_ = _e239.member_1.x;
                                }
                                let _e278 = phi_482_;
                                if (_e221.member_1.y > _e239.member_1.y) {
                                    phi_487_ = _e221.member_1.y;
                                } else {
                                    phi_487_ = _e239.member_1.y;
                                }
                                let _e281 = phi_487_;
                                if (_e221.member_2.x > _e239.member_2.x) {
                                    phi_492_ = _e221.member_2.x;
                                } else {
                                    phi_492_ = _e239.member_2.x;
                                }
                                let _e284 = phi_492_;
                                if (_e221.member_2.y > _e239.member_2.y) {
                                    phi_497_ = _e221.member_2.y;
                                } else {
                                    phi_497_ = _e239.member_2.y;
                                }
                                let _e287 = phi_497_;
                                if (_e254 < _e272) {
                                    phi_502_ = _e254;
                                } else {
                                    phi_502_ = _e272;
                                }
                                let _e290 = phi_502_;
                                if (_e257 < _e275) {
                                    phi_507_ = _e257;
                                } else {
                                    phi_507_ = _e275;
                                }
                                let _e293 = phi_507_;
                                if (_e260 < _e278) {
                                    phi_512_ = _e260;
                                } else {
                                    phi_512_ = _e278;
                                }
                                let _e296 = phi_512_;
                                if (_e263 > _e281) {
                                    phi_517_ = _e263;
                                } else {
                                    phi_517_ = _e281;
                                }
                                let _e299 = phi_517_;
                                if (_e266 > _e284) {
                                    phi_522_ = _e266;
                                } else {
                                    phi_522_ = _e284;
                                }
                                let _e302 = phi_522_;
                                if (_e269 > _e287) {
                                    phi_527_ = _e269;
                                } else {
                                    phi_527_ = _e287;
                                }
                                let _e305 = phi_527_;
                                if (_e152.member[0] < _e290) {
                                    phi_533_ = _e152.member[0];
                                } else {
                                    phi_533_ = _e290;
                                }
                                let _e310 = phi_533_;
                                if (_e152.member[1] < _e293) {
                                    phi_539_ = _e152.member[1];
                                } else {
                                    phi_539_ = _e293;
                                }
                                let _e315 = phi_539_;
                                if (_e152.member[2] < _e296) {
                                    phi_545_ = _e152.member[2];
                                } else {
                                    phi_545_ = _e296;
                                }
                                let _e320 = phi_545_;
                                if (_e152.member_1[0] > _e299) {
                                    phi_552_ = _e152.member_1[0];
                                } else {
                                    phi_552_ = _e299;
                                }
                                let _e326 = phi_552_;
                                if (_e152.member_1[1] > _e302) {
                                    phi_558_ = _e152.member_1[1];
                                } else {
                                    phi_558_ = _e302;
                                }
                                let _e331 = phi_558_;
                                if (_e152.member_1[2] > _e305) {
                                    phi_564_ = _e152.member_1[2];
                                } else {
                                    phi_564_ = _e305;
                                }
                                let _e336 = phi_564_;
                                phi_295_ = type_29(array<f32, 3>(_e310, _e315, _e320), array<f32, 3>(_e326, _e331, _e336));
                            } else {
                                phi_295_ = type_29();
                            }
                            let _e340 = phi_295_;
                            continue;
                            continuing {
                                phi_291_ = _e164;
                                phi_294_ = _e340;
                                break if !(_e170);
                            }
                        }
                        let _e342 = (_e102 - _e138);
                        let _e343 = (_e342 / 4u);
                        if ((_e342 % 4u) > 0u) {
                            phi_583_ = (_e343 + 1u);
                        } else {
                            phi_583_ = _e343;
                        }
                        let _e348 = phi_583_;
                        phi_586_ = type_9(0u, _e348);
                        let _e1133 = local_4;
                        phi_589_ = _e1133;
                        loop {
                            let _e351 = phi_586_;
                            let _e353 = phi_589_;
                            local_5 = _e353;
                            if (_e351.member < _e351.member_1) {
                                phi_587_ = type_9((_e351.member + 1u), _e351.member_1);
                                phi_612_ = type_9(1u, _e351.member);
                            } else {
                                phi_587_ = _e351;
                                phi_612_ = type_9(0u, type_9().member_1);
                            }
                            let _e365 = phi_587_;
                            let _e367 = phi_612_;
                            let _e371 = (bitcast<i32>(_e367.member) != 0i);
                            if _e371 {
                                let _e377 = params.member.member_2.member[_e118.member_1][1u];
                                let _e378 = (_e377 + (_e138 + (4u * _e367.member_1)));
                                let _e382 = params.member.member_2.member[_e118.member_1][1u];
                                let _e384 = ((_e382 + _e102) - 1u);
                                let _e386 = block_nodes.member[_e378];
                                let _e399 = (_e378 + 1u);
                                if (_e384 < _e399) {
                                    phi_672_ = _e384;
                                } else {
                                    phi_672_ = _e399;
                                }
                                let _e402 = phi_672_;
                                let _e404 = block_nodes.member[_e402];
                                let _e417 = (_e378 + 2u);
                                if (_e384 < _e417) {
                                    phi_694_ = _e384;
                                } else {
                                    phi_694_ = _e417;
                                }
                                let _e420 = phi_694_;
                                let _e422 = block_nodes.member[_e420];
                                let _e435 = (_e378 + 3u);
                                if (_e384 < _e435) {
                                    phi_716_ = _e384;
                                } else {
                                    phi_716_ = _e435;
                                }
                                let _e438 = phi_716_;
                                let _e440 = block_nodes.member[_e438];
                                if (_e386.member.x < _e404.member.x) {
                                    phi_737_ = _e386.member.x;
                                } else {
                                    phi_737_ = _e404.member.x;
                                }
                                let _e455 = phi_737_;
                                if (_e386.member.y < _e404.member.y) {
                                    phi_742_ = _e386.member.y;
                                } else {
                                    phi_742_ = _e404.member.y;
                                }
                                let _e458 = phi_742_;
                                if (_e386.member_1.x < _e404.member_1.x) {
                                    phi_747_ = _e386.member_1.x;
                                } else {
                                    phi_747_ = _e404.member_1.x;
                                }
                                let _e461 = phi_747_;
                                if (_e386.member_1.y > _e404.member_1.y) {
                                    phi_752_ = _e386.member_1.y;
                                } else {
                                    phi_752_ = _e404.member_1.y;
                                }
                                let _e464 = phi_752_;
                                if (_e386.member_2.x > _e404.member_2.x) {
                                    phi_757_ = _e386.member_2.x;
                                } else {
                                    phi_757_ = _e404.member_2.x;
                                }
                                let _e467 = phi_757_;
                                if (_e386.member_2.y > _e404.member_2.y) {
                                    phi_762_ = _e386.member_2.y;
                                } else {
                                    phi_762_ = _e404.member_2.y;
                                }
                                let _e470 = phi_762_;
                                if (_e422.member.x < _e440.member.x) {
                                    phi_767_ = _e422.member.x;
                                } else {
                                    phi_767_ = _e440.member.x;
                                }
                                let _e473 = phi_767_;
                                if (_e422.member.y < _e440.member.y) {
                                    phi_772_ = _e422.member.y;
                                } else {
                                    phi_772_ = _e440.member.y;
                                }
                                let _e476 = phi_772_;
                                if (_e422.member_1.x < _e440.member_1.x) {
                                    phi_777_ = _e422.member_1.x;
                                } else {
                                    phi_777_ = _e440.member_1.x;
                                }
                                let _e479 = phi_777_;
                                if (_e422.member_1.y > _e440.member_1.y) {
                                    phi_782_ = _e422.member_1.y;
                                } else {
                                    phi_782_ = _e440.member_1.y;
                                }
                                let _e482 = phi_782_;
                                if (_e422.member_2.x > _e440.member_2.x) {
                                    phi_787_ = _e422.member_2.x;
                                } else {
                                    phi_787_ = _e440.member_2.x;
                                }
                                let _e485 = phi_787_;
                                if (_e422.member_2.y > _e440.member_2.y) {
                                    phi_792_ = _e422.member_2.y;
                                } else {
                                    phi_792_ = _e440.member_2.y;
                                }
                                let _e488 = phi_792_;
                                if (_e455 < _e473) {
                                    phi_797_ = _e455;
                                } else {
                                    phi_797_ = _e473;
                                }
                                let _e491 = phi_797_;
                                if (_e458 < _e476) {
                                    phi_802_ = _e458;
                                } else {
                                    phi_802_ = _e476;
                                }
                                let _e494 = phi_802_;
                                if (_e461 < _e479) {
                                    phi_807_ = _e461;
                                } else {
                                    phi_807_ = _e479;
                                }
                                let _e497 = phi_807_;
                                if (_e464 > _e482) {
                                    phi_812_ = _e464;
                                } else {
                                    phi_812_ = _e482;
                                }
                                let _e500 = phi_812_;
                                if (_e467 > _e485) {
                                    phi_817_ = _e467;
                                } else {
                                    phi_817_ = _e485;
                                }
                                let _e503 = phi_817_;
                                if (_e470 > _e488) {
                                    phi_822_ = _e470;
                                } else {
                                    phi_822_ = _e488;
                                }
                                let _e506 = phi_822_;
                                if (_e353.member[0] < _e491) {
                                    phi_828_ = _e353.member[0];
                                } else {
                                    phi_828_ = _e491;
                                }
                                let _e511 = phi_828_;
                                if (_e353.member[1] < _e494) {
                                    phi_834_ = _e353.member[1];
                                } else {
                                    phi_834_ = _e494;
                                }
                                let _e516 = phi_834_;
                                if (_e353.member[2] < _e497) {
                                    phi_840_ = _e353.member[2];
                                } else {
                                    phi_840_ = _e497;
                                }
                                let _e521 = phi_840_;
                                if (_e353.member_1[0] > _e500) {
                                    phi_847_ = _e353.member_1[0];
                                } else {
                                    phi_847_ = _e500;
                                }
                                let _e527 = phi_847_;
                                if (_e353.member_1[1] > _e503) {
                                    phi_853_ = _e353.member_1[1];
                                } else {
                                    phi_853_ = _e503;
                                }
                                let _e532 = phi_853_;
                                if (_e353.member_1[2] > _e506) {
                                    phi_859_ = _e353.member_1[2];
                                } else {
                                    phi_859_ = _e506;
                                }
                                let _e537 = phi_859_;
                                phi_590_ = type_29(array<f32, 3>(_e511, _e516, _e521), array<f32, 3>(_e527, _e532, _e537));
                            } else {
                                phi_590_ = type_29();
                            }
                            let _e541 = phi_590_;
                            continue;
                            continuing {
                                phi_586_ = _e365;
                                phi_589_ = _e541;
                                break if !(_e371);
                            }
                        }
                        if _e136 {
                            phi_866_ = (_e128 / 32u);
                        } else {
                            phi_866_ = 0u;
                        }
                        let _e545 = phi_866_;
                        if _e136 {
                            phi_871_ = (_e130 / 32u);
                        } else {
                            phi_871_ = 0u;
                        }
                        let _e548 = phi_871_;
                        let _e1168 = local_5;
                        phi_211_ = _e1168;
                        phi_213_ = _e548;
                        phi_215_ = _e545;
                    } else {
                        phi_211_ = type_29();
                        phi_213_ = u32();
                        phi_215_ = u32();
                    }
                    let _e550 = phi_211_;
                    let _e552 = phi_213_;
                    let _e554 = phi_215_;
                    continue;
                    continuing {
                        phi_207_ = _e116;
                        phi_210_ = _e550;
                        phi_212_ = _e552;
                        phi_214_ = _e554;
                        break if !(_e122);
                    }
                }
                phi_877_ = type_9(0u, 8u);
                phi_880_ = type_29(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                phi_882_ = (_e86.w + 1u);
                phi_884_ = (_e94 + 1u);
                loop {
                    let _e560 = phi_877_;
                    let _e562 = phi_880_;
                    let _e564 = phi_882_;
                    let _e566 = phi_884_;
                    local_2 = _e562;
                    local_3 = _e562;
                    if (_e560.member < _e560.member_1) {
                        phi_878_ = type_9((_e560.member + 1u), _e560.member_1);
                        phi_907_ = type_9(1u, _e560.member);
                    } else {
                        phi_878_ = _e560;
                        phi_907_ = type_9(0u, type_9().member_1);
                    }
                    let _e578 = phi_878_;
                    let _e580 = phi_907_;
                    let _e584 = (bitcast<i32>(_e580.member) != 0i);
                    if _e584 {
                        let _e585 = (_e566 % 32u);
                        if (_e585 == 0u) {
                            phi_926_ = _e566;
                        } else {
                            phi_926_ = (_e566 + (32u - _e585));
                        }
                        let _e590 = phi_926_;
                        let _e592 = ((_e564 / 32u) * 32u);
                        if (_e590 < _e592) {
                            let _e595 = params.member.member_2.member_2;
                            phi_936_ = (_e580.member_1 < _e595);
                        } else {
                            phi_936_ = false;
                        }
                        let _e598 = phi_936_;
                        if _e598 {
                            phi_940_ = _e592;
                            phi_941_ = _e590;
                        } else {
                            phi_940_ = _e564;
                            phi_941_ = _e564;
                        }
                        let _e600 = phi_940_;
                        let _e602 = phi_941_;
                        let _e603 = (_e602 - _e566);
                        let _e604 = (_e603 / 4u);
                        if ((_e603 % 4u) > 0u) {
                            phi_958_ = (_e604 + 1u);
                        } else {
                            phi_958_ = _e604;
                        }
                        let _e609 = phi_958_;
                        phi_961_ = type_9(0u, _e609);
                        phi_964_ = _e562;
                        loop {
                            let _e612 = phi_961_;
                            let _e614 = phi_964_;
                            local_6 = _e614;
                            if (_e612.member < _e612.member_1) {
                                phi_962_ = type_9((_e612.member + 1u), _e612.member_1);
                                phi_987_ = type_9(1u, _e612.member);
                            } else {
                                phi_962_ = _e612;
                                phi_987_ = type_9(0u, type_9().member_1);
                            }
                            let _e626 = phi_962_;
                            let _e628 = phi_987_;
                            let _e632 = (bitcast<i32>(_e628.member) != 0i);
                            if _e632 {
                                let _e638 = params.member.member_2.member[_e580.member_1][1u];
                                let _e639 = (_e638 + (_e566 + (4u * _e628.member_1)));
                                let _e643 = params.member.member_2.member[_e580.member_1][1u];
                                let _e645 = ((_e643 + _e602) - 1u);
                                let _e647 = block_nodes.member[_e639];
                                let _e660 = (_e639 + 1u);
                                if (_e645 < _e660) {
                                    phi_1047_ = _e645;
                                } else {
                                    phi_1047_ = _e660;
                                }
                                let _e663 = phi_1047_;
                                let _e665 = block_nodes.member[_e663];
                                let _e678 = (_e639 + 2u);
                                if (_e645 < _e678) {
                                    phi_1069_ = _e645;
                                } else {
                                    phi_1069_ = _e678;
                                }
                                let _e681 = phi_1069_;
                                let _e683 = block_nodes.member[_e681];
                                let _e696 = (_e639 + 3u);
                                if (_e645 < _e696) {
                                    phi_1091_ = _e645;
                                } else {
                                    phi_1091_ = _e696;
                                }
                                let _e699 = phi_1091_;
                                let _e701 = block_nodes.member[_e699];
                                if (_e647.member.x < _e665.member.x) {
                                    phi_1112_ = _e647.member.x;
                                } else {
                                    phi_1112_ = _e665.member.x;
                                }
                                let _e716 = phi_1112_;
                                if (_e647.member.y < _e665.member.y) {
                                    phi_1117_ = _e647.member.y;
                                } else {
                                    phi_1117_ = _e665.member.y;
                                }
                                let _e719 = phi_1117_;
                                if (_e647.member_1.x < _e665.member_1.x) {
                                    phi_1122_ = _e647.member_1.x;
                                } else {
                                    phi_1122_ = _e665.member_1.x;
                                }
                                let _e722 = phi_1122_;
                                if (_e647.member_1.y > _e665.member_1.y) {
                                    phi_1127_ = _e647.member_1.y;
                                } else {
                                    phi_1127_ = _e665.member_1.y;
                                }
                                let _e725 = phi_1127_;
                                if (_e647.member_2.x > _e665.member_2.x) {
                                    phi_1132_ = _e647.member_2.x;
                                } else {
                                    phi_1132_ = _e665.member_2.x;
                                }
                                let _e728 = phi_1132_;
                                if (_e647.member_2.y > _e665.member_2.y) {
                                    phi_1137_ = _e647.member_2.y;
                                } else {
                                    phi_1137_ = _e665.member_2.y;
                                }
                                let _e731 = phi_1137_;
                                if (_e683.member.x < _e701.member.x) {
                                    phi_1142_ = _e683.member.x;
                                } else {
                                    phi_1142_ = _e701.member.x;
                                }
                                let _e734 = phi_1142_;
                                if (_e683.member.y < _e701.member.y) {
                                    phi_1147_ = _e683.member.y;
                                } else {
                                    phi_1147_ = _e701.member.y;
                                }
                                let _e737 = phi_1147_;
                                if (_e683.member_1.x < _e701.member_1.x) {
                                    phi_1152_ = _e683.member_1.x;
                                } else {
                                    phi_1152_ = _e701.member_1.x;
                                }
                                let _e740 = phi_1152_;
                                if (_e683.member_1.y > _e701.member_1.y) {
                                    phi_1157_ = _e683.member_1.y;
                                } else {
                                    phi_1157_ = _e701.member_1.y;
                                }
                                let _e743 = phi_1157_;
                                if (_e683.member_2.x > _e701.member_2.x) {
                                    phi_1162_ = _e683.member_2.x;
                                } else {
                                    phi_1162_ = _e701.member_2.x;
                                }
                                let _e746 = phi_1162_;
                                if (_e683.member_2.y > _e701.member_2.y) {
                                    phi_1167_ = _e683.member_2.y;
                                } else {
                                    phi_1167_ = _e701.member_2.y;
                                }
                                let _e749 = phi_1167_;
                                if (_e716 < _e734) {
                                    phi_1172_ = _e716;
                                } else {
                                    phi_1172_ = _e734;
                                }
                                let _e752 = phi_1172_;
                                if (_e719 < _e737) {
                                    phi_1177_ = _e719;
                                } else {
                                    phi_1177_ = _e737;
                                }
                                let _e755 = phi_1177_;
                                if (_e722 < _e740) {
                                    phi_1182_ = _e722;
                                } else {
                                    phi_1182_ = _e740;
                                }
                                let _e758 = phi_1182_;
                                if (_e725 > _e743) {
                                    phi_1187_ = _e725;
                                } else {
                                    phi_1187_ = _e743;
                                }
                                let _e761 = phi_1187_;
                                if (_e728 > _e746) {
                                    phi_1192_ = _e728;
                                } else {
                                    phi_1192_ = _e746;
                                }
                                let _e764 = phi_1192_;
                                if (_e731 > _e749) {
                                    phi_1197_ = _e731;
                                } else {
                                    phi_1197_ = _e749;
                                }
                                let _e767 = phi_1197_;
                                if (_e614.member[0] < _e752) {
                                    phi_1203_ = _e614.member[0];
                                } else {
                                    phi_1203_ = _e752;
                                }
                                let _e772 = phi_1203_;
                                if (_e614.member[1] < _e755) {
                                    phi_1209_ = _e614.member[1];
                                } else {
                                    phi_1209_ = _e755;
                                }
                                let _e777 = phi_1209_;
                                if (_e614.member[2] < _e758) {
                                    phi_1215_ = _e614.member[2];
                                } else {
                                    phi_1215_ = _e758;
                                }
                                let _e782 = phi_1215_;
                                if (_e614.member_1[0] > _e761) {
                                    phi_1222_ = _e614.member_1[0];
                                } else {
                                    phi_1222_ = _e761;
                                }
                                let _e788 = phi_1222_;
                                if (_e614.member_1[1] > _e764) {
                                    phi_1228_ = _e614.member_1[1];
                                } else {
                                    phi_1228_ = _e764;
                                }
                                let _e793 = phi_1228_;
                                if (_e614.member_1[2] > _e767) {
                                    phi_1234_ = _e614.member_1[2];
                                } else {
                                    phi_1234_ = _e767;
                                }
                                let _e798 = phi_1234_;
                                phi_965_ = type_29(array<f32, 3>(_e772, _e777, _e782), array<f32, 3>(_e788, _e793, _e798));
                            } else {
                                phi_965_ = type_29();
                            }
                            let _e802 = phi_965_;
                            continue;
                            continuing {
                                phi_961_ = _e626;
                                phi_964_ = _e802;
                                break if !(_e632);
                            }
                        }
                        let _e804 = (_e564 - _e600);
                        let _e805 = (_e804 / 4u);
                        if ((_e804 % 4u) > 0u) {
                            phi_1253_ = (_e805 + 1u);
                        } else {
                            phi_1253_ = _e805;
                        }
                        let _e810 = phi_1253_;
                        phi_1256_ = type_9(0u, _e810);
                        let _e1218 = local_6;
                        phi_1259_ = _e1218;
                        loop {
                            let _e813 = phi_1256_;
                            let _e815 = phi_1259_;
                            local_7 = _e815;
                            if (_e813.member < _e813.member_1) {
                                phi_1257_ = type_9((_e813.member + 1u), _e813.member_1);
                                phi_1282_ = type_9(1u, _e813.member);
                            } else {
                                phi_1257_ = _e813;
                                phi_1282_ = type_9(0u, type_9().member_1);
                            }
                            let _e827 = phi_1257_;
                            let _e829 = phi_1282_;
                            let _e833 = (bitcast<i32>(_e829.member) != 0i);
                            if _e833 {
                                let _e839 = params.member.member_2.member[_e580.member_1][1u];
                                let _e840 = (_e839 + (_e600 + (4u * _e829.member_1)));
                                let _e844 = params.member.member_2.member[_e580.member_1][1u];
                                let _e846 = ((_e844 + _e564) - 1u);
                                let _e848 = block_nodes.member[_e840];
                                let _e861 = (_e840 + 1u);
                                if (_e846 < _e861) {
                                    phi_1342_ = _e846;
                                } else {
                                    phi_1342_ = _e861;
                                }
                                let _e864 = phi_1342_;
                                let _e866 = block_nodes.member[_e864];
                                let _e879 = (_e840 + 2u);
                                if (_e846 < _e879) {
                                    phi_1364_ = _e846;
                                } else {
                                    phi_1364_ = _e879;
                                }
                                let _e882 = phi_1364_;
                                let _e884 = block_nodes.member[_e882];
                                let _e897 = (_e840 + 3u);
                                if (_e846 < _e897) {
                                    phi_1386_ = _e846;
                                } else {
                                    phi_1386_ = _e897;
                                }
                                let _e900 = phi_1386_;
                                let _e902 = block_nodes.member[_e900];
                                if (_e848.member.x < _e866.member.x) {
                                    phi_1407_ = _e848.member.x;
                                } else {
                                    phi_1407_ = _e866.member.x;
                                }
                                let _e917 = phi_1407_;
                                if (_e848.member.y < _e866.member.y) {
                                    phi_1412_ = _e848.member.y;
                                } else {
                                    phi_1412_ = _e866.member.y;
                                }
                                let _e920 = phi_1412_;
                                if (_e848.member_1.x < _e866.member_1.x) {
                                    phi_1417_ = _e848.member_1.x;
                                } else {
                                    phi_1417_ = _e866.member_1.x;
                                }
                                let _e923 = phi_1417_;
                                if (_e848.member_1.y > _e866.member_1.y) {
                                    phi_1422_ = _e848.member_1.y;
                                } else {
                                    phi_1422_ = _e866.member_1.y;
                                }
                                let _e926 = phi_1422_;
                                if (_e848.member_2.x > _e866.member_2.x) {
                                    phi_1427_ = _e848.member_2.x;
                                } else {
                                    phi_1427_ = _e866.member_2.x;
                                }
                                let _e929 = phi_1427_;
                                if (_e848.member_2.y > _e866.member_2.y) {
                                    phi_1432_ = _e848.member_2.y;
                                } else {
                                    phi_1432_ = _e866.member_2.y;
                                }
                                let _e932 = phi_1432_;
                                if (_e884.member.x < _e902.member.x) {
                                    phi_1437_ = _e884.member.x;
                                } else {
                                    phi_1437_ = _e902.member.x;
                                }
                                let _e935 = phi_1437_;
                                if (_e884.member.y < _e902.member.y) {
                                    phi_1442_ = _e884.member.y;
                                } else {
                                    phi_1442_ = _e902.member.y;
                                }
                                let _e938 = phi_1442_;
                                if (_e884.member_1.x < _e902.member_1.x) {
                                    phi_1447_ = _e884.member_1.x;
                                } else {
                                    phi_1447_ = _e902.member_1.x;
                                }
                                let _e941 = phi_1447_;
                                if (_e884.member_1.y > _e902.member_1.y) {
                                    phi_1452_ = _e884.member_1.y;
                                } else {
                                    phi_1452_ = _e902.member_1.y;
                                }
                                let _e944 = phi_1452_;
                                if (_e884.member_2.x > _e902.member_2.x) {
                                    phi_1457_ = _e884.member_2.x;
                                } else {
                                    phi_1457_ = _e902.member_2.x;
                                }
                                let _e947 = phi_1457_;
                                if (_e884.member_2.y > _e902.member_2.y) {
                                    phi_1462_ = _e884.member_2.y;
                                } else {
                                    phi_1462_ = _e902.member_2.y;
                                }
                                let _e950 = phi_1462_;
                                if (_e917 < _e935) {
                                    phi_1467_ = _e917;
                                } else {
                                    phi_1467_ = _e935;
                                }
                                let _e953 = phi_1467_;
                                if (_e920 < _e938) {
                                    phi_1472_ = _e920;
                                } else {
                                    phi_1472_ = _e938;
                                }
                                let _e956 = phi_1472_;
                                if (_e923 < _e941) {
                                    phi_1477_ = _e923;
                                } else {
                                    phi_1477_ = _e941;
                                }
                                let _e959 = phi_1477_;
                                if (_e926 > _e944) {
                                    phi_1482_ = _e926;
                                } else {
                                    phi_1482_ = _e944;
                                }
                                let _e962 = phi_1482_;
                                if (_e929 > _e947) {
                                    phi_1487_ = _e929;
                                } else {
                                    phi_1487_ = _e947;
                                }
                                let _e965 = phi_1487_;
                                if (_e932 > _e950) {
                                    phi_1492_ = _e932;
                                } else {
                                    phi_1492_ = _e950;
                                }
                                let _e968 = phi_1492_;
                                if (_e815.member[0] < _e953) {
                                    phi_1498_ = _e815.member[0];
                                } else {
                                    phi_1498_ = _e953;
                                }
                                let _e973 = phi_1498_;
                                if (_e815.member[1] < _e956) {
                                    phi_1504_ = _e815.member[1];
                                } else {
                                    phi_1504_ = _e956;
                                }
                                let _e978 = phi_1504_;
                                if (_e815.member[2] < _e959) {
                                    phi_1510_ = _e815.member[2];
                                } else {
                                    phi_1510_ = _e959;
                                }
                                let _e983 = phi_1510_;
                                if (_e815.member_1[0] > _e962) {
                                    phi_1517_ = _e815.member_1[0];
                                } else {
                                    phi_1517_ = _e962;
                                }
                                let _e989 = phi_1517_;
                                if (_e815.member_1[1] > _e965) {
                                    phi_1523_ = _e815.member_1[1];
                                } else {
                                    phi_1523_ = _e965;
                                }
                                let _e994 = phi_1523_;
                                if (_e815.member_1[2] > _e968) {
                                    phi_1529_ = _e815.member_1[2];
                                } else {
                                    phi_1529_ = _e968;
                                }
                                let _e999 = phi_1529_;
                                phi_1260_ = type_29(array<f32, 3>(_e973, _e978, _e983), array<f32, 3>(_e989, _e994, _e999));
                            } else {
                                phi_1260_ = type_29();
                            }
                            let _e1003 = phi_1260_;
                            continue;
                            continuing {
                                phi_1256_ = _e827;
                                phi_1259_ = _e1003;
                                break if !(_e833);
                            }
                        }
                        if _e598 {
                            phi_1536_ = (_e590 / 32u);
                        } else {
                            phi_1536_ = 0u;
                        }
                        let _e1007 = phi_1536_;
                        if _e598 {
                            phi_1541_ = (_e592 / 32u);
                        } else {
                            phi_1541_ = 0u;
                        }
                        let _e1010 = phi_1541_;
                        let _e1253 = local_7;
                        phi_881_ = _e1253;
                        phi_883_ = _e1010;
                        phi_885_ = _e1007;
                    } else {
                        phi_881_ = type_29();
                        phi_883_ = u32();
                        phi_885_ = u32();
                    }
                    let _e1012 = phi_881_;
                    let _e1014 = phi_883_;
                    let _e1016 = phi_885_;
                    continue;
                    continuing {
                        phi_877_ = _e578;
                        phi_880_ = _e1012;
                        phi_882_ = _e1014;
                        phi_884_ = _e1016;
                        break if !(_e584);
                    }
                }
                let _e1022 = local;
                if (_e86.x >= _e38) {
                    phi_1552_ = ((_e86.x - _e38) | 2147483648u);
                } else {
                    phi_1552_ = _e86.x;
                }
                let _e1028 = phi_1552_;
                let _e1030 = local_1;
                if (_e86.y >= _e38) {
                    phi_1560_ = ((_e86.y - _e38) | 2147483648u);
                } else {
                    phi_1560_ = _e86.y;
                }
                let _e1036 = phi_1560_;
                let _e1038 = local_2;
                let _e1041 = local_3;
                if ((_e94 - _e86.z) < (_e86.w - _e94)) {
                    phi_1566_ = 2147483648u;
                } else {
                    phi_1566_ = 0u;
                }
                let _e1044 = phi_1566_;
                nodes.member[_e84] = type_25(vec4<u32>(bitcast<u32>(_e1022.member[0]), bitcast<u32>(_e1022.member[1]), bitcast<u32>(_e1022.member[2]), _e1028), vec4<u32>(bitcast<u32>(_e1030.member_1[0]), bitcast<u32>(_e1030.member_1[1]), bitcast<u32>(_e1030.member_1[2]), _e1036), vec4<u32>(bitcast<u32>(_e1038.member[0]), bitcast<u32>(_e1038.member[1]), bitcast<u32>(_e1038.member[2]), _e94), vec4<u32>(bitcast<u32>(_e1041.member_1[0]), bitcast<u32>(_e1041.member_1[1]), bitcast<u32>(_e1041.member_1[2]), (_e86.w | _e1044)));
                phi_1599_ = true;
            }
            let _e1077 = phi_1599_;
            phi_1600_ = _e1077;
        } else {
            phi_1600_ = false;
        }
        let _e1079 = phi_1600_;
        continue;
        continuing {
            phi_127_ = _e65;
            break if !(_e1079);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn far_nodes(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}

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
    var phi_139_: u32;
    var phi_142_: type_9;
    var phi_143_: type_9;
    var phi_166_: type_9;
    var phi_210_: u32;
    var phi_215_: type_9;
    var phi_218_: type_29;
    var phi_220_: u32;
    var phi_222_: u32;
    var phi_216_: type_9;
    var phi_245_: type_9;
    var phi_264_: u32;
    var phi_274_: bool;
    var phi_278_: u32;
    var phi_279_: u32;
    var phi_296_: u32;
    var phi_299_: type_9;
    var phi_302_: type_29;
    var phi_300_: type_9;
    var phi_325_: type_9;
    var phi_385_: u32;
    var phi_407_: u32;
    var phi_429_: u32;
    var phi_450_: f32;
    var phi_455_: f32;
    var phi_460_: f32;
    var phi_465_: f32;
    var phi_470_: f32;
    var phi_475_: f32;
    var phi_480_: f32;
    var phi_485_: f32;
    var phi_490_: f32;
    var phi_495_: f32;
    var phi_500_: f32;
    var phi_505_: f32;
    var phi_510_: f32;
    var phi_515_: f32;
    var phi_520_: f32;
    var phi_525_: f32;
    var phi_530_: f32;
    var phi_535_: f32;
    var phi_541_: f32;
    var phi_547_: f32;
    var phi_553_: f32;
    var phi_560_: f32;
    var phi_566_: f32;
    var phi_572_: f32;
    var phi_303_: type_29;
    var phi_591_: u32;
    var phi_594_: type_9;
    var phi_597_: type_29;
    var phi_595_: type_9;
    var phi_620_: type_9;
    var phi_680_: u32;
    var phi_702_: u32;
    var phi_724_: u32;
    var phi_745_: f32;
    var phi_750_: f32;
    var phi_755_: f32;
    var phi_760_: f32;
    var phi_765_: f32;
    var phi_770_: f32;
    var phi_775_: f32;
    var phi_780_: f32;
    var phi_785_: f32;
    var phi_790_: f32;
    var phi_795_: f32;
    var phi_800_: f32;
    var phi_805_: f32;
    var phi_810_: f32;
    var phi_815_: f32;
    var phi_820_: f32;
    var phi_825_: f32;
    var phi_830_: f32;
    var phi_836_: f32;
    var phi_842_: f32;
    var phi_848_: f32;
    var phi_855_: f32;
    var phi_861_: f32;
    var phi_867_: f32;
    var phi_598_: type_29;
    var phi_874_: u32;
    var phi_879_: u32;
    var phi_219_: type_29;
    var phi_221_: u32;
    var phi_223_: u32;
    var phi_885_: type_9;
    var phi_888_: type_29;
    var phi_890_: u32;
    var phi_892_: u32;
    var phi_886_: type_9;
    var phi_915_: type_9;
    var phi_934_: u32;
    var phi_944_: bool;
    var phi_948_: u32;
    var phi_949_: u32;
    var phi_966_: u32;
    var phi_969_: type_9;
    var phi_972_: type_29;
    var phi_970_: type_9;
    var phi_995_: type_9;
    var phi_1055_: u32;
    var phi_1077_: u32;
    var phi_1099_: u32;
    var phi_1120_: f32;
    var phi_1125_: f32;
    var phi_1130_: f32;
    var phi_1135_: f32;
    var phi_1140_: f32;
    var phi_1145_: f32;
    var phi_1150_: f32;
    var phi_1155_: f32;
    var phi_1160_: f32;
    var phi_1165_: f32;
    var phi_1170_: f32;
    var phi_1175_: f32;
    var phi_1180_: f32;
    var phi_1185_: f32;
    var phi_1190_: f32;
    var phi_1195_: f32;
    var phi_1200_: f32;
    var phi_1205_: f32;
    var phi_1211_: f32;
    var phi_1217_: f32;
    var phi_1223_: f32;
    var phi_1230_: f32;
    var phi_1236_: f32;
    var phi_1242_: f32;
    var phi_973_: type_29;
    var phi_1261_: u32;
    var phi_1264_: type_9;
    var phi_1267_: type_29;
    var phi_1265_: type_9;
    var phi_1290_: type_9;
    var phi_1350_: u32;
    var phi_1372_: u32;
    var phi_1394_: u32;
    var phi_1415_: f32;
    var phi_1420_: f32;
    var phi_1425_: f32;
    var phi_1430_: f32;
    var phi_1435_: f32;
    var phi_1440_: f32;
    var phi_1445_: f32;
    var phi_1450_: f32;
    var phi_1455_: f32;
    var phi_1460_: f32;
    var phi_1465_: f32;
    var phi_1470_: f32;
    var phi_1475_: f32;
    var phi_1480_: f32;
    var phi_1485_: f32;
    var phi_1490_: f32;
    var phi_1495_: f32;
    var phi_1500_: f32;
    var phi_1506_: f32;
    var phi_1512_: f32;
    var phi_1518_: f32;
    var phi_1525_: f32;
    var phi_1531_: f32;
    var phi_1537_: f32;
    var phi_1268_: type_29;
    var phi_1544_: u32;
    var phi_1549_: u32;
    var phi_889_: type_29;
    var phi_891_: u32;
    var phi_893_: u32;
    var local: type_29;
    var phi_1560_: u32;
    var local_1: type_29;
    var phi_1568_: u32;
    var local_2: type_29;
    var local_3: type_29;
    var phi_1574_: u32;
    var phi_1607_: bool;
    var phi_1608_: bool;
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
    let _e44 = params.member.member_2.member_1;
    let _e46 = far.member[0u];
    let _e50 = params.member.member.member[_e44];
    let _e51 = (_e50 - 1u);
    let _e52 = ((_e25.x * _e25.y) * 128u);
    if (_e52 == 0u) {
        return;
    }
    let _e54 = (_e46 / _e52);
    if (_e52 == 0u) {
        return;
    }
    if ((_e46 % _e52) > 0u) {
        phi_139_ = (_e54 + 1u);
    } else {
        phi_139_ = _e54;
    }
    let _e60 = phi_139_;
    phi_142_ = type_9(0u, _e60);
    loop {
        let _e63 = phi_142_;
        if (_e63.member < _e63.member_1) {
            phi_143_ = type_9((_e63.member + 1u), _e63.member_1);
            phi_166_ = type_9(1u, _e63.member);
        } else {
            phi_143_ = _e63;
            phi_166_ = type_9(0u, type_9().member_1);
        }
        let _e75 = phi_143_;
        let _e77 = phi_166_;
        if (bitcast<i32>(_e77.member) != 0i) {
            let _e83 = ((_e77.member_1 * _e52) + ((((_e24.y * _e25.x) + _e24.x) * 128u) + _e26));
            if (_e83 >= _e46) {
                phi_1607_ = false;
            } else {
                let _e87 = far.member[(4u + _e83)];
                let _e89 = branches.member[_e87];
                if (_e89.x >= _e51) {
                    phi_210_ = (_e89.x - _e51);
                } else {
                    phi_210_ = _e89.x;
                }
                let _e97 = phi_210_;
                phi_215_ = type_9(0u, 8u);
                phi_218_ = type_29(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                phi_220_ = (_e97 + 1u);
                phi_222_ = _e89.z;
                loop {
                    let _e101 = phi_215_;
                    let _e103 = phi_218_;
                    let _e105 = phi_220_;
                    let _e107 = phi_222_;
                    local = _e103;
                    local_1 = _e103;
                    if (_e101.member < _e101.member_1) {
                        phi_216_ = type_9((_e101.member + 1u), _e101.member_1);
                        phi_245_ = type_9(1u, _e101.member);
                    } else {
                        phi_216_ = _e101;
                        phi_245_ = type_9(0u, type_9().member_1);
                    }
                    let _e119 = phi_216_;
                    let _e121 = phi_245_;
                    let _e125 = (bitcast<i32>(_e121.member) != 0i);
                    if _e125 {
                        let _e126 = (_e107 % 32u);
                        if (_e126 == 0u) {
                            phi_264_ = _e107;
                        } else {
                            phi_264_ = (_e107 + (32u - _e126));
                        }
                        let _e131 = phi_264_;
                        let _e133 = ((_e105 / 32u) * 32u);
                        if (_e131 < _e133) {
                            let _e136 = params.member.member_2.member_2;
                            phi_274_ = (_e121.member_1 < _e136);
                        } else {
                            phi_274_ = false;
                        }
                        let _e139 = phi_274_;
                        if _e139 {
                            phi_278_ = _e133;
                            phi_279_ = _e131;
                        } else {
                            phi_278_ = _e105;
                            phi_279_ = _e105;
                        }
                        let _e141 = phi_278_;
                        let _e143 = phi_279_;
                        let _e144 = (_e143 - _e107);
                        let _e145 = (_e144 / 4u);
                        if ((_e144 % 4u) > 0u) {
                            phi_296_ = (_e145 + 1u);
                        } else {
                            phi_296_ = _e145;
                        }
                        let _e150 = phi_296_;
                        phi_299_ = type_9(0u, _e150);
                        phi_302_ = _e103;
                        loop {
                            let _e153 = phi_299_;
                            let _e155 = phi_302_;
                            local_4 = _e155;
                            if (_e153.member < _e153.member_1) {
                                phi_300_ = type_9((_e153.member + 1u), _e153.member_1);
                                phi_325_ = type_9(1u, _e153.member);
                            } else {
                                phi_300_ = _e153;
                                phi_325_ = type_9(0u, type_9().member_1);
                            }
                            let _e167 = phi_300_;
                            let _e169 = phi_325_;
                            let _e173 = (bitcast<i32>(_e169.member) != 0i);
                            if _e173 {
                                let _e179 = params.member.member_2.member[_e121.member_1][_e44];
                                let _e180 = (_e179 + (_e107 + (4u * _e169.member_1)));
                                let _e184 = params.member.member_2.member[_e121.member_1][_e44];
                                let _e186 = ((_e184 + _e143) - 1u);
                                let _e188 = block_nodes.member[_e180];
                                let _e201 = (_e180 + 1u);
                                if (_e186 < _e201) {
                                    phi_385_ = _e186;
                                } else {
                                    phi_385_ = _e201;
                                }
                                let _e204 = phi_385_;
                                let _e206 = block_nodes.member[_e204];
                                let _e219 = (_e180 + 2u);
                                if (_e186 < _e219) {
                                    phi_407_ = _e186;
                                } else {
                                    phi_407_ = _e219;
                                }
                                let _e222 = phi_407_;
                                let _e224 = block_nodes.member[_e222];
                                let _e237 = (_e180 + 3u);
                                if (_e186 < _e237) {
                                    phi_429_ = _e186;
                                } else {
                                    phi_429_ = _e237;
                                }
                                let _e240 = phi_429_;
                                let _e242 = block_nodes.member[_e240];
                                if (_e188.member.x < _e206.member.x) {
                                    phi_450_ = _e188.member.x;
                                } else {
                                    phi_450_ = _e206.member.x;
                                }
                                let _e257 = phi_450_;
                                if (_e188.member.y < _e206.member.y) {
                                    phi_455_ = _e188.member.y;
                                } else {
                                    phi_455_ = _e206.member.y;
                                }
                                let _e260 = phi_455_;
                                if (_e188.member_1.x < _e206.member_1.x) {
                                    phi_460_ = _e188.member_1.x;
                                } else {
                                    phi_460_ = _e206.member_1.x;
                                }
                                let _e263 = phi_460_;
                                if (_e188.member_1.y > _e206.member_1.y) {
                                    phi_465_ = _e188.member_1.y;
                                } else {
                                    phi_465_ = _e206.member_1.y;
                                }
                                let _e266 = phi_465_;
                                if (_e188.member_2.x > _e206.member_2.x) {
                                    phi_470_ = _e188.member_2.x;
                                } else {
                                    phi_470_ = _e206.member_2.x;
                                }
                                let _e269 = phi_470_;
                                if (_e188.member_2.y > _e206.member_2.y) {
                                    phi_475_ = _e188.member_2.y;
                                } else {
                                    phi_475_ = _e206.member_2.y;
                                }
                                let _e272 = phi_475_;
                                if (_e224.member.x < _e242.member.x) {
                                    phi_480_ = _e224.member.x;
                                } else {
                                    phi_480_ = _e242.member.x;
                                }
                                let _e275 = phi_480_;
                                if (_e224.member.y < _e242.member.y) {
                                    phi_485_ = _e224.member.y;
                                } else {
                                    phi_485_ = _e242.member.y;
                                }
                                let _e278 = phi_485_;
                                if (_e224.member_1.x < _e242.member_1.x) {
                                    phi_490_ = _e224.member_1.x;
                                } else {
                                    phi_490_ = _e242.member_1.x;
                                }
                                let _e281 = phi_490_;
                                if (_e224.member_1.y > _e242.member_1.y) {
                                    phi_495_ = _e224.member_1.y;
                                } else {
                                    phi_495_ = _e242.member_1.y;
                                }
                                let _e284 = phi_495_;
                                if (_e224.member_2.x > _e242.member_2.x) {
                                    phi_500_ = _e224.member_2.x;
                                } else {
                                    phi_500_ = _e242.member_2.x;
                                }
                                let _e287 = phi_500_;
                                if (_e224.member_2.y > _e242.member_2.y) {
                                    phi_505_ = _e224.member_2.y;
                                } else {
                                    phi_505_ = _e242.member_2.y;
                                }
                                let _e290 = phi_505_;
                                if (_e257 < _e275) {
                                    phi_510_ = _e257;
                                } else {
                                    phi_510_ = _e275;
                                }
                                let _e293 = phi_510_;
                                if (_e260 < _e278) {
                                    phi_515_ = _e260;
                                } else {
                                    phi_515_ = _e278;
                                }
                                let _e296 = phi_515_;
                                if (_e263 < _e281) {
                                    phi_520_ = _e263;
                                } else {
                                    phi_520_ = _e281;
                                }
                                let _e299 = phi_520_;
                                if (_e266 > _e284) {
                                    phi_525_ = _e266;
                                } else {
                                    phi_525_ = _e284;
                                }
                                let _e302 = phi_525_;
                                if (_e269 > _e287) {
                                    phi_530_ = _e269;
                                } else {
                                    phi_530_ = _e287;
                                }
                                let _e305 = phi_530_;
                                if (_e272 > _e290) {
                                    phi_535_ = _e272;
                                } else {
                                    phi_535_ = _e290;
                                }
                                let _e308 = phi_535_;
                                if (_e155.member[0] < _e293) {
                                    phi_541_ = _e155.member[0];
                                } else {
                                    phi_541_ = _e293;
                                }
                                let _e313 = phi_541_;
                                if (_e155.member[1] < _e296) {
                                    phi_547_ = _e155.member[1];
                                } else {
                                    phi_547_ = _e296;
                                }
                                let _e318 = phi_547_;
                                if (_e155.member[2] < _e299) {
                                    phi_553_ = _e155.member[2];
                                } else {
                                    phi_553_ = _e299;
                                }
                                let _e323 = phi_553_;
                                if (_e155.member_1[0] > _e302) {
                                    phi_560_ = _e155.member_1[0];
                                } else {
                                    phi_560_ = _e302;
                                }
                                let _e329 = phi_560_;
                                if (_e155.member_1[1] > _e305) {
                                    phi_566_ = _e155.member_1[1];
                                } else {
                                    phi_566_ = _e305;
                                }
                                let _e334 = phi_566_;
                                if (_e155.member_1[2] > _e308) {
                                    phi_572_ = _e155.member_1[2];
                                } else {
                                    phi_572_ = _e308;
                                }
                                let _e339 = phi_572_;
                                phi_303_ = type_29(array<f32, 3>(_e313, _e318, _e323), array<f32, 3>(_e329, _e334, _e339));
                            } else {
                                phi_303_ = type_29();
                            }
                            let _e343 = phi_303_;
                            continue;
                            continuing {
                                phi_299_ = _e167;
                                phi_302_ = _e343;
                                break if !(_e173);
                            }
                        }
                        let _e345 = (_e105 - _e141);
                        let _e346 = (_e345 / 4u);
                        if ((_e345 % 4u) > 0u) {
                            phi_591_ = (_e346 + 1u);
                        } else {
                            phi_591_ = _e346;
                        }
                        let _e351 = phi_591_;
                        phi_594_ = type_9(0u, _e351);
                        let _e1136 = local_4;
                        phi_597_ = _e1136;
                        loop {
                            let _e354 = phi_594_;
                            let _e356 = phi_597_;
                            local_5 = _e356;
                            if (_e354.member < _e354.member_1) {
                                phi_595_ = type_9((_e354.member + 1u), _e354.member_1);
                                phi_620_ = type_9(1u, _e354.member);
                            } else {
                                phi_595_ = _e354;
                                phi_620_ = type_9(0u, type_9().member_1);
                            }
                            let _e368 = phi_595_;
                            let _e370 = phi_620_;
                            let _e374 = (bitcast<i32>(_e370.member) != 0i);
                            if _e374 {
                                let _e380 = params.member.member_2.member[_e121.member_1][_e44];
                                let _e381 = (_e380 + (_e141 + (4u * _e370.member_1)));
                                let _e385 = params.member.member_2.member[_e121.member_1][_e44];
                                let _e387 = ((_e385 + _e105) - 1u);
                                let _e389 = block_nodes.member[_e381];
                                let _e402 = (_e381 + 1u);
                                if (_e387 < _e402) {
                                    phi_680_ = _e387;
                                } else {
                                    phi_680_ = _e402;
                                }
                                let _e405 = phi_680_;
                                let _e407 = block_nodes.member[_e405];
                                let _e420 = (_e381 + 2u);
                                if (_e387 < _e420) {
                                    phi_702_ = _e387;
                                } else {
                                    phi_702_ = _e420;
                                }
                                let _e423 = phi_702_;
                                let _e425 = block_nodes.member[_e423];
                                let _e438 = (_e381 + 3u);
                                if (_e387 < _e438) {
                                    phi_724_ = _e387;
                                } else {
                                    phi_724_ = _e438;
                                }
                                let _e441 = phi_724_;
                                let _e443 = block_nodes.member[_e441];
                                if (_e389.member.x < _e407.member.x) {
                                    phi_745_ = _e389.member.x;
                                } else {
                                    phi_745_ = _e407.member.x;
                                }
                                let _e458 = phi_745_;
                                if (_e389.member.y < _e407.member.y) {
                                    phi_750_ = _e389.member.y;
                                } else {
                                    phi_750_ = _e407.member.y;
                                }
                                let _e461 = phi_750_;
                                if (_e389.member_1.x < _e407.member_1.x) {
                                    phi_755_ = _e389.member_1.x;
                                } else {
                                    phi_755_ = _e407.member_1.x;
                                }
                                let _e464 = phi_755_;
                                if (_e389.member_1.y > _e407.member_1.y) {
                                    phi_760_ = _e389.member_1.y;
                                } else {
                                    phi_760_ = _e407.member_1.y;
                                }
                                let _e467 = phi_760_;
                                if (_e389.member_2.x > _e407.member_2.x) {
                                    phi_765_ = _e389.member_2.x;
                                } else {
                                    phi_765_ = _e407.member_2.x;
                                }
                                let _e470 = phi_765_;
                                if (_e389.member_2.y > _e407.member_2.y) {
                                    phi_770_ = _e389.member_2.y;
                                } else {
                                    phi_770_ = _e407.member_2.y;
                                }
                                let _e473 = phi_770_;
                                if (_e425.member.x < _e443.member.x) {
                                    phi_775_ = _e425.member.x;
                                } else {
                                    phi_775_ = _e443.member.x;
                                }
                                let _e476 = phi_775_;
                                if (_e425.member.y < _e443.member.y) {
                                    phi_780_ = _e425.member.y;
                                } else {
                                    phi_780_ = _e443.member.y;
                                }
                                let _e479 = phi_780_;
                                if (_e425.member_1.x < _e443.member_1.x) {
                                    phi_785_ = _e425.member_1.x;
                                } else {
                                    phi_785_ = _e443.member_1.x;
                                }
                                let _e482 = phi_785_;
                                if (_e425.member_1.y > _e443.member_1.y) {
                                    phi_790_ = _e425.member_1.y;
                                } else {
                                    phi_790_ = _e443.member_1.y;
                                }
                                let _e485 = phi_790_;
                                if (_e425.member_2.x > _e443.member_2.x) {
                                    phi_795_ = _e425.member_2.x;
                                } else {
                                    phi_795_ = _e443.member_2.x;
                                }
                                let _e488 = phi_795_;
                                if (_e425.member_2.y > _e443.member_2.y) {
                                    phi_800_ = _e425.member_2.y;
                                } else {
                                    phi_800_ = _e443.member_2.y;
                                }
                                let _e491 = phi_800_;
                                if (_e458 < _e476) {
                                    phi_805_ = _e458;
                                } else {
                                    phi_805_ = _e476;
                                }
                                let _e494 = phi_805_;
                                if (_e461 < _e479) {
                                    phi_810_ = _e461;
                                } else {
                                    phi_810_ = _e479;
                                }
                                let _e497 = phi_810_;
                                if (_e464 < _e482) {
                                    phi_815_ = _e464;
                                } else {
                                    phi_815_ = _e482;
                                }
                                let _e500 = phi_815_;
                                if (_e467 > _e485) {
                                    phi_820_ = _e467;
                                } else {
                                    phi_820_ = _e485;
                                }
                                let _e503 = phi_820_;
                                if (_e470 > _e488) {
                                    phi_825_ = _e470;
                                } else {
                                    phi_825_ = _e488;
                                }
                                let _e506 = phi_825_;
                                if (_e473 > _e491) {
                                    phi_830_ = _e473;
                                } else {
                                    phi_830_ = _e491;
                                }
                                let _e509 = phi_830_;
                                if (_e356.member[0] < _e494) {
                                    phi_836_ = _e356.member[0];
                                } else {
                                    phi_836_ = _e494;
                                }
                                let _e514 = phi_836_;
                                if (_e356.member[1] < _e497) {
                                    phi_842_ = _e356.member[1];
                                } else {
                                    phi_842_ = _e497;
                                }
                                let _e519 = phi_842_;
                                if (_e356.member[2] < _e500) {
                                    phi_848_ = _e356.member[2];
                                } else {
                                    phi_848_ = _e500;
                                }
                                let _e524 = phi_848_;
                                if (_e356.member_1[0] > _e503) {
                                    phi_855_ = _e356.member_1[0];
                                } else {
                                    phi_855_ = _e503;
                                }
                                let _e530 = phi_855_;
                                if (_e356.member_1[1] > _e506) {
                                    phi_861_ = _e356.member_1[1];
                                } else {
                                    phi_861_ = _e506;
                                }
                                let _e535 = phi_861_;
                                if (_e356.member_1[2] > _e509) {
                                    phi_867_ = _e356.member_1[2];
                                } else {
                                    phi_867_ = _e509;
                                }
                                let _e540 = phi_867_;
                                phi_598_ = type_29(array<f32, 3>(_e514, _e519, _e524), array<f32, 3>(_e530, _e535, _e540));
                            } else {
                                phi_598_ = type_29();
                            }
                            let _e544 = phi_598_;
                            continue;
                            continuing {
                                phi_594_ = _e368;
                                phi_597_ = _e544;
                                break if !(_e374);
                            }
                        }
                        if _e139 {
                            phi_874_ = (_e131 / 32u);
                        } else {
                            phi_874_ = 0u;
                        }
                        let _e548 = phi_874_;
                        if _e139 {
                            phi_879_ = (_e133 / 32u);
                        } else {
                            phi_879_ = 0u;
                        }
                        let _e551 = phi_879_;
                        let _e1171 = local_5;
                        phi_219_ = _e1171;
                        phi_221_ = _e551;
                        phi_223_ = _e548;
                    } else {
                        phi_219_ = type_29();
                        phi_221_ = u32();
                        phi_223_ = u32();
                    }
                    let _e553 = phi_219_;
                    let _e555 = phi_221_;
                    let _e557 = phi_223_;
                    continue;
                    continuing {
                        phi_215_ = _e119;
                        phi_218_ = _e553;
                        phi_220_ = _e555;
                        phi_222_ = _e557;
                        break if !(_e125);
                    }
                }
                phi_885_ = type_9(0u, 8u);
                phi_888_ = type_29(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                phi_890_ = (_e89.w + 1u);
                phi_892_ = (_e97 + 1u);
                loop {
                    let _e563 = phi_885_;
                    let _e565 = phi_888_;
                    let _e567 = phi_890_;
                    let _e569 = phi_892_;
                    local_2 = _e565;
                    local_3 = _e565;
                    if (_e563.member < _e563.member_1) {
                        phi_886_ = type_9((_e563.member + 1u), _e563.member_1);
                        phi_915_ = type_9(1u, _e563.member);
                    } else {
                        phi_886_ = _e563;
                        phi_915_ = type_9(0u, type_9().member_1);
                    }
                    let _e581 = phi_886_;
                    let _e583 = phi_915_;
                    let _e587 = (bitcast<i32>(_e583.member) != 0i);
                    if _e587 {
                        let _e588 = (_e569 % 32u);
                        if (_e588 == 0u) {
                            phi_934_ = _e569;
                        } else {
                            phi_934_ = (_e569 + (32u - _e588));
                        }
                        let _e593 = phi_934_;
                        let _e595 = ((_e567 / 32u) * 32u);
                        if (_e593 < _e595) {
                            let _e598 = params.member.member_2.member_2;
                            phi_944_ = (_e583.member_1 < _e598);
                        } else {
                            phi_944_ = false;
                        }
                        let _e601 = phi_944_;
                        if _e601 {
                            phi_948_ = _e595;
                            phi_949_ = _e593;
                        } else {
                            phi_948_ = _e567;
                            phi_949_ = _e567;
                        }
                        let _e603 = phi_948_;
                        let _e605 = phi_949_;
                        let _e606 = (_e605 - _e569);
                        let _e607 = (_e606 / 4u);
                        if ((_e606 % 4u) > 0u) {
                            phi_966_ = (_e607 + 1u);
                        } else {
                            phi_966_ = _e607;
                        }
                        let _e612 = phi_966_;
                        phi_969_ = type_9(0u, _e612);
                        phi_972_ = _e565;
                        loop {
                            let _e615 = phi_969_;
                            let _e617 = phi_972_;
                            local_6 = _e617;
                            if (_e615.member < _e615.member_1) {
                                phi_970_ = type_9((_e615.member + 1u), _e615.member_1);
                                phi_995_ = type_9(1u, _e615.member);
                            } else {
                                phi_970_ = _e615;
                                phi_995_ = type_9(0u, type_9().member_1);
                            }
                            let _e629 = phi_970_;
                            let _e631 = phi_995_;
                            let _e635 = (bitcast<i32>(_e631.member) != 0i);
                            if _e635 {
                                let _e641 = params.member.member_2.member[_e583.member_1][_e44];
                                let _e642 = (_e641 + (_e569 + (4u * _e631.member_1)));
                                let _e646 = params.member.member_2.member[_e583.member_1][_e44];
                                let _e648 = ((_e646 + _e605) - 1u);
                                let _e650 = block_nodes.member[_e642];
                                let _e663 = (_e642 + 1u);
                                if (_e648 < _e663) {
                                    phi_1055_ = _e648;
                                } else {
                                    phi_1055_ = _e663;
                                }
                                let _e666 = phi_1055_;
                                let _e668 = block_nodes.member[_e666];
                                let _e681 = (_e642 + 2u);
                                if (_e648 < _e681) {
                                    phi_1077_ = _e648;
                                } else {
                                    phi_1077_ = _e681;
                                }
                                let _e684 = phi_1077_;
                                let _e686 = block_nodes.member[_e684];
                                let _e699 = (_e642 + 3u);
                                if (_e648 < _e699) {
                                    phi_1099_ = _e648;
                                } else {
                                    phi_1099_ = _e699;
                                }
                                let _e702 = phi_1099_;
                                let _e704 = block_nodes.member[_e702];
                                if (_e650.member.x < _e668.member.x) {
                                    phi_1120_ = _e650.member.x;
                                } else {
                                    phi_1120_ = _e668.member.x;
                                }
                                let _e719 = phi_1120_;
                                if (_e650.member.y < _e668.member.y) {
                                    phi_1125_ = _e650.member.y;
                                } else {
                                    phi_1125_ = _e668.member.y;
                                }
                                let _e722 = phi_1125_;
                                if (_e650.member_1.x < _e668.member_1.x) {
                                    phi_1130_ = _e650.member_1.x;
                                } else {
                                    phi_1130_ = _e668.member_1.x;
                                }
                                let _e725 = phi_1130_;
                                if (_e650.member_1.y > _e668.member_1.y) {
                                    phi_1135_ = _e650.member_1.y;
                                } else {
                                    phi_1135_ = _e668.member_1.y;
                                }
                                let _e728 = phi_1135_;
                                if (_e650.member_2.x > _e668.member_2.x) {
                                    phi_1140_ = _e650.member_2.x;
                                } else {
                                    phi_1140_ = _e668.member_2.x;
                                }
                                let _e731 = phi_1140_;
                                if (_e650.member_2.y > _e668.member_2.y) {
                                    phi_1145_ = _e650.member_2.y;
                                } else {
                                    phi_1145_ = _e668.member_2.y;
                                }
                                let _e734 = phi_1145_;
                                if (_e686.member.x < _e704.member.x) {
                                    phi_1150_ = _e686.member.x;
                                } else {
                                    phi_1150_ = _e704.member.x;
                                }
                                let _e737 = phi_1150_;
                                if (_e686.member.y < _e704.member.y) {
                                    phi_1155_ = _e686.member.y;
                                } else {
                                    phi_1155_ = _e704.member.y;
                                }
                                let _e740 = phi_1155_;
                                if (_e686.member_1.x < _e704.member_1.x) {
                                    phi_1160_ = _e686.member_1.x;
                                } else {
                                    phi_1160_ = _e704.member_1.x;
                                }
                                let _e743 = phi_1160_;
                                if (_e686.member_1.y > _e704.member_1.y) {
                                    phi_1165_ = _e686.member_1.y;
                                } else {
                                    phi_1165_ = _e704.member_1.y;
                                }
                                let _e746 = phi_1165_;
                                if (_e686.member_2.x > _e704.member_2.x) {
                                    phi_1170_ = _e686.member_2.x;
                                } else {
                                    phi_1170_ = _e704.member_2.x;
                                }
                                let _e749 = phi_1170_;
                                if (_e686.member_2.y > _e704.member_2.y) {
                                    phi_1175_ = _e686.member_2.y;
                                } else {
                                    phi_1175_ = _e704.member_2.y;
                                }
                                let _e752 = phi_1175_;
                                if (_e719 < _e737) {
                                    phi_1180_ = _e719;
                                } else {
                                    phi_1180_ = _e737;
                                }
                                let _e755 = phi_1180_;
                                if (_e722 < _e740) {
                                    phi_1185_ = _e722;
                                } else {
                                    phi_1185_ = _e740;
                                }
                                let _e758 = phi_1185_;
                                if (_e725 < _e743) {
                                    phi_1190_ = _e725;
                                } else {
                                    phi_1190_ = _e743;
                                }
                                let _e761 = phi_1190_;
                                if (_e728 > _e746) {
                                    phi_1195_ = _e728;
                                } else {
                                    phi_1195_ = _e746;
                                }
                                let _e764 = phi_1195_;
                                if (_e731 > _e749) {
                                    phi_1200_ = _e731;
                                } else {
                                    phi_1200_ = _e749;
                                }
                                let _e767 = phi_1200_;
                                if (_e734 > _e752) {
                                    phi_1205_ = _e734;
                                } else {
                                    phi_1205_ = _e752;
                                }
                                let _e770 = phi_1205_;
                                if (_e617.member[0] < _e755) {
                                    phi_1211_ = _e617.member[0];
                                } else {
                                    phi_1211_ = _e755;
                                }
                                let _e775 = phi_1211_;
                                if (_e617.member[1] < _e758) {
                                    phi_1217_ = _e617.member[1];
                                } else {
                                    phi_1217_ = _e758;
                                }
                                let _e780 = phi_1217_;
                                if (_e617.member[2] < _e761) {
                                    phi_1223_ = _e617.member[2];
                                } else {
                                    phi_1223_ = _e761;
                                }
                                let _e785 = phi_1223_;
                                if (_e617.member_1[0] > _e764) {
                                    phi_1230_ = _e617.member_1[0];
                                } else {
                                    phi_1230_ = _e764;
                                }
                                let _e791 = phi_1230_;
                                if (_e617.member_1[1] > _e767) {
                                    phi_1236_ = _e617.member_1[1];
                                } else {
                                    phi_1236_ = _e767;
                                }
                                let _e796 = phi_1236_;
                                if (_e617.member_1[2] > _e770) {
                                    phi_1242_ = _e617.member_1[2];
                                } else {
                                    phi_1242_ = _e770;
                                }
                                let _e801 = phi_1242_;
                                phi_973_ = type_29(array<f32, 3>(_e775, _e780, _e785), array<f32, 3>(_e791, _e796, _e801));
                            } else {
                                phi_973_ = type_29();
                            }
                            let _e805 = phi_973_;
                            continue;
                            continuing {
                                phi_969_ = _e629;
                                phi_972_ = _e805;
                                break if !(_e635);
                            }
                        }
                        let _e807 = (_e567 - _e603);
                        let _e808 = (_e807 / 4u);
                        if ((_e807 % 4u) > 0u) {
                            phi_1261_ = (_e808 + 1u);
                        } else {
                            phi_1261_ = _e808;
                        }
                        let _e813 = phi_1261_;
                        phi_1264_ = type_9(0u, _e813);
                        let _e1221 = local_6;
                        phi_1267_ = _e1221;
                        loop {
                            let _e816 = phi_1264_;
                            let _e818 = phi_1267_;
                            local_7 = _e818;
                            if (_e816.member < _e816.member_1) {
                                phi_1265_ = type_9((_e816.member + 1u), _e816.member_1);
                                phi_1290_ = type_9(1u, _e816.member);
                            } else {
                                phi_1265_ = _e816;
                                phi_1290_ = type_9(0u, type_9().member_1);
                            }
                            let _e830 = phi_1265_;
                            let _e832 = phi_1290_;
                            let _e836 = (bitcast<i32>(_e832.member) != 0i);
                            if _e836 {
                                let _e842 = params.member.member_2.member[_e583.member_1][_e44];
                                let _e843 = (_e842 + (_e603 + (4u * _e832.member_1)));
                                let _e847 = params.member.member_2.member[_e583.member_1][_e44];
                                let _e849 = ((_e847 + _e567) - 1u);
                                let _e851 = block_nodes.member[_e843];
                                let _e864 = (_e843 + 1u);
                                if (_e849 < _e864) {
                                    phi_1350_ = _e849;
                                } else {
                                    phi_1350_ = _e864;
                                }
                                let _e867 = phi_1350_;
                                let _e869 = block_nodes.member[_e867];
                                let _e882 = (_e843 + 2u);
                                if (_e849 < _e882) {
                                    phi_1372_ = _e849;
                                } else {
                                    phi_1372_ = _e882;
                                }
                                let _e885 = phi_1372_;
                                let _e887 = block_nodes.member[_e885];
                                let _e900 = (_e843 + 3u);
                                if (_e849 < _e900) {
                                    phi_1394_ = _e849;
                                } else {
                                    phi_1394_ = _e900;
                                }
                                let _e903 = phi_1394_;
                                let _e905 = block_nodes.member[_e903];
                                if (_e851.member.x < _e869.member.x) {
                                    phi_1415_ = _e851.member.x;
                                } else {
                                    phi_1415_ = _e869.member.x;
                                }
                                let _e920 = phi_1415_;
                                if (_e851.member.y < _e869.member.y) {
                                    phi_1420_ = _e851.member.y;
                                } else {
                                    phi_1420_ = _e869.member.y;
                                }
                                let _e923 = phi_1420_;
                                if (_e851.member_1.x < _e869.member_1.x) {
                                    phi_1425_ = _e851.member_1.x;
                                } else {
                                    phi_1425_ = _e869.member_1.x;
                                }
                                let _e926 = phi_1425_;
                                if (_e851.member_1.y > _e869.member_1.y) {
                                    phi_1430_ = _e851.member_1.y;
                                } else {
                                    phi_1430_ = _e869.member_1.y;
                                }
                                let _e929 = phi_1430_;
                                if (_e851.member_2.x > _e869.member_2.x) {
                                    phi_1435_ = _e851.member_2.x;
                                } else {
                                    phi_1435_ = _e869.member_2.x;
                                }
                                let _e932 = phi_1435_;
                                if (_e851.member_2.y > _e869.member_2.y) {
                                    phi_1440_ = _e851.member_2.y;
                                } else {
                                    phi_1440_ = _e869.member_2.y;
                                }
                                let _e935 = phi_1440_;
                                if (_e887.member.x < _e905.member.x) {
                                    phi_1445_ = _e887.member.x;
                                } else {
                                    phi_1445_ = _e905.member.x;
                                }
                                let _e938 = phi_1445_;
                                if (_e887.member.y < _e905.member.y) {
                                    phi_1450_ = _e887.member.y;
                                } else {
                                    phi_1450_ = _e905.member.y;
                                }
                                let _e941 = phi_1450_;
                                if (_e887.member_1.x < _e905.member_1.x) {
                                    phi_1455_ = _e887.member_1.x;
                                } else {
                                    phi_1455_ = _e905.member_1.x;
                                }
                                let _e944 = phi_1455_;
                                if (_e887.member_1.y > _e905.member_1.y) {
                                    phi_1460_ = _e887.member_1.y;
                                } else {
                                    phi_1460_ = _e905.member_1.y;
                                }
                                let _e947 = phi_1460_;
                                if (_e887.member_2.x > _e905.member_2.x) {
                                    phi_1465_ = _e887.member_2.x;
                                } else {
                                    phi_1465_ = _e905.member_2.x;
                                }
                                let _e950 = phi_1465_;
                                if (_e887.member_2.y > _e905.member_2.y) {
                                    phi_1470_ = _e887.member_2.y;
                                } else {
                                    phi_1470_ = _e905.member_2.y;
                                }
                                let _e953 = phi_1470_;
                                if (_e920 < _e938) {
                                    phi_1475_ = _e920;
                                } else {
                                    phi_1475_ = _e938;
                                }
                                let _e956 = phi_1475_;
                                if (_e923 < _e941) {
                                    phi_1480_ = _e923;
                                } else {
                                    phi_1480_ = _e941;
                                }
                                let _e959 = phi_1480_;
                                if (_e926 < _e944) {
                                    phi_1485_ = _e926;
                                } else {
                                    phi_1485_ = _e944;
                                }
                                let _e962 = phi_1485_;
                                if (_e929 > _e947) {
                                    phi_1490_ = _e929;
                                } else {
                                    phi_1490_ = _e947;
                                }
                                let _e965 = phi_1490_;
                                if (_e932 > _e950) {
                                    phi_1495_ = _e932;
                                } else {
                                    phi_1495_ = _e950;
                                }
                                let _e968 = phi_1495_;
                                if (_e935 > _e953) {
                                    phi_1500_ = _e935;
                                } else {
                                    phi_1500_ = _e953;
                                }
                                let _e971 = phi_1500_;
                                if (_e818.member[0] < _e956) {
                                    phi_1506_ = _e818.member[0];
                                } else {
                                    phi_1506_ = _e956;
                                }
                                let _e976 = phi_1506_;
                                if (_e818.member[1] < _e959) {
                                    phi_1512_ = _e818.member[1];
                                } else {
                                    phi_1512_ = _e959;
                                }
                                let _e981 = phi_1512_;
                                if (_e818.member[2] < _e962) {
                                    phi_1518_ = _e818.member[2];
                                } else {
                                    phi_1518_ = _e962;
                                }
                                let _e986 = phi_1518_;
                                if (_e818.member_1[0] > _e965) {
                                    phi_1525_ = _e818.member_1[0];
                                } else {
                                    phi_1525_ = _e965;
                                }
                                let _e992 = phi_1525_;
                                if (_e818.member_1[1] > _e968) {
                                    phi_1531_ = _e818.member_1[1];
                                } else {
                                    phi_1531_ = _e968;
                                }
                                let _e997 = phi_1531_;
                                if (_e818.member_1[2] > _e971) {
                                    phi_1537_ = _e818.member_1[2];
                                } else {
                                    phi_1537_ = _e971;
                                }
                                let _e1002 = phi_1537_;
                                phi_1268_ = type_29(array<f32, 3>(_e976, _e981, _e986), array<f32, 3>(_e992, _e997, _e1002));
                            } else {
                                phi_1268_ = type_29();
                            }
                            let _e1006 = phi_1268_;
                            continue;
                            continuing {
                                phi_1264_ = _e830;
                                phi_1267_ = _e1006;
                                break if !(_e836);
                            }
                        }
                        if _e601 {
                            phi_1544_ = (_e593 / 32u);
                        } else {
                            phi_1544_ = 0u;
                        }
                        let _e1010 = phi_1544_;
                        if _e601 {
                            phi_1549_ = (_e595 / 32u);
                        } else {
                            phi_1549_ = 0u;
                        }
                        let _e1013 = phi_1549_;
                        let _e1256 = local_7;
                        phi_889_ = _e1256;
                        phi_891_ = _e1013;
                        phi_893_ = _e1010;
                    } else {
                        phi_889_ = type_29();
                        phi_891_ = u32();
                        phi_893_ = u32();
                    }
                    let _e1015 = phi_889_;
                    let _e1017 = phi_891_;
                    let _e1019 = phi_893_;
                    continue;
                    continuing {
                        phi_885_ = _e581;
                        phi_888_ = _e1015;
                        phi_890_ = _e1017;
                        phi_892_ = _e1019;
                        break if !(_e587);
                    }
                }
                let _e1025 = local;
                if (_e89.x >= _e51) {
                    phi_1560_ = ((_e89.x - _e51) | 2147483648u);
                } else {
                    phi_1560_ = _e89.x;
                }
                let _e1031 = phi_1560_;
                let _e1033 = local_1;
                if (_e89.y >= _e51) {
                    phi_1568_ = ((_e89.y - _e51) | 2147483648u);
                } else {
                    phi_1568_ = _e89.y;
                }
                let _e1039 = phi_1568_;
                let _e1041 = local_2;
                let _e1044 = local_3;
                if ((_e97 - _e89.z) < (_e89.w - _e97)) {
                    phi_1574_ = 2147483648u;
                } else {
                    phi_1574_ = 0u;
                }
                let _e1047 = phi_1574_;
                nodes.member[_e87] = type_25(vec4<u32>(bitcast<u32>(_e1025.member[0]), bitcast<u32>(_e1025.member[1]), bitcast<u32>(_e1025.member[2]), _e1031), vec4<u32>(bitcast<u32>(_e1033.member_1[0]), bitcast<u32>(_e1033.member_1[1]), bitcast<u32>(_e1033.member_1[2]), _e1039), vec4<u32>(bitcast<u32>(_e1041.member[0]), bitcast<u32>(_e1041.member[1]), bitcast<u32>(_e1041.member[2]), _e97), vec4<u32>(bitcast<u32>(_e1044.member_1[0]), bitcast<u32>(_e1044.member_1[1]), bitcast<u32>(_e1044.member_1[2]), (_e89.w | _e1047)));
                phi_1607_ = true;
            }
            let _e1080 = phi_1607_;
            phi_1608_ = _e1080;
        } else {
            phi_1608_ = false;
        }
        let _e1082 = phi_1608_;
        continue;
        continuing {
            phi_142_ = _e75;
            break if !(_e1082);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn far_nodes(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}

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

struct type_13 {
    member: array<array<u32, 4>, 8>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_14 {
    member: type_7,
    member_1: type_8,
    member_2: type_13,
}

struct type_15 {
    member: type_14,
}

struct type_16 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_18 {
    member: array<type_16>,
}

struct type_20 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_22 {
    member: array<type_8>,
}

struct type_24 {
    member: array<type_20>,
}

struct type_25 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
}

struct type_27 {
    member: array<type_25>,
}

@group(0) @binding(0) 
var<storage> params: type_15;
@group(0) @binding(1) 
var<storage> branches: type_22;
@group(0) @binding(2) 
var<storage> block_nodes: type_24;
@group(0) @binding(3) 
var<storage> leaves: type_18;
@group(0) @binding(4) 
var<storage, read_write> nodes: type_27;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_128_: type_9;
    var phi_131_: type_20;
    var phi_133_: u32;
    var phi_135_: u32;
    var phi_129_: type_9;
    var phi_158_: type_9;
    var phi_177_: u32;
    var phi_187_: bool;
    var phi_191_: u32;
    var phi_192_: u32;
    var phi_209_: u32;
    var phi_212_: type_9;
    var phi_215_: type_20;
    var phi_213_: type_9;
    var phi_238_: type_9;
    var phi_292_: u32;
    var phi_308_: u32;
    var phi_324_: u32;
    var phi_341_: f32;
    var phi_348_: f32;
    var phi_355_: f32;
    var phi_362_: f32;
    var phi_369_: f32;
    var phi_376_: f32;
    var phi_383_: f32;
    var phi_390_: f32;
    var phi_397_: f32;
    var phi_404_: f32;
    var phi_411_: f32;
    var phi_418_: f32;
    var phi_423_: f32;
    var phi_428_: f32;
    var phi_433_: f32;
    var phi_438_: f32;
    var phi_443_: f32;
    var phi_448_: f32;
    var phi_454_: f32;
    var phi_460_: f32;
    var phi_466_: f32;
    var phi_473_: f32;
    var phi_479_: f32;
    var phi_485_: f32;
    var phi_216_: type_20;
    var phi_504_: u32;
    var phi_507_: type_9;
    var phi_510_: type_20;
    var phi_508_: type_9;
    var phi_533_: type_9;
    var phi_587_: u32;
    var phi_603_: u32;
    var phi_619_: u32;
    var phi_636_: f32;
    var phi_643_: f32;
    var phi_650_: f32;
    var phi_657_: f32;
    var phi_664_: f32;
    var phi_671_: f32;
    var phi_678_: f32;
    var phi_685_: f32;
    var phi_692_: f32;
    var phi_699_: f32;
    var phi_706_: f32;
    var phi_713_: f32;
    var phi_718_: f32;
    var phi_723_: f32;
    var phi_728_: f32;
    var phi_733_: f32;
    var phi_738_: f32;
    var phi_743_: f32;
    var phi_749_: f32;
    var phi_755_: f32;
    var phi_761_: f32;
    var phi_768_: f32;
    var phi_774_: f32;
    var phi_780_: f32;
    var phi_511_: type_20;
    var phi_787_: u32;
    var phi_792_: u32;
    var phi_132_: type_20;
    var phi_134_: u32;
    var phi_136_: u32;
    var local: type_20;
    var local_1: type_20;
    var local_2: type_20;
    var local_3: type_20;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e23 = id_2;
    let _e24 = n_2;
    let _e25 = lane_2;
    let _e37 = ((((_e23.y * _e24.x) + _e23.x) * 256u) + _e25);
    let _e40 = params.member.member_2.member_1;
    let _e44 = params.member.member.member[_e40];
    if ((_e37 + 1u) < _e44) {
        let _e48 = branches.member[_e37];
        phi_128_ = type_9(0u, 8u);
        phi_131_ = type_20(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        phi_133_ = (_e48.member_3 + 1u);
        phi_135_ = _e48.member_2;
        loop {
            let _e54 = phi_128_;
            let _e56 = phi_131_;
            let _e58 = phi_133_;
            let _e60 = phi_135_;
            local = _e56;
            local_1 = _e56;
            if (_e54.member < _e54.member_1) {
                phi_129_ = type_9((_e54.member + 1u), _e54.member_1);
                phi_158_ = type_9(1u, _e54.member);
            } else {
                phi_129_ = _e54;
                phi_158_ = type_9(0u, type_9().member_1);
            }
            let _e72 = phi_129_;
            let _e74 = phi_158_;
            let _e78 = (bitcast<i32>(_e74.member) != 0i);
            if _e78 {
                let _e79 = (_e60 % 32u);
                if (_e79 == 0u) {
                    phi_177_ = _e60;
                } else {
                    phi_177_ = (_e60 + (32u - _e79));
                }
                let _e84 = phi_177_;
                let _e86 = ((_e58 / 32u) * 32u);
                if (_e84 < _e86) {
                    let _e89 = params.member.member_2.member_2;
                    phi_187_ = (_e74.member_1 < _e89);
                } else {
                    phi_187_ = false;
                }
                let _e92 = phi_187_;
                if _e92 {
                    phi_191_ = _e86;
                    phi_192_ = _e84;
                } else {
                    phi_191_ = _e58;
                    phi_192_ = _e58;
                }
                let _e94 = phi_191_;
                let _e96 = phi_192_;
                let _e97 = (_e96 - _e60);
                let _e98 = (_e97 / 4u);
                if ((_e97 % 4u) > 0u) {
                    phi_209_ = (_e98 + 1u);
                } else {
                    phi_209_ = _e98;
                }
                let _e103 = phi_209_;
                phi_212_ = type_9(0u, _e103);
                phi_215_ = _e56;
                loop {
                    let _e106 = phi_212_;
                    let _e108 = phi_215_;
                    local_2 = _e108;
                    if (_e106.member < _e106.member_1) {
                        phi_213_ = type_9((_e106.member + 1u), _e106.member_1);
                        phi_238_ = type_9(1u, _e106.member);
                    } else {
                        phi_213_ = _e106;
                        phi_238_ = type_9(0u, type_9().member_1);
                    }
                    let _e120 = phi_213_;
                    let _e122 = phi_238_;
                    let _e126 = (bitcast<i32>(_e122.member) != 0i);
                    if _e126 {
                        let _e132 = params.member.member_2.member[_e74.member_1][_e40];
                        let _e133 = (_e132 + (_e60 + (4u * _e122.member_1)));
                        let _e137 = params.member.member_2.member[_e74.member_1][_e40];
                        let _e139 = ((_e137 + _e96) - 1u);
                        let _e141 = block_nodes.member[_e133];
                        let _e142 = (_e133 + 1u);
                        if (_e139 < _e142) {
                            phi_292_ = _e139;
                        } else {
                            phi_292_ = _e142;
                        }
                        let _e145 = phi_292_;
                        let _e147 = block_nodes.member[_e145];
                        let _e148 = (_e133 + 2u);
                        if (_e139 < _e148) {
                            phi_308_ = _e139;
                        } else {
                            phi_308_ = _e148;
                        }
                        let _e151 = phi_308_;
                        let _e153 = block_nodes.member[_e151];
                        let _e154 = (_e133 + 3u);
                        if (_e139 < _e154) {
                            phi_324_ = _e139;
                        } else {
                            phi_324_ = _e154;
                        }
                        let _e157 = phi_324_;
                        let _e159 = block_nodes.member[_e157];
                        if (_e141.member[0] < _e147.member[0]) {
                            phi_341_ = _e141.member[0];
                        } else {
                            phi_341_ = _e147.member[0];
                        }
                        let _e166 = phi_341_;
                        if (_e141.member[1] < _e147.member[1]) {
                            phi_348_ = _e141.member[1];
                        } else {
                            phi_348_ = _e147.member[1];
                        }
                        let _e173 = phi_348_;
                        if (_e141.member[2] < _e147.member[2]) {
                            phi_355_ = _e141.member[2];
                        } else {
                            phi_355_ = _e147.member[2];
                        }
                        let _e180 = phi_355_;
                        if (_e141.member_1[0] > _e147.member_1[0]) {
                            phi_362_ = _e141.member_1[0];
                        } else {
                            phi_362_ = _e147.member_1[0];
                        }
                        let _e187 = phi_362_;
                        if (_e141.member_1[1] > _e147.member_1[1]) {
                            phi_369_ = _e141.member_1[1];
                        } else {
                            phi_369_ = _e147.member_1[1];
                        }
                        let _e194 = phi_369_;
                        if (_e141.member_1[2] > _e147.member_1[2]) {
                            phi_376_ = _e141.member_1[2];
                        } else {
                            phi_376_ = _e147.member_1[2];
                        }
                        let _e201 = phi_376_;
                        if (_e153.member[0] < _e159.member[0]) {
                            phi_383_ = _e153.member[0];
                        } else {
                            phi_383_ = _e159.member[0];
                        }
                        let _e208 = phi_383_;
                        if (_e153.member[1] < _e159.member[1]) {
                            phi_390_ = _e153.member[1];
                        } else {
                            phi_390_ = _e159.member[1];
                        }
                        let _e215 = phi_390_;
                        if (_e153.member[2] < _e159.member[2]) {
                            phi_397_ = _e153.member[2];
                        } else {
                            phi_397_ = _e159.member[2];
                        }
                        let _e222 = phi_397_;
                        if (_e153.member_1[0] > _e159.member_1[0]) {
                            phi_404_ = _e153.member_1[0];
                        } else {
                            phi_404_ = _e159.member_1[0];
                        }
                        let _e229 = phi_404_;
                        if (_e153.member_1[1] > _e159.member_1[1]) {
                            phi_411_ = _e153.member_1[1];
                        } else {
                            phi_411_ = _e159.member_1[1];
                        }
                        let _e236 = phi_411_;
                        if (_e153.member_1[2] > _e159.member_1[2]) {
                            phi_418_ = _e153.member_1[2];
                        } else {
                            phi_418_ = _e159.member_1[2];
                        }
                        let _e243 = phi_418_;
                        if (_e166 < _e208) {
                            phi_423_ = _e166;
                        } else {
                            phi_423_ = _e208;
                        }
                        let _e246 = phi_423_;
                        if (_e173 < _e215) {
                            phi_428_ = _e173;
                        } else {
                            phi_428_ = _e215;
                        }
                        let _e249 = phi_428_;
                        if (_e180 < _e222) {
                            phi_433_ = _e180;
                        } else {
                            phi_433_ = _e222;
                        }
                        let _e252 = phi_433_;
                        if (_e187 > _e229) {
                            phi_438_ = _e187;
                        } else {
                            phi_438_ = _e229;
                        }
                        let _e255 = phi_438_;
                        if (_e194 > _e236) {
                            phi_443_ = _e194;
                        } else {
                            phi_443_ = _e236;
                        }
                        let _e258 = phi_443_;
                        if (_e201 > _e243) {
                            phi_448_ = _e201;
                        } else {
                            phi_448_ = _e243;
                        }
                        let _e261 = phi_448_;
                        if (_e108.member[0] < _e246) {
                            phi_454_ = _e108.member[0];
                        } else {
                            phi_454_ = _e246;
                        }
                        let _e266 = phi_454_;
                        if (_e108.member[1] < _e249) {
                            phi_460_ = _e108.member[1];
                        } else {
                            phi_460_ = _e249;
                        }
                        let _e271 = phi_460_;
                        if (_e108.member[2] < _e252) {
                            phi_466_ = _e108.member[2];
                        } else {
                            phi_466_ = _e252;
                        }
                        let _e276 = phi_466_;
                        if (_e108.member_1[0] > _e255) {
                            phi_473_ = _e108.member_1[0];
                        } else {
                            phi_473_ = _e255;
                        }
                        let _e282 = phi_473_;
                        if (_e108.member_1[1] > _e258) {
                            phi_479_ = _e108.member_1[1];
                        } else {
                            phi_479_ = _e258;
                        }
                        let _e287 = phi_479_;
                        if (_e108.member_1[2] > _e261) {
                            phi_485_ = _e108.member_1[2];
                        } else {
                            phi_485_ = _e261;
                        }
                        let _e292 = phi_485_;
                        phi_216_ = type_20(array<f32, 3>(_e266, _e271, _e276), array<f32, 3>(_e282, _e287, _e292));
                    } else {
                        phi_216_ = type_20();
                    }
                    let _e296 = phi_216_;
                    continue;
                    continuing {
                        phi_212_ = _e120;
                        phi_215_ = _e296;
                        break if !(_e126);
                    }
                }
                let _e298 = (_e58 - _e94);
                let _e299 = (_e298 / 4u);
                if ((_e298 % 4u) > 0u) {
                    phi_504_ = (_e299 + 1u);
                } else {
                    phi_504_ = _e299;
                }
                let _e304 = phi_504_;
                phi_507_ = type_9(0u, _e304);
                let _e587 = local_2;
                phi_510_ = _e587;
                loop {
                    let _e307 = phi_507_;
                    let _e309 = phi_510_;
                    local_3 = _e309;
                    if (_e307.member < _e307.member_1) {
                        phi_508_ = type_9((_e307.member + 1u), _e307.member_1);
                        phi_533_ = type_9(1u, _e307.member);
                    } else {
                        phi_508_ = _e307;
                        phi_533_ = type_9(0u, type_9().member_1);
                    }
                    let _e321 = phi_508_;
                    let _e323 = phi_533_;
                    let _e327 = (bitcast<i32>(_e323.member) != 0i);
                    if _e327 {
                        let _e333 = params.member.member_2.member[_e74.member_1][_e40];
                        let _e334 = (_e333 + (_e94 + (4u * _e323.member_1)));
                        let _e338 = params.member.member_2.member[_e74.member_1][_e40];
                        let _e340 = ((_e338 + _e58) - 1u);
                        let _e342 = block_nodes.member[_e334];
                        let _e343 = (_e334 + 1u);
                        if (_e340 < _e343) {
                            phi_587_ = _e340;
                        } else {
                            phi_587_ = _e343;
                        }
                        let _e346 = phi_587_;
                        let _e348 = block_nodes.member[_e346];
                        let _e349 = (_e334 + 2u);
                        if (_e340 < _e349) {
                            phi_603_ = _e340;
                        } else {
                            phi_603_ = _e349;
                        }
                        let _e352 = phi_603_;
                        let _e354 = block_nodes.member[_e352];
                        let _e355 = (_e334 + 3u);
                        if (_e340 < _e355) {
                            phi_619_ = _e340;
                        } else {
                            phi_619_ = _e355;
                        }
                        let _e358 = phi_619_;
                        let _e360 = block_nodes.member[_e358];
                        if (_e342.member[0] < _e348.member[0]) {
                            phi_636_ = _e342.member[0];
                        } else {
                            phi_636_ = _e348.member[0];
                        }
                        let _e367 = phi_636_;
                        if (_e342.member[1] < _e348.member[1]) {
                            phi_643_ = _e342.member[1];
                        } else {
                            phi_643_ = _e348.member[1];
                        }
                        let _e374 = phi_643_;
                        if (_e342.member[2] < _e348.member[2]) {
                            phi_650_ = _e342.member[2];
                        } else {
                            phi_650_ = _e348.member[2];
                        }
                        let _e381 = phi_650_;
                        if (_e342.member_1[0] > _e348.member_1[0]) {
                            phi_657_ = _e342.member_1[0];
                        } else {
                            phi_657_ = _e348.member_1[0];
                        }
                        let _e388 = phi_657_;
                        if (_e342.member_1[1] > _e348.member_1[1]) {
                            phi_664_ = _e342.member_1[1];
                        } else {
                            phi_664_ = _e348.member_1[1];
                        }
                        let _e395 = phi_664_;
                        if (_e342.member_1[2] > _e348.member_1[2]) {
                            phi_671_ = _e342.member_1[2];
                        } else {
                            phi_671_ = _e348.member_1[2];
                        }
                        let _e402 = phi_671_;
                        if (_e354.member[0] < _e360.member[0]) {
                            phi_678_ = _e354.member[0];
                        } else {
                            phi_678_ = _e360.member[0];
                        }
                        let _e409 = phi_678_;
                        if (_e354.member[1] < _e360.member[1]) {
                            phi_685_ = _e354.member[1];
                        } else {
                            phi_685_ = _e360.member[1];
                        }
                        let _e416 = phi_685_;
                        if (_e354.member[2] < _e360.member[2]) {
                            phi_692_ = _e354.member[2];
                        } else {
                            phi_692_ = _e360.member[2];
                        }
                        let _e423 = phi_692_;
                        if (_e354.member_1[0] > _e360.member_1[0]) {
                            phi_699_ = _e354.member_1[0];
                        } else {
                            phi_699_ = _e360.member_1[0];
                        }
                        let _e430 = phi_699_;
                        if (_e354.member_1[1] > _e360.member_1[1]) {
                            phi_706_ = _e354.member_1[1];
                        } else {
                            phi_706_ = _e360.member_1[1];
                        }
                        let _e437 = phi_706_;
                        if (_e354.member_1[2] > _e360.member_1[2]) {
                            phi_713_ = _e354.member_1[2];
                        } else {
                            phi_713_ = _e360.member_1[2];
                        }
                        let _e444 = phi_713_;
                        if (_e367 < _e409) {
                            phi_718_ = _e367;
                        } else {
                            phi_718_ = _e409;
                        }
                        let _e447 = phi_718_;
                        if (_e374 < _e416) {
                            phi_723_ = _e374;
                        } else {
                            phi_723_ = _e416;
                        }
                        let _e450 = phi_723_;
                        if (_e381 < _e423) {
                            phi_728_ = _e381;
                        } else {
                            phi_728_ = _e423;
                        }
                        let _e453 = phi_728_;
                        if (_e388 > _e430) {
                            phi_733_ = _e388;
                        } else {
                            phi_733_ = _e430;
                        }
                        let _e456 = phi_733_;
                        if (_e395 > _e437) {
                            phi_738_ = _e395;
                        } else {
                            phi_738_ = _e437;
                        }
                        let _e459 = phi_738_;
                        if (_e402 > _e444) {
                            phi_743_ = _e402;
                        } else {
                            phi_743_ = _e444;
                        }
                        let _e462 = phi_743_;
                        if (_e309.member[0] < _e447) {
                            phi_749_ = _e309.member[0];
                        } else {
                            phi_749_ = _e447;
                        }
                        let _e467 = phi_749_;
                        if (_e309.member[1] < _e450) {
                            phi_755_ = _e309.member[1];
                        } else {
                            phi_755_ = _e450;
                        }
                        let _e472 = phi_755_;
                        if (_e309.member[2] < _e453) {
                            phi_761_ = _e309.member[2];
                        } else {
                            phi_761_ = _e453;
                        }
                        let _e477 = phi_761_;
                        if (_e309.member_1[0] > _e456) {
                            phi_768_ = _e309.member_1[0];
                        } else {
                            phi_768_ = _e456;
                        }
                        let _e483 = phi_768_;
                        if (_e309.member_1[1] > _e459) {
                            phi_774_ = _e309.member_1[1];
                        } else {
                            phi_774_ = _e459;
                        }
                        let _e488 = phi_774_;
                        if (_e309.member_1[2] > _e462) {
                            phi_780_ = _e309.member_1[2];
                        } else {
                            phi_780_ = _e462;
                        }
                        let _e493 = phi_780_;
                        phi_511_ = type_20(array<f32, 3>(_e467, _e472, _e477), array<f32, 3>(_e483, _e488, _e493));
                    } else {
                        phi_511_ = type_20();
                    }
                    let _e497 = phi_511_;
                    continue;
                    continuing {
                        phi_507_ = _e321;
                        phi_510_ = _e497;
                        break if !(_e327);
                    }
                }
                if _e92 {
                    phi_787_ = (_e84 / 32u);
                } else {
                    phi_787_ = 0u;
                }
                let _e501 = phi_787_;
                if _e92 {
                    phi_792_ = (_e86 / 32u);
                } else {
                    phi_792_ = 0u;
                }
                let _e504 = phi_792_;
                let _e622 = local_3;
                phi_132_ = _e622;
                phi_134_ = _e504;
                phi_136_ = _e501;
            } else {
                phi_132_ = type_20();
                phi_134_ = u32();
                phi_136_ = u32();
            }
            let _e506 = phi_132_;
            let _e508 = phi_134_;
            let _e510 = phi_136_;
            continue;
            continuing {
                phi_128_ = _e72;
                phi_131_ = _e506;
                phi_133_ = _e508;
                phi_135_ = _e510;
                break if !(_e78);
            }
        }
        let _e513 = local;
        let _e517 = local_1;
        nodes.member[_e37] = type_25(_e513.member, _e48.member, _e517.member_1, _e48.member_1);
    }
    if (_e37 < _e44) {
        let _e527 = params.member.member_2.member[0u][_e40];
        let _e528 = (_e527 + _e37);
        let _e530 = block_nodes.member[_e528];
        let _e535 = leaves.member[_e528];
        nodes.member[((_e44 - 1u) + _e37)] = type_25(_e530.member, _e535.member_1, _e530.member_1, 4294967295u);
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn branch_boxes(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}

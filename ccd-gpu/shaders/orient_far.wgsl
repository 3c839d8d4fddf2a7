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
    member: i32,
    member_1: i32,
}

struct type_16 {
    member: u32,
    member_1: i32,
}

struct type_17 {
    member: f32,
    member_1: f32,
}

struct type_19 {
    member: array<array<u32, 4>, 8>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_20 {
    member: type_7,
    member_1: type_8,
    member_2: type_19,
}

struct type_21 {
    member: type_20,
}

struct type_23 {
    member: array<vec4<u32>>,
}

struct type_25 {
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_27 {
    member: array<type_25>,
}

struct type_30 {
    member: vec4<f32>,
    member_1: vec4<f32>,
    member_2: vec4<f32>,
    member_3: vec4<f32>,
}

struct type_32 {
    member: array<type_30>,
}

struct type_34 {
    member: array<f32, 3>,
    member_1: array<array<f32, 3>, 3>,
    member_2: array<f32, 3>,
}

struct type_36 {
    member: array<f32, 2>,
    member_1: array<f32, 3>,
    member_2: array<array<f32, 3>, 3>,
}

struct type_37 {
    member: array<f32, 3>,
    member_1: array<array<f32, 3>, 3>,
}

struct type_40 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_21;
@group(0) @binding(1) 
var<storage> branches: type_23;
@group(0) @binding(2) 
var<storage> block_nodes: type_27;
@group(0) @binding(3) 
var<storage> far: type_11;
@group(0) @binding(4) 
var<storage, read_write> oriented: type_32;
@group(0) @binding(5) 
var<storage, read_write> stamps: type_40;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_177_: type_9;
    var phi_296_: bool;
    var phi_343_: bool;
    var phi_522_: type_34;
    var phi_698_: type_34;
    var phi_836_: f32;
    var phi_837_: bool;
    var phi_1234_: type_15;
    var phi_1237_: f32;
    var phi_1235_: type_15;
    var phi_1278_: type_16;
    var phi_1238_: f32;
    var local: f32;
    var phi_1291_: f32;
    var phi_1303_: type_17;
    var phi_1342_: type_9;
    var phi_1345_: type_36;
    var phi_1428_: type_15;
    var phi_1431_: f32;
    var phi_1429_: type_15;
    var phi_1472_: type_16;
    var phi_1432_: f32;
    var local_1: f32;
    var phi_1485_: f32;
    var phi_1526_: type_15;
    var phi_1529_: f32;
    var phi_1527_: type_15;
    var phi_1570_: type_16;
    var phi_1530_: f32;
    var local_2: f32;
    var phi_1583_: f32;
    var phi_1595_: type_17;
    var phi_1691_: type_15;
    var phi_1694_: f32;
    var phi_1692_: type_15;
    var phi_1735_: type_16;
    var phi_1695_: f32;
    var local_3: f32;
    var phi_1748_: f32;
    var phi_1760_: type_17;
    var phi_1827_: type_36;
    var phi_1828_: bool;
    var phi_1829_: type_36;
    var phi_1830_: bool;
    var phi_2119_: type_15;
    var phi_2122_: f32;
    var phi_2120_: type_15;
    var phi_2163_: type_16;
    var phi_2123_: f32;
    var local_4: f32;
    var phi_2176_: f32;
    var phi_2217_: type_15;
    var phi_2220_: f32;
    var phi_2218_: type_15;
    var phi_2261_: type_16;
    var phi_2221_: f32;
    var local_5: f32;
    var phi_2274_: f32;
    var phi_2286_: type_17;
    var phi_2348_: type_36;
    var phi_1862_: type_15;
    var phi_1865_: f32;
    var phi_1863_: type_15;
    var phi_1906_: type_16;
    var phi_1866_: f32;
    var local_6: f32;
    var phi_1919_: f32;
    var phi_1960_: type_15;
    var phi_1963_: f32;
    var phi_1961_: type_15;
    var phi_2004_: type_16;
    var phi_1964_: f32;
    var local_7: f32;
    var phi_2017_: f32;
    var phi_2029_: type_17;
    var phi_2349_: type_36;
    var phi_2350_: type_36;
    var phi_1346_: type_36;
    var phi_2359_: type_36;
    var phi_2360_: bool;
    var phi_2361_: bool;
    var local_8: bool;
    var phi_2365_: type_36;
    var phi_2795_: array<array<f32, 3>, 3>;
    var phi_2797_: type_37;
    var phi_2798_: bool;
    var phi_2799_: type_37;
    var phi_2800_: bool;
    var phi_2813_: type_37;
    var phi_4325_: type_34;
    var phi_4326_: bool;
    var phi_4327_: type_34;
    var phi_4328_: bool;
    var phi_4352_: type_34;
    var phi_4384_: bool;
    var phi_4385_: bool;
    var local_9: type_36;
    var local_10: type_36;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e51 = id_2;
    let _e52 = n_2;
    let _e53 = lane_2;
    let _e71 = far.member[0u];
    let _e74 = params.member.member_2.member_1;
    let _e78 = params.member.member.member_2[_e74];
    let _e81 = params.member.member_1.member_1;
    let _e82 = ((_e52.x * _e52.y) * 128u);
    if (_e82 == 0u) {
        return;
    }
    let _e84 = (_e71 / _e82);
    if (_e82 == 0u) {
        return;
    }
    phi_177_ = type_9(0u, select(_e84, (_e84 + 1u), ((_e71 % _e82) > 0u)));
    loop {
        let _e92 = phi_177_;
        let _e95 = (_e92.member < _e92.member_1);
        if (bitcast<i32>(select(0u, 1u, _e95)) != 0i) {
            let _e110 = ((select(type_9().member_1, _e92.member, _e95) * _e82) + ((((_e51.y * _e52.x) + _e51.x) * 128u) + _e53));
            if (_e110 >= _e71) {
                phi_4384_ = false;
            } else {
                let _e114 = far.member[(4u + _e110)];
                let _e115 = (_e78 + _e114);
                let _e117 = atomicLoad((&stamps.member[_e115]));
                if (_e117 == 0u) {
                    let _e120 = branches.member[_e114];
                    let _e125 = params.member.member_2.member_1;
                    let _e130 = params.member.member.member[_e125];
                    if ((_e120.x + 1u) >= _e130) {
                        phi_296_ = true;
                    } else {
                        let _e135 = params.member.member.member_2[_e125];
                        let _e138 = atomicLoad((&stamps.member[(_e135 + _e120.x)]));
                        let _e141 = params.member.member_1.member_1;
                        phi_296_ = select((_e138 < _e141), false, (_e138 == 0u));
                    }
                    let _e146 = phi_296_;
                    if _e146 {
                        let _e149 = params.member.member_2.member_1;
                        let _e154 = params.member.member.member[_e149];
                        if ((_e120.y + 1u) >= _e154) {
                            phi_343_ = true;
                        } else {
                            let _e159 = params.member.member.member_2[_e149];
                            let _e162 = atomicLoad((&stamps.member[(_e159 + _e120.y)]));
                            let _e165 = params.member.member_1.member_1;
                            phi_343_ = select((_e162 < _e165), false, (_e162 == 0u));
                        }
                        let _e170 = phi_343_;
                        if _e170 {
                            let _e173 = params.member.member_2.member_1;
                            let _e178 = params.member.member.member[_e173];
                            if ((_e120.x + 1u) >= _e178) {
                                let _e226 = params.member.member_2.member_1;
                                let _e230 = params.member.member.member[_e226];
                                let _e237 = params.member.member_2.member[0u][_e226];
                                let _e240 = block_nodes.member[(_e237 + (_e120.x - (_e230 - 1u)))];
                                let _e259 = ((_e240.member.x * 0.5f) + (_e240.member_1.y * 0.5f));
                                let _e260 = ((_e240.member.y * 0.5f) + (_e240.member_2.x * 0.5f));
                                let _e261 = ((_e240.member_1.x * 0.5f) + (_e240.member_2.y * 0.5f));
                                let _e263 = select(_e240.member_1.y, _e259, (_e259 < _e240.member_1.y));
                                let _e265 = select(_e240.member_2.x, _e260, (_e260 < _e240.member_2.x));
                                let _e267 = select(_e240.member_2.y, _e261, (_e261 < _e240.member_2.y));
                                let _e269 = select(_e240.member.x, _e263, (_e263 > _e240.member.x));
                                let _e271 = select(_e240.member.y, _e265, (_e265 > _e240.member.y));
                                let _e273 = select(_e240.member_1.x, _e267, (_e267 > _e240.member_1.x));
                                let _e275 = (_e240.member_1.y - _e269);
                                let _e276 = (_e240.member_2.x - _e271);
                                let _e277 = (_e240.member_2.y - _e273);
                                let _e278 = (_e269 - _e240.member.x);
                                let _e279 = (_e271 - _e240.member.y);
                                let _e280 = (_e273 - _e240.member_1.x);
                                let _e288 = (1f + (0.000000059604645f * 4f));
                                let _e292 = (0.000000000000000000000000000000000000011754944f * 8f);
                                phi_522_ = type_34(array<f32, 3>(_e269, _e271, _e273), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((select(_e278, _e275, (_e275 > _e278)) * _e288) + _e292), ((select(_e279, _e276, (_e276 > _e279)) * _e288) + _e292), ((select(_e280, _e277, (_e277 > _e280)) * _e288) + _e292)));
                            } else {
                                let _e183 = params.member.member.member_2[_e173];
                                let _e186 = oriented.member[(_e183 + _e120.x)];
                                phi_522_ = type_34(array<f32, 3>(_e186.member.x, _e186.member.y, _e186.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e186.member.w, _e186.member_1.x, _e186.member_1.y), array<f32, 3>(_e186.member_1.z, _e186.member_1.w, _e186.member_2.x), array<f32, 3>(_e186.member_2.y, _e186.member_2.z, _e186.member_2.w)), array<f32, 3>(_e186.member_3.x, _e186.member_3.y, _e186.member_3.z));
                            }
                            let _e299 = phi_522_;
                            let _e302 = params.member.member_2.member_1;
                            let _e307 = params.member.member.member[_e302];
                            if ((_e120.y + 1u) >= _e307) {
                                let _e355 = params.member.member_2.member_1;
                                let _e359 = params.member.member.member[_e355];
                                let _e366 = params.member.member_2.member[0u][_e355];
                                let _e369 = block_nodes.member[(_e366 + (_e120.y - (_e359 - 1u)))];
                                let _e388 = ((_e369.member.x * 0.5f) + (_e369.member_1.y * 0.5f));
                                let _e389 = ((_e369.member.y * 0.5f) + (_e369.member_2.x * 0.5f));
                                let _e390 = ((_e369.member_1.x * 0.5f) + (_e369.member_2.y * 0.5f));
                                let _e392 = select(_e369.member_1.y, _e388, (_e388 < _e369.member_1.y));
                                let _e394 = select(_e369.member_2.x, _e389, (_e389 < _e369.member_2.x));
                                let _e396 = select(_e369.member_2.y, _e390, (_e390 < _e369.member_2.y));
                                let _e398 = select(_e369.member.x, _e392, (_e392 > _e369.member.x));
                                let _e400 = select(_e369.member.y, _e394, (_e394 > _e369.member.y));
                                let _e402 = select(_e369.member_1.x, _e396, (_e396 > _e369.member_1.x));
                                let _e404 = (_e369.member_1.y - _e398);
                                let _e405 = (_e369.member_2.x - _e400);
                                let _e406 = (_e369.member_2.y - _e402);
                                let _e407 = (_e398 - _e369.member.x);
                                let _e408 = (_e400 - _e369.member.y);
                                let _e409 = (_e402 - _e369.member_1.x);
                                let _e417 = (1f + (0.000000059604645f * 4f));
                                let _e421 = (0.000000000000000000000000000000000000011754944f * 8f);
                                phi_698_ = type_34(array<f32, 3>(_e398, _e400, _e402), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((select(_e407, _e404, (_e404 > _e407)) * _e417) + _e421), ((select(_e408, _e405, (_e405 > _e408)) * _e417) + _e421), ((select(_e409, _e406, (_e406 > _e409)) * _e417) + _e421)));
                            } else {
                                let _e312 = params.member.member.member_2[_e302];
                                let _e315 = oriented.member[(_e312 + _e120.y)];
                                phi_698_ = type_34(array<f32, 3>(_e315.member.x, _e315.member.y, _e315.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e315.member.w, _e315.member_1.x, _e315.member_1.y), array<f32, 3>(_e315.member_1.z, _e315.member_1.w, _e315.member_2.x), array<f32, 3>(_e315.member_2.y, _e315.member_2.z, _e315.member_2.w)), array<f32, 3>(_e315.member_3.x, _e315.member_3.y, _e315.member_3.z));
                            }
                            let _e428 = phi_698_;
                            let _e433 = (_e428.member[0] - _e299.member[0]);
                            let _e436 = (_e428.member[1] - _e299.member[1]);
                            let _e439 = (_e428.member[2] - _e299.member[2]);
                            let _e442 = select(_e433, -(_e433), (_e433 < 0f));
                            let _e445 = select(_e436, -(_e436), (_e436 < 0f));
                            let _e447 = select(_e445, _e442, (_e442 > _e445));
                            let _e450 = select(_e439, -(_e439), (_e439 < 0f));
                            let _e452 = select(_e450, _e447, (_e447 > _e450));
                            let _e457 = select(_e299.member_2[0], -(_e299.member_2[0]), (_e299.member_2[0] < 0f));
                            let _e461 = select(_e299.member_2[1], -(_e299.member_2[1]), (_e299.member_2[1] < 0f));
                            let _e463 = select(_e461, _e457, (_e457 > _e461));
                            let _e467 = select(_e299.member_2[2], -(_e299.member_2[2]), (_e299.member_2[2] < 0f));
                            let _e469 = select(_e467, _e463, (_e463 > _e467));
                            let _e471 = select(_e469, _e452, (_e452 > _e469));
                            let _e476 = select(_e428.member_2[0], -(_e428.member_2[0]), (_e428.member_2[0] < 0f));
                            let _e480 = select(_e428.member_2[1], -(_e428.member_2[1]), (_e428.member_2[1] < 0f));
                            let _e482 = select(_e480, _e476, (_e476 > _e480));
                            let _e486 = select(_e428.member_2[2], -(_e428.member_2[2]), (_e428.member_2[2] < 0f));
                            let _e488 = select(_e486, _e482, (_e482 > _e486));
                            let _e490 = select(_e488, _e471, (_e471 > _e488));
                            if (_e490 > 0.000000000000000000000000000000000000011754944f) {
                                let _e494 = ((bitcast<u32>(_e490) & 2139095040u) != 2139095040u);
                                let _e497 = (2130706432u - (bitcast<u32>(_e490) & 2139095040u));
                                phi_836_ = select(f32(), bitcast<f32>(select(8388608u, _e497, (_e497 > 8388608u))), _e494);
                                phi_837_ = select(true, false, _e494);
                            } else {
                                phi_836_ = f32();
                                phi_837_ = true;
                            }
                            let _e504 = phi_836_;
                            let _e506 = phi_837_;
                            let _e507 = select(_e504, 0f, _e506);
                            let _e508 = (_e433 * _e507);
                            let _e509 = (_e436 * _e507);
                            let _e510 = (_e439 * _e507);
                            let _e511 = (_e508 * 0.5f);
                            let _e512 = (_e509 * 0.5f);
                            let _e530 = (_e299.member_2[0] * _e507);
                            let _e532 = (_e299.member_1[0][0] * _e530);
                            let _e534 = (_e299.member_1[0][1] * _e530);
                            let _e536 = (_e299.member_1[0][2] * _e530);
                            let _e537 = (_e532 * 1f);
                            let _e538 = (_e534 * 1f);
                            let _e556 = (_e299.member_2[1] * _e507);
                            let _e558 = (_e299.member_1[1][0] * _e556);
                            let _e560 = (_e299.member_1[1][1] * _e556);
                            let _e562 = (_e299.member_1[1][2] * _e556);
                            let _e563 = (_e558 * 1f);
                            let _e564 = (_e560 * 1f);
                            let _e582 = (_e299.member_2[2] * _e507);
                            let _e584 = (_e299.member_1[2][0] * _e582);
                            let _e586 = (_e299.member_1[2][1] * _e582);
                            let _e588 = (_e299.member_1[2][2] * _e582);
                            let _e589 = (_e584 * 1f);
                            let _e590 = (_e586 * 1f);
                            let _e608 = (_e428.member_2[0] * _e507);
                            let _e610 = (_e428.member_1[0][0] * _e608);
                            let _e612 = (_e428.member_1[0][1] * _e608);
                            let _e614 = (_e428.member_1[0][2] * _e608);
                            let _e615 = (_e610 * 1f);
                            let _e616 = (_e612 * 1f);
                            let _e634 = (_e428.member_2[1] * _e507);
                            let _e636 = (_e428.member_1[1][0] * _e634);
                            let _e638 = (_e428.member_1[1][1] * _e634);
                            let _e640 = (_e428.member_1[1][2] * _e634);
                            let _e641 = (_e636 * 1f);
                            let _e642 = (_e638 * 1f);
                            let _e660 = (_e428.member_2[2] * _e507);
                            let _e662 = (_e428.member_1[2][0] * _e660);
                            let _e664 = (_e428.member_1[2][1] * _e660);
                            let _e666 = (_e428.member_1[2][2] * _e660);
                            let _e667 = (_e662 * 1f);
                            let _e668 = (_e664 * 1f);
                            let _e673 = (((((((0f + (_e508 * _e511)) + (_e532 * _e537)) + (_e558 * _e563)) + (_e584 * _e589)) + (_e610 * _e615)) + (_e636 * _e641)) + (_e662 * _e667));
                            let _e674 = (((((((0f + (_e509 * _e511)) + (_e534 * _e537)) + (_e560 * _e563)) + (_e586 * _e589)) + (_e612 * _e615)) + (_e638 * _e641)) + (_e664 * _e667));
                            let _e675 = (((((((0f + (_e510 * _e511)) + (_e536 * _e537)) + (_e562 * _e563)) + (_e588 * _e589)) + (_e614 * _e615)) + (_e640 * _e641)) + (_e666 * _e667));
                            let _e677 = (((((((0f + (_e512 * _e509)) + (_e538 * _e534)) + (_e564 * _e560)) + (_e590 * _e586)) + (_e616 * _e612)) + (_e642 * _e638)) + (_e668 * _e664));
                            let _e679 = (((((((0f + (_e512 * _e510)) + (_e538 * _e536)) + (_e564 * _e562)) + (_e590 * _e588)) + (_e616 * _e614)) + (_e642 * _e640)) + (_e668 * _e666));
                            let _e681 = (((((((0f + ((_e510 * 0.5f) * _e510)) + ((_e536 * 1f) * _e536)) + ((_e562 * 1f) * _e562)) + ((_e588 * 1f) * _e588)) + ((_e614 * 1f) * _e614)) + ((_e640 * 1f) * _e640)) + ((_e666 * 1f) * _e666));
                            let _e684 = select(_e673, -(_e673), (_e673 < 0f));
                            let _e687 = select(_e674, -(_e674), (_e674 < 0f));
                            let _e689 = select(_e687, _e684, (_e684 > _e687));
                            let _e692 = select(_e675, -(_e675), (_e675 < 0f));
                            let _e694 = select(_e692, _e689, (_e689 > _e692));
                            let _e697 = select(_e677, -(_e677), (_e677 < 0f));
                            let _e700 = select(_e679, -(_e679), (_e679 < 0f));
                            let _e702 = select(_e700, _e697, (_e697 > _e700));
                            let _e705 = select(_e681, -(_e681), (_e681 < 0f));
                            let _e707 = select(_e705, _e702, (_e702 > _e705));
                            let _e709 = select(_e707, _e694, (_e694 > _e707));
                            if (_e709 > 0.000000000000000000000000000000000000011754944f) {
                                if ((bitcast<u32>(_e709) & 2139095040u) != 2139095040u) {
                                    let _e716 = (2130706432u - (bitcast<u32>(_e709) & 2139095040u));
                                    let _e719 = bitcast<f32>(select(8388608u, _e716, (_e716 > 8388608u)));
                                    let _e721 = (_e674 * _e719);
                                    let _e722 = (_e675 * _e719);
                                    let _e723 = (_e677 * _e719);
                                    let _e724 = (_e679 * _e719);
                                    let _e725 = (_e681 * _e719);
                                    let _e728 = ((_e721 * _e721) + (_e722 * _e722));
                                    if (_e728 > ((0.000000059604645f * 0.000000059604645f) * (0.000000059604645f * 0.000000059604645f))) {
                                        if (_e728 <= 0.000000000000000000000000000000000000011754944f) {
                                            phi_1291_ = select(0f, (0.000000000000000000106433627f * 2f), (_e728 > 0f));
                                        } else {
                                            phi_1234_ = type_15(0i, 5i);
                                            phi_1237_ = bitcast<f32>(((bitcast<u32>(_e728) >> bitcast<u32>(1i)) + 532369198u));
                                            loop {
                                                let _e740 = phi_1234_;
                                                let _e742 = phi_1237_;
                                                local = _e742;
                                                if (_e740.member < _e740.member_1) {
                                                    let _e749 = (_e740.member + 1i);
                                                    phi_1235_ = type_15(select(_e749, type_16().member_1, select(false, true, ((false == (_e749 > _e740.member)) != false))), _e740.member_1);
                                                    phi_1278_ = type_16(1u, _e740.member);
                                                } else {
                                                    phi_1235_ = _e740;
                                                    phi_1278_ = type_16(0u, type_16().member_1);
                                                }
                                                let _e760 = phi_1235_;
                                                let _e762 = phi_1278_;
                                                let _e765 = (bitcast<i32>(_e762.member) != 0i);
                                                if _e765 {
                                                    phi_1238_ = (0.5f * (_e742 + (_e728 / _e742)));
                                                } else {
                                                    phi_1238_ = f32();
                                                }
                                                let _e770 = phi_1238_;
                                                continue;
                                                continuing {
                                                    phi_1234_ = _e760;
                                                    phi_1237_ = _e770;
                                                    break if !(_e765);
                                                }
                                            }
                                            let _e775 = local;
                                            phi_1291_ = (_e775 * (1f + (8f * 0.000000059604645f)));
                                        }
                                        let _e781 = phi_1291_;
                                        let _e782 = (_e721 / _e781);
                                        let _e783 = (_e722 / _e781);
                                        let _e788 = (1.5f - (((_e782 * _e782) + (_e783 * _e783)) * 0.5f));
                                        phi_1303_ = type_17((_e782 * _e788), (_e783 * _e788));
                                    } else {
                                        phi_1303_ = type_17(1f, 0f);
                                    }
                                    let _e793 = phi_1303_;
                                    let _e798 = (((_e793.member * _e793.member_1) * _e724) * 2f);
                                    phi_1342_ = type_9(0u, 16u);
                                    phi_1345_ = type_36(array<f32, 2>(((_e793.member * _e721) + (_e793.member_1 * _e722)), (((_e793.member * _e793.member_1) * (_e723 - _e725)) + (((_e793.member_1 * _e793.member_1) - (_e793.member * _e793.member)) * _e724))), array<f32, 3>((_e673 * _e719), ((((_e793.member * _e793.member) * _e723) + _e798) + ((_e793.member_1 * _e793.member_1) * _e725)), ((((_e793.member_1 * _e793.member_1) * _e723) - _e798) + ((_e793.member * _e793.member) * _e725))), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, _e793.member, _e793.member_1), array<f32, 3>(0f, _e793.member_1, -(_e793.member))));
                                    loop {
                                        let _e830 = phi_1342_;
                                        let _e832 = phi_1345_;
                                        local_10 = _e832;
                                        let _e835 = (_e830.member < _e830.member_1);
                                        if (bitcast<i32>(select(0u, 1u, _e835)) != 0i) {
                                            let _e847 = (0.000000059604645f * 0.5f);
                                            let _e858 = (select(_e832.member[0], -(_e832.member[0]), (_e832.member[0] < 0f)) > _e847);
                                            let _e862 = (select(_e832.member[1], -(_e832.member[1]), (_e832.member[1] < 0f)) > _e847);
                                            if _e858 {
                                                if _e862 {
                                                    let _e865 = ((_e832.member_1[1] - _e832.member_1[0]) / (_e832.member[0] * 2f));
                                                    let _e867 = ((_e865 * _e865) + 1f);
                                                    if (_e867 <= 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1485_ = select(0f, (0.000000000000000000106433627f * 2f), (_e867 > 0f));
                                                    } else {
                                                        phi_1428_ = type_15(0i, 5i);
                                                        phi_1431_ = bitcast<f32>(((bitcast<u32>(_e867) >> bitcast<u32>(1i)) + 532369198u));
                                                        loop {
                                                            let _e875 = phi_1428_;
                                                            let _e877 = phi_1431_;
                                                            local_1 = _e877;
                                                            if (_e875.member < _e875.member_1) {
                                                                let _e884 = (_e875.member + 1i);
                                                                phi_1429_ = type_15(select(_e884, type_16().member_1, select(false, true, ((false == (_e884 > _e875.member)) != false))), _e875.member_1);
                                                                phi_1472_ = type_16(1u, _e875.member);
                                                            } else {
                                                                phi_1429_ = _e875;
                                                                phi_1472_ = type_16(0u, type_16().member_1);
                                                            }
                                                            let _e895 = phi_1429_;
                                                            let _e897 = phi_1472_;
                                                            let _e900 = (bitcast<i32>(_e897.member) != 0i);
                                                            if _e900 {
                                                                phi_1432_ = (0.5f * (_e877 + (_e867 / _e877)));
                                                            } else {
                                                                phi_1432_ = f32();
                                                            }
                                                            let _e905 = phi_1432_;
                                                            continue;
                                                            continuing {
                                                                phi_1428_ = _e895;
                                                                phi_1431_ = _e905;
                                                                break if !(_e900);
                                                            }
                                                        }
                                                        let _e910 = local_1;
                                                        phi_1485_ = (_e910 * (1f + (8f * 0.000000059604645f)));
                                                    }
                                                    let _e916 = phi_1485_;
                                                    let _e923 = (_e832.member_1[2] - (_e832.member_1[0] - (_e832.member[0] / select((_e865 - _e916), (_e865 + _e916), (_e865 > 0f)))));
                                                    let _e926 = ((_e923 * _e923) + (_e832.member[1] * _e832.member[1]));
                                                    if (_e926 > ((0.000000059604645f * 0.000000059604645f) * (0.000000059604645f * 0.000000059604645f))) {
                                                        if (_e926 <= 0.000000000000000000000000000000000000011754944f) {
                                                            phi_1583_ = select(0f, (0.000000000000000000106433627f * 2f), (_e926 > 0f));
                                                        } else {
                                                            phi_1526_ = type_15(0i, 5i);
                                                            phi_1529_ = bitcast<f32>(((bitcast<u32>(_e926) >> bitcast<u32>(1i)) + 532369198u));
                                                            loop {
                                                                let _e938 = phi_1526_;
                                                                let _e940 = phi_1529_;
                                                                local_2 = _e940;
                                                                if (_e938.member < _e938.member_1) {
                                                                    let _e947 = (_e938.member + 1i);
                                                                    phi_1527_ = type_15(select(_e947, type_16().member_1, select(false, true, ((false == (_e947 > _e938.member)) != false))), _e938.member_1);
                                                                    phi_1570_ = type_16(1u, _e938.member);
                                                                } else {
                                                                    phi_1527_ = _e938;
                                                                    phi_1570_ = type_16(0u, type_16().member_1);
                                                                }
                                                                let _e958 = phi_1527_;
                                                                let _e960 = phi_1570_;
                                                                let _e963 = (bitcast<i32>(_e960.member) != 0i);
                                                                if _e963 {
                                                                    phi_1530_ = (0.5f * (_e940 + (_e926 / _e940)));
                                                                } else {
                                                                    phi_1530_ = f32();
                                                                }
                                                                let _e968 = phi_1530_;
                                                                continue;
                                                                continuing {
                                                                    phi_1526_ = _e958;
                                                                    phi_1529_ = _e968;
                                                                    break if !(_e963);
                                                                }
                                                            }
                                                            let _e973 = local_2;
                                                            phi_1583_ = (_e973 * (1f + (8f * 0.000000059604645f)));
                                                        }
                                                        let _e979 = phi_1583_;
                                                        let _e980 = (_e923 / _e979);
                                                        let _e981 = (_e832.member[1] / _e979);
                                                        let _e986 = (1.5f - (((_e980 * _e980) + (_e981 * _e981)) * 0.5f));
                                                        phi_1595_ = type_17((_e980 * _e986), (_e981 * _e986));
                                                    } else {
                                                        phi_1595_ = type_17(1f, 0f);
                                                    }
                                                    let _e991 = phi_1595_;
                                                    let _e1008 = (((_e832.member_1[1] - _e832.member_1[2]) * _e991.member_1) + ((_e991.member * _e832.member[1]) * 2f));
                                                    let _e1010 = (_e832.member_1[1] - (_e991.member_1 * _e1008));
                                                    let _e1014 = ((_e991.member * _e1008) - _e832.member[1]);
                                                    let _e1027 = ((_e832.member_2[1][0] * _e991.member) - (_e832.member_2[2][0] * _e991.member_1));
                                                    let _e1028 = ((_e832.member_2[1][1] * _e991.member) - (_e832.member_2[2][1] * _e991.member_1));
                                                    let _e1029 = ((_e832.member_2[1][2] * _e991.member) - (_e832.member_2[2][2] * _e991.member_1));
                                                    let _e1046 = (_e991.member * _e832.member[0]);
                                                    let _e1047 = (_e991.member_1 * _e832.member[0]);
                                                    let _e1050 = ((_e1014 * _e1014) + (_e1047 * _e1047));
                                                    if (_e1050 > ((0.000000059604645f * 0.000000059604645f) * (0.000000059604645f * 0.000000059604645f))) {
                                                        if (_e1050 <= 0.000000000000000000000000000000000000011754944f) {
                                                            phi_1748_ = select(0f, (0.000000000000000000106433627f * 2f), (_e1050 > 0f));
                                                        } else {
                                                            phi_1691_ = type_15(0i, 5i);
                                                            phi_1694_ = bitcast<f32>(((bitcast<u32>(_e1050) >> bitcast<u32>(1i)) + 532369198u));
                                                            loop {
                                                                let _e1062 = phi_1691_;
                                                                let _e1064 = phi_1694_;
                                                                local_3 = _e1064;
                                                                if (_e1062.member < _e1062.member_1) {
                                                                    let _e1071 = (_e1062.member + 1i);
                                                                    phi_1692_ = type_15(select(_e1071, type_16().member_1, select(false, true, ((false == (_e1071 > _e1062.member)) != false))), _e1062.member_1);
                                                                    phi_1735_ = type_16(1u, _e1062.member);
                                                                } else {
                                                                    phi_1692_ = _e1062;
                                                                    phi_1735_ = type_16(0u, type_16().member_1);
                                                                }
                                                                let _e1082 = phi_1692_;
                                                                let _e1084 = phi_1735_;
                                                                let _e1087 = (bitcast<i32>(_e1084.member) != 0i);
                                                                if _e1087 {
                                                                    phi_1695_ = (0.5f * (_e1064 + (_e1050 / _e1064)));
                                                                } else {
                                                                    phi_1695_ = f32();
                                                                }
                                                                let _e1092 = phi_1695_;
                                                                continue;
                                                                continuing {
                                                                    phi_1691_ = _e1082;
                                                                    phi_1694_ = _e1092;
                                                                    break if !(_e1087);
                                                                }
                                                            }
                                                            let _e1097 = local_3;
                                                            phi_1748_ = (_e1097 * (1f + (8f * 0.000000059604645f)));
                                                        }
                                                        let _e1103 = phi_1748_;
                                                        let _e1104 = (_e1014 / _e1103);
                                                        let _e1105 = (_e1047 / _e1103);
                                                        let _e1110 = (1.5f - (((_e1104 * _e1104) + (_e1105 * _e1105)) * 0.5f));
                                                        phi_1760_ = type_17((_e1104 * _e1110), (_e1105 * _e1110));
                                                    } else {
                                                        phi_1760_ = type_17(1f, 0f);
                                                    }
                                                    let _e1115 = phi_1760_;
                                                    let _e1125 = (((_e832.member_1[0] - _e1010) * _e1115.member_1) + ((_e1115.member * _e1046) * 2f));
                                                    phi_1827_ = type_36(array<f32, 2>(((_e1115.member * _e1125) - _e1046), ((_e1115.member_1 * _e1047) + (_e1115.member * _e1014))), array<f32, 3>((_e832.member_1[0] - (_e1115.member_1 * _e1125)), (_e1010 + (_e1115.member_1 * _e1125)), (_e832.member_1[2] + (_e991.member_1 * _e1008))), array<array<f32, 3>, 3>(array<f32, 3>(((_e832.member_2[0][0] * _e1115.member) - (_e1027 * _e1115.member_1)), ((_e832.member_2[0][1] * _e1115.member) - (_e1028 * _e1115.member_1)), ((_e832.member_2[0][2] * _e1115.member) - (_e1029 * _e1115.member_1))), array<f32, 3>(((_e832.member_2[0][0] * _e1115.member_1) + (_e1027 * _e1115.member)), ((_e832.member_2[0][1] * _e1115.member_1) + (_e1028 * _e1115.member)), ((_e832.member_2[0][2] * _e1115.member_1) + (_e1029 * _e1115.member))), array<f32, 3>(((_e832.member_2[1][0] * _e991.member_1) + (_e832.member_2[2][0] * _e991.member)), ((_e832.member_2[1][1] * _e991.member_1) + (_e832.member_2[2][1] * _e991.member)), ((_e832.member_2[1][2] * _e991.member_1) + (_e832.member_2[2][2] * _e991.member)))));
                                                    phi_1828_ = false;
                                                } else {
                                                    phi_1827_ = type_36();
                                                    phi_1828_ = true;
                                                }
                                                let _e1163 = phi_1827_;
                                                let _e1165 = phi_1828_;
                                                phi_1829_ = _e1163;
                                                phi_1830_ = _e1165;
                                            } else {
                                                phi_1829_ = type_36();
                                                phi_1830_ = true;
                                            }
                                            let _e1167 = phi_1829_;
                                            let _e1169 = phi_1830_;
                                            if _e1169 {
                                                if _e858 {
                                                    let _e1372 = ((_e832.member_1[1] - _e832.member_1[0]) / (_e832.member[0] * 2f));
                                                    let _e1374 = ((_e1372 * _e1372) + 1f);
                                                    if (_e1374 <= 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1919_ = select(0f, (0.000000000000000000106433627f * 2f), (_e1374 > 0f));
                                                    } else {
                                                        phi_1862_ = type_15(0i, 5i);
                                                        phi_1865_ = bitcast<f32>(((bitcast<u32>(_e1374) >> bitcast<u32>(1i)) + 532369198u));
                                                        loop {
                                                            let _e1382 = phi_1862_;
                                                            let _e1384 = phi_1865_;
                                                            local_6 = _e1384;
                                                            if (_e1382.member < _e1382.member_1) {
                                                                let _e1391 = (_e1382.member + 1i);
                                                                phi_1863_ = type_15(select(_e1391, type_16().member_1, select(false, true, ((false == (_e1391 > _e1382.member)) != false))), _e1382.member_1);
                                                                phi_1906_ = type_16(1u, _e1382.member);
                                                            } else {
                                                                phi_1863_ = _e1382;
                                                                phi_1906_ = type_16(0u, type_16().member_1);
                                                            }
                                                            let _e1402 = phi_1863_;
                                                            let _e1404 = phi_1906_;
                                                            let _e1407 = (bitcast<i32>(_e1404.member) != 0i);
                                                            if _e1407 {
                                                                phi_1866_ = (0.5f * (_e1384 + (_e1374 / _e1384)));
                                                            } else {
                                                                phi_1866_ = f32();
                                                            }
                                                            let _e1412 = phi_1866_;
                                                            continue;
                                                            continuing {
                                                                phi_1862_ = _e1402;
                                                                phi_1865_ = _e1412;
                                                                break if !(_e1407);
                                                            }
                                                        }
                                                        let _e1417 = local_6;
                                                        phi_1919_ = (_e1417 * (1f + (8f * 0.000000059604645f)));
                                                    }
                                                    let _e1423 = phi_1919_;
                                                    let _e1430 = (_e832.member_1[1] - (_e832.member_1[0] - (_e832.member[0] / select((_e1372 - _e1423), (_e1372 + _e1423), (_e1372 > 0f)))));
                                                    let _e1433 = ((_e1430 * _e1430) + (_e832.member[0] * _e832.member[0]));
                                                    if (_e1433 > ((0.000000059604645f * 0.000000059604645f) * (0.000000059604645f * 0.000000059604645f))) {
                                                        if (_e1433 <= 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2017_ = select(0f, (0.000000000000000000106433627f * 2f), (_e1433 > 0f));
                                                        } else {
                                                            phi_1960_ = type_15(0i, 5i);
                                                            phi_1963_ = bitcast<f32>(((bitcast<u32>(_e1433) >> bitcast<u32>(1i)) + 532369198u));
                                                            loop {
                                                                let _e1445 = phi_1960_;
                                                                let _e1447 = phi_1963_;
                                                                local_7 = _e1447;
                                                                if (_e1445.member < _e1445.member_1) {
                                                                    let _e1454 = (_e1445.member + 1i);
                                                                    phi_1961_ = type_15(select(_e1454, type_16().member_1, select(false, true, ((false == (_e1454 > _e1445.member)) != false))), _e1445.member_1);
                                                                    phi_2004_ = type_16(1u, _e1445.member);
                                                                } else {
                                                                    phi_1961_ = _e1445;
                                                                    phi_2004_ = type_16(0u, type_16().member_1);
                                                                }
                                                                let _e1465 = phi_1961_;
                                                                let _e1467 = phi_2004_;
                                                                let _e1470 = (bitcast<i32>(_e1467.member) != 0i);
                                                                if _e1470 {
                                                                    phi_1964_ = (0.5f * (_e1447 + (_e1433 / _e1447)));
                                                                } else {
                                                                    phi_1964_ = f32();
                                                                }
                                                                let _e1475 = phi_1964_;
                                                                continue;
                                                                continuing {
                                                                    phi_1960_ = _e1465;
                                                                    phi_1963_ = _e1475;
                                                                    break if !(_e1470);
                                                                }
                                                            }
                                                            let _e1480 = local_7;
                                                            phi_2017_ = (_e1480 * (1f + (8f * 0.000000059604645f)));
                                                        }
                                                        let _e1486 = phi_2017_;
                                                        let _e1487 = (_e1430 / _e1486);
                                                        let _e1488 = (_e832.member[0] / _e1486);
                                                        let _e1493 = (1.5f - (((_e1487 * _e1487) + (_e1488 * _e1488)) * 0.5f));
                                                        phi_2029_ = type_17((_e1487 * _e1493), (_e1488 * _e1493));
                                                    } else {
                                                        phi_2029_ = type_17(1f, 0f);
                                                    }
                                                    let _e1498 = phi_2029_;
                                                    let _e1515 = (((_e832.member_1[0] - _e832.member_1[1]) * _e1498.member_1) + ((_e1498.member * _e832.member[0]) * 2f));
                                                    let _e1525 = type_36(_e832.member, array<f32, 3>((_e832.member_1[0] - (_e1498.member_1 * _e1515)), (_e832.member_1[1] + (_e1498.member_1 * _e1515)), _e832.member_1[2]), _e832.member_2);
                                                    let _e1531 = type_36(array<f32, 2>(((_e1498.member * _e1515) - _e832.member[0]), _e1525.member[1]), _e1525.member_1, _e1525.member_2);
                                                    phi_2349_ = type_36(_e1531.member, _e1531.member_1, array<array<f32, 3>, 3>(array<f32, 3>(((_e832.member_2[0][0] * _e1498.member) - (_e832.member_2[1][0] * _e1498.member_1)), ((_e832.member_2[0][1] * _e1498.member) - (_e832.member_2[1][1] * _e1498.member_1)), ((_e832.member_2[0][2] * _e1498.member) - (_e832.member_2[1][2] * _e1498.member_1))), array<f32, 3>(((_e832.member_2[0][0] * _e1498.member_1) + (_e832.member_2[1][0] * _e1498.member)), ((_e832.member_2[0][1] * _e1498.member_1) + (_e832.member_2[1][1] * _e1498.member)), ((_e832.member_2[0][2] * _e1498.member_1) + (_e832.member_2[1][2] * _e1498.member))), _e832.member_2[2]));
                                                } else {
                                                    if _e862 {
                                                        let _e1172 = ((_e832.member_1[2] - _e832.member_1[1]) / (_e832.member[1] * 2f));
                                                        let _e1174 = ((_e1172 * _e1172) + 1f);
                                                        if (_e1174 <= 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2176_ = select(0f, (0.000000000000000000106433627f * 2f), (_e1174 > 0f));
                                                        } else {
                                                            phi_2119_ = type_15(0i, 5i);
                                                            phi_2122_ = bitcast<f32>(((bitcast<u32>(_e1174) >> bitcast<u32>(1i)) + 532369198u));
                                                            loop {
                                                                let _e1182 = phi_2119_;
                                                                let _e1184 = phi_2122_;
                                                                local_4 = _e1184;
                                                                if (_e1182.member < _e1182.member_1) {
                                                                    let _e1191 = (_e1182.member + 1i);
                                                                    phi_2120_ = type_15(select(_e1191, type_16().member_1, select(false, true, ((false == (_e1191 > _e1182.member)) != false))), _e1182.member_1);
                                                                    phi_2163_ = type_16(1u, _e1182.member);
                                                                } else {
                                                                    phi_2120_ = _e1182;
                                                                    phi_2163_ = type_16(0u, type_16().member_1);
                                                                }
                                                                let _e1202 = phi_2120_;
                                                                let _e1204 = phi_2163_;
                                                                let _e1207 = (bitcast<i32>(_e1204.member) != 0i);
                                                                if _e1207 {
                                                                    phi_2123_ = (0.5f * (_e1184 + (_e1174 / _e1184)));
                                                                } else {
                                                                    phi_2123_ = f32();
                                                                }
                                                                let _e1212 = phi_2123_;
                                                                continue;
                                                                continuing {
                                                                    phi_2119_ = _e1202;
                                                                    phi_2122_ = _e1212;
                                                                    break if !(_e1207);
                                                                }
                                                            }
                                                            let _e1217 = local_4;
                                                            phi_2176_ = (_e1217 * (1f + (8f * 0.000000059604645f)));
                                                        }
                                                        let _e1223 = phi_2176_;
                                                        let _e1230 = (_e832.member_1[2] - (_e832.member_1[1] - (_e832.member[1] / select((_e1172 - _e1223), (_e1172 + _e1223), (_e1172 > 0f)))));
                                                        let _e1233 = ((_e1230 * _e1230) + (_e832.member[1] * _e832.member[1]));
                                                        if (_e1233 > ((0.000000059604645f * 0.000000059604645f) * (0.000000059604645f * 0.000000059604645f))) {
                                                            if (_e1233 <= 0.000000000000000000000000000000000000011754944f) {
                                                                phi_2274_ = select(0f, (0.000000000000000000106433627f * 2f), (_e1233 > 0f));
                                                            } else {
                                                                phi_2217_ = type_15(0i, 5i);
                                                                phi_2220_ = bitcast<f32>(((bitcast<u32>(_e1233) >> bitcast<u32>(1i)) + 532369198u));
                                                                loop {
                                                                    let _e1245 = phi_2217_;
                                                                    let _e1247 = phi_2220_;
                                                                    local_5 = _e1247;
                                                                    if (_e1245.member < _e1245.member_1) {
                                                                        let _e1254 = (_e1245.member + 1i);
                                                                        phi_2218_ = type_15(select(_e1254, type_16().member_1, select(false, true, ((false == (_e1254 > _e1245.member)) != false))), _e1245.member_1);
                                                                        phi_2261_ = type_16(1u, _e1245.member);
                                                                    } else {
                                                                        phi_2218_ = _e1245;
                                                                        phi_2261_ = type_16(0u, type_16().member_1);
                                                                    }
                                                                    let _e1265 = phi_2218_;
                                                                    let _e1267 = phi_2261_;
                                                                    let _e1270 = (bitcast<i32>(_e1267.member) != 0i);
                                                                    if _e1270 {
                                                                        phi_2221_ = (0.5f * (_e1247 + (_e1233 / _e1247)));
                                                                    } else {
                                                                        phi_2221_ = f32();
                                                                    }
                                                                    let _e1275 = phi_2221_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_2217_ = _e1265;
                                                                        phi_2220_ = _e1275;
                                                                        break if !(_e1270);
                                                                    }
                                                                }
                                                                let _e1280 = local_5;
                                                                phi_2274_ = (_e1280 * (1f + (8f * 0.000000059604645f)));
                                                            }
                                                            let _e1286 = phi_2274_;
                                                            let _e1287 = (_e1230 / _e1286);
                                                            let _e1288 = (_e832.member[1] / _e1286);
                                                            let _e1293 = (1.5f - (((_e1287 * _e1287) + (_e1288 * _e1288)) * 0.5f));
                                                            phi_2286_ = type_17((_e1287 * _e1293), (_e1288 * _e1293));
                                                        } else {
                                                            phi_2286_ = type_17(1f, 0f);
                                                        }
                                                        let _e1298 = phi_2286_;
                                                        let _e1315 = (((_e832.member_1[1] - _e832.member_1[2]) * _e1298.member_1) + ((_e1298.member * _e832.member[1]) * 2f));
                                                        let _e1325 = type_36(_e832.member, array<f32, 3>(_e832.member_1[0], (_e832.member_1[1] - (_e1298.member_1 * _e1315)), (_e832.member_1[2] + (_e1298.member_1 * _e1315))), _e832.member_2);
                                                        let _e1331 = type_36(array<f32, 2>(_e1325.member[0], ((_e1298.member * _e1315) - _e832.member[1])), _e1325.member_1, _e1325.member_2);
                                                        phi_2348_ = type_36(_e1331.member, _e1331.member_1, array<array<f32, 3>, 3>(_e832.member_2[0], array<f32, 3>(((_e832.member_2[1][0] * _e1298.member) - (_e832.member_2[2][0] * _e1298.member_1)), ((_e832.member_2[1][1] * _e1298.member) - (_e832.member_2[2][1] * _e1298.member_1)), ((_e832.member_2[1][2] * _e1298.member) - (_e832.member_2[2][2] * _e1298.member_1))), array<f32, 3>(((_e832.member_2[1][0] * _e1298.member_1) + (_e832.member_2[2][0] * _e1298.member)), ((_e832.member_2[1][1] * _e1298.member_1) + (_e832.member_2[2][1] * _e1298.member)), ((_e832.member_2[1][2] * _e1298.member_1) + (_e832.member_2[2][2] * _e1298.member)))));
                                                    } else {
                                                        phi_2348_ = _e832;
                                                    }
                                                    let _e1369 = phi_2348_;
                                                    phi_2349_ = _e1369;
                                                }
                                                let _e1569 = phi_2349_;
                                                phi_2350_ = _e1569;
                                            } else {
                                                phi_2350_ = _e1167;
                                            }
                                            let _e1571 = phi_2350_;
                                            let _e1572 = select(_e862, true, _e858);
                                            phi_1346_ = _e1571;
                                            phi_2359_ = _e1571;
                                            phi_2360_ = _e1572;
                                            phi_2361_ = select(true, false, _e1572);
                                        } else {
                                            phi_1346_ = type_36();
                                            phi_2359_ = type_36();
                                            phi_2360_ = false;
                                            phi_2361_ = false;
                                        }
                                        let _e1575 = phi_1346_;
                                        let _e1577 = phi_2359_;
                                        let _e1579 = phi_2360_;
                                        let _e1581 = phi_2361_;
                                        local_8 = _e1581;
                                        local_9 = _e1577;
                                        continue;
                                        continuing {
                                            phi_1342_ = type_9(select(_e830.member, (_e830.member + 1u), _e835), select(_e830.member_1, _e830.member_1, _e835));
                                            phi_1345_ = _e1575;
                                            break if !(_e1579);
                                        }
                                    }
                                    let _e1584 = local_8;
                                    if _e1584 {
                                        let _e3279 = local_9;
                                        phi_2365_ = _e3279;
                                    } else {
                                        let _e3281 = local_10;
                                        phi_2365_ = _e3281;
                                    }
                                    let _e1586 = phi_2365_;
                                    let _e1590 = (2130706432u - (bitcast<u32>(_e719) & 2139095040u));
                                    let _e1593 = bitcast<f32>(select(8388608u, _e1590, (_e1590 > 8388608u)));
                                    let _e1615 = ((((_e1586.member_2[0][0] * _e1586.member_2[0][0]) + (_e1586.member_2[0][1] * _e1586.member_2[0][1])) + (_e1586.member_2[0][2] * _e1586.member_2[0][2])) - 1f);
                                    let _e1629 = ((((_e1586.member_2[1][0] * _e1586.member_2[1][0]) + (_e1586.member_2[1][1] * _e1586.member_2[1][1])) + (_e1586.member_2[1][2] * _e1586.member_2[1][2])) - 1f);
                                    let _e1643 = ((((_e1586.member_2[2][0] * _e1586.member_2[2][0]) + (_e1586.member_2[2][1] * _e1586.member_2[2][1])) + (_e1586.member_2[2][2] * _e1586.member_2[2][2])) - 1f);
                                    let _e1656 = (((_e1586.member_2[0][0] * _e1586.member_2[1][0]) + (_e1586.member_2[0][1] * _e1586.member_2[1][1])) + (_e1586.member_2[0][2] * _e1586.member_2[1][2]));
                                    let _e1669 = (((_e1586.member_2[0][0] * _e1586.member_2[2][0]) + (_e1586.member_2[0][1] * _e1586.member_2[2][1])) + (_e1586.member_2[0][2] * _e1586.member_2[2][2]));
                                    let _e1682 = (((_e1586.member_2[1][0] * _e1586.member_2[2][0]) + (_e1586.member_2[1][1] * _e1586.member_2[2][1])) + (_e1586.member_2[1][2] * _e1586.member_2[2][2]));
                                    let _e1715 = (_e1586.member_2[0][0] - ((((_e1586.member_2[0][0] * _e1615) + (_e1586.member_2[1][0] * _e1656)) + (_e1586.member_2[2][0] * _e1669)) * 0.5f));
                                    let _e1717 = (_e1586.member_2[0][1] - ((((_e1586.member_2[0][1] * _e1615) + (_e1586.member_2[1][1] * _e1656)) + (_e1586.member_2[2][1] * _e1669)) * 0.5f));
                                    let _e1719 = (_e1586.member_2[0][2] - ((((_e1586.member_2[0][2] * _e1615) + (_e1586.member_2[1][2] * _e1656)) + (_e1586.member_2[2][2] * _e1669)) * 0.5f));
                                    let _e1725 = select(0f, _e1715, (select(_e1715, -(_e1715), (_e1715 < 0f)) > (0.000000059604645f * 0.000000059604645f)));
                                    let _e1731 = select(0f, _e1717, (select(_e1717, -(_e1717), (_e1717 < 0f)) > (0.000000059604645f * 0.000000059604645f)));
                                    let _e1737 = select(0f, _e1719, (select(_e1719, -(_e1719), (_e1719 < 0f)) > (0.000000059604645f * 0.000000059604645f)));
                                    let _e1771 = (_e1586.member_2[1][0] - ((((_e1586.member_2[0][0] * _e1656) + (_e1586.member_2[1][0] * _e1629)) + (_e1586.member_2[2][0] * _e1682)) * 0.5f));
                                    let _e1773 = (_e1586.member_2[1][1] - ((((_e1586.member_2[0][1] * _e1656) + (_e1586.member_2[1][1] * _e1629)) + (_e1586.member_2[2][1] * _e1682)) * 0.5f));
                                    let _e1775 = (_e1586.member_2[1][2] - ((((_e1586.member_2[0][2] * _e1656) + (_e1586.member_2[1][2] * _e1629)) + (_e1586.member_2[2][2] * _e1682)) * 0.5f));
                                    let _e1781 = select(0f, _e1771, (select(_e1771, -(_e1771), (_e1771 < 0f)) > (0.000000059604645f * 0.000000059604645f)));
                                    let _e1787 = select(0f, _e1773, (select(_e1773, -(_e1773), (_e1773 < 0f)) > (0.000000059604645f * 0.000000059604645f)));
                                    let _e1793 = select(0f, _e1775, (select(_e1775, -(_e1775), (_e1775 < 0f)) > (0.000000059604645f * 0.000000059604645f)));
                                    let _e1827 = (_e1586.member_2[2][0] - ((((_e1586.member_2[0][0] * _e1669) + (_e1586.member_2[1][0] * _e1682)) + (_e1586.member_2[2][0] * _e1643)) * 0.5f));
                                    let _e1829 = (_e1586.member_2[2][1] - ((((_e1586.member_2[0][1] * _e1669) + (_e1586.member_2[1][1] * _e1682)) + (_e1586.member_2[2][1] * _e1643)) * 0.5f));
                                    let _e1831 = (_e1586.member_2[2][2] - ((((_e1586.member_2[0][2] * _e1669) + (_e1586.member_2[1][2] * _e1682)) + (_e1586.member_2[2][2] * _e1643)) * 0.5f));
                                    let _e1837 = select(0f, _e1827, (select(_e1827, -(_e1827), (_e1827 < 0f)) > (0.000000059604645f * 0.000000059604645f)));
                                    let _e1843 = select(0f, _e1829, (select(_e1829, -(_e1829), (_e1829 < 0f)) > (0.000000059604645f * 0.000000059604645f)));
                                    let _e1849 = select(0f, _e1831, (select(_e1831, -(_e1831), (_e1831 < 0f)) > (0.000000059604645f * 0.000000059604645f)));
                                    let _e1857 = ((((_e1725 * _e1725) + (_e1731 * _e1731)) + (_e1737 * _e1737)) - 1f);
                                    let _e1863 = ((((_e1781 * _e1781) + (_e1787 * _e1787)) + (_e1793 * _e1793)) - 1f);
                                    let _e1869 = ((((_e1837 * _e1837) + (_e1843 * _e1843)) + (_e1849 * _e1849)) - 1f);
                                    let _e1874 = (((_e1725 * _e1781) + (_e1731 * _e1787)) + (_e1737 * _e1793));
                                    let _e1879 = (((_e1725 * _e1837) + (_e1731 * _e1843)) + (_e1737 * _e1849));
                                    let _e1884 = (((_e1781 * _e1837) + (_e1787 * _e1843)) + (_e1793 * _e1849));
                                    let _e1887 = select(_e1857, -(_e1857), (_e1857 < 0f));
                                    let _e1890 = select(_e1863, -(_e1863), (_e1863 < 0f));
                                    let _e1892 = select(_e1890, _e1887, (_e1887 > _e1890));
                                    let _e1895 = select(_e1869, -(_e1869), (_e1869 < 0f));
                                    let _e1897 = select(_e1895, _e1892, (_e1892 > _e1895));
                                    let _e1900 = select(_e1874, -(_e1874), (_e1874 < 0f));
                                    let _e1903 = select(_e1879, -(_e1879), (_e1879 < 0f));
                                    let _e1905 = select(_e1903, _e1900, (_e1900 > _e1903));
                                    let _e1908 = select(_e1884, -(_e1884), (_e1884 < 0f));
                                    let _e1910 = select(_e1908, _e1905, (_e1905 > _e1908));
                                    if (select(_e1910, _e1897, (_e1897 > _e1910)) <= (0.000000059604645f * (16f - 6f))) {
                                        phi_2795_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1725, _e1731, _e1737), array<f32, 3>(_e1781, _e1787, _e1793), array<f32, 3>(_e1837, _e1843, _e1849));
                                    } else {
                                        phi_2795_ = array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f));
                                    }
                                    let _e1917 = phi_2795_;
                                    phi_2797_ = type_37(array<f32, 3>((_e1586.member_1[0] * _e1593), (_e1586.member_1[1] * _e1593), (_e1586.member_1[2] * _e1593)), _e1917);
                                    phi_2798_ = false;
                                } else {
                                    phi_2797_ = type_37();
                                    phi_2798_ = true;
                                }
                                let _e1920 = phi_2797_;
                                let _e1922 = phi_2798_;
                                phi_2799_ = _e1920;
                                phi_2800_ = _e1922;
                            } else {
                                phi_2799_ = type_37();
                                phi_2800_ = true;
                            }
                            let _e1924 = phi_2799_;
                            let _e1926 = phi_2800_;
                            if _e1926 {
                                phi_2813_ = type_37(array<f32, 3>(_e673, _e677, _e681), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)));
                            } else {
                                phi_2813_ = _e1924;
                            }
                            let _e1930 = phi_2813_;
                            let _e1945 = (((_e299.member_1[0][0] * _e1930.member_1[0][0]) + (_e299.member_1[0][1] * _e1930.member_1[0][1])) + (_e299.member_1[0][2] * _e1930.member_1[0][2]));
                            let _e1958 = (((_e299.member_1[1][0] * _e1930.member_1[0][0]) + (_e299.member_1[1][1] * _e1930.member_1[0][1])) + (_e299.member_1[1][2] * _e1930.member_1[0][2]));
                            let _e1971 = (((_e299.member_1[2][0] * _e1930.member_1[0][0]) + (_e299.member_1[2][1] * _e1930.member_1[0][1])) + (_e299.member_1[2][2] * _e1930.member_1[0][2]));
                            let _e1989 = (((select(_e1945, -(_e1945), (_e1945 < 0f)) * _e299.member_2[0]) + (select(_e1958, -(_e1958), (_e1958 < 0f)) * _e299.member_2[1])) + (select(_e1971, -(_e1971), (_e1971 < 0f)) * _e299.member_2[2]));
                            let _e2003 = (((_e299.member_1[0][0] * _e1930.member_1[1][0]) + (_e299.member_1[0][1] * _e1930.member_1[1][1])) + (_e299.member_1[0][2] * _e1930.member_1[1][2]));
                            let _e2016 = (((_e299.member_1[1][0] * _e1930.member_1[1][0]) + (_e299.member_1[1][1] * _e1930.member_1[1][1])) + (_e299.member_1[1][2] * _e1930.member_1[1][2]));
                            let _e2029 = (((_e299.member_1[2][0] * _e1930.member_1[1][0]) + (_e299.member_1[2][1] * _e1930.member_1[1][1])) + (_e299.member_1[2][2] * _e1930.member_1[1][2]));
                            let _e2047 = (((select(_e2003, -(_e2003), (_e2003 < 0f)) * _e299.member_2[0]) + (select(_e2016, -(_e2016), (_e2016 < 0f)) * _e299.member_2[1])) + (select(_e2029, -(_e2029), (_e2029 < 0f)) * _e299.member_2[2]));
                            let _e2061 = (((_e299.member_1[0][0] * _e1930.member_1[2][0]) + (_e299.member_1[0][1] * _e1930.member_1[2][1])) + (_e299.member_1[0][2] * _e1930.member_1[2][2]));
                            let _e2074 = (((_e299.member_1[1][0] * _e1930.member_1[2][0]) + (_e299.member_1[1][1] * _e1930.member_1[2][1])) + (_e299.member_1[1][2] * _e1930.member_1[2][2]));
                            let _e2087 = (((_e299.member_1[2][0] * _e1930.member_1[2][0]) + (_e299.member_1[2][1] * _e1930.member_1[2][1])) + (_e299.member_1[2][2] * _e1930.member_1[2][2]));
                            let _e2105 = (((select(_e2061, -(_e2061), (_e2061 < 0f)) * _e299.member_2[0]) + (select(_e2074, -(_e2074), (_e2074 < 0f)) * _e299.member_2[1])) + (select(_e2087, -(_e2087), (_e2087 < 0f)) * _e299.member_2[2]));
                            let _e2119 = (((_e428.member_1[0][0] * _e1930.member_1[0][0]) + (_e428.member_1[0][1] * _e1930.member_1[0][1])) + (_e428.member_1[0][2] * _e1930.member_1[0][2]));
                            let _e2132 = (((_e428.member_1[1][0] * _e1930.member_1[0][0]) + (_e428.member_1[1][1] * _e1930.member_1[0][1])) + (_e428.member_1[1][2] * _e1930.member_1[0][2]));
                            let _e2145 = (((_e428.member_1[2][0] * _e1930.member_1[0][0]) + (_e428.member_1[2][1] * _e1930.member_1[0][1])) + (_e428.member_1[2][2] * _e1930.member_1[0][2]));
                            let _e2163 = (((select(_e2119, -(_e2119), (_e2119 < 0f)) * _e428.member_2[0]) + (select(_e2132, -(_e2132), (_e2132 < 0f)) * _e428.member_2[1])) + (select(_e2145, -(_e2145), (_e2145 < 0f)) * _e428.member_2[2]));
                            let _e2177 = (((_e428.member_1[0][0] * _e1930.member_1[1][0]) + (_e428.member_1[0][1] * _e1930.member_1[1][1])) + (_e428.member_1[0][2] * _e1930.member_1[1][2]));
                            let _e2190 = (((_e428.member_1[1][0] * _e1930.member_1[1][0]) + (_e428.member_1[1][1] * _e1930.member_1[1][1])) + (_e428.member_1[1][2] * _e1930.member_1[1][2]));
                            let _e2203 = (((_e428.member_1[2][0] * _e1930.member_1[1][0]) + (_e428.member_1[2][1] * _e1930.member_1[1][1])) + (_e428.member_1[2][2] * _e1930.member_1[1][2]));
                            let _e2221 = (((select(_e2177, -(_e2177), (_e2177 < 0f)) * _e428.member_2[0]) + (select(_e2190, -(_e2190), (_e2190 < 0f)) * _e428.member_2[1])) + (select(_e2203, -(_e2203), (_e2203 < 0f)) * _e428.member_2[2]));
                            let _e2235 = (((_e428.member_1[0][0] * _e1930.member_1[2][0]) + (_e428.member_1[0][1] * _e1930.member_1[2][1])) + (_e428.member_1[0][2] * _e1930.member_1[2][2]));
                            let _e2248 = (((_e428.member_1[1][0] * _e1930.member_1[2][0]) + (_e428.member_1[1][1] * _e1930.member_1[2][1])) + (_e428.member_1[1][2] * _e1930.member_1[2][2]));
                            let _e2261 = (((_e428.member_1[2][0] * _e1930.member_1[2][0]) + (_e428.member_1[2][1] * _e1930.member_1[2][1])) + (_e428.member_1[2][2] * _e1930.member_1[2][2]));
                            let _e2279 = (((select(_e2235, -(_e2235), (_e2235 < 0f)) * _e428.member_2[0]) + (select(_e2248, -(_e2248), (_e2248 < 0f)) * _e428.member_2[1])) + (select(_e2261, -(_e2261), (_e2261 < 0f)) * _e428.member_2[2]));
                            let _e2288 = (((_e1930.member_1[0][0] * _e433) + (_e1930.member_1[0][1] * _e436)) + (_e1930.member_1[0][2] * _e439));
                            let _e2297 = (((_e1930.member_1[1][0] * _e433) + (_e1930.member_1[1][1] * _e436)) + (_e1930.member_1[1][2] * _e439));
                            let _e2306 = (((_e1930.member_1[2][0] * _e433) + (_e1930.member_1[2][1] * _e436)) + (_e1930.member_1[2][2] * _e439));
                            let _e2307 = (_e1989 * -1f);
                            let _e2308 = (_e2047 * -1f);
                            let _e2309 = (_e2105 * -1f);
                            let _e2310 = (_e2288 - _e2163);
                            let _e2311 = (_e2297 - _e2221);
                            let _e2312 = (_e2306 - _e2279);
                            let _e2319 = (_e2288 + _e2163);
                            let _e2320 = (_e2297 + _e2221);
                            let _e2321 = (_e2306 + _e2279);
                            let _e2332 = ((select(_e2310, _e2307, (_e2307 < _e2310)) + select(_e2319, _e1989, (_e1989 > _e2319))) * 0.5f);
                            let _e2333 = ((select(_e2311, _e2308, (_e2308 < _e2311)) + select(_e2320, _e2047, (_e2047 > _e2320))) * 0.5f);
                            let _e2334 = ((select(_e2312, _e2309, (_e2309 < _e2312)) + select(_e2321, _e2105, (_e2105 > _e2321))) * 0.5f);
                            let _e2363 = (_e299.member[0] + (((_e1930.member_1[0][0] * _e2332) + (_e1930.member_1[1][0] * _e2333)) + (_e1930.member_1[2][0] * _e2334)));
                            let _e2365 = (_e299.member[1] + (((_e1930.member_1[0][1] * _e2332) + (_e1930.member_1[1][1] * _e2333)) + (_e1930.member_1[2][1] * _e2334)));
                            let _e2367 = (_e299.member[2] + (((_e1930.member_1[0][2] * _e2332) + (_e1930.member_1[1][2] * _e2333)) + (_e1930.member_1[2][2] * _e2334)));
                            let _e2373 = select(_e299.member[0], -(_e299.member[0]), (_e299.member[0] < 0f));
                            let _e2377 = select(_e299.member[1], -(_e299.member[1]), (_e299.member[1] < 0f));
                            let _e2381 = select(_e299.member[2], -(_e299.member[2]), (_e299.member[2] < 0f));
                            let _e2386 = select(_e428.member[0], -(_e428.member[0]), (_e428.member[0] < 0f));
                            let _e2390 = select(_e428.member[1], -(_e428.member[1]), (_e428.member[1] < 0f));
                            let _e2394 = select(_e428.member[2], -(_e428.member[2]), (_e428.member[2] < 0f));
                            let _e2396 = select(_e2386, _e2373, (_e2373 > _e2386));
                            let _e2398 = select(_e2390, _e2377, (_e2377 > _e2390));
                            let _e2400 = select(_e2394, _e2381, (_e2381 > _e2394));
                            let _e2403 = (_e299.member[0] - _e2363);
                            let _e2405 = (_e299.member[1] - _e2365);
                            let _e2407 = (_e299.member[2] - _e2367);
                            let _e2420 = (((select(_e2403, -(_e2403), (_e2403 < 0f)) + select(_e2405, -(_e2405), (_e2405 < 0f))) + select(_e2407, -(_e2407), (_e2407 < 0f))) * (0.000000059604645f * 16f));
                            let _e2475 = (0.000000059604645f * 12f);
                            let _e2479 = (((((select(_e1930.member_1[0][0], -(_e1930.member_1[0][0]), (_e1930.member_1[0][0] < 0f)) * _e2396) + (select(_e1930.member_1[0][1], -(_e1930.member_1[0][1]), (_e1930.member_1[0][1] < 0f)) * _e2398)) + (select(_e1930.member_1[0][2], -(_e1930.member_1[0][2]), (_e1930.member_1[0][2] < 0f)) * _e2400)) * _e2475) + _e2420);
                            let _e2480 = (((((select(_e1930.member_1[1][0], -(_e1930.member_1[1][0]), (_e1930.member_1[1][0] < 0f)) * _e2396) + (select(_e1930.member_1[1][1], -(_e1930.member_1[1][1]), (_e1930.member_1[1][1] < 0f)) * _e2398)) + (select(_e1930.member_1[1][2], -(_e1930.member_1[1][2]), (_e1930.member_1[1][2] < 0f)) * _e2400)) * _e2475) + _e2420);
                            let _e2481 = (((((select(_e1930.member_1[2][0], -(_e1930.member_1[2][0]), (_e1930.member_1[2][0] < 0f)) * _e2396) + (select(_e1930.member_1[2][1], -(_e1930.member_1[2][1]), (_e1930.member_1[2][1] < 0f)) * _e2398)) + (select(_e1930.member_1[2][2], -(_e1930.member_1[2][2]), (_e1930.member_1[2][2] < 0f)) * _e2400)) * _e2475) + _e2420);
                            let _e2484 = (_e299.member[0] - _e2363);
                            let _e2486 = (_e299.member[1] - _e2365);
                            let _e2488 = (_e299.member[2] - _e2367);
                            let _e2508 = select(_e2484, -(_e2484), (_e2484 < 0f));
                            let _e2511 = select(_e2486, -(_e2486), (_e2486 < 0f));
                            let _e2514 = select(_e2488, -(_e2488), (_e2488 < 0f));
                            let _e2569 = (0.000000059604645f * 8f);
                            let _e2574 = ((((select(_e299.member_2[0], -(_e299.member_2[0]), (_e299.member_2[0] < 0f)) + select(_e299.member_2[1], -(_e299.member_2[1]), (_e299.member_2[1] < 0f))) + select(_e299.member_2[2], -(_e299.member_2[2]), (_e299.member_2[2] < 0f))) * (0.000000059604645f * 64f)) + (0.000000000000000000000000000000000000011754944f * 64f));
                            let _e2586 = (((_e1930.member_1[0][0] * _e2484) + (_e1930.member_1[0][1] * _e2486)) + (_e1930.member_1[0][2] * _e2488));
                            let _e2595 = (((_e1930.member_1[1][0] * _e2484) + (_e1930.member_1[1][1] * _e2486)) + (_e1930.member_1[1][2] * _e2488));
                            let _e2604 = (((_e1930.member_1[2][0] * _e2484) + (_e1930.member_1[2][1] * _e2486)) + (_e1930.member_1[2][2] * _e2488));
                            let _e2627 = (((_e299.member_1[0][0] * _e1930.member_1[0][0]) + (_e299.member_1[0][1] * _e1930.member_1[0][1])) + (_e299.member_1[0][2] * _e1930.member_1[0][2]));
                            let _e2640 = (((_e299.member_1[1][0] * _e1930.member_1[0][0]) + (_e299.member_1[1][1] * _e1930.member_1[0][1])) + (_e299.member_1[1][2] * _e1930.member_1[0][2]));
                            let _e2653 = (((_e299.member_1[2][0] * _e1930.member_1[0][0]) + (_e299.member_1[2][1] * _e1930.member_1[0][1])) + (_e299.member_1[2][2] * _e1930.member_1[0][2]));
                            let _e2685 = (((_e299.member_1[0][0] * _e1930.member_1[1][0]) + (_e299.member_1[0][1] * _e1930.member_1[1][1])) + (_e299.member_1[0][2] * _e1930.member_1[1][2]));
                            let _e2698 = (((_e299.member_1[1][0] * _e1930.member_1[1][0]) + (_e299.member_1[1][1] * _e1930.member_1[1][1])) + (_e299.member_1[1][2] * _e1930.member_1[1][2]));
                            let _e2711 = (((_e299.member_1[2][0] * _e1930.member_1[1][0]) + (_e299.member_1[2][1] * _e1930.member_1[1][1])) + (_e299.member_1[2][2] * _e1930.member_1[1][2]));
                            let _e2743 = (((_e299.member_1[0][0] * _e1930.member_1[2][0]) + (_e299.member_1[0][1] * _e1930.member_1[2][1])) + (_e299.member_1[0][2] * _e1930.member_1[2][2]));
                            let _e2756 = (((_e299.member_1[1][0] * _e1930.member_1[2][0]) + (_e299.member_1[1][1] * _e1930.member_1[2][1])) + (_e299.member_1[1][2] * _e1930.member_1[2][2]));
                            let _e2769 = (((_e299.member_1[2][0] * _e1930.member_1[2][0]) + (_e299.member_1[2][1] * _e1930.member_1[2][1])) + (_e299.member_1[2][2] * _e1930.member_1[2][2]));
                            let _e2796 = (_e428.member[0] - _e2363);
                            let _e2798 = (_e428.member[1] - _e2365);
                            let _e2800 = (_e428.member[2] - _e2367);
                            let _e2820 = select(_e2796, -(_e2796), (_e2796 < 0f));
                            let _e2823 = select(_e2798, -(_e2798), (_e2798 < 0f));
                            let _e2826 = select(_e2800, -(_e2800), (_e2800 < 0f));
                            let _e2881 = (0.000000059604645f * 8f);
                            let _e2886 = ((((select(_e428.member_2[0], -(_e428.member_2[0]), (_e428.member_2[0] < 0f)) + select(_e428.member_2[1], -(_e428.member_2[1]), (_e428.member_2[1] < 0f))) + select(_e428.member_2[2], -(_e428.member_2[2]), (_e428.member_2[2] < 0f))) * (0.000000059604645f * 64f)) + (0.000000000000000000000000000000000000011754944f * 64f));
                            let _e2898 = (((_e1930.member_1[0][0] * _e2796) + (_e1930.member_1[0][1] * _e2798)) + (_e1930.member_1[0][2] * _e2800));
                            let _e2907 = (((_e1930.member_1[1][0] * _e2796) + (_e1930.member_1[1][1] * _e2798)) + (_e1930.member_1[1][2] * _e2800));
                            let _e2916 = (((_e1930.member_1[2][0] * _e2796) + (_e1930.member_1[2][1] * _e2798)) + (_e1930.member_1[2][2] * _e2800));
                            let _e2939 = (((_e428.member_1[0][0] * _e1930.member_1[0][0]) + (_e428.member_1[0][1] * _e1930.member_1[0][1])) + (_e428.member_1[0][2] * _e1930.member_1[0][2]));
                            let _e2952 = (((_e428.member_1[1][0] * _e1930.member_1[0][0]) + (_e428.member_1[1][1] * _e1930.member_1[0][1])) + (_e428.member_1[1][2] * _e1930.member_1[0][2]));
                            let _e2965 = (((_e428.member_1[2][0] * _e1930.member_1[0][0]) + (_e428.member_1[2][1] * _e1930.member_1[0][1])) + (_e428.member_1[2][2] * _e1930.member_1[0][2]));
                            let _e2997 = (((_e428.member_1[0][0] * _e1930.member_1[1][0]) + (_e428.member_1[0][1] * _e1930.member_1[1][1])) + (_e428.member_1[0][2] * _e1930.member_1[1][2]));
                            let _e3010 = (((_e428.member_1[1][0] * _e1930.member_1[1][0]) + (_e428.member_1[1][1] * _e1930.member_1[1][1])) + (_e428.member_1[1][2] * _e1930.member_1[1][2]));
                            let _e3023 = (((_e428.member_1[2][0] * _e1930.member_1[1][0]) + (_e428.member_1[2][1] * _e1930.member_1[1][1])) + (_e428.member_1[2][2] * _e1930.member_1[1][2]));
                            let _e3055 = (((_e428.member_1[0][0] * _e1930.member_1[2][0]) + (_e428.member_1[0][1] * _e1930.member_1[2][1])) + (_e428.member_1[0][2] * _e1930.member_1[2][2]));
                            let _e3068 = (((_e428.member_1[1][0] * _e1930.member_1[2][0]) + (_e428.member_1[1][1] * _e1930.member_1[2][1])) + (_e428.member_1[1][2] * _e1930.member_1[2][2]));
                            let _e3081 = (((_e428.member_1[2][0] * _e1930.member_1[2][0]) + (_e428.member_1[2][1] * _e1930.member_1[2][1])) + (_e428.member_1[2][2] * _e1930.member_1[2][2]));
                            let _e3106 = (((select(_e2586, -(_e2586), (_e2586 < 0f)) + (((select(_e2627, -(_e2627), (_e2627 < 0f)) * _e299.member_2[0]) + (select(_e2640, -(_e2640), (_e2640 < 0f)) * _e299.member_2[1])) + (select(_e2653, -(_e2653), (_e2653 < 0f)) * _e299.member_2[2]))) + (((((select(_e1930.member_1[0][0], -(_e1930.member_1[0][0]), (_e1930.member_1[0][0] < 0f)) * _e2508) + (select(_e1930.member_1[0][1], -(_e1930.member_1[0][1]), (_e1930.member_1[0][1] < 0f)) * _e2511)) + (select(_e1930.member_1[0][2], -(_e1930.member_1[0][2]), (_e1930.member_1[0][2] < 0f)) * _e2514)) * _e2569) + _e2574)) + _e2479);
                            let _e3107 = (((select(_e2595, -(_e2595), (_e2595 < 0f)) + (((select(_e2685, -(_e2685), (_e2685 < 0f)) * _e299.member_2[0]) + (select(_e2698, -(_e2698), (_e2698 < 0f)) * _e299.member_2[1])) + (select(_e2711, -(_e2711), (_e2711 < 0f)) * _e299.member_2[2]))) + (((((select(_e1930.member_1[1][0], -(_e1930.member_1[1][0]), (_e1930.member_1[1][0] < 0f)) * _e2508) + (select(_e1930.member_1[1][1], -(_e1930.member_1[1][1]), (_e1930.member_1[1][1] < 0f)) * _e2511)) + (select(_e1930.member_1[1][2], -(_e1930.member_1[1][2]), (_e1930.member_1[1][2] < 0f)) * _e2514)) * _e2569) + _e2574)) + _e2480);
                            let _e3108 = (((select(_e2604, -(_e2604), (_e2604 < 0f)) + (((select(_e2743, -(_e2743), (_e2743 < 0f)) * _e299.member_2[0]) + (select(_e2756, -(_e2756), (_e2756 < 0f)) * _e299.member_2[1])) + (select(_e2769, -(_e2769), (_e2769 < 0f)) * _e299.member_2[2]))) + (((((select(_e1930.member_1[2][0], -(_e1930.member_1[2][0]), (_e1930.member_1[2][0] < 0f)) * _e2508) + (select(_e1930.member_1[2][1], -(_e1930.member_1[2][1]), (_e1930.member_1[2][1] < 0f)) * _e2511)) + (select(_e1930.member_1[2][2], -(_e1930.member_1[2][2]), (_e1930.member_1[2][2] < 0f)) * _e2514)) * _e2569) + _e2574)) + _e2481);
                            let _e3109 = (((select(_e2898, -(_e2898), (_e2898 < 0f)) + (((select(_e2939, -(_e2939), (_e2939 < 0f)) * _e428.member_2[0]) + (select(_e2952, -(_e2952), (_e2952 < 0f)) * _e428.member_2[1])) + (select(_e2965, -(_e2965), (_e2965 < 0f)) * _e428.member_2[2]))) + (((((select(_e1930.member_1[0][0], -(_e1930.member_1[0][0]), (_e1930.member_1[0][0] < 0f)) * _e2820) + (select(_e1930.member_1[0][1], -(_e1930.member_1[0][1]), (_e1930.member_1[0][1] < 0f)) * _e2823)) + (select(_e1930.member_1[0][2], -(_e1930.member_1[0][2]), (_e1930.member_1[0][2] < 0f)) * _e2826)) * _e2881) + _e2886)) + _e2479);
                            let _e3110 = (((select(_e2907, -(_e2907), (_e2907 < 0f)) + (((select(_e2997, -(_e2997), (_e2997 < 0f)) * _e428.member_2[0]) + (select(_e3010, -(_e3010), (_e3010 < 0f)) * _e428.member_2[1])) + (select(_e3023, -(_e3023), (_e3023 < 0f)) * _e428.member_2[2]))) + (((((select(_e1930.member_1[1][0], -(_e1930.member_1[1][0]), (_e1930.member_1[1][0] < 0f)) * _e2820) + (select(_e1930.member_1[1][1], -(_e1930.member_1[1][1]), (_e1930.member_1[1][1] < 0f)) * _e2823)) + (select(_e1930.member_1[1][2], -(_e1930.member_1[1][2]), (_e1930.member_1[1][2] < 0f)) * _e2826)) * _e2881) + _e2886)) + _e2480);
                            let _e3111 = (((select(_e2916, -(_e2916), (_e2916 < 0f)) + (((select(_e3055, -(_e3055), (_e3055 < 0f)) * _e428.member_2[0]) + (select(_e3068, -(_e3068), (_e3068 < 0f)) * _e428.member_2[1])) + (select(_e3081, -(_e3081), (_e3081 < 0f)) * _e428.member_2[2]))) + (((((select(_e1930.member_1[2][0], -(_e1930.member_1[2][0]), (_e1930.member_1[2][0] < 0f)) * _e2820) + (select(_e1930.member_1[2][1], -(_e1930.member_1[2][1]), (_e1930.member_1[2][1] < 0f)) * _e2823)) + (select(_e1930.member_1[2][2], -(_e1930.member_1[2][2]), (_e1930.member_1[2][2] < 0f)) * _e2826)) * _e2881) + _e2886)) + _e2481);
                            let _e3114 = ((bitcast<u32>(_e3106) & 2139095040u) != 2139095040u);
                            let _e3117 = ((bitcast<u32>(_e3107) & 2139095040u) != 2139095040u);
                            if select(select(bool(), select(bool(), ((bitcast<u32>(_e3108) & 2139095040u) != 2139095040u), _e3117), _e3114), false, select(true, select(true, false, _e3117), _e3114)) {
                                let _e3128 = ((bitcast<u32>(_e3109) & 2139095040u) != 2139095040u);
                                let _e3131 = ((bitcast<u32>(_e3110) & 2139095040u) != 2139095040u);
                                if select(select(bool(), select(bool(), ((bitcast<u32>(_e3111) & 2139095040u) != 2139095040u), _e3131), _e3128), false, select(true, select(true, false, _e3131), _e3128)) {
                                    phi_4325_ = type_34(array<f32, 3>(_e2363, _e2365, _e2367), _e1930.member_1, array<f32, 3>(select(_e3109, _e3106, (_e3106 > _e3109)), select(_e3110, _e3107, (_e3107 > _e3110)), select(_e3111, _e3108, (_e3108 > _e3111))));
                                    phi_4326_ = false;
                                } else {
                                    phi_4325_ = type_34();
                                    phi_4326_ = true;
                                }
                                let _e3149 = phi_4325_;
                                let _e3151 = phi_4326_;
                                phi_4327_ = _e3149;
                                phi_4328_ = _e3151;
                            } else {
                                phi_4327_ = type_34();
                                phi_4328_ = true;
                            }
                            let _e3153 = phi_4327_;
                            let _e3155 = phi_4328_;
                            if _e3155 {
                                let _e3156 = (85070590000000000000000000000000000000f * 3.9999998f);
                                phi_4352_ = type_34(array<f32, 3>(0f, 0f, 0f), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(_e3156, _e3156, _e3156));
                            } else {
                                phi_4352_ = _e3153;
                            }
                            let _e3160 = phi_4352_;
                            oriented.member[_e115] = type_30(vec4<f32>(_e3160.member[0], _e3160.member[1], _e3160.member[2], _e3160.member_1[0][0]), vec4<f32>(_e3160.member_1[0][1], _e3160.member_1[0][2], _e3160.member_1[1][0], _e3160.member_1[1][1]), vec4<f32>(_e3160.member_1[1][2], _e3160.member_1[2][0], _e3160.member_1[2][1], _e3160.member_1[2][2]), vec4<f32>(_e3160.member_2[0], _e3160.member_2[1], _e3160.member_2[2], 0f));
                            let _e3189 = atomicMax((&stamps.member[_e115]), _e81);
                        }
                    }
                }
                phi_4384_ = true;
            }
            let _e3191 = phi_4384_;
            phi_4385_ = _e3191;
        } else {
            phi_4385_ = false;
        }
        let _e3193 = phi_4385_;
        continue;
        continuing {
            phi_177_ = type_9(select(_e92.member, (_e92.member + 1u), _e95), select(_e92.member_1, _e92.member_1, _e95));
            break if !(_e3193);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn orient_far(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}

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

struct type_10 {
    member: type_7,
    member_1: type_8,
    member_2: type_9,
}

struct type_11 {
    member: type_10,
}

struct type_13 {
    member: array<u32>,
}

struct type_18 {
    member: u32,
    member_1: array<u32, 4>,
}

struct type_19 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_21 {
    member: array<type_19>,
}

struct type_23 {
    member: array<array<f32, 3>, 2>,
    member_1: array<array<f32, 3>, 2>,
    member_2: array<array<f32, 3>, 2>,
    member_3: f32,
}

struct type_24 {
    member: array<array<f32, 3>, 2>,
    member_1: array<array<f32, 3>, 2>,
}

struct type_28 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_11;
@group(0) @binding(3) 
var<storage> input: type_13;
@group(0) @binding(4) 
var<storage, read_write> output: type_28;
@group(0) @binding(2) 
var<storage> paths: type_21;
@group(0) @binding(1) 
var<storage> elements: type_13;
var<workgroup> counters: array<atomic<u32>, 3>;
var<workgroup> left: array<type_9, 512>;
var<workgroup> kept: array<type_9, 512>;

fn function_(param: f32, param_1: f32) -> f32 {
    return select(param, param_1, select((param_1 <= param), true, (param != param)));
}

fn function_1(param_2: f32, param_3: f32) -> f32 {
    return select(param_2, param_3, select((param_3 >= param_2), true, (param_2 != param_2)));
}

fn function_2(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_23;
    var local_1: type_23;
    var local_2: type_23;
    var phi_191_: u32;
    var phi_236_: u32;
    var phi_239_: type_9;
    var phi_281_: type_9;
    var phi_432_: type_18;
    var phi_554_: type_24;
    var phi_601_: type_24;
    var phi_674_: bool;
    var phi_808_: type_23;
    var phi_2443_: f32;
    var phi_2446_: bool;
    var phi_2455_: bool;
    var phi_2456_: bool;
    var phi_2461_: type_9;
    var phi_2589_: type_18;
    var phi_2722_: type_23;
    var phi_4456_: f32;
    var phi_4459_: bool;
    var phi_6059_: f32;
    var phi_6062_: bool;
    var phi_6064_: bool;
    var phi_6073_: bool;
    var phi_6074_: bool;
    var phi_6102_: type_9;
    var phi_6160_: bool;
    var phi_6161_: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e43 = id_2;
    let _e44 = n_2;
    let _e45 = lane_2;
    let _e55 = ((_e43.y * _e44.x) + _e43.x);
    let _e58 = (_e44.x * _e44.y);
    let _e60 = params.member.member;
    let _e63 = params.member.member_2.member;
    let _e71 = params.member.member_1.member_2;
    let _e73 = input.member[0u];
    let _e75 = select(_e73, _e71, (_e71 < _e73));
    let _e77 = params.member.member_1.member_1;
    if (_e75 > _e77) {
        let _e80 = params.member.member_1.member_1;
        phi_191_ = (_e75 - _e80);
    } else {
        phi_191_ = 0u;
    }
    let _e83 = phi_191_;
    let _e85 = params.member.member_1.member;
    let _e87 = select(_e83, _e85, (_e85 < _e83));
    let _e88 = (_e87 / 512u);
    let _e92 = select(_e88, (_e88 + 1u), ((_e87 % 512u) > 0u));
    if (_e92 > _e55) {
        let _e94 = (_e92 - _e55);
        if (_e58 == 0u) {
            return;
        }
        let _e96 = (_e94 / _e58);
        if (_e58 == 0u) {
            return;
        }
        phi_236_ = select(_e96, (_e96 + 1u), ((_e94 % _e58) > 0u));
    } else {
        phi_236_ = 0u;
    }
    let _e103 = phi_236_;
    phi_239_ = type_9(0u, _e103);
    loop {
        let _e106 = phi_239_;
        let _e109 = (_e106.member < _e106.member_1);
        let _e122 = (bitcast<i32>(select(0u, 1u, _e109)) != 0i);
        if _e122 {
            if (_e45 <= 1u) {
                atomicStore((&counters[_e45]), 0u);
            }
            workgroupBarrier();
            phi_281_ = type_9(0u, 4u);
            loop {
                let _e129 = phi_281_;
                let _e132 = (_e129.member < _e129.member_1);
                if (bitcast<i32>(select(0u, 1u, _e132)) != 0i) {
                    let _e148 = ((((_e55 + (select(type_9().member_1, _e106.member, _e109) * _e58)) * 512u) + (select(type_9().member_1, _e129.member, _e132) * 128u)) + _e45);
                    if (_e148 >= _e87) {
                        phi_2455_ = false;
                    } else {
                        let _e152 = params.member.member_1.member_1;
                        let _e154 = (2u * (_e152 + _e148));
                        let _e157 = input.member[(4u + _e154)];
                        let _e160 = input.member[(_e154 + 5u)];
                        if (_e63 == 0u) {
                            let _e176 = (3u * _e160);
                            let _e178 = elements.member[_e176];
                            let _e181 = elements.member[(_e176 + 1u)];
                            let _e184 = elements.member[(_e176 + 2u)];
                            phi_432_ = type_18(0u, array<u32, 4>(_e157, _e178, _e181, _e184));
                        } else {
                            let _e162 = (2u * _e157);
                            let _e163 = (2u * _e160);
                            let _e165 = elements.member[_e162];
                            let _e167 = elements.member[_e163];
                            let _e170 = elements.member[(_e162 + 1u)];
                            let _e173 = elements.member[(_e163 + 1u)];
                            phi_432_ = type_18(1u, array<u32, 4>(_e165, _e170, _e167, _e173));
                        }
                        let _e188 = phi_432_;
                        if ((_e60.member_1 & 512u) != 0u) {
                            phi_674_ = true;
                        } else {
                            let _e193 = paths.member[_e188.member_1[0]];
                            let _e208 = paths.member[_e188.member_1[1]];
                            let _e223 = paths.member[_e188.member_1[2]];
                            let _e238 = paths.member[_e188.member_1[3]];
                            let _e251 = array<f32, 3>(_e193.member.x, _e193.member.y, _e193.member.z);
                            let _e252 = array<f32, 3>(_e193.member_1.x, _e193.member_1.y, _e193.member_1.z);
                            if (_e188.member != 0u) {
                                let _e277 = function_(_e193.member.x, _e208.member.x);
                                let _e278 = function_(_e193.member.y, _e208.member.y);
                                let _e279 = function_(_e193.member.z, _e208.member.z);
                                let _e281 = function_1(_e193.member.x, _e208.member.x);
                                let _e282 = function_1(_e193.member.y, _e208.member.y);
                                let _e283 = function_1(_e193.member.z, _e208.member.z);
                                let _e286 = function_(_e223.member.x, _e238.member.x);
                                let _e287 = function_(_e223.member.y, _e238.member.y);
                                let _e288 = function_(_e223.member.z, _e238.member.z);
                                let _e290 = function_1(_e223.member.x, _e238.member.x);
                                let _e291 = function_1(_e223.member.y, _e238.member.y);
                                let _e292 = function_1(_e223.member.z, _e238.member.z);
                                phi_554_ = type_24(array<array<f32, 3>, 2>(array<f32, 3>(_e277, _e278, _e279), array<f32, 3>(_e281, _e282, _e283)), array<array<f32, 3>, 2>(array<f32, 3>(_e286, _e287, _e288), array<f32, 3>(_e290, _e291, _e292)));
                            } else {
                                let _e254 = function_(_e208.member.x, _e223.member.x);
                                let _e255 = function_(_e208.member.y, _e223.member.y);
                                let _e256 = function_(_e208.member.z, _e223.member.z);
                                let _e257 = function_1(_e208.member.x, _e223.member.x);
                                let _e258 = function_1(_e208.member.y, _e223.member.y);
                                let _e259 = function_1(_e208.member.z, _e223.member.z);
                                let _e261 = function_(_e254, _e238.member.x);
                                let _e262 = function_(_e255, _e238.member.y);
                                let _e263 = function_(_e256, _e238.member.z);
                                let _e265 = function_1(_e254, _e238.member.x);
                                let _e266 = function_1(_e255, _e238.member.y);
                                let _e267 = function_1(_e256, _e238.member.z);
                                let _e268 = function_(_e257, _e238.member.x);
                                let _e269 = function_(_e258, _e238.member.y);
                                let _e270 = function_(_e259, _e238.member.z);
                                let _e271 = function_1(_e257, _e238.member.x);
                                let _e272 = function_1(_e258, _e238.member.y);
                                let _e273 = function_1(_e259, _e238.member.z);
                                phi_554_ = type_24(array<array<f32, 3>, 2>(_e251, _e251), array<array<f32, 3>, 2>(array<f32, 3>(_e261, _e262, _e263), array<f32, 3>(_e271, _e272, _e273)));
                            }
                            let _e297 = phi_554_;
                            if (_e188.member != 0u) {
                                let _e322 = function_(_e193.member_1.x, _e208.member_1.x);
                                let _e323 = function_(_e193.member_1.y, _e208.member_1.y);
                                let _e324 = function_(_e193.member_1.z, _e208.member_1.z);
                                let _e326 = function_1(_e193.member_1.x, _e208.member_1.x);
                                let _e327 = function_1(_e193.member_1.y, _e208.member_1.y);
                                let _e328 = function_1(_e193.member_1.z, _e208.member_1.z);
                                let _e331 = function_(_e223.member_1.x, _e238.member_1.x);
                                let _e332 = function_(_e223.member_1.y, _e238.member_1.y);
                                let _e333 = function_(_e223.member_1.z, _e238.member_1.z);
                                let _e335 = function_1(_e223.member_1.x, _e238.member_1.x);
                                let _e336 = function_1(_e223.member_1.y, _e238.member_1.y);
                                let _e337 = function_1(_e223.member_1.z, _e238.member_1.z);
                                phi_601_ = type_24(array<array<f32, 3>, 2>(array<f32, 3>(_e322, _e323, _e324), array<f32, 3>(_e326, _e327, _e328)), array<array<f32, 3>, 2>(array<f32, 3>(_e331, _e332, _e333), array<f32, 3>(_e335, _e336, _e337)));
                            } else {
                                let _e299 = function_(_e208.member_1.x, _e223.member_1.x);
                                let _e300 = function_(_e208.member_1.y, _e223.member_1.y);
                                let _e301 = function_(_e208.member_1.z, _e223.member_1.z);
                                let _e302 = function_1(_e208.member_1.x, _e223.member_1.x);
                                let _e303 = function_1(_e208.member_1.y, _e223.member_1.y);
                                let _e304 = function_1(_e208.member_1.z, _e223.member_1.z);
                                let _e306 = function_(_e299, _e238.member_1.x);
                                let _e307 = function_(_e300, _e238.member_1.y);
                                let _e308 = function_(_e301, _e238.member_1.z);
                                let _e310 = function_1(_e299, _e238.member_1.x);
                                let _e311 = function_1(_e300, _e238.member_1.y);
                                let _e312 = function_1(_e301, _e238.member_1.z);
                                let _e313 = function_(_e302, _e238.member_1.x);
                                let _e314 = function_(_e303, _e238.member_1.y);
                                let _e315 = function_(_e304, _e238.member_1.z);
                                let _e316 = function_1(_e302, _e238.member_1.x);
                                let _e317 = function_1(_e303, _e238.member_1.y);
                                let _e318 = function_1(_e304, _e238.member_1.z);
                                phi_601_ = type_24(array<array<f32, 3>, 2>(_e252, _e252), array<array<f32, 3>, 2>(array<f32, 3>(_e306, _e307, _e308), array<f32, 3>(_e316, _e317, _e318)));
                            }
                            let _e342 = phi_601_;
                            let _e351 = (((_e60.member_5 + (2f * _e60.member_4)) * 1.0001f) + (8f * 0.000000000000000000000000000000000000011754944f));
                            phi_674_ = !(((((((_e297.member[0][0] - _e297.member_1[1][0]) > _e351) && ((_e342.member[0][0] - _e342.member_1[1][0]) > _e351)) || (((_e297.member_1[0][0] - _e297.member[1][0]) > _e351) && ((_e342.member_1[0][0] - _e342.member[1][0]) > _e351))) || ((((_e297.member[0][1] - _e297.member_1[1][1]) > _e351) && ((_e342.member[0][1] - _e342.member_1[1][1]) > _e351)) || (((_e297.member_1[0][1] - _e297.member[1][1]) > _e351) && ((_e342.member_1[0][1] - _e342.member[1][1]) > _e351)))) || ((((_e297.member[0][2] - _e297.member_1[1][2]) > _e351) && ((_e342.member[0][2] - _e342.member_1[1][2]) > _e351)) || (((_e297.member_1[0][2] - _e297.member[1][2]) > _e351) && ((_e342.member_1[0][2] - _e342.member[1][2]) > _e351)))));
                        }
                        let _e437 = phi_674_;
                        if _e437 {
                            let _e440 = paths.member[_e188.member_1[0]];
                            let _e455 = paths.member[_e188.member_1[1]];
                            let _e470 = paths.member[_e188.member_1[2]];
                            let _e485 = paths.member[_e188.member_1[3]];
                            if (_e188.member != 0u) {
                                phi_808_ = type_23(array<array<f32, 3>, 2>(array<f32, 3>((_e470.member.x - _e440.member.x), (_e470.member.y - _e440.member.y), (_e470.member.z - _e440.member.z)), array<f32, 3>((_e470.member_1.x - _e440.member_1.x), (_e470.member_1.y - _e440.member_1.y), (_e470.member_1.z - _e440.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e455.member.x - _e440.member.x), (_e455.member.y - _e440.member.y), (_e455.member.z - _e440.member.z)), array<f32, 3>((_e455.member_1.x - _e440.member_1.x), (_e455.member_1.y - _e440.member_1.y), (_e455.member_1.z - _e440.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e470.member.x - _e485.member.x), (_e470.member.y - _e485.member.y), (_e470.member.z - _e485.member.z)), array<f32, 3>((_e470.member_1.x - _e485.member_1.x), (_e470.member_1.y - _e485.member_1.y), (_e470.member_1.z - _e485.member_1.z))), (_e60.member_4 + _e60.member_4));
                            } else {
                                phi_808_ = type_23(array<array<f32, 3>, 2>(array<f32, 3>((_e440.member.x - _e455.member.x), (_e440.member.y - _e455.member.y), (_e440.member.z - _e455.member.z)), array<f32, 3>((_e440.member_1.x - _e455.member_1.x), (_e440.member_1.y - _e455.member_1.y), (_e440.member_1.z - _e455.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e470.member.x - _e455.member.x), (_e470.member.y - _e455.member.y), (_e470.member.z - _e455.member.z)), array<f32, 3>((_e470.member_1.x - _e455.member_1.x), (_e470.member_1.y - _e455.member_1.y), (_e470.member_1.z - _e455.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e485.member.x - _e455.member.x), (_e485.member.y - _e455.member.y), (_e485.member.z - _e455.member.z)), array<f32, 3>((_e485.member_1.x - _e455.member_1.x), (_e485.member_1.y - _e455.member_1.y), (_e485.member_1.z - _e455.member_1.z))), (_e60.member_4 + _e60.member_4));
                            }
                            let _e558 = phi_808_;
                            local_2 = type_23(array<array<f32, 3>, 2>(array<f32, 3>(_e558.member[0][0], _e558.member[0][1], _e558.member[0][2]), array<f32, 3>(_e558.member[1][0], _e558.member[1][1], _e558.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e558.member_1[0][0], _e558.member_1[0][1], _e558.member_1[0][2]), array<f32, 3>(_e558.member_1[1][0], _e558.member_1[1][1], _e558.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e558.member_2[0][0], _e558.member_2[0][1], _e558.member_2[0][2]), array<f32, 3>(_e558.member_2[1][0], _e558.member_2[1][1], _e558.member_2[1][2])), _e558.member_3);
                            let _e599 = local_2.member_1[0u];
                            let _e605 = local_2.member_2[0u];
                            let _e611 = ((_e599[1] * _e605[2]) - (_e599[2] * _e605[1]));
                            let _e614 = ((_e599[2] * _e605[0]) - (_e599[0] * _e605[2]));
                            let _e617 = ((_e599[0] * _e605[1]) - (_e599[1] * _e605[0]));
                            let _e620 = local_2.member_1[1u];
                            let _e626 = local_2.member_2[1u];
                            let _e632 = ((_e620[1] * _e626[2]) - (_e620[2] * _e626[1]));
                            let _e635 = ((_e620[2] * _e626[0]) - (_e620[0] * _e626[2]));
                            let _e638 = ((_e620[0] * _e626[1]) - (_e620[1] * _e626[0]));
                            let _e641 = local_2.member_1[0u];
                            let _e647 = local_2.member_2[1u];
                            let _e662 = local_2.member_1[1u];
                            let _e668 = local_2.member_2[0u];
                            let _e681 = (((_e641[1] * _e647[2]) - (_e641[2] * _e647[1])) + ((_e662[1] * _e668[2]) - (_e662[2] * _e668[1])));
                            let _e682 = (((_e641[2] * _e647[0]) - (_e641[0] * _e647[2])) + ((_e662[2] * _e668[0]) - (_e662[0] * _e668[2])));
                            let _e683 = (((_e641[0] * _e647[1]) - (_e641[1] * _e647[0])) + ((_e662[0] * _e668[1]) - (_e662[1] * _e668[0])));
                            let _e686 = local_2.member[0u];
                            let _e697 = local_2.member[1u];
                            let _e708 = local_2.member[0u];
                            let _e717 = ((((_e697[0] * _e611) + (_e697[1] * _e614)) + (_e697[2] * _e617)) + (((_e708[0] * _e681) + (_e708[1] * _e682)) + (_e708[2] * _e683)));
                            let _e720 = local_2.member[0u];
                            let _e731 = local_2.member[1u];
                            let _e740 = ((((_e720[0] * _e632) + (_e720[1] * _e635)) + (_e720[2] * _e638)) + (((_e731[0] * _e681) + (_e731[1] * _e682)) + (_e731[2] * _e683)));
                            let _e743 = local_2.member[1u];
                            let _e754 = local_2.member[0u];
                            let _e760 = select(_e754[0], -(_e754[0]), (_e754[0] < 0f));
                            let _e763 = select(_e754[1], -(_e754[1]), (_e754[1] < 0f));
                            let _e765 = select(_e763, _e760, (_e760 > _e763));
                            let _e768 = select(_e754[2], -(_e754[2]), (_e754[2] < 0f));
                            let _e770 = select(_e768, _e765, (_e765 > _e768));
                            let _e773 = local_2.member[1u];
                            let _e779 = select(_e773[0], -(_e773[0]), (_e773[0] < 0f));
                            let _e782 = select(_e773[1], -(_e773[1]), (_e773[1] < 0f));
                            let _e784 = select(_e782, _e779, (_e779 > _e782));
                            let _e787 = select(_e773[2], -(_e773[2]), (_e773[2] < 0f));
                            let _e789 = select(_e787, _e784, (_e784 > _e787));
                            let _e793 = local_2.member_3;
                            let _e794 = (select(_e789, _e770, (_e770 > _e789)) + _e793);
                            let _e797 = local_2.member_1[0u];
                            let _e803 = select(_e797[0], -(_e797[0]), (_e797[0] < 0f));
                            let _e806 = select(_e797[1], -(_e797[1]), (_e797[1] < 0f));
                            let _e808 = select(_e806, _e803, (_e803 > _e806));
                            let _e811 = select(_e797[2], -(_e797[2]), (_e797[2] < 0f));
                            let _e813 = select(_e811, _e808, (_e808 > _e811));
                            let _e816 = local_2.member_1[1u];
                            let _e822 = select(_e816[0], -(_e816[0]), (_e816[0] < 0f));
                            let _e825 = select(_e816[1], -(_e816[1]), (_e816[1] < 0f));
                            let _e827 = select(_e825, _e822, (_e822 > _e825));
                            let _e830 = select(_e816[2], -(_e816[2]), (_e816[2] < 0f));
                            let _e832 = select(_e830, _e827, (_e827 > _e830));
                            let _e836 = local_2.member_3;
                            let _e837 = (select(_e832, _e813, (_e813 > _e832)) + _e836);
                            let _e840 = local_2.member_2[0u];
                            let _e846 = select(_e840[0], -(_e840[0]), (_e840[0] < 0f));
                            let _e849 = select(_e840[1], -(_e840[1]), (_e840[1] < 0f));
                            let _e851 = select(_e849, _e846, (_e846 > _e849));
                            let _e854 = select(_e840[2], -(_e840[2]), (_e840[2] < 0f));
                            let _e856 = select(_e854, _e851, (_e851 > _e854));
                            let _e859 = local_2.member_2[1u];
                            let _e865 = select(_e859[0], -(_e859[0]), (_e859[0] < 0f));
                            let _e868 = select(_e859[1], -(_e859[1]), (_e859[1] < 0f));
                            let _e870 = select(_e868, _e865, (_e865 > _e868));
                            let _e873 = select(_e859[2], -(_e859[2]), (_e859[2] < 0f));
                            let _e875 = select(_e873, _e870, (_e870 > _e873));
                            let _e879 = local_2.member_3;
                            let _e880 = (select(_e875, _e856, (_e856 > _e875)) + _e879);
                            let _e882 = ((_e837 * 8f) * _e880);
                            let _e889 = local_2.member_3;
                            let _e913 = ((select(_e611, -(_e611), (_e611 < 0f)) + select(_e614, -(_e614), (_e614 < 0f))) + select(_e617, -(_e617), (_e617 < 0f)));
                            let _e924 = ((select(_e632, -(_e632), (_e632 < 0f)) + select(_e635, -(_e635), (_e635 < 0f))) + select(_e638, -(_e638), (_e638 < 0f)));
                            let _e926 = select(_e924, _e913, (_e913 > _e924));
                            let _e938 = (((select(_e681, -(_e681), (_e681 < 0f)) + select(_e682, -(_e682), (_e682 < 0f))) + select(_e683, -(_e683), (_e683 < 0f))) * 0.5f);
                            let _e945 = local_2.member_3;
                            let _e958 = ((((_e686[0] * _e611) + (_e686[1] * _e614)) + (_e686[2] * _e617)) * 3f);
                            let _e959 = ((((_e743[0] * _e632) + (_e743[1] * _e635)) + (_e743[2] * _e638)) * 3f);
                            let _e961 = select(_e959, _e958, (_e958 < _e959));
                            let _e963 = select(_e740, _e717, (_e717 < _e740));
                            let _e965 = select(_e963, _e961, (_e961 < _e963));
                            let _e967 = select(_e959, _e958, (_e958 > _e959));
                            let _e969 = select(_e740, _e717, (_e717 > _e740));
                            let _e976 = -(select(_e969, _e967, (_e967 > _e969)));
                            let _e980 = ((select(_e976, _e965, (_e965 > _e976)) - ((((((_e794 * 8f) * _e882) * (0.000000059604645f * (524f / 64f))) + ((_e889 * 19f) * ((_e794 * (_e837 + _e880)) + (_e837 * _e880)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e794) * ((1f + _e837) * (1f + _e880))))) + ((_e60.member_5 * (((select(_e938, _e926, (_e926 > _e938)) + (_e882 * (0.000000059604645f * 8f))) + ((_e945 * 6f) * (_e837 + _e880))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e837) * (1f + _e880))))) * (3f * 1.0001f)))) > 0f);
                            if _e980 {
                                phi_2446_ = _e980;
                            } else {
                                let _e983 = local_2.member_1[0u];
                                let _e989 = local_2.member_1[1u];
                                let _e993 = (_e983[0] + _e989[0]);
                                let _e994 = (_e983[1] + _e989[1]);
                                let _e995 = (_e983[2] + _e989[2]);
                                let _e998 = local_2.member_2[0u];
                                let _e1004 = local_2.member_2[1u];
                                let _e1008 = (_e998[0] + _e1004[0]);
                                let _e1009 = (_e998[1] + _e1004[1]);
                                let _e1010 = (_e998[2] + _e1004[2]);
                                let _e1013 = ((_e994 * _e1010) - (_e995 * _e1009));
                                let _e1016 = ((_e995 * _e1008) - (_e993 * _e1010));
                                let _e1019 = ((_e993 * _e1009) - (_e994 * _e1008));
                                let _e1022 = local_2.member[0u];
                                let _e1028 = local_2.member_1[0u];
                                let _e1034 = local_2.member_2[0u];
                                let _e1038 = (_e1022[0] - _e1028[0]);
                                let _e1039 = (_e1022[1] - _e1028[1]);
                                let _e1040 = (_e1022[2] - _e1028[2]);
                                let _e1041 = (_e188.member == 0u);
                                let _e1045 = select((_e1038 - _e1034[0]), _e1022[0], _e1041);
                                let _e1046 = select((_e1039 - _e1034[1]), _e1022[1], _e1041);
                                let _e1047 = select((_e1040 - _e1034[2]), _e1022[2], _e1041);
                                let _e1048 = (_e1022[0] - _e1034[0]);
                                let _e1049 = (_e1022[1] - _e1034[1]);
                                let _e1050 = (_e1022[2] - _e1034[2]);
                                let _e1053 = local_2.member[1u];
                                let _e1059 = local_2.member_1[1u];
                                let _e1065 = local_2.member_2[1u];
                                let _e1069 = (_e1053[0] - _e1059[0]);
                                let _e1070 = (_e1053[1] - _e1059[1]);
                                let _e1071 = (_e1053[2] - _e1059[2]);
                                let _e1072 = (_e188.member == 0u);
                                let _e1076 = select((_e1069 - _e1065[0]), _e1053[0], _e1072);
                                let _e1077 = select((_e1070 - _e1065[1]), _e1053[1], _e1072);
                                let _e1078 = select((_e1071 - _e1065[2]), _e1053[2], _e1072);
                                let _e1079 = (_e1053[0] - _e1065[0]);
                                let _e1080 = (_e1053[1] - _e1065[1]);
                                let _e1081 = (_e1053[2] - _e1065[2]);
                                let _e1084 = local_2.member[0u];
                                let _e1090 = select(_e1084[0], -(_e1084[0]), (_e1084[0] < 0f));
                                let _e1093 = select(_e1084[1], -(_e1084[1]), (_e1084[1] < 0f));
                                let _e1095 = select(_e1093, _e1090, (_e1090 > _e1093));
                                let _e1098 = select(_e1084[2], -(_e1084[2]), (_e1084[2] < 0f));
                                let _e1100 = select(_e1098, _e1095, (_e1095 > _e1098));
                                let _e1103 = local_2.member[1u];
                                let _e1109 = select(_e1103[0], -(_e1103[0]), (_e1103[0] < 0f));
                                let _e1112 = select(_e1103[1], -(_e1103[1]), (_e1103[1] < 0f));
                                let _e1114 = select(_e1112, _e1109, (_e1109 > _e1112));
                                let _e1117 = select(_e1103[2], -(_e1103[2]), (_e1103[2] < 0f));
                                let _e1119 = select(_e1117, _e1114, (_e1114 > _e1117));
                                let _e1123 = local_2.member_3;
                                let _e1127 = local_2.member_1[0u];
                                let _e1133 = select(_e1127[0], -(_e1127[0]), (_e1127[0] < 0f));
                                let _e1136 = select(_e1127[1], -(_e1127[1]), (_e1127[1] < 0f));
                                let _e1138 = select(_e1136, _e1133, (_e1133 > _e1136));
                                let _e1141 = select(_e1127[2], -(_e1127[2]), (_e1127[2] < 0f));
                                let _e1143 = select(_e1141, _e1138, (_e1138 > _e1141));
                                let _e1146 = local_2.member_1[1u];
                                let _e1152 = select(_e1146[0], -(_e1146[0]), (_e1146[0] < 0f));
                                let _e1155 = select(_e1146[1], -(_e1146[1]), (_e1146[1] < 0f));
                                let _e1157 = select(_e1155, _e1152, (_e1152 > _e1155));
                                let _e1160 = select(_e1146[2], -(_e1146[2]), (_e1146[2] < 0f));
                                let _e1162 = select(_e1160, _e1157, (_e1157 > _e1160));
                                let _e1166 = local_2.member_3;
                                let _e1170 = local_2.member_2[0u];
                                let _e1176 = select(_e1170[0], -(_e1170[0]), (_e1170[0] < 0f));
                                let _e1179 = select(_e1170[1], -(_e1170[1]), (_e1170[1] < 0f));
                                let _e1181 = select(_e1179, _e1176, (_e1176 > _e1179));
                                let _e1184 = select(_e1170[2], -(_e1170[2]), (_e1170[2] < 0f));
                                let _e1186 = select(_e1184, _e1181, (_e1181 > _e1184));
                                let _e1189 = local_2.member_2[1u];
                                let _e1195 = select(_e1189[0], -(_e1189[0]), (_e1189[0] < 0f));
                                let _e1198 = select(_e1189[1], -(_e1189[1]), (_e1189[1] < 0f));
                                let _e1200 = select(_e1198, _e1195, (_e1195 > _e1198));
                                let _e1203 = select(_e1189[2], -(_e1189[2]), (_e1189[2] < 0f));
                                let _e1205 = select(_e1203, _e1200, (_e1200 > _e1203));
                                let _e1209 = local_2.member_3;
                                let _e1213 = ((((select(_e1119, _e1100, (_e1100 > _e1119)) + _e1123) + (select(_e1162, _e1143, (_e1143 > _e1162)) + _e1166)) + (select(_e1205, _e1186, (_e1186 > _e1205)) + _e1209)) * 2f);
                                let _e1216 = local_2.member_3;
                                let _e1220 = (((_e60.member_5 * 1.0001f) + (_e1216 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                let _e1223 = ((_e1016 * _e995) - (_e1019 * _e994));
                                let _e1226 = ((_e1019 * _e993) - (_e1013 * _e995));
                                let _e1229 = ((_e1013 * _e994) - (_e1016 * _e993));
                                let _e1234 = (((_e1223 * _e1022[0]) + (_e1226 * _e1022[1])) + (_e1229 * _e1022[2]));
                                let _e1239 = (((_e1223 * _e1038) + (_e1226 * _e1039)) + (_e1229 * _e1040));
                                let _e1244 = (((_e1223 * _e1048) + (_e1226 * _e1049)) + (_e1229 * _e1050));
                                let _e1249 = (((_e1223 * _e1045) + (_e1226 * _e1046)) + (_e1229 * _e1047));
                                let _e1254 = (((_e1223 * _e1053[0]) + (_e1226 * _e1053[1])) + (_e1229 * _e1053[2]));
                                let _e1259 = (((_e1223 * _e1069) + (_e1226 * _e1070)) + (_e1229 * _e1071));
                                let _e1264 = (((_e1223 * _e1079) + (_e1226 * _e1080)) + (_e1229 * _e1081));
                                let _e1269 = (((_e1223 * _e1076) + (_e1226 * _e1077)) + (_e1229 * _e1078));
                                let _e1271 = select(_e1239, _e1234, (_e1234 < _e1239));
                                let _e1273 = select(_e1249, _e1244, (_e1244 < _e1249));
                                let _e1275 = select(_e1273, _e1271, (_e1271 < _e1273));
                                let _e1277 = select(_e1259, _e1254, (_e1254 < _e1259));
                                let _e1279 = select(_e1269, _e1264, (_e1264 < _e1269));
                                let _e1281 = select(_e1279, _e1277, (_e1277 < _e1279));
                                let _e1283 = select(_e1281, _e1275, (_e1275 < _e1281));
                                let _e1285 = select(_e1239, _e1234, (_e1234 > _e1239));
                                let _e1287 = select(_e1249, _e1244, (_e1244 > _e1249));
                                let _e1289 = select(_e1287, _e1285, (_e1285 > _e1287));
                                let _e1291 = select(_e1259, _e1254, (_e1254 > _e1259));
                                let _e1293 = select(_e1269, _e1264, (_e1264 > _e1269));
                                let _e1295 = select(_e1293, _e1291, (_e1291 > _e1293));
                                let _e1308 = ((select(_e1223, -(_e1223), (_e1223 < 0f)) + select(_e1226, -(_e1226), (_e1226 < 0f))) + select(_e1229, -(_e1229), (_e1229 < 0f)));
                                let _e1313 = -(select(_e1295, _e1289, (_e1289 > _e1295)));
                                let _e1320 = (((select(_e1313, _e1283, (_e1283 > _e1313)) - ((_e1308 * _e1213) * (0.000000059604645f * (17f / 2f)))) - (_e1308 * _e1220)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                let _e1323 = ((_e1016 * _e1010) - (_e1019 * _e1009));
                                let _e1326 = ((_e1019 * _e1008) - (_e1013 * _e1010));
                                let _e1329 = ((_e1013 * _e1009) - (_e1016 * _e1008));
                                let _e1334 = (((_e1323 * _e1022[0]) + (_e1326 * _e1022[1])) + (_e1329 * _e1022[2]));
                                let _e1339 = (((_e1323 * _e1038) + (_e1326 * _e1039)) + (_e1329 * _e1040));
                                let _e1344 = (((_e1323 * _e1048) + (_e1326 * _e1049)) + (_e1329 * _e1050));
                                let _e1349 = (((_e1323 * _e1045) + (_e1326 * _e1046)) + (_e1329 * _e1047));
                                let _e1354 = (((_e1323 * _e1053[0]) + (_e1326 * _e1053[1])) + (_e1329 * _e1053[2]));
                                let _e1359 = (((_e1323 * _e1069) + (_e1326 * _e1070)) + (_e1329 * _e1071));
                                let _e1364 = (((_e1323 * _e1079) + (_e1326 * _e1080)) + (_e1329 * _e1081));
                                let _e1369 = (((_e1323 * _e1076) + (_e1326 * _e1077)) + (_e1329 * _e1078));
                                let _e1371 = select(_e1339, _e1334, (_e1334 < _e1339));
                                let _e1373 = select(_e1349, _e1344, (_e1344 < _e1349));
                                let _e1375 = select(_e1373, _e1371, (_e1371 < _e1373));
                                let _e1377 = select(_e1359, _e1354, (_e1354 < _e1359));
                                let _e1379 = select(_e1369, _e1364, (_e1364 < _e1369));
                                let _e1381 = select(_e1379, _e1377, (_e1377 < _e1379));
                                let _e1383 = select(_e1381, _e1375, (_e1375 < _e1381));
                                let _e1385 = select(_e1339, _e1334, (_e1334 > _e1339));
                                let _e1387 = select(_e1349, _e1344, (_e1344 > _e1349));
                                let _e1389 = select(_e1387, _e1385, (_e1385 > _e1387));
                                let _e1391 = select(_e1359, _e1354, (_e1354 > _e1359));
                                let _e1393 = select(_e1369, _e1364, (_e1364 > _e1369));
                                let _e1395 = select(_e1393, _e1391, (_e1391 > _e1393));
                                let _e1408 = ((select(_e1323, -(_e1323), (_e1323 < 0f)) + select(_e1326, -(_e1326), (_e1326 < 0f))) + select(_e1329, -(_e1329), (_e1329 < 0f)));
                                let _e1413 = -(select(_e1395, _e1389, (_e1389 > _e1395)));
                                let _e1420 = (((select(_e1413, _e1383, (_e1383 > _e1413)) - ((_e1408 * _e1213) * (0.000000059604645f * (17f / 2f)))) - (_e1408 * _e1220)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                let _e1422 = select(_e1420, _e1320, (_e1320 > _e1420));
                                if (_e188.member == 0u) {
                                    let _e1424 = (_e1008 - _e993);
                                    let _e1425 = (_e1009 - _e994);
                                    let _e1426 = (_e1010 - _e995);
                                    let _e1429 = ((_e1016 * _e1426) - (_e1019 * _e1425));
                                    let _e1432 = ((_e1019 * _e1424) - (_e1013 * _e1426));
                                    let _e1435 = ((_e1013 * _e1425) - (_e1016 * _e1424));
                                    let _e1440 = (((_e1429 * _e1022[0]) + (_e1432 * _e1022[1])) + (_e1435 * _e1022[2]));
                                    let _e1445 = (((_e1429 * _e1038) + (_e1432 * _e1039)) + (_e1435 * _e1040));
                                    let _e1450 = (((_e1429 * _e1048) + (_e1432 * _e1049)) + (_e1435 * _e1050));
                                    let _e1455 = (((_e1429 * _e1045) + (_e1432 * _e1046)) + (_e1435 * _e1047));
                                    let _e1460 = (((_e1429 * _e1053[0]) + (_e1432 * _e1053[1])) + (_e1435 * _e1053[2]));
                                    let _e1465 = (((_e1429 * _e1069) + (_e1432 * _e1070)) + (_e1435 * _e1071));
                                    let _e1470 = (((_e1429 * _e1079) + (_e1432 * _e1080)) + (_e1435 * _e1081));
                                    let _e1475 = (((_e1429 * _e1076) + (_e1432 * _e1077)) + (_e1435 * _e1078));
                                    let _e1477 = select(_e1445, _e1440, (_e1440 < _e1445));
                                    let _e1479 = select(_e1455, _e1450, (_e1450 < _e1455));
                                    let _e1481 = select(_e1479, _e1477, (_e1477 < _e1479));
                                    let _e1483 = select(_e1465, _e1460, (_e1460 < _e1465));
                                    let _e1485 = select(_e1475, _e1470, (_e1470 < _e1475));
                                    let _e1487 = select(_e1485, _e1483, (_e1483 < _e1485));
                                    let _e1489 = select(_e1487, _e1481, (_e1481 < _e1487));
                                    let _e1491 = select(_e1445, _e1440, (_e1440 > _e1445));
                                    let _e1493 = select(_e1455, _e1450, (_e1450 > _e1455));
                                    let _e1495 = select(_e1493, _e1491, (_e1491 > _e1493));
                                    let _e1497 = select(_e1465, _e1460, (_e1460 > _e1465));
                                    let _e1499 = select(_e1475, _e1470, (_e1470 > _e1475));
                                    let _e1501 = select(_e1499, _e1497, (_e1497 > _e1499));
                                    let _e1514 = ((select(_e1429, -(_e1429), (_e1429 < 0f)) + select(_e1432, -(_e1432), (_e1432 < 0f))) + select(_e1435, -(_e1435), (_e1435 < 0f)));
                                    let _e1519 = -(select(_e1501, _e1495, (_e1495 > _e1501)));
                                    let _e1526 = (((select(_e1519, _e1489, (_e1489 > _e1519)) - ((_e1514 * _e1213) * (0.000000059604645f * (17f / 2f)))) - (_e1514 * _e1220)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    phi_2443_ = select(_e1526, _e1422, (_e1422 > _e1526));
                                } else {
                                    phi_2443_ = _e1422;
                                }
                                let _e1530 = phi_2443_;
                                phi_2446_ = (_e980 || (_e1530 > 0f));
                            }
                            let _e1534 = phi_2446_;
                            if _e1534 {
                            } else {
                                let _e1536 = atomicAdd((&counters[0u]), 1u);
                                left[_e1536].member = _e157;
                                left[_e1536].member_1 = _e160;
                            }
                        }
                        phi_2455_ = true;
                    }
                    let _e1541 = phi_2455_;
                    phi_2456_ = _e1541;
                } else {
                    phi_2456_ = false;
                }
                let _e1543 = phi_2456_;
                continue;
                continuing {
                    phi_281_ = type_9(select(_e129.member, (_e129.member + 1u), _e132), select(_e129.member_1, _e129.member_1, _e132));
                    break if !(_e1543);
                }
            }
            workgroupBarrier();
            let _e1546 = atomicLoad((&counters[0u]));
            phi_2461_ = type_9(0u, 4u);
            loop {
                let _e1548 = phi_2461_;
                let _e1551 = (_e1548.member < _e1548.member_1);
                if (bitcast<i32>(select(0u, 1u, _e1551)) != 0i) {
                    let _e1566 = ((select(type_9().member_1, _e1548.member, _e1551) * 128u) + _e45);
                    if (_e1566 >= _e1546) {
                        phi_6073_ = false;
                    } else {
                        let _e1570 = left[_e1566].member;
                        let _e1572 = left[_e1566].member_1;
                        if (_e63 == 0u) {
                            let _e1588 = (3u * _e1572);
                            let _e1590 = elements.member[_e1588];
                            let _e1593 = elements.member[(_e1588 + 1u)];
                            let _e1596 = elements.member[(_e1588 + 2u)];
                            phi_2589_ = type_18(0u, array<u32, 4>(_e1570, _e1590, _e1593, _e1596));
                        } else {
                            let _e1574 = (2u * _e1570);
                            let _e1575 = (2u * _e1572);
                            let _e1577 = elements.member[_e1574];
                            let _e1579 = elements.member[_e1575];
                            let _e1582 = elements.member[(_e1574 + 1u)];
                            let _e1585 = elements.member[(_e1575 + 1u)];
                            phi_2589_ = type_18(1u, array<u32, 4>(_e1577, _e1582, _e1579, _e1585));
                        }
                        let _e1600 = phi_2589_;
                        let _e1605 = paths.member[_e1600.member_1[0]];
                        let _e1620 = paths.member[_e1600.member_1[1]];
                        let _e1635 = paths.member[_e1600.member_1[2]];
                        let _e1650 = paths.member[_e1600.member_1[3]];
                        if (_e1600.member != 0u) {
                            phi_2722_ = type_23(array<array<f32, 3>, 2>(array<f32, 3>((_e1635.member.x - _e1605.member.x), (_e1635.member.y - _e1605.member.y), (_e1635.member.z - _e1605.member.z)), array<f32, 3>((_e1635.member_1.x - _e1605.member_1.x), (_e1635.member_1.y - _e1605.member_1.y), (_e1635.member_1.z - _e1605.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e1620.member.x - _e1605.member.x), (_e1620.member.y - _e1605.member.y), (_e1620.member.z - _e1605.member.z)), array<f32, 3>((_e1620.member_1.x - _e1605.member_1.x), (_e1620.member_1.y - _e1605.member_1.y), (_e1620.member_1.z - _e1605.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e1635.member.x - _e1650.member.x), (_e1635.member.y - _e1650.member.y), (_e1635.member.z - _e1650.member.z)), array<f32, 3>((_e1635.member_1.x - _e1650.member_1.x), (_e1635.member_1.y - _e1650.member_1.y), (_e1635.member_1.z - _e1650.member_1.z))), (_e60.member_4 + _e60.member_4));
                        } else {
                            phi_2722_ = type_23(array<array<f32, 3>, 2>(array<f32, 3>((_e1605.member.x - _e1620.member.x), (_e1605.member.y - _e1620.member.y), (_e1605.member.z - _e1620.member.z)), array<f32, 3>((_e1605.member_1.x - _e1620.member_1.x), (_e1605.member_1.y - _e1620.member_1.y), (_e1605.member_1.z - _e1620.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e1635.member.x - _e1620.member.x), (_e1635.member.y - _e1620.member.y), (_e1635.member.z - _e1620.member.z)), array<f32, 3>((_e1635.member_1.x - _e1620.member_1.x), (_e1635.member_1.y - _e1620.member_1.y), (_e1635.member_1.z - _e1620.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e1650.member.x - _e1620.member.x), (_e1650.member.y - _e1620.member.y), (_e1650.member.z - _e1620.member.z)), array<f32, 3>((_e1650.member_1.x - _e1620.member_1.x), (_e1650.member_1.y - _e1620.member_1.y), (_e1650.member_1.z - _e1620.member_1.z))), (_e60.member_4 + _e60.member_4));
                        }
                        let _e1723 = phi_2722_;
                        let _e1737 = ((_e1723.member[0][0] + _e1723.member[1][0]) * 0.5f);
                        let _e1738 = ((_e1723.member[0][1] + _e1723.member[1][1]) * 0.5f);
                        let _e1739 = ((_e1723.member[0][2] + _e1723.member[1][2]) * 0.5f);
                        let _e1753 = ((_e1723.member_1[0][0] + _e1723.member_1[1][0]) * 0.5f);
                        let _e1754 = ((_e1723.member_1[0][1] + _e1723.member_1[1][1]) * 0.5f);
                        let _e1755 = ((_e1723.member_1[0][2] + _e1723.member_1[1][2]) * 0.5f);
                        let _e1769 = ((_e1723.member_2[0][0] + _e1723.member_2[1][0]) * 0.5f);
                        let _e1770 = ((_e1723.member_2[0][1] + _e1723.member_2[1][1]) * 0.5f);
                        let _e1771 = ((_e1723.member_2[0][2] + _e1723.member_2[1][2]) * 0.5f);
                        local = type_23(array<array<f32, 3>, 2>(array<f32, 3>(_e1723.member[0][0], _e1723.member[0][1], _e1723.member[0][2]), array<f32, 3>(_e1737, _e1738, _e1739)), array<array<f32, 3>, 2>(array<f32, 3>(_e1723.member_1[0][0], _e1723.member_1[0][1], _e1723.member_1[0][2]), array<f32, 3>(_e1753, _e1754, _e1755)), array<array<f32, 3>, 2>(array<f32, 3>(_e1723.member_2[0][0], _e1723.member_2[0][1], _e1723.member_2[0][2]), array<f32, 3>(_e1769, _e1770, _e1771)), _e1723.member_3);
                        local_1 = type_23(array<array<f32, 3>, 2>(array<f32, 3>(_e1737, _e1738, _e1739), array<f32, 3>(_e1723.member[1][0], _e1723.member[1][1], _e1723.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e1753, _e1754, _e1755), array<f32, 3>(_e1723.member_1[1][0], _e1723.member_1[1][1], _e1723.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e1769, _e1770, _e1771), array<f32, 3>(_e1723.member_2[1][0], _e1723.member_2[1][1], _e1723.member_2[1][2])), _e1723.member_3);
                        let _e1826 = local.member_1[0u];
                        let _e1832 = local.member_2[0u];
                        let _e1838 = ((_e1826[1] * _e1832[2]) - (_e1826[2] * _e1832[1]));
                        let _e1841 = ((_e1826[2] * _e1832[0]) - (_e1826[0] * _e1832[2]));
                        let _e1844 = ((_e1826[0] * _e1832[1]) - (_e1826[1] * _e1832[0]));
                        let _e1847 = local.member_1[1u];
                        let _e1853 = local.member_2[1u];
                        let _e1859 = ((_e1847[1] * _e1853[2]) - (_e1847[2] * _e1853[1]));
                        let _e1862 = ((_e1847[2] * _e1853[0]) - (_e1847[0] * _e1853[2]));
                        let _e1865 = ((_e1847[0] * _e1853[1]) - (_e1847[1] * _e1853[0]));
                        let _e1868 = local.member_1[0u];
                        let _e1874 = local.member_2[1u];
                        let _e1889 = local.member_1[1u];
                        let _e1895 = local.member_2[0u];
                        let _e1908 = (((_e1868[1] * _e1874[2]) - (_e1868[2] * _e1874[1])) + ((_e1889[1] * _e1895[2]) - (_e1889[2] * _e1895[1])));
                        let _e1909 = (((_e1868[2] * _e1874[0]) - (_e1868[0] * _e1874[2])) + ((_e1889[2] * _e1895[0]) - (_e1889[0] * _e1895[2])));
                        let _e1910 = (((_e1868[0] * _e1874[1]) - (_e1868[1] * _e1874[0])) + ((_e1889[0] * _e1895[1]) - (_e1889[1] * _e1895[0])));
                        let _e1913 = local.member[0u];
                        let _e1924 = local.member[1u];
                        let _e1935 = local.member[0u];
                        let _e1944 = ((((_e1924[0] * _e1838) + (_e1924[1] * _e1841)) + (_e1924[2] * _e1844)) + (((_e1935[0] * _e1908) + (_e1935[1] * _e1909)) + (_e1935[2] * _e1910)));
                        let _e1947 = local.member[0u];
                        let _e1958 = local.member[1u];
                        let _e1967 = ((((_e1947[0] * _e1859) + (_e1947[1] * _e1862)) + (_e1947[2] * _e1865)) + (((_e1958[0] * _e1908) + (_e1958[1] * _e1909)) + (_e1958[2] * _e1910)));
                        let _e1970 = local.member[1u];
                        let _e1981 = local.member[0u];
                        let _e1987 = select(_e1981[0], -(_e1981[0]), (_e1981[0] < 0f));
                        let _e1990 = select(_e1981[1], -(_e1981[1]), (_e1981[1] < 0f));
                        let _e1992 = select(_e1990, _e1987, (_e1987 > _e1990));
                        let _e1995 = select(_e1981[2], -(_e1981[2]), (_e1981[2] < 0f));
                        let _e1997 = select(_e1995, _e1992, (_e1992 > _e1995));
                        let _e2000 = local.member[1u];
                        let _e2006 = select(_e2000[0], -(_e2000[0]), (_e2000[0] < 0f));
                        let _e2009 = select(_e2000[1], -(_e2000[1]), (_e2000[1] < 0f));
                        let _e2011 = select(_e2009, _e2006, (_e2006 > _e2009));
                        let _e2014 = select(_e2000[2], -(_e2000[2]), (_e2000[2] < 0f));
                        let _e2016 = select(_e2014, _e2011, (_e2011 > _e2014));
                        let _e2020 = local.member_3;
                        let _e2021 = (select(_e2016, _e1997, (_e1997 > _e2016)) + _e2020);
                        let _e2024 = local.member_1[0u];
                        let _e2030 = select(_e2024[0], -(_e2024[0]), (_e2024[0] < 0f));
                        let _e2033 = select(_e2024[1], -(_e2024[1]), (_e2024[1] < 0f));
                        let _e2035 = select(_e2033, _e2030, (_e2030 > _e2033));
                        let _e2038 = select(_e2024[2], -(_e2024[2]), (_e2024[2] < 0f));
                        let _e2040 = select(_e2038, _e2035, (_e2035 > _e2038));
                        let _e2043 = local.member_1[1u];
                        let _e2049 = select(_e2043[0], -(_e2043[0]), (_e2043[0] < 0f));
                        let _e2052 = select(_e2043[1], -(_e2043[1]), (_e2043[1] < 0f));
                        let _e2054 = select(_e2052, _e2049, (_e2049 > _e2052));
                        let _e2057 = select(_e2043[2], -(_e2043[2]), (_e2043[2] < 0f));
                        let _e2059 = select(_e2057, _e2054, (_e2054 > _e2057));
                        let _e2063 = local.member_3;
                        let _e2064 = (select(_e2059, _e2040, (_e2040 > _e2059)) + _e2063);
                        let _e2067 = local.member_2[0u];
                        let _e2073 = select(_e2067[0], -(_e2067[0]), (_e2067[0] < 0f));
                        let _e2076 = select(_e2067[1], -(_e2067[1]), (_e2067[1] < 0f));
                        let _e2078 = select(_e2076, _e2073, (_e2073 > _e2076));
                        let _e2081 = select(_e2067[2], -(_e2067[2]), (_e2067[2] < 0f));
                        let _e2083 = select(_e2081, _e2078, (_e2078 > _e2081));
                        let _e2086 = local.member_2[1u];
                        let _e2092 = select(_e2086[0], -(_e2086[0]), (_e2086[0] < 0f));
                        let _e2095 = select(_e2086[1], -(_e2086[1]), (_e2086[1] < 0f));
                        let _e2097 = select(_e2095, _e2092, (_e2092 > _e2095));
                        let _e2100 = select(_e2086[2], -(_e2086[2]), (_e2086[2] < 0f));
                        let _e2102 = select(_e2100, _e2097, (_e2097 > _e2100));
                        let _e2106 = local.member_3;
                        let _e2107 = (select(_e2102, _e2083, (_e2083 > _e2102)) + _e2106);
                        let _e2109 = ((_e2064 * 8f) * _e2107);
                        let _e2116 = local.member_3;
                        let _e2140 = ((select(_e1838, -(_e1838), (_e1838 < 0f)) + select(_e1841, -(_e1841), (_e1841 < 0f))) + select(_e1844, -(_e1844), (_e1844 < 0f)));
                        let _e2151 = ((select(_e1859, -(_e1859), (_e1859 < 0f)) + select(_e1862, -(_e1862), (_e1862 < 0f))) + select(_e1865, -(_e1865), (_e1865 < 0f)));
                        let _e2153 = select(_e2151, _e2140, (_e2140 > _e2151));
                        let _e2165 = (((select(_e1908, -(_e1908), (_e1908 < 0f)) + select(_e1909, -(_e1909), (_e1909 < 0f))) + select(_e1910, -(_e1910), (_e1910 < 0f))) * 0.5f);
                        let _e2172 = local.member_3;
                        let _e2185 = ((((_e1913[0] * _e1838) + (_e1913[1] * _e1841)) + (_e1913[2] * _e1844)) * 3f);
                        let _e2186 = ((((_e1970[0] * _e1859) + (_e1970[1] * _e1862)) + (_e1970[2] * _e1865)) * 3f);
                        let _e2188 = select(_e2186, _e2185, (_e2185 < _e2186));
                        let _e2190 = select(_e1967, _e1944, (_e1944 < _e1967));
                        let _e2192 = select(_e2190, _e2188, (_e2188 < _e2190));
                        let _e2194 = select(_e2186, _e2185, (_e2185 > _e2186));
                        let _e2196 = select(_e1967, _e1944, (_e1944 > _e1967));
                        let _e2203 = -(select(_e2196, _e2194, (_e2194 > _e2196)));
                        let _e2207 = ((select(_e2203, _e2192, (_e2192 > _e2203)) - ((((((_e2021 * 8f) * _e2109) * (0.000000059604645f * (524f / 64f))) + ((_e2116 * 19f) * ((_e2021 * (_e2064 + _e2107)) + (_e2064 * _e2107)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2021) * ((1f + _e2064) * (1f + _e2107))))) + ((_e60.member_5 * (((select(_e2165, _e2153, (_e2153 > _e2165)) + (_e2109 * (0.000000059604645f * 8f))) + ((_e2172 * 6f) * (_e2064 + _e2107))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2064) * (1f + _e2107))))) * (3f * 1.0001f)))) > 0f);
                        if _e2207 {
                            phi_4459_ = _e2207;
                        } else {
                            let _e2210 = local.member_1[0u];
                            let _e2216 = local.member_1[1u];
                            let _e2220 = (_e2210[0] + _e2216[0]);
                            let _e2221 = (_e2210[1] + _e2216[1]);
                            let _e2222 = (_e2210[2] + _e2216[2]);
                            let _e2225 = local.member_2[0u];
                            let _e2231 = local.member_2[1u];
                            let _e2235 = (_e2225[0] + _e2231[0]);
                            let _e2236 = (_e2225[1] + _e2231[1]);
                            let _e2237 = (_e2225[2] + _e2231[2]);
                            let _e2240 = ((_e2221 * _e2237) - (_e2222 * _e2236));
                            let _e2243 = ((_e2222 * _e2235) - (_e2220 * _e2237));
                            let _e2246 = ((_e2220 * _e2236) - (_e2221 * _e2235));
                            let _e2249 = local.member[0u];
                            let _e2255 = local.member_1[0u];
                            let _e2261 = local.member_2[0u];
                            let _e2265 = (_e2249[0] - _e2255[0]);
                            let _e2266 = (_e2249[1] - _e2255[1]);
                            let _e2267 = (_e2249[2] - _e2255[2]);
                            let _e2268 = (_e1600.member == 0u);
                            let _e2272 = select((_e2265 - _e2261[0]), _e2249[0], _e2268);
                            let _e2273 = select((_e2266 - _e2261[1]), _e2249[1], _e2268);
                            let _e2274 = select((_e2267 - _e2261[2]), _e2249[2], _e2268);
                            let _e2275 = (_e2249[0] - _e2261[0]);
                            let _e2276 = (_e2249[1] - _e2261[1]);
                            let _e2277 = (_e2249[2] - _e2261[2]);
                            let _e2280 = local.member[1u];
                            let _e2286 = local.member_1[1u];
                            let _e2292 = local.member_2[1u];
                            let _e2296 = (_e2280[0] - _e2286[0]);
                            let _e2297 = (_e2280[1] - _e2286[1]);
                            let _e2298 = (_e2280[2] - _e2286[2]);
                            let _e2299 = (_e1600.member == 0u);
                            let _e2303 = select((_e2296 - _e2292[0]), _e2280[0], _e2299);
                            let _e2304 = select((_e2297 - _e2292[1]), _e2280[1], _e2299);
                            let _e2305 = select((_e2298 - _e2292[2]), _e2280[2], _e2299);
                            let _e2306 = (_e2280[0] - _e2292[0]);
                            let _e2307 = (_e2280[1] - _e2292[1]);
                            let _e2308 = (_e2280[2] - _e2292[2]);
                            let _e2311 = local.member[0u];
                            let _e2317 = select(_e2311[0], -(_e2311[0]), (_e2311[0] < 0f));
                            let _e2320 = select(_e2311[1], -(_e2311[1]), (_e2311[1] < 0f));
                            let _e2322 = select(_e2320, _e2317, (_e2317 > _e2320));
                            let _e2325 = select(_e2311[2], -(_e2311[2]), (_e2311[2] < 0f));
                            let _e2327 = select(_e2325, _e2322, (_e2322 > _e2325));
                            let _e2330 = local.member[1u];
                            let _e2336 = select(_e2330[0], -(_e2330[0]), (_e2330[0] < 0f));
                            let _e2339 = select(_e2330[1], -(_e2330[1]), (_e2330[1] < 0f));
                            let _e2341 = select(_e2339, _e2336, (_e2336 > _e2339));
                            let _e2344 = select(_e2330[2], -(_e2330[2]), (_e2330[2] < 0f));
                            let _e2346 = select(_e2344, _e2341, (_e2341 > _e2344));
                            let _e2350 = local.member_3;
                            let _e2354 = local.member_1[0u];
                            let _e2360 = select(_e2354[0], -(_e2354[0]), (_e2354[0] < 0f));
                            let _e2363 = select(_e2354[1], -(_e2354[1]), (_e2354[1] < 0f));
                            let _e2365 = select(_e2363, _e2360, (_e2360 > _e2363));
                            let _e2368 = select(_e2354[2], -(_e2354[2]), (_e2354[2] < 0f));
                            let _e2370 = select(_e2368, _e2365, (_e2365 > _e2368));
                            let _e2373 = local.member_1[1u];
                            let _e2379 = select(_e2373[0], -(_e2373[0]), (_e2373[0] < 0f));
                            let _e2382 = select(_e2373[1], -(_e2373[1]), (_e2373[1] < 0f));
                            let _e2384 = select(_e2382, _e2379, (_e2379 > _e2382));
                            let _e2387 = select(_e2373[2], -(_e2373[2]), (_e2373[2] < 0f));
                            let _e2389 = select(_e2387, _e2384, (_e2384 > _e2387));
                            let _e2393 = local.member_3;
                            let _e2397 = local.member_2[0u];
                            let _e2403 = select(_e2397[0], -(_e2397[0]), (_e2397[0] < 0f));
                            let _e2406 = select(_e2397[1], -(_e2397[1]), (_e2397[1] < 0f));
                            let _e2408 = select(_e2406, _e2403, (_e2403 > _e2406));
                            let _e2411 = select(_e2397[2], -(_e2397[2]), (_e2397[2] < 0f));
                            let _e2413 = select(_e2411, _e2408, (_e2408 > _e2411));
                            let _e2416 = local.member_2[1u];
                            let _e2422 = select(_e2416[0], -(_e2416[0]), (_e2416[0] < 0f));
                            let _e2425 = select(_e2416[1], -(_e2416[1]), (_e2416[1] < 0f));
                            let _e2427 = select(_e2425, _e2422, (_e2422 > _e2425));
                            let _e2430 = select(_e2416[2], -(_e2416[2]), (_e2416[2] < 0f));
                            let _e2432 = select(_e2430, _e2427, (_e2427 > _e2430));
                            let _e2436 = local.member_3;
                            let _e2440 = ((((select(_e2346, _e2327, (_e2327 > _e2346)) + _e2350) + (select(_e2389, _e2370, (_e2370 > _e2389)) + _e2393)) + (select(_e2432, _e2413, (_e2413 > _e2432)) + _e2436)) * 2f);
                            let _e2443 = local.member_3;
                            let _e2447 = (((_e60.member_5 * 1.0001f) + (_e2443 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                            let _e2450 = ((_e2243 * _e2222) - (_e2246 * _e2221));
                            let _e2453 = ((_e2246 * _e2220) - (_e2240 * _e2222));
                            let _e2456 = ((_e2240 * _e2221) - (_e2243 * _e2220));
                            let _e2461 = (((_e2450 * _e2249[0]) + (_e2453 * _e2249[1])) + (_e2456 * _e2249[2]));
                            let _e2466 = (((_e2450 * _e2265) + (_e2453 * _e2266)) + (_e2456 * _e2267));
                            let _e2471 = (((_e2450 * _e2275) + (_e2453 * _e2276)) + (_e2456 * _e2277));
                            let _e2476 = (((_e2450 * _e2272) + (_e2453 * _e2273)) + (_e2456 * _e2274));
                            let _e2481 = (((_e2450 * _e2280[0]) + (_e2453 * _e2280[1])) + (_e2456 * _e2280[2]));
                            let _e2486 = (((_e2450 * _e2296) + (_e2453 * _e2297)) + (_e2456 * _e2298));
                            let _e2491 = (((_e2450 * _e2306) + (_e2453 * _e2307)) + (_e2456 * _e2308));
                            let _e2496 = (((_e2450 * _e2303) + (_e2453 * _e2304)) + (_e2456 * _e2305));
                            let _e2498 = select(_e2466, _e2461, (_e2461 < _e2466));
                            let _e2500 = select(_e2476, _e2471, (_e2471 < _e2476));
                            let _e2502 = select(_e2500, _e2498, (_e2498 < _e2500));
                            let _e2504 = select(_e2486, _e2481, (_e2481 < _e2486));
                            let _e2506 = select(_e2496, _e2491, (_e2491 < _e2496));
                            let _e2508 = select(_e2506, _e2504, (_e2504 < _e2506));
                            let _e2510 = select(_e2508, _e2502, (_e2502 < _e2508));
                            let _e2512 = select(_e2466, _e2461, (_e2461 > _e2466));
                            let _e2514 = select(_e2476, _e2471, (_e2471 > _e2476));
                            let _e2516 = select(_e2514, _e2512, (_e2512 > _e2514));
                            let _e2518 = select(_e2486, _e2481, (_e2481 > _e2486));
                            let _e2520 = select(_e2496, _e2491, (_e2491 > _e2496));
                            let _e2522 = select(_e2520, _e2518, (_e2518 > _e2520));
                            let _e2535 = ((select(_e2450, -(_e2450), (_e2450 < 0f)) + select(_e2453, -(_e2453), (_e2453 < 0f))) + select(_e2456, -(_e2456), (_e2456 < 0f)));
                            let _e2540 = -(select(_e2522, _e2516, (_e2516 > _e2522)));
                            let _e2547 = (((select(_e2540, _e2510, (_e2510 > _e2540)) - ((_e2535 * _e2440) * (0.000000059604645f * (17f / 2f)))) - (_e2535 * _e2447)) - (0.000000000000000000000000000000000000011754944f * 64f));
                            let _e2550 = ((_e2243 * _e2237) - (_e2246 * _e2236));
                            let _e2553 = ((_e2246 * _e2235) - (_e2240 * _e2237));
                            let _e2556 = ((_e2240 * _e2236) - (_e2243 * _e2235));
                            let _e2561 = (((_e2550 * _e2249[0]) + (_e2553 * _e2249[1])) + (_e2556 * _e2249[2]));
                            let _e2566 = (((_e2550 * _e2265) + (_e2553 * _e2266)) + (_e2556 * _e2267));
                            let _e2571 = (((_e2550 * _e2275) + (_e2553 * _e2276)) + (_e2556 * _e2277));
                            let _e2576 = (((_e2550 * _e2272) + (_e2553 * _e2273)) + (_e2556 * _e2274));
                            let _e2581 = (((_e2550 * _e2280[0]) + (_e2553 * _e2280[1])) + (_e2556 * _e2280[2]));
                            let _e2586 = (((_e2550 * _e2296) + (_e2553 * _e2297)) + (_e2556 * _e2298));
                            let _e2591 = (((_e2550 * _e2306) + (_e2553 * _e2307)) + (_e2556 * _e2308));
                            let _e2596 = (((_e2550 * _e2303) + (_e2553 * _e2304)) + (_e2556 * _e2305));
                            let _e2598 = select(_e2566, _e2561, (_e2561 < _e2566));
                            let _e2600 = select(_e2576, _e2571, (_e2571 < _e2576));
                            let _e2602 = select(_e2600, _e2598, (_e2598 < _e2600));
                            let _e2604 = select(_e2586, _e2581, (_e2581 < _e2586));
                            let _e2606 = select(_e2596, _e2591, (_e2591 < _e2596));
                            let _e2608 = select(_e2606, _e2604, (_e2604 < _e2606));
                            let _e2610 = select(_e2608, _e2602, (_e2602 < _e2608));
                            let _e2612 = select(_e2566, _e2561, (_e2561 > _e2566));
                            let _e2614 = select(_e2576, _e2571, (_e2571 > _e2576));
                            let _e2616 = select(_e2614, _e2612, (_e2612 > _e2614));
                            let _e2618 = select(_e2586, _e2581, (_e2581 > _e2586));
                            let _e2620 = select(_e2596, _e2591, (_e2591 > _e2596));
                            let _e2622 = select(_e2620, _e2618, (_e2618 > _e2620));
                            let _e2635 = ((select(_e2550, -(_e2550), (_e2550 < 0f)) + select(_e2553, -(_e2553), (_e2553 < 0f))) + select(_e2556, -(_e2556), (_e2556 < 0f)));
                            let _e2640 = -(select(_e2622, _e2616, (_e2616 > _e2622)));
                            let _e2647 = (((select(_e2640, _e2610, (_e2610 > _e2640)) - ((_e2635 * _e2440) * (0.000000059604645f * (17f / 2f)))) - (_e2635 * _e2447)) - (0.000000000000000000000000000000000000011754944f * 64f));
                            let _e2649 = select(_e2647, _e2547, (_e2547 > _e2647));
                            if (_e1600.member == 0u) {
                                let _e2651 = (_e2235 - _e2220);
                                let _e2652 = (_e2236 - _e2221);
                                let _e2653 = (_e2237 - _e2222);
                                let _e2656 = ((_e2243 * _e2653) - (_e2246 * _e2652));
                                let _e2659 = ((_e2246 * _e2651) - (_e2240 * _e2653));
                                let _e2662 = ((_e2240 * _e2652) - (_e2243 * _e2651));
                                let _e2667 = (((_e2656 * _e2249[0]) + (_e2659 * _e2249[1])) + (_e2662 * _e2249[2]));
                                let _e2672 = (((_e2656 * _e2265) + (_e2659 * _e2266)) + (_e2662 * _e2267));
                                let _e2677 = (((_e2656 * _e2275) + (_e2659 * _e2276)) + (_e2662 * _e2277));
                                let _e2682 = (((_e2656 * _e2272) + (_e2659 * _e2273)) + (_e2662 * _e2274));
                                let _e2687 = (((_e2656 * _e2280[0]) + (_e2659 * _e2280[1])) + (_e2662 * _e2280[2]));
                                let _e2692 = (((_e2656 * _e2296) + (_e2659 * _e2297)) + (_e2662 * _e2298));
                                let _e2697 = (((_e2656 * _e2306) + (_e2659 * _e2307)) + (_e2662 * _e2308));
                                let _e2702 = (((_e2656 * _e2303) + (_e2659 * _e2304)) + (_e2662 * _e2305));
                                let _e2704 = select(_e2672, _e2667, (_e2667 < _e2672));
                                let _e2706 = select(_e2682, _e2677, (_e2677 < _e2682));
                                let _e2708 = select(_e2706, _e2704, (_e2704 < _e2706));
                                let _e2710 = select(_e2692, _e2687, (_e2687 < _e2692));
                                let _e2712 = select(_e2702, _e2697, (_e2697 < _e2702));
                                let _e2714 = select(_e2712, _e2710, (_e2710 < _e2712));
                                let _e2716 = select(_e2714, _e2708, (_e2708 < _e2714));
                                let _e2718 = select(_e2672, _e2667, (_e2667 > _e2672));
                                let _e2720 = select(_e2682, _e2677, (_e2677 > _e2682));
                                let _e2722 = select(_e2720, _e2718, (_e2718 > _e2720));
                                let _e2724 = select(_e2692, _e2687, (_e2687 > _e2692));
                                let _e2726 = select(_e2702, _e2697, (_e2697 > _e2702));
                                let _e2728 = select(_e2726, _e2724, (_e2724 > _e2726));
                                let _e2741 = ((select(_e2656, -(_e2656), (_e2656 < 0f)) + select(_e2659, -(_e2659), (_e2659 < 0f))) + select(_e2662, -(_e2662), (_e2662 < 0f)));
                                let _e2746 = -(select(_e2728, _e2722, (_e2722 > _e2728)));
                                let _e2753 = (((select(_e2746, _e2716, (_e2716 > _e2746)) - ((_e2741 * _e2440) * (0.000000059604645f * (17f / 2f)))) - (_e2741 * _e2447)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                phi_4456_ = select(_e2753, _e2649, (_e2649 > _e2753));
                            } else {
                                phi_4456_ = _e2649;
                            }
                            let _e2757 = phi_4456_;
                            phi_4459_ = (_e2207 || (_e2757 > 0f));
                        }
                        let _e2761 = phi_4459_;
                        if _e2761 {
                            let _e2764 = local_1.member_1[0u];
                            let _e2770 = local_1.member_2[0u];
                            let _e2776 = ((_e2764[1] * _e2770[2]) - (_e2764[2] * _e2770[1]));
                            let _e2779 = ((_e2764[2] * _e2770[0]) - (_e2764[0] * _e2770[2]));
                            let _e2782 = ((_e2764[0] * _e2770[1]) - (_e2764[1] * _e2770[0]));
                            let _e2785 = local_1.member_1[1u];
                            let _e2791 = local_1.member_2[1u];
                            let _e2797 = ((_e2785[1] * _e2791[2]) - (_e2785[2] * _e2791[1]));
                            let _e2800 = ((_e2785[2] * _e2791[0]) - (_e2785[0] * _e2791[2]));
                            let _e2803 = ((_e2785[0] * _e2791[1]) - (_e2785[1] * _e2791[0]));
                            let _e2806 = local_1.member_1[0u];
                            let _e2812 = local_1.member_2[1u];
                            let _e2827 = local_1.member_1[1u];
                            let _e2833 = local_1.member_2[0u];
                            let _e2846 = (((_e2806[1] * _e2812[2]) - (_e2806[2] * _e2812[1])) + ((_e2827[1] * _e2833[2]) - (_e2827[2] * _e2833[1])));
                            let _e2847 = (((_e2806[2] * _e2812[0]) - (_e2806[0] * _e2812[2])) + ((_e2827[2] * _e2833[0]) - (_e2827[0] * _e2833[2])));
                            let _e2848 = (((_e2806[0] * _e2812[1]) - (_e2806[1] * _e2812[0])) + ((_e2827[0] * _e2833[1]) - (_e2827[1] * _e2833[0])));
                            let _e2851 = local_1.member[0u];
                            let _e2862 = local_1.member[1u];
                            let _e2873 = local_1.member[0u];
                            let _e2882 = ((((_e2862[0] * _e2776) + (_e2862[1] * _e2779)) + (_e2862[2] * _e2782)) + (((_e2873[0] * _e2846) + (_e2873[1] * _e2847)) + (_e2873[2] * _e2848)));
                            let _e2885 = local_1.member[0u];
                            let _e2896 = local_1.member[1u];
                            let _e2905 = ((((_e2885[0] * _e2797) + (_e2885[1] * _e2800)) + (_e2885[2] * _e2803)) + (((_e2896[0] * _e2846) + (_e2896[1] * _e2847)) + (_e2896[2] * _e2848)));
                            let _e2908 = local_1.member[1u];
                            let _e2919 = local_1.member[0u];
                            let _e2925 = select(_e2919[0], -(_e2919[0]), (_e2919[0] < 0f));
                            let _e2928 = select(_e2919[1], -(_e2919[1]), (_e2919[1] < 0f));
                            let _e2930 = select(_e2928, _e2925, (_e2925 > _e2928));
                            let _e2933 = select(_e2919[2], -(_e2919[2]), (_e2919[2] < 0f));
                            let _e2935 = select(_e2933, _e2930, (_e2930 > _e2933));
                            let _e2938 = local_1.member[1u];
                            let _e2944 = select(_e2938[0], -(_e2938[0]), (_e2938[0] < 0f));
                            let _e2947 = select(_e2938[1], -(_e2938[1]), (_e2938[1] < 0f));
                            let _e2949 = select(_e2947, _e2944, (_e2944 > _e2947));
                            let _e2952 = select(_e2938[2], -(_e2938[2]), (_e2938[2] < 0f));
                            let _e2954 = select(_e2952, _e2949, (_e2949 > _e2952));
                            let _e2958 = local_1.member_3;
                            let _e2959 = (select(_e2954, _e2935, (_e2935 > _e2954)) + _e2958);
                            let _e2962 = local_1.member_1[0u];
                            let _e2968 = select(_e2962[0], -(_e2962[0]), (_e2962[0] < 0f));
                            let _e2971 = select(_e2962[1], -(_e2962[1]), (_e2962[1] < 0f));
                            let _e2973 = select(_e2971, _e2968, (_e2968 > _e2971));
                            let _e2976 = select(_e2962[2], -(_e2962[2]), (_e2962[2] < 0f));
                            let _e2978 = select(_e2976, _e2973, (_e2973 > _e2976));
                            let _e2981 = local_1.member_1[1u];
                            let _e2987 = select(_e2981[0], -(_e2981[0]), (_e2981[0] < 0f));
                            let _e2990 = select(_e2981[1], -(_e2981[1]), (_e2981[1] < 0f));
                            let _e2992 = select(_e2990, _e2987, (_e2987 > _e2990));
                            let _e2995 = select(_e2981[2], -(_e2981[2]), (_e2981[2] < 0f));
                            let _e2997 = select(_e2995, _e2992, (_e2992 > _e2995));
                            let _e3001 = local_1.member_3;
                            let _e3002 = (select(_e2997, _e2978, (_e2978 > _e2997)) + _e3001);
                            let _e3005 = local_1.member_2[0u];
                            let _e3011 = select(_e3005[0], -(_e3005[0]), (_e3005[0] < 0f));
                            let _e3014 = select(_e3005[1], -(_e3005[1]), (_e3005[1] < 0f));
                            let _e3016 = select(_e3014, _e3011, (_e3011 > _e3014));
                            let _e3019 = select(_e3005[2], -(_e3005[2]), (_e3005[2] < 0f));
                            let _e3021 = select(_e3019, _e3016, (_e3016 > _e3019));
                            let _e3024 = local_1.member_2[1u];
                            let _e3030 = select(_e3024[0], -(_e3024[0]), (_e3024[0] < 0f));
                            let _e3033 = select(_e3024[1], -(_e3024[1]), (_e3024[1] < 0f));
                            let _e3035 = select(_e3033, _e3030, (_e3030 > _e3033));
                            let _e3038 = select(_e3024[2], -(_e3024[2]), (_e3024[2] < 0f));
                            let _e3040 = select(_e3038, _e3035, (_e3035 > _e3038));
                            let _e3044 = local_1.member_3;
                            let _e3045 = (select(_e3040, _e3021, (_e3021 > _e3040)) + _e3044);
                            let _e3047 = ((_e3002 * 8f) * _e3045);
                            let _e3054 = local_1.member_3;
                            let _e3078 = ((select(_e2776, -(_e2776), (_e2776 < 0f)) + select(_e2779, -(_e2779), (_e2779 < 0f))) + select(_e2782, -(_e2782), (_e2782 < 0f)));
                            let _e3089 = ((select(_e2797, -(_e2797), (_e2797 < 0f)) + select(_e2800, -(_e2800), (_e2800 < 0f))) + select(_e2803, -(_e2803), (_e2803 < 0f)));
                            let _e3091 = select(_e3089, _e3078, (_e3078 > _e3089));
                            let _e3103 = (((select(_e2846, -(_e2846), (_e2846 < 0f)) + select(_e2847, -(_e2847), (_e2847 < 0f))) + select(_e2848, -(_e2848), (_e2848 < 0f))) * 0.5f);
                            let _e3110 = local_1.member_3;
                            let _e3123 = ((((_e2851[0] * _e2776) + (_e2851[1] * _e2779)) + (_e2851[2] * _e2782)) * 3f);
                            let _e3124 = ((((_e2908[0] * _e2797) + (_e2908[1] * _e2800)) + (_e2908[2] * _e2803)) * 3f);
                            let _e3126 = select(_e3124, _e3123, (_e3123 < _e3124));
                            let _e3128 = select(_e2905, _e2882, (_e2882 < _e2905));
                            let _e3130 = select(_e3128, _e3126, (_e3126 < _e3128));
                            let _e3132 = select(_e3124, _e3123, (_e3123 > _e3124));
                            let _e3134 = select(_e2905, _e2882, (_e2882 > _e2905));
                            let _e3141 = -(select(_e3134, _e3132, (_e3132 > _e3134)));
                            let _e3145 = ((select(_e3141, _e3130, (_e3130 > _e3141)) - ((((((_e2959 * 8f) * _e3047) * (0.000000059604645f * (524f / 64f))) + ((_e3054 * 19f) * ((_e2959 * (_e3002 + _e3045)) + (_e3002 * _e3045)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2959) * ((1f + _e3002) * (1f + _e3045))))) + ((_e60.member_5 * (((select(_e3103, _e3091, (_e3091 > _e3103)) + (_e3047 * (0.000000059604645f * 8f))) + ((_e3110 * 6f) * (_e3002 + _e3045))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3002) * (1f + _e3045))))) * (3f * 1.0001f)))) > 0f);
                            if _e3145 {
                                phi_6062_ = _e3145;
                            } else {
                                let _e3148 = local_1.member_1[0u];
                                let _e3154 = local_1.member_1[1u];
                                let _e3158 = (_e3148[0] + _e3154[0]);
                                let _e3159 = (_e3148[1] + _e3154[1]);
                                let _e3160 = (_e3148[2] + _e3154[2]);
                                let _e3163 = local_1.member_2[0u];
                                let _e3169 = local_1.member_2[1u];
                                let _e3173 = (_e3163[0] + _e3169[0]);
                                let _e3174 = (_e3163[1] + _e3169[1]);
                                let _e3175 = (_e3163[2] + _e3169[2]);
                                let _e3178 = ((_e3159 * _e3175) - (_e3160 * _e3174));
                                let _e3181 = ((_e3160 * _e3173) - (_e3158 * _e3175));
                                let _e3184 = ((_e3158 * _e3174) - (_e3159 * _e3173));
                                let _e3187 = local_1.member[0u];
                                let _e3193 = local_1.member_1[0u];
                                let _e3199 = local_1.member_2[0u];
                                let _e3203 = (_e3187[0] - _e3193[0]);
                                let _e3204 = (_e3187[1] - _e3193[1]);
                                let _e3205 = (_e3187[2] - _e3193[2]);
                                let _e3206 = (_e1600.member == 0u);
                                let _e3210 = select((_e3203 - _e3199[0]), _e3187[0], _e3206);
                                let _e3211 = select((_e3204 - _e3199[1]), _e3187[1], _e3206);
                                let _e3212 = select((_e3205 - _e3199[2]), _e3187[2], _e3206);
                                let _e3213 = (_e3187[0] - _e3199[0]);
                                let _e3214 = (_e3187[1] - _e3199[1]);
                                let _e3215 = (_e3187[2] - _e3199[2]);
                                let _e3218 = local_1.member[1u];
                                let _e3224 = local_1.member_1[1u];
                                let _e3230 = local_1.member_2[1u];
                                let _e3234 = (_e3218[0] - _e3224[0]);
                                let _e3235 = (_e3218[1] - _e3224[1]);
                                let _e3236 = (_e3218[2] - _e3224[2]);
                                let _e3237 = (_e1600.member == 0u);
                                let _e3241 = select((_e3234 - _e3230[0]), _e3218[0], _e3237);
                                let _e3242 = select((_e3235 - _e3230[1]), _e3218[1], _e3237);
                                let _e3243 = select((_e3236 - _e3230[2]), _e3218[2], _e3237);
                                let _e3244 = (_e3218[0] - _e3230[0]);
                                let _e3245 = (_e3218[1] - _e3230[1]);
                                let _e3246 = (_e3218[2] - _e3230[2]);
                                let _e3249 = local_1.member[0u];
                                let _e3255 = select(_e3249[0], -(_e3249[0]), (_e3249[0] < 0f));
                                let _e3258 = select(_e3249[1], -(_e3249[1]), (_e3249[1] < 0f));
                                let _e3260 = select(_e3258, _e3255, (_e3255 > _e3258));
                                let _e3263 = select(_e3249[2], -(_e3249[2]), (_e3249[2] < 0f));
                                let _e3265 = select(_e3263, _e3260, (_e3260 > _e3263));
                                let _e3268 = local_1.member[1u];
                                let _e3274 = select(_e3268[0], -(_e3268[0]), (_e3268[0] < 0f));
                                let _e3277 = select(_e3268[1], -(_e3268[1]), (_e3268[1] < 0f));
                                let _e3279 = select(_e3277, _e3274, (_e3274 > _e3277));
                                let _e3282 = select(_e3268[2], -(_e3268[2]), (_e3268[2] < 0f));
                                let _e3284 = select(_e3282, _e3279, (_e3279 > _e3282));
                                let _e3288 = local_1.member_3;
                                let _e3292 = local_1.member_1[0u];
                                let _e3298 = select(_e3292[0], -(_e3292[0]), (_e3292[0] < 0f));
                                let _e3301 = select(_e3292[1], -(_e3292[1]), (_e3292[1] < 0f));
                                let _e3303 = select(_e3301, _e3298, (_e3298 > _e3301));
                                let _e3306 = select(_e3292[2], -(_e3292[2]), (_e3292[2] < 0f));
                                let _e3308 = select(_e3306, _e3303, (_e3303 > _e3306));
                                let _e3311 = local_1.member_1[1u];
                                let _e3317 = select(_e3311[0], -(_e3311[0]), (_e3311[0] < 0f));
                                let _e3320 = select(_e3311[1], -(_e3311[1]), (_e3311[1] < 0f));
                                let _e3322 = select(_e3320, _e3317, (_e3317 > _e3320));
                                let _e3325 = select(_e3311[2], -(_e3311[2]), (_e3311[2] < 0f));
                                let _e3327 = select(_e3325, _e3322, (_e3322 > _e3325));
                                let _e3331 = local_1.member_3;
                                let _e3335 = local_1.member_2[0u];
                                let _e3341 = select(_e3335[0], -(_e3335[0]), (_e3335[0] < 0f));
                                let _e3344 = select(_e3335[1], -(_e3335[1]), (_e3335[1] < 0f));
                                let _e3346 = select(_e3344, _e3341, (_e3341 > _e3344));
                                let _e3349 = select(_e3335[2], -(_e3335[2]), (_e3335[2] < 0f));
                                let _e3351 = select(_e3349, _e3346, (_e3346 > _e3349));
                                let _e3354 = local_1.member_2[1u];
                                let _e3360 = select(_e3354[0], -(_e3354[0]), (_e3354[0] < 0f));
                                let _e3363 = select(_e3354[1], -(_e3354[1]), (_e3354[1] < 0f));
                                let _e3365 = select(_e3363, _e3360, (_e3360 > _e3363));
                                let _e3368 = select(_e3354[2], -(_e3354[2]), (_e3354[2] < 0f));
                                let _e3370 = select(_e3368, _e3365, (_e3365 > _e3368));
                                let _e3374 = local_1.member_3;
                                let _e3378 = ((((select(_e3284, _e3265, (_e3265 > _e3284)) + _e3288) + (select(_e3327, _e3308, (_e3308 > _e3327)) + _e3331)) + (select(_e3370, _e3351, (_e3351 > _e3370)) + _e3374)) * 2f);
                                let _e3381 = local_1.member_3;
                                let _e3385 = (((_e60.member_5 * 1.0001f) + (_e3381 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                let _e3388 = ((_e3181 * _e3160) - (_e3184 * _e3159));
                                let _e3391 = ((_e3184 * _e3158) - (_e3178 * _e3160));
                                let _e3394 = ((_e3178 * _e3159) - (_e3181 * _e3158));
                                let _e3399 = (((_e3388 * _e3187[0]) + (_e3391 * _e3187[1])) + (_e3394 * _e3187[2]));
                                let _e3404 = (((_e3388 * _e3203) + (_e3391 * _e3204)) + (_e3394 * _e3205));
                                let _e3409 = (((_e3388 * _e3213) + (_e3391 * _e3214)) + (_e3394 * _e3215));
                                let _e3414 = (((_e3388 * _e3210) + (_e3391 * _e3211)) + (_e3394 * _e3212));
                                let _e3419 = (((_e3388 * _e3218[0]) + (_e3391 * _e3218[1])) + (_e3394 * _e3218[2]));
                                let _e3424 = (((_e3388 * _e3234) + (_e3391 * _e3235)) + (_e3394 * _e3236));
                                let _e3429 = (((_e3388 * _e3244) + (_e3391 * _e3245)) + (_e3394 * _e3246));
                                let _e3434 = (((_e3388 * _e3241) + (_e3391 * _e3242)) + (_e3394 * _e3243));
                                let _e3436 = select(_e3404, _e3399, (_e3399 < _e3404));
                                let _e3438 = select(_e3414, _e3409, (_e3409 < _e3414));
                                let _e3440 = select(_e3438, _e3436, (_e3436 < _e3438));
                                let _e3442 = select(_e3424, _e3419, (_e3419 < _e3424));
                                let _e3444 = select(_e3434, _e3429, (_e3429 < _e3434));
                                let _e3446 = select(_e3444, _e3442, (_e3442 < _e3444));
                                let _e3448 = select(_e3446, _e3440, (_e3440 < _e3446));
                                let _e3450 = select(_e3404, _e3399, (_e3399 > _e3404));
                                let _e3452 = select(_e3414, _e3409, (_e3409 > _e3414));
                                let _e3454 = select(_e3452, _e3450, (_e3450 > _e3452));
                                let _e3456 = select(_e3424, _e3419, (_e3419 > _e3424));
                                let _e3458 = select(_e3434, _e3429, (_e3429 > _e3434));
                                let _e3460 = select(_e3458, _e3456, (_e3456 > _e3458));
                                let _e3473 = ((select(_e3388, -(_e3388), (_e3388 < 0f)) + select(_e3391, -(_e3391), (_e3391 < 0f))) + select(_e3394, -(_e3394), (_e3394 < 0f)));
                                let _e3478 = -(select(_e3460, _e3454, (_e3454 > _e3460)));
                                let _e3485 = (((select(_e3478, _e3448, (_e3448 > _e3478)) - ((_e3473 * _e3378) * (0.000000059604645f * (17f / 2f)))) - (_e3473 * _e3385)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                let _e3488 = ((_e3181 * _e3175) - (_e3184 * _e3174));
                                let _e3491 = ((_e3184 * _e3173) - (_e3178 * _e3175));
                                let _e3494 = ((_e3178 * _e3174) - (_e3181 * _e3173));
                                let _e3499 = (((_e3488 * _e3187[0]) + (_e3491 * _e3187[1])) + (_e3494 * _e3187[2]));
                                let _e3504 = (((_e3488 * _e3203) + (_e3491 * _e3204)) + (_e3494 * _e3205));
                                let _e3509 = (((_e3488 * _e3213) + (_e3491 * _e3214)) + (_e3494 * _e3215));
                                let _e3514 = (((_e3488 * _e3210) + (_e3491 * _e3211)) + (_e3494 * _e3212));
                                let _e3519 = (((_e3488 * _e3218[0]) + (_e3491 * _e3218[1])) + (_e3494 * _e3218[2]));
                                let _e3524 = (((_e3488 * _e3234) + (_e3491 * _e3235)) + (_e3494 * _e3236));
                                let _e3529 = (((_e3488 * _e3244) + (_e3491 * _e3245)) + (_e3494 * _e3246));
                                let _e3534 = (((_e3488 * _e3241) + (_e3491 * _e3242)) + (_e3494 * _e3243));
                                let _e3536 = select(_e3504, _e3499, (_e3499 < _e3504));
                                let _e3538 = select(_e3514, _e3509, (_e3509 < _e3514));
                                let _e3540 = select(_e3538, _e3536, (_e3536 < _e3538));
                                let _e3542 = select(_e3524, _e3519, (_e3519 < _e3524));
                                let _e3544 = select(_e3534, _e3529, (_e3529 < _e3534));
                                let _e3546 = select(_e3544, _e3542, (_e3542 < _e3544));
                                let _e3548 = select(_e3546, _e3540, (_e3540 < _e3546));
                                let _e3550 = select(_e3504, _e3499, (_e3499 > _e3504));
                                let _e3552 = select(_e3514, _e3509, (_e3509 > _e3514));
                                let _e3554 = select(_e3552, _e3550, (_e3550 > _e3552));
                                let _e3556 = select(_e3524, _e3519, (_e3519 > _e3524));
                                let _e3558 = select(_e3534, _e3529, (_e3529 > _e3534));
                                let _e3560 = select(_e3558, _e3556, (_e3556 > _e3558));
                                let _e3573 = ((select(_e3488, -(_e3488), (_e3488 < 0f)) + select(_e3491, -(_e3491), (_e3491 < 0f))) + select(_e3494, -(_e3494), (_e3494 < 0f)));
                                let _e3578 = -(select(_e3560, _e3554, (_e3554 > _e3560)));
                                let _e3585 = (((select(_e3578, _e3548, (_e3548 > _e3578)) - ((_e3573 * _e3378) * (0.000000059604645f * (17f / 2f)))) - (_e3573 * _e3385)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                let _e3587 = select(_e3585, _e3485, (_e3485 > _e3585));
                                if (_e1600.member == 0u) {
                                    let _e3589 = (_e3173 - _e3158);
                                    let _e3590 = (_e3174 - _e3159);
                                    let _e3591 = (_e3175 - _e3160);
                                    let _e3594 = ((_e3181 * _e3591) - (_e3184 * _e3590));
                                    let _e3597 = ((_e3184 * _e3589) - (_e3178 * _e3591));
                                    let _e3600 = ((_e3178 * _e3590) - (_e3181 * _e3589));
                                    let _e3605 = (((_e3594 * _e3187[0]) + (_e3597 * _e3187[1])) + (_e3600 * _e3187[2]));
                                    let _e3610 = (((_e3594 * _e3203) + (_e3597 * _e3204)) + (_e3600 * _e3205));
                                    let _e3615 = (((_e3594 * _e3213) + (_e3597 * _e3214)) + (_e3600 * _e3215));
                                    let _e3620 = (((_e3594 * _e3210) + (_e3597 * _e3211)) + (_e3600 * _e3212));
                                    let _e3625 = (((_e3594 * _e3218[0]) + (_e3597 * _e3218[1])) + (_e3600 * _e3218[2]));
                                    let _e3630 = (((_e3594 * _e3234) + (_e3597 * _e3235)) + (_e3600 * _e3236));
                                    let _e3635 = (((_e3594 * _e3244) + (_e3597 * _e3245)) + (_e3600 * _e3246));
                                    let _e3640 = (((_e3594 * _e3241) + (_e3597 * _e3242)) + (_e3600 * _e3243));
                                    let _e3642 = select(_e3610, _e3605, (_e3605 < _e3610));
                                    let _e3644 = select(_e3620, _e3615, (_e3615 < _e3620));
                                    let _e3646 = select(_e3644, _e3642, (_e3642 < _e3644));
                                    let _e3648 = select(_e3630, _e3625, (_e3625 < _e3630));
                                    let _e3650 = select(_e3640, _e3635, (_e3635 < _e3640));
                                    let _e3652 = select(_e3650, _e3648, (_e3648 < _e3650));
                                    let _e3654 = select(_e3652, _e3646, (_e3646 < _e3652));
                                    let _e3656 = select(_e3610, _e3605, (_e3605 > _e3610));
                                    let _e3658 = select(_e3620, _e3615, (_e3615 > _e3620));
                                    let _e3660 = select(_e3658, _e3656, (_e3656 > _e3658));
                                    let _e3662 = select(_e3630, _e3625, (_e3625 > _e3630));
                                    let _e3664 = select(_e3640, _e3635, (_e3635 > _e3640));
                                    let _e3666 = select(_e3664, _e3662, (_e3662 > _e3664));
                                    let _e3679 = ((select(_e3594, -(_e3594), (_e3594 < 0f)) + select(_e3597, -(_e3597), (_e3597 < 0f))) + select(_e3600, -(_e3600), (_e3600 < 0f)));
                                    let _e3684 = -(select(_e3666, _e3660, (_e3660 > _e3666)));
                                    let _e3691 = (((select(_e3684, _e3654, (_e3654 > _e3684)) - ((_e3679 * _e3378) * (0.000000059604645f * (17f / 2f)))) - (_e3679 * _e3385)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    phi_6059_ = select(_e3691, _e3587, (_e3587 > _e3691));
                                } else {
                                    phi_6059_ = _e3587;
                                }
                                let _e3695 = phi_6059_;
                                phi_6062_ = (_e3145 || (_e3695 > 0f));
                            }
                            let _e3699 = phi_6062_;
                            phi_6064_ = (_e2761 && _e3699);
                        } else {
                            phi_6064_ = _e2761;
                        }
                        let _e3702 = phi_6064_;
                        if _e3702 {
                        } else {
                            let _e3704 = atomicAdd((&counters[1u]), 1u);
                            kept[_e3704].member = _e1570;
                            kept[_e3704].member_1 = _e1572;
                        }
                        phi_6073_ = true;
                    }
                    let _e3709 = phi_6073_;
                    phi_6074_ = _e3709;
                } else {
                    phi_6074_ = false;
                }
                let _e3711 = phi_6074_;
                continue;
                continuing {
                    phi_2461_ = type_9(select(_e1548.member, (_e1548.member + 1u), _e1551), select(_e1548.member_1, _e1548.member_1, _e1551));
                    break if !(_e3711);
                }
            }
            workgroupBarrier();
            let _e3714 = atomicLoad((&counters[1u]));
            if (_e45 == 0u) {
                if (_e3714 > 0u) {
                    let _e3718 = atomicAdd((&output.member[0u]), _e3714);
                    if ((_e3718 + _e3714) < _e3718) {
                        let _e3722 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[2u]), _e3718);
                }
            }
            workgroupBarrier();
            let _e3725 = atomicLoad((&counters[2u]));
            phi_6102_ = type_9(0u, 4u);
            loop {
                let _e3727 = phi_6102_;
                let _e3730 = (_e3727.member < _e3727.member_1);
                if (bitcast<i32>(select(0u, 1u, _e3730)) != 0i) {
                    let _e3745 = ((select(type_9().member_1, _e3727.member, _e3730) * 128u) + _e45);
                    if (_e3745 >= _e3714) {
                        phi_6160_ = false;
                    } else {
                        let _e3749 = params.member.member_1.member_3;
                        let _e3750 = (_e3725 + _e3745);
                        let _e3753 = kept[_e3745].member;
                        let _e3755 = kept[_e3745].member_1;
                        if (_e3750 < _e3749) {
                            let _e3757 = (2u * _e3750);
                            atomicStore((&output.member[(4u + _e3757)]), _e3753);
                            atomicStore((&output.member[(_e3757 + 5u)]), _e3755);
                        }
                        phi_6160_ = true;
                    }
                    let _e3763 = phi_6160_;
                    phi_6161_ = _e3763;
                } else {
                    phi_6161_ = false;
                }
                let _e3765 = phi_6161_;
                continue;
                continuing {
                    phi_6102_ = type_9(select(_e3727.member, (_e3727.member + 1u), _e3730), select(_e3727.member_1, _e3727.member_1, _e3730));
                    break if !(_e3765);
                }
            }
            workgroupBarrier();
        }
        continue;
        continuing {
            phi_239_ = type_9(select(_e106.member, (_e106.member + 1u), _e109), select(_e106.member_1, _e106.member_1, _e109));
            break if !(_e122);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn filter_pairs(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_2(id, n, lane);
}

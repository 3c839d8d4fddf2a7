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
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_20 {
    member: array<type_18>,
}

struct type_21 {
    member: vec4<u32>,
    member_1: vec4<u32>,
    member_2: vec4<u32>,
    member_3: vec4<u32>,
}

struct type_23 {
    member: array<type_21>,
}

struct type_26 {
    member: array<array<f32, 3>, 3>,
    member_1: array<f32, 3>,
    member_2: array<f32, 3>,
    member_3: array<f32, 3>,
    member_4: array<f32, 3>,
    member_5: f32,
}

struct type_28 {
    member: vec4<f32>,
    member_1: vec4<f32>,
    member_2: vec4<f32>,
    member_3: vec4<f32>,
}

struct type_30 {
    member: array<type_28>,
}

struct type_32 {
    member: array<u32, 31>,
    member_1: u32,
}

struct type_33 {
    member: type_32,
    member_1: u32,
    member_2: bool,
    member_3: bool,
}

struct type_36 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_11;
@group(0) @binding(4) 
var<storage> oriented: type_30;
@group(0) @binding(2) 
var<storage> order: type_13;
@group(0) @binding(1) 
var<storage> boxes: type_20;
@group(0) @binding(3) 
var<storage> nodes: type_23;
@group(0) @binding(5) 
var<storage, read_write> pairs: type_36;

fn function_(param: u32) -> u32 {
    return param;
}

fn function_1(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_26;
    var local_1: type_33;
    var phi_180_: u32;
    var phi_410_: type_9;
    var phi_2283_: bool;
    var phi_2312_: bool;
    var phi_2393_: bool;
    var phi_2394_: bool;
    var phi_2395_: u32;
    var phi_2425_: bool;
    var phi_2547_: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e31 = id_2;
    let _e32 = n_2;
    let _e33 = lane_2;
    let _e46 = ((((_e31.y * _e32.x) + _e31.x) * 128u) + _e33);
    let _e49 = params.member.member_1.member;
    if (_e46 < _e49) {
        let _e53 = params.member.member_2.member;
        let _e59 = params.member.member.member_2[select(1u, 0u, (_e53 == 0u))];
        let _e62 = params.member.member_1.member_1;
        let _e64 = ((_e59 + _e62) + _e46);
        let _e67 = params.member.member_2.member_1;
        if (_e67 == 0u) {
            phi_180_ = _e64;
        } else {
            let _e70 = order.member[_e64];
            phi_180_ = _e70;
        }
        let _e72 = phi_180_;
        let _e73 = (_e72 - _e59);
        let _e75 = boxes.member[_e72];
        let _e90 = params.member.member_2.member;
        let _e92 = select(1u, 2u, (_e90 == 0u));
        let _e96 = params.member.member.member_2[_e92];
        let _e100 = params.member.member.member[_e92];
        let _e101 = (_e100 - 1u);
        if (_e101 == 0u) {
            let _e105 = params.member.member_2.member;
            let _e111 = params.member.member.member_2[select(1u, 2u, (_e105 == 0u))];
            let _e113 = order.member[_e111];
            let _e115 = boxes.member[_e113];
            if ((((((_e115.member.x <= _e75.member_1.y) && (_e75.member.x <= _e115.member_1.y)) && (_e115.member.y <= _e75.member_2.x)) && (_e75.member.y <= _e115.member_2.x)) && (_e115.member_1.x <= _e75.member_2.y)) && (_e75.member_1.x <= _e115.member_2.y)) {
                let _e141 = params.member.member_2.member;
                let _e147 = params.member.member.member_2[select(1u, 2u, (_e141 == 0u))];
                let _e149 = order.member[_e147];
                let _e150 = (_e149 - _e147);
                let _e153 = params.member.member_2.member;
                if select((_e150 > _e73), true, (_e153 == 0u)) {
                    let _e159 = params.member.member_1.member_3;
                    let _e161 = atomicAdd((&pairs.member[0u]), 1u);
                    if ((_e161 + 1u) < _e161) {
                        let _e165 = atomicAdd((&pairs.member[2u]), 1u);
                    }
                    if (_e161 < _e159) {
                        let _e167 = (2u * _e161);
                        atomicStore((&pairs.member[(4u + _e167)]), _e73);
                        atomicStore((&pairs.member[(_e167 + 5u)]), _e150);
                    }
                }
            }
        }
        local_1 = type_33(type_32(array<u32, 31>(u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32()), 0u), 0u, false, true);
        phi_410_ = type_9(0u, (2u * _e101));
        loop {
            let _e178 = phi_410_;
            let _e181 = (_e178.member < _e178.member_1);
            if (bitcast<i32>(select(0u, 1u, _e181)) != 0i) {
                let _e194 = local_1.member_3;
                if _e194 {
                    let _e196 = local_1.member_2;
                    if !(_e196) {
                        let _e199 = local_1.member_1;
                        let _e202 = oriented.member[(_e96 + _e199)];
                        let _e239 = ((_e75.member.x * 0.5f) + (_e75.member_1.y * 0.5f));
                        let _e240 = ((_e75.member.y * 0.5f) + (_e75.member_2.x * 0.5f));
                        let _e241 = ((_e75.member_1.x * 0.5f) + (_e75.member_2.y * 0.5f));
                        let _e243 = select(_e75.member_1.y, _e239, (_e239 < _e75.member_1.y));
                        let _e245 = select(_e75.member_2.x, _e240, (_e240 < _e75.member_2.x));
                        let _e247 = select(_e75.member_2.y, _e241, (_e241 < _e75.member_2.y));
                        let _e249 = select(_e75.member.x, _e243, (_e243 > _e75.member.x));
                        let _e251 = select(_e75.member.y, _e245, (_e245 > _e75.member.y));
                        let _e253 = select(_e75.member_1.x, _e247, (_e247 > _e75.member_1.x));
                        let _e254 = (_e75.member_1.y - _e249);
                        let _e255 = (_e75.member_2.x - _e251);
                        let _e256 = (_e75.member_2.y - _e253);
                        let _e257 = (_e249 - _e75.member.x);
                        let _e258 = (_e251 - _e75.member.y);
                        let _e259 = (_e253 - _e75.member_1.x);
                        let _e267 = (1f + (0.000000059604645f * 4f));
                        let _e271 = (0.000000000000000000000000000000000000011754944f * 8f);
                        let _e272 = ((select(_e257, _e254, (_e254 > _e257)) * _e267) + _e271);
                        let _e273 = ((select(_e258, _e255, (_e255 > _e258)) * _e267) + _e271);
                        let _e274 = ((select(_e259, _e256, (_e256 > _e259)) * _e267) + _e271);
                        let _e275 = (_e202.member.x - _e249);
                        let _e276 = (_e202.member.y - _e251);
                        let _e277 = (_e202.member.z - _e253);
                        local = type_26(array<array<f32, 3>, 3>(array<f32, 3>(_e202.member.w, _e202.member_1.z, _e202.member_2.y), array<f32, 3>(_e202.member_1.x, _e202.member_1.w, _e202.member_2.z), array<f32, 3>(_e202.member_1.y, _e202.member_2.x, _e202.member_2.w)), array<f32, 3>(_e275, _e276, _e277), array<f32, 3>((((_e202.member.w * _e275) + (_e202.member_1.x * _e276)) + (_e202.member_1.y * _e277)), (((_e202.member_1.z * _e275) + (_e202.member_1.w * _e276)) + (_e202.member_2.x * _e277)), (((_e202.member_2.y * _e275) + (_e202.member_2.z * _e276)) + (_e202.member_2.w * _e277))), array<f32, 3>(_e272, _e273, _e274), array<f32, 3>(_e202.member_3.x, _e202.member_3.y, _e202.member_3.z), ((((((select(_e275, -(_e275), (_e275 < 0f)) + select(_e276, -(_e276), (_e276 < 0f))) + select(_e277, -(_e277), (_e277 < 0f))) + (((select(_e272, -(_e272), (_e272 < 0f)) + select(_e273, -(_e273), (_e273 < 0f))) + select(_e274, -(_e274), (_e274 < 0f))) + ((select(_e202.member_3.x, -(_e202.member_3.x), (_e202.member_3.x < 0f)) + select(_e202.member_3.y, -(_e202.member_3.y), (_e202.member_3.y < 0f))) + select(_e202.member_3.z, -(_e202.member_3.z), (_e202.member_3.z < 0f))))) * 2f) * (0.000000059604645f * 128f)) + (0.000000000000000000000000000000000000011754944f * 128f)));
                        let _e345 = local.member[0u][0u];
                        let _e349 = local.member[0u][1u];
                        let _e353 = local.member[0u][2u];
                        let _e357 = local.member[1u][0u];
                        let _e361 = local.member[1u][1u];
                        let _e365 = local.member[1u][2u];
                        let _e369 = local.member[2u][0u];
                        let _e373 = local.member[2u][1u];
                        let _e377 = local.member[2u][2u];
                        let _e379 = local.member_3;
                        let _e384 = local.member_4;
                        let _e390 = local.member_1[0u];
                        let _e409 = (select(_e390, -(_e390), (_e390 < 0f)) - (_e379[0] + (((select(_e345, -(_e345), (_e345 < 0f)) * _e384[0]) + (select(_e349, -(_e349), (_e349 < 0f)) * _e384[1])) + (select(_e353, -(_e353), (_e353 < 0f)) * _e384[2]))));
                        let _e412 = local.member_1[1u];
                        let _e431 = (select(_e412, -(_e412), (_e412 < 0f)) - (_e379[1] + (((select(_e357, -(_e357), (_e357 < 0f)) * _e384[0]) + (select(_e361, -(_e361), (_e361 < 0f)) * _e384[1])) + (select(_e365, -(_e365), (_e365 < 0f)) * _e384[2]))));
                        let _e434 = local.member_1[2u];
                        let _e453 = (select(_e434, -(_e434), (_e434 < 0f)) - (_e379[2] + (((select(_e369, -(_e369), (_e369 < 0f)) * _e384[0]) + (select(_e373, -(_e373), (_e373 < 0f)) * _e384[1])) + (select(_e377, -(_e377), (_e377 < 0f)) * _e384[2]))));
                        let _e456 = local.member_2[0u];
                        let _e475 = (select(_e456, -(_e456), (_e456 < 0f)) - (_e384[0] + (((select(_e345, -(_e345), (_e345 < 0f)) * _e379[0]) + (select(_e357, -(_e357), (_e357 < 0f)) * _e379[1])) + (select(_e369, -(_e369), (_e369 < 0f)) * _e379[2]))));
                        let _e478 = local.member_2[1u];
                        let _e497 = (select(_e478, -(_e478), (_e478 < 0f)) - (_e384[1] + (((select(_e349, -(_e349), (_e349 < 0f)) * _e379[0]) + (select(_e361, -(_e361), (_e361 < 0f)) * _e379[1])) + (select(_e373, -(_e373), (_e373 < 0f)) * _e379[2]))));
                        let _e500 = local.member_2[2u];
                        let _e519 = (select(_e500, -(_e500), (_e500 < 0f)) - (_e384[2] + (((select(_e353, -(_e353), (_e353 < 0f)) * _e379[0]) + (select(_e365, -(_e365), (_e365 < 0f)) * _e379[1])) + (select(_e377, -(_e377), (_e377 < 0f)) * _e379[2]))));
                        let _e521 = select(_e431, _e409, (_e409 > _e431));
                        let _e523 = select(_e453, _e521, (_e521 > _e453));
                        let _e525 = select(_e497, _e475, (_e475 > _e497));
                        let _e527 = select(_e519, _e525, (_e525 > _e519));
                        let _e531 = local.member_5;
                        if (select(_e527, _e523, (_e523 > _e527)) > _e531) {
                            phi_2283_ = true;
                        } else {
                            let _e536 = local.member[1u][0u];
                            let _e539 = local.member_1[2u];
                            let _e544 = local.member[2u][0u];
                            let _e547 = local.member_1[1u];
                            let _e549 = ((_e536 * _e539) - (_e544 * _e547));
                            let _e553 = local.member[2u][0u];
                            let _e559 = local.member_3[1u];
                            let _e564 = local.member[1u][0u];
                            let _e570 = local.member_3[2u];
                            let _e576 = local.member[0u][2u];
                            let _e582 = local.member_4[1u];
                            let _e587 = local.member[0u][1u];
                            let _e593 = local.member_4[2u];
                            let _e600 = (select(_e549, -(_e549), (_e549 < 0f)) - (((select(_e553, -(_e553), (_e553 < 0f)) * _e559) + (select(_e564, -(_e564), (_e564 < 0f)) * _e570)) + ((select(_e576, -(_e576), (_e576 < 0f)) * _e582) + (select(_e587, -(_e587), (_e587 < 0f)) * _e593))));
                            let _e604 = local.member[1u][1u];
                            let _e607 = local.member_1[2u];
                            let _e612 = local.member[2u][1u];
                            let _e615 = local.member_1[1u];
                            let _e617 = ((_e604 * _e607) - (_e612 * _e615));
                            let _e621 = local.member[2u][1u];
                            let _e627 = local.member_3[1u];
                            let _e632 = local.member[1u][1u];
                            let _e638 = local.member_3[2u];
                            let _e644 = local.member[0u][0u];
                            let _e650 = local.member_4[2u];
                            let _e655 = local.member[0u][2u];
                            let _e661 = local.member_4[0u];
                            let _e668 = (select(_e617, -(_e617), (_e617 < 0f)) - (((select(_e621, -(_e621), (_e621 < 0f)) * _e627) + (select(_e632, -(_e632), (_e632 < 0f)) * _e638)) + ((select(_e644, -(_e644), (_e644 < 0f)) * _e650) + (select(_e655, -(_e655), (_e655 < 0f)) * _e661))));
                            let _e672 = local.member[1u][2u];
                            let _e675 = local.member_1[2u];
                            let _e680 = local.member[2u][2u];
                            let _e683 = local.member_1[1u];
                            let _e685 = ((_e672 * _e675) - (_e680 * _e683));
                            let _e689 = local.member[2u][2u];
                            let _e695 = local.member_3[1u];
                            let _e700 = local.member[1u][2u];
                            let _e706 = local.member_3[2u];
                            let _e712 = local.member[0u][1u];
                            let _e718 = local.member_4[0u];
                            let _e723 = local.member[0u][0u];
                            let _e729 = local.member_4[1u];
                            let _e736 = (select(_e685, -(_e685), (_e685 < 0f)) - (((select(_e689, -(_e689), (_e689 < 0f)) * _e695) + (select(_e700, -(_e700), (_e700 < 0f)) * _e706)) + ((select(_e712, -(_e712), (_e712 < 0f)) * _e718) + (select(_e723, -(_e723), (_e723 < 0f)) * _e729))));
                            let _e740 = local.member[2u][0u];
                            let _e743 = local.member_1[0u];
                            let _e748 = local.member[0u][0u];
                            let _e751 = local.member_1[2u];
                            let _e753 = ((_e740 * _e743) - (_e748 * _e751));
                            let _e757 = local.member[0u][0u];
                            let _e763 = local.member_3[2u];
                            let _e768 = local.member[2u][0u];
                            let _e774 = local.member_3[0u];
                            let _e780 = local.member[1u][2u];
                            let _e786 = local.member_4[1u];
                            let _e791 = local.member[1u][1u];
                            let _e797 = local.member_4[2u];
                            let _e804 = (select(_e753, -(_e753), (_e753 < 0f)) - (((select(_e757, -(_e757), (_e757 < 0f)) * _e763) + (select(_e768, -(_e768), (_e768 < 0f)) * _e774)) + ((select(_e780, -(_e780), (_e780 < 0f)) * _e786) + (select(_e791, -(_e791), (_e791 < 0f)) * _e797))));
                            let _e808 = local.member[2u][1u];
                            let _e811 = local.member_1[0u];
                            let _e816 = local.member[0u][1u];
                            let _e819 = local.member_1[2u];
                            let _e821 = ((_e808 * _e811) - (_e816 * _e819));
                            let _e825 = local.member[0u][1u];
                            let _e831 = local.member_3[2u];
                            let _e836 = local.member[2u][1u];
                            let _e842 = local.member_3[0u];
                            let _e848 = local.member[1u][0u];
                            let _e854 = local.member_4[2u];
                            let _e859 = local.member[1u][2u];
                            let _e865 = local.member_4[0u];
                            let _e872 = (select(_e821, -(_e821), (_e821 < 0f)) - (((select(_e825, -(_e825), (_e825 < 0f)) * _e831) + (select(_e836, -(_e836), (_e836 < 0f)) * _e842)) + ((select(_e848, -(_e848), (_e848 < 0f)) * _e854) + (select(_e859, -(_e859), (_e859 < 0f)) * _e865))));
                            let _e876 = local.member[2u][2u];
                            let _e879 = local.member_1[0u];
                            let _e884 = local.member[0u][2u];
                            let _e887 = local.member_1[2u];
                            let _e889 = ((_e876 * _e879) - (_e884 * _e887));
                            let _e893 = local.member[0u][2u];
                            let _e899 = local.member_3[2u];
                            let _e904 = local.member[2u][2u];
                            let _e910 = local.member_3[0u];
                            let _e916 = local.member[1u][1u];
                            let _e922 = local.member_4[0u];
                            let _e927 = local.member[1u][0u];
                            let _e933 = local.member_4[1u];
                            let _e940 = (select(_e889, -(_e889), (_e889 < 0f)) - (((select(_e893, -(_e893), (_e893 < 0f)) * _e899) + (select(_e904, -(_e904), (_e904 < 0f)) * _e910)) + ((select(_e916, -(_e916), (_e916 < 0f)) * _e922) + (select(_e927, -(_e927), (_e927 < 0f)) * _e933))));
                            let _e944 = local.member[0u][0u];
                            let _e947 = local.member_1[1u];
                            let _e952 = local.member[1u][0u];
                            let _e955 = local.member_1[0u];
                            let _e957 = ((_e944 * _e947) - (_e952 * _e955));
                            let _e961 = local.member[1u][0u];
                            let _e967 = local.member_3[0u];
                            let _e972 = local.member[0u][0u];
                            let _e978 = local.member_3[1u];
                            let _e984 = local.member[2u][2u];
                            let _e990 = local.member_4[1u];
                            let _e995 = local.member[2u][1u];
                            let _e1001 = local.member_4[2u];
                            let _e1008 = (select(_e957, -(_e957), (_e957 < 0f)) - (((select(_e961, -(_e961), (_e961 < 0f)) * _e967) + (select(_e972, -(_e972), (_e972 < 0f)) * _e978)) + ((select(_e984, -(_e984), (_e984 < 0f)) * _e990) + (select(_e995, -(_e995), (_e995 < 0f)) * _e1001))));
                            let _e1012 = local.member[0u][1u];
                            let _e1015 = local.member_1[1u];
                            let _e1020 = local.member[1u][1u];
                            let _e1023 = local.member_1[0u];
                            let _e1025 = ((_e1012 * _e1015) - (_e1020 * _e1023));
                            let _e1029 = local.member[1u][1u];
                            let _e1035 = local.member_3[0u];
                            let _e1040 = local.member[0u][1u];
                            let _e1046 = local.member_3[1u];
                            let _e1052 = local.member[2u][0u];
                            let _e1058 = local.member_4[2u];
                            let _e1063 = local.member[2u][2u];
                            let _e1069 = local.member_4[0u];
                            let _e1076 = (select(_e1025, -(_e1025), (_e1025 < 0f)) - (((select(_e1029, -(_e1029), (_e1029 < 0f)) * _e1035) + (select(_e1040, -(_e1040), (_e1040 < 0f)) * _e1046)) + ((select(_e1052, -(_e1052), (_e1052 < 0f)) * _e1058) + (select(_e1063, -(_e1063), (_e1063 < 0f)) * _e1069))));
                            let _e1080 = local.member[0u][2u];
                            let _e1083 = local.member_1[1u];
                            let _e1088 = local.member[1u][2u];
                            let _e1091 = local.member_1[0u];
                            let _e1093 = ((_e1080 * _e1083) - (_e1088 * _e1091));
                            let _e1097 = local.member[1u][2u];
                            let _e1103 = local.member_3[0u];
                            let _e1108 = local.member[0u][2u];
                            let _e1114 = local.member_3[1u];
                            let _e1120 = local.member[2u][1u];
                            let _e1126 = local.member_4[0u];
                            let _e1131 = local.member[2u][0u];
                            let _e1137 = local.member_4[1u];
                            let _e1144 = (select(_e1093, -(_e1093), (_e1093 < 0f)) - (((select(_e1097, -(_e1097), (_e1097 < 0f)) * _e1103) + (select(_e1108, -(_e1108), (_e1108 < 0f)) * _e1114)) + ((select(_e1120, -(_e1120), (_e1120 < 0f)) * _e1126) + (select(_e1131, -(_e1131), (_e1131 < 0f)) * _e1137))));
                            let _e1146 = select(_e668, _e600, (_e600 > _e668));
                            let _e1148 = select(_e736, _e1146, (_e1146 > _e736));
                            let _e1150 = select(_e872, _e804, (_e804 > _e872));
                            let _e1152 = select(_e940, _e1150, (_e1150 > _e940));
                            let _e1154 = select(_e1152, _e1148, (_e1148 > _e1152));
                            let _e1156 = select(_e1076, _e1008, (_e1008 > _e1076));
                            let _e1158 = select(_e1144, _e1156, (_e1156 > _e1144));
                            let _e1162 = local.member_5;
                            phi_2283_ = (select(_e1158, _e1154, (_e1154 > _e1158)) > _e1162);
                        }
                        let _e1165 = phi_2283_;
                        let _e1166 = !(_e1165);
                        if _e1166 {
                        } else {
                            let _e1169 = local_1.member.member_1;
                            if (_e1169 > 0u) {
                                let _e1175 = local_1.member.member_1;
                                local_1.member.member_1 = (_e1175 - 1u);
                                let _e1178 = local_1.member.member_1;
                                let _e1181 = local_1.member.member[_e1178];
                                local_1.member_1 = _e1181;
                                local_1.member_2 = true;
                            } else {
                                local_1.member_3 = false;
                            }
                        }
                        phi_2312_ = _e1166;
                    } else {
                        phi_2312_ = true;
                    }
                    let _e1185 = phi_2312_;
                    if _e1185 {
                        let _e1187 = local_1.member_1;
                        let _e1189 = nodes.member[_e1187];
                        let _e1225 = local_1.member_2;
                        if (((_e1189.member_3.w & 4u) != 0u) != _e1225) {
                            phi_2393_ = ((_e1189.member_3.w & 1u) != 0u);
                            phi_2394_ = ((((((bitcast<f32>(_e1189.member.x) <= _e75.member_1.y) && (_e75.member.x <= bitcast<f32>(_e1189.member_1.x))) && (bitcast<f32>(_e1189.member.y) <= _e75.member_2.x)) && (_e75.member.y <= bitcast<f32>(_e1189.member_1.y))) && (bitcast<f32>(_e1189.member.z) <= _e75.member_2.y)) && (_e75.member_1.x <= bitcast<f32>(_e1189.member_1.z)));
                            phi_2395_ = _e1189.member_2.w;
                        } else {
                            phi_2393_ = ((_e1189.member_3.w & 2u) != 0u);
                            phi_2394_ = ((((((bitcast<f32>(_e1189.member_2.x) <= _e75.member_1.y) && (_e75.member.x <= bitcast<f32>(_e1189.member_3.x))) && (bitcast<f32>(_e1189.member_2.y) <= _e75.member_2.x)) && (_e75.member.y <= bitcast<f32>(_e1189.member_3.y))) && (bitcast<f32>(_e1189.member_2.z) <= _e75.member_2.y)) && (_e75.member_1.x <= bitcast<f32>(_e1189.member_3.z)));
                            phi_2395_ = (_e1189.member_2.w + 1u);
                        }
                        let _e1255 = phi_2393_;
                        let _e1257 = phi_2394_;
                        let _e1259 = phi_2395_;
                        if _e1257 {
                            if _e1255 {
                            } else {
                                let _e1261 = local_1.member_2;
                                if _e1261 {
                                } else {
                                    let _e1263 = local_1.member_1;
                                    let _e1265 = function_(_e1263);
                                    let _e1267 = local_1.member.member_1;
                                    local_1.member.member[_e1267] = _e1265;
                                    let _e1272 = local_1.member.member_1;
                                    local_1.member.member_1 = (_e1272 + 1u);
                                }
                                local_1.member_1 = _e1259;
                                local_1.member_2 = false;
                            }
                            phi_2425_ = _e1255;
                        } else {
                            phi_2425_ = true;
                        }
                        let _e1277 = phi_2425_;
                        if _e1277 {
                            let _e1279 = local_1.member_2;
                            if _e1279 {
                                let _e1283 = local_1.member.member_1;
                                if (_e1283 > 0u) {
                                    let _e1289 = local_1.member.member_1;
                                    local_1.member.member_1 = (_e1289 - 1u);
                                    let _e1292 = local_1.member.member_1;
                                    let _e1295 = local_1.member.member[_e1292];
                                    local_1.member_1 = _e1295;
                                    local_1.member_2 = true;
                                } else {
                                    local_1.member_3 = false;
                                }
                            } else {
                                local_1.member_2 = true;
                            }
                        }
                        let _e1300 = select(_e1259, 4294967295u, select(true, select(true, false, _e1255), _e1257));
                        if (_e1300 != 4294967295u) {
                            let _e1304 = params.member.member_2.member;
                            let _e1310 = params.member.member.member_2[select(1u, 2u, (_e1304 == 0u))];
                            let _e1313 = order.member[(_e1310 + _e1300)];
                            let _e1314 = (_e1313 - _e1310);
                            let _e1317 = params.member.member_2.member;
                            if select((_e1314 > _e73), true, (_e1317 == 0u)) {
                                let _e1323 = params.member.member_1.member_3;
                                let _e1325 = atomicAdd((&pairs.member[0u]), 1u);
                                if ((_e1325 + 1u) < _e1325) {
                                    let _e1329 = atomicAdd((&pairs.member[2u]), 1u);
                                }
                                if (_e1325 < _e1323) {
                                    let _e1331 = (2u * _e1325);
                                    atomicStore((&pairs.member[(4u + _e1331)]), _e73);
                                    atomicStore((&pairs.member[(_e1331 + 5u)]), _e1314);
                                }
                            }
                        }
                    }
                }
                phi_2547_ = _e194;
            } else {
                phi_2547_ = false;
            }
            let _e1337 = phi_2547_;
            continue;
            continuing {
                phi_410_ = type_9(select(_e178.member, (_e178.member + 1u), _e181), select(_e178.member_1, _e178.member_1, _e181));
                break if !(_e1337);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn traverse_recursive_oriented(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_1(id, n, lane);
}

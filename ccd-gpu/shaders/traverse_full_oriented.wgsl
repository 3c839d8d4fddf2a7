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
    member: array<u32, 47>,
    member_1: u32,
}

struct type_33 {
    member: type_32,
    member_1: u32,
    member_2: bool,
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
    var phi_424_: type_9;
    var phi_2291_: bool;
    var phi_2430_: bool;
    var phi_2431_: bool;
    var phi_2645_: bool;
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
        local_1 = type_33(type_32(array<u32, 47>(u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32()), 0u), 0u, true);
        phi_424_ = type_9(0u, _e101);
        loop {
            let _e177 = phi_424_;
            let _e180 = (_e177.member < _e177.member_1);
            if (bitcast<i32>(select(0u, 1u, _e180)) != 0i) {
                let _e193 = local_1.member_2;
                if _e193 {
                    let _e195 = local_1.member_1;
                    let _e198 = oriented.member[(_e96 + _e195)];
                    let _e235 = ((_e75.member.x * 0.5f) + (_e75.member_1.y * 0.5f));
                    let _e236 = ((_e75.member.y * 0.5f) + (_e75.member_2.x * 0.5f));
                    let _e237 = ((_e75.member_1.x * 0.5f) + (_e75.member_2.y * 0.5f));
                    let _e239 = select(_e75.member_1.y, _e235, (_e235 < _e75.member_1.y));
                    let _e241 = select(_e75.member_2.x, _e236, (_e236 < _e75.member_2.x));
                    let _e243 = select(_e75.member_2.y, _e237, (_e237 < _e75.member_2.y));
                    let _e245 = select(_e75.member.x, _e239, (_e239 > _e75.member.x));
                    let _e247 = select(_e75.member.y, _e241, (_e241 > _e75.member.y));
                    let _e249 = select(_e75.member_1.x, _e243, (_e243 > _e75.member_1.x));
                    let _e250 = (_e75.member_1.y - _e245);
                    let _e251 = (_e75.member_2.x - _e247);
                    let _e252 = (_e75.member_2.y - _e249);
                    let _e253 = (_e245 - _e75.member.x);
                    let _e254 = (_e247 - _e75.member.y);
                    let _e255 = (_e249 - _e75.member_1.x);
                    let _e263 = (1f + (0.000000059604645f * 4f));
                    let _e267 = (0.000000000000000000000000000000000000011754944f * 8f);
                    let _e268 = ((select(_e253, _e250, (_e250 > _e253)) * _e263) + _e267);
                    let _e269 = ((select(_e254, _e251, (_e251 > _e254)) * _e263) + _e267);
                    let _e270 = ((select(_e255, _e252, (_e252 > _e255)) * _e263) + _e267);
                    let _e271 = (_e198.member.x - _e245);
                    let _e272 = (_e198.member.y - _e247);
                    let _e273 = (_e198.member.z - _e249);
                    local = type_26(array<array<f32, 3>, 3>(array<f32, 3>(_e198.member.w, _e198.member_1.z, _e198.member_2.y), array<f32, 3>(_e198.member_1.x, _e198.member_1.w, _e198.member_2.z), array<f32, 3>(_e198.member_1.y, _e198.member_2.x, _e198.member_2.w)), array<f32, 3>(_e271, _e272, _e273), array<f32, 3>((((_e198.member.w * _e271) + (_e198.member_1.x * _e272)) + (_e198.member_1.y * _e273)), (((_e198.member_1.z * _e271) + (_e198.member_1.w * _e272)) + (_e198.member_2.x * _e273)), (((_e198.member_2.y * _e271) + (_e198.member_2.z * _e272)) + (_e198.member_2.w * _e273))), array<f32, 3>(_e268, _e269, _e270), array<f32, 3>(_e198.member_3.x, _e198.member_3.y, _e198.member_3.z), ((((((select(_e271, -(_e271), (_e271 < 0f)) + select(_e272, -(_e272), (_e272 < 0f))) + select(_e273, -(_e273), (_e273 < 0f))) + (((select(_e268, -(_e268), (_e268 < 0f)) + select(_e269, -(_e269), (_e269 < 0f))) + select(_e270, -(_e270), (_e270 < 0f))) + ((select(_e198.member_3.x, -(_e198.member_3.x), (_e198.member_3.x < 0f)) + select(_e198.member_3.y, -(_e198.member_3.y), (_e198.member_3.y < 0f))) + select(_e198.member_3.z, -(_e198.member_3.z), (_e198.member_3.z < 0f))))) * 2f) * (0.000000059604645f * 128f)) + (0.000000000000000000000000000000000000011754944f * 128f)));
                    let _e341 = local.member[0u][0u];
                    let _e345 = local.member[0u][1u];
                    let _e349 = local.member[0u][2u];
                    let _e353 = local.member[1u][0u];
                    let _e357 = local.member[1u][1u];
                    let _e361 = local.member[1u][2u];
                    let _e365 = local.member[2u][0u];
                    let _e369 = local.member[2u][1u];
                    let _e373 = local.member[2u][2u];
                    let _e375 = local.member_3;
                    let _e380 = local.member_4;
                    let _e386 = local.member_1[0u];
                    let _e405 = (select(_e386, -(_e386), (_e386 < 0f)) - (_e375[0] + (((select(_e341, -(_e341), (_e341 < 0f)) * _e380[0]) + (select(_e345, -(_e345), (_e345 < 0f)) * _e380[1])) + (select(_e349, -(_e349), (_e349 < 0f)) * _e380[2]))));
                    let _e408 = local.member_1[1u];
                    let _e427 = (select(_e408, -(_e408), (_e408 < 0f)) - (_e375[1] + (((select(_e353, -(_e353), (_e353 < 0f)) * _e380[0]) + (select(_e357, -(_e357), (_e357 < 0f)) * _e380[1])) + (select(_e361, -(_e361), (_e361 < 0f)) * _e380[2]))));
                    let _e430 = local.member_1[2u];
                    let _e449 = (select(_e430, -(_e430), (_e430 < 0f)) - (_e375[2] + (((select(_e365, -(_e365), (_e365 < 0f)) * _e380[0]) + (select(_e369, -(_e369), (_e369 < 0f)) * _e380[1])) + (select(_e373, -(_e373), (_e373 < 0f)) * _e380[2]))));
                    let _e452 = local.member_2[0u];
                    let _e471 = (select(_e452, -(_e452), (_e452 < 0f)) - (_e380[0] + (((select(_e341, -(_e341), (_e341 < 0f)) * _e375[0]) + (select(_e353, -(_e353), (_e353 < 0f)) * _e375[1])) + (select(_e365, -(_e365), (_e365 < 0f)) * _e375[2]))));
                    let _e474 = local.member_2[1u];
                    let _e493 = (select(_e474, -(_e474), (_e474 < 0f)) - (_e380[1] + (((select(_e345, -(_e345), (_e345 < 0f)) * _e375[0]) + (select(_e357, -(_e357), (_e357 < 0f)) * _e375[1])) + (select(_e369, -(_e369), (_e369 < 0f)) * _e375[2]))));
                    let _e496 = local.member_2[2u];
                    let _e515 = (select(_e496, -(_e496), (_e496 < 0f)) - (_e380[2] + (((select(_e349, -(_e349), (_e349 < 0f)) * _e375[0]) + (select(_e361, -(_e361), (_e361 < 0f)) * _e375[1])) + (select(_e373, -(_e373), (_e373 < 0f)) * _e375[2]))));
                    let _e517 = select(_e427, _e405, (_e405 > _e427));
                    let _e519 = select(_e449, _e517, (_e517 > _e449));
                    let _e521 = select(_e493, _e471, (_e471 > _e493));
                    let _e523 = select(_e515, _e521, (_e521 > _e515));
                    let _e527 = local.member_5;
                    if (select(_e523, _e519, (_e519 > _e523)) > _e527) {
                        phi_2291_ = true;
                    } else {
                        let _e532 = local.member[1u][0u];
                        let _e535 = local.member_1[2u];
                        let _e540 = local.member[2u][0u];
                        let _e543 = local.member_1[1u];
                        let _e545 = ((_e532 * _e535) - (_e540 * _e543));
                        let _e549 = local.member[2u][0u];
                        let _e555 = local.member_3[1u];
                        let _e560 = local.member[1u][0u];
                        let _e566 = local.member_3[2u];
                        let _e572 = local.member[0u][2u];
                        let _e578 = local.member_4[1u];
                        let _e583 = local.member[0u][1u];
                        let _e589 = local.member_4[2u];
                        let _e596 = (select(_e545, -(_e545), (_e545 < 0f)) - (((select(_e549, -(_e549), (_e549 < 0f)) * _e555) + (select(_e560, -(_e560), (_e560 < 0f)) * _e566)) + ((select(_e572, -(_e572), (_e572 < 0f)) * _e578) + (select(_e583, -(_e583), (_e583 < 0f)) * _e589))));
                        let _e600 = local.member[1u][1u];
                        let _e603 = local.member_1[2u];
                        let _e608 = local.member[2u][1u];
                        let _e611 = local.member_1[1u];
                        let _e613 = ((_e600 * _e603) - (_e608 * _e611));
                        let _e617 = local.member[2u][1u];
                        let _e623 = local.member_3[1u];
                        let _e628 = local.member[1u][1u];
                        let _e634 = local.member_3[2u];
                        let _e640 = local.member[0u][0u];
                        let _e646 = local.member_4[2u];
                        let _e651 = local.member[0u][2u];
                        let _e657 = local.member_4[0u];
                        let _e664 = (select(_e613, -(_e613), (_e613 < 0f)) - (((select(_e617, -(_e617), (_e617 < 0f)) * _e623) + (select(_e628, -(_e628), (_e628 < 0f)) * _e634)) + ((select(_e640, -(_e640), (_e640 < 0f)) * _e646) + (select(_e651, -(_e651), (_e651 < 0f)) * _e657))));
                        let _e668 = local.member[1u][2u];
                        let _e671 = local.member_1[2u];
                        let _e676 = local.member[2u][2u];
                        let _e679 = local.member_1[1u];
                        let _e681 = ((_e668 * _e671) - (_e676 * _e679));
                        let _e685 = local.member[2u][2u];
                        let _e691 = local.member_3[1u];
                        let _e696 = local.member[1u][2u];
                        let _e702 = local.member_3[2u];
                        let _e708 = local.member[0u][1u];
                        let _e714 = local.member_4[0u];
                        let _e719 = local.member[0u][0u];
                        let _e725 = local.member_4[1u];
                        let _e732 = (select(_e681, -(_e681), (_e681 < 0f)) - (((select(_e685, -(_e685), (_e685 < 0f)) * _e691) + (select(_e696, -(_e696), (_e696 < 0f)) * _e702)) + ((select(_e708, -(_e708), (_e708 < 0f)) * _e714) + (select(_e719, -(_e719), (_e719 < 0f)) * _e725))));
                        let _e736 = local.member[2u][0u];
                        let _e739 = local.member_1[0u];
                        let _e744 = local.member[0u][0u];
                        let _e747 = local.member_1[2u];
                        let _e749 = ((_e736 * _e739) - (_e744 * _e747));
                        let _e753 = local.member[0u][0u];
                        let _e759 = local.member_3[2u];
                        let _e764 = local.member[2u][0u];
                        let _e770 = local.member_3[0u];
                        let _e776 = local.member[1u][2u];
                        let _e782 = local.member_4[1u];
                        let _e787 = local.member[1u][1u];
                        let _e793 = local.member_4[2u];
                        let _e800 = (select(_e749, -(_e749), (_e749 < 0f)) - (((select(_e753, -(_e753), (_e753 < 0f)) * _e759) + (select(_e764, -(_e764), (_e764 < 0f)) * _e770)) + ((select(_e776, -(_e776), (_e776 < 0f)) * _e782) + (select(_e787, -(_e787), (_e787 < 0f)) * _e793))));
                        let _e804 = local.member[2u][1u];
                        let _e807 = local.member_1[0u];
                        let _e812 = local.member[0u][1u];
                        let _e815 = local.member_1[2u];
                        let _e817 = ((_e804 * _e807) - (_e812 * _e815));
                        let _e821 = local.member[0u][1u];
                        let _e827 = local.member_3[2u];
                        let _e832 = local.member[2u][1u];
                        let _e838 = local.member_3[0u];
                        let _e844 = local.member[1u][0u];
                        let _e850 = local.member_4[2u];
                        let _e855 = local.member[1u][2u];
                        let _e861 = local.member_4[0u];
                        let _e868 = (select(_e817, -(_e817), (_e817 < 0f)) - (((select(_e821, -(_e821), (_e821 < 0f)) * _e827) + (select(_e832, -(_e832), (_e832 < 0f)) * _e838)) + ((select(_e844, -(_e844), (_e844 < 0f)) * _e850) + (select(_e855, -(_e855), (_e855 < 0f)) * _e861))));
                        let _e872 = local.member[2u][2u];
                        let _e875 = local.member_1[0u];
                        let _e880 = local.member[0u][2u];
                        let _e883 = local.member_1[2u];
                        let _e885 = ((_e872 * _e875) - (_e880 * _e883));
                        let _e889 = local.member[0u][2u];
                        let _e895 = local.member_3[2u];
                        let _e900 = local.member[2u][2u];
                        let _e906 = local.member_3[0u];
                        let _e912 = local.member[1u][1u];
                        let _e918 = local.member_4[0u];
                        let _e923 = local.member[1u][0u];
                        let _e929 = local.member_4[1u];
                        let _e936 = (select(_e885, -(_e885), (_e885 < 0f)) - (((select(_e889, -(_e889), (_e889 < 0f)) * _e895) + (select(_e900, -(_e900), (_e900 < 0f)) * _e906)) + ((select(_e912, -(_e912), (_e912 < 0f)) * _e918) + (select(_e923, -(_e923), (_e923 < 0f)) * _e929))));
                        let _e940 = local.member[0u][0u];
                        let _e943 = local.member_1[1u];
                        let _e948 = local.member[1u][0u];
                        let _e951 = local.member_1[0u];
                        let _e953 = ((_e940 * _e943) - (_e948 * _e951));
                        let _e957 = local.member[1u][0u];
                        let _e963 = local.member_3[0u];
                        let _e968 = local.member[0u][0u];
                        let _e974 = local.member_3[1u];
                        let _e980 = local.member[2u][2u];
                        let _e986 = local.member_4[1u];
                        let _e991 = local.member[2u][1u];
                        let _e997 = local.member_4[2u];
                        let _e1004 = (select(_e953, -(_e953), (_e953 < 0f)) - (((select(_e957, -(_e957), (_e957 < 0f)) * _e963) + (select(_e968, -(_e968), (_e968 < 0f)) * _e974)) + ((select(_e980, -(_e980), (_e980 < 0f)) * _e986) + (select(_e991, -(_e991), (_e991 < 0f)) * _e997))));
                        let _e1008 = local.member[0u][1u];
                        let _e1011 = local.member_1[1u];
                        let _e1016 = local.member[1u][1u];
                        let _e1019 = local.member_1[0u];
                        let _e1021 = ((_e1008 * _e1011) - (_e1016 * _e1019));
                        let _e1025 = local.member[1u][1u];
                        let _e1031 = local.member_3[0u];
                        let _e1036 = local.member[0u][1u];
                        let _e1042 = local.member_3[1u];
                        let _e1048 = local.member[2u][0u];
                        let _e1054 = local.member_4[2u];
                        let _e1059 = local.member[2u][2u];
                        let _e1065 = local.member_4[0u];
                        let _e1072 = (select(_e1021, -(_e1021), (_e1021 < 0f)) - (((select(_e1025, -(_e1025), (_e1025 < 0f)) * _e1031) + (select(_e1036, -(_e1036), (_e1036 < 0f)) * _e1042)) + ((select(_e1048, -(_e1048), (_e1048 < 0f)) * _e1054) + (select(_e1059, -(_e1059), (_e1059 < 0f)) * _e1065))));
                        let _e1076 = local.member[0u][2u];
                        let _e1079 = local.member_1[1u];
                        let _e1084 = local.member[1u][2u];
                        let _e1087 = local.member_1[0u];
                        let _e1089 = ((_e1076 * _e1079) - (_e1084 * _e1087));
                        let _e1093 = local.member[1u][2u];
                        let _e1099 = local.member_3[0u];
                        let _e1104 = local.member[0u][2u];
                        let _e1110 = local.member_3[1u];
                        let _e1116 = local.member[2u][1u];
                        let _e1122 = local.member_4[0u];
                        let _e1127 = local.member[2u][0u];
                        let _e1133 = local.member_4[1u];
                        let _e1140 = (select(_e1089, -(_e1089), (_e1089 < 0f)) - (((select(_e1093, -(_e1093), (_e1093 < 0f)) * _e1099) + (select(_e1104, -(_e1104), (_e1104 < 0f)) * _e1110)) + ((select(_e1116, -(_e1116), (_e1116 < 0f)) * _e1122) + (select(_e1127, -(_e1127), (_e1127 < 0f)) * _e1133))));
                        let _e1142 = select(_e664, _e596, (_e596 > _e664));
                        let _e1144 = select(_e732, _e1142, (_e1142 > _e732));
                        let _e1146 = select(_e868, _e800, (_e800 > _e868));
                        let _e1148 = select(_e936, _e1146, (_e1146 > _e936));
                        let _e1150 = select(_e1148, _e1144, (_e1144 > _e1148));
                        let _e1152 = select(_e1072, _e1004, (_e1004 > _e1072));
                        let _e1154 = select(_e1140, _e1152, (_e1152 > _e1140));
                        let _e1158 = local.member_5;
                        phi_2291_ = (select(_e1154, _e1150, (_e1150 > _e1154)) > _e1158);
                    }
                    let _e1161 = phi_2291_;
                    if !(_e1161) {
                        let _e1182 = local_1.member_1;
                        let _e1184 = nodes.member[_e1182];
                        let _e1227 = ((((((bitcast<f32>(_e1184.member.x) <= _e75.member_1.y) && (_e75.member.x <= bitcast<f32>(_e1184.member_1.x))) && (bitcast<f32>(_e1184.member.y) <= _e75.member_2.x)) && (_e75.member.y <= bitcast<f32>(_e1184.member_1.y))) && (bitcast<f32>(_e1184.member.z) <= _e75.member_2.y)) && (_e75.member_1.x <= bitcast<f32>(_e1184.member_1.z)));
                        let _e1238 = ((((((bitcast<f32>(_e1184.member_2.x) <= _e75.member_1.y) && (_e75.member.x <= bitcast<f32>(_e1184.member_3.x))) && (bitcast<f32>(_e1184.member_2.y) <= _e75.member_2.x)) && (_e75.member.y <= bitcast<f32>(_e1184.member_3.y))) && (bitcast<f32>(_e1184.member_2.z) <= _e75.member_2.y)) && (_e75.member_1.x <= bitcast<f32>(_e1184.member_3.z)));
                        let _e1240 = ((_e1184.member_3.w & 1u) != 0u);
                        let _e1242 = ((_e1184.member_3.w & 2u) != 0u);
                        let _e1243 = (_e1184.member_2.w + 1u);
                        let _e1246 = select(_e1184.member_2.w, 4294967295u, select(true, select(true, false, _e1240), _e1227));
                        let _e1249 = select(_e1243, 4294967295u, select(true, select(true, false, _e1242), _e1238));
                        let _e1251 = select(false, !(_e1240), _e1227);
                        let _e1253 = select(false, !(_e1242), _e1238);
                        if _e1251 {
                            if _e1253 {
                                let _e1255 = ((_e1184.member_3.w & 4u) != 0u);
                                let _e1258 = function_(select(_e1184.member_2.w, _e1243, _e1255));
                                let _e1260 = local_1.member.member_1;
                                local_1.member.member[_e1260] = _e1258;
                                let _e1265 = local_1.member.member_1;
                                local_1.member.member_1 = (_e1265 + 1u);
                                local_1.member_1 = select(_e1243, _e1184.member_2.w, _e1255);
                                phi_2430_ = false;
                            } else {
                                phi_2430_ = true;
                            }
                            let _e1270 = phi_2430_;
                            phi_2431_ = _e1270;
                        } else {
                            phi_2431_ = true;
                        }
                        let _e1272 = phi_2431_;
                        if _e1272 {
                            if _e1251 {
                                local_1.member_1 = _e1184.member_2.w;
                            } else {
                                if _e1253 {
                                    local_1.member_1 = _e1243;
                                } else {
                                    let _e1275 = local_1.member.member_1;
                                    local_1.member_2 = (_e1275 > 0u);
                                    let _e1279 = local_1.member_2;
                                    if _e1279 {
                                        let _e1283 = local_1.member.member_1;
                                        local_1.member.member_1 = (_e1283 - 1u);
                                        let _e1286 = local_1.member.member_1;
                                        let _e1289 = local_1.member.member[_e1286];
                                        local_1.member_1 = _e1289;
                                    }
                                }
                            }
                        }
                        if (_e1246 != 4294967295u) {
                            let _e1296 = params.member.member_2.member;
                            let _e1302 = params.member.member.member_2[select(1u, 2u, (_e1296 == 0u))];
                            let _e1305 = order.member[(_e1302 + _e1246)];
                            let _e1306 = (_e1305 - _e1302);
                            let _e1309 = params.member.member_2.member;
                            if select((_e1306 > _e73), true, (_e1309 == 0u)) {
                                let _e1315 = params.member.member_1.member_3;
                                let _e1317 = atomicAdd((&pairs.member[0u]), 1u);
                                if ((_e1317 + 1u) < _e1317) {
                                    let _e1321 = atomicAdd((&pairs.member[2u]), 1u);
                                }
                                if (_e1317 < _e1315) {
                                    let _e1323 = (2u * _e1317);
                                    atomicStore((&pairs.member[(4u + _e1323)]), _e73);
                                    atomicStore((&pairs.member[(_e1323 + 5u)]), _e1306);
                                }
                            }
                        }
                        if (_e1249 != 4294967295u) {
                            let _e1331 = params.member.member_2.member;
                            let _e1337 = params.member.member.member_2[select(1u, 2u, (_e1331 == 0u))];
                            let _e1340 = order.member[(_e1337 + _e1249)];
                            let _e1341 = (_e1340 - _e1337);
                            let _e1344 = params.member.member_2.member;
                            if select((_e1341 > _e73), true, (_e1344 == 0u)) {
                                let _e1350 = params.member.member_1.member_3;
                                let _e1352 = atomicAdd((&pairs.member[0u]), 1u);
                                if ((_e1352 + 1u) < _e1352) {
                                    let _e1356 = atomicAdd((&pairs.member[2u]), 1u);
                                }
                                if (_e1352 < _e1350) {
                                    let _e1358 = (2u * _e1352);
                                    atomicStore((&pairs.member[(4u + _e1358)]), _e73);
                                    atomicStore((&pairs.member[(_e1358 + 5u)]), _e1341);
                                }
                            }
                        }
                    } else {
                        let _e1165 = local_1.member.member_1;
                        local_1.member_2 = (_e1165 > 0u);
                        let _e1169 = local_1.member_2;
                        if _e1169 {
                            let _e1173 = local_1.member.member_1;
                            local_1.member.member_1 = (_e1173 - 1u);
                            let _e1176 = local_1.member.member_1;
                            let _e1179 = local_1.member.member[_e1176];
                            local_1.member_1 = _e1179;
                        }
                    }
                }
                phi_2645_ = _e193;
            } else {
                phi_2645_ = false;
            }
            let _e1364 = phi_2645_;
            continue;
            continuing {
                phi_424_ = type_9(select(_e177.member, (_e177.member + 1u), _e180), select(_e177.member_1, _e177.member_1, _e180));
                break if !(_e1364);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn traverse_full_oriented(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_1(id, n, lane);
}

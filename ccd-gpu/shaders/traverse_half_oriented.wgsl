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

struct type_16 {
    member: array<array<u32, 4>, 8>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_17 {
    member: type_7,
    member_1: type_8,
    member_2: type_16,
}

struct type_18 {
    member: type_17,
}

struct type_20 {
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_22 {
    member: array<type_20>,
}

struct type_23 {
    member: vec4<u32>,
    member_1: vec4<u32>,
    member_2: vec4<u32>,
    member_3: vec4<u32>,
}

struct type_25 {
    member: array<type_23>,
}

struct type_28 {
    member: array<array<f32, 3>, 3>,
    member_1: array<f32, 3>,
    member_2: array<f32, 3>,
    member_3: array<f32, 3>,
    member_4: array<f32, 3>,
    member_5: f32,
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
    member: array<u32, 31>,
    member_1: u32,
    member_2: u32,
    member_3: bool,
}

struct type_37 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_18;
@group(0) @binding(4) 
var<storage> oriented: type_32;
@group(0) @binding(2) 
var<storage> order: type_11;
@group(0) @binding(3) 
var<storage> nodes: type_25;
@group(0) @binding(1) 
var<storage> leaves: type_22;
@group(0) @binding(5) 
var<storage, read_write> pairs: type_37;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_28;
    var local_1: type_34;
    var phi_231_: type_9;
    var phi_2098_: bool;
    var phi_2171_: bool;
    var phi_2194_: bool;
    var phi_2268_: bool;
    var phi_2269_: bool;
    var phi_2431_: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e34 = id_2;
    let _e35 = n_2;
    let _e36 = lane_2;
    let _e49 = ((((_e34.y * _e35.x) + _e34.x) * 128u) + _e36);
    let _e52 = params.member.member_1.member;
    if (_e49 < _e52) {
        let _e56 = params.member.member_1.member_1;
        let _e57 = (_e56 + _e49);
        let _e62 = params.member.member_2.member[0u][1u];
        let _e65 = leaves.member[(_e62 + _e57)];
        let _e81 = params.member.member.member_2[1u];
        let _e85 = params.member.member.member[1u];
        let _e88 = order.member[(_e81 + _e57)];
        let _e89 = (_e88 - _e81);
        local_1 = type_34(array<u32, 31>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, true);
        phi_231_ = type_9(0u, (_e85 - 1u));
        loop {
            let _e93 = phi_231_;
            let _e96 = (_e93.member < _e93.member_1);
            if (bitcast<i32>(select(0u, 1u, _e96)) != 0i) {
                let _e109 = local_1.member_3;
                if _e109 {
                    let _e111 = local_1.member_2;
                    let _e114 = oriented.member[(_e81 + _e111)];
                    let _e151 = ((_e65.member.x * 0.5f) + (_e65.member_1.y * 0.5f));
                    let _e152 = ((_e65.member.y * 0.5f) + (_e65.member_2.x * 0.5f));
                    let _e153 = ((_e65.member_1.x * 0.5f) + (_e65.member_2.y * 0.5f));
                    let _e155 = select(_e65.member_1.y, _e151, (_e151 < _e65.member_1.y));
                    let _e157 = select(_e65.member_2.x, _e152, (_e152 < _e65.member_2.x));
                    let _e159 = select(_e65.member_2.y, _e153, (_e153 < _e65.member_2.y));
                    let _e161 = select(_e65.member.x, _e155, (_e155 > _e65.member.x));
                    let _e163 = select(_e65.member.y, _e157, (_e157 > _e65.member.y));
                    let _e165 = select(_e65.member_1.x, _e159, (_e159 > _e65.member_1.x));
                    let _e166 = (_e65.member_1.y - _e161);
                    let _e167 = (_e65.member_2.x - _e163);
                    let _e168 = (_e65.member_2.y - _e165);
                    let _e169 = (_e161 - _e65.member.x);
                    let _e170 = (_e163 - _e65.member.y);
                    let _e171 = (_e165 - _e65.member_1.x);
                    let _e179 = (1f + (0.000000059604645f * 4f));
                    let _e183 = (0.000000000000000000000000000000000000011754944f * 8f);
                    let _e184 = ((select(_e169, _e166, (_e166 > _e169)) * _e179) + _e183);
                    let _e185 = ((select(_e170, _e167, (_e167 > _e170)) * _e179) + _e183);
                    let _e186 = ((select(_e171, _e168, (_e168 > _e171)) * _e179) + _e183);
                    let _e187 = (_e114.member.x - _e161);
                    let _e188 = (_e114.member.y - _e163);
                    let _e189 = (_e114.member.z - _e165);
                    local = type_28(array<array<f32, 3>, 3>(array<f32, 3>(_e114.member.w, _e114.member_1.z, _e114.member_2.y), array<f32, 3>(_e114.member_1.x, _e114.member_1.w, _e114.member_2.z), array<f32, 3>(_e114.member_1.y, _e114.member_2.x, _e114.member_2.w)), array<f32, 3>(_e187, _e188, _e189), array<f32, 3>((((_e114.member.w * _e187) + (_e114.member_1.x * _e188)) + (_e114.member_1.y * _e189)), (((_e114.member_1.z * _e187) + (_e114.member_1.w * _e188)) + (_e114.member_2.x * _e189)), (((_e114.member_2.y * _e187) + (_e114.member_2.z * _e188)) + (_e114.member_2.w * _e189))), array<f32, 3>(_e184, _e185, _e186), array<f32, 3>(_e114.member_3.x, _e114.member_3.y, _e114.member_3.z), ((((((select(_e187, -(_e187), (_e187 < 0f)) + select(_e188, -(_e188), (_e188 < 0f))) + select(_e189, -(_e189), (_e189 < 0f))) + (((select(_e184, -(_e184), (_e184 < 0f)) + select(_e185, -(_e185), (_e185 < 0f))) + select(_e186, -(_e186), (_e186 < 0f))) + ((select(_e114.member_3.x, -(_e114.member_3.x), (_e114.member_3.x < 0f)) + select(_e114.member_3.y, -(_e114.member_3.y), (_e114.member_3.y < 0f))) + select(_e114.member_3.z, -(_e114.member_3.z), (_e114.member_3.z < 0f))))) * 2f) * (0.000000059604645f * 128f)) + (0.000000000000000000000000000000000000011754944f * 128f)));
                    let _e257 = local.member[0u][0u];
                    let _e261 = local.member[0u][1u];
                    let _e265 = local.member[0u][2u];
                    let _e269 = local.member[1u][0u];
                    let _e273 = local.member[1u][1u];
                    let _e277 = local.member[1u][2u];
                    let _e281 = local.member[2u][0u];
                    let _e285 = local.member[2u][1u];
                    let _e289 = local.member[2u][2u];
                    let _e291 = local.member_3;
                    let _e296 = local.member_4;
                    let _e302 = local.member_1[0u];
                    let _e321 = (select(_e302, -(_e302), (_e302 < 0f)) - (_e291[0] + (((select(_e257, -(_e257), (_e257 < 0f)) * _e296[0]) + (select(_e261, -(_e261), (_e261 < 0f)) * _e296[1])) + (select(_e265, -(_e265), (_e265 < 0f)) * _e296[2]))));
                    let _e324 = local.member_1[1u];
                    let _e343 = (select(_e324, -(_e324), (_e324 < 0f)) - (_e291[1] + (((select(_e269, -(_e269), (_e269 < 0f)) * _e296[0]) + (select(_e273, -(_e273), (_e273 < 0f)) * _e296[1])) + (select(_e277, -(_e277), (_e277 < 0f)) * _e296[2]))));
                    let _e346 = local.member_1[2u];
                    let _e365 = (select(_e346, -(_e346), (_e346 < 0f)) - (_e291[2] + (((select(_e281, -(_e281), (_e281 < 0f)) * _e296[0]) + (select(_e285, -(_e285), (_e285 < 0f)) * _e296[1])) + (select(_e289, -(_e289), (_e289 < 0f)) * _e296[2]))));
                    let _e368 = local.member_2[0u];
                    let _e387 = (select(_e368, -(_e368), (_e368 < 0f)) - (_e296[0] + (((select(_e257, -(_e257), (_e257 < 0f)) * _e291[0]) + (select(_e269, -(_e269), (_e269 < 0f)) * _e291[1])) + (select(_e281, -(_e281), (_e281 < 0f)) * _e291[2]))));
                    let _e390 = local.member_2[1u];
                    let _e409 = (select(_e390, -(_e390), (_e390 < 0f)) - (_e296[1] + (((select(_e261, -(_e261), (_e261 < 0f)) * _e291[0]) + (select(_e273, -(_e273), (_e273 < 0f)) * _e291[1])) + (select(_e285, -(_e285), (_e285 < 0f)) * _e291[2]))));
                    let _e412 = local.member_2[2u];
                    let _e431 = (select(_e412, -(_e412), (_e412 < 0f)) - (_e296[2] + (((select(_e265, -(_e265), (_e265 < 0f)) * _e291[0]) + (select(_e277, -(_e277), (_e277 < 0f)) * _e291[1])) + (select(_e289, -(_e289), (_e289 < 0f)) * _e291[2]))));
                    let _e433 = select(_e343, _e321, (_e321 > _e343));
                    let _e435 = select(_e365, _e433, (_e433 > _e365));
                    let _e437 = select(_e409, _e387, (_e387 > _e409));
                    let _e439 = select(_e431, _e437, (_e437 > _e431));
                    let _e443 = local.member_5;
                    if (select(_e439, _e435, (_e435 > _e439)) > _e443) {
                        phi_2098_ = true;
                    } else {
                        let _e448 = local.member[1u][0u];
                        let _e451 = local.member_1[2u];
                        let _e456 = local.member[2u][0u];
                        let _e459 = local.member_1[1u];
                        let _e461 = ((_e448 * _e451) - (_e456 * _e459));
                        let _e465 = local.member[2u][0u];
                        let _e471 = local.member_3[1u];
                        let _e476 = local.member[1u][0u];
                        let _e482 = local.member_3[2u];
                        let _e488 = local.member[0u][2u];
                        let _e494 = local.member_4[1u];
                        let _e499 = local.member[0u][1u];
                        let _e505 = local.member_4[2u];
                        let _e512 = (select(_e461, -(_e461), (_e461 < 0f)) - (((select(_e465, -(_e465), (_e465 < 0f)) * _e471) + (select(_e476, -(_e476), (_e476 < 0f)) * _e482)) + ((select(_e488, -(_e488), (_e488 < 0f)) * _e494) + (select(_e499, -(_e499), (_e499 < 0f)) * _e505))));
                        let _e516 = local.member[1u][1u];
                        let _e519 = local.member_1[2u];
                        let _e524 = local.member[2u][1u];
                        let _e527 = local.member_1[1u];
                        let _e529 = ((_e516 * _e519) - (_e524 * _e527));
                        let _e533 = local.member[2u][1u];
                        let _e539 = local.member_3[1u];
                        let _e544 = local.member[1u][1u];
                        let _e550 = local.member_3[2u];
                        let _e556 = local.member[0u][0u];
                        let _e562 = local.member_4[2u];
                        let _e567 = local.member[0u][2u];
                        let _e573 = local.member_4[0u];
                        let _e580 = (select(_e529, -(_e529), (_e529 < 0f)) - (((select(_e533, -(_e533), (_e533 < 0f)) * _e539) + (select(_e544, -(_e544), (_e544 < 0f)) * _e550)) + ((select(_e556, -(_e556), (_e556 < 0f)) * _e562) + (select(_e567, -(_e567), (_e567 < 0f)) * _e573))));
                        let _e584 = local.member[1u][2u];
                        let _e587 = local.member_1[2u];
                        let _e592 = local.member[2u][2u];
                        let _e595 = local.member_1[1u];
                        let _e597 = ((_e584 * _e587) - (_e592 * _e595));
                        let _e601 = local.member[2u][2u];
                        let _e607 = local.member_3[1u];
                        let _e612 = local.member[1u][2u];
                        let _e618 = local.member_3[2u];
                        let _e624 = local.member[0u][1u];
                        let _e630 = local.member_4[0u];
                        let _e635 = local.member[0u][0u];
                        let _e641 = local.member_4[1u];
                        let _e648 = (select(_e597, -(_e597), (_e597 < 0f)) - (((select(_e601, -(_e601), (_e601 < 0f)) * _e607) + (select(_e612, -(_e612), (_e612 < 0f)) * _e618)) + ((select(_e624, -(_e624), (_e624 < 0f)) * _e630) + (select(_e635, -(_e635), (_e635 < 0f)) * _e641))));
                        let _e652 = local.member[2u][0u];
                        let _e655 = local.member_1[0u];
                        let _e660 = local.member[0u][0u];
                        let _e663 = local.member_1[2u];
                        let _e665 = ((_e652 * _e655) - (_e660 * _e663));
                        let _e669 = local.member[0u][0u];
                        let _e675 = local.member_3[2u];
                        let _e680 = local.member[2u][0u];
                        let _e686 = local.member_3[0u];
                        let _e692 = local.member[1u][2u];
                        let _e698 = local.member_4[1u];
                        let _e703 = local.member[1u][1u];
                        let _e709 = local.member_4[2u];
                        let _e716 = (select(_e665, -(_e665), (_e665 < 0f)) - (((select(_e669, -(_e669), (_e669 < 0f)) * _e675) + (select(_e680, -(_e680), (_e680 < 0f)) * _e686)) + ((select(_e692, -(_e692), (_e692 < 0f)) * _e698) + (select(_e703, -(_e703), (_e703 < 0f)) * _e709))));
                        let _e720 = local.member[2u][1u];
                        let _e723 = local.member_1[0u];
                        let _e728 = local.member[0u][1u];
                        let _e731 = local.member_1[2u];
                        let _e733 = ((_e720 * _e723) - (_e728 * _e731));
                        let _e737 = local.member[0u][1u];
                        let _e743 = local.member_3[2u];
                        let _e748 = local.member[2u][1u];
                        let _e754 = local.member_3[0u];
                        let _e760 = local.member[1u][0u];
                        let _e766 = local.member_4[2u];
                        let _e771 = local.member[1u][2u];
                        let _e777 = local.member_4[0u];
                        let _e784 = (select(_e733, -(_e733), (_e733 < 0f)) - (((select(_e737, -(_e737), (_e737 < 0f)) * _e743) + (select(_e748, -(_e748), (_e748 < 0f)) * _e754)) + ((select(_e760, -(_e760), (_e760 < 0f)) * _e766) + (select(_e771, -(_e771), (_e771 < 0f)) * _e777))));
                        let _e788 = local.member[2u][2u];
                        let _e791 = local.member_1[0u];
                        let _e796 = local.member[0u][2u];
                        let _e799 = local.member_1[2u];
                        let _e801 = ((_e788 * _e791) - (_e796 * _e799));
                        let _e805 = local.member[0u][2u];
                        let _e811 = local.member_3[2u];
                        let _e816 = local.member[2u][2u];
                        let _e822 = local.member_3[0u];
                        let _e828 = local.member[1u][1u];
                        let _e834 = local.member_4[0u];
                        let _e839 = local.member[1u][0u];
                        let _e845 = local.member_4[1u];
                        let _e852 = (select(_e801, -(_e801), (_e801 < 0f)) - (((select(_e805, -(_e805), (_e805 < 0f)) * _e811) + (select(_e816, -(_e816), (_e816 < 0f)) * _e822)) + ((select(_e828, -(_e828), (_e828 < 0f)) * _e834) + (select(_e839, -(_e839), (_e839 < 0f)) * _e845))));
                        let _e856 = local.member[0u][0u];
                        let _e859 = local.member_1[1u];
                        let _e864 = local.member[1u][0u];
                        let _e867 = local.member_1[0u];
                        let _e869 = ((_e856 * _e859) - (_e864 * _e867));
                        let _e873 = local.member[1u][0u];
                        let _e879 = local.member_3[0u];
                        let _e884 = local.member[0u][0u];
                        let _e890 = local.member_3[1u];
                        let _e896 = local.member[2u][2u];
                        let _e902 = local.member_4[1u];
                        let _e907 = local.member[2u][1u];
                        let _e913 = local.member_4[2u];
                        let _e920 = (select(_e869, -(_e869), (_e869 < 0f)) - (((select(_e873, -(_e873), (_e873 < 0f)) * _e879) + (select(_e884, -(_e884), (_e884 < 0f)) * _e890)) + ((select(_e896, -(_e896), (_e896 < 0f)) * _e902) + (select(_e907, -(_e907), (_e907 < 0f)) * _e913))));
                        let _e924 = local.member[0u][1u];
                        let _e927 = local.member_1[1u];
                        let _e932 = local.member[1u][1u];
                        let _e935 = local.member_1[0u];
                        let _e937 = ((_e924 * _e927) - (_e932 * _e935));
                        let _e941 = local.member[1u][1u];
                        let _e947 = local.member_3[0u];
                        let _e952 = local.member[0u][1u];
                        let _e958 = local.member_3[1u];
                        let _e964 = local.member[2u][0u];
                        let _e970 = local.member_4[2u];
                        let _e975 = local.member[2u][2u];
                        let _e981 = local.member_4[0u];
                        let _e988 = (select(_e937, -(_e937), (_e937 < 0f)) - (((select(_e941, -(_e941), (_e941 < 0f)) * _e947) + (select(_e952, -(_e952), (_e952 < 0f)) * _e958)) + ((select(_e964, -(_e964), (_e964 < 0f)) * _e970) + (select(_e975, -(_e975), (_e975 < 0f)) * _e981))));
                        let _e992 = local.member[0u][2u];
                        let _e995 = local.member_1[1u];
                        let _e1000 = local.member[1u][2u];
                        let _e1003 = local.member_1[0u];
                        let _e1005 = ((_e992 * _e995) - (_e1000 * _e1003));
                        let _e1009 = local.member[1u][2u];
                        let _e1015 = local.member_3[0u];
                        let _e1020 = local.member[0u][2u];
                        let _e1026 = local.member_3[1u];
                        let _e1032 = local.member[2u][1u];
                        let _e1038 = local.member_4[0u];
                        let _e1043 = local.member[2u][0u];
                        let _e1049 = local.member_4[1u];
                        let _e1056 = (select(_e1005, -(_e1005), (_e1005 < 0f)) - (((select(_e1009, -(_e1009), (_e1009 < 0f)) * _e1015) + (select(_e1020, -(_e1020), (_e1020 < 0f)) * _e1026)) + ((select(_e1032, -(_e1032), (_e1032 < 0f)) * _e1038) + (select(_e1043, -(_e1043), (_e1043 < 0f)) * _e1049))));
                        let _e1058 = select(_e580, _e512, (_e512 > _e580));
                        let _e1060 = select(_e648, _e1058, (_e1058 > _e648));
                        let _e1062 = select(_e784, _e716, (_e716 > _e784));
                        let _e1064 = select(_e852, _e1062, (_e1062 > _e852));
                        let _e1066 = select(_e1064, _e1060, (_e1060 > _e1064));
                        let _e1068 = select(_e988, _e920, (_e920 > _e988));
                        let _e1070 = select(_e1056, _e1068, (_e1068 > _e1056));
                        let _e1074 = local.member_5;
                        phi_2098_ = (select(_e1070, _e1066, (_e1066 > _e1070)) > _e1074);
                    }
                    let _e1077 = phi_2098_;
                    if !(_e1077) {
                        let _e1094 = local_1.member_2;
                        let _e1096 = nodes.member[_e1094];
                        let _e1133 = (_e57 == 4294967295u);
                        if select((_e1096.member_2.w > _e57), true, _e1133) {
                            phi_2171_ = ((((((bitcast<f32>(_e1096.member.x) <= _e65.member_1.y) && (_e65.member.x <= bitcast<f32>(_e1096.member_1.x))) && (bitcast<f32>(_e1096.member.y) <= _e65.member_2.x)) && (_e65.member.y <= bitcast<f32>(_e1096.member_1.y))) && (bitcast<f32>(_e1096.member.z) <= _e65.member_2.y)) && (_e65.member_1.x <= bitcast<f32>(_e1096.member_1.z)));
                        } else {
                            phi_2171_ = false;
                        }
                        let _e1149 = phi_2171_;
                        if select(((_e1096.member_3.w & 2147483647u) > _e57), true, _e1133) {
                            phi_2194_ = ((((((bitcast<f32>(_e1096.member_2.x) <= _e65.member_1.y) && (_e65.member.x <= bitcast<f32>(_e1096.member_3.x))) && (bitcast<f32>(_e1096.member_2.y) <= _e65.member_2.x)) && (_e65.member.y <= bitcast<f32>(_e1096.member_3.y))) && (bitcast<f32>(_e1096.member_2.z) <= _e65.member_2.y)) && (_e65.member_1.x <= bitcast<f32>(_e1096.member_3.z)));
                        } else {
                            phi_2194_ = false;
                        }
                        let _e1164 = phi_2194_;
                        let _e1166 = ((_e1096.member.w & 2147483648u) != 0u);
                        let _e1168 = ((_e1096.member_1.w & 2147483648u) != 0u);
                        let _e1174 = select(select(u32(), select(u32(), (_e1096.member.w & 2147483647u), _e1166), _e1149), 4294967295u, select(true, select(true, false, _e1166), _e1149));
                        let _e1180 = select(select(u32(), select(u32(), (_e1096.member_1.w & 2147483647u), _e1168), _e1164), 4294967295u, select(true, select(true, false, _e1168), _e1164));
                        let _e1182 = select(false, !(_e1166), _e1149);
                        let _e1184 = select(false, !(_e1168), _e1164);
                        if _e1182 {
                            if _e1184 {
                                let _e1186 = ((_e1096.member_3.w & 2147483648u) != 0u);
                                let _e1189 = local_1.member_1;
                                local_1.member[_e1189] = select(_e1096.member.w, _e1096.member_1.w, _e1186);
                                let _e1194 = local_1.member_1;
                                local_1.member_1 = (_e1194 + 1u);
                                local_1.member_2 = select(_e1096.member_1.w, _e1096.member.w, _e1186);
                                phi_2268_ = false;
                            } else {
                                phi_2268_ = true;
                            }
                            let _e1199 = phi_2268_;
                            phi_2269_ = _e1199;
                        } else {
                            phi_2269_ = true;
                        }
                        let _e1201 = phi_2269_;
                        if _e1201 {
                            if _e1182 {
                                local_1.member_2 = _e1096.member.w;
                            } else {
                                if _e1184 {
                                    local_1.member_2 = _e1096.member_1.w;
                                } else {
                                    let _e1203 = local_1.member_1;
                                    if (_e1203 > 0u) {
                                        let _e1208 = local_1.member_1;
                                        local_1.member_1 = (_e1208 - 1u);
                                        let _e1211 = local_1.member_1;
                                        let _e1214 = local_1.member[_e1211];
                                        local_1.member_2 = _e1214;
                                    } else {
                                        local_1.member_3 = false;
                                    }
                                }
                            }
                        }
                        if (_e1174 != 4294967295u) {
                            let _e1222 = params.member.member.member_2[1u];
                            let _e1225 = order.member[(_e1222 + _e1174)];
                            let _e1226 = (_e1225 - _e1222);
                            let _e1229 = params.member.member_1.member_3;
                            let _e1230 = (_e89 < _e1226);
                            let _e1234 = atomicAdd((&pairs.member[0u]), 1u);
                            if ((_e1234 + 1u) < _e1234) {
                                let _e1238 = atomicAdd((&pairs.member[2u]), 1u);
                            }
                            if (_e1234 < _e1229) {
                                let _e1240 = (2u * _e1234);
                                atomicStore((&pairs.member[(4u + _e1240)]), select(_e1226, _e89, _e1230));
                                atomicStore((&pairs.member[(_e1240 + 5u)]), select(_e89, _e1226, _e1230));
                            }
                        }
                        if (_e1180 != 4294967295u) {
                            let _e1249 = params.member.member.member_2[1u];
                            let _e1252 = order.member[(_e1249 + _e1180)];
                            let _e1253 = (_e1252 - _e1249);
                            let _e1256 = params.member.member_1.member_3;
                            let _e1257 = (_e89 < _e1253);
                            let _e1261 = atomicAdd((&pairs.member[0u]), 1u);
                            if ((_e1261 + 1u) < _e1261) {
                                let _e1265 = atomicAdd((&pairs.member[2u]), 1u);
                            }
                            if (_e1261 < _e1256) {
                                let _e1267 = (2u * _e1261);
                                atomicStore((&pairs.member[(4u + _e1267)]), select(_e1253, _e89, _e1257));
                                atomicStore((&pairs.member[(_e1267 + 5u)]), select(_e89, _e1253, _e1257));
                            }
                        }
                    } else {
                        let _e1080 = local_1.member_1;
                        if (_e1080 > 0u) {
                            let _e1085 = local_1.member_1;
                            local_1.member_1 = (_e1085 - 1u);
                            let _e1088 = local_1.member_1;
                            let _e1091 = local_1.member[_e1088];
                            local_1.member_2 = _e1091;
                        } else {
                            local_1.member_3 = false;
                        }
                    }
                }
                phi_2431_ = _e109;
            } else {
                phi_2431_ = false;
            }
            let _e1273 = phi_2431_;
            continue;
            continuing {
                phi_231_ = type_9(select(_e93.member, (_e93.member + 1u), _e96), select(_e93.member_1, _e93.member_1, _e96));
                break if !(_e1273);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn traverse_half_oriented(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}

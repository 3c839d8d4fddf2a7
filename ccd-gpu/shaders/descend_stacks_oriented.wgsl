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
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
}

struct type_17 {
    member: array<type_15>,
}

struct type_19 {
    member: array<u32, 64>,
    member_1: u32,
}

struct type_20 {
    member: type_19,
    member_1: type_19,
}

struct type_21 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
    member_7: u32,
    member_8: u32,
    member_9: u32,
    member_10: u32,
    member_11: u32,
    member_12: u32,
    member_13: u32,
    member_14: u32,
    member_15: u32,
    member_16: u32,
    member_17: u32,
    member_18: u32,
}

struct type_22 {
    member: type_7,
    member_1: type_8,
    member_2: type_21,
}

struct type_23 {
    member: type_22,
}

struct type_25 {
    member: array<array<u32, 2>, 4>,
    member_1: array<array<u32, 2>, 4>,
}

struct type_27 {
    member: array<array<f32, 3>, 3>,
    member_1: array<f32, 3>,
    member_2: array<f32, 3>,
    member_3: array<f32, 3>,
    member_4: array<f32, 3>,
    member_5: f32,
}

struct type_29 {
    member: vec4<f32>,
    member_1: vec4<f32>,
    member_2: vec4<f32>,
    member_3: vec4<f32>,
}

struct type_31 {
    member: array<type_29>,
}

struct type_32 {
    member: array<f32, 3>,
    member_1: array<array<f32, 3>, 3>,
    member_2: array<f32, 3>,
}

struct type_35 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_23;
@group(0) @binding(1) 
var<storage> a_nodes: type_17;
@group(0) @binding(2) 
var<storage> b_nodes: type_17;
@group(0) @binding(3) 
var<storage> oriented: type_31;
@group(0) @binding(4) 
var<storage> input: type_11;
@group(0) @binding(5) 
var<storage, read_write> rounds: type_35;
@group(0) @binding(6) 
var<storage, read_write> output: type_35;
@group(0) @binding(7) 
var<storage, read_write> pairs: type_35;

fn function_(param: u32) -> u32 {
    return param;
}

fn function_1(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_27;
    var local_1: array<array<u32, 2>, 4>;
    var local_2: type_27;
    var local_3: type_20;
    var phi_318_: array<u32, 2>;
    var phi_319_: array<u32, 2>;
    var phi_320_: array<u32, 2>;
    var phi_369_: bool;
    var phi_370_: bool;
    var phi_371_: bool;
    var phi_372_: bool;
    var phi_677_: type_32;
    var phi_821_: type_32;
    var phi_2722_: bool;
    var phi_2724_: bool;
    var phi_2725_: bool;
    var phi_2726_: bool;
    var phi_2727_: bool;
    var phi_2732_: bool;
    var phi_2737_: array<u32, 2>;
    var phi_2738_: array<u32, 2>;
    var phi_2739_: array<u32, 2>;
    var phi_219_: array<u32, 2>;
    var phi_2740_: array<u32, 2>;
    var phi_2993_: type_9;
    var phi_3114_: type_9;
    var phi_3181_: array<u32, 2>;
    var phi_3322_: type_25;
    var phi_3323_: type_25;
    var phi_3324_: bool;
    var phi_3325_: type_25;
    var phi_3326_: bool;
    var phi_3386_: bool;
    var phi_3387_: bool;
    var phi_3388_: bool;
    var phi_3389_: bool;
    var phi_3390_: bool;
    var phi_3391_: bool;
    var phi_3586_: type_25;
    var phi_3587_: bool;
    var phi_3588_: type_25;
    var phi_3589_: bool;
    var phi_3796_: type_25;
    var phi_3797_: type_25;
    var phi_3798_: type_25;
    var phi_3799_: bool;
    var phi_3800_: type_25;
    var phi_3801_: type_25;
    var phi_3802_: bool;
    var phi_3806_: type_25;
    var phi_3900_: type_9;
    var phi_4113_: type_32;
    var phi_4257_: type_32;
    var phi_6158_: bool;
    var phi_6160_: bool;
    var phi_6161_: bool;
    var phi_6162_: bool;
    var phi_6163_: bool;
    var phi_6304_: type_9;
    var phi_6529_: type_9;
    var phi_6754_: type_9;
    var phi_6979_: type_9;
    var phi_7095_: bool;
    var phi_7096_: bool;
    var phi_7099_: type_9;
    var phi_7166_: array<u32, 2>;
    var phi_7209_: bool;
    var phi_7210_: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e46 = id_2;
    let _e47 = n_2;
    let _e48 = lane_2;
    let _e63 = ((((_e46.y * _e47.x) + _e46.x) * 128u) + _e48);
    let _e67 = params.member.member_1.member_1;
    if (_e67 > 0u) {
        let _e1538 = params.member.member_1.member_1;
        let _e1540 = atomicLoad((&rounds.member[_e1538]));
        let _e1543 = params.member.member_1.member_2;
        if (_e63 < select(_e1540, _e1543, (_e1543 < _e1540))) {
            let _e1547 = (2u * _e63);
            let _e1550 = input.member[(4u + _e1547)];
            let _e1553 = input.member[(_e1547 + 5u)];
            phi_219_ = array<u32, 2>(_e1550, _e1553);
        } else {
            phi_219_ = array<u32, 2>(4294967295u, 4294967295u);
        }
        let _e1556 = phi_219_;
        phi_2740_ = _e1556;
    } else {
        let _e71 = params.member.member_2.member_2;
        let _e74 = params.member.member_2.member_2;
        if (_e63 < (_e71 * _e74)) {
            let _e78 = params.member.member_2.member_2;
            if (_e78 == 0u) {
                return;
            }
            let _e80 = (_e63 / _e78);
            let _e82 = params.member.member_2.member_2;
            if (_e82 == 0u) {
                return;
            }
            let _e84 = (_e63 % _e82);
            let _e86 = params.member.member_2.member;
            let _e87 = (_e86 == 1u);
            let _e89 = (select(1u, 0u, _e87) * 1028u);
            let _e91 = input.member[0u];
            if (_e80 < _e91) {
                let _e94 = input.member[_e89];
                if (_e84 < _e94) {
                    if select(true, (_e80 <= _e84), _e87) {
                        let _e100 = input.member[(4u + _e80)];
                        let _e104 = input.member[((_e89 + 4u) + _e84)];
                        phi_318_ = array<u32, 2>(_e100, _e104);
                    } else {
                        phi_318_ = array<u32, 2>(4294967295u, 4294967295u);
                    }
                    let _e107 = phi_318_;
                    phi_319_ = _e107;
                } else {
                    phi_319_ = array<u32, 2>(4294967295u, 4294967295u);
                }
                let _e109 = phi_319_;
                phi_320_ = _e109;
            } else {
                phi_320_ = array<u32, 2>(4294967295u, 4294967295u);
            }
            let _e111 = phi_320_;
            if (_e111[0] != 4294967295u) {
                let _e116 = params.member.member_2.member;
                if (_e116 == 1u) {
                    if (_e111[0] == _e111[1]) {
                        let _e123 = a_nodes.member[_e111[0]];
                        phi_369_ = (_e123.member_3 == 4294967295u);
                        phi_370_ = false;
                    } else {
                        phi_369_ = bool();
                        phi_370_ = true;
                    }
                    let _e127 = phi_369_;
                    let _e129 = phi_370_;
                    phi_371_ = _e127;
                    phi_372_ = _e129;
                } else {
                    phi_371_ = bool();
                    phi_372_ = true;
                }
                let _e131 = phi_371_;
                let _e133 = phi_372_;
                if select(_e131, false, _e133) {
                    phi_2737_ = array<u32, 2>(4294967295u, 4294967295u);
                } else {
                    let _e137 = a_nodes.member[_e111[0]];
                    let _e140 = b_nodes.member[_e111[1]];
                    if ((((((_e137.member[0] <= _e140.member_2[0]) && (_e140.member[0] <= _e137.member_2[0])) && (_e137.member[1] <= _e140.member_2[1])) && (_e140.member[1] <= _e137.member_2[1])) && (_e137.member[2] <= _e140.member_2[2])) && (_e140.member[2] <= _e137.member_2[2])) {
                        let _e170 = params.member.member_2.member;
                        let _e171 = (_e170 == 0u);
                        let _e177 = params.member.member.member[select(1u, 0u, _e171)];
                        let _e178 = (_e177 - 1u);
                        let _e182 = params.member.member.member[select(1u, 2u, _e171)];
                        let _e183 = (_e182 - 1u);
                        let _e186 = params.member.member_2.member;
                        let _e187 = (_e186 == 0u);
                        let _e193 = params.member.member.member_2[select(1u, 0u, _e187)];
                        let _e197 = params.member.member.member_2[select(1u, 2u, _e187)];
                        let _e200 = params.member.member_2.member;
                        if select(false, (_e111[0] == _e111[1]), (_e200 == 1u)) {
                            phi_2726_ = bool();
                            phi_2727_ = true;
                        } else {
                            if select(true, select(true, false, (_e111[1] >= _e183)), (_e111[0] >= _e178)) {
                                if (_e111[0] < _e178) {
                                    let _e280 = oriented.member[(_e193 + _e111[0])];
                                    phi_677_ = type_32(array<f32, 3>(_e280.member.x, _e280.member.y, _e280.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e280.member.w, _e280.member_1.x, _e280.member_1.y), array<f32, 3>(_e280.member_1.z, _e280.member_1.w, _e280.member_2.x), array<f32, 3>(_e280.member_2.y, _e280.member_2.z, _e280.member_2.w)), array<f32, 3>(_e280.member_3.x, _e280.member_3.y, _e280.member_3.z));
                                } else {
                                    let _e212 = a_nodes.member[_e111[0]];
                                    let _e227 = ((_e212.member[0] * 0.5f) + (_e212.member_2[0] * 0.5f));
                                    let _e228 = ((_e212.member[1] * 0.5f) + (_e212.member_2[1] * 0.5f));
                                    let _e229 = ((_e212.member[2] * 0.5f) + (_e212.member_2[2] * 0.5f));
                                    let _e232 = select(_e212.member_2[0], _e227, (_e227 < _e212.member_2[0]));
                                    let _e235 = select(_e212.member_2[1], _e228, (_e228 < _e212.member_2[1]));
                                    let _e238 = select(_e212.member_2[2], _e229, (_e229 < _e212.member_2[2]));
                                    let _e241 = select(_e212.member[0], _e232, (_e232 > _e212.member[0]));
                                    let _e244 = select(_e212.member[1], _e235, (_e235 > _e212.member[1]));
                                    let _e247 = select(_e212.member[2], _e238, (_e238 > _e212.member[2]));
                                    let _e250 = (_e212.member_2[0] - _e241);
                                    let _e252 = (_e212.member_2[1] - _e244);
                                    let _e254 = (_e212.member_2[2] - _e247);
                                    let _e256 = (_e241 - _e212.member[0]);
                                    let _e258 = (_e244 - _e212.member[1]);
                                    let _e260 = (_e247 - _e212.member[2]);
                                    let _e268 = (1f + (0.000000059604645f * 4f));
                                    let _e272 = (0.000000000000000000000000000000000000011754944f * 8f);
                                    phi_677_ = type_32(array<f32, 3>(_e241, _e244, _e247), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((select(_e256, _e250, (_e250 > _e256)) * _e268) + _e272), ((select(_e258, _e252, (_e252 > _e258)) * _e268) + _e272), ((select(_e260, _e254, (_e254 > _e260)) * _e268) + _e272)));
                                }
                                let _e319 = phi_677_;
                                if (_e111[1] < _e183) {
                                    let _e390 = oriented.member[(_e197 + _e111[1])];
                                    phi_821_ = type_32(array<f32, 3>(_e390.member.x, _e390.member.y, _e390.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e390.member.w, _e390.member_1.x, _e390.member_1.y), array<f32, 3>(_e390.member_1.z, _e390.member_1.w, _e390.member_2.x), array<f32, 3>(_e390.member_2.y, _e390.member_2.z, _e390.member_2.w)), array<f32, 3>(_e390.member_3.x, _e390.member_3.y, _e390.member_3.z));
                                } else {
                                    let _e322 = b_nodes.member[_e111[1]];
                                    let _e337 = ((_e322.member[0] * 0.5f) + (_e322.member_2[0] * 0.5f));
                                    let _e338 = ((_e322.member[1] * 0.5f) + (_e322.member_2[1] * 0.5f));
                                    let _e339 = ((_e322.member[2] * 0.5f) + (_e322.member_2[2] * 0.5f));
                                    let _e342 = select(_e322.member_2[0], _e337, (_e337 < _e322.member_2[0]));
                                    let _e345 = select(_e322.member_2[1], _e338, (_e338 < _e322.member_2[1]));
                                    let _e348 = select(_e322.member_2[2], _e339, (_e339 < _e322.member_2[2]));
                                    let _e351 = select(_e322.member[0], _e342, (_e342 > _e322.member[0]));
                                    let _e354 = select(_e322.member[1], _e345, (_e345 > _e322.member[1]));
                                    let _e357 = select(_e322.member[2], _e348, (_e348 > _e322.member[2]));
                                    let _e360 = (_e322.member_2[0] - _e351);
                                    let _e362 = (_e322.member_2[1] - _e354);
                                    let _e364 = (_e322.member_2[2] - _e357);
                                    let _e366 = (_e351 - _e322.member[0]);
                                    let _e368 = (_e354 - _e322.member[1]);
                                    let _e370 = (_e357 - _e322.member[2]);
                                    let _e378 = (1f + (0.000000059604645f * 4f));
                                    let _e382 = (0.000000000000000000000000000000000000011754944f * 8f);
                                    phi_821_ = type_32(array<f32, 3>(_e351, _e354, _e357), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((select(_e366, _e360, (_e360 > _e366)) * _e378) + _e382), ((select(_e368, _e362, (_e362 > _e368)) * _e378) + _e382), ((select(_e370, _e364, (_e364 > _e370)) * _e378) + _e382)));
                                }
                                let _e429 = phi_821_;
                                let _e434 = (_e429.member[0] - _e319.member[0]);
                                let _e437 = (_e429.member[1] - _e319.member[1]);
                                let _e440 = (_e429.member[2] - _e319.member[2]);
                                local_2 = type_27(array<array<f32, 3>, 3>(array<f32, 3>((((_e429.member_1[0][0] * _e319.member_1[0][0]) + (_e429.member_1[0][1] * _e319.member_1[0][1])) + (_e429.member_1[0][2] * _e319.member_1[0][2])), (((_e429.member_1[1][0] * _e319.member_1[0][0]) + (_e429.member_1[1][1] * _e319.member_1[0][1])) + (_e429.member_1[1][2] * _e319.member_1[0][2])), (((_e429.member_1[2][0] * _e319.member_1[0][0]) + (_e429.member_1[2][1] * _e319.member_1[0][1])) + (_e429.member_1[2][2] * _e319.member_1[0][2]))), array<f32, 3>((((_e429.member_1[0][0] * _e319.member_1[1][0]) + (_e429.member_1[0][1] * _e319.member_1[1][1])) + (_e429.member_1[0][2] * _e319.member_1[1][2])), (((_e429.member_1[1][0] * _e319.member_1[1][0]) + (_e429.member_1[1][1] * _e319.member_1[1][1])) + (_e429.member_1[1][2] * _e319.member_1[1][2])), (((_e429.member_1[2][0] * _e319.member_1[1][0]) + (_e429.member_1[2][1] * _e319.member_1[1][1])) + (_e429.member_1[2][2] * _e319.member_1[1][2]))), array<f32, 3>((((_e429.member_1[0][0] * _e319.member_1[2][0]) + (_e429.member_1[0][1] * _e319.member_1[2][1])) + (_e429.member_1[0][2] * _e319.member_1[2][2])), (((_e429.member_1[1][0] * _e319.member_1[2][0]) + (_e429.member_1[1][1] * _e319.member_1[2][1])) + (_e429.member_1[1][2] * _e319.member_1[2][2])), (((_e429.member_1[2][0] * _e319.member_1[2][0]) + (_e429.member_1[2][1] * _e319.member_1[2][1])) + (_e429.member_1[2][2] * _e319.member_1[2][2])))), array<f32, 3>((((_e319.member_1[0][0] * _e434) + (_e319.member_1[0][1] * _e437)) + (_e319.member_1[0][2] * _e440)), (((_e319.member_1[1][0] * _e434) + (_e319.member_1[1][1] * _e437)) + (_e319.member_1[1][2] * _e440)), (((_e319.member_1[2][0] * _e434) + (_e319.member_1[2][1] * _e437)) + (_e319.member_1[2][2] * _e440))), array<f32, 3>((((_e429.member_1[0][0] * _e434) + (_e429.member_1[0][1] * _e437)) + (_e429.member_1[0][2] * _e440)), (((_e429.member_1[1][0] * _e434) + (_e429.member_1[1][1] * _e437)) + (_e429.member_1[1][2] * _e440)), (((_e429.member_1[2][0] * _e434) + (_e429.member_1[2][1] * _e437)) + (_e429.member_1[2][2] * _e440))), array<f32, 3>(_e319.member_2[0], _e319.member_2[1], _e319.member_2[2]), array<f32, 3>(_e429.member_2[0], _e429.member_2[1], _e429.member_2[2]), ((((((select(_e434, -(_e434), (_e434 < 0f)) + select(_e437, -(_e437), (_e437 < 0f))) + select(_e440, -(_e440), (_e440 < 0f))) + (((select(_e319.member_2[0], -(_e319.member_2[0]), (_e319.member_2[0] < 0f)) + select(_e319.member_2[1], -(_e319.member_2[1]), (_e319.member_2[1] < 0f))) + select(_e319.member_2[2], -(_e319.member_2[2]), (_e319.member_2[2] < 0f))) + ((select(_e429.member_2[0], -(_e429.member_2[0]), (_e429.member_2[0] < 0f)) + select(_e429.member_2[1], -(_e429.member_2[1]), (_e429.member_2[1] < 0f))) + select(_e429.member_2[2], -(_e429.member_2[2]), (_e429.member_2[2] < 0f))))) * 2f) * (0.000000059604645f * 128f)) + (0.000000000000000000000000000000000000011754944f * 128f)));
                                let _e692 = local_2.member[0u][0u];
                                let _e696 = local_2.member[0u][1u];
                                let _e700 = local_2.member[0u][2u];
                                let _e704 = local_2.member[1u][0u];
                                let _e708 = local_2.member[1u][1u];
                                let _e712 = local_2.member[1u][2u];
                                let _e716 = local_2.member[2u][0u];
                                let _e720 = local_2.member[2u][1u];
                                let _e724 = local_2.member[2u][2u];
                                let _e726 = local_2.member_3;
                                let _e731 = local_2.member_4;
                                let _e737 = local_2.member_1[0u];
                                let _e756 = (select(_e737, -(_e737), (_e737 < 0f)) - (_e726[0] + (((select(_e692, -(_e692), (_e692 < 0f)) * _e731[0]) + (select(_e696, -(_e696), (_e696 < 0f)) * _e731[1])) + (select(_e700, -(_e700), (_e700 < 0f)) * _e731[2]))));
                                let _e759 = local_2.member_1[1u];
                                let _e778 = (select(_e759, -(_e759), (_e759 < 0f)) - (_e726[1] + (((select(_e704, -(_e704), (_e704 < 0f)) * _e731[0]) + (select(_e708, -(_e708), (_e708 < 0f)) * _e731[1])) + (select(_e712, -(_e712), (_e712 < 0f)) * _e731[2]))));
                                let _e781 = local_2.member_1[2u];
                                let _e800 = (select(_e781, -(_e781), (_e781 < 0f)) - (_e726[2] + (((select(_e716, -(_e716), (_e716 < 0f)) * _e731[0]) + (select(_e720, -(_e720), (_e720 < 0f)) * _e731[1])) + (select(_e724, -(_e724), (_e724 < 0f)) * _e731[2]))));
                                let _e803 = local_2.member_2[0u];
                                let _e822 = (select(_e803, -(_e803), (_e803 < 0f)) - (_e731[0] + (((select(_e692, -(_e692), (_e692 < 0f)) * _e726[0]) + (select(_e704, -(_e704), (_e704 < 0f)) * _e726[1])) + (select(_e716, -(_e716), (_e716 < 0f)) * _e726[2]))));
                                let _e825 = local_2.member_2[1u];
                                let _e844 = (select(_e825, -(_e825), (_e825 < 0f)) - (_e731[1] + (((select(_e696, -(_e696), (_e696 < 0f)) * _e726[0]) + (select(_e708, -(_e708), (_e708 < 0f)) * _e726[1])) + (select(_e720, -(_e720), (_e720 < 0f)) * _e726[2]))));
                                let _e847 = local_2.member_2[2u];
                                let _e866 = (select(_e847, -(_e847), (_e847 < 0f)) - (_e731[2] + (((select(_e700, -(_e700), (_e700 < 0f)) * _e726[0]) + (select(_e712, -(_e712), (_e712 < 0f)) * _e726[1])) + (select(_e724, -(_e724), (_e724 < 0f)) * _e726[2]))));
                                let _e868 = select(_e778, _e756, (_e756 > _e778));
                                let _e870 = select(_e800, _e868, (_e868 > _e800));
                                let _e872 = select(_e844, _e822, (_e822 > _e844));
                                let _e874 = select(_e866, _e872, (_e872 > _e866));
                                let _e878 = local_2.member_5;
                                if (select(_e874, _e870, (_e870 > _e874)) > _e878) {
                                    phi_2722_ = true;
                                } else {
                                    let _e883 = local_2.member[1u][0u];
                                    let _e886 = local_2.member_1[2u];
                                    let _e891 = local_2.member[2u][0u];
                                    let _e894 = local_2.member_1[1u];
                                    let _e896 = ((_e883 * _e886) - (_e891 * _e894));
                                    let _e900 = local_2.member[2u][0u];
                                    let _e906 = local_2.member_3[1u];
                                    let _e911 = local_2.member[1u][0u];
                                    let _e917 = local_2.member_3[2u];
                                    let _e923 = local_2.member[0u][2u];
                                    let _e929 = local_2.member_4[1u];
                                    let _e934 = local_2.member[0u][1u];
                                    let _e940 = local_2.member_4[2u];
                                    let _e947 = (select(_e896, -(_e896), (_e896 < 0f)) - (((select(_e900, -(_e900), (_e900 < 0f)) * _e906) + (select(_e911, -(_e911), (_e911 < 0f)) * _e917)) + ((select(_e923, -(_e923), (_e923 < 0f)) * _e929) + (select(_e934, -(_e934), (_e934 < 0f)) * _e940))));
                                    let _e951 = local_2.member[1u][1u];
                                    let _e954 = local_2.member_1[2u];
                                    let _e959 = local_2.member[2u][1u];
                                    let _e962 = local_2.member_1[1u];
                                    let _e964 = ((_e951 * _e954) - (_e959 * _e962));
                                    let _e968 = local_2.member[2u][1u];
                                    let _e974 = local_2.member_3[1u];
                                    let _e979 = local_2.member[1u][1u];
                                    let _e985 = local_2.member_3[2u];
                                    let _e991 = local_2.member[0u][0u];
                                    let _e997 = local_2.member_4[2u];
                                    let _e1002 = local_2.member[0u][2u];
                                    let _e1008 = local_2.member_4[0u];
                                    let _e1015 = (select(_e964, -(_e964), (_e964 < 0f)) - (((select(_e968, -(_e968), (_e968 < 0f)) * _e974) + (select(_e979, -(_e979), (_e979 < 0f)) * _e985)) + ((select(_e991, -(_e991), (_e991 < 0f)) * _e997) + (select(_e1002, -(_e1002), (_e1002 < 0f)) * _e1008))));
                                    let _e1019 = local_2.member[1u][2u];
                                    let _e1022 = local_2.member_1[2u];
                                    let _e1027 = local_2.member[2u][2u];
                                    let _e1030 = local_2.member_1[1u];
                                    let _e1032 = ((_e1019 * _e1022) - (_e1027 * _e1030));
                                    let _e1036 = local_2.member[2u][2u];
                                    let _e1042 = local_2.member_3[1u];
                                    let _e1047 = local_2.member[1u][2u];
                                    let _e1053 = local_2.member_3[2u];
                                    let _e1059 = local_2.member[0u][1u];
                                    let _e1065 = local_2.member_4[0u];
                                    let _e1070 = local_2.member[0u][0u];
                                    let _e1076 = local_2.member_4[1u];
                                    let _e1083 = (select(_e1032, -(_e1032), (_e1032 < 0f)) - (((select(_e1036, -(_e1036), (_e1036 < 0f)) * _e1042) + (select(_e1047, -(_e1047), (_e1047 < 0f)) * _e1053)) + ((select(_e1059, -(_e1059), (_e1059 < 0f)) * _e1065) + (select(_e1070, -(_e1070), (_e1070 < 0f)) * _e1076))));
                                    let _e1087 = local_2.member[2u][0u];
                                    let _e1090 = local_2.member_1[0u];
                                    let _e1095 = local_2.member[0u][0u];
                                    let _e1098 = local_2.member_1[2u];
                                    let _e1100 = ((_e1087 * _e1090) - (_e1095 * _e1098));
                                    let _e1104 = local_2.member[0u][0u];
                                    let _e1110 = local_2.member_3[2u];
                                    let _e1115 = local_2.member[2u][0u];
                                    let _e1121 = local_2.member_3[0u];
                                    let _e1127 = local_2.member[1u][2u];
                                    let _e1133 = local_2.member_4[1u];
                                    let _e1138 = local_2.member[1u][1u];
                                    let _e1144 = local_2.member_4[2u];
                                    let _e1151 = (select(_e1100, -(_e1100), (_e1100 < 0f)) - (((select(_e1104, -(_e1104), (_e1104 < 0f)) * _e1110) + (select(_e1115, -(_e1115), (_e1115 < 0f)) * _e1121)) + ((select(_e1127, -(_e1127), (_e1127 < 0f)) * _e1133) + (select(_e1138, -(_e1138), (_e1138 < 0f)) * _e1144))));
                                    let _e1155 = local_2.member[2u][1u];
                                    let _e1158 = local_2.member_1[0u];
                                    let _e1163 = local_2.member[0u][1u];
                                    let _e1166 = local_2.member_1[2u];
                                    let _e1168 = ((_e1155 * _e1158) - (_e1163 * _e1166));
                                    let _e1172 = local_2.member[0u][1u];
                                    let _e1178 = local_2.member_3[2u];
                                    let _e1183 = local_2.member[2u][1u];
                                    let _e1189 = local_2.member_3[0u];
                                    let _e1195 = local_2.member[1u][0u];
                                    let _e1201 = local_2.member_4[2u];
                                    let _e1206 = local_2.member[1u][2u];
                                    let _e1212 = local_2.member_4[0u];
                                    let _e1219 = (select(_e1168, -(_e1168), (_e1168 < 0f)) - (((select(_e1172, -(_e1172), (_e1172 < 0f)) * _e1178) + (select(_e1183, -(_e1183), (_e1183 < 0f)) * _e1189)) + ((select(_e1195, -(_e1195), (_e1195 < 0f)) * _e1201) + (select(_e1206, -(_e1206), (_e1206 < 0f)) * _e1212))));
                                    let _e1223 = local_2.member[2u][2u];
                                    let _e1226 = local_2.member_1[0u];
                                    let _e1231 = local_2.member[0u][2u];
                                    let _e1234 = local_2.member_1[2u];
                                    let _e1236 = ((_e1223 * _e1226) - (_e1231 * _e1234));
                                    let _e1240 = local_2.member[0u][2u];
                                    let _e1246 = local_2.member_3[2u];
                                    let _e1251 = local_2.member[2u][2u];
                                    let _e1257 = local_2.member_3[0u];
                                    let _e1263 = local_2.member[1u][1u];
                                    let _e1269 = local_2.member_4[0u];
                                    let _e1274 = local_2.member[1u][0u];
                                    let _e1280 = local_2.member_4[1u];
                                    let _e1287 = (select(_e1236, -(_e1236), (_e1236 < 0f)) - (((select(_e1240, -(_e1240), (_e1240 < 0f)) * _e1246) + (select(_e1251, -(_e1251), (_e1251 < 0f)) * _e1257)) + ((select(_e1263, -(_e1263), (_e1263 < 0f)) * _e1269) + (select(_e1274, -(_e1274), (_e1274 < 0f)) * _e1280))));
                                    let _e1291 = local_2.member[0u][0u];
                                    let _e1294 = local_2.member_1[1u];
                                    let _e1299 = local_2.member[1u][0u];
                                    let _e1302 = local_2.member_1[0u];
                                    let _e1304 = ((_e1291 * _e1294) - (_e1299 * _e1302));
                                    let _e1308 = local_2.member[1u][0u];
                                    let _e1314 = local_2.member_3[0u];
                                    let _e1319 = local_2.member[0u][0u];
                                    let _e1325 = local_2.member_3[1u];
                                    let _e1331 = local_2.member[2u][2u];
                                    let _e1337 = local_2.member_4[1u];
                                    let _e1342 = local_2.member[2u][1u];
                                    let _e1348 = local_2.member_4[2u];
                                    let _e1355 = (select(_e1304, -(_e1304), (_e1304 < 0f)) - (((select(_e1308, -(_e1308), (_e1308 < 0f)) * _e1314) + (select(_e1319, -(_e1319), (_e1319 < 0f)) * _e1325)) + ((select(_e1331, -(_e1331), (_e1331 < 0f)) * _e1337) + (select(_e1342, -(_e1342), (_e1342 < 0f)) * _e1348))));
                                    let _e1359 = local_2.member[0u][1u];
                                    let _e1362 = local_2.member_1[1u];
                                    let _e1367 = local_2.member[1u][1u];
                                    let _e1370 = local_2.member_1[0u];
                                    let _e1372 = ((_e1359 * _e1362) - (_e1367 * _e1370));
                                    let _e1376 = local_2.member[1u][1u];
                                    let _e1382 = local_2.member_3[0u];
                                    let _e1387 = local_2.member[0u][1u];
                                    let _e1393 = local_2.member_3[1u];
                                    let _e1399 = local_2.member[2u][0u];
                                    let _e1405 = local_2.member_4[2u];
                                    let _e1410 = local_2.member[2u][2u];
                                    let _e1416 = local_2.member_4[0u];
                                    let _e1423 = (select(_e1372, -(_e1372), (_e1372 < 0f)) - (((select(_e1376, -(_e1376), (_e1376 < 0f)) * _e1382) + (select(_e1387, -(_e1387), (_e1387 < 0f)) * _e1393)) + ((select(_e1399, -(_e1399), (_e1399 < 0f)) * _e1405) + (select(_e1410, -(_e1410), (_e1410 < 0f)) * _e1416))));
                                    let _e1427 = local_2.member[0u][2u];
                                    let _e1430 = local_2.member_1[1u];
                                    let _e1435 = local_2.member[1u][2u];
                                    let _e1438 = local_2.member_1[0u];
                                    let _e1440 = ((_e1427 * _e1430) - (_e1435 * _e1438));
                                    let _e1444 = local_2.member[1u][2u];
                                    let _e1450 = local_2.member_3[0u];
                                    let _e1455 = local_2.member[0u][2u];
                                    let _e1461 = local_2.member_3[1u];
                                    let _e1467 = local_2.member[2u][1u];
                                    let _e1473 = local_2.member_4[0u];
                                    let _e1478 = local_2.member[2u][0u];
                                    let _e1484 = local_2.member_4[1u];
                                    let _e1491 = (select(_e1440, -(_e1440), (_e1440 < 0f)) - (((select(_e1444, -(_e1444), (_e1444 < 0f)) * _e1450) + (select(_e1455, -(_e1455), (_e1455 < 0f)) * _e1461)) + ((select(_e1467, -(_e1467), (_e1467 < 0f)) * _e1473) + (select(_e1478, -(_e1478), (_e1478 < 0f)) * _e1484))));
                                    let _e1493 = select(_e1015, _e947, (_e947 > _e1015));
                                    let _e1495 = select(_e1083, _e1493, (_e1493 > _e1083));
                                    let _e1497 = select(_e1219, _e1151, (_e1151 > _e1219));
                                    let _e1499 = select(_e1287, _e1497, (_e1497 > _e1287));
                                    let _e1501 = select(_e1499, _e1495, (_e1495 > _e1499));
                                    let _e1503 = select(_e1423, _e1355, (_e1355 > _e1423));
                                    let _e1505 = select(_e1491, _e1503, (_e1503 > _e1491));
                                    let _e1509 = local_2.member_5;
                                    phi_2722_ = (select(_e1505, _e1501, (_e1501 > _e1505)) > _e1509);
                                }
                                let _e1512 = phi_2722_;
                                phi_2724_ = !(_e1512);
                                phi_2725_ = false;
                            } else {
                                phi_2724_ = bool();
                                phi_2725_ = true;
                            }
                            let _e1515 = phi_2724_;
                            let _e1517 = phi_2725_;
                            phi_2726_ = _e1515;
                            phi_2727_ = _e1517;
                        }
                        let _e1519 = phi_2726_;
                        let _e1521 = phi_2727_;
                        phi_2732_ = select(_e1519, true, _e1521);
                    } else {
                        phi_2732_ = false;
                    }
                    let _e1524 = phi_2732_;
                    phi_2737_ = array<u32, 2>(select(4294967295u, _e111[0], _e1524), select(4294967295u, _e111[1], _e1524));
                }
                let _e1531 = phi_2737_;
                phi_2738_ = _e1531;
            } else {
                phi_2738_ = array<u32, 2>(4294967295u, 4294967295u);
            }
            let _e1533 = phi_2738_;
            phi_2739_ = _e1533;
        } else {
            phi_2739_ = array<u32, 2>(4294967295u, 4294967295u);
        }
        let _e1535 = phi_2739_;
        phi_2740_ = _e1535;
    }
    let _e1558 = phi_2740_;
    local_3 = type_20(type_19(array<u32, 64>(u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32()), 0u), type_19(array<u32, 64>(u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32()), 0u));
    let _e1566 = params.member.member_2.member;
    let _e1567 = (_e1566 == 0u);
    let _e1573 = params.member.member.member[select(1u, 0u, _e1567)];
    let _e1578 = params.member.member.member[select(1u, 2u, _e1567)];
    let _e1589 = select(select(2u, 1u, select(true, select(true, false, (_e1558[1] >= (_e1578 - 1u))), (_e1558[0] >= (_e1573 - 1u)))), 0u, (_e1558[0] == 4294967295u));
    if (_e1589 == 2u) {
        let _e1649 = params.member.member_1.member_3;
        let _e1652 = a_nodes.member[_e1558[0]];
        let _e1656 = b_nodes.member[_e1558[1]];
        let _e1660 = params.member.member_2.member;
        if (_e1660 == 1u) {
            let _e1663 = (_e1652.member_1 < _e1656.member_1);
            phi_2993_ = type_9(select(_e1656.member_1, _e1652.member_1, _e1663), select(_e1652.member_1, _e1656.member_1, _e1663));
        } else {
            phi_2993_ = type_9(_e1652.member_1, _e1656.member_1);
        }
        let _e1668 = phi_2993_;
        let _e1672 = atomicAdd((&pairs.member[0u]), 1u);
        if ((_e1672 + 1u) < _e1672) {
            let _e1676 = atomicAdd((&pairs.member[2u]), 1u);
        }
        if (_e1672 < _e1649) {
            let _e1678 = (2u * _e1672);
            atomicStore((&pairs.member[(4u + _e1678)]), _e1668.member);
            atomicStore((&pairs.member[(_e1678 + 5u)]), _e1668.member_1);
        }
    } else {
        if (_e1589 == 1u) {
            let _e1594 = params.member.member_2.member_10;
            let _e1597 = local_3.member.member_1;
            let _e1600 = (_e1597 < select(_e1594, 64u, (64u < _e1594)));
            if _e1600 {
                let _e1603 = function_(_e1558[0]);
                let _e1605 = local_3.member.member_1;
                local_3.member.member[_e1605] = _e1603;
                let _e1610 = local_3.member.member_1;
                local_3.member.member_1 = (_e1610 + 1u);
                let _e1614 = function_(_e1558[1]);
                let _e1616 = local_3.member_1.member_1;
                local_3.member_1.member[_e1616] = _e1614;
                let _e1621 = local_3.member_1.member_1;
                local_3.member_1.member_1 = (_e1621 + 1u);
            }
            if _e1600 {
            } else {
                let _e1625 = params.member.member_1.member_1;
                let _e1628 = atomicAdd((&rounds.member[(_e1625 + 1u)]), 1u);
                let _e1631 = atomicMax((&output.member[0u]), (_e1628 + 1u));
                if ((_e1628 + 1u) < _e1628) {
                    let _e1635 = atomicAdd((&output.member[2u]), 1u);
                }
                let _e1638 = params.member.member_2.member_3;
                if (_e1628 < _e1638) {
                    let _e1642 = (2u * _e1628);
                    atomicStore((&output.member[(4u + _e1642)]), _e1558[0]);
                    atomicStore((&output.member[(_e1642 + 5u)]), _e1558[1]);
                }
            }
        }
    }
    let _e1685 = params.member.member_2.member_12;
    phi_3114_ = type_9(0u, _e1685);
    loop {
        let _e1688 = phi_3114_;
        let _e1691 = (_e1688.member < _e1688.member_1);
        if (bitcast<i32>(select(0u, 1u, _e1691)) != 0i) {
            let _e1705 = local_3.member.member_1;
            if (_e1705 > 0u) {
                let _e1710 = local_3.member.member_1;
                local_3.member.member_1 = (_e1710 - 1u);
                let _e1713 = local_3.member.member_1;
                let _e1716 = local_3.member.member[_e1713];
                let _e1720 = local_3.member_1.member_1;
                local_3.member_1.member_1 = (_e1720 - 1u);
                let _e1723 = local_3.member_1.member_1;
                let _e1726 = local_3.member_1.member[_e1723];
                phi_3181_ = array<u32, 2>(_e1716, _e1726);
            } else {
                phi_3181_ = array<u32, 2>(4294967295u, 4294967295u);
            }
            let _e1729 = phi_3181_;
            if (_e1729[0] == 4294967295u) {
                phi_7095_ = false;
            } else {
                let _e1734 = params.member.member_2.member_1;
                let _e1739 = params.member.member_2.member;
                let _e1744 = a_nodes.member[_e1729[0]];
                let _e1746 = b_nodes.member[_e1729[1]];
                if (_e1739 == 1u) {
                    if (_e1729[0] == _e1729[1]) {
                        if (_e1744.member_3 == 4294967295u) {
                            phi_3322_ = type_25(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)));
                        } else {
                            let _e1752 = a_nodes.member[_e1744.member_1];
                            let _e1755 = a_nodes.member[_e1744.member_3];
                            let _e1758 = !((_e1752.member_3 == 4294967295u));
                            let _e1769 = type_25(array<array<u32, 2>, 4>(array<u32, 2>(select(4294967295u, _e1744.member_1, _e1758), select(4294967295u, _e1744.member_1, _e1758)), type_25(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[1], type_25(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[2], type_25(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[3]), type_25(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1);
                            let _e1781 = type_25(array<array<u32, 2>, 4>(_e1769.member[0], array<u32, 2>(_e1744.member_1, _e1769.member[1][1]), _e1769.member[2], _e1769.member[3]), _e1769.member_1);
                            let _e1789 = type_25(array<array<u32, 2>, 4>(_e1781.member[0], array<u32, 2>(_e1744.member_1, _e1744.member_3), _e1781.member[2], _e1781.member[3]), _e1781.member_1);
                            let _e1792 = !((_e1755.member_3 == 4294967295u));
                            let _e1803 = type_25(array<array<u32, 2>, 4>(_e1789.member[0], _e1789.member[1], array<u32, 2>(select(4294967295u, _e1744.member_3, _e1792), select(4294967295u, _e1744.member_3, _e1792)), _e1789.member[3]), _e1789.member_1);
                            let _e1806 = type_25(_e1803.member, _e1803.member);
                            let _e1833 = ((((((_e1752.member[0] <= _e1755.member_2[0]) && (_e1755.member[0] <= _e1752.member_2[0])) && (_e1752.member[1] <= _e1755.member_2[1])) && (_e1755.member[1] <= _e1752.member_2[1])) && (_e1752.member[2] <= _e1755.member_2[2])) && (_e1755.member[2] <= _e1752.member_2[2]));
                            phi_3322_ = type_25(_e1806.member, array<array<u32, 2>, 4>(_e1806.member_1[0], array<u32, 2>(select(4294967295u, _e1744.member_1, _e1833), select(4294967295u, _e1744.member_3, _e1833)), _e1806.member_1[2], _e1806.member_1[3]));
                        }
                        let _e1845 = phi_3322_;
                        phi_3323_ = _e1845;
                        phi_3324_ = false;
                    } else {
                        phi_3323_ = type_25();
                        phi_3324_ = true;
                    }
                    let _e1847 = phi_3323_;
                    let _e1849 = phi_3324_;
                    phi_3325_ = _e1847;
                    phi_3326_ = _e1849;
                } else {
                    phi_3325_ = type_25();
                    phi_3326_ = true;
                }
                let _e1851 = phi_3325_;
                let _e1853 = phi_3326_;
                if _e1853 {
                    let _e1856 = !((_e1744.member_3 == 4294967295u));
                    let _e1859 = !((_e1746.member_3 == 4294967295u));
                    if select(_e1859, true, _e1856) {
                        if _e1856 {
                            if _e1859 {
                                if (select(0u, 1u, (_e1734 == 0u)) == 0u) {
                                    let _e1888 = ((((_e1746.member_2[0] - _e1746.member[0]) * (_e1746.member_2[1] - _e1746.member[1])) * (_e1746.member_2[2] - _e1746.member[2])) > (((_e1744.member_2[0] - _e1744.member[0]) * (_e1744.member_2[1] - _e1744.member[1])) * (_e1744.member_2[2] - _e1744.member[2])));
                                    phi_3386_ = _e1888;
                                    phi_3387_ = !(_e1888);
                                } else {
                                    phi_3386_ = _e1859;
                                    phi_3387_ = _e1856;
                                }
                                let _e1891 = phi_3386_;
                                let _e1893 = phi_3387_;
                                phi_3388_ = _e1891;
                                phi_3389_ = _e1893;
                            } else {
                                phi_3388_ = _e1859;
                                phi_3389_ = _e1856;
                            }
                            let _e1895 = phi_3388_;
                            let _e1897 = phi_3389_;
                            phi_3390_ = _e1895;
                            phi_3391_ = _e1897;
                        } else {
                            phi_3390_ = _e1859;
                            phi_3391_ = _e1856;
                        }
                        let _e1899 = phi_3390_;
                        let _e1901 = phi_3391_;
                        if _e1901 {
                            if _e1899 {
                                let _e1904 = a_nodes.member[_e1744.member_1];
                                let _e1909 = a_nodes.member[_e1744.member_3];
                                let _e1914 = b_nodes.member[_e1746.member_1];
                                let _e1919 = b_nodes.member[_e1746.member_3];
                                let _e1957 = ((((((_e1904.member[0] <= _e1914.member_2[0]) && (_e1914.member[0] <= _e1904.member_2[0])) && (_e1904.member[1] <= _e1914.member_2[1])) && (_e1914.member[1] <= _e1904.member_2[1])) && (_e1904.member[2] <= _e1914.member_2[2])) && (_e1914.member[2] <= _e1904.member_2[2]));
                                let _e1983 = ((((((_e1904.member[0] <= _e1919.member_2[0]) && (_e1919.member[0] <= _e1904.member_2[0])) && (_e1904.member[1] <= _e1919.member_2[1])) && (_e1919.member[1] <= _e1904.member_2[1])) && (_e1904.member[2] <= _e1919.member_2[2])) && (_e1919.member[2] <= _e1904.member_2[2]));
                                let _e2009 = ((((((_e1909.member[0] <= _e1914.member_2[0]) && (_e1914.member[0] <= _e1909.member_2[0])) && (_e1909.member[1] <= _e1914.member_2[1])) && (_e1914.member[1] <= _e1909.member_2[1])) && (_e1909.member[2] <= _e1914.member_2[2])) && (_e1914.member[2] <= _e1909.member_2[2]));
                                let _e2035 = ((((((_e1909.member[0] <= _e1919.member_2[0]) && (_e1919.member[0] <= _e1909.member_2[0])) && (_e1909.member[1] <= _e1919.member_2[1])) && (_e1919.member[1] <= _e1909.member_2[1])) && (_e1909.member[2] <= _e1919.member_2[2])) && (_e1919.member[2] <= _e1909.member_2[2]));
                                phi_3586_ = type_25(array<array<u32, 2>, 4>(array<u32, 2>(_e1744.member_1, _e1746.member_1), array<u32, 2>(_e1744.member_1, _e1746.member_3), array<u32, 2>(_e1744.member_3, _e1746.member_1), array<u32, 2>(_e1744.member_3, _e1746.member_3)), array<array<u32, 2>, 4>(array<u32, 2>(select(4294967295u, _e1744.member_1, _e1957), select(4294967295u, _e1746.member_1, _e1957)), array<u32, 2>(select(4294967295u, _e1744.member_1, _e1983), select(4294967295u, _e1746.member_3, _e1983)), array<u32, 2>(select(4294967295u, _e1744.member_3, _e2009), select(4294967295u, _e1746.member_1, _e2009)), array<u32, 2>(select(4294967295u, _e1744.member_3, _e2035), select(4294967295u, _e1746.member_3, _e2035))));
                                phi_3587_ = false;
                            } else {
                                phi_3586_ = type_25();
                                phi_3587_ = true;
                            }
                            let _e2042 = phi_3586_;
                            let _e2044 = phi_3587_;
                            phi_3588_ = _e2042;
                            phi_3589_ = _e2044;
                        } else {
                            phi_3588_ = type_25();
                            phi_3589_ = true;
                        }
                        let _e2046 = phi_3588_;
                        let _e2048 = phi_3589_;
                        if _e2048 {
                            if _e1901 {
                                let _e2133 = a_nodes.member[_e1744.member_1];
                                let _e2138 = a_nodes.member[_e1744.member_3];
                                let _e2167 = ((((((_e2133.member[0] <= _e1746.member_2[0]) && (_e1746.member[0] <= _e2133.member_2[0])) && (_e2133.member[1] <= _e1746.member_2[1])) && (_e1746.member[1] <= _e2133.member_2[1])) && (_e2133.member[2] <= _e1746.member_2[2])) && (_e1746.member[2] <= _e2133.member_2[2]));
                                let _e2177 = type_25(type_25(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member, array<array<u32, 2>, 4>(array<u32, 2>(select(4294967295u, _e1744.member_1, _e2167), select(4294967295u, _e1729[1], _e2167)), type_25(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[1], type_25(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[2], type_25(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[3]));
                                let _e2202 = ((((((_e2138.member[0] <= _e1746.member_2[0]) && (_e1746.member[0] <= _e2138.member_2[0])) && (_e2138.member[1] <= _e1746.member_2[1])) && (_e1746.member[1] <= _e2138.member_2[1])) && (_e2138.member[2] <= _e1746.member_2[2])) && (_e1746.member[2] <= _e2138.member_2[2]));
                                phi_3796_ = type_25(_e2177.member, array<array<u32, 2>, 4>(_e2177.member_1[0], array<u32, 2>(select(4294967295u, _e1744.member_3, _e2202), select(4294967295u, _e1729[1], _e2202)), _e2177.member_1[2], _e2177.member_1[3]));
                            } else {
                                let _e2051 = b_nodes.member[_e1746.member_1];
                                let _e2056 = b_nodes.member[_e1746.member_3];
                                let _e2085 = ((((((_e1744.member[0] <= _e2051.member_2[0]) && (_e2051.member[0] <= _e1744.member_2[0])) && (_e1744.member[1] <= _e2051.member_2[1])) && (_e2051.member[1] <= _e1744.member_2[1])) && (_e1744.member[2] <= _e2051.member_2[2])) && (_e2051.member[2] <= _e1744.member_2[2]));
                                let _e2095 = type_25(type_25(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member, array<array<u32, 2>, 4>(array<u32, 2>(select(4294967295u, _e1729[0], _e2085), select(4294967295u, _e1746.member_1, _e2085)), type_25(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[1], type_25(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[2], type_25(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[3]));
                                let _e2120 = ((((((_e1744.member[0] <= _e2056.member_2[0]) && (_e2056.member[0] <= _e1744.member_2[0])) && (_e1744.member[1] <= _e2056.member_2[1])) && (_e2056.member[1] <= _e1744.member_2[1])) && (_e1744.member[2] <= _e2056.member_2[2])) && (_e2056.member[2] <= _e1744.member_2[2]));
                                phi_3796_ = type_25(_e2095.member, array<array<u32, 2>, 4>(_e2095.member_1[0], array<u32, 2>(select(4294967295u, _e1729[0], _e2120), select(4294967295u, _e1746.member_3, _e2120)), _e2095.member_1[2], _e2095.member_1[3]));
                            }
                            let _e2214 = phi_3796_;
                            phi_3797_ = _e2214;
                        } else {
                            phi_3797_ = _e2046;
                        }
                        let _e2216 = phi_3797_;
                        phi_3798_ = _e2216;
                        phi_3799_ = false;
                    } else {
                        phi_3798_ = type_25();
                        phi_3799_ = true;
                    }
                    let _e2218 = phi_3798_;
                    let _e2220 = phi_3799_;
                    phi_3800_ = _e2218;
                    phi_3801_ = type_25(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)));
                    phi_3802_ = _e2220;
                } else {
                    phi_3800_ = type_25();
                    phi_3801_ = _e1851;
                    phi_3802_ = true;
                }
                let _e2222 = phi_3800_;
                let _e2224 = phi_3801_;
                let _e2226 = phi_3802_;
                if _e2226 {
                    phi_3806_ = _e2224;
                } else {
                    phi_3806_ = _e2222;
                }
                let _e2228 = phi_3806_;
                let _e2232 = params.member.member_2.member;
                let _e2233 = (_e2232 == 0u);
                let _e2239 = params.member.member.member[select(1u, 0u, _e2233)];
                let _e2240 = (_e2239 - 1u);
                let _e2244 = params.member.member.member[select(1u, 2u, _e2233)];
                let _e2245 = (_e2244 - 1u);
                let _e2248 = params.member.member_2.member;
                let _e2249 = (_e2248 == 0u);
                let _e2255 = params.member.member.member_2[select(1u, 0u, _e2249)];
                let _e2259 = params.member.member.member_2[select(1u, 2u, _e2249)];
                let _e2262 = params.member.member_2.member;
                local_1 = array<array<u32, 2>, 4>(array<u32, 2>(_e2228.member_1[0][0], _e2228.member_1[0][1]), array<u32, 2>(_e2228.member_1[1][0], _e2228.member_1[1][1]), array<u32, 2>(_e2228.member_1[2][0], _e2228.member_1[2][1]), array<u32, 2>(_e2228.member_1[3][0], _e2228.member_1[3][1]));
                phi_3900_ = type_9(0u, 4u);
                loop {
                    let _e2282 = phi_3900_;
                    let _e2285 = (_e2282.member < _e2282.member_1);
                    let _e2296 = select(type_9().member_1, _e2282.member, _e2285);
                    let _e2298 = (bitcast<i32>(select(0u, 1u, _e2285)) != 0i);
                    if _e2298 {
                        let _e2300 = local_1[_e2296];
                        if (_e2300[0] != 4294967295u) {
                            if select(false, (_e2300[0] == _e2300[1]), (_e2262 == 1u)) {
                                phi_6162_ = bool();
                                phi_6163_ = true;
                            } else {
                                if select(true, select(true, false, (_e2300[1] >= _e2245)), (_e2300[0] >= _e2240)) {
                                    if (_e2300[0] < _e2240) {
                                        let _e2380 = oriented.member[(_e2255 + _e2300[0])];
                                        phi_4113_ = type_32(array<f32, 3>(_e2380.member.x, _e2380.member.y, _e2380.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e2380.member.w, _e2380.member_1.x, _e2380.member_1.y), array<f32, 3>(_e2380.member_1.z, _e2380.member_1.w, _e2380.member_2.x), array<f32, 3>(_e2380.member_2.y, _e2380.member_2.z, _e2380.member_2.w)), array<f32, 3>(_e2380.member_3.x, _e2380.member_3.y, _e2380.member_3.z));
                                    } else {
                                        let _e2312 = a_nodes.member[_e2300[0]];
                                        let _e2327 = ((_e2312.member[0] * 0.5f) + (_e2312.member_2[0] * 0.5f));
                                        let _e2328 = ((_e2312.member[1] * 0.5f) + (_e2312.member_2[1] * 0.5f));
                                        let _e2329 = ((_e2312.member[2] * 0.5f) + (_e2312.member_2[2] * 0.5f));
                                        let _e2332 = select(_e2312.member_2[0], _e2327, (_e2327 < _e2312.member_2[0]));
                                        let _e2335 = select(_e2312.member_2[1], _e2328, (_e2328 < _e2312.member_2[1]));
                                        let _e2338 = select(_e2312.member_2[2], _e2329, (_e2329 < _e2312.member_2[2]));
                                        let _e2341 = select(_e2312.member[0], _e2332, (_e2332 > _e2312.member[0]));
                                        let _e2344 = select(_e2312.member[1], _e2335, (_e2335 > _e2312.member[1]));
                                        let _e2347 = select(_e2312.member[2], _e2338, (_e2338 > _e2312.member[2]));
                                        let _e2350 = (_e2312.member_2[0] - _e2341);
                                        let _e2352 = (_e2312.member_2[1] - _e2344);
                                        let _e2354 = (_e2312.member_2[2] - _e2347);
                                        let _e2356 = (_e2341 - _e2312.member[0]);
                                        let _e2358 = (_e2344 - _e2312.member[1]);
                                        let _e2360 = (_e2347 - _e2312.member[2]);
                                        let _e2368 = (1f + (0.000000059604645f * 4f));
                                        let _e2372 = (0.000000000000000000000000000000000000011754944f * 8f);
                                        phi_4113_ = type_32(array<f32, 3>(_e2341, _e2344, _e2347), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((select(_e2356, _e2350, (_e2350 > _e2356)) * _e2368) + _e2372), ((select(_e2358, _e2352, (_e2352 > _e2358)) * _e2368) + _e2372), ((select(_e2360, _e2354, (_e2354 > _e2360)) * _e2368) + _e2372)));
                                    }
                                    let _e2419 = phi_4113_;
                                    if (_e2300[1] < _e2245) {
                                        let _e2490 = oriented.member[(_e2259 + _e2300[1])];
                                        phi_4257_ = type_32(array<f32, 3>(_e2490.member.x, _e2490.member.y, _e2490.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e2490.member.w, _e2490.member_1.x, _e2490.member_1.y), array<f32, 3>(_e2490.member_1.z, _e2490.member_1.w, _e2490.member_2.x), array<f32, 3>(_e2490.member_2.y, _e2490.member_2.z, _e2490.member_2.w)), array<f32, 3>(_e2490.member_3.x, _e2490.member_3.y, _e2490.member_3.z));
                                    } else {
                                        let _e2422 = b_nodes.member[_e2300[1]];
                                        let _e2437 = ((_e2422.member[0] * 0.5f) + (_e2422.member_2[0] * 0.5f));
                                        let _e2438 = ((_e2422.member[1] * 0.5f) + (_e2422.member_2[1] * 0.5f));
                                        let _e2439 = ((_e2422.member[2] * 0.5f) + (_e2422.member_2[2] * 0.5f));
                                        let _e2442 = select(_e2422.member_2[0], _e2437, (_e2437 < _e2422.member_2[0]));
                                        let _e2445 = select(_e2422.member_2[1], _e2438, (_e2438 < _e2422.member_2[1]));
                                        let _e2448 = select(_e2422.member_2[2], _e2439, (_e2439 < _e2422.member_2[2]));
                                        let _e2451 = select(_e2422.member[0], _e2442, (_e2442 > _e2422.member[0]));
                                        let _e2454 = select(_e2422.member[1], _e2445, (_e2445 > _e2422.member[1]));
                                        let _e2457 = select(_e2422.member[2], _e2448, (_e2448 > _e2422.member[2]));
                                        let _e2460 = (_e2422.member_2[0] - _e2451);
                                        let _e2462 = (_e2422.member_2[1] - _e2454);
                                        let _e2464 = (_e2422.member_2[2] - _e2457);
                                        let _e2466 = (_e2451 - _e2422.member[0]);
                                        let _e2468 = (_e2454 - _e2422.member[1]);
                                        let _e2470 = (_e2457 - _e2422.member[2]);
                                        let _e2478 = (1f + (0.000000059604645f * 4f));
                                        let _e2482 = (0.000000000000000000000000000000000000011754944f * 8f);
                                        phi_4257_ = type_32(array<f32, 3>(_e2451, _e2454, _e2457), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((select(_e2466, _e2460, (_e2460 > _e2466)) * _e2478) + _e2482), ((select(_e2468, _e2462, (_e2462 > _e2468)) * _e2478) + _e2482), ((select(_e2470, _e2464, (_e2464 > _e2470)) * _e2478) + _e2482)));
                                    }
                                    let _e2529 = phi_4257_;
                                    let _e2534 = (_e2529.member[0] - _e2419.member[0]);
                                    let _e2537 = (_e2529.member[1] - _e2419.member[1]);
                                    let _e2540 = (_e2529.member[2] - _e2419.member[2]);
                                    local = type_27(array<array<f32, 3>, 3>(array<f32, 3>((((_e2529.member_1[0][0] * _e2419.member_1[0][0]) + (_e2529.member_1[0][1] * _e2419.member_1[0][1])) + (_e2529.member_1[0][2] * _e2419.member_1[0][2])), (((_e2529.member_1[1][0] * _e2419.member_1[0][0]) + (_e2529.member_1[1][1] * _e2419.member_1[0][1])) + (_e2529.member_1[1][2] * _e2419.member_1[0][2])), (((_e2529.member_1[2][0] * _e2419.member_1[0][0]) + (_e2529.member_1[2][1] * _e2419.member_1[0][1])) + (_e2529.member_1[2][2] * _e2419.member_1[0][2]))), array<f32, 3>((((_e2529.member_1[0][0] * _e2419.member_1[1][0]) + (_e2529.member_1[0][1] * _e2419.member_1[1][1])) + (_e2529.member_1[0][2] * _e2419.member_1[1][2])), (((_e2529.member_1[1][0] * _e2419.member_1[1][0]) + (_e2529.member_1[1][1] * _e2419.member_1[1][1])) + (_e2529.member_1[1][2] * _e2419.member_1[1][2])), (((_e2529.member_1[2][0] * _e2419.member_1[1][0]) + (_e2529.member_1[2][1] * _e2419.member_1[1][1])) + (_e2529.member_1[2][2] * _e2419.member_1[1][2]))), array<f32, 3>((((_e2529.member_1[0][0] * _e2419.member_1[2][0]) + (_e2529.member_1[0][1] * _e2419.member_1[2][1])) + (_e2529.member_1[0][2] * _e2419.member_1[2][2])), (((_e2529.member_1[1][0] * _e2419.member_1[2][0]) + (_e2529.member_1[1][1] * _e2419.member_1[2][1])) + (_e2529.member_1[1][2] * _e2419.member_1[2][2])), (((_e2529.member_1[2][0] * _e2419.member_1[2][0]) + (_e2529.member_1[2][1] * _e2419.member_1[2][1])) + (_e2529.member_1[2][2] * _e2419.member_1[2][2])))), array<f32, 3>((((_e2419.member_1[0][0] * _e2534) + (_e2419.member_1[0][1] * _e2537)) + (_e2419.member_1[0][2] * _e2540)), (((_e2419.member_1[1][0] * _e2534) + (_e2419.member_1[1][1] * _e2537)) + (_e2419.member_1[1][2] * _e2540)), (((_e2419.member_1[2][0] * _e2534) + (_e2419.member_1[2][1] * _e2537)) + (_e2419.member_1[2][2] * _e2540))), array<f32, 3>((((_e2529.member_1[0][0] * _e2534) + (_e2529.member_1[0][1] * _e2537)) + (_e2529.member_1[0][2] * _e2540)), (((_e2529.member_1[1][0] * _e2534) + (_e2529.member_1[1][1] * _e2537)) + (_e2529.member_1[1][2] * _e2540)), (((_e2529.member_1[2][0] * _e2534) + (_e2529.member_1[2][1] * _e2537)) + (_e2529.member_1[2][2] * _e2540))), array<f32, 3>(_e2419.member_2[0], _e2419.member_2[1], _e2419.member_2[2]), array<f32, 3>(_e2529.member_2[0], _e2529.member_2[1], _e2529.member_2[2]), ((((((select(_e2534, -(_e2534), (_e2534 < 0f)) + select(_e2537, -(_e2537), (_e2537 < 0f))) + select(_e2540, -(_e2540), (_e2540 < 0f))) + (((select(_e2419.member_2[0], -(_e2419.member_2[0]), (_e2419.member_2[0] < 0f)) + select(_e2419.member_2[1], -(_e2419.member_2[1]), (_e2419.member_2[1] < 0f))) + select(_e2419.member_2[2], -(_e2419.member_2[2]), (_e2419.member_2[2] < 0f))) + ((select(_e2529.member_2[0], -(_e2529.member_2[0]), (_e2529.member_2[0] < 0f)) + select(_e2529.member_2[1], -(_e2529.member_2[1]), (_e2529.member_2[1] < 0f))) + select(_e2529.member_2[2], -(_e2529.member_2[2]), (_e2529.member_2[2] < 0f))))) * 2f) * (0.000000059604645f * 128f)) + (0.000000000000000000000000000000000000011754944f * 128f)));
                                    let _e2792 = local.member[0u][0u];
                                    let _e2796 = local.member[0u][1u];
                                    let _e2800 = local.member[0u][2u];
                                    let _e2804 = local.member[1u][0u];
                                    let _e2808 = local.member[1u][1u];
                                    let _e2812 = local.member[1u][2u];
                                    let _e2816 = local.member[2u][0u];
                                    let _e2820 = local.member[2u][1u];
                                    let _e2824 = local.member[2u][2u];
                                    let _e2826 = local.member_3;
                                    let _e2831 = local.member_4;
                                    let _e2837 = local.member_1[0u];
                                    let _e2856 = (select(_e2837, -(_e2837), (_e2837 < 0f)) - (_e2826[0] + (((select(_e2792, -(_e2792), (_e2792 < 0f)) * _e2831[0]) + (select(_e2796, -(_e2796), (_e2796 < 0f)) * _e2831[1])) + (select(_e2800, -(_e2800), (_e2800 < 0f)) * _e2831[2]))));
                                    let _e2859 = local.member_1[1u];
                                    let _e2878 = (select(_e2859, -(_e2859), (_e2859 < 0f)) - (_e2826[1] + (((select(_e2804, -(_e2804), (_e2804 < 0f)) * _e2831[0]) + (select(_e2808, -(_e2808), (_e2808 < 0f)) * _e2831[1])) + (select(_e2812, -(_e2812), (_e2812 < 0f)) * _e2831[2]))));
                                    let _e2881 = local.member_1[2u];
                                    let _e2900 = (select(_e2881, -(_e2881), (_e2881 < 0f)) - (_e2826[2] + (((select(_e2816, -(_e2816), (_e2816 < 0f)) * _e2831[0]) + (select(_e2820, -(_e2820), (_e2820 < 0f)) * _e2831[1])) + (select(_e2824, -(_e2824), (_e2824 < 0f)) * _e2831[2]))));
                                    let _e2903 = local.member_2[0u];
                                    let _e2922 = (select(_e2903, -(_e2903), (_e2903 < 0f)) - (_e2831[0] + (((select(_e2792, -(_e2792), (_e2792 < 0f)) * _e2826[0]) + (select(_e2804, -(_e2804), (_e2804 < 0f)) * _e2826[1])) + (select(_e2816, -(_e2816), (_e2816 < 0f)) * _e2826[2]))));
                                    let _e2925 = local.member_2[1u];
                                    let _e2944 = (select(_e2925, -(_e2925), (_e2925 < 0f)) - (_e2831[1] + (((select(_e2796, -(_e2796), (_e2796 < 0f)) * _e2826[0]) + (select(_e2808, -(_e2808), (_e2808 < 0f)) * _e2826[1])) + (select(_e2820, -(_e2820), (_e2820 < 0f)) * _e2826[2]))));
                                    let _e2947 = local.member_2[2u];
                                    let _e2966 = (select(_e2947, -(_e2947), (_e2947 < 0f)) - (_e2831[2] + (((select(_e2800, -(_e2800), (_e2800 < 0f)) * _e2826[0]) + (select(_e2812, -(_e2812), (_e2812 < 0f)) * _e2826[1])) + (select(_e2824, -(_e2824), (_e2824 < 0f)) * _e2826[2]))));
                                    let _e2968 = select(_e2878, _e2856, (_e2856 > _e2878));
                                    let _e2970 = select(_e2900, _e2968, (_e2968 > _e2900));
                                    let _e2972 = select(_e2944, _e2922, (_e2922 > _e2944));
                                    let _e2974 = select(_e2966, _e2972, (_e2972 > _e2966));
                                    let _e2978 = local.member_5;
                                    if (select(_e2974, _e2970, (_e2970 > _e2974)) > _e2978) {
                                        phi_6158_ = true;
                                    } else {
                                        let _e2983 = local.member[1u][0u];
                                        let _e2986 = local.member_1[2u];
                                        let _e2991 = local.member[2u][0u];
                                        let _e2994 = local.member_1[1u];
                                        let _e2996 = ((_e2983 * _e2986) - (_e2991 * _e2994));
                                        let _e3000 = local.member[2u][0u];
                                        let _e3006 = local.member_3[1u];
                                        let _e3011 = local.member[1u][0u];
                                        let _e3017 = local.member_3[2u];
                                        let _e3023 = local.member[0u][2u];
                                        let _e3029 = local.member_4[1u];
                                        let _e3034 = local.member[0u][1u];
                                        let _e3040 = local.member_4[2u];
                                        let _e3047 = (select(_e2996, -(_e2996), (_e2996 < 0f)) - (((select(_e3000, -(_e3000), (_e3000 < 0f)) * _e3006) + (select(_e3011, -(_e3011), (_e3011 < 0f)) * _e3017)) + ((select(_e3023, -(_e3023), (_e3023 < 0f)) * _e3029) + (select(_e3034, -(_e3034), (_e3034 < 0f)) * _e3040))));
                                        let _e3051 = local.member[1u][1u];
                                        let _e3054 = local.member_1[2u];
                                        let _e3059 = local.member[2u][1u];
                                        let _e3062 = local.member_1[1u];
                                        let _e3064 = ((_e3051 * _e3054) - (_e3059 * _e3062));
                                        let _e3068 = local.member[2u][1u];
                                        let _e3074 = local.member_3[1u];
                                        let _e3079 = local.member[1u][1u];
                                        let _e3085 = local.member_3[2u];
                                        let _e3091 = local.member[0u][0u];
                                        let _e3097 = local.member_4[2u];
                                        let _e3102 = local.member[0u][2u];
                                        let _e3108 = local.member_4[0u];
                                        let _e3115 = (select(_e3064, -(_e3064), (_e3064 < 0f)) - (((select(_e3068, -(_e3068), (_e3068 < 0f)) * _e3074) + (select(_e3079, -(_e3079), (_e3079 < 0f)) * _e3085)) + ((select(_e3091, -(_e3091), (_e3091 < 0f)) * _e3097) + (select(_e3102, -(_e3102), (_e3102 < 0f)) * _e3108))));
                                        let _e3119 = local.member[1u][2u];
                                        let _e3122 = local.member_1[2u];
                                        let _e3127 = local.member[2u][2u];
                                        let _e3130 = local.member_1[1u];
                                        let _e3132 = ((_e3119 * _e3122) - (_e3127 * _e3130));
                                        let _e3136 = local.member[2u][2u];
                                        let _e3142 = local.member_3[1u];
                                        let _e3147 = local.member[1u][2u];
                                        let _e3153 = local.member_3[2u];
                                        let _e3159 = local.member[0u][1u];
                                        let _e3165 = local.member_4[0u];
                                        let _e3170 = local.member[0u][0u];
                                        let _e3176 = local.member_4[1u];
                                        let _e3183 = (select(_e3132, -(_e3132), (_e3132 < 0f)) - (((select(_e3136, -(_e3136), (_e3136 < 0f)) * _e3142) + (select(_e3147, -(_e3147), (_e3147 < 0f)) * _e3153)) + ((select(_e3159, -(_e3159), (_e3159 < 0f)) * _e3165) + (select(_e3170, -(_e3170), (_e3170 < 0f)) * _e3176))));
                                        let _e3187 = local.member[2u][0u];
                                        let _e3190 = local.member_1[0u];
                                        let _e3195 = local.member[0u][0u];
                                        let _e3198 = local.member_1[2u];
                                        let _e3200 = ((_e3187 * _e3190) - (_e3195 * _e3198));
                                        let _e3204 = local.member[0u][0u];
                                        let _e3210 = local.member_3[2u];
                                        let _e3215 = local.member[2u][0u];
                                        let _e3221 = local.member_3[0u];
                                        let _e3227 = local.member[1u][2u];
                                        let _e3233 = local.member_4[1u];
                                        let _e3238 = local.member[1u][1u];
                                        let _e3244 = local.member_4[2u];
                                        let _e3251 = (select(_e3200, -(_e3200), (_e3200 < 0f)) - (((select(_e3204, -(_e3204), (_e3204 < 0f)) * _e3210) + (select(_e3215, -(_e3215), (_e3215 < 0f)) * _e3221)) + ((select(_e3227, -(_e3227), (_e3227 < 0f)) * _e3233) + (select(_e3238, -(_e3238), (_e3238 < 0f)) * _e3244))));
                                        let _e3255 = local.member[2u][1u];
                                        let _e3258 = local.member_1[0u];
                                        let _e3263 = local.member[0u][1u];
                                        let _e3266 = local.member_1[2u];
                                        let _e3268 = ((_e3255 * _e3258) - (_e3263 * _e3266));
                                        let _e3272 = local.member[0u][1u];
                                        let _e3278 = local.member_3[2u];
                                        let _e3283 = local.member[2u][1u];
                                        let _e3289 = local.member_3[0u];
                                        let _e3295 = local.member[1u][0u];
                                        let _e3301 = local.member_4[2u];
                                        let _e3306 = local.member[1u][2u];
                                        let _e3312 = local.member_4[0u];
                                        let _e3319 = (select(_e3268, -(_e3268), (_e3268 < 0f)) - (((select(_e3272, -(_e3272), (_e3272 < 0f)) * _e3278) + (select(_e3283, -(_e3283), (_e3283 < 0f)) * _e3289)) + ((select(_e3295, -(_e3295), (_e3295 < 0f)) * _e3301) + (select(_e3306, -(_e3306), (_e3306 < 0f)) * _e3312))));
                                        let _e3323 = local.member[2u][2u];
                                        let _e3326 = local.member_1[0u];
                                        let _e3331 = local.member[0u][2u];
                                        let _e3334 = local.member_1[2u];
                                        let _e3336 = ((_e3323 * _e3326) - (_e3331 * _e3334));
                                        let _e3340 = local.member[0u][2u];
                                        let _e3346 = local.member_3[2u];
                                        let _e3351 = local.member[2u][2u];
                                        let _e3357 = local.member_3[0u];
                                        let _e3363 = local.member[1u][1u];
                                        let _e3369 = local.member_4[0u];
                                        let _e3374 = local.member[1u][0u];
                                        let _e3380 = local.member_4[1u];
                                        let _e3387 = (select(_e3336, -(_e3336), (_e3336 < 0f)) - (((select(_e3340, -(_e3340), (_e3340 < 0f)) * _e3346) + (select(_e3351, -(_e3351), (_e3351 < 0f)) * _e3357)) + ((select(_e3363, -(_e3363), (_e3363 < 0f)) * _e3369) + (select(_e3374, -(_e3374), (_e3374 < 0f)) * _e3380))));
                                        let _e3391 = local.member[0u][0u];
                                        let _e3394 = local.member_1[1u];
                                        let _e3399 = local.member[1u][0u];
                                        let _e3402 = local.member_1[0u];
                                        let _e3404 = ((_e3391 * _e3394) - (_e3399 * _e3402));
                                        let _e3408 = local.member[1u][0u];
                                        let _e3414 = local.member_3[0u];
                                        let _e3419 = local.member[0u][0u];
                                        let _e3425 = local.member_3[1u];
                                        let _e3431 = local.member[2u][2u];
                                        let _e3437 = local.member_4[1u];
                                        let _e3442 = local.member[2u][1u];
                                        let _e3448 = local.member_4[2u];
                                        let _e3455 = (select(_e3404, -(_e3404), (_e3404 < 0f)) - (((select(_e3408, -(_e3408), (_e3408 < 0f)) * _e3414) + (select(_e3419, -(_e3419), (_e3419 < 0f)) * _e3425)) + ((select(_e3431, -(_e3431), (_e3431 < 0f)) * _e3437) + (select(_e3442, -(_e3442), (_e3442 < 0f)) * _e3448))));
                                        let _e3459 = local.member[0u][1u];
                                        let _e3462 = local.member_1[1u];
                                        let _e3467 = local.member[1u][1u];
                                        let _e3470 = local.member_1[0u];
                                        let _e3472 = ((_e3459 * _e3462) - (_e3467 * _e3470));
                                        let _e3476 = local.member[1u][1u];
                                        let _e3482 = local.member_3[0u];
                                        let _e3487 = local.member[0u][1u];
                                        let _e3493 = local.member_3[1u];
                                        let _e3499 = local.member[2u][0u];
                                        let _e3505 = local.member_4[2u];
                                        let _e3510 = local.member[2u][2u];
                                        let _e3516 = local.member_4[0u];
                                        let _e3523 = (select(_e3472, -(_e3472), (_e3472 < 0f)) - (((select(_e3476, -(_e3476), (_e3476 < 0f)) * _e3482) + (select(_e3487, -(_e3487), (_e3487 < 0f)) * _e3493)) + ((select(_e3499, -(_e3499), (_e3499 < 0f)) * _e3505) + (select(_e3510, -(_e3510), (_e3510 < 0f)) * _e3516))));
                                        let _e3527 = local.member[0u][2u];
                                        let _e3530 = local.member_1[1u];
                                        let _e3535 = local.member[1u][2u];
                                        let _e3538 = local.member_1[0u];
                                        let _e3540 = ((_e3527 * _e3530) - (_e3535 * _e3538));
                                        let _e3544 = local.member[1u][2u];
                                        let _e3550 = local.member_3[0u];
                                        let _e3555 = local.member[0u][2u];
                                        let _e3561 = local.member_3[1u];
                                        let _e3567 = local.member[2u][1u];
                                        let _e3573 = local.member_4[0u];
                                        let _e3578 = local.member[2u][0u];
                                        let _e3584 = local.member_4[1u];
                                        let _e3591 = (select(_e3540, -(_e3540), (_e3540 < 0f)) - (((select(_e3544, -(_e3544), (_e3544 < 0f)) * _e3550) + (select(_e3555, -(_e3555), (_e3555 < 0f)) * _e3561)) + ((select(_e3567, -(_e3567), (_e3567 < 0f)) * _e3573) + (select(_e3578, -(_e3578), (_e3578 < 0f)) * _e3584))));
                                        let _e3593 = select(_e3115, _e3047, (_e3047 > _e3115));
                                        let _e3595 = select(_e3183, _e3593, (_e3593 > _e3183));
                                        let _e3597 = select(_e3319, _e3251, (_e3251 > _e3319));
                                        let _e3599 = select(_e3387, _e3597, (_e3597 > _e3387));
                                        let _e3601 = select(_e3599, _e3595, (_e3595 > _e3599));
                                        let _e3603 = select(_e3523, _e3455, (_e3455 > _e3523));
                                        let _e3605 = select(_e3591, _e3603, (_e3603 > _e3591));
                                        let _e3609 = local.member_5;
                                        phi_6158_ = (select(_e3605, _e3601, (_e3601 > _e3605)) > _e3609);
                                    }
                                    let _e3612 = phi_6158_;
                                    phi_6160_ = !(_e3612);
                                    phi_6161_ = false;
                                } else {
                                    phi_6160_ = bool();
                                    phi_6161_ = true;
                                }
                                let _e3615 = phi_6160_;
                                let _e3617 = phi_6161_;
                                phi_6162_ = _e3615;
                                phi_6163_ = _e3617;
                            }
                            let _e3619 = phi_6162_;
                            let _e3621 = phi_6163_;
                            if select(_e3619, true, _e3621) {
                            } else {
                                local_1[_e2296] = array<u32, 2>(4294967295u, 4294967295u);
                            }
                        }
                    }
                    continue;
                    continuing {
                        phi_3900_ = type_9(select(_e2282.member, (_e2282.member + 1u), _e2285), select(_e2282.member_1, _e2282.member_1, _e2285));
                        break if !(_e2298);
                    }
                }
                let _e3625 = local_1;
                let _e3640 = params.member.member_2.member;
                let _e3641 = (_e3640 == 0u);
                let _e3647 = params.member.member.member[select(1u, 0u, _e3641)];
                let _e3652 = params.member.member.member[select(1u, 2u, _e3641)];
                let _e3660 = select(select(2u, 1u, select(true, select(true, false, (_e3625[0][1] >= (_e3652 - 1u))), (_e3625[0][0] >= (_e3647 - 1u)))), 0u, (_e3625[0][0] == 4294967295u));
                if (_e3660 == 2u) {
                    let _e3716 = params.member.member_1.member_3;
                    let _e3718 = a_nodes.member[_e3625[0][0]];
                    let _e3721 = b_nodes.member[_e3625[0][1]];
                    let _e3725 = params.member.member_2.member;
                    if (_e3725 == 1u) {
                        let _e3728 = (_e3718.member_1 < _e3721.member_1);
                        phi_6304_ = type_9(select(_e3721.member_1, _e3718.member_1, _e3728), select(_e3718.member_1, _e3721.member_1, _e3728));
                    } else {
                        phi_6304_ = type_9(_e3718.member_1, _e3721.member_1);
                    }
                    let _e3733 = phi_6304_;
                    let _e3737 = atomicAdd((&pairs.member[0u]), 1u);
                    if ((_e3737 + 1u) < _e3737) {
                        let _e3741 = atomicAdd((&pairs.member[2u]), 1u);
                    }
                    if (_e3737 < _e3716) {
                        let _e3743 = (2u * _e3737);
                        atomicStore((&pairs.member[(4u + _e3743)]), _e3733.member);
                        atomicStore((&pairs.member[(_e3743 + 5u)]), _e3733.member_1);
                    }
                } else {
                    if (_e3660 == 1u) {
                        let _e3665 = params.member.member_2.member_10;
                        let _e3668 = local_3.member.member_1;
                        let _e3671 = (_e3668 < select(_e3665, 64u, (64u < _e3665)));
                        if _e3671 {
                            let _e3673 = function_(_e3625[0][0]);
                            let _e3675 = local_3.member.member_1;
                            local_3.member.member[_e3675] = _e3673;
                            let _e3680 = local_3.member.member_1;
                            local_3.member.member_1 = (_e3680 + 1u);
                            let _e3683 = function_(_e3625[0][1]);
                            let _e3685 = local_3.member_1.member_1;
                            local_3.member_1.member[_e3685] = _e3683;
                            let _e3690 = local_3.member_1.member_1;
                            local_3.member_1.member_1 = (_e3690 + 1u);
                        }
                        if _e3671 {
                        } else {
                            let _e3694 = params.member.member_1.member_1;
                            let _e3697 = atomicAdd((&rounds.member[(_e3694 + 1u)]), 1u);
                            let _e3700 = atomicMax((&output.member[0u]), (_e3697 + 1u));
                            if ((_e3697 + 1u) < _e3697) {
                                let _e3704 = atomicAdd((&output.member[2u]), 1u);
                            }
                            let _e3707 = params.member.member_2.member_3;
                            if (_e3697 < _e3707) {
                                let _e3709 = (2u * _e3697);
                                atomicStore((&output.member[(4u + _e3709)]), _e3625[0][0]);
                                atomicStore((&output.member[(_e3709 + 5u)]), _e3625[0][1]);
                            }
                        }
                    }
                }
                let _e3750 = params.member.member_2.member;
                let _e3751 = (_e3750 == 0u);
                let _e3757 = params.member.member.member[select(1u, 0u, _e3751)];
                let _e3762 = params.member.member.member[select(1u, 2u, _e3751)];
                let _e3770 = select(select(2u, 1u, select(true, select(true, false, (_e3625[1][1] >= (_e3762 - 1u))), (_e3625[1][0] >= (_e3757 - 1u)))), 0u, (_e3625[1][0] == 4294967295u));
                if (_e3770 == 2u) {
                    let _e3826 = params.member.member_1.member_3;
                    let _e3828 = a_nodes.member[_e3625[1][0]];
                    let _e3831 = b_nodes.member[_e3625[1][1]];
                    let _e3835 = params.member.member_2.member;
                    if (_e3835 == 1u) {
                        let _e3838 = (_e3828.member_1 < _e3831.member_1);
                        phi_6529_ = type_9(select(_e3831.member_1, _e3828.member_1, _e3838), select(_e3828.member_1, _e3831.member_1, _e3838));
                    } else {
                        phi_6529_ = type_9(_e3828.member_1, _e3831.member_1);
                    }
                    let _e3843 = phi_6529_;
                    let _e3847 = atomicAdd((&pairs.member[0u]), 1u);
                    if ((_e3847 + 1u) < _e3847) {
                        let _e3851 = atomicAdd((&pairs.member[2u]), 1u);
                    }
                    if (_e3847 < _e3826) {
                        let _e3853 = (2u * _e3847);
                        atomicStore((&pairs.member[(4u + _e3853)]), _e3843.member);
                        atomicStore((&pairs.member[(_e3853 + 5u)]), _e3843.member_1);
                    }
                } else {
                    if (_e3770 == 1u) {
                        let _e3775 = params.member.member_2.member_10;
                        let _e3778 = local_3.member.member_1;
                        let _e3781 = (_e3778 < select(_e3775, 64u, (64u < _e3775)));
                        if _e3781 {
                            let _e3783 = function_(_e3625[1][0]);
                            let _e3785 = local_3.member.member_1;
                            local_3.member.member[_e3785] = _e3783;
                            let _e3790 = local_3.member.member_1;
                            local_3.member.member_1 = (_e3790 + 1u);
                            let _e3793 = function_(_e3625[1][1]);
                            let _e3795 = local_3.member_1.member_1;
                            local_3.member_1.member[_e3795] = _e3793;
                            let _e3800 = local_3.member_1.member_1;
                            local_3.member_1.member_1 = (_e3800 + 1u);
                        }
                        if _e3781 {
                        } else {
                            let _e3804 = params.member.member_1.member_1;
                            let _e3807 = atomicAdd((&rounds.member[(_e3804 + 1u)]), 1u);
                            let _e3810 = atomicMax((&output.member[0u]), (_e3807 + 1u));
                            if ((_e3807 + 1u) < _e3807) {
                                let _e3814 = atomicAdd((&output.member[2u]), 1u);
                            }
                            let _e3817 = params.member.member_2.member_3;
                            if (_e3807 < _e3817) {
                                let _e3819 = (2u * _e3807);
                                atomicStore((&output.member[(4u + _e3819)]), _e3625[1][0]);
                                atomicStore((&output.member[(_e3819 + 5u)]), _e3625[1][1]);
                            }
                        }
                    }
                }
                let _e3860 = params.member.member_2.member;
                let _e3861 = (_e3860 == 0u);
                let _e3867 = params.member.member.member[select(1u, 0u, _e3861)];
                let _e3872 = params.member.member.member[select(1u, 2u, _e3861)];
                let _e3880 = select(select(2u, 1u, select(true, select(true, false, (_e3625[2][1] >= (_e3872 - 1u))), (_e3625[2][0] >= (_e3867 - 1u)))), 0u, (_e3625[2][0] == 4294967295u));
                if (_e3880 == 2u) {
                    let _e3936 = params.member.member_1.member_3;
                    let _e3938 = a_nodes.member[_e3625[2][0]];
                    let _e3941 = b_nodes.member[_e3625[2][1]];
                    let _e3945 = params.member.member_2.member;
                    if (_e3945 == 1u) {
                        let _e3948 = (_e3938.member_1 < _e3941.member_1);
                        phi_6754_ = type_9(select(_e3941.member_1, _e3938.member_1, _e3948), select(_e3938.member_1, _e3941.member_1, _e3948));
                    } else {
                        phi_6754_ = type_9(_e3938.member_1, _e3941.member_1);
                    }
                    let _e3953 = phi_6754_;
                    let _e3957 = atomicAdd((&pairs.member[0u]), 1u);
                    if ((_e3957 + 1u) < _e3957) {
                        let _e3961 = atomicAdd((&pairs.member[2u]), 1u);
                    }
                    if (_e3957 < _e3936) {
                        let _e3963 = (2u * _e3957);
                        atomicStore((&pairs.member[(4u + _e3963)]), _e3953.member);
                        atomicStore((&pairs.member[(_e3963 + 5u)]), _e3953.member_1);
                    }
                } else {
                    if (_e3880 == 1u) {
                        let _e3885 = params.member.member_2.member_10;
                        let _e3888 = local_3.member.member_1;
                        let _e3891 = (_e3888 < select(_e3885, 64u, (64u < _e3885)));
                        if _e3891 {
                            let _e3893 = function_(_e3625[2][0]);
                            let _e3895 = local_3.member.member_1;
                            local_3.member.member[_e3895] = _e3893;
                            let _e3900 = local_3.member.member_1;
                            local_3.member.member_1 = (_e3900 + 1u);
                            let _e3903 = function_(_e3625[2][1]);
                            let _e3905 = local_3.member_1.member_1;
                            local_3.member_1.member[_e3905] = _e3903;
                            let _e3910 = local_3.member_1.member_1;
                            local_3.member_1.member_1 = (_e3910 + 1u);
                        }
                        if _e3891 {
                        } else {
                            let _e3914 = params.member.member_1.member_1;
                            let _e3917 = atomicAdd((&rounds.member[(_e3914 + 1u)]), 1u);
                            let _e3920 = atomicMax((&output.member[0u]), (_e3917 + 1u));
                            if ((_e3917 + 1u) < _e3917) {
                                let _e3924 = atomicAdd((&output.member[2u]), 1u);
                            }
                            let _e3927 = params.member.member_2.member_3;
                            if (_e3917 < _e3927) {
                                let _e3929 = (2u * _e3917);
                                atomicStore((&output.member[(4u + _e3929)]), _e3625[2][0]);
                                atomicStore((&output.member[(_e3929 + 5u)]), _e3625[2][1]);
                            }
                        }
                    }
                }
                let _e3970 = params.member.member_2.member;
                let _e3971 = (_e3970 == 0u);
                let _e3977 = params.member.member.member[select(1u, 0u, _e3971)];
                let _e3982 = params.member.member.member[select(1u, 2u, _e3971)];
                let _e3990 = select(select(2u, 1u, select(true, select(true, false, (_e3625[3][1] >= (_e3982 - 1u))), (_e3625[3][0] >= (_e3977 - 1u)))), 0u, (_e3625[3][0] == 4294967295u));
                if (_e3990 == 2u) {
                    let _e4046 = params.member.member_1.member_3;
                    let _e4048 = a_nodes.member[_e3625[3][0]];
                    let _e4051 = b_nodes.member[_e3625[3][1]];
                    let _e4055 = params.member.member_2.member;
                    if (_e4055 == 1u) {
                        let _e4058 = (_e4048.member_1 < _e4051.member_1);
                        phi_6979_ = type_9(select(_e4051.member_1, _e4048.member_1, _e4058), select(_e4048.member_1, _e4051.member_1, _e4058));
                    } else {
                        phi_6979_ = type_9(_e4048.member_1, _e4051.member_1);
                    }
                    let _e4063 = phi_6979_;
                    let _e4067 = atomicAdd((&pairs.member[0u]), 1u);
                    if ((_e4067 + 1u) < _e4067) {
                        let _e4071 = atomicAdd((&pairs.member[2u]), 1u);
                    }
                    if (_e4067 < _e4046) {
                        let _e4073 = (2u * _e4067);
                        atomicStore((&pairs.member[(4u + _e4073)]), _e4063.member);
                        atomicStore((&pairs.member[(_e4073 + 5u)]), _e4063.member_1);
                    }
                } else {
                    if (_e3990 == 1u) {
                        let _e3995 = params.member.member_2.member_10;
                        let _e3998 = local_3.member.member_1;
                        let _e4001 = (_e3998 < select(_e3995, 64u, (64u < _e3995)));
                        if _e4001 {
                            let _e4003 = function_(_e3625[3][0]);
                            let _e4005 = local_3.member.member_1;
                            local_3.member.member[_e4005] = _e4003;
                            let _e4010 = local_3.member.member_1;
                            local_3.member.member_1 = (_e4010 + 1u);
                            let _e4013 = function_(_e3625[3][1]);
                            let _e4015 = local_3.member_1.member_1;
                            local_3.member_1.member[_e4015] = _e4013;
                            let _e4020 = local_3.member_1.member_1;
                            local_3.member_1.member_1 = (_e4020 + 1u);
                        }
                        if _e4001 {
                        } else {
                            let _e4024 = params.member.member_1.member_1;
                            let _e4027 = atomicAdd((&rounds.member[(_e4024 + 1u)]), 1u);
                            let _e4030 = atomicMax((&output.member[0u]), (_e4027 + 1u));
                            if ((_e4027 + 1u) < _e4027) {
                                let _e4034 = atomicAdd((&output.member[2u]), 1u);
                            }
                            let _e4037 = params.member.member_2.member_3;
                            if (_e4027 < _e4037) {
                                let _e4039 = (2u * _e4027);
                                atomicStore((&output.member[(4u + _e4039)]), _e3625[3][0]);
                                atomicStore((&output.member[(_e4039 + 5u)]), _e3625[3][1]);
                            }
                        }
                    }
                }
                phi_7095_ = true;
            }
            let _e4079 = phi_7095_;
            phi_7096_ = _e4079;
        } else {
            phi_7096_ = false;
        }
        let _e4081 = phi_7096_;
        continue;
        continuing {
            phi_3114_ = type_9(select(_e1688.member, (_e1688.member + 1u), _e1691), select(_e1688.member_1, _e1688.member_1, _e1691));
            break if !(_e4081);
        }
    }
    phi_7099_ = type_9(0u, 64u);
    loop {
        let _e4084 = phi_7099_;
        let _e4087 = (_e4084.member < _e4084.member_1);
        if (bitcast<i32>(select(0u, 1u, _e4087)) != 0i) {
            let _e4101 = local_3.member.member_1;
            if (_e4101 > 0u) {
                let _e4106 = local_3.member.member_1;
                local_3.member.member_1 = (_e4106 - 1u);
                let _e4109 = local_3.member.member_1;
                let _e4112 = local_3.member.member[_e4109];
                let _e4116 = local_3.member_1.member_1;
                local_3.member_1.member_1 = (_e4116 - 1u);
                let _e4119 = local_3.member_1.member_1;
                let _e4122 = local_3.member_1.member[_e4119];
                phi_7166_ = array<u32, 2>(_e4112, _e4122);
            } else {
                phi_7166_ = array<u32, 2>(4294967295u, 4294967295u);
            }
            let _e4125 = phi_7166_;
            if (_e4125[0] == 4294967295u) {
                phi_7209_ = false;
            } else {
                let _e4130 = params.member.member_1.member_1;
                let _e4133 = atomicAdd((&rounds.member[(_e4130 + 1u)]), 1u);
                let _e4136 = atomicMax((&output.member[0u]), (_e4133 + 1u));
                if ((_e4133 + 1u) < _e4133) {
                    let _e4140 = atomicAdd((&output.member[2u]), 1u);
                }
                let _e4143 = params.member.member_2.member_3;
                if (_e4133 < _e4143) {
                    let _e4147 = (2u * _e4133);
                    atomicStore((&output.member[(4u + _e4147)]), _e4125[0]);
                    atomicStore((&output.member[(_e4147 + 5u)]), _e4125[1]);
                }
                phi_7209_ = true;
            }
            let _e4153 = phi_7209_;
            phi_7210_ = _e4153;
        } else {
            phi_7210_ = false;
        }
        let _e4155 = phi_7210_;
        continue;
        continuing {
            phi_7099_ = type_9(select(_e4084.member, (_e4084.member + 1u), _e4087), select(_e4084.member_1, _e4084.member_1, _e4087));
            break if !(_e4155);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn descend_stacks_oriented(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_1(id, n, lane);
}

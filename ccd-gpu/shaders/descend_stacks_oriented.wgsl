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
    member_1: array<u32, 64>,
    member_2: u32,
}

struct type_20 {
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

struct type_21 {
    member: type_7,
    member_1: type_8,
    member_2: type_20,
}

struct type_22 {
    member: type_21,
}

struct type_24 {
    member: array<array<u32, 2>, 4>,
    member_1: array<array<u32, 2>, 4>,
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

struct type_31 {
    member: array<f32, 3>,
    member_1: array<array<f32, 3>, 3>,
    member_2: array<f32, 3>,
}

struct type_34 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_22;
@group(0) @binding(1) 
var<storage> a_nodes: type_17;
@group(0) @binding(2) 
var<storage> b_nodes: type_17;
@group(0) @binding(3) 
var<storage> oriented: type_30;
@group(0) @binding(4) 
var<storage> input: type_11;
@group(0) @binding(5) 
var<storage, read_write> rounds: type_34;
@group(0) @binding(6) 
var<storage, read_write> output: type_34;
@group(0) @binding(7) 
var<storage, read_write> pairs: type_34;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_26;
    var local_1: array<array<u32, 2>, 4>;
    var local_2: type_26;
    var local_3: type_19;
    var phi_312_: array<u32, 2>;
    var phi_313_: array<u32, 2>;
    var phi_314_: array<u32, 2>;
    var phi_363_: bool;
    var phi_364_: bool;
    var phi_365_: bool;
    var phi_366_: bool;
    var phi_671_: type_31;
    var phi_815_: type_31;
    var phi_2716_: bool;
    var phi_2718_: bool;
    var phi_2719_: bool;
    var phi_2720_: bool;
    var phi_2721_: bool;
    var phi_2726_: bool;
    var phi_2731_: array<u32, 2>;
    var phi_2732_: array<u32, 2>;
    var phi_2733_: array<u32, 2>;
    var phi_213_: array<u32, 2>;
    var phi_2734_: array<u32, 2>;
    var phi_2978_: type_9;
    var phi_3091_: type_9;
    var phi_3150_: array<u32, 2>;
    var phi_3291_: type_24;
    var phi_3292_: type_24;
    var phi_3293_: bool;
    var phi_3294_: type_24;
    var phi_3295_: bool;
    var phi_3355_: bool;
    var phi_3356_: bool;
    var phi_3357_: bool;
    var phi_3358_: bool;
    var phi_3359_: bool;
    var phi_3360_: bool;
    var phi_3555_: type_24;
    var phi_3556_: bool;
    var phi_3557_: type_24;
    var phi_3558_: bool;
    var phi_3765_: type_24;
    var phi_3766_: type_24;
    var phi_3767_: type_24;
    var phi_3768_: bool;
    var phi_3769_: type_24;
    var phi_3770_: type_24;
    var phi_3771_: bool;
    var phi_3775_: type_24;
    var phi_3869_: type_9;
    var phi_4082_: type_31;
    var phi_4226_: type_31;
    var phi_6127_: bool;
    var phi_6129_: bool;
    var phi_6130_: bool;
    var phi_6131_: bool;
    var phi_6132_: bool;
    var phi_6273_: type_9;
    var phi_6490_: type_9;
    var phi_6707_: type_9;
    var phi_6924_: type_9;
    var phi_7032_: bool;
    var phi_7033_: bool;
    var phi_7036_: type_9;
    var phi_7095_: array<u32, 2>;
    var phi_7138_: bool;
    var phi_7139_: bool;
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
            phi_213_ = array<u32, 2>(_e1550, _e1553);
        } else {
            phi_213_ = array<u32, 2>(4294967295u, 4294967295u);
        }
        let _e1556 = phi_213_;
        phi_2734_ = _e1556;
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
                        phi_312_ = array<u32, 2>(_e100, _e104);
                    } else {
                        phi_312_ = array<u32, 2>(4294967295u, 4294967295u);
                    }
                    let _e107 = phi_312_;
                    phi_313_ = _e107;
                } else {
                    phi_313_ = array<u32, 2>(4294967295u, 4294967295u);
                }
                let _e109 = phi_313_;
                phi_314_ = _e109;
            } else {
                phi_314_ = array<u32, 2>(4294967295u, 4294967295u);
            }
            let _e111 = phi_314_;
            if (_e111[0] != 4294967295u) {
                let _e116 = params.member.member_2.member;
                if (_e116 == 1u) {
                    if (_e111[0] == _e111[1]) {
                        let _e123 = a_nodes.member[_e111[0]];
                        phi_363_ = (_e123.member_3 == 4294967295u);
                        phi_364_ = false;
                    } else {
                        phi_363_ = bool();
                        phi_364_ = true;
                    }
                    let _e127 = phi_363_;
                    let _e129 = phi_364_;
                    phi_365_ = _e127;
                    phi_366_ = _e129;
                } else {
                    phi_365_ = bool();
                    phi_366_ = true;
                }
                let _e131 = phi_365_;
                let _e133 = phi_366_;
                if select(_e131, false, _e133) {
                    phi_2731_ = array<u32, 2>(4294967295u, 4294967295u);
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
                            phi_2720_ = bool();
                            phi_2721_ = true;
                        } else {
                            if select(true, select(true, false, (_e111[1] >= _e183)), (_e111[0] >= _e178)) {
                                if (_e111[0] < _e178) {
                                    let _e280 = oriented.member[(_e193 + _e111[0])];
                                    phi_671_ = type_31(array<f32, 3>(_e280.member.x, _e280.member.y, _e280.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e280.member.w, _e280.member_1.x, _e280.member_1.y), array<f32, 3>(_e280.member_1.z, _e280.member_1.w, _e280.member_2.x), array<f32, 3>(_e280.member_2.y, _e280.member_2.z, _e280.member_2.w)), array<f32, 3>(_e280.member_3.x, _e280.member_3.y, _e280.member_3.z));
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
                                    phi_671_ = type_31(array<f32, 3>(_e241, _e244, _e247), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((select(_e256, _e250, (_e250 > _e256)) * _e268) + _e272), ((select(_e258, _e252, (_e252 > _e258)) * _e268) + _e272), ((select(_e260, _e254, (_e254 > _e260)) * _e268) + _e272)));
                                }
                                let _e319 = phi_671_;
                                if (_e111[1] < _e183) {
                                    let _e390 = oriented.member[(_e197 + _e111[1])];
                                    phi_815_ = type_31(array<f32, 3>(_e390.member.x, _e390.member.y, _e390.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e390.member.w, _e390.member_1.x, _e390.member_1.y), array<f32, 3>(_e390.member_1.z, _e390.member_1.w, _e390.member_2.x), array<f32, 3>(_e390.member_2.y, _e390.member_2.z, _e390.member_2.w)), array<f32, 3>(_e390.member_3.x, _e390.member_3.y, _e390.member_3.z));
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
                                    phi_815_ = type_31(array<f32, 3>(_e351, _e354, _e357), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((select(_e366, _e360, (_e360 > _e366)) * _e378) + _e382), ((select(_e368, _e362, (_e362 > _e368)) * _e378) + _e382), ((select(_e370, _e364, (_e364 > _e370)) * _e378) + _e382)));
                                }
                                let _e429 = phi_815_;
                                let _e434 = (_e429.member[0] - _e319.member[0]);
                                let _e437 = (_e429.member[1] - _e319.member[1]);
                                let _e440 = (_e429.member[2] - _e319.member[2]);
                                local_2 = type_26(array<array<f32, 3>, 3>(array<f32, 3>((((_e429.member_1[0][0] * _e319.member_1[0][0]) + (_e429.member_1[0][1] * _e319.member_1[0][1])) + (_e429.member_1[0][2] * _e319.member_1[0][2])), (((_e429.member_1[1][0] * _e319.member_1[0][0]) + (_e429.member_1[1][1] * _e319.member_1[0][1])) + (_e429.member_1[1][2] * _e319.member_1[0][2])), (((_e429.member_1[2][0] * _e319.member_1[0][0]) + (_e429.member_1[2][1] * _e319.member_1[0][1])) + (_e429.member_1[2][2] * _e319.member_1[0][2]))), array<f32, 3>((((_e429.member_1[0][0] * _e319.member_1[1][0]) + (_e429.member_1[0][1] * _e319.member_1[1][1])) + (_e429.member_1[0][2] * _e319.member_1[1][2])), (((_e429.member_1[1][0] * _e319.member_1[1][0]) + (_e429.member_1[1][1] * _e319.member_1[1][1])) + (_e429.member_1[1][2] * _e319.member_1[1][2])), (((_e429.member_1[2][0] * _e319.member_1[1][0]) + (_e429.member_1[2][1] * _e319.member_1[1][1])) + (_e429.member_1[2][2] * _e319.member_1[1][2]))), array<f32, 3>((((_e429.member_1[0][0] * _e319.member_1[2][0]) + (_e429.member_1[0][1] * _e319.member_1[2][1])) + (_e429.member_1[0][2] * _e319.member_1[2][2])), (((_e429.member_1[1][0] * _e319.member_1[2][0]) + (_e429.member_1[1][1] * _e319.member_1[2][1])) + (_e429.member_1[1][2] * _e319.member_1[2][2])), (((_e429.member_1[2][0] * _e319.member_1[2][0]) + (_e429.member_1[2][1] * _e319.member_1[2][1])) + (_e429.member_1[2][2] * _e319.member_1[2][2])))), array<f32, 3>((((_e319.member_1[0][0] * _e434) + (_e319.member_1[0][1] * _e437)) + (_e319.member_1[0][2] * _e440)), (((_e319.member_1[1][0] * _e434) + (_e319.member_1[1][1] * _e437)) + (_e319.member_1[1][2] * _e440)), (((_e319.member_1[2][0] * _e434) + (_e319.member_1[2][1] * _e437)) + (_e319.member_1[2][2] * _e440))), array<f32, 3>((((_e429.member_1[0][0] * _e434) + (_e429.member_1[0][1] * _e437)) + (_e429.member_1[0][2] * _e440)), (((_e429.member_1[1][0] * _e434) + (_e429.member_1[1][1] * _e437)) + (_e429.member_1[1][2] * _e440)), (((_e429.member_1[2][0] * _e434) + (_e429.member_1[2][1] * _e437)) + (_e429.member_1[2][2] * _e440))), array<f32, 3>(_e319.member_2[0], _e319.member_2[1], _e319.member_2[2]), array<f32, 3>(_e429.member_2[0], _e429.member_2[1], _e429.member_2[2]), ((((((select(_e434, -(_e434), (_e434 < 0f)) + select(_e437, -(_e437), (_e437 < 0f))) + select(_e440, -(_e440), (_e440 < 0f))) + (((select(_e319.member_2[0], -(_e319.member_2[0]), (_e319.member_2[0] < 0f)) + select(_e319.member_2[1], -(_e319.member_2[1]), (_e319.member_2[1] < 0f))) + select(_e319.member_2[2], -(_e319.member_2[2]), (_e319.member_2[2] < 0f))) + ((select(_e429.member_2[0], -(_e429.member_2[0]), (_e429.member_2[0] < 0f)) + select(_e429.member_2[1], -(_e429.member_2[1]), (_e429.member_2[1] < 0f))) + select(_e429.member_2[2], -(_e429.member_2[2]), (_e429.member_2[2] < 0f))))) * 2f) * (0.000000059604645f * 128f)) + (0.000000000000000000000000000000000000011754944f * 128f)));
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
                                    phi_2716_ = true;
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
                                    phi_2716_ = (select(_e1505, _e1501, (_e1501 > _e1505)) > _e1509);
                                }
                                let _e1512 = phi_2716_;
                                phi_2718_ = !(_e1512);
                                phi_2719_ = false;
                            } else {
                                phi_2718_ = bool();
                                phi_2719_ = true;
                            }
                            let _e1515 = phi_2718_;
                            let _e1517 = phi_2719_;
                            phi_2720_ = _e1515;
                            phi_2721_ = _e1517;
                        }
                        let _e1519 = phi_2720_;
                        let _e1521 = phi_2721_;
                        phi_2726_ = select(_e1519, true, _e1521);
                    } else {
                        phi_2726_ = false;
                    }
                    let _e1524 = phi_2726_;
                    phi_2731_ = array<u32, 2>(select(4294967295u, _e111[0], _e1524), select(4294967295u, _e111[1], _e1524));
                }
                let _e1531 = phi_2731_;
                phi_2732_ = _e1531;
            } else {
                phi_2732_ = array<u32, 2>(4294967295u, 4294967295u);
            }
            let _e1533 = phi_2732_;
            phi_2733_ = _e1533;
        } else {
            phi_2733_ = array<u32, 2>(4294967295u, 4294967295u);
        }
        let _e1535 = phi_2733_;
        phi_2734_ = _e1535;
    }
    let _e1558 = phi_2734_;
    local_3 = type_19(array<u32, 64>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 64>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u);
    let _e1561 = params.member.member_2.member;
    let _e1562 = (_e1561 == 0u);
    let _e1568 = params.member.member.member[select(1u, 0u, _e1562)];
    let _e1573 = params.member.member.member[select(1u, 2u, _e1562)];
    let _e1584 = select(select(2u, 1u, select(true, select(true, false, (_e1558[1] >= (_e1573 - 1u))), (_e1558[0] >= (_e1568 - 1u)))), 0u, (_e1558[0] == 4294967295u));
    if (_e1584 == 2u) {
        let _e1635 = params.member.member_1.member_3;
        let _e1638 = a_nodes.member[_e1558[0]];
        let _e1642 = b_nodes.member[_e1558[1]];
        let _e1646 = params.member.member_2.member;
        if (_e1646 == 1u) {
            let _e1649 = (_e1638.member_1 < _e1642.member_1);
            phi_2978_ = type_9(select(_e1642.member_1, _e1638.member_1, _e1649), select(_e1638.member_1, _e1642.member_1, _e1649));
        } else {
            phi_2978_ = type_9(_e1638.member_1, _e1642.member_1);
        }
        let _e1654 = phi_2978_;
        let _e1658 = atomicAdd((&pairs.member[0u]), 1u);
        if ((_e1658 + 1u) < _e1658) {
            let _e1662 = atomicAdd((&pairs.member[2u]), 1u);
        }
        if (_e1658 < _e1635) {
            let _e1664 = (2u * _e1658);
            atomicStore((&pairs.member[(4u + _e1664)]), _e1654.member);
            atomicStore((&pairs.member[(_e1664 + 5u)]), _e1654.member_1);
        }
    } else {
        if (_e1584 == 1u) {
            let _e1589 = params.member.member_2.member_10;
            let _e1591 = local_3.member_2;
            let _e1594 = (_e1591 < select(_e1589, 64u, (64u < _e1589)));
            if _e1594 {
                let _e1597 = local_3.member_2;
                local_3.member[_e1597] = _e1558[0];
                let _e1602 = local_3.member_2;
                local_3.member_1[_e1602] = _e1558[1];
                let _e1607 = local_3.member_2;
                local_3.member_2 = (_e1607 + 1u);
            }
            if _e1594 {
            } else {
                let _e1611 = params.member.member_1.member_1;
                let _e1614 = atomicAdd((&rounds.member[(_e1611 + 1u)]), 1u);
                let _e1617 = atomicMax((&output.member[0u]), (_e1614 + 1u));
                if ((_e1614 + 1u) < _e1614) {
                    let _e1621 = atomicAdd((&output.member[2u]), 1u);
                }
                let _e1624 = params.member.member_2.member_3;
                if (_e1614 < _e1624) {
                    let _e1628 = (2u * _e1614);
                    atomicStore((&output.member[(4u + _e1628)]), _e1558[0]);
                    atomicStore((&output.member[(_e1628 + 5u)]), _e1558[1]);
                }
            }
        }
    }
    let _e1671 = params.member.member_2.member_12;
    phi_3091_ = type_9(0u, _e1671);
    loop {
        let _e1674 = phi_3091_;
        let _e1677 = (_e1674.member < _e1674.member_1);
        if (bitcast<i32>(select(0u, 1u, _e1677)) != 0i) {
            let _e1690 = local_3.member_2;
            if (_e1690 > 0u) {
                let _e1694 = local_3.member_2;
                local_3.member_2 = (_e1694 - 1u);
                let _e1697 = local_3.member_2;
                let _e1700 = local_3.member[_e1697];
                let _e1703 = local_3.member_1[_e1697];
                phi_3150_ = array<u32, 2>(_e1700, _e1703);
            } else {
                phi_3150_ = array<u32, 2>(4294967295u, 4294967295u);
            }
            let _e1706 = phi_3150_;
            if (_e1706[0] == 4294967295u) {
                phi_7032_ = false;
            } else {
                let _e1711 = params.member.member_2.member_1;
                let _e1716 = params.member.member_2.member;
                let _e1721 = a_nodes.member[_e1706[0]];
                let _e1723 = b_nodes.member[_e1706[1]];
                if (_e1716 == 1u) {
                    if (_e1706[0] == _e1706[1]) {
                        if (_e1721.member_3 == 4294967295u) {
                            phi_3291_ = type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)));
                        } else {
                            let _e1729 = a_nodes.member[_e1721.member_1];
                            let _e1732 = a_nodes.member[_e1721.member_3];
                            let _e1735 = !((_e1729.member_3 == 4294967295u));
                            let _e1746 = type_24(array<array<u32, 2>, 4>(array<u32, 2>(select(4294967295u, _e1721.member_1, _e1735), select(4294967295u, _e1721.member_1, _e1735)), type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[1], type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[2], type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[3]), type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1);
                            let _e1758 = type_24(array<array<u32, 2>, 4>(_e1746.member[0], array<u32, 2>(_e1721.member_1, _e1746.member[1][1]), _e1746.member[2], _e1746.member[3]), _e1746.member_1);
                            let _e1766 = type_24(array<array<u32, 2>, 4>(_e1758.member[0], array<u32, 2>(_e1721.member_1, _e1721.member_3), _e1758.member[2], _e1758.member[3]), _e1758.member_1);
                            let _e1769 = !((_e1732.member_3 == 4294967295u));
                            let _e1780 = type_24(array<array<u32, 2>, 4>(_e1766.member[0], _e1766.member[1], array<u32, 2>(select(4294967295u, _e1721.member_3, _e1769), select(4294967295u, _e1721.member_3, _e1769)), _e1766.member[3]), _e1766.member_1);
                            let _e1783 = type_24(_e1780.member, _e1780.member);
                            let _e1810 = ((((((_e1729.member[0] <= _e1732.member_2[0]) && (_e1732.member[0] <= _e1729.member_2[0])) && (_e1729.member[1] <= _e1732.member_2[1])) && (_e1732.member[1] <= _e1729.member_2[1])) && (_e1729.member[2] <= _e1732.member_2[2])) && (_e1732.member[2] <= _e1729.member_2[2]));
                            phi_3291_ = type_24(_e1783.member, array<array<u32, 2>, 4>(_e1783.member_1[0], array<u32, 2>(select(4294967295u, _e1721.member_1, _e1810), select(4294967295u, _e1721.member_3, _e1810)), _e1783.member_1[2], _e1783.member_1[3]));
                        }
                        let _e1822 = phi_3291_;
                        phi_3292_ = _e1822;
                        phi_3293_ = false;
                    } else {
                        phi_3292_ = type_24();
                        phi_3293_ = true;
                    }
                    let _e1824 = phi_3292_;
                    let _e1826 = phi_3293_;
                    phi_3294_ = _e1824;
                    phi_3295_ = _e1826;
                } else {
                    phi_3294_ = type_24();
                    phi_3295_ = true;
                }
                let _e1828 = phi_3294_;
                let _e1830 = phi_3295_;
                if _e1830 {
                    let _e1833 = !((_e1721.member_3 == 4294967295u));
                    let _e1836 = !((_e1723.member_3 == 4294967295u));
                    if select(_e1836, true, _e1833) {
                        if _e1833 {
                            if _e1836 {
                                if (select(0u, 1u, (_e1711 == 0u)) == 0u) {
                                    let _e1865 = ((((_e1723.member_2[0] - _e1723.member[0]) * (_e1723.member_2[1] - _e1723.member[1])) * (_e1723.member_2[2] - _e1723.member[2])) > (((_e1721.member_2[0] - _e1721.member[0]) * (_e1721.member_2[1] - _e1721.member[1])) * (_e1721.member_2[2] - _e1721.member[2])));
                                    phi_3355_ = _e1865;
                                    phi_3356_ = !(_e1865);
                                } else {
                                    phi_3355_ = _e1836;
                                    phi_3356_ = _e1833;
                                }
                                let _e1868 = phi_3355_;
                                let _e1870 = phi_3356_;
                                phi_3357_ = _e1868;
                                phi_3358_ = _e1870;
                            } else {
                                phi_3357_ = _e1836;
                                phi_3358_ = _e1833;
                            }
                            let _e1872 = phi_3357_;
                            let _e1874 = phi_3358_;
                            phi_3359_ = _e1872;
                            phi_3360_ = _e1874;
                        } else {
                            phi_3359_ = _e1836;
                            phi_3360_ = _e1833;
                        }
                        let _e1876 = phi_3359_;
                        let _e1878 = phi_3360_;
                        if _e1878 {
                            if _e1876 {
                                let _e1881 = a_nodes.member[_e1721.member_1];
                                let _e1886 = a_nodes.member[_e1721.member_3];
                                let _e1891 = b_nodes.member[_e1723.member_1];
                                let _e1896 = b_nodes.member[_e1723.member_3];
                                let _e1934 = ((((((_e1881.member[0] <= _e1891.member_2[0]) && (_e1891.member[0] <= _e1881.member_2[0])) && (_e1881.member[1] <= _e1891.member_2[1])) && (_e1891.member[1] <= _e1881.member_2[1])) && (_e1881.member[2] <= _e1891.member_2[2])) && (_e1891.member[2] <= _e1881.member_2[2]));
                                let _e1960 = ((((((_e1881.member[0] <= _e1896.member_2[0]) && (_e1896.member[0] <= _e1881.member_2[0])) && (_e1881.member[1] <= _e1896.member_2[1])) && (_e1896.member[1] <= _e1881.member_2[1])) && (_e1881.member[2] <= _e1896.member_2[2])) && (_e1896.member[2] <= _e1881.member_2[2]));
                                let _e1986 = ((((((_e1886.member[0] <= _e1891.member_2[0]) && (_e1891.member[0] <= _e1886.member_2[0])) && (_e1886.member[1] <= _e1891.member_2[1])) && (_e1891.member[1] <= _e1886.member_2[1])) && (_e1886.member[2] <= _e1891.member_2[2])) && (_e1891.member[2] <= _e1886.member_2[2]));
                                let _e2012 = ((((((_e1886.member[0] <= _e1896.member_2[0]) && (_e1896.member[0] <= _e1886.member_2[0])) && (_e1886.member[1] <= _e1896.member_2[1])) && (_e1896.member[1] <= _e1886.member_2[1])) && (_e1886.member[2] <= _e1896.member_2[2])) && (_e1896.member[2] <= _e1886.member_2[2]));
                                phi_3555_ = type_24(array<array<u32, 2>, 4>(array<u32, 2>(_e1721.member_1, _e1723.member_1), array<u32, 2>(_e1721.member_1, _e1723.member_3), array<u32, 2>(_e1721.member_3, _e1723.member_1), array<u32, 2>(_e1721.member_3, _e1723.member_3)), array<array<u32, 2>, 4>(array<u32, 2>(select(4294967295u, _e1721.member_1, _e1934), select(4294967295u, _e1723.member_1, _e1934)), array<u32, 2>(select(4294967295u, _e1721.member_1, _e1960), select(4294967295u, _e1723.member_3, _e1960)), array<u32, 2>(select(4294967295u, _e1721.member_3, _e1986), select(4294967295u, _e1723.member_1, _e1986)), array<u32, 2>(select(4294967295u, _e1721.member_3, _e2012), select(4294967295u, _e1723.member_3, _e2012))));
                                phi_3556_ = false;
                            } else {
                                phi_3555_ = type_24();
                                phi_3556_ = true;
                            }
                            let _e2019 = phi_3555_;
                            let _e2021 = phi_3556_;
                            phi_3557_ = _e2019;
                            phi_3558_ = _e2021;
                        } else {
                            phi_3557_ = type_24();
                            phi_3558_ = true;
                        }
                        let _e2023 = phi_3557_;
                        let _e2025 = phi_3558_;
                        if _e2025 {
                            if _e1878 {
                                let _e2110 = a_nodes.member[_e1721.member_1];
                                let _e2115 = a_nodes.member[_e1721.member_3];
                                let _e2144 = ((((((_e2110.member[0] <= _e1723.member_2[0]) && (_e1723.member[0] <= _e2110.member_2[0])) && (_e2110.member[1] <= _e1723.member_2[1])) && (_e1723.member[1] <= _e2110.member_2[1])) && (_e2110.member[2] <= _e1723.member_2[2])) && (_e1723.member[2] <= _e2110.member_2[2]));
                                let _e2154 = type_24(type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member, array<array<u32, 2>, 4>(array<u32, 2>(select(4294967295u, _e1721.member_1, _e2144), select(4294967295u, _e1706[1], _e2144)), type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[1], type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[2], type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[3]));
                                let _e2179 = ((((((_e2115.member[0] <= _e1723.member_2[0]) && (_e1723.member[0] <= _e2115.member_2[0])) && (_e2115.member[1] <= _e1723.member_2[1])) && (_e1723.member[1] <= _e2115.member_2[1])) && (_e2115.member[2] <= _e1723.member_2[2])) && (_e1723.member[2] <= _e2115.member_2[2]));
                                phi_3765_ = type_24(_e2154.member, array<array<u32, 2>, 4>(_e2154.member_1[0], array<u32, 2>(select(4294967295u, _e1721.member_3, _e2179), select(4294967295u, _e1706[1], _e2179)), _e2154.member_1[2], _e2154.member_1[3]));
                            } else {
                                let _e2028 = b_nodes.member[_e1723.member_1];
                                let _e2033 = b_nodes.member[_e1723.member_3];
                                let _e2062 = ((((((_e1721.member[0] <= _e2028.member_2[0]) && (_e2028.member[0] <= _e1721.member_2[0])) && (_e1721.member[1] <= _e2028.member_2[1])) && (_e2028.member[1] <= _e1721.member_2[1])) && (_e1721.member[2] <= _e2028.member_2[2])) && (_e2028.member[2] <= _e1721.member_2[2]));
                                let _e2072 = type_24(type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member, array<array<u32, 2>, 4>(array<u32, 2>(select(4294967295u, _e1706[0], _e2062), select(4294967295u, _e1723.member_1, _e2062)), type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[1], type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[2], type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[3]));
                                let _e2097 = ((((((_e1721.member[0] <= _e2033.member_2[0]) && (_e2033.member[0] <= _e1721.member_2[0])) && (_e1721.member[1] <= _e2033.member_2[1])) && (_e2033.member[1] <= _e1721.member_2[1])) && (_e1721.member[2] <= _e2033.member_2[2])) && (_e2033.member[2] <= _e1721.member_2[2]));
                                phi_3765_ = type_24(_e2072.member, array<array<u32, 2>, 4>(_e2072.member_1[0], array<u32, 2>(select(4294967295u, _e1706[0], _e2097), select(4294967295u, _e1723.member_3, _e2097)), _e2072.member_1[2], _e2072.member_1[3]));
                            }
                            let _e2191 = phi_3765_;
                            phi_3766_ = _e2191;
                        } else {
                            phi_3766_ = _e2023;
                        }
                        let _e2193 = phi_3766_;
                        phi_3767_ = _e2193;
                        phi_3768_ = false;
                    } else {
                        phi_3767_ = type_24();
                        phi_3768_ = true;
                    }
                    let _e2195 = phi_3767_;
                    let _e2197 = phi_3768_;
                    phi_3769_ = _e2195;
                    phi_3770_ = type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)));
                    phi_3771_ = _e2197;
                } else {
                    phi_3769_ = type_24();
                    phi_3770_ = _e1828;
                    phi_3771_ = true;
                }
                let _e2199 = phi_3769_;
                let _e2201 = phi_3770_;
                let _e2203 = phi_3771_;
                if _e2203 {
                    phi_3775_ = _e2201;
                } else {
                    phi_3775_ = _e2199;
                }
                let _e2205 = phi_3775_;
                let _e2209 = params.member.member_2.member;
                let _e2210 = (_e2209 == 0u);
                let _e2216 = params.member.member.member[select(1u, 0u, _e2210)];
                let _e2217 = (_e2216 - 1u);
                let _e2221 = params.member.member.member[select(1u, 2u, _e2210)];
                let _e2222 = (_e2221 - 1u);
                let _e2225 = params.member.member_2.member;
                let _e2226 = (_e2225 == 0u);
                let _e2232 = params.member.member.member_2[select(1u, 0u, _e2226)];
                let _e2236 = params.member.member.member_2[select(1u, 2u, _e2226)];
                let _e2239 = params.member.member_2.member;
                local_1 = array<array<u32, 2>, 4>(array<u32, 2>(_e2205.member_1[0][0], _e2205.member_1[0][1]), array<u32, 2>(_e2205.member_1[1][0], _e2205.member_1[1][1]), array<u32, 2>(_e2205.member_1[2][0], _e2205.member_1[2][1]), array<u32, 2>(_e2205.member_1[3][0], _e2205.member_1[3][1]));
                phi_3869_ = type_9(0u, 4u);
                loop {
                    let _e2259 = phi_3869_;
                    let _e2262 = (_e2259.member < _e2259.member_1);
                    let _e2273 = select(type_9().member_1, _e2259.member, _e2262);
                    let _e2275 = (bitcast<i32>(select(0u, 1u, _e2262)) != 0i);
                    if _e2275 {
                        let _e2277 = local_1[_e2273];
                        if (_e2277[0] != 4294967295u) {
                            if select(false, (_e2277[0] == _e2277[1]), (_e2239 == 1u)) {
                                phi_6131_ = bool();
                                phi_6132_ = true;
                            } else {
                                if select(true, select(true, false, (_e2277[1] >= _e2222)), (_e2277[0] >= _e2217)) {
                                    if (_e2277[0] < _e2217) {
                                        let _e2357 = oriented.member[(_e2232 + _e2277[0])];
                                        phi_4082_ = type_31(array<f32, 3>(_e2357.member.x, _e2357.member.y, _e2357.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e2357.member.w, _e2357.member_1.x, _e2357.member_1.y), array<f32, 3>(_e2357.member_1.z, _e2357.member_1.w, _e2357.member_2.x), array<f32, 3>(_e2357.member_2.y, _e2357.member_2.z, _e2357.member_2.w)), array<f32, 3>(_e2357.member_3.x, _e2357.member_3.y, _e2357.member_3.z));
                                    } else {
                                        let _e2289 = a_nodes.member[_e2277[0]];
                                        let _e2304 = ((_e2289.member[0] * 0.5f) + (_e2289.member_2[0] * 0.5f));
                                        let _e2305 = ((_e2289.member[1] * 0.5f) + (_e2289.member_2[1] * 0.5f));
                                        let _e2306 = ((_e2289.member[2] * 0.5f) + (_e2289.member_2[2] * 0.5f));
                                        let _e2309 = select(_e2289.member_2[0], _e2304, (_e2304 < _e2289.member_2[0]));
                                        let _e2312 = select(_e2289.member_2[1], _e2305, (_e2305 < _e2289.member_2[1]));
                                        let _e2315 = select(_e2289.member_2[2], _e2306, (_e2306 < _e2289.member_2[2]));
                                        let _e2318 = select(_e2289.member[0], _e2309, (_e2309 > _e2289.member[0]));
                                        let _e2321 = select(_e2289.member[1], _e2312, (_e2312 > _e2289.member[1]));
                                        let _e2324 = select(_e2289.member[2], _e2315, (_e2315 > _e2289.member[2]));
                                        let _e2327 = (_e2289.member_2[0] - _e2318);
                                        let _e2329 = (_e2289.member_2[1] - _e2321);
                                        let _e2331 = (_e2289.member_2[2] - _e2324);
                                        let _e2333 = (_e2318 - _e2289.member[0]);
                                        let _e2335 = (_e2321 - _e2289.member[1]);
                                        let _e2337 = (_e2324 - _e2289.member[2]);
                                        let _e2345 = (1f + (0.000000059604645f * 4f));
                                        let _e2349 = (0.000000000000000000000000000000000000011754944f * 8f);
                                        phi_4082_ = type_31(array<f32, 3>(_e2318, _e2321, _e2324), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((select(_e2333, _e2327, (_e2327 > _e2333)) * _e2345) + _e2349), ((select(_e2335, _e2329, (_e2329 > _e2335)) * _e2345) + _e2349), ((select(_e2337, _e2331, (_e2331 > _e2337)) * _e2345) + _e2349)));
                                    }
                                    let _e2396 = phi_4082_;
                                    if (_e2277[1] < _e2222) {
                                        let _e2467 = oriented.member[(_e2236 + _e2277[1])];
                                        phi_4226_ = type_31(array<f32, 3>(_e2467.member.x, _e2467.member.y, _e2467.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e2467.member.w, _e2467.member_1.x, _e2467.member_1.y), array<f32, 3>(_e2467.member_1.z, _e2467.member_1.w, _e2467.member_2.x), array<f32, 3>(_e2467.member_2.y, _e2467.member_2.z, _e2467.member_2.w)), array<f32, 3>(_e2467.member_3.x, _e2467.member_3.y, _e2467.member_3.z));
                                    } else {
                                        let _e2399 = b_nodes.member[_e2277[1]];
                                        let _e2414 = ((_e2399.member[0] * 0.5f) + (_e2399.member_2[0] * 0.5f));
                                        let _e2415 = ((_e2399.member[1] * 0.5f) + (_e2399.member_2[1] * 0.5f));
                                        let _e2416 = ((_e2399.member[2] * 0.5f) + (_e2399.member_2[2] * 0.5f));
                                        let _e2419 = select(_e2399.member_2[0], _e2414, (_e2414 < _e2399.member_2[0]));
                                        let _e2422 = select(_e2399.member_2[1], _e2415, (_e2415 < _e2399.member_2[1]));
                                        let _e2425 = select(_e2399.member_2[2], _e2416, (_e2416 < _e2399.member_2[2]));
                                        let _e2428 = select(_e2399.member[0], _e2419, (_e2419 > _e2399.member[0]));
                                        let _e2431 = select(_e2399.member[1], _e2422, (_e2422 > _e2399.member[1]));
                                        let _e2434 = select(_e2399.member[2], _e2425, (_e2425 > _e2399.member[2]));
                                        let _e2437 = (_e2399.member_2[0] - _e2428);
                                        let _e2439 = (_e2399.member_2[1] - _e2431);
                                        let _e2441 = (_e2399.member_2[2] - _e2434);
                                        let _e2443 = (_e2428 - _e2399.member[0]);
                                        let _e2445 = (_e2431 - _e2399.member[1]);
                                        let _e2447 = (_e2434 - _e2399.member[2]);
                                        let _e2455 = (1f + (0.000000059604645f * 4f));
                                        let _e2459 = (0.000000000000000000000000000000000000011754944f * 8f);
                                        phi_4226_ = type_31(array<f32, 3>(_e2428, _e2431, _e2434), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((select(_e2443, _e2437, (_e2437 > _e2443)) * _e2455) + _e2459), ((select(_e2445, _e2439, (_e2439 > _e2445)) * _e2455) + _e2459), ((select(_e2447, _e2441, (_e2441 > _e2447)) * _e2455) + _e2459)));
                                    }
                                    let _e2506 = phi_4226_;
                                    let _e2511 = (_e2506.member[0] - _e2396.member[0]);
                                    let _e2514 = (_e2506.member[1] - _e2396.member[1]);
                                    let _e2517 = (_e2506.member[2] - _e2396.member[2]);
                                    local = type_26(array<array<f32, 3>, 3>(array<f32, 3>((((_e2506.member_1[0][0] * _e2396.member_1[0][0]) + (_e2506.member_1[0][1] * _e2396.member_1[0][1])) + (_e2506.member_1[0][2] * _e2396.member_1[0][2])), (((_e2506.member_1[1][0] * _e2396.member_1[0][0]) + (_e2506.member_1[1][1] * _e2396.member_1[0][1])) + (_e2506.member_1[1][2] * _e2396.member_1[0][2])), (((_e2506.member_1[2][0] * _e2396.member_1[0][0]) + (_e2506.member_1[2][1] * _e2396.member_1[0][1])) + (_e2506.member_1[2][2] * _e2396.member_1[0][2]))), array<f32, 3>((((_e2506.member_1[0][0] * _e2396.member_1[1][0]) + (_e2506.member_1[0][1] * _e2396.member_1[1][1])) + (_e2506.member_1[0][2] * _e2396.member_1[1][2])), (((_e2506.member_1[1][0] * _e2396.member_1[1][0]) + (_e2506.member_1[1][1] * _e2396.member_1[1][1])) + (_e2506.member_1[1][2] * _e2396.member_1[1][2])), (((_e2506.member_1[2][0] * _e2396.member_1[1][0]) + (_e2506.member_1[2][1] * _e2396.member_1[1][1])) + (_e2506.member_1[2][2] * _e2396.member_1[1][2]))), array<f32, 3>((((_e2506.member_1[0][0] * _e2396.member_1[2][0]) + (_e2506.member_1[0][1] * _e2396.member_1[2][1])) + (_e2506.member_1[0][2] * _e2396.member_1[2][2])), (((_e2506.member_1[1][0] * _e2396.member_1[2][0]) + (_e2506.member_1[1][1] * _e2396.member_1[2][1])) + (_e2506.member_1[1][2] * _e2396.member_1[2][2])), (((_e2506.member_1[2][0] * _e2396.member_1[2][0]) + (_e2506.member_1[2][1] * _e2396.member_1[2][1])) + (_e2506.member_1[2][2] * _e2396.member_1[2][2])))), array<f32, 3>((((_e2396.member_1[0][0] * _e2511) + (_e2396.member_1[0][1] * _e2514)) + (_e2396.member_1[0][2] * _e2517)), (((_e2396.member_1[1][0] * _e2511) + (_e2396.member_1[1][1] * _e2514)) + (_e2396.member_1[1][2] * _e2517)), (((_e2396.member_1[2][0] * _e2511) + (_e2396.member_1[2][1] * _e2514)) + (_e2396.member_1[2][2] * _e2517))), array<f32, 3>((((_e2506.member_1[0][0] * _e2511) + (_e2506.member_1[0][1] * _e2514)) + (_e2506.member_1[0][2] * _e2517)), (((_e2506.member_1[1][0] * _e2511) + (_e2506.member_1[1][1] * _e2514)) + (_e2506.member_1[1][2] * _e2517)), (((_e2506.member_1[2][0] * _e2511) + (_e2506.member_1[2][1] * _e2514)) + (_e2506.member_1[2][2] * _e2517))), array<f32, 3>(_e2396.member_2[0], _e2396.member_2[1], _e2396.member_2[2]), array<f32, 3>(_e2506.member_2[0], _e2506.member_2[1], _e2506.member_2[2]), ((((((select(_e2511, -(_e2511), (_e2511 < 0f)) + select(_e2514, -(_e2514), (_e2514 < 0f))) + select(_e2517, -(_e2517), (_e2517 < 0f))) + (((select(_e2396.member_2[0], -(_e2396.member_2[0]), (_e2396.member_2[0] < 0f)) + select(_e2396.member_2[1], -(_e2396.member_2[1]), (_e2396.member_2[1] < 0f))) + select(_e2396.member_2[2], -(_e2396.member_2[2]), (_e2396.member_2[2] < 0f))) + ((select(_e2506.member_2[0], -(_e2506.member_2[0]), (_e2506.member_2[0] < 0f)) + select(_e2506.member_2[1], -(_e2506.member_2[1]), (_e2506.member_2[1] < 0f))) + select(_e2506.member_2[2], -(_e2506.member_2[2]), (_e2506.member_2[2] < 0f))))) * 2f) * (0.000000059604645f * 128f)) + (0.000000000000000000000000000000000000011754944f * 128f)));
                                    let _e2769 = local.member[0u][0u];
                                    let _e2773 = local.member[0u][1u];
                                    let _e2777 = local.member[0u][2u];
                                    let _e2781 = local.member[1u][0u];
                                    let _e2785 = local.member[1u][1u];
                                    let _e2789 = local.member[1u][2u];
                                    let _e2793 = local.member[2u][0u];
                                    let _e2797 = local.member[2u][1u];
                                    let _e2801 = local.member[2u][2u];
                                    let _e2803 = local.member_3;
                                    let _e2808 = local.member_4;
                                    let _e2814 = local.member_1[0u];
                                    let _e2833 = (select(_e2814, -(_e2814), (_e2814 < 0f)) - (_e2803[0] + (((select(_e2769, -(_e2769), (_e2769 < 0f)) * _e2808[0]) + (select(_e2773, -(_e2773), (_e2773 < 0f)) * _e2808[1])) + (select(_e2777, -(_e2777), (_e2777 < 0f)) * _e2808[2]))));
                                    let _e2836 = local.member_1[1u];
                                    let _e2855 = (select(_e2836, -(_e2836), (_e2836 < 0f)) - (_e2803[1] + (((select(_e2781, -(_e2781), (_e2781 < 0f)) * _e2808[0]) + (select(_e2785, -(_e2785), (_e2785 < 0f)) * _e2808[1])) + (select(_e2789, -(_e2789), (_e2789 < 0f)) * _e2808[2]))));
                                    let _e2858 = local.member_1[2u];
                                    let _e2877 = (select(_e2858, -(_e2858), (_e2858 < 0f)) - (_e2803[2] + (((select(_e2793, -(_e2793), (_e2793 < 0f)) * _e2808[0]) + (select(_e2797, -(_e2797), (_e2797 < 0f)) * _e2808[1])) + (select(_e2801, -(_e2801), (_e2801 < 0f)) * _e2808[2]))));
                                    let _e2880 = local.member_2[0u];
                                    let _e2899 = (select(_e2880, -(_e2880), (_e2880 < 0f)) - (_e2808[0] + (((select(_e2769, -(_e2769), (_e2769 < 0f)) * _e2803[0]) + (select(_e2781, -(_e2781), (_e2781 < 0f)) * _e2803[1])) + (select(_e2793, -(_e2793), (_e2793 < 0f)) * _e2803[2]))));
                                    let _e2902 = local.member_2[1u];
                                    let _e2921 = (select(_e2902, -(_e2902), (_e2902 < 0f)) - (_e2808[1] + (((select(_e2773, -(_e2773), (_e2773 < 0f)) * _e2803[0]) + (select(_e2785, -(_e2785), (_e2785 < 0f)) * _e2803[1])) + (select(_e2797, -(_e2797), (_e2797 < 0f)) * _e2803[2]))));
                                    let _e2924 = local.member_2[2u];
                                    let _e2943 = (select(_e2924, -(_e2924), (_e2924 < 0f)) - (_e2808[2] + (((select(_e2777, -(_e2777), (_e2777 < 0f)) * _e2803[0]) + (select(_e2789, -(_e2789), (_e2789 < 0f)) * _e2803[1])) + (select(_e2801, -(_e2801), (_e2801 < 0f)) * _e2803[2]))));
                                    let _e2945 = select(_e2855, _e2833, (_e2833 > _e2855));
                                    let _e2947 = select(_e2877, _e2945, (_e2945 > _e2877));
                                    let _e2949 = select(_e2921, _e2899, (_e2899 > _e2921));
                                    let _e2951 = select(_e2943, _e2949, (_e2949 > _e2943));
                                    let _e2955 = local.member_5;
                                    if (select(_e2951, _e2947, (_e2947 > _e2951)) > _e2955) {
                                        phi_6127_ = true;
                                    } else {
                                        let _e2960 = local.member[1u][0u];
                                        let _e2963 = local.member_1[2u];
                                        let _e2968 = local.member[2u][0u];
                                        let _e2971 = local.member_1[1u];
                                        let _e2973 = ((_e2960 * _e2963) - (_e2968 * _e2971));
                                        let _e2977 = local.member[2u][0u];
                                        let _e2983 = local.member_3[1u];
                                        let _e2988 = local.member[1u][0u];
                                        let _e2994 = local.member_3[2u];
                                        let _e3000 = local.member[0u][2u];
                                        let _e3006 = local.member_4[1u];
                                        let _e3011 = local.member[0u][1u];
                                        let _e3017 = local.member_4[2u];
                                        let _e3024 = (select(_e2973, -(_e2973), (_e2973 < 0f)) - (((select(_e2977, -(_e2977), (_e2977 < 0f)) * _e2983) + (select(_e2988, -(_e2988), (_e2988 < 0f)) * _e2994)) + ((select(_e3000, -(_e3000), (_e3000 < 0f)) * _e3006) + (select(_e3011, -(_e3011), (_e3011 < 0f)) * _e3017))));
                                        let _e3028 = local.member[1u][1u];
                                        let _e3031 = local.member_1[2u];
                                        let _e3036 = local.member[2u][1u];
                                        let _e3039 = local.member_1[1u];
                                        let _e3041 = ((_e3028 * _e3031) - (_e3036 * _e3039));
                                        let _e3045 = local.member[2u][1u];
                                        let _e3051 = local.member_3[1u];
                                        let _e3056 = local.member[1u][1u];
                                        let _e3062 = local.member_3[2u];
                                        let _e3068 = local.member[0u][0u];
                                        let _e3074 = local.member_4[2u];
                                        let _e3079 = local.member[0u][2u];
                                        let _e3085 = local.member_4[0u];
                                        let _e3092 = (select(_e3041, -(_e3041), (_e3041 < 0f)) - (((select(_e3045, -(_e3045), (_e3045 < 0f)) * _e3051) + (select(_e3056, -(_e3056), (_e3056 < 0f)) * _e3062)) + ((select(_e3068, -(_e3068), (_e3068 < 0f)) * _e3074) + (select(_e3079, -(_e3079), (_e3079 < 0f)) * _e3085))));
                                        let _e3096 = local.member[1u][2u];
                                        let _e3099 = local.member_1[2u];
                                        let _e3104 = local.member[2u][2u];
                                        let _e3107 = local.member_1[1u];
                                        let _e3109 = ((_e3096 * _e3099) - (_e3104 * _e3107));
                                        let _e3113 = local.member[2u][2u];
                                        let _e3119 = local.member_3[1u];
                                        let _e3124 = local.member[1u][2u];
                                        let _e3130 = local.member_3[2u];
                                        let _e3136 = local.member[0u][1u];
                                        let _e3142 = local.member_4[0u];
                                        let _e3147 = local.member[0u][0u];
                                        let _e3153 = local.member_4[1u];
                                        let _e3160 = (select(_e3109, -(_e3109), (_e3109 < 0f)) - (((select(_e3113, -(_e3113), (_e3113 < 0f)) * _e3119) + (select(_e3124, -(_e3124), (_e3124 < 0f)) * _e3130)) + ((select(_e3136, -(_e3136), (_e3136 < 0f)) * _e3142) + (select(_e3147, -(_e3147), (_e3147 < 0f)) * _e3153))));
                                        let _e3164 = local.member[2u][0u];
                                        let _e3167 = local.member_1[0u];
                                        let _e3172 = local.member[0u][0u];
                                        let _e3175 = local.member_1[2u];
                                        let _e3177 = ((_e3164 * _e3167) - (_e3172 * _e3175));
                                        let _e3181 = local.member[0u][0u];
                                        let _e3187 = local.member_3[2u];
                                        let _e3192 = local.member[2u][0u];
                                        let _e3198 = local.member_3[0u];
                                        let _e3204 = local.member[1u][2u];
                                        let _e3210 = local.member_4[1u];
                                        let _e3215 = local.member[1u][1u];
                                        let _e3221 = local.member_4[2u];
                                        let _e3228 = (select(_e3177, -(_e3177), (_e3177 < 0f)) - (((select(_e3181, -(_e3181), (_e3181 < 0f)) * _e3187) + (select(_e3192, -(_e3192), (_e3192 < 0f)) * _e3198)) + ((select(_e3204, -(_e3204), (_e3204 < 0f)) * _e3210) + (select(_e3215, -(_e3215), (_e3215 < 0f)) * _e3221))));
                                        let _e3232 = local.member[2u][1u];
                                        let _e3235 = local.member_1[0u];
                                        let _e3240 = local.member[0u][1u];
                                        let _e3243 = local.member_1[2u];
                                        let _e3245 = ((_e3232 * _e3235) - (_e3240 * _e3243));
                                        let _e3249 = local.member[0u][1u];
                                        let _e3255 = local.member_3[2u];
                                        let _e3260 = local.member[2u][1u];
                                        let _e3266 = local.member_3[0u];
                                        let _e3272 = local.member[1u][0u];
                                        let _e3278 = local.member_4[2u];
                                        let _e3283 = local.member[1u][2u];
                                        let _e3289 = local.member_4[0u];
                                        let _e3296 = (select(_e3245, -(_e3245), (_e3245 < 0f)) - (((select(_e3249, -(_e3249), (_e3249 < 0f)) * _e3255) + (select(_e3260, -(_e3260), (_e3260 < 0f)) * _e3266)) + ((select(_e3272, -(_e3272), (_e3272 < 0f)) * _e3278) + (select(_e3283, -(_e3283), (_e3283 < 0f)) * _e3289))));
                                        let _e3300 = local.member[2u][2u];
                                        let _e3303 = local.member_1[0u];
                                        let _e3308 = local.member[0u][2u];
                                        let _e3311 = local.member_1[2u];
                                        let _e3313 = ((_e3300 * _e3303) - (_e3308 * _e3311));
                                        let _e3317 = local.member[0u][2u];
                                        let _e3323 = local.member_3[2u];
                                        let _e3328 = local.member[2u][2u];
                                        let _e3334 = local.member_3[0u];
                                        let _e3340 = local.member[1u][1u];
                                        let _e3346 = local.member_4[0u];
                                        let _e3351 = local.member[1u][0u];
                                        let _e3357 = local.member_4[1u];
                                        let _e3364 = (select(_e3313, -(_e3313), (_e3313 < 0f)) - (((select(_e3317, -(_e3317), (_e3317 < 0f)) * _e3323) + (select(_e3328, -(_e3328), (_e3328 < 0f)) * _e3334)) + ((select(_e3340, -(_e3340), (_e3340 < 0f)) * _e3346) + (select(_e3351, -(_e3351), (_e3351 < 0f)) * _e3357))));
                                        let _e3368 = local.member[0u][0u];
                                        let _e3371 = local.member_1[1u];
                                        let _e3376 = local.member[1u][0u];
                                        let _e3379 = local.member_1[0u];
                                        let _e3381 = ((_e3368 * _e3371) - (_e3376 * _e3379));
                                        let _e3385 = local.member[1u][0u];
                                        let _e3391 = local.member_3[0u];
                                        let _e3396 = local.member[0u][0u];
                                        let _e3402 = local.member_3[1u];
                                        let _e3408 = local.member[2u][2u];
                                        let _e3414 = local.member_4[1u];
                                        let _e3419 = local.member[2u][1u];
                                        let _e3425 = local.member_4[2u];
                                        let _e3432 = (select(_e3381, -(_e3381), (_e3381 < 0f)) - (((select(_e3385, -(_e3385), (_e3385 < 0f)) * _e3391) + (select(_e3396, -(_e3396), (_e3396 < 0f)) * _e3402)) + ((select(_e3408, -(_e3408), (_e3408 < 0f)) * _e3414) + (select(_e3419, -(_e3419), (_e3419 < 0f)) * _e3425))));
                                        let _e3436 = local.member[0u][1u];
                                        let _e3439 = local.member_1[1u];
                                        let _e3444 = local.member[1u][1u];
                                        let _e3447 = local.member_1[0u];
                                        let _e3449 = ((_e3436 * _e3439) - (_e3444 * _e3447));
                                        let _e3453 = local.member[1u][1u];
                                        let _e3459 = local.member_3[0u];
                                        let _e3464 = local.member[0u][1u];
                                        let _e3470 = local.member_3[1u];
                                        let _e3476 = local.member[2u][0u];
                                        let _e3482 = local.member_4[2u];
                                        let _e3487 = local.member[2u][2u];
                                        let _e3493 = local.member_4[0u];
                                        let _e3500 = (select(_e3449, -(_e3449), (_e3449 < 0f)) - (((select(_e3453, -(_e3453), (_e3453 < 0f)) * _e3459) + (select(_e3464, -(_e3464), (_e3464 < 0f)) * _e3470)) + ((select(_e3476, -(_e3476), (_e3476 < 0f)) * _e3482) + (select(_e3487, -(_e3487), (_e3487 < 0f)) * _e3493))));
                                        let _e3504 = local.member[0u][2u];
                                        let _e3507 = local.member_1[1u];
                                        let _e3512 = local.member[1u][2u];
                                        let _e3515 = local.member_1[0u];
                                        let _e3517 = ((_e3504 * _e3507) - (_e3512 * _e3515));
                                        let _e3521 = local.member[1u][2u];
                                        let _e3527 = local.member_3[0u];
                                        let _e3532 = local.member[0u][2u];
                                        let _e3538 = local.member_3[1u];
                                        let _e3544 = local.member[2u][1u];
                                        let _e3550 = local.member_4[0u];
                                        let _e3555 = local.member[2u][0u];
                                        let _e3561 = local.member_4[1u];
                                        let _e3568 = (select(_e3517, -(_e3517), (_e3517 < 0f)) - (((select(_e3521, -(_e3521), (_e3521 < 0f)) * _e3527) + (select(_e3532, -(_e3532), (_e3532 < 0f)) * _e3538)) + ((select(_e3544, -(_e3544), (_e3544 < 0f)) * _e3550) + (select(_e3555, -(_e3555), (_e3555 < 0f)) * _e3561))));
                                        let _e3570 = select(_e3092, _e3024, (_e3024 > _e3092));
                                        let _e3572 = select(_e3160, _e3570, (_e3570 > _e3160));
                                        let _e3574 = select(_e3296, _e3228, (_e3228 > _e3296));
                                        let _e3576 = select(_e3364, _e3574, (_e3574 > _e3364));
                                        let _e3578 = select(_e3576, _e3572, (_e3572 > _e3576));
                                        let _e3580 = select(_e3500, _e3432, (_e3432 > _e3500));
                                        let _e3582 = select(_e3568, _e3580, (_e3580 > _e3568));
                                        let _e3586 = local.member_5;
                                        phi_6127_ = (select(_e3582, _e3578, (_e3578 > _e3582)) > _e3586);
                                    }
                                    let _e3589 = phi_6127_;
                                    phi_6129_ = !(_e3589);
                                    phi_6130_ = false;
                                } else {
                                    phi_6129_ = bool();
                                    phi_6130_ = true;
                                }
                                let _e3592 = phi_6129_;
                                let _e3594 = phi_6130_;
                                phi_6131_ = _e3592;
                                phi_6132_ = _e3594;
                            }
                            let _e3596 = phi_6131_;
                            let _e3598 = phi_6132_;
                            if select(_e3596, true, _e3598) {
                            } else {
                                local_1[_e2273] = array<u32, 2>(4294967295u, 4294967295u);
                            }
                        }
                    }
                    continue;
                    continuing {
                        phi_3869_ = type_9(select(_e2259.member, (_e2259.member + 1u), _e2262), select(_e2259.member_1, _e2259.member_1, _e2262));
                        break if !(_e2275);
                    }
                }
                let _e3602 = local_1;
                let _e3617 = params.member.member_2.member;
                let _e3618 = (_e3617 == 0u);
                let _e3624 = params.member.member.member[select(1u, 0u, _e3618)];
                let _e3629 = params.member.member.member[select(1u, 2u, _e3618)];
                let _e3637 = select(select(2u, 1u, select(true, select(true, false, (_e3602[0][1] >= (_e3629 - 1u))), (_e3602[0][0] >= (_e3624 - 1u)))), 0u, (_e3602[0][0] == 4294967295u));
                if (_e3637 == 2u) {
                    let _e3684 = params.member.member_1.member_3;
                    let _e3686 = a_nodes.member[_e3602[0][0]];
                    let _e3689 = b_nodes.member[_e3602[0][1]];
                    let _e3693 = params.member.member_2.member;
                    if (_e3693 == 1u) {
                        let _e3696 = (_e3686.member_1 < _e3689.member_1);
                        phi_6273_ = type_9(select(_e3689.member_1, _e3686.member_1, _e3696), select(_e3686.member_1, _e3689.member_1, _e3696));
                    } else {
                        phi_6273_ = type_9(_e3686.member_1, _e3689.member_1);
                    }
                    let _e3701 = phi_6273_;
                    let _e3705 = atomicAdd((&pairs.member[0u]), 1u);
                    if ((_e3705 + 1u) < _e3705) {
                        let _e3709 = atomicAdd((&pairs.member[2u]), 1u);
                    }
                    if (_e3705 < _e3684) {
                        let _e3711 = (2u * _e3705);
                        atomicStore((&pairs.member[(4u + _e3711)]), _e3701.member);
                        atomicStore((&pairs.member[(_e3711 + 5u)]), _e3701.member_1);
                    }
                } else {
                    if (_e3637 == 1u) {
                        let _e3642 = params.member.member_2.member_10;
                        let _e3644 = local_3.member_2;
                        let _e3647 = (_e3644 < select(_e3642, 64u, (64u < _e3642)));
                        if _e3647 {
                            let _e3649 = local_3.member_2;
                            local_3.member[_e3649] = _e3602[0][0];
                            let _e3653 = local_3.member_2;
                            local_3.member_1[_e3653] = _e3602[0][1];
                            let _e3658 = local_3.member_2;
                            local_3.member_2 = (_e3658 + 1u);
                        }
                        if _e3647 {
                        } else {
                            let _e3662 = params.member.member_1.member_1;
                            let _e3665 = atomicAdd((&rounds.member[(_e3662 + 1u)]), 1u);
                            let _e3668 = atomicMax((&output.member[0u]), (_e3665 + 1u));
                            if ((_e3665 + 1u) < _e3665) {
                                let _e3672 = atomicAdd((&output.member[2u]), 1u);
                            }
                            let _e3675 = params.member.member_2.member_3;
                            if (_e3665 < _e3675) {
                                let _e3677 = (2u * _e3665);
                                atomicStore((&output.member[(4u + _e3677)]), _e3602[0][0]);
                                atomicStore((&output.member[(_e3677 + 5u)]), _e3602[0][1]);
                            }
                        }
                    }
                }
                let _e3718 = params.member.member_2.member;
                let _e3719 = (_e3718 == 0u);
                let _e3725 = params.member.member.member[select(1u, 0u, _e3719)];
                let _e3730 = params.member.member.member[select(1u, 2u, _e3719)];
                let _e3738 = select(select(2u, 1u, select(true, select(true, false, (_e3602[1][1] >= (_e3730 - 1u))), (_e3602[1][0] >= (_e3725 - 1u)))), 0u, (_e3602[1][0] == 4294967295u));
                if (_e3738 == 2u) {
                    let _e3785 = params.member.member_1.member_3;
                    let _e3787 = a_nodes.member[_e3602[1][0]];
                    let _e3790 = b_nodes.member[_e3602[1][1]];
                    let _e3794 = params.member.member_2.member;
                    if (_e3794 == 1u) {
                        let _e3797 = (_e3787.member_1 < _e3790.member_1);
                        phi_6490_ = type_9(select(_e3790.member_1, _e3787.member_1, _e3797), select(_e3787.member_1, _e3790.member_1, _e3797));
                    } else {
                        phi_6490_ = type_9(_e3787.member_1, _e3790.member_1);
                    }
                    let _e3802 = phi_6490_;
                    let _e3806 = atomicAdd((&pairs.member[0u]), 1u);
                    if ((_e3806 + 1u) < _e3806) {
                        let _e3810 = atomicAdd((&pairs.member[2u]), 1u);
                    }
                    if (_e3806 < _e3785) {
                        let _e3812 = (2u * _e3806);
                        atomicStore((&pairs.member[(4u + _e3812)]), _e3802.member);
                        atomicStore((&pairs.member[(_e3812 + 5u)]), _e3802.member_1);
                    }
                } else {
                    if (_e3738 == 1u) {
                        let _e3743 = params.member.member_2.member_10;
                        let _e3745 = local_3.member_2;
                        let _e3748 = (_e3745 < select(_e3743, 64u, (64u < _e3743)));
                        if _e3748 {
                            let _e3750 = local_3.member_2;
                            local_3.member[_e3750] = _e3602[1][0];
                            let _e3754 = local_3.member_2;
                            local_3.member_1[_e3754] = _e3602[1][1];
                            let _e3759 = local_3.member_2;
                            local_3.member_2 = (_e3759 + 1u);
                        }
                        if _e3748 {
                        } else {
                            let _e3763 = params.member.member_1.member_1;
                            let _e3766 = atomicAdd((&rounds.member[(_e3763 + 1u)]), 1u);
                            let _e3769 = atomicMax((&output.member[0u]), (_e3766 + 1u));
                            if ((_e3766 + 1u) < _e3766) {
                                let _e3773 = atomicAdd((&output.member[2u]), 1u);
                            }
                            let _e3776 = params.member.member_2.member_3;
                            if (_e3766 < _e3776) {
                                let _e3778 = (2u * _e3766);
                                atomicStore((&output.member[(4u + _e3778)]), _e3602[1][0]);
                                atomicStore((&output.member[(_e3778 + 5u)]), _e3602[1][1]);
                            }
                        }
                    }
                }
                let _e3819 = params.member.member_2.member;
                let _e3820 = (_e3819 == 0u);
                let _e3826 = params.member.member.member[select(1u, 0u, _e3820)];
                let _e3831 = params.member.member.member[select(1u, 2u, _e3820)];
                let _e3839 = select(select(2u, 1u, select(true, select(true, false, (_e3602[2][1] >= (_e3831 - 1u))), (_e3602[2][0] >= (_e3826 - 1u)))), 0u, (_e3602[2][0] == 4294967295u));
                if (_e3839 == 2u) {
                    let _e3886 = params.member.member_1.member_3;
                    let _e3888 = a_nodes.member[_e3602[2][0]];
                    let _e3891 = b_nodes.member[_e3602[2][1]];
                    let _e3895 = params.member.member_2.member;
                    if (_e3895 == 1u) {
                        let _e3898 = (_e3888.member_1 < _e3891.member_1);
                        phi_6707_ = type_9(select(_e3891.member_1, _e3888.member_1, _e3898), select(_e3888.member_1, _e3891.member_1, _e3898));
                    } else {
                        phi_6707_ = type_9(_e3888.member_1, _e3891.member_1);
                    }
                    let _e3903 = phi_6707_;
                    let _e3907 = atomicAdd((&pairs.member[0u]), 1u);
                    if ((_e3907 + 1u) < _e3907) {
                        let _e3911 = atomicAdd((&pairs.member[2u]), 1u);
                    }
                    if (_e3907 < _e3886) {
                        let _e3913 = (2u * _e3907);
                        atomicStore((&pairs.member[(4u + _e3913)]), _e3903.member);
                        atomicStore((&pairs.member[(_e3913 + 5u)]), _e3903.member_1);
                    }
                } else {
                    if (_e3839 == 1u) {
                        let _e3844 = params.member.member_2.member_10;
                        let _e3846 = local_3.member_2;
                        let _e3849 = (_e3846 < select(_e3844, 64u, (64u < _e3844)));
                        if _e3849 {
                            let _e3851 = local_3.member_2;
                            local_3.member[_e3851] = _e3602[2][0];
                            let _e3855 = local_3.member_2;
                            local_3.member_1[_e3855] = _e3602[2][1];
                            let _e3860 = local_3.member_2;
                            local_3.member_2 = (_e3860 + 1u);
                        }
                        if _e3849 {
                        } else {
                            let _e3864 = params.member.member_1.member_1;
                            let _e3867 = atomicAdd((&rounds.member[(_e3864 + 1u)]), 1u);
                            let _e3870 = atomicMax((&output.member[0u]), (_e3867 + 1u));
                            if ((_e3867 + 1u) < _e3867) {
                                let _e3874 = atomicAdd((&output.member[2u]), 1u);
                            }
                            let _e3877 = params.member.member_2.member_3;
                            if (_e3867 < _e3877) {
                                let _e3879 = (2u * _e3867);
                                atomicStore((&output.member[(4u + _e3879)]), _e3602[2][0]);
                                atomicStore((&output.member[(_e3879 + 5u)]), _e3602[2][1]);
                            }
                        }
                    }
                }
                let _e3920 = params.member.member_2.member;
                let _e3921 = (_e3920 == 0u);
                let _e3927 = params.member.member.member[select(1u, 0u, _e3921)];
                let _e3932 = params.member.member.member[select(1u, 2u, _e3921)];
                let _e3940 = select(select(2u, 1u, select(true, select(true, false, (_e3602[3][1] >= (_e3932 - 1u))), (_e3602[3][0] >= (_e3927 - 1u)))), 0u, (_e3602[3][0] == 4294967295u));
                if (_e3940 == 2u) {
                    let _e3987 = params.member.member_1.member_3;
                    let _e3989 = a_nodes.member[_e3602[3][0]];
                    let _e3992 = b_nodes.member[_e3602[3][1]];
                    let _e3996 = params.member.member_2.member;
                    if (_e3996 == 1u) {
                        let _e3999 = (_e3989.member_1 < _e3992.member_1);
                        phi_6924_ = type_9(select(_e3992.member_1, _e3989.member_1, _e3999), select(_e3989.member_1, _e3992.member_1, _e3999));
                    } else {
                        phi_6924_ = type_9(_e3989.member_1, _e3992.member_1);
                    }
                    let _e4004 = phi_6924_;
                    let _e4008 = atomicAdd((&pairs.member[0u]), 1u);
                    if ((_e4008 + 1u) < _e4008) {
                        let _e4012 = atomicAdd((&pairs.member[2u]), 1u);
                    }
                    if (_e4008 < _e3987) {
                        let _e4014 = (2u * _e4008);
                        atomicStore((&pairs.member[(4u + _e4014)]), _e4004.member);
                        atomicStore((&pairs.member[(_e4014 + 5u)]), _e4004.member_1);
                    }
                } else {
                    if (_e3940 == 1u) {
                        let _e3945 = params.member.member_2.member_10;
                        let _e3947 = local_3.member_2;
                        let _e3950 = (_e3947 < select(_e3945, 64u, (64u < _e3945)));
                        if _e3950 {
                            let _e3952 = local_3.member_2;
                            local_3.member[_e3952] = _e3602[3][0];
                            let _e3956 = local_3.member_2;
                            local_3.member_1[_e3956] = _e3602[3][1];
                            let _e3961 = local_3.member_2;
                            local_3.member_2 = (_e3961 + 1u);
                        }
                        if _e3950 {
                        } else {
                            let _e3965 = params.member.member_1.member_1;
                            let _e3968 = atomicAdd((&rounds.member[(_e3965 + 1u)]), 1u);
                            let _e3971 = atomicMax((&output.member[0u]), (_e3968 + 1u));
                            if ((_e3968 + 1u) < _e3968) {
                                let _e3975 = atomicAdd((&output.member[2u]), 1u);
                            }
                            let _e3978 = params.member.member_2.member_3;
                            if (_e3968 < _e3978) {
                                let _e3980 = (2u * _e3968);
                                atomicStore((&output.member[(4u + _e3980)]), _e3602[3][0]);
                                atomicStore((&output.member[(_e3980 + 5u)]), _e3602[3][1]);
                            }
                        }
                    }
                }
                phi_7032_ = true;
            }
            let _e4020 = phi_7032_;
            phi_7033_ = _e4020;
        } else {
            phi_7033_ = false;
        }
        let _e4022 = phi_7033_;
        continue;
        continuing {
            phi_3091_ = type_9(select(_e1674.member, (_e1674.member + 1u), _e1677), select(_e1674.member_1, _e1674.member_1, _e1677));
            break if !(_e4022);
        }
    }
    phi_7036_ = type_9(0u, 64u);
    loop {
        let _e4025 = phi_7036_;
        let _e4028 = (_e4025.member < _e4025.member_1);
        if (bitcast<i32>(select(0u, 1u, _e4028)) != 0i) {
            let _e4041 = local_3.member_2;
            if (_e4041 > 0u) {
                let _e4045 = local_3.member_2;
                local_3.member_2 = (_e4045 - 1u);
                let _e4048 = local_3.member_2;
                let _e4051 = local_3.member[_e4048];
                let _e4054 = local_3.member_1[_e4048];
                phi_7095_ = array<u32, 2>(_e4051, _e4054);
            } else {
                phi_7095_ = array<u32, 2>(4294967295u, 4294967295u);
            }
            let _e4057 = phi_7095_;
            if (_e4057[0] == 4294967295u) {
                phi_7138_ = false;
            } else {
                let _e4062 = params.member.member_1.member_1;
                let _e4065 = atomicAdd((&rounds.member[(_e4062 + 1u)]), 1u);
                let _e4068 = atomicMax((&output.member[0u]), (_e4065 + 1u));
                if ((_e4065 + 1u) < _e4065) {
                    let _e4072 = atomicAdd((&output.member[2u]), 1u);
                }
                let _e4075 = params.member.member_2.member_3;
                if (_e4065 < _e4075) {
                    let _e4079 = (2u * _e4065);
                    atomicStore((&output.member[(4u + _e4079)]), _e4057[0]);
                    atomicStore((&output.member[(_e4079 + 5u)]), _e4057[1]);
                }
                phi_7138_ = true;
            }
            let _e4085 = phi_7138_;
            phi_7139_ = _e4085;
        } else {
            phi_7139_ = false;
        }
        let _e4087 = phi_7139_;
        continue;
        continuing {
            phi_7036_ = type_9(select(_e4025.member, (_e4025.member + 1u), _e4028), select(_e4025.member_1, _e4025.member_1, _e4028));
            break if !(_e4087);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn descend_stacks_oriented(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}

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

struct type_10 {
    member: array<u32>,
}

struct type_13 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
}

struct type_15 {
    member: array<type_13>,
}

struct type_16 {
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

struct type_17 {
    member: type_7,
    member_1: type_8,
    member_2: type_16,
}

struct type_18 {
    member: type_17,
}

struct type_20 {
    member: array<array<f32, 3>, 3>,
    member_1: array<f32, 3>,
    member_2: array<f32, 3>,
    member_3: array<f32, 3>,
    member_4: array<f32, 3>,
    member_5: f32,
}

struct type_22 {
    member: vec4<f32>,
    member_1: vec4<f32>,
    member_2: vec4<f32>,
    member_3: vec4<f32>,
}

struct type_24 {
    member: array<type_22>,
}

struct type_25 {
    member: array<f32, 3>,
    member_1: array<array<f32, 3>, 3>,
    member_2: array<f32, 3>,
}

struct type_28 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_18;
@group(0) @binding(1) 
var<storage> a_nodes: type_15;
@group(0) @binding(2) 
var<storage> b_nodes: type_15;
@group(0) @binding(6) 
var<storage, read_write> output: type_28;
@group(0) @binding(3) 
var<storage> cuts: type_10;
@group(0) @binding(4) 
var<storage> oriented: type_24;
@group(0) @binding(5) 
var<storage, read_write> control: type_28;
@group(0) @binding(7) 
var<storage, read_write> front: type_10;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_20;
    var phi_214_: array<u32, 2>;
    var phi_215_: array<u32, 2>;
    var phi_216_: array<u32, 2>;
    var phi_267_: bool;
    var phi_268_: bool;
    var phi_269_: bool;
    var phi_270_: bool;
    var phi_575_: type_25;
    var phi_719_: type_25;
    var phi_2620_: bool;
    var phi_2622_: bool;
    var phi_2623_: bool;
    var phi_2624_: bool;
    var phi_2625_: bool;
    var phi_2630_: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e36 = id_2;
    let _e37 = n_2;
    let _e38 = lane_2;
    let _e53 = ((((_e36.y * _e37.x) + _e36.x) * 256u) + _e38);
    let _e56 = params.member.member_2.member_2;
    if (_e56 == 0u) {
        return;
    }
    let _e58 = (_e53 / _e56);
    let _e60 = params.member.member_2.member_2;
    if (_e60 == 0u) {
        return;
    }
    let _e62 = (_e53 % _e60);
    let _e64 = params.member.member_2.member;
    let _e65 = (_e64 == 1u);
    let _e67 = (select(1u, 0u, _e65) * 1028u);
    let _e69 = cuts.member[0u];
    if (_e58 < _e69) {
        let _e72 = cuts.member[_e67];
        if (_e62 < _e72) {
            if select(true, (_e58 <= _e62), _e65) {
                let _e78 = cuts.member[(4u + _e58)];
                let _e82 = cuts.member[((_e67 + 4u) + _e62)];
                phi_214_ = array<u32, 2>(_e78, _e82);
            } else {
                phi_214_ = array<u32, 2>(4294967295u, 4294967295u);
            }
            let _e85 = phi_214_;
            phi_215_ = _e85;
        } else {
            phi_215_ = array<u32, 2>(4294967295u, 4294967295u);
        }
        let _e87 = phi_215_;
        phi_216_ = _e87;
    } else {
        phi_216_ = array<u32, 2>(4294967295u, 4294967295u);
    }
    let _e89 = phi_216_;
    if (_e89[0] != 4294967295u) {
        let _e95 = params.member.member_2.member;
        if (_e95 == 1u) {
            if (_e89[0] == _e89[1]) {
                let _e102 = a_nodes.member[_e89[0]];
                phi_267_ = (_e102.member_3 == 4294967295u);
                phi_268_ = false;
            } else {
                phi_267_ = bool();
                phi_268_ = true;
            }
            let _e106 = phi_267_;
            let _e108 = phi_268_;
            phi_269_ = _e106;
            phi_270_ = _e108;
        } else {
            phi_269_ = bool();
            phi_270_ = true;
        }
        let _e110 = phi_269_;
        let _e112 = phi_270_;
        if select(_e110, false, _e112) {
        } else {
            let _e116 = a_nodes.member[_e89[0]];
            let _e119 = b_nodes.member[_e89[1]];
            if ((((((_e116.member[0] <= _e119.member_2[0]) && (_e119.member[0] <= _e116.member_2[0])) && (_e116.member[1] <= _e119.member_2[1])) && (_e119.member[1] <= _e116.member_2[1])) && (_e116.member[2] <= _e119.member_2[2])) && (_e119.member[2] <= _e116.member_2[2])) {
                let _e149 = params.member.member_2.member;
                let _e150 = (_e149 == 0u);
                let _e156 = params.member.member.member[select(1u, 0u, _e150)];
                let _e157 = (_e156 - 1u);
                let _e161 = params.member.member.member[select(1u, 2u, _e150)];
                let _e162 = (_e161 - 1u);
                let _e165 = params.member.member_2.member;
                let _e166 = (_e165 == 0u);
                let _e172 = params.member.member.member_2[select(1u, 0u, _e166)];
                let _e176 = params.member.member.member_2[select(1u, 2u, _e166)];
                let _e179 = params.member.member_2.member;
                if select(false, (_e89[0] == _e89[1]), (_e179 == 1u)) {
                    phi_2624_ = bool();
                    phi_2625_ = true;
                } else {
                    if select(true, select(true, false, (_e89[1] >= _e162)), (_e89[0] >= _e157)) {
                        if (_e89[0] < _e157) {
                            let _e259 = oriented.member[(_e172 + _e89[0])];
                            phi_575_ = type_25(array<f32, 3>(_e259.member.x, _e259.member.y, _e259.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e259.member.w, _e259.member_1.x, _e259.member_1.y), array<f32, 3>(_e259.member_1.z, _e259.member_1.w, _e259.member_2.x), array<f32, 3>(_e259.member_2.y, _e259.member_2.z, _e259.member_2.w)), array<f32, 3>(_e259.member_3.x, _e259.member_3.y, _e259.member_3.z));
                        } else {
                            let _e191 = a_nodes.member[_e89[0]];
                            let _e206 = ((_e191.member[0] * 0.5f) + (_e191.member_2[0] * 0.5f));
                            let _e207 = ((_e191.member[1] * 0.5f) + (_e191.member_2[1] * 0.5f));
                            let _e208 = ((_e191.member[2] * 0.5f) + (_e191.member_2[2] * 0.5f));
                            let _e211 = select(_e191.member_2[0], _e206, (_e206 < _e191.member_2[0]));
                            let _e214 = select(_e191.member_2[1], _e207, (_e207 < _e191.member_2[1]));
                            let _e217 = select(_e191.member_2[2], _e208, (_e208 < _e191.member_2[2]));
                            let _e220 = select(_e191.member[0], _e211, (_e211 > _e191.member[0]));
                            let _e223 = select(_e191.member[1], _e214, (_e214 > _e191.member[1]));
                            let _e226 = select(_e191.member[2], _e217, (_e217 > _e191.member[2]));
                            let _e229 = (_e191.member_2[0] - _e220);
                            let _e231 = (_e191.member_2[1] - _e223);
                            let _e233 = (_e191.member_2[2] - _e226);
                            let _e235 = (_e220 - _e191.member[0]);
                            let _e237 = (_e223 - _e191.member[1]);
                            let _e239 = (_e226 - _e191.member[2]);
                            let _e247 = (1f + (0.000000059604645f * 4f));
                            let _e251 = (0.000000000000000000000000000000000000011754944f * 8f);
                            phi_575_ = type_25(array<f32, 3>(_e220, _e223, _e226), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((select(_e235, _e229, (_e229 > _e235)) * _e247) + _e251), ((select(_e237, _e231, (_e231 > _e237)) * _e247) + _e251), ((select(_e239, _e233, (_e233 > _e239)) * _e247) + _e251)));
                        }
                        let _e298 = phi_575_;
                        if (_e89[1] < _e162) {
                            let _e369 = oriented.member[(_e176 + _e89[1])];
                            phi_719_ = type_25(array<f32, 3>(_e369.member.x, _e369.member.y, _e369.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e369.member.w, _e369.member_1.x, _e369.member_1.y), array<f32, 3>(_e369.member_1.z, _e369.member_1.w, _e369.member_2.x), array<f32, 3>(_e369.member_2.y, _e369.member_2.z, _e369.member_2.w)), array<f32, 3>(_e369.member_3.x, _e369.member_3.y, _e369.member_3.z));
                        } else {
                            let _e301 = b_nodes.member[_e89[1]];
                            let _e316 = ((_e301.member[0] * 0.5f) + (_e301.member_2[0] * 0.5f));
                            let _e317 = ((_e301.member[1] * 0.5f) + (_e301.member_2[1] * 0.5f));
                            let _e318 = ((_e301.member[2] * 0.5f) + (_e301.member_2[2] * 0.5f));
                            let _e321 = select(_e301.member_2[0], _e316, (_e316 < _e301.member_2[0]));
                            let _e324 = select(_e301.member_2[1], _e317, (_e317 < _e301.member_2[1]));
                            let _e327 = select(_e301.member_2[2], _e318, (_e318 < _e301.member_2[2]));
                            let _e330 = select(_e301.member[0], _e321, (_e321 > _e301.member[0]));
                            let _e333 = select(_e301.member[1], _e324, (_e324 > _e301.member[1]));
                            let _e336 = select(_e301.member[2], _e327, (_e327 > _e301.member[2]));
                            let _e339 = (_e301.member_2[0] - _e330);
                            let _e341 = (_e301.member_2[1] - _e333);
                            let _e343 = (_e301.member_2[2] - _e336);
                            let _e345 = (_e330 - _e301.member[0]);
                            let _e347 = (_e333 - _e301.member[1]);
                            let _e349 = (_e336 - _e301.member[2]);
                            let _e357 = (1f + (0.000000059604645f * 4f));
                            let _e361 = (0.000000000000000000000000000000000000011754944f * 8f);
                            phi_719_ = type_25(array<f32, 3>(_e330, _e333, _e336), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((select(_e345, _e339, (_e339 > _e345)) * _e357) + _e361), ((select(_e347, _e341, (_e341 > _e347)) * _e357) + _e361), ((select(_e349, _e343, (_e343 > _e349)) * _e357) + _e361)));
                        }
                        let _e408 = phi_719_;
                        let _e413 = (_e408.member[0] - _e298.member[0]);
                        let _e416 = (_e408.member[1] - _e298.member[1]);
                        let _e419 = (_e408.member[2] - _e298.member[2]);
                        local = type_20(array<array<f32, 3>, 3>(array<f32, 3>((((_e408.member_1[0][0] * _e298.member_1[0][0]) + (_e408.member_1[0][1] * _e298.member_1[0][1])) + (_e408.member_1[0][2] * _e298.member_1[0][2])), (((_e408.member_1[1][0] * _e298.member_1[0][0]) + (_e408.member_1[1][1] * _e298.member_1[0][1])) + (_e408.member_1[1][2] * _e298.member_1[0][2])), (((_e408.member_1[2][0] * _e298.member_1[0][0]) + (_e408.member_1[2][1] * _e298.member_1[0][1])) + (_e408.member_1[2][2] * _e298.member_1[0][2]))), array<f32, 3>((((_e408.member_1[0][0] * _e298.member_1[1][0]) + (_e408.member_1[0][1] * _e298.member_1[1][1])) + (_e408.member_1[0][2] * _e298.member_1[1][2])), (((_e408.member_1[1][0] * _e298.member_1[1][0]) + (_e408.member_1[1][1] * _e298.member_1[1][1])) + (_e408.member_1[1][2] * _e298.member_1[1][2])), (((_e408.member_1[2][0] * _e298.member_1[1][0]) + (_e408.member_1[2][1] * _e298.member_1[1][1])) + (_e408.member_1[2][2] * _e298.member_1[1][2]))), array<f32, 3>((((_e408.member_1[0][0] * _e298.member_1[2][0]) + (_e408.member_1[0][1] * _e298.member_1[2][1])) + (_e408.member_1[0][2] * _e298.member_1[2][2])), (((_e408.member_1[1][0] * _e298.member_1[2][0]) + (_e408.member_1[1][1] * _e298.member_1[2][1])) + (_e408.member_1[1][2] * _e298.member_1[2][2])), (((_e408.member_1[2][0] * _e298.member_1[2][0]) + (_e408.member_1[2][1] * _e298.member_1[2][1])) + (_e408.member_1[2][2] * _e298.member_1[2][2])))), array<f32, 3>((((_e298.member_1[0][0] * _e413) + (_e298.member_1[0][1] * _e416)) + (_e298.member_1[0][2] * _e419)), (((_e298.member_1[1][0] * _e413) + (_e298.member_1[1][1] * _e416)) + (_e298.member_1[1][2] * _e419)), (((_e298.member_1[2][0] * _e413) + (_e298.member_1[2][1] * _e416)) + (_e298.member_1[2][2] * _e419))), array<f32, 3>((((_e408.member_1[0][0] * _e413) + (_e408.member_1[0][1] * _e416)) + (_e408.member_1[0][2] * _e419)), (((_e408.member_1[1][0] * _e413) + (_e408.member_1[1][1] * _e416)) + (_e408.member_1[1][2] * _e419)), (((_e408.member_1[2][0] * _e413) + (_e408.member_1[2][1] * _e416)) + (_e408.member_1[2][2] * _e419))), array<f32, 3>(_e298.member_2[0], _e298.member_2[1], _e298.member_2[2]), array<f32, 3>(_e408.member_2[0], _e408.member_2[1], _e408.member_2[2]), ((((((select(_e413, -(_e413), (_e413 < 0f)) + select(_e416, -(_e416), (_e416 < 0f))) + select(_e419, -(_e419), (_e419 < 0f))) + (((select(_e298.member_2[0], -(_e298.member_2[0]), (_e298.member_2[0] < 0f)) + select(_e298.member_2[1], -(_e298.member_2[1]), (_e298.member_2[1] < 0f))) + select(_e298.member_2[2], -(_e298.member_2[2]), (_e298.member_2[2] < 0f))) + ((select(_e408.member_2[0], -(_e408.member_2[0]), (_e408.member_2[0] < 0f)) + select(_e408.member_2[1], -(_e408.member_2[1]), (_e408.member_2[1] < 0f))) + select(_e408.member_2[2], -(_e408.member_2[2]), (_e408.member_2[2] < 0f))))) * 2f) * (0.000000059604645f * 128f)) + (0.000000000000000000000000000000000000011754944f * 128f)));
                        let _e671 = local.member[0u][0u];
                        let _e675 = local.member[0u][1u];
                        let _e679 = local.member[0u][2u];
                        let _e683 = local.member[1u][0u];
                        let _e687 = local.member[1u][1u];
                        let _e691 = local.member[1u][2u];
                        let _e695 = local.member[2u][0u];
                        let _e699 = local.member[2u][1u];
                        let _e703 = local.member[2u][2u];
                        let _e705 = local.member_3;
                        let _e710 = local.member_4;
                        let _e716 = local.member_1[0u];
                        let _e735 = (select(_e716, -(_e716), (_e716 < 0f)) - (_e705[0] + (((select(_e671, -(_e671), (_e671 < 0f)) * _e710[0]) + (select(_e675, -(_e675), (_e675 < 0f)) * _e710[1])) + (select(_e679, -(_e679), (_e679 < 0f)) * _e710[2]))));
                        let _e738 = local.member_1[1u];
                        let _e757 = (select(_e738, -(_e738), (_e738 < 0f)) - (_e705[1] + (((select(_e683, -(_e683), (_e683 < 0f)) * _e710[0]) + (select(_e687, -(_e687), (_e687 < 0f)) * _e710[1])) + (select(_e691, -(_e691), (_e691 < 0f)) * _e710[2]))));
                        let _e760 = local.member_1[2u];
                        let _e779 = (select(_e760, -(_e760), (_e760 < 0f)) - (_e705[2] + (((select(_e695, -(_e695), (_e695 < 0f)) * _e710[0]) + (select(_e699, -(_e699), (_e699 < 0f)) * _e710[1])) + (select(_e703, -(_e703), (_e703 < 0f)) * _e710[2]))));
                        let _e782 = local.member_2[0u];
                        let _e801 = (select(_e782, -(_e782), (_e782 < 0f)) - (_e710[0] + (((select(_e671, -(_e671), (_e671 < 0f)) * _e705[0]) + (select(_e683, -(_e683), (_e683 < 0f)) * _e705[1])) + (select(_e695, -(_e695), (_e695 < 0f)) * _e705[2]))));
                        let _e804 = local.member_2[1u];
                        let _e823 = (select(_e804, -(_e804), (_e804 < 0f)) - (_e710[1] + (((select(_e675, -(_e675), (_e675 < 0f)) * _e705[0]) + (select(_e687, -(_e687), (_e687 < 0f)) * _e705[1])) + (select(_e699, -(_e699), (_e699 < 0f)) * _e705[2]))));
                        let _e826 = local.member_2[2u];
                        let _e845 = (select(_e826, -(_e826), (_e826 < 0f)) - (_e710[2] + (((select(_e679, -(_e679), (_e679 < 0f)) * _e705[0]) + (select(_e691, -(_e691), (_e691 < 0f)) * _e705[1])) + (select(_e703, -(_e703), (_e703 < 0f)) * _e705[2]))));
                        let _e847 = select(_e757, _e735, (_e735 > _e757));
                        let _e849 = select(_e779, _e847, (_e847 > _e779));
                        let _e851 = select(_e823, _e801, (_e801 > _e823));
                        let _e853 = select(_e845, _e851, (_e851 > _e845));
                        let _e857 = local.member_5;
                        if (select(_e853, _e849, (_e849 > _e853)) > _e857) {
                            phi_2620_ = true;
                        } else {
                            let _e862 = local.member[1u][0u];
                            let _e865 = local.member_1[2u];
                            let _e870 = local.member[2u][0u];
                            let _e873 = local.member_1[1u];
                            let _e875 = ((_e862 * _e865) - (_e870 * _e873));
                            let _e879 = local.member[2u][0u];
                            let _e885 = local.member_3[1u];
                            let _e890 = local.member[1u][0u];
                            let _e896 = local.member_3[2u];
                            let _e902 = local.member[0u][2u];
                            let _e908 = local.member_4[1u];
                            let _e913 = local.member[0u][1u];
                            let _e919 = local.member_4[2u];
                            let _e926 = (select(_e875, -(_e875), (_e875 < 0f)) - (((select(_e879, -(_e879), (_e879 < 0f)) * _e885) + (select(_e890, -(_e890), (_e890 < 0f)) * _e896)) + ((select(_e902, -(_e902), (_e902 < 0f)) * _e908) + (select(_e913, -(_e913), (_e913 < 0f)) * _e919))));
                            let _e930 = local.member[1u][1u];
                            let _e933 = local.member_1[2u];
                            let _e938 = local.member[2u][1u];
                            let _e941 = local.member_1[1u];
                            let _e943 = ((_e930 * _e933) - (_e938 * _e941));
                            let _e947 = local.member[2u][1u];
                            let _e953 = local.member_3[1u];
                            let _e958 = local.member[1u][1u];
                            let _e964 = local.member_3[2u];
                            let _e970 = local.member[0u][0u];
                            let _e976 = local.member_4[2u];
                            let _e981 = local.member[0u][2u];
                            let _e987 = local.member_4[0u];
                            let _e994 = (select(_e943, -(_e943), (_e943 < 0f)) - (((select(_e947, -(_e947), (_e947 < 0f)) * _e953) + (select(_e958, -(_e958), (_e958 < 0f)) * _e964)) + ((select(_e970, -(_e970), (_e970 < 0f)) * _e976) + (select(_e981, -(_e981), (_e981 < 0f)) * _e987))));
                            let _e998 = local.member[1u][2u];
                            let _e1001 = local.member_1[2u];
                            let _e1006 = local.member[2u][2u];
                            let _e1009 = local.member_1[1u];
                            let _e1011 = ((_e998 * _e1001) - (_e1006 * _e1009));
                            let _e1015 = local.member[2u][2u];
                            let _e1021 = local.member_3[1u];
                            let _e1026 = local.member[1u][2u];
                            let _e1032 = local.member_3[2u];
                            let _e1038 = local.member[0u][1u];
                            let _e1044 = local.member_4[0u];
                            let _e1049 = local.member[0u][0u];
                            let _e1055 = local.member_4[1u];
                            let _e1062 = (select(_e1011, -(_e1011), (_e1011 < 0f)) - (((select(_e1015, -(_e1015), (_e1015 < 0f)) * _e1021) + (select(_e1026, -(_e1026), (_e1026 < 0f)) * _e1032)) + ((select(_e1038, -(_e1038), (_e1038 < 0f)) * _e1044) + (select(_e1049, -(_e1049), (_e1049 < 0f)) * _e1055))));
                            let _e1066 = local.member[2u][0u];
                            let _e1069 = local.member_1[0u];
                            let _e1074 = local.member[0u][0u];
                            let _e1077 = local.member_1[2u];
                            let _e1079 = ((_e1066 * _e1069) - (_e1074 * _e1077));
                            let _e1083 = local.member[0u][0u];
                            let _e1089 = local.member_3[2u];
                            let _e1094 = local.member[2u][0u];
                            let _e1100 = local.member_3[0u];
                            let _e1106 = local.member[1u][2u];
                            let _e1112 = local.member_4[1u];
                            let _e1117 = local.member[1u][1u];
                            let _e1123 = local.member_4[2u];
                            let _e1130 = (select(_e1079, -(_e1079), (_e1079 < 0f)) - (((select(_e1083, -(_e1083), (_e1083 < 0f)) * _e1089) + (select(_e1094, -(_e1094), (_e1094 < 0f)) * _e1100)) + ((select(_e1106, -(_e1106), (_e1106 < 0f)) * _e1112) + (select(_e1117, -(_e1117), (_e1117 < 0f)) * _e1123))));
                            let _e1134 = local.member[2u][1u];
                            let _e1137 = local.member_1[0u];
                            let _e1142 = local.member[0u][1u];
                            let _e1145 = local.member_1[2u];
                            let _e1147 = ((_e1134 * _e1137) - (_e1142 * _e1145));
                            let _e1151 = local.member[0u][1u];
                            let _e1157 = local.member_3[2u];
                            let _e1162 = local.member[2u][1u];
                            let _e1168 = local.member_3[0u];
                            let _e1174 = local.member[1u][0u];
                            let _e1180 = local.member_4[2u];
                            let _e1185 = local.member[1u][2u];
                            let _e1191 = local.member_4[0u];
                            let _e1198 = (select(_e1147, -(_e1147), (_e1147 < 0f)) - (((select(_e1151, -(_e1151), (_e1151 < 0f)) * _e1157) + (select(_e1162, -(_e1162), (_e1162 < 0f)) * _e1168)) + ((select(_e1174, -(_e1174), (_e1174 < 0f)) * _e1180) + (select(_e1185, -(_e1185), (_e1185 < 0f)) * _e1191))));
                            let _e1202 = local.member[2u][2u];
                            let _e1205 = local.member_1[0u];
                            let _e1210 = local.member[0u][2u];
                            let _e1213 = local.member_1[2u];
                            let _e1215 = ((_e1202 * _e1205) - (_e1210 * _e1213));
                            let _e1219 = local.member[0u][2u];
                            let _e1225 = local.member_3[2u];
                            let _e1230 = local.member[2u][2u];
                            let _e1236 = local.member_3[0u];
                            let _e1242 = local.member[1u][1u];
                            let _e1248 = local.member_4[0u];
                            let _e1253 = local.member[1u][0u];
                            let _e1259 = local.member_4[1u];
                            let _e1266 = (select(_e1215, -(_e1215), (_e1215 < 0f)) - (((select(_e1219, -(_e1219), (_e1219 < 0f)) * _e1225) + (select(_e1230, -(_e1230), (_e1230 < 0f)) * _e1236)) + ((select(_e1242, -(_e1242), (_e1242 < 0f)) * _e1248) + (select(_e1253, -(_e1253), (_e1253 < 0f)) * _e1259))));
                            let _e1270 = local.member[0u][0u];
                            let _e1273 = local.member_1[1u];
                            let _e1278 = local.member[1u][0u];
                            let _e1281 = local.member_1[0u];
                            let _e1283 = ((_e1270 * _e1273) - (_e1278 * _e1281));
                            let _e1287 = local.member[1u][0u];
                            let _e1293 = local.member_3[0u];
                            let _e1298 = local.member[0u][0u];
                            let _e1304 = local.member_3[1u];
                            let _e1310 = local.member[2u][2u];
                            let _e1316 = local.member_4[1u];
                            let _e1321 = local.member[2u][1u];
                            let _e1327 = local.member_4[2u];
                            let _e1334 = (select(_e1283, -(_e1283), (_e1283 < 0f)) - (((select(_e1287, -(_e1287), (_e1287 < 0f)) * _e1293) + (select(_e1298, -(_e1298), (_e1298 < 0f)) * _e1304)) + ((select(_e1310, -(_e1310), (_e1310 < 0f)) * _e1316) + (select(_e1321, -(_e1321), (_e1321 < 0f)) * _e1327))));
                            let _e1338 = local.member[0u][1u];
                            let _e1341 = local.member_1[1u];
                            let _e1346 = local.member[1u][1u];
                            let _e1349 = local.member_1[0u];
                            let _e1351 = ((_e1338 * _e1341) - (_e1346 * _e1349));
                            let _e1355 = local.member[1u][1u];
                            let _e1361 = local.member_3[0u];
                            let _e1366 = local.member[0u][1u];
                            let _e1372 = local.member_3[1u];
                            let _e1378 = local.member[2u][0u];
                            let _e1384 = local.member_4[2u];
                            let _e1389 = local.member[2u][2u];
                            let _e1395 = local.member_4[0u];
                            let _e1402 = (select(_e1351, -(_e1351), (_e1351 < 0f)) - (((select(_e1355, -(_e1355), (_e1355 < 0f)) * _e1361) + (select(_e1366, -(_e1366), (_e1366 < 0f)) * _e1372)) + ((select(_e1378, -(_e1378), (_e1378 < 0f)) * _e1384) + (select(_e1389, -(_e1389), (_e1389 < 0f)) * _e1395))));
                            let _e1406 = local.member[0u][2u];
                            let _e1409 = local.member_1[1u];
                            let _e1414 = local.member[1u][2u];
                            let _e1417 = local.member_1[0u];
                            let _e1419 = ((_e1406 * _e1409) - (_e1414 * _e1417));
                            let _e1423 = local.member[1u][2u];
                            let _e1429 = local.member_3[0u];
                            let _e1434 = local.member[0u][2u];
                            let _e1440 = local.member_3[1u];
                            let _e1446 = local.member[2u][1u];
                            let _e1452 = local.member_4[0u];
                            let _e1457 = local.member[2u][0u];
                            let _e1463 = local.member_4[1u];
                            let _e1470 = (select(_e1419, -(_e1419), (_e1419 < 0f)) - (((select(_e1423, -(_e1423), (_e1423 < 0f)) * _e1429) + (select(_e1434, -(_e1434), (_e1434 < 0f)) * _e1440)) + ((select(_e1446, -(_e1446), (_e1446 < 0f)) * _e1452) + (select(_e1457, -(_e1457), (_e1457 < 0f)) * _e1463))));
                            let _e1472 = select(_e994, _e926, (_e926 > _e994));
                            let _e1474 = select(_e1062, _e1472, (_e1472 > _e1062));
                            let _e1476 = select(_e1198, _e1130, (_e1130 > _e1198));
                            let _e1478 = select(_e1266, _e1476, (_e1476 > _e1266));
                            let _e1480 = select(_e1478, _e1474, (_e1474 > _e1478));
                            let _e1482 = select(_e1402, _e1334, (_e1334 > _e1402));
                            let _e1484 = select(_e1470, _e1482, (_e1482 > _e1470));
                            let _e1488 = local.member_5;
                            phi_2620_ = (select(_e1484, _e1480, (_e1480 > _e1484)) > _e1488);
                        }
                        let _e1491 = phi_2620_;
                        phi_2622_ = !(_e1491);
                        phi_2623_ = false;
                    } else {
                        phi_2622_ = bool();
                        phi_2623_ = true;
                    }
                    let _e1494 = phi_2622_;
                    let _e1496 = phi_2623_;
                    phi_2624_ = _e1494;
                    phi_2625_ = _e1496;
                }
                let _e1498 = phi_2624_;
                let _e1500 = phi_2625_;
                phi_2630_ = select(_e1498, true, _e1500);
            } else {
                phi_2630_ = false;
            }
            let _e1503 = phi_2630_;
            if _e1503 {
                let _e1530 = atomicAdd((&control.member[0u]), 1u);
                let _e1533 = atomicMax((&output.member[0u]), (_e1530 + 1u));
                if ((_e1530 + 1u) < _e1530) {
                    let _e1537 = atomicAdd((&output.member[2u]), 1u);
                }
                let _e1540 = params.member.member_2.member_3;
                if (_e1530 < _e1540) {
                    let _e1544 = (2u * _e1530);
                    atomicStore((&output.member[(4u + _e1544)]), _e89[0]);
                    atomicStore((&output.member[(_e1544 + 5u)]), _e89[1]);
                }
            } else {
                let _e1506 = params.member.member_2.member_4;
                if (_e1506 > 0u) {
                    let _e1509 = atomicAdd((&control.member[1537u]), 1u);
                    if ((_e1509 + 1u) < _e1509) {
                        let _e1513 = atomicAdd((&control.member[1538u]), 1u);
                    }
                    let _e1515 = params.member.member_2.member_4;
                    if (_e1509 < _e1515) {
                        let _e1518 = params.member.member_2.member_5;
                        let _e1520 = params.member.member_2.member_4;
                        let _e1523 = (2u * ((_e1518 * _e1520) + _e1509));
                        front.member[_e1523] = _e89[0];
                        front.member[(_e1523 + 1u)] = _e89[1];
                    }
                }
            }
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn cut_pairs_oriented(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}

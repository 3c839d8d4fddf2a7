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
    member: u32,
}

struct type_17 {
    member: type_7,
    member_1: type_8,
    member_2: type_16,
}

struct type_18 {
    member: type_17,
}

struct type_19 {
    member: u32,
    member_1: array<u32, 4>,
}

struct type_20 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_22 {
    member: array<type_20>,
}

struct type_24 {
    member: array<array<f32, 3>, 2>,
    member_1: array<array<f32, 3>, 2>,
    member_2: array<array<f32, 3>, 2>,
    member_3: f32,
}

struct type_25 {
    member: array<array<f32, 3>, 2>,
    member_1: array<array<f32, 3>, 2>,
}

struct type_29 {
    member: array<atomic<u32>>,
}

@group(0) @binding(5) 
var<storage, read_write> output: type_29;
@group(0) @binding(0) 
var<storage> params: type_18;
@group(0) @binding(1) 
var<storage> elements: type_11;
@group(0) @binding(2) 
var<storage> paths: type_22;
@group(0) @binding(3) 
var<storage> vf: type_11;
@group(0) @binding(4) 
var<storage> ee: type_11;
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
    var local: type_24;
    var local_1: type_24;
    var local_2: type_24;
    var phi_244_: u32;
    var phi_289_: u32;
    var phi_292_: type_9;
    var phi_351_: type_9;
    var phi_441_: type_9;
    var phi_532_: type_19;
    var phi_654_: type_25;
    var phi_701_: type_25;
    var phi_774_: bool;
    var phi_908_: type_24;
    var phi_2543_: f32;
    var phi_2546_: bool;
    var phi_2557_: bool;
    var phi_2558_: bool;
    var phi_2563_: type_9;
    var phi_2694_: type_19;
    var phi_2827_: type_24;
    var phi_4561_: f32;
    var phi_4564_: bool;
    var phi_6164_: f32;
    var phi_6167_: bool;
    var phi_6169_: bool;
    var phi_6178_: bool;
    var phi_6179_: bool;
    var phi_6222_: type_9;
    var phi_6281_: bool;
    var phi_6282_: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e45 = id_2;
    let _e46 = n_2;
    let _e47 = lane_2;
    let _e58 = ((_e45.y * _e46.x) + _e45.x);
    let _e61 = (_e46.x * _e46.y);
    let _e63 = params.member.member;
    let _e71 = params.member.member_1.member_2;
    let _e73 = vf.member[0u];
    let _e75 = select(_e73, _e71, (_e71 < _e73));
    let _e78 = params.member.member_2.member;
    let _e80 = ee.member[0u];
    let _e82 = select(_e80, _e78, (_e78 < _e80));
    let _e83 = (_e75 / 512u);
    let _e87 = select(_e83, (_e83 + 1u), ((_e75 % 512u) > 0u));
    let _e88 = (_e82 / 512u);
    let _e93 = (_e87 + select(_e88, (_e88 + 1u), ((_e82 % 512u) > 0u)));
    let _e95 = params.member.member_1.member_1;
    if (_e93 > _e95) {
        let _e98 = params.member.member_1.member_1;
        phi_244_ = (_e93 - _e98);
    } else {
        phi_244_ = 0u;
    }
    let _e101 = phi_244_;
    let _e103 = params.member.member_1.member;
    let _e105 = select(_e101, _e103, (_e103 < _e101));
    if (_e105 > _e58) {
        let _e107 = (_e105 - _e58);
        if (_e61 == 0u) {
            return;
        }
        let _e109 = (_e107 / _e61);
        if (_e61 == 0u) {
            return;
        }
        phi_289_ = select(_e109, (_e109 + 1u), ((_e107 % _e61) > 0u));
    } else {
        phi_289_ = 0u;
    }
    let _e116 = phi_289_;
    phi_292_ = type_9(0u, _e116);
    loop {
        let _e119 = phi_292_;
        let _e122 = (_e119.member < _e119.member_1);
        let _e135 = (bitcast<i32>(select(0u, 1u, _e122)) != 0i);
        if _e135 {
            let _e137 = params.member.member_1.member_1;
            let _e140 = ((_e137 + _e58) + (select(type_9().member_1, _e119.member, _e122) * _e61));
            let _e141 = (_e140 >= _e87);
            let _e142 = select(0u, 1u, _e141);
            if (_e47 <= 1u) {
                atomicStore((&counters[_e47]), 0u);
            }
            workgroupBarrier();
            phi_351_ = type_9(0u, 4u);
            loop {
                let _e150 = phi_351_;
                let _e153 = (_e150.member < _e150.member_1);
                if (bitcast<i32>(select(0u, 1u, _e153)) != 0i) {
                    let _e169 = (((512u * select(_e140, (_e140 - _e87), _e141)) + (select(type_9().member_1, _e150.member, _e153) * 128u)) + _e47);
                    if (_e169 >= select(_e75, _e82, _e141)) {
                        phi_2557_ = false;
                    } else {
                        if _e141 {
                            let _e179 = (2u * _e169);
                            let _e182 = ee.member[(4u + _e179)];
                            let _e185 = ee.member[(_e179 + 5u)];
                            phi_441_ = type_9(_e182, _e185);
                        } else {
                            let _e171 = (2u * _e169);
                            let _e174 = vf.member[(4u + _e171)];
                            let _e177 = vf.member[(_e171 + 5u)];
                            phi_441_ = type_9(_e174, _e177);
                        }
                        let _e188 = phi_441_;
                        if (_e142 == 0u) {
                            let _e210 = ((2u * _e63.member[1]) + (3u * _e188.member_1));
                            let _e212 = elements.member[_e210];
                            let _e215 = elements.member[(_e210 + 1u)];
                            let _e218 = elements.member[(_e210 + 2u)];
                            phi_532_ = type_19(0u, array<u32, 4>(_e188.member, _e212, _e215, _e218));
                        } else {
                            let _e192 = (2u * _e188.member);
                            let _e194 = elements.member[_e192];
                            let _e197 = elements.member[(_e192 + 1u)];
                            let _e198 = (2u * _e188.member_1);
                            let _e200 = elements.member[_e198];
                            let _e203 = elements.member[(_e198 + 1u)];
                            phi_532_ = type_19(1u, array<u32, 4>(_e194, _e197, _e200, _e203));
                        }
                        let _e222 = phi_532_;
                        if ((_e63.member_1 & 512u) != 0u) {
                            phi_774_ = true;
                        } else {
                            let _e227 = paths.member[_e222.member_1[0]];
                            let _e242 = paths.member[_e222.member_1[1]];
                            let _e257 = paths.member[_e222.member_1[2]];
                            let _e272 = paths.member[_e222.member_1[3]];
                            let _e285 = array<f32, 3>(_e227.member.x, _e227.member.y, _e227.member.z);
                            let _e286 = array<f32, 3>(_e227.member_1.x, _e227.member_1.y, _e227.member_1.z);
                            if (_e222.member != 0u) {
                                let _e311 = function_(_e227.member.x, _e242.member.x);
                                let _e312 = function_(_e227.member.y, _e242.member.y);
                                let _e313 = function_(_e227.member.z, _e242.member.z);
                                let _e315 = function_1(_e227.member.x, _e242.member.x);
                                let _e316 = function_1(_e227.member.y, _e242.member.y);
                                let _e317 = function_1(_e227.member.z, _e242.member.z);
                                let _e320 = function_(_e257.member.x, _e272.member.x);
                                let _e321 = function_(_e257.member.y, _e272.member.y);
                                let _e322 = function_(_e257.member.z, _e272.member.z);
                                let _e324 = function_1(_e257.member.x, _e272.member.x);
                                let _e325 = function_1(_e257.member.y, _e272.member.y);
                                let _e326 = function_1(_e257.member.z, _e272.member.z);
                                phi_654_ = type_25(array<array<f32, 3>, 2>(array<f32, 3>(_e311, _e312, _e313), array<f32, 3>(_e315, _e316, _e317)), array<array<f32, 3>, 2>(array<f32, 3>(_e320, _e321, _e322), array<f32, 3>(_e324, _e325, _e326)));
                            } else {
                                let _e288 = function_(_e242.member.x, _e257.member.x);
                                let _e289 = function_(_e242.member.y, _e257.member.y);
                                let _e290 = function_(_e242.member.z, _e257.member.z);
                                let _e291 = function_1(_e242.member.x, _e257.member.x);
                                let _e292 = function_1(_e242.member.y, _e257.member.y);
                                let _e293 = function_1(_e242.member.z, _e257.member.z);
                                let _e295 = function_(_e288, _e272.member.x);
                                let _e296 = function_(_e289, _e272.member.y);
                                let _e297 = function_(_e290, _e272.member.z);
                                let _e299 = function_1(_e288, _e272.member.x);
                                let _e300 = function_1(_e289, _e272.member.y);
                                let _e301 = function_1(_e290, _e272.member.z);
                                let _e302 = function_(_e291, _e272.member.x);
                                let _e303 = function_(_e292, _e272.member.y);
                                let _e304 = function_(_e293, _e272.member.z);
                                let _e305 = function_1(_e291, _e272.member.x);
                                let _e306 = function_1(_e292, _e272.member.y);
                                let _e307 = function_1(_e293, _e272.member.z);
                                phi_654_ = type_25(array<array<f32, 3>, 2>(_e285, _e285), array<array<f32, 3>, 2>(array<f32, 3>(_e295, _e296, _e297), array<f32, 3>(_e305, _e306, _e307)));
                            }
                            let _e331 = phi_654_;
                            if (_e222.member != 0u) {
                                let _e356 = function_(_e227.member_1.x, _e242.member_1.x);
                                let _e357 = function_(_e227.member_1.y, _e242.member_1.y);
                                let _e358 = function_(_e227.member_1.z, _e242.member_1.z);
                                let _e360 = function_1(_e227.member_1.x, _e242.member_1.x);
                                let _e361 = function_1(_e227.member_1.y, _e242.member_1.y);
                                let _e362 = function_1(_e227.member_1.z, _e242.member_1.z);
                                let _e365 = function_(_e257.member_1.x, _e272.member_1.x);
                                let _e366 = function_(_e257.member_1.y, _e272.member_1.y);
                                let _e367 = function_(_e257.member_1.z, _e272.member_1.z);
                                let _e369 = function_1(_e257.member_1.x, _e272.member_1.x);
                                let _e370 = function_1(_e257.member_1.y, _e272.member_1.y);
                                let _e371 = function_1(_e257.member_1.z, _e272.member_1.z);
                                phi_701_ = type_25(array<array<f32, 3>, 2>(array<f32, 3>(_e356, _e357, _e358), array<f32, 3>(_e360, _e361, _e362)), array<array<f32, 3>, 2>(array<f32, 3>(_e365, _e366, _e367), array<f32, 3>(_e369, _e370, _e371)));
                            } else {
                                let _e333 = function_(_e242.member_1.x, _e257.member_1.x);
                                let _e334 = function_(_e242.member_1.y, _e257.member_1.y);
                                let _e335 = function_(_e242.member_1.z, _e257.member_1.z);
                                let _e336 = function_1(_e242.member_1.x, _e257.member_1.x);
                                let _e337 = function_1(_e242.member_1.y, _e257.member_1.y);
                                let _e338 = function_1(_e242.member_1.z, _e257.member_1.z);
                                let _e340 = function_(_e333, _e272.member_1.x);
                                let _e341 = function_(_e334, _e272.member_1.y);
                                let _e342 = function_(_e335, _e272.member_1.z);
                                let _e344 = function_1(_e333, _e272.member_1.x);
                                let _e345 = function_1(_e334, _e272.member_1.y);
                                let _e346 = function_1(_e335, _e272.member_1.z);
                                let _e347 = function_(_e336, _e272.member_1.x);
                                let _e348 = function_(_e337, _e272.member_1.y);
                                let _e349 = function_(_e338, _e272.member_1.z);
                                let _e350 = function_1(_e336, _e272.member_1.x);
                                let _e351 = function_1(_e337, _e272.member_1.y);
                                let _e352 = function_1(_e338, _e272.member_1.z);
                                phi_701_ = type_25(array<array<f32, 3>, 2>(_e286, _e286), array<array<f32, 3>, 2>(array<f32, 3>(_e340, _e341, _e342), array<f32, 3>(_e350, _e351, _e352)));
                            }
                            let _e376 = phi_701_;
                            let _e385 = (((_e63.member_5 + (2f * _e63.member_4)) * 1.0001f) + (8f * 0.000000000000000000000000000000000000011754944f));
                            phi_774_ = !(((((((_e331.member[0][0] - _e331.member_1[1][0]) > _e385) && ((_e376.member[0][0] - _e376.member_1[1][0]) > _e385)) || (((_e331.member_1[0][0] - _e331.member[1][0]) > _e385) && ((_e376.member_1[0][0] - _e376.member[1][0]) > _e385))) || ((((_e331.member[0][1] - _e331.member_1[1][1]) > _e385) && ((_e376.member[0][1] - _e376.member_1[1][1]) > _e385)) || (((_e331.member_1[0][1] - _e331.member[1][1]) > _e385) && ((_e376.member_1[0][1] - _e376.member[1][1]) > _e385)))) || ((((_e331.member[0][2] - _e331.member_1[1][2]) > _e385) && ((_e376.member[0][2] - _e376.member_1[1][2]) > _e385)) || (((_e331.member_1[0][2] - _e331.member[1][2]) > _e385) && ((_e376.member_1[0][2] - _e376.member[1][2]) > _e385)))));
                        }
                        let _e471 = phi_774_;
                        if _e471 {
                            let _e474 = paths.member[_e222.member_1[0]];
                            let _e489 = paths.member[_e222.member_1[1]];
                            let _e504 = paths.member[_e222.member_1[2]];
                            let _e519 = paths.member[_e222.member_1[3]];
                            if (_e222.member != 0u) {
                                phi_908_ = type_24(array<array<f32, 3>, 2>(array<f32, 3>((_e504.member.x - _e474.member.x), (_e504.member.y - _e474.member.y), (_e504.member.z - _e474.member.z)), array<f32, 3>((_e504.member_1.x - _e474.member_1.x), (_e504.member_1.y - _e474.member_1.y), (_e504.member_1.z - _e474.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e489.member.x - _e474.member.x), (_e489.member.y - _e474.member.y), (_e489.member.z - _e474.member.z)), array<f32, 3>((_e489.member_1.x - _e474.member_1.x), (_e489.member_1.y - _e474.member_1.y), (_e489.member_1.z - _e474.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e504.member.x - _e519.member.x), (_e504.member.y - _e519.member.y), (_e504.member.z - _e519.member.z)), array<f32, 3>((_e504.member_1.x - _e519.member_1.x), (_e504.member_1.y - _e519.member_1.y), (_e504.member_1.z - _e519.member_1.z))), (_e63.member_4 + _e63.member_4));
                            } else {
                                phi_908_ = type_24(array<array<f32, 3>, 2>(array<f32, 3>((_e474.member.x - _e489.member.x), (_e474.member.y - _e489.member.y), (_e474.member.z - _e489.member.z)), array<f32, 3>((_e474.member_1.x - _e489.member_1.x), (_e474.member_1.y - _e489.member_1.y), (_e474.member_1.z - _e489.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e504.member.x - _e489.member.x), (_e504.member.y - _e489.member.y), (_e504.member.z - _e489.member.z)), array<f32, 3>((_e504.member_1.x - _e489.member_1.x), (_e504.member_1.y - _e489.member_1.y), (_e504.member_1.z - _e489.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e519.member.x - _e489.member.x), (_e519.member.y - _e489.member.y), (_e519.member.z - _e489.member.z)), array<f32, 3>((_e519.member_1.x - _e489.member_1.x), (_e519.member_1.y - _e489.member_1.y), (_e519.member_1.z - _e489.member_1.z))), (_e63.member_4 + _e63.member_4));
                            }
                            let _e592 = phi_908_;
                            local_2 = type_24(array<array<f32, 3>, 2>(array<f32, 3>(_e592.member[0][0], _e592.member[0][1], _e592.member[0][2]), array<f32, 3>(_e592.member[1][0], _e592.member[1][1], _e592.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e592.member_1[0][0], _e592.member_1[0][1], _e592.member_1[0][2]), array<f32, 3>(_e592.member_1[1][0], _e592.member_1[1][1], _e592.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e592.member_2[0][0], _e592.member_2[0][1], _e592.member_2[0][2]), array<f32, 3>(_e592.member_2[1][0], _e592.member_2[1][1], _e592.member_2[1][2])), _e592.member_3);
                            let _e633 = local_2.member_1[0u];
                            let _e639 = local_2.member_2[0u];
                            let _e645 = ((_e633[1] * _e639[2]) - (_e633[2] * _e639[1]));
                            let _e648 = ((_e633[2] * _e639[0]) - (_e633[0] * _e639[2]));
                            let _e651 = ((_e633[0] * _e639[1]) - (_e633[1] * _e639[0]));
                            let _e654 = local_2.member_1[1u];
                            let _e660 = local_2.member_2[1u];
                            let _e666 = ((_e654[1] * _e660[2]) - (_e654[2] * _e660[1]));
                            let _e669 = ((_e654[2] * _e660[0]) - (_e654[0] * _e660[2]));
                            let _e672 = ((_e654[0] * _e660[1]) - (_e654[1] * _e660[0]));
                            let _e675 = local_2.member_1[0u];
                            let _e681 = local_2.member_2[1u];
                            let _e696 = local_2.member_1[1u];
                            let _e702 = local_2.member_2[0u];
                            let _e715 = (((_e675[1] * _e681[2]) - (_e675[2] * _e681[1])) + ((_e696[1] * _e702[2]) - (_e696[2] * _e702[1])));
                            let _e716 = (((_e675[2] * _e681[0]) - (_e675[0] * _e681[2])) + ((_e696[2] * _e702[0]) - (_e696[0] * _e702[2])));
                            let _e717 = (((_e675[0] * _e681[1]) - (_e675[1] * _e681[0])) + ((_e696[0] * _e702[1]) - (_e696[1] * _e702[0])));
                            let _e720 = local_2.member[0u];
                            let _e731 = local_2.member[1u];
                            let _e742 = local_2.member[0u];
                            let _e751 = ((((_e731[0] * _e645) + (_e731[1] * _e648)) + (_e731[2] * _e651)) + (((_e742[0] * _e715) + (_e742[1] * _e716)) + (_e742[2] * _e717)));
                            let _e754 = local_2.member[0u];
                            let _e765 = local_2.member[1u];
                            let _e774 = ((((_e754[0] * _e666) + (_e754[1] * _e669)) + (_e754[2] * _e672)) + (((_e765[0] * _e715) + (_e765[1] * _e716)) + (_e765[2] * _e717)));
                            let _e777 = local_2.member[1u];
                            let _e788 = local_2.member[0u];
                            let _e794 = select(_e788[0], -(_e788[0]), (_e788[0] < 0f));
                            let _e797 = select(_e788[1], -(_e788[1]), (_e788[1] < 0f));
                            let _e799 = select(_e797, _e794, (_e794 > _e797));
                            let _e802 = select(_e788[2], -(_e788[2]), (_e788[2] < 0f));
                            let _e804 = select(_e802, _e799, (_e799 > _e802));
                            let _e807 = local_2.member[1u];
                            let _e813 = select(_e807[0], -(_e807[0]), (_e807[0] < 0f));
                            let _e816 = select(_e807[1], -(_e807[1]), (_e807[1] < 0f));
                            let _e818 = select(_e816, _e813, (_e813 > _e816));
                            let _e821 = select(_e807[2], -(_e807[2]), (_e807[2] < 0f));
                            let _e823 = select(_e821, _e818, (_e818 > _e821));
                            let _e827 = local_2.member_3;
                            let _e828 = (select(_e823, _e804, (_e804 > _e823)) + _e827);
                            let _e831 = local_2.member_1[0u];
                            let _e837 = select(_e831[0], -(_e831[0]), (_e831[0] < 0f));
                            let _e840 = select(_e831[1], -(_e831[1]), (_e831[1] < 0f));
                            let _e842 = select(_e840, _e837, (_e837 > _e840));
                            let _e845 = select(_e831[2], -(_e831[2]), (_e831[2] < 0f));
                            let _e847 = select(_e845, _e842, (_e842 > _e845));
                            let _e850 = local_2.member_1[1u];
                            let _e856 = select(_e850[0], -(_e850[0]), (_e850[0] < 0f));
                            let _e859 = select(_e850[1], -(_e850[1]), (_e850[1] < 0f));
                            let _e861 = select(_e859, _e856, (_e856 > _e859));
                            let _e864 = select(_e850[2], -(_e850[2]), (_e850[2] < 0f));
                            let _e866 = select(_e864, _e861, (_e861 > _e864));
                            let _e870 = local_2.member_3;
                            let _e871 = (select(_e866, _e847, (_e847 > _e866)) + _e870);
                            let _e874 = local_2.member_2[0u];
                            let _e880 = select(_e874[0], -(_e874[0]), (_e874[0] < 0f));
                            let _e883 = select(_e874[1], -(_e874[1]), (_e874[1] < 0f));
                            let _e885 = select(_e883, _e880, (_e880 > _e883));
                            let _e888 = select(_e874[2], -(_e874[2]), (_e874[2] < 0f));
                            let _e890 = select(_e888, _e885, (_e885 > _e888));
                            let _e893 = local_2.member_2[1u];
                            let _e899 = select(_e893[0], -(_e893[0]), (_e893[0] < 0f));
                            let _e902 = select(_e893[1], -(_e893[1]), (_e893[1] < 0f));
                            let _e904 = select(_e902, _e899, (_e899 > _e902));
                            let _e907 = select(_e893[2], -(_e893[2]), (_e893[2] < 0f));
                            let _e909 = select(_e907, _e904, (_e904 > _e907));
                            let _e913 = local_2.member_3;
                            let _e914 = (select(_e909, _e890, (_e890 > _e909)) + _e913);
                            let _e916 = ((_e871 * 8f) * _e914);
                            let _e923 = local_2.member_3;
                            let _e947 = ((select(_e645, -(_e645), (_e645 < 0f)) + select(_e648, -(_e648), (_e648 < 0f))) + select(_e651, -(_e651), (_e651 < 0f)));
                            let _e958 = ((select(_e666, -(_e666), (_e666 < 0f)) + select(_e669, -(_e669), (_e669 < 0f))) + select(_e672, -(_e672), (_e672 < 0f)));
                            let _e960 = select(_e958, _e947, (_e947 > _e958));
                            let _e972 = (((select(_e715, -(_e715), (_e715 < 0f)) + select(_e716, -(_e716), (_e716 < 0f))) + select(_e717, -(_e717), (_e717 < 0f))) * 0.5f);
                            let _e979 = local_2.member_3;
                            let _e992 = ((((_e720[0] * _e645) + (_e720[1] * _e648)) + (_e720[2] * _e651)) * 3f);
                            let _e993 = ((((_e777[0] * _e666) + (_e777[1] * _e669)) + (_e777[2] * _e672)) * 3f);
                            let _e995 = select(_e993, _e992, (_e992 < _e993));
                            let _e997 = select(_e774, _e751, (_e751 < _e774));
                            let _e999 = select(_e997, _e995, (_e995 < _e997));
                            let _e1001 = select(_e993, _e992, (_e992 > _e993));
                            let _e1003 = select(_e774, _e751, (_e751 > _e774));
                            let _e1010 = -(select(_e1003, _e1001, (_e1001 > _e1003)));
                            let _e1014 = ((select(_e1010, _e999, (_e999 > _e1010)) - ((((((_e828 * 8f) * _e916) * (0.000000059604645f * (524f / 64f))) + ((_e923 * 19f) * ((_e828 * (_e871 + _e914)) + (_e871 * _e914)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e828) * ((1f + _e871) * (1f + _e914))))) + ((_e63.member_5 * (((select(_e972, _e960, (_e960 > _e972)) + (_e916 * (0.000000059604645f * 8f))) + ((_e979 * 6f) * (_e871 + _e914))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e871) * (1f + _e914))))) * (3f * 1.0001f)))) > 0f);
                            if _e1014 {
                                phi_2546_ = _e1014;
                            } else {
                                let _e1017 = local_2.member_1[0u];
                                let _e1023 = local_2.member_1[1u];
                                let _e1027 = (_e1017[0] + _e1023[0]);
                                let _e1028 = (_e1017[1] + _e1023[1]);
                                let _e1029 = (_e1017[2] + _e1023[2]);
                                let _e1032 = local_2.member_2[0u];
                                let _e1038 = local_2.member_2[1u];
                                let _e1042 = (_e1032[0] + _e1038[0]);
                                let _e1043 = (_e1032[1] + _e1038[1]);
                                let _e1044 = (_e1032[2] + _e1038[2]);
                                let _e1047 = ((_e1028 * _e1044) - (_e1029 * _e1043));
                                let _e1050 = ((_e1029 * _e1042) - (_e1027 * _e1044));
                                let _e1053 = ((_e1027 * _e1043) - (_e1028 * _e1042));
                                let _e1056 = local_2.member[0u];
                                let _e1062 = local_2.member_1[0u];
                                let _e1068 = local_2.member_2[0u];
                                let _e1072 = (_e1056[0] - _e1062[0]);
                                let _e1073 = (_e1056[1] - _e1062[1]);
                                let _e1074 = (_e1056[2] - _e1062[2]);
                                let _e1075 = (_e222.member == 0u);
                                let _e1079 = select((_e1072 - _e1068[0]), _e1056[0], _e1075);
                                let _e1080 = select((_e1073 - _e1068[1]), _e1056[1], _e1075);
                                let _e1081 = select((_e1074 - _e1068[2]), _e1056[2], _e1075);
                                let _e1082 = (_e1056[0] - _e1068[0]);
                                let _e1083 = (_e1056[1] - _e1068[1]);
                                let _e1084 = (_e1056[2] - _e1068[2]);
                                let _e1087 = local_2.member[1u];
                                let _e1093 = local_2.member_1[1u];
                                let _e1099 = local_2.member_2[1u];
                                let _e1103 = (_e1087[0] - _e1093[0]);
                                let _e1104 = (_e1087[1] - _e1093[1]);
                                let _e1105 = (_e1087[2] - _e1093[2]);
                                let _e1106 = (_e222.member == 0u);
                                let _e1110 = select((_e1103 - _e1099[0]), _e1087[0], _e1106);
                                let _e1111 = select((_e1104 - _e1099[1]), _e1087[1], _e1106);
                                let _e1112 = select((_e1105 - _e1099[2]), _e1087[2], _e1106);
                                let _e1113 = (_e1087[0] - _e1099[0]);
                                let _e1114 = (_e1087[1] - _e1099[1]);
                                let _e1115 = (_e1087[2] - _e1099[2]);
                                let _e1118 = local_2.member[0u];
                                let _e1124 = select(_e1118[0], -(_e1118[0]), (_e1118[0] < 0f));
                                let _e1127 = select(_e1118[1], -(_e1118[1]), (_e1118[1] < 0f));
                                let _e1129 = select(_e1127, _e1124, (_e1124 > _e1127));
                                let _e1132 = select(_e1118[2], -(_e1118[2]), (_e1118[2] < 0f));
                                let _e1134 = select(_e1132, _e1129, (_e1129 > _e1132));
                                let _e1137 = local_2.member[1u];
                                let _e1143 = select(_e1137[0], -(_e1137[0]), (_e1137[0] < 0f));
                                let _e1146 = select(_e1137[1], -(_e1137[1]), (_e1137[1] < 0f));
                                let _e1148 = select(_e1146, _e1143, (_e1143 > _e1146));
                                let _e1151 = select(_e1137[2], -(_e1137[2]), (_e1137[2] < 0f));
                                let _e1153 = select(_e1151, _e1148, (_e1148 > _e1151));
                                let _e1157 = local_2.member_3;
                                let _e1161 = local_2.member_1[0u];
                                let _e1167 = select(_e1161[0], -(_e1161[0]), (_e1161[0] < 0f));
                                let _e1170 = select(_e1161[1], -(_e1161[1]), (_e1161[1] < 0f));
                                let _e1172 = select(_e1170, _e1167, (_e1167 > _e1170));
                                let _e1175 = select(_e1161[2], -(_e1161[2]), (_e1161[2] < 0f));
                                let _e1177 = select(_e1175, _e1172, (_e1172 > _e1175));
                                let _e1180 = local_2.member_1[1u];
                                let _e1186 = select(_e1180[0], -(_e1180[0]), (_e1180[0] < 0f));
                                let _e1189 = select(_e1180[1], -(_e1180[1]), (_e1180[1] < 0f));
                                let _e1191 = select(_e1189, _e1186, (_e1186 > _e1189));
                                let _e1194 = select(_e1180[2], -(_e1180[2]), (_e1180[2] < 0f));
                                let _e1196 = select(_e1194, _e1191, (_e1191 > _e1194));
                                let _e1200 = local_2.member_3;
                                let _e1204 = local_2.member_2[0u];
                                let _e1210 = select(_e1204[0], -(_e1204[0]), (_e1204[0] < 0f));
                                let _e1213 = select(_e1204[1], -(_e1204[1]), (_e1204[1] < 0f));
                                let _e1215 = select(_e1213, _e1210, (_e1210 > _e1213));
                                let _e1218 = select(_e1204[2], -(_e1204[2]), (_e1204[2] < 0f));
                                let _e1220 = select(_e1218, _e1215, (_e1215 > _e1218));
                                let _e1223 = local_2.member_2[1u];
                                let _e1229 = select(_e1223[0], -(_e1223[0]), (_e1223[0] < 0f));
                                let _e1232 = select(_e1223[1], -(_e1223[1]), (_e1223[1] < 0f));
                                let _e1234 = select(_e1232, _e1229, (_e1229 > _e1232));
                                let _e1237 = select(_e1223[2], -(_e1223[2]), (_e1223[2] < 0f));
                                let _e1239 = select(_e1237, _e1234, (_e1234 > _e1237));
                                let _e1243 = local_2.member_3;
                                let _e1247 = ((((select(_e1153, _e1134, (_e1134 > _e1153)) + _e1157) + (select(_e1196, _e1177, (_e1177 > _e1196)) + _e1200)) + (select(_e1239, _e1220, (_e1220 > _e1239)) + _e1243)) * 2f);
                                let _e1250 = local_2.member_3;
                                let _e1254 = (((_e63.member_5 * 1.0001f) + (_e1250 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                let _e1257 = ((_e1050 * _e1029) - (_e1053 * _e1028));
                                let _e1260 = ((_e1053 * _e1027) - (_e1047 * _e1029));
                                let _e1263 = ((_e1047 * _e1028) - (_e1050 * _e1027));
                                let _e1268 = (((_e1257 * _e1056[0]) + (_e1260 * _e1056[1])) + (_e1263 * _e1056[2]));
                                let _e1273 = (((_e1257 * _e1072) + (_e1260 * _e1073)) + (_e1263 * _e1074));
                                let _e1278 = (((_e1257 * _e1082) + (_e1260 * _e1083)) + (_e1263 * _e1084));
                                let _e1283 = (((_e1257 * _e1079) + (_e1260 * _e1080)) + (_e1263 * _e1081));
                                let _e1288 = (((_e1257 * _e1087[0]) + (_e1260 * _e1087[1])) + (_e1263 * _e1087[2]));
                                let _e1293 = (((_e1257 * _e1103) + (_e1260 * _e1104)) + (_e1263 * _e1105));
                                let _e1298 = (((_e1257 * _e1113) + (_e1260 * _e1114)) + (_e1263 * _e1115));
                                let _e1303 = (((_e1257 * _e1110) + (_e1260 * _e1111)) + (_e1263 * _e1112));
                                let _e1305 = select(_e1273, _e1268, (_e1268 < _e1273));
                                let _e1307 = select(_e1283, _e1278, (_e1278 < _e1283));
                                let _e1309 = select(_e1307, _e1305, (_e1305 < _e1307));
                                let _e1311 = select(_e1293, _e1288, (_e1288 < _e1293));
                                let _e1313 = select(_e1303, _e1298, (_e1298 < _e1303));
                                let _e1315 = select(_e1313, _e1311, (_e1311 < _e1313));
                                let _e1317 = select(_e1315, _e1309, (_e1309 < _e1315));
                                let _e1319 = select(_e1273, _e1268, (_e1268 > _e1273));
                                let _e1321 = select(_e1283, _e1278, (_e1278 > _e1283));
                                let _e1323 = select(_e1321, _e1319, (_e1319 > _e1321));
                                let _e1325 = select(_e1293, _e1288, (_e1288 > _e1293));
                                let _e1327 = select(_e1303, _e1298, (_e1298 > _e1303));
                                let _e1329 = select(_e1327, _e1325, (_e1325 > _e1327));
                                let _e1342 = ((select(_e1257, -(_e1257), (_e1257 < 0f)) + select(_e1260, -(_e1260), (_e1260 < 0f))) + select(_e1263, -(_e1263), (_e1263 < 0f)));
                                let _e1347 = -(select(_e1329, _e1323, (_e1323 > _e1329)));
                                let _e1354 = (((select(_e1347, _e1317, (_e1317 > _e1347)) - ((_e1342 * _e1247) * (0.000000059604645f * (17f / 2f)))) - (_e1342 * _e1254)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                let _e1357 = ((_e1050 * _e1044) - (_e1053 * _e1043));
                                let _e1360 = ((_e1053 * _e1042) - (_e1047 * _e1044));
                                let _e1363 = ((_e1047 * _e1043) - (_e1050 * _e1042));
                                let _e1368 = (((_e1357 * _e1056[0]) + (_e1360 * _e1056[1])) + (_e1363 * _e1056[2]));
                                let _e1373 = (((_e1357 * _e1072) + (_e1360 * _e1073)) + (_e1363 * _e1074));
                                let _e1378 = (((_e1357 * _e1082) + (_e1360 * _e1083)) + (_e1363 * _e1084));
                                let _e1383 = (((_e1357 * _e1079) + (_e1360 * _e1080)) + (_e1363 * _e1081));
                                let _e1388 = (((_e1357 * _e1087[0]) + (_e1360 * _e1087[1])) + (_e1363 * _e1087[2]));
                                let _e1393 = (((_e1357 * _e1103) + (_e1360 * _e1104)) + (_e1363 * _e1105));
                                let _e1398 = (((_e1357 * _e1113) + (_e1360 * _e1114)) + (_e1363 * _e1115));
                                let _e1403 = (((_e1357 * _e1110) + (_e1360 * _e1111)) + (_e1363 * _e1112));
                                let _e1405 = select(_e1373, _e1368, (_e1368 < _e1373));
                                let _e1407 = select(_e1383, _e1378, (_e1378 < _e1383));
                                let _e1409 = select(_e1407, _e1405, (_e1405 < _e1407));
                                let _e1411 = select(_e1393, _e1388, (_e1388 < _e1393));
                                let _e1413 = select(_e1403, _e1398, (_e1398 < _e1403));
                                let _e1415 = select(_e1413, _e1411, (_e1411 < _e1413));
                                let _e1417 = select(_e1415, _e1409, (_e1409 < _e1415));
                                let _e1419 = select(_e1373, _e1368, (_e1368 > _e1373));
                                let _e1421 = select(_e1383, _e1378, (_e1378 > _e1383));
                                let _e1423 = select(_e1421, _e1419, (_e1419 > _e1421));
                                let _e1425 = select(_e1393, _e1388, (_e1388 > _e1393));
                                let _e1427 = select(_e1403, _e1398, (_e1398 > _e1403));
                                let _e1429 = select(_e1427, _e1425, (_e1425 > _e1427));
                                let _e1442 = ((select(_e1357, -(_e1357), (_e1357 < 0f)) + select(_e1360, -(_e1360), (_e1360 < 0f))) + select(_e1363, -(_e1363), (_e1363 < 0f)));
                                let _e1447 = -(select(_e1429, _e1423, (_e1423 > _e1429)));
                                let _e1454 = (((select(_e1447, _e1417, (_e1417 > _e1447)) - ((_e1442 * _e1247) * (0.000000059604645f * (17f / 2f)))) - (_e1442 * _e1254)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                let _e1456 = select(_e1454, _e1354, (_e1354 > _e1454));
                                if (_e222.member == 0u) {
                                    let _e1458 = (_e1042 - _e1027);
                                    let _e1459 = (_e1043 - _e1028);
                                    let _e1460 = (_e1044 - _e1029);
                                    let _e1463 = ((_e1050 * _e1460) - (_e1053 * _e1459));
                                    let _e1466 = ((_e1053 * _e1458) - (_e1047 * _e1460));
                                    let _e1469 = ((_e1047 * _e1459) - (_e1050 * _e1458));
                                    let _e1474 = (((_e1463 * _e1056[0]) + (_e1466 * _e1056[1])) + (_e1469 * _e1056[2]));
                                    let _e1479 = (((_e1463 * _e1072) + (_e1466 * _e1073)) + (_e1469 * _e1074));
                                    let _e1484 = (((_e1463 * _e1082) + (_e1466 * _e1083)) + (_e1469 * _e1084));
                                    let _e1489 = (((_e1463 * _e1079) + (_e1466 * _e1080)) + (_e1469 * _e1081));
                                    let _e1494 = (((_e1463 * _e1087[0]) + (_e1466 * _e1087[1])) + (_e1469 * _e1087[2]));
                                    let _e1499 = (((_e1463 * _e1103) + (_e1466 * _e1104)) + (_e1469 * _e1105));
                                    let _e1504 = (((_e1463 * _e1113) + (_e1466 * _e1114)) + (_e1469 * _e1115));
                                    let _e1509 = (((_e1463 * _e1110) + (_e1466 * _e1111)) + (_e1469 * _e1112));
                                    let _e1511 = select(_e1479, _e1474, (_e1474 < _e1479));
                                    let _e1513 = select(_e1489, _e1484, (_e1484 < _e1489));
                                    let _e1515 = select(_e1513, _e1511, (_e1511 < _e1513));
                                    let _e1517 = select(_e1499, _e1494, (_e1494 < _e1499));
                                    let _e1519 = select(_e1509, _e1504, (_e1504 < _e1509));
                                    let _e1521 = select(_e1519, _e1517, (_e1517 < _e1519));
                                    let _e1523 = select(_e1521, _e1515, (_e1515 < _e1521));
                                    let _e1525 = select(_e1479, _e1474, (_e1474 > _e1479));
                                    let _e1527 = select(_e1489, _e1484, (_e1484 > _e1489));
                                    let _e1529 = select(_e1527, _e1525, (_e1525 > _e1527));
                                    let _e1531 = select(_e1499, _e1494, (_e1494 > _e1499));
                                    let _e1533 = select(_e1509, _e1504, (_e1504 > _e1509));
                                    let _e1535 = select(_e1533, _e1531, (_e1531 > _e1533));
                                    let _e1548 = ((select(_e1463, -(_e1463), (_e1463 < 0f)) + select(_e1466, -(_e1466), (_e1466 < 0f))) + select(_e1469, -(_e1469), (_e1469 < 0f)));
                                    let _e1553 = -(select(_e1535, _e1529, (_e1529 > _e1535)));
                                    let _e1560 = (((select(_e1553, _e1523, (_e1523 > _e1553)) - ((_e1548 * _e1247) * (0.000000059604645f * (17f / 2f)))) - (_e1548 * _e1254)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    phi_2543_ = select(_e1560, _e1456, (_e1456 > _e1560));
                                } else {
                                    phi_2543_ = _e1456;
                                }
                                let _e1564 = phi_2543_;
                                phi_2546_ = (_e1014 || (_e1564 > 0f));
                            }
                            let _e1568 = phi_2546_;
                            if _e1568 {
                            } else {
                                let _e1570 = atomicAdd((&counters[0u]), 1u);
                                left[_e1570].member = _e188.member;
                                left[_e1570].member_1 = _e188.member_1;
                            }
                        }
                        phi_2557_ = true;
                    }
                    let _e1577 = phi_2557_;
                    phi_2558_ = _e1577;
                } else {
                    phi_2558_ = false;
                }
                let _e1579 = phi_2558_;
                continue;
                continuing {
                    phi_351_ = type_9(select(_e150.member, (_e150.member + 1u), _e153), select(_e150.member_1, _e150.member_1, _e153));
                    break if !(_e1579);
                }
            }
            workgroupBarrier();
            let _e1582 = atomicLoad((&counters[0u]));
            phi_2563_ = type_9(0u, 4u);
            loop {
                let _e1584 = phi_2563_;
                let _e1587 = (_e1584.member < _e1584.member_1);
                if (bitcast<i32>(select(0u, 1u, _e1587)) != 0i) {
                    let _e1602 = ((select(type_9().member_1, _e1584.member, _e1587) * 128u) + _e47);
                    if (_e1602 >= _e1582) {
                        phi_6178_ = false;
                    } else {
                        let _e1606 = left[_e1602].member;
                        let _e1608 = left[_e1602].member_1;
                        if (_e142 == 0u) {
                            let _e1628 = ((2u * _e63.member[1]) + (3u * _e1608));
                            let _e1630 = elements.member[_e1628];
                            let _e1633 = elements.member[(_e1628 + 1u)];
                            let _e1636 = elements.member[(_e1628 + 2u)];
                            phi_2694_ = type_19(0u, array<u32, 4>(_e1606, _e1630, _e1633, _e1636));
                        } else {
                            let _e1610 = (2u * _e1606);
                            let _e1612 = elements.member[_e1610];
                            let _e1615 = elements.member[(_e1610 + 1u)];
                            let _e1616 = (2u * _e1608);
                            let _e1618 = elements.member[_e1616];
                            let _e1621 = elements.member[(_e1616 + 1u)];
                            phi_2694_ = type_19(1u, array<u32, 4>(_e1612, _e1615, _e1618, _e1621));
                        }
                        let _e1640 = phi_2694_;
                        let _e1645 = paths.member[_e1640.member_1[0]];
                        let _e1660 = paths.member[_e1640.member_1[1]];
                        let _e1675 = paths.member[_e1640.member_1[2]];
                        let _e1690 = paths.member[_e1640.member_1[3]];
                        if (_e1640.member != 0u) {
                            phi_2827_ = type_24(array<array<f32, 3>, 2>(array<f32, 3>((_e1675.member.x - _e1645.member.x), (_e1675.member.y - _e1645.member.y), (_e1675.member.z - _e1645.member.z)), array<f32, 3>((_e1675.member_1.x - _e1645.member_1.x), (_e1675.member_1.y - _e1645.member_1.y), (_e1675.member_1.z - _e1645.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e1660.member.x - _e1645.member.x), (_e1660.member.y - _e1645.member.y), (_e1660.member.z - _e1645.member.z)), array<f32, 3>((_e1660.member_1.x - _e1645.member_1.x), (_e1660.member_1.y - _e1645.member_1.y), (_e1660.member_1.z - _e1645.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e1675.member.x - _e1690.member.x), (_e1675.member.y - _e1690.member.y), (_e1675.member.z - _e1690.member.z)), array<f32, 3>((_e1675.member_1.x - _e1690.member_1.x), (_e1675.member_1.y - _e1690.member_1.y), (_e1675.member_1.z - _e1690.member_1.z))), (_e63.member_4 + _e63.member_4));
                        } else {
                            phi_2827_ = type_24(array<array<f32, 3>, 2>(array<f32, 3>((_e1645.member.x - _e1660.member.x), (_e1645.member.y - _e1660.member.y), (_e1645.member.z - _e1660.member.z)), array<f32, 3>((_e1645.member_1.x - _e1660.member_1.x), (_e1645.member_1.y - _e1660.member_1.y), (_e1645.member_1.z - _e1660.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e1675.member.x - _e1660.member.x), (_e1675.member.y - _e1660.member.y), (_e1675.member.z - _e1660.member.z)), array<f32, 3>((_e1675.member_1.x - _e1660.member_1.x), (_e1675.member_1.y - _e1660.member_1.y), (_e1675.member_1.z - _e1660.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e1690.member.x - _e1660.member.x), (_e1690.member.y - _e1660.member.y), (_e1690.member.z - _e1660.member.z)), array<f32, 3>((_e1690.member_1.x - _e1660.member_1.x), (_e1690.member_1.y - _e1660.member_1.y), (_e1690.member_1.z - _e1660.member_1.z))), (_e63.member_4 + _e63.member_4));
                        }
                        let _e1763 = phi_2827_;
                        let _e1777 = ((_e1763.member[0][0] + _e1763.member[1][0]) * 0.5f);
                        let _e1778 = ((_e1763.member[0][1] + _e1763.member[1][1]) * 0.5f);
                        let _e1779 = ((_e1763.member[0][2] + _e1763.member[1][2]) * 0.5f);
                        let _e1793 = ((_e1763.member_1[0][0] + _e1763.member_1[1][0]) * 0.5f);
                        let _e1794 = ((_e1763.member_1[0][1] + _e1763.member_1[1][1]) * 0.5f);
                        let _e1795 = ((_e1763.member_1[0][2] + _e1763.member_1[1][2]) * 0.5f);
                        let _e1809 = ((_e1763.member_2[0][0] + _e1763.member_2[1][0]) * 0.5f);
                        let _e1810 = ((_e1763.member_2[0][1] + _e1763.member_2[1][1]) * 0.5f);
                        let _e1811 = ((_e1763.member_2[0][2] + _e1763.member_2[1][2]) * 0.5f);
                        local = type_24(array<array<f32, 3>, 2>(array<f32, 3>(_e1763.member[0][0], _e1763.member[0][1], _e1763.member[0][2]), array<f32, 3>(_e1777, _e1778, _e1779)), array<array<f32, 3>, 2>(array<f32, 3>(_e1763.member_1[0][0], _e1763.member_1[0][1], _e1763.member_1[0][2]), array<f32, 3>(_e1793, _e1794, _e1795)), array<array<f32, 3>, 2>(array<f32, 3>(_e1763.member_2[0][0], _e1763.member_2[0][1], _e1763.member_2[0][2]), array<f32, 3>(_e1809, _e1810, _e1811)), _e1763.member_3);
                        local_1 = type_24(array<array<f32, 3>, 2>(array<f32, 3>(_e1777, _e1778, _e1779), array<f32, 3>(_e1763.member[1][0], _e1763.member[1][1], _e1763.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e1793, _e1794, _e1795), array<f32, 3>(_e1763.member_1[1][0], _e1763.member_1[1][1], _e1763.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e1809, _e1810, _e1811), array<f32, 3>(_e1763.member_2[1][0], _e1763.member_2[1][1], _e1763.member_2[1][2])), _e1763.member_3);
                        let _e1866 = local.member_1[0u];
                        let _e1872 = local.member_2[0u];
                        let _e1878 = ((_e1866[1] * _e1872[2]) - (_e1866[2] * _e1872[1]));
                        let _e1881 = ((_e1866[2] * _e1872[0]) - (_e1866[0] * _e1872[2]));
                        let _e1884 = ((_e1866[0] * _e1872[1]) - (_e1866[1] * _e1872[0]));
                        let _e1887 = local.member_1[1u];
                        let _e1893 = local.member_2[1u];
                        let _e1899 = ((_e1887[1] * _e1893[2]) - (_e1887[2] * _e1893[1]));
                        let _e1902 = ((_e1887[2] * _e1893[0]) - (_e1887[0] * _e1893[2]));
                        let _e1905 = ((_e1887[0] * _e1893[1]) - (_e1887[1] * _e1893[0]));
                        let _e1908 = local.member_1[0u];
                        let _e1914 = local.member_2[1u];
                        let _e1929 = local.member_1[1u];
                        let _e1935 = local.member_2[0u];
                        let _e1948 = (((_e1908[1] * _e1914[2]) - (_e1908[2] * _e1914[1])) + ((_e1929[1] * _e1935[2]) - (_e1929[2] * _e1935[1])));
                        let _e1949 = (((_e1908[2] * _e1914[0]) - (_e1908[0] * _e1914[2])) + ((_e1929[2] * _e1935[0]) - (_e1929[0] * _e1935[2])));
                        let _e1950 = (((_e1908[0] * _e1914[1]) - (_e1908[1] * _e1914[0])) + ((_e1929[0] * _e1935[1]) - (_e1929[1] * _e1935[0])));
                        let _e1953 = local.member[0u];
                        let _e1964 = local.member[1u];
                        let _e1975 = local.member[0u];
                        let _e1984 = ((((_e1964[0] * _e1878) + (_e1964[1] * _e1881)) + (_e1964[2] * _e1884)) + (((_e1975[0] * _e1948) + (_e1975[1] * _e1949)) + (_e1975[2] * _e1950)));
                        let _e1987 = local.member[0u];
                        let _e1998 = local.member[1u];
                        let _e2007 = ((((_e1987[0] * _e1899) + (_e1987[1] * _e1902)) + (_e1987[2] * _e1905)) + (((_e1998[0] * _e1948) + (_e1998[1] * _e1949)) + (_e1998[2] * _e1950)));
                        let _e2010 = local.member[1u];
                        let _e2021 = local.member[0u];
                        let _e2027 = select(_e2021[0], -(_e2021[0]), (_e2021[0] < 0f));
                        let _e2030 = select(_e2021[1], -(_e2021[1]), (_e2021[1] < 0f));
                        let _e2032 = select(_e2030, _e2027, (_e2027 > _e2030));
                        let _e2035 = select(_e2021[2], -(_e2021[2]), (_e2021[2] < 0f));
                        let _e2037 = select(_e2035, _e2032, (_e2032 > _e2035));
                        let _e2040 = local.member[1u];
                        let _e2046 = select(_e2040[0], -(_e2040[0]), (_e2040[0] < 0f));
                        let _e2049 = select(_e2040[1], -(_e2040[1]), (_e2040[1] < 0f));
                        let _e2051 = select(_e2049, _e2046, (_e2046 > _e2049));
                        let _e2054 = select(_e2040[2], -(_e2040[2]), (_e2040[2] < 0f));
                        let _e2056 = select(_e2054, _e2051, (_e2051 > _e2054));
                        let _e2060 = local.member_3;
                        let _e2061 = (select(_e2056, _e2037, (_e2037 > _e2056)) + _e2060);
                        let _e2064 = local.member_1[0u];
                        let _e2070 = select(_e2064[0], -(_e2064[0]), (_e2064[0] < 0f));
                        let _e2073 = select(_e2064[1], -(_e2064[1]), (_e2064[1] < 0f));
                        let _e2075 = select(_e2073, _e2070, (_e2070 > _e2073));
                        let _e2078 = select(_e2064[2], -(_e2064[2]), (_e2064[2] < 0f));
                        let _e2080 = select(_e2078, _e2075, (_e2075 > _e2078));
                        let _e2083 = local.member_1[1u];
                        let _e2089 = select(_e2083[0], -(_e2083[0]), (_e2083[0] < 0f));
                        let _e2092 = select(_e2083[1], -(_e2083[1]), (_e2083[1] < 0f));
                        let _e2094 = select(_e2092, _e2089, (_e2089 > _e2092));
                        let _e2097 = select(_e2083[2], -(_e2083[2]), (_e2083[2] < 0f));
                        let _e2099 = select(_e2097, _e2094, (_e2094 > _e2097));
                        let _e2103 = local.member_3;
                        let _e2104 = (select(_e2099, _e2080, (_e2080 > _e2099)) + _e2103);
                        let _e2107 = local.member_2[0u];
                        let _e2113 = select(_e2107[0], -(_e2107[0]), (_e2107[0] < 0f));
                        let _e2116 = select(_e2107[1], -(_e2107[1]), (_e2107[1] < 0f));
                        let _e2118 = select(_e2116, _e2113, (_e2113 > _e2116));
                        let _e2121 = select(_e2107[2], -(_e2107[2]), (_e2107[2] < 0f));
                        let _e2123 = select(_e2121, _e2118, (_e2118 > _e2121));
                        let _e2126 = local.member_2[1u];
                        let _e2132 = select(_e2126[0], -(_e2126[0]), (_e2126[0] < 0f));
                        let _e2135 = select(_e2126[1], -(_e2126[1]), (_e2126[1] < 0f));
                        let _e2137 = select(_e2135, _e2132, (_e2132 > _e2135));
                        let _e2140 = select(_e2126[2], -(_e2126[2]), (_e2126[2] < 0f));
                        let _e2142 = select(_e2140, _e2137, (_e2137 > _e2140));
                        let _e2146 = local.member_3;
                        let _e2147 = (select(_e2142, _e2123, (_e2123 > _e2142)) + _e2146);
                        let _e2149 = ((_e2104 * 8f) * _e2147);
                        let _e2156 = local.member_3;
                        let _e2180 = ((select(_e1878, -(_e1878), (_e1878 < 0f)) + select(_e1881, -(_e1881), (_e1881 < 0f))) + select(_e1884, -(_e1884), (_e1884 < 0f)));
                        let _e2191 = ((select(_e1899, -(_e1899), (_e1899 < 0f)) + select(_e1902, -(_e1902), (_e1902 < 0f))) + select(_e1905, -(_e1905), (_e1905 < 0f)));
                        let _e2193 = select(_e2191, _e2180, (_e2180 > _e2191));
                        let _e2205 = (((select(_e1948, -(_e1948), (_e1948 < 0f)) + select(_e1949, -(_e1949), (_e1949 < 0f))) + select(_e1950, -(_e1950), (_e1950 < 0f))) * 0.5f);
                        let _e2212 = local.member_3;
                        let _e2225 = ((((_e1953[0] * _e1878) + (_e1953[1] * _e1881)) + (_e1953[2] * _e1884)) * 3f);
                        let _e2226 = ((((_e2010[0] * _e1899) + (_e2010[1] * _e1902)) + (_e2010[2] * _e1905)) * 3f);
                        let _e2228 = select(_e2226, _e2225, (_e2225 < _e2226));
                        let _e2230 = select(_e2007, _e1984, (_e1984 < _e2007));
                        let _e2232 = select(_e2230, _e2228, (_e2228 < _e2230));
                        let _e2234 = select(_e2226, _e2225, (_e2225 > _e2226));
                        let _e2236 = select(_e2007, _e1984, (_e1984 > _e2007));
                        let _e2243 = -(select(_e2236, _e2234, (_e2234 > _e2236)));
                        let _e2247 = ((select(_e2243, _e2232, (_e2232 > _e2243)) - ((((((_e2061 * 8f) * _e2149) * (0.000000059604645f * (524f / 64f))) + ((_e2156 * 19f) * ((_e2061 * (_e2104 + _e2147)) + (_e2104 * _e2147)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2061) * ((1f + _e2104) * (1f + _e2147))))) + ((_e63.member_5 * (((select(_e2205, _e2193, (_e2193 > _e2205)) + (_e2149 * (0.000000059604645f * 8f))) + ((_e2212 * 6f) * (_e2104 + _e2147))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2104) * (1f + _e2147))))) * (3f * 1.0001f)))) > 0f);
                        if _e2247 {
                            phi_4564_ = _e2247;
                        } else {
                            let _e2250 = local.member_1[0u];
                            let _e2256 = local.member_1[1u];
                            let _e2260 = (_e2250[0] + _e2256[0]);
                            let _e2261 = (_e2250[1] + _e2256[1]);
                            let _e2262 = (_e2250[2] + _e2256[2]);
                            let _e2265 = local.member_2[0u];
                            let _e2271 = local.member_2[1u];
                            let _e2275 = (_e2265[0] + _e2271[0]);
                            let _e2276 = (_e2265[1] + _e2271[1]);
                            let _e2277 = (_e2265[2] + _e2271[2]);
                            let _e2280 = ((_e2261 * _e2277) - (_e2262 * _e2276));
                            let _e2283 = ((_e2262 * _e2275) - (_e2260 * _e2277));
                            let _e2286 = ((_e2260 * _e2276) - (_e2261 * _e2275));
                            let _e2289 = local.member[0u];
                            let _e2295 = local.member_1[0u];
                            let _e2301 = local.member_2[0u];
                            let _e2305 = (_e2289[0] - _e2295[0]);
                            let _e2306 = (_e2289[1] - _e2295[1]);
                            let _e2307 = (_e2289[2] - _e2295[2]);
                            let _e2308 = (_e1640.member == 0u);
                            let _e2312 = select((_e2305 - _e2301[0]), _e2289[0], _e2308);
                            let _e2313 = select((_e2306 - _e2301[1]), _e2289[1], _e2308);
                            let _e2314 = select((_e2307 - _e2301[2]), _e2289[2], _e2308);
                            let _e2315 = (_e2289[0] - _e2301[0]);
                            let _e2316 = (_e2289[1] - _e2301[1]);
                            let _e2317 = (_e2289[2] - _e2301[2]);
                            let _e2320 = local.member[1u];
                            let _e2326 = local.member_1[1u];
                            let _e2332 = local.member_2[1u];
                            let _e2336 = (_e2320[0] - _e2326[0]);
                            let _e2337 = (_e2320[1] - _e2326[1]);
                            let _e2338 = (_e2320[2] - _e2326[2]);
                            let _e2339 = (_e1640.member == 0u);
                            let _e2343 = select((_e2336 - _e2332[0]), _e2320[0], _e2339);
                            let _e2344 = select((_e2337 - _e2332[1]), _e2320[1], _e2339);
                            let _e2345 = select((_e2338 - _e2332[2]), _e2320[2], _e2339);
                            let _e2346 = (_e2320[0] - _e2332[0]);
                            let _e2347 = (_e2320[1] - _e2332[1]);
                            let _e2348 = (_e2320[2] - _e2332[2]);
                            let _e2351 = local.member[0u];
                            let _e2357 = select(_e2351[0], -(_e2351[0]), (_e2351[0] < 0f));
                            let _e2360 = select(_e2351[1], -(_e2351[1]), (_e2351[1] < 0f));
                            let _e2362 = select(_e2360, _e2357, (_e2357 > _e2360));
                            let _e2365 = select(_e2351[2], -(_e2351[2]), (_e2351[2] < 0f));
                            let _e2367 = select(_e2365, _e2362, (_e2362 > _e2365));
                            let _e2370 = local.member[1u];
                            let _e2376 = select(_e2370[0], -(_e2370[0]), (_e2370[0] < 0f));
                            let _e2379 = select(_e2370[1], -(_e2370[1]), (_e2370[1] < 0f));
                            let _e2381 = select(_e2379, _e2376, (_e2376 > _e2379));
                            let _e2384 = select(_e2370[2], -(_e2370[2]), (_e2370[2] < 0f));
                            let _e2386 = select(_e2384, _e2381, (_e2381 > _e2384));
                            let _e2390 = local.member_3;
                            let _e2394 = local.member_1[0u];
                            let _e2400 = select(_e2394[0], -(_e2394[0]), (_e2394[0] < 0f));
                            let _e2403 = select(_e2394[1], -(_e2394[1]), (_e2394[1] < 0f));
                            let _e2405 = select(_e2403, _e2400, (_e2400 > _e2403));
                            let _e2408 = select(_e2394[2], -(_e2394[2]), (_e2394[2] < 0f));
                            let _e2410 = select(_e2408, _e2405, (_e2405 > _e2408));
                            let _e2413 = local.member_1[1u];
                            let _e2419 = select(_e2413[0], -(_e2413[0]), (_e2413[0] < 0f));
                            let _e2422 = select(_e2413[1], -(_e2413[1]), (_e2413[1] < 0f));
                            let _e2424 = select(_e2422, _e2419, (_e2419 > _e2422));
                            let _e2427 = select(_e2413[2], -(_e2413[2]), (_e2413[2] < 0f));
                            let _e2429 = select(_e2427, _e2424, (_e2424 > _e2427));
                            let _e2433 = local.member_3;
                            let _e2437 = local.member_2[0u];
                            let _e2443 = select(_e2437[0], -(_e2437[0]), (_e2437[0] < 0f));
                            let _e2446 = select(_e2437[1], -(_e2437[1]), (_e2437[1] < 0f));
                            let _e2448 = select(_e2446, _e2443, (_e2443 > _e2446));
                            let _e2451 = select(_e2437[2], -(_e2437[2]), (_e2437[2] < 0f));
                            let _e2453 = select(_e2451, _e2448, (_e2448 > _e2451));
                            let _e2456 = local.member_2[1u];
                            let _e2462 = select(_e2456[0], -(_e2456[0]), (_e2456[0] < 0f));
                            let _e2465 = select(_e2456[1], -(_e2456[1]), (_e2456[1] < 0f));
                            let _e2467 = select(_e2465, _e2462, (_e2462 > _e2465));
                            let _e2470 = select(_e2456[2], -(_e2456[2]), (_e2456[2] < 0f));
                            let _e2472 = select(_e2470, _e2467, (_e2467 > _e2470));
                            let _e2476 = local.member_3;
                            let _e2480 = ((((select(_e2386, _e2367, (_e2367 > _e2386)) + _e2390) + (select(_e2429, _e2410, (_e2410 > _e2429)) + _e2433)) + (select(_e2472, _e2453, (_e2453 > _e2472)) + _e2476)) * 2f);
                            let _e2483 = local.member_3;
                            let _e2487 = (((_e63.member_5 * 1.0001f) + (_e2483 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                            let _e2490 = ((_e2283 * _e2262) - (_e2286 * _e2261));
                            let _e2493 = ((_e2286 * _e2260) - (_e2280 * _e2262));
                            let _e2496 = ((_e2280 * _e2261) - (_e2283 * _e2260));
                            let _e2501 = (((_e2490 * _e2289[0]) + (_e2493 * _e2289[1])) + (_e2496 * _e2289[2]));
                            let _e2506 = (((_e2490 * _e2305) + (_e2493 * _e2306)) + (_e2496 * _e2307));
                            let _e2511 = (((_e2490 * _e2315) + (_e2493 * _e2316)) + (_e2496 * _e2317));
                            let _e2516 = (((_e2490 * _e2312) + (_e2493 * _e2313)) + (_e2496 * _e2314));
                            let _e2521 = (((_e2490 * _e2320[0]) + (_e2493 * _e2320[1])) + (_e2496 * _e2320[2]));
                            let _e2526 = (((_e2490 * _e2336) + (_e2493 * _e2337)) + (_e2496 * _e2338));
                            let _e2531 = (((_e2490 * _e2346) + (_e2493 * _e2347)) + (_e2496 * _e2348));
                            let _e2536 = (((_e2490 * _e2343) + (_e2493 * _e2344)) + (_e2496 * _e2345));
                            let _e2538 = select(_e2506, _e2501, (_e2501 < _e2506));
                            let _e2540 = select(_e2516, _e2511, (_e2511 < _e2516));
                            let _e2542 = select(_e2540, _e2538, (_e2538 < _e2540));
                            let _e2544 = select(_e2526, _e2521, (_e2521 < _e2526));
                            let _e2546 = select(_e2536, _e2531, (_e2531 < _e2536));
                            let _e2548 = select(_e2546, _e2544, (_e2544 < _e2546));
                            let _e2550 = select(_e2548, _e2542, (_e2542 < _e2548));
                            let _e2552 = select(_e2506, _e2501, (_e2501 > _e2506));
                            let _e2554 = select(_e2516, _e2511, (_e2511 > _e2516));
                            let _e2556 = select(_e2554, _e2552, (_e2552 > _e2554));
                            let _e2558 = select(_e2526, _e2521, (_e2521 > _e2526));
                            let _e2560 = select(_e2536, _e2531, (_e2531 > _e2536));
                            let _e2562 = select(_e2560, _e2558, (_e2558 > _e2560));
                            let _e2575 = ((select(_e2490, -(_e2490), (_e2490 < 0f)) + select(_e2493, -(_e2493), (_e2493 < 0f))) + select(_e2496, -(_e2496), (_e2496 < 0f)));
                            let _e2580 = -(select(_e2562, _e2556, (_e2556 > _e2562)));
                            let _e2587 = (((select(_e2580, _e2550, (_e2550 > _e2580)) - ((_e2575 * _e2480) * (0.000000059604645f * (17f / 2f)))) - (_e2575 * _e2487)) - (0.000000000000000000000000000000000000011754944f * 64f));
                            let _e2590 = ((_e2283 * _e2277) - (_e2286 * _e2276));
                            let _e2593 = ((_e2286 * _e2275) - (_e2280 * _e2277));
                            let _e2596 = ((_e2280 * _e2276) - (_e2283 * _e2275));
                            let _e2601 = (((_e2590 * _e2289[0]) + (_e2593 * _e2289[1])) + (_e2596 * _e2289[2]));
                            let _e2606 = (((_e2590 * _e2305) + (_e2593 * _e2306)) + (_e2596 * _e2307));
                            let _e2611 = (((_e2590 * _e2315) + (_e2593 * _e2316)) + (_e2596 * _e2317));
                            let _e2616 = (((_e2590 * _e2312) + (_e2593 * _e2313)) + (_e2596 * _e2314));
                            let _e2621 = (((_e2590 * _e2320[0]) + (_e2593 * _e2320[1])) + (_e2596 * _e2320[2]));
                            let _e2626 = (((_e2590 * _e2336) + (_e2593 * _e2337)) + (_e2596 * _e2338));
                            let _e2631 = (((_e2590 * _e2346) + (_e2593 * _e2347)) + (_e2596 * _e2348));
                            let _e2636 = (((_e2590 * _e2343) + (_e2593 * _e2344)) + (_e2596 * _e2345));
                            let _e2638 = select(_e2606, _e2601, (_e2601 < _e2606));
                            let _e2640 = select(_e2616, _e2611, (_e2611 < _e2616));
                            let _e2642 = select(_e2640, _e2638, (_e2638 < _e2640));
                            let _e2644 = select(_e2626, _e2621, (_e2621 < _e2626));
                            let _e2646 = select(_e2636, _e2631, (_e2631 < _e2636));
                            let _e2648 = select(_e2646, _e2644, (_e2644 < _e2646));
                            let _e2650 = select(_e2648, _e2642, (_e2642 < _e2648));
                            let _e2652 = select(_e2606, _e2601, (_e2601 > _e2606));
                            let _e2654 = select(_e2616, _e2611, (_e2611 > _e2616));
                            let _e2656 = select(_e2654, _e2652, (_e2652 > _e2654));
                            let _e2658 = select(_e2626, _e2621, (_e2621 > _e2626));
                            let _e2660 = select(_e2636, _e2631, (_e2631 > _e2636));
                            let _e2662 = select(_e2660, _e2658, (_e2658 > _e2660));
                            let _e2675 = ((select(_e2590, -(_e2590), (_e2590 < 0f)) + select(_e2593, -(_e2593), (_e2593 < 0f))) + select(_e2596, -(_e2596), (_e2596 < 0f)));
                            let _e2680 = -(select(_e2662, _e2656, (_e2656 > _e2662)));
                            let _e2687 = (((select(_e2680, _e2650, (_e2650 > _e2680)) - ((_e2675 * _e2480) * (0.000000059604645f * (17f / 2f)))) - (_e2675 * _e2487)) - (0.000000000000000000000000000000000000011754944f * 64f));
                            let _e2689 = select(_e2687, _e2587, (_e2587 > _e2687));
                            if (_e1640.member == 0u) {
                                let _e2691 = (_e2275 - _e2260);
                                let _e2692 = (_e2276 - _e2261);
                                let _e2693 = (_e2277 - _e2262);
                                let _e2696 = ((_e2283 * _e2693) - (_e2286 * _e2692));
                                let _e2699 = ((_e2286 * _e2691) - (_e2280 * _e2693));
                                let _e2702 = ((_e2280 * _e2692) - (_e2283 * _e2691));
                                let _e2707 = (((_e2696 * _e2289[0]) + (_e2699 * _e2289[1])) + (_e2702 * _e2289[2]));
                                let _e2712 = (((_e2696 * _e2305) + (_e2699 * _e2306)) + (_e2702 * _e2307));
                                let _e2717 = (((_e2696 * _e2315) + (_e2699 * _e2316)) + (_e2702 * _e2317));
                                let _e2722 = (((_e2696 * _e2312) + (_e2699 * _e2313)) + (_e2702 * _e2314));
                                let _e2727 = (((_e2696 * _e2320[0]) + (_e2699 * _e2320[1])) + (_e2702 * _e2320[2]));
                                let _e2732 = (((_e2696 * _e2336) + (_e2699 * _e2337)) + (_e2702 * _e2338));
                                let _e2737 = (((_e2696 * _e2346) + (_e2699 * _e2347)) + (_e2702 * _e2348));
                                let _e2742 = (((_e2696 * _e2343) + (_e2699 * _e2344)) + (_e2702 * _e2345));
                                let _e2744 = select(_e2712, _e2707, (_e2707 < _e2712));
                                let _e2746 = select(_e2722, _e2717, (_e2717 < _e2722));
                                let _e2748 = select(_e2746, _e2744, (_e2744 < _e2746));
                                let _e2750 = select(_e2732, _e2727, (_e2727 < _e2732));
                                let _e2752 = select(_e2742, _e2737, (_e2737 < _e2742));
                                let _e2754 = select(_e2752, _e2750, (_e2750 < _e2752));
                                let _e2756 = select(_e2754, _e2748, (_e2748 < _e2754));
                                let _e2758 = select(_e2712, _e2707, (_e2707 > _e2712));
                                let _e2760 = select(_e2722, _e2717, (_e2717 > _e2722));
                                let _e2762 = select(_e2760, _e2758, (_e2758 > _e2760));
                                let _e2764 = select(_e2732, _e2727, (_e2727 > _e2732));
                                let _e2766 = select(_e2742, _e2737, (_e2737 > _e2742));
                                let _e2768 = select(_e2766, _e2764, (_e2764 > _e2766));
                                let _e2781 = ((select(_e2696, -(_e2696), (_e2696 < 0f)) + select(_e2699, -(_e2699), (_e2699 < 0f))) + select(_e2702, -(_e2702), (_e2702 < 0f)));
                                let _e2786 = -(select(_e2768, _e2762, (_e2762 > _e2768)));
                                let _e2793 = (((select(_e2786, _e2756, (_e2756 > _e2786)) - ((_e2781 * _e2480) * (0.000000059604645f * (17f / 2f)))) - (_e2781 * _e2487)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                phi_4561_ = select(_e2793, _e2689, (_e2689 > _e2793));
                            } else {
                                phi_4561_ = _e2689;
                            }
                            let _e2797 = phi_4561_;
                            phi_4564_ = (_e2247 || (_e2797 > 0f));
                        }
                        let _e2801 = phi_4564_;
                        if _e2801 {
                            let _e2804 = local_1.member_1[0u];
                            let _e2810 = local_1.member_2[0u];
                            let _e2816 = ((_e2804[1] * _e2810[2]) - (_e2804[2] * _e2810[1]));
                            let _e2819 = ((_e2804[2] * _e2810[0]) - (_e2804[0] * _e2810[2]));
                            let _e2822 = ((_e2804[0] * _e2810[1]) - (_e2804[1] * _e2810[0]));
                            let _e2825 = local_1.member_1[1u];
                            let _e2831 = local_1.member_2[1u];
                            let _e2837 = ((_e2825[1] * _e2831[2]) - (_e2825[2] * _e2831[1]));
                            let _e2840 = ((_e2825[2] * _e2831[0]) - (_e2825[0] * _e2831[2]));
                            let _e2843 = ((_e2825[0] * _e2831[1]) - (_e2825[1] * _e2831[0]));
                            let _e2846 = local_1.member_1[0u];
                            let _e2852 = local_1.member_2[1u];
                            let _e2867 = local_1.member_1[1u];
                            let _e2873 = local_1.member_2[0u];
                            let _e2886 = (((_e2846[1] * _e2852[2]) - (_e2846[2] * _e2852[1])) + ((_e2867[1] * _e2873[2]) - (_e2867[2] * _e2873[1])));
                            let _e2887 = (((_e2846[2] * _e2852[0]) - (_e2846[0] * _e2852[2])) + ((_e2867[2] * _e2873[0]) - (_e2867[0] * _e2873[2])));
                            let _e2888 = (((_e2846[0] * _e2852[1]) - (_e2846[1] * _e2852[0])) + ((_e2867[0] * _e2873[1]) - (_e2867[1] * _e2873[0])));
                            let _e2891 = local_1.member[0u];
                            let _e2902 = local_1.member[1u];
                            let _e2913 = local_1.member[0u];
                            let _e2922 = ((((_e2902[0] * _e2816) + (_e2902[1] * _e2819)) + (_e2902[2] * _e2822)) + (((_e2913[0] * _e2886) + (_e2913[1] * _e2887)) + (_e2913[2] * _e2888)));
                            let _e2925 = local_1.member[0u];
                            let _e2936 = local_1.member[1u];
                            let _e2945 = ((((_e2925[0] * _e2837) + (_e2925[1] * _e2840)) + (_e2925[2] * _e2843)) + (((_e2936[0] * _e2886) + (_e2936[1] * _e2887)) + (_e2936[2] * _e2888)));
                            let _e2948 = local_1.member[1u];
                            let _e2959 = local_1.member[0u];
                            let _e2965 = select(_e2959[0], -(_e2959[0]), (_e2959[0] < 0f));
                            let _e2968 = select(_e2959[1], -(_e2959[1]), (_e2959[1] < 0f));
                            let _e2970 = select(_e2968, _e2965, (_e2965 > _e2968));
                            let _e2973 = select(_e2959[2], -(_e2959[2]), (_e2959[2] < 0f));
                            let _e2975 = select(_e2973, _e2970, (_e2970 > _e2973));
                            let _e2978 = local_1.member[1u];
                            let _e2984 = select(_e2978[0], -(_e2978[0]), (_e2978[0] < 0f));
                            let _e2987 = select(_e2978[1], -(_e2978[1]), (_e2978[1] < 0f));
                            let _e2989 = select(_e2987, _e2984, (_e2984 > _e2987));
                            let _e2992 = select(_e2978[2], -(_e2978[2]), (_e2978[2] < 0f));
                            let _e2994 = select(_e2992, _e2989, (_e2989 > _e2992));
                            let _e2998 = local_1.member_3;
                            let _e2999 = (select(_e2994, _e2975, (_e2975 > _e2994)) + _e2998);
                            let _e3002 = local_1.member_1[0u];
                            let _e3008 = select(_e3002[0], -(_e3002[0]), (_e3002[0] < 0f));
                            let _e3011 = select(_e3002[1], -(_e3002[1]), (_e3002[1] < 0f));
                            let _e3013 = select(_e3011, _e3008, (_e3008 > _e3011));
                            let _e3016 = select(_e3002[2], -(_e3002[2]), (_e3002[2] < 0f));
                            let _e3018 = select(_e3016, _e3013, (_e3013 > _e3016));
                            let _e3021 = local_1.member_1[1u];
                            let _e3027 = select(_e3021[0], -(_e3021[0]), (_e3021[0] < 0f));
                            let _e3030 = select(_e3021[1], -(_e3021[1]), (_e3021[1] < 0f));
                            let _e3032 = select(_e3030, _e3027, (_e3027 > _e3030));
                            let _e3035 = select(_e3021[2], -(_e3021[2]), (_e3021[2] < 0f));
                            let _e3037 = select(_e3035, _e3032, (_e3032 > _e3035));
                            let _e3041 = local_1.member_3;
                            let _e3042 = (select(_e3037, _e3018, (_e3018 > _e3037)) + _e3041);
                            let _e3045 = local_1.member_2[0u];
                            let _e3051 = select(_e3045[0], -(_e3045[0]), (_e3045[0] < 0f));
                            let _e3054 = select(_e3045[1], -(_e3045[1]), (_e3045[1] < 0f));
                            let _e3056 = select(_e3054, _e3051, (_e3051 > _e3054));
                            let _e3059 = select(_e3045[2], -(_e3045[2]), (_e3045[2] < 0f));
                            let _e3061 = select(_e3059, _e3056, (_e3056 > _e3059));
                            let _e3064 = local_1.member_2[1u];
                            let _e3070 = select(_e3064[0], -(_e3064[0]), (_e3064[0] < 0f));
                            let _e3073 = select(_e3064[1], -(_e3064[1]), (_e3064[1] < 0f));
                            let _e3075 = select(_e3073, _e3070, (_e3070 > _e3073));
                            let _e3078 = select(_e3064[2], -(_e3064[2]), (_e3064[2] < 0f));
                            let _e3080 = select(_e3078, _e3075, (_e3075 > _e3078));
                            let _e3084 = local_1.member_3;
                            let _e3085 = (select(_e3080, _e3061, (_e3061 > _e3080)) + _e3084);
                            let _e3087 = ((_e3042 * 8f) * _e3085);
                            let _e3094 = local_1.member_3;
                            let _e3118 = ((select(_e2816, -(_e2816), (_e2816 < 0f)) + select(_e2819, -(_e2819), (_e2819 < 0f))) + select(_e2822, -(_e2822), (_e2822 < 0f)));
                            let _e3129 = ((select(_e2837, -(_e2837), (_e2837 < 0f)) + select(_e2840, -(_e2840), (_e2840 < 0f))) + select(_e2843, -(_e2843), (_e2843 < 0f)));
                            let _e3131 = select(_e3129, _e3118, (_e3118 > _e3129));
                            let _e3143 = (((select(_e2886, -(_e2886), (_e2886 < 0f)) + select(_e2887, -(_e2887), (_e2887 < 0f))) + select(_e2888, -(_e2888), (_e2888 < 0f))) * 0.5f);
                            let _e3150 = local_1.member_3;
                            let _e3163 = ((((_e2891[0] * _e2816) + (_e2891[1] * _e2819)) + (_e2891[2] * _e2822)) * 3f);
                            let _e3164 = ((((_e2948[0] * _e2837) + (_e2948[1] * _e2840)) + (_e2948[2] * _e2843)) * 3f);
                            let _e3166 = select(_e3164, _e3163, (_e3163 < _e3164));
                            let _e3168 = select(_e2945, _e2922, (_e2922 < _e2945));
                            let _e3170 = select(_e3168, _e3166, (_e3166 < _e3168));
                            let _e3172 = select(_e3164, _e3163, (_e3163 > _e3164));
                            let _e3174 = select(_e2945, _e2922, (_e2922 > _e2945));
                            let _e3181 = -(select(_e3174, _e3172, (_e3172 > _e3174)));
                            let _e3185 = ((select(_e3181, _e3170, (_e3170 > _e3181)) - ((((((_e2999 * 8f) * _e3087) * (0.000000059604645f * (524f / 64f))) + ((_e3094 * 19f) * ((_e2999 * (_e3042 + _e3085)) + (_e3042 * _e3085)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2999) * ((1f + _e3042) * (1f + _e3085))))) + ((_e63.member_5 * (((select(_e3143, _e3131, (_e3131 > _e3143)) + (_e3087 * (0.000000059604645f * 8f))) + ((_e3150 * 6f) * (_e3042 + _e3085))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3042) * (1f + _e3085))))) * (3f * 1.0001f)))) > 0f);
                            if _e3185 {
                                phi_6167_ = _e3185;
                            } else {
                                let _e3188 = local_1.member_1[0u];
                                let _e3194 = local_1.member_1[1u];
                                let _e3198 = (_e3188[0] + _e3194[0]);
                                let _e3199 = (_e3188[1] + _e3194[1]);
                                let _e3200 = (_e3188[2] + _e3194[2]);
                                let _e3203 = local_1.member_2[0u];
                                let _e3209 = local_1.member_2[1u];
                                let _e3213 = (_e3203[0] + _e3209[0]);
                                let _e3214 = (_e3203[1] + _e3209[1]);
                                let _e3215 = (_e3203[2] + _e3209[2]);
                                let _e3218 = ((_e3199 * _e3215) - (_e3200 * _e3214));
                                let _e3221 = ((_e3200 * _e3213) - (_e3198 * _e3215));
                                let _e3224 = ((_e3198 * _e3214) - (_e3199 * _e3213));
                                let _e3227 = local_1.member[0u];
                                let _e3233 = local_1.member_1[0u];
                                let _e3239 = local_1.member_2[0u];
                                let _e3243 = (_e3227[0] - _e3233[0]);
                                let _e3244 = (_e3227[1] - _e3233[1]);
                                let _e3245 = (_e3227[2] - _e3233[2]);
                                let _e3246 = (_e1640.member == 0u);
                                let _e3250 = select((_e3243 - _e3239[0]), _e3227[0], _e3246);
                                let _e3251 = select((_e3244 - _e3239[1]), _e3227[1], _e3246);
                                let _e3252 = select((_e3245 - _e3239[2]), _e3227[2], _e3246);
                                let _e3253 = (_e3227[0] - _e3239[0]);
                                let _e3254 = (_e3227[1] - _e3239[1]);
                                let _e3255 = (_e3227[2] - _e3239[2]);
                                let _e3258 = local_1.member[1u];
                                let _e3264 = local_1.member_1[1u];
                                let _e3270 = local_1.member_2[1u];
                                let _e3274 = (_e3258[0] - _e3264[0]);
                                let _e3275 = (_e3258[1] - _e3264[1]);
                                let _e3276 = (_e3258[2] - _e3264[2]);
                                let _e3277 = (_e1640.member == 0u);
                                let _e3281 = select((_e3274 - _e3270[0]), _e3258[0], _e3277);
                                let _e3282 = select((_e3275 - _e3270[1]), _e3258[1], _e3277);
                                let _e3283 = select((_e3276 - _e3270[2]), _e3258[2], _e3277);
                                let _e3284 = (_e3258[0] - _e3270[0]);
                                let _e3285 = (_e3258[1] - _e3270[1]);
                                let _e3286 = (_e3258[2] - _e3270[2]);
                                let _e3289 = local_1.member[0u];
                                let _e3295 = select(_e3289[0], -(_e3289[0]), (_e3289[0] < 0f));
                                let _e3298 = select(_e3289[1], -(_e3289[1]), (_e3289[1] < 0f));
                                let _e3300 = select(_e3298, _e3295, (_e3295 > _e3298));
                                let _e3303 = select(_e3289[2], -(_e3289[2]), (_e3289[2] < 0f));
                                let _e3305 = select(_e3303, _e3300, (_e3300 > _e3303));
                                let _e3308 = local_1.member[1u];
                                let _e3314 = select(_e3308[0], -(_e3308[0]), (_e3308[0] < 0f));
                                let _e3317 = select(_e3308[1], -(_e3308[1]), (_e3308[1] < 0f));
                                let _e3319 = select(_e3317, _e3314, (_e3314 > _e3317));
                                let _e3322 = select(_e3308[2], -(_e3308[2]), (_e3308[2] < 0f));
                                let _e3324 = select(_e3322, _e3319, (_e3319 > _e3322));
                                let _e3328 = local_1.member_3;
                                let _e3332 = local_1.member_1[0u];
                                let _e3338 = select(_e3332[0], -(_e3332[0]), (_e3332[0] < 0f));
                                let _e3341 = select(_e3332[1], -(_e3332[1]), (_e3332[1] < 0f));
                                let _e3343 = select(_e3341, _e3338, (_e3338 > _e3341));
                                let _e3346 = select(_e3332[2], -(_e3332[2]), (_e3332[2] < 0f));
                                let _e3348 = select(_e3346, _e3343, (_e3343 > _e3346));
                                let _e3351 = local_1.member_1[1u];
                                let _e3357 = select(_e3351[0], -(_e3351[0]), (_e3351[0] < 0f));
                                let _e3360 = select(_e3351[1], -(_e3351[1]), (_e3351[1] < 0f));
                                let _e3362 = select(_e3360, _e3357, (_e3357 > _e3360));
                                let _e3365 = select(_e3351[2], -(_e3351[2]), (_e3351[2] < 0f));
                                let _e3367 = select(_e3365, _e3362, (_e3362 > _e3365));
                                let _e3371 = local_1.member_3;
                                let _e3375 = local_1.member_2[0u];
                                let _e3381 = select(_e3375[0], -(_e3375[0]), (_e3375[0] < 0f));
                                let _e3384 = select(_e3375[1], -(_e3375[1]), (_e3375[1] < 0f));
                                let _e3386 = select(_e3384, _e3381, (_e3381 > _e3384));
                                let _e3389 = select(_e3375[2], -(_e3375[2]), (_e3375[2] < 0f));
                                let _e3391 = select(_e3389, _e3386, (_e3386 > _e3389));
                                let _e3394 = local_1.member_2[1u];
                                let _e3400 = select(_e3394[0], -(_e3394[0]), (_e3394[0] < 0f));
                                let _e3403 = select(_e3394[1], -(_e3394[1]), (_e3394[1] < 0f));
                                let _e3405 = select(_e3403, _e3400, (_e3400 > _e3403));
                                let _e3408 = select(_e3394[2], -(_e3394[2]), (_e3394[2] < 0f));
                                let _e3410 = select(_e3408, _e3405, (_e3405 > _e3408));
                                let _e3414 = local_1.member_3;
                                let _e3418 = ((((select(_e3324, _e3305, (_e3305 > _e3324)) + _e3328) + (select(_e3367, _e3348, (_e3348 > _e3367)) + _e3371)) + (select(_e3410, _e3391, (_e3391 > _e3410)) + _e3414)) * 2f);
                                let _e3421 = local_1.member_3;
                                let _e3425 = (((_e63.member_5 * 1.0001f) + (_e3421 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                let _e3428 = ((_e3221 * _e3200) - (_e3224 * _e3199));
                                let _e3431 = ((_e3224 * _e3198) - (_e3218 * _e3200));
                                let _e3434 = ((_e3218 * _e3199) - (_e3221 * _e3198));
                                let _e3439 = (((_e3428 * _e3227[0]) + (_e3431 * _e3227[1])) + (_e3434 * _e3227[2]));
                                let _e3444 = (((_e3428 * _e3243) + (_e3431 * _e3244)) + (_e3434 * _e3245));
                                let _e3449 = (((_e3428 * _e3253) + (_e3431 * _e3254)) + (_e3434 * _e3255));
                                let _e3454 = (((_e3428 * _e3250) + (_e3431 * _e3251)) + (_e3434 * _e3252));
                                let _e3459 = (((_e3428 * _e3258[0]) + (_e3431 * _e3258[1])) + (_e3434 * _e3258[2]));
                                let _e3464 = (((_e3428 * _e3274) + (_e3431 * _e3275)) + (_e3434 * _e3276));
                                let _e3469 = (((_e3428 * _e3284) + (_e3431 * _e3285)) + (_e3434 * _e3286));
                                let _e3474 = (((_e3428 * _e3281) + (_e3431 * _e3282)) + (_e3434 * _e3283));
                                let _e3476 = select(_e3444, _e3439, (_e3439 < _e3444));
                                let _e3478 = select(_e3454, _e3449, (_e3449 < _e3454));
                                let _e3480 = select(_e3478, _e3476, (_e3476 < _e3478));
                                let _e3482 = select(_e3464, _e3459, (_e3459 < _e3464));
                                let _e3484 = select(_e3474, _e3469, (_e3469 < _e3474));
                                let _e3486 = select(_e3484, _e3482, (_e3482 < _e3484));
                                let _e3488 = select(_e3486, _e3480, (_e3480 < _e3486));
                                let _e3490 = select(_e3444, _e3439, (_e3439 > _e3444));
                                let _e3492 = select(_e3454, _e3449, (_e3449 > _e3454));
                                let _e3494 = select(_e3492, _e3490, (_e3490 > _e3492));
                                let _e3496 = select(_e3464, _e3459, (_e3459 > _e3464));
                                let _e3498 = select(_e3474, _e3469, (_e3469 > _e3474));
                                let _e3500 = select(_e3498, _e3496, (_e3496 > _e3498));
                                let _e3513 = ((select(_e3428, -(_e3428), (_e3428 < 0f)) + select(_e3431, -(_e3431), (_e3431 < 0f))) + select(_e3434, -(_e3434), (_e3434 < 0f)));
                                let _e3518 = -(select(_e3500, _e3494, (_e3494 > _e3500)));
                                let _e3525 = (((select(_e3518, _e3488, (_e3488 > _e3518)) - ((_e3513 * _e3418) * (0.000000059604645f * (17f / 2f)))) - (_e3513 * _e3425)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                let _e3528 = ((_e3221 * _e3215) - (_e3224 * _e3214));
                                let _e3531 = ((_e3224 * _e3213) - (_e3218 * _e3215));
                                let _e3534 = ((_e3218 * _e3214) - (_e3221 * _e3213));
                                let _e3539 = (((_e3528 * _e3227[0]) + (_e3531 * _e3227[1])) + (_e3534 * _e3227[2]));
                                let _e3544 = (((_e3528 * _e3243) + (_e3531 * _e3244)) + (_e3534 * _e3245));
                                let _e3549 = (((_e3528 * _e3253) + (_e3531 * _e3254)) + (_e3534 * _e3255));
                                let _e3554 = (((_e3528 * _e3250) + (_e3531 * _e3251)) + (_e3534 * _e3252));
                                let _e3559 = (((_e3528 * _e3258[0]) + (_e3531 * _e3258[1])) + (_e3534 * _e3258[2]));
                                let _e3564 = (((_e3528 * _e3274) + (_e3531 * _e3275)) + (_e3534 * _e3276));
                                let _e3569 = (((_e3528 * _e3284) + (_e3531 * _e3285)) + (_e3534 * _e3286));
                                let _e3574 = (((_e3528 * _e3281) + (_e3531 * _e3282)) + (_e3534 * _e3283));
                                let _e3576 = select(_e3544, _e3539, (_e3539 < _e3544));
                                let _e3578 = select(_e3554, _e3549, (_e3549 < _e3554));
                                let _e3580 = select(_e3578, _e3576, (_e3576 < _e3578));
                                let _e3582 = select(_e3564, _e3559, (_e3559 < _e3564));
                                let _e3584 = select(_e3574, _e3569, (_e3569 < _e3574));
                                let _e3586 = select(_e3584, _e3582, (_e3582 < _e3584));
                                let _e3588 = select(_e3586, _e3580, (_e3580 < _e3586));
                                let _e3590 = select(_e3544, _e3539, (_e3539 > _e3544));
                                let _e3592 = select(_e3554, _e3549, (_e3549 > _e3554));
                                let _e3594 = select(_e3592, _e3590, (_e3590 > _e3592));
                                let _e3596 = select(_e3564, _e3559, (_e3559 > _e3564));
                                let _e3598 = select(_e3574, _e3569, (_e3569 > _e3574));
                                let _e3600 = select(_e3598, _e3596, (_e3596 > _e3598));
                                let _e3613 = ((select(_e3528, -(_e3528), (_e3528 < 0f)) + select(_e3531, -(_e3531), (_e3531 < 0f))) + select(_e3534, -(_e3534), (_e3534 < 0f)));
                                let _e3618 = -(select(_e3600, _e3594, (_e3594 > _e3600)));
                                let _e3625 = (((select(_e3618, _e3588, (_e3588 > _e3618)) - ((_e3613 * _e3418) * (0.000000059604645f * (17f / 2f)))) - (_e3613 * _e3425)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                let _e3627 = select(_e3625, _e3525, (_e3525 > _e3625));
                                if (_e1640.member == 0u) {
                                    let _e3629 = (_e3213 - _e3198);
                                    let _e3630 = (_e3214 - _e3199);
                                    let _e3631 = (_e3215 - _e3200);
                                    let _e3634 = ((_e3221 * _e3631) - (_e3224 * _e3630));
                                    let _e3637 = ((_e3224 * _e3629) - (_e3218 * _e3631));
                                    let _e3640 = ((_e3218 * _e3630) - (_e3221 * _e3629));
                                    let _e3645 = (((_e3634 * _e3227[0]) + (_e3637 * _e3227[1])) + (_e3640 * _e3227[2]));
                                    let _e3650 = (((_e3634 * _e3243) + (_e3637 * _e3244)) + (_e3640 * _e3245));
                                    let _e3655 = (((_e3634 * _e3253) + (_e3637 * _e3254)) + (_e3640 * _e3255));
                                    let _e3660 = (((_e3634 * _e3250) + (_e3637 * _e3251)) + (_e3640 * _e3252));
                                    let _e3665 = (((_e3634 * _e3258[0]) + (_e3637 * _e3258[1])) + (_e3640 * _e3258[2]));
                                    let _e3670 = (((_e3634 * _e3274) + (_e3637 * _e3275)) + (_e3640 * _e3276));
                                    let _e3675 = (((_e3634 * _e3284) + (_e3637 * _e3285)) + (_e3640 * _e3286));
                                    let _e3680 = (((_e3634 * _e3281) + (_e3637 * _e3282)) + (_e3640 * _e3283));
                                    let _e3682 = select(_e3650, _e3645, (_e3645 < _e3650));
                                    let _e3684 = select(_e3660, _e3655, (_e3655 < _e3660));
                                    let _e3686 = select(_e3684, _e3682, (_e3682 < _e3684));
                                    let _e3688 = select(_e3670, _e3665, (_e3665 < _e3670));
                                    let _e3690 = select(_e3680, _e3675, (_e3675 < _e3680));
                                    let _e3692 = select(_e3690, _e3688, (_e3688 < _e3690));
                                    let _e3694 = select(_e3692, _e3686, (_e3686 < _e3692));
                                    let _e3696 = select(_e3650, _e3645, (_e3645 > _e3650));
                                    let _e3698 = select(_e3660, _e3655, (_e3655 > _e3660));
                                    let _e3700 = select(_e3698, _e3696, (_e3696 > _e3698));
                                    let _e3702 = select(_e3670, _e3665, (_e3665 > _e3670));
                                    let _e3704 = select(_e3680, _e3675, (_e3675 > _e3680));
                                    let _e3706 = select(_e3704, _e3702, (_e3702 > _e3704));
                                    let _e3719 = ((select(_e3634, -(_e3634), (_e3634 < 0f)) + select(_e3637, -(_e3637), (_e3637 < 0f))) + select(_e3640, -(_e3640), (_e3640 < 0f)));
                                    let _e3724 = -(select(_e3706, _e3700, (_e3700 > _e3706)));
                                    let _e3731 = (((select(_e3724, _e3694, (_e3694 > _e3724)) - ((_e3719 * _e3418) * (0.000000059604645f * (17f / 2f)))) - (_e3719 * _e3425)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    phi_6164_ = select(_e3731, _e3627, (_e3627 > _e3731));
                                } else {
                                    phi_6164_ = _e3627;
                                }
                                let _e3735 = phi_6164_;
                                phi_6167_ = (_e3185 || (_e3735 > 0f));
                            }
                            let _e3739 = phi_6167_;
                            phi_6169_ = (_e2801 && _e3739);
                        } else {
                            phi_6169_ = _e2801;
                        }
                        let _e3742 = phi_6169_;
                        if _e3742 {
                        } else {
                            let _e3744 = atomicAdd((&counters[1u]), 1u);
                            kept[_e3744].member = _e1606;
                            kept[_e3744].member_1 = _e1608;
                        }
                        phi_6178_ = true;
                    }
                    let _e3749 = phi_6178_;
                    phi_6179_ = _e3749;
                } else {
                    phi_6179_ = false;
                }
                let _e3751 = phi_6179_;
                continue;
                continuing {
                    phi_2563_ = type_9(select(_e1584.member, (_e1584.member + 1u), _e1587), select(_e1584.member_1, _e1584.member_1, _e1587));
                    break if !(_e3751);
                }
            }
            workgroupBarrier();
            let _e3754 = atomicLoad((&counters[1u]));
            if (_e47 == 0u) {
                if (_e3754 > 0u) {
                    let _e3758 = atomicAdd((&output.member[0u]), _e3754);
                    if ((_e3758 + _e3754) < _e3758) {
                        let _e3762 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[2u]), _e3758);
                    if _e141 {
                        let _e3765 = atomicAdd((&output.member[1u]), _e3754);
                        if ((_e3765 + _e3754) < _e3765) {
                            let _e3769 = atomicAdd((&output.member[3u]), 1u);
                        }
                    }
                }
            }
            workgroupBarrier();
            let _e3771 = atomicLoad((&counters[2u]));
            phi_6222_ = type_9(0u, 4u);
            loop {
                let _e3773 = phi_6222_;
                let _e3776 = (_e3773.member < _e3773.member_1);
                if (bitcast<i32>(select(0u, 1u, _e3776)) != 0i) {
                    let _e3791 = ((select(type_9().member_1, _e3773.member, _e3776) * 128u) + _e47);
                    if (_e3791 >= _e3754) {
                        phi_6281_ = false;
                    } else {
                        let _e3795 = kept[_e3791].member;
                        let _e3797 = kept[_e3791].member_1;
                        let _e3802 = params.member.member_1.member_3;
                        let _e3803 = (_e3771 + _e3791);
                        if (_e3803 < _e3802) {
                            let _e3805 = (2u * _e3803);
                            atomicStore((&output.member[(4u + _e3805)]), _e3795);
                            atomicStore((&output.member[(_e3805 + 5u)]), (_e3797 | (_e142 << bitcast<u32>(31i))));
                        }
                        phi_6281_ = true;
                    }
                    let _e3811 = phi_6281_;
                    phi_6282_ = _e3811;
                } else {
                    phi_6282_ = false;
                }
                let _e3813 = phi_6282_;
                continue;
                continuing {
                    phi_6222_ = type_9(select(_e3773.member, (_e3773.member + 1u), _e3776), select(_e3773.member_1, _e3773.member_1, _e3776));
                    break if !(_e3813);
                }
            }
            workgroupBarrier();
        }
        continue;
        continuing {
            phi_292_ = type_9(select(_e119.member, (_e119.member + 1u), _e122), select(_e119.member_1, _e119.member_1, _e122));
            break if !(_e135);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn filter_pairs(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_2(id, n, lane);
}

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
    var phi_248_: u32;
    var phi_293_: u32;
    var phi_296_: type_9;
    var phi_355_: type_9;
    var phi_445_: type_9;
    var phi_536_: type_19;
    var phi_658_: type_25;
    var phi_705_: type_25;
    var phi_778_: bool;
    var phi_912_: type_24;
    var phi_2547_: f32;
    var phi_2550_: bool;
    var phi_2561_: bool;
    var phi_2562_: bool;
    var phi_2567_: type_9;
    var phi_2698_: type_19;
    var phi_2831_: type_24;
    var phi_5443_: f32;
    var phi_5446_: bool;
    var phi_8286_: f32;
    var phi_8289_: bool;
    var phi_8292_: bool;
    var phi_8301_: bool;
    var phi_8302_: bool;
    var phi_8345_: type_9;
    var phi_8404_: bool;
    var phi_8405_: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e49 = id_2;
    let _e50 = n_2;
    let _e51 = lane_2;
    let _e62 = ((_e49.y * _e50.x) + _e49.x);
    let _e65 = (_e50.x * _e50.y);
    let _e67 = params.member.member;
    let _e75 = params.member.member_1.member_2;
    let _e77 = vf.member[0u];
    let _e79 = select(_e77, _e75, (_e75 < _e77));
    let _e82 = params.member.member_2.member;
    let _e84 = ee.member[0u];
    let _e86 = select(_e84, _e82, (_e82 < _e84));
    let _e87 = (_e79 / 512u);
    let _e91 = select(_e87, (_e87 + 1u), ((_e79 % 512u) > 0u));
    let _e92 = (_e86 / 512u);
    let _e97 = (_e91 + select(_e92, (_e92 + 1u), ((_e86 % 512u) > 0u)));
    let _e99 = params.member.member_1.member_1;
    if (_e97 > _e99) {
        let _e102 = params.member.member_1.member_1;
        phi_248_ = (_e97 - _e102);
    } else {
        phi_248_ = 0u;
    }
    let _e105 = phi_248_;
    let _e107 = params.member.member_1.member;
    let _e109 = select(_e105, _e107, (_e107 < _e105));
    if (_e109 > _e62) {
        let _e111 = (_e109 - _e62);
        if (_e65 == 0u) {
            return;
        }
        let _e113 = (_e111 / _e65);
        if (_e65 == 0u) {
            return;
        }
        phi_293_ = select(_e113, (_e113 + 1u), ((_e111 % _e65) > 0u));
    } else {
        phi_293_ = 0u;
    }
    let _e120 = phi_293_;
    phi_296_ = type_9(0u, _e120);
    loop {
        let _e123 = phi_296_;
        let _e126 = (_e123.member < _e123.member_1);
        let _e139 = (bitcast<i32>(select(0u, 1u, _e126)) != 0i);
        if _e139 {
            let _e141 = params.member.member_1.member_1;
            let _e144 = ((_e141 + _e62) + (select(type_9().member_1, _e123.member, _e126) * _e65));
            let _e145 = (_e144 >= _e91);
            let _e146 = select(0u, 1u, _e145);
            if (_e51 <= 1u) {
                atomicStore((&counters[_e51]), 0u);
            }
            workgroupBarrier();
            phi_355_ = type_9(0u, 4u);
            loop {
                let _e154 = phi_355_;
                let _e157 = (_e154.member < _e154.member_1);
                if (bitcast<i32>(select(0u, 1u, _e157)) != 0i) {
                    let _e173 = (((512u * select(_e144, (_e144 - _e91), _e145)) + (select(type_9().member_1, _e154.member, _e157) * 128u)) + _e51);
                    if (_e173 >= select(_e79, _e86, _e145)) {
                        phi_2561_ = false;
                    } else {
                        if _e145 {
                            let _e183 = (2u * _e173);
                            let _e186 = ee.member[(4u + _e183)];
                            let _e189 = ee.member[(_e183 + 5u)];
                            phi_445_ = type_9(_e186, _e189);
                        } else {
                            let _e175 = (2u * _e173);
                            let _e178 = vf.member[(4u + _e175)];
                            let _e181 = vf.member[(_e175 + 5u)];
                            phi_445_ = type_9(_e178, _e181);
                        }
                        let _e192 = phi_445_;
                        if (_e146 == 0u) {
                            let _e214 = ((2u * _e67.member[1]) + (3u * _e192.member_1));
                            let _e216 = elements.member[_e214];
                            let _e219 = elements.member[(_e214 + 1u)];
                            let _e222 = elements.member[(_e214 + 2u)];
                            phi_536_ = type_19(0u, array<u32, 4>(_e192.member, _e216, _e219, _e222));
                        } else {
                            let _e196 = (2u * _e192.member);
                            let _e198 = elements.member[_e196];
                            let _e201 = elements.member[(_e196 + 1u)];
                            let _e202 = (2u * _e192.member_1);
                            let _e204 = elements.member[_e202];
                            let _e207 = elements.member[(_e202 + 1u)];
                            phi_536_ = type_19(1u, array<u32, 4>(_e198, _e201, _e204, _e207));
                        }
                        let _e226 = phi_536_;
                        if ((_e67.member_1 & 512u) != 0u) {
                            phi_778_ = true;
                        } else {
                            let _e231 = paths.member[_e226.member_1[0]];
                            let _e246 = paths.member[_e226.member_1[1]];
                            let _e261 = paths.member[_e226.member_1[2]];
                            let _e276 = paths.member[_e226.member_1[3]];
                            let _e289 = array<f32, 3>(_e231.member.x, _e231.member.y, _e231.member.z);
                            let _e290 = array<f32, 3>(_e231.member_1.x, _e231.member_1.y, _e231.member_1.z);
                            if (_e226.member != 0u) {
                                let _e315 = function_(_e231.member.x, _e246.member.x);
                                let _e316 = function_(_e231.member.y, _e246.member.y);
                                let _e317 = function_(_e231.member.z, _e246.member.z);
                                let _e319 = function_1(_e231.member.x, _e246.member.x);
                                let _e320 = function_1(_e231.member.y, _e246.member.y);
                                let _e321 = function_1(_e231.member.z, _e246.member.z);
                                let _e324 = function_(_e261.member.x, _e276.member.x);
                                let _e325 = function_(_e261.member.y, _e276.member.y);
                                let _e326 = function_(_e261.member.z, _e276.member.z);
                                let _e328 = function_1(_e261.member.x, _e276.member.x);
                                let _e329 = function_1(_e261.member.y, _e276.member.y);
                                let _e330 = function_1(_e261.member.z, _e276.member.z);
                                phi_658_ = type_25(array<array<f32, 3>, 2>(array<f32, 3>(_e315, _e316, _e317), array<f32, 3>(_e319, _e320, _e321)), array<array<f32, 3>, 2>(array<f32, 3>(_e324, _e325, _e326), array<f32, 3>(_e328, _e329, _e330)));
                            } else {
                                let _e292 = function_(_e246.member.x, _e261.member.x);
                                let _e293 = function_(_e246.member.y, _e261.member.y);
                                let _e294 = function_(_e246.member.z, _e261.member.z);
                                let _e295 = function_1(_e246.member.x, _e261.member.x);
                                let _e296 = function_1(_e246.member.y, _e261.member.y);
                                let _e297 = function_1(_e246.member.z, _e261.member.z);
                                let _e299 = function_(_e292, _e276.member.x);
                                let _e300 = function_(_e293, _e276.member.y);
                                let _e301 = function_(_e294, _e276.member.z);
                                let _e303 = function_1(_e292, _e276.member.x);
                                let _e304 = function_1(_e293, _e276.member.y);
                                let _e305 = function_1(_e294, _e276.member.z);
                                let _e306 = function_(_e295, _e276.member.x);
                                let _e307 = function_(_e296, _e276.member.y);
                                let _e308 = function_(_e297, _e276.member.z);
                                let _e309 = function_1(_e295, _e276.member.x);
                                let _e310 = function_1(_e296, _e276.member.y);
                                let _e311 = function_1(_e297, _e276.member.z);
                                phi_658_ = type_25(array<array<f32, 3>, 2>(_e289, _e289), array<array<f32, 3>, 2>(array<f32, 3>(_e299, _e300, _e301), array<f32, 3>(_e309, _e310, _e311)));
                            }
                            let _e335 = phi_658_;
                            if (_e226.member != 0u) {
                                let _e360 = function_(_e231.member_1.x, _e246.member_1.x);
                                let _e361 = function_(_e231.member_1.y, _e246.member_1.y);
                                let _e362 = function_(_e231.member_1.z, _e246.member_1.z);
                                let _e364 = function_1(_e231.member_1.x, _e246.member_1.x);
                                let _e365 = function_1(_e231.member_1.y, _e246.member_1.y);
                                let _e366 = function_1(_e231.member_1.z, _e246.member_1.z);
                                let _e369 = function_(_e261.member_1.x, _e276.member_1.x);
                                let _e370 = function_(_e261.member_1.y, _e276.member_1.y);
                                let _e371 = function_(_e261.member_1.z, _e276.member_1.z);
                                let _e373 = function_1(_e261.member_1.x, _e276.member_1.x);
                                let _e374 = function_1(_e261.member_1.y, _e276.member_1.y);
                                let _e375 = function_1(_e261.member_1.z, _e276.member_1.z);
                                phi_705_ = type_25(array<array<f32, 3>, 2>(array<f32, 3>(_e360, _e361, _e362), array<f32, 3>(_e364, _e365, _e366)), array<array<f32, 3>, 2>(array<f32, 3>(_e369, _e370, _e371), array<f32, 3>(_e373, _e374, _e375)));
                            } else {
                                let _e337 = function_(_e246.member_1.x, _e261.member_1.x);
                                let _e338 = function_(_e246.member_1.y, _e261.member_1.y);
                                let _e339 = function_(_e246.member_1.z, _e261.member_1.z);
                                let _e340 = function_1(_e246.member_1.x, _e261.member_1.x);
                                let _e341 = function_1(_e246.member_1.y, _e261.member_1.y);
                                let _e342 = function_1(_e246.member_1.z, _e261.member_1.z);
                                let _e344 = function_(_e337, _e276.member_1.x);
                                let _e345 = function_(_e338, _e276.member_1.y);
                                let _e346 = function_(_e339, _e276.member_1.z);
                                let _e348 = function_1(_e337, _e276.member_1.x);
                                let _e349 = function_1(_e338, _e276.member_1.y);
                                let _e350 = function_1(_e339, _e276.member_1.z);
                                let _e351 = function_(_e340, _e276.member_1.x);
                                let _e352 = function_(_e341, _e276.member_1.y);
                                let _e353 = function_(_e342, _e276.member_1.z);
                                let _e354 = function_1(_e340, _e276.member_1.x);
                                let _e355 = function_1(_e341, _e276.member_1.y);
                                let _e356 = function_1(_e342, _e276.member_1.z);
                                phi_705_ = type_25(array<array<f32, 3>, 2>(_e290, _e290), array<array<f32, 3>, 2>(array<f32, 3>(_e344, _e345, _e346), array<f32, 3>(_e354, _e355, _e356)));
                            }
                            let _e380 = phi_705_;
                            let _e389 = (((_e67.member_5 + (2f * _e67.member_4)) * 1.0001f) + (8f * 0.000000000000000000000000000000000000011754944f));
                            phi_778_ = !(((((((_e335.member[0][0] - _e335.member_1[1][0]) > _e389) && ((_e380.member[0][0] - _e380.member_1[1][0]) > _e389)) || (((_e335.member_1[0][0] - _e335.member[1][0]) > _e389) && ((_e380.member_1[0][0] - _e380.member[1][0]) > _e389))) || ((((_e335.member[0][1] - _e335.member_1[1][1]) > _e389) && ((_e380.member[0][1] - _e380.member_1[1][1]) > _e389)) || (((_e335.member_1[0][1] - _e335.member[1][1]) > _e389) && ((_e380.member_1[0][1] - _e380.member[1][1]) > _e389)))) || ((((_e335.member[0][2] - _e335.member_1[1][2]) > _e389) && ((_e380.member[0][2] - _e380.member_1[1][2]) > _e389)) || (((_e335.member_1[0][2] - _e335.member[1][2]) > _e389) && ((_e380.member_1[0][2] - _e380.member[1][2]) > _e389)))));
                        }
                        let _e475 = phi_778_;
                        if _e475 {
                            let _e478 = paths.member[_e226.member_1[0]];
                            let _e493 = paths.member[_e226.member_1[1]];
                            let _e508 = paths.member[_e226.member_1[2]];
                            let _e523 = paths.member[_e226.member_1[3]];
                            if (_e226.member != 0u) {
                                phi_912_ = type_24(array<array<f32, 3>, 2>(array<f32, 3>((_e508.member.x - _e478.member.x), (_e508.member.y - _e478.member.y), (_e508.member.z - _e478.member.z)), array<f32, 3>((_e508.member_1.x - _e478.member_1.x), (_e508.member_1.y - _e478.member_1.y), (_e508.member_1.z - _e478.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e493.member.x - _e478.member.x), (_e493.member.y - _e478.member.y), (_e493.member.z - _e478.member.z)), array<f32, 3>((_e493.member_1.x - _e478.member_1.x), (_e493.member_1.y - _e478.member_1.y), (_e493.member_1.z - _e478.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e508.member.x - _e523.member.x), (_e508.member.y - _e523.member.y), (_e508.member.z - _e523.member.z)), array<f32, 3>((_e508.member_1.x - _e523.member_1.x), (_e508.member_1.y - _e523.member_1.y), (_e508.member_1.z - _e523.member_1.z))), (_e67.member_4 + _e67.member_4));
                            } else {
                                phi_912_ = type_24(array<array<f32, 3>, 2>(array<f32, 3>((_e478.member.x - _e493.member.x), (_e478.member.y - _e493.member.y), (_e478.member.z - _e493.member.z)), array<f32, 3>((_e478.member_1.x - _e493.member_1.x), (_e478.member_1.y - _e493.member_1.y), (_e478.member_1.z - _e493.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e508.member.x - _e493.member.x), (_e508.member.y - _e493.member.y), (_e508.member.z - _e493.member.z)), array<f32, 3>((_e508.member_1.x - _e493.member_1.x), (_e508.member_1.y - _e493.member_1.y), (_e508.member_1.z - _e493.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e523.member.x - _e493.member.x), (_e523.member.y - _e493.member.y), (_e523.member.z - _e493.member.z)), array<f32, 3>((_e523.member_1.x - _e493.member_1.x), (_e523.member_1.y - _e493.member_1.y), (_e523.member_1.z - _e493.member_1.z))), (_e67.member_4 + _e67.member_4));
                            }
                            let _e596 = phi_912_;
                            local_2 = type_24(array<array<f32, 3>, 2>(array<f32, 3>(_e596.member[0][0], _e596.member[0][1], _e596.member[0][2]), array<f32, 3>(_e596.member[1][0], _e596.member[1][1], _e596.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e596.member_1[0][0], _e596.member_1[0][1], _e596.member_1[0][2]), array<f32, 3>(_e596.member_1[1][0], _e596.member_1[1][1], _e596.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e596.member_2[0][0], _e596.member_2[0][1], _e596.member_2[0][2]), array<f32, 3>(_e596.member_2[1][0], _e596.member_2[1][1], _e596.member_2[1][2])), _e596.member_3);
                            let _e637 = local_2.member_1[0u];
                            let _e643 = local_2.member_2[0u];
                            let _e649 = ((_e637[1] * _e643[2]) - (_e637[2] * _e643[1]));
                            let _e652 = ((_e637[2] * _e643[0]) - (_e637[0] * _e643[2]));
                            let _e655 = ((_e637[0] * _e643[1]) - (_e637[1] * _e643[0]));
                            let _e658 = local_2.member_1[1u];
                            let _e664 = local_2.member_2[1u];
                            let _e670 = ((_e658[1] * _e664[2]) - (_e658[2] * _e664[1]));
                            let _e673 = ((_e658[2] * _e664[0]) - (_e658[0] * _e664[2]));
                            let _e676 = ((_e658[0] * _e664[1]) - (_e658[1] * _e664[0]));
                            let _e679 = local_2.member_1[0u];
                            let _e685 = local_2.member_2[1u];
                            let _e700 = local_2.member_1[1u];
                            let _e706 = local_2.member_2[0u];
                            let _e719 = (((_e679[1] * _e685[2]) - (_e679[2] * _e685[1])) + ((_e700[1] * _e706[2]) - (_e700[2] * _e706[1])));
                            let _e720 = (((_e679[2] * _e685[0]) - (_e679[0] * _e685[2])) + ((_e700[2] * _e706[0]) - (_e700[0] * _e706[2])));
                            let _e721 = (((_e679[0] * _e685[1]) - (_e679[1] * _e685[0])) + ((_e700[0] * _e706[1]) - (_e700[1] * _e706[0])));
                            let _e724 = local_2.member[0u];
                            let _e735 = local_2.member[1u];
                            let _e746 = local_2.member[0u];
                            let _e755 = ((((_e735[0] * _e649) + (_e735[1] * _e652)) + (_e735[2] * _e655)) + (((_e746[0] * _e719) + (_e746[1] * _e720)) + (_e746[2] * _e721)));
                            let _e758 = local_2.member[0u];
                            let _e769 = local_2.member[1u];
                            let _e778 = ((((_e758[0] * _e670) + (_e758[1] * _e673)) + (_e758[2] * _e676)) + (((_e769[0] * _e719) + (_e769[1] * _e720)) + (_e769[2] * _e721)));
                            let _e781 = local_2.member[1u];
                            let _e792 = local_2.member[0u];
                            let _e798 = select(_e792[0], -(_e792[0]), (_e792[0] < 0f));
                            let _e801 = select(_e792[1], -(_e792[1]), (_e792[1] < 0f));
                            let _e803 = select(_e801, _e798, (_e798 > _e801));
                            let _e806 = select(_e792[2], -(_e792[2]), (_e792[2] < 0f));
                            let _e808 = select(_e806, _e803, (_e803 > _e806));
                            let _e811 = local_2.member[1u];
                            let _e817 = select(_e811[0], -(_e811[0]), (_e811[0] < 0f));
                            let _e820 = select(_e811[1], -(_e811[1]), (_e811[1] < 0f));
                            let _e822 = select(_e820, _e817, (_e817 > _e820));
                            let _e825 = select(_e811[2], -(_e811[2]), (_e811[2] < 0f));
                            let _e827 = select(_e825, _e822, (_e822 > _e825));
                            let _e831 = local_2.member_3;
                            let _e832 = (select(_e827, _e808, (_e808 > _e827)) + _e831);
                            let _e835 = local_2.member_1[0u];
                            let _e841 = select(_e835[0], -(_e835[0]), (_e835[0] < 0f));
                            let _e844 = select(_e835[1], -(_e835[1]), (_e835[1] < 0f));
                            let _e846 = select(_e844, _e841, (_e841 > _e844));
                            let _e849 = select(_e835[2], -(_e835[2]), (_e835[2] < 0f));
                            let _e851 = select(_e849, _e846, (_e846 > _e849));
                            let _e854 = local_2.member_1[1u];
                            let _e860 = select(_e854[0], -(_e854[0]), (_e854[0] < 0f));
                            let _e863 = select(_e854[1], -(_e854[1]), (_e854[1] < 0f));
                            let _e865 = select(_e863, _e860, (_e860 > _e863));
                            let _e868 = select(_e854[2], -(_e854[2]), (_e854[2] < 0f));
                            let _e870 = select(_e868, _e865, (_e865 > _e868));
                            let _e874 = local_2.member_3;
                            let _e875 = (select(_e870, _e851, (_e851 > _e870)) + _e874);
                            let _e878 = local_2.member_2[0u];
                            let _e884 = select(_e878[0], -(_e878[0]), (_e878[0] < 0f));
                            let _e887 = select(_e878[1], -(_e878[1]), (_e878[1] < 0f));
                            let _e889 = select(_e887, _e884, (_e884 > _e887));
                            let _e892 = select(_e878[2], -(_e878[2]), (_e878[2] < 0f));
                            let _e894 = select(_e892, _e889, (_e889 > _e892));
                            let _e897 = local_2.member_2[1u];
                            let _e903 = select(_e897[0], -(_e897[0]), (_e897[0] < 0f));
                            let _e906 = select(_e897[1], -(_e897[1]), (_e897[1] < 0f));
                            let _e908 = select(_e906, _e903, (_e903 > _e906));
                            let _e911 = select(_e897[2], -(_e897[2]), (_e897[2] < 0f));
                            let _e913 = select(_e911, _e908, (_e908 > _e911));
                            let _e917 = local_2.member_3;
                            let _e918 = (select(_e913, _e894, (_e894 > _e913)) + _e917);
                            let _e920 = ((_e875 * 8f) * _e918);
                            let _e927 = local_2.member_3;
                            let _e951 = ((select(_e649, -(_e649), (_e649 < 0f)) + select(_e652, -(_e652), (_e652 < 0f))) + select(_e655, -(_e655), (_e655 < 0f)));
                            let _e962 = ((select(_e670, -(_e670), (_e670 < 0f)) + select(_e673, -(_e673), (_e673 < 0f))) + select(_e676, -(_e676), (_e676 < 0f)));
                            let _e964 = select(_e962, _e951, (_e951 > _e962));
                            let _e976 = (((select(_e719, -(_e719), (_e719 < 0f)) + select(_e720, -(_e720), (_e720 < 0f))) + select(_e721, -(_e721), (_e721 < 0f))) * 0.5f);
                            let _e983 = local_2.member_3;
                            let _e996 = ((((_e724[0] * _e649) + (_e724[1] * _e652)) + (_e724[2] * _e655)) * 3f);
                            let _e997 = ((((_e781[0] * _e670) + (_e781[1] * _e673)) + (_e781[2] * _e676)) * 3f);
                            let _e999 = select(_e997, _e996, (_e996 < _e997));
                            let _e1001 = select(_e778, _e755, (_e755 < _e778));
                            let _e1003 = select(_e1001, _e999, (_e999 < _e1001));
                            let _e1005 = select(_e997, _e996, (_e996 > _e997));
                            let _e1007 = select(_e778, _e755, (_e755 > _e778));
                            let _e1010 = -(select(_e1007, _e1005, (_e1005 > _e1007)));
                            let _e1018 = ((select(_e1010, _e1003, (_e1003 > _e1010)) - ((((((_e832 * 8f) * _e920) * (0.000000059604645f * (524f / 64f))) + ((_e927 * 19f) * ((_e832 * (_e875 + _e918)) + (_e875 * _e918)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e832) * ((1f + _e875) * (1f + _e918))))) + ((_e67.member_5 * (((select(_e976, _e964, (_e964 > _e976)) + (_e920 * (0.000000059604645f * 8f))) + ((_e983 * 6f) * (_e875 + _e918))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e875) * (1f + _e918))))) * (3f * 1.0001f)))) > 0f);
                            if _e1018 {
                                phi_2550_ = _e1018;
                            } else {
                                let _e1021 = local_2.member_1[0u];
                                let _e1027 = local_2.member_1[1u];
                                let _e1031 = (_e1021[0] + _e1027[0]);
                                let _e1032 = (_e1021[1] + _e1027[1]);
                                let _e1033 = (_e1021[2] + _e1027[2]);
                                let _e1036 = local_2.member_2[0u];
                                let _e1042 = local_2.member_2[1u];
                                let _e1046 = (_e1036[0] + _e1042[0]);
                                let _e1047 = (_e1036[1] + _e1042[1]);
                                let _e1048 = (_e1036[2] + _e1042[2]);
                                let _e1051 = ((_e1032 * _e1048) - (_e1033 * _e1047));
                                let _e1054 = ((_e1033 * _e1046) - (_e1031 * _e1048));
                                let _e1057 = ((_e1031 * _e1047) - (_e1032 * _e1046));
                                let _e1060 = local_2.member[0u];
                                let _e1066 = local_2.member_1[0u];
                                let _e1072 = local_2.member_2[0u];
                                let _e1076 = (_e1060[0] - _e1066[0]);
                                let _e1077 = (_e1060[1] - _e1066[1]);
                                let _e1078 = (_e1060[2] - _e1066[2]);
                                let _e1079 = (_e226.member == 0u);
                                let _e1083 = select((_e1076 - _e1072[0]), _e1060[0], _e1079);
                                let _e1084 = select((_e1077 - _e1072[1]), _e1060[1], _e1079);
                                let _e1085 = select((_e1078 - _e1072[2]), _e1060[2], _e1079);
                                let _e1086 = (_e1060[0] - _e1072[0]);
                                let _e1087 = (_e1060[1] - _e1072[1]);
                                let _e1088 = (_e1060[2] - _e1072[2]);
                                let _e1091 = local_2.member[1u];
                                let _e1097 = local_2.member_1[1u];
                                let _e1103 = local_2.member_2[1u];
                                let _e1107 = (_e1091[0] - _e1097[0]);
                                let _e1108 = (_e1091[1] - _e1097[1]);
                                let _e1109 = (_e1091[2] - _e1097[2]);
                                let _e1110 = (_e226.member == 0u);
                                let _e1114 = select((_e1107 - _e1103[0]), _e1091[0], _e1110);
                                let _e1115 = select((_e1108 - _e1103[1]), _e1091[1], _e1110);
                                let _e1116 = select((_e1109 - _e1103[2]), _e1091[2], _e1110);
                                let _e1117 = (_e1091[0] - _e1103[0]);
                                let _e1118 = (_e1091[1] - _e1103[1]);
                                let _e1119 = (_e1091[2] - _e1103[2]);
                                let _e1122 = local_2.member[0u];
                                let _e1128 = select(_e1122[0], -(_e1122[0]), (_e1122[0] < 0f));
                                let _e1131 = select(_e1122[1], -(_e1122[1]), (_e1122[1] < 0f));
                                let _e1133 = select(_e1131, _e1128, (_e1128 > _e1131));
                                let _e1136 = select(_e1122[2], -(_e1122[2]), (_e1122[2] < 0f));
                                let _e1138 = select(_e1136, _e1133, (_e1133 > _e1136));
                                let _e1141 = local_2.member[1u];
                                let _e1147 = select(_e1141[0], -(_e1141[0]), (_e1141[0] < 0f));
                                let _e1150 = select(_e1141[1], -(_e1141[1]), (_e1141[1] < 0f));
                                let _e1152 = select(_e1150, _e1147, (_e1147 > _e1150));
                                let _e1155 = select(_e1141[2], -(_e1141[2]), (_e1141[2] < 0f));
                                let _e1157 = select(_e1155, _e1152, (_e1152 > _e1155));
                                let _e1161 = local_2.member_3;
                                let _e1165 = local_2.member_1[0u];
                                let _e1171 = select(_e1165[0], -(_e1165[0]), (_e1165[0] < 0f));
                                let _e1174 = select(_e1165[1], -(_e1165[1]), (_e1165[1] < 0f));
                                let _e1176 = select(_e1174, _e1171, (_e1171 > _e1174));
                                let _e1179 = select(_e1165[2], -(_e1165[2]), (_e1165[2] < 0f));
                                let _e1181 = select(_e1179, _e1176, (_e1176 > _e1179));
                                let _e1184 = local_2.member_1[1u];
                                let _e1190 = select(_e1184[0], -(_e1184[0]), (_e1184[0] < 0f));
                                let _e1193 = select(_e1184[1], -(_e1184[1]), (_e1184[1] < 0f));
                                let _e1195 = select(_e1193, _e1190, (_e1190 > _e1193));
                                let _e1198 = select(_e1184[2], -(_e1184[2]), (_e1184[2] < 0f));
                                let _e1200 = select(_e1198, _e1195, (_e1195 > _e1198));
                                let _e1204 = local_2.member_3;
                                let _e1208 = local_2.member_2[0u];
                                let _e1214 = select(_e1208[0], -(_e1208[0]), (_e1208[0] < 0f));
                                let _e1217 = select(_e1208[1], -(_e1208[1]), (_e1208[1] < 0f));
                                let _e1219 = select(_e1217, _e1214, (_e1214 > _e1217));
                                let _e1222 = select(_e1208[2], -(_e1208[2]), (_e1208[2] < 0f));
                                let _e1224 = select(_e1222, _e1219, (_e1219 > _e1222));
                                let _e1227 = local_2.member_2[1u];
                                let _e1233 = select(_e1227[0], -(_e1227[0]), (_e1227[0] < 0f));
                                let _e1236 = select(_e1227[1], -(_e1227[1]), (_e1227[1] < 0f));
                                let _e1238 = select(_e1236, _e1233, (_e1233 > _e1236));
                                let _e1241 = select(_e1227[2], -(_e1227[2]), (_e1227[2] < 0f));
                                let _e1243 = select(_e1241, _e1238, (_e1238 > _e1241));
                                let _e1247 = local_2.member_3;
                                let _e1251 = ((((select(_e1157, _e1138, (_e1138 > _e1157)) + _e1161) + (select(_e1200, _e1181, (_e1181 > _e1200)) + _e1204)) + (select(_e1243, _e1224, (_e1224 > _e1243)) + _e1247)) * 2f);
                                let _e1254 = local_2.member_3;
                                let _e1258 = (((_e67.member_5 * 1.0001f) + (_e1254 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                let _e1261 = ((_e1054 * _e1033) - (_e1057 * _e1032));
                                let _e1264 = ((_e1057 * _e1031) - (_e1051 * _e1033));
                                let _e1267 = ((_e1051 * _e1032) - (_e1054 * _e1031));
                                let _e1272 = (((_e1261 * _e1060[0]) + (_e1264 * _e1060[1])) + (_e1267 * _e1060[2]));
                                let _e1277 = (((_e1261 * _e1076) + (_e1264 * _e1077)) + (_e1267 * _e1078));
                                let _e1282 = (((_e1261 * _e1086) + (_e1264 * _e1087)) + (_e1267 * _e1088));
                                let _e1287 = (((_e1261 * _e1083) + (_e1264 * _e1084)) + (_e1267 * _e1085));
                                let _e1292 = (((_e1261 * _e1091[0]) + (_e1264 * _e1091[1])) + (_e1267 * _e1091[2]));
                                let _e1297 = (((_e1261 * _e1107) + (_e1264 * _e1108)) + (_e1267 * _e1109));
                                let _e1302 = (((_e1261 * _e1117) + (_e1264 * _e1118)) + (_e1267 * _e1119));
                                let _e1307 = (((_e1261 * _e1114) + (_e1264 * _e1115)) + (_e1267 * _e1116));
                                let _e1309 = select(_e1277, _e1272, (_e1272 < _e1277));
                                let _e1311 = select(_e1287, _e1282, (_e1282 < _e1287));
                                let _e1313 = select(_e1311, _e1309, (_e1309 < _e1311));
                                let _e1315 = select(_e1297, _e1292, (_e1292 < _e1297));
                                let _e1317 = select(_e1307, _e1302, (_e1302 < _e1307));
                                let _e1319 = select(_e1317, _e1315, (_e1315 < _e1317));
                                let _e1321 = select(_e1319, _e1313, (_e1313 < _e1319));
                                let _e1323 = select(_e1277, _e1272, (_e1272 > _e1277));
                                let _e1325 = select(_e1287, _e1282, (_e1282 > _e1287));
                                let _e1327 = select(_e1325, _e1323, (_e1323 > _e1325));
                                let _e1329 = select(_e1297, _e1292, (_e1292 > _e1297));
                                let _e1331 = select(_e1307, _e1302, (_e1302 > _e1307));
                                let _e1333 = select(_e1331, _e1329, (_e1329 > _e1331));
                                let _e1346 = ((select(_e1261, -(_e1261), (_e1261 < 0f)) + select(_e1264, -(_e1264), (_e1264 < 0f))) + select(_e1267, -(_e1267), (_e1267 < 0f)));
                                let _e1351 = -(select(_e1333, _e1327, (_e1327 > _e1333)));
                                let _e1358 = (((select(_e1351, _e1321, (_e1321 > _e1351)) - ((_e1346 * _e1251) * (0.000000059604645f * (17f / 2f)))) - (_e1346 * _e1258)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                let _e1361 = ((_e1054 * _e1048) - (_e1057 * _e1047));
                                let _e1364 = ((_e1057 * _e1046) - (_e1051 * _e1048));
                                let _e1367 = ((_e1051 * _e1047) - (_e1054 * _e1046));
                                let _e1372 = (((_e1361 * _e1060[0]) + (_e1364 * _e1060[1])) + (_e1367 * _e1060[2]));
                                let _e1377 = (((_e1361 * _e1076) + (_e1364 * _e1077)) + (_e1367 * _e1078));
                                let _e1382 = (((_e1361 * _e1086) + (_e1364 * _e1087)) + (_e1367 * _e1088));
                                let _e1387 = (((_e1361 * _e1083) + (_e1364 * _e1084)) + (_e1367 * _e1085));
                                let _e1392 = (((_e1361 * _e1091[0]) + (_e1364 * _e1091[1])) + (_e1367 * _e1091[2]));
                                let _e1397 = (((_e1361 * _e1107) + (_e1364 * _e1108)) + (_e1367 * _e1109));
                                let _e1402 = (((_e1361 * _e1117) + (_e1364 * _e1118)) + (_e1367 * _e1119));
                                let _e1407 = (((_e1361 * _e1114) + (_e1364 * _e1115)) + (_e1367 * _e1116));
                                let _e1409 = select(_e1377, _e1372, (_e1372 < _e1377));
                                let _e1411 = select(_e1387, _e1382, (_e1382 < _e1387));
                                let _e1413 = select(_e1411, _e1409, (_e1409 < _e1411));
                                let _e1415 = select(_e1397, _e1392, (_e1392 < _e1397));
                                let _e1417 = select(_e1407, _e1402, (_e1402 < _e1407));
                                let _e1419 = select(_e1417, _e1415, (_e1415 < _e1417));
                                let _e1421 = select(_e1419, _e1413, (_e1413 < _e1419));
                                let _e1423 = select(_e1377, _e1372, (_e1372 > _e1377));
                                let _e1425 = select(_e1387, _e1382, (_e1382 > _e1387));
                                let _e1427 = select(_e1425, _e1423, (_e1423 > _e1425));
                                let _e1429 = select(_e1397, _e1392, (_e1392 > _e1397));
                                let _e1431 = select(_e1407, _e1402, (_e1402 > _e1407));
                                let _e1433 = select(_e1431, _e1429, (_e1429 > _e1431));
                                let _e1446 = ((select(_e1361, -(_e1361), (_e1361 < 0f)) + select(_e1364, -(_e1364), (_e1364 < 0f))) + select(_e1367, -(_e1367), (_e1367 < 0f)));
                                let _e1451 = -(select(_e1433, _e1427, (_e1427 > _e1433)));
                                let _e1458 = (((select(_e1451, _e1421, (_e1421 > _e1451)) - ((_e1446 * _e1251) * (0.000000059604645f * (17f / 2f)))) - (_e1446 * _e1258)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                let _e1460 = select(_e1458, _e1358, (_e1358 > _e1458));
                                if (_e226.member == 0u) {
                                    let _e1462 = (_e1046 - _e1031);
                                    let _e1463 = (_e1047 - _e1032);
                                    let _e1464 = (_e1048 - _e1033);
                                    let _e1467 = ((_e1054 * _e1464) - (_e1057 * _e1463));
                                    let _e1470 = ((_e1057 * _e1462) - (_e1051 * _e1464));
                                    let _e1473 = ((_e1051 * _e1463) - (_e1054 * _e1462));
                                    let _e1478 = (((_e1467 * _e1060[0]) + (_e1470 * _e1060[1])) + (_e1473 * _e1060[2]));
                                    let _e1483 = (((_e1467 * _e1076) + (_e1470 * _e1077)) + (_e1473 * _e1078));
                                    let _e1488 = (((_e1467 * _e1086) + (_e1470 * _e1087)) + (_e1473 * _e1088));
                                    let _e1493 = (((_e1467 * _e1083) + (_e1470 * _e1084)) + (_e1473 * _e1085));
                                    let _e1498 = (((_e1467 * _e1091[0]) + (_e1470 * _e1091[1])) + (_e1473 * _e1091[2]));
                                    let _e1503 = (((_e1467 * _e1107) + (_e1470 * _e1108)) + (_e1473 * _e1109));
                                    let _e1508 = (((_e1467 * _e1117) + (_e1470 * _e1118)) + (_e1473 * _e1119));
                                    let _e1513 = (((_e1467 * _e1114) + (_e1470 * _e1115)) + (_e1473 * _e1116));
                                    let _e1515 = select(_e1483, _e1478, (_e1478 < _e1483));
                                    let _e1517 = select(_e1493, _e1488, (_e1488 < _e1493));
                                    let _e1519 = select(_e1517, _e1515, (_e1515 < _e1517));
                                    let _e1521 = select(_e1503, _e1498, (_e1498 < _e1503));
                                    let _e1523 = select(_e1513, _e1508, (_e1508 < _e1513));
                                    let _e1525 = select(_e1523, _e1521, (_e1521 < _e1523));
                                    let _e1527 = select(_e1525, _e1519, (_e1519 < _e1525));
                                    let _e1529 = select(_e1483, _e1478, (_e1478 > _e1483));
                                    let _e1531 = select(_e1493, _e1488, (_e1488 > _e1493));
                                    let _e1533 = select(_e1531, _e1529, (_e1529 > _e1531));
                                    let _e1535 = select(_e1503, _e1498, (_e1498 > _e1503));
                                    let _e1537 = select(_e1513, _e1508, (_e1508 > _e1513));
                                    let _e1539 = select(_e1537, _e1535, (_e1535 > _e1537));
                                    let _e1552 = ((select(_e1467, -(_e1467), (_e1467 < 0f)) + select(_e1470, -(_e1470), (_e1470 < 0f))) + select(_e1473, -(_e1473), (_e1473 < 0f)));
                                    let _e1557 = -(select(_e1539, _e1533, (_e1533 > _e1539)));
                                    let _e1564 = (((select(_e1557, _e1527, (_e1527 > _e1557)) - ((_e1552 * _e1251) * (0.000000059604645f * (17f / 2f)))) - (_e1552 * _e1258)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    phi_2547_ = select(_e1564, _e1460, (_e1460 > _e1564));
                                } else {
                                    phi_2547_ = _e1460;
                                }
                                let _e1568 = phi_2547_;
                                phi_2550_ = (_e1018 || (_e1568 > 0f));
                            }
                            let _e1572 = phi_2550_;
                            if _e1572 {
                            } else {
                                let _e1574 = atomicAdd((&counters[0u]), 1u);
                                left[_e1574].member = _e192.member;
                                left[_e1574].member_1 = _e192.member_1;
                            }
                        }
                        phi_2561_ = true;
                    }
                    let _e1581 = phi_2561_;
                    phi_2562_ = _e1581;
                } else {
                    phi_2562_ = false;
                }
                let _e1583 = phi_2562_;
                continue;
                continuing {
                    phi_355_ = type_9(select(_e154.member, (_e154.member + 1u), _e157), select(_e154.member_1, _e154.member_1, _e157));
                    break if !(_e1583);
                }
            }
            workgroupBarrier();
            let _e1586 = atomicLoad((&counters[0u]));
            phi_2567_ = type_9(0u, 4u);
            loop {
                let _e1588 = phi_2567_;
                let _e1591 = (_e1588.member < _e1588.member_1);
                if (bitcast<i32>(select(0u, 1u, _e1591)) != 0i) {
                    let _e1606 = ((select(type_9().member_1, _e1588.member, _e1591) * 128u) + _e51);
                    if (_e1606 >= _e1586) {
                        phi_8301_ = false;
                    } else {
                        let _e1610 = left[_e1606].member;
                        let _e1612 = left[_e1606].member_1;
                        if (_e146 == 0u) {
                            let _e1632 = ((2u * _e67.member[1]) + (3u * _e1612));
                            let _e1634 = elements.member[_e1632];
                            let _e1637 = elements.member[(_e1632 + 1u)];
                            let _e1640 = elements.member[(_e1632 + 2u)];
                            phi_2698_ = type_19(0u, array<u32, 4>(_e1610, _e1634, _e1637, _e1640));
                        } else {
                            let _e1614 = (2u * _e1610);
                            let _e1616 = elements.member[_e1614];
                            let _e1619 = elements.member[(_e1614 + 1u)];
                            let _e1620 = (2u * _e1612);
                            let _e1622 = elements.member[_e1620];
                            let _e1625 = elements.member[(_e1620 + 1u)];
                            phi_2698_ = type_19(1u, array<u32, 4>(_e1616, _e1619, _e1622, _e1625));
                        }
                        let _e1644 = phi_2698_;
                        let _e1649 = paths.member[_e1644.member_1[0]];
                        let _e1664 = paths.member[_e1644.member_1[1]];
                        let _e1679 = paths.member[_e1644.member_1[2]];
                        let _e1694 = paths.member[_e1644.member_1[3]];
                        if (_e1644.member != 0u) {
                            phi_2831_ = type_24(array<array<f32, 3>, 2>(array<f32, 3>((_e1679.member.x - _e1649.member.x), (_e1679.member.y - _e1649.member.y), (_e1679.member.z - _e1649.member.z)), array<f32, 3>((_e1679.member_1.x - _e1649.member_1.x), (_e1679.member_1.y - _e1649.member_1.y), (_e1679.member_1.z - _e1649.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e1664.member.x - _e1649.member.x), (_e1664.member.y - _e1649.member.y), (_e1664.member.z - _e1649.member.z)), array<f32, 3>((_e1664.member_1.x - _e1649.member_1.x), (_e1664.member_1.y - _e1649.member_1.y), (_e1664.member_1.z - _e1649.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e1679.member.x - _e1694.member.x), (_e1679.member.y - _e1694.member.y), (_e1679.member.z - _e1694.member.z)), array<f32, 3>((_e1679.member_1.x - _e1694.member_1.x), (_e1679.member_1.y - _e1694.member_1.y), (_e1679.member_1.z - _e1694.member_1.z))), (_e67.member_4 + _e67.member_4));
                        } else {
                            phi_2831_ = type_24(array<array<f32, 3>, 2>(array<f32, 3>((_e1649.member.x - _e1664.member.x), (_e1649.member.y - _e1664.member.y), (_e1649.member.z - _e1664.member.z)), array<f32, 3>((_e1649.member_1.x - _e1664.member_1.x), (_e1649.member_1.y - _e1664.member_1.y), (_e1649.member_1.z - _e1664.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e1679.member.x - _e1664.member.x), (_e1679.member.y - _e1664.member.y), (_e1679.member.z - _e1664.member.z)), array<f32, 3>((_e1679.member_1.x - _e1664.member_1.x), (_e1679.member_1.y - _e1664.member_1.y), (_e1679.member_1.z - _e1664.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e1694.member.x - _e1664.member.x), (_e1694.member.y - _e1664.member.y), (_e1694.member.z - _e1664.member.z)), array<f32, 3>((_e1694.member_1.x - _e1664.member_1.x), (_e1694.member_1.y - _e1664.member_1.y), (_e1694.member_1.z - _e1664.member_1.z))), (_e67.member_4 + _e67.member_4));
                        }
                        let _e1767 = phi_2831_;
                        let _e1778 = ((_e1767.member_1[0][1] * _e1767.member_2[0][2]) - (_e1767.member_1[0][2] * _e1767.member_2[0][1]));
                        let _e1785 = ((_e1767.member_1[0][2] * _e1767.member_2[0][0]) - (_e1767.member_1[0][0] * _e1767.member_2[0][2]));
                        let _e1792 = ((_e1767.member_1[0][0] * _e1767.member_2[0][1]) - (_e1767.member_1[0][1] * _e1767.member_2[0][0]));
                        let _e1803 = ((_e1767.member_1[1][1] * _e1767.member_2[1][2]) - (_e1767.member_1[1][2] * _e1767.member_2[1][1]));
                        let _e1810 = ((_e1767.member_1[1][2] * _e1767.member_2[1][0]) - (_e1767.member_1[1][0] * _e1767.member_2[1][2]));
                        let _e1817 = ((_e1767.member_1[1][0] * _e1767.member_2[1][1]) - (_e1767.member_1[1][1] * _e1767.member_2[1][0]));
                        let _e1868 = (((_e1767.member_1[0][1] * _e1767.member_2[1][2]) - (_e1767.member_1[0][2] * _e1767.member_2[1][1])) + ((_e1767.member_1[1][1] * _e1767.member_2[0][2]) - (_e1767.member_1[1][2] * _e1767.member_2[0][1])));
                        let _e1869 = (((_e1767.member_1[0][2] * _e1767.member_2[1][0]) - (_e1767.member_1[0][0] * _e1767.member_2[1][2])) + ((_e1767.member_1[1][2] * _e1767.member_2[0][0]) - (_e1767.member_1[1][0] * _e1767.member_2[0][2])));
                        let _e1870 = (((_e1767.member_1[0][0] * _e1767.member_2[1][1]) - (_e1767.member_1[0][1] * _e1767.member_2[1][0])) + ((_e1767.member_1[1][0] * _e1767.member_2[0][1]) - (_e1767.member_1[1][1] * _e1767.member_2[0][0])));
                        let _e1901 = ((((_e1767.member[1][0] * _e1778) + (_e1767.member[1][1] * _e1785)) + (_e1767.member[1][2] * _e1792)) + (((_e1767.member[0][0] * _e1868) + (_e1767.member[0][1] * _e1869)) + (_e1767.member[0][2] * _e1870)));
                        let _e1922 = ((((_e1767.member[0][0] * _e1803) + (_e1767.member[0][1] * _e1810)) + (_e1767.member[0][2] * _e1817)) + (((_e1767.member[1][0] * _e1868) + (_e1767.member[1][1] * _e1869)) + (_e1767.member[1][2] * _e1870)));
                        let _e1938 = select(_e1767.member[0][0], -(_e1767.member[0][0]), (_e1767.member[0][0] < 0f));
                        let _e1942 = select(_e1767.member[0][1], -(_e1767.member[0][1]), (_e1767.member[0][1] < 0f));
                        let _e1944 = select(_e1942, _e1938, (_e1938 > _e1942));
                        let _e1948 = select(_e1767.member[0][2], -(_e1767.member[0][2]), (_e1767.member[0][2] < 0f));
                        let _e1950 = select(_e1948, _e1944, (_e1944 > _e1948));
                        let _e1956 = select(_e1767.member[1][0], -(_e1767.member[1][0]), (_e1767.member[1][0] < 0f));
                        let _e1960 = select(_e1767.member[1][1], -(_e1767.member[1][1]), (_e1767.member[1][1] < 0f));
                        let _e1962 = select(_e1960, _e1956, (_e1956 > _e1960));
                        let _e1966 = select(_e1767.member[1][2], -(_e1767.member[1][2]), (_e1767.member[1][2] < 0f));
                        let _e1968 = select(_e1966, _e1962, (_e1962 > _e1966));
                        let _e1972 = (select(_e1968, _e1950, (_e1950 > _e1968)) + _e1767.member_3);
                        let _e1978 = select(_e1767.member_1[0][0], -(_e1767.member_1[0][0]), (_e1767.member_1[0][0] < 0f));
                        let _e1982 = select(_e1767.member_1[0][1], -(_e1767.member_1[0][1]), (_e1767.member_1[0][1] < 0f));
                        let _e1984 = select(_e1982, _e1978, (_e1978 > _e1982));
                        let _e1988 = select(_e1767.member_1[0][2], -(_e1767.member_1[0][2]), (_e1767.member_1[0][2] < 0f));
                        let _e1990 = select(_e1988, _e1984, (_e1984 > _e1988));
                        let _e1996 = select(_e1767.member_1[1][0], -(_e1767.member_1[1][0]), (_e1767.member_1[1][0] < 0f));
                        let _e2000 = select(_e1767.member_1[1][1], -(_e1767.member_1[1][1]), (_e1767.member_1[1][1] < 0f));
                        let _e2002 = select(_e2000, _e1996, (_e1996 > _e2000));
                        let _e2006 = select(_e1767.member_1[1][2], -(_e1767.member_1[1][2]), (_e1767.member_1[1][2] < 0f));
                        let _e2008 = select(_e2006, _e2002, (_e2002 > _e2006));
                        let _e2012 = (select(_e2008, _e1990, (_e1990 > _e2008)) + _e1767.member_3);
                        let _e2018 = select(_e1767.member_2[0][0], -(_e1767.member_2[0][0]), (_e1767.member_2[0][0] < 0f));
                        let _e2022 = select(_e1767.member_2[0][1], -(_e1767.member_2[0][1]), (_e1767.member_2[0][1] < 0f));
                        let _e2024 = select(_e2022, _e2018, (_e2018 > _e2022));
                        let _e2028 = select(_e1767.member_2[0][2], -(_e1767.member_2[0][2]), (_e1767.member_2[0][2] < 0f));
                        let _e2030 = select(_e2028, _e2024, (_e2024 > _e2028));
                        let _e2036 = select(_e1767.member_2[1][0], -(_e1767.member_2[1][0]), (_e1767.member_2[1][0] < 0f));
                        let _e2040 = select(_e1767.member_2[1][1], -(_e1767.member_2[1][1]), (_e1767.member_2[1][1] < 0f));
                        let _e2042 = select(_e2040, _e2036, (_e2036 > _e2040));
                        let _e2046 = select(_e1767.member_2[1][2], -(_e1767.member_2[1][2]), (_e1767.member_2[1][2] < 0f));
                        let _e2048 = select(_e2046, _e2042, (_e2042 > _e2046));
                        let _e2052 = (select(_e2048, _e2030, (_e2030 > _e2048)) + _e1767.member_3);
                        let _e2054 = ((_e2012 * 8f) * _e2052);
                        let _e2084 = ((select(_e1778, -(_e1778), (_e1778 < 0f)) + select(_e1785, -(_e1785), (_e1785 < 0f))) + select(_e1792, -(_e1792), (_e1792 < 0f)));
                        let _e2095 = ((select(_e1803, -(_e1803), (_e1803 < 0f)) + select(_e1810, -(_e1810), (_e1810 < 0f))) + select(_e1817, -(_e1817), (_e1817 < 0f)));
                        let _e2097 = select(_e2095, _e2084, (_e2084 > _e2095));
                        let _e2109 = (((select(_e1868, -(_e1868), (_e1868 < 0f)) + select(_e1869, -(_e1869), (_e1869 < 0f))) + select(_e1870, -(_e1870), (_e1870 < 0f))) * 0.5f);
                        let _e2128 = ((((_e1767.member[0][0] * _e1778) + (_e1767.member[0][1] * _e1785)) + (_e1767.member[0][2] * _e1792)) * 3f);
                        let _e2129 = ((((_e1767.member[1][0] * _e1803) + (_e1767.member[1][1] * _e1810)) + (_e1767.member[1][2] * _e1817)) * 3f);
                        let _e2133 = ((((((_e1972 * 8f) * _e2054) * (0.000000059604645f * (524f / 64f))) + ((_e1767.member_3 * 19f) * ((_e1972 * (_e2012 + _e2052)) + (_e2012 * _e2052)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1972) * ((1f + _e2012) * (1f + _e2052))))) + ((_e67.member_5 * (((select(_e2109, _e2097, (_e2097 > _e2109)) + (_e2054 * (0.000000059604645f * 8f))) + ((_e1767.member_3 * 6f) * (_e2012 + _e2052))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2012) * (1f + _e2052))))) * (3f * 1.0001f)));
                        let _e2135 = ((_e1901 - _e2128) * 3f);
                        let _e2137 = ((_e1922 - _e2128) * 1.5f);
                        let _e2138 = (_e2129 - _e2128);
                        let _e2140 = select(_e2137, _e2135, (_e2135 < _e2137));
                        let _e2143 = -(select(_e2138, _e2140, (_e2140 < _e2138)));
                        let _e2147 = select(_e2137, _e2135, (_e2135 > _e2137));
                        let _e2149 = select(_e2138, _e2147, (_e2147 > _e2138));
                        let _e2152 = (0.000000000000000000000000000000000000011754944f * 8f);
                        let _e2155 = ((_e2128 - _e2133) / (select(0f, _e2143, (_e2143 > 0f)) + _e2152));
                        let _e2159 = ((-(_e2128) - _e2133) / (select(0f, _e2149, (_e2149 > 0f)) + _e2152));
                        let _e2164 = (select(_e2159, _e2155, (_e2155 > _e2159)) * (1f - (0.000000059604645f * 32f)));
                        let _e2166 = select(0f, _e2164, (_e2164 > 0f));
                        let _e2168 = select(1f, _e2166, (_e2166 < 1f));
                        let _e2170 = ((_e1922 - _e2129) * 3f);
                        let _e2172 = ((_e1901 - _e2129) * 1.5f);
                        let _e2173 = (_e2128 - _e2129);
                        let _e2175 = select(_e2172, _e2170, (_e2170 < _e2172));
                        let _e2178 = -(select(_e2173, _e2175, (_e2175 < _e2173)));
                        let _e2182 = select(_e2172, _e2170, (_e2170 > _e2172));
                        let _e2184 = select(_e2173, _e2182, (_e2182 > _e2173));
                        let _e2187 = (0.000000000000000000000000000000000000011754944f * 8f);
                        let _e2190 = ((_e2129 - _e2133) / (select(0f, _e2178, (_e2178 > 0f)) + _e2187));
                        let _e2194 = ((-(_e2129) - _e2133) / (select(0f, _e2184, (_e2184 > 0f)) + _e2187));
                        let _e2199 = (select(_e2194, _e2190, (_e2190 > _e2194)) * (1f - (0.000000059604645f * 32f)));
                        let _e2201 = select(0f, _e2199, (_e2199 > 0f));
                        let _e2206 = ((1f - select(1f, _e2201, (_e2201 < 1f))) + (0.000000059604645f * 4f));
                        let _e2208 = select(1f, _e2206, (_e2206 < 1f));
                        let _e2210 = select(1f, _e2208, (_e2208 < 1f));
                        let _e2216 = select(_e1767.member[0][0], -(_e1767.member[0][0]), (_e1767.member[0][0] < 0f));
                        let _e2220 = select(_e1767.member[0][1], -(_e1767.member[0][1]), (_e1767.member[0][1] < 0f));
                        let _e2222 = select(_e2220, _e2216, (_e2216 > _e2220));
                        let _e2226 = select(_e1767.member[0][2], -(_e1767.member[0][2]), (_e1767.member[0][2] < 0f));
                        let _e2228 = select(_e2226, _e2222, (_e2222 > _e2226));
                        let _e2234 = select(_e1767.member[1][0], -(_e1767.member[1][0]), (_e1767.member[1][0] < 0f));
                        let _e2238 = select(_e1767.member[1][1], -(_e1767.member[1][1]), (_e1767.member[1][1] < 0f));
                        let _e2240 = select(_e2238, _e2234, (_e2234 > _e2238));
                        let _e2244 = select(_e1767.member[1][2], -(_e1767.member[1][2]), (_e1767.member[1][2] < 0f));
                        let _e2246 = select(_e2244, _e2240, (_e2240 > _e2244));
                        let _e2250 = (select(_e2246, _e2228, (_e2228 > _e2246)) + _e1767.member_3);
                        let _e2256 = select(_e1767.member_1[0][0], -(_e1767.member_1[0][0]), (_e1767.member_1[0][0] < 0f));
                        let _e2260 = select(_e1767.member_1[0][1], -(_e1767.member_1[0][1]), (_e1767.member_1[0][1] < 0f));
                        let _e2262 = select(_e2260, _e2256, (_e2256 > _e2260));
                        let _e2266 = select(_e1767.member_1[0][2], -(_e1767.member_1[0][2]), (_e1767.member_1[0][2] < 0f));
                        let _e2268 = select(_e2266, _e2262, (_e2262 > _e2266));
                        let _e2274 = select(_e1767.member_1[1][0], -(_e1767.member_1[1][0]), (_e1767.member_1[1][0] < 0f));
                        let _e2278 = select(_e1767.member_1[1][1], -(_e1767.member_1[1][1]), (_e1767.member_1[1][1] < 0f));
                        let _e2280 = select(_e2278, _e2274, (_e2274 > _e2278));
                        let _e2284 = select(_e1767.member_1[1][2], -(_e1767.member_1[1][2]), (_e1767.member_1[1][2] < 0f));
                        let _e2286 = select(_e2284, _e2280, (_e2280 > _e2284));
                        let _e2290 = (select(_e2286, _e2268, (_e2268 > _e2286)) + _e1767.member_3);
                        let _e2296 = select(_e1767.member_2[0][0], -(_e1767.member_2[0][0]), (_e1767.member_2[0][0] < 0f));
                        let _e2300 = select(_e1767.member_2[0][1], -(_e1767.member_2[0][1]), (_e1767.member_2[0][1] < 0f));
                        let _e2302 = select(_e2300, _e2296, (_e2296 > _e2300));
                        let _e2306 = select(_e1767.member_2[0][2], -(_e1767.member_2[0][2]), (_e1767.member_2[0][2] < 0f));
                        let _e2308 = select(_e2306, _e2302, (_e2302 > _e2306));
                        let _e2314 = select(_e1767.member_2[1][0], -(_e1767.member_2[1][0]), (_e1767.member_2[1][0] < 0f));
                        let _e2318 = select(_e1767.member_2[1][1], -(_e1767.member_2[1][1]), (_e1767.member_2[1][1] < 0f));
                        let _e2320 = select(_e2318, _e2314, (_e2314 > _e2318));
                        let _e2324 = select(_e1767.member_2[1][2], -(_e1767.member_2[1][2]), (_e1767.member_2[1][2] < 0f));
                        let _e2326 = select(_e2324, _e2320, (_e2320 > _e2324));
                        let _e2330 = (select(_e2326, _e2308, (_e2308 > _e2326)) + _e1767.member_3);
                        let _e2332 = select(_e2290, _e2250, (_e2250 > _e2290));
                        let _e2475 = ((_e2168 > -1f) && (_e2210 > -1f));
                        local = type_24(array<array<f32, 3>, 2>(array<f32, 3>((_e1767.member[0][0] + ((_e1767.member[1][0] - _e1767.member[0][0]) * _e2168)), (_e1767.member[0][1] + ((_e1767.member[1][1] - _e1767.member[0][1]) * _e2168)), (_e1767.member[0][2] + ((_e1767.member[1][2] - _e1767.member[0][2]) * _e2168))), array<f32, 3>((_e1767.member[0][0] + ((_e1767.member[1][0] - _e1767.member[0][0]) * _e2210)), (_e1767.member[0][1] + ((_e1767.member[1][1] - _e1767.member[0][1]) * _e2210)), (_e1767.member[0][2] + ((_e1767.member[1][2] - _e1767.member[0][2]) * _e2210)))), array<array<f32, 3>, 2>(array<f32, 3>((_e1767.member_1[0][0] + ((_e1767.member_1[1][0] - _e1767.member_1[0][0]) * _e2168)), (_e1767.member_1[0][1] + ((_e1767.member_1[1][1] - _e1767.member_1[0][1]) * _e2168)), (_e1767.member_1[0][2] + ((_e1767.member_1[1][2] - _e1767.member_1[0][2]) * _e2168))), array<f32, 3>((_e1767.member_1[0][0] + ((_e1767.member_1[1][0] - _e1767.member_1[0][0]) * _e2210)), (_e1767.member_1[0][1] + ((_e1767.member_1[1][1] - _e1767.member_1[0][1]) * _e2210)), (_e1767.member_1[0][2] + ((_e1767.member_1[1][2] - _e1767.member_1[0][2]) * _e2210)))), array<array<f32, 3>, 2>(array<f32, 3>((_e1767.member_2[0][0] + ((_e1767.member_2[1][0] - _e1767.member_2[0][0]) * _e2168)), (_e1767.member_2[0][1] + ((_e1767.member_2[1][1] - _e1767.member_2[0][1]) * _e2168)), (_e1767.member_2[0][2] + ((_e1767.member_2[1][2] - _e1767.member_2[0][2]) * _e2168))), array<f32, 3>((_e1767.member_2[0][0] + ((_e1767.member_2[1][0] - _e1767.member_2[0][0]) * _e2210)), (_e1767.member_2[0][1] + ((_e1767.member_2[1][1] - _e1767.member_2[0][1]) * _e2210)), (_e1767.member_2[0][2] + ((_e1767.member_2[1][2] - _e1767.member_2[0][2]) * _e2210)))), ((_e1767.member_3 + (select(_e2330, _e2332, (_e2332 > _e2330)) * (0.000000059604645f * 8f))) + (0.000000000000000000000000000000000000011754944f * 8f)));
                        let _e2488 = local.member_1[0u];
                        let _e2494 = local.member_2[0u];
                        let _e2500 = ((_e2488[1] * _e2494[2]) - (_e2488[2] * _e2494[1]));
                        let _e2503 = ((_e2488[2] * _e2494[0]) - (_e2488[0] * _e2494[2]));
                        let _e2506 = ((_e2488[0] * _e2494[1]) - (_e2488[1] * _e2494[0]));
                        let _e2509 = local.member_1[1u];
                        let _e2515 = local.member_2[1u];
                        let _e2521 = ((_e2509[1] * _e2515[2]) - (_e2509[2] * _e2515[1]));
                        let _e2524 = ((_e2509[2] * _e2515[0]) - (_e2509[0] * _e2515[2]));
                        let _e2527 = ((_e2509[0] * _e2515[1]) - (_e2509[1] * _e2515[0]));
                        let _e2530 = local.member_1[0u];
                        let _e2536 = local.member_2[1u];
                        let _e2551 = local.member_1[1u];
                        let _e2557 = local.member_2[0u];
                        let _e2570 = (((_e2530[1] * _e2536[2]) - (_e2530[2] * _e2536[1])) + ((_e2551[1] * _e2557[2]) - (_e2551[2] * _e2557[1])));
                        let _e2571 = (((_e2530[2] * _e2536[0]) - (_e2530[0] * _e2536[2])) + ((_e2551[2] * _e2557[0]) - (_e2551[0] * _e2557[2])));
                        let _e2572 = (((_e2530[0] * _e2536[1]) - (_e2530[1] * _e2536[0])) + ((_e2551[0] * _e2557[1]) - (_e2551[1] * _e2557[0])));
                        let _e2575 = local.member[0u];
                        let _e2586 = local.member[1u];
                        let _e2597 = local.member[0u];
                        let _e2606 = ((((_e2586[0] * _e2500) + (_e2586[1] * _e2503)) + (_e2586[2] * _e2506)) + (((_e2597[0] * _e2570) + (_e2597[1] * _e2571)) + (_e2597[2] * _e2572)));
                        let _e2609 = local.member[0u];
                        let _e2620 = local.member[1u];
                        let _e2629 = ((((_e2609[0] * _e2521) + (_e2609[1] * _e2524)) + (_e2609[2] * _e2527)) + (((_e2620[0] * _e2570) + (_e2620[1] * _e2571)) + (_e2620[2] * _e2572)));
                        let _e2632 = local.member[1u];
                        let _e2643 = local.member[0u];
                        let _e2649 = select(_e2643[0], -(_e2643[0]), (_e2643[0] < 0f));
                        let _e2652 = select(_e2643[1], -(_e2643[1]), (_e2643[1] < 0f));
                        let _e2654 = select(_e2652, _e2649, (_e2649 > _e2652));
                        let _e2657 = select(_e2643[2], -(_e2643[2]), (_e2643[2] < 0f));
                        let _e2659 = select(_e2657, _e2654, (_e2654 > _e2657));
                        let _e2662 = local.member[1u];
                        let _e2668 = select(_e2662[0], -(_e2662[0]), (_e2662[0] < 0f));
                        let _e2671 = select(_e2662[1], -(_e2662[1]), (_e2662[1] < 0f));
                        let _e2673 = select(_e2671, _e2668, (_e2668 > _e2671));
                        let _e2676 = select(_e2662[2], -(_e2662[2]), (_e2662[2] < 0f));
                        let _e2678 = select(_e2676, _e2673, (_e2673 > _e2676));
                        let _e2682 = local.member_3;
                        let _e2683 = (select(_e2678, _e2659, (_e2659 > _e2678)) + _e2682);
                        let _e2686 = local.member_1[0u];
                        let _e2692 = select(_e2686[0], -(_e2686[0]), (_e2686[0] < 0f));
                        let _e2695 = select(_e2686[1], -(_e2686[1]), (_e2686[1] < 0f));
                        let _e2697 = select(_e2695, _e2692, (_e2692 > _e2695));
                        let _e2700 = select(_e2686[2], -(_e2686[2]), (_e2686[2] < 0f));
                        let _e2702 = select(_e2700, _e2697, (_e2697 > _e2700));
                        let _e2705 = local.member_1[1u];
                        let _e2711 = select(_e2705[0], -(_e2705[0]), (_e2705[0] < 0f));
                        let _e2714 = select(_e2705[1], -(_e2705[1]), (_e2705[1] < 0f));
                        let _e2716 = select(_e2714, _e2711, (_e2711 > _e2714));
                        let _e2719 = select(_e2705[2], -(_e2705[2]), (_e2705[2] < 0f));
                        let _e2721 = select(_e2719, _e2716, (_e2716 > _e2719));
                        let _e2725 = local.member_3;
                        let _e2726 = (select(_e2721, _e2702, (_e2702 > _e2721)) + _e2725);
                        let _e2729 = local.member_2[0u];
                        let _e2735 = select(_e2729[0], -(_e2729[0]), (_e2729[0] < 0f));
                        let _e2738 = select(_e2729[1], -(_e2729[1]), (_e2729[1] < 0f));
                        let _e2740 = select(_e2738, _e2735, (_e2735 > _e2738));
                        let _e2743 = select(_e2729[2], -(_e2729[2]), (_e2729[2] < 0f));
                        let _e2745 = select(_e2743, _e2740, (_e2740 > _e2743));
                        let _e2748 = local.member_2[1u];
                        let _e2754 = select(_e2748[0], -(_e2748[0]), (_e2748[0] < 0f));
                        let _e2757 = select(_e2748[1], -(_e2748[1]), (_e2748[1] < 0f));
                        let _e2759 = select(_e2757, _e2754, (_e2754 > _e2757));
                        let _e2762 = select(_e2748[2], -(_e2748[2]), (_e2748[2] < 0f));
                        let _e2764 = select(_e2762, _e2759, (_e2759 > _e2762));
                        let _e2768 = local.member_3;
                        let _e2769 = (select(_e2764, _e2745, (_e2745 > _e2764)) + _e2768);
                        let _e2771 = ((_e2726 * 8f) * _e2769);
                        let _e2778 = local.member_3;
                        let _e2802 = ((select(_e2500, -(_e2500), (_e2500 < 0f)) + select(_e2503, -(_e2503), (_e2503 < 0f))) + select(_e2506, -(_e2506), (_e2506 < 0f)));
                        let _e2813 = ((select(_e2521, -(_e2521), (_e2521 < 0f)) + select(_e2524, -(_e2524), (_e2524 < 0f))) + select(_e2527, -(_e2527), (_e2527 < 0f)));
                        let _e2815 = select(_e2813, _e2802, (_e2802 > _e2813));
                        let _e2827 = (((select(_e2570, -(_e2570), (_e2570 < 0f)) + select(_e2571, -(_e2571), (_e2571 < 0f))) + select(_e2572, -(_e2572), (_e2572 < 0f))) * 0.5f);
                        let _e2834 = local.member_3;
                        let _e2847 = ((((_e2575[0] * _e2500) + (_e2575[1] * _e2503)) + (_e2575[2] * _e2506)) * 3f);
                        let _e2848 = ((((_e2632[0] * _e2521) + (_e2632[1] * _e2524)) + (_e2632[2] * _e2527)) * 3f);
                        let _e2850 = select(_e2848, _e2847, (_e2847 < _e2848));
                        let _e2852 = select(_e2629, _e2606, (_e2606 < _e2629));
                        let _e2854 = select(_e2852, _e2850, (_e2850 < _e2852));
                        let _e2856 = select(_e2848, _e2847, (_e2847 > _e2848));
                        let _e2858 = select(_e2629, _e2606, (_e2606 > _e2629));
                        let _e2861 = -(select(_e2858, _e2856, (_e2856 > _e2858)));
                        let _e2869 = ((select(_e2861, _e2854, (_e2854 > _e2861)) - ((((((_e2683 * 8f) * _e2771) * (0.000000059604645f * (524f / 64f))) + ((_e2778 * 19f) * ((_e2683 * (_e2726 + _e2769)) + (_e2726 * _e2769)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2683) * ((1f + _e2726) * (1f + _e2769))))) + ((_e67.member_5 * (((select(_e2827, _e2815, (_e2815 > _e2827)) + (_e2771 * (0.000000059604645f * 8f))) + ((_e2834 * 6f) * (_e2726 + _e2769))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2726) * (1f + _e2769))))) * (3f * 1.0001f)))) > 0f);
                        if _e2869 {
                            phi_5446_ = _e2869;
                        } else {
                            let _e2872 = local.member_1[0u];
                            let _e2878 = local.member_1[1u];
                            let _e2882 = (_e2872[0] + _e2878[0]);
                            let _e2883 = (_e2872[1] + _e2878[1]);
                            let _e2884 = (_e2872[2] + _e2878[2]);
                            let _e2887 = local.member_2[0u];
                            let _e2893 = local.member_2[1u];
                            let _e2897 = (_e2887[0] + _e2893[0]);
                            let _e2898 = (_e2887[1] + _e2893[1]);
                            let _e2899 = (_e2887[2] + _e2893[2]);
                            let _e2902 = ((_e2883 * _e2899) - (_e2884 * _e2898));
                            let _e2905 = ((_e2884 * _e2897) - (_e2882 * _e2899));
                            let _e2908 = ((_e2882 * _e2898) - (_e2883 * _e2897));
                            let _e2911 = local.member[0u];
                            let _e2917 = local.member_1[0u];
                            let _e2923 = local.member_2[0u];
                            let _e2927 = (_e2911[0] - _e2917[0]);
                            let _e2928 = (_e2911[1] - _e2917[1]);
                            let _e2929 = (_e2911[2] - _e2917[2]);
                            let _e2930 = (_e1644.member == 0u);
                            let _e2934 = select((_e2927 - _e2923[0]), _e2911[0], _e2930);
                            let _e2935 = select((_e2928 - _e2923[1]), _e2911[1], _e2930);
                            let _e2936 = select((_e2929 - _e2923[2]), _e2911[2], _e2930);
                            let _e2937 = (_e2911[0] - _e2923[0]);
                            let _e2938 = (_e2911[1] - _e2923[1]);
                            let _e2939 = (_e2911[2] - _e2923[2]);
                            let _e2942 = local.member[1u];
                            let _e2948 = local.member_1[1u];
                            let _e2954 = local.member_2[1u];
                            let _e2958 = (_e2942[0] - _e2948[0]);
                            let _e2959 = (_e2942[1] - _e2948[1]);
                            let _e2960 = (_e2942[2] - _e2948[2]);
                            let _e2961 = (_e1644.member == 0u);
                            let _e2965 = select((_e2958 - _e2954[0]), _e2942[0], _e2961);
                            let _e2966 = select((_e2959 - _e2954[1]), _e2942[1], _e2961);
                            let _e2967 = select((_e2960 - _e2954[2]), _e2942[2], _e2961);
                            let _e2968 = (_e2942[0] - _e2954[0]);
                            let _e2969 = (_e2942[1] - _e2954[1]);
                            let _e2970 = (_e2942[2] - _e2954[2]);
                            let _e2973 = local.member[0u];
                            let _e2979 = select(_e2973[0], -(_e2973[0]), (_e2973[0] < 0f));
                            let _e2982 = select(_e2973[1], -(_e2973[1]), (_e2973[1] < 0f));
                            let _e2984 = select(_e2982, _e2979, (_e2979 > _e2982));
                            let _e2987 = select(_e2973[2], -(_e2973[2]), (_e2973[2] < 0f));
                            let _e2989 = select(_e2987, _e2984, (_e2984 > _e2987));
                            let _e2992 = local.member[1u];
                            let _e2998 = select(_e2992[0], -(_e2992[0]), (_e2992[0] < 0f));
                            let _e3001 = select(_e2992[1], -(_e2992[1]), (_e2992[1] < 0f));
                            let _e3003 = select(_e3001, _e2998, (_e2998 > _e3001));
                            let _e3006 = select(_e2992[2], -(_e2992[2]), (_e2992[2] < 0f));
                            let _e3008 = select(_e3006, _e3003, (_e3003 > _e3006));
                            let _e3012 = local.member_3;
                            let _e3016 = local.member_1[0u];
                            let _e3022 = select(_e3016[0], -(_e3016[0]), (_e3016[0] < 0f));
                            let _e3025 = select(_e3016[1], -(_e3016[1]), (_e3016[1] < 0f));
                            let _e3027 = select(_e3025, _e3022, (_e3022 > _e3025));
                            let _e3030 = select(_e3016[2], -(_e3016[2]), (_e3016[2] < 0f));
                            let _e3032 = select(_e3030, _e3027, (_e3027 > _e3030));
                            let _e3035 = local.member_1[1u];
                            let _e3041 = select(_e3035[0], -(_e3035[0]), (_e3035[0] < 0f));
                            let _e3044 = select(_e3035[1], -(_e3035[1]), (_e3035[1] < 0f));
                            let _e3046 = select(_e3044, _e3041, (_e3041 > _e3044));
                            let _e3049 = select(_e3035[2], -(_e3035[2]), (_e3035[2] < 0f));
                            let _e3051 = select(_e3049, _e3046, (_e3046 > _e3049));
                            let _e3055 = local.member_3;
                            let _e3059 = local.member_2[0u];
                            let _e3065 = select(_e3059[0], -(_e3059[0]), (_e3059[0] < 0f));
                            let _e3068 = select(_e3059[1], -(_e3059[1]), (_e3059[1] < 0f));
                            let _e3070 = select(_e3068, _e3065, (_e3065 > _e3068));
                            let _e3073 = select(_e3059[2], -(_e3059[2]), (_e3059[2] < 0f));
                            let _e3075 = select(_e3073, _e3070, (_e3070 > _e3073));
                            let _e3078 = local.member_2[1u];
                            let _e3084 = select(_e3078[0], -(_e3078[0]), (_e3078[0] < 0f));
                            let _e3087 = select(_e3078[1], -(_e3078[1]), (_e3078[1] < 0f));
                            let _e3089 = select(_e3087, _e3084, (_e3084 > _e3087));
                            let _e3092 = select(_e3078[2], -(_e3078[2]), (_e3078[2] < 0f));
                            let _e3094 = select(_e3092, _e3089, (_e3089 > _e3092));
                            let _e3098 = local.member_3;
                            let _e3102 = ((((select(_e3008, _e2989, (_e2989 > _e3008)) + _e3012) + (select(_e3051, _e3032, (_e3032 > _e3051)) + _e3055)) + (select(_e3094, _e3075, (_e3075 > _e3094)) + _e3098)) * 2f);
                            let _e3105 = local.member_3;
                            let _e3109 = (((_e67.member_5 * 1.0001f) + (_e3105 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                            let _e3112 = ((_e2905 * _e2884) - (_e2908 * _e2883));
                            let _e3115 = ((_e2908 * _e2882) - (_e2902 * _e2884));
                            let _e3118 = ((_e2902 * _e2883) - (_e2905 * _e2882));
                            let _e3123 = (((_e3112 * _e2911[0]) + (_e3115 * _e2911[1])) + (_e3118 * _e2911[2]));
                            let _e3128 = (((_e3112 * _e2927) + (_e3115 * _e2928)) + (_e3118 * _e2929));
                            let _e3133 = (((_e3112 * _e2937) + (_e3115 * _e2938)) + (_e3118 * _e2939));
                            let _e3138 = (((_e3112 * _e2934) + (_e3115 * _e2935)) + (_e3118 * _e2936));
                            let _e3143 = (((_e3112 * _e2942[0]) + (_e3115 * _e2942[1])) + (_e3118 * _e2942[2]));
                            let _e3148 = (((_e3112 * _e2958) + (_e3115 * _e2959)) + (_e3118 * _e2960));
                            let _e3153 = (((_e3112 * _e2968) + (_e3115 * _e2969)) + (_e3118 * _e2970));
                            let _e3158 = (((_e3112 * _e2965) + (_e3115 * _e2966)) + (_e3118 * _e2967));
                            let _e3160 = select(_e3128, _e3123, (_e3123 < _e3128));
                            let _e3162 = select(_e3138, _e3133, (_e3133 < _e3138));
                            let _e3164 = select(_e3162, _e3160, (_e3160 < _e3162));
                            let _e3166 = select(_e3148, _e3143, (_e3143 < _e3148));
                            let _e3168 = select(_e3158, _e3153, (_e3153 < _e3158));
                            let _e3170 = select(_e3168, _e3166, (_e3166 < _e3168));
                            let _e3172 = select(_e3170, _e3164, (_e3164 < _e3170));
                            let _e3174 = select(_e3128, _e3123, (_e3123 > _e3128));
                            let _e3176 = select(_e3138, _e3133, (_e3133 > _e3138));
                            let _e3178 = select(_e3176, _e3174, (_e3174 > _e3176));
                            let _e3180 = select(_e3148, _e3143, (_e3143 > _e3148));
                            let _e3182 = select(_e3158, _e3153, (_e3153 > _e3158));
                            let _e3184 = select(_e3182, _e3180, (_e3180 > _e3182));
                            let _e3197 = ((select(_e3112, -(_e3112), (_e3112 < 0f)) + select(_e3115, -(_e3115), (_e3115 < 0f))) + select(_e3118, -(_e3118), (_e3118 < 0f)));
                            let _e3202 = -(select(_e3184, _e3178, (_e3178 > _e3184)));
                            let _e3209 = (((select(_e3202, _e3172, (_e3172 > _e3202)) - ((_e3197 * _e3102) * (0.000000059604645f * (17f / 2f)))) - (_e3197 * _e3109)) - (0.000000000000000000000000000000000000011754944f * 64f));
                            let _e3212 = ((_e2905 * _e2899) - (_e2908 * _e2898));
                            let _e3215 = ((_e2908 * _e2897) - (_e2902 * _e2899));
                            let _e3218 = ((_e2902 * _e2898) - (_e2905 * _e2897));
                            let _e3223 = (((_e3212 * _e2911[0]) + (_e3215 * _e2911[1])) + (_e3218 * _e2911[2]));
                            let _e3228 = (((_e3212 * _e2927) + (_e3215 * _e2928)) + (_e3218 * _e2929));
                            let _e3233 = (((_e3212 * _e2937) + (_e3215 * _e2938)) + (_e3218 * _e2939));
                            let _e3238 = (((_e3212 * _e2934) + (_e3215 * _e2935)) + (_e3218 * _e2936));
                            let _e3243 = (((_e3212 * _e2942[0]) + (_e3215 * _e2942[1])) + (_e3218 * _e2942[2]));
                            let _e3248 = (((_e3212 * _e2958) + (_e3215 * _e2959)) + (_e3218 * _e2960));
                            let _e3253 = (((_e3212 * _e2968) + (_e3215 * _e2969)) + (_e3218 * _e2970));
                            let _e3258 = (((_e3212 * _e2965) + (_e3215 * _e2966)) + (_e3218 * _e2967));
                            let _e3260 = select(_e3228, _e3223, (_e3223 < _e3228));
                            let _e3262 = select(_e3238, _e3233, (_e3233 < _e3238));
                            let _e3264 = select(_e3262, _e3260, (_e3260 < _e3262));
                            let _e3266 = select(_e3248, _e3243, (_e3243 < _e3248));
                            let _e3268 = select(_e3258, _e3253, (_e3253 < _e3258));
                            let _e3270 = select(_e3268, _e3266, (_e3266 < _e3268));
                            let _e3272 = select(_e3270, _e3264, (_e3264 < _e3270));
                            let _e3274 = select(_e3228, _e3223, (_e3223 > _e3228));
                            let _e3276 = select(_e3238, _e3233, (_e3233 > _e3238));
                            let _e3278 = select(_e3276, _e3274, (_e3274 > _e3276));
                            let _e3280 = select(_e3248, _e3243, (_e3243 > _e3248));
                            let _e3282 = select(_e3258, _e3253, (_e3253 > _e3258));
                            let _e3284 = select(_e3282, _e3280, (_e3280 > _e3282));
                            let _e3297 = ((select(_e3212, -(_e3212), (_e3212 < 0f)) + select(_e3215, -(_e3215), (_e3215 < 0f))) + select(_e3218, -(_e3218), (_e3218 < 0f)));
                            let _e3302 = -(select(_e3284, _e3278, (_e3278 > _e3284)));
                            let _e3309 = (((select(_e3302, _e3272, (_e3272 > _e3302)) - ((_e3297 * _e3102) * (0.000000059604645f * (17f / 2f)))) - (_e3297 * _e3109)) - (0.000000000000000000000000000000000000011754944f * 64f));
                            let _e3311 = select(_e3309, _e3209, (_e3209 > _e3309));
                            if (_e1644.member == 0u) {
                                let _e3313 = (_e2897 - _e2882);
                                let _e3314 = (_e2898 - _e2883);
                                let _e3315 = (_e2899 - _e2884);
                                let _e3318 = ((_e2905 * _e3315) - (_e2908 * _e3314));
                                let _e3321 = ((_e2908 * _e3313) - (_e2902 * _e3315));
                                let _e3324 = ((_e2902 * _e3314) - (_e2905 * _e3313));
                                let _e3329 = (((_e3318 * _e2911[0]) + (_e3321 * _e2911[1])) + (_e3324 * _e2911[2]));
                                let _e3334 = (((_e3318 * _e2927) + (_e3321 * _e2928)) + (_e3324 * _e2929));
                                let _e3339 = (((_e3318 * _e2937) + (_e3321 * _e2938)) + (_e3324 * _e2939));
                                let _e3344 = (((_e3318 * _e2934) + (_e3321 * _e2935)) + (_e3324 * _e2936));
                                let _e3349 = (((_e3318 * _e2942[0]) + (_e3321 * _e2942[1])) + (_e3324 * _e2942[2]));
                                let _e3354 = (((_e3318 * _e2958) + (_e3321 * _e2959)) + (_e3324 * _e2960));
                                let _e3359 = (((_e3318 * _e2968) + (_e3321 * _e2969)) + (_e3324 * _e2970));
                                let _e3364 = (((_e3318 * _e2965) + (_e3321 * _e2966)) + (_e3324 * _e2967));
                                let _e3366 = select(_e3334, _e3329, (_e3329 < _e3334));
                                let _e3368 = select(_e3344, _e3339, (_e3339 < _e3344));
                                let _e3370 = select(_e3368, _e3366, (_e3366 < _e3368));
                                let _e3372 = select(_e3354, _e3349, (_e3349 < _e3354));
                                let _e3374 = select(_e3364, _e3359, (_e3359 < _e3364));
                                let _e3376 = select(_e3374, _e3372, (_e3372 < _e3374));
                                let _e3378 = select(_e3376, _e3370, (_e3370 < _e3376));
                                let _e3380 = select(_e3334, _e3329, (_e3329 > _e3334));
                                let _e3382 = select(_e3344, _e3339, (_e3339 > _e3344));
                                let _e3384 = select(_e3382, _e3380, (_e3380 > _e3382));
                                let _e3386 = select(_e3354, _e3349, (_e3349 > _e3354));
                                let _e3388 = select(_e3364, _e3359, (_e3359 > _e3364));
                                let _e3390 = select(_e3388, _e3386, (_e3386 > _e3388));
                                let _e3403 = ((select(_e3318, -(_e3318), (_e3318 < 0f)) + select(_e3321, -(_e3321), (_e3321 < 0f))) + select(_e3324, -(_e3324), (_e3324 < 0f)));
                                let _e3408 = -(select(_e3390, _e3384, (_e3384 > _e3390)));
                                let _e3415 = (((select(_e3408, _e3378, (_e3378 > _e3408)) - ((_e3403 * _e3102) * (0.000000059604645f * (17f / 2f)))) - (_e3403 * _e3109)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                phi_5443_ = select(_e3415, _e3311, (_e3311 > _e3415));
                            } else {
                                phi_5443_ = _e3311;
                            }
                            let _e3419 = phi_5443_;
                            phi_5446_ = (_e2869 || (_e3419 > 0f));
                        }
                        let _e3423 = phi_5446_;
                        let _e3424 = (_e2475 && _e3423);
                        if _e3424 {
                            phi_8292_ = _e3424;
                        } else {
                            let _e3427 = local.member_1[0u];
                            let _e3433 = local.member_2[0u];
                            let _e3439 = ((_e3427[1] * _e3433[2]) - (_e3427[2] * _e3433[1]));
                            let _e3442 = ((_e3427[2] * _e3433[0]) - (_e3427[0] * _e3433[2]));
                            let _e3445 = ((_e3427[0] * _e3433[1]) - (_e3427[1] * _e3433[0]));
                            let _e3448 = local.member_1[1u];
                            let _e3454 = local.member_2[1u];
                            let _e3460 = ((_e3448[1] * _e3454[2]) - (_e3448[2] * _e3454[1]));
                            let _e3463 = ((_e3448[2] * _e3454[0]) - (_e3448[0] * _e3454[2]));
                            let _e3466 = ((_e3448[0] * _e3454[1]) - (_e3448[1] * _e3454[0]));
                            let _e3469 = local.member_1[0u];
                            let _e3475 = local.member_2[1u];
                            let _e3490 = local.member_1[1u];
                            let _e3496 = local.member_2[0u];
                            let _e3509 = (((_e3469[1] * _e3475[2]) - (_e3469[2] * _e3475[1])) + ((_e3490[1] * _e3496[2]) - (_e3490[2] * _e3496[1])));
                            let _e3510 = (((_e3469[2] * _e3475[0]) - (_e3469[0] * _e3475[2])) + ((_e3490[2] * _e3496[0]) - (_e3490[0] * _e3496[2])));
                            let _e3511 = (((_e3469[0] * _e3475[1]) - (_e3469[1] * _e3475[0])) + ((_e3490[0] * _e3496[1]) - (_e3490[1] * _e3496[0])));
                            let _e3514 = local.member[0u];
                            let _e3525 = local.member[1u];
                            let _e3536 = local.member[0u];
                            let _e3545 = ((((_e3525[0] * _e3439) + (_e3525[1] * _e3442)) + (_e3525[2] * _e3445)) + (((_e3536[0] * _e3509) + (_e3536[1] * _e3510)) + (_e3536[2] * _e3511)));
                            let _e3548 = local.member[0u];
                            let _e3559 = local.member[1u];
                            let _e3568 = ((((_e3548[0] * _e3460) + (_e3548[1] * _e3463)) + (_e3548[2] * _e3466)) + (((_e3559[0] * _e3509) + (_e3559[1] * _e3510)) + (_e3559[2] * _e3511)));
                            let _e3571 = local.member[1u];
                            let _e3582 = local.member[0u];
                            let _e3588 = select(_e3582[0], -(_e3582[0]), (_e3582[0] < 0f));
                            let _e3591 = select(_e3582[1], -(_e3582[1]), (_e3582[1] < 0f));
                            let _e3593 = select(_e3591, _e3588, (_e3588 > _e3591));
                            let _e3596 = select(_e3582[2], -(_e3582[2]), (_e3582[2] < 0f));
                            let _e3598 = select(_e3596, _e3593, (_e3593 > _e3596));
                            let _e3601 = local.member[1u];
                            let _e3607 = select(_e3601[0], -(_e3601[0]), (_e3601[0] < 0f));
                            let _e3610 = select(_e3601[1], -(_e3601[1]), (_e3601[1] < 0f));
                            let _e3612 = select(_e3610, _e3607, (_e3607 > _e3610));
                            let _e3615 = select(_e3601[2], -(_e3601[2]), (_e3601[2] < 0f));
                            let _e3617 = select(_e3615, _e3612, (_e3612 > _e3615));
                            let _e3621 = local.member_3;
                            let _e3622 = (select(_e3617, _e3598, (_e3598 > _e3617)) + _e3621);
                            let _e3625 = local.member_1[0u];
                            let _e3631 = select(_e3625[0], -(_e3625[0]), (_e3625[0] < 0f));
                            let _e3634 = select(_e3625[1], -(_e3625[1]), (_e3625[1] < 0f));
                            let _e3636 = select(_e3634, _e3631, (_e3631 > _e3634));
                            let _e3639 = select(_e3625[2], -(_e3625[2]), (_e3625[2] < 0f));
                            let _e3641 = select(_e3639, _e3636, (_e3636 > _e3639));
                            let _e3644 = local.member_1[1u];
                            let _e3650 = select(_e3644[0], -(_e3644[0]), (_e3644[0] < 0f));
                            let _e3653 = select(_e3644[1], -(_e3644[1]), (_e3644[1] < 0f));
                            let _e3655 = select(_e3653, _e3650, (_e3650 > _e3653));
                            let _e3658 = select(_e3644[2], -(_e3644[2]), (_e3644[2] < 0f));
                            let _e3660 = select(_e3658, _e3655, (_e3655 > _e3658));
                            let _e3664 = local.member_3;
                            let _e3665 = (select(_e3660, _e3641, (_e3641 > _e3660)) + _e3664);
                            let _e3668 = local.member_2[0u];
                            let _e3674 = select(_e3668[0], -(_e3668[0]), (_e3668[0] < 0f));
                            let _e3677 = select(_e3668[1], -(_e3668[1]), (_e3668[1] < 0f));
                            let _e3679 = select(_e3677, _e3674, (_e3674 > _e3677));
                            let _e3682 = select(_e3668[2], -(_e3668[2]), (_e3668[2] < 0f));
                            let _e3684 = select(_e3682, _e3679, (_e3679 > _e3682));
                            let _e3687 = local.member_2[1u];
                            let _e3693 = select(_e3687[0], -(_e3687[0]), (_e3687[0] < 0f));
                            let _e3696 = select(_e3687[1], -(_e3687[1]), (_e3687[1] < 0f));
                            let _e3698 = select(_e3696, _e3693, (_e3693 > _e3696));
                            let _e3701 = select(_e3687[2], -(_e3687[2]), (_e3687[2] < 0f));
                            let _e3703 = select(_e3701, _e3698, (_e3698 > _e3701));
                            let _e3707 = local.member_3;
                            let _e3708 = (select(_e3703, _e3684, (_e3684 > _e3703)) + _e3707);
                            let _e3710 = ((_e3665 * 8f) * _e3708);
                            let _e3717 = local.member_3;
                            let _e3741 = ((select(_e3439, -(_e3439), (_e3439 < 0f)) + select(_e3442, -(_e3442), (_e3442 < 0f))) + select(_e3445, -(_e3445), (_e3445 < 0f)));
                            let _e3752 = ((select(_e3460, -(_e3460), (_e3460 < 0f)) + select(_e3463, -(_e3463), (_e3463 < 0f))) + select(_e3466, -(_e3466), (_e3466 < 0f)));
                            let _e3754 = select(_e3752, _e3741, (_e3741 > _e3752));
                            let _e3766 = (((select(_e3509, -(_e3509), (_e3509 < 0f)) + select(_e3510, -(_e3510), (_e3510 < 0f))) + select(_e3511, -(_e3511), (_e3511 < 0f))) * 0.5f);
                            let _e3773 = local.member_3;
                            let _e3786 = ((((_e3514[0] * _e3439) + (_e3514[1] * _e3442)) + (_e3514[2] * _e3445)) * 3f);
                            let _e3787 = ((((_e3571[0] * _e3460) + (_e3571[1] * _e3463)) + (_e3571[2] * _e3466)) * 3f);
                            let _e3791 = ((((((_e3622 * 8f) * _e3710) * (0.000000059604645f * (524f / 64f))) + ((_e3717 * 19f) * ((_e3622 * (_e3665 + _e3708)) + (_e3665 * _e3708)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3622) * ((1f + _e3665) * (1f + _e3708))))) + ((_e67.member_5 * (((select(_e3766, _e3754, (_e3754 > _e3766)) + (_e3710 * (0.000000059604645f * 8f))) + ((_e3773 * 6f) * (_e3665 + _e3708))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3665) * (1f + _e3708))))) * (3f * 1.0001f)));
                            let _e3793 = ((_e3545 - _e3786) * 3f);
                            let _e3795 = ((_e3568 - _e3786) * 1.5f);
                            let _e3796 = (_e3787 - _e3786);
                            let _e3798 = select(_e3795, _e3793, (_e3793 < _e3795));
                            let _e3801 = -(select(_e3796, _e3798, (_e3798 < _e3796)));
                            let _e3805 = select(_e3795, _e3793, (_e3793 > _e3795));
                            let _e3807 = select(_e3796, _e3805, (_e3805 > _e3796));
                            let _e3810 = (0.000000000000000000000000000000000000011754944f * 8f);
                            let _e3813 = ((_e3786 - _e3791) / (select(0f, _e3801, (_e3801 > 0f)) + _e3810));
                            let _e3817 = ((-(_e3786) - _e3791) / (select(0f, _e3807, (_e3807 > 0f)) + _e3810));
                            let _e3822 = (select(_e3817, _e3813, (_e3813 > _e3817)) * (1f - (0.000000059604645f * 32f)));
                            let _e3824 = select(0f, _e3822, (_e3822 > 0f));
                            let _e3826 = select(1f, _e3824, (_e3824 < 1f));
                            let _e3828 = ((_e3568 - _e3787) * 3f);
                            let _e3830 = ((_e3545 - _e3787) * 1.5f);
                            let _e3831 = (_e3786 - _e3787);
                            let _e3833 = select(_e3830, _e3828, (_e3828 < _e3830));
                            let _e3836 = -(select(_e3831, _e3833, (_e3833 < _e3831)));
                            let _e3840 = select(_e3830, _e3828, (_e3828 > _e3830));
                            let _e3842 = select(_e3831, _e3840, (_e3840 > _e3831));
                            let _e3845 = (0.000000000000000000000000000000000000011754944f * 8f);
                            let _e3848 = ((_e3787 - _e3791) / (select(0f, _e3836, (_e3836 > 0f)) + _e3845));
                            let _e3852 = ((-(_e3787) - _e3791) / (select(0f, _e3842, (_e3842 > 0f)) + _e3845));
                            let _e3857 = (select(_e3852, _e3848, (_e3848 > _e3852)) * (1f - (0.000000059604645f * 32f)));
                            let _e3859 = select(0f, _e3857, (_e3857 > 0f));
                            let _e3864 = ((1f - select(1f, _e3859, (_e3859 < 1f))) + (0.000000059604645f * 4f));
                            let _e3866 = select(1f, _e3864, (_e3864 < 1f));
                            let _e3868 = select(1f, _e3866, (_e3866 < 1f));
                            let _e3871 = local.member[0u];
                            let _e3877 = select(_e3871[0], -(_e3871[0]), (_e3871[0] < 0f));
                            let _e3880 = select(_e3871[1], -(_e3871[1]), (_e3871[1] < 0f));
                            let _e3882 = select(_e3880, _e3877, (_e3877 > _e3880));
                            let _e3885 = select(_e3871[2], -(_e3871[2]), (_e3871[2] < 0f));
                            let _e3887 = select(_e3885, _e3882, (_e3882 > _e3885));
                            let _e3890 = local.member[1u];
                            let _e3896 = select(_e3890[0], -(_e3890[0]), (_e3890[0] < 0f));
                            let _e3899 = select(_e3890[1], -(_e3890[1]), (_e3890[1] < 0f));
                            let _e3901 = select(_e3899, _e3896, (_e3896 > _e3899));
                            let _e3904 = select(_e3890[2], -(_e3890[2]), (_e3890[2] < 0f));
                            let _e3906 = select(_e3904, _e3901, (_e3901 > _e3904));
                            let _e3910 = local.member_3;
                            let _e3911 = (select(_e3906, _e3887, (_e3887 > _e3906)) + _e3910);
                            let _e3914 = local.member_1[0u];
                            let _e3920 = select(_e3914[0], -(_e3914[0]), (_e3914[0] < 0f));
                            let _e3923 = select(_e3914[1], -(_e3914[1]), (_e3914[1] < 0f));
                            let _e3925 = select(_e3923, _e3920, (_e3920 > _e3923));
                            let _e3928 = select(_e3914[2], -(_e3914[2]), (_e3914[2] < 0f));
                            let _e3930 = select(_e3928, _e3925, (_e3925 > _e3928));
                            let _e3933 = local.member_1[1u];
                            let _e3939 = select(_e3933[0], -(_e3933[0]), (_e3933[0] < 0f));
                            let _e3942 = select(_e3933[1], -(_e3933[1]), (_e3933[1] < 0f));
                            let _e3944 = select(_e3942, _e3939, (_e3939 > _e3942));
                            let _e3947 = select(_e3933[2], -(_e3933[2]), (_e3933[2] < 0f));
                            let _e3949 = select(_e3947, _e3944, (_e3944 > _e3947));
                            let _e3953 = local.member_3;
                            let _e3954 = (select(_e3949, _e3930, (_e3930 > _e3949)) + _e3953);
                            let _e3957 = local.member_2[0u];
                            let _e3963 = select(_e3957[0], -(_e3957[0]), (_e3957[0] < 0f));
                            let _e3966 = select(_e3957[1], -(_e3957[1]), (_e3957[1] < 0f));
                            let _e3968 = select(_e3966, _e3963, (_e3963 > _e3966));
                            let _e3971 = select(_e3957[2], -(_e3957[2]), (_e3957[2] < 0f));
                            let _e3973 = select(_e3971, _e3968, (_e3968 > _e3971));
                            let _e3976 = local.member_2[1u];
                            let _e3982 = select(_e3976[0], -(_e3976[0]), (_e3976[0] < 0f));
                            let _e3985 = select(_e3976[1], -(_e3976[1]), (_e3976[1] < 0f));
                            let _e3987 = select(_e3985, _e3982, (_e3982 > _e3985));
                            let _e3990 = select(_e3976[2], -(_e3976[2]), (_e3976[2] < 0f));
                            let _e3992 = select(_e3990, _e3987, (_e3987 > _e3990));
                            let _e3996 = local.member_3;
                            let _e3997 = (select(_e3992, _e3973, (_e3973 > _e3992)) + _e3996);
                            let _e3999 = select(_e3954, _e3911, (_e3911 > _e3954));
                            let _e4006 = local.member[0u];
                            let _e4012 = local.member[1u];
                            let _e4027 = local.member[0u];
                            let _e4033 = local.member[1u];
                            let _e4048 = local.member_1[0u];
                            let _e4054 = local.member_1[1u];
                            let _e4069 = local.member_1[0u];
                            let _e4075 = local.member_1[1u];
                            let _e4090 = local.member_2[0u];
                            let _e4096 = local.member_2[1u];
                            let _e4111 = local.member_2[0u];
                            let _e4117 = local.member_2[1u];
                            let _e4131 = local.member_3;
                            local_1 = type_24(array<array<f32, 3>, 2>(array<f32, 3>((_e4006[0] + ((_e4012[0] - _e4006[0]) * _e3826)), (_e4006[1] + ((_e4012[1] - _e4006[1]) * _e3826)), (_e4006[2] + ((_e4012[2] - _e4006[2]) * _e3826))), array<f32, 3>((_e4027[0] + ((_e4033[0] - _e4027[0]) * _e3868)), (_e4027[1] + ((_e4033[1] - _e4027[1]) * _e3868)), (_e4027[2] + ((_e4033[2] - _e4027[2]) * _e3868)))), array<array<f32, 3>, 2>(array<f32, 3>((_e4048[0] + ((_e4054[0] - _e4048[0]) * _e3826)), (_e4048[1] + ((_e4054[1] - _e4048[1]) * _e3826)), (_e4048[2] + ((_e4054[2] - _e4048[2]) * _e3826))), array<f32, 3>((_e4069[0] + ((_e4075[0] - _e4069[0]) * _e3868)), (_e4069[1] + ((_e4075[1] - _e4069[1]) * _e3868)), (_e4069[2] + ((_e4075[2] - _e4069[2]) * _e3868)))), array<array<f32, 3>, 2>(array<f32, 3>((_e4090[0] + ((_e4096[0] - _e4090[0]) * _e3826)), (_e4090[1] + ((_e4096[1] - _e4090[1]) * _e3826)), (_e4090[2] + ((_e4096[2] - _e4090[2]) * _e3826))), array<f32, 3>((_e4111[0] + ((_e4117[0] - _e4111[0]) * _e3868)), (_e4111[1] + ((_e4117[1] - _e4111[1]) * _e3868)), (_e4111[2] + ((_e4117[2] - _e4111[2]) * _e3868)))), ((_e4131 + (select(_e3997, _e3999, (_e3999 > _e3997)) * (0.000000059604645f * 8f))) + (0.000000000000000000000000000000000000011754944f * 8f)));
                            let _e4151 = local_1.member_1[0u];
                            let _e4157 = local_1.member_2[0u];
                            let _e4163 = ((_e4151[1] * _e4157[2]) - (_e4151[2] * _e4157[1]));
                            let _e4166 = ((_e4151[2] * _e4157[0]) - (_e4151[0] * _e4157[2]));
                            let _e4169 = ((_e4151[0] * _e4157[1]) - (_e4151[1] * _e4157[0]));
                            let _e4172 = local_1.member_1[1u];
                            let _e4178 = local_1.member_2[1u];
                            let _e4184 = ((_e4172[1] * _e4178[2]) - (_e4172[2] * _e4178[1]));
                            let _e4187 = ((_e4172[2] * _e4178[0]) - (_e4172[0] * _e4178[2]));
                            let _e4190 = ((_e4172[0] * _e4178[1]) - (_e4172[1] * _e4178[0]));
                            let _e4193 = local_1.member_1[0u];
                            let _e4199 = local_1.member_2[1u];
                            let _e4214 = local_1.member_1[1u];
                            let _e4220 = local_1.member_2[0u];
                            let _e4233 = (((_e4193[1] * _e4199[2]) - (_e4193[2] * _e4199[1])) + ((_e4214[1] * _e4220[2]) - (_e4214[2] * _e4220[1])));
                            let _e4234 = (((_e4193[2] * _e4199[0]) - (_e4193[0] * _e4199[2])) + ((_e4214[2] * _e4220[0]) - (_e4214[0] * _e4220[2])));
                            let _e4235 = (((_e4193[0] * _e4199[1]) - (_e4193[1] * _e4199[0])) + ((_e4214[0] * _e4220[1]) - (_e4214[1] * _e4220[0])));
                            let _e4238 = local_1.member[0u];
                            let _e4249 = local_1.member[1u];
                            let _e4260 = local_1.member[0u];
                            let _e4269 = ((((_e4249[0] * _e4163) + (_e4249[1] * _e4166)) + (_e4249[2] * _e4169)) + (((_e4260[0] * _e4233) + (_e4260[1] * _e4234)) + (_e4260[2] * _e4235)));
                            let _e4272 = local_1.member[0u];
                            let _e4283 = local_1.member[1u];
                            let _e4292 = ((((_e4272[0] * _e4184) + (_e4272[1] * _e4187)) + (_e4272[2] * _e4190)) + (((_e4283[0] * _e4233) + (_e4283[1] * _e4234)) + (_e4283[2] * _e4235)));
                            let _e4295 = local_1.member[1u];
                            let _e4306 = local_1.member[0u];
                            let _e4312 = select(_e4306[0], -(_e4306[0]), (_e4306[0] < 0f));
                            let _e4315 = select(_e4306[1], -(_e4306[1]), (_e4306[1] < 0f));
                            let _e4317 = select(_e4315, _e4312, (_e4312 > _e4315));
                            let _e4320 = select(_e4306[2], -(_e4306[2]), (_e4306[2] < 0f));
                            let _e4322 = select(_e4320, _e4317, (_e4317 > _e4320));
                            let _e4325 = local_1.member[1u];
                            let _e4331 = select(_e4325[0], -(_e4325[0]), (_e4325[0] < 0f));
                            let _e4334 = select(_e4325[1], -(_e4325[1]), (_e4325[1] < 0f));
                            let _e4336 = select(_e4334, _e4331, (_e4331 > _e4334));
                            let _e4339 = select(_e4325[2], -(_e4325[2]), (_e4325[2] < 0f));
                            let _e4341 = select(_e4339, _e4336, (_e4336 > _e4339));
                            let _e4345 = local_1.member_3;
                            let _e4346 = (select(_e4341, _e4322, (_e4322 > _e4341)) + _e4345);
                            let _e4349 = local_1.member_1[0u];
                            let _e4355 = select(_e4349[0], -(_e4349[0]), (_e4349[0] < 0f));
                            let _e4358 = select(_e4349[1], -(_e4349[1]), (_e4349[1] < 0f));
                            let _e4360 = select(_e4358, _e4355, (_e4355 > _e4358));
                            let _e4363 = select(_e4349[2], -(_e4349[2]), (_e4349[2] < 0f));
                            let _e4365 = select(_e4363, _e4360, (_e4360 > _e4363));
                            let _e4368 = local_1.member_1[1u];
                            let _e4374 = select(_e4368[0], -(_e4368[0]), (_e4368[0] < 0f));
                            let _e4377 = select(_e4368[1], -(_e4368[1]), (_e4368[1] < 0f));
                            let _e4379 = select(_e4377, _e4374, (_e4374 > _e4377));
                            let _e4382 = select(_e4368[2], -(_e4368[2]), (_e4368[2] < 0f));
                            let _e4384 = select(_e4382, _e4379, (_e4379 > _e4382));
                            let _e4388 = local_1.member_3;
                            let _e4389 = (select(_e4384, _e4365, (_e4365 > _e4384)) + _e4388);
                            let _e4392 = local_1.member_2[0u];
                            let _e4398 = select(_e4392[0], -(_e4392[0]), (_e4392[0] < 0f));
                            let _e4401 = select(_e4392[1], -(_e4392[1]), (_e4392[1] < 0f));
                            let _e4403 = select(_e4401, _e4398, (_e4398 > _e4401));
                            let _e4406 = select(_e4392[2], -(_e4392[2]), (_e4392[2] < 0f));
                            let _e4408 = select(_e4406, _e4403, (_e4403 > _e4406));
                            let _e4411 = local_1.member_2[1u];
                            let _e4417 = select(_e4411[0], -(_e4411[0]), (_e4411[0] < 0f));
                            let _e4420 = select(_e4411[1], -(_e4411[1]), (_e4411[1] < 0f));
                            let _e4422 = select(_e4420, _e4417, (_e4417 > _e4420));
                            let _e4425 = select(_e4411[2], -(_e4411[2]), (_e4411[2] < 0f));
                            let _e4427 = select(_e4425, _e4422, (_e4422 > _e4425));
                            let _e4431 = local_1.member_3;
                            let _e4432 = (select(_e4427, _e4408, (_e4408 > _e4427)) + _e4431);
                            let _e4434 = ((_e4389 * 8f) * _e4432);
                            let _e4441 = local_1.member_3;
                            let _e4465 = ((select(_e4163, -(_e4163), (_e4163 < 0f)) + select(_e4166, -(_e4166), (_e4166 < 0f))) + select(_e4169, -(_e4169), (_e4169 < 0f)));
                            let _e4476 = ((select(_e4184, -(_e4184), (_e4184 < 0f)) + select(_e4187, -(_e4187), (_e4187 < 0f))) + select(_e4190, -(_e4190), (_e4190 < 0f)));
                            let _e4478 = select(_e4476, _e4465, (_e4465 > _e4476));
                            let _e4490 = (((select(_e4233, -(_e4233), (_e4233 < 0f)) + select(_e4234, -(_e4234), (_e4234 < 0f))) + select(_e4235, -(_e4235), (_e4235 < 0f))) * 0.5f);
                            let _e4497 = local_1.member_3;
                            let _e4510 = ((((_e4238[0] * _e4163) + (_e4238[1] * _e4166)) + (_e4238[2] * _e4169)) * 3f);
                            let _e4511 = ((((_e4295[0] * _e4184) + (_e4295[1] * _e4187)) + (_e4295[2] * _e4190)) * 3f);
                            let _e4513 = select(_e4511, _e4510, (_e4510 < _e4511));
                            let _e4515 = select(_e4292, _e4269, (_e4269 < _e4292));
                            let _e4517 = select(_e4515, _e4513, (_e4513 < _e4515));
                            let _e4519 = select(_e4511, _e4510, (_e4510 > _e4511));
                            let _e4521 = select(_e4292, _e4269, (_e4269 > _e4292));
                            let _e4524 = -(select(_e4521, _e4519, (_e4519 > _e4521)));
                            let _e4532 = ((select(_e4524, _e4517, (_e4517 > _e4524)) - ((((((_e4346 * 8f) * _e4434) * (0.000000059604645f * (524f / 64f))) + ((_e4441 * 19f) * ((_e4346 * (_e4389 + _e4432)) + (_e4389 * _e4432)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e4346) * ((1f + _e4389) * (1f + _e4432))))) + ((_e67.member_5 * (((select(_e4490, _e4478, (_e4478 > _e4490)) + (_e4434 * (0.000000059604645f * 8f))) + ((_e4497 * 6f) * (_e4389 + _e4432))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e4389) * (1f + _e4432))))) * (3f * 1.0001f)))) > 0f);
                            if _e4532 {
                                phi_8289_ = _e4532;
                            } else {
                                let _e4535 = local_1.member_1[0u];
                                let _e4541 = local_1.member_1[1u];
                                let _e4545 = (_e4535[0] + _e4541[0]);
                                let _e4546 = (_e4535[1] + _e4541[1]);
                                let _e4547 = (_e4535[2] + _e4541[2]);
                                let _e4550 = local_1.member_2[0u];
                                let _e4556 = local_1.member_2[1u];
                                let _e4560 = (_e4550[0] + _e4556[0]);
                                let _e4561 = (_e4550[1] + _e4556[1]);
                                let _e4562 = (_e4550[2] + _e4556[2]);
                                let _e4565 = ((_e4546 * _e4562) - (_e4547 * _e4561));
                                let _e4568 = ((_e4547 * _e4560) - (_e4545 * _e4562));
                                let _e4571 = ((_e4545 * _e4561) - (_e4546 * _e4560));
                                let _e4574 = local_1.member[0u];
                                let _e4580 = local_1.member_1[0u];
                                let _e4586 = local_1.member_2[0u];
                                let _e4590 = (_e4574[0] - _e4580[0]);
                                let _e4591 = (_e4574[1] - _e4580[1]);
                                let _e4592 = (_e4574[2] - _e4580[2]);
                                let _e4593 = (_e1644.member == 0u);
                                let _e4597 = select((_e4590 - _e4586[0]), _e4574[0], _e4593);
                                let _e4598 = select((_e4591 - _e4586[1]), _e4574[1], _e4593);
                                let _e4599 = select((_e4592 - _e4586[2]), _e4574[2], _e4593);
                                let _e4600 = (_e4574[0] - _e4586[0]);
                                let _e4601 = (_e4574[1] - _e4586[1]);
                                let _e4602 = (_e4574[2] - _e4586[2]);
                                let _e4605 = local_1.member[1u];
                                let _e4611 = local_1.member_1[1u];
                                let _e4617 = local_1.member_2[1u];
                                let _e4621 = (_e4605[0] - _e4611[0]);
                                let _e4622 = (_e4605[1] - _e4611[1]);
                                let _e4623 = (_e4605[2] - _e4611[2]);
                                let _e4624 = (_e1644.member == 0u);
                                let _e4628 = select((_e4621 - _e4617[0]), _e4605[0], _e4624);
                                let _e4629 = select((_e4622 - _e4617[1]), _e4605[1], _e4624);
                                let _e4630 = select((_e4623 - _e4617[2]), _e4605[2], _e4624);
                                let _e4631 = (_e4605[0] - _e4617[0]);
                                let _e4632 = (_e4605[1] - _e4617[1]);
                                let _e4633 = (_e4605[2] - _e4617[2]);
                                let _e4636 = local_1.member[0u];
                                let _e4642 = select(_e4636[0], -(_e4636[0]), (_e4636[0] < 0f));
                                let _e4645 = select(_e4636[1], -(_e4636[1]), (_e4636[1] < 0f));
                                let _e4647 = select(_e4645, _e4642, (_e4642 > _e4645));
                                let _e4650 = select(_e4636[2], -(_e4636[2]), (_e4636[2] < 0f));
                                let _e4652 = select(_e4650, _e4647, (_e4647 > _e4650));
                                let _e4655 = local_1.member[1u];
                                let _e4661 = select(_e4655[0], -(_e4655[0]), (_e4655[0] < 0f));
                                let _e4664 = select(_e4655[1], -(_e4655[1]), (_e4655[1] < 0f));
                                let _e4666 = select(_e4664, _e4661, (_e4661 > _e4664));
                                let _e4669 = select(_e4655[2], -(_e4655[2]), (_e4655[2] < 0f));
                                let _e4671 = select(_e4669, _e4666, (_e4666 > _e4669));
                                let _e4675 = local_1.member_3;
                                let _e4679 = local_1.member_1[0u];
                                let _e4685 = select(_e4679[0], -(_e4679[0]), (_e4679[0] < 0f));
                                let _e4688 = select(_e4679[1], -(_e4679[1]), (_e4679[1] < 0f));
                                let _e4690 = select(_e4688, _e4685, (_e4685 > _e4688));
                                let _e4693 = select(_e4679[2], -(_e4679[2]), (_e4679[2] < 0f));
                                let _e4695 = select(_e4693, _e4690, (_e4690 > _e4693));
                                let _e4698 = local_1.member_1[1u];
                                let _e4704 = select(_e4698[0], -(_e4698[0]), (_e4698[0] < 0f));
                                let _e4707 = select(_e4698[1], -(_e4698[1]), (_e4698[1] < 0f));
                                let _e4709 = select(_e4707, _e4704, (_e4704 > _e4707));
                                let _e4712 = select(_e4698[2], -(_e4698[2]), (_e4698[2] < 0f));
                                let _e4714 = select(_e4712, _e4709, (_e4709 > _e4712));
                                let _e4718 = local_1.member_3;
                                let _e4722 = local_1.member_2[0u];
                                let _e4728 = select(_e4722[0], -(_e4722[0]), (_e4722[0] < 0f));
                                let _e4731 = select(_e4722[1], -(_e4722[1]), (_e4722[1] < 0f));
                                let _e4733 = select(_e4731, _e4728, (_e4728 > _e4731));
                                let _e4736 = select(_e4722[2], -(_e4722[2]), (_e4722[2] < 0f));
                                let _e4738 = select(_e4736, _e4733, (_e4733 > _e4736));
                                let _e4741 = local_1.member_2[1u];
                                let _e4747 = select(_e4741[0], -(_e4741[0]), (_e4741[0] < 0f));
                                let _e4750 = select(_e4741[1], -(_e4741[1]), (_e4741[1] < 0f));
                                let _e4752 = select(_e4750, _e4747, (_e4747 > _e4750));
                                let _e4755 = select(_e4741[2], -(_e4741[2]), (_e4741[2] < 0f));
                                let _e4757 = select(_e4755, _e4752, (_e4752 > _e4755));
                                let _e4761 = local_1.member_3;
                                let _e4765 = ((((select(_e4671, _e4652, (_e4652 > _e4671)) + _e4675) + (select(_e4714, _e4695, (_e4695 > _e4714)) + _e4718)) + (select(_e4757, _e4738, (_e4738 > _e4757)) + _e4761)) * 2f);
                                let _e4768 = local_1.member_3;
                                let _e4772 = (((_e67.member_5 * 1.0001f) + (_e4768 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                let _e4775 = ((_e4568 * _e4547) - (_e4571 * _e4546));
                                let _e4778 = ((_e4571 * _e4545) - (_e4565 * _e4547));
                                let _e4781 = ((_e4565 * _e4546) - (_e4568 * _e4545));
                                let _e4786 = (((_e4775 * _e4574[0]) + (_e4778 * _e4574[1])) + (_e4781 * _e4574[2]));
                                let _e4791 = (((_e4775 * _e4590) + (_e4778 * _e4591)) + (_e4781 * _e4592));
                                let _e4796 = (((_e4775 * _e4600) + (_e4778 * _e4601)) + (_e4781 * _e4602));
                                let _e4801 = (((_e4775 * _e4597) + (_e4778 * _e4598)) + (_e4781 * _e4599));
                                let _e4806 = (((_e4775 * _e4605[0]) + (_e4778 * _e4605[1])) + (_e4781 * _e4605[2]));
                                let _e4811 = (((_e4775 * _e4621) + (_e4778 * _e4622)) + (_e4781 * _e4623));
                                let _e4816 = (((_e4775 * _e4631) + (_e4778 * _e4632)) + (_e4781 * _e4633));
                                let _e4821 = (((_e4775 * _e4628) + (_e4778 * _e4629)) + (_e4781 * _e4630));
                                let _e4823 = select(_e4791, _e4786, (_e4786 < _e4791));
                                let _e4825 = select(_e4801, _e4796, (_e4796 < _e4801));
                                let _e4827 = select(_e4825, _e4823, (_e4823 < _e4825));
                                let _e4829 = select(_e4811, _e4806, (_e4806 < _e4811));
                                let _e4831 = select(_e4821, _e4816, (_e4816 < _e4821));
                                let _e4833 = select(_e4831, _e4829, (_e4829 < _e4831));
                                let _e4835 = select(_e4833, _e4827, (_e4827 < _e4833));
                                let _e4837 = select(_e4791, _e4786, (_e4786 > _e4791));
                                let _e4839 = select(_e4801, _e4796, (_e4796 > _e4801));
                                let _e4841 = select(_e4839, _e4837, (_e4837 > _e4839));
                                let _e4843 = select(_e4811, _e4806, (_e4806 > _e4811));
                                let _e4845 = select(_e4821, _e4816, (_e4816 > _e4821));
                                let _e4847 = select(_e4845, _e4843, (_e4843 > _e4845));
                                let _e4860 = ((select(_e4775, -(_e4775), (_e4775 < 0f)) + select(_e4778, -(_e4778), (_e4778 < 0f))) + select(_e4781, -(_e4781), (_e4781 < 0f)));
                                let _e4865 = -(select(_e4847, _e4841, (_e4841 > _e4847)));
                                let _e4872 = (((select(_e4865, _e4835, (_e4835 > _e4865)) - ((_e4860 * _e4765) * (0.000000059604645f * (17f / 2f)))) - (_e4860 * _e4772)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                let _e4875 = ((_e4568 * _e4562) - (_e4571 * _e4561));
                                let _e4878 = ((_e4571 * _e4560) - (_e4565 * _e4562));
                                let _e4881 = ((_e4565 * _e4561) - (_e4568 * _e4560));
                                let _e4886 = (((_e4875 * _e4574[0]) + (_e4878 * _e4574[1])) + (_e4881 * _e4574[2]));
                                let _e4891 = (((_e4875 * _e4590) + (_e4878 * _e4591)) + (_e4881 * _e4592));
                                let _e4896 = (((_e4875 * _e4600) + (_e4878 * _e4601)) + (_e4881 * _e4602));
                                let _e4901 = (((_e4875 * _e4597) + (_e4878 * _e4598)) + (_e4881 * _e4599));
                                let _e4906 = (((_e4875 * _e4605[0]) + (_e4878 * _e4605[1])) + (_e4881 * _e4605[2]));
                                let _e4911 = (((_e4875 * _e4621) + (_e4878 * _e4622)) + (_e4881 * _e4623));
                                let _e4916 = (((_e4875 * _e4631) + (_e4878 * _e4632)) + (_e4881 * _e4633));
                                let _e4921 = (((_e4875 * _e4628) + (_e4878 * _e4629)) + (_e4881 * _e4630));
                                let _e4923 = select(_e4891, _e4886, (_e4886 < _e4891));
                                let _e4925 = select(_e4901, _e4896, (_e4896 < _e4901));
                                let _e4927 = select(_e4925, _e4923, (_e4923 < _e4925));
                                let _e4929 = select(_e4911, _e4906, (_e4906 < _e4911));
                                let _e4931 = select(_e4921, _e4916, (_e4916 < _e4921));
                                let _e4933 = select(_e4931, _e4929, (_e4929 < _e4931));
                                let _e4935 = select(_e4933, _e4927, (_e4927 < _e4933));
                                let _e4937 = select(_e4891, _e4886, (_e4886 > _e4891));
                                let _e4939 = select(_e4901, _e4896, (_e4896 > _e4901));
                                let _e4941 = select(_e4939, _e4937, (_e4937 > _e4939));
                                let _e4943 = select(_e4911, _e4906, (_e4906 > _e4911));
                                let _e4945 = select(_e4921, _e4916, (_e4916 > _e4921));
                                let _e4947 = select(_e4945, _e4943, (_e4943 > _e4945));
                                let _e4960 = ((select(_e4875, -(_e4875), (_e4875 < 0f)) + select(_e4878, -(_e4878), (_e4878 < 0f))) + select(_e4881, -(_e4881), (_e4881 < 0f)));
                                let _e4965 = -(select(_e4947, _e4941, (_e4941 > _e4947)));
                                let _e4972 = (((select(_e4965, _e4935, (_e4935 > _e4965)) - ((_e4960 * _e4765) * (0.000000059604645f * (17f / 2f)))) - (_e4960 * _e4772)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                let _e4974 = select(_e4972, _e4872, (_e4872 > _e4972));
                                if (_e1644.member == 0u) {
                                    let _e4976 = (_e4560 - _e4545);
                                    let _e4977 = (_e4561 - _e4546);
                                    let _e4978 = (_e4562 - _e4547);
                                    let _e4981 = ((_e4568 * _e4978) - (_e4571 * _e4977));
                                    let _e4984 = ((_e4571 * _e4976) - (_e4565 * _e4978));
                                    let _e4987 = ((_e4565 * _e4977) - (_e4568 * _e4976));
                                    let _e4992 = (((_e4981 * _e4574[0]) + (_e4984 * _e4574[1])) + (_e4987 * _e4574[2]));
                                    let _e4997 = (((_e4981 * _e4590) + (_e4984 * _e4591)) + (_e4987 * _e4592));
                                    let _e5002 = (((_e4981 * _e4600) + (_e4984 * _e4601)) + (_e4987 * _e4602));
                                    let _e5007 = (((_e4981 * _e4597) + (_e4984 * _e4598)) + (_e4987 * _e4599));
                                    let _e5012 = (((_e4981 * _e4605[0]) + (_e4984 * _e4605[1])) + (_e4987 * _e4605[2]));
                                    let _e5017 = (((_e4981 * _e4621) + (_e4984 * _e4622)) + (_e4987 * _e4623));
                                    let _e5022 = (((_e4981 * _e4631) + (_e4984 * _e4632)) + (_e4987 * _e4633));
                                    let _e5027 = (((_e4981 * _e4628) + (_e4984 * _e4629)) + (_e4987 * _e4630));
                                    let _e5029 = select(_e4997, _e4992, (_e4992 < _e4997));
                                    let _e5031 = select(_e5007, _e5002, (_e5002 < _e5007));
                                    let _e5033 = select(_e5031, _e5029, (_e5029 < _e5031));
                                    let _e5035 = select(_e5017, _e5012, (_e5012 < _e5017));
                                    let _e5037 = select(_e5027, _e5022, (_e5022 < _e5027));
                                    let _e5039 = select(_e5037, _e5035, (_e5035 < _e5037));
                                    let _e5041 = select(_e5039, _e5033, (_e5033 < _e5039));
                                    let _e5043 = select(_e4997, _e4992, (_e4992 > _e4997));
                                    let _e5045 = select(_e5007, _e5002, (_e5002 > _e5007));
                                    let _e5047 = select(_e5045, _e5043, (_e5043 > _e5045));
                                    let _e5049 = select(_e5017, _e5012, (_e5012 > _e5017));
                                    let _e5051 = select(_e5027, _e5022, (_e5022 > _e5027));
                                    let _e5053 = select(_e5051, _e5049, (_e5049 > _e5051));
                                    let _e5066 = ((select(_e4981, -(_e4981), (_e4981 < 0f)) + select(_e4984, -(_e4984), (_e4984 < 0f))) + select(_e4987, -(_e4987), (_e4987 < 0f)));
                                    let _e5071 = -(select(_e5053, _e5047, (_e5047 > _e5053)));
                                    let _e5078 = (((select(_e5071, _e5041, (_e5041 > _e5071)) - ((_e5066 * _e4765) * (0.000000059604645f * (17f / 2f)))) - (_e5066 * _e4772)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    phi_8286_ = select(_e5078, _e4974, (_e4974 > _e5078));
                                } else {
                                    phi_8286_ = _e4974;
                                }
                                let _e5082 = phi_8286_;
                                phi_8289_ = (_e4532 || (_e5082 > 0f));
                            }
                            let _e5086 = phi_8289_;
                            phi_8292_ = (_e3424 || ((_e2475 && ((_e3826 > -1f) && (_e3868 > -1f))) && _e5086));
                        }
                        let _e5090 = phi_8292_;
                        if _e5090 {
                        } else {
                            let _e5092 = atomicAdd((&counters[1u]), 1u);
                            kept[_e5092].member = _e1610;
                            kept[_e5092].member_1 = _e1612;
                        }
                        phi_8301_ = true;
                    }
                    let _e5097 = phi_8301_;
                    phi_8302_ = _e5097;
                } else {
                    phi_8302_ = false;
                }
                let _e5099 = phi_8302_;
                continue;
                continuing {
                    phi_2567_ = type_9(select(_e1588.member, (_e1588.member + 1u), _e1591), select(_e1588.member_1, _e1588.member_1, _e1591));
                    break if !(_e5099);
                }
            }
            workgroupBarrier();
            let _e5102 = atomicLoad((&counters[1u]));
            if (_e51 == 0u) {
                if (_e5102 > 0u) {
                    let _e5106 = atomicAdd((&output.member[0u]), _e5102);
                    if ((_e5106 + _e5102) < _e5106) {
                        let _e5110 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[2u]), _e5106);
                    if _e145 {
                        let _e5113 = atomicAdd((&output.member[1u]), _e5102);
                        if ((_e5113 + _e5102) < _e5113) {
                            let _e5117 = atomicAdd((&output.member[3u]), 1u);
                        }
                    }
                }
            }
            workgroupBarrier();
            let _e5119 = atomicLoad((&counters[2u]));
            phi_8345_ = type_9(0u, 4u);
            loop {
                let _e5121 = phi_8345_;
                let _e5124 = (_e5121.member < _e5121.member_1);
                if (bitcast<i32>(select(0u, 1u, _e5124)) != 0i) {
                    let _e5139 = ((select(type_9().member_1, _e5121.member, _e5124) * 128u) + _e51);
                    if (_e5139 >= _e5102) {
                        phi_8404_ = false;
                    } else {
                        let _e5143 = kept[_e5139].member;
                        let _e5145 = kept[_e5139].member_1;
                        let _e5150 = params.member.member_1.member_3;
                        let _e5151 = (_e5119 + _e5139);
                        if (_e5151 < _e5150) {
                            let _e5153 = (2u * _e5151);
                            atomicStore((&output.member[(4u + _e5153)]), _e5143);
                            atomicStore((&output.member[(_e5153 + 5u)]), (_e5145 | (_e146 << bitcast<u32>(31i))));
                        }
                        phi_8404_ = true;
                    }
                    let _e5159 = phi_8404_;
                    phi_8405_ = _e5159;
                } else {
                    phi_8405_ = false;
                }
                let _e5161 = phi_8405_;
                continue;
                continuing {
                    phi_8345_ = type_9(select(_e5121.member, (_e5121.member + 1u), _e5124), select(_e5121.member_1, _e5121.member_1, _e5124));
                    break if !(_e5161);
                }
            }
            workgroupBarrier();
        }
        continue;
        continuing {
            phi_296_ = type_9(select(_e123.member, (_e123.member + 1u), _e126), select(_e123.member_1, _e123.member_1, _e126));
            break if !(_e139);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn filter_pairs(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_2(id, n, lane);
}

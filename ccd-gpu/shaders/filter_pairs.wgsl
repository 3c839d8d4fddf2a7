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
    return select(param, param_1, select((param_1 >= param), true, (param != param)));
}

fn function_1(param_2: f32, param_3: f32) -> f32 {
    return select(param_2, param_3, select((param_3 <= param_2), true, (param_2 != param_2)));
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
    var phi_4807_: f32;
    var phi_7645_: f32;
    var phi_7651_: bool;
    var phi_7660_: bool;
    var phi_7661_: bool;
    var phi_7704_: type_9;
    var phi_7763_: bool;
    var phi_7764_: bool;
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
                                let _e315 = function_1(_e231.member.x, _e246.member.x);
                                let _e316 = function_1(_e231.member.y, _e246.member.y);
                                let _e317 = function_1(_e231.member.z, _e246.member.z);
                                let _e319 = function_(_e231.member.x, _e246.member.x);
                                let _e320 = function_(_e231.member.y, _e246.member.y);
                                let _e321 = function_(_e231.member.z, _e246.member.z);
                                let _e324 = function_1(_e261.member.x, _e276.member.x);
                                let _e325 = function_1(_e261.member.y, _e276.member.y);
                                let _e326 = function_1(_e261.member.z, _e276.member.z);
                                let _e328 = function_(_e261.member.x, _e276.member.x);
                                let _e329 = function_(_e261.member.y, _e276.member.y);
                                let _e330 = function_(_e261.member.z, _e276.member.z);
                                phi_658_ = type_25(array<array<f32, 3>, 2>(array<f32, 3>(_e315, _e316, _e317), array<f32, 3>(_e319, _e320, _e321)), array<array<f32, 3>, 2>(array<f32, 3>(_e324, _e325, _e326), array<f32, 3>(_e328, _e329, _e330)));
                            } else {
                                let _e292 = function_1(_e246.member.x, _e261.member.x);
                                let _e293 = function_1(_e246.member.y, _e261.member.y);
                                let _e294 = function_1(_e246.member.z, _e261.member.z);
                                let _e295 = function_(_e246.member.x, _e261.member.x);
                                let _e296 = function_(_e246.member.y, _e261.member.y);
                                let _e297 = function_(_e246.member.z, _e261.member.z);
                                let _e299 = function_1(_e292, _e276.member.x);
                                let _e300 = function_1(_e293, _e276.member.y);
                                let _e301 = function_1(_e294, _e276.member.z);
                                let _e303 = function_(_e292, _e276.member.x);
                                let _e304 = function_(_e293, _e276.member.y);
                                let _e305 = function_(_e294, _e276.member.z);
                                let _e306 = function_1(_e295, _e276.member.x);
                                let _e307 = function_1(_e296, _e276.member.y);
                                let _e308 = function_1(_e297, _e276.member.z);
                                let _e309 = function_(_e295, _e276.member.x);
                                let _e310 = function_(_e296, _e276.member.y);
                                let _e311 = function_(_e297, _e276.member.z);
                                phi_658_ = type_25(array<array<f32, 3>, 2>(_e289, _e289), array<array<f32, 3>, 2>(array<f32, 3>(_e299, _e300, _e301), array<f32, 3>(_e309, _e310, _e311)));
                            }
                            let _e335 = phi_658_;
                            if (_e226.member != 0u) {
                                let _e360 = function_1(_e231.member_1.x, _e246.member_1.x);
                                let _e361 = function_1(_e231.member_1.y, _e246.member_1.y);
                                let _e362 = function_1(_e231.member_1.z, _e246.member_1.z);
                                let _e364 = function_(_e231.member_1.x, _e246.member_1.x);
                                let _e365 = function_(_e231.member_1.y, _e246.member_1.y);
                                let _e366 = function_(_e231.member_1.z, _e246.member_1.z);
                                let _e369 = function_1(_e261.member_1.x, _e276.member_1.x);
                                let _e370 = function_1(_e261.member_1.y, _e276.member_1.y);
                                let _e371 = function_1(_e261.member_1.z, _e276.member_1.z);
                                let _e373 = function_(_e261.member_1.x, _e276.member_1.x);
                                let _e374 = function_(_e261.member_1.y, _e276.member_1.y);
                                let _e375 = function_(_e261.member_1.z, _e276.member_1.z);
                                phi_705_ = type_25(array<array<f32, 3>, 2>(array<f32, 3>(_e360, _e361, _e362), array<f32, 3>(_e364, _e365, _e366)), array<array<f32, 3>, 2>(array<f32, 3>(_e369, _e370, _e371), array<f32, 3>(_e373, _e374, _e375)));
                            } else {
                                let _e337 = function_1(_e246.member_1.x, _e261.member_1.x);
                                let _e338 = function_1(_e246.member_1.y, _e261.member_1.y);
                                let _e339 = function_1(_e246.member_1.z, _e261.member_1.z);
                                let _e340 = function_(_e246.member_1.x, _e261.member_1.x);
                                let _e341 = function_(_e246.member_1.y, _e261.member_1.y);
                                let _e342 = function_(_e246.member_1.z, _e261.member_1.z);
                                let _e344 = function_1(_e337, _e276.member_1.x);
                                let _e345 = function_1(_e338, _e276.member_1.y);
                                let _e346 = function_1(_e339, _e276.member_1.z);
                                let _e348 = function_(_e337, _e276.member_1.x);
                                let _e349 = function_(_e338, _e276.member_1.y);
                                let _e350 = function_(_e339, _e276.member_1.z);
                                let _e351 = function_1(_e340, _e276.member_1.x);
                                let _e352 = function_1(_e341, _e276.member_1.y);
                                let _e353 = function_1(_e342, _e276.member_1.z);
                                let _e354 = function_(_e340, _e276.member_1.x);
                                let _e355 = function_(_e341, _e276.member_1.y);
                                let _e356 = function_(_e342, _e276.member_1.z);
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
                        phi_7660_ = false;
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
                        let _e2494 = local.member_1[1u];
                        let _e2498 = (_e2488[0] + _e2494[0]);
                        let _e2499 = (_e2488[1] + _e2494[1]);
                        let _e2500 = (_e2488[2] + _e2494[2]);
                        let _e2503 = local.member_2[0u];
                        let _e2509 = local.member_2[1u];
                        let _e2513 = (_e2503[0] + _e2509[0]);
                        let _e2514 = (_e2503[1] + _e2509[1]);
                        let _e2515 = (_e2503[2] + _e2509[2]);
                        let _e2518 = ((_e2499 * _e2515) - (_e2500 * _e2514));
                        let _e2521 = ((_e2500 * _e2513) - (_e2498 * _e2515));
                        let _e2524 = ((_e2498 * _e2514) - (_e2499 * _e2513));
                        let _e2527 = local.member[0u];
                        let _e2533 = local.member_1[0u];
                        let _e2539 = local.member_2[0u];
                        let _e2543 = (_e2527[0] - _e2533[0]);
                        let _e2544 = (_e2527[1] - _e2533[1]);
                        let _e2545 = (_e2527[2] - _e2533[2]);
                        let _e2546 = (_e1644.member == 0u);
                        let _e2550 = select((_e2543 - _e2539[0]), _e2527[0], _e2546);
                        let _e2551 = select((_e2544 - _e2539[1]), _e2527[1], _e2546);
                        let _e2552 = select((_e2545 - _e2539[2]), _e2527[2], _e2546);
                        let _e2553 = (_e2527[0] - _e2539[0]);
                        let _e2554 = (_e2527[1] - _e2539[1]);
                        let _e2555 = (_e2527[2] - _e2539[2]);
                        let _e2558 = local.member[1u];
                        let _e2564 = local.member_1[1u];
                        let _e2570 = local.member_2[1u];
                        let _e2574 = (_e2558[0] - _e2564[0]);
                        let _e2575 = (_e2558[1] - _e2564[1]);
                        let _e2576 = (_e2558[2] - _e2564[2]);
                        let _e2577 = (_e1644.member == 0u);
                        let _e2581 = select((_e2574 - _e2570[0]), _e2558[0], _e2577);
                        let _e2582 = select((_e2575 - _e2570[1]), _e2558[1], _e2577);
                        let _e2583 = select((_e2576 - _e2570[2]), _e2558[2], _e2577);
                        let _e2584 = (_e2558[0] - _e2570[0]);
                        let _e2585 = (_e2558[1] - _e2570[1]);
                        let _e2586 = (_e2558[2] - _e2570[2]);
                        let _e2589 = local.member[0u];
                        let _e2595 = select(_e2589[0], -(_e2589[0]), (_e2589[0] < 0f));
                        let _e2598 = select(_e2589[1], -(_e2589[1]), (_e2589[1] < 0f));
                        let _e2600 = select(_e2598, _e2595, (_e2595 > _e2598));
                        let _e2603 = select(_e2589[2], -(_e2589[2]), (_e2589[2] < 0f));
                        let _e2605 = select(_e2603, _e2600, (_e2600 > _e2603));
                        let _e2608 = local.member[1u];
                        let _e2614 = select(_e2608[0], -(_e2608[0]), (_e2608[0] < 0f));
                        let _e2617 = select(_e2608[1], -(_e2608[1]), (_e2608[1] < 0f));
                        let _e2619 = select(_e2617, _e2614, (_e2614 > _e2617));
                        let _e2622 = select(_e2608[2], -(_e2608[2]), (_e2608[2] < 0f));
                        let _e2624 = select(_e2622, _e2619, (_e2619 > _e2622));
                        let _e2628 = local.member_3;
                        let _e2632 = local.member_1[0u];
                        let _e2638 = select(_e2632[0], -(_e2632[0]), (_e2632[0] < 0f));
                        let _e2641 = select(_e2632[1], -(_e2632[1]), (_e2632[1] < 0f));
                        let _e2643 = select(_e2641, _e2638, (_e2638 > _e2641));
                        let _e2646 = select(_e2632[2], -(_e2632[2]), (_e2632[2] < 0f));
                        let _e2648 = select(_e2646, _e2643, (_e2643 > _e2646));
                        let _e2651 = local.member_1[1u];
                        let _e2657 = select(_e2651[0], -(_e2651[0]), (_e2651[0] < 0f));
                        let _e2660 = select(_e2651[1], -(_e2651[1]), (_e2651[1] < 0f));
                        let _e2662 = select(_e2660, _e2657, (_e2657 > _e2660));
                        let _e2665 = select(_e2651[2], -(_e2651[2]), (_e2651[2] < 0f));
                        let _e2667 = select(_e2665, _e2662, (_e2662 > _e2665));
                        let _e2671 = local.member_3;
                        let _e2675 = local.member_2[0u];
                        let _e2681 = select(_e2675[0], -(_e2675[0]), (_e2675[0] < 0f));
                        let _e2684 = select(_e2675[1], -(_e2675[1]), (_e2675[1] < 0f));
                        let _e2686 = select(_e2684, _e2681, (_e2681 > _e2684));
                        let _e2689 = select(_e2675[2], -(_e2675[2]), (_e2675[2] < 0f));
                        let _e2691 = select(_e2689, _e2686, (_e2686 > _e2689));
                        let _e2694 = local.member_2[1u];
                        let _e2700 = select(_e2694[0], -(_e2694[0]), (_e2694[0] < 0f));
                        let _e2703 = select(_e2694[1], -(_e2694[1]), (_e2694[1] < 0f));
                        let _e2705 = select(_e2703, _e2700, (_e2700 > _e2703));
                        let _e2708 = select(_e2694[2], -(_e2694[2]), (_e2694[2] < 0f));
                        let _e2710 = select(_e2708, _e2705, (_e2705 > _e2708));
                        let _e2714 = local.member_3;
                        let _e2718 = ((((select(_e2624, _e2605, (_e2605 > _e2624)) + _e2628) + (select(_e2667, _e2648, (_e2648 > _e2667)) + _e2671)) + (select(_e2710, _e2691, (_e2691 > _e2710)) + _e2714)) * 2f);
                        let _e2721 = local.member_3;
                        let _e2725 = (((_e67.member_5 * 1.0001f) + (_e2721 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                        let _e2728 = ((_e2521 * _e2500) - (_e2524 * _e2499));
                        let _e2731 = ((_e2524 * _e2498) - (_e2518 * _e2500));
                        let _e2734 = ((_e2518 * _e2499) - (_e2521 * _e2498));
                        let _e2739 = (((_e2728 * _e2527[0]) + (_e2731 * _e2527[1])) + (_e2734 * _e2527[2]));
                        let _e2744 = (((_e2728 * _e2543) + (_e2731 * _e2544)) + (_e2734 * _e2545));
                        let _e2749 = (((_e2728 * _e2553) + (_e2731 * _e2554)) + (_e2734 * _e2555));
                        let _e2754 = (((_e2728 * _e2550) + (_e2731 * _e2551)) + (_e2734 * _e2552));
                        let _e2759 = (((_e2728 * _e2558[0]) + (_e2731 * _e2558[1])) + (_e2734 * _e2558[2]));
                        let _e2764 = (((_e2728 * _e2574) + (_e2731 * _e2575)) + (_e2734 * _e2576));
                        let _e2769 = (((_e2728 * _e2584) + (_e2731 * _e2585)) + (_e2734 * _e2586));
                        let _e2774 = (((_e2728 * _e2581) + (_e2731 * _e2582)) + (_e2734 * _e2583));
                        let _e2776 = select(_e2744, _e2739, (_e2739 < _e2744));
                        let _e2778 = select(_e2754, _e2749, (_e2749 < _e2754));
                        let _e2780 = select(_e2778, _e2776, (_e2776 < _e2778));
                        let _e2782 = select(_e2764, _e2759, (_e2759 < _e2764));
                        let _e2784 = select(_e2774, _e2769, (_e2769 < _e2774));
                        let _e2786 = select(_e2784, _e2782, (_e2782 < _e2784));
                        let _e2788 = select(_e2786, _e2780, (_e2780 < _e2786));
                        let _e2790 = select(_e2744, _e2739, (_e2739 > _e2744));
                        let _e2792 = select(_e2754, _e2749, (_e2749 > _e2754));
                        let _e2794 = select(_e2792, _e2790, (_e2790 > _e2792));
                        let _e2796 = select(_e2764, _e2759, (_e2759 > _e2764));
                        let _e2798 = select(_e2774, _e2769, (_e2769 > _e2774));
                        let _e2800 = select(_e2798, _e2796, (_e2796 > _e2798));
                        let _e2813 = ((select(_e2728, -(_e2728), (_e2728 < 0f)) + select(_e2731, -(_e2731), (_e2731 < 0f))) + select(_e2734, -(_e2734), (_e2734 < 0f)));
                        let _e2818 = -(select(_e2800, _e2794, (_e2794 > _e2800)));
                        let _e2825 = (((select(_e2818, _e2788, (_e2788 > _e2818)) - ((_e2813 * _e2718) * (0.000000059604645f * (17f / 2f)))) - (_e2813 * _e2725)) - (0.000000000000000000000000000000000000011754944f * 64f));
                        let _e2828 = ((_e2521 * _e2515) - (_e2524 * _e2514));
                        let _e2831 = ((_e2524 * _e2513) - (_e2518 * _e2515));
                        let _e2834 = ((_e2518 * _e2514) - (_e2521 * _e2513));
                        let _e2839 = (((_e2828 * _e2527[0]) + (_e2831 * _e2527[1])) + (_e2834 * _e2527[2]));
                        let _e2844 = (((_e2828 * _e2543) + (_e2831 * _e2544)) + (_e2834 * _e2545));
                        let _e2849 = (((_e2828 * _e2553) + (_e2831 * _e2554)) + (_e2834 * _e2555));
                        let _e2854 = (((_e2828 * _e2550) + (_e2831 * _e2551)) + (_e2834 * _e2552));
                        let _e2859 = (((_e2828 * _e2558[0]) + (_e2831 * _e2558[1])) + (_e2834 * _e2558[2]));
                        let _e2864 = (((_e2828 * _e2574) + (_e2831 * _e2575)) + (_e2834 * _e2576));
                        let _e2869 = (((_e2828 * _e2584) + (_e2831 * _e2585)) + (_e2834 * _e2586));
                        let _e2874 = (((_e2828 * _e2581) + (_e2831 * _e2582)) + (_e2834 * _e2583));
                        let _e2876 = select(_e2844, _e2839, (_e2839 < _e2844));
                        let _e2878 = select(_e2854, _e2849, (_e2849 < _e2854));
                        let _e2880 = select(_e2878, _e2876, (_e2876 < _e2878));
                        let _e2882 = select(_e2864, _e2859, (_e2859 < _e2864));
                        let _e2884 = select(_e2874, _e2869, (_e2869 < _e2874));
                        let _e2886 = select(_e2884, _e2882, (_e2882 < _e2884));
                        let _e2888 = select(_e2886, _e2880, (_e2880 < _e2886));
                        let _e2890 = select(_e2844, _e2839, (_e2839 > _e2844));
                        let _e2892 = select(_e2854, _e2849, (_e2849 > _e2854));
                        let _e2894 = select(_e2892, _e2890, (_e2890 > _e2892));
                        let _e2896 = select(_e2864, _e2859, (_e2859 > _e2864));
                        let _e2898 = select(_e2874, _e2869, (_e2869 > _e2874));
                        let _e2900 = select(_e2898, _e2896, (_e2896 > _e2898));
                        let _e2913 = ((select(_e2828, -(_e2828), (_e2828 < 0f)) + select(_e2831, -(_e2831), (_e2831 < 0f))) + select(_e2834, -(_e2834), (_e2834 < 0f)));
                        let _e2918 = -(select(_e2900, _e2894, (_e2894 > _e2900)));
                        let _e2925 = (((select(_e2918, _e2888, (_e2888 > _e2918)) - ((_e2913 * _e2718) * (0.000000059604645f * (17f / 2f)))) - (_e2913 * _e2725)) - (0.000000000000000000000000000000000000011754944f * 64f));
                        let _e2927 = select(_e2925, _e2825, (_e2825 > _e2925));
                        if (_e1644.member == 0u) {
                            let _e2929 = (_e2513 - _e2498);
                            let _e2930 = (_e2514 - _e2499);
                            let _e2931 = (_e2515 - _e2500);
                            let _e2934 = ((_e2521 * _e2931) - (_e2524 * _e2930));
                            let _e2937 = ((_e2524 * _e2929) - (_e2518 * _e2931));
                            let _e2940 = ((_e2518 * _e2930) - (_e2521 * _e2929));
                            let _e2945 = (((_e2934 * _e2527[0]) + (_e2937 * _e2527[1])) + (_e2940 * _e2527[2]));
                            let _e2950 = (((_e2934 * _e2543) + (_e2937 * _e2544)) + (_e2940 * _e2545));
                            let _e2955 = (((_e2934 * _e2553) + (_e2937 * _e2554)) + (_e2940 * _e2555));
                            let _e2960 = (((_e2934 * _e2550) + (_e2937 * _e2551)) + (_e2940 * _e2552));
                            let _e2965 = (((_e2934 * _e2558[0]) + (_e2937 * _e2558[1])) + (_e2940 * _e2558[2]));
                            let _e2970 = (((_e2934 * _e2574) + (_e2937 * _e2575)) + (_e2940 * _e2576));
                            let _e2975 = (((_e2934 * _e2584) + (_e2937 * _e2585)) + (_e2940 * _e2586));
                            let _e2980 = (((_e2934 * _e2581) + (_e2937 * _e2582)) + (_e2940 * _e2583));
                            let _e2982 = select(_e2950, _e2945, (_e2945 < _e2950));
                            let _e2984 = select(_e2960, _e2955, (_e2955 < _e2960));
                            let _e2986 = select(_e2984, _e2982, (_e2982 < _e2984));
                            let _e2988 = select(_e2970, _e2965, (_e2965 < _e2970));
                            let _e2990 = select(_e2980, _e2975, (_e2975 < _e2980));
                            let _e2992 = select(_e2990, _e2988, (_e2988 < _e2990));
                            let _e2994 = select(_e2992, _e2986, (_e2986 < _e2992));
                            let _e2996 = select(_e2950, _e2945, (_e2945 > _e2950));
                            let _e2998 = select(_e2960, _e2955, (_e2955 > _e2960));
                            let _e3000 = select(_e2998, _e2996, (_e2996 > _e2998));
                            let _e3002 = select(_e2970, _e2965, (_e2965 > _e2970));
                            let _e3004 = select(_e2980, _e2975, (_e2975 > _e2980));
                            let _e3006 = select(_e3004, _e3002, (_e3002 > _e3004));
                            let _e3019 = ((select(_e2934, -(_e2934), (_e2934 < 0f)) + select(_e2937, -(_e2937), (_e2937 < 0f))) + select(_e2940, -(_e2940), (_e2940 < 0f)));
                            let _e3024 = -(select(_e3006, _e3000, (_e3000 > _e3006)));
                            let _e3031 = (((select(_e3024, _e2994, (_e2994 > _e3024)) - ((_e3019 * _e2718) * (0.000000059604645f * (17f / 2f)))) - (_e3019 * _e2725)) - (0.000000000000000000000000000000000000011754944f * 64f));
                            phi_4807_ = select(_e3031, _e2927, (_e2927 > _e3031));
                        } else {
                            phi_4807_ = _e2927;
                        }
                        let _e3035 = phi_4807_;
                        let _e3037 = (_e2475 && (_e3035 > 0f));
                        if _e3037 {
                            phi_7651_ = _e3037;
                        } else {
                            let _e3040 = local.member_1[0u];
                            let _e3046 = local.member_2[0u];
                            let _e3052 = ((_e3040[1] * _e3046[2]) - (_e3040[2] * _e3046[1]));
                            let _e3055 = ((_e3040[2] * _e3046[0]) - (_e3040[0] * _e3046[2]));
                            let _e3058 = ((_e3040[0] * _e3046[1]) - (_e3040[1] * _e3046[0]));
                            let _e3061 = local.member_1[1u];
                            let _e3067 = local.member_2[1u];
                            let _e3073 = ((_e3061[1] * _e3067[2]) - (_e3061[2] * _e3067[1]));
                            let _e3076 = ((_e3061[2] * _e3067[0]) - (_e3061[0] * _e3067[2]));
                            let _e3079 = ((_e3061[0] * _e3067[1]) - (_e3061[1] * _e3067[0]));
                            let _e3082 = local.member_1[0u];
                            let _e3088 = local.member_2[1u];
                            let _e3103 = local.member_1[1u];
                            let _e3109 = local.member_2[0u];
                            let _e3122 = (((_e3082[1] * _e3088[2]) - (_e3082[2] * _e3088[1])) + ((_e3103[1] * _e3109[2]) - (_e3103[2] * _e3109[1])));
                            let _e3123 = (((_e3082[2] * _e3088[0]) - (_e3082[0] * _e3088[2])) + ((_e3103[2] * _e3109[0]) - (_e3103[0] * _e3109[2])));
                            let _e3124 = (((_e3082[0] * _e3088[1]) - (_e3082[1] * _e3088[0])) + ((_e3103[0] * _e3109[1]) - (_e3103[1] * _e3109[0])));
                            let _e3127 = local.member[0u];
                            let _e3138 = local.member[1u];
                            let _e3149 = local.member[0u];
                            let _e3158 = ((((_e3138[0] * _e3052) + (_e3138[1] * _e3055)) + (_e3138[2] * _e3058)) + (((_e3149[0] * _e3122) + (_e3149[1] * _e3123)) + (_e3149[2] * _e3124)));
                            let _e3161 = local.member[0u];
                            let _e3172 = local.member[1u];
                            let _e3181 = ((((_e3161[0] * _e3073) + (_e3161[1] * _e3076)) + (_e3161[2] * _e3079)) + (((_e3172[0] * _e3122) + (_e3172[1] * _e3123)) + (_e3172[2] * _e3124)));
                            let _e3184 = local.member[1u];
                            let _e3195 = local.member[0u];
                            let _e3201 = select(_e3195[0], -(_e3195[0]), (_e3195[0] < 0f));
                            let _e3204 = select(_e3195[1], -(_e3195[1]), (_e3195[1] < 0f));
                            let _e3206 = select(_e3204, _e3201, (_e3201 > _e3204));
                            let _e3209 = select(_e3195[2], -(_e3195[2]), (_e3195[2] < 0f));
                            let _e3211 = select(_e3209, _e3206, (_e3206 > _e3209));
                            let _e3214 = local.member[1u];
                            let _e3220 = select(_e3214[0], -(_e3214[0]), (_e3214[0] < 0f));
                            let _e3223 = select(_e3214[1], -(_e3214[1]), (_e3214[1] < 0f));
                            let _e3225 = select(_e3223, _e3220, (_e3220 > _e3223));
                            let _e3228 = select(_e3214[2], -(_e3214[2]), (_e3214[2] < 0f));
                            let _e3230 = select(_e3228, _e3225, (_e3225 > _e3228));
                            let _e3234 = local.member_3;
                            let _e3235 = (select(_e3230, _e3211, (_e3211 > _e3230)) + _e3234);
                            let _e3238 = local.member_1[0u];
                            let _e3244 = select(_e3238[0], -(_e3238[0]), (_e3238[0] < 0f));
                            let _e3247 = select(_e3238[1], -(_e3238[1]), (_e3238[1] < 0f));
                            let _e3249 = select(_e3247, _e3244, (_e3244 > _e3247));
                            let _e3252 = select(_e3238[2], -(_e3238[2]), (_e3238[2] < 0f));
                            let _e3254 = select(_e3252, _e3249, (_e3249 > _e3252));
                            let _e3257 = local.member_1[1u];
                            let _e3263 = select(_e3257[0], -(_e3257[0]), (_e3257[0] < 0f));
                            let _e3266 = select(_e3257[1], -(_e3257[1]), (_e3257[1] < 0f));
                            let _e3268 = select(_e3266, _e3263, (_e3263 > _e3266));
                            let _e3271 = select(_e3257[2], -(_e3257[2]), (_e3257[2] < 0f));
                            let _e3273 = select(_e3271, _e3268, (_e3268 > _e3271));
                            let _e3277 = local.member_3;
                            let _e3278 = (select(_e3273, _e3254, (_e3254 > _e3273)) + _e3277);
                            let _e3281 = local.member_2[0u];
                            let _e3287 = select(_e3281[0], -(_e3281[0]), (_e3281[0] < 0f));
                            let _e3290 = select(_e3281[1], -(_e3281[1]), (_e3281[1] < 0f));
                            let _e3292 = select(_e3290, _e3287, (_e3287 > _e3290));
                            let _e3295 = select(_e3281[2], -(_e3281[2]), (_e3281[2] < 0f));
                            let _e3297 = select(_e3295, _e3292, (_e3292 > _e3295));
                            let _e3300 = local.member_2[1u];
                            let _e3306 = select(_e3300[0], -(_e3300[0]), (_e3300[0] < 0f));
                            let _e3309 = select(_e3300[1], -(_e3300[1]), (_e3300[1] < 0f));
                            let _e3311 = select(_e3309, _e3306, (_e3306 > _e3309));
                            let _e3314 = select(_e3300[2], -(_e3300[2]), (_e3300[2] < 0f));
                            let _e3316 = select(_e3314, _e3311, (_e3311 > _e3314));
                            let _e3320 = local.member_3;
                            let _e3321 = (select(_e3316, _e3297, (_e3297 > _e3316)) + _e3320);
                            let _e3323 = ((_e3278 * 8f) * _e3321);
                            let _e3330 = local.member_3;
                            let _e3354 = ((select(_e3052, -(_e3052), (_e3052 < 0f)) + select(_e3055, -(_e3055), (_e3055 < 0f))) + select(_e3058, -(_e3058), (_e3058 < 0f)));
                            let _e3365 = ((select(_e3073, -(_e3073), (_e3073 < 0f)) + select(_e3076, -(_e3076), (_e3076 < 0f))) + select(_e3079, -(_e3079), (_e3079 < 0f)));
                            let _e3367 = select(_e3365, _e3354, (_e3354 > _e3365));
                            let _e3379 = (((select(_e3122, -(_e3122), (_e3122 < 0f)) + select(_e3123, -(_e3123), (_e3123 < 0f))) + select(_e3124, -(_e3124), (_e3124 < 0f))) * 0.5f);
                            let _e3386 = local.member_3;
                            let _e3399 = ((((_e3127[0] * _e3052) + (_e3127[1] * _e3055)) + (_e3127[2] * _e3058)) * 3f);
                            let _e3400 = ((((_e3184[0] * _e3073) + (_e3184[1] * _e3076)) + (_e3184[2] * _e3079)) * 3f);
                            let _e3402 = select(_e3400, _e3399, (_e3399 < _e3400));
                            let _e3404 = select(_e3181, _e3158, (_e3158 < _e3181));
                            let _e3406 = select(_e3404, _e3402, (_e3402 < _e3404));
                            let _e3408 = select(_e3400, _e3399, (_e3399 > _e3400));
                            let _e3410 = select(_e3181, _e3158, (_e3158 > _e3181));
                            let _e3413 = -(select(_e3410, _e3408, (_e3408 > _e3410)));
                            let _e3425 = local.member_1[0u];
                            let _e3431 = local.member_2[0u];
                            let _e3437 = ((_e3425[1] * _e3431[2]) - (_e3425[2] * _e3431[1]));
                            let _e3440 = ((_e3425[2] * _e3431[0]) - (_e3425[0] * _e3431[2]));
                            let _e3443 = ((_e3425[0] * _e3431[1]) - (_e3425[1] * _e3431[0]));
                            let _e3446 = local.member_1[1u];
                            let _e3452 = local.member_2[1u];
                            let _e3458 = ((_e3446[1] * _e3452[2]) - (_e3446[2] * _e3452[1]));
                            let _e3461 = ((_e3446[2] * _e3452[0]) - (_e3446[0] * _e3452[2]));
                            let _e3464 = ((_e3446[0] * _e3452[1]) - (_e3446[1] * _e3452[0]));
                            let _e3467 = local.member_1[0u];
                            let _e3473 = local.member_2[1u];
                            let _e3488 = local.member_1[1u];
                            let _e3494 = local.member_2[0u];
                            let _e3507 = (((_e3467[1] * _e3473[2]) - (_e3467[2] * _e3473[1])) + ((_e3488[1] * _e3494[2]) - (_e3488[2] * _e3494[1])));
                            let _e3508 = (((_e3467[2] * _e3473[0]) - (_e3467[0] * _e3473[2])) + ((_e3488[2] * _e3494[0]) - (_e3488[0] * _e3494[2])));
                            let _e3509 = (((_e3467[0] * _e3473[1]) - (_e3467[1] * _e3473[0])) + ((_e3488[0] * _e3494[1]) - (_e3488[1] * _e3494[0])));
                            let _e3512 = local.member[0u];
                            let _e3523 = local.member[1u];
                            let _e3534 = local.member[0u];
                            let _e3543 = ((((_e3523[0] * _e3437) + (_e3523[1] * _e3440)) + (_e3523[2] * _e3443)) + (((_e3534[0] * _e3507) + (_e3534[1] * _e3508)) + (_e3534[2] * _e3509)));
                            let _e3546 = local.member[0u];
                            let _e3557 = local.member[1u];
                            let _e3566 = ((((_e3546[0] * _e3458) + (_e3546[1] * _e3461)) + (_e3546[2] * _e3464)) + (((_e3557[0] * _e3507) + (_e3557[1] * _e3508)) + (_e3557[2] * _e3509)));
                            let _e3569 = local.member[1u];
                            let _e3580 = local.member[0u];
                            let _e3586 = select(_e3580[0], -(_e3580[0]), (_e3580[0] < 0f));
                            let _e3589 = select(_e3580[1], -(_e3580[1]), (_e3580[1] < 0f));
                            let _e3591 = select(_e3589, _e3586, (_e3586 > _e3589));
                            let _e3594 = select(_e3580[2], -(_e3580[2]), (_e3580[2] < 0f));
                            let _e3596 = select(_e3594, _e3591, (_e3591 > _e3594));
                            let _e3599 = local.member[1u];
                            let _e3605 = select(_e3599[0], -(_e3599[0]), (_e3599[0] < 0f));
                            let _e3608 = select(_e3599[1], -(_e3599[1]), (_e3599[1] < 0f));
                            let _e3610 = select(_e3608, _e3605, (_e3605 > _e3608));
                            let _e3613 = select(_e3599[2], -(_e3599[2]), (_e3599[2] < 0f));
                            let _e3615 = select(_e3613, _e3610, (_e3610 > _e3613));
                            let _e3619 = local.member_3;
                            let _e3620 = (select(_e3615, _e3596, (_e3596 > _e3615)) + _e3619);
                            let _e3623 = local.member_1[0u];
                            let _e3629 = select(_e3623[0], -(_e3623[0]), (_e3623[0] < 0f));
                            let _e3632 = select(_e3623[1], -(_e3623[1]), (_e3623[1] < 0f));
                            let _e3634 = select(_e3632, _e3629, (_e3629 > _e3632));
                            let _e3637 = select(_e3623[2], -(_e3623[2]), (_e3623[2] < 0f));
                            let _e3639 = select(_e3637, _e3634, (_e3634 > _e3637));
                            let _e3642 = local.member_1[1u];
                            let _e3648 = select(_e3642[0], -(_e3642[0]), (_e3642[0] < 0f));
                            let _e3651 = select(_e3642[1], -(_e3642[1]), (_e3642[1] < 0f));
                            let _e3653 = select(_e3651, _e3648, (_e3648 > _e3651));
                            let _e3656 = select(_e3642[2], -(_e3642[2]), (_e3642[2] < 0f));
                            let _e3658 = select(_e3656, _e3653, (_e3653 > _e3656));
                            let _e3662 = local.member_3;
                            let _e3663 = (select(_e3658, _e3639, (_e3639 > _e3658)) + _e3662);
                            let _e3666 = local.member_2[0u];
                            let _e3672 = select(_e3666[0], -(_e3666[0]), (_e3666[0] < 0f));
                            let _e3675 = select(_e3666[1], -(_e3666[1]), (_e3666[1] < 0f));
                            let _e3677 = select(_e3675, _e3672, (_e3672 > _e3675));
                            let _e3680 = select(_e3666[2], -(_e3666[2]), (_e3666[2] < 0f));
                            let _e3682 = select(_e3680, _e3677, (_e3677 > _e3680));
                            let _e3685 = local.member_2[1u];
                            let _e3691 = select(_e3685[0], -(_e3685[0]), (_e3685[0] < 0f));
                            let _e3694 = select(_e3685[1], -(_e3685[1]), (_e3685[1] < 0f));
                            let _e3696 = select(_e3694, _e3691, (_e3691 > _e3694));
                            let _e3699 = select(_e3685[2], -(_e3685[2]), (_e3685[2] < 0f));
                            let _e3701 = select(_e3699, _e3696, (_e3696 > _e3699));
                            let _e3705 = local.member_3;
                            let _e3706 = (select(_e3701, _e3682, (_e3682 > _e3701)) + _e3705);
                            let _e3708 = ((_e3663 * 8f) * _e3706);
                            let _e3715 = local.member_3;
                            let _e3739 = ((select(_e3437, -(_e3437), (_e3437 < 0f)) + select(_e3440, -(_e3440), (_e3440 < 0f))) + select(_e3443, -(_e3443), (_e3443 < 0f)));
                            let _e3750 = ((select(_e3458, -(_e3458), (_e3458 < 0f)) + select(_e3461, -(_e3461), (_e3461 < 0f))) + select(_e3464, -(_e3464), (_e3464 < 0f)));
                            let _e3752 = select(_e3750, _e3739, (_e3739 > _e3750));
                            let _e3764 = (((select(_e3507, -(_e3507), (_e3507 < 0f)) + select(_e3508, -(_e3508), (_e3508 < 0f))) + select(_e3509, -(_e3509), (_e3509 < 0f))) * 0.5f);
                            let _e3771 = local.member_3;
                            let _e3784 = ((((_e3512[0] * _e3437) + (_e3512[1] * _e3440)) + (_e3512[2] * _e3443)) * 3f);
                            let _e3785 = ((((_e3569[0] * _e3458) + (_e3569[1] * _e3461)) + (_e3569[2] * _e3464)) * 3f);
                            let _e3789 = ((((((_e3620 * 8f) * _e3708) * (0.000000059604645f * (524f / 64f))) + ((_e3715 * 19f) * ((_e3620 * (_e3663 + _e3706)) + (_e3663 * _e3706)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3620) * ((1f + _e3663) * (1f + _e3706))))) + ((_e67.member_5 * (((select(_e3764, _e3752, (_e3752 > _e3764)) + (_e3708 * (0.000000059604645f * 8f))) + ((_e3771 * 6f) * (_e3663 + _e3706))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3663) * (1f + _e3706))))) * (3f * 1.0001f)));
                            let _e3791 = ((_e3543 - _e3784) * 3f);
                            let _e3793 = ((_e3566 - _e3784) * 1.5f);
                            let _e3794 = (_e3785 - _e3784);
                            let _e3796 = select(_e3793, _e3791, (_e3791 < _e3793));
                            let _e3799 = -(select(_e3794, _e3796, (_e3796 < _e3794)));
                            let _e3803 = select(_e3793, _e3791, (_e3791 > _e3793));
                            let _e3805 = select(_e3794, _e3803, (_e3803 > _e3794));
                            let _e3808 = (0.000000000000000000000000000000000000011754944f * 8f);
                            let _e3811 = ((_e3784 - _e3789) / (select(0f, _e3799, (_e3799 > 0f)) + _e3808));
                            let _e3815 = ((-(_e3784) - _e3789) / (select(0f, _e3805, (_e3805 > 0f)) + _e3808));
                            let _e3820 = (select(_e3815, _e3811, (_e3811 > _e3815)) * (1f - (0.000000059604645f * 32f)));
                            let _e3822 = select(0f, _e3820, (_e3820 > 0f));
                            let _e3824 = select(1f, _e3822, (_e3822 < 1f));
                            let _e3826 = ((_e3566 - _e3785) * 3f);
                            let _e3828 = ((_e3543 - _e3785) * 1.5f);
                            let _e3829 = (_e3784 - _e3785);
                            let _e3831 = select(_e3828, _e3826, (_e3826 < _e3828));
                            let _e3834 = -(select(_e3829, _e3831, (_e3831 < _e3829)));
                            let _e3838 = select(_e3828, _e3826, (_e3826 > _e3828));
                            let _e3840 = select(_e3829, _e3838, (_e3838 > _e3829));
                            let _e3843 = (0.000000000000000000000000000000000000011754944f * 8f);
                            let _e3846 = ((_e3785 - _e3789) / (select(0f, _e3834, (_e3834 > 0f)) + _e3843));
                            let _e3850 = ((-(_e3785) - _e3789) / (select(0f, _e3840, (_e3840 > 0f)) + _e3843));
                            let _e3855 = (select(_e3850, _e3846, (_e3846 > _e3850)) * (1f - (0.000000059604645f * 32f)));
                            let _e3857 = select(0f, _e3855, (_e3855 > 0f));
                            let _e3862 = ((1f - select(1f, _e3857, (_e3857 < 1f))) + (0.000000059604645f * 4f));
                            let _e3864 = select(1f, _e3862, (_e3862 < 1f));
                            let _e3866 = select(1f, _e3864, (_e3864 < 1f));
                            let _e3869 = local.member[0u];
                            let _e3875 = select(_e3869[0], -(_e3869[0]), (_e3869[0] < 0f));
                            let _e3878 = select(_e3869[1], -(_e3869[1]), (_e3869[1] < 0f));
                            let _e3880 = select(_e3878, _e3875, (_e3875 > _e3878));
                            let _e3883 = select(_e3869[2], -(_e3869[2]), (_e3869[2] < 0f));
                            let _e3885 = select(_e3883, _e3880, (_e3880 > _e3883));
                            let _e3888 = local.member[1u];
                            let _e3894 = select(_e3888[0], -(_e3888[0]), (_e3888[0] < 0f));
                            let _e3897 = select(_e3888[1], -(_e3888[1]), (_e3888[1] < 0f));
                            let _e3899 = select(_e3897, _e3894, (_e3894 > _e3897));
                            let _e3902 = select(_e3888[2], -(_e3888[2]), (_e3888[2] < 0f));
                            let _e3904 = select(_e3902, _e3899, (_e3899 > _e3902));
                            let _e3908 = local.member_3;
                            let _e3909 = (select(_e3904, _e3885, (_e3885 > _e3904)) + _e3908);
                            let _e3912 = local.member_1[0u];
                            let _e3918 = select(_e3912[0], -(_e3912[0]), (_e3912[0] < 0f));
                            let _e3921 = select(_e3912[1], -(_e3912[1]), (_e3912[1] < 0f));
                            let _e3923 = select(_e3921, _e3918, (_e3918 > _e3921));
                            let _e3926 = select(_e3912[2], -(_e3912[2]), (_e3912[2] < 0f));
                            let _e3928 = select(_e3926, _e3923, (_e3923 > _e3926));
                            let _e3931 = local.member_1[1u];
                            let _e3937 = select(_e3931[0], -(_e3931[0]), (_e3931[0] < 0f));
                            let _e3940 = select(_e3931[1], -(_e3931[1]), (_e3931[1] < 0f));
                            let _e3942 = select(_e3940, _e3937, (_e3937 > _e3940));
                            let _e3945 = select(_e3931[2], -(_e3931[2]), (_e3931[2] < 0f));
                            let _e3947 = select(_e3945, _e3942, (_e3942 > _e3945));
                            let _e3951 = local.member_3;
                            let _e3952 = (select(_e3947, _e3928, (_e3928 > _e3947)) + _e3951);
                            let _e3955 = local.member_2[0u];
                            let _e3961 = select(_e3955[0], -(_e3955[0]), (_e3955[0] < 0f));
                            let _e3964 = select(_e3955[1], -(_e3955[1]), (_e3955[1] < 0f));
                            let _e3966 = select(_e3964, _e3961, (_e3961 > _e3964));
                            let _e3969 = select(_e3955[2], -(_e3955[2]), (_e3955[2] < 0f));
                            let _e3971 = select(_e3969, _e3966, (_e3966 > _e3969));
                            let _e3974 = local.member_2[1u];
                            let _e3980 = select(_e3974[0], -(_e3974[0]), (_e3974[0] < 0f));
                            let _e3983 = select(_e3974[1], -(_e3974[1]), (_e3974[1] < 0f));
                            let _e3985 = select(_e3983, _e3980, (_e3980 > _e3983));
                            let _e3988 = select(_e3974[2], -(_e3974[2]), (_e3974[2] < 0f));
                            let _e3990 = select(_e3988, _e3985, (_e3985 > _e3988));
                            let _e3994 = local.member_3;
                            let _e3995 = (select(_e3990, _e3971, (_e3971 > _e3990)) + _e3994);
                            let _e3997 = select(_e3952, _e3909, (_e3909 > _e3952));
                            let _e4004 = local.member[0u];
                            let _e4010 = local.member[1u];
                            let _e4025 = local.member[0u];
                            let _e4031 = local.member[1u];
                            let _e4046 = local.member_1[0u];
                            let _e4052 = local.member_1[1u];
                            let _e4067 = local.member_1[0u];
                            let _e4073 = local.member_1[1u];
                            let _e4088 = local.member_2[0u];
                            let _e4094 = local.member_2[1u];
                            let _e4109 = local.member_2[0u];
                            let _e4115 = local.member_2[1u];
                            let _e4129 = local.member_3;
                            local_1 = type_24(array<array<f32, 3>, 2>(array<f32, 3>((_e4004[0] + ((_e4010[0] - _e4004[0]) * _e3824)), (_e4004[1] + ((_e4010[1] - _e4004[1]) * _e3824)), (_e4004[2] + ((_e4010[2] - _e4004[2]) * _e3824))), array<f32, 3>((_e4025[0] + ((_e4031[0] - _e4025[0]) * _e3866)), (_e4025[1] + ((_e4031[1] - _e4025[1]) * _e3866)), (_e4025[2] + ((_e4031[2] - _e4025[2]) * _e3866)))), array<array<f32, 3>, 2>(array<f32, 3>((_e4046[0] + ((_e4052[0] - _e4046[0]) * _e3824)), (_e4046[1] + ((_e4052[1] - _e4046[1]) * _e3824)), (_e4046[2] + ((_e4052[2] - _e4046[2]) * _e3824))), array<f32, 3>((_e4067[0] + ((_e4073[0] - _e4067[0]) * _e3866)), (_e4067[1] + ((_e4073[1] - _e4067[1]) * _e3866)), (_e4067[2] + ((_e4073[2] - _e4067[2]) * _e3866)))), array<array<f32, 3>, 2>(array<f32, 3>((_e4088[0] + ((_e4094[0] - _e4088[0]) * _e3824)), (_e4088[1] + ((_e4094[1] - _e4088[1]) * _e3824)), (_e4088[2] + ((_e4094[2] - _e4088[2]) * _e3824))), array<f32, 3>((_e4109[0] + ((_e4115[0] - _e4109[0]) * _e3866)), (_e4109[1] + ((_e4115[1] - _e4109[1]) * _e3866)), (_e4109[2] + ((_e4115[2] - _e4109[2]) * _e3866)))), ((_e4129 + (select(_e3995, _e3997, (_e3997 > _e3995)) * (0.000000059604645f * 8f))) + (0.000000000000000000000000000000000000011754944f * 8f)));
                            let _e4148 = local_1.member_1[0u];
                            let _e4154 = local_1.member_1[1u];
                            let _e4158 = (_e4148[0] + _e4154[0]);
                            let _e4159 = (_e4148[1] + _e4154[1]);
                            let _e4160 = (_e4148[2] + _e4154[2]);
                            let _e4163 = local_1.member_2[0u];
                            let _e4169 = local_1.member_2[1u];
                            let _e4173 = (_e4163[0] + _e4169[0]);
                            let _e4174 = (_e4163[1] + _e4169[1]);
                            let _e4175 = (_e4163[2] + _e4169[2]);
                            let _e4178 = ((_e4159 * _e4175) - (_e4160 * _e4174));
                            let _e4181 = ((_e4160 * _e4173) - (_e4158 * _e4175));
                            let _e4184 = ((_e4158 * _e4174) - (_e4159 * _e4173));
                            let _e4187 = local_1.member[0u];
                            let _e4193 = local_1.member_1[0u];
                            let _e4199 = local_1.member_2[0u];
                            let _e4203 = (_e4187[0] - _e4193[0]);
                            let _e4204 = (_e4187[1] - _e4193[1]);
                            let _e4205 = (_e4187[2] - _e4193[2]);
                            let _e4206 = (_e1644.member == 0u);
                            let _e4210 = select((_e4203 - _e4199[0]), _e4187[0], _e4206);
                            let _e4211 = select((_e4204 - _e4199[1]), _e4187[1], _e4206);
                            let _e4212 = select((_e4205 - _e4199[2]), _e4187[2], _e4206);
                            let _e4213 = (_e4187[0] - _e4199[0]);
                            let _e4214 = (_e4187[1] - _e4199[1]);
                            let _e4215 = (_e4187[2] - _e4199[2]);
                            let _e4218 = local_1.member[1u];
                            let _e4224 = local_1.member_1[1u];
                            let _e4230 = local_1.member_2[1u];
                            let _e4234 = (_e4218[0] - _e4224[0]);
                            let _e4235 = (_e4218[1] - _e4224[1]);
                            let _e4236 = (_e4218[2] - _e4224[2]);
                            let _e4237 = (_e1644.member == 0u);
                            let _e4241 = select((_e4234 - _e4230[0]), _e4218[0], _e4237);
                            let _e4242 = select((_e4235 - _e4230[1]), _e4218[1], _e4237);
                            let _e4243 = select((_e4236 - _e4230[2]), _e4218[2], _e4237);
                            let _e4244 = (_e4218[0] - _e4230[0]);
                            let _e4245 = (_e4218[1] - _e4230[1]);
                            let _e4246 = (_e4218[2] - _e4230[2]);
                            let _e4249 = local_1.member[0u];
                            let _e4255 = select(_e4249[0], -(_e4249[0]), (_e4249[0] < 0f));
                            let _e4258 = select(_e4249[1], -(_e4249[1]), (_e4249[1] < 0f));
                            let _e4260 = select(_e4258, _e4255, (_e4255 > _e4258));
                            let _e4263 = select(_e4249[2], -(_e4249[2]), (_e4249[2] < 0f));
                            let _e4265 = select(_e4263, _e4260, (_e4260 > _e4263));
                            let _e4268 = local_1.member[1u];
                            let _e4274 = select(_e4268[0], -(_e4268[0]), (_e4268[0] < 0f));
                            let _e4277 = select(_e4268[1], -(_e4268[1]), (_e4268[1] < 0f));
                            let _e4279 = select(_e4277, _e4274, (_e4274 > _e4277));
                            let _e4282 = select(_e4268[2], -(_e4268[2]), (_e4268[2] < 0f));
                            let _e4284 = select(_e4282, _e4279, (_e4279 > _e4282));
                            let _e4288 = local_1.member_3;
                            let _e4292 = local_1.member_1[0u];
                            let _e4298 = select(_e4292[0], -(_e4292[0]), (_e4292[0] < 0f));
                            let _e4301 = select(_e4292[1], -(_e4292[1]), (_e4292[1] < 0f));
                            let _e4303 = select(_e4301, _e4298, (_e4298 > _e4301));
                            let _e4306 = select(_e4292[2], -(_e4292[2]), (_e4292[2] < 0f));
                            let _e4308 = select(_e4306, _e4303, (_e4303 > _e4306));
                            let _e4311 = local_1.member_1[1u];
                            let _e4317 = select(_e4311[0], -(_e4311[0]), (_e4311[0] < 0f));
                            let _e4320 = select(_e4311[1], -(_e4311[1]), (_e4311[1] < 0f));
                            let _e4322 = select(_e4320, _e4317, (_e4317 > _e4320));
                            let _e4325 = select(_e4311[2], -(_e4311[2]), (_e4311[2] < 0f));
                            let _e4327 = select(_e4325, _e4322, (_e4322 > _e4325));
                            let _e4331 = local_1.member_3;
                            let _e4335 = local_1.member_2[0u];
                            let _e4341 = select(_e4335[0], -(_e4335[0]), (_e4335[0] < 0f));
                            let _e4344 = select(_e4335[1], -(_e4335[1]), (_e4335[1] < 0f));
                            let _e4346 = select(_e4344, _e4341, (_e4341 > _e4344));
                            let _e4349 = select(_e4335[2], -(_e4335[2]), (_e4335[2] < 0f));
                            let _e4351 = select(_e4349, _e4346, (_e4346 > _e4349));
                            let _e4354 = local_1.member_2[1u];
                            let _e4360 = select(_e4354[0], -(_e4354[0]), (_e4354[0] < 0f));
                            let _e4363 = select(_e4354[1], -(_e4354[1]), (_e4354[1] < 0f));
                            let _e4365 = select(_e4363, _e4360, (_e4360 > _e4363));
                            let _e4368 = select(_e4354[2], -(_e4354[2]), (_e4354[2] < 0f));
                            let _e4370 = select(_e4368, _e4365, (_e4365 > _e4368));
                            let _e4374 = local_1.member_3;
                            let _e4378 = ((((select(_e4284, _e4265, (_e4265 > _e4284)) + _e4288) + (select(_e4327, _e4308, (_e4308 > _e4327)) + _e4331)) + (select(_e4370, _e4351, (_e4351 > _e4370)) + _e4374)) * 2f);
                            let _e4381 = local_1.member_3;
                            let _e4385 = (((_e67.member_5 * 1.0001f) + (_e4381 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                            let _e4388 = ((_e4181 * _e4160) - (_e4184 * _e4159));
                            let _e4391 = ((_e4184 * _e4158) - (_e4178 * _e4160));
                            let _e4394 = ((_e4178 * _e4159) - (_e4181 * _e4158));
                            let _e4399 = (((_e4388 * _e4187[0]) + (_e4391 * _e4187[1])) + (_e4394 * _e4187[2]));
                            let _e4404 = (((_e4388 * _e4203) + (_e4391 * _e4204)) + (_e4394 * _e4205));
                            let _e4409 = (((_e4388 * _e4213) + (_e4391 * _e4214)) + (_e4394 * _e4215));
                            let _e4414 = (((_e4388 * _e4210) + (_e4391 * _e4211)) + (_e4394 * _e4212));
                            let _e4419 = (((_e4388 * _e4218[0]) + (_e4391 * _e4218[1])) + (_e4394 * _e4218[2]));
                            let _e4424 = (((_e4388 * _e4234) + (_e4391 * _e4235)) + (_e4394 * _e4236));
                            let _e4429 = (((_e4388 * _e4244) + (_e4391 * _e4245)) + (_e4394 * _e4246));
                            let _e4434 = (((_e4388 * _e4241) + (_e4391 * _e4242)) + (_e4394 * _e4243));
                            let _e4436 = select(_e4404, _e4399, (_e4399 < _e4404));
                            let _e4438 = select(_e4414, _e4409, (_e4409 < _e4414));
                            let _e4440 = select(_e4438, _e4436, (_e4436 < _e4438));
                            let _e4442 = select(_e4424, _e4419, (_e4419 < _e4424));
                            let _e4444 = select(_e4434, _e4429, (_e4429 < _e4434));
                            let _e4446 = select(_e4444, _e4442, (_e4442 < _e4444));
                            let _e4448 = select(_e4446, _e4440, (_e4440 < _e4446));
                            let _e4450 = select(_e4404, _e4399, (_e4399 > _e4404));
                            let _e4452 = select(_e4414, _e4409, (_e4409 > _e4414));
                            let _e4454 = select(_e4452, _e4450, (_e4450 > _e4452));
                            let _e4456 = select(_e4424, _e4419, (_e4419 > _e4424));
                            let _e4458 = select(_e4434, _e4429, (_e4429 > _e4434));
                            let _e4460 = select(_e4458, _e4456, (_e4456 > _e4458));
                            let _e4473 = ((select(_e4388, -(_e4388), (_e4388 < 0f)) + select(_e4391, -(_e4391), (_e4391 < 0f))) + select(_e4394, -(_e4394), (_e4394 < 0f)));
                            let _e4478 = -(select(_e4460, _e4454, (_e4454 > _e4460)));
                            let _e4485 = (((select(_e4478, _e4448, (_e4448 > _e4478)) - ((_e4473 * _e4378) * (0.000000059604645f * (17f / 2f)))) - (_e4473 * _e4385)) - (0.000000000000000000000000000000000000011754944f * 64f));
                            let _e4488 = ((_e4181 * _e4175) - (_e4184 * _e4174));
                            let _e4491 = ((_e4184 * _e4173) - (_e4178 * _e4175));
                            let _e4494 = ((_e4178 * _e4174) - (_e4181 * _e4173));
                            let _e4499 = (((_e4488 * _e4187[0]) + (_e4491 * _e4187[1])) + (_e4494 * _e4187[2]));
                            let _e4504 = (((_e4488 * _e4203) + (_e4491 * _e4204)) + (_e4494 * _e4205));
                            let _e4509 = (((_e4488 * _e4213) + (_e4491 * _e4214)) + (_e4494 * _e4215));
                            let _e4514 = (((_e4488 * _e4210) + (_e4491 * _e4211)) + (_e4494 * _e4212));
                            let _e4519 = (((_e4488 * _e4218[0]) + (_e4491 * _e4218[1])) + (_e4494 * _e4218[2]));
                            let _e4524 = (((_e4488 * _e4234) + (_e4491 * _e4235)) + (_e4494 * _e4236));
                            let _e4529 = (((_e4488 * _e4244) + (_e4491 * _e4245)) + (_e4494 * _e4246));
                            let _e4534 = (((_e4488 * _e4241) + (_e4491 * _e4242)) + (_e4494 * _e4243));
                            let _e4536 = select(_e4504, _e4499, (_e4499 < _e4504));
                            let _e4538 = select(_e4514, _e4509, (_e4509 < _e4514));
                            let _e4540 = select(_e4538, _e4536, (_e4536 < _e4538));
                            let _e4542 = select(_e4524, _e4519, (_e4519 < _e4524));
                            let _e4544 = select(_e4534, _e4529, (_e4529 < _e4534));
                            let _e4546 = select(_e4544, _e4542, (_e4542 < _e4544));
                            let _e4548 = select(_e4546, _e4540, (_e4540 < _e4546));
                            let _e4550 = select(_e4504, _e4499, (_e4499 > _e4504));
                            let _e4552 = select(_e4514, _e4509, (_e4509 > _e4514));
                            let _e4554 = select(_e4552, _e4550, (_e4550 > _e4552));
                            let _e4556 = select(_e4524, _e4519, (_e4519 > _e4524));
                            let _e4558 = select(_e4534, _e4529, (_e4529 > _e4534));
                            let _e4560 = select(_e4558, _e4556, (_e4556 > _e4558));
                            let _e4573 = ((select(_e4488, -(_e4488), (_e4488 < 0f)) + select(_e4491, -(_e4491), (_e4491 < 0f))) + select(_e4494, -(_e4494), (_e4494 < 0f)));
                            let _e4578 = -(select(_e4560, _e4554, (_e4554 > _e4560)));
                            let _e4585 = (((select(_e4578, _e4548, (_e4548 > _e4578)) - ((_e4573 * _e4378) * (0.000000059604645f * (17f / 2f)))) - (_e4573 * _e4385)) - (0.000000000000000000000000000000000000011754944f * 64f));
                            let _e4587 = select(_e4585, _e4485, (_e4485 > _e4585));
                            if (_e1644.member == 0u) {
                                let _e4589 = (_e4173 - _e4158);
                                let _e4590 = (_e4174 - _e4159);
                                let _e4591 = (_e4175 - _e4160);
                                let _e4594 = ((_e4181 * _e4591) - (_e4184 * _e4590));
                                let _e4597 = ((_e4184 * _e4589) - (_e4178 * _e4591));
                                let _e4600 = ((_e4178 * _e4590) - (_e4181 * _e4589));
                                let _e4605 = (((_e4594 * _e4187[0]) + (_e4597 * _e4187[1])) + (_e4600 * _e4187[2]));
                                let _e4610 = (((_e4594 * _e4203) + (_e4597 * _e4204)) + (_e4600 * _e4205));
                                let _e4615 = (((_e4594 * _e4213) + (_e4597 * _e4214)) + (_e4600 * _e4215));
                                let _e4620 = (((_e4594 * _e4210) + (_e4597 * _e4211)) + (_e4600 * _e4212));
                                let _e4625 = (((_e4594 * _e4218[0]) + (_e4597 * _e4218[1])) + (_e4600 * _e4218[2]));
                                let _e4630 = (((_e4594 * _e4234) + (_e4597 * _e4235)) + (_e4600 * _e4236));
                                let _e4635 = (((_e4594 * _e4244) + (_e4597 * _e4245)) + (_e4600 * _e4246));
                                let _e4640 = (((_e4594 * _e4241) + (_e4597 * _e4242)) + (_e4600 * _e4243));
                                let _e4642 = select(_e4610, _e4605, (_e4605 < _e4610));
                                let _e4644 = select(_e4620, _e4615, (_e4615 < _e4620));
                                let _e4646 = select(_e4644, _e4642, (_e4642 < _e4644));
                                let _e4648 = select(_e4630, _e4625, (_e4625 < _e4630));
                                let _e4650 = select(_e4640, _e4635, (_e4635 < _e4640));
                                let _e4652 = select(_e4650, _e4648, (_e4648 < _e4650));
                                let _e4654 = select(_e4652, _e4646, (_e4646 < _e4652));
                                let _e4656 = select(_e4610, _e4605, (_e4605 > _e4610));
                                let _e4658 = select(_e4620, _e4615, (_e4615 > _e4620));
                                let _e4660 = select(_e4658, _e4656, (_e4656 > _e4658));
                                let _e4662 = select(_e4630, _e4625, (_e4625 > _e4630));
                                let _e4664 = select(_e4640, _e4635, (_e4635 > _e4640));
                                let _e4666 = select(_e4664, _e4662, (_e4662 > _e4664));
                                let _e4679 = ((select(_e4594, -(_e4594), (_e4594 < 0f)) + select(_e4597, -(_e4597), (_e4597 < 0f))) + select(_e4600, -(_e4600), (_e4600 < 0f)));
                                let _e4684 = -(select(_e4666, _e4660, (_e4660 > _e4666)));
                                let _e4691 = (((select(_e4684, _e4654, (_e4654 > _e4684)) - ((_e4679 * _e4378) * (0.000000059604645f * (17f / 2f)))) - (_e4679 * _e4385)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                phi_7645_ = select(_e4691, _e4587, (_e4587 > _e4691));
                            } else {
                                phi_7645_ = _e4587;
                            }
                            let _e4695 = phi_7645_;
                            phi_7651_ = ((_e3037 || (_e2475 && ((select(_e3413, _e3406, (_e3406 > _e3413)) - ((((((_e3235 * 8f) * _e3323) * (0.000000059604645f * (524f / 64f))) + ((_e3330 * 19f) * ((_e3235 * (_e3278 + _e3321)) + (_e3278 * _e3321)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3235) * ((1f + _e3278) * (1f + _e3321))))) + ((_e67.member_5 * (((select(_e3379, _e3367, (_e3367 > _e3379)) + (_e3323 * (0.000000059604645f * 8f))) + ((_e3386 * 6f) * (_e3278 + _e3321))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3278) * (1f + _e3321))))) * (3f * 1.0001f)))) > 0f))) || (_e2475 && (((_e3824 > -1f) && (_e3866 > -1f)) && (_e4695 > 0f))));
                        }
                        let _e4702 = phi_7651_;
                        if _e4702 {
                        } else {
                            let _e4704 = atomicAdd((&counters[1u]), 1u);
                            kept[_e4704].member = _e1610;
                            kept[_e4704].member_1 = _e1612;
                        }
                        phi_7660_ = true;
                    }
                    let _e4709 = phi_7660_;
                    phi_7661_ = _e4709;
                } else {
                    phi_7661_ = false;
                }
                let _e4711 = phi_7661_;
                continue;
                continuing {
                    phi_2567_ = type_9(select(_e1588.member, (_e1588.member + 1u), _e1591), select(_e1588.member_1, _e1588.member_1, _e1591));
                    break if !(_e4711);
                }
            }
            workgroupBarrier();
            let _e4714 = atomicLoad((&counters[1u]));
            if (_e51 == 0u) {
                if (_e4714 > 0u) {
                    let _e4718 = atomicAdd((&output.member[0u]), _e4714);
                    if ((_e4718 + _e4714) < _e4718) {
                        let _e4722 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[2u]), _e4718);
                    if _e145 {
                        let _e4725 = atomicAdd((&output.member[1u]), _e4714);
                        if ((_e4725 + _e4714) < _e4725) {
                            let _e4729 = atomicAdd((&output.member[3u]), 1u);
                        }
                    }
                }
            }
            workgroupBarrier();
            let _e4731 = atomicLoad((&counters[2u]));
            phi_7704_ = type_9(0u, 4u);
            loop {
                let _e4733 = phi_7704_;
                let _e4736 = (_e4733.member < _e4733.member_1);
                if (bitcast<i32>(select(0u, 1u, _e4736)) != 0i) {
                    let _e4751 = ((select(type_9().member_1, _e4733.member, _e4736) * 128u) + _e51);
                    if (_e4751 >= _e4714) {
                        phi_7763_ = false;
                    } else {
                        let _e4755 = kept[_e4751].member;
                        let _e4757 = kept[_e4751].member_1;
                        let _e4762 = params.member.member_1.member_3;
                        let _e4763 = (_e4731 + _e4751);
                        if (_e4763 < _e4762) {
                            let _e4765 = (2u * _e4763);
                            atomicStore((&output.member[(4u + _e4765)]), _e4755);
                            atomicStore((&output.member[(_e4765 + 5u)]), (_e4757 | (_e146 << bitcast<u32>(31i))));
                        }
                        phi_7763_ = true;
                    }
                    let _e4771 = phi_7763_;
                    phi_7764_ = _e4771;
                } else {
                    phi_7764_ = false;
                }
                let _e4773 = phi_7764_;
                continue;
                continuing {
                    phi_7704_ = type_9(select(_e4733.member, (_e4733.member + 1u), _e4736), select(_e4733.member_1, _e4733.member_1, _e4736));
                    break if !(_e4773);
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

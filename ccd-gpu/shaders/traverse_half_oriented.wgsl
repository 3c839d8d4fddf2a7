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
    member: array<u32, 47>,
    member_1: u32,
}

struct type_35 {
    member: type_34,
    member_1: u32,
    member_2: bool,
}

struct type_36 {
    member: u32,
    member_1: u32,
    member_2: bool,
}

struct type_39 {
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
var<storage, read_write> pairs: type_39;

fn function_(param: u32) -> u32 {
    return param;
}

fn function_1(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_28;
    var local_1: type_35;
    var phi_259_: type_9;
    var phi_262_: type_36;
    var phi_299_: type_9;
    var phi_302_: type_36;
    var phi_340_: bool;
    var phi_430_: type_36;
    var phi_431_: u32;
    var phi_486_: type_36;
    var phi_303_: type_36;
    var phi_487_: bool;
    var phi_516_: type_9;
    var phi_2383_: bool;
    var phi_2522_: bool;
    var phi_2523_: bool;
    var phi_2693_: bool;
    var phi_2694_: type_36;
    var phi_2695_: bool;
    var phi_263_: type_36;
    var phi_2696_: bool;
    var local_2: type_36;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e33 = id_2;
    let _e34 = n_2;
    let _e35 = lane_2;
    let _e48 = ((((_e33.y * _e34.x) + _e33.x) * 128u) + _e35);
    let _e51 = params.member.member_1.member;
    if (_e48 < _e51) {
        let _e55 = params.member.member_1.member_1;
        let _e56 = (_e55 + _e48);
        let _e61 = params.member.member_2.member[0u][1u];
        let _e64 = leaves.member[(_e61 + _e56)];
        let _e80 = params.member.member.member_2[1u];
        let _e84 = params.member.member.member[1u];
        let _e87 = order.member[(_e80 + _e56)];
        let _e88 = (_e87 - _e80);
        local_1 = type_35(type_34(array<u32, 47>(u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32(), u32()), 0u), 0u, true);
        phi_259_ = type_9(0u, (_e84 - 1u));
        phi_262_ = type_36(_e56, 0u, false);
        loop {
            let _e96 = phi_259_;
            let _e98 = phi_262_;
            let _e101 = (_e96.member < _e96.member_1);
            if (bitcast<i32>(select(0u, 1u, _e101)) != 0i) {
                if _e98.member_2 {
                    phi_2694_ = type_36();
                    phi_2695_ = false;
                } else {
                    phi_299_ = type_9(0u, (_e84 - 1u));
                    phi_302_ = _e98;
                    loop {
                        let _e117 = phi_299_;
                        let _e119 = phi_302_;
                        local_2 = _e119;
                        let _e122 = (_e117.member < _e117.member_1);
                        if (bitcast<i32>(select(0u, 1u, _e122)) != 0i) {
                            if _e119.member_2 {
                                phi_340_ = false;
                            } else {
                                let _e137 = local_1.member.member_1;
                                phi_340_ = (_e137 < 16u);
                            }
                            let _e140 = phi_340_;
                            if _e140 {
                                let _e143 = nodes.member[_e119.member_1];
                                let _e162 = (_e143.member_2.w + 1u);
                                if (_e119.member > _e143.member_2.w) {
                                    let _e201 = type_36(_e119.member, _e162, _e119.member_2);
                                    phi_430_ = type_36(_e201.member, _e201.member_1, ((_e143.member_3.w & 2u) != 0u));
                                    phi_431_ = 4294967295u;
                                } else {
                                    let _e167 = type_36(_e119.member, _e143.member_2.w, _e119.member_2);
                                    let _e183 = ((((((bitcast<f32>(_e143.member_2.x) <= _e64.member_1.y) && (_e64.member.x <= bitcast<f32>(_e143.member_3.x))) && (bitcast<f32>(_e143.member_2.y) <= _e64.member_2.x)) && (_e64.member.y <= bitcast<f32>(_e143.member_3.y))) && (bitcast<f32>(_e143.member_2.z) <= _e64.member_2.y)) && (_e64.member_1.x <= bitcast<f32>(_e143.member_3.z)));
                                    let _e185 = ((_e143.member_3.w & 2u) != 0u);
                                    if _e183 {
                                        if _e185 {
                                        } else {
                                            let _e187 = function_(_e162);
                                            let _e189 = local_1.member.member_1;
                                            local_1.member.member[_e189] = _e187;
                                            let _e194 = local_1.member.member_1;
                                            local_1.member.member_1 = (_e194 + 1u);
                                        }
                                    }
                                    phi_430_ = type_36(_e167.member, _e167.member_1, ((_e143.member_3.w & 1u) != 0u));
                                    phi_431_ = select(_e162, 4294967295u, select(true, select(true, false, _e185), _e183));
                                }
                                let _e208 = phi_430_;
                                let _e210 = phi_431_;
                                if (_e210 != 4294967295u) {
                                    let _e215 = params.member.member.member_2[1u];
                                    let _e218 = order.member[(_e215 + _e210)];
                                    let _e219 = (_e218 - _e215);
                                    let _e222 = params.member.member_1.member_3;
                                    let _e223 = (_e88 < _e219);
                                    let _e227 = atomicAdd((&pairs.member[0u]), 1u);
                                    if ((_e227 + 1u) < _e227) {
                                        let _e231 = atomicAdd((&pairs.member[2u]), 1u);
                                    }
                                    if (_e227 < _e222) {
                                        let _e233 = (2u * _e227);
                                        atomicStore((&pairs.member[(4u + _e233)]), select(_e219, _e88, _e223));
                                        atomicStore((&pairs.member[(_e233 + 5u)]), select(_e88, _e219, _e223));
                                    }
                                }
                                phi_486_ = _e208;
                            } else {
                                phi_486_ = type_36();
                            }
                            let _e239 = phi_486_;
                            phi_303_ = _e239;
                            phi_487_ = _e140;
                        } else {
                            phi_303_ = type_36();
                            phi_487_ = false;
                        }
                        let _e241 = phi_303_;
                        let _e243 = phi_487_;
                        continue;
                        continuing {
                            phi_299_ = type_9(select(_e117.member, (_e117.member + 1u), _e122), select(_e117.member_1, _e117.member_1, _e122));
                            phi_302_ = _e241;
                            break if !(_e243);
                        }
                    }
                    let _e247 = local_1.member.member_1;
                    local_1.member_2 = (_e247 > 0u);
                    let _e251 = local_1.member_2;
                    if _e251 {
                        let _e255 = local_1.member.member_1;
                        local_1.member.member_1 = (_e255 - 1u);
                        let _e258 = local_1.member.member_1;
                        let _e261 = local_1.member.member[_e258];
                        local_1.member_1 = _e261;
                    }
                    phi_516_ = type_9(0u, (_e84 - 1u));
                    loop {
                        let _e266 = phi_516_;
                        let _e269 = (_e266.member < _e266.member_1);
                        if (bitcast<i32>(select(0u, 1u, _e269)) != 0i) {
                            let _e282 = local_1.member_2;
                            if _e282 {
                                let _e284 = local_1.member_1;
                                let _e287 = oriented.member[(_e80 + _e284)];
                                let _e324 = ((_e64.member.x * 0.5f) + (_e64.member_1.y * 0.5f));
                                let _e325 = ((_e64.member.y * 0.5f) + (_e64.member_2.x * 0.5f));
                                let _e326 = ((_e64.member_1.x * 0.5f) + (_e64.member_2.y * 0.5f));
                                let _e328 = select(_e64.member_1.y, _e324, (_e324 < _e64.member_1.y));
                                let _e330 = select(_e64.member_2.x, _e325, (_e325 < _e64.member_2.x));
                                let _e332 = select(_e64.member_2.y, _e326, (_e326 < _e64.member_2.y));
                                let _e334 = select(_e64.member.x, _e328, (_e328 > _e64.member.x));
                                let _e336 = select(_e64.member.y, _e330, (_e330 > _e64.member.y));
                                let _e338 = select(_e64.member_1.x, _e332, (_e332 > _e64.member_1.x));
                                let _e339 = (_e64.member_1.y - _e334);
                                let _e340 = (_e64.member_2.x - _e336);
                                let _e341 = (_e64.member_2.y - _e338);
                                let _e342 = (_e334 - _e64.member.x);
                                let _e343 = (_e336 - _e64.member.y);
                                let _e344 = (_e338 - _e64.member_1.x);
                                let _e352 = (1f + (0.000000059604645f * 4f));
                                let _e356 = (0.000000000000000000000000000000000000011754944f * 8f);
                                let _e357 = ((select(_e342, _e339, (_e339 > _e342)) * _e352) + _e356);
                                let _e358 = ((select(_e343, _e340, (_e340 > _e343)) * _e352) + _e356);
                                let _e359 = ((select(_e344, _e341, (_e341 > _e344)) * _e352) + _e356);
                                let _e360 = (_e287.member.x - _e334);
                                let _e361 = (_e287.member.y - _e336);
                                let _e362 = (_e287.member.z - _e338);
                                local = type_28(array<array<f32, 3>, 3>(array<f32, 3>(_e287.member.w, _e287.member_1.z, _e287.member_2.y), array<f32, 3>(_e287.member_1.x, _e287.member_1.w, _e287.member_2.z), array<f32, 3>(_e287.member_1.y, _e287.member_2.x, _e287.member_2.w)), array<f32, 3>(_e360, _e361, _e362), array<f32, 3>((((_e287.member.w * _e360) + (_e287.member_1.x * _e361)) + (_e287.member_1.y * _e362)), (((_e287.member_1.z * _e360) + (_e287.member_1.w * _e361)) + (_e287.member_2.x * _e362)), (((_e287.member_2.y * _e360) + (_e287.member_2.z * _e361)) + (_e287.member_2.w * _e362))), array<f32, 3>(_e357, _e358, _e359), array<f32, 3>(_e287.member_3.x, _e287.member_3.y, _e287.member_3.z), ((((((select(_e360, -(_e360), (_e360 < 0f)) + select(_e361, -(_e361), (_e361 < 0f))) + select(_e362, -(_e362), (_e362 < 0f))) + (((select(_e357, -(_e357), (_e357 < 0f)) + select(_e358, -(_e358), (_e358 < 0f))) + select(_e359, -(_e359), (_e359 < 0f))) + ((select(_e287.member_3.x, -(_e287.member_3.x), (_e287.member_3.x < 0f)) + select(_e287.member_3.y, -(_e287.member_3.y), (_e287.member_3.y < 0f))) + select(_e287.member_3.z, -(_e287.member_3.z), (_e287.member_3.z < 0f))))) * 2f) * (0.000000059604645f * 128f)) + (0.000000000000000000000000000000000000011754944f * 128f)));
                                let _e430 = local.member[0u][0u];
                                let _e434 = local.member[0u][1u];
                                let _e438 = local.member[0u][2u];
                                let _e442 = local.member[1u][0u];
                                let _e446 = local.member[1u][1u];
                                let _e450 = local.member[1u][2u];
                                let _e454 = local.member[2u][0u];
                                let _e458 = local.member[2u][1u];
                                let _e462 = local.member[2u][2u];
                                let _e464 = local.member_3;
                                let _e469 = local.member_4;
                                let _e475 = local.member_1[0u];
                                let _e494 = (select(_e475, -(_e475), (_e475 < 0f)) - (_e464[0] + (((select(_e430, -(_e430), (_e430 < 0f)) * _e469[0]) + (select(_e434, -(_e434), (_e434 < 0f)) * _e469[1])) + (select(_e438, -(_e438), (_e438 < 0f)) * _e469[2]))));
                                let _e497 = local.member_1[1u];
                                let _e516 = (select(_e497, -(_e497), (_e497 < 0f)) - (_e464[1] + (((select(_e442, -(_e442), (_e442 < 0f)) * _e469[0]) + (select(_e446, -(_e446), (_e446 < 0f)) * _e469[1])) + (select(_e450, -(_e450), (_e450 < 0f)) * _e469[2]))));
                                let _e519 = local.member_1[2u];
                                let _e538 = (select(_e519, -(_e519), (_e519 < 0f)) - (_e464[2] + (((select(_e454, -(_e454), (_e454 < 0f)) * _e469[0]) + (select(_e458, -(_e458), (_e458 < 0f)) * _e469[1])) + (select(_e462, -(_e462), (_e462 < 0f)) * _e469[2]))));
                                let _e541 = local.member_2[0u];
                                let _e560 = (select(_e541, -(_e541), (_e541 < 0f)) - (_e469[0] + (((select(_e430, -(_e430), (_e430 < 0f)) * _e464[0]) + (select(_e442, -(_e442), (_e442 < 0f)) * _e464[1])) + (select(_e454, -(_e454), (_e454 < 0f)) * _e464[2]))));
                                let _e563 = local.member_2[1u];
                                let _e582 = (select(_e563, -(_e563), (_e563 < 0f)) - (_e469[1] + (((select(_e434, -(_e434), (_e434 < 0f)) * _e464[0]) + (select(_e446, -(_e446), (_e446 < 0f)) * _e464[1])) + (select(_e458, -(_e458), (_e458 < 0f)) * _e464[2]))));
                                let _e585 = local.member_2[2u];
                                let _e604 = (select(_e585, -(_e585), (_e585 < 0f)) - (_e469[2] + (((select(_e438, -(_e438), (_e438 < 0f)) * _e464[0]) + (select(_e450, -(_e450), (_e450 < 0f)) * _e464[1])) + (select(_e462, -(_e462), (_e462 < 0f)) * _e464[2]))));
                                let _e606 = select(_e516, _e494, (_e494 > _e516));
                                let _e608 = select(_e538, _e606, (_e606 > _e538));
                                let _e610 = select(_e582, _e560, (_e560 > _e582));
                                let _e612 = select(_e604, _e610, (_e610 > _e604));
                                let _e616 = local.member_5;
                                if (select(_e612, _e608, (_e608 > _e612)) > _e616) {
                                    phi_2383_ = true;
                                } else {
                                    let _e621 = local.member[1u][0u];
                                    let _e624 = local.member_1[2u];
                                    let _e629 = local.member[2u][0u];
                                    let _e632 = local.member_1[1u];
                                    let _e634 = ((_e621 * _e624) - (_e629 * _e632));
                                    let _e638 = local.member[2u][0u];
                                    let _e644 = local.member_3[1u];
                                    let _e649 = local.member[1u][0u];
                                    let _e655 = local.member_3[2u];
                                    let _e661 = local.member[0u][2u];
                                    let _e667 = local.member_4[1u];
                                    let _e672 = local.member[0u][1u];
                                    let _e678 = local.member_4[2u];
                                    let _e685 = (select(_e634, -(_e634), (_e634 < 0f)) - (((select(_e638, -(_e638), (_e638 < 0f)) * _e644) + (select(_e649, -(_e649), (_e649 < 0f)) * _e655)) + ((select(_e661, -(_e661), (_e661 < 0f)) * _e667) + (select(_e672, -(_e672), (_e672 < 0f)) * _e678))));
                                    let _e689 = local.member[1u][1u];
                                    let _e692 = local.member_1[2u];
                                    let _e697 = local.member[2u][1u];
                                    let _e700 = local.member_1[1u];
                                    let _e702 = ((_e689 * _e692) - (_e697 * _e700));
                                    let _e706 = local.member[2u][1u];
                                    let _e712 = local.member_3[1u];
                                    let _e717 = local.member[1u][1u];
                                    let _e723 = local.member_3[2u];
                                    let _e729 = local.member[0u][0u];
                                    let _e735 = local.member_4[2u];
                                    let _e740 = local.member[0u][2u];
                                    let _e746 = local.member_4[0u];
                                    let _e753 = (select(_e702, -(_e702), (_e702 < 0f)) - (((select(_e706, -(_e706), (_e706 < 0f)) * _e712) + (select(_e717, -(_e717), (_e717 < 0f)) * _e723)) + ((select(_e729, -(_e729), (_e729 < 0f)) * _e735) + (select(_e740, -(_e740), (_e740 < 0f)) * _e746))));
                                    let _e757 = local.member[1u][2u];
                                    let _e760 = local.member_1[2u];
                                    let _e765 = local.member[2u][2u];
                                    let _e768 = local.member_1[1u];
                                    let _e770 = ((_e757 * _e760) - (_e765 * _e768));
                                    let _e774 = local.member[2u][2u];
                                    let _e780 = local.member_3[1u];
                                    let _e785 = local.member[1u][2u];
                                    let _e791 = local.member_3[2u];
                                    let _e797 = local.member[0u][1u];
                                    let _e803 = local.member_4[0u];
                                    let _e808 = local.member[0u][0u];
                                    let _e814 = local.member_4[1u];
                                    let _e821 = (select(_e770, -(_e770), (_e770 < 0f)) - (((select(_e774, -(_e774), (_e774 < 0f)) * _e780) + (select(_e785, -(_e785), (_e785 < 0f)) * _e791)) + ((select(_e797, -(_e797), (_e797 < 0f)) * _e803) + (select(_e808, -(_e808), (_e808 < 0f)) * _e814))));
                                    let _e825 = local.member[2u][0u];
                                    let _e828 = local.member_1[0u];
                                    let _e833 = local.member[0u][0u];
                                    let _e836 = local.member_1[2u];
                                    let _e838 = ((_e825 * _e828) - (_e833 * _e836));
                                    let _e842 = local.member[0u][0u];
                                    let _e848 = local.member_3[2u];
                                    let _e853 = local.member[2u][0u];
                                    let _e859 = local.member_3[0u];
                                    let _e865 = local.member[1u][2u];
                                    let _e871 = local.member_4[1u];
                                    let _e876 = local.member[1u][1u];
                                    let _e882 = local.member_4[2u];
                                    let _e889 = (select(_e838, -(_e838), (_e838 < 0f)) - (((select(_e842, -(_e842), (_e842 < 0f)) * _e848) + (select(_e853, -(_e853), (_e853 < 0f)) * _e859)) + ((select(_e865, -(_e865), (_e865 < 0f)) * _e871) + (select(_e876, -(_e876), (_e876 < 0f)) * _e882))));
                                    let _e893 = local.member[2u][1u];
                                    let _e896 = local.member_1[0u];
                                    let _e901 = local.member[0u][1u];
                                    let _e904 = local.member_1[2u];
                                    let _e906 = ((_e893 * _e896) - (_e901 * _e904));
                                    let _e910 = local.member[0u][1u];
                                    let _e916 = local.member_3[2u];
                                    let _e921 = local.member[2u][1u];
                                    let _e927 = local.member_3[0u];
                                    let _e933 = local.member[1u][0u];
                                    let _e939 = local.member_4[2u];
                                    let _e944 = local.member[1u][2u];
                                    let _e950 = local.member_4[0u];
                                    let _e957 = (select(_e906, -(_e906), (_e906 < 0f)) - (((select(_e910, -(_e910), (_e910 < 0f)) * _e916) + (select(_e921, -(_e921), (_e921 < 0f)) * _e927)) + ((select(_e933, -(_e933), (_e933 < 0f)) * _e939) + (select(_e944, -(_e944), (_e944 < 0f)) * _e950))));
                                    let _e961 = local.member[2u][2u];
                                    let _e964 = local.member_1[0u];
                                    let _e969 = local.member[0u][2u];
                                    let _e972 = local.member_1[2u];
                                    let _e974 = ((_e961 * _e964) - (_e969 * _e972));
                                    let _e978 = local.member[0u][2u];
                                    let _e984 = local.member_3[2u];
                                    let _e989 = local.member[2u][2u];
                                    let _e995 = local.member_3[0u];
                                    let _e1001 = local.member[1u][1u];
                                    let _e1007 = local.member_4[0u];
                                    let _e1012 = local.member[1u][0u];
                                    let _e1018 = local.member_4[1u];
                                    let _e1025 = (select(_e974, -(_e974), (_e974 < 0f)) - (((select(_e978, -(_e978), (_e978 < 0f)) * _e984) + (select(_e989, -(_e989), (_e989 < 0f)) * _e995)) + ((select(_e1001, -(_e1001), (_e1001 < 0f)) * _e1007) + (select(_e1012, -(_e1012), (_e1012 < 0f)) * _e1018))));
                                    let _e1029 = local.member[0u][0u];
                                    let _e1032 = local.member_1[1u];
                                    let _e1037 = local.member[1u][0u];
                                    let _e1040 = local.member_1[0u];
                                    let _e1042 = ((_e1029 * _e1032) - (_e1037 * _e1040));
                                    let _e1046 = local.member[1u][0u];
                                    let _e1052 = local.member_3[0u];
                                    let _e1057 = local.member[0u][0u];
                                    let _e1063 = local.member_3[1u];
                                    let _e1069 = local.member[2u][2u];
                                    let _e1075 = local.member_4[1u];
                                    let _e1080 = local.member[2u][1u];
                                    let _e1086 = local.member_4[2u];
                                    let _e1093 = (select(_e1042, -(_e1042), (_e1042 < 0f)) - (((select(_e1046, -(_e1046), (_e1046 < 0f)) * _e1052) + (select(_e1057, -(_e1057), (_e1057 < 0f)) * _e1063)) + ((select(_e1069, -(_e1069), (_e1069 < 0f)) * _e1075) + (select(_e1080, -(_e1080), (_e1080 < 0f)) * _e1086))));
                                    let _e1097 = local.member[0u][1u];
                                    let _e1100 = local.member_1[1u];
                                    let _e1105 = local.member[1u][1u];
                                    let _e1108 = local.member_1[0u];
                                    let _e1110 = ((_e1097 * _e1100) - (_e1105 * _e1108));
                                    let _e1114 = local.member[1u][1u];
                                    let _e1120 = local.member_3[0u];
                                    let _e1125 = local.member[0u][1u];
                                    let _e1131 = local.member_3[1u];
                                    let _e1137 = local.member[2u][0u];
                                    let _e1143 = local.member_4[2u];
                                    let _e1148 = local.member[2u][2u];
                                    let _e1154 = local.member_4[0u];
                                    let _e1161 = (select(_e1110, -(_e1110), (_e1110 < 0f)) - (((select(_e1114, -(_e1114), (_e1114 < 0f)) * _e1120) + (select(_e1125, -(_e1125), (_e1125 < 0f)) * _e1131)) + ((select(_e1137, -(_e1137), (_e1137 < 0f)) * _e1143) + (select(_e1148, -(_e1148), (_e1148 < 0f)) * _e1154))));
                                    let _e1165 = local.member[0u][2u];
                                    let _e1168 = local.member_1[1u];
                                    let _e1173 = local.member[1u][2u];
                                    let _e1176 = local.member_1[0u];
                                    let _e1178 = ((_e1165 * _e1168) - (_e1173 * _e1176));
                                    let _e1182 = local.member[1u][2u];
                                    let _e1188 = local.member_3[0u];
                                    let _e1193 = local.member[0u][2u];
                                    let _e1199 = local.member_3[1u];
                                    let _e1205 = local.member[2u][1u];
                                    let _e1211 = local.member_4[0u];
                                    let _e1216 = local.member[2u][0u];
                                    let _e1222 = local.member_4[1u];
                                    let _e1229 = (select(_e1178, -(_e1178), (_e1178 < 0f)) - (((select(_e1182, -(_e1182), (_e1182 < 0f)) * _e1188) + (select(_e1193, -(_e1193), (_e1193 < 0f)) * _e1199)) + ((select(_e1205, -(_e1205), (_e1205 < 0f)) * _e1211) + (select(_e1216, -(_e1216), (_e1216 < 0f)) * _e1222))));
                                    let _e1231 = select(_e753, _e685, (_e685 > _e753));
                                    let _e1233 = select(_e821, _e1231, (_e1231 > _e821));
                                    let _e1235 = select(_e957, _e889, (_e889 > _e957));
                                    let _e1237 = select(_e1025, _e1235, (_e1235 > _e1025));
                                    let _e1239 = select(_e1237, _e1233, (_e1233 > _e1237));
                                    let _e1241 = select(_e1161, _e1093, (_e1093 > _e1161));
                                    let _e1243 = select(_e1229, _e1241, (_e1241 > _e1229));
                                    let _e1247 = local.member_5;
                                    phi_2383_ = (select(_e1243, _e1239, (_e1239 > _e1243)) > _e1247);
                                }
                                let _e1250 = phi_2383_;
                                if !(_e1250) {
                                    let _e1271 = local_1.member_1;
                                    let _e1273 = nodes.member[_e1271];
                                    let _e1316 = ((((((bitcast<f32>(_e1273.member.x) <= _e64.member_1.y) && (_e64.member.x <= bitcast<f32>(_e1273.member_1.x))) && (bitcast<f32>(_e1273.member.y) <= _e64.member_2.x)) && (_e64.member.y <= bitcast<f32>(_e1273.member_1.y))) && (bitcast<f32>(_e1273.member.z) <= _e64.member_2.y)) && (_e64.member_1.x <= bitcast<f32>(_e1273.member_1.z)));
                                    let _e1327 = ((((((bitcast<f32>(_e1273.member_2.x) <= _e64.member_1.y) && (_e64.member.x <= bitcast<f32>(_e1273.member_3.x))) && (bitcast<f32>(_e1273.member_2.y) <= _e64.member_2.x)) && (_e64.member.y <= bitcast<f32>(_e1273.member_3.y))) && (bitcast<f32>(_e1273.member_2.z) <= _e64.member_2.y)) && (_e64.member_1.x <= bitcast<f32>(_e1273.member_3.z)));
                                    let _e1329 = ((_e1273.member_3.w & 1u) != 0u);
                                    let _e1331 = ((_e1273.member_3.w & 2u) != 0u);
                                    let _e1332 = (_e1273.member_2.w + 1u);
                                    let _e1335 = select(_e1273.member_2.w, 4294967295u, select(true, select(true, false, _e1329), _e1316));
                                    let _e1338 = select(_e1332, 4294967295u, select(true, select(true, false, _e1331), _e1327));
                                    let _e1340 = select(false, !(_e1329), _e1316);
                                    let _e1342 = select(false, !(_e1331), _e1327);
                                    if _e1340 {
                                        if _e1342 {
                                            let _e1344 = ((_e1273.member_3.w & 4u) != 0u);
                                            let _e1347 = function_(select(_e1273.member_2.w, _e1332, _e1344));
                                            let _e1349 = local_1.member.member_1;
                                            local_1.member.member[_e1349] = _e1347;
                                            let _e1354 = local_1.member.member_1;
                                            local_1.member.member_1 = (_e1354 + 1u);
                                            local_1.member_1 = select(_e1332, _e1273.member_2.w, _e1344);
                                            phi_2522_ = false;
                                        } else {
                                            phi_2522_ = true;
                                        }
                                        let _e1359 = phi_2522_;
                                        phi_2523_ = _e1359;
                                    } else {
                                        phi_2523_ = true;
                                    }
                                    let _e1361 = phi_2523_;
                                    if _e1361 {
                                        if _e1340 {
                                            local_1.member_1 = _e1273.member_2.w;
                                        } else {
                                            if _e1342 {
                                                local_1.member_1 = _e1332;
                                            } else {
                                                let _e1364 = local_1.member.member_1;
                                                local_1.member_2 = (_e1364 > 0u);
                                                let _e1368 = local_1.member_2;
                                                if _e1368 {
                                                    let _e1372 = local_1.member.member_1;
                                                    local_1.member.member_1 = (_e1372 - 1u);
                                                    let _e1375 = local_1.member.member_1;
                                                    let _e1378 = local_1.member.member[_e1375];
                                                    local_1.member_1 = _e1378;
                                                }
                                            }
                                        }
                                    }
                                    if (_e1335 != 4294967295u) {
                                        let _e1386 = params.member.member.member_2[1u];
                                        let _e1389 = order.member[(_e1386 + _e1335)];
                                        let _e1390 = (_e1389 - _e1386);
                                        let _e1393 = params.member.member_1.member_3;
                                        let _e1394 = (_e88 < _e1390);
                                        let _e1398 = atomicAdd((&pairs.member[0u]), 1u);
                                        if ((_e1398 + 1u) < _e1398) {
                                            let _e1402 = atomicAdd((&pairs.member[2u]), 1u);
                                        }
                                        if (_e1398 < _e1393) {
                                            let _e1404 = (2u * _e1398);
                                            atomicStore((&pairs.member[(4u + _e1404)]), select(_e1390, _e88, _e1394));
                                            atomicStore((&pairs.member[(_e1404 + 5u)]), select(_e88, _e1390, _e1394));
                                        }
                                    }
                                    if (_e1338 != 4294967295u) {
                                        let _e1413 = params.member.member.member_2[1u];
                                        let _e1416 = order.member[(_e1413 + _e1338)];
                                        let _e1417 = (_e1416 - _e1413);
                                        let _e1420 = params.member.member_1.member_3;
                                        let _e1421 = (_e88 < _e1417);
                                        let _e1425 = atomicAdd((&pairs.member[0u]), 1u);
                                        if ((_e1425 + 1u) < _e1425) {
                                            let _e1429 = atomicAdd((&pairs.member[2u]), 1u);
                                        }
                                        if (_e1425 < _e1420) {
                                            let _e1431 = (2u * _e1425);
                                            atomicStore((&pairs.member[(4u + _e1431)]), select(_e1417, _e88, _e1421));
                                            atomicStore((&pairs.member[(_e1431 + 5u)]), select(_e88, _e1417, _e1421));
                                        }
                                    }
                                } else {
                                    let _e1254 = local_1.member.member_1;
                                    local_1.member_2 = (_e1254 > 0u);
                                    let _e1258 = local_1.member_2;
                                    if _e1258 {
                                        let _e1262 = local_1.member.member_1;
                                        local_1.member.member_1 = (_e1262 - 1u);
                                        let _e1265 = local_1.member.member_1;
                                        let _e1268 = local_1.member.member[_e1265];
                                        local_1.member_1 = _e1268;
                                    }
                                }
                            }
                            phi_2693_ = _e282;
                        } else {
                            phi_2693_ = false;
                        }
                        let _e1437 = phi_2693_;
                        continue;
                        continuing {
                            phi_516_ = type_9(select(_e266.member, (_e266.member + 1u), _e269), select(_e266.member_1, _e266.member_1, _e269));
                            break if !(_e1437);
                        }
                    }
                    let _e1465 = local_2;
                    phi_2694_ = _e1465;
                    phi_2695_ = true;
                }
                let _e1440 = phi_2694_;
                let _e1442 = phi_2695_;
                phi_263_ = _e1440;
                phi_2696_ = _e1442;
            } else {
                phi_263_ = type_36();
                phi_2696_ = false;
            }
            let _e1444 = phi_263_;
            let _e1446 = phi_2696_;
            continue;
            continuing {
                phi_259_ = type_9(select(_e96.member, (_e96.member + 1u), _e101), select(_e96.member_1, _e96.member_1, _e101));
                phi_262_ = _e1444;
                break if !(_e1446);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn traverse_half_oriented(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_1(id, n, lane);
}

// Generated from ccd-shaders by `cargo xtask shaders`: not to be edited.
struct type_6 {
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

struct type_7 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_9 {
    member: array<u32>,
}

struct type_10 {
    member: u32,
}

struct type_11 {
    member: type_6,
    member_1: type_7,
    member_2: type_10,
}

struct type_12 {
    member: type_11,
}

@group(0) @binding(0) 
var<storage> params: type_12;
@group(0) @binding(1) 
var<storage> list_0_: type_9;
@group(0) @binding(2) 
var<storage> list_1_: type_9;
@group(0) @binding(3) 
var<storage> list_2_: type_9;
@group(0) @binding(4) 
var<storage> list_3_: type_9;
@group(0) @binding(5) 
var<storage> list_4_: type_9;
@group(0) @binding(6) 
var<storage> list_5_: type_9;
@group(0) @binding(7) 
var<storage, read_write> headers: type_9;

fn function_(lane_1: u32) {
    var lane_2: u32;

    lane_2 = lane_1;
    let _e14 = lane_2;
    if (_e14 < 4u) {
        let _e26 = params.member.member_1.member_1;
        let _e27 = (_e26 + _e14);
        let _e29 = list_0_.member[_e14];
        headers.member[_e27] = _e29;
        let _e33 = list_1_.member[_e14];
        headers.member[(_e27 + 4u)] = _e33;
        let _e37 = list_2_.member[_e14];
        headers.member[(_e27 + 8u)] = _e37;
        let _e41 = list_3_.member[_e14];
        headers.member[(_e27 + 12u)] = _e41;
        let _e45 = list_4_.member[_e14];
        headers.member[(_e27 + 16u)] = _e45;
        let _e49 = list_5_.member[_e14];
        headers.member[(_e27 + 20u)] = _e49;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn gather_headers(@builtin(local_invocation_index) lane: u32) {
    function_(lane);
}

// Generated from ccd-shaders by `cargo xtask shaders`: not to be edited.
struct type_2 {
    member: array<u32>,
}

@group(0) @binding(0) 
var<storage, read_write> list_0_: type_2;
@group(0) @binding(1) 
var<storage, read_write> list_1_: type_2;
@group(0) @binding(2) 
var<storage, read_write> list_2_: type_2;
@group(0) @binding(3) 
var<storage, read_write> list_3_: type_2;
@group(0) @binding(4) 
var<storage, read_write> list_4_: type_2;
@group(0) @binding(5) 
var<storage, read_write> list_5_: type_2;
@group(0) @binding(6) 
var<storage, read_write> list_6_: type_2;
@group(0) @binding(7) 
var<storage, read_write> list_7_: type_2;

fn function_(lane_1: u32) {
    var lane_2: u32;

    lane_2 = lane_1;
    let _e11 = lane_2;
    if (_e11 < 4u) {
        list_0_.member[_e11] = 0u;
        list_1_.member[_e11] = 0u;
        list_2_.member[_e11] = 0u;
        list_3_.member[_e11] = 0u;
        list_4_.member[_e11] = 0u;
        list_5_.member[_e11] = 0u;
        list_6_.member[_e11] = 0u;
        list_7_.member[_e11] = 0u;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn clear_headers(@builtin(local_invocation_index) lane: u32) {
    function_(lane);
}

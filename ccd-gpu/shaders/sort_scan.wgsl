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

struct type_10 {
    member: type_7,
    member_1: type_8,
    member_2: type_9,
}

struct type_11 {
    member: type_10,
}

struct type_13 {
    member: array<u32>,
}

@group(0) @binding(0) 
var<storage> params: type_11;
@group(0) @binding(1) 
var<storage, read_write> table: type_13;
var<workgroup> sums: array<u32, 512>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_83_: u32;
    var phi_86_: type_9;
    var phi_89_: u32;
    var phi_87_: type_9;
    var phi_112_: type_9;
    var phi_138_: u32;
    var phi_155_: u32;
    var phi_172_: u32;
    var phi_189_: u32;
    var phi_196_: type_9;
    var phi_199_: u32;
    var phi_201_: u32;
    var phi_203_: u32;
    var phi_200_: u32;
    var phi_197_: type_9;
    var phi_226_: type_9;
    var phi_242_: u32;
    var phi_202_: u32;
    var phi_204_: u32;
    var local: u32;
    var phi_90_: u32;
    var local_1: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e18 = id_2;
    let _e19 = n_2;
    let _e20 = lane_2;
    let _e27 = ((_e18.y * _e19.x) + _e18.x);
    let _e30 = params.member.member_2.member_1;
    let _e31 = (_e27 * _e30);
    let _e32 = (_e30 / 1024u);
    if ((_e30 % 1024u) > 0u) {
        phi_83_ = (_e32 + 1u);
    } else {
        phi_83_ = _e32;
    }
    let _e37 = phi_83_;
    phi_86_ = type_9(0u, _e37);
    phi_89_ = 0u;
    loop {
        let _e40 = phi_86_;
        let _e42 = phi_89_;
        local_1 = _e42;
        if (_e40.member < _e40.member_1) {
            phi_87_ = type_9((_e40.member + 1u), _e40.member_1);
            phi_112_ = type_9(1u, _e40.member);
        } else {
            phi_87_ = _e40;
            phi_112_ = type_9(0u, type_9().member_1);
        }
        let _e54 = phi_87_;
        let _e56 = phi_112_;
        let _e60 = (bitcast<i32>(_e56.member) != 0i);
        if _e60 {
            let _e63 = ((_e56.member_1 * 1024u) + (4u * _e20));
            if (_e63 < _e30) {
                let _e67 = table.member[(_e31 + _e63)];
                phi_138_ = _e67;
            } else {
                phi_138_ = 0u;
            }
            let _e69 = phi_138_;
            let _e70 = (_e63 + 1u);
            if (_e70 < _e30) {
                let _e74 = table.member[(_e31 + _e70)];
                phi_155_ = _e74;
            } else {
                phi_155_ = 0u;
            }
            let _e76 = phi_155_;
            let _e77 = (_e63 + 2u);
            if (_e77 < _e30) {
                let _e81 = table.member[(_e31 + _e77)];
                phi_172_ = _e81;
            } else {
                phi_172_ = 0u;
            }
            let _e83 = phi_172_;
            let _e84 = (_e63 + 3u);
            if (_e84 < _e30) {
                let _e88 = table.member[(_e31 + _e84)];
                phi_189_ = _e88;
            } else {
                phi_189_ = 0u;
            }
            let _e90 = phi_189_;
            let _e93 = (((_e69 + _e76) + _e83) + _e90);
            sums[_e20] = _e93;
            phi_196_ = type_9(0u, 8u);
            phi_199_ = 0u;
            phi_201_ = 1u;
            phi_203_ = _e93;
            phi_200_ = 256u;
            loop {
                let _e96 = phi_196_;
                let _e98 = phi_199_;
                let _e100 = phi_201_;
                let _e102 = phi_203_;
                let _e104 = phi_200_;
                local = _e102;
                if (_e96.member < _e96.member_1) {
                    phi_197_ = type_9((_e96.member + 1u), _e96.member_1);
                    phi_226_ = type_9(1u, _e96.member);
                } else {
                    phi_197_ = _e96;
                    phi_226_ = type_9(0u, type_9().member_1);
                }
                let _e116 = phi_197_;
                let _e118 = phi_226_;
                let _e121 = (bitcast<i32>(_e118.member) != 0i);
                if _e121 {
                    workgroupBarrier();
                    if (_e20 >= _e100) {
                        let _e126 = sums[((_e98 + _e20) - _e100)];
                        phi_242_ = (_e102 + _e126);
                    } else {
                        phi_242_ = _e102;
                    }
                    let _e129 = phi_242_;
                    sums[(_e104 + _e20)] = _e129;
                    phi_202_ = (_e100 * 2u);
                    phi_204_ = _e129;
                } else {
                    phi_202_ = u32();
                    phi_204_ = u32();
                }
                let _e134 = phi_202_;
                let _e136 = phi_204_;
                continue;
                continuing {
                    phi_196_ = _e116;
                    phi_199_ = _e104;
                    phi_201_ = _e134;
                    phi_203_ = _e136;
                    phi_200_ = _e98;
                    break if !(_e121);
                }
            }
            workgroupBarrier();
            let _e139 = local;
            let _e141 = ((_e42 + _e139) - _e93);
            if (_e63 < _e30) {
                table.member[(_e31 + _e63)] = _e141;
            }
            let _e145 = (_e141 + _e69);
            if ((_e63 + 1u) < _e30) {
                table.member[((_e31 + _e63) + 1u)] = _e145;
            }
            let _e151 = (_e145 + _e76);
            if ((_e63 + 2u) < _e30) {
                table.member[((_e31 + _e63) + 2u)] = _e151;
            }
            if ((_e63 + 3u) < _e30) {
                table.member[((_e31 + _e63) + 3u)] = (_e151 + _e83);
            }
            let _e164 = sums[255u];
            workgroupBarrier();
            phi_90_ = (_e42 + _e164);
        } else {
            phi_90_ = u32();
        }
        let _e167 = phi_90_;
        continue;
        continuing {
            phi_86_ = _e54;
            phi_89_ = _e167;
            break if !(_e60);
        }
    }
    if (_e20 == 0u) {
        let _e174 = local_1;
        table.member[((256u * _e30) + _e27)] = _e174;
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn sort_scan(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}

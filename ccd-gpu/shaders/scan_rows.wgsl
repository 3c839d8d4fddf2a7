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
    var phi_86_: type_9;
    var phi_89_: u32;
    var phi_138_: u32;
    var phi_155_: u32;
    var phi_172_: u32;
    var phi_189_: u32;
    var phi_196_: type_9;
    var phi_199_: u32;
    var phi_201_: u32;
    var phi_203_: u32;
    var phi_200_: u32;
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
    phi_86_ = type_9(0u, select(_e32, (_e32 + 1u), ((_e30 % 1024u) > 0u)));
    phi_89_ = 0u;
    loop {
        let _e39 = phi_86_;
        let _e41 = phi_89_;
        local_1 = _e41;
        let _e44 = (_e39.member < _e39.member_1);
        let _e57 = (bitcast<i32>(select(0u, 1u, _e44)) != 0i);
        if _e57 {
            let _e60 = ((select(type_9().member_1, _e39.member, _e44) * 1024u) + (4u * _e20));
            if (_e60 < _e30) {
                let _e64 = table.member[(_e31 + _e60)];
                phi_138_ = _e64;
            } else {
                phi_138_ = 0u;
            }
            let _e66 = phi_138_;
            let _e67 = (_e60 + 1u);
            if (_e67 < _e30) {
                let _e71 = table.member[(_e31 + _e67)];
                phi_155_ = _e71;
            } else {
                phi_155_ = 0u;
            }
            let _e73 = phi_155_;
            let _e74 = (_e60 + 2u);
            if (_e74 < _e30) {
                let _e78 = table.member[(_e31 + _e74)];
                phi_172_ = _e78;
            } else {
                phi_172_ = 0u;
            }
            let _e80 = phi_172_;
            let _e81 = (_e60 + 3u);
            if (_e81 < _e30) {
                let _e85 = table.member[(_e31 + _e81)];
                phi_189_ = _e85;
            } else {
                phi_189_ = 0u;
            }
            let _e87 = phi_189_;
            let _e90 = (((_e66 + _e73) + _e80) + _e87);
            sums[_e20] = _e90;
            phi_196_ = type_9(0u, 8u);
            phi_199_ = 0u;
            phi_201_ = 1u;
            phi_203_ = _e90;
            phi_200_ = 256u;
            loop {
                let _e93 = phi_196_;
                let _e95 = phi_199_;
                let _e97 = phi_201_;
                let _e99 = phi_203_;
                let _e101 = phi_200_;
                local = _e99;
                let _e104 = (_e93.member < _e93.member_1);
                let _e115 = (bitcast<i32>(select(0u, 1u, _e104)) != 0i);
                if _e115 {
                    workgroupBarrier();
                    if (_e20 >= _e97) {
                        let _e120 = sums[((_e95 + _e20) - _e97)];
                        phi_242_ = (_e99 + _e120);
                    } else {
                        phi_242_ = _e99;
                    }
                    let _e123 = phi_242_;
                    sums[(_e101 + _e20)] = _e123;
                    phi_202_ = (_e97 * 2u);
                    phi_204_ = _e123;
                } else {
                    phi_202_ = u32();
                    phi_204_ = u32();
                }
                let _e128 = phi_202_;
                let _e130 = phi_204_;
                continue;
                continuing {
                    phi_196_ = type_9(select(_e93.member, (_e93.member + 1u), _e104), select(_e93.member_1, _e93.member_1, _e104));
                    phi_199_ = _e101;
                    phi_201_ = _e128;
                    phi_203_ = _e130;
                    phi_200_ = _e95;
                    break if !(_e115);
                }
            }
            workgroupBarrier();
            let _e133 = local;
            let _e135 = ((_e41 + _e133) - _e90);
            if (_e60 < _e30) {
                table.member[(_e31 + _e60)] = _e135;
            }
            let _e139 = (_e135 + _e66);
            if ((_e60 + 1u) < _e30) {
                table.member[((_e31 + _e60) + 1u)] = _e139;
            }
            let _e145 = (_e139 + _e73);
            if ((_e60 + 2u) < _e30) {
                table.member[((_e31 + _e60) + 2u)] = _e145;
            }
            if ((_e60 + 3u) < _e30) {
                table.member[((_e31 + _e60) + 3u)] = (_e145 + _e80);
            }
            let _e158 = sums[255u];
            workgroupBarrier();
            phi_90_ = (_e41 + _e158);
        } else {
            phi_90_ = u32();
        }
        let _e161 = phi_90_;
        continue;
        continuing {
            phi_86_ = type_9(select(_e39.member, (_e39.member + 1u), _e44), select(_e39.member_1, _e39.member_1, _e44));
            phi_89_ = _e161;
            break if !(_e57);
        }
    }
    if (_e20 == 0u) {
        let _e168 = local_1;
        table.member[((256u * _e30) + _e27)] = _e168;
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn scan_rows(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}

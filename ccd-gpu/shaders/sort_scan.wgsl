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

fn function_(id_1: vec3<u32>, lane_1: u32) {
    var phi_79_: u32;
    var phi_82_: type_9;
    var phi_85_: u32;
    var phi_83_: type_9;
    var phi_108_: type_9;
    var phi_136_: u32;
    var phi_140_: type_9;
    var phi_143_: u32;
    var phi_145_: u32;
    var phi_147_: u32;
    var phi_144_: u32;
    var phi_141_: type_9;
    var phi_170_: type_9;
    var phi_186_: u32;
    var phi_146_: u32;
    var phi_148_: u32;
    var local: u32;
    var phi_86_: u32;
    var local_1: u32;
    var id_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    lane_2 = lane_1;
    let _e14 = id_2;
    let _e15 = lane_2;
    let _e21 = params.member.member_2.member_1;
    let _e22 = (_e14.x * _e21);
    let _e25 = params.member.member_2.member_1;
    let _e26 = (_e25 / 256u);
    if ((_e25 % 256u) > 0u) {
        phi_79_ = (_e26 + 1u);
    } else {
        phi_79_ = _e26;
    }
    let _e31 = phi_79_;
    phi_82_ = type_9(0u, _e31);
    phi_85_ = 0u;
    loop {
        let _e34 = phi_82_;
        let _e36 = phi_85_;
        local_1 = _e36;
        if (_e34.member < _e34.member_1) {
            phi_83_ = type_9((_e34.member + 1u), _e34.member_1);
            phi_108_ = type_9(1u, _e34.member);
        } else {
            phi_83_ = _e34;
            phi_108_ = type_9(0u, type_9().member_1);
        }
        let _e48 = phi_83_;
        let _e50 = phi_108_;
        let _e54 = (bitcast<i32>(_e50.member) != 0i);
        if _e54 {
            let _e56 = ((_e50.member_1 * 256u) + _e15);
            let _e59 = params.member.member_2.member_1;
            if (_e56 < _e59) {
                let _e63 = table.member[(_e22 + _e56)];
                phi_136_ = _e63;
            } else {
                phi_136_ = 0u;
            }
            let _e65 = phi_136_;
            sums[_e15] = _e65;
            phi_140_ = type_9(0u, 8u);
            phi_143_ = 0u;
            phi_145_ = 1u;
            phi_147_ = _e65;
            phi_144_ = 256u;
            loop {
                let _e68 = phi_140_;
                let _e70 = phi_143_;
                let _e72 = phi_145_;
                let _e74 = phi_147_;
                let _e76 = phi_144_;
                local = _e74;
                if (_e68.member < _e68.member_1) {
                    phi_141_ = type_9((_e68.member + 1u), _e68.member_1);
                    phi_170_ = type_9(1u, _e68.member);
                } else {
                    phi_141_ = _e68;
                    phi_170_ = type_9(0u, type_9().member_1);
                }
                let _e88 = phi_141_;
                let _e90 = phi_170_;
                let _e93 = (bitcast<i32>(_e90.member) != 0i);
                if _e93 {
                    workgroupBarrier();
                    if (_e15 >= _e72) {
                        let _e98 = sums[((_e70 + _e15) - _e72)];
                        phi_186_ = (_e74 + _e98);
                    } else {
                        phi_186_ = _e74;
                    }
                    let _e101 = phi_186_;
                    sums[(_e76 + _e15)] = _e101;
                    phi_146_ = (_e72 * 2u);
                    phi_148_ = _e101;
                } else {
                    phi_146_ = u32();
                    phi_148_ = u32();
                }
                let _e106 = phi_146_;
                let _e108 = phi_148_;
                continue;
                continuing {
                    phi_140_ = _e88;
                    phi_143_ = _e76;
                    phi_145_ = _e106;
                    phi_147_ = _e108;
                    phi_144_ = _e70;
                    break if !(_e93);
                }
            }
            workgroupBarrier();
            let _e112 = params.member.member_2.member_1;
            if (_e56 < _e112) {
                let _e116 = local;
                table.member[(_e22 + _e56)] = ((_e36 + _e116) - _e65);
            }
            let _e121 = sums[255u];
            workgroupBarrier();
            phi_86_ = (_e36 + _e121);
        } else {
            phi_86_ = u32();
        }
        let _e124 = phi_86_;
        continue;
        continuing {
            phi_82_ = _e48;
            phi_85_ = _e124;
            break if !(_e54);
        }
    }
    if (_e15 == 0u) {
        let _e129 = params.member.member_2.member_1;
        let _e135 = local_1;
        table.member[((256u * _e129) + _e14.x)] = _e135;
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn sort_scan(@builtin(workgroup_id) id: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, lane);
}

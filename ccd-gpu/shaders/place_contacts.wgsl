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

struct type_15 {
    member: u32,
}

struct type_16 {
    member: type_7,
    member_1: type_8,
    member_2: type_15,
}

struct type_17 {
    member: type_16,
}

var<workgroup> starts: array<u32, 256>;
var<workgroup> sums: array<u32, 512>;
@group(0) @binding(0) 
var<storage> params: type_17;
@group(0) @binding(1) 
var<storage> contacts: type_11;
@group(0) @binding(2) 
var<storage> table: type_11;
@group(0) @binding(3) 
var<storage> ranks: type_11;
@group(0) @binding(4) 
var<storage, read_write> slots: type_11;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_99_: u32;
    var phi_115_: type_9;
    var phi_118_: u32;
    var phi_120_: u32;
    var phi_122_: u32;
    var phi_119_: u32;
    var phi_116_: type_9;
    var phi_145_: type_9;
    var phi_161_: u32;
    var phi_121_: u32;
    var phi_123_: u32;
    var local: u32;
    var phi_187_: u32;
    var phi_192_: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e21 = id_2;
    let _e22 = n_2;
    let _e23 = lane_2;
    let _e35 = ((((_e21.y * _e22.x) + _e21.x) * 256u) + _e23);
    let _e39 = params.member.member.member[0u];
    let _e42 = params.member.member.member[1u];
    let _e43 = (_e39 + _e42);
    let _e44 = (_e43 / 256u);
    if ((_e43 % 256u) > 0u) {
        phi_99_ = (_e44 + 1u);
    } else {
        phi_99_ = _e44;
    }
    let _e49 = phi_99_;
    let _e53 = table.member[((256u * _e49) + _e23)];
    sums[_e23] = _e53;
    phi_115_ = type_9(0u, 8u);
    phi_118_ = 0u;
    phi_120_ = 1u;
    phi_122_ = _e53;
    phi_119_ = 256u;
    loop {
        let _e56 = phi_115_;
        let _e58 = phi_118_;
        let _e60 = phi_120_;
        let _e62 = phi_122_;
        let _e64 = phi_119_;
        local = _e62;
        if (_e56.member < _e56.member_1) {
            phi_116_ = type_9((_e56.member + 1u), _e56.member_1);
            phi_145_ = type_9(1u, _e56.member);
        } else {
            phi_116_ = _e56;
            phi_145_ = type_9(0u, type_9().member_1);
        }
        let _e76 = phi_116_;
        let _e78 = phi_145_;
        let _e81 = (bitcast<i32>(_e78.member) != 0i);
        if _e81 {
            workgroupBarrier();
            if (_e23 >= _e60) {
                let _e86 = sums[((_e58 + _e23) - _e60)];
                phi_161_ = (_e62 + _e86);
            } else {
                phi_161_ = _e62;
            }
            let _e89 = phi_161_;
            sums[(_e64 + _e23)] = _e89;
            phi_121_ = (_e60 * 2u);
            phi_123_ = _e89;
        } else {
            phi_121_ = u32();
            phi_123_ = u32();
        }
        let _e94 = phi_121_;
        let _e96 = phi_123_;
        continue;
        continuing {
            phi_115_ = _e76;
            phi_118_ = _e64;
            phi_120_ = _e94;
            phi_122_ = _e96;
            phi_119_ = _e58;
            break if !(_e81);
        }
    }
    workgroupBarrier();
    let _e99 = local;
    starts[_e23] = (_e99 - _e53);
    workgroupBarrier();
    let _e104 = params.member.member_1.member;
    let _e107 = params.member.member_1.member_2;
    let _e109 = contacts.member[0u];
    if (_e107 < _e109) {
        phi_187_ = _e107;
    } else {
        phi_187_ = _e109;
    }
    let _e112 = phi_187_;
    if (_e112 < _e104) {
        phi_192_ = _e112;
    } else {
        phi_192_ = _e104;
    }
    let _e115 = phi_192_;
    if (_e35 < _e115) {
        let _e118 = (7u * _e35);
        let _e121 = contacts.member[(4u + _e118)];
        let _e124 = params.member.member.member[0u];
        let _e128 = contacts.member[(_e118 + 6u)];
        let _e129 = ((_e121 * _e124) + _e128);
        if (_e49 == 0u) {
            return;
        }
        let _e133 = starts[(_e129 / _e49)];
        let _e135 = table.member[_e129];
        let _e138 = ranks.member[_e35];
        slots.member[((_e133 + _e135) + _e138)] = _e35;
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn place_contacts(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}

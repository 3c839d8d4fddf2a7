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
    var phi_115_: type_9;
    var phi_118_: u32;
    var phi_120_: u32;
    var phi_122_: u32;
    var phi_119_: u32;
    var phi_161_: u32;
    var phi_121_: u32;
    var phi_123_: u32;
    var local: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e20 = id_2;
    let _e21 = n_2;
    let _e22 = lane_2;
    let _e34 = ((((_e20.y * _e21.x) + _e20.x) * 256u) + _e22);
    let _e38 = params.member.member.member[0u];
    let _e41 = params.member.member.member[1u];
    let _e42 = (_e38 + _e41);
    let _e43 = (_e42 / 256u);
    let _e47 = select(_e43, (_e43 + 1u), ((_e42 % 256u) > 0u));
    let _e51 = table.member[((256u * _e47) + _e22)];
    sums[_e22] = _e51;
    phi_115_ = type_9(0u, 8u);
    phi_118_ = 0u;
    phi_120_ = 1u;
    phi_122_ = _e51;
    phi_119_ = 256u;
    loop {
        let _e54 = phi_115_;
        let _e56 = phi_118_;
        let _e58 = phi_120_;
        let _e60 = phi_122_;
        let _e62 = phi_119_;
        local = _e60;
        let _e65 = (_e54.member < _e54.member_1);
        let _e76 = (bitcast<i32>(select(0u, 1u, _e65)) != 0i);
        if _e76 {
            workgroupBarrier();
            if (_e22 >= _e58) {
                let _e81 = sums[((_e56 + _e22) - _e58)];
                phi_161_ = (_e60 + _e81);
            } else {
                phi_161_ = _e60;
            }
            let _e84 = phi_161_;
            sums[(_e62 + _e22)] = _e84;
            phi_121_ = (_e58 * 2u);
            phi_123_ = _e84;
        } else {
            phi_121_ = u32();
            phi_123_ = u32();
        }
        let _e89 = phi_121_;
        let _e91 = phi_123_;
        continue;
        continuing {
            phi_115_ = type_9(select(_e54.member, (_e54.member + 1u), _e65), select(_e54.member_1, _e54.member_1, _e65));
            phi_118_ = _e62;
            phi_120_ = _e89;
            phi_122_ = _e91;
            phi_119_ = _e56;
            break if !(_e76);
        }
    }
    workgroupBarrier();
    let _e94 = local;
    starts[_e22] = (_e94 - _e51);
    workgroupBarrier();
    let _e99 = params.member.member_1.member;
    let _e102 = params.member.member_1.member_2;
    let _e104 = contacts.member[0u];
    let _e106 = select(_e104, _e102, (_e102 < _e104));
    if (_e34 < select(_e99, _e106, (_e106 < _e99))) {
        let _e111 = (7u * _e34);
        let _e114 = contacts.member[(4u + _e111)];
        let _e117 = params.member.member.member[0u];
        let _e121 = contacts.member[(_e111 + 6u)];
        let _e122 = ((_e114 * _e117) + _e121);
        if (_e47 == 0u) {
            return;
        }
        let _e126 = starts[(_e122 / _e47)];
        let _e128 = table.member[_e122];
        let _e131 = ranks.member[_e34];
        slots.member[((_e126 + _e128) + _e131)] = _e34;
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn place_contacts(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}

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

struct type_17 {
    member: array<vec4<u32>>,
}

struct type_18 {
    member: u32,
}

struct type_19 {
    member: type_7,
    member_1: type_8,
    member_2: type_18,
}

struct type_20 {
    member: type_19,
}

var<workgroup> sums: array<u32, 512>;
@group(0) @binding(0) 
var<storage> params: type_20;
@group(0) @binding(1) 
var<storage> contacts: type_11;
@group(0) @binding(2) 
var<storage> table: type_11;
@group(0) @binding(3) 
var<storage> ranks: type_11;
@group(0) @binding(4) 
var<storage, read_write> slots: type_17;
var<workgroup> starts: array<u32, 256>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_131_: type_9;
    var phi_134_: u32;
    var phi_136_: u32;
    var phi_138_: u32;
    var phi_135_: u32;
    var phi_177_: u32;
    var phi_137_: u32;
    var phi_139_: u32;
    var local: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e27 = id_2;
    let _e28 = n_2;
    let _e29 = lane_2;
    let _e41 = ((((_e27.y * _e28.x) + _e27.x) * 256u) + _e29);
    let _e45 = params.member.member.member[0u];
    let _e48 = params.member.member.member[1u];
    let _e49 = (_e45 + _e48);
    let _e50 = (_e49 / 256u);
    let _e54 = select(_e50, (_e50 + 1u), ((_e49 % 256u) > 0u));
    let _e58 = table.member[((256u * _e54) + _e29)];
    sums[_e29] = _e58;
    phi_131_ = type_9(0u, 8u);
    phi_134_ = 0u;
    phi_136_ = 1u;
    phi_138_ = _e58;
    phi_135_ = 256u;
    loop {
        let _e61 = phi_131_;
        let _e63 = phi_134_;
        let _e65 = phi_136_;
        let _e67 = phi_138_;
        let _e69 = phi_135_;
        local = _e67;
        let _e72 = (_e61.member < _e61.member_1);
        let _e83 = (bitcast<i32>(select(0u, 1u, _e72)) != 0i);
        if _e83 {
            workgroupBarrier();
            if (_e29 >= _e65) {
                let _e88 = sums[((_e63 + _e29) - _e65)];
                phi_177_ = (_e67 + _e88);
            } else {
                phi_177_ = _e67;
            }
            let _e91 = phi_177_;
            sums[(_e69 + _e29)] = _e91;
            phi_137_ = (_e65 * 2u);
            phi_139_ = _e91;
        } else {
            phi_137_ = u32();
            phi_139_ = u32();
        }
        let _e96 = phi_137_;
        let _e98 = phi_139_;
        continue;
        continuing {
            phi_131_ = type_9(select(_e61.member, (_e61.member + 1u), _e72), select(_e61.member_1, _e61.member_1, _e72));
            phi_134_ = _e69;
            phi_136_ = _e96;
            phi_138_ = _e98;
            phi_135_ = _e63;
            break if !(_e83);
        }
    }
    workgroupBarrier();
    let _e101 = local;
    starts[_e29] = (_e101 - _e58);
    workgroupBarrier();
    let _e106 = params.member.member_1.member;
    let _e109 = params.member.member_1.member_2;
    let _e111 = contacts.member[0u];
    let _e113 = select(_e111, _e109, (_e109 < _e111));
    if (_e41 < select(_e106, _e113, (_e113 < _e106))) {
        let _e118 = (7u * _e41);
        let _e121 = contacts.member[(4u + _e118)];
        let _e124 = params.member.member.member[0u];
        let _e128 = contacts.member[(_e118 + 6u)];
        let _e129 = ((_e121 * _e124) + _e128);
        if (_e54 == 0u) {
            return;
        }
        let _e133 = starts[(_e129 / _e54)];
        let _e135 = table.member[_e129];
        let _e137 = (7u * _e41);
        let _e140 = contacts.member[(4u + _e137)];
        let _e143 = contacts.member[(_e137 + 5u)];
        let _e146 = contacts.member[(_e137 + 6u)];
        let _e149 = contacts.member[(_e137 + 7u)];
        let _e152 = contacts.member[(_e137 + 8u)];
        let _e155 = contacts.member[(_e137 + 9u)];
        let _e158 = contacts.member[(_e137 + 10u)];
        let _e170 = ranks.member[_e41];
        slots.member[((_e133 + _e135) + _e170)] = vec4<u32>((_e146 | (_e140 << bitcast<u32>(31i))), (_e149 | (_e143 << bitcast<u32>(31i))), _e152, ((_e155 & 1073741823u) | (_e158 << bitcast<u32>(30i))));
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn place_contacts(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}

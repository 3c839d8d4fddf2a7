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
    member: array<vec4<u32>>,
}

struct type_17 {
    member: u32,
}

struct type_18 {
    member: type_7,
    member_1: type_8,
    member_2: type_17,
}

struct type_19 {
    member: type_18,
}

struct type_22 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_19;
@group(0) @binding(1) 
var<storage> contacts: type_11;
@group(0) @binding(2) 
var<storage> slots: type_16;
@group(0) @binding(3) 
var<storage, read_write> ordered: type_16;
@group(0) @binding(4) 
var<storage, read_write> table: type_22;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_123_: type_9;
    var phi_126_: u32;
    var phi_128_: u32;
    var phi_187_: u32;
    var phi_188_: u32;
    var phi_189_: bool;
    var phi_127_: u32;
    var phi_129_: u32;
    var phi_190_: bool;
    var phi_197_: type_9;
    var phi_200_: u32;
    var phi_202_: u32;
    var phi_262_: u32;
    var phi_263_: u32;
    var phi_264_: bool;
    var phi_201_: u32;
    var phi_203_: u32;
    var phi_265_: bool;
    var local: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e18 = id_2;
    let _e19 = n_2;
    let _e20 = lane_2;
    let _e32 = ((((_e18.y * _e19.x) + _e18.x) * 256u) + _e20);
    let _e35 = params.member.member_1.member;
    let _e38 = params.member.member_1.member_2;
    let _e40 = contacts.member[0u];
    let _e42 = select(_e40, _e38, (_e38 < _e40));
    let _e44 = select(_e35, _e42, (_e42 < _e35));
    if (_e32 < _e44) {
        let _e47 = slots.member[_e32];
        let _e50 = (_e47.y & 2147483647u);
        phi_123_ = type_9(0u, 4097u);
        phi_126_ = 0u;
        phi_128_ = _e32;
        loop {
            let _e52 = phi_123_;
            let _e54 = phi_126_;
            let _e56 = phi_128_;
            local_4 = _e54;
            local_1 = _e56;
            local_2 = _e56;
            let _e59 = (_e52.member < _e52.member_1);
            if (bitcast<i32>(select(0u, 1u, _e59)) != 0i) {
                if (_e56 == 0u) {
                    phi_187_ = u32();
                    phi_188_ = u32();
                    phi_189_ = false;
                } else {
                    let _e74 = slots.member[(_e56 - 1u)];
                    let _e78 = (_e74.x != _e47.x);
                    phi_187_ = select((_e54 + select(0u, 1u, ((_e74.y & 2147483647u) <= _e50))), u32(), _e78);
                    phi_188_ = select((_e56 - 1u), u32(), _e78);
                    phi_189_ = select(true, false, _e78);
                }
                let _e87 = phi_187_;
                let _e89 = phi_188_;
                let _e91 = phi_189_;
                phi_127_ = _e87;
                phi_129_ = _e89;
                phi_190_ = _e91;
            } else {
                phi_127_ = u32();
                phi_129_ = u32();
                phi_190_ = false;
            }
            let _e93 = phi_127_;
            let _e95 = phi_129_;
            let _e97 = phi_190_;
            continue;
            continuing {
                phi_123_ = type_9(select(_e52.member, (_e52.member + 1u), _e59), select(_e52.member_1, _e52.member_1, _e59));
                phi_126_ = _e93;
                phi_128_ = _e95;
                break if !(_e97);
            }
        }
        phi_197_ = type_9(0u, 4097u);
        phi_200_ = _e32;
        let _e194 = local_4;
        phi_202_ = _e194;
        loop {
            let _e100 = phi_197_;
            let _e102 = phi_200_;
            let _e104 = phi_202_;
            local = _e102;
            local_3 = _e104;
            let _e107 = (_e100.member < _e100.member_1);
            if (bitcast<i32>(select(0u, 1u, _e107)) != 0i) {
                if ((_e102 + 1u) >= _e44) {
                    phi_262_ = u32();
                    phi_263_ = u32();
                    phi_264_ = false;
                } else {
                    let _e123 = slots.member[(_e102 + 1u)];
                    let _e127 = (_e123.x != _e47.x);
                    phi_262_ = select((_e102 + 1u), u32(), _e127);
                    phi_263_ = select((_e104 + select(0u, 1u, ((_e123.y & 2147483647u) < _e50))), u32(), _e127);
                    phi_264_ = select(true, false, _e127);
                }
                let _e136 = phi_262_;
                let _e138 = phi_263_;
                let _e140 = phi_264_;
                phi_201_ = _e136;
                phi_203_ = _e138;
                phi_265_ = _e140;
            } else {
                phi_201_ = u32();
                phi_203_ = u32();
                phi_265_ = false;
            }
            let _e142 = phi_201_;
            let _e144 = phi_203_;
            let _e146 = phi_265_;
            continue;
            continuing {
                phi_197_ = type_9(select(_e100.member, (_e100.member + 1u), _e107), select(_e100.member_1, _e100.member_1, _e107));
                phi_200_ = _e142;
                phi_202_ = _e144;
                break if !(_e146);
            }
        }
        let _e149 = local;
        let _e151 = local_1;
        let _e153 = ((_e149 - _e151) > 4096u);
        let _e155 = local_2;
        let _e157 = local_3;
        if select(true, false, _e153) {
        } else {
            let _e164 = params.member.member.member[0u];
            let _e167 = params.member.member.member[1u];
            let _e168 = (_e164 + _e167);
            let _e169 = (_e168 / 256u);
            let _e177 = atomicOr((&table.member[((256u * select(_e169, (_e169 + 1u), ((_e168 % 256u) > 0u))) + 256u)]), 1u);
        }
        let _e179 = slots.member[_e32];
        ordered.member[select((_e155 + _e157), _e32, _e153)] = _e179;
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn order_contacts(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}

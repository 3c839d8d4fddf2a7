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

struct type_13 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_14 {
    member: type_7,
    member_1: type_8,
    member_2: type_13,
}

struct type_15 {
    member: type_14,
}

@group(0) @binding(3) 
var<storage, read_write> table: type_11;
@group(0) @binding(0) 
var<storage> params: type_15;
@group(0) @binding(1) 
var<storage> levels: type_11;
@group(0) @binding(2) 
var<storage> present: type_11;
var<workgroup> counts: array<atomic<u32>, 256>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<u32, 3>;
    var local_1: array<u32, 3>;
    var phi_154_: u32;
    var phi_176_: u32;
    var phi_193_: type_9;
    var phi_196_: u32;
    var phi_197_: u32;
    var phi_259_: type_9;
    var phi_262_: u32;
    var phi_263_: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_320_: array<u32, 2>;
    var phi_326_: type_9;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e22 = id_2;
    let _e23 = n_2;
    let _e24 = lane_2;
    let _e33 = ((_e22.y * _e23.x) + _e22.x);
    let _e36 = params.member.member_2.member;
    let _e40 = params.member.member.member[_e36];
    let _e41 = (_e40 - 1u);
    atomicStore((&counts[_e24]), 0u);
    workgroupBarrier();
    let _e44 = ((_e33 * 256u) + _e24);
    if (_e44 < _e41) {
        let _e47 = present.member[0u];
        let _e49 = present.member[1u];
        let _e51 = present.member[2u];
        let _e53 = levels.member[_e44];
        if (_e44 > 0u) {
            let _e57 = levels.member[(_e44 - 1u)];
            phi_154_ = select(_e57, _e53, (_e57 < _e53));
        } else {
            phi_154_ = _e53;
        }
        let _e61 = phi_154_;
        if ((_e44 + 1u) < _e41) {
            let _e66 = levels.member[(_e44 + 1u)];
            phi_176_ = select(_e66, _e61, (_e66 < _e61));
        } else {
            phi_176_ = _e61;
        }
        let _e70 = phi_176_;
        let _e72 = levels.member[_e44];
        local_1 = array<u32, 3>(_e47, _e49, _e51);
        phi_193_ = type_9(0u, 3u);
        phi_196_ = 0u;
        loop {
            let _e75 = phi_193_;
            let _e77 = phi_196_;
            local_2 = _e77;
            let _e80 = (_e75.member < _e75.member_1);
            let _e91 = select(type_9().member_1, _e75.member, _e80);
            let _e93 = (bitcast<i32>(select(0u, 1u, _e80)) != 0i);
            if _e93 {
                let _e94 = (32u * _e91);
                let _e106 = local_1[_e91];
                phi_197_ = (_e77 + countOneBits((_e106 & select(select(0u, ((1u << bitcast<u32>(((_e72 - _e94) & 31u))) - 1u), (_e72 > _e94)), 4294967295u, (_e72 >= (_e94 + 32u))))));
            } else {
                phi_197_ = u32();
            }
            let _e111 = phi_197_;
            continue;
            continuing {
                phi_193_ = type_9(select(_e75.member, (_e75.member + 1u), _e80), select(_e75.member_1, _e75.member_1, _e80));
                phi_196_ = _e111;
                break if !(_e93);
            }
        }
        local = array<u32, 3>(_e47, _e49, _e51);
        phi_259_ = type_9(0u, 3u);
        phi_262_ = 0u;
        loop {
            let _e115 = phi_259_;
            let _e117 = phi_262_;
            local_3 = _e117;
            let _e120 = (_e115.member < _e115.member_1);
            let _e131 = select(type_9().member_1, _e115.member, _e120);
            let _e133 = (bitcast<i32>(select(0u, 1u, _e120)) != 0i);
            if _e133 {
                let _e134 = (32u * _e131);
                let _e146 = local[_e131];
                phi_263_ = (_e117 + countOneBits((_e146 & select(select(0u, ((1u << bitcast<u32>(((_e70 - _e134) & 31u))) - 1u), (_e70 > _e134)), 4294967295u, (_e70 >= (_e134 + 32u))))));
            } else {
                phi_263_ = u32();
            }
            let _e151 = phi_263_;
            continue;
            continuing {
                phi_259_ = type_9(select(_e115.member, (_e115.member + 1u), _e120), select(_e115.member_1, _e115.member_1, _e120));
                phi_262_ = _e151;
                break if !(_e133);
            }
        }
        let _e154 = local_2;
        let _e156 = local_3;
        phi_320_ = array<u32, 2>(_e154, _e156);
    } else {
        phi_320_ = array<u32, 2>(1u, 0u);
    }
    let _e159 = phi_320_;
    phi_326_ = type_9(_e159[0], (_e159[1] + 1u));
    loop {
        let _e165 = phi_326_;
        let _e168 = (_e165.member < _e165.member_1);
        let _e181 = (bitcast<i32>(select(0u, 1u, _e168)) != 0i);
        if _e181 {
            let _e183 = atomicAdd((&counts[select(type_9().member_1, _e165.member, _e168)]), 1u);
        }
        continue;
        continuing {
            phi_326_ = type_9(select(_e165.member, (_e165.member + 1u), _e168), select(_e165.member_1, _e165.member_1, _e168));
            break if !(_e181);
        }
    }
    workgroupBarrier();
    let _e185 = (_e41 / 256u);
    let _e189 = select(_e185, (_e185 + 1u), ((_e41 % 256u) > 0u));
    if (_e33 < _e189) {
        let _e194 = atomicLoad((&counts[_e24]));
        table.member[((_e24 * _e189) + _e33)] = _e194;
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn split_count(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}

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
var<storage> keys: type_13;
@group(0) @binding(2) 
var<storage, read_write> table: type_13;
var<workgroup> counts: array<atomic<u32>, 256>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_105_: u32;
    var phi_124_: u32;
    var phi_143_: u32;
    var phi_162_: u32;
    var phi_181_: u32;
    var phi_200_: u32;
    var phi_219_: u32;
    var phi_238_: u32;
    var phi_257_: u32;
    var phi_276_: u32;
    var phi_295_: u32;
    var phi_314_: u32;
    var phi_333_: u32;
    var phi_352_: u32;
    var phi_371_: u32;
    var phi_390_: u32;
    var phi_608_: type_9;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e30 = id_2;
    let _e31 = n_2;
    let _e32 = lane_2;
    let _e40 = ((_e30.y * _e31.x) + _e30.x);
    atomicStore((&counts[_e32]), 0u);
    atomicStore((&counts[(_e32 + 128u)]), 0u);
    workgroupBarrier();
    let _e45 = ((_e40 * 2048u) + _e32);
    let _e48 = params.member.member_2.member;
    let _e51 = params.member.member_1.member;
    if (_e45 < _e51) {
        let _e54 = keys.member[_e45];
        phi_105_ = _e54;
    } else {
        phi_105_ = 0u;
    }
    let _e56 = phi_105_;
    let _e59 = params.member.member_1.member;
    let _e60 = (_e45 + 128u);
    if (_e60 < _e59) {
        let _e63 = keys.member[_e60];
        phi_124_ = _e63;
    } else {
        phi_124_ = 0u;
    }
    let _e65 = phi_124_;
    let _e68 = params.member.member_1.member;
    let _e69 = (_e45 + 256u);
    if (_e69 < _e68) {
        let _e72 = keys.member[_e69];
        phi_143_ = _e72;
    } else {
        phi_143_ = 0u;
    }
    let _e74 = phi_143_;
    let _e77 = params.member.member_1.member;
    let _e78 = (_e45 + 384u);
    if (_e78 < _e77) {
        let _e81 = keys.member[_e78];
        phi_162_ = _e81;
    } else {
        phi_162_ = 0u;
    }
    let _e83 = phi_162_;
    let _e86 = params.member.member_1.member;
    let _e87 = (_e45 + 512u);
    if (_e87 < _e86) {
        let _e90 = keys.member[_e87];
        phi_181_ = _e90;
    } else {
        phi_181_ = 0u;
    }
    let _e92 = phi_181_;
    let _e95 = params.member.member_1.member;
    let _e96 = (_e45 + 640u);
    if (_e96 < _e95) {
        let _e99 = keys.member[_e96];
        phi_200_ = _e99;
    } else {
        phi_200_ = 0u;
    }
    let _e101 = phi_200_;
    let _e104 = params.member.member_1.member;
    let _e105 = (_e45 + 768u);
    if (_e105 < _e104) {
        let _e108 = keys.member[_e105];
        phi_219_ = _e108;
    } else {
        phi_219_ = 0u;
    }
    let _e110 = phi_219_;
    let _e113 = params.member.member_1.member;
    let _e114 = (_e45 + 896u);
    if (_e114 < _e113) {
        let _e117 = keys.member[_e114];
        phi_238_ = _e117;
    } else {
        phi_238_ = 0u;
    }
    let _e119 = phi_238_;
    let _e122 = params.member.member_1.member;
    let _e123 = (_e45 + 1024u);
    if (_e123 < _e122) {
        let _e126 = keys.member[_e123];
        phi_257_ = _e126;
    } else {
        phi_257_ = 0u;
    }
    let _e128 = phi_257_;
    let _e131 = params.member.member_1.member;
    let _e132 = (_e45 + 1152u);
    if (_e132 < _e131) {
        let _e135 = keys.member[_e132];
        phi_276_ = _e135;
    } else {
        phi_276_ = 0u;
    }
    let _e137 = phi_276_;
    let _e140 = params.member.member_1.member;
    let _e141 = (_e45 + 1280u);
    if (_e141 < _e140) {
        let _e144 = keys.member[_e141];
        phi_295_ = _e144;
    } else {
        phi_295_ = 0u;
    }
    let _e146 = phi_295_;
    let _e149 = params.member.member_1.member;
    let _e150 = (_e45 + 1408u);
    if (_e150 < _e149) {
        let _e153 = keys.member[_e150];
        phi_314_ = _e153;
    } else {
        phi_314_ = 0u;
    }
    let _e155 = phi_314_;
    let _e158 = params.member.member_1.member;
    let _e159 = (_e45 + 1536u);
    if (_e159 < _e158) {
        let _e162 = keys.member[_e159];
        phi_333_ = _e162;
    } else {
        phi_333_ = 0u;
    }
    let _e164 = phi_333_;
    let _e167 = params.member.member_1.member;
    let _e168 = (_e45 + 1664u);
    if (_e168 < _e167) {
        let _e171 = keys.member[_e168];
        phi_352_ = _e171;
    } else {
        phi_352_ = 0u;
    }
    let _e173 = phi_352_;
    let _e176 = params.member.member_1.member;
    let _e177 = (_e45 + 1792u);
    if (_e177 < _e176) {
        let _e180 = keys.member[_e177];
        phi_371_ = _e180;
    } else {
        phi_371_ = 0u;
    }
    let _e182 = phi_371_;
    let _e185 = params.member.member_1.member;
    let _e186 = (_e45 + 1920u);
    if (_e186 < _e185) {
        let _e189 = keys.member[_e186];
        phi_390_ = _e189;
    } else {
        phi_390_ = 0u;
    }
    let _e191 = phi_390_;
    let _e194 = params.member.member_1.member;
    if (_e45 < _e194) {
        let _e201 = atomicAdd((&counts[((_e56 >> bitcast<u32>((_e48 & 31u))) & 255u)]), 1u);
    }
    let _e205 = params.member.member_1.member;
    if ((_e45 + 128u) < _e205) {
        let _e212 = atomicAdd((&counts[((_e65 >> bitcast<u32>((_e48 & 31u))) & 255u)]), 1u);
    }
    let _e216 = params.member.member_1.member;
    if ((_e45 + 256u) < _e216) {
        let _e223 = atomicAdd((&counts[((_e74 >> bitcast<u32>((_e48 & 31u))) & 255u)]), 1u);
    }
    let _e227 = params.member.member_1.member;
    if ((_e45 + 384u) < _e227) {
        let _e234 = atomicAdd((&counts[((_e83 >> bitcast<u32>((_e48 & 31u))) & 255u)]), 1u);
    }
    let _e238 = params.member.member_1.member;
    if ((_e45 + 512u) < _e238) {
        let _e245 = atomicAdd((&counts[((_e92 >> bitcast<u32>((_e48 & 31u))) & 255u)]), 1u);
    }
    let _e249 = params.member.member_1.member;
    if ((_e45 + 640u) < _e249) {
        let _e256 = atomicAdd((&counts[((_e101 >> bitcast<u32>((_e48 & 31u))) & 255u)]), 1u);
    }
    let _e260 = params.member.member_1.member;
    if ((_e45 + 768u) < _e260) {
        let _e267 = atomicAdd((&counts[((_e110 >> bitcast<u32>((_e48 & 31u))) & 255u)]), 1u);
    }
    let _e271 = params.member.member_1.member;
    if ((_e45 + 896u) < _e271) {
        let _e278 = atomicAdd((&counts[((_e119 >> bitcast<u32>((_e48 & 31u))) & 255u)]), 1u);
    }
    let _e282 = params.member.member_1.member;
    if ((_e45 + 1024u) < _e282) {
        let _e289 = atomicAdd((&counts[((_e128 >> bitcast<u32>((_e48 & 31u))) & 255u)]), 1u);
    }
    let _e293 = params.member.member_1.member;
    if ((_e45 + 1152u) < _e293) {
        let _e300 = atomicAdd((&counts[((_e137 >> bitcast<u32>((_e48 & 31u))) & 255u)]), 1u);
    }
    let _e304 = params.member.member_1.member;
    if ((_e45 + 1280u) < _e304) {
        let _e311 = atomicAdd((&counts[((_e146 >> bitcast<u32>((_e48 & 31u))) & 255u)]), 1u);
    }
    let _e315 = params.member.member_1.member;
    if ((_e45 + 1408u) < _e315) {
        let _e322 = atomicAdd((&counts[((_e155 >> bitcast<u32>((_e48 & 31u))) & 255u)]), 1u);
    }
    let _e326 = params.member.member_1.member;
    if ((_e45 + 1536u) < _e326) {
        let _e333 = atomicAdd((&counts[((_e164 >> bitcast<u32>((_e48 & 31u))) & 255u)]), 1u);
    }
    let _e337 = params.member.member_1.member;
    if ((_e45 + 1664u) < _e337) {
        let _e344 = atomicAdd((&counts[((_e173 >> bitcast<u32>((_e48 & 31u))) & 255u)]), 1u);
    }
    let _e348 = params.member.member_1.member;
    if ((_e45 + 1792u) < _e348) {
        let _e355 = atomicAdd((&counts[((_e182 >> bitcast<u32>((_e48 & 31u))) & 255u)]), 1u);
    }
    let _e359 = params.member.member_1.member;
    if ((_e45 + 1920u) < _e359) {
        let _e366 = atomicAdd((&counts[((_e191 >> bitcast<u32>((_e48 & 31u))) & 255u)]), 1u);
    }
    workgroupBarrier();
    let _e369 = params.member.member_2.member_1;
    if (_e40 < _e369) {
        phi_608_ = type_9(0u, 2u);
        loop {
            let _e372 = phi_608_;
            let _e375 = (_e372.member < _e372.member_1);
            let _e388 = (bitcast<i32>(select(0u, 1u, _e375)) != 0i);
            if _e388 {
                let _e390 = (_e32 + (select(type_9().member_1, _e372.member, _e375) * 128u));
                let _e393 = params.member.member_2.member_1;
                let _e397 = atomicLoad((&counts[_e390]));
                table.member[((_e390 * _e393) + _e40)] = _e397;
            }
            continue;
            continuing {
                phi_608_ = type_9(select(_e372.member, (_e372.member + 1u), _e375), select(_e372.member_1, _e372.member_1, _e375));
                break if !(_e388);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn sort_count(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}

struct type_8 {
    member: array<u32, 3>,
    member_1: u32,
    member_2: array<u32, 4>,
    member_3: f32,
    member_4: f32,
    member_5: f32,
    member_6: f32,
    member_7: array<u32, 2>,
    member_8: u32,
    member_9: u32,
    member_10: u32,
    member_11: u32,
    member_12: u32,
    member_13: u32,
    member_14: u32,
    member_15: u32,
    member_16: u32,
    member_17: u32,
    member_18: array<array<u32, 2>, 3>,
    member_19: array<u32, 2>,
    member_20: array<array<u32, 4>, 8>,
}

struct type_9 {
    member: type_8,
}

struct type_11 {
    member: array<u32>,
}

struct type_13 {
    member: u32,
    member_1: u32,
}

@group(0) @binding(0) 
var<storage> params: type_9;
@group(0) @binding(1) 
var<storage> keys: type_11;
@group(0) @binding(2) 
var<storage, read_write> table: type_11;
var<workgroup> counts: array<atomic<u32>, 256>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_104_: u32;
    var phi_122_: u32;
    var phi_140_: u32;
    var phi_158_: u32;
    var phi_176_: u32;
    var phi_194_: u32;
    var phi_212_: u32;
    var phi_230_: u32;
    var phi_248_: u32;
    var phi_266_: u32;
    var phi_284_: u32;
    var phi_302_: u32;
    var phi_320_: u32;
    var phi_338_: u32;
    var phi_356_: u32;
    var phi_374_: u32;
    var phi_575_: type_13;
    var phi_576_: type_13;
    var phi_599_: type_13;
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
    let _e47 = params.member.member_10;
    let _e49 = params.member.member_17;
    if (_e45 < _e49) {
        let _e52 = keys.member[_e45];
        phi_104_ = _e52;
    } else {
        phi_104_ = 0u;
    }
    let _e54 = phi_104_;
    let _e56 = params.member.member_17;
    let _e57 = (_e45 + 128u);
    if (_e57 < _e56) {
        let _e60 = keys.member[_e57];
        phi_122_ = _e60;
    } else {
        phi_122_ = 0u;
    }
    let _e62 = phi_122_;
    let _e64 = params.member.member_17;
    let _e65 = (_e45 + 256u);
    if (_e65 < _e64) {
        let _e68 = keys.member[_e65];
        phi_140_ = _e68;
    } else {
        phi_140_ = 0u;
    }
    let _e70 = phi_140_;
    let _e72 = params.member.member_17;
    let _e73 = (_e45 + 384u);
    if (_e73 < _e72) {
        let _e76 = keys.member[_e73];
        phi_158_ = _e76;
    } else {
        phi_158_ = 0u;
    }
    let _e78 = phi_158_;
    let _e80 = params.member.member_17;
    let _e81 = (_e45 + 512u);
    if (_e81 < _e80) {
        let _e84 = keys.member[_e81];
        phi_176_ = _e84;
    } else {
        phi_176_ = 0u;
    }
    let _e86 = phi_176_;
    let _e88 = params.member.member_17;
    let _e89 = (_e45 + 640u);
    if (_e89 < _e88) {
        let _e92 = keys.member[_e89];
        phi_194_ = _e92;
    } else {
        phi_194_ = 0u;
    }
    let _e94 = phi_194_;
    let _e96 = params.member.member_17;
    let _e97 = (_e45 + 768u);
    if (_e97 < _e96) {
        let _e100 = keys.member[_e97];
        phi_212_ = _e100;
    } else {
        phi_212_ = 0u;
    }
    let _e102 = phi_212_;
    let _e104 = params.member.member_17;
    let _e105 = (_e45 + 896u);
    if (_e105 < _e104) {
        let _e108 = keys.member[_e105];
        phi_230_ = _e108;
    } else {
        phi_230_ = 0u;
    }
    let _e110 = phi_230_;
    let _e112 = params.member.member_17;
    let _e113 = (_e45 + 1024u);
    if (_e113 < _e112) {
        let _e116 = keys.member[_e113];
        phi_248_ = _e116;
    } else {
        phi_248_ = 0u;
    }
    let _e118 = phi_248_;
    let _e120 = params.member.member_17;
    let _e121 = (_e45 + 1152u);
    if (_e121 < _e120) {
        let _e124 = keys.member[_e121];
        phi_266_ = _e124;
    } else {
        phi_266_ = 0u;
    }
    let _e126 = phi_266_;
    let _e128 = params.member.member_17;
    let _e129 = (_e45 + 1280u);
    if (_e129 < _e128) {
        let _e132 = keys.member[_e129];
        phi_284_ = _e132;
    } else {
        phi_284_ = 0u;
    }
    let _e134 = phi_284_;
    let _e136 = params.member.member_17;
    let _e137 = (_e45 + 1408u);
    if (_e137 < _e136) {
        let _e140 = keys.member[_e137];
        phi_302_ = _e140;
    } else {
        phi_302_ = 0u;
    }
    let _e142 = phi_302_;
    let _e144 = params.member.member_17;
    let _e145 = (_e45 + 1536u);
    if (_e145 < _e144) {
        let _e148 = keys.member[_e145];
        phi_320_ = _e148;
    } else {
        phi_320_ = 0u;
    }
    let _e150 = phi_320_;
    let _e152 = params.member.member_17;
    let _e153 = (_e45 + 1664u);
    if (_e153 < _e152) {
        let _e156 = keys.member[_e153];
        phi_338_ = _e156;
    } else {
        phi_338_ = 0u;
    }
    let _e158 = phi_338_;
    let _e160 = params.member.member_17;
    let _e161 = (_e45 + 1792u);
    if (_e161 < _e160) {
        let _e164 = keys.member[_e161];
        phi_356_ = _e164;
    } else {
        phi_356_ = 0u;
    }
    let _e166 = phi_356_;
    let _e168 = params.member.member_17;
    let _e169 = (_e45 + 1920u);
    if (_e169 < _e168) {
        let _e172 = keys.member[_e169];
        phi_374_ = _e172;
    } else {
        phi_374_ = 0u;
    }
    let _e174 = phi_374_;
    let _e176 = params.member.member_17;
    if (_e45 < _e176) {
        let _e183 = atomicAdd((&counts[((_e54 >> bitcast<u32>((_e47 & 31u))) & 255u)]), 1u);
    }
    let _e186 = params.member.member_17;
    if ((_e45 + 128u) < _e186) {
        let _e193 = atomicAdd((&counts[((_e62 >> bitcast<u32>((_e47 & 31u))) & 255u)]), 1u);
    }
    let _e196 = params.member.member_17;
    if ((_e45 + 256u) < _e196) {
        let _e203 = atomicAdd((&counts[((_e70 >> bitcast<u32>((_e47 & 31u))) & 255u)]), 1u);
    }
    let _e206 = params.member.member_17;
    if ((_e45 + 384u) < _e206) {
        let _e213 = atomicAdd((&counts[((_e78 >> bitcast<u32>((_e47 & 31u))) & 255u)]), 1u);
    }
    let _e216 = params.member.member_17;
    if ((_e45 + 512u) < _e216) {
        let _e223 = atomicAdd((&counts[((_e86 >> bitcast<u32>((_e47 & 31u))) & 255u)]), 1u);
    }
    let _e226 = params.member.member_17;
    if ((_e45 + 640u) < _e226) {
        let _e233 = atomicAdd((&counts[((_e94 >> bitcast<u32>((_e47 & 31u))) & 255u)]), 1u);
    }
    let _e236 = params.member.member_17;
    if ((_e45 + 768u) < _e236) {
        let _e243 = atomicAdd((&counts[((_e102 >> bitcast<u32>((_e47 & 31u))) & 255u)]), 1u);
    }
    let _e246 = params.member.member_17;
    if ((_e45 + 896u) < _e246) {
        let _e253 = atomicAdd((&counts[((_e110 >> bitcast<u32>((_e47 & 31u))) & 255u)]), 1u);
    }
    let _e256 = params.member.member_17;
    if ((_e45 + 1024u) < _e256) {
        let _e263 = atomicAdd((&counts[((_e118 >> bitcast<u32>((_e47 & 31u))) & 255u)]), 1u);
    }
    let _e266 = params.member.member_17;
    if ((_e45 + 1152u) < _e266) {
        let _e273 = atomicAdd((&counts[((_e126 >> bitcast<u32>((_e47 & 31u))) & 255u)]), 1u);
    }
    let _e276 = params.member.member_17;
    if ((_e45 + 1280u) < _e276) {
        let _e283 = atomicAdd((&counts[((_e134 >> bitcast<u32>((_e47 & 31u))) & 255u)]), 1u);
    }
    let _e286 = params.member.member_17;
    if ((_e45 + 1408u) < _e286) {
        let _e293 = atomicAdd((&counts[((_e142 >> bitcast<u32>((_e47 & 31u))) & 255u)]), 1u);
    }
    let _e296 = params.member.member_17;
    if ((_e45 + 1536u) < _e296) {
        let _e303 = atomicAdd((&counts[((_e150 >> bitcast<u32>((_e47 & 31u))) & 255u)]), 1u);
    }
    let _e306 = params.member.member_17;
    if ((_e45 + 1664u) < _e306) {
        let _e313 = atomicAdd((&counts[((_e158 >> bitcast<u32>((_e47 & 31u))) & 255u)]), 1u);
    }
    let _e316 = params.member.member_17;
    if ((_e45 + 1792u) < _e316) {
        let _e323 = atomicAdd((&counts[((_e166 >> bitcast<u32>((_e47 & 31u))) & 255u)]), 1u);
    }
    let _e326 = params.member.member_17;
    if ((_e45 + 1920u) < _e326) {
        let _e333 = atomicAdd((&counts[((_e174 >> bitcast<u32>((_e47 & 31u))) & 255u)]), 1u);
    }
    workgroupBarrier();
    let _e335 = params.member.member_11;
    if (_e40 < _e335) {
        phi_575_ = type_13(0u, 2u);
        loop {
            let _e338 = phi_575_;
            if (_e338.member < _e338.member_1) {
                phi_576_ = type_13((_e338.member + 1u), _e338.member_1);
                phi_599_ = type_13(1u, _e338.member);
            } else {
                phi_576_ = _e338;
                phi_599_ = type_13(0u, type_13().member_1);
            }
            let _e350 = phi_576_;
            let _e352 = phi_599_;
            let _e356 = (bitcast<i32>(_e352.member) != 0i);
            if _e356 {
                let _e358 = (_e32 + (_e352.member_1 * 128u));
                let _e360 = params.member.member_11;
                let _e364 = atomicLoad((&counts[_e358]));
                table.member[((_e358 * _e360) + _e40)] = _e364;
            }
            continue;
            continuing {
                phi_575_ = _e350;
                break if !(_e356);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn sort_count(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}

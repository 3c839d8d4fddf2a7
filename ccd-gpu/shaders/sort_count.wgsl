struct type_10 {
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

struct type_12 {
    member: type_10,
}

struct type_16 {
    member: array<u32>,
}

struct type_21 {
    member: u32,
    member_1: u32,
}

var<private> id_1: vec3<u32>;
var<private> n_1: vec3<u32>;
var<private> lane_1: u32;
@group(0) @binding(0) 
var<storage> params: type_12;
@group(0) @binding(1) 
var<storage> keys: type_16;
@group(0) @binding(2) 
var<storage, read_write> table: type_16;
var<workgroup> counts: array<atomic<u32>, 256>;

fn function_() {
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
    var phi_575_: type_21;
    var phi_576_: type_21;
    var phi_599_: type_21;

    let _e38 = id_1;
    let _e39 = n_1;
    let _e40 = lane_1;
    let _e48 = ((_e38.y * _e39.x) + _e38.x);
    atomicStore((&counts[_e40]), 0u);
    atomicStore((&counts[(_e40 + 128u)]), 0u);
    workgroupBarrier();
    let _e53 = ((_e48 * 2048u) + _e40);
    let _e55 = params.member.member_10;
    let _e57 = params.member.member_17;
    if (_e53 < _e57) {
        let _e60 = keys.member[_e53];
        phi_104_ = _e60;
    } else {
        phi_104_ = 0u;
    }
    let _e62 = phi_104_;
    let _e64 = params.member.member_17;
    let _e65 = (_e53 + 128u);
    if (_e65 < _e64) {
        let _e68 = keys.member[_e65];
        phi_122_ = _e68;
    } else {
        phi_122_ = 0u;
    }
    let _e70 = phi_122_;
    let _e72 = params.member.member_17;
    let _e73 = (_e53 + 256u);
    if (_e73 < _e72) {
        let _e76 = keys.member[_e73];
        phi_140_ = _e76;
    } else {
        phi_140_ = 0u;
    }
    let _e78 = phi_140_;
    let _e80 = params.member.member_17;
    let _e81 = (_e53 + 384u);
    if (_e81 < _e80) {
        let _e84 = keys.member[_e81];
        phi_158_ = _e84;
    } else {
        phi_158_ = 0u;
    }
    let _e86 = phi_158_;
    let _e88 = params.member.member_17;
    let _e89 = (_e53 + 512u);
    if (_e89 < _e88) {
        let _e92 = keys.member[_e89];
        phi_176_ = _e92;
    } else {
        phi_176_ = 0u;
    }
    let _e94 = phi_176_;
    let _e96 = params.member.member_17;
    let _e97 = (_e53 + 640u);
    if (_e97 < _e96) {
        let _e100 = keys.member[_e97];
        phi_194_ = _e100;
    } else {
        phi_194_ = 0u;
    }
    let _e102 = phi_194_;
    let _e104 = params.member.member_17;
    let _e105 = (_e53 + 768u);
    if (_e105 < _e104) {
        let _e108 = keys.member[_e105];
        phi_212_ = _e108;
    } else {
        phi_212_ = 0u;
    }
    let _e110 = phi_212_;
    let _e112 = params.member.member_17;
    let _e113 = (_e53 + 896u);
    if (_e113 < _e112) {
        let _e116 = keys.member[_e113];
        phi_230_ = _e116;
    } else {
        phi_230_ = 0u;
    }
    let _e118 = phi_230_;
    let _e120 = params.member.member_17;
    let _e121 = (_e53 + 1024u);
    if (_e121 < _e120) {
        let _e124 = keys.member[_e121];
        phi_248_ = _e124;
    } else {
        phi_248_ = 0u;
    }
    let _e126 = phi_248_;
    let _e128 = params.member.member_17;
    let _e129 = (_e53 + 1152u);
    if (_e129 < _e128) {
        let _e132 = keys.member[_e129];
        phi_266_ = _e132;
    } else {
        phi_266_ = 0u;
    }
    let _e134 = phi_266_;
    let _e136 = params.member.member_17;
    let _e137 = (_e53 + 1280u);
    if (_e137 < _e136) {
        let _e140 = keys.member[_e137];
        phi_284_ = _e140;
    } else {
        phi_284_ = 0u;
    }
    let _e142 = phi_284_;
    let _e144 = params.member.member_17;
    let _e145 = (_e53 + 1408u);
    if (_e145 < _e144) {
        let _e148 = keys.member[_e145];
        phi_302_ = _e148;
    } else {
        phi_302_ = 0u;
    }
    let _e150 = phi_302_;
    let _e152 = params.member.member_17;
    let _e153 = (_e53 + 1536u);
    if (_e153 < _e152) {
        let _e156 = keys.member[_e153];
        phi_320_ = _e156;
    } else {
        phi_320_ = 0u;
    }
    let _e158 = phi_320_;
    let _e160 = params.member.member_17;
    let _e161 = (_e53 + 1664u);
    if (_e161 < _e160) {
        let _e164 = keys.member[_e161];
        phi_338_ = _e164;
    } else {
        phi_338_ = 0u;
    }
    let _e166 = phi_338_;
    let _e168 = params.member.member_17;
    let _e169 = (_e53 + 1792u);
    if (_e169 < _e168) {
        let _e172 = keys.member[_e169];
        phi_356_ = _e172;
    } else {
        phi_356_ = 0u;
    }
    let _e174 = phi_356_;
    let _e176 = params.member.member_17;
    let _e177 = (_e53 + 1920u);
    if (_e177 < _e176) {
        let _e180 = keys.member[_e177];
        phi_374_ = _e180;
    } else {
        phi_374_ = 0u;
    }
    let _e182 = phi_374_;
    let _e184 = params.member.member_17;
    if (_e53 < _e184) {
        let _e191 = atomicAdd((&counts[((_e62 >> bitcast<u32>((_e55 & 31u))) & 255u)]), 1u);
    }
    let _e194 = params.member.member_17;
    if ((_e53 + 128u) < _e194) {
        let _e201 = atomicAdd((&counts[((_e70 >> bitcast<u32>((_e55 & 31u))) & 255u)]), 1u);
    }
    let _e204 = params.member.member_17;
    if ((_e53 + 256u) < _e204) {
        let _e211 = atomicAdd((&counts[((_e78 >> bitcast<u32>((_e55 & 31u))) & 255u)]), 1u);
    }
    let _e214 = params.member.member_17;
    if ((_e53 + 384u) < _e214) {
        let _e221 = atomicAdd((&counts[((_e86 >> bitcast<u32>((_e55 & 31u))) & 255u)]), 1u);
    }
    let _e224 = params.member.member_17;
    if ((_e53 + 512u) < _e224) {
        let _e231 = atomicAdd((&counts[((_e94 >> bitcast<u32>((_e55 & 31u))) & 255u)]), 1u);
    }
    let _e234 = params.member.member_17;
    if ((_e53 + 640u) < _e234) {
        let _e241 = atomicAdd((&counts[((_e102 >> bitcast<u32>((_e55 & 31u))) & 255u)]), 1u);
    }
    let _e244 = params.member.member_17;
    if ((_e53 + 768u) < _e244) {
        let _e251 = atomicAdd((&counts[((_e110 >> bitcast<u32>((_e55 & 31u))) & 255u)]), 1u);
    }
    let _e254 = params.member.member_17;
    if ((_e53 + 896u) < _e254) {
        let _e261 = atomicAdd((&counts[((_e118 >> bitcast<u32>((_e55 & 31u))) & 255u)]), 1u);
    }
    let _e264 = params.member.member_17;
    if ((_e53 + 1024u) < _e264) {
        let _e271 = atomicAdd((&counts[((_e126 >> bitcast<u32>((_e55 & 31u))) & 255u)]), 1u);
    }
    let _e274 = params.member.member_17;
    if ((_e53 + 1152u) < _e274) {
        let _e281 = atomicAdd((&counts[((_e134 >> bitcast<u32>((_e55 & 31u))) & 255u)]), 1u);
    }
    let _e284 = params.member.member_17;
    if ((_e53 + 1280u) < _e284) {
        let _e291 = atomicAdd((&counts[((_e142 >> bitcast<u32>((_e55 & 31u))) & 255u)]), 1u);
    }
    let _e294 = params.member.member_17;
    if ((_e53 + 1408u) < _e294) {
        let _e301 = atomicAdd((&counts[((_e150 >> bitcast<u32>((_e55 & 31u))) & 255u)]), 1u);
    }
    let _e304 = params.member.member_17;
    if ((_e53 + 1536u) < _e304) {
        let _e311 = atomicAdd((&counts[((_e158 >> bitcast<u32>((_e55 & 31u))) & 255u)]), 1u);
    }
    let _e314 = params.member.member_17;
    if ((_e53 + 1664u) < _e314) {
        let _e321 = atomicAdd((&counts[((_e166 >> bitcast<u32>((_e55 & 31u))) & 255u)]), 1u);
    }
    let _e324 = params.member.member_17;
    if ((_e53 + 1792u) < _e324) {
        let _e331 = atomicAdd((&counts[((_e174 >> bitcast<u32>((_e55 & 31u))) & 255u)]), 1u);
    }
    let _e334 = params.member.member_17;
    if ((_e53 + 1920u) < _e334) {
        let _e341 = atomicAdd((&counts[((_e182 >> bitcast<u32>((_e55 & 31u))) & 255u)]), 1u);
    }
    workgroupBarrier();
    let _e343 = params.member.member_11;
    if (_e48 < _e343) {
        phi_575_ = type_21(0u, 2u);
        loop {
            let _e346 = phi_575_;
            if (_e346.member < _e346.member_1) {
                phi_576_ = type_21((_e346.member + 1u), _e346.member_1);
                phi_599_ = type_21(1u, _e346.member);
            } else {
                phi_576_ = _e346;
                phi_599_ = type_21(0u, type_21().member_1);
            }
            let _e360 = phi_576_;
            let _e362 = phi_599_;
            let _e366 = (bitcast<i32>(_e362.member) != 0i);
            if _e366 {
                let _e368 = (_e40 + (_e362.member_1 * 128u));
                let _e370 = params.member.member_11;
                let _e374 = atomicLoad((&counts[_e368]));
                table.member[((_e368 * _e370) + _e48)] = _e374;
            }
            continue;
            continuing {
                phi_575_ = _e360;
                break if !(_e366);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn sort_count(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    id_1 = id;
    n_1 = n;
    lane_1 = lane;
    function_();
}

struct type_9 {
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
    member_18: array<array<u32, 4>, 8>,
}

struct type_11 {
    member: type_9,
}

struct type_15 {
    member: array<u32>,
}

struct type_20 {
    member: u32,
    member_1: u32,
}

var<private> id_1: vec3<u32>;
var<private> n_1: vec3<u32>;
var<private> lane_1: u32;
@group(0) @binding(0) 
var<storage> params: type_11;
@group(0) @binding(1) 
var<storage> table: type_15;
@group(0) @binding(2) 
var<storage> keys: type_15;
@group(0) @binding(3) 
var<storage> values: type_15;
@group(0) @binding(4) 
var<storage, read_write> keys_out: type_15;
@group(0) @binding(5) 
var<storage, read_write> values_out: type_15;
var<workgroup> masks: array<atomic<u32>, 2048>;
var<workgroup> counts: array<atomic<u32>, 1024>;
var<workgroup> ranks: array<u32, 1024>;

fn function_() {
    var phi_88_: type_20;
    var phi_89_: type_20;
    var phi_112_: type_20;
    var phi_134_: type_20;
    var phi_135_: type_20;
    var phi_158_: type_20;
    var phi_212_: u32;
    var phi_241_: u32;
    var phi_335_: type_20;
    var phi_338_: u32;
    var phi_340_: u32;
    var phi_342_: u32;
    var phi_339_: u32;
    var phi_336_: type_20;
    var phi_365_: type_20;
    var phi_381_: u32;
    var phi_341_: u32;
    var phi_343_: u32;
    var local: u32;
    var phi_388_: type_20;
    var phi_391_: u32;
    var phi_389_: type_20;
    var phi_414_: type_20;
    var phi_444_: u32;
    var phi_448_: type_20;
    var phi_451_: u32;
    var phi_449_: type_20;
    var phi_474_: type_20;
    var phi_452_: u32;
    var phi_392_: u32;
    var phi_491_: type_20;
    var phi_492_: type_20;
    var phi_515_: type_20;

    let _e43 = id_1;
    let _e44 = n_1;
    let _e45 = lane_1;
    let _e56 = ((_e43.y * _e44.x) + _e43.x);
    phi_88_ = type_20(0u, 8u);
    loop {
        let _e58 = phi_88_;
        if (_e58.member < _e58.member_1) {
            phi_89_ = type_20((_e58.member + 1u), _e58.member_1);
            phi_112_ = type_20(1u, _e58.member);
        } else {
            phi_89_ = _e58;
            phi_112_ = type_20(0u, type_20().member_1);
        }
        let _e72 = phi_89_;
        let _e74 = phi_112_;
        let _e78 = (bitcast<i32>(_e74.member) != 0i);
        if _e78 {
            atomicStore((&masks[((_e74.member_1 * 128u) + _e45)]), 0u);
            atomicStore((&masks[((1024u + (_e74.member_1 * 128u)) + _e45)]), 0u);
            atomicStore((&counts[((_e74.member_1 * 128u) + _e45)]), 0u);
        }
        continue;
        continuing {
            phi_88_ = _e72;
            break if !(_e78);
        }
    }
    workgroupBarrier();
    let _e91 = ((_e45 / 32u) * 256u);
    phi_134_ = type_20(0u, 8u);
    loop {
        let _e93 = phi_134_;
        if (_e93.member < _e93.member_1) {
            phi_135_ = type_20((_e93.member + 1u), _e93.member_1);
            phi_158_ = type_20(1u, _e93.member);
        } else {
            phi_135_ = _e93;
            phi_158_ = type_20(0u, type_20().member_1);
        }
        let _e107 = phi_135_;
        let _e109 = phi_158_;
        let _e113 = (bitcast<i32>(_e109.member) != 0i);
        if _e113 {
            let _e121 = ((_e56 * 2048u) + ((((_e45 / 32u) * 512u) + (_e109.member_1 * 64u)) + (_e45 % 32u)));
            let _e131 = ((_e56 * 2048u) + ((((_e45 / 32u) * 512u) + (((2u * _e109.member_1) + 1u) * 32u)) + (_e45 % 32u)));
            let _e133 = params.member.member_17;
            if (_e121 < _e133) {
                let _e136 = keys.member[_e121];
                let _e138 = params.member.member_10;
                let _e143 = (_e91 + ((_e136 >> bitcast<u32>((_e138 & 31u))) & 255u));
                let _e149 = atomicOr((&masks[_e143]), (1u << bitcast<u32>(((_e45 % 32u) & 31u))));
                phi_212_ = _e143;
            } else {
                phi_212_ = _e91;
            }
            let _e151 = phi_212_;
            let _e153 = params.member.member_17;
            if (_e131 < _e153) {
                let _e156 = keys.member[_e131];
                let _e158 = params.member.member_10;
                let _e163 = (_e91 + ((_e156 >> bitcast<u32>((_e158 & 31u))) & 255u));
                let _e170 = atomicOr((&masks[(1024u + _e163)]), (1u << bitcast<u32>(((_e45 % 32u) & 31u))));
                phi_241_ = _e163;
            } else {
                phi_241_ = _e91;
            }
            let _e172 = phi_241_;
            workgroupBarrier();
            let _e174 = atomicLoad((&masks[_e151]));
            let _e177 = atomicLoad((&masks[(1024u + _e172)]));
            let _e184 = countOneBits((_e174 & ((1u << bitcast<u32>(((_e45 % 32u) & 31u))) - 1u)));
            let _e191 = countOneBits((_e177 & ((1u << bitcast<u32>(((_e45 % 32u) & 31u))) - 1u)));
            let _e193 = atomicLoad((&counts[_e151]));
            let _e196 = atomicLoad((&counts[_e172]));
            let _e198 = atomicLoad((&masks[_e172]));
            ranks[((_e109.member_1 * 128u) + _e45)] = ((_e193 + _e184) | (((_e196 + countOneBits(_e198)) + _e191) << bitcast<u32>(16i)));
            workgroupBarrier();
            let _e209 = params.member.member_17;
            if (_e121 < _e209) {
                if (_e184 == 0u) {
                    let _e214 = atomicAdd((&counts[_e151]), countOneBits(_e174));
                    atomicStore((&masks[_e151]), 0u);
                }
            }
            let _e217 = params.member.member_17;
            if (_e131 < _e217) {
                if (_e191 == 0u) {
                    let _e222 = atomicAdd((&counts[_e172]), countOneBits(_e177));
                    atomicStore((&masks[(1024u + _e172)]), 0u);
                }
            }
            workgroupBarrier();
        }
        continue;
        continuing {
            phi_134_ = _e107;
            break if !(_e113);
        }
    }
    let _e227 = params.member.member_11;
    let _e228 = (256u * _e227);
    let _e232 = table.member[(_e228 + (2u * _e45))];
    let _e237 = table.member[((_e228 + (2u * _e45)) + 1u)];
    let _e238 = (_e232 + _e237);
    atomicStore((&masks[_e45]), _e238);
    phi_335_ = type_20(0u, 7u);
    phi_338_ = 0u;
    phi_340_ = 1u;
    phi_342_ = _e238;
    phi_339_ = 1024u;
    loop {
        let _e241 = phi_335_;
        let _e243 = phi_338_;
        let _e245 = phi_340_;
        let _e247 = phi_342_;
        let _e249 = phi_339_;
        local = _e247;
        if (_e241.member < _e241.member_1) {
            phi_336_ = type_20((_e241.member + 1u), _e241.member_1);
            phi_365_ = type_20(1u, _e241.member);
        } else {
            phi_336_ = _e241;
            phi_365_ = type_20(0u, type_20().member_1);
        }
        let _e263 = phi_336_;
        let _e265 = phi_365_;
        let _e268 = (bitcast<i32>(_e265.member) != 0i);
        if _e268 {
            workgroupBarrier();
            if (_e45 >= _e245) {
                let _e273 = atomicLoad((&masks[((_e243 + _e45) - _e245)]));
                phi_381_ = (_e247 + _e273);
            } else {
                phi_381_ = _e247;
            }
            let _e276 = phi_381_;
            atomicStore((&masks[(_e249 + _e45)]), _e276);
            phi_341_ = (_e245 * 2u);
            phi_343_ = _e276;
        } else {
            phi_341_ = u32();
            phi_343_ = u32();
        }
        let _e281 = phi_341_;
        let _e283 = phi_343_;
        continue;
        continuing {
            phi_335_ = _e263;
            phi_338_ = _e249;
            phi_340_ = _e281;
            phi_342_ = _e283;
            phi_339_ = _e243;
            break if !(_e268);
        }
    }
    workgroupBarrier();
    let _e286 = local;
    phi_388_ = type_20(0u, 2u);
    phi_391_ = (_e286 - _e238);
    loop {
        let _e289 = phi_388_;
        let _e291 = phi_391_;
        if (_e289.member < _e289.member_1) {
            phi_389_ = type_20((_e289.member + 1u), _e289.member_1);
            phi_414_ = type_20(1u, _e289.member);
        } else {
            phi_389_ = _e289;
            phi_414_ = type_20(0u, type_20().member_1);
        }
        let _e305 = phi_389_;
        let _e307 = phi_414_;
        let _e311 = (bitcast<i32>(_e307.member) != 0i);
        if _e311 {
            let _e313 = ((2u * _e45) + _e307.member_1);
            let _e315 = params.member.member_11;
            if (_e56 < _e315) {
                let _e318 = params.member.member_11;
                let _e322 = table.member[((_e313 * _e318) + _e56)];
                phi_444_ = _e322;
            } else {
                phi_444_ = 0u;
            }
            let _e324 = phi_444_;
            phi_448_ = type_20(0u, 4u);
            phi_451_ = (_e291 + _e324);
            loop {
                let _e327 = phi_448_;
                let _e329 = phi_451_;
                if (_e327.member < _e327.member_1) {
                    phi_449_ = type_20((_e327.member + 1u), _e327.member_1);
                    phi_474_ = type_20(1u, _e327.member);
                } else {
                    phi_449_ = _e327;
                    phi_474_ = type_20(0u, type_20().member_1);
                }
                let _e343 = phi_449_;
                let _e345 = phi_474_;
                let _e349 = (bitcast<i32>(_e345.member) != 0i);
                if _e349 {
                    let _e351 = ((_e345.member_1 * 256u) + _e313);
                    let _e353 = atomicLoad((&counts[_e351]));
                    atomicStore((&counts[_e351]), _e329);
                    phi_452_ = (_e329 + _e353);
                } else {
                    phi_452_ = u32();
                }
                let _e357 = phi_452_;
                continue;
                continuing {
                    phi_448_ = _e343;
                    phi_451_ = _e357;
                    break if !(_e349);
                }
            }
            phi_392_ = (_e291 + _e232);
        } else {
            phi_392_ = u32();
        }
        let _e361 = phi_392_;
        continue;
        continuing {
            phi_388_ = _e305;
            phi_391_ = _e361;
            break if !(_e311);
        }
    }
    workgroupBarrier();
    phi_491_ = type_20(0u, 16u);
    loop {
        let _e364 = phi_491_;
        if (_e364.member < _e364.member_1) {
            phi_492_ = type_20((_e364.member + 1u), _e364.member_1);
            phi_515_ = type_20(1u, _e364.member);
        } else {
            phi_492_ = _e364;
            phi_515_ = type_20(0u, type_20().member_1);
        }
        let _e378 = phi_492_;
        let _e380 = phi_515_;
        let _e384 = (bitcast<i32>(_e380.member) != 0i);
        if _e384 {
            let _e392 = ((_e56 * 2048u) + ((((_e45 / 32u) * 512u) + (_e380.member_1 * 32u)) + (_e45 % 32u)));
            let _e394 = params.member.member_17;
            if (_e392 < _e394) {
                let _e397 = keys.member[_e392];
                let _e402 = ranks[(((_e380.member_1 / 2u) * 128u) + _e45)];
                let _e410 = params.member.member_10;
                let _e417 = atomicLoad((&counts[(_e91 + ((_e397 >> bitcast<u32>((_e410 & 31u))) & 255u))]));
                let _e418 = (_e417 + ((_e402 >> bitcast<u32>(((16u * (_e380.member_1 % 2u)) & 31u))) & 65535u));
                keys_out.member[_e418] = _e397;
                let _e421 = values.member[_e392];
                values_out.member[_e418] = _e421;
            }
        }
        continue;
        continuing {
            phi_491_ = _e378;
            break if !(_e384);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn sort_scatter(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    id_1 = id;
    n_1 = n;
    lane_1 = lane;
    function_();
}

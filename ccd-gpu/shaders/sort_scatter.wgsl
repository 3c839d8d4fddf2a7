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
var<workgroup> masks: array<atomic<u32>, 1024>;
var<workgroup> counts: array<u32, 1024>;
var<workgroup> sums: array<u32, 512>;

fn function_() {
    var local: array<u32, 16>;
    var phi_91_: type_20;
    var phi_92_: type_20;
    var phi_115_: type_20;
    var phi_133_: type_20;
    var phi_134_: type_20;
    var phi_157_: type_20;
    var phi_200_: u32;
    var phi_264_: type_20;
    var phi_267_: u32;
    var phi_268_: u32;
    var phi_269_: u32;
    var phi_271_: u32;
    var phi_265_: type_20;
    var phi_294_: type_20;
    var phi_310_: u32;
    var phi_270_: u32;
    var phi_272_: u32;
    var local_1: u32;
    var phi_317_: type_20;
    var phi_320_: u32;
    var phi_318_: type_20;
    var phi_343_: type_20;
    var phi_373_: u32;
    var phi_377_: type_20;
    var phi_380_: u32;
    var phi_378_: type_20;
    var phi_403_: type_20;
    var phi_381_: u32;
    var phi_321_: u32;
    var phi_420_: type_20;
    var phi_421_: type_20;
    var phi_444_: type_20;

    let _e42 = id_1;
    let _e43 = n_1;
    let _e44 = lane_1;
    let _e55 = ((_e42.y * _e43.x) + _e42.x);
    phi_91_ = type_20(0u, 8u);
    loop {
        let _e57 = phi_91_;
        if (_e57.member < _e57.member_1) {
            phi_92_ = type_20((_e57.member + 1u), _e57.member_1);
            phi_115_ = type_20(1u, _e57.member);
        } else {
            phi_92_ = _e57;
            phi_115_ = type_20(0u, type_20().member_1);
        }
        let _e71 = phi_92_;
        let _e73 = phi_115_;
        let _e77 = (bitcast<i32>(_e73.member) != 0i);
        if _e77 {
            atomicStore((&masks[((_e73.member_1 * 128u) + _e44)]), 0u);
            counts[((_e73.member_1 * 128u) + _e44)] = 0u;
        }
        continue;
        continuing {
            phi_91_ = _e71;
            break if !(_e77);
        }
    }
    workgroupBarrier();
    let _e86 = ((_e44 / 32u) * 256u);
    local = array<u32, 16>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
    phi_133_ = type_20(0u, 16u);
    loop {
        let _e88 = phi_133_;
        if (_e88.member < _e88.member_1) {
            phi_134_ = type_20((_e88.member + 1u), _e88.member_1);
            phi_157_ = type_20(1u, _e88.member);
        } else {
            phi_134_ = _e88;
            phi_157_ = type_20(0u, type_20().member_1);
        }
        let _e102 = phi_134_;
        let _e104 = phi_157_;
        let _e108 = (bitcast<i32>(_e104.member) != 0i);
        if _e108 {
            let _e116 = ((_e55 * 2048u) + ((((_e44 / 32u) * 512u) + (_e104.member_1 * 32u)) + (_e44 % 32u)));
            let _e118 = params.member.member_17;
            if (_e116 < _e118) {
                let _e121 = keys.member[_e116];
                let _e123 = params.member.member_10;
                let _e128 = (_e86 + ((_e121 >> bitcast<u32>((_e123 & 31u))) & 255u));
                let _e134 = atomicOr((&masks[_e128]), (1u << bitcast<u32>(((_e44 % 32u) & 31u))));
                phi_200_ = _e128;
            } else {
                phi_200_ = 0u;
            }
            let _e136 = phi_200_;
            workgroupBarrier();
            let _e138 = atomicLoad((&masks[_e136]));
            let _e145 = countOneBits((_e138 & ((1u << bitcast<u32>(((_e44 % 32u) & 31u))) - 1u)));
            let _e147 = counts[_e136];
            let _e148 = (_e147 + _e145);
            if (_e104.member_1 < 16u) {
            } else {
                return;
            }
            local[_e104.member_1] = _e148;
            workgroupBarrier();
            let _e152 = params.member.member_17;
            if (_e116 < _e152) {
                if (_e145 == 0u) {
                    counts[_e136] = (_e148 + countOneBits(_e138));
                    atomicStore((&masks[_e136]), 0u);
                }
            }
            workgroupBarrier();
        }
        continue;
        continuing {
            phi_133_ = _e102;
            break if !(_e108);
        }
    }
    let _e161 = params.member.member_11;
    let _e162 = (256u * _e161);
    let _e166 = table.member[(_e162 + (2u * _e44))];
    let _e171 = table.member[((_e162 + (2u * _e44)) + 1u)];
    let _e172 = (_e166 + _e171);
    sums[_e44] = _e172;
    phi_264_ = type_20(0u, 7u);
    phi_267_ = 256u;
    phi_268_ = 0u;
    phi_269_ = 1u;
    phi_271_ = _e172;
    loop {
        let _e175 = phi_264_;
        let _e177 = phi_267_;
        let _e179 = phi_268_;
        let _e181 = phi_269_;
        let _e183 = phi_271_;
        local_1 = _e183;
        if (_e175.member < _e175.member_1) {
            phi_265_ = type_20((_e175.member + 1u), _e175.member_1);
            phi_294_ = type_20(1u, _e175.member);
        } else {
            phi_265_ = _e175;
            phi_294_ = type_20(0u, type_20().member_1);
        }
        let _e197 = phi_265_;
        let _e199 = phi_294_;
        let _e202 = (bitcast<i32>(_e199.member) != 0i);
        if _e202 {
            workgroupBarrier();
            if (_e44 >= _e181) {
                let _e207 = sums[((_e179 + _e44) - _e181)];
                phi_310_ = (_e183 + _e207);
            } else {
                phi_310_ = _e183;
            }
            let _e210 = phi_310_;
            sums[(_e177 + _e44)] = _e210;
            phi_270_ = (_e181 * 2u);
            phi_272_ = _e210;
        } else {
            phi_270_ = u32();
            phi_272_ = u32();
        }
        let _e215 = phi_270_;
        let _e217 = phi_272_;
        continue;
        continuing {
            phi_264_ = _e197;
            phi_267_ = _e179;
            phi_268_ = _e177;
            phi_269_ = _e215;
            phi_271_ = _e217;
            break if !(_e202);
        }
    }
    workgroupBarrier();
    let _e220 = local_1;
    phi_317_ = type_20(0u, 2u);
    phi_320_ = (_e220 - _e172);
    loop {
        let _e223 = phi_317_;
        let _e225 = phi_320_;
        if (_e223.member < _e223.member_1) {
            phi_318_ = type_20((_e223.member + 1u), _e223.member_1);
            phi_343_ = type_20(1u, _e223.member);
        } else {
            phi_318_ = _e223;
            phi_343_ = type_20(0u, type_20().member_1);
        }
        let _e239 = phi_318_;
        let _e241 = phi_343_;
        let _e245 = (bitcast<i32>(_e241.member) != 0i);
        if _e245 {
            let _e247 = ((2u * _e44) + _e241.member_1);
            let _e249 = params.member.member_11;
            if (_e55 < _e249) {
                let _e252 = params.member.member_11;
                let _e256 = table.member[((_e247 * _e252) + _e55)];
                phi_373_ = _e256;
            } else {
                phi_373_ = 0u;
            }
            let _e258 = phi_373_;
            phi_377_ = type_20(0u, 4u);
            phi_380_ = (_e225 + _e258);
            loop {
                let _e261 = phi_377_;
                let _e263 = phi_380_;
                if (_e261.member < _e261.member_1) {
                    phi_378_ = type_20((_e261.member + 1u), _e261.member_1);
                    phi_403_ = type_20(1u, _e261.member);
                } else {
                    phi_378_ = _e261;
                    phi_403_ = type_20(0u, type_20().member_1);
                }
                let _e277 = phi_378_;
                let _e279 = phi_403_;
                let _e283 = (bitcast<i32>(_e279.member) != 0i);
                if _e283 {
                    let _e285 = ((_e279.member_1 * 256u) + _e247);
                    let _e287 = counts[_e285];
                    counts[_e285] = _e263;
                    phi_381_ = (_e263 + _e287);
                } else {
                    phi_381_ = u32();
                }
                let _e291 = phi_381_;
                continue;
                continuing {
                    phi_377_ = _e277;
                    phi_380_ = _e291;
                    break if !(_e283);
                }
            }
            phi_321_ = (_e225 + _e166);
        } else {
            phi_321_ = u32();
        }
        let _e295 = phi_321_;
        continue;
        continuing {
            phi_317_ = _e239;
            phi_320_ = _e295;
            break if !(_e245);
        }
    }
    workgroupBarrier();
    phi_420_ = type_20(0u, 16u);
    loop {
        let _e298 = phi_420_;
        if (_e298.member < _e298.member_1) {
            phi_421_ = type_20((_e298.member + 1u), _e298.member_1);
            phi_444_ = type_20(1u, _e298.member);
        } else {
            phi_421_ = _e298;
            phi_444_ = type_20(0u, type_20().member_1);
        }
        let _e312 = phi_421_;
        let _e314 = phi_444_;
        let _e318 = (bitcast<i32>(_e314.member) != 0i);
        if _e318 {
            let _e326 = ((_e55 * 2048u) + ((((_e44 / 32u) * 512u) + (_e314.member_1 * 32u)) + (_e44 % 32u)));
            let _e328 = params.member.member_17;
            if (_e326 < _e328) {
                let _e331 = keys.member[_e326];
                let _e333 = params.member.member_10;
                let _e340 = counts[(_e86 + ((_e331 >> bitcast<u32>((_e333 & 31u))) & 255u))];
                if (_e314.member_1 < 16u) {
                } else {
                    return;
                }
                let _e343 = local[_e314.member_1];
                let _e344 = (_e340 + _e343);
                keys_out.member[_e344] = _e331;
                let _e347 = values.member[_e326];
                values_out.member[_e344] = _e347;
            }
        }
        continue;
        continuing {
            phi_420_ = _e312;
            break if !(_e318);
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

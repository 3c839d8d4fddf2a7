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
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
}

struct type_17 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_18 {
    member: type_7,
    member_1: type_8,
    member_2: type_17,
}

struct type_19 {
    member: type_18,
}

struct type_20 {
    member: vec4<u32>,
    member_1: vec4<u32>,
}

struct type_22 {
    member: array<type_20>,
}

@group(0) @binding(0) 
var<storage> params: type_19;
@group(0) @binding(1) 
var<storage> neighbours: type_11;
var<workgroup> masks: array<atomic<u32>, 8>;
@group(0) @binding(6) 
var<storage, read_write> counts: type_11;
@group(0) @binding(2) 
var<storage> clusters: type_22;
@group(0) @binding(3) 
var<storage> names: type_11;
@group(0) @binding(4) 
var<storage, read_write> clusters_out: type_22;
@group(0) @binding(5) 
var<storage, read_write> names_out: type_11;
@group(0) @binding(7) 
var<storage, read_write> joins: type_11;
var<workgroup> sums: array<atomic<u32>, 2>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_114_: u32;
    var phi_152_: u32;
    var phi_168_: u32;
    var phi_177_: bool;
    var phi_193_: u32;
    var phi_209_: u32;
    var phi_225_: u32;
    var phi_241_: u32;
    var phi_244_: type_9;
    var phi_247_: u32;
    var phi_249_: u32;
    var phi_245_: type_9;
    var phi_272_: type_9;
    var phi_297_: u32;
    var phi_303_: u32;
    var phi_310_: u32;
    var phi_248_: u32;
    var phi_250_: u32;
    var local: u32;
    var local_1: u32;
    var local_2: u32;
    var phi_322_: u32;
    var phi_355_: u32;
    var phi_356_: u32;
    var phi_357_: u32;
    var phi_358_: bool;
    var phi_362_: u32;
    var phi_368_: bool;
    var phi_396_: type_9;
    var phi_399_: u32;
    var phi_397_: type_9;
    var phi_422_: type_9;
    var phi_400_: u32;
    var phi_552_: f32;
    var phi_557_: f32;
    var phi_562_: f32;
    var phi_568_: f32;
    var phi_573_: f32;
    var phi_578_: f32;
    var phi_582_: type_16;
    var local_3: u32;
    var local_4: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e28 = id_2;
    let _e29 = n_2;
    let _e30 = lane_2;
    let _e43 = ((_e28.y * _e29.x) + _e28.x);
    let _e46 = params.member.member_1.member_1;
    let _e48 = counts.member[_e46];
    if (_e48 > 256u) {
        phi_114_ = _e48;
    } else {
        phi_114_ = 0u;
    }
    let _e51 = phi_114_;
    let _e54 = params.member.member_2.member;
    let _e58 = params.member.member.member[_e54];
    let _e60 = ((_e43 * 256u) + _e30);
    if (_e30 < 2u) {
        atomicStore((&sums[_e30]), 0u);
    }
    if (_e30 < 8u) {
        atomicStore((&masks[_e30]), 0u);
    }
    workgroupBarrier();
    let _e65 = (_e51 / 256u);
    if ((_e51 % 256u) > 0u) {
        phi_152_ = (_e65 + 1u);
    } else {
        phi_152_ = _e65;
    }
    let _e70 = phi_152_;
    let _e71 = (_e70 / 256u);
    if ((_e70 % 256u) > 0u) {
        phi_168_ = (_e71 + 1u);
    } else {
        phi_168_ = _e71;
    }
    let _e76 = phi_168_;
    let _e79 = (((_e43 / 256u) * 256u) + _e30);
    if (_e79 < _e43) {
        phi_177_ = (_e79 < _e70);
    } else {
        phi_177_ = false;
    }
    let _e83 = phi_177_;
    let _e84 = (_e58 / 256u);
    if ((_e58 % 256u) > 0u) {
        phi_193_ = (_e84 + 1u);
    } else {
        phi_193_ = _e84;
    }
    let _e89 = phi_193_;
    let _e90 = (_e89 / 256u);
    if ((_e89 % 256u) > 0u) {
        phi_209_ = (_e90 + 1u);
    } else {
        phi_209_ = _e90;
    }
    let _e95 = phi_209_;
    if _e83 {
        let _e99 = counts.member[(192u + (_e95 + _e79))];
        phi_225_ = _e99;
    } else {
        phi_225_ = 0u;
    }
    let _e101 = phi_225_;
    let _e102 = (_e76 / 256u);
    if ((_e76 % 256u) > 0u) {
        phi_241_ = (_e102 + 1u);
    } else {
        phi_241_ = _e102;
    }
    let _e107 = phi_241_;
    phi_244_ = type_9(0u, _e107);
    phi_247_ = 0u;
    phi_249_ = 0u;
    loop {
        let _e110 = phi_244_;
        let _e112 = phi_247_;
        let _e114 = phi_249_;
        local = _e114;
        local_1 = _e114;
        local_2 = _e112;
        if (_e110.member < _e110.member_1) {
            phi_245_ = type_9((_e110.member + 1u), _e110.member_1);
            phi_272_ = type_9(1u, _e110.member);
        } else {
            phi_245_ = _e110;
            phi_272_ = type_9(0u, type_9().member_1);
        }
        let _e126 = phi_245_;
        let _e128 = phi_272_;
        let _e132 = (bitcast<i32>(_e128.member) != 0i);
        if _e132 {
            let _e134 = ((_e128.member_1 * 256u) + _e30);
            if (_e134 < _e76) {
                let _e138 = counts.member[(192u + _e134)];
                phi_297_ = _e138;
            } else {
                phi_297_ = 0u;
            }
            let _e140 = phi_297_;
            if (_e134 < (_e43 / 256u)) {
                phi_303_ = _e140;
            } else {
                phi_303_ = 0u;
            }
            let _e144 = phi_303_;
            if (_e134 < (_e43 / 256u)) {
                phi_310_ = 0u;
            } else {
                phi_310_ = _e140;
            }
            let _e149 = phi_310_;
            phi_248_ = (_e112 + _e149);
            phi_250_ = (_e114 + _e144);
        } else {
            phi_248_ = u32();
            phi_250_ = u32();
        }
        let _e152 = phi_248_;
        let _e154 = phi_250_;
        continue;
        continuing {
            phi_244_ = _e126;
            phi_247_ = _e152;
            phi_249_ = _e154;
            break if !(_e132);
        }
    }
    let _e157 = local;
    let _e160 = atomicAdd((&sums[0u]), (_e157 + _e101));
    let _e162 = local_1;
    let _e164 = local_2;
    let _e167 = atomicAdd((&sums[1u]), (_e162 + _e164));
    let _e168 = (_e60 < _e51);
    if _e168 {
        phi_322_ = _e60;
    } else {
        phi_322_ = 0u;
    }
    let _e170 = phi_322_;
    let _e172 = neighbours.member[_e170];
    let _e174 = neighbours.member[_e172];
    if (_e170 == _e172) {
        phi_357_ = u32();
        phi_358_ = true;
    } else {
        let _e176 = (_e174 != _e170);
        if _e176 {
            phi_356_ = u32();
        } else {
            if (_e170 < _e172) {
                phi_355_ = 1u;
            } else {
                phi_355_ = 2u;
            }
            let _e179 = phi_355_;
            phi_356_ = _e179;
        }
        let _e181 = phi_356_;
        phi_357_ = _e181;
        phi_358_ = _e176;
    }
    let _e183 = phi_357_;
    let _e185 = phi_358_;
    if _e185 {
        phi_362_ = 0u;
    } else {
        phi_362_ = _e183;
    }
    let _e187 = phi_362_;
    if _e168 {
        phi_368_ = !((_e187 == 2u));
    } else {
        phi_368_ = false;
    }
    let _e191 = phi_368_;
    if _e191 {
        let _e198 = atomicOr((&masks[(_e30 / 32u)]), (1u << bitcast<u32>(((_e30 % 32u) & 31u))));
    }
    workgroupBarrier();
    if _e191 {
        let _e200 = atomicLoad((&sums[0u]));
        let _e203 = atomicLoad((&masks[(_e30 / 32u)]));
        phi_396_ = type_9(0u, (_e30 / 32u));
        phi_399_ = (_e200 + countOneBits((_e203 & ((1u << bitcast<u32>(((_e30 % 32u) & 31u))) - 1u))));
        loop {
            let _e215 = phi_396_;
            let _e217 = phi_399_;
            local_3 = _e217;
            local_4 = _e217;
            if (_e215.member < _e215.member_1) {
                phi_397_ = type_9((_e215.member + 1u), _e215.member_1);
                phi_422_ = type_9(1u, _e215.member);
            } else {
                phi_397_ = _e215;
                phi_422_ = type_9(0u, type_9().member_1);
            }
            let _e229 = phi_397_;
            let _e231 = phi_422_;
            let _e235 = (bitcast<i32>(_e231.member) != 0i);
            if _e235 {
                let _e237 = atomicLoad((&masks[_e231.member_1]));
                phi_400_ = (_e217 + countOneBits(_e237));
            } else {
                phi_400_ = u32();
            }
            let _e241 = phi_400_;
            continue;
            continuing {
                phi_396_ = _e229;
                phi_399_ = _e241;
                break if !(_e235);
            }
        }
        let _e244 = clusters.member[_e60];
        let _e247 = bitcast<f32>(_e244.member.x);
        let _e249 = bitcast<f32>(_e244.member.y);
        let _e251 = bitcast<f32>(_e244.member.z);
        let _e257 = bitcast<f32>(_e244.member_1.x);
        let _e259 = bitcast<f32>(_e244.member_1.y);
        let _e261 = bitcast<f32>(_e244.member_1.z);
        if (_e187 == 1u) {
            let _e268 = clusters.member[_e172];
            let _e271 = bitcast<f32>(_e268.member.x);
            let _e273 = bitcast<f32>(_e268.member.y);
            let _e275 = bitcast<f32>(_e268.member.z);
            let _e280 = bitcast<f32>(_e268.member_1.x);
            let _e282 = bitcast<f32>(_e268.member_1.y);
            let _e284 = bitcast<f32>(_e268.member_1.z);
            let _e288 = names.member[_e172];
            let _e289 = (_e288 - 1u);
            let _e290 = (_e289 * 4u);
            let _e291 = (_e244.member.w * 4u);
            let _e292 = (_e268.member.w * 4u);
            joins.member[_e291] = _e289;
            joins.member[(_e291 + 1u)] = 0u;
            joins.member[_e292] = _e289;
            joins.member[(_e292 + 1u)] = _e244.member_1.w;
            joins.member[(_e290 + 2u)] = _e244.member_1.w;
            joins.member[(_e290 + 3u)] = (_e244.member_1.w + _e268.member_1.w);
            if (_e247 < _e271) {
                phi_552_ = _e247;
            } else {
                phi_552_ = _e271;
            }
            let _e306 = phi_552_;
            if (_e249 < _e273) {
                phi_557_ = _e249;
            } else {
                phi_557_ = _e273;
            }
            let _e309 = phi_557_;
            if (_e251 < _e275) {
                phi_562_ = _e251;
            } else {
                phi_562_ = _e275;
            }
            let _e312 = phi_562_;
            if (_e257 > _e280) {
                phi_568_ = _e257;
            } else {
                phi_568_ = _e280;
            }
            let _e316 = phi_568_;
            if (_e259 > _e282) {
                phi_573_ = _e259;
            } else {
                phi_573_ = _e282;
            }
            let _e319 = phi_573_;
            if (_e261 > _e284) {
                phi_578_ = _e261;
            } else {
                phi_578_ = _e284;
            }
            let _e322 = phi_578_;
            phi_582_ = type_16(array<f32, 3>(_e306, _e309, _e312), _e289, array<f32, 3>(_e316, _e319, _e322), (_e244.member_1.w + _e268.member_1.w));
        } else {
            phi_582_ = type_16(array<f32, 3>(_e247, _e249, _e251), _e244.member.w, array<f32, 3>(_e257, _e259, _e261), _e244.member_1.w);
        }
        let _e327 = phi_582_;
        let _e348 = local_3;
        clusters_out.member[_e348] = type_20(vec4<u32>(bitcast<u32>(_e327.member[0]), bitcast<u32>(_e327.member[1]), bitcast<u32>(_e327.member[2]), _e327.member_1), vec4<u32>(bitcast<u32>(_e327.member_2[0]), bitcast<u32>(_e327.member_2[1]), bitcast<u32>(_e327.member_2[2]), _e327.member_3));
        let _e351 = names.member[_e60];
        let _e353 = local_4;
        names_out.member[_e353] = _e351;
    }
    if (_e60 == 0u) {
        if (_e51 > 0u) {
            let _e359 = params.member.member_1.member_1;
            let _e362 = atomicLoad((&sums[1u]));
            counts.member[(_e359 + 1u)] = _e362;
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn ploc_join(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}

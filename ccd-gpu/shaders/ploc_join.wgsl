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
    var phi_111_: u32;
    var phi_149_: u32;
    var phi_165_: u32;
    var phi_174_: bool;
    var phi_190_: u32;
    var phi_206_: u32;
    var phi_222_: u32;
    var phi_238_: u32;
    var phi_241_: type_9;
    var phi_244_: u32;
    var phi_246_: u32;
    var phi_242_: type_9;
    var phi_269_: type_9;
    var phi_294_: u32;
    var phi_300_: u32;
    var phi_307_: u32;
    var phi_245_: u32;
    var phi_247_: u32;
    var local: u32;
    var local_1: u32;
    var local_2: u32;
    var phi_319_: u32;
    var phi_352_: u32;
    var phi_353_: u32;
    var phi_354_: u32;
    var phi_355_: bool;
    var phi_359_: u32;
    var phi_365_: bool;
    var phi_393_: type_9;
    var phi_396_: u32;
    var phi_394_: type_9;
    var phi_419_: type_9;
    var phi_397_: u32;
    var phi_525_: f32;
    var phi_530_: f32;
    var phi_535_: f32;
    var phi_541_: f32;
    var phi_546_: f32;
    var phi_551_: f32;
    var phi_555_: type_16;
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
        phi_111_ = _e48;
    } else {
        phi_111_ = 0u;
    }
    let _e51 = phi_111_;
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
        phi_149_ = (_e65 + 1u);
    } else {
        phi_149_ = _e65;
    }
    let _e70 = phi_149_;
    let _e71 = (_e70 / 256u);
    if ((_e70 % 256u) > 0u) {
        phi_165_ = (_e71 + 1u);
    } else {
        phi_165_ = _e71;
    }
    let _e76 = phi_165_;
    let _e79 = (((_e43 / 256u) * 256u) + _e30);
    if (_e79 < _e43) {
        phi_174_ = (_e79 < _e70);
    } else {
        phi_174_ = false;
    }
    let _e83 = phi_174_;
    let _e84 = (_e58 / 256u);
    if ((_e58 % 256u) > 0u) {
        phi_190_ = (_e84 + 1u);
    } else {
        phi_190_ = _e84;
    }
    let _e89 = phi_190_;
    let _e90 = (_e89 / 256u);
    if ((_e89 % 256u) > 0u) {
        phi_206_ = (_e90 + 1u);
    } else {
        phi_206_ = _e90;
    }
    let _e95 = phi_206_;
    if _e83 {
        let _e99 = counts.member[(192u + (_e95 + _e79))];
        phi_222_ = _e99;
    } else {
        phi_222_ = 0u;
    }
    let _e101 = phi_222_;
    let _e102 = (_e76 / 256u);
    if ((_e76 % 256u) > 0u) {
        phi_238_ = (_e102 + 1u);
    } else {
        phi_238_ = _e102;
    }
    let _e107 = phi_238_;
    phi_241_ = type_9(0u, _e107);
    phi_244_ = 0u;
    phi_246_ = 0u;
    loop {
        let _e110 = phi_241_;
        let _e112 = phi_244_;
        let _e114 = phi_246_;
        local = _e114;
        local_1 = _e114;
        local_2 = _e112;
        if (_e110.member < _e110.member_1) {
            phi_242_ = type_9((_e110.member + 1u), _e110.member_1);
            phi_269_ = type_9(1u, _e110.member);
        } else {
            phi_242_ = _e110;
            phi_269_ = type_9(0u, type_9().member_1);
        }
        let _e126 = phi_242_;
        let _e128 = phi_269_;
        let _e132 = (bitcast<i32>(_e128.member) != 0i);
        if _e132 {
            let _e134 = ((_e128.member_1 * 256u) + _e30);
            if (_e134 < _e76) {
                let _e138 = counts.member[(192u + _e134)];
                phi_294_ = _e138;
            } else {
                phi_294_ = 0u;
            }
            let _e140 = phi_294_;
            if (_e134 < (_e43 / 256u)) {
                phi_300_ = _e140;
            } else {
                phi_300_ = 0u;
            }
            let _e144 = phi_300_;
            if (_e134 < (_e43 / 256u)) {
                phi_307_ = 0u;
            } else {
                phi_307_ = _e140;
            }
            let _e149 = phi_307_;
            phi_245_ = (_e112 + _e149);
            phi_247_ = (_e114 + _e144);
        } else {
            phi_245_ = u32();
            phi_247_ = u32();
        }
        let _e152 = phi_245_;
        let _e154 = phi_247_;
        continue;
        continuing {
            phi_241_ = _e126;
            phi_244_ = _e152;
            phi_246_ = _e154;
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
        phi_319_ = _e60;
    } else {
        phi_319_ = 0u;
    }
    let _e170 = phi_319_;
    let _e172 = neighbours.member[_e170];
    let _e174 = neighbours.member[_e172];
    if (_e170 == _e172) {
        phi_354_ = u32();
        phi_355_ = true;
    } else {
        let _e176 = (_e174 != _e170);
        if _e176 {
            phi_353_ = u32();
        } else {
            if (_e170 < _e172) {
                phi_352_ = 1u;
            } else {
                phi_352_ = 2u;
            }
            let _e179 = phi_352_;
            phi_353_ = _e179;
        }
        let _e181 = phi_353_;
        phi_354_ = _e181;
        phi_355_ = _e176;
    }
    let _e183 = phi_354_;
    let _e185 = phi_355_;
    if _e185 {
        phi_359_ = 0u;
    } else {
        phi_359_ = _e183;
    }
    let _e187 = phi_359_;
    if _e168 {
        phi_365_ = !((_e187 == 2u));
    } else {
        phi_365_ = false;
    }
    let _e191 = phi_365_;
    if _e191 {
        let _e198 = atomicOr((&masks[(_e30 / 32u)]), (1u << bitcast<u32>(((_e30 % 32u) & 31u))));
    }
    workgroupBarrier();
    if _e191 {
        let _e200 = atomicLoad((&sums[0u]));
        let _e203 = atomicLoad((&masks[(_e30 / 32u)]));
        phi_393_ = type_9(0u, (_e30 / 32u));
        phi_396_ = (_e200 + countOneBits((_e203 & ((1u << bitcast<u32>(((_e30 % 32u) & 31u))) - 1u))));
        loop {
            let _e215 = phi_393_;
            let _e217 = phi_396_;
            local_3 = _e217;
            local_4 = _e217;
            if (_e215.member < _e215.member_1) {
                phi_394_ = type_9((_e215.member + 1u), _e215.member_1);
                phi_419_ = type_9(1u, _e215.member);
            } else {
                phi_394_ = _e215;
                phi_419_ = type_9(0u, type_9().member_1);
            }
            let _e229 = phi_394_;
            let _e231 = phi_419_;
            let _e235 = (bitcast<i32>(_e231.member) != 0i);
            if _e235 {
                let _e237 = atomicLoad((&masks[_e231.member_1]));
                phi_397_ = (_e217 + countOneBits(_e237));
            } else {
                phi_397_ = u32();
            }
            let _e241 = phi_397_;
            continue;
            continuing {
                phi_393_ = _e229;
                phi_396_ = _e241;
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
                phi_525_ = _e247;
            } else {
                phi_525_ = _e271;
            }
            let _e306 = phi_525_;
            if (_e249 < _e273) {
                phi_530_ = _e249;
            } else {
                phi_530_ = _e273;
            }
            let _e309 = phi_530_;
            if (_e251 < _e275) {
                phi_535_ = _e251;
            } else {
                phi_535_ = _e275;
            }
            let _e312 = phi_535_;
            if (_e257 > _e280) {
                phi_541_ = _e257;
            } else {
                phi_541_ = _e280;
            }
            let _e316 = phi_541_;
            if (_e259 > _e282) {
                phi_546_ = _e259;
            } else {
                phi_546_ = _e282;
            }
            let _e319 = phi_546_;
            if (_e261 > _e284) {
                phi_551_ = _e261;
            } else {
                phi_551_ = _e284;
            }
            let _e322 = phi_551_;
            phi_555_ = type_16(array<f32, 3>(_e306, _e309, _e312), _e289, array<f32, 3>(_e316, _e319, _e322), (_e244.member_1.w + _e268.member_1.w));
        } else {
            phi_555_ = type_16(array<f32, 3>(_e247, _e249, _e251), _e244.member.w, array<f32, 3>(_e257, _e259, _e261), _e244.member_1.w);
        }
        let _e327 = phi_555_;
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

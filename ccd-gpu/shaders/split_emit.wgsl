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

struct type_14 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_15 {
    member: type_7,
    member_1: type_8,
    member_2: type_14,
}

struct type_16 {
    member: type_15,
}

@group(0) @binding(0) 
var<storage> params: type_16;
@group(0) @binding(1) 
var<storage> levels: type_11;
@group(0) @binding(2) 
var<storage> present: type_11;
@group(0) @binding(3) 
var<storage> table: type_11;
@group(0) @binding(4) 
var<storage, read_write> entries: type_11;
@group(0) @binding(5) 
var<storage, read_write> list: type_11;
var<workgroup> masks: array<atomic<u32>, 768>;
var<workgroup> begins: array<u32, 256>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<u32, 3>;
    var local_1: array<u32, 3>;
    var phi_112_: u32;
    var phi_117_: type_9;
    var phi_118_: type_9;
    var phi_141_: type_9;
    var phi_156_: u32;
    var phi_159_: type_9;
    var phi_162_: u32;
    var phi_160_: type_9;
    var phi_185_: type_9;
    var phi_163_: u32;
    var local_2: u32;
    var phi_272_: u32;
    var phi_273_: u32;
    var phi_294_: u32;
    var phi_295_: u32;
    var phi_312_: type_9;
    var phi_315_: u32;
    var phi_313_: type_9;
    var phi_338_: type_9;
    var phi_360_: u32;
    var phi_361_: u32;
    var phi_316_: u32;
    var phi_378_: type_9;
    var phi_381_: u32;
    var phi_379_: type_9;
    var phi_404_: type_9;
    var phi_426_: u32;
    var phi_427_: u32;
    var phi_382_: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_439_: array<u32, 2>;
    var phi_445_: type_9;
    var phi_446_: type_9;
    var phi_469_: type_9;
    var phi_488_: type_9;
    var phi_489_: type_9;
    var phi_512_: type_9;
    var phi_538_: type_9;
    var phi_541_: u32;
    var phi_539_: type_9;
    var phi_564_: type_9;
    var phi_542_: u32;
    var local_5: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e28 = id_2;
    let _e29 = n_2;
    let _e30 = lane_2;
    let _e41 = ((_e28.y * _e29.x) + _e28.x);
    let _e44 = params.member.member_2.member;
    let _e48 = params.member.member.member[_e44];
    let _e49 = (_e48 - 1u);
    let _e50 = (_e49 / 256u);
    if ((_e49 % 256u) > 0u) {
        phi_112_ = (_e50 + 1u);
    } else {
        phi_112_ = _e50;
    }
    let _e55 = phi_112_;
    let _e57 = ((_e41 * 256u) + _e30);
    phi_117_ = type_9(0u, 3u);
    loop {
        let _e59 = phi_117_;
        if (_e59.member < _e59.member_1) {
            phi_118_ = type_9((_e59.member + 1u), _e59.member_1);
            phi_141_ = type_9(1u, _e59.member);
        } else {
            phi_118_ = _e59;
            phi_141_ = type_9(0u, type_9().member_1);
        }
        let _e71 = phi_118_;
        let _e73 = phi_141_;
        let _e77 = (bitcast<i32>(_e73.member) != 0i);
        if _e77 {
            atomicStore((&masks[((_e73.member_1 * 256u) + _e30)]), 0u);
        }
        continue;
        continuing {
            phi_117_ = _e71;
            break if !(_e77);
        }
    }
    if (96u < _e30) {
        phi_156_ = 96u;
    } else {
        phi_156_ = _e30;
    }
    let _e84 = phi_156_;
    phi_159_ = type_9(0u, _e84);
    phi_162_ = 0u;
    loop {
        let _e87 = phi_159_;
        let _e89 = phi_162_;
        local_2 = _e89;
        if (_e87.member < _e87.member_1) {
            phi_160_ = type_9((_e87.member + 1u), _e87.member_1);
            phi_185_ = type_9(1u, _e87.member);
        } else {
            phi_160_ = _e87;
            phi_185_ = type_9(0u, type_9().member_1);
        }
        let _e101 = phi_160_;
        let _e103 = phi_185_;
        let _e107 = (bitcast<i32>(_e103.member) != 0i);
        if _e107 {
            let _e111 = table.member[((256u * _e55) + _e103.member_1)];
            phi_163_ = (_e89 + _e111);
        } else {
            phi_163_ = u32();
        }
        let _e114 = phi_163_;
        continue;
        continuing {
            phi_159_ = _e101;
            phi_162_ = _e114;
            break if !(_e107);
        }
    }
    let _e118 = local_2;
    begins[_e30] = _e118;
    workgroupBarrier();
    if (_e57 < _e49) {
        let _e121 = present.member[0u];
        let _e123 = present.member[1u];
        let _e125 = present.member[2u];
        let _e127 = levels.member[_e57];
        if (_e57 > 0u) {
            let _e131 = levels.member[(_e57 - 1u)];
            if (_e131 < _e127) {
                phi_272_ = _e127;
            } else {
                phi_272_ = _e131;
            }
            let _e134 = phi_272_;
            phi_273_ = _e134;
        } else {
            phi_273_ = _e127;
        }
        let _e136 = phi_273_;
        if ((_e57 + 1u) < _e49) {
            let _e141 = levels.member[(_e57 + 1u)];
            if (_e141 < _e136) {
                phi_294_ = _e136;
            } else {
                phi_294_ = _e141;
            }
            let _e144 = phi_294_;
            phi_295_ = _e144;
        } else {
            phi_295_ = _e136;
        }
        let _e146 = phi_295_;
        let _e148 = levels.member[_e57];
        local_1 = array<u32, 3>(_e121, _e123, _e125);
        phi_312_ = type_9(0u, 3u);
        phi_315_ = 0u;
        loop {
            let _e151 = phi_312_;
            let _e153 = phi_315_;
            local_3 = _e153;
            if (_e151.member < _e151.member_1) {
                phi_313_ = type_9((_e151.member + 1u), _e151.member_1);
                phi_338_ = type_9(1u, _e151.member);
            } else {
                phi_313_ = _e151;
                phi_338_ = type_9(0u, type_9().member_1);
            }
            let _e165 = phi_313_;
            let _e167 = phi_338_;
            let _e171 = (bitcast<i32>(_e167.member) != 0i);
            if _e171 {
                let _e172 = (32u * _e167.member_1);
                if (_e148 >= (_e172 + 32u)) {
                    phi_361_ = 4294967295u;
                } else {
                    if (_e148 > _e172) {
                        phi_360_ = ((1u << bitcast<u32>(((_e148 - _e172) & 31u))) - 1u);
                    } else {
                        phi_360_ = 0u;
                    }
                    let _e182 = phi_360_;
                    phi_361_ = _e182;
                }
                let _e184 = phi_361_;
                let _e186 = local_1[_e167.member_1];
                phi_316_ = (_e153 + countOneBits((_e186 & _e184)));
            } else {
                phi_316_ = u32();
            }
            let _e191 = phi_316_;
            continue;
            continuing {
                phi_312_ = _e165;
                phi_315_ = _e191;
                break if !(_e171);
            }
        }
        local = array<u32, 3>(_e121, _e123, _e125);
        phi_378_ = type_9(0u, 3u);
        phi_381_ = 0u;
        loop {
            let _e195 = phi_378_;
            let _e197 = phi_381_;
            local_4 = _e197;
            if (_e195.member < _e195.member_1) {
                phi_379_ = type_9((_e195.member + 1u), _e195.member_1);
                phi_404_ = type_9(1u, _e195.member);
            } else {
                phi_379_ = _e195;
                phi_404_ = type_9(0u, type_9().member_1);
            }
            let _e209 = phi_379_;
            let _e211 = phi_404_;
            let _e215 = (bitcast<i32>(_e211.member) != 0i);
            if _e215 {
                let _e216 = (32u * _e211.member_1);
                if (_e146 >= (_e216 + 32u)) {
                    phi_427_ = 4294967295u;
                } else {
                    if (_e146 > _e216) {
                        phi_426_ = ((1u << bitcast<u32>(((_e146 - _e216) & 31u))) - 1u);
                    } else {
                        phi_426_ = 0u;
                    }
                    let _e226 = phi_426_;
                    phi_427_ = _e226;
                }
                let _e228 = phi_427_;
                let _e230 = local[_e211.member_1];
                phi_382_ = (_e197 + countOneBits((_e230 & _e228)));
            } else {
                phi_382_ = u32();
            }
            let _e235 = phi_382_;
            continue;
            continuing {
                phi_378_ = _e209;
                phi_381_ = _e235;
                break if !(_e215);
            }
        }
        let _e238 = local_3;
        let _e240 = local_4;
        phi_439_ = array<u32, 2>(_e238, _e240);
    } else {
        phi_439_ = array<u32, 2>(1u, 0u);
    }
    let _e243 = phi_439_;
    phi_445_ = type_9(_e243[0], (_e243[1] + 1u));
    loop {
        let _e249 = phi_445_;
        if (_e249.member < _e249.member_1) {
            phi_446_ = type_9((_e249.member + 1u), _e249.member_1);
            phi_469_ = type_9(1u, _e249.member);
        } else {
            phi_446_ = _e249;
            phi_469_ = type_9(0u, type_9().member_1);
        }
        let _e261 = phi_446_;
        let _e263 = phi_469_;
        let _e267 = (bitcast<i32>(_e263.member) != 0i);
        if _e267 {
            let _e276 = atomicOr((&masks[((_e263.member_1 * 8u) + (_e30 / 32u))]), (1u << bitcast<u32>(((_e30 % 32u) & 31u))));
        }
        continue;
        continuing {
            phi_445_ = _e261;
            break if !(_e267);
        }
    }
    workgroupBarrier();
    phi_488_ = type_9(_e243[0], (_e243[1] + 1u));
    loop {
        let _e281 = phi_488_;
        if (_e281.member < _e281.member_1) {
            phi_489_ = type_9((_e281.member + 1u), _e281.member_1);
            phi_512_ = type_9(1u, _e281.member);
        } else {
            phi_489_ = _e281;
            phi_512_ = type_9(0u, type_9().member_1);
        }
        let _e293 = phi_489_;
        let _e295 = phi_512_;
        let _e299 = (bitcast<i32>(_e295.member) != 0i);
        if _e299 {
            let _e301 = begins[_e295.member_1];
            let _e305 = table.member[((_e295.member_1 * _e55) + _e41)];
            phi_538_ = type_9(0u, (_e30 / 32u));
            phi_541_ = (_e301 + _e305);
            loop {
                let _e310 = phi_538_;
                let _e312 = phi_541_;
                local_5 = _e312;
                if (_e310.member < _e310.member_1) {
                    phi_539_ = type_9((_e310.member + 1u), _e310.member_1);
                    phi_564_ = type_9(1u, _e310.member);
                } else {
                    phi_539_ = _e310;
                    phi_564_ = type_9(0u, type_9().member_1);
                }
                let _e324 = phi_539_;
                let _e326 = phi_564_;
                let _e330 = (bitcast<i32>(_e326.member) != 0i);
                if _e330 {
                    let _e334 = atomicLoad((&masks[((_e295.member_1 * 8u) + _e326.member_1)]));
                    phi_542_ = (_e312 + countOneBits(_e334));
                } else {
                    phi_542_ = u32();
                }
                let _e338 = phi_542_;
                continue;
                continuing {
                    phi_538_ = _e324;
                    phi_541_ = _e338;
                    break if !(_e330);
                }
            }
            let _e344 = atomicLoad((&masks[((_e295.member_1 * 8u) + (_e30 / 32u))]));
            let _e353 = local_5;
            let _e354 = (_e353 + countOneBits((_e344 & ((1u << bitcast<u32>(((_e30 % 32u) & 31u))) - 1u))));
            let _e357 = params.member.member_1.member_3;
            if (_e354 < _e357) {
                list.member[(4u + _e354)] = _e57;
            }
            if (_e295.member_1 == _e243[0]) {
                entries.member[_e57] = _e354;
            }
        }
        continue;
        continuing {
            phi_488_ = _e293;
            break if !(_e299);
        }
    }
    if (_e57 == 0u) {
        let _e366 = begins[96u];
        list.member[0u] = _e366;
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn split_emit(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}

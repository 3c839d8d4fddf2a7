// Generated from ccd-shaders by `cargo xtask shaders`: not to be edited.
struct type_3 {
    member: u32,
    member_1: u32,
}

struct type_10 {
    member: array<array<u32, 4>>,
}

struct type_12 {
    member: array<array<u32, 28>>,
}

struct type_15 {
    member: i32,
    member_1: i32,
}

struct type_16 {
    member: u32,
    member_1: i32,
}

@group(0) @binding(0) 
var<storage> inputs: type_10;
@group(0) @binding(1) 
var<storage, read_write> results: type_12;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<u32, 28>;
    var local_1: array<array<u32, 2>, 14>;
    var phi_220_: type_15;
    var phi_223_: f64;
    var phi_221_: type_15;
    var phi_264_: type_16;
    var phi_224_: f64;
    var local_2: f64;
    var phi_277_: f64;
    var phi_401_: bool;
    var phi_402_: u32;
    var phi_403_: bool;
    var phi_404_: u32;
    var phi_405_: bool;
    var phi_406_: u32;
    var phi_407_: bool;
    var phi_408_: u32;
    var phi_498_: type_3;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e63 = id_2;
    let _e64 = n_2;
    let _e65 = lane_2;
    let _e76 = ((((_e63.y * _e64.x) + _e63.x) * 64u) + _e65);
    if (_e76 < arrayLength((&inputs.member))) {
        let _e79 = inputs.member[_e76];
        let _e86 = bitcast<f64>(((u64(_e79[1]) * 4294967296lu) + u64(_e79[0])));
        let _e93 = bitcast<f64>(((u64(_e79[3]) * 4294967296lu) + u64(_e79[2])));
        let _e95 = bitcast<u64>((_e86 + _e93));
        let _e100 = bitcast<u64>((_e86 - _e93));
        let _e105 = bitcast<u64>((_e86 * _e93));
        let _e110 = bitcast<u64>((_e86 / _e93));
        let _e117 = bitcast<u64>(select(_e86, -(_e86), (_e86 < 0.0lf)));
        let _e123 = bitcast<u64>(select(_e93, _e86, (_e86 < _e93)));
        let _e129 = bitcast<u64>(select(_e93, _e86, (_e86 > _e93)));
        if (_e86 <= 2.2250738585072014e-308lf) {
            phi_277_ = select(0.0lf, (1.464336215552873e-154lf * 2.0lf), (_e86 > 0.0lf));
        } else {
            phi_220_ = type_15(0i, 5i);
            phi_223_ = bitcast<f64>(((bitcast<u64>(_e86) / 2lu) + 2303426169912950784lu));
            loop {
                let _e143 = phi_220_;
                let _e145 = phi_223_;
                local_2 = _e145;
                if (_e143.member < _e143.member_1) {
                    let _e152 = (_e143.member + 1i);
                    phi_221_ = type_15(select(_e152, type_16().member_1, select(false, true, ((false == (_e152 > _e143.member)) != false))), _e143.member_1);
                    phi_264_ = type_16(1u, _e143.member);
                } else {
                    phi_221_ = _e143;
                    phi_264_ = type_16(0u, type_16().member_1);
                }
                let _e163 = phi_221_;
                let _e165 = phi_264_;
                let _e168 = (bitcast<i32>(_e165.member) != 0i);
                if _e168 {
                    phi_224_ = (0.5lf * (_e145 + (_e86 / _e145)));
                } else {
                    phi_224_ = f64();
                }
                let _e173 = phi_224_;
                continue;
                continuing {
                    phi_220_ = _e163;
                    phi_223_ = _e173;
                    break if !(_e168);
                }
            }
            let _e178 = local_2;
            phi_277_ = (_e178 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
        }
        let _e184 = phi_277_;
        let _e185 = bitcast<u64>(_e184);
        let _e189 = bitcast<u64>(_e86);
        let _e203 = bitcast<u64>(select(_e86, select(select(5e-324lf, bitcast<f64>((_e189 - 1lu)), (_e86 < 0.0lf)), bitcast<f64>((_e189 + 1lu)), (_e86 > 0.0lf)), select(true, (_e86 < 0.0lf), ((_e189 & 9218868437227405312lu) == 9218868437227405312lu))));
        let _e207 = -(_e86);
        let _e208 = bitcast<u64>(_e207);
        let _e223 = bitcast<u64>(-(select(_e207, select(select(5e-324lf, bitcast<f64>((_e208 - 1lu)), (_e207 < 0.0lf)), bitcast<f64>((_e208 + 1lu)), (_e207 > 0.0lf)), select(true, (_e207 < 0.0lf), ((_e208 & 9218868437227405312lu) == 9218868437227405312lu)))));
        let _e227 = bitcast<u64>(_e86);
        let _e228 = u32(_e227);
        let _e230 = u32((_e227 / 4294967296lu));
        let _e231 = (_e230 & 2147483648u);
        let _e234 = ((_e230 >> bitcast<u32>(20i)) & 2047u);
        let _e240 = (((_e230 & 1048575u) << bitcast<u32>(3i)) | (_e228 >> bitcast<u32>(29i)));
        let _e241 = (_e228 & 536870911u);
        if (_e234 == 2047u) {
            phi_407_ = false;
            phi_408_ = (2139095040u | _e240);
        } else {
            if (_e234 > 1150u) {
                phi_405_ = true;
                phi_406_ = 2139095039u;
            } else {
                if (_e234 > 896u) {
                    phi_403_ = (_e241 != 0u);
                    phi_404_ = (((_e234 - 896u) << bitcast<u32>(23i)) | _e240);
                } else {
                    if (_e234 >= 873u) {
                        let _e249 = (8388608u | _e240);
                        let _e250 = (897u - _e234);
                        phi_401_ = (((_e249 & ((1u << bitcast<u32>((_e250 & 31u))) - 1u)) | _e241) != 0u);
                        phi_402_ = (_e249 >> bitcast<u32>((_e250 & 31u)));
                    } else {
                        phi_401_ = (((_e230 & 2147483647u) | _e228) != 0u);
                        phi_402_ = 0u;
                    }
                    let _e262 = phi_401_;
                    let _e264 = phi_402_;
                    phi_403_ = _e262;
                    phi_404_ = _e264;
                }
                let _e271 = phi_403_;
                let _e273 = phi_404_;
                phi_405_ = _e271;
                phi_406_ = _e273;
            }
            let _e275 = phi_405_;
            let _e277 = phi_406_;
            phi_407_ = _e275;
            phi_408_ = _e277;
        }
        let _e280 = phi_407_;
        let _e282 = phi_408_;
        let _e299 = bitcast<u64>(f64(bitcast<f32>(_e79[0])));
        local_1[0u] = array<u32, 2>(u32(_e95), u32((_e95 / 4294967296lu)));
        local_1[1u] = array<u32, 2>(u32(_e100), u32((_e100 / 4294967296lu)));
        local_1[2u] = array<u32, 2>(u32(_e105), u32((_e105 / 4294967296lu)));
        local_1[3u] = array<u32, 2>(u32(_e110), u32((_e110 / 4294967296lu)));
        local_1[4u] = array<u32, 2>(u32(_e117), u32((_e117 / 4294967296lu)));
        local_1[5u] = array<u32, 2>(u32(_e123), u32((_e123 / 4294967296lu)));
        local_1[6u] = array<u32, 2>(u32(_e129), u32((_e129 / 4294967296lu)));
        local_1[7u] = array<u32, 2>(select(0u, 1u, (_e86 < _e93)), select(0u, 1u, (_e86 <= _e93)));
        local_1[8u] = array<u32, 2>(u32(_e185), u32((_e185 / 4294967296lu)));
        local_1[9u] = array<u32, 2>(u32(_e203), u32((_e203 / 4294967296lu)));
        local_1[10u] = array<u32, 2>(u32(_e223), u32((_e223 / 4294967296lu)));
        local_1[11u] = array<u32, 2>(bitcast<u32>(select(bitcast<f32>(((_e231 | _e282) + select(0u, 1u, _e280))), bitcast<f32>((_e231 | _e282)), (_e231 == 0u))), select(0u, 1u, ((bitcast<u64>(_e86) & 9218868437227405312lu) != 9218868437227405312lu)));
        local_1[12u] = array<u32, 2>(u32(_e299), u32((_e299 / 4294967296lu)));
        local_1[13u] = array<u32, 2>(bitcast<u32>(f32(_e86)), 0u);
        local = array<u32, 28>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
        phi_498_ = type_3(0u, 14u);
        loop {
            let _e334 = phi_498_;
            let _e337 = (_e334.member < _e334.member_1);
            let _e348 = select(type_3().member_1, _e334.member, _e337);
            let _e350 = (bitcast<i32>(select(0u, 1u, _e337)) != 0i);
            if _e350 {
                let _e353 = local_1[_e348][0u];
                local[(2u * _e348)] = _e353;
                let _e358 = local_1[_e348][1u];
                local[((2u * _e348) + 1u)] = _e358;
            }
            continue;
            continuing {
                phi_498_ = type_3(select(_e334.member, (_e334.member + 1u), _e337), select(_e334.member_1, _e334.member_1, _e337));
                break if !(_e350);
            }
        }
        let _e363 = local;
        results.member[_e76] = array<u32, 28>(_e363[0], _e363[1], _e363[2], _e363[3], _e363[4], _e363[5], _e363[6], _e363[7], _e363[8], _e363[9], _e363[10], _e363[11], _e363[12], _e363[13], _e363[14], _e363[15], _e363[16], _e363[17], _e363[18], _e363[19], _e363[20], _e363[21], _e363[22], _e363[23], _e363[24], _e363[25], _e363[26], _e363[27]);
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn probe_wide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}

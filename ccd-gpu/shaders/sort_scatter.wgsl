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

struct type_20 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_11;
@group(0) @binding(1) 
var<storage> keys: type_13;
var<workgroup> counts: array<atomic<u32>, 1024>;
@group(0) @binding(2) 
var<storage> values: type_13;
@group(0) @binding(3) 
var<storage, read_write> table: type_20;
@group(0) @binding(4) 
var<storage, read_write> keys_out: type_13;
@group(0) @binding(5) 
var<storage, read_write> values_out: type_13;
var<workgroup> words: array<atomic<u32>, 2560>;
var<workgroup> lowest: array<atomic<u32>, 1>;
var<workgroup> digits: array<atomic<u32>, 256>;
var<workgroup> missing: array<u32, 1>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_160_: u32;
    var phi_182_: u32;
    var phi_204_: u32;
    var phi_226_: u32;
    var phi_248_: u32;
    var phi_270_: u32;
    var phi_292_: u32;
    var phi_314_: u32;
    var phi_336_: u32;
    var phi_358_: u32;
    var phi_376_: u32;
    var phi_379_: type_9;
    var phi_416_: type_9;
    var phi_977_: type_9;
    var phi_980_: u32;
    var phi_981_: u32;
    var phi_1019_: type_9;
    var local: u32;
    var phi_1086_: type_9;
    var phi_1089_: u32;
    var phi_1091_: u32;
    var phi_1093_: u32;
    var phi_1090_: u32;
    var phi_1132_: u32;
    var phi_1092_: u32;
    var phi_1094_: u32;
    var phi_1139_: type_9;
    var phi_1142_: u32;
    var phi_1144_: u32;
    var phi_1146_: u32;
    var phi_1143_: u32;
    var phi_1185_: u32;
    var phi_1145_: u32;
    var phi_1147_: u32;
    var local_1: u32;
    var phi_1740_: u32;
    var phi_1743_: u32;
    var phi_1748_: u32;
    var phi_1751_: u32;
    var phi_1753_: u32;
    var phi_1946_: u32;
    var phi_1947_: u32;
    var phi_1948_: u32;
    var phi_1749_: u32;
    var phi_1752_: u32;
    var phi_1754_: u32;
    var phi_1949_: bool;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_2008_: type_9;
    var local_6: u32;
    var phi_2067_: u32;
    var phi_2068_: u32;
    var phi_1741_: u32;
    var phi_1744_: u32;
    var phi_2069_: bool;
    var phi_2096_: array<u32, 3>;
    var phi_2123_: array<u32, 3>;
    var phi_2150_: array<u32, 3>;
    var phi_2177_: array<u32, 3>;
    var phi_2204_: array<u32, 3>;
    var phi_2231_: array<u32, 3>;
    var phi_2258_: array<u32, 3>;
    var phi_2285_: array<u32, 3>;
    var phi_2312_: array<u32, 3>;
    var phi_2339_: array<u32, 3>;
    var local_7: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e61 = id_2;
    let _e62 = n_2;
    let _e63 = lane_2;
    let _e77 = params.member.member_2.member;
    let _e80 = params.member.member_1.member;
    let _e83 = params.member.member_2.member_1;
    let _e86 = params.member.member_1.member_1;
    let _e87 = (_e86 + ((_e61.y * _e62.x) + _e61.x));
    let _e88 = (_e87 * 2560u);
    let _e93 = (_e88 + (((_e63 / 32u) * 320u) + (_e63 % 32u)));
    if (_e93 < _e80) {
        let _e96 = keys.member[_e93];
        phi_160_ = _e96;
    } else {
        phi_160_ = 4294967295u;
    }
    let _e98 = phi_160_;
    let _e104 = (_e88 + ((((_e63 / 32u) * 320u) + 32u) + (_e63 % 32u)));
    if (_e104 < _e80) {
        let _e107 = keys.member[_e104];
        phi_182_ = _e107;
    } else {
        phi_182_ = 4294967295u;
    }
    let _e109 = phi_182_;
    let _e115 = (_e88 + ((((_e63 / 32u) * 320u) + 64u) + (_e63 % 32u)));
    if (_e115 < _e80) {
        let _e118 = keys.member[_e115];
        phi_204_ = _e118;
    } else {
        phi_204_ = 4294967295u;
    }
    let _e120 = phi_204_;
    let _e126 = (_e88 + ((((_e63 / 32u) * 320u) + 96u) + (_e63 % 32u)));
    if (_e126 < _e80) {
        let _e129 = keys.member[_e126];
        phi_226_ = _e129;
    } else {
        phi_226_ = 4294967295u;
    }
    let _e131 = phi_226_;
    let _e137 = (_e88 + ((((_e63 / 32u) * 320u) + 128u) + (_e63 % 32u)));
    if (_e137 < _e80) {
        let _e140 = keys.member[_e137];
        phi_248_ = _e140;
    } else {
        phi_248_ = 4294967295u;
    }
    let _e142 = phi_248_;
    let _e148 = (_e88 + ((((_e63 / 32u) * 320u) + 160u) + (_e63 % 32u)));
    if (_e148 < _e80) {
        let _e151 = keys.member[_e148];
        phi_270_ = _e151;
    } else {
        phi_270_ = 4294967295u;
    }
    let _e153 = phi_270_;
    let _e159 = (_e88 + ((((_e63 / 32u) * 320u) + 192u) + (_e63 % 32u)));
    if (_e159 < _e80) {
        let _e162 = keys.member[_e159];
        phi_292_ = _e162;
    } else {
        phi_292_ = 4294967295u;
    }
    let _e164 = phi_292_;
    let _e170 = (_e88 + ((((_e63 / 32u) * 320u) + 224u) + (_e63 % 32u)));
    if (_e170 < _e80) {
        let _e173 = keys.member[_e170];
        phi_314_ = _e173;
    } else {
        phi_314_ = 4294967295u;
    }
    let _e175 = phi_314_;
    let _e181 = (_e88 + ((((_e63 / 32u) * 320u) + 256u) + (_e63 % 32u)));
    if (_e181 < _e80) {
        let _e184 = keys.member[_e181];
        phi_336_ = _e184;
    } else {
        phi_336_ = 4294967295u;
    }
    let _e186 = phi_336_;
    let _e192 = (_e88 + ((((_e63 / 32u) * 320u) + 288u) + (_e63 % 32u)));
    if (_e192 < _e80) {
        let _e195 = keys.member[_e192];
        phi_358_ = _e195;
    } else {
        phi_358_ = 4294967295u;
    }
    let _e197 = phi_358_;
    if (_e63 < 256u) {
        let _e203 = atomicLoad((&table.member[(((_e77 / 8u) * 256u) + _e63)]));
        phi_376_ = _e203;
    } else {
        phi_376_ = 0u;
    }
    let _e205 = phi_376_;
    phi_379_ = type_9(0u, 4u);
    loop {
        let _e207 = phi_379_;
        let _e210 = (_e207.member < _e207.member_1);
        let _e223 = (bitcast<i32>(select(0u, 1u, _e210)) != 0i);
        if _e223 {
            atomicStore((&counts[((select(type_9().member_1, _e207.member, _e210) * 256u) + _e63)]), 0u);
        }
        continue;
        continuing {
            phi_379_ = type_9(select(_e207.member, (_e207.member + 1u), _e210), select(_e207.member_1, _e207.member_1, _e210));
            break if !(_e223);
        }
    }
    phi_416_ = type_9(0u, 8u);
    loop {
        let _e229 = phi_416_;
        let _e232 = (_e229.member < _e229.member_1);
        let _e245 = (bitcast<i32>(select(0u, 1u, _e232)) != 0i);
        if _e245 {
            atomicStore((&words[((select(type_9().member_1, _e229.member, _e232) * 256u) + _e63)]), 0u);
        }
        continue;
        continuing {
            phi_416_ = type_9(select(_e229.member, (_e229.member + 1u), _e232), select(_e229.member_1, _e229.member_1, _e232));
            break if !(_e245);
        }
    }
    if (_e63 == 0u) {
        atomicStore((&lowest[0u]), 4294967295u);
    }
    workgroupBarrier();
    let _e255 = ((_e98 >> bitcast<u32>((_e77 & 31u))) & 255u);
    let _e258 = (((_e63 / 32u) * 256u) + _e255);
    let _e264 = atomicOr((&words[_e258]), (1u << bitcast<u32>(((_e63 % 32u) & 31u))));
    workgroupBarrier();
    let _e266 = atomicLoad((&words[_e258]));
    let _e273 = countOneBits((_e266 & ((1u << bitcast<u32>(((_e63 % 32u) & 31u))) - 1u)));
    let _e276 = atomicLoad((&counts[(_e258 / 2u)]));
    workgroupBarrier();
    if (_e273 == 0u) {
        let _e293 = atomicAdd((&counts[(_e258 / 2u)]), (countOneBits(_e266) << bitcast<u32>(((16u * (_e255 % 2u)) & 31u))));
        atomicStore((&words[_e258]), 0u);
    }
    workgroupBarrier();
    let _e299 = ((_e109 >> bitcast<u32>((_e77 & 31u))) & 255u);
    let _e302 = (((_e63 / 32u) * 256u) + _e299);
    let _e308 = atomicOr((&words[_e302]), (1u << bitcast<u32>(((_e63 % 32u) & 31u))));
    workgroupBarrier();
    let _e310 = atomicLoad((&words[_e302]));
    let _e317 = countOneBits((_e310 & ((1u << bitcast<u32>(((_e63 % 32u) & 31u))) - 1u)));
    let _e320 = atomicLoad((&counts[(_e302 / 2u)]));
    workgroupBarrier();
    if (_e317 == 0u) {
        let _e337 = atomicAdd((&counts[(_e302 / 2u)]), (countOneBits(_e310) << bitcast<u32>(((16u * (_e299 % 2u)) & 31u))));
        atomicStore((&words[_e302]), 0u);
    }
    workgroupBarrier();
    let _e345 = ((_e120 >> bitcast<u32>((_e77 & 31u))) & 255u);
    let _e348 = (((_e63 / 32u) * 256u) + _e345);
    let _e354 = atomicOr((&words[_e348]), (1u << bitcast<u32>(((_e63 % 32u) & 31u))));
    workgroupBarrier();
    let _e356 = atomicLoad((&words[_e348]));
    let _e363 = countOneBits((_e356 & ((1u << bitcast<u32>(((_e63 % 32u) & 31u))) - 1u)));
    let _e366 = atomicLoad((&counts[(_e348 / 2u)]));
    workgroupBarrier();
    if (_e363 == 0u) {
        let _e383 = atomicAdd((&counts[(_e348 / 2u)]), (countOneBits(_e356) << bitcast<u32>(((16u * (_e345 % 2u)) & 31u))));
        atomicStore((&words[_e348]), 0u);
    }
    workgroupBarrier();
    let _e389 = ((_e131 >> bitcast<u32>((_e77 & 31u))) & 255u);
    let _e392 = (((_e63 / 32u) * 256u) + _e389);
    let _e398 = atomicOr((&words[_e392]), (1u << bitcast<u32>(((_e63 % 32u) & 31u))));
    workgroupBarrier();
    let _e400 = atomicLoad((&words[_e392]));
    let _e407 = countOneBits((_e400 & ((1u << bitcast<u32>(((_e63 % 32u) & 31u))) - 1u)));
    let _e410 = atomicLoad((&counts[(_e392 / 2u)]));
    workgroupBarrier();
    if (_e407 == 0u) {
        let _e427 = atomicAdd((&counts[(_e392 / 2u)]), (countOneBits(_e400) << bitcast<u32>(((16u * (_e389 % 2u)) & 31u))));
        atomicStore((&words[_e392]), 0u);
    }
    workgroupBarrier();
    let _e435 = ((_e142 >> bitcast<u32>((_e77 & 31u))) & 255u);
    let _e438 = (((_e63 / 32u) * 256u) + _e435);
    let _e444 = atomicOr((&words[_e438]), (1u << bitcast<u32>(((_e63 % 32u) & 31u))));
    workgroupBarrier();
    let _e446 = atomicLoad((&words[_e438]));
    let _e453 = countOneBits((_e446 & ((1u << bitcast<u32>(((_e63 % 32u) & 31u))) - 1u)));
    let _e456 = atomicLoad((&counts[(_e438 / 2u)]));
    workgroupBarrier();
    if (_e453 == 0u) {
        let _e473 = atomicAdd((&counts[(_e438 / 2u)]), (countOneBits(_e446) << bitcast<u32>(((16u * (_e435 % 2u)) & 31u))));
        atomicStore((&words[_e438]), 0u);
    }
    workgroupBarrier();
    let _e479 = ((_e153 >> bitcast<u32>((_e77 & 31u))) & 255u);
    let _e482 = (((_e63 / 32u) * 256u) + _e479);
    let _e488 = atomicOr((&words[_e482]), (1u << bitcast<u32>(((_e63 % 32u) & 31u))));
    workgroupBarrier();
    let _e490 = atomicLoad((&words[_e482]));
    let _e497 = countOneBits((_e490 & ((1u << bitcast<u32>(((_e63 % 32u) & 31u))) - 1u)));
    let _e500 = atomicLoad((&counts[(_e482 / 2u)]));
    workgroupBarrier();
    if (_e497 == 0u) {
        let _e517 = atomicAdd((&counts[(_e482 / 2u)]), (countOneBits(_e490) << bitcast<u32>(((16u * (_e479 % 2u)) & 31u))));
        atomicStore((&words[_e482]), 0u);
    }
    workgroupBarrier();
    let _e525 = ((_e164 >> bitcast<u32>((_e77 & 31u))) & 255u);
    let _e528 = (((_e63 / 32u) * 256u) + _e525);
    let _e534 = atomicOr((&words[_e528]), (1u << bitcast<u32>(((_e63 % 32u) & 31u))));
    workgroupBarrier();
    let _e536 = atomicLoad((&words[_e528]));
    let _e543 = countOneBits((_e536 & ((1u << bitcast<u32>(((_e63 % 32u) & 31u))) - 1u)));
    let _e546 = atomicLoad((&counts[(_e528 / 2u)]));
    workgroupBarrier();
    if (_e543 == 0u) {
        let _e563 = atomicAdd((&counts[(_e528 / 2u)]), (countOneBits(_e536) << bitcast<u32>(((16u * (_e525 % 2u)) & 31u))));
        atomicStore((&words[_e528]), 0u);
    }
    workgroupBarrier();
    let _e569 = ((_e175 >> bitcast<u32>((_e77 & 31u))) & 255u);
    let _e572 = (((_e63 / 32u) * 256u) + _e569);
    let _e578 = atomicOr((&words[_e572]), (1u << bitcast<u32>(((_e63 % 32u) & 31u))));
    workgroupBarrier();
    let _e580 = atomicLoad((&words[_e572]));
    let _e587 = countOneBits((_e580 & ((1u << bitcast<u32>(((_e63 % 32u) & 31u))) - 1u)));
    let _e590 = atomicLoad((&counts[(_e572 / 2u)]));
    workgroupBarrier();
    if (_e587 == 0u) {
        let _e607 = atomicAdd((&counts[(_e572 / 2u)]), (countOneBits(_e580) << bitcast<u32>(((16u * (_e569 % 2u)) & 31u))));
        atomicStore((&words[_e572]), 0u);
    }
    workgroupBarrier();
    let _e615 = ((_e186 >> bitcast<u32>((_e77 & 31u))) & 255u);
    let _e618 = (((_e63 / 32u) * 256u) + _e615);
    let _e624 = atomicOr((&words[_e618]), (1u << bitcast<u32>(((_e63 % 32u) & 31u))));
    workgroupBarrier();
    let _e626 = atomicLoad((&words[_e618]));
    let _e633 = countOneBits((_e626 & ((1u << bitcast<u32>(((_e63 % 32u) & 31u))) - 1u)));
    let _e636 = atomicLoad((&counts[(_e618 / 2u)]));
    workgroupBarrier();
    if (_e633 == 0u) {
        let _e653 = atomicAdd((&counts[(_e618 / 2u)]), (countOneBits(_e626) << bitcast<u32>(((16u * (_e615 % 2u)) & 31u))));
        atomicStore((&words[_e618]), 0u);
    }
    workgroupBarrier();
    let _e659 = ((_e197 >> bitcast<u32>((_e77 & 31u))) & 255u);
    let _e662 = (((_e63 / 32u) * 256u) + _e659);
    let _e668 = atomicOr((&words[_e662]), (1u << bitcast<u32>(((_e63 % 32u) & 31u))));
    workgroupBarrier();
    let _e670 = atomicLoad((&words[_e662]));
    let _e677 = countOneBits((_e670 & ((1u << bitcast<u32>(((_e63 % 32u) & 31u))) - 1u)));
    let _e680 = atomicLoad((&counts[(_e662 / 2u)]));
    workgroupBarrier();
    if (_e677 == 0u) {
        let _e697 = atomicAdd((&counts[(_e662 / 2u)]), (countOneBits(_e670) << bitcast<u32>(((16u * (_e659 % 2u)) & 31u))));
        atomicStore((&words[_e662]), 0u);
    }
    workgroupBarrier();
    workgroupBarrier();
    let _e704 = select(false, (_e87 < _e83), (_e63 < 256u));
    let _e706 = ((_e77 / 8u) % 2u);
    let _e710 = (((4u + (_e706 * _e83)) * 256u) + _e63);
    if (_e63 < 128u) {
        phi_977_ = type_9(0u, 8u);
        phi_980_ = 0u;
        loop {
            let _e713 = phi_977_;
            let _e715 = phi_980_;
            local = _e715;
            let _e718 = (_e713.member < _e713.member_1);
            let _e731 = (bitcast<i32>(select(0u, 1u, _e718)) != 0i);
            if _e731 {
                let _e733 = ((select(type_9().member_1, _e713.member, _e718) * 128u) + _e63);
                let _e735 = atomicLoad((&counts[_e733]));
                atomicStore((&counts[_e733]), _e715);
                phi_981_ = (_e715 + _e735);
            } else {
                phi_981_ = u32();
            }
            let _e739 = phi_981_;
            continue;
            continuing {
                phi_977_ = type_9(select(_e713.member, (_e713.member + 1u), _e718), select(_e713.member_1, _e713.member_1, _e718));
                phi_980_ = _e739;
                break if !(_e731);
            }
        }
        phi_1019_ = type_9(0u, 2u);
        loop {
            let _e742 = phi_1019_;
            let _e745 = (_e742.member < _e742.member_1);
            let _e756 = select(type_9().member_1, _e742.member, _e745);
            let _e758 = (bitcast<i32>(select(0u, 1u, _e745)) != 0i);
            if _e758 {
                let _e765 = local;
                atomicStore((&digits[((2u * _e63) + _e756)]), ((_e765 >> bitcast<u32>(((16u * (_e756 % 2u)) & 31u))) & 65535u));
            }
            continue;
            continuing {
                phi_1019_ = type_9(select(_e742.member, (_e742.member + 1u), _e745), select(_e742.member_1, _e742.member_1, _e745));
                break if !(_e758);
            }
        }
    }
    workgroupBarrier();
    let _e772 = atomicLoad((&digits[_e63]));
    if _e704 {
        atomicStore((&table.member[(_e710 + (_e87 * 256u))]), (select(1073741824u, 2147483648u, (_e87 == 0u)) | _e772));
        atomicStore((&table.member[((256u * ((4u + ((1u - _e706) * _e83)) + _e87)) + _e63)]), 0u);
    }
    atomicStore((&words[_e63]), _e772);
    phi_1086_ = type_9(0u, 8u);
    phi_1089_ = 0u;
    phi_1091_ = 1u;
    phi_1093_ = _e772;
    phi_1090_ = 256u;
    loop {
        let _e788 = phi_1086_;
        let _e790 = phi_1089_;
        let _e792 = phi_1091_;
        let _e794 = phi_1093_;
        let _e796 = phi_1090_;
        local_1 = _e794;
        let _e799 = (_e788.member < _e788.member_1);
        let _e810 = (bitcast<i32>(select(0u, 1u, _e799)) != 0i);
        if _e810 {
            workgroupBarrier();
            if (_e63 >= _e792) {
                let _e815 = atomicLoad((&words[((_e790 + _e63) - _e792)]));
                phi_1132_ = (_e794 + _e815);
            } else {
                phi_1132_ = _e794;
            }
            let _e818 = phi_1132_;
            atomicStore((&words[(_e796 + _e63)]), _e818);
            phi_1092_ = (_e792 * 2u);
            phi_1094_ = _e818;
        } else {
            phi_1092_ = u32();
            phi_1094_ = u32();
        }
        let _e823 = phi_1092_;
        let _e825 = phi_1094_;
        continue;
        continuing {
            phi_1086_ = type_9(select(_e788.member, (_e788.member + 1u), _e799), select(_e788.member_1, _e788.member_1, _e799));
            phi_1089_ = _e796;
            phi_1091_ = _e823;
            phi_1093_ = _e825;
            phi_1090_ = _e790;
            break if !(_e810);
        }
    }
    workgroupBarrier();
    atomicStore((&words[_e63]), _e205);
    phi_1139_ = type_9(0u, 8u);
    phi_1142_ = 0u;
    phi_1144_ = 1u;
    phi_1146_ = _e205;
    phi_1143_ = 256u;
    loop {
        let _e829 = phi_1139_;
        let _e831 = phi_1142_;
        let _e833 = phi_1144_;
        let _e835 = phi_1146_;
        let _e837 = phi_1143_;
        local_5 = _e835;
        let _e840 = (_e829.member < _e829.member_1);
        let _e851 = (bitcast<i32>(select(0u, 1u, _e840)) != 0i);
        if _e851 {
            workgroupBarrier();
            if (_e63 >= _e833) {
                let _e856 = atomicLoad((&words[((_e831 + _e63) - _e833)]));
                phi_1185_ = (_e835 + _e856);
            } else {
                phi_1185_ = _e835;
            }
            let _e859 = phi_1185_;
            atomicStore((&words[(_e837 + _e63)]), _e859);
            phi_1145_ = (_e833 * 2u);
            phi_1147_ = _e859;
        } else {
            phi_1145_ = u32();
            phi_1147_ = u32();
        }
        let _e864 = phi_1145_;
        let _e866 = phi_1147_;
        continue;
        continuing {
            phi_1139_ = type_9(select(_e829.member, (_e829.member + 1u), _e840), select(_e829.member_1, _e829.member_1, _e840));
            phi_1142_ = _e837;
            phi_1144_ = _e864;
            phi_1146_ = _e866;
            phi_1143_ = _e831;
            break if !(_e851);
        }
    }
    workgroupBarrier();
    let _e869 = local_1;
    let _e870 = (_e869 - _e772);
    if (_e63 < 256u) {
        atomicStore((&digits[_e63]), _e870);
    }
    workgroupBarrier();
    let _e876 = ((_e98 >> bitcast<u32>((_e77 & 31u))) & 255u);
    let _e882 = atomicLoad((&counts[((((_e63 / 32u) * 256u) + _e876) / 2u)]));
    let _e890 = atomicLoad((&digits[_e876]));
    let _e897 = ((_e109 >> bitcast<u32>((_e77 & 31u))) & 255u);
    let _e903 = atomicLoad((&counts[((((_e63 / 32u) * 256u) + _e897) / 2u)]));
    let _e911 = atomicLoad((&digits[_e897]));
    let _e915 = (((bitcast<u32>((((_e276 >> bitcast<u32>(((16u * (_e255 % 2u)) & 31u))) & 65535u) + _e273)) | ((((_e320 >> bitcast<u32>(((16u * (_e299 % 2u)) & 31u))) & 65535u) + _e317) << bitcast<u32>(16i))) + bitcast<u32>((((_e882 >> bitcast<u32>(((16u * (_e876 % 2u)) & 31u))) & 65535u) + _e890))) + ((((_e903 >> bitcast<u32>(((16u * (_e897 % 2u)) & 31u))) & 65535u) + _e911) << bitcast<u32>(16i)));
    let _e919 = ((_e120 >> bitcast<u32>((_e77 & 31u))) & 255u);
    let _e925 = atomicLoad((&counts[((((_e63 / 32u) * 256u) + _e919) / 2u)]));
    let _e933 = atomicLoad((&digits[_e919]));
    let _e940 = ((_e131 >> bitcast<u32>((_e77 & 31u))) & 255u);
    let _e946 = atomicLoad((&counts[((((_e63 / 32u) * 256u) + _e940) / 2u)]));
    let _e954 = atomicLoad((&digits[_e940]));
    let _e958 = (((bitcast<u32>((((_e366 >> bitcast<u32>(((16u * (_e345 % 2u)) & 31u))) & 65535u) + _e363)) | ((((_e410 >> bitcast<u32>(((16u * (_e389 % 2u)) & 31u))) & 65535u) + _e407) << bitcast<u32>(16i))) + bitcast<u32>((((_e925 >> bitcast<u32>(((16u * (_e919 % 2u)) & 31u))) & 65535u) + _e933))) + ((((_e946 >> bitcast<u32>(((16u * (_e940 % 2u)) & 31u))) & 65535u) + _e954) << bitcast<u32>(16i)));
    let _e962 = ((_e142 >> bitcast<u32>((_e77 & 31u))) & 255u);
    let _e968 = atomicLoad((&counts[((((_e63 / 32u) * 256u) + _e962) / 2u)]));
    let _e976 = atomicLoad((&digits[_e962]));
    let _e983 = ((_e153 >> bitcast<u32>((_e77 & 31u))) & 255u);
    let _e989 = atomicLoad((&counts[((((_e63 / 32u) * 256u) + _e983) / 2u)]));
    let _e997 = atomicLoad((&digits[_e983]));
    let _e1001 = (((bitcast<u32>((((_e456 >> bitcast<u32>(((16u * (_e435 % 2u)) & 31u))) & 65535u) + _e453)) | ((((_e500 >> bitcast<u32>(((16u * (_e479 % 2u)) & 31u))) & 65535u) + _e497) << bitcast<u32>(16i))) + bitcast<u32>((((_e968 >> bitcast<u32>(((16u * (_e962 % 2u)) & 31u))) & 65535u) + _e976))) + ((((_e989 >> bitcast<u32>(((16u * (_e983 % 2u)) & 31u))) & 65535u) + _e997) << bitcast<u32>(16i)));
    let _e1005 = ((_e164 >> bitcast<u32>((_e77 & 31u))) & 255u);
    let _e1011 = atomicLoad((&counts[((((_e63 / 32u) * 256u) + _e1005) / 2u)]));
    let _e1019 = atomicLoad((&digits[_e1005]));
    let _e1026 = ((_e175 >> bitcast<u32>((_e77 & 31u))) & 255u);
    let _e1032 = atomicLoad((&counts[((((_e63 / 32u) * 256u) + _e1026) / 2u)]));
    let _e1040 = atomicLoad((&digits[_e1026]));
    let _e1044 = (((bitcast<u32>((((_e546 >> bitcast<u32>(((16u * (_e525 % 2u)) & 31u))) & 65535u) + _e543)) | ((((_e590 >> bitcast<u32>(((16u * (_e569 % 2u)) & 31u))) & 65535u) + _e587) << bitcast<u32>(16i))) + bitcast<u32>((((_e1011 >> bitcast<u32>(((16u * (_e1005 % 2u)) & 31u))) & 65535u) + _e1019))) + ((((_e1032 >> bitcast<u32>(((16u * (_e1026 % 2u)) & 31u))) & 65535u) + _e1040) << bitcast<u32>(16i)));
    let _e1048 = ((_e186 >> bitcast<u32>((_e77 & 31u))) & 255u);
    let _e1054 = atomicLoad((&counts[((((_e63 / 32u) * 256u) + _e1048) / 2u)]));
    let _e1062 = atomicLoad((&digits[_e1048]));
    let _e1069 = ((_e197 >> bitcast<u32>((_e77 & 31u))) & 255u);
    let _e1075 = atomicLoad((&counts[((((_e63 / 32u) * 256u) + _e1069) / 2u)]));
    let _e1083 = atomicLoad((&digits[_e1069]));
    let _e1087 = (((bitcast<u32>((((_e636 >> bitcast<u32>(((16u * (_e615 % 2u)) & 31u))) & 65535u) + _e633)) | ((((_e680 >> bitcast<u32>(((16u * (_e659 % 2u)) & 31u))) & 65535u) + _e677) << bitcast<u32>(16i))) + bitcast<u32>((((_e1054 >> bitcast<u32>(((16u * (_e1048 % 2u)) & 31u))) & 65535u) + _e1062))) + ((((_e1075 >> bitcast<u32>(((16u * (_e1069 % 2u)) & 31u))) & 65535u) + _e1083) << bitcast<u32>(16i)));
    workgroupBarrier();
    atomicStore((&words[(_e915 & 65535u)]), _e98);
    atomicStore((&words[((_e915 >> bitcast<u32>(16u)) & 65535u)]), _e109);
    atomicStore((&words[(_e958 & 65535u)]), _e120);
    atomicStore((&words[((_e958 >> bitcast<u32>(16u)) & 65535u)]), _e131);
    atomicStore((&words[(_e1001 & 65535u)]), _e142);
    atomicStore((&words[((_e1001 >> bitcast<u32>(16u)) & 65535u)]), _e153);
    atomicStore((&words[(_e1044 & 65535u)]), _e164);
    atomicStore((&words[((_e1044 >> bitcast<u32>(16u)) & 65535u)]), _e175);
    atomicStore((&words[(_e1087 & 65535u)]), _e186);
    atomicStore((&words[((_e1087 >> bitcast<u32>(16u)) & 65535u)]), _e197);
    let _e1122 = (_e88 + (((_e63 / 32u) * 320u) + (_e63 % 32u)));
    let _e1123 = (_e80 - 1u);
    let _e1127 = values.member[select(_e1122, _e1123, (_e1123 < _e1122))];
    let _e1133 = (_e88 + ((((_e63 / 32u) * 320u) + 32u) + (_e63 % 32u)));
    let _e1134 = (_e80 - 1u);
    let _e1138 = values.member[select(_e1133, _e1134, (_e1134 < _e1133))];
    let _e1144 = (_e88 + ((((_e63 / 32u) * 320u) + 64u) + (_e63 % 32u)));
    let _e1145 = (_e80 - 1u);
    let _e1149 = values.member[select(_e1144, _e1145, (_e1145 < _e1144))];
    let _e1155 = (_e88 + ((((_e63 / 32u) * 320u) + 96u) + (_e63 % 32u)));
    let _e1156 = (_e80 - 1u);
    let _e1160 = values.member[select(_e1155, _e1156, (_e1156 < _e1155))];
    let _e1166 = (_e88 + ((((_e63 / 32u) * 320u) + 128u) + (_e63 % 32u)));
    let _e1167 = (_e80 - 1u);
    let _e1171 = values.member[select(_e1166, _e1167, (_e1167 < _e1166))];
    let _e1177 = (_e88 + ((((_e63 / 32u) * 320u) + 160u) + (_e63 % 32u)));
    let _e1178 = (_e80 - 1u);
    let _e1182 = values.member[select(_e1177, _e1178, (_e1178 < _e1177))];
    let _e1188 = (_e88 + ((((_e63 / 32u) * 320u) + 192u) + (_e63 % 32u)));
    let _e1189 = (_e80 - 1u);
    let _e1193 = values.member[select(_e1188, _e1189, (_e1189 < _e1188))];
    let _e1199 = (_e88 + ((((_e63 / 32u) * 320u) + 224u) + (_e63 % 32u)));
    let _e1200 = (_e80 - 1u);
    let _e1204 = values.member[select(_e1199, _e1200, (_e1200 < _e1199))];
    let _e1210 = (_e88 + ((((_e63 / 32u) * 320u) + 256u) + (_e63 % 32u)));
    let _e1211 = (_e80 - 1u);
    let _e1215 = values.member[select(_e1210, _e1211, (_e1211 < _e1210))];
    let _e1221 = (_e88 + ((((_e63 / 32u) * 320u) + 288u) + (_e63 % 32u)));
    let _e1222 = (_e80 - 1u);
    let _e1226 = values.member[select(_e1221, _e1222, (_e1222 < _e1221))];
    phi_1740_ = select(0u, _e87, _e704);
    phi_1743_ = 0u;
    loop {
        let _e1229 = phi_1740_;
        let _e1231 = phi_1743_;
        phi_1748_ = 0u;
        phi_1751_ = 0u;
        phi_1753_ = _e1229;
        loop {
            let _e1233 = phi_1748_;
            let _e1235 = phi_1751_;
            let _e1237 = phi_1753_;
            local_2 = _e1235;
            local_3 = _e1237;
            local_4 = _e1237;
            local_6 = _e1237;
            local_7 = _e1237;
            if (_e1237 > 0u) {
                let _e1239 = (_e1233 < 256u);
                if _e1239 {
                    let _e1240 = (_e1233 + 1u);
                    let _e1247 = atomicLoad((&table.member[(_e710 + select(0u, ((_e1237 - 1u) * 256u), (_e1237 > 0u)))]));
                    let _e1254 = atomicLoad((&table.member[(_e710 + select(0u, ((_e1237 - 2u) * 256u), (_e1237 > 1u)))]));
                    let _e1261 = atomicLoad((&table.member[(_e710 + select(0u, ((_e1237 - 3u) * 256u), (_e1237 > 2u)))]));
                    let _e1268 = atomicLoad((&table.member[(_e710 + select(0u, ((_e1237 - 4u) * 256u), (_e1237 > 3u)))]));
                    let _e1269 = (_e1247 != 0u);
                    let _e1270 = (_e1237 > 0u);
                    let _e1279 = select(_e1240, select(_e1240, 0u, _e1269), _e1270);
                    let _e1280 = select(_e1235, select(_e1235, (_e1235 + (_e1247 & 1073741823u)), _e1269), _e1270);
                    let _e1281 = select(_e1237, select(_e1237, select((_e1237 - 1u), 0u, (_e1247 >= 2147483648u)), _e1269), _e1270);
                    let _e1283 = select(false, (_e1254 != 0u), _e1269);
                    let _e1284 = (_e1281 > 0u);
                    let _e1293 = select(_e1279, select(_e1279, 0u, _e1283), _e1284);
                    let _e1294 = select(_e1280, select(_e1280, (_e1280 + (_e1254 & 1073741823u)), _e1283), _e1284);
                    let _e1295 = select(_e1281, select(_e1281, select((_e1281 - 1u), 0u, (_e1254 >= 2147483648u)), _e1283), _e1284);
                    let _e1297 = select(false, (_e1261 != 0u), _e1283);
                    let _e1298 = (_e1295 > 0u);
                    let _e1307 = select(_e1293, select(_e1293, 0u, _e1297), _e1298);
                    let _e1308 = select(_e1294, select(_e1294, (_e1294 + (_e1261 & 1073741823u)), _e1297), _e1298);
                    let _e1309 = select(_e1295, select(_e1295, select((_e1295 - 1u), 0u, (_e1261 >= 2147483648u)), _e1297), _e1298);
                    let _e1311 = select(false, (_e1268 != 0u), _e1297);
                    let _e1312 = (_e1309 > 0u);
                    phi_1946_ = select(_e1307, select(_e1307, 0u, _e1311), _e1312);
                    phi_1947_ = select(_e1308, select(_e1308, (_e1308 + (_e1268 & 1073741823u)), _e1311), _e1312);
                    phi_1948_ = select(_e1309, select(_e1309, select((_e1309 - 1u), 0u, (_e1268 >= 2147483648u)), _e1311), _e1312);
                } else {
                    phi_1946_ = u32();
                    phi_1947_ = u32();
                    phi_1948_ = u32();
                }
                let _e1325 = phi_1946_;
                let _e1327 = phi_1947_;
                let _e1329 = phi_1948_;
                phi_1749_ = _e1325;
                phi_1752_ = _e1327;
                phi_1754_ = _e1329;
                phi_1949_ = _e1239;
            } else {
                phi_1749_ = u32();
                phi_1752_ = u32();
                phi_1754_ = u32();
                phi_1949_ = false;
            }
            let _e1331 = phi_1749_;
            let _e1333 = phi_1752_;
            let _e1335 = phi_1754_;
            let _e1337 = phi_1949_;
            continue;
            continuing {
                phi_1748_ = _e1331;
                phi_1751_ = _e1333;
                phi_1753_ = _e1335;
                break if !(_e1337);
            }
        }
        let _e1340 = local_2;
        let _e1341 = (_e1231 + _e1340);
        let _e1343 = local_3;
        if (_e1343 > 0u) {
            let _e1352 = local_4;
            let _e1355 = atomicMin((&lowest[0u]), (_e1352 - 1u));
        } else {
            if _e704 {
                if (_e87 > 0u) {
                    atomicStore((&table.member[(_e710 + (_e87 * 256u))]), (2147483648u | (_e1341 + _e772)));
                }
            }
        }
        if (_e63 < 256u) {
            let _e1358 = local_5;
            atomicStore((&digits[_e63]), (((_e1358 - _e205) + _e1341) - _e870));
        }
        workgroupBarrier();
        if (_e63 == 0u) {
            let _e1365 = atomicLoad((&lowest[0u]));
            missing[0u] = _e1365;
        }
        let _e1368 = workgroupUniformLoad((&missing[0u]));
        if (_e1368 == 4294967295u) {
            phi_1741_ = u32();
            phi_1744_ = u32();
            phi_2069_ = false;
        } else {
            workgroupBarrier();
            if (_e63 < 256u) {
                atomicStore((&digits[_e63]), 0u);
            }
            if (_e63 == 0u) {
                atomicStore((&lowest[0u]), 4294967295u);
            }
            workgroupBarrier();
            phi_2008_ = type_9(0u, 10u);
            loop {
                let _e1375 = phi_2008_;
                let _e1378 = (_e1375.member < _e1375.member_1);
                let _e1391 = (bitcast<i32>(select(0u, 1u, _e1378)) != 0i);
                if _e1391 {
                    let _e1397 = keys.member[(((_e1368 * 2560u) + (select(type_9().member_1, _e1375.member, _e1378) * 256u)) + _e63)];
                    let _e1403 = atomicAdd((&digits[((_e1397 >> bitcast<u32>((_e77 & 31u))) & 255u)]), 1u);
                }
                continue;
                continuing {
                    phi_2008_ = type_9(select(_e1375.member, (_e1375.member + 1u), _e1378), select(_e1375.member_1, _e1375.member_1, _e1378));
                    break if !(_e1391);
                }
            }
            workgroupBarrier();
            let _e1407 = local_6;
            if (_e1407 == (_e1368 + 1u)) {
                let _e1410 = atomicLoad((&digits[_e63]));
                phi_2067_ = _e1368;
                phi_2068_ = (_e1341 + _e1410);
            } else {
                let _e1845 = local_7;
                phi_2067_ = _e1845;
                phi_2068_ = _e1341;
            }
            let _e1413 = phi_2067_;
            let _e1415 = phi_2068_;
            phi_1741_ = _e1413;
            phi_1744_ = _e1415;
            phi_2069_ = true;
        }
        let _e1417 = phi_1741_;
        let _e1419 = phi_1744_;
        let _e1421 = phi_2069_;
        continue;
        continuing {
            phi_1740_ = _e1417;
            phi_1743_ = _e1419;
            break if !(_e1421);
        }
    }
    if ((_e88 + _e63) < _e80) {
        let _e1426 = atomicLoad((&words[_e63]));
        let _e1430 = ((_e1426 >> bitcast<u32>((_e77 & 31u))) & 255u);
        let _e1436 = atomicLoad((&digits[_e1430]));
        keys_out.member[(_e1436 + _e63)] = _e1426;
        phi_2096_ = array<u32, 3>(bitcast<u32>(_e1430), array<u32, 3>(0u, 0u, 0u)[1], array<u32, 3>(0u, 0u, 0u)[2]);
    } else {
        phi_2096_ = array<u32, 3>(0u, 0u, 0u);
    }
    let _e1440 = phi_2096_;
    let _e1441 = (256u + _e63);
    if ((_e88 + _e1441) < _e80) {
        let _e1445 = atomicLoad((&words[_e1441]));
        let _e1449 = ((_e1445 >> bitcast<u32>((_e77 & 31u))) & 255u);
        let _e1458 = atomicLoad((&digits[_e1449]));
        keys_out.member[(_e1458 + _e1441)] = _e1445;
        phi_2123_ = array<u32, 3>((_e1440[0] | (_e1449 << bitcast<u32>(8i))), _e1440[1], _e1440[2]);
    } else {
        phi_2123_ = _e1440;
    }
    let _e1462 = phi_2123_;
    let _e1463 = (512u + _e63);
    if ((_e88 + _e1463) < _e80) {
        let _e1467 = atomicLoad((&words[_e1463]));
        let _e1471 = ((_e1467 >> bitcast<u32>((_e77 & 31u))) & 255u);
        let _e1480 = atomicLoad((&digits[_e1471]));
        keys_out.member[(_e1480 + _e1463)] = _e1467;
        phi_2150_ = array<u32, 3>((_e1462[0] | (_e1471 << bitcast<u32>(16i))), _e1462[1], _e1462[2]);
    } else {
        phi_2150_ = _e1462;
    }
    let _e1484 = phi_2150_;
    let _e1485 = (768u + _e63);
    if ((_e88 + _e1485) < _e80) {
        let _e1489 = atomicLoad((&words[_e1485]));
        let _e1493 = ((_e1489 >> bitcast<u32>((_e77 & 31u))) & 255u);
        let _e1502 = atomicLoad((&digits[_e1493]));
        keys_out.member[(_e1502 + _e1485)] = _e1489;
        phi_2177_ = array<u32, 3>((_e1484[0] | (_e1493 << bitcast<u32>(24i))), _e1484[1], _e1484[2]);
    } else {
        phi_2177_ = _e1484;
    }
    let _e1506 = phi_2177_;
    let _e1507 = (1024u + _e63);
    if ((_e88 + _e1507) < _e80) {
        let _e1511 = atomicLoad((&words[_e1507]));
        let _e1515 = ((_e1511 >> bitcast<u32>((_e77 & 31u))) & 255u);
        let _e1523 = atomicLoad((&digits[_e1515]));
        keys_out.member[(_e1523 + _e1507)] = _e1511;
        phi_2204_ = array<u32, 3>(_e1506[0], (_e1506[1] | bitcast<u32>(_e1515)), _e1506[2]);
    } else {
        phi_2204_ = _e1506;
    }
    let _e1527 = phi_2204_;
    let _e1528 = (1280u + _e63);
    if ((_e88 + _e1528) < _e80) {
        let _e1532 = atomicLoad((&words[_e1528]));
        let _e1536 = ((_e1532 >> bitcast<u32>((_e77 & 31u))) & 255u);
        let _e1545 = atomicLoad((&digits[_e1536]));
        keys_out.member[(_e1545 + _e1528)] = _e1532;
        phi_2231_ = array<u32, 3>(_e1527[0], (_e1527[1] | (_e1536 << bitcast<u32>(8i))), _e1527[2]);
    } else {
        phi_2231_ = _e1527;
    }
    let _e1549 = phi_2231_;
    let _e1550 = (1536u + _e63);
    if ((_e88 + _e1550) < _e80) {
        let _e1554 = atomicLoad((&words[_e1550]));
        let _e1558 = ((_e1554 >> bitcast<u32>((_e77 & 31u))) & 255u);
        let _e1567 = atomicLoad((&digits[_e1558]));
        keys_out.member[(_e1567 + _e1550)] = _e1554;
        phi_2258_ = array<u32, 3>(_e1549[0], (_e1549[1] | (_e1558 << bitcast<u32>(16i))), _e1549[2]);
    } else {
        phi_2258_ = _e1549;
    }
    let _e1571 = phi_2258_;
    let _e1572 = (1792u + _e63);
    if ((_e88 + _e1572) < _e80) {
        let _e1576 = atomicLoad((&words[_e1572]));
        let _e1580 = ((_e1576 >> bitcast<u32>((_e77 & 31u))) & 255u);
        let _e1589 = atomicLoad((&digits[_e1580]));
        keys_out.member[(_e1589 + _e1572)] = _e1576;
        phi_2285_ = array<u32, 3>(_e1571[0], (_e1571[1] | (_e1580 << bitcast<u32>(24i))), _e1571[2]);
    } else {
        phi_2285_ = _e1571;
    }
    let _e1593 = phi_2285_;
    let _e1594 = (2048u + _e63);
    if ((_e88 + _e1594) < _e80) {
        let _e1598 = atomicLoad((&words[_e1594]));
        let _e1602 = ((_e1598 >> bitcast<u32>((_e77 & 31u))) & 255u);
        let _e1610 = atomicLoad((&digits[_e1602]));
        keys_out.member[(_e1610 + _e1594)] = _e1598;
        phi_2312_ = array<u32, 3>(_e1593[0], _e1593[1], (_e1593[2] | bitcast<u32>(_e1602)));
    } else {
        phi_2312_ = _e1593;
    }
    let _e1614 = phi_2312_;
    let _e1615 = (2304u + _e63);
    if ((_e88 + _e1615) < _e80) {
        let _e1619 = atomicLoad((&words[_e1615]));
        let _e1623 = ((_e1619 >> bitcast<u32>((_e77 & 31u))) & 255u);
        let _e1632 = atomicLoad((&digits[_e1623]));
        keys_out.member[(_e1632 + _e1615)] = _e1619;
        phi_2339_ = array<u32, 3>(_e1614[0], _e1614[1], (_e1614[2] | (_e1623 << bitcast<u32>(8i))));
    } else {
        phi_2339_ = _e1614;
    }
    let _e1636 = phi_2339_;
    workgroupBarrier();
    atomicStore((&words[(_e915 & 65535u)]), _e1127);
    atomicStore((&words[((_e915 >> bitcast<u32>(16u)) & 65535u)]), _e1138);
    atomicStore((&words[(_e958 & 65535u)]), _e1149);
    atomicStore((&words[((_e958 >> bitcast<u32>(16u)) & 65535u)]), _e1160);
    atomicStore((&words[(_e1001 & 65535u)]), _e1171);
    atomicStore((&words[((_e1001 >> bitcast<u32>(16u)) & 65535u)]), _e1182);
    atomicStore((&words[(_e1044 & 65535u)]), _e1193);
    atomicStore((&words[((_e1044 >> bitcast<u32>(16u)) & 65535u)]), _e1204);
    atomicStore((&words[(_e1087 & 65535u)]), _e1215);
    atomicStore((&words[((_e1087 >> bitcast<u32>(16u)) & 65535u)]), _e1226);
    workgroupBarrier();
    if ((_e88 + _e63) < _e80) {
        let _e1672 = atomicLoad((&digits[(_e1636[0] & 255u)]));
        let _e1675 = atomicLoad((&words[_e63]));
        values_out.member[(_e1672 + _e63)] = _e1675;
    }
    let _e1677 = (256u + _e63);
    if ((_e88 + _e1677) < _e80) {
        let _e1685 = atomicLoad((&digits[((_e1636[0] >> bitcast<u32>(8u)) & 255u)]));
        let _e1688 = atomicLoad((&words[_e1677]));
        values_out.member[(_e1685 + _e1677)] = _e1688;
    }
    let _e1690 = (512u + _e63);
    if ((_e88 + _e1690) < _e80) {
        let _e1698 = atomicLoad((&digits[((_e1636[0] >> bitcast<u32>(16u)) & 255u)]));
        let _e1701 = atomicLoad((&words[_e1690]));
        values_out.member[(_e1698 + _e1690)] = _e1701;
    }
    let _e1703 = (768u + _e63);
    if ((_e88 + _e1703) < _e80) {
        let _e1711 = atomicLoad((&digits[((_e1636[0] >> bitcast<u32>(24u)) & 255u)]));
        let _e1714 = atomicLoad((&words[_e1703]));
        values_out.member[(_e1711 + _e1703)] = _e1714;
    }
    let _e1716 = (1024u + _e63);
    if ((_e88 + _e1716) < _e80) {
        let _e1722 = atomicLoad((&digits[(_e1636[1] & 255u)]));
        let _e1725 = atomicLoad((&words[_e1716]));
        values_out.member[(_e1722 + _e1716)] = _e1725;
    }
    let _e1727 = (1280u + _e63);
    if ((_e88 + _e1727) < _e80) {
        let _e1735 = atomicLoad((&digits[((_e1636[1] >> bitcast<u32>(8u)) & 255u)]));
        let _e1738 = atomicLoad((&words[_e1727]));
        values_out.member[(_e1735 + _e1727)] = _e1738;
    }
    let _e1740 = (1536u + _e63);
    if ((_e88 + _e1740) < _e80) {
        let _e1748 = atomicLoad((&digits[((_e1636[1] >> bitcast<u32>(16u)) & 255u)]));
        let _e1751 = atomicLoad((&words[_e1740]));
        values_out.member[(_e1748 + _e1740)] = _e1751;
    }
    let _e1753 = (1792u + _e63);
    if ((_e88 + _e1753) < _e80) {
        let _e1761 = atomicLoad((&digits[((_e1636[1] >> bitcast<u32>(24u)) & 255u)]));
        let _e1764 = atomicLoad((&words[_e1753]));
        values_out.member[(_e1761 + _e1753)] = _e1764;
    }
    let _e1766 = (2048u + _e63);
    if ((_e88 + _e1766) < _e80) {
        let _e1772 = atomicLoad((&digits[(_e1636[2] & 255u)]));
        let _e1775 = atomicLoad((&words[_e1766]));
        values_out.member[(_e1772 + _e1766)] = _e1775;
    }
    let _e1777 = (2304u + _e63);
    if ((_e88 + _e1777) < _e80) {
        let _e1785 = atomicLoad((&digits[((_e1636[2] >> bitcast<u32>(8u)) & 255u)]));
        let _e1788 = atomicLoad((&words[_e1777]));
        values_out.member[(_e1785 + _e1777)] = _e1788;
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn sort_scatter(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}

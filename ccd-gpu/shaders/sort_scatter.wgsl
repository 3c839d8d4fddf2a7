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

struct type_21 {
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
var<storage, read_write> table: type_21;
@group(0) @binding(4) 
var<storage, read_write> keys_out: type_13;
@group(0) @binding(5) 
var<storage, read_write> values_out: type_13;
var<workgroup> words: array<atomic<u32>, 2048>;
var<workgroup> lowest: array<atomic<u32>, 1>;
var<workgroup> digits: array<atomic<u32>, 256>;
var<workgroup> missing: array<u32, 1>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_139_: u32;
    var phi_161_: u32;
    var phi_183_: u32;
    var phi_205_: u32;
    var phi_227_: u32;
    var phi_249_: u32;
    var phi_271_: u32;
    var phi_293_: u32;
    var phi_297_: type_9;
    var phi_334_: type_9;
    var phi_829_: type_9;
    var phi_832_: u32;
    var phi_833_: u32;
    var phi_871_: type_9;
    var local: u32;
    var phi_960_: u32;
    var phi_961_: u32;
    var phi_965_: type_9;
    var phi_968_: u32;
    var phi_970_: u32;
    var phi_972_: u32;
    var phi_969_: u32;
    var phi_1011_: u32;
    var phi_971_: u32;
    var phi_973_: u32;
    var phi_1018_: type_9;
    var phi_1021_: u32;
    var phi_1023_: u32;
    var phi_1025_: u32;
    var phi_1022_: u32;
    var phi_1064_: u32;
    var phi_1024_: u32;
    var phi_1026_: u32;
    var local_1: u32;
    var phi_1104_: array<u32, 8>;
    var phi_1136_: array<u32, 8>;
    var phi_1168_: array<u32, 8>;
    var phi_1200_: array<u32, 8>;
    var phi_1232_: array<u32, 8>;
    var phi_1264_: array<u32, 8>;
    var phi_1296_: array<u32, 8>;
    var phi_1328_: array<u32, 8>;
    var phi_1438_: u32;
    var phi_1441_: u32;
    var phi_1446_: u32;
    var phi_1449_: u32;
    var phi_1451_: u32;
    var phi_1644_: u32;
    var phi_1645_: u32;
    var phi_1646_: u32;
    var phi_1447_: u32;
    var phi_1450_: u32;
    var phi_1452_: u32;
    var phi_1647_: bool;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1835_: u32;
    var phi_1836_: u32;
    var phi_1439_: u32;
    var phi_1442_: u32;
    var phi_1837_: bool;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_1880_: u32;
    var phi_1902_: u32;
    var phi_1924_: u32;
    var phi_1946_: u32;
    var phi_1968_: u32;
    var phi_1990_: u32;
    var phi_2012_: u32;
    var phi_2034_: u32;
    var phi_2052_: array<u32, 8>;
    var phi_2070_: array<u32, 8>;
    var phi_2088_: array<u32, 8>;
    var phi_2106_: array<u32, 8>;
    var phi_2124_: array<u32, 8>;
    var phi_2142_: array<u32, 8>;
    var phi_2160_: array<u32, 8>;
    var phi_2178_: array<u32, 8>;
    var local_9: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e51 = id_2;
    let _e52 = n_2;
    let _e53 = lane_2;
    let _e67 = params.member.member_2.member;
    let _e70 = params.member.member_1.member;
    let _e73 = params.member.member_2.member_1;
    let _e76 = params.member.member_1.member_1;
    let _e77 = (_e76 + ((_e51.y * _e52.x) + _e51.x));
    let _e78 = (_e77 * 2048u);
    let _e83 = (_e78 + (((_e53 / 32u) * 256u) + (_e53 % 32u)));
    if (_e83 < _e70) {
        let _e86 = keys.member[_e83];
        phi_139_ = _e86;
    } else {
        phi_139_ = 0u;
    }
    let _e88 = phi_139_;
    let _e94 = (_e78 + ((((_e53 / 32u) * 256u) + 32u) + (_e53 % 32u)));
    if (_e94 < _e70) {
        let _e97 = keys.member[_e94];
        phi_161_ = _e97;
    } else {
        phi_161_ = 0u;
    }
    let _e99 = phi_161_;
    let _e105 = (_e78 + ((((_e53 / 32u) * 256u) + 64u) + (_e53 % 32u)));
    if (_e105 < _e70) {
        let _e108 = keys.member[_e105];
        phi_183_ = _e108;
    } else {
        phi_183_ = 0u;
    }
    let _e110 = phi_183_;
    let _e116 = (_e78 + ((((_e53 / 32u) * 256u) + 96u) + (_e53 % 32u)));
    if (_e116 < _e70) {
        let _e119 = keys.member[_e116];
        phi_205_ = _e119;
    } else {
        phi_205_ = 0u;
    }
    let _e121 = phi_205_;
    let _e127 = (_e78 + ((((_e53 / 32u) * 256u) + 128u) + (_e53 % 32u)));
    if (_e127 < _e70) {
        let _e130 = keys.member[_e127];
        phi_227_ = _e130;
    } else {
        phi_227_ = 0u;
    }
    let _e132 = phi_227_;
    let _e138 = (_e78 + ((((_e53 / 32u) * 256u) + 160u) + (_e53 % 32u)));
    if (_e138 < _e70) {
        let _e141 = keys.member[_e138];
        phi_249_ = _e141;
    } else {
        phi_249_ = 0u;
    }
    let _e143 = phi_249_;
    let _e149 = (_e78 + ((((_e53 / 32u) * 256u) + 192u) + (_e53 % 32u)));
    if (_e149 < _e70) {
        let _e152 = keys.member[_e149];
        phi_271_ = _e152;
    } else {
        phi_271_ = 0u;
    }
    let _e154 = phi_271_;
    let _e160 = (_e78 + ((((_e53 / 32u) * 256u) + 224u) + (_e53 % 32u)));
    if (_e160 < _e70) {
        let _e163 = keys.member[_e160];
        phi_293_ = _e163;
    } else {
        phi_293_ = 0u;
    }
    let _e165 = phi_293_;
    phi_297_ = type_9(0u, 8u);
    loop {
        let _e168 = phi_297_;
        let _e171 = (_e168.member < _e168.member_1);
        let _e184 = (bitcast<i32>(select(0u, 1u, _e171)) != 0i);
        if _e184 {
            atomicStore((&words[((select(type_9().member_1, _e168.member, _e171) * 256u) + _e53)]), 0u);
        }
        continue;
        continuing {
            phi_297_ = type_9(select(_e168.member, (_e168.member + 1u), _e171), select(_e168.member_1, _e168.member_1, _e171));
            break if !(_e184);
        }
    }
    phi_334_ = type_9(0u, 4u);
    loop {
        let _e190 = phi_334_;
        let _e193 = (_e190.member < _e190.member_1);
        let _e206 = (bitcast<i32>(select(0u, 1u, _e193)) != 0i);
        if _e206 {
            atomicStore((&counts[((select(type_9().member_1, _e190.member, _e193) * 256u) + _e53)]), 0u);
        }
        continue;
        continuing {
            phi_334_ = type_9(select(_e190.member, (_e190.member + 1u), _e193), select(_e190.member_1, _e190.member_1, _e193));
            break if !(_e206);
        }
    }
    if (_e53 == 0u) {
        atomicStore((&lowest[0u]), 4294967295u);
    }
    workgroupBarrier();
    let _e218 = ((_e78 + (((_e53 / 32u) * 256u) + (_e53 % 32u))) < _e70);
    let _e222 = ((_e88 >> bitcast<u32>((_e67 & 31u))) & 255u);
    let _e225 = (((_e53 / 32u) * 256u) + _e222);
    if _e218 {
        let _e231 = atomicOr((&words[_e225]), (1u << bitcast<u32>(((_e53 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e233 = atomicLoad((&words[_e225]));
    let _e240 = countOneBits((_e233 & ((1u << bitcast<u32>(((_e53 % 32u) & 31u))) - 1u)));
    let _e243 = atomicLoad((&counts[(_e225 / 2u)]));
    let _e250 = (((_e243 >> bitcast<u32>(((16u * (_e222 % 2u)) & 31u))) & 65535u) + _e240);
    workgroupBarrier();
    if _e218 {
        if (_e240 == 0u) {
            let _e260 = atomicAdd((&counts[(_e225 / 2u)]), (countOneBits(_e233) << bitcast<u32>(((16u * (_e222 % 2u)) & 31u))));
            atomicStore((&words[_e225]), 0u);
        }
    }
    workgroupBarrier();
    let _e268 = ((_e78 + ((((_e53 / 32u) * 256u) + 32u) + (_e53 % 32u))) < _e70);
    let _e272 = ((_e99 >> bitcast<u32>((_e67 & 31u))) & 255u);
    let _e275 = (((_e53 / 32u) * 256u) + _e272);
    if _e268 {
        let _e281 = atomicOr((&words[_e275]), (1u << bitcast<u32>(((_e53 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e283 = atomicLoad((&words[_e275]));
    let _e290 = countOneBits((_e283 & ((1u << bitcast<u32>(((_e53 % 32u) & 31u))) - 1u)));
    let _e293 = atomicLoad((&counts[(_e275 / 2u)]));
    let _e300 = (((_e293 >> bitcast<u32>(((16u * (_e272 % 2u)) & 31u))) & 65535u) + _e290);
    workgroupBarrier();
    if _e268 {
        if (_e290 == 0u) {
            let _e310 = atomicAdd((&counts[(_e275 / 2u)]), (countOneBits(_e283) << bitcast<u32>(((16u * (_e272 % 2u)) & 31u))));
            atomicStore((&words[_e275]), 0u);
        }
    }
    workgroupBarrier();
    let _e318 = ((_e78 + ((((_e53 / 32u) * 256u) + 64u) + (_e53 % 32u))) < _e70);
    let _e322 = ((_e110 >> bitcast<u32>((_e67 & 31u))) & 255u);
    let _e325 = (((_e53 / 32u) * 256u) + _e322);
    if _e318 {
        let _e331 = atomicOr((&words[_e325]), (1u << bitcast<u32>(((_e53 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e333 = atomicLoad((&words[_e325]));
    let _e340 = countOneBits((_e333 & ((1u << bitcast<u32>(((_e53 % 32u) & 31u))) - 1u)));
    let _e343 = atomicLoad((&counts[(_e325 / 2u)]));
    let _e350 = (((_e343 >> bitcast<u32>(((16u * (_e322 % 2u)) & 31u))) & 65535u) + _e340);
    workgroupBarrier();
    if _e318 {
        if (_e340 == 0u) {
            let _e360 = atomicAdd((&counts[(_e325 / 2u)]), (countOneBits(_e333) << bitcast<u32>(((16u * (_e322 % 2u)) & 31u))));
            atomicStore((&words[_e325]), 0u);
        }
    }
    workgroupBarrier();
    let _e368 = ((_e78 + ((((_e53 / 32u) * 256u) + 96u) + (_e53 % 32u))) < _e70);
    let _e372 = ((_e121 >> bitcast<u32>((_e67 & 31u))) & 255u);
    let _e375 = (((_e53 / 32u) * 256u) + _e372);
    if _e368 {
        let _e381 = atomicOr((&words[_e375]), (1u << bitcast<u32>(((_e53 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e383 = atomicLoad((&words[_e375]));
    let _e390 = countOneBits((_e383 & ((1u << bitcast<u32>(((_e53 % 32u) & 31u))) - 1u)));
    let _e393 = atomicLoad((&counts[(_e375 / 2u)]));
    let _e400 = (((_e393 >> bitcast<u32>(((16u * (_e372 % 2u)) & 31u))) & 65535u) + _e390);
    workgroupBarrier();
    if _e368 {
        if (_e390 == 0u) {
            let _e410 = atomicAdd((&counts[(_e375 / 2u)]), (countOneBits(_e383) << bitcast<u32>(((16u * (_e372 % 2u)) & 31u))));
            atomicStore((&words[_e375]), 0u);
        }
    }
    workgroupBarrier();
    let _e418 = ((_e78 + ((((_e53 / 32u) * 256u) + 128u) + (_e53 % 32u))) < _e70);
    let _e422 = ((_e132 >> bitcast<u32>((_e67 & 31u))) & 255u);
    let _e425 = (((_e53 / 32u) * 256u) + _e422);
    if _e418 {
        let _e431 = atomicOr((&words[_e425]), (1u << bitcast<u32>(((_e53 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e433 = atomicLoad((&words[_e425]));
    let _e440 = countOneBits((_e433 & ((1u << bitcast<u32>(((_e53 % 32u) & 31u))) - 1u)));
    let _e443 = atomicLoad((&counts[(_e425 / 2u)]));
    let _e450 = (((_e443 >> bitcast<u32>(((16u * (_e422 % 2u)) & 31u))) & 65535u) + _e440);
    workgroupBarrier();
    if _e418 {
        if (_e440 == 0u) {
            let _e460 = atomicAdd((&counts[(_e425 / 2u)]), (countOneBits(_e433) << bitcast<u32>(((16u * (_e422 % 2u)) & 31u))));
            atomicStore((&words[_e425]), 0u);
        }
    }
    workgroupBarrier();
    let _e468 = ((_e78 + ((((_e53 / 32u) * 256u) + 160u) + (_e53 % 32u))) < _e70);
    let _e472 = ((_e143 >> bitcast<u32>((_e67 & 31u))) & 255u);
    let _e475 = (((_e53 / 32u) * 256u) + _e472);
    if _e468 {
        let _e481 = atomicOr((&words[_e475]), (1u << bitcast<u32>(((_e53 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e483 = atomicLoad((&words[_e475]));
    let _e490 = countOneBits((_e483 & ((1u << bitcast<u32>(((_e53 % 32u) & 31u))) - 1u)));
    let _e493 = atomicLoad((&counts[(_e475 / 2u)]));
    let _e500 = (((_e493 >> bitcast<u32>(((16u * (_e472 % 2u)) & 31u))) & 65535u) + _e490);
    workgroupBarrier();
    if _e468 {
        if (_e490 == 0u) {
            let _e510 = atomicAdd((&counts[(_e475 / 2u)]), (countOneBits(_e483) << bitcast<u32>(((16u * (_e472 % 2u)) & 31u))));
            atomicStore((&words[_e475]), 0u);
        }
    }
    workgroupBarrier();
    let _e518 = ((_e78 + ((((_e53 / 32u) * 256u) + 192u) + (_e53 % 32u))) < _e70);
    let _e522 = ((_e154 >> bitcast<u32>((_e67 & 31u))) & 255u);
    let _e525 = (((_e53 / 32u) * 256u) + _e522);
    if _e518 {
        let _e531 = atomicOr((&words[_e525]), (1u << bitcast<u32>(((_e53 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e533 = atomicLoad((&words[_e525]));
    let _e540 = countOneBits((_e533 & ((1u << bitcast<u32>(((_e53 % 32u) & 31u))) - 1u)));
    let _e543 = atomicLoad((&counts[(_e525 / 2u)]));
    let _e550 = (((_e543 >> bitcast<u32>(((16u * (_e522 % 2u)) & 31u))) & 65535u) + _e540);
    workgroupBarrier();
    if _e518 {
        if (_e540 == 0u) {
            let _e560 = atomicAdd((&counts[(_e525 / 2u)]), (countOneBits(_e533) << bitcast<u32>(((16u * (_e522 % 2u)) & 31u))));
            atomicStore((&words[_e525]), 0u);
        }
    }
    workgroupBarrier();
    let _e568 = ((_e78 + ((((_e53 / 32u) * 256u) + 224u) + (_e53 % 32u))) < _e70);
    let _e572 = ((_e165 >> bitcast<u32>((_e67 & 31u))) & 255u);
    let _e575 = (((_e53 / 32u) * 256u) + _e572);
    if _e568 {
        let _e581 = atomicOr((&words[_e575]), (1u << bitcast<u32>(((_e53 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e583 = atomicLoad((&words[_e575]));
    let _e590 = countOneBits((_e583 & ((1u << bitcast<u32>(((_e53 % 32u) & 31u))) - 1u)));
    let _e593 = atomicLoad((&counts[(_e575 / 2u)]));
    let _e600 = (((_e593 >> bitcast<u32>(((16u * (_e572 % 2u)) & 31u))) & 65535u) + _e590);
    workgroupBarrier();
    if _e568 {
        if (_e590 == 0u) {
            let _e610 = atomicAdd((&counts[(_e575 / 2u)]), (countOneBits(_e583) << bitcast<u32>(((16u * (_e572 % 2u)) & 31u))));
            atomicStore((&words[_e575]), 0u);
        }
    }
    workgroupBarrier();
    workgroupBarrier();
    if (_e53 < 128u) {
        phi_829_ = type_9(0u, 8u);
        phi_832_ = 0u;
        loop {
            let _e615 = phi_829_;
            let _e617 = phi_832_;
            local = _e617;
            let _e620 = (_e615.member < _e615.member_1);
            let _e633 = (bitcast<i32>(select(0u, 1u, _e620)) != 0i);
            if _e633 {
                let _e635 = ((select(type_9().member_1, _e615.member, _e620) * 128u) + _e53);
                let _e637 = atomicLoad((&counts[_e635]));
                atomicStore((&counts[_e635]), _e617);
                phi_833_ = (_e617 + _e637);
            } else {
                phi_833_ = u32();
            }
            let _e641 = phi_833_;
            continue;
            continuing {
                phi_829_ = type_9(select(_e615.member, (_e615.member + 1u), _e620), select(_e615.member_1, _e615.member_1, _e620));
                phi_832_ = _e641;
                break if !(_e633);
            }
        }
        phi_871_ = type_9(0u, 2u);
        loop {
            let _e644 = phi_871_;
            let _e647 = (_e644.member < _e644.member_1);
            let _e658 = select(type_9().member_1, _e644.member, _e647);
            let _e660 = (bitcast<i32>(select(0u, 1u, _e647)) != 0i);
            if _e660 {
                let _e667 = local;
                atomicStore((&digits[((2u * _e53) + _e658)]), ((_e667 >> bitcast<u32>(((16u * (_e658 % 2u)) & 31u))) & 65535u));
            }
            continue;
            continuing {
                phi_871_ = type_9(select(_e644.member, (_e644.member + 1u), _e647), select(_e644.member_1, _e644.member_1, _e647));
                break if !(_e660);
            }
        }
    }
    workgroupBarrier();
    let _e675 = select(false, (_e77 < _e73), (_e53 < 256u));
    let _e677 = ((_e67 / 8u) % 2u);
    let _e681 = (((4u + (_e677 * _e73)) * 256u) + _e53);
    if _e675 {
        let _e683 = atomicLoad((&digits[_e53]));
        let _e688 = atomicLoad((&table.member[(((_e67 / 8u) * 256u) + _e53)]));
        atomicStore((&table.member[(_e681 + (_e77 * 256u))]), (select(1073741824u, 2147483648u, (_e77 == 0u)) | _e683));
        atomicStore((&table.member[((256u * ((4u + ((1u - _e677) * _e73)) + _e77)) + _e53)]), 0u);
        phi_960_ = _e688;
        phi_961_ = _e683;
    } else {
        phi_960_ = 0u;
        phi_961_ = 0u;
    }
    let _e703 = phi_960_;
    let _e705 = phi_961_;
    atomicStore((&words[_e53]), _e705);
    phi_965_ = type_9(0u, 8u);
    phi_968_ = 0u;
    phi_970_ = 1u;
    phi_972_ = _e705;
    phi_969_ = 256u;
    loop {
        let _e708 = phi_965_;
        let _e710 = phi_968_;
        let _e712 = phi_970_;
        let _e714 = phi_972_;
        let _e716 = phi_969_;
        local_1 = _e714;
        let _e719 = (_e708.member < _e708.member_1);
        let _e730 = (bitcast<i32>(select(0u, 1u, _e719)) != 0i);
        if _e730 {
            workgroupBarrier();
            if (_e53 >= _e712) {
                let _e735 = atomicLoad((&words[((_e710 + _e53) - _e712)]));
                phi_1011_ = (_e714 + _e735);
            } else {
                phi_1011_ = _e714;
            }
            let _e738 = phi_1011_;
            atomicStore((&words[(_e716 + _e53)]), _e738);
            phi_971_ = (_e712 * 2u);
            phi_973_ = _e738;
        } else {
            phi_971_ = u32();
            phi_973_ = u32();
        }
        let _e743 = phi_971_;
        let _e745 = phi_973_;
        continue;
        continuing {
            phi_965_ = type_9(select(_e708.member, (_e708.member + 1u), _e719), select(_e708.member_1, _e708.member_1, _e719));
            phi_968_ = _e716;
            phi_970_ = _e743;
            phi_972_ = _e745;
            phi_969_ = _e710;
            break if !(_e730);
        }
    }
    workgroupBarrier();
    atomicStore((&words[_e53]), _e703);
    phi_1018_ = type_9(0u, 8u);
    phi_1021_ = 0u;
    phi_1023_ = 1u;
    phi_1025_ = _e703;
    phi_1022_ = 256u;
    loop {
        let _e749 = phi_1018_;
        let _e751 = phi_1021_;
        let _e753 = phi_1023_;
        let _e755 = phi_1025_;
        let _e757 = phi_1022_;
        local_7 = _e755;
        let _e760 = (_e749.member < _e749.member_1);
        let _e771 = (bitcast<i32>(select(0u, 1u, _e760)) != 0i);
        if _e771 {
            workgroupBarrier();
            if (_e53 >= _e753) {
                let _e776 = atomicLoad((&words[((_e751 + _e53) - _e753)]));
                phi_1064_ = (_e755 + _e776);
            } else {
                phi_1064_ = _e755;
            }
            let _e779 = phi_1064_;
            atomicStore((&words[(_e757 + _e53)]), _e779);
            phi_1024_ = (_e753 * 2u);
            phi_1026_ = _e779;
        } else {
            phi_1024_ = u32();
            phi_1026_ = u32();
        }
        let _e784 = phi_1024_;
        let _e786 = phi_1026_;
        continue;
        continuing {
            phi_1018_ = type_9(select(_e749.member, (_e749.member + 1u), _e760), select(_e749.member_1, _e749.member_1, _e760));
            phi_1021_ = _e757;
            phi_1023_ = _e784;
            phi_1025_ = _e786;
            phi_1022_ = _e751;
            break if !(_e771);
        }
    }
    workgroupBarrier();
    let _e789 = local_1;
    let _e790 = (_e789 - _e705);
    if (_e53 < 256u) {
        atomicStore((&digits[_e53]), _e790);
    }
    workgroupBarrier();
    if ((_e78 + (((_e53 / 32u) * 256u) + (_e53 % 32u))) < _e70) {
        let _e802 = ((_e88 >> bitcast<u32>((_e67 & 31u))) & 255u);
        let _e808 = atomicLoad((&counts[((((_e53 / 32u) * 256u) + _e802) / 2u)]));
        let _e816 = atomicLoad((&digits[_e802]));
        phi_1104_ = array<u32, 8>((_e250 + (((_e808 >> bitcast<u32>(((16u * (_e802 % 2u)) & 31u))) & 65535u) + _e816)), _e300, _e350, _e400, _e450, _e500, _e550, _e600);
    } else {
        phi_1104_ = array<u32, 8>(_e250, _e300, _e350, _e400, _e450, _e500, _e550, _e600);
    }
    let _e821 = phi_1104_;
    if ((_e78 + ((((_e53 / 32u) * 256u) + 32u) + (_e53 % 32u))) < _e70) {
        let _e832 = ((_e99 >> bitcast<u32>((_e67 & 31u))) & 255u);
        let _e838 = atomicLoad((&counts[((((_e53 / 32u) * 256u) + _e832) / 2u)]));
        let _e846 = atomicLoad((&digits[_e832]));
        phi_1136_ = array<u32, 8>(_e821[0], (_e821[1] + (((_e838 >> bitcast<u32>(((16u * (_e832 % 2u)) & 31u))) & 65535u) + _e846)), _e821[2], _e821[3], _e821[4], _e821[5], _e821[6], _e821[7]);
    } else {
        phi_1136_ = _e821;
    }
    let _e859 = phi_1136_;
    if ((_e78 + ((((_e53 / 32u) * 256u) + 64u) + (_e53 % 32u))) < _e70) {
        let _e870 = ((_e110 >> bitcast<u32>((_e67 & 31u))) & 255u);
        let _e876 = atomicLoad((&counts[((((_e53 / 32u) * 256u) + _e870) / 2u)]));
        let _e884 = atomicLoad((&digits[_e870]));
        phi_1168_ = array<u32, 8>(_e859[0], _e859[1], (_e859[2] + (((_e876 >> bitcast<u32>(((16u * (_e870 % 2u)) & 31u))) & 65535u) + _e884)), _e859[3], _e859[4], _e859[5], _e859[6], _e859[7]);
    } else {
        phi_1168_ = _e859;
    }
    let _e897 = phi_1168_;
    if ((_e78 + ((((_e53 / 32u) * 256u) + 96u) + (_e53 % 32u))) < _e70) {
        let _e908 = ((_e121 >> bitcast<u32>((_e67 & 31u))) & 255u);
        let _e914 = atomicLoad((&counts[((((_e53 / 32u) * 256u) + _e908) / 2u)]));
        let _e922 = atomicLoad((&digits[_e908]));
        phi_1200_ = array<u32, 8>(_e897[0], _e897[1], _e897[2], (_e897[3] + (((_e914 >> bitcast<u32>(((16u * (_e908 % 2u)) & 31u))) & 65535u) + _e922)), _e897[4], _e897[5], _e897[6], _e897[7]);
    } else {
        phi_1200_ = _e897;
    }
    let _e935 = phi_1200_;
    if ((_e78 + ((((_e53 / 32u) * 256u) + 128u) + (_e53 % 32u))) < _e70) {
        let _e946 = ((_e132 >> bitcast<u32>((_e67 & 31u))) & 255u);
        let _e952 = atomicLoad((&counts[((((_e53 / 32u) * 256u) + _e946) / 2u)]));
        let _e960 = atomicLoad((&digits[_e946]));
        phi_1232_ = array<u32, 8>(_e935[0], _e935[1], _e935[2], _e935[3], (_e935[4] + (((_e952 >> bitcast<u32>(((16u * (_e946 % 2u)) & 31u))) & 65535u) + _e960)), _e935[5], _e935[6], _e935[7]);
    } else {
        phi_1232_ = _e935;
    }
    let _e973 = phi_1232_;
    if ((_e78 + ((((_e53 / 32u) * 256u) + 160u) + (_e53 % 32u))) < _e70) {
        let _e984 = ((_e143 >> bitcast<u32>((_e67 & 31u))) & 255u);
        let _e990 = atomicLoad((&counts[((((_e53 / 32u) * 256u) + _e984) / 2u)]));
        let _e998 = atomicLoad((&digits[_e984]));
        phi_1264_ = array<u32, 8>(_e973[0], _e973[1], _e973[2], _e973[3], _e973[4], (_e973[5] + (((_e990 >> bitcast<u32>(((16u * (_e984 % 2u)) & 31u))) & 65535u) + _e998)), _e973[6], _e973[7]);
    } else {
        phi_1264_ = _e973;
    }
    let _e1011 = phi_1264_;
    if ((_e78 + ((((_e53 / 32u) * 256u) + 192u) + (_e53 % 32u))) < _e70) {
        let _e1022 = ((_e154 >> bitcast<u32>((_e67 & 31u))) & 255u);
        let _e1028 = atomicLoad((&counts[((((_e53 / 32u) * 256u) + _e1022) / 2u)]));
        let _e1036 = atomicLoad((&digits[_e1022]));
        phi_1296_ = array<u32, 8>(_e1011[0], _e1011[1], _e1011[2], _e1011[3], _e1011[4], _e1011[5], (_e1011[6] + (((_e1028 >> bitcast<u32>(((16u * (_e1022 % 2u)) & 31u))) & 65535u) + _e1036)), _e1011[7]);
    } else {
        phi_1296_ = _e1011;
    }
    let _e1049 = phi_1296_;
    if ((_e78 + ((((_e53 / 32u) * 256u) + 224u) + (_e53 % 32u))) < _e70) {
        let _e1060 = ((_e165 >> bitcast<u32>((_e67 & 31u))) & 255u);
        let _e1066 = atomicLoad((&counts[((((_e53 / 32u) * 256u) + _e1060) / 2u)]));
        let _e1074 = atomicLoad((&digits[_e1060]));
        phi_1328_ = array<u32, 8>(_e1049[0], _e1049[1], _e1049[2], _e1049[3], _e1049[4], _e1049[5], _e1049[6], (_e1049[7] + (((_e1066 >> bitcast<u32>(((16u * (_e1060 % 2u)) & 31u))) & 65535u) + _e1074)));
    } else {
        phi_1328_ = _e1049;
    }
    let _e1087 = phi_1328_;
    workgroupBarrier();
    if ((_e78 + (((_e53 / 32u) * 256u) + (_e53 % 32u))) < _e70) {
        atomicStore((&words[_e1087[0]]), _e88);
    }
    if ((_e78 + ((((_e53 / 32u) * 256u) + 32u) + (_e53 % 32u))) < _e70) {
        atomicStore((&words[_e1087[1]]), _e99);
    }
    if ((_e78 + ((((_e53 / 32u) * 256u) + 64u) + (_e53 % 32u))) < _e70) {
        atomicStore((&words[_e1087[2]]), _e110);
    }
    if ((_e78 + ((((_e53 / 32u) * 256u) + 96u) + (_e53 % 32u))) < _e70) {
        atomicStore((&words[_e1087[3]]), _e121);
    }
    if ((_e78 + ((((_e53 / 32u) * 256u) + 128u) + (_e53 % 32u))) < _e70) {
        atomicStore((&words[_e1087[4]]), _e132);
    }
    if ((_e78 + ((((_e53 / 32u) * 256u) + 160u) + (_e53 % 32u))) < _e70) {
        atomicStore((&words[_e1087[5]]), _e143);
    }
    if ((_e78 + ((((_e53 / 32u) * 256u) + 192u) + (_e53 % 32u))) < _e70) {
        atomicStore((&words[_e1087[6]]), _e154);
    }
    if ((_e78 + ((((_e53 / 32u) * 256u) + 224u) + (_e53 % 32u))) < _e70) {
        atomicStore((&words[_e1087[7]]), _e165);
    }
    phi_1438_ = select(0u, _e77, _e675);
    phi_1441_ = 0u;
    loop {
        let _e1161 = phi_1438_;
        let _e1163 = phi_1441_;
        phi_1446_ = 0u;
        phi_1449_ = 0u;
        phi_1451_ = _e1161;
        loop {
            let _e1165 = phi_1446_;
            let _e1167 = phi_1449_;
            let _e1169 = phi_1451_;
            local_2 = _e1167;
            local_3 = _e1169;
            local_4 = _e1169;
            local_5 = _e1169;
            local_9 = _e1169;
            if (_e1169 > 0u) {
                let _e1171 = (_e1165 < 256u);
                if _e1171 {
                    let _e1172 = (_e1165 + 1u);
                    let _e1179 = atomicLoad((&table.member[(_e681 + select(0u, ((_e1169 - 1u) * 256u), (_e1169 > 0u)))]));
                    let _e1186 = atomicLoad((&table.member[(_e681 + select(0u, ((_e1169 - 2u) * 256u), (_e1169 > 1u)))]));
                    let _e1193 = atomicLoad((&table.member[(_e681 + select(0u, ((_e1169 - 3u) * 256u), (_e1169 > 2u)))]));
                    let _e1200 = atomicLoad((&table.member[(_e681 + select(0u, ((_e1169 - 4u) * 256u), (_e1169 > 3u)))]));
                    let _e1201 = (_e1179 != 0u);
                    let _e1202 = (_e1169 > 0u);
                    let _e1211 = select(_e1172, select(_e1172, 0u, _e1201), _e1202);
                    let _e1212 = select(_e1167, select(_e1167, (_e1167 + (_e1179 & 1073741823u)), _e1201), _e1202);
                    let _e1213 = select(_e1169, select(_e1169, select((_e1169 - 1u), 0u, (_e1179 >= 2147483648u)), _e1201), _e1202);
                    let _e1215 = select(false, (_e1186 != 0u), _e1201);
                    let _e1216 = (_e1213 > 0u);
                    let _e1225 = select(_e1211, select(_e1211, 0u, _e1215), _e1216);
                    let _e1226 = select(_e1212, select(_e1212, (_e1212 + (_e1186 & 1073741823u)), _e1215), _e1216);
                    let _e1227 = select(_e1213, select(_e1213, select((_e1213 - 1u), 0u, (_e1186 >= 2147483648u)), _e1215), _e1216);
                    let _e1229 = select(false, (_e1193 != 0u), _e1215);
                    let _e1230 = (_e1227 > 0u);
                    let _e1239 = select(_e1225, select(_e1225, 0u, _e1229), _e1230);
                    let _e1240 = select(_e1226, select(_e1226, (_e1226 + (_e1193 & 1073741823u)), _e1229), _e1230);
                    let _e1241 = select(_e1227, select(_e1227, select((_e1227 - 1u), 0u, (_e1193 >= 2147483648u)), _e1229), _e1230);
                    let _e1243 = select(false, (_e1200 != 0u), _e1229);
                    let _e1244 = (_e1241 > 0u);
                    phi_1644_ = select(_e1239, select(_e1239, 0u, _e1243), _e1244);
                    phi_1645_ = select(_e1240, select(_e1240, (_e1240 + (_e1200 & 1073741823u)), _e1243), _e1244);
                    phi_1646_ = select(_e1241, select(_e1241, select((_e1241 - 1u), 0u, (_e1200 >= 2147483648u)), _e1243), _e1244);
                } else {
                    phi_1644_ = u32();
                    phi_1645_ = u32();
                    phi_1646_ = u32();
                }
                let _e1257 = phi_1644_;
                let _e1259 = phi_1645_;
                let _e1261 = phi_1646_;
                phi_1447_ = _e1257;
                phi_1450_ = _e1259;
                phi_1452_ = _e1261;
                phi_1647_ = _e1171;
            } else {
                phi_1447_ = u32();
                phi_1450_ = u32();
                phi_1452_ = u32();
                phi_1647_ = false;
            }
            let _e1263 = phi_1447_;
            let _e1265 = phi_1450_;
            let _e1267 = phi_1452_;
            let _e1269 = phi_1647_;
            continue;
            continuing {
                phi_1446_ = _e1263;
                phi_1449_ = _e1265;
                phi_1451_ = _e1267;
                break if !(_e1269);
            }
        }
        let _e1272 = local_2;
        let _e1273 = (_e1163 + _e1272);
        let _e1275 = local_3;
        local_6 = _e1273;
        local_8 = _e1273;
        if (_e1275 > 0u) {
            let _e1278 = local_4;
            let _e1281 = atomicMin((&lowest[0u]), (_e1278 - 1u));
        }
        workgroupBarrier();
        if (_e53 == 0u) {
            let _e1284 = atomicLoad((&lowest[0u]));
            missing[0u] = _e1284;
        }
        let _e1287 = workgroupUniformLoad((&missing[0u]));
        if (_e1287 == 4294967295u) {
            phi_1439_ = u32();
            phi_1442_ = u32();
            phi_1837_ = false;
        } else {
            if (_e53 < 256u) {
                atomicStore((&digits[_e53]), 0u);
            }
            workgroupBarrier();
            if (_e53 == 0u) {
                atomicStore((&lowest[0u]), 4294967295u);
            }
            let _e1296 = keys.member[((_e1287 * 2048u) + _e53)];
            let _e1302 = atomicAdd((&digits[((_e1296 >> bitcast<u32>((_e67 & 31u))) & 255u)]), 1u);
            let _e1307 = keys.member[(((_e1287 * 2048u) + 256u) + _e53)];
            let _e1313 = atomicAdd((&digits[((_e1307 >> bitcast<u32>((_e67 & 31u))) & 255u)]), 1u);
            let _e1318 = keys.member[(((_e1287 * 2048u) + 512u) + _e53)];
            let _e1324 = atomicAdd((&digits[((_e1318 >> bitcast<u32>((_e67 & 31u))) & 255u)]), 1u);
            let _e1329 = keys.member[(((_e1287 * 2048u) + 768u) + _e53)];
            let _e1335 = atomicAdd((&digits[((_e1329 >> bitcast<u32>((_e67 & 31u))) & 255u)]), 1u);
            let _e1340 = keys.member[(((_e1287 * 2048u) + 1024u) + _e53)];
            let _e1346 = atomicAdd((&digits[((_e1340 >> bitcast<u32>((_e67 & 31u))) & 255u)]), 1u);
            let _e1351 = keys.member[(((_e1287 * 2048u) + 1280u) + _e53)];
            let _e1357 = atomicAdd((&digits[((_e1351 >> bitcast<u32>((_e67 & 31u))) & 255u)]), 1u);
            let _e1362 = keys.member[(((_e1287 * 2048u) + 1536u) + _e53)];
            let _e1368 = atomicAdd((&digits[((_e1362 >> bitcast<u32>((_e67 & 31u))) & 255u)]), 1u);
            let _e1373 = keys.member[(((_e1287 * 2048u) + 1792u) + _e53)];
            let _e1379 = atomicAdd((&digits[((_e1373 >> bitcast<u32>((_e67 & 31u))) & 255u)]), 1u);
            workgroupBarrier();
            let _e1382 = local_5;
            if (_e1382 == (_e1287 + 1u)) {
                let _e1385 = atomicLoad((&digits[_e53]));
                phi_1835_ = _e1287;
                phi_1836_ = (_e1273 + _e1385);
            } else {
                let _e1864 = local_9;
                phi_1835_ = _e1864;
                phi_1836_ = _e1273;
            }
            let _e1388 = phi_1835_;
            let _e1390 = phi_1836_;
            workgroupBarrier();
            phi_1439_ = _e1388;
            phi_1442_ = _e1390;
            phi_1837_ = true;
        }
        let _e1392 = phi_1439_;
        let _e1394 = phi_1442_;
        let _e1396 = phi_1837_;
        continue;
        continuing {
            phi_1438_ = _e1392;
            phi_1441_ = _e1394;
            break if !(_e1396);
        }
    }
    if _e675 {
        if (_e77 > 0u) {
            let _e1402 = local_6;
            atomicStore((&table.member[(_e681 + (_e77 * 256u))]), (2147483648u | (_e1402 + _e705)));
        }
    }
    if (_e53 < 256u) {
        let _e1408 = local_7;
        let _e1411 = local_8;
        atomicStore((&digits[_e53]), (((_e1408 - _e703) + _e1411) - _e790));
    }
    workgroupBarrier();
    let _e1419 = (_e78 + (((_e53 / 32u) * 256u) + (_e53 % 32u)));
    if (_e1419 < _e70) {
        let _e1422 = values.member[_e1419];
        phi_1880_ = _e1422;
    } else {
        phi_1880_ = 0u;
    }
    let _e1424 = phi_1880_;
    let _e1430 = (_e78 + ((((_e53 / 32u) * 256u) + 32u) + (_e53 % 32u)));
    if (_e1430 < _e70) {
        let _e1433 = values.member[_e1430];
        phi_1902_ = _e1433;
    } else {
        phi_1902_ = 0u;
    }
    let _e1435 = phi_1902_;
    let _e1441 = (_e78 + ((((_e53 / 32u) * 256u) + 64u) + (_e53 % 32u)));
    if (_e1441 < _e70) {
        let _e1444 = values.member[_e1441];
        phi_1924_ = _e1444;
    } else {
        phi_1924_ = 0u;
    }
    let _e1446 = phi_1924_;
    let _e1452 = (_e78 + ((((_e53 / 32u) * 256u) + 96u) + (_e53 % 32u)));
    if (_e1452 < _e70) {
        let _e1455 = values.member[_e1452];
        phi_1946_ = _e1455;
    } else {
        phi_1946_ = 0u;
    }
    let _e1457 = phi_1946_;
    let _e1463 = (_e78 + ((((_e53 / 32u) * 256u) + 128u) + (_e53 % 32u)));
    if (_e1463 < _e70) {
        let _e1466 = values.member[_e1463];
        phi_1968_ = _e1466;
    } else {
        phi_1968_ = 0u;
    }
    let _e1468 = phi_1968_;
    let _e1474 = (_e78 + ((((_e53 / 32u) * 256u) + 160u) + (_e53 % 32u)));
    if (_e1474 < _e70) {
        let _e1477 = values.member[_e1474];
        phi_1990_ = _e1477;
    } else {
        phi_1990_ = 0u;
    }
    let _e1479 = phi_1990_;
    let _e1485 = (_e78 + ((((_e53 / 32u) * 256u) + 192u) + (_e53 % 32u)));
    if (_e1485 < _e70) {
        let _e1488 = values.member[_e1485];
        phi_2012_ = _e1488;
    } else {
        phi_2012_ = 0u;
    }
    let _e1490 = phi_2012_;
    let _e1496 = (_e78 + ((((_e53 / 32u) * 256u) + 224u) + (_e53 % 32u)));
    if (_e1496 < _e70) {
        let _e1499 = values.member[_e1496];
        phi_2034_ = _e1499;
    } else {
        phi_2034_ = 0u;
    }
    let _e1501 = phi_2034_;
    if ((_e78 + _e53) < _e70) {
        let _e1505 = atomicLoad((&words[_e53]));
        let _e1511 = atomicLoad((&digits[((_e1505 >> bitcast<u32>((_e67 & 31u))) & 255u)]));
        let _e1512 = (_e1511 + _e53);
        keys_out.member[_e1512] = _e1505;
        phi_2052_ = array<u32, 8>(_e1512, _e99, _e110, _e121, _e132, _e143, _e154, _e165);
    } else {
        phi_2052_ = array<u32, 8>(_e88, _e99, _e110, _e121, _e132, _e143, _e154, _e165);
    }
    let _e1516 = phi_2052_;
    let _e1517 = (256u + _e53);
    if ((_e78 + _e1517) < _e70) {
        let _e1521 = atomicLoad((&words[_e1517]));
        let _e1527 = atomicLoad((&digits[((_e1521 >> bitcast<u32>((_e67 & 31u))) & 255u)]));
        let _e1528 = (_e1527 + _e1517);
        keys_out.member[_e1528] = _e1521;
        phi_2070_ = array<u32, 8>(_e1516[0], _e1528, _e1516[2], _e1516[3], _e1516[4], _e1516[5], _e1516[6], _e1516[7]);
    } else {
        phi_2070_ = _e1516;
    }
    let _e1539 = phi_2070_;
    let _e1540 = (512u + _e53);
    if ((_e78 + _e1540) < _e70) {
        let _e1544 = atomicLoad((&words[_e1540]));
        let _e1550 = atomicLoad((&digits[((_e1544 >> bitcast<u32>((_e67 & 31u))) & 255u)]));
        let _e1551 = (_e1550 + _e1540);
        keys_out.member[_e1551] = _e1544;
        phi_2088_ = array<u32, 8>(_e1539[0], _e1539[1], _e1551, _e1539[3], _e1539[4], _e1539[5], _e1539[6], _e1539[7]);
    } else {
        phi_2088_ = _e1539;
    }
    let _e1562 = phi_2088_;
    let _e1563 = (768u + _e53);
    if ((_e78 + _e1563) < _e70) {
        let _e1567 = atomicLoad((&words[_e1563]));
        let _e1573 = atomicLoad((&digits[((_e1567 >> bitcast<u32>((_e67 & 31u))) & 255u)]));
        let _e1574 = (_e1573 + _e1563);
        keys_out.member[_e1574] = _e1567;
        phi_2106_ = array<u32, 8>(_e1562[0], _e1562[1], _e1562[2], _e1574, _e1562[4], _e1562[5], _e1562[6], _e1562[7]);
    } else {
        phi_2106_ = _e1562;
    }
    let _e1585 = phi_2106_;
    let _e1586 = (1024u + _e53);
    if ((_e78 + _e1586) < _e70) {
        let _e1590 = atomicLoad((&words[_e1586]));
        let _e1596 = atomicLoad((&digits[((_e1590 >> bitcast<u32>((_e67 & 31u))) & 255u)]));
        let _e1597 = (_e1596 + _e1586);
        keys_out.member[_e1597] = _e1590;
        phi_2124_ = array<u32, 8>(_e1585[0], _e1585[1], _e1585[2], _e1585[3], _e1597, _e1585[5], _e1585[6], _e1585[7]);
    } else {
        phi_2124_ = _e1585;
    }
    let _e1608 = phi_2124_;
    let _e1609 = (1280u + _e53);
    if ((_e78 + _e1609) < _e70) {
        let _e1613 = atomicLoad((&words[_e1609]));
        let _e1619 = atomicLoad((&digits[((_e1613 >> bitcast<u32>((_e67 & 31u))) & 255u)]));
        let _e1620 = (_e1619 + _e1609);
        keys_out.member[_e1620] = _e1613;
        phi_2142_ = array<u32, 8>(_e1608[0], _e1608[1], _e1608[2], _e1608[3], _e1608[4], _e1620, _e1608[6], _e1608[7]);
    } else {
        phi_2142_ = _e1608;
    }
    let _e1631 = phi_2142_;
    let _e1632 = (1536u + _e53);
    if ((_e78 + _e1632) < _e70) {
        let _e1636 = atomicLoad((&words[_e1632]));
        let _e1642 = atomicLoad((&digits[((_e1636 >> bitcast<u32>((_e67 & 31u))) & 255u)]));
        let _e1643 = (_e1642 + _e1632);
        keys_out.member[_e1643] = _e1636;
        phi_2160_ = array<u32, 8>(_e1631[0], _e1631[1], _e1631[2], _e1631[3], _e1631[4], _e1631[5], _e1643, _e1631[7]);
    } else {
        phi_2160_ = _e1631;
    }
    let _e1654 = phi_2160_;
    let _e1655 = (1792u + _e53);
    if ((_e78 + _e1655) < _e70) {
        let _e1659 = atomicLoad((&words[_e1655]));
        let _e1665 = atomicLoad((&digits[((_e1659 >> bitcast<u32>((_e67 & 31u))) & 255u)]));
        let _e1666 = (_e1665 + _e1655);
        keys_out.member[_e1666] = _e1659;
        phi_2178_ = array<u32, 8>(_e1654[0], _e1654[1], _e1654[2], _e1654[3], _e1654[4], _e1654[5], _e1654[6], _e1666);
    } else {
        phi_2178_ = _e1654;
    }
    let _e1677 = phi_2178_;
    workgroupBarrier();
    if ((_e78 + (((_e53 / 32u) * 256u) + (_e53 % 32u))) < _e70) {
        atomicStore((&words[_e1087[0]]), _e1424);
    }
    if ((_e78 + ((((_e53 / 32u) * 256u) + 32u) + (_e53 % 32u))) < _e70) {
        atomicStore((&words[_e1087[1]]), _e1435);
    }
    if ((_e78 + ((((_e53 / 32u) * 256u) + 64u) + (_e53 % 32u))) < _e70) {
        atomicStore((&words[_e1087[2]]), _e1446);
    }
    if ((_e78 + ((((_e53 / 32u) * 256u) + 96u) + (_e53 % 32u))) < _e70) {
        atomicStore((&words[_e1087[3]]), _e1457);
    }
    if ((_e78 + ((((_e53 / 32u) * 256u) + 128u) + (_e53 % 32u))) < _e70) {
        atomicStore((&words[_e1087[4]]), _e1468);
    }
    if ((_e78 + ((((_e53 / 32u) * 256u) + 160u) + (_e53 % 32u))) < _e70) {
        atomicStore((&words[_e1087[5]]), _e1479);
    }
    if ((_e78 + ((((_e53 / 32u) * 256u) + 192u) + (_e53 % 32u))) < _e70) {
        atomicStore((&words[_e1087[6]]), _e1490);
    }
    if ((_e78 + ((((_e53 / 32u) * 256u) + 224u) + (_e53 % 32u))) < _e70) {
        atomicStore((&words[_e1087[7]]), _e1501);
    }
    workgroupBarrier();
    if ((_e78 + _e53) < _e70) {
        let _e1753 = atomicLoad((&words[_e53]));
        values_out.member[_e1677[0]] = _e1753;
    }
    let _e1755 = (256u + _e53);
    if ((_e78 + _e1755) < _e70) {
        let _e1760 = atomicLoad((&words[_e1755]));
        values_out.member[_e1677[1]] = _e1760;
    }
    let _e1762 = (512u + _e53);
    if ((_e78 + _e1762) < _e70) {
        let _e1767 = atomicLoad((&words[_e1762]));
        values_out.member[_e1677[2]] = _e1767;
    }
    let _e1769 = (768u + _e53);
    if ((_e78 + _e1769) < _e70) {
        let _e1774 = atomicLoad((&words[_e1769]));
        values_out.member[_e1677[3]] = _e1774;
    }
    let _e1776 = (1024u + _e53);
    if ((_e78 + _e1776) < _e70) {
        let _e1781 = atomicLoad((&words[_e1776]));
        values_out.member[_e1677[4]] = _e1781;
    }
    let _e1783 = (1280u + _e53);
    if ((_e78 + _e1783) < _e70) {
        let _e1788 = atomicLoad((&words[_e1783]));
        values_out.member[_e1677[5]] = _e1788;
    }
    let _e1790 = (1536u + _e53);
    if ((_e78 + _e1790) < _e70) {
        let _e1795 = atomicLoad((&words[_e1790]));
        values_out.member[_e1677[6]] = _e1795;
    }
    let _e1797 = (1792u + _e53);
    if ((_e78 + _e1797) < _e70) {
        let _e1802 = atomicLoad((&words[_e1797]));
        values_out.member[_e1677[7]] = _e1802;
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn sort_scatter(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}

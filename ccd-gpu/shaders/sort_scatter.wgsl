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

@group(0) @binding(0) 
var<storage> params: type_11;
@group(0) @binding(1) 
var<storage> table: type_13;
@group(0) @binding(2) 
var<storage> keys: type_13;
@group(0) @binding(3) 
var<storage> values: type_13;
@group(0) @binding(4) 
var<storage, read_write> keys_out: type_13;
@group(0) @binding(5) 
var<storage, read_write> values_out: type_13;
var<workgroup> words: array<atomic<u32>, 2048>;
var<workgroup> counts: array<atomic<u32>, 1024>;
var<workgroup> starts: array<u32, 256>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_129_: u32;
    var phi_152_: u32;
    var phi_175_: u32;
    var phi_198_: u32;
    var phi_221_: u32;
    var phi_244_: u32;
    var phi_267_: u32;
    var phi_290_: u32;
    var phi_313_: u32;
    var phi_336_: u32;
    var phi_359_: u32;
    var phi_382_: u32;
    var phi_405_: u32;
    var phi_428_: u32;
    var phi_451_: u32;
    var phi_475_: u32;
    var phi_478_: type_9;
    var phi_515_: type_9;
    var phi_992_: type_9;
    var phi_995_: u32;
    var phi_996_: u32;
    var local: u32;
    var local_1: u32;
    var phi_1060_: array<u32, 2>;
    var phi_1061_: array<u32, 2>;
    var phi_1071_: type_9;
    var phi_1074_: u32;
    var phi_1076_: u32;
    var phi_1078_: u32;
    var phi_1075_: u32;
    var phi_1117_: u32;
    var phi_1077_: u32;
    var phi_1079_: u32;
    var local_2: u32;
    var phi_1125_: type_9;
    var phi_1128_: u32;
    var phi_1130_: u32;
    var phi_1132_: u32;
    var phi_1129_: u32;
    var phi_1171_: u32;
    var phi_1131_: u32;
    var phi_1133_: u32;
    var local_3: u32;
    var phi_1211_: array<u32, 2>;
    var phi_1229_: type_9;
    var phi_1232_: u32;
    var phi_1233_: u32;
    var phi_1298_: array<u32, 8>;
    var phi_1327_: array<u32, 8>;
    var phi_1356_: array<u32, 8>;
    var phi_1385_: array<u32, 8>;
    var phi_1414_: array<u32, 8>;
    var phi_1443_: array<u32, 8>;
    var phi_1472_: array<u32, 8>;
    var phi_1501_: array<u32, 8>;
    var phi_1520_: array<u32, 8>;
    var phi_1539_: array<u32, 8>;
    var phi_1558_: array<u32, 8>;
    var phi_1577_: array<u32, 8>;
    var phi_1596_: array<u32, 8>;
    var phi_1615_: array<u32, 8>;
    var phi_1634_: array<u32, 8>;
    var phi_1653_: array<u32, 8>;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e41 = id_2;
    let _e42 = n_2;
    let _e43 = lane_2;
    let _e54 = ((_e41.y * _e42.x) + _e41.x);
    let _e56 = ((_e43 / 32u) * 256u);
    let _e59 = params.member.member_2.member;
    let _e62 = params.member.member_1.member;
    let _e65 = params.member.member_2.member_1;
    let _e71 = ((_e54 * 2048u) + (((_e43 / 32u) * 256u) + (_e43 % 32u)));
    if (_e71 < _e62) {
        let _e74 = keys.member[_e71];
        phi_129_ = _e74;
    } else {
        phi_129_ = 0u;
    }
    let _e76 = phi_129_;
    let _e82 = ((_e54 * 2048u) + (((_e43 / 32u) * 256u) + (_e43 % 32u)));
    if (_e82 < _e62) {
        let _e85 = values.member[_e82];
        phi_152_ = _e85;
    } else {
        phi_152_ = 0u;
    }
    let _e87 = phi_152_;
    let _e94 = ((_e54 * 2048u) + ((((_e43 / 32u) * 256u) + 32u) + (_e43 % 32u)));
    if (_e94 < _e62) {
        let _e97 = keys.member[_e94];
        phi_175_ = _e97;
    } else {
        phi_175_ = 0u;
    }
    let _e99 = phi_175_;
    let _e106 = ((_e54 * 2048u) + ((((_e43 / 32u) * 256u) + 32u) + (_e43 % 32u)));
    if (_e106 < _e62) {
        let _e109 = values.member[_e106];
        phi_198_ = _e109;
    } else {
        phi_198_ = 0u;
    }
    let _e111 = phi_198_;
    let _e118 = ((_e54 * 2048u) + ((((_e43 / 32u) * 256u) + 64u) + (_e43 % 32u)));
    if (_e118 < _e62) {
        let _e121 = keys.member[_e118];
        phi_221_ = _e121;
    } else {
        phi_221_ = 0u;
    }
    let _e123 = phi_221_;
    let _e130 = ((_e54 * 2048u) + ((((_e43 / 32u) * 256u) + 64u) + (_e43 % 32u)));
    if (_e130 < _e62) {
        let _e133 = values.member[_e130];
        phi_244_ = _e133;
    } else {
        phi_244_ = 0u;
    }
    let _e135 = phi_244_;
    let _e142 = ((_e54 * 2048u) + ((((_e43 / 32u) * 256u) + 96u) + (_e43 % 32u)));
    if (_e142 < _e62) {
        let _e145 = keys.member[_e142];
        phi_267_ = _e145;
    } else {
        phi_267_ = 0u;
    }
    let _e147 = phi_267_;
    let _e154 = ((_e54 * 2048u) + ((((_e43 / 32u) * 256u) + 96u) + (_e43 % 32u)));
    if (_e154 < _e62) {
        let _e157 = values.member[_e154];
        phi_290_ = _e157;
    } else {
        phi_290_ = 0u;
    }
    let _e159 = phi_290_;
    let _e166 = ((_e54 * 2048u) + ((((_e43 / 32u) * 256u) + 128u) + (_e43 % 32u)));
    if (_e166 < _e62) {
        let _e169 = keys.member[_e166];
        phi_313_ = _e169;
    } else {
        phi_313_ = 0u;
    }
    let _e171 = phi_313_;
    let _e178 = ((_e54 * 2048u) + ((((_e43 / 32u) * 256u) + 128u) + (_e43 % 32u)));
    if (_e178 < _e62) {
        let _e181 = values.member[_e178];
        phi_336_ = _e181;
    } else {
        phi_336_ = 0u;
    }
    let _e183 = phi_336_;
    let _e190 = ((_e54 * 2048u) + ((((_e43 / 32u) * 256u) + 160u) + (_e43 % 32u)));
    if (_e190 < _e62) {
        let _e193 = keys.member[_e190];
        phi_359_ = _e193;
    } else {
        phi_359_ = 0u;
    }
    let _e195 = phi_359_;
    let _e202 = ((_e54 * 2048u) + ((((_e43 / 32u) * 256u) + 160u) + (_e43 % 32u)));
    if (_e202 < _e62) {
        let _e205 = values.member[_e202];
        phi_382_ = _e205;
    } else {
        phi_382_ = 0u;
    }
    let _e207 = phi_382_;
    let _e214 = ((_e54 * 2048u) + ((((_e43 / 32u) * 256u) + 192u) + (_e43 % 32u)));
    if (_e214 < _e62) {
        let _e217 = keys.member[_e214];
        phi_405_ = _e217;
    } else {
        phi_405_ = 0u;
    }
    let _e219 = phi_405_;
    let _e226 = ((_e54 * 2048u) + ((((_e43 / 32u) * 256u) + 192u) + (_e43 % 32u)));
    if (_e226 < _e62) {
        let _e229 = values.member[_e226];
        phi_428_ = _e229;
    } else {
        phi_428_ = 0u;
    }
    let _e231 = phi_428_;
    let _e238 = ((_e54 * 2048u) + ((((_e43 / 32u) * 256u) + 224u) + (_e43 % 32u)));
    if (_e238 < _e62) {
        let _e241 = keys.member[_e238];
        phi_451_ = _e241;
    } else {
        phi_451_ = 0u;
    }
    let _e243 = phi_451_;
    let _e251 = ((_e54 * 2048u) + ((((_e43 / 32u) * 256u) + 224u) + (_e43 % 32u)));
    if (_e251 < _e62) {
        let _e254 = values.member[_e251];
        phi_475_ = _e254;
    } else {
        phi_475_ = 0u;
    }
    let _e256 = phi_475_;
    phi_478_ = type_9(0u, 8u);
    loop {
        let _e258 = phi_478_;
        let _e261 = (_e258.member < _e258.member_1);
        let _e274 = (bitcast<i32>(select(0u, 1u, _e261)) != 0i);
        if _e274 {
            atomicStore((&words[((select(type_9().member_1, _e258.member, _e261) * 256u) + _e43)]), 0u);
        }
        continue;
        continuing {
            phi_478_ = type_9(select(_e258.member, (_e258.member + 1u), _e261), select(_e258.member_1, _e258.member_1, _e261));
            break if !(_e274);
        }
    }
    phi_515_ = type_9(0u, 4u);
    loop {
        let _e280 = phi_515_;
        let _e283 = (_e280.member < _e280.member_1);
        let _e296 = (bitcast<i32>(select(0u, 1u, _e283)) != 0i);
        if _e296 {
            atomicStore((&counts[((select(type_9().member_1, _e280.member, _e283) * 256u) + _e43)]), 0u);
        }
        continue;
        continuing {
            phi_515_ = type_9(select(_e280.member, (_e280.member + 1u), _e283), select(_e280.member_1, _e280.member_1, _e283));
            break if !(_e296);
        }
    }
    workgroupBarrier();
    let _e307 = (((_e54 * 2048u) + (((_e43 / 32u) * 256u) + (_e43 % 32u))) < _e62);
    let _e312 = (_e56 + ((_e76 >> bitcast<u32>((_e59 & 31u))) & 255u));
    if _e307 {
        let _e318 = atomicOr((&words[_e312]), (1u << bitcast<u32>(((_e43 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e320 = atomicLoad((&words[_e312]));
    let _e327 = countOneBits((_e320 & ((1u << bitcast<u32>(((_e43 % 32u) & 31u))) - 1u)));
    let _e330 = atomicLoad((&counts[(_e312 / 2u)]));
    let _e337 = (((_e330 >> bitcast<u32>(((16u * (_e312 % 2u)) & 31u))) & 65535u) + _e327);
    workgroupBarrier();
    if _e307 {
        if (_e327 == 0u) {
            let _e347 = atomicAdd((&counts[(_e312 / 2u)]), (countOneBits(_e320) << bitcast<u32>(((16u * (_e312 % 2u)) & 31u))));
            atomicStore((&words[_e312]), 0u);
        }
    }
    workgroupBarrier();
    let _e356 = (((_e54 * 2048u) + ((((_e43 / 32u) * 256u) + 32u) + (_e43 % 32u))) < _e62);
    let _e361 = (_e56 + ((_e99 >> bitcast<u32>((_e59 & 31u))) & 255u));
    if _e356 {
        let _e367 = atomicOr((&words[_e361]), (1u << bitcast<u32>(((_e43 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e369 = atomicLoad((&words[_e361]));
    let _e376 = countOneBits((_e369 & ((1u << bitcast<u32>(((_e43 % 32u) & 31u))) - 1u)));
    let _e379 = atomicLoad((&counts[(_e361 / 2u)]));
    let _e386 = (((_e379 >> bitcast<u32>(((16u * (_e361 % 2u)) & 31u))) & 65535u) + _e376);
    workgroupBarrier();
    if _e356 {
        if (_e376 == 0u) {
            let _e396 = atomicAdd((&counts[(_e361 / 2u)]), (countOneBits(_e369) << bitcast<u32>(((16u * (_e361 % 2u)) & 31u))));
            atomicStore((&words[_e361]), 0u);
        }
    }
    workgroupBarrier();
    let _e405 = (((_e54 * 2048u) + ((((_e43 / 32u) * 256u) + 64u) + (_e43 % 32u))) < _e62);
    let _e410 = (_e56 + ((_e123 >> bitcast<u32>((_e59 & 31u))) & 255u));
    if _e405 {
        let _e416 = atomicOr((&words[_e410]), (1u << bitcast<u32>(((_e43 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e418 = atomicLoad((&words[_e410]));
    let _e425 = countOneBits((_e418 & ((1u << bitcast<u32>(((_e43 % 32u) & 31u))) - 1u)));
    let _e428 = atomicLoad((&counts[(_e410 / 2u)]));
    let _e435 = (((_e428 >> bitcast<u32>(((16u * (_e410 % 2u)) & 31u))) & 65535u) + _e425);
    workgroupBarrier();
    if _e405 {
        if (_e425 == 0u) {
            let _e445 = atomicAdd((&counts[(_e410 / 2u)]), (countOneBits(_e418) << bitcast<u32>(((16u * (_e410 % 2u)) & 31u))));
            atomicStore((&words[_e410]), 0u);
        }
    }
    workgroupBarrier();
    let _e454 = (((_e54 * 2048u) + ((((_e43 / 32u) * 256u) + 96u) + (_e43 % 32u))) < _e62);
    let _e459 = (_e56 + ((_e147 >> bitcast<u32>((_e59 & 31u))) & 255u));
    if _e454 {
        let _e465 = atomicOr((&words[_e459]), (1u << bitcast<u32>(((_e43 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e467 = atomicLoad((&words[_e459]));
    let _e474 = countOneBits((_e467 & ((1u << bitcast<u32>(((_e43 % 32u) & 31u))) - 1u)));
    let _e477 = atomicLoad((&counts[(_e459 / 2u)]));
    let _e484 = (((_e477 >> bitcast<u32>(((16u * (_e459 % 2u)) & 31u))) & 65535u) + _e474);
    workgroupBarrier();
    if _e454 {
        if (_e474 == 0u) {
            let _e494 = atomicAdd((&counts[(_e459 / 2u)]), (countOneBits(_e467) << bitcast<u32>(((16u * (_e459 % 2u)) & 31u))));
            atomicStore((&words[_e459]), 0u);
        }
    }
    workgroupBarrier();
    let _e503 = (((_e54 * 2048u) + ((((_e43 / 32u) * 256u) + 128u) + (_e43 % 32u))) < _e62);
    let _e508 = (_e56 + ((_e171 >> bitcast<u32>((_e59 & 31u))) & 255u));
    if _e503 {
        let _e514 = atomicOr((&words[_e508]), (1u << bitcast<u32>(((_e43 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e516 = atomicLoad((&words[_e508]));
    let _e523 = countOneBits((_e516 & ((1u << bitcast<u32>(((_e43 % 32u) & 31u))) - 1u)));
    let _e526 = atomicLoad((&counts[(_e508 / 2u)]));
    let _e533 = (((_e526 >> bitcast<u32>(((16u * (_e508 % 2u)) & 31u))) & 65535u) + _e523);
    workgroupBarrier();
    if _e503 {
        if (_e523 == 0u) {
            let _e543 = atomicAdd((&counts[(_e508 / 2u)]), (countOneBits(_e516) << bitcast<u32>(((16u * (_e508 % 2u)) & 31u))));
            atomicStore((&words[_e508]), 0u);
        }
    }
    workgroupBarrier();
    let _e552 = (((_e54 * 2048u) + ((((_e43 / 32u) * 256u) + 160u) + (_e43 % 32u))) < _e62);
    let _e557 = (_e56 + ((_e195 >> bitcast<u32>((_e59 & 31u))) & 255u));
    if _e552 {
        let _e563 = atomicOr((&words[_e557]), (1u << bitcast<u32>(((_e43 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e565 = atomicLoad((&words[_e557]));
    let _e572 = countOneBits((_e565 & ((1u << bitcast<u32>(((_e43 % 32u) & 31u))) - 1u)));
    let _e575 = atomicLoad((&counts[(_e557 / 2u)]));
    let _e582 = (((_e575 >> bitcast<u32>(((16u * (_e557 % 2u)) & 31u))) & 65535u) + _e572);
    workgroupBarrier();
    if _e552 {
        if (_e572 == 0u) {
            let _e592 = atomicAdd((&counts[(_e557 / 2u)]), (countOneBits(_e565) << bitcast<u32>(((16u * (_e557 % 2u)) & 31u))));
            atomicStore((&words[_e557]), 0u);
        }
    }
    workgroupBarrier();
    let _e601 = (((_e54 * 2048u) + ((((_e43 / 32u) * 256u) + 192u) + (_e43 % 32u))) < _e62);
    let _e606 = (_e56 + ((_e219 >> bitcast<u32>((_e59 & 31u))) & 255u));
    if _e601 {
        let _e612 = atomicOr((&words[_e606]), (1u << bitcast<u32>(((_e43 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e614 = atomicLoad((&words[_e606]));
    let _e621 = countOneBits((_e614 & ((1u << bitcast<u32>(((_e43 % 32u) & 31u))) - 1u)));
    let _e624 = atomicLoad((&counts[(_e606 / 2u)]));
    let _e631 = (((_e624 >> bitcast<u32>(((16u * (_e606 % 2u)) & 31u))) & 65535u) + _e621);
    workgroupBarrier();
    if _e601 {
        if (_e621 == 0u) {
            let _e641 = atomicAdd((&counts[(_e606 / 2u)]), (countOneBits(_e614) << bitcast<u32>(((16u * (_e606 % 2u)) & 31u))));
            atomicStore((&words[_e606]), 0u);
        }
    }
    workgroupBarrier();
    let _e650 = (((_e54 * 2048u) + ((((_e43 / 32u) * 256u) + 224u) + (_e43 % 32u))) < _e62);
    let _e655 = (_e56 + ((_e243 >> bitcast<u32>((_e59 & 31u))) & 255u));
    if _e650 {
        let _e661 = atomicOr((&words[_e655]), (1u << bitcast<u32>(((_e43 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e663 = atomicLoad((&words[_e655]));
    let _e670 = countOneBits((_e663 & ((1u << bitcast<u32>(((_e43 % 32u) & 31u))) - 1u)));
    let _e673 = atomicLoad((&counts[(_e655 / 2u)]));
    let _e680 = (((_e673 >> bitcast<u32>(((16u * (_e655 % 2u)) & 31u))) & 65535u) + _e670);
    workgroupBarrier();
    if _e650 {
        if (_e670 == 0u) {
            let _e691 = atomicAdd((&counts[(_e655 / 2u)]), (countOneBits(_e663) << bitcast<u32>(((16u * (_e655 % 2u)) & 31u))));
            atomicStore((&words[_e655]), 0u);
        }
    }
    workgroupBarrier();
    let _e693 = (2u * _e43);
    if (_e43 < 128u) {
        phi_992_ = type_9(0u, 8u);
        phi_995_ = 0u;
        loop {
            let _e696 = phi_992_;
            let _e698 = phi_995_;
            local = _e698;
            local_1 = _e698;
            let _e701 = (_e696.member < _e696.member_1);
            let _e714 = (bitcast<i32>(select(0u, 1u, _e701)) != 0i);
            if _e714 {
                let _e718 = atomicLoad((&counts[((select(type_9().member_1, _e696.member, _e701) * 128u) + _e43)]));
                phi_996_ = (_e698 + _e718);
            } else {
                phi_996_ = u32();
            }
            let _e721 = phi_996_;
            continue;
            continuing {
                phi_992_ = type_9(select(_e696.member, (_e696.member + 1u), _e701), select(_e696.member_1, _e696.member_1, _e701));
                phi_995_ = _e721;
                break if !(_e714);
            }
        }
        let _e724 = local;
        let _e727 = local_1;
        let _e734 = table.member[((256u * _e65) + _e693)];
        let _e739 = table.member[(((256u * _e65) + _e693) + 1u)];
        phi_1060_ = array<u32, 2>(_e734, _e739);
        phi_1061_ = array<u32, 2>((_e724 & 65535u), (_e727 >> bitcast<u32>(16i)));
    } else {
        phi_1060_ = array<u32, 2>(0u, 0u);
        phi_1061_ = array<u32, 2>(0u, 0u);
    }
    let _e742 = phi_1060_;
    let _e744 = phi_1061_;
    let _e747 = (_e744[0] + _e744[1]);
    let _e750 = (_e742[0] + _e742[1]);
    atomicStore((&words[_e43]), _e747);
    phi_1071_ = type_9(0u, 8u);
    phi_1074_ = 0u;
    phi_1076_ = 1u;
    phi_1078_ = _e747;
    phi_1075_ = 256u;
    loop {
        let _e753 = phi_1071_;
        let _e755 = phi_1074_;
        let _e757 = phi_1076_;
        let _e759 = phi_1078_;
        let _e761 = phi_1075_;
        local_2 = _e759;
        let _e764 = (_e753.member < _e753.member_1);
        let _e775 = (bitcast<i32>(select(0u, 1u, _e764)) != 0i);
        if _e775 {
            workgroupBarrier();
            if (_e43 >= _e757) {
                let _e780 = atomicLoad((&words[((_e755 + _e43) - _e757)]));
                phi_1117_ = (_e759 + _e780);
            } else {
                phi_1117_ = _e759;
            }
            let _e783 = phi_1117_;
            atomicStore((&words[(_e761 + _e43)]), _e783);
            phi_1077_ = (_e757 * 2u);
            phi_1079_ = _e783;
        } else {
            phi_1077_ = u32();
            phi_1079_ = u32();
        }
        let _e788 = phi_1077_;
        let _e790 = phi_1079_;
        continue;
        continuing {
            phi_1071_ = type_9(select(_e753.member, (_e753.member + 1u), _e764), select(_e753.member_1, _e753.member_1, _e764));
            phi_1074_ = _e761;
            phi_1076_ = _e788;
            phi_1078_ = _e790;
            phi_1075_ = _e755;
            break if !(_e775);
        }
    }
    workgroupBarrier();
    let _e793 = local_2;
    let _e794 = (_e793 - _e747);
    atomicStore((&words[_e43]), _e750);
    phi_1125_ = type_9(0u, 8u);
    phi_1128_ = 0u;
    phi_1130_ = 1u;
    phi_1132_ = _e750;
    phi_1129_ = 256u;
    loop {
        let _e797 = phi_1125_;
        let _e799 = phi_1128_;
        let _e801 = phi_1130_;
        let _e803 = phi_1132_;
        let _e805 = phi_1129_;
        local_3 = _e803;
        let _e808 = (_e797.member < _e797.member_1);
        let _e819 = (bitcast<i32>(select(0u, 1u, _e808)) != 0i);
        if _e819 {
            workgroupBarrier();
            if (_e43 >= _e801) {
                let _e824 = atomicLoad((&words[((_e799 + _e43) - _e801)]));
                phi_1171_ = (_e803 + _e824);
            } else {
                phi_1171_ = _e803;
            }
            let _e827 = phi_1171_;
            atomicStore((&words[(_e805 + _e43)]), _e827);
            phi_1131_ = (_e801 * 2u);
            phi_1133_ = _e827;
        } else {
            phi_1131_ = u32();
            phi_1133_ = u32();
        }
        let _e832 = phi_1131_;
        let _e834 = phi_1133_;
        continue;
        continuing {
            phi_1125_ = type_9(select(_e797.member, (_e797.member + 1u), _e808), select(_e797.member_1, _e797.member_1, _e808));
            phi_1128_ = _e805;
            phi_1130_ = _e832;
            phi_1132_ = _e834;
            phi_1129_ = _e799;
            break if !(_e819);
        }
    }
    workgroupBarrier();
    let _e837 = local_3;
    let _e838 = (_e837 - _e750);
    if (_e43 < 128u) {
        if (_e54 < _e65) {
            let _e844 = table.member[((_e693 * _e65) + _e54)];
            let _e849 = table.member[(((_e693 + 1u) * _e65) + _e54)];
            phi_1211_ = array<u32, 2>(_e844, _e849);
        } else {
            phi_1211_ = array<u32, 2>(0u, 0u);
        }
        let _e852 = phi_1211_;
        let _e854 = (_e794 + _e744[0]);
        starts[_e693] = ((_e838 + _e852[0]) - _e794);
        starts[(_e693 + 1u)] = (((_e838 + _e742[0]) + _e852[1]) - _e854);
        phi_1229_ = type_9(0u, 8u);
        phi_1232_ = (_e794 | (_e854 << bitcast<u32>(16i)));
        loop {
            let _e870 = phi_1229_;
            let _e872 = phi_1232_;
            let _e875 = (_e870.member < _e870.member_1);
            let _e886 = select(type_9().member_1, _e870.member, _e875);
            let _e888 = (bitcast<i32>(select(0u, 1u, _e875)) != 0i);
            if _e888 {
                let _e892 = atomicLoad((&counts[((_e886 * 128u) + _e43)]));
                atomicStore((&counts[((_e886 * 128u) + _e43)]), _e872);
                phi_1233_ = (_e872 + _e892);
            } else {
                phi_1233_ = u32();
            }
            let _e898 = phi_1233_;
            continue;
            continuing {
                phi_1229_ = type_9(select(_e870.member, (_e870.member + 1u), _e875), select(_e870.member_1, _e870.member_1, _e875));
                phi_1232_ = _e898;
                break if !(_e888);
            }
        }
    }
    workgroupBarrier();
    if (((_e54 * 2048u) + (((_e43 / 32u) * 256u) + (_e43 % 32u))) < _e62) {
        let _e911 = (_e56 + ((_e76 >> bitcast<u32>((_e59 & 31u))) & 255u));
        let _e914 = atomicLoad((&counts[(_e911 / 2u)]));
        let _e921 = (_e337 + ((_e914 >> bitcast<u32>(((16u * (_e911 % 2u)) & 31u))) & 65535u));
        atomicStore((&words[_e921]), _e76);
        phi_1298_ = array<u32, 8>(_e921, _e386, _e435, _e484, _e533, _e582, _e631, _e680);
    } else {
        phi_1298_ = array<u32, 8>(_e337, _e386, _e435, _e484, _e533, _e582, _e631, _e680);
    }
    let _e925 = phi_1298_;
    if (((_e54 * 2048u) + ((((_e43 / 32u) * 256u) + 32u) + (_e43 % 32u))) < _e62) {
        let _e938 = (_e56 + ((_e99 >> bitcast<u32>((_e59 & 31u))) & 255u));
        let _e941 = atomicLoad((&counts[(_e938 / 2u)]));
        let _e949 = (_e925[1] + ((_e941 >> bitcast<u32>(((16u * (_e938 % 2u)) & 31u))) & 65535u));
        atomicStore((&words[_e949]), _e99);
        phi_1327_ = array<u32, 8>(_e925[0], _e949, _e925[2], _e925[3], _e925[4], _e925[5], _e925[6], _e925[7]);
    } else {
        phi_1327_ = _e925;
    }
    let _e960 = phi_1327_;
    if (((_e54 * 2048u) + ((((_e43 / 32u) * 256u) + 64u) + (_e43 % 32u))) < _e62) {
        let _e973 = (_e56 + ((_e123 >> bitcast<u32>((_e59 & 31u))) & 255u));
        let _e976 = atomicLoad((&counts[(_e973 / 2u)]));
        let _e984 = (_e960[2] + ((_e976 >> bitcast<u32>(((16u * (_e973 % 2u)) & 31u))) & 65535u));
        atomicStore((&words[_e984]), _e123);
        phi_1356_ = array<u32, 8>(_e960[0], _e960[1], _e984, _e960[3], _e960[4], _e960[5], _e960[6], _e960[7]);
    } else {
        phi_1356_ = _e960;
    }
    let _e995 = phi_1356_;
    if (((_e54 * 2048u) + ((((_e43 / 32u) * 256u) + 96u) + (_e43 % 32u))) < _e62) {
        let _e1008 = (_e56 + ((_e147 >> bitcast<u32>((_e59 & 31u))) & 255u));
        let _e1011 = atomicLoad((&counts[(_e1008 / 2u)]));
        let _e1019 = (_e995[3] + ((_e1011 >> bitcast<u32>(((16u * (_e1008 % 2u)) & 31u))) & 65535u));
        atomicStore((&words[_e1019]), _e147);
        phi_1385_ = array<u32, 8>(_e995[0], _e995[1], _e995[2], _e1019, _e995[4], _e995[5], _e995[6], _e995[7]);
    } else {
        phi_1385_ = _e995;
    }
    let _e1030 = phi_1385_;
    if (((_e54 * 2048u) + ((((_e43 / 32u) * 256u) + 128u) + (_e43 % 32u))) < _e62) {
        let _e1043 = (_e56 + ((_e171 >> bitcast<u32>((_e59 & 31u))) & 255u));
        let _e1046 = atomicLoad((&counts[(_e1043 / 2u)]));
        let _e1054 = (_e1030[4] + ((_e1046 >> bitcast<u32>(((16u * (_e1043 % 2u)) & 31u))) & 65535u));
        atomicStore((&words[_e1054]), _e171);
        phi_1414_ = array<u32, 8>(_e1030[0], _e1030[1], _e1030[2], _e1030[3], _e1054, _e1030[5], _e1030[6], _e1030[7]);
    } else {
        phi_1414_ = _e1030;
    }
    let _e1065 = phi_1414_;
    if (((_e54 * 2048u) + ((((_e43 / 32u) * 256u) + 160u) + (_e43 % 32u))) < _e62) {
        let _e1078 = (_e56 + ((_e195 >> bitcast<u32>((_e59 & 31u))) & 255u));
        let _e1081 = atomicLoad((&counts[(_e1078 / 2u)]));
        let _e1089 = (_e1065[5] + ((_e1081 >> bitcast<u32>(((16u * (_e1078 % 2u)) & 31u))) & 65535u));
        atomicStore((&words[_e1089]), _e195);
        phi_1443_ = array<u32, 8>(_e1065[0], _e1065[1], _e1065[2], _e1065[3], _e1065[4], _e1089, _e1065[6], _e1065[7]);
    } else {
        phi_1443_ = _e1065;
    }
    let _e1100 = phi_1443_;
    if (((_e54 * 2048u) + ((((_e43 / 32u) * 256u) + 192u) + (_e43 % 32u))) < _e62) {
        let _e1113 = (_e56 + ((_e219 >> bitcast<u32>((_e59 & 31u))) & 255u));
        let _e1116 = atomicLoad((&counts[(_e1113 / 2u)]));
        let _e1124 = (_e1100[6] + ((_e1116 >> bitcast<u32>(((16u * (_e1113 % 2u)) & 31u))) & 65535u));
        atomicStore((&words[_e1124]), _e219);
        phi_1472_ = array<u32, 8>(_e1100[0], _e1100[1], _e1100[2], _e1100[3], _e1100[4], _e1100[5], _e1124, _e1100[7]);
    } else {
        phi_1472_ = _e1100;
    }
    let _e1135 = phi_1472_;
    if (((_e54 * 2048u) + ((((_e43 / 32u) * 256u) + 224u) + (_e43 % 32u))) < _e62) {
        let _e1148 = (_e56 + ((_e243 >> bitcast<u32>((_e59 & 31u))) & 255u));
        let _e1151 = atomicLoad((&counts[(_e1148 / 2u)]));
        let _e1159 = (_e1135[7] + ((_e1151 >> bitcast<u32>(((16u * (_e1148 % 2u)) & 31u))) & 65535u));
        atomicStore((&words[_e1159]), _e243);
        phi_1501_ = array<u32, 8>(_e1135[0], _e1135[1], _e1135[2], _e1135[3], _e1135[4], _e1135[5], _e1135[6], _e1159);
    } else {
        phi_1501_ = _e1135;
    }
    let _e1170 = phi_1501_;
    workgroupBarrier();
    if (((_e54 * 2048u) + _e43) < _e62) {
        let _e1175 = atomicLoad((&words[_e43]));
        let _e1181 = starts[((_e1175 >> bitcast<u32>((_e59 & 31u))) & 255u)];
        let _e1182 = (_e1181 + _e43);
        keys_out.member[_e1182] = _e1175;
        phi_1520_ = array<u32, 8>(_e1182, _e99, _e123, _e147, _e171, _e195, _e219, _e243);
    } else {
        phi_1520_ = array<u32, 8>(_e76, _e99, _e123, _e147, _e171, _e195, _e219, _e243);
    }
    let _e1186 = phi_1520_;
    let _e1187 = (256u + _e43);
    if (((_e54 * 2048u) + _e1187) < _e62) {
        let _e1192 = atomicLoad((&words[_e1187]));
        let _e1198 = starts[((_e1192 >> bitcast<u32>((_e59 & 31u))) & 255u)];
        let _e1199 = (_e1198 + _e1187);
        keys_out.member[_e1199] = _e1192;
        phi_1539_ = array<u32, 8>(_e1186[0], _e1199, _e1186[2], _e1186[3], _e1186[4], _e1186[5], _e1186[6], _e1186[7]);
    } else {
        phi_1539_ = _e1186;
    }
    let _e1210 = phi_1539_;
    let _e1211 = (512u + _e43);
    if (((_e54 * 2048u) + _e1211) < _e62) {
        let _e1216 = atomicLoad((&words[_e1211]));
        let _e1222 = starts[((_e1216 >> bitcast<u32>((_e59 & 31u))) & 255u)];
        let _e1223 = (_e1222 + _e1211);
        keys_out.member[_e1223] = _e1216;
        phi_1558_ = array<u32, 8>(_e1210[0], _e1210[1], _e1223, _e1210[3], _e1210[4], _e1210[5], _e1210[6], _e1210[7]);
    } else {
        phi_1558_ = _e1210;
    }
    let _e1234 = phi_1558_;
    let _e1235 = (768u + _e43);
    if (((_e54 * 2048u) + _e1235) < _e62) {
        let _e1240 = atomicLoad((&words[_e1235]));
        let _e1246 = starts[((_e1240 >> bitcast<u32>((_e59 & 31u))) & 255u)];
        let _e1247 = (_e1246 + _e1235);
        keys_out.member[_e1247] = _e1240;
        phi_1577_ = array<u32, 8>(_e1234[0], _e1234[1], _e1234[2], _e1247, _e1234[4], _e1234[5], _e1234[6], _e1234[7]);
    } else {
        phi_1577_ = _e1234;
    }
    let _e1258 = phi_1577_;
    let _e1259 = (1024u + _e43);
    if (((_e54 * 2048u) + _e1259) < _e62) {
        let _e1264 = atomicLoad((&words[_e1259]));
        let _e1270 = starts[((_e1264 >> bitcast<u32>((_e59 & 31u))) & 255u)];
        let _e1271 = (_e1270 + _e1259);
        keys_out.member[_e1271] = _e1264;
        phi_1596_ = array<u32, 8>(_e1258[0], _e1258[1], _e1258[2], _e1258[3], _e1271, _e1258[5], _e1258[6], _e1258[7]);
    } else {
        phi_1596_ = _e1258;
    }
    let _e1282 = phi_1596_;
    let _e1283 = (1280u + _e43);
    if (((_e54 * 2048u) + _e1283) < _e62) {
        let _e1288 = atomicLoad((&words[_e1283]));
        let _e1294 = starts[((_e1288 >> bitcast<u32>((_e59 & 31u))) & 255u)];
        let _e1295 = (_e1294 + _e1283);
        keys_out.member[_e1295] = _e1288;
        phi_1615_ = array<u32, 8>(_e1282[0], _e1282[1], _e1282[2], _e1282[3], _e1282[4], _e1295, _e1282[6], _e1282[7]);
    } else {
        phi_1615_ = _e1282;
    }
    let _e1306 = phi_1615_;
    let _e1307 = (1536u + _e43);
    if (((_e54 * 2048u) + _e1307) < _e62) {
        let _e1312 = atomicLoad((&words[_e1307]));
        let _e1318 = starts[((_e1312 >> bitcast<u32>((_e59 & 31u))) & 255u)];
        let _e1319 = (_e1318 + _e1307);
        keys_out.member[_e1319] = _e1312;
        phi_1634_ = array<u32, 8>(_e1306[0], _e1306[1], _e1306[2], _e1306[3], _e1306[4], _e1306[5], _e1319, _e1306[7]);
    } else {
        phi_1634_ = _e1306;
    }
    let _e1330 = phi_1634_;
    let _e1331 = (1792u + _e43);
    if (((_e54 * 2048u) + _e1331) < _e62) {
        let _e1336 = atomicLoad((&words[_e1331]));
        let _e1342 = starts[((_e1336 >> bitcast<u32>((_e59 & 31u))) & 255u)];
        let _e1343 = (_e1342 + _e1331);
        keys_out.member[_e1343] = _e1336;
        phi_1653_ = array<u32, 8>(_e1330[0], _e1330[1], _e1330[2], _e1330[3], _e1330[4], _e1330[5], _e1330[6], _e1343);
    } else {
        phi_1653_ = _e1330;
    }
    let _e1354 = phi_1653_;
    workgroupBarrier();
    if (((_e54 * 2048u) + (((_e43 / 32u) * 256u) + (_e43 % 32u))) < _e62) {
        atomicStore((&words[_e1170[0]]), _e87);
    }
    if (((_e54 * 2048u) + ((((_e43 / 32u) * 256u) + 32u) + (_e43 % 32u))) < _e62) {
        atomicStore((&words[_e1170[1]]), _e111);
    }
    if (((_e54 * 2048u) + ((((_e43 / 32u) * 256u) + 64u) + (_e43 % 32u))) < _e62) {
        atomicStore((&words[_e1170[2]]), _e135);
    }
    if (((_e54 * 2048u) + ((((_e43 / 32u) * 256u) + 96u) + (_e43 % 32u))) < _e62) {
        atomicStore((&words[_e1170[3]]), _e159);
    }
    if (((_e54 * 2048u) + ((((_e43 / 32u) * 256u) + 128u) + (_e43 % 32u))) < _e62) {
        atomicStore((&words[_e1170[4]]), _e183);
    }
    if (((_e54 * 2048u) + ((((_e43 / 32u) * 256u) + 160u) + (_e43 % 32u))) < _e62) {
        atomicStore((&words[_e1170[5]]), _e207);
    }
    if (((_e54 * 2048u) + ((((_e43 / 32u) * 256u) + 192u) + (_e43 % 32u))) < _e62) {
        atomicStore((&words[_e1170[6]]), _e231);
    }
    if (((_e54 * 2048u) + ((((_e43 / 32u) * 256u) + 224u) + (_e43 % 32u))) < _e62) {
        atomicStore((&words[_e1170[7]]), _e256);
    }
    workgroupBarrier();
    if (((_e54 * 2048u) + _e43) < _e62) {
        let _e1439 = atomicLoad((&words[_e43]));
        values_out.member[_e1354[0]] = _e1439;
    }
    let _e1441 = (256u + _e43);
    if (((_e54 * 2048u) + _e1441) < _e62) {
        let _e1447 = atomicLoad((&words[_e1441]));
        values_out.member[_e1354[1]] = _e1447;
    }
    let _e1449 = (512u + _e43);
    if (((_e54 * 2048u) + _e1449) < _e62) {
        let _e1455 = atomicLoad((&words[_e1449]));
        values_out.member[_e1354[2]] = _e1455;
    }
    let _e1457 = (768u + _e43);
    if (((_e54 * 2048u) + _e1457) < _e62) {
        let _e1463 = atomicLoad((&words[_e1457]));
        values_out.member[_e1354[3]] = _e1463;
    }
    let _e1465 = (1024u + _e43);
    if (((_e54 * 2048u) + _e1465) < _e62) {
        let _e1471 = atomicLoad((&words[_e1465]));
        values_out.member[_e1354[4]] = _e1471;
    }
    let _e1473 = (1280u + _e43);
    if (((_e54 * 2048u) + _e1473) < _e62) {
        let _e1479 = atomicLoad((&words[_e1473]));
        values_out.member[_e1354[5]] = _e1479;
    }
    let _e1481 = (1536u + _e43);
    if (((_e54 * 2048u) + _e1481) < _e62) {
        let _e1487 = atomicLoad((&words[_e1481]));
        values_out.member[_e1354[6]] = _e1487;
    }
    let _e1489 = (1792u + _e43);
    if (((_e54 * 2048u) + _e1489) < _e62) {
        let _e1495 = atomicLoad((&words[_e1489]));
        values_out.member[_e1354[7]] = _e1495;
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn sort_scatter(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}

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
    var phi_141_: u32;
    var phi_164_: u32;
    var phi_187_: u32;
    var phi_210_: u32;
    var phi_233_: u32;
    var phi_256_: u32;
    var phi_279_: u32;
    var phi_302_: u32;
    var phi_325_: u32;
    var phi_348_: u32;
    var phi_371_: u32;
    var phi_394_: u32;
    var phi_417_: u32;
    var phi_440_: u32;
    var phi_463_: u32;
    var phi_486_: u32;
    var phi_509_: u32;
    var phi_532_: u32;
    var phi_555_: u32;
    var phi_578_: u32;
    var phi_601_: u32;
    var phi_624_: u32;
    var phi_647_: u32;
    var phi_670_: u32;
    var phi_693_: u32;
    var phi_716_: u32;
    var phi_739_: u32;
    var phi_762_: u32;
    var phi_785_: u32;
    var phi_808_: u32;
    var phi_832_: u32;
    var phi_855_: u32;
    var phi_858_: type_9;
    var phi_1647_: type_9;
    var phi_1650_: u32;
    var phi_1652_: u32;
    var phi_1687_: type_9;
    var phi_1690_: u32;
    var phi_1691_: u32;
    var phi_1651_: u32;
    var phi_1653_: u32;
    var local: u32;
    var phi_1742_: type_9;
    var phi_1745_: u32;
    var phi_1747_: u32;
    var phi_1749_: u32;
    var phi_1746_: u32;
    var phi_1788_: u32;
    var phi_1748_: u32;
    var phi_1750_: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_1796_: type_9;
    var phi_1799_: u32;
    var phi_1801_: u32;
    var phi_1803_: u32;
    var phi_1800_: u32;
    var phi_1842_: u32;
    var phi_1802_: u32;
    var phi_1804_: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1849_: type_9;
    var phi_1852_: u32;
    var phi_1854_: u32;
    var phi_1903_: u32;
    var phi_1922_: type_9;
    var phi_1925_: u32;
    var phi_1926_: u32;
    var phi_1853_: u32;
    var phi_1855_: u32;
    var phi_1985_: array<u32, 16>;
    var phi_2008_: array<u32, 16>;
    var phi_2031_: array<u32, 16>;
    var phi_2054_: array<u32, 16>;
    var phi_2077_: array<u32, 16>;
    var phi_2100_: array<u32, 16>;
    var phi_2123_: array<u32, 16>;
    var phi_2146_: array<u32, 16>;
    var phi_2169_: array<u32, 16>;
    var phi_2192_: array<u32, 16>;
    var phi_2215_: array<u32, 16>;
    var phi_2238_: array<u32, 16>;
    var phi_2261_: array<u32, 16>;
    var phi_2284_: array<u32, 16>;
    var phi_2307_: array<u32, 16>;
    var phi_2330_: array<u32, 16>;
    var phi_2349_: array<u32, 16>;
    var phi_2368_: array<u32, 16>;
    var phi_2387_: array<u32, 16>;
    var phi_2406_: array<u32, 16>;
    var phi_2425_: array<u32, 16>;
    var phi_2444_: array<u32, 16>;
    var phi_2463_: array<u32, 16>;
    var phi_2482_: array<u32, 16>;
    var phi_2501_: array<u32, 16>;
    var phi_2520_: array<u32, 16>;
    var phi_2539_: array<u32, 16>;
    var phi_2558_: array<u32, 16>;
    var phi_2577_: array<u32, 16>;
    var phi_2596_: array<u32, 16>;
    var phi_2615_: array<u32, 16>;
    var phi_2634_: array<u32, 16>;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var local_9: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e52 = id_2;
    let _e53 = n_2;
    let _e54 = lane_2;
    let _e65 = ((_e52.y * _e53.x) + _e52.x);
    let _e67 = ((_e54 / 32u) * 256u);
    let _e70 = params.member.member_2.member;
    let _e73 = params.member.member_1.member;
    let _e76 = params.member.member_2.member_1;
    let _e82 = ((_e65 * 2048u) + (((_e54 / 32u) * 512u) + (_e54 % 32u)));
    if (_e82 < _e73) {
        let _e85 = keys.member[_e82];
        phi_141_ = _e85;
    } else {
        phi_141_ = 0u;
    }
    let _e87 = phi_141_;
    let _e94 = ((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 32u) + (_e54 % 32u)));
    if (_e94 < _e73) {
        let _e97 = keys.member[_e94];
        phi_164_ = _e97;
    } else {
        phi_164_ = 0u;
    }
    let _e99 = phi_164_;
    let _e105 = ((_e65 * 2048u) + (((_e54 / 32u) * 512u) + (_e54 % 32u)));
    if (_e105 < _e73) {
        let _e108 = values.member[_e105];
        phi_187_ = _e108;
    } else {
        phi_187_ = 0u;
    }
    let _e110 = phi_187_;
    let _e117 = ((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 32u) + (_e54 % 32u)));
    if (_e117 < _e73) {
        let _e120 = values.member[_e117];
        phi_210_ = _e120;
    } else {
        phi_210_ = 0u;
    }
    let _e122 = phi_210_;
    let _e129 = ((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 64u) + (_e54 % 32u)));
    if (_e129 < _e73) {
        let _e132 = keys.member[_e129];
        phi_233_ = _e132;
    } else {
        phi_233_ = 0u;
    }
    let _e134 = phi_233_;
    let _e141 = ((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 96u) + (_e54 % 32u)));
    if (_e141 < _e73) {
        let _e144 = keys.member[_e141];
        phi_256_ = _e144;
    } else {
        phi_256_ = 0u;
    }
    let _e146 = phi_256_;
    let _e153 = ((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 64u) + (_e54 % 32u)));
    if (_e153 < _e73) {
        let _e156 = values.member[_e153];
        phi_279_ = _e156;
    } else {
        phi_279_ = 0u;
    }
    let _e158 = phi_279_;
    let _e165 = ((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 96u) + (_e54 % 32u)));
    if (_e165 < _e73) {
        let _e168 = values.member[_e165];
        phi_302_ = _e168;
    } else {
        phi_302_ = 0u;
    }
    let _e170 = phi_302_;
    let _e177 = ((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 128u) + (_e54 % 32u)));
    if (_e177 < _e73) {
        let _e180 = keys.member[_e177];
        phi_325_ = _e180;
    } else {
        phi_325_ = 0u;
    }
    let _e182 = phi_325_;
    let _e189 = ((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 160u) + (_e54 % 32u)));
    if (_e189 < _e73) {
        let _e192 = keys.member[_e189];
        phi_348_ = _e192;
    } else {
        phi_348_ = 0u;
    }
    let _e194 = phi_348_;
    let _e201 = ((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 128u) + (_e54 % 32u)));
    if (_e201 < _e73) {
        let _e204 = values.member[_e201];
        phi_371_ = _e204;
    } else {
        phi_371_ = 0u;
    }
    let _e206 = phi_371_;
    let _e213 = ((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 160u) + (_e54 % 32u)));
    if (_e213 < _e73) {
        let _e216 = values.member[_e213];
        phi_394_ = _e216;
    } else {
        phi_394_ = 0u;
    }
    let _e218 = phi_394_;
    let _e225 = ((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 192u) + (_e54 % 32u)));
    if (_e225 < _e73) {
        let _e228 = keys.member[_e225];
        phi_417_ = _e228;
    } else {
        phi_417_ = 0u;
    }
    let _e230 = phi_417_;
    let _e237 = ((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 224u) + (_e54 % 32u)));
    if (_e237 < _e73) {
        let _e240 = keys.member[_e237];
        phi_440_ = _e240;
    } else {
        phi_440_ = 0u;
    }
    let _e242 = phi_440_;
    let _e249 = ((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 192u) + (_e54 % 32u)));
    if (_e249 < _e73) {
        let _e252 = values.member[_e249];
        phi_463_ = _e252;
    } else {
        phi_463_ = 0u;
    }
    let _e254 = phi_463_;
    let _e261 = ((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 224u) + (_e54 % 32u)));
    if (_e261 < _e73) {
        let _e264 = values.member[_e261];
        phi_486_ = _e264;
    } else {
        phi_486_ = 0u;
    }
    let _e266 = phi_486_;
    let _e273 = ((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 256u) + (_e54 % 32u)));
    if (_e273 < _e73) {
        let _e276 = keys.member[_e273];
        phi_509_ = _e276;
    } else {
        phi_509_ = 0u;
    }
    let _e278 = phi_509_;
    let _e285 = ((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 288u) + (_e54 % 32u)));
    if (_e285 < _e73) {
        let _e288 = keys.member[_e285];
        phi_532_ = _e288;
    } else {
        phi_532_ = 0u;
    }
    let _e290 = phi_532_;
    let _e297 = ((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 256u) + (_e54 % 32u)));
    if (_e297 < _e73) {
        let _e300 = values.member[_e297];
        phi_555_ = _e300;
    } else {
        phi_555_ = 0u;
    }
    let _e302 = phi_555_;
    let _e309 = ((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 288u) + (_e54 % 32u)));
    if (_e309 < _e73) {
        let _e312 = values.member[_e309];
        phi_578_ = _e312;
    } else {
        phi_578_ = 0u;
    }
    let _e314 = phi_578_;
    let _e321 = ((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 320u) + (_e54 % 32u)));
    if (_e321 < _e73) {
        let _e324 = keys.member[_e321];
        phi_601_ = _e324;
    } else {
        phi_601_ = 0u;
    }
    let _e326 = phi_601_;
    let _e333 = ((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 352u) + (_e54 % 32u)));
    if (_e333 < _e73) {
        let _e336 = keys.member[_e333];
        phi_624_ = _e336;
    } else {
        phi_624_ = 0u;
    }
    let _e338 = phi_624_;
    let _e345 = ((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 320u) + (_e54 % 32u)));
    if (_e345 < _e73) {
        let _e348 = values.member[_e345];
        phi_647_ = _e348;
    } else {
        phi_647_ = 0u;
    }
    let _e350 = phi_647_;
    let _e357 = ((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 352u) + (_e54 % 32u)));
    if (_e357 < _e73) {
        let _e360 = values.member[_e357];
        phi_670_ = _e360;
    } else {
        phi_670_ = 0u;
    }
    let _e362 = phi_670_;
    let _e369 = ((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 384u) + (_e54 % 32u)));
    if (_e369 < _e73) {
        let _e372 = keys.member[_e369];
        phi_693_ = _e372;
    } else {
        phi_693_ = 0u;
    }
    let _e374 = phi_693_;
    let _e381 = ((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 416u) + (_e54 % 32u)));
    if (_e381 < _e73) {
        let _e384 = keys.member[_e381];
        phi_716_ = _e384;
    } else {
        phi_716_ = 0u;
    }
    let _e386 = phi_716_;
    let _e393 = ((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 384u) + (_e54 % 32u)));
    if (_e393 < _e73) {
        let _e396 = values.member[_e393];
        phi_739_ = _e396;
    } else {
        phi_739_ = 0u;
    }
    let _e398 = phi_739_;
    let _e405 = ((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 416u) + (_e54 % 32u)));
    if (_e405 < _e73) {
        let _e408 = values.member[_e405];
        phi_762_ = _e408;
    } else {
        phi_762_ = 0u;
    }
    let _e410 = phi_762_;
    let _e417 = ((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 448u) + (_e54 % 32u)));
    if (_e417 < _e73) {
        let _e420 = keys.member[_e417];
        phi_785_ = _e420;
    } else {
        phi_785_ = 0u;
    }
    let _e422 = phi_785_;
    let _e429 = ((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 480u) + (_e54 % 32u)));
    if (_e429 < _e73) {
        let _e432 = keys.member[_e429];
        phi_808_ = _e432;
    } else {
        phi_808_ = 0u;
    }
    let _e434 = phi_808_;
    let _e442 = ((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 448u) + (_e54 % 32u)));
    if (_e442 < _e73) {
        let _e445 = values.member[_e442];
        phi_832_ = _e445;
    } else {
        phi_832_ = 0u;
    }
    let _e447 = phi_832_;
    let _e454 = ((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 480u) + (_e54 % 32u)));
    if (_e454 < _e73) {
        let _e457 = values.member[_e454];
        phi_855_ = _e457;
    } else {
        phi_855_ = 0u;
    }
    let _e459 = phi_855_;
    phi_858_ = type_9(0u, 8u);
    loop {
        let _e461 = phi_858_;
        let _e464 = (_e461.member < _e461.member_1);
        let _e475 = select(type_9().member_1, _e461.member, _e464);
        let _e477 = (bitcast<i32>(select(0u, 1u, _e464)) != 0i);
        if _e477 {
            atomicStore((&words[((_e475 * 128u) + _e54)]), 0u);
            atomicStore((&words[((1024u + (_e475 * 128u)) + _e54)]), 0u);
            atomicStore((&counts[((_e475 * 128u) + _e54)]), 0u);
        }
        continue;
        continuing {
            phi_858_ = type_9(select(_e461.member, (_e461.member + 1u), _e464), select(_e461.member_1, _e461.member_1, _e464));
            break if !(_e477);
        }
    }
    workgroupBarrier();
    let _e495 = (((_e65 * 2048u) + (((_e54 / 32u) * 512u) + (_e54 % 32u))) < _e73);
    let _e503 = (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 32u) + (_e54 % 32u))) < _e73);
    let _e508 = (_e67 + ((_e87 >> bitcast<u32>((_e70 & 31u))) & 255u));
    let _e513 = (_e67 + ((_e99 >> bitcast<u32>((_e70 & 31u))) & 255u));
    if _e495 {
        let _e519 = atomicOr((&words[_e508]), (1u << bitcast<u32>(((_e54 % 32u) & 31u))));
    }
    if _e503 {
        let _e526 = atomicOr((&words[(1024u + _e513)]), (1u << bitcast<u32>(((_e54 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e528 = atomicLoad((&words[_e508]));
    let _e531 = atomicLoad((&words[(1024u + _e513)]));
    let _e538 = countOneBits((_e528 & ((1u << bitcast<u32>(((_e54 % 32u) & 31u))) - 1u)));
    let _e545 = countOneBits((_e531 & ((1u << bitcast<u32>(((_e54 % 32u) & 31u))) - 1u)));
    let _e547 = atomicLoad((&counts[_e508]));
    let _e548 = (_e547 + _e538);
    let _e550 = atomicLoad((&counts[_e513]));
    let _e552 = atomicLoad((&words[_e513]));
    let _e555 = ((_e550 + countOneBits(_e552)) + _e545);
    workgroupBarrier();
    if _e495 {
        if (_e538 == 0u) {
            let _e559 = atomicAdd((&counts[_e508]), countOneBits(_e528));
            atomicStore((&words[_e508]), 0u);
        }
    }
    if _e503 {
        if (_e545 == 0u) {
            let _e564 = atomicAdd((&counts[_e513]), countOneBits(_e531));
            atomicStore((&words[(1024u + _e513)]), 0u);
        }
    }
    workgroupBarrier();
    let _e574 = (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 64u) + (_e54 % 32u))) < _e73);
    let _e582 = (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 96u) + (_e54 % 32u))) < _e73);
    let _e587 = (_e67 + ((_e134 >> bitcast<u32>((_e70 & 31u))) & 255u));
    let _e592 = (_e67 + ((_e146 >> bitcast<u32>((_e70 & 31u))) & 255u));
    if _e574 {
        let _e598 = atomicOr((&words[_e587]), (1u << bitcast<u32>(((_e54 % 32u) & 31u))));
    }
    if _e582 {
        let _e605 = atomicOr((&words[(1024u + _e592)]), (1u << bitcast<u32>(((_e54 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e607 = atomicLoad((&words[_e587]));
    let _e610 = atomicLoad((&words[(1024u + _e592)]));
    let _e617 = countOneBits((_e607 & ((1u << bitcast<u32>(((_e54 % 32u) & 31u))) - 1u)));
    let _e624 = countOneBits((_e610 & ((1u << bitcast<u32>(((_e54 % 32u) & 31u))) - 1u)));
    let _e626 = atomicLoad((&counts[_e587]));
    let _e627 = (_e626 + _e617);
    let _e629 = atomicLoad((&counts[_e592]));
    let _e631 = atomicLoad((&words[_e592]));
    let _e634 = ((_e629 + countOneBits(_e631)) + _e624);
    workgroupBarrier();
    if _e574 {
        if (_e617 == 0u) {
            let _e638 = atomicAdd((&counts[_e587]), countOneBits(_e607));
            atomicStore((&words[_e587]), 0u);
        }
    }
    if _e582 {
        if (_e624 == 0u) {
            let _e643 = atomicAdd((&counts[_e592]), countOneBits(_e610));
            atomicStore((&words[(1024u + _e592)]), 0u);
        }
    }
    workgroupBarrier();
    let _e653 = (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 128u) + (_e54 % 32u))) < _e73);
    let _e661 = (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 160u) + (_e54 % 32u))) < _e73);
    let _e666 = (_e67 + ((_e182 >> bitcast<u32>((_e70 & 31u))) & 255u));
    let _e671 = (_e67 + ((_e194 >> bitcast<u32>((_e70 & 31u))) & 255u));
    if _e653 {
        let _e677 = atomicOr((&words[_e666]), (1u << bitcast<u32>(((_e54 % 32u) & 31u))));
    }
    if _e661 {
        let _e684 = atomicOr((&words[(1024u + _e671)]), (1u << bitcast<u32>(((_e54 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e686 = atomicLoad((&words[_e666]));
    let _e689 = atomicLoad((&words[(1024u + _e671)]));
    let _e696 = countOneBits((_e686 & ((1u << bitcast<u32>(((_e54 % 32u) & 31u))) - 1u)));
    let _e703 = countOneBits((_e689 & ((1u << bitcast<u32>(((_e54 % 32u) & 31u))) - 1u)));
    let _e705 = atomicLoad((&counts[_e666]));
    let _e706 = (_e705 + _e696);
    let _e708 = atomicLoad((&counts[_e671]));
    let _e710 = atomicLoad((&words[_e671]));
    let _e713 = ((_e708 + countOneBits(_e710)) + _e703);
    workgroupBarrier();
    if _e653 {
        if (_e696 == 0u) {
            let _e717 = atomicAdd((&counts[_e666]), countOneBits(_e686));
            atomicStore((&words[_e666]), 0u);
        }
    }
    if _e661 {
        if (_e703 == 0u) {
            let _e722 = atomicAdd((&counts[_e671]), countOneBits(_e689));
            atomicStore((&words[(1024u + _e671)]), 0u);
        }
    }
    workgroupBarrier();
    let _e732 = (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 192u) + (_e54 % 32u))) < _e73);
    let _e740 = (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 224u) + (_e54 % 32u))) < _e73);
    let _e745 = (_e67 + ((_e230 >> bitcast<u32>((_e70 & 31u))) & 255u));
    let _e750 = (_e67 + ((_e242 >> bitcast<u32>((_e70 & 31u))) & 255u));
    if _e732 {
        let _e756 = atomicOr((&words[_e745]), (1u << bitcast<u32>(((_e54 % 32u) & 31u))));
    }
    if _e740 {
        let _e763 = atomicOr((&words[(1024u + _e750)]), (1u << bitcast<u32>(((_e54 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e765 = atomicLoad((&words[_e745]));
    let _e768 = atomicLoad((&words[(1024u + _e750)]));
    let _e775 = countOneBits((_e765 & ((1u << bitcast<u32>(((_e54 % 32u) & 31u))) - 1u)));
    let _e782 = countOneBits((_e768 & ((1u << bitcast<u32>(((_e54 % 32u) & 31u))) - 1u)));
    let _e784 = atomicLoad((&counts[_e745]));
    let _e785 = (_e784 + _e775);
    let _e787 = atomicLoad((&counts[_e750]));
    let _e789 = atomicLoad((&words[_e750]));
    let _e792 = ((_e787 + countOneBits(_e789)) + _e782);
    workgroupBarrier();
    if _e732 {
        if (_e775 == 0u) {
            let _e796 = atomicAdd((&counts[_e745]), countOneBits(_e765));
            atomicStore((&words[_e745]), 0u);
        }
    }
    if _e740 {
        if (_e782 == 0u) {
            let _e801 = atomicAdd((&counts[_e750]), countOneBits(_e768));
            atomicStore((&words[(1024u + _e750)]), 0u);
        }
    }
    workgroupBarrier();
    let _e811 = (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 256u) + (_e54 % 32u))) < _e73);
    let _e819 = (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 288u) + (_e54 % 32u))) < _e73);
    let _e824 = (_e67 + ((_e278 >> bitcast<u32>((_e70 & 31u))) & 255u));
    let _e829 = (_e67 + ((_e290 >> bitcast<u32>((_e70 & 31u))) & 255u));
    if _e811 {
        let _e835 = atomicOr((&words[_e824]), (1u << bitcast<u32>(((_e54 % 32u) & 31u))));
    }
    if _e819 {
        let _e842 = atomicOr((&words[(1024u + _e829)]), (1u << bitcast<u32>(((_e54 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e844 = atomicLoad((&words[_e824]));
    let _e847 = atomicLoad((&words[(1024u + _e829)]));
    let _e854 = countOneBits((_e844 & ((1u << bitcast<u32>(((_e54 % 32u) & 31u))) - 1u)));
    let _e861 = countOneBits((_e847 & ((1u << bitcast<u32>(((_e54 % 32u) & 31u))) - 1u)));
    let _e863 = atomicLoad((&counts[_e824]));
    let _e864 = (_e863 + _e854);
    let _e866 = atomicLoad((&counts[_e829]));
    let _e868 = atomicLoad((&words[_e829]));
    let _e871 = ((_e866 + countOneBits(_e868)) + _e861);
    workgroupBarrier();
    if _e811 {
        if (_e854 == 0u) {
            let _e875 = atomicAdd((&counts[_e824]), countOneBits(_e844));
            atomicStore((&words[_e824]), 0u);
        }
    }
    if _e819 {
        if (_e861 == 0u) {
            let _e880 = atomicAdd((&counts[_e829]), countOneBits(_e847));
            atomicStore((&words[(1024u + _e829)]), 0u);
        }
    }
    workgroupBarrier();
    let _e890 = (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 320u) + (_e54 % 32u))) < _e73);
    let _e898 = (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 352u) + (_e54 % 32u))) < _e73);
    let _e903 = (_e67 + ((_e326 >> bitcast<u32>((_e70 & 31u))) & 255u));
    let _e908 = (_e67 + ((_e338 >> bitcast<u32>((_e70 & 31u))) & 255u));
    if _e890 {
        let _e914 = atomicOr((&words[_e903]), (1u << bitcast<u32>(((_e54 % 32u) & 31u))));
    }
    if _e898 {
        let _e921 = atomicOr((&words[(1024u + _e908)]), (1u << bitcast<u32>(((_e54 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e923 = atomicLoad((&words[_e903]));
    let _e926 = atomicLoad((&words[(1024u + _e908)]));
    let _e933 = countOneBits((_e923 & ((1u << bitcast<u32>(((_e54 % 32u) & 31u))) - 1u)));
    let _e940 = countOneBits((_e926 & ((1u << bitcast<u32>(((_e54 % 32u) & 31u))) - 1u)));
    let _e942 = atomicLoad((&counts[_e903]));
    let _e943 = (_e942 + _e933);
    let _e945 = atomicLoad((&counts[_e908]));
    let _e947 = atomicLoad((&words[_e908]));
    let _e950 = ((_e945 + countOneBits(_e947)) + _e940);
    workgroupBarrier();
    if _e890 {
        if (_e933 == 0u) {
            let _e954 = atomicAdd((&counts[_e903]), countOneBits(_e923));
            atomicStore((&words[_e903]), 0u);
        }
    }
    if _e898 {
        if (_e940 == 0u) {
            let _e959 = atomicAdd((&counts[_e908]), countOneBits(_e926));
            atomicStore((&words[(1024u + _e908)]), 0u);
        }
    }
    workgroupBarrier();
    let _e969 = (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 384u) + (_e54 % 32u))) < _e73);
    let _e977 = (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 416u) + (_e54 % 32u))) < _e73);
    let _e982 = (_e67 + ((_e374 >> bitcast<u32>((_e70 & 31u))) & 255u));
    let _e987 = (_e67 + ((_e386 >> bitcast<u32>((_e70 & 31u))) & 255u));
    if _e969 {
        let _e993 = atomicOr((&words[_e982]), (1u << bitcast<u32>(((_e54 % 32u) & 31u))));
    }
    if _e977 {
        let _e1000 = atomicOr((&words[(1024u + _e987)]), (1u << bitcast<u32>(((_e54 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e1002 = atomicLoad((&words[_e982]));
    let _e1005 = atomicLoad((&words[(1024u + _e987)]));
    let _e1012 = countOneBits((_e1002 & ((1u << bitcast<u32>(((_e54 % 32u) & 31u))) - 1u)));
    let _e1019 = countOneBits((_e1005 & ((1u << bitcast<u32>(((_e54 % 32u) & 31u))) - 1u)));
    let _e1021 = atomicLoad((&counts[_e982]));
    let _e1022 = (_e1021 + _e1012);
    let _e1024 = atomicLoad((&counts[_e987]));
    let _e1026 = atomicLoad((&words[_e987]));
    let _e1029 = ((_e1024 + countOneBits(_e1026)) + _e1019);
    workgroupBarrier();
    if _e969 {
        if (_e1012 == 0u) {
            let _e1033 = atomicAdd((&counts[_e982]), countOneBits(_e1002));
            atomicStore((&words[_e982]), 0u);
        }
    }
    if _e977 {
        if (_e1019 == 0u) {
            let _e1038 = atomicAdd((&counts[_e987]), countOneBits(_e1005));
            atomicStore((&words[(1024u + _e987)]), 0u);
        }
    }
    workgroupBarrier();
    let _e1048 = (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 448u) + (_e54 % 32u))) < _e73);
    let _e1056 = (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 480u) + (_e54 % 32u))) < _e73);
    let _e1061 = (_e67 + ((_e422 >> bitcast<u32>((_e70 & 31u))) & 255u));
    let _e1066 = (_e67 + ((_e434 >> bitcast<u32>((_e70 & 31u))) & 255u));
    if _e1048 {
        let _e1072 = atomicOr((&words[_e1061]), (1u << bitcast<u32>(((_e54 % 32u) & 31u))));
    }
    if _e1056 {
        let _e1079 = atomicOr((&words[(1024u + _e1066)]), (1u << bitcast<u32>(((_e54 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e1081 = atomicLoad((&words[_e1061]));
    let _e1084 = atomicLoad((&words[(1024u + _e1066)]));
    let _e1091 = countOneBits((_e1081 & ((1u << bitcast<u32>(((_e54 % 32u) & 31u))) - 1u)));
    let _e1098 = countOneBits((_e1084 & ((1u << bitcast<u32>(((_e54 % 32u) & 31u))) - 1u)));
    let _e1100 = atomicLoad((&counts[_e1061]));
    let _e1101 = (_e1100 + _e1091);
    let _e1103 = atomicLoad((&counts[_e1066]));
    let _e1105 = atomicLoad((&words[_e1066]));
    let _e1108 = ((_e1103 + countOneBits(_e1105)) + _e1098);
    workgroupBarrier();
    if _e1048 {
        if (_e1091 == 0u) {
            let _e1113 = atomicAdd((&counts[_e1061]), countOneBits(_e1081));
            atomicStore((&words[_e1061]), 0u);
        }
    }
    if _e1056 {
        if (_e1098 == 0u) {
            let _e1118 = atomicAdd((&counts[_e1066]), countOneBits(_e1084));
            atomicStore((&words[(1024u + _e1066)]), 0u);
        }
    }
    workgroupBarrier();
    phi_1647_ = type_9(0u, 2u);
    phi_1650_ = 0u;
    phi_1652_ = 0u;
    loop {
        let _e1122 = phi_1647_;
        let _e1124 = phi_1650_;
        let _e1126 = phi_1652_;
        local = _e1126;
        local_7 = _e1126;
        local_2 = _e1126;
        local_3 = _e1124;
        local_8 = _e1124;
        local_5 = _e1124;
        let _e1129 = (_e1122.member < _e1122.member_1);
        let _e1142 = (bitcast<i32>(select(0u, 1u, _e1129)) != 0i);
        if _e1142 {
            let _e1144 = ((2u * _e54) + select(type_9().member_1, _e1122.member, _e1129));
            phi_1687_ = type_9(0u, 4u);
            phi_1690_ = _e1126;
            loop {
                let _e1146 = phi_1687_;
                let _e1148 = phi_1690_;
                local_6 = _e1148;
                let _e1151 = (_e1146.member < _e1146.member_1);
                let _e1164 = (bitcast<i32>(select(0u, 1u, _e1151)) != 0i);
                if _e1164 {
                    let _e1168 = atomicLoad((&counts[((select(type_9().member_1, _e1146.member, _e1151) * 256u) + _e1144)]));
                    phi_1691_ = (_e1148 + _e1168);
                } else {
                    phi_1691_ = u32();
                }
                let _e1171 = phi_1691_;
                continue;
                continuing {
                    phi_1687_ = type_9(select(_e1146.member, (_e1146.member + 1u), _e1151), select(_e1146.member_1, _e1146.member_1, _e1151));
                    phi_1690_ = _e1171;
                    break if !(_e1164);
                }
            }
            let _e1176 = table.member[((256u * _e76) + _e1144)];
            phi_1651_ = (_e1124 + _e1176);
            let _e2737 = local_6;
            phi_1653_ = _e2737;
        } else {
            phi_1651_ = u32();
            phi_1653_ = u32();
        }
        let _e1179 = phi_1651_;
        let _e1181 = phi_1653_;
        continue;
        continuing {
            phi_1647_ = type_9(select(_e1122.member, (_e1122.member + 1u), _e1129), select(_e1122.member_1, _e1122.member_1, _e1129));
            phi_1650_ = _e1179;
            phi_1652_ = _e1181;
            break if !(_e1142);
        }
    }
    let _e1185 = local;
    atomicStore((&words[_e54]), _e1185);
    phi_1742_ = type_9(0u, 7u);
    phi_1745_ = 0u;
    phi_1747_ = 1u;
    let _e2744 = local_7;
    phi_1749_ = _e2744;
    phi_1746_ = 1024u;
    loop {
        let _e1187 = phi_1742_;
        let _e1189 = phi_1745_;
        let _e1191 = phi_1747_;
        let _e1193 = phi_1749_;
        let _e1195 = phi_1746_;
        local_1 = _e1193;
        let _e1198 = (_e1187.member < _e1187.member_1);
        let _e1209 = (bitcast<i32>(select(0u, 1u, _e1198)) != 0i);
        if _e1209 {
            workgroupBarrier();
            if (_e54 >= _e1191) {
                let _e1214 = atomicLoad((&words[((_e1189 + _e54) - _e1191)]));
                phi_1788_ = (_e1193 + _e1214);
            } else {
                phi_1788_ = _e1193;
            }
            let _e1217 = phi_1788_;
            atomicStore((&words[(_e1195 + _e54)]), _e1217);
            phi_1748_ = (_e1191 * 2u);
            phi_1750_ = _e1217;
        } else {
            phi_1748_ = u32();
            phi_1750_ = u32();
        }
        let _e1222 = phi_1748_;
        let _e1224 = phi_1750_;
        continue;
        continuing {
            phi_1742_ = type_9(select(_e1187.member, (_e1187.member + 1u), _e1198), select(_e1187.member_1, _e1187.member_1, _e1198));
            phi_1745_ = _e1195;
            phi_1747_ = _e1222;
            phi_1749_ = _e1224;
            phi_1746_ = _e1189;
            break if !(_e1209);
        }
    }
    workgroupBarrier();
    let _e1227 = local_1;
    let _e1229 = local_2;
    let _e1233 = local_3;
    atomicStore((&words[_e54]), _e1233);
    phi_1796_ = type_9(0u, 7u);
    phi_1799_ = 0u;
    phi_1801_ = 1u;
    let _e2757 = local_8;
    phi_1803_ = _e2757;
    phi_1800_ = 1024u;
    loop {
        let _e1235 = phi_1796_;
        let _e1237 = phi_1799_;
        let _e1239 = phi_1801_;
        let _e1241 = phi_1803_;
        let _e1243 = phi_1800_;
        local_4 = _e1241;
        let _e1246 = (_e1235.member < _e1235.member_1);
        let _e1257 = (bitcast<i32>(select(0u, 1u, _e1246)) != 0i);
        if _e1257 {
            workgroupBarrier();
            if (_e54 >= _e1239) {
                let _e1262 = atomicLoad((&words[((_e1237 + _e54) - _e1239)]));
                phi_1842_ = (_e1241 + _e1262);
            } else {
                phi_1842_ = _e1241;
            }
            let _e1265 = phi_1842_;
            atomicStore((&words[(_e1243 + _e54)]), _e1265);
            phi_1802_ = (_e1239 * 2u);
            phi_1804_ = _e1265;
        } else {
            phi_1802_ = u32();
            phi_1804_ = u32();
        }
        let _e1270 = phi_1802_;
        let _e1272 = phi_1804_;
        continue;
        continuing {
            phi_1796_ = type_9(select(_e1235.member, (_e1235.member + 1u), _e1246), select(_e1235.member_1, _e1235.member_1, _e1246));
            phi_1799_ = _e1243;
            phi_1801_ = _e1270;
            phi_1803_ = _e1272;
            phi_1800_ = _e1237;
            break if !(_e1257);
        }
    }
    workgroupBarrier();
    let _e1275 = local_4;
    let _e1277 = local_5;
    phi_1849_ = type_9(0u, 2u);
    phi_1852_ = (_e1275 - _e1277);
    phi_1854_ = (_e1227 - _e1229);
    loop {
        let _e1280 = phi_1849_;
        let _e1282 = phi_1852_;
        let _e1284 = phi_1854_;
        let _e1287 = (_e1280.member < _e1280.member_1);
        let _e1300 = (bitcast<i32>(select(0u, 1u, _e1287)) != 0i);
        if _e1300 {
            let _e1302 = ((2u * _e54) + select(type_9().member_1, _e1280.member, _e1287));
            if (_e65 < _e76) {
                let _e1307 = table.member[((_e1302 * _e76) + _e65)];
                phi_1903_ = _e1307;
            } else {
                phi_1903_ = 0u;
            }
            let _e1309 = phi_1903_;
            starts[_e1302] = ((_e1282 + _e1309) - _e1284);
            let _e1316 = table.member[((256u * _e76) + _e1302)];
            phi_1922_ = type_9(0u, 4u);
            phi_1925_ = _e1284;
            loop {
                let _e1319 = phi_1922_;
                let _e1321 = phi_1925_;
                local_9 = _e1321;
                let _e1324 = (_e1319.member < _e1319.member_1);
                let _e1335 = select(type_9().member_1, _e1319.member, _e1324);
                let _e1337 = (bitcast<i32>(select(0u, 1u, _e1324)) != 0i);
                if _e1337 {
                    let _e1341 = atomicLoad((&counts[((_e1335 * 256u) + _e1302)]));
                    atomicStore((&counts[((_e1335 * 256u) + _e1302)]), _e1321);
                    phi_1926_ = (_e1321 + _e1341);
                } else {
                    phi_1926_ = u32();
                }
                let _e1347 = phi_1926_;
                continue;
                continuing {
                    phi_1922_ = type_9(select(_e1319.member, (_e1319.member + 1u), _e1324), select(_e1319.member_1, _e1319.member_1, _e1324));
                    phi_1925_ = _e1347;
                    break if !(_e1337);
                }
            }
            phi_1853_ = (_e1282 + _e1316);
            let _e2774 = local_9;
            phi_1855_ = _e2774;
        } else {
            phi_1853_ = u32();
            phi_1855_ = u32();
        }
        let _e1350 = phi_1853_;
        let _e1352 = phi_1855_;
        continue;
        continuing {
            phi_1849_ = type_9(select(_e1280.member, (_e1280.member + 1u), _e1287), select(_e1280.member_1, _e1280.member_1, _e1287));
            phi_1852_ = _e1350;
            phi_1854_ = _e1352;
            break if !(_e1300);
        }
    }
    workgroupBarrier();
    if (((_e65 * 2048u) + (((_e54 / 32u) * 512u) + (_e54 % 32u))) < _e73) {
        let _e1367 = atomicLoad((&counts[(_e67 + ((_e87 >> bitcast<u32>((_e70 & 31u))) & 255u))]));
        let _e1368 = (_e548 + _e1367);
        atomicStore((&words[_e1368]), _e87);
        phi_1985_ = array<u32, 16>(_e1368, _e555, _e627, _e634, _e706, _e713, _e785, _e792, _e864, _e871, _e943, _e950, _e1022, _e1029, _e1101, _e1108);
    } else {
        phi_1985_ = array<u32, 16>(_e548, _e555, _e627, _e634, _e706, _e713, _e785, _e792, _e864, _e871, _e943, _e950, _e1022, _e1029, _e1101, _e1108);
    }
    let _e1372 = phi_1985_;
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 32u) + (_e54 % 32u))) < _e73) {
        let _e1387 = atomicLoad((&counts[(_e67 + ((_e99 >> bitcast<u32>((_e70 & 31u))) & 255u))]));
        let _e1389 = (_e1372[1] + _e1387);
        atomicStore((&words[_e1389]), _e99);
        phi_2008_ = array<u32, 16>(_e1372[0], _e1389, _e1372[2], _e1372[3], _e1372[4], _e1372[5], _e1372[6], _e1372[7], _e1372[8], _e1372[9], _e1372[10], _e1372[11], _e1372[12], _e1372[13], _e1372[14], _e1372[15]);
    } else {
        phi_2008_ = _e1372;
    }
    let _e1408 = phi_2008_;
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 64u) + (_e54 % 32u))) < _e73) {
        let _e1423 = atomicLoad((&counts[(_e67 + ((_e134 >> bitcast<u32>((_e70 & 31u))) & 255u))]));
        let _e1425 = (_e1408[2] + _e1423);
        atomicStore((&words[_e1425]), _e134);
        phi_2031_ = array<u32, 16>(_e1408[0], _e1408[1], _e1425, _e1408[3], _e1408[4], _e1408[5], _e1408[6], _e1408[7], _e1408[8], _e1408[9], _e1408[10], _e1408[11], _e1408[12], _e1408[13], _e1408[14], _e1408[15]);
    } else {
        phi_2031_ = _e1408;
    }
    let _e1444 = phi_2031_;
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 96u) + (_e54 % 32u))) < _e73) {
        let _e1459 = atomicLoad((&counts[(_e67 + ((_e146 >> bitcast<u32>((_e70 & 31u))) & 255u))]));
        let _e1461 = (_e1444[3] + _e1459);
        atomicStore((&words[_e1461]), _e146);
        phi_2054_ = array<u32, 16>(_e1444[0], _e1444[1], _e1444[2], _e1461, _e1444[4], _e1444[5], _e1444[6], _e1444[7], _e1444[8], _e1444[9], _e1444[10], _e1444[11], _e1444[12], _e1444[13], _e1444[14], _e1444[15]);
    } else {
        phi_2054_ = _e1444;
    }
    let _e1480 = phi_2054_;
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 128u) + (_e54 % 32u))) < _e73) {
        let _e1495 = atomicLoad((&counts[(_e67 + ((_e182 >> bitcast<u32>((_e70 & 31u))) & 255u))]));
        let _e1497 = (_e1480[4] + _e1495);
        atomicStore((&words[_e1497]), _e182);
        phi_2077_ = array<u32, 16>(_e1480[0], _e1480[1], _e1480[2], _e1480[3], _e1497, _e1480[5], _e1480[6], _e1480[7], _e1480[8], _e1480[9], _e1480[10], _e1480[11], _e1480[12], _e1480[13], _e1480[14], _e1480[15]);
    } else {
        phi_2077_ = _e1480;
    }
    let _e1516 = phi_2077_;
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 160u) + (_e54 % 32u))) < _e73) {
        let _e1531 = atomicLoad((&counts[(_e67 + ((_e194 >> bitcast<u32>((_e70 & 31u))) & 255u))]));
        let _e1533 = (_e1516[5] + _e1531);
        atomicStore((&words[_e1533]), _e194);
        phi_2100_ = array<u32, 16>(_e1516[0], _e1516[1], _e1516[2], _e1516[3], _e1516[4], _e1533, _e1516[6], _e1516[7], _e1516[8], _e1516[9], _e1516[10], _e1516[11], _e1516[12], _e1516[13], _e1516[14], _e1516[15]);
    } else {
        phi_2100_ = _e1516;
    }
    let _e1552 = phi_2100_;
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 192u) + (_e54 % 32u))) < _e73) {
        let _e1567 = atomicLoad((&counts[(_e67 + ((_e230 >> bitcast<u32>((_e70 & 31u))) & 255u))]));
        let _e1569 = (_e1552[6] + _e1567);
        atomicStore((&words[_e1569]), _e230);
        phi_2123_ = array<u32, 16>(_e1552[0], _e1552[1], _e1552[2], _e1552[3], _e1552[4], _e1552[5], _e1569, _e1552[7], _e1552[8], _e1552[9], _e1552[10], _e1552[11], _e1552[12], _e1552[13], _e1552[14], _e1552[15]);
    } else {
        phi_2123_ = _e1552;
    }
    let _e1588 = phi_2123_;
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 224u) + (_e54 % 32u))) < _e73) {
        let _e1603 = atomicLoad((&counts[(_e67 + ((_e242 >> bitcast<u32>((_e70 & 31u))) & 255u))]));
        let _e1605 = (_e1588[7] + _e1603);
        atomicStore((&words[_e1605]), _e242);
        phi_2146_ = array<u32, 16>(_e1588[0], _e1588[1], _e1588[2], _e1588[3], _e1588[4], _e1588[5], _e1588[6], _e1605, _e1588[8], _e1588[9], _e1588[10], _e1588[11], _e1588[12], _e1588[13], _e1588[14], _e1588[15]);
    } else {
        phi_2146_ = _e1588;
    }
    let _e1624 = phi_2146_;
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 256u) + (_e54 % 32u))) < _e73) {
        let _e1639 = atomicLoad((&counts[(_e67 + ((_e278 >> bitcast<u32>((_e70 & 31u))) & 255u))]));
        let _e1641 = (_e1624[8] + _e1639);
        atomicStore((&words[_e1641]), _e278);
        phi_2169_ = array<u32, 16>(_e1624[0], _e1624[1], _e1624[2], _e1624[3], _e1624[4], _e1624[5], _e1624[6], _e1624[7], _e1641, _e1624[9], _e1624[10], _e1624[11], _e1624[12], _e1624[13], _e1624[14], _e1624[15]);
    } else {
        phi_2169_ = _e1624;
    }
    let _e1660 = phi_2169_;
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 288u) + (_e54 % 32u))) < _e73) {
        let _e1675 = atomicLoad((&counts[(_e67 + ((_e290 >> bitcast<u32>((_e70 & 31u))) & 255u))]));
        let _e1677 = (_e1660[9] + _e1675);
        atomicStore((&words[_e1677]), _e290);
        phi_2192_ = array<u32, 16>(_e1660[0], _e1660[1], _e1660[2], _e1660[3], _e1660[4], _e1660[5], _e1660[6], _e1660[7], _e1660[8], _e1677, _e1660[10], _e1660[11], _e1660[12], _e1660[13], _e1660[14], _e1660[15]);
    } else {
        phi_2192_ = _e1660;
    }
    let _e1696 = phi_2192_;
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 320u) + (_e54 % 32u))) < _e73) {
        let _e1711 = atomicLoad((&counts[(_e67 + ((_e326 >> bitcast<u32>((_e70 & 31u))) & 255u))]));
        let _e1713 = (_e1696[10] + _e1711);
        atomicStore((&words[_e1713]), _e326);
        phi_2215_ = array<u32, 16>(_e1696[0], _e1696[1], _e1696[2], _e1696[3], _e1696[4], _e1696[5], _e1696[6], _e1696[7], _e1696[8], _e1696[9], _e1713, _e1696[11], _e1696[12], _e1696[13], _e1696[14], _e1696[15]);
    } else {
        phi_2215_ = _e1696;
    }
    let _e1732 = phi_2215_;
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 352u) + (_e54 % 32u))) < _e73) {
        let _e1747 = atomicLoad((&counts[(_e67 + ((_e338 >> bitcast<u32>((_e70 & 31u))) & 255u))]));
        let _e1749 = (_e1732[11] + _e1747);
        atomicStore((&words[_e1749]), _e338);
        phi_2238_ = array<u32, 16>(_e1732[0], _e1732[1], _e1732[2], _e1732[3], _e1732[4], _e1732[5], _e1732[6], _e1732[7], _e1732[8], _e1732[9], _e1732[10], _e1749, _e1732[12], _e1732[13], _e1732[14], _e1732[15]);
    } else {
        phi_2238_ = _e1732;
    }
    let _e1768 = phi_2238_;
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 384u) + (_e54 % 32u))) < _e73) {
        let _e1783 = atomicLoad((&counts[(_e67 + ((_e374 >> bitcast<u32>((_e70 & 31u))) & 255u))]));
        let _e1785 = (_e1768[12] + _e1783);
        atomicStore((&words[_e1785]), _e374);
        phi_2261_ = array<u32, 16>(_e1768[0], _e1768[1], _e1768[2], _e1768[3], _e1768[4], _e1768[5], _e1768[6], _e1768[7], _e1768[8], _e1768[9], _e1768[10], _e1768[11], _e1785, _e1768[13], _e1768[14], _e1768[15]);
    } else {
        phi_2261_ = _e1768;
    }
    let _e1804 = phi_2261_;
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 416u) + (_e54 % 32u))) < _e73) {
        let _e1819 = atomicLoad((&counts[(_e67 + ((_e386 >> bitcast<u32>((_e70 & 31u))) & 255u))]));
        let _e1821 = (_e1804[13] + _e1819);
        atomicStore((&words[_e1821]), _e386);
        phi_2284_ = array<u32, 16>(_e1804[0], _e1804[1], _e1804[2], _e1804[3], _e1804[4], _e1804[5], _e1804[6], _e1804[7], _e1804[8], _e1804[9], _e1804[10], _e1804[11], _e1804[12], _e1821, _e1804[14], _e1804[15]);
    } else {
        phi_2284_ = _e1804;
    }
    let _e1840 = phi_2284_;
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 448u) + (_e54 % 32u))) < _e73) {
        let _e1855 = atomicLoad((&counts[(_e67 + ((_e422 >> bitcast<u32>((_e70 & 31u))) & 255u))]));
        let _e1857 = (_e1840[14] + _e1855);
        atomicStore((&words[_e1857]), _e422);
        phi_2307_ = array<u32, 16>(_e1840[0], _e1840[1], _e1840[2], _e1840[3], _e1840[4], _e1840[5], _e1840[6], _e1840[7], _e1840[8], _e1840[9], _e1840[10], _e1840[11], _e1840[12], _e1840[13], _e1857, _e1840[15]);
    } else {
        phi_2307_ = _e1840;
    }
    let _e1876 = phi_2307_;
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 480u) + (_e54 % 32u))) < _e73) {
        let _e1891 = atomicLoad((&counts[(_e67 + ((_e434 >> bitcast<u32>((_e70 & 31u))) & 255u))]));
        let _e1893 = (_e1876[15] + _e1891);
        atomicStore((&words[_e1893]), _e434);
        phi_2330_ = array<u32, 16>(_e1876[0], _e1876[1], _e1876[2], _e1876[3], _e1876[4], _e1876[5], _e1876[6], _e1876[7], _e1876[8], _e1876[9], _e1876[10], _e1876[11], _e1876[12], _e1876[13], _e1876[14], _e1893);
    } else {
        phi_2330_ = _e1876;
    }
    let _e1912 = phi_2330_;
    workgroupBarrier();
    if (((_e65 * 2048u) + _e54) < _e73) {
        let _e1917 = atomicLoad((&words[_e54]));
        let _e1923 = starts[((_e1917 >> bitcast<u32>((_e70 & 31u))) & 255u)];
        let _e1924 = (_e1923 + _e54);
        keys_out.member[_e1924] = _e1917;
        phi_2349_ = array<u32, 16>(_e1924, _e99, _e134, _e146, _e182, _e194, _e230, _e242, _e278, _e290, _e326, _e338, _e374, _e386, _e422, _e434);
    } else {
        phi_2349_ = array<u32, 16>(_e87, _e99, _e134, _e146, _e182, _e194, _e230, _e242, _e278, _e290, _e326, _e338, _e374, _e386, _e422, _e434);
    }
    let _e1928 = phi_2349_;
    let _e1929 = (128u + _e54);
    if (((_e65 * 2048u) + _e1929) < _e73) {
        let _e1934 = atomicLoad((&words[_e1929]));
        let _e1940 = starts[((_e1934 >> bitcast<u32>((_e70 & 31u))) & 255u)];
        let _e1941 = (_e1940 + _e1929);
        keys_out.member[_e1941] = _e1934;
        phi_2368_ = array<u32, 16>(_e1928[0], _e1941, _e1928[2], _e1928[3], _e1928[4], _e1928[5], _e1928[6], _e1928[7], _e1928[8], _e1928[9], _e1928[10], _e1928[11], _e1928[12], _e1928[13], _e1928[14], _e1928[15]);
    } else {
        phi_2368_ = _e1928;
    }
    let _e1960 = phi_2368_;
    let _e1961 = (256u + _e54);
    if (((_e65 * 2048u) + _e1961) < _e73) {
        let _e1966 = atomicLoad((&words[_e1961]));
        let _e1972 = starts[((_e1966 >> bitcast<u32>((_e70 & 31u))) & 255u)];
        let _e1973 = (_e1972 + _e1961);
        keys_out.member[_e1973] = _e1966;
        phi_2387_ = array<u32, 16>(_e1960[0], _e1960[1], _e1973, _e1960[3], _e1960[4], _e1960[5], _e1960[6], _e1960[7], _e1960[8], _e1960[9], _e1960[10], _e1960[11], _e1960[12], _e1960[13], _e1960[14], _e1960[15]);
    } else {
        phi_2387_ = _e1960;
    }
    let _e1992 = phi_2387_;
    let _e1993 = (384u + _e54);
    if (((_e65 * 2048u) + _e1993) < _e73) {
        let _e1998 = atomicLoad((&words[_e1993]));
        let _e2004 = starts[((_e1998 >> bitcast<u32>((_e70 & 31u))) & 255u)];
        let _e2005 = (_e2004 + _e1993);
        keys_out.member[_e2005] = _e1998;
        phi_2406_ = array<u32, 16>(_e1992[0], _e1992[1], _e1992[2], _e2005, _e1992[4], _e1992[5], _e1992[6], _e1992[7], _e1992[8], _e1992[9], _e1992[10], _e1992[11], _e1992[12], _e1992[13], _e1992[14], _e1992[15]);
    } else {
        phi_2406_ = _e1992;
    }
    let _e2024 = phi_2406_;
    let _e2025 = (512u + _e54);
    if (((_e65 * 2048u) + _e2025) < _e73) {
        let _e2030 = atomicLoad((&words[_e2025]));
        let _e2036 = starts[((_e2030 >> bitcast<u32>((_e70 & 31u))) & 255u)];
        let _e2037 = (_e2036 + _e2025);
        keys_out.member[_e2037] = _e2030;
        phi_2425_ = array<u32, 16>(_e2024[0], _e2024[1], _e2024[2], _e2024[3], _e2037, _e2024[5], _e2024[6], _e2024[7], _e2024[8], _e2024[9], _e2024[10], _e2024[11], _e2024[12], _e2024[13], _e2024[14], _e2024[15]);
    } else {
        phi_2425_ = _e2024;
    }
    let _e2056 = phi_2425_;
    let _e2057 = (640u + _e54);
    if (((_e65 * 2048u) + _e2057) < _e73) {
        let _e2062 = atomicLoad((&words[_e2057]));
        let _e2068 = starts[((_e2062 >> bitcast<u32>((_e70 & 31u))) & 255u)];
        let _e2069 = (_e2068 + _e2057);
        keys_out.member[_e2069] = _e2062;
        phi_2444_ = array<u32, 16>(_e2056[0], _e2056[1], _e2056[2], _e2056[3], _e2056[4], _e2069, _e2056[6], _e2056[7], _e2056[8], _e2056[9], _e2056[10], _e2056[11], _e2056[12], _e2056[13], _e2056[14], _e2056[15]);
    } else {
        phi_2444_ = _e2056;
    }
    let _e2088 = phi_2444_;
    let _e2089 = (768u + _e54);
    if (((_e65 * 2048u) + _e2089) < _e73) {
        let _e2094 = atomicLoad((&words[_e2089]));
        let _e2100 = starts[((_e2094 >> bitcast<u32>((_e70 & 31u))) & 255u)];
        let _e2101 = (_e2100 + _e2089);
        keys_out.member[_e2101] = _e2094;
        phi_2463_ = array<u32, 16>(_e2088[0], _e2088[1], _e2088[2], _e2088[3], _e2088[4], _e2088[5], _e2101, _e2088[7], _e2088[8], _e2088[9], _e2088[10], _e2088[11], _e2088[12], _e2088[13], _e2088[14], _e2088[15]);
    } else {
        phi_2463_ = _e2088;
    }
    let _e2120 = phi_2463_;
    let _e2121 = (896u + _e54);
    if (((_e65 * 2048u) + _e2121) < _e73) {
        let _e2126 = atomicLoad((&words[_e2121]));
        let _e2132 = starts[((_e2126 >> bitcast<u32>((_e70 & 31u))) & 255u)];
        let _e2133 = (_e2132 + _e2121);
        keys_out.member[_e2133] = _e2126;
        phi_2482_ = array<u32, 16>(_e2120[0], _e2120[1], _e2120[2], _e2120[3], _e2120[4], _e2120[5], _e2120[6], _e2133, _e2120[8], _e2120[9], _e2120[10], _e2120[11], _e2120[12], _e2120[13], _e2120[14], _e2120[15]);
    } else {
        phi_2482_ = _e2120;
    }
    let _e2152 = phi_2482_;
    let _e2153 = (1024u + _e54);
    if (((_e65 * 2048u) + _e2153) < _e73) {
        let _e2158 = atomicLoad((&words[_e2153]));
        let _e2164 = starts[((_e2158 >> bitcast<u32>((_e70 & 31u))) & 255u)];
        let _e2165 = (_e2164 + _e2153);
        keys_out.member[_e2165] = _e2158;
        phi_2501_ = array<u32, 16>(_e2152[0], _e2152[1], _e2152[2], _e2152[3], _e2152[4], _e2152[5], _e2152[6], _e2152[7], _e2165, _e2152[9], _e2152[10], _e2152[11], _e2152[12], _e2152[13], _e2152[14], _e2152[15]);
    } else {
        phi_2501_ = _e2152;
    }
    let _e2184 = phi_2501_;
    let _e2185 = (1152u + _e54);
    if (((_e65 * 2048u) + _e2185) < _e73) {
        let _e2190 = atomicLoad((&words[_e2185]));
        let _e2196 = starts[((_e2190 >> bitcast<u32>((_e70 & 31u))) & 255u)];
        let _e2197 = (_e2196 + _e2185);
        keys_out.member[_e2197] = _e2190;
        phi_2520_ = array<u32, 16>(_e2184[0], _e2184[1], _e2184[2], _e2184[3], _e2184[4], _e2184[5], _e2184[6], _e2184[7], _e2184[8], _e2197, _e2184[10], _e2184[11], _e2184[12], _e2184[13], _e2184[14], _e2184[15]);
    } else {
        phi_2520_ = _e2184;
    }
    let _e2216 = phi_2520_;
    let _e2217 = (1280u + _e54);
    if (((_e65 * 2048u) + _e2217) < _e73) {
        let _e2222 = atomicLoad((&words[_e2217]));
        let _e2228 = starts[((_e2222 >> bitcast<u32>((_e70 & 31u))) & 255u)];
        let _e2229 = (_e2228 + _e2217);
        keys_out.member[_e2229] = _e2222;
        phi_2539_ = array<u32, 16>(_e2216[0], _e2216[1], _e2216[2], _e2216[3], _e2216[4], _e2216[5], _e2216[6], _e2216[7], _e2216[8], _e2216[9], _e2229, _e2216[11], _e2216[12], _e2216[13], _e2216[14], _e2216[15]);
    } else {
        phi_2539_ = _e2216;
    }
    let _e2248 = phi_2539_;
    let _e2249 = (1408u + _e54);
    if (((_e65 * 2048u) + _e2249) < _e73) {
        let _e2254 = atomicLoad((&words[_e2249]));
        let _e2260 = starts[((_e2254 >> bitcast<u32>((_e70 & 31u))) & 255u)];
        let _e2261 = (_e2260 + _e2249);
        keys_out.member[_e2261] = _e2254;
        phi_2558_ = array<u32, 16>(_e2248[0], _e2248[1], _e2248[2], _e2248[3], _e2248[4], _e2248[5], _e2248[6], _e2248[7], _e2248[8], _e2248[9], _e2248[10], _e2261, _e2248[12], _e2248[13], _e2248[14], _e2248[15]);
    } else {
        phi_2558_ = _e2248;
    }
    let _e2280 = phi_2558_;
    let _e2281 = (1536u + _e54);
    if (((_e65 * 2048u) + _e2281) < _e73) {
        let _e2286 = atomicLoad((&words[_e2281]));
        let _e2292 = starts[((_e2286 >> bitcast<u32>((_e70 & 31u))) & 255u)];
        let _e2293 = (_e2292 + _e2281);
        keys_out.member[_e2293] = _e2286;
        phi_2577_ = array<u32, 16>(_e2280[0], _e2280[1], _e2280[2], _e2280[3], _e2280[4], _e2280[5], _e2280[6], _e2280[7], _e2280[8], _e2280[9], _e2280[10], _e2280[11], _e2293, _e2280[13], _e2280[14], _e2280[15]);
    } else {
        phi_2577_ = _e2280;
    }
    let _e2312 = phi_2577_;
    let _e2313 = (1664u + _e54);
    if (((_e65 * 2048u) + _e2313) < _e73) {
        let _e2318 = atomicLoad((&words[_e2313]));
        let _e2324 = starts[((_e2318 >> bitcast<u32>((_e70 & 31u))) & 255u)];
        let _e2325 = (_e2324 + _e2313);
        keys_out.member[_e2325] = _e2318;
        phi_2596_ = array<u32, 16>(_e2312[0], _e2312[1], _e2312[2], _e2312[3], _e2312[4], _e2312[5], _e2312[6], _e2312[7], _e2312[8], _e2312[9], _e2312[10], _e2312[11], _e2312[12], _e2325, _e2312[14], _e2312[15]);
    } else {
        phi_2596_ = _e2312;
    }
    let _e2344 = phi_2596_;
    let _e2345 = (1792u + _e54);
    if (((_e65 * 2048u) + _e2345) < _e73) {
        let _e2350 = atomicLoad((&words[_e2345]));
        let _e2356 = starts[((_e2350 >> bitcast<u32>((_e70 & 31u))) & 255u)];
        let _e2357 = (_e2356 + _e2345);
        keys_out.member[_e2357] = _e2350;
        phi_2615_ = array<u32, 16>(_e2344[0], _e2344[1], _e2344[2], _e2344[3], _e2344[4], _e2344[5], _e2344[6], _e2344[7], _e2344[8], _e2344[9], _e2344[10], _e2344[11], _e2344[12], _e2344[13], _e2357, _e2344[15]);
    } else {
        phi_2615_ = _e2344;
    }
    let _e2376 = phi_2615_;
    let _e2377 = (1920u + _e54);
    if (((_e65 * 2048u) + _e2377) < _e73) {
        let _e2382 = atomicLoad((&words[_e2377]));
        let _e2388 = starts[((_e2382 >> bitcast<u32>((_e70 & 31u))) & 255u)];
        let _e2389 = (_e2388 + _e2377);
        keys_out.member[_e2389] = _e2382;
        phi_2634_ = array<u32, 16>(_e2376[0], _e2376[1], _e2376[2], _e2376[3], _e2376[4], _e2376[5], _e2376[6], _e2376[7], _e2376[8], _e2376[9], _e2376[10], _e2376[11], _e2376[12], _e2376[13], _e2376[14], _e2389);
    } else {
        phi_2634_ = _e2376;
    }
    let _e2408 = phi_2634_;
    workgroupBarrier();
    if (((_e65 * 2048u) + (((_e54 / 32u) * 512u) + (_e54 % 32u))) < _e73) {
        atomicStore((&words[_e1912[0]]), _e110);
    }
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 32u) + (_e54 % 32u))) < _e73) {
        atomicStore((&words[_e1912[1]]), _e122);
    }
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 64u) + (_e54 % 32u))) < _e73) {
        atomicStore((&words[_e1912[2]]), _e158);
    }
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 96u) + (_e54 % 32u))) < _e73) {
        atomicStore((&words[_e1912[3]]), _e170);
    }
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 128u) + (_e54 % 32u))) < _e73) {
        atomicStore((&words[_e1912[4]]), _e206);
    }
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 160u) + (_e54 % 32u))) < _e73) {
        atomicStore((&words[_e1912[5]]), _e218);
    }
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 192u) + (_e54 % 32u))) < _e73) {
        atomicStore((&words[_e1912[6]]), _e254);
    }
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 224u) + (_e54 % 32u))) < _e73) {
        atomicStore((&words[_e1912[7]]), _e266);
    }
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 256u) + (_e54 % 32u))) < _e73) {
        atomicStore((&words[_e1912[8]]), _e302);
    }
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 288u) + (_e54 % 32u))) < _e73) {
        atomicStore((&words[_e1912[9]]), _e314);
    }
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 320u) + (_e54 % 32u))) < _e73) {
        atomicStore((&words[_e1912[10]]), _e350);
    }
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 352u) + (_e54 % 32u))) < _e73) {
        atomicStore((&words[_e1912[11]]), _e362);
    }
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 384u) + (_e54 % 32u))) < _e73) {
        atomicStore((&words[_e1912[12]]), _e398);
    }
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 416u) + (_e54 % 32u))) < _e73) {
        atomicStore((&words[_e1912[13]]), _e410);
    }
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 448u) + (_e54 % 32u))) < _e73) {
        atomicStore((&words[_e1912[14]]), _e447);
    }
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 480u) + (_e54 % 32u))) < _e73) {
        atomicStore((&words[_e1912[15]]), _e459);
    }
    workgroupBarrier();
    if (((_e65 * 2048u) + _e54) < _e73) {
        let _e2573 = atomicLoad((&words[_e54]));
        values_out.member[_e2408[0]] = _e2573;
    }
    let _e2575 = (128u + _e54);
    if (((_e65 * 2048u) + _e2575) < _e73) {
        let _e2581 = atomicLoad((&words[_e2575]));
        values_out.member[_e2408[1]] = _e2581;
    }
    let _e2583 = (256u + _e54);
    if (((_e65 * 2048u) + _e2583) < _e73) {
        let _e2589 = atomicLoad((&words[_e2583]));
        values_out.member[_e2408[2]] = _e2589;
    }
    let _e2591 = (384u + _e54);
    if (((_e65 * 2048u) + _e2591) < _e73) {
        let _e2597 = atomicLoad((&words[_e2591]));
        values_out.member[_e2408[3]] = _e2597;
    }
    let _e2599 = (512u + _e54);
    if (((_e65 * 2048u) + _e2599) < _e73) {
        let _e2605 = atomicLoad((&words[_e2599]));
        values_out.member[_e2408[4]] = _e2605;
    }
    let _e2607 = (640u + _e54);
    if (((_e65 * 2048u) + _e2607) < _e73) {
        let _e2613 = atomicLoad((&words[_e2607]));
        values_out.member[_e2408[5]] = _e2613;
    }
    let _e2615 = (768u + _e54);
    if (((_e65 * 2048u) + _e2615) < _e73) {
        let _e2621 = atomicLoad((&words[_e2615]));
        values_out.member[_e2408[6]] = _e2621;
    }
    let _e2623 = (896u + _e54);
    if (((_e65 * 2048u) + _e2623) < _e73) {
        let _e2629 = atomicLoad((&words[_e2623]));
        values_out.member[_e2408[7]] = _e2629;
    }
    let _e2631 = (1024u + _e54);
    if (((_e65 * 2048u) + _e2631) < _e73) {
        let _e2637 = atomicLoad((&words[_e2631]));
        values_out.member[_e2408[8]] = _e2637;
    }
    let _e2639 = (1152u + _e54);
    if (((_e65 * 2048u) + _e2639) < _e73) {
        let _e2645 = atomicLoad((&words[_e2639]));
        values_out.member[_e2408[9]] = _e2645;
    }
    let _e2647 = (1280u + _e54);
    if (((_e65 * 2048u) + _e2647) < _e73) {
        let _e2653 = atomicLoad((&words[_e2647]));
        values_out.member[_e2408[10]] = _e2653;
    }
    let _e2655 = (1408u + _e54);
    if (((_e65 * 2048u) + _e2655) < _e73) {
        let _e2661 = atomicLoad((&words[_e2655]));
        values_out.member[_e2408[11]] = _e2661;
    }
    let _e2663 = (1536u + _e54);
    if (((_e65 * 2048u) + _e2663) < _e73) {
        let _e2669 = atomicLoad((&words[_e2663]));
        values_out.member[_e2408[12]] = _e2669;
    }
    let _e2671 = (1664u + _e54);
    if (((_e65 * 2048u) + _e2671) < _e73) {
        let _e2677 = atomicLoad((&words[_e2671]));
        values_out.member[_e2408[13]] = _e2677;
    }
    let _e2679 = (1792u + _e54);
    if (((_e65 * 2048u) + _e2679) < _e73) {
        let _e2685 = atomicLoad((&words[_e2679]));
        values_out.member[_e2408[14]] = _e2685;
    }
    let _e2687 = (1920u + _e54);
    if (((_e65 * 2048u) + _e2687) < _e73) {
        let _e2693 = atomicLoad((&words[_e2687]));
        values_out.member[_e2408[15]] = _e2693;
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn sort_scatter(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}

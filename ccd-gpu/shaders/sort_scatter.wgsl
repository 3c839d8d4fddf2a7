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
    var phi_859_: type_9;
    var phi_882_: type_9;
    var phi_1647_: type_9;
    var phi_1650_: u32;
    var phi_1652_: u32;
    var phi_1648_: type_9;
    var phi_1675_: type_9;
    var phi_1687_: type_9;
    var phi_1690_: u32;
    var phi_1688_: type_9;
    var phi_1713_: type_9;
    var phi_1691_: u32;
    var phi_1651_: u32;
    var phi_1653_: u32;
    var local: u32;
    var phi_1742_: type_9;
    var phi_1745_: u32;
    var phi_1747_: u32;
    var phi_1749_: u32;
    var phi_1746_: u32;
    var phi_1743_: type_9;
    var phi_1772_: type_9;
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
    var phi_1797_: type_9;
    var phi_1826_: type_9;
    var phi_1842_: u32;
    var phi_1802_: u32;
    var phi_1804_: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1849_: type_9;
    var phi_1852_: u32;
    var phi_1854_: u32;
    var phi_1850_: type_9;
    var phi_1877_: type_9;
    var phi_1903_: u32;
    var phi_1922_: type_9;
    var phi_1925_: u32;
    var phi_1923_: type_9;
    var phi_1948_: type_9;
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
        if (_e461.member < _e461.member_1) {
            phi_859_ = type_9((_e461.member + 1u), _e461.member_1);
            phi_882_ = type_9(1u, _e461.member);
        } else {
            phi_859_ = _e461;
            phi_882_ = type_9(0u, type_9().member_1);
        }
        let _e473 = phi_859_;
        let _e475 = phi_882_;
        let _e479 = (bitcast<i32>(_e475.member) != 0i);
        if _e479 {
            atomicStore((&words[((_e475.member_1 * 128u) + _e54)]), 0u);
            atomicStore((&words[((1024u + (_e475.member_1 * 128u)) + _e54)]), 0u);
            atomicStore((&counts[((_e475.member_1 * 128u) + _e54)]), 0u);
        }
        continue;
        continuing {
            phi_858_ = _e473;
            break if !(_e479);
        }
    }
    workgroupBarrier();
    let _e497 = (((_e65 * 2048u) + (((_e54 / 32u) * 512u) + (_e54 % 32u))) < _e73);
    let _e505 = (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 32u) + (_e54 % 32u))) < _e73);
    let _e510 = (_e67 + ((_e87 >> bitcast<u32>((_e70 & 31u))) & 255u));
    let _e515 = (_e67 + ((_e99 >> bitcast<u32>((_e70 & 31u))) & 255u));
    if _e497 {
        let _e521 = atomicOr((&words[_e510]), (1u << bitcast<u32>(((_e54 % 32u) & 31u))));
    }
    if _e505 {
        let _e528 = atomicOr((&words[(1024u + _e515)]), (1u << bitcast<u32>(((_e54 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e530 = atomicLoad((&words[_e510]));
    let _e533 = atomicLoad((&words[(1024u + _e515)]));
    let _e540 = countOneBits((_e530 & ((1u << bitcast<u32>(((_e54 % 32u) & 31u))) - 1u)));
    let _e547 = countOneBits((_e533 & ((1u << bitcast<u32>(((_e54 % 32u) & 31u))) - 1u)));
    let _e549 = atomicLoad((&counts[_e510]));
    let _e550 = (_e549 + _e540);
    let _e552 = atomicLoad((&counts[_e515]));
    let _e554 = atomicLoad((&words[_e515]));
    let _e557 = ((_e552 + countOneBits(_e554)) + _e547);
    workgroupBarrier();
    if _e497 {
        if (_e540 == 0u) {
            let _e561 = atomicAdd((&counts[_e510]), countOneBits(_e530));
            atomicStore((&words[_e510]), 0u);
        }
    }
    if _e505 {
        if (_e547 == 0u) {
            let _e566 = atomicAdd((&counts[_e515]), countOneBits(_e533));
            atomicStore((&words[(1024u + _e515)]), 0u);
        }
    }
    workgroupBarrier();
    let _e576 = (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 64u) + (_e54 % 32u))) < _e73);
    let _e584 = (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 96u) + (_e54 % 32u))) < _e73);
    let _e589 = (_e67 + ((_e134 >> bitcast<u32>((_e70 & 31u))) & 255u));
    let _e594 = (_e67 + ((_e146 >> bitcast<u32>((_e70 & 31u))) & 255u));
    if _e576 {
        let _e600 = atomicOr((&words[_e589]), (1u << bitcast<u32>(((_e54 % 32u) & 31u))));
    }
    if _e584 {
        let _e607 = atomicOr((&words[(1024u + _e594)]), (1u << bitcast<u32>(((_e54 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e609 = atomicLoad((&words[_e589]));
    let _e612 = atomicLoad((&words[(1024u + _e594)]));
    let _e619 = countOneBits((_e609 & ((1u << bitcast<u32>(((_e54 % 32u) & 31u))) - 1u)));
    let _e626 = countOneBits((_e612 & ((1u << bitcast<u32>(((_e54 % 32u) & 31u))) - 1u)));
    let _e628 = atomicLoad((&counts[_e589]));
    let _e629 = (_e628 + _e619);
    let _e631 = atomicLoad((&counts[_e594]));
    let _e633 = atomicLoad((&words[_e594]));
    let _e636 = ((_e631 + countOneBits(_e633)) + _e626);
    workgroupBarrier();
    if _e576 {
        if (_e619 == 0u) {
            let _e640 = atomicAdd((&counts[_e589]), countOneBits(_e609));
            atomicStore((&words[_e589]), 0u);
        }
    }
    if _e584 {
        if (_e626 == 0u) {
            let _e645 = atomicAdd((&counts[_e594]), countOneBits(_e612));
            atomicStore((&words[(1024u + _e594)]), 0u);
        }
    }
    workgroupBarrier();
    let _e655 = (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 128u) + (_e54 % 32u))) < _e73);
    let _e663 = (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 160u) + (_e54 % 32u))) < _e73);
    let _e668 = (_e67 + ((_e182 >> bitcast<u32>((_e70 & 31u))) & 255u));
    let _e673 = (_e67 + ((_e194 >> bitcast<u32>((_e70 & 31u))) & 255u));
    if _e655 {
        let _e679 = atomicOr((&words[_e668]), (1u << bitcast<u32>(((_e54 % 32u) & 31u))));
    }
    if _e663 {
        let _e686 = atomicOr((&words[(1024u + _e673)]), (1u << bitcast<u32>(((_e54 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e688 = atomicLoad((&words[_e668]));
    let _e691 = atomicLoad((&words[(1024u + _e673)]));
    let _e698 = countOneBits((_e688 & ((1u << bitcast<u32>(((_e54 % 32u) & 31u))) - 1u)));
    let _e705 = countOneBits((_e691 & ((1u << bitcast<u32>(((_e54 % 32u) & 31u))) - 1u)));
    let _e707 = atomicLoad((&counts[_e668]));
    let _e708 = (_e707 + _e698);
    let _e710 = atomicLoad((&counts[_e673]));
    let _e712 = atomicLoad((&words[_e673]));
    let _e715 = ((_e710 + countOneBits(_e712)) + _e705);
    workgroupBarrier();
    if _e655 {
        if (_e698 == 0u) {
            let _e719 = atomicAdd((&counts[_e668]), countOneBits(_e688));
            atomicStore((&words[_e668]), 0u);
        }
    }
    if _e663 {
        if (_e705 == 0u) {
            let _e724 = atomicAdd((&counts[_e673]), countOneBits(_e691));
            atomicStore((&words[(1024u + _e673)]), 0u);
        }
    }
    workgroupBarrier();
    let _e734 = (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 192u) + (_e54 % 32u))) < _e73);
    let _e742 = (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 224u) + (_e54 % 32u))) < _e73);
    let _e747 = (_e67 + ((_e230 >> bitcast<u32>((_e70 & 31u))) & 255u));
    let _e752 = (_e67 + ((_e242 >> bitcast<u32>((_e70 & 31u))) & 255u));
    if _e734 {
        let _e758 = atomicOr((&words[_e747]), (1u << bitcast<u32>(((_e54 % 32u) & 31u))));
    }
    if _e742 {
        let _e765 = atomicOr((&words[(1024u + _e752)]), (1u << bitcast<u32>(((_e54 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e767 = atomicLoad((&words[_e747]));
    let _e770 = atomicLoad((&words[(1024u + _e752)]));
    let _e777 = countOneBits((_e767 & ((1u << bitcast<u32>(((_e54 % 32u) & 31u))) - 1u)));
    let _e784 = countOneBits((_e770 & ((1u << bitcast<u32>(((_e54 % 32u) & 31u))) - 1u)));
    let _e786 = atomicLoad((&counts[_e747]));
    let _e787 = (_e786 + _e777);
    let _e789 = atomicLoad((&counts[_e752]));
    let _e791 = atomicLoad((&words[_e752]));
    let _e794 = ((_e789 + countOneBits(_e791)) + _e784);
    workgroupBarrier();
    if _e734 {
        if (_e777 == 0u) {
            let _e798 = atomicAdd((&counts[_e747]), countOneBits(_e767));
            atomicStore((&words[_e747]), 0u);
        }
    }
    if _e742 {
        if (_e784 == 0u) {
            let _e803 = atomicAdd((&counts[_e752]), countOneBits(_e770));
            atomicStore((&words[(1024u + _e752)]), 0u);
        }
    }
    workgroupBarrier();
    let _e813 = (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 256u) + (_e54 % 32u))) < _e73);
    let _e821 = (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 288u) + (_e54 % 32u))) < _e73);
    let _e826 = (_e67 + ((_e278 >> bitcast<u32>((_e70 & 31u))) & 255u));
    let _e831 = (_e67 + ((_e290 >> bitcast<u32>((_e70 & 31u))) & 255u));
    if _e813 {
        let _e837 = atomicOr((&words[_e826]), (1u << bitcast<u32>(((_e54 % 32u) & 31u))));
    }
    if _e821 {
        let _e844 = atomicOr((&words[(1024u + _e831)]), (1u << bitcast<u32>(((_e54 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e846 = atomicLoad((&words[_e826]));
    let _e849 = atomicLoad((&words[(1024u + _e831)]));
    let _e856 = countOneBits((_e846 & ((1u << bitcast<u32>(((_e54 % 32u) & 31u))) - 1u)));
    let _e863 = countOneBits((_e849 & ((1u << bitcast<u32>(((_e54 % 32u) & 31u))) - 1u)));
    let _e865 = atomicLoad((&counts[_e826]));
    let _e866 = (_e865 + _e856);
    let _e868 = atomicLoad((&counts[_e831]));
    let _e870 = atomicLoad((&words[_e831]));
    let _e873 = ((_e868 + countOneBits(_e870)) + _e863);
    workgroupBarrier();
    if _e813 {
        if (_e856 == 0u) {
            let _e877 = atomicAdd((&counts[_e826]), countOneBits(_e846));
            atomicStore((&words[_e826]), 0u);
        }
    }
    if _e821 {
        if (_e863 == 0u) {
            let _e882 = atomicAdd((&counts[_e831]), countOneBits(_e849));
            atomicStore((&words[(1024u + _e831)]), 0u);
        }
    }
    workgroupBarrier();
    let _e892 = (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 320u) + (_e54 % 32u))) < _e73);
    let _e900 = (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 352u) + (_e54 % 32u))) < _e73);
    let _e905 = (_e67 + ((_e326 >> bitcast<u32>((_e70 & 31u))) & 255u));
    let _e910 = (_e67 + ((_e338 >> bitcast<u32>((_e70 & 31u))) & 255u));
    if _e892 {
        let _e916 = atomicOr((&words[_e905]), (1u << bitcast<u32>(((_e54 % 32u) & 31u))));
    }
    if _e900 {
        let _e923 = atomicOr((&words[(1024u + _e910)]), (1u << bitcast<u32>(((_e54 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e925 = atomicLoad((&words[_e905]));
    let _e928 = atomicLoad((&words[(1024u + _e910)]));
    let _e935 = countOneBits((_e925 & ((1u << bitcast<u32>(((_e54 % 32u) & 31u))) - 1u)));
    let _e942 = countOneBits((_e928 & ((1u << bitcast<u32>(((_e54 % 32u) & 31u))) - 1u)));
    let _e944 = atomicLoad((&counts[_e905]));
    let _e945 = (_e944 + _e935);
    let _e947 = atomicLoad((&counts[_e910]));
    let _e949 = atomicLoad((&words[_e910]));
    let _e952 = ((_e947 + countOneBits(_e949)) + _e942);
    workgroupBarrier();
    if _e892 {
        if (_e935 == 0u) {
            let _e956 = atomicAdd((&counts[_e905]), countOneBits(_e925));
            atomicStore((&words[_e905]), 0u);
        }
    }
    if _e900 {
        if (_e942 == 0u) {
            let _e961 = atomicAdd((&counts[_e910]), countOneBits(_e928));
            atomicStore((&words[(1024u + _e910)]), 0u);
        }
    }
    workgroupBarrier();
    let _e971 = (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 384u) + (_e54 % 32u))) < _e73);
    let _e979 = (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 416u) + (_e54 % 32u))) < _e73);
    let _e984 = (_e67 + ((_e374 >> bitcast<u32>((_e70 & 31u))) & 255u));
    let _e989 = (_e67 + ((_e386 >> bitcast<u32>((_e70 & 31u))) & 255u));
    if _e971 {
        let _e995 = atomicOr((&words[_e984]), (1u << bitcast<u32>(((_e54 % 32u) & 31u))));
    }
    if _e979 {
        let _e1002 = atomicOr((&words[(1024u + _e989)]), (1u << bitcast<u32>(((_e54 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e1004 = atomicLoad((&words[_e984]));
    let _e1007 = atomicLoad((&words[(1024u + _e989)]));
    let _e1014 = countOneBits((_e1004 & ((1u << bitcast<u32>(((_e54 % 32u) & 31u))) - 1u)));
    let _e1021 = countOneBits((_e1007 & ((1u << bitcast<u32>(((_e54 % 32u) & 31u))) - 1u)));
    let _e1023 = atomicLoad((&counts[_e984]));
    let _e1024 = (_e1023 + _e1014);
    let _e1026 = atomicLoad((&counts[_e989]));
    let _e1028 = atomicLoad((&words[_e989]));
    let _e1031 = ((_e1026 + countOneBits(_e1028)) + _e1021);
    workgroupBarrier();
    if _e971 {
        if (_e1014 == 0u) {
            let _e1035 = atomicAdd((&counts[_e984]), countOneBits(_e1004));
            atomicStore((&words[_e984]), 0u);
        }
    }
    if _e979 {
        if (_e1021 == 0u) {
            let _e1040 = atomicAdd((&counts[_e989]), countOneBits(_e1007));
            atomicStore((&words[(1024u + _e989)]), 0u);
        }
    }
    workgroupBarrier();
    let _e1050 = (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 448u) + (_e54 % 32u))) < _e73);
    let _e1058 = (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 480u) + (_e54 % 32u))) < _e73);
    let _e1063 = (_e67 + ((_e422 >> bitcast<u32>((_e70 & 31u))) & 255u));
    let _e1068 = (_e67 + ((_e434 >> bitcast<u32>((_e70 & 31u))) & 255u));
    if _e1050 {
        let _e1074 = atomicOr((&words[_e1063]), (1u << bitcast<u32>(((_e54 % 32u) & 31u))));
    }
    if _e1058 {
        let _e1081 = atomicOr((&words[(1024u + _e1068)]), (1u << bitcast<u32>(((_e54 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e1083 = atomicLoad((&words[_e1063]));
    let _e1086 = atomicLoad((&words[(1024u + _e1068)]));
    let _e1093 = countOneBits((_e1083 & ((1u << bitcast<u32>(((_e54 % 32u) & 31u))) - 1u)));
    let _e1100 = countOneBits((_e1086 & ((1u << bitcast<u32>(((_e54 % 32u) & 31u))) - 1u)));
    let _e1102 = atomicLoad((&counts[_e1063]));
    let _e1103 = (_e1102 + _e1093);
    let _e1105 = atomicLoad((&counts[_e1068]));
    let _e1107 = atomicLoad((&words[_e1068]));
    let _e1110 = ((_e1105 + countOneBits(_e1107)) + _e1100);
    workgroupBarrier();
    if _e1050 {
        if (_e1093 == 0u) {
            let _e1115 = atomicAdd((&counts[_e1063]), countOneBits(_e1083));
            atomicStore((&words[_e1063]), 0u);
        }
    }
    if _e1058 {
        if (_e1100 == 0u) {
            let _e1120 = atomicAdd((&counts[_e1068]), countOneBits(_e1086));
            atomicStore((&words[(1024u + _e1068)]), 0u);
        }
    }
    workgroupBarrier();
    phi_1647_ = type_9(0u, 2u);
    phi_1650_ = 0u;
    phi_1652_ = 0u;
    loop {
        let _e1124 = phi_1647_;
        let _e1126 = phi_1650_;
        let _e1128 = phi_1652_;
        local = _e1128;
        local_7 = _e1128;
        local_2 = _e1128;
        local_3 = _e1126;
        local_8 = _e1126;
        local_5 = _e1126;
        if (_e1124.member < _e1124.member_1) {
            phi_1648_ = type_9((_e1124.member + 1u), _e1124.member_1);
            phi_1675_ = type_9(1u, _e1124.member);
        } else {
            phi_1648_ = _e1124;
            phi_1675_ = type_9(0u, type_9().member_1);
        }
        let _e1140 = phi_1648_;
        let _e1142 = phi_1675_;
        let _e1146 = (bitcast<i32>(_e1142.member) != 0i);
        if _e1146 {
            let _e1148 = ((2u * _e54) + _e1142.member_1);
            phi_1687_ = type_9(0u, 4u);
            phi_1690_ = _e1128;
            loop {
                let _e1150 = phi_1687_;
                let _e1152 = phi_1690_;
                local_6 = _e1152;
                if (_e1150.member < _e1150.member_1) {
                    phi_1688_ = type_9((_e1150.member + 1u), _e1150.member_1);
                    phi_1713_ = type_9(1u, _e1150.member);
                } else {
                    phi_1688_ = _e1150;
                    phi_1713_ = type_9(0u, type_9().member_1);
                }
                let _e1164 = phi_1688_;
                let _e1166 = phi_1713_;
                let _e1170 = (bitcast<i32>(_e1166.member) != 0i);
                if _e1170 {
                    let _e1174 = atomicLoad((&counts[((_e1166.member_1 * 256u) + _e1148)]));
                    phi_1691_ = (_e1152 + _e1174);
                } else {
                    phi_1691_ = u32();
                }
                let _e1177 = phi_1691_;
                continue;
                continuing {
                    phi_1687_ = _e1164;
                    phi_1690_ = _e1177;
                    break if !(_e1170);
                }
            }
            let _e1182 = table.member[((256u * _e76) + _e1148)];
            phi_1651_ = (_e1126 + _e1182);
            let _e2759 = local_6;
            phi_1653_ = _e2759;
        } else {
            phi_1651_ = u32();
            phi_1653_ = u32();
        }
        let _e1185 = phi_1651_;
        let _e1187 = phi_1653_;
        continue;
        continuing {
            phi_1647_ = _e1140;
            phi_1650_ = _e1185;
            phi_1652_ = _e1187;
            break if !(_e1146);
        }
    }
    let _e1191 = local;
    atomicStore((&words[_e54]), _e1191);
    phi_1742_ = type_9(0u, 7u);
    phi_1745_ = 0u;
    phi_1747_ = 1u;
    let _e2766 = local_7;
    phi_1749_ = _e2766;
    phi_1746_ = 1024u;
    loop {
        let _e1193 = phi_1742_;
        let _e1195 = phi_1745_;
        let _e1197 = phi_1747_;
        let _e1199 = phi_1749_;
        let _e1201 = phi_1746_;
        local_1 = _e1199;
        if (_e1193.member < _e1193.member_1) {
            phi_1743_ = type_9((_e1193.member + 1u), _e1193.member_1);
            phi_1772_ = type_9(1u, _e1193.member);
        } else {
            phi_1743_ = _e1193;
            phi_1772_ = type_9(0u, type_9().member_1);
        }
        let _e1213 = phi_1743_;
        let _e1215 = phi_1772_;
        let _e1218 = (bitcast<i32>(_e1215.member) != 0i);
        if _e1218 {
            workgroupBarrier();
            if (_e54 >= _e1197) {
                let _e1223 = atomicLoad((&words[((_e1195 + _e54) - _e1197)]));
                phi_1788_ = (_e1199 + _e1223);
            } else {
                phi_1788_ = _e1199;
            }
            let _e1226 = phi_1788_;
            atomicStore((&words[(_e1201 + _e54)]), _e1226);
            phi_1748_ = (_e1197 * 2u);
            phi_1750_ = _e1226;
        } else {
            phi_1748_ = u32();
            phi_1750_ = u32();
        }
        let _e1231 = phi_1748_;
        let _e1233 = phi_1750_;
        continue;
        continuing {
            phi_1742_ = _e1213;
            phi_1745_ = _e1201;
            phi_1747_ = _e1231;
            phi_1749_ = _e1233;
            phi_1746_ = _e1195;
            break if !(_e1218);
        }
    }
    workgroupBarrier();
    let _e1236 = local_1;
    let _e1238 = local_2;
    let _e1242 = local_3;
    atomicStore((&words[_e54]), _e1242);
    phi_1796_ = type_9(0u, 7u);
    phi_1799_ = 0u;
    phi_1801_ = 1u;
    let _e2781 = local_8;
    phi_1803_ = _e2781;
    phi_1800_ = 1024u;
    loop {
        let _e1244 = phi_1796_;
        let _e1246 = phi_1799_;
        let _e1248 = phi_1801_;
        let _e1250 = phi_1803_;
        let _e1252 = phi_1800_;
        local_4 = _e1250;
        if (_e1244.member < _e1244.member_1) {
            phi_1797_ = type_9((_e1244.member + 1u), _e1244.member_1);
            phi_1826_ = type_9(1u, _e1244.member);
        } else {
            phi_1797_ = _e1244;
            phi_1826_ = type_9(0u, type_9().member_1);
        }
        let _e1264 = phi_1797_;
        let _e1266 = phi_1826_;
        let _e1269 = (bitcast<i32>(_e1266.member) != 0i);
        if _e1269 {
            workgroupBarrier();
            if (_e54 >= _e1248) {
                let _e1274 = atomicLoad((&words[((_e1246 + _e54) - _e1248)]));
                phi_1842_ = (_e1250 + _e1274);
            } else {
                phi_1842_ = _e1250;
            }
            let _e1277 = phi_1842_;
            atomicStore((&words[(_e1252 + _e54)]), _e1277);
            phi_1802_ = (_e1248 * 2u);
            phi_1804_ = _e1277;
        } else {
            phi_1802_ = u32();
            phi_1804_ = u32();
        }
        let _e1282 = phi_1802_;
        let _e1284 = phi_1804_;
        continue;
        continuing {
            phi_1796_ = _e1264;
            phi_1799_ = _e1252;
            phi_1801_ = _e1282;
            phi_1803_ = _e1284;
            phi_1800_ = _e1246;
            break if !(_e1269);
        }
    }
    workgroupBarrier();
    let _e1287 = local_4;
    let _e1289 = local_5;
    phi_1849_ = type_9(0u, 2u);
    phi_1852_ = (_e1287 - _e1289);
    phi_1854_ = (_e1236 - _e1238);
    loop {
        let _e1292 = phi_1849_;
        let _e1294 = phi_1852_;
        let _e1296 = phi_1854_;
        if (_e1292.member < _e1292.member_1) {
            phi_1850_ = type_9((_e1292.member + 1u), _e1292.member_1);
            phi_1877_ = type_9(1u, _e1292.member);
        } else {
            phi_1850_ = _e1292;
            phi_1877_ = type_9(0u, type_9().member_1);
        }
        let _e1308 = phi_1850_;
        let _e1310 = phi_1877_;
        let _e1314 = (bitcast<i32>(_e1310.member) != 0i);
        if _e1314 {
            let _e1316 = ((2u * _e54) + _e1310.member_1);
            if (_e65 < _e76) {
                let _e1321 = table.member[((_e1316 * _e76) + _e65)];
                phi_1903_ = _e1321;
            } else {
                phi_1903_ = 0u;
            }
            let _e1323 = phi_1903_;
            starts[_e1316] = ((_e1294 + _e1323) - _e1296);
            let _e1330 = table.member[((256u * _e76) + _e1316)];
            phi_1922_ = type_9(0u, 4u);
            phi_1925_ = _e1296;
            loop {
                let _e1333 = phi_1922_;
                let _e1335 = phi_1925_;
                local_9 = _e1335;
                if (_e1333.member < _e1333.member_1) {
                    phi_1923_ = type_9((_e1333.member + 1u), _e1333.member_1);
                    phi_1948_ = type_9(1u, _e1333.member);
                } else {
                    phi_1923_ = _e1333;
                    phi_1948_ = type_9(0u, type_9().member_1);
                }
                let _e1347 = phi_1923_;
                let _e1349 = phi_1948_;
                let _e1353 = (bitcast<i32>(_e1349.member) != 0i);
                if _e1353 {
                    let _e1357 = atomicLoad((&counts[((_e1349.member_1 * 256u) + _e1316)]));
                    atomicStore((&counts[((_e1349.member_1 * 256u) + _e1316)]), _e1335);
                    phi_1926_ = (_e1335 + _e1357);
                } else {
                    phi_1926_ = u32();
                }
                let _e1363 = phi_1926_;
                continue;
                continuing {
                    phi_1922_ = _e1347;
                    phi_1925_ = _e1363;
                    break if !(_e1353);
                }
            }
            phi_1853_ = (_e1294 + _e1330);
            let _e2804 = local_9;
            phi_1855_ = _e2804;
        } else {
            phi_1853_ = u32();
            phi_1855_ = u32();
        }
        let _e1366 = phi_1853_;
        let _e1368 = phi_1855_;
        continue;
        continuing {
            phi_1849_ = _e1308;
            phi_1852_ = _e1366;
            phi_1854_ = _e1368;
            break if !(_e1314);
        }
    }
    workgroupBarrier();
    if (((_e65 * 2048u) + (((_e54 / 32u) * 512u) + (_e54 % 32u))) < _e73) {
        let _e1383 = atomicLoad((&counts[(_e67 + ((_e87 >> bitcast<u32>((_e70 & 31u))) & 255u))]));
        let _e1384 = (_e550 + _e1383);
        atomicStore((&words[_e1384]), _e87);
        phi_1985_ = array<u32, 16>(_e1384, _e557, _e629, _e636, _e708, _e715, _e787, _e794, _e866, _e873, _e945, _e952, _e1024, _e1031, _e1103, _e1110);
    } else {
        phi_1985_ = array<u32, 16>(_e550, _e557, _e629, _e636, _e708, _e715, _e787, _e794, _e866, _e873, _e945, _e952, _e1024, _e1031, _e1103, _e1110);
    }
    let _e1388 = phi_1985_;
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 32u) + (_e54 % 32u))) < _e73) {
        let _e1403 = atomicLoad((&counts[(_e67 + ((_e99 >> bitcast<u32>((_e70 & 31u))) & 255u))]));
        let _e1405 = (_e1388[1] + _e1403);
        atomicStore((&words[_e1405]), _e99);
        phi_2008_ = array<u32, 16>(_e1388[0], _e1405, _e1388[2], _e1388[3], _e1388[4], _e1388[5], _e1388[6], _e1388[7], _e1388[8], _e1388[9], _e1388[10], _e1388[11], _e1388[12], _e1388[13], _e1388[14], _e1388[15]);
    } else {
        phi_2008_ = _e1388;
    }
    let _e1424 = phi_2008_;
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 64u) + (_e54 % 32u))) < _e73) {
        let _e1439 = atomicLoad((&counts[(_e67 + ((_e134 >> bitcast<u32>((_e70 & 31u))) & 255u))]));
        let _e1441 = (_e1424[2] + _e1439);
        atomicStore((&words[_e1441]), _e134);
        phi_2031_ = array<u32, 16>(_e1424[0], _e1424[1], _e1441, _e1424[3], _e1424[4], _e1424[5], _e1424[6], _e1424[7], _e1424[8], _e1424[9], _e1424[10], _e1424[11], _e1424[12], _e1424[13], _e1424[14], _e1424[15]);
    } else {
        phi_2031_ = _e1424;
    }
    let _e1460 = phi_2031_;
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 96u) + (_e54 % 32u))) < _e73) {
        let _e1475 = atomicLoad((&counts[(_e67 + ((_e146 >> bitcast<u32>((_e70 & 31u))) & 255u))]));
        let _e1477 = (_e1460[3] + _e1475);
        atomicStore((&words[_e1477]), _e146);
        phi_2054_ = array<u32, 16>(_e1460[0], _e1460[1], _e1460[2], _e1477, _e1460[4], _e1460[5], _e1460[6], _e1460[7], _e1460[8], _e1460[9], _e1460[10], _e1460[11], _e1460[12], _e1460[13], _e1460[14], _e1460[15]);
    } else {
        phi_2054_ = _e1460;
    }
    let _e1496 = phi_2054_;
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 128u) + (_e54 % 32u))) < _e73) {
        let _e1511 = atomicLoad((&counts[(_e67 + ((_e182 >> bitcast<u32>((_e70 & 31u))) & 255u))]));
        let _e1513 = (_e1496[4] + _e1511);
        atomicStore((&words[_e1513]), _e182);
        phi_2077_ = array<u32, 16>(_e1496[0], _e1496[1], _e1496[2], _e1496[3], _e1513, _e1496[5], _e1496[6], _e1496[7], _e1496[8], _e1496[9], _e1496[10], _e1496[11], _e1496[12], _e1496[13], _e1496[14], _e1496[15]);
    } else {
        phi_2077_ = _e1496;
    }
    let _e1532 = phi_2077_;
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 160u) + (_e54 % 32u))) < _e73) {
        let _e1547 = atomicLoad((&counts[(_e67 + ((_e194 >> bitcast<u32>((_e70 & 31u))) & 255u))]));
        let _e1549 = (_e1532[5] + _e1547);
        atomicStore((&words[_e1549]), _e194);
        phi_2100_ = array<u32, 16>(_e1532[0], _e1532[1], _e1532[2], _e1532[3], _e1532[4], _e1549, _e1532[6], _e1532[7], _e1532[8], _e1532[9], _e1532[10], _e1532[11], _e1532[12], _e1532[13], _e1532[14], _e1532[15]);
    } else {
        phi_2100_ = _e1532;
    }
    let _e1568 = phi_2100_;
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 192u) + (_e54 % 32u))) < _e73) {
        let _e1583 = atomicLoad((&counts[(_e67 + ((_e230 >> bitcast<u32>((_e70 & 31u))) & 255u))]));
        let _e1585 = (_e1568[6] + _e1583);
        atomicStore((&words[_e1585]), _e230);
        phi_2123_ = array<u32, 16>(_e1568[0], _e1568[1], _e1568[2], _e1568[3], _e1568[4], _e1568[5], _e1585, _e1568[7], _e1568[8], _e1568[9], _e1568[10], _e1568[11], _e1568[12], _e1568[13], _e1568[14], _e1568[15]);
    } else {
        phi_2123_ = _e1568;
    }
    let _e1604 = phi_2123_;
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 224u) + (_e54 % 32u))) < _e73) {
        let _e1619 = atomicLoad((&counts[(_e67 + ((_e242 >> bitcast<u32>((_e70 & 31u))) & 255u))]));
        let _e1621 = (_e1604[7] + _e1619);
        atomicStore((&words[_e1621]), _e242);
        phi_2146_ = array<u32, 16>(_e1604[0], _e1604[1], _e1604[2], _e1604[3], _e1604[4], _e1604[5], _e1604[6], _e1621, _e1604[8], _e1604[9], _e1604[10], _e1604[11], _e1604[12], _e1604[13], _e1604[14], _e1604[15]);
    } else {
        phi_2146_ = _e1604;
    }
    let _e1640 = phi_2146_;
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 256u) + (_e54 % 32u))) < _e73) {
        let _e1655 = atomicLoad((&counts[(_e67 + ((_e278 >> bitcast<u32>((_e70 & 31u))) & 255u))]));
        let _e1657 = (_e1640[8] + _e1655);
        atomicStore((&words[_e1657]), _e278);
        phi_2169_ = array<u32, 16>(_e1640[0], _e1640[1], _e1640[2], _e1640[3], _e1640[4], _e1640[5], _e1640[6], _e1640[7], _e1657, _e1640[9], _e1640[10], _e1640[11], _e1640[12], _e1640[13], _e1640[14], _e1640[15]);
    } else {
        phi_2169_ = _e1640;
    }
    let _e1676 = phi_2169_;
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 288u) + (_e54 % 32u))) < _e73) {
        let _e1691 = atomicLoad((&counts[(_e67 + ((_e290 >> bitcast<u32>((_e70 & 31u))) & 255u))]));
        let _e1693 = (_e1676[9] + _e1691);
        atomicStore((&words[_e1693]), _e290);
        phi_2192_ = array<u32, 16>(_e1676[0], _e1676[1], _e1676[2], _e1676[3], _e1676[4], _e1676[5], _e1676[6], _e1676[7], _e1676[8], _e1693, _e1676[10], _e1676[11], _e1676[12], _e1676[13], _e1676[14], _e1676[15]);
    } else {
        phi_2192_ = _e1676;
    }
    let _e1712 = phi_2192_;
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 320u) + (_e54 % 32u))) < _e73) {
        let _e1727 = atomicLoad((&counts[(_e67 + ((_e326 >> bitcast<u32>((_e70 & 31u))) & 255u))]));
        let _e1729 = (_e1712[10] + _e1727);
        atomicStore((&words[_e1729]), _e326);
        phi_2215_ = array<u32, 16>(_e1712[0], _e1712[1], _e1712[2], _e1712[3], _e1712[4], _e1712[5], _e1712[6], _e1712[7], _e1712[8], _e1712[9], _e1729, _e1712[11], _e1712[12], _e1712[13], _e1712[14], _e1712[15]);
    } else {
        phi_2215_ = _e1712;
    }
    let _e1748 = phi_2215_;
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 352u) + (_e54 % 32u))) < _e73) {
        let _e1763 = atomicLoad((&counts[(_e67 + ((_e338 >> bitcast<u32>((_e70 & 31u))) & 255u))]));
        let _e1765 = (_e1748[11] + _e1763);
        atomicStore((&words[_e1765]), _e338);
        phi_2238_ = array<u32, 16>(_e1748[0], _e1748[1], _e1748[2], _e1748[3], _e1748[4], _e1748[5], _e1748[6], _e1748[7], _e1748[8], _e1748[9], _e1748[10], _e1765, _e1748[12], _e1748[13], _e1748[14], _e1748[15]);
    } else {
        phi_2238_ = _e1748;
    }
    let _e1784 = phi_2238_;
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 384u) + (_e54 % 32u))) < _e73) {
        let _e1799 = atomicLoad((&counts[(_e67 + ((_e374 >> bitcast<u32>((_e70 & 31u))) & 255u))]));
        let _e1801 = (_e1784[12] + _e1799);
        atomicStore((&words[_e1801]), _e374);
        phi_2261_ = array<u32, 16>(_e1784[0], _e1784[1], _e1784[2], _e1784[3], _e1784[4], _e1784[5], _e1784[6], _e1784[7], _e1784[8], _e1784[9], _e1784[10], _e1784[11], _e1801, _e1784[13], _e1784[14], _e1784[15]);
    } else {
        phi_2261_ = _e1784;
    }
    let _e1820 = phi_2261_;
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 416u) + (_e54 % 32u))) < _e73) {
        let _e1835 = atomicLoad((&counts[(_e67 + ((_e386 >> bitcast<u32>((_e70 & 31u))) & 255u))]));
        let _e1837 = (_e1820[13] + _e1835);
        atomicStore((&words[_e1837]), _e386);
        phi_2284_ = array<u32, 16>(_e1820[0], _e1820[1], _e1820[2], _e1820[3], _e1820[4], _e1820[5], _e1820[6], _e1820[7], _e1820[8], _e1820[9], _e1820[10], _e1820[11], _e1820[12], _e1837, _e1820[14], _e1820[15]);
    } else {
        phi_2284_ = _e1820;
    }
    let _e1856 = phi_2284_;
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 448u) + (_e54 % 32u))) < _e73) {
        let _e1871 = atomicLoad((&counts[(_e67 + ((_e422 >> bitcast<u32>((_e70 & 31u))) & 255u))]));
        let _e1873 = (_e1856[14] + _e1871);
        atomicStore((&words[_e1873]), _e422);
        phi_2307_ = array<u32, 16>(_e1856[0], _e1856[1], _e1856[2], _e1856[3], _e1856[4], _e1856[5], _e1856[6], _e1856[7], _e1856[8], _e1856[9], _e1856[10], _e1856[11], _e1856[12], _e1856[13], _e1873, _e1856[15]);
    } else {
        phi_2307_ = _e1856;
    }
    let _e1892 = phi_2307_;
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 480u) + (_e54 % 32u))) < _e73) {
        let _e1907 = atomicLoad((&counts[(_e67 + ((_e434 >> bitcast<u32>((_e70 & 31u))) & 255u))]));
        let _e1909 = (_e1892[15] + _e1907);
        atomicStore((&words[_e1909]), _e434);
        phi_2330_ = array<u32, 16>(_e1892[0], _e1892[1], _e1892[2], _e1892[3], _e1892[4], _e1892[5], _e1892[6], _e1892[7], _e1892[8], _e1892[9], _e1892[10], _e1892[11], _e1892[12], _e1892[13], _e1892[14], _e1909);
    } else {
        phi_2330_ = _e1892;
    }
    let _e1928 = phi_2330_;
    workgroupBarrier();
    if (((_e65 * 2048u) + _e54) < _e73) {
        let _e1933 = atomicLoad((&words[_e54]));
        let _e1939 = starts[((_e1933 >> bitcast<u32>((_e70 & 31u))) & 255u)];
        let _e1940 = (_e1939 + _e54);
        keys_out.member[_e1940] = _e1933;
        phi_2349_ = array<u32, 16>(_e1940, _e99, _e134, _e146, _e182, _e194, _e230, _e242, _e278, _e290, _e326, _e338, _e374, _e386, _e422, _e434);
    } else {
        phi_2349_ = array<u32, 16>(_e87, _e99, _e134, _e146, _e182, _e194, _e230, _e242, _e278, _e290, _e326, _e338, _e374, _e386, _e422, _e434);
    }
    let _e1944 = phi_2349_;
    let _e1945 = (128u + _e54);
    if (((_e65 * 2048u) + _e1945) < _e73) {
        let _e1950 = atomicLoad((&words[_e1945]));
        let _e1956 = starts[((_e1950 >> bitcast<u32>((_e70 & 31u))) & 255u)];
        let _e1957 = (_e1956 + _e1945);
        keys_out.member[_e1957] = _e1950;
        phi_2368_ = array<u32, 16>(_e1944[0], _e1957, _e1944[2], _e1944[3], _e1944[4], _e1944[5], _e1944[6], _e1944[7], _e1944[8], _e1944[9], _e1944[10], _e1944[11], _e1944[12], _e1944[13], _e1944[14], _e1944[15]);
    } else {
        phi_2368_ = _e1944;
    }
    let _e1976 = phi_2368_;
    let _e1977 = (256u + _e54);
    if (((_e65 * 2048u) + _e1977) < _e73) {
        let _e1982 = atomicLoad((&words[_e1977]));
        let _e1988 = starts[((_e1982 >> bitcast<u32>((_e70 & 31u))) & 255u)];
        let _e1989 = (_e1988 + _e1977);
        keys_out.member[_e1989] = _e1982;
        phi_2387_ = array<u32, 16>(_e1976[0], _e1976[1], _e1989, _e1976[3], _e1976[4], _e1976[5], _e1976[6], _e1976[7], _e1976[8], _e1976[9], _e1976[10], _e1976[11], _e1976[12], _e1976[13], _e1976[14], _e1976[15]);
    } else {
        phi_2387_ = _e1976;
    }
    let _e2008 = phi_2387_;
    let _e2009 = (384u + _e54);
    if (((_e65 * 2048u) + _e2009) < _e73) {
        let _e2014 = atomicLoad((&words[_e2009]));
        let _e2020 = starts[((_e2014 >> bitcast<u32>((_e70 & 31u))) & 255u)];
        let _e2021 = (_e2020 + _e2009);
        keys_out.member[_e2021] = _e2014;
        phi_2406_ = array<u32, 16>(_e2008[0], _e2008[1], _e2008[2], _e2021, _e2008[4], _e2008[5], _e2008[6], _e2008[7], _e2008[8], _e2008[9], _e2008[10], _e2008[11], _e2008[12], _e2008[13], _e2008[14], _e2008[15]);
    } else {
        phi_2406_ = _e2008;
    }
    let _e2040 = phi_2406_;
    let _e2041 = (512u + _e54);
    if (((_e65 * 2048u) + _e2041) < _e73) {
        let _e2046 = atomicLoad((&words[_e2041]));
        let _e2052 = starts[((_e2046 >> bitcast<u32>((_e70 & 31u))) & 255u)];
        let _e2053 = (_e2052 + _e2041);
        keys_out.member[_e2053] = _e2046;
        phi_2425_ = array<u32, 16>(_e2040[0], _e2040[1], _e2040[2], _e2040[3], _e2053, _e2040[5], _e2040[6], _e2040[7], _e2040[8], _e2040[9], _e2040[10], _e2040[11], _e2040[12], _e2040[13], _e2040[14], _e2040[15]);
    } else {
        phi_2425_ = _e2040;
    }
    let _e2072 = phi_2425_;
    let _e2073 = (640u + _e54);
    if (((_e65 * 2048u) + _e2073) < _e73) {
        let _e2078 = atomicLoad((&words[_e2073]));
        let _e2084 = starts[((_e2078 >> bitcast<u32>((_e70 & 31u))) & 255u)];
        let _e2085 = (_e2084 + _e2073);
        keys_out.member[_e2085] = _e2078;
        phi_2444_ = array<u32, 16>(_e2072[0], _e2072[1], _e2072[2], _e2072[3], _e2072[4], _e2085, _e2072[6], _e2072[7], _e2072[8], _e2072[9], _e2072[10], _e2072[11], _e2072[12], _e2072[13], _e2072[14], _e2072[15]);
    } else {
        phi_2444_ = _e2072;
    }
    let _e2104 = phi_2444_;
    let _e2105 = (768u + _e54);
    if (((_e65 * 2048u) + _e2105) < _e73) {
        let _e2110 = atomicLoad((&words[_e2105]));
        let _e2116 = starts[((_e2110 >> bitcast<u32>((_e70 & 31u))) & 255u)];
        let _e2117 = (_e2116 + _e2105);
        keys_out.member[_e2117] = _e2110;
        phi_2463_ = array<u32, 16>(_e2104[0], _e2104[1], _e2104[2], _e2104[3], _e2104[4], _e2104[5], _e2117, _e2104[7], _e2104[8], _e2104[9], _e2104[10], _e2104[11], _e2104[12], _e2104[13], _e2104[14], _e2104[15]);
    } else {
        phi_2463_ = _e2104;
    }
    let _e2136 = phi_2463_;
    let _e2137 = (896u + _e54);
    if (((_e65 * 2048u) + _e2137) < _e73) {
        let _e2142 = atomicLoad((&words[_e2137]));
        let _e2148 = starts[((_e2142 >> bitcast<u32>((_e70 & 31u))) & 255u)];
        let _e2149 = (_e2148 + _e2137);
        keys_out.member[_e2149] = _e2142;
        phi_2482_ = array<u32, 16>(_e2136[0], _e2136[1], _e2136[2], _e2136[3], _e2136[4], _e2136[5], _e2136[6], _e2149, _e2136[8], _e2136[9], _e2136[10], _e2136[11], _e2136[12], _e2136[13], _e2136[14], _e2136[15]);
    } else {
        phi_2482_ = _e2136;
    }
    let _e2168 = phi_2482_;
    let _e2169 = (1024u + _e54);
    if (((_e65 * 2048u) + _e2169) < _e73) {
        let _e2174 = atomicLoad((&words[_e2169]));
        let _e2180 = starts[((_e2174 >> bitcast<u32>((_e70 & 31u))) & 255u)];
        let _e2181 = (_e2180 + _e2169);
        keys_out.member[_e2181] = _e2174;
        phi_2501_ = array<u32, 16>(_e2168[0], _e2168[1], _e2168[2], _e2168[3], _e2168[4], _e2168[5], _e2168[6], _e2168[7], _e2181, _e2168[9], _e2168[10], _e2168[11], _e2168[12], _e2168[13], _e2168[14], _e2168[15]);
    } else {
        phi_2501_ = _e2168;
    }
    let _e2200 = phi_2501_;
    let _e2201 = (1152u + _e54);
    if (((_e65 * 2048u) + _e2201) < _e73) {
        let _e2206 = atomicLoad((&words[_e2201]));
        let _e2212 = starts[((_e2206 >> bitcast<u32>((_e70 & 31u))) & 255u)];
        let _e2213 = (_e2212 + _e2201);
        keys_out.member[_e2213] = _e2206;
        phi_2520_ = array<u32, 16>(_e2200[0], _e2200[1], _e2200[2], _e2200[3], _e2200[4], _e2200[5], _e2200[6], _e2200[7], _e2200[8], _e2213, _e2200[10], _e2200[11], _e2200[12], _e2200[13], _e2200[14], _e2200[15]);
    } else {
        phi_2520_ = _e2200;
    }
    let _e2232 = phi_2520_;
    let _e2233 = (1280u + _e54);
    if (((_e65 * 2048u) + _e2233) < _e73) {
        let _e2238 = atomicLoad((&words[_e2233]));
        let _e2244 = starts[((_e2238 >> bitcast<u32>((_e70 & 31u))) & 255u)];
        let _e2245 = (_e2244 + _e2233);
        keys_out.member[_e2245] = _e2238;
        phi_2539_ = array<u32, 16>(_e2232[0], _e2232[1], _e2232[2], _e2232[3], _e2232[4], _e2232[5], _e2232[6], _e2232[7], _e2232[8], _e2232[9], _e2245, _e2232[11], _e2232[12], _e2232[13], _e2232[14], _e2232[15]);
    } else {
        phi_2539_ = _e2232;
    }
    let _e2264 = phi_2539_;
    let _e2265 = (1408u + _e54);
    if (((_e65 * 2048u) + _e2265) < _e73) {
        let _e2270 = atomicLoad((&words[_e2265]));
        let _e2276 = starts[((_e2270 >> bitcast<u32>((_e70 & 31u))) & 255u)];
        let _e2277 = (_e2276 + _e2265);
        keys_out.member[_e2277] = _e2270;
        phi_2558_ = array<u32, 16>(_e2264[0], _e2264[1], _e2264[2], _e2264[3], _e2264[4], _e2264[5], _e2264[6], _e2264[7], _e2264[8], _e2264[9], _e2264[10], _e2277, _e2264[12], _e2264[13], _e2264[14], _e2264[15]);
    } else {
        phi_2558_ = _e2264;
    }
    let _e2296 = phi_2558_;
    let _e2297 = (1536u + _e54);
    if (((_e65 * 2048u) + _e2297) < _e73) {
        let _e2302 = atomicLoad((&words[_e2297]));
        let _e2308 = starts[((_e2302 >> bitcast<u32>((_e70 & 31u))) & 255u)];
        let _e2309 = (_e2308 + _e2297);
        keys_out.member[_e2309] = _e2302;
        phi_2577_ = array<u32, 16>(_e2296[0], _e2296[1], _e2296[2], _e2296[3], _e2296[4], _e2296[5], _e2296[6], _e2296[7], _e2296[8], _e2296[9], _e2296[10], _e2296[11], _e2309, _e2296[13], _e2296[14], _e2296[15]);
    } else {
        phi_2577_ = _e2296;
    }
    let _e2328 = phi_2577_;
    let _e2329 = (1664u + _e54);
    if (((_e65 * 2048u) + _e2329) < _e73) {
        let _e2334 = atomicLoad((&words[_e2329]));
        let _e2340 = starts[((_e2334 >> bitcast<u32>((_e70 & 31u))) & 255u)];
        let _e2341 = (_e2340 + _e2329);
        keys_out.member[_e2341] = _e2334;
        phi_2596_ = array<u32, 16>(_e2328[0], _e2328[1], _e2328[2], _e2328[3], _e2328[4], _e2328[5], _e2328[6], _e2328[7], _e2328[8], _e2328[9], _e2328[10], _e2328[11], _e2328[12], _e2341, _e2328[14], _e2328[15]);
    } else {
        phi_2596_ = _e2328;
    }
    let _e2360 = phi_2596_;
    let _e2361 = (1792u + _e54);
    if (((_e65 * 2048u) + _e2361) < _e73) {
        let _e2366 = atomicLoad((&words[_e2361]));
        let _e2372 = starts[((_e2366 >> bitcast<u32>((_e70 & 31u))) & 255u)];
        let _e2373 = (_e2372 + _e2361);
        keys_out.member[_e2373] = _e2366;
        phi_2615_ = array<u32, 16>(_e2360[0], _e2360[1], _e2360[2], _e2360[3], _e2360[4], _e2360[5], _e2360[6], _e2360[7], _e2360[8], _e2360[9], _e2360[10], _e2360[11], _e2360[12], _e2360[13], _e2373, _e2360[15]);
    } else {
        phi_2615_ = _e2360;
    }
    let _e2392 = phi_2615_;
    let _e2393 = (1920u + _e54);
    if (((_e65 * 2048u) + _e2393) < _e73) {
        let _e2398 = atomicLoad((&words[_e2393]));
        let _e2404 = starts[((_e2398 >> bitcast<u32>((_e70 & 31u))) & 255u)];
        let _e2405 = (_e2404 + _e2393);
        keys_out.member[_e2405] = _e2398;
        phi_2634_ = array<u32, 16>(_e2392[0], _e2392[1], _e2392[2], _e2392[3], _e2392[4], _e2392[5], _e2392[6], _e2392[7], _e2392[8], _e2392[9], _e2392[10], _e2392[11], _e2392[12], _e2392[13], _e2392[14], _e2405);
    } else {
        phi_2634_ = _e2392;
    }
    let _e2424 = phi_2634_;
    workgroupBarrier();
    if (((_e65 * 2048u) + (((_e54 / 32u) * 512u) + (_e54 % 32u))) < _e73) {
        atomicStore((&words[_e1928[0]]), _e110);
    }
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 32u) + (_e54 % 32u))) < _e73) {
        atomicStore((&words[_e1928[1]]), _e122);
    }
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 64u) + (_e54 % 32u))) < _e73) {
        atomicStore((&words[_e1928[2]]), _e158);
    }
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 96u) + (_e54 % 32u))) < _e73) {
        atomicStore((&words[_e1928[3]]), _e170);
    }
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 128u) + (_e54 % 32u))) < _e73) {
        atomicStore((&words[_e1928[4]]), _e206);
    }
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 160u) + (_e54 % 32u))) < _e73) {
        atomicStore((&words[_e1928[5]]), _e218);
    }
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 192u) + (_e54 % 32u))) < _e73) {
        atomicStore((&words[_e1928[6]]), _e254);
    }
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 224u) + (_e54 % 32u))) < _e73) {
        atomicStore((&words[_e1928[7]]), _e266);
    }
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 256u) + (_e54 % 32u))) < _e73) {
        atomicStore((&words[_e1928[8]]), _e302);
    }
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 288u) + (_e54 % 32u))) < _e73) {
        atomicStore((&words[_e1928[9]]), _e314);
    }
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 320u) + (_e54 % 32u))) < _e73) {
        atomicStore((&words[_e1928[10]]), _e350);
    }
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 352u) + (_e54 % 32u))) < _e73) {
        atomicStore((&words[_e1928[11]]), _e362);
    }
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 384u) + (_e54 % 32u))) < _e73) {
        atomicStore((&words[_e1928[12]]), _e398);
    }
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 416u) + (_e54 % 32u))) < _e73) {
        atomicStore((&words[_e1928[13]]), _e410);
    }
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 448u) + (_e54 % 32u))) < _e73) {
        atomicStore((&words[_e1928[14]]), _e447);
    }
    if (((_e65 * 2048u) + ((((_e54 / 32u) * 512u) + 480u) + (_e54 % 32u))) < _e73) {
        atomicStore((&words[_e1928[15]]), _e459);
    }
    workgroupBarrier();
    if (((_e65 * 2048u) + _e54) < _e73) {
        let _e2589 = atomicLoad((&words[_e54]));
        values_out.member[_e2424[0]] = _e2589;
    }
    let _e2591 = (128u + _e54);
    if (((_e65 * 2048u) + _e2591) < _e73) {
        let _e2597 = atomicLoad((&words[_e2591]));
        values_out.member[_e2424[1]] = _e2597;
    }
    let _e2599 = (256u + _e54);
    if (((_e65 * 2048u) + _e2599) < _e73) {
        let _e2605 = atomicLoad((&words[_e2599]));
        values_out.member[_e2424[2]] = _e2605;
    }
    let _e2607 = (384u + _e54);
    if (((_e65 * 2048u) + _e2607) < _e73) {
        let _e2613 = atomicLoad((&words[_e2607]));
        values_out.member[_e2424[3]] = _e2613;
    }
    let _e2615 = (512u + _e54);
    if (((_e65 * 2048u) + _e2615) < _e73) {
        let _e2621 = atomicLoad((&words[_e2615]));
        values_out.member[_e2424[4]] = _e2621;
    }
    let _e2623 = (640u + _e54);
    if (((_e65 * 2048u) + _e2623) < _e73) {
        let _e2629 = atomicLoad((&words[_e2623]));
        values_out.member[_e2424[5]] = _e2629;
    }
    let _e2631 = (768u + _e54);
    if (((_e65 * 2048u) + _e2631) < _e73) {
        let _e2637 = atomicLoad((&words[_e2631]));
        values_out.member[_e2424[6]] = _e2637;
    }
    let _e2639 = (896u + _e54);
    if (((_e65 * 2048u) + _e2639) < _e73) {
        let _e2645 = atomicLoad((&words[_e2639]));
        values_out.member[_e2424[7]] = _e2645;
    }
    let _e2647 = (1024u + _e54);
    if (((_e65 * 2048u) + _e2647) < _e73) {
        let _e2653 = atomicLoad((&words[_e2647]));
        values_out.member[_e2424[8]] = _e2653;
    }
    let _e2655 = (1152u + _e54);
    if (((_e65 * 2048u) + _e2655) < _e73) {
        let _e2661 = atomicLoad((&words[_e2655]));
        values_out.member[_e2424[9]] = _e2661;
    }
    let _e2663 = (1280u + _e54);
    if (((_e65 * 2048u) + _e2663) < _e73) {
        let _e2669 = atomicLoad((&words[_e2663]));
        values_out.member[_e2424[10]] = _e2669;
    }
    let _e2671 = (1408u + _e54);
    if (((_e65 * 2048u) + _e2671) < _e73) {
        let _e2677 = atomicLoad((&words[_e2671]));
        values_out.member[_e2424[11]] = _e2677;
    }
    let _e2679 = (1536u + _e54);
    if (((_e65 * 2048u) + _e2679) < _e73) {
        let _e2685 = atomicLoad((&words[_e2679]));
        values_out.member[_e2424[12]] = _e2685;
    }
    let _e2687 = (1664u + _e54);
    if (((_e65 * 2048u) + _e2687) < _e73) {
        let _e2693 = atomicLoad((&words[_e2687]));
        values_out.member[_e2424[13]] = _e2693;
    }
    let _e2695 = (1792u + _e54);
    if (((_e65 * 2048u) + _e2695) < _e73) {
        let _e2701 = atomicLoad((&words[_e2695]));
        values_out.member[_e2424[14]] = _e2701;
    }
    let _e2703 = (1920u + _e54);
    if (((_e65 * 2048u) + _e2703) < _e73) {
        let _e2709 = atomicLoad((&words[_e2703]));
        values_out.member[_e2424[15]] = _e2709;
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn sort_scatter(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}

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
var<workgroup> masks: array<atomic<u32>, 2048>;
var<workgroup> counts: array<atomic<u32>, 1024>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_122_: u32;
    var phi_145_: u32;
    var phi_168_: u32;
    var phi_191_: u32;
    var phi_214_: u32;
    var phi_237_: u32;
    var phi_260_: u32;
    var phi_283_: u32;
    var phi_306_: u32;
    var phi_329_: u32;
    var phi_352_: u32;
    var phi_375_: u32;
    var phi_398_: u32;
    var phi_421_: u32;
    var phi_444_: u32;
    var phi_467_: u32;
    var phi_490_: u32;
    var phi_513_: u32;
    var phi_536_: u32;
    var phi_559_: u32;
    var phi_582_: u32;
    var phi_605_: u32;
    var phi_628_: u32;
    var phi_651_: u32;
    var phi_674_: u32;
    var phi_697_: u32;
    var phi_720_: u32;
    var phi_743_: u32;
    var phi_766_: u32;
    var phi_789_: u32;
    var phi_812_: u32;
    var phi_835_: u32;
    var phi_838_: type_9;
    var phi_839_: type_9;
    var phi_862_: type_9;
    var phi_1657_: type_9;
    var phi_1660_: u32;
    var phi_1662_: u32;
    var phi_1664_: u32;
    var phi_1661_: u32;
    var phi_1658_: type_9;
    var phi_1687_: type_9;
    var phi_1703_: u32;
    var phi_1663_: u32;
    var phi_1665_: u32;
    var local: u32;
    var phi_1710_: type_9;
    var phi_1713_: u32;
    var phi_1711_: type_9;
    var phi_1736_: type_9;
    var phi_1768_: u32;
    var phi_1772_: type_9;
    var phi_1775_: u32;
    var phi_1773_: type_9;
    var phi_1798_: type_9;
    var phi_1776_: u32;
    var phi_1714_: u32;
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
    let _e68 = ((_e54 * 2048u) + (((_e43 / 32u) * 512u) + (_e43 % 32u)));
    if (_e68 < _e62) {
        let _e71 = keys.member[_e68];
        phi_122_ = _e71;
    } else {
        phi_122_ = 0u;
    }
    let _e73 = phi_122_;
    let _e80 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 32u) + (_e43 % 32u)));
    if (_e80 < _e62) {
        let _e83 = keys.member[_e80];
        phi_145_ = _e83;
    } else {
        phi_145_ = 0u;
    }
    let _e85 = phi_145_;
    let _e91 = ((_e54 * 2048u) + (((_e43 / 32u) * 512u) + (_e43 % 32u)));
    if (_e91 < _e62) {
        let _e94 = values.member[_e91];
        phi_168_ = _e94;
    } else {
        phi_168_ = 0u;
    }
    let _e96 = phi_168_;
    let _e103 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 32u) + (_e43 % 32u)));
    if (_e103 < _e62) {
        let _e106 = values.member[_e103];
        phi_191_ = _e106;
    } else {
        phi_191_ = 0u;
    }
    let _e108 = phi_191_;
    let _e115 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 64u) + (_e43 % 32u)));
    if (_e115 < _e62) {
        let _e118 = keys.member[_e115];
        phi_214_ = _e118;
    } else {
        phi_214_ = 0u;
    }
    let _e120 = phi_214_;
    let _e127 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 96u) + (_e43 % 32u)));
    if (_e127 < _e62) {
        let _e130 = keys.member[_e127];
        phi_237_ = _e130;
    } else {
        phi_237_ = 0u;
    }
    let _e132 = phi_237_;
    let _e139 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 64u) + (_e43 % 32u)));
    if (_e139 < _e62) {
        let _e142 = values.member[_e139];
        phi_260_ = _e142;
    } else {
        phi_260_ = 0u;
    }
    let _e144 = phi_260_;
    let _e151 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 96u) + (_e43 % 32u)));
    if (_e151 < _e62) {
        let _e154 = values.member[_e151];
        phi_283_ = _e154;
    } else {
        phi_283_ = 0u;
    }
    let _e156 = phi_283_;
    let _e163 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 128u) + (_e43 % 32u)));
    if (_e163 < _e62) {
        let _e166 = keys.member[_e163];
        phi_306_ = _e166;
    } else {
        phi_306_ = 0u;
    }
    let _e168 = phi_306_;
    let _e175 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 160u) + (_e43 % 32u)));
    if (_e175 < _e62) {
        let _e178 = keys.member[_e175];
        phi_329_ = _e178;
    } else {
        phi_329_ = 0u;
    }
    let _e180 = phi_329_;
    let _e187 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 128u) + (_e43 % 32u)));
    if (_e187 < _e62) {
        let _e190 = values.member[_e187];
        phi_352_ = _e190;
    } else {
        phi_352_ = 0u;
    }
    let _e192 = phi_352_;
    let _e199 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 160u) + (_e43 % 32u)));
    if (_e199 < _e62) {
        let _e202 = values.member[_e199];
        phi_375_ = _e202;
    } else {
        phi_375_ = 0u;
    }
    let _e204 = phi_375_;
    let _e211 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 192u) + (_e43 % 32u)));
    if (_e211 < _e62) {
        let _e214 = keys.member[_e211];
        phi_398_ = _e214;
    } else {
        phi_398_ = 0u;
    }
    let _e216 = phi_398_;
    let _e223 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 224u) + (_e43 % 32u)));
    if (_e223 < _e62) {
        let _e226 = keys.member[_e223];
        phi_421_ = _e226;
    } else {
        phi_421_ = 0u;
    }
    let _e228 = phi_421_;
    let _e235 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 192u) + (_e43 % 32u)));
    if (_e235 < _e62) {
        let _e238 = values.member[_e235];
        phi_444_ = _e238;
    } else {
        phi_444_ = 0u;
    }
    let _e240 = phi_444_;
    let _e247 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 224u) + (_e43 % 32u)));
    if (_e247 < _e62) {
        let _e250 = values.member[_e247];
        phi_467_ = _e250;
    } else {
        phi_467_ = 0u;
    }
    let _e252 = phi_467_;
    let _e259 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 256u) + (_e43 % 32u)));
    if (_e259 < _e62) {
        let _e262 = keys.member[_e259];
        phi_490_ = _e262;
    } else {
        phi_490_ = 0u;
    }
    let _e264 = phi_490_;
    let _e271 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 288u) + (_e43 % 32u)));
    if (_e271 < _e62) {
        let _e274 = keys.member[_e271];
        phi_513_ = _e274;
    } else {
        phi_513_ = 0u;
    }
    let _e276 = phi_513_;
    let _e283 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 256u) + (_e43 % 32u)));
    if (_e283 < _e62) {
        let _e286 = values.member[_e283];
        phi_536_ = _e286;
    } else {
        phi_536_ = 0u;
    }
    let _e288 = phi_536_;
    let _e295 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 288u) + (_e43 % 32u)));
    if (_e295 < _e62) {
        let _e298 = values.member[_e295];
        phi_559_ = _e298;
    } else {
        phi_559_ = 0u;
    }
    let _e300 = phi_559_;
    let _e307 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 320u) + (_e43 % 32u)));
    if (_e307 < _e62) {
        let _e310 = keys.member[_e307];
        phi_582_ = _e310;
    } else {
        phi_582_ = 0u;
    }
    let _e312 = phi_582_;
    let _e319 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 352u) + (_e43 % 32u)));
    if (_e319 < _e62) {
        let _e322 = keys.member[_e319];
        phi_605_ = _e322;
    } else {
        phi_605_ = 0u;
    }
    let _e324 = phi_605_;
    let _e331 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 320u) + (_e43 % 32u)));
    if (_e331 < _e62) {
        let _e334 = values.member[_e331];
        phi_628_ = _e334;
    } else {
        phi_628_ = 0u;
    }
    let _e336 = phi_628_;
    let _e343 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 352u) + (_e43 % 32u)));
    if (_e343 < _e62) {
        let _e346 = values.member[_e343];
        phi_651_ = _e346;
    } else {
        phi_651_ = 0u;
    }
    let _e348 = phi_651_;
    let _e355 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 384u) + (_e43 % 32u)));
    if (_e355 < _e62) {
        let _e358 = keys.member[_e355];
        phi_674_ = _e358;
    } else {
        phi_674_ = 0u;
    }
    let _e360 = phi_674_;
    let _e367 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 416u) + (_e43 % 32u)));
    if (_e367 < _e62) {
        let _e370 = keys.member[_e367];
        phi_697_ = _e370;
    } else {
        phi_697_ = 0u;
    }
    let _e372 = phi_697_;
    let _e379 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 384u) + (_e43 % 32u)));
    if (_e379 < _e62) {
        let _e382 = values.member[_e379];
        phi_720_ = _e382;
    } else {
        phi_720_ = 0u;
    }
    let _e384 = phi_720_;
    let _e391 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 416u) + (_e43 % 32u)));
    if (_e391 < _e62) {
        let _e394 = values.member[_e391];
        phi_743_ = _e394;
    } else {
        phi_743_ = 0u;
    }
    let _e396 = phi_743_;
    let _e403 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 448u) + (_e43 % 32u)));
    if (_e403 < _e62) {
        let _e406 = keys.member[_e403];
        phi_766_ = _e406;
    } else {
        phi_766_ = 0u;
    }
    let _e408 = phi_766_;
    let _e415 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 480u) + (_e43 % 32u)));
    if (_e415 < _e62) {
        let _e418 = keys.member[_e415];
        phi_789_ = _e418;
    } else {
        phi_789_ = 0u;
    }
    let _e420 = phi_789_;
    let _e427 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 448u) + (_e43 % 32u)));
    if (_e427 < _e62) {
        let _e430 = values.member[_e427];
        phi_812_ = _e430;
    } else {
        phi_812_ = 0u;
    }
    let _e432 = phi_812_;
    let _e439 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 480u) + (_e43 % 32u)));
    if (_e439 < _e62) {
        let _e442 = values.member[_e439];
        phi_835_ = _e442;
    } else {
        phi_835_ = 0u;
    }
    let _e444 = phi_835_;
    phi_838_ = type_9(0u, 8u);
    loop {
        let _e446 = phi_838_;
        if (_e446.member < _e446.member_1) {
            phi_839_ = type_9((_e446.member + 1u), _e446.member_1);
            phi_862_ = type_9(1u, _e446.member);
        } else {
            phi_839_ = _e446;
            phi_862_ = type_9(0u, type_9().member_1);
        }
        let _e458 = phi_839_;
        let _e460 = phi_862_;
        let _e464 = (bitcast<i32>(_e460.member) != 0i);
        if _e464 {
            atomicStore((&masks[((_e460.member_1 * 128u) + _e43)]), 0u);
            atomicStore((&masks[((1024u + (_e460.member_1 * 128u)) + _e43)]), 0u);
            atomicStore((&counts[((_e460.member_1 * 128u) + _e43)]), 0u);
        }
        continue;
        continuing {
            phi_838_ = _e458;
            break if !(_e464);
        }
    }
    workgroupBarrier();
    let _e482 = (((_e54 * 2048u) + (((_e43 / 32u) * 512u) + (_e43 % 32u))) < _e62);
    let _e490 = (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 32u) + (_e43 % 32u))) < _e62);
    let _e495 = (_e56 + ((_e73 >> bitcast<u32>((_e59 & 31u))) & 255u));
    let _e500 = (_e56 + ((_e85 >> bitcast<u32>((_e59 & 31u))) & 255u));
    if _e482 {
        let _e506 = atomicOr((&masks[_e495]), (1u << bitcast<u32>(((_e43 % 32u) & 31u))));
    }
    if _e490 {
        let _e513 = atomicOr((&masks[(1024u + _e500)]), (1u << bitcast<u32>(((_e43 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e515 = atomicLoad((&masks[_e495]));
    let _e518 = atomicLoad((&masks[(1024u + _e500)]));
    let _e525 = countOneBits((_e515 & ((1u << bitcast<u32>(((_e43 % 32u) & 31u))) - 1u)));
    let _e532 = countOneBits((_e518 & ((1u << bitcast<u32>(((_e43 % 32u) & 31u))) - 1u)));
    let _e534 = atomicLoad((&counts[_e495]));
    let _e537 = atomicLoad((&counts[_e500]));
    let _e539 = atomicLoad((&masks[_e500]));
    workgroupBarrier();
    if _e482 {
        if (_e525 == 0u) {
            let _e546 = atomicAdd((&counts[_e495]), countOneBits(_e515));
            atomicStore((&masks[_e495]), 0u);
        }
    }
    if _e490 {
        if (_e532 == 0u) {
            let _e551 = atomicAdd((&counts[_e500]), countOneBits(_e518));
            atomicStore((&masks[(1024u + _e500)]), 0u);
        }
    }
    workgroupBarrier();
    let _e561 = (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 64u) + (_e43 % 32u))) < _e62);
    let _e569 = (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 96u) + (_e43 % 32u))) < _e62);
    let _e574 = (_e56 + ((_e120 >> bitcast<u32>((_e59 & 31u))) & 255u));
    let _e579 = (_e56 + ((_e132 >> bitcast<u32>((_e59 & 31u))) & 255u));
    if _e561 {
        let _e585 = atomicOr((&masks[_e574]), (1u << bitcast<u32>(((_e43 % 32u) & 31u))));
    }
    if _e569 {
        let _e592 = atomicOr((&masks[(1024u + _e579)]), (1u << bitcast<u32>(((_e43 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e594 = atomicLoad((&masks[_e574]));
    let _e597 = atomicLoad((&masks[(1024u + _e579)]));
    let _e604 = countOneBits((_e594 & ((1u << bitcast<u32>(((_e43 % 32u) & 31u))) - 1u)));
    let _e611 = countOneBits((_e597 & ((1u << bitcast<u32>(((_e43 % 32u) & 31u))) - 1u)));
    let _e613 = atomicLoad((&counts[_e574]));
    let _e616 = atomicLoad((&counts[_e579]));
    let _e618 = atomicLoad((&masks[_e579]));
    workgroupBarrier();
    if _e561 {
        if (_e604 == 0u) {
            let _e625 = atomicAdd((&counts[_e574]), countOneBits(_e594));
            atomicStore((&masks[_e574]), 0u);
        }
    }
    if _e569 {
        if (_e611 == 0u) {
            let _e630 = atomicAdd((&counts[_e579]), countOneBits(_e597));
            atomicStore((&masks[(1024u + _e579)]), 0u);
        }
    }
    workgroupBarrier();
    let _e640 = (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 128u) + (_e43 % 32u))) < _e62);
    let _e648 = (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 160u) + (_e43 % 32u))) < _e62);
    let _e653 = (_e56 + ((_e168 >> bitcast<u32>((_e59 & 31u))) & 255u));
    let _e658 = (_e56 + ((_e180 >> bitcast<u32>((_e59 & 31u))) & 255u));
    if _e640 {
        let _e664 = atomicOr((&masks[_e653]), (1u << bitcast<u32>(((_e43 % 32u) & 31u))));
    }
    if _e648 {
        let _e671 = atomicOr((&masks[(1024u + _e658)]), (1u << bitcast<u32>(((_e43 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e673 = atomicLoad((&masks[_e653]));
    let _e676 = atomicLoad((&masks[(1024u + _e658)]));
    let _e683 = countOneBits((_e673 & ((1u << bitcast<u32>(((_e43 % 32u) & 31u))) - 1u)));
    let _e690 = countOneBits((_e676 & ((1u << bitcast<u32>(((_e43 % 32u) & 31u))) - 1u)));
    let _e692 = atomicLoad((&counts[_e653]));
    let _e695 = atomicLoad((&counts[_e658]));
    let _e697 = atomicLoad((&masks[_e658]));
    workgroupBarrier();
    if _e640 {
        if (_e683 == 0u) {
            let _e704 = atomicAdd((&counts[_e653]), countOneBits(_e673));
            atomicStore((&masks[_e653]), 0u);
        }
    }
    if _e648 {
        if (_e690 == 0u) {
            let _e709 = atomicAdd((&counts[_e658]), countOneBits(_e676));
            atomicStore((&masks[(1024u + _e658)]), 0u);
        }
    }
    workgroupBarrier();
    let _e719 = (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 192u) + (_e43 % 32u))) < _e62);
    let _e727 = (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 224u) + (_e43 % 32u))) < _e62);
    let _e732 = (_e56 + ((_e216 >> bitcast<u32>((_e59 & 31u))) & 255u));
    let _e737 = (_e56 + ((_e228 >> bitcast<u32>((_e59 & 31u))) & 255u));
    if _e719 {
        let _e743 = atomicOr((&masks[_e732]), (1u << bitcast<u32>(((_e43 % 32u) & 31u))));
    }
    if _e727 {
        let _e750 = atomicOr((&masks[(1024u + _e737)]), (1u << bitcast<u32>(((_e43 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e752 = atomicLoad((&masks[_e732]));
    let _e755 = atomicLoad((&masks[(1024u + _e737)]));
    let _e762 = countOneBits((_e752 & ((1u << bitcast<u32>(((_e43 % 32u) & 31u))) - 1u)));
    let _e769 = countOneBits((_e755 & ((1u << bitcast<u32>(((_e43 % 32u) & 31u))) - 1u)));
    let _e771 = atomicLoad((&counts[_e732]));
    let _e774 = atomicLoad((&counts[_e737]));
    let _e776 = atomicLoad((&masks[_e737]));
    workgroupBarrier();
    if _e719 {
        if (_e762 == 0u) {
            let _e783 = atomicAdd((&counts[_e732]), countOneBits(_e752));
            atomicStore((&masks[_e732]), 0u);
        }
    }
    if _e727 {
        if (_e769 == 0u) {
            let _e788 = atomicAdd((&counts[_e737]), countOneBits(_e755));
            atomicStore((&masks[(1024u + _e737)]), 0u);
        }
    }
    workgroupBarrier();
    let _e798 = (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 256u) + (_e43 % 32u))) < _e62);
    let _e806 = (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 288u) + (_e43 % 32u))) < _e62);
    let _e811 = (_e56 + ((_e264 >> bitcast<u32>((_e59 & 31u))) & 255u));
    let _e816 = (_e56 + ((_e276 >> bitcast<u32>((_e59 & 31u))) & 255u));
    if _e798 {
        let _e822 = atomicOr((&masks[_e811]), (1u << bitcast<u32>(((_e43 % 32u) & 31u))));
    }
    if _e806 {
        let _e829 = atomicOr((&masks[(1024u + _e816)]), (1u << bitcast<u32>(((_e43 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e831 = atomicLoad((&masks[_e811]));
    let _e834 = atomicLoad((&masks[(1024u + _e816)]));
    let _e841 = countOneBits((_e831 & ((1u << bitcast<u32>(((_e43 % 32u) & 31u))) - 1u)));
    let _e848 = countOneBits((_e834 & ((1u << bitcast<u32>(((_e43 % 32u) & 31u))) - 1u)));
    let _e850 = atomicLoad((&counts[_e811]));
    let _e853 = atomicLoad((&counts[_e816]));
    let _e855 = atomicLoad((&masks[_e816]));
    workgroupBarrier();
    if _e798 {
        if (_e841 == 0u) {
            let _e862 = atomicAdd((&counts[_e811]), countOneBits(_e831));
            atomicStore((&masks[_e811]), 0u);
        }
    }
    if _e806 {
        if (_e848 == 0u) {
            let _e867 = atomicAdd((&counts[_e816]), countOneBits(_e834));
            atomicStore((&masks[(1024u + _e816)]), 0u);
        }
    }
    workgroupBarrier();
    let _e877 = (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 320u) + (_e43 % 32u))) < _e62);
    let _e885 = (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 352u) + (_e43 % 32u))) < _e62);
    let _e890 = (_e56 + ((_e312 >> bitcast<u32>((_e59 & 31u))) & 255u));
    let _e895 = (_e56 + ((_e324 >> bitcast<u32>((_e59 & 31u))) & 255u));
    if _e877 {
        let _e901 = atomicOr((&masks[_e890]), (1u << bitcast<u32>(((_e43 % 32u) & 31u))));
    }
    if _e885 {
        let _e908 = atomicOr((&masks[(1024u + _e895)]), (1u << bitcast<u32>(((_e43 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e910 = atomicLoad((&masks[_e890]));
    let _e913 = atomicLoad((&masks[(1024u + _e895)]));
    let _e920 = countOneBits((_e910 & ((1u << bitcast<u32>(((_e43 % 32u) & 31u))) - 1u)));
    let _e927 = countOneBits((_e913 & ((1u << bitcast<u32>(((_e43 % 32u) & 31u))) - 1u)));
    let _e929 = atomicLoad((&counts[_e890]));
    let _e932 = atomicLoad((&counts[_e895]));
    let _e934 = atomicLoad((&masks[_e895]));
    workgroupBarrier();
    if _e877 {
        if (_e920 == 0u) {
            let _e941 = atomicAdd((&counts[_e890]), countOneBits(_e910));
            atomicStore((&masks[_e890]), 0u);
        }
    }
    if _e885 {
        if (_e927 == 0u) {
            let _e946 = atomicAdd((&counts[_e895]), countOneBits(_e913));
            atomicStore((&masks[(1024u + _e895)]), 0u);
        }
    }
    workgroupBarrier();
    let _e956 = (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 384u) + (_e43 % 32u))) < _e62);
    let _e964 = (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 416u) + (_e43 % 32u))) < _e62);
    let _e969 = (_e56 + ((_e360 >> bitcast<u32>((_e59 & 31u))) & 255u));
    let _e974 = (_e56 + ((_e372 >> bitcast<u32>((_e59 & 31u))) & 255u));
    if _e956 {
        let _e980 = atomicOr((&masks[_e969]), (1u << bitcast<u32>(((_e43 % 32u) & 31u))));
    }
    if _e964 {
        let _e987 = atomicOr((&masks[(1024u + _e974)]), (1u << bitcast<u32>(((_e43 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e989 = atomicLoad((&masks[_e969]));
    let _e992 = atomicLoad((&masks[(1024u + _e974)]));
    let _e999 = countOneBits((_e989 & ((1u << bitcast<u32>(((_e43 % 32u) & 31u))) - 1u)));
    let _e1006 = countOneBits((_e992 & ((1u << bitcast<u32>(((_e43 % 32u) & 31u))) - 1u)));
    let _e1008 = atomicLoad((&counts[_e969]));
    let _e1011 = atomicLoad((&counts[_e974]));
    let _e1013 = atomicLoad((&masks[_e974]));
    workgroupBarrier();
    if _e956 {
        if (_e999 == 0u) {
            let _e1020 = atomicAdd((&counts[_e969]), countOneBits(_e989));
            atomicStore((&masks[_e969]), 0u);
        }
    }
    if _e964 {
        if (_e1006 == 0u) {
            let _e1025 = atomicAdd((&counts[_e974]), countOneBits(_e992));
            atomicStore((&masks[(1024u + _e974)]), 0u);
        }
    }
    workgroupBarrier();
    let _e1035 = (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 448u) + (_e43 % 32u))) < _e62);
    let _e1043 = (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 480u) + (_e43 % 32u))) < _e62);
    let _e1048 = (_e56 + ((_e408 >> bitcast<u32>((_e59 & 31u))) & 255u));
    let _e1053 = (_e56 + ((_e420 >> bitcast<u32>((_e59 & 31u))) & 255u));
    if _e1035 {
        let _e1059 = atomicOr((&masks[_e1048]), (1u << bitcast<u32>(((_e43 % 32u) & 31u))));
    }
    if _e1043 {
        let _e1066 = atomicOr((&masks[(1024u + _e1053)]), (1u << bitcast<u32>(((_e43 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e1068 = atomicLoad((&masks[_e1048]));
    let _e1071 = atomicLoad((&masks[(1024u + _e1053)]));
    let _e1078 = countOneBits((_e1068 & ((1u << bitcast<u32>(((_e43 % 32u) & 31u))) - 1u)));
    let _e1085 = countOneBits((_e1071 & ((1u << bitcast<u32>(((_e43 % 32u) & 31u))) - 1u)));
    let _e1087 = atomicLoad((&counts[_e1048]));
    let _e1090 = atomicLoad((&counts[_e1053]));
    let _e1092 = atomicLoad((&masks[_e1053]));
    workgroupBarrier();
    if _e1035 {
        if (_e1078 == 0u) {
            let _e1099 = atomicAdd((&counts[_e1048]), countOneBits(_e1068));
            atomicStore((&masks[_e1048]), 0u);
        }
    }
    if _e1043 {
        if (_e1085 == 0u) {
            let _e1104 = atomicAdd((&counts[_e1053]), countOneBits(_e1071));
            atomicStore((&masks[(1024u + _e1053)]), 0u);
        }
    }
    workgroupBarrier();
    let _e1109 = params.member.member_2.member_1;
    let _e1110 = (256u * _e1109);
    let _e1114 = table.member[(_e1110 + (2u * _e43))];
    let _e1119 = table.member[((_e1110 + (2u * _e43)) + 1u)];
    let _e1120 = (_e1114 + _e1119);
    atomicStore((&masks[_e43]), _e1120);
    phi_1657_ = type_9(0u, 7u);
    phi_1660_ = 0u;
    phi_1662_ = 1u;
    phi_1664_ = _e1120;
    phi_1661_ = 1024u;
    loop {
        let _e1123 = phi_1657_;
        let _e1125 = phi_1660_;
        let _e1127 = phi_1662_;
        let _e1129 = phi_1664_;
        let _e1131 = phi_1661_;
        local = _e1129;
        if (_e1123.member < _e1123.member_1) {
            phi_1658_ = type_9((_e1123.member + 1u), _e1123.member_1);
            phi_1687_ = type_9(1u, _e1123.member);
        } else {
            phi_1658_ = _e1123;
            phi_1687_ = type_9(0u, type_9().member_1);
        }
        let _e1143 = phi_1658_;
        let _e1145 = phi_1687_;
        let _e1148 = (bitcast<i32>(_e1145.member) != 0i);
        if _e1148 {
            workgroupBarrier();
            if (_e43 >= _e1127) {
                let _e1153 = atomicLoad((&masks[((_e1125 + _e43) - _e1127)]));
                phi_1703_ = (_e1129 + _e1153);
            } else {
                phi_1703_ = _e1129;
            }
            let _e1156 = phi_1703_;
            atomicStore((&masks[(_e1131 + _e43)]), _e1156);
            phi_1663_ = (_e1127 * 2u);
            phi_1665_ = _e1156;
        } else {
            phi_1663_ = u32();
            phi_1665_ = u32();
        }
        let _e1161 = phi_1663_;
        let _e1163 = phi_1665_;
        continue;
        continuing {
            phi_1657_ = _e1143;
            phi_1660_ = _e1131;
            phi_1662_ = _e1161;
            phi_1664_ = _e1163;
            phi_1661_ = _e1125;
            break if !(_e1148);
        }
    }
    workgroupBarrier();
    let _e1166 = local;
    phi_1710_ = type_9(0u, 2u);
    phi_1713_ = (_e1166 - _e1120);
    loop {
        let _e1169 = phi_1710_;
        let _e1171 = phi_1713_;
        if (_e1169.member < _e1169.member_1) {
            phi_1711_ = type_9((_e1169.member + 1u), _e1169.member_1);
            phi_1736_ = type_9(1u, _e1169.member);
        } else {
            phi_1711_ = _e1169;
            phi_1736_ = type_9(0u, type_9().member_1);
        }
        let _e1183 = phi_1711_;
        let _e1185 = phi_1736_;
        let _e1189 = (bitcast<i32>(_e1185.member) != 0i);
        if _e1189 {
            let _e1191 = ((2u * _e43) + _e1185.member_1);
            let _e1194 = params.member.member_2.member_1;
            if (_e54 < _e1194) {
                let _e1198 = params.member.member_2.member_1;
                let _e1202 = table.member[((_e1191 * _e1198) + _e54)];
                phi_1768_ = _e1202;
            } else {
                phi_1768_ = 0u;
            }
            let _e1204 = phi_1768_;
            phi_1772_ = type_9(0u, 4u);
            phi_1775_ = (_e1171 + _e1204);
            loop {
                let _e1207 = phi_1772_;
                let _e1209 = phi_1775_;
                if (_e1207.member < _e1207.member_1) {
                    phi_1773_ = type_9((_e1207.member + 1u), _e1207.member_1);
                    phi_1798_ = type_9(1u, _e1207.member);
                } else {
                    phi_1773_ = _e1207;
                    phi_1798_ = type_9(0u, type_9().member_1);
                }
                let _e1221 = phi_1773_;
                let _e1223 = phi_1798_;
                let _e1227 = (bitcast<i32>(_e1223.member) != 0i);
                if _e1227 {
                    let _e1229 = ((_e1223.member_1 * 256u) + _e1191);
                    let _e1231 = atomicLoad((&counts[_e1229]));
                    atomicStore((&counts[_e1229]), _e1209);
                    phi_1776_ = (_e1209 + _e1231);
                } else {
                    phi_1776_ = u32();
                }
                let _e1235 = phi_1776_;
                continue;
                continuing {
                    phi_1772_ = _e1221;
                    phi_1775_ = _e1235;
                    break if !(_e1227);
                }
            }
            phi_1714_ = (_e1171 + _e1114);
        } else {
            phi_1714_ = u32();
        }
        let _e1239 = phi_1714_;
        continue;
        continuing {
            phi_1710_ = _e1183;
            phi_1713_ = _e1239;
            break if !(_e1189);
        }
    }
    workgroupBarrier();
    if (((_e54 * 2048u) + (((_e43 / 32u) * 512u) + (_e43 % 32u))) < _e62) {
        let _e1254 = atomicLoad((&counts[(_e56 + ((_e73 >> bitcast<u32>((_e59 & 31u))) & 255u))]));
        let _e1255 = (_e1254 + (_e534 + _e525));
        keys_out.member[_e1255] = _e73;
        values_out.member[_e1255] = _e96;
    }
    if (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 32u) + (_e43 % 32u))) < _e62) {
        let _e1272 = atomicLoad((&counts[(_e56 + ((_e85 >> bitcast<u32>((_e59 & 31u))) & 255u))]));
        let _e1273 = (_e1272 + ((_e537 + countOneBits(_e539)) + _e532));
        keys_out.member[_e1273] = _e85;
        values_out.member[_e1273] = _e108;
    }
    if (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 64u) + (_e43 % 32u))) < _e62) {
        let _e1290 = atomicLoad((&counts[(_e56 + ((_e120 >> bitcast<u32>((_e59 & 31u))) & 255u))]));
        let _e1291 = (_e1290 + (_e613 + _e604));
        keys_out.member[_e1291] = _e120;
        values_out.member[_e1291] = _e144;
    }
    if (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 96u) + (_e43 % 32u))) < _e62) {
        let _e1308 = atomicLoad((&counts[(_e56 + ((_e132 >> bitcast<u32>((_e59 & 31u))) & 255u))]));
        let _e1309 = (_e1308 + ((_e616 + countOneBits(_e618)) + _e611));
        keys_out.member[_e1309] = _e132;
        values_out.member[_e1309] = _e156;
    }
    if (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 128u) + (_e43 % 32u))) < _e62) {
        let _e1326 = atomicLoad((&counts[(_e56 + ((_e168 >> bitcast<u32>((_e59 & 31u))) & 255u))]));
        let _e1327 = (_e1326 + (_e692 + _e683));
        keys_out.member[_e1327] = _e168;
        values_out.member[_e1327] = _e192;
    }
    if (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 160u) + (_e43 % 32u))) < _e62) {
        let _e1344 = atomicLoad((&counts[(_e56 + ((_e180 >> bitcast<u32>((_e59 & 31u))) & 255u))]));
        let _e1345 = (_e1344 + ((_e695 + countOneBits(_e697)) + _e690));
        keys_out.member[_e1345] = _e180;
        values_out.member[_e1345] = _e204;
    }
    if (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 192u) + (_e43 % 32u))) < _e62) {
        let _e1362 = atomicLoad((&counts[(_e56 + ((_e216 >> bitcast<u32>((_e59 & 31u))) & 255u))]));
        let _e1363 = (_e1362 + (_e771 + _e762));
        keys_out.member[_e1363] = _e216;
        values_out.member[_e1363] = _e240;
    }
    if (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 224u) + (_e43 % 32u))) < _e62) {
        let _e1380 = atomicLoad((&counts[(_e56 + ((_e228 >> bitcast<u32>((_e59 & 31u))) & 255u))]));
        let _e1381 = (_e1380 + ((_e774 + countOneBits(_e776)) + _e769));
        keys_out.member[_e1381] = _e228;
        values_out.member[_e1381] = _e252;
    }
    if (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 256u) + (_e43 % 32u))) < _e62) {
        let _e1398 = atomicLoad((&counts[(_e56 + ((_e264 >> bitcast<u32>((_e59 & 31u))) & 255u))]));
        let _e1399 = (_e1398 + (_e850 + _e841));
        keys_out.member[_e1399] = _e264;
        values_out.member[_e1399] = _e288;
    }
    if (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 288u) + (_e43 % 32u))) < _e62) {
        let _e1416 = atomicLoad((&counts[(_e56 + ((_e276 >> bitcast<u32>((_e59 & 31u))) & 255u))]));
        let _e1417 = (_e1416 + ((_e853 + countOneBits(_e855)) + _e848));
        keys_out.member[_e1417] = _e276;
        values_out.member[_e1417] = _e300;
    }
    if (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 320u) + (_e43 % 32u))) < _e62) {
        let _e1434 = atomicLoad((&counts[(_e56 + ((_e312 >> bitcast<u32>((_e59 & 31u))) & 255u))]));
        let _e1435 = (_e1434 + (_e929 + _e920));
        keys_out.member[_e1435] = _e312;
        values_out.member[_e1435] = _e336;
    }
    if (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 352u) + (_e43 % 32u))) < _e62) {
        let _e1452 = atomicLoad((&counts[(_e56 + ((_e324 >> bitcast<u32>((_e59 & 31u))) & 255u))]));
        let _e1453 = (_e1452 + ((_e932 + countOneBits(_e934)) + _e927));
        keys_out.member[_e1453] = _e324;
        values_out.member[_e1453] = _e348;
    }
    if (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 384u) + (_e43 % 32u))) < _e62) {
        let _e1470 = atomicLoad((&counts[(_e56 + ((_e360 >> bitcast<u32>((_e59 & 31u))) & 255u))]));
        let _e1471 = (_e1470 + (_e1008 + _e999));
        keys_out.member[_e1471] = _e360;
        values_out.member[_e1471] = _e384;
    }
    if (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 416u) + (_e43 % 32u))) < _e62) {
        let _e1488 = atomicLoad((&counts[(_e56 + ((_e372 >> bitcast<u32>((_e59 & 31u))) & 255u))]));
        let _e1489 = (_e1488 + ((_e1011 + countOneBits(_e1013)) + _e1006));
        keys_out.member[_e1489] = _e372;
        values_out.member[_e1489] = _e396;
    }
    if (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 448u) + (_e43 % 32u))) < _e62) {
        let _e1506 = atomicLoad((&counts[(_e56 + ((_e408 >> bitcast<u32>((_e59 & 31u))) & 255u))]));
        let _e1507 = (_e1506 + (_e1087 + _e1078));
        keys_out.member[_e1507] = _e408;
        values_out.member[_e1507] = _e432;
    }
    if (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 480u) + (_e43 % 32u))) < _e62) {
        let _e1524 = atomicLoad((&counts[(_e56 + ((_e420 >> bitcast<u32>((_e59 & 31u))) & 255u))]));
        let _e1525 = (_e1524 + ((_e1090 + countOneBits(_e1092)) + _e1085));
        keys_out.member[_e1525] = _e420;
        values_out.member[_e1525] = _e444;
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn sort_scatter(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}

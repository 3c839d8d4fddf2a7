struct type_8 {
    member: array<u32, 3>,
    member_1: u32,
    member_2: array<u32, 4>,
    member_3: f32,
    member_4: f32,
    member_5: f32,
    member_6: f32,
    member_7: array<u32, 2>,
    member_8: u32,
    member_9: u32,
    member_10: u32,
    member_11: u32,
    member_12: u32,
    member_13: u32,
    member_14: u32,
    member_15: u32,
    member_16: u32,
    member_17: u32,
    member_18: array<array<u32, 2>, 3>,
    member_19: array<u32, 2>,
    member_20: array<array<u32, 4>, 8>,
}

struct type_9 {
    member: type_8,
}

struct type_11 {
    member: array<u32>,
}

struct type_13 {
    member: u32,
    member_1: u32,
}

@group(0) @binding(0) 
var<storage> params: type_9;
@group(0) @binding(1) 
var<storage> table: type_11;
@group(0) @binding(2) 
var<storage> keys: type_11;
@group(0) @binding(3) 
var<storage> values: type_11;
@group(0) @binding(4) 
var<storage, read_write> keys_out: type_11;
@group(0) @binding(5) 
var<storage, read_write> values_out: type_11;
var<workgroup> masks: array<atomic<u32>, 2048>;
var<workgroup> counts: array<atomic<u32>, 1024>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_118_: u32;
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
    var phi_831_: u32;
    var phi_834_: type_13;
    var phi_835_: type_13;
    var phi_858_: type_13;
    var phi_1652_: type_13;
    var phi_1655_: u32;
    var phi_1657_: u32;
    var phi_1659_: u32;
    var phi_1656_: u32;
    var phi_1653_: type_13;
    var phi_1682_: type_13;
    var phi_1698_: u32;
    var phi_1658_: u32;
    var phi_1660_: u32;
    var local: u32;
    var phi_1705_: type_13;
    var phi_1708_: u32;
    var phi_1706_: type_13;
    var phi_1731_: type_13;
    var phi_1761_: u32;
    var phi_1765_: type_13;
    var phi_1768_: u32;
    var phi_1766_: type_13;
    var phi_1791_: type_13;
    var phi_1769_: u32;
    var phi_1709_: u32;
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
    let _e58 = params.member.member_10;
    let _e60 = params.member.member_17;
    let _e66 = ((_e54 * 2048u) + (((_e43 / 32u) * 512u) + (_e43 % 32u)));
    if (_e66 < _e60) {
        let _e69 = keys.member[_e66];
        phi_118_ = _e69;
    } else {
        phi_118_ = 0u;
    }
    let _e71 = phi_118_;
    let _e78 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 32u) + (_e43 % 32u)));
    if (_e78 < _e60) {
        let _e81 = keys.member[_e78];
        phi_141_ = _e81;
    } else {
        phi_141_ = 0u;
    }
    let _e83 = phi_141_;
    let _e89 = ((_e54 * 2048u) + (((_e43 / 32u) * 512u) + (_e43 % 32u)));
    if (_e89 < _e60) {
        let _e92 = values.member[_e89];
        phi_164_ = _e92;
    } else {
        phi_164_ = 0u;
    }
    let _e94 = phi_164_;
    let _e101 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 32u) + (_e43 % 32u)));
    if (_e101 < _e60) {
        let _e104 = values.member[_e101];
        phi_187_ = _e104;
    } else {
        phi_187_ = 0u;
    }
    let _e106 = phi_187_;
    let _e113 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 64u) + (_e43 % 32u)));
    if (_e113 < _e60) {
        let _e116 = keys.member[_e113];
        phi_210_ = _e116;
    } else {
        phi_210_ = 0u;
    }
    let _e118 = phi_210_;
    let _e125 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 96u) + (_e43 % 32u)));
    if (_e125 < _e60) {
        let _e128 = keys.member[_e125];
        phi_233_ = _e128;
    } else {
        phi_233_ = 0u;
    }
    let _e130 = phi_233_;
    let _e137 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 64u) + (_e43 % 32u)));
    if (_e137 < _e60) {
        let _e140 = values.member[_e137];
        phi_256_ = _e140;
    } else {
        phi_256_ = 0u;
    }
    let _e142 = phi_256_;
    let _e149 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 96u) + (_e43 % 32u)));
    if (_e149 < _e60) {
        let _e152 = values.member[_e149];
        phi_279_ = _e152;
    } else {
        phi_279_ = 0u;
    }
    let _e154 = phi_279_;
    let _e161 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 128u) + (_e43 % 32u)));
    if (_e161 < _e60) {
        let _e164 = keys.member[_e161];
        phi_302_ = _e164;
    } else {
        phi_302_ = 0u;
    }
    let _e166 = phi_302_;
    let _e173 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 160u) + (_e43 % 32u)));
    if (_e173 < _e60) {
        let _e176 = keys.member[_e173];
        phi_325_ = _e176;
    } else {
        phi_325_ = 0u;
    }
    let _e178 = phi_325_;
    let _e185 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 128u) + (_e43 % 32u)));
    if (_e185 < _e60) {
        let _e188 = values.member[_e185];
        phi_348_ = _e188;
    } else {
        phi_348_ = 0u;
    }
    let _e190 = phi_348_;
    let _e197 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 160u) + (_e43 % 32u)));
    if (_e197 < _e60) {
        let _e200 = values.member[_e197];
        phi_371_ = _e200;
    } else {
        phi_371_ = 0u;
    }
    let _e202 = phi_371_;
    let _e209 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 192u) + (_e43 % 32u)));
    if (_e209 < _e60) {
        let _e212 = keys.member[_e209];
        phi_394_ = _e212;
    } else {
        phi_394_ = 0u;
    }
    let _e214 = phi_394_;
    let _e221 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 224u) + (_e43 % 32u)));
    if (_e221 < _e60) {
        let _e224 = keys.member[_e221];
        phi_417_ = _e224;
    } else {
        phi_417_ = 0u;
    }
    let _e226 = phi_417_;
    let _e233 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 192u) + (_e43 % 32u)));
    if (_e233 < _e60) {
        let _e236 = values.member[_e233];
        phi_440_ = _e236;
    } else {
        phi_440_ = 0u;
    }
    let _e238 = phi_440_;
    let _e245 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 224u) + (_e43 % 32u)));
    if (_e245 < _e60) {
        let _e248 = values.member[_e245];
        phi_463_ = _e248;
    } else {
        phi_463_ = 0u;
    }
    let _e250 = phi_463_;
    let _e257 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 256u) + (_e43 % 32u)));
    if (_e257 < _e60) {
        let _e260 = keys.member[_e257];
        phi_486_ = _e260;
    } else {
        phi_486_ = 0u;
    }
    let _e262 = phi_486_;
    let _e269 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 288u) + (_e43 % 32u)));
    if (_e269 < _e60) {
        let _e272 = keys.member[_e269];
        phi_509_ = _e272;
    } else {
        phi_509_ = 0u;
    }
    let _e274 = phi_509_;
    let _e281 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 256u) + (_e43 % 32u)));
    if (_e281 < _e60) {
        let _e284 = values.member[_e281];
        phi_532_ = _e284;
    } else {
        phi_532_ = 0u;
    }
    let _e286 = phi_532_;
    let _e293 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 288u) + (_e43 % 32u)));
    if (_e293 < _e60) {
        let _e296 = values.member[_e293];
        phi_555_ = _e296;
    } else {
        phi_555_ = 0u;
    }
    let _e298 = phi_555_;
    let _e305 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 320u) + (_e43 % 32u)));
    if (_e305 < _e60) {
        let _e308 = keys.member[_e305];
        phi_578_ = _e308;
    } else {
        phi_578_ = 0u;
    }
    let _e310 = phi_578_;
    let _e317 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 352u) + (_e43 % 32u)));
    if (_e317 < _e60) {
        let _e320 = keys.member[_e317];
        phi_601_ = _e320;
    } else {
        phi_601_ = 0u;
    }
    let _e322 = phi_601_;
    let _e329 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 320u) + (_e43 % 32u)));
    if (_e329 < _e60) {
        let _e332 = values.member[_e329];
        phi_624_ = _e332;
    } else {
        phi_624_ = 0u;
    }
    let _e334 = phi_624_;
    let _e341 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 352u) + (_e43 % 32u)));
    if (_e341 < _e60) {
        let _e344 = values.member[_e341];
        phi_647_ = _e344;
    } else {
        phi_647_ = 0u;
    }
    let _e346 = phi_647_;
    let _e353 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 384u) + (_e43 % 32u)));
    if (_e353 < _e60) {
        let _e356 = keys.member[_e353];
        phi_670_ = _e356;
    } else {
        phi_670_ = 0u;
    }
    let _e358 = phi_670_;
    let _e365 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 416u) + (_e43 % 32u)));
    if (_e365 < _e60) {
        let _e368 = keys.member[_e365];
        phi_693_ = _e368;
    } else {
        phi_693_ = 0u;
    }
    let _e370 = phi_693_;
    let _e377 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 384u) + (_e43 % 32u)));
    if (_e377 < _e60) {
        let _e380 = values.member[_e377];
        phi_716_ = _e380;
    } else {
        phi_716_ = 0u;
    }
    let _e382 = phi_716_;
    let _e389 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 416u) + (_e43 % 32u)));
    if (_e389 < _e60) {
        let _e392 = values.member[_e389];
        phi_739_ = _e392;
    } else {
        phi_739_ = 0u;
    }
    let _e394 = phi_739_;
    let _e401 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 448u) + (_e43 % 32u)));
    if (_e401 < _e60) {
        let _e404 = keys.member[_e401];
        phi_762_ = _e404;
    } else {
        phi_762_ = 0u;
    }
    let _e406 = phi_762_;
    let _e413 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 480u) + (_e43 % 32u)));
    if (_e413 < _e60) {
        let _e416 = keys.member[_e413];
        phi_785_ = _e416;
    } else {
        phi_785_ = 0u;
    }
    let _e418 = phi_785_;
    let _e425 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 448u) + (_e43 % 32u)));
    if (_e425 < _e60) {
        let _e428 = values.member[_e425];
        phi_808_ = _e428;
    } else {
        phi_808_ = 0u;
    }
    let _e430 = phi_808_;
    let _e437 = ((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 480u) + (_e43 % 32u)));
    if (_e437 < _e60) {
        let _e440 = values.member[_e437];
        phi_831_ = _e440;
    } else {
        phi_831_ = 0u;
    }
    let _e442 = phi_831_;
    phi_834_ = type_13(0u, 8u);
    loop {
        let _e444 = phi_834_;
        if (_e444.member < _e444.member_1) {
            phi_835_ = type_13((_e444.member + 1u), _e444.member_1);
            phi_858_ = type_13(1u, _e444.member);
        } else {
            phi_835_ = _e444;
            phi_858_ = type_13(0u, type_13().member_1);
        }
        let _e456 = phi_835_;
        let _e458 = phi_858_;
        let _e462 = (bitcast<i32>(_e458.member) != 0i);
        if _e462 {
            atomicStore((&masks[((_e458.member_1 * 128u) + _e43)]), 0u);
            atomicStore((&masks[((1024u + (_e458.member_1 * 128u)) + _e43)]), 0u);
            atomicStore((&counts[((_e458.member_1 * 128u) + _e43)]), 0u);
        }
        continue;
        continuing {
            phi_834_ = _e456;
            break if !(_e462);
        }
    }
    workgroupBarrier();
    let _e480 = (((_e54 * 2048u) + (((_e43 / 32u) * 512u) + (_e43 % 32u))) < _e60);
    let _e488 = (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 32u) + (_e43 % 32u))) < _e60);
    let _e493 = (_e56 + ((_e71 >> bitcast<u32>((_e58 & 31u))) & 255u));
    let _e498 = (_e56 + ((_e83 >> bitcast<u32>((_e58 & 31u))) & 255u));
    if _e480 {
        let _e504 = atomicOr((&masks[_e493]), (1u << bitcast<u32>(((_e43 % 32u) & 31u))));
    }
    if _e488 {
        let _e511 = atomicOr((&masks[(1024u + _e498)]), (1u << bitcast<u32>(((_e43 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e513 = atomicLoad((&masks[_e493]));
    let _e516 = atomicLoad((&masks[(1024u + _e498)]));
    let _e523 = countOneBits((_e513 & ((1u << bitcast<u32>(((_e43 % 32u) & 31u))) - 1u)));
    let _e530 = countOneBits((_e516 & ((1u << bitcast<u32>(((_e43 % 32u) & 31u))) - 1u)));
    let _e532 = atomicLoad((&counts[_e493]));
    let _e535 = atomicLoad((&counts[_e498]));
    let _e537 = atomicLoad((&masks[_e498]));
    workgroupBarrier();
    if _e480 {
        if (_e523 == 0u) {
            let _e544 = atomicAdd((&counts[_e493]), countOneBits(_e513));
            atomicStore((&masks[_e493]), 0u);
        }
    }
    if _e488 {
        if (_e530 == 0u) {
            let _e549 = atomicAdd((&counts[_e498]), countOneBits(_e516));
            atomicStore((&masks[(1024u + _e498)]), 0u);
        }
    }
    workgroupBarrier();
    let _e559 = (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 64u) + (_e43 % 32u))) < _e60);
    let _e567 = (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 96u) + (_e43 % 32u))) < _e60);
    let _e572 = (_e56 + ((_e118 >> bitcast<u32>((_e58 & 31u))) & 255u));
    let _e577 = (_e56 + ((_e130 >> bitcast<u32>((_e58 & 31u))) & 255u));
    if _e559 {
        let _e583 = atomicOr((&masks[_e572]), (1u << bitcast<u32>(((_e43 % 32u) & 31u))));
    }
    if _e567 {
        let _e590 = atomicOr((&masks[(1024u + _e577)]), (1u << bitcast<u32>(((_e43 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e592 = atomicLoad((&masks[_e572]));
    let _e595 = atomicLoad((&masks[(1024u + _e577)]));
    let _e602 = countOneBits((_e592 & ((1u << bitcast<u32>(((_e43 % 32u) & 31u))) - 1u)));
    let _e609 = countOneBits((_e595 & ((1u << bitcast<u32>(((_e43 % 32u) & 31u))) - 1u)));
    let _e611 = atomicLoad((&counts[_e572]));
    let _e614 = atomicLoad((&counts[_e577]));
    let _e616 = atomicLoad((&masks[_e577]));
    workgroupBarrier();
    if _e559 {
        if (_e602 == 0u) {
            let _e623 = atomicAdd((&counts[_e572]), countOneBits(_e592));
            atomicStore((&masks[_e572]), 0u);
        }
    }
    if _e567 {
        if (_e609 == 0u) {
            let _e628 = atomicAdd((&counts[_e577]), countOneBits(_e595));
            atomicStore((&masks[(1024u + _e577)]), 0u);
        }
    }
    workgroupBarrier();
    let _e638 = (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 128u) + (_e43 % 32u))) < _e60);
    let _e646 = (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 160u) + (_e43 % 32u))) < _e60);
    let _e651 = (_e56 + ((_e166 >> bitcast<u32>((_e58 & 31u))) & 255u));
    let _e656 = (_e56 + ((_e178 >> bitcast<u32>((_e58 & 31u))) & 255u));
    if _e638 {
        let _e662 = atomicOr((&masks[_e651]), (1u << bitcast<u32>(((_e43 % 32u) & 31u))));
    }
    if _e646 {
        let _e669 = atomicOr((&masks[(1024u + _e656)]), (1u << bitcast<u32>(((_e43 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e671 = atomicLoad((&masks[_e651]));
    let _e674 = atomicLoad((&masks[(1024u + _e656)]));
    let _e681 = countOneBits((_e671 & ((1u << bitcast<u32>(((_e43 % 32u) & 31u))) - 1u)));
    let _e688 = countOneBits((_e674 & ((1u << bitcast<u32>(((_e43 % 32u) & 31u))) - 1u)));
    let _e690 = atomicLoad((&counts[_e651]));
    let _e693 = atomicLoad((&counts[_e656]));
    let _e695 = atomicLoad((&masks[_e656]));
    workgroupBarrier();
    if _e638 {
        if (_e681 == 0u) {
            let _e702 = atomicAdd((&counts[_e651]), countOneBits(_e671));
            atomicStore((&masks[_e651]), 0u);
        }
    }
    if _e646 {
        if (_e688 == 0u) {
            let _e707 = atomicAdd((&counts[_e656]), countOneBits(_e674));
            atomicStore((&masks[(1024u + _e656)]), 0u);
        }
    }
    workgroupBarrier();
    let _e717 = (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 192u) + (_e43 % 32u))) < _e60);
    let _e725 = (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 224u) + (_e43 % 32u))) < _e60);
    let _e730 = (_e56 + ((_e214 >> bitcast<u32>((_e58 & 31u))) & 255u));
    let _e735 = (_e56 + ((_e226 >> bitcast<u32>((_e58 & 31u))) & 255u));
    if _e717 {
        let _e741 = atomicOr((&masks[_e730]), (1u << bitcast<u32>(((_e43 % 32u) & 31u))));
    }
    if _e725 {
        let _e748 = atomicOr((&masks[(1024u + _e735)]), (1u << bitcast<u32>(((_e43 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e750 = atomicLoad((&masks[_e730]));
    let _e753 = atomicLoad((&masks[(1024u + _e735)]));
    let _e760 = countOneBits((_e750 & ((1u << bitcast<u32>(((_e43 % 32u) & 31u))) - 1u)));
    let _e767 = countOneBits((_e753 & ((1u << bitcast<u32>(((_e43 % 32u) & 31u))) - 1u)));
    let _e769 = atomicLoad((&counts[_e730]));
    let _e772 = atomicLoad((&counts[_e735]));
    let _e774 = atomicLoad((&masks[_e735]));
    workgroupBarrier();
    if _e717 {
        if (_e760 == 0u) {
            let _e781 = atomicAdd((&counts[_e730]), countOneBits(_e750));
            atomicStore((&masks[_e730]), 0u);
        }
    }
    if _e725 {
        if (_e767 == 0u) {
            let _e786 = atomicAdd((&counts[_e735]), countOneBits(_e753));
            atomicStore((&masks[(1024u + _e735)]), 0u);
        }
    }
    workgroupBarrier();
    let _e796 = (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 256u) + (_e43 % 32u))) < _e60);
    let _e804 = (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 288u) + (_e43 % 32u))) < _e60);
    let _e809 = (_e56 + ((_e262 >> bitcast<u32>((_e58 & 31u))) & 255u));
    let _e814 = (_e56 + ((_e274 >> bitcast<u32>((_e58 & 31u))) & 255u));
    if _e796 {
        let _e820 = atomicOr((&masks[_e809]), (1u << bitcast<u32>(((_e43 % 32u) & 31u))));
    }
    if _e804 {
        let _e827 = atomicOr((&masks[(1024u + _e814)]), (1u << bitcast<u32>(((_e43 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e829 = atomicLoad((&masks[_e809]));
    let _e832 = atomicLoad((&masks[(1024u + _e814)]));
    let _e839 = countOneBits((_e829 & ((1u << bitcast<u32>(((_e43 % 32u) & 31u))) - 1u)));
    let _e846 = countOneBits((_e832 & ((1u << bitcast<u32>(((_e43 % 32u) & 31u))) - 1u)));
    let _e848 = atomicLoad((&counts[_e809]));
    let _e851 = atomicLoad((&counts[_e814]));
    let _e853 = atomicLoad((&masks[_e814]));
    workgroupBarrier();
    if _e796 {
        if (_e839 == 0u) {
            let _e860 = atomicAdd((&counts[_e809]), countOneBits(_e829));
            atomicStore((&masks[_e809]), 0u);
        }
    }
    if _e804 {
        if (_e846 == 0u) {
            let _e865 = atomicAdd((&counts[_e814]), countOneBits(_e832));
            atomicStore((&masks[(1024u + _e814)]), 0u);
        }
    }
    workgroupBarrier();
    let _e875 = (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 320u) + (_e43 % 32u))) < _e60);
    let _e883 = (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 352u) + (_e43 % 32u))) < _e60);
    let _e888 = (_e56 + ((_e310 >> bitcast<u32>((_e58 & 31u))) & 255u));
    let _e893 = (_e56 + ((_e322 >> bitcast<u32>((_e58 & 31u))) & 255u));
    if _e875 {
        let _e899 = atomicOr((&masks[_e888]), (1u << bitcast<u32>(((_e43 % 32u) & 31u))));
    }
    if _e883 {
        let _e906 = atomicOr((&masks[(1024u + _e893)]), (1u << bitcast<u32>(((_e43 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e908 = atomicLoad((&masks[_e888]));
    let _e911 = atomicLoad((&masks[(1024u + _e893)]));
    let _e918 = countOneBits((_e908 & ((1u << bitcast<u32>(((_e43 % 32u) & 31u))) - 1u)));
    let _e925 = countOneBits((_e911 & ((1u << bitcast<u32>(((_e43 % 32u) & 31u))) - 1u)));
    let _e927 = atomicLoad((&counts[_e888]));
    let _e930 = atomicLoad((&counts[_e893]));
    let _e932 = atomicLoad((&masks[_e893]));
    workgroupBarrier();
    if _e875 {
        if (_e918 == 0u) {
            let _e939 = atomicAdd((&counts[_e888]), countOneBits(_e908));
            atomicStore((&masks[_e888]), 0u);
        }
    }
    if _e883 {
        if (_e925 == 0u) {
            let _e944 = atomicAdd((&counts[_e893]), countOneBits(_e911));
            atomicStore((&masks[(1024u + _e893)]), 0u);
        }
    }
    workgroupBarrier();
    let _e954 = (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 384u) + (_e43 % 32u))) < _e60);
    let _e962 = (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 416u) + (_e43 % 32u))) < _e60);
    let _e967 = (_e56 + ((_e358 >> bitcast<u32>((_e58 & 31u))) & 255u));
    let _e972 = (_e56 + ((_e370 >> bitcast<u32>((_e58 & 31u))) & 255u));
    if _e954 {
        let _e978 = atomicOr((&masks[_e967]), (1u << bitcast<u32>(((_e43 % 32u) & 31u))));
    }
    if _e962 {
        let _e985 = atomicOr((&masks[(1024u + _e972)]), (1u << bitcast<u32>(((_e43 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e987 = atomicLoad((&masks[_e967]));
    let _e990 = atomicLoad((&masks[(1024u + _e972)]));
    let _e997 = countOneBits((_e987 & ((1u << bitcast<u32>(((_e43 % 32u) & 31u))) - 1u)));
    let _e1004 = countOneBits((_e990 & ((1u << bitcast<u32>(((_e43 % 32u) & 31u))) - 1u)));
    let _e1006 = atomicLoad((&counts[_e967]));
    let _e1009 = atomicLoad((&counts[_e972]));
    let _e1011 = atomicLoad((&masks[_e972]));
    workgroupBarrier();
    if _e954 {
        if (_e997 == 0u) {
            let _e1018 = atomicAdd((&counts[_e967]), countOneBits(_e987));
            atomicStore((&masks[_e967]), 0u);
        }
    }
    if _e962 {
        if (_e1004 == 0u) {
            let _e1023 = atomicAdd((&counts[_e972]), countOneBits(_e990));
            atomicStore((&masks[(1024u + _e972)]), 0u);
        }
    }
    workgroupBarrier();
    let _e1033 = (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 448u) + (_e43 % 32u))) < _e60);
    let _e1041 = (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 480u) + (_e43 % 32u))) < _e60);
    let _e1046 = (_e56 + ((_e406 >> bitcast<u32>((_e58 & 31u))) & 255u));
    let _e1051 = (_e56 + ((_e418 >> bitcast<u32>((_e58 & 31u))) & 255u));
    if _e1033 {
        let _e1057 = atomicOr((&masks[_e1046]), (1u << bitcast<u32>(((_e43 % 32u) & 31u))));
    }
    if _e1041 {
        let _e1064 = atomicOr((&masks[(1024u + _e1051)]), (1u << bitcast<u32>(((_e43 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e1066 = atomicLoad((&masks[_e1046]));
    let _e1069 = atomicLoad((&masks[(1024u + _e1051)]));
    let _e1076 = countOneBits((_e1066 & ((1u << bitcast<u32>(((_e43 % 32u) & 31u))) - 1u)));
    let _e1083 = countOneBits((_e1069 & ((1u << bitcast<u32>(((_e43 % 32u) & 31u))) - 1u)));
    let _e1085 = atomicLoad((&counts[_e1046]));
    let _e1088 = atomicLoad((&counts[_e1051]));
    let _e1090 = atomicLoad((&masks[_e1051]));
    workgroupBarrier();
    if _e1033 {
        if (_e1076 == 0u) {
            let _e1097 = atomicAdd((&counts[_e1046]), countOneBits(_e1066));
            atomicStore((&masks[_e1046]), 0u);
        }
    }
    if _e1041 {
        if (_e1083 == 0u) {
            let _e1102 = atomicAdd((&counts[_e1051]), countOneBits(_e1069));
            atomicStore((&masks[(1024u + _e1051)]), 0u);
        }
    }
    workgroupBarrier();
    let _e1106 = params.member.member_11;
    let _e1107 = (256u * _e1106);
    let _e1111 = table.member[(_e1107 + (2u * _e43))];
    let _e1116 = table.member[((_e1107 + (2u * _e43)) + 1u)];
    let _e1117 = (_e1111 + _e1116);
    atomicStore((&masks[_e43]), _e1117);
    phi_1652_ = type_13(0u, 7u);
    phi_1655_ = 0u;
    phi_1657_ = 1u;
    phi_1659_ = _e1117;
    phi_1656_ = 1024u;
    loop {
        let _e1120 = phi_1652_;
        let _e1122 = phi_1655_;
        let _e1124 = phi_1657_;
        let _e1126 = phi_1659_;
        let _e1128 = phi_1656_;
        local = _e1126;
        if (_e1120.member < _e1120.member_1) {
            phi_1653_ = type_13((_e1120.member + 1u), _e1120.member_1);
            phi_1682_ = type_13(1u, _e1120.member);
        } else {
            phi_1653_ = _e1120;
            phi_1682_ = type_13(0u, type_13().member_1);
        }
        let _e1140 = phi_1653_;
        let _e1142 = phi_1682_;
        let _e1145 = (bitcast<i32>(_e1142.member) != 0i);
        if _e1145 {
            workgroupBarrier();
            if (_e43 >= _e1124) {
                let _e1150 = atomicLoad((&masks[((_e1122 + _e43) - _e1124)]));
                phi_1698_ = (_e1126 + _e1150);
            } else {
                phi_1698_ = _e1126;
            }
            let _e1153 = phi_1698_;
            atomicStore((&masks[(_e1128 + _e43)]), _e1153);
            phi_1658_ = (_e1124 * 2u);
            phi_1660_ = _e1153;
        } else {
            phi_1658_ = u32();
            phi_1660_ = u32();
        }
        let _e1158 = phi_1658_;
        let _e1160 = phi_1660_;
        continue;
        continuing {
            phi_1652_ = _e1140;
            phi_1655_ = _e1128;
            phi_1657_ = _e1158;
            phi_1659_ = _e1160;
            phi_1656_ = _e1122;
            break if !(_e1145);
        }
    }
    workgroupBarrier();
    let _e1163 = local;
    phi_1705_ = type_13(0u, 2u);
    phi_1708_ = (_e1163 - _e1117);
    loop {
        let _e1166 = phi_1705_;
        let _e1168 = phi_1708_;
        if (_e1166.member < _e1166.member_1) {
            phi_1706_ = type_13((_e1166.member + 1u), _e1166.member_1);
            phi_1731_ = type_13(1u, _e1166.member);
        } else {
            phi_1706_ = _e1166;
            phi_1731_ = type_13(0u, type_13().member_1);
        }
        let _e1180 = phi_1706_;
        let _e1182 = phi_1731_;
        let _e1186 = (bitcast<i32>(_e1182.member) != 0i);
        if _e1186 {
            let _e1188 = ((2u * _e43) + _e1182.member_1);
            let _e1190 = params.member.member_11;
            if (_e54 < _e1190) {
                let _e1193 = params.member.member_11;
                let _e1197 = table.member[((_e1188 * _e1193) + _e54)];
                phi_1761_ = _e1197;
            } else {
                phi_1761_ = 0u;
            }
            let _e1199 = phi_1761_;
            phi_1765_ = type_13(0u, 4u);
            phi_1768_ = (_e1168 + _e1199);
            loop {
                let _e1202 = phi_1765_;
                let _e1204 = phi_1768_;
                if (_e1202.member < _e1202.member_1) {
                    phi_1766_ = type_13((_e1202.member + 1u), _e1202.member_1);
                    phi_1791_ = type_13(1u, _e1202.member);
                } else {
                    phi_1766_ = _e1202;
                    phi_1791_ = type_13(0u, type_13().member_1);
                }
                let _e1216 = phi_1766_;
                let _e1218 = phi_1791_;
                let _e1222 = (bitcast<i32>(_e1218.member) != 0i);
                if _e1222 {
                    let _e1224 = ((_e1218.member_1 * 256u) + _e1188);
                    let _e1226 = atomicLoad((&counts[_e1224]));
                    atomicStore((&counts[_e1224]), _e1204);
                    phi_1769_ = (_e1204 + _e1226);
                } else {
                    phi_1769_ = u32();
                }
                let _e1230 = phi_1769_;
                continue;
                continuing {
                    phi_1765_ = _e1216;
                    phi_1768_ = _e1230;
                    break if !(_e1222);
                }
            }
            phi_1709_ = (_e1168 + _e1111);
        } else {
            phi_1709_ = u32();
        }
        let _e1234 = phi_1709_;
        continue;
        continuing {
            phi_1705_ = _e1180;
            phi_1708_ = _e1234;
            break if !(_e1186);
        }
    }
    workgroupBarrier();
    if (((_e54 * 2048u) + (((_e43 / 32u) * 512u) + (_e43 % 32u))) < _e60) {
        let _e1249 = atomicLoad((&counts[(_e56 + ((_e71 >> bitcast<u32>((_e58 & 31u))) & 255u))]));
        let _e1250 = (_e1249 + (_e532 + _e523));
        keys_out.member[_e1250] = _e71;
        values_out.member[_e1250] = _e94;
    }
    if (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 32u) + (_e43 % 32u))) < _e60) {
        let _e1267 = atomicLoad((&counts[(_e56 + ((_e83 >> bitcast<u32>((_e58 & 31u))) & 255u))]));
        let _e1268 = (_e1267 + ((_e535 + countOneBits(_e537)) + _e530));
        keys_out.member[_e1268] = _e83;
        values_out.member[_e1268] = _e106;
    }
    if (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 64u) + (_e43 % 32u))) < _e60) {
        let _e1285 = atomicLoad((&counts[(_e56 + ((_e118 >> bitcast<u32>((_e58 & 31u))) & 255u))]));
        let _e1286 = (_e1285 + (_e611 + _e602));
        keys_out.member[_e1286] = _e118;
        values_out.member[_e1286] = _e142;
    }
    if (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 96u) + (_e43 % 32u))) < _e60) {
        let _e1303 = atomicLoad((&counts[(_e56 + ((_e130 >> bitcast<u32>((_e58 & 31u))) & 255u))]));
        let _e1304 = (_e1303 + ((_e614 + countOneBits(_e616)) + _e609));
        keys_out.member[_e1304] = _e130;
        values_out.member[_e1304] = _e154;
    }
    if (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 128u) + (_e43 % 32u))) < _e60) {
        let _e1321 = atomicLoad((&counts[(_e56 + ((_e166 >> bitcast<u32>((_e58 & 31u))) & 255u))]));
        let _e1322 = (_e1321 + (_e690 + _e681));
        keys_out.member[_e1322] = _e166;
        values_out.member[_e1322] = _e190;
    }
    if (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 160u) + (_e43 % 32u))) < _e60) {
        let _e1339 = atomicLoad((&counts[(_e56 + ((_e178 >> bitcast<u32>((_e58 & 31u))) & 255u))]));
        let _e1340 = (_e1339 + ((_e693 + countOneBits(_e695)) + _e688));
        keys_out.member[_e1340] = _e178;
        values_out.member[_e1340] = _e202;
    }
    if (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 192u) + (_e43 % 32u))) < _e60) {
        let _e1357 = atomicLoad((&counts[(_e56 + ((_e214 >> bitcast<u32>((_e58 & 31u))) & 255u))]));
        let _e1358 = (_e1357 + (_e769 + _e760));
        keys_out.member[_e1358] = _e214;
        values_out.member[_e1358] = _e238;
    }
    if (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 224u) + (_e43 % 32u))) < _e60) {
        let _e1375 = atomicLoad((&counts[(_e56 + ((_e226 >> bitcast<u32>((_e58 & 31u))) & 255u))]));
        let _e1376 = (_e1375 + ((_e772 + countOneBits(_e774)) + _e767));
        keys_out.member[_e1376] = _e226;
        values_out.member[_e1376] = _e250;
    }
    if (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 256u) + (_e43 % 32u))) < _e60) {
        let _e1393 = atomicLoad((&counts[(_e56 + ((_e262 >> bitcast<u32>((_e58 & 31u))) & 255u))]));
        let _e1394 = (_e1393 + (_e848 + _e839));
        keys_out.member[_e1394] = _e262;
        values_out.member[_e1394] = _e286;
    }
    if (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 288u) + (_e43 % 32u))) < _e60) {
        let _e1411 = atomicLoad((&counts[(_e56 + ((_e274 >> bitcast<u32>((_e58 & 31u))) & 255u))]));
        let _e1412 = (_e1411 + ((_e851 + countOneBits(_e853)) + _e846));
        keys_out.member[_e1412] = _e274;
        values_out.member[_e1412] = _e298;
    }
    if (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 320u) + (_e43 % 32u))) < _e60) {
        let _e1429 = atomicLoad((&counts[(_e56 + ((_e310 >> bitcast<u32>((_e58 & 31u))) & 255u))]));
        let _e1430 = (_e1429 + (_e927 + _e918));
        keys_out.member[_e1430] = _e310;
        values_out.member[_e1430] = _e334;
    }
    if (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 352u) + (_e43 % 32u))) < _e60) {
        let _e1447 = atomicLoad((&counts[(_e56 + ((_e322 >> bitcast<u32>((_e58 & 31u))) & 255u))]));
        let _e1448 = (_e1447 + ((_e930 + countOneBits(_e932)) + _e925));
        keys_out.member[_e1448] = _e322;
        values_out.member[_e1448] = _e346;
    }
    if (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 384u) + (_e43 % 32u))) < _e60) {
        let _e1465 = atomicLoad((&counts[(_e56 + ((_e358 >> bitcast<u32>((_e58 & 31u))) & 255u))]));
        let _e1466 = (_e1465 + (_e1006 + _e997));
        keys_out.member[_e1466] = _e358;
        values_out.member[_e1466] = _e382;
    }
    if (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 416u) + (_e43 % 32u))) < _e60) {
        let _e1483 = atomicLoad((&counts[(_e56 + ((_e370 >> bitcast<u32>((_e58 & 31u))) & 255u))]));
        let _e1484 = (_e1483 + ((_e1009 + countOneBits(_e1011)) + _e1004));
        keys_out.member[_e1484] = _e370;
        values_out.member[_e1484] = _e394;
    }
    if (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 448u) + (_e43 % 32u))) < _e60) {
        let _e1501 = atomicLoad((&counts[(_e56 + ((_e406 >> bitcast<u32>((_e58 & 31u))) & 255u))]));
        let _e1502 = (_e1501 + (_e1085 + _e1076));
        keys_out.member[_e1502] = _e406;
        values_out.member[_e1502] = _e430;
    }
    if (((_e54 * 2048u) + ((((_e43 / 32u) * 512u) + 480u) + (_e43 % 32u))) < _e60) {
        let _e1519 = atomicLoad((&counts[(_e56 + ((_e418 >> bitcast<u32>((_e58 & 31u))) & 255u))]));
        let _e1520 = (_e1519 + ((_e1088 + countOneBits(_e1090)) + _e1083));
        keys_out.member[_e1520] = _e418;
        values_out.member[_e1520] = _e442;
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn sort_scatter(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}

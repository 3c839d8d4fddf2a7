struct type_10 {
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

struct type_12 {
    member: type_10,
}

struct type_16 {
    member: array<u32>,
}

struct type_21 {
    member: u32,
    member_1: u32,
}

var<private> id_1: vec3<u32>;
var<private> n_1: vec3<u32>;
var<private> lane_1: u32;
@group(0) @binding(0) 
var<storage> params: type_12;
@group(0) @binding(1) 
var<storage> table: type_16;
@group(0) @binding(2) 
var<storage> keys: type_16;
@group(0) @binding(3) 
var<storage> values: type_16;
@group(0) @binding(4) 
var<storage, read_write> keys_out: type_16;
@group(0) @binding(5) 
var<storage, read_write> values_out: type_16;
var<workgroup> masks: array<atomic<u32>, 2048>;
var<workgroup> counts: array<atomic<u32>, 1024>;

fn function_() {
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
    var phi_834_: type_21;
    var phi_835_: type_21;
    var phi_858_: type_21;
    var phi_1652_: type_21;
    var phi_1655_: u32;
    var phi_1657_: u32;
    var phi_1659_: u32;
    var phi_1656_: u32;
    var phi_1653_: type_21;
    var phi_1682_: type_21;
    var phi_1698_: u32;
    var phi_1658_: u32;
    var phi_1660_: u32;
    var local: u32;
    var phi_1705_: type_21;
    var phi_1708_: u32;
    var phi_1706_: type_21;
    var phi_1731_: type_21;
    var phi_1761_: u32;
    var phi_1765_: type_21;
    var phi_1768_: u32;
    var phi_1766_: type_21;
    var phi_1791_: type_21;
    var phi_1769_: u32;
    var phi_1709_: u32;

    let _e49 = id_1;
    let _e50 = n_1;
    let _e51 = lane_1;
    let _e62 = ((_e49.y * _e50.x) + _e49.x);
    let _e64 = ((_e51 / 32u) * 256u);
    let _e66 = params.member.member_10;
    let _e68 = params.member.member_17;
    let _e74 = ((_e62 * 2048u) + (((_e51 / 32u) * 512u) + (_e51 % 32u)));
    if (_e74 < _e68) {
        let _e77 = keys.member[_e74];
        phi_118_ = _e77;
    } else {
        phi_118_ = 0u;
    }
    let _e79 = phi_118_;
    let _e86 = ((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 32u) + (_e51 % 32u)));
    if (_e86 < _e68) {
        let _e89 = keys.member[_e86];
        phi_141_ = _e89;
    } else {
        phi_141_ = 0u;
    }
    let _e91 = phi_141_;
    let _e97 = ((_e62 * 2048u) + (((_e51 / 32u) * 512u) + (_e51 % 32u)));
    if (_e97 < _e68) {
        let _e100 = values.member[_e97];
        phi_164_ = _e100;
    } else {
        phi_164_ = 0u;
    }
    let _e102 = phi_164_;
    let _e109 = ((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 32u) + (_e51 % 32u)));
    if (_e109 < _e68) {
        let _e112 = values.member[_e109];
        phi_187_ = _e112;
    } else {
        phi_187_ = 0u;
    }
    let _e114 = phi_187_;
    let _e121 = ((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 64u) + (_e51 % 32u)));
    if (_e121 < _e68) {
        let _e124 = keys.member[_e121];
        phi_210_ = _e124;
    } else {
        phi_210_ = 0u;
    }
    let _e126 = phi_210_;
    let _e133 = ((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 96u) + (_e51 % 32u)));
    if (_e133 < _e68) {
        let _e136 = keys.member[_e133];
        phi_233_ = _e136;
    } else {
        phi_233_ = 0u;
    }
    let _e138 = phi_233_;
    let _e145 = ((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 64u) + (_e51 % 32u)));
    if (_e145 < _e68) {
        let _e148 = values.member[_e145];
        phi_256_ = _e148;
    } else {
        phi_256_ = 0u;
    }
    let _e150 = phi_256_;
    let _e157 = ((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 96u) + (_e51 % 32u)));
    if (_e157 < _e68) {
        let _e160 = values.member[_e157];
        phi_279_ = _e160;
    } else {
        phi_279_ = 0u;
    }
    let _e162 = phi_279_;
    let _e169 = ((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 128u) + (_e51 % 32u)));
    if (_e169 < _e68) {
        let _e172 = keys.member[_e169];
        phi_302_ = _e172;
    } else {
        phi_302_ = 0u;
    }
    let _e174 = phi_302_;
    let _e181 = ((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 160u) + (_e51 % 32u)));
    if (_e181 < _e68) {
        let _e184 = keys.member[_e181];
        phi_325_ = _e184;
    } else {
        phi_325_ = 0u;
    }
    let _e186 = phi_325_;
    let _e193 = ((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 128u) + (_e51 % 32u)));
    if (_e193 < _e68) {
        let _e196 = values.member[_e193];
        phi_348_ = _e196;
    } else {
        phi_348_ = 0u;
    }
    let _e198 = phi_348_;
    let _e205 = ((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 160u) + (_e51 % 32u)));
    if (_e205 < _e68) {
        let _e208 = values.member[_e205];
        phi_371_ = _e208;
    } else {
        phi_371_ = 0u;
    }
    let _e210 = phi_371_;
    let _e217 = ((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 192u) + (_e51 % 32u)));
    if (_e217 < _e68) {
        let _e220 = keys.member[_e217];
        phi_394_ = _e220;
    } else {
        phi_394_ = 0u;
    }
    let _e222 = phi_394_;
    let _e229 = ((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 224u) + (_e51 % 32u)));
    if (_e229 < _e68) {
        let _e232 = keys.member[_e229];
        phi_417_ = _e232;
    } else {
        phi_417_ = 0u;
    }
    let _e234 = phi_417_;
    let _e241 = ((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 192u) + (_e51 % 32u)));
    if (_e241 < _e68) {
        let _e244 = values.member[_e241];
        phi_440_ = _e244;
    } else {
        phi_440_ = 0u;
    }
    let _e246 = phi_440_;
    let _e253 = ((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 224u) + (_e51 % 32u)));
    if (_e253 < _e68) {
        let _e256 = values.member[_e253];
        phi_463_ = _e256;
    } else {
        phi_463_ = 0u;
    }
    let _e258 = phi_463_;
    let _e265 = ((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 256u) + (_e51 % 32u)));
    if (_e265 < _e68) {
        let _e268 = keys.member[_e265];
        phi_486_ = _e268;
    } else {
        phi_486_ = 0u;
    }
    let _e270 = phi_486_;
    let _e277 = ((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 288u) + (_e51 % 32u)));
    if (_e277 < _e68) {
        let _e280 = keys.member[_e277];
        phi_509_ = _e280;
    } else {
        phi_509_ = 0u;
    }
    let _e282 = phi_509_;
    let _e289 = ((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 256u) + (_e51 % 32u)));
    if (_e289 < _e68) {
        let _e292 = values.member[_e289];
        phi_532_ = _e292;
    } else {
        phi_532_ = 0u;
    }
    let _e294 = phi_532_;
    let _e301 = ((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 288u) + (_e51 % 32u)));
    if (_e301 < _e68) {
        let _e304 = values.member[_e301];
        phi_555_ = _e304;
    } else {
        phi_555_ = 0u;
    }
    let _e306 = phi_555_;
    let _e313 = ((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 320u) + (_e51 % 32u)));
    if (_e313 < _e68) {
        let _e316 = keys.member[_e313];
        phi_578_ = _e316;
    } else {
        phi_578_ = 0u;
    }
    let _e318 = phi_578_;
    let _e325 = ((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 352u) + (_e51 % 32u)));
    if (_e325 < _e68) {
        let _e328 = keys.member[_e325];
        phi_601_ = _e328;
    } else {
        phi_601_ = 0u;
    }
    let _e330 = phi_601_;
    let _e337 = ((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 320u) + (_e51 % 32u)));
    if (_e337 < _e68) {
        let _e340 = values.member[_e337];
        phi_624_ = _e340;
    } else {
        phi_624_ = 0u;
    }
    let _e342 = phi_624_;
    let _e349 = ((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 352u) + (_e51 % 32u)));
    if (_e349 < _e68) {
        let _e352 = values.member[_e349];
        phi_647_ = _e352;
    } else {
        phi_647_ = 0u;
    }
    let _e354 = phi_647_;
    let _e361 = ((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 384u) + (_e51 % 32u)));
    if (_e361 < _e68) {
        let _e364 = keys.member[_e361];
        phi_670_ = _e364;
    } else {
        phi_670_ = 0u;
    }
    let _e366 = phi_670_;
    let _e373 = ((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 416u) + (_e51 % 32u)));
    if (_e373 < _e68) {
        let _e376 = keys.member[_e373];
        phi_693_ = _e376;
    } else {
        phi_693_ = 0u;
    }
    let _e378 = phi_693_;
    let _e385 = ((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 384u) + (_e51 % 32u)));
    if (_e385 < _e68) {
        let _e388 = values.member[_e385];
        phi_716_ = _e388;
    } else {
        phi_716_ = 0u;
    }
    let _e390 = phi_716_;
    let _e397 = ((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 416u) + (_e51 % 32u)));
    if (_e397 < _e68) {
        let _e400 = values.member[_e397];
        phi_739_ = _e400;
    } else {
        phi_739_ = 0u;
    }
    let _e402 = phi_739_;
    let _e409 = ((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 448u) + (_e51 % 32u)));
    if (_e409 < _e68) {
        let _e412 = keys.member[_e409];
        phi_762_ = _e412;
    } else {
        phi_762_ = 0u;
    }
    let _e414 = phi_762_;
    let _e421 = ((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 480u) + (_e51 % 32u)));
    if (_e421 < _e68) {
        let _e424 = keys.member[_e421];
        phi_785_ = _e424;
    } else {
        phi_785_ = 0u;
    }
    let _e426 = phi_785_;
    let _e433 = ((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 448u) + (_e51 % 32u)));
    if (_e433 < _e68) {
        let _e436 = values.member[_e433];
        phi_808_ = _e436;
    } else {
        phi_808_ = 0u;
    }
    let _e438 = phi_808_;
    let _e445 = ((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 480u) + (_e51 % 32u)));
    if (_e445 < _e68) {
        let _e448 = values.member[_e445];
        phi_831_ = _e448;
    } else {
        phi_831_ = 0u;
    }
    let _e450 = phi_831_;
    phi_834_ = type_21(0u, 8u);
    loop {
        let _e452 = phi_834_;
        if (_e452.member < _e452.member_1) {
            phi_835_ = type_21((_e452.member + 1u), _e452.member_1);
            phi_858_ = type_21(1u, _e452.member);
        } else {
            phi_835_ = _e452;
            phi_858_ = type_21(0u, type_21().member_1);
        }
        let _e466 = phi_835_;
        let _e468 = phi_858_;
        let _e472 = (bitcast<i32>(_e468.member) != 0i);
        if _e472 {
            atomicStore((&masks[((_e468.member_1 * 128u) + _e51)]), 0u);
            atomicStore((&masks[((1024u + (_e468.member_1 * 128u)) + _e51)]), 0u);
            atomicStore((&counts[((_e468.member_1 * 128u) + _e51)]), 0u);
        }
        continue;
        continuing {
            phi_834_ = _e466;
            break if !(_e472);
        }
    }
    workgroupBarrier();
    let _e490 = (((_e62 * 2048u) + (((_e51 / 32u) * 512u) + (_e51 % 32u))) < _e68);
    let _e498 = (((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 32u) + (_e51 % 32u))) < _e68);
    let _e503 = (_e64 + ((_e79 >> bitcast<u32>((_e66 & 31u))) & 255u));
    let _e508 = (_e64 + ((_e91 >> bitcast<u32>((_e66 & 31u))) & 255u));
    if _e490 {
        let _e514 = atomicOr((&masks[_e503]), (1u << bitcast<u32>(((_e51 % 32u) & 31u))));
    }
    if _e498 {
        let _e521 = atomicOr((&masks[(1024u + _e508)]), (1u << bitcast<u32>(((_e51 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e523 = atomicLoad((&masks[_e503]));
    let _e526 = atomicLoad((&masks[(1024u + _e508)]));
    let _e533 = countOneBits((_e523 & ((1u << bitcast<u32>(((_e51 % 32u) & 31u))) - 1u)));
    let _e540 = countOneBits((_e526 & ((1u << bitcast<u32>(((_e51 % 32u) & 31u))) - 1u)));
    let _e542 = atomicLoad((&counts[_e503]));
    let _e545 = atomicLoad((&counts[_e508]));
    let _e547 = atomicLoad((&masks[_e508]));
    workgroupBarrier();
    if _e490 {
        if (_e533 == 0u) {
            let _e554 = atomicAdd((&counts[_e503]), countOneBits(_e523));
            atomicStore((&masks[_e503]), 0u);
        }
    }
    if _e498 {
        if (_e540 == 0u) {
            let _e559 = atomicAdd((&counts[_e508]), countOneBits(_e526));
            atomicStore((&masks[(1024u + _e508)]), 0u);
        }
    }
    workgroupBarrier();
    let _e569 = (((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 64u) + (_e51 % 32u))) < _e68);
    let _e577 = (((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 96u) + (_e51 % 32u))) < _e68);
    let _e582 = (_e64 + ((_e126 >> bitcast<u32>((_e66 & 31u))) & 255u));
    let _e587 = (_e64 + ((_e138 >> bitcast<u32>((_e66 & 31u))) & 255u));
    if _e569 {
        let _e593 = atomicOr((&masks[_e582]), (1u << bitcast<u32>(((_e51 % 32u) & 31u))));
    }
    if _e577 {
        let _e600 = atomicOr((&masks[(1024u + _e587)]), (1u << bitcast<u32>(((_e51 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e602 = atomicLoad((&masks[_e582]));
    let _e605 = atomicLoad((&masks[(1024u + _e587)]));
    let _e612 = countOneBits((_e602 & ((1u << bitcast<u32>(((_e51 % 32u) & 31u))) - 1u)));
    let _e619 = countOneBits((_e605 & ((1u << bitcast<u32>(((_e51 % 32u) & 31u))) - 1u)));
    let _e621 = atomicLoad((&counts[_e582]));
    let _e624 = atomicLoad((&counts[_e587]));
    let _e626 = atomicLoad((&masks[_e587]));
    workgroupBarrier();
    if _e569 {
        if (_e612 == 0u) {
            let _e633 = atomicAdd((&counts[_e582]), countOneBits(_e602));
            atomicStore((&masks[_e582]), 0u);
        }
    }
    if _e577 {
        if (_e619 == 0u) {
            let _e638 = atomicAdd((&counts[_e587]), countOneBits(_e605));
            atomicStore((&masks[(1024u + _e587)]), 0u);
        }
    }
    workgroupBarrier();
    let _e648 = (((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 128u) + (_e51 % 32u))) < _e68);
    let _e656 = (((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 160u) + (_e51 % 32u))) < _e68);
    let _e661 = (_e64 + ((_e174 >> bitcast<u32>((_e66 & 31u))) & 255u));
    let _e666 = (_e64 + ((_e186 >> bitcast<u32>((_e66 & 31u))) & 255u));
    if _e648 {
        let _e672 = atomicOr((&masks[_e661]), (1u << bitcast<u32>(((_e51 % 32u) & 31u))));
    }
    if _e656 {
        let _e679 = atomicOr((&masks[(1024u + _e666)]), (1u << bitcast<u32>(((_e51 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e681 = atomicLoad((&masks[_e661]));
    let _e684 = atomicLoad((&masks[(1024u + _e666)]));
    let _e691 = countOneBits((_e681 & ((1u << bitcast<u32>(((_e51 % 32u) & 31u))) - 1u)));
    let _e698 = countOneBits((_e684 & ((1u << bitcast<u32>(((_e51 % 32u) & 31u))) - 1u)));
    let _e700 = atomicLoad((&counts[_e661]));
    let _e703 = atomicLoad((&counts[_e666]));
    let _e705 = atomicLoad((&masks[_e666]));
    workgroupBarrier();
    if _e648 {
        if (_e691 == 0u) {
            let _e712 = atomicAdd((&counts[_e661]), countOneBits(_e681));
            atomicStore((&masks[_e661]), 0u);
        }
    }
    if _e656 {
        if (_e698 == 0u) {
            let _e717 = atomicAdd((&counts[_e666]), countOneBits(_e684));
            atomicStore((&masks[(1024u + _e666)]), 0u);
        }
    }
    workgroupBarrier();
    let _e727 = (((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 192u) + (_e51 % 32u))) < _e68);
    let _e735 = (((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 224u) + (_e51 % 32u))) < _e68);
    let _e740 = (_e64 + ((_e222 >> bitcast<u32>((_e66 & 31u))) & 255u));
    let _e745 = (_e64 + ((_e234 >> bitcast<u32>((_e66 & 31u))) & 255u));
    if _e727 {
        let _e751 = atomicOr((&masks[_e740]), (1u << bitcast<u32>(((_e51 % 32u) & 31u))));
    }
    if _e735 {
        let _e758 = atomicOr((&masks[(1024u + _e745)]), (1u << bitcast<u32>(((_e51 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e760 = atomicLoad((&masks[_e740]));
    let _e763 = atomicLoad((&masks[(1024u + _e745)]));
    let _e770 = countOneBits((_e760 & ((1u << bitcast<u32>(((_e51 % 32u) & 31u))) - 1u)));
    let _e777 = countOneBits((_e763 & ((1u << bitcast<u32>(((_e51 % 32u) & 31u))) - 1u)));
    let _e779 = atomicLoad((&counts[_e740]));
    let _e782 = atomicLoad((&counts[_e745]));
    let _e784 = atomicLoad((&masks[_e745]));
    workgroupBarrier();
    if _e727 {
        if (_e770 == 0u) {
            let _e791 = atomicAdd((&counts[_e740]), countOneBits(_e760));
            atomicStore((&masks[_e740]), 0u);
        }
    }
    if _e735 {
        if (_e777 == 0u) {
            let _e796 = atomicAdd((&counts[_e745]), countOneBits(_e763));
            atomicStore((&masks[(1024u + _e745)]), 0u);
        }
    }
    workgroupBarrier();
    let _e806 = (((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 256u) + (_e51 % 32u))) < _e68);
    let _e814 = (((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 288u) + (_e51 % 32u))) < _e68);
    let _e819 = (_e64 + ((_e270 >> bitcast<u32>((_e66 & 31u))) & 255u));
    let _e824 = (_e64 + ((_e282 >> bitcast<u32>((_e66 & 31u))) & 255u));
    if _e806 {
        let _e830 = atomicOr((&masks[_e819]), (1u << bitcast<u32>(((_e51 % 32u) & 31u))));
    }
    if _e814 {
        let _e837 = atomicOr((&masks[(1024u + _e824)]), (1u << bitcast<u32>(((_e51 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e839 = atomicLoad((&masks[_e819]));
    let _e842 = atomicLoad((&masks[(1024u + _e824)]));
    let _e849 = countOneBits((_e839 & ((1u << bitcast<u32>(((_e51 % 32u) & 31u))) - 1u)));
    let _e856 = countOneBits((_e842 & ((1u << bitcast<u32>(((_e51 % 32u) & 31u))) - 1u)));
    let _e858 = atomicLoad((&counts[_e819]));
    let _e861 = atomicLoad((&counts[_e824]));
    let _e863 = atomicLoad((&masks[_e824]));
    workgroupBarrier();
    if _e806 {
        if (_e849 == 0u) {
            let _e870 = atomicAdd((&counts[_e819]), countOneBits(_e839));
            atomicStore((&masks[_e819]), 0u);
        }
    }
    if _e814 {
        if (_e856 == 0u) {
            let _e875 = atomicAdd((&counts[_e824]), countOneBits(_e842));
            atomicStore((&masks[(1024u + _e824)]), 0u);
        }
    }
    workgroupBarrier();
    let _e885 = (((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 320u) + (_e51 % 32u))) < _e68);
    let _e893 = (((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 352u) + (_e51 % 32u))) < _e68);
    let _e898 = (_e64 + ((_e318 >> bitcast<u32>((_e66 & 31u))) & 255u));
    let _e903 = (_e64 + ((_e330 >> bitcast<u32>((_e66 & 31u))) & 255u));
    if _e885 {
        let _e909 = atomicOr((&masks[_e898]), (1u << bitcast<u32>(((_e51 % 32u) & 31u))));
    }
    if _e893 {
        let _e916 = atomicOr((&masks[(1024u + _e903)]), (1u << bitcast<u32>(((_e51 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e918 = atomicLoad((&masks[_e898]));
    let _e921 = atomicLoad((&masks[(1024u + _e903)]));
    let _e928 = countOneBits((_e918 & ((1u << bitcast<u32>(((_e51 % 32u) & 31u))) - 1u)));
    let _e935 = countOneBits((_e921 & ((1u << bitcast<u32>(((_e51 % 32u) & 31u))) - 1u)));
    let _e937 = atomicLoad((&counts[_e898]));
    let _e940 = atomicLoad((&counts[_e903]));
    let _e942 = atomicLoad((&masks[_e903]));
    workgroupBarrier();
    if _e885 {
        if (_e928 == 0u) {
            let _e949 = atomicAdd((&counts[_e898]), countOneBits(_e918));
            atomicStore((&masks[_e898]), 0u);
        }
    }
    if _e893 {
        if (_e935 == 0u) {
            let _e954 = atomicAdd((&counts[_e903]), countOneBits(_e921));
            atomicStore((&masks[(1024u + _e903)]), 0u);
        }
    }
    workgroupBarrier();
    let _e964 = (((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 384u) + (_e51 % 32u))) < _e68);
    let _e972 = (((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 416u) + (_e51 % 32u))) < _e68);
    let _e977 = (_e64 + ((_e366 >> bitcast<u32>((_e66 & 31u))) & 255u));
    let _e982 = (_e64 + ((_e378 >> bitcast<u32>((_e66 & 31u))) & 255u));
    if _e964 {
        let _e988 = atomicOr((&masks[_e977]), (1u << bitcast<u32>(((_e51 % 32u) & 31u))));
    }
    if _e972 {
        let _e995 = atomicOr((&masks[(1024u + _e982)]), (1u << bitcast<u32>(((_e51 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e997 = atomicLoad((&masks[_e977]));
    let _e1000 = atomicLoad((&masks[(1024u + _e982)]));
    let _e1007 = countOneBits((_e997 & ((1u << bitcast<u32>(((_e51 % 32u) & 31u))) - 1u)));
    let _e1014 = countOneBits((_e1000 & ((1u << bitcast<u32>(((_e51 % 32u) & 31u))) - 1u)));
    let _e1016 = atomicLoad((&counts[_e977]));
    let _e1019 = atomicLoad((&counts[_e982]));
    let _e1021 = atomicLoad((&masks[_e982]));
    workgroupBarrier();
    if _e964 {
        if (_e1007 == 0u) {
            let _e1028 = atomicAdd((&counts[_e977]), countOneBits(_e997));
            atomicStore((&masks[_e977]), 0u);
        }
    }
    if _e972 {
        if (_e1014 == 0u) {
            let _e1033 = atomicAdd((&counts[_e982]), countOneBits(_e1000));
            atomicStore((&masks[(1024u + _e982)]), 0u);
        }
    }
    workgroupBarrier();
    let _e1043 = (((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 448u) + (_e51 % 32u))) < _e68);
    let _e1051 = (((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 480u) + (_e51 % 32u))) < _e68);
    let _e1056 = (_e64 + ((_e414 >> bitcast<u32>((_e66 & 31u))) & 255u));
    let _e1061 = (_e64 + ((_e426 >> bitcast<u32>((_e66 & 31u))) & 255u));
    if _e1043 {
        let _e1067 = atomicOr((&masks[_e1056]), (1u << bitcast<u32>(((_e51 % 32u) & 31u))));
    }
    if _e1051 {
        let _e1074 = atomicOr((&masks[(1024u + _e1061)]), (1u << bitcast<u32>(((_e51 % 32u) & 31u))));
    }
    workgroupBarrier();
    let _e1076 = atomicLoad((&masks[_e1056]));
    let _e1079 = atomicLoad((&masks[(1024u + _e1061)]));
    let _e1086 = countOneBits((_e1076 & ((1u << bitcast<u32>(((_e51 % 32u) & 31u))) - 1u)));
    let _e1093 = countOneBits((_e1079 & ((1u << bitcast<u32>(((_e51 % 32u) & 31u))) - 1u)));
    let _e1095 = atomicLoad((&counts[_e1056]));
    let _e1098 = atomicLoad((&counts[_e1061]));
    let _e1100 = atomicLoad((&masks[_e1061]));
    workgroupBarrier();
    if _e1043 {
        if (_e1086 == 0u) {
            let _e1107 = atomicAdd((&counts[_e1056]), countOneBits(_e1076));
            atomicStore((&masks[_e1056]), 0u);
        }
    }
    if _e1051 {
        if (_e1093 == 0u) {
            let _e1112 = atomicAdd((&counts[_e1061]), countOneBits(_e1079));
            atomicStore((&masks[(1024u + _e1061)]), 0u);
        }
    }
    workgroupBarrier();
    let _e1116 = params.member.member_11;
    let _e1117 = (256u * _e1116);
    let _e1121 = table.member[(_e1117 + (2u * _e51))];
    let _e1126 = table.member[((_e1117 + (2u * _e51)) + 1u)];
    let _e1127 = (_e1121 + _e1126);
    atomicStore((&masks[_e51]), _e1127);
    phi_1652_ = type_21(0u, 7u);
    phi_1655_ = 0u;
    phi_1657_ = 1u;
    phi_1659_ = _e1127;
    phi_1656_ = 1024u;
    loop {
        let _e1130 = phi_1652_;
        let _e1132 = phi_1655_;
        let _e1134 = phi_1657_;
        let _e1136 = phi_1659_;
        let _e1138 = phi_1656_;
        local = _e1136;
        if (_e1130.member < _e1130.member_1) {
            phi_1653_ = type_21((_e1130.member + 1u), _e1130.member_1);
            phi_1682_ = type_21(1u, _e1130.member);
        } else {
            phi_1653_ = _e1130;
            phi_1682_ = type_21(0u, type_21().member_1);
        }
        let _e1152 = phi_1653_;
        let _e1154 = phi_1682_;
        let _e1157 = (bitcast<i32>(_e1154.member) != 0i);
        if _e1157 {
            workgroupBarrier();
            if (_e51 >= _e1134) {
                let _e1162 = atomicLoad((&masks[((_e1132 + _e51) - _e1134)]));
                phi_1698_ = (_e1136 + _e1162);
            } else {
                phi_1698_ = _e1136;
            }
            let _e1165 = phi_1698_;
            atomicStore((&masks[(_e1138 + _e51)]), _e1165);
            phi_1658_ = (_e1134 * 2u);
            phi_1660_ = _e1165;
        } else {
            phi_1658_ = u32();
            phi_1660_ = u32();
        }
        let _e1170 = phi_1658_;
        let _e1172 = phi_1660_;
        continue;
        continuing {
            phi_1652_ = _e1152;
            phi_1655_ = _e1138;
            phi_1657_ = _e1170;
            phi_1659_ = _e1172;
            phi_1656_ = _e1132;
            break if !(_e1157);
        }
    }
    workgroupBarrier();
    let _e1175 = local;
    phi_1705_ = type_21(0u, 2u);
    phi_1708_ = (_e1175 - _e1127);
    loop {
        let _e1178 = phi_1705_;
        let _e1180 = phi_1708_;
        if (_e1178.member < _e1178.member_1) {
            phi_1706_ = type_21((_e1178.member + 1u), _e1178.member_1);
            phi_1731_ = type_21(1u, _e1178.member);
        } else {
            phi_1706_ = _e1178;
            phi_1731_ = type_21(0u, type_21().member_1);
        }
        let _e1194 = phi_1706_;
        let _e1196 = phi_1731_;
        let _e1200 = (bitcast<i32>(_e1196.member) != 0i);
        if _e1200 {
            let _e1202 = ((2u * _e51) + _e1196.member_1);
            let _e1204 = params.member.member_11;
            if (_e62 < _e1204) {
                let _e1207 = params.member.member_11;
                let _e1211 = table.member[((_e1202 * _e1207) + _e62)];
                phi_1761_ = _e1211;
            } else {
                phi_1761_ = 0u;
            }
            let _e1213 = phi_1761_;
            phi_1765_ = type_21(0u, 4u);
            phi_1768_ = (_e1180 + _e1213);
            loop {
                let _e1216 = phi_1765_;
                let _e1218 = phi_1768_;
                if (_e1216.member < _e1216.member_1) {
                    phi_1766_ = type_21((_e1216.member + 1u), _e1216.member_1);
                    phi_1791_ = type_21(1u, _e1216.member);
                } else {
                    phi_1766_ = _e1216;
                    phi_1791_ = type_21(0u, type_21().member_1);
                }
                let _e1232 = phi_1766_;
                let _e1234 = phi_1791_;
                let _e1238 = (bitcast<i32>(_e1234.member) != 0i);
                if _e1238 {
                    let _e1240 = ((_e1234.member_1 * 256u) + _e1202);
                    let _e1242 = atomicLoad((&counts[_e1240]));
                    atomicStore((&counts[_e1240]), _e1218);
                    phi_1769_ = (_e1218 + _e1242);
                } else {
                    phi_1769_ = u32();
                }
                let _e1246 = phi_1769_;
                continue;
                continuing {
                    phi_1765_ = _e1232;
                    phi_1768_ = _e1246;
                    break if !(_e1238);
                }
            }
            phi_1709_ = (_e1180 + _e1121);
        } else {
            phi_1709_ = u32();
        }
        let _e1250 = phi_1709_;
        continue;
        continuing {
            phi_1705_ = _e1194;
            phi_1708_ = _e1250;
            break if !(_e1200);
        }
    }
    workgroupBarrier();
    if (((_e62 * 2048u) + (((_e51 / 32u) * 512u) + (_e51 % 32u))) < _e68) {
        let _e1265 = atomicLoad((&counts[(_e64 + ((_e79 >> bitcast<u32>((_e66 & 31u))) & 255u))]));
        let _e1266 = (_e1265 + (_e542 + _e533));
        keys_out.member[_e1266] = _e79;
        values_out.member[_e1266] = _e102;
    }
    if (((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 32u) + (_e51 % 32u))) < _e68) {
        let _e1283 = atomicLoad((&counts[(_e64 + ((_e91 >> bitcast<u32>((_e66 & 31u))) & 255u))]));
        let _e1284 = (_e1283 + ((_e545 + countOneBits(_e547)) + _e540));
        keys_out.member[_e1284] = _e91;
        values_out.member[_e1284] = _e114;
    }
    if (((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 64u) + (_e51 % 32u))) < _e68) {
        let _e1301 = atomicLoad((&counts[(_e64 + ((_e126 >> bitcast<u32>((_e66 & 31u))) & 255u))]));
        let _e1302 = (_e1301 + (_e621 + _e612));
        keys_out.member[_e1302] = _e126;
        values_out.member[_e1302] = _e150;
    }
    if (((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 96u) + (_e51 % 32u))) < _e68) {
        let _e1319 = atomicLoad((&counts[(_e64 + ((_e138 >> bitcast<u32>((_e66 & 31u))) & 255u))]));
        let _e1320 = (_e1319 + ((_e624 + countOneBits(_e626)) + _e619));
        keys_out.member[_e1320] = _e138;
        values_out.member[_e1320] = _e162;
    }
    if (((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 128u) + (_e51 % 32u))) < _e68) {
        let _e1337 = atomicLoad((&counts[(_e64 + ((_e174 >> bitcast<u32>((_e66 & 31u))) & 255u))]));
        let _e1338 = (_e1337 + (_e700 + _e691));
        keys_out.member[_e1338] = _e174;
        values_out.member[_e1338] = _e198;
    }
    if (((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 160u) + (_e51 % 32u))) < _e68) {
        let _e1355 = atomicLoad((&counts[(_e64 + ((_e186 >> bitcast<u32>((_e66 & 31u))) & 255u))]));
        let _e1356 = (_e1355 + ((_e703 + countOneBits(_e705)) + _e698));
        keys_out.member[_e1356] = _e186;
        values_out.member[_e1356] = _e210;
    }
    if (((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 192u) + (_e51 % 32u))) < _e68) {
        let _e1373 = atomicLoad((&counts[(_e64 + ((_e222 >> bitcast<u32>((_e66 & 31u))) & 255u))]));
        let _e1374 = (_e1373 + (_e779 + _e770));
        keys_out.member[_e1374] = _e222;
        values_out.member[_e1374] = _e246;
    }
    if (((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 224u) + (_e51 % 32u))) < _e68) {
        let _e1391 = atomicLoad((&counts[(_e64 + ((_e234 >> bitcast<u32>((_e66 & 31u))) & 255u))]));
        let _e1392 = (_e1391 + ((_e782 + countOneBits(_e784)) + _e777));
        keys_out.member[_e1392] = _e234;
        values_out.member[_e1392] = _e258;
    }
    if (((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 256u) + (_e51 % 32u))) < _e68) {
        let _e1409 = atomicLoad((&counts[(_e64 + ((_e270 >> bitcast<u32>((_e66 & 31u))) & 255u))]));
        let _e1410 = (_e1409 + (_e858 + _e849));
        keys_out.member[_e1410] = _e270;
        values_out.member[_e1410] = _e294;
    }
    if (((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 288u) + (_e51 % 32u))) < _e68) {
        let _e1427 = atomicLoad((&counts[(_e64 + ((_e282 >> bitcast<u32>((_e66 & 31u))) & 255u))]));
        let _e1428 = (_e1427 + ((_e861 + countOneBits(_e863)) + _e856));
        keys_out.member[_e1428] = _e282;
        values_out.member[_e1428] = _e306;
    }
    if (((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 320u) + (_e51 % 32u))) < _e68) {
        let _e1445 = atomicLoad((&counts[(_e64 + ((_e318 >> bitcast<u32>((_e66 & 31u))) & 255u))]));
        let _e1446 = (_e1445 + (_e937 + _e928));
        keys_out.member[_e1446] = _e318;
        values_out.member[_e1446] = _e342;
    }
    if (((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 352u) + (_e51 % 32u))) < _e68) {
        let _e1463 = atomicLoad((&counts[(_e64 + ((_e330 >> bitcast<u32>((_e66 & 31u))) & 255u))]));
        let _e1464 = (_e1463 + ((_e940 + countOneBits(_e942)) + _e935));
        keys_out.member[_e1464] = _e330;
        values_out.member[_e1464] = _e354;
    }
    if (((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 384u) + (_e51 % 32u))) < _e68) {
        let _e1481 = atomicLoad((&counts[(_e64 + ((_e366 >> bitcast<u32>((_e66 & 31u))) & 255u))]));
        let _e1482 = (_e1481 + (_e1016 + _e1007));
        keys_out.member[_e1482] = _e366;
        values_out.member[_e1482] = _e390;
    }
    if (((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 416u) + (_e51 % 32u))) < _e68) {
        let _e1499 = atomicLoad((&counts[(_e64 + ((_e378 >> bitcast<u32>((_e66 & 31u))) & 255u))]));
        let _e1500 = (_e1499 + ((_e1019 + countOneBits(_e1021)) + _e1014));
        keys_out.member[_e1500] = _e378;
        values_out.member[_e1500] = _e402;
    }
    if (((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 448u) + (_e51 % 32u))) < _e68) {
        let _e1517 = atomicLoad((&counts[(_e64 + ((_e414 >> bitcast<u32>((_e66 & 31u))) & 255u))]));
        let _e1518 = (_e1517 + (_e1095 + _e1086));
        keys_out.member[_e1518] = _e414;
        values_out.member[_e1518] = _e438;
    }
    if (((_e62 * 2048u) + ((((_e51 / 32u) * 512u) + 480u) + (_e51 % 32u))) < _e68) {
        let _e1535 = atomicLoad((&counts[(_e64 + ((_e426 >> bitcast<u32>((_e66 & 31u))) & 255u))]));
        let _e1536 = (_e1535 + ((_e1098 + countOneBits(_e1100)) + _e1093));
        keys_out.member[_e1536] = _e426;
        values_out.member[_e1536] = _e450;
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn sort_scatter(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    id_1 = id;
    n_1 = n;
    lane_1 = lane;
    function_();
}

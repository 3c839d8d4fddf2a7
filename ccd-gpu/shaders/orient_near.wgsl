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

struct type_15 {
    member: i32,
    member_1: i32,
}

struct type_16 {
    member: u32,
    member_1: i32,
}

struct type_17 {
    member: f32,
    member_1: f32,
}

struct type_19 {
    member: array<array<u32, 4>, 8>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_20 {
    member: type_7,
    member_1: type_8,
    member_2: type_19,
}

struct type_21 {
    member: type_20,
}

struct type_23 {
    member: array<vec4<u32>>,
}

struct type_25 {
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_27 {
    member: array<type_25>,
}

struct type_31 {
    member: vec4<f32>,
    member_1: vec4<f32>,
    member_2: vec4<f32>,
    member_3: vec4<f32>,
}

struct type_33 {
    member: array<type_31>,
}

struct type_34 {
    member: array<f32, 3>,
    member_1: array<array<f32, 3>, 3>,
    member_2: array<f32, 3>,
}

struct type_36 {
    member: array<f32, 2>,
    member_1: array<f32, 3>,
    member_2: array<array<f32, 3>, 3>,
}

struct type_37 {
    member: array<f32, 3>,
    member_1: array<array<f32, 3>, 3>,
}

struct type_42 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_21;
@group(0) @binding(1) 
var<storage> branches: type_23;
@group(0) @binding(2) 
var<storage> block_nodes: type_27;
var<workgroup> counters: array<atomic<u32>, 2>;
@group(0) @binding(3) 
var<storage, read_write> oriented: type_33;
@group(0) @binding(4) 
var<storage, read_write> stamps: type_11;
@group(0) @binding(5) 
var<storage, read_write> far: type_42;
var<workgroup> done: array<atomic<u32>, 8>;
var<workgroup> boxes: array<type_34, 256>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_198_: type_8;
    var phi_199_: u32;
    var phi_202_: type_9;
    var phi_205_: u32;
    var phi_253_: u32;
    var phi_268_: u32;
    var phi_270_: u32;
    var phi_441_: type_34;
    var phi_608_: type_34;
    var phi_746_: f32;
    var phi_747_: bool;
    var phi_1144_: type_15;
    var phi_1147_: f32;
    var phi_1145_: type_15;
    var phi_1188_: type_16;
    var phi_1148_: f32;
    var local: f32;
    var phi_1201_: f32;
    var phi_1213_: type_17;
    var phi_1252_: type_9;
    var phi_1255_: type_36;
    var phi_1338_: type_15;
    var phi_1341_: f32;
    var phi_1339_: type_15;
    var phi_1382_: type_16;
    var phi_1342_: f32;
    var local_1: f32;
    var phi_1395_: f32;
    var phi_1436_: type_15;
    var phi_1439_: f32;
    var phi_1437_: type_15;
    var phi_1480_: type_16;
    var phi_1440_: f32;
    var local_2: f32;
    var phi_1493_: f32;
    var phi_1505_: type_17;
    var phi_1601_: type_15;
    var phi_1604_: f32;
    var phi_1602_: type_15;
    var phi_1645_: type_16;
    var phi_1605_: f32;
    var local_3: f32;
    var phi_1658_: f32;
    var phi_1670_: type_17;
    var phi_1737_: type_36;
    var phi_1738_: bool;
    var phi_1739_: type_36;
    var phi_1740_: bool;
    var phi_2029_: type_15;
    var phi_2032_: f32;
    var phi_2030_: type_15;
    var phi_2073_: type_16;
    var phi_2033_: f32;
    var local_4: f32;
    var phi_2086_: f32;
    var phi_2127_: type_15;
    var phi_2130_: f32;
    var phi_2128_: type_15;
    var phi_2171_: type_16;
    var phi_2131_: f32;
    var local_5: f32;
    var phi_2184_: f32;
    var phi_2196_: type_17;
    var phi_2258_: type_36;
    var phi_1772_: type_15;
    var phi_1775_: f32;
    var phi_1773_: type_15;
    var phi_1816_: type_16;
    var phi_1776_: f32;
    var local_6: f32;
    var phi_1829_: f32;
    var phi_1870_: type_15;
    var phi_1873_: f32;
    var phi_1871_: type_15;
    var phi_1914_: type_16;
    var phi_1874_: f32;
    var local_7: f32;
    var phi_1927_: f32;
    var phi_1939_: type_17;
    var phi_2259_: type_36;
    var phi_2260_: type_36;
    var phi_1256_: type_36;
    var phi_2269_: type_36;
    var phi_2270_: bool;
    var phi_2271_: bool;
    var local_8: bool;
    var phi_2275_: type_36;
    var phi_2705_: array<array<f32, 3>, 3>;
    var phi_2707_: type_37;
    var phi_2708_: bool;
    var phi_2709_: type_37;
    var phi_2710_: bool;
    var phi_2723_: type_37;
    var phi_4235_: type_34;
    var phi_4236_: bool;
    var phi_4237_: type_34;
    var phi_4238_: bool;
    var phi_4262_: type_34;
    var phi_4298_: u32;
    var phi_206_: u32;
    var local_9: u32;
    var local_10: u32;
    var phi_4313_: u32;
    var local_11: u32;
    var local_12: u32;
    var local_13: type_36;
    var local_14: type_36;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e61 = id_2;
    let _e62 = n_2;
    let _e63 = lane_2;
    let _e75 = (((_e61.y * _e62.x) + _e61.x) * 256u);
    let _e76 = (_e75 + _e63);
    let _e79 = params.member.member_2.member_1;
    let _e83 = params.member.member.member[_e79];
    if (_e63 < 8u) {
        atomicStore((&done[_e63]), 0u);
    }
    if (_e63 < 2u) {
        atomicStore((&counters[_e63]), 0u);
    }
    if ((_e76 + 1u) < _e83) {
        let _e92 = branches.member[_e76];
        phi_198_ = type_8(_e92.x, _e92.y, _e92.z, _e92.w);
        phi_199_ = select(3u, 1u, select(false, (_e92.w < (_e75 + 256u)), (_e92.z >= _e75)));
    } else {
        phi_198_ = type_8(0u, 0u, _e75, _e75);
        phi_199_ = 0u;
    }
    let _e104 = phi_198_;
    let _e106 = phi_199_;
    workgroupBarrier();
    phi_202_ = type_9(0u, 38u);
    phi_205_ = _e106;
    loop {
        let _e108 = phi_202_;
        let _e110 = phi_205_;
        local_9 = _e110;
        local_10 = _e110;
        local_11 = _e110;
        local_12 = _e110;
        let _e113 = (_e108.member < _e108.member_1);
        let _e124 = (bitcast<i32>(select(0u, 1u, _e113)) != 0i);
        if _e124 {
            if (_e110 == 1u) {
                if ((_e104.member + 1u) >= _e83) {
                    phi_253_ = 1u;
                } else {
                    let _e129 = (_e104.member - _e75);
                    let _e132 = atomicLoad((&done[(_e129 / 32u)]));
                    phi_253_ = ((_e132 >> bitcast<u32>(((_e129 % 32u) & 31u))) & 1u);
                }
                let _e139 = phi_253_;
                if ((_e104.member_1 + 1u) >= _e83) {
                    phi_268_ = 1u;
                } else {
                    let _e143 = (_e104.member_1 - _e75);
                    let _e146 = atomicLoad((&done[(_e143 / 32u)]));
                    phi_268_ = ((_e146 >> bitcast<u32>(((_e143 % 32u) & 31u))) & 1u);
                }
                let _e153 = phi_268_;
                phi_270_ = (_e139 & _e153);
            } else {
                phi_270_ = 0u;
            }
            let _e156 = phi_270_;
            workgroupBarrier();
            if (_e156 == 0u) {
                phi_4298_ = _e110;
            } else {
                let _e162 = params.member.member_2.member_1;
                let _e166 = params.member.member.member[_e162];
                if ((_e104.member + 1u) >= _e166) {
                    let _e201 = params.member.member_2.member_1;
                    let _e205 = params.member.member.member[_e201];
                    let _e212 = params.member.member_2.member[0u][_e201];
                    let _e215 = block_nodes.member[(_e212 + (_e104.member - (_e205 - 1u)))];
                    let _e234 = ((_e215.member.x * 0.5f) + (_e215.member_1.y * 0.5f));
                    let _e235 = ((_e215.member.y * 0.5f) + (_e215.member_2.x * 0.5f));
                    let _e236 = ((_e215.member_1.x * 0.5f) + (_e215.member_2.y * 0.5f));
                    let _e238 = select(_e215.member_1.y, _e234, (_e234 < _e215.member_1.y));
                    let _e240 = select(_e215.member_2.x, _e235, (_e235 < _e215.member_2.x));
                    let _e242 = select(_e215.member_2.y, _e236, (_e236 < _e215.member_2.y));
                    let _e244 = select(_e215.member.x, _e238, (_e238 > _e215.member.x));
                    let _e246 = select(_e215.member.y, _e240, (_e240 > _e215.member.y));
                    let _e248 = select(_e215.member_1.x, _e242, (_e242 > _e215.member_1.x));
                    let _e250 = (_e215.member_1.y - _e244);
                    let _e251 = (_e215.member_2.x - _e246);
                    let _e252 = (_e215.member_2.y - _e248);
                    let _e253 = (_e244 - _e215.member.x);
                    let _e254 = (_e246 - _e215.member.y);
                    let _e255 = (_e248 - _e215.member_1.x);
                    let _e263 = (1f + (0.000000059604645f * 4f));
                    let _e267 = (0.000000000000000000000000000000000000011754944f * 8f);
                    phi_441_ = type_34(array<f32, 3>(_e244, _e246, _e248), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((select(_e253, _e250, (_e250 > _e253)) * _e263) + _e267), ((select(_e254, _e251, (_e251 > _e254)) * _e263) + _e267), ((select(_e255, _e252, (_e252 > _e255)) * _e263) + _e267)));
                } else {
                    let _e170 = boxes[(_e104.member - _e75)];
                    phi_441_ = type_34(array<f32, 3>(_e170.member[0], _e170.member[1], _e170.member[2]), array<array<f32, 3>, 3>(array<f32, 3>(_e170.member_1[0][0], _e170.member_1[0][1], _e170.member_1[0][2]), array<f32, 3>(_e170.member_1[1][0], _e170.member_1[1][1], _e170.member_1[1][2]), array<f32, 3>(_e170.member_1[2][0], _e170.member_1[2][1], _e170.member_1[2][2])), array<f32, 3>(_e170.member_2[0], _e170.member_2[1], _e170.member_2[2]));
                }
                let _e274 = phi_441_;
                let _e279 = params.member.member_2.member_1;
                let _e283 = params.member.member.member[_e279];
                if ((_e104.member_1 + 1u) >= _e283) {
                    let _e318 = params.member.member_2.member_1;
                    let _e322 = params.member.member.member[_e318];
                    let _e329 = params.member.member_2.member[0u][_e318];
                    let _e332 = block_nodes.member[(_e329 + (_e104.member_1 - (_e322 - 1u)))];
                    let _e351 = ((_e332.member.x * 0.5f) + (_e332.member_1.y * 0.5f));
                    let _e352 = ((_e332.member.y * 0.5f) + (_e332.member_2.x * 0.5f));
                    let _e353 = ((_e332.member_1.x * 0.5f) + (_e332.member_2.y * 0.5f));
                    let _e355 = select(_e332.member_1.y, _e351, (_e351 < _e332.member_1.y));
                    let _e357 = select(_e332.member_2.x, _e352, (_e352 < _e332.member_2.x));
                    let _e359 = select(_e332.member_2.y, _e353, (_e353 < _e332.member_2.y));
                    let _e361 = select(_e332.member.x, _e355, (_e355 > _e332.member.x));
                    let _e363 = select(_e332.member.y, _e357, (_e357 > _e332.member.y));
                    let _e365 = select(_e332.member_1.x, _e359, (_e359 > _e332.member_1.x));
                    let _e367 = (_e332.member_1.y - _e361);
                    let _e368 = (_e332.member_2.x - _e363);
                    let _e369 = (_e332.member_2.y - _e365);
                    let _e370 = (_e361 - _e332.member.x);
                    let _e371 = (_e363 - _e332.member.y);
                    let _e372 = (_e365 - _e332.member_1.x);
                    let _e380 = (1f + (0.000000059604645f * 4f));
                    let _e384 = (0.000000000000000000000000000000000000011754944f * 8f);
                    phi_608_ = type_34(array<f32, 3>(_e361, _e363, _e365), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((select(_e370, _e367, (_e367 > _e370)) * _e380) + _e384), ((select(_e371, _e368, (_e368 > _e371)) * _e380) + _e384), ((select(_e372, _e369, (_e369 > _e372)) * _e380) + _e384)));
                } else {
                    let _e287 = boxes[(_e104.member_1 - _e75)];
                    phi_608_ = type_34(array<f32, 3>(_e287.member[0], _e287.member[1], _e287.member[2]), array<array<f32, 3>, 3>(array<f32, 3>(_e287.member_1[0][0], _e287.member_1[0][1], _e287.member_1[0][2]), array<f32, 3>(_e287.member_1[1][0], _e287.member_1[1][1], _e287.member_1[1][2]), array<f32, 3>(_e287.member_1[2][0], _e287.member_1[2][1], _e287.member_1[2][2])), array<f32, 3>(_e287.member_2[0], _e287.member_2[1], _e287.member_2[2]));
                }
                let _e391 = phi_608_;
                let _e396 = (_e391.member[0] - _e274.member[0]);
                let _e399 = (_e391.member[1] - _e274.member[1]);
                let _e402 = (_e391.member[2] - _e274.member[2]);
                let _e405 = select(_e396, -(_e396), (_e396 < 0f));
                let _e408 = select(_e399, -(_e399), (_e399 < 0f));
                let _e410 = select(_e408, _e405, (_e405 > _e408));
                let _e413 = select(_e402, -(_e402), (_e402 < 0f));
                let _e415 = select(_e413, _e410, (_e410 > _e413));
                let _e420 = select(_e274.member_2[0], -(_e274.member_2[0]), (_e274.member_2[0] < 0f));
                let _e424 = select(_e274.member_2[1], -(_e274.member_2[1]), (_e274.member_2[1] < 0f));
                let _e426 = select(_e424, _e420, (_e420 > _e424));
                let _e430 = select(_e274.member_2[2], -(_e274.member_2[2]), (_e274.member_2[2] < 0f));
                let _e432 = select(_e430, _e426, (_e426 > _e430));
                let _e434 = select(_e432, _e415, (_e415 > _e432));
                let _e439 = select(_e391.member_2[0], -(_e391.member_2[0]), (_e391.member_2[0] < 0f));
                let _e443 = select(_e391.member_2[1], -(_e391.member_2[1]), (_e391.member_2[1] < 0f));
                let _e445 = select(_e443, _e439, (_e439 > _e443));
                let _e449 = select(_e391.member_2[2], -(_e391.member_2[2]), (_e391.member_2[2] < 0f));
                let _e451 = select(_e449, _e445, (_e445 > _e449));
                let _e453 = select(_e451, _e434, (_e434 > _e451));
                if (_e453 > 0.000000000000000000000000000000000000011754944f) {
                    let _e457 = ((bitcast<u32>(_e453) & 2139095040u) != 2139095040u);
                    let _e460 = (2130706432u - (bitcast<u32>(_e453) & 2139095040u));
                    phi_746_ = select(f32(), bitcast<f32>(select(8388608u, _e460, (_e460 > 8388608u))), _e457);
                    phi_747_ = select(true, false, _e457);
                } else {
                    phi_746_ = f32();
                    phi_747_ = true;
                }
                let _e467 = phi_746_;
                let _e469 = phi_747_;
                let _e470 = select(_e467, 0f, _e469);
                let _e471 = (_e396 * _e470);
                let _e472 = (_e399 * _e470);
                let _e473 = (_e402 * _e470);
                let _e474 = (_e471 * 0.5f);
                let _e475 = (_e472 * 0.5f);
                let _e493 = (_e274.member_2[0] * _e470);
                let _e495 = (_e274.member_1[0][0] * _e493);
                let _e497 = (_e274.member_1[0][1] * _e493);
                let _e499 = (_e274.member_1[0][2] * _e493);
                let _e500 = (_e495 * 1f);
                let _e501 = (_e497 * 1f);
                let _e519 = (_e274.member_2[1] * _e470);
                let _e521 = (_e274.member_1[1][0] * _e519);
                let _e523 = (_e274.member_1[1][1] * _e519);
                let _e525 = (_e274.member_1[1][2] * _e519);
                let _e526 = (_e521 * 1f);
                let _e527 = (_e523 * 1f);
                let _e545 = (_e274.member_2[2] * _e470);
                let _e547 = (_e274.member_1[2][0] * _e545);
                let _e549 = (_e274.member_1[2][1] * _e545);
                let _e551 = (_e274.member_1[2][2] * _e545);
                let _e552 = (_e547 * 1f);
                let _e553 = (_e549 * 1f);
                let _e571 = (_e391.member_2[0] * _e470);
                let _e573 = (_e391.member_1[0][0] * _e571);
                let _e575 = (_e391.member_1[0][1] * _e571);
                let _e577 = (_e391.member_1[0][2] * _e571);
                let _e578 = (_e573 * 1f);
                let _e579 = (_e575 * 1f);
                let _e597 = (_e391.member_2[1] * _e470);
                let _e599 = (_e391.member_1[1][0] * _e597);
                let _e601 = (_e391.member_1[1][1] * _e597);
                let _e603 = (_e391.member_1[1][2] * _e597);
                let _e604 = (_e599 * 1f);
                let _e605 = (_e601 * 1f);
                let _e623 = (_e391.member_2[2] * _e470);
                let _e625 = (_e391.member_1[2][0] * _e623);
                let _e627 = (_e391.member_1[2][1] * _e623);
                let _e629 = (_e391.member_1[2][2] * _e623);
                let _e630 = (_e625 * 1f);
                let _e631 = (_e627 * 1f);
                let _e636 = (((((((0f + (_e471 * _e474)) + (_e495 * _e500)) + (_e521 * _e526)) + (_e547 * _e552)) + (_e573 * _e578)) + (_e599 * _e604)) + (_e625 * _e630));
                let _e637 = (((((((0f + (_e472 * _e474)) + (_e497 * _e500)) + (_e523 * _e526)) + (_e549 * _e552)) + (_e575 * _e578)) + (_e601 * _e604)) + (_e627 * _e630));
                let _e638 = (((((((0f + (_e473 * _e474)) + (_e499 * _e500)) + (_e525 * _e526)) + (_e551 * _e552)) + (_e577 * _e578)) + (_e603 * _e604)) + (_e629 * _e630));
                let _e640 = (((((((0f + (_e475 * _e472)) + (_e501 * _e497)) + (_e527 * _e523)) + (_e553 * _e549)) + (_e579 * _e575)) + (_e605 * _e601)) + (_e631 * _e627));
                let _e642 = (((((((0f + (_e475 * _e473)) + (_e501 * _e499)) + (_e527 * _e525)) + (_e553 * _e551)) + (_e579 * _e577)) + (_e605 * _e603)) + (_e631 * _e629));
                let _e644 = (((((((0f + ((_e473 * 0.5f) * _e473)) + ((_e499 * 1f) * _e499)) + ((_e525 * 1f) * _e525)) + ((_e551 * 1f) * _e551)) + ((_e577 * 1f) * _e577)) + ((_e603 * 1f) * _e603)) + ((_e629 * 1f) * _e629));
                let _e647 = select(_e636, -(_e636), (_e636 < 0f));
                let _e650 = select(_e637, -(_e637), (_e637 < 0f));
                let _e652 = select(_e650, _e647, (_e647 > _e650));
                let _e655 = select(_e638, -(_e638), (_e638 < 0f));
                let _e657 = select(_e655, _e652, (_e652 > _e655));
                let _e660 = select(_e640, -(_e640), (_e640 < 0f));
                let _e663 = select(_e642, -(_e642), (_e642 < 0f));
                let _e665 = select(_e663, _e660, (_e660 > _e663));
                let _e668 = select(_e644, -(_e644), (_e644 < 0f));
                let _e670 = select(_e668, _e665, (_e665 > _e668));
                let _e672 = select(_e670, _e657, (_e657 > _e670));
                if (_e672 > 0.000000000000000000000000000000000000011754944f) {
                    if ((bitcast<u32>(_e672) & 2139095040u) != 2139095040u) {
                        let _e679 = (2130706432u - (bitcast<u32>(_e672) & 2139095040u));
                        let _e682 = bitcast<f32>(select(8388608u, _e679, (_e679 > 8388608u)));
                        let _e684 = (_e637 * _e682);
                        let _e685 = (_e638 * _e682);
                        let _e686 = (_e640 * _e682);
                        let _e687 = (_e642 * _e682);
                        let _e688 = (_e644 * _e682);
                        let _e691 = ((_e684 * _e684) + (_e685 * _e685));
                        if (_e691 > ((0.000000059604645f * 0.000000059604645f) * (0.000000059604645f * 0.000000059604645f))) {
                            if (_e691 <= 0.000000000000000000000000000000000000011754944f) {
                                phi_1201_ = select(0f, (0.000000000000000000106433627f * 2f), (_e691 > 0f));
                            } else {
                                phi_1144_ = type_15(0i, 5i);
                                phi_1147_ = bitcast<f32>(((bitcast<u32>(_e691) >> bitcast<u32>(1i)) + 532369198u));
                                loop {
                                    let _e703 = phi_1144_;
                                    let _e705 = phi_1147_;
                                    local = _e705;
                                    if (_e703.member < _e703.member_1) {
                                        let _e712 = (_e703.member + 1i);
                                        phi_1145_ = type_15(select(_e712, type_16().member_1, select(false, true, ((false == (_e712 > _e703.member)) != false))), _e703.member_1);
                                        phi_1188_ = type_16(1u, _e703.member);
                                    } else {
                                        phi_1145_ = _e703;
                                        phi_1188_ = type_16(0u, type_16().member_1);
                                    }
                                    let _e723 = phi_1145_;
                                    let _e725 = phi_1188_;
                                    let _e728 = (bitcast<i32>(_e725.member) != 0i);
                                    if _e728 {
                                        phi_1148_ = (0.5f * (_e705 + (_e691 / _e705)));
                                    } else {
                                        phi_1148_ = f32();
                                    }
                                    let _e733 = phi_1148_;
                                    continue;
                                    continuing {
                                        phi_1144_ = _e723;
                                        phi_1147_ = _e733;
                                        break if !(_e728);
                                    }
                                }
                                let _e738 = local;
                                phi_1201_ = (_e738 * (1f + (8f * 0.000000059604645f)));
                            }
                            let _e744 = phi_1201_;
                            let _e745 = (_e684 / _e744);
                            let _e746 = (_e685 / _e744);
                            let _e751 = (1.5f - (((_e745 * _e745) + (_e746 * _e746)) * 0.5f));
                            phi_1213_ = type_17((_e745 * _e751), (_e746 * _e751));
                        } else {
                            phi_1213_ = type_17(1f, 0f);
                        }
                        let _e756 = phi_1213_;
                        let _e761 = (((_e756.member * _e756.member_1) * _e687) * 2f);
                        phi_1252_ = type_9(0u, 16u);
                        phi_1255_ = type_36(array<f32, 2>(((_e756.member * _e684) + (_e756.member_1 * _e685)), (((_e756.member * _e756.member_1) * (_e686 - _e688)) + (((_e756.member_1 * _e756.member_1) - (_e756.member * _e756.member)) * _e687))), array<f32, 3>((_e636 * _e682), ((((_e756.member * _e756.member) * _e686) + _e761) + ((_e756.member_1 * _e756.member_1) * _e688)), ((((_e756.member_1 * _e756.member_1) * _e686) - _e761) + ((_e756.member * _e756.member) * _e688))), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, _e756.member, _e756.member_1), array<f32, 3>(0f, _e756.member_1, -(_e756.member))));
                        loop {
                            let _e793 = phi_1252_;
                            let _e795 = phi_1255_;
                            local_14 = _e795;
                            let _e798 = (_e793.member < _e793.member_1);
                            if (bitcast<i32>(select(0u, 1u, _e798)) != 0i) {
                                let _e810 = (0.000000059604645f * 0.5f);
                                let _e821 = (select(_e795.member[0], -(_e795.member[0]), (_e795.member[0] < 0f)) > _e810);
                                let _e825 = (select(_e795.member[1], -(_e795.member[1]), (_e795.member[1] < 0f)) > _e810);
                                if _e821 {
                                    if _e825 {
                                        let _e828 = ((_e795.member_1[1] - _e795.member_1[0]) / (_e795.member[0] * 2f));
                                        let _e830 = ((_e828 * _e828) + 1f);
                                        if (_e830 <= 0.000000000000000000000000000000000000011754944f) {
                                            phi_1395_ = select(0f, (0.000000000000000000106433627f * 2f), (_e830 > 0f));
                                        } else {
                                            phi_1338_ = type_15(0i, 5i);
                                            phi_1341_ = bitcast<f32>(((bitcast<u32>(_e830) >> bitcast<u32>(1i)) + 532369198u));
                                            loop {
                                                let _e838 = phi_1338_;
                                                let _e840 = phi_1341_;
                                                local_1 = _e840;
                                                if (_e838.member < _e838.member_1) {
                                                    let _e847 = (_e838.member + 1i);
                                                    phi_1339_ = type_15(select(_e847, type_16().member_1, select(false, true, ((false == (_e847 > _e838.member)) != false))), _e838.member_1);
                                                    phi_1382_ = type_16(1u, _e838.member);
                                                } else {
                                                    phi_1339_ = _e838;
                                                    phi_1382_ = type_16(0u, type_16().member_1);
                                                }
                                                let _e858 = phi_1339_;
                                                let _e860 = phi_1382_;
                                                let _e863 = (bitcast<i32>(_e860.member) != 0i);
                                                if _e863 {
                                                    phi_1342_ = (0.5f * (_e840 + (_e830 / _e840)));
                                                } else {
                                                    phi_1342_ = f32();
                                                }
                                                let _e868 = phi_1342_;
                                                continue;
                                                continuing {
                                                    phi_1338_ = _e858;
                                                    phi_1341_ = _e868;
                                                    break if !(_e863);
                                                }
                                            }
                                            let _e873 = local_1;
                                            phi_1395_ = (_e873 * (1f + (8f * 0.000000059604645f)));
                                        }
                                        let _e879 = phi_1395_;
                                        let _e886 = (_e795.member_1[2] - (_e795.member_1[0] - (_e795.member[0] / select((_e828 - _e879), (_e828 + _e879), (_e828 > 0f)))));
                                        let _e889 = ((_e886 * _e886) + (_e795.member[1] * _e795.member[1]));
                                        if (_e889 > ((0.000000059604645f * 0.000000059604645f) * (0.000000059604645f * 0.000000059604645f))) {
                                            if (_e889 <= 0.000000000000000000000000000000000000011754944f) {
                                                phi_1493_ = select(0f, (0.000000000000000000106433627f * 2f), (_e889 > 0f));
                                            } else {
                                                phi_1436_ = type_15(0i, 5i);
                                                phi_1439_ = bitcast<f32>(((bitcast<u32>(_e889) >> bitcast<u32>(1i)) + 532369198u));
                                                loop {
                                                    let _e901 = phi_1436_;
                                                    let _e903 = phi_1439_;
                                                    local_2 = _e903;
                                                    if (_e901.member < _e901.member_1) {
                                                        let _e910 = (_e901.member + 1i);
                                                        phi_1437_ = type_15(select(_e910, type_16().member_1, select(false, true, ((false == (_e910 > _e901.member)) != false))), _e901.member_1);
                                                        phi_1480_ = type_16(1u, _e901.member);
                                                    } else {
                                                        phi_1437_ = _e901;
                                                        phi_1480_ = type_16(0u, type_16().member_1);
                                                    }
                                                    let _e921 = phi_1437_;
                                                    let _e923 = phi_1480_;
                                                    let _e926 = (bitcast<i32>(_e923.member) != 0i);
                                                    if _e926 {
                                                        phi_1440_ = (0.5f * (_e903 + (_e889 / _e903)));
                                                    } else {
                                                        phi_1440_ = f32();
                                                    }
                                                    let _e931 = phi_1440_;
                                                    continue;
                                                    continuing {
                                                        phi_1436_ = _e921;
                                                        phi_1439_ = _e931;
                                                        break if !(_e926);
                                                    }
                                                }
                                                let _e936 = local_2;
                                                phi_1493_ = (_e936 * (1f + (8f * 0.000000059604645f)));
                                            }
                                            let _e942 = phi_1493_;
                                            let _e943 = (_e886 / _e942);
                                            let _e944 = (_e795.member[1] / _e942);
                                            let _e949 = (1.5f - (((_e943 * _e943) + (_e944 * _e944)) * 0.5f));
                                            phi_1505_ = type_17((_e943 * _e949), (_e944 * _e949));
                                        } else {
                                            phi_1505_ = type_17(1f, 0f);
                                        }
                                        let _e954 = phi_1505_;
                                        let _e971 = (((_e795.member_1[1] - _e795.member_1[2]) * _e954.member_1) + ((_e954.member * _e795.member[1]) * 2f));
                                        let _e973 = (_e795.member_1[1] - (_e954.member_1 * _e971));
                                        let _e977 = ((_e954.member * _e971) - _e795.member[1]);
                                        let _e990 = ((_e795.member_2[1][0] * _e954.member) - (_e795.member_2[2][0] * _e954.member_1));
                                        let _e991 = ((_e795.member_2[1][1] * _e954.member) - (_e795.member_2[2][1] * _e954.member_1));
                                        let _e992 = ((_e795.member_2[1][2] * _e954.member) - (_e795.member_2[2][2] * _e954.member_1));
                                        let _e1009 = (_e954.member * _e795.member[0]);
                                        let _e1010 = (_e954.member_1 * _e795.member[0]);
                                        let _e1013 = ((_e977 * _e977) + (_e1010 * _e1010));
                                        if (_e1013 > ((0.000000059604645f * 0.000000059604645f) * (0.000000059604645f * 0.000000059604645f))) {
                                            if (_e1013 <= 0.000000000000000000000000000000000000011754944f) {
                                                phi_1658_ = select(0f, (0.000000000000000000106433627f * 2f), (_e1013 > 0f));
                                            } else {
                                                phi_1601_ = type_15(0i, 5i);
                                                phi_1604_ = bitcast<f32>(((bitcast<u32>(_e1013) >> bitcast<u32>(1i)) + 532369198u));
                                                loop {
                                                    let _e1025 = phi_1601_;
                                                    let _e1027 = phi_1604_;
                                                    local_3 = _e1027;
                                                    if (_e1025.member < _e1025.member_1) {
                                                        let _e1034 = (_e1025.member + 1i);
                                                        phi_1602_ = type_15(select(_e1034, type_16().member_1, select(false, true, ((false == (_e1034 > _e1025.member)) != false))), _e1025.member_1);
                                                        phi_1645_ = type_16(1u, _e1025.member);
                                                    } else {
                                                        phi_1602_ = _e1025;
                                                        phi_1645_ = type_16(0u, type_16().member_1);
                                                    }
                                                    let _e1045 = phi_1602_;
                                                    let _e1047 = phi_1645_;
                                                    let _e1050 = (bitcast<i32>(_e1047.member) != 0i);
                                                    if _e1050 {
                                                        phi_1605_ = (0.5f * (_e1027 + (_e1013 / _e1027)));
                                                    } else {
                                                        phi_1605_ = f32();
                                                    }
                                                    let _e1055 = phi_1605_;
                                                    continue;
                                                    continuing {
                                                        phi_1601_ = _e1045;
                                                        phi_1604_ = _e1055;
                                                        break if !(_e1050);
                                                    }
                                                }
                                                let _e1060 = local_3;
                                                phi_1658_ = (_e1060 * (1f + (8f * 0.000000059604645f)));
                                            }
                                            let _e1066 = phi_1658_;
                                            let _e1067 = (_e977 / _e1066);
                                            let _e1068 = (_e1010 / _e1066);
                                            let _e1073 = (1.5f - (((_e1067 * _e1067) + (_e1068 * _e1068)) * 0.5f));
                                            phi_1670_ = type_17((_e1067 * _e1073), (_e1068 * _e1073));
                                        } else {
                                            phi_1670_ = type_17(1f, 0f);
                                        }
                                        let _e1078 = phi_1670_;
                                        let _e1088 = (((_e795.member_1[0] - _e973) * _e1078.member_1) + ((_e1078.member * _e1009) * 2f));
                                        phi_1737_ = type_36(array<f32, 2>(((_e1078.member * _e1088) - _e1009), ((_e1078.member_1 * _e1010) + (_e1078.member * _e977))), array<f32, 3>((_e795.member_1[0] - (_e1078.member_1 * _e1088)), (_e973 + (_e1078.member_1 * _e1088)), (_e795.member_1[2] + (_e954.member_1 * _e971))), array<array<f32, 3>, 3>(array<f32, 3>(((_e795.member_2[0][0] * _e1078.member) - (_e990 * _e1078.member_1)), ((_e795.member_2[0][1] * _e1078.member) - (_e991 * _e1078.member_1)), ((_e795.member_2[0][2] * _e1078.member) - (_e992 * _e1078.member_1))), array<f32, 3>(((_e795.member_2[0][0] * _e1078.member_1) + (_e990 * _e1078.member)), ((_e795.member_2[0][1] * _e1078.member_1) + (_e991 * _e1078.member)), ((_e795.member_2[0][2] * _e1078.member_1) + (_e992 * _e1078.member))), array<f32, 3>(((_e795.member_2[1][0] * _e954.member_1) + (_e795.member_2[2][0] * _e954.member)), ((_e795.member_2[1][1] * _e954.member_1) + (_e795.member_2[2][1] * _e954.member)), ((_e795.member_2[1][2] * _e954.member_1) + (_e795.member_2[2][2] * _e954.member)))));
                                        phi_1738_ = false;
                                    } else {
                                        phi_1737_ = type_36();
                                        phi_1738_ = true;
                                    }
                                    let _e1126 = phi_1737_;
                                    let _e1128 = phi_1738_;
                                    phi_1739_ = _e1126;
                                    phi_1740_ = _e1128;
                                } else {
                                    phi_1739_ = type_36();
                                    phi_1740_ = true;
                                }
                                let _e1130 = phi_1739_;
                                let _e1132 = phi_1740_;
                                if _e1132 {
                                    if _e821 {
                                        let _e1335 = ((_e795.member_1[1] - _e795.member_1[0]) / (_e795.member[0] * 2f));
                                        let _e1337 = ((_e1335 * _e1335) + 1f);
                                        if (_e1337 <= 0.000000000000000000000000000000000000011754944f) {
                                            phi_1829_ = select(0f, (0.000000000000000000106433627f * 2f), (_e1337 > 0f));
                                        } else {
                                            phi_1772_ = type_15(0i, 5i);
                                            phi_1775_ = bitcast<f32>(((bitcast<u32>(_e1337) >> bitcast<u32>(1i)) + 532369198u));
                                            loop {
                                                let _e1345 = phi_1772_;
                                                let _e1347 = phi_1775_;
                                                local_6 = _e1347;
                                                if (_e1345.member < _e1345.member_1) {
                                                    let _e1354 = (_e1345.member + 1i);
                                                    phi_1773_ = type_15(select(_e1354, type_16().member_1, select(false, true, ((false == (_e1354 > _e1345.member)) != false))), _e1345.member_1);
                                                    phi_1816_ = type_16(1u, _e1345.member);
                                                } else {
                                                    phi_1773_ = _e1345;
                                                    phi_1816_ = type_16(0u, type_16().member_1);
                                                }
                                                let _e1365 = phi_1773_;
                                                let _e1367 = phi_1816_;
                                                let _e1370 = (bitcast<i32>(_e1367.member) != 0i);
                                                if _e1370 {
                                                    phi_1776_ = (0.5f * (_e1347 + (_e1337 / _e1347)));
                                                } else {
                                                    phi_1776_ = f32();
                                                }
                                                let _e1375 = phi_1776_;
                                                continue;
                                                continuing {
                                                    phi_1772_ = _e1365;
                                                    phi_1775_ = _e1375;
                                                    break if !(_e1370);
                                                }
                                            }
                                            let _e1380 = local_6;
                                            phi_1829_ = (_e1380 * (1f + (8f * 0.000000059604645f)));
                                        }
                                        let _e1386 = phi_1829_;
                                        let _e1393 = (_e795.member_1[1] - (_e795.member_1[0] - (_e795.member[0] / select((_e1335 - _e1386), (_e1335 + _e1386), (_e1335 > 0f)))));
                                        let _e1396 = ((_e1393 * _e1393) + (_e795.member[0] * _e795.member[0]));
                                        if (_e1396 > ((0.000000059604645f * 0.000000059604645f) * (0.000000059604645f * 0.000000059604645f))) {
                                            if (_e1396 <= 0.000000000000000000000000000000000000011754944f) {
                                                phi_1927_ = select(0f, (0.000000000000000000106433627f * 2f), (_e1396 > 0f));
                                            } else {
                                                phi_1870_ = type_15(0i, 5i);
                                                phi_1873_ = bitcast<f32>(((bitcast<u32>(_e1396) >> bitcast<u32>(1i)) + 532369198u));
                                                loop {
                                                    let _e1408 = phi_1870_;
                                                    let _e1410 = phi_1873_;
                                                    local_7 = _e1410;
                                                    if (_e1408.member < _e1408.member_1) {
                                                        let _e1417 = (_e1408.member + 1i);
                                                        phi_1871_ = type_15(select(_e1417, type_16().member_1, select(false, true, ((false == (_e1417 > _e1408.member)) != false))), _e1408.member_1);
                                                        phi_1914_ = type_16(1u, _e1408.member);
                                                    } else {
                                                        phi_1871_ = _e1408;
                                                        phi_1914_ = type_16(0u, type_16().member_1);
                                                    }
                                                    let _e1428 = phi_1871_;
                                                    let _e1430 = phi_1914_;
                                                    let _e1433 = (bitcast<i32>(_e1430.member) != 0i);
                                                    if _e1433 {
                                                        phi_1874_ = (0.5f * (_e1410 + (_e1396 / _e1410)));
                                                    } else {
                                                        phi_1874_ = f32();
                                                    }
                                                    let _e1438 = phi_1874_;
                                                    continue;
                                                    continuing {
                                                        phi_1870_ = _e1428;
                                                        phi_1873_ = _e1438;
                                                        break if !(_e1433);
                                                    }
                                                }
                                                let _e1443 = local_7;
                                                phi_1927_ = (_e1443 * (1f + (8f * 0.000000059604645f)));
                                            }
                                            let _e1449 = phi_1927_;
                                            let _e1450 = (_e1393 / _e1449);
                                            let _e1451 = (_e795.member[0] / _e1449);
                                            let _e1456 = (1.5f - (((_e1450 * _e1450) + (_e1451 * _e1451)) * 0.5f));
                                            phi_1939_ = type_17((_e1450 * _e1456), (_e1451 * _e1456));
                                        } else {
                                            phi_1939_ = type_17(1f, 0f);
                                        }
                                        let _e1461 = phi_1939_;
                                        let _e1478 = (((_e795.member_1[0] - _e795.member_1[1]) * _e1461.member_1) + ((_e1461.member * _e795.member[0]) * 2f));
                                        let _e1488 = type_36(_e795.member, array<f32, 3>((_e795.member_1[0] - (_e1461.member_1 * _e1478)), (_e795.member_1[1] + (_e1461.member_1 * _e1478)), _e795.member_1[2]), _e795.member_2);
                                        let _e1494 = type_36(array<f32, 2>(((_e1461.member * _e1478) - _e795.member[0]), _e1488.member[1]), _e1488.member_1, _e1488.member_2);
                                        phi_2259_ = type_36(_e1494.member, _e1494.member_1, array<array<f32, 3>, 3>(array<f32, 3>(((_e795.member_2[0][0] * _e1461.member) - (_e795.member_2[1][0] * _e1461.member_1)), ((_e795.member_2[0][1] * _e1461.member) - (_e795.member_2[1][1] * _e1461.member_1)), ((_e795.member_2[0][2] * _e1461.member) - (_e795.member_2[1][2] * _e1461.member_1))), array<f32, 3>(((_e795.member_2[0][0] * _e1461.member_1) + (_e795.member_2[1][0] * _e1461.member)), ((_e795.member_2[0][1] * _e1461.member_1) + (_e795.member_2[1][1] * _e1461.member)), ((_e795.member_2[0][2] * _e1461.member_1) + (_e795.member_2[1][2] * _e1461.member))), _e795.member_2[2]));
                                    } else {
                                        if _e825 {
                                            let _e1135 = ((_e795.member_1[2] - _e795.member_1[1]) / (_e795.member[1] * 2f));
                                            let _e1137 = ((_e1135 * _e1135) + 1f);
                                            if (_e1137 <= 0.000000000000000000000000000000000000011754944f) {
                                                phi_2086_ = select(0f, (0.000000000000000000106433627f * 2f), (_e1137 > 0f));
                                            } else {
                                                phi_2029_ = type_15(0i, 5i);
                                                phi_2032_ = bitcast<f32>(((bitcast<u32>(_e1137) >> bitcast<u32>(1i)) + 532369198u));
                                                loop {
                                                    let _e1145 = phi_2029_;
                                                    let _e1147 = phi_2032_;
                                                    local_4 = _e1147;
                                                    if (_e1145.member < _e1145.member_1) {
                                                        let _e1154 = (_e1145.member + 1i);
                                                        phi_2030_ = type_15(select(_e1154, type_16().member_1, select(false, true, ((false == (_e1154 > _e1145.member)) != false))), _e1145.member_1);
                                                        phi_2073_ = type_16(1u, _e1145.member);
                                                    } else {
                                                        phi_2030_ = _e1145;
                                                        phi_2073_ = type_16(0u, type_16().member_1);
                                                    }
                                                    let _e1165 = phi_2030_;
                                                    let _e1167 = phi_2073_;
                                                    let _e1170 = (bitcast<i32>(_e1167.member) != 0i);
                                                    if _e1170 {
                                                        phi_2033_ = (0.5f * (_e1147 + (_e1137 / _e1147)));
                                                    } else {
                                                        phi_2033_ = f32();
                                                    }
                                                    let _e1175 = phi_2033_;
                                                    continue;
                                                    continuing {
                                                        phi_2029_ = _e1165;
                                                        phi_2032_ = _e1175;
                                                        break if !(_e1170);
                                                    }
                                                }
                                                let _e1180 = local_4;
                                                phi_2086_ = (_e1180 * (1f + (8f * 0.000000059604645f)));
                                            }
                                            let _e1186 = phi_2086_;
                                            let _e1193 = (_e795.member_1[2] - (_e795.member_1[1] - (_e795.member[1] / select((_e1135 - _e1186), (_e1135 + _e1186), (_e1135 > 0f)))));
                                            let _e1196 = ((_e1193 * _e1193) + (_e795.member[1] * _e795.member[1]));
                                            if (_e1196 > ((0.000000059604645f * 0.000000059604645f) * (0.000000059604645f * 0.000000059604645f))) {
                                                if (_e1196 <= 0.000000000000000000000000000000000000011754944f) {
                                                    phi_2184_ = select(0f, (0.000000000000000000106433627f * 2f), (_e1196 > 0f));
                                                } else {
                                                    phi_2127_ = type_15(0i, 5i);
                                                    phi_2130_ = bitcast<f32>(((bitcast<u32>(_e1196) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e1208 = phi_2127_;
                                                        let _e1210 = phi_2130_;
                                                        local_5 = _e1210;
                                                        if (_e1208.member < _e1208.member_1) {
                                                            let _e1217 = (_e1208.member + 1i);
                                                            phi_2128_ = type_15(select(_e1217, type_16().member_1, select(false, true, ((false == (_e1217 > _e1208.member)) != false))), _e1208.member_1);
                                                            phi_2171_ = type_16(1u, _e1208.member);
                                                        } else {
                                                            phi_2128_ = _e1208;
                                                            phi_2171_ = type_16(0u, type_16().member_1);
                                                        }
                                                        let _e1228 = phi_2128_;
                                                        let _e1230 = phi_2171_;
                                                        let _e1233 = (bitcast<i32>(_e1230.member) != 0i);
                                                        if _e1233 {
                                                            phi_2131_ = (0.5f * (_e1210 + (_e1196 / _e1210)));
                                                        } else {
                                                            phi_2131_ = f32();
                                                        }
                                                        let _e1238 = phi_2131_;
                                                        continue;
                                                        continuing {
                                                            phi_2127_ = _e1228;
                                                            phi_2130_ = _e1238;
                                                            break if !(_e1233);
                                                        }
                                                    }
                                                    let _e1243 = local_5;
                                                    phi_2184_ = (_e1243 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e1249 = phi_2184_;
                                                let _e1250 = (_e1193 / _e1249);
                                                let _e1251 = (_e795.member[1] / _e1249);
                                                let _e1256 = (1.5f - (((_e1250 * _e1250) + (_e1251 * _e1251)) * 0.5f));
                                                phi_2196_ = type_17((_e1250 * _e1256), (_e1251 * _e1256));
                                            } else {
                                                phi_2196_ = type_17(1f, 0f);
                                            }
                                            let _e1261 = phi_2196_;
                                            let _e1278 = (((_e795.member_1[1] - _e795.member_1[2]) * _e1261.member_1) + ((_e1261.member * _e795.member[1]) * 2f));
                                            let _e1288 = type_36(_e795.member, array<f32, 3>(_e795.member_1[0], (_e795.member_1[1] - (_e1261.member_1 * _e1278)), (_e795.member_1[2] + (_e1261.member_1 * _e1278))), _e795.member_2);
                                            let _e1294 = type_36(array<f32, 2>(_e1288.member[0], ((_e1261.member * _e1278) - _e795.member[1])), _e1288.member_1, _e1288.member_2);
                                            phi_2258_ = type_36(_e1294.member, _e1294.member_1, array<array<f32, 3>, 3>(_e795.member_2[0], array<f32, 3>(((_e795.member_2[1][0] * _e1261.member) - (_e795.member_2[2][0] * _e1261.member_1)), ((_e795.member_2[1][1] * _e1261.member) - (_e795.member_2[2][1] * _e1261.member_1)), ((_e795.member_2[1][2] * _e1261.member) - (_e795.member_2[2][2] * _e1261.member_1))), array<f32, 3>(((_e795.member_2[1][0] * _e1261.member_1) + (_e795.member_2[2][0] * _e1261.member)), ((_e795.member_2[1][1] * _e1261.member_1) + (_e795.member_2[2][1] * _e1261.member)), ((_e795.member_2[1][2] * _e1261.member_1) + (_e795.member_2[2][2] * _e1261.member)))));
                                        } else {
                                            phi_2258_ = _e795;
                                        }
                                        let _e1332 = phi_2258_;
                                        phi_2259_ = _e1332;
                                    }
                                    let _e1532 = phi_2259_;
                                    phi_2260_ = _e1532;
                                } else {
                                    phi_2260_ = _e1130;
                                }
                                let _e1534 = phi_2260_;
                                let _e1535 = select(_e825, true, _e821);
                                phi_1256_ = _e1534;
                                phi_2269_ = _e1534;
                                phi_2270_ = _e1535;
                                phi_2271_ = select(true, false, _e1535);
                            } else {
                                phi_1256_ = type_36();
                                phi_2269_ = type_36();
                                phi_2270_ = false;
                                phi_2271_ = false;
                            }
                            let _e1538 = phi_1256_;
                            let _e1540 = phi_2269_;
                            let _e1542 = phi_2270_;
                            let _e1544 = phi_2271_;
                            local_8 = _e1544;
                            local_13 = _e1540;
                            continue;
                            continuing {
                                phi_1252_ = type_9(select(_e793.member, (_e793.member + 1u), _e798), select(_e793.member_1, _e793.member_1, _e798));
                                phi_1255_ = _e1538;
                                break if !(_e1542);
                            }
                        }
                        let _e1547 = local_8;
                        if _e1547 {
                            let _e3322 = local_13;
                            phi_2275_ = _e3322;
                        } else {
                            let _e3324 = local_14;
                            phi_2275_ = _e3324;
                        }
                        let _e1549 = phi_2275_;
                        let _e1553 = (2130706432u - (bitcast<u32>(_e682) & 2139095040u));
                        let _e1556 = bitcast<f32>(select(8388608u, _e1553, (_e1553 > 8388608u)));
                        let _e1578 = ((((_e1549.member_2[0][0] * _e1549.member_2[0][0]) + (_e1549.member_2[0][1] * _e1549.member_2[0][1])) + (_e1549.member_2[0][2] * _e1549.member_2[0][2])) - 1f);
                        let _e1592 = ((((_e1549.member_2[1][0] * _e1549.member_2[1][0]) + (_e1549.member_2[1][1] * _e1549.member_2[1][1])) + (_e1549.member_2[1][2] * _e1549.member_2[1][2])) - 1f);
                        let _e1606 = ((((_e1549.member_2[2][0] * _e1549.member_2[2][0]) + (_e1549.member_2[2][1] * _e1549.member_2[2][1])) + (_e1549.member_2[2][2] * _e1549.member_2[2][2])) - 1f);
                        let _e1619 = (((_e1549.member_2[0][0] * _e1549.member_2[1][0]) + (_e1549.member_2[0][1] * _e1549.member_2[1][1])) + (_e1549.member_2[0][2] * _e1549.member_2[1][2]));
                        let _e1632 = (((_e1549.member_2[0][0] * _e1549.member_2[2][0]) + (_e1549.member_2[0][1] * _e1549.member_2[2][1])) + (_e1549.member_2[0][2] * _e1549.member_2[2][2]));
                        let _e1645 = (((_e1549.member_2[1][0] * _e1549.member_2[2][0]) + (_e1549.member_2[1][1] * _e1549.member_2[2][1])) + (_e1549.member_2[1][2] * _e1549.member_2[2][2]));
                        let _e1678 = (_e1549.member_2[0][0] - ((((_e1549.member_2[0][0] * _e1578) + (_e1549.member_2[1][0] * _e1619)) + (_e1549.member_2[2][0] * _e1632)) * 0.5f));
                        let _e1680 = (_e1549.member_2[0][1] - ((((_e1549.member_2[0][1] * _e1578) + (_e1549.member_2[1][1] * _e1619)) + (_e1549.member_2[2][1] * _e1632)) * 0.5f));
                        let _e1682 = (_e1549.member_2[0][2] - ((((_e1549.member_2[0][2] * _e1578) + (_e1549.member_2[1][2] * _e1619)) + (_e1549.member_2[2][2] * _e1632)) * 0.5f));
                        let _e1688 = select(0f, _e1678, (select(_e1678, -(_e1678), (_e1678 < 0f)) > (0.000000059604645f * 0.000000059604645f)));
                        let _e1694 = select(0f, _e1680, (select(_e1680, -(_e1680), (_e1680 < 0f)) > (0.000000059604645f * 0.000000059604645f)));
                        let _e1700 = select(0f, _e1682, (select(_e1682, -(_e1682), (_e1682 < 0f)) > (0.000000059604645f * 0.000000059604645f)));
                        let _e1734 = (_e1549.member_2[1][0] - ((((_e1549.member_2[0][0] * _e1619) + (_e1549.member_2[1][0] * _e1592)) + (_e1549.member_2[2][0] * _e1645)) * 0.5f));
                        let _e1736 = (_e1549.member_2[1][1] - ((((_e1549.member_2[0][1] * _e1619) + (_e1549.member_2[1][1] * _e1592)) + (_e1549.member_2[2][1] * _e1645)) * 0.5f));
                        let _e1738 = (_e1549.member_2[1][2] - ((((_e1549.member_2[0][2] * _e1619) + (_e1549.member_2[1][2] * _e1592)) + (_e1549.member_2[2][2] * _e1645)) * 0.5f));
                        let _e1744 = select(0f, _e1734, (select(_e1734, -(_e1734), (_e1734 < 0f)) > (0.000000059604645f * 0.000000059604645f)));
                        let _e1750 = select(0f, _e1736, (select(_e1736, -(_e1736), (_e1736 < 0f)) > (0.000000059604645f * 0.000000059604645f)));
                        let _e1756 = select(0f, _e1738, (select(_e1738, -(_e1738), (_e1738 < 0f)) > (0.000000059604645f * 0.000000059604645f)));
                        let _e1790 = (_e1549.member_2[2][0] - ((((_e1549.member_2[0][0] * _e1632) + (_e1549.member_2[1][0] * _e1645)) + (_e1549.member_2[2][0] * _e1606)) * 0.5f));
                        let _e1792 = (_e1549.member_2[2][1] - ((((_e1549.member_2[0][1] * _e1632) + (_e1549.member_2[1][1] * _e1645)) + (_e1549.member_2[2][1] * _e1606)) * 0.5f));
                        let _e1794 = (_e1549.member_2[2][2] - ((((_e1549.member_2[0][2] * _e1632) + (_e1549.member_2[1][2] * _e1645)) + (_e1549.member_2[2][2] * _e1606)) * 0.5f));
                        let _e1800 = select(0f, _e1790, (select(_e1790, -(_e1790), (_e1790 < 0f)) > (0.000000059604645f * 0.000000059604645f)));
                        let _e1806 = select(0f, _e1792, (select(_e1792, -(_e1792), (_e1792 < 0f)) > (0.000000059604645f * 0.000000059604645f)));
                        let _e1812 = select(0f, _e1794, (select(_e1794, -(_e1794), (_e1794 < 0f)) > (0.000000059604645f * 0.000000059604645f)));
                        let _e1820 = ((((_e1688 * _e1688) + (_e1694 * _e1694)) + (_e1700 * _e1700)) - 1f);
                        let _e1826 = ((((_e1744 * _e1744) + (_e1750 * _e1750)) + (_e1756 * _e1756)) - 1f);
                        let _e1832 = ((((_e1800 * _e1800) + (_e1806 * _e1806)) + (_e1812 * _e1812)) - 1f);
                        let _e1837 = (((_e1688 * _e1744) + (_e1694 * _e1750)) + (_e1700 * _e1756));
                        let _e1842 = (((_e1688 * _e1800) + (_e1694 * _e1806)) + (_e1700 * _e1812));
                        let _e1847 = (((_e1744 * _e1800) + (_e1750 * _e1806)) + (_e1756 * _e1812));
                        let _e1850 = select(_e1820, -(_e1820), (_e1820 < 0f));
                        let _e1853 = select(_e1826, -(_e1826), (_e1826 < 0f));
                        let _e1855 = select(_e1853, _e1850, (_e1850 > _e1853));
                        let _e1858 = select(_e1832, -(_e1832), (_e1832 < 0f));
                        let _e1860 = select(_e1858, _e1855, (_e1855 > _e1858));
                        let _e1863 = select(_e1837, -(_e1837), (_e1837 < 0f));
                        let _e1866 = select(_e1842, -(_e1842), (_e1842 < 0f));
                        let _e1868 = select(_e1866, _e1863, (_e1863 > _e1866));
                        let _e1871 = select(_e1847, -(_e1847), (_e1847 < 0f));
                        let _e1873 = select(_e1871, _e1868, (_e1868 > _e1871));
                        if (select(_e1873, _e1860, (_e1860 > _e1873)) <= (0.000000059604645f * (16f - 6f))) {
                            phi_2705_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1688, _e1694, _e1700), array<f32, 3>(_e1744, _e1750, _e1756), array<f32, 3>(_e1800, _e1806, _e1812));
                        } else {
                            phi_2705_ = array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f));
                        }
                        let _e1880 = phi_2705_;
                        phi_2707_ = type_37(array<f32, 3>((_e1549.member_1[0] * _e1556), (_e1549.member_1[1] * _e1556), (_e1549.member_1[2] * _e1556)), _e1880);
                        phi_2708_ = false;
                    } else {
                        phi_2707_ = type_37();
                        phi_2708_ = true;
                    }
                    let _e1883 = phi_2707_;
                    let _e1885 = phi_2708_;
                    phi_2709_ = _e1883;
                    phi_2710_ = _e1885;
                } else {
                    phi_2709_ = type_37();
                    phi_2710_ = true;
                }
                let _e1887 = phi_2709_;
                let _e1889 = phi_2710_;
                if _e1889 {
                    phi_2723_ = type_37(array<f32, 3>(_e636, _e640, _e644), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)));
                } else {
                    phi_2723_ = _e1887;
                }
                let _e1893 = phi_2723_;
                let _e1908 = (((_e274.member_1[0][0] * _e1893.member_1[0][0]) + (_e274.member_1[0][1] * _e1893.member_1[0][1])) + (_e274.member_1[0][2] * _e1893.member_1[0][2]));
                let _e1921 = (((_e274.member_1[1][0] * _e1893.member_1[0][0]) + (_e274.member_1[1][1] * _e1893.member_1[0][1])) + (_e274.member_1[1][2] * _e1893.member_1[0][2]));
                let _e1934 = (((_e274.member_1[2][0] * _e1893.member_1[0][0]) + (_e274.member_1[2][1] * _e1893.member_1[0][1])) + (_e274.member_1[2][2] * _e1893.member_1[0][2]));
                let _e1952 = (((select(_e1908, -(_e1908), (_e1908 < 0f)) * _e274.member_2[0]) + (select(_e1921, -(_e1921), (_e1921 < 0f)) * _e274.member_2[1])) + (select(_e1934, -(_e1934), (_e1934 < 0f)) * _e274.member_2[2]));
                let _e1966 = (((_e274.member_1[0][0] * _e1893.member_1[1][0]) + (_e274.member_1[0][1] * _e1893.member_1[1][1])) + (_e274.member_1[0][2] * _e1893.member_1[1][2]));
                let _e1979 = (((_e274.member_1[1][0] * _e1893.member_1[1][0]) + (_e274.member_1[1][1] * _e1893.member_1[1][1])) + (_e274.member_1[1][2] * _e1893.member_1[1][2]));
                let _e1992 = (((_e274.member_1[2][0] * _e1893.member_1[1][0]) + (_e274.member_1[2][1] * _e1893.member_1[1][1])) + (_e274.member_1[2][2] * _e1893.member_1[1][2]));
                let _e2010 = (((select(_e1966, -(_e1966), (_e1966 < 0f)) * _e274.member_2[0]) + (select(_e1979, -(_e1979), (_e1979 < 0f)) * _e274.member_2[1])) + (select(_e1992, -(_e1992), (_e1992 < 0f)) * _e274.member_2[2]));
                let _e2024 = (((_e274.member_1[0][0] * _e1893.member_1[2][0]) + (_e274.member_1[0][1] * _e1893.member_1[2][1])) + (_e274.member_1[0][2] * _e1893.member_1[2][2]));
                let _e2037 = (((_e274.member_1[1][0] * _e1893.member_1[2][0]) + (_e274.member_1[1][1] * _e1893.member_1[2][1])) + (_e274.member_1[1][2] * _e1893.member_1[2][2]));
                let _e2050 = (((_e274.member_1[2][0] * _e1893.member_1[2][0]) + (_e274.member_1[2][1] * _e1893.member_1[2][1])) + (_e274.member_1[2][2] * _e1893.member_1[2][2]));
                let _e2068 = (((select(_e2024, -(_e2024), (_e2024 < 0f)) * _e274.member_2[0]) + (select(_e2037, -(_e2037), (_e2037 < 0f)) * _e274.member_2[1])) + (select(_e2050, -(_e2050), (_e2050 < 0f)) * _e274.member_2[2]));
                let _e2082 = (((_e391.member_1[0][0] * _e1893.member_1[0][0]) + (_e391.member_1[0][1] * _e1893.member_1[0][1])) + (_e391.member_1[0][2] * _e1893.member_1[0][2]));
                let _e2095 = (((_e391.member_1[1][0] * _e1893.member_1[0][0]) + (_e391.member_1[1][1] * _e1893.member_1[0][1])) + (_e391.member_1[1][2] * _e1893.member_1[0][2]));
                let _e2108 = (((_e391.member_1[2][0] * _e1893.member_1[0][0]) + (_e391.member_1[2][1] * _e1893.member_1[0][1])) + (_e391.member_1[2][2] * _e1893.member_1[0][2]));
                let _e2126 = (((select(_e2082, -(_e2082), (_e2082 < 0f)) * _e391.member_2[0]) + (select(_e2095, -(_e2095), (_e2095 < 0f)) * _e391.member_2[1])) + (select(_e2108, -(_e2108), (_e2108 < 0f)) * _e391.member_2[2]));
                let _e2140 = (((_e391.member_1[0][0] * _e1893.member_1[1][0]) + (_e391.member_1[0][1] * _e1893.member_1[1][1])) + (_e391.member_1[0][2] * _e1893.member_1[1][2]));
                let _e2153 = (((_e391.member_1[1][0] * _e1893.member_1[1][0]) + (_e391.member_1[1][1] * _e1893.member_1[1][1])) + (_e391.member_1[1][2] * _e1893.member_1[1][2]));
                let _e2166 = (((_e391.member_1[2][0] * _e1893.member_1[1][0]) + (_e391.member_1[2][1] * _e1893.member_1[1][1])) + (_e391.member_1[2][2] * _e1893.member_1[1][2]));
                let _e2184 = (((select(_e2140, -(_e2140), (_e2140 < 0f)) * _e391.member_2[0]) + (select(_e2153, -(_e2153), (_e2153 < 0f)) * _e391.member_2[1])) + (select(_e2166, -(_e2166), (_e2166 < 0f)) * _e391.member_2[2]));
                let _e2198 = (((_e391.member_1[0][0] * _e1893.member_1[2][0]) + (_e391.member_1[0][1] * _e1893.member_1[2][1])) + (_e391.member_1[0][2] * _e1893.member_1[2][2]));
                let _e2211 = (((_e391.member_1[1][0] * _e1893.member_1[2][0]) + (_e391.member_1[1][1] * _e1893.member_1[2][1])) + (_e391.member_1[1][2] * _e1893.member_1[2][2]));
                let _e2224 = (((_e391.member_1[2][0] * _e1893.member_1[2][0]) + (_e391.member_1[2][1] * _e1893.member_1[2][1])) + (_e391.member_1[2][2] * _e1893.member_1[2][2]));
                let _e2242 = (((select(_e2198, -(_e2198), (_e2198 < 0f)) * _e391.member_2[0]) + (select(_e2211, -(_e2211), (_e2211 < 0f)) * _e391.member_2[1])) + (select(_e2224, -(_e2224), (_e2224 < 0f)) * _e391.member_2[2]));
                let _e2251 = (((_e1893.member_1[0][0] * _e396) + (_e1893.member_1[0][1] * _e399)) + (_e1893.member_1[0][2] * _e402));
                let _e2260 = (((_e1893.member_1[1][0] * _e396) + (_e1893.member_1[1][1] * _e399)) + (_e1893.member_1[1][2] * _e402));
                let _e2269 = (((_e1893.member_1[2][0] * _e396) + (_e1893.member_1[2][1] * _e399)) + (_e1893.member_1[2][2] * _e402));
                let _e2270 = (_e1952 * -1f);
                let _e2271 = (_e2010 * -1f);
                let _e2272 = (_e2068 * -1f);
                let _e2273 = (_e2251 - _e2126);
                let _e2274 = (_e2260 - _e2184);
                let _e2275 = (_e2269 - _e2242);
                let _e2282 = (_e2251 + _e2126);
                let _e2283 = (_e2260 + _e2184);
                let _e2284 = (_e2269 + _e2242);
                let _e2295 = ((select(_e2273, _e2270, (_e2270 < _e2273)) + select(_e2282, _e1952, (_e1952 > _e2282))) * 0.5f);
                let _e2296 = ((select(_e2274, _e2271, (_e2271 < _e2274)) + select(_e2283, _e2010, (_e2010 > _e2283))) * 0.5f);
                let _e2297 = ((select(_e2275, _e2272, (_e2272 < _e2275)) + select(_e2284, _e2068, (_e2068 > _e2284))) * 0.5f);
                let _e2326 = (_e274.member[0] + (((_e1893.member_1[0][0] * _e2295) + (_e1893.member_1[1][0] * _e2296)) + (_e1893.member_1[2][0] * _e2297)));
                let _e2328 = (_e274.member[1] + (((_e1893.member_1[0][1] * _e2295) + (_e1893.member_1[1][1] * _e2296)) + (_e1893.member_1[2][1] * _e2297)));
                let _e2330 = (_e274.member[2] + (((_e1893.member_1[0][2] * _e2295) + (_e1893.member_1[1][2] * _e2296)) + (_e1893.member_1[2][2] * _e2297)));
                let _e2336 = select(_e274.member[0], -(_e274.member[0]), (_e274.member[0] < 0f));
                let _e2340 = select(_e274.member[1], -(_e274.member[1]), (_e274.member[1] < 0f));
                let _e2344 = select(_e274.member[2], -(_e274.member[2]), (_e274.member[2] < 0f));
                let _e2349 = select(_e391.member[0], -(_e391.member[0]), (_e391.member[0] < 0f));
                let _e2353 = select(_e391.member[1], -(_e391.member[1]), (_e391.member[1] < 0f));
                let _e2357 = select(_e391.member[2], -(_e391.member[2]), (_e391.member[2] < 0f));
                let _e2359 = select(_e2349, _e2336, (_e2336 > _e2349));
                let _e2361 = select(_e2353, _e2340, (_e2340 > _e2353));
                let _e2363 = select(_e2357, _e2344, (_e2344 > _e2357));
                let _e2366 = (_e274.member[0] - _e2326);
                let _e2368 = (_e274.member[1] - _e2328);
                let _e2370 = (_e274.member[2] - _e2330);
                let _e2383 = (((select(_e2366, -(_e2366), (_e2366 < 0f)) + select(_e2368, -(_e2368), (_e2368 < 0f))) + select(_e2370, -(_e2370), (_e2370 < 0f))) * (0.000000059604645f * 16f));
                let _e2438 = (0.000000059604645f * 12f);
                let _e2442 = (((((select(_e1893.member_1[0][0], -(_e1893.member_1[0][0]), (_e1893.member_1[0][0] < 0f)) * _e2359) + (select(_e1893.member_1[0][1], -(_e1893.member_1[0][1]), (_e1893.member_1[0][1] < 0f)) * _e2361)) + (select(_e1893.member_1[0][2], -(_e1893.member_1[0][2]), (_e1893.member_1[0][2] < 0f)) * _e2363)) * _e2438) + _e2383);
                let _e2443 = (((((select(_e1893.member_1[1][0], -(_e1893.member_1[1][0]), (_e1893.member_1[1][0] < 0f)) * _e2359) + (select(_e1893.member_1[1][1], -(_e1893.member_1[1][1]), (_e1893.member_1[1][1] < 0f)) * _e2361)) + (select(_e1893.member_1[1][2], -(_e1893.member_1[1][2]), (_e1893.member_1[1][2] < 0f)) * _e2363)) * _e2438) + _e2383);
                let _e2444 = (((((select(_e1893.member_1[2][0], -(_e1893.member_1[2][0]), (_e1893.member_1[2][0] < 0f)) * _e2359) + (select(_e1893.member_1[2][1], -(_e1893.member_1[2][1]), (_e1893.member_1[2][1] < 0f)) * _e2361)) + (select(_e1893.member_1[2][2], -(_e1893.member_1[2][2]), (_e1893.member_1[2][2] < 0f)) * _e2363)) * _e2438) + _e2383);
                let _e2447 = (_e274.member[0] - _e2326);
                let _e2449 = (_e274.member[1] - _e2328);
                let _e2451 = (_e274.member[2] - _e2330);
                let _e2471 = select(_e2447, -(_e2447), (_e2447 < 0f));
                let _e2474 = select(_e2449, -(_e2449), (_e2449 < 0f));
                let _e2477 = select(_e2451, -(_e2451), (_e2451 < 0f));
                let _e2532 = (0.000000059604645f * 8f);
                let _e2537 = ((((select(_e274.member_2[0], -(_e274.member_2[0]), (_e274.member_2[0] < 0f)) + select(_e274.member_2[1], -(_e274.member_2[1]), (_e274.member_2[1] < 0f))) + select(_e274.member_2[2], -(_e274.member_2[2]), (_e274.member_2[2] < 0f))) * (0.000000059604645f * 64f)) + (0.000000000000000000000000000000000000011754944f * 64f));
                let _e2549 = (((_e1893.member_1[0][0] * _e2447) + (_e1893.member_1[0][1] * _e2449)) + (_e1893.member_1[0][2] * _e2451));
                let _e2558 = (((_e1893.member_1[1][0] * _e2447) + (_e1893.member_1[1][1] * _e2449)) + (_e1893.member_1[1][2] * _e2451));
                let _e2567 = (((_e1893.member_1[2][0] * _e2447) + (_e1893.member_1[2][1] * _e2449)) + (_e1893.member_1[2][2] * _e2451));
                let _e2590 = (((_e274.member_1[0][0] * _e1893.member_1[0][0]) + (_e274.member_1[0][1] * _e1893.member_1[0][1])) + (_e274.member_1[0][2] * _e1893.member_1[0][2]));
                let _e2603 = (((_e274.member_1[1][0] * _e1893.member_1[0][0]) + (_e274.member_1[1][1] * _e1893.member_1[0][1])) + (_e274.member_1[1][2] * _e1893.member_1[0][2]));
                let _e2616 = (((_e274.member_1[2][0] * _e1893.member_1[0][0]) + (_e274.member_1[2][1] * _e1893.member_1[0][1])) + (_e274.member_1[2][2] * _e1893.member_1[0][2]));
                let _e2648 = (((_e274.member_1[0][0] * _e1893.member_1[1][0]) + (_e274.member_1[0][1] * _e1893.member_1[1][1])) + (_e274.member_1[0][2] * _e1893.member_1[1][2]));
                let _e2661 = (((_e274.member_1[1][0] * _e1893.member_1[1][0]) + (_e274.member_1[1][1] * _e1893.member_1[1][1])) + (_e274.member_1[1][2] * _e1893.member_1[1][2]));
                let _e2674 = (((_e274.member_1[2][0] * _e1893.member_1[1][0]) + (_e274.member_1[2][1] * _e1893.member_1[1][1])) + (_e274.member_1[2][2] * _e1893.member_1[1][2]));
                let _e2706 = (((_e274.member_1[0][0] * _e1893.member_1[2][0]) + (_e274.member_1[0][1] * _e1893.member_1[2][1])) + (_e274.member_1[0][2] * _e1893.member_1[2][2]));
                let _e2719 = (((_e274.member_1[1][0] * _e1893.member_1[2][0]) + (_e274.member_1[1][1] * _e1893.member_1[2][1])) + (_e274.member_1[1][2] * _e1893.member_1[2][2]));
                let _e2732 = (((_e274.member_1[2][0] * _e1893.member_1[2][0]) + (_e274.member_1[2][1] * _e1893.member_1[2][1])) + (_e274.member_1[2][2] * _e1893.member_1[2][2]));
                let _e2759 = (_e391.member[0] - _e2326);
                let _e2761 = (_e391.member[1] - _e2328);
                let _e2763 = (_e391.member[2] - _e2330);
                let _e2783 = select(_e2759, -(_e2759), (_e2759 < 0f));
                let _e2786 = select(_e2761, -(_e2761), (_e2761 < 0f));
                let _e2789 = select(_e2763, -(_e2763), (_e2763 < 0f));
                let _e2844 = (0.000000059604645f * 8f);
                let _e2849 = ((((select(_e391.member_2[0], -(_e391.member_2[0]), (_e391.member_2[0] < 0f)) + select(_e391.member_2[1], -(_e391.member_2[1]), (_e391.member_2[1] < 0f))) + select(_e391.member_2[2], -(_e391.member_2[2]), (_e391.member_2[2] < 0f))) * (0.000000059604645f * 64f)) + (0.000000000000000000000000000000000000011754944f * 64f));
                let _e2861 = (((_e1893.member_1[0][0] * _e2759) + (_e1893.member_1[0][1] * _e2761)) + (_e1893.member_1[0][2] * _e2763));
                let _e2870 = (((_e1893.member_1[1][0] * _e2759) + (_e1893.member_1[1][1] * _e2761)) + (_e1893.member_1[1][2] * _e2763));
                let _e2879 = (((_e1893.member_1[2][0] * _e2759) + (_e1893.member_1[2][1] * _e2761)) + (_e1893.member_1[2][2] * _e2763));
                let _e2902 = (((_e391.member_1[0][0] * _e1893.member_1[0][0]) + (_e391.member_1[0][1] * _e1893.member_1[0][1])) + (_e391.member_1[0][2] * _e1893.member_1[0][2]));
                let _e2915 = (((_e391.member_1[1][0] * _e1893.member_1[0][0]) + (_e391.member_1[1][1] * _e1893.member_1[0][1])) + (_e391.member_1[1][2] * _e1893.member_1[0][2]));
                let _e2928 = (((_e391.member_1[2][0] * _e1893.member_1[0][0]) + (_e391.member_1[2][1] * _e1893.member_1[0][1])) + (_e391.member_1[2][2] * _e1893.member_1[0][2]));
                let _e2960 = (((_e391.member_1[0][0] * _e1893.member_1[1][0]) + (_e391.member_1[0][1] * _e1893.member_1[1][1])) + (_e391.member_1[0][2] * _e1893.member_1[1][2]));
                let _e2973 = (((_e391.member_1[1][0] * _e1893.member_1[1][0]) + (_e391.member_1[1][1] * _e1893.member_1[1][1])) + (_e391.member_1[1][2] * _e1893.member_1[1][2]));
                let _e2986 = (((_e391.member_1[2][0] * _e1893.member_1[1][0]) + (_e391.member_1[2][1] * _e1893.member_1[1][1])) + (_e391.member_1[2][2] * _e1893.member_1[1][2]));
                let _e3018 = (((_e391.member_1[0][0] * _e1893.member_1[2][0]) + (_e391.member_1[0][1] * _e1893.member_1[2][1])) + (_e391.member_1[0][2] * _e1893.member_1[2][2]));
                let _e3031 = (((_e391.member_1[1][0] * _e1893.member_1[2][0]) + (_e391.member_1[1][1] * _e1893.member_1[2][1])) + (_e391.member_1[1][2] * _e1893.member_1[2][2]));
                let _e3044 = (((_e391.member_1[2][0] * _e1893.member_1[2][0]) + (_e391.member_1[2][1] * _e1893.member_1[2][1])) + (_e391.member_1[2][2] * _e1893.member_1[2][2]));
                let _e3069 = (((select(_e2549, -(_e2549), (_e2549 < 0f)) + (((select(_e2590, -(_e2590), (_e2590 < 0f)) * _e274.member_2[0]) + (select(_e2603, -(_e2603), (_e2603 < 0f)) * _e274.member_2[1])) + (select(_e2616, -(_e2616), (_e2616 < 0f)) * _e274.member_2[2]))) + (((((select(_e1893.member_1[0][0], -(_e1893.member_1[0][0]), (_e1893.member_1[0][0] < 0f)) * _e2471) + (select(_e1893.member_1[0][1], -(_e1893.member_1[0][1]), (_e1893.member_1[0][1] < 0f)) * _e2474)) + (select(_e1893.member_1[0][2], -(_e1893.member_1[0][2]), (_e1893.member_1[0][2] < 0f)) * _e2477)) * _e2532) + _e2537)) + _e2442);
                let _e3070 = (((select(_e2558, -(_e2558), (_e2558 < 0f)) + (((select(_e2648, -(_e2648), (_e2648 < 0f)) * _e274.member_2[0]) + (select(_e2661, -(_e2661), (_e2661 < 0f)) * _e274.member_2[1])) + (select(_e2674, -(_e2674), (_e2674 < 0f)) * _e274.member_2[2]))) + (((((select(_e1893.member_1[1][0], -(_e1893.member_1[1][0]), (_e1893.member_1[1][0] < 0f)) * _e2471) + (select(_e1893.member_1[1][1], -(_e1893.member_1[1][1]), (_e1893.member_1[1][1] < 0f)) * _e2474)) + (select(_e1893.member_1[1][2], -(_e1893.member_1[1][2]), (_e1893.member_1[1][2] < 0f)) * _e2477)) * _e2532) + _e2537)) + _e2443);
                let _e3071 = (((select(_e2567, -(_e2567), (_e2567 < 0f)) + (((select(_e2706, -(_e2706), (_e2706 < 0f)) * _e274.member_2[0]) + (select(_e2719, -(_e2719), (_e2719 < 0f)) * _e274.member_2[1])) + (select(_e2732, -(_e2732), (_e2732 < 0f)) * _e274.member_2[2]))) + (((((select(_e1893.member_1[2][0], -(_e1893.member_1[2][0]), (_e1893.member_1[2][0] < 0f)) * _e2471) + (select(_e1893.member_1[2][1], -(_e1893.member_1[2][1]), (_e1893.member_1[2][1] < 0f)) * _e2474)) + (select(_e1893.member_1[2][2], -(_e1893.member_1[2][2]), (_e1893.member_1[2][2] < 0f)) * _e2477)) * _e2532) + _e2537)) + _e2444);
                let _e3072 = (((select(_e2861, -(_e2861), (_e2861 < 0f)) + (((select(_e2902, -(_e2902), (_e2902 < 0f)) * _e391.member_2[0]) + (select(_e2915, -(_e2915), (_e2915 < 0f)) * _e391.member_2[1])) + (select(_e2928, -(_e2928), (_e2928 < 0f)) * _e391.member_2[2]))) + (((((select(_e1893.member_1[0][0], -(_e1893.member_1[0][0]), (_e1893.member_1[0][0] < 0f)) * _e2783) + (select(_e1893.member_1[0][1], -(_e1893.member_1[0][1]), (_e1893.member_1[0][1] < 0f)) * _e2786)) + (select(_e1893.member_1[0][2], -(_e1893.member_1[0][2]), (_e1893.member_1[0][2] < 0f)) * _e2789)) * _e2844) + _e2849)) + _e2442);
                let _e3073 = (((select(_e2870, -(_e2870), (_e2870 < 0f)) + (((select(_e2960, -(_e2960), (_e2960 < 0f)) * _e391.member_2[0]) + (select(_e2973, -(_e2973), (_e2973 < 0f)) * _e391.member_2[1])) + (select(_e2986, -(_e2986), (_e2986 < 0f)) * _e391.member_2[2]))) + (((((select(_e1893.member_1[1][0], -(_e1893.member_1[1][0]), (_e1893.member_1[1][0] < 0f)) * _e2783) + (select(_e1893.member_1[1][1], -(_e1893.member_1[1][1]), (_e1893.member_1[1][1] < 0f)) * _e2786)) + (select(_e1893.member_1[1][2], -(_e1893.member_1[1][2]), (_e1893.member_1[1][2] < 0f)) * _e2789)) * _e2844) + _e2849)) + _e2443);
                let _e3074 = (((select(_e2879, -(_e2879), (_e2879 < 0f)) + (((select(_e3018, -(_e3018), (_e3018 < 0f)) * _e391.member_2[0]) + (select(_e3031, -(_e3031), (_e3031 < 0f)) * _e391.member_2[1])) + (select(_e3044, -(_e3044), (_e3044 < 0f)) * _e391.member_2[2]))) + (((((select(_e1893.member_1[2][0], -(_e1893.member_1[2][0]), (_e1893.member_1[2][0] < 0f)) * _e2783) + (select(_e1893.member_1[2][1], -(_e1893.member_1[2][1]), (_e1893.member_1[2][1] < 0f)) * _e2786)) + (select(_e1893.member_1[2][2], -(_e1893.member_1[2][2]), (_e1893.member_1[2][2] < 0f)) * _e2789)) * _e2844) + _e2849)) + _e2444);
                let _e3077 = ((bitcast<u32>(_e3069) & 2139095040u) != 2139095040u);
                let _e3080 = ((bitcast<u32>(_e3070) & 2139095040u) != 2139095040u);
                if select(select(bool(), select(bool(), ((bitcast<u32>(_e3071) & 2139095040u) != 2139095040u), _e3080), _e3077), false, select(true, select(true, false, _e3080), _e3077)) {
                    let _e3091 = ((bitcast<u32>(_e3072) & 2139095040u) != 2139095040u);
                    let _e3094 = ((bitcast<u32>(_e3073) & 2139095040u) != 2139095040u);
                    if select(select(bool(), select(bool(), ((bitcast<u32>(_e3074) & 2139095040u) != 2139095040u), _e3094), _e3091), false, select(true, select(true, false, _e3094), _e3091)) {
                        phi_4235_ = type_34(array<f32, 3>(_e2326, _e2328, _e2330), _e1893.member_1, array<f32, 3>(select(_e3072, _e3069, (_e3069 > _e3072)), select(_e3073, _e3070, (_e3070 > _e3073)), select(_e3074, _e3071, (_e3071 > _e3074))));
                        phi_4236_ = false;
                    } else {
                        phi_4235_ = type_34();
                        phi_4236_ = true;
                    }
                    let _e3112 = phi_4235_;
                    let _e3114 = phi_4236_;
                    phi_4237_ = _e3112;
                    phi_4238_ = _e3114;
                } else {
                    phi_4237_ = type_34();
                    phi_4238_ = true;
                }
                let _e3116 = phi_4237_;
                let _e3118 = phi_4238_;
                if _e3118 {
                    let _e3119 = (85070590000000000000000000000000000000f * 3.9999998f);
                    phi_4262_ = type_34(array<f32, 3>(0f, 0f, 0f), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(_e3119, _e3119, _e3119));
                } else {
                    phi_4262_ = _e3116;
                }
                let _e3123 = phi_4262_;
                boxes[_e63] = type_34(array<f32, 3>(_e3123.member[0], _e3123.member[1], _e3123.member[2]), array<array<f32, 3>, 3>(array<f32, 3>(_e3123.member_1[0][0], _e3123.member_1[0][1], _e3123.member_1[0][2]), array<f32, 3>(_e3123.member_1[1][0], _e3123.member_1[1][1], _e3123.member_1[1][2]), array<f32, 3>(_e3123.member_1[2][0], _e3123.member_1[2][1], _e3123.member_1[2][2])), array<f32, 3>(_e3123.member_2[0], _e3123.member_2[1], _e3123.member_2[2]));
                let _e3159 = atomicOr((&done[(_e63 / 32u)]), (1u << bitcast<u32>(((_e63 % 32u) & 31u))));
                phi_4298_ = 2u;
            }
            let _e3161 = phi_4298_;
            workgroupBarrier();
            phi_206_ = _e3161;
        } else {
            phi_206_ = u32();
        }
        let _e3163 = phi_206_;
        continue;
        continuing {
            phi_202_ = type_9(select(_e108.member, (_e108.member + 1u), _e113), select(_e108.member_1, _e108.member_1, _e113));
            phi_205_ = _e3163;
            break if !(_e124);
        }
    }
    let _e3166 = local_9;
    let _e3169 = local_10;
    if select((_e3169 == 3u), true, (_e3166 == 1u)) {
        let _e3173 = atomicAdd((&counters[0u]), 1u);
        phi_4313_ = _e3173;
    } else {
        phi_4313_ = 0u;
    }
    let _e3175 = phi_4313_;
    workgroupBarrier();
    if (_e63 == 0u) {
        let _e3178 = atomicLoad((&counters[0u]));
        if (_e3178 > 0u) {
            let _e3181 = atomicAdd((&far.member[0u]), _e3178);
            atomicStore((&counters[1u]), _e3181);
        }
    }
    workgroupBarrier();
    let _e3186 = params.member.member.member_2[_e79];
    let _e3187 = (_e3186 + _e76);
    let _e3189 = local_11;
    if (_e3189 == 2u) {
        let _e3205 = boxes[_e63];
        oriented.member[_e3187] = type_31(vec4<f32>(_e3205.member[0], _e3205.member[1], _e3205.member[2], _e3205.member_1[0][0]), vec4<f32>(_e3205.member_1[0][1], _e3205.member_1[0][2], _e3205.member_1[1][0], _e3205.member_1[1][1]), vec4<f32>(_e3205.member_1[1][2], _e3205.member_1[2][0], _e3205.member_1[2][1], _e3205.member_1[2][2]), vec4<f32>(_e3205.member_2[0], _e3205.member_2[1], _e3205.member_2[2], 0f));
        stamps.member[_e3187] = 1u;
    } else {
        let _e3192 = local_12;
        if (_e3192 != 0u) {
            let _e3194 = (85070590000000000000000000000000000000f * 3.9999998f);
            oriented.member[_e3187] = type_31(vec4<f32>(0f, 0f, 0f, 1f), vec4<f32>(0f, 0f, 0f, 1f), vec4<f32>(0f, 0f, 0f, 1f), vec4<f32>(_e3194, _e3194, _e3194, 0f));
            stamps.member[_e3187] = 0u;
            let _e3200 = atomicLoad((&counters[1u]));
            atomicStore((&far.member[(4u + (_e3200 + _e3175))]), _e76);
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn orient_near(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}

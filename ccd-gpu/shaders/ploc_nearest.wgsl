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

struct type_16 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_17 {
    member: u32,
    member_1: f32,
}

struct type_18 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_19 {
    member: type_7,
    member_1: type_8,
    member_2: type_18,
}

struct type_20 {
    member: type_19,
}

struct type_21 {
    member: vec4<u32>,
    member_1: vec4<u32>,
}

struct type_23 {
    member: array<type_21>,
}

@group(0) @binding(0) 
var<storage> params: type_20;
@group(0) @binding(1) 
var<storage> clusters: type_23;
@group(0) @binding(2) 
var<storage, read_write> neighbours: type_11;
@group(0) @binding(3) 
var<storage, read_write> counts: type_11;
var<workgroup> near: array<type_16, 512>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_116_: type_9;
    var phi_195_: type_16;
    var phi_196_: type_16;
    var phi_197_: type_16;
    var phi_244_: u32;
    var phi_255_: u32;
    var phi_293_: type_9;
    var phi_296_: type_17;
    var phi_420_: bool;
    var phi_426_: type_17;
    var phi_297_: type_17;
    var local: type_17;
    var phi_428_: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e24 = id_2;
    let _e25 = n_2;
    let _e26 = lane_2;
    let _e35 = ((_e24.y * _e25.x) + _e24.x);
    let _e38 = params.member.member_1.member_1;
    let _e40 = counts.member[_e38];
    let _e42 = select(0u, _e40, (_e40 > 256u));
    let _e45 = params.member.member_2.member_1;
    let _e47 = ((_e35 * 256u) + _e26);
    phi_116_ = type_9(0u, 2u);
    loop {
        let _e49 = phi_116_;
        let _e52 = (_e49.member < _e49.member_1);
        let _e65 = (bitcast<i32>(select(0u, 1u, _e52)) != 0i);
        if _e65 {
            let _e67 = ((select(type_9().member_1, _e49.member, _e52) * 256u) + _e26);
            let _e69 = ((_e35 * 256u) + _e67);
            if (_e69 >= _e45) {
                if ((_e69 - _e45) < _e42) {
                    if (_e67 < (256u + (2u * _e45))) {
                        let _e78 = clusters.member[(_e69 - _e45)];
                        phi_195_ = type_16(array<f32, 3>(bitcast<f32>(_e78.member.x), bitcast<f32>(_e78.member.y), bitcast<f32>(_e78.member.z)), array<f32, 3>(bitcast<f32>(_e78.member_1.x), bitcast<f32>(_e78.member_1.y), bitcast<f32>(_e78.member_1.z)));
                    } else {
                        phi_195_ = type_16(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                    }
                    let _e97 = phi_195_;
                    phi_196_ = _e97;
                } else {
                    phi_196_ = type_16(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                }
                let _e99 = phi_196_;
                phi_197_ = _e99;
            } else {
                phi_197_ = type_16(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            }
            let _e101 = phi_197_;
            near[_e67] = type_16(array<f32, 3>(_e101.member[0], _e101.member[1], _e101.member[2]), array<f32, 3>(_e101.member_1[0], _e101.member_1[1], _e101.member_1[2]));
        }
        continue;
        continuing {
            phi_116_ = type_9(select(_e49.member, (_e49.member + 1u), _e52), select(_e49.member_1, _e49.member_1, _e52));
            break if !(_e65);
        }
    }
    workgroupBarrier();
    if (_e47 < _e42) {
        let _e118 = params.member.member_2.member;
        let _e122 = params.member.member.member[_e118];
        let _e129 = params.member.member_1.member_1;
        if (_e122 > 1u) {
            let _e131 = (_e122 - 1u);
            phi_244_ = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e131)), 32u, (_e131 == 0u)));
        } else {
            phi_244_ = 0u;
        }
        let _e139 = phi_244_;
        if (_e42 > 1u) {
            let _e141 = (_e42 - 1u);
            phi_255_ = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e141)), 32u, (_e141 == 0u)));
        } else {
            phi_255_ = 0u;
        }
        let _e149 = phi_255_;
        if (_e129 >= (6u * ((_e139 - _e149) + 1u))) {
            phi_428_ = select(_e47, (_e47 ^ 1u), ((_e47 ^ 1u) < _e42));
        } else {
            let _e156 = near[(_e45 + _e26)];
            let _e169 = ((_e47 + _e45) + 1u);
            phi_293_ = type_9((_e47 - select(_e45, _e47, (_e47 < _e45))), select(_e169, _e42, (_e42 < _e169)));
            phi_296_ = type_17(_e47, 300000000000000000000000000000000000000f);
            loop {
                let _e175 = phi_293_;
                let _e177 = phi_296_;
                local = _e177;
                let _e180 = (_e175.member < _e175.member_1);
                let _e191 = select(type_9().member_1, _e175.member, _e180);
                let _e193 = (bitcast<i32>(select(0u, 1u, _e180)) != 0i);
                if _e193 {
                    let _e198 = near[((_e191 + _e45) - (_e35 * 256u))];
                    let _e211 = (select(_e198.member_1[0], _e156.member_1[0], (_e156.member_1[0] > _e198.member_1[0])) - select(_e198.member[0], _e156.member[0], (_e156.member[0] < _e198.member[0])));
                    let _e216 = (select(_e198.member_1[1], _e156.member_1[1], (_e156.member_1[1] > _e198.member_1[1])) - select(_e198.member[1], _e156.member[1], (_e156.member[1] < _e198.member[1])));
                    let _e221 = (select(_e198.member_1[2], _e156.member_1[2], (_e156.member_1[2] > _e198.member_1[2])) - select(_e198.member[2], _e156.member[2], (_e156.member[2] < _e198.member[2])));
                    let _e226 = (((_e211 * _e216) + (_e216 * _e221)) + (_e221 * _e211));
                    if (_e191 != _e47) {
                        if (_e226 < _e177.member_1) {
                            phi_420_ = true;
                        } else {
                            phi_420_ = select(false, select(((_e47 ^ _e191) < (_e47 ^ _e177.member)), true, (_e177.member == _e47)), (_e226 == _e177.member_1));
                        }
                        let _e240 = phi_420_;
                        phi_426_ = type_17(select(_e177.member, _e191, _e240), select(_e177.member_1, _e226, _e240));
                    } else {
                        phi_426_ = _e177;
                    }
                    let _e247 = phi_426_;
                    phi_297_ = _e247;
                } else {
                    phi_297_ = type_17();
                }
                let _e249 = phi_297_;
                continue;
                continuing {
                    phi_293_ = type_9(select(_e175.member, (_e175.member + 1u), _e180), select(_e175.member_1, _e175.member_1, _e180));
                    phi_296_ = _e249;
                    break if !(_e193);
                }
            }
            let _e252 = local;
            phi_428_ = _e252.member;
        }
        let _e255 = phi_428_;
        neighbours.member[_e47] = _e255;
        if (_e26 == 0u) {
            if ((_e35 % 256u) == 0u) {
                counts.member[(192u + (_e35 / 256u))] = 0u;
            }
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn ploc_nearest(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}

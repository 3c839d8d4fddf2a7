struct type_9 {
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
    member_18: array<array<u32, 4>, 8>,
}

struct type_11 {
    member: type_9,
}

struct type_15 {
    member: array<u32>,
}

struct type_20 {
    member: u32,
    member_1: u32,
}

var<private> id_1: vec3<u32>;
var<private> lane_1: u32;
@group(0) @binding(0) 
var<storage> params: type_11;
@group(0) @binding(1) 
var<storage, read_write> table: type_15;
var<workgroup> sums: array<u32, 512>;

fn function_() {
    var phi_75_: u32;
    var phi_78_: type_20;
    var phi_81_: u32;
    var phi_79_: type_20;
    var phi_104_: type_20;
    var phi_131_: u32;
    var phi_135_: type_20;
    var phi_138_: u32;
    var phi_140_: u32;
    var phi_142_: u32;
    var phi_139_: u32;
    var phi_136_: type_20;
    var phi_165_: type_20;
    var phi_181_: u32;
    var phi_141_: u32;
    var phi_143_: u32;
    var local: u32;
    var phi_82_: u32;
    var local_1: u32;

    let _e20 = id_1;
    let _e21 = lane_1;
    let _e26 = params.member.member_11;
    let _e27 = (_e20.x * _e26);
    let _e29 = params.member.member_11;
    let _e30 = (_e29 / 256u);
    if ((_e29 % 256u) > 0u) {
        phi_75_ = (_e30 + 1u);
    } else {
        phi_75_ = _e30;
    }
    let _e35 = phi_75_;
    phi_78_ = type_20(0u, _e35);
    phi_81_ = 0u;
    loop {
        let _e38 = phi_78_;
        let _e40 = phi_81_;
        local_1 = _e40;
        if (_e38.member < _e38.member_1) {
            phi_79_ = type_20((_e38.member + 1u), _e38.member_1);
            phi_104_ = type_20(1u, _e38.member);
        } else {
            phi_79_ = _e38;
            phi_104_ = type_20(0u, type_20().member_1);
        }
        let _e54 = phi_79_;
        let _e56 = phi_104_;
        let _e60 = (bitcast<i32>(_e56.member) != 0i);
        if _e60 {
            let _e62 = ((_e56.member_1 * 256u) + _e21);
            let _e64 = params.member.member_11;
            if (_e62 < _e64) {
                let _e68 = table.member[(_e27 + _e62)];
                phi_131_ = _e68;
            } else {
                phi_131_ = 0u;
            }
            let _e70 = phi_131_;
            sums[_e21] = _e70;
            phi_135_ = type_20(0u, 8u);
            phi_138_ = 0u;
            phi_140_ = 1u;
            phi_142_ = _e70;
            phi_139_ = 256u;
            loop {
                let _e73 = phi_135_;
                let _e75 = phi_138_;
                let _e77 = phi_140_;
                let _e79 = phi_142_;
                let _e81 = phi_139_;
                local = _e79;
                if (_e73.member < _e73.member_1) {
                    phi_136_ = type_20((_e73.member + 1u), _e73.member_1);
                    phi_165_ = type_20(1u, _e73.member);
                } else {
                    phi_136_ = _e73;
                    phi_165_ = type_20(0u, type_20().member_1);
                }
                let _e95 = phi_136_;
                let _e97 = phi_165_;
                let _e100 = (bitcast<i32>(_e97.member) != 0i);
                if _e100 {
                    workgroupBarrier();
                    if (_e21 >= _e77) {
                        let _e105 = sums[((_e75 + _e21) - _e77)];
                        phi_181_ = (_e79 + _e105);
                    } else {
                        phi_181_ = _e79;
                    }
                    let _e108 = phi_181_;
                    sums[(_e81 + _e21)] = _e108;
                    phi_141_ = (_e77 * 2u);
                    phi_143_ = _e108;
                } else {
                    phi_141_ = u32();
                    phi_143_ = u32();
                }
                let _e113 = phi_141_;
                let _e115 = phi_143_;
                continue;
                continuing {
                    phi_135_ = _e95;
                    phi_138_ = _e81;
                    phi_140_ = _e113;
                    phi_142_ = _e115;
                    phi_139_ = _e75;
                    break if !(_e100);
                }
            }
            workgroupBarrier();
            let _e118 = params.member.member_11;
            if (_e62 < _e118) {
                let _e122 = local;
                table.member[(_e27 + _e62)] = ((_e40 + _e122) - _e70);
            }
            let _e127 = sums[255u];
            workgroupBarrier();
            phi_82_ = (_e40 + _e127);
        } else {
            phi_82_ = u32();
        }
        let _e130 = phi_82_;
        continue;
        continuing {
            phi_78_ = _e54;
            phi_81_ = _e130;
            break if !(_e60);
        }
    }
    if (_e21 == 0u) {
        let _e134 = params.member.member_11;
        let _e140 = local_1;
        table.member[((256u * _e134) + _e20.x)] = _e140;
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn sort_scan(@builtin(workgroup_id) id: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    id_1 = id;
    lane_1 = lane;
    function_();
}

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
var<private> lane_1: u32;
@group(0) @binding(0) 
var<storage> params: type_12;
@group(0) @binding(1) 
var<storage, read_write> table: type_16;
var<workgroup> sums: array<u32, 512>;

fn function_() {
    var phi_76_: u32;
    var phi_79_: type_21;
    var phi_82_: u32;
    var phi_80_: type_21;
    var phi_105_: type_21;
    var phi_132_: u32;
    var phi_136_: type_21;
    var phi_139_: u32;
    var phi_141_: u32;
    var phi_143_: u32;
    var phi_140_: u32;
    var phi_137_: type_21;
    var phi_166_: type_21;
    var phi_182_: u32;
    var phi_142_: u32;
    var phi_144_: u32;
    var local: u32;
    var phi_83_: u32;
    var local_1: u32;

    let _e20 = id_1;
    let _e21 = lane_1;
    let _e26 = params.member.member_11;
    let _e27 = (_e20.x * _e26);
    let _e29 = params.member.member_11;
    let _e30 = (_e29 / 256u);
    if ((_e29 % 256u) > 0u) {
        phi_76_ = (_e30 + 1u);
    } else {
        phi_76_ = _e30;
    }
    let _e35 = phi_76_;
    phi_79_ = type_21(0u, _e35);
    phi_82_ = 0u;
    loop {
        let _e38 = phi_79_;
        let _e40 = phi_82_;
        local_1 = _e40;
        if (_e38.member < _e38.member_1) {
            phi_80_ = type_21((_e38.member + 1u), _e38.member_1);
            phi_105_ = type_21(1u, _e38.member);
        } else {
            phi_80_ = _e38;
            phi_105_ = type_21(0u, type_21().member_1);
        }
        let _e54 = phi_80_;
        let _e56 = phi_105_;
        let _e60 = (bitcast<i32>(_e56.member) != 0i);
        if _e60 {
            let _e62 = ((_e56.member_1 * 256u) + _e21);
            let _e64 = params.member.member_11;
            if (_e62 < _e64) {
                let _e68 = table.member[(_e27 + _e62)];
                phi_132_ = _e68;
            } else {
                phi_132_ = 0u;
            }
            let _e70 = phi_132_;
            sums[_e21] = _e70;
            phi_136_ = type_21(0u, 8u);
            phi_139_ = 0u;
            phi_141_ = 1u;
            phi_143_ = _e70;
            phi_140_ = 256u;
            loop {
                let _e73 = phi_136_;
                let _e75 = phi_139_;
                let _e77 = phi_141_;
                let _e79 = phi_143_;
                let _e81 = phi_140_;
                local = _e79;
                if (_e73.member < _e73.member_1) {
                    phi_137_ = type_21((_e73.member + 1u), _e73.member_1);
                    phi_166_ = type_21(1u, _e73.member);
                } else {
                    phi_137_ = _e73;
                    phi_166_ = type_21(0u, type_21().member_1);
                }
                let _e95 = phi_137_;
                let _e97 = phi_166_;
                let _e100 = (bitcast<i32>(_e97.member) != 0i);
                if _e100 {
                    workgroupBarrier();
                    if (_e21 >= _e77) {
                        let _e105 = sums[((_e75 + _e21) - _e77)];
                        phi_182_ = (_e79 + _e105);
                    } else {
                        phi_182_ = _e79;
                    }
                    let _e108 = phi_182_;
                    sums[(_e81 + _e21)] = _e108;
                    phi_142_ = (_e77 * 2u);
                    phi_144_ = _e108;
                } else {
                    phi_142_ = u32();
                    phi_144_ = u32();
                }
                let _e113 = phi_142_;
                let _e115 = phi_144_;
                continue;
                continuing {
                    phi_136_ = _e95;
                    phi_139_ = _e81;
                    phi_141_ = _e113;
                    phi_143_ = _e115;
                    phi_140_ = _e75;
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
            phi_83_ = (_e40 + _e127);
        } else {
            phi_83_ = u32();
        }
        let _e130 = phi_83_;
        continue;
        continuing {
            phi_79_ = _e54;
            phi_82_ = _e130;
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

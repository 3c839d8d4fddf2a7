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
var<storage, read_write> table: type_11;
var<workgroup> sums: array<u32, 512>;

fn function_(id_1: vec3<u32>, lane_1: u32) {
    var phi_76_: u32;
    var phi_79_: type_13;
    var phi_82_: u32;
    var phi_80_: type_13;
    var phi_105_: type_13;
    var phi_132_: u32;
    var phi_136_: type_13;
    var phi_139_: u32;
    var phi_141_: u32;
    var phi_143_: u32;
    var phi_140_: u32;
    var phi_137_: type_13;
    var phi_166_: type_13;
    var phi_182_: u32;
    var phi_142_: u32;
    var phi_144_: u32;
    var local: u32;
    var phi_83_: u32;
    var local_1: u32;
    var id_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    lane_2 = lane_1;
    let _e14 = id_2;
    let _e15 = lane_2;
    let _e20 = params.member.member_11;
    let _e21 = (_e14.x * _e20);
    let _e23 = params.member.member_11;
    let _e24 = (_e23 / 256u);
    if ((_e23 % 256u) > 0u) {
        phi_76_ = (_e24 + 1u);
    } else {
        phi_76_ = _e24;
    }
    let _e29 = phi_76_;
    phi_79_ = type_13(0u, _e29);
    phi_82_ = 0u;
    loop {
        let _e32 = phi_79_;
        let _e34 = phi_82_;
        local_1 = _e34;
        if (_e32.member < _e32.member_1) {
            phi_80_ = type_13((_e32.member + 1u), _e32.member_1);
            phi_105_ = type_13(1u, _e32.member);
        } else {
            phi_80_ = _e32;
            phi_105_ = type_13(0u, type_13().member_1);
        }
        let _e46 = phi_80_;
        let _e48 = phi_105_;
        let _e52 = (bitcast<i32>(_e48.member) != 0i);
        if _e52 {
            let _e54 = ((_e48.member_1 * 256u) + _e15);
            let _e56 = params.member.member_11;
            if (_e54 < _e56) {
                let _e60 = table.member[(_e21 + _e54)];
                phi_132_ = _e60;
            } else {
                phi_132_ = 0u;
            }
            let _e62 = phi_132_;
            sums[_e15] = _e62;
            phi_136_ = type_13(0u, 8u);
            phi_139_ = 0u;
            phi_141_ = 1u;
            phi_143_ = _e62;
            phi_140_ = 256u;
            loop {
                let _e65 = phi_136_;
                let _e67 = phi_139_;
                let _e69 = phi_141_;
                let _e71 = phi_143_;
                let _e73 = phi_140_;
                local = _e71;
                if (_e65.member < _e65.member_1) {
                    phi_137_ = type_13((_e65.member + 1u), _e65.member_1);
                    phi_166_ = type_13(1u, _e65.member);
                } else {
                    phi_137_ = _e65;
                    phi_166_ = type_13(0u, type_13().member_1);
                }
                let _e85 = phi_137_;
                let _e87 = phi_166_;
                let _e90 = (bitcast<i32>(_e87.member) != 0i);
                if _e90 {
                    workgroupBarrier();
                    if (_e15 >= _e69) {
                        let _e95 = sums[((_e67 + _e15) - _e69)];
                        phi_182_ = (_e71 + _e95);
                    } else {
                        phi_182_ = _e71;
                    }
                    let _e98 = phi_182_;
                    sums[(_e73 + _e15)] = _e98;
                    phi_142_ = (_e69 * 2u);
                    phi_144_ = _e98;
                } else {
                    phi_142_ = u32();
                    phi_144_ = u32();
                }
                let _e103 = phi_142_;
                let _e105 = phi_144_;
                continue;
                continuing {
                    phi_136_ = _e85;
                    phi_139_ = _e73;
                    phi_141_ = _e103;
                    phi_143_ = _e105;
                    phi_140_ = _e67;
                    break if !(_e90);
                }
            }
            workgroupBarrier();
            let _e108 = params.member.member_11;
            if (_e54 < _e108) {
                let _e112 = local;
                table.member[(_e21 + _e54)] = ((_e34 + _e112) - _e62);
            }
            let _e117 = sums[255u];
            workgroupBarrier();
            phi_83_ = (_e34 + _e117);
        } else {
            phi_83_ = u32();
        }
        let _e120 = phi_83_;
        continue;
        continuing {
            phi_79_ = _e46;
            phi_82_ = _e120;
            break if !(_e52);
        }
    }
    if (_e15 == 0u) {
        let _e124 = params.member.member_11;
        let _e130 = local_1;
        table.member[((256u * _e124) + _e14.x)] = _e130;
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn sort_scan(@builtin(workgroup_id) id: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, lane);
}

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

struct type_14 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
}

struct type_16 {
    member: array<type_14>,
}

struct type_17 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
    member_7: u32,
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
    member_18: u32,
}

struct type_18 {
    member: type_7,
    member_1: type_8,
    member_2: type_17,
}

struct type_19 {
    member: type_18,
}

struct type_22 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_19;
@group(0) @binding(6) 
var<storage, read_write> front: type_11;
@group(0) @binding(5) 
var<storage, read_write> pairs: type_22;
@group(0) @binding(1) 
var<storage> a: type_16;
@group(0) @binding(2) 
var<storage> b: type_16;
@group(0) @binding(3) 
var<storage, read_write> control: type_22;
@group(0) @binding(4) 
var<storage, read_write> nodes: type_22;
var<workgroup> shared_: array<atomic<u32>, 22>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_202_: array<u32, 2>;
    var phi_335_: u32;
    var phi_336_: u32;
    var phi_354_: array<u32, 2>;
    var phi_355_: array<u32, 2>;
    var phi_367_: array<u32, 2>;
    var phi_368_: array<u32, 2>;
    var phi_531_: type_9;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e31 = id_2;
    let _e32 = n_2;
    let _e33 = lane_2;
    let _e47 = ((((_e31.y * _e32.x) + _e31.x) * 128u) + _e33);
    let _e49 = params.member.member_2;
    let _e51 = params.member.member_1;
    if (_e47 < _e51.member) {
        let _e59 = (2u * (((1u - _e49.member_5) * _e49.member_4) + _e47));
        let _e61 = front.member[_e59];
        let _e64 = front.member[(_e59 + 1u)];
        phi_202_ = array<u32, 2>(_e61, _e64);
    } else {
        phi_202_ = array<u32, 2>(4294967295u, 4294967295u);
    }
    let _e67 = phi_202_;
    if (_e33 == 0u) {
        atomicStore((&shared_[6u]), 0u);
        atomicStore((&shared_[7u]), 0u);
        atomicStore((&shared_[8u]), 0u);
    }
    workgroupBarrier();
    if (_e67[0] != 4294967295u) {
        let _e76 = a.member[_e67[0]];
        let _e79 = b.member[_e67[1]];
        if ((((((_e76.member[0] <= _e79.member_2[0]) && (_e79.member[0] <= _e76.member_2[0])) && (_e76.member[1] <= _e79.member_2[1])) && (_e79.member[1] <= _e76.member_2[1])) && (_e76.member[2] <= _e79.member_2[2])) && (_e79.member[2] <= _e76.member_2[2])) {
            let _e109 = params.member.member_2.member;
            let _e110 = (_e109 == 0u);
            let _e116 = params.member.member.member[select(1u, 0u, _e110)];
            let _e121 = params.member.member.member[select(1u, 2u, _e110)];
            phi_335_ = select(select(2u, 1u, select(true, select(true, false, (_e67[1] >= (_e121 - 1u))), (_e67[0] >= (_e116 - 1u)))), 0u, (_e67[0] == 4294967295u));
        } else {
            phi_335_ = 3u;
        }
        let _e134 = phi_335_;
        phi_336_ = _e134;
    } else {
        phi_336_ = 0u;
    }
    let _e136 = phi_336_;
    if (_e136 == 1u) {
        let _e146 = atomicAdd((&shared_[6u]), 1u);
        phi_355_ = array<u32, 2>(_e146, 0u);
    } else {
        if (_e136 == 2u) {
            let _e141 = atomicAdd((&shared_[7u]), 1u);
            phi_354_ = array<u32, 2>(_e141, 0u);
        } else {
            phi_354_ = array<u32, 2>(0u, 0u);
        }
        let _e144 = phi_354_;
        phi_355_ = _e144;
    }
    let _e149 = phi_355_;
    if (_e136 >= 2u) {
        if (_e49.member_4 > 0u) {
            let _e153 = atomicAdd((&shared_[8u]), 1u);
            phi_367_ = array<u32, 2>(_e149[0], _e153);
        } else {
            phi_367_ = _e149;
        }
        let _e157 = phi_367_;
        phi_368_ = _e157;
    } else {
        phi_368_ = _e149;
    }
    let _e159 = phi_368_;
    workgroupBarrier();
    if (_e33 == 0u) {
        let _e162 = atomicLoad((&shared_[6u]));
        let _e164 = atomicLoad((&shared_[7u]));
        if (_e162 > 0u) {
            let _e167 = atomicAdd((&control.member[0u]), _e162);
            let _e170 = atomicMax((&nodes.member[0u]), (_e167 + _e162));
            if ((_e167 + _e162) < _e167) {
                let _e174 = atomicAdd((&nodes.member[2u]), 1u);
            }
            atomicStore((&shared_[11u]), _e167);
        }
        if (_e164 > 0u) {
            let _e178 = atomicAdd((&pairs.member[0u]), _e164);
            if ((_e178 + _e164) < _e178) {
                let _e182 = atomicAdd((&pairs.member[2u]), 1u);
            }
            atomicStore((&shared_[12u]), _e178);
        }
        let _e185 = atomicLoad((&shared_[8u]));
        if (_e185 > 0u) {
            let _e188 = atomicLoad((&shared_[8u]));
            let _e190 = atomicAdd((&control.member[1537u]), _e188);
            if ((_e190 + _e188) < _e190) {
                let _e194 = atomicAdd((&control.member[1538u]), 1u);
            }
            atomicStore((&shared_[13u]), _e190);
        }
    }
    workgroupBarrier();
    if (_e136 == 1u) {
        let _e252 = atomicLoad((&shared_[11u]));
        let _e254 = (_e252 + _e159[0]);
        if (_e254 < _e49.member_3) {
            if (_e254 < 4294967295u) {
                let _e260 = (2u * _e254);
                atomicStore((&nodes.member[(4u + _e260)]), _e67[0]);
                atomicStore((&nodes.member[(_e260 + 5u)]), _e67[1]);
            }
        }
    } else {
        if (_e136 == 0u) {
        } else {
            if (_e136 == 2u) {
                let _e201 = a.member[_e67[0]];
                let _e205 = b.member[_e67[1]];
                let _e209 = params.member.member_2.member;
                if (_e209 == 1u) {
                    let _e212 = (_e201.member_1 < _e205.member_1);
                    phi_531_ = type_9(select(_e205.member_1, _e201.member_1, _e212), select(_e201.member_1, _e205.member_1, _e212));
                } else {
                    phi_531_ = type_9(_e201.member_1, _e205.member_1);
                }
                let _e217 = phi_531_;
                let _e221 = params.member.member_1;
                let _e224 = atomicLoad((&shared_[12u]));
                let _e226 = (_e224 + _e159[0]);
                if (_e226 < _e221.member_3) {
                    let _e228 = (2u * _e226);
                    atomicStore((&pairs.member[(4u + _e228)]), _e217.member);
                    atomicStore((&pairs.member[(_e228 + 5u)]), _e217.member_1);
                }
            }
            if (_e49.member_4 > 0u) {
                let _e236 = atomicLoad((&shared_[13u]));
                let _e238 = (_e236 + _e159[1]);
                if (_e238 < _e49.member_4) {
                    let _e245 = (2u * ((_e49.member_5 * _e49.member_4) + _e238));
                    front.member[_e245] = _e67[0];
                    front.member[(_e245 + 1u)] = _e67[1];
                }
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn resume_front(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}

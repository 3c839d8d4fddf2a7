struct type_4 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

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

struct type_11 {
    member: type_10,
}

struct type_13 {
    member: array<type_4>,
}

struct type_15 {
    member: array<array<u32, 3>>,
}

struct type_17 {
    member: u32,
    member_1: u32,
}

@group(0) @binding(0) 
var<storage> params: type_11;
@group(0) @binding(2) 
var<storage, read_write> boxes: type_13;
@group(0) @binding(1) 
var<storage> faces: type_15;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_4;
    var local_1: type_4;
    var local_2: type_4;
    var local_3: type_4;
    var phi_139_: type_17;
    var phi_140_: type_17;
    var phi_163_: type_17;
    var phi_189_: f32;
    var phi_216_: f32;
    var phi_270_: type_17;
    var phi_271_: type_17;
    var phi_294_: type_17;
    var phi_320_: f32;
    var phi_347_: f32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e17 = id_2;
    let _e18 = n_2;
    let _e19 = lane_2;
    let _e29 = ((((_e17.y * _e18.x) + _e17.x) * 256u) + _e19);
    let _e32 = params.member.member[2u];
    if (_e29 < _e32) {
        let _e35 = faces.member[_e29];
        let _e40 = boxes.member[_e35[0]];
        let _e42 = boxes.member[_e35[1]];
        local_2 = type_4(array<f32, 3>(_e42.member[0], _e42.member[1], _e42.member[2]), array<f32, 3>(_e42.member_1[0], _e42.member_1[1], _e42.member_1[2]));
        local_1 = type_4(array<f32, 3>(_e40.member[0], _e40.member[1], _e40.member[2]), array<f32, 3>(_e40.member_1[0], _e40.member_1[1], _e40.member_1[2]));
        phi_139_ = type_17(0u, 3u);
        loop {
            let _e66 = phi_139_;
            if (_e66.member < _e66.member_1) {
                phi_140_ = type_17((_e66.member + 1u), _e66.member_1);
                phi_163_ = type_17(1u, _e66.member);
            } else {
                phi_140_ = _e66;
                phi_163_ = type_17(0u, type_17().member_1);
            }
            let _e78 = phi_140_;
            let _e80 = phi_163_;
            let _e84 = (bitcast<i32>(_e80.member) != 0i);
            if _e84 {
                let _e87 = local_1.member[_e80.member_1];
                let _e90 = local_2.member[_e80.member_1];
                if (_e87 < _e90) {
                    phi_189_ = _e87;
                } else {
                    phi_189_ = _e90;
                }
                let _e93 = phi_189_;
                local_1.member[_e80.member_1] = _e93;
                let _e98 = local_1.member_1[_e80.member_1];
                let _e101 = local_2.member_1[_e80.member_1];
                if (_e98 > _e101) {
                    phi_216_ = _e98;
                } else {
                    phi_216_ = _e101;
                }
                let _e104 = phi_216_;
                local_1.member_1[_e80.member_1] = _e104;
            }
            continue;
            continuing {
                phi_139_ = _e78;
                break if !(_e84);
            }
        }
        let _e108 = local_1;
        let _e110 = boxes.member[_e35[2]];
        local_3 = type_4(array<f32, 3>(_e110.member[0], _e110.member[1], _e110.member[2]), array<f32, 3>(_e110.member_1[0], _e110.member_1[1], _e110.member_1[2]));
        local = _e108;
        phi_270_ = type_17(0u, 3u);
        loop {
            let _e123 = phi_270_;
            if (_e123.member < _e123.member_1) {
                phi_271_ = type_17((_e123.member + 1u), _e123.member_1);
                phi_294_ = type_17(1u, _e123.member);
            } else {
                phi_271_ = _e123;
                phi_294_ = type_17(0u, type_17().member_1);
            }
            let _e135 = phi_271_;
            let _e137 = phi_294_;
            let _e141 = (bitcast<i32>(_e137.member) != 0i);
            if _e141 {
                let _e144 = local.member[_e137.member_1];
                let _e147 = local_3.member[_e137.member_1];
                if (_e144 < _e147) {
                    phi_320_ = _e144;
                } else {
                    phi_320_ = _e147;
                }
                let _e150 = phi_320_;
                local.member[_e137.member_1] = _e150;
                let _e155 = local.member_1[_e137.member_1];
                let _e158 = local_3.member_1[_e137.member_1];
                if (_e155 > _e158) {
                    phi_347_ = _e155;
                } else {
                    phi_347_ = _e158;
                }
                let _e161 = phi_347_;
                local.member_1[_e137.member_1] = _e161;
            }
            continue;
            continuing {
                phi_270_ = _e135;
                break if !(_e141);
            }
        }
        let _e165 = local;
        let _e179 = params.member.member_2[2u];
        boxes.member[(_e179 + _e29)] = type_4(array<f32, 3>(_e165.member[0], _e165.member[1], _e165.member[2]), array<f32, 3>(_e165.member_1[0], _e165.member_1[1], _e165.member_1[2]));
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn sweep_faces(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}

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
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_13 {
    member: array<type_11>,
}

struct type_15 {
    member: array<u32>,
}

struct type_17 {
    member: array<array<u32, 2>>,
}

struct type_19 {
    member: array<array<u32, 3>>,
}

struct type_20 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_22 {
    member: array<type_20>,
}

struct type_26 {
    member: i32,
    member_1: i32,
}

struct type_27 {
    member: u32,
    member_1: i32,
}

@group(0) @binding(0) 
var<storage> params: type_9;
@group(0) @binding(1) 
var<storage> boxes: type_13;
@group(0) @binding(2) 
var<storage> order: type_15;
@group(0) @binding(3) 
var<storage> edges: type_17;
@group(0) @binding(4) 
var<storage> faces: type_19;
@group(0) @binding(5) 
var<storage, read_write> nodes: type_13;
@group(0) @binding(6) 
var<storage, read_write> leaves: type_22;
var<workgroup> shared_: array<type_11, 256>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_129_: u32;
    var phi_130_: u32;
    var phi_243_: type_20;
    var phi_244_: type_20;
    var phi_245_: type_20;
    var phi_246_: type_11;
    var phi_247_: type_20;
    var phi_248_: type_11;
    var phi_249_: type_20;
    var phi_264_: type_26;
    var phi_267_: type_11;
    var phi_269_: u32;
    var phi_290_: bool;
    var phi_296_: type_27;
    var phi_265_: type_26;
    var phi_310_: type_27;
    var phi_342_: f32;
    var phi_349_: f32;
    var phi_356_: f32;
    var phi_364_: f32;
    var phi_371_: f32;
    var phi_378_: f32;
    var phi_393_: type_11;
    var phi_268_: type_11;
    var phi_270_: u32;
    var local: type_11;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e29 = id_2;
    let _e30 = n_2;
    let _e31 = lane_2;
    let _e45 = ((((_e29.y * _e30.x) + _e29.x) * 256u) + _e31);
    let _e49 = params.member.member_20[0u][2u];
    if (_e45 >= _e49) {
        phi_130_ = 2u;
    } else {
        let _e52 = params.member.member_20[0u][1u];
        if (_e45 >= _e52) {
            phi_129_ = 1u;
        } else {
            phi_129_ = 0u;
        }
        let _e55 = phi_129_;
        phi_130_ = _e55;
    }
    let _e57 = phi_130_;
    let _e61 = params.member.member_20[0u][_e57];
    let _e62 = (_e45 - _e61);
    let _e66 = params.member.member_20[0u][3u];
    let _e67 = (_e45 < _e66);
    if _e67 {
        let _e70 = params.member.member[_e57];
        if (_e62 < _e70) {
            let _e74 = params.member.member_2[_e57];
            let _e77 = order.member[(_e74 + _e62)];
            let _e79 = boxes.member[_e77];
            let _e82 = params.member.member_2[_e57];
            let _e83 = (_e77 - _e82);
            let _e84 = type_20(array<u32, 3>(0u, 0u, 0u), _e83);
            let _e90 = type_20(array<u32, 3>(_e83, _e84.member[1], _e84.member[2]), _e84.member_1);
            let _e99 = type_20(array<u32, 3>(_e83, _e83, _e83), type_20(array<u32, 3>(_e90.member[0], _e83, _e90.member[2]), _e90.member_1).member_1);
            let _e101 = params.member.member_1;
            if ((_e101 & 1u) != 0u) {
                if (_e57 == 1u) {
                    let _e113 = edges.member[_e83];
                    let _e122 = type_20(array<u32, 3>(_e113[0], _e99.member[1], _e99.member[2]), _e99.member_1);
                    phi_244_ = type_20(array<u32, 3>(_e113[0], _e113[1], _e113[1]), type_20(array<u32, 3>(_e122.member[0], _e113[1], _e122.member[2]), _e122.member_1).member_1);
                } else {
                    if (_e57 == 2u) {
                        let _e107 = faces.member[_e83];
                        phi_243_ = type_20(_e107, _e99.member_1);
                    } else {
                        phi_243_ = _e99;
                    }
                    let _e111 = phi_243_;
                    phi_244_ = _e111;
                }
                let _e133 = phi_244_;
                phi_245_ = _e133;
            } else {
                phi_245_ = _e99;
            }
            let _e135 = phi_245_;
            phi_246_ = _e79;
            phi_247_ = _e135;
        } else {
            phi_246_ = type_11(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            phi_247_ = type_20(array<u32, 3>(0u, 0u, 0u), 4294967295u);
        }
        let _e137 = phi_246_;
        let _e139 = phi_247_;
        phi_248_ = _e137;
        phi_249_ = _e139;
    } else {
        phi_248_ = type_11(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        phi_249_ = type_20(array<u32, 3>(0u, 0u, 0u), 4294967295u);
    }
    let _e141 = phi_248_;
    let _e143 = phi_249_;
    shared_[_e31] = type_11(array<f32, 3>(_e141.member[0], _e141.member[1], _e141.member[2]), array<f32, 3>(_e141.member_1[0], _e141.member_1[1], _e141.member_1[2]));
    phi_264_ = type_26(0i, 5i);
    phi_267_ = _e141;
    phi_269_ = 16u;
    loop {
        let _e157 = phi_264_;
        let _e159 = phi_267_;
        let _e161 = phi_269_;
        local = _e159;
        if (_e157.member < _e157.member_1) {
            let _e168 = (_e157.member + 1i);
            if ((false == (_e168 > _e157.member)) != false) {
                phi_290_ = true;
            } else {
                phi_290_ = false;
            }
            let _e173 = phi_290_;
            if _e173 {
                phi_296_ = type_27(0u, type_27().member_1);
            } else {
                phi_296_ = type_27(1u, _e168);
            }
            let _e178 = phi_296_;
            phi_265_ = type_26(_e178.member_1, _e157.member_1);
            phi_310_ = type_27(1u, _e157.member);
        } else {
            phi_265_ = _e157;
            phi_310_ = type_27(0u, type_27().member_1);
        }
        let _e184 = phi_265_;
        let _e186 = phi_310_;
        let _e189 = (bitcast<i32>(_e186.member) != 0i);
        if _e189 {
            workgroupBarrier();
            if ((_e31 % 32u) < _e161) {
                let _e194 = shared_[(_e31 + _e161)];
                if (_e159.member[0] < _e194.member[0]) {
                    phi_342_ = _e159.member[0];
                } else {
                    phi_342_ = _e194.member[0];
                }
                let _e207 = phi_342_;
                if (_e159.member[1] < _e194.member[1]) {
                    phi_349_ = _e159.member[1];
                } else {
                    phi_349_ = _e194.member[1];
                }
                let _e212 = phi_349_;
                if (_e159.member[2] < _e194.member[2]) {
                    phi_356_ = _e159.member[2];
                } else {
                    phi_356_ = _e194.member[2];
                }
                let _e217 = phi_356_;
                if (_e159.member_1[0] > _e194.member_1[0]) {
                    phi_364_ = _e159.member_1[0];
                } else {
                    phi_364_ = _e194.member_1[0];
                }
                let _e223 = phi_364_;
                if (_e159.member_1[1] > _e194.member_1[1]) {
                    phi_371_ = _e159.member_1[1];
                } else {
                    phi_371_ = _e194.member_1[1];
                }
                let _e228 = phi_371_;
                if (_e159.member_1[2] > _e194.member_1[2]) {
                    phi_378_ = _e159.member_1[2];
                } else {
                    phi_378_ = _e194.member_1[2];
                }
                let _e233 = phi_378_;
                shared_[_e31] = type_11(array<f32, 3>(_e207, _e212, _e217), array<f32, 3>(_e223, _e228, _e233));
                phi_393_ = type_11(array<f32, 3>(_e207, _e212, _e217), array<f32, 3>(_e223, _e228, _e233));
            } else {
                phi_393_ = _e159;
            }
            let _e241 = phi_393_;
            phi_268_ = _e241;
            phi_270_ = (_e161 / 2u);
        } else {
            phi_268_ = type_11();
            phi_270_ = u32();
        }
        let _e244 = phi_268_;
        let _e246 = phi_270_;
        continue;
        continuing {
            phi_264_ = _e184;
            phi_267_ = _e244;
            phi_269_ = _e246;
            break if !(_e189);
        }
    }
    if _e67 {
        nodes.member[_e45] = _e141;
        leaves.member[_e45] = _e143;
        if ((_e31 % 32u) == 0u) {
            let _e256 = params.member.member_20[1u][_e57];
            let _e260 = local;
            nodes.member[(_e256 + (_e62 / 32u))] = _e260;
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn fit_leaves(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}

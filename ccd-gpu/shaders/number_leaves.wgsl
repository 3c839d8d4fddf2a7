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
    member: array<vec4<u32>>,
}

struct type_17 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_18 {
    member: type_7,
    member_1: type_8,
    member_2: type_17,
}

struct type_19 {
    member: type_18,
}

@group(0) @binding(2) 
var<storage> order: type_11;
@group(0) @binding(0) 
var<storage> params: type_19;
@group(0) @binding(1) 
var<storage> joins: type_11;
@group(0) @binding(3) 
var<storage, read_write> ordered: type_11;
@group(0) @binding(4) 
var<storage, read_write> branches: type_16;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_100_: type_9;
    var phi_103_: u32;
    var phi_105_: u32;
    var phi_101_: type_9;
    var phi_128_: type_9;
    var phi_163_: u32;
    var phi_164_: bool;
    var phi_104_: u32;
    var phi_106_: u32;
    var phi_165_: bool;
    var phi_185_: u32;
    var local: u32;
    var phi_192_: type_9;
    var phi_195_: u32;
    var phi_193_: type_9;
    var phi_218_: type_9;
    var phi_252_: bool;
    var phi_256_: u32;
    var local_1: u32;
    var phi_311_: u32;
    var phi_312_: u32;
    var phi_316_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_326_: u32;
    var phi_332_: u32;
    var local_6: u32;
    var phi_196_: u32;
    var phi_339_: bool;
    var local_7: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e20 = id_2;
    let _e21 = n_2;
    let _e22 = lane_2;
    let _e34 = ((((_e20.y * _e21.x) + _e20.x) * 256u) + _e22);
    let _e37 = params.member.member_2.member;
    let _e41 = params.member.member.member_2[_e37];
    let _e45 = params.member.member.member[_e37];
    if (_e34 < _e45) {
        let _e47 = (_e45 - 1u);
        phi_100_ = type_9(0u, _e47);
        phi_103_ = (_e47 + _e34);
        phi_105_ = 0u;
        loop {
            let _e51 = phi_100_;
            let _e53 = phi_103_;
            let _e55 = phi_105_;
            local = _e55;
            local_1 = _e55;
            local_7 = _e55;
            local_2 = _e55;
            local_3 = _e55;
            local_4 = _e55;
            local_5 = _e55;
            local_6 = _e55;
            if (_e51.member < _e51.member_1) {
                phi_101_ = type_9((_e51.member + 1u), _e51.member_1);
                phi_128_ = type_9(1u, _e51.member);
            } else {
                phi_101_ = _e51;
                phi_128_ = type_9(0u, type_9().member_1);
            }
            let _e67 = phi_101_;
            let _e69 = phi_128_;
            if (bitcast<i32>(_e69.member) != 0i) {
                let _e75 = joins.member[(_e53 * 4u)];
                if (_e75 == 4294967295u) {
                    phi_163_ = u32();
                    phi_164_ = false;
                } else {
                    let _e80 = joins.member[((_e53 * 4u) + 1u)];
                    phi_163_ = (_e55 + _e80);
                    phi_164_ = true;
                }
                let _e83 = phi_163_;
                let _e85 = phi_164_;
                phi_104_ = _e75;
                phi_106_ = _e83;
                phi_165_ = _e85;
            } else {
                phi_104_ = u32();
                phi_106_ = u32();
                phi_165_ = false;
            }
            let _e87 = phi_104_;
            let _e89 = phi_106_;
            let _e91 = phi_165_;
            continue;
            continuing {
                phi_100_ = _e67;
                phi_103_ = _e87;
                phi_105_ = _e89;
                break if !(_e91);
            }
        }
        let _e96 = params.member.member_2.member_3;
        if (_e96 == 0u) {
            phi_185_ = (_e41 + _e34);
        } else {
            let _e100 = order.member[(_e41 + _e34)];
            phi_185_ = _e100;
        }
        let _e102 = phi_185_;
        let _e104 = local;
        ordered.member[(_e41 + _e104)] = _e102;
        phi_192_ = type_9(0u, _e47);
        phi_195_ = (_e47 + _e34);
        loop {
            let _e110 = phi_192_;
            let _e112 = phi_195_;
            if (_e110.member < _e110.member_1) {
                phi_193_ = type_9((_e110.member + 1u), _e110.member_1);
                phi_218_ = type_9(1u, _e110.member);
            } else {
                phi_193_ = _e110;
                phi_218_ = type_9(0u, type_9().member_1);
            }
            let _e124 = phi_193_;
            let _e126 = phi_218_;
            if (bitcast<i32>(_e126.member) != 0i) {
                let _e130 = (_e112 * 4u);
                let _e132 = joins.member[_e130];
                if (_e132 != 4294967295u) {
                    let _e136 = joins.member[(_e130 + 1u)];
                    phi_252_ = (_e136 == 0u);
                } else {
                    phi_252_ = false;
                }
                let _e139 = phi_252_;
                if _e139 {
                    phi_256_ = _e132;
                } else {
                    phi_256_ = _e112;
                }
                let _e141 = phi_256_;
                let _e142 = (_e141 * 4u);
                let _e144 = joins.member[_e142];
                let _e148 = joins.member[(_e142 + 1u)];
                let _e152 = joins.member[(_e142 + 2u)];
                let _e155 = joins.member[(_e142 + 3u)];
                if (_e144 == 4294967295u) {
                    phi_312_ = 0u;
                } else {
                    if (_e148 == 0u) {
                        let _e157 = local_1;
                        phi_311_ = ((_e157 + _e155) - 1u);
                    } else {
                        let _e216 = local_7;
                        phi_311_ = _e216;
                    }
                    let _e161 = phi_311_;
                    phi_312_ = _e161;
                }
                let _e163 = phi_312_;
                if _e139 {
                    phi_316_ = _e163;
                } else {
                    phi_316_ = 0u;
                }
                let _e165 = phi_316_;
                let _e167 = local_2;
                let _e168 = (_e167 + _e152);
                let _e170 = local_3;
                let _e172 = (_e168 - 1u);
                let _e173 = ((_e170 + _e155) - 1u);
                let _e175 = local_4;
                if (_e175 == _e172) {
                    let _e178 = local_5;
                    phi_326_ = (_e47 + _e178);
                } else {
                    phi_326_ = _e172;
                }
                let _e181 = phi_326_;
                if (_e168 == _e173) {
                    phi_332_ = (_e47 + _e168);
                } else {
                    phi_332_ = _e168;
                }
                let _e185 = phi_332_;
                if _e139 {
                    let _e187 = local_6;
                    branches.member[_e165] = vec4<u32>(_e181, _e185, _e187, _e173);
                }
                phi_196_ = _e141;
                phi_339_ = _e139;
            } else {
                phi_196_ = u32();
                phi_339_ = false;
            }
            let _e191 = phi_196_;
            let _e193 = phi_339_;
            continue;
            continuing {
                phi_192_ = _e124;
                phi_195_ = _e191;
                break if !(_e193);
            }
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn number_leaves(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}

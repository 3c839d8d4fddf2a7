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

struct type_21 {
    member: array<array<f32, 3>, 3>,
    member_1: array<f32, 3>,
    member_2: array<f32, 3>,
    member_3: array<f32, 3>,
    member_4: array<f32, 3>,
    member_5: f32,
}

struct type_23 {
    member: vec4<f32>,
    member_1: vec4<f32>,
    member_2: vec4<f32>,
    member_3: vec4<f32>,
}

struct type_25 {
    member: array<type_23>,
}

struct type_26 {
    member: array<f32, 3>,
    member_1: array<array<f32, 3>, 3>,
    member_2: array<f32, 3>,
}

struct type_29 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_19;
@group(0) @binding(6) 
var<storage, read_write> pairs: type_29;
@group(0) @binding(3) 
var<storage> oriented: type_25;
@group(0) @binding(7) 
var<storage, read_write> front: type_11;
@group(0) @binding(4) 
var<storage, read_write> control: type_29;
@group(0) @binding(1) 
var<storage> a: type_16;
@group(0) @binding(2) 
var<storage> b: type_16;
var<workgroup> shared_: array<atomic<u32>, 22>;
@group(0) @binding(5) 
var<storage, read_write> nodes: type_29;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_21;
    var phi_238_: array<u32, 2>;
    var phi_553_: type_26;
    var phi_697_: type_26;
    var phi_2598_: bool;
    var phi_2600_: bool;
    var phi_2601_: bool;
    var phi_2602_: bool;
    var phi_2603_: bool;
    var phi_2664_: u32;
    var phi_2665_: u32;
    var phi_2666_: u32;
    var phi_2684_: array<u32, 2>;
    var phi_2685_: array<u32, 2>;
    var phi_2697_: array<u32, 2>;
    var phi_2698_: array<u32, 2>;
    var phi_2861_: type_9;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e44 = id_2;
    let _e45 = n_2;
    let _e46 = lane_2;
    let _e61 = ((((_e44.y * _e45.x) + _e44.x) * 128u) + _e46);
    let _e63 = params.member.member_2;
    let _e65 = params.member.member_1;
    if (_e61 < _e65.member) {
        let _e73 = (2u * (((1u - _e63.member_5) * _e63.member_4) + _e61));
        let _e75 = front.member[_e73];
        let _e78 = front.member[(_e73 + 1u)];
        phi_238_ = array<u32, 2>(_e75, _e78);
    } else {
        phi_238_ = array<u32, 2>(4294967295u, 4294967295u);
    }
    let _e81 = phi_238_;
    if (_e46 == 0u) {
        atomicStore((&shared_[6u]), 0u);
        atomicStore((&shared_[7u]), 0u);
        atomicStore((&shared_[8u]), 0u);
    }
    workgroupBarrier();
    if (_e81[0] != 4294967295u) {
        let _e90 = a.member[_e81[0]];
        let _e93 = b.member[_e81[1]];
        if ((((((_e90.member[0] <= _e93.member_2[0]) && (_e93.member[0] <= _e90.member_2[0])) && (_e90.member[1] <= _e93.member_2[1])) && (_e93.member[1] <= _e90.member_2[1])) && (_e90.member[2] <= _e93.member_2[2])) && (_e93.member[2] <= _e90.member_2[2])) {
            let _e123 = params.member.member_2.member;
            let _e124 = (_e123 == 0u);
            let _e130 = params.member.member.member[select(1u, 0u, _e124)];
            let _e131 = (_e130 - 1u);
            let _e135 = params.member.member.member[select(1u, 2u, _e124)];
            let _e136 = (_e135 - 1u);
            let _e139 = params.member.member_2.member;
            let _e140 = (_e139 == 0u);
            let _e146 = params.member.member.member_2[select(1u, 0u, _e140)];
            let _e150 = params.member.member.member_2[select(1u, 2u, _e140)];
            let _e153 = params.member.member_2.member;
            if select(false, (_e81[0] == _e81[1]), (_e153 == 1u)) {
                phi_2602_ = bool();
                phi_2603_ = true;
            } else {
                if select(true, select(true, false, (_e81[1] >= _e136)), (_e81[0] >= _e131)) {
                    if (_e81[0] < _e131) {
                        let _e233 = oriented.member[(_e146 + _e81[0])];
                        phi_553_ = type_26(array<f32, 3>(_e233.member.x, _e233.member.y, _e233.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e233.member.w, _e233.member_1.x, _e233.member_1.y), array<f32, 3>(_e233.member_1.z, _e233.member_1.w, _e233.member_2.x), array<f32, 3>(_e233.member_2.y, _e233.member_2.z, _e233.member_2.w)), array<f32, 3>(_e233.member_3.x, _e233.member_3.y, _e233.member_3.z));
                    } else {
                        let _e165 = a.member[_e81[0]];
                        let _e180 = ((_e165.member[0] * 0.5f) + (_e165.member_2[0] * 0.5f));
                        let _e181 = ((_e165.member[1] * 0.5f) + (_e165.member_2[1] * 0.5f));
                        let _e182 = ((_e165.member[2] * 0.5f) + (_e165.member_2[2] * 0.5f));
                        let _e185 = select(_e165.member_2[0], _e180, (_e180 < _e165.member_2[0]));
                        let _e188 = select(_e165.member_2[1], _e181, (_e181 < _e165.member_2[1]));
                        let _e191 = select(_e165.member_2[2], _e182, (_e182 < _e165.member_2[2]));
                        let _e194 = select(_e165.member[0], _e185, (_e185 > _e165.member[0]));
                        let _e197 = select(_e165.member[1], _e188, (_e188 > _e165.member[1]));
                        let _e200 = select(_e165.member[2], _e191, (_e191 > _e165.member[2]));
                        let _e203 = (_e165.member_2[0] - _e194);
                        let _e205 = (_e165.member_2[1] - _e197);
                        let _e207 = (_e165.member_2[2] - _e200);
                        let _e209 = (_e194 - _e165.member[0]);
                        let _e211 = (_e197 - _e165.member[1]);
                        let _e213 = (_e200 - _e165.member[2]);
                        let _e221 = (1f + (0.000000059604645f * 4f));
                        let _e225 = (0.000000000000000000000000000000000000011754944f * 8f);
                        phi_553_ = type_26(array<f32, 3>(_e194, _e197, _e200), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((select(_e209, _e203, (_e203 > _e209)) * _e221) + _e225), ((select(_e211, _e205, (_e205 > _e211)) * _e221) + _e225), ((select(_e213, _e207, (_e207 > _e213)) * _e221) + _e225)));
                    }
                    let _e272 = phi_553_;
                    if (_e81[1] < _e136) {
                        let _e343 = oriented.member[(_e150 + _e81[1])];
                        phi_697_ = type_26(array<f32, 3>(_e343.member.x, _e343.member.y, _e343.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e343.member.w, _e343.member_1.x, _e343.member_1.y), array<f32, 3>(_e343.member_1.z, _e343.member_1.w, _e343.member_2.x), array<f32, 3>(_e343.member_2.y, _e343.member_2.z, _e343.member_2.w)), array<f32, 3>(_e343.member_3.x, _e343.member_3.y, _e343.member_3.z));
                    } else {
                        let _e275 = b.member[_e81[1]];
                        let _e290 = ((_e275.member[0] * 0.5f) + (_e275.member_2[0] * 0.5f));
                        let _e291 = ((_e275.member[1] * 0.5f) + (_e275.member_2[1] * 0.5f));
                        let _e292 = ((_e275.member[2] * 0.5f) + (_e275.member_2[2] * 0.5f));
                        let _e295 = select(_e275.member_2[0], _e290, (_e290 < _e275.member_2[0]));
                        let _e298 = select(_e275.member_2[1], _e291, (_e291 < _e275.member_2[1]));
                        let _e301 = select(_e275.member_2[2], _e292, (_e292 < _e275.member_2[2]));
                        let _e304 = select(_e275.member[0], _e295, (_e295 > _e275.member[0]));
                        let _e307 = select(_e275.member[1], _e298, (_e298 > _e275.member[1]));
                        let _e310 = select(_e275.member[2], _e301, (_e301 > _e275.member[2]));
                        let _e313 = (_e275.member_2[0] - _e304);
                        let _e315 = (_e275.member_2[1] - _e307);
                        let _e317 = (_e275.member_2[2] - _e310);
                        let _e319 = (_e304 - _e275.member[0]);
                        let _e321 = (_e307 - _e275.member[1]);
                        let _e323 = (_e310 - _e275.member[2]);
                        let _e331 = (1f + (0.000000059604645f * 4f));
                        let _e335 = (0.000000000000000000000000000000000000011754944f * 8f);
                        phi_697_ = type_26(array<f32, 3>(_e304, _e307, _e310), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((select(_e319, _e313, (_e313 > _e319)) * _e331) + _e335), ((select(_e321, _e315, (_e315 > _e321)) * _e331) + _e335), ((select(_e323, _e317, (_e317 > _e323)) * _e331) + _e335)));
                    }
                    let _e382 = phi_697_;
                    let _e387 = (_e382.member[0] - _e272.member[0]);
                    let _e390 = (_e382.member[1] - _e272.member[1]);
                    let _e393 = (_e382.member[2] - _e272.member[2]);
                    local = type_21(array<array<f32, 3>, 3>(array<f32, 3>((((_e382.member_1[0][0] * _e272.member_1[0][0]) + (_e382.member_1[0][1] * _e272.member_1[0][1])) + (_e382.member_1[0][2] * _e272.member_1[0][2])), (((_e382.member_1[1][0] * _e272.member_1[0][0]) + (_e382.member_1[1][1] * _e272.member_1[0][1])) + (_e382.member_1[1][2] * _e272.member_1[0][2])), (((_e382.member_1[2][0] * _e272.member_1[0][0]) + (_e382.member_1[2][1] * _e272.member_1[0][1])) + (_e382.member_1[2][2] * _e272.member_1[0][2]))), array<f32, 3>((((_e382.member_1[0][0] * _e272.member_1[1][0]) + (_e382.member_1[0][1] * _e272.member_1[1][1])) + (_e382.member_1[0][2] * _e272.member_1[1][2])), (((_e382.member_1[1][0] * _e272.member_1[1][0]) + (_e382.member_1[1][1] * _e272.member_1[1][1])) + (_e382.member_1[1][2] * _e272.member_1[1][2])), (((_e382.member_1[2][0] * _e272.member_1[1][0]) + (_e382.member_1[2][1] * _e272.member_1[1][1])) + (_e382.member_1[2][2] * _e272.member_1[1][2]))), array<f32, 3>((((_e382.member_1[0][0] * _e272.member_1[2][0]) + (_e382.member_1[0][1] * _e272.member_1[2][1])) + (_e382.member_1[0][2] * _e272.member_1[2][2])), (((_e382.member_1[1][0] * _e272.member_1[2][0]) + (_e382.member_1[1][1] * _e272.member_1[2][1])) + (_e382.member_1[1][2] * _e272.member_1[2][2])), (((_e382.member_1[2][0] * _e272.member_1[2][0]) + (_e382.member_1[2][1] * _e272.member_1[2][1])) + (_e382.member_1[2][2] * _e272.member_1[2][2])))), array<f32, 3>((((_e272.member_1[0][0] * _e387) + (_e272.member_1[0][1] * _e390)) + (_e272.member_1[0][2] * _e393)), (((_e272.member_1[1][0] * _e387) + (_e272.member_1[1][1] * _e390)) + (_e272.member_1[1][2] * _e393)), (((_e272.member_1[2][0] * _e387) + (_e272.member_1[2][1] * _e390)) + (_e272.member_1[2][2] * _e393))), array<f32, 3>((((_e382.member_1[0][0] * _e387) + (_e382.member_1[0][1] * _e390)) + (_e382.member_1[0][2] * _e393)), (((_e382.member_1[1][0] * _e387) + (_e382.member_1[1][1] * _e390)) + (_e382.member_1[1][2] * _e393)), (((_e382.member_1[2][0] * _e387) + (_e382.member_1[2][1] * _e390)) + (_e382.member_1[2][2] * _e393))), array<f32, 3>(_e272.member_2[0], _e272.member_2[1], _e272.member_2[2]), array<f32, 3>(_e382.member_2[0], _e382.member_2[1], _e382.member_2[2]), ((((((select(_e387, -(_e387), (_e387 < 0f)) + select(_e390, -(_e390), (_e390 < 0f))) + select(_e393, -(_e393), (_e393 < 0f))) + (((select(_e272.member_2[0], -(_e272.member_2[0]), (_e272.member_2[0] < 0f)) + select(_e272.member_2[1], -(_e272.member_2[1]), (_e272.member_2[1] < 0f))) + select(_e272.member_2[2], -(_e272.member_2[2]), (_e272.member_2[2] < 0f))) + ((select(_e382.member_2[0], -(_e382.member_2[0]), (_e382.member_2[0] < 0f)) + select(_e382.member_2[1], -(_e382.member_2[1]), (_e382.member_2[1] < 0f))) + select(_e382.member_2[2], -(_e382.member_2[2]), (_e382.member_2[2] < 0f))))) * 2f) * (0.000000059604645f * 128f)) + (0.000000000000000000000000000000000000011754944f * 128f)));
                    let _e645 = local.member[0u][0u];
                    let _e649 = local.member[0u][1u];
                    let _e653 = local.member[0u][2u];
                    let _e657 = local.member[1u][0u];
                    let _e661 = local.member[1u][1u];
                    let _e665 = local.member[1u][2u];
                    let _e669 = local.member[2u][0u];
                    let _e673 = local.member[2u][1u];
                    let _e677 = local.member[2u][2u];
                    let _e679 = local.member_3;
                    let _e684 = local.member_4;
                    let _e690 = local.member_1[0u];
                    let _e709 = (select(_e690, -(_e690), (_e690 < 0f)) - (_e679[0] + (((select(_e645, -(_e645), (_e645 < 0f)) * _e684[0]) + (select(_e649, -(_e649), (_e649 < 0f)) * _e684[1])) + (select(_e653, -(_e653), (_e653 < 0f)) * _e684[2]))));
                    let _e712 = local.member_1[1u];
                    let _e731 = (select(_e712, -(_e712), (_e712 < 0f)) - (_e679[1] + (((select(_e657, -(_e657), (_e657 < 0f)) * _e684[0]) + (select(_e661, -(_e661), (_e661 < 0f)) * _e684[1])) + (select(_e665, -(_e665), (_e665 < 0f)) * _e684[2]))));
                    let _e734 = local.member_1[2u];
                    let _e753 = (select(_e734, -(_e734), (_e734 < 0f)) - (_e679[2] + (((select(_e669, -(_e669), (_e669 < 0f)) * _e684[0]) + (select(_e673, -(_e673), (_e673 < 0f)) * _e684[1])) + (select(_e677, -(_e677), (_e677 < 0f)) * _e684[2]))));
                    let _e756 = local.member_2[0u];
                    let _e775 = (select(_e756, -(_e756), (_e756 < 0f)) - (_e684[0] + (((select(_e645, -(_e645), (_e645 < 0f)) * _e679[0]) + (select(_e657, -(_e657), (_e657 < 0f)) * _e679[1])) + (select(_e669, -(_e669), (_e669 < 0f)) * _e679[2]))));
                    let _e778 = local.member_2[1u];
                    let _e797 = (select(_e778, -(_e778), (_e778 < 0f)) - (_e684[1] + (((select(_e649, -(_e649), (_e649 < 0f)) * _e679[0]) + (select(_e661, -(_e661), (_e661 < 0f)) * _e679[1])) + (select(_e673, -(_e673), (_e673 < 0f)) * _e679[2]))));
                    let _e800 = local.member_2[2u];
                    let _e819 = (select(_e800, -(_e800), (_e800 < 0f)) - (_e684[2] + (((select(_e653, -(_e653), (_e653 < 0f)) * _e679[0]) + (select(_e665, -(_e665), (_e665 < 0f)) * _e679[1])) + (select(_e677, -(_e677), (_e677 < 0f)) * _e679[2]))));
                    let _e821 = select(_e731, _e709, (_e709 > _e731));
                    let _e823 = select(_e753, _e821, (_e821 > _e753));
                    let _e825 = select(_e797, _e775, (_e775 > _e797));
                    let _e827 = select(_e819, _e825, (_e825 > _e819));
                    let _e831 = local.member_5;
                    if (select(_e827, _e823, (_e823 > _e827)) > _e831) {
                        phi_2598_ = true;
                    } else {
                        let _e836 = local.member[1u][0u];
                        let _e839 = local.member_1[2u];
                        let _e844 = local.member[2u][0u];
                        let _e847 = local.member_1[1u];
                        let _e849 = ((_e836 * _e839) - (_e844 * _e847));
                        let _e853 = local.member[2u][0u];
                        let _e859 = local.member_3[1u];
                        let _e864 = local.member[1u][0u];
                        let _e870 = local.member_3[2u];
                        let _e876 = local.member[0u][2u];
                        let _e882 = local.member_4[1u];
                        let _e887 = local.member[0u][1u];
                        let _e893 = local.member_4[2u];
                        let _e900 = (select(_e849, -(_e849), (_e849 < 0f)) - (((select(_e853, -(_e853), (_e853 < 0f)) * _e859) + (select(_e864, -(_e864), (_e864 < 0f)) * _e870)) + ((select(_e876, -(_e876), (_e876 < 0f)) * _e882) + (select(_e887, -(_e887), (_e887 < 0f)) * _e893))));
                        let _e904 = local.member[1u][1u];
                        let _e907 = local.member_1[2u];
                        let _e912 = local.member[2u][1u];
                        let _e915 = local.member_1[1u];
                        let _e917 = ((_e904 * _e907) - (_e912 * _e915));
                        let _e921 = local.member[2u][1u];
                        let _e927 = local.member_3[1u];
                        let _e932 = local.member[1u][1u];
                        let _e938 = local.member_3[2u];
                        let _e944 = local.member[0u][0u];
                        let _e950 = local.member_4[2u];
                        let _e955 = local.member[0u][2u];
                        let _e961 = local.member_4[0u];
                        let _e968 = (select(_e917, -(_e917), (_e917 < 0f)) - (((select(_e921, -(_e921), (_e921 < 0f)) * _e927) + (select(_e932, -(_e932), (_e932 < 0f)) * _e938)) + ((select(_e944, -(_e944), (_e944 < 0f)) * _e950) + (select(_e955, -(_e955), (_e955 < 0f)) * _e961))));
                        let _e972 = local.member[1u][2u];
                        let _e975 = local.member_1[2u];
                        let _e980 = local.member[2u][2u];
                        let _e983 = local.member_1[1u];
                        let _e985 = ((_e972 * _e975) - (_e980 * _e983));
                        let _e989 = local.member[2u][2u];
                        let _e995 = local.member_3[1u];
                        let _e1000 = local.member[1u][2u];
                        let _e1006 = local.member_3[2u];
                        let _e1012 = local.member[0u][1u];
                        let _e1018 = local.member_4[0u];
                        let _e1023 = local.member[0u][0u];
                        let _e1029 = local.member_4[1u];
                        let _e1036 = (select(_e985, -(_e985), (_e985 < 0f)) - (((select(_e989, -(_e989), (_e989 < 0f)) * _e995) + (select(_e1000, -(_e1000), (_e1000 < 0f)) * _e1006)) + ((select(_e1012, -(_e1012), (_e1012 < 0f)) * _e1018) + (select(_e1023, -(_e1023), (_e1023 < 0f)) * _e1029))));
                        let _e1040 = local.member[2u][0u];
                        let _e1043 = local.member_1[0u];
                        let _e1048 = local.member[0u][0u];
                        let _e1051 = local.member_1[2u];
                        let _e1053 = ((_e1040 * _e1043) - (_e1048 * _e1051));
                        let _e1057 = local.member[0u][0u];
                        let _e1063 = local.member_3[2u];
                        let _e1068 = local.member[2u][0u];
                        let _e1074 = local.member_3[0u];
                        let _e1080 = local.member[1u][2u];
                        let _e1086 = local.member_4[1u];
                        let _e1091 = local.member[1u][1u];
                        let _e1097 = local.member_4[2u];
                        let _e1104 = (select(_e1053, -(_e1053), (_e1053 < 0f)) - (((select(_e1057, -(_e1057), (_e1057 < 0f)) * _e1063) + (select(_e1068, -(_e1068), (_e1068 < 0f)) * _e1074)) + ((select(_e1080, -(_e1080), (_e1080 < 0f)) * _e1086) + (select(_e1091, -(_e1091), (_e1091 < 0f)) * _e1097))));
                        let _e1108 = local.member[2u][1u];
                        let _e1111 = local.member_1[0u];
                        let _e1116 = local.member[0u][1u];
                        let _e1119 = local.member_1[2u];
                        let _e1121 = ((_e1108 * _e1111) - (_e1116 * _e1119));
                        let _e1125 = local.member[0u][1u];
                        let _e1131 = local.member_3[2u];
                        let _e1136 = local.member[2u][1u];
                        let _e1142 = local.member_3[0u];
                        let _e1148 = local.member[1u][0u];
                        let _e1154 = local.member_4[2u];
                        let _e1159 = local.member[1u][2u];
                        let _e1165 = local.member_4[0u];
                        let _e1172 = (select(_e1121, -(_e1121), (_e1121 < 0f)) - (((select(_e1125, -(_e1125), (_e1125 < 0f)) * _e1131) + (select(_e1136, -(_e1136), (_e1136 < 0f)) * _e1142)) + ((select(_e1148, -(_e1148), (_e1148 < 0f)) * _e1154) + (select(_e1159, -(_e1159), (_e1159 < 0f)) * _e1165))));
                        let _e1176 = local.member[2u][2u];
                        let _e1179 = local.member_1[0u];
                        let _e1184 = local.member[0u][2u];
                        let _e1187 = local.member_1[2u];
                        let _e1189 = ((_e1176 * _e1179) - (_e1184 * _e1187));
                        let _e1193 = local.member[0u][2u];
                        let _e1199 = local.member_3[2u];
                        let _e1204 = local.member[2u][2u];
                        let _e1210 = local.member_3[0u];
                        let _e1216 = local.member[1u][1u];
                        let _e1222 = local.member_4[0u];
                        let _e1227 = local.member[1u][0u];
                        let _e1233 = local.member_4[1u];
                        let _e1240 = (select(_e1189, -(_e1189), (_e1189 < 0f)) - (((select(_e1193, -(_e1193), (_e1193 < 0f)) * _e1199) + (select(_e1204, -(_e1204), (_e1204 < 0f)) * _e1210)) + ((select(_e1216, -(_e1216), (_e1216 < 0f)) * _e1222) + (select(_e1227, -(_e1227), (_e1227 < 0f)) * _e1233))));
                        let _e1244 = local.member[0u][0u];
                        let _e1247 = local.member_1[1u];
                        let _e1252 = local.member[1u][0u];
                        let _e1255 = local.member_1[0u];
                        let _e1257 = ((_e1244 * _e1247) - (_e1252 * _e1255));
                        let _e1261 = local.member[1u][0u];
                        let _e1267 = local.member_3[0u];
                        let _e1272 = local.member[0u][0u];
                        let _e1278 = local.member_3[1u];
                        let _e1284 = local.member[2u][2u];
                        let _e1290 = local.member_4[1u];
                        let _e1295 = local.member[2u][1u];
                        let _e1301 = local.member_4[2u];
                        let _e1308 = (select(_e1257, -(_e1257), (_e1257 < 0f)) - (((select(_e1261, -(_e1261), (_e1261 < 0f)) * _e1267) + (select(_e1272, -(_e1272), (_e1272 < 0f)) * _e1278)) + ((select(_e1284, -(_e1284), (_e1284 < 0f)) * _e1290) + (select(_e1295, -(_e1295), (_e1295 < 0f)) * _e1301))));
                        let _e1312 = local.member[0u][1u];
                        let _e1315 = local.member_1[1u];
                        let _e1320 = local.member[1u][1u];
                        let _e1323 = local.member_1[0u];
                        let _e1325 = ((_e1312 * _e1315) - (_e1320 * _e1323));
                        let _e1329 = local.member[1u][1u];
                        let _e1335 = local.member_3[0u];
                        let _e1340 = local.member[0u][1u];
                        let _e1346 = local.member_3[1u];
                        let _e1352 = local.member[2u][0u];
                        let _e1358 = local.member_4[2u];
                        let _e1363 = local.member[2u][2u];
                        let _e1369 = local.member_4[0u];
                        let _e1376 = (select(_e1325, -(_e1325), (_e1325 < 0f)) - (((select(_e1329, -(_e1329), (_e1329 < 0f)) * _e1335) + (select(_e1340, -(_e1340), (_e1340 < 0f)) * _e1346)) + ((select(_e1352, -(_e1352), (_e1352 < 0f)) * _e1358) + (select(_e1363, -(_e1363), (_e1363 < 0f)) * _e1369))));
                        let _e1380 = local.member[0u][2u];
                        let _e1383 = local.member_1[1u];
                        let _e1388 = local.member[1u][2u];
                        let _e1391 = local.member_1[0u];
                        let _e1393 = ((_e1380 * _e1383) - (_e1388 * _e1391));
                        let _e1397 = local.member[1u][2u];
                        let _e1403 = local.member_3[0u];
                        let _e1408 = local.member[0u][2u];
                        let _e1414 = local.member_3[1u];
                        let _e1420 = local.member[2u][1u];
                        let _e1426 = local.member_4[0u];
                        let _e1431 = local.member[2u][0u];
                        let _e1437 = local.member_4[1u];
                        let _e1444 = (select(_e1393, -(_e1393), (_e1393 < 0f)) - (((select(_e1397, -(_e1397), (_e1397 < 0f)) * _e1403) + (select(_e1408, -(_e1408), (_e1408 < 0f)) * _e1414)) + ((select(_e1420, -(_e1420), (_e1420 < 0f)) * _e1426) + (select(_e1431, -(_e1431), (_e1431 < 0f)) * _e1437))));
                        let _e1446 = select(_e968, _e900, (_e900 > _e968));
                        let _e1448 = select(_e1036, _e1446, (_e1446 > _e1036));
                        let _e1450 = select(_e1172, _e1104, (_e1104 > _e1172));
                        let _e1452 = select(_e1240, _e1450, (_e1450 > _e1240));
                        let _e1454 = select(_e1452, _e1448, (_e1448 > _e1452));
                        let _e1456 = select(_e1376, _e1308, (_e1308 > _e1376));
                        let _e1458 = select(_e1444, _e1456, (_e1456 > _e1444));
                        let _e1462 = local.member_5;
                        phi_2598_ = (select(_e1458, _e1454, (_e1454 > _e1458)) > _e1462);
                    }
                    let _e1465 = phi_2598_;
                    phi_2600_ = !(_e1465);
                    phi_2601_ = false;
                } else {
                    phi_2600_ = bool();
                    phi_2601_ = true;
                }
                let _e1468 = phi_2600_;
                let _e1470 = phi_2601_;
                phi_2602_ = _e1468;
                phi_2603_ = _e1470;
            }
            let _e1472 = phi_2602_;
            let _e1474 = phi_2603_;
            if select(_e1472, true, _e1474) {
                let _e1478 = params.member.member_2.member;
                let _e1479 = (_e1478 == 0u);
                let _e1485 = params.member.member.member[select(1u, 0u, _e1479)];
                let _e1490 = params.member.member.member[select(1u, 2u, _e1479)];
                phi_2664_ = select(select(2u, 1u, select(true, select(true, false, (_e81[1] >= (_e1490 - 1u))), (_e81[0] >= (_e1485 - 1u)))), 0u, (_e81[0] == 4294967295u));
            } else {
                phi_2664_ = 3u;
            }
            let _e1503 = phi_2664_;
            phi_2665_ = _e1503;
        } else {
            phi_2665_ = 3u;
        }
        let _e1505 = phi_2665_;
        phi_2666_ = _e1505;
    } else {
        phi_2666_ = 0u;
    }
    let _e1507 = phi_2666_;
    if (_e1507 == 1u) {
        let _e1517 = atomicAdd((&shared_[6u]), 1u);
        phi_2685_ = array<u32, 2>(_e1517, 0u);
    } else {
        if (_e1507 == 2u) {
            let _e1512 = atomicAdd((&shared_[7u]), 1u);
            phi_2684_ = array<u32, 2>(_e1512, 0u);
        } else {
            phi_2684_ = array<u32, 2>(0u, 0u);
        }
        let _e1515 = phi_2684_;
        phi_2685_ = _e1515;
    }
    let _e1520 = phi_2685_;
    if (_e1507 >= 2u) {
        if (_e63.member_4 > 0u) {
            let _e1524 = atomicAdd((&shared_[8u]), 1u);
            phi_2697_ = array<u32, 2>(_e1520[0], _e1524);
        } else {
            phi_2697_ = _e1520;
        }
        let _e1528 = phi_2697_;
        phi_2698_ = _e1528;
    } else {
        phi_2698_ = _e1520;
    }
    let _e1530 = phi_2698_;
    workgroupBarrier();
    if (_e46 == 0u) {
        let _e1533 = atomicLoad((&shared_[6u]));
        let _e1535 = atomicLoad((&shared_[7u]));
        if (_e1533 > 0u) {
            let _e1538 = atomicAdd((&control.member[0u]), _e1533);
            let _e1541 = atomicMax((&nodes.member[0u]), (_e1538 + _e1533));
            if ((_e1538 + _e1533) < _e1538) {
                let _e1545 = atomicAdd((&nodes.member[2u]), 1u);
            }
            atomicStore((&shared_[11u]), _e1538);
        }
        if (_e1535 > 0u) {
            let _e1549 = atomicAdd((&pairs.member[0u]), _e1535);
            if ((_e1549 + _e1535) < _e1549) {
                let _e1553 = atomicAdd((&pairs.member[2u]), 1u);
            }
            atomicStore((&shared_[12u]), _e1549);
        }
        let _e1556 = atomicLoad((&shared_[8u]));
        if (_e1556 > 0u) {
            let _e1559 = atomicLoad((&shared_[8u]));
            let _e1561 = atomicAdd((&control.member[1537u]), _e1559);
            if ((_e1561 + _e1559) < _e1561) {
                let _e1565 = atomicAdd((&control.member[1538u]), 1u);
            }
            atomicStore((&shared_[13u]), _e1561);
        }
    }
    workgroupBarrier();
    if (_e1507 == 1u) {
        let _e1623 = atomicLoad((&shared_[11u]));
        let _e1625 = (_e1623 + _e1530[0]);
        if (_e1625 < _e63.member_3) {
            if (_e1625 < 4294967295u) {
                let _e1631 = (2u * _e1625);
                atomicStore((&nodes.member[(4u + _e1631)]), _e81[0]);
                atomicStore((&nodes.member[(_e1631 + 5u)]), _e81[1]);
            }
        }
    } else {
        if (_e1507 == 0u) {
        } else {
            if (_e1507 == 2u) {
                let _e1572 = a.member[_e81[0]];
                let _e1576 = b.member[_e81[1]];
                let _e1580 = params.member.member_2.member;
                if (_e1580 == 1u) {
                    let _e1583 = (_e1572.member_1 < _e1576.member_1);
                    phi_2861_ = type_9(select(_e1576.member_1, _e1572.member_1, _e1583), select(_e1572.member_1, _e1576.member_1, _e1583));
                } else {
                    phi_2861_ = type_9(_e1572.member_1, _e1576.member_1);
                }
                let _e1588 = phi_2861_;
                let _e1592 = params.member.member_1;
                let _e1595 = atomicLoad((&shared_[12u]));
                let _e1597 = (_e1595 + _e1530[0]);
                if (_e1597 < _e1592.member_3) {
                    let _e1599 = (2u * _e1597);
                    atomicStore((&pairs.member[(4u + _e1599)]), _e1588.member);
                    atomicStore((&pairs.member[(_e1599 + 5u)]), _e1588.member_1);
                }
            }
            if (_e63.member_4 > 0u) {
                let _e1607 = atomicLoad((&shared_[13u]));
                let _e1609 = (_e1607 + _e1530[1]);
                if (_e1609 < _e63.member_4) {
                    let _e1616 = (2u * ((_e63.member_5 * _e63.member_4) + _e1609));
                    front.member[_e1616] = _e81[0];
                    front.member[(_e1616 + 1u)] = _e81[1];
                }
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn resume_front_oriented(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}

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
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
}

struct type_17 {
    member: array<type_15>,
}

struct type_19 {
    member: array<u32, 64>,
    member_1: array<u32, 64>,
    member_2: u32,
}

struct type_20 {
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

struct type_21 {
    member: type_7,
    member_1: type_8,
    member_2: type_20,
}

struct type_22 {
    member: type_21,
}

struct type_24 {
    member: array<array<u32, 2>, 4>,
    member_1: array<array<u32, 2>, 4>,
}

struct type_26 {
    member: array<array<f32, 3>, 3>,
    member_1: array<f32, 3>,
    member_2: array<f32, 3>,
    member_3: array<f32, 3>,
    member_4: array<f32, 3>,
    member_5: f32,
}

struct type_28 {
    member: vec4<f32>,
    member_1: vec4<f32>,
    member_2: vec4<f32>,
    member_3: vec4<f32>,
}

struct type_30 {
    member: array<type_28>,
}

struct type_31 {
    member: array<f32, 3>,
    member_1: array<array<f32, 3>, 3>,
    member_2: array<f32, 3>,
}

struct type_34 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_22;
@group(0) @binding(1) 
var<storage> a_nodes: type_17;
@group(0) @binding(2) 
var<storage> b_nodes: type_17;
@group(0) @binding(3) 
var<storage> oriented: type_30;
@group(0) @binding(4) 
var<storage> input: type_11;
@group(0) @binding(5) 
var<storage, read_write> rounds: type_34;
@group(0) @binding(6) 
var<storage, read_write> output: type_34;
@group(0) @binding(7) 
var<storage, read_write> pairs: type_34;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_26;
    var local_1: array<array<u32, 2>, 4>;
    var local_2: type_26;
    var local_3: type_19;
    var phi_246_: u32;
    var phi_283_: bool;
    var phi_312_: array<u32, 2>;
    var phi_313_: array<u32, 2>;
    var phi_314_: array<u32, 2>;
    var phi_363_: bool;
    var phi_364_: bool;
    var phi_365_: bool;
    var phi_366_: bool;
    var phi_370_: bool;
    var phi_448_: array<u32, 2>;
    var phi_479_: array<u32, 2>;
    var phi_511_: bool;
    var phi_523_: bool;
    var phi_524_: bool;
    var phi_597_: f32;
    var phi_603_: f32;
    var phi_609_: f32;
    var phi_615_: f32;
    var phi_621_: f32;
    var phi_627_: f32;
    var phi_645_: f32;
    var phi_650_: f32;
    var phi_655_: f32;
    var phi_671_: type_31;
    var phi_741_: f32;
    var phi_747_: f32;
    var phi_753_: f32;
    var phi_759_: f32;
    var phi_765_: f32;
    var phi_771_: f32;
    var phi_789_: f32;
    var phi_794_: f32;
    var phi_799_: f32;
    var phi_815_: type_31;
    var phi_1005_: f32;
    var phi_1011_: f32;
    var phi_1018_: f32;
    var phi_1027_: f32;
    var phi_1034_: f32;
    var phi_1042_: f32;
    var phi_1051_: f32;
    var phi_1058_: f32;
    var phi_1066_: f32;
    var phi_1159_: f32;
    var phi_1166_: f32;
    var phi_1172_: f32;
    var phi_1178_: f32;
    var phi_1197_: f32;
    var phi_1204_: f32;
    var phi_1210_: f32;
    var phi_1216_: f32;
    var phi_1235_: f32;
    var phi_1242_: f32;
    var phi_1248_: f32;
    var phi_1254_: f32;
    var phi_1273_: f32;
    var phi_1280_: f32;
    var phi_1286_: f32;
    var phi_1292_: f32;
    var phi_1311_: f32;
    var phi_1318_: f32;
    var phi_1324_: f32;
    var phi_1330_: f32;
    var phi_1349_: f32;
    var phi_1356_: f32;
    var phi_1362_: f32;
    var phi_1368_: f32;
    var phi_1383_: f32;
    var phi_1388_: f32;
    var phi_1393_: f32;
    var phi_1398_: f32;
    var phi_1403_: f32;
    var phi_1462_: f32;
    var phi_1485_: f32;
    var phi_1508_: f32;
    var phi_1530_: f32;
    var phi_1546_: f32;
    var phi_1601_: f32;
    var phi_1624_: f32;
    var phi_1647_: f32;
    var phi_1669_: f32;
    var phi_1685_: f32;
    var phi_1740_: f32;
    var phi_1763_: f32;
    var phi_1786_: f32;
    var phi_1808_: f32;
    var phi_1824_: f32;
    var phi_1879_: f32;
    var phi_1902_: f32;
    var phi_1926_: f32;
    var phi_1949_: f32;
    var phi_1965_: f32;
    var phi_2020_: f32;
    var phi_2043_: f32;
    var phi_2067_: f32;
    var phi_2090_: f32;
    var phi_2106_: f32;
    var phi_2161_: f32;
    var phi_2184_: f32;
    var phi_2208_: f32;
    var phi_2231_: f32;
    var phi_2247_: f32;
    var phi_2302_: f32;
    var phi_2325_: f32;
    var phi_2349_: f32;
    var phi_2372_: f32;
    var phi_2388_: f32;
    var phi_2443_: f32;
    var phi_2466_: f32;
    var phi_2490_: f32;
    var phi_2513_: f32;
    var phi_2529_: f32;
    var phi_2584_: f32;
    var phi_2607_: f32;
    var phi_2631_: f32;
    var phi_2654_: f32;
    var phi_2670_: f32;
    var phi_2677_: f32;
    var phi_2682_: f32;
    var phi_2687_: f32;
    var phi_2692_: f32;
    var phi_2697_: f32;
    var phi_2702_: f32;
    var phi_2707_: f32;
    var phi_2712_: f32;
    var phi_2716_: bool;
    var phi_2718_: bool;
    var phi_2719_: bool;
    var phi_2720_: bool;
    var phi_2721_: bool;
    var phi_2725_: bool;
    var phi_2726_: bool;
    var phi_2730_: array<u32, 2>;
    var phi_2731_: array<u32, 2>;
    var phi_2732_: array<u32, 2>;
    var phi_2733_: array<u32, 2>;
    var phi_184_: u32;
    var phi_213_: array<u32, 2>;
    var phi_2734_: array<u32, 2>;
    var phi_2880_: array<u32, 2>;
    var phi_2916_: bool;
    var phi_2917_: bool;
    var phi_2921_: u32;
    var phi_2922_: u32;
    var phi_3018_: u32;
    var phi_2973_: type_9;
    var phi_2978_: type_9;
    var phi_3091_: type_9;
    var phi_3092_: type_9;
    var phi_3115_: type_9;
    var phi_3150_: array<u32, 2>;
    var phi_3164_: u32;
    var phi_3238_: array<u32, 2>;
    var phi_3252_: array<u32, 2>;
    var phi_3289_: array<u32, 2>;
    var phi_3291_: type_24;
    var phi_3292_: type_24;
    var phi_3293_: bool;
    var phi_3294_: type_24;
    var phi_3295_: bool;
    var phi_3311_: bool;
    var phi_3355_: bool;
    var phi_3356_: bool;
    var phi_3357_: bool;
    var phi_3358_: bool;
    var phi_3359_: bool;
    var phi_3360_: bool;
    var phi_3466_: array<u32, 2>;
    var phi_3495_: array<u32, 2>;
    var phi_3524_: array<u32, 2>;
    var phi_3553_: array<u32, 2>;
    var phi_3555_: type_24;
    var phi_3556_: bool;
    var phi_3557_: type_24;
    var phi_3558_: bool;
    var phi_3731_: array<u32, 2>;
    var phi_3763_: array<u32, 2>;
    var phi_3631_: array<u32, 2>;
    var phi_3663_: array<u32, 2>;
    var phi_3765_: type_24;
    var phi_3766_: type_24;
    var phi_3767_: type_24;
    var phi_3768_: bool;
    var phi_3769_: type_24;
    var phi_3770_: type_24;
    var phi_3771_: bool;
    var phi_3775_: type_24;
    var phi_3793_: array<u32, 2>;
    var phi_3824_: array<u32, 2>;
    var phi_3869_: type_9;
    var phi_3870_: type_9;
    var phi_3893_: type_9;
    var phi_3922_: bool;
    var phi_3934_: bool;
    var phi_3935_: bool;
    var phi_4008_: f32;
    var phi_4014_: f32;
    var phi_4020_: f32;
    var phi_4026_: f32;
    var phi_4032_: f32;
    var phi_4038_: f32;
    var phi_4056_: f32;
    var phi_4061_: f32;
    var phi_4066_: f32;
    var phi_4082_: type_31;
    var phi_4152_: f32;
    var phi_4158_: f32;
    var phi_4164_: f32;
    var phi_4170_: f32;
    var phi_4176_: f32;
    var phi_4182_: f32;
    var phi_4200_: f32;
    var phi_4205_: f32;
    var phi_4210_: f32;
    var phi_4226_: type_31;
    var phi_4416_: f32;
    var phi_4422_: f32;
    var phi_4429_: f32;
    var phi_4438_: f32;
    var phi_4445_: f32;
    var phi_4453_: f32;
    var phi_4462_: f32;
    var phi_4469_: f32;
    var phi_4477_: f32;
    var phi_4570_: f32;
    var phi_4577_: f32;
    var phi_4583_: f32;
    var phi_4589_: f32;
    var phi_4608_: f32;
    var phi_4615_: f32;
    var phi_4621_: f32;
    var phi_4627_: f32;
    var phi_4646_: f32;
    var phi_4653_: f32;
    var phi_4659_: f32;
    var phi_4665_: f32;
    var phi_4684_: f32;
    var phi_4691_: f32;
    var phi_4697_: f32;
    var phi_4703_: f32;
    var phi_4722_: f32;
    var phi_4729_: f32;
    var phi_4735_: f32;
    var phi_4741_: f32;
    var phi_4760_: f32;
    var phi_4767_: f32;
    var phi_4773_: f32;
    var phi_4779_: f32;
    var phi_4794_: f32;
    var phi_4799_: f32;
    var phi_4804_: f32;
    var phi_4809_: f32;
    var phi_4814_: f32;
    var phi_4873_: f32;
    var phi_4896_: f32;
    var phi_4919_: f32;
    var phi_4941_: f32;
    var phi_4957_: f32;
    var phi_5012_: f32;
    var phi_5035_: f32;
    var phi_5058_: f32;
    var phi_5080_: f32;
    var phi_5096_: f32;
    var phi_5151_: f32;
    var phi_5174_: f32;
    var phi_5197_: f32;
    var phi_5219_: f32;
    var phi_5235_: f32;
    var phi_5290_: f32;
    var phi_5313_: f32;
    var phi_5337_: f32;
    var phi_5360_: f32;
    var phi_5376_: f32;
    var phi_5431_: f32;
    var phi_5454_: f32;
    var phi_5478_: f32;
    var phi_5501_: f32;
    var phi_5517_: f32;
    var phi_5572_: f32;
    var phi_5595_: f32;
    var phi_5619_: f32;
    var phi_5642_: f32;
    var phi_5658_: f32;
    var phi_5713_: f32;
    var phi_5736_: f32;
    var phi_5760_: f32;
    var phi_5783_: f32;
    var phi_5799_: f32;
    var phi_5854_: f32;
    var phi_5877_: f32;
    var phi_5901_: f32;
    var phi_5924_: f32;
    var phi_5940_: f32;
    var phi_5995_: f32;
    var phi_6018_: f32;
    var phi_6042_: f32;
    var phi_6065_: f32;
    var phi_6081_: f32;
    var phi_6088_: f32;
    var phi_6093_: f32;
    var phi_6098_: f32;
    var phi_6103_: f32;
    var phi_6108_: f32;
    var phi_6113_: f32;
    var phi_6118_: f32;
    var phi_6123_: f32;
    var phi_6127_: bool;
    var phi_6129_: bool;
    var phi_6130_: bool;
    var phi_6131_: bool;
    var phi_6132_: bool;
    var phi_6136_: bool;
    var phi_6175_: array<u32, 2>;
    var phi_6211_: bool;
    var phi_6212_: bool;
    var phi_6216_: u32;
    var phi_6217_: u32;
    var phi_6313_: u32;
    var phi_6268_: type_9;
    var phi_6273_: type_9;
    var phi_6392_: array<u32, 2>;
    var phi_6428_: bool;
    var phi_6429_: bool;
    var phi_6433_: u32;
    var phi_6434_: u32;
    var phi_6530_: u32;
    var phi_6485_: type_9;
    var phi_6490_: type_9;
    var phi_6609_: array<u32, 2>;
    var phi_6645_: bool;
    var phi_6646_: bool;
    var phi_6650_: u32;
    var phi_6651_: u32;
    var phi_6747_: u32;
    var phi_6702_: type_9;
    var phi_6707_: type_9;
    var phi_6826_: array<u32, 2>;
    var phi_6862_: bool;
    var phi_6863_: bool;
    var phi_6867_: u32;
    var phi_6868_: u32;
    var phi_6964_: u32;
    var phi_6919_: type_9;
    var phi_6924_: type_9;
    var phi_7032_: bool;
    var phi_7033_: bool;
    var phi_7036_: type_9;
    var phi_7037_: type_9;
    var phi_7060_: type_9;
    var phi_7095_: array<u32, 2>;
    var phi_7138_: bool;
    var phi_7139_: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e48 = id_2;
    let _e49 = n_2;
    let _e50 = lane_2;
    let _e65 = ((((_e48.y * _e49.x) + _e48.x) * 128u) + _e50);
    let _e69 = params.member.member_1.member_1;
    if (_e69 > 0u) {
        let _e1657 = params.member.member_1.member_1;
        let _e1659 = atomicLoad((&rounds.member[_e1657]));
        let _e1662 = params.member.member_1.member_2;
        if (_e1662 < _e1659) {
            phi_184_ = _e1662;
        } else {
            phi_184_ = _e1659;
        }
        let _e1665 = phi_184_;
        if (_e65 < _e1665) {
            let _e1667 = (2u * _e65);
            let _e1670 = input.member[(4u + _e1667)];
            let _e1673 = input.member[(_e1667 + 5u)];
            phi_213_ = array<u32, 2>(_e1670, _e1673);
        } else {
            phi_213_ = array<u32, 2>(4294967295u, 4294967295u);
        }
        let _e1676 = phi_213_;
        phi_2734_ = _e1676;
    } else {
        let _e73 = params.member.member_2.member_2;
        let _e76 = params.member.member_2.member_2;
        if (_e65 < (_e73 * _e76)) {
            let _e80 = params.member.member_2.member_2;
            if (_e80 == 0u) {
                return;
            }
            let _e82 = (_e65 / _e80);
            let _e84 = params.member.member_2.member_2;
            if (_e84 == 0u) {
                return;
            }
            let _e86 = (_e65 % _e84);
            let _e88 = params.member.member_2.member;
            let _e89 = (_e88 == 1u);
            if _e89 {
                phi_246_ = 0u;
            } else {
                phi_246_ = 1u;
            }
            let _e91 = phi_246_;
            let _e92 = (_e91 * 1028u);
            let _e94 = input.member[0u];
            if (_e82 < _e94) {
                let _e97 = input.member[_e92];
                if (_e86 < _e97) {
                    if _e89 {
                        phi_283_ = (_e82 <= _e86);
                    } else {
                        phi_283_ = true;
                    }
                    let _e101 = phi_283_;
                    if _e101 {
                        let _e104 = input.member[(4u + _e82)];
                        let _e108 = input.member[((_e92 + 4u) + _e86)];
                        phi_312_ = array<u32, 2>(_e104, _e108);
                    } else {
                        phi_312_ = array<u32, 2>(4294967295u, 4294967295u);
                    }
                    let _e111 = phi_312_;
                    phi_313_ = _e111;
                } else {
                    phi_313_ = array<u32, 2>(4294967295u, 4294967295u);
                }
                let _e113 = phi_313_;
                phi_314_ = _e113;
            } else {
                phi_314_ = array<u32, 2>(4294967295u, 4294967295u);
            }
            let _e115 = phi_314_;
            if (_e115[0] != 4294967295u) {
                let _e120 = params.member.member_2.member;
                if (_e120 == 1u) {
                    if (_e115[0] == _e115[1]) {
                        let _e127 = a_nodes.member[_e115[0]];
                        phi_363_ = (_e127.member_3 == 4294967295u);
                        phi_364_ = false;
                    } else {
                        phi_363_ = bool();
                        phi_364_ = true;
                    }
                    let _e131 = phi_363_;
                    let _e133 = phi_364_;
                    phi_365_ = _e131;
                    phi_366_ = _e133;
                } else {
                    phi_365_ = bool();
                    phi_366_ = true;
                }
                let _e135 = phi_365_;
                let _e137 = phi_366_;
                if _e137 {
                    phi_370_ = false;
                } else {
                    phi_370_ = _e135;
                }
                let _e139 = phi_370_;
                if _e139 {
                    phi_2731_ = array<u32, 2>(4294967295u, 4294967295u);
                } else {
                    let _e142 = a_nodes.member[_e115[0]];
                    let _e145 = b_nodes.member[_e115[1]];
                    if ((((((_e142.member[0] <= _e145.member_2[0]) && (_e145.member[0] <= _e142.member_2[0])) && (_e142.member[1] <= _e145.member_2[1])) && (_e145.member[1] <= _e142.member_2[1])) && (_e142.member[2] <= _e145.member_2[2])) && (_e145.member[2] <= _e142.member_2[2])) {
                        let _e175 = params.member.member_2.member;
                        if (_e175 == 0u) {
                            phi_448_ = array<u32, 2>(0u, 2u);
                        } else {
                            phi_448_ = array<u32, 2>(1u, 1u);
                        }
                        let _e178 = phi_448_;
                        let _e184 = params.member.member.member[_e178[0]];
                        let _e185 = (_e184 - 1u);
                        let _e189 = params.member.member.member[_e178[1]];
                        let _e190 = (_e189 - 1u);
                        let _e193 = params.member.member_2.member;
                        if (_e193 == 0u) {
                            phi_479_ = array<u32, 2>(0u, 2u);
                        } else {
                            phi_479_ = array<u32, 2>(1u, 1u);
                        }
                        let _e196 = phi_479_;
                        let _e202 = params.member.member.member_2[_e196[0]];
                        let _e206 = params.member.member.member_2[_e196[1]];
                        let _e209 = params.member.member_2.member;
                        if (_e209 == 1u) {
                            phi_511_ = (_e115[0] == _e115[1]);
                        } else {
                            phi_511_ = false;
                        }
                        let _e215 = phi_511_;
                        if _e215 {
                            phi_2720_ = bool();
                            phi_2721_ = true;
                        } else {
                            if (_e115[0] >= _e185) {
                                if (_e115[1] >= _e190) {
                                    phi_523_ = false;
                                } else {
                                    phi_523_ = true;
                                }
                                let _e219 = phi_523_;
                                phi_524_ = _e219;
                            } else {
                                phi_524_ = true;
                            }
                            let _e221 = phi_524_;
                            if _e221 {
                                if (_e115[0] < _e185) {
                                    let _e301 = oriented.member[(_e202 + _e115[0])];
                                    phi_671_ = type_31(array<f32, 3>(_e301.member.x, _e301.member.y, _e301.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e301.member.w, _e301.member_1.x, _e301.member_1.y), array<f32, 3>(_e301.member_1.z, _e301.member_1.w, _e301.member_2.x), array<f32, 3>(_e301.member_2.y, _e301.member_2.z, _e301.member_2.w)), array<f32, 3>(_e301.member_3.x, _e301.member_3.y, _e301.member_3.z));
                                } else {
                                    let _e224 = a_nodes.member[_e115[0]];
                                    let _e239 = ((_e224.member[0] * 0.5f) + (_e224.member_2[0] * 0.5f));
                                    let _e240 = ((_e224.member[1] * 0.5f) + (_e224.member_2[1] * 0.5f));
                                    let _e241 = ((_e224.member[2] * 0.5f) + (_e224.member_2[2] * 0.5f));
                                    if (_e239 < _e224.member_2[0]) {
                                        phi_597_ = _e239;
                                    } else {
                                        phi_597_ = _e224.member_2[0];
                                    }
                                    let _e245 = phi_597_;
                                    if (_e240 < _e224.member_2[1]) {
                                        phi_603_ = _e240;
                                    } else {
                                        phi_603_ = _e224.member_2[1];
                                    }
                                    let _e249 = phi_603_;
                                    if (_e241 < _e224.member_2[2]) {
                                        phi_609_ = _e241;
                                    } else {
                                        phi_609_ = _e224.member_2[2];
                                    }
                                    let _e253 = phi_609_;
                                    if (_e245 > _e224.member[0]) {
                                        phi_615_ = _e245;
                                    } else {
                                        phi_615_ = _e224.member[0];
                                    }
                                    let _e257 = phi_615_;
                                    if (_e249 > _e224.member[1]) {
                                        phi_621_ = _e249;
                                    } else {
                                        phi_621_ = _e224.member[1];
                                    }
                                    let _e261 = phi_621_;
                                    if (_e253 > _e224.member[2]) {
                                        phi_627_ = _e253;
                                    } else {
                                        phi_627_ = _e224.member[2];
                                    }
                                    let _e265 = phi_627_;
                                    let _e268 = (_e224.member_2[0] - _e257);
                                    let _e270 = (_e224.member_2[1] - _e261);
                                    let _e272 = (_e224.member_2[2] - _e265);
                                    let _e274 = (_e257 - _e224.member[0]);
                                    let _e276 = (_e261 - _e224.member[1]);
                                    let _e278 = (_e265 - _e224.member[2]);
                                    if (_e268 > _e274) {
                                        phi_645_ = _e268;
                                    } else {
                                        phi_645_ = _e274;
                                    }
                                    let _e281 = phi_645_;
                                    if (_e270 > _e276) {
                                        phi_650_ = _e270;
                                    } else {
                                        phi_650_ = _e276;
                                    }
                                    let _e284 = phi_650_;
                                    if (_e272 > _e278) {
                                        phi_655_ = _e272;
                                    } else {
                                        phi_655_ = _e278;
                                    }
                                    let _e287 = phi_655_;
                                    let _e289 = (1f + (0.000000059604645f * 4f));
                                    let _e293 = (0.000000000000000000000000000000000000011754944f * 8f);
                                    phi_671_ = type_31(array<f32, 3>(_e257, _e261, _e265), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e281 * _e289) + _e293), ((_e284 * _e289) + _e293), ((_e287 * _e289) + _e293)));
                                }
                                let _e340 = phi_671_;
                                if (_e115[1] < _e190) {
                                    let _e420 = oriented.member[(_e206 + _e115[1])];
                                    phi_815_ = type_31(array<f32, 3>(_e420.member.x, _e420.member.y, _e420.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e420.member.w, _e420.member_1.x, _e420.member_1.y), array<f32, 3>(_e420.member_1.z, _e420.member_1.w, _e420.member_2.x), array<f32, 3>(_e420.member_2.y, _e420.member_2.z, _e420.member_2.w)), array<f32, 3>(_e420.member_3.x, _e420.member_3.y, _e420.member_3.z));
                                } else {
                                    let _e343 = b_nodes.member[_e115[1]];
                                    let _e358 = ((_e343.member[0] * 0.5f) + (_e343.member_2[0] * 0.5f));
                                    let _e359 = ((_e343.member[1] * 0.5f) + (_e343.member_2[1] * 0.5f));
                                    let _e360 = ((_e343.member[2] * 0.5f) + (_e343.member_2[2] * 0.5f));
                                    if (_e358 < _e343.member_2[0]) {
                                        phi_741_ = _e358;
                                    } else {
                                        phi_741_ = _e343.member_2[0];
                                    }
                                    let _e364 = phi_741_;
                                    if (_e359 < _e343.member_2[1]) {
                                        phi_747_ = _e359;
                                    } else {
                                        phi_747_ = _e343.member_2[1];
                                    }
                                    let _e368 = phi_747_;
                                    if (_e360 < _e343.member_2[2]) {
                                        phi_753_ = _e360;
                                    } else {
                                        phi_753_ = _e343.member_2[2];
                                    }
                                    let _e372 = phi_753_;
                                    if (_e364 > _e343.member[0]) {
                                        phi_759_ = _e364;
                                    } else {
                                        phi_759_ = _e343.member[0];
                                    }
                                    let _e376 = phi_759_;
                                    if (_e368 > _e343.member[1]) {
                                        phi_765_ = _e368;
                                    } else {
                                        phi_765_ = _e343.member[1];
                                    }
                                    let _e380 = phi_765_;
                                    if (_e372 > _e343.member[2]) {
                                        phi_771_ = _e372;
                                    } else {
                                        phi_771_ = _e343.member[2];
                                    }
                                    let _e384 = phi_771_;
                                    let _e387 = (_e343.member_2[0] - _e376);
                                    let _e389 = (_e343.member_2[1] - _e380);
                                    let _e391 = (_e343.member_2[2] - _e384);
                                    let _e393 = (_e376 - _e343.member[0]);
                                    let _e395 = (_e380 - _e343.member[1]);
                                    let _e397 = (_e384 - _e343.member[2]);
                                    if (_e387 > _e393) {
                                        phi_789_ = _e387;
                                    } else {
                                        phi_789_ = _e393;
                                    }
                                    let _e400 = phi_789_;
                                    if (_e389 > _e395) {
                                        phi_794_ = _e389;
                                    } else {
                                        phi_794_ = _e395;
                                    }
                                    let _e403 = phi_794_;
                                    if (_e391 > _e397) {
                                        phi_799_ = _e391;
                                    } else {
                                        phi_799_ = _e397;
                                    }
                                    let _e406 = phi_799_;
                                    let _e408 = (1f + (0.000000059604645f * 4f));
                                    let _e412 = (0.000000000000000000000000000000000000011754944f * 8f);
                                    phi_815_ = type_31(array<f32, 3>(_e376, _e380, _e384), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e400 * _e408) + _e412), ((_e403 * _e408) + _e412), ((_e406 * _e408) + _e412)));
                                }
                                let _e459 = phi_815_;
                                let _e464 = (_e459.member[0] - _e340.member[0]);
                                let _e467 = (_e459.member[1] - _e340.member[1]);
                                let _e470 = (_e459.member[2] - _e340.member[2]);
                                if (_e464 < 0f) {
                                    phi_1005_ = -(_e464);
                                } else {
                                    phi_1005_ = _e464;
                                }
                                let _e659 = phi_1005_;
                                if (_e467 < 0f) {
                                    phi_1011_ = -(_e467);
                                } else {
                                    phi_1011_ = _e467;
                                }
                                let _e663 = phi_1011_;
                                if (_e470 < 0f) {
                                    phi_1018_ = -(_e470);
                                } else {
                                    phi_1018_ = _e470;
                                }
                                let _e668 = phi_1018_;
                                if (_e340.member_2[0] < 0f) {
                                    phi_1027_ = -(_e340.member_2[0]);
                                } else {
                                    phi_1027_ = _e340.member_2[0];
                                }
                                let _e675 = phi_1027_;
                                if (_e340.member_2[1] < 0f) {
                                    phi_1034_ = -(_e340.member_2[1]);
                                } else {
                                    phi_1034_ = _e340.member_2[1];
                                }
                                let _e680 = phi_1034_;
                                if (_e340.member_2[2] < 0f) {
                                    phi_1042_ = -(_e340.member_2[2]);
                                } else {
                                    phi_1042_ = _e340.member_2[2];
                                }
                                let _e686 = phi_1042_;
                                if (_e459.member_2[0] < 0f) {
                                    phi_1051_ = -(_e459.member_2[0]);
                                } else {
                                    phi_1051_ = _e459.member_2[0];
                                }
                                let _e693 = phi_1051_;
                                if (_e459.member_2[1] < 0f) {
                                    phi_1058_ = -(_e459.member_2[1]);
                                } else {
                                    phi_1058_ = _e459.member_2[1];
                                }
                                let _e698 = phi_1058_;
                                if (_e459.member_2[2] < 0f) {
                                    phi_1066_ = -(_e459.member_2[2]);
                                } else {
                                    phi_1066_ = _e459.member_2[2];
                                }
                                let _e704 = phi_1066_;
                                local_2 = type_26(array<array<f32, 3>, 3>(array<f32, 3>((((_e459.member_1[0][0] * _e340.member_1[0][0]) + (_e459.member_1[0][1] * _e340.member_1[0][1])) + (_e459.member_1[0][2] * _e340.member_1[0][2])), (((_e459.member_1[1][0] * _e340.member_1[0][0]) + (_e459.member_1[1][1] * _e340.member_1[0][1])) + (_e459.member_1[1][2] * _e340.member_1[0][2])), (((_e459.member_1[2][0] * _e340.member_1[0][0]) + (_e459.member_1[2][1] * _e340.member_1[0][1])) + (_e459.member_1[2][2] * _e340.member_1[0][2]))), array<f32, 3>((((_e459.member_1[0][0] * _e340.member_1[1][0]) + (_e459.member_1[0][1] * _e340.member_1[1][1])) + (_e459.member_1[0][2] * _e340.member_1[1][2])), (((_e459.member_1[1][0] * _e340.member_1[1][0]) + (_e459.member_1[1][1] * _e340.member_1[1][1])) + (_e459.member_1[1][2] * _e340.member_1[1][2])), (((_e459.member_1[2][0] * _e340.member_1[1][0]) + (_e459.member_1[2][1] * _e340.member_1[1][1])) + (_e459.member_1[2][2] * _e340.member_1[1][2]))), array<f32, 3>((((_e459.member_1[0][0] * _e340.member_1[2][0]) + (_e459.member_1[0][1] * _e340.member_1[2][1])) + (_e459.member_1[0][2] * _e340.member_1[2][2])), (((_e459.member_1[1][0] * _e340.member_1[2][0]) + (_e459.member_1[1][1] * _e340.member_1[2][1])) + (_e459.member_1[1][2] * _e340.member_1[2][2])), (((_e459.member_1[2][0] * _e340.member_1[2][0]) + (_e459.member_1[2][1] * _e340.member_1[2][1])) + (_e459.member_1[2][2] * _e340.member_1[2][2])))), array<f32, 3>((((_e340.member_1[0][0] * _e464) + (_e340.member_1[0][1] * _e467)) + (_e340.member_1[0][2] * _e470)), (((_e340.member_1[1][0] * _e464) + (_e340.member_1[1][1] * _e467)) + (_e340.member_1[1][2] * _e470)), (((_e340.member_1[2][0] * _e464) + (_e340.member_1[2][1] * _e467)) + (_e340.member_1[2][2] * _e470))), array<f32, 3>((((_e459.member_1[0][0] * _e464) + (_e459.member_1[0][1] * _e467)) + (_e459.member_1[0][2] * _e470)), (((_e459.member_1[1][0] * _e464) + (_e459.member_1[1][1] * _e467)) + (_e459.member_1[1][2] * _e470)), (((_e459.member_1[2][0] * _e464) + (_e459.member_1[2][1] * _e467)) + (_e459.member_1[2][2] * _e470))), array<f32, 3>(_e340.member_2[0], _e340.member_2[1], _e340.member_2[2]), array<f32, 3>(_e459.member_2[0], _e459.member_2[1], _e459.member_2[2]), ((((((_e659 + _e663) + _e668) + (((_e675 + _e680) + _e686) + ((_e693 + _e698) + _e704))) * 2f) * (0.000000059604645f * 128f)) + (0.000000000000000000000000000000000000011754944f * 128f)));
                                let _e731 = local_2.member[0u][0u];
                                let _e735 = local_2.member[0u][1u];
                                let _e739 = local_2.member[0u][2u];
                                let _e743 = local_2.member[1u][0u];
                                let _e747 = local_2.member[1u][1u];
                                let _e751 = local_2.member[1u][2u];
                                let _e755 = local_2.member[2u][0u];
                                let _e759 = local_2.member[2u][1u];
                                let _e763 = local_2.member[2u][2u];
                                let _e765 = local_2.member_3;
                                let _e770 = local_2.member_4;
                                let _e776 = local_2.member_1[0u];
                                if (_e776 < 0f) {
                                    phi_1159_ = -(_e776);
                                } else {
                                    phi_1159_ = _e776;
                                }
                                let _e780 = phi_1159_;
                                if (_e731 < 0f) {
                                    phi_1166_ = -(_e731);
                                } else {
                                    phi_1166_ = _e731;
                                }
                                let _e784 = phi_1166_;
                                if (_e735 < 0f) {
                                    phi_1172_ = -(_e735);
                                } else {
                                    phi_1172_ = _e735;
                                }
                                let _e788 = phi_1172_;
                                if (_e739 < 0f) {
                                    phi_1178_ = -(_e739);
                                } else {
                                    phi_1178_ = _e739;
                                }
                                let _e792 = phi_1178_;
                                let _e799 = (_e780 - (_e765[0] + (((_e784 * _e770[0]) + (_e788 * _e770[1])) + (_e792 * _e770[2]))));
                                let _e802 = local_2.member_1[1u];
                                if (_e802 < 0f) {
                                    phi_1197_ = -(_e802);
                                } else {
                                    phi_1197_ = _e802;
                                }
                                let _e806 = phi_1197_;
                                if (_e743 < 0f) {
                                    phi_1204_ = -(_e743);
                                } else {
                                    phi_1204_ = _e743;
                                }
                                let _e810 = phi_1204_;
                                if (_e747 < 0f) {
                                    phi_1210_ = -(_e747);
                                } else {
                                    phi_1210_ = _e747;
                                }
                                let _e814 = phi_1210_;
                                if (_e751 < 0f) {
                                    phi_1216_ = -(_e751);
                                } else {
                                    phi_1216_ = _e751;
                                }
                                let _e818 = phi_1216_;
                                let _e825 = (_e806 - (_e765[1] + (((_e810 * _e770[0]) + (_e814 * _e770[1])) + (_e818 * _e770[2]))));
                                let _e828 = local_2.member_1[2u];
                                if (_e828 < 0f) {
                                    phi_1235_ = -(_e828);
                                } else {
                                    phi_1235_ = _e828;
                                }
                                let _e832 = phi_1235_;
                                if (_e755 < 0f) {
                                    phi_1242_ = -(_e755);
                                } else {
                                    phi_1242_ = _e755;
                                }
                                let _e836 = phi_1242_;
                                if (_e759 < 0f) {
                                    phi_1248_ = -(_e759);
                                } else {
                                    phi_1248_ = _e759;
                                }
                                let _e840 = phi_1248_;
                                if (_e763 < 0f) {
                                    phi_1254_ = -(_e763);
                                } else {
                                    phi_1254_ = _e763;
                                }
                                let _e844 = phi_1254_;
                                let _e851 = (_e832 - (_e765[2] + (((_e836 * _e770[0]) + (_e840 * _e770[1])) + (_e844 * _e770[2]))));
                                let _e854 = local_2.member_2[0u];
                                if (_e854 < 0f) {
                                    phi_1273_ = -(_e854);
                                } else {
                                    phi_1273_ = _e854;
                                }
                                let _e858 = phi_1273_;
                                if (_e731 < 0f) {
                                    phi_1280_ = -(_e731);
                                } else {
                                    phi_1280_ = _e731;
                                }
                                let _e862 = phi_1280_;
                                if (_e743 < 0f) {
                                    phi_1286_ = -(_e743);
                                } else {
                                    phi_1286_ = _e743;
                                }
                                let _e866 = phi_1286_;
                                if (_e755 < 0f) {
                                    phi_1292_ = -(_e755);
                                } else {
                                    phi_1292_ = _e755;
                                }
                                let _e870 = phi_1292_;
                                let _e877 = (_e858 - (_e770[0] + (((_e862 * _e765[0]) + (_e866 * _e765[1])) + (_e870 * _e765[2]))));
                                let _e880 = local_2.member_2[1u];
                                if (_e880 < 0f) {
                                    phi_1311_ = -(_e880);
                                } else {
                                    phi_1311_ = _e880;
                                }
                                let _e884 = phi_1311_;
                                if (_e735 < 0f) {
                                    phi_1318_ = -(_e735);
                                } else {
                                    phi_1318_ = _e735;
                                }
                                let _e888 = phi_1318_;
                                if (_e747 < 0f) {
                                    phi_1324_ = -(_e747);
                                } else {
                                    phi_1324_ = _e747;
                                }
                                let _e892 = phi_1324_;
                                if (_e759 < 0f) {
                                    phi_1330_ = -(_e759);
                                } else {
                                    phi_1330_ = _e759;
                                }
                                let _e896 = phi_1330_;
                                let _e903 = (_e884 - (_e770[1] + (((_e888 * _e765[0]) + (_e892 * _e765[1])) + (_e896 * _e765[2]))));
                                let _e906 = local_2.member_2[2u];
                                if (_e906 < 0f) {
                                    phi_1349_ = -(_e906);
                                } else {
                                    phi_1349_ = _e906;
                                }
                                let _e910 = phi_1349_;
                                if (_e739 < 0f) {
                                    phi_1356_ = -(_e739);
                                } else {
                                    phi_1356_ = _e739;
                                }
                                let _e914 = phi_1356_;
                                if (_e751 < 0f) {
                                    phi_1362_ = -(_e751);
                                } else {
                                    phi_1362_ = _e751;
                                }
                                let _e918 = phi_1362_;
                                if (_e763 < 0f) {
                                    phi_1368_ = -(_e763);
                                } else {
                                    phi_1368_ = _e763;
                                }
                                let _e922 = phi_1368_;
                                let _e929 = (_e910 - (_e770[2] + (((_e914 * _e765[0]) + (_e918 * _e765[1])) + (_e922 * _e765[2]))));
                                if (_e799 > _e825) {
                                    phi_1383_ = _e799;
                                } else {
                                    phi_1383_ = _e825;
                                }
                                let _e932 = phi_1383_;
                                if (_e932 > _e851) {
                                    phi_1388_ = _e932;
                                } else {
                                    phi_1388_ = _e851;
                                }
                                let _e935 = phi_1388_;
                                if (_e877 > _e903) {
                                    phi_1393_ = _e877;
                                } else {
                                    phi_1393_ = _e903;
                                }
                                let _e938 = phi_1393_;
                                if (_e938 > _e929) {
                                    phi_1398_ = _e938;
                                } else {
                                    phi_1398_ = _e929;
                                }
                                let _e941 = phi_1398_;
                                if (_e935 > _e941) {
                                    phi_1403_ = _e935;
                                } else {
                                    phi_1403_ = _e941;
                                }
                                let _e944 = phi_1403_;
                                let _e946 = local_2.member_5;
                                if (_e944 > _e946) {
                                    phi_2716_ = true;
                                } else {
                                    let _e951 = local_2.member[1u][0u];
                                    let _e954 = local_2.member_1[2u];
                                    let _e959 = local_2.member[2u][0u];
                                    let _e962 = local_2.member_1[1u];
                                    let _e964 = ((_e951 * _e954) - (_e959 * _e962));
                                    let _e968 = local_2.member[2u][0u];
                                    if (_e968 < 0f) {
                                        phi_1462_ = -(_e968);
                                    } else {
                                        phi_1462_ = _e968;
                                    }
                                    let _e972 = phi_1462_;
                                    let _e975 = local_2.member_3[1u];
                                    let _e980 = local_2.member[1u][0u];
                                    if (_e980 < 0f) {
                                        phi_1485_ = -(_e980);
                                    } else {
                                        phi_1485_ = _e980;
                                    }
                                    let _e984 = phi_1485_;
                                    let _e987 = local_2.member_3[2u];
                                    let _e993 = local_2.member[0u][2u];
                                    if (_e993 < 0f) {
                                        phi_1508_ = -(_e993);
                                    } else {
                                        phi_1508_ = _e993;
                                    }
                                    let _e997 = phi_1508_;
                                    let _e1000 = local_2.member_4[1u];
                                    let _e1005 = local_2.member[0u][1u];
                                    if (_e1005 < 0f) {
                                        phi_1530_ = -(_e1005);
                                    } else {
                                        phi_1530_ = _e1005;
                                    }
                                    let _e1009 = phi_1530_;
                                    let _e1012 = local_2.member_4[2u];
                                    if (_e964 < 0f) {
                                        phi_1546_ = -(_e964);
                                    } else {
                                        phi_1546_ = _e964;
                                    }
                                    let _e1018 = phi_1546_;
                                    let _e1020 = (_e1018 - (((_e972 * _e975) + (_e984 * _e987)) + ((_e997 * _e1000) + (_e1009 * _e1012))));
                                    let _e1024 = local_2.member[1u][1u];
                                    let _e1027 = local_2.member_1[2u];
                                    let _e1032 = local_2.member[2u][1u];
                                    let _e1035 = local_2.member_1[1u];
                                    let _e1037 = ((_e1024 * _e1027) - (_e1032 * _e1035));
                                    let _e1041 = local_2.member[2u][1u];
                                    if (_e1041 < 0f) {
                                        phi_1601_ = -(_e1041);
                                    } else {
                                        phi_1601_ = _e1041;
                                    }
                                    let _e1045 = phi_1601_;
                                    let _e1048 = local_2.member_3[1u];
                                    let _e1053 = local_2.member[1u][1u];
                                    if (_e1053 < 0f) {
                                        phi_1624_ = -(_e1053);
                                    } else {
                                        phi_1624_ = _e1053;
                                    }
                                    let _e1057 = phi_1624_;
                                    let _e1060 = local_2.member_3[2u];
                                    let _e1066 = local_2.member[0u][0u];
                                    if (_e1066 < 0f) {
                                        phi_1647_ = -(_e1066);
                                    } else {
                                        phi_1647_ = _e1066;
                                    }
                                    let _e1070 = phi_1647_;
                                    let _e1073 = local_2.member_4[2u];
                                    let _e1078 = local_2.member[0u][2u];
                                    if (_e1078 < 0f) {
                                        phi_1669_ = -(_e1078);
                                    } else {
                                        phi_1669_ = _e1078;
                                    }
                                    let _e1082 = phi_1669_;
                                    let _e1085 = local_2.member_4[0u];
                                    if (_e1037 < 0f) {
                                        phi_1685_ = -(_e1037);
                                    } else {
                                        phi_1685_ = _e1037;
                                    }
                                    let _e1091 = phi_1685_;
                                    let _e1093 = (_e1091 - (((_e1045 * _e1048) + (_e1057 * _e1060)) + ((_e1070 * _e1073) + (_e1082 * _e1085))));
                                    let _e1097 = local_2.member[1u][2u];
                                    let _e1100 = local_2.member_1[2u];
                                    let _e1105 = local_2.member[2u][2u];
                                    let _e1108 = local_2.member_1[1u];
                                    let _e1110 = ((_e1097 * _e1100) - (_e1105 * _e1108));
                                    let _e1114 = local_2.member[2u][2u];
                                    if (_e1114 < 0f) {
                                        phi_1740_ = -(_e1114);
                                    } else {
                                        phi_1740_ = _e1114;
                                    }
                                    let _e1118 = phi_1740_;
                                    let _e1121 = local_2.member_3[1u];
                                    let _e1126 = local_2.member[1u][2u];
                                    if (_e1126 < 0f) {
                                        phi_1763_ = -(_e1126);
                                    } else {
                                        phi_1763_ = _e1126;
                                    }
                                    let _e1130 = phi_1763_;
                                    let _e1133 = local_2.member_3[2u];
                                    let _e1139 = local_2.member[0u][1u];
                                    if (_e1139 < 0f) {
                                        phi_1786_ = -(_e1139);
                                    } else {
                                        phi_1786_ = _e1139;
                                    }
                                    let _e1143 = phi_1786_;
                                    let _e1146 = local_2.member_4[0u];
                                    let _e1151 = local_2.member[0u][0u];
                                    if (_e1151 < 0f) {
                                        phi_1808_ = -(_e1151);
                                    } else {
                                        phi_1808_ = _e1151;
                                    }
                                    let _e1155 = phi_1808_;
                                    let _e1158 = local_2.member_4[1u];
                                    if (_e1110 < 0f) {
                                        phi_1824_ = -(_e1110);
                                    } else {
                                        phi_1824_ = _e1110;
                                    }
                                    let _e1164 = phi_1824_;
                                    let _e1166 = (_e1164 - (((_e1118 * _e1121) + (_e1130 * _e1133)) + ((_e1143 * _e1146) + (_e1155 * _e1158))));
                                    let _e1170 = local_2.member[2u][0u];
                                    let _e1173 = local_2.member_1[0u];
                                    let _e1178 = local_2.member[0u][0u];
                                    let _e1181 = local_2.member_1[2u];
                                    let _e1183 = ((_e1170 * _e1173) - (_e1178 * _e1181));
                                    let _e1187 = local_2.member[0u][0u];
                                    if (_e1187 < 0f) {
                                        phi_1879_ = -(_e1187);
                                    } else {
                                        phi_1879_ = _e1187;
                                    }
                                    let _e1191 = phi_1879_;
                                    let _e1194 = local_2.member_3[2u];
                                    let _e1199 = local_2.member[2u][0u];
                                    if (_e1199 < 0f) {
                                        phi_1902_ = -(_e1199);
                                    } else {
                                        phi_1902_ = _e1199;
                                    }
                                    let _e1203 = phi_1902_;
                                    let _e1206 = local_2.member_3[0u];
                                    let _e1212 = local_2.member[1u][2u];
                                    if (_e1212 < 0f) {
                                        phi_1926_ = -(_e1212);
                                    } else {
                                        phi_1926_ = _e1212;
                                    }
                                    let _e1216 = phi_1926_;
                                    let _e1219 = local_2.member_4[1u];
                                    let _e1224 = local_2.member[1u][1u];
                                    if (_e1224 < 0f) {
                                        phi_1949_ = -(_e1224);
                                    } else {
                                        phi_1949_ = _e1224;
                                    }
                                    let _e1228 = phi_1949_;
                                    let _e1231 = local_2.member_4[2u];
                                    if (_e1183 < 0f) {
                                        phi_1965_ = -(_e1183);
                                    } else {
                                        phi_1965_ = _e1183;
                                    }
                                    let _e1237 = phi_1965_;
                                    let _e1239 = (_e1237 - (((_e1191 * _e1194) + (_e1203 * _e1206)) + ((_e1216 * _e1219) + (_e1228 * _e1231))));
                                    let _e1243 = local_2.member[2u][1u];
                                    let _e1246 = local_2.member_1[0u];
                                    let _e1251 = local_2.member[0u][1u];
                                    let _e1254 = local_2.member_1[2u];
                                    let _e1256 = ((_e1243 * _e1246) - (_e1251 * _e1254));
                                    let _e1260 = local_2.member[0u][1u];
                                    if (_e1260 < 0f) {
                                        phi_2020_ = -(_e1260);
                                    } else {
                                        phi_2020_ = _e1260;
                                    }
                                    let _e1264 = phi_2020_;
                                    let _e1267 = local_2.member_3[2u];
                                    let _e1272 = local_2.member[2u][1u];
                                    if (_e1272 < 0f) {
                                        phi_2043_ = -(_e1272);
                                    } else {
                                        phi_2043_ = _e1272;
                                    }
                                    let _e1276 = phi_2043_;
                                    let _e1279 = local_2.member_3[0u];
                                    let _e1285 = local_2.member[1u][0u];
                                    if (_e1285 < 0f) {
                                        phi_2067_ = -(_e1285);
                                    } else {
                                        phi_2067_ = _e1285;
                                    }
                                    let _e1289 = phi_2067_;
                                    let _e1292 = local_2.member_4[2u];
                                    let _e1297 = local_2.member[1u][2u];
                                    if (_e1297 < 0f) {
                                        phi_2090_ = -(_e1297);
                                    } else {
                                        phi_2090_ = _e1297;
                                    }
                                    let _e1301 = phi_2090_;
                                    let _e1304 = local_2.member_4[0u];
                                    if (_e1256 < 0f) {
                                        phi_2106_ = -(_e1256);
                                    } else {
                                        phi_2106_ = _e1256;
                                    }
                                    let _e1310 = phi_2106_;
                                    let _e1312 = (_e1310 - (((_e1264 * _e1267) + (_e1276 * _e1279)) + ((_e1289 * _e1292) + (_e1301 * _e1304))));
                                    let _e1316 = local_2.member[2u][2u];
                                    let _e1319 = local_2.member_1[0u];
                                    let _e1324 = local_2.member[0u][2u];
                                    let _e1327 = local_2.member_1[2u];
                                    let _e1329 = ((_e1316 * _e1319) - (_e1324 * _e1327));
                                    let _e1333 = local_2.member[0u][2u];
                                    if (_e1333 < 0f) {
                                        phi_2161_ = -(_e1333);
                                    } else {
                                        phi_2161_ = _e1333;
                                    }
                                    let _e1337 = phi_2161_;
                                    let _e1340 = local_2.member_3[2u];
                                    let _e1345 = local_2.member[2u][2u];
                                    if (_e1345 < 0f) {
                                        phi_2184_ = -(_e1345);
                                    } else {
                                        phi_2184_ = _e1345;
                                    }
                                    let _e1349 = phi_2184_;
                                    let _e1352 = local_2.member_3[0u];
                                    let _e1358 = local_2.member[1u][1u];
                                    if (_e1358 < 0f) {
                                        phi_2208_ = -(_e1358);
                                    } else {
                                        phi_2208_ = _e1358;
                                    }
                                    let _e1362 = phi_2208_;
                                    let _e1365 = local_2.member_4[0u];
                                    let _e1370 = local_2.member[1u][0u];
                                    if (_e1370 < 0f) {
                                        phi_2231_ = -(_e1370);
                                    } else {
                                        phi_2231_ = _e1370;
                                    }
                                    let _e1374 = phi_2231_;
                                    let _e1377 = local_2.member_4[1u];
                                    if (_e1329 < 0f) {
                                        phi_2247_ = -(_e1329);
                                    } else {
                                        phi_2247_ = _e1329;
                                    }
                                    let _e1383 = phi_2247_;
                                    let _e1385 = (_e1383 - (((_e1337 * _e1340) + (_e1349 * _e1352)) + ((_e1362 * _e1365) + (_e1374 * _e1377))));
                                    let _e1389 = local_2.member[0u][0u];
                                    let _e1392 = local_2.member_1[1u];
                                    let _e1397 = local_2.member[1u][0u];
                                    let _e1400 = local_2.member_1[0u];
                                    let _e1402 = ((_e1389 * _e1392) - (_e1397 * _e1400));
                                    let _e1406 = local_2.member[1u][0u];
                                    if (_e1406 < 0f) {
                                        phi_2302_ = -(_e1406);
                                    } else {
                                        phi_2302_ = _e1406;
                                    }
                                    let _e1410 = phi_2302_;
                                    let _e1413 = local_2.member_3[0u];
                                    let _e1418 = local_2.member[0u][0u];
                                    if (_e1418 < 0f) {
                                        phi_2325_ = -(_e1418);
                                    } else {
                                        phi_2325_ = _e1418;
                                    }
                                    let _e1422 = phi_2325_;
                                    let _e1425 = local_2.member_3[1u];
                                    let _e1431 = local_2.member[2u][2u];
                                    if (_e1431 < 0f) {
                                        phi_2349_ = -(_e1431);
                                    } else {
                                        phi_2349_ = _e1431;
                                    }
                                    let _e1435 = phi_2349_;
                                    let _e1438 = local_2.member_4[1u];
                                    let _e1443 = local_2.member[2u][1u];
                                    if (_e1443 < 0f) {
                                        phi_2372_ = -(_e1443);
                                    } else {
                                        phi_2372_ = _e1443;
                                    }
                                    let _e1447 = phi_2372_;
                                    let _e1450 = local_2.member_4[2u];
                                    if (_e1402 < 0f) {
                                        phi_2388_ = -(_e1402);
                                    } else {
                                        phi_2388_ = _e1402;
                                    }
                                    let _e1456 = phi_2388_;
                                    let _e1458 = (_e1456 - (((_e1410 * _e1413) + (_e1422 * _e1425)) + ((_e1435 * _e1438) + (_e1447 * _e1450))));
                                    let _e1462 = local_2.member[0u][1u];
                                    let _e1465 = local_2.member_1[1u];
                                    let _e1470 = local_2.member[1u][1u];
                                    let _e1473 = local_2.member_1[0u];
                                    let _e1475 = ((_e1462 * _e1465) - (_e1470 * _e1473));
                                    let _e1479 = local_2.member[1u][1u];
                                    if (_e1479 < 0f) {
                                        phi_2443_ = -(_e1479);
                                    } else {
                                        phi_2443_ = _e1479;
                                    }
                                    let _e1483 = phi_2443_;
                                    let _e1486 = local_2.member_3[0u];
                                    let _e1491 = local_2.member[0u][1u];
                                    if (_e1491 < 0f) {
                                        phi_2466_ = -(_e1491);
                                    } else {
                                        phi_2466_ = _e1491;
                                    }
                                    let _e1495 = phi_2466_;
                                    let _e1498 = local_2.member_3[1u];
                                    let _e1504 = local_2.member[2u][0u];
                                    if (_e1504 < 0f) {
                                        phi_2490_ = -(_e1504);
                                    } else {
                                        phi_2490_ = _e1504;
                                    }
                                    let _e1508 = phi_2490_;
                                    let _e1511 = local_2.member_4[2u];
                                    let _e1516 = local_2.member[2u][2u];
                                    if (_e1516 < 0f) {
                                        phi_2513_ = -(_e1516);
                                    } else {
                                        phi_2513_ = _e1516;
                                    }
                                    let _e1520 = phi_2513_;
                                    let _e1523 = local_2.member_4[0u];
                                    if (_e1475 < 0f) {
                                        phi_2529_ = -(_e1475);
                                    } else {
                                        phi_2529_ = _e1475;
                                    }
                                    let _e1529 = phi_2529_;
                                    let _e1531 = (_e1529 - (((_e1483 * _e1486) + (_e1495 * _e1498)) + ((_e1508 * _e1511) + (_e1520 * _e1523))));
                                    let _e1535 = local_2.member[0u][2u];
                                    let _e1538 = local_2.member_1[1u];
                                    let _e1543 = local_2.member[1u][2u];
                                    let _e1546 = local_2.member_1[0u];
                                    let _e1548 = ((_e1535 * _e1538) - (_e1543 * _e1546));
                                    let _e1552 = local_2.member[1u][2u];
                                    if (_e1552 < 0f) {
                                        phi_2584_ = -(_e1552);
                                    } else {
                                        phi_2584_ = _e1552;
                                    }
                                    let _e1556 = phi_2584_;
                                    let _e1559 = local_2.member_3[0u];
                                    let _e1564 = local_2.member[0u][2u];
                                    if (_e1564 < 0f) {
                                        phi_2607_ = -(_e1564);
                                    } else {
                                        phi_2607_ = _e1564;
                                    }
                                    let _e1568 = phi_2607_;
                                    let _e1571 = local_2.member_3[1u];
                                    let _e1577 = local_2.member[2u][1u];
                                    if (_e1577 < 0f) {
                                        phi_2631_ = -(_e1577);
                                    } else {
                                        phi_2631_ = _e1577;
                                    }
                                    let _e1581 = phi_2631_;
                                    let _e1584 = local_2.member_4[0u];
                                    let _e1589 = local_2.member[2u][0u];
                                    if (_e1589 < 0f) {
                                        phi_2654_ = -(_e1589);
                                    } else {
                                        phi_2654_ = _e1589;
                                    }
                                    let _e1593 = phi_2654_;
                                    let _e1596 = local_2.member_4[1u];
                                    if (_e1548 < 0f) {
                                        phi_2670_ = -(_e1548);
                                    } else {
                                        phi_2670_ = _e1548;
                                    }
                                    let _e1602 = phi_2670_;
                                    let _e1604 = (_e1602 - (((_e1556 * _e1559) + (_e1568 * _e1571)) + ((_e1581 * _e1584) + (_e1593 * _e1596))));
                                    if (_e1020 > _e1093) {
                                        phi_2677_ = _e1020;
                                    } else {
                                        phi_2677_ = _e1093;
                                    }
                                    let _e1607 = phi_2677_;
                                    if (_e1607 > _e1166) {
                                        phi_2682_ = _e1607;
                                    } else {
                                        phi_2682_ = _e1166;
                                    }
                                    let _e1610 = phi_2682_;
                                    if (_e1239 > _e1312) {
                                        phi_2687_ = _e1239;
                                    } else {
                                        phi_2687_ = _e1312;
                                    }
                                    let _e1613 = phi_2687_;
                                    if (_e1613 > _e1385) {
                                        phi_2692_ = _e1613;
                                    } else {
                                        phi_2692_ = _e1385;
                                    }
                                    let _e1616 = phi_2692_;
                                    if (_e1610 > _e1616) {
                                        phi_2697_ = _e1610;
                                    } else {
                                        phi_2697_ = _e1616;
                                    }
                                    let _e1619 = phi_2697_;
                                    if (_e1458 > _e1531) {
                                        phi_2702_ = _e1458;
                                    } else {
                                        phi_2702_ = _e1531;
                                    }
                                    let _e1622 = phi_2702_;
                                    if (_e1622 > _e1604) {
                                        phi_2707_ = _e1622;
                                    } else {
                                        phi_2707_ = _e1604;
                                    }
                                    let _e1625 = phi_2707_;
                                    if (_e1619 > _e1625) {
                                        phi_2712_ = _e1619;
                                    } else {
                                        phi_2712_ = _e1625;
                                    }
                                    let _e1628 = phi_2712_;
                                    let _e1630 = local_2.member_5;
                                    phi_2716_ = (_e1628 > _e1630);
                                }
                                let _e1633 = phi_2716_;
                                phi_2718_ = !(_e1633);
                                phi_2719_ = false;
                            } else {
                                phi_2718_ = bool();
                                phi_2719_ = true;
                            }
                            let _e1636 = phi_2718_;
                            let _e1638 = phi_2719_;
                            phi_2720_ = _e1636;
                            phi_2721_ = _e1638;
                        }
                        let _e1640 = phi_2720_;
                        let _e1642 = phi_2721_;
                        if _e1642 {
                            phi_2725_ = true;
                        } else {
                            phi_2725_ = _e1640;
                        }
                        let _e1644 = phi_2725_;
                        phi_2726_ = _e1644;
                    } else {
                        phi_2726_ = false;
                    }
                    let _e1646 = phi_2726_;
                    if _e1646 {
                        phi_2730_ = _e115;
                    } else {
                        phi_2730_ = array<u32, 2>(4294967295u, 4294967295u);
                    }
                    let _e1648 = phi_2730_;
                    phi_2731_ = _e1648;
                }
                let _e1650 = phi_2731_;
                phi_2732_ = _e1650;
            } else {
                phi_2732_ = array<u32, 2>(4294967295u, 4294967295u);
            }
            let _e1652 = phi_2732_;
            phi_2733_ = _e1652;
        } else {
            phi_2733_ = array<u32, 2>(4294967295u, 4294967295u);
        }
        let _e1654 = phi_2733_;
        phi_2734_ = _e1654;
    }
    let _e1678 = phi_2734_;
    local_3 = type_19(array<u32, 64>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 64>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u);
    let _e1681 = params.member.member_2.member;
    if (_e1681 == 0u) {
        phi_2880_ = array<u32, 2>(0u, 2u);
    } else {
        phi_2880_ = array<u32, 2>(1u, 1u);
    }
    let _e1684 = phi_2880_;
    let _e1690 = params.member.member.member[_e1684[0]];
    let _e1695 = params.member.member.member[_e1684[1]];
    if (_e1678[0] == 4294967295u) {
        phi_2922_ = 0u;
    } else {
        if (_e1678[0] >= (_e1690 - 1u)) {
            if (_e1678[1] >= (_e1695 - 1u)) {
                phi_2916_ = false;
            } else {
                phi_2916_ = true;
            }
            let _e1704 = phi_2916_;
            phi_2917_ = _e1704;
        } else {
            phi_2917_ = true;
        }
        let _e1706 = phi_2917_;
        if _e1706 {
            phi_2921_ = 1u;
        } else {
            phi_2921_ = 2u;
        }
        let _e1708 = phi_2921_;
        phi_2922_ = _e1708;
    }
    let _e1710 = phi_2922_;
    if (_e1710 == 2u) {
        let _e1762 = params.member.member_1.member_3;
        let _e1765 = a_nodes.member[_e1678[0]];
        let _e1769 = b_nodes.member[_e1678[1]];
        let _e1773 = params.member.member_2.member;
        if (_e1773 == 1u) {
            if (_e1765.member_1 < _e1769.member_1) {
                phi_2973_ = type_9(_e1765.member_1, _e1769.member_1);
            } else {
                phi_2973_ = type_9(_e1769.member_1, _e1765.member_1);
            }
            let _e1780 = phi_2973_;
            phi_2978_ = _e1780;
        } else {
            phi_2978_ = type_9(_e1765.member_1, _e1769.member_1);
        }
        let _e1782 = phi_2978_;
        let _e1786 = atomicAdd((&pairs.member[0u]), 1u);
        if ((_e1786 + 1u) < _e1786) {
            let _e1790 = atomicAdd((&pairs.member[2u]), 1u);
        }
        if (_e1786 < _e1762) {
            let _e1792 = (2u * _e1786);
            atomicStore((&pairs.member[(4u + _e1792)]), _e1782.member);
            atomicStore((&pairs.member[(_e1792 + 5u)]), _e1782.member_1);
        }
    } else {
        if (_e1710 == 1u) {
            let _e1715 = params.member.member_2.member_10;
            let _e1717 = local_3.member_2;
            if (64u < _e1715) {
                phi_3018_ = 64u;
            } else {
                phi_3018_ = _e1715;
            }
            let _e1720 = phi_3018_;
            let _e1721 = (_e1717 < _e1720);
            if _e1721 {
                let _e1724 = local_3.member_2;
                local_3.member[_e1724] = _e1678[0];
                let _e1729 = local_3.member_2;
                local_3.member_1[_e1729] = _e1678[1];
                let _e1734 = local_3.member_2;
                local_3.member_2 = (_e1734 + 1u);
            }
            if _e1721 {
            } else {
                let _e1738 = params.member.member_1.member_1;
                let _e1741 = atomicAdd((&rounds.member[(_e1738 + 1u)]), 1u);
                let _e1744 = atomicMax((&output.member[0u]), (_e1741 + 1u));
                if ((_e1741 + 1u) < _e1741) {
                    let _e1748 = atomicAdd((&output.member[2u]), 1u);
                }
                let _e1751 = params.member.member_2.member_3;
                if (_e1741 < _e1751) {
                    let _e1755 = (2u * _e1741);
                    atomicStore((&output.member[(4u + _e1755)]), _e1678[0]);
                    atomicStore((&output.member[(_e1755 + 5u)]), _e1678[1]);
                }
            }
        }
    }
    let _e1799 = params.member.member_2.member_12;
    phi_3091_ = type_9(0u, _e1799);
    loop {
        let _e1802 = phi_3091_;
        if (_e1802.member < _e1802.member_1) {
            phi_3092_ = type_9((_e1802.member + 1u), _e1802.member_1);
            phi_3115_ = type_9(1u, _e1802.member);
        } else {
            phi_3092_ = _e1802;
            phi_3115_ = type_9(0u, type_9().member_1);
        }
        let _e1814 = phi_3092_;
        let _e1816 = phi_3115_;
        if (bitcast<i32>(_e1816.member) != 0i) {
            let _e1821 = local_3.member_2;
            if (_e1821 > 0u) {
                let _e1825 = local_3.member_2;
                local_3.member_2 = (_e1825 - 1u);
                let _e1828 = local_3.member_2;
                let _e1831 = local_3.member[_e1828];
                let _e1834 = local_3.member_1[_e1828];
                phi_3150_ = array<u32, 2>(_e1831, _e1834);
            } else {
                phi_3150_ = array<u32, 2>(4294967295u, 4294967295u);
            }
            let _e1837 = phi_3150_;
            if (_e1837[0] == 4294967295u) {
                phi_7032_ = false;
            } else {
                let _e1842 = params.member.member_2.member_1;
                if (_e1842 == 0u) {
                    phi_3164_ = 1u;
                } else {
                    phi_3164_ = 0u;
                }
                let _e1845 = phi_3164_;
                let _e1848 = params.member.member_2.member;
                let _e1853 = a_nodes.member[_e1837[0]];
                let _e1855 = b_nodes.member[_e1837[1]];
                if (_e1848 == 1u) {
                    if (_e1837[0] == _e1837[1]) {
                        if (_e1853.member_3 == 4294967295u) {
                            phi_3291_ = type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)));
                        } else {
                            let _e1861 = a_nodes.member[_e1853.member_1];
                            let _e1864 = a_nodes.member[_e1853.member_3];
                            if !((_e1861.member_3 == 4294967295u)) {
                                phi_3238_ = array<u32, 2>(_e1853.member_1, _e1853.member_1);
                            } else {
                                phi_3238_ = array<u32, 2>(4294967295u, 4294967295u);
                            }
                            let _e1871 = phi_3238_;
                            let _e1878 = type_24(array<array<u32, 2>, 4>(_e1871, type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[1], type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[2], type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[3]), type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1);
                            let _e1890 = type_24(array<array<u32, 2>, 4>(_e1878.member[0], array<u32, 2>(_e1853.member_1, _e1878.member[1][1]), _e1878.member[2], _e1878.member[3]), _e1878.member_1);
                            let _e1891 = array<u32, 2>(_e1853.member_1, _e1853.member_3);
                            let _e1898 = type_24(array<array<u32, 2>, 4>(_e1890.member[0], _e1891, _e1890.member[2], _e1890.member[3]), _e1890.member_1);
                            if !((_e1864.member_3 == 4294967295u)) {
                                phi_3252_ = array<u32, 2>(_e1853.member_3, _e1853.member_3);
                            } else {
                                phi_3252_ = array<u32, 2>(4294967295u, 4294967295u);
                            }
                            let _e1905 = phi_3252_;
                            let _e1912 = type_24(array<array<u32, 2>, 4>(_e1898.member[0], _e1898.member[1], _e1905, _e1898.member[3]), _e1898.member_1);
                            let _e1915 = type_24(_e1912.member, _e1912.member);
                            if ((((((_e1861.member[0] <= _e1864.member_2[0]) && (_e1864.member[0] <= _e1861.member_2[0])) && (_e1861.member[1] <= _e1864.member_2[1])) && (_e1864.member[1] <= _e1861.member_2[1])) && (_e1861.member[2] <= _e1864.member_2[2])) && (_e1864.member[2] <= _e1861.member_2[2])) {
                                phi_3289_ = _e1891;
                            } else {
                                phi_3289_ = array<u32, 2>(4294967295u, 4294967295u);
                            }
                            let _e1944 = phi_3289_;
                            phi_3291_ = type_24(_e1915.member, array<array<u32, 2>, 4>(_e1915.member_1[0], _e1944, _e1915.member_1[2], _e1915.member_1[3]));
                        }
                        let _e1953 = phi_3291_;
                        phi_3292_ = _e1953;
                        phi_3293_ = false;
                    } else {
                        phi_3292_ = type_24();
                        phi_3293_ = true;
                    }
                    let _e1955 = phi_3292_;
                    let _e1957 = phi_3293_;
                    phi_3294_ = _e1955;
                    phi_3295_ = _e1957;
                } else {
                    phi_3294_ = type_24();
                    phi_3295_ = true;
                }
                let _e1959 = phi_3294_;
                let _e1961 = phi_3295_;
                if _e1961 {
                    let _e1964 = !((_e1853.member_3 == 4294967295u));
                    let _e1967 = !((_e1855.member_3 == 4294967295u));
                    if _e1964 {
                        phi_3311_ = true;
                    } else {
                        phi_3311_ = _e1967;
                    }
                    let _e1969 = phi_3311_;
                    if _e1969 {
                        if _e1964 {
                            if _e1967 {
                                if (_e1845 == 0u) {
                                    let _e1997 = ((((_e1855.member_2[0] - _e1855.member[0]) * (_e1855.member_2[1] - _e1855.member[1])) * (_e1855.member_2[2] - _e1855.member[2])) > (((_e1853.member_2[0] - _e1853.member[0]) * (_e1853.member_2[1] - _e1853.member[1])) * (_e1853.member_2[2] - _e1853.member[2])));
                                    phi_3355_ = _e1997;
                                    phi_3356_ = !(_e1997);
                                } else {
                                    phi_3355_ = _e1967;
                                    phi_3356_ = _e1964;
                                }
                                let _e2000 = phi_3355_;
                                let _e2002 = phi_3356_;
                                phi_3357_ = _e2000;
                                phi_3358_ = _e2002;
                            } else {
                                phi_3357_ = _e1967;
                                phi_3358_ = _e1964;
                            }
                            let _e2004 = phi_3357_;
                            let _e2006 = phi_3358_;
                            phi_3359_ = _e2004;
                            phi_3360_ = _e2006;
                        } else {
                            phi_3359_ = _e1967;
                            phi_3360_ = _e1964;
                        }
                        let _e2008 = phi_3359_;
                        let _e2010 = phi_3360_;
                        if _e2010 {
                            if _e2008 {
                                let _e2013 = a_nodes.member[_e1853.member_1];
                                let _e2018 = a_nodes.member[_e1853.member_3];
                                let _e2023 = b_nodes.member[_e1855.member_1];
                                let _e2028 = b_nodes.member[_e1855.member_3];
                                let _e2033 = array<u32, 2>(_e1853.member_1, _e1855.member_1);
                                let _e2036 = array<u32, 2>(_e1853.member_1, _e1855.member_3);
                                let _e2039 = array<u32, 2>(_e1853.member_3, _e1855.member_1);
                                let _e2042 = array<u32, 2>(_e1853.member_3, _e1855.member_3);
                                if ((((((_e2013.member[0] <= _e2023.member_2[0]) && (_e2023.member[0] <= _e2013.member_2[0])) && (_e2013.member[1] <= _e2023.member_2[1])) && (_e2023.member[1] <= _e2013.member_2[1])) && (_e2013.member[2] <= _e2023.member_2[2])) && (_e2023.member[2] <= _e2013.member_2[2])) {
                                    phi_3466_ = _e2033;
                                } else {
                                    phi_3466_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e2068 = phi_3466_;
                                if ((((((_e2013.member[0] <= _e2028.member_2[0]) && (_e2028.member[0] <= _e2013.member_2[0])) && (_e2013.member[1] <= _e2028.member_2[1])) && (_e2028.member[1] <= _e2013.member_2[1])) && (_e2013.member[2] <= _e2028.member_2[2])) && (_e2028.member[2] <= _e2013.member_2[2])) {
                                    phi_3495_ = _e2036;
                                } else {
                                    phi_3495_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e2093 = phi_3495_;
                                if ((((((_e2018.member[0] <= _e2023.member_2[0]) && (_e2023.member[0] <= _e2018.member_2[0])) && (_e2018.member[1] <= _e2023.member_2[1])) && (_e2023.member[1] <= _e2018.member_2[1])) && (_e2018.member[2] <= _e2023.member_2[2])) && (_e2023.member[2] <= _e2018.member_2[2])) {
                                    phi_3524_ = _e2039;
                                } else {
                                    phi_3524_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e2118 = phi_3524_;
                                if ((((((_e2018.member[0] <= _e2028.member_2[0]) && (_e2028.member[0] <= _e2018.member_2[0])) && (_e2018.member[1] <= _e2028.member_2[1])) && (_e2028.member[1] <= _e2018.member_2[1])) && (_e2018.member[2] <= _e2028.member_2[2])) && (_e2028.member[2] <= _e2018.member_2[2])) {
                                    phi_3553_ = _e2042;
                                } else {
                                    phi_3553_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e2143 = phi_3553_;
                                phi_3555_ = type_24(array<array<u32, 2>, 4>(_e2033, _e2036, _e2039, _e2042), array<array<u32, 2>, 4>(_e2068, _e2093, _e2118, _e2143));
                                phi_3556_ = false;
                            } else {
                                phi_3555_ = type_24();
                                phi_3556_ = true;
                            }
                            let _e2147 = phi_3555_;
                            let _e2149 = phi_3556_;
                            phi_3557_ = _e2147;
                            phi_3558_ = _e2149;
                        } else {
                            phi_3557_ = type_24();
                            phi_3558_ = true;
                        }
                        let _e2151 = phi_3557_;
                        let _e2153 = phi_3558_;
                        if _e2153 {
                            if _e2010 {
                                let _e2238 = a_nodes.member[_e1853.member_1];
                                let _e2243 = a_nodes.member[_e1853.member_3];
                                if ((((((_e2238.member[0] <= _e1855.member_2[0]) && (_e1855.member[0] <= _e2238.member_2[0])) && (_e2238.member[1] <= _e1855.member_2[1])) && (_e1855.member[1] <= _e2238.member_2[1])) && (_e2238.member[2] <= _e1855.member_2[2])) && (_e1855.member[2] <= _e2238.member_2[2])) {
                                    phi_3631_ = array<u32, 2>(_e1853.member_1, _e1837[1]);
                                } else {
                                    phi_3631_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e2276 = phi_3631_;
                                let _e2283 = type_24(type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member, array<array<u32, 2>, 4>(_e2276, type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[1], type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[2], type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[3]));
                                if ((((((_e2243.member[0] <= _e1855.member_2[0]) && (_e1855.member[0] <= _e2243.member_2[0])) && (_e2243.member[1] <= _e1855.member_2[1])) && (_e1855.member[1] <= _e2243.member_2[1])) && (_e2243.member[2] <= _e1855.member_2[2])) && (_e1855.member[2] <= _e2243.member_2[2])) {
                                    phi_3663_ = array<u32, 2>(_e1853.member_3, _e1837[1]);
                                } else {
                                    phi_3663_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e2310 = phi_3663_;
                                phi_3765_ = type_24(_e2283.member, array<array<u32, 2>, 4>(_e2283.member_1[0], _e2310, _e2283.member_1[2], _e2283.member_1[3]));
                            } else {
                                let _e2156 = b_nodes.member[_e1855.member_1];
                                let _e2161 = b_nodes.member[_e1855.member_3];
                                if ((((((_e1853.member[0] <= _e2156.member_2[0]) && (_e2156.member[0] <= _e1853.member_2[0])) && (_e1853.member[1] <= _e2156.member_2[1])) && (_e2156.member[1] <= _e1853.member_2[1])) && (_e1853.member[2] <= _e2156.member_2[2])) && (_e2156.member[2] <= _e1853.member_2[2])) {
                                    phi_3731_ = array<u32, 2>(_e1837[0], _e1855.member_1);
                                } else {
                                    phi_3731_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e2194 = phi_3731_;
                                let _e2201 = type_24(type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member, array<array<u32, 2>, 4>(_e2194, type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[1], type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[2], type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[3]));
                                if ((((((_e1853.member[0] <= _e2161.member_2[0]) && (_e2161.member[0] <= _e1853.member_2[0])) && (_e1853.member[1] <= _e2161.member_2[1])) && (_e2161.member[1] <= _e1853.member_2[1])) && (_e1853.member[2] <= _e2161.member_2[2])) && (_e2161.member[2] <= _e1853.member_2[2])) {
                                    phi_3763_ = array<u32, 2>(_e1837[0], _e1855.member_3);
                                } else {
                                    phi_3763_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e2228 = phi_3763_;
                                phi_3765_ = type_24(_e2201.member, array<array<u32, 2>, 4>(_e2201.member_1[0], _e2228, _e2201.member_1[2], _e2201.member_1[3]));
                            }
                            let _e2319 = phi_3765_;
                            phi_3766_ = _e2319;
                        } else {
                            phi_3766_ = _e2151;
                        }
                        let _e2321 = phi_3766_;
                        phi_3767_ = _e2321;
                        phi_3768_ = false;
                    } else {
                        phi_3767_ = type_24();
                        phi_3768_ = true;
                    }
                    let _e2323 = phi_3767_;
                    let _e2325 = phi_3768_;
                    phi_3769_ = _e2323;
                    phi_3770_ = type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)));
                    phi_3771_ = _e2325;
                } else {
                    phi_3769_ = type_24();
                    phi_3770_ = _e1959;
                    phi_3771_ = true;
                }
                let _e2327 = phi_3769_;
                let _e2329 = phi_3770_;
                let _e2331 = phi_3771_;
                if _e2331 {
                    phi_3775_ = _e2329;
                } else {
                    phi_3775_ = _e2327;
                }
                let _e2333 = phi_3775_;
                let _e2337 = params.member.member_2.member;
                if (_e2337 == 0u) {
                    phi_3793_ = array<u32, 2>(0u, 2u);
                } else {
                    phi_3793_ = array<u32, 2>(1u, 1u);
                }
                let _e2340 = phi_3793_;
                let _e2346 = params.member.member.member[_e2340[0]];
                let _e2347 = (_e2346 - 1u);
                let _e2351 = params.member.member.member[_e2340[1]];
                let _e2352 = (_e2351 - 1u);
                let _e2355 = params.member.member_2.member;
                if (_e2355 == 0u) {
                    phi_3824_ = array<u32, 2>(0u, 2u);
                } else {
                    phi_3824_ = array<u32, 2>(1u, 1u);
                }
                let _e2358 = phi_3824_;
                let _e2364 = params.member.member.member_2[_e2358[0]];
                let _e2368 = params.member.member.member_2[_e2358[1]];
                let _e2371 = params.member.member_2.member;
                local_1 = array<array<u32, 2>, 4>(array<u32, 2>(_e2333.member_1[0][0], _e2333.member_1[0][1]), array<u32, 2>(_e2333.member_1[1][0], _e2333.member_1[1][1]), array<u32, 2>(_e2333.member_1[2][0], _e2333.member_1[2][1]), array<u32, 2>(_e2333.member_1[3][0], _e2333.member_1[3][1]));
                phi_3869_ = type_9(0u, 4u);
                loop {
                    let _e2391 = phi_3869_;
                    if (_e2391.member < _e2391.member_1) {
                        phi_3870_ = type_9((_e2391.member + 1u), _e2391.member_1);
                        phi_3893_ = type_9(1u, _e2391.member);
                    } else {
                        phi_3870_ = _e2391;
                        phi_3893_ = type_9(0u, type_9().member_1);
                    }
                    let _e2403 = phi_3870_;
                    let _e2405 = phi_3893_;
                    let _e2409 = (bitcast<i32>(_e2405.member) != 0i);
                    if _e2409 {
                        let _e2411 = local_1[_e2405.member_1];
                        if (_e2411[0] != 4294967295u) {
                            if (_e2371 == 1u) {
                                phi_3922_ = (_e2411[0] == _e2411[1]);
                            } else {
                                phi_3922_ = false;
                            }
                            let _e2417 = phi_3922_;
                            if _e2417 {
                                phi_6131_ = bool();
                                phi_6132_ = true;
                            } else {
                                if (_e2411[0] >= _e2347) {
                                    if (_e2411[1] >= _e2352) {
                                        phi_3934_ = false;
                                    } else {
                                        phi_3934_ = true;
                                    }
                                    let _e2421 = phi_3934_;
                                    phi_3935_ = _e2421;
                                } else {
                                    phi_3935_ = true;
                                }
                                let _e2423 = phi_3935_;
                                if _e2423 {
                                    if (_e2411[0] < _e2347) {
                                        let _e2503 = oriented.member[(_e2364 + _e2411[0])];
                                        phi_4082_ = type_31(array<f32, 3>(_e2503.member.x, _e2503.member.y, _e2503.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e2503.member.w, _e2503.member_1.x, _e2503.member_1.y), array<f32, 3>(_e2503.member_1.z, _e2503.member_1.w, _e2503.member_2.x), array<f32, 3>(_e2503.member_2.y, _e2503.member_2.z, _e2503.member_2.w)), array<f32, 3>(_e2503.member_3.x, _e2503.member_3.y, _e2503.member_3.z));
                                    } else {
                                        let _e2426 = a_nodes.member[_e2411[0]];
                                        let _e2441 = ((_e2426.member[0] * 0.5f) + (_e2426.member_2[0] * 0.5f));
                                        let _e2442 = ((_e2426.member[1] * 0.5f) + (_e2426.member_2[1] * 0.5f));
                                        let _e2443 = ((_e2426.member[2] * 0.5f) + (_e2426.member_2[2] * 0.5f));
                                        if (_e2441 < _e2426.member_2[0]) {
                                            phi_4008_ = _e2441;
                                        } else {
                                            phi_4008_ = _e2426.member_2[0];
                                        }
                                        let _e2447 = phi_4008_;
                                        if (_e2442 < _e2426.member_2[1]) {
                                            phi_4014_ = _e2442;
                                        } else {
                                            phi_4014_ = _e2426.member_2[1];
                                        }
                                        let _e2451 = phi_4014_;
                                        if (_e2443 < _e2426.member_2[2]) {
                                            phi_4020_ = _e2443;
                                        } else {
                                            phi_4020_ = _e2426.member_2[2];
                                        }
                                        let _e2455 = phi_4020_;
                                        if (_e2447 > _e2426.member[0]) {
                                            phi_4026_ = _e2447;
                                        } else {
                                            phi_4026_ = _e2426.member[0];
                                        }
                                        let _e2459 = phi_4026_;
                                        if (_e2451 > _e2426.member[1]) {
                                            phi_4032_ = _e2451;
                                        } else {
                                            phi_4032_ = _e2426.member[1];
                                        }
                                        let _e2463 = phi_4032_;
                                        if (_e2455 > _e2426.member[2]) {
                                            phi_4038_ = _e2455;
                                        } else {
                                            phi_4038_ = _e2426.member[2];
                                        }
                                        let _e2467 = phi_4038_;
                                        let _e2470 = (_e2426.member_2[0] - _e2459);
                                        let _e2472 = (_e2426.member_2[1] - _e2463);
                                        let _e2474 = (_e2426.member_2[2] - _e2467);
                                        let _e2476 = (_e2459 - _e2426.member[0]);
                                        let _e2478 = (_e2463 - _e2426.member[1]);
                                        let _e2480 = (_e2467 - _e2426.member[2]);
                                        if (_e2470 > _e2476) {
                                            phi_4056_ = _e2470;
                                        } else {
                                            phi_4056_ = _e2476;
                                        }
                                        let _e2483 = phi_4056_;
                                        if (_e2472 > _e2478) {
                                            phi_4061_ = _e2472;
                                        } else {
                                            phi_4061_ = _e2478;
                                        }
                                        let _e2486 = phi_4061_;
                                        if (_e2474 > _e2480) {
                                            phi_4066_ = _e2474;
                                        } else {
                                            phi_4066_ = _e2480;
                                        }
                                        let _e2489 = phi_4066_;
                                        let _e2491 = (1f + (0.000000059604645f * 4f));
                                        let _e2495 = (0.000000000000000000000000000000000000011754944f * 8f);
                                        phi_4082_ = type_31(array<f32, 3>(_e2459, _e2463, _e2467), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e2483 * _e2491) + _e2495), ((_e2486 * _e2491) + _e2495), ((_e2489 * _e2491) + _e2495)));
                                    }
                                    let _e2542 = phi_4082_;
                                    if (_e2411[1] < _e2352) {
                                        let _e2622 = oriented.member[(_e2368 + _e2411[1])];
                                        phi_4226_ = type_31(array<f32, 3>(_e2622.member.x, _e2622.member.y, _e2622.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e2622.member.w, _e2622.member_1.x, _e2622.member_1.y), array<f32, 3>(_e2622.member_1.z, _e2622.member_1.w, _e2622.member_2.x), array<f32, 3>(_e2622.member_2.y, _e2622.member_2.z, _e2622.member_2.w)), array<f32, 3>(_e2622.member_3.x, _e2622.member_3.y, _e2622.member_3.z));
                                    } else {
                                        let _e2545 = b_nodes.member[_e2411[1]];
                                        let _e2560 = ((_e2545.member[0] * 0.5f) + (_e2545.member_2[0] * 0.5f));
                                        let _e2561 = ((_e2545.member[1] * 0.5f) + (_e2545.member_2[1] * 0.5f));
                                        let _e2562 = ((_e2545.member[2] * 0.5f) + (_e2545.member_2[2] * 0.5f));
                                        if (_e2560 < _e2545.member_2[0]) {
                                            phi_4152_ = _e2560;
                                        } else {
                                            phi_4152_ = _e2545.member_2[0];
                                        }
                                        let _e2566 = phi_4152_;
                                        if (_e2561 < _e2545.member_2[1]) {
                                            phi_4158_ = _e2561;
                                        } else {
                                            phi_4158_ = _e2545.member_2[1];
                                        }
                                        let _e2570 = phi_4158_;
                                        if (_e2562 < _e2545.member_2[2]) {
                                            phi_4164_ = _e2562;
                                        } else {
                                            phi_4164_ = _e2545.member_2[2];
                                        }
                                        let _e2574 = phi_4164_;
                                        if (_e2566 > _e2545.member[0]) {
                                            phi_4170_ = _e2566;
                                        } else {
                                            phi_4170_ = _e2545.member[0];
                                        }
                                        let _e2578 = phi_4170_;
                                        if (_e2570 > _e2545.member[1]) {
                                            phi_4176_ = _e2570;
                                        } else {
                                            phi_4176_ = _e2545.member[1];
                                        }
                                        let _e2582 = phi_4176_;
                                        if (_e2574 > _e2545.member[2]) {
                                            phi_4182_ = _e2574;
                                        } else {
                                            phi_4182_ = _e2545.member[2];
                                        }
                                        let _e2586 = phi_4182_;
                                        let _e2589 = (_e2545.member_2[0] - _e2578);
                                        let _e2591 = (_e2545.member_2[1] - _e2582);
                                        let _e2593 = (_e2545.member_2[2] - _e2586);
                                        let _e2595 = (_e2578 - _e2545.member[0]);
                                        let _e2597 = (_e2582 - _e2545.member[1]);
                                        let _e2599 = (_e2586 - _e2545.member[2]);
                                        if (_e2589 > _e2595) {
                                            phi_4200_ = _e2589;
                                        } else {
                                            phi_4200_ = _e2595;
                                        }
                                        let _e2602 = phi_4200_;
                                        if (_e2591 > _e2597) {
                                            phi_4205_ = _e2591;
                                        } else {
                                            phi_4205_ = _e2597;
                                        }
                                        let _e2605 = phi_4205_;
                                        if (_e2593 > _e2599) {
                                            phi_4210_ = _e2593;
                                        } else {
                                            phi_4210_ = _e2599;
                                        }
                                        let _e2608 = phi_4210_;
                                        let _e2610 = (1f + (0.000000059604645f * 4f));
                                        let _e2614 = (0.000000000000000000000000000000000000011754944f * 8f);
                                        phi_4226_ = type_31(array<f32, 3>(_e2578, _e2582, _e2586), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e2602 * _e2610) + _e2614), ((_e2605 * _e2610) + _e2614), ((_e2608 * _e2610) + _e2614)));
                                    }
                                    let _e2661 = phi_4226_;
                                    let _e2666 = (_e2661.member[0] - _e2542.member[0]);
                                    let _e2669 = (_e2661.member[1] - _e2542.member[1]);
                                    let _e2672 = (_e2661.member[2] - _e2542.member[2]);
                                    if (_e2666 < 0f) {
                                        phi_4416_ = -(_e2666);
                                    } else {
                                        phi_4416_ = _e2666;
                                    }
                                    let _e2861 = phi_4416_;
                                    if (_e2669 < 0f) {
                                        phi_4422_ = -(_e2669);
                                    } else {
                                        phi_4422_ = _e2669;
                                    }
                                    let _e2865 = phi_4422_;
                                    if (_e2672 < 0f) {
                                        phi_4429_ = -(_e2672);
                                    } else {
                                        phi_4429_ = _e2672;
                                    }
                                    let _e2870 = phi_4429_;
                                    if (_e2542.member_2[0] < 0f) {
                                        phi_4438_ = -(_e2542.member_2[0]);
                                    } else {
                                        phi_4438_ = _e2542.member_2[0];
                                    }
                                    let _e2877 = phi_4438_;
                                    if (_e2542.member_2[1] < 0f) {
                                        phi_4445_ = -(_e2542.member_2[1]);
                                    } else {
                                        phi_4445_ = _e2542.member_2[1];
                                    }
                                    let _e2882 = phi_4445_;
                                    if (_e2542.member_2[2] < 0f) {
                                        phi_4453_ = -(_e2542.member_2[2]);
                                    } else {
                                        phi_4453_ = _e2542.member_2[2];
                                    }
                                    let _e2888 = phi_4453_;
                                    if (_e2661.member_2[0] < 0f) {
                                        phi_4462_ = -(_e2661.member_2[0]);
                                    } else {
                                        phi_4462_ = _e2661.member_2[0];
                                    }
                                    let _e2895 = phi_4462_;
                                    if (_e2661.member_2[1] < 0f) {
                                        phi_4469_ = -(_e2661.member_2[1]);
                                    } else {
                                        phi_4469_ = _e2661.member_2[1];
                                    }
                                    let _e2900 = phi_4469_;
                                    if (_e2661.member_2[2] < 0f) {
                                        phi_4477_ = -(_e2661.member_2[2]);
                                    } else {
                                        phi_4477_ = _e2661.member_2[2];
                                    }
                                    let _e2906 = phi_4477_;
                                    local = type_26(array<array<f32, 3>, 3>(array<f32, 3>((((_e2661.member_1[0][0] * _e2542.member_1[0][0]) + (_e2661.member_1[0][1] * _e2542.member_1[0][1])) + (_e2661.member_1[0][2] * _e2542.member_1[0][2])), (((_e2661.member_1[1][0] * _e2542.member_1[0][0]) + (_e2661.member_1[1][1] * _e2542.member_1[0][1])) + (_e2661.member_1[1][2] * _e2542.member_1[0][2])), (((_e2661.member_1[2][0] * _e2542.member_1[0][0]) + (_e2661.member_1[2][1] * _e2542.member_1[0][1])) + (_e2661.member_1[2][2] * _e2542.member_1[0][2]))), array<f32, 3>((((_e2661.member_1[0][0] * _e2542.member_1[1][0]) + (_e2661.member_1[0][1] * _e2542.member_1[1][1])) + (_e2661.member_1[0][2] * _e2542.member_1[1][2])), (((_e2661.member_1[1][0] * _e2542.member_1[1][0]) + (_e2661.member_1[1][1] * _e2542.member_1[1][1])) + (_e2661.member_1[1][2] * _e2542.member_1[1][2])), (((_e2661.member_1[2][0] * _e2542.member_1[1][0]) + (_e2661.member_1[2][1] * _e2542.member_1[1][1])) + (_e2661.member_1[2][2] * _e2542.member_1[1][2]))), array<f32, 3>((((_e2661.member_1[0][0] * _e2542.member_1[2][0]) + (_e2661.member_1[0][1] * _e2542.member_1[2][1])) + (_e2661.member_1[0][2] * _e2542.member_1[2][2])), (((_e2661.member_1[1][0] * _e2542.member_1[2][0]) + (_e2661.member_1[1][1] * _e2542.member_1[2][1])) + (_e2661.member_1[1][2] * _e2542.member_1[2][2])), (((_e2661.member_1[2][0] * _e2542.member_1[2][0]) + (_e2661.member_1[2][1] * _e2542.member_1[2][1])) + (_e2661.member_1[2][2] * _e2542.member_1[2][2])))), array<f32, 3>((((_e2542.member_1[0][0] * _e2666) + (_e2542.member_1[0][1] * _e2669)) + (_e2542.member_1[0][2] * _e2672)), (((_e2542.member_1[1][0] * _e2666) + (_e2542.member_1[1][1] * _e2669)) + (_e2542.member_1[1][2] * _e2672)), (((_e2542.member_1[2][0] * _e2666) + (_e2542.member_1[2][1] * _e2669)) + (_e2542.member_1[2][2] * _e2672))), array<f32, 3>((((_e2661.member_1[0][0] * _e2666) + (_e2661.member_1[0][1] * _e2669)) + (_e2661.member_1[0][2] * _e2672)), (((_e2661.member_1[1][0] * _e2666) + (_e2661.member_1[1][1] * _e2669)) + (_e2661.member_1[1][2] * _e2672)), (((_e2661.member_1[2][0] * _e2666) + (_e2661.member_1[2][1] * _e2669)) + (_e2661.member_1[2][2] * _e2672))), array<f32, 3>(_e2542.member_2[0], _e2542.member_2[1], _e2542.member_2[2]), array<f32, 3>(_e2661.member_2[0], _e2661.member_2[1], _e2661.member_2[2]), ((((((_e2861 + _e2865) + _e2870) + (((_e2877 + _e2882) + _e2888) + ((_e2895 + _e2900) + _e2906))) * 2f) * (0.000000059604645f * 128f)) + (0.000000000000000000000000000000000000011754944f * 128f)));
                                    let _e2933 = local.member[0u][0u];
                                    let _e2937 = local.member[0u][1u];
                                    let _e2941 = local.member[0u][2u];
                                    let _e2945 = local.member[1u][0u];
                                    let _e2949 = local.member[1u][1u];
                                    let _e2953 = local.member[1u][2u];
                                    let _e2957 = local.member[2u][0u];
                                    let _e2961 = local.member[2u][1u];
                                    let _e2965 = local.member[2u][2u];
                                    let _e2967 = local.member_3;
                                    let _e2972 = local.member_4;
                                    let _e2978 = local.member_1[0u];
                                    if (_e2978 < 0f) {
                                        phi_4570_ = -(_e2978);
                                    } else {
                                        phi_4570_ = _e2978;
                                    }
                                    let _e2982 = phi_4570_;
                                    if (_e2933 < 0f) {
                                        phi_4577_ = -(_e2933);
                                    } else {
                                        phi_4577_ = _e2933;
                                    }
                                    let _e2986 = phi_4577_;
                                    if (_e2937 < 0f) {
                                        phi_4583_ = -(_e2937);
                                    } else {
                                        phi_4583_ = _e2937;
                                    }
                                    let _e2990 = phi_4583_;
                                    if (_e2941 < 0f) {
                                        phi_4589_ = -(_e2941);
                                    } else {
                                        phi_4589_ = _e2941;
                                    }
                                    let _e2994 = phi_4589_;
                                    let _e3001 = (_e2982 - (_e2967[0] + (((_e2986 * _e2972[0]) + (_e2990 * _e2972[1])) + (_e2994 * _e2972[2]))));
                                    let _e3004 = local.member_1[1u];
                                    if (_e3004 < 0f) {
                                        phi_4608_ = -(_e3004);
                                    } else {
                                        phi_4608_ = _e3004;
                                    }
                                    let _e3008 = phi_4608_;
                                    if (_e2945 < 0f) {
                                        phi_4615_ = -(_e2945);
                                    } else {
                                        phi_4615_ = _e2945;
                                    }
                                    let _e3012 = phi_4615_;
                                    if (_e2949 < 0f) {
                                        phi_4621_ = -(_e2949);
                                    } else {
                                        phi_4621_ = _e2949;
                                    }
                                    let _e3016 = phi_4621_;
                                    if (_e2953 < 0f) {
                                        phi_4627_ = -(_e2953);
                                    } else {
                                        phi_4627_ = _e2953;
                                    }
                                    let _e3020 = phi_4627_;
                                    let _e3027 = (_e3008 - (_e2967[1] + (((_e3012 * _e2972[0]) + (_e3016 * _e2972[1])) + (_e3020 * _e2972[2]))));
                                    let _e3030 = local.member_1[2u];
                                    if (_e3030 < 0f) {
                                        phi_4646_ = -(_e3030);
                                    } else {
                                        phi_4646_ = _e3030;
                                    }
                                    let _e3034 = phi_4646_;
                                    if (_e2957 < 0f) {
                                        phi_4653_ = -(_e2957);
                                    } else {
                                        phi_4653_ = _e2957;
                                    }
                                    let _e3038 = phi_4653_;
                                    if (_e2961 < 0f) {
                                        phi_4659_ = -(_e2961);
                                    } else {
                                        phi_4659_ = _e2961;
                                    }
                                    let _e3042 = phi_4659_;
                                    if (_e2965 < 0f) {
                                        phi_4665_ = -(_e2965);
                                    } else {
                                        phi_4665_ = _e2965;
                                    }
                                    let _e3046 = phi_4665_;
                                    let _e3053 = (_e3034 - (_e2967[2] + (((_e3038 * _e2972[0]) + (_e3042 * _e2972[1])) + (_e3046 * _e2972[2]))));
                                    let _e3056 = local.member_2[0u];
                                    if (_e3056 < 0f) {
                                        phi_4684_ = -(_e3056);
                                    } else {
                                        phi_4684_ = _e3056;
                                    }
                                    let _e3060 = phi_4684_;
                                    if (_e2933 < 0f) {
                                        phi_4691_ = -(_e2933);
                                    } else {
                                        phi_4691_ = _e2933;
                                    }
                                    let _e3064 = phi_4691_;
                                    if (_e2945 < 0f) {
                                        phi_4697_ = -(_e2945);
                                    } else {
                                        phi_4697_ = _e2945;
                                    }
                                    let _e3068 = phi_4697_;
                                    if (_e2957 < 0f) {
                                        phi_4703_ = -(_e2957);
                                    } else {
                                        phi_4703_ = _e2957;
                                    }
                                    let _e3072 = phi_4703_;
                                    let _e3079 = (_e3060 - (_e2972[0] + (((_e3064 * _e2967[0]) + (_e3068 * _e2967[1])) + (_e3072 * _e2967[2]))));
                                    let _e3082 = local.member_2[1u];
                                    if (_e3082 < 0f) {
                                        phi_4722_ = -(_e3082);
                                    } else {
                                        phi_4722_ = _e3082;
                                    }
                                    let _e3086 = phi_4722_;
                                    if (_e2937 < 0f) {
                                        phi_4729_ = -(_e2937);
                                    } else {
                                        phi_4729_ = _e2937;
                                    }
                                    let _e3090 = phi_4729_;
                                    if (_e2949 < 0f) {
                                        phi_4735_ = -(_e2949);
                                    } else {
                                        phi_4735_ = _e2949;
                                    }
                                    let _e3094 = phi_4735_;
                                    if (_e2961 < 0f) {
                                        phi_4741_ = -(_e2961);
                                    } else {
                                        phi_4741_ = _e2961;
                                    }
                                    let _e3098 = phi_4741_;
                                    let _e3105 = (_e3086 - (_e2972[1] + (((_e3090 * _e2967[0]) + (_e3094 * _e2967[1])) + (_e3098 * _e2967[2]))));
                                    let _e3108 = local.member_2[2u];
                                    if (_e3108 < 0f) {
                                        phi_4760_ = -(_e3108);
                                    } else {
                                        phi_4760_ = _e3108;
                                    }
                                    let _e3112 = phi_4760_;
                                    if (_e2941 < 0f) {
                                        phi_4767_ = -(_e2941);
                                    } else {
                                        phi_4767_ = _e2941;
                                    }
                                    let _e3116 = phi_4767_;
                                    if (_e2953 < 0f) {
                                        phi_4773_ = -(_e2953);
                                    } else {
                                        phi_4773_ = _e2953;
                                    }
                                    let _e3120 = phi_4773_;
                                    if (_e2965 < 0f) {
                                        phi_4779_ = -(_e2965);
                                    } else {
                                        phi_4779_ = _e2965;
                                    }
                                    let _e3124 = phi_4779_;
                                    let _e3131 = (_e3112 - (_e2972[2] + (((_e3116 * _e2967[0]) + (_e3120 * _e2967[1])) + (_e3124 * _e2967[2]))));
                                    if (_e3001 > _e3027) {
                                        phi_4794_ = _e3001;
                                    } else {
                                        phi_4794_ = _e3027;
                                    }
                                    let _e3134 = phi_4794_;
                                    if (_e3134 > _e3053) {
                                        phi_4799_ = _e3134;
                                    } else {
                                        phi_4799_ = _e3053;
                                    }
                                    let _e3137 = phi_4799_;
                                    if (_e3079 > _e3105) {
                                        phi_4804_ = _e3079;
                                    } else {
                                        phi_4804_ = _e3105;
                                    }
                                    let _e3140 = phi_4804_;
                                    if (_e3140 > _e3131) {
                                        phi_4809_ = _e3140;
                                    } else {
                                        phi_4809_ = _e3131;
                                    }
                                    let _e3143 = phi_4809_;
                                    if (_e3137 > _e3143) {
                                        phi_4814_ = _e3137;
                                    } else {
                                        phi_4814_ = _e3143;
                                    }
                                    let _e3146 = phi_4814_;
                                    let _e3148 = local.member_5;
                                    if (_e3146 > _e3148) {
                                        phi_6127_ = true;
                                    } else {
                                        let _e3153 = local.member[1u][0u];
                                        let _e3156 = local.member_1[2u];
                                        let _e3161 = local.member[2u][0u];
                                        let _e3164 = local.member_1[1u];
                                        let _e3166 = ((_e3153 * _e3156) - (_e3161 * _e3164));
                                        let _e3170 = local.member[2u][0u];
                                        if (_e3170 < 0f) {
                                            phi_4873_ = -(_e3170);
                                        } else {
                                            phi_4873_ = _e3170;
                                        }
                                        let _e3174 = phi_4873_;
                                        let _e3177 = local.member_3[1u];
                                        let _e3182 = local.member[1u][0u];
                                        if (_e3182 < 0f) {
                                            phi_4896_ = -(_e3182);
                                        } else {
                                            phi_4896_ = _e3182;
                                        }
                                        let _e3186 = phi_4896_;
                                        let _e3189 = local.member_3[2u];
                                        let _e3195 = local.member[0u][2u];
                                        if (_e3195 < 0f) {
                                            phi_4919_ = -(_e3195);
                                        } else {
                                            phi_4919_ = _e3195;
                                        }
                                        let _e3199 = phi_4919_;
                                        let _e3202 = local.member_4[1u];
                                        let _e3207 = local.member[0u][1u];
                                        if (_e3207 < 0f) {
                                            phi_4941_ = -(_e3207);
                                        } else {
                                            phi_4941_ = _e3207;
                                        }
                                        let _e3211 = phi_4941_;
                                        let _e3214 = local.member_4[2u];
                                        if (_e3166 < 0f) {
                                            phi_4957_ = -(_e3166);
                                        } else {
                                            phi_4957_ = _e3166;
                                        }
                                        let _e3220 = phi_4957_;
                                        let _e3222 = (_e3220 - (((_e3174 * _e3177) + (_e3186 * _e3189)) + ((_e3199 * _e3202) + (_e3211 * _e3214))));
                                        let _e3226 = local.member[1u][1u];
                                        let _e3229 = local.member_1[2u];
                                        let _e3234 = local.member[2u][1u];
                                        let _e3237 = local.member_1[1u];
                                        let _e3239 = ((_e3226 * _e3229) - (_e3234 * _e3237));
                                        let _e3243 = local.member[2u][1u];
                                        if (_e3243 < 0f) {
                                            phi_5012_ = -(_e3243);
                                        } else {
                                            phi_5012_ = _e3243;
                                        }
                                        let _e3247 = phi_5012_;
                                        let _e3250 = local.member_3[1u];
                                        let _e3255 = local.member[1u][1u];
                                        if (_e3255 < 0f) {
                                            phi_5035_ = -(_e3255);
                                        } else {
                                            phi_5035_ = _e3255;
                                        }
                                        let _e3259 = phi_5035_;
                                        let _e3262 = local.member_3[2u];
                                        let _e3268 = local.member[0u][0u];
                                        if (_e3268 < 0f) {
                                            phi_5058_ = -(_e3268);
                                        } else {
                                            phi_5058_ = _e3268;
                                        }
                                        let _e3272 = phi_5058_;
                                        let _e3275 = local.member_4[2u];
                                        let _e3280 = local.member[0u][2u];
                                        if (_e3280 < 0f) {
                                            phi_5080_ = -(_e3280);
                                        } else {
                                            phi_5080_ = _e3280;
                                        }
                                        let _e3284 = phi_5080_;
                                        let _e3287 = local.member_4[0u];
                                        if (_e3239 < 0f) {
                                            phi_5096_ = -(_e3239);
                                        } else {
                                            phi_5096_ = _e3239;
                                        }
                                        let _e3293 = phi_5096_;
                                        let _e3295 = (_e3293 - (((_e3247 * _e3250) + (_e3259 * _e3262)) + ((_e3272 * _e3275) + (_e3284 * _e3287))));
                                        let _e3299 = local.member[1u][2u];
                                        let _e3302 = local.member_1[2u];
                                        let _e3307 = local.member[2u][2u];
                                        let _e3310 = local.member_1[1u];
                                        let _e3312 = ((_e3299 * _e3302) - (_e3307 * _e3310));
                                        let _e3316 = local.member[2u][2u];
                                        if (_e3316 < 0f) {
                                            phi_5151_ = -(_e3316);
                                        } else {
                                            phi_5151_ = _e3316;
                                        }
                                        let _e3320 = phi_5151_;
                                        let _e3323 = local.member_3[1u];
                                        let _e3328 = local.member[1u][2u];
                                        if (_e3328 < 0f) {
                                            phi_5174_ = -(_e3328);
                                        } else {
                                            phi_5174_ = _e3328;
                                        }
                                        let _e3332 = phi_5174_;
                                        let _e3335 = local.member_3[2u];
                                        let _e3341 = local.member[0u][1u];
                                        if (_e3341 < 0f) {
                                            phi_5197_ = -(_e3341);
                                        } else {
                                            phi_5197_ = _e3341;
                                        }
                                        let _e3345 = phi_5197_;
                                        let _e3348 = local.member_4[0u];
                                        let _e3353 = local.member[0u][0u];
                                        if (_e3353 < 0f) {
                                            phi_5219_ = -(_e3353);
                                        } else {
                                            phi_5219_ = _e3353;
                                        }
                                        let _e3357 = phi_5219_;
                                        let _e3360 = local.member_4[1u];
                                        if (_e3312 < 0f) {
                                            phi_5235_ = -(_e3312);
                                        } else {
                                            phi_5235_ = _e3312;
                                        }
                                        let _e3366 = phi_5235_;
                                        let _e3368 = (_e3366 - (((_e3320 * _e3323) + (_e3332 * _e3335)) + ((_e3345 * _e3348) + (_e3357 * _e3360))));
                                        let _e3372 = local.member[2u][0u];
                                        let _e3375 = local.member_1[0u];
                                        let _e3380 = local.member[0u][0u];
                                        let _e3383 = local.member_1[2u];
                                        let _e3385 = ((_e3372 * _e3375) - (_e3380 * _e3383));
                                        let _e3389 = local.member[0u][0u];
                                        if (_e3389 < 0f) {
                                            phi_5290_ = -(_e3389);
                                        } else {
                                            phi_5290_ = _e3389;
                                        }
                                        let _e3393 = phi_5290_;
                                        let _e3396 = local.member_3[2u];
                                        let _e3401 = local.member[2u][0u];
                                        if (_e3401 < 0f) {
                                            phi_5313_ = -(_e3401);
                                        } else {
                                            phi_5313_ = _e3401;
                                        }
                                        let _e3405 = phi_5313_;
                                        let _e3408 = local.member_3[0u];
                                        let _e3414 = local.member[1u][2u];
                                        if (_e3414 < 0f) {
                                            phi_5337_ = -(_e3414);
                                        } else {
                                            phi_5337_ = _e3414;
                                        }
                                        let _e3418 = phi_5337_;
                                        let _e3421 = local.member_4[1u];
                                        let _e3426 = local.member[1u][1u];
                                        if (_e3426 < 0f) {
                                            phi_5360_ = -(_e3426);
                                        } else {
                                            phi_5360_ = _e3426;
                                        }
                                        let _e3430 = phi_5360_;
                                        let _e3433 = local.member_4[2u];
                                        if (_e3385 < 0f) {
                                            phi_5376_ = -(_e3385);
                                        } else {
                                            phi_5376_ = _e3385;
                                        }
                                        let _e3439 = phi_5376_;
                                        let _e3441 = (_e3439 - (((_e3393 * _e3396) + (_e3405 * _e3408)) + ((_e3418 * _e3421) + (_e3430 * _e3433))));
                                        let _e3445 = local.member[2u][1u];
                                        let _e3448 = local.member_1[0u];
                                        let _e3453 = local.member[0u][1u];
                                        let _e3456 = local.member_1[2u];
                                        let _e3458 = ((_e3445 * _e3448) - (_e3453 * _e3456));
                                        let _e3462 = local.member[0u][1u];
                                        if (_e3462 < 0f) {
                                            phi_5431_ = -(_e3462);
                                        } else {
                                            phi_5431_ = _e3462;
                                        }
                                        let _e3466 = phi_5431_;
                                        let _e3469 = local.member_3[2u];
                                        let _e3474 = local.member[2u][1u];
                                        if (_e3474 < 0f) {
                                            phi_5454_ = -(_e3474);
                                        } else {
                                            phi_5454_ = _e3474;
                                        }
                                        let _e3478 = phi_5454_;
                                        let _e3481 = local.member_3[0u];
                                        let _e3487 = local.member[1u][0u];
                                        if (_e3487 < 0f) {
                                            phi_5478_ = -(_e3487);
                                        } else {
                                            phi_5478_ = _e3487;
                                        }
                                        let _e3491 = phi_5478_;
                                        let _e3494 = local.member_4[2u];
                                        let _e3499 = local.member[1u][2u];
                                        if (_e3499 < 0f) {
                                            phi_5501_ = -(_e3499);
                                        } else {
                                            phi_5501_ = _e3499;
                                        }
                                        let _e3503 = phi_5501_;
                                        let _e3506 = local.member_4[0u];
                                        if (_e3458 < 0f) {
                                            phi_5517_ = -(_e3458);
                                        } else {
                                            phi_5517_ = _e3458;
                                        }
                                        let _e3512 = phi_5517_;
                                        let _e3514 = (_e3512 - (((_e3466 * _e3469) + (_e3478 * _e3481)) + ((_e3491 * _e3494) + (_e3503 * _e3506))));
                                        let _e3518 = local.member[2u][2u];
                                        let _e3521 = local.member_1[0u];
                                        let _e3526 = local.member[0u][2u];
                                        let _e3529 = local.member_1[2u];
                                        let _e3531 = ((_e3518 * _e3521) - (_e3526 * _e3529));
                                        let _e3535 = local.member[0u][2u];
                                        if (_e3535 < 0f) {
                                            phi_5572_ = -(_e3535);
                                        } else {
                                            phi_5572_ = _e3535;
                                        }
                                        let _e3539 = phi_5572_;
                                        let _e3542 = local.member_3[2u];
                                        let _e3547 = local.member[2u][2u];
                                        if (_e3547 < 0f) {
                                            phi_5595_ = -(_e3547);
                                        } else {
                                            phi_5595_ = _e3547;
                                        }
                                        let _e3551 = phi_5595_;
                                        let _e3554 = local.member_3[0u];
                                        let _e3560 = local.member[1u][1u];
                                        if (_e3560 < 0f) {
                                            phi_5619_ = -(_e3560);
                                        } else {
                                            phi_5619_ = _e3560;
                                        }
                                        let _e3564 = phi_5619_;
                                        let _e3567 = local.member_4[0u];
                                        let _e3572 = local.member[1u][0u];
                                        if (_e3572 < 0f) {
                                            phi_5642_ = -(_e3572);
                                        } else {
                                            phi_5642_ = _e3572;
                                        }
                                        let _e3576 = phi_5642_;
                                        let _e3579 = local.member_4[1u];
                                        if (_e3531 < 0f) {
                                            phi_5658_ = -(_e3531);
                                        } else {
                                            phi_5658_ = _e3531;
                                        }
                                        let _e3585 = phi_5658_;
                                        let _e3587 = (_e3585 - (((_e3539 * _e3542) + (_e3551 * _e3554)) + ((_e3564 * _e3567) + (_e3576 * _e3579))));
                                        let _e3591 = local.member[0u][0u];
                                        let _e3594 = local.member_1[1u];
                                        let _e3599 = local.member[1u][0u];
                                        let _e3602 = local.member_1[0u];
                                        let _e3604 = ((_e3591 * _e3594) - (_e3599 * _e3602));
                                        let _e3608 = local.member[1u][0u];
                                        if (_e3608 < 0f) {
                                            phi_5713_ = -(_e3608);
                                        } else {
                                            phi_5713_ = _e3608;
                                        }
                                        let _e3612 = phi_5713_;
                                        let _e3615 = local.member_3[0u];
                                        let _e3620 = local.member[0u][0u];
                                        if (_e3620 < 0f) {
                                            phi_5736_ = -(_e3620);
                                        } else {
                                            phi_5736_ = _e3620;
                                        }
                                        let _e3624 = phi_5736_;
                                        let _e3627 = local.member_3[1u];
                                        let _e3633 = local.member[2u][2u];
                                        if (_e3633 < 0f) {
                                            phi_5760_ = -(_e3633);
                                        } else {
                                            phi_5760_ = _e3633;
                                        }
                                        let _e3637 = phi_5760_;
                                        let _e3640 = local.member_4[1u];
                                        let _e3645 = local.member[2u][1u];
                                        if (_e3645 < 0f) {
                                            phi_5783_ = -(_e3645);
                                        } else {
                                            phi_5783_ = _e3645;
                                        }
                                        let _e3649 = phi_5783_;
                                        let _e3652 = local.member_4[2u];
                                        if (_e3604 < 0f) {
                                            phi_5799_ = -(_e3604);
                                        } else {
                                            phi_5799_ = _e3604;
                                        }
                                        let _e3658 = phi_5799_;
                                        let _e3660 = (_e3658 - (((_e3612 * _e3615) + (_e3624 * _e3627)) + ((_e3637 * _e3640) + (_e3649 * _e3652))));
                                        let _e3664 = local.member[0u][1u];
                                        let _e3667 = local.member_1[1u];
                                        let _e3672 = local.member[1u][1u];
                                        let _e3675 = local.member_1[0u];
                                        let _e3677 = ((_e3664 * _e3667) - (_e3672 * _e3675));
                                        let _e3681 = local.member[1u][1u];
                                        if (_e3681 < 0f) {
                                            phi_5854_ = -(_e3681);
                                        } else {
                                            phi_5854_ = _e3681;
                                        }
                                        let _e3685 = phi_5854_;
                                        let _e3688 = local.member_3[0u];
                                        let _e3693 = local.member[0u][1u];
                                        if (_e3693 < 0f) {
                                            phi_5877_ = -(_e3693);
                                        } else {
                                            phi_5877_ = _e3693;
                                        }
                                        let _e3697 = phi_5877_;
                                        let _e3700 = local.member_3[1u];
                                        let _e3706 = local.member[2u][0u];
                                        if (_e3706 < 0f) {
                                            phi_5901_ = -(_e3706);
                                        } else {
                                            phi_5901_ = _e3706;
                                        }
                                        let _e3710 = phi_5901_;
                                        let _e3713 = local.member_4[2u];
                                        let _e3718 = local.member[2u][2u];
                                        if (_e3718 < 0f) {
                                            phi_5924_ = -(_e3718);
                                        } else {
                                            phi_5924_ = _e3718;
                                        }
                                        let _e3722 = phi_5924_;
                                        let _e3725 = local.member_4[0u];
                                        if (_e3677 < 0f) {
                                            phi_5940_ = -(_e3677);
                                        } else {
                                            phi_5940_ = _e3677;
                                        }
                                        let _e3731 = phi_5940_;
                                        let _e3733 = (_e3731 - (((_e3685 * _e3688) + (_e3697 * _e3700)) + ((_e3710 * _e3713) + (_e3722 * _e3725))));
                                        let _e3737 = local.member[0u][2u];
                                        let _e3740 = local.member_1[1u];
                                        let _e3745 = local.member[1u][2u];
                                        let _e3748 = local.member_1[0u];
                                        let _e3750 = ((_e3737 * _e3740) - (_e3745 * _e3748));
                                        let _e3754 = local.member[1u][2u];
                                        if (_e3754 < 0f) {
                                            phi_5995_ = -(_e3754);
                                        } else {
                                            phi_5995_ = _e3754;
                                        }
                                        let _e3758 = phi_5995_;
                                        let _e3761 = local.member_3[0u];
                                        let _e3766 = local.member[0u][2u];
                                        if (_e3766 < 0f) {
                                            phi_6018_ = -(_e3766);
                                        } else {
                                            phi_6018_ = _e3766;
                                        }
                                        let _e3770 = phi_6018_;
                                        let _e3773 = local.member_3[1u];
                                        let _e3779 = local.member[2u][1u];
                                        if (_e3779 < 0f) {
                                            phi_6042_ = -(_e3779);
                                        } else {
                                            phi_6042_ = _e3779;
                                        }
                                        let _e3783 = phi_6042_;
                                        let _e3786 = local.member_4[0u];
                                        let _e3791 = local.member[2u][0u];
                                        if (_e3791 < 0f) {
                                            phi_6065_ = -(_e3791);
                                        } else {
                                            phi_6065_ = _e3791;
                                        }
                                        let _e3795 = phi_6065_;
                                        let _e3798 = local.member_4[1u];
                                        if (_e3750 < 0f) {
                                            phi_6081_ = -(_e3750);
                                        } else {
                                            phi_6081_ = _e3750;
                                        }
                                        let _e3804 = phi_6081_;
                                        let _e3806 = (_e3804 - (((_e3758 * _e3761) + (_e3770 * _e3773)) + ((_e3783 * _e3786) + (_e3795 * _e3798))));
                                        if (_e3222 > _e3295) {
                                            phi_6088_ = _e3222;
                                        } else {
                                            phi_6088_ = _e3295;
                                        }
                                        let _e3809 = phi_6088_;
                                        if (_e3809 > _e3368) {
                                            phi_6093_ = _e3809;
                                        } else {
                                            phi_6093_ = _e3368;
                                        }
                                        let _e3812 = phi_6093_;
                                        if (_e3441 > _e3514) {
                                            phi_6098_ = _e3441;
                                        } else {
                                            phi_6098_ = _e3514;
                                        }
                                        let _e3815 = phi_6098_;
                                        if (_e3815 > _e3587) {
                                            phi_6103_ = _e3815;
                                        } else {
                                            phi_6103_ = _e3587;
                                        }
                                        let _e3818 = phi_6103_;
                                        if (_e3812 > _e3818) {
                                            phi_6108_ = _e3812;
                                        } else {
                                            phi_6108_ = _e3818;
                                        }
                                        let _e3821 = phi_6108_;
                                        if (_e3660 > _e3733) {
                                            phi_6113_ = _e3660;
                                        } else {
                                            phi_6113_ = _e3733;
                                        }
                                        let _e3824 = phi_6113_;
                                        if (_e3824 > _e3806) {
                                            phi_6118_ = _e3824;
                                        } else {
                                            phi_6118_ = _e3806;
                                        }
                                        let _e3827 = phi_6118_;
                                        if (_e3821 > _e3827) {
                                            phi_6123_ = _e3821;
                                        } else {
                                            phi_6123_ = _e3827;
                                        }
                                        let _e3830 = phi_6123_;
                                        let _e3832 = local.member_5;
                                        phi_6127_ = (_e3830 > _e3832);
                                    }
                                    let _e3835 = phi_6127_;
                                    phi_6129_ = !(_e3835);
                                    phi_6130_ = false;
                                } else {
                                    phi_6129_ = bool();
                                    phi_6130_ = true;
                                }
                                let _e3838 = phi_6129_;
                                let _e3840 = phi_6130_;
                                phi_6131_ = _e3838;
                                phi_6132_ = _e3840;
                            }
                            let _e3842 = phi_6131_;
                            let _e3844 = phi_6132_;
                            if _e3844 {
                                phi_6136_ = true;
                            } else {
                                phi_6136_ = _e3842;
                            }
                            let _e3846 = phi_6136_;
                            if _e3846 {
                            } else {
                                local_1[_e2405.member_1] = array<u32, 2>(4294967295u, 4294967295u);
                            }
                        }
                    }
                    continue;
                    continuing {
                        phi_3869_ = _e2403;
                        break if !(_e2409);
                    }
                }
                let _e3849 = local_1;
                let _e3864 = params.member.member_2.member;
                if (_e3864 == 0u) {
                    phi_6175_ = array<u32, 2>(0u, 2u);
                } else {
                    phi_6175_ = array<u32, 2>(1u, 1u);
                }
                let _e3867 = phi_6175_;
                let _e3873 = params.member.member.member[_e3867[0]];
                let _e3878 = params.member.member.member[_e3867[1]];
                if (_e3849[0][0] == 4294967295u) {
                    phi_6217_ = 0u;
                } else {
                    if (_e3849[0][0] >= (_e3873 - 1u)) {
                        if (_e3849[0][1] >= (_e3878 - 1u)) {
                            phi_6211_ = false;
                        } else {
                            phi_6211_ = true;
                        }
                        let _e3884 = phi_6211_;
                        phi_6212_ = _e3884;
                    } else {
                        phi_6212_ = true;
                    }
                    let _e3886 = phi_6212_;
                    if _e3886 {
                        phi_6216_ = 1u;
                    } else {
                        phi_6216_ = 2u;
                    }
                    let _e3888 = phi_6216_;
                    phi_6217_ = _e3888;
                }
                let _e3890 = phi_6217_;
                if (_e3890 == 2u) {
                    let _e3938 = params.member.member_1.member_3;
                    let _e3940 = a_nodes.member[_e3849[0][0]];
                    let _e3943 = b_nodes.member[_e3849[0][1]];
                    let _e3947 = params.member.member_2.member;
                    if (_e3947 == 1u) {
                        if (_e3940.member_1 < _e3943.member_1) {
                            phi_6268_ = type_9(_e3940.member_1, _e3943.member_1);
                        } else {
                            phi_6268_ = type_9(_e3943.member_1, _e3940.member_1);
                        }
                        let _e3954 = phi_6268_;
                        phi_6273_ = _e3954;
                    } else {
                        phi_6273_ = type_9(_e3940.member_1, _e3943.member_1);
                    }
                    let _e3956 = phi_6273_;
                    let _e3960 = atomicAdd((&pairs.member[0u]), 1u);
                    if ((_e3960 + 1u) < _e3960) {
                        let _e3964 = atomicAdd((&pairs.member[2u]), 1u);
                    }
                    if (_e3960 < _e3938) {
                        let _e3966 = (2u * _e3960);
                        atomicStore((&pairs.member[(4u + _e3966)]), _e3956.member);
                        atomicStore((&pairs.member[(_e3966 + 5u)]), _e3956.member_1);
                    }
                } else {
                    if (_e3890 == 1u) {
                        let _e3895 = params.member.member_2.member_10;
                        let _e3897 = local_3.member_2;
                        if (64u < _e3895) {
                            phi_6313_ = 64u;
                        } else {
                            phi_6313_ = _e3895;
                        }
                        let _e3900 = phi_6313_;
                        let _e3901 = (_e3897 < _e3900);
                        if _e3901 {
                            let _e3903 = local_3.member_2;
                            local_3.member[_e3903] = _e3849[0][0];
                            let _e3907 = local_3.member_2;
                            local_3.member_1[_e3907] = _e3849[0][1];
                            let _e3912 = local_3.member_2;
                            local_3.member_2 = (_e3912 + 1u);
                        }
                        if _e3901 {
                        } else {
                            let _e3916 = params.member.member_1.member_1;
                            let _e3919 = atomicAdd((&rounds.member[(_e3916 + 1u)]), 1u);
                            let _e3922 = atomicMax((&output.member[0u]), (_e3919 + 1u));
                            if ((_e3919 + 1u) < _e3919) {
                                let _e3926 = atomicAdd((&output.member[2u]), 1u);
                            }
                            let _e3929 = params.member.member_2.member_3;
                            if (_e3919 < _e3929) {
                                let _e3931 = (2u * _e3919);
                                atomicStore((&output.member[(4u + _e3931)]), _e3849[0][0]);
                                atomicStore((&output.member[(_e3931 + 5u)]), _e3849[0][1]);
                            }
                        }
                    }
                }
                let _e3973 = params.member.member_2.member;
                if (_e3973 == 0u) {
                    phi_6392_ = array<u32, 2>(0u, 2u);
                } else {
                    phi_6392_ = array<u32, 2>(1u, 1u);
                }
                let _e3976 = phi_6392_;
                let _e3982 = params.member.member.member[_e3976[0]];
                let _e3987 = params.member.member.member[_e3976[1]];
                if (_e3849[1][0] == 4294967295u) {
                    phi_6434_ = 0u;
                } else {
                    if (_e3849[1][0] >= (_e3982 - 1u)) {
                        if (_e3849[1][1] >= (_e3987 - 1u)) {
                            phi_6428_ = false;
                        } else {
                            phi_6428_ = true;
                        }
                        let _e3993 = phi_6428_;
                        phi_6429_ = _e3993;
                    } else {
                        phi_6429_ = true;
                    }
                    let _e3995 = phi_6429_;
                    if _e3995 {
                        phi_6433_ = 1u;
                    } else {
                        phi_6433_ = 2u;
                    }
                    let _e3997 = phi_6433_;
                    phi_6434_ = _e3997;
                }
                let _e3999 = phi_6434_;
                if (_e3999 == 2u) {
                    let _e4047 = params.member.member_1.member_3;
                    let _e4049 = a_nodes.member[_e3849[1][0]];
                    let _e4052 = b_nodes.member[_e3849[1][1]];
                    let _e4056 = params.member.member_2.member;
                    if (_e4056 == 1u) {
                        if (_e4049.member_1 < _e4052.member_1) {
                            phi_6485_ = type_9(_e4049.member_1, _e4052.member_1);
                        } else {
                            phi_6485_ = type_9(_e4052.member_1, _e4049.member_1);
                        }
                        let _e4063 = phi_6485_;
                        phi_6490_ = _e4063;
                    } else {
                        phi_6490_ = type_9(_e4049.member_1, _e4052.member_1);
                    }
                    let _e4065 = phi_6490_;
                    let _e4069 = atomicAdd((&pairs.member[0u]), 1u);
                    if ((_e4069 + 1u) < _e4069) {
                        let _e4073 = atomicAdd((&pairs.member[2u]), 1u);
                    }
                    if (_e4069 < _e4047) {
                        let _e4075 = (2u * _e4069);
                        atomicStore((&pairs.member[(4u + _e4075)]), _e4065.member);
                        atomicStore((&pairs.member[(_e4075 + 5u)]), _e4065.member_1);
                    }
                } else {
                    if (_e3999 == 1u) {
                        let _e4004 = params.member.member_2.member_10;
                        let _e4006 = local_3.member_2;
                        if (64u < _e4004) {
                            phi_6530_ = 64u;
                        } else {
                            phi_6530_ = _e4004;
                        }
                        let _e4009 = phi_6530_;
                        let _e4010 = (_e4006 < _e4009);
                        if _e4010 {
                            let _e4012 = local_3.member_2;
                            local_3.member[_e4012] = _e3849[1][0];
                            let _e4016 = local_3.member_2;
                            local_3.member_1[_e4016] = _e3849[1][1];
                            let _e4021 = local_3.member_2;
                            local_3.member_2 = (_e4021 + 1u);
                        }
                        if _e4010 {
                        } else {
                            let _e4025 = params.member.member_1.member_1;
                            let _e4028 = atomicAdd((&rounds.member[(_e4025 + 1u)]), 1u);
                            let _e4031 = atomicMax((&output.member[0u]), (_e4028 + 1u));
                            if ((_e4028 + 1u) < _e4028) {
                                let _e4035 = atomicAdd((&output.member[2u]), 1u);
                            }
                            let _e4038 = params.member.member_2.member_3;
                            if (_e4028 < _e4038) {
                                let _e4040 = (2u * _e4028);
                                atomicStore((&output.member[(4u + _e4040)]), _e3849[1][0]);
                                atomicStore((&output.member[(_e4040 + 5u)]), _e3849[1][1]);
                            }
                        }
                    }
                }
                let _e4082 = params.member.member_2.member;
                if (_e4082 == 0u) {
                    phi_6609_ = array<u32, 2>(0u, 2u);
                } else {
                    phi_6609_ = array<u32, 2>(1u, 1u);
                }
                let _e4085 = phi_6609_;
                let _e4091 = params.member.member.member[_e4085[0]];
                let _e4096 = params.member.member.member[_e4085[1]];
                if (_e3849[2][0] == 4294967295u) {
                    phi_6651_ = 0u;
                } else {
                    if (_e3849[2][0] >= (_e4091 - 1u)) {
                        if (_e3849[2][1] >= (_e4096 - 1u)) {
                            phi_6645_ = false;
                        } else {
                            phi_6645_ = true;
                        }
                        let _e4102 = phi_6645_;
                        phi_6646_ = _e4102;
                    } else {
                        phi_6646_ = true;
                    }
                    let _e4104 = phi_6646_;
                    if _e4104 {
                        phi_6650_ = 1u;
                    } else {
                        phi_6650_ = 2u;
                    }
                    let _e4106 = phi_6650_;
                    phi_6651_ = _e4106;
                }
                let _e4108 = phi_6651_;
                if (_e4108 == 2u) {
                    let _e4156 = params.member.member_1.member_3;
                    let _e4158 = a_nodes.member[_e3849[2][0]];
                    let _e4161 = b_nodes.member[_e3849[2][1]];
                    let _e4165 = params.member.member_2.member;
                    if (_e4165 == 1u) {
                        if (_e4158.member_1 < _e4161.member_1) {
                            phi_6702_ = type_9(_e4158.member_1, _e4161.member_1);
                        } else {
                            phi_6702_ = type_9(_e4161.member_1, _e4158.member_1);
                        }
                        let _e4172 = phi_6702_;
                        phi_6707_ = _e4172;
                    } else {
                        phi_6707_ = type_9(_e4158.member_1, _e4161.member_1);
                    }
                    let _e4174 = phi_6707_;
                    let _e4178 = atomicAdd((&pairs.member[0u]), 1u);
                    if ((_e4178 + 1u) < _e4178) {
                        let _e4182 = atomicAdd((&pairs.member[2u]), 1u);
                    }
                    if (_e4178 < _e4156) {
                        let _e4184 = (2u * _e4178);
                        atomicStore((&pairs.member[(4u + _e4184)]), _e4174.member);
                        atomicStore((&pairs.member[(_e4184 + 5u)]), _e4174.member_1);
                    }
                } else {
                    if (_e4108 == 1u) {
                        let _e4113 = params.member.member_2.member_10;
                        let _e4115 = local_3.member_2;
                        if (64u < _e4113) {
                            phi_6747_ = 64u;
                        } else {
                            phi_6747_ = _e4113;
                        }
                        let _e4118 = phi_6747_;
                        let _e4119 = (_e4115 < _e4118);
                        if _e4119 {
                            let _e4121 = local_3.member_2;
                            local_3.member[_e4121] = _e3849[2][0];
                            let _e4125 = local_3.member_2;
                            local_3.member_1[_e4125] = _e3849[2][1];
                            let _e4130 = local_3.member_2;
                            local_3.member_2 = (_e4130 + 1u);
                        }
                        if _e4119 {
                        } else {
                            let _e4134 = params.member.member_1.member_1;
                            let _e4137 = atomicAdd((&rounds.member[(_e4134 + 1u)]), 1u);
                            let _e4140 = atomicMax((&output.member[0u]), (_e4137 + 1u));
                            if ((_e4137 + 1u) < _e4137) {
                                let _e4144 = atomicAdd((&output.member[2u]), 1u);
                            }
                            let _e4147 = params.member.member_2.member_3;
                            if (_e4137 < _e4147) {
                                let _e4149 = (2u * _e4137);
                                atomicStore((&output.member[(4u + _e4149)]), _e3849[2][0]);
                                atomicStore((&output.member[(_e4149 + 5u)]), _e3849[2][1]);
                            }
                        }
                    }
                }
                let _e4191 = params.member.member_2.member;
                if (_e4191 == 0u) {
                    phi_6826_ = array<u32, 2>(0u, 2u);
                } else {
                    phi_6826_ = array<u32, 2>(1u, 1u);
                }
                let _e4194 = phi_6826_;
                let _e4200 = params.member.member.member[_e4194[0]];
                let _e4205 = params.member.member.member[_e4194[1]];
                if (_e3849[3][0] == 4294967295u) {
                    phi_6868_ = 0u;
                } else {
                    if (_e3849[3][0] >= (_e4200 - 1u)) {
                        if (_e3849[3][1] >= (_e4205 - 1u)) {
                            phi_6862_ = false;
                        } else {
                            phi_6862_ = true;
                        }
                        let _e4211 = phi_6862_;
                        phi_6863_ = _e4211;
                    } else {
                        phi_6863_ = true;
                    }
                    let _e4213 = phi_6863_;
                    if _e4213 {
                        phi_6867_ = 1u;
                    } else {
                        phi_6867_ = 2u;
                    }
                    let _e4215 = phi_6867_;
                    phi_6868_ = _e4215;
                }
                let _e4217 = phi_6868_;
                if (_e4217 == 2u) {
                    let _e4265 = params.member.member_1.member_3;
                    let _e4267 = a_nodes.member[_e3849[3][0]];
                    let _e4270 = b_nodes.member[_e3849[3][1]];
                    let _e4274 = params.member.member_2.member;
                    if (_e4274 == 1u) {
                        if (_e4267.member_1 < _e4270.member_1) {
                            phi_6919_ = type_9(_e4267.member_1, _e4270.member_1);
                        } else {
                            phi_6919_ = type_9(_e4270.member_1, _e4267.member_1);
                        }
                        let _e4281 = phi_6919_;
                        phi_6924_ = _e4281;
                    } else {
                        phi_6924_ = type_9(_e4267.member_1, _e4270.member_1);
                    }
                    let _e4283 = phi_6924_;
                    let _e4287 = atomicAdd((&pairs.member[0u]), 1u);
                    if ((_e4287 + 1u) < _e4287) {
                        let _e4291 = atomicAdd((&pairs.member[2u]), 1u);
                    }
                    if (_e4287 < _e4265) {
                        let _e4293 = (2u * _e4287);
                        atomicStore((&pairs.member[(4u + _e4293)]), _e4283.member);
                        atomicStore((&pairs.member[(_e4293 + 5u)]), _e4283.member_1);
                    }
                } else {
                    if (_e4217 == 1u) {
                        let _e4222 = params.member.member_2.member_10;
                        let _e4224 = local_3.member_2;
                        if (64u < _e4222) {
                            phi_6964_ = 64u;
                        } else {
                            phi_6964_ = _e4222;
                        }
                        let _e4227 = phi_6964_;
                        let _e4228 = (_e4224 < _e4227);
                        if _e4228 {
                            let _e4230 = local_3.member_2;
                            local_3.member[_e4230] = _e3849[3][0];
                            let _e4234 = local_3.member_2;
                            local_3.member_1[_e4234] = _e3849[3][1];
                            let _e4239 = local_3.member_2;
                            local_3.member_2 = (_e4239 + 1u);
                        }
                        if _e4228 {
                        } else {
                            let _e4243 = params.member.member_1.member_1;
                            let _e4246 = atomicAdd((&rounds.member[(_e4243 + 1u)]), 1u);
                            let _e4249 = atomicMax((&output.member[0u]), (_e4246 + 1u));
                            if ((_e4246 + 1u) < _e4246) {
                                let _e4253 = atomicAdd((&output.member[2u]), 1u);
                            }
                            let _e4256 = params.member.member_2.member_3;
                            if (_e4246 < _e4256) {
                                let _e4258 = (2u * _e4246);
                                atomicStore((&output.member[(4u + _e4258)]), _e3849[3][0]);
                                atomicStore((&output.member[(_e4258 + 5u)]), _e3849[3][1]);
                            }
                        }
                    }
                }
                phi_7032_ = true;
            }
            let _e4299 = phi_7032_;
            phi_7033_ = _e4299;
        } else {
            phi_7033_ = false;
        }
        let _e4301 = phi_7033_;
        continue;
        continuing {
            phi_3091_ = _e1814;
            break if !(_e4301);
        }
    }
    phi_7036_ = type_9(0u, 64u);
    loop {
        let _e4304 = phi_7036_;
        if (_e4304.member < _e4304.member_1) {
            phi_7037_ = type_9((_e4304.member + 1u), _e4304.member_1);
            phi_7060_ = type_9(1u, _e4304.member);
        } else {
            phi_7037_ = _e4304;
            phi_7060_ = type_9(0u, type_9().member_1);
        }
        let _e4316 = phi_7037_;
        let _e4318 = phi_7060_;
        if (bitcast<i32>(_e4318.member) != 0i) {
            let _e4323 = local_3.member_2;
            if (_e4323 > 0u) {
                let _e4327 = local_3.member_2;
                local_3.member_2 = (_e4327 - 1u);
                let _e4330 = local_3.member_2;
                let _e4333 = local_3.member[_e4330];
                let _e4336 = local_3.member_1[_e4330];
                phi_7095_ = array<u32, 2>(_e4333, _e4336);
            } else {
                phi_7095_ = array<u32, 2>(4294967295u, 4294967295u);
            }
            let _e4339 = phi_7095_;
            if (_e4339[0] == 4294967295u) {
                phi_7138_ = false;
            } else {
                let _e4344 = params.member.member_1.member_1;
                let _e4347 = atomicAdd((&rounds.member[(_e4344 + 1u)]), 1u);
                let _e4350 = atomicMax((&output.member[0u]), (_e4347 + 1u));
                if ((_e4347 + 1u) < _e4347) {
                    let _e4354 = atomicAdd((&output.member[2u]), 1u);
                }
                let _e4357 = params.member.member_2.member_3;
                if (_e4347 < _e4357) {
                    let _e4361 = (2u * _e4347);
                    atomicStore((&output.member[(4u + _e4361)]), _e4339[0]);
                    atomicStore((&output.member[(_e4361 + 5u)]), _e4339[1]);
                }
                phi_7138_ = true;
            }
            let _e4367 = phi_7138_;
            phi_7139_ = _e4367;
        } else {
            phi_7139_ = false;
        }
        let _e4369 = phi_7139_;
        continue;
        continuing {
            phi_7036_ = _e4316;
            break if !(_e4369);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn descend_stacks_oriented(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}

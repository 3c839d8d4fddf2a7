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

struct type_18 {
    member: array<type_16>,
}

struct type_21 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: array<u32, 3>,
}

struct type_22 {
    member: type_7,
    member_1: type_8,
    member_2: type_21,
}

struct type_23 {
    member: type_22,
}

struct type_27 {
    member: array<atomic<u32>>,
}

@group(0) @binding(2) 
var<storage> keys: type_11;
var<workgroup> names: array<u32, 128>;
var<workgroup> counters: array<atomic<u32>, 8>;
var<workgroup> hits: array<u32, 2048>;
@group(0) @binding(6) 
var<storage, read_write> pairs: type_27;
@group(0) @binding(0) 
var<storage> params: type_23;
@group(0) @binding(1) 
var<storage> sorted: type_18;
@group(0) @binding(3) 
var<storage> order: type_11;
@group(0) @binding(4) 
var<storage> survey: type_11;
@group(0) @binding(5) 
var<storage> work: type_11;
var<workgroup> boxes: array<type_16, 128>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_182_: bool;
    var phi_228_: bool;
    var phi_274_: bool;
    var phi_275_: bool;
    var phi_276_: bool;
    var phi_277_: bool;
    var phi_281_: bool;
    var phi_302_: u32;
    var phi_312_: u32;
    var phi_319_: u32;
    var phi_320_: u32;
    var phi_339_: u32;
    var phi_360_: u32;
    var phi_361_: u32;
    var phi_364_: type_9;
    var phi_365_: type_9;
    var phi_388_: type_9;
    var phi_444_: array<u32, 2>;
    var phi_456_: array<u32, 2>;
    var phi_457_: bool;
    var phi_458_: array<u32, 2>;
    var phi_459_: bool;
    var phi_464_: array<u32, 2>;
    var phi_502_: array<u32, 2>;
    var phi_514_: array<u32, 2>;
    var phi_515_: bool;
    var phi_516_: array<u32, 2>;
    var phi_517_: bool;
    var phi_522_: array<u32, 2>;
    var phi_609_: u32;
    var phi_645_: bool;
    var phi_646_: bool;
    var phi_651_: u32;
    var phi_652_: bool;
    var phi_653_: u32;
    var phi_654_: bool;
    var phi_658_: u32;
    var phi_665_: u32;
    var phi_679_: array<u32, 2>;
    var phi_680_: array<u32, 2>;
    var phi_681_: bool;
    var phi_682_: array<u32, 2>;
    var phi_683_: bool;
    var phi_684_: array<u32, 2>;
    var phi_685_: bool;
    var phi_690_: array<u32, 2>;
    var phi_697_: array<u32, 2>;
    var phi_579_: f32;
    var phi_580_: f32;
    var phi_586_: u32;
    var phi_596_: u32;
    var phi_698_: array<u32, 2>;
    var phi_706_: u32;
    var phi_709_: array<u32, 3>;
    var phi_726_: type_16;
    var phi_729_: type_9;
    var phi_730_: type_9;
    var phi_753_: type_9;
    var phi_788_: type_16;
    var phi_789_: u32;
    var phi_810_: type_9;
    var phi_811_: type_9;
    var phi_834_: type_9;
    var phi_967_: type_9;
    var phi_968_: bool;
    var phi_969_: type_9;
    var phi_970_: bool;
    var phi_979_: type_9;
    var phi_947_: type_9;
    var phi_980_: type_9;
    var phi_1015_: u32;
    var phi_1041_: type_9;
    var phi_1042_: type_9;
    var phi_1065_: type_9;
    var phi_1096_: array<u32, 2>;
    var phi_1108_: array<u32, 2>;
    var phi_1109_: bool;
    var phi_1110_: array<u32, 2>;
    var phi_1111_: bool;
    var phi_1116_: array<u32, 2>;
    var phi_1199_: type_9;
    var phi_1200_: bool;
    var phi_1201_: type_9;
    var phi_1202_: bool;
    var phi_1211_: type_9;
    var phi_1179_: type_9;
    var phi_1212_: type_9;
    var phi_1230_: bool;
    var phi_1231_: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e55 = id_2;
    let _e56 = n_2;
    let _e57 = lane_2;
    let _e69 = ((_e55.y * _e56.x) + _e55.x);
    let _e72 = (_e56.x * _e56.y);
    let _e74 = survey.member[10u];
    if (_e74 > 0u) {
        phi_182_ = true;
    } else {
        let _e77 = survey.member[9u];
        let _e81 = params.member.member_2.member_3[0u];
        phi_182_ = (_e77 > _e81);
    }
    let _e84 = phi_182_;
    if _e84 {
        phi_276_ = bool();
        phi_277_ = true;
    } else {
        let _e86 = survey.member[15u];
        if (_e86 > 0u) {
            phi_228_ = true;
        } else {
            let _e89 = survey.member[14u];
            let _e93 = params.member.member_2.member_3[1u];
            phi_228_ = (_e89 > _e93);
        }
        let _e96 = phi_228_;
        if _e96 {
            phi_275_ = bool();
        } else {
            let _e98 = survey.member[20u];
            if (_e98 > 0u) {
                phi_274_ = true;
            } else {
                let _e101 = survey.member[19u];
                let _e105 = params.member.member_2.member_3[2u];
                phi_274_ = (_e101 > _e105);
            }
            let _e108 = phi_274_;
            phi_275_ = _e108;
        }
        let _e110 = phi_275_;
        phi_276_ = _e110;
        phi_277_ = _e96;
    }
    let _e112 = phi_276_;
    let _e114 = phi_277_;
    if _e114 {
        phi_281_ = true;
    } else {
        phi_281_ = _e112;
    }
    let _e116 = phi_281_;
    if _e116 {
        phi_320_ = 0u;
    } else {
        let _e119 = params.member.member_1.member_2;
        let _e121 = work.member[0u];
        if (_e119 < _e121) {
            phi_302_ = _e119;
        } else {
            phi_302_ = _e121;
        }
        let _e124 = phi_302_;
        let _e126 = params.member.member_1.member_1;
        if (_e124 > _e126) {
            let _e129 = params.member.member_1.member_1;
            phi_312_ = (_e124 - _e129);
        } else {
            phi_312_ = 0u;
        }
        let _e132 = phi_312_;
        let _e134 = params.member.member_1.member;
        if (_e134 < _e132) {
            phi_319_ = _e134;
        } else {
            phi_319_ = _e132;
        }
        let _e137 = phi_319_;
        phi_320_ = _e137;
    }
    let _e139 = phi_320_;
    let _e143 = params.member.member.member_2[3u];
    if false {
        phi_339_ = (_e139 + 1u);
    } else {
        phi_339_ = _e139;
    }
    let _e146 = phi_339_;
    if (_e146 > _e69) {
        let _e148 = (_e146 - _e69);
        if (_e72 == 0u) {
            return;
        }
        let _e150 = (_e148 / _e72);
        if (_e72 == 0u) {
            return;
        }
        if ((_e148 % _e72) > 0u) {
            phi_360_ = (_e150 + 1u);
        } else {
            phi_360_ = _e150;
        }
        let _e156 = phi_360_;
        phi_361_ = _e156;
    } else {
        phi_361_ = 0u;
    }
    let _e158 = phi_361_;
    phi_364_ = type_9(0u, _e158);
    loop {
        let _e161 = phi_364_;
        if (_e161.member < _e161.member_1) {
            phi_365_ = type_9((_e161.member + 1u), _e161.member_1);
            phi_388_ = type_9(1u, _e161.member);
        } else {
            phi_365_ = _e161;
            phi_388_ = type_9(0u, type_9().member_1);
        }
        let _e173 = phi_365_;
        let _e175 = phi_388_;
        let _e179 = (bitcast<i32>(_e175.member) != 0i);
        if _e179 {
            let _e182 = params.member.member_1.member_1;
            let _e186 = (2u * ((_e182 + _e69) + (_e175.member_1 * _e72)));
            let _e189 = work.member[(4u + _e186)];
            let _e192 = work.member[(_e186 + 5u)];
            let _e194 = (_e189 >> bitcast<u32>(28i));
            let _e199 = (_e189 & 16777215u);
            let _e202 = params.member.member_2.member;
            let _e205 = params.member.member_2.member_1;
            if (_e205 == 0u) {
                phi_444_ = array<u32, 2>(0u, 2u);
            } else {
                phi_444_ = array<u32, 2>(1u, 1u);
            }
            let _e208 = phi_444_;
            if (_e202 == 1u) {
                if (_e194 == 1u) {
                    phi_456_ = array<u32, 2>(_e208[1], _e208[0]);
                    phi_457_ = false;
                } else {
                    phi_456_ = array<u32, 2>();
                    phi_457_ = true;
                }
                let _e215 = phi_456_;
                let _e217 = phi_457_;
                phi_458_ = _e215;
                phi_459_ = _e217;
            } else {
                phi_458_ = array<u32, 2>();
                phi_459_ = true;
            }
            let _e219 = phi_458_;
            let _e221 = phi_459_;
            if _e221 {
                phi_464_ = _e208;
            } else {
                phi_464_ = _e219;
            }
            let _e223 = phi_464_;
            let _e226 = ((_e199 * 128u) + _e57);
            let _e230 = params.member.member.member_2[_e223[0]];
            let _e231 = (_e230 + _e226);
            let _e235 = params.member.member.member[_e223[0]];
            let _e236 = (_e226 < _e235);
            if _e236 {
                let _e239 = params.member.member_2.member;
                let _e242 = params.member.member_2.member_1;
                if (_e242 == 0u) {
                    phi_502_ = array<u32, 2>(0u, 2u);
                } else {
                    phi_502_ = array<u32, 2>(1u, 1u);
                }
                let _e245 = phi_502_;
                if (_e239 == 1u) {
                    if (_e194 == 1u) {
                        phi_514_ = array<u32, 2>(_e245[1], _e245[0]);
                        phi_515_ = false;
                    } else {
                        phi_514_ = array<u32, 2>();
                        phi_515_ = true;
                    }
                    let _e252 = phi_514_;
                    let _e254 = phi_515_;
                    phi_516_ = _e252;
                    phi_517_ = _e254;
                } else {
                    phi_516_ = array<u32, 2>();
                    phi_517_ = true;
                }
                let _e256 = phi_516_;
                let _e258 = phi_517_;
                if _e258 {
                    phi_522_ = _e245;
                } else {
                    phi_522_ = _e256;
                }
                let _e260 = phi_522_;
                let _e263 = keys.member[_e231];
                let _e265 = sorted.member[_e231];
                let _e267 = (_e260[1] << bitcast<u32>(30u));
                let _e268 = (_e263 & 1073741823u);
                if (_e239 == 1u) {
                    let _e355 = survey.member[6u];
                    if (_e355 == 0u) {
                        phi_580_ = _e265.member_1[0];
                    } else {
                        if (_e355 == 1u) {
                            phi_579_ = _e265.member_1[1];
                        } else {
                            phi_579_ = _e265.member_1[2];
                        }
                        let _e363 = phi_579_;
                        phi_580_ = _e363;
                    }
                    let _e367 = phi_580_;
                    let _e368 = bitcast<u32>(_e367);
                    if (_e368 == 2147483648u) {
                        phi_586_ = 0u;
                    } else {
                        phi_586_ = _e368;
                    }
                    let _e371 = phi_586_;
                    let _e373 = bitcast<u32>(bitcast<f32>(_e371));
                    if ((_e373 >> bitcast<u32>(31i)) == 1u) {
                        phi_596_ = ~(_e373);
                    } else {
                        phi_596_ = (_e373 | 2147483648u);
                    }
                    let _e380 = phi_596_;
                    phi_698_ = array<u32, 2>(((_e267 | _e268) + _e194), (_e267 | (_e380 >> bitcast<u32>(2i))));
                } else {
                    if (_e239 == 2u) {
                        let _e272 = (_e242 == 1u);
                        if _e272 {
                            phi_609_ = (4u + _e194);
                        } else {
                            phi_609_ = _e194;
                        }
                        let _e275 = phi_609_;
                        let _e276 = (_e268 & 1023u);
                        let _e283 = (((_e268 >> bitcast<u32>(10u)) & 1023u) + (_e275 % 3u));
                        let _e285 = ((_e268 >> bitcast<u32>(20u)) + (_e275 / 3u));
                        if (_e283 < 1u) {
                            phi_684_ = array<u32, 2>();
                            phi_685_ = true;
                        } else {
                            if (_e285 < 1u) {
                                phi_682_ = array<u32, 2>();
                                phi_683_ = true;
                            } else {
                                if (_e283 > 1024u) {
                                    phi_680_ = array<u32, 2>();
                                    phi_681_ = true;
                                } else {
                                    let _e289 = (_e285 > 1024u);
                                    if _e289 {
                                        phi_679_ = array<u32, 2>();
                                    } else {
                                        if (_e276 > 0u) {
                                            if _e272 {
                                                if (_e275 == 4u) {
                                                    phi_645_ = false;
                                                } else {
                                                    phi_645_ = true;
                                                }
                                                let _e293 = phi_645_;
                                                phi_646_ = _e293;
                                            } else {
                                                phi_646_ = true;
                                            }
                                            let _e295 = phi_646_;
                                            if _e295 {
                                                phi_651_ = (_e276 - 1u);
                                                phi_652_ = false;
                                            } else {
                                                phi_651_ = u32();
                                                phi_652_ = true;
                                            }
                                            let _e298 = phi_651_;
                                            let _e300 = phi_652_;
                                            phi_653_ = _e298;
                                            phi_654_ = _e300;
                                        } else {
                                            phi_653_ = u32();
                                            phi_654_ = true;
                                        }
                                        let _e302 = phi_653_;
                                        let _e304 = phi_654_;
                                        if _e304 {
                                            phi_658_ = _e276;
                                        } else {
                                            phi_658_ = _e302;
                                        }
                                        let _e306 = phi_658_;
                                        if ((_e276 + 1u) < 1024u) {
                                            phi_665_ = (_e276 + 1u);
                                        } else {
                                            phi_665_ = _e276;
                                        }
                                        let _e311 = phi_665_;
                                        phi_679_ = array<u32, 2>(((((_e285 - 1u) << bitcast<u32>(20u)) | ((_e283 - 1u) << bitcast<u32>(10u))) | _e306), ((((_e285 - 1u) << bitcast<u32>(20u)) | ((_e283 - 1u) << bitcast<u32>(10u))) | _e311));
                                    }
                                    let _e330 = phi_679_;
                                    phi_680_ = _e330;
                                    phi_681_ = _e289;
                                }
                                let _e332 = phi_680_;
                                let _e334 = phi_681_;
                                phi_682_ = _e332;
                                phi_683_ = _e334;
                            }
                            let _e336 = phi_682_;
                            let _e338 = phi_683_;
                            phi_684_ = _e336;
                            phi_685_ = _e338;
                        }
                        let _e340 = phi_684_;
                        let _e342 = phi_685_;
                        if _e342 {
                            phi_690_ = array<u32, 2>(1u, 0u);
                        } else {
                            phi_690_ = _e340;
                        }
                        let _e344 = phi_690_;
                        phi_697_ = array<u32, 2>((_e267 | _e344[0]), (_e267 | _e344[1]));
                    } else {
                        phi_697_ = array<u32, 2>(_e267, _e267);
                    }
                    let _e351 = phi_697_;
                    phi_698_ = _e351;
                }
                let _e386 = phi_698_;
                if (_e242 == 1u) {
                    phi_706_ = (_e231 + 1u);
                } else {
                    phi_706_ = 0u;
                }
                let _e392 = phi_706_;
                phi_709_ = array<u32, 3>(_e386[0], _e386[1], _e392);
            } else {
                phi_709_ = array<u32, 3>(4294967295u, 0u, 0u);
            }
            let _e395 = phi_709_;
            if _e236 {
                let _e400 = sorted.member[_e231];
                phi_726_ = _e400;
            } else {
                phi_726_ = type_16(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            }
            let _e402 = phi_726_;
            phi_729_ = type_9(0u, (((_e189 >> bitcast<u32>(24i)) & 15u) + 1u));
            loop {
                let _e405 = phi_729_;
                if (_e405.member < _e405.member_1) {
                    phi_730_ = type_9((_e405.member + 1u), _e405.member_1);
                    phi_753_ = type_9(1u, _e405.member);
                } else {
                    phi_730_ = _e405;
                    phi_753_ = type_9(0u, type_9().member_1);
                }
                let _e417 = phi_730_;
                let _e419 = phi_753_;
                let _e423 = (bitcast<i32>(_e419.member) != 0i);
                if _e423 {
                    let _e425 = (_e192 + (_e419.member_1 * 128u));
                    let _e426 = (_e425 + _e57);
                    if (_e426 < _e143) {
                        let _e429 = keys.member[_e426];
                        let _e431 = sorted.member[_e426];
                        phi_788_ = _e431;
                        phi_789_ = _e429;
                    } else {
                        phi_788_ = type_16(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                        phi_789_ = 4294967295u;
                    }
                    let _e433 = phi_788_;
                    let _e435 = phi_789_;
                    names[_e57] = _e435;
                    boxes[_e57] = type_16(array<f32, 3>(_e433.member[0], _e433.member[1], _e433.member[2]), array<f32, 3>(_e433.member_1[0], _e433.member_1[1], _e433.member_1[2]));
                    if (_e57 == 0u) {
                        atomicStore((&counters[4u]), 0u);
                    }
                    workgroupBarrier();
                    phi_810_ = type_9(0u, 128u);
                    loop {
                        let _e452 = phi_810_;
                        if (_e452.member < _e452.member_1) {
                            phi_811_ = type_9((_e452.member + 1u), _e452.member_1);
                            phi_834_ = type_9(1u, _e452.member);
                        } else {
                            phi_811_ = _e452;
                            phi_834_ = type_9(0u, type_9().member_1);
                        }
                        let _e464 = phi_811_;
                        let _e466 = phi_834_;
                        let _e470 = (bitcast<i32>(_e466.member) != 0i);
                        if _e470 {
                            let _e472 = names[_e466.member_1];
                            if (_e472 >= _e395[0]) {
                                if (_e472 <= _e395[1]) {
                                    if ((_e425 + _e466.member_1) >= _e395[2]) {
                                        let _e478 = boxes[_e466.member_1];
                                        if ((((((_e402.member[0] <= _e478.member_1[0]) && (_e478.member[0] <= _e402.member_1[0])) && (_e402.member[1] <= _e478.member_1[1])) && (_e478.member[1] <= _e402.member_1[1])) && (_e402.member[2] <= _e478.member_1[2])) && (_e478.member[2] <= _e402.member_1[2])) {
                                            let _e511 = atomicAdd((&counters[4u]), 1u);
                                            if (_e511 < 2048u) {
                                                hits[_e511] = ((_e57 << bitcast<u32>(7i)) | _e466.member_1);
                                            } else {
                                                let _e515 = order.member[_e231];
                                                let _e517 = order.member[(_e425 + _e466.member_1)];
                                                let _e520 = params.member.member_2.member_1;
                                                if (_e520 == 1u) {
                                                    let _e552 = params.member.member.member_2[1u];
                                                    let _e553 = (_e515 - _e552);
                                                    let _e557 = params.member.member.member_2[1u];
                                                    let _e558 = (_e517 - _e557);
                                                    if (_e553 < _e558) {
                                                        phi_947_ = type_9(_e553, _e558);
                                                    } else {
                                                        phi_947_ = type_9(_e558, _e553);
                                                    }
                                                    let _e563 = phi_947_;
                                                    phi_980_ = _e563;
                                                } else {
                                                    let _e524 = params.member.member_2.member;
                                                    if (_e524 == 1u) {
                                                        if (_e194 == 1u) {
                                                            let _e530 = params.member.member.member_2[2u];
                                                            phi_967_ = type_9(_e517, (_e515 - _e530));
                                                            phi_968_ = false;
                                                        } else {
                                                            phi_967_ = type_9();
                                                            phi_968_ = true;
                                                        }
                                                        let _e534 = phi_967_;
                                                        let _e536 = phi_968_;
                                                        phi_969_ = _e534;
                                                        phi_970_ = _e536;
                                                    } else {
                                                        phi_969_ = type_9();
                                                        phi_970_ = true;
                                                    }
                                                    let _e538 = phi_969_;
                                                    let _e540 = phi_970_;
                                                    if _e540 {
                                                        let _e544 = params.member.member.member_2[2u];
                                                        phi_979_ = type_9(_e515, (_e517 - _e544));
                                                    } else {
                                                        phi_979_ = _e538;
                                                    }
                                                    let _e548 = phi_979_;
                                                    phi_980_ = _e548;
                                                }
                                                let _e565 = phi_980_;
                                                let _e570 = params.member.member_1.member_3;
                                                let _e572 = atomicAdd((&pairs.member[0u]), 1u);
                                                if ((_e572 + 1u) < _e572) {
                                                    let _e576 = atomicAdd((&pairs.member[2u]), 1u);
                                                }
                                                if (_e572 < _e570) {
                                                    let _e578 = (2u * _e572);
                                                    atomicStore((&pairs.member[(4u + _e578)]), _e565.member);
                                                    atomicStore((&pairs.member[(_e578 + 5u)]), _e565.member_1);
                                                }
                                            }
                                        }
                                    }
                                }
                            }
                        }
                        continue;
                        continuing {
                            phi_810_ = _e464;
                            break if !(_e470);
                        }
                    }
                    workgroupBarrier();
                    let _e589 = atomicLoad((&counters[4u]));
                    if (2048u < _e589) {
                        phi_1015_ = 2048u;
                    } else {
                        phi_1015_ = _e589;
                    }
                    let _e592 = phi_1015_;
                    if (_e57 == 0u) {
                        if (_e592 > 0u) {
                            let _e596 = atomicAdd((&pairs.member[0u]), _e592);
                            if ((_e596 + _e592) < _e596) {
                                let _e600 = atomicAdd((&pairs.member[2u]), 1u);
                            }
                            atomicStore((&counters[5u]), _e596);
                        }
                    }
                    workgroupBarrier();
                    let _e603 = atomicLoad((&counters[5u]));
                    phi_1041_ = type_9(0u, 16u);
                    loop {
                        let _e605 = phi_1041_;
                        if (_e605.member < _e605.member_1) {
                            phi_1042_ = type_9((_e605.member + 1u), _e605.member_1);
                            phi_1065_ = type_9(1u, _e605.member);
                        } else {
                            phi_1042_ = _e605;
                            phi_1065_ = type_9(0u, type_9().member_1);
                        }
                        let _e617 = phi_1042_;
                        let _e619 = phi_1065_;
                        if (bitcast<i32>(_e619.member) != 0i) {
                            let _e625 = ((_e619.member_1 * 128u) + _e57);
                            if (_e625 >= _e592) {
                                phi_1230_ = false;
                            } else {
                                let _e628 = hits[_e625];
                                let _e633 = params.member.member_2.member;
                                let _e636 = params.member.member_2.member_1;
                                if (_e636 == 0u) {
                                    phi_1096_ = array<u32, 2>(0u, 2u);
                                } else {
                                    phi_1096_ = array<u32, 2>(1u, 1u);
                                }
                                let _e639 = phi_1096_;
                                if (_e633 == 1u) {
                                    if (_e194 == 1u) {
                                        phi_1108_ = array<u32, 2>(_e639[1], _e639[0]);
                                        phi_1109_ = false;
                                    } else {
                                        phi_1108_ = array<u32, 2>();
                                        phi_1109_ = true;
                                    }
                                    let _e646 = phi_1108_;
                                    let _e648 = phi_1109_;
                                    phi_1110_ = _e646;
                                    phi_1111_ = _e648;
                                } else {
                                    phi_1110_ = array<u32, 2>();
                                    phi_1111_ = true;
                                }
                                let _e650 = phi_1110_;
                                let _e652 = phi_1111_;
                                if _e652 {
                                    phi_1116_ = _e639;
                                } else {
                                    phi_1116_ = _e650;
                                }
                                let _e654 = phi_1116_;
                                let _e661 = params.member.member.member_2[_e654[0]];
                                let _e666 = order.member[(_e661 + ((_e199 * 128u) + (_e628 >> bitcast<u32>(7i))))];
                                let _e668 = order.member[(_e425 + (_e628 % 128u))];
                                let _e671 = params.member.member_2.member_1;
                                if (_e671 == 1u) {
                                    let _e703 = params.member.member.member_2[1u];
                                    let _e704 = (_e666 - _e703);
                                    let _e708 = params.member.member.member_2[1u];
                                    let _e709 = (_e668 - _e708);
                                    if (_e704 < _e709) {
                                        phi_1179_ = type_9(_e704, _e709);
                                    } else {
                                        phi_1179_ = type_9(_e709, _e704);
                                    }
                                    let _e714 = phi_1179_;
                                    phi_1212_ = _e714;
                                } else {
                                    let _e675 = params.member.member_2.member;
                                    if (_e675 == 1u) {
                                        if (_e194 == 1u) {
                                            let _e681 = params.member.member.member_2[2u];
                                            phi_1199_ = type_9(_e668, (_e666 - _e681));
                                            phi_1200_ = false;
                                        } else {
                                            phi_1199_ = type_9();
                                            phi_1200_ = true;
                                        }
                                        let _e685 = phi_1199_;
                                        let _e687 = phi_1200_;
                                        phi_1201_ = _e685;
                                        phi_1202_ = _e687;
                                    } else {
                                        phi_1201_ = type_9();
                                        phi_1202_ = true;
                                    }
                                    let _e689 = phi_1201_;
                                    let _e691 = phi_1202_;
                                    if _e691 {
                                        let _e695 = params.member.member.member_2[2u];
                                        phi_1211_ = type_9(_e666, (_e668 - _e695));
                                    } else {
                                        phi_1211_ = _e689;
                                    }
                                    let _e699 = phi_1211_;
                                    phi_1212_ = _e699;
                                }
                                let _e716 = phi_1212_;
                                let _e721 = params.member.member_1.member_3;
                                let _e722 = (_e603 + _e625);
                                if (_e722 < _e721) {
                                    let _e724 = (2u * _e722);
                                    atomicStore((&pairs.member[(4u + _e724)]), _e716.member);
                                    atomicStore((&pairs.member[(_e724 + 5u)]), _e716.member_1);
                                }
                                phi_1230_ = true;
                            }
                            let _e730 = phi_1230_;
                            phi_1231_ = _e730;
                        } else {
                            phi_1231_ = false;
                        }
                        let _e732 = phi_1231_;
                        continue;
                        continuing {
                            phi_1041_ = _e617;
                            break if !(_e732);
                        }
                    }
                    workgroupBarrier();
                }
                continue;
                continuing {
                    phi_729_ = _e417;
                    break if !(_e423);
                }
            }
        }
        continue;
        continuing {
            phi_364_ = _e173;
            break if !(_e179);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn interval_pairs(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}

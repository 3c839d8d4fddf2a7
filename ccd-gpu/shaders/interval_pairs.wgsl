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
    var phi_166_: bool;
    var phi_207_: bool;
    var phi_248_: bool;
    var phi_249_: bool;
    var phi_250_: bool;
    var phi_251_: bool;
    var phi_255_: bool;
    var phi_276_: u32;
    var phi_286_: u32;
    var phi_293_: u32;
    var phi_294_: u32;
    var phi_313_: u32;
    var phi_334_: u32;
    var phi_335_: u32;
    var phi_338_: type_9;
    var phi_339_: type_9;
    var phi_362_: type_9;
    var phi_416_: array<u32, 2>;
    var phi_428_: array<u32, 2>;
    var phi_429_: bool;
    var phi_430_: array<u32, 2>;
    var phi_431_: bool;
    var phi_436_: array<u32, 2>;
    var phi_472_: array<u32, 2>;
    var phi_484_: array<u32, 2>;
    var phi_485_: bool;
    var phi_486_: array<u32, 2>;
    var phi_487_: bool;
    var phi_492_: array<u32, 2>;
    var phi_573_: u32;
    var phi_609_: bool;
    var phi_610_: bool;
    var phi_615_: u32;
    var phi_616_: bool;
    var phi_617_: u32;
    var phi_618_: bool;
    var phi_622_: u32;
    var phi_629_: u32;
    var phi_643_: array<u32, 2>;
    var phi_644_: array<u32, 2>;
    var phi_645_: bool;
    var phi_646_: array<u32, 2>;
    var phi_647_: bool;
    var phi_648_: array<u32, 2>;
    var phi_649_: bool;
    var phi_654_: array<u32, 2>;
    var phi_661_: array<u32, 2>;
    var phi_543_: f32;
    var phi_544_: f32;
    var phi_550_: u32;
    var phi_560_: u32;
    var phi_662_: array<u32, 2>;
    var phi_670_: u32;
    var phi_673_: array<u32, 3>;
    var phi_690_: type_16;
    var phi_693_: type_9;
    var phi_694_: type_9;
    var phi_717_: type_9;
    var phi_752_: type_16;
    var phi_753_: u32;
    var phi_774_: type_9;
    var phi_775_: type_9;
    var phi_798_: type_9;
    var phi_931_: type_9;
    var phi_932_: bool;
    var phi_933_: type_9;
    var phi_934_: bool;
    var phi_943_: type_9;
    var phi_911_: type_9;
    var phi_944_: type_9;
    var phi_979_: u32;
    var phi_1005_: type_9;
    var phi_1006_: type_9;
    var phi_1029_: type_9;
    var phi_1058_: array<u32, 2>;
    var phi_1070_: array<u32, 2>;
    var phi_1071_: bool;
    var phi_1072_: array<u32, 2>;
    var phi_1073_: bool;
    var phi_1078_: array<u32, 2>;
    var phi_1161_: type_9;
    var phi_1162_: bool;
    var phi_1163_: type_9;
    var phi_1164_: bool;
    var phi_1173_: type_9;
    var phi_1141_: type_9;
    var phi_1174_: type_9;
    var phi_1192_: bool;
    var phi_1193_: bool;
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
        phi_166_ = true;
    } else {
        let _e77 = survey.member[9u];
        let _e81 = params.member.member_2.member_3[0u];
        phi_166_ = (_e77 > _e81);
    }
    let _e84 = phi_166_;
    if _e84 {
        phi_250_ = bool();
        phi_251_ = true;
    } else {
        let _e86 = survey.member[15u];
        if (_e86 > 0u) {
            phi_207_ = true;
        } else {
            let _e89 = survey.member[14u];
            let _e93 = params.member.member_2.member_3[1u];
            phi_207_ = (_e89 > _e93);
        }
        let _e96 = phi_207_;
        if _e96 {
            phi_249_ = bool();
        } else {
            let _e98 = survey.member[20u];
            if (_e98 > 0u) {
                phi_248_ = true;
            } else {
                let _e101 = survey.member[19u];
                let _e105 = params.member.member_2.member_3[2u];
                phi_248_ = (_e101 > _e105);
            }
            let _e108 = phi_248_;
            phi_249_ = _e108;
        }
        let _e110 = phi_249_;
        phi_250_ = _e110;
        phi_251_ = _e96;
    }
    let _e112 = phi_250_;
    let _e114 = phi_251_;
    if _e114 {
        phi_255_ = true;
    } else {
        phi_255_ = _e112;
    }
    let _e116 = phi_255_;
    if _e116 {
        phi_294_ = 0u;
    } else {
        let _e119 = params.member.member_1.member_2;
        let _e121 = work.member[0u];
        if (_e119 < _e121) {
            phi_276_ = _e119;
        } else {
            phi_276_ = _e121;
        }
        let _e124 = phi_276_;
        let _e126 = params.member.member_1.member_1;
        if (_e124 > _e126) {
            let _e129 = params.member.member_1.member_1;
            phi_286_ = (_e124 - _e129);
        } else {
            phi_286_ = 0u;
        }
        let _e132 = phi_286_;
        let _e134 = params.member.member_1.member;
        if (_e134 < _e132) {
            phi_293_ = _e134;
        } else {
            phi_293_ = _e132;
        }
        let _e137 = phi_293_;
        phi_294_ = _e137;
    }
    let _e139 = phi_294_;
    let _e143 = params.member.member.member_2[3u];
    if false {
        phi_313_ = (_e139 + 1u);
    } else {
        phi_313_ = _e139;
    }
    let _e146 = phi_313_;
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
            phi_334_ = (_e150 + 1u);
        } else {
            phi_334_ = _e150;
        }
        let _e156 = phi_334_;
        phi_335_ = _e156;
    } else {
        phi_335_ = 0u;
    }
    let _e158 = phi_335_;
    phi_338_ = type_9(0u, _e158);
    loop {
        let _e161 = phi_338_;
        if (_e161.member < _e161.member_1) {
            phi_339_ = type_9((_e161.member + 1u), _e161.member_1);
            phi_362_ = type_9(1u, _e161.member);
        } else {
            phi_339_ = _e161;
            phi_362_ = type_9(0u, type_9().member_1);
        }
        let _e173 = phi_339_;
        let _e175 = phi_362_;
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
                phi_416_ = array<u32, 2>(0u, 2u);
            } else {
                phi_416_ = array<u32, 2>(1u, 1u);
            }
            let _e208 = phi_416_;
            if (_e202 == 1u) {
                if (_e194 == 1u) {
                    phi_428_ = array<u32, 2>(_e208[1], _e208[0]);
                    phi_429_ = false;
                } else {
                    phi_428_ = array<u32, 2>();
                    phi_429_ = true;
                }
                let _e215 = phi_428_;
                let _e217 = phi_429_;
                phi_430_ = _e215;
                phi_431_ = _e217;
            } else {
                phi_430_ = array<u32, 2>();
                phi_431_ = true;
            }
            let _e219 = phi_430_;
            let _e221 = phi_431_;
            if _e221 {
                phi_436_ = _e208;
            } else {
                phi_436_ = _e219;
            }
            let _e223 = phi_436_;
            let _e226 = ((_e199 * 128u) + _e57);
            let _e230 = params.member.member.member_2[_e223[0]];
            let _e231 = (_e230 + _e226);
            let _e235 = params.member.member.member[_e223[0]];
            let _e236 = (_e226 < _e235);
            if _e236 {
                let _e239 = params.member.member_2.member;
                let _e242 = params.member.member_2.member_1;
                if (_e242 == 0u) {
                    phi_472_ = array<u32, 2>(0u, 2u);
                } else {
                    phi_472_ = array<u32, 2>(1u, 1u);
                }
                let _e245 = phi_472_;
                if (_e239 == 1u) {
                    if (_e194 == 1u) {
                        phi_484_ = array<u32, 2>(_e245[1], _e245[0]);
                        phi_485_ = false;
                    } else {
                        phi_484_ = array<u32, 2>();
                        phi_485_ = true;
                    }
                    let _e252 = phi_484_;
                    let _e254 = phi_485_;
                    phi_486_ = _e252;
                    phi_487_ = _e254;
                } else {
                    phi_486_ = array<u32, 2>();
                    phi_487_ = true;
                }
                let _e256 = phi_486_;
                let _e258 = phi_487_;
                if _e258 {
                    phi_492_ = _e245;
                } else {
                    phi_492_ = _e256;
                }
                let _e260 = phi_492_;
                let _e263 = keys.member[_e231];
                let _e265 = sorted.member[_e231];
                let _e267 = (_e260[1] << bitcast<u32>(30u));
                let _e268 = (_e263 & 1073741823u);
                if (_e239 == 1u) {
                    let _e355 = survey.member[6u];
                    if (_e355 == 0u) {
                        phi_544_ = _e265.member_1[0];
                    } else {
                        if (_e355 == 1u) {
                            phi_543_ = _e265.member_1[1];
                        } else {
                            phi_543_ = _e265.member_1[2];
                        }
                        let _e363 = phi_543_;
                        phi_544_ = _e363;
                    }
                    let _e367 = phi_544_;
                    let _e368 = bitcast<u32>(_e367);
                    if (_e368 == 2147483648u) {
                        phi_550_ = 0u;
                    } else {
                        phi_550_ = _e368;
                    }
                    let _e371 = phi_550_;
                    let _e373 = bitcast<u32>(bitcast<f32>(_e371));
                    if ((_e373 >> bitcast<u32>(31i)) == 1u) {
                        phi_560_ = ~(_e373);
                    } else {
                        phi_560_ = (_e373 | 2147483648u);
                    }
                    let _e380 = phi_560_;
                    phi_662_ = array<u32, 2>(((_e267 | _e268) + _e194), (_e267 | (_e380 >> bitcast<u32>(2i))));
                } else {
                    if (_e239 == 2u) {
                        let _e272 = (_e242 == 1u);
                        if _e272 {
                            phi_573_ = (4u + _e194);
                        } else {
                            phi_573_ = _e194;
                        }
                        let _e275 = phi_573_;
                        let _e276 = (_e268 & 1023u);
                        let _e283 = (((_e268 >> bitcast<u32>(10u)) & 1023u) + (_e275 % 3u));
                        let _e285 = ((_e268 >> bitcast<u32>(20u)) + (_e275 / 3u));
                        if (_e283 < 1u) {
                            phi_648_ = array<u32, 2>();
                            phi_649_ = true;
                        } else {
                            if (_e285 < 1u) {
                                phi_646_ = array<u32, 2>();
                                phi_647_ = true;
                            } else {
                                if (_e283 > 1024u) {
                                    phi_644_ = array<u32, 2>();
                                    phi_645_ = true;
                                } else {
                                    let _e289 = (_e285 > 1024u);
                                    if _e289 {
                                        phi_643_ = array<u32, 2>();
                                    } else {
                                        if (_e276 > 0u) {
                                            if _e272 {
                                                if (_e275 == 4u) {
                                                    phi_609_ = false;
                                                } else {
                                                    phi_609_ = true;
                                                }
                                                let _e293 = phi_609_;
                                                phi_610_ = _e293;
                                            } else {
                                                phi_610_ = true;
                                            }
                                            let _e295 = phi_610_;
                                            if _e295 {
                                                phi_615_ = (_e276 - 1u);
                                                phi_616_ = false;
                                            } else {
                                                phi_615_ = u32();
                                                phi_616_ = true;
                                            }
                                            let _e298 = phi_615_;
                                            let _e300 = phi_616_;
                                            phi_617_ = _e298;
                                            phi_618_ = _e300;
                                        } else {
                                            phi_617_ = u32();
                                            phi_618_ = true;
                                        }
                                        let _e302 = phi_617_;
                                        let _e304 = phi_618_;
                                        if _e304 {
                                            phi_622_ = _e276;
                                        } else {
                                            phi_622_ = _e302;
                                        }
                                        let _e306 = phi_622_;
                                        if ((_e276 + 1u) < 1024u) {
                                            phi_629_ = (_e276 + 1u);
                                        } else {
                                            phi_629_ = _e276;
                                        }
                                        let _e311 = phi_629_;
                                        phi_643_ = array<u32, 2>(((((_e285 - 1u) << bitcast<u32>(20u)) | ((_e283 - 1u) << bitcast<u32>(10u))) | _e306), ((((_e285 - 1u) << bitcast<u32>(20u)) | ((_e283 - 1u) << bitcast<u32>(10u))) | _e311));
                                    }
                                    let _e330 = phi_643_;
                                    phi_644_ = _e330;
                                    phi_645_ = _e289;
                                }
                                let _e332 = phi_644_;
                                let _e334 = phi_645_;
                                phi_646_ = _e332;
                                phi_647_ = _e334;
                            }
                            let _e336 = phi_646_;
                            let _e338 = phi_647_;
                            phi_648_ = _e336;
                            phi_649_ = _e338;
                        }
                        let _e340 = phi_648_;
                        let _e342 = phi_649_;
                        if _e342 {
                            phi_654_ = array<u32, 2>(1u, 0u);
                        } else {
                            phi_654_ = _e340;
                        }
                        let _e344 = phi_654_;
                        phi_661_ = array<u32, 2>((_e267 | _e344[0]), (_e267 | _e344[1]));
                    } else {
                        phi_661_ = array<u32, 2>(_e267, _e267);
                    }
                    let _e351 = phi_661_;
                    phi_662_ = _e351;
                }
                let _e386 = phi_662_;
                if (_e242 == 1u) {
                    phi_670_ = (_e231 + 1u);
                } else {
                    phi_670_ = 0u;
                }
                let _e392 = phi_670_;
                phi_673_ = array<u32, 3>(_e386[0], _e386[1], _e392);
            } else {
                phi_673_ = array<u32, 3>(4294967295u, 0u, 0u);
            }
            let _e395 = phi_673_;
            if _e236 {
                let _e400 = sorted.member[_e231];
                phi_690_ = _e400;
            } else {
                phi_690_ = type_16(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            }
            let _e402 = phi_690_;
            phi_693_ = type_9(0u, (((_e189 >> bitcast<u32>(24i)) & 15u) + 1u));
            loop {
                let _e405 = phi_693_;
                if (_e405.member < _e405.member_1) {
                    phi_694_ = type_9((_e405.member + 1u), _e405.member_1);
                    phi_717_ = type_9(1u, _e405.member);
                } else {
                    phi_694_ = _e405;
                    phi_717_ = type_9(0u, type_9().member_1);
                }
                let _e417 = phi_694_;
                let _e419 = phi_717_;
                let _e423 = (bitcast<i32>(_e419.member) != 0i);
                if _e423 {
                    let _e425 = (_e192 + (_e419.member_1 * 128u));
                    let _e426 = (_e425 + _e57);
                    if (_e426 < _e143) {
                        let _e429 = keys.member[_e426];
                        let _e431 = sorted.member[_e426];
                        phi_752_ = _e431;
                        phi_753_ = _e429;
                    } else {
                        phi_752_ = type_16(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                        phi_753_ = 4294967295u;
                    }
                    let _e433 = phi_752_;
                    let _e435 = phi_753_;
                    names[_e57] = _e435;
                    boxes[_e57] = type_16(array<f32, 3>(_e433.member[0], _e433.member[1], _e433.member[2]), array<f32, 3>(_e433.member_1[0], _e433.member_1[1], _e433.member_1[2]));
                    if (_e57 == 0u) {
                        atomicStore((&counters[4u]), 0u);
                    }
                    workgroupBarrier();
                    phi_774_ = type_9(0u, 128u);
                    loop {
                        let _e452 = phi_774_;
                        if (_e452.member < _e452.member_1) {
                            phi_775_ = type_9((_e452.member + 1u), _e452.member_1);
                            phi_798_ = type_9(1u, _e452.member);
                        } else {
                            phi_775_ = _e452;
                            phi_798_ = type_9(0u, type_9().member_1);
                        }
                        let _e464 = phi_775_;
                        let _e466 = phi_798_;
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
                                                        phi_911_ = type_9(_e553, _e558);
                                                    } else {
                                                        phi_911_ = type_9(_e558, _e553);
                                                    }
                                                    let _e563 = phi_911_;
                                                    phi_944_ = _e563;
                                                } else {
                                                    let _e524 = params.member.member_2.member;
                                                    if (_e524 == 1u) {
                                                        if (_e194 == 1u) {
                                                            let _e530 = params.member.member.member_2[2u];
                                                            phi_931_ = type_9(_e517, (_e515 - _e530));
                                                            phi_932_ = false;
                                                        } else {
                                                            phi_931_ = type_9();
                                                            phi_932_ = true;
                                                        }
                                                        let _e534 = phi_931_;
                                                        let _e536 = phi_932_;
                                                        phi_933_ = _e534;
                                                        phi_934_ = _e536;
                                                    } else {
                                                        phi_933_ = type_9();
                                                        phi_934_ = true;
                                                    }
                                                    let _e538 = phi_933_;
                                                    let _e540 = phi_934_;
                                                    if _e540 {
                                                        let _e544 = params.member.member.member_2[2u];
                                                        phi_943_ = type_9(_e515, (_e517 - _e544));
                                                    } else {
                                                        phi_943_ = _e538;
                                                    }
                                                    let _e548 = phi_943_;
                                                    phi_944_ = _e548;
                                                }
                                                let _e565 = phi_944_;
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
                            phi_774_ = _e464;
                            break if !(_e470);
                        }
                    }
                    workgroupBarrier();
                    let _e589 = atomicLoad((&counters[4u]));
                    if (2048u < _e589) {
                        phi_979_ = 2048u;
                    } else {
                        phi_979_ = _e589;
                    }
                    let _e592 = phi_979_;
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
                    phi_1005_ = type_9(0u, 16u);
                    loop {
                        let _e605 = phi_1005_;
                        if (_e605.member < _e605.member_1) {
                            phi_1006_ = type_9((_e605.member + 1u), _e605.member_1);
                            phi_1029_ = type_9(1u, _e605.member);
                        } else {
                            phi_1006_ = _e605;
                            phi_1029_ = type_9(0u, type_9().member_1);
                        }
                        let _e617 = phi_1006_;
                        let _e619 = phi_1029_;
                        if (bitcast<i32>(_e619.member) != 0i) {
                            let _e625 = ((_e619.member_1 * 128u) + _e57);
                            if (_e625 >= _e592) {
                                phi_1192_ = false;
                            } else {
                                let _e628 = hits[_e625];
                                let _e633 = params.member.member_2.member;
                                let _e636 = params.member.member_2.member_1;
                                if (_e636 == 0u) {
                                    phi_1058_ = array<u32, 2>(0u, 2u);
                                } else {
                                    phi_1058_ = array<u32, 2>(1u, 1u);
                                }
                                let _e639 = phi_1058_;
                                if (_e633 == 1u) {
                                    if (_e194 == 1u) {
                                        phi_1070_ = array<u32, 2>(_e639[1], _e639[0]);
                                        phi_1071_ = false;
                                    } else {
                                        phi_1070_ = array<u32, 2>();
                                        phi_1071_ = true;
                                    }
                                    let _e646 = phi_1070_;
                                    let _e648 = phi_1071_;
                                    phi_1072_ = _e646;
                                    phi_1073_ = _e648;
                                } else {
                                    phi_1072_ = array<u32, 2>();
                                    phi_1073_ = true;
                                }
                                let _e650 = phi_1072_;
                                let _e652 = phi_1073_;
                                if _e652 {
                                    phi_1078_ = _e639;
                                } else {
                                    phi_1078_ = _e650;
                                }
                                let _e654 = phi_1078_;
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
                                        phi_1141_ = type_9(_e704, _e709);
                                    } else {
                                        phi_1141_ = type_9(_e709, _e704);
                                    }
                                    let _e714 = phi_1141_;
                                    phi_1174_ = _e714;
                                } else {
                                    let _e675 = params.member.member_2.member;
                                    if (_e675 == 1u) {
                                        if (_e194 == 1u) {
                                            let _e681 = params.member.member.member_2[2u];
                                            phi_1161_ = type_9(_e668, (_e666 - _e681));
                                            phi_1162_ = false;
                                        } else {
                                            phi_1161_ = type_9();
                                            phi_1162_ = true;
                                        }
                                        let _e685 = phi_1161_;
                                        let _e687 = phi_1162_;
                                        phi_1163_ = _e685;
                                        phi_1164_ = _e687;
                                    } else {
                                        phi_1163_ = type_9();
                                        phi_1164_ = true;
                                    }
                                    let _e689 = phi_1163_;
                                    let _e691 = phi_1164_;
                                    if _e691 {
                                        let _e695 = params.member.member.member_2[2u];
                                        phi_1173_ = type_9(_e666, (_e668 - _e695));
                                    } else {
                                        phi_1173_ = _e689;
                                    }
                                    let _e699 = phi_1173_;
                                    phi_1174_ = _e699;
                                }
                                let _e716 = phi_1174_;
                                let _e721 = params.member.member_1.member_3;
                                let _e722 = (_e603 + _e625);
                                if (_e722 < _e721) {
                                    let _e724 = (2u * _e722);
                                    atomicStore((&pairs.member[(4u + _e724)]), _e716.member);
                                    atomicStore((&pairs.member[(_e724 + 5u)]), _e716.member_1);
                                }
                                phi_1192_ = true;
                            }
                            let _e730 = phi_1192_;
                            phi_1193_ = _e730;
                        } else {
                            phi_1193_ = false;
                        }
                        let _e732 = phi_1193_;
                        continue;
                        continuing {
                            phi_1005_ = _e617;
                            break if !(_e732);
                        }
                    }
                    workgroupBarrier();
                }
                continue;
                continuing {
                    phi_693_ = _e417;
                    break if !(_e423);
                }
            }
        }
        continue;
        continuing {
            phi_338_ = _e173;
            break if !(_e179);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn interval_pairs(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}

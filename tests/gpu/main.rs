//! The GPU against the CPU, through both paths for shaders: every kernel, whole steps on real
//! scenes, all published queries, and what happens when something fails.
//!
//! Without an adapter every test is ignored with the reason; with `CCD_GPU=require` that is a
//! failure. `CCD_ADAPTER` chooses one. Tests of scenes need the data, as in `truth.rs`. On a GPU
//! that is emulated some are left out (`emulated.rs`) but with `CCD_WHOLE=1`.

mod balanced;
mod builder_twin;
mod builders;
mod changes;
mod codimensional;
mod descent;
mod emulated;
mod end_points;
#[path = "../../examples/engine.rs"]
mod engine;
mod failures;
mod geometry;
mod groups;
mod in_flight;
mod intervals;
mod kept_order;
mod kernels;
mod limits;
mod listed;
#[path = "../sessions/moving_bodies.rs"]
mod moving_bodies;
mod oriented;
mod pair_stacks;
mod pairs;
mod poison;
mod queries;
mod recovery;
mod recursive;
mod rules;
mod scalars;
mod scenes;
mod search;
mod search_blocks;
mod search_trees;
mod sequences;
mod sorts;
mod stealing;
mod support;
mod tangential;
mod trees;
mod triangles;
mod twin;
mod units;
mod windows;
mod workers;

use ccd::gpu::{Device, DeviceOptions, Path, harness};
use libtest_mimic::{Arguments, Completion, Failed, Trial};

/// Names and tests that take a device.
pub type Tests = &'static [(&'static str, fn(&Device))];

/// A device of each path, or why there is none.
type Devices = Result<Vec<(String, Device)>, String>;

fn open() -> Devices {
    let mut out = Vec::new();
    for (name, path) in [("passthrough", Path::Passthrough), ("wgsl", Path::Wgsl)] {
        for (bits, integers) in [("f64", false), ("slow_f64", true), ("f32", true)] {
            let narrow = bits == "f32";
            if (bits, path) == ("slow_f64", Path::Wgsl) {
                continue;
            }
            let options = DeviceOptions {
                path: Some(path),
                narrow,
                integers: Some(integers),
                ..DeviceOptions::default()
            };
            let folder = std::env::var_os("CCD_CHECKED_SHADERS");
            let device = match folder.filter(|_| path == Path::Passthrough) {
                // SAFETY: whoever sets the variable has run `cargo xtask shaders --checked`.
                #[allow(unsafe_code, reason = "the driver gets what lies in a folder")]
                Some(folder) => unsafe { harness::open_checked(&options, folder.as_ref()) },
                None => Device::open(&options),
            };
            let device = device.map_err(|e| e.to_string())?;
            if !narrow && !device.info().wide {
                continue;
            }
            out.push((format!("{name}_{bits}"), device));
        }
    }
    Ok(out)
}

fn main() {
    let devices = open();
    let required = std::env::var("CCD_GPU").is_ok_and(|v| v == "require");
    if let Ok(devices) = &devices {
        println!("{}", devices[0].1.info());
    }
    let mut trials = Vec::new();
    let data = ccd_testkit::data::data_dir();
    let add = |trials: &mut Vec<Trial>,
               path: &str,
               test_name: &str,
               test: scenes::Runnable,
               device: Result<Device, String>| {
        let name = format!("{path}_{test_name}");
        let left_out =
            device.as_ref().ok().and_then(|device| emulated::left_out(test_name, device));
        if let Some(why) = left_out {
            let ignored = move || Ok(Completion::ignored_with(why));
            return trials.push(Trial::ignorable_test(name, ignored));
        }
        trials.push(Trial::ignorable_test(name, move || match (device, test) {
            (Ok(device), Ok(test)) => {
                test(&device);
                let failures = harness::failures(&device)?.unwrap_or_default();
                if !failures.is_empty() {
                    return Err(format!("indices past the end: {failures:?}").into());
                }
                Ok(support::take_not_run().map_or(Completion::Completed, Completion::ignored_with))
            }
            (Err(why), _) if required => {
                Err(Failed::from(format!("CCD_GPU=require, but there is no device: {why}")))
            }
            (Err(why), _) | (_, Err(why)) => Ok(Completion::ignored_with(why)),
        }));
    };
    let each: Vec<(&str, Result<Device, String>)> = match &devices {
        Ok(devices) => devices.iter().map(|(name, device)| (&**name, Ok(device.clone()))).collect(),
        Err(why) => vec![("no_device", Err(why.clone()))],
    };
    for (path, device) in each {
        let tests = [
            kernels::TESTS,
            sorts::TESTS,
            pairs::TESTS,
            trees::TESTS,
            builders::TESTS,
            changes::TESTS,
            kept_order::TESTS,
            listed::TESTS,
            rules::TESTS,
            triangles::TESTS,
            intervals::TESTS,
            end_points::TESTS,
            descent::TESTS,
            pair_stacks::TESTS,
            recursive::TESTS,
            workers::TESTS,
            balanced::TESTS,
            oriented::TESTS,
            stealing::TESTS,
            poison::TESTS,
            scalars::TESTS,
            failures::TESTS,
            limits::TESTS,
            recovery::TESTS,
            groups::TESTS,
            in_flight::TESTS,
            codimensional::TESTS,
            geometry::TESTS,
            scenes::TESTS,
            windows::TESTS,
            sequences::TESTS,
            tangential::TESTS,
            units::TESTS,
        ];
        emulated::check_names(&tests);
        for (name, test) in tests.into_iter().flatten() {
            add(&mut trials, path, name, Ok(Box::new(test)), device.clone());
        }
        let (name, test) = queries::test_of_data(&data);
        add(&mut trials, path, &name, test, device);
    }
    let anywhere: [(&str, fn()); 6] = [
        ("control_of_scenes", scenes::check_negative_controls),
        ("control_of_scalars", scalars::check_negative_control),
        ("control_of_kernels", kernels::check_negative_controls),
        ("control_of_poison", poison::check_negative_control),
        ("layouts_in_spirv", scalars::check_decorations),
        ("manifest_is_the_table", scalars::check_manifest),
    ];
    let trial = |(name, check): (&str, fn())| {
        Trial::test(name, move || {
            check();
            Ok(())
        })
    };
    trials.extend(anywhere.map(trial));
    let device = devices.as_ref().map(|_| ()).map_err(Clone::clone);
    trials.push(Trial::ignorable_test("example_engine", move || match device {
        Ok(()) => engine::main().map(|()| Completion::Completed).map_err(Failed::from),
        Err(why) if required => Err(Failed::from(why)),
        Err(why) => Ok(Completion::ignored_with(why)),
    }));
    let mut arguments = Arguments::from_args();
    // Devices are shared, and a software adapter uses all cores by itself.
    let n_threads = *arguments.test_threads.get_or_insert(1);
    if let Ok(devices) = &devices {
        // The last trial: with one thread all others ran before it.
        let all = n_threads == 1 && arguments.filter.is_none() && arguments.skip.is_empty();
        let wide = devices.iter().any(|(_, device)| device.info().wide);
        let subgroups = devices.iter().any(|(_, device)| device.info().subgroups);
        trials.push(Trial::ignorable_test("every_kernel_ran", move || {
            if !all {
                return Ok(Completion::ignored_with("only a part of the tests ran before"));
            }
            support::check_all_ran(wide, subgroups);
            Ok(Completion::Completed)
        }));
    }
    libtest_mimic::run(&arguments, trials).exit();
}

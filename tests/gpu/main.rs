//! The GPU against the CPU, through both paths for shaders: every kernel, whole steps on real scenes, all published queries, and what happens when something fails.
//!
//! Without an adapter every test is ignored with the reason; with `CCD_GPU=require` that is a failure. `CCD_ADAPTER` chooses one. Tests of scenes need the data, as
//! in `truth.rs`.

mod failures;
mod kernels;
mod pairs;
mod poison;
mod scalars;
mod scenes;
mod support;
mod twin;

use ccd::gpu::{Device, DeviceOptions, Path};
use libtest_mimic::{Arguments, Completion, Failed, Trial};

/// Names and tests that take a device.
pub type Tests = &'static [(&'static str, fn(&Device))];

/// A device of each path, or why there is none.
type Devices = Result<Vec<(&'static str, Device)>, String>;

fn open() -> Devices {
    let mut out = Vec::new();
    for (name, path) in [("passthrough", Path::Passthrough), ("wgsl", Path::Wgsl)] {
        for narrow in [false, true] {
            let options = DeviceOptions { path: Some(path), narrow, ..DeviceOptions::default() };
            let device = Device::open(&options).map_err(|e| e.to_string())?;
            if !narrow && !device.info().wide {
                continue;
            }
            let name: &'static str = match (name, narrow) {
                ("passthrough", false) => "passthrough_f64",
                ("passthrough", true) => "passthrough_f32",
                (_, false) => "wgsl_f64",
                (_, true) => "wgsl_f32",
            };
            out.push((name, device));
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
    let add = |trials: &mut Vec<Trial>, name: String, test: Box<dyn FnOnce(&Device) + Send>, device: Result<Device, String>| {
        trials.push(Trial::ignorable_test(name, move || match device {
            Ok(device) => {
                test(&device);
                Ok(Completion::Completed)
            }
            Err(why) if required => Err(Failed::from(format!("CCD_GPU=require, but there is no device: {why}"))),
            Err(why) => Ok(Completion::ignored_with(why)),
        }));
    };
    let each: Vec<(&str, Result<Device, String>)> = match &devices {
        Ok(devices) => devices.iter().map(|(name, device)| (*name, Ok(device.clone()))).collect(),
        Err(why) => vec![("no_device", Err(why.clone()))],
    };
    for (path, device) in each {
        for (name, test) in kernels::TESTS.iter().chain(pairs::TESTS).chain(poison::TESTS).chain(scalars::TESTS).chain(failures::TESTS) {
            add(&mut trials, format!("{path}_{name}"), Box::new(test), device.clone());
        }
        for (name, test) in scenes::tests() {
            add(&mut trials, format!("{path}_{name}"), test, device.clone());
        }
    }
    trials.push(Trial::test("negative_controls", || {
        scenes::check_negative_controls();
        scalars::check_negative_control();
        kernels::check_negative_controls();
        poison::check_negative_control();
        Ok(())
    }));
    trials.push(Trial::test("layouts_in_spirv", || {
        scalars::check_decorations();
        Ok(())
    }));
    trials.push(Trial::test("manifest_is_the_table", || {
        scalars::check_manifest();
        Ok(())
    }));
    let mut arguments = Arguments::from_args();
    // Devices are shared, and a software adapter uses all cores by itself.
    arguments.test_threads.get_or_insert(1);
    libtest_mimic::run(&arguments, trials).exit();
}

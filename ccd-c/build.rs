//! Gives the shared library the name by which programs load it.

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    let is = |what: &str, of: &str| {
        std::env::var(format!("CARGO_CFG_TARGET_{what}")).is_ok_and(|x| x == of)
    };
    if is("VENDOR", "apple") {
        println!("cargo::rustc-cdylib-link-arg=-Wl,-install_name,@rpath/libmeshccd.dylib");
    } else if is("FAMILY", "unix") {
        println!("cargo::rustc-cdylib-link-arg=-Wl,-soname,libmeshccd.so");
    }
}

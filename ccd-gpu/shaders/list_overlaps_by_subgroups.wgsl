// Generated from ccd-shaders by `cargo xtask shaders`: not to be edited.
// None: it needs acquire and release between workgroups.

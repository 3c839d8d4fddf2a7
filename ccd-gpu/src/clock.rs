//! Times as reports give them, from a clock where there is one; twin: the file of this name of
//! ccd-cpu.

ccd_core::clock!();

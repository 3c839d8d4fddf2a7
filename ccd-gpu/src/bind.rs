//! The buffers of each kernel by name: a structure a kernel, made from the kernel table.
//!
//! `B` is a buffer on the device, or, for [`crate::harness`], the bytes that one is filled with.

use bytemuck::Pod;
use ccd_core::backend::kernel::Id;
use ccd_core::backend::layout::Params;

/// A kernel with its buffers.
pub trait Bind<B> {
    /// The kernel.
    const ID: Id;
    /// Its record in [`Params`].
    type Args: Pod;
    /// Its buffers in the order of their bindings.
    fn buffers(&self) -> Vec<&B>;
    /// The same, to be changed.
    fn buffers_mut(&mut self) -> Vec<&mut B>;
}

/// Bytes reserved for the parameters of a dispatch: twice the greatest alignment of them that a
/// device may ask for.
pub const PARAMS_BYTES: usize = 512;

macro_rules! args {
    () => {
        ccd_core::backend::layout::Plain
    };
    ($args:ident) => {
        ccd_core::backend::layout::$args
    };
}

macro_rules! binds {
    ($($group:ident {$(
        $(#[$doc:meta])*
        $id:ident = $name:ident($threads:literal threads, $barriers:literal barriers, $float:ident
            $(, Params<$args:ident>)?) { $($field:ident: $access:ident),* }
    )*})*) => {$($(
        $(#[$doc])*
        #[derive(Clone, Debug)]
        pub struct $id<B> {
            $(
                #[doc = concat!("Access: `", stringify!($access), "`.")]
                pub $field: B,
            )*
        }

        impl<B> Bind<B> for $id<B> {
            const ID: Id = Id::$id;
            type Args = args!($($args)?);

            fn buffers(&self) -> Vec<&B> {
                vec![$(&self.$field),*]
            }

            fn buffers_mut(&mut self) -> Vec<&mut B> {
                vec![$(&mut self.$field),*]
            }
        }

        const _: () = assert!(size_of::<Params<args!($($args)?)>>() <= PARAMS_BYTES);
    )*)*};
}

ccd_core::kernels!(binds);

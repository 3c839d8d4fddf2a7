//! A macro for entry points: each names its threads, workgroup memory, record and views once.

/// The number of a thread.
#[derive(Clone, Copy)]
pub(crate) struct Thread {
    /// Its number among all.
    pub i: u32,
    /// Its number in its workgroup.
    pub lane: u32,
    /// Its workgroup, and how many there are; grids of more than 65,535 are folded into two
    /// dimensions.
    pub group: u32,
    pub groups: u32,
}

/// Makes an entry point with the name, threads, record and buffers of its row in
/// `ccd_core::kernels!`; tests compare both.
///
/// ```text
///   name[threads](thread; params: record; shared: array, ..; view: [T], mut written: [T], ..)
/// ```
///
/// A view is a storage buffer; bindings count from 1, behind `params`. With `by (s, i)` behind the
/// number of threads, they are numbered by their subgroups, of 32 threads each.
macro_rules! kernel {
    (
        $(#[$doc:meta])* $name:ident[$threads:tt $($by:tt)*]($thread:ident;
            $params:ident: $args:ident; $($shared:ident: $array:ty),*; $($views:tt)*) $body:block
    ) => {
        kernel! { @
            { $(#[$doc])* } $name [$threads $($by)*] $thread { $params: $args }
            { $($shared: $array),* } [1 2 3 4 5 6 7 8] [$($views)*,] [] $body
        }
    };
    (
        @ $doc:tt $name:ident $threads:tt $thread:ident $params:tt $shared:tt
        [$n:tt $($more:tt)*] [mut $view:ident: $ty:ty, $($rest:tt)*] [$($done:tt)*] $body:block
    ) => {
        kernel! { @
            $doc $name $threads $thread $params $shared [$($more)*] [$($rest)*]
            [$($done)*
                #[spirv(storage_buffer, descriptor_set = 0, binding = $n)] $view: &mut $ty,]
            $body
        }
    };
    (
        @ $doc:tt $name:ident $threads:tt $thread:ident $params:tt $shared:tt
        [$n:tt $($more:tt)*] [$view:ident: $ty:ty, $($rest:tt)*] [$($done:tt)*] $body:block
    ) => {
        kernel! { @
            $doc $name $threads $thread $params $shared [$($more)*] [$($rest)*]
            [$($done)* #[spirv(storage_buffer, descriptor_set = 0, binding = $n)] $view: &$ty,]
            $body
        }
    };
    (
        @ { $(#[$doc:meta])* } $name:ident [$threads:tt $(by ($subgroup:ident, $of:ident))?]
        $thread:ident { $params:ident: $args:ident }
        { $($shared:ident: $array:ty),* } $numbers:tt [$(,)?] [$($views:tt)*] $body:block
    ) => {
        $(#[$doc])*
        #[spirv_std::spirv(compute(threads($threads)))]
        pub fn $name(
            #[spirv(workgroup_id)] id: spirv_std::glam::UVec3,
            #[spirv(num_workgroups)] n: spirv_std::glam::UVec3,
            #[spirv(local_invocation_index)] lane: u32,
            $(
                #[spirv(subgroup_id)] $subgroup: u32,
                #[spirv(subgroup_local_invocation_id)] $of: u32,
            )?
            $(#[spirv(workgroup)] $shared: &mut $array,)*
            #[spirv(storage_buffer, descriptor_set = 0, binding = 0)]
            $params: &ccd_core::backend::layout::Params<ccd_core::backend::layout::$args>,
            $($views)*
        ) {
            $(
                let _ = lane;
                let lane = 32 * $subgroup + $of;
            )?
            let group = id.y * n.x + id.x;
            let (i, groups) = (group * $threads + lane, n.x * n.y);
            let $thread = crate::entry::Thread { i, lane, group, groups };
            $body
        }
    };
}

pub(crate) use kernel;

//! Results that stay where a device has them, for work that goes on there.

use super::Engine;
use super::in_flight::Sought;
use crate::error::Error;
use crate::growable_list::List;
use crate::step::frame::Frames;
use crate::step::upload::Input;
use ccd_core::model::options::Mode;
use ccd_core::model::positions::{AsPositions, Gathered, ends};
use ccd_core::model::session;

/// Results where a device has them, for work that goes on there. Valid until the session's next
/// call.
///
/// A list is a header of four words, of which the first is the number of entries, then the entries.
/// That number may exceed the capacity of a list in [`OnDevice::lists`], or the third word not be
/// 0: then results are incomplete, and [`Session::step`](session::Session::step) must be called
/// instead, which makes the list longer.
///
/// ```no_run
/// use ccd::gpu::{Error, Session, wgpu};
///
/// /// A step of whatever is in `session.paths()`, and a copy of its contacts to `out`.
/// fn frame(
///     session: &mut Session,
///     encoder: &mut wgpu::CommandEncoder,
///     out: &wgpu::Buffer,
/// ) -> Result<(), Error> {
///     let found = session.record(encoder)?;
///     let bytes = found.contacts.bytes(found.contacts.capacity());
///     encoder.copy_buffer_to_buffer(found.contacts.buffer(), 0, out, 0, bytes);
///     Ok(())
/// }
/// # let _ = frame;
/// ```
#[derive(Clone, Debug)]
pub struct OnDevice<'a> {
    /// Contacts: entries are [`Touch`](ccd_core::records::Touch). Those of state 1 the device could
    /// not decide: they do not touch before their time, which is that of the start if nothing is
    /// known, and are to be treated as contacts.
    pub contacts: &'a List,
    /// Every list of the frame, also those between stages: if the first word of any of them exceeds
    /// its capacity, or the third is not 0, results are incomplete.
    pub lists: Vec<&'a List>,
    /// One word: the bits of the earliest time of impact as `f32`, rounded down; greater than those
    /// of 1 if there is none. Without contacts of state 1, but in `f64` with a minimum distance:
    /// who steps by it looks for those as well.
    pub earliest: &'a wgpu::Buffer,
}

/// The contacts of a step with their geometry where a device has them. Valid until the session's
/// next call.
///
/// ```no_run
/// use ccd::gpu::{Error, Session, wgpu};
///
/// fn frame(session: &mut Session, encoder: &mut wgpu::CommandEncoder) -> Result<(), Error> {
///     session.record(encoder)?;
///     let found = session.record_geometry(encoder)?;
///     println!("{} bytes for {} contacts", found.geometry.size(), found.contacts.capacity());
///     Ok(())
/// }
/// # let _ = frame;
/// ```
#[derive(Clone, Debug)]
pub struct GeometryOnDevice<'a> {
    /// As in [`OnDevice::contacts`], including its capacity: its header counts here, too.
    pub contacts: &'a List,
    /// Record `i` is a [`TouchGeometry`](ccd_core::records::TouchGeometry) of entry `i`;
    /// without a header. Records behind the last contact are left as they were.
    pub geometry: &'a wgpu::Buffer,
}

impl Engine {
    /// As [`Session::candidates`](session::Session::candidates), but leaves the pairs on the
    /// device: vertex-face and edge-edge, until the next call. All of them fit.
    ///
    /// # Errors
    /// Those of [`Session::step`](session::Session::step).
    pub fn candidates_on_device<A, B>(&mut self, x0: &A, x1: &B) -> Result<[&List; 2], Error>
    where
        A: AsPositions + ?Sized,
        B: AsPositions<Scalar = A::Scalar> + ?Sized,
    {
        let mut gathered = Gathered::default();
        let given = session::given(&self.state.mesh, &mut gathered, ends(x0, x1));
        let done = given.map_err(Error::from);
        let device = self.device.clone();
        done.and_then(|given| {
            device.block_on(self.run(Input::new(given, None), Sought::CANDIDATES))
        })
        .inspect_err(|_| session::Engine::clear(self))?;
        let [vf, ee] = &self.frames.buffers.candidates;
        Ok([vf, ee])
    }

    /// The buffer of positions that [`Engine::record`] reads: one [`ccd_core::records::Path`] per
    /// vertex. May be written by copies and by kernels; coordinates must be finite and at most 2^28
    /// in size, which nothing checks. Another mesh may bring another buffer, and so may other
    /// options with a limit of memory.
    ///
    /// It is the caller's from now on: steps that begin later have another, and keep it while they
    /// are in flight. Not so a step that is in flight when this is called for the first time: until
    /// its results are here the buffer must not be written.
    pub fn paths(&self) -> &wgpu::Buffer {
        self.frames.buffers.positions.lend_paths()
    }

    /// Records a whole step, from the paths in [`Engine::paths`] to the lists of [`OnDevice`],
    /// into an encoder of the caller's; nothing is read back.
    ///
    /// The paths are taken as exact and must be finite. Submit the encoder before the session's
    /// next call. With a minimum distance, it is rounded to `f32`. Refused with free regions, which
    /// are certified from positions on the host, and for meshes with vertices of no edge that could
    /// touch each other or an edge of no face, which are decided there. Whether what is
    /// fixed moves is not seen.
    ///
    /// # Errors
    /// [`Error::PathsUnseen`] with free regions, [`Error::Codimensional`] for such meshes,
    /// [`Error::ExactOnDevice`] in that mode; what the device refuses.
    pub fn record(&mut self, encoder: &mut wgpu::CommandEncoder) -> Result<OnDevice<'_>, Error> {
        if self.codimensional.is_some() {
            return Err(Error::Codimensional);
        }
        self.check_conservative()?;
        self.abandon();
        let b =
            self.frames.record(&self.device, (&self.state.mesh, &self.state.options), encoder)?;
        Ok(OnDevice { contacts: &b.contacts, lists: b.lists().into_vec(), earliest: &b.earliest })
    }

    /// Records what writes point, normal, weights and vertices of every contact on the device that
    /// the last [`Engine::record`] or [`Session::step`](session::Session::step) has listed there,
    /// in the order of that list; nothing is read back. See
    /// [`contact_geometry`](ccd_core::narrow_phase::contact_geometry) for the rules.
    ///
    /// Into the encoder of [`Engine::record`] after it, or, after a step, into any. Submit the
    /// encoder before the session's next call. Computed in `f64` where the device has it and else
    /// in `f32`, from times rounded down to that.
    ///
    /// # Errors
    /// [`Error::NoContacts`] if the last call was another, which lists no contacts;
    /// [`Error::ExactOnDevice`] in that mode; no memory for 64 bytes a contact.
    pub fn record_geometry(
        &mut self,
        encoder: &mut wgpu::CommandEncoder,
    ) -> Result<GeometryOnDevice<'_>, Error> {
        self.check_conservative()?;
        self.abandon();
        let Frames { buffers, geometry, .. } = &mut self.frames;
        let geometry = geometry.record(&self.device, buffers, &self.state.options, encoder)?;
        Ok(GeometryOnDevice { contacts: &buffers.contacts, geometry })
    }

    fn check_conservative(&self) -> Result<(), Error> {
        match self.state.options.mode {
            Mode::Exact => Err(Error::ExactOnDevice),
            _ => Ok(()),
        }
    }
}

//! Changes between frames: device, mesh, options, bodies, capacity of lists; all of it or nothing.

use super::Frames;
use crate::device::Device;
use crate::error::Error;
use crate::readback::Readback;
use crate::recorder::Bench;
use crate::step::buffers::Buffers;
use crate::step::contact_geometry::Geometry;
use ccd_core::model::mesh::Mesh;
use ccd_core::model::options::Options;

impl Frames {
    /// Goes on with another device; nothing changes if this fails.
    pub fn move_to(
        &mut self,
        device: &Device,
        mesh: &Mesh,
        options: &Options,
    ) -> Result<(), Error> {
        let (buffers, mut bench) =
            (Buffers::new(device, mesh, options, None)?, Bench::new(device)?);
        bench.set_timing(self.bench.timing())?;
        (self.buffers, self.bench) = (buffers, bench);
        // What bodies take was counted by the device before.
        (self.stale, self.of_bodies) = (false, 0);
        self.readback = Readback::default();
        self.order.forget();
        self.geometry = Geometry::default();
        Ok(())
    }

    /// Takes the bodies of these options; the next frame sorts.
    pub fn set_bodies(
        &mut self,
        device: &Device,
        mesh: &Mesh,
        options: &Options,
    ) -> Result<(), Error> {
        self.order.forget();
        self.bench.forget();
        let buffers = &mut self.buffers;
        let ((), bytes) = device.counting(|| buffers.set_bodies(device, mesh, options))?;
        device.give_back(std::mem::replace(&mut self.of_bodies, bytes));
        Ok(())
    }

    /// Goes on with another mesh or other options, in the buffers that are there as far as they are
    /// large enough. The next frame sorts; nothing changes if this fails.
    pub fn change(&mut self, device: &Device, mesh: &Mesh, options: &Options) -> Result<(), Error> {
        self.stale = true;
        // Under a limit of memory nothing is reused: it could not be counted anew.
        let old = Some(&self.buffers).filter(|_| device.memory().is_none());
        self.buffers = Buffers::new(device, mesh, options, old)?;
        // Contacts there are those of other ids.
        self.geometry = Geometry::default();
        (self.stale, self.of_bodies) = (false, 0);
        self.bench.use_device(device);
        self.order.forget();
        self.at_once = 0;
        Ok(())
    }

    /// Gives every list this capacity.
    pub fn reserve(&mut self, device: &Device, entries: u32) -> Result<(), Error> {
        self.order.forget();
        self.geometry.listed = false;
        for list in self.buffers.lists_mut().into_vec() {
            let before = list.buffer().size();
            *list = list.resized(device, entries)?;
            device.give_back(before);
        }
        self.bench.forget();
        Ok(())
    }

    /// Sends edges and faces again after [`Frames::change`] has failed.
    pub(super) fn refresh(&mut self, device: &Device, mesh: &Mesh) -> Result<(), Error> {
        if self.stale {
            self.buffers.write_mesh(device, mesh)?;
            self.stale = false;
        }
        Ok(())
    }
}

//! Pixels that plots and legends are drawn on, and the file that they become. The letters of a text
//! are placed by fractions of a pixel, where the font wants them; plotters' own place each on a
//! whole pixel and leave out the space before it.

use super::{Failure, files, in_file};
use ab_glyph::{Font, FontRef, ScaleFont, point};
use plotters::backend::BitMapBackend;
use plotters::drawing::DrawingArea;
use plotters::style::{FontStyle, register_font};
use plotters_backend::text_anchor::{HPos, VPos};
use plotters_backend::{
    BackendColor, BackendCoord, BackendTextStyle, DrawingBackend, DrawingErrorKind,
};
use std::io::Write;
use std::path::Path;

/// The font travels with the program, none need be installed.
const FONT: &[u8] = epaint_default_fonts::UBUNTU_LIGHT;

pub type Area<'a> = DrawingArea<Pixels<'a>, plotters::coord::Shift>;
pub type Failed = Box<dyn std::error::Error>;

/// A file of a picture, which is opened before any work.
pub struct Picture<'a> {
    path: &'a Path,
    to: files::Output,
}

impl<'a> Picture<'a> {
    /// Opens the file, or standard output for `-`.
    pub fn create(path: &'a Path) -> Result<Self, Failure> {
        Ok(Self { path, to: files::create(path, &["png"])? })
    }

    /// Writes pixels, three bytes each, if they could be drawn, and puts the file in its place.
    pub fn save(mut self, size: (u32, u32), drawn: Result<Vec<u8>, Failed>) -> Result<(), Failure> {
        let png = drawn.and_then(|pixels| encoded(size, &pixels));
        let png = png.map_err(|e| in_file(self.path, e))?;
        let written = self.to.write_all(&png).and_then(|()| self.to.done());
        written.map_err(|e| files::failed(self.path, e))
    }
}

/// Pixels as the bytes of a small file.
fn encoded((width, height): (u32, u32), pixels: &[u8]) -> Result<Vec<u8>, Failed> {
    let mut png = Vec::new();
    let mut encoder = png::Encoder::new(&mut png, width, height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_compression(png::Compression::High);
    encoder.set_filter(png::Filter::Adaptive);
    encoder.write_header()?.write_image_data(pixels)?;
    Ok(png)
}

/// Three bytes a pixel, row by row.
pub struct Pixels<'a> {
    to: BitMapBackend<'a>,
    font: FontRef<'static>,
}

type Error<'a> = <BitMapBackend<'a> as DrawingBackend>::ErrorType;
type Done<'a> = Result<(), DrawingErrorKind<Error<'a>>>;

impl<'a> Pixels<'a> {
    /// Draws on pixels of a picture of a size.
    pub fn of(pixels: &'a mut [u8], size: (u32, u32)) -> Result<Self, Failed> {
        // So that plotters knows how large a text is.
        register_font("sans-serif", FontStyle::Normal, FONT)
            .map_err(|_| "the font cannot be read")?;
        let font = FontRef::try_from_slice(FONT)?;
        Ok(Self { to: BitMapBackend::with_buffer(pixels, size), font })
    }

    /// What is drawn of a text that begins at 0: pixels, and how much of each is covered.
    fn covered(&self, text: &str, size: f32) -> Vec<(i32, i32, f32)> {
        let font = self.font.as_scaled(size);
        let mut out = Vec::new();
        let (mut x, mut before) = (0.0, None);
        for c in text.chars() {
            let id = font.glyph_id(c);
            x += before.map_or(0.0, |before| font.kern(before, id));
            let glyph = id.with_scale_and_position(size, point(x, 0.5 * size));
            if let Some(outline) = font.outline_glyph(glyph) {
                let corner = outline.px_bounds().min;
                outline.draw(|i, j, part| {
                    out.push((corner.x as i32 + i as i32, corner.y as i32 + j as i32, part));
                });
            }
            x += font.h_advance(id);
            before = Some(id);
        }
        out
    }
}

impl<'a> DrawingBackend for Pixels<'a> {
    type ErrorType = Error<'a>;

    fn get_size(&self) -> (u32, u32) {
        self.to.get_size()
    }

    fn ensure_prepared(&mut self) -> Done<'a> {
        self.to.ensure_prepared()
    }

    fn present(&mut self) -> Done<'a> {
        self.to.present()
    }

    fn draw_pixel(&mut self, at: BackendCoord, colour: BackendColor) -> Done<'a> {
        self.to.draw_pixel(at, colour)
    }

    fn draw_text<S: BackendTextStyle>(
        &mut self,
        text: &str,
        style: &S,
        (x, y): BackendCoord,
    ) -> Done<'a> {
        let boxed = |e| DrawingErrorKind::FontError(Box::new(e));
        let (min, max) = style.layout_box(text).map_err(boxed)?;
        let (width, height) = (max.0 - min.0, max.1 - min.1);
        let left = match style.anchor().h_pos {
            HPos::Left => x,
            HPos::Right => x - width,
            HPos::Center => x - width / 2,
        };
        let top = match style.anchor().v_pos {
            VPos::Top => y,
            VPos::Center => y - height / 2,
            VPos::Bottom => y - height,
        };
        let (columns, rows) = self.get_size();
        for (i, j, part) in self.covered(text, style.size() as f32) {
            let (at, mut colour) = ((left + i, top + j), style.color());
            colour.alpha *= part.clamp(0.0, 1.0) as f64;
            if (0..columns as i32).contains(&at.0) && (0..rows as i32).contains(&at.1) {
                self.draw_pixel(at, colour)?;
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_keep_their_distance() {
        let mut pixels = vec![255u8; 300];
        let canvas = Pixels::of(&mut pixels, (10, 10)).unwrap();
        // Columns without ink between two letters: as wide at every place in a line, give or take
        // what a fraction of a pixel makes.
        let inked = |text: &str| {
            let mut columns: Vec<i32> = canvas.covered(text, 40.0).iter().map(|p| p.0).collect();
            columns.sort_unstable();
            columns.dedup();
            columns
        };
        let gaps: Vec<i32> =
            inked("llllllll").windows(2).map(|w| w[1] - w[0]).filter(|&gap| gap > 1).collect();
        let (least, most) = (gaps.iter().min().unwrap(), gaps.iter().max().unwrap());
        assert!(gaps.len() == 7 && most - least <= 1, "{gaps:?}");
        // The space before the first one is kept.
        assert!(inked("l")[0] > 0);
    }
}

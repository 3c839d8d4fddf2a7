//! What is written around a picture: two lines above it, below it a scale, what marks mean, and the
//! colours of times.

use super::canvas::{Colour, HEIGHT, WIDTH};
use super::pixels::{Area, Failed, Pixels};
use super::toi;
use ccd::geometry::vec3::lerp;
use plotters::prelude::*;

/// Pixels above and below the picture.
const TOP: u32 = 62;
const BOTTOM: u32 = 78;
/// Size of the picture with everything around it.
pub const SIZE_ALL: (u32, u32) = (WIDTH as u32, HEIGHT as u32 + TOP + BOTTOM);

/// Colours of the earliest to the latest time.
const TIMES: [Colour; 5] = [
    [0.10, 0.05, 0.50],
    [0.48, 0.02, 0.64],
    [0.80, 0.24, 0.42],
    [0.95, 0.50, 0.22],
    [0.98, 0.78, 0.20],
];

/// The colour of a part, 0 to 1, of the way from the earliest to the latest contact.
pub fn colour_of(part: f64) -> Colour {
    let at = part.clamp(0.0, 1.0) * (TIMES.len() - 1) as f64;
    let i = (at as usize).min(TIMES.len() - 2);
    lerp(TIMES[i], TIMES[i + 1], at - i as f64)
}

const INK: RGBColor = RGBColor(25, 28, 38);
const MARK: RGBColor = RGBColor(204, 61, 107);
const SIZE: u32 = 18;
/// The colour bar: left end, length, height.
const BAR: [i32; 3] = [860, 380, 14];

/// Contents of the legend.
pub struct Legend<'a> {
    pub lines: [&'a str; 2],
    pub pixels_per_unit: f64,
    /// The earliest and the latest time of impact.
    pub times: Option<[f64; 2]>,
    /// Whether there are undecided contacts.
    pub undecided: bool,
}

impl Legend<'_> {
    /// The picture with all of it around: three bytes a pixel.
    pub fn frame(&self, picture: &[u8]) -> Result<Vec<u8>, Failed> {
        let mut pixels = vec![255u8; (SIZE_ALL.0 * SIZE_ALL.1 * 3) as usize];
        let first = (TOP * SIZE_ALL.0 * 3) as usize;
        pixels[first..first + picture.len()].copy_from_slice(picture);
        let root = Pixels::of(&mut pixels, SIZE_ALL)?.into_drawing_area();
        write(&root, self.lines[0], [24, 8], SIZE + 4)?;
        write(&root, self.lines[1], [24, 34], SIZE)?;
        self.scale(&root)?;
        self.marks(&root)?;
        self.colours(&root)?;
        root.present()?;
        drop(root);
        Ok(pixels)
    }

    /// A bar of a round length.
    fn scale(&self, root: &Area) -> Result<(), Failed> {
        let length = round_length(150.0 / self.pixels_per_unit);
        let (from, y) = (24, bottom(56));
        let to = from + (length * self.pixels_per_unit).round() as i32;
        for [a, b] in
            [[(from, y), (to, y)], [(from, y - 6), (from, y + 6)], [(to, y - 6), (to, y + 6)]]
        {
            root.draw(&PathElement::new([a, b], INK.stroke_width(2)))?;
        }
        write(root, &format!("{} (unit of the mesh)", number(length)), [from, bottom(20)], SIZE)
    }

    fn marks(&self, root: &Area) -> Result<(), Failed> {
        let Some([first, _]) = self.times else {
            return Ok(());
        };
        let (x, y) = (390, bottom(24));
        root.draw(&Circle::new((x, y), 6, MARK.filled()))?;
        write(root, "contact", [x + 14, y - 10], SIZE)?;
        if self.undecided {
            let corners = [(x + 96, y - 6), (x + 108, y + 6)];
            root.draw(&Rectangle::new(corners, MARK.stroke_width(3)))?;
            write(root, "undecided", [x + 118, y - 10], SIZE)?;
        }
        root.draw(&Circle::new((x + 228, y), 11, INK.stroke_width(2)))?;
        write(root, &format!("earliest, t = {}", toi::plain(first)), [x + 248, y - 10], SIZE)?;
        write(root, "faint: behind a surface", [x - 6, bottom(46)], SIZE - 3)
    }

    fn colours(&self, root: &Area) -> Result<(), Failed> {
        let Some([first, last]) = self.times else {
            return write(root, "no contact", [390, bottom(14)], SIZE);
        };
        let ([left, length, height], y) = (BAR, bottom(30));
        write(root, "time of impact", [left, y - 24], SIZE - 2)?;
        for i in 0..length {
            let part = if last > first { i as f64 / length as f64 } else { 0.0 };
            let line = [(left + i, y), (left + i, y + height)];
            root.draw(&PathElement::new(line, rgb(colour_of(part)).stroke_width(1)))?;
        }
        write(root, &toi::plain(first), [left, y + height + 4], SIZE - 2)?;
        if last > first {
            let text = toi::plain(last);
            let style = ("sans-serif", SIZE - 2).into_font();
            let width = style.box_size(&text)?.0 as i32;
            write(root, &text, [left + length - width, y + height + 4], SIZE - 2)?;
        }
        Ok(())
    }
}

/// A row so many pixels below the picture.
fn bottom(y: i32) -> i32 {
    (TOP as usize + HEIGHT) as i32 + y
}

/// A text whose letters begin at this place, some pixels below where the font begins.
fn write(root: &Area, text: &str, [x, y]: [i32; 2], size: u32) -> Result<(), Failed> {
    let y = y + size as i32 / 3;
    root.draw(&Text::new(text.to_string(), (x, y), ("sans-serif", size).into_font().color(&INK)))?;
    Ok(())
}

fn rgb(c: Colour) -> RGBColor {
    let [r, g, b] = c.map(|c| (c * 255.0) as u8);
    RGBColor(r, g, b)
}

/// The greatest of 1, 2, 5 times a power of ten that is at most `x`.
fn round_length(x: f64) -> f64 {
    let power = 10f64.powf(x.log10().floor());
    let times = [5.0, 2.0].into_iter().find(|t| t * power <= x).unwrap_or(1.0);
    times * power
}

/// A length in few digits.
fn number(x: f64) -> String {
    if (1e-3..1e5).contains(&x) {
        format!("{}", (x * 1e6).round() / 1e6)
    } else {
        format!("{x:.0e}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_are_round() {
        for (x, want, text) in
            [(0.13, 0.1, "0.1"), (0.2, 0.2, "0.2"), (740.0, 500.0, "500"), (9.9e-9, 5e-9, "5e-9")]
        {
            assert!((round_length(x) / want - 1.0).abs() < 1e-12);
            assert_eq!(number(round_length(x)), text);
        }
    }
}

//! What is written around a picture: two lines above it, below it a scale, what marks mean, and the
//! colours of times.

use super::canvas::{BACK, Colour};
use super::pixels::{Area, Failed, Pixels};
use super::toi;
use ccd::geometry::vec3::lerp;
use plotters::prelude::*;

/// Units above and below the picture.
const TOP: f64 = 62.0;
const BOTTOM: f64 = 78.0;

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

/// Space of a picture and of its legend.
#[derive(Clone, Copy)]
pub struct Frame {
    /// Width and height of all, in pixels.
    size: [usize; 2],
    /// Pixels a unit, of which lengths in the code are: 1 in a picture of 1280 by 1020 pixels.
    pub unit: f64,
}

impl Frame {
    /// That of a picture of so many pixels.
    pub fn of(size: [usize; 2]) -> Self {
        let [width, height] = size.map(|n| n as f64);
        Self { size, unit: (width / 1280.0).min(height / 1020.0) }
    }

    /// Width and height of the picture without its legend, in pixels.
    pub fn area(&self) -> [usize; 2] {
        let [top, bottom] = [TOP, BOTTOM].map(|n| self.pixels(n) as usize);
        [self.size[0], self.size[1] - top - bottom]
    }

    fn pixels(&self, units: f64) -> i32 {
        (units * self.unit).round() as i32
    }

    fn size(&self) -> (u32, u32) {
        self.size.map(|n| n as u32).into()
    }

    /// A place so many units from the left and below the picture.
    fn below(&self, [x, y]: [i32; 2]) -> (i32, i32) {
        let bottom = self.pixels(TOP) + self.area()[1] as i32;
        (self.pixels(x.into()), bottom + self.pixels(y.into()))
    }

    fn style(&self, colour: RGBColor, width: u32) -> ShapeStyle {
        colour.stroke_width(self.pixels(width.into()).max(1) as u32)
    }
}

/// Contents of the legend.
pub struct Legend<'a> {
    pub frame: Frame,
    pub lines: [&'a str; 2],
    pub pixels_per_unit: f64,
    /// The earliest and the latest time of impact.
    pub times: Option<[f64; 2]>,
    /// What is said where there is none.
    pub nothing: &'a str,
    /// Whether there are undecided contacts.
    pub undecided: bool,
    /// Whether backs of faces are to be seen.
    pub backs: bool,
}

impl Legend<'_> {
    /// The picture with all of it around: three bytes a pixel.
    pub fn around(&self, picture: &[u8]) -> Result<Vec<u8>, Failed> {
        let size = self.frame.size();
        let mut pixels = vec![255u8; (size.0 * size.1 * 3) as usize];
        let first = (self.frame.pixels(TOP) as u32 * size.0 * 3) as usize;
        pixels[first..first + picture.len()].copy_from_slice(picture);
        let root = Pixels::of(&mut pixels, size)?.into_drawing_area();
        for (line, y, letters) in [(self.lines[0], 8.0, SIZE + 4), (self.lines[1], 34.0, SIZE)] {
            let place = [24.0, y].map(|n| self.frame.pixels(n));
            let most = size.0 as i32 - 2 * place[0];
            self.write(&root, &self.fitted(line, letters, most)?, place.into(), letters)?;
        }
        self.scale(&root)?;
        self.marks(&root)?;
        self.colours(&root)?;
        root.present()?;
        drop(root);
        Ok(pixels)
    }

    /// A bar of a round length.
    fn scale(&self, root: &Area) -> Result<(), Failed> {
        let length = round_length(150.0 * self.frame.unit / self.pixels_per_unit);
        let (from, y) = self.frame.below([24, 56]);
        let (to, end) = (from + (length * self.pixels_per_unit).round() as i32, self.end());
        for [a, b] in [
            [(from, y), (to, y)],
            [(from, y - end), (from, y + end)],
            [(to, y - end), (to, y + end)],
        ] {
            root.draw(&PathElement::new([a, b], self.frame.style(INK, 2)))?;
        }
        self.below(root, &format!("{} units of the mesh", number(length)), [24, 20], SIZE)
    }

    /// Half of the side of a small thing, in pixels.
    fn end(&self) -> i32 {
        self.frame.pixels(6.0)
    }

    fn marks(&self, root: &Area) -> Result<(), Failed> {
        let x = 390;
        if self.backs {
            let style = rgb(BACK).filled();
            root.draw(&Rectangle::new(self.square([x + 228, 56]), style))?;
            self.below(root, "back of a face", [x + 248, 46], SIZE - 3)?;
        }
        let Some([first, _]) = self.times else {
            return Ok(());
        };
        root.draw(&Circle::new(self.frame.below([x, 24]), self.end(), MARK.filled()))?;
        self.below(root, "contact", [x + 14, 14], SIZE)?;
        if self.undecided {
            root.draw(&Rectangle::new(self.square([x + 102, 24]), self.frame.style(MARK, 3)))?;
            self.below(root, "undecided", [x + 118, 14], SIZE)?;
        }
        let (ring, radius) = (self.frame.below([x + 228, 24]), self.frame.pixels(11.0));
        root.draw(&Circle::new(ring, radius, self.frame.style(INK, 2)))?;
        self.below(root, &format!("earliest, t = {}", toi::plain(first)), [x + 248, 14], SIZE)?;
        self.below(root, "faint: behind a surface", [x - 6, 46], SIZE - 3)
    }

    /// Corners of a small square around a place.
    fn square(&self, middle: [i32; 2]) -> [(i32, i32); 2] {
        let ((x, y), end) = (self.frame.below(middle), self.end());
        [(x - end, y - end), (x + end, y + end)]
    }

    fn colours(&self, root: &Area) -> Result<(), Failed> {
        let Some([first, last]) = self.times else {
            return self.below(root, self.nothing, [390, 14], SIZE);
        };
        let [left, length, height] = BAR;
        self.below(root, "time of impact", [left, 6], SIZE - 2)?;
        let ((from, top), (to, bottom)) =
            (self.frame.below([left, 30]), self.frame.below([left + length, 30 + height]));
        for x in from..to {
            let part = if last > first { (x - from) as f64 / (to - from) as f64 } else { 0.0 };
            let style = rgb(colour_of(part)).stroke_width(1);
            root.draw(&PathElement::new([(x, top), (x, bottom)], style))?;
        }
        let below = self.frame.pixels(4.0);
        self.write(root, &toi::plain(first), (from, bottom + below), SIZE - 2)?;
        if last > first {
            let text = toi::plain(last);
            let place = (to - self.width_of(&text, SIZE - 2)?, bottom + below);
            self.write(root, &text, place, SIZE - 2)?;
        }
        Ok(())
    }

    /// Writes so many units from the left and below the picture.
    fn below(&self, root: &Area, text: &str, at: [i32; 2], size: u32) -> Result<(), Failed> {
        self.write(root, text, self.frame.below(at), size)
    }

    /// A text whose letters begin at this place, some pixels below where the font begins.
    fn write(&self, root: &Area, text: &str, at: (i32, i32), size: u32) -> Result<(), Failed> {
        let size = self.frame.pixels(size.into());
        let style = ("sans-serif", size).into_font().color(&INK);
        root.draw(&Text::new(text.to_string(), (at.0, at.1 + size / 3), style))?;
        Ok(())
    }

    /// Width of a text in pixels.
    fn width_of(&self, text: &str, size: u32) -> Result<i32, Failed> {
        let style = ("sans-serif", self.frame.pixels(size.into())).into_font();
        Ok(style.box_size(text)?.0 as i32)
    }

    /// A text that is cut where it would be wider than `most` pixels.
    fn fitted(&self, text: &str, size: u32, most: i32) -> Result<String, Failed> {
        let (mut kept, mut out) = (text.to_owned(), text.to_owned());
        while self.width_of(&out, size)? > most && kept.pop().is_some() {
            out = format!("{kept}..");
        }
        Ok(out)
    }
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

//! Line plots of numbers over frames, one above the other.

use super::Failure;
use super::pixels::{Failed, Picture, Pixels};
use plotters::prelude::*;

const WIDTH: u32 = 1200;
const HEIGHT_EACH: u32 = 320;
/// Above them: what was run on what.
const TITLE: u32 = 44;
const COLOURS: [RGBColor; 3] =
    [RGBColor(31, 90, 160), RGBColor(200, 40, 40), RGBColor(60, 130, 60)];

/// So few values are marked one by one.
const FEW: usize = 60;

/// Numbers over frames.
pub struct Series<'a> {
    pub name: &'a str,
    /// NaN is left out.
    pub values: &'a [f64],
    /// The top of the axis, if it does not follow from the values.
    pub top: Option<f64>,
}

impl<'a> Series<'a> {
    /// Values that are 0 or more.
    pub fn new(name: &'a str, values: &'a [f64]) -> Self {
        Self { name, values, top: None }
    }
}

/// Writes one plot per series, all over the same axis; each has its name and starts at 0. `title`:
/// the scene, and the backend that ran it. `axis`: its name, and its number at the first value.
pub fn write<const N: usize>(
    to: Picture,
    title: &str,
    axis: (&str, usize),
    series: [Series; N],
) -> Result<(), Failure> {
    let size = (WIDTH, TITLE + HEIGHT_EACH * N as u32);
    let mut pixels = vec![255u8; (size.0 * size.1 * 3) as usize];
    let drawn = draw(&mut pixels, size, title, axis, series);
    to.save(size, drawn.map(|()| pixels))
}

fn draw<const N: usize>(
    pixels: &mut [u8],
    size: (u32, u32),
    title: &str,
    (axis, first): (&str, usize),
    series: [Series; N],
) -> Result<(), Failed> {
    let root = Pixels::of(pixels, size)?.into_drawing_area();
    let (above, below) = root.split_vertically(TITLE);
    above.draw(&Text::new(title.to_string(), (16, 14), ("sans-serif", 22).into_font()))?;
    for (k, (area, series)) in below.split_evenly((N, 1)).iter().zip(series).enumerate() {
        let Series { name, values, top } = series;
        let most = values.iter().fold(0.0f64, |m, &v| m.max(v));
        // Counts have no fractions; what is small has as many digits as tell its lines apart.
        let is_count = top.is_none() && values.iter().all(|v| v.is_nan() || v.fract() == 0.0);
        let top = top.unwrap_or(if most > 0.0 { most * 1.08 } else { 1.0 });
        let last = first + values.len().max(2) - 1;
        let caption = match values {
            [] => format!("{name}: there is no {axis}"),
            _ if values.iter().all(|v| v.is_nan()) => format!("{name}: there is none"),
            _ => name.to_owned(),
        };
        let mut chart = ChartBuilder::on(area)
            .caption(caption, ("sans-serif", 26))
            .margin(14)
            .x_label_area_size(44)
            .y_label_area_size(90)
            .build_cartesian_2d(first..last, 0.0..top)?;
        let digits = (1.0 - top.log10().floor()).clamp(0.0, 9.0) as usize;
        let number = |v: &f64| match is_count {
            true if v.fract() != 0.0 => String::new(),
            true => format!("{v:.0}"),
            false => format!("{v:.digits$}"),
        };
        chart
            .configure_mesh()
            .x_desc(axis)
            .label_style(("sans-serif", 17))
            .axis_desc_style(("sans-serif", 19))
            .light_line_style(WHITE)
            .bold_line_style(RGBColor(225, 225, 230))
            .y_label_formatter(&number)
            .draw()?;
        let colour = COLOURS[k % COLOURS.len()].stroke_width(2);
        let points: Vec<(usize, f64)> = (first..).zip(values.iter().copied()).collect();
        for run in points.split(|point| point.1.is_nan()) {
            // One alone makes no line.
            let marks = if values.len() <= FEW || run.len() == 1 { 3 } else { 0 };
            let run = run.iter().copied();
            chart.draw_series(LineSeries::new(run, colour.filled()).point_size(marks))?;
        }
    }
    root.present()?;
    Ok(())
}

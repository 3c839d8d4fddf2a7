//! Line plots of numbers over frames, one above the other.

use super::{Failure, in_file};
use plotters::prelude::*;
use plotters::style::{FontStyle, register_font};
use std::path::Path;

const WIDTH: u32 = 1200;
const HEIGHT_EACH: u32 = 320;
const COLOURS: [RGBColor; 3] =
    [RGBColor(31, 90, 160), RGBColor(200, 40, 40), RGBColor(60, 130, 60)];

/// Writes one plot per series, all over the same axis; each has its name and starts at 0.
pub fn write<const N: usize>(
    path: &Path,
    axis: &str,
    series: [(&str, &[f64]); N],
) -> Result<(), Failure> {
    let height = HEIGHT_EACH * N as u32;
    let mut pixels = vec![255u8; (WIDTH * height * 3) as usize];
    draw(&mut pixels, (WIDTH, height), axis, series).map_err(|e| in_file(path, e))?;
    let image = image::RgbImage::from_raw(WIDTH, height, pixels)
        .ok_or_else(|| in_file(path, "a picture of the wrong size"))?;
    image.save_with_format(path, image::ImageFormat::Png).map_err(|e| in_file(path, e))
}

fn draw<const N: usize>(
    pixels: &mut [u8],
    size: (u32, u32),
    axis: &str,
    series: [(&str, &[f64]); N],
) -> Result<(), Box<dyn std::error::Error>> {
    // The font travels with the program: none need be installed.
    register_font("sans-serif", FontStyle::Normal, epaint_default_fonts::UBUNTU_LIGHT)
        .map_err(|_| "the font cannot be read")?;
    let root = BitMapBackend::with_buffer(pixels, size).into_drawing_area();
    root.fill(&WHITE)?;
    for (k, (area, (name, values))) in root.split_evenly((N, 1)).iter().zip(series).enumerate() {
        let top = values.iter().fold(0.0f64, |m, &v| m.max(v)).max(1e-9) * 1.08;
        let last = values.len().max(2) - 1;
        let mut chart = ChartBuilder::on(area)
            .caption(name, ("sans-serif", 26))
            .margin(14)
            .x_label_area_size(44)
            .y_label_area_size(90)
            .build_cartesian_2d(0..last, 0.0..top)?;
        let number = |v: &f64| if top < 10.0 { format!("{v:.2}") } else { format!("{v:.0}") };
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
        chart.draw_series(LineSeries::new(values.iter().copied().enumerate(), colour))?;
    }
    root.present()?;
    Ok(())
}

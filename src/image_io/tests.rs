//! Encoding and decoding again gives the original.

use super::*;

/// A test picture with every 8-bit code in every channel, also in alpha.
fn picture_of_all_codes() -> Frame {
    let rgba: Vec<u8> = (0..=255u8).flat_map(|i| [i, 255 - i, i ^ 0x55, i.max(1)]).collect();
    Pixels { width: 16, height: 16, channels: 4, samples: Samples::U8(rgba) }.to_linear_image()
}

fn encode_test_picture(frame: &Frame, format: Format, depth: u8, alpha: bool) -> Vec<u8> {
    encode(frame, &Encoding { format, depth, alpha, ..Encoding::new(format) }).unwrap()
}

fn round_trip(frame: &Frame, format: Format, depth: u8, alpha: bool) -> Pixels {
    decode_pixels(&encode_test_picture(frame, format, depth, alpha), format.name()).unwrap()
}

/// Test: a bmp is dithered from the bottom; turned upside down, it equals the png of the picture turned upside down.
#[test]
fn bmp_is_dithered_from_the_bottom() {
    let light = |x: usize, y: usize| (x * 7 + y * 13) as f32 / 500.0;
    let pixel = |at: usize, turned: bool| {
        let y = if turned { 15 - at / 16 } else { at / 16 };
        [light(at % 16, y), light(y, at % 16), 0.3, 1.0]
    };
    for (dither, upside_down) in [(Dither::FloydSteinberg, true), (Dither::Row, true), (Dither::Bayer(3), false)] {
        let read = |format: Format, turned: bool| {
            let frame = Frame { width: 16, height: 16, pixels: (0..256).map(|at| pixel(at, turned)).collect() };
            let bytes = encode(&frame, &Encoding { dither: Some(dither), ..Encoding::new(format) }).unwrap();
            image::load_from_memory(&bytes).unwrap().to_rgb8()
        };
        let (bmp, png) = (read(Format::Bmp, false), read(Format::Png, upside_down));
        let png = if upside_down { image::imageops::flip_vertical(&png) } else { png };
        assert!(bmp == png, "{dither:?}");
    }
}

/// Test: the gray of a picture is the brightness of its light in the file's curve, as with POV-Ray's `+FNg` (its output
/// for `rgb <1, 0.3, 0.1>` as 16 bits).
#[test]
fn gray_is_brightness() {
    let frame = Frame { width: 2, height: 1, pixels: vec![[1.0, 0.3, 0.1, 1.0], [0.5, 0.5, 0.5, 0.5]] };
    for (format, alpha, depth) in
        [(Format::Png, false, 16), (Format::Png, true, 16), (Format::Png, false, 8), (Format::Ppm, false, 16)]
    {
        let bytes = encode(&frame, &Encoding { gray: true, alpha, depth, ..Encoding::new(format) }).unwrap();
        let read = image::load_from_memory(&bytes).unwrap();
        assert!(!read.color().has_color(), "{format:?}");
        assert_eq!(
            (read.color().has_alpha(), read.color().bytes_per_pixel()),
            (alpha, depth / 8 * (1 + u8::from(alpha)))
        );
        let light = 0.297 + 0.589 * 0.3 + 0.114 * 0.1;
        let code = crate::color::transfer::srgb_encode(light) * 65_535.0;
        let first = read.to_luma_alpha16().get_pixel(0, 0).0;
        assert!((f64::from(first[0]) - code).abs() <= if depth == 16 { 1.0 } else { 257.0 }, "{first:?} {code}");
        if alpha {
            assert_eq!(read.to_luma_alpha16().get_pixel(1, 0).0[1], 32_768);
        }
    }
}

#[test]
fn integer_pixels_survive_a_round_trip() {
    let frame = picture_of_all_codes();
    for format in [Format::Png, Format::Bmp, Format::Tga, Format::Tiff] {
        for depth in [8, 16] {
            if format.check_limits(16, 16, Some(depth)).is_ok() {
                let back = round_trip(&frame, format, depth, true);
                assert_eq!((back.width, back.height, back.channels), (16, 16, 4), "{format:?}");
                assert_eq!(back.to_linear_image().rgba8(), frame.rgba8(), "{format:?} {depth}");
            }
        }
    }
}

#[test]
fn without_alpha_pictures_are_composited_over_black() {
    let frame = picture_of_all_codes();
    let opaque = frame.over_black();
    for format in [Format::Png, Format::Ppm, Format::Bmp, Format::Tga, Format::Tiff] {
        let back = round_trip(&frame, format, 8, false);
        assert_eq!(back.channels, 3, "{format:?}");
        assert_eq!(back.to_linear_image().rgba8(), opaque.rgba8(), "{format:?}");
    }
    assert_eq!(round_trip(&frame, Format::Ppm, 16, false).to_linear_image().rgba8(), opaque.rgba8());
}

#[test]
fn floating_point_pixels_survive_a_round_trip() {
    let pixels = vec![[0.25, 3.5, 1e-3, 1.0], [100.0, 0.0, 0.5, 0.5], [f32::NAN, 1.0, 1.0, 1.0], [0.0; 4]];
    let frame = Frame { width: 2, height: 2, pixels };
    let back = round_trip(&frame, Format::Exr, 8, true).to_linear_image();
    assert_eq!(back.pixels[..2], frame.pixels[..2]);
    assert_eq!(back.pixels[2..], [[0.0, 1.0, 1.0, 1.0], [0.0; 4]]);
    assert_eq!(round_trip(&frame, Format::Exr, 8, false).to_linear_image().pixels[1], [50.0, 0.0, 0.25, 1.0]);
    let hdr = round_trip(&frame, Format::Hdr, 8, false).to_linear_image();
    assert!((hdr.pixels[0][1] - 3.5).abs() < 0.02);
}

#[test]
fn extreme_light_fits_a_shared_exponent() {
    let frame = Frame { width: 3, height: 1, pixels: vec![[f32::INFINITY, 1.0, f32::NAN, 1.0], [1e-45; 4], [1e38; 4]] };
    let pixels = round_trip(&frame, Format::Hdr, 8, false).to_linear_image().pixels;
    assert!(pixels[0][0] > 8e37 && pixels[0][2] < 1e36, "{:?}", pixels[0]);
    assert_eq!(pixels[1][..3], [0.0; 3]);
    assert!((8e37..9e37).contains(&pixels[2][1]), "{:?}", pixels[2]);
}

#[test]
fn jpg_decodes_near_the_original() {
    let gray = Frame { width: 8, height: 8, pixels: vec![[0.5, 0.5, 0.5, 1.0]; 64] };
    let back = round_trip(&gray, Format::Jpg, 8, false).to_linear_image();
    assert!((back.pixels[9][0] - 0.5).abs() < 0.02);
}

#[test]
fn ppm_files_have_these_bytes() {
    let frame = Frame { width: 2, height: 1, pixels: vec![[1.0, 0.5, 0.0, 1.0], [0.0, 0.0, 1.0, 1.0]] };
    assert_eq!(encode_test_picture(&frame, Format::Ppm, 8, false), b"P6\n2 1\n255\n\xff\xbc\x00\x00\x00\xff");
    assert_eq!(
        encode_test_picture(&frame, Format::Ppm, 16, false),
        b"P6\n2 1\n65535\n\xff\xff\xbc\x40\x00\x00\x00\x00\x00\x00\xff\xff"
    );
}

#[test]
fn the_same_picture_gives_the_same_bytes() {
    let frame = picture_of_all_codes();
    for name in Format::names() {
        let format = Format::from_name(name).unwrap();
        assert_eq!(
            encode_test_picture(&frame, format, 8, true),
            encode_test_picture(&frame, format, 8, true),
            "{name}"
        );
    }
}

#[test]
fn broken_files_are_refused_in_words() {
    for bytes in [&b"\x89PNG\r\n\x1a\nxxxx"[..], b"", b"hello", b"\x76\x2f\x31\x01", b"\xff\xd8\xff"] {
        assert!(decode_pixels(bytes, "png").is_err());
    }
}

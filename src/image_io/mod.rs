//! Decoders and encoders of picture files; no other module reads or writes them.

mod adler32;
mod bmp;
mod decode;
mod density;
mod dither;
mod encode;
mod format;
mod frame;
mod netpbm;
mod open_exr;
mod picture;
mod png_filter;
mod png_palette;
mod png_piece;
mod png_writer;
mod quantize;
mod radiance;
#[cfg(test)]
mod tests;
mod tga;
mod tiff_palette;

use decode::{Decoded, decode_picture_bytes};
pub use decode::{Pixels, Samples, decode_picture_file, decode_pixels, expand_pixel};
pub use density::Voxels;
pub use dither::Dither;
pub use encode::{EncodeError, Encoder, Encoding, Packing, Rows, encode};
pub use format::{Format, SIGNATURE_BYTES, begins_like_a_picture};
pub use frame::Frame;
pub use picture::{Picture, Stored, round_gray_like_povray, scale_and_wrap_to_u16};
pub use png_piece::{CompressedPieces, Pieces};

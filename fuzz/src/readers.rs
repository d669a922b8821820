//! Properties of the readers of pictures, meshes, fonts, density files, INI files, resume journals,
//! shards and files of light.

use crate::Corpus;
use durer::Memory;
use durer::cli::fuzzing;
use durer::image_io::{Picture, Pixels, Samples, Voxels, decode_pixels};
use durer::mesh_io::{NONE, Triangles, read_mesh_file};
use std::path::Path;

/// Largest decoded picture that is converted to linear light, in samples.
const MAX_SAMPLES: usize = 1 << 20;

/// Decodes a picture that begins with `signature`, and checks the number of samples.
fn picture(bytes: &[u8], signature: &[u8], ending: &str) -> Corpus {
    if !bytes.starts_with(signature) {
        return Corpus::Reject;
    }
    let Ok(pixels) = decode_pixels(bytes, ending) else { return Corpus::Keep };
    let Pixels { width, height, channels, ref samples } = pixels;
    let count = match samples {
        Samples::U8(samples) => samples.len(),
        Samples::U16(samples) => samples.len(),
        Samples::F32(samples) => samples.len(),
    };
    assert!(width > 0 && height > 0 && (1..=4).contains(&channels), "{width}x{height} pixels of {channels} channels");
    assert_eq!(count, width * height * channels, "number of samples");
    if count <= MAX_SAMPLES {
        assert_eq!(pixels.to_linear_image().pixels.len(), width * height);
        let (files, path) = (Memory::default(), Path::new("a").with_extension(ending));
        files.insert(&path, bytes);
        Picture::read(&files, &path).expect("the picture was decoded before");
    }
    Corpus::Keep
}

/// Checks the reader of PNG files.
pub fn picture_png(bytes: &[u8]) -> Corpus {
    picture(bytes, b"\x89PNG", "png")
}

/// Checks the reader of JPEG files.
pub fn picture_jpeg(bytes: &[u8]) -> Corpus {
    picture(bytes, b"\xff\xd8", "jpg")
}

/// Checks the reader of GIF files.
pub fn picture_gif(bytes: &[u8]) -> Corpus {
    picture(bytes, b"GIF8", "gif")
}

/// Checks the reader of TGA files, which have no signature.
pub fn picture_tga(bytes: &[u8]) -> Corpus {
    picture(bytes, b"", "tga")
}

/// Checks the readers of PBM, PGM, PPM and PAM files.
pub fn picture_netpbm(bytes: &[u8]) -> Corpus {
    picture(bytes, b"P", "ppm")
}

/// Checks the reader of BMP files.
pub fn picture_bmp(bytes: &[u8]) -> Corpus {
    picture(bytes, b"BM", "bmp")
}

/// Checks the reader of TIFF files.
pub fn picture_tiff(bytes: &[u8]) -> Corpus {
    if bytes.starts_with(b"MM") { picture(bytes, b"MM", "tif") } else { picture(bytes, b"II", "tif") }
}

/// Checks the reader of OpenEXR files.
pub fn picture_exr(bytes: &[u8]) -> Corpus {
    picture(bytes, &[0x76, 0x2f, 0x31, 0x01], "exr")
}

/// Checks the reader of Radiance HDR files.
pub fn picture_radiance(bytes: &[u8]) -> Corpus {
    picture(bytes, b"#?", "hdr")
}

/// Reads a mesh file, and checks that its indices are inside of their lists. Files that the mesh file names have the
/// contents of the mesh file itself.
fn mesh(bytes: &[u8], ending: &str) -> Corpus {
    let Ok(mesh) = read_mesh_file(bytes, ending, &mut |_| Ok(bytes.to_vec())) else { return Corpus::Keep };
    let Triangles { vertices, normals, uvs, corners, smooth, mapped, painted } = &mesh.triangles;
    let inside = |list: &[[u32; 3]], count: usize| {
        let indices = list.iter().filter(|three| **three != NONE).flatten();
        indices.for_each(|index| assert!((*index as usize) < count, "index {index} of {count}"));
    };
    inside(corners, vertices.len());
    inside(smooth, normals.len());
    inside(mapped, uvs.len());
    inside(painted, mesh.materials.len() + 1);
    for list in [smooth, mapped, painted] {
        assert!(list.is_empty() || list.len() == corners.len(), "{} of {} triangles", list.len(), corners.len());
    }
    assert!(vertices.iter().all(|vertex| vertex.is_finite()), "a vertex is not finite");
    assert!(normals.iter().all(|normal| normal.is_finite()), "a normal is not finite");
    Corpus::Keep
}

/// Checks the reader of PLY files.
pub fn mesh_ply(bytes: &[u8]) -> Corpus {
    mesh(bytes, "ply")
}

/// Checks the readers of OBJ and MTL files.
pub fn mesh_obj(bytes: &[u8]) -> Corpus {
    mesh(bytes, "obj")
}

/// Checks the reader of STL files.
pub fn mesh_stl(bytes: &[u8]) -> Corpus {
    mesh(bytes, "stl")
}

/// Checks the reader of glTF files, as text and as binary.
pub fn mesh_gltf(bytes: &[u8]) -> Corpus {
    mesh(bytes, "gltf")
}

/// Checks the reader of density files.
pub fn density(bytes: &[u8]) -> Corpus {
    let Ok(voxels) = Voxels::decode_df3(bytes) else { return Corpus::Keep };
    for at in [[0; 3], voxels.size.map(|n| n - 1)] {
        assert!((0.0..=1.0).contains(&voxels.density_at(at)));
    }
    Corpus::Keep
}

/// Checks the reader of fonts.
pub fn font(bytes: &[u8]) -> Corpus {
    fuzzing::read_font(bytes);
    Corpus::Keep
}

/// Checks the readers of INI files and of POV-Ray's command lines.
pub fn options(bytes: &[u8]) -> Corpus {
    let Ok(text) = std::str::from_utf8(bytes) else { return Corpus::Reject };
    fuzzing::read_ini(text);
    fuzzing::parse_command_line(text);
    Corpus::Keep
}

/// Folder of a journal, which is deleted at the end, and the journal.
struct JournalFolder {
    _folder: tempfile::TempDir,
    journal: fuzzing::ValidJournal,
}

impl JournalFolder {
    fn create() -> Self {
        let folder = tempfile::tempdir().expect("a temporary folder can be created");
        let journal = fuzzing::ValidJournal::write(folder.path()).expect("a journal can be written");
        Self { _folder: folder, journal }
    }
}

/// Checks the reader of resume journals.
pub fn journal(bytes: &[u8]) -> Corpus {
    thread_local! {
        static FOLDER: JournalFolder = JournalFolder::create();
    }
    FOLDER.with(|folder| folder.journal.resume_with(bytes));
    Corpus::Keep
}

/// Checks the reader of shard files.
pub fn shard(bytes: &[u8]) -> Corpus {
    thread_local! {
        static FOLDER: tempfile::TempDir = tempfile::tempdir().expect("a temporary folder can be created");
    }
    FOLDER.with(|folder| fuzzing::read_shard(folder.path(), bytes));
    Corpus::Keep
}

/// Checks the reader of files of photons and radiosity samples, and a render that uses them.
pub fn light_file(bytes: &[u8]) -> Corpus {
    fuzzing::use_light_file(bytes);
    Corpus::Keep
}

//! glTF 2.0, as JSON with separate buffers or in one file (Khronos Group, glTF 2.0 Specification, 2021; ISO/IEC
//! 12113:2022): the triangles of the default scene, transformed by its nodes, and the base colours. Skins, morph
//! targets and animations are ignored.

mod accessor;
mod document;
mod node;

use super::{FileOpener, MeshFile, MeshMaterial, ReadResult};
use document::Document;

/// Reads a glTF file, and the buffers that it names.
pub fn read_gltf(bytes: &[u8], open: FileOpener) -> ReadResult<MeshFile> {
    let Parts { json, bytes: chunk, base } =
        if bytes.starts_with(b"glTF") { split_glb_chunks(bytes)? } else { Parts { json: bytes, bytes: None, base: 0 } };
    let document: Document = serde_json::from_slice(json).map_err(|e| {
        let why = e.to_string();
        let why = why.split(" at line ").next().unwrap_or_default().to_string();
        match base {
            0 => format!("line {}: {why}", e.line()),
            _ => format!("byte {base} and on, line {} of the JSON: {why}", e.line()),
        }
    })?;
    if let Some(name) = document.extensions_required.iter().find(|name| !KNOWN.contains(&name.as_str())) {
        return Err(format!("it needs the extension `{name}`, which durer doesn't know"));
    }
    let mut buffers: Vec<Vec<u8>> = vec![];
    for (i, buffer) in document.buffers.iter().enumerate() {
        buffers.push(match (&buffer.uri, chunk) {
            (Some(uri), _) => read_uri(uri, open).map_err(|why| format!("buffer {i}: {why}"))?,
            (None, Some(chunk)) => chunk.to_vec(),
            (None, None) => return Err(format!("buffer {i} names no file")),
        });
    }
    let mut out = MeshFile::default();
    read_materials(&document, &mut out);
    let size = bytes.len() + buffers.iter().map(Vec::len).sum::<usize>();
    node::read_nodes(&document, &buffers, size, &mut out)?;
    Ok(out)
}

/// Extensions of glTF that do not affect geometry.
const KNOWN: &[&str] =
    &["KHR_mesh_quantization", "KHR_materials_unlit", "KHR_texture_transform", "KHR_materials_pbrSpecularGlossiness"];

/// JSON and binary chunk of a glTF file, and the offset of the JSON.
struct Parts<'a> {
    json: &'a [u8],
    bytes: Option<&'a [u8]>,
    base: usize,
}

fn split_glb_chunks(bytes: &[u8]) -> ReadResult<Parts<'_>> {
    let word = |at: usize| bytes.get(at..at + 4).map(|b| u32::from_le_bytes([b[0], b[1], b[2], b[3]]) as usize);
    if word(4) != Some(2) {
        return Err("byte 4: only version 2 of glTF is read".into());
    }
    let (mut json, mut rest, mut at) = (None, None, 12);
    while let (Some(length), Some(kind)) = (word(at), word(at + 4)) {
        let Some(chunk) = bytes[at + 8..].get(..length) else {
            return Err(format!("byte {at}: this part has {length} bytes, but the file ends before"));
        };
        match kind {
            0x4e4f_534a => json = json.or(Some(chunk)),
            0x004e_4942 => rest = rest.or(Some(chunk)),
            _ => {}
        }
        at += 8 + length;
    }
    Ok(Parts { json: json.ok_or("byte 12: there is no JSON in it")?, bytes: rest, base: 20 })
}

/// Returns the bytes of a URI in a glTF file: embedded data, or a file.
fn read_uri(uri: &str, open: FileOpener) -> ReadResult<Vec<u8>> {
    match uri.strip_prefix("data:") {
        Some(data) => match data.split_once(";base64,") {
            Some((_, text)) => decode_base64(text),
            None => Err("its bytes are not in base64".into()),
        },
        None => open(&decode_percent_encoding(uri)),
    }
}

/// Decodes base64 text (RFC 4648), with or without padding.
fn decode_base64(text: &str) -> ReadResult<Vec<u8>> {
    use base64::engine::{DecodePaddingMode, Engine, general_purpose::*};
    let lenient = GeneralPurposeConfig::new().with_decode_padding_mode(DecodePaddingMode::Indifferent);
    let engine = GeneralPurpose::new(&base64::alphabet::STANDARD, lenient.with_decode_allow_trailing_bits(true));
    engine.decode(text).map_err(|_| "its bytes are not in base64".into())
}

/// Decodes the percent-encoding of a URI: `%20` is a blank.
fn decode_percent_encoding(uri: &str) -> String {
    let mut out = vec![];
    let mut rest = uri.as_bytes();
    while let [first, more @ ..] = rest {
        let code = more.get(..2).and_then(|hex| std::str::from_utf8(hex).ok());
        match code.and_then(|hex| u8::from_str_radix(hex, 16).ok()).filter(|_| *first == b'%') {
            Some(byte) => {
                out.push(byte);
                rest = &more[2..];
            }
            None => {
                out.push(*first);
                rest = more;
            }
        }
    }
    String::from_utf8_lossy(&out).into_owned()
}

fn read_materials(document: &Document, out: &mut MeshFile) {
    for (i, stored) in document.materials.iter().enumerate() {
        let mut material = MeshMaterial::new(stored.name.clone().unwrap_or_else(|| i.to_string()));
        let pbr = &stored.pbr;
        let [r, g, b, a] = pbr.base_color_factor;
        (material.color, material.is_linear) = ([r, g, b].map(|x| if x.is_finite() { x.max(0.0) } else { 0.0 }), true);
        if stored.alpha_mode.as_deref() == Some("BLEND") {
            material.opacity = a.clamp(0.0, 1.0);
        }
        if let Some(texture) = &pbr.base_color_texture {
            let image = document.textures.get(texture.index).and_then(|t| document.images.get(t.source?));
            match image.and_then(|image| image.uri.as_deref()).filter(|uri| !uri.starts_with("data:")) {
                Some(uri) => material.picture = Some(decode_percent_encoding(uri)),
                None => out
                    .remarks
                    .push(format!("the picture of its material `{}` is inside the file, and left out", material.name)),
            }
        }
        out.materials.push(material);
    }
}

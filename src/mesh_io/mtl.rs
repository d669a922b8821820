//! Materials of OBJ files: colour, opacity, highlight and picture. (Alias|Wavefront, MTL material format, 1995.)

use super::words::{numbered_lines, parse_number};
use super::{MeshMaterial, ReadResult};

/// Appends the materials of an MTL file; `file` is its name, for messages.
pub fn read_mtl(bytes: &[u8], file: &str, out: &mut Vec<MeshMaterial>) -> ReadResult<()> {
    let first = out.len();
    for (line, text) in numbered_lines(bytes) {
        let (word, rest) = text.split_once(char::is_whitespace).unwrap_or((&text, ""));
        let rest = rest.trim();
        if word == "newmtl" {
            out.push(MeshMaterial::new(rest.into()));
            continue;
        }
        let Some(material) = out[first..].last_mut() else { continue };
        let numbers = || {
            let numbers: ReadResult<Vec<f64>> = rest
                .split_ascii_whitespace()
                .map(|word| parse_number(word.as_bytes(), || format!("line {line} of `{file}`")))
                .collect();
            let numbers = numbers?;
            match numbers.iter().all(|x| x.is_finite()) && !numbers.is_empty() {
                true => Ok(numbers),
                false => Err(format!("line {line} of `{file}`: expected a number")),
            }
        };
        match word {
            // (`Kd spectral` and `Kd xyz` are rare, and ignored.)
            "Kd" if !rest.starts_with(['s', 'x']) => {
                let c = numbers()?;
                material.color = [0, 1, 2].map(|i| *c.get(i).unwrap_or(&c[0]));
            }
            "Ks" if !rest.starts_with(['s', 'x']) => material.specular = numbers()?.into_iter().fold(0.0, f64::max),
            "Ns" => material.shininess = numbers()?[0].clamp(1.0, 1e6),
            "d" if !rest.starts_with('-') => material.opacity = numbers()?[0].clamp(0.0, 1.0),
            "Tr" => material.opacity = 1.0 - numbers()?[0].clamp(0.0, 1.0),
            "map_Kd" => material.picture = picture_file_name(rest),
            _ => {}
        }
    }
    Ok(())
}

/// Returns the picture's file name in a line of an MTL file, after options such as `-o 0 0 0`; it may contain blanks.
fn picture_file_name(rest: &str) -> Option<String> {
    let mut words = rest.split_ascii_whitespace().peekable();
    while words.peek().is_some_and(|word| word.starts_with('-')) {
        let count = match words.next()? {
            "-blendu" | "-blendv" | "-cc" | "-clamp" | "-texres" | "-bm" | "-boost" | "-imfchan" => 1,
            "-mm" => 2,
            // Up to three numbers.
            _ => words.clone().take(3).take_while(|word| word.parse::<f64>().is_ok()).count(),
        };
        words.by_ref().take(count).for_each(drop);
    }
    let name = words.collect::<Vec<_>>().join(" ").replace('\\', "/");
    (!name.is_empty()).then_some(name)
}

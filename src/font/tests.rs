use super::{Font, kerning};
use skrifa::raw::{FontData, FontRead, tables::kern::Kern};

#[test]
fn glyphs_are_placed_by_their_widths() {
    let font = Font::built_in();
    let line = font.lay_out("lll");
    // The left edge of the first glyph is at 0, and all are equally wide.
    let left = font.outline(line[0].glyph).iter().flatten().map(|p| p.x).reduce(f64::min).unwrap();
    assert!((line[0].x + left).abs() < 1e-12);
    assert!((line[2].x - 2.0 * line[1].x + line[0].x).abs() < 1e-12 && line[1].x > line[0].x);
    // A character without a glyph shows glyph 0.
    assert_eq!(font.lay_out("\u{4E2D}")[0].glyph, 0);
    assert!(font.lay_out("").is_empty());
}

#[test]
fn outlines_are_closed() {
    let font = Font::built_in();
    for set in font.lay_out("Ög&@8Ж") {
        let outline = font.outline(set.glyph);
        assert!(!outline.is_empty());
        let mut start = outline[0][0];
        for pair in outline.windows(2) {
            if pair[0][2] != pair[1][0] {
                assert_eq!(pair[0][2], start, "an outline ends where it began");
                start = pair[1][0];
            }
        }
        assert_eq!(outline.last().unwrap()[2], start);
    }
}

#[test]
fn kerning_pairs_need_not_be_sorted() {
    // A table with three pairs: its header, its length and coverage, the pairs (the search fields are unused).
    let pairs: [[i16; 3]; 3] = [[55, 72, -42], [34, 57, -97], [14, 34, -56]];
    let head = [0, 1, 0, 14 + 6 * 3, 1, 3, 0, 0, 0];
    let bytes: Vec<u8> = head.iter().chain(pairs.iter().flatten()).flat_map(|n: &i16| n.to_be_bytes()).collect();
    let kern = Kern::read(FontData::new(&bytes)).unwrap();
    let found = |left: u16, right: u16| kerning(Some(&kern), left.into(), right.into());
    assert_eq!([found(55, 72), found(34, 57), found(14, 34), found(14, 57)], [-42.0, -97.0, -56.0, 0.0]);
}

use super::Font;

#[test]
fn letters_stand_by_their_widths() {
    let font = Font::own();
    let line = font.set("lll");
    // The left edge of the first one is at 0, and all are equally wide.
    let left = font.outline(line[0].glyph).iter().flatten().map(|p| p.x).reduce(f64::min).unwrap();
    assert!((line[0].x + left).abs() < 1e-12);
    assert!((line[2].x - 2.0 * line[1].x + line[0].x).abs() < 1e-12 && line[1].x > line[0].x);
    // What a font does not have is its letter 0.
    assert_eq!(font.set("\u{4E2D}")[0].glyph, 0);
    assert!(font.set("").is_empty());
}

#[test]
fn outlines_are_closed() {
    let font = Font::own();
    for set in font.set("Ög&@8Ж") {
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

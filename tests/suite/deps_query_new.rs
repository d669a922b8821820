//! Information about scenes and files: `--deps`, `durer query`; and the scene of `durer new`.

use crate::scratch::Scratch;
use serde_json::Value;

const INCLUDING: &str =
    "#include \"a b.inc\"\ncamera { location -5 * z }\nsphere { 0, 1 pigment { image_map { png \"p#.png\" } } }\n";

fn including() -> Scratch {
    let scratch = Scratch::new();
    scratch.put("main.scene", INCLUDING);
    scratch.put("a b.inc", "#declare A = 1;\n");
    scratch.exits(0, "render ball.scene -o p#.png --size 4x3");
    scratch
}

#[test]
fn deps_as_a_rule_for_make() {
    let scratch = including();
    scratch.exits(0, "render main.scene -o out.png --size 4x3 --deps out.d");
    let text = String::from_utf8(scratch.read("out.d")).unwrap();
    assert_eq!(
        text,
        "out.png: \\\n  a\\ b.inc \\\n  main.scene \\\n  p\\#.png\n\na\\ b.inc:\n\nmain.scene:\n\np\\#.png:\n"
    );
}

#[test]
fn deps_as_json_and_of_failed_runs() {
    let scratch = including();
    scratch.put("bad.ini", "Input_File_Name=bad.pov\nWidth=4\nHeight=3\n");
    scratch.put("bad.pov", "#include \"a b.inc\"\nspere { }\n");
    scratch.exits(1, "render bad.ini -o out.png --deps out.json");
    let read: Value = serde_json::from_slice(&scratch.read("out.json")).unwrap();
    assert_eq!(read["pictures"], serde_json::json!(["out.png"]));
    assert_eq!(read["files"], serde_json::json!(["a b.inc", "bad.ini", "bad.pov"]));
    let (_, err) = scratch.exits(5, "render main.scene --no-output --size 4x3 --deps nowhere/out.d");
    assert!(err.contains("nowhere/out.d"), "{err}");
}

#[test]
fn new_scenes_have_no_faults() {
    let scratch = Scratch::new();
    let (_, err) = scratch.exits(0, "new table");
    assert!(err.contains("durer render table.scene"), "{err}");
    scratch.exits(0, "check table.scene --deny warnings --warn unused,shadow,portable,doubtful");
    scratch.exits(0, "fmt --check table.scene");
    let (_, err) = scratch.exits(2, "new table.scene");
    assert!(err.contains("`table.scene` exists"), "{err}");
    scratch.exits(0, "new other.pov");
    scratch.exits(2, "new other.png");
    scratch.exits(2, "new ..");
    scratch.exits(5, "new nowhere/other");
    assert_eq!(scratch.names(), ["ball.scene", "other.pov", "table.scene"]);
}

const HALL: &str = "camera { location -5 * z look_at 0 }
union { sphere { 2 * x, 1 } light_source { y, rgb 2 } translate y }
plane { y, 0 pigment { checker } }
#for (I, 1, 3) box { I, I + 1 } #end
difference { sphere { 0, 1 } box { -2, 2 } }
";

#[test]
fn query_lists_objects_and_settings() {
    let scratch = Scratch::new();
    scratch.put("hall.scene", HALL);
    let (out, _) = scratch.exits(0, "query hall.scene --quiet");
    for line in [
        "hall.scene:1:1   camera    perspective at <0, 0, -5>, looks along <0, 0, 1>",
        "hall.scene:2:29  light     point at <0, 2, 0>, rgb <2, 2, 2>",
        "hall.scene:2:1   object    union of 2 shapes, <1, 0, -1> to <3, 2, 1>, texture 1",
        "hall.scene:3:1   object    plane, infinite, texture 2",
        "hall.scene:4:16  object    3 × box, <1, 1, 1> to <4, 4, 4>, texture 1",
        "hall.scene:3:1   texture   number 2: checker; on 1 object",
    ] {
        assert!(out.contains(&format!("{line}\n")), "{line}\n{out}");
    }
    let (out, _) = scratch.exits(0, "query hall.scene --quiet --json");
    let read: Value = serde_json::from_str(&out).unwrap();
    let objects = read["objects"].as_array().unwrap();
    assert_eq!(objects.len(), 6);
    assert_eq!(objects[1]["infinite"], true);
    // Boxes are rounded outwards.
    let corners = objects[2]["box"].as_array().unwrap().iter().flat_map(|corner| corner.as_array().unwrap());
    let near = |(x, y): (&Value, f64)| (x.as_f64().unwrap() - y).abs() < 1e-6;
    assert!(corners.zip([1.0, 1.0, 1.0, 2.0, 2.0, 2.0]).all(near), "{}", objects[2]);
    assert_eq!(objects[2]["source"], serde_json::json!({"file": "hall.scene", "line": 4, "column": 16}));
}

#[test]
fn query_errors() {
    let scratch = Scratch::new();
    scratch.put("bad.scene", "spere { }");
    let (out, err) = scratch.exits(1, "query bad.scene");
    assert!(out.is_empty() && err.contains("E02"), "{err}");
    scratch.exits(5, "query nowhere.scene");
    scratch.put("empty.scene", "");
    scratch.exits(0, "query empty.scene --json");
}

//! File access by scenes: reading and writing outside of their folders, endless files, exponential growth.

use super::limited_run::{Case, ScratchFolder, case, drawn};
use libtest_mimic::{Failed, Trial};
use std::process::Stdio;

const BALL: &str = "camera { location <0, 0, -5> look_at 0 }\nsphere { 0, 1 }\n";
/// Command for a scene that is not trusted.
const UNTRUSTED: &str = "render a.scene -o out.png --size 8x6 --threads 2 --untrusted";
/// Command for a scene that may replace all files of its folder.
const WRITING: &str = "render a.scene -o out.png --size 8x6 --threads 2 --allow-write .";

/// Cases of one command with files.
pub fn cases() -> Vec<Case> {
    let bomb =
        "#macro Twice(S) #fopen F \"b.inc\" write #write (F, concat(\"#declare N = N+1;\\n\", S)) #fclose F #end\n";
    vec![
        case("write_at_root", "#fopen F \"/durer.txt\" write\n", 1, &["E0235", "a.scene:1:10", "--allow-write"]),
        case("write_above", "#fopen F \"../durer.txt\" write\n", 1, &["E0235", "a.scene:1:10"]),
        case("write_around", "#fopen F \"./a/../../durer.txt\" write\n", 1, &["E0235"]),
        case("write_home", "#fopen F \"~/durer.txt\" write\n", 1, &["a.scene:1:10"]),
        case("write_device", "#fopen F \"/dev/null\" write\n", 1, &["E0235"]),
        case("write_folder", "#fopen F \".\" write\n", 1, &["a.scene:1:10"]),
        case("read_secrets", "#fopen F \"/etc/passwd\" read\n", 1, &["E0235", "--allow-read"]).args(UNTRUSTED),
        case("read_above", "#fopen F \"../../../../../../etc/passwd\" read\n", 1, &["E0235"]).args(UNTRUSTED),
        case("include_secrets", "#include \"/etc/passwd\"\n", 1, &["E0235"]).args(UNTRUSTED),
        case("exists_is_no_spy", "#if (file_exists(\"/etc/passwd\")) #error \"seen\" #end\n", 0, &["W0206"]).args(UNTRUSTED),
        case("read_picture", "#fopen F \"out.png\" read\n#read (F, A)\n", 1, &["out.png"]),
        case("read_binary", "#fopen F \"b.dat\" read\n#read (F, A)\n", 1, &["E0231"]).with("b.dat", [0, 1, 2, 255]),
        case("read_nonsense", "#fopen F \"b.dat\" read\n#read (F, A)\n", 1, &["E0236", "b.dat:1:1"]).with("b.dat", "?"),
        case("read_open_string", "#fopen F \"b.dat\" read\n#read (F, A)\n", 1, &["E0236"]).with("b.dat", "\"abc"),
        case("read_open_vector", "#fopen F \"b.dat\" read\n#read (F, A)\n", 1, &["E0236"]).with("b.dat", "<1, 2"),
        case("mesh_of_secrets", "mesh { file \"/etc/passwd\" }\n", 1, &["E0235", "--allow-read"]).args(UNTRUSTED),
        case("picture_without_width", "sphere { z, 1 normal { bump_map { pgm \"a.pgm\" } } }\n", 1, &["E0007", "no pixels"])
            .with("a.pgm", "P5 0 4 255\n"),
        case("picture_without_height", "sphere { z, 1 pigment { image_map { pgm \"a.pgm\" } } }\n", 1, &["E0007"])
            .with("a.pgm", "P5 4 0 255\n"),
        case("ini_opens_no_folder", "#include \"etc/passwd\"\n", 1, &["E0230"])
            .with("a.ini", "Input_File_Name=a.scene\nLibrary_Path=/\n")
            .args("check a.ini --untrusted"),
        case("ini_names_no_secret", BALL, 1, &["E0235", "a.ini:1:17"])
            .with("a.ini", "Input_File_Name=/etc/passwd\n")
            .args("check a.ini --untrusted"),
        case("ini_reads_no_other_ini", BALL, 1, &["E0235", "a.ini:1:1"])
            .with("a.ini", "/etc/hosts[x]\nInput_File_Name=a.scene\n")
            .args("a.ini --untrusted +W8 +H6"),
        case("untrusted_picture_has_no_folder", BALL, 0, &["W0012", "without a folder"])
            .with("a.ini", "Input_File_Name=a.scene\nOutput_File_Name=../b.png\n")
            .args("check a.ini --untrusted"),
        case("ini_hides_no_picture", BALL, 1, &["E0235", "begins with a dot"])
            .with("a.ini", "Input_File_Name=a.scene\nOutput_File_Name=.profile.png\n")
            .args("render a.ini"),
        case("untrusted_picture_is_small", BALL, 4, &["E0006"]).args("render a.scene --size 5000x5000 --untrusted"),
        case("untrusted_scene_writes_nothing", "#fopen F \"b.inc\" write #write (F, 1) #fclose F\n", 0, &["b.inc"])
            .args(UNTRUSTED),
        case("picture_replaces_no_text", BALL, 5, &["E0004", "not a picture"])
            .with("b.png", "notes")
            .args("render a.scene -o b.png"),
        case("mesh_folder", "mesh { file \".\" }\n", 1, &["E0230", "a.scene:1:13"]),
        case("mesh_of_nothing", "mesh { file \"a.obj\" }\n", 1, &["E0018", "no triangles"]).with("a.obj", ""),
        case("mesh_that_ends", "mesh { file \"a.stl\" }\n", 1, &["E0018", "byte 84"]).with("a.stl", [255; 84]),
        case("mesh_of_zeros", "mesh { file \"a.ply\" }\n", 1, &["E0018", "end_header"]).with("a.ply", [0; 999]),
        case("mesh_of_billions", "mesh { file \"a.ply\" }\n", 1, &["E0018", "line 4"]).with(
            "a.ply",
            "ply\nformat binary_little_endian 1.0\nelement vertex 18446744073709551615\nelement face 99999999999999999999\nend_header\n",
        ),
        case("mesh_of_empty_elements", "mesh { file \"a.ply\" }\n", 1, &["E0018"]).with(
            "a.ply",
            "ply\nformat binary_little_endian 1.0\nelement edge 18446744073709551615\nelement vertex 18446744073709551615\nend_header\n",
        ),
        case("mesh_without_area", "mesh { file \"a.obj\" }\n", 0, &["W0300", "no triangles"])
            .with("a.obj", "v 0 0 0\nv 1 1 1\nv 2 2 2\nf 1 2 3\nf 1 1 1\n"),
        case("mesh_beyond_measure", "mesh { file \"a.obj\" scale 1e30 }\n", 0, &["W0300"])
            .with("a.obj", "v 0 0 1e37\nv 1e33 0 0\nv 0 1e33 0\nf 1 2 3\n"),
        case("mesh_names_secrets", "mesh { file \"a.obj\" }\n", 0, &["W0214", "may not be read"])
            .args(UNTRUSTED)
            .with("a.obj", "mtllib /etc/passwd\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
        case("mesh_of_itself", "mesh { file \"a.gltf\" }\n", 1, &["E0018", "node 0 hangs in the tree twice"])
            .with("a.gltf", "{\"nodes\": [{\"children\": [1]}, {\"children\": [0, 0]}]}"),
        case("read_empty", "#fopen F \"b.dat\" read\n#while (defined(F)) #read (F, A) #end\n", 0, &[])
            .with("b.dat", ""),
        case("read_number_of_letters", "#fopen F \"b.dat\" read\n#read (F, A)\n", 1, &["E0236"])
            .with("b.dat", "e".repeat(1_000_000)),
        case(
            "write_without_end",
            "#declare S = \"0123456789\";\n#while (strlen(S) < 10000000) #declare S = concat(S, S); #end\n\
             #fopen F \"/dev/full\" append\n",
            1,
            &["E0235"],
        ),
        case(
            "include_writes_itself",
            "#fopen F \"b.inc\" write #write (F, \"#include \\\"b.inc\\\"\") #fclose F\n#include \"b.inc\"\n",
            4,
            &["E0244"],
        )
        .args(WRITING)
        .with("b.inc", ""),
        drawn(
            "include_grows",
            format!("{bomb}#declare N = 0;\n#while (N < 100) Twice(str(N, 0, 0)) #include \"b.inc\" #end\n"),
            1,
            &["b.inc:2:1"],
        )
        .args(WRITING)
        .with("b.inc", ""),
        case("string_doubles", "#declare S = \"x\";\n#while (1) #declare S = concat(S, S); #end\n", 4, &["E0242"]),
        case("array_of_billions", "#declare A = array[100000][100000];\n", 4, &["E0242"]),
        case("array_of_nothing", "#declare A = array[0/0];\nsphere { 0, A[0] }\n", 4, &["E0242", "a.scene:1:14"]),
        case("array_of_itself", "#declare A = array[1];\n#for (I, 1, 100000) #declare A[0] = A; #end\n", 0, &["W0206"]),
        case(
            "function_doubles",
            "#declare F0 = function(x) { x+1 }\n#declare F1 = function(x) { F0(x)*F0(x+1) }\n#declare F2 = function(x) { F1(x)*F1(x+2) }\n\
             #declare F3 = function(x) { F2(x)*F2(x+3) }\n#declare F4 = function(x) { F3(x)*F3(x+4) }\nsphere { 0, F4(1) }\n",
            0,
            &[],
        ),
        case(
            "sum_without_end",
            "#declare F = function(x) { sum(i, 1, 1e300, i) }\nsphere { 0, F(1) }\n",
            0,
            &["W0213", "a.scene:2:13"],
        ),
    ]
}

/// Cases with symbolic links.
pub fn trials() -> Vec<Trial> {
    vec![
        #[cfg(unix)]
        Trial::test("hostile::links_lead_nowhere_else", links_lead_nowhere_else),
        Trial::test("hostile::environment_makes_scenes_untrusted", environment_makes_scenes_untrusted),
    ]
}

/// `DURER_UNTRUSTED=1` is `--untrusted` for each command, and `0` is not.
fn environment_makes_scenes_untrusted() -> Result<(), Failed> {
    let (folder, outside) = (ScratchFolder::new()?, tempfile::tempdir()?);
    let secret = outside.path().join("secret.inc");
    std::fs::write(&secret, "#declare A = 1;")?;
    folder.put("a.scene", format!("#include {secret:?}\n").as_bytes())?;
    for line in ["check a.scene", "render a.scene --no-output --size 8x6", "query a.scene", "pick a.scene 1,1"] {
        for (value, is_refused) in [("1", true), ("0", false)] {
            let mut command = folder.command(line);
            command.env("DURER_UNTRUSTED", value).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::piped());
            let ended = super::limited_run::finish(command.spawn()?)?;
            if ended.stderr.contains("E0235") != is_refused {
                return Err(format!("{line}, {value}: {}", ended.stderr).into());
            }
        }
    }
    Ok(())
}

/// A symbolic link out of the scene's folder does not give access.
#[cfg(unix)]
fn links_lead_nowhere_else() -> Result<(), Failed> {
    let (folder, outside) = (ScratchFolder::new()?, tempfile::tempdir()?);
    std::fs::write(outside.path().join("secret.txt"), "1")?;
    std::os::unix::fs::symlink(outside.path(), folder.path().join("folder"))?;
    std::os::unix::fs::symlink(outside.path().join("secret.txt"), folder.path().join("link.txt"))?;
    let (reads, writes) = ("check a.scene --untrusted", "render a.scene --no-output --allow-write .");
    for (text, command) in [
        ("#fopen F \"link.txt\" read", reads),
        ("#fopen F \"link.txt\" write", writes),
        ("#fopen F \"folder/secret.txt\" append", writes),
        ("#fopen F \"folder/new.txt\" write", writes),
        ("#include \"link.txt\"", reads),
    ] {
        folder.put("a.scene", text.as_bytes())?;
        let ended = folder.run(command, Stdio::null())?;
        if ended.status.code() != Some(1) || !ended.stderr.contains("E0235") {
            return Err(format!("{text}: {}", ended.stderr).into());
        }
    }
    let (secret, others) =
        (std::fs::read(outside.path().join("secret.txt"))?, std::fs::read_dir(outside.path())?.count());
    if secret != b"1" || others != 1 { Err("something was written".into()) } else { Ok(()) }
}

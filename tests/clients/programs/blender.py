"""Blender's add-on "Persistence of Vision": writes a scene and an INI file into the folder for temporary files, runs `povray FILE.ini
-d`, parses standard output (with standard error in it) for the phases and the percentage, and loads the picture.

The scenes and INI files are written by this script in the add-on's style, because Blender is large.
"""

from clients import Case, find_all

SCENE = """#version 3.7;
#default { radiosity { importance 1.0 } }

//--Global settings--

global_settings {
    assumed_gamma 1.0
    max_trace_level 5
    charset utf8
}

//--Background--

background {rgbt<0.25, 0.3, 0.4, 0.75>}

//--Cameras--

#declare camLocation  = <0.00, 4.00, -6.00>;
camera {
    location  <0, 0, 0>
    look_at  <0, 0, -1>
    right <-1.333333, 0, 0>
    up <0, 1, 0>
    angle  49.134342
    rotate  <-30.000000, 0.000000, 0.000000>
    translate <0.000000, 3.000000, 5.500000>
}

//--Lamps--

light_source {
    < 0,0,0 >
    color rgb<1.2, 1.2, 1.2>
    fade_distance 12.500000
    fade_power 2
    matrix <1,0,0, 0,1,0, 0,0,1, 4.0,6.0,5.0>
}

//--Material Definitions--

#default{ finish {ambient 0} }
#declare MAT_red = texture {
    pigment {rgbft<0.8, 0.1, 0.05, 0, 0>}
    finish {
        diffuse 0.8
        specular 0.5
        roughness 0.02
    }
}

//--Mesh objects--

mesh2 {
    vertex_vectors {
        6,
        <1,0,0>,<0,1,0>,<-1,0,0>,<0,-1,0>,<0,0,1>,<0,0,-1>
    }
    face_indices {
        8,
        <0,1,4>,<1,2,4>,<2,3,4>,<3,0,4>,<1,0,5>,<2,1,5>,<3,2,5>,<0,3,5>
    }
    texture {MAT_red}
    matrix <1.2,0,0, 0,1.2,0, 0,0,1.2, 0,0.5,0>
}
plane {y, -1 pigment {rgb 0.7}}
"""

INI = """Version=3.7
{log}Input_File_Name='{folder}/scene.pov'
Output_File_Name='{folder}/scene.png'
Width=96
Height=72
{border}Bounding_Method=2
Display=1
Pause_When_Done=0
Output_File_Type=N
Output_Alpha=1
{antialias}"""

BORDER = """Start_Column=0.25
End_Column=0.75
Start_Row=0.166667
End_Row= 0.5
"""

ANTIALIAS = {
    "off": "Antialias=off\n",
    "grid": "Antialias=on\nAntialias_Depth=2\nAntialias_Threshold=0.1\nSampling_Method=1\nAntialias_Gamma=2.5\nJitter=off\n",
    "corners": "Antialias=on\nAntialias_Depth=2\nAntialias_Threshold=0.03\nSampling_Method=2\nAntialias_Gamma=1\nJitter=off\n",
}


def render(antialias, border="", scene=SCENE, log="", switches=()):
    """Creates an action that writes the files of the add-on and reads its phases."""

    def action(box):
        folder = box.temporary
        (folder / "scene.pov").write_text(scene)
        ini = folder / "scene.ini"
        ini.write_text(INI.format(folder=folder, log=log, border=border, antialias=ANTIALIAS[antialias]))
        # NamedTemporaryFile(delete=False) leaves an empty file, which the add-on removes before it renders.
        result = box.run("povray", ini, *switches, "-d", merge=True)
        box.record("parsing", bool(find_all(r"= \[Parsing\.\.\.\] =", result.stdout)))
        box.record("rendering", bool(find_all(r"= \[Rendering\.\.\.\] =", result.stdout)))
        # Bytes of standard output are formatted as `str(bytes)`, and the last percentage is shown.
        box.record("percent", find_all(r"\(([0-9]{1,3})%\)", str(result.stdout.encode()))[-1:])

    return action


def preview(box):
    """Renders the preview of a texture: an INI file of language 3.8 with quotes around names and a switch."""
    folder = box.temporary / "povray-preview"
    folder.mkdir()
    name = folder / "tex_prev.png"
    (folder / "Preview.pov").write_text(
        """#declare PAT_tex =
pigment { wood turbulence <0.1, 0.1, 0> color_map { [0 rgb <0.4, 0.2, 0.1>] [1 rgb <0.9, 0.7, 0.4>] } scale 0.5 }
#declare Plane =
mesh {
    triangle {<-2.021,-1.744,2.021>,<-2.021,-1.744,-2.021>,<2.021,-1.744,2.021>}
    triangle {<-2.021,-1.744,-2.021>,<2.021,-1.744,-2.021>,<2.021,-1.744,2.021>}
    texture{ pigment { PAT_tex } }
}
object {Plane}
light_source {
    <0,4.38,-1.92e-07>
    color rgb<4, 4, 4>
    parallel
    point_at  <0, 0, -1>
}
camera {
    location  <0, 0, 0>
    look_at  <0, 0, -1>
    right <-1.0, 0, 0>
    up <0, 1, 0>
    angle  96.805211
    rotate  <-90.000003, -0.000000, 0.000000>
}
"""
    )
    ini = folder / "Preview.ini"
    ini.write_text(
        f"""Version=3.8
Input_File_Name="{folder}/Preview.pov"
Output_File_Name="{name}"
Library_Path="{folder}"
Width=64
Height=64
Pause_When_Done=0
Output_File_Type=N
Output_Alpha=1
Antialias=on
Sampling_Method=2
Antialias_Depth=3
-d
"""
    )
    box.run("povray", "-d", ini, merge=True)


CASES = [
    Case("plain", render("off")),
    Case("antialias-grid", render("grid")),
    Case("antialias-corners", render("corners")),
    Case("border", render("off", BORDER)),
    Case("switches", render("off", switches=("+L/usr/share/povray-3.7/include", "+Q5"))),
    Case("error", render("off", scene=SCENE + "sphere { <0, 0, 0> 1 }}\n"), draws=False),
    Case("log", render("off", log="All_File=1\n")),
    Case("preview", preview),
]

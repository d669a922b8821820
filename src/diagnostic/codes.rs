//! All diagnostic codes. A code is never reused or renumbered, and has a test case in `tests/ui`.

use super::Severity;

/// A stable diagnostic code such as `E0102`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Code(pub &'static str);

impl Code {
    /// Returns the severity of the code: a warning for `W…`, an error for `E…`.
    pub fn severity(self) -> Severity {
        if self.0.starts_with('W') { Severity::Warning } else { Severity::Error }
    }
}

impl std::fmt::Display for Code {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.0)
    }
}

/// Output of `durer explain` for one diagnostic code.
pub struct Explanation {
    /// Diagnostic code that the explanation describes.
    pub code: Code,
    /// Title of the diagnostic code in one line.
    pub title: &'static str,
    /// Explanation of the code in a paragraph or two, with an example.
    pub text: &'static str,
}

macro_rules! codes {
    ($($name:ident $code:literal $title:literal $text:literal)*) => {
        $(#[doc = $title] pub const $name: Code = Code($code);)*
        /// Explanations of all diagnostic codes, in the order of the codes.
        pub const ALL: &[Explanation] = &[$(Explanation { code: $name, title: $title, text: $text }),*];
    };
}

codes! {
    NOT_TEXT "E0001" "the file is not text"
"A scene is a text file. This one holds bytes that no text holds, as pictures, archives and programs do.
Text in UTF-16, as some editors write it, has to be saved as UTF-8."
    FILE_NOT_FOUND "E0002" "there is no such file"
"No file has this name. Names are relative to the current folder unless they start with `/`; upper and lower
case letters differ on most systems. `-` is standard input."
    FILE_UNREADABLE "E0003" "the file can't be read"
"The file exists, but it is a folder, or larger than 4 GB, or the system doesn't let you read it."
    FILE_UNWRITABLE "E0004" "the file can't be written"
"Its folder doesn't exist, or you may not write there, or the disk is full. A picture is written whole or not at all: first
into a temporary file in the same folder, which then takes the name. So the folder itself has to be writable. Nothing was
changed.

One process at a time renders a picture. Meanwhile, the file with the name of the picture and `.unfinished` is locked; it has to
be a regular file, and neither a link nor a pipe."
    UNKNOWN_FORMAT "E0005" "the file's ending names no picture format"
"The ending of the output's name says in which format the picture is written: png, exr, hdr, jpg, ppm, bmp, tga or tiff.
`--format` says it for names without such an ending, and for standard output:

    durer render ball.scene -o - --format ppm | display"
    PICTURE_TOO_LARGE "E0006" "the picture needs more memory than there is"
"Pictures are drawn in bands of rows. Rows of png, ppm and hdr leave memory as they are done, so that even a large picture needs
some 30 MB; the other formats keep all rows until the last one: exr takes 16 bytes a pixel, jpg, bmp, tga and tiff 3 to 8.
`--max-memory` sets a limit of your own; without it, what the machine has free is the limit. Choose png, or make the picture
smaller with `--size`. More than 68 719 476 736 pixels are never drawn: that would take years."
    PICTURE_BROKEN "E0007" "the picture file can't be decoded"
"It is damaged, cut off, or of another kind than its name says."
    FORMAT_LIMIT "E0008" "the picture format can't hold this picture"
"Every format has limits: jpg holds 65535 pixels a side, bmp, tga and jpg hold 8 bits a channel, exr and hdr always hold
floating-point numbers, and only png, tiff, bmp, tga and exr have transparency. Choose another format, for example png."
    OUTSIDE_PICTURE "E0010" "this part is not inside the picture"
"Pixels are counted from the top left, starting with 0: a picture of 640x480 goes from 0,0 to 639,479. `--size` says how large
the picture is."
    UNKNOWN_OPTION "E0011" "there is no such option"
"durer accepts its own options (`durer render --help`) and those of POV-Ray (`+W640`, `Width=640`). This is neither."
    OPTION_IGNORED "W0012" "a POV-Ray option that has no effect here"
"durer accepts this option of POV-Ray and ignores it. The picture is rendered without it."
    INI_SECTION "W0013" "an INI file has no such section"
"`durer anim.ini[low]` reads the lines before the first label of the file, and then those after the label `[low]`. Without that
label, only the first part is read, as POV-Ray does."
    INI_REST "W0014" "a part of a line is not read"
"In an INI file, a setting such as `Width=320` ends its line. POV-Ray reads no further, and so does durer."
    INI_SYNTAX "E0015" "a line of an INI file can't be read"
"A line holds settings (`Width=320`), switches (`+W320`), the name of another INI file, or a section's label (`[low]`). Comments
begin with `;` or `#`. The meaning of any other line is unknown, so nothing is rendered."
    NO_SCENE "E0016" "an INI file names no scene"
"`durer render anim.ini` draws the scene that the line `Input_File_Name=scene.pov` of the file names. An INI file without such a
line holds options only; `durer scene.pov low.ini` uses both."
    INI_LOOP "E0017" "an INI file reads itself"
"An INI file may name another on a line of its own. A file that names itself, directly or through others, would never end."
    MESH_BROKEN "E0018" "the mesh's file can't be read"
"`mesh { file \"NAME\" }` reads PLY, OBJ, STL and glTF files (ply, obj, stl, gltf, glb). The message gives the reason, and the line or the
byte (counted from 0) where it is known: the file ends early, a corner's index is too large, a coordinate is not a number."
    OTHER_PREPARATION "E0020" "light that was prepared for another picture"
"The file of `--prepared` was written by `durer prepare` for another scene, size, frame or quality, or the scene has changed since. Its
light would make a wrong picture, so nothing is rendered. Prepare the picture again with the options of the render."
    SYNTAX "E0100" "unexpected text"
"The text can't be read as a scene from this place on."
    UNCLOSED "E0101" "something is opened and never closed"
"A `{`, `(`, `[`, string, comment or directive has no end. The message marks the opener, since the intended end
is unknown.\n\n    sphere { <0, 0, 0>, 1\n    // the `}` is missing"
    UNMATCHED_CLOSER "E0102" "something is closed that was never opened"
"A `}`, `)`, `]` or `#end` has no opener. Often one too many was typed, or the opener was deleted."
    UNKNOWN_DIRECTIVE "E0103" "no directive of this name"
"A directive is a `#` and a word: #declare, #local, #if, #while, #for, #macro, #include and so on.\n\n    #declre A = 1;   // #declare"
    TOO_DEEP "E0104" "brackets are nested too deeply"
"A thousand brackets, directives or choices inside each other are more than any scene needs: the file is probably damaged."
    WRONG_TYPE "E0200" "a value of another kind is needed here"
"For example a colour where a number belongs, or a texture where an object belongs. A number is accepted as a vector or a
colour with equal components: `scale 2` is `scale <2, 2, 2>`.\n\n    sphere { <0, 0, 0>, rgb 1 }   // the radius is a number"
    EXPECTED_VALUE "E0201" "a number, vector, colour or text is needed here"
"A word, a block or the end of a block is where the previous word needs a value.\n\n    rotate translate y   // rotate by how much?"
    WRONG_COUNT "E0202" "too few or too many values"
"A vector has two to five numbers, a macro takes as many arguments as its definition names, a `matrix` twelve numbers."
    UNDECLARED "E0203" "a name that nothing was declared for"
"Every name needs a `#declare` or `#local` before it is used; those of the standard includes need their `#include`.\n\n    #include \"colors.inc\"\n    sphere { 0, 1 pigment { Red } }"
    UNKNOWN_WORD "E0204" "a block does not take this word"
"Each block takes words of its own; the message lists them, or names the nearest."
    EXPECTED "E0205" "something else is needed here"
"The message gives the found and the expected text."
    NO_COMPONENT "E0206" "a vector has no such component"
"Vectors have x y z, and u v t; colours have red green blue filter transmit and gray."
    NOT_CALLABLE "E0207" "only macros and functions are called"
"A name with arguments in parentheses must be a macro or a function; this one is something else."
    RESERVED_NAME "E0208" "a word of the language can't be declared"
"All words of the language are in lower case: a name with a capital letter never collides with one, nor with a word of a later version."
    BAD_ARGUMENT "E0209" "a function can't be computed for this value"
"For example the root of a negative number or the logarithm of 0."
    NOT_FINITE "E0210" "a number is infinite or not a number"
"An earlier division by zero or overflow gave this number."
    SINGULAR "E0211" "a transform flattens space"
"A factor of 0 in `scale`, or a `matrix` whose rows lie in one plane, has no inverse: no ray could be brought into the object's space.\n\n    scale <1, 0, 1>   // use a tiny number, or a disc"
    ZERO_VECTOR "E0212" "a direction has no length"
"A normal, an axis or a direction is `<0, 0, 0>` and points nowhere."
    BAD_CAMERA "E0213" "a camera that can't see"
"Its vectors are zero or parallel, or its angle is outside of the range of its projection."
    EMPTY_MAP "E0214" "a map without entries"
"A map needs at least one entry such as `[0.5 color rgb 1]`."
    UNCLOSED_BLOCK "E0215" "a block that never ends"
"The text ended, or a macro's body did, before the block's `}`."
    BAD_INDEX "E0216" "an index outside of an array"
"The elements of `array[3]` are 0, 1 and 2. A size is at least 1."
    NOT_YET "E0220" "not supported yet"
"This part of the language is read but can't be run yet. See the manual for what durer does so far."
    MISSING_INCLUDE "E0230" "an included file was not found"
"An `#include` is looked for in the scene's folder, in those given by -I, in those of the environment variable DURER_INCLUDE, and in the include folder of an installed POV-Ray."
    UNREADABLE_INCLUDE "E0231" "an included file can't be read"
"The file exists, but the system refuses to open it, or it is a folder."
    BREAK_OUTSIDE "E0232" "`#break` outside of a loop"
"It leaves the innermost `#while`, `#for` or `#switch` around it or, where a macro's body has none of them, the macro."
    ZERO_STEP "E0233" "a loop that never advances"
"The step of a `#for` is 0, so that its counter would never reach the last value."
    USER_ERROR "E0234" "the scene's own `#error`"
"The scene itself, or a file it includes, found a reason to stop."
    FORBIDDEN_FILE "E0235" "a file that the scene may not touch"
"A scene creates files below the current folder, and replaces only those that it created before; files and folders whose names
begin with a dot, scenes, INI files and snapshots are never written. `--allow-write DIR` allows more. With `--untrusted`, a scene reads
only below its own folder; `--allow-read DIR` allows more. No scene can start a program."
    BAD_DATA "E0236" "a data file holds something else"
"`#read` takes numbers, vectors such as `<1, 2, 3>` and strings in double quotes, with commas or blanks between them."
    STEP_LIMIT "E0240" "too many steps"
"Every directive, macro call and pass through a loop is a step. The limit ends loops that never end; `--max-steps N` moves it. Exit code 4."
    TIME_LIMIT "E0241" "too much time"
"`--max-time` set this limit. Exit code 4."
    MEMORY_LIMIT "E0242" "too much memory"
"`--max-memory` set this limit, or the scene's text is larger than 4 GB, or a `function W, H { … }` makes a picture that has no room. Exit code 4."
    CALL_DEPTH "E0243" "macros call each other without end"
"A macro that calls itself needs an `#if` that ends it at some depth. Exit code 4."
    INCLUDE_DEPTH "E0244" "files include each other without end"
"A file that includes itself, directly or through others, never ends. `#ifndef (Name_Inc) #declare Name_Inc = 1; … #end` around a file makes it harmless. Exit code 4."
    DIVISION_BY_ZERO "W0200" "a division by zero"
"POV-Ray computes infinity, and so does durer; where such a number reaches a shape or a transform it is an error."
    USER_WARNING "W0202" "the scene's own `#warning`"
"The scene itself, or a file it includes, has something to say."
    DEPRECATED "W0203" "a name that should not be used any more"
"Whoever declared it marked it as `deprecated` and says what to use instead."
    NEWER_VERSION "W0204" "a version of the language newer than 3.7"
"durer renders as POV-Ray 3.7 does. From 3.8 it reads dictionaries, mixed arrays, optional parameters, several names in one `#declare` and the
prefixes `local.` and `global.`; other new words are errors. One warning a run, however often the version is stated."
    EMPTY_BLOCK "W0205" "an empty block"
"It has no effect."
    NO_CAMERA "W0206" "a scene without a camera"
"POV-Ray's default camera is used: at the origin, looking along z."
    ZERO_SCALE "W0207" "a scale of 0"
"It would flatten the object; POV-Ray uses 1 for that axis instead, and so does durer."
    OTHER_SPELLING "W0208" "a file is there, but not under this name"
"Some systems take `COLORS.INC` for `colors.inc`, and `\\` for `/`; most do not. durer finds the file all the same and reports the spelling of
its name. Of a path such as `C:\\pov\\shapes.inc`, only the last name is looked for.

    #include \"Include\\Colors.inc\"   // #include \"include/colors.inc\""
    UNUSED_NAME "W0209" "a name that is declared and never used"
"Reported with `--warn unused`. The scene's own file declares it, and no file that was read uses it: often a typo in the declaration
or in the use. A name that begins with `_` is not reported."
    HIDDEN_NAME "W0210" "a name that hides another"
"Reported with `--warn shadow`. Inside of a macro, its parameters and `#local`s hide equal names declared outside, also from
the macros that it calls."
    FONT_MISSING "W0211" "a font was not found"
"A `text` names a font file that is neither in the scene's folder nor in those of the includes, nor a family of this
machine's fonts. A similar font of the system replaces it (serif, sans or monospaced, bold, italic, according to its name), so that the picture differs a
little. The environment variable DURER_FONTS names other folders in which to look for it."
    MISPLACED "W0212" "a misplaced word"
"POV-Ray accepts it there with the same effect as durer: a colour of an object outside of its `pigment` changes nothing,
`max_trace_level` outside of `global_settings` counts, and `uv_mapping` after a pigment's name removes its colours.

    sphere { 0, 1 color rgb 1 }              // sphere { 0, 1 pigment { color rgb 1 } }
    max_trace_level 10                       // global_settings { max_trace_level 10 }
    pigment { Wood uv_mapping }              // pigment { uv_mapping Wood }"
    INFINITE "W0213" "a number that is used is infinite or not a number"
"POV-Ray continues with such numbers, and so does durer where it can: a shape with such a number or transform is
invisible, but a `box` with an infinite corner has no end there; in a colour, infinity is white light and black paint,
and NaN is black. Look for a division by zero, or for a number that grows in a loop."
    MESH_PARTLY "W0214" "a part of a mesh's file is left out"
"A mesh file names its materials, which may be in another file: that file is missing, or has features that durer doesn't render. The mesh's own
texture replaces them."
    MORE_ERRORS "W0250" "more errors than are reported"
"After twenty errors the others are only counted: many of them follow from the first ones, and vanish when those are corrected."
    NO_DIRECTION "E0300" "a plane has no direction"
"The normal of a plane is its direction, so `plane { <0, 0, 0>, 1 }` is not a plane. A plane that is spanned by two
vectors has no normal either if they are parallel. A floor is `plane { y, 0 }`."
    NO_LENGTH "E0301" "a cylinder or cone has no length"
"Its two end points are equal, so its axis has no direction: `cylinder { 0, 0, 1 }`. Move one of them, as in
`cylinder { 0, y, 1 }`; a flat round plate is `disc { 0, y, 1 }`."
    FEW_POINTS "E0302" "a polygon or curve has too few points"
"The first number in a `polygon` says how many points follow. It takes three to enclose an area, and the first one is
usually repeated at the end: `polygon { 4, <0, 0>, <1, 0>, <0, 1>, <0, 0> }`."
    TWO_FORMS "E0304" "a shape is given twice"
"A mesh has triangles that are written out or those of one `file`. A plane is given by `normal, distance` or by one of the forms with words, `implicit <A, B, C, D>`, `point q normal n` or
`point q span i, j`, and only once."
    BAD_ORDER "E0305" "a polynomial has no such order or power"
"The order of a `poly` or `polynomial` is the highest sum of powers in it, from 2 to 35. In `xyz(i, j, k): c`, no power is negative, and
`i + j + k` is at most the order: `polynomial { 2, xyz(2, 0, 0): 1, xyz(0, 2, 0): 1, xyz(0, 0, 0): -1 }` is a pipe."
    BAD_OUTLINE "E0306" "the points of a surface of revolution can't be joined"
"The radius of a `sor` is a function of its height: from the second point to the last but one the heights rise, and no radius is negative. The
first and the last point, which only give directions, are not as high as the next but one. A `lathe` turns any curve."
    NO_SURFACE "W0300" "a shape has no surface"
"The shape is invisible: a radius is zero or, in a torus, negative; or the normal of a disc is zero; or the hole of a disc
is as large as the disc."
    FLAT_TRIANGLE "W0301" "a triangle has no area"
"Its corners are on one line, or two of them are the same point. It is left out."
    TWISTED_TRIANGLE "W0302" "the normals of a smooth triangle point to both sides"
"All three normals of a `smooth_triangle` must point to the same side of it, and none may lie in its plane. Such a triangle is
left out, as POV-Ray does."
    OPEN_OUTLINE "W0303" "the outline of a polygon is not closed"
"Each outline ends with the point that it began with: `polygon { 4, <0, 0>, <1, 0>, <0, 1>, <0, 0> }`. The last one was closed
for you."
    NOT_FLAT "W0304" "the points of a polygon are not in one plane"
"A `polygon` is flat: all its points lie in one plane, to 1e-10, and not all on one line. One that is not is left out, as
POV-Ray does. Split it into triangles."
    NOT_POSITIVE "W0310" "a number of a shape must be more than 0"
"Some numbers mean something above 0 alone: `accuracy`, `max_gradient` and `max_trace` of an `isosurface`. For any other the usual number is
taken, as POV-Ray does."
    TOO_STEEP "W0311" "an isosurface is steeper than its `max_gradient` says"
"POV-Ray searches for an isosurface by steps that `max_gradient` allows; where the function is steeper, it shows holes. durer bounds the
function itself where it can and shows none, but a scene that shall look alike in both needs a `max_gradient` that is large enough."
    BLACK_PICTURE "W0400" "the picture is black all over"
"Something is seen, but no light comes from it: the scene has no `light_source`, or the light is inside of an object, or all visible
objects are black. An object without a `pigment` is black.

    light_source { <10, 20, -10>, rgb 1 }"
    NOTHING_SEEN "W0401" "the picture shows nothing but the background"
"No ray from the camera hits an object. The message locates the nearest one: behind the camera, beside the picture, or so
far away that it is smaller than a pixel. Reported after rendering."
    CAMERA_INSIDE "W0402" "the camera is inside of an object"
"All that is seen is the inside of the object around the camera, or the back of a floor; other objects are hidden by it. A room or a sky
around the camera is fine as long as another object is visible too. Reported after rendering."
    NOTHING_LEFT "W0403" "nothing is left of a CSG object"
"The objects that a `difference` subtracts contain all of the first object, or the parts of an `intersection` have no point in common. If one
part alone is the reason, the message names it. The inside of a `plane` is the side that its normal points away from.

    difference { sphere { 0, 1 } box { -2, 2 } }   // nothing of the sphere lies outside of the box"
    SEVERAL_CAMERAS "W0404" "a scene with several cameras"
"The last one counts; the others are ignored. An `#if` or `#switch` around them chooses one."
    STRETCHED "W0405" "the picture's sides do not fit the camera's"
"The camera's window is `right` wide and `up` high; a picture of another shape shows all of it, stretched, and balls become eggs. Reported after
rendering. This fits a picture of any size:

    camera { location <0, 1, -5> look_at 0 right x*image_width/image_height }"
    COLOR_OF_BYTES "W0406" "a colour that counts up to 255"
"In a scene, colours go from 0 to 1: `rgb <255, 128, 0>` is as bright as two hundred lamps, and looks white. Divide by 255; `srgb` means the
numbers as painting programs do:

    pigment { srgb <255, 128, 0>/255 }"
    ALL_AXES "W0407" "`rotate` with a single number"
"A single number is used for all three components: `rotate 45` is `rotate <45, 45, 45>`, which turns around the x axis, then y, then z. Around one axis it is
`rotate y*45`. Write the vector if all three are meant."
    ALONG_SKY "W0408" "the camera looks along `sky`"
"`look_at` turns the camera so that `sky` is up in the picture, and straight above or below the camera no direction is up. The `right` vector is
used instead. Choose another `sky`:

    camera { location y*10 sky z look_at 0 }"
    FALLING_MAP "W0409" "the numbers of a map fall"
"The numbers of a map's entries rise from the first to the last; if an entry's number is smaller than the one before, the colours between them are
never shown. Usually two entries are exchanged: `[0 …] [1 …]`."
    FEW_PARTS "W0410" "a CSG object with a single part"
"An `intersection` or a `difference` needs two objects or more; with one, it has no effect. Check the position of the `}`. A `union` of one object
is reported with `--warn doubtful` only."
    SAME_SURFACE "W0411" "two surfaces coincide"
"Where two faces coincide, rounding decides which one a ray hits first, and the picture shows specks of both. Move one of them by a
thousandth; let the objects that a `difference` subtracts stick out a little. Reported after rendering.

    difference { box { 0, 1 } cylinder { 0.5*(x + z), 0.5*(x + z) + y, 0.3 } }   // from below 0 to above 1"
    SOLID_MEDIA "W0412" "media in an object that is not hollow"
"An object without `hollow` is filled with the material of its surface, and holds no smoke, fire or fog. Write `hollow` into the object, and into every
object around it, the one around the camera too.

    sphere { 0, 1 pigment { rgbt 1 } hollow interior { media { emission 0.5 } } }"
    UNLIT_MEDIA "W0413" "media that scatter light, without a light"
"`scattering` sends the light of `light_source`s towards the camera. The scene has none, or all have `media_interaction off`. Add a light, or give
the media an `emission`, which needs none.

    light_source { <5, 8, -5> rgb 2 }
    media { scattering { 1, 0.1 } }"
    EMPTY_DENSITY "W0414" "a density that is 0 in all of its object"
"`spherical`, `boxed`, `cylindrical` and `planar` are above 0 at most one unit from the origin, before the transforms that follow them. Write the object and the
density around the origin, and move both together.

    sphere { 0, 1 pigment { rgbt 1 } hollow interior { media { emission 1 density { spherical } } } translate 5*y }"
    SLOW_MEDIA "W0415" "media that take hours"
"The number of samples on a ray is `intervals` times `samples`, and each of them asks for the light of each light source, whose rays may pass media
again. The estimate is reported before the render begins. Lower `samples`, `intervals` or `aa_level`, or render a small picture first."
    UNUSED_LIGHT_FILE "W0416" "a file of photons or of radiosity that can't be used"
"`load_file` names a file that does not exist, is damaged, has something else, or comes from another program or another version of durer. The
picture is the same as without the word, and the photons or samples are computed anew. Save the file again:

    global_settings { photons { count 20000 save_file \"glass.photons\" } }"
    OTHER_LIGHT "W0417" "light that was saved for another scene"
"The file of `load_file` was saved when an object, a light or a texture was different. Its light is used, but it may not fit what is there now. Moving the
camera is no change. Save the file again, or remove `load_file`."
    UNSAVED_LIGHT "W0418" "photons or samples of radiosity that could not be saved"
"The picture is correct, but the file of `save_file` or `--save-radiosity` was not written. A scene creates files below the current folder, and replaces those
that it created itself; `--allow-write` lets it write elsewhere. `--save-radiosity` replaces files of radiosity that durer saved, and no others."
    IDLE_PHOTONS "W0419" "photons, or settings of photons, without effect"
"Photons are shot only at objects with `target` in their `photons` block, and only if the object or the light has `refraction on` or
`reflection on`. They light up media only if the media scatter light. `count` and `spacing` are two ways to state how many photons there are;
`spacing` has no effect beside `count`.

    sphere { 0, 1 pigment { rgbf 1 } interior { ior 1.5 } photons { target refraction on reflection on } }"
    NOT_PORTABLE "W0420" "POV-Ray 3.7 would reject this"
"Reported with `durer check --warn portable`. durer accepts it, POV-Ray 3.7 does not: a comma where it expects none, a vector for a colour, a texture's name without
its `texture { }`, a missing `;`, or a word of durer's own."
    DOUBLE_AMBIENT "W0421" "`ambient` beside radiosity"
"`ambient` is a constant in place of the light that comes from other surfaces, and radiosity computes that light. In scenes for versions before
3.7, and in those that state no version, both count, and most surfaces become too bright. Set `ambient` to 0 at the beginning, or state version
3.7, in which radiosity switches `ambient` off.

    #default { finish { ambient 0 } }"
    SLOW_LIGHT "W0422" "photons or radiosity that take hours"
"Each sample of radiosity traces `count` rays, and the smaller `minimum_reuse` and `error_bound` are, the more samples there are. Each pixel with photons
examines up to the second number of `gather`. The estimate is an upper one, and is reported before the render begins. Lower these numbers, or render a
small picture first."
}

/// Code of an error that follows from a reported one; never shown.
pub const FOLLOWS: Code = Code("E0998");
/// Internal code that ends the run after a reported error; never shown.
pub const ENDS_RUN: Code = Code("E0999");

/// Returns the explanation of a code that the user typed, in any letter case; `None` for an unknown code.
pub fn find_explanation(code: &str) -> Option<&'static Explanation> {
    ALL.iter().find(|e| e.code.0.eq_ignore_ascii_case(code.trim()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn codes_are_unique() {
        let mut codes: Vec<_> = ALL.iter().map(|e| e.code).chain([FOLLOWS, ENDS_RUN]).collect();
        codes.sort();
        assert_eq!(codes.windows(2).find(|pair| pair[0] == pair[1]), None);
    }
}

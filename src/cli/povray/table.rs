//! All options of POV-Ray 3.7: switch, INI name, and effect in durer (manual, section 3.2).

use super::settings::Settings;
use super::text_output::Stream;

/// One option of POV-Ray in all its spellings, whose letter case is ignored.
pub struct Row {
    /// Switch after `+` or `-`; empty if the option has only an INI name.
    pub switch: &'static str,
    /// INI name of the POV-Ray option before `=`; empty if the option has only a switch.
    pub ini: &'static str,
    /// Kind of value that the POV-Ray option takes.
    pub takes: Takes,
    /// Effect of the POV-Ray option written with `+` or with a value.
    pub on: Effect,
    /// Effect of the POV-Ray option written with `-`, or with `off` in an INI file.
    pub off: Effect,
}

impl Row {
    /// True for an option of an INI file such as `All_File`, which asks for a text file even without a name.
    pub fn has_default_text_file(&self) -> bool {
        self.switch.is_empty() && matches!(self.on, TextFile(_))
    }
}

/// Kind of value that a POV-Ray option takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Takes {
    /// POV-Ray option without a value, such as `+C` or `Continue_Trace=on`.
    Nothing,
    /// POV-Ray option with a number, such as `+W640`.
    Number,
    /// POV-Ray option with an optional number: `+A0.3`, or `+A` alone.
    MaybeNumber,
    /// POV-Ray option with a text, such as `+Iscene.pov`.
    Text,
    /// POV-Ray option with an optional text: `+FN16`, or `+F` alone.
    MaybeText,
}

/// Effect of a POV-Ray option on durer's settings.
#[derive(Clone, Copy)]
pub enum Effect {
    /// No effect, because durer always does so, or because the option changes no pixel.
    Same,
    /// Effect: sets the durer option of this name to the same value.
    Option(&'static str),
    /// Effect: sets the durer option of this name, which has no value.
    Flag(&'static str),
    /// Effect: sets a part of a durer option, which is combined at the end. The function fails for a wrong value.
    Part(fn(&mut Settings, &str) -> Result<(), String>),
    /// Effect: a warning that durer lacks the feature, for this reason.
    Lacks(&'static str),
    /// Effect: a warning with `--warn options` that durer lacks the feature, which changes no pixel.
    Idle(&'static str),
    /// Effect: sets the durer option of this name to a whole number between two limits.
    Whole(&'static str, u16, u16),
    /// Effect: copies a stream of text into the file that the value names. An empty value means the stream's default
    /// name, or, for the options `…_Console`, for no file.
    TextFile(Stream),
    /// Effect: does not print a stream of text, but copies the stream into the file that the value names, if any.
    Silence(Stream),
}

use Effect::{Flag, Idle, Lacks, Option, Part, Same, Silence, TextFile, Whole};
use Takes::{MaybeNumber, MaybeText, Nothing, Number, Text};

const fn row(switch: &'static str, ini: &'static str, takes: Takes, on: Effect, off: Effect) -> Row {
    Row { switch, ini, takes, on, off }
}

/// Creates the table row of an option for which `-` has the same effect as `+`.
const fn row_ignoring_sign(switch: &'static str, ini: &'static str, takes: Takes, on: Effect) -> Row {
    Row { switch, ini, takes, on, off: on }
}

const NO_WINDOW: &str = "durer opens no window";
const CTRL_C: &str = "Ctrl-C always ends durer";
const NO_SHELL: &str = "durer never runs other programs";

/// All POV-Ray options, in the order of the manual.
pub const ROWS: &[Row] = &[
    // 3.2.1 Animation
    row_ignoring_sign("K", "Clock", Number, Part(|p, v| p.set_clock(v))),
    row_ignoring_sign(
        "KFI",
        "Initial_Frame",
        Number,
        Part(|p, v| p.set_frame_number(v, |p, n| p.initial_frame = Some(n))),
    ),
    row_ignoring_sign("KFF", "Final_Frame", Number, Part(|p, v| p.set_frame_number(v, |p, n| p.final_frame = Some(n)))),
    row_ignoring_sign("KI", "Initial_Clock", Number, Part(|p, v| p.set_number(v, |p, x| p.initial_clock = x))),
    row_ignoring_sign("KF", "Final_Clock", Number, Part(|p, v| p.set_number(v, |p, x| p.final_clock = x))),
    row_ignoring_sign(
        "SF",
        "Subset_Start_Frame",
        Number,
        Part(|p, v| p.set_number(v, |p, x| p.subset_start = Some(x))),
    ),
    row_ignoring_sign("EF", "Subset_End_Frame", Number, Part(|p, v| p.set_number(v, |p, x| p.subset_end = Some(x)))),
    row_ignoring_sign("STP", "Frame_Step", Number, Part(|p, v| p.set_frame_number(v, |p, n| p.frame_step = n))),
    row(
        "KC",
        "Cyclic_Animation",
        Nothing,
        Part(|p, _| p.change(|p| p.cyclic = true)),
        Part(|p, _| p.change(|p| p.cyclic = false)),
    ),
    row("", "Clockless_Animation", Nothing, Same, Same),
    row("UF", "Field_Render", Nothing, Lacks("durer renders whole frames only"), Same),
    row("UO", "Odd_Field", Nothing, Lacks("durer renders whole frames only"), Same),
    // 3.2.2 General output
    row_ignoring_sign("H", "Height", Number, Part(|p, v| p.set_pixel_count(v, |p, n| p.height = Some(n)))),
    row_ignoring_sign("W", "Width", Number, Part(|p, v| p.set_pixel_count(v, |p, n| p.width = Some(n)))),
    row_ignoring_sign("MI", "Max_Image_Buffer_Memory", Number, Same),
    row_ignoring_sign("SC", "Start_Column", Number, Part(|p, v| p.set_number(v, |p, x| p.start_column = Some(x)))),
    row_ignoring_sign("EC", "End_Column", Number, Part(|p, v| p.set_number(v, |p, x| p.end_column = Some(x)))),
    row_ignoring_sign("SR", "Start_Row", Number, Part(|p, v| p.set_number(v, |p, x| p.start_row = Some(x)))),
    row_ignoring_sign("ER", "End_Row", Number, Part(|p, v| p.set_number(v, |p, x| p.end_row = Some(x)))),
    row("X", "Test_Abort", MaybeNumber, Idle(CTRL_C), Same),
    row_ignoring_sign("", "Test_Abort_Count", Number, Idle(CTRL_C)),
    row("C", "Continue_Trace", Nothing, Flag("--resume"), Same),
    row_ignoring_sign("GI", "Create_Ini", Text, Part(|p, v| p.change(|p| p.created_ini = Some(v.into())))),
    // 3.2.3 Display
    row("D", "Display", MaybeText, Idle(NO_WINDOW), Same),
    row_ignoring_sign("", "Video_Mode", Text, Idle(NO_WINDOW)),
    row_ignoring_sign("", "Palette", Text, Idle(NO_WINDOW)),
    row_ignoring_sign("", "Display_Gamma", Text, Idle(NO_WINDOW)),
    row_ignoring_sign("", "Real_Time_Raytracing", Nothing, Same),
    row("P", "Pause_When_Done", Nothing, Idle(NO_WINDOW), Same),
    row("V", "Verbose", Nothing, Flag("--progress=always"), Flag("--progress=never")),
    row("UD", "Draw_Vistas", Nothing, Idle(NO_WINDOW), Same),
    row_ignoring_sign("SP", "Preview_Start_Size", Number, Idle(NO_WINDOW)),
    row_ignoring_sign("EP", "Preview_End_Size", Number, Idle(NO_WINDOW)),
    // 3.2.4 File output
    row("F", "Output_to_File", MaybeText, Part(|p, v| p.set_file_type(v)), Flag("--no-output")),
    row_ignoring_sign("", "Output_File_Type", Text, Part(|p, v| p.set_file_type(v))),
    row(
        "UA",
        "Output_Alpha",
        Nothing,
        Part(|p, _| p.change(|p| p.alpha = true)),
        Part(|p, _| p.change(|p| p.alpha = false)),
    ),
    row(
        "",
        "Grayscale_Output",
        Nothing,
        Part(|p, _| p.change(|p| p.gray = true)),
        Part(|p, _| p.change(|p| p.gray = false)),
    ),
    row("", "Create_Histogram", Nothing, Lacks("`durer render --stats` tells times"), Same),
    row_ignoring_sign("", "Histogram_Type", Text, Same),
    row_ignoring_sign("", "Histogram_Name", Text, Same),
    row_ignoring_sign("", "Histogram_Grid_Size", Text, Same),
    row_ignoring_sign("", "Bits_Per_Color", Number, Part(|p, v| p.set_bits_per_channel(v))),
    row_ignoring_sign("", "Compression", Number, Idle("durer chooses the compression")),
    row_ignoring_sign("O", "Output_File_Name", Text, Part(|p, v| p.change(|p| p.output = Some(v.into())))),
    row_ignoring_sign("B", "Buffer_Output", MaybeNumber, Same),
    row_ignoring_sign("", "Buffer_Size", Number, Same),
    row("TH", "Dither", MaybeText, Part(|p, v| p.set_dither(v, true)), Part(|p, v| p.set_dither(v, false))),
    row_ignoring_sign("", "Dither_Method", Text, Part(|p, v| p.set_dither_method(v))),
    row_ignoring_sign("FG", "File_Gamma", Text, Part(|p, v| p.set_file_gamma(v))),
    // 3.2.5 Scene parsing
    row_ignoring_sign("", "Declare", Text, Option("--declare")),
    row_ignoring_sign("I", "Input_File_Name", Text, Part(|p, v| p.change(|p| p.input = Some(v.into())))),
    row_ignoring_sign("HI", "Include_Header", Text, Option("--header")),
    row_ignoring_sign("L", "Library_Path", Text, Option("--include")),
    row_ignoring_sign("MV", "Version", Number, Option("--language")),
    // 3.2.6 Shell commands
    row_ignoring_sign("", "Pre_Scene_Command", Text, Lacks(NO_SHELL)),
    row_ignoring_sign("", "Pre_Frame_Command", Text, Lacks(NO_SHELL)),
    row_ignoring_sign("", "Post_Scene_Command", Text, Lacks(NO_SHELL)),
    row_ignoring_sign("", "Post_Frame_Command", Text, Lacks(NO_SHELL)),
    row_ignoring_sign("", "User_Abort_Command", Text, Lacks(NO_SHELL)),
    row_ignoring_sign("", "Fatal_Error_Command", Text, Lacks(NO_SHELL)),
    row_ignoring_sign("", "Pre_Scene_Return", Text, Same),
    row_ignoring_sign("", "Pre_Frame_Return", Text, Same),
    row_ignoring_sign("", "Post_Scene_Return", Text, Same),
    row_ignoring_sign("", "Post_Frame_Return", Text, Same),
    row_ignoring_sign("", "User_Abort_Return", Text, Same),
    row_ignoring_sign("", "Fatal_Error_Return", Text, Same),
    // 3.2.7 Text output
    row("GA", "All_Console", MaybeText, TextFile(Stream::All), Silence(Stream::All)),
    row("GD", "Debug_Console", MaybeText, TextFile(Stream::Debug), Silence(Stream::Debug)),
    row("GF", "Fatal_Console", MaybeText, TextFile(Stream::Fatal), Silence(Stream::Fatal)),
    row("GR", "Render_Console", MaybeText, TextFile(Stream::Render), Silence(Stream::Render)),
    row("GS", "Statistic_Console", MaybeText, TextFile(Stream::Statistics), Silence(Stream::Statistics)),
    row("GW", "Warning_Console", MaybeText, TextFile(Stream::Warning), Silence(Stream::Warning)),
    row("", "All_File", MaybeText, TextFile(Stream::All), Same),
    row("", "Debug_File", MaybeText, TextFile(Stream::Debug), Same),
    row("", "Fatal_File", MaybeText, TextFile(Stream::Fatal), Same),
    row("", "Render_File", MaybeText, TextFile(Stream::Render), Same),
    row("", "Statistic_File", MaybeText, TextFile(Stream::Statistics), Same),
    row("", "Warning_File", MaybeText, TextFile(Stream::Warning), Same),
    row(
        "GP",
        "Append_File",
        Nothing,
        Part(|p, _| p.change(|p| p.appends_text = true)),
        Part(|p, _| p.change(|p| p.appends_text = false)),
    ),
    row_ignoring_sign("WL", "Warning_Level", Number, Same),
    // 3.2.8 Tracing
    row_ignoring_sign("WT", "Work_Threads", Number, Whole("--threads", 1, 4096)),
    row_ignoring_sign("BS", "Render_Block_Size", Number, Same),
    row_ignoring_sign("RP", "Render_Pattern", Number, Same),
    row_ignoring_sign("RS", "Render_Block_Step", Number, Same),
    row_ignoring_sign("Q", "Quality", Number, Whole("--quality", 0, 11)),
    row_ignoring_sign("MB", "Bounding", MaybeNumber, Same),
    row_ignoring_sign("", "Bounding_Threshold", Number, Same),
    row_ignoring_sign("BM", "Bounding_Method", Number, Same),
    row_ignoring_sign("UL", "Light_Buffer", Nothing, Same),
    row_ignoring_sign("UV", "Vista_Buffer", Nothing, Same),
    row_ignoring_sign("UR", "Remove_Bounds", Nothing, Same),
    row_ignoring_sign("SU", "Split_Unions", Nothing, Same),
    row_ignoring_sign("", "BSP_MaxDepth", Number, Same),
    row_ignoring_sign("", "BSP_BaseAccessCost", Number, Same),
    row_ignoring_sign("", "BSP_ChildAccessCost", Number, Same),
    row_ignoring_sign("", "BSP_IsectCost", Number, Same),
    row_ignoring_sign("", "BSP_MissChance", Number, Same),
    row("A", "Antialias", MaybeNumber, Part(|p, v| p.set_antialias(v, true)), Part(|p, v| p.set_antialias(v, false))),
    row_ignoring_sign("", "Antialias_Threshold", Number, Part(|p, v| p.set_number(v, |p, x| p.threshold = x))),
    row_ignoring_sign("AM", "Sampling_Method", Number, Part(|p, v| p.set_sampling_method(v))),
    row_ignoring_sign("AG", "Antialias_Gamma", Number, Part(|p, v| p.set_antialias_gamma(v))),
    row_ignoring_sign("R", "Antialias_Depth", Number, Part(|p, v| p.set_sampling_depth(v))),
    row("J", "Jitter", MaybeNumber, Part(|p, v| p.set_jitter(v, true)), Part(|p, v| p.set_jitter(v, false))),
    row_ignoring_sign("", "Jitter_Amount", Number, Part(|p, v| p.set_jitter(v, true))),
    row("HR", "High_Reproducibility", Nothing, Same, Same),
    row_ignoring_sign("RF", "Radiosity_File_Name", Text, Part(|p, v| p.change(|p| p.radiosity_file = Some(v.into())))),
    row(
        "RFI",
        "Radiosity_From_File",
        Nothing,
        Part(|p, _| p.change(|p| p.loads_radiosity = true)),
        Part(|p, _| p.change(|p| p.loads_radiosity = false)),
    ),
    row(
        "RFO",
        "Radiosity_To_File",
        Nothing,
        Part(|p, _| p.change(|p| p.saves_radiosity = true)),
        Part(|p, _| p.change(|p| p.saves_radiosity = false)),
    ),
    row_ignoring_sign("RVP", "Radiosity_Vain_Pretrace", Nothing, Same),
];

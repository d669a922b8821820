" Made of durer's tables by `UPDATE_EDITORS=1 cargo test --test suite editors::`: change those.
if exists('b:current_syntax')
  finish
endif
syntax case ignore
syntax iskeyword @,48-57,_

syntax keyword povrayiniOption All_Console All_File Antialias Antialias_Depth Antialias_Gamma Antialias_Threshold Append_File
syntax keyword povrayiniOption BSP_BaseAccessCost BSP_ChildAccessCost BSP_IsectCost BSP_MaxDepth BSP_MissChance Bits_Per_Color
syntax keyword povrayiniOption Bounding Bounding_Method Bounding_Threshold Buffer_Output Buffer_Size Clock Clockless_Animation
syntax keyword povrayiniOption Compression Continue_Trace Create_Histogram Create_Ini Cyclic_Animation Debug_Console Debug_File
syntax keyword povrayiniOption Declare Display Display_Gamma Dither Dither_Method Draw_Vistas End_Column End_Row Fatal_Console
syntax keyword povrayiniOption Fatal_Error_Command Fatal_Error_Return Fatal_File Field_Render File_Gamma Final_Clock Final_Frame
syntax keyword povrayiniOption Frame_Step Grayscale_Output Height High_Reproducibility Histogram_Grid_Size Histogram_Name
syntax keyword povrayiniOption Histogram_Type Include_Header Initial_Clock Initial_Frame Input_File_Name Jitter Jitter_Amount
syntax keyword povrayiniOption Library_Path Light_Buffer Max_Image_Buffer_Memory Odd_Field Output_Alpha Output_File_Name
syntax keyword povrayiniOption Output_File_Type Output_to_File Palette Pause_When_Done Post_Frame_Command Post_Frame_Return
syntax keyword povrayiniOption Post_Scene_Command Post_Scene_Return Pre_Frame_Command Pre_Frame_Return Pre_Scene_Command
syntax keyword povrayiniOption Pre_Scene_Return Preview_End_Size Preview_Start_Size Quality Radiosity_File_Name Radiosity_From_File
syntax keyword povrayiniOption Radiosity_To_File Radiosity_Vain_Pretrace Real_Time_Raytracing Remove_Bounds Render_Block_Size
syntax keyword povrayiniOption Render_Block_Step Render_Console Render_File Render_Pattern Sampling_Method Split_Unions Start_Column
syntax keyword povrayiniOption Start_Row Statistic_Console Statistic_File Subset_End_Frame Subset_Start_Frame Test_Abort
syntax keyword povrayiniOption Test_Abort_Count User_Abort_Command User_Abort_Return Verbose Version Video_Mode Vista_Buffer
syntax keyword povrayiniOption Warning_Console Warning_File Warning_Level Width Work_Threads
syntax keyword povrayiniConstant on off true false yes no
syntax match povrayiniNumber /\%(\<\d\+\%(\.\d*\)\=\|\.\d\+\)\%([eE][-+]\=\d\+\)\=\>\=/
syntax match povrayiniSwitch /\%(^\|\s\)\zs[-+]\a\+/
syntax match povrayiniSection /^\s*\[[^\]]*\]\=/
syntax region povrayiniString start=/"/ end=/"/ oneline
syntax match povrayiniComment /[;#].*$/ contains=@Spell

highlight default link povrayiniOption Identifier
highlight default link povrayiniConstant Constant
highlight default link povrayiniNumber Number
highlight default link povrayiniSwitch Statement
highlight default link povrayiniSection Title
highlight default link povrayiniString String
highlight default link povrayiniComment Comment

let b:current_syntax = 'povrayini'

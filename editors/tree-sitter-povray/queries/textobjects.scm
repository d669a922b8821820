(macro) @function.around
(block) @class.around
(line_comment) @comment.inside
(block_comment) @comment.inside

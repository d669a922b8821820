[(block) (parentheses) (brackets) (conditional) (macro)] @indent
["}" ")" "]" (middle) (end)] @outdent

// Tokens, brackets, and directives up to their `#end`: as much as colours, indentation and folds need. All else durer tells (`durer lsp`).
// Which word is what stands in `queries/highlights.scm`, made of durer's tables; so no new word changes the parser.

// (Of two tokens of the same length the earlier rule's is taken: `directive` stands last.)
const directive = names => new RegExp(`#[ \\t]*(?:${names})`);
// What follows without a blank before it.
const within = (precedence, rule) => token.immediate(prec(precedence, rule));

module.exports = grammar({
  name: 'povray',
  extras: $ => [/\s/, /[\u00a0\ufeff\u007f]/, $.line_comment, $.block_comment],
  rules: {
    source_file: $ => repeat($._item),

    _item: $ => choice(
      $.conditional, $.macro, $.declaration, $.directive,
      $.block, $.parentheses, $.brackets,
      $.string, $.number, $.word, $.sign,
    ),

    block: $ => seq('{', repeat($._item), '}'),
    parentheses: $ => seq('(', repeat($._item), ')'),
    brackets: $ => seq('[', repeat($._item), ']'),

    conditional: $ => seq($.opener, repeat(choice($._item, $.middle)), $.end),
    macro: $ => seq($.macro_opener, field('name', $.word), $.parameters, repeat($._item), $.end),
    parameters: $ => seq('(', repeat(choice($.word, ',')), ')'),
    declaration: $ => seq($.declare, field('name', $.word)),

    opener: _ => directive('if|ifdef|ifndef|while|for|switch'),
    middle: _ => directive('else|elseif|case|range'),
    end: _ => directive('end'),
    macro_opener: _ => directive('macro'),
    declare: _ => directive('declare|local'),
    directive: _ => /#[ \t]*[A-Za-z_][A-Za-z_0-9]*/,

    word: _ => /[A-Za-z_][A-Za-z_0-9]*/,
    number: _ => /(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][-+]?[0-9]+)?/,
    string: $ => seq('"', repeat(choice($.escape, within(1, /[^"\\]+/))), token.immediate('"')),
    escape: _ => token.immediate(/\\(?:u[0-9A-Fa-f]{4}|.|\n)/),
    sign: _ => /[^\sA-Za-z_0-9"{}()\[\]#]|#/,

    line_comment: _ => token(seq('//', /[^\n]*/)),
    // They nest; `//` means nothing in them.
    block_comment: $ => seq(token(prec(3, '/*')), repeat(choice($.block_comment, within(2, /[^*\/]+/), within(2, /[*\/]/))), within(3, '*/')),
  },
});

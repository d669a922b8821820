#include "tree_sitter/parser.h"

#if defined(__GNUC__) || defined(__clang__)
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#endif

#define LANGUAGE_VERSION 14
#define STATE_COUNT 114
#define LARGE_STATE_COUNT 36
#define SYMBOL_COUNT 42
#define ALIAS_COUNT 0
#define TOKEN_COUNT 26
#define EXTERNAL_TOKEN_COUNT 0
#define FIELD_COUNT 1
#define MAX_ALIAS_SEQUENCE_LENGTH 5
#define PRODUCTION_ID_COUNT 2

enum ts_symbol_identifiers {
  anon_sym_LBRACE = 1,
  anon_sym_RBRACE = 2,
  anon_sym_LPAREN = 3,
  anon_sym_RPAREN = 4,
  anon_sym_LBRACK = 5,
  anon_sym_RBRACK = 6,
  anon_sym_COMMA = 7,
  sym_opener = 8,
  sym_middle = 9,
  sym_end = 10,
  sym_macro_opener = 11,
  sym_declare = 12,
  sym_directive = 13,
  sym_word = 14,
  sym_number = 15,
  anon_sym_DQUOTE = 16,
  aux_sym_string_token1 = 17,
  anon_sym_DQUOTE2 = 18,
  sym_escape = 19,
  sym_sign = 20,
  sym_line_comment = 21,
  anon_sym_SLASH_STAR = 22,
  aux_sym_block_comment_token1 = 23,
  aux_sym_block_comment_token2 = 24,
  anon_sym_STAR_SLASH = 25,
  sym_source_file = 26,
  sym__item = 27,
  sym_block = 28,
  sym_parentheses = 29,
  sym_brackets = 30,
  sym_conditional = 31,
  sym_macro = 32,
  sym_parameters = 33,
  sym_declaration = 34,
  sym_string = 35,
  sym_block_comment = 36,
  aux_sym_source_file_repeat1 = 37,
  aux_sym_conditional_repeat1 = 38,
  aux_sym_parameters_repeat1 = 39,
  aux_sym_string_repeat1 = 40,
  aux_sym_block_comment_repeat1 = 41,
};

static const char * const ts_symbol_names[] = {
  [ts_builtin_sym_end] = "end",
  [anon_sym_LBRACE] = "{",
  [anon_sym_RBRACE] = "}",
  [anon_sym_LPAREN] = "(",
  [anon_sym_RPAREN] = ")",
  [anon_sym_LBRACK] = "[",
  [anon_sym_RBRACK] = "]",
  [anon_sym_COMMA] = ",",
  [sym_opener] = "opener",
  [sym_middle] = "middle",
  [sym_end] = "end",
  [sym_macro_opener] = "macro_opener",
  [sym_declare] = "declare",
  [sym_directive] = "directive",
  [sym_word] = "word",
  [sym_number] = "number",
  [anon_sym_DQUOTE] = "\"",
  [aux_sym_string_token1] = "string_token1",
  [anon_sym_DQUOTE2] = "\"",
  [sym_escape] = "escape",
  [sym_sign] = "sign",
  [sym_line_comment] = "line_comment",
  [anon_sym_SLASH_STAR] = "/*",
  [aux_sym_block_comment_token1] = "block_comment_token1",
  [aux_sym_block_comment_token2] = "block_comment_token2",
  [anon_sym_STAR_SLASH] = "*/",
  [sym_source_file] = "source_file",
  [sym__item] = "_item",
  [sym_block] = "block",
  [sym_parentheses] = "parentheses",
  [sym_brackets] = "brackets",
  [sym_conditional] = "conditional",
  [sym_macro] = "macro",
  [sym_parameters] = "parameters",
  [sym_declaration] = "declaration",
  [sym_string] = "string",
  [sym_block_comment] = "block_comment",
  [aux_sym_source_file_repeat1] = "source_file_repeat1",
  [aux_sym_conditional_repeat1] = "conditional_repeat1",
  [aux_sym_parameters_repeat1] = "parameters_repeat1",
  [aux_sym_string_repeat1] = "string_repeat1",
  [aux_sym_block_comment_repeat1] = "block_comment_repeat1",
};

static const TSSymbol ts_symbol_map[] = {
  [ts_builtin_sym_end] = ts_builtin_sym_end,
  [anon_sym_LBRACE] = anon_sym_LBRACE,
  [anon_sym_RBRACE] = anon_sym_RBRACE,
  [anon_sym_LPAREN] = anon_sym_LPAREN,
  [anon_sym_RPAREN] = anon_sym_RPAREN,
  [anon_sym_LBRACK] = anon_sym_LBRACK,
  [anon_sym_RBRACK] = anon_sym_RBRACK,
  [anon_sym_COMMA] = anon_sym_COMMA,
  [sym_opener] = sym_opener,
  [sym_middle] = sym_middle,
  [sym_end] = sym_end,
  [sym_macro_opener] = sym_macro_opener,
  [sym_declare] = sym_declare,
  [sym_directive] = sym_directive,
  [sym_word] = sym_word,
  [sym_number] = sym_number,
  [anon_sym_DQUOTE] = anon_sym_DQUOTE,
  [aux_sym_string_token1] = aux_sym_string_token1,
  [anon_sym_DQUOTE2] = anon_sym_DQUOTE,
  [sym_escape] = sym_escape,
  [sym_sign] = sym_sign,
  [sym_line_comment] = sym_line_comment,
  [anon_sym_SLASH_STAR] = anon_sym_SLASH_STAR,
  [aux_sym_block_comment_token1] = aux_sym_block_comment_token1,
  [aux_sym_block_comment_token2] = aux_sym_block_comment_token2,
  [anon_sym_STAR_SLASH] = anon_sym_STAR_SLASH,
  [sym_source_file] = sym_source_file,
  [sym__item] = sym__item,
  [sym_block] = sym_block,
  [sym_parentheses] = sym_parentheses,
  [sym_brackets] = sym_brackets,
  [sym_conditional] = sym_conditional,
  [sym_macro] = sym_macro,
  [sym_parameters] = sym_parameters,
  [sym_declaration] = sym_declaration,
  [sym_string] = sym_string,
  [sym_block_comment] = sym_block_comment,
  [aux_sym_source_file_repeat1] = aux_sym_source_file_repeat1,
  [aux_sym_conditional_repeat1] = aux_sym_conditional_repeat1,
  [aux_sym_parameters_repeat1] = aux_sym_parameters_repeat1,
  [aux_sym_string_repeat1] = aux_sym_string_repeat1,
  [aux_sym_block_comment_repeat1] = aux_sym_block_comment_repeat1,
};

static const TSSymbolMetadata ts_symbol_metadata[] = {
  [ts_builtin_sym_end] = {
    .visible = false,
    .named = true,
  },
  [anon_sym_LBRACE] = {
    .visible = true,
    .named = false,
  },
  [anon_sym_RBRACE] = {
    .visible = true,
    .named = false,
  },
  [anon_sym_LPAREN] = {
    .visible = true,
    .named = false,
  },
  [anon_sym_RPAREN] = {
    .visible = true,
    .named = false,
  },
  [anon_sym_LBRACK] = {
    .visible = true,
    .named = false,
  },
  [anon_sym_RBRACK] = {
    .visible = true,
    .named = false,
  },
  [anon_sym_COMMA] = {
    .visible = true,
    .named = false,
  },
  [sym_opener] = {
    .visible = true,
    .named = true,
  },
  [sym_middle] = {
    .visible = true,
    .named = true,
  },
  [sym_end] = {
    .visible = true,
    .named = true,
  },
  [sym_macro_opener] = {
    .visible = true,
    .named = true,
  },
  [sym_declare] = {
    .visible = true,
    .named = true,
  },
  [sym_directive] = {
    .visible = true,
    .named = true,
  },
  [sym_word] = {
    .visible = true,
    .named = true,
  },
  [sym_number] = {
    .visible = true,
    .named = true,
  },
  [anon_sym_DQUOTE] = {
    .visible = true,
    .named = false,
  },
  [aux_sym_string_token1] = {
    .visible = false,
    .named = false,
  },
  [anon_sym_DQUOTE2] = {
    .visible = true,
    .named = false,
  },
  [sym_escape] = {
    .visible = true,
    .named = true,
  },
  [sym_sign] = {
    .visible = true,
    .named = true,
  },
  [sym_line_comment] = {
    .visible = true,
    .named = true,
  },
  [anon_sym_SLASH_STAR] = {
    .visible = true,
    .named = false,
  },
  [aux_sym_block_comment_token1] = {
    .visible = false,
    .named = false,
  },
  [aux_sym_block_comment_token2] = {
    .visible = false,
    .named = false,
  },
  [anon_sym_STAR_SLASH] = {
    .visible = true,
    .named = false,
  },
  [sym_source_file] = {
    .visible = true,
    .named = true,
  },
  [sym__item] = {
    .visible = false,
    .named = true,
  },
  [sym_block] = {
    .visible = true,
    .named = true,
  },
  [sym_parentheses] = {
    .visible = true,
    .named = true,
  },
  [sym_brackets] = {
    .visible = true,
    .named = true,
  },
  [sym_conditional] = {
    .visible = true,
    .named = true,
  },
  [sym_macro] = {
    .visible = true,
    .named = true,
  },
  [sym_parameters] = {
    .visible = true,
    .named = true,
  },
  [sym_declaration] = {
    .visible = true,
    .named = true,
  },
  [sym_string] = {
    .visible = true,
    .named = true,
  },
  [sym_block_comment] = {
    .visible = true,
    .named = true,
  },
  [aux_sym_source_file_repeat1] = {
    .visible = false,
    .named = false,
  },
  [aux_sym_conditional_repeat1] = {
    .visible = false,
    .named = false,
  },
  [aux_sym_parameters_repeat1] = {
    .visible = false,
    .named = false,
  },
  [aux_sym_string_repeat1] = {
    .visible = false,
    .named = false,
  },
  [aux_sym_block_comment_repeat1] = {
    .visible = false,
    .named = false,
  },
};

enum ts_field_identifiers {
  field_name = 1,
};

static const char * const ts_field_names[] = {
  [0] = NULL,
  [field_name] = "name",
};

static const TSFieldMapSlice ts_field_map_slices[PRODUCTION_ID_COUNT] = {
  [1] = {.index = 0, .length = 1},
};

static const TSFieldMapEntry ts_field_map_entries[] = {
  [0] =
    {field_name, 1},
};

static const TSSymbol ts_alias_sequences[PRODUCTION_ID_COUNT][MAX_ALIAS_SEQUENCE_LENGTH] = {
  [0] = {0},
};

static const uint16_t ts_non_terminal_alias_map[] = {
  0,
};

static const TSStateId ts_primary_state_ids[STATE_COUNT] = {
  [0] = 0,
  [1] = 1,
  [2] = 2,
  [3] = 3,
  [4] = 4,
  [5] = 5,
  [6] = 4,
  [7] = 3,
  [8] = 4,
  [9] = 3,
  [10] = 10,
  [11] = 11,
  [12] = 12,
  [13] = 13,
  [14] = 14,
  [15] = 15,
  [16] = 16,
  [17] = 17,
  [18] = 2,
  [19] = 16,
  [20] = 10,
  [21] = 15,
  [22] = 12,
  [23] = 13,
  [24] = 14,
  [25] = 17,
  [26] = 26,
  [27] = 16,
  [28] = 10,
  [29] = 15,
  [30] = 12,
  [31] = 13,
  [32] = 14,
  [33] = 17,
  [34] = 26,
  [35] = 26,
  [36] = 36,
  [37] = 37,
  [38] = 38,
  [39] = 39,
  [40] = 40,
  [41] = 41,
  [42] = 42,
  [43] = 43,
  [44] = 44,
  [45] = 45,
  [46] = 46,
  [47] = 47,
  [48] = 48,
  [49] = 49,
  [50] = 50,
  [51] = 44,
  [52] = 42,
  [53] = 41,
  [54] = 48,
  [55] = 49,
  [56] = 50,
  [57] = 37,
  [58] = 38,
  [59] = 39,
  [60] = 40,
  [61] = 43,
  [62] = 47,
  [63] = 63,
  [64] = 36,
  [65] = 45,
  [66] = 66,
  [67] = 41,
  [68] = 48,
  [69] = 49,
  [70] = 50,
  [71] = 37,
  [72] = 38,
  [73] = 39,
  [74] = 40,
  [75] = 43,
  [76] = 44,
  [77] = 47,
  [78] = 45,
  [79] = 36,
  [80] = 80,
  [81] = 42,
  [82] = 46,
  [83] = 83,
  [84] = 84,
  [85] = 85,
  [86] = 86,
  [87] = 87,
  [88] = 88,
  [89] = 84,
  [90] = 90,
  [91] = 91,
  [92] = 85,
  [93] = 87,
  [94] = 94,
  [95] = 83,
  [96] = 85,
  [97] = 87,
  [98] = 98,
  [99] = 99,
  [100] = 100,
  [101] = 101,
  [102] = 102,
  [103] = 102,
  [104] = 102,
  [105] = 105,
  [106] = 106,
  [107] = 106,
  [108] = 106,
  [109] = 109,
  [110] = 109,
  [111] = 109,
  [112] = 98,
  [113] = 100,
};

static TSCharacterRange sym_sign_character_set_1[] = {
  {0, 0x08}, {0x0e, 0x1f}, {'!', '!'}, {'#', '\''}, {'*', '/'}, {':', '@'}, {'\\', '\\'}, {'^', '^'},
  {'`', '`'}, {'|', '|'}, {'~', 0x10ffff},
};

static bool ts_lex(TSLexer *lexer, TSStateId state) {
  START_LEXER();
  eof = lexer->eof(lexer);
  switch (state) {
    case 0:
      if (eof) ADVANCE(19);
      ADVANCE_MAP(
        '"', 85,
        '#', 6,
        '(', 22,
        ')', 23,
        '*', 102,
        ',', 26,
        '.', 11,
        '/', 101,
        '[', 24,
        '\\', 9,
        ']', 25,
        '{', 20,
        '}', 21,
      );
      if (('\t' <= lookahead && lookahead <= '\r') ||
          lookahead == ' ' ||
          lookahead == 0x7f ||
          lookahead == 0xa0 ||
          lookahead == 0xfeff) SKIP(16);
      if (('0' <= lookahead && lookahead <= '9')) ADVANCE(77);
      if (('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(76);
      END_STATE();
    case 1:
      if (lookahead == '"') ADVANCE(85);
      if (lookahead == '/') ADVANCE(82);
      if (lookahead == '\\') ADVANCE(9);
      if (('\t' <= lookahead && lookahead <= '\r') ||
          lookahead == ' ' ||
          lookahead == 0x7f ||
          lookahead == 0xa0 ||
          lookahead == 0xfeff) ADVANCE(83);
      if (lookahead != 0) ADVANCE(84);
      END_STATE();
    case 2:
      ADVANCE_MAP(
        '"', 80,
        '#', 93,
        '(', 22,
        '.', 96,
        '/', 92,
        '[', 24,
        '{', 20,
        0x7f, 90,
        0xa0, 90,
        0xfeff, 90,
      );
      if (('\t' <= lookahead && lookahead <= '\r') ||
          lookahead == ' ') SKIP(2);
      if (('0' <= lookahead && lookahead <= '9')) ADVANCE(77);
      if (('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(76);
      if (lookahead != 0 &&
          lookahead != '(' &&
          lookahead != ')' &&
          lookahead != ']' &&
          lookahead != '}') ADVANCE(88);
      END_STATE();
    case 3:
      ADVANCE_MAP(
        '"', 80,
        '#', 94,
        '(', 22,
        '.', 96,
        '/', 92,
        '[', 24,
        '{', 20,
        0x7f, 91,
        0xa0, 91,
        0xfeff, 91,
      );
      if (('\t' <= lookahead && lookahead <= '\r') ||
          lookahead == ' ') SKIP(3);
      if (('0' <= lookahead && lookahead <= '9')) ADVANCE(77);
      if (('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(76);
      if (lookahead != 0 &&
          lookahead != '(' &&
          lookahead != ')' &&
          lookahead != ']' &&
          lookahead != '}') ADVANCE(88);
      END_STATE();
    case 4:
      if (lookahead == '*') ADVANCE(102);
      if (lookahead == '/') ADVANCE(101);
      if (('\t' <= lookahead && lookahead <= '\r') ||
          lookahead == ' ' ||
          lookahead == 0x7f ||
          lookahead == 0xa0 ||
          lookahead == 0xfeff) ADVANCE(99);
      if (lookahead != 0) ADVANCE(100);
      END_STATE();
    case 5:
      if (lookahead == '*') ADVANCE(98);
      if (lookahead == '/') ADVANCE(97);
      END_STATE();
    case 6:
      ADVANCE_MAP(
        'c', 34,
        'd', 45,
        'e', 62,
        'f', 65,
        'i', 51,
        'l', 67,
        'm', 36,
        'r', 35,
        's', 74,
        'w', 56,
        '\t', 6,
        ' ', 6,
      );
      if (('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 7:
      ADVANCE_MAP(
        'd', 45,
        'e', 63,
        'f', 65,
        'i', 51,
        'l', 67,
        'm', 36,
        's', 74,
        'w', 56,
        '\t', 7,
        ' ', 7,
      );
      if (('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 8:
      ADVANCE_MAP(
        'd', 45,
        'f', 65,
        'i', 51,
        'l', 67,
        'm', 36,
        's', 74,
        'w', 56,
        '\t', 8,
        ' ', 8,
      );
      if (('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 9:
      if (lookahead == 'u') ADVANCE(87);
      if (lookahead != 0) ADVANCE(86);
      END_STATE();
    case 10:
      if (lookahead == '+' ||
          lookahead == '-') ADVANCE(12);
      if (('0' <= lookahead && lookahead <= '9')) ADVANCE(79);
      END_STATE();
    case 11:
      if (('0' <= lookahead && lookahead <= '9')) ADVANCE(78);
      END_STATE();
    case 12:
      if (('0' <= lookahead && lookahead <= '9')) ADVANCE(79);
      END_STATE();
    case 13:
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'F') ||
          ('a' <= lookahead && lookahead <= 'f')) ADVANCE(86);
      END_STATE();
    case 14:
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'F') ||
          ('a' <= lookahead && lookahead <= 'f')) ADVANCE(13);
      END_STATE();
    case 15:
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'F') ||
          ('a' <= lookahead && lookahead <= 'f')) ADVANCE(14);
      END_STATE();
    case 16:
      if (eof) ADVANCE(19);
      ADVANCE_MAP(
        '"', 80,
        '#', 6,
        '(', 22,
        ')', 23,
        ',', 26,
        '.', 11,
        '/', 5,
        '[', 24,
        ']', 25,
        '{', 20,
        '}', 21,
      );
      if (('\t' <= lookahead && lookahead <= '\r') ||
          lookahead == ' ' ||
          lookahead == 0x7f ||
          lookahead == 0xa0 ||
          lookahead == 0xfeff) SKIP(16);
      if (('0' <= lookahead && lookahead <= '9')) ADVANCE(77);
      if (('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(76);
      END_STATE();
    case 17:
      if (eof) ADVANCE(19);
      ADVANCE_MAP(
        '"', 80,
        '#', 95,
        '(', 22,
        ')', 23,
        '.', 96,
        '/', 92,
        '[', 24,
        ']', 25,
        '{', 20,
        '}', 21,
        0x7f, 89,
        0xa0, 89,
        0xfeff, 89,
      );
      if (('\t' <= lookahead && lookahead <= '\r') ||
          lookahead == ' ') SKIP(17);
      if (('0' <= lookahead && lookahead <= '9')) ADVANCE(77);
      if (('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(76);
      if (lookahead != 0) ADVANCE(88);
      END_STATE();
    case 18:
      if (eof) ADVANCE(19);
      if (lookahead == '(') ADVANCE(22);
      if (lookahead == ')') ADVANCE(23);
      if (lookahead == ',') ADVANCE(26);
      if (lookahead == '/') ADVANCE(5);
      if (('\t' <= lookahead && lookahead <= '\r') ||
          lookahead == ' ' ||
          lookahead == 0x7f ||
          lookahead == 0xa0 ||
          lookahead == 0xfeff) SKIP(18);
      if (('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(76);
      END_STATE();
    case 19:
      ACCEPT_TOKEN(ts_builtin_sym_end);
      END_STATE();
    case 20:
      ACCEPT_TOKEN(anon_sym_LBRACE);
      END_STATE();
    case 21:
      ACCEPT_TOKEN(anon_sym_RBRACE);
      END_STATE();
    case 22:
      ACCEPT_TOKEN(anon_sym_LPAREN);
      END_STATE();
    case 23:
      ACCEPT_TOKEN(anon_sym_RPAREN);
      END_STATE();
    case 24:
      ACCEPT_TOKEN(anon_sym_LBRACK);
      END_STATE();
    case 25:
      ACCEPT_TOKEN(anon_sym_RBRACK);
      END_STATE();
    case 26:
      ACCEPT_TOKEN(anon_sym_COMMA);
      END_STATE();
    case 27:
      ACCEPT_TOKEN(sym_opener);
      if (lookahead == 'd') ADVANCE(50);
      if (lookahead == 'n') ADVANCE(44);
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 28:
      ACCEPT_TOKEN(sym_opener);
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 29:
      ACCEPT_TOKEN(sym_middle);
      if (lookahead == 'i') ADVANCE(53);
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 30:
      ACCEPT_TOKEN(sym_middle);
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 31:
      ACCEPT_TOKEN(sym_end);
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 32:
      ACCEPT_TOKEN(sym_macro_opener);
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 33:
      ACCEPT_TOKEN(sym_declare);
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 34:
      ACCEPT_TOKEN(sym_directive);
      if (lookahead == 'a') ADVANCE(71);
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('b' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 35:
      ACCEPT_TOKEN(sym_directive);
      if (lookahead == 'a') ADVANCE(64);
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('b' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 36:
      ACCEPT_TOKEN(sym_directive);
      if (lookahead == 'a') ADVANCE(41);
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('b' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 37:
      ACCEPT_TOKEN(sym_directive);
      if (lookahead == 'a') ADVANCE(70);
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('b' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 38:
      ACCEPT_TOKEN(sym_directive);
      if (lookahead == 'a') ADVANCE(59);
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('b' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 39:
      ACCEPT_TOKEN(sym_directive);
      if (lookahead == 'c') ADVANCE(60);
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 40:
      ACCEPT_TOKEN(sym_directive);
      if (lookahead == 'c') ADVANCE(55);
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 41:
      ACCEPT_TOKEN(sym_directive);
      if (lookahead == 'c') ADVANCE(69);
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 42:
      ACCEPT_TOKEN(sym_directive);
      if (lookahead == 'c') ADVANCE(38);
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 43:
      ACCEPT_TOKEN(sym_directive);
      if (lookahead == 'd') ADVANCE(31);
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 44:
      ACCEPT_TOKEN(sym_directive);
      if (lookahead == 'd') ADVANCE(50);
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 45:
      ACCEPT_TOKEN(sym_directive);
      if (lookahead == 'e') ADVANCE(39);
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 46:
      ACCEPT_TOKEN(sym_directive);
      if (lookahead == 'e') ADVANCE(28);
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 47:
      ACCEPT_TOKEN(sym_directive);
      if (lookahead == 'e') ADVANCE(30);
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 48:
      ACCEPT_TOKEN(sym_directive);
      if (lookahead == 'e') ADVANCE(29);
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 49:
      ACCEPT_TOKEN(sym_directive);
      if (lookahead == 'e') ADVANCE(33);
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 50:
      ACCEPT_TOKEN(sym_directive);
      if (lookahead == 'e') ADVANCE(52);
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 51:
      ACCEPT_TOKEN(sym_directive);
      if (lookahead == 'f') ADVANCE(27);
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 52:
      ACCEPT_TOKEN(sym_directive);
      if (lookahead == 'f') ADVANCE(28);
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 53:
      ACCEPT_TOKEN(sym_directive);
      if (lookahead == 'f') ADVANCE(30);
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 54:
      ACCEPT_TOKEN(sym_directive);
      if (lookahead == 'g') ADVANCE(47);
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 55:
      ACCEPT_TOKEN(sym_directive);
      if (lookahead == 'h') ADVANCE(28);
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 56:
      ACCEPT_TOKEN(sym_directive);
      if (lookahead == 'h') ADVANCE(58);
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 57:
      ACCEPT_TOKEN(sym_directive);
      if (lookahead == 'i') ADVANCE(73);
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 58:
      ACCEPT_TOKEN(sym_directive);
      if (lookahead == 'i') ADVANCE(61);
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 59:
      ACCEPT_TOKEN(sym_directive);
      if (lookahead == 'l') ADVANCE(33);
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 60:
      ACCEPT_TOKEN(sym_directive);
      if (lookahead == 'l') ADVANCE(37);
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 61:
      ACCEPT_TOKEN(sym_directive);
      if (lookahead == 'l') ADVANCE(46);
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 62:
      ACCEPT_TOKEN(sym_directive);
      if (lookahead == 'l') ADVANCE(72);
      if (lookahead == 'n') ADVANCE(43);
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 63:
      ACCEPT_TOKEN(sym_directive);
      if (lookahead == 'n') ADVANCE(43);
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 64:
      ACCEPT_TOKEN(sym_directive);
      if (lookahead == 'n') ADVANCE(54);
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 65:
      ACCEPT_TOKEN(sym_directive);
      if (lookahead == 'o') ADVANCE(68);
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 66:
      ACCEPT_TOKEN(sym_directive);
      if (lookahead == 'o') ADVANCE(32);
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 67:
      ACCEPT_TOKEN(sym_directive);
      if (lookahead == 'o') ADVANCE(42);
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 68:
      ACCEPT_TOKEN(sym_directive);
      if (lookahead == 'r') ADVANCE(28);
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 69:
      ACCEPT_TOKEN(sym_directive);
      if (lookahead == 'r') ADVANCE(66);
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 70:
      ACCEPT_TOKEN(sym_directive);
      if (lookahead == 'r') ADVANCE(49);
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 71:
      ACCEPT_TOKEN(sym_directive);
      if (lookahead == 's') ADVANCE(47);
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 72:
      ACCEPT_TOKEN(sym_directive);
      if (lookahead == 's') ADVANCE(48);
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 73:
      ACCEPT_TOKEN(sym_directive);
      if (lookahead == 't') ADVANCE(40);
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 74:
      ACCEPT_TOKEN(sym_directive);
      if (lookahead == 'w') ADVANCE(57);
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 75:
      ACCEPT_TOKEN(sym_directive);
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 76:
      ACCEPT_TOKEN(sym_word);
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(76);
      END_STATE();
    case 77:
      ACCEPT_TOKEN(sym_number);
      if (lookahead == '.') ADVANCE(78);
      if (lookahead == 'E' ||
          lookahead == 'e') ADVANCE(10);
      if (('0' <= lookahead && lookahead <= '9')) ADVANCE(77);
      END_STATE();
    case 78:
      ACCEPT_TOKEN(sym_number);
      if (lookahead == 'E' ||
          lookahead == 'e') ADVANCE(10);
      if (('0' <= lookahead && lookahead <= '9')) ADVANCE(78);
      END_STATE();
    case 79:
      ACCEPT_TOKEN(sym_number);
      if (('0' <= lookahead && lookahead <= '9')) ADVANCE(79);
      END_STATE();
    case 80:
      ACCEPT_TOKEN(anon_sym_DQUOTE);
      END_STATE();
    case 81:
      ACCEPT_TOKEN(aux_sym_string_token1);
      if (lookahead == '\n') ADVANCE(84);
      if (lookahead != 0 &&
          lookahead != '"' &&
          lookahead != '\\') ADVANCE(81);
      END_STATE();
    case 82:
      ACCEPT_TOKEN(aux_sym_string_token1);
      if (lookahead == '*') ADVANCE(98);
      if (lookahead == '/') ADVANCE(81);
      if (lookahead != 0 &&
          lookahead != '"' &&
          lookahead != '\\') ADVANCE(84);
      END_STATE();
    case 83:
      ACCEPT_TOKEN(aux_sym_string_token1);
      if (lookahead == '/') ADVANCE(82);
      if (('\t' <= lookahead && lookahead <= '\r') ||
          lookahead == ' ' ||
          lookahead == 0x7f ||
          lookahead == 0xa0 ||
          lookahead == 0xfeff) ADVANCE(83);
      if (lookahead != 0 &&
          lookahead != '"' &&
          lookahead != '\\') ADVANCE(84);
      END_STATE();
    case 84:
      ACCEPT_TOKEN(aux_sym_string_token1);
      if (lookahead != 0 &&
          lookahead != '"' &&
          lookahead != '\\') ADVANCE(84);
      END_STATE();
    case 85:
      ACCEPT_TOKEN(anon_sym_DQUOTE2);
      END_STATE();
    case 86:
      ACCEPT_TOKEN(sym_escape);
      END_STATE();
    case 87:
      ACCEPT_TOKEN(sym_escape);
      if (('0' <= lookahead && lookahead <= '9') ||
          ('A' <= lookahead && lookahead <= 'F') ||
          ('a' <= lookahead && lookahead <= 'f')) ADVANCE(15);
      END_STATE();
    case 88:
      ACCEPT_TOKEN(sym_sign);
      END_STATE();
    case 89:
      ACCEPT_TOKEN(sym_sign);
      if (lookahead == '#') ADVANCE(95);
      if (lookahead == '.') ADVANCE(96);
      if (lookahead == '/') ADVANCE(92);
      if (lookahead == 0x7f ||
          lookahead == 0xa0 ||
          lookahead == 0xfeff) ADVANCE(89);
      if ((!eof && set_contains(sym_sign_character_set_1, 11, lookahead))) ADVANCE(88);
      END_STATE();
    case 90:
      ACCEPT_TOKEN(sym_sign);
      if (lookahead == '#') ADVANCE(93);
      if (lookahead == '.') ADVANCE(96);
      if (lookahead == '/') ADVANCE(92);
      if (lookahead == 0x7f ||
          lookahead == 0xa0 ||
          lookahead == 0xfeff) ADVANCE(90);
      if ((!eof && set_contains(sym_sign_character_set_1, 11, lookahead))) ADVANCE(88);
      END_STATE();
    case 91:
      ACCEPT_TOKEN(sym_sign);
      if (lookahead == '#') ADVANCE(94);
      if (lookahead == '.') ADVANCE(96);
      if (lookahead == '/') ADVANCE(92);
      if (lookahead == 0x7f ||
          lookahead == 0xa0 ||
          lookahead == 0xfeff) ADVANCE(91);
      if ((!eof && set_contains(sym_sign_character_set_1, 11, lookahead))) ADVANCE(88);
      END_STATE();
    case 92:
      ACCEPT_TOKEN(sym_sign);
      if (lookahead == '*') ADVANCE(98);
      if (lookahead == '/') ADVANCE(97);
      END_STATE();
    case 93:
      ACCEPT_TOKEN(sym_sign);
      ADVANCE_MAP(
        'c', 34,
        'd', 45,
        'e', 62,
        'f', 65,
        'i', 51,
        'l', 67,
        'm', 36,
        'r', 35,
        's', 74,
        'w', 56,
        '\t', 6,
        ' ', 6,
      );
      if (('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 94:
      ACCEPT_TOKEN(sym_sign);
      ADVANCE_MAP(
        'd', 45,
        'e', 63,
        'f', 65,
        'i', 51,
        'l', 67,
        'm', 36,
        's', 74,
        'w', 56,
        '\t', 7,
        ' ', 7,
      );
      if (('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 95:
      ACCEPT_TOKEN(sym_sign);
      ADVANCE_MAP(
        'd', 45,
        'f', 65,
        'i', 51,
        'l', 67,
        'm', 36,
        's', 74,
        'w', 56,
        '\t', 8,
        ' ', 8,
      );
      if (('A' <= lookahead && lookahead <= 'Z') ||
          lookahead == '_' ||
          ('a' <= lookahead && lookahead <= 'z')) ADVANCE(75);
      END_STATE();
    case 96:
      ACCEPT_TOKEN(sym_sign);
      if (('0' <= lookahead && lookahead <= '9')) ADVANCE(78);
      END_STATE();
    case 97:
      ACCEPT_TOKEN(sym_line_comment);
      if (lookahead != 0 &&
          lookahead != '\n') ADVANCE(97);
      END_STATE();
    case 98:
      ACCEPT_TOKEN(anon_sym_SLASH_STAR);
      END_STATE();
    case 99:
      ACCEPT_TOKEN(aux_sym_block_comment_token1);
      if (lookahead == '/') ADVANCE(5);
      if (('\t' <= lookahead && lookahead <= '\r') ||
          lookahead == ' ' ||
          lookahead == 0x7f ||
          lookahead == 0xa0 ||
          lookahead == 0xfeff) ADVANCE(99);
      if (lookahead != 0 &&
          lookahead != '*') ADVANCE(100);
      END_STATE();
    case 100:
      ACCEPT_TOKEN(aux_sym_block_comment_token1);
      if (lookahead != 0 &&
          lookahead != '*' &&
          lookahead != '/') ADVANCE(100);
      END_STATE();
    case 101:
      ACCEPT_TOKEN(aux_sym_block_comment_token2);
      if (lookahead == '*') ADVANCE(98);
      END_STATE();
    case 102:
      ACCEPT_TOKEN(aux_sym_block_comment_token2);
      if (lookahead == '/') ADVANCE(103);
      END_STATE();
    case 103:
      ACCEPT_TOKEN(anon_sym_STAR_SLASH);
      END_STATE();
    default:
      return false;
  }
}

static const TSLexMode ts_lex_modes[STATE_COUNT] = {
  [0] = {.lex_state = 0},
  [1] = {.lex_state = 17},
  [2] = {.lex_state = 17},
  [3] = {.lex_state = 2},
  [4] = {.lex_state = 2},
  [5] = {.lex_state = 2},
  [6] = {.lex_state = 2},
  [7] = {.lex_state = 2},
  [8] = {.lex_state = 2},
  [9] = {.lex_state = 2},
  [10] = {.lex_state = 17},
  [11] = {.lex_state = 17},
  [12] = {.lex_state = 17},
  [13] = {.lex_state = 17},
  [14] = {.lex_state = 17},
  [15] = {.lex_state = 17},
  [16] = {.lex_state = 17},
  [17] = {.lex_state = 3},
  [18] = {.lex_state = 3},
  [19] = {.lex_state = 17},
  [20] = {.lex_state = 17},
  [21] = {.lex_state = 17},
  [22] = {.lex_state = 17},
  [23] = {.lex_state = 17},
  [24] = {.lex_state = 17},
  [25] = {.lex_state = 3},
  [26] = {.lex_state = 3},
  [27] = {.lex_state = 17},
  [28] = {.lex_state = 17},
  [29] = {.lex_state = 17},
  [30] = {.lex_state = 17},
  [31] = {.lex_state = 17},
  [32] = {.lex_state = 17},
  [33] = {.lex_state = 3},
  [34] = {.lex_state = 3},
  [35] = {.lex_state = 3},
  [36] = {.lex_state = 17},
  [37] = {.lex_state = 17},
  [38] = {.lex_state = 17},
  [39] = {.lex_state = 17},
  [40] = {.lex_state = 17},
  [41] = {.lex_state = 17},
  [42] = {.lex_state = 17},
  [43] = {.lex_state = 17},
  [44] = {.lex_state = 17},
  [45] = {.lex_state = 17},
  [46] = {.lex_state = 17},
  [47] = {.lex_state = 17},
  [48] = {.lex_state = 17},
  [49] = {.lex_state = 17},
  [50] = {.lex_state = 17},
  [51] = {.lex_state = 2},
  [52] = {.lex_state = 2},
  [53] = {.lex_state = 2},
  [54] = {.lex_state = 2},
  [55] = {.lex_state = 2},
  [56] = {.lex_state = 2},
  [57] = {.lex_state = 2},
  [58] = {.lex_state = 2},
  [59] = {.lex_state = 2},
  [60] = {.lex_state = 2},
  [61] = {.lex_state = 2},
  [62] = {.lex_state = 2},
  [63] = {.lex_state = 2},
  [64] = {.lex_state = 2},
  [65] = {.lex_state = 2},
  [66] = {.lex_state = 3},
  [67] = {.lex_state = 3},
  [68] = {.lex_state = 3},
  [69] = {.lex_state = 3},
  [70] = {.lex_state = 3},
  [71] = {.lex_state = 3},
  [72] = {.lex_state = 3},
  [73] = {.lex_state = 3},
  [74] = {.lex_state = 3},
  [75] = {.lex_state = 3},
  [76] = {.lex_state = 3},
  [77] = {.lex_state = 3},
  [78] = {.lex_state = 3},
  [79] = {.lex_state = 3},
  [80] = {.lex_state = 3},
  [81] = {.lex_state = 3},
  [82] = {.lex_state = 3},
  [83] = {.lex_state = 4},
  [84] = {.lex_state = 4},
  [85] = {.lex_state = 1},
  [86] = {.lex_state = 18},
  [87] = {.lex_state = 1},
  [88] = {.lex_state = 1},
  [89] = {.lex_state = 4},
  [90] = {.lex_state = 18},
  [91] = {.lex_state = 4},
  [92] = {.lex_state = 1},
  [93] = {.lex_state = 1},
  [94] = {.lex_state = 18},
  [95] = {.lex_state = 4},
  [96] = {.lex_state = 1},
  [97] = {.lex_state = 1},
  [98] = {.lex_state = 4},
  [99] = {.lex_state = 1},
  [100] = {.lex_state = 4},
  [101] = {.lex_state = 18},
  [102] = {.lex_state = 18},
  [103] = {.lex_state = 18},
  [104] = {.lex_state = 18},
  [105] = {.lex_state = 18},
  [106] = {.lex_state = 18},
  [107] = {.lex_state = 18},
  [108] = {.lex_state = 18},
  [109] = {.lex_state = 18},
  [110] = {.lex_state = 18},
  [111] = {.lex_state = 18},
  [112] = {(TSStateId)(-1)},
  [113] = {(TSStateId)(-1)},
};

static const uint16_t ts_parse_table[LARGE_STATE_COUNT][SYMBOL_COUNT] = {
  [0] = {
    [sym_block_comment] = STATE(0),
    [ts_builtin_sym_end] = ACTIONS(1),
    [anon_sym_LBRACE] = ACTIONS(1),
    [anon_sym_RBRACE] = ACTIONS(1),
    [anon_sym_LPAREN] = ACTIONS(1),
    [anon_sym_RPAREN] = ACTIONS(1),
    [anon_sym_LBRACK] = ACTIONS(1),
    [anon_sym_RBRACK] = ACTIONS(1),
    [anon_sym_COMMA] = ACTIONS(1),
    [sym_opener] = ACTIONS(1),
    [sym_middle] = ACTIONS(1),
    [sym_end] = ACTIONS(1),
    [sym_macro_opener] = ACTIONS(1),
    [sym_declare] = ACTIONS(1),
    [sym_directive] = ACTIONS(1),
    [sym_word] = ACTIONS(1),
    [sym_number] = ACTIONS(1),
    [anon_sym_DQUOTE] = ACTIONS(1),
    [anon_sym_DQUOTE2] = ACTIONS(1),
    [sym_escape] = ACTIONS(1),
    [sym_line_comment] = ACTIONS(3),
    [anon_sym_SLASH_STAR] = ACTIONS(5),
    [aux_sym_block_comment_token2] = ACTIONS(1),
    [anon_sym_STAR_SLASH] = ACTIONS(1),
  },
  [1] = {
    [sym_source_file] = STATE(105),
    [sym__item] = STATE(46),
    [sym_block] = STATE(45),
    [sym_parentheses] = STATE(45),
    [sym_brackets] = STATE(45),
    [sym_conditional] = STATE(45),
    [sym_macro] = STATE(45),
    [sym_declaration] = STATE(45),
    [sym_string] = STATE(45),
    [sym_block_comment] = STATE(1),
    [aux_sym_source_file_repeat1] = STATE(11),
    [ts_builtin_sym_end] = ACTIONS(7),
    [anon_sym_LBRACE] = ACTIONS(9),
    [anon_sym_LPAREN] = ACTIONS(11),
    [anon_sym_LBRACK] = ACTIONS(13),
    [sym_opener] = ACTIONS(15),
    [sym_macro_opener] = ACTIONS(17),
    [sym_declare] = ACTIONS(19),
    [sym_directive] = ACTIONS(21),
    [sym_word] = ACTIONS(21),
    [sym_number] = ACTIONS(21),
    [anon_sym_DQUOTE] = ACTIONS(23),
    [sym_sign] = ACTIONS(21),
    [sym_line_comment] = ACTIONS(3),
    [anon_sym_SLASH_STAR] = ACTIONS(25),
  },
  [2] = {
    [sym__item] = STATE(46),
    [sym_block] = STATE(45),
    [sym_parentheses] = STATE(45),
    [sym_brackets] = STATE(45),
    [sym_conditional] = STATE(45),
    [sym_macro] = STATE(45),
    [sym_declaration] = STATE(45),
    [sym_string] = STATE(45),
    [sym_block_comment] = STATE(2),
    [aux_sym_source_file_repeat1] = STATE(2),
    [ts_builtin_sym_end] = ACTIONS(27),
    [anon_sym_LBRACE] = ACTIONS(29),
    [anon_sym_RBRACE] = ACTIONS(32),
    [anon_sym_LPAREN] = ACTIONS(34),
    [anon_sym_RPAREN] = ACTIONS(32),
    [anon_sym_LBRACK] = ACTIONS(37),
    [anon_sym_RBRACK] = ACTIONS(32),
    [sym_opener] = ACTIONS(40),
    [sym_macro_opener] = ACTIONS(43),
    [sym_declare] = ACTIONS(46),
    [sym_directive] = ACTIONS(49),
    [sym_word] = ACTIONS(49),
    [sym_number] = ACTIONS(49),
    [anon_sym_DQUOTE] = ACTIONS(52),
    [sym_sign] = ACTIONS(49),
    [sym_line_comment] = ACTIONS(3),
    [anon_sym_SLASH_STAR] = ACTIONS(25),
  },
  [3] = {
    [sym__item] = STATE(63),
    [sym_block] = STATE(65),
    [sym_parentheses] = STATE(65),
    [sym_brackets] = STATE(65),
    [sym_conditional] = STATE(65),
    [sym_macro] = STATE(65),
    [sym_declaration] = STATE(65),
    [sym_string] = STATE(65),
    [sym_block_comment] = STATE(3),
    [aux_sym_conditional_repeat1] = STATE(5),
    [anon_sym_LBRACE] = ACTIONS(55),
    [anon_sym_LPAREN] = ACTIONS(57),
    [anon_sym_LBRACK] = ACTIONS(59),
    [sym_opener] = ACTIONS(61),
    [sym_middle] = ACTIONS(63),
    [sym_end] = ACTIONS(65),
    [sym_macro_opener] = ACTIONS(67),
    [sym_declare] = ACTIONS(69),
    [sym_directive] = ACTIONS(71),
    [sym_word] = ACTIONS(71),
    [sym_number] = ACTIONS(71),
    [anon_sym_DQUOTE] = ACTIONS(73),
    [sym_sign] = ACTIONS(71),
    [sym_line_comment] = ACTIONS(3),
    [anon_sym_SLASH_STAR] = ACTIONS(25),
  },
  [4] = {
    [sym__item] = STATE(63),
    [sym_block] = STATE(65),
    [sym_parentheses] = STATE(65),
    [sym_brackets] = STATE(65),
    [sym_conditional] = STATE(65),
    [sym_macro] = STATE(65),
    [sym_declaration] = STATE(65),
    [sym_string] = STATE(65),
    [sym_block_comment] = STATE(4),
    [aux_sym_conditional_repeat1] = STATE(3),
    [anon_sym_LBRACE] = ACTIONS(55),
    [anon_sym_LPAREN] = ACTIONS(57),
    [anon_sym_LBRACK] = ACTIONS(59),
    [sym_opener] = ACTIONS(61),
    [sym_middle] = ACTIONS(63),
    [sym_end] = ACTIONS(75),
    [sym_macro_opener] = ACTIONS(67),
    [sym_declare] = ACTIONS(69),
    [sym_directive] = ACTIONS(71),
    [sym_word] = ACTIONS(71),
    [sym_number] = ACTIONS(71),
    [anon_sym_DQUOTE] = ACTIONS(73),
    [sym_sign] = ACTIONS(71),
    [sym_line_comment] = ACTIONS(3),
    [anon_sym_SLASH_STAR] = ACTIONS(25),
  },
  [5] = {
    [sym__item] = STATE(63),
    [sym_block] = STATE(65),
    [sym_parentheses] = STATE(65),
    [sym_brackets] = STATE(65),
    [sym_conditional] = STATE(65),
    [sym_macro] = STATE(65),
    [sym_declaration] = STATE(65),
    [sym_string] = STATE(65),
    [sym_block_comment] = STATE(5),
    [aux_sym_conditional_repeat1] = STATE(5),
    [anon_sym_LBRACE] = ACTIONS(77),
    [anon_sym_LPAREN] = ACTIONS(80),
    [anon_sym_LBRACK] = ACTIONS(83),
    [sym_opener] = ACTIONS(86),
    [sym_middle] = ACTIONS(89),
    [sym_end] = ACTIONS(92),
    [sym_macro_opener] = ACTIONS(94),
    [sym_declare] = ACTIONS(97),
    [sym_directive] = ACTIONS(100),
    [sym_word] = ACTIONS(100),
    [sym_number] = ACTIONS(100),
    [anon_sym_DQUOTE] = ACTIONS(103),
    [sym_sign] = ACTIONS(100),
    [sym_line_comment] = ACTIONS(3),
    [anon_sym_SLASH_STAR] = ACTIONS(25),
  },
  [6] = {
    [sym__item] = STATE(63),
    [sym_block] = STATE(65),
    [sym_parentheses] = STATE(65),
    [sym_brackets] = STATE(65),
    [sym_conditional] = STATE(65),
    [sym_macro] = STATE(65),
    [sym_declaration] = STATE(65),
    [sym_string] = STATE(65),
    [sym_block_comment] = STATE(6),
    [aux_sym_conditional_repeat1] = STATE(7),
    [anon_sym_LBRACE] = ACTIONS(55),
    [anon_sym_LPAREN] = ACTIONS(57),
    [anon_sym_LBRACK] = ACTIONS(59),
    [sym_opener] = ACTIONS(61),
    [sym_middle] = ACTIONS(63),
    [sym_end] = ACTIONS(106),
    [sym_macro_opener] = ACTIONS(67),
    [sym_declare] = ACTIONS(69),
    [sym_directive] = ACTIONS(71),
    [sym_word] = ACTIONS(71),
    [sym_number] = ACTIONS(71),
    [anon_sym_DQUOTE] = ACTIONS(73),
    [sym_sign] = ACTIONS(71),
    [sym_line_comment] = ACTIONS(3),
    [anon_sym_SLASH_STAR] = ACTIONS(25),
  },
  [7] = {
    [sym__item] = STATE(63),
    [sym_block] = STATE(65),
    [sym_parentheses] = STATE(65),
    [sym_brackets] = STATE(65),
    [sym_conditional] = STATE(65),
    [sym_macro] = STATE(65),
    [sym_declaration] = STATE(65),
    [sym_string] = STATE(65),
    [sym_block_comment] = STATE(7),
    [aux_sym_conditional_repeat1] = STATE(5),
    [anon_sym_LBRACE] = ACTIONS(55),
    [anon_sym_LPAREN] = ACTIONS(57),
    [anon_sym_LBRACK] = ACTIONS(59),
    [sym_opener] = ACTIONS(61),
    [sym_middle] = ACTIONS(63),
    [sym_end] = ACTIONS(108),
    [sym_macro_opener] = ACTIONS(67),
    [sym_declare] = ACTIONS(69),
    [sym_directive] = ACTIONS(71),
    [sym_word] = ACTIONS(71),
    [sym_number] = ACTIONS(71),
    [anon_sym_DQUOTE] = ACTIONS(73),
    [sym_sign] = ACTIONS(71),
    [sym_line_comment] = ACTIONS(3),
    [anon_sym_SLASH_STAR] = ACTIONS(25),
  },
  [8] = {
    [sym__item] = STATE(63),
    [sym_block] = STATE(65),
    [sym_parentheses] = STATE(65),
    [sym_brackets] = STATE(65),
    [sym_conditional] = STATE(65),
    [sym_macro] = STATE(65),
    [sym_declaration] = STATE(65),
    [sym_string] = STATE(65),
    [sym_block_comment] = STATE(8),
    [aux_sym_conditional_repeat1] = STATE(9),
    [anon_sym_LBRACE] = ACTIONS(55),
    [anon_sym_LPAREN] = ACTIONS(57),
    [anon_sym_LBRACK] = ACTIONS(59),
    [sym_opener] = ACTIONS(61),
    [sym_middle] = ACTIONS(63),
    [sym_end] = ACTIONS(110),
    [sym_macro_opener] = ACTIONS(67),
    [sym_declare] = ACTIONS(69),
    [sym_directive] = ACTIONS(71),
    [sym_word] = ACTIONS(71),
    [sym_number] = ACTIONS(71),
    [anon_sym_DQUOTE] = ACTIONS(73),
    [sym_sign] = ACTIONS(71),
    [sym_line_comment] = ACTIONS(3),
    [anon_sym_SLASH_STAR] = ACTIONS(25),
  },
  [9] = {
    [sym__item] = STATE(63),
    [sym_block] = STATE(65),
    [sym_parentheses] = STATE(65),
    [sym_brackets] = STATE(65),
    [sym_conditional] = STATE(65),
    [sym_macro] = STATE(65),
    [sym_declaration] = STATE(65),
    [sym_string] = STATE(65),
    [sym_block_comment] = STATE(9),
    [aux_sym_conditional_repeat1] = STATE(5),
    [anon_sym_LBRACE] = ACTIONS(55),
    [anon_sym_LPAREN] = ACTIONS(57),
    [anon_sym_LBRACK] = ACTIONS(59),
    [sym_opener] = ACTIONS(61),
    [sym_middle] = ACTIONS(63),
    [sym_end] = ACTIONS(112),
    [sym_macro_opener] = ACTIONS(67),
    [sym_declare] = ACTIONS(69),
    [sym_directive] = ACTIONS(71),
    [sym_word] = ACTIONS(71),
    [sym_number] = ACTIONS(71),
    [anon_sym_DQUOTE] = ACTIONS(73),
    [sym_sign] = ACTIONS(71),
    [sym_line_comment] = ACTIONS(3),
    [anon_sym_SLASH_STAR] = ACTIONS(25),
  },
  [10] = {
    [sym__item] = STATE(46),
    [sym_block] = STATE(45),
    [sym_parentheses] = STATE(45),
    [sym_brackets] = STATE(45),
    [sym_conditional] = STATE(45),
    [sym_macro] = STATE(45),
    [sym_declaration] = STATE(45),
    [sym_string] = STATE(45),
    [sym_block_comment] = STATE(10),
    [aux_sym_source_file_repeat1] = STATE(13),
    [anon_sym_LBRACE] = ACTIONS(9),
    [anon_sym_LPAREN] = ACTIONS(11),
    [anon_sym_RPAREN] = ACTIONS(114),
    [anon_sym_LBRACK] = ACTIONS(13),
    [sym_opener] = ACTIONS(15),
    [sym_macro_opener] = ACTIONS(17),
    [sym_declare] = ACTIONS(19),
    [sym_directive] = ACTIONS(21),
    [sym_word] = ACTIONS(21),
    [sym_number] = ACTIONS(21),
    [anon_sym_DQUOTE] = ACTIONS(23),
    [sym_sign] = ACTIONS(21),
    [sym_line_comment] = ACTIONS(3),
    [anon_sym_SLASH_STAR] = ACTIONS(25),
  },
  [11] = {
    [sym__item] = STATE(46),
    [sym_block] = STATE(45),
    [sym_parentheses] = STATE(45),
    [sym_brackets] = STATE(45),
    [sym_conditional] = STATE(45),
    [sym_macro] = STATE(45),
    [sym_declaration] = STATE(45),
    [sym_string] = STATE(45),
    [sym_block_comment] = STATE(11),
    [aux_sym_source_file_repeat1] = STATE(2),
    [ts_builtin_sym_end] = ACTIONS(116),
    [anon_sym_LBRACE] = ACTIONS(9),
    [anon_sym_LPAREN] = ACTIONS(11),
    [anon_sym_LBRACK] = ACTIONS(13),
    [sym_opener] = ACTIONS(15),
    [sym_macro_opener] = ACTIONS(17),
    [sym_declare] = ACTIONS(19),
    [sym_directive] = ACTIONS(21),
    [sym_word] = ACTIONS(21),
    [sym_number] = ACTIONS(21),
    [anon_sym_DQUOTE] = ACTIONS(23),
    [sym_sign] = ACTIONS(21),
    [sym_line_comment] = ACTIONS(3),
    [anon_sym_SLASH_STAR] = ACTIONS(25),
  },
  [12] = {
    [sym__item] = STATE(46),
    [sym_block] = STATE(45),
    [sym_parentheses] = STATE(45),
    [sym_brackets] = STATE(45),
    [sym_conditional] = STATE(45),
    [sym_macro] = STATE(45),
    [sym_declaration] = STATE(45),
    [sym_string] = STATE(45),
    [sym_block_comment] = STATE(12),
    [aux_sym_source_file_repeat1] = STATE(2),
    [anon_sym_LBRACE] = ACTIONS(9),
    [anon_sym_RBRACE] = ACTIONS(118),
    [anon_sym_LPAREN] = ACTIONS(11),
    [anon_sym_LBRACK] = ACTIONS(13),
    [sym_opener] = ACTIONS(15),
    [sym_macro_opener] = ACTIONS(17),
    [sym_declare] = ACTIONS(19),
    [sym_directive] = ACTIONS(21),
    [sym_word] = ACTIONS(21),
    [sym_number] = ACTIONS(21),
    [anon_sym_DQUOTE] = ACTIONS(23),
    [sym_sign] = ACTIONS(21),
    [sym_line_comment] = ACTIONS(3),
    [anon_sym_SLASH_STAR] = ACTIONS(25),
  },
  [13] = {
    [sym__item] = STATE(46),
    [sym_block] = STATE(45),
    [sym_parentheses] = STATE(45),
    [sym_brackets] = STATE(45),
    [sym_conditional] = STATE(45),
    [sym_macro] = STATE(45),
    [sym_declaration] = STATE(45),
    [sym_string] = STATE(45),
    [sym_block_comment] = STATE(13),
    [aux_sym_source_file_repeat1] = STATE(2),
    [anon_sym_LBRACE] = ACTIONS(9),
    [anon_sym_LPAREN] = ACTIONS(11),
    [anon_sym_RPAREN] = ACTIONS(120),
    [anon_sym_LBRACK] = ACTIONS(13),
    [sym_opener] = ACTIONS(15),
    [sym_macro_opener] = ACTIONS(17),
    [sym_declare] = ACTIONS(19),
    [sym_directive] = ACTIONS(21),
    [sym_word] = ACTIONS(21),
    [sym_number] = ACTIONS(21),
    [anon_sym_DQUOTE] = ACTIONS(23),
    [sym_sign] = ACTIONS(21),
    [sym_line_comment] = ACTIONS(3),
    [anon_sym_SLASH_STAR] = ACTIONS(25),
  },
  [14] = {
    [sym__item] = STATE(46),
    [sym_block] = STATE(45),
    [sym_parentheses] = STATE(45),
    [sym_brackets] = STATE(45),
    [sym_conditional] = STATE(45),
    [sym_macro] = STATE(45),
    [sym_declaration] = STATE(45),
    [sym_string] = STATE(45),
    [sym_block_comment] = STATE(14),
    [aux_sym_source_file_repeat1] = STATE(2),
    [anon_sym_LBRACE] = ACTIONS(9),
    [anon_sym_LPAREN] = ACTIONS(11),
    [anon_sym_LBRACK] = ACTIONS(13),
    [anon_sym_RBRACK] = ACTIONS(122),
    [sym_opener] = ACTIONS(15),
    [sym_macro_opener] = ACTIONS(17),
    [sym_declare] = ACTIONS(19),
    [sym_directive] = ACTIONS(21),
    [sym_word] = ACTIONS(21),
    [sym_number] = ACTIONS(21),
    [anon_sym_DQUOTE] = ACTIONS(23),
    [sym_sign] = ACTIONS(21),
    [sym_line_comment] = ACTIONS(3),
    [anon_sym_SLASH_STAR] = ACTIONS(25),
  },
  [15] = {
    [sym__item] = STATE(46),
    [sym_block] = STATE(45),
    [sym_parentheses] = STATE(45),
    [sym_brackets] = STATE(45),
    [sym_conditional] = STATE(45),
    [sym_macro] = STATE(45),
    [sym_declaration] = STATE(45),
    [sym_string] = STATE(45),
    [sym_block_comment] = STATE(15),
    [aux_sym_source_file_repeat1] = STATE(14),
    [anon_sym_LBRACE] = ACTIONS(9),
    [anon_sym_LPAREN] = ACTIONS(11),
    [anon_sym_LBRACK] = ACTIONS(13),
    [anon_sym_RBRACK] = ACTIONS(124),
    [sym_opener] = ACTIONS(15),
    [sym_macro_opener] = ACTIONS(17),
    [sym_declare] = ACTIONS(19),
    [sym_directive] = ACTIONS(21),
    [sym_word] = ACTIONS(21),
    [sym_number] = ACTIONS(21),
    [anon_sym_DQUOTE] = ACTIONS(23),
    [sym_sign] = ACTIONS(21),
    [sym_line_comment] = ACTIONS(3),
    [anon_sym_SLASH_STAR] = ACTIONS(25),
  },
  [16] = {
    [sym__item] = STATE(46),
    [sym_block] = STATE(45),
    [sym_parentheses] = STATE(45),
    [sym_brackets] = STATE(45),
    [sym_conditional] = STATE(45),
    [sym_macro] = STATE(45),
    [sym_declaration] = STATE(45),
    [sym_string] = STATE(45),
    [sym_block_comment] = STATE(16),
    [aux_sym_source_file_repeat1] = STATE(12),
    [anon_sym_LBRACE] = ACTIONS(9),
    [anon_sym_RBRACE] = ACTIONS(126),
    [anon_sym_LPAREN] = ACTIONS(11),
    [anon_sym_LBRACK] = ACTIONS(13),
    [sym_opener] = ACTIONS(15),
    [sym_macro_opener] = ACTIONS(17),
    [sym_declare] = ACTIONS(19),
    [sym_directive] = ACTIONS(21),
    [sym_word] = ACTIONS(21),
    [sym_number] = ACTIONS(21),
    [anon_sym_DQUOTE] = ACTIONS(23),
    [sym_sign] = ACTIONS(21),
    [sym_line_comment] = ACTIONS(3),
    [anon_sym_SLASH_STAR] = ACTIONS(25),
  },
  [17] = {
    [sym__item] = STATE(82),
    [sym_block] = STATE(78),
    [sym_parentheses] = STATE(78),
    [sym_brackets] = STATE(78),
    [sym_conditional] = STATE(78),
    [sym_macro] = STATE(78),
    [sym_declaration] = STATE(78),
    [sym_string] = STATE(78),
    [sym_block_comment] = STATE(17),
    [aux_sym_source_file_repeat1] = STATE(35),
    [anon_sym_LBRACE] = ACTIONS(128),
    [anon_sym_LPAREN] = ACTIONS(130),
    [anon_sym_LBRACK] = ACTIONS(132),
    [sym_opener] = ACTIONS(134),
    [sym_end] = ACTIONS(136),
    [sym_macro_opener] = ACTIONS(138),
    [sym_declare] = ACTIONS(140),
    [sym_directive] = ACTIONS(142),
    [sym_word] = ACTIONS(142),
    [sym_number] = ACTIONS(142),
    [anon_sym_DQUOTE] = ACTIONS(144),
    [sym_sign] = ACTIONS(142),
    [sym_line_comment] = ACTIONS(3),
    [anon_sym_SLASH_STAR] = ACTIONS(25),
  },
  [18] = {
    [sym__item] = STATE(82),
    [sym_block] = STATE(78),
    [sym_parentheses] = STATE(78),
    [sym_brackets] = STATE(78),
    [sym_conditional] = STATE(78),
    [sym_macro] = STATE(78),
    [sym_declaration] = STATE(78),
    [sym_string] = STATE(78),
    [sym_block_comment] = STATE(18),
    [aux_sym_source_file_repeat1] = STATE(18),
    [anon_sym_LBRACE] = ACTIONS(146),
    [anon_sym_LPAREN] = ACTIONS(149),
    [anon_sym_LBRACK] = ACTIONS(152),
    [sym_opener] = ACTIONS(155),
    [sym_end] = ACTIONS(32),
    [sym_macro_opener] = ACTIONS(158),
    [sym_declare] = ACTIONS(161),
    [sym_directive] = ACTIONS(164),
    [sym_word] = ACTIONS(164),
    [sym_number] = ACTIONS(164),
    [anon_sym_DQUOTE] = ACTIONS(167),
    [sym_sign] = ACTIONS(164),
    [sym_line_comment] = ACTIONS(3),
    [anon_sym_SLASH_STAR] = ACTIONS(25),
  },
  [19] = {
    [sym__item] = STATE(46),
    [sym_block] = STATE(45),
    [sym_parentheses] = STATE(45),
    [sym_brackets] = STATE(45),
    [sym_conditional] = STATE(45),
    [sym_macro] = STATE(45),
    [sym_declaration] = STATE(45),
    [sym_string] = STATE(45),
    [sym_block_comment] = STATE(19),
    [aux_sym_source_file_repeat1] = STATE(22),
    [anon_sym_LBRACE] = ACTIONS(9),
    [anon_sym_RBRACE] = ACTIONS(170),
    [anon_sym_LPAREN] = ACTIONS(11),
    [anon_sym_LBRACK] = ACTIONS(13),
    [sym_opener] = ACTIONS(15),
    [sym_macro_opener] = ACTIONS(17),
    [sym_declare] = ACTIONS(19),
    [sym_directive] = ACTIONS(21),
    [sym_word] = ACTIONS(21),
    [sym_number] = ACTIONS(21),
    [anon_sym_DQUOTE] = ACTIONS(23),
    [sym_sign] = ACTIONS(21),
    [sym_line_comment] = ACTIONS(3),
    [anon_sym_SLASH_STAR] = ACTIONS(25),
  },
  [20] = {
    [sym__item] = STATE(46),
    [sym_block] = STATE(45),
    [sym_parentheses] = STATE(45),
    [sym_brackets] = STATE(45),
    [sym_conditional] = STATE(45),
    [sym_macro] = STATE(45),
    [sym_declaration] = STATE(45),
    [sym_string] = STATE(45),
    [sym_block_comment] = STATE(20),
    [aux_sym_source_file_repeat1] = STATE(23),
    [anon_sym_LBRACE] = ACTIONS(9),
    [anon_sym_LPAREN] = ACTIONS(11),
    [anon_sym_RPAREN] = ACTIONS(172),
    [anon_sym_LBRACK] = ACTIONS(13),
    [sym_opener] = ACTIONS(15),
    [sym_macro_opener] = ACTIONS(17),
    [sym_declare] = ACTIONS(19),
    [sym_directive] = ACTIONS(21),
    [sym_word] = ACTIONS(21),
    [sym_number] = ACTIONS(21),
    [anon_sym_DQUOTE] = ACTIONS(23),
    [sym_sign] = ACTIONS(21),
    [sym_line_comment] = ACTIONS(3),
    [anon_sym_SLASH_STAR] = ACTIONS(25),
  },
  [21] = {
    [sym__item] = STATE(46),
    [sym_block] = STATE(45),
    [sym_parentheses] = STATE(45),
    [sym_brackets] = STATE(45),
    [sym_conditional] = STATE(45),
    [sym_macro] = STATE(45),
    [sym_declaration] = STATE(45),
    [sym_string] = STATE(45),
    [sym_block_comment] = STATE(21),
    [aux_sym_source_file_repeat1] = STATE(24),
    [anon_sym_LBRACE] = ACTIONS(9),
    [anon_sym_LPAREN] = ACTIONS(11),
    [anon_sym_LBRACK] = ACTIONS(13),
    [anon_sym_RBRACK] = ACTIONS(174),
    [sym_opener] = ACTIONS(15),
    [sym_macro_opener] = ACTIONS(17),
    [sym_declare] = ACTIONS(19),
    [sym_directive] = ACTIONS(21),
    [sym_word] = ACTIONS(21),
    [sym_number] = ACTIONS(21),
    [anon_sym_DQUOTE] = ACTIONS(23),
    [sym_sign] = ACTIONS(21),
    [sym_line_comment] = ACTIONS(3),
    [anon_sym_SLASH_STAR] = ACTIONS(25),
  },
  [22] = {
    [sym__item] = STATE(46),
    [sym_block] = STATE(45),
    [sym_parentheses] = STATE(45),
    [sym_brackets] = STATE(45),
    [sym_conditional] = STATE(45),
    [sym_macro] = STATE(45),
    [sym_declaration] = STATE(45),
    [sym_string] = STATE(45),
    [sym_block_comment] = STATE(22),
    [aux_sym_source_file_repeat1] = STATE(2),
    [anon_sym_LBRACE] = ACTIONS(9),
    [anon_sym_RBRACE] = ACTIONS(176),
    [anon_sym_LPAREN] = ACTIONS(11),
    [anon_sym_LBRACK] = ACTIONS(13),
    [sym_opener] = ACTIONS(15),
    [sym_macro_opener] = ACTIONS(17),
    [sym_declare] = ACTIONS(19),
    [sym_directive] = ACTIONS(21),
    [sym_word] = ACTIONS(21),
    [sym_number] = ACTIONS(21),
    [anon_sym_DQUOTE] = ACTIONS(23),
    [sym_sign] = ACTIONS(21),
    [sym_line_comment] = ACTIONS(3),
    [anon_sym_SLASH_STAR] = ACTIONS(25),
  },
  [23] = {
    [sym__item] = STATE(46),
    [sym_block] = STATE(45),
    [sym_parentheses] = STATE(45),
    [sym_brackets] = STATE(45),
    [sym_conditional] = STATE(45),
    [sym_macro] = STATE(45),
    [sym_declaration] = STATE(45),
    [sym_string] = STATE(45),
    [sym_block_comment] = STATE(23),
    [aux_sym_source_file_repeat1] = STATE(2),
    [anon_sym_LBRACE] = ACTIONS(9),
    [anon_sym_LPAREN] = ACTIONS(11),
    [anon_sym_RPAREN] = ACTIONS(178),
    [anon_sym_LBRACK] = ACTIONS(13),
    [sym_opener] = ACTIONS(15),
    [sym_macro_opener] = ACTIONS(17),
    [sym_declare] = ACTIONS(19),
    [sym_directive] = ACTIONS(21),
    [sym_word] = ACTIONS(21),
    [sym_number] = ACTIONS(21),
    [anon_sym_DQUOTE] = ACTIONS(23),
    [sym_sign] = ACTIONS(21),
    [sym_line_comment] = ACTIONS(3),
    [anon_sym_SLASH_STAR] = ACTIONS(25),
  },
  [24] = {
    [sym__item] = STATE(46),
    [sym_block] = STATE(45),
    [sym_parentheses] = STATE(45),
    [sym_brackets] = STATE(45),
    [sym_conditional] = STATE(45),
    [sym_macro] = STATE(45),
    [sym_declaration] = STATE(45),
    [sym_string] = STATE(45),
    [sym_block_comment] = STATE(24),
    [aux_sym_source_file_repeat1] = STATE(2),
    [anon_sym_LBRACE] = ACTIONS(9),
    [anon_sym_LPAREN] = ACTIONS(11),
    [anon_sym_LBRACK] = ACTIONS(13),
    [anon_sym_RBRACK] = ACTIONS(180),
    [sym_opener] = ACTIONS(15),
    [sym_macro_opener] = ACTIONS(17),
    [sym_declare] = ACTIONS(19),
    [sym_directive] = ACTIONS(21),
    [sym_word] = ACTIONS(21),
    [sym_number] = ACTIONS(21),
    [anon_sym_DQUOTE] = ACTIONS(23),
    [sym_sign] = ACTIONS(21),
    [sym_line_comment] = ACTIONS(3),
    [anon_sym_SLASH_STAR] = ACTIONS(25),
  },
  [25] = {
    [sym__item] = STATE(82),
    [sym_block] = STATE(78),
    [sym_parentheses] = STATE(78),
    [sym_brackets] = STATE(78),
    [sym_conditional] = STATE(78),
    [sym_macro] = STATE(78),
    [sym_declaration] = STATE(78),
    [sym_string] = STATE(78),
    [sym_block_comment] = STATE(25),
    [aux_sym_source_file_repeat1] = STATE(26),
    [anon_sym_LBRACE] = ACTIONS(128),
    [anon_sym_LPAREN] = ACTIONS(130),
    [anon_sym_LBRACK] = ACTIONS(132),
    [sym_opener] = ACTIONS(134),
    [sym_end] = ACTIONS(182),
    [sym_macro_opener] = ACTIONS(138),
    [sym_declare] = ACTIONS(140),
    [sym_directive] = ACTIONS(142),
    [sym_word] = ACTIONS(142),
    [sym_number] = ACTIONS(142),
    [anon_sym_DQUOTE] = ACTIONS(144),
    [sym_sign] = ACTIONS(142),
    [sym_line_comment] = ACTIONS(3),
    [anon_sym_SLASH_STAR] = ACTIONS(25),
  },
  [26] = {
    [sym__item] = STATE(82),
    [sym_block] = STATE(78),
    [sym_parentheses] = STATE(78),
    [sym_brackets] = STATE(78),
    [sym_conditional] = STATE(78),
    [sym_macro] = STATE(78),
    [sym_declaration] = STATE(78),
    [sym_string] = STATE(78),
    [sym_block_comment] = STATE(26),
    [aux_sym_source_file_repeat1] = STATE(18),
    [anon_sym_LBRACE] = ACTIONS(128),
    [anon_sym_LPAREN] = ACTIONS(130),
    [anon_sym_LBRACK] = ACTIONS(132),
    [sym_opener] = ACTIONS(134),
    [sym_end] = ACTIONS(184),
    [sym_macro_opener] = ACTIONS(138),
    [sym_declare] = ACTIONS(140),
    [sym_directive] = ACTIONS(142),
    [sym_word] = ACTIONS(142),
    [sym_number] = ACTIONS(142),
    [anon_sym_DQUOTE] = ACTIONS(144),
    [sym_sign] = ACTIONS(142),
    [sym_line_comment] = ACTIONS(3),
    [anon_sym_SLASH_STAR] = ACTIONS(25),
  },
  [27] = {
    [sym__item] = STATE(46),
    [sym_block] = STATE(45),
    [sym_parentheses] = STATE(45),
    [sym_brackets] = STATE(45),
    [sym_conditional] = STATE(45),
    [sym_macro] = STATE(45),
    [sym_declaration] = STATE(45),
    [sym_string] = STATE(45),
    [sym_block_comment] = STATE(27),
    [aux_sym_source_file_repeat1] = STATE(30),
    [anon_sym_LBRACE] = ACTIONS(9),
    [anon_sym_RBRACE] = ACTIONS(186),
    [anon_sym_LPAREN] = ACTIONS(11),
    [anon_sym_LBRACK] = ACTIONS(13),
    [sym_opener] = ACTIONS(15),
    [sym_macro_opener] = ACTIONS(17),
    [sym_declare] = ACTIONS(19),
    [sym_directive] = ACTIONS(21),
    [sym_word] = ACTIONS(21),
    [sym_number] = ACTIONS(21),
    [anon_sym_DQUOTE] = ACTIONS(23),
    [sym_sign] = ACTIONS(21),
    [sym_line_comment] = ACTIONS(3),
    [anon_sym_SLASH_STAR] = ACTIONS(25),
  },
  [28] = {
    [sym__item] = STATE(46),
    [sym_block] = STATE(45),
    [sym_parentheses] = STATE(45),
    [sym_brackets] = STATE(45),
    [sym_conditional] = STATE(45),
    [sym_macro] = STATE(45),
    [sym_declaration] = STATE(45),
    [sym_string] = STATE(45),
    [sym_block_comment] = STATE(28),
    [aux_sym_source_file_repeat1] = STATE(31),
    [anon_sym_LBRACE] = ACTIONS(9),
    [anon_sym_LPAREN] = ACTIONS(11),
    [anon_sym_RPAREN] = ACTIONS(188),
    [anon_sym_LBRACK] = ACTIONS(13),
    [sym_opener] = ACTIONS(15),
    [sym_macro_opener] = ACTIONS(17),
    [sym_declare] = ACTIONS(19),
    [sym_directive] = ACTIONS(21),
    [sym_word] = ACTIONS(21),
    [sym_number] = ACTIONS(21),
    [anon_sym_DQUOTE] = ACTIONS(23),
    [sym_sign] = ACTIONS(21),
    [sym_line_comment] = ACTIONS(3),
    [anon_sym_SLASH_STAR] = ACTIONS(25),
  },
  [29] = {
    [sym__item] = STATE(46),
    [sym_block] = STATE(45),
    [sym_parentheses] = STATE(45),
    [sym_brackets] = STATE(45),
    [sym_conditional] = STATE(45),
    [sym_macro] = STATE(45),
    [sym_declaration] = STATE(45),
    [sym_string] = STATE(45),
    [sym_block_comment] = STATE(29),
    [aux_sym_source_file_repeat1] = STATE(32),
    [anon_sym_LBRACE] = ACTIONS(9),
    [anon_sym_LPAREN] = ACTIONS(11),
    [anon_sym_LBRACK] = ACTIONS(13),
    [anon_sym_RBRACK] = ACTIONS(190),
    [sym_opener] = ACTIONS(15),
    [sym_macro_opener] = ACTIONS(17),
    [sym_declare] = ACTIONS(19),
    [sym_directive] = ACTIONS(21),
    [sym_word] = ACTIONS(21),
    [sym_number] = ACTIONS(21),
    [anon_sym_DQUOTE] = ACTIONS(23),
    [sym_sign] = ACTIONS(21),
    [sym_line_comment] = ACTIONS(3),
    [anon_sym_SLASH_STAR] = ACTIONS(25),
  },
  [30] = {
    [sym__item] = STATE(46),
    [sym_block] = STATE(45),
    [sym_parentheses] = STATE(45),
    [sym_brackets] = STATE(45),
    [sym_conditional] = STATE(45),
    [sym_macro] = STATE(45),
    [sym_declaration] = STATE(45),
    [sym_string] = STATE(45),
    [sym_block_comment] = STATE(30),
    [aux_sym_source_file_repeat1] = STATE(2),
    [anon_sym_LBRACE] = ACTIONS(9),
    [anon_sym_RBRACE] = ACTIONS(192),
    [anon_sym_LPAREN] = ACTIONS(11),
    [anon_sym_LBRACK] = ACTIONS(13),
    [sym_opener] = ACTIONS(15),
    [sym_macro_opener] = ACTIONS(17),
    [sym_declare] = ACTIONS(19),
    [sym_directive] = ACTIONS(21),
    [sym_word] = ACTIONS(21),
    [sym_number] = ACTIONS(21),
    [anon_sym_DQUOTE] = ACTIONS(23),
    [sym_sign] = ACTIONS(21),
    [sym_line_comment] = ACTIONS(3),
    [anon_sym_SLASH_STAR] = ACTIONS(25),
  },
  [31] = {
    [sym__item] = STATE(46),
    [sym_block] = STATE(45),
    [sym_parentheses] = STATE(45),
    [sym_brackets] = STATE(45),
    [sym_conditional] = STATE(45),
    [sym_macro] = STATE(45),
    [sym_declaration] = STATE(45),
    [sym_string] = STATE(45),
    [sym_block_comment] = STATE(31),
    [aux_sym_source_file_repeat1] = STATE(2),
    [anon_sym_LBRACE] = ACTIONS(9),
    [anon_sym_LPAREN] = ACTIONS(11),
    [anon_sym_RPAREN] = ACTIONS(194),
    [anon_sym_LBRACK] = ACTIONS(13),
    [sym_opener] = ACTIONS(15),
    [sym_macro_opener] = ACTIONS(17),
    [sym_declare] = ACTIONS(19),
    [sym_directive] = ACTIONS(21),
    [sym_word] = ACTIONS(21),
    [sym_number] = ACTIONS(21),
    [anon_sym_DQUOTE] = ACTIONS(23),
    [sym_sign] = ACTIONS(21),
    [sym_line_comment] = ACTIONS(3),
    [anon_sym_SLASH_STAR] = ACTIONS(25),
  },
  [32] = {
    [sym__item] = STATE(46),
    [sym_block] = STATE(45),
    [sym_parentheses] = STATE(45),
    [sym_brackets] = STATE(45),
    [sym_conditional] = STATE(45),
    [sym_macro] = STATE(45),
    [sym_declaration] = STATE(45),
    [sym_string] = STATE(45),
    [sym_block_comment] = STATE(32),
    [aux_sym_source_file_repeat1] = STATE(2),
    [anon_sym_LBRACE] = ACTIONS(9),
    [anon_sym_LPAREN] = ACTIONS(11),
    [anon_sym_LBRACK] = ACTIONS(13),
    [anon_sym_RBRACK] = ACTIONS(196),
    [sym_opener] = ACTIONS(15),
    [sym_macro_opener] = ACTIONS(17),
    [sym_declare] = ACTIONS(19),
    [sym_directive] = ACTIONS(21),
    [sym_word] = ACTIONS(21),
    [sym_number] = ACTIONS(21),
    [anon_sym_DQUOTE] = ACTIONS(23),
    [sym_sign] = ACTIONS(21),
    [sym_line_comment] = ACTIONS(3),
    [anon_sym_SLASH_STAR] = ACTIONS(25),
  },
  [33] = {
    [sym__item] = STATE(82),
    [sym_block] = STATE(78),
    [sym_parentheses] = STATE(78),
    [sym_brackets] = STATE(78),
    [sym_conditional] = STATE(78),
    [sym_macro] = STATE(78),
    [sym_declaration] = STATE(78),
    [sym_string] = STATE(78),
    [sym_block_comment] = STATE(33),
    [aux_sym_source_file_repeat1] = STATE(34),
    [anon_sym_LBRACE] = ACTIONS(128),
    [anon_sym_LPAREN] = ACTIONS(130),
    [anon_sym_LBRACK] = ACTIONS(132),
    [sym_opener] = ACTIONS(134),
    [sym_end] = ACTIONS(198),
    [sym_macro_opener] = ACTIONS(138),
    [sym_declare] = ACTIONS(140),
    [sym_directive] = ACTIONS(142),
    [sym_word] = ACTIONS(142),
    [sym_number] = ACTIONS(142),
    [anon_sym_DQUOTE] = ACTIONS(144),
    [sym_sign] = ACTIONS(142),
    [sym_line_comment] = ACTIONS(3),
    [anon_sym_SLASH_STAR] = ACTIONS(25),
  },
  [34] = {
    [sym__item] = STATE(82),
    [sym_block] = STATE(78),
    [sym_parentheses] = STATE(78),
    [sym_brackets] = STATE(78),
    [sym_conditional] = STATE(78),
    [sym_macro] = STATE(78),
    [sym_declaration] = STATE(78),
    [sym_string] = STATE(78),
    [sym_block_comment] = STATE(34),
    [aux_sym_source_file_repeat1] = STATE(18),
    [anon_sym_LBRACE] = ACTIONS(128),
    [anon_sym_LPAREN] = ACTIONS(130),
    [anon_sym_LBRACK] = ACTIONS(132),
    [sym_opener] = ACTIONS(134),
    [sym_end] = ACTIONS(200),
    [sym_macro_opener] = ACTIONS(138),
    [sym_declare] = ACTIONS(140),
    [sym_directive] = ACTIONS(142),
    [sym_word] = ACTIONS(142),
    [sym_number] = ACTIONS(142),
    [anon_sym_DQUOTE] = ACTIONS(144),
    [sym_sign] = ACTIONS(142),
    [sym_line_comment] = ACTIONS(3),
    [anon_sym_SLASH_STAR] = ACTIONS(25),
  },
  [35] = {
    [sym__item] = STATE(82),
    [sym_block] = STATE(78),
    [sym_parentheses] = STATE(78),
    [sym_brackets] = STATE(78),
    [sym_conditional] = STATE(78),
    [sym_macro] = STATE(78),
    [sym_declaration] = STATE(78),
    [sym_string] = STATE(78),
    [sym_block_comment] = STATE(35),
    [aux_sym_source_file_repeat1] = STATE(18),
    [anon_sym_LBRACE] = ACTIONS(128),
    [anon_sym_LPAREN] = ACTIONS(130),
    [anon_sym_LBRACK] = ACTIONS(132),
    [sym_opener] = ACTIONS(134),
    [sym_end] = ACTIONS(202),
    [sym_macro_opener] = ACTIONS(138),
    [sym_declare] = ACTIONS(140),
    [sym_directive] = ACTIONS(142),
    [sym_word] = ACTIONS(142),
    [sym_number] = ACTIONS(142),
    [anon_sym_DQUOTE] = ACTIONS(144),
    [sym_sign] = ACTIONS(142),
    [sym_line_comment] = ACTIONS(3),
    [anon_sym_SLASH_STAR] = ACTIONS(25),
  },
};

static const uint16_t ts_small_parse_table[] = {
  [0] = 5,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    ACTIONS(204), 1,
      ts_builtin_sym_end,
    STATE(36), 1,
      sym_block_comment,
    ACTIONS(206), 14,
      anon_sym_LBRACE,
      anon_sym_RBRACE,
      anon_sym_LPAREN,
      anon_sym_RPAREN,
      anon_sym_LBRACK,
      anon_sym_RBRACK,
      sym_opener,
      sym_macro_opener,
      sym_declare,
      sym_directive,
      sym_word,
      sym_number,
      anon_sym_DQUOTE,
      sym_sign,
  [29] = 5,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    ACTIONS(208), 1,
      ts_builtin_sym_end,
    STATE(37), 1,
      sym_block_comment,
    ACTIONS(210), 14,
      anon_sym_LBRACE,
      anon_sym_RBRACE,
      anon_sym_LPAREN,
      anon_sym_RPAREN,
      anon_sym_LBRACK,
      anon_sym_RBRACK,
      sym_opener,
      sym_macro_opener,
      sym_declare,
      sym_directive,
      sym_word,
      sym_number,
      anon_sym_DQUOTE,
      sym_sign,
  [58] = 5,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    ACTIONS(212), 1,
      ts_builtin_sym_end,
    STATE(38), 1,
      sym_block_comment,
    ACTIONS(214), 14,
      anon_sym_LBRACE,
      anon_sym_RBRACE,
      anon_sym_LPAREN,
      anon_sym_RPAREN,
      anon_sym_LBRACK,
      anon_sym_RBRACK,
      sym_opener,
      sym_macro_opener,
      sym_declare,
      sym_directive,
      sym_word,
      sym_number,
      anon_sym_DQUOTE,
      sym_sign,
  [87] = 5,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    ACTIONS(216), 1,
      ts_builtin_sym_end,
    STATE(39), 1,
      sym_block_comment,
    ACTIONS(218), 14,
      anon_sym_LBRACE,
      anon_sym_RBRACE,
      anon_sym_LPAREN,
      anon_sym_RPAREN,
      anon_sym_LBRACK,
      anon_sym_RBRACK,
      sym_opener,
      sym_macro_opener,
      sym_declare,
      sym_directive,
      sym_word,
      sym_number,
      anon_sym_DQUOTE,
      sym_sign,
  [116] = 5,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    ACTIONS(220), 1,
      ts_builtin_sym_end,
    STATE(40), 1,
      sym_block_comment,
    ACTIONS(222), 14,
      anon_sym_LBRACE,
      anon_sym_RBRACE,
      anon_sym_LPAREN,
      anon_sym_RPAREN,
      anon_sym_LBRACK,
      anon_sym_RBRACK,
      sym_opener,
      sym_macro_opener,
      sym_declare,
      sym_directive,
      sym_word,
      sym_number,
      anon_sym_DQUOTE,
      sym_sign,
  [145] = 5,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    ACTIONS(224), 1,
      ts_builtin_sym_end,
    STATE(41), 1,
      sym_block_comment,
    ACTIONS(226), 14,
      anon_sym_LBRACE,
      anon_sym_RBRACE,
      anon_sym_LPAREN,
      anon_sym_RPAREN,
      anon_sym_LBRACK,
      anon_sym_RBRACK,
      sym_opener,
      sym_macro_opener,
      sym_declare,
      sym_directive,
      sym_word,
      sym_number,
      anon_sym_DQUOTE,
      sym_sign,
  [174] = 5,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    ACTIONS(228), 1,
      ts_builtin_sym_end,
    STATE(42), 1,
      sym_block_comment,
    ACTIONS(230), 14,
      anon_sym_LBRACE,
      anon_sym_RBRACE,
      anon_sym_LPAREN,
      anon_sym_RPAREN,
      anon_sym_LBRACK,
      anon_sym_RBRACK,
      sym_opener,
      sym_macro_opener,
      sym_declare,
      sym_directive,
      sym_word,
      sym_number,
      anon_sym_DQUOTE,
      sym_sign,
  [203] = 5,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    ACTIONS(232), 1,
      ts_builtin_sym_end,
    STATE(43), 1,
      sym_block_comment,
    ACTIONS(234), 14,
      anon_sym_LBRACE,
      anon_sym_RBRACE,
      anon_sym_LPAREN,
      anon_sym_RPAREN,
      anon_sym_LBRACK,
      anon_sym_RBRACK,
      sym_opener,
      sym_macro_opener,
      sym_declare,
      sym_directive,
      sym_word,
      sym_number,
      anon_sym_DQUOTE,
      sym_sign,
  [232] = 5,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    ACTIONS(236), 1,
      ts_builtin_sym_end,
    STATE(44), 1,
      sym_block_comment,
    ACTIONS(238), 14,
      anon_sym_LBRACE,
      anon_sym_RBRACE,
      anon_sym_LPAREN,
      anon_sym_RPAREN,
      anon_sym_LBRACK,
      anon_sym_RBRACK,
      sym_opener,
      sym_macro_opener,
      sym_declare,
      sym_directive,
      sym_word,
      sym_number,
      anon_sym_DQUOTE,
      sym_sign,
  [261] = 5,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    ACTIONS(240), 1,
      ts_builtin_sym_end,
    STATE(45), 1,
      sym_block_comment,
    ACTIONS(242), 14,
      anon_sym_LBRACE,
      anon_sym_RBRACE,
      anon_sym_LPAREN,
      anon_sym_RPAREN,
      anon_sym_LBRACK,
      anon_sym_RBRACK,
      sym_opener,
      sym_macro_opener,
      sym_declare,
      sym_directive,
      sym_word,
      sym_number,
      anon_sym_DQUOTE,
      sym_sign,
  [290] = 5,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    ACTIONS(244), 1,
      ts_builtin_sym_end,
    STATE(46), 1,
      sym_block_comment,
    ACTIONS(246), 14,
      anon_sym_LBRACE,
      anon_sym_RBRACE,
      anon_sym_LPAREN,
      anon_sym_RPAREN,
      anon_sym_LBRACK,
      anon_sym_RBRACK,
      sym_opener,
      sym_macro_opener,
      sym_declare,
      sym_directive,
      sym_word,
      sym_number,
      anon_sym_DQUOTE,
      sym_sign,
  [319] = 5,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    ACTIONS(248), 1,
      ts_builtin_sym_end,
    STATE(47), 1,
      sym_block_comment,
    ACTIONS(250), 14,
      anon_sym_LBRACE,
      anon_sym_RBRACE,
      anon_sym_LPAREN,
      anon_sym_RPAREN,
      anon_sym_LBRACK,
      anon_sym_RBRACK,
      sym_opener,
      sym_macro_opener,
      sym_declare,
      sym_directive,
      sym_word,
      sym_number,
      anon_sym_DQUOTE,
      sym_sign,
  [348] = 5,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    ACTIONS(252), 1,
      ts_builtin_sym_end,
    STATE(48), 1,
      sym_block_comment,
    ACTIONS(254), 14,
      anon_sym_LBRACE,
      anon_sym_RBRACE,
      anon_sym_LPAREN,
      anon_sym_RPAREN,
      anon_sym_LBRACK,
      anon_sym_RBRACK,
      sym_opener,
      sym_macro_opener,
      sym_declare,
      sym_directive,
      sym_word,
      sym_number,
      anon_sym_DQUOTE,
      sym_sign,
  [377] = 5,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    ACTIONS(256), 1,
      ts_builtin_sym_end,
    STATE(49), 1,
      sym_block_comment,
    ACTIONS(258), 14,
      anon_sym_LBRACE,
      anon_sym_RBRACE,
      anon_sym_LPAREN,
      anon_sym_RPAREN,
      anon_sym_LBRACK,
      anon_sym_RBRACK,
      sym_opener,
      sym_macro_opener,
      sym_declare,
      sym_directive,
      sym_word,
      sym_number,
      anon_sym_DQUOTE,
      sym_sign,
  [406] = 5,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    ACTIONS(260), 1,
      ts_builtin_sym_end,
    STATE(50), 1,
      sym_block_comment,
    ACTIONS(262), 14,
      anon_sym_LBRACE,
      anon_sym_RBRACE,
      anon_sym_LPAREN,
      anon_sym_RPAREN,
      anon_sym_LBRACK,
      anon_sym_RBRACK,
      sym_opener,
      sym_macro_opener,
      sym_declare,
      sym_directive,
      sym_word,
      sym_number,
      anon_sym_DQUOTE,
      sym_sign,
  [435] = 4,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    STATE(51), 1,
      sym_block_comment,
    ACTIONS(238), 13,
      anon_sym_LBRACE,
      anon_sym_LPAREN,
      anon_sym_LBRACK,
      sym_opener,
      sym_middle,
      sym_end,
      sym_macro_opener,
      sym_declare,
      sym_directive,
      sym_word,
      sym_number,
      anon_sym_DQUOTE,
      sym_sign,
  [460] = 4,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    STATE(52), 1,
      sym_block_comment,
    ACTIONS(230), 13,
      anon_sym_LBRACE,
      anon_sym_LPAREN,
      anon_sym_LBRACK,
      sym_opener,
      sym_middle,
      sym_end,
      sym_macro_opener,
      sym_declare,
      sym_directive,
      sym_word,
      sym_number,
      anon_sym_DQUOTE,
      sym_sign,
  [485] = 4,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    STATE(53), 1,
      sym_block_comment,
    ACTIONS(226), 13,
      anon_sym_LBRACE,
      anon_sym_LPAREN,
      anon_sym_LBRACK,
      sym_opener,
      sym_middle,
      sym_end,
      sym_macro_opener,
      sym_declare,
      sym_directive,
      sym_word,
      sym_number,
      anon_sym_DQUOTE,
      sym_sign,
  [510] = 4,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    STATE(54), 1,
      sym_block_comment,
    ACTIONS(254), 13,
      anon_sym_LBRACE,
      anon_sym_LPAREN,
      anon_sym_LBRACK,
      sym_opener,
      sym_middle,
      sym_end,
      sym_macro_opener,
      sym_declare,
      sym_directive,
      sym_word,
      sym_number,
      anon_sym_DQUOTE,
      sym_sign,
  [535] = 4,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    STATE(55), 1,
      sym_block_comment,
    ACTIONS(258), 13,
      anon_sym_LBRACE,
      anon_sym_LPAREN,
      anon_sym_LBRACK,
      sym_opener,
      sym_middle,
      sym_end,
      sym_macro_opener,
      sym_declare,
      sym_directive,
      sym_word,
      sym_number,
      anon_sym_DQUOTE,
      sym_sign,
  [560] = 4,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    STATE(56), 1,
      sym_block_comment,
    ACTIONS(262), 13,
      anon_sym_LBRACE,
      anon_sym_LPAREN,
      anon_sym_LBRACK,
      sym_opener,
      sym_middle,
      sym_end,
      sym_macro_opener,
      sym_declare,
      sym_directive,
      sym_word,
      sym_number,
      anon_sym_DQUOTE,
      sym_sign,
  [585] = 4,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    STATE(57), 1,
      sym_block_comment,
    ACTIONS(210), 13,
      anon_sym_LBRACE,
      anon_sym_LPAREN,
      anon_sym_LBRACK,
      sym_opener,
      sym_middle,
      sym_end,
      sym_macro_opener,
      sym_declare,
      sym_directive,
      sym_word,
      sym_number,
      anon_sym_DQUOTE,
      sym_sign,
  [610] = 4,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    STATE(58), 1,
      sym_block_comment,
    ACTIONS(214), 13,
      anon_sym_LBRACE,
      anon_sym_LPAREN,
      anon_sym_LBRACK,
      sym_opener,
      sym_middle,
      sym_end,
      sym_macro_opener,
      sym_declare,
      sym_directive,
      sym_word,
      sym_number,
      anon_sym_DQUOTE,
      sym_sign,
  [635] = 4,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    STATE(59), 1,
      sym_block_comment,
    ACTIONS(218), 13,
      anon_sym_LBRACE,
      anon_sym_LPAREN,
      anon_sym_LBRACK,
      sym_opener,
      sym_middle,
      sym_end,
      sym_macro_opener,
      sym_declare,
      sym_directive,
      sym_word,
      sym_number,
      anon_sym_DQUOTE,
      sym_sign,
  [660] = 4,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    STATE(60), 1,
      sym_block_comment,
    ACTIONS(222), 13,
      anon_sym_LBRACE,
      anon_sym_LPAREN,
      anon_sym_LBRACK,
      sym_opener,
      sym_middle,
      sym_end,
      sym_macro_opener,
      sym_declare,
      sym_directive,
      sym_word,
      sym_number,
      anon_sym_DQUOTE,
      sym_sign,
  [685] = 4,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    STATE(61), 1,
      sym_block_comment,
    ACTIONS(234), 13,
      anon_sym_LBRACE,
      anon_sym_LPAREN,
      anon_sym_LBRACK,
      sym_opener,
      sym_middle,
      sym_end,
      sym_macro_opener,
      sym_declare,
      sym_directive,
      sym_word,
      sym_number,
      anon_sym_DQUOTE,
      sym_sign,
  [710] = 4,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    STATE(62), 1,
      sym_block_comment,
    ACTIONS(250), 13,
      anon_sym_LBRACE,
      anon_sym_LPAREN,
      anon_sym_LBRACK,
      sym_opener,
      sym_middle,
      sym_end,
      sym_macro_opener,
      sym_declare,
      sym_directive,
      sym_word,
      sym_number,
      anon_sym_DQUOTE,
      sym_sign,
  [735] = 4,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    STATE(63), 1,
      sym_block_comment,
    ACTIONS(264), 13,
      anon_sym_LBRACE,
      anon_sym_LPAREN,
      anon_sym_LBRACK,
      sym_opener,
      sym_middle,
      sym_end,
      sym_macro_opener,
      sym_declare,
      sym_directive,
      sym_word,
      sym_number,
      anon_sym_DQUOTE,
      sym_sign,
  [760] = 4,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    STATE(64), 1,
      sym_block_comment,
    ACTIONS(206), 13,
      anon_sym_LBRACE,
      anon_sym_LPAREN,
      anon_sym_LBRACK,
      sym_opener,
      sym_middle,
      sym_end,
      sym_macro_opener,
      sym_declare,
      sym_directive,
      sym_word,
      sym_number,
      anon_sym_DQUOTE,
      sym_sign,
  [785] = 4,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    STATE(65), 1,
      sym_block_comment,
    ACTIONS(242), 13,
      anon_sym_LBRACE,
      anon_sym_LPAREN,
      anon_sym_LBRACK,
      sym_opener,
      sym_middle,
      sym_end,
      sym_macro_opener,
      sym_declare,
      sym_directive,
      sym_word,
      sym_number,
      anon_sym_DQUOTE,
      sym_sign,
  [810] = 4,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    STATE(66), 1,
      sym_block_comment,
    ACTIONS(266), 12,
      anon_sym_LBRACE,
      anon_sym_LPAREN,
      anon_sym_LBRACK,
      sym_opener,
      sym_end,
      sym_macro_opener,
      sym_declare,
      sym_directive,
      sym_word,
      sym_number,
      anon_sym_DQUOTE,
      sym_sign,
  [834] = 4,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    STATE(67), 1,
      sym_block_comment,
    ACTIONS(226), 12,
      anon_sym_LBRACE,
      anon_sym_LPAREN,
      anon_sym_LBRACK,
      sym_opener,
      sym_end,
      sym_macro_opener,
      sym_declare,
      sym_directive,
      sym_word,
      sym_number,
      anon_sym_DQUOTE,
      sym_sign,
  [858] = 4,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    STATE(68), 1,
      sym_block_comment,
    ACTIONS(254), 12,
      anon_sym_LBRACE,
      anon_sym_LPAREN,
      anon_sym_LBRACK,
      sym_opener,
      sym_end,
      sym_macro_opener,
      sym_declare,
      sym_directive,
      sym_word,
      sym_number,
      anon_sym_DQUOTE,
      sym_sign,
  [882] = 4,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    STATE(69), 1,
      sym_block_comment,
    ACTIONS(258), 12,
      anon_sym_LBRACE,
      anon_sym_LPAREN,
      anon_sym_LBRACK,
      sym_opener,
      sym_end,
      sym_macro_opener,
      sym_declare,
      sym_directive,
      sym_word,
      sym_number,
      anon_sym_DQUOTE,
      sym_sign,
  [906] = 4,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    STATE(70), 1,
      sym_block_comment,
    ACTIONS(262), 12,
      anon_sym_LBRACE,
      anon_sym_LPAREN,
      anon_sym_LBRACK,
      sym_opener,
      sym_end,
      sym_macro_opener,
      sym_declare,
      sym_directive,
      sym_word,
      sym_number,
      anon_sym_DQUOTE,
      sym_sign,
  [930] = 4,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    STATE(71), 1,
      sym_block_comment,
    ACTIONS(210), 12,
      anon_sym_LBRACE,
      anon_sym_LPAREN,
      anon_sym_LBRACK,
      sym_opener,
      sym_end,
      sym_macro_opener,
      sym_declare,
      sym_directive,
      sym_word,
      sym_number,
      anon_sym_DQUOTE,
      sym_sign,
  [954] = 4,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    STATE(72), 1,
      sym_block_comment,
    ACTIONS(214), 12,
      anon_sym_LBRACE,
      anon_sym_LPAREN,
      anon_sym_LBRACK,
      sym_opener,
      sym_end,
      sym_macro_opener,
      sym_declare,
      sym_directive,
      sym_word,
      sym_number,
      anon_sym_DQUOTE,
      sym_sign,
  [978] = 4,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    STATE(73), 1,
      sym_block_comment,
    ACTIONS(218), 12,
      anon_sym_LBRACE,
      anon_sym_LPAREN,
      anon_sym_LBRACK,
      sym_opener,
      sym_end,
      sym_macro_opener,
      sym_declare,
      sym_directive,
      sym_word,
      sym_number,
      anon_sym_DQUOTE,
      sym_sign,
  [1002] = 4,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    STATE(74), 1,
      sym_block_comment,
    ACTIONS(222), 12,
      anon_sym_LBRACE,
      anon_sym_LPAREN,
      anon_sym_LBRACK,
      sym_opener,
      sym_end,
      sym_macro_opener,
      sym_declare,
      sym_directive,
      sym_word,
      sym_number,
      anon_sym_DQUOTE,
      sym_sign,
  [1026] = 4,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    STATE(75), 1,
      sym_block_comment,
    ACTIONS(234), 12,
      anon_sym_LBRACE,
      anon_sym_LPAREN,
      anon_sym_LBRACK,
      sym_opener,
      sym_end,
      sym_macro_opener,
      sym_declare,
      sym_directive,
      sym_word,
      sym_number,
      anon_sym_DQUOTE,
      sym_sign,
  [1050] = 4,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    STATE(76), 1,
      sym_block_comment,
    ACTIONS(238), 12,
      anon_sym_LBRACE,
      anon_sym_LPAREN,
      anon_sym_LBRACK,
      sym_opener,
      sym_end,
      sym_macro_opener,
      sym_declare,
      sym_directive,
      sym_word,
      sym_number,
      anon_sym_DQUOTE,
      sym_sign,
  [1074] = 4,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    STATE(77), 1,
      sym_block_comment,
    ACTIONS(250), 12,
      anon_sym_LBRACE,
      anon_sym_LPAREN,
      anon_sym_LBRACK,
      sym_opener,
      sym_end,
      sym_macro_opener,
      sym_declare,
      sym_directive,
      sym_word,
      sym_number,
      anon_sym_DQUOTE,
      sym_sign,
  [1098] = 4,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    STATE(78), 1,
      sym_block_comment,
    ACTIONS(242), 12,
      anon_sym_LBRACE,
      anon_sym_LPAREN,
      anon_sym_LBRACK,
      sym_opener,
      sym_end,
      sym_macro_opener,
      sym_declare,
      sym_directive,
      sym_word,
      sym_number,
      anon_sym_DQUOTE,
      sym_sign,
  [1122] = 4,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    STATE(79), 1,
      sym_block_comment,
    ACTIONS(206), 12,
      anon_sym_LBRACE,
      anon_sym_LPAREN,
      anon_sym_LBRACK,
      sym_opener,
      sym_end,
      sym_macro_opener,
      sym_declare,
      sym_directive,
      sym_word,
      sym_number,
      anon_sym_DQUOTE,
      sym_sign,
  [1146] = 4,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    STATE(80), 1,
      sym_block_comment,
    ACTIONS(268), 12,
      anon_sym_LBRACE,
      anon_sym_LPAREN,
      anon_sym_LBRACK,
      sym_opener,
      sym_end,
      sym_macro_opener,
      sym_declare,
      sym_directive,
      sym_word,
      sym_number,
      anon_sym_DQUOTE,
      sym_sign,
  [1170] = 4,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    STATE(81), 1,
      sym_block_comment,
    ACTIONS(230), 12,
      anon_sym_LBRACE,
      anon_sym_LPAREN,
      anon_sym_LBRACK,
      sym_opener,
      sym_end,
      sym_macro_opener,
      sym_declare,
      sym_directive,
      sym_word,
      sym_number,
      anon_sym_DQUOTE,
      sym_sign,
  [1194] = 4,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    STATE(82), 1,
      sym_block_comment,
    ACTIONS(246), 12,
      anon_sym_LBRACE,
      anon_sym_LPAREN,
      anon_sym_LBRACK,
      sym_opener,
      sym_end,
      sym_macro_opener,
      sym_declare,
      sym_directive,
      sym_word,
      sym_number,
      anon_sym_DQUOTE,
      sym_sign,
  [1218] = 6,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(270), 1,
      anon_sym_SLASH_STAR,
    ACTIONS(274), 1,
      anon_sym_STAR_SLASH,
    STATE(83), 1,
      sym_block_comment,
    STATE(89), 1,
      aux_sym_block_comment_repeat1,
    ACTIONS(272), 2,
      aux_sym_block_comment_token1,
      aux_sym_block_comment_token2,
  [1238] = 6,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(270), 1,
      anon_sym_SLASH_STAR,
    ACTIONS(278), 1,
      anon_sym_STAR_SLASH,
    STATE(84), 1,
      sym_block_comment,
    STATE(91), 1,
      aux_sym_block_comment_repeat1,
    ACTIONS(276), 2,
      aux_sym_block_comment_token1,
      aux_sym_block_comment_token2,
  [1258] = 7,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    ACTIONS(280), 1,
      aux_sym_string_token1,
    ACTIONS(282), 1,
      anon_sym_DQUOTE2,
    ACTIONS(284), 1,
      sym_escape,
    STATE(85), 1,
      sym_block_comment,
    STATE(87), 1,
      aux_sym_string_repeat1,
  [1280] = 6,
    ACTIONS(5), 1,
      anon_sym_SLASH_STAR,
    ACTIONS(286), 1,
      anon_sym_RPAREN,
    ACTIONS(290), 1,
      sym_line_comment,
    STATE(86), 1,
      sym_block_comment,
    STATE(90), 1,
      aux_sym_parameters_repeat1,
    ACTIONS(288), 2,
      anon_sym_COMMA,
      sym_word,
  [1300] = 7,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    ACTIONS(280), 1,
      aux_sym_string_token1,
    ACTIONS(284), 1,
      sym_escape,
    ACTIONS(292), 1,
      anon_sym_DQUOTE2,
    STATE(87), 1,
      sym_block_comment,
    STATE(88), 1,
      aux_sym_string_repeat1,
  [1322] = 6,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    ACTIONS(294), 1,
      aux_sym_string_token1,
    ACTIONS(297), 1,
      anon_sym_DQUOTE2,
    ACTIONS(299), 1,
      sym_escape,
    STATE(88), 2,
      sym_block_comment,
      aux_sym_string_repeat1,
  [1342] = 6,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(270), 1,
      anon_sym_SLASH_STAR,
    ACTIONS(302), 1,
      anon_sym_STAR_SLASH,
    STATE(89), 1,
      sym_block_comment,
    STATE(91), 1,
      aux_sym_block_comment_repeat1,
    ACTIONS(276), 2,
      aux_sym_block_comment_token1,
      aux_sym_block_comment_token2,
  [1362] = 6,
    ACTIONS(5), 1,
      anon_sym_SLASH_STAR,
    ACTIONS(290), 1,
      sym_line_comment,
    ACTIONS(304), 1,
      anon_sym_RPAREN,
    STATE(90), 1,
      sym_block_comment,
    STATE(94), 1,
      aux_sym_parameters_repeat1,
    ACTIONS(288), 2,
      anon_sym_COMMA,
      sym_word,
  [1382] = 5,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(306), 1,
      anon_sym_SLASH_STAR,
    ACTIONS(312), 1,
      anon_sym_STAR_SLASH,
    ACTIONS(309), 2,
      aux_sym_block_comment_token1,
      aux_sym_block_comment_token2,
    STATE(91), 2,
      sym_block_comment,
      aux_sym_block_comment_repeat1,
  [1400] = 7,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    ACTIONS(280), 1,
      aux_sym_string_token1,
    ACTIONS(284), 1,
      sym_escape,
    ACTIONS(314), 1,
      anon_sym_DQUOTE2,
    STATE(92), 1,
      sym_block_comment,
    STATE(97), 1,
      aux_sym_string_repeat1,
  [1422] = 7,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    ACTIONS(280), 1,
      aux_sym_string_token1,
    ACTIONS(284), 1,
      sym_escape,
    ACTIONS(316), 1,
      anon_sym_DQUOTE2,
    STATE(88), 1,
      aux_sym_string_repeat1,
    STATE(93), 1,
      sym_block_comment,
  [1444] = 5,
    ACTIONS(5), 1,
      anon_sym_SLASH_STAR,
    ACTIONS(290), 1,
      sym_line_comment,
    ACTIONS(318), 1,
      anon_sym_RPAREN,
    ACTIONS(320), 2,
      anon_sym_COMMA,
      sym_word,
    STATE(94), 2,
      sym_block_comment,
      aux_sym_parameters_repeat1,
  [1462] = 6,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(270), 1,
      anon_sym_SLASH_STAR,
    ACTIONS(325), 1,
      anon_sym_STAR_SLASH,
    STATE(84), 1,
      aux_sym_block_comment_repeat1,
    STATE(95), 1,
      sym_block_comment,
    ACTIONS(323), 2,
      aux_sym_block_comment_token1,
      aux_sym_block_comment_token2,
  [1482] = 7,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    ACTIONS(280), 1,
      aux_sym_string_token1,
    ACTIONS(284), 1,
      sym_escape,
    ACTIONS(327), 1,
      anon_sym_DQUOTE2,
    STATE(93), 1,
      aux_sym_string_repeat1,
    STATE(96), 1,
      sym_block_comment,
  [1504] = 7,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    ACTIONS(280), 1,
      aux_sym_string_token1,
    ACTIONS(284), 1,
      sym_escape,
    ACTIONS(329), 1,
      anon_sym_DQUOTE2,
    STATE(88), 1,
      aux_sym_string_repeat1,
    STATE(97), 1,
      sym_block_comment,
  [1526] = 4,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(333), 1,
      anon_sym_STAR_SLASH,
    STATE(98), 1,
      sym_block_comment,
    ACTIONS(331), 3,
      anon_sym_SLASH_STAR,
      aux_sym_block_comment_token1,
      aux_sym_block_comment_token2,
  [1541] = 5,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(25), 1,
      anon_sym_SLASH_STAR,
    ACTIONS(335), 1,
      aux_sym_string_token1,
    STATE(99), 1,
      sym_block_comment,
    ACTIONS(337), 2,
      anon_sym_DQUOTE2,
      sym_escape,
  [1558] = 4,
    ACTIONS(3), 1,
      sym_line_comment,
    ACTIONS(341), 1,
      anon_sym_STAR_SLASH,
    STATE(100), 1,
      sym_block_comment,
    ACTIONS(339), 3,
      anon_sym_SLASH_STAR,
      aux_sym_block_comment_token1,
      aux_sym_block_comment_token2,
  [1573] = 4,
    ACTIONS(5), 1,
      anon_sym_SLASH_STAR,
    ACTIONS(290), 1,
      sym_line_comment,
    STATE(101), 1,
      sym_block_comment,
    ACTIONS(343), 3,
      anon_sym_RPAREN,
      anon_sym_COMMA,
      sym_word,
  [1588] = 5,
    ACTIONS(5), 1,
      anon_sym_SLASH_STAR,
    ACTIONS(290), 1,
      sym_line_comment,
    ACTIONS(345), 1,
      anon_sym_LPAREN,
    STATE(33), 1,
      sym_parameters,
    STATE(102), 1,
      sym_block_comment,
  [1604] = 5,
    ACTIONS(5), 1,
      anon_sym_SLASH_STAR,
    ACTIONS(290), 1,
      sym_line_comment,
    ACTIONS(345), 1,
      anon_sym_LPAREN,
    STATE(17), 1,
      sym_parameters,
    STATE(103), 1,
      sym_block_comment,
  [1620] = 5,
    ACTIONS(5), 1,
      anon_sym_SLASH_STAR,
    ACTIONS(290), 1,
      sym_line_comment,
    ACTIONS(345), 1,
      anon_sym_LPAREN,
    STATE(25), 1,
      sym_parameters,
    STATE(104), 1,
      sym_block_comment,
  [1636] = 4,
    ACTIONS(5), 1,
      anon_sym_SLASH_STAR,
    ACTIONS(290), 1,
      sym_line_comment,
    ACTIONS(347), 1,
      ts_builtin_sym_end,
    STATE(105), 1,
      sym_block_comment,
  [1649] = 4,
    ACTIONS(5), 1,
      anon_sym_SLASH_STAR,
    ACTIONS(290), 1,
      sym_line_comment,
    ACTIONS(349), 1,
      sym_word,
    STATE(106), 1,
      sym_block_comment,
  [1662] = 4,
    ACTIONS(5), 1,
      anon_sym_SLASH_STAR,
    ACTIONS(290), 1,
      sym_line_comment,
    ACTIONS(351), 1,
      sym_word,
    STATE(107), 1,
      sym_block_comment,
  [1675] = 4,
    ACTIONS(5), 1,
      anon_sym_SLASH_STAR,
    ACTIONS(290), 1,
      sym_line_comment,
    ACTIONS(353), 1,
      sym_word,
    STATE(108), 1,
      sym_block_comment,
  [1688] = 4,
    ACTIONS(5), 1,
      anon_sym_SLASH_STAR,
    ACTIONS(290), 1,
      sym_line_comment,
    ACTIONS(355), 1,
      sym_word,
    STATE(109), 1,
      sym_block_comment,
  [1701] = 4,
    ACTIONS(5), 1,
      anon_sym_SLASH_STAR,
    ACTIONS(290), 1,
      sym_line_comment,
    ACTIONS(357), 1,
      sym_word,
    STATE(110), 1,
      sym_block_comment,
  [1714] = 4,
    ACTIONS(5), 1,
      anon_sym_SLASH_STAR,
    ACTIONS(290), 1,
      sym_line_comment,
    ACTIONS(359), 1,
      sym_word,
    STATE(111), 1,
      sym_block_comment,
  [1727] = 1,
    ACTIONS(333), 1,
      ts_builtin_sym_end,
  [1731] = 1,
    ACTIONS(341), 1,
      ts_builtin_sym_end,
};

static const uint32_t ts_small_parse_table_map[] = {
  [SMALL_STATE(36)] = 0,
  [SMALL_STATE(37)] = 29,
  [SMALL_STATE(38)] = 58,
  [SMALL_STATE(39)] = 87,
  [SMALL_STATE(40)] = 116,
  [SMALL_STATE(41)] = 145,
  [SMALL_STATE(42)] = 174,
  [SMALL_STATE(43)] = 203,
  [SMALL_STATE(44)] = 232,
  [SMALL_STATE(45)] = 261,
  [SMALL_STATE(46)] = 290,
  [SMALL_STATE(47)] = 319,
  [SMALL_STATE(48)] = 348,
  [SMALL_STATE(49)] = 377,
  [SMALL_STATE(50)] = 406,
  [SMALL_STATE(51)] = 435,
  [SMALL_STATE(52)] = 460,
  [SMALL_STATE(53)] = 485,
  [SMALL_STATE(54)] = 510,
  [SMALL_STATE(55)] = 535,
  [SMALL_STATE(56)] = 560,
  [SMALL_STATE(57)] = 585,
  [SMALL_STATE(58)] = 610,
  [SMALL_STATE(59)] = 635,
  [SMALL_STATE(60)] = 660,
  [SMALL_STATE(61)] = 685,
  [SMALL_STATE(62)] = 710,
  [SMALL_STATE(63)] = 735,
  [SMALL_STATE(64)] = 760,
  [SMALL_STATE(65)] = 785,
  [SMALL_STATE(66)] = 810,
  [SMALL_STATE(67)] = 834,
  [SMALL_STATE(68)] = 858,
  [SMALL_STATE(69)] = 882,
  [SMALL_STATE(70)] = 906,
  [SMALL_STATE(71)] = 930,
  [SMALL_STATE(72)] = 954,
  [SMALL_STATE(73)] = 978,
  [SMALL_STATE(74)] = 1002,
  [SMALL_STATE(75)] = 1026,
  [SMALL_STATE(76)] = 1050,
  [SMALL_STATE(77)] = 1074,
  [SMALL_STATE(78)] = 1098,
  [SMALL_STATE(79)] = 1122,
  [SMALL_STATE(80)] = 1146,
  [SMALL_STATE(81)] = 1170,
  [SMALL_STATE(82)] = 1194,
  [SMALL_STATE(83)] = 1218,
  [SMALL_STATE(84)] = 1238,
  [SMALL_STATE(85)] = 1258,
  [SMALL_STATE(86)] = 1280,
  [SMALL_STATE(87)] = 1300,
  [SMALL_STATE(88)] = 1322,
  [SMALL_STATE(89)] = 1342,
  [SMALL_STATE(90)] = 1362,
  [SMALL_STATE(91)] = 1382,
  [SMALL_STATE(92)] = 1400,
  [SMALL_STATE(93)] = 1422,
  [SMALL_STATE(94)] = 1444,
  [SMALL_STATE(95)] = 1462,
  [SMALL_STATE(96)] = 1482,
  [SMALL_STATE(97)] = 1504,
  [SMALL_STATE(98)] = 1526,
  [SMALL_STATE(99)] = 1541,
  [SMALL_STATE(100)] = 1558,
  [SMALL_STATE(101)] = 1573,
  [SMALL_STATE(102)] = 1588,
  [SMALL_STATE(103)] = 1604,
  [SMALL_STATE(104)] = 1620,
  [SMALL_STATE(105)] = 1636,
  [SMALL_STATE(106)] = 1649,
  [SMALL_STATE(107)] = 1662,
  [SMALL_STATE(108)] = 1675,
  [SMALL_STATE(109)] = 1688,
  [SMALL_STATE(110)] = 1701,
  [SMALL_STATE(111)] = 1714,
  [SMALL_STATE(112)] = 1727,
  [SMALL_STATE(113)] = 1731,
};

static const TSParseActionEntry ts_parse_actions[] = {
  [0] = {.entry = {.count = 0, .reusable = false}},
  [1] = {.entry = {.count = 1, .reusable = false}}, RECOVER(),
  [3] = {.entry = {.count = 1, .reusable = false}}, SHIFT_EXTRA(),
  [5] = {.entry = {.count = 1, .reusable = true}}, SHIFT(95),
  [7] = {.entry = {.count = 1, .reusable = true}}, REDUCE(sym_source_file, 0, 0, 0),
  [9] = {.entry = {.count = 1, .reusable = false}}, SHIFT(16),
  [11] = {.entry = {.count = 1, .reusable = false}}, SHIFT(10),
  [13] = {.entry = {.count = 1, .reusable = false}}, SHIFT(15),
  [15] = {.entry = {.count = 1, .reusable = false}}, SHIFT(4),
  [17] = {.entry = {.count = 1, .reusable = false}}, SHIFT(109),
  [19] = {.entry = {.count = 1, .reusable = false}}, SHIFT(106),
  [21] = {.entry = {.count = 1, .reusable = false}}, SHIFT(45),
  [23] = {.entry = {.count = 1, .reusable = false}}, SHIFT(96),
  [25] = {.entry = {.count = 1, .reusable = false}}, SHIFT(95),
  [27] = {.entry = {.count = 1, .reusable = true}}, REDUCE(aux_sym_source_file_repeat1, 2, 0, 0),
  [29] = {.entry = {.count = 2, .reusable = false}}, REDUCE(aux_sym_source_file_repeat1, 2, 0, 0), SHIFT_REPEAT(16),
  [32] = {.entry = {.count = 1, .reusable = false}}, REDUCE(aux_sym_source_file_repeat1, 2, 0, 0),
  [34] = {.entry = {.count = 2, .reusable = false}}, REDUCE(aux_sym_source_file_repeat1, 2, 0, 0), SHIFT_REPEAT(10),
  [37] = {.entry = {.count = 2, .reusable = false}}, REDUCE(aux_sym_source_file_repeat1, 2, 0, 0), SHIFT_REPEAT(15),
  [40] = {.entry = {.count = 2, .reusable = false}}, REDUCE(aux_sym_source_file_repeat1, 2, 0, 0), SHIFT_REPEAT(4),
  [43] = {.entry = {.count = 2, .reusable = false}}, REDUCE(aux_sym_source_file_repeat1, 2, 0, 0), SHIFT_REPEAT(109),
  [46] = {.entry = {.count = 2, .reusable = false}}, REDUCE(aux_sym_source_file_repeat1, 2, 0, 0), SHIFT_REPEAT(106),
  [49] = {.entry = {.count = 2, .reusable = false}}, REDUCE(aux_sym_source_file_repeat1, 2, 0, 0), SHIFT_REPEAT(45),
  [52] = {.entry = {.count = 2, .reusable = false}}, REDUCE(aux_sym_source_file_repeat1, 2, 0, 0), SHIFT_REPEAT(96),
  [55] = {.entry = {.count = 1, .reusable = false}}, SHIFT(19),
  [57] = {.entry = {.count = 1, .reusable = false}}, SHIFT(20),
  [59] = {.entry = {.count = 1, .reusable = false}}, SHIFT(21),
  [61] = {.entry = {.count = 1, .reusable = false}}, SHIFT(6),
  [63] = {.entry = {.count = 1, .reusable = false}}, SHIFT(63),
  [65] = {.entry = {.count = 1, .reusable = false}}, SHIFT(40),
  [67] = {.entry = {.count = 1, .reusable = false}}, SHIFT(110),
  [69] = {.entry = {.count = 1, .reusable = false}}, SHIFT(107),
  [71] = {.entry = {.count = 1, .reusable = false}}, SHIFT(65),
  [73] = {.entry = {.count = 1, .reusable = false}}, SHIFT(85),
  [75] = {.entry = {.count = 1, .reusable = false}}, SHIFT(48),
  [77] = {.entry = {.count = 2, .reusable = false}}, REDUCE(aux_sym_conditional_repeat1, 2, 0, 0), SHIFT_REPEAT(19),
  [80] = {.entry = {.count = 2, .reusable = false}}, REDUCE(aux_sym_conditional_repeat1, 2, 0, 0), SHIFT_REPEAT(20),
  [83] = {.entry = {.count = 2, .reusable = false}}, REDUCE(aux_sym_conditional_repeat1, 2, 0, 0), SHIFT_REPEAT(21),
  [86] = {.entry = {.count = 2, .reusable = false}}, REDUCE(aux_sym_conditional_repeat1, 2, 0, 0), SHIFT_REPEAT(6),
  [89] = {.entry = {.count = 2, .reusable = false}}, REDUCE(aux_sym_conditional_repeat1, 2, 0, 0), SHIFT_REPEAT(63),
  [92] = {.entry = {.count = 1, .reusable = false}}, REDUCE(aux_sym_conditional_repeat1, 2, 0, 0),
  [94] = {.entry = {.count = 2, .reusable = false}}, REDUCE(aux_sym_conditional_repeat1, 2, 0, 0), SHIFT_REPEAT(110),
  [97] = {.entry = {.count = 2, .reusable = false}}, REDUCE(aux_sym_conditional_repeat1, 2, 0, 0), SHIFT_REPEAT(107),
  [100] = {.entry = {.count = 2, .reusable = false}}, REDUCE(aux_sym_conditional_repeat1, 2, 0, 0), SHIFT_REPEAT(65),
  [103] = {.entry = {.count = 2, .reusable = false}}, REDUCE(aux_sym_conditional_repeat1, 2, 0, 0), SHIFT_REPEAT(85),
  [106] = {.entry = {.count = 1, .reusable = false}}, SHIFT(54),
  [108] = {.entry = {.count = 1, .reusable = false}}, SHIFT(60),
  [110] = {.entry = {.count = 1, .reusable = false}}, SHIFT(68),
  [112] = {.entry = {.count = 1, .reusable = false}}, SHIFT(74),
  [114] = {.entry = {.count = 1, .reusable = false}}, SHIFT(42),
  [116] = {.entry = {.count = 1, .reusable = true}}, REDUCE(sym_source_file, 1, 0, 0),
  [118] = {.entry = {.count = 1, .reusable = false}}, SHIFT(37),
  [120] = {.entry = {.count = 1, .reusable = false}}, SHIFT(38),
  [122] = {.entry = {.count = 1, .reusable = false}}, SHIFT(39),
  [124] = {.entry = {.count = 1, .reusable = false}}, SHIFT(41),
  [126] = {.entry = {.count = 1, .reusable = false}}, SHIFT(36),
  [128] = {.entry = {.count = 1, .reusable = false}}, SHIFT(27),
  [130] = {.entry = {.count = 1, .reusable = false}}, SHIFT(28),
  [132] = {.entry = {.count = 1, .reusable = false}}, SHIFT(29),
  [134] = {.entry = {.count = 1, .reusable = false}}, SHIFT(8),
  [136] = {.entry = {.count = 1, .reusable = false}}, SHIFT(44),
  [138] = {.entry = {.count = 1, .reusable = false}}, SHIFT(111),
  [140] = {.entry = {.count = 1, .reusable = false}}, SHIFT(108),
  [142] = {.entry = {.count = 1, .reusable = false}}, SHIFT(78),
  [144] = {.entry = {.count = 1, .reusable = false}}, SHIFT(92),
  [146] = {.entry = {.count = 2, .reusable = false}}, REDUCE(aux_sym_source_file_repeat1, 2, 0, 0), SHIFT_REPEAT(27),
  [149] = {.entry = {.count = 2, .reusable = false}}, REDUCE(aux_sym_source_file_repeat1, 2, 0, 0), SHIFT_REPEAT(28),
  [152] = {.entry = {.count = 2, .reusable = false}}, REDUCE(aux_sym_source_file_repeat1, 2, 0, 0), SHIFT_REPEAT(29),
  [155] = {.entry = {.count = 2, .reusable = false}}, REDUCE(aux_sym_source_file_repeat1, 2, 0, 0), SHIFT_REPEAT(8),
  [158] = {.entry = {.count = 2, .reusable = false}}, REDUCE(aux_sym_source_file_repeat1, 2, 0, 0), SHIFT_REPEAT(111),
  [161] = {.entry = {.count = 2, .reusable = false}}, REDUCE(aux_sym_source_file_repeat1, 2, 0, 0), SHIFT_REPEAT(108),
  [164] = {.entry = {.count = 2, .reusable = false}}, REDUCE(aux_sym_source_file_repeat1, 2, 0, 0), SHIFT_REPEAT(78),
  [167] = {.entry = {.count = 2, .reusable = false}}, REDUCE(aux_sym_source_file_repeat1, 2, 0, 0), SHIFT_REPEAT(92),
  [170] = {.entry = {.count = 1, .reusable = false}}, SHIFT(64),
  [172] = {.entry = {.count = 1, .reusable = false}}, SHIFT(52),
  [174] = {.entry = {.count = 1, .reusable = false}}, SHIFT(53),
  [176] = {.entry = {.count = 1, .reusable = false}}, SHIFT(57),
  [178] = {.entry = {.count = 1, .reusable = false}}, SHIFT(58),
  [180] = {.entry = {.count = 1, .reusable = false}}, SHIFT(59),
  [182] = {.entry = {.count = 1, .reusable = false}}, SHIFT(51),
  [184] = {.entry = {.count = 1, .reusable = false}}, SHIFT(62),
  [186] = {.entry = {.count = 1, .reusable = false}}, SHIFT(79),
  [188] = {.entry = {.count = 1, .reusable = false}}, SHIFT(81),
  [190] = {.entry = {.count = 1, .reusable = false}}, SHIFT(67),
  [192] = {.entry = {.count = 1, .reusable = false}}, SHIFT(71),
  [194] = {.entry = {.count = 1, .reusable = false}}, SHIFT(72),
  [196] = {.entry = {.count = 1, .reusable = false}}, SHIFT(73),
  [198] = {.entry = {.count = 1, .reusable = false}}, SHIFT(76),
  [200] = {.entry = {.count = 1, .reusable = false}}, SHIFT(77),
  [202] = {.entry = {.count = 1, .reusable = false}}, SHIFT(47),
  [204] = {.entry = {.count = 1, .reusable = true}}, REDUCE(sym_block, 2, 0, 0),
  [206] = {.entry = {.count = 1, .reusable = false}}, REDUCE(sym_block, 2, 0, 0),
  [208] = {.entry = {.count = 1, .reusable = true}}, REDUCE(sym_block, 3, 0, 0),
  [210] = {.entry = {.count = 1, .reusable = false}}, REDUCE(sym_block, 3, 0, 0),
  [212] = {.entry = {.count = 1, .reusable = true}}, REDUCE(sym_parentheses, 3, 0, 0),
  [214] = {.entry = {.count = 1, .reusable = false}}, REDUCE(sym_parentheses, 3, 0, 0),
  [216] = {.entry = {.count = 1, .reusable = true}}, REDUCE(sym_brackets, 3, 0, 0),
  [218] = {.entry = {.count = 1, .reusable = false}}, REDUCE(sym_brackets, 3, 0, 0),
  [220] = {.entry = {.count = 1, .reusable = true}}, REDUCE(sym_conditional, 3, 0, 0),
  [222] = {.entry = {.count = 1, .reusable = false}}, REDUCE(sym_conditional, 3, 0, 0),
  [224] = {.entry = {.count = 1, .reusable = true}}, REDUCE(sym_brackets, 2, 0, 0),
  [226] = {.entry = {.count = 1, .reusable = false}}, REDUCE(sym_brackets, 2, 0, 0),
  [228] = {.entry = {.count = 1, .reusable = true}}, REDUCE(sym_parentheses, 2, 0, 0),
  [230] = {.entry = {.count = 1, .reusable = false}}, REDUCE(sym_parentheses, 2, 0, 0),
  [232] = {.entry = {.count = 1, .reusable = true}}, REDUCE(sym_string, 3, 0, 0),
  [234] = {.entry = {.count = 1, .reusable = false}}, REDUCE(sym_string, 3, 0, 0),
  [236] = {.entry = {.count = 1, .reusable = true}}, REDUCE(sym_macro, 4, 0, 1),
  [238] = {.entry = {.count = 1, .reusable = false}}, REDUCE(sym_macro, 4, 0, 1),
  [240] = {.entry = {.count = 1, .reusable = true}}, REDUCE(sym__item, 1, 0, 0),
  [242] = {.entry = {.count = 1, .reusable = false}}, REDUCE(sym__item, 1, 0, 0),
  [244] = {.entry = {.count = 1, .reusable = true}}, REDUCE(aux_sym_source_file_repeat1, 1, 0, 0),
  [246] = {.entry = {.count = 1, .reusable = false}}, REDUCE(aux_sym_source_file_repeat1, 1, 0, 0),
  [248] = {.entry = {.count = 1, .reusable = true}}, REDUCE(sym_macro, 5, 0, 1),
  [250] = {.entry = {.count = 1, .reusable = false}}, REDUCE(sym_macro, 5, 0, 1),
  [252] = {.entry = {.count = 1, .reusable = true}}, REDUCE(sym_conditional, 2, 0, 0),
  [254] = {.entry = {.count = 1, .reusable = false}}, REDUCE(sym_conditional, 2, 0, 0),
  [256] = {.entry = {.count = 1, .reusable = true}}, REDUCE(sym_declaration, 2, 0, 1),
  [258] = {.entry = {.count = 1, .reusable = false}}, REDUCE(sym_declaration, 2, 0, 1),
  [260] = {.entry = {.count = 1, .reusable = true}}, REDUCE(sym_string, 2, 0, 0),
  [262] = {.entry = {.count = 1, .reusable = false}}, REDUCE(sym_string, 2, 0, 0),
  [264] = {.entry = {.count = 1, .reusable = false}}, REDUCE(aux_sym_conditional_repeat1, 1, 0, 0),
  [266] = {.entry = {.count = 1, .reusable = false}}, REDUCE(sym_parameters, 2, 0, 0),
  [268] = {.entry = {.count = 1, .reusable = false}}, REDUCE(sym_parameters, 3, 0, 0),
  [270] = {.entry = {.count = 1, .reusable = false}}, SHIFT(83),
  [272] = {.entry = {.count = 1, .reusable = false}}, SHIFT(89),
  [274] = {.entry = {.count = 1, .reusable = true}}, SHIFT(98),
  [276] = {.entry = {.count = 1, .reusable = false}}, SHIFT(91),
  [278] = {.entry = {.count = 1, .reusable = true}}, SHIFT(113),
  [280] = {.entry = {.count = 1, .reusable = false}}, SHIFT(99),
  [282] = {.entry = {.count = 1, .reusable = true}}, SHIFT(56),
  [284] = {.entry = {.count = 1, .reusable = true}}, SHIFT(99),
  [286] = {.entry = {.count = 1, .reusable = true}}, SHIFT(66),
  [288] = {.entry = {.count = 1, .reusable = true}}, SHIFT(101),
  [290] = {.entry = {.count = 1, .reusable = true}}, SHIFT_EXTRA(),
  [292] = {.entry = {.count = 1, .reusable = true}}, SHIFT(61),
  [294] = {.entry = {.count = 2, .reusable = false}}, REDUCE(aux_sym_string_repeat1, 2, 0, 0), SHIFT_REPEAT(99),
  [297] = {.entry = {.count = 1, .reusable = true}}, REDUCE(aux_sym_string_repeat1, 2, 0, 0),
  [299] = {.entry = {.count = 2, .reusable = true}}, REDUCE(aux_sym_string_repeat1, 2, 0, 0), SHIFT_REPEAT(99),
  [302] = {.entry = {.count = 1, .reusable = true}}, SHIFT(100),
  [304] = {.entry = {.count = 1, .reusable = true}}, SHIFT(80),
  [306] = {.entry = {.count = 2, .reusable = false}}, REDUCE(aux_sym_block_comment_repeat1, 2, 0, 0), SHIFT_REPEAT(83),
  [309] = {.entry = {.count = 2, .reusable = false}}, REDUCE(aux_sym_block_comment_repeat1, 2, 0, 0), SHIFT_REPEAT(91),
  [312] = {.entry = {.count = 1, .reusable = true}}, REDUCE(aux_sym_block_comment_repeat1, 2, 0, 0),
  [314] = {.entry = {.count = 1, .reusable = true}}, SHIFT(70),
  [316] = {.entry = {.count = 1, .reusable = true}}, SHIFT(43),
  [318] = {.entry = {.count = 1, .reusable = true}}, REDUCE(aux_sym_parameters_repeat1, 2, 0, 0),
  [320] = {.entry = {.count = 2, .reusable = true}}, REDUCE(aux_sym_parameters_repeat1, 2, 0, 0), SHIFT_REPEAT(101),
  [323] = {.entry = {.count = 1, .reusable = false}}, SHIFT(84),
  [325] = {.entry = {.count = 1, .reusable = true}}, SHIFT(112),
  [327] = {.entry = {.count = 1, .reusable = true}}, SHIFT(50),
  [329] = {.entry = {.count = 1, .reusable = true}}, SHIFT(75),
  [331] = {.entry = {.count = 1, .reusable = false}}, REDUCE(sym_block_comment, 2, 0, 0),
  [333] = {.entry = {.count = 1, .reusable = true}}, REDUCE(sym_block_comment, 2, 0, 0),
  [335] = {.entry = {.count = 1, .reusable = false}}, REDUCE(aux_sym_string_repeat1, 1, 0, 0),
  [337] = {.entry = {.count = 1, .reusable = true}}, REDUCE(aux_sym_string_repeat1, 1, 0, 0),
  [339] = {.entry = {.count = 1, .reusable = false}}, REDUCE(sym_block_comment, 3, 0, 0),
  [341] = {.entry = {.count = 1, .reusable = true}}, REDUCE(sym_block_comment, 3, 0, 0),
  [343] = {.entry = {.count = 1, .reusable = true}}, REDUCE(aux_sym_parameters_repeat1, 1, 0, 0),
  [345] = {.entry = {.count = 1, .reusable = true}}, SHIFT(86),
  [347] = {.entry = {.count = 1, .reusable = true}},  ACCEPT_INPUT(),
  [349] = {.entry = {.count = 1, .reusable = true}}, SHIFT(49),
  [351] = {.entry = {.count = 1, .reusable = true}}, SHIFT(55),
  [353] = {.entry = {.count = 1, .reusable = true}}, SHIFT(69),
  [355] = {.entry = {.count = 1, .reusable = true}}, SHIFT(103),
  [357] = {.entry = {.count = 1, .reusable = true}}, SHIFT(104),
  [359] = {.entry = {.count = 1, .reusable = true}}, SHIFT(102),
};

#ifdef __cplusplus
extern "C" {
#endif
#ifdef TREE_SITTER_HIDE_SYMBOLS
#define TS_PUBLIC
#elif defined(_WIN32)
#define TS_PUBLIC __declspec(dllexport)
#else
#define TS_PUBLIC __attribute__((visibility("default")))
#endif

TS_PUBLIC const TSLanguage *tree_sitter_povray(void) {
  static const TSLanguage language = {
    .version = LANGUAGE_VERSION,
    .symbol_count = SYMBOL_COUNT,
    .alias_count = ALIAS_COUNT,
    .token_count = TOKEN_COUNT,
    .external_token_count = EXTERNAL_TOKEN_COUNT,
    .state_count = STATE_COUNT,
    .large_state_count = LARGE_STATE_COUNT,
    .production_id_count = PRODUCTION_ID_COUNT,
    .field_count = FIELD_COUNT,
    .max_alias_sequence_length = MAX_ALIAS_SEQUENCE_LENGTH,
    .parse_table = &ts_parse_table[0][0],
    .small_parse_table = ts_small_parse_table,
    .small_parse_table_map = ts_small_parse_table_map,
    .parse_actions = ts_parse_actions,
    .symbol_names = ts_symbol_names,
    .field_names = ts_field_names,
    .field_map_slices = ts_field_map_slices,
    .field_map_entries = ts_field_map_entries,
    .symbol_metadata = ts_symbol_metadata,
    .public_symbol_map = ts_symbol_map,
    .alias_map = ts_non_terminal_alias_map,
    .alias_sequences = &ts_alias_sequences[0][0],
    .lex_modes = ts_lex_modes,
    .lex_fn = ts_lex,
    .primary_state_ids = ts_primary_state_ids,
  };
  return &language;
}
#ifdef __cplusplus
}
#endif

// What tests/editor/textmate.sh runs; further folders of scenes may be named.
'use strict';

const assert = require('assert');
const fs = require('fs');
const path = require('path');
const oniguruma = require('vscode-oniguruma');
const textmate = require('vscode-textmate');

const root = path.join(__dirname, '../..');
const syntaxes = path.join(root, 'editors/vscode/syntaxes');

const registry = new textmate.Registry({
  onigLib: oniguruma
    .loadWASM(fs.readFileSync(require.resolve('vscode-oniguruma/release/onig.wasm')))
    .then(() => ({
      createOnigScanner: (patterns) => new oniguruma.OnigScanner(patterns),
      createOnigString: (text) => new oniguruma.OnigString(text),
    })),
  loadGrammar: async (scope) => {
    const file = path.join(syntaxes, `${scope.slice('source.'.length)}.tmLanguage.json`);
    return textmate.parseRawGrammar(fs.readFileSync(file, 'utf8'), file);
  },
});

// All tokens of a text with their scopes, and what goes on behind its end.
function read(grammar, text) {
  let state = textmate.INITIAL;
  const all = text.split('\n').flatMap((line) => {
    const found = grammar.tokenizeLine(line, state);
    assert(!found.stoppedEarly);
    state = found.ruleStack;
    return found.tokens.map((t) => ({ text: line.slice(t.startIndex, t.endIndex), scopes: t.scopes }));
  });
  return { all, state };
}

// The nth token that holds the text has this scope among its own.
function is(all, text, scope, nth = 1) {
  const found = all.filter((token) => token.text.includes(text))[nth - 1];
  assert(found, `there is no token with ${text}`);
  assert(found.scopes.some((one) => one.startsWith(scope)), `${text} is ${found.scopes}, not ${scope}`);
}

function files(folder) {
  return fs.readdirSync(folder, { withFileTypes: true }).flatMap((entry) => {
    const name = path.join(folder, entry.name);
    return entry.isDirectory() ? files(name) : /\.(scene|pov|inc)$/.test(name) ? [name] : [];
  });
}

async function main() {
  const scene = await registry.loadGrammar('source.povray');
  const sample = read(scene, fs.readFileSync(path.join(__dirname, 'sample.pov'), 'utf8')).all;
  is(sample, 'all of it', 'comment.line');
  is(sample, 'sphere in a comment', 'comment.block');
  is(sample, 'still a comment', 'comment.block');
  is(sample, '#version', 'keyword.control.directive');
  is(sample, '3.7', 'constant.numeric');
  is(sample, '#declare', 'keyword.control.directive');
  is(sample, 'Size', 'variable.other.definition');
  is(sample, 'Size', 'variable.other.povray', 2);
  is(sample, '1.5e-1', 'constant.numeric');
  is(sample, '#macro', 'keyword.control.directive');
  is(sample, 'Ball', 'entity.name.function');
  is(sample, 'Where', 'variable.parameter');
  is(sample, 'sphere', 'support.class', 2);
  is(sample, 'pigment', 'keyword.other.block');
  is(sample, 'rgb', 'support.type.property-name');
  is(sample, 'sin', 'support.function');
  is(sample, 'pi', 'constant.language', 2);
  is(sample, '.5', 'constant.numeric', 2);
  is(sample, '#for', 'keyword.control.directive');
  is(sample, 'Index', 'variable.other.definition');
  is(sample, '# end', 'keyword.control.directive');
  is(sample, 'a // text ', 'string');
  is(sample, '\\"', 'constant.character.escape');
  is(sample, 'with /* in it', 'string');
  is(sample, 'union', 'support.class');

  const ini = await registry.loadGrammar('source.povray-ini');
  const options = read(ini, fs.readFileSync(path.join(__dirname, 'sample.ini'), 'utf8')).all;
  is(options, 'all of it', 'comment.line');
  is(options, 'Input_File_Name', 'support.type.property-name');
  is(options, 'width', 'support.type.property-name');
  is(options, '"sample.pov"', 'string');
  is(options, '[low]', 'entity.name.section');
  is(options, '+A', 'keyword.other.switch');
  is(options, '320', 'constant.numeric');

  const scenes = [path.join(root, 'scenes'), ...process.argv.slice(2)].flatMap(files);
  let count = 0;
  for (const file of scenes) {
    const { all, state } = read(scene, fs.readFileSync(file, 'latin1').replace(/\r\n?/g, '\n'));
    count += all.length;
    // Else a comment or a text has no end.
    assert.equal(state.depth, 1, file);
  }
  // Kinds of files: POV-Ray's INI files, and others.
  const Module = require('module');
  const load = Module._load;
  Module._load = (name, ...more) => (/^vscode/.test(name) ? {} : load(name, ...more));
  const { isOptionFile } = require(path.join(root, 'editors/vscode/extension.js'));
  assert(isOptionFile('; x\r\nInput_File_Name=a.pov') && isOptionFile('+W320 +H200') && isOptionFile('; x\nWidth=3\nheight = 2\n'));
  assert(!isOptionFile('[a]\nWidth=3\nheight=2\nname=+W3\n'));
  console.log(`ok: ${count} tokens in ${scenes.length} scenes`);
}

main().catch((error) => {
  console.error(error);
  process.exit(1);
});

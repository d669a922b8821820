// Starts `durer lsp`, carries out what its code lenses ask for, and knows POV-Ray's INI files.
'use strict';

const path = require('path');
const vscode = require('vscode');
const { LanguageClient } = require('vscode-languageclient/node');
const { options } = require('./options.json');

let client;

function settings() {
  const all = vscode.workspace.getConfiguration('durer');
  const include = all.get('include', []).flatMap((folder) => ['-I', folder]);
  return { program: all.get('path') || 'durer', include };
}

async function start() {
  const { program, include } = settings();
  const server = { command: program, args: ['lsp', ...include] };
  const selector = [{ language: 'povray', scheme: 'file' }, { language: 'povray', scheme: 'untitled' }];
  // These are carried out here, in a terminal.
  const initializationOptions = { commands: ['durer.render', 'durer.watch'] };
  client = new LanguageClient('durer', 'durer', server, { documentSelector: selector, initializationOptions });
  try {
    await client.start();
  } catch (error) {
    client = undefined;
    vscode.window.showErrorMessage(`"${program} lsp" does not start: ${error.message}. The setting "durer.path" says where durer is.`);
  }
}

async function stop() {
  const old = client;
  client = undefined;
  if (old) await old.stop().catch(() => {});
}

// One after the other, also if settings change while the server starts.
let turn = Promise.resolve();
function restart() {
  turn = turn.then(stop).then(start);
  return turn;
}

// Runs durer with the scene in a terminal, in the scene's folder; no shell reads the words.
async function run(words, given) {
  const document = vscode.window.activeTextEditor?.document;
  let scene = typeof given === 'string' ? given : document?.uri.scheme === 'file' ? document.uri.fsPath : undefined;
  if (!scene) return vscode.window.showErrorMessage('durer: this text has no file yet.');
  if (scene.startsWith('file:')) scene = vscode.Uri.parse(scene).fsPath;
  await vscode.workspace.textDocuments.find((one) => one.uri.fsPath === scene)?.save();
  const { program, include } = settings();
  const execution = new vscode.ProcessExecution(program, [...words, ...include, scene], { cwd: path.dirname(scene) });
  const name = `${words[0]} ${path.basename(scene)}`;
  const task = new vscode.Task({ type: 'durer', scene, words }, vscode.TaskScope.Workspace, name, 'durer', execution);
  task.presentationOptions = { reveal: vscode.TaskRevealKind.Always, panel: vscode.TaskPanelKind.Dedicated, clear: true };
  return vscode.tasks.executeTask(task);
}

// Of INI files those in which a switch stands, or an option that can only be POV-Ray's (`Width` others have too), or several settings, all
// of which are options.
const known = new Set(options.map((name) => name.toLowerCase()));

function isOptionFile(text) {
  const lines = text.split(/\r\n|\r|\n/, 200);
  const names = lines.map((line) => /^\s*(\w+)\s*=/.exec(line)?.[1].toLowerCase()).filter((name) => name);
  const ours = names.filter((name) => known.has(name));
  const isSure = ours.some((name) => name.includes('_')) || (ours.length > 1 && ours.length === names.length);
  return isSure || lines.some((line) => /^\s*[-+][WHI]\S/.test(line));
}

function look(document) {
  if (document.languageId === 'ini' && isOptionFile(document.getText())) {
    vscode.languages.setTextDocumentLanguage(document, 'povray-ini');
  }
}

function activate(context) {
  context.subscriptions.push(
    vscode.commands.registerCommand('durer.render', (scene) => run(['render'], scene)),
    vscode.commands.registerCommand('durer.watch', (scene) => run(['watch', '--open'], scene)),
    vscode.workspace.onDidOpenTextDocument(look),
    vscode.workspace.onDidChangeConfiguration((event) => event.affectsConfiguration('durer') && restart()),
  );
  vscode.workspace.textDocuments.forEach(look);
  return restart();
}

function deactivate() {
  return turn.then(stop);
}

module.exports = { activate, deactivate, isOptionFile };

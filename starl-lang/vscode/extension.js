// Starts the language server with the launcher that the setting starl.command names.
const { workspace } = require('vscode');
const { LanguageClient } = require('vscode-languageclient/node');

let client;

exports.activate = () => {
  const command = workspace.getConfiguration('starl').get('command');
  const server = { command, args: ['language-server'] };
  client = new LanguageClient('starl', 'StarL', { run: server, debug: server }, {
    documentSelector: [{ language: 'starl' }],
    synchronize: { fileEvents: workspace.createFileSystemWatcher('**/*.starl') },
  });
  return client.start();
};

exports.deactivate = () => client && client.stop();

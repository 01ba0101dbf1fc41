// Starts `minipov lsp` for scenes, and renders or compares the open one in a task.

import * as path from "node:path";
import * as vscode from "vscode";
import { LanguageClient } from "vscode-languageclient/node";

let client: LanguageClient | undefined;

/** Stops and starts of the server, one after the other: settings may change while it starts. */
let restarted: Promise<void> = Promise.resolve();

export async function activate(context: vscode.ExtensionContext): Promise<void> {
  context.subscriptions.push(
    vscode.commands.registerCommand("minipov.render", render),
    vscode.commands.registerCommand("minipov.diff", diff),
    vscode.commands.registerCommand("minipov.restart", restart),
    vscode.workspace.onDidChangeConfiguration(async (change) => {
      if (change.affectsConfiguration("minipov.command") || change.affectsConfiguration("minipov.libraryPaths")) {
        await restart();
      }
    }),
  );
  await restart();
}

export async function deactivate(): Promise<void> {
  await restarted;
  await stop();
}

function restart(): Promise<void> {
  restarted = restarted.then(stop).then(start);
  return restarted;
}

async function stop(): Promise<void> {
  const stopping = client;
  client = undefined;
  if (stopping?.isRunning()) {
    await stopping.stop();
  }
}

async function start(): Promise<void> {
  const folders = setting<string[]>("libraryPaths").flatMap((folder) => ["--library-path", folder]);
  const server = { command: program(), args: ["lsp", ...folders] };
  client = new LanguageClient("minipov", "minipov", server, {
    documentSelector: [{ language: "povray" }],
    outputChannelName: "minipov",
  });
  try {
    await client.start();
  } catch (error) {
    void explain(error);
  }
}

async function explain(failure: unknown): Promise<void> {
  const choice = await vscode.window.showErrorMessage(
    `minipov's language server does not start: ${String(failure)}. ` +
      "Install it (pip install 'minipov[editor]') or name it in minipov.command.",
    "Open Settings",
  );
  if (choice !== undefined) {
    await vscode.commands.executeCommand("workbench.action.openSettings", "minipov.command");
  }
}

/** Render the scene to a picture beside it, and show that. */
async function render(): Promise<void> {
  const scene = await savedScene();
  if (scene === undefined) {
    return;
  }
  const picture = scene.fsPath.replace(/\.pov$/i, "") + ".png";
  const words = [scene.fsPath, "-o", picture, ...setting<string[]>("renderArguments")];
  if ((await runTask("render", scene, words)) === 0) {
    const beside = { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true };
    await vscode.commands.executeCommand("vscode.open", vscode.Uri.file(picture), beside);
  }
}

/** Render the scene with POV-Ray too, and say how far apart the pictures are. */
async function diff(): Promise<void> {
  const scene = await savedScene();
  if (scene !== undefined) {
    await runTask("diff", scene, ["diff", scene.fsPath]);
  }
}

async function savedScene(): Promise<vscode.Uri | undefined> {
  const document = vscode.window.activeTextEditor?.document;
  if (document === undefined || document.languageId !== "povray") {
    await vscode.window.showInformationMessage("Open a scene first.");
    return undefined;
  }
  return (await document.save()) ? document.uri : undefined;
}

/** Run minipov in the folder of the scene, its errors in the Problems view; gives the exit status. */
async function runTask(name: string, scene: vscode.Uri, words: string[]): Promise<number | undefined> {
  const execution = new vscode.ProcessExecution(program(), words, { cwd: path.dirname(scene.fsPath) });
  const folder = vscode.workspace.getWorkspaceFolder(scene) ?? vscode.TaskScope.Workspace;
  const task = new vscode.Task({ type: "minipov", name }, folder, name, "minipov", execution, "$minipov");
  task.presentationOptions = { reveal: vscode.TaskRevealKind.Always, clear: true };
  const running = await vscode.tasks.executeTask(task);
  return new Promise((resolve) => {
    const listeners = [
      vscode.tasks.onDidEndTaskProcess((ended) => end(ended.execution, ended.exitCode)),
      // Comes after the above, and alone where the program could not be started.
      vscode.tasks.onDidEndTask((ended) => end(ended.execution, undefined)),
    ];
    function end(ended: vscode.TaskExecution, status: number | undefined): void {
      if (ended === running) {
        listeners.forEach((listener) => listener.dispose());
        resolve(status);
      }
    }
  });
}

/** The program, found from the workspace folder where it is given by a relative path. */
function program(): string {
  const command = setting<string>("command");
  const root = vscode.workspace.workspaceFolders?.[0]?.uri.fsPath;
  return command.includes("/") && !path.isAbsolute(command) && root !== undefined ? path.join(root, command) : command;
}

function setting<T>(name: string): T {
  return vscode.workspace.getConfiguration("minipov").get(name) as T;
}

// The language client, and the functions of a family beside its text.

import { execFile } from "node:child_process";
import * as fs from "node:fs/promises";
import * as os from "node:os";
import * as path from "node:path";
import * as vscode from "vscode";
import { LanguageClient, TransportKind } from "vscode-languageclient/node";

let client: LanguageClient | undefined;

function command(): string {
  return vscode.workspace.getConfiguration("basis").get("command", "basis");
}

async function start(): Promise<void> {
  const run = { command: command(), args: ["lsp"], transport: TransportKind.stdio };
  client = new LanguageClient("basis", "basis", run, {
    documentSelector: [{ language: "basis" }],
    synchronize: { fileEvents: vscode.workspace.createFileSystemWatcher("**/*.basis") },
  });
  try {
    await client.start();
  } catch (error) {
    client = undefined;
    const what = `\`${run.command} lsp\` does not start: ${error}. Install it with \`cargo install --path cli\`, or set basis.command.`;
    void vscode.window.showErrorMessage(what);
  }
}

/** What a run of the command prints, the text of the editor on its standard input. */
function output(text: string, folder: string | undefined, args: string[]): Promise<string> {
  return new Promise((resolve, reject) => {
    const options = { cwd: folder, timeout: 20_000, maxBuffer: 64 << 20 };
    const child = execFile(command(), args, options, (error, stdout, stderr) => {
      if (error) reject(new Error(stderr.trim() || error.message));
      else resolve(stdout);
    });
    child.stdin?.on("error", () => undefined); // the command may end before it has read all
    child.stdin?.end(text);
  });
}

/** The folder of a text, from which what it uses is found. */
function folder(document: vscode.TextDocument): string | undefined {
  return document.uri.scheme === "file" ? path.dirname(document.uri.fsPath) : undefined;
}

/** The family around the cursor, or before it, in its lowest order; above all families the first one. */
function family(editor: vscode.TextEditor): string | undefined {
  const { document, selection } = editor;
  const text = document.getText();
  const before = document.getText(new vscode.Range(new vscode.Position(0, 0), document.lineAt(selection.active.line).range.end));
  const families = (part: string) => [...part.matchAll(/^\s*family\s+([\p{L}_][\p{L}\p{N}_]*)(\s*\(([^)]*)\))?/gmu)];
  const found = families(before).at(-1) ?? families(text)[0];
  if (!found) return undefined;
  const lows = [...(found[3] ?? "").matchAll(/in\s+(-?\d+)/g)].map((low) => low[1]);
  return lows.length > 0 ? `${found[1]}(${lows.join(",")})` : found[1];
}

/** A panel with the page that `basis plot` writes, drawn again when the text rests. */
class Preview {
  private readonly panel: vscode.WebviewPanel;
  private timer: NodeJS.Timeout | undefined;
  private drawn = 0;

  constructor(private editor: vscode.TextEditor, closed: () => void) {
    const beside = { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true };
    this.panel = vscode.window.createWebviewPanel("basis.preview", "basis", beside, { enableScripts: true });
    const changes = vscode.workspace.onDidChangeTextDocument((event) => {
      if (event.document === this.editor.document) this.later(300);
    });
    const moves = vscode.window.onDidChangeTextEditorSelection((event) => {
      if (event.textEditor.document.languageId !== "basis") return;
      const same = event.textEditor === this.editor && family(this.editor) === this.shown;
      this.editor = event.textEditor;
      if (!same) this.later(300);
    });
    this.panel.onDidDispose(() => {
      changes.dispose();
      moves.dispose();
      clearTimeout(this.timer);
      closed();
    });
    this.later(0);
  }

  private shown: string | undefined;

  reveal(): void {
    this.panel.reveal(undefined, true);
    this.later(0);
  }

  private later(wait: number): void {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => void this.draw(), wait);
  }

  private async draw(): Promise<void> {
    const number = ++this.drawn;
    const name = family(this.editor);
    this.shown = name;
    const document = this.editor.document;
    const scratch = await fs.mkdtemp(path.join(os.tmpdir(), "basis-"));
    const file = path.join(scratch, "preview.html");
    try {
      await output(document.getText(), folder(document), ["plot", "-", ...(name ? [name] : []), "-o", file]);
      const page = await fs.readFile(file, "utf8");
      if (number === this.drawn) {
        this.panel.title = name ?? "basis";
        this.panel.webview.html = page;
      }
    } catch {
      // A text with errors keeps the last picture; the errors stand in the text.
    } finally {
      await fs.rm(scratch, { recursive: true, force: true });
    }
  }
}

let preview: Preview | undefined;

async function latex(): Promise<void> {
  const editor = vscode.window.activeTextEditor;
  if (!editor) return;
  const name = family(editor);
  try {
    const text = await output(editor.document.getText(), folder(editor.document), ["explain", "--format", "latex", "-", ...(name ? [name] : [])]);
    const document = await vscode.workspace.openTextDocument({ language: "latex", content: text });
    await vscode.window.showTextDocument(document, vscode.ViewColumn.Beside);
  } catch (error) {
    void vscode.window.showErrorMessage(String(error));
  }
}

export async function activate(context: vscode.ExtensionContext): Promise<void> {
  context.subscriptions.push(
    vscode.commands.registerCommand("basis.preview", () => {
      const editor = vscode.window.activeTextEditor;
      if (preview) preview.reveal();
      else if (editor?.document.languageId === "basis") preview = new Preview(editor, () => (preview = undefined));
    }),
    vscode.commands.registerCommand("basis.latex", latex),
    vscode.commands.registerCommand("basis.restart", async () => {
      await client?.stop();
      await start();
    }),
  );
  await start();
}

export async function deactivate(): Promise<void> {
  await client?.stop();
}

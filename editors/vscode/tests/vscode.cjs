// What the extension and its client library use of the module `vscode`, which only the editor has. Whatever is not written
// here is a class, a function without effect or an event that never fires.

class Emitter {
  listeners = new Set();
  event = (listener, self) => {
    const call = self ? listener.bind(self) : listener;
    this.listeners.add(call);
    return { dispose: () => this.listeners.delete(call) };
  };
  fire(value) {
    for (const listener of this.listeners) listener(value);
  }
  dispose() {
    this.listeners.clear();
  }
}

class Position {
  constructor(line, character) {
    Object.assign(this, { line, character });
  }
}

class Range {
  constructor(a, b, c, d) {
    [this.start, this.end] = typeof a === 'number' ? [new Position(a, b), new Position(c, d)] : [a, b];
  }
}

class Diagnostic {
  constructor(range, message, severity) {
    Object.assign(this, { range, message, severity });
  }
}

class Uri {
  constructor(path) {
    Object.assign(this, { scheme: 'file', authority: '', path, query: '', fragment: '', fsPath: path });
  }
  static file = (path) => new Uri(path);
  static parse = (text) => new Uri(decodeURIComponent(text.replace('file://', '')));
  toString() {
    return `file://${this.path}`;
  }
}

class Disposable {
  constructor(end) {
    this.dispose = () => end?.();
  }
  static from = (...all) => new Disposable(() => all.forEach((one) => one.dispose()));
}

class CancellationTokenSource {
  canceled = new Emitter();
  token = { isCancellationRequested: false, onCancellationRequested: this.canceled.event };
  cancel() {
    this.token.isCancellationRequested = true;
    this.canceled.fire();
  }
  dispose() {}
}

class CodeActionKind {
  static Empty = new CodeActionKind('');
  constructor(value) {
    this.value = value;
  }
  append(part) {
    return new CodeActionKind(this.value ? `${this.value}.${part}` : part);
  }
}

/** A text in the editor. */
class TextDocument {
  version = 1;
  languageId = 'basis';
  isClosed = false;
  constructor(path, text) {
    this.uri = Uri.file(path);
    this.text = text;
  }
  offset(position) {
    const lines = this.text.split('\n').slice(0, position.line);
    return lines.reduce((sum, line) => sum + line.length + 1, 0) + position.character;
  }
  getText(range) {
    return range ? this.text.slice(this.offset(range.start), this.offset(range.end)) : this.text;
  }
  lineAt(line) {
    const text = this.text.split('\n')[line];
    return { text, range: new Range(line, 0, line, text.length) };
  }
}

/** An object that has whatever is asked of it. */
function lenient(known) {
  return new Proxy(known, {
    get(target, name) {
      if (name in target || typeof name === 'symbol' || name === 'then') return target[name];
      if (/^onDid|^onWill/.test(name)) target[name] = new Emitter().event;
      else if (/^[A-Z]/.test(name)) target[name] = class {};
      else target[name] = () => ({ dispose() {} });
      return target[name];
    },
  });
}

/** An editor without a window; `command` is the command `basis`. */
exports.editor = function editor(command) {
  const events = Object.fromEntries(['open', 'change', 'select'].map((name) => [name, new Emitter()]));
  const seen = { commands: new Map(), diagnostics: new Map(), panels: [], errors: [], shown: [], documents: [] };
  const settings = { get: (key, otherwise) => (key === 'command' ? command : otherwise), has: () => false, inspect: () => undefined };
  const vscode = lenient({
    CancellationTokenSource, CodeActionKind, Diagnostic, Disposable, Position, Range, Uri,
    EventEmitter: Emitter,
    version: '1.85.0',
    DiagnosticSeverity: { Error: 0, Warning: 1, Information: 2, Hint: 3 },
    ViewColumn: { Beside: -2 },
    FileType: { Unknown: 0, File: 1, Directory: 2, SymbolicLink: 64 },
    env: lenient({ language: 'en', appName: 'none' }),
    extensions: lenient({ getExtension: () => undefined, all: [] }),
    workspace: lenient({
      textDocuments: seen.documents,
      notebookDocuments: [],
      workspaceFolders: undefined,
      getConfiguration: () => settings,
      getWorkspaceFolder: () => undefined,
      onDidOpenTextDocument: events.open.event,
      onDidChangeTextDocument: events.change.event,
      createFileSystemWatcher: () => lenient({}),
      openTextDocument: async ({ content }) => ({ content }),
    }),
    languages: lenient({
      match: (selector, document) => (document.languageId === 'basis' ? 10 : 0),
      createDiagnosticCollection: () => lenient({ set: (uri, all) => seen.diagnostics.set(uri.toString(), all) }),
    }),
    commands: lenient({
      registerCommand: (name, run) => {
        seen.commands.set(name, run);
        return { dispose: () => seen.commands.delete(name) };
      },
    }),
    window: lenient({
      activeTextEditor: undefined,
      visibleTextEditors: [],
      tabGroups: lenient({ all: [] }),
      onDidChangeTextEditorSelection: events.select.event,
      createOutputChannel: () => lenient({}),
      showErrorMessage: async (message) => void seen.errors.push(message),
      showTextDocument: async (document) => void seen.shown.push(document),
      createWebviewPanel: () => {
        const closed = new Emitter();
        const panel = { title: '', webview: { html: '' }, onDidDispose: closed.event, reveal() {}, close: () => closed.fire() };
        seen.panels.push(panel);
        return panel;
      },
    }),
  });
  return {
    vscode,
    seen,
    /** Shows a text with the cursor on a line. */
    open(path, text, line = 0) {
      const document = new TextDocument(path, text);
      seen.documents.push(document);
      const textEditor = { document, selection: { active: new Position(line, 0) } };
      vscode.window.activeTextEditor = textEditor;
      events.open.fire(document);
      return textEditor;
    },
    /** Types a text in place of what stands first. */
    type(textEditor, old, text) {
      const { document } = textEditor;
      const at = document.text.indexOf(old);
      const before = document.text.slice(0, at).split('\n');
      const [line, character] = [before.length - 1, before.at(-1).length];
      document.text = document.text.replace(old, text);
      document.version++;
      const range = new Range(line, character, line, character + old.length);
      events.change.fire({ document, contentChanges: [{ range, rangeOffset: at, rangeLength: old.length, text }], reason: undefined });
    },
    /** Moves the cursor. */
    select(textEditor, line) {
      textEditor.selection.active = new Position(line, 0);
      events.select.fire({ textEditor });
    },
  };
};

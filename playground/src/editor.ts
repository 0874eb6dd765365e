// The text: words in colour, verdict marks beside the lines, errors below them, Greek letters by name.
import { autocompletion, completionKeymap, type CompletionContext, type CompletionResult } from '@codemirror/autocomplete';
import { defaultKeymap, history, historyKeymap, indentWithTab } from '@codemirror/commands';
import { HighlightStyle, StreamLanguage, bracketMatching, indentUnit, syntaxHighlighting } from '@codemirror/language';
import { setDiagnostics } from '@codemirror/lint';
import { EditorState, RangeSet, StateEffect, StateField } from '@codemirror/state';
import { EditorView, GutterMarker, drawSelection, gutter, highlightActiveLine, highlightActiveLineGutter, keymap, lineNumbers } from '@codemirror/view';
import { tags } from '@lezer/highlight';
import catalogue from './generated/catalogue.json';
import { signs } from './dom';
import type { Message, Statement, Suggestion } from './protocol';

const WORDS = new Map(catalogue.words as [string, string][]);

const language = StreamLanguage.define({
  name: 'basis',
  token(stream) {
    if (stream.eatSpace()) return null;
    if (stream.match(/\/\/[/!].*/)) return 'docComment';
    if (stream.match(/\/\/.*/)) return 'comment';
    if (stream.match(/"[^"]*"?/)) return 'string';
    if (stream.match(/\d+(\.\d+)?/)) return 'number';
    const word = stream.match(/[\p{L}_][\p{L}\p{N}_]*/u) as RegExpMatchArray | null;
    if (word) {
      const kind = WORDS.get(word[0]);
      if (kind === undefined) return 'variableName';
      return kind === 'Function' || kind === 'Property' ? 'propertyName' : 'keyword';
    }
    stream.next();
    return null;
  },
  languageData: { commentTokens: { line: '//' } },
  tokenTable: { docComment: tags.docComment },
});

const colours = HighlightStyle.define([
  { tag: tags.keyword, color: 'var(--keyword)', fontWeight: '600' },
  { tag: tags.propertyName, color: 'var(--property)' },
  { tag: tags.number, color: 'var(--number)' },
  { tag: tags.string, color: 'var(--string)' },
  { tag: [tags.comment, tags.docComment], color: 'var(--comment)', fontStyle: 'italic' },
]);

/** How a statement stands: its sign, and whether that is what its author declares. */
export function standing(s: Statement): { sign: string; kind: string; words: string } {
  const decided = s.proved + s.refuted + s.undecided;
  if (s.unexpected === 0 && !s.complete) return { sign: '…', kind: 'open', words: 'not decided yet' };
  const parts = [[s.proved, 'proved'], [s.refuted, 'refuted'], [s.undecided, 'undecided']] as const;
  const words = parts.filter(([n]) => n > 0).map(([n, word]) => (n === decided && n === 1 ? word : `${n} ${word}`)).join(', ');
  if (s.undecided > 0 && s.unexpected > 0 && s.refuted === 0) return { sign: '?', kind: 'undecided', words };
  const sign = s.unexpected > 0 ? (s.refuted > 0 && s.declared !== 'refute' ? '✗' : '✓') : s.refuted > 0 && s.proved === 0 ? '✗' : s.undecided > 0 ? '?' : '✓';
  return { sign, kind: s.unexpected > 0 ? 'wrong' : 'right', words };
}

class Verdict extends GutterMarker {
  constructor(readonly sign: string, readonly kind: string, readonly title: string, readonly index: number) {
    super();
  }

  override eq(other: Verdict): boolean {
    return this.sign === other.sign && this.kind === other.kind && this.title === other.title && this.index === other.index;
  }

  override toDOM(): Node {
    const mark = document.createElement('span');
    mark.className = `verdict ${this.kind}`;
    mark.textContent = this.sign;
    mark.title = this.title;
    mark.dataset['statement'] = String(this.index);
    return mark;
  }
}

const setVerdicts = StateEffect.define<Statement[]>();

const verdicts = StateField.define<RangeSet<Verdict>>({
  create: () => RangeSet.empty,
  update(marks, transaction) {
    marks = marks.map(transaction.changes);
    for (const effect of transaction.effects) {
      if (!effect.is(setVerdicts)) continue;
      const { doc } = transaction.state;
      // Of several statements on a line the worst one.
      const rank = ['right', 'open', 'undecided', 'wrong'];
      const lines = new Map<number, Verdict>();
      effect.value.forEach((s, k) => {
        const { sign, kind, words } = standing(s);
        const reason = s.claims[0]?.reason ?? '';
        const title = signs(`${words}${reason ? `: ${reason}` : ''}`);
        const line = doc.lineAt(Math.min(s.from, doc.length)).from;
        const known = lines.get(line);
        if (!known || rank.indexOf(kind) > rank.indexOf(known.kind)) lines.set(line, new Verdict(sign, kind, title, k));
      });
      marks = RangeSet.of([...lines].map(([line, mark]) => mark.range(line)), true);
    }
    return marks;
  },
});

export interface Hooks {
  changed(text: string): void;
  complete(text: string, at: number): Promise<Suggestion[]>;
  /** A mark in the gutter was clicked. */
  picked(statement: number): void;
}

export class Editor {
  readonly view: EditorView;
  private quiet = false;

  constructor(parent: HTMLElement, hooks: Hooks) {
    const complete = async (context: CompletionContext): Promise<CompletionResult | null> => {
      const word = context.matchBefore(/\\?[\p{L}\p{N}_]+|\\/u);
      if (!word && !context.explicit) return null;
      const all = await hooks.complete(context.state.doc.toString(), context.pos);
      if (!all.length || context.aborted) return null;
      const options = all.map((s) => ({
        label: s.label,
        detail: undefined,
        info: s.meaning || undefined,
        apply: (view: EditorView, _: unknown, from: number, to: number) => {
          const [before, after] = s.insert.includes('$0') ? (s.insert.split('$0') as [string, string]) : [s.insert, ''];
          view.dispatch({ changes: { from, to, insert: before + after }, selection: { anchor: from + before.length } });
        },
      }));
      return { from: all[0]!.from, options, filter: !word?.text.startsWith('\\') };
    };
    this.view = new EditorView({
      parent,
      state: EditorState.create({
        extensions: [
          verdicts,
          gutter({
            class: 'verdicts',
            markers: (view) => view.state.field(verdicts),
            initialSpacer: () => new Verdict('✓', 'right', '', -1),
            domEventHandlers: {
              mousedown: (view, line) => {
                view.state.field(verdicts).between(line.from, line.from, (_from, _to, mark) => hooks.picked(mark.index));
                return false;
              },
            },
          }),
          lineNumbers(),
          highlightActiveLineGutter(),
          highlightActiveLine(),
          history(),
          drawSelection(),
          bracketMatching(),
          indentUnit.of('    '),
          language,
          syntaxHighlighting(colours),
          autocompletion({ override: [complete] }),
          EditorView.lineWrapping,
          EditorView.contentAttributes.of({ 'aria-label': 'spec', spellcheck: 'false', autocapitalize: 'off' }),
          EditorView.updateListener.of((update) => {
            if (update.docChanged && !this.quiet) hooks.changed(update.state.doc.toString());
          }),
          keymap.of([...completionKeymap, ...defaultKeymap, ...historyKeymap, indentWithTab]),
        ],
      }),
    });
  }

  get text(): string {
    return this.view.state.doc.toString();
  }

  set(text: string): void {
    this.quiet = true;
    this.view.dispatch({ changes: { from: 0, to: this.view.state.doc.length, insert: text }, selection: { anchor: 0 }, scrollIntoView: true });
    this.quiet = false;
  }

  insert(at: number, text: string): void {
    this.view.dispatch({ changes: { from: at, insert: text }, selection: { anchor: at + text.length }, scrollIntoView: true });
  }

  show(statements: Statement[], messages: Message[]): void {
    const { length } = this.view.state.doc;
    const inside = (at: number) => Math.max(0, Math.min(at, length));
    const all = messages.map((m) => ({ from: inside(m.from), to: inside(Math.max(m.to, m.from)), severity: m.severity, message: signs(m.message) }));
    this.view.dispatch({ effects: setVerdicts.of(statements) }, setDiagnostics(this.view.state, all));
  }

  /** Puts the cursor at a place and shows it. */
  go(at: number): void {
    this.view.dispatch({ selection: { anchor: Math.min(at, this.view.state.doc.length) }, effects: EditorView.scrollIntoView(at, { y: 'center' }) });
  }
}

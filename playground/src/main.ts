// The page: the text at the left, and at the right what follows from it.
import { Curves, type Mark } from './curves';
import { byId, h, signs } from './dom';
import { Editor, standing } from './editor';
import { Engine } from './engine';
import { violated } from './evaluate';
import catalogue from './generated/catalogue.json';
import { formula } from './math';
import { isRefusal, type Claim, type Drawing, type Facts, type FunctionFacts, type Formula, type Item, type Library, type Statement, type Verdicts } from './protocol';
import { decode, encode, type State } from './share';
import { Surfaces } from './surfaces';

const FIRST = catalogue.first;
const TABS = ['text', 'functions', 'plot', 'verdicts', 'code', 'library'] as const;
type Tab = (typeof TABS)[number];

/** What is shown of the open spec. */
interface View {
  items: Item[];
  item: number;
  verdicts: Verdicts | undefined;
  /** By title, so that they stay when the text changes. */
  shapes: Map<string, Map<string, number>>;
  points: Map<string, number[][]>;
  mark: Mark | undefined;
  drawing: Drawing | undefined;
  picture: Curves | Surfaces | undefined;
  tab: Tab;
  library: Library | undefined;
  /** The claim that is to be shown in the picture once the family is drawn. */
  wanted: Claim | undefined;
  /** Whether all that is shown belongs to the text as it is. */
  current: boolean;
}

const view: View = {
  items: [], item: 0, verdicts: undefined, shapes: new Map(), points: new Map(), mark: undefined, drawing: undefined,
  picture: undefined, tab: 'plot', library: undefined, wanted: undefined, current: false,
};

const status = byId('status');
const family = byId('family') as HTMLSelectElement;
const panel = (tab: Tab): HTMLElement => byId(`panel-${tab}`);

const engine = new Engine({
  opened(items, claims) {
    document.body.classList.toggle('stale', items.length === 0 && view.items.length > 0);
    // What is shown stays while the text cannot be read.
    if (items.length === 0 && view.items.length > 0) return;
    const before = wantedFamily ?? view.items[view.item]?.title;
    view.items = items;
    wantedFamily = undefined;
    const same = items.findIndex((item) => item.title === before);
    const own = items.findIndex((item) => item.own);
    view.item = same >= 0 ? same : Math.max(0, own);
    family.replaceChildren(...items.map((item, k) => h('option', { value: k }, item.kind === 'family' ? item.title : `${item.kind} ${item.name}`)));
    family.disabled = items.length === 0;
    family.value = String(view.item);
    if (claims > 0) say(`${claims} claims …`);
    view.current = true;
    void refresh();
  },
  verdicts(verdicts, decided, milliseconds, stopped) {
    view.verdicts = verdicts;
    editor.show(verdicts.statements, verdicts.messages);
    if (verdicts.done || stopped) doing('done');
    summary(verdicts, decided, milliseconds, stopped);
    if (view.tab === 'verdicts') showVerdicts();
    if (view.tab === 'code' && verdicts.done) void showCode();
    if (verdicts.done && performance.getEntriesByName('first-verdict').length === 0) performance.mark('first-verdict');
  },
  failed(message) {
    doing('failed');
    say(message, 'wrong');
  },
});

let wantedFamily: string | undefined;
let pause: ReturnType<typeof setTimeout> | undefined;

const editor = new Editor(byId('editor'), {
  changed(text) {
    clearTimeout(pause);
    doing('deciding');
    view.current = false;
    view.mark = undefined;
    pause = setTimeout(() => { engine.open(text); remember(); }, 60);
  },
  async complete(text, at) {
    const answer = await engine.ask<{ suggestions: any[] }>({ ask: 'complete', text, at });
    return isRefusal(answer) ? [] : answer.suggestions;
  },
  picked(statement) {
    show('verdicts');
    const row = panel('verdicts').querySelector<HTMLElement>(`[data-statement="${statement}"]`);
    row?.scrollIntoView({ block: 'center' });
    row?.querySelector<HTMLElement>('button')?.focus();
  },
});

/** What the page does with the text: tests wait for it, and the style shows it. */
function doing(what: 'deciding' | 'done' | 'failed'): void {
  document.body.dataset['state'] = what;
}

function say(text: string, kind = ''): void {
  status.textContent = text;
  status.className = kind;
}

function summary(verdicts: Verdicts, decided: number, milliseconds: number, stopped: boolean): void {
  const count = (key: 'proved' | 'refuted' | 'undecided' | 'unexpected') => verdicts.statements.reduce((sum, s) => sum + s[key], 0);
  const errors = verdicts.messages.filter((m) => m.severity === 'error').length;
  const parts = [`${count('proved')} proved`, `${count('refuted')} refuted`];
  if (count('undecided')) parts.push(`${count('undecided')} undecided`);
  if (errors) parts.push(`${errors} ${errors === 1 ? 'error' : 'errors'}`);
  if (stopped) parts.push(`stopped after ${Math.round(milliseconds / 1000)} s, ${decided} claims decided`);
  else if (verdicts.done) parts.push(`${milliseconds < 10 ? milliseconds.toFixed(1) : Math.round(milliseconds)} ms`);
  else parts.push('…');
  say(parts.join(' · '), errors || stopped ? 'wrong' : verdicts.done ? 'right' : '');
}

// Tabs

function show(tab: Tab): void {
  view.tab = tab;
  document.body.dataset['tab'] = tab;
  for (const other of TABS) {
    const button = byId(`tab-${other}`);
    button.setAttribute('aria-selected', String(other === tab));
    button.tabIndex = other === tab ? 0 : -1;
    if (other !== 'text') panel(other).hidden = other !== tab;
  }
  void refresh();
  remember();
}

for (const tab of TABS) {
  byId(`tab-${tab}`).addEventListener('click', () => show(tab));
}
byId('tabs').addEventListener('keydown', (e) => {
  const seen = TABS.filter((tab) => byId(`tab-${tab}`).offsetParent !== null);
  const step = e.key === 'ArrowRight' ? 1 : e.key === 'ArrowLeft' ? -1 : 0;
  if (!step) return;
  e.preventDefault();
  const next = seen[(seen.indexOf(view.tab) + step + seen.length) % seen.length]!;
  show(next);
  byId(`tab-${next}`).focus();
});

async function refresh(): Promise<void> {
  switch (view.tab) {
    case 'functions': return showFunctions();
    case 'plot': return showPlot();
    case 'verdicts': return showVerdicts();
    case 'code': return showCode();
    case 'library': return showLibrary();
    default:
  }
}

const item = (): Item | undefined => view.items[view.item];

family.addEventListener('change', () => {
  view.item = Number(family.value);
  view.mark = undefined;
  void refresh();
  remember();
});

/** A question about the family that is shown; nothing where another one is shown by the time of the answer. */
async function about<T extends object>(question: Record<string, unknown>): Promise<T | string | undefined> {
  const [wanted, items] = [view.item, view.items];
  const answer = await engine.ask<T>({ ...question, item: wanted });
  if (view.item !== wanted || view.items !== items) return undefined;
  if (isRefusal(answer)) return document.body.classList.contains('stale') ? UNREAD : answer.error;
  return answer;
}

const UNREAD = 'The text declares no family that can be read. The messages stand below its lines.';

const nothing = (): HTMLElement =>
  h('p', { class: 'hint' }, view.items.length || !view.current ? '' : UNREAD);

// Functions

async function showFunctions(): Promise<void> {
  if (!item()) return panel('functions').replaceChildren(nothing());
  const facts = await about<Facts>({ ask: 'facts' });
  if (facts === undefined) return;
  if (typeof facts === 'string') return panel('functions').replaceChildren(h('p', { class: 'wrong' }, facts));
  const into: Node[] = [h('h2', {}, facts.title)];
  if (facts.doc.length) into.push(h('p', {}, facts.doc.filter((line) => line.trim()).join(' ')));
  const domain = [...(facts.domain ?? []), ...(facts.shapes ?? []).map((s) => s.declared), ...(facts.conditions ?? [])];
  if (domain.length) into.push(h('p', { class: 'domain' }, ...domain.flatMap((f, k) => [k ? ',  ' : '', formula(f)])));
  for (const patch of facts.patches ?? []) into.push(h('p', {}, `${patch.name} = ${patch.written}`));
  const spans = facts.spans?.length ? facts.spans : [{ domain: [], functions: facts.functions ?? [] }];
  if (spans.some((s) => s.functions.length)) {
    const forms = h('select', { 'aria-label': 'form of the formulas' }, h('option', { value: 'factored' }, 'factored'), h('option', { value: 'expanded' }, 'expanded'));
    const bernstein = spans.some((s) => s.functions.some((f) => f.bernstein.length));
    if (bernstein) forms.append(h('option', { value: 'bernstein' }, 'Bernstein coefficients'));
    const list = h('div', { class: 'formulas' });
    const fill = () => {
      const form = forms.value as 'factored' | 'expanded' | 'bernstein';
      const row = (f: FunctionFacts): HTMLElement => {
        const right = form === 'bernstein'
          ? h('span', {}, ...f.bernstein.flatMap((c, k) => [k ? ',  ' : '', formula(c)]))
          : formula(f[form]);
        const line = h('div', { class: 'formula' }, formula(f.label), h('span', { class: 'equals' }, form === 'bernstein' ? ':' : '='), right);
        if (form !== 'bernstein' && f.between) line.append(h('span', { class: 'hint' }, '  between ', formula(f.between[0]), ' and ', formula(f.between[1])));
        return line;
      };
      list.replaceChildren(...spans.flatMap((s) => [...s.domain.map((d) => h('div', { class: 'formula hint' }, 'on ', formula(d))), ...s.functions.map(row)]));
    };
    forms.addEventListener('change', fill);
    fill();
    into.push(h('label', { class: 'pick' }, 'Formulas ', forms), list);
  }
  const ends = h('div');
  into.push(ends);
  if (facts.points?.length) into.push(h('h3', {}, 'Control points that it determines'), h('div', { class: 'formulas' }, ...facts.points.map((f) => h('div', { class: 'formula' }, formula(f)))));
  panel('functions').replaceChildren(...into);
  if (!facts.functions) return;
  const more = await about<{ ends: Formula[] }>({ ask: 'ends' });
  if (typeof more !== 'object' || !more.ends.length) return;
  ends.replaceChildren(h('h3', {}, 'At the ends'), h('div', { class: 'formulas' }, ...more.ends.map((f) => h('div', { class: 'formula' }, formula(f)))));
}

// Plot

function values(drawing: Drawing): number[] {
  const known = view.shapes.get(drawing.title);
  return drawing.shapes.map((s) => {
    const value = known?.get(s.name) ?? s.value;
    return Math.max(s.open[0] ? -Infinity : s.low, Math.min(s.open[1] ? Infinity : s.high, value));
  });
}

async function showPlot(): Promise<void> {
  const into = panel('plot');
  if (!item()) return into.replaceChildren(nothing());
  if (item()!.kind !== 'family') return into.replaceChildren(h('h2', {}, item()!.title), h('p', { class: 'hint' }, 'Joins and theorems have no picture. Choose a family above.'));
  const drawing = await about<Drawing>({ ask: 'draw' });
  if (drawing === undefined) return;
  if (typeof drawing === 'string') return into.replaceChildren(h('p', { class: 'wrong' }, drawing));
  view.drawing = drawing;
  if (view.wanted) {
    const { witness, text, item: of } = view.wanted;
    if (of === view.item && witness?.at) {
      const shapes = new Map(drawing.shapes.filter((s) => s.name in witness.at!).map((s) => [s.name, witness.at![s.name]!]));
      view.shapes.set(drawing.title, new Map([...(view.shapes.get(drawing.title) ?? []), ...shapes]));
      view.mark = { at: witness.at, function: witness.function ?? null, text: `${text} fails at ${witness.point}` };
    }
    view.wanted = undefined;
  }
  const now = values(drawing);
  const points = controlPoints(drawing);
  const note = h('p', { class: 'mark-note', role: 'status', hidden: true });
  const conditions = h('p', { class: 'wrong', hidden: true });
  const moved = () => { view.points.set(drawing.title, points); remember(); };
  const picture = drawing.kind === 'interval' ? new Curves(drawing, now, points, moved) : new Surfaces(drawing, now, points, moved);
  const change = () => {
    view.shapes.set(drawing.title, new Map(drawing.shapes.map((s, k) => [s.name, now[k]!])));
    note.hidden = !view.mark;
    note.textContent = view.mark ? signs(view.mark.text) : '';
    const broken = violated(drawing, now);
    conditions.hidden = broken.length === 0;
    conditions.textContent = `Outside of what the family assumes: ${signs(broken.join(', '))}`;
    picture.set(now, view.mark);
  };
  const sliders = drawing.shapes.map((s, k) => slider(s, now[k]!, (value) => {
    now[k] = value;
    view.mark = undefined;
    change();
    remember();
  }));
  const title = h('h2', {}, drawing.title);
  into.replaceChildren(title, h('div', { class: 'sliders' }, ...sliders.flat()), conditions, note, picture.element);
  view.picture = picture;
  change();
  picture.resize();
}

/** As many control points as there are functions; of a curve in an arc, of a surface empty until it is drawn. */
function controlPoints(drawing: Drawing): number[][] {
  const n = drawing.labels.length;
  const size = drawing.kind === 'interval' ? 2 : 3;
  const known = view.points.get(drawing.title);
  if (known && known.length === n && known.every((p) => p.length === size && p.every(Number.isFinite))) return known;
  const points = drawing.kind === 'interval' ? Curves.start(n) : [];
  view.points.set(drawing.title, points);
  return points;
}

function slider(s: Drawing['shapes'][number], value: number, changed: (value: number) => void): HTMLElement[] {
  const id = `shape-${s.name}`;
  const span = s.high - s.low;
  const [low, high] = [s.low + (s.excluded[0] ? span / 1000 : 0), s.high - (s.excluded[1] ? span / 1000 : 0)];
  const slide = h('input', { type: 'range', id, min: low, max: high, step: 'any', value });
  const box = h('input', { type: 'number', min: low, max: high, step: 'any', value: Number(value.toPrecision(6)), 'aria-label': `value of ${s.name}` });
  const set = (from: HTMLInputElement, to: HTMLInputElement) => {
    const v = Number(from.value);
    const fits = from.value !== '' && Number.isFinite(v) && v >= low - 1e-9 && (s.open[1] || v <= high + 1e-9);
    box.setAttribute('aria-invalid', String(!fits));
    if (!fits) return;
    to.value = String(Number(v.toPrecision(6)));
    changed(v);
  };
  slide.addEventListener('input', () => set(slide, box));
  slide.addEventListener('keydown', (e) => {
    const step = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1 }[e.key];
    if (!step) return;
    e.preventDefault();
    slide.value = String(Number(slide.value) + (step * span) / (e.shiftKey ? 1000 : 100));
    set(slide, box);
  });
  box.addEventListener('input', () => set(box, slide));
  const name = h('label', { for: id, title: s.doc.join(' ') }, s.name);
  return [name, slide, box, h('span', { class: 'range' }, signs(s.declared))];
}

// Verdicts

function showVerdicts(): void {
  const into = panel('verdicts');
  const { verdicts } = view;
  if (!verdicts) return into.replaceChildren(h('p', { class: 'hint' }, 'Nothing is decided yet.'));
  const nodes: Node[] = [];
  for (const m of verdicts.messages.filter((m) => !verdicts.statements.some((s) => s.from <= m.from && m.to <= s.to && m.to > 0))) {
    const [first, ...rest] = signs(m.message).split('\n');
    const button = h('button', { type: 'button', class: 'message' }, h('span', { class: 'verdict wrong' }, m.severity === 'error' ? '!' : '·'), h('span', {}, h('b', {}, `${m.severity}: ${first}`), ...rest.map((line) => h('small', {}, line.replace(/^ *= */, '')))));
    button.addEventListener('click', () => { showText(); editor.go(m.from); });
    nodes.push(button);
  }
  const groups = new Map<string, [Statement, number][]>();
  verdicts.statements.forEach((s, k) => {
    const group = groups.get(s.about ?? '') ?? [];
    group.push([s, k]);
    groups.set(s.about ?? '', group);
  });
  for (const [title, statements] of groups) {
    nodes.push(h('h3', {}, title), h('ul', { class: 'claims' }, ...statements.map(([s, k]) => row(s, k))));
    if (title.startsWith('family ')) nodes.push(finder(title.slice('family '.length)));
  }
  if (verdicts.unlisted) nodes.push(h('p', { class: 'hint' }, `${verdicts.unlisted} further statements are not listed.`));
  if (!verdicts.statements.length && !nodes.length) nodes.push(h('p', { class: 'hint' }, 'The text makes no claims.'));
  const without = view.items.filter((i, k) => i.own && i.kind === 'family' && !groups.has(`family ${i.name}`) && view.items.findIndex((j) => j.name === i.name) === k);
  for (const i of without) nodes.push(h('h3', {}, `family ${i.name}`), h('p', { class: 'hint' }, 'It makes no claims.'), finder(i.name));
  into.replaceChildren(...nodes);
}

function row(s: Statement, k: number): HTMLElement {
  const { sign, kind, words } = standing(s);
  const reasons = s.claims.filter((c) => c.verdict !== 'proved' || s.claims.length === 1).slice(0, 3);
  const several = s.proved + s.refuted + s.undecided > 1;
  const button = h('button', { type: 'button' },
    h('span', { class: `verdict ${kind}` }, sign),
    h('span', {}, h('span', { class: 'claim' }, h('b', {}, s.declared ?? ''), ` ${signs(s.text ?? '')}`, s.at ? h('span', { class: 'hint' }, ` at ${s.at}`) : ''),
      h('small', { class: kind }, several ? words : '', ...reasons.flatMap((c, j) => reason(c, several, j)))));
  const jump = s.claims.find((c) => c.witness?.at);
  button.addEventListener('click', () => {
    editor.go(s.from);
    if (jump) look(jump);
    else showText();
  });
  if (jump) button.append(h('span', { class: 'jump', title: 'show the counterexample in the plot' }, 'show ↗'));
  return h('li', { 'data-statement': k, class: kind }, button);
}

function reason(c: Claim, several: boolean, j: number): (Node | string)[] {
  const about = several ? `${j || several ? ' · ' : ''}${c.title}: ` : '';
  const text = c.verdict === 'proved' ? `proved by ${c.reason}` : c.verdict === 'refuted' ? `refuted: ${c.reason}` : `undecided: ${c.reason}`;
  return [`${about}${signs(text)}`];
}

/** On a phone, the text; elsewhere it is there anyway. */
function showText(): void {
  if (byId('tab-text').offsetParent !== null) show('text');
  else editor.view.focus();
}

/** The sliders jump to a counterexample, and its point is marked. */
function look(claim: Claim): void {
  if (claim.item !== null) {
    view.item = claim.item;
    family.value = String(claim.item);
  }
  view.wanted = claim;
  show('plot');
}

/** A button that looks for claims that hold, and inserts them. */
function finder(name: string): HTMLElement {
  const into = h('div', { class: 'finder' });
  const button = h('button', { type: 'button', class: 'plain' }, 'Find more that holds');
  button.addEventListener('click', async () => {
    button.disabled = true;
    button.textContent = 'Looking …';
    const { text } = editor;
    const place = view.items.findIndex((i) => i.name === name && i.kind === 'family');
    const answer = await engine.ask<{ at: number | null; statements: string[] }>({ ask: 'holds', item: place });
    button.remove();
    if (isRefusal(answer)) return into.append(h('p', { class: 'wrong' }, answer.error));
    if (editor.text !== text) return into.append(h('p', { class: 'hint' }, 'The text has changed meanwhile.'));
    if (!answer.statements.length || answer.at === null) return into.append(h('p', { class: 'hint' }, 'Nothing else is known to hold.'));
    const code = answer.statements.map((s) => s.split('\n').map((line) => `    ${line}`).join('\n')).join('\n');
    const insert = h('button', { type: 'button', class: 'plain' }, 'Insert these claims');
    insert.addEventListener('click', () => {
      const before = editor.text.slice(0, answer.at!);
      editor.insert(answer.at!, `${before.endsWith('\n') ? '' : '\n'}${code}\n`);
    });
    into.append(h('pre', {}, code), insert);
  });
  into.append(button);
  return into;
}

// Code

let language = '';

async function showCode(): Promise<void> {
  const into = panel('code');
  if (!item()) return into.replaceChildren(nothing());
  const languages = catalogue.languages as [string, string][];
  if (!languages.some(([to]) => to === language)) language = languages[0]?.[0] ?? '';
  const answer = await about<{ code: string; command: string }>({ ask: 'code', to: language });
  if (answer === undefined) return;
  const pick = h('select', { 'aria-label': 'language' }, ...languages.map(([to, name]) => h('option', { value: to, selected: to === language }, name)));
  pick.addEventListener('change', () => { language = pick.value; void showCode(); });
  const head = h('p', { class: 'bar' }, h('label', { class: 'pick' }, 'Language ', pick));
  if (typeof answer === 'string') return into.replaceChildren(head, h('p', { class: 'wrong pre' }, signs(answer)));
  head.append(copier('Copy', () => answer.code));
  into.replaceChildren(head, h('p', { class: 'hint' }, 'The same as ', h('code', {}, answer.command)), h('pre', { class: 'code', tabindex: 0 }, answer.code));
}

function copier(label: string, text: () => string): HTMLElement {
  const button = h('button', { type: 'button', class: 'plain' }, label);
  button.addEventListener('click', async () => {
    try {
      await navigator.clipboard.writeText(text());
      button.textContent = 'Copied';
    } catch {
      button.textContent = 'The browser does not allow copying';
    }
    setTimeout(() => { button.textContent = label; }, 1500);
  });
  return button;
}

// Library

async function library(): Promise<Library | undefined> {
  if (view.library) return view.library;
  const answer = await engine.ask<Library>({ ask: 'library' });
  if (!isRefusal(answer)) view.library = answer;
  return view.library;
}

/** The text of one spec of the library. */
async function shipped(name: string): Promise<string | undefined> {
  const answer = await engine.ask<{ text: string }>({ ask: 'spec', name });
  return isRefusal(answer) ? undefined : answer.text;
}

async function showLibrary(): Promise<void> {
  const into = panel('library');
  const all = await library();
  if (!all || view.tab !== 'library' || into.childElementCount) return;
  const counts = new Map((catalogue.specs as { name: string; title: string; proved: number; refuted: number }[]).map((s) => [s.name, s]));
  const list = h('ul', { class: 'library' }, ...all.specs.map((spec) => {
    const known = counts.get(spec.name);
    const names = spec.items.filter((i) => i.kind === 'family').map((i) => i.name);
    const others = spec.items.length - names.length;
    const button = h('button', { type: 'button', 'data-spec': spec.name },
      h('b', {}, spec.name), h('span', {}, known?.title ?? ''),
      h('small', {}, [names.join(', '), others ? `${others} ${others === 1 ? 'theorem or join' : 'theorems and joins'}` : '', known ? `${known.proved} claims proved, ${known.refuted} refuted` : ''].filter(Boolean).join(' · ')));
    button.addEventListener('click', () => { open(spec.text); show(isWide() ? 'verdicts' : 'text'); });
    return h('li', {}, button);
  }));
  const papers = (catalogue.papers as { name: string; title: string; wrong: { id: string; statement: string; remark: string }[] }[]).filter((p) => p.wrong.length);
  const wrong = papers.flatMap((p) => {
    const button = h('button', { type: 'button', class: 'plain' }, 'Open the spec with the proofs');
    button.addEventListener('click', () => { open(all.specs.find((s) => s.name === p.name)?.text ?? ''); show('verdicts'); });
    return [h('h4', {}, p.title), h('dl', {}, ...p.wrong.flatMap((w) => [
      h('dt', {}, h('span', { class: 'verdict wrong' }, '✗'), ` ${w.statement || w.id}`),
      h('dd', {}, w.remark ? `True instead: ${w.remark}` : 'Refuted; nothing is known instead.')])), button];
  });
  into.replaceChildren(h('h2', {}, 'Shipped specs'), h('p', { class: 'hint' }, 'A click opens one in place of the text; undo brings the text back.'), list, h('h2', { id: 'literature' }, 'What the literature has wrong'), h('p', { class: 'hint' }, 'Published statements that are refuted here, each with an exact counterexample in the spec.'), ...wrong);
}

/** Replaces the text, as an edit that can be undone. */
function open(text: string): void {
  doing('deciding');
  editor.set(text);
  view.items = [];
  view.mark = undefined;
  view.verdicts = undefined;
  engine.open(text);
  remember();
}

// Address

let last = '';
let saving: ReturnType<typeof setTimeout> | undefined;

async function state(): Promise<State> {
  const { text } = editor;
  const named = (await library())?.specs.find((s) => s.text === text)?.name;
  const title = item()?.title;
  const now: State = named === undefined ? { text } : { library: named };
  if (title !== undefined) {
    now.family = title;
    const shapes = view.drawing?.title === title && view.drawing.shapes.length ? values(view.drawing) : [];
    if (shapes.length && view.shapes.has(title)) now.shapes = Object.fromEntries(view.drawing!.shapes.map((s, k) => [s.name, shapes[k]!]));
    const points = view.points.get(title);
    if (points?.length) now.points = points;
  }
  if (view.tab !== 'plot') now.tab = view.tab;
  return now;
}

/** Keeps the state in the address, so that reloading the page loses nothing. */
function remember(): void {
  clearTimeout(saving);
  saving = setTimeout(async () => {
    const fragment = await encode(await state());
    last = `#${fragment}`;
    history.replaceState(null, '', last);
  }, 400);
}

byId('share').addEventListener('click', async () => {
  clearTimeout(saving);
  last = `#${await encode(await state())}`;
  history.replaceState(null, '', last);
  try {
    await navigator.clipboard.writeText(location.href);
    say('The link is copied; it holds the text, the shape values and the control points.', 'right');
  } catch {
    say('The link stands in the address bar; it holds the text, the shape values and the control points.', 'right');
  }
});

async function restore(): Promise<void> {
  const wanted = await decode(location.hash.slice(1));
  const text = typeof wanted?.text === 'string' ? wanted.text : (await shipped(String(wanted?.library ?? FIRST))) ?? (await shipped(FIRST)) ?? '';
  if (location.hash.length > 1 && !wanted) say('The link is damaged; here is a spec of the library instead.', 'wrong');
  doing('deciding');
  view.items = [];
  view.mark = undefined;
  const title = wanted?.family;
  wantedFamily = title;
  if (typeof title === 'string') {
    if (Array.isArray(wanted?.points)) view.points.set(title, wanted.points);
    const shapes = Object.entries(wanted?.shapes ?? {}).filter(([, value]) => Number.isFinite(value));
    view.shapes.set(title, new Map(shapes));
  }
  editor.set(text);
  engine.open(text);
  const tab = TABS.find((t) => t === wanted?.tab) ?? (isWide() ? 'plot' : 'text');
  show(tab);
}

const isWide = (): boolean => matchMedia('(min-width: 820px)').matches;

addEventListener('hashchange', () => { if (location.hash !== last) void restore(); });
addEventListener('resize', () => { if (view.tab === 'plot') view.picture?.resize(); });
byId('format').addEventListener('click', async () => {
  const { text } = editor;
  const answer = await engine.ask<{ text: string }>({ ask: 'format', text });
  if (isRefusal(answer)) say(`The layout stays: ${answer.error}`, 'wrong');
  else if (answer.text !== text && editor.text === text) {
    editor.set(answer.text);
    engine.open(answer.text);
    remember();
  }
});
void restore();

// Families on an interval: the functions, and a curve whose control points are dragged.
import { colour, dashes, h, number, svg, ticks } from './dom';
import { Functions, type Sample } from './evaluate';
import type { Drawing } from './protocol';

/** A counterexample in the picture. */
export interface Mark { at: Record<string, number>; function: number | null; text: string }

type Place = (x: number, y: number) => [number, number];
type Range = [number, number];

const LEFT = 50;
const BOTTOM = 38;
const RIGHT = 14;
const TOP = 10;

/** Two charts of one family. */
export class Curves {
  readonly element = h('div', { class: 'charts' });
  private readonly chart = svg('svg', { role: 'img', 'aria-label': 'the basis functions', class: 'functions' });
  private readonly plane = svg('svg', { 'aria-label': 'a curve with control points to drag', class: 'plane' });
  private readonly hidden = new Set<number>();
  private functions: Functions;
  private samples: Sample[] = [];
  private mark: Mark | undefined;
  /** The part of the plane that is seen; it follows the points when they are let go. */
  private view: { x: Range; y: Range } = { x: [0, 1], y: [0, 1] };

  constructor(private readonly drawing: Drawing, values: number[], private readonly points: number[][], private readonly moved: () => void) {
    this.functions = new Functions(drawing, values);
    const hint = h('p', { class: 'hint' }, 'Drag the control points, or move one with the arrow keys.');
    this.element.append(h('figure', {}, this.chart, this.legend()));
    // One function makes no curve.
    if (drawing.labels.length > 1) this.element.append(h('figure', {}, this.plane, hint));
    this.sample();
  }

  static start(n: number): number[][] {
    return Array.from({ length: n }, (_, k) => (n === 1 ? [0, 0] : [(4 * k) / (n - 1), Math.sin((Math.PI * k) / (n - 1)) * 2]));
  }

  set(values: number[], mark: Mark | undefined): void {
    this.functions = new Functions(this.drawing, values);
    this.mark = mark;
    if (mark && mark.function !== null) this.hidden.delete(mark.function);
    this.sample();
    this.draw();
  }

  private sample(): void {
    // Fewer points where there are many functions: the picture follows a slider.
    const cost = this.drawing.labels.length * (this.drawing.spans[0]?.functions.length ?? 1);
    this.samples = this.functions.samples(cost > 900 ? 100 : 240);
  }

  resize(): void {
    this.fit();
    this.draw();
  }

  private size(): [number, number] {
    const own = this.element.clientWidth || 560;
    const w = Math.max(300, Math.min(640, own));
    // On a phone letters keep their size; on a screen both charts are seen together.
    return [w, Math.round(w < 480 ? w * 0.62 : Math.max(210, Math.min(w * 0.6, innerHeight * 0.34)))];
  }

  private legend(): HTMLElement {
    const n = this.drawing.labels.length;
    const one = (label: string, k: number) => {
      const button = h('button', { type: 'button', 'aria-pressed': 'true' }, svg('svg', { class: 'key', viewBox: '0 0 22 6', width: 22, height: 6, 'aria-hidden': 'true' }, svg('line', { x1: 0, x2: 22, y1: 3, y2: 3, stroke: colour(k, n), 'stroke-width': 3, 'stroke-dasharray': dashes(k, n) })), label);
      button.addEventListener('click', () => {
        if (!this.hidden.delete(k)) this.hidden.add(k);
        button.setAttribute('aria-pressed', String(!this.hidden.has(k)));
        this.draw();
      });
      return h('li', {}, button);
    };
    return h('ul', { class: 'legend', 'aria-label': 'functions to show' }, ...this.drawing.labels.map(one));
  }

  /** A chart with axes; the result turns a point into pixels. */
  private frame(into: SVGSVGElement, x: Range, y: Range, name: string): Place {
    const [w, height] = this.size();
    const at: Place = (px, py) => [
      LEFT + ((w - LEFT - RIGHT) * (px - x[0])) / (x[1] - x[0] || 1),
      TOP + ((height - BOTTOM - TOP) * (y[1] - py)) / (y[1] - y[0] || 1),
    ];
    into.setAttribute('viewBox', `0 0 ${w} ${height}`);
    into.replaceChildren();
    for (const t of ticks(...x, 6)) {
      const [px] = at(t, 0);
      into.append(
        svg('line', { x1: px, x2: px, y1: TOP, y2: height - BOTTOM, class: 'grid' }),
        svg('text', { x: px, y: height - BOTTOM + 17, 'text-anchor': 'middle' }, number(t)));
    }
    for (const t of ticks(...y, 5)) {
      const [, py] = at(0, t);
      into.append(
        svg('line', { x1: LEFT, x2: w - RIGHT, y1: py, y2: py, class: t === 0 ? 'axis' : 'grid' }),
        svg('text', { x: LEFT - 7, y: py + 4, 'text-anchor': 'end' }, number(t)));
    }
    into.append(svg('text', { x: (LEFT + w) / 2, y: height - 5, 'text-anchor': 'middle', 'font-style': 'italic' }, name));
    return at;
  }

  private static path(points: Range[], at: Place): string {
    let pen = 'M';
    return points.map(([x, y]) => {
      if (!Number.isFinite(y) || !Number.isFinite(x)) { pen = 'M'; return ''; }
      const word = pen + at(x, y).map((v) => v.toFixed(2)).join(' ');
      pen = 'L';
      return word;
    }).join('');
  }

  fit(): void {
    const range = (a: number): Range => [Math.min(...this.points.map((p) => p[a]!)), Math.max(...this.points.map((p) => p[a]!))];
    const [x, y] = [range(0), range(1)];
    const [w, height] = this.size();
    const [width, tall] = [w - LEFT - RIGHT, height - BOTTOM - TOP];
    const unit = Math.max((x[1] - x[0]) / width, (y[1] - y[0]) / tall, 0.002) * 1.3;
    const around = (r: Range, half: number): Range => [(r[0] + r[1]) / 2 - half, (r[0] + r[1]) / 2 + half];
    this.view = { x: around(x, (width / 2) * unit), y: around(y, (tall / 2) * unit) };
  }

  draw(): void {
    const n = this.drawing.labels.length;
    const seen = this.samples.flatMap((s) => s.values.filter((v, k) => Number.isFinite(v) && !this.hidden.has(k)));
    const low = Math.max(-1e6, seen.reduce((a, b) => Math.min(a, b), 0));
    const high = Math.min(1e6, seen.reduce((a, b) => Math.max(a, b), 0.1));
    const room = (high - low) * 0.05;
    const ends: Range = [this.samples[0]!.axis, this.samples.at(-1)!.axis];
    const at = this.frame(this.chart, ends, [low < 0 ? low - room : low, high + room], this.functions.axisName());
    this.drawing.spans.slice(1).forEach((_, k) => {
      const [px] = at(this.samples.find((s) => s.span === k + 1)!.axis, 0);
      this.chart.append(svg('line', { x1: px, x2: px, y1: TOP, y2: this.size()[1] - BOTTOM, class: 'knot' }));
    });
    this.drawing.labels.forEach((label, k) => {
      if (this.hidden.has(k)) return;
      const line = this.samples.map((s): Range => [s.axis, s.values[k]!]);
      this.chart.append(svg('path', { d: Curves.path(line, at), class: 'function', stroke: colour(k, n), 'stroke-dasharray': dashes(k, n), 'data-function': label }, svg('title', {}, label)));
    });
    this.drawMark(at);
    this.drawPlane();
  }

  private drawMark(at: Place): void {
    const t = this.mark?.at[this.drawing.variables[0] ?? ''];
    if (!this.mark || t === undefined) return;
    const span = this.functions.spanOf(t);
    const y = this.mark.function === null ? 0 : this.functions.at([t], span)[this.mark.function] ?? 0;
    const [px, py] = at(this.functions.axis(t, span), y);
    this.chart.append(
      svg('line', { x1: px, x2: px, y1: TOP, y2: this.size()[1] - BOTTOM, class: 'mark-line' }),
      svg('circle', { cx: px, cy: py, r: 6.5, class: 'counterexample' }, svg('title', {}, this.mark.text)));
  }

  private drawPlane(): void {
    const focus = document.activeElement instanceof SVGElement ? document.activeElement.dataset['point'] : undefined;
    const on = this.frame(this.plane, this.view.x, this.view.y, '');
    const places = this.points.map((p): Range => [p[0]!, p[1]!]);
    this.plane.append(svg('path', { d: Curves.path(places, on), class: 'polygon' }));
    const through = this.samples.map((s): Range => {
      let [x, y] = [0, 0];
      s.values.forEach((b, k) => { x += b * places[k]![0]; y += b * places[k]![1]; });
      return [x, y];
    });
    this.plane.append(svg('path', { d: Curves.path(through, on), class: 'curve' }));
    const few = places.length <= 16;
    // Names stand at the side of the point that is turned away from the others.
    const [mx, my] = on(places.reduce((sum, p) => sum + p[0], 0) / places.length, places.reduce((sum, p) => sum + p[1], 0) / places.length);
    const zero = on(0, 0)[1];
    places.forEach((p, k) => {
      const name = this.drawing.labels[k]!.replace(/^[^[]*/, 'P');
      const [px, py] = on(...p);
      const dot = svg('circle', { cx: px, cy: py, r: 7.5, class: 'point', tabindex: 0, 'data-point': k, role: 'slider', 'aria-label': `control point ${name}`, 'aria-valuenow': 0, 'aria-valuetext': p.map((v) => number(v, 3)).join(', ') }, svg('title', {}, `${name} = (${p.map((v) => number(v, 3)).join(', ')})`));
      dot.addEventListener('keydown', (e) => this.key(e, k));
      dot.addEventListener('pointerdown', (e) => this.drag(e, k));
      this.plane.append(dot);
      const far = Math.hypot(px - mx, py - my) || 1;
      const [dx, dy] = far < 2 ? [0, -1] : [(px - mx) / far, (py - my) / far];
      // The zero line does not run through a name.
      const away = py + 18 * dy - zero;
      const middle = Math.abs(away) < 16 ? zero + (away < 0 ? -16 : 16) : zero + away;
      if (few) this.plane.append(svg('text', { x: px + 22 * dx, y: middle + 4, 'text-anchor': 'middle', class: 'name' }, name));
      if (focus === String(k)) dot.focus();
    });
  }

  private unit(): number {
    return (this.view.x[1] - this.view.x[0]) / (this.size()[0] - LEFT - RIGHT);
  }

  private key(e: KeyboardEvent, k: number): void {
    const steps: Record<string, Range> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
    const step = steps[e.key];
    if (!step) return;
    e.preventDefault();
    const by = this.unit() * (e.shiftKey ? 1 : 6);
    const p = this.points[k]!;
    p[0]! += step[0] * by;
    p[1]! += step[1] * by;
    this.draw();
    this.moved();
  }

  private drag(e: PointerEvent, k: number): void {
    e.preventDefault();
    (e.currentTarget as SVGElement).focus();
    const p = this.points[k]!;
    const move = (m: PointerEvent) => {
      const box = this.plane.getBoundingClientRect();
      const scale = this.size()[0] / box.width;
      const unit = this.unit();
      p[0] = this.view.x[0] + ((m.clientX - box.left) * scale - LEFT) * unit;
      p[1] = this.view.y[1] - ((m.clientY - box.top) * scale - TOP) * unit;
      this.drawPlane();
    };
    const up = () => {
      removeEventListener('pointermove', move);
      removeEventListener('pointerup', up);
      removeEventListener('pointercancel', up);
      this.fit();
      this.draw();
      this.moved();
    };
    addEventListener('pointermove', move);
    addEventListener('pointerup', up);
    addEventListener('pointercancel', up);
  }
}

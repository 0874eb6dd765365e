// Families of several variables: one function as a map, and a surface whose control points are dragged.
import { h, number, svg, ticks } from './dom';
import type { Mark } from './curves';
import { Functions } from './evaluate';
import type { Drawing } from './protocol';

type Point = [number, number, number];
type Tone = [number, number, number];

const MAP = 360;
const STEPS = 90;
const ROOT = Math.sqrt(3) / 2;
const SCALE: Tone[] = [[58, 30, 110], [49, 80, 150], [30, 125, 140], [40, 160, 110], [130, 175, 50], [205, 165, 20]];

/** White for zero, through green and blue to violet for the largest value, red for negative ones. */
function tone(v: number, low: number, high: number): Tone {
  if (v < 0) {
    const a = low < 0 ? Math.min(1, v / low) : 1;
    return [255 - 95 * a, 225 - 215 * a, 215 - 185 * a];
  }
  const a = Math.min(1, high > 0 ? v / high : 0);
  const at = (1 - a) * 4.999;
  const k = Math.floor(at);
  const m = Math.min(1, 0.25 + 0.9 * a);
  const mix = (c: 0 | 1 | 2) => 250 * (1 - m) + m * (SCALE[k]![c] + (SCALE[k + 1]![c] - SCALE[k]![c]) * (at - k));
  return [mix(0), mix(1), mix(2)];
}

export class Surfaces {
  readonly element = h('div', { class: 'charts' });
  private readonly map = h('canvas', { width: MAP * 2, height: MAP * 2, role: 'img', class: 'map' });
  private readonly about = h('p', { class: 'hint' });
  private readonly scene = svg('svg', { 'aria-label': 'a surface with control points to drag', class: 'scene', tabindex: 0 });
  private readonly choice = h('select', { 'aria-label': 'function' });
  private functions: Functions;
  private mark: Mark | undefined;
  private readonly triangle: boolean;
  private readonly ranges: [number, number][];
  /** The values of all functions at the nodes of the surface, and the faces between nodes. */
  private nodes: { where: number[]; values: number[] }[] = [];
  private faces: number[][] = [];
  private yaw = -0.65;
  private pitch = 0.6;
  /** The middle of the picture, to the right and up, and the pixels of a unit. */
  private view = { right: 0, up: 0, unit: 1 };
  /** The place of the first of the two variables that are drawn, those of a simplex if there is one. */
  private readonly first: number;
  /** The places of the other variables, and the values at which the domain is cut. */
  private readonly others: number[];
  private readonly cut: number[];

  constructor(private readonly drawing: Drawing, values: number[], readonly points: number[][], private readonly moved: () => void) {
    this.functions = new Functions(drawing, values);
    this.triangle = drawing.simplices.length > 0;
    this.ranges = drawing.spans[0]!.ranges;
    this.first = drawing.simplices[0]?.[0] ?? 0;
    this.others = this.ranges.map((_, place) => place).filter((place) => place < this.first || place > this.first + 1);
    this.cut = this.others.map((place) => {
      const [a, b] = this.ranges[place]!;
      return this.simplexOf(place) ? 0.25 : (a + b) / 2;
    });
    drawing.labels.forEach((label, k) => this.choice.append(h('option', { value: k }, label)));
    this.choice.addEventListener('change', () => this.draw());
    const hint = h('p', { class: 'hint' }, 'Drag the control points in the plane of the screen, the background to turn the surface; or use the arrow keys.');
    this.element.append(h('figure', {}, h('label', { class: 'pick' }, 'Function ', this.choice), ...this.cuts(), this.map, this.about), h('figure', {}, this.scene, hint));
    if (!points.length) points.push(...this.start());
    this.mesh();
    this.scene.addEventListener('pointerdown', (e) => this.turn(e));
    this.scene.addEventListener('keydown', (e) => this.key(e));
  }

  set(values: number[], mark: Mark | undefined): void {
    this.functions = new Functions(this.drawing, values);
    this.mark = mark;
    if (mark && mark.function !== null) this.choice.value = String(mark.function);
    const at = mark && this.others.map((place) => mark.at[this.drawing.variables[place]!]);
    at?.forEach((x, k) => { if (x !== undefined) this.cut[k] = x; });
    this.mesh();
    this.draw();
  }

  resize(): void {
    this.fit();
    this.draw();
  }

  /** The simplex to which the coordinate at a place belongs. */
  private simplexOf(place: number): [number, number] | undefined {
    return this.drawing.simplices.find(([start, end]) => start <= place && place < end);
  }

  /** What the cuts leave of the sum 1 of the barycentric coordinates of a simplex, but for those at one place. */
  private left([start, end]: [number, number], but = -1): number {
    const taken = this.others.reduce((sum, place, k) => (start <= place && place < end && place !== but ? sum + this.cut[k]! : sum), 0);
    return Math.max(0, 1 - taken);
  }

  /** Sliders for the variables that are not drawn. */
  private cuts(): HTMLElement[] {
    return this.cut.map((value, k) => {
      const place = this.others[k]!;
      const [low, high] = this.ranges[place]!;
      const name = this.drawing.variables[place]!;
      const simplex = this.simplexOf(place);
      const shown = h('output', {}, number(value, 3));
      const slide = h('input', { type: 'range', min: low, max: simplex ? high * 0.95 : high, step: (high - low) / 200, value, 'aria-label': name });
      slide.addEventListener('input', () => {
        this.cut[k] = Math.min(Number(slide.value), simplex ? this.left(simplex, place) : Infinity);
        shown.textContent = number(this.cut[k]!, 3);
        this.mesh();
        this.draw();
      });
      return h('label', { class: 'pick' }, `cut at ${name} = `, shown, slide);
    });
  }

  private rest(): number {
    return this.triangle ? this.left(this.drawing.simplices[0]!) : 1;
  }

  /** The point of the domain at a and b from 0 to 1; of a simplex a + b ≤ 1. */
  private where(a: number, b: number): number[] {
    const at = this.ranges.map(() => 0);
    this.others.forEach((place, k) => { at[place] = this.cut[k]!; });
    [a, b].forEach((x, k) => {
      const [low, high] = this.ranges[this.first + k]!;
      at[this.first + k] = this.triangle ? x * this.rest() : low + x * (high - low);
    });
    return at;
  }

  private mesh(): void {
    const many = this.drawing.labels.length > 24;
    const n = many ? 16 : 24;
    this.nodes = [];
    this.faces = [];
    const index = new Map<string, number>();
    const node = (i: number, j: number) => {
      const key = `${i},${j}`;
      let k = index.get(key);
      if (k === undefined) {
        k = this.nodes.length;
        const where = this.where(i / n, j / n);
        this.nodes.push({ where, values: this.functions.at(where) });
        index.set(key, k);
      }
      return k;
    };
    for (let j = 0; j < n; j++) for (let i = 0; i < n; i++) {
      if (!this.triangle) this.faces.push([node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)]);
      else if (i + j < n) {
        this.faces.push([node(i, j), node(i + 1, j), node(i, j + 1)]);
        if (i + j < n - 1) this.faces.push([node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)]);
      }
    }
  }

  /** The plane of the domain as a figure with sides of about one. */
  private flat(where: number[]): [number, number] {
    if (this.triangle) return [where[this.first]! + where[this.first + 1]! / 2, where[this.first + 1]! * ROOT];
    return [0, 1].map((k) => (where[k]! - this.ranges[k]![0]) / (this.ranges[k]![1] - this.ranges[k]![0])) as [number, number];
  }

  /** A control point stands over the place at which its function is largest, so that the net looks like the domain. */
  private start(): number[][] {
    const n = 24;
    const best = this.drawing.labels.map(() => ({ value: 0, sum: [0, 0] as [number, number], count: 0 }));
    for (let j = 0; j <= n; j++) for (let i = 0; i <= (this.triangle ? n - j : n); i++) {
      const where = this.where(i / n, j / n);
      const flat = this.flat(where);
      this.functions.at(where).forEach((v, k) => {
        const b = best[k]!;
        const size = Math.abs(v);
        if (size > b.value * (1 + 1e-9) + 1e-12) Object.assign(b, { value: size, sum: [0, 0], count: 0 });
        if (size >= b.value * (1 - 1e-9) && size > 1e-12) { b.sum[0] += flat[0]; b.sum[1] += flat[1]; b.count += 1; }
      });
    }
    const middle: [number, number] = this.triangle ? [0.5, ROOT / 3] : [0.5, 0.5];
    return best.map(({ sum, count }) => {
      const [x, y] = count ? [sum[0] / count, sum[1] / count] : middle;
      const far = Math.hypot(x - middle[0], y - middle[1]);
      return [x, y, 0.45 * Math.cos(far * 2.6)];
    });
  }

  draw(): void {
    this.drawMap();
    this.drawScene();
  }

  private drawMap(): void {
    const context = this.map.getContext('2d');
    if (!context) return;
    const k = Number(this.choice.value) || 0;
    const size = MAP * 2;
    const image = context.createImageData(size, size);
    // From a pixel, as parts of the picture, to the domain.
    const low3 = (1 - ROOT) / 2;
    const parts = (x: number, y: number): [number, number] => {
      const b = this.triangle ? (1 - y - low3) / ROOT : 1 - y;
      return [this.triangle ? x - b / 2 : x, b];
    };
    const inside = ([a, b]: [number, number]) => (this.triangle ? a >= -1e-9 && b >= -1e-9 && a + b <= 1 + 1e-9 : true);
    const grid: number[] = [];
    // The ends of the domain are nodes of the surface, and need not be nodes of the map.
    const seen = this.nodes.map((node) => node.values[k]!).filter(Number.isFinite);
    let [low, high] = [Math.min(0, ...seen), Math.max(0, ...seen)];
    const tiny = 1e-9 * Math.max(-low, high);
    for (let j = 0; j <= STEPS; j++) for (let i = 0; i <= STEPS; i++) {
      const p = parts(i / STEPS, j / STEPS);
      const near = this.triangle ? p[0] > -0.05 && p[1] > -0.05 && p[0] + p[1] < 1.05 : true;
      const f = near ? this.functions.at(this.where(...p))[k]! : NaN;
      grid.push(f);
      if (inside(p) && Number.isFinite(f)) { low = Math.min(low, f); high = Math.max(high, f); }
    }
    // What is negative by rounding only is zero.
    if (low > -tiny) low = 0;
    const bands = ticks(low, high || 1, 10);
    const width = bands.length > 1 ? bands[1]! - bands[0]! : 0.1;
    for (let y = 0; y < size; y++) for (let x = 0; x < size; x++) {
      const [px, py] = [((x + 0.5) / size) * STEPS, ((y + 0.5) / size) * STEPS];
      if (!inside(parts(px / STEPS, py / STEPS))) continue;
      const [i, j] = [Math.min(STEPS - 1, Math.floor(px)), Math.min(STEPS - 1, Math.floor(py))];
      const [s, t, at] = [px - i, py - j, j * (STEPS + 1) + i];
      const row = (from: number) => (1 - s) * grid[from]! + s * grid[from + 1]!;
      const raw = (1 - t) * row(at) + t * row(at + STEPS + 1);
      if (!Number.isFinite(raw)) continue;
      const f = Math.max(low, Math.min(high, raw));
      const c = tone((Math.floor(f / width + 1e-9) + 0.5) * width, low, high);
      image.data.set([...c, 255], 4 * (y * size + x));
    }
    context.clearRect(0, 0, size, size);
    context.putImageData(image, 0, 0);
    const { variables } = this.drawing;
    const [u, v, w] = [this.first, this.first + 1, this.ranges.length].map((place) => variables[place]);
    const axes = this.triangle ? `${u} = 1 at the right, ${v} = 1 at the top, ${w} = 1 at the left` : `${u} to the right, ${v} upwards`;
    const label = this.drawing.labels[k] ?? '';
    this.map.setAttribute('aria-label', `${label} as a map`);
    this.about.textContent = `${label} from ${number(low, 4)} to ${number(high, 4)}; a band every ${number(width)}; ${axes}${low < 0 ? '; negative values are red' : ''}.`;
    this.markMap(context, size, low3);
  }

  private marked(): number[] | undefined {
    const at = this.ranges.map((_, k) => this.mark?.at[this.drawing.variables[k]!]);
    return at.every((x) => x !== undefined) && at.length ? (at as number[]) : undefined;
  }

  private markMap(context: CanvasRenderingContext2D, size: number, low3: number): void {
    const at = this.marked();
    if (!at) return;
    let [x, y] = this.flat(at);
    if (this.triangle) {
      const rest = this.rest() || 1;
      [x, y] = [x / rest, y / rest + low3];
    }
    for (const [width, style] of [[9, '#fff'], [5, '#c1121f']] as const) {
      context.beginPath();
      context.arc(x * size, (1 - y) * size, 14, 0, 7);
      context.lineWidth = width;
      context.strokeStyle = style;
      context.stroke();
    }
  }

  private size(): [number, number] {
    const w = Math.max(300, Math.min(560, this.element.clientWidth || 480));
    return [w, Math.round(w < 480 ? w * 0.8 : Math.max(240, Math.min(w * 0.68, innerHeight * 0.45)))];
  }

  /** Right, up and towards the eye, of a point around the middle of the domain. */
  private turned([x, y, z]: Point): Point {
    const [cx, cy] = this.triangle ? [0.5, ROOT / 3] : [0.5, 0.5];
    const [a, b] = [x - cx, y - cy];
    const [c, s] = [Math.cos(this.yaw), Math.sin(this.yaw)];
    const [right, back] = [c * a - s * b, s * a + c * b];
    const [cp, sp] = [Math.cos(this.pitch), Math.sin(this.pitch)];
    const height = z - 0.15;
    return [right, back * sp + height * cp, height * sp - back * cp];
  }

  private unit(): number {
    return this.view.unit;
  }

  private screen([right, up]: Point): [number, number] {
    const [w, height] = this.size();
    return [w / 2 + (right - this.view.right) * this.unit(), height / 2 - (up - this.view.up) * this.unit()];
  }

  /** Shows all control points, and the surface between them. */
  private fit(): void {
    const at = this.points.map((p) => this.turned(p as Point));
    const [w, height] = this.size();
    const range = (c: 0 | 1) => [Math.min(...at.map((p) => p[c])), Math.max(...at.map((p) => p[c]))] as const;
    const [[left, right], [low, high]] = [range(0), range(1)];
    const unit = Math.min((w - 60) / Math.max(right - left, 0.2), (height - 50) / Math.max(high - low, 0.2));
    this.view = { right: (left + right) / 2, up: (low + high) / 2, unit: Math.min(unit, w) };
  }

  private drawScene(): void {
    const [w, height] = this.size();
    const focus = document.activeElement instanceof SVGElement ? document.activeElement.dataset['point'] : undefined;
    this.scene.setAttribute('viewBox', `0 0 ${w} ${height}`);
    this.scene.replaceChildren();
    const place = (values: number[]): Point => {
      const p: Point = [0, 0, 0];
      values.forEach((b, k) => { for (let c = 0; c < 3; c++) p[c]! += b * this.points[k]![c]!; });
      return p;
    };
    const at = this.nodes.map((node) => this.turned(place(node.values)));
    const flat = at.map((p) => this.screen(p));
    const faces = this.faces
      .map((face) => ({ face, depth: face.reduce((sum, k) => sum + at[k]![2], 0) / face.length }))
      .filter(({ depth }) => Number.isFinite(depth))
      .sort((a, b) => a.depth - b.depth);
    for (const { face } of faces) {
      const [p, q, r] = face.slice(0, 3).map((k) => at[k]!) as [Point, Point, Point];
      const [a, b] = [q.map((v, c) => v - p[c]!), r.map((v, c) => v - p[c]!)] as [Point, Point];
      const normal = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]] as Point;
      const length = Math.hypot(...normal) || 1;
      const light = Math.abs((normal[0] * -0.35 + normal[1] * 0.5 + normal[2] * 0.8) / length);
      const fill = `hsl(206 62% ${(34 + 40 * light).toFixed(0)}%)`;
      this.scene.append(svg('polygon', { points: face.map((k) => flat[k]!.map((v) => v.toFixed(1)).join(',')).join(' '), fill, stroke: fill, class: 'face' }));
    }
    const corners = this.points.map((p) => this.screen(this.turned(p as Point)));
    const net = this.net().map(([i, j]) => `M${corners[i]!.map((v) => v.toFixed(1)).join(' ')}L${corners[j]!.map((v) => v.toFixed(1)).join(' ')}`);
    this.scene.append(svg('path', { d: net.join(''), class: 'polygon' }));
    const many = this.points.length > 20;
    this.points.forEach((p, k) => {
      const [px, py] = corners[k]!;
      const name = this.drawing.labels[k]!.replace(/^[^[]*/, 'P');
      const text = p.map((v) => number(v, 3)).join(', ');
      const dot = svg('circle', { cx: px, cy: py, r: many ? 5 : 7, class: 'point', tabindex: 0, 'data-point': k, role: 'slider', 'aria-label': `control point ${name}`, 'aria-valuenow': 0, 'aria-valuetext': text }, svg('title', {}, `${name} = (${text})`));
      dot.addEventListener('pointerdown', (e) => this.drag(e, k));
      this.scene.append(dot);
      if (focus === String(k)) dot.focus();
    });
    this.markScene(place);
  }

  private markScene(place: (values: number[]) => Point): void {
    const at = this.marked();
    if (!at) return;
    const [px, py] = this.screen(this.turned(place(this.functions.at(at))));
    this.scene.append(svg('circle', { cx: px, cy: py, r: 8, class: 'counterexample' }));
  }

  /** The lines of the net: between points whose indices are neighbours. */
  private net(): [number, number][] {
    const { indices, simplices, variables } = this.drawing;
    // All barycentric coordinates of a simplex are indices, where a function has one for each variable.
    const groups = simplices.map(([start, end], k) => [start + k, end + k + 1] as const);
    const inSimplex = (change: number[]) => groups.some(([start, end]) => change.every((v, k) => v === 0 || (start <= k && k < end)));
    const lines: [number, number][] = [];
    for (let i = 0; i < indices.length; i++) for (let j = i + 1; j < indices.length; j++) {
      const change = indices[i]!.map((v, k) => Math.abs(v - indices[j]![k]!));
      const steps = change.reduce((a, b) => a + b, 0);
      const barycentric = this.triangle && change.length === variables.length;
      const along = steps === 1 && change.length > 1;
      if (along || (barycentric && steps === 2 && Math.max(...change) === 1 && inSimplex(change))) lines.push([i, j]);
    }
    return lines;
  }

  /** Moves a control point by pixels in the plane of the screen. */
  private shift(k: number, dx: number, dy: number): void {
    const [right, up] = [dx / this.unit(), -dy / this.unit()];
    const [c, s, cp, sp] = [Math.cos(this.yaw), Math.sin(this.yaw), Math.cos(this.pitch), Math.sin(this.pitch)];
    const back = up * sp;
    const p = this.points[k]!;
    p[0]! += c * right + s * back;
    p[1]! += -s * right + c * back;
    p[2]! += up * cp;
  }

  private follow(e: PointerEvent, step: (dx: number, dy: number) => void, done: () => void): void {
    e.preventDefault();
    let [x, y] = [e.clientX, e.clientY];
    const scale = () => this.size()[0] / this.scene.getBoundingClientRect().width;
    const move = (m: PointerEvent) => {
      step((m.clientX - x) * scale(), (m.clientY - y) * scale());
      [x, y] = [m.clientX, m.clientY];
      this.drawScene();
    };
    const up = () => {
      for (const name of ['pointerup', 'pointercancel']) removeEventListener(name, up);
      removeEventListener('pointermove', move);
      done();
    };
    addEventListener('pointermove', move);
    for (const name of ['pointerup', 'pointercancel']) addEventListener(name, up);
  }

  private drag(e: PointerEvent, k: number): void {
    e.stopPropagation();
    (e.currentTarget as SVGElement).focus();
    this.follow(e, (dx, dy) => this.shift(k, dx, dy), () => { this.fit(); this.drawScene(); this.moved(); });
  }

  private turn(e: PointerEvent): void {
    this.follow(e, (dx, dy) => this.rotate(dx, dy), () => { this.fit(); this.drawScene(); });
  }

  private rotate(dx: number, dy: number): void {
    this.yaw -= dx * 0.01;
    this.pitch = Math.max(0.05, Math.min(1.5, this.pitch + dy * 0.01));
  }

  private key(e: KeyboardEvent): void {
    const steps: Record<string, [number, number]> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
    const step = steps[e.key];
    if (!step) return;
    e.preventDefault();
    const point = (e.target as SVGElement).dataset['point'];
    if (point === undefined) this.rotate(step[0] * 12, step[1] * 12);
    else this.shift(Number(point), step[0] * 6, step[1] * 6);
    this.drawScene();
    if (point !== undefined) this.moved();
  }
}

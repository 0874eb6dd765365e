// Families in floating point.
import type { Angle, Drawing, Quotient, Span, Sum, Term } from './protocol';

/** A sum of terms, each a coefficient times powers of variables. */
export function terms(all: Term[], at: number[]): number {
  let sum = 0;
  for (const term of all) {
    let product = term[0]!;
    for (let k = 1; k < term.length; k += 2) {
      const x = at[term[k]!]!;
      for (let n = term[k + 1]!; n > 0; n--) product *= x;
    }
    sum += product;
  }
  return sum;
}

/** A polynomial in Bernstein form at x and s = 1 − x, by the algorithm of de Casteljau. */
function casteljau(coefficients: number[], x: number): number {
  const s = 1 - x;
  const b = coefficients.slice();
  for (let n = b.length - 1; n > 0; n--) for (let j = 0; j < n; j++) b[j] = s * b[j]! + x * b[j + 1]!;
  return b[0] ?? 0;
}

/** The functions of a family on one span, at fixed shape values. */
class Piece {
  private readonly base: number[];
  private readonly own: Angle | undefined;
  /** For each function what stands above and below the fraction line, where no coefficient depends on the point. */
  private readonly fixed: ([number[], number[] | null] | null)[];

  constructor(private readonly span: Span, shapes: { var: number; value: number }[]) {
    this.base = new Array<number>(span.width).fill(0);
    for (const shape of shapes) this.base[shape.var] = shape.value;
    for (const [place, value] of span.numbers) this.base[place] = value;
    this.own = span.angles.find((a) => span.domain.includes(a.var));
    for (const angle of span.angles) if (angle !== this.own) this.base[angle.itself] = this.itself(angle, this.base);
    const moving = new Set([...span.domain, ...(this.own ? [this.own.itself] : [])]);
    const still = (sum: Sum) => 'bernstein' in sum && sum.bernstein.every((c) => c.every((t) => t.every((v, k) => k % 2 === 0 || !moving.has(v))));
    const row = (sum: Sum) => ('bernstein' in sum ? sum.bernstein.map((c) => terms(c, this.base)) : []);
    this.fixed = span.functions.map((f) =>
      still(f.above) && (f.below === null || still(f.below)) ? [row(f.above), f.below && row(f.below)] : null);
  }

  /** An angle where its variable has a value: that of the tangent is low + width · y. */
  private itself(angle: Angle, at: number[]): number {
    const quotient = (q: { above: Term[]; below: Term[] }) => terms(q.above, at) / terms(q.below, at);
    const x = quotient(angle.low) + quotient(angle.width) * at[angle.var]!;
    return angle.kind ? angle.shift + Math[angle.kind](x) / angle.rate : x;
  }

  private all(where: number[]): number[] {
    const at = this.base.slice();
    this.span.domain.forEach((place, k) => { at[place] = where[k]!; });
    if (this.own) at[this.own.itself] = this.itself(this.own, at);
    return at;
  }

  /** Where a value of the domain variable stands on the axis. */
  axis(y: number): number {
    return this.own ? this.itself(this.own, this.all([y])) : y;
  }

  values(where: number[]): number[] {
    const at = this.all(where);
    const [low, high] = this.span.ranges[0]!;
    const x = (where[0]! - low) / (high - low);
    const sum = (s: Sum) => ('bernstein' in s ? casteljau(s.bernstein.map((c) => terms(c, at)), x) : terms(s.terms, at));
    return this.span.functions.map((f: Quotient, k) => {
      const fixed = this.fixed[k];
      if (fixed) return casteljau(fixed[0], x) / (fixed[1] ? casteljau(fixed[1], x) : 1);
      return sum(f.above) / (f.below ? sum(f.below) : 1);
    });
  }
}

/** A point of an interval: where it stands on the axis, and the functions there. */
export interface Sample { span: number; t: number; axis: number; values: number[] }

/** A family at fixed shape values. */
export class Functions {
  private readonly pieces: Piece[];

  constructor(readonly drawing: Drawing, values: number[]) {
    const shapes = drawing.shapes.map((s, k) => ({ var: s.var, value: values[k]! }));
    this.pieces = drawing.spans.map((span) => new Piece(span, shapes));
  }

  /** The functions at a point of the domain. */
  at(where: number[], span = 0): number[] {
    return this.pieces[span]!.values(where);
  }

  /** The span of an interval in which a value of its variable lies, as counterexamples name it. */
  spanOf(t: number): number {
    const found = this.drawing.spans.findIndex(({ ranges: [range] }) => range![0] <= t && t <= range![1]);
    return Math.max(0, found);
  }

  axis(t: number, span = 0): number {
    return this.pieces[span]!.axis(t);
  }

  /** What stands on the axis of an interval: the angle, where the variable is a tangent of one. */
  axisName(): string {
    const [span] = this.drawing.spans;
    return span?.angles.find((a) => span.domain.includes(a.var))?.name ?? this.drawing.variables[0] ?? '';
  }

  /** Points of an interval at equal distances in its variable, both ends of every span among them. */
  samples(count: number): Sample[] {
    const each = Math.max(16, Math.ceil(count / this.pieces.length));
    return this.drawing.spans.flatMap(({ ranges: [range] }, span) =>
      Array.from({ length: each + 1 }, (_, k) => {
        const [low, high] = range!;
        const t = k === each ? high : low + ((high - low) * k) / each;
        return { span, t, axis: this.axis(t, span), values: this.at([t], span) };
      }));
  }
}

/** The conditions of `assume` that shape values do not meet. */
export function violated(drawing: Drawing, values: number[]): string[] {
  const at: number[] = [];
  drawing.shapes.forEach((s, k) => { at[s.var] = values[k]!; });
  return drawing.conditions.filter((c) => !(terms(c.value, at) >= -1e-12)).map((c) => c.text);
}

// The LaTeX that the engine writes, as MathML. It is a small part of LaTeX (`engine/src/query/latex.rs` writes it): a renderer
// of the whole is as large as the editor. The tests compare the two on every formula of the library.

/** An element of MathML: its name, what it holds, and attributes. */
export interface Node {
  tag: string;
  content: string | Node[];
  attributes?: Record<string, string>;
}

const node = (tag: string, content: string | Node[], attributes?: Record<string, string>): Node =>
  attributes ? { tag, content, attributes } : { tag, content };

/** Letters by name, from U+03B1 on; LaTeX knows no final sigma, and names two letters by the form that they had first. */
const LETTERS = new Map<string, string>([
  ...'alpha beta gamma delta varepsilon zeta eta theta iota kappa lambda mu nu xi omicron pi rho varsigma sigma tau upsilon varphi chi psi omega'
    .split(' ').map((name, k): [string, string] => [name, String.fromCharCode(0x3b1 + k)]),
  ...'Gamma Γ Chi Χ Delta Δ Theta Θ Lambda Λ Xi Ξ Pi Π Sigma Σ Upsilon Υ Phi Φ Psi Ψ Omega Ω epsilon ϵ phi ϕ vartheta ϑ ell ℓ partial ∂'
    .split(' ').flatMap((name, k, all): [string, string][] => (k % 2 ? [] : [[name, all[k + 1]!]])),
]);
const FUNCTIONS = new Set(['sin', 'cos', 'tan', 'sinh', 'cosh', 'tanh', 'exp', 'min', 'max']);
const SIGNS = new Map(Object.entries({
  le: '≤', ge: '≥', ne: '≠', parallel: '∥', times: '×', cdot: '⋅', sum: '∑', prod: '∏', int: '∫',
  lfloor: '⌊', rfloor: '⌋', lceil: '⌈', rceil: '⌉', langle: '⟨', rangle: '⟩',
}));
/** Widths of spaces in em. */
const SPACES = new Map(Object.entries({ ',': '0.1667em', ' ': '0.25em', quad: '1em' }));

/** Whether brackets around it have to grow. */
const isTall = ({ tag, content }: Node): boolean => tag === 'mfrac' || tag === 'msqrt' || (Array.isArray(content) && content.some(isTall));

/** What is nested more deeply is not read; the engine stops at the same depth. */
const DEPTH = 400;

class Reader {
  private at = 0;
  private depth = 0;
  private readonly tokens: string[];

  constructor(latex: string) {
    this.tokens = latex.match(/\\(?:[a-zA-Z]+|[^])|\d+(?:\.\d+)?|\S/gu) ?? [];
  }

  whole(): Node {
    const row = this.row(() => false);
    if (this.at < this.tokens.length) throw this.unknown();
    return row;
  }

  private unknown(): Error {
    return new Error(`no LaTeX that the engine writes: ${this.tokens[this.at] ?? 'it ends too early'}`);
  }

  private next(): string {
    const token = this.tokens[this.at];
    if (token === undefined) throw this.unknown();
    this.at += 1;
    return token;
  }

  private eat(token: string): boolean {
    const found = this.tokens[this.at] === token;
    if (found) this.at += 1;
    return found;
  }

  private expect(token: string): void {
    if (!this.eat(token)) throw this.unknown();
  }

  /** Elements side by side, up to a token that ends them. */
  private row(ends: (token: string) => boolean): Node {
    this.depth += 1;
    if (this.depth > DEPTH) throw this.unknown();
    const all: Node[] = [];
    for (let token; (token = this.tokens[this.at]) !== undefined && !ends(token);) {
      const element = this.scripted();
      all.push(element);
      // A sine keeps its distance from what it is applied to.
      const base = Array.isArray(element.content) && /^msu/.test(element.tag) ? element.content[0]! : element;
      if (FUNCTIONS.has(base.content as string)) all.push(node('mo', '\u2061'));
    }
    this.depth -= 1;
    return all.length === 1 ? all[0]! : node('mrow', all);
  }

  private group(): Node {
    this.expect('{');
    const row = this.row((token) => token === '}');
    this.expect('}');
    return row;
  }

  /** An element with what stands above and below its line. */
  private scripted(): Node {
    const base = this.element();
    let primes = 0;
    let above: Node | undefined;
    let below: Node | undefined;
    for (;;) {
      if (this.eat("'")) primes += 1;
      else if (this.eat('^')) above = this.group();
      else if (this.eat('_')) below = this.group();
      else break;
    }
    if (primes) {
      const marks = node('mo', '′'.repeat(primes), { lspace: '0em', rspace: '0em' });
      above = above ? node('mrow', [marks, above]) : marks;
    }
    if (above && below) return node('msubsup', [base, below, above]);
    if (above) return node('msup', [base, above]);
    return below ? node('msub', [base, below]) : base;
  }

  private element(): Node {
    const token = this.tokens[this.at];
    if (token === '{') return this.group();
    this.next();
    if (token!.length > 1 && token!.startsWith('\\')) return this.command(token!.slice(1));
    if (/^\d/.test(token!)) return node('mn', token!);
    if (/^\p{L}/u.test(token!)) return node('mi', token!);
    if (token === '-') return node('mo', '−');
    if ('()[]'.includes(token!)) return node('mo', token!, { stretchy: 'false' });
    if ('+=<>,!:|/*'.includes(token!)) return node('mo', token!);
    this.at -= 1;
    throw this.unknown();
  }

  private command(name: string): Node {
    const letter = LETTERS.get(name);
    if (letter) return /[Α-Ω]/.test(letter) ? node('mi', letter, { mathvariant: 'normal' }) : node('mi', letter);
    if (FUNCTIONS.has(name)) return node('mi', name);
    const sign = SIGNS.get(name);
    if (sign) return node('mo', sign);
    const width = SPACES.get(name);
    if (width) return node('mspace', [], { width });
    switch (name) {
      case 'frac': return node('mfrac', [this.group(), this.group()]);
      case 'sqrt': return node('msqrt', [this.group()]);
      case 'binom': {
        const numbers = node('mfrac', [this.group(), this.group()], { linethickness: '0px' });
        return node('mrow', [node('mo', '('), numbers, node('mo', ')')]);
      }
      case 'left': {
        const open = this.fence();
        const inside = this.row((token) => token === '\\right');
        this.expect('\\right');
        const close = this.fence();
        // What can grow has more room beside it than it needs in browsers, also where it does not grow.
        if (!isTall(inside)) for (const sign of [open, close]) sign.attributes = { ...sign.attributes, stretchy: 'false' };
        return node('mrow', [open, inside, close]);
      }
      case 'mathit': return node('mi', this.word(), { class: 'word' });
      case 'mathrm': return node('mi', this.word().replace(/^u([\da-f]+)$/, (_, code) => String.fromCodePoint(parseInt(code, 16))), { mathvariant: 'normal' });
      default:
        this.at -= 1;
        throw this.unknown();
    }
  }

  private fence(): Node {
    const token = this.next();
    const sign = '()[]'.includes(token) ? token : SIGNS.get(token.slice(1));
    if (!sign) throw this.unknown();
    return node('mo', sign, { fence: 'true' });
  }

  /** The letters of a name of several. */
  private word(): string {
    this.expect('{');
    let word = '';
    while (!this.eat('}')) {
      const token = this.next();
      word += token.startsWith('\\') ? (LETTERS.get(token.slice(1)) ?? token.slice(1)) : token;
    }
    return word;
  }
}

/** The MathML of a formula in LaTeX; an error where it is none that the engine writes. */
export const mathml = (latex: string): Node => node('math', [new Reader(latex).whole()]);

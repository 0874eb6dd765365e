// Formulas as they are printed.
import katex from 'katex';
import type { Formula } from './protocol';
import { signs } from './dom';

/** A formula; text where it is none, or one that would be longer than anyone reads. */
export function formula(f: Formula): HTMLElement {
  const span = document.createElement('span');
  if (f.latex === null || f.latex.length > 4000) {
    span.textContent = signs(f.text);
    span.className = 'plain-formula';
    return span;
  }
  span.className = 'math';
  katex.render(f.latex, span, { throwOnError: false, output: 'mathml', strict: false, trust: false, maxExpand: 100 });
  return span;
}

// Formulas as they are printed.
import type { Formula } from './protocol';
import { signs } from './dom';
import { mathml, type Node } from './latex';

function element({ tag, content, attributes }: Node): Element {
  const e = document.createElementNS('http://www.w3.org/1998/Math/MathML', tag);
  for (const [name, value] of Object.entries(attributes ?? {})) e.setAttribute(name, value);
  if (typeof content === 'string') e.textContent = content;
  else e.append(...content.map(element));
  return e;
}

/** A formula; text where it is none, or one that would be longer than anyone reads. */
export function formula(f: Formula): HTMLElement {
  const span = document.createElement('span');
  if (f.latex === null || f.latex.length > 4000) {
    span.textContent = signs(f.text);
    span.className = 'plain-formula';
    return span;
  }
  span.className = 'math';
  span.append(element(mathml(f.latex)));
  return span;
}

// Formulas as MathML: numbers like `-1/2 + 3/4 a^2`, square roots like `√(5/12)` or `√3/6`, polynomials like `2*z3 - x^2`. A text of another form stays text.

const MATHML = "http://www.w3.org/1998/Math/MathML";

function mathElement(name, ...children) {
  const node = document.createElementNS(MATHML, name);
  node.append(...children);
  return node;
}

// The formula, or the text as it is.
function math(text) {
  const tokens = text.match(/\d+|[a-z][a-z0-9_]*|\S/g) ?? [];
  if (tokens.length === 1 && /^\d/.test(text)) return text;
  let at = 0;
  const take = (token) => tokens[at] === token && ++at > 0;
  const row = (parts) => (parts.length === 1 ? parts[0] : mathElement("mrow", ...parts));
  const operator = (sign) => mathElement("mo", sign === "-" ? "−" : sign);
  const sum = () => {
    const parts = take("-") ? [operator("-"), product()] : [product()];
    while (tokens[at] === "+" || tokens[at] === "-") parts.push(operator(tokens[at++]), product());
    return row(parts);
  };
  const product = () => {
    const factors = [power()];
    for (;;) {
      if (take("/")) factors.push(mathElement("mfrac", factors.pop(), power()));
      else if (take("*") || /^(\d|[a-z√(])/.test(tokens[at] ?? "")) factors.push(mathElement("mo", "\u2062"), power());
      else return row(factors);
    }
  };
  const power = () => {
    const base = atom();
    return take("^") ? mathElement("msup", base, atom()) : base;
  };
  const atom = () => {
    const token = tokens[at++] ?? "";
    if (/^\d+$/.test(token)) return mathElement("mn", token);
    if (/^[a-z]/.test(token)) return name(token);
    if (token === "√") return mathElement("msqrt", take("(") ? closed(sum()) : atom());
    if (token === "(") return row([operator("("), closed(sum()), operator(")")]);
    throw new SyntaxError(token);
  };
  // `z1` has the index 1, and `x_zn2` the index zn2.
  const name = (token) => {
    const [, letters, index] = /^([a-z]+)_*(.*)$/.exec(token);
    return index ? mathElement("msub", mathElement("mi", letters), mathElement("mi", index)) : mathElement("mi", letters);
  };
  const closed = (inner) => {
    if (!take(")")) throw new SyntaxError(text);
    return inner;
  };
  try {
    const formula = sum();
    if (at < tokens.length) return text;
    const node = mathElement("math", formula);
    // Programs that read pages aloud, and those that copy text, have the plain form.
    node.setAttribute("alttext", text);
    return node;
  } catch (error) {
    if (!(error instanceof SyntaxError)) throw error;
    return text;
  }
}

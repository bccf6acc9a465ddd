// Families: the member at a point of the box, from the polynomials of the certificate. Doubles, for pictures only.

// A slider has this many steps; its ends are those of the interval, without an end that is open.
const STEPS = 200;

const doubleOf = (number, generator) => [number].flat().reduce((sum, c, k) => sum + Number(c) * generator ** k, 0);

// The value of a polynomial, a list of [coefficient, exponents…].
const valueAt = (terms, point, generator) =>
  terms.reduce((sum, [c, ...exponents]) => sum + exponents.reduce((product, e, k) => product * point[k] ** e, doubleOf(c, generator)), 0);

// The parameters of a family: name, interval in words and in doubles, and the steps of the slider.
function parametersOf({ claim }, generator) {
  const value = ([, [number, denominator]]) => doubleOf(number, generator) / Number(denominator);
  return claim.parameters.map(({ name, low, high }) => ({
    name, words: sideWords(low, high), low: value(low), high: value(high),
    first: low[0] === "open" ? 1 : 0, last: high[0] === "open" ? STEPS - 1 : STEPS,
  }));
}

// Rows b_i with b_i · b_j = G_ij, for an upper triangle G.
function basisOf(gram) {
  const rows = gram.map(() => gram.map(() => 0));
  gram.forEach((_, i) => {
    for (let j = 0; j <= i; j++) {
      const rest = gram[j][i - j] - rows[j].slice(0, j).reduce((sum, x, k) => sum + rows[i][k] * x, 0);
      rows[i][j] = i === j ? Math.sqrt(Math.max(rest, 0)) : rest / rows[j][j];
    }
  });
  return rows;
}

// Sets basis and points of `data` to those of the member at these steps.
function setMember(data, certificate, steps) {
  const { generator } = data, { claim: { gram }, witness: { vertices, denominator } } = certificate;
  data.parameters ??= parametersOf(certificate, generator);
  data.steps = steps ?? data.parameters.map(() => STEPS / 2);
  data.at = data.parameters.map(({ low, high }, k) => low + (high - low) * data.steps[k] / STEPS);
  const value = (terms) => valueAt(terms, data.at, generator);
  data.basis = basisOf(gram.map((row) => row.map(value)));
  data.points = vertices.map((vertex) => vertex.map((terms) => value(terms) / Number(denominator)));
}

// Moves the vertices to the member at these steps.
function moveMember(view, steps) {
  const { tiling } = view;
  setMember(tiling.data, tiling.certificate, steps);
  placeVertices(tiling);
  [tiling.bounds, tiling.range] = [{}, null];
  view.renew();
}

// A slider for each parameter, and the angles of the member in words.
function familyControls(view) {
  const { data } = view.tiling, spoken = element("p", { class: "values" });
  const sliders = data.parameters.map(({ name, words, first, last }, k) => {
    const slider = element("input", { type: "range", min: first, max: last, step: "1", value: data.steps[k], name: `parameter-${k}`, "aria-label": `${name} in ${words}` });
    const value = element("output", {});
    return { slider, value, label: element("label", {}, element("span", {}, math(name), " = ", value, ` in ${words}`), slider) };
  });
  const tell = () => {
    sliders.forEach(({ slider, value }, k) => {
      value.textContent = slider.ariaValueText = data.at[k].toPrecision(6);
    });
    spoken.textContent = memberWords(view.tiling);
  };
  const move = () => { moveMember(view, sliders.map(({ slider }) => slider.valueAsNumber)); tell(); };
  sliders.forEach(({ slider }) => slider.addEventListener("input", move));
  tell();
  view.applySteps = (steps) => {
    sliders.forEach(({ slider }, k) => { slider.value = steps[k]; });
    move();
  };
  const note = element("p", { class: "hint" }, "The theorem holds at every point of the box. Picture and values here are computed in doubles from the certificate's polynomials.");
  return [...sliders.map(({ label }) => label), spoken, note];
}

// The angles of the member that is shown, rounded.
function memberWords(tiling) {
  const all = Array.from({ length: tiling.count }, (_, index) => roundedAngles(pointsOf(tiling, index), tiling.D).map(([, , x]) => x)).flat();
  const [low, high] = all.reduce(([a, b], x) => [Math.min(a, x), Math.max(b, x)], [180, 0]);
  return `${tiling.D === 2 ? "Angles" : "Dihedral angles"} at this point, rounded: from ${low.toFixed(3)}° to ${high.toFixed(3)}°.`;
}

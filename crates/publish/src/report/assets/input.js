// Fingers, mouse, wheel and keys move the view.

// One finger or the mouse turns, two fingers zoom, and what hardly moved was a click.
function listenToPointers(view) {
  const { canvas } = view, fingers = new Map();
  let travelled = 0, spread = 0;
  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    fingers.set(event.pointerId, [event.clientX, event.clientY]);
    if (fingers.size === 1) travelled = 0;
    spread = 0;
  });
  canvas.addEventListener("pointermove", (event) => {
    const old = fingers.get(event.pointerId);
    if (!old) return;
    fingers.set(event.pointerId, [event.clientX, event.clientY]);
    const [dx, dy] = [event.clientX - old[0], event.clientY - old[1]];
    const size = Math.min(canvas.clientWidth, canvas.clientHeight) / 2;
    travelled += Math.hypot(dx, dy);
    if (fingers.size === 1) view.rotate(dx / size, dy / size);
    if (fingers.size === 2) {
      const [a, b] = [...fingers.values()], now = Math.hypot(a[0] - b[0], a[1] - b[1]);
      if (spread) view.magnify(now / spread);
      spread = now;
    }
  });
  const release = (event) => {
    if (event.type === "pointerup" && fingers.size === 1 && travelled < 5) view.click(event);
    fingers.delete(event.pointerId);
    spread = 0;
  };
  canvas.addEventListener("pointerup", release);
  canvas.addEventListener("pointercancel", release);
}

function listenToWheel(view) {
  view.canvas.addEventListener("wheel", (event) => {
    // A page scrolls past the view unless it is in use.
    if (document.activeElement !== view.canvas && !event.ctrlKey) return;
    event.preventDefault();
    view.magnify(Math.exp(-event.deltaY * 0.0015));
  }, { passive: false });
}

const TURNS = { ArrowLeft: [-0.06, 0], ArrowRight: [0.06, 0], ArrowUp: [0, -0.06], ArrowDown: [0, 0.06] };

function listenToKeys(view) {
  view.canvas.addEventListener("keydown", (event) => {
    const count = view.items();
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (TURNS[event.key]) view.rotate(...TURNS[event.key]);
    else if (event.key === "+" || event.key === "=") view.magnify(1.25);
    else if (event.key === "-") view.magnify(0.8);
    else if (event.key === "0") view.reset();
    else if (event.key === "n") view.choose((view.chosen + 1) % count);
    else if (event.key === "p") view.choose((Math.max(view.chosen, 0) + count - 1) % count);
    else if (event.key === "Escape") view.choose(-1);
    else return;
    event.preventDefault();
  });
}

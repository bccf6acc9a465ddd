// Vectors of three doubles, and work in portions.

const add = (a, b, s = 1) => [a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = (a) => { const n = Math.hypot(...a) || 1; return [a[0] / n, a[1] / n, a[2] / n]; };
const mean = (points) => points.reduce((s, p) => add(s, p, 1 / points.length), [0, 0, 0]);

// Lets the page answer its reader before the work goes on.
const breathe = () => new Promise((resolve) => setTimeout(resolve));
// After the page itself is drawn: a view that is made earlier waits for that, and the reader with it.
async function painted() {
  for (let frame = 0; frame < 3; frame++) await new Promise((resolve) => { requestAnimationFrame(resolve); setTimeout(resolve, 500); });
}
const PORTION = 20;

// Calls `work(i)` for each i below `count`, in portions of about 20 ms.
async function inPortions(count, work) {
  let start = performance.now();
  for (let i = 0; i < count; i++) {
    work(i);
    if ((i & 127) === 127 && performance.now() - start > PORTION) {
      await breathe();
      start = performance.now();
    }
  }
}

// Draws triangles in WebGL 2: one program, flat light from the viewer, edges from barycentric coordinates.

const VERTEX_SHADER = `#version 300 es
precision highp float;
layout(location=0) in vec3 position; layout(location=1) in vec3 normal; layout(location=2) in vec3 middle;
layout(location=3) in vec4 barycentric; layout(location=4) in vec4 ink; layout(location=5) in vec4 kind;
layout(location=6) in float owner;
uniform mat3 turn; uniform vec3 centre; uniform float explode, zoom, perspective, scale; uniform vec2 aspect, pan; uniform float selected;
out vec4 weight; out vec3 light; flat out vec4 colours; flat out float facet; flat out float chosen; flat out float edgesOnly;
void main() {
  vec3 p = turn * (position + explode * (middle - centre) - centre) * scale;
  vec3 n = turn * normal;
  light = vec3(n.z, n.y, n.x);
  weight = barycentric; colours = ink; facet = kind.x; edgesOnly = kind.y; chosen = abs(owner - selected) < 0.5 ? 1.0 : 0.0;
  float depth = 1.0 - perspective * p.z / (1.0 + explode);
  vec2 q = p.xy * zoom / (1.0 + 0.75 * explode) + pan * depth;
  gl_Position = vec4(q * aspect, -p.z * 0.2 / (1.0 + explode), depth);
}`;

const FRAGMENT_SHADER = `#version 300 es
precision highp float;
in vec4 weight; in vec3 light; flat in vec4 colours; flat in float facet; flat in float chosen; flat in float edgesOnly;
uniform vec3 palette[64]; uniform vec3 edge; uniform float width; uniform float flatLight;
out vec4 colour;
void main() {
  int nearest = 0;
  for (int k = 1; k < 4; k++) if (weight[k] > weight[nearest]) nearest = k;
  vec3 base = palette[int(colours[nearest] + 0.5)];
  float shade = mix(0.52 + 0.48 * clamp(0.85 * light.x + 0.35 * light.y, 0.0, 1.0), 1.0, flatLight);
  float distance = 1e6;
  for (int k = 0; k < 4; k++) {
    float slope = length(vec2(dFdx(weight[k]), dFdy(weight[k])));
    if (abs(float(k) - facet) > 0.5) distance = min(distance, weight[k] / max(slope, 1e-9));
  }
  float wide = width * (1.0 + 2.0 * chosen);
  float ink = 1.0 - smoothstep(wide - 0.6, wide + 0.6, distance);
  if (edgesOnly > 0.5 && ink < 0.5) discard;
  vec3 lit = mix(base * shade, vec3(1.0), 0.35 * chosen);
  colour = vec4(mix(lit, mix(edge, vec3(0.85, 0.0, 0.3), chosen), ink), 1.0);
}`;

class Renderer {
  // Throws where there is no WebGL 2.
  constructor(canvas) {
    this.canvas = canvas;
    const gl = this.gl = canvas.getContext("webgl2", { antialias: true, preserveDrawingBuffer: true, alpha: true });
    if (!gl) throw new Error("WebGL 2 is not available");
    this.program = this.link();
    this.uniforms = {};
    const count = gl.getProgramParameter(this.program, gl.ACTIVE_UNIFORMS);
    for (let i = 0; i < count; i++) {
      const name = gl.getActiveUniform(this.program, i).name.replace("[0]", "");
      this.uniforms[name] = gl.getUniformLocation(this.program, name);
    }
    gl.useProgram(this.program);
    gl.enable(gl.DEPTH_TEST);
    this.buffers = [gl.createBuffer(), gl.createBuffer(), gl.createBuffer()];
    this.count = 0;
  }

  link() {
    const gl = this.gl, program = gl.createProgram();
    for (const [type, source] of [[gl.VERTEX_SHADER, VERTEX_SHADER], [gl.FRAGMENT_SHADER, FRAGMENT_SHADER]]) {
      const shader = gl.createShader(type);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
    return program;
  }

  // Takes the result of `triangles`.
  upload(mesh) {
    const gl = this.gl;
    this.mesh = mesh;
    this.count = mesh.floats.length / FLOATS;
    gl.bindBuffer(gl.ARRAY_BUFFER, this.buffers[0]);
    gl.bufferData(gl.ARRAY_BUFFER, mesh.floats, gl.STATIC_DRAW);
    [3, 3, 3, 4].reduce((start, size, location) => {
      gl.enableVertexAttribArray(location);
      gl.vertexAttribPointer(location, size, gl.FLOAT, false, FLOATS * 4, start * 4);
      return start + size;
    }, 0);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.buffers[1]);
    gl.bufferData(gl.ARRAY_BUFFER, mesh.bytes, gl.STATIC_DRAW);
    for (const location of [4, 5]) {
      gl.enableVertexAttribArray(location);
      gl.vertexAttribPointer(location, 4, gl.UNSIGNED_BYTE, false, 8, (location - 4) * 4);
    }
    gl.bindBuffer(gl.ARRAY_BUFFER, this.buffers[2]);
    const owners = Float32Array.from({ length: this.count }, (_, i) => mesh.owners[Math.floor(i / 3)]);
    gl.bufferData(gl.ARRAY_BUFFER, owners, gl.STATIC_DRAW);
    gl.enableVertexAttribArray(6);
    gl.vertexAttribPointer(6, 1, gl.FLOAT, false, 4, 0);
  }

  // Draws for a camera {turn: 9 numbers by columns, centre, scale, zoom, pan, explode, flat}, colours 0 to 1 and a chosen simplex or -1.
  draw(camera, palette, edge, chosen) {
    const gl = this.gl, u = this.uniforms, [w, h] = this.size();
    gl.viewport(0, 0, w, h);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.uniformMatrix3fv(u.turn, false, camera.turn);
    gl.uniform3fv(u.centre, camera.centre);
    gl.uniform1f(u.explode, camera.explode);
    gl.uniform1f(u.scale, camera.scale);
    gl.uniform1f(u.zoom, camera.zoom);
    gl.uniform1f(u.perspective, camera.flat ? 0 : 0.22);
    gl.uniform1f(u.flatLight, camera.flat ? 1 : 0);
    gl.uniform2fv(u.aspect, this.aspect());
    gl.uniform2fv(u.pan, camera.pan);
    gl.uniform3fv(u.palette, palette.slice(0, 64).flat());
    gl.uniform3fv(u.edge, edge);
    gl.uniform1f(u.width, 0.7 * Math.max(1, w / Math.max(1, this.canvas.clientWidth)));
    gl.uniform1f(u.selected, chosen);
    gl.drawArrays(gl.TRIANGLES, 0, this.count);
  }

  size() {
    return [this.canvas.width, this.canvas.height];
  }

  // The shorter side of the canvas goes from -1 to 1.
  aspect() {
    const [w, h] = this.size();
    return w > h ? [h / w, 1] : [1, w / h];
  }

  // The simplex under a point of the canvas (x, y from -1 to 1, y up), or -1: the vertex shader once more, in doubles.
  pick(camera, x, y) {
    const { floats, owners } = this.mesh, [ax, ay] = this.aspect();
    const project = (i) => {
      const f = floats.subarray(i * FLOATS, i * FLOATS + 9);
      const v = [0, 1, 2].map((k) => (f[k] + camera.explode * (f[6 + k] - camera.centre[k]) - camera.centre[k]) * camera.scale);
      const t = camera.turn;
      const p = [0, 1, 2].map((k) => t[k] * v[0] + t[3 + k] * v[1] + t[6 + k] * v[2]);
      const depth = 1 - (camera.flat ? 0 : 0.22) * p[2] / (1 + camera.explode);
      const zoom = camera.zoom / (1 + 0.75 * camera.explode);
      return [(p[0] * zoom / depth + camera.pan[0]) * ax, (p[1] * zoom / depth + camera.pan[1]) * ay, p[2] / depth];
    };
    let best = -1, nearest = -Infinity;
    for (let i = 0; i < owners.length; i++) {
      const [a, b, c] = [project(3 * i), project(3 * i + 1), project(3 * i + 2)];
      const area = (p, q, r) => (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
      const all = area(a, b, c), at = [x, y];
      const s = area(at, b, c) / all, t = area(a, at, c) / all;
      if (!(s >= 0 && t >= 0 && s + t <= 1) || this.mesh.bytes[24 * i + 5]) continue;
      const depth = s * a[2] + t * b[2] + (1 - s - t) * c[2];
      if (depth > nearest) [best, nearest] = [owners[i], depth];
    }
    return best;
  }
}


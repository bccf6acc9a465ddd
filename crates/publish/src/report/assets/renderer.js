// Draws triangles in WebGL 2, with edges from barycentric coordinates; where the view rests, with outlines and soft shadows.

const PERSPECTIVE = 0.22;

// Starts the card in a worker: the first context of a browser takes long, and a page that asks for it answers nobody meanwhile. Where
// that is not possible, the page asks itself.
async function wakeCard() {
  const program = "try { new OffscreenCanvas(1, 1).getContext('webgl2')?.flush(); } finally { postMessage(0); }";
  let worker;
  try {
    worker = new Worker(URL.createObjectURL(new Blob([program], { type: "text/javascript" })));
    await new Promise((resolve) => { worker.onmessage = worker.onerror = resolve; });
  } catch {
    // A browser that starts no worker from memory.
  }
  return () => worker?.terminate();
}

class Renderer {
  // Throws where there is no WebGL 2.
  constructor(canvas) {
    this.canvas = canvas;
    const gl = this.gl = canvas.getContext("webgl2", { antialias: true, preserveDrawingBuffer: true, alpha: true });
    if (!gl) throw new Error("WebGL 2 is not available");
    gl.enable(gl.DEPTH_TEST);
    this.attributes = gl.createVertexArray();
    this.nothing = gl.createVertexArray();
    this.buffers = [gl.createBuffer(), gl.createBuffer(), gl.createBuffer()];
    this.count = 0;
  }

  // Makes the programs; the card compiles them while the page answers its reader.
  async link() {
    const gl = this.gl, parallel = gl.getExtension("KHR_parallel_shader_compile");
    const shader = (type, source) => {
      const made = gl.createShader(type);
      gl.shaderSource(made, source);
      gl.compileShader(made);
      return made;
    };
    const programs = [[VERTEX_SHADER, FRAGMENT_SHADER], [WHOLE_VERTEX_SHADER, WHOLE_FRAGMENT_SHADER]].map(([vertex, fragment]) => {
      const program = gl.createProgram(), shaders = [shader(gl.VERTEX_SHADER, vertex), shader(gl.FRAGMENT_SHADER, fragment)];
      shaders.forEach((made) => gl.attachShader(program, made));
      gl.linkProgram(program);
      return { program, shaders };
    });
    await this.reached();
    while (parallel && !programs.every(({ program }) => gl.getProgramParameter(program, parallel.COMPLETION_STATUS_KHR))) await breathe();
    [this.program, this.uniforms] = this.linked(programs[0]);
    await breathe();
    [this.whole, this.wholeUniforms] = this.linked(programs[1]);
  }

  // The card has done all that it was asked for; the page answers its reader meanwhile.
  async reached() {
    const gl = this.gl, fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
    do await breathe(); while (fence && gl.getSyncParameter(fence, gl.SYNC_STATUS) !== gl.SIGNALED && !gl.isContextLost());
    gl.deleteSync(fence);
  }

  // A program and the places of its uniforms.
  linked({ program, shaders }) {
    const gl = this.gl;
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) {
      throw new Error([gl.getProgramInfoLog(program), ...shaders.map((made) => gl.getShaderInfoLog(made))].join(" "));
    }
    const uniforms = {}, count = gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS);
    for (let i = 0; i < count; i++) {
      const name = gl.getActiveUniform(program, i).name.replace("[0]", "");
      uniforms[name] = gl.getUniformLocation(program, name);
    }
    return [program, uniforms];
  }

  // Takes the result of `triangles`.
  upload(mesh) {
    const gl = this.gl;
    this.mesh = mesh;
    this.count = mesh.floats.length / FLOATS;
    gl.bindVertexArray(this.attributes);
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
    const owners = new Float32Array(this.count);
    for (let i = 0; i < this.count; i++) owners[i] = mesh.owners[Math.floor(i / 3)];
    gl.bufferData(gl.ARRAY_BUFFER, owners, gl.STATIC_DRAW);
    gl.enableVertexAttribArray(6);
    gl.vertexAttribPointer(6, 1, gl.FLOAT, false, 4, 0);
  }

  // Draws for a camera {turn: 9 numbers by columns, centre, scale, zoom, pan, explode, flat}, colours 0 to 1 and a chosen simplex or -1.
  // `isFine` asks for outlines and soft shadows; they do not exist in the plane.
  draw(camera, palette, edge, chosen, isFine) {
    if (isFine && !camera.flat) return this.drawFine(camera, palette, edge, chosen);
    this.gl.bindFramebuffer(this.gl.FRAMEBUFFER, null);
    this.drawTriangles(camera, palette, edge, chosen);
  }

  drawTriangles(camera, palette, edge, chosen) {
    const gl = this.gl, u = this.uniforms, [w, h] = this.size();
    gl.useProgram(this.program);
    gl.bindVertexArray(this.attributes);
    gl.enable(gl.DEPTH_TEST);
    gl.viewport(0, 0, w, h);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.uniformMatrix3fv(u.turn, false, camera.turn);
    gl.uniform3fv(u.centre, camera.centre);
    gl.uniform1f(u.explode, camera.explode);
    gl.uniform1f(u.scale, camera.scale);
    gl.uniform1f(u.zoom, camera.zoom);
    gl.uniform1f(u.perspective, camera.flat ? 0 : PERSPECTIVE);
    gl.uniform1f(u.flatLight, camera.flat ? 1 : 0);
    gl.uniform2fv(u.aspect, this.aspect());
    gl.uniform2fv(u.pan, camera.pan);
    gl.uniform3fv(u.palette, palette.slice(0, 64).flat());
    gl.uniform3fv(u.edge, edge);
    gl.uniform1f(u.width, 0.7 * this.density());
    gl.uniform1f(u.selected, chosen);
    gl.drawArrays(gl.TRIANGLES, 0, this.count);
  }

  // Draws into textures with several samples for each pixel, then the whole picture from colours and depths.
  drawFine(camera, palette, edge, chosen) {
    const gl = this.gl, [w, h] = this.size(), targets = this.targets();
    gl.bindFramebuffer(gl.FRAMEBUFFER, targets.many);
    this.drawTriangles(camera, palette, edge, chosen);
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, targets.many);
    gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, targets.one);
    gl.blitFramebuffer(0, 0, w, h, 0, 0, w, h, gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT, gl.NEAREST);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.disable(gl.DEPTH_TEST);
    gl.useProgram(this.whole);
    gl.bindVertexArray(this.nothing);
    const u = this.wholeUniforms, size = Math.min(w, h);
    [targets.picture, targets.depths].forEach((texture, unit) => {
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_2D, texture);
    });
    gl.uniform1i(u.picture, 0);
    gl.uniform1i(u.depths, 1);
    gl.uniform1f(u.perspective, PERSPECTIVE);
    gl.uniform1f(u.near, 0.008 * size);
    gl.uniform1f(u.far, 0.06 * size);
    gl.uniform1f(u.line, this.density());
    gl.uniform4f(u.ink, ...edge, 1);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }

  // Framebuffers of the canvas' size. Every card with WebGL 2 has these formats; to ask whether they are complete would wait for it.
  targets() {
    const gl = this.gl, [w, h] = this.size();
    if (this.kept?.w === w && this.kept?.h === h) return this.kept;
    for (const [kind, item] of this.kept?.items ?? []) gl[`delete${kind}`](item);
    const items = [], made = (kind) => { const item = gl[`create${kind}`](); items.push([kind, item]); return item; };
    const samples = Math.min(4, gl.getParameter(gl.MAX_SAMPLES));
    const many = made("Framebuffer"), one = made("Framebuffer");
    gl.bindFramebuffer(gl.FRAMEBUFFER, many);
    for (const [format, place] of [[gl.RGBA8, gl.COLOR_ATTACHMENT0], [gl.DEPTH_COMPONENT24, gl.DEPTH_ATTACHMENT]]) {
      const buffer = made("Renderbuffer");
      gl.bindRenderbuffer(gl.RENDERBUFFER, buffer);
      gl.renderbufferStorageMultisample(gl.RENDERBUFFER, samples, format, w, h);
      gl.framebufferRenderbuffer(gl.FRAMEBUFFER, place, gl.RENDERBUFFER, buffer);
    }
    gl.bindFramebuffer(gl.FRAMEBUFFER, one);
    const texture = (format, place) => {
      const name = made("Texture");
      gl.bindTexture(gl.TEXTURE_2D, name);
      gl.texStorage2D(gl.TEXTURE_2D, 1, format, w, h);
      for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, filter, gl.NEAREST);
      gl.framebufferTexture2D(gl.FRAMEBUFFER, place, gl.TEXTURE_2D, name, 0);
      return name;
    };
    const picture = texture(gl.RGBA8, gl.COLOR_ATTACHMENT0), depths = texture(gl.DEPTH_COMPONENT24, gl.DEPTH_ATTACHMENT);
    return this.kept = { w, h, many, one, picture, depths, items };
  }

  size() {
    return [this.canvas.width, this.canvas.height];
  }

  // Pixels of the canvas for one of the page.
  density() {
    return Math.max(1, this.canvas.width / Math.max(1, this.canvas.clientWidth));
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
      const depth = 1 - (camera.flat ? 0 : PERSPECTIVE) * p[2] / (1 + camera.explode);
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

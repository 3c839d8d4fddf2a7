// A mesh and points in WebGL2: flat shading from both sides, points on top, a camera that turns.

const MESH = [`#version 300 es
uniform mat4 view;
in vec3 position;
in float part;
out vec3 at;
flat out float which;
void main() {
  at = (view * vec4(position, 1.0)).xyz;
  which = part;
  gl_Position = view * vec4(position, 1.0);
}`, `#version 300 es
precision highp float;
in vec3 at;
flat in float which;
out vec4 colour;
void main() {
  vec3 normal = normalize(cross(dFdx(at), dFdy(at)));
  float light = 0.35 + 0.6 * abs(dot(normal, normalize(vec3(0.3, 0.5, -0.8))));
  vec3 base = which < 0.5 ? vec3(0.52, 0.68, 0.92) : vec3(0.80, 0.80, 0.78);
  colour = vec4(base * light, 1.0);
}`];

const POINTS = [`#version 300 es
uniform mat4 view;
uniform float size;
uniform float now;
uniform float opacity;
in vec3 position;
in float time;
out vec4 tint;
vec3 ramp(float t) {
  vec3 low = mix(vec3(0.99, 0.91, 0.15), vec3(0.98, 0.45, 0.25), smoothstep(0.0, 0.5, t));
  return mix(low, vec3(0.62, 0.10, 0.50), smoothstep(0.5, 1.0, t));
}
void main() {
  bool reached = time <= now;
  tint = vec4(ramp(time), opacity * (reached ? 1.0 : 0.6));
  gl_Position = view * vec4(position, 1.0);
  gl_Position.z -= 0.02;
  gl_PointSize = reached ? size : 0.6 * size;
}`, `#version 300 es
precision highp float;
in vec4 tint;
out vec4 colour;
void main() {
  float r = length(gl_PointCoord - 0.5);
  if (r > 0.5) discard;
  colour = vec4(r > 0.38 ? vec3(0.08) : tint.rgb, tint.a);
}`];

/**
 * A picture of one canvas; null where there is no WebGL2. `lost` is called when the browser takes
 * the graphics back, `restored` when meshes and points have to be set again.
 */
export function picture(canvas, { lost, restored }) {
  const gl = canvas.getContext("webgl2", { antialias: true });
  if (!gl) return null;
  const view = new Picture(canvas, gl);
  canvas.addEventListener("webglcontextlost", (event) => {
    // Without this it is never restored.
    event.preventDefault();
    lost();
  });
  canvas.addEventListener("webglcontextrestored", () => {
    view.setUp();
    restored();
  });
  return view;
}

class Picture {
  constructor(canvas, gl) {
    this.canvas = canvas;
    this.gl = gl;
    this.camera = { turn: 0.6, tilt: 0.45, zoom: 1 };
    this.box = { middle: [0, 0, 0], size: 1 };
    this.now = 1;
    this.setUp();
    this.listen();
    new ResizeObserver(() => this.draw()).observe(canvas);
  }

  /** Programs, and buffers of nothing. */
  setUp() {
    const { gl } = this;
    this.mesh = program(gl, MESH);
    this.dots = program(gl, POINTS);
    this.buffers = ["x", "part", "faces", "points", "times"]
      .reduce((all, name) => ({ ...all, [name]: gl.createBuffer() }), {});
    this.nFaces = 0;
    this.nPoints = 0;
  }

  /** Topology; the first `nFirst` vertices have another colour than the others. */
  setMesh(faces, nVertices, nFirst) {
    const part = Float32Array.from({ length: nVertices }, (_, i) => (i < nFirst ? 0 : 1));
    this.fill("part", part);
    this.fill("faces", faces, this.gl.ELEMENT_ARRAY_BUFFER);
    this.nFaces = faces.length;
  }

  /** What the camera looks at: a box of these positions. */
  lookAt(x) {
    const [lo, hi] = [[Infinity, Infinity, Infinity], [-Infinity, -Infinity, -Infinity]];
    x.forEach((value, i) => {
      lo[i % 3] = Math.min(lo[i % 3], value);
      hi[i % 3] = Math.max(hi[i % 3], value);
    });
    this.box = {
      middle: lo.map((value, k) => (value + hi[k]) / 2),
      size: Math.hypot(...lo.map((value, k) => hi[k] - value)) || 1,
    };
  }

  setPositions(x) {
    this.fill("x", x);
  }

  /** Points with the times that colour them. */
  setPoints(points, times) {
    this.fill("points", points);
    this.fill("times", Float32Array.from(times));
    this.nPoints = times.length;
  }

  fill(name, data, target = this.gl.ARRAY_BUFFER) {
    this.gl.bindBuffer(target, this.buffers[name]);
    this.gl.bufferData(target, data, this.gl.DYNAMIC_DRAW);
  }

  draw() {
    const { gl, canvas } = this;
    const scale = Math.min(devicePixelRatio, 2);
    const [width, height] = [canvas.clientWidth, canvas.clientHeight].map((n) => n * scale | 0);
    if (!width || !height || gl.isContextLost()) return;
    const fits = canvas.width === width && canvas.height === height;
    if (!fits) Object.assign(canvas, { width, height });
    gl.viewport(0, 0, width, height);
    gl.clearColor(0.09, 0.1, 0.13, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.LESS);
    const view = this.view(width / height);
    if (this.nFaces) {
      gl.useProgram(this.mesh);
      gl.uniformMatrix4fv(gl.getUniformLocation(this.mesh, "view"), false, view);
      this.attribute(this.mesh, "position", "x", 3);
      this.attribute(this.mesh, "part", "part", 1);
      gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.buffers.faces);
      gl.drawElements(gl.TRIANGLES, this.nFaces, gl.UNSIGNED_INT, 0);
    }
    if (this.nPoints) {
      gl.enable(gl.BLEND);
      gl.depthMask(false);
      gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
      gl.useProgram(this.dots);
      gl.uniformMatrix4fv(gl.getUniformLocation(this.dots, "view"), false, view);
      gl.uniform1f(gl.getUniformLocation(this.dots, "size"), 7 * scale);
      gl.uniform1f(gl.getUniformLocation(this.dots, "now"), this.now);
      this.attribute(this.dots, "position", "points", 3);
      this.attribute(this.dots, "time", "times", 1);
      // What the mesh hides shines through.
      for (const [opacity, hides] of [[0.45, gl.ALWAYS], [1, gl.LESS]]) {
        gl.uniform1f(gl.getUniformLocation(this.dots, "opacity"), opacity);
        gl.depthFunc(hides);
        gl.drawArrays(gl.POINTS, 0, this.nPoints);
      }
      gl.depthMask(true);
      gl.disable(gl.BLEND);
    }
  }

  attribute(of, name, buffer, n) {
    const { gl } = this;
    const at = gl.getAttribLocation(of, name);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.buffers[buffer]);
    gl.enableVertexAttribArray(at);
    gl.vertexAttribPointer(at, n, gl.FLOAT, false, 0, 0);
  }

  /** Turned, scaled so that the box fills the smaller side, without perspective. */
  view(aspect) {
    const { turn, tilt, zoom } = this.camera;
    const [c, s, ct, st] = [Math.cos(turn), Math.sin(turn), Math.cos(tilt), Math.sin(tilt)];
    const rows = [[c, 0, -s], [-s * st, ct, -c * st], [-s * ct, -st, -c * ct]];
    const scale = 1.9 * zoom / this.box.size;
    const scales = [scale / Math.max(aspect, 1), scale * Math.min(aspect, 1), 0.45 / this.box.size];
    const out = new Float32Array(16);
    rows.forEach((row, k) => {
      row.forEach((value, j) => { out[4 * j + k] = value * scales[k]; });
      out[12 + k] = -scales[k] * row.reduce((sum, value, j) => sum + value * this.box.middle[j], 0);
    });
    out[15] = 1;
    return out;
  }

  /** Dragging and arrows turn, the wheel, two fingers and + - zoom. */
  listen() {
    const { canvas, camera } = this;
    const move = (turn, tilt, zoom = 1) => {
      camera.turn += turn;
      camera.tilt = Math.max(-1.5, Math.min(1.5, camera.tilt + tilt));
      camera.zoom = Math.max(0.2, Math.min(20, camera.zoom * zoom));
      this.draw();
    };
    /** Where each finger is, or the mouse while a button is down. */
    const pointers = new Map();
    const spread = ([p, q]) => Math.hypot(p[0] - q[0], p[1] - q[1]);
    canvas.addEventListener("pointerdown", ({ pointerId, clientX, clientY }) => {
      canvas.setPointerCapture(pointerId);
      pointers.set(pointerId, [clientX, clientY]);
    });
    canvas.addEventListener("pointermove", ({ pointerId, clientX, clientY }) => {
      if (!pointers.has(pointerId)) return;
      const before = [...pointers.values()];
      const [x, y] = pointers.get(pointerId);
      pointers.set(pointerId, [clientX, clientY]);
      if (before.length === 1) move((clientX - x) * 0.008, (clientY - y) * 0.008);
      if (before.length !== 2) return;
      move(0, 0, spread([...pointers.values()]) / Math.max(spread(before), 1));
    });
    // After the button or the finger is up, too.
    canvas.addEventListener("lostpointercapture", ({ pointerId }) => pointers.delete(pointerId));
    canvas.addEventListener("wheel", (event) => {
      event.preventDefault();
      move(0, 0, Math.exp(-event.deltaY * 0.001));
    }, { passive: false });
    const keys = {
      ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1],
      "+": [0, 0, 1.15], "=": [0, 0, 1.15], "-": [0, 0, 1 / 1.15],
    };
    canvas.addEventListener("keydown", (event) => {
      if (!keys[event.key]) return;
      event.preventDefault();
      move(...keys[event.key]);
    });
  }
}

function program(gl, sources) {
  const all = gl.createProgram();
  [gl.VERTEX_SHADER, gl.FRAGMENT_SHADER].forEach((type, i) => {
    const shader = gl.createShader(type);
    gl.shaderSource(shader, sources[i]);
    gl.compileShader(shader);
    gl.attachShader(all, shader);
  });
  gl.linkProgram(all);
  if (!gl.getProgramParameter(all, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(all));
  return all;
}

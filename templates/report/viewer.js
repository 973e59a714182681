// SPDX-License-Identifier: MIT-0
// A small viewer on WebGL: shaded shapes, lines, a camera that goes round. It is our own because what it draws is a
// cylinder, a cone, a sphere and a box: the libraries that draw more are several times larger than the whole page.
(() => {
"use strict";
const { add, scaled, cross, dot, unit, triad, affine, product, looking, perspective } = torsorReport.vectors;

const vertexShader = `
attribute vec3 position, normal;
uniform mat4 place, view;
uniform mat3 turn;
varying vec3 outwards;
void main() {
  outwards = turn * normal;
  gl_Position = view * place * vec4(position, 1.0);
}`;
const fragmentShader = `
precision mediump float;
uniform vec4 colour;
uniform vec3 light;
uniform float shaded;
varying vec3 outwards;
void main() {
  float lit = 0.45 + 0.55 * abs(dot(normalize(outwards + vec3(1e-6)), light));
  gl_FragColor = vec4(colour.rgb * mix(1.0, lit, shaded), colour.a);
}`;

/// Corners and normals of triangles: a surface of revolution about z with the given profile [radius, height, slope].
function revolved(profile, parts = 24) {
  const corners = [], ring = (k) => [Math.cos((2 * Math.PI * k) / parts), Math.sin((2 * Math.PI * k) / parts)];
  const corner = ([r, z, nr, nz], k) => {
    const [c, s] = ring(k);
    return [r * c, r * s, z, nr * c, nr * s, nz];
  };
  for (let i = 0; i + 1 < profile.length; i += 2) {
    for (let k = 0; k < parts; ++k) {
      const [a, b, c, d] = [corner(profile[i], k), corner(profile[i], k + 1), corner(profile[i + 1], k + 1), corner(profile[i + 1], k)];
      corners.push(...a, ...b, ...c, ...a, ...c, ...d);
    }
  }
  return new Float32Array(corners);
}

function sphere() {
  const profile = [], parts = 20;
  const at = (k) => {
    const angle = -Math.PI / 2 + (Math.PI * k) / parts;
    return [Math.cos(angle), Math.sin(angle), Math.cos(angle), Math.sin(angle)];
  };
  for (let k = 0; k < parts; ++k) profile.push(at(k), at(k + 1));
  return revolved(profile, 40);
}

function box() {
  const corners = [];
  for (const axis of [0, 1, 2]) {
    for (const sign of [-1, 1]) {
      const normal = [0, 0, 0], u = [0, 0, 0], v = [0, 0, 0];
      normal[axis] = sign, u[(axis + 1) % 3] = 1, v[(axis + 2) % 3] = 1;
      const at = (a, b) => [...add(add(normal, u, a), v, b), ...normal];
      corners.push(...at(-1, -1), ...at(1, -1), ...at(1, 1), ...at(-1, -1), ...at(1, 1), ...at(-1, 1));
    }
  }
  return new Float32Array(corners);
}

const fieldOfView = 0.7;  // from the lower to the upper edge

const meshes = {
  cylinder: () => revolved([[1, 0, 1, 0], [1, 1, 1, 0], [0, 0, 0, -1], [1, 0, 0, -1], [1, 1, 0, 1], [0, 1, 0, 1]]),
  cone: () => revolved([[1, 0, 0.7, 0.7], [0, 1, 0.7, 0.7], [0, 0, 0, -1], [1, 0, 0, -1]]),
  sphere,
  box,
};

class Viewer {
  /// Throws where the browser has no WebGL.
  constructor(canvas) {
    this.canvas = canvas;
    const gl = canvas.getContext("webgl", { antialias: true, alpha: true, preserveDrawingBuffer: true });
    if (!gl) throw new Error("«this browser has no WebGL»");
    this.gl = gl;
    const program = gl.createProgram();
    for (const [type, text] of [[gl.VERTEX_SHADER, vertexShader], [gl.FRAGMENT_SHADER, fragmentShader]]) {
      const shader = gl.createShader(type);
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
    gl.useProgram(program);
    this.at = Object.fromEntries(["place", "view", "turn", "colour", "light", "shaded"].map((name) => [name, gl.getUniformLocation(program, name)]));
    this.position = gl.getAttribLocation(program, "position");
    this.normal = gl.getAttribLocation(program, "normal");
    gl.enableVertexAttribArray(this.position);
    gl.enable(gl.DEPTH_TEST);
    this.buffers = {};
    for (const [name, make] of Object.entries(meshes)) this.mesh(name, make());
    this.lineBuffer = gl.createBuffer();
    this.home({ target: [0, 0, 0], up: [0, 0, 1], from: [1, -1, 0.6], size: 1 });
    this.listen();
  }

  /// Makes a mesh known: corners of triangles, each with its normal.
  mesh(name, corners) {
    const { gl } = this, buffer = gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, corners, gl.STATIC_DRAW);
    this.buffers[name] = { buffer, count: corners.length / 6 };
  }

  /// Where the camera stands first, and where `reset` brings it back to.
  home(place) {
    this.first = place;
    this.reset();
  }
  reset() {
    const { target, up, from, size, places } = this.first;
    this.target = target;
    this.up = unit(up);
    const [x, y] = triad(this.up), view = unit(from);
    this.elevation = Math.asin(Math.max(-1, Math.min(1, dot(view, this.up))));
    this.azimuth = Math.atan2(dot(view, y), dot(view, x));
    this.distance = places ? this.fitting(places, 2.5 * size) : 3.1 * size;
    this.changed = true;
  }

  /// The unit vector from the target to the eye.
  towardsEye() {
    const [x, y] = triad(this.up), flat = Math.cos(this.elevation);
    return add(add(scaled(x, flat * Math.cos(this.azimuth)), y, flat * Math.sin(this.azimuth)), this.up, Math.sin(this.elevation));
  }

  /// How far the eye must be for balls [place, radius] to be in the picture; no nearer than `least`, for what moves later.
  fitting(places, least) {
    const view = this.towardsEye(), x = unit(cross(this.up, view), [1, 0, 0]), y = cross(view, x);
    const upwards = 0.92 * Math.tan(fieldOfView / 2), sideways = (upwards * (this.canvas.clientWidth || 1)) / (this.canvas.clientHeight || 1);
    return places.reduce((far, [place, radius]) => {
      const from = add(place, this.target, -1), over = (axis) => Math.abs(dot(from, axis)) + radius;
      return Math.max(far, dot(from, view) + Math.max(over(x) / sideways, over(y) / upwards));
    }, least);
  }

  orbit(about, above) {
    this.azimuth += about;
    this.elevation = Math.max(-1.55, Math.min(1.55, this.elevation + above));
    this.changed = true;
  }
  zoom(factor) {
    this.distance *= factor;
    this.changed = true;
  }

  listen() {
    const { canvas } = this, fingers = new Map();
    canvas.addEventListener("pointerdown", (event) => {
      canvas.setPointerCapture(event.pointerId);
      fingers.set(event.pointerId, [event.clientX, event.clientY]);
    });
    const leave = (event) => fingers.delete(event.pointerId);
    canvas.addEventListener("pointerup", leave);
    canvas.addEventListener("pointercancel", leave);
    canvas.addEventListener("pointermove", (event) => {
      const before = fingers.get(event.pointerId);
      if (!before) return;
      const apart = () => {
        const [a, b] = [...fingers.values()];
        return Math.hypot(a[0] - b[0], a[1] - b[1]);
      };
      const old = fingers.size === 2 ? apart() : 0;
      fingers.set(event.pointerId, [event.clientX, event.clientY]);
      if (fingers.size === 2) this.zoom(old / Math.max(apart(), 1));
      else this.orbit(-(event.clientX - before[0]) * 0.008, (event.clientY - before[1]) * 0.008);
    });
    canvas.addEventListener("wheel", (event) => {
      event.preventDefault();
      this.zoom(Math.exp(event.deltaY * 0.001));
    }, { passive: false });
    canvas.addEventListener("keydown", (event) => {
      const step = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1] }[event.key];
      if (step) this.orbit(...step);
      else if (event.key === "+" || event.key === "=") this.zoom(0.9);
      else if (event.key === "-") this.zoom(1.1);
      else if (event.key === "0") this.reset();
      else return;
      event.preventDefault();
    });
  }

  /// Draws shapes {mesh, x, y, z, origin, colour, above} and lines {points, colour, pairs}; what is `above` hides all else.
  draw({ shapes, lines }) {
    const { gl, canvas, at } = this, ratio = Math.min(window.devicePixelRatio || 1, 2);
    const width = Math.max(1, Math.round(canvas.clientWidth * ratio)), height = Math.max(1, Math.round(canvas.clientHeight * ratio));
    if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
    gl.viewport(0, 0, width, height);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    const view = this.towardsEye(), eye = add(this.target, view, this.distance);
    const seen = looking(eye, this.target, this.up);
    gl.uniformMatrix4fv(at.view, false, product(perspective(fieldOfView, width / height, this.distance / 100, this.distance * 30), seen));
    gl.uniform3fv(at.light, unit(add(add(view, this.up, 0.6), cross(this.up, view), 0.4)));
    this.drawShapes(shapes.filter((shape) => !shape.above));
    this.drawLines(lines);
    gl.clear(gl.DEPTH_BUFFER_BIT);
    this.drawShapes(shapes.filter((shape) => shape.above));
    this.changed = false;
  }

  drawShapes(shapes) {
    const { gl, at } = this;
    gl.uniform1f(at.shaded, 1);
    gl.enableVertexAttribArray(this.normal);
    let bound = null;
    for (const shape of shapes) {
      const { buffer, count } = this.buffers[shape.mesh];
      if (bound !== buffer) {
        gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
        gl.vertexAttribPointer(this.position, 3, gl.FLOAT, false, 24, 0);
        gl.vertexAttribPointer(this.normal, 3, gl.FLOAT, false, 24, 12);
        bound = buffer;
      }
      const axes = [shape.x, shape.y, shape.z];
      gl.uniformMatrix4fv(at.place, false, affine(...axes, shape.origin));
      // Normals turn with the inverse of the transpose: orthogonal axes over their squared lengths.
      gl.uniformMatrix3fv(at.turn, false, new Float32Array(axes.flatMap((axis) => scaled(axis, 1 / Math.max(dot(axis, axis), 1e-30)))));
      gl.uniform4fv(at.colour, [...shape.colour, 1]);
      gl.drawArrays(gl.TRIANGLES, 0, count);
    }
  }

  drawLines(lines) {
    const { gl, at } = this;
    gl.uniform1f(at.shaded, 0);
    gl.uniformMatrix4fv(at.place, false, affine([1, 0, 0], [0, 1, 0], [0, 0, 1], [0, 0, 0]));
    gl.disableVertexAttribArray(this.normal);
    gl.vertexAttrib3f(this.normal, 0, 0, 1);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.lineBuffer);
    gl.vertexAttribPointer(this.position, 3, gl.FLOAT, false, 12, 0);
    for (const line of lines) {
      gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(line.points), gl.DYNAMIC_DRAW);
      gl.uniform4fv(at.colour, [...line.colour, 1]);
      gl.drawArrays(line.pairs ? gl.LINES : gl.LINE_STRIP, 0, line.points.length / 3);
    }
  }
}

torsorReport.Viewer = Viewer;
})();

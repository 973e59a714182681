// SPDX-License-Identifier: MIT-0
// Curves over time on a canvas, tied to the time of the animation.
(() => {
"use strict";
const colours = ["#2266bb", "#cc4b33", "#33935a", "#985bb3", "#c98f10", "#1a94a6", "#c65a8c", "#72802f"];
const eventColour = "#c03070";

function label(value) {
  if (value === 0) return "0";
  const size = Math.abs(value);
  return size >= 1e5 || size < 1e-3 ? value.toExponential(2) : String(Number(value.toPrecision(4)));
}

/// A unit as people write it: kg m² s⁻².
function written(unit) {
  return unit === "1" ? "" : unit.replace(/\^(-?\d+)/g, (_, power) => [...power].map((c) => (c === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[c])).join(""));
}

/// A canvas with a mark over it, which follows the animation. Curves are drawn when they change: without a graphics card
/// that takes a browser most of a frame. `sources` give numbers of sample k.
class Chart {
  constructor(parent, title, words, sources) {
    this.sources = sources;
    this.clear();
    this.canvas = document.createElement("canvas");
    this.canvas.className = "plot";
    this.canvas.setAttribute("role", "img");
    this.canvas.setAttribute("aria-label", words);
    this.mark = document.createElement("div");
    this.figure = document.createElement("figure");
    const caption = document.createElement("figcaption"), plane = document.createElement("div");
    caption.textContent = title;
    plane.className = "plane";
    plane.append(this.canvas, this.mark);
    this.figure.append(caption, plane);
    parent.append(this.figure);
  }

  clear() {
    this.data = this.sources.map(() => []);
    this.picture = "";
  }

  /// Reads samples that came since.
  read(count) {
    this.sources.forEach((source, i) => {
      for (let k = this.data[i].length; k < count; ++k) this.data[i].push(source(k));
    });
  }

  /// An empty canvas where this picture, which `content` tells from others, is not there yet; `draw` gets its context, its size
  /// and its colours.
  drawOnce(content, draw) {
    const { canvas } = this, ratio = Math.min(window.devicePixelRatio || 1, 2), box = [canvas.clientWidth, canvas.clientHeight];
    if (box[0] === 0) return;
    const style = getComputedStyle(canvas), colour = { ink: style.color };
    for (const name of ["line", "back"]) colour[name] = style.getPropertyValue(`--${name}`);
    const picture = [...content, ...box, ratio, ...Object.values(colour)].join();
    if (picture === this.picture) return;
    this.picture = picture;
    canvas.width = Math.round(box[0] * ratio), canvas.height = Math.round(box[1] * ratio);
    const context = canvas.getContext("2d");
    context.scale(ratio, ratio);
    context.font = "11px system-ui, sans-serif";
    draw(context, box, colour);
  }

  moveMark(x, y) { this.mark.style.transform = `translate(${x}px, ${y}px)`; }
}

class Plot extends Chart {
  /// `curves`: [{name, unit, value(k)}]; `words` says for those who do not see it what it shows.
  constructor(parent, title, unit, curves, onTime) {
    const shown = unit ? `${title} [${written(unit)}]` : title;
    super(parent, shown, `${shown}« over time: »${curves.map((curve) => curve.name).join(", ")}`,
          curves.map((curve) => curve.value));
    Object.assign(this, { unit, curves, title });
    this.mark.className = "instant";
    this.legend = document.createElement("ul");
    this.legend.className = "legend";
    this.values = curves.map((curve, i) => {
      const item = document.createElement("li"), mark = document.createElement("span"), value = document.createElement("span");
      mark.className = "mark";
      mark.style.background = colours[i % colours.length];
      value.className = "value";
      item.append(mark, document.createTextNode(curve.name + " "), value);
      this.legend.append(item);
      return value;
    });
    this.figure.append(this.legend);
    const at = (event) => {
      if (event.type === "pointermove" && event.buttons === 0) return;
      const box = this.canvas.getBoundingClientRect();
      onTime(((event.clientX - box.left - 56) / Math.max(1, box.width - 66)) * this.end);
    };
    this.canvas.addEventListener("pointerdown", at);
    this.canvas.addEventListener("pointermove", at);
  }

  /// `events`: [{time}], marked on the axis of time.
  draw(interval, end, now, events = []) {
    this.end = end;
    this.drawOnce([this.data[0].length, end, events.length, this.withDots], (context, box, colour) => {
      this.drawCurves(context, box, colour, interval, events);
    });
    if (this.sides) this.moveMark(this.sides[0] + (this.sides[1] - this.sides[0]) * now / end, 0);
    const k = Math.round(now / interval);
    this.values.forEach((value, i) => {
      value.textContent = k < this.data[i].length ? label(this.data[i][k]) : "";
    });
  }

  drawCurves(context, box, colour, interval, events) {
    const { end } = this;
    let low = Infinity, high = -Infinity;
    for (const data of this.data) for (const value of data) if (Number.isFinite(value)) [low, high] = [Math.min(low, value), Math.max(high, value)];
    if (!(low <= high)) [low, high] = [-1, 1];
    const least = 1e-12 * Math.max(1e-6, Math.abs(low), Math.abs(high));
    if (high - low < least) [low, high] = [low - Math.max(least, 0.5 * Math.abs(low) || 1), high + Math.max(least, 0.5 * Math.abs(high) || 1)];
    const left = 56, right = box[0] - 10, top = 8, bottom = box[1] - 18;
    this.sides = [left, right];
    const x = (t) => left + ((right - left) * t) / end, y = (v) => bottom - ((bottom - top) * (v - low)) / (high - low);
    context.strokeStyle = colour.line;
    context.fillStyle = colour.ink;
    context.lineWidth = 1;
    const stepY = torsorReport.niceStep((high - low) / 4), stepX = torsorReport.niceStep(end / 6);
    context.textAlign = "right";
    for (let v = Math.ceil(low / stepY) * stepY; v <= high + 1e-9 * stepY; v += stepY) {
      line(context, left, y(v), right, y(v));
      context.fillText(label(Math.abs(v) < 1e-9 * stepY ? 0 : v), left - 4, y(v) + 4);
    }
    context.textAlign = "center";
    for (let t = 0; t <= end * (1 + 1e-9); t += stepX) {
      line(context, x(t), top, x(t), bottom);
      context.fillText(label(t), x(t), bottom + 13);
    }
    context.strokeStyle = eventColour;
    for (const { time } of events) line(context, x(time), bottom - 7, x(time), bottom);
    context.lineWidth = 1.6;
    this.data.forEach((data, i) => {
      context.strokeStyle = colours[i % colours.length];
      context.beginPath();
      const stride = Math.max(1, Math.floor(data.length / (2 * (right - left))));
      for (let k = 0; k < data.length; k += stride) {
        if (k === 0) context.moveTo(x(0), y(data[0]));
        else context.lineTo(x(k * interval), y(data[k]));
      }
      context.stroke();
    });
    if (this.withDots) this.drawDots(context, x, y, colour.back);
  }

  /// The reference trajectory's.
  drawDots(context, x, y, edge) {
    this.curves.forEach(({ dots = [] }, i) => {
      for (const [t, value] of dots) {
        if (t > this.end) continue;
        context.beginPath();
        context.arc(x(t), y(value), 4, 0, 2 * Math.PI);
        context.fillStyle = colours[i % colours.length];
        context.strokeStyle = edge;
        context.lineWidth = 1.5;
        context.fill();
        context.stroke();
      }
    });
  }

  /// Words for the picture, when the motion stands still.
  describe() {
    const ranges = this.curves.map((curve, i) => {
      const data = this.data[i].filter(Number.isFinite);
      const [low, high] = data.reduce(([a, b], v) => [Math.min(a, v), Math.max(b, v)], [Infinity, -Infinity]);
      return `${curve.name} «between ${label(low)} and ${label(high)}»`;
    });
    this.canvas.setAttribute("aria-label", `${this.title}« over time: »${ranges.join("; ")} ${this.unit}`);
  }
}

/// A phase portrait: one quantity over another, with a dot where the motion is.
class Portrait extends Chart {
  constructor(parent, title, acrossName, upName, { x, y }) {
    super(parent, title, `«Phase portrait, »${title}`, [x, y]);
    Object.assign(this, { title, acrossName, upName });
    this.mark.className = "place";
    this.mark.style.background = colours[1];
  }

  draw(interval, end, now) {
    if (this.data[0].length === 0) return;
    this.drawOnce([this.data[0].length], (context, box, colour) => this.drawCurve(context, box, colour));
    const k = Math.min(this.data[0].length - 1, Math.round(now / interval));
    if (this.at) this.moveMark(...this.at(k));
  }

  drawCurve(context, box, colour) {
    const extent = (data) => {
      let low = Infinity, high = -Infinity;
      for (const value of data) if (Number.isFinite(value)) [low, high] = [Math.min(low, value), Math.max(high, value)];
      if (!(low <= high)) return [-1, 1];
      const pad = Math.max(0.05 * (high - low), 1e-9 * Math.max(1, Math.abs(low), Math.abs(high)));
      return [low - pad, high + pad];
    };
    const [[x0, x1], [y0, y1]] = this.data.map(extent), left = 56, right = box[0] - 10, top = 8, bottom = box[1] - 32;
    const x = (v) => left + ((right - left) * (v - x0)) / (x1 - x0), y = (v) => bottom - ((bottom - top) * (v - y0)) / (y1 - y0);
    this.at = (k) => [x(this.data[0][k]), y(this.data[1][k])];
    context.strokeStyle = colour.line;
    context.fillStyle = colour.ink;
    context.lineWidth = 1;
    const stepX = torsorReport.niceStep((x1 - x0) / 5), stepY = torsorReport.niceStep((y1 - y0) / 4);
    context.textAlign = "right";
    for (let v = Math.ceil(y0 / stepY) * stepY; v <= y1; v += stepY) {
      line(context, left, y(v), right, y(v));
      context.fillText(label(Math.abs(v) < 1e-9 * stepY ? 0 : v), left - 4, y(v) + 4);
    }
    context.textAlign = "center";
    for (let v = Math.ceil(x0 / stepX) * stepX; v <= x1; v += stepX) {
      line(context, x(v), top, x(v), bottom);
      context.fillText(label(Math.abs(v) < 1e-9 * stepX ? 0 : v), x(v), bottom + 13);
    }
    context.fillText(this.acrossName, (left + right) / 2, box[1] - 4);
    context.lineWidth = 1.4;
    context.strokeStyle = colours[0];
    context.beginPath();
    this.data[0].forEach((value, k) => (k === 0 ? context.moveTo(x(value), y(this.data[1][k])) : context.lineTo(x(value), y(this.data[1][k]))));
    context.stroke();
  }

  describe() {
    const range = (data) => data.reduce(([a, b], v) => [Math.min(a, v), Math.max(b, v)], [Infinity, -Infinity]).map(label).join("« and »");
    this.canvas.setAttribute("aria-label", `«Phase portrait: »${this.acrossName}« between »${range(this.data[0])}, ${this.upName}« between »${range(this.data[1])}`);
  }
}

function line(context, x1, y1, x2, y2) {
  context.beginPath();
  context.moveTo(x1, y1);
  context.lineTo(x2, y2);
  context.stroke();
}

Object.assign(torsorReport, { Plot, Portrait, label, written });
})();

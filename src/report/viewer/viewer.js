// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// The view in three dimensions of a report: points, outlines, sections, measures. One WebGL 2 context, nothing loaded.
// Lengths are metres from the scene's origin; the camera turns about `eye.at`. viewer/packing.cpp writes the points.
"use strict";
(async () => {
const started = performance.now();
const $ = (id) => document.getElementById("view-" + id);
const scene = JSON.parse($("scene").textContent);
const canvas = $("gl"), over = $("over"), bar = $("bar"), told = $("told");
const say = (text) => { told.textContent = text; };
const gl = canvas.getContext("webgl2", {antialias: true, preserveDrawingBuffer: true});
if (!gl || !window.DecompressionStream) {
  $("box").remove();
  return say("This browser has no WebGL 2: the pictures above show the same.");
}

// ---- points: two planes of bytes a number, differences of neighbours, zigzag
const hex = (text) => [1, 3, 5].map((i) => parseInt(text.slice(i, i + 2), 16));
const digit = Uint8Array.from({length: 128}, (_, c) => c < 60 ? c - 36 : c - 37);
const inflate = async (packed) => {
  const stream = new DecompressionStream("deflate"), writer = stream.writable.getWriter(), reader = stream.readable.getReader();
  writer.write(packed);
  writer.close();
  const parts = [];
  let size = 0;
  for (let part; !(part = await reader.read()).done; size += part.value.length) parts.push(part.value);
  const out = new Uint8Array(size);
  size = 0;
  for (const part of parts) { out.set(part, size); size += part.length; }
  return out;
};
const unpack = (i) => {
  const text = new TextEncoder().encode($("data-" + i).textContent), words = new DataView(new ArrayBuffer(text.length / 5 * 4));
  for (let k = 0, at = 0; at < text.length; k += 4, at += 5)
    words.setUint32(k, (((digit[text[at]] * 85 + digit[text[at + 1]]) * 85 + digit[text[at + 2]]) * 85 + digit[text[at + 3]]) * 85
      + digit[text[at + 4]]);
  return inflate(new Uint8Array(words.buffer, 0, scene.clouds[i].bytes));
};
const clouds = [];
for (let i = 0; i < scene.clouds.length; i++) {
  const cloud = Object.assign({shown: true}, scene.clouds[i]), n = cloud.n, raw = await unpack(i);
  let at = 0;
  // To every stride-th place of out.
  const read = (out, stride, first, bytes, plain) => {
    const low = raw.subarray(at, at += n), high = bytes > 1 ? raw.subarray(at, at += n) : null, kept = plain ? 0 : -1;
    for (let k = 0, to = first, v = 0; k < n; k++, to += stride) {
      const z = high ? low[k] | high[k] << 8 : low[k];
      v = (v & kept) + (z >>> 1 ^ -(z & 1));
      out[to] = high ? v : v & 255;
    }
    return out;
  };
  const numbers = (bytes, plain) => read(new Uint16Array(n), 1, 0, bytes, plain);
  cloud.q = new Uint16Array(4 * n);
  for (let a = 0; a < 3; a++) read(cloud.q, 4, a, 2);
  for (const c of cloud.channels) {
    if (c.kind == "rgb") c.v = [numbers(1), numbers(1), numbers(1)];
    else if (c.kind == "label") c.v = numbers(2);
    else c.v = new Int16Array(numbers(2, c.plain).buffer);
  }
  clouds.push(cloud);
}

const decoded = performance.now() - started;

// ---- small algebra: 4 x 4 matrices by columns
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const sub = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const mul = (a, b) => {
  const o = new Float64Array(16);
  for (let i = 0; i < 4; i++) for (let j = 0; j < 4; j++)
  for (let k = 0; k < 4; k++) o[i * 4 + j] += a[k * 4 + j] * b[i * 4 + k];
  return o;
};
const apply = (m, p) => [0, 1, 2, 3].map((i) => m[i] * p[0] + m[4 + i] * p[1] + m[8 + i] * p[2] + m[12 + i]);
const fixed = (v, d) => v.toFixed(d);
const place = (p) => p.map((v, i) => fixed(v + scene.origin[i], 3)).join("  ");

// ---- what is drawn
const shader = (type, text) => {
  const s = gl.createShader(type);
  gl.shaderSource(s, "#version 300 es\nprecision highp float;\nprecision highp int;\n" + text);
  gl.compileShader(s);
  if (!gl.getShaderParameter(s, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(s));
  return s;
};
const program = (vertex, fragment) => {
  const p = gl.createProgram();
  gl.attachShader(p, shader(gl.VERTEX_SHADER, vertex));
  gl.attachShader(p, shader(gl.FRAGMENT_SHADER, fragment));
  gl.linkProgram(p);
  return p;
};
const pointProgram = program(`layout(location=0) in uvec4 q; layout(location=1) in vec4 c;
  uniform mat4 view, pose; uniform float step, size, room; uniform vec4 cut; out vec3 colour;
  void main() { vec4 p = pose * vec4(vec3(q.xyz) * step, 1.); colour = c.rgb;
    gl_Position = abs(dot(cut.xyz, p.xyz) - cut.w) > room ? vec4(2., 2., 2., 1.) : view * p;
    gl_PointSize = clamp(size / gl_Position.w, 1.5, 14.); }`,
  "in vec3 colour; out vec4 o; void main() { o = vec4(colour, 1.); }");
const lineProgram = program(`layout(location=0) in vec3 p; layout(location=1) in vec4 c;
  uniform mat4 view; uniform float room; uniform vec4 cut; out vec3 colour; out float off;
  void main() { gl_Position = view * vec4(p, 1.); gl_Position.z -= .0006 * gl_Position.w; colour = c.rgb;
    off = abs(dot(cut.xyz, p) - cut.w) - room; }`,
  "in vec3 colour; in float off; out vec4 o; void main() { if (off > 0.) discard; o = vec4(colour, 1.); }");
const uniform = (p, name) => gl.getUniformLocation(p, name);
const buffer = (data, attribute, size, type, normal, whole, stride) => {
  gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
  gl.bufferData(gl.ARRAY_BUFFER, data, gl.STATIC_DRAW);
  gl.enableVertexAttribArray(attribute);
  if (whole) gl.vertexAttribIPointer(attribute, size, type, stride, 0);
  else gl.vertexAttribPointer(attribute, size, type, normal, stride, 0);
  return gl.getParameter(gl.ARRAY_BUFFER_BINDING);
};
for (const c of clouds) {
  c.vao = gl.createVertexArray();
  gl.bindVertexArray(c.vao);
  c.places = buffer(c.q, 0, 4, gl.UNSIGNED_SHORT, false, true, 8);
  c.colours = buffer(new Uint8Array(4 * c.n), 1, 4, gl.UNSIGNED_BYTE, true, false, 4);
}
const ends = [], inks = [], low = [1e9, 1e9, 1e9], high = [-1e9, -1e9, -1e9];
const widen = (p) => p.forEach((v, i) => { low[i] = Math.min(low[i], v); high[i] = Math.max(high[i], v); });
const rings = (part) => part.rings.map((r) => Array.from({length: r.length / 3}, (_, i) => r.slice(3 * i, 3 * i + 3)));
for (const part of scene.parts) {
  part.first = ends.length / 3;
  const ink = hex(part.colour);
  for (const ring of rings(part)) ring.forEach((p, i) => {
      ends.push(...p, ...ring[(i + 1) % ring.length]);
      inks.push(...ink, 255, ...ink, 255);
      widen(p);
    });
  part.count = ends.length / 3 - part.first;
  const outer = rings(part)[0] || [];
  part.middle = [0, 1, 2].map((k) => outer.reduce((s, p) => s + p[k], 0) / Math.max(1, outer.length));
  part.normal = outer.reduce((s, p, i) => cross(sub(p, part.middle), sub(outer[(i + 1) % outer.length], part.middle))
    .map((v, k) => v + s[k]), [0, 0, 0]);
  part.area = Math.hypot(...part.normal) / 2;
}
const lines = gl.createVertexArray();
gl.bindVertexArray(lines);
buffer(new Float32Array(ends), 0, 3, gl.FLOAT, false, false, 12);
buffer(new Uint8Array(inks), 1, 4, gl.UNSIGNED_BYTE, true, false, 4);
for (const c of clouds) for (let corner = 0; corner < 8 && c.n; corner++)
widen(apply(c.pose, [0, 1, 2].map((a) => corner >> a & 1 ? c.size[a] : 0)).slice(0, 3));
if (low[0] > high[0]) { low.fill(0); high.fill(1); }
const focus = scene.focus || [...low, ...high], size = Math.max(.1, Math.hypot(...sub(focus.slice(3), focus.slice(0, 3))));
const reach = Math.max(.1, Math.hypot(...sub(high, low)));

// ---- colours
const ramp = ["#30366d", "#2c728e", "#35a17c", "#a5c94a", "#f4e07a"].map(hex);
const between = (stops, t) => {
  const at = Math.min(1, Math.max(0, t)) * (stops.length - 1), i = Math.min(stops.length - 2, Math.floor(at));
  return stops[i].map((v, k) => v + (at - i) * (stops[i + 1][k] - v));
};
const modes = [...new Set(clouds.flatMap((c) => c.channels.map((x) => x.name)))];
if (clouds.length > 1 || !modes.length) modes.push("cloud");
modes.push("height");
const channel = (c, mode) => c.channels.find((x) => x.name == mode);
const legendOf = (mode) => clouds.map((c) => channel(c, mode)).find((x) => x);
const paint = () => {
  for (const c of clouds) {
    const out = new Uint8Array(4 * c.n), x = channel(c, eye.mode), n = c.n;
    const put = (k, rgb) => { out[4 * k] = rgb[0]; out[4 * k + 1] = rgb[1]; out[4 * k + 2] = rgb[2]; };
    if (x && x.kind == "rgb") for (let k = 0; k < n; k++) put(k, [x.v[0][k], x.v[1][k], x.v[2][k]]);
    else if (x && x.kind == "label") {
      const table = x.colours.map(hex);
      for (let k = 0; k < n; k++) put(k, table[Math.min(x.v[k], table.length - 1)]);
    } else if (x) {
      const table = x.colours.map(hex), s = x.step / (x.high - x.low), off = x.low / x.step;
      const none = x.none.map((e) => hex(e[0]));
      for (let k = 0; k < n; k++) {
        const v = x.v[k];
        put(k, v < -32765 ? none[v + 32768] :
            table[Math.min(table.length - 1, Math.max(0, Math.floor((v - off) * s * table.length)))]);
      }
    } else if (eye.mode == "height") {
      const m = c.pose, table = Array.from({length: 256}, (_, i) => between(ramp, i / 255)), h = Math.max(1e-6, focus[5] - focus[2]);
      for (let k = 0; k < n; k++) {
        const z = (m[2] * c.q[4 * k] + m[6] * c.q[4 * k + 1] + m[10] * c.q[4 * k + 2]) * c.step + m[14];
        put(k, table[Math.min(255, Math.max(0, Math.floor((z - focus[2]) / h * 256)))]);
      }
    } else { const ink = hex(c.colour); for (let k = 0; k < n; k++) put(k, ink); }
    gl.bindBuffer(gl.ARRAY_BUFFER, c.colours);
    gl.bufferData(gl.ARRAY_BUFFER, out, gl.STATIC_DRAW);
  }
};

// ---- camera
const front = Math.atan2(scene.axes[1][1], scene.axes[1][0]);
const home = {az: front + .45, el: .3, far: size * 1.1, at: [0, 1, 2].map((i) => (focus[i] + focus[i + 3]) / 2), flat: 0, mode: modes[0], cut: 0,
  pos: .5, wide: .1, mask: clouds.reduce((m, c, i) => m | (c.hidden ? 0 : 1 << i), 0), side: 0, names: 1};
let eye = Object.assign({}, home), parts = null, marks = [], picked = null, moving = false;
const kLens = 1 / Math.tan(.4);
const camera = (width, height) => {
  const c = Math.cos(eye.el), back = [Math.cos(eye.az) * c, Math.sin(eye.az) * c, Math.sin(eye.el)];
  const right = [-Math.sin(eye.az), Math.cos(eye.az), 0], up = cross(back, right);
  const from = eye.at.map((v, i) => v + eye.far * back[i]), deep = eye.far + 2 * reach, near = Math.max(eye.far * .01, eye.far - 2 * reach);
  const view = [right[0], up[0], back[0], 0, right[1], up[1], back[1], 0, right[2], up[2], back[2], 0,
    -dot(right, from), -dot(up, from), -dot(back, from), 1];
  const s = kLens * height / width, f = eye.flat ? kLens / eye.far : 0;
  const lens = eye.flat ? [f * height / width, 0, 0, 0, 0, f, 0, 0, 0, 0, -1 / (2 * reach + eye.far), 0, 0, 0, 0, 1]
  : [s, 0, 0, 0, 0, kLens, 0, 0, 0, 0, (deep + near) / (near - deep), -1, 0, 0, 2 * deep * near / (near - deep), 0];
  return {m: mul(lens, view), right, up, back, from};
};
const cut = () => {
  if (!eye.cut) return {n: [0, 0, 0], d: 0, room: 1};
  const n = scene.axes[eye.cut - 1];
  let a = Infinity, b = -Infinity;
  for (let corner = 0; corner < 8; corner++) {
    const t = dot(n, [0, 1, 2].map((k) => corner >> k & 1 ? high[k] : low[k]));
    a = Math.min(a, t);
    b = Math.max(b, t);
  }
  return {n, d: a + eye.pos * (b - a), room: Math.max(.002, eye.wide * (b - a) / 2), span: b - a, from: a};
};
const panes = () => {
  const shown = clouds.filter((_, i) => eye.mask >> i & 1);
  if (!eye.side || shown.length < 2) return [{clouds: shown, x: 0, w: canvas.width}];
  const w = Math.floor(canvas.width / shown.length);
  return shown.map((c, i) => ({clouds: [c], x: i * w, w}));
};
const draw = () => {
  const ratio = window.devicePixelRatio || 1, width = Math.round(canvas.clientWidth * ratio), height = Math.round(canvas.clientHeight * ratio);
  if (canvas.width != width || canvas.height != height) {
    canvas.width = over.width = width;
    canvas.height = over.height = height;
  }
  const section = cut();
  gl.enable(gl.DEPTH_TEST);
  gl.enable(gl.SCISSOR_TEST);
  gl.clearColor(1, 1, 1, 1);
  for (const pane of panes()) {
    const cam = pane.cam = camera(pane.w, height);
    gl.viewport(pane.x, 0, pane.w, height);
    gl.scissor(pane.x, 0, pane.w, height);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    for (const p of [pointProgram, lineProgram]) {
      gl.useProgram(p);
      gl.uniformMatrix4fv(uniform(p, "view"), false, new Float32Array(cam.m));
      gl.uniform4f(uniform(p, "cut"), ...section.n, section.d);
      gl.uniform1f(uniform(p, "room"), section.room);
    }
    gl.useProgram(pointProgram);
    for (const c of pane.clouds) {
      const every = moving ? Math.min(30, Math.max(1, Math.ceil(c.n / 300000))) : 1;
      gl.uniformMatrix4fv(uniform(pointProgram, "pose"), false, new Float32Array(c.pose));
      gl.uniform1f(uniform(pointProgram, "step"), c.step);
      gl.uniform1f(uniform(pointProgram, "size"), c.spacing * 1.5 * Math.sqrt(every) * (eye.flat ? kLens * height / 2 / eye.far : kLens * height / 2));
      gl.bindVertexArray(c.vao);
      gl.bindBuffer(gl.ARRAY_BUFFER, c.places);
      gl.vertexAttribIPointer(0, 4, gl.UNSIGNED_SHORT, 8 * every, 0);
      gl.bindBuffer(gl.ARRAY_BUFFER, c.colours);
      gl.vertexAttribPointer(1, 4, gl.UNSIGNED_BYTE, true, 4 * every, 0);
      gl.drawArrays(gl.POINTS, 0, Math.floor(c.n / every));
    }
    gl.useProgram(lineProgram);
    gl.bindVertexArray(lines);
    gl.drawArrays(gl.LINES, 0, ends.length / 3);
    annotate(pane, ratio, height);
  }
};

// ---- what stands on the picture: names, marks, scales
const onPane = (pane, p) => {
  const c = apply(pane.cam.m, p);
  return c[3] <= 0 ? null : [pane.x + (c[0] / c[3] + 1) / 2 * pane.w, (1 - c[1] / c[3]) / 2 * canvas.height, c[3]];
};
const visible = (p) => { const s = cut(); return !eye.cut || Math.abs(dot(s.n, p) - s.d) <= s.room; };
const annotate = (pane, ratio, height) => {
  const g = over.getContext("2d");
  g.clearRect(pane.x, 0, pane.w, height);
  g.save();
  g.beginPath();
  g.rect(pane.x, 0, pane.w, height);
  g.clip();
  const em = 12 * ratio, write = (text, x, y, ink) => {
    g.lineWidth = 3 * ratio;
    g.strokeStyle = "#fff";
    g.strokeText(text, x, y);
    g.fillStyle = ink || "#1a1a1a";
    g.fillText(text, x, y);
  };
  g.font = em + "px Helvetica,Arial,sans-serif";
  g.textBaseline = "middle";
  g.lineJoin = "round";
  if (picked && picked.rings) for (const ring of rings(picked)) {
    g.beginPath();
    ring.map((p) => onPane(pane, p)).filter((p) => p).forEach((p, i) => i ? g.lineTo(p[0], p[1]) : g.moveTo(p[0], p[1]));
    g.closePath();
    g.lineWidth = 3 * ratio;
    g.strokeStyle = "#e0007a";
    g.stroke();
  }
  if (eye.names && !moving) {
    const taken = [];
    g.textAlign = "center";
    for (const part of scene.parts.filter((p) => p.tag).sort((a, b) => b.area - a.area)) {
      if (!visible(part.middle)) continue;
      const at = onPane(pane, part.middle), w = g.measureText(part.tag).width;
      if (!at || taken.some((t) => Math.abs(t[0] - at[0]) < (t[2] + w) / 2 + 4 && Math.abs(t[1] - at[1]) < em)) continue;
      taken.push([at[0], at[1], w]);
      write(part.tag, at[0], at[1]);
    }
  }
  g.textAlign = "left";
  marks.forEach((mark, i) => {
      const at = onPane(pane, mark);
      if (!at) return;
      g.strokeStyle = "#e0007a";
      g.lineWidth = 1.5 * ratio;
      g.beginPath();
      g.moveTo(at[0] - 7 * ratio, at[1]);
      g.lineTo(at[0] + 7 * ratio, at[1]);
      g.moveTo(at[0], at[1] - 7 * ratio);
      g.lineTo(at[0], at[1] + 7 * ratio);
      const before = i && onPane(pane, marks[i - 1]);
      if (before) { g.moveTo(before[0], before[1]); g.lineTo(at[0], at[1]); }
      g.stroke();
      if (before) write(fixed(Math.hypot(...sub(mark, marks[i - 1])), 3) + " m", (at[0] + before[0]) / 2 + em / 2, (at[1] + before[1]) / 2, "#a0005a");
    });
  // a bar of a round length, true at the depth of the middle
  const metre = kLens * height / 2 / eye.far, wish = 120 * ratio / metre, ten = 10 ** Math.floor(Math.log10(wish));
  const length = [5, 2, 1].find((k) => k * ten <= wish) * ten, x = pane.x + pane.w - 20 * ratio, y = height - 18 * ratio;
  g.fillStyle = "#1a1a1a";
  g.fillRect(x - length * metre, y, length * metre, 3 * ratio);
  g.textAlign = "right";
  write((length < .01 ? length * 1000 + " mm" : length + " m") + (eye.flat ? "" : " at the middle"), x, y - em * .8);
  // directions of the axes
  const o = [pane.x + 34 * ratio, height - 34 * ratio];
  g.textAlign = "center";
  const axes3 = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
["X", "Y", "Z"].forEach((name, k) => {
      const d = [dot(pane.cam.right, axes3[k]), -dot(pane.cam.up, axes3[k])].map((v) => v * 24 * ratio);
      g.strokeStyle = "#777";
      g.lineWidth = ratio;
      g.beginPath();
      g.moveTo(o[0], o[1]);
      g.lineTo(o[0] + d[0], o[1] + d[1]);
      g.stroke();
      write(name, o[0] + d[0] * 1.25, o[1] + d[1] * 1.25, "#555");
    });
  g.textAlign = "left";
  legend(g, pane, ratio, em, write);
  g.restore();
};
const legend = (g, pane, ratio, em, write) => {
  const x = pane.x + 12 * ratio, shown = legendOf(eye.mode);
  let y = 16 * ratio;
  const row = (ink, text) => {
    g.fillStyle = ink;
    g.fillRect(x, y - em / 2, em, em);
    write(text, x + 1.5 * em, y);
    y += 1.4 * em;
  };
  if (eye.side) { write(pane.clouds.map((c) => c.name).join(" + "), x, y); y += 1.6 * em; }
  if (eye.mode == "cloud") for (const c of pane.clouds) row(c.colour, c.name);
  const scale = eye.mode == "height" ? {name: "height", unit: "m", low: focus[2] + scene.origin[2], high: focus[5] + scene.origin[2], colours: null} : shown;
  if (!scale || scale.kind == "rgb" || scale.kind == "label") return;
  const unit = scale.unit == "m" && Math.max(Math.abs(scale.low), Math.abs(scale.high)) < 1 && scale.name != "height" ? [1000, "mm"] : [1, scale.unit];
  write(scale.name + (unit[1] ? " (" + unit[1] + ")" : ""), x, y);
  y += 1.1 * em;
  const tall = 110 * ratio, table = scale.colours ? scale.colours.map(hex) : ramp;
  for (let i = 0; i < tall; i++) {
    const t = 1 - i / tall, ink = scale.colours ? table[Math.min(table.length - 1, Math.floor(t * table.length))] : between(table, t);
    g.fillStyle = "rgb(" + ink.map(Math.round) + ")";
    g.fillRect(x, y + i, em, 1.5);
  }
  for (const t of [1, .5, 0]) {
    const value = (scale.low + t * (scale.high - scale.low)) * unit[0];
    write(String(+value.toPrecision(scale.name == "height" ? 6 : 3)), x + 1.4 * em, y + (1 - t) * tall);
  }
  y += tall + 1.3 * em;
  for (const [ink, text] of scale.none || []) if (text) row(ink, text);
};
let asked = false;
const ask = () => {
  if (asked) return;
  asked = true;
  requestAnimationFrame(() => { asked = false; draw(); });
};
//@include viewer_hand.js
})();

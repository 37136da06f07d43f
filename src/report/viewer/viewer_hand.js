// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// The rest of viewer.js: pointer, keys, what a click tells, the bar of choices, the view in the link.

// ---- what a click tells
const paneAt = (x) => panes().map((p) => Object.assign(p, {cam: camera(p.w, canvas.height)})).find((p) => x >= p.x && x < p.x + p.w);
const inside = (part, p) => {
  const axis = part.normal.map(Math.abs).indexOf(Math.max(...part.normal.map(Math.abs)));
  const u = (axis + 1) % 3, v = (axis + 2) % 3;
  let odd = false;
  for (const ring of rings(part)) ring.forEach((a, i) => {
      const b = ring[(i + 1) % ring.length];
      if ((a[v] > p[v]) != (b[v] > p[v]) && p[u] < (b[u] - a[u]) * (p[v] - a[v]) / (b[v] - a[v]) + a[u]) odd = !odd;
    });
  return odd;
};
// The point within a few pixels that is nearest to the eye; of points about as near the one nearest to the pointer.
const pointAt = (pane, x, y, reachPixels) => {
  let best = null, score = Infinity;
  for (const c of pane.clouds) {
    const m = mul(pane.cam.m, c.pose), s = c.step, q = c.q, w2 = pane.w / 2, h2 = canvas.height / 2, section = cut(), pose = c.pose;
    for (let k = 0; k < c.n; k++) {
      const a = q[4 * k] * s, b = q[4 * k + 1] * s, d = q[4 * k + 2] * s, w = m[3] * a + m[7] * b + m[11] * d + m[15];
      if (w <= 0) continue;
      const dx = pane.x + ((m[0] * a + m[4] * b + m[8] * d + m[12]) / w + 1) * w2 - x;
      if (dx > reachPixels || dx < -reachPixels) continue;
      const dy = (1 - (m[1] * a + m[5] * b + m[9] * d + m[13]) / w) * h2 - y, r2 = dx * dx + dy * dy;
      if (r2 > reachPixels * reachPixels) continue;
      const depth = (m[2] * a + m[6] * b + m[10] * d + m[14]) / w + r2 / (reachPixels * reachPixels) * 1e-3;
      if (depth >= score) continue;
      if (eye.cut) {
        const p = apply(pose, [a, b, d]);
        if (Math.abs(dot(section.n, p) - section.d) > section.room) continue;
      }
      score = depth;
      best = {cloud: c, k, p: apply(pose, [a, b, d]).slice(0, 3)};
    }
  }
  return best;
};
const rayAt = (pane, x, y) => {
  const nx = (x - pane.x) / pane.w * 2 - 1, ny = 1 - y / canvas.height * 2, wide = eye.far / kLens, {right, up, back, from} = pane.cam;
  const side = [0, 1, 2].map((i) => right[i] * nx * wide * pane.w / canvas.height + up[i] * ny * wide);
  return eye.flat ? {from: from.map((v, i) => v + side[i]), to: back.map((v) => -v)}
  : {from, to: side.map((v, i) => v - eye.far * back[i])};
};
// The opening or else the face that the pointer is in, of several the smallest; one behind the point is hidden by it.
const partAt = (pane, x, y, point) => {
  const ray = rayAt(pane, x, y), length = Math.hypot(...ray.to);
  const far = point ? dot(sub(point.p, ray.from), ray.to) / length + .3 : Infinity;
  let best = null;
  for (const part of scene.parts) {
    const down = dot(part.normal, ray.to);
    if (!part.area || Math.abs(down) < 1e-12) continue;
    const t = dot(part.normal, sub(part.middle, ray.from)) / down, p = ray.from.map((v, i) => v + t * ray.to[i]);
    if (t <= 0 || (part.kind != "opening" && t * length > far) || !visible(p) || !inside(part, p)) continue;
    if (part.kind == "opening" && t * length > far + 1) continue;
    const nearer = !best || (part.kind == best.part.kind ? part.area < best.part.area : part.kind == "opening");
    if (nearer) best = {part, p};
  }
  return best;
};
const valueText = (hit) => hit.cloud.channels.filter((c) => c.kind == "scale" || c.kind == "grey").map((c) => {
    const v = c.v[hit.k];
    if (v < -32765) return c.name + ": " + (c.none[v + 32768][1] || "none");
    return c.name + " " + (c.unit == "m" ? fixed(v * c.step * 1000, 1) + " mm" : +(v * c.step).toPrecision(4) + " " + c.unit);
  }).join(", ");
const tell = (x, y) => {
  const pane = paneAt(x);
  if (!pane) return;
  const hit = pointAt(pane, x, y, 9 * (window.devicePixelRatio || 1)), on = partAt(pane, x, y, hit);
  const p = hit ? hit.p : on && on.p;
  picked = on && on.part;
  if (!p) { say("Nothing is there."); return ask(); }
  marks = marks.length == 1 ? [marks[0], p] : [p];
  const label = hit && hit.cloud.channels.find((c) => c.kind == "label");
  const text = [];
  if (on && (on.part.kind == "opening" || !label)) text.push(on.part.text);
  else if (label) text.push(scene.labels[label.v[hit.k]] || "point of no segment");
  else if (clouds.length > 1 && hit) text.push(hit.cloud.name);
  if (hit) text.push(valueText(hit));
  text.push("at " + place(p));
  if (marks.length == 2) {
    const d = sub(marks[1], marks[0]);
    text.push("distance " + fixed(Math.hypot(...d), 3) + " m (level " + fixed(Math.hypot(d[0], d[1]), 3) + ", height " + fixed(d[2], 3) + ")");
  }
  say(text.filter((t) => t).join("; "));
  ask();
};

// ---- pointer: turn, shift with the right button or Shift, wheel or two fingers to come nearer
const down = new Map();
let travelled = 0;
const shift = (dx, dy) => {
  const {right, up} = camera(canvas.width, canvas.height), k = eye.far / kLens * 2 / canvas.clientHeight;
  eye.at = eye.at.map((v, i) => v - right[i] * dx * k + up[i] * dy * k);
};
const turn = (dx, dy) => {
  eye.az -= dx * .006;
  eye.el = Math.max(-1.57, Math.min(1.57, eye.el + dy * .006));
};
const nearer = (factor) => { eye.far = Math.max(reach * .002, Math.min(reach * 8, eye.far * factor)); };
let rest = 0;
const changed = () => {
  moving = true;
  clearTimeout(rest);
  rest = setTimeout(() => { moving = false; keep(); ask(); }, 180);
  ask();
};
canvas.addEventListener("contextmenu", (e) => e.preventDefault());
canvas.addEventListener("pointerdown", (e) => { down.set(e.pointerId, [e.clientX, e.clientY]); travelled = 0; canvas.setPointerCapture(e.pointerId); });
canvas.addEventListener("pointermove", (e) => {
    const last = down.get(e.pointerId);
    if (!last) return;
    const dx = e.clientX - last[0], dy = e.clientY - last[1];
    travelled += Math.abs(dx) + Math.abs(dy);
    if (down.size == 2) {
      const other = [...down].find(([id]) => id != e.pointerId)[1];
      nearer(Math.hypot(last[0] - other[0], last[1] - other[1]) / Math.max(1, Math.hypot(e.clientX - other[0], e.clientY - other[1])));
      shift(dx / 2, dy / 2);
    } else if (e.buttons == 1 && !e.shiftKey) turn(dx, dy);
    else shift(dx, dy);
    down.set(e.pointerId, [e.clientX, e.clientY]);
    if (travelled > 4) changed();
  });
canvas.addEventListener("pointerup", (e) => {
    const one = down.size == 1;
    down.delete(e.pointerId);
    if (!one || travelled > 4 || e.button) return;
    const box = canvas.getBoundingClientRect(), ratio = window.devicePixelRatio || 1;
    tell((e.clientX - box.left) * ratio, (e.clientY - box.top) * ratio);
  });
canvas.addEventListener("pointercancel", (e) => down.delete(e.pointerId));
canvas.addEventListener("wheel", (e) => { e.preventDefault(); nearer(Math.exp(e.deltaY * .001)); changed(); }, {passive: false});

// ---- the bar of choices, built from what the scene has
const make = (name, set, into) => (into || bar).appendChild(Object.assign(document.createElement(name), set));
const labelled = (text, name, set) => { const l = make("label", {textContent: text}); return make(name, set, l); };
const look = (az, el) => () => { Object.assign(eye, {az, el}); near(); changed(); };
// As near as the outlines, or else the points about the focus, stay in the picture from where the eye looks. The focus
// leaves out the outermost in a hundred points, strays or not: what lies a quarter beyond it belongs to it.
const essence = [], room = [0, 1, 2].map((k) => .25 * (focus[k + 3] - focus[k]) + .01);
const within = (p) => p.every((v, k) => v >= focus[k] - room[k] && v <= focus[k + 3] + room[k]);
for (const part of scene.parts) for (const p of rings(part).flat()) if (within(p)) essence.push(p);
// Of the points the outermost each way.
const ways = [-2, -1, 0, 1, 2], ways3 = ways.flatMap((x) => ways.flatMap((y) => ways.map((z) => [x, y, z])));
if (scene.parts.every((part) => part.rings[0].length < 9)) for (const c of clouds.filter((x) => !x.hidden)) {
  const every = Math.ceil(c.n / 40000), out = ways3.map(() => null), far = ways3.map(() => -Infinity);
  for (let k = 0; k < c.n; k += every) {
    const p = apply(c.pose, [0, 1, 2].map((a) => c.q[4 * k + a] * c.step)).slice(0, 3);
    if (within(p)) ways3.forEach((way, i) => { const t = dot(way, p); if (t > far[i]) { far[i] = t; out[i] = p; } });
  }
  essence.push(...out.filter((p) => p));
}
const near = () => {
  Object.assign(eye, {at: home.at.slice(), far: home.far});
  for (let round = 0; round < 8 && essence.length; round++) {
    const cam = camera(panes()[0].w, canvas.height), box = [1e9, -1e9, 1e9, -1e9];
    for (const p of essence) {
      const c = apply(cam.m, p), x = c[0] / c[3], y = c[1] / c[3];
      if (c[3] > 0) box.splice(0, 4, Math.min(box[0], x), Math.max(box[1], x), Math.min(box[2], y), Math.max(box[3], y));
    }
    const k = eye.far / kLens, dx = (box[0] + box[1]) / 2 * k * panes()[0].w / canvas.height, dy = (box[2] + box[3]) / 2 * k;
    eye.at = eye.at.map((v, i) => v + cam.right[i] * dx + cam.up[i] * dy);
    eye.far *= Math.max(.3, Math.max(box[1] - box[0], box[3] - box[2]) / 1.8);
  }
};
const fit = () => { near(); changed(); };
const control = {};
control.mode = labelled("Colours ", "select", {onchange: (e) => { eye.mode = e.target.value; paint(); changed(); }});
for (const m of modes) make("option", {value: m, textContent: m}, control.mode);
control.shown = clouds.map((c, i) => clouds.length < 2 ? null : labelled("", "input",
    {type: "checkbox", onchange: (e) => { eye.mask = eye.mask & ~(1 << i) | e.target.checked << i; changed(); }}));
control.shown.forEach((box, i) => box && box.parentNode.append(" " + clouds[i].name));
if (clouds.length > 1) {
  control.side = labelled("", "input", {type: "checkbox", onchange: (e) => { eye.side = +e.target.checked; changed(); }});
  control.side.parentNode.append(" side by side");
}
control.cut = labelled("Section ", "select", {onchange: (e) => { eye.cut = +e.target.value; show(); changed(); }});
["none", "along the front", "in depth", "by height"].forEach((t, i) => make("option", {value: i, textContent: t}, control.cut));
control.pos = labelled("at ", "input", {type: "range", min: 0, max: 1, step: .001, oninput: (e) => { eye.pos = +e.target.value; changed(); }});
control.wide = labelled("thickness ", "input", {type: "range", min: .002, max: 1, step: .002, oninput: (e) => { eye.wide = +e.target.value; changed(); }});
control.names = labelled("", "input", {type: "checkbox", onchange: (e) => { eye.names = +e.target.checked; changed(); }});
control.names.parentNode.append(" names");
control.flat = labelled("", "input", {type: "checkbox", onchange: (e) => { eye.flat = +e.target.checked; changed(); }});
control.flat.parentNode.append(" parallel");
for (const [text, act] of [["Front", look(front, 0)], ["Top", look(front, 1.57)], ["Side", look(front + 1.5708, 0)], ["All", fit]])
make("button", {type: "button", textContent: text, onclick: act});
const show = () => {
  control.mode.value = eye.mode;
  control.shown.forEach((box, i) => { if (box) box.checked = eye.mask >> i & 1; });
  if (control.side) control.side.checked = eye.side;
  control.cut.value = eye.cut;
  control.pos.value = eye.pos;
  control.wide.value = eye.wide;
  control.pos.parentNode.hidden = control.wide.parentNode.hidden = !eye.cut;
  control.names.checked = eye.names;
  control.flat.checked = eye.flat;
};

// ---- keys, on the picture
const keys = {ArrowLeft: () => turn(-20, 0), ArrowRight: () => turn(20, 0), ArrowUp: () => turn(0, -20), ArrowDown: () => turn(0, 20),
  "+": () => nearer(.85), "=": () => nearer(.85), "-": () => nearer(1 / .85), f: look(front, 0), t: look(front, 1.57), s: look(front + 1.5708, 0),
  a: fit, p: () => { eye.flat ^= 1; }, n: () => { eye.names ^= 1; }, x: () => { eye.cut = (eye.cut + 1) % 4; },
  "[": () => { eye.pos = Math.max(0, eye.pos - .01); }, "]": () => { eye.pos = Math.min(1, eye.pos + .01); },
  m: () => { eye.mode = modes[(modes.indexOf(eye.mode) + 1) % modes.length]; paint(); },
  Enter: () => tell(canvas.width / 2, canvas.height / 2),
  Escape: () => { marks = []; picked = null; say(help); }};
canvas.addEventListener("keydown", (e) => {
    const step = {ArrowLeft: [-30, 0], ArrowRight: [30, 0], ArrowUp: [0, -30], ArrowDown: [0, 30]}[e.key];
    if (e.ctrlKey || e.metaKey || e.altKey) return;
    if (e.shiftKey && step) shift(...step);
    else if (/^[1-9]$/.test(e.key) && modes[e.key - 1]) { eye.mode = modes[e.key - 1]; paint(); }
    else if (keys[e.key]) keys[e.key]();
    else return;
    e.preventDefault();
    show();
    changed();
  });

// ---- the view in the link
const order = ["az", "el", "far", "flat", "cut", "pos", "wide", "mask", "side", "names"];
let kept = "";
const keep = () => {
  const round = (v) => +(+v).toFixed(4);
  kept = "#view=" + [...order.map((k) => round(eye[k])), ...eye.at.map(round), modes.indexOf(eye.mode)].join(",");
  try { history.replaceState(null, "", kept); } catch (e) { location.replace(kept); }
};
const recall = () => {
  if (location.hash == kept || !location.hash.startsWith("#view=")) return;
  const v = location.hash.slice(6).split(",").map(Number);
  if (v.length != order.length + 4 || !v.every(Number.isFinite)) return;
  order.forEach((k, i) => { eye[k] = v[i]; });
  eye.at = v.slice(order.length, order.length + 3);
  eye.mode = modes[v[order.length + 3]] || modes[0];
  eye.cut = Math.min(3, Math.max(0, Math.round(eye.cut)));
  nearer(1);
  paint();
  show();
  ask();
};
const help = "Drag to turn, right button or Shift to shift, wheel to come nearer; click: what it is, two clicks: how far. " +
  "Keys on the picture: arrows, + -, F T S A views, P parallel, M colours, X [ ] section, N names, Enter, Esc.";
window.addEventListener("resize", ask);
window.addEventListener("hashchange", recall);
paint();
draw();
near();
recall();
show();
draw();
gl.finish();
say(help);
window.jalonView = {decoded, ms: performance.now() - started, points: clouds.reduce((s, c) => s + c.n, 0), modes, eye: () => eye, ask, draw,
  set: (values) => { Object.assign(eye, values); paint(); show(); draw(); },
  project: (p) => { const pane = Object.assign(panes()[0], {cam: camera(panes()[0].w, canvas.height)}); return onPane(pane, sub(p, scene.origin)); },
  pixel: (x, y) => { const px = new Uint8Array(4); gl.readPixels(Math.round(x), canvas.height - 1 - Math.round(y), 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, px); return [...px]; }};

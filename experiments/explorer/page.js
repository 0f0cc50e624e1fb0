"use strict";
// The page of the explorer. All numbers come from the core, the library's own C++; this file draws and listens.
const data = JSON.parse(document.getElementById("data").textContent);
const $ = (id) => document.getElementById(id);
const SVG = "http://www.w3.org/2000/svg";

// ---- The core -------------------------------------------------------------------------------------------------

let core = null;

const startCore = async () => {
  const module = await explorerCore();
  const call = (name, types) => {
    const raw = module.cwrap("explorer_" + name, "string", types);
    return (...values) => JSON.parse(raw(...values));
  };
  const array = (which) => {
    const start = module.ccall("explorer_array", "number", ["number"], [which]) / 8;
    return module.HEAPF64.slice(start, start + module.ccall("explorer_size", "number", ["number"], [which]));
  };
  core = { evaluate: call("evaluate", ["string", "number"]), smoothness: call("smoothness", ["string", "string"]),
           number: call("number", ["string"]), setFacts: call("set_facts", ["string"]), array };
  const taken = core.setFacts(data.facts);
  if (taken.error) throw new Error(taken.error);
};

// ---- The state: what the address holds --------------------------------------------------------------------------

// steps: [s] or [a, b], as they were typed; the last repeats. points: [[x, y], ..] as exact decimals.
let state = null;
let chosen = 0;
let past = [];
let undone = [];

const copy = (s) => JSON.parse(JSON.stringify(s));
const both = (step) => [step[0], step[step.length - 1]];

const toHash = (s) => {
  const parts = ["steps=" + s.steps.map((step) => step.join(",")).join(";"), "levels=" + s.levels,
                 "points=" + s.points.map((p) => p.join(",")).join(";")];
  if (s.retrofit) parts.push("retrofit");
  if (s.open) parts.push("open");
  const shown = ["curvature", "jerk", "edges"].filter((name) => s.show[name]);
  parts.push("show=" + shown.join(","), "comb=" + s.comb);
  return "#" + parts.join("&");
};

const fromHash = (hash) => {
  const parts = new URLSearchParams(hash.replace(/^#/, ""));
  if (!parts.has("steps")) return null;
  const s = copy(standard());
  s.steps = parts.get("steps").split(";").map((t) => t.split(",").slice(0, 2));
  if (parts.has("points")) s.points = parts.get("points").split(";").map((t) => t.split(","));
  if (parts.has("levels")) s.levels = Math.min(8, Math.max(0, Math.round(+parts.get("levels")) || 0));
  if (parts.has("comb")) s.comb = Math.min(100, Math.max(1, Math.round(+parts.get("comb")) || 1));
  s.retrofit = parts.has("retrofit");
  s.open = parts.has("open");
  if (parts.has("show")) for (const name of Object.keys(s.show)) s.show[name] = parts.get("show").split(",").includes(name);
  return s;
};

const polygonNamed = (name) => data.polygons.find((p) => p.name === name);

const standard = () => ({ steps: [["1/2"]], levels: 6, points: polygonNamed("figure-shape").points, retrofit: false, open: false,
                          show: { curvature: true, jerk: false, edges: true }, comb: 30 });

const request = (s) => {
  const lines = ["levels " + s.levels];
  if (s.open) lines.push("open");
  if (s.retrofit && !s.open) lines.push("retrofit");
  for (const step of s.steps) lines.push("step " + both(step).join(" "));
  for (const point of s.points) lines.push("point " + point[0] + " " + point[1]);
  return lines.join("\n");
};

// A change that can be undone. Changes of one kind that follow each other quickly are undone at once.
let lastKind = "";
let lastTime = 0;
const remember = (kind) => {
  complaint = "";
  const now = Date.now();
  if (!kind || kind !== lastKind || now - lastTime > 800) {
    past.push(copy(state));
    if (past.length > 200) past.shift();
  }
  undone = [];
  lastKind = kind;
  lastTime = now;
};

const change = (kind, edit) => {
  remember(kind);
  edit(state);
  show();
};

const travel = (from, to) => {
  if (from.length === 0) return;
  to.push(copy(state));
  state = from.pop();
  lastKind = "";
  fitView();
  show();
};

// ---- The view -----------------------------------------------------------------------------------------------------

const plane = $("plane");
let view = { scale: 1, x: 0, y: 0, width: 800, height: 600 };
const toPicture = (x, y) => [view.x + view.scale * x, view.y - view.scale * y];
const toPlane = (x, y) => [(x - view.x) / view.scale, (view.y - y) / view.scale];
const values = () => state.points.map((p) => p.map((c) => core.number(c).double));

const fitView = () => {
  view.width = 800;
  view.height = Math.round((800 * plane.clientHeight) / Math.max(1, plane.clientWidth)) || 600;
  plane.setAttribute("viewBox", `0 0 ${view.width} ${view.height}`);
  const points = values();
  const xs = points.map((p) => p[0]);
  const ys = points.map((p) => p[1]);
  const [left, right, low, high] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  const margin = 0.17;
  const fits = Math.min((view.width * (1 - 2 * margin)) / (right - left || 1), (view.height * (1 - 2 * margin)) / (high - low || 1));
  view.scale = fits;
  view.x = view.width / 2 - (fits * (left + right)) / 2;
  view.y = view.height / 2 + (fits * (low + high)) / 2;
};

// Coordinates are decimals of about a third of a pixel: short to write, exact to compute with.
const grid = () => Math.max(0, Math.ceil(Math.log10(view.scale)));
const decimal = (x) => {
  const text = x.toFixed(grid());
  const short = text.includes(".") ? text.replace(/0+$/, "").replace(/\.$/, "") : text;
  return short === "-0" ? "0" : short;
};

const path = (xs, ys, closed) => {
  const parts = [];
  for (let i = 0; i < xs.length; ++i) {
    const [x, y] = toPicture(xs[i], ys[i]);
    parts.push((i === 0 ? "M" : "L") + x.toFixed(2) + " " + y.toFixed(2));
  }
  return parts.join("") + (closed && xs.length > 0 ? "Z" : "");
};

// ---- Combs ----------------------------------------------------------------------------------------------------------

// Teeth stand on the left of the curve for negative values, as combs of curvature usually do: outside of a
// counter-clockwise turn. `places` gives the foot of a tooth and the direction of the curve there.
const comb = (name, wanted, places, numbers) => {
  const teeth = [];
  const hull = [];
  if (wanted && numbers.length > 0) {
    let largest = 0;
    for (const v of numbers) if (Number.isFinite(v)) largest = Math.max(largest, Math.abs(v));
    const size = largest > 0 ? ((state.comb / 100) * 0.6 * Math.min(view.width, view.height)) / largest : 0;
    for (let i = 0; i < numbers.length; ++i) {
      const { x, y, dx, dy } = places(i);
      const length = Math.hypot(dx, dy) || 1;
      const value = Number.isFinite(numbers[i]) ? numbers[i] : 0;
      const [px, py] = toPicture(x, y);
      const tx = px + (value * size * dy) / length;
      const ty = py + (value * size * dx) / length;
      teeth.push(`M${px.toFixed(2)} ${py.toFixed(2)}L${tx.toFixed(2)} ${ty.toFixed(2)}`);
      hull.push(`${hull.length === 0 ? "M" : "L"}${tx.toFixed(2)} ${ty.toFixed(2)}`);
    }
    if (!state.open) hull.push("Z");
  }
  $(name + "-comb").setAttribute("d", teeth.join(""));
  $(name + "-hull").setAttribute("d", hull.join(""));
};

const drawCombs = (xs, ys) => {
  const n = xs.length;
  const around = (i) => (state.open ? Math.min(n - 1, Math.max(0, i)) : ((i % n) + n) % n);
  comb("curvature", state.show.curvature, (i) => {
    const [before, after] = [around(i - 1), around(i + 1)];
    return { x: xs[i], y: ys[i], dx: xs[after] - xs[before], dy: ys[after] - ys[before] };
  }, core.array(2));
  const shift = state.open ? 1 : 0;
  comb("jerk", state.show.jerk, (k) => {
    const i = around(k + shift);
    const next = around(k + shift + 1);
    return { x: (xs[i] + xs[next]) / 2, y: (ys[i] + ys[next]) / 2, dx: xs[next] - xs[i], dy: ys[next] - ys[i] };
  }, core.array(3));
};

// ---- Points that can be moved -----------------------------------------------------------------------------------

const handles = $("handles");

const element = (name, attributes) => {
  const made = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  return made;
};

const drawHandles = () => {
  const points = values();
  while (handles.children.length > points.length) handles.lastChild.remove();
  while (handles.children.length < points.length) {
    const handle = element("g", { class: "handle", tabindex: "0", role: "button" });
    handle.append(element("circle", { class: "reach" }), element("circle", { class: "dot" }));
    handles.append(handle);
  }
  chosen = Math.min(chosen, points.length - 1);
  const pixel = 800 / Math.max(1, plane.clientWidth);
  points.forEach((point, i) => {
    const handle = handles.children[i];
    const [x, y] = toPicture(...point);
    handle.setAttribute("aria-label", `Point ${i + 1} of ${points.length}: ${state.points[i][0]}, ${state.points[i][1]}`);
    handle.classList.toggle("chosen", i === chosen);
    for (const [circle, radius] of [[handle.firstChild, 22], [handle.lastChild, 7]]) {
      circle.setAttribute("cx", x.toFixed(2));
      circle.setAttribute("cy", y.toFixed(2));
      circle.setAttribute("r", (radius * pixel).toFixed(2));
    }
  });
};

const picturePlace = (event) => {
  const box = plane.getBoundingClientRect();
  return toPlane(((event.clientX - box.left) * view.width) / box.width, ((event.clientY - box.top) * view.height) / box.height);
};

const indexOf = (target) => [...handles.children].indexOf(target.closest?.(".handle"));

let dragged = -1;
let grip = [0, 0];
plane.addEventListener("pointerdown", (event) => {
  const i = core ? indexOf(event.target) : -1;
  if (i < 0 || (event.button !== 0 && event.pointerType === "mouse")) return;
  const place = picturePlace(event);
  const at = values()[i];
  grip = [at[0] - place[0], at[1] - place[1]];
  dragged = i;
  chosen = i;
  remember("");
  lastKind = "drag";
  plane.setPointerCapture(event.pointerId);
  handles.children[i].focus({ preventScroll: true });
  event.preventDefault();
  drawHandles();
});
plane.addEventListener("pointermove", (event) => {
  if (dragged < 0) return;
  const [x, y] = picturePlace(event);
  state.points[dragged] = [decimal(x + grip[0]), decimal(y + grip[1])];
  soon();
});
const drop = () => {
  if (dragged < 0) return;
  dragged = -1;
  if (past.length > 0 && JSON.stringify(past[past.length - 1]) === JSON.stringify(state)) past.pop();
  lastKind = "";
  const outside = values().some(([x, y]) => {
    const [px, py] = toPicture(x, y);
    return px < 0 || py < 0 || px > view.width || py > view.height;
  });
  if (outside) fitView();
  show();
};
plane.addEventListener("pointerup", drop);
plane.addEventListener("pointercancel", drop);

// The new point, exact: the middle of an edge, or a place on it.
const insertAfter = (i, place) => {
  const points = values();
  const [a, b] = [points[i], points[(i + 1) % points.length]];
  const last = state.open && i === points.length - 1;
  const at = place ?? (last ? [2 * a[0] - points[i - 1][0], 2 * a[1] - points[i - 1][1]] : [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2]);
  change("", (s) => s.points.splice(i + 1, 0, at.map(decimal)));
  chosen = i + 1;
  show();
  handles.children[chosen].focus({ preventScroll: true });
};

const removePoint = (i) => {
  if (state.points.length <= 3) return announce("A curve needs at least 3 points.");
  change("", (s) => s.points.splice(i, 1));
  handles.children[chosen].focus({ preventScroll: true });
};

const nearestEdge = ([x, y]) => {
  const points = values();
  let best = 0;
  let least = Infinity;
  for (let i = 0; i < points.length - (state.open ? 1 : 0); ++i) {
    const [a, b] = [points[i], points[(i + 1) % points.length]];
    const [ux, uy] = [b[0] - a[0], b[1] - a[1]];
    const t = Math.min(1, Math.max(0, ((x - a[0]) * ux + (y - a[1]) * uy) / (ux * ux + uy * uy || 1)));
    const distance = Math.hypot(a[0] + t * ux - x, a[1] + t * uy - y);
    if (distance < least) [least, best] = [distance, i];
  }
  return best;
};

plane.addEventListener("dblclick", (event) => {
  // The plane has captured the pointer: the event names the plane, also over a point.
  const i = indexOf(document.elementFromPoint(event.clientX, event.clientY) ?? plane);
  if (i >= 0) return removePoint(i);
  const place = picturePlace(event);
  insertAfter(nearestEdge(place), place);
});

handles.addEventListener("focusin", (event) => {
  chosen = Math.max(0, indexOf(event.target));
  [...handles.children].forEach((handle, i) => handle.classList.toggle("chosen", i === chosen));
});

handles.addEventListener("keydown", (event) => {
  const i = indexOf(event.target);
  const moves = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
  if (i < 0 || event.ctrlKey || event.metaKey || event.altKey) return;
  if (event.key in moves) {
    const step = (event.shiftKey ? 10 : 1) * 10 ** (1 - grid());
    const [x, y] = values()[i];
    const [dx, dy] = moves[event.key];
    change("move" + i, (s) => (s.points[i] = [decimal(x + dx * step), decimal(y + dy * step)]));
  } else if (event.key === "Delete" || event.key === "Backspace") {
    removePoint(i);
  } else if (event.key === "Insert" || event.key === "+") {
    insertAfter(i);
  } else {
    return;
  }
  event.preventDefault();
});

document.addEventListener("keydown", (event) => {
  if (!(event.ctrlKey || event.metaKey) || event.target.matches("input[type=text]")) return;
  const key = event.key.toLowerCase();
  if (key === "z" && !event.shiftKey) travel(past, undone);
  else if (key === "y" || (key === "z" && event.shiftKey)) travel(undone, past);
  else return;
  event.preventDefault();
});

// ---- Steps -----------------------------------------------------------------------------------------------------------

const stepsBox = $("steps");
const field = (i, which, name) => {
  const id = `step-${i}-${which}`;
  return `<label for="${id}">${name}</label><div class="pair">` +
    `<input type="range" id="${id}-slider" min="-3" max="7" step="0.005" aria-label="${name}, step ${i + 1}, slider">` +
    `<input type="text" id="${id}" inputmode="text" autocomplete="off" spellcheck="false" aria-describedby="${id}-wrong"></div>` +
    `<p class="wrong" id="${id}-wrong"></p>`;
};

const buildSteps = () => {
  const count = state.steps.length;
  const layout = state.steps.map((step) => step.length);
  if (stepsBox.dataset.layout !== layout.join(" ")) {
    stepsBox.dataset.layout = layout.join(" ");
    stepsBox.innerHTML = layout.map((numbers, i) => {
      const last = i === count - 1;
      const title = last ? (count > 1 ? "Then for ever" : "Every step") : count === 2 ? "First step" : `Step ${i + 1}`;
      return `<fieldset><legend>${title}</legend>` +
        (numbers === 1 ? field(i, 0, "s") : field(i, 0, "a") + field(i, 1, "b")) +
        `<label class="box"><input type="checkbox" id="step-${i}-linked"${numbers === 1 ? " checked" : ""}> one parameter, a = b = s</label>` +
        (last ? "" : `<div class="buttons"><button type="button" id="step-${i}-drop">Leave step ${i + 1} out</button></div>`) + "</fieldset>";
    }).join("");
  }
  state.steps.forEach((step, i) => step.forEach((_, which) => {
    const input = $(`step-${i}-${which}`);
    const slider = $(`step-${i}-${which}-slider`);
    if (document.activeElement !== input || input.getAttribute("aria-invalid") !== "true") {
      if (core.number(input.value).value !== core.number(step[which]).value) input.value = step[which];
      input.removeAttribute("aria-invalid");
      $(`step-${i}-${which}-wrong`).textContent = "";
    }
    if (document.activeElement !== slider) slider.value = core.number(step[which]).double;
    slider.setAttribute("aria-valuetext", step[which]);
  }));
};

const setStep = (i, which, text, kind) => change(kind, (s) => (s.steps[i][which] = text));

stepsBox.addEventListener("input", (event) => {
  const [, i, which, slider] = event.target.id.match(/^step-(\d+)-([01])(-slider)?$/) ?? [];
  if (i === undefined) return;
  const text = event.target.value.trim().replace("\u2212", "-").replace(/\s/g, "");
  if (slider) return setStep(+i, +which, text, "slider" + event.target.id);
  const number = core.number(text);
  const wrong = number.error ? "Write a number such as 3/8, 0.375 or -33/26." : "";
  $(`step-${i}-${which}-wrong`).textContent = wrong;
  if (wrong) event.target.setAttribute("aria-invalid", "true");
  else event.target.removeAttribute("aria-invalid");
  if (!wrong) setStep(+i, +which, text, "type" + event.target.id);
});

stepsBox.addEventListener("change", (event) => {
  const [, i] = event.target.id.match(/^step-(\d+)-linked$/) ?? [];
  if (i === undefined) return;
  change("", (s) => (s.steps[+i] = event.target.checked ? [s.steps[+i][0]] : both(s.steps[+i])));
  $(`step-${i}-linked`).focus();
});

stepsBox.addEventListener("click", (event) => {
  const [, i] = event.target.id?.match(/^step-(\d+)-drop$/) ?? [];
  if (i === undefined) return;
  change("", (s) => s.steps.splice(+i, 1));
  $("more-steps").focus();
});

$("more-steps").addEventListener("click", () => {
  if (state.steps.length >= 12) return announce("Twelve steps are enough.");
  change("", (s) => s.steps.unshift(copy(s.steps[0])));
});

// ---- Words -----------------------------------------------------------------------------------------------------------

const digits = (x, n = 6) => (x === null ? "" : String(+x.toPrecision(n)));
const percent = (part) => {
  const value = 100 * part;
  return `${value > 0 ? "+" : ""}${Math.abs(value) < 1e-9 ? "0" : digits(value, 3)}%`.replace("-", "\u2212");
};
const minus = (text) => text.replaceAll("-", "\u2212");
const escaped = (text) => text.replace(/[&<>"]/g, (c) => ({ "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" })[c]);
const claimLink = (id) => (data.claims[id] ? `<a href="index.html#${id}">${id}</a>` : `<code>${id}</code>`);

const schemeName = (s) => {
  const name = (step) => `J(${step.join(", ")})`;
  const parts = s.steps.map(name);
  const last = "*" + parts.pop();
  return minus(parts.length > 0 ? `{${parts.join(", ")}, ${last}}` : last);
};

const continuityWords = (known) => {
  if (known.proved < 0 && known.refuted === 0) return "not continuous: there is no limit curve for all points";
  if (known.proved >= 0 && known.refuted === known.proved + 1) return `C${known.proved}, and not C${known.refuted}`;
  if (known.proved < 0 && known.refuted < 0) return "undecided";
  const parts = [];
  if (known.proved >= 0) parts.push(`at least C${known.proved}`);
  if (known.refuted >= 0) parts.push(`not C${known.refuted}`);
  return parts.join(", ") + "; undecided between";
};

// The digits that both ends share.
const commonDigits = (lower, upper) => {
  let n = 0;
  while (n < lower.length && lower[n] === upper[n]) ++n;
  return lower.slice(0, n).replace(/\.$/, "");
};
const trimmed = (text) => text.replace(/(\.\d*?)0+$/, "$1").replace(/\.$/, "");

const exponentWords = (e) => {
  if (e.exact) return `${e.formula || trimmed(e.lower)}, proved`;
  if (e.formula) return `${minus(e.formula)} = ${commonDigits(e.lower, e.upper)}\u2026, proved`;
  if (e.lower && e.upper) return `between ${trimmed(e.lower)} and ${trimmed(e.upper)}, proved; the value is undecided`;
  if (e.lower) return `at least ${trimmed(e.lower)}, proved; the value is undecided`;
  if (e.upper) return `at most ${trimmed(e.upper)}, proved; the value is undecided`;
  return e.reason === "no limit" ? "none: there is no limit curve" : "undecided";
};

let smoothness = null;
let smoothnessOf = "";
const updateSmoothness = () => {
  const [a, b] = both(state.steps[state.steps.length - 1]);
  if (smoothnessOf !== a + " " + b) {
    smoothnessOf = a + " " + b;
    smoothness = core.smoothness(a, b);
  }
  const known = smoothness;
  const why = known.reason ? ` <span class="count">(proved: ${minus(escaped(known.reason))})</span>` : "";
  const many = state.steps.length > 1 ? ' <span class="count">Steps before the last change the points only.</span>' : "";
  $("continuity").innerHTML = continuityWords(known) + why + many;
  $("exponent").textContent = exponentWords(known.exponent);
};

const samePreset = (p) => p.retrofit === (state.retrofit && !state.open) && p.steps.length === state.steps.length &&
  p.steps.every((step, i) => both(step).every((x, k) => core.number(x).value === core.number(both(state.steps[i])[k]).value));
const samePolygon = (p) => JSON.stringify(p.points) === JSON.stringify(state.points);

const updateClaims = () => {
  const preset = data.presets.find(samePreset);
  $("preset").value = preset ? preset.name : "";
  $("preset-note").textContent = preset ? preset.note : "";
  const ids = [...new Set([...(preset ? preset.claims : []), ...smoothness.claims])].filter((id) => data.claims[id]);
  $("claims").innerHTML = ids.length === 0 ? "nothing" : "<ul>" + ids.map((id) => {
    const { printed, verdict } = data.claims[id];
    return `<li>${claimLink(id)}: ${printed ? `<q>${escaped(printed)}</q>, ` : ""}${verdict}</li>`;
  }).join("") + "</ul>";
};

// ---- Everything again -------------------------------------------------------------------------------------------------

let reply = null;
let xs = [];
let ys = [];

let complaint = "";  // of an address that names no curve, until something is changed
const setFailure = (text) => {
  $("failure").hidden = !text;
  $("failure").textContent = text;
};

const draw = (withLimit) => {
  const answer = core.evaluate(request(state), withLimit ? 1 : 0);
  drawHandles();
  const points = values();
  $("edges").setAttribute("d", state.show.edges ? path(points.map((p) => p[0]), points.map((p) => p[1]), !state.open) : "");
  if (answer.error) {
    setFailure(answer.error);
    for (const id of ["curve", "solution", "curvature-comb", "curvature-hull", "jerk-comb", "jerk-hull"]) $(id).setAttribute("d", "");
    reply = null;
    return;
  }
  setFailure(complaint);
  reply = answer;
  xs = core.array(0);
  ys = core.array(1);
  $("curve").setAttribute("d", path(xs, ys, !state.open));
  const solved = state.retrofit && !state.open;
  $("solution-key").hidden = !solved;
  $("solution").setAttribute("d", solved ? path(answer.polygon.filter((_, i) => i % 2 === 0), answer.polygon.filter((_, i) => i % 2 === 1), true) : "");
  drawCombs(xs, ys);
};

const areaWords = (area) => (area === null || reply.polygonArea === null ? "" : `${digits(area, 8)}` +
  (reply.polygonArea === 0 ? "" : `: ${percent(area / reply.polygonArea - 1)} against the polygon`));

const updateNumbers = (withLimit) => {
  const levels = `${state.levels} level${state.levels === 1 ? "" : "s"}`;
  for (const place of document.querySelectorAll(".levels-shown")) place.textContent = levels;
  if (!reply) {
    for (const id of ["polygon-area", "area", "limit-area", "length", "curvature", "jerk"]) $(id).textContent = "none";
    return;
  }
  $("polygon-area").textContent = reply.polygonArea === null ? "open curves have none" : minus(digits(reply.polygonArea, 8));
  $("area").textContent = reply.area === null ? "open curves have none" : minus(areaWords(reply.area));
  if (withLimit || reply.area === null) {
    $("limit-area").textContent = reply.area === null ? "open curves have none"
      : reply.limitArea === null || smoothness.proved < 1 ? "not given: the limits are not proved to be C1"
      : minus(areaWords(reply.limitArea)) + ", by the exact area mask";
  }
  $("length").textContent = `${digits(reply.length, 8)}, ${reply.points} points`;
  const largest = core.array(2).reduce((most, k) => (Number.isFinite(k) ? Math.max(most, Math.abs(k)) : most), 0);
  $("curvature").textContent = largest === 0 ? "0" : `${digits(largest, 4)}: radius ${digits(1 / largest, 4)}`;
  $("jerk").textContent = `largest ${digits(reply.largestJerk, 4)}, mean ${digits(reply.meanJerk, 4)}; the comb shows it times 8 a level`;
};

const announce = (text) => ($("summary").textContent = text);
const summary = () => {
  if (!reply) return announce("No curve is drawn.");
  const area = reply.area === null || reply.polygonArea === 0 ? "" : ` Its area is ${percent(reply.area / reply.polygonArea - 1)} against the polygon's.`;
  announce(`${schemeName(state)}${state.retrofit && !state.open ? ", retrofitted" : ""} on ${state.points.length} points` +
    `${state.open ? ", open" : ""}: ${continuityWords(smoothness)}; H\u00f6lder exponent ${exponentWords(smoothness.exponent)}.${area}`);
};

const shellNumber = (x) => x.replace(/^\+/, "");
const commands = (s) => {
  const step = (s) => (s.length === 1 ? `jspline:s=${shellNumber(s[0])}` : `jspline:a=${shellNumber(s[0])},b=${shellNumber(s[1])}`);
  const scheme = s.steps.map(step).join("+");
  const stored = data.polygons.find(samePolygon);
  const file = stored ? `experiments/data/${stored.name}.csv` : "polygon.csv";
  const write = stored ? "" : `printf '%s\\n' x,y ${s.points.map((p) => p.join(",")).join(" ")} > polygon.csv\n`;
  const how = s.open ? " --open reflected" : s.retrofit ? " --retrofit direct" : "";
  return `${write}subdivlab refine '${scheme}' ${file} --levels ${s.levels}${how} -o curve.csv\n` +
    (s.retrofit && !s.open ? "" : `subdivlab measure ${file} --scheme '${scheme}' --levels ${s.levels}${s.open ? " --open reflected" : ""}\n`) +
    `subdivlab analyze '${scheme}'\n`;
};

let pendingFrame = 0;
let pendingLimit = 0;
// While a point or a slider moves: one frame, one curve; what costs more follows when the hand rests.
const soon = () => {
  if (!pendingFrame) pendingFrame = requestAnimationFrame(() => {
    pendingFrame = 0;
    show();
  });
};

const show = () => {
  buildSteps();
  updateSmoothness();
  draw(false);
  updateNumbers(false);
  $("levels").value = state.levels;
  $("levels-value").textContent = state.levels;
  $("comb").value = state.comb;
  $("comb-value").textContent = state.comb;
  $("retrofit").checked = state.retrofit && !state.open;
  $("retrofit").disabled = state.open;
  $("open").checked = state.open;
  for (const name of Object.keys(state.show)) {
    $("show-" + name).checked = state.show[name];
    $(name + "-key").hidden = !state.show[name];
  }
  const polygon = data.polygons.find(samePolygon);
  $("polygon").value = polygon ? polygon.name : "";
  $("command").textContent = commands(state);
  $("undo").disabled = past.length === 0;
  $("redo").disabled = undone.length === 0;
  $("remove").disabled = state.points.length <= 3;
  clearTimeout(pendingLimit);
  pendingLimit = setTimeout(rest, 120);
};

const rest = () => {
  if (dragged < 0) {
    draw(true);
    updateNumbers(true);
    updateClaims();
    summary();
    try {
      window.history.replaceState(null, "", location.pathname + location.search + toHash(state));
    } catch {
      // some browsers refuse for local files
    }
  }
  document.documentElement.dataset.ready = String(1 + Number(document.documentElement.dataset.ready ?? 0));
};

// ---- Saving ------------------------------------------------------------------------------------------------------------

const save = (name, text, type) => {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([text], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
};
const csv = (rows) => "x,y\n" + rows.map((r) => r.join(",") + "\n").join("");
const curveCsv = () => csv([...xs].map((x, i) => [x, ys[i]]));
const pictureSvg = () => {
  const style = getComputedStyle(plane);
  const drawn = (id, colour, width, more = "") => {
    const d = $(id).getAttribute("d");
    return d ? `<path d="${d}" fill="none" stroke="${colour}" stroke-width="${width}"${more}/>\n` : "";
  };
  const colour = (name) => style.getPropertyValue(name).trim();
  return `<svg xmlns="${SVG}" viewBox="0 0 ${view.width} ${view.height}">\n<title>${escaped(schemeName(state))}</title>\n` +
    drawn("jerk-comb", colour("--jerky"), 0.5) + drawn("jerk-hull", colour("--jerky"), 1.2) +
    drawn("curvature-comb", colour("--curved"), 0.5) + drawn("curvature-hull", colour("--curved"), 1.2) +
    drawn("edges", colour("--poly"), 1.3) + drawn("solution", colour("--solved"), 1.2, ' stroke-dasharray="6 4"') +
    drawn("curve", colour("--curve"), 2.6) + "</svg>\n";
};

const copyText = async (text, what) => {
  try {
    await navigator.clipboard.writeText(text);
    announce(what + " copied.");
  } catch {
    announce("The browser does not let the page copy: the address of this page and the text above can be copied by hand.");
  }
};

// ---- The rest of the controls ---------------------------------------------------------------------------------------------

const fillSelects = () => {
  const group = new Map();
  for (const p of data.presets) group.set(p.group, [...(group.get(p.group) ?? []), p]);
  $("preset").innerHTML = '<option value="">another curve</option>' + [...group].map(([name, list]) =>
    `<optgroup label="${escaped(name)}">` + list.map((p) => `<option>${escaped(p.name)}</option>`).join("") + "</optgroup>").join("");
  $("polygon").innerHTML = '<option value="">another polygon</option>' +
    data.polygons.map((p) => `<option value="${p.name}">${escaped(p.title)}</option>`).join("");
};

const listen = () => {
  $("preset").addEventListener("change", (event) => {
    const preset = data.presets.find((p) => p.name === event.target.value);
    if (!preset) return show();
    change("", (s) => {
      s.steps = copy(preset.steps);
      s.retrofit = preset.retrofit;
      if (preset.retrofit) s.open = false;
    });
  });
  $("polygon").addEventListener("change", (event) => {
    const polygon = polygonNamed(event.target.value);
    if (!polygon) return show();
    remember("");
    state.points = copy(polygon.points);
    state.open = polygon.open;
    fitView();
    show();
  });
  $("levels").addEventListener("input", (event) => change("levels", (s) => (s.levels = +event.target.value)));
  $("comb").addEventListener("input", (event) => change("comb", (s) => (s.comb = +event.target.value)));
  $("retrofit").addEventListener("change", (event) => change("", (s) => (s.retrofit = event.target.checked)));
  $("open").addEventListener("change", (event) => change("", (s) => (s.open = event.target.checked)));
  for (const name of ["curvature", "jerk", "edges"])
    $("show-" + name).addEventListener("change", (event) => change("", (s) => (s.show[name] = event.target.checked)));
  $("undo").addEventListener("click", () => travel(past, undone));
  $("redo").addEventListener("click", () => travel(undone, past));
  $("reset").addEventListener("click", () => {
    remember("");
    state = copy(standard());
    fitView();
    show();
  });
  $("add").addEventListener("click", () => insertAfter(chosen));
  $("remove").addEventListener("click", () => removePoint(chosen));
  $("fit").addEventListener("click", () => {
    fitView();
    show();
  });
  $("copy").addEventListener("click", () => copyText(commands(state), "The commands are"));
  $("link").addEventListener("click", () => copyText(location.href.split("#")[0] + toHash(state), "The link is"));
  $("save-points").addEventListener("click", () => save("curve.csv", curveCsv(), "text/csv"));
  $("save-polygon").addEventListener("click", () => save("polygon.csv", csv(state.points), "text/csv"));
  $("save-picture").addEventListener("click", () => save("curve.svg", pictureSvg(), "image/svg+xml"));
  $("controls").addEventListener("submit", (event) => event.preventDefault());
  addEventListener("resize", () => {
    fitView();
    soon();
  });
  addEventListener("hashchange", () => {
    const linkedState = takeHash();
    if (!linkedState) setFailure(complaint);
    if (!linkedState || toHash(linkedState) === toHash(state)) return;
    remember("");
    state = linkedState;
    fitView();
    show();
  });
};

// The state of the address, when the core accepts it.
const takeHash = () => {
  const wanted = fromHash(location.hash);
  if (!wanted) return null;
  const answer = core.evaluate(request(wanted), 0);
  if (!answer.error) return wanted;
  complaint = "The address of this page names no curve: " + answer.error;
  return null;
};

const start = async () => {
  try {
    await startCore();
  } catch (error) {
    setFailure("This page computes with WebAssembly, which did not start here: " + error.message);
    return;
  }
  fillSelects();
  $("controls").hidden = false;
  state = takeHash() ?? copy(standard());
  listen();
  fitView();
  show();
};
start();

// The page: a problem that is edited or dragged, a worker that solves it, pictures of what it found.
"use strict";

const $ = (id) => document.getElementById(id);
const LIVE = ["csv", "boundary", "json"];
const OUTPUTS = {listing: "txt", csv: "csv", boundary: "csv", json: "json", summary: "csv", bodies: "csv", trace: "csv", vtk: "vtk", report: "html"};
const SAVED = {listing: "listing.txt", csv: "contact.csv", boundary: "boundary.csv", summary: "numbers.csv", bodies: "bodies.csv",
  trace: "trace.csv", json: "summary.json", vtk: "contact2d.vtk", report: "report.html"};
const PATIENCE = 250; // milliseconds a run may take so that its pictures, too, are drawn while a slider moves

const page = {
  module: null, worker: null, examples: {}, families: new Map(),
  kind: "sketch", family: null, companions: {}, // "sketch", "deck" or "family"; files that a sketch reads
  busy: false, wanted: null, number: 0, waiting: new Map(),
  result: null, full: null, slow: true, drawn: null,
  shape: null, magnified: null, // the deformed shape and the factors that fit, the factor chosen
};

// ---------------------------------------------------------------- the worker
function startWorker() {
  const source = `${$("engine").textContent}
    let module = null;
    onmessage = (message) => {
      const {id, words, files, loaded} = message.data;
      if (loaded !== undefined) { module = loaded; return; }
      const begin = performance.now();
      let printed = "";
      const tell = (text) => { if (text.includes("%")) postMessage({id, progress: text}); else printed += text; };
      try {
        const result = runContact2d(module, words, files, tell);
        postMessage({id, result, seconds: (performance.now() - begin) / 1000});
      } catch (why) { postMessage({id, failed: String(why)}); }
    };`;
  page.worker = new Worker(URL.createObjectURL(new Blob([source], {type: "text/javascript"})));
  page.worker.onmessage = ({data}) => {
    const job = page.waiting.get(data.id);
    if (job === undefined) return;
    if (data.progress !== undefined) { job.progress?.(data.progress); return; }
    page.waiting.delete(data.id);
    if (data.failed !== undefined) job.reject(new Error(data.failed)); else job.resolve({...data.result, seconds: data.seconds});
  };
  page.worker.postMessage({loaded: page.module});
}

function command(words, files, progress) {
  const id = ++page.number;
  return new Promise((resolve, reject) => {
    page.waiting.set(id, {resolve, reject, progress});
    page.worker.postMessage({id, words, files});
  });
}

function stop() {
  page.worker.terminate();
  for (const job of page.waiting.values()) job.reject(new Error("stopped"));
  page.waiting.clear();
  page.wanted = null;
  startWorker();
}

// ---------------------------------------------------------------- the problem
// A deck begins with a number or *FREE; what was a sketch stays one whatever its first word has become.
function isSketch(text) {
  if (page.kind === "family") return false;
  const first = text.split("\n").map((each) => each.replace(/!.*/, "").trim()).find((each) => each !== "") || "";
  if (/^(title|units|plane|functions|parameter|symmetry|body|copy|contact|tie|case)\b/.test(first)) return true;
  return page.kind === "sketch" && !/^([-+.\d]|\*)/.test(first);
}

// Names and numbers of the parameter statements of a sketch; formulas are no sliders.
function sketchParameters(text) {
  const out = [];
  for (const each of text.split("\n")) {
    const words = each.replace(/!.*/, "").match(/\{[^}]*\}|[^\s,=]+/g) || [];
    if (words[0] !== "parameter") continue;
    for (let i = 1; i + 1 < words.length; i += 2) {
      const value = Number(words[i + 1]);
      if (Number.isFinite(value)) out.push({name: words[i], value, meaning: ""});
    }
  }
  return out;
}

function readFamilies(text) {
  let family = null;
  for (const each of text.split("\n")) {
    const head = each.match(/^(?!usage:)(\w+): (.*)$/), key = each.match(/^ {2}(\w+)=(\S+)\s+(.*)$/);
    if (head) page.families.set(head[1], family = {name: head[1], summary: head[2], keys: []});
    else if (key && family) family.keys.push({name: key[1], value: key[2], meaning: key[3]});
  }
}

function rangeOf({name, value, meaning}) {
  const count = /^(n|steps|cycles|plates|rollers|order)$/.test(name) && Number.isInteger(value);
  if (count) return name === "order" ? [1, 3, 1] : [1, Math.max(10, 2 * value), 1];
  if (/^nu/.test(name) && value >= 0 && value <= 0.5) return [0, 0.49, 0.01];
  if (/^mu/.test(name)) return [0, Math.max(1, 2 * value), 0.01];
  if (value === 0) return [-1, 1, 0.01];
  const low = value > 0 ? value / 4 : value * 4, high = value > 0 ? value * 4 : value / 4;
  return [low, high, Number((Math.abs(value) / 100).toPrecision(1))];
}

function showParameters(list) {
  $("parameters").replaceChildren();
  for (const parameter of list) {
    const row = document.createElement("div"), number = Number(parameter.value), choice = (parameter.meaning || "").match(/^([\w|]+\|[\w|]+):/);
    row.className = "parameter";
    const label = document.createElement("label");
    label.textContent = parameter.name, label.htmlFor = `value-${parameter.name}`;
    const take = (value, whole) => { parameter.chosen = value; solve(whole); };
    if (choice) {
      const select = document.createElement("select");
      for (const word of choice[1].split("|")) select.add(new Option(word, word, false, word === parameter.value));
      select.id = label.htmlFor, select.onchange = () => take(select.value, true);
      row.append(label, select);
    } else {
      const slider = document.createElement("input"), field = document.createElement("input");
      slider.type = "range", field.type = "number", field.step = "any", field.id = label.htmlFor, field.value = parameter.value;
      slider.setAttribute("aria-label", `${parameter.name}, slider`);
      [slider.min, slider.max, slider.step] = Number.isFinite(number) ? rangeOf({...parameter, value: number}) : [0, 1, 0.1];
      slider.value = parameter.value;
      slider.disabled = !Number.isFinite(number);
      slider.oninput = () => { field.value = String(Number(Number(slider.value).toPrecision(12))); take(field.value, false); };
      slider.onchange = () => solve(true);
      field.onchange = () => { slider.value = field.value; take(field.value, true); };
      row.append(label, slider, field);
    }
    if (parameter.meaning) {
      const words = document.createElement("small");
      words.textContent = parameter.meaning;
      row.append(words);
    }
    $("parameters").append(row);
  }
  page.parameters = list;
}

const changed = () => page.parameters.filter((each) => each.chosen !== undefined && String(each.chosen) !== String(each.value));
const settings = () => changed().map((each) => `${each.name}=${each.chosen}`);

const familyParameters = (family) => family.keys.map((key) => ({...key, value: Number.isFinite(Number(key.value)) ? Number(key.value) : key.value}));

function takeCompanions() {
  for (const [file, text] of Object.entries(page.examples)) if (file.endsWith(".csv")) page.companions[file] = text;
}

// A value as if it had been typed, without solving.
function setParameter(parameter, value) {
  parameter.chosen = value;
  const field = $(`value-${parameter.name}`), slider = field.parentElement.querySelector("input[type=range]");
  field.value = value;
  if (slider !== null) slider.value = value;
}

async function choose(name) {
  const [group, which] = name.split(":");
  page.companions = {};
  page.family = group === "family" ? page.families.get(which) : null;
  page.kind = group;
  if (page.family) {
    showParameters(familyParameters(page.family));
  } else {
    $("editor").value = page.examples[which];
    takeCompanions();
    showParameters(sketchParameters($("editor").value));
  }
  page.full = null, page.drawn = null, page.magnified = null, $("view").value = "contact";
  await solve(true);
}

function taken(text, kind) { // from a file or the editor
  page.kind = kind, page.family = null;
  $("editor").value = text;
  showParameters(sketchParameters(text));
  page.full = null, page.drawn = null, page.magnified = null, $("view").value = "contact";
  solve(true);
}

// ---------------------------------------------------------------- what a reload finds
// The problem as it stands: which it is, its text, the values chosen. A browser that keeps nothing (a private window, a full
// disk) loses it as before.
const KEPT = "contact2d problem";

function keep() {
  const values = Object.fromEntries((page.parameters || []).filter((each) => each.chosen !== undefined).map((each) => [each.name, each.chosen]));
  const kept = {example: $("example").value, kind: page.kind, family: page.family && page.family.name, text: $("editor").value,
    companions: Object.keys(page.companions).length > 0, values, seek: $("seek").checked};
  try { localStorage.setItem(KEPT, JSON.stringify(kept)); } catch (why) { /* not kept */ }
}

function kept() {
  try {
    const found = JSON.parse(localStorage.getItem(KEPT));
    return found !== null && typeof found.text === "string" && (!found.family || page.families.has(found.family)) ? found : null;
  } catch (why) { return null; }
}

// The problem of an earlier visit, if there is one; true: it is solved.
async function restore() {
  const found = kept();
  if (found === null) return false;
  page.kind = found.kind, page.family = found.family ? page.families.get(found.family) : null;
  if ([...$("example").options].some((each) => each.value === found.example)) $("example").value = found.example;
  $("editor").value = found.text, $("seek").checked = found.seek === true;
  if (found.companions) takeCompanions();
  showParameters(page.family ? familyParameters(page.family) : sketchParameters(found.text));
  for (const each of page.parameters) if (Object.hasOwn(found.values || {}, each.name)) setParameter(each, found.values[each.name]);
  await solve(true);
  return true;
}

// ---------------------------------------------------------------- solving
// Whatever is asked for while a run is at work is done after it, once, as it stands then.
async function solve(whole) {
  page.wanted = {whole: whole || (page.wanted !== null && page.wanted.whole)};
  keep();
  if (page.busy) return;
  page.busy = true;
  $("stop").disabled = false;
  while (page.wanted !== null) {
    const {whole: all} = page.wanted;
    page.wanted = null;
    try {
      await solveOnce(all);
    } catch (why) {
      state(why.message === "stopped" ? "Stopped." : `The program ended: ${why.message}`, true);
    }
  }
  page.busy = false;
  $("stop").disabled = true;
}

async function problemText() {
  if (!page.family) return $("editor").value;
  const made = await command(["make", page.family.name, ...settings()], {});
  if (made.status === 0) {
    $("editor").value = made.out;
    return made.out;
  }
  showError(made.err.split("\n").slice(0, 1).join("").replace(/^contact2d: /, ""));
  return null;
}

function showError(text) {
  showMessages([{severity: "error", text, line: 0, column: 0}]);
  state("Not solved: " + text, true);
}

async function solveOnce(whole) {
  const text = await problemText();
  if (text === null) return;
  const sketch = isSketch(text), name = sketch ? "model.c2s" : "model.dat";
  const quick = sketch && !$("seek").checked;
  const solved = quick ? withoutSeeking(text) : text;
  const pictures = whole || !page.slow;
  const words = ["run", name, ...(page.family || !sketch ? [] : settings()), "--progress"];
  for (const output of pictures ? Object.keys(OUTPUTS) : LIVE) words.push(`--${output}`, `${output}.${OUTPUTS[output]}`);
  if (pictures) words.push("--figures", "figures");
  if (whole) state("Solving");
  const run = await command(words, {...page.companions, [name]: solved}, (now) => { if (whole) state("Solving: " + now.replace(/[\r\n]|contact2d: /g, " ").trim()); });
  const messages = messagesOf(run.err);
  showMessages(messages);
  const faults = messages.filter((each) => each.severity === "error");
  if (run.status > 1 && run.status !== 5) { // 5: solved, a wanted tolerance is not met
    $("shown").classList.add("stale");
    state(`Not solved: ${faults.length > 0 ? (faults[0].line ? `line ${faults[0].line}: ` : "") + faults[0].text : "exit status " + run.status}`, true);
    return;
  }
  page.slow = pictures ? run.seconds * 1000 > PATIENCE : page.slow;
  page.result = read(run);
  if (pictures) page.full = run.files;
  $("shown").classList.remove("stale");
  $("shown").hidden = false;
  showChoices();
  show();
  if (pictures) showPictures(run.files);
  const peak = page.result.rows.reduce((most, row) => (row.status === "tied" ? most : Math.max(most, row.tn)), 0);
  const outcome = page.result.json.outcome;
  const stated = ((page.result.json.accuracy || {}).stated || []).filter((each) => each.relative_error !== undefined && each.tolerance !== undefined);
  const errors = stated.map((each) => `${each.name} ${short(100 * each.relative_error, 2)} %${each.met === false ? " (not met)" : ""}`).join(", ");
  const time = run.seconds < 0.1 ? `${Math.max(1, Math.round(run.seconds * 1000))} ms` : `${run.seconds.toFixed(1)} s`;
  state((run.status === 0 ? `Solved in ${time}` : `Ended early (${outcome}); ${time}`) +
    `${peak > 0 ? `; largest pressure of a pair ${short(peak, 6)}` : ""}${quick ? "; first mesh, error not stated" : errors ? `; stated errors: ${errors}` : ""}.`, run.status !== 0);
}

// The first mesh as it is; lines keep their numbers.
const withoutSeeking = (text) => (/^\s*tolerance\b/m.test(text) ? text.replace(/^\s*tolerance\b.*$/m, "tolerance off") : `${text.replace(/\n*$/, "")}\ntolerance off\n`);

function messagesOf(text) {
  const out = [];
  for (const each of text.split(/[\r\n]/)) {
    const found = each.match(/^.*?contact2d: (?:model\.\w+(?::(\d+)(?::(\d+))?)?: )?(error|warning|note): (.*)$/);
    if (found) out.push({line: Number(found[1] || 0), column: Number(found[2] || 0), severity: found[3], text: found[4]});
  }
  return out;
}

function state(text, fault = false) {
  $("state").textContent = text;
  $("state").classList.toggle("fault", fault);
}

// ---------------------------------------------------------------- the editor
function showGutter() {
  const lines = $("editor").value.split("\n").length, marks = new Map();
  for (const message of page.messages || []) if (message.line > 0) marks.set(message.line, message.severity === "error" || marks.get(message.line) === "fault" ? "fault" : "warning");
  let out = "";
  for (let i = 1; i <= lines; ++i) out += `<b class="${marks.get(i) || ""}">${i}</b>`;
  $("gutter").innerHTML = out;
  $("gutter").scrollTop = $("editor").scrollTop;
}

function goTo({line, column}) {
  const lines = $("editor").value.split("\n");
  if (line < 1 || line > lines.length) return;
  const start = lines.slice(0, line - 1).reduce((sum, each) => sum + each.length + 1, 0);
  $("editor").focus();
  $("editor").setSelectionRange(start + Math.max(0, column - 1), start + lines[line - 1].length);
  $("editor").scrollTop = Math.max(0, (line - 8) * 18);
}

function showMessages(messages) {
  page.messages = messages;
  $("messages").replaceChildren(...messages.map((message) => {
    const item = document.createElement("li");
    const text = `${message.severity === "error" ? "" : message.severity + ": "}${message.line ? `line ${message.line}, column ${message.column}: ` : ""}${message.text}`;
    if (message.line > 0) {
      const button = document.createElement("button");
      button.textContent = text, button.onclick = () => goTo(message);
      item.append(button);
    } else {
      item.textContent = text;
    }
    if (message.severity === "error") item.className = "fault", item.firstChild.className = "fault";
    return item;
  }));
  showGutter();
}

// ---------------------------------------------------------------- results
function table(text) {
  const [head, ...rows] = text.trimEnd().split("\n"), names = head.split(",");
  return rows.map((row) => {
    const out = {};
    row.split(",").forEach((word, i) => { out[names[i]] = names[i] === "status" ? word : Number(word); });
    return out;
  });
}

function read(run) {
  const rows = table(run.files["csv.csv"] || "mu\n"), ends = table(run.files["boundary.csv"] || "body\n");
  const json = JSON.parse(run.files["json.json"]);
  const ties = new Set(rows.filter((row) => row.status === "tied").map((row) => row.zone));
  return {rows, ends, json, ties, mus: [...new Set(rows.map((row) => row.mu))], zones: [...new Set(rows.map((row) => row.zone))],
    size: ends.length > 0 ? Math.max(spread(ends, "x"), spread(ends, "y")) : 0};
}

// What is chosen stays chosen while it is there under its name; `preferred` else, and of another problem.
function options(select, values, words, holder, preferred) {
  const before = page.drawn === null || select.selectedIndex < 0 ? null : select.selectedOptions[0].text;
  select.replaceChildren(...values.map((value) => new Option(words(value), String(value))));
  select.value = String(values.find((value) => words(value) === before) ?? preferred);
  holder.hidden = values.length < 2;
}

const zoneOf = (zone) => (page.result.json.zones || []).find((each) => each.zone === zone) || {};

// "top on toe"; with the number where there is no name, or it is not the only one.
function zoneName(zone) {
  const {name} = zoneOf(zone);
  if (name === undefined) return `zone ${zone}`;
  return page.result.json.zones.filter((each) => each.name === name).length > 1 ? `${name} (zone ${zone})` : name;
}

function showChoices() {
  const {mus, zones, ties} = page.result;
  options($("mu"), mus, (mu) => `mu ${mu}`, $("mu-choice"), mus[0]);
  options($("zone"), zones, zoneName, $("zone-choice"), zones.find((zone) => !ties.has(zone)) ?? zones[0]);
}

// Of a zone with one of its own it is that, whatever the run's is. (Infinite: null in the JSON.)
function frictionOf(zone, mu) {
  const {mus} = page.result, own = zoneOf(zone).mu;
  return own === undefined || own === mus[0] ? mu : own ?? Infinity;
}

// Lines beyond which images go on; bodies of revolution are drawn on both sides of their axis.
const linesOf = (json) => [...(json.symmetry || []), ...(json.plane === "axisymmetric" ? [{axis: "x", at: 0}] : [])];

// Steps of the zone and coefficient chosen, each a list of pairs and of their images in the order of their places along the zone,
// and what a place is called.
function stepsShown() {
  const mu = Number($("mu").value), zone = Number($("zone").value), steps = new Map();
  for (const row of page.result.rows) {
    if (row.mu !== mu || row.zone !== zone) continue;
    if (!steps.has(row.step)) steps.set(row.step, []);
    steps.get(row.step).push(row);
  }
  if (steps.size === 0) return {steps: [], place: ""};
  const places = placesAlong([...steps.values()][0], linesOf(page.result.json));
  const all = [...steps.values()].map((rows) => alongZone(rows, places));
  // what ever touches, and as much again around it
  const first = all[0], touched = first.map((_, i) => i).filter((i) => all.some((step) => step[i].status !== "open"));
  if (touched.length === 0) return {steps: all, place: places.name};
  const begin = touched[0], end = touched[touched.length - 1], more = Math.max(3, Math.ceil((end - begin) / 2));
  const margin = Math.max(0.5 * (first[end].s - first[begin].s), first[Math.min(end + 1, first.length - 1)].s - first[end].s);
  const near = (i) => i >= begin - more && i <= end + more && first[i].s >= first[begin].s - margin && first[i].s <= first[end].s + margin;
  return {steps: all.map((step) => step.filter((_, i) => near(i))), place: places.name};
}

// Names of units, as in the report: forces of the whole circumference, or per unit thickness.
function unitNames() {
  const text = $("editor").value;
  const found = text.match(isSketch(text) ? /^\s*units[\s,]+([^\s,]+)[\s,]+([^\s,]+)/m : /^\*UNITS\s+(\S+)\s+(\S+)/mi);
  if (found === null) return {length: "", stress: "", force: "", work: ""};
  const [, length, force] = found, stress = `${force}/${length}\u00b2`;
  if (page.result.json.plane === "axisymmetric") return {length, stress, force, work: `${force} ${length}`};
  return {length, stress, force: `${force}/${length}`, work: force};
}

function units() { // as axes have them
  const {length, stress} = unitNames();
  return {length: length && ` (${length})`, stress: stress && ` (${stress})`};
}

// Factors of all load cases.
function loadText(row) {
  const loads = Object.keys(row).filter((name) => /^load\d*$/.test(name)).map((name) => short(row[name]));
  return `${loads.length > 1 ? "loads" : "load"} ${loads.join(", ")}`;
}

function show() {
  const {steps, place} = stepsShown(), wide = Math.max(340, Math.min(900, $("pressure").clientWidth || 640));
  $("step").max = Math.max(1, steps.length);
  const fresh = page.drawn !== steps.length; // another path: its end is shown
  if (fresh) $("step").value = steps.length;
  page.drawn = steps.length;
  for (const id of ["pressure", "status-map"]) $(id).parentElement.hidden = steps.length === 0;
  $("step").parentElement.hidden = steps.length < 2;
  if (steps.length > 0) {
    const now = Number($("step").value) - 1, rows = steps[now];
    $("step-text").textContent = `step ${now + 1} of ${steps.length}, ${loadText(rows[0])}`;
    $("step").setAttribute("aria-valuetext", $("step-text").textContent);
    const others = [0.25, 0.5, 0.75].map((share) => steps[Math.floor(share * (steps.length - 1))]).filter((each) => each !== rows && steps.length > 4);
    const zone = Number($("zone").value), tied = page.result.ties.has(zone), mu = frictionOf(zone, Number($("mu").value));
    $("pressure").innerHTML = drawPressure(rows, others, {mu, tied, place}, units(), wide);
    $("status-map").innerHTML = drawStatus(steps, now, tied, wide);
    showPairs(rows.filter((row) => !row.isImage).sort((p, q) => p.pair - q.pair), tied);
  }
  showDeformed(wide);
  showNumbers();
}

// The last state, whose displacements the boundary table has: of the last coefficient of friction.
function showDeformed(wide) {
  const {ends, rows, json, mus} = page.result, last = rows.filter((row) => row.mu === mus[mus.length - 1]);
  if (ends.length === 0) return;
  const key = [$("view").value, wide].join(" ");
  if (page.shape === null || page.shape.of !== page.result || page.shape.key !== key) {
    const step = last.length > 0 ? last[last.length - 1].step : 0;
    const bodies = ((json.steps_detail || []).slice(-1)[0] || {}).bodies || []; // rigid ones have a motion
    const rigid = new Set(bodies.map((body, i) => (body.motion === undefined ? 0 : i + 1)));
    const at = last.filter((row) => row.step === step);
    const lines = linesOf(json), d = deformation(ends, at, json.zones || [], rigid, lines, $("view").value === "whole");
    page.shape = {of: page.result, key, d, ...factorsOf(d, lines, wide)};
  }
  const {d, factors, automatic} = page.shape;
  const now = page.magnified === null ? automatic : factors.filter((factor) => factor <= page.magnified).length - 1;
  $("magnify").max = factors.length - 1, $("magnify").value = now;
  $("magnify").disabled = factors.length < 2;
  $("magnify-text").textContent = factors[now] === 1 ? "to scale" : `times ${short(factors[now], 3)}`;
  $("magnify").setAttribute("aria-valuetext", $("magnify-text").textContent);
  $("deformed").innerHTML = drawDeformed(d, factors[now], linesOf(json), units(), wide);
}

// Rows of cells; one that is a word is a heading of those below.
function htmlTable(names, rows) {
  const row = (cells) => (typeof cells === "string" ? `<th class="group" colspan="${names.length}">${escaped(cells)}</th>`
    : cells.map((cell) => `<td>${escaped(cell)}</td>`).join(""));
  return `<table><thead><tr>${names.map((name) => `<th scope="col">${escaped(name)}</th>`).join("")}</tr></thead><tbody>` +
    `${rows.map((cells) => `<tr>${row(cells)}</tr>`).join("")}</tbody></table>`;
}

// Of an edge or border its distance along the second side, the same on every mesh.
function shownValue(each) {
  return /^(contact edge|stick border)$/.test(each.quantity) && each.along !== undefined ? each.along : each.value;
}

// The unit of a contact number, and the size below which it is round-off, shown as 0.
function unitOf(quantity, names, size, force) {
  if (/^(peak|mean) pressure$/.test(quantity)) return [names.stress, 0];
  if (/^(force [xy]|friction force)$/.test(quantity)) return [names.force, 1e-10 * force];
  if (quantity === "moment") return [names.work, 1e-10 * force * size];
  if (quantity === "dissipated") return [names.work, 0];
  if (quantity === "rotation") return ["rad", 0];
  if (quantity === "edge pressure") return [names.stress && `${names.stress}/\u221a${names.length}`, 0];
  if (quantity === "edge friction") return [names.stress && `${names.stress} \u221a${names.length}`, 0];
  return [names.length, 1e-15 * size];
}

const withUnit = (name, unit) => (unit ? `${name}, ${unit}` : name);

// Is it a force along a line of symmetry that cuts the body on side 2? The whole contact has twice that.
function isHalf({quantity, zone}) {
  const {json, ends, size} = page.result, body = zoneOf(zone).body2 ?? 2;
  const isOn = (line) => ends.some((end) => end.body === body && Math.abs(end[line.axis] - line.at) <= 1e-9 * size);
  const cut = (json.symmetry || []).filter(isOn);
  return zone > 0 && /^force [xy]$/.test(quantity) && cut.length > 0 && cut.every((line) => line.axis !== quantity.slice(-1));
}

// The table of the report: by coefficient and zone.
function showNumbers() {
  const {json, size, ties} = page.result, names = unitNames(), none = "\u2013", places = ["x", "y", "along"], rows = [];
  const stated = json.runs.some((run) => (run.quantities || []).some((each) => each.error !== undefined));
  const zero = (value, noise, error = 0) => (Math.abs(value) <= noise || Math.abs(value) <= 0.01 * error ? 0 : value);
  const muText = (mu) => `mu ${mu === Infinity ? "infinite" : short(mu)}`;
  for (const {quantities = [], mu: infinite} of json.runs) {
    const mu = infinite ?? Infinity, forces = quantities.filter((each) => each.quantity.startsWith("force "));
    const force = Math.max(0, ...forces.map((each) => Math.abs(each.value)));
    let before;
    for (const each of quantities) {
      const {zone} = each, [unit, noise] = unitOf(each.quantity, names, size, force);
      if (zone !== before && zone === 0) rows.push(`all zones, ${muText(mu)}`);
      else if (zone !== before) rows.push(`${zoneName(zone)}, ${ties.has(zone) ? "tied" : muText(frictionOf(zone, mu))}`);
      before = zone;
      const where = places.map((name) => (each[name] === undefined ? none : short(zero(each[name], 1e-10 * size), 6)));
      const add = (name, times) => {
        const value = short(times * zero(shownValue(each), noise, each.error), 6);
        const error = each.error === undefined ? none : `\u00b1 ${short(times * zero(each.error, noise), 2)}`;
        rows.push([name, unit ? `${value} ${unit}` : value, ...(stated ? [error] : []), ...where]);
      };
      const body = zone === 0 && each.item ? `, body ${each.item}${each.name ? ` (${each.name})` : ""}` : "";
      add(each.quantity + (body || (each.item ? ` ${each.item}` : "")), 1);
      if (isHalf(each)) add(`${each.quantity}, whole`, 2);
    }
  }
  const head = ["quantity", "value", ...(stated ? ["stated error"] : []), ...places.map((name) => withUnit(name, names.length))];
  const whole = json.plane === "axisymmetric" ? " of the whole circumference" : "";
  const whose = whole + ((json.symmetry || []).length > 0 ? " of the modelled part" : "");
  $("numbers").innerHTML = htmlTable(head, rows) + (whose ? `<p>Forces, moments and dissipated work are those${whose}.</p>` : "");
}

function showPairs(rows, tied) {
  const {length, stress} = unitNames(), lengths = (names) => names.map((name) => withUnit(name, length));
  const tractions = tractionNames(tied).map((name) => withUnit(name, stress)), six = (...values) => values.map((value) => short(value, 6));
  $("pairs").innerHTML = htmlTable(["pair", ...lengths(["x", "y"]), "status", ...tractions, ...lengths(["gap", "slip"])],
    rows.map((row) => [row.pair, ...six(row.x, row.y), row.status, ...six(row.tn, row.tt, row.gap, row.slip)]));
}

// Pictures stand in the page, as in the report, whose colours for dark screens are theirs here too.
function showPictures(files) {
  $("dark").textContent = files["report.html"].split("\n").filter((each) => each.startsWith("svg [")).join("\n");
  const names = Object.keys(files).filter((name) => name.startsWith("figures/")).sort();
  const stress = names.filter((name) => /\/(contact[^/]*|stress(_zone)?|deformed)\.svg$/.test(name)); // the contact, the shape, stress
  $("stress").innerHTML = stress.map((name) => files[name]).join("");
  const draw = () => { $("pictures").innerHTML = $("more").open ? names.map((name) => files[name]).join("") : ""; };
  $("more").ontoggle = draw;
  draw();
}

// ---------------------------------------------------------------- saving
function download(name, text, type = "text/plain") {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([text], {type}));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

// The text of a sketch whose parameters have the values that are chosen. (That of a family is the deck made of them.)
function withValues(text) {
  const chosen = new Map(page.parameters.filter((each) => each.chosen !== undefined).map((each) => [each.name, each.chosen]));
  return text.split("\n").map((each) => {
    const end = each.indexOf("!"), words = end < 0 ? each : each.slice(0, end);
    if (!/^\s*parameter\b/.test(words)) return each;
    const value = (match, name, between, old) => (chosen.has(name) ? name + between + chosen.get(name) : match);
    const head = words.match(/^\s*parameter\b/)[0];
    return head + words.slice(head.length).replace(/([^\s,=]+)([\s,=]+)(\{[^}]*\}|[^\s,=]+)/g, value) + each.slice(words.length);
  }).join("\n");
}

async function save(output) {
  if (output === "problem") {
    const sketch = isSketch($("editor").value);
    const seen = (text) => ($("seek").checked ? text : withoutSeeking(text)); // run again, it gives the numbers of the page
    download(sketch ? "model.c2s" : "model.dat", sketch ? seen(withValues($("editor").value)) : $("editor").value);
    return;
  }
  await solve(true);
  if (page.full === null) return;
  if (output === "figures") {
    const names = Object.keys(page.full).filter((name) => name.startsWith("figures/"));
    download("pictures.zip", archive(names.map((name) => [name.slice(8), page.full[name]])), "application/zip");
  } else {
    download(SAVED[output], page.full[`${output}.${OUTPUTS[output]}`], output === "report" ? "text/html" : "text/plain");
  }
}

function checksum(bytes) { // CRC-32
  let sum = 0xffffffff;
  for (const byte of bytes) {
    sum ^= byte;
    for (let i = 0; i < 8; ++i) sum = (sum >>> 1) ^ (sum & 1 ? 0xedb88320 : 0);
  }
  return ~sum >>> 0;
}

// A ZIP archive of texts, as they are, without compression.
function archive(texts) {
  const parts = [], directory = [];
  let at = 0;
  const record = (...fields) => { // pairs of bytes and value
    const view = new DataView(new ArrayBuffer(fields.reduce((sum, [bytes]) => sum + bytes, 0)));
    let place = 0;
    for (const [bytes, value] of fields) {
      if (bytes === 4) view.setUint32(place, value, true); else view.setUint16(place, value, true);
      place += bytes;
    }
    return new Uint8Array(view.buffer);
  };
  for (const [name, text] of texts) {
    const title = new TextEncoder().encode(name), bytes = new TextEncoder().encode(text), sum = checksum(bytes);
    const common = [[2, 20], [2, 0x800], [2, 0], [2, 0], [2, 0x21], [4, sum], [4, bytes.length], [4, bytes.length], [2, title.length], [2, 0]];
    const head = record([4, 0x04034b50], ...common);
    directory.push(record([4, 0x02014b50], [2, 20], ...common, [2, 0], [2, 0], [2, 0], [4, 0], [4, at]), title);
    parts.push(head, title, bytes);
    at += head.length + title.length + bytes.length;
  }
  const size = directory.reduce((sum, each) => sum + each.length, 0);
  return new Blob([...parts, ...directory, record([4, 0x06054b50], [2, 0], [2, 0], [2, texts.length], [2, texts.length], [4, size], [4, at], [2, 0])]);
}

function showSaving() {
  const words = {problem: "deck or sketch", listing: "listing", csv: "contact (CSV)", boundary: "boundary (CSV)", summary: "numbers (CSV)", bodies: "bodies (CSV)",
    trace: "changes of status (CSV)", json: "summary (JSON)", vtk: "ParaView (VTK)", report: "report (HTML)", figures: "pictures (SVG, zipped)"};
  for (const [output, word] of Object.entries(words)) {
    const button = document.createElement("button");
    button.textContent = word, button.dataset.output = output, button.onclick = () => save(output);
    $("save").append(button);
  }
}

// ---------------------------------------------------------------- the beginning
// Of a deck it is the last of its heading lines, whose number stands before them.
function titleOf(text, isDeck) {
  if (!isDeck) return (text.match(/^\s*title\s+(.*?)\s*(!.*)?$/m) || ["", ""])[1];
  const lines = text.split("\n").filter((each) => !/^(\*FREE|!)/i.test(each));
  return (lines[parseInt(lines[0], 10)] || "").trim();
}

async function begin() {
  showSaving();
  page.module = await loadContact2d($("program").textContent);
  page.examples = JSON.parse(new TextDecoder().decode(await unpackContact2d($("examples").textContent)));
  startWorker();
  const version = await command(["--version"], {}), families = await command(["make", "--list"], {});
  $("version").textContent = version.out.trim() + ".";
  readFamilies(families.out);
  const group = (label, values) => {
    const out = document.createElement("optgroup");
    out.label = label;
    for (const [value, word] of values) out.append(new Option(word, value));
    $("example").append(out);
  };
  const title = (name) => titleOf(page.examples[name], name.endsWith(".dat")) || name;
  const lesson = (name) => Number((name.match(/^t(\d+)_/) || [0, 0])[1]), all = Object.keys(page.examples).sort();
  const names = all.filter((name) => !lesson(name)), lessons = all.filter(lesson).sort((a, b) => lesson(a) - lesson(b));
  group("Tutorial", lessons.map((name) => [`${name.endsWith(".dat") ? "deck" : "sketch"}:${name}`,
    `${lesson(name)} ${title(name)}`]));
  group("Sketches", names.filter((name) => name.endsWith(".c2s")).map((name) => [`sketch:${name}`, title(name)]));
  group("Families of problems", [...page.families.values()].map((family) => [`family:${family.name}`, `${family.name}: ${family.summary}`]));
  const decks = names.filter((name) => name.endsWith(".dat"));
  const isAlone = (name) => decks.filter((each) => title(each) === title(name)).length === 1;
  group("Decks", decks.map((name) => [`deck:${name}`, isAlone(name) ? title(name) : `${title(name)} (${name})`]));
  $("example").onchange = $("reset").onclick = () => choose($("example").value);
  let typing = 0;
  $("editor").oninput = () => {
    showGutter();
    clearTimeout(typing);
    keep();
    typing = setTimeout(() => {
      const text = $("editor").value;
      page.kind = page.family ? "deck" : page.kind, page.family = null;
      const chosen = new Map((page.parameters || []).map((each) => [each.name, each]));
      const found = sketchParameters(text);
      if (JSON.stringify(found.map((each) => [each.name, each.value])) !== JSON.stringify([...chosen.values()].map((each) => [each.name, each.value]))) showParameters(found);
      solve(false);
    }, 300);
  };
  $("editor").onscroll = () => { $("gutter").scrollTop = $("editor").scrollTop; };
  $("editor").onchange = () => solve(true);
  $("open").onchange = async () => {
    const file = $("open").files[0];
    if (file) taken(await file.text(), file.name.endsWith(".c2s") ? "sketch" : "deck");
  };
  $("seek").onchange = () => solve(true);
  $("solve").onclick = () => solve(true);
  $("stop").onclick = stop;
  $("mu").onchange = $("zone").onchange = () => { page.drawn = null; show(); };
  $("step").oninput = () => show();
  $("magnify").oninput = () => { page.magnified = page.shape.factors[Number($("magnify").value)]; show(); };
  $("view").onchange = () => { page.magnified = null; show(); };
  addEventListener("resize", () => { if (page.result) show(); });
  const start = "sketch:roller.c2s";
  if (!await restore()) {
    $("example").value = start;
    await choose(start);
  }
  document.body.dataset.ready = "yes";
}

begin().catch((why) => state(`This browser cannot run the program: ${why.message || why}`, true));

// Pictures drawn from the program's tables: tractions, statuses over the load, the deformed shape.
"use strict";

const escaped = (text) => String(text).replace(/[&<>"]/g, (c) => ({"&": "&amp;", "<": "&lt;", ">": "&gt;", "\"": "&quot;"})[c]);
const short = (value, digits = 4) => (Number.isFinite(value) ? String(Number(value.toPrecision(digits))) : "-");

function ticks(low, high, about) {
  let step = 10 ** Math.floor(Math.log10((high - low) / about));
  step *= [1, 2, 5, 10].find((factor) => (high - low) / (step * factor) <= about) || 10;
  const out = [];
  for (let i = Math.ceil(low / step - 1e-9); i <= Math.floor(high / step + 1e-9); ++i) out.push(i * step);
  return out;
}

// From numbers to places of a picture; a range that is a point is widened.
function scale(low, high, from, to) {
  if (!(high > low)) [low, high] = [low - (Math.abs(low) || 1), high + (Math.abs(high) || 1)];
  const at = (value) => from + (to - from) * (value - low) / (high - low);
  return Object.assign(at, {low, high});
}

function axes(x, y, box, xName, yName) {
  const out = [];
  for (const value of ticks(x.low, x.high, Math.max(3, (box.right - box.left) / 90))) {
    out.push(`<path d="M${x(value).toFixed(1)} ${box.top}V${box.bottom}" stroke="var(--line)"/>`,
      `<text x="${x(value).toFixed(1)}" y="${box.bottom + 17}" text-anchor="middle">${short(value)}</text>`);
  }
  for (const value of ticks(y.low, y.high, 5)) {
    out.push(`<path d="M${box.left} ${y(value).toFixed(1)}H${box.right}" stroke="var(--line)"/>`,
      `<text x="${box.left - 6}" y="${(y(value) + 4).toFixed(1)}" text-anchor="end">${short(value)}</text>`);
  }
  out.push(`<text x="${(box.left + box.right) / 2}" y="${box.bottom + 35}" text-anchor="middle">${escaped(xName)}</text>`,
    `<text x="${box.left}" y="${box.top - 8}">${escaped(yName)}</text>`);
  return out.join("");
}

function picture(width, height, label, content) {
  return `<svg viewBox="0 0 ${width} ${height}" role="img" aria-label="${escaped(label)}">${content}</svg>`;
}

const line = (xs, ys, style) => `<polyline fill="none" ${style} points="${xs.map((x, i) => `${x.toFixed(1)},${ys[i].toFixed(1)}`).join(" ")}"/>`;

// What a pair's status looks like: hollow, full, a triangle, a square; not by colour alone.
function mark(status, x, y) {
  const at = `${x.toFixed(1)} ${y.toFixed(1)}`;
  if (status === "open") return `<circle cx="${x.toFixed(1)}" cy="${y.toFixed(1)}" r="3" fill="var(--back)" stroke="var(--pressure)"/>`;
  if (status === "stick") return `<circle cx="${x.toFixed(1)}" cy="${y.toFixed(1)}" r="3" fill="var(--pressure)"/>`;
  if (status === "slip") return `<path d="M${at}m0 -4l4 7h-8z" fill="var(--friction)"/>`;
  return `<path d="M${at}m-3 -3h6v6h-6z" fill="var(--soft)"/>`;
}

// ---------------------------------------------------------------- places along a zone
// As in the pictures of the report: a zone that nowhere rises more than a third is shown over x (or y), any other over the length
// from its left or lower end, or from a line of symmetry; what ends on such a line goes on beyond it.

// How a zone is measured, from its pairs in their order: `name`, `at` (place of every pair) and `mirror` (that of a line), if any.
function placesAlong(rows, lines) {
  const first = rows[0], last = rows[rows.length - 1], steep = Math.abs(last.y - first.y) > 1.001 * Math.abs(last.x - first.x);
  const [name, across] = steep ? ["y", "x"] : ["x", "y"], way = last[name] < first[name] ? -1 : 1;
  const straight = rows.every((row, i) => {
    const step = i > 0 ? way * (row[name] - rows[i - 1][name]) : 0;
    return i === 0 || step > 0 && Math.abs(row[across] - rows[i - 1][across]) <= step / 3;
  });
  const isOn = (line, row) => Math.abs(row[line.axis] - line.at) <= 1e-9 * (Math.abs(row.x) + Math.abs(row.y));
  const onLine = (row) => lines.some((line) => isOn(line, row));
  const ends = way > 0 ? [first, last] : [last, first], origin = onLine(ends[1]) && !onLine(ends[0]) ? ends[1] : ends[0];
  const length = [0];
  for (let i = 1; i < rows.length; ++i) length.push(length[i - 1] + way * Math.hypot(rows[i].x - rows[i - 1].x, rows[i].y - rows[i - 1].y));
  const at = rows.map((row, i) => (straight ? row[name] : length[i] - length[rows.indexOf(origin)]));
  return {name: straight ? name : "along the zone", at, mirror: onLine(origin) ? at[rows.indexOf(origin)] : undefined};
}

// The rows of a step with their places `s`, and their images beyond the line, where t is reversed; in the order of s.
function alongZone(rows, {at, mirror}) {
  rows.forEach((row, i) => { row.s = at[i]; });
  const image = (row) => ({...row, s: 2 * mirror - row.s, tt: -row.tt, isImage: true});
  const images = mirror === undefined ? [] : rows.filter((row) => row.s !== mirror).map(image);
  return [...rows, ...images].sort((p, q) => p.s - q.s);
}

const tractionNames = (tied) => (tied ? ["normal stress", "shear stress"] : ["pressure", "friction"]);

// `rows`: of one zone and step, in the order of their places s along it, images included; `place`: what s is called. A tie has no
// Coulomb bounds, and its tractions are neither pressure nor friction.
function drawPressure(rows, others, {mu, tied, place}, unit, wide) {
  const width = wide, height = 330, box = {left: 62, right: width - 14, top: 46, bottom: height - 42};
  const bounded = !tied && Number.isFinite(mu);
  const bound = rows.map((row) => (bounded ? mu * Math.max(row.tn, 0) : 0));
  const values = [0, ...rows.flatMap((row, i) => [row.tn, row.tt, bound[i], -bound[i]]), ...others.flatMap((each) => each.map((row) => row.tn))];
  const x = scale(Math.min(...rows.map((row) => row.s)), Math.max(...rows.map((row) => row.s)), box.left, box.right);
  const y = scale(Math.min(...values), Math.max(...values), box.bottom, box.top);
  const xs = rows.map((row) => x(row.s)), out = [axes(x, y, box, `${place}${unit.length}`, `tractions${unit.stress}`)];
  const band = [...xs.map((at, i) => `${at.toFixed(1)},${y(bound[i]).toFixed(1)}`), ...xs.map((at, i) => `${at.toFixed(1)},${y(-bound[i]).toFixed(1)}`).reverse()];
  if (bounded && mu > 0) out.push(`<polygon points="${band.join(" ")}" fill="var(--band)"/>`);
  for (const each of others) out.push(line(each.map((row) => x(row.s)), each.map((row) => y(row.tn)), 'stroke="var(--soft)" stroke-width="0.8" stroke-dasharray="3 3"'));
  out.push(line(xs, rows.map((row) => y(row.tt)), 'stroke="var(--friction)" stroke-width="2"'),
    line(xs, rows.map((row) => y(row.tn)), 'stroke="var(--pressure)" stroke-width="2"'),
    rows.map((row, i) => mark(row.status, xs[i], y(row.tn))).join(""));
  const peak = rows.reduce((best, row) => (row.tn > best.tn ? row : best), rows[0]), names = tractionNames(tied);
  let at = box.left;
  const word = (text, colour, room) => {
    out.push(`<text x="${at}" y="16"${colour ? ` style="fill:var(--${colour});font-weight:600"` : ""}>${text}</text>`);
    at += room;
  };
  word(names[0], "pressure", tied ? 116 : 68), word(names[1], "friction", tied ? 106 : 62);
  for (const status of tied ? ["tied"] : ["stick", "slip", "open"]) {
    out.push(mark(status, at, 12)), at += 8;
    word(status, "", 44);
  }
  const own = rows.filter((row) => !row.isImage), count = (status) => own.filter((row) => row.status === status).length;
  const counts = ["stick", "slip", "open", "tied"].map((status) => [count(status), status]).filter(([n]) => n > 0);
  const label = tied ? "Normal and shear stress" : "Pressure and friction";
  const words = counts.map(([n, status]) => `${n} ${status}`).join(", ");
  return picture(width, height, `${label}: largest ${names[0]} ${short(peak.tn)} at ${short(peak.s)}; ${words}`, out.join(""));
}

const STATUS_FILL = {open: "none", stick: "var(--pressure)", slip: "var(--friction)", tied: "var(--soft)"};

// Statuses: across the zone, upwards the steps.
function drawStatus(steps, now, tied, wide) {
  const width = wide, box = {left: 62, right: width - 14, top: 26, bottom: 26 + Math.min(260, Math.max(90, steps.length * 9))};
  const rows = steps[0], edges = rows.map((row, i) => (i === 0 ? row.s : (row.s + rows[i - 1].s) / 2)).concat(rows[rows.length - 1].s);
  const x = scale(Math.min(...edges), Math.max(...edges), box.left, box.right), y = scale(0.5, steps.length + 0.5, box.bottom, box.top);
  const out = [];
  steps.forEach((step, k) => {
    const top = y(k + 1.5), bottom = y(k + 0.5);
    for (let i = 0, j = 0; i < step.length; i = j) {
      while (j < step.length && step[j].status === step[i].status) ++j;
      const [a, b] = [x(edges[i]), x(edges[j])].sort((p, q) => p - q), fill = STATUS_FILL[step[i].status];
      if (fill !== "none") out.push(`<rect x="${a.toFixed(1)}" y="${top.toFixed(1)}" width="${(b - a).toFixed(1)}" height="${(bottom - top).toFixed(1)}" fill="${fill}"${step[i].status === "slip" ? ' fill-opacity="0.75"' : ""}/>`);
    }
  });
  const word = (status, colour) => `<tspan style="fill:var(--${colour});font-weight:600">${status}</tspan>`;
  const legend = tied ? word("tied", "soft") : `${word("stick", "pressure")} ${word("slip", "friction")} open (blank)`;
  out.push(`<rect x="${box.left}" y="${box.top}" width="${box.right - box.left}" height="${box.bottom - box.top}" fill="none" stroke="var(--line)"/>`,
    `<rect x="${box.left}" y="${y(now + 1.5).toFixed(1)}" width="${box.right - box.left}" height="${Math.max(2, y(now + 0.5) - y(now + 1.5)).toFixed(1)}" fill="none" stroke="var(--front)" stroke-width="2"/>`,
    `<text x="${box.left}" y="16">step by step: ${legend}</text>`);
  for (const value of ticks(y.low, y.high, 4).filter((each) => Number.isInteger(each))) out.push(`<text x="${box.left - 6}" y="${(y(value) + 4).toFixed(1)}" text-anchor="end">${value}</text>`);
  const pairs = rows.filter((row) => !row.isImage).length;
  return picture(width, box.bottom + 8, `Statuses of ${pairs} pairs over ${steps.length} steps`, out.join(""));
}

// ---------------------------------------------------------------- the deformed shape
// Displacements and gaps are drawn times one factor: bodies that touch are drawn touching, and none is drawn over another. A gap
// that was there before any load is magnified by moving the other body, with a field that takes the pairs' values and is smooth
// elsewhere; a rigid body is moved as one. The rules are those of the report's pictures: gap_lift.cpp and deformation.cpp there.

const MOST_SOURCES = 200; // pairs of a zone that move a body; of more every second, third, ...
const BESIDE = 100; // places of an outline over the length of a zone
const MOST_OVERLAP = 0.5, MOST_GAP_ERROR = 0.75, NEAR_GAP = 20; // pixels; gaps that are drawn larger are not compared
const MOST_DISTORTION = 0.1, SEEN = 1; // of a shape by magnified initial gaps, and in pixels

// Curves of every body: rows of the boundary table, in the order of elements; a jump from one element to the next begins another.
function shapesOf(ends) {
  const shapes = new Map(), size = spread(ends, "x") + spread(ends, "y");
  let before = null;
  for (const end of ends) {
    if (!shapes.has(end.body)) shapes.set(end.body, []);
    const curves = shapes.get(end.body);
    const apart = before === null || before.body !== end.body ||
      end.element !== before.element && Math.hypot(end.x - before.x, end.y - before.y) > 1e-9 * size;
    if (apart) curves.push([]);
    curves[curves.length - 1].push(end);
    before = end;
  }
  return shapes;
}

function spread(list, name) {
  let low = Infinity, high = -Infinity;
  for (const each of list) low = Math.min(low, each[name]), high = Math.max(high, each[name]);
  return high - low;
}

// The distance of a point from curves, and the direction of the nearest piece.
function nearestOn(curves, x, y) {
  let best = {distance: Infinity, along: [1, 0]};
  for (const curve of curves)
    for (let i = 0; i + 1 < curve.length; ++i) {
      const a = curve[i], dx = curve[i + 1].x - a.x, dy = curve[i + 1].y - a.y, length = Math.hypot(dx, dy);
      if (length === 0) continue;
      const part = Math.min(1, Math.max(0, ((x - a.x) * dx + (y - a.y) * dy) / length / length));
      const distance = Math.hypot(a.x + part * dx - x, a.y + part * dy - y);
      if (distance < best.distance) best = {distance, along: [dx / length, dy / length]};
    }
  return best;
}

// Directions along side 2 at the pairs of a zone, which follow one another: chords from the pair before to the next one, turned as
// the outline of body 2 runs (a corner, where the outline's own direction says nothing, may end the zone).
function directionsOf(rows, curves) {
  const chords = rows.map((row, i) => {
    const a = rows[Math.max(0, i - 1)], b = rows[Math.min(rows.length - 1, i + 1)], length = Math.hypot(b.x - a.x, b.y - a.y);
    return length > 0 ? [(b.x - a.x) / length, (b.y - a.y) / length] : nearestOn(curves, row.x, row.y).along;
  });
  const way = rows.reduce((sum, row, i) => {
    const {along} = nearestOn(curves, row.x, row.y);
    return sum + along[0] * chords[i][0] + along[1] * chords[i][1];
  }, 0) < 0 ? -1 : 1;
  return chords.map(([dx, dy]) => [way * dx, way * dy]);
}

// The model and its images beyond lines of symmetry, and what an image makes of a place and of a direction.
const imagesOf = (lines) => lines.reduce((all, line) => [...all, ...all.map((image) => ({...image, [line.axis]: line.at}))], [{}]);
const turned = (image, p) => ({x: image.x === undefined ? p.x : 2 * image.x - p.x, y: image.y === undefined ? p.y : 2 * image.y - p.y});
const turnedBy = (image, [x, y]) => [image.x === undefined ? x : -x, image.y === undefined ? y : -y];

// Distance from a place along the unit vector n to the nearest place of curves, at most `most` either way; not finite if there is none.
function distanceAlong(curves, from, n, most) {
  let nearest = Infinity;
  const aside = (p) => n[0] * (p.y - from.y) - n[1] * (p.x - from.x), ahead = (p) => n[0] * (p.x - from.x) + n[1] * (p.y - from.y);
  for (const curve of curves)
    for (let i = 0; i + 1 < curve.length; ++i) {
      const a = aside(curve[i]), b = aside(curve[i + 1]);
      if (a === b || (a > 0) === (b > 0)) continue;
      const far = ahead(curve[i]) + a / (a - b) * (ahead(curve[i + 1]) - ahead(curve[i]));
      if (Math.abs(far) <= most && Math.abs(far) < Math.abs(nearest)) nearest = far;
    }
  return nearest;
}

// Of the pairs of a zone: their places on side 2, normals from body 1 to body 2, and gaps before any load.
function pairsOf(rows, curves) {
  const directions = directionsOf(rows, curves);
  return rows.map((row, i) => {
    const n = [-directions[i][1], directions[i][0]], initial = row.gap - (row.un2 - row.un1); // material is on the left
    const moved = [row.un1 * n[0] + row.ut1 * n[1], row.un1 * n[1] - row.ut1 * n[0]]; // side 1; t is n turned by -90 degrees
    return {x: row.x + initial * n[0], y: row.y + initial * n[1], n, initial, moved, gap: row.gap, row, isTied: row.status === "tied"};
  });
}

// Beside a zone, up to its length from either end, the sides have a gap as well: along the normal of the end, from places of side 2
// that face body 1 to its outline. Without it the shape would have a notch where the zone ends.
function besideZone(pairs, one, two) {
  const found = [], apart = (p, q) => Math.hypot(p.x - q.x, p.y - q.y), last = pairs.length - 1;
  if (last < 1 || pairs.every((pair) => pair.isTied)) return found;
  const length = apart(pairs[0], pairs[last]);
  for (const [at, next] of [[pairs[0], pairs[1]], [pairs[last], pairs[last - 1]]])
    for (const curve of two)
      for (let i = 0; i + 1 < curve.length; ++i) {
        const from = curve[i], to = curve[i + 1], size = apart(from, to), parts = Math.min(BESIDE, Math.ceil(BESIDE * size / length));
        if ((to.x - from.x) * at.n[1] - (to.y - from.y) * at.n[0] <= 0) continue; // material on the left, n away from body 1
        for (let k = 0; apart(from, at) <= length + size && k < parts; ++k) {
          const p = {x: from.x + k / parts * (to.x - from.x), y: from.y + k / parts * (to.y - from.y), n: at.n}, off = apart(p, at);
          if (!(off < length) || off >= apart(p, next) || off < 0.5 * apart(at, next)) continue;
          p.initial = -distanceAlong(one, p, at.n, length);
          if (Number.isFinite(p.initial) && p.initial >= 0) found.push(p);
        }
      }
  return found;
}

// Of every body the places of pairs and how far their initial gaps move it, each body against those that stand already. A rigid one
// keeps its shape: all of it is moved by the mean over its pairs.
function liftsOf(shapes, zones, rigid, images) {
  const lifts = new Map();
  let stands = new Set([shapes.keys().next().value]);
  for (let before = new Set(); stands.size > before.size;) {
    before = stands, stands = new Set(before);
    for (const {one, two, pairs} of zones) {
      if (before.has(one) === before.has(two)) continue;
      const [moved, fixed, sign] = before.has(one) ? [two, one, 1] : [one, two, -1], sources = lifts.get(moved) || [];
      const add = ({x, y, n, initial}) => {
        // the overlap of a press fit, magnified, would exceed the motion that closes it
        const base = liftAt(lifts.get(fixed), x, y), lift = sign * Math.max(initial, 0);
        const by = [base[0] + lift * n[0], base[1] + lift * n[1]];
        for (const image of images) sources.push({...turned(image, {x, y}), by: turnedBy(image, by)});
      };
      const every = Math.ceil(pairs.length / MOST_SOURCES);
      pairs.filter((_, i) => i % every === 0).forEach(add);
      if (!rigid.has(moved)) besideZone(pairs, shapes.get(one), shapes.get(two)).forEach(add);
      lifts.set(moved, sources), stands.add(moved);
    }
    for (const body of stands) {
      const sources = lifts.get(body);
      if (before.has(body) || !rigid.has(body) || sources.length === 0) continue;
      const mean = [0, 1].map((k) => sources.reduce((sum, source) => sum + source.by[k], 0) / sources.length);
      lifts.set(body, [{x: 0, y: 0, by: mean}]);
    }
  }
  return lifts;
}

// Means with the inverse fourth power of the distance as weight.
function liftAt(sources, x, y) {
  let sum = 0, out = [0, 0];
  for (const source of sources || []) {
    const weight = ((source.x - x) ** 2 + (source.y - y) ** 2) ** -2;
    if (!Number.isFinite(weight)) return source.by;
    sum += weight, out = [out[0] + weight * source.by[0], out[1] + weight * source.by[1]];
  }
  return sum > 0 ? [out[0] / sum, out[1] / sum] : out;
}

function isInside(curves, x, y) {
  let inside = false;
  for (const curve of curves)
    for (let i = 0, j = curve.length - 1; i < curve.length; j = i++) {
      const a = curve[i], b = curve[j];
      if ((a.y > y) !== (b.y > y) && x < a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y)) inside = !inside;
    }
  return inside;
}

// All that is drawn of a result but the factor. `whole`: the model, not its contact. `rows`: of the last step. `rigid`: which bodies
// are. `lifted`: the factors with which initial gaps have to be magnified by moving bodies; with others it makes no difference.
function deformation(ends, rows, zones, rigid, symmetry, whole) {
  const shapes = shapesOf(ends), joined = rows.filter((row) => row.status !== "open");
  const sides = zones.map(({zone, body1 = 1, body2 = 2}) => ({one: body1, two: body2, rows: rows.filter((row) => row.zone === zone)}))
    .filter(({one, two, rows: of}) => shapes.has(one) && shapes.has(two) && of.length > 0); // no platens
  for (const side of sides) side.pairs = pairsOf(side.rows, shapes.get(side.two));
  const lifts = liftsOf(shapes, sides, rigid, imagesOf(symmetry));
  const touching = joined.some((row) => row.status !== "tied") ? joined.filter((row) => row.status !== "tied") : joined;
  for (const [body, curves] of shapes)
    for (const end of curves.flat()) end.lift = liftAt(lifts.get(body), end.x, end.y);
  // how far the moved bodies are from the initial gap of a pair
  const pairs = sides.flatMap(({one, two, pairs: of}) => of.map(({x, y, n, initial, gap}) => {
    const [a, b] = [one, two].map((body) => liftAt(lifts.get(body), x, y));
    return {gap, initial, miss: (b[0] - a[0]) * n[0] + (b[1] - a[1]) * n[1] - initial};
  }));
  const near = whole || touching.length === 0 ? ends : touching, size = Math.max(spread(near, "x"), spread(near, "y"));
  const middle = (name) => Math.min(...near.map((each) => each[name])) + spread(near, name) / 2;
  const least = 0.02 * Math.max(spread(ends, "x"), spread(ends, "y")), half = 0.75 * Math.max(size, near === ends ? 0 : least);
  const closed = new Map([...shapes].map(([body, curves]) => [body, closedBy(symmetry, curves, half)]));
  const out = {shapes, closed, pairs, lifted: new Set(), whole: near === ends, x: middle("x"), y: middle("y"), half, reference: [0, 0]};
  const inContact = new Set(touching), held = out.whole ? [] : sides.flatMap((side) => side.pairs.filter((pair) => inContact.has(pair.row)));
  const seen = ends.filter((end) => Math.abs(end.x - out.x) <= half && Math.abs(end.y - out.y) <= half);
  const moving = held.length > 0 ? held.map(({moved: [ux, uy]}) => ({ux, uy})) : seen.length > 0 ? seen : ends;
  // images beyond a line in view are drawn where that line is, which does not move
  const inView = symmetry.filter((line) => isInView(line, out[line.axis], half));
  const mean = (name) => moving.reduce((sum, end) => sum + end[name], 0) / moving.length;
  if (!out.whole) out.reference = ["x", "y"].map((axis) => (inView.some((line) => line.axis === axis) ? 0 : mean(`u${axis}`)));
  out.wanted = wantedFactor(out, ends, [...moving, ...(out.whole ? ends : seen)], near, inView);
  return out;
}

// The largest motion, relative to what is not drawn, is at most a twelfth of what touches and a margin, or of the model, no more than
// twice its smallest body: the rule of the report's pictures (picture_contact.cpp, picture_deformed.cpp).
const SHARE = 1 / 12, AROUND = 1.25;
function wantedFactor(d, ends, moving, near, lines) {
  const larger = (list) => Math.max(spread(list, "x"), spread(list, "y"));
  const bodies = [...d.shapes.values()].map((curves) => larger(curves.flat()));
  const shown = imagesOf(lines).flatMap((image) => near.map((each) => turned(image, each)));
  const size = d.whole ? Math.min(larger(ends), 2 * Math.min(...bodies)) : AROUND * larger(shown) || 2 * d.half;
  const moved = Math.max(0, ...moving.map((end) => Math.hypot(end.ux - d.reference[0], end.uy - d.reference[1])),
    ...(d.whole ? d.pairs.map((pair) => Math.abs(pair.initial)) : []));
  return moved > 0 ? SHARE * size / moved : 1;
}

function placed(d, curves, factor) {
  const more = d.lifted.has(factor) ? factor - 1 : 0;
  return curves.map((curve) => curve.map((end) => ({
    x: end.x + factor * (end.ux - d.reference[0]) + more * end.lift[0],
    y: end.y + factor * (end.uy - d.reference[1]) + more * end.lift[1]})));
}

// Are gaps of pairs drawn as large as they are, times the factor?
function gapsFit(d, factor, pixel) {
  return d.pairs.every(({gap, initial, miss}) => {
    const is = factor * gap, error = (factor - 1) * (d.lifted.has(factor) ? miss : -initial);
    return is + error >= -MOST_OVERLAP * pixel && (is >= NEAR_GAP * pixel || Math.abs(error) <= MOST_GAP_ERROR * pixel);
  });
}

// Do magnified initial gaps leave the bodies their shape, or are they too small to be seen?
function shapesFit(d, factor, pixel) {
  const more = d.lifted.has(factor) ? factor - 1 : 0;
  for (const curve of [...d.shapes.values()].flat()) {
    let change = 0; // since the last place without distortion
    for (let i = 0; i + 1 < curve.length; ++i) {
      const a = curve[i], b = curve[i + 1], length = Math.hypot(b.x - a.x, b.y - a.y);
      if (length === 0) continue;
      const by = more * Math.hypot(b.lift[0] - a.lift[0], b.lift[1] - a.lift[1]);
      if (by <= MOST_DISTORTION * length || Math.abs(a.x - d.x) > d.half || Math.abs(a.y - d.y) > d.half) change = 0;
      else if ((change += by) > SEEN * pixel) return false;
    }
  }
  return true;
}

// Has what is drawn its gaps and shapes, and does no body reach into another, to a part of a `pixel`?
function fits(d, factor, pixel) {
  if (!gapsFit(d, factor, pixel) || !shapesFit(d, factor, pixel)) return false;
  const drawn = new Map([...d.shapes].map(([body, curves]) => [body, placed(d, curves, factor)]));
  for (const [other, outlines] of d.closed) {
    const around = placed(d, outlines, factor).map((curve) => [...curve, curve[0]]);
    const box = ["x", "y"].map((name) => [Math.min(...around.flat().map((p) => p[name])), Math.max(...around.flat().map((p) => p[name]))]);
    const isNear = (p) => Math.abs(p.x - d.x) <= d.half && Math.abs(p.y - d.y) <= d.half &&
      p.x > box[0][0] && p.x < box[0][1] && p.y > box[1][0] && p.y < box[1][1];
    const isDeep = (p) => isNear(p) && isInside(around, p.x, p.y) && nearestOn(around, p.x, p.y).distance > MOST_OVERLAP * pixel;
    for (const [body, curves] of drawn) if (body !== other && curves.flat().some(isDeep)) return false;
  }
  return true;
}

// Where a picture of `wide` pixels draws: its box, the middle of what it shows, and how long a pixel is.
function frameOf(d, lines, wide) {
  let [midX, midY, halfX, halfY] = [d.x, d.y, d.half, d.half]; // the contact in the middle
  if (d.whole) { // or the whole with its images
    const ends = [...d.shapes.values()].flat(2), all = imagesOf(lines).flatMap((image) => ends.map((end) => turned(image, end)));
    [halfX, halfY] = [0.55 * spread(all, "x"), 0.55 * spread(all, "y")];
    [midX, midY] = [Math.min(...all.map((p) => p.x)) + halfX / 1.1, Math.min(...all.map((p) => p.y)) + halfY / 1.1];
  } else {
    for (const line of lines) if (line.axis === "x" && isInView(line, midX, halfX)) halfX += Math.abs(midX - line.at), midX = line.at;
    for (const line of lines) if (line.axis === "y" && isInView(line, midY, halfY)) halfY += Math.abs(midY - line.at), midY = line.at;
  }
  const box = {left: 62, right: wide - 14, top: 24, bottom: 0}, room = box.right - box.left;
  box.bottom = box.top + Math.min(460, Math.max(0.5 * room, room * halfY / halfX));
  return {box, midX, midY, per: Math.max(2 * halfX / room, 2 * halfY / (box.bottom - box.top))};
}

// 1, 2, 5, 10, ...: those that fit, and which of them is wanted.
function factorsOf(d, lines, wide) {
  const out = [1], pixel = frameOf(d, lines, wide).per;
  for (let i = 1; ; ++i) {
    const factor = [1, 2, 5][i % 3] * 10 ** Math.floor(i / 3);
    if (factor > 10 * d.wanted) break;
    if (!fits(d, factor, pixel)) {
      d.lifted.add(factor);
      if (!fits(d, factor, pixel)) break;
    }
    out.push(factor);
  }
  return {factors: out, automatic: Math.max(0, out.filter((factor) => factor <= d.wanted).length - 1)};
}

// Closed outlines of curves that begin and end on lines: from the end of one along its line, material on the left, to the next
// one that begins there, or where lines cross, which does not move, along the other.
function closedBy(lines, curves, size) {
  const near = 1e-6 * size, across = (line) => (line.axis === "x" ? "y" : "x");
  const isClosed = (curve) => Math.hypot(curve[0].x - curve[curve.length - 1].x, curve[0].y - curve[curve.length - 1].y) < 1e-3 * near;
  const isOn = (line, p) => Math.abs(p[line.axis] - line.at) < near;
  const out = curves.filter(isClosed), open = curves.filter((curve) => !isClosed(curve));
  const goOn = (outline, first, line) => { // true: another curve follows
    const end = outline[outline.length - 1], other = across(line), side = curves.flat().some((p) => p[line.axis] > line.at + near) ? 1 : -1;
    const way = (line.axis === "x" ? -side : side), ahead = (place) => way * (place - end[other]);
    const next = [first, ...open].filter((curve) => isOn(line, curve[0]) && ahead(curve[0][other]) > 0).sort((p, q) => ahead(p[0][other]) - ahead(q[0][other]))[0];
    if (next !== undefined) {
      if (next !== first) outline.push(...open.splice(open.indexOf(next), 1)[0]);
      return next !== first;
    }
    const crossing = lines.find((each) => each.axis === other && ahead(each.at) > 0);
    if (crossing === undefined) return false;
    outline.push({...end, [line.axis]: line.at, [other]: crossing.at, ux: 0, uy: 0});
    return goOn(outline, first, crossing);
  };
  while (open.length > 0) {
    const first = open.shift(), outline = [...first];
    for (let more = true; more;) {
      const line = lines.find((each) => isOn(each, outline[outline.length - 1]));
      more = line !== undefined && goOn(outline, first, line);
    }
    out.push(outline);
  }
  return out;
}

// Is a view moved and widened to a line of symmetry, to show as much beyond it?
const isInView = (line, middle, half) => Math.abs(middle - line.at) < 2 * half;

// `lines`: with images beyond them; of bodies of revolution the axis is one.
function drawDeformed(d, factor, lines, unit, wide) {
  const images = imagesOf(lines), {box, midX, midY, per} = frameOf(d, lines, wide);
  const room = box.right - box.left, high = box.bottom - box.top;
  const x = scale(midX - per * room / 2, midX + per * room / 2, box.left, box.right);
  const y = scale(midY - per * high / 2, midY + per * high / 2, box.bottom, box.top);
  const path = (curves, image) => curves.map((curve) => curve.map((p, i) => {
    const at = turned(image, p);
    return `${i ? "L" : "M"}${x(at.x).toFixed(1)} ${y(at.y).toFixed(1)}`;
  }).join("")).join("");
  const out = [axes(x, y, box, `x${unit.length}`, `y${unit.length}`),
    `<clipPath id="deformed-box"><rect x="${box.left}" y="${box.top}" width="${room}" height="${high}"/></clipPath><g clip-path="url(#deformed-box)">`];
  let number = 0;
  for (const [body, curves] of d.shapes) {
    const fill = `var(--fill${1 + number++ % 2})`, drawn = placed(d, curves, factor), filled = placed(d, d.closed.get(body), factor);
    for (const image of images) out.push(`<path d="${path(filled, image)}" fill="${fill}" fill-rule="evenodd"/>`);
    for (const image of images) out.push(`<path d="${path(drawn, image)}" fill="none" stroke="var(--front)" stroke-width="1.3"/>`);
    if (d.whole) for (const image of images) out.push(`<path d="${path(curves, image)}" fill="none" stroke="var(--soft)" stroke-width="0.7" stroke-dasharray="3 3"/>`);
  }
  const words = factor === 1 ? "to scale" : `displacements and gaps × ${short(factor, 3)}`;
  out.push(`</g><rect x="${box.left}" y="${box.top}" width="${room}" height="${high}" fill="none" stroke="var(--line)"/>`,
    `<text x="${wide - 14}" y="16" text-anchor="end">${words}</text>`);
  return picture(wide, box.bottom + 44, `Deformed shape of ${d.shapes.size} bodies, ${d.whole ? "whole model" : "at the contact"}, ${words}`, out.join(""));
}

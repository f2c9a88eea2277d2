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

// Rows of one zone and step, in the order of pairs, with `s`: the length along the zone, or x where it is straight along x.
function drawPressure(rows, others, mu, unit, wide) {
  const width = wide, height = 330, box = {left: 62, right: width - 14, top: 46, bottom: height - 42};
  const bound = rows.map((row) => (Number.isFinite(mu) ? mu * Math.max(row.tn, 0) : 0));
  const values = [0, ...rows.flatMap((row, i) => [row.tn, row.tt, bound[i], -bound[i]]), ...others.flatMap((each) => each.map((row) => row.tn))];
  const x = scale(Math.min(...rows.map((row) => row.s)), Math.max(...rows.map((row) => row.s)), box.left, box.right);
  const y = scale(Math.min(...values), Math.max(...values), box.bottom, box.top);
  const xs = rows.map((row) => x(row.s)), out = [axes(x, y, box, `along the zone${unit.length}`, `tractions${unit.stress}`)];
  const band = [...xs.map((at, i) => `${at.toFixed(1)},${y(bound[i]).toFixed(1)}`), ...xs.map((at, i) => `${at.toFixed(1)},${y(-bound[i]).toFixed(1)}`).reverse()];
  out.push(`<polygon points="${band.join(" ")}" fill="var(--band)"/>`);
  for (const each of others) out.push(line(each.map((row) => x(row.s)), each.map((row) => y(row.tn)), 'stroke="var(--soft)" stroke-width="0.8" stroke-dasharray="3 3"'));
  out.push(line(xs, rows.map((row) => y(row.tt)), 'stroke="var(--friction)" stroke-width="2"'),
    line(xs, rows.map((row) => y(row.tn)), 'stroke="var(--pressure)" stroke-width="2"'),
    rows.map((row, i) => mark(row.status, xs[i], y(row.tn))).join(""));
  const peak = rows.reduce((best, row) => (row.tn > best.tn ? row : best), rows[0]);
  out.push(`<text x="${box.left}" y="16" style="fill:var(--pressure);font-weight:600">pressure</text><text x="${box.left + 68}" y="16" style="fill:var(--friction);font-weight:600">friction</text>`,
    `<g>${mark("stick", box.left + 130, 12)}${mark("slip", box.left + 182, 12)}${mark("open", box.left + 228, 12)}<text x="${box.left + 138}" y="16">stick</text><text x="${box.left + 190}" y="16">slip</text><text x="${box.left + 236}" y="16">open</text></g>`);
  const counts = ["stick", "slip", "open", "tied"].map((status) => [rows.filter((row) => row.status === status).length, status]).filter(([n]) => n > 0);
  return picture(width, height, `Pressure and friction: largest pressure ${short(peak.tn)} at ${short(peak.s)}; ${counts.map(([n, status]) => `${n} ${status}`).join(", ")}`, out.join(""));
}

const STATUS_FILL = {open: "none", stick: "var(--pressure)", slip: "var(--friction)", tied: "var(--soft)"};

// Statuses: across the zone, upwards the steps.
function drawStatus(steps, now, unit, wide) {
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
  out.push(`<rect x="${box.left}" y="${box.top}" width="${box.right - box.left}" height="${box.bottom - box.top}" fill="none" stroke="var(--line)"/>`,
    `<rect x="${box.left}" y="${y(now + 1.5).toFixed(1)}" width="${box.right - box.left}" height="${Math.max(2, y(now + 0.5) - y(now + 1.5)).toFixed(1)}" fill="none" stroke="var(--front)" stroke-width="2"/>`,
    `<text x="${box.left}" y="16">step by step: <tspan style="fill:var(--pressure);font-weight:600">stick</tspan> <tspan style="fill:var(--friction);font-weight:600">slip</tspan> open (blank)</text>`);
  for (const value of ticks(y.low, y.high, 4).filter((each) => Number.isInteger(each))) out.push(`<text x="${box.left - 6}" y="${(y(value) + 4).toFixed(1)}" text-anchor="end">${value}</text>`);
  return picture(width, box.bottom + 8, `Statuses of ${rows.length} pairs over ${steps.length} steps`, out.join(""));
}

// ---------------------------------------------------------------- the deformed shape
// Displacements and gaps are drawn times one factor: bodies that touch are drawn touching, and none is drawn over another. A gap
// that was there before any load is magnified by moving the other body, with a field that takes the pairs' values and is smooth
// elsewhere.

const MOST_SOURCES = 200; // pairs of a zone that are looked at; of more every second, third, ...

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

// Of every body the places of pairs and how far their initial gaps move it, each body against those that stand already.
function liftsOf(shapes, rows, zones) {
  const lifts = new Map(), stands = new Set([shapes.keys().next().value]);
  for (let more = true; more;) {
    more = false;
    for (const zone of zones) {
      const one = zone.body1 || 1, two = zone.body2 || 2;
      if (stands.has(one) === stands.has(two) || !shapes.has(one) || !shapes.has(two)) continue;
      const moved = stands.has(one) ? two : one, fixed = moved === two ? one : two, sources = lifts.get(moved) || [];
      const pairs = rows.filter((each) => each.zone === zone.zone), directions = directionsOf(pairs, shapes.get(two));
      const every = Math.ceil(pairs.length / MOST_SOURCES);
      for (let i = 0; i < pairs.length; i += every) {
        const row = pairs[i], [dx, dy] = directions[i]; // material is on the left, and n points into body 2
        const gap = (row.gap - row.un2 + row.un1) * (moved === two ? 1 : -1), base = liftAt(lifts.get(fixed), row.x, row.y);
        sources.push({x: row.x, y: row.y, by: [base[0] - gap * dy, base[1] + gap * dx]});
      }
      lifts.set(moved, sources), stands.add(moved);
      more = true;
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

// Where pairs touch or are tied: the end of an element of body 1 nearest to the pair, by curve and number, and body 2.
function meetingPlaces(shapes, rows, zones) {
  const out = [], every = Math.ceil(rows.length / MOST_SOURCES);
  for (let k = 0; k < rows.length; k += every) {
    const row = rows[k], zone = zones.find((each) => each.zone === row.zone) || {}, one = zone.body1 || 1, two = zone.body2 || 2;
    if (!shapes.has(one) || !shapes.has(two)) continue; // a platen
    let best = {distance: Infinity};
    shapes.get(one).forEach((curve, i) => curve.forEach((end, j) => {
      const distance = Math.hypot(end.x - row.x, end.y - row.y);
      if (distance < best.distance) best = {distance, one, two, i, j};
    }));
    out.push(best);
  }
  return out;
}

// All that is drawn of a result but the factor. `whole`: the model, not its contact. `rows`: of the last step.
function deformation(ends, rows, zones, whole) {
  const shapes = shapesOf(ends), joined = rows.filter((row) => row.status !== "open"), lifts = liftsOf(shapes, rows, zones);
  const touching = joined.some((row) => row.status !== "tied") ? joined.filter((row) => row.status !== "tied") : joined;
  for (const [body, curves] of shapes)
    for (const end of curves.flat()) end.lift = liftAt(lifts.get(body), end.x, end.y);
  const near = whole || touching.length === 0 ? ends : touching, size = Math.max(spread(near, "x"), spread(near, "y"));
  const middle = (name) => Math.min(...near.map((each) => each[name])) + spread(near, name) / 2;
  const least = 0.02 * Math.max(spread(ends, "x"), spread(ends, "y")), half = 0.75 * Math.max(size, near === ends ? 0 : least);
  const met = meetingPlaces(shapes, joined, zones);
  const out = {shapes, met, whole: near === ends, x: middle("x"), y: middle("y"), half, reference: [0, 0]};
  const seen = ends.filter((end) => Math.abs(end.x - out.x) <= half && Math.abs(end.y - out.y) <= half);
  const shown = seen.length > 0 && !out.whole ? seen : ends;
  if (!out.whole) out.reference = ["ux", "uy"].map((name) => shown.reduce((sum, end) => sum + end[name], 0) / shown.length);
  const moved = Math.max(...shown.map((end) => Math.hypot(end.ux - out.reference[0], end.uy - out.reference[1])));
  out.wanted = moved > 0 ? half / 6 / moved : 1;
  return out;
}

const placed = (d, curves, factor) => curves.map((curve) => curve.map((end) => ({
  x: end.x + factor * (end.ux - d.reference[0]) + (factor - 1) * end.lift[0],
  y: end.y + factor * (end.uy - d.reference[1]) + (factor - 1) * end.lift[1]})));

// Do bodies that touch touch as they are drawn, and does no other reach into one, to a pixel of `wide`?
function fits(d, factor, wide) {
  const pixel = 2 * d.half / wide, drawn = new Map([...d.shapes].map(([body, curves]) => [body, placed(d, curves, factor)]));
  for (const {one, two, i, j, distance} of d.met) {
    const p = drawn.get(one)[i][j];
    if (nearestOn(drawn.get(two), p.x, p.y).distance > Math.max(pixel, 1.5 * distance)) return false;
  }
  const closed = new Map([...drawn].map(([body, curves]) => [body, curves.map((curve) => [...curve, curve[0]])]));
  for (const [other, around] of closed) {
    const box = ["x", "y"].map((name) => [Math.min(...around.flat().map((p) => p[name])), Math.max(...around.flat().map((p) => p[name]))]);
    const isNear = (p) => Math.abs(p.x - d.x) <= d.half && Math.abs(p.y - d.y) <= d.half &&
      p.x > box[0][0] && p.x < box[0][1] && p.y > box[1][0] && p.y < box[1][1];
    for (const [body, curves] of drawn)
      if (body !== other && curves.flat().some((p) => isNear(p) && isInside(around, p.x, p.y) && nearestOn(around, p.x, p.y).distance > 0.5 * pixel)) return false;
  }
  return true;
}

// 1, 2, 5, 10, ...: those that fit, and which of them is wanted.
function factorsOf(d, wide) {
  const out = [1];
  for (let i = 1; ; ++i) {
    const factor = [1, 2, 5][i % 3] * 10 ** Math.floor(i / 3);
    if (factor > 10 * d.wanted || !fits(d, factor, wide)) break;
    out.push(factor);
  }
  return {factors: out, automatic: out.filter((factor) => factor <= d.wanted).length - 1};
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

// `symmetry`: lines with images beyond them, and the axis of bodies of revolution, which has none.
function drawDeformed(d, factor, symmetry, unit, wide) {
  const lines = symmetry.filter((line) => !line.isAxis);
  const ends = [...d.shapes.values()].flat(2), images = lines.reduce((all, line) => [...all, ...all.map((image) => ({...image, [line.axis]: line.at}))], [{}]);
  const turned = (image, p) => ({x: image.x === undefined ? p.x : 2 * image.x - p.x, y: image.y === undefined ? p.y : 2 * image.y - p.y});
  // the view: the contact in the middle, or the whole with its images
  let [midX, midY, halfX, halfY] = [d.x, d.y, d.half, d.half];
  if (d.whole) {
    const all = images.flatMap((image) => ends.map((end) => turned(image, end)));
    [halfX, halfY] = [0.55 * spread(all, "x"), 0.55 * spread(all, "y")];
    [midX, midY] = [Math.min(...all.map((p) => p.x)) + halfX / 1.1, Math.min(...all.map((p) => p.y)) + halfY / 1.1];
  } else {
    for (const line of lines) if (line.axis === "x" && Math.abs(midX - line.at) < 2 * halfX) halfX += Math.abs(midX - line.at), midX = line.at;
    for (const line of lines) if (line.axis === "y" && Math.abs(midY - line.at) < 2 * halfY) halfY += Math.abs(midY - line.at), midY = line.at;
  }
  const box = {left: 62, right: wide - 14, top: 24, bottom: 0}, room = box.right - box.left;
  box.bottom = box.top + Math.min(460, Math.max(0.5 * room, room * halfY / halfX));
  const per = Math.max(2 * halfX / room, 2 * halfY / (box.bottom - box.top)), high = box.bottom - box.top;
  const x = scale(midX - per * room / 2, midX + per * room / 2, box.left, box.right);
  const y = scale(midY - per * high / 2, midY + per * high / 2, box.bottom, box.top);
  const path = (curves, image) => curves.map((curve) => curve.map((p, i) => {
    const at = turned(image, p);
    return `${i ? "L" : "M"}${x(at.x).toFixed(1)} ${y(at.y).toFixed(1)}`;
  }).join("")).join("");
  const out = [axes(x, y, box, `x${unit.length}`, `y${unit.length}`),
    `<clipPath id="deformed-box"><rect x="${box.left}" y="${box.top}" width="${room}" height="${high}"/></clipPath><g clip-path="url(#deformed-box)">`];
  let number = 0;
  for (const curves of d.shapes.values()) {
    const fill = `var(--fill${1 + number++ % 2})`, drawn = placed(d, curves, factor), filled = placed(d, closedBy(symmetry, curves, d.half), factor);
    for (const image of images) out.push(`<path d="${path(filled, image)}" fill="${fill}" fill-rule="evenodd"/>`);
    for (const image of images) out.push(`<path d="${path(drawn, image)}" fill="none" stroke="var(--front)" stroke-width="1.3"/>`);
    if (d.whole) for (const image of images) out.push(`<path d="${path(curves, image)}" fill="none" stroke="var(--soft)" stroke-width="0.7" stroke-dasharray="3 3"/>`);
  }
  const words = factor === 1 ? "to scale" : `displacements and gaps × ${short(factor, 3)}`;
  out.push(`</g><rect x="${box.left}" y="${box.top}" width="${room}" height="${high}" fill="none" stroke="var(--line)"/>`,
    `<text x="${wide - 14}" y="16" text-anchor="end">${words}</text>`);
  return picture(wide, box.bottom + 44, `Deformed shape of ${d.shapes.size} bodies, ${d.whole ? "whole model" : "at the contact"}, ${words}`, out.join(""));
}

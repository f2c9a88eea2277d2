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

// Outlines of all bodies, undeformed thin, deformed filled. `ends`: rows of the boundary table, in the order of elements.
function drawDeformed(ends, factor, unit, wide) {
  const bodies = new Map();
  for (const end of ends) {
    if (!bodies.has(end.body)) bodies.set(end.body, []);
    bodies.get(end.body).push(end);
  }
  const xs = ends.flatMap((end) => [end.x, end.x + factor * end.ux]), ys = ends.flatMap((end) => [end.y, end.y + factor * end.uy]);
  const [x0, x1, y0, y1] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  const width = wide, margin = 14, room = width - 2 * margin;
  const size = Math.min(room / (x1 - x0 || 1), 460 / (y1 - y0 || 1)), height = size * (y1 - y0) + 2 * margin + 36;
  const left = (width - size * (x1 - x0)) / 2;
  const at = (x, y) => `${(left + size * (x - x0)).toFixed(1)} ${(height - margin - size * (y - y0)).toFixed(1)}`;
  // a jump from one element to the next begins another curve
  const path = (list, f) => {
    let out = "", before = null;
    for (const end of list) {
      const apart = before === null || Math.hypot(end.x - before.x, end.y - before.y) > 1e-9 * (x1 - x0 + y1 - y0) && end.element !== before.element;
      out += (apart ? "M" : "L") + at(end.x + f * end.ux, end.y + f * end.uy);
      before = end;
    }
    return out;
  };
  const out = [...bodies.values()].map((list, i) => `<path d="${path(list, factor)}" fill="var(--fill${1 + i % 2})" fill-rule="evenodd" stroke="var(--front)" stroke-width="1.3"/>`);
  out.push(...[...bodies.values()].map((list) => `<path d="${path(list, 0)}" fill="none" stroke="var(--soft)" stroke-width="0.7" stroke-dasharray="3 3"/>`),
    `<text x="${margin}" y="14">displacements times ${short(factor, 3)}</text>`,
    `<text x="${margin}" y="30">gaps to scale: bodies may seem to overlap</text>`);
  return picture(width, height, `Deformed shape of ${bodies.size} bodies, displacements times ${short(factor, 3)}`, out.join(""));
}

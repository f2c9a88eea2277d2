#include "forms.hpp"

#include "../dice.hpp"
#include "laws.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace random_decks {

namespace {

using namespace problem;

Form form(const char* name, const Problem& p) {
  Form f;
  f.name = name;
  f.problem = p;
  return f;
}

Form in_other_units(const Problem& p, Dice& dice) {
  const double length = dice.power(-3, 3), stress = dice.power(-5, 5);
  Form f = form("units", scaled(p, length, stress));
  f.map.length = 1 / length;
  f.map.stress = 1 / stress;
  return f;
}

Form mirrored(const Problem& p) {
  Form f = form("mirror", reflected(p));
  f.map.tangential = -1;
  return f;
}

Form with_bodies_exchanged(const Problem& p) {
  Form f = form("exchange", exchanged(p));
  f.map.exchanged = true;
  return f;
}

Form with_memory(const char* name, const Problem& p, Memory memory) {
  Form f = form(name, p);
  f.setup.memory = memory;
  return f;
}

Form with_threads(const Problem& p, int32_t threads) {
  Form f = form("threads", p);
  f.setup.threads = threads;
  f.equal_bits = true;
  return f;
}

Form with_changes(const Problem& p) {
  Form f = form("changes told", p);
  f.setup.every_change = 1;
  f.equal_bits = true;
  return f;
}

Form in_more_steps(const Problem& p, int32_t times) {
  Form f = form("increments", split(p, times));
  f.rows = times;
  return f;
}

// Does a range that is told by its elements alone run on, without going round the end of its region? One of half a ring
// could be read both ways.
bool runs_on(int32_t first, int32_t last, int32_t elements, int b) {
  return elements == 1 || last - first == (b == 0 ? elements - 1 : 1 - elements);
}

Problem renumbered_whole(const Problem& p, int32_t shift) {
  for (int32_t tries = 0; tries < 50; ++tries, ++shift) {
    const Problem q = renumbered(p, shift);
    bool whole = true;
    for (const problem::FreeZone& z : q.free_zones) whole = whole && z.elements[0] == 0 && z.elements[1] == 0;
    for (const problem::Zone& z : q.zones)
      for (int b = 0; b < 2 && p.function_nodes == 1; ++b)
        whole = whole && runs_on(z.first_element[b], z.last_element[b], z.elements, b);
    if (whole) return q;
  }
  return p;
}

std::string text(const char* what, double a, double b) {
  char line[200];
  std::snprintf(line, sizeof line, "%s %.9g and %.9g", what, a, b);
  return line;
}

std::vector<Step> rows_of(const Result& r, int32_t every) {
  std::vector<Step> out;
  const std::vector<Step> all = r.recorded();
  for (size_t i = static_cast<size_t>(every) - 1; i < all.size(); i += static_cast<size_t>(every)) out.push_back(all[i]);
  return out;
}

struct Gap {
  double traction = 0, displacement = 0;
};

double field(const Step& s, int pair, int which, const Mapping& m) {
  const bool tangential = which == C2D_TT || which == C2D_UT1 || which == C2D_UT2 || which == C2D_SLIP_SUM;
  const double sign = tangential ? m.tangential : 1, scale = which == C2D_TN || which == C2D_TT ? m.stress : m.length;
  if (!m.exchanged || which < C2D_UN1 || which > C2D_UT2) return sign * scale * s.at(pair, which);
  const int other = which < C2D_UN2 ? which + 2 : which - 2; // the frame turns round
  return -sign * scale * s.at(pair, other);
}

Gap between(const Step& a, const Step& b, const Mapping& map) {
  Gap gap;
  for (int i = 0; i < a.pairs() && i < b.pairs(); ++i)
    for (int which = C2D_TN; which <= C2D_SLIP_SUM; ++which) {
      double& worst = which <= C2D_TT ? gap.traction : gap.displacement;
      worst = std::max(worst, std::fabs(field(a, i, which, Mapping()) - field(b, i, which, map)));
    }
  if (a.pairs() != b.pairs()) gap.traction = HUGE_VAL;
  return gap;
}

Gap largest(const std::vector<Step>& rows) {
  Gap size;
  for (const Step& s : rows)
    for (int i = 0; i < s.pairs(); ++i)
      for (int which = C2D_TN; which <= C2D_UT2; ++which) {
        double& worst = which <= C2D_TT ? size.traction : size.displacement;
        worst = std::max(worst, std::fabs(s.at(i, which)));
      }
  return size;
}

// With its pairs in the opposite order.
Step image_of(const Step& s) {
  Step image = s;
  for (int i = 0; i < s.pairs(); ++i)
    for (int field = 0; field < C2D_PAIR_FIELDS; ++field)
      image.table[static_cast<size_t>(i * C2D_PAIR_FIELDS + field)] = s.at(s.pairs() - 1 - i, field);
  return image;
}

// The sizes are those of all rows of the deck.
std::string difference_of_rows(const Model& model, const Result& deck, const std::vector<Step>& rows,
                               const std::vector<Step>& others, const Mapping& map) {
  const double allowed = 100 * tolerance_of(deck);
  Gap sizes = largest(deck.recorded());
  Runs runs;
  runs.changes = deck;
  sizes.traction = std::max(sizes.traction, sizes_of(model.problem, runs).traction);
  for (size_t i = 0; i < rows.size(); ++i) {
    const Gap gap = between(rows[i], others[i], map);
    if (!(gap.traction > allowed * sizes.traction) && !(gap.displacement > allowed * sizes.displacement)) continue;
    const bool flying = gap.traction <= allowed * sizes.traction;
    char line[200];
    std::snprintf(line, sizeof line,
                  "%s row %zu of %zu at load %.6g %.6g: tractions %.2g of %.2g, displacements %.2g of %.2g (%.0e)",
                  flying ? "displacements differ in" : "tractions differ in", i + 1, rows.size(), rows[i].load, rows[i].second,
                  gap.traction, sizes.traction, gap.displacement, sizes.displacement, allowed);
    return line;
  }
  return "";
}

bool same_bits(const Step& a, const Step& b) {
  return a.table == b.table && a.work == b.work && a.dissipated == b.dissipated && a.elastic == b.elastic;
}

} // namespace

std::vector<Form> forms_of(const Model& model, uint64_t seed) {
  Dice dice(seed ^ 0xF0F0F0F0F0F0u);
  const Problem& p = model.problem;
  std::vector<Form> forms;
  forms.push_back(with_changes(p));
  forms.push_back(with_threads(p, dice.whole(2, 4)));
  forms.push_back(in_other_units(p, dice));
  forms.push_back(form("quarter turn", rotated(p, 90)));
  const double angle = dice.between(-180, 180);
  if (model.any_angle) forms.push_back(form("turn", rotated(p, angle)));
  forms.push_back(mirrored(p));
  forms.push_back(form("numbering", renumbered_whole(p, dice.whole(1, 20))));
  if (model.same_surfaces) forms.push_back(with_bodies_exchanged(p));
  forms.push_back(with_memory("least memory", p, Memory::minimum));
  forms.push_back(with_memory("some memory", p, Memory::between));
  forms.push_back(in_more_steps(p, dice.whole(2, 5)));
  return forms;
}

std::string difference(const Model& model, const Result& deck, const Form& form, const Result& other) {
  if (deck.status != other.status) return text("status", deck.status, other.status) + ": " + deck.messages() + other.messages();
  if (deck.status != C2D_OK) return "";
  if (deck.outcome != other.outcome)
    return std::string(c2d_outcome_message(deck.outcome)) + " at load " + std::to_string(deck.summary.load) + ", " +
           c2d_outcome_message(other.outcome) + " at " + std::to_string(other.summary.load);
  const std::vector<Step> rows = rows_of(deck, 1), others = rows_of(other, form.rows);
  if (rows.size() != others.size())
    return text("recorded rows", static_cast<double>(rows.size()), static_cast<double>(others.size()));
  if (std::fabs(deck.summary.load - other.summary.load) > 1e-6 * (1 + std::fabs(deck.summary.load)))
    return text("ends at load", deck.summary.load, other.summary.load);
  if (form.equal_bits)
    for (size_t i = 0; i < rows.size(); ++i)
      if (!same_bits(rows[i], others[i])) return text("bits differ in row", static_cast<double>(i + 1), 0);
  return difference_of_rows(model, deck, rows, others, form.map);
}

std::string asymmetry(const Model& model, const Result& deck) {
  std::vector<Step> rows, images;
  for (const Step& s : deck.recorded()) {
    if (s.second != 0) break;
    rows.push_back(s);
    images.push_back(image_of(s));
  }
  Mapping map;
  map.tangential = -1;
  return difference_of_rows(model, deck, rows, images, map);
}

} // namespace random_decks

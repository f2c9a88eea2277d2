// Statements of requested results, tolerances and limits.
#include "program/sketch/read/reader.hpp"

#include <algorithm>
#include <cmath>

namespace sketch {
namespace {

// Those of a body and `cycle`, or all; of torsion in sketches of bodies of revolution.
std::vector<const char*> words_of_wants(bool all, bool axisymmetric) {
  std::vector<const char*> out;
  for (const WantRow& row : wants())
    if (row.of == WantOf::kTorsion ? all && axisymmetric : all || row.of == WantOf::kPoints || row.of == WantOf::kCurves)
      out.push_back(row.word);
  if (all) out.push_back("cycle");
  return out;
}

// A tolerance of 1 without % would be 100 %: an error.
double tolerance_of(Statement& s, double value) {
  if (!(value > 0 && value <= 0.5))
    s.fail(show(value) + ": expected a tolerance above 0 and at most 50 %, such as 1 % or 0.01");
  return value;
}

// The row that requests the number whose name comes next; null: no such name does.
const WantRow* row_of_number(Statement& s) {
  for (const WantRow& row : wants())
    for (const app::Measure what : row.quantities)
      if (!s.is_next(row.word) && s.accept_phrase(app::name_of(what))) return &row;
  return nullptr;
}

} // namespace

// Is the next word a number and not the name of a result? A parameter may have such a name.
bool Reader::may_be_number(const Statement& s, size_t ahead) const {
  const std::vector<const char*> words = words_of_wants(true, s_.axisymmetric);
  return s.is_number(ahead) &&
         std::none_of(words.begin(), words.end(), [&](const char* word) { return s.is_next(word, ahead); });
}

void Reader::steps(Statement& s) {
  once(s, "the statement 'steps'");
  s_.steps.clear();
  do s_.steps.push_back(s.whole("the number of steps of each piece of the history", 1, 100000));
  while (s.has_more());
}

// Points where displacements and stresses are printed.
void Reader::stress(Statement& s) {
  end_body();
  const int body = body_named(s.take("the name of a body"));
  do s_.points.push_back({body, s.point("a point"), s.at()});
  while (s.has_more());
}

void Reader::want(Statement& s) {
  end_body();
  do want_one(s);
  while (s.has_more());
}

void Reader::want_one(Statement& s) {
  Want want;
  want.at = s.at();
  const std::vector<const char*> all = words_of_wants(true, s_.axisymmetric), of_body = words_of_wants(false, false);
  const WantRow* const named = row_of_number(s); // by the name that the number has in tables and responses
  want.word = named != nullptr ? named->word : all[s.choice(all)];
  want.cycle = want.word == "cycle";
  if (want.cycle) s.choice({"range"}), want.word = of_body[s.choice(of_body)];
  want.of = want_row(want.word).of;
  if (want.of == WantOf::kPoints) return want_stress(s, want);
  if (want.of == WantOf::kFatigue) return want_fatigue(s, want);
  if (want.word == "pressure" && s.accept("at")) return want_pressure_at(s, want);
  if (want.word == "approach" && s.accept("at")) return want_pair(s, want);
  if (want.of == WantOf::kCurves || want.word == "shear") want.side = side(s), want.body = want.side->body;
  if (may_be_number(s)) want.tolerance = tolerance_of(s, s.share("a tolerance"));
  s_.wants.push_back(want);
}

// Adds one want per point. A last number without a partner, or in percent, is their tolerance.
void Reader::want_points(Statement& s, Want want) {
  const size_t first = s_.wants.size();
  do want.where = s.point("a point"), s_.wants.push_back(want);
  while (may_be_number(s) && !s.is_share() && may_be_number(s, 1));
  if (!may_be_number(s)) return;
  const double tolerance = tolerance_of(s, s.share("a tolerance"));
  for (size_t i = first; i < s_.wants.size(); ++i) s_.wants[i].tolerance = tolerance;
}

// `want stress body x y`, `want stress zz body x y`, `want stress zz body.curve`.
void Reader::want_stress(Statement& s, Want want) {
  const bool is_body = std::any_of(s_.bodies.begin(), s_.bodies.end(), [](const Body& b) { return b.name == "zz"; });
  want.is_zz = !is_body && s.accept("zz");
  if (want.is_zz && s.is_side()) {
    want.of = WantOf::kCurves, want.side = side(s), want.body = want.side->body;
    if (may_be_number(s)) want.tolerance = tolerance_of(s, s.share("a tolerance"));
    s_.wants.push_back(want);
    return;
  }
  s.accept("at");
  want.body = body_named(s.take("the name of a body"));
  const size_t first = s_.wants.size();
  want_points(s, want);
  for (size_t i = first; i < s_.wants.size(); ++i) s_.points.push_back({want.body, s_.wants[i].where, s.at()});
}

void Reader::want_pair(Statement& s, Want want) {
  want.of = WantOf::kPair;
  want.body = body_named(s.take("the name of a body"));
  want.where = s.point("a point");
  want.other = body_named(s.take("the name of the body of the second point"));
  want.to = s.point("a second point");
  if (length(want.to - want.where) == 0) s.fail("both points are the same, expected two points");
  if (may_be_number(s)) want.tolerance = tolerance_of(s, s.share("a tolerance"));
  s_.points.push_back({want.body, want.where, want.at}), s_.points.push_back({want.other, want.to, want.at});
  s_.wants.push_back(want);
}

// The constants that a parameter needs, of the body just named.
void Reader::check_fatigue_constants(Statement& s, const Want& want) {
  const FatigueConstants& c = s_.bodies[static_cast<size_t>(want.body)].fatigue;
  const auto need = [&](double constant, const char* word, const char* example) {
    if (std::isnan(constant))
      s.fail("body " + in_quotes(s_.bodies[static_cast<size_t>(want.body)].name) + " has no fatigue constant " +
             in_quotes(word) + ", expected it in the statement of the body: fatigue " + word + " " + example);
  };
  switch (want.fatigue.kind) {
  case FatigueKind::kFatemiSocie: need(c.fatemi_socie, "fatemi-socie", "1"), need(c.yield, "yield", "400"); break;
  case FatigueKind::kFindley: need(c.findley, "findley", "0.3"); break;
  case FatigueKind::kCrossland: need(c.crossland, "crossland", "0.3"); break;
  case FatigueKind::kDangVan: need(c.dang_van, "dang-van", "0.3"); break;
  default: break;
  }
}

// `want fatigue swt pad.tip [depth d | mean d]`, or a body and interior points; a crack needs a depth. Ruiz's parameters are
// those of a surface.
void Reader::want_fatigue(Statement& s, Want want) {
  std::vector<const char*> words;
  for (const FatigueRow& row : fatigue_rows()) words.push_back(row.word);
  want.fatigue.kind = fatigue_rows()[s.choice(words)].kind;
  const FatigueKind kind = want.fatigue.kind;
  const bool is_rubbing = kind == FatigueKind::kRuiz1 || kind == FatigueKind::kRuiz2, is_crack = kind == FatigueKind::kCrack;
  const bool in_body =
      std::any_of(s_.bodies.begin(), s_.bodies.end(), [&](const Body& b) { return s.is_next(b.name.c_str()); });
  if (in_body && !is_rubbing && !is_crack) {
    want.fatigue.place = FatiguePlace::kPoint;
    want.body = body_named(s.take("the name of a body"));
    check_fatigue_constants(s, want);
    const size_t first = s_.wants.size();
    want_points(s, want);
    for (size_t i = first; i < s_.wants.size(); ++i) s_.fatigue_points.push_back({want.body, s_.wants[i].where, s.at()});
    return;
  }
  want.side = side(s), want.body = want.side->body;
  check_fatigue_constants(s, want);
  if (is_crack && !s.is_next("depth")) s.missing("depth and the length of the crack");
  const bool at_depth = !is_rubbing && s.accept("depth"), to_depth = !is_rubbing && !is_crack && !at_depth && s.accept("mean");
  if (at_depth || to_depth) {
    want.fatigue.place = at_depth ? FatiguePlace::kDepth : FatiguePlace::kMean;
    want.fatigue.depth = s.positive(is_crack ? "the length of the crack" : "a depth below the surface");
  }
  if (may_be_number(s)) want.tolerance = tolerance_of(s, s.share("a tolerance"));
  s_.wants.push_back(want);
}

void Reader::want_pressure_at(Statement& s, Want want) {
  want.of = WantOf::kPlaces;
  want.side = side(s), want.body = want.side->body;
  want_points(s, want);
}

void Reader::tolerance(Statement& s) {
  once(s, "the statement 'tolerance'");
  if (s.accept("off"))
    s_.adapts = false;
  else
    s_.tolerance = tolerance_of(s, s.share("a tolerance, such as 1 %, or off"));
}

void Reader::limit(Statement& s) {
  do {
    switch (s.choice({"seconds", "elements", "work"})) {
    case 0:
      once(s, "the limit 'seconds'");
      s_.most_seconds = s.positive("the number of seconds");
      break;
    case 1:
      once(s, "the limit 'elements'");
      s_.most_elements = s.whole("the number of elements", 1, 1000000);
      break;
    default: once(s, "the limit 'work'"); s_.most_work = s.positive("the number of multiplications");
    }
  } while (s.has_more());
}

} // namespace sketch

// Tables of the outputs whose entries are rare: parameters without derivatives, several zones, loads round the axis that end
// early, fatigue without a plane, words for every number.
#include "json.hpp"
#include "picture_runs.hpp"
#include "post/fatigue/ball.hpp"
#include "post/fatigue/criteria.hpp"
#include "post/fatigue/planes.hpp"
#include "report/csv.hpp"
#include "report/drawn/surface.hpp"
#include "report/json/json.hpp"
#include "report/json/json_torsion.hpp"
#include "report/listing/listing.hpp"
#include "report/page/page_fatigue.hpp"
#include "report/page/page_terms.hpp"
#include "report/page/page_tolerances.hpp"
#include "report/page/page_torsion.hpp"
#include "report/pictures/pictures.hpp"
#include "report/totals.hpp"
#include "shell.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace app;
using test::contains;

namespace {

// Two bodies and two zones between them, with units, and what was kept of a run.
struct Kept {
  RunRecord record;
  Scene scene;

  explicit Kept(bool units = true) {
    Summary& s = scene.summary;
    s.bodies = 2, s.zones = 2, s.load_cases = 1, s.coefficients = 1;
    s.body_name = {"low", "high"}, s.zone_name = {"left", "right"};
    s.body.list().assign(2, C2D_INIT(c2d_body_result));
    s.zone.assign(2, C2D_INIT(c2d_zone));
    for (c2d_zone& z : s.zone) z.side1.body = 1, z.side2.body = 2;
    scene.record = &record;
    scene.bodies.resize(2);
    scene.zones.resize(2);
    if (units) scene.stress_unit = "MPa", scene.length_unit = "mm", scene.force_unit = "N/mm", scene.work_unit = "mJ/mm";
  }
  ToleranceTable& table() { return record.meshes.tolerances; }
  std::string page() const {
    std::string out;
    append_page_tolerances(out, scene);
    return out;
  }
  std::string listing() const {
    std::string out;
    append_tolerances(out, record);
    return out;
  }
  std::string json() const {
    std::string out;
    append_tolerances(out, record.meshes.tolerances);
    return out;
  }
};

Stated number(Measure what, int32_t zone, double value, int32_t item = 0) {
  Stated s;
  s.what = what, s.zone = zone, s.value = value, s.scale = value, s.item = item;
  return s;
}

void append_step(RunRecord& record, std::vector<Quantity> all) {
  CoefficientRecord c;
  c.mu = 0.3;
  StepRecord step;
  step.step = 1, step.loads = {1.0}, step.quantities = std::move(all);
  c.steps.push_back(step);
  record.coefficients.push_back(c);
}

} // namespace

TEST_CASE("report tables: parameters without derivatives, and numbers of several zones") {
  Kept kept;
  ToleranceTable& t = kept.table();
  t.parameters = {{"radius", 5, 0.5, ""}, {"a_name_of_many_letters", 2, 0.1, "the history ends otherwise"}};
  Toleranced left{number(Measure::kContactWidth, 1, 4), {{2, ""}, {NAN, ""}}},
      right{number(Measure::kContactWidth, 2, 3), {{NAN, "two steps give 1 and 2"}, {NAN, ""}}},
      whole{number(Measure::kDissipated, 0, 7), {{1, ""}, {NAN, ""}}},
      edge{number(Measure::kContactEdge, 2, 1, 2), {{1, ""}, {NAN, ""}}};
  Toleranced stress{number(Measure::kStressXX, 0, 9), {{3, ""}, {NAN, ""}}};
  stress.number.body = 2, stress.number.at[0] = stress.number.at[1] = 0.5;
  t.numbers = {whole, left, right, edge, stress};
  CHECK(t.is_of_several_zones());
  CHECK(t.share(left, 0) == 1);
  CHECK(std::isnan(t.worst_case(left)));
  const std::string page = kept.page();
  for (const char* part : {"By a_name_of_many_letters no number: the history ends otherwise.",
                           "By radius not the contact width: two steps give 1 and 2.", "contact width, zone 1",
                           "contact width, zone 2", "contact edge 2, zone 2"}) {
    CAPTURE(part);
    CHECK(contains(page, part));
  }
  CHECK_FALSE(contains(page, "a_name_of_many_letters not the"));
  const std::string listing = kept.listing();
  CHECK(contains(listing, "a_name_of_many_letters "));
  CHECK(contains(listing, "   no derivatives: the history ends otherwise\n"));
  CHECK(contains(listing, "   no usable derivative: two steps give 1 and 2\n"));
  CHECK(contains(listing, "     all      -   "));
  CHECK(contains(listing, "       -      2   "));
  const test::Json json = test::JsonReader::read(kept.json());
  CHECK(json["parameters"][1]["why"].text == "the history ends otherwise");
  CHECK_FALSE(json["parameters"][0].has("why"));
  // Of one zone, or of none, names stand alone.
  t.numbers = {whole, left};
  CHECK_FALSE(t.is_of_several_zones());
  CHECK_FALSE(contains(kept.page(), "zone 1"));
  // Nothing at all.
  t.numbers.clear(), t.why = "the history ended early";
  CHECK(contains(kept.page(), "<p>No derivatives: the history ended early.</p>"));
  CHECK_FALSE(contains(kept.page(), "worst case"));
  CHECK(contains(kept.listing(), "\n  no derivatives: the history ended early\n"));
  CHECK_FALSE(contains(kept.listing(), "worst case"));
}

TEST_CASE("report tables: bars of tolerances, of many parameters and many numbers") {
  Kept kept;
  ToleranceTable& t = kept.table();
  for (int p = 0; p < 9; ++p) t.parameters.push_back({"p" + std::to_string(p), 1, 0.1, ""});
  for (int k = 0; k < 40; ++k) {
    Toleranced one{number(Measure::kContactEdge, 1 + k % 2, 1 + k, k + 1), {}};
    one.by.assign(9, {1.0, ""});
    t.numbers.push_back(one);
  }
  Toleranced zero{number(Measure::kMoment, 1, 0), {}}, none{number(Measure::kForceX, 1, 5), {}};
  zero.by.assign(9, {1.0, ""}), none.by.assign(9, {NAN, ""});
  t.numbers.push_back(zero), t.numbers.push_back(none);
  Pictures out;
  draw_tolerances(kept.scene, out);
  REQUIRE(out.size() == 1);
  test::check_picture(out[0].name, out[0].svg);
  CHECK(contains(out[0].svg, "all others"));
  CHECK(contains(out[0].svg, "contact edge 1, zone 1")); // 90 % of the smallest value: the longest bar
  CHECK_FALSE(contains(out[0].svg, "contact edge 40"));
  CHECK_FALSE(contains(out[0].svg, "moment"));
  CHECK_FALSE(contains(out[0].svg, "force x"));
}

TEST_CASE("report tables: bars of every number of parameters have as many fills, and one more for all others") {
  for (size_t count = 1; count < 9; ++count) {
    CAPTURE(count);
    Kept kept;
    for (size_t p = 0; p < count; ++p) kept.table().parameters.push_back({"p" + std::to_string(p), 1, 0.1, ""});
    Toleranced one{number(Measure::kContactEdge, 1, 1, 1), {}};
    one.by.assign(count, {1.0, ""});
    kept.table().numbers.push_back(one);
    Pictures out;
    draw_tolerances(kept.scene, out);
    REQUIRE(out.size() == 1);
    CHECK(contains(out[0].svg, "all others") == (count > 6));
    CHECK(contains(out[0].svg, ">p" + std::to_string(count - 1) + " ") == (count <= 6));
  }
}

TEST_CASE("report tables: whole forces of zones, of a body that a line of symmetry cuts, and nothing else") {
  Kept kept;
  Summary& s = kept.scene.summary;
  std::vector<Quantity> all(4);
  for (Quantity& q : all) q.what = Measure::kForceY, q.value = 3, q.zone = 1;
  all[1].zone = 0, all[2].zone = 7, all[3].what = Measure::kMoment;
  CHECK(with_wholes(all, s).size() == 4);
  CHECK(std::string(words_of_totals(s)).empty());
}

TEST_CASE("report tables: loads of more cases than a legend has strokes share these") {
  const test::Folder folder;
  std::string text = "body b E 1 nu 0\nfrom 0 0\nline s to 1 0\nline e to 1 1\nline n to 0 1\nline w close\nfix b.s\n", history;
  for (int c = 1; c <= 18; ++c) {
    text += "case c" + std::to_string(c) + "\n" + (c % 4 == 2 ? "force b at 0.5 0.5 fx 1\n" : "traction b.n fx 0.1\n");
    history += "history c" + std::to_string(c) + " 1\n";
  }
  test::write_file(folder / "s.c2s", text + history + "steps 1\ntolerance off\n");
  const test::Result run =
      test::run_shell("'" + paths::program() + "' run -q '" + (folder / "s.c2s") + "' --report '" + (folder / "p.html") + "'");
  REQUIRE_MESSAGE(run.status == 0, run.err);
  const std::string page = test::read_file(folder / "p.html");
  for (const char* part : {"cases 1, 5, 9, ...", "cases 3, 7, 11, ...", "cases 4, 8, 12, ..."}) {
    CAPTURE(part);
    CHECK(contains(page, part));
  }
}

TEST_CASE("report tables: rows of the summary find their tolerances by measure, curve, body and place") {
  Kept kept;
  ToleranceTable& t = kept.table();
  t.parameters = {{"R", 5, 0.5, ""}};
  const auto add = [&](Stated s, double derivative) { t.numbers.push_back({s, {{derivative, ""}}}); };
  Stated stress = number(Measure::kStressXX, 0, 9);
  stress.body = 1, stress.at[0] = 1, stress.at[1] = 2;
  Stated other = stress, beside = stress, above = stress, along = number(Measure::kLargestAlong, 0, 4);
  other.body = 2, beside.at[0] = 3, above.at[1] = 4, along.body = 1, along.of = " of top";
  Stated along_other = along;
  along_other.of = " of foot";
  double derivative = 0;
  for (const Stated& s : {other, beside, above, along, along_other, stress}) add(s, derivative += 2);
  Stated nowhere = stress; // a place that is not known is another one
  nowhere.at[0] = nowhere.at[1] = NAN;
  Stated missing = stress;
  missing.at[0] = missing.at[1] = 77;
  kept.record.meshes.stated = {stress, other, beside, above, along, along_other, missing, nowhere};
  Stated moment = number(Measure::kMoment, 2, 1);
  moment.body = 1; // not that of the zone
  add(moment, 500);
  add(number(Measure::kContactWidth, 1, 1), 100), add(number(Measure::kContactWidth, 2, 1), 200);
  add(number(Measure::kContactEdge, 2, 1, 1), 300), add(number(Measure::kContactEdge, 2, 1, 2), 400);
  std::vector<Quantity> all;
  for (const auto& [what, zone, item] : {std::tuple(Measure::kContactWidth, 1, 0), std::tuple(Measure::kContactWidth, 2, 0),
                                         std::tuple(Measure::kContactEdge, 2, 2), std::tuple(Measure::kMoment, 2, 0)}) {
    Quantity q;
    q.what = what, q.zone = zone, q.item = item, q.value = 1;
    all.push_back(q);
  }
  append_step(kept.record, all);
  std::string csv;
  append_summary(csv, kept.record, kept.scene.summary);
  std::vector<double> worst; // the column before the last
  for (size_t at = csv.find('\n') + 1; at < csv.size();) {
    const size_t end = csv.find('\n', at), last = csv.rfind(',', end), before = csv.rfind(',', last - 1);
    worst.push_back(last - before > 1 ? std::strtod(csv.c_str() + before + 1, nullptr) : -1);
    at = end + 1;
  }
  CHECK(worst == std::vector<double>{50, 100, 200, -1, 6, 1, 2, 3, 4, 5, -1, -1});
}

TEST_CASE("report tables: loads round the axis that end early, and tractions that are given") {
  Kept kept;
  TorsionTable& t = kept.record.meshes.torsion;
  CHECK_FALSE(t.any());
  t.parts = {{"bar.top", 2, true}, {"bar.foot", 1, false}};
  t.contacts = {{"left", false, 5, 1, {1, 0}, NAN}};
  t.ended = "the contact slips throughout";
  t.steps.push_back({{0.5}, {NAN, 0}, {1, -1}, {1}, {3}});
  CHECK(t.any());
  std::string listing, page, json;
  append_torsion(listing, kept.record);
  append_page_torsion(page, kept.scene);
  append_json_torsion(json, t);
  CHECK(contains(listing, "  The history ended early: the contact slips throughout.\n"));
  CHECK(contains(page, " The history ended early: the contact slips throughout."));
  const test::Json read = test::JsonReader::read(json);
  CHECK(contains(json, "\"angle\": [null, 0]"));
  CHECK(read["turned"][0]["given"].text == "traction");
  CHECK(read["turned"][1]["given"].text == "angle");
  CHECK(read["ended"].text == "the contact slips throughout");
  t.borders = {{1, {NAN, 0.5}}};
  json.clear();
  append_json_torsion(json, t);
  CHECK(contains(json, "[null, 0.5]"));
  t = TorsionTable();
  t.why = "a body can turn";
  CHECK(t.any());
}

TEST_CASE("report tables: fatigue parameters with a plane and without, with units and without") {
  for (const bool units : {true, false}) {
    CAPTURE(units);
    Kept kept(units);
    Stated plane = number(Measure::kSwt, 0, 3), none = number(Measure::kCrossland, 0, 4);
    plane.body = none.body = 1, plane.at[0] = 1, plane.at[1] = 2, plane.error = 0.1, plane.angle = 30;
    kept.record.meshes.stated = {plane, none, number(Measure::kContactWidth, 1, 1)};
    std::string page;
    append_page_fatigue(page, kept.scene);
    CHECK(contains(page, "30&#176;"));
    CHECK(contains(page, "&#177; &#8211;"));
    CHECK(contains(page, "<td>&#8211;</td></tr>"));
    CHECK(contains(page, units ? "<th>x, mm</th>" : "<th>x</th>"));
    // Lines along curves: of zeros, of two points and beyond the sixth none is drawn.
    for (const Measure what : {Measure::kSwt, Measure::kRuiz1, Measure::kRuiz2, Measure::kCrackRange, Measure::kDangVan})
      for (int k = 0; k < 3; ++k) {
        FatigueLine line;
        line.what = what, line.along = "top";
        for (int i = 0; i < (k == 1 ? 2 : 5); ++i) line.points.push_back({static_cast<double>(i), k == 2 ? 0.0 : 1.0 + i % 3});
        kept.record.meshes.fatigue.push_back(line);
      }
    for (int k = 0; k < 12; ++k) kept.record.meshes.fatigue.push_back(kept.record.meshes.fatigue[0]);
    Pictures out;
    draw_fatigue(kept.scene, out);
    REQUIRE(out.size() == 1);
    test::check_picture(out[0].name, out[0].svg);
    CHECK(contains(out[0].svg, name_of(Measure::kRuiz2)));
  }
}

TEST_CASE("report tables: every number has a unit of its dimension, and those of tables a meaning") {
  const Kept with, without(false);
  for (size_t k = 0; k < kMeasures; ++k) {
    const Measure what = static_cast<Measure>(k);
    CAPTURE(name_of(what));
    const std::string unit = unit_of(what, with.scene);
    CHECK((unit_of(what, without.scene).empty() || what == Measure::kRotation));
    if (row_of(what).unit == Unit::kLength) CHECK(unit == "mm");
    if (row_of(what).unit == Unit::kWork) CHECK(unit == "mJ/mm");
    const std::string meaning = meaning_of(what) != nullptr ? meaning_of(what) : "";
    if (what < Measure::kTractions && what != Measure::kWalk && what != Measure::kStuckAll) CHECK_FALSE(meaning.empty());
    if (what >= Measure::kSwt && what <= Measure::kCrackRange) CHECK_FALSE(meaning.empty());
  }
  CHECK(unit_of(Measure::kCrackRange, with.scene) == "MPa &#8730;mm");
  CHECK(unit_of(Measure::kEdgePressure, with.scene) == "MPa/&#8730;mm");
  CHECK(unit_of(Measure::kRuiz2, with.scene) == "MPa&#183;N/mm");
}

TEST_CASE("report tables: where no tolerance was met, moving loads are named") {
  MeshLoop loop;
  loop.positions = 48;
  CHECK(loop.ending().empty());
  loop.stopped = "the work limit";
  CHECK(loop.ending() ==
        "It ended here: the work limit. The moving loads have 48 positions in a period, and errors include the "
        "change from 24");
  loop.positions = 0;
  CHECK(loop.ending() == "It ended here: the work limit");
}

TEST_CASE("report tables: elements of a side, up, down and across the end of an outline") {
  BodyScene body;
  body.curves.emplace_back();
  const Point corners[] = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  for (int32_t e = 1; e <= 4; ++e) {
    const Point at = corners[e - 1], moved{at.x + e, at.y};
    body.curves[0].push_back({e, 0, at, moved});
  }
  const auto normal_at = [&](int32_t first, int32_t last, int32_t elements) {
    c2d_side side = {};
    side.body = 1, side.first_element = first, side.last_element = last, side.elements = elements;
    return surface_at(body, side, {1.9, 1.1}).normal;
  };
  const auto is = [](Point n, double x, double y) { return std::hypot(n.x - x, n.y - y) < 1e-12; };
  CHECK(is(normal_at(0, 0, 0), 1, 0));
  CHECK(is(normal_at(1, 2, 2), 1, 0));
  CHECK(is(normal_at(2, 1, 2), 1, 0));
  CHECK(is(normal_at(1, 1, 1), 0, -1));
  CHECK(is(normal_at(3, 1, 3), 1, 0));  // down from 3 to 1
  CHECK(is(normal_at(4, 1, 2), 0, -1)); // up across the end: 4 and 1
  CHECK(is(normal_at(3, 2, 4), 1, 0));  // all, from 3 round to 2
  CHECK(is(normal_at(1, 3, 2), 0, 1));  // down across the end: 1, 4 and 3
}

TEST_CASE("report tables: fatigue of no stress, of points in one place, of planes in closed form") {
  CHECK(smallest_ball({}).radius == 0);
  CHECK(smallest_ball({{1, 2, 3}, {1, 2, 3}}).radius == 0);
  CHECK(smallest_ball({{0, 0, 0}, {2, 0, 0}, {1, 0.5, 0}}).radius == doctest::Approx(1));
  CHECK(largest_over_planes({}, {{0, 1, 0}}, {}).value == 0);
  CHECK(largest_over_planes({{0, 1, 0}}, {}, {}).value == 0);
  FatigueMaterial steel;
  steel.findley = 0.3;
  CHECK(std::isinf(fatigue_bound(FatigueCriterion::kSwt, {}, steel)));
  CHECK(std::isinf(fatigue_bound(FatigueCriterion::kCrossland, {{1, 0, 0, 0}}, steel)));
  // Findley, uniaxial tension from 0 to s: half the root of 1 + k^2, plus k, times s over 2.
  const double k = steel.findley, s = 8;
  const double exact = s / 2 * (std::sqrt(0.25 + k * k) + k);
  CHECK(fatigue_value(FatigueCriterion::kFindley, {{0, 0, 0, 0}, {s, 0, 0, 0}}, steel).value == doctest::Approx(exact));
  CHECK(fatigue_value(FatigueCriterion::kFindley, {{0, 0, 0, 0}, {0, s, 0, 0}}, steel).value == doctest::Approx(exact));
}

// Pictures, tables and words of states made by hand: what a model that is solved shows rarely, or never.
#include "json.hpp"
#include "many_bodies.hpp"
#include "picture_runs.hpp"
#include "post/cracks.hpp"
#include "report/csv.hpp"
#include "report/cycle.hpp"
#include "report/json/json.hpp"
#include "report/listing/key_table.hpp"
#include "report/listing/listing.hpp"
#include "report/listing/listing_items.hpp"
#include "report/page/page.hpp"
#include "report/page/page_cycles.hpp"
#include "report/pictures/contour.hpp"
#include "report/pictures/gap_lift.hpp"
#include "report/pictures/model_symbols.hpp"
#include "report/pictures/pictures.hpp"
#include "report/stresses.hpp"
#include "report/trace.hpp"
#include "report/vtk.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>

using namespace app;
using test::contains;

namespace {

struct Row {
  int32_t status = C2D_OPEN;
  double tn = 0, tt = 0, gap = 0, slip = 0;
};

// Two bodies, one above the other, and pairs along y = 0 between them, in one zone or several of as many pairs.
struct Hand {
  RunRecord record;
  History history;
  Scene scene;

  explicit Hand(size_t pairs, size_t zones = 1) {
    Summary& s = scene.summary;
    s.bodies = 2, s.function_nodes = 2, s.zones = static_cast<int32_t>(zones), s.pairs = static_cast<int32_t>(pairs * zones);
    s.load_cases = 1, s.coefficients = 1;
    s.body.list().assign(2, C2D_INIT(c2d_body_result));
    scene.record = &record, scene.history = &history;
    scene.images = scene.zone_images = {{{1, 1}, {0, 0}}};
    const double wide = static_cast<double>(pairs * zones);
    for (const double side : {1.0, -1.0}) {
      BodyScene body;
      const Point corners[] = {{0, 0}, {side * wide, 0}, {side * wide, side * 4}, {0, side * 4}};
      body.curves.emplace_back();
      for (const Point& at : corners) {
        const Point p{side > 0 ? at.x : at.x + wide, at.y};
        body.curves[0].push_back({1, 0, p, p});
        body.corners.push_back(p);
      }
      scene.bodies.push_back(body);
    }
    for (size_t z = 0; z < zones; ++z) {
      ZoneScene zone;
      zone.first = zone.origin = z * pairs, zone.pairs = pairs;
      for (size_t p = zone.first; p < zone.first + pairs; ++p) {
        const double at = static_cast<double>(p);
        zone.samples.push_back({p, at, 1});
        PairScene pair{};
        pair.zone = static_cast<int32_t>(z) + 1, pair.on[0] = pair.on[1] = {at, 0}, pair.s = at;
        scene.pairs.push_back(pair);
      }
      scene.zones.push_back(zone);
      c2d_zone side = C2D_INIT(c2d_zone);
      side.pairs = static_cast<int32_t>(pairs), side.side1.body = 1, side.side2.body = 2;
      s.zone.push_back(side);
    }
  }

  // A step of the callback; its rows are the first ones, the others are open.
  void step(std::vector<double> loads, std::vector<Row> rows, int32_t number, int32_t coefficient = 1,
            int32_t kind = C2D_STEP_RECORDED) {
    rows.resize(scene.pairs.size());
    std::vector<double> table;
    for (const Row& row : rows) {
      std::array<double, C2D_PAIR_FIELDS> r{};
      r[C2D_STATUS] = row.status, r[C2D_TN] = row.tn, r[C2D_TT] = row.tt, r[C2D_GAP] = row.gap, r[C2D_SLIP_SUM] = row.slip;
      table.insert(table.end(), r.begin(), r.end());
    }
    c2d_step now = C2D_INIT(c2d_step);
    now.kind = kind, now.coefficient = coefficient, now.step = number, now.pairs = static_cast<int32_t>(rows.size());
    now.mu = 0.3, now.load = loads.front(), now.cases = static_cast<int32_t>(loads.size()), now.loads = loads.data();
    now.work_by_case = loads.data(), now.table = table.data(), now.stride = C2D_PAIR_FIELDS;
    CoefficientRecord& c = keep_step(record, now);
    keep_history(c, now, nullptr, {}, {});
    history.note(now);
  }
  Pictures draw(void (*one)(const Scene&, Pictures&)) const {
    Pictures out;
    one(scene, out);
    for (const Picture& p : out) test::check_picture(p.name, p.svg);
    return out;
  }
};

std::vector<Row> rows_of(size_t count, const Row& row) { return std::vector<Row>(count, row); }

size_t times(const std::string& text, const std::string& part) {
  size_t count = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

} // namespace

// ---- tractions

TEST_CASE("report: one pressure that is far above the others is told, and not drawn") {
  Hand hand(60);
  std::vector<Row> rows = rows_of(60, {C2D_STICK, 1, 0, 0, 0});
  rows[40].tn = 100;
  hand.step({1}, rows, 1);
  const Pictures out = hand.draw(draw_tractions);
  REQUIRE(out.size() >= 1);
  CHECK(contains(out[0].svg, "1 pair beyond the axis: up to 100 at s = 40"));
  rows.resize(100, rows[0]), rows[20].tn = 90;
  Hand two(100);
  two.step({1}, rows, 1);
  CHECK(contains(two.draw(draw_tractions)[0].svg, "2 pairs beyond the axis: up to 100 at s = 40"));
}

TEST_CASE("report: bodies that have left each other: the pressure of before is drawn, and the caption says that none is left") {
  Hand hand(8);
  hand.step({1}, rows_of(8, {C2D_STICK, 2, 0, 0, 0}), 1);
  hand.step({-1}, {}, 2);
  const Pictures out = hand.draw(draw_tractions);
  REQUIRE(out.size() == 1);
  CHECK(contains(out[0].caption, "no pair touches."));
  Hand never(8);
  never.step({1}, {}, 1);
  CHECK(never.draw(draw_tractions).empty());
  never.scene.zones[0].pairs = 0; // without pairs
  CHECK(never.draw(draw_tractions).empty());
}

TEST_CASE("report: the half width of a contact at a line of symmetry, on either side of it, and of one away from it") {
  for (const int from : {0, 5, 2}) { // up from the line; down from it; beside it
    CAPTURE(from);
    Hand hand(8);
    ZoneScene& zone = hand.scene.zones[0];
    zone.symmetric_origin = true, zone.origin = from == 5 ? 7 : 0;
    for (size_t i = 0; i < 8; ++i) zone.samples[i].s = hand.scene.pairs[i].s = static_cast<double>(i) - (from == 5 ? 7 : 0);
    std::vector<Row> rows(8);
    for (size_t i = 0; i < 3; ++i) rows[static_cast<size_t>(from) + i] = {C2D_STICK, 1, 0, 0, 0};
    hand.step({1}, rows, 1);
    const Pictures out = hand.draw(draw_tractions);
    REQUIRE(out.size() >= 1);
    CHECK(contains(out[0].caption, "contact half width 2 (to the last touching node)") == (from != 2));
    CHECK(contains(out[0].caption, " between s = 2 and 4") == (from == 2));
  }
}

TEST_CASE("report: around edges of contact what slips beside stick, or presses most; of many the first and the last") {
  // Blocks of 4 pairs of 200 that touch: each edge is worth a view only if the largest pressure or stick beside slip is there.
  Hand hand(200);
  std::vector<Row> rows(200);
  const auto block = [&](size_t from, int32_t status, double tn) {
    for (size_t i = from; i < from + 4; ++i) rows[i] = {status, tn, status == C2D_SLIP ? 0.3 * tn : 0.1, 0, 0};
  };
  block(20, C2D_SLIP, 1), block(100, C2D_SLIP, 2), block(160, C2D_SLIP, 1);
  hand.step({1}, rows, 1);
  Pictures out = hand.draw(draw_tractions);
  REQUIRE(out.size() == 2); // nothing sticks: the middle block has the largest pressure
  CHECK(out[1].name == "edges");
  CHECK(contains(out[1].caption, "the first and the last edge"));
  CHECK(contains(out[0].caption, "no pair sticks"));
  rows[101].status = C2D_STICK, rows[101].tt = 0.1; // now each edge has slip, and something sticks
  Hand sticking(200);
  sticking.step({1}, rows, 1);
  out = sticking.draw(draw_tractions);
  REQUIRE(out.size() == 2);
  CHECK(contains(out[0].caption, "; sticking from s = 101 to 101, 11 pairs slip"));
  rows[103].status = C2D_STICK, rows[103].tt = 0.1; // with one that slips between them
  Hand parted(200);
  parted.step({1}, rows, 1);
  CHECK(contains(parted.draw(draw_tractions)[0].caption, "; sticking in 2 stretches between s = 101 and 103, 10 pairs slip"));
  // Slip to the end of the zone: as far as there are pairs.
  Hand whole(40);
  std::vector<Row> slipping = rows_of(40, {C2D_SLIP, 1, 0.3, 0, 0});
  slipping[39] = {C2D_OPEN, 0, 0, 1, 0};
  whole.step({1}, slipping, 1);
  CHECK(whole.draw(draw_tractions).size() == 1); // that is all of it
}

// ---- path, status, energy

TEST_CASE("report: a coefficient that has come to nothing is no line of the path, and has no map and no energy") {
  Hand hand(6);
  hand.scene.summary.coefficients = 2;
  hand.step({1}, rows_of(6, {C2D_STICK, 1, 0, 0, 0}), 1, 2); // of the second alone
  hand.record.coefficients[0].table.assign(6 * C2D_PAIR_FIELDS, 0.0);
  const Pictures path = hand.draw(draw_path);
  REQUIRE(path.size() == 1);
  CHECK(times(path[0].caption, "pairs in contact") == 1);
  const Pictures map = hand.draw(draw_status_map);
  REQUIRE(map.size() == 1);
  CHECK(map[0].name == "status_2");
  CHECK(hand.draw(draw_energy).empty()); // it goes by coefficients, up to the first without
}

TEST_CASE("report: of the path nothing without steps; of loads that come later, from zero on; no more than six lines") {
  const Hand none(6);
  for (const auto draw : {draw_path, draw_energy, draw_status_map, draw_tractions, draw_gap, draw_loop})
    CHECK(none.draw(draw).empty());
  Hand later(6);
  later.scene.cases = 2, later.scene.summary.load_cases = 2;
  later.step({1, 0}, rows_of(6, {C2D_STICK, 1, 0, 0, 0}), 1);
  later.step({1, 1}, rows_of(6, {C2D_SLIP, 1, 0.3, 0, 0.1}), 2);
  later.record.coefficients[0].steps[0].loads.resize(1);
  const Pictures path = later.draw(draw_path);
  REQUIRE(path.size() == 1);
  CHECK(contains(path[0].svg, "Factors of the load cases"));
  Hand many(4);
  many.scene.summary.coefficients = 7;
  for (int32_t c = 1; c <= 7; ++c) many.step({1}, rows_of(4, {C2D_STICK, 1, 0, 0, 0}), 1, c);
  const Pictures seven = many.draw(draw_path);
  REQUIRE(seven.size() == 1);
  CHECK(times(seven[0].caption, "pairs in contact") == 6);
  CHECK(contains(seven[0].caption, "; further coefficients are not drawn"));
  // Places on the path without a history: the load that was recorded.
  many.record.coefficients.resize(8);
  many.record.coefficients[7].load = 0.25;
  CHECK(place_on_path(many.scene, 7) == "load factor 0.25");
  RunRecord empty;
  many.scene.record = &empty;
  many.scene.summary.load = 0.75, many.scene.summary.mu = 0.5;
  CHECK(place_at_end(many.scene) == "load factor 0.75, &#956; = 0.5");
}

TEST_CASE(
    "report: a contact whose friction never changes has no loop; of a history without an entry for it tractions are drawn") {
  Hand hand(6);
  for (int32_t k = 1; k <= 4; ++k) {
    hand.step({k % 2 == 0 ? -1.0 : 1.0}, rows_of(6, {C2D_STICK, 1, 0, 0, 0}), k);
    Quantity shift;
    shift.what = Measure::kShift, shift.zone = 1, shift.value = 0.1 * k;
    hand.record.coefficients[0].steps.back().quantities.push_back(shift);
  }
  CHECK(hand.draw(draw_loop).empty()); // it moves, and nothing rubs
  for (StepRecord& step : hand.record.coefficients[0].steps) {
    Quantity rub;
    rub.what = Measure::kFrictionForce, rub.zone = 1, rub.value = step.loads[0];
    step.quantities.push_back(rub);
  }
  CHECK(hand.draw(draw_loop).size() == 1);
  const History none;
  hand.scene.history = &none;
  CHECK(hand.draw(draw_tractions).size() == 1);
  CHECK(hand.draw(draw_status_map).empty());
}

TEST_CASE("report: a cycle that walks, of two zones; what is drawn of it, and what not if it is not whole") {
  Hand hand(2, 2);
  const auto state = [](double tt) {
    return std::vector<Row>{{C2D_SLIP, 1, tt, 0, 0}, {C2D_STICK, 1, 0, 0, 0}, {C2D_STICK, 2, 0, 0, 0}, {C2D_OPEN, 0, 0, 1, 0}};
  };
  CycleSeen seen;
  seen.cycles = 1, seen.change = 0.5, seen.dissipated = 0.25, seen.slip_range = 2;
  seen.zones = {{2, 1, 1, 0.5, 2}, {1, 1, 0, 0, 0}};
  const auto table = [&hand](int32_t kind, int32_t number, double load, const std::vector<Row>& rows, double moved) {
    std::vector<double> out;
    for (const Row& row : rows) {
      std::array<double, C2D_PAIR_FIELDS> r{};
      r[C2D_STATUS] = row.status, r[C2D_TN] = row.tn, r[C2D_TT] = row.tt, r[C2D_UT2] = out.empty() ? moved : 0;
      out.insert(out.end(), r.begin(), r.end());
    }
    c2d_step now = C2D_INIT(c2d_step);
    now.kind = kind, now.coefficient = 1, now.step = number, now.pairs = 4, now.mu = 0.3, now.load = load, now.cases = 1;
    now.loads = now.work_by_case = &load, now.table = out.data(), now.stride = C2D_PAIR_FIELDS;
    CoefficientRecord& c = keep_step(hand.record, now);
    if (kind == C2D_STEP_CYCLE) {
      keep_cycle_start(c, now, nullptr, {});
      hand.history.note_cycle(now, {{0, {0, 1}}, {-1, {2}}});
      return;
    }
    keep_history(c, now, nullptr, {}, {});
    hand.history.note(now);
  };
  table(C2D_STEP_RECORDED, 1, 1, state(0.3), 5);
  CoefficientRecord& c = hand.record.coefficients[0];
  for (int i = 0; i < 2; ++i) { // the second takes the place of the first
    table(C2D_STEP_CYCLE, 1, 1, state(0.3), 7 + i);
    seen.cycles = i + 1, seen.extrapolations = 1;
    c.cycles.push_back(seen);
  }
  CHECK(hand.draw(draw_cycle_loop).empty()); // it has not been recorded
  CHECK(hand.draw(draw_cycles).size() == 1);
  CHECK(find_cycle(c).any() == false);
  table(C2D_STEP_RECORDED, 2, 0, state(-0.3), 10);
  table(C2D_STEP_RECORDED, 3, 1, state(0.3), 9);
  CHECK((find_cycle(c).first == 0 && find_cycle(c).last == 2));
  const Pictures curves = hand.draw(draw_cycles), loops = hand.draw(draw_cycle_loop), statuses = hand.draw(draw_cycle_status);
  REQUIRE((curves.size() == 2 && loops.size() == 1 && statuses.size() == 2));
  CHECK((curves[0].name == "cycles" && curves[1].name == "cycle_steps"));
  CHECK(contains(curves[0].caption, "After 1 cycle the state was extrapolated"));
  CHECK((contains(curves[0].svg, "Walk in each cycle") && contains(curves[0].svg, ">extrapolation<")));
  CHECK(contains(curves[1].svg, "zone 2"));
  CHECK(contains(loops[0].caption, "pair 1 at s = 0"));
  // From 8 to 10 with -0.3 to 0.3 on side 1, and back to 9: no area, and 1 from where it began.
  CHECK(contains(loops[0].caption, "moves over 2 and dissipates "));
  CHECK(contains(loops[0].caption, "it ends 1 from where it began"));
  CHECK(contains(statuses[0].caption, "1 of 2 pairs stick all the time, 1 slip at some time"));
  CHECK(contains(statuses[1].caption, "1 of 2 pairs stick all the time, 0 slip at some time"));
  std::string page;
  hand.scene.solved = true;
  append_page_cycles(page, hand.scene);
  CHECK(contains(page, "<h2>Cycles</h2>"));
  CHECK(!contains(page, "Steps of the last cycle")); // nothing sums up their contact
  c.outcome = C2D_FREE_MOTION;
  CHECK(!find_cycle(c).any());
  CHECK(steps_of_cycle(c).empty());
}

TEST_CASE("report: sixteen charts of a kind at most, over all zones and coefficients; zones without pairs have none") {
  Hand hand(3, 18);
  hand.step({1}, rows_of(54, {C2D_STICK, 1, 0, 0.5, 0}), 1);
  CHECK(hand.draw(draw_gap).size() == kMostCharts);
  hand.scene.zones[0].pairs = 0;
  const Pictures out = hand.draw(draw_gap);
  CHECK(out.size() == kMostCharts);
  CHECK(out.front().name == "gap_zone2");
  CHECK(out.back().name == "gap_zone17");
}

TEST_CASE("report: what lengths are counted from, where two lines of symmetry meet") {
  Hand hand(4);
  Scene& scene = hand.scene;
  ZoneScene& zone = scene.zones[0];
  CHECK(position_name(scene, zone) == "s from pair 1, along body 1");
  zone.symmetric_origin = true;
  scene.summary.symmetry = 1, scene.summary.symmetry_at[0] = 2, scene.summary.symmetry_at[1] = -3;
  CHECK(position_name(scene, zone) == "s from the line of symmetry, along body 1");
  scene.summary.symmetry = 3;
  scene.pairs[0].image_line = 1;
  CHECK(position_name(scene, zone) == "s from the line of symmetry x = 2, along body 1");
  scene.pairs[0].image_line = 2;
  CHECK(position_name(scene, zone) == "s from the line of symmetry y = -3, along body 1");
  zone.position = "y";
  CHECK(position_name(scene, zone) == "y, along body 1");
}

// ---- meshes

namespace {

MeshRound mesh(int32_t elements, double change = NAN) {
  MeshRound out;
  out.elements = elements, out.pressure = out.energy = change;
  MeshCurve curve;
  for (int i = 0; i <= 8; ++i) curve.ends.push_back({i * 1.0, 0.0});
  out.curves = {curve, MeshCurve()};
  return out;
}

} // namespace

TEST_CASE("report: meshes of bodies that touch nowhere, of one mesh alone, of nothing to show") {
  Hand hand(8);
  hand.record.meshes.rounds = {mesh(16), mesh(32)};
  hand.record.meshes.taken = 1;
  const auto draw = [&] {
    const Pictures out = hand.draw(draw_meshes);
    REQUIRE(out.size() == 1);
    return out[0];
  };
  hand.step({1}, {}, 1); // all open: about the shortest elements
  Picture all = draw();
  CHECK(contains(all.svg, "The contact on mesh 2"));
  CHECK(contains(all.caption, "On the left is the first mesh, on the right the one of the results, number 2 of 2"));
  hand.record.coefficients[0].table.clear(); // nothing is known of it: all of the zone
  CHECK(contains(draw().svg, "The contact on mesh 2"));
  hand.record.coefficients.clear();
  CHECK(contains(draw().svg, "The contact on mesh 2"));
  hand.record.meshes.taken = 0;
  hand.record.meshes.stopped = "there is no time & no memory";
  Picture one = draw();
  CHECK(contains(one.svg, "The contact on mesh 1"));
  CHECK(one.caption ==
        "It ended here: there is no time &amp; no memory. Strokes across the boundary are ends of elements. The results are "
        "those of the first mesh. The dashed frame is enlarged.");
  MeshCurve& back = hand.record.meshes.rounds[0].curves[0]; // there and back again: a stroke has no direction there
  back.ends = {{0, 0}, {4, 0}, {0, 0}};
  CHECK(contains(draw().svg, "The contact on mesh 1"));
  // Zones without a length, and of platens, are no contact to look at.
  for (PairScene& pair : hand.scene.pairs) pair.on[0] = pair.on[1] = {1, 0};
  for (const size_t taken : {size_t{0}, size_t{1}}) {
    hand.record.meshes.taken = taken;
    CHECK_FALSE(contains(draw().svg, "The contact on mesh"));
  }
  hand.scene.bodies[0].platen = true;
  CHECK_FALSE(contains(draw().svg, "The contact on mesh"));
  for (BodyScene& body : hand.scene.bodies) body.curves.clear();
  CHECK(hand.draw(draw_meshes).empty());
  hand.record.meshes.rounds[1].curves.clear(); // of a deck
  CHECK(hand.draw(draw_meshes).empty());
  CHECK(hand.draw(draw_convergence).empty()); // changes are not known
}

TEST_CASE("report: convergence of changes alone, of one of them, with errors of numbers that were asked for") {
  Hand hand(4);
  MeshLoop& loop = hand.record.meshes;
  loop.rounds = {mesh(10), mesh(20, 0.1), mesh(40, 0.01)};
  const auto draw = [&] {
    const Pictures out = hand.draw(draw_convergence);
    REQUIRE(out.size() == 1);
    return out[0];
  };
  Picture both = draw();
  CHECK((contains(both.svg, ">tractions</text>") && contains(both.svg, ">energy</text>")));
  CHECK_FALSE(contains(both.caption, "Below: stated errors"));
  loop.rounds[1].pressure = loop.rounds[2].pressure = NAN; // as where nothing touches
  Picture energy = draw();
  CHECK((!contains(energy.svg, ">tractions</text>") && contains(energy.svg, ">energy</text>")));
  loop.rounds[1].pressure = 0.2; // one alone is no line, and beside it there is one
  CHECK(contains(draw().svg, ">tractions</text>"));
  Stated peak;
  peak.what = Measure::kPeakPressure, peak.value = 1, peak.scale = 1, peak.error = 0.02, peak.tolerance = 0.01;
  loop.rounds[2].stated = {peak};
  Picture stated = draw();
  CHECK(contains(stated.svg, ">peak pressure</text>"));
  CHECK(contains(stated.caption, "Below: stated errors"));
  loop.rounds[2].energy = NAN; // two meshes alone do not converge
  CHECK(hand.draw(draw_convergence).empty());
}

// ---- symbols of the model

TEST_CASE("report: loads that are nothing, or beyond the picture, have no symbol, but turns about such points") {
  Hand hand(4);
  Scene& scene = hand.scene;
  const Chart view = make_view({100, 100, 400, 300}, {0, 4, false}, {-4, 4, false}, 10, "mm");
  const auto drawn = [&] {
    Svg svg("s", 500, 400);
    const std::string nothing = svg.finish("", "");
    Present present;
    draw_loads(svg, scene, view, present);
    const std::string text = svg.finish("", "");
    size_t kinds = 0;
    for (const std::vector<bool>& cases : present.load) kinds += !cases.empty();
    CHECK((kinds > 0) == (text != nothing));
    return kinds;
  };
  CHECK(drawn() == 0);
  const Point far{1000, 1000};
  scene.point_loads = {{1, {1, 1}, {0, 0}, 0}, {1, far, {1, 0}, 0}, {1, {1, 1}, {1, 0}, 1}}; // nothing, far, another case
  CHECK(drawn() == 0);
  scene.point_loads.push_back({1, {1, 1}, {0, 1}, 0});
  CHECK(drawn() == 1);
  scene.point_loads.clear();
  scene.body_forces = {{1, 0, {0, 0}, 0, {0, 0}}};
  CHECK(drawn() == 0);
  scene.body_forces = {{1, 0, {0, 0}, 1, far}}; // about a point beyond the picture: at the middle of the body
  CHECK(drawn() == 1);
  scene.body_forces = {{1, 0, {0, 1}, 0, {0, 0}}, {2, 0, {0, 0}, 1, {2, 0}}};
  CHECK(drawn() == 2);
  scene.body_forces.clear();
  scene.motions = {{2, 0, {0, 0}, 0, {0, 0}}};
  CHECK(drawn() == 0);
  scene.motions = {{2, 0, {0, 0}, -1, far}};
  CHECK(drawn() == 1);
  scene.motions = {{2, 0, {1, 0}, 0.5, {2, 0}}};
  CHECK(drawn() == 1);
  // A force is drawn on its body, wherever on its line of action its point lies; with a moment, at the point.
  const Point middle{0.5 * (scene.bodies[1].curves[0][0].at.x + scene.bodies[1].curves[0][2].at.x),
                     0.5 * (scene.bodies[1].curves[0][0].at.y + scene.bodies[1].curves[0][2].at.y)};
  const auto marked = [&](Point at, double moment) { // is the point's circle in the middle of the body?
    scene.rigid_loads = {{2, at, {0, -1}, moment}};
    Svg svg("s", 500, 400), circle("s", 500, 400);
    Present present;
    draw_loads(svg, scene, view, present);
    circle.mark(Mark::kCircle, view.at(middle), 4.0, "#d55e00");
    const std::string all = circle.finish("", ""), text = svg.finish("", "");
    const size_t from = all.find("cx=");
    REQUIRE(from != std::string::npos);
    return contains(text, all.substr(from, all.find(" r=", from) - from));
  };
  CHECK(marked({middle.x, 3.9}, 0));
  CHECK_FALSE(marked({middle.x, -3.9}, 0)); // in the body: where it is
  CHECK_FALSE(marked({middle.x, 3.9}, 1));
  scene.rigid_loads.clear();
  for (BodyScene& body : scene.bodies) // out of sight; and without an area there is no middle
    for (OutlinePoint& p : body.curves[0]) p.at = p.moved = {p.at.x + 1000, p.at.y};
  scene.motions[0].rotation = 0, scene.body_forces = {{1, 0, {1, 1}, 0, {0, 0}}};
  CHECK(drawn() == 0);
  scene.bodies[0].curves.clear(), scene.bodies[1].curves.clear();
  CHECK(drawn() == 2); // then it is the origin, which is in sight
}

TEST_CASE("report: motions are those of the rigid body, or of a rigid one of several; cases are told where there are some") {
  Hand hand(4);
  Present present;
  present.note(Symbol::kRigidMotion, 1);
  hand.scene.cases = 2;
  for (const bool second : {false, true}) {
    hand.scene.bodies[0].rigid = true, hand.scene.bodies[1].rigid = second;
    const std::vector<LegendEntry> legend = symbol_legend(hand.scene, present);
    REQUIRE(legend.size() == 1);
    CHECK(legend[0].text == std::string("motion of ") + (second ? "a" : "the") + " rigid body, case 2");
  }
  hand.scene.cases = 1;
  CHECK(symbol_legend(hand.scene, present).empty());
}

TEST_CASE("report: a model whose bodies have no outline is not drawn; one that platens alone hold has no contact") {
  Hand hand(4);
  for (BodyScene& body : hand.scene.bodies) body.on_line.assign(1, false);
  Pictures out = hand.draw(draw_model);
  REQUIRE(!out.empty());
  CHECK((contains(out[0].svg, ">contact zone</text>") && !contains(out[0].svg, ">tie</text>")));
  hand.scene.bodies[0].platen = true;
  out = hand.draw(draw_model);
  REQUIRE(out.size() == 1);
  CHECK((!contains(out[0].svg, ">contact zone</text>") && !contains(out[0].svg, ">tie</text>")));
  CHECK(contains(out[0].caption, "body 1 moves elements 0 to 0 of body 2 as if rigid"));
  CHECK(hand.scene.summary.moved_by(2).empty()); // no zone of its own
  for (BodyScene& body : hand.scene.bodies) body.curves.clear();
  CHECK(hand.draw(draw_model).empty());
}

// ---- tables

namespace {

Summary two_bodies() {
  Summary s;
  s.bodies = 2, s.pairs = 2, s.zones = 1, s.function_nodes = 2, s.load_cases = 1;
  s.body.list().assign(2, C2D_INIT(c2d_body_result));
  c2d_zone zone = C2D_INIT(c2d_zone);
  zone.pairs = 2, zone.side1.body = 1, zone.side2.body = 2;
  s.zone = {zone};
  s.body_name = {"", ""}, s.zone_name = {""};
  return s;
}

} // namespace

TEST_CASE("report: JSON of what has no number, no step, no name") {
  Summary s = two_bodies();
  s.body_name.clear(), s.zone_name.clear(); // as of a model that is not complete
  s.body.list()[1].applied[2] = NAN;
  RunRecord record;
  record.friction = {0.5, INFINITY};
  record.measure = {1, 2}; // of two zones, of which the model tells one
  record.coefficients.resize(2);
  CoefficientRecord &one = record.coefficients[0], &two = record.coefficients[1];
  one.mu = 0.5, one.load = 0.25, one.outcome = C2D_FREE_MOTION, one.why = "it \"moves\"\t";
  two.mu = INFINITY, two.singular = true;
  CornerState notch;
  notch.body[0] = 1, notch.joint = "free", notch.exponents = {0.5, 0.9}, notch.K = 2, notch.K_error = 0.1;
  record.corners = {notch, notch, notch};
  record.corners[1].K2 = -3, record.corners[1].K2_error = 0.2;
  record.corners[2].why = "too few nodes near it";
  std::string text;
  append_json(text, record, s);
  const test::Json json = test::JsonReader::read(text);
  CHECK(contains(text, "\"mu\": [0.5, null]"));
  CHECK(contains(text, "\"why\": \"it \\\"moves\\\"\\u0009\""));
  CHECK(json["incomplete"]["loads"].items.size() == 1);
  CHECK(json["incomplete"]["loads"][0].number == 0.25);
  CHECK(json["runs"][0]["outcome"].text == "free motion");
  CHECK(json["runs"][1]["outcome"].text == "singular");
  CHECK_FALSE(json["runs"][0].has("quantities"));
  CHECK(contains(text, "\"applied\": [0, 0, null]"));
  CHECK_FALSE(json["force"]["bodies"][0].has("name"));
  REQUIRE(json["corners"].items.size() == 3);
  CHECK_FALSE(json["corners"][0].has("K2"));
  CHECK(json["corners"][1]["K2"].number == -3);
  CHECK(json["corners"][1]["K2_error"].number == 0.2);
  CHECK(json["corners"][2]["why"].text == "too few nodes near it");
  CHECK_FALSE(json["corners"][2].has("K_error"));
  CHECK(json["zones"].items.size() == 2);
  s.body_name = {"bolt", ""}, s.zone_name = {"thread"};
  text.clear();
  append_json(text, record, s);
  const test::Json named = test::JsonReader::read(text);
  CHECK(named["zones"][0]["name"].text == "thread");
  CHECK(named["zones"][0]["body2"].number == 2);
  CHECK_FALSE(named["zones"][1].has("body2"));
  CHECK(named["force"]["bodies"][0]["name"].text == "bolt");
}

TEST_CASE("report: a listing of coefficients without a step, of several cracks, of a singular one") {
  const Summary s = two_bodies();
  RunRecord record;
  record.coefficients.resize(3);
  record.coefficients[0].mu = 0.125; // no step
  for (const size_t c : {size_t{1}, size_t{2}}) {
    record.coefficients[c].mu = 0.25 * static_cast<double>(c);
    record.coefficients[c].steps.resize(1);
    record.coefficients[c].steps[0].loads = {1};
    StressIntensity crack;
    crack.zone = 1, crack.K1 = NAN, crack.K2 = 3, crack.why = "closed";
    record.coefficients[c].steps[0].cracks = {crack};
  }
  std::string text;
  append_ending(text, record, s);
  CHECK(times(text, "Stress intensity at tips of cracks") == 1);
  CHECK(times(text, "         load factors\n") == 0);
  const std::string energy = text.substr(text.find("Energy"), text.find("Contact in numbers") - text.find("Energy"));
  CHECK(times(energy, "coefficient of friction") == 2); // not the one without a step
  CHECK(times(text, "            -            3              1   closed\n") == 2);
  record.coefficients[2].singular = true;
  record.coefficients[2].why = "no unique solution";
  text.clear();
  append_ending(text, record, s);
  CHECK(contains(text, "0.5  incomplete: singular at load factor 0, step 0: no unique solution\n"));
  CHECK_FALSE(contains(text, "Energy"));
  CHECK(std::string(record.outcome()) == "singular");
  std::string table;
  append_summary(table, record, s);
  CHECK(table == "mu,step,load,zone,name,quantity,item,value,x,y,error,s,along,plane_angle,worst_case,root_of_squares\n");
}

TEST_CASE("report: places in free zones as they are printed, with others and without a table; statuses that are none") {
  Summary s = two_bodies();
  s.zone.push_back(s.zone[0]);
  s.zone[0].kind = C2D_ZONE_FREE;
  s.zone_name.emplace_back();
  s.zones = 2;
  CoefficientRecord c;
  const ContactEnd place{1, 3, 0, 1, 1, 0.5, 0, -1e-5};
  std::vector<ContactEnd> ends[2] = {{place, place}, {}};
  ends[0][1].eta = -0.4321;
  std::string text;
  append_contact_zone(text, c, ends, s);
  CHECK(text.empty()); // there is no table
  c.table.assign(2 * C2D_PAIR_FIELDS, 0.0);
  append_contact_zone(text, c, ends, s);
  CHECK(contains(text, "       1       3  0.000  5.00000e-01"));
  CHECK(contains(text, "       1       3 -0.432  5.00000e-01"));
  CHECK(times(text, "in zones of non-matching meshes") == 2); // of both bodies
  s.pairs = 0;
  text.clear();
  append_contact_zone(text, c, ends, s);
  CHECK(text.empty());
  c2d_step step = C2D_INIT(c2d_step);
  const double load = 1;
  std::vector<double> table(2 * C2D_PAIR_FIELDS, 0.0);
  table[C2D_STATUS] = -1, table[C2D_PAIR_FIELDS + C2D_STATUS] = C2D_TIED;
  step.kind = C2D_STEP_RECORDED, step.pairs = 2, step.stride = C2D_PAIR_FIELDS, step.table = table.data();
  step.cases = 1, step.loads = step.work_by_case = &load;
  append_step(text, step, false);
  CHECK(contains(text, "   ??\n"));
  History history;
  history.note(step); // of no coefficient: it is the first
  REQUIRE(history.coefficients().size() == 1);
  CHECK(history.coefficients()[0].points.at(0).count[C2D_OPEN] == 0);
  RunRecord record;
  keep_step(record, step);
  CHECK(record.coefficients.size() == 1);
}

TEST_CASE("report: errors of numbers that have no place") {
  RunRecord record;
  record.meshes.rounds.resize(1);
  Stated s;
  s.what = Measure::kPressureOn, s.of = "left", s.body = 1, s.value = 2, s.error = 0.1, s.scale = 2;
  record.meshes.stated = {s, s};
  record.meshes.stated[1].at[0] = 0.5, record.meshes.stated[1].at[1] = 0.25;
  std::string text;
  append_accuracy(text, record);
  CHECK(times(text, "pressure on left") == 2);
  CHECK(times(text, "   at (") == 1);
  CHECK(contains(text, "   at (0.5, 0.25)\n"));
}

TEST_CASE("report: ranges of stress over the steps that have it; points of grids outside are left out, others are not") {
  RunRecord record;
  record.coefficients.resize(2); // the second without
  CoefficientRecord& c = record.coefficients[0];
  c.mu = 0.5;
  c.steps.resize(3);
  for (size_t i = 0; i < 3; ++i)
    c.steps[i].step = static_cast<int32_t>(i) + 1, c.steps[i].loads = {1.0 + static_cast<double>(i)};
  const double none = NAN;
  c.steps[0].stresses = {1, 0, 0, 0, 1, none, none, none, none, none, none, none, none, none, none};
  c.steps[2].stresses = {3, 0, 0, 0, 3, none, none, none, none, none, none, none, none, none, none};
  const std::vector<StressPlace> places = {{1, 1, 0, 0.5, 0, false}, {1, 0, 1, 9, 9, true}, {1, 0, 2, 8, 8, false}};
  std::string text;
  append_ranges(text, record, places);
  const std::vector<std::string> rows = test::lines_of(text);
  REQUIRE(rows.size() == 3);
  CHECK(rows[1] == "0.5,1,3,1,1,0,0.5,0,1,3,1,3,3,2");
  CHECK(rows[2] == "0.5,1,3,1,0,2,8,8,,,nan,nan,nan,nan");
}

TEST_CASE("report: names of bodies are told where a zone joins others than the first and the second") {
  Summary s = two_bodies();
  CHECK_FALSE(s.names_bodies());
  s.zone[0].side2.body = 1;
  CHECK(s.names_bodies());
  s.zone[0].side1.body = 2, s.zone[0].side2.body = 2;
  CHECK(s.names_bodies());
  s = two_bodies();
  s.zone_name[0] = "x";
  CHECK(s.names_bodies());
  s = two_bodies();
  s.bodies = 3;
  CHECK(s.names_bodies());
}

TEST_CASE("report: steps of which no numbers are known have no key table, and no place on the page") {
  Hand hand(4, 2);
  Summary& s = hand.scene.summary;
  s.zone_name = {"", ""}, s.body_name = {"", ""};
  hand.scene.solved = true;
  const auto page = [&] {
    std::string out;
    append_page(out, hand.scene, {}, "deck");
    CHECK(contains(out, "<h1>deck</h1>"));
    return out;
  };
  CHECK_FALSE(contains(page(), "id=\"numbers\""));
  hand.step({1}, rows_of(8, {C2D_STICK, 1, 0, 0, 0}), 1);
  CoefficientRecord& c = hand.record.coefficients[0];
  CHECK(key_table(c, 1, 5).heading.empty());
  CHECK((!contains(page(), "id=\"numbers\"") && !contains(page(), "Step by step")));
  Quantity q;
  q.what = Measure::kPeakPressure, q.zone = 1, q.value = 3;
  c.steps[0].quantities = {q};
  CHECK(key_table(c, 1, 5).rows.size() == 1);
  CHECK(contains(page(), "<td><a href=\"#term-peak-pressure\">peak pressure</a></td><td>3</td>"));
  CHECK(contains(page(), "<dt id=\"term-peak-pressure\">"));
  CHECK(contains(page(), "Step by step"));
  hand.record.coefficients.resize(2); // no row of a coefficient that never began
  CHECK(times(page(), "class=\"group\"") == 1);
  c2d_step again = C2D_INIT(c2d_step);
  CoefficientRecord& empty = hand.record.coefficients[1];
  keep_corners(empty, again, {Corner()});
  CHECK(empty.steps.empty());
}

TEST_CASE("report: names that are longer than their column") {
  std::string text;
  append_item(text, "a name that is longer than the column it is to stand in", int64_t{7});
  CHECK(text == "  a name that is longer than the column it is to stand in  7\n");
}

TEST_CASE("report: friction that has come to nothing has not turned") {
  Trace trace;
  std::string text;
  const double load = 1;
  double row[C2D_PAIR_FIELDS] = {};
  c2d_step step = C2D_INIT(c2d_step);
  step.kind = C2D_STEP_RECORDED, step.coefficient = 1, step.pairs = 1, step.stride = C2D_PAIR_FIELDS, step.table = row;
  step.cases = 1, step.loads = &load;
  row[C2D_STATUS] = C2D_SLIP;
  for (const double tt : {-1.0, 0.0, 1.0, -1.0}) {
    row[C2D_TT] = tt;
    trace.append(text, step);
  }
  CHECK(test::lines_of(text).size() == 2); // where it begins, and from 1 to -1
  CHECK(contains(text, "slip,slip,slip turned\n"));
}

TEST_CASE("report: a path that ended where a curve of its way was kept has that curve once") {
  Hand hand(4);
  hand.history.begin(4); // of which the second is the last
  for (const int32_t k : {1, 2}) hand.step({0.25 * k}, rows_of(4, {C2D_STICK, 1.0 * k, 0, 0, 0}), k);
  const CoefficientHistory& history = hand.history.coefficients()[0];
  CHECK(history.frames.size() == 2);
  std::vector<double> table = hand.record.coefficients[0].table; // that of the second step
  CHECK(earlier_states(history, 2, table).size() == 1);
  CHECK(earlier_states(history, 9, table).size() == 1); // nor is a curve drawn that equals that of the end
  for (size_t at = C2D_TN; at < table.size(); at += C2D_PAIR_FIELDS) table[at] *= 2;
  CHECK(earlier_states(history, 9, table).size() == 2);
}

TEST_CASE("report: titles in a VTK file are ASCII") {
  Scene scene;
  std::snprintf(scene.summary.title, sizeof scene.summary.title, "%s", "R\xc3\xb6lle \t1");
  std::string text;
  CHECK(append_vtk(text, scene, Interior()) == C2D_OK);
  CHECK(text.compare(0, 39, "# vtk DataFile Version 3.0\nR??lle ?1\nAS") == 0);
}

// ---- scenes of models

namespace {

struct Gathered {
  many::Machine machine;
  RunRecord record;
  History history;
  Scene scene;
  explicit Gathered(const many::Model& model, const char* length = nullptr, const char* force = nullptr) : machine(model) {
    REQUIRE_MESSAGE(machine.status == C2D_OK, std::string(machine.told.empty() ? "" : machine.told[0].text));
    REQUIRE(c2d_set_units(machine.solver, length, force) == C2D_OK);
    REQUIRE(gather_scene(machine.solver, record, history, scene) == C2D_OK);
  }
};

double area_of(const BodyScene& body) {
  double twice = 0;
  for (const std::vector<Point>& curve : outline_of(body, 0))
    for (size_t i = 0; i < curve.size(); ++i) {
      const Point a = curve[i], b = curve[(i + 1) % curve.size()];
      twice += a.x * b.y - b.x * a.y;
    }
  return twice / 2;
}

} // namespace

TEST_CASE("report: outlines of a quarter that ends on one line of symmetry alone, with a hole, are drawn with all images") {
  many::Model model; // 2 < x < 4, 0 < y < 2, a square hole in it; and what ends on the other line
  model.symmetry = 3;
  model.add(many::open_polygon({{4, 0, 3}, {4, 2, 3}, {2, 2, 3}, {2, 0, 0}}));
  many::add_polygon(model.body(1), {{2.5, 0.5, 1}, {2.5, 1.5, 1}, {3.5, 1.5, 1}, {3.5, 0.5, 1}});
  model.body(1).ends.resize(static_cast<size_t>(2 * model.body(1).elements()));
  model.set(1, 1, many::end_of("1001"));
  model.add(many::open_polygon({{0, 3, 2}, {1, 3, 2}, {1, 5, 2}, {0, 5, 0}}));
  model.set(2, 1, many::end_of("0110"));
  const Gathered whole(model);
  const BodyScene& body = whole.scene.bodies[0];
  CHECK(body.curves.size() == 4 + 2); // the holes, and a body on either side of x = 0
  CHECK(area_of(body) == doctest::Approx(2 * 8 - 4));
  for (const Point at : {Point{3.9, -1.9}, Point{-3.9, 1.9}, Point{-2.1, -0.1}}) CHECK(is_inside(outline_of(body, 0), at));
  for (const Point at : {Point{3, -1}, Point{-3, 1}, Point{0, 0}}) CHECK_FALSE(is_inside(outline_of(body, 0), at));
  CHECK(whole.scene.bodies[1].curves.size() == 2);
  CHECK(area_of(whole.scene.bodies[1]) == doctest::Approx(2 * 4));
  CHECK(whole.scene.images.size() == 4);
  CHECK(whole.scene.zone_images.size() == 1);
}

TEST_CASE("report: a contact across a line of symmetry y = 0 is shown with its image") {
  many::Model model;
  model.symmetry = 2;
  model.add(many::open_polygon({{1, 0, 4}, {1, 1, 2}, {0, 1, 2}, {0, 0, 0}}));
  model.add(many::open_polygon({{2, 0, 2}, {2, 1, 2}, {1, 1, 4}, {1, 0, 0}}));
  model.set(1, 3, many::end_of("1001"));
  model.set(2, 1, many::end_of(many::kPulled, -1));
  model.join(C2D_ZONE_MATCHING, 1, 1, 2, 3);
  Gathered half(model, "mm", "N");
  CHECK(half.scene.stress_unit == "N/mm&#178;");
  REQUIRE(half.scene.zone_images.size() == 2);
  CHECK(half.scene.zone_images[1].place({1, 0.5}).y == -0.5);
  CHECK(half.scene.zone_images[1].place({1, 0.5}).x == 1);
  REQUIRE(half.scene.zones.size() == 1);
  const ZoneScene& zone = half.scene.zones[0];
  CHECK((zone.symmetric_origin && zone.has_images));
  CHECK(zone.samples.size() == 2 * zone.pairs - 1);
  CHECK(zone.samples.front().s == doctest::Approx(-1));
  CHECK(std::string(zone.position) == "y");
  // Without a name for length that of stress cannot be made.
  const Gathered nameless(model, nullptr, "N");
  CHECK((nameless.scene.stress_unit.empty() && nameless.scene.length_unit.empty()));
}

TEST_CASE("report: a rigid body that is turned, and nothing more, is a load") {
  many::Model model;
  model.add(many::rectangle(0, 0, 1, 1, {2, 2, 4, 2}));
  model.add(many::rectangle(0, 1, 1, 2, {4, 2, 2, 2}));
  model.set(1, 1, many::end_of(many::kHeld));
  model.body(2).rigid = 1;
  model.body(2).ends.assign(static_cast<size_t>(2 * model.body(2).elements()), many::End());
  model.body(2).motion[2] = 1e-3;
  model.join(C2D_ZONE_MATCHING, 1, 3, 2, 1);
  const Gathered turned(model);
  REQUIRE(turned.scene.motions.size() == 1);
  CHECK((turned.scene.motions[0].rotation == 1e-3 && turned.scene.motions[0].by.x == 0));
  CHECK(turned.scene.bodies[1].rigid);
}

TEST_CASE("report: a straight zone is shown over its coordinate, and begins where one of its bodies is supported") {
  for (const double at : {0.0, 3.0}) {
    CAPTURE(at);
    many::Model model; // side by side, on rollers
    model.add(many::rectangle(0, at, 1, at + 1, {2, 4, 2, 2}));
    model.add(many::rectangle(1, at, 2, at + 1, {2, 2, 2, 4}));
    model.set(1, 1, many::end_of("0110"));
    model.set(2, 1, many::end_of("0110"));
    model.set(1, 4, many::end_of("1001"));
    model.set(2, 2, many::end_of(many::kPulled, -1));
    model.join(C2D_ZONE_MATCHING, 1, 2, 2, 4);
    const Gathered own(model);
    const ZoneScene& zone = own.scene.zones.at(0);
    CHECK(zone.symmetric_origin);
    CHECK(own.scene.pairs[zone.origin].on[0].y == at);
    CHECK(std::string(zone.position) == "y");
    CHECK(own.scene.pairs[zone.origin].s == at);
  }
}

TEST_CASE("report: a contact goes on beyond its end where both bodies slide along a line that rests, and is free of friction") {
  const auto mirrors = [](const many::End& below) {
    many::Model model; // the contact ends a side above the rollers' line: at y = 0, where `below` holds
    for (const double x : {0.0, 1.0}) model.add(many::rectangle(x, 0, x + 1, 1, {2, x < 0.5 ? 4 : 2, 2, x < 0.5 ? 2 : 4}));
    model.join(C2D_ZONE_MATCHING, 1, 2, 2, 4);
    for (const int32_t body : {1, 2}) model.set(body, 1, below);
    model.zones[0].without[0] = 1; // the node on the line is in no pair
    const Gathered own(model);
    std::vector<ZoneLine> lines;
    REQUIRE(find_zone_lines(own.machine.solver, own.scene.summary, lines) == C2D_OK);
    return lines.at(0).end[0].mirror || lines.at(0).end[1].mirror;
  };
  CHECK(mirrors(many::end_of("0110")));
  CHECK_FALSE(mirrors(many::end_of("0110", 0, 0, 0, 0.01))); // it moves
  CHECK_FALSE(mirrors(many::end_of("0110", 0.5)));           // it rubs
  CHECK_FALSE(mirrors(many::end_of(many::kHeld)));
}

TEST_CASE("report: of bodies without contact the first is drawn of two, each of more but those that are rigid") {
  many::Model model;
  for (int i = 0; i < 4; ++i) {
    model.add(many::rectangle(3 * i, 0, 3 * i + 1, 1, {2, 2, 2, 2}));
    model.set(i + 1, 1, many::end_of(many::kHeld));
    model.set(i + 1, 3, many::end_of(many::kPulled, 0, 1));
  }
  const auto drawn = [&] {
    Gathered own(model);
    REQUIRE(own.machine.run().status == C2D_OK);
    Scene scene;
    REQUIRE(gather_scene(own.machine.solver, own.record, own.history, scene) == C2D_OK);
    Pictures out;
    REQUIRE(draw_boundary_stress(scene, out) == C2D_OK);
    std::string names;
    for (const Picture& p : out) names += p.name + " ";
    return names;
  };
  CHECK(drawn() == "boundary_body1 boundary_body2 boundary_body3 boundary_body4 ");
  model.body(2).rigid = 1;
  model.body(2).ends.assign(model.body(2).ends.size(), many::End());
  CHECK(drawn() == "boundary_body1 boundary_body3 boundary_body4 ");
  model.bodies.resize(1), model.bodies.push_back(model.bodies[0]);
  for (size_t i = 0; i < model.bodies[1].xy.size(); i += 2) model.bodies[1].xy[i] += 3;
  CHECK(drawn() == "boundary ");
  Pictures none;
  CHECK(draw_boundary_stress(Scene(), none) == C2D_OK);
  CHECK(none.empty());
}

TEST_CASE("report: of a model that is not complete nothing but numbers is told") {
  many::Model model;
  model.add(many::rectangle(0, 0, 1, 1, {2, 2, 2, 2}));
  model.add(many::rectangle(0, 1, 1, 2, {2, 2, 2, 2}));
  model.join(C2D_ZONE_MATCHING, 1, 3, 2, 1);
  model.body(1).youngs_modulus = -1;
  const many::Machine machine(model);
  REQUIRE(machine.status != C2D_OK);
  Summary s;
  REQUIRE(get_summary(machine.solver, s) == C2D_OK);
  CHECK((s.zone.empty() && s.body_name.empty() && s.zone_name.empty()));
}

// ---- deformed shapes, cracks

TEST_CASE("report: gaps that are magnified are those of the pairs that are known, between two bodies") {
  Hand hand(4);
  for (PairScene& pair : hand.scene.pairs) pair.normal = {0, -1};
  CHECK(GapLift(hand.scene).largest() == 0); // no coefficient
  hand.step({1}, rows_of(4, {C2D_OPEN, 0, 0, 0.5, 0}), 1);
  const std::vector<BodyScene> whole = hand.scene.bodies;
  for (BodyScene& body : hand.scene.bodies) body.curves.clear(); // beside the zone there is nothing
  const GapLift lift(hand.scene);
  CHECK(lift.largest() == 0.5);
  for (const double x : {0.0, 1e-160, 0.5})
    CHECK(lift.at(1, {x, 0}).y == doctest::Approx(-0.5)); // at, beside, and between pairs
  CHECK(lift.at(0, {0, 0}).y == 0);
  hand.scene.bodies = whole;
  hand.record.coefficients[0].table.clear(); // nothing is known
  CHECK(GapLift(hand.scene).at(1, {3, 0}).y == 0);
  hand.scene.zones[0].body[1] = 1; // of one body with itself: it does not move
  CHECK(GapLift(hand.scene).at(0, {1, 0}).y == 0);
  hand.scene.bodies.clear();
  hand.scene.zones.clear(), hand.scene.pairs.clear();
  CHECK(GapLift(hand.scene).largest() == 0);
}

TEST_CASE("report: bodies that do not move are drawn as they are, along any direction") {
  for (const bool steep : {false, true}) {
    Hand hand(4);
    hand.step({1}, rows_of(4, {C2D_STICK, 0, 0, 0, 0}), 1);
    if (steep)
      for (PairScene& pair : hand.scene.pairs) std::swap(pair.on[0].x, pair.on[0].y), std::swap(pair.on[1].x, pair.on[1].y);
    const Pictures out = hand.draw(draw_deformed);
    REQUIRE(out.size() == 1);
    CHECK(contains(out[0].caption, "to scale: the largest displacement is 0 at (0, 0) of body 1."));
  }
}

TEST_CASE("report: the tip of a crack whose faces have no pairs has no intensity") {
  CrackTip tip;
  tip.zone = 2;
  const StressIntensity none = stress_intensity(tip, nullptr, C2D_PAIR_FIELDS);
  CHECK((std::isnan(none.K1) && std::isnan(none.K2) && none.zone == 2));
  tip.why = "one of the bodies is rigid", tip.faces = {{0, 1.0}};
  CHECK(stress_intensity(tip, nullptr, C2D_PAIR_FIELDS).why == "one of the bodies is rigid");
}

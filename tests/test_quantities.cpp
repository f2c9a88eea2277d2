// The numbers that sum up a contact: edges and borders between nodes, peaks, resultants, intensities; where they are written.
#include "json.hpp"
#include "post/edges.hpp"
#include "quantity_runs.hpp"
#include "report/csv.hpp"
#include "report/listing/listing.hpp"
#include "shell.hpp"

#include <algorithm>
#include <cmath>
#include <string>

using namespace quantities_test;

namespace {

// ---- lines by hand
ZoneLine line_of(const std::vector<double>& s, bool round = false, double length = 0) {
  ZoneLine line;
  line.zone = 1, line.round = round, line.s = s, line.length = length > 0 ? length : s.back();
  line.end[1].s = line.length;
  for (size_t i = 0; i < s.size(); ++i) line.pair.push_back(static_cast<int32_t>(i)), line.corner.push_back(0);
  line.weight.assign(s.size(), line.length / static_cast<double>(s.size()));
  return line;
}
std::vector<double> steps(size_t count, double h = 1) {
  std::vector<double> out;
  for (size_t i = 0; i < count; ++i) out.push_back(h * static_cast<double>(i));
  return out;
}
// A contact from a to b on it, with a gap of (3/2) power beyond and a pressure of (1/2) power inside.
LineState state_of(const ZoneLine& line, double a, double b) {
  LineState state{line, {}, {}, {}, {}, {}, {}, {}};
  for (double s : line.s) {
    if (line.round && s < a - (line.length - (b - a)) / 2) s += line.length;
    const bool in = s >= a && s <= b;
    const double beyond = in ? 0 : std::min(std::fabs(s - a), std::fabs(s - b));
    state.status.push_back(in ? C2D_SLIP : C2D_OPEN);
    state.tn.push_back(in ? std::sqrt((s - a) * (b - s)) : 0);
    state.gap.push_back(std::pow(beyond, 1.5));
    state.tt.push_back(0), state.slip.push_back(0);
  }
  return state;
}

} // namespace

TEST_CASE("quantities: a gap of the power 3/2 gives the edge exactly, wherever it lies, in both directions") {
  for (int i = 0; i < 10; ++i) {
    const double a = 10.05 + 0.1 * i, b = 25.31 + 0.07 * i;
    const ZoneLine line = line_of(steps(40));
    const std::vector<ContactEdge> edges = find_contact_edges(state_of(line, a, b));
    REQUIRE(edges.size() == 2);
    CHECK(std::fabs(edges[0].s - a) < 1e-12 * 40);
    CHECK(std::fabs(edges[1].s - b) < 1e-12 * 40);
    CHECK(edges[0].direction == -1);
    CHECK(edges[1].direction == 1);
  }
}

TEST_CASE("quantities: where unlike bodies slide the gap has another power, by the friction towards the open side") {
  // A rigid body over an elastic one with nu 0: beta 1/2. Friction 0.8 of the pressure on body 2 along t, which runs with s or
  // against it; on body 1 the other way, so that it yields towards that side (Bufler).
  const double kBeta = 0.5, kFriction = 0.8, shift = std::atan(kBeta * kFriction) / kPi, a = 10.3, b = 25.6;
  for (const int with : {-1, 1}) {
    ZoneLine line = line_of(steps(40));
    line.x = line.s, line.y.assign(line.size(), 0), line.beta = kBeta;
    LineState state = state_of(line, a, b);
    for (size_t i = 0; i < line.size(); ++i) {
      state.nx.push_back(0), state.ny.push_back(with); // t = (ny, -nx)
      state.tt[i] = kFriction * state.tn[i];
      const double s = line.s[i], to_right = 1.5 - with * shift, to_left = 1.5 + with * shift;
      if (s > b) state.gap[i] = std::pow(s - b, to_right);
      if (s < a) state.gap[i] = std::pow(a - s, to_left);
    }
    const std::vector<ContactEdge> edges = find_contact_edges(state);
    REQUIRE(edges.size() == 2);
    CHECK(edges[0].s == doctest::Approx(a).epsilon(1e-10));
    CHECK(edges[1].s == doctest::Approx(b).epsilon(1e-10));
  }
}

TEST_CASE("quantities: slip is largest at an edge, between nodes") {
  const double a = 10.3, b = 25.6;
  const ZoneLine line = line_of(steps(40));
  LineState state = state_of(line, a, b);
  std::vector<double> table;
  for (size_t i = 0; i < line.size(); ++i) {
    std::vector<double> row(C2D_PAIR_FIELDS, 0.0);
    row[C2D_STATUS] = state.status[i], row[C2D_TN] = state.tn[i], row[C2D_GAP] = state.gap[i];
    row[C2D_SLIP_SUM] = 0.01 * (line.s[i] - 15);
    table.insert(table.end(), row.begin(), row.end());
  }
  const Quantity slip = Run::all(quantities_of({line}, table.data(), C2D_PAIR_FIELDS, {}, 0), Measure::kSlipRange).at(0);
  CHECK(slip.value == doctest::Approx(0.01 * (b - 15)));
  CHECK(slip.doubt < 1e-12);
  CHECK(slip.s == doctest::Approx(b));
}

TEST_CASE("quantities: slip that is largest within the contact is that between nodes, in doubt by what its node stands out") {
  const ZoneLine line = line_of(steps(40));
  LineState state = state_of(line, 2.3, 37.6);
  for (const double sign : {1.0, -1.0}) {
    std::vector<double> table;
    for (size_t i = 0; i < line.size(); ++i) {
      std::vector<double> row(C2D_PAIR_FIELDS, 0.0);
      row[C2D_STATUS] = state.status[i], row[C2D_TN] = state.tn[i], row[C2D_GAP] = state.gap[i];
      row[C2D_SLIP_SUM] = sign * (1 - 0.002 * (line.s[i] - 15.3) * (line.s[i] - 15.3));
      table.insert(table.end(), row.begin(), row.end());
    }
    const Quantity slip = Run::all(quantities_of({line}, table.data(), C2D_PAIR_FIELDS, {}, 0), Measure::kSlipRange).at(0);
    CHECK(slip.value == doctest::Approx(1).epsilon(1e-12));
    CHECK(slip.s == doctest::Approx(15.3));
    CHECK(slip.doubt == doctest::Approx(0.5 * 0.002));
  }
}

TEST_CASE("quantities: few open pairs beyond an edge") {
  const double b = 20.3;
  for (size_t open = 1; open <= 6; ++open) {
    const ZoneLine line = line_of(steps(21 + open));
    const std::vector<ContactEdge> edges = find_contact_edges(state_of(line, 5.5, b));
    REQUIRE(edges.size() == 2);
    CHECK(edges[1].s == doctest::Approx(open == 1 ? 20.5 : b).epsilon(1e-12)); // one pair: the middle
  }
  const ZoneLine none = line_of(steps(21)); // closed up to the end of the zone: no edge there
  CHECK(find_contact_edges(state_of(none, 5.5, b)).size() == 1);
}

TEST_CASE("quantities: stretches near each other share the open pairs between them") {
  for (size_t open = 1; open <= 12; ++open) {
    const double b = 9.4, c = b + static_cast<double>(open) + 0.2; // open pairs 10 ... 9 + open
    const ZoneLine line = line_of(steps(30 + open));
    LineState state = state_of(line, -100, b);
    const LineState other = state_of(line, c, 1000);
    for (size_t i = 0; i < line.size(); ++i) {
      if (other.status[i] != C2D_OPEN) state.status[i] = C2D_SLIP;
      state.gap[i] = std::min(state.gap[i], other.gap[i]);
    }
    const std::vector<ContactEdge> edges = find_contact_edges(state);
    REQUIRE(edges.size() == 2);
    CHECK(std::fabs(edges[0].s - b) < (open < 3 ? 0.5 : 1e-9));
    CHECK(std::fabs(edges[1].s - c) < (open < 3 ? 0.5 : 1e-9));
  }
}

TEST_CASE("quantities: round a closed side") {
  const size_t n = 60;
  for (const double a : {-7.3, -0.4, 20.6, 42.5, 48.2}) { // before, at, away from and across the place where lengths begin
    ZoneLine line = line_of(steps(n), true, static_cast<double>(n));
    const double b = a + 17.45;
    LineState state = state_of(line, a < 0 ? a + 60 : a, a < 0 ? b + 60 : b);
    const std::vector<ContactEdge> edges = find_contact_edges(state);
    REQUIRE(edges.size() == 2);
    double length = 0;
    for (const ContactEdge& e : edges) length += e.direction * e.s;
    CHECK(std::remainder(length - 17.45, 60.0) == doctest::Approx(0).epsilon(1e-9));
    for (const ContactEdge& e : edges)
      CHECK(std::remainder(e.s - (e.direction < 0 ? a : b), 60.0) == doctest::Approx(0).epsilon(1e-9));
    std::vector<double> table;
    for (size_t i = 0; i < n; ++i) {
      std::vector<double> row(C2D_PAIR_FIELDS, 0.0);
      row[C2D_STATUS] = state.status[i], row[C2D_TN] = state.tn[i], row[C2D_GAP] = state.gap[i];
      table.insert(table.end(), row.begin(), row.end());
    }
    const std::vector<Quantity> all = quantities_of({line}, table.data(), C2D_PAIR_FIELDS, {C2D_INIT(c2d_zone_state)}, 0);
    double force = 0;
    for (const double p : state.tn) force += p;
    CHECK(Run::all(all, Measure::kMeanPressure).at(0).value == doctest::Approx(force / 17.45).epsilon(1e-9));
    for (const Quantity& q : Run::all(all, Measure::kContactEdge)) CHECK((q.value >= 0 && q.value < 60));
  }
  const ZoneLine whole = line_of(steps(n), true, 60);
  CHECK(find_contact_edges(state_of(whole, -1000, 1000)).empty()); // all of it touches
}

TEST_CASE("quantities: round a closed side the peak is where its parabola has it; none of equal pressures, nor of two pairs") {
  const auto quantities = [](const ZoneLine& line, const std::vector<double>& tn) {
    std::vector<double> table(line.size() * C2D_PAIR_FIELDS, 0.0);
    for (size_t i = 0; i < tn.size(); ++i)
      table[i * C2D_PAIR_FIELDS + C2D_STATUS] = tn[i] > 0 ? C2D_SLIP : C2D_OPEN, table[i * C2D_PAIR_FIELDS + C2D_TN] = tn[i];
    return quantities_of({line}, table.data(), C2D_PAIR_FIELDS, {}, 0);
  };
  const auto peak = [&](const ZoneLine& line, const std::vector<double>& tn) {
    return Run::all(quantities(line, tn), Measure::kPeakPressure).at(0);
  };
  const ZoneLine line = line_of(steps(12), true, 12);
  for (const double top : {0.3, 5.4, 11.3, 11.8}) {
    std::vector<double> tn;
    for (const double s : line.s) tn.push_back(50 - std::pow(std::remainder(s - top, 12.0), 2));
    CHECK(peak(line, tn).value == doctest::Approx(50));
    CHECK(peak(line, tn).s == doctest::Approx(top));
  }
  CHECK(peak(line, std::vector<double>(12, 5.0)).value == 5);
  const ZoneLine two = line_of(steps(2, 6), true, 12);
  CHECK(peak(two, {1, 3}).value == 3);
  CHECK(peak(two, {1, 3}).s == 6);
  // One pair alone: its edges lie half way to those beside it. Without states of the zones there are no forces.
  std::vector<double> one(12, 0.0);
  one[4] = 1;
  const std::vector<Quantity> all = quantities(line, one);
  CHECK(Run::all(all, Measure::kContactEdge).size() == 2);
  CHECK(Run::all(all, Measure::kForceX).empty());
  CHECK(std::string(name_of(static_cast<Measure>(99))).empty());
}

TEST_CASE("quantities: a place that is 0 but for round-off is told as 0, in the body and along a side, a closed one too") {
  for (const bool round : {false, true})
    for (const double off : {3e-10, -3e-10, 3e-7}) { // of a length of 12
      ZoneLine line = line_of(steps(12), round, 12);
      for (double& s : line.s) s += off;
      ElementCurve side;
      side.count = 2, side.x[1] = 12, side.y[1] = 12e-12;
      line.pieces.push_back({0, true, side});
      std::vector<double> table(line.size() * C2D_PAIR_FIELDS, 0.0);
      table[C2D_STATUS] = C2D_SLIP, table[C2D_TN] = 1;
      const std::vector<Quantity> all = quantities_of({line}, table.data(), C2D_PAIR_FIELDS, {}, 0);
      const Quantity peak = Run::all(all, Measure::kPeakPressure).at(0);
      const double told = std::fabs(off) < 1e-9 ? 0 : off;
      CHECK(peak.s == told);
      if (!round || off > 0) CHECK(peak.at[0] == doctest::Approx(told)); // (of this side the end is elsewhere)
      if (!round || off > 0) CHECK((peak.at[0] == 0) == (told == 0));
      CHECK(peak.at[1] == 0);
    }
}

TEST_CASE("quantities: one pair that sticks amid slip, round a closed side; a contact up to a corner that ends its side") {
  const ZoneLine line = line_of(steps(12), true, 12);
  LineState state = state_of(line, -1000, 1000);
  for (size_t i = 0; i < 12; ++i) state.slip[i] = 0.1 * std::pow(std::fabs(std::remainder(line.s[i] - 4, 12.0)), 1.5);
  state.status[4] = C2D_STICK;
  const std::vector<double> borders = find_stick_borders(state);
  REQUIRE(borders.size() == 2);
  CHECK(borders[0] == doctest::Approx(4));
  CHECK(borders[1] == doctest::Approx(4));
  ZoneLine ended = line_of(steps(12));
  ended.end[1].corner = true, ended.end[1].s = 11.5;
  std::vector<double> table(12 * C2D_PAIR_FIELDS, 0.0);
  for (size_t i = 6; i < 12; ++i) table[i * C2D_PAIR_FIELDS + C2D_STATUS] = C2D_STICK, table[i * C2D_PAIR_FIELDS + C2D_TN] = 1;
  const std::vector<Quantity> all = quantities_of({ended}, table.data(), C2D_PAIR_FIELDS, {}, 0);
  const std::vector<Quantity> edges = Run::all(all, Measure::kContactEdge);
  REQUIRE(edges.size() == 2);
  CHECK(edges[1].value == 11.5);
  const double force = 6 * ended.weight[0]; // over what lies between the edges
  CHECK(Run::all(all, Measure::kMeanPressure).at(0).value == doctest::Approx(force / (11.5 - edges[0].value)));
}

TEST_CASE("quantities: Hertz, wherever the edge lies in its element, linear and quadratic functions") {
  const double p0 = 1000 / (2 * 0.91) / 200, P = kPi * p0 / 2;
  for (const char* order : {"order=1", "order=2"})
    for (int i = 0; i < 8; ++i) {
      CAPTURE(std::string(order));
      const Run run = make("hertz", {order, "n=20", number("edge", 0.02 + i / 8.0)});
      CHECK(std::fabs(run.one(Measure::kContactEdge).at[0] - 1) < 1e-3);       // measured 6.4e-4 and 9.0e-4
      CHECK(std::fabs(run.one(Measure::kPeakPressure).value / p0 - 1) < 5e-4); // measured 3.3e-4
      CHECK(run.one(Measure::kPeakPressure).at[0] == 0.0);                     // on the line of symmetry, without round-off
      CHECK(std::fabs(run.one(Measure::kMeanPressure).value / (P / 2) - 1) < 1.2e-3);             // as the edge
      CHECK(std::fabs(run.one(Measure::kEdgePressure).value / (p0 * std::sqrt(2.0)) - 1) < 6e-3); // measured 0.13 %, 0.5 %
      CHECK(run.one(Measure::kForceY).value == doctest::Approx(P / 2).epsilon(1e-3)); // of the half that is modelled
      CHECK(run.all(Measure::kStickBorder).empty());
    }
}

TEST_CASE("quantities: Cattaneo and Mindlin, stick borders while the load goes to and fro") {
  const Run run = make("mindlin");
  const double P = run.one(Measure::kForceY).value, mu = 0.3;
  const std::vector<StepRecord>& steps = run.record.steps;
  int compared = 0;
  double turned = 0, before = 0; // tangential force where it last turned, and a step ago
  for (size_t i = 1; i < steps.size(); ++i) {
    const double q = Run::all(steps[i].quantities, Measure::kForceX).at(0).value / (mu * P);
    if (i > 1 && (q - before) * (before - turned) < 0) turned = before;
    const double part = std::fabs(turned) > 1e-6 ? std::fabs(q - turned) / 2 : std::fabs(q);
    before = q;
    const std::vector<Quantity> borders = Run::all(steps[i].quantities, Measure::kStickBorder);
    const int32_t slipping = steps[i].zones.at(0).slip / 2; // pairs, on either side
    if (borders.size() != 2 || slipping < 2) continue;      // one: the border is set between it and the pair that sticks
    const double middle = (borders[0].at[0] + borders[1].at[0]) / 2, c = std::fabs(borders[0].at[0] - borders[1].at[0]) / 2;
    CHECK(std::fabs(c - std::sqrt(1 - part)) < (slipping < 3 ? 8e-3 : 5e-3)); // 7.5e-3; 4.2e-3, and 1e-3 where 5 do
    CHECK(std::fabs(middle) < 5e-3);
    ++compared;
  }
  CHECK(compared >= 14);
  for (const Quantity& edge : run.all(Measure::kContactEdge)) CHECK(std::fabs(std::fabs(edge.at[0]) - 1) < 3e-3); // it shifts
}

TEST_CASE("quantities: Spence's cylinder, where stick advances over what has slipped") {
  const double a = 0.9728971709260842, c = 0.864481667647117 * a;
  for (const char* edge : {"edge=0.1", "edge=0.5", "edge=0.9"}) {
    const Run run = make("cylinder_friction", {edge});
    CHECK(std::fabs(run.one(Measure::kContactEdge).at[0] - a) < 2.5e-3); // measured 1.5e-3
    CHECK(std::fabs(run.one(Measure::kStickBorder).at[0] - c) < 4e-3);   // measured 3e-3: 0.12 of an element
    CHECK(run.all(Measure::kEdgeFriction).empty());                      // slips there
  }
}

TEST_CASE("quantities: at a corner contact ends at the corner; Spence's punch") {
  const Run run = make("punch");
  const Quantity edge = run.one(Measure::kContactEdge);
  CHECK(std::fabs(edge.at[0] - 1) < 1e-12);
  CHECK(run.all(Measure::kEdgePressure).empty());
  CHECK(run.one(Measure::kMeanPressure).value == doctest::Approx(0.5).epsilon(1e-6));
  CHECK(std::fabs(run.one(Measure::kStickBorder).at[0] - 0.7) < 2e-3); // measured 7e-4
}

TEST_CASE("quantities: Turner's punch, three borders of stick and slip after unloading") {
  const families_test::Table zones = families_test::reference("p05_zone_boundaries");
  const std::vector<Quantity> found = make("punch", {"unload=0.45"}).all(Measure::kStickBorder);
  REQUIRE(found.size() == 3);
  for (const std::vector<double>& z : zones) {
    if (std::fabs(z[0] - 0.45) > 1e-9) continue;
    const double x[] = {z[1], z[2], 1 - z[3]};
    double off[3];
    for (size_t i = 0; i < 3; ++i) {
      off[i] = 1;
      for (const Quantity& q : found) off[i] = std::min(off[i], std::fabs(q.at[0] - x[i]));
    }
    CHECK(off[0] < 2e-3); // measured 1.0e-3
    CHECK(off[1] < 4e-3); // measured 2.1e-3
    CHECK(off[2] < 1e-4); // measured 3e-5: elements are small at the corner
  }
}

TEST_CASE("quantities: a layer that lifts between two stretches of contact") {
  CHECK(std::fabs(make("layer_lifted").all(Measure::kContactEdge).at(1).at[0] - 0.9518250994943219) < 1e-3); // 1.6e-4
  CHECK(std::fabs(make("layer_lifted", {"lambda=4"}).all(Measure::kContactEdge).at(1).at[0] - 2.392934771522195) <
        2e-3); // 7e-4
}

TEST_CASE("quantities: receding layer and disc in a hole") {
  CHECK(std::fabs(make("receding_layer").one(Measure::kContactEdge).at[0] - 1.3241653718676933) < 1.5e-3);
  const Quantity edge = make("disc_in_hole").one(Measure::kContactEdge);
  CHECK(std::fabs(std::atan2(edge.at[0], edge.at[1]) * 180 / kPi - 19.625) < 0.06); // an element is 1.5 degrees
  CHECK(std::hypot(edge.at[0], edge.at[1]) == doctest::Approx(1).epsilon(1e-3));
}

TEST_CASE("quantities: lengths along a curved side") {
  // Pairs on the quarter of a circle: lengths are those of arcs, for every order of the geometry that the families use.
  for (const char* order : {"order=1", "order=2", "order=3"}) {
    const Run run = make("disc_in_hole", {order});
    const ZoneLine& line = run.lines.at(0);
    CHECK(line.length == doctest::Approx(kPi / 2).epsilon(2e-4));
    for (size_t i = 0; i < line.size(); ++i) {
      const double angle = std::fabs(std::atan2(line.y[i], line.x[i]) - std::atan2(line.y[0], line.x[0]));
      CHECK(std::fabs(line.s[i] - angle) < 3e-4);
      double at[2];
      line.place(line.s[i], at);
      CHECK(std::hypot(at[0] - line.x[i], at[1] - line.y[i]) < 1e-12);
    }
    double sum = 0;
    for (const double w : line.weight) sum += w;
    CHECK(sum == doctest::Approx(line.length).epsilon(1e-12));
  }
}

TEST_CASE("quantities: friction of a contact that sticks up to its edge") {
  std::string deck, error;
  REQUIRE(families::make_deck("mindlin", {"n=20", "steps=1", "Q=0.9", "move=0.0005"}, deck, error));
  const std::string card = "! coefficients of friction\n1 0.3\n";
  REQUIRE(deck.find(card) != std::string::npos);
  deck.replace(deck.find(card), card.size(), "1 1E6\n");
  many::Machine machine(deck);
  const Run run = follow(machine);
  const std::vector<Quantity> K = Run::all(run.record.steps.at(1).quantities, Measure::kEdgeFriction);
  const double Q = Run::all(run.record.steps.at(1).quantities, Measure::kForceX).at(0).value;
  REQUIRE(K.size() == 2);
  for (const Quantity& k : K) CHECK(k.value == doctest::Approx(Q / (kPi * std::sqrt(2.0))).epsilon(0.03)); // measured 1.9 %
  CHECK(Run::all(run.record.steps.at(0).quantities, Measure::kEdgeFriction).empty());                      // no friction yet
}

TEST_CASE("quantities: ties have forces alone, zones that do not touch what they have dissipated, too") {
  const Run run = make("bimaterial");
  CHECK(run.all(Measure::kForceX).size() == 1);
  for (const Measure what : {Measure::kPeakPressure, Measure::kMeanPressure, Measure::kContactEdge, Measure::kApproach})
    CHECK(run.all(what).empty());
  const ZoneLine line = line_of(steps(8));
  std::vector<double> table(8 * C2D_PAIR_FIELDS, 0.0); // all open
  c2d_zone_state state = C2D_INIT(c2d_zone_state);
  CHECK(quantities_of({line}, table.data(), C2D_PAIR_FIELDS, {state}, 0).size() == 5); // and what is dissipated, twice
  CHECK(quantities_of({}, nullptr, C2D_PAIR_FIELDS, {}, 0).empty());                   // no contact in the model
}

TEST_CASE("quantities: the vertex of a parabola is nearer to the peak than the highest node") {
  // Flat punch with rounded edges, b/a = 0.8: the pressure in closed form, its peak 0.95830251 at 0.859303.
  const double f0 = std::asin(0.8), factor = 2 / (kPi * (kPi - 2 * f0 - std::sin(2 * f0)));
  const auto pressure = [&](double x) {
    const double f = std::asin(x);
    return factor * ((kPi - 2 * f0) * std::cos(f) + std::sin(f) * std::log(std::fabs(std::sin(f + f0) / std::sin(f - f0))) +
                     std::sin(f0) * std::log(std::fabs(std::tan((f + f0) / 2) * std::tan((f - f0) / 2))));
  };
  double worst_node = 0, worst = 0, worst_place = 0;
  for (int i = 0; i < 10; ++i) {
    const double h = 0.02, shift = h * (i + 0.3) / 10;
    std::vector<double> s, table;
    for (int k = 0; k < 50 && shift + k * h < 1; ++k) {
      s.push_back(k * h);
      std::vector<double> row(C2D_PAIR_FIELDS, 0.0);
      row[C2D_STATUS] = C2D_SLIP, row[C2D_TN] = pressure(shift + k * h);
      table.insert(table.end(), row.begin(), row.end());
    }
    ZoneLine line = line_of(s);
    line.pieces.resize(1); // a straight side
    line.pieces[0].up = true, line.pieces[0].s = 0;
    line.pieces[0].curve.count = 2, line.pieces[0].curve.x[0] = shift, line.pieces[0].curve.x[1] = shift + line.length;
    double highest = 0;
    for (size_t k = 0; k < s.size(); ++k) highest = std::max(highest, table[k * C2D_PAIR_FIELDS + C2D_TN]);
    const Quantity peak =
        Run::all(quantities_of({line}, table.data(), C2D_PAIR_FIELDS, {C2D_INIT(c2d_zone_state)}, 0), Measure::kPeakPressure)
            .at(0);
    worst_node = std::max(worst_node, std::fabs(highest / 0.95830251 - 1));
    worst = std::max(worst, std::fabs(peak.value / 0.95830251 - 1));
    worst_place = std::max(worst_place, std::fabs(peak.at[0] - 0.859303));
  }
  CHECK(worst < 0.3 * worst_node); // measured 2.7e-4 against 2.5e-3
  CHECK(worst_place < 0.1 * 0.02); // measured 4e-4
}

// ---- where they are written
namespace {

std::vector<std::string> fields_of(const std::string& row) {
  std::vector<std::string> out(1);
  bool quoted = false;
  for (const char c : row) {
    if (c == '"') quoted = !quoted;
    if (c == ',' && !quoted)
      out.emplace_back();
    else if (c != '"')
      out.back() += c;
  }
  return out;
}

} // namespace

TEST_CASE("quantities: listing, JSON and summary table of the program tell the same") {
  const test::Folder folder;
  const std::string deck = folder / "deck.dat", program = "'" + paths::program() + "' ";
  REQUIRE(test::run_shell(program + "make mindlin n=10 > '" + deck + "'").status == 0);
  std::string text = test::read_file(deck);
  const std::string name = "*NAME ZONE 1 zone on zone1\n";
  REQUIRE(test::contains(text, name));
  text.replace(text.find(name), name.size(), "*NAME ZONE 1 pad, left\n");
  test::write_file(deck, text);
  const test::Result run = test::run_shell(program + "run '" + deck + "' --listing '" + (folder / "l") + "' --json '" +
                                           (folder / "j") + "' --summary '" + (folder / "s") + "'");
  REQUIRE_MESSAGE(run.status == 0, run.err);
  const test::Json json = test::JsonReader::read(test::read_file(folder / "j"));
  const std::vector<std::string> rows = test::lines_of(test::read_file(folder / "s"));
  CHECK(rows.at(0) ==
        "mu,step,load,zone,name,quantity,item,value,x,y,error,s,along,load2,plane_angle,worst_case,root_of_squares");
  size_t row = 1;
  std::vector<std::pair<double, double>> peaks;
  for (const test::Json& step : json["steps_detail"].items)
    for (const test::Json& q : step["quantities"].items) {
      const std::vector<std::string> f = fields_of(rows.at(row++));
      REQUIRE(f.size() == 17);
      CHECK(std::stod(f[13]) == step["loads"][1].number);
      CHECK(std::stod(f[1]) == step["step"].number);
      CHECK(f[3] == std::to_string(static_cast<int>(q["zone"].number)));
      CHECK(f[4] == (f[3] == "1" ? "pad, left" : ""));
      CHECK(f[5] == q["quantity"].text);
      CHECK(f[6] == std::to_string(static_cast<int>(q["item"].number)));
      CHECK(std::stod(f[7]) == q["value"].number);
      CHECK(f[8].empty() == !q.has("x"));
      if (q.has("y")) CHECK(std::stod(f[9]) == q["y"].number);
      CHECK(f[10].empty());
      CHECK(!q.has("error"));
      CHECK(f[11].empty() == !q.has("s"));
      if (q.has("s")) CHECK((std::stod(f[11]) == q["s"].number && std::stod(f[12]) == q["along"].number));
      if (f[5] == "contact edge" || f[5] == "stick border") CHECK(std::stod(f[11]) == std::stod(f[7]));
      if (f[5] == "peak pressure") // side 2 is flat, and s grows as x or against it
        peaks.emplace_back(q["x"].number, q["s"].number);
    }
  REQUIRE(peaks.size() > 1);
  for (const auto& [x, s] : peaks) {
    CHECK(s >= 0);
    CHECK(std::fabs(s - peaks[0].second) == doctest::Approx(std::fabs(x - peaks[0].first)));
  }
  CHECK(row == rows.size());
  const test::Json& last = json["runs"][0]["quantities"];
  CHECK(last.items.size() == json["steps_detail"].items.back()["quantities"].items.size());
  const std::string listing = test::read_file(folder / "l");
  CHECK(test::contains(listing, "Contact in numbers"));
  for (const test::Json& q : last.items) CHECK(test::contains(listing, q["quantity"].text));
  CHECK(!test::contains(listing, "+-"));
  REQUIRE(test::run_shell(program + "run '" + deck + "' --listing /dev/null --report '" + (folder / "r") + "'").status == 0);
  const std::string page = test::read_file(folder / "r");
  for (const test::Json& q : last.items) CHECK(test::contains(page, ">" + q["quantity"].text + "</a>"));
}

TEST_CASE("quantities: stated errors go to the first coefficient's last step, and are shown") {
  RunRecord record;
  record.coefficients.resize(2);
  for (CoefficientRecord& c : record.coefficients) {
    c.steps.resize(2);
    for (StepRecord& step : c.steps) {
      step.loads = {1};
      for (const int32_t item : {1, 2}) {
        Quantity q;
        q.what = Measure::kContactEdge, q.zone = 1, q.item = item, q.value = 2.5, q.at[0] = q.at[1] = item, q.s = 2.5;
        step.quantities.push_back(q);
      }
    }
  }
  Stated stated;
  stated.what = Measure::kContactEdge, stated.zone = 1, stated.item = 2, stated.error = 0.0125;
  record.meshes.stated = {stated};
  stated.zone = 7; // there is none
  record.meshes.stated.push_back(stated);
  record.take_stated_errors();
  for (size_t c = 0; c < 2; ++c)
    for (size_t step = 0; step < 2; ++step)
      for (size_t i = 0; i < 2; ++i) {
        const double error = record.coefficients[c].steps[step].quantities[i].error;
        CHECK(std::isfinite(error) == (c == 0 && step == 1 && i == 1));
      }
  Summary summary;
  summary.pairs = 5;
  summary.zone_name = {"a"};
  std::string listing, table;
  append_quantities(listing, record, summary);
  CHECK(test::contains(listing, "2.5  +- 0.013"));
  append_summary(table, record, summary);
  CHECK(test::contains(table, ",1,a,contact edge,2,2.5,2,2,0.0125,2.5,,,,\n"));
  RunRecord empty;
  empty.take_stated_errors(); // nothing to state of nothing
  CHECK(empty.coefficients.empty());
}

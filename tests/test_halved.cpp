// The halved deck: the same problem with every element cut in two, against closed forms and meshes made otherwise.
#include "family_runs.hpp"
#include "program/estimate/mesh/cut_body.hpp"
#include "program/estimate/mesh/halved.hpp"
#include "shell.hpp"

#include <doctest/doctest.h>
#include <filesystem>
#include <memory>

namespace {

using families_test::Solution;

const double kPi = std::acos(-1.0);

// A deck's model in a solver that solves nothing.
struct Model {
  runs::Deck deck;
  host::Limits limits;
  std::unique_ptr<runs::Machine> machine;
  c2d_status status = C2D_ERR_INPUT;
  std::string fault;

  explicit Model(const std::string& text, int32_t symmetry = C2D_SYMMETRY_DECK) {
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) deck.lines.push_back(line);
    limits = deck.limits();
    uint64_t minimum = 0;
    REQUIRE(limits.bodies > 0);
    REQUIRE(c2d_memory_need(&limits, &minimum, nullptr, nullptr) == C2D_OK);
    machine = std::make_unique<runs::Machine>(limits, minimum, nullptr);
    c2d_options options = C2D_INIT(c2d_options);
    options.symmetry = symmetry;
    CHECK(c2d_set_options(machine->solver, &options) == C2D_OK);
    status = runs::read_deck(machine->solver, deck);
    if (status != C2D_OK) fault = runs::error_of(machine->solver).text;
  }
  c2d_solver* solver() const { return machine->solver; }
  c2d_body_result body(int32_t b) const {
    c2d_body_result out = C2D_INIT(c2d_body_result);
    c2d_get_body_result(solver(), b, &out);
    return out;
  }
  std::vector<double> field(int32_t field, int32_t b, int32_t count) const {
    std::vector<double> out(static_cast<size_t>(count));
    CHECK(c2d_get(solver(), field, b, 1, count, out.data(), 1) == C2D_OK);
    return out;
  }
  std::vector<std::pair<double, double>> points(int32_t b) const {
    const std::vector<double> x = field(C2D_NODE_X, b, body(b).points), y = field(C2D_NODE_Y, b, body(b).points);
    std::vector<std::pair<double, double>> out;
    for (size_t i = 0; i < x.size(); ++i) out.emplace_back(x[i], y[i]);
    return out;
  }
  c2d_zone zone(int32_t i) const {
    c2d_zone out = C2D_INIT(c2d_zone);
    CHECK(c2d_get_zone(solver(), i, &out) == C2D_OK);
    return out;
  }
};

std::string halved(const std::string& deck) {
  const Model model(deck);
  INFO(model.fault);
  REQUIRE(model.status == C2D_OK);
  std::string error;
  const std::string out = estimate::halved_deck(model.solver(), deck, error);
  CHECK(error.empty());
  return out;
}

std::string family(const std::string& name, const std::vector<std::string>& settings) {
  std::string deck, error;
  REQUIRE(families::make_deck(name, settings, deck, error));
  return deck;
}

std::string text_of(const std::filesystem::path& name) {
  std::ifstream in(name, std::ios::binary);
  std::ostringstream out;
  out << in.rdbuf();
  return out.str();
}

Solution solved(const std::string& deck) {
  const Solution out = families_test::solve_deck(deck);
  CHECK(out.error == "");
  return out;
}

// A closed polygon as the only body, with conditions on elements' ends.
std::string polygon(const std::vector<std::pair<double, double>>& points, const std::vector<std::string>& conditions = {},
                    const std::string& keywords = "", int nodes = 2) {
  const std::string n = std::to_string(points.size());
  std::ostringstream out;
  out.precision(17);
  out << "*FREE\n1\nPOLYGON\n0 0\n1 0 " << nodes << "\n1 2 " << n << " " << n << "\n1 " << n << "\n1 0\n1 0\n0 0\n";
  for (size_t i = 0; i < points.size(); ++i) out << i + 1 << " " << points[i].first << " " << points[i].second << "\n";
  out << conditions.size() << "\n";
  for (const std::string& text : conditions) out << text << "\n";
  out << "0\n0 0\n1 10\n1 1\n" << keywords;
  return out.str();
}

} // namespace

TEST_CASE("halved: every deck of the examples is complete, runs, and keeps its points") {
  for (const auto& entry : std::filesystem::directory_iterator(paths::root() + "/examples")) {
    if (entry.path().extension() != ".dat") continue;
    CAPTURE(entry.path().filename().string());
    const std::string deck = text_of(entry.path()), fine = halved(deck);
    const Model before(deck), after(fine);
    CHECK(after.fault == "");
    REQUIRE(after.status == C2D_OK);
    for (int32_t b = 1; b <= before.limits.bodies; ++b) {
      CHECK(after.body(b).elements == 2 * before.body(b).elements);
      CHECK(after.body(b).open_regions == before.body(b).open_regions);
      const auto old = before.points(b), all = after.points(b);
      const size_t open = static_cast<size_t>(before.body(b).open_regions);
      REQUIRE(all.size() == 2 * old.size() - open);
      if (open == 0)
        for (size_t i = 0; i < old.size(); ++i) CHECK(all[2 * i] == old[i]); // bit for bit
    }
    c2d_summary one = C2D_INIT(c2d_summary), two = one;
    c2d_get_summary(before.solver(), &one), c2d_get_summary(after.solver(), &two);
    CHECK(one.zones == two.zones);
    CHECK(one.load_cases == two.load_cases);
    CHECK(one.steps == two.steps);
    CHECK(one.coefficients == two.coefficients);
    CHECK(std::string(one.title) == two.title);
    CHECK(std::string(one.unit_length) == two.unit_length);
    solved(fine);
  }
}

TEST_CASE("halved: uniform states stay what they are") {
  for (const char* name : {"stack", "plate_tension"}) {
    CAPTURE(name);
    const bool made = std::string(name) == "stack";
    const std::string deck = made ? family(name, {}) : text_of(paths::root() + "/examples/" + name + ".dat");
    const Solution one = solved(deck), two = solved(halved(deck));
    REQUIRE(one.bodies.size() == two.bodies.size());
    double stress = 0, displacement = 0;
    for (const auto& body : one.bodies)
      for (const auto& e : body) {
        stress = std::max(stress, std::fabs(e.hoop) + std::hypot(e.tx, e.ty));
        displacement = std::max(displacement, std::hypot(e.ux, e.uy));
      }
    const auto& order = Model(deck);
    c2d_summary sizes = C2D_INIT(c2d_summary);
    c2d_get_summary(order.solver(), &sizes);
    const size_t f = static_cast<size_t>(sizes.function_nodes);
    for (size_t b = 0; b < one.bodies.size(); ++b)
      for (size_t i = 0; i < one.bodies[b].size(); ++i) {
        // Of an element its first end is the first of the first half, its last the last of the second.
        const size_t e = i / f, l = i % f;
        if (l != 0 && l != f - 1) continue;
        const auto &p = one.bodies[b][i], &q = two.bodies[b][(2 * e + (l == 0 ? 0 : 1)) * f + l];
        CHECK(std::fabs(p.x - q.x) + std::fabs(p.y - q.y) == 0);
        CHECK(std::hypot(p.ux - q.ux, p.uy - q.uy) <= 1e-9 * displacement);
        CHECK(std::hypot(p.tx - q.tx, p.ty - q.ty) <= 1e-9 * stress);
        CHECK(std::fabs(p.hoop - q.hoop) <= 1e-9 * stress);
      }
  }
}

TEST_CASE("halved: twice, uniform meshes on arcs and lines are those of four times as many elements") {
  for (const std::string order : {"order=1", "order=2", "order=3"}) {
    CAPTURE(order);
    const std::string fine = family("ring", {"n=24", order}), cut = halved(halved(family("ring", {"n=6", order})));
    const Model four(fine), twice(cut);
    const auto a = four.points(1), b = twice.points(1);
    REQUIRE(a.size() == b.size());
    for (size_t i = 0; i < a.size(); ++i) CHECK(std::hypot(a[i].first - b[i].first, a[i].second - b[i].second) < 1e-13);
    // Pressure turns along an arc; between the ends it is what the functions of the long elements make of it.
    if (order == "order=1") continue;
    const Solution one = solved(fine), other = solved(cut);
    double most = 0, size = 0;
    for (size_t i = 0; i < one.ends.size(); ++i) {
      most = std::max(most, std::hypot(one.ends[i].ux - other.ends[i].ux, one.ends[i].uy - other.ends[i].uy));
      size = std::max(size, std::hypot(one.ends[i].ux, one.ends[i].uy));
    }
    CHECK(most < 3e-5 * size);
  }
}

TEST_CASE("halved: contact pressure goes to the truth of the surface, not of the polygon") {
  // Hertz: the highest pressure is 2 P / (pi a), a = 1; half of the load is on the part that is modelled. A single halving
  // moves the edge from the middle of an element to a node, which is worse.
  const auto off = [](const std::string& deck) {
    const Solution s = solved(deck);
    const double p0 = 4 * std::fabs(s.resultants[1].contact[1]) / kPi;
    return std::fabs(families_test::largest_pressure(s.last()) / p0 - 1);
  };
  for (const char* n : {"n=3", "n=5", "n=10"}) {
    CAPTURE(n);
    const std::string deck = family("hertz", {n});
    CHECK(off(halved(halved(deck))) < 0.7 * off(deck));
  }
  // Where the chords are told to be the surface, it goes to that of the polygon: ever higher at its corners.
  std::string polygon = family("hertz", {"n=5"});
  const Model model(polygon);
  const c2d_zone zone = model.zone(1);
  for (const c2d_side& side : {zone.side1, zone.side2})
    for (int32_t e = std::min(side.first_element, side.last_element); e <= std::max(side.first_element, side.last_element); ++e)
      polygon += "*CURVE LINE " + std::to_string(side.body) + " " + std::to_string(e) + " " + std::to_string(e) + "\n";
  CHECK(off(halved(halved(polygon))) > 0.05);
}

TEST_CASE("halved: where new boundary points lie") {
  using P = std::pair<double, double>;
  const auto after = [](const std::string& deck) { return Model(halved(deck)).points(1); };
  const auto near = [](P a, double x, double y) { return std::hypot(a.first - x, a.second - y) < 1e-14; };
  std::vector<P> circle, ellipse;
  for (int i = 0; i < 16; ++i) {
    const double angle = 2 * kPi * i / 16;
    circle.emplace_back(3 + 2 * std::cos(angle), 2 * std::sin(angle) - 1);
    ellipse.emplace_back(2 * std::cos(angle), std::sin(angle));
  }
  const double angle = kPi / 16;
  CHECK(near(after(polygon(circle))[1], 3 + 2 * std::cos(angle), 2 * std::sin(angle) - 1));
  const std::vector<double> x = Model(polygon(circle)).field(C2D_SURFACE_X, 1, 16);
  CHECK(x[0] == doctest::Approx(3 + 2 * std::cos(angle)).epsilon(1e-14)); // what the library takes for the surface there
  CHECK(near(after(polygon(ellipse))[1], (ellipse[0].first + ellipse[1].first) / 2, ellipse[1].second / 2));
  // A card says that the chord is meant, or another circle; a spline is near to the ellipse.
  CHECK(near(after(polygon(circle, {}, "*CURVE LINE 1 1 1\n"))[1], (circle[0].first + circle[1].first) / 2,
             (circle[0].second + circle[1].second) / 2));
  const P lens = after(polygon({{-1, 0}, {0, -0.01}, {1, 0}, {0, 1}}, {}, "*CURVE ARC 1 1 2  0 49.995 50.005\n"))[1];
  CHECK(std::hypot(lens.first, lens.second - 49.995) == doctest::Approx(50.005).epsilon(1e-15));
  double spline[2]; // how far it is from the ellipse, with 16 and 32 points
  for (const int n : {16, 32}) {
    std::vector<P> p;
    for (int i = 0; i < n; ++i) p.emplace_back(2 * std::cos(2 * kPi * i / n), std::sin(2 * kPi * i / n));
    const P q = after(polygon(p, {}, "*CURVE SPLINE 1 1 " + std::to_string(n) + "\n"))[static_cast<size_t>(n / 8 + 1)];
    spline[n / 32] = std::fabs(std::hypot(q.first / 2, q.second) - 1);
  }
  CHECK(spline[0] < 2e-3);
  CHECK(spline[1] < spline[0] / 8); // the fourth order
  CHECK(std::fabs(std::hypot((ellipse[1].first + ellipse[2].first) / 4, (ellipse[1].second + ellipse[2].second) / 2) - 1) >
        0.01);
  // Corners of a square lie on a circle, too; those of an octagon are corners, of a decagon none (METHOD 8.1).
  CHECK(near(after(polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}))[1], 0.5, 0));
  for (const int n : {8, 10}) {
    std::vector<P> p;
    for (int i = 0; i < n; ++i) p.emplace_back(std::cos(2 * kPi * i / n), std::sin(2 * kPi * i / n));
    const P q = after(polygon(p))[1];
    CHECK(std::hypot(q.first, q.second) == doctest::Approx(n == 8 ? std::cos(kPi / 8) : 1).epsilon(1e-14));
  }
}

TEST_CASE("halved: flats between chamfers and arcs stay flat") {
  const auto all_lie_on = [](const std::vector<std::pair<double, double>>& corners, double low, double high, double y) {
    int on = 0;
    for (const auto& [px, py] : Model(halved(polygon(corners))).points(1))
      if (px > low && px < high && std::fabs(py - y) < 0.2) {
        CHECK(py == y);
        ++on;
      }
    return on;
  };
  // The flat's two elements, a chamfer and an element of the slope beside it lie on one circle; then the chamfers' own points.
  const double a = 0.5 + 0.15 * std::sqrt(3), b = a + 0.25, c = b + 0.25, down = 0.25 * std::sqrt(3);
  const std::vector<std::pair<double, double>> foot = {
      {-c, 3},   {-c, 0.15 + 2 * down}, {-b, 0.15 + down},    {-a, 0.15}, {-0.5, 0}, {0, 0}, {0.5, 0},
      {a, 0.15}, {b, 0.15 + down},      {c, 0.15 + 2 * down}, {c, 3},     {0, 3}};
  CHECK(all_lie_on(foot, -0.4, 0.4, 0) == 3);
  const auto points = Model(halved(polygon(foot))).points(1);
  const auto middle = [&](size_t i) {
    const auto &p = foot[i], &q = foot[(i + 1) % foot.size()];
    return std::hypot(points[2 * i + 1].first - (p.first + q.first) / 2, points[2 * i + 1].second - (p.second + q.second) / 2);
  };
  for (size_t i = 0; i < foot.size(); ++i) CHECK(middle(i) < 1e-14);
  // A flat of one element between arcs that it is tangent to: each of its neighbours is as long as the other.
  std::vector<std::pair<double, double>> pad;
  for (int i = 0; i <= 4; ++i) pad.emplace_back(-1 + std::cos(kPi * (1 + i / 8.0)), 1 + std::sin(kPi * (1 + i / 8.0)));
  for (int i = 0; i <= 4; ++i) pad.emplace_back(1 + std::cos(kPi * (1.5 + i / 8.0)), 1 + std::sin(kPi * (1.5 + i / 8.0)));
  pad.emplace_back(2, 3);
  pad.emplace_back(-2, 3);
  const auto rounded = Model(halved(polygon(pad))).points(1);
  CHECK(all_lie_on(pad, -0.9, 0.9, 0) == 1);
  CHECK(std::hypot(rounded[1].first + 1, rounded[1].second - 1) == doctest::Approx(1).epsilon(1e-12)); // the arc's first chord
  CHECK(std::hypot(rounded[7].first + 1, rounded[7].second - 1) == doctest::Approx(1).epsilon(1e-12)); // and its last
}

TEST_CASE("halved: conditions between the ends of an element") {
  const std::vector<std::pair<double, double>> square = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  const std::string deck = polygon(square,
                                   {"1 1 1100 0 0 0.5 0", "1 2 1100 0 0 0.25 0", "2 1 0000 1 0 0.25 0", "2 2 0011 3 -1 0 0",
                                    "3 1 0011 -1 2 0 0", "4 2 0000 0 0 0.5 0"},
                                   "*CASES 2\ncase 2\ncondition 1 2 0  5 7 0 0\ncondition 1 1 1  0 0 0 4\ncondition 1 4 2  0 0 "
                                   "0 4\nload 1 1 1 0 -2\n*PATH\n3 1 0.5\n");
  const Model model(halved(deck));
  INFO(model.fault);
  REQUIRE(model.status == C2D_OK);
  const auto check = [&](int32_t element, int32_t local, int32_t load_case, const char* codes,
                         const std::vector<double>& values) {
    CAPTURE(element);
    CAPTURE(local);
    int32_t found[4];
    double is[4];
    CHECK(c2d_get_condition(model.solver(), 1, element, local, load_case, found, is) == C2D_OK);
    for (size_t i = 0; i < 4; ++i) {
      CHECK(found[i] == codes[i] - '0');
      CHECK(is[i] == values[i]);
    }
  };
  check(1, 1, 1, "1100", {0, 0, 0.5, 0});
  check(1, 2, 1, "1100", {0, 0, 0.375, 0});
  check(2, 1, 1, "1100", {0, 0, 0.375, 0});
  check(2, 2, 1, "1100", {0, 0, 0.25, 0});
  check(3, 1, 1, "0000", {1, 0, 0.25, 0});
  check(3, 2, 1, "0011", {2, -0.5, 0, 0}); // a side with tractions: what is held is its end
  check(4, 1, 1, "0011", {2, -0.5, 0, 0});
  check(5, 2, 1, "0011", {-0.5, 1, 0, 0}); // linear to the end without a card
  check(6, 2, 1, "0011", {0, 0, 0, 0});
  check(7, 2, 1, "0011", {0, 0, 0, 0});
  check(1, 2, 2, "1100", {0, 0, 0, 2});
  check(3, 1, 2, "0000", {5, 7, 0, 0});
  check(3, 2, 2, "0011", {5, 7, 0, 0});
  int32_t body = 0, load_case = 0, increments = 0;
  double xy[2], force[2], load[2];
  CHECK(c2d_get_point_load(model.solver(), 1, &body, &load_case, xy, force) == C2D_OK);
  CHECK((load_case == 2 && xy[0] == 1 && force[1] == -2));
  CHECK(c2d_get_path(model.solver(), 1, &increments, load, 2) == C2D_OK);
  CHECK((increments == 3 && load[0] == 1 && load[1] == 0.5));

  // Quadratic functions: a parabola stays one, and the node inside says what the element's own condition is.
  const Model quadratic(halved(polygon(square,
                                       {"1 1 1100 0 0 0 0", "1 2 1100 0 0 0 0", "1 3 1100 0 0 0 0", "2 1 0000 0 0 0 0",
                                        "2 2 0011 1 0 0 0", "2 3 0011 4 0 0 0", "4 3 0000 0 0 0 0"},
                                       "", 3)));
  REQUIRE(quadratic.status == C2D_OK);
  for (const int32_t l : {1, 2, 3}) {
    int32_t codes[4];
    double values[4];
    CHECK(c2d_get_condition(quadratic.solver(), 1, 3, l, 1, codes, values) == C2D_OK);
    CHECK(values[0] == doctest::Approx((l - 1) * (l - 1) / 4.0).epsilon(1e-15));
    CHECK(codes[2] == (l == 1 ? 0 : 1));
  }
}

namespace {

// Two squares, one on the other, whose numbers go on from body to body. Below, what the zone's cards are.
std::string squares(const std::string& zones, const std::string& keywords, const char* analysis = "0 1", int nodes = 2) {
  const std::string last = std::to_string(nodes);
  const auto side = [&](const std::string& element, const std::string& text) {
    const std::string first = element + " 1 " + text + "\n", rest = "1 " + element + " " + last + " " + text + "\n";
    return nodes == 1 ? "1\n" + first + "0\n" : "2\n" + first + rest + "0\n";
  };
  return std::string("*FREE\n1\nSQUARES\n") + analysis + "\n2 " + (zones.empty() ? "0 " : "1 ") + last +
         "\n1 2 4 4\n1 2 4 4\n1 4\n5 8\n100 0.3\n200 0.2\n1 0.5\n0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n"
         "0 1\n5 0 0\n6 1 0\n7 1 1\n8 0 1\n" +
         side("1", "1100 0 0 0 0") + side("7", "0011 0 -1 0 0") + zones + (zones.empty() ? "0 0\n0 0\n" : "") + "1 10\n4 1\n" +
         keywords;
}
const char kMatching[] = "1 2 2 1\n3 3 5 5\n3 4 6 5\n2 1\n2 1\n";

} // namespace

TEST_CASE("halved: zones of every kind, and numbers that go on from body to body") {
  const Model matching(halved(squares(kMatching, "*NAME ZONE 1 joint\n*UNITS mm N\n")));
  CHECK(matching.fault == "");
  REQUIRE(matching.status == C2D_OK);
  const c2d_zone zone = matching.zone(1);
  CHECK((zone.pairs == 3 && zone.side1.elements == 2));
  CHECK((zone.side1.first_element == 5 && zone.side1.last_element == 6 && zone.side2.first_element == 2 &&
         zone.side2.last_element == 1));
  CHECK((zone.side1.first_node == 5 && zone.side1.last_node == 7 && zone.side2.first_node == 3 && zone.side2.last_node == 1));
  char name[32];
  CHECK(c2d_get_name(matching.solver(), C2D_NAME_ZONE, 1, name) == C2D_OK);
  CHECK(std::string(name) == "joint");
  for (const char* text :
       {"*ZONE 3 3 5 5\n", "*ZONE 3,3,5,5 ! a comment\n", "*zone BODIES 1 2 3 3 5 5\n", "*ZONE 3 3 5 5 1 1 BODIES 1 2\n"}) {
    CAPTURE(text);
    const Model free(halved(squares("", text)));
    CHECK(free.fault == "");
    REQUIRE(free.status == C2D_OK);
    CHECK((free.zone(1).pairs == 3 && free.zone(1).side1.elements == 2 && free.zone(1).side2.elements == 2));
    CHECK(std::min(free.zone(1).side1.first_element, free.zone(1).side1.last_element) == 5);
  }
  const Model tied(halved(squares(kMatching, "*TIE 1\n")));
  CHECK(tied.zone(1).kind == C2D_ZONE_TIED);
  // Round the end of the curve: elements 4 and 1 of body 1 are the left and the lower side.
  std::string pressed = squares(kMatching, "*PLATEN 2 7 7  0.5 2\n1 FY -1\n");
  const std::string loads = "2\n7 1 0011 0 -1 0 0\n1 7 2 0011 0 -1 0 0\n0\n";
  pressed.replace(pressed.find(loads), loads.size(), "0\n0\n");
  const Model platen(halved(pressed));
  CHECK(platen.fault == "");
  REQUIRE(platen.status == C2D_OK);
  CHECK(platen.zone(2).side2.elements + platen.zone(2).side1.elements == 4);
  for (const int order : {1, 3, 4}) { // functional nodes of an element
    CAPTURE(order);
    const int pairs = order == 1 ? 1 : order;
    const std::string count = std::to_string(pairs), first = std::to_string(order == 1 ? 3 : 2 * (order - 1) + 1),
                      last = std::to_string(order == 1 ? 3 : 3 * (order - 1) + 1),
                      from = std::to_string(order == 1 ? 5 : 5 * (order - 1) + 1),
                      to = std::to_string(order == 1 ? 5 : 4 * (order - 1) + 1);
    const Model high(halved(squares("1 2 " + count + " 1\n3 3 5 5\n" + first + " " + last + " " + from + " " + to + "\n" +
                                        count + " 1\n" + count + " 1\n",
                                    "", "0 1", order)));
    CHECK(high.fault == "");
    REQUIRE(high.status == C2D_OK);
    CHECK(high.zone(1).pairs == (order == 1 ? 2 : 2 * order - 1));
  }
}

TEST_CASE("halved: a model by images says the same as one with elements on its lines") {
  const std::string deck = family("hertz", {"symmetry=line", "n=5"});
  const Model images(deck, C2D_SYMMETRY_IMAGES), line(deck);
  std::string error;
  const Model one(estimate::halved_deck(images.solver(), deck, error)), other(halved(deck));
  REQUIRE(one.status == C2D_OK);
  for (int32_t b = 1; b <= 2; ++b) {
    const auto p = one.points(b), q = other.points(b);
    REQUIRE(p.size() == q.size());
    for (size_t i = 0; i < p.size(); ++i) CHECK(std::hypot(p[i].first - q[i].first, p[i].second - q[i].second) < 1e-12);
    for (int32_t e = 1; e <= one.body(b).elements; ++e)
      for (int32_t l = 1; l <= 2; ++l) {
        int32_t a[4], c[4];
        double u[4], v[4];
        CHECK(c2d_get_condition(one.solver(), b, e, l, 1, a, u) == C2D_OK);
        CHECK(c2d_get_condition(other.solver(), b, e, l, 1, c, v) == C2D_OK);
        for (int i = 0; i < 4; ++i) CHECK((a[i] == c[i] && u[i] == v[i]));
      }
  }
}

TEST_CASE("halved: ranges that go round the end of their curve") {
  // A ring of six elements behind a region of two; linear functions.
  estimate::CutBody ring;
  ring.element_nodes = ring.function_nodes = 2;
  ring.regions = {{0, 1, false}, {2, 7, false}};
  ring.in_contact.assign(8, false);
  for (int32_t i = 0; i <= 8; ++i) ring.children.push_back(2 * i);
  using estimate::Range;
  const auto cut = [&](Range elements, int32_t count) {
    const bool up = estimate::goes_up(ring, elements, count);
    const Range range = estimate::cut_elements(ring, elements, up);
    return std::array<int32_t, 4>{up ? 1 : -1, range.first, range.last, estimate::count_cut(ring, elements, up)};
  };
  CHECK(cut({6, 2}, 3) == std::array<int32_t, 4>{1, 12, 5, 6});
  CHECK(cut({2, 6}, 3) == std::array<int32_t, 4>{-1, 5, 12, 6});
  CHECK(cut({3, 5}, 3) == std::array<int32_t, 4>{1, 6, 11, 6});
  CHECK(cut({5, 3}, 0) == std::array<int32_t, 4>{-1, 11, 6, 6});
  CHECK(cut({4, 4}, 1) == std::array<int32_t, 4>{1, 8, 9, 2});
  // Nodes of elements 6, 7, 2 are 6, 7, 2 and 3; without the first, and the last.
  const Range nodes = estimate::cut_nodes(ring, {6, 2}, {7, 2}, true);
  CHECK((nodes.first == 13 && nodes.last == 5));
  const Range back = estimate::cut_nodes(ring, {2, 6}, {2, 7}, false);
  CHECK((back.first == 5 && back.last == 13));
}

TEST_CASE("halved: sides of a matching zone that are one surface stay one, and nothing overlaps") {
  // A parabola of three elements on either side. Beyond the zone body 1 goes on along it, body 2 has corners, so that each
  // makes another guess of the surface.
  std::ostringstream out;
  out.precision(17);
  const auto point = [&](int number, double x, double y) { out << number << " " << x << " " << y << "\n"; };
  out << "*FREE\n1\nSOCKET\n0 1\n2 1 2\n1 2 8 8\n1 2 5 5\n1 8\n1 5\n1 0.3\n1 0.3\n1 0.2\n0 0\n";
  point(1, -2.5, -3), point(2, 2.5, -3);
  for (int i = 0; i < 6; ++i) point(i + 3, 2.5 - i, 0.3 * (2.5 - i) * (2.5 - i));
  out << "0 0\n";
  for (int i = 0; i < 4; ++i) point(i + 1, i - 1.5, 0.3 * (i - 1.5) * (i - 1.5));
  point(5, 0, 3);
  out << "2\n1 1 1100 0 0 0 0\n1 2 1100 0 0 0 0\n0\n1\n4 1 0011 0 -1 0 0\n0\n"
         "1 2 4 3\n4 6 3 1\n4 7 4 1\n4 3\n4 3\n1 10\n1 1\n";
  const Model before(out.str()), model(halved(out.str()));
  INFO(model.fault);
  REQUIRE(model.status == C2D_OK);
  CHECK(std::fabs(before.field(C2D_SURFACE_Y, 1, 8)[3] - before.field(C2D_SURFACE_Y, 2, 5)[2]) > 1e-3);
  const auto one = model.points(1), two = model.points(2);
  for (size_t i = 0; i < 7; ++i) CHECK(one[6 + i] == two[6 - i]);
}

TEST_CASE("halved: a crack's tip stays tied, elements of no length stay, an error is told") {
  const std::string crack = family("crack", {});
  const Model before(crack), after(halved(crack));
  c2d_summary sizes = C2D_INIT(c2d_summary);
  c2d_get_summary(before.solver(), &sizes);
  const int32_t order = sizes.function_nodes - 1;
  for (int32_t i = 1; i <= sizes.zones; ++i) {
    const c2d_zone one = before.zone(i), two = after.zone(i);
    CHECK(two.side1.elements == 2 * one.side1.elements);
    // As many nodes fewer than the elements have: those at the tips.
    CHECK(order * two.side1.elements + 1 - two.pairs == order * one.side1.elements + 1 - one.pairs);
  }
  const Model twin(
      halved(polygon({{0, 0}, {1, 0}, {1, 0}, {1, 1}, {0, 1}}, {"1 1 1100 0 0 0 0", "1 2 1100 0 0 0 0", "5 2 0000 0 0 0 0"})));
  CHECK(twin.fault == "");
  CHECK(twin.body(1).elements == 9);
  std::string error;
  const std::string deck = polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  const host::Limits limits = before.limits;
  runs::Machine empty(limits, 1 << 22, nullptr);
  CHECK(estimate::halved_deck(empty.solver, deck, error).empty());
  CHECK(error == "the deck cannot be halved: the solver has no model");
  CHECK(estimate::halved_deck(Model(deck).solver(), crack, error).empty()); // the model of another deck
  CHECK(error == std::string("the deck cannot be halved: ") + c2d_message(C2D_ERR_ARGUMENT));
  CHECK(estimate::halved_deck(Model(deck).solver(), "no deck\n", error).empty());
  CHECK(error == std::string("the deck cannot be halved: ") + c2d_message(C2D_ERR_INPUT));
}

TEST_CASE("halved: the program writes the deck, of decks and of sketches") {
  const test::Folder folder;
  const auto run = [](const std::string& arguments) { return test::run_shell("'" + paths::program() + "' " + arguments); };
  const std::string deck = paths::root() + "/examples/roller.dat";
  const test::Result written = run("mesh '" + deck + "' --halve");
  CHECK(written.status == 0);
  CHECK(written.out == halved(text_of(deck)));
  test::write_file(folder / "square.c2s",
                   "body b E 1 nu 0\nfrom 0 0\nline s to 1 0\nline e to 1 1\nline n to 0 1\nline w close\n"
                   "fix b.s x y\npressure b.n 1\n");
  const test::Result coarse = run("mesh '" + (folder / "square.c2s") + "'");
  const test::Result fine = run("mesh --halve -o '" + (folder / "fine.dat") + "' '" + (folder / "square.c2s") + "'");
  CHECK_MESSAGE(coarse.status == 0, coarse.err);
  CHECK_MESSAGE(fine.status == 0, fine.err);
  CHECK(test::read_file(folder / "fine.dat") == halved(coarse.out));
  test::write_file(folder / "wrong.dat", "no deck\n");
  CHECK(run("mesh --halve '" + (folder / "wrong.dat") + "'").status == 2);
  CHECK(run("mesh --halve=2 '" + deck + "'").status == 64);
  CHECK(run("mesh --halve '" + deck + "' -o '" + (folder / "no/such/folder") + "'").status == 3);
}

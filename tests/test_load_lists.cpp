// What the library tells of the loads of all cases, and of the places of pairs: as the cards gave them.
#include "solver_runs.hpp"

#include <doctest/doctest.h>

#include <sstream>

using namespace runs;

namespace {

// A solver with a complete model.
struct Model {
  Deck deck;
  host::Limits limits;
  std::vector<unsigned char> memory;
  c2d_solver* solver = nullptr;

  explicit Model(Deck cards, const std::string& more = "") : deck(std::move(cards)) {
    std::istringstream in(more);
    for (std::string line; std::getline(in, line);) deck.lines.push_back(line);
    limits = deck.limits();
    uint64_t minimum = 0, in_core = 0;
    REQUIRE(c2d_memory_need(&limits, &minimum, &in_core, nullptr) == C2D_OK);
    memory.resize(static_cast<size_t>(minimum));
    REQUIRE(c2d_create(&solver, memory.data(), memory.size(), &limits, nullptr, nullptr) == C2D_OK);
    const c2d_status status = c2d_read_deck(solver, Deck::read, &deck);
    c2d_error why = C2D_INIT(c2d_error);
    c2d_last_error(solver, &why);
    REQUIRE_MESSAGE(status == C2D_OK, why.text);
  }
  ~Model() { c2d_close(solver); }
  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;

  std::vector<double> get(int32_t field, int32_t body, int32_t count) const {
    std::vector<double> out(static_cast<size_t>(count));
    REQUIRE(c2d_get(solver, field, body, 1, count, out.data(), 1) == C2D_OK);
    return out;
  }
};

// The lines of a deck, its zone's cards replaced by *ZONE.
Deck free_hertz() {
  Deck deck = deck_named("hertz_lin_l");
  deck.lines[5] = "    2    0    2";
  const size_t first = deck.lines.size() - 7;
  deck.lines.erase(deck.lines.begin() + static_cast<std::ptrdiff_t>(first),
                   deck.lines.begin() + static_cast<std::ptrdiff_t>(first) + 3);
  deck.lines[first] = deck.lines[first + 1] = "    0    0";
  deck.lines.push_back("*ZONE 26 34 43 35");
  return deck;
}

// C2D_PAIR_ELEMENT1 and _ETA1, put into the element's chord, give the pair's place. Returns how many lie
// between nodes.
int check_places(const Model& model) {
  host::Summary s;
  REQUIRE(host::get_summary(model.solver, s) == C2D_OK);
  REQUIRE(s.body[0].element_nodes == 2);
  const std::vector<double> element = model.get(C2D_PAIR_ELEMENT1, 1, s.pairs), eta = model.get(C2D_PAIR_ETA1, 1, s.pairs),
                            x = model.get(C2D_X, 1, s.pairs), y = model.get(C2D_Y, 1, s.pairs),
                            nx = model.get(C2D_NODE_X, 1, s.body[0].points), ny = model.get(C2D_NODE_Y, 1, s.body[0].points);
  int between = 0;
  for (size_t p = 0; p < x.size(); ++p) {
    const size_t a = static_cast<size_t>(element[p]) - 1, b = (a + 1) % nx.size(); // one closed curve
    CHECK(eta[p] >= -1.0);
    CHECK(eta[p] <= 1.0);
    CHECK(0.5 * (1 - eta[p]) * nx[a] + 0.5 * (1 + eta[p]) * nx[b] == doctest::Approx(x[p]).epsilon(1e-12));
    CHECK(0.5 * (1 - eta[p]) * ny[a] + 0.5 * (1 + eta[p]) * ny[b] == doctest::Approx(y[p]).epsilon(1e-12));
    if (eta[p] > -0.999 && eta[p] < 0.999) ++between;
  }
  return between;
}

} // namespace

TEST_CASE("load lists: conditions, point loads and body forces of every case") {
  const Model model(deck_named("block"), "*CASES 3\ncase 2\ncondition 2 25-48 0 0.05 -0.01 0 0\n"
                                         "load 2 0.1 0.5 0.02 -0.03\ncase 3\nload 2 0.1 0.6 0.5 0\n"
                                         "*BODY FORCE 2 3 0.5 -0.25 2 0.1 0.6\n*PATH\n1 1 0 0\n");
  int32_t codes[4] = {9, 9, 9, 9}, first[4] = {9, 9, 9, 9};
  double values[4], unchanged[4];
  REQUIRE(c2d_get_condition(model.solver, 2, 30, 1, 2, codes, values) == C2D_OK);
  CHECK(codes[0] == 0);
  CHECK(values[0] == 0.05);
  CHECK(values[1] == -0.01);
  REQUIRE(c2d_get_condition(model.solver, 2, 30, 1, 3, codes, values) == C2D_OK);
  CHECK(values[0] == 0.0);
  REQUIRE(c2d_get_condition(model.solver, 2, 30, 1, 1, codes, values) == C2D_OK);
  REQUIRE(c2d_get_condition(model.solver, 2, 30, 1, 1, first, unchanged) == C2D_OK);
  for (int q = 0; q < 4; ++q) {
    CHECK(codes[q] == first[q]);
    CHECK(values[q] == unchanged[q]);
  }

  int32_t body = 0, load_case = 0;
  double xy[2], force[2], rho = 0.0, axis[2];
  REQUIRE(c2d_get_point_load(model.solver, 1, &body, &load_case, xy, force) == C2D_OK);
  CHECK(body == 2);
  CHECK(load_case == 2);
  CHECK(xy[1] == 0.5);
  CHECK(force[0] == 0.02);
  CHECK(force[1] == -0.03);
  REQUIRE(c2d_get_point_load(model.solver, 2, &body, &load_case, xy, force) == C2D_OK);
  CHECK(load_case == 3);
  CHECK(c2d_get_point_load(model.solver, 3, &body, &load_case, xy, force) == C2D_ERR_ARGUMENT);

  REQUIRE(c2d_get_body_force(model.solver, 2, 3, force, &rho, axis) == C2D_OK);
  CHECK(force[0] == 0.5);
  CHECK(force[1] == -0.25);
  CHECK(rho == 2.0);
  CHECK(axis[0] == 0.1);
  CHECK(axis[1] == 0.6);
  REQUIRE(c2d_get_body_force(model.solver, 2, 2, force, &rho, axis) == C2D_OK);
  CHECK(force[1] == 0.0);
  CHECK(rho == 0.0);
  CHECK(c2d_get_body_force(model.solver, 2, 4, force, &rho, axis) == C2D_ERR_ARGUMENT);
}

TEST_CASE("load lists: a rigid body's motion, a press fit") {
  int32_t rigid = 9, closing = 9;
  double motion[3], axis[2];
  const Model plain(deck_named("sample"));
  REQUIRE(c2d_get_rigid(plain.solver, 1, 1, &rigid, motion, axis) == C2D_OK);
  CHECK(rigid == 0);
  REQUIRE(c2d_get_interference(plain.solver, &closing) == C2D_OK);
  CHECK(closing == 0);
  const Model model(deck_named("sample"), "*CASES 2\n*RIGID\n2 0 0.02 0 0 -1\n*INTERFERENCE 2\n*PATH\n1 1 0\n");
  REQUIRE(c2d_get_rigid(model.solver, 1, 2, &rigid, motion, axis) == C2D_OK);
  CHECK(rigid == 1);
  CHECK(motion[1] == 0.02);
  CHECK(motion[2] == 0.0);
  CHECK(axis[1] == -1.0);
  REQUIRE(c2d_get_rigid(model.solver, 1, 1, &rigid, motion, axis) == C2D_OK);
  CHECK(rigid == 1);
  CHECK(motion[1] == 0.0);
  REQUIRE(c2d_get_interference(model.solver, &closing) == C2D_OK);
  CHECK(closing == 2);
}

TEST_CASE("load lists: where pairs lie on body 1") {
  CHECK(check_places(Model(deck_named("hertz_lin_l"))) == 0);
  CHECK(check_places(Model(free_hertz())) == 0); // the meshes happen to match
  Deck shifted = free_hertz();                   // nodes 29 and 31 of body 1 leave their partners
  REQUIRE(shifted.lines[42] == "   29 1.200000000.00000000");
  shifted.lines[42] = "   29 1.250000000.00000000";
  REQUIRE(shifted.lines[44] == "   31 0.800000000.00000000");
  shifted.lines[44] = "   31 0.830000000.00000000";
  CHECK(check_places(Model(shifted)) == 2);
}

// What must not matter: units, directions, numbering, which body is first, workspace, store, repetition.
#include "problem.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <string>
#include <vector>

using namespace problem;

namespace {

const char* const kDecks[] = {"sample.dat",      "sample56.dat", "block.dat",   "half_cylinder.dat",
                              "hertz_lin_l.dat", "layer_mu.dat", "layer_t.dat", "rect.dat"};

Result solved(const Problem& p, const Setup& setup = Setup()) {
  Result r = solve(p, setup);
  REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
  return r;
}

void check_same(const Result& a, const Result& b, const Mapping& map, double tolerance) {
  const Difference d = compare(a, b, map);
  CHECK(d.statuses == 0);
  CHECK(d.traction < tolerance);
  CHECK(d.displacement1 < tolerance);
  CHECK(d.displacement2 < tolerance);
  CHECK(d.gap < tolerance);
  CHECK(d.slip < tolerance);
}

// ---- decks in other units
// ---------------------------------------------------------------------------------------

// A number in ten columns that reads as exactly this value; empty if there is none.
std::string ten_columns(double value) {
  char text[40];
  for (int digits = 0; digits <= 9; ++digits) {
    std::snprintf(text, sizeof text, "%.*f", digits, value);
    if (std::strlen(text) <= 10 && std::strtod(text, nullptr) == value) return std::string(10 - std::strlen(text), ' ') + text;
    std::snprintf(text, sizeof text, "%.*E", digits, value);
    if (std::strlen(text) <= 10 && std::strtod(text, nullptr) == value) return std::string(10 - std::strlen(text), ' ') + text;
  }
  return "";
}

struct DeckScaler {
  std::vector<std::string> lines;
  size_t at = 0;
  double length, stress;

  int integer(size_t column, size_t width) const { return std::atoi(lines[at].substr(column - 1, width).c_str()); }
  void field(size_t column, double factor) {
    std::string& line = lines[at];
    line.resize(std::max(line.size(), column + 9), ' ');
    const double value = std::strtod(line.substr(column - 1, 10).c_str(), nullptr);
    const std::string text = ten_columns(value * factor);
    REQUIRE_MESSAGE(text.size() == 10, value * factor << " does not fit: " << line);
    line.replace(column - 1, 10, text);
  }
};

std::string deck_in_units(const std::string& text, double length, double stress) {
  DeckScaler d = {{}, 0, length, stress};
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) d.lines.push_back(line);
  const int headings = d.integer(1, 5);
  d.at = 1 + static_cast<size_t>(headings) + 1;
  const int bodies = d.integer(1, 5);
  ++d.at;
  int points[2] = {0, 0}, regions = 0;
  for (int b = 0; b < bodies; ++b, ++d.at) regions += d.integer(1, 5), points[b] = d.integer(16, 5);
  d.at += static_cast<size_t>(regions);
  for (int b = 0; b < bodies; ++b, ++d.at) d.field(1, stress);
  ++d.at; // coefficients of friction
  for (int b = 0; b < bodies; ++b) {
    d.field(1, length), d.field(11, length);
    ++d.at;
    for (bool last = false; !last; ++d.at) {
      last = d.integer(2, 4) == points[b];
      d.field(7, length);
      if (d.lines[d.at][0] != 'P') d.field(17, length);
    }
  }
  for (int b = 0; b < bodies; ++b) {
    int cards = d.integer(1, 5);
    for (++d.at; cards > 0; --cards, ++d.at)
      for (size_t k = 0; k < 4; ++k) d.field(17 + 10 * k, k < 2 ? stress : length);
    REQUIRE(d.integer(1, 5) == 0); // no point loads in these decks
    ++d.at;
  }
  std::string out;
  for (const std::string& line : d.lines) out += line + "\n";
  return out;
}

} // namespace

TEST_CASE("invariance: other units by calls") {
  const double units[][2] = {{0.37, 1}, {1e3, 1}, {1e-4, 1}, {1, 7.3}, {1, 1e6}, {1e-4, 1e6}, {0.37, 7.3e-5}};
  for (const std::string deck : kDecks) {
    const Problem p = load(deck);
    const Result reference = solved(p);
    for (const auto& unit : units) {
      CAPTURE(deck);
      CAPTURE(unit[0]);
      CAPTURE(unit[1]);
      Mapping map;
      map.length = 1 / unit[0];
      map.stress = 1 / unit[1];
      check_same(reference, solved(scaled(p, unit[0], unit[1])), map, 1e-9);
    }
  }
}

TEST_CASE("invariance: other units by decks, with factors exact in ten columns") {
  struct Case {
    const char* deck;
    double length, stress;
  };
  const Case cases[] = {{"sample.dat", 0.5, 1},     {"sample.dat", 1024, 1},    {"sample.dat", 0.0625, 1},
                        {"sample.dat", 1, 0.0625},  {"sample.dat", 1024, 0.5},  {"sample.dat", 0.5, 1024},
                        {"block.dat", 0.5, 1},      {"block.dat", 0.5, 0.0625}, {"layer_mu.dat", 0.0625, 1024},
                        {"layer_mu.dat", 1024, 0.5}};
  for (const Case& c : cases) {
    const std::string deck = c.deck;
    CAPTURE(deck);
    CAPTURE(c.length);
    CAPTURE(c.stress);
    const std::string text = deck_text(c.deck);
    const Result a = solve_text(text), b = solve_text(deck_in_units(text, c.length, c.stress));
    REQUIRE_MESSAGE(b.status == C2D_OK, b.messages());
    Mapping map;
    map.length = 1 / c.length;
    map.stress = 1 / c.stress;
    check_same(a, b, map, 1e-9);
    // Powers of two change no digit in an engine that works in units of its own.
    CHECK(compare(a, b, map).worst() == 0.0);
  }
}

TEST_CASE("invariance: quarter turns") {
  for (const std::string deck : kDecks) {
    CAPTURE(deck);
    const Problem p = load(deck), once = rotated(p, 90), twice = rotated(once, 90), thrice = rotated(twice, 90);
    const Result reference = solved(p);
    for (const Problem* turned : {&once, &twice, &thrice}) check_same(reference, solved(*turned), Mapping(), 1e-9);
  }
}

TEST_CASE("invariance: any angle, where no condition holds a single component") {
  const Problem p = load("block.dat");
  const Result reference = solved(p);
  for (double degrees : {30.0, 45.0, 117.3, -30.0}) {
    CAPTURE(degrees);
    check_same(reference, solved(rotated(p, degrees)), Mapping(), 1e-9);
  }
}

TEST_CASE("invariance: reflection turns the tangential signs") {
  Mapping map;
  map.tangential = -1;
  for (const std::string deck : kDecks) {
    CAPTURE(deck);
    const Problem p = load(deck);
    check_same(solved(p), solved(reflected(p)), map, 1e-9);
  }
}

TEST_CASE("invariance: boundaries numbered from another node") {
  for (const std::string deck : kDecks) {
    CAPTURE(deck);
    const Problem p = load(deck);
    const Result reference = solved(p);
    for (int32_t shift : {1, 7, 30}) { // 30 lies within most contact zones
      CAPTURE(shift);
      check_same(reference, solved(renumbered(p, shift)), Mapping(), 1e-9);
    }
  }
}

// Five of eight elements: first and last are as far from each other one way as the other way round.
TEST_CASE("invariance: a zone over half of its ring, numbered from every node") {
  Problem p;
  p.bodies.resize(2);
  add_polygon(p.bodies[0], {{0, -2, 1}, {5, -2, 1}, {5, 0, 5}, {0, 0, 1}});
  add_polygon(p.bodies[1], {{0, 0, 5}, {5, 0, 1}, {5, 2, 1}, {0, 2, 1}});
  set_ends(p, 1, [](double, double, double, double ny, End& end) {
    const bool held = ny < -0.5;
    for (int c = 0; c < 2; ++c) end.codes[c] = held, end.codes[2 + c] = !held;
  });
  for (int32_t node : {1, 2}) // at both ends of the side that is held
    for (int c = 0; c < 2; ++c) p.end(1, node == 1 ? 8 : 2, node == 1 ? 2 : 1).codes[2 + c] = 0;
  set_ends(p, 2, [](double x, double, double, double ny, End& end) {
    if (ny > 0.5) end.values[0] = 0.1, end.values[1] = -1 - 0.1 * x;
  });
  problem::Zone zone = problem::Zone();
  zone.pairs = 6, zone.elements = 5;
  zone.first_element[0] = 3, zone.last_element[0] = 7, zone.first_node[0] = 3, zone.last_node[0] = 8;
  zone.first_element[1] = 5, zone.last_element[1] = 1, zone.first_node[1] = 6, zone.last_node[1] = 1;
  p.zones = {zone};
  p.friction = {0.5};
  const Result reference = solved(p);
  for (int32_t shift = 1; shift < 8; ++shift) {
    CAPTURE(shift);
    check_same(reference, solved(renumbered(p, shift)), Mapping(), 1e-9);
  }
}

TEST_CASE("invariance: bodies exchanged") {
  Mapping map;
  map.exchanged = true;
  for (const std::string deck : {"layer_mu.dat", "layer_t.dat", "rect.dat", "block.dat"}) {
    CAPTURE(deck);
    const Problem p = load(deck);
    check_same(solved(p), solved(exchanged(p)), map, 1e-8);
  }
  for (const std::string deck : {"sample.dat", "sample56.dat", "half_cylinder.dat", "hertz_lin_l.dat"}) {
    CAPTURE(deck);
    // Pressures are per length of the new body 1: they change by up to 3 % (measured), displacements hardly.
    const Problem p = load(deck);
    const Difference d = compare(solved(p), solved(exchanged(p)), map);
    CHECK(d.statuses == 0);
    CHECK(d.displacement1 < 1e-4);
    CHECK(d.displacement2 < 1e-4);
    CHECK(d.gap < 1e-4);
    CHECK(d.slip < 1e-4);
  }
}

TEST_CASE("invariance: workspace, panel width and store") {
  for (const std::string deck : {"sample.dat", "sample56.dat", "block.dat", "layer_mu.dat", "half_cylinder.dat"}) {
    const Problem p = load(deck);
    const Result reference = solved(p);
    for (int32_t columns : {1, 3, 8, 0})
      for (Memory memory : {Memory::minimum, Memory::between, Memory::in_core})
        for (Store store : {Store::memory, Store::stdio, Store::posix}) {
          // Files cost time, the synced ones most; which blocks there are does not depend on the store.
          if (store == Store::stdio && deck != "sample.dat" && deck != "block.dat") continue;
          if (store == Store::posix && (deck != "sample.dat" || columns == 1)) continue;
          CAPTURE(deck);
          CAPTURE(columns);
          CAPTURE(static_cast<int>(memory));
          CAPTURE(static_cast<int>(store));
          Setup setup;
          setup.panel_columns = columns;
          setup.memory = memory;
          setup.store = store;
          const Result r = solved(p, setup);
          check_same(reference, r, Mapping(), 1e-9);
          CHECK(boundary_difference(reference, r) < 1e-9);
        }
  }
}

TEST_CASE("invariance: the store changes no bit") {
  const Problem p = load("sample.dat");
  Setup setup;
  setup.memory = Memory::minimum;
  const Result memory = solved(p, setup);
  setup.store = Store::stdio;
  CHECK(identical(memory, solved(p, setup)));
  setup.store = Store::posix;
  CHECK(identical(memory, solved(p, setup)));
}

TEST_CASE("invariance: the sample solves in 48 KiB with a file store") {
  const std::string text = deck_text("sample.dat");
  const Result reference = solve_text(text);
  Setup setup;
  setup.bytes = 48 * 1024;
  setup.store = Store::stdio;
  const Result r = solve_text(text, setup);
  REQUIRE_MESSAGE(r.status == C2D_OK, "needs " << r.minimum_bytes << "\n" << r.messages());
  check_same(reference, r, Mapping(), 1e-9);
}

TEST_CASE("invariance: twice is the same to the bit") {
  for (const std::string deck : kDecks) {
    CAPTURE(deck);
    const Problem p = load(deck);
    const Result once = solved(p);
    CHECK(identical(once, solved(p)));
    Setup setup;
    setup.runs = 2;
    CHECK(identical(once, solved(p, setup)));
  }
}

TEST_CASE("invariance: coefficients of friction in another order") {
  for (const std::string deck : {"sample.dat", "layer_mu.dat", "rect.dat", "half_cylinder.dat"}) {
    CAPTURE(deck);
    Problem p = load(deck);
    REQUIRE(p.friction.size() > 1);
    const Result a = solved(p);
    std::vector<double> turned(p.friction.rbegin(), p.friction.rend());
    p.friction = turned;
    const Result b = solved(p);
    const std::vector<Step> x = a.recorded(), y = b.recorded();
    REQUIRE(x.size() == y.size());
    const size_t steps = x.size() / p.friction.size();
    for (size_t i = 0; i < x.size(); ++i) {
      const size_t other = (p.friction.size() - 1 - i / steps) * steps + i % steps;
      CHECK(x[i].mu == y[other].mu);
      CHECK(x[i].table == y[other].table);
    }
  }
}

TEST_CASE("invariance: begin and advance reproduce run, also after it") {
  for (const std::string deck : kDecks) {
    CAPTURE(deck);
    const Problem p = load(deck);
    const std::vector<Step> run = solved(p).recorded();
    const size_t steps = run.size() / p.friction.size();
    for (bool after : {false, true}) {
      Setup setup;
      setup.begin_after_run = after;
      setup.advance_mu = p.friction[0];
      for (size_t i = 0; i < steps; ++i) setup.advance_loads.push_back(run[i].load);
      const std::vector<Step> steps_by_calls = solved(p, setup).recorded();
      REQUIRE(steps_by_calls.size() == steps);
      for (size_t i = 0; i < steps; ++i) CHECK(steps_by_calls[i].table == run[i].table);
    }
  }
}

TEST_CASE("a host that steps itself gives neither friction nor path, and c2d_run says so") {
  Problem given = load("block.dat"), bare = given;
  bare.friction.clear();
  bare.paths.clear();
  Setup steps;
  steps.advance_loads = {0.5, 1.0};
  steps.advance_mu = 0.3;
  const Result with = solve(given, steps), without = solve(bare, steps);
  REQUIRE(with.status == C2D_OK);
  REQUIRE(without.status == C2D_OK);
  CHECK(identical(with, without));
  Problem no_friction = given;
  no_friction.friction.clear();
  for (const Problem& p : {bare, no_friction}) {
    const Result run = solve(p);
    CHECK(run.status == C2D_ERR_ARGUMENT);
    CHECK(run.messages().find(p.paths.empty() ? "no load path to run" : "no coefficient of friction to run") !=
          std::string::npos);
  }
}

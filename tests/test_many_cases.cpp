// Many load cases, as loads that move over a body need them: by decks, by calls, in FORTRAN 77, saved and restored, in tables.
// What they give is what a model with the few cases that the path uses gives.
#include "fortran77_calls.hpp"
#include "solver/session.hpp"
#include "solver_runs.hpp"

#include <cmath>
#include <doctest/doctest.h>

using namespace runs;

namespace {

constexpr int kSide = 32; // elements along the contact

// A list on cards of at most 78 columns.
void add_list(std::vector<std::string>& lines, const std::string& first, const std::vector<std::string>& list) {
  std::string line = first;
  for (const std::string& item : list) {
    if (line.size() + item.size() > 74) {
      lines.push_back(line + " &");
      line.clear();
    }
    line += " " + item;
  }
  lines.push_back(line);
}

void add_nodes(std::vector<std::string>& lines, double bottom) {
  const int n = kSide, m = n / 2;
  const double step = 4.0 / n;
  int number = 0;
  const auto node = [&](double x, double y) {
    lines.push_back(std::to_string(++number) + " " + std::to_string(x) + " " + std::to_string(bottom + y));
  };
  lines.push_back("0 0");
  for (int i = 0; i < n; ++i) node(i * step, 0);
  for (int i = 0; i < m; ++i) node(4, i * step);
  for (int i = 0; i < n; ++i) node(4 - i * step, 2);
  for (int i = 0; i < m; ++i) node(0, 2 - i * step);
}

// Two blocks. Case 1 presses all of the upper one, every other one an element of it, or draws the foundation aside (every
// seventh), or is a point load in it (every fifth). The path: case 1, then each of `used` in turn beside it.
Deck blocks(const std::vector<int>& cases, const std::vector<int>& used) {
  const int n = kSide, m = n / 2, elements = 2 * n + 2 * m, first = n + m + 1;
  const auto number = [](int i) { return std::to_string(i); };
  Deck deck;
  std::vector<std::string>& to = deck.lines;
  to = {"*FREE", "1", "MANY LOAD CASES", "0 1", "2 1 2"};
  for (int b = 0; b < 2; ++b) to.push_back("1 2 " + number(elements) + " " + number(elements));
  for (int b = 0; b < 2; ++b) to.push_back("1 " + number(elements));
  to.insert(to.end(), {"100 0.3", "200 0.2", "1 0.5"});
  for (int b = 0; b < 2; ++b) add_nodes(to, 2 * b);
  to.insert(to.end(), {"2", "1 1 1100 0 0 0 0", "1 " + number(n) + " 2 1100 0 0 0 0", "0"});
  to.insert(to.end(), {"2", number(first) + " 1 0011 0 -1 0 0", "1 " + number(first + n - 1) + " 2 0011 0 -1 0 0", "0"});
  to.push_back("1 2 " + number(n + 1) + " " + number(n));
  to.push_back(number(first) + " " + number(first + n - 1) + " " + number(n) + " 1");
  to.push_back(number(first) + " " + number(first + n) + " " + number(n + 1) + " 1");
  for (int b = 0; b < 2; ++b) to.push_back(number(n + 1) + " " + number(n));
  to.insert(to.end(), {"1 10", "1 1", "*CASES " + number(static_cast<int>(cases.size()) + 1)});
  for (size_t k = 0; k < cases.size(); ++k) {
    const int i = cases[k];
    to.push_back("case " + number(static_cast<int>(k) + 2));
    if (i % 7 == 0)
      to.push_back("condition 1 1-" + number(n) + " 0 0 0 " + std::to_string(1e-4 * i) + " 0");
    else if (i % 5 == 0)
      to.push_back("load 2 " + std::to_string(0.5 + 3.0 * (i % n) / n) + " 3.5 0.05 -0.3");
    else
      to.push_back("condition 2 " + number(first + i % n) + " 0 0.1 -0.8 0 0");
  }
  to.push_back("*PATH");
  for (int turn = -1; turn < static_cast<int>(used.size()); ++turn) {
    std::vector<std::string> factors = {"1"};
    for (const int i : cases) factors.push_back(turn >= 0 && i == used[static_cast<size_t>(turn)] ? "1" : "0");
    add_list(to, "2", factors);
  }
  return deck;
}

std::vector<int> counted(int cases) { // besides the first
  std::vector<int> out;
  for (int i = 1; i < cases; ++i) out.push_back(i);
  return out;
}

struct Run {
  RamStore store;
  c2d_port port = C2D_INIT(c2d_port);
  host::Limits limits;
  uint64_t in_core = 0;

  explicit Run(const Deck& deck) : limits(deck.limits()) {
    REQUIRE(limits.bodies == 2);
    REQUIRE(c2d_memory_need(&limits, nullptr, &in_core, nullptr) == C2D_OK);
    store.serve(port);
  }
};

struct Steps {
  std::vector<double> tables, work, factors;
  static int32_t take(void* context, const c2d_step* step) {
    Steps& to = *static_cast<Steps*>(context);
    for (int32_t pair = 0; pair < step->pairs; ++pair)
      for (const int field : {C2D_TN, C2D_TT, C2D_STATUS}) to.tables.push_back(step->table[pair * step->stride + field]);
    double sum = 0;
    for (int32_t k = 0; k < step->cases; ++k) {
      if (step->loads[k] != 0) to.factors.push_back(step->loads[k]);
      sum += step->work_by_case[k];
    }
    to.work.push_back(sum);
    return 0;
  }
};

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  REQUIRE(a.size() == b.size());
  double most = 0, size = 0;
  for (size_t i = 0; i < a.size(); ++i) most = std::max(most, std::fabs(a[i] - b[i])), size = std::max(size, std::fabs(b[i]));
  return most / size;
}

// bytes: of the workspace; 0: what everything in memory takes
Steps steps_of(const Deck& deck, uint64_t bytes = 0) {
  Run run(deck);
  Machine machine(run.limits, bytes != 0 ? bytes : run.in_core, &run.port);
  Steps steps;
  REQUIRE_MESSAGE(read_deck(machine.solver, deck) == C2D_OK, error_of(machine.solver).text);
  REQUIRE(c2d_prepare(machine.solver) == C2D_OK);
  REQUIRE(c2d_run(machine.solver, Steps::take, &steps) == C2D_OK);
  return steps;
}

} // namespace

TEST_CASE("many cases: a path through a few of them is that of a deck with these alone") {
  for (const int cases : {24, 96, 400}) {
    CAPTURE(cases);
    const std::vector<int> used = {1, cases / 2, 5, 7, 10, cases - 1};
    std::vector<int> few = used;
    std::sort(few.begin(), few.end());
    const Steps some = steps_of(blocks(few, used)), all = steps_of(blocks(counted(cases), used));
    REQUIRE(some.work.size() == 14);
    CHECK(largest_difference(all.tables, some.tables) < 1e-9);
    CHECK(largest_difference(all.work, some.work) < 1e-9);
    CHECK(all.factors == some.factors);
  }
}

// Bytes from the store are what can be counted on every machine: with the square of the cases 400 took 25 times as many as 24.
TEST_CASE("many cases: what is read to prepare them grows with their number") {
  const auto bytes = [](int cases) {
    const Deck deck = blocks(counted(cases), {1});
    Run run(deck);
    Machine machine(run.limits, run.in_core, &run.port);
    REQUIRE(read_deck(machine.solver, deck) == C2D_OK);
    REQUIRE(c2d_prepare(machine.solver) == C2D_OK);
    double sum = 0;
    for (const uint64_t each : run.store.bytes_read) sum += static_cast<double>(each);
    return sum;
  };
  const double few = bytes(24), more = bytes(96), many = bytes(400);
  MESSAGE("24: " << few << " 96: " << more << " 400: " << many);
  CHECK(more < 4 * few);
  CHECK(many < (c2d::kSmallCode ? 16 : 8) * few); // functionals of the energies share a pass
}

// How many functionals share a pass depends on the workspace.
TEST_CASE("many cases: the least workspace changes no more than last digits") {
  for (const int cases : {96, 400}) {
    CAPTURE(cases);
    const Deck deck = blocks(counted(cases), {1, 7, 10, cases - 1});
    uint64_t least = 0;
    const Run run(deck);
    REQUIRE(c2d_memory_need(&run.limits, &least, nullptr, nullptr) == C2D_OK);
    REQUIRE(least < run.in_core);
    const Steps tight = steps_of(deck, least), wide = steps_of(deck, 2 * run.in_core);
    CHECK(largest_difference(tight.tables, wide.tables) < 1e-10);
    CHECK(largest_difference(tight.work, wide.work) < 1e-10);
  }
}

// With many cases the sums of the mean motions once went into the room of the tableau, which was then built anew.
TEST_CASE("many cases: what is read in a step's callback leaves the tableau as it is") {
  struct Reading {
    c2d_solver* solver;
    int steps = 0;
    double approach = 0;
    static int32_t take(void* context, const c2d_step*) {
      Reading& to = *static_cast<Reading*>(context);
      c2d::Session session;
      c2d::open_session(to.solver, session);
      const c2d::Tableau& t = session.tableau;
      const std::vector<c2d::Real> before(t.t, t.t + int64_t{t.m} * c2d::tableau_columns(t));
      c2d_zone_state zone = C2D_INIT(c2d_zone_state);
      c2d_body_state body = C2D_INIT(c2d_body_state);
      CHECK(c2d_get_zone_state(to.solver, 1, &zone) == C2D_OK);
      for (int32_t b = 1; b <= 2; ++b) CHECK(c2d_get_body_state(to.solver, b, &body) == C2D_OK);
      CHECK(std::equal(before.begin(), before.end(), t.t));
      to.approach = std::max(to.approach, std::fabs(zone.approach));
      ++to.steps;
      return 0;
    }
  };
  for (const int cases : {24, 400}) {
    CAPTURE(cases);
    const Deck deck = blocks(counted(cases), {1, 7});
    Run run(deck);
    Machine machine(run.limits, run.in_core, &run.port);
    Reading reading{machine.solver};
    REQUIRE(read_deck(machine.solver, deck) == C2D_OK);
    REQUIRE(c2d_prepare(machine.solver) == C2D_OK);
    REQUIRE(c2d_run(machine.solver, Reading::take, &reading) == C2D_OK);
    CHECK(reading.steps == 6);
    CHECK(reading.approach > 0);
  }
}

TEST_CASE("many cases: saved in the path and restored in another workspace, the same bits") {
  for (const int cases : {96, 400}) {
    CAPTURE(cases);
    const Deck deck = blocks(counted(cases), {3, cases - 1});
    Run run(deck);
    Numbers expected, found;
    std::vector<double> factors(static_cast<size_t>(cases), 0.0);
    const auto go = [&](c2d_solver* s, double last, Numbers& to) {
      factors[0] = 1, factors.back() = last;
      REQUIRE(c2d_advance(s, factors.data(), cases, &to.outcome) == C2D_OK);
      REQUIRE(get_boundary(s, to) == C2D_OK);
    };
    {
      Machine machine(run.limits, run.in_core, &run.port);
      REQUIRE(read_deck(machine.solver, deck) == C2D_OK);
      REQUIRE(c2d_prepare(machine.solver) == C2D_OK);
      const double mu = 0.5;
      REQUIRE(c2d_begin(machine.solver, &mu, 1) == C2D_OK);
      go(machine.solver, 0.7, expected);
      REQUIRE(c2d_save(machine.solver) == C2D_OK);
      expected = Numbers();
      go(machine.solver, -0.4, expected);
      int32_t outcome = 0;
      CHECK(c2d_advance(machine.solver, factors.data(), cases - 1, &outcome) == C2D_ERR_ARGUMENT);
    }
    Machine again(run.limits, run.in_core, &run.port);
    REQUIRE(read_deck(again.solver, deck) == C2D_OK);
    REQUIRE(c2d_restore(again.solver) == C2D_OK);
    go(again.solver, -0.4, found);
    CHECK(found == expected);
    std::vector<double> row(static_cast<size_t>(cases));
    int32_t increments = 0;
    REQUIRE(c2d_get_path(again.solver, 3, &increments, row.data(), cases) == C2D_OK);
    CHECK(increments == 2);
    CHECK(row.front() + row.back() == 2);
  }
}

TEST_CASE("many cases: FORTRAN 77 reads them and follows factors of its own, as in C") {
  for (const int32_t cases : {96, 400}) {
    CAPTURE(cases);
    const Deck deck = blocks(counted(cases), {3});
    Run run(deck);
    Machine machine(run.limits, run.in_core, &run.port);
    REQUIRE(read_deck(machine.solver, deck) == C2D_OK);
    REQUIRE(c2d_prepare(machine.solver) == C2D_OK);
    const double mu = 0.5;
    std::vector<double> factors(static_cast<size_t>(cases), 0.0);
    factors[0] = 1, factors.back() = 0.5;
    int32_t ours = -1, outcome = -2, error = 0;
    REQUIRE(c2d_begin(machine.solver, &mu, 1) == C2D_OK);
    REQUIRE(c2d_advance(machine.solver, factors.data(), cases, &ours) == C2D_OK);
    const int32_t words = static_cast<int32_t>(run.in_core / 8) + 40000, stored = 1 << 21;
    test::Odd memory(8 * static_cast<size_t>(words), 4), store(8 * static_cast<size_t>(stored), 4);
    void* work = memory.at();
    REQUIRE(test::open(work, words) == 0);
    c2core_(work, store.at(), test::I{stored}, &error);
    const std::string cards = test::padded(deck.lines);
    c2card_(work, cards.data(), test::I{80}, test::I{static_cast<int32_t>(deck.lines.size())}, &error);
    REQUIRE(error == 0);
    c2prep_(work, &error);
    REQUIRE(error == 0);
    c2begn_(work, test::R{mu}, test::I{1}, &error);
    c2advn_(work, factors.data(), test::I{cases}, &outcome, &error);
    CHECK(error == 0);
    CHECK(outcome == ours);
    std::vector<double> theirs(kSide + 1), expected(kSide + 1);
    REQUIRE(c2d_get(machine.solver, C2D_TN, 0, 1, kSide + 1, expected.data(), 1) == C2D_OK);
    c2get_(work, test::I{C2D_TN}, test::I{0}, test::I{1}, test::I{kSide + 1}, theirs.data(), test::I{1}, &error);
    CHECK(error == 0);
    CHECK(theirs == expected);
    c2clos_(work, &error);
  }
}

TEST_CASE("many cases: every table has a column for each, and what was cut off is resumed") {
  for (const int cases : {96, 400}) {
    CAPTURE(cases);
    const test::Folder folder;
    std::string text;
    for (const std::string& line : blocks(counted(cases), {3, cases - 1}).lines) text += line + "\n";
    test::write_file(folder / "many.dat", text);
    const std::string run = "cd '" + folder.path() + "' && '" + paths::program() + "' ";
    const test::Result done =
        test::run_shell(run + "run many.dat --store file:t --keep --csv c.csv --json j.json --listing l.txt"
                              " --summary s.csv --bodies b.csv --trace t.csv --stresses st.csv");
    REQUIRE_MESSAGE(done.status == 0, done.err);
    const std::string last = ",load" + std::to_string(cases), next = ",load" + std::to_string(cases + 1);
    std::vector<std::string> tables;
    for (const char* name : {"c.csv", "s.csv", "b.csv", "t.csv", "st.csv"}) {
      CAPTURE(std::string(name));
      tables.push_back(test::read_file(folder / name));
      const std::vector<std::string> rows = test::lines_of(tables.back());
      REQUIRE(rows.size() > 1);
      CHECK(test::contains(rows[0], ",load2,load3"));
      CHECK(test::contains(rows[0], last));
      CHECK(!test::contains(rows[0], next));
      const auto fields = [](const std::string& row) { return std::count(row.begin(), row.end(), ','); };
      CHECK(fields(rows.back()) == fields(rows[0]));
    }
    const std::string json = test::read_file(folder / "j.json");
    CHECK(!json.empty());
    CHECK(test::contains(test::read_file(folder / "l.txt"), "load factors of all cases"));
    const test::Result resumed = test::run_shell(run + "resume t");
    REQUIRE_MESSAGE(resumed.status == 0, resumed.err);
    size_t i = 0;
    for (const char* name : {"c.csv", "s.csv", "b.csv", "t.csv", "st.csv"})
      CHECK(test::read_file(folder / name) == tables[i++]);
  }
}

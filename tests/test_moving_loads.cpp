// Loads that move: their positions as load cases beside loads drawn there, the history between them, errors from their number.
#include "effort.hpp"
#include "json.hpp"
#include "program/sketch/moving.hpp"
#include "sketch_runs.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <sstream>

using namespace sketch_test;

namespace {

const double kPi = std::acos(-1.0);

const std::string kTied = "body b E 100 nu 0.3\nfrom -3 -1\nline s to 3 -1\nline e to 3 0\nline n to -3 0\nline w close\n"
                          "body c E 100 nu 0.3\nfrom -3 0\nline s to 3 0\nline e to 3 1\nline n to -3 1\nline w close\n"
                          "tie c.s b.n\nfix b.s\nsteps 1\n";

sketch::Sketch read_whole(const std::string& text) {
  const sketch::Reading reading = read_text(text);
  for (const sketch::Fault& fault : reading.faults) FAIL_CHECK(fault.at.line << ": " << fault.text);
  return reading.sketch;
}

// Tractions of the tie at the end of the history, on one mesh.
std::vector<Row> end_of(const sketch::Sketch& sketch, const sketch::Mesh& mesh) {
  const Solution s = families_test::solve_deck(sketch::deck_of(sketch, mesh));
  REQUIRE_MESSAGE(s.error.empty(), s.error);
  return zone_at(s, s.steps.size() - 1);
}

void check_alike(const std::string& moving, const std::string& drawn) {
  const sketch::Sketch one = read_whole(moving), other = read_whole(drawn);
  const sketch::Mesh mesh = sketch::first_mesh(one, 1);
  const std::vector<Row> a = end_of(one, mesh), b = end_of(other, mesh);
  REQUIRE(a.size() == b.size());
  double largest = 0, apart = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    largest = std::max({largest, std::fabs(a[i].tn), std::fabs(a[i].tt)});
    apart = std::max({apart, std::fabs(a[i].tn - b[i].tn), std::fabs(a[i].tt - b[i].tt)});
  }
  CHECK(largest > 0);
  CHECK(apart < 1e-9 * largest);
}

// Do the conditions of a case apply at every place what those of the last case of a drawn sketch do?
void check_values(const std::string& moving, int load_case, const std::string& drawn) {
  const sketch::Sketch all = with_positions(read_whole(moving)), one = read_whole(drawn);
  const int last = static_cast<int>(one.cases.size()) - 1;
  double largest = 0, apart = 0;
  const auto sum_of = [](const sketch::Sketch& s, int number, sketch::Point at) {
    sketch::Point sum;
    for (const sketch::Condition& c : s.conditions)
      if (c.load_case == number && c.kind != sketch::Condition::kDisplacement) sum = sum + c.value_at(at);
    return sum;
  };
  for (int i = 0; i < 40; ++i) {
    const sketch::Point at{2.9 * std::sin(1.7 * i), 1.3 * std::cos(0.9 * i)}, expected = sum_of(one, last, at);
    largest = std::max(largest, sketch::length(expected));
    apart = std::max(apart, sketch::length(sum_of(all, load_case, at) - expected));
  }
  CHECK(largest > 0);
  CHECK(apart < 1e-13 * largest);
}

void has(const std::string& fault, const char* text) { CHECK_MESSAGE(test::contains(fault, text), fault); }

std::string fault_of(const std::string& text) {
  const sketch::Reading reading = read_text(text);
  if (reading.faults.empty()) return "none";
  const sketch::Fault& f = reading.faults.front();
  return std::to_string(f.at.line) + ":" + std::to_string(f.at.column) + " " + f.text;
}

} // namespace

TEST_CASE("moving loads: at a position they are those drawn there") {
  const std::string travel =
      kTied + "case roll travel 2 0 positions 4\npressure c.n {exp(-(x + 1)^2)}\nhistory roll 1; roll to 1\n";
  check_values(travel, 4, kTied + "case roll\npressure c.n {exp(-(x - 1)^2)}\nhistory roll 1\n");
  check_values(travel, 1, kTied + "case roll\npressure c.n {exp(-(x + 0.5)^2)}\nhistory roll 1\n");
  const std::string turned = kTied + "case roll round 1 0 positions 4\ntraction c.n fx {exp(x*y)} fy {x}\ntraction c.e fx 2\n"
                                     "history roll 1; roll to 1\n";
  // A quarter turn about (1, 0): (x, y) comes from (1 + y, 1 - x), and (fx, fy) is (-fy, fx) there.
  check_values(turned, 1,
               kTied + "case roll\ntraction c.n fx {-(1 + y)} fy {exp((1 + y)*(1 - x))}\ntraction c.e fy 2\n"
                       "history roll 1\n");
  const std::string text = "pressure c.n {exp(-(x - 2)^2)}\nhistory roll 1; roll to 1\n"; // c.n goes from (3, 1) to (-3, 1)
  for (int k = 0; k <= 5; ++k)
    check_values(kTied + "case roll along c.n positions 5\n" + text, k,
                 kTied + "case roll\npressure c.n {exp(-(x - 2 + 6*" + std::to_string(k) + "/5)^2)}\nhistory roll 1\n");
}

TEST_CASE("moving loads: along an arc they turn about its centre") {
  const std::string body = "body b E 1 nu 0\nfrom 2 0\narc rim to -2 0 centre 0 0\nline floor close\nfix b.floor\n";
  const std::string load = "pressure b.rim {max(0, x)^3}\nhistory roll 1; roll to 1\n";
  const sketch::Sketch along = with_positions(read_whole(body + "case roll along b.rim positions 6\n" + load)),
                       round = with_positions(read_whole(body + "case roll round 0 0 positions 12\n" + load));
  for (int k = 0; k <= 6; ++k)
    for (const double angle : {0.1, 1.0, 2.9}) {
      const sketch::Point at{2 * std::cos(angle), 2 * std::sin(angle)};
      const auto value = [&](const sketch::Sketch& s) {
        for (const sketch::Condition& c : s.conditions)
          if (c.load_case == k && c.kind == sketch::Condition::kPressure) return c.value_at(at).x;
        return std::nan("");
      };
      CHECK(value(along) == doctest::Approx(value(round)).epsilon(1e-7));
    }
}

TEST_CASE("moving loads: forces, weights and drives move, and the end of a history is that of the loads drawn there") {
  const std::string to = "; roll to 1, 0.25\n"; // a whole turn, and back
  check_alike(kTied + "case roll round 0 0.5 positions 8\nforce c at 0.3 0.5 fx 1\nweight c fy -1\nhistory roll 1" + to,
              kTied + "case roll\nforce c at 0 0.8 fy 1\nweight c fx 1\nhistory roll 1\n");
  check_alike(kTied + "case roll round 0 0 positions 4\nplaten c.n about 0 1 fx 1 fy 2 moment 3\nhistory roll 1" + to,
              kTied + "case roll\nplaten c.n about 0 1 fx -2 fy 1 moment 3\nhistory roll 1\n");
  check_alike(kTied + "case roll round 0 0 positions 4\nplaten c.n about 0 1 x 0.1 y 0.2 turn 0\nhistory roll 1" + to,
              kTied + "case roll\nplaten c.n about 0 1 x -0.2 y 0.1 turn 0\nhistory roll 1\n");
  check_alike(kTied + "case roll travel 2 0 positions 4\npressure c.n {max(0, 1 - (x + 1)^2)}\nhistory roll 1; roll to 1\n",
              kTied + "case roll\npressure c.n {max(0, 1 - (x - 1)^2)}\nhistory roll 1\n");
}

TEST_CASE("moving loads: between two positions both act, with factors that add to the factor of the case") {
  const sketch::Sketch s =
      with_positions(read_whole(kTied.substr(0, kTied.find("steps")) +
                                "case press\npressure c.n 1\ncase roll round 0 0 positions 4\ntraction c.e fx 1\n"
                                "history press 3; roll 2; roll to 1.125; roll 1; roll to 0.5; press 2\nsteps 5 7 1 9\n"));
  REQUIRE(s.cases.size() == 5);
  // press, positions 1 to 4, increments
  const std::vector<std::vector<double>> expected = {{3, 0, 0, 0, 0, 5}, {3, 2, 0, 0, 0, 7},     {3, 0, 2, 0, 0, 1},
                                                     {3, 0, 0, 2, 0, 1}, {3, 0, 0, 0, 2, 1},     {3, 2, 0, 0, 0, 1},
                                                     {3, 1, 1, 0, 0, 1}, {3, 0.5, 0.5, 0, 0, 9}, {3, 1, 0, 0, 0, 1},
                                                     {3, 0, 0, 0, 1, 1}, {3, 0, 0, 1, 0, 1},     {2, 0, 0, 1, 0, 9}};
  REQUIRE(s.pieces == static_cast<int>(expected.size()));
  for (size_t p = 0; p < expected.size(); ++p) {
    CAPTURE(p);
    for (size_t c = 0; c < 5; ++c) CHECK(s.cases[c].factors[p] == doctest::Approx(expected[p][c]));
    CHECK(s.steps[p] == static_cast<int>(expected[p][5]));
  }
}

TEST_CASE("moving loads: several have shares, by a law of the angle or their own") {
  const auto total = [](const sketch::Sketch& s, int load_case, sketch::Point at) {
    double sum = 0;
    for (const sketch::Condition& c : s.conditions)
      if (c.load_case == load_case && c.kind == sketch::Condition::kPressure) sum += c.value_at(at).x;
    return sum;
  };
  const std::string body =
      "body b E 1 nu 0\ncircle rim centre 0 0 radius 2\nhole\ncircle bore centre 0 0 radius 1\nfix b.rim\n";
  const std::string load = "pressure b.bore {exp(4*x - 4)}\nhistory roll 1; roll to 1\n";
  const sketch::Sketch law = with_positions(
                           read_whole(body + "case roll round 0 0 positions 3 loads 4 shares {max(0, cos(a))}\n" + load)),
                       own =
                           with_positions(read_whole(body + "case roll round 0 0 positions 3 loads 4 shares 1 2 0 3\n" + load));
  CHECK(law.cases.size() == 3); // of one pitch
  CHECK(own.cases.size() == 12);
  for (int k = 0; k < 12; ++k)
    for (const double angle : {0.3, 2.0, 4.4}) {
      const sketch::Point at{std::cos(angle), std::sin(angle)};
      double by_law = 0, by_own = 0;
      for (int i = 0; i < 4; ++i) {
        const double turn = (k / 3.0 + i) * kPi / 2, one = std::exp(4 * std::cos(angle - turn) - 4);
        by_law += std::fmax(0, std::cos(turn)) * one;
        by_own += std::vector<double>{1, 2, 0, 3}[static_cast<size_t>(i)] * one;
      }
      if (k < 3) CHECK(total(law, k, at) == doctest::Approx(by_law).epsilon(1e-12));
      CHECK(total(own, k, at) == doctest::Approx(by_own).epsilon(1e-12));
    }
}

// next.md's ring walks by 0.550 um in a revolution of 96 positions, and backwards by 0.147 um in one of 24.
TEST_CASE("moving loads: a ring walks in its housing as another program had it") {
  const std::string ring =
      "parameter K 24\nbody ring E 210e3 nu 0.3\ncircle outer centre 0 0 radius 43\nhole\n"
      "circle bore centre 0 0 radius 40\nbody housing E 210e3 nu 0.3\ncircle rim centre 0 0 radius 60\nhole\n"
      "circle seat centre 0 0 radius 43\ncontact ring.outer housing.seat mu 0.2\nfix housing.rim\n"
      "case fit\npressure ring.bore 0.5\ncase roll round 0 0 positions K\n"
      "pressure ring.bore {400*max(0, cos(atan2(y, x)) - cos(25*deg))}\n"
      "history fit 1; roll 1; roll to 3\nfunctions quadratic\ntolerance off\n"
      "elements ring.outer 80\nelements housing.seat 80\nelements ring.bore 80\n";
  const std::vector<std::pair<int, double>> walks = {{24, -0.147e-3}, {96, 0.550e-3}};
  for (size_t i = 0; i < test::effort<size_t>(1, 2); ++i) {
    const auto [positions, walk] = walks[i];
    CAPTURE(positions);
    const test::Folder folder;
    test::write_file(folder / "ring.c2s", ring);
    const test::Result run =
        test::run_shell("'" + paths::program() + "' run -q '" + (folder / "ring.c2s") + "' K=" + std::to_string(positions) +
                        " --csv '" + (folder / "c.csv") + "'" + (i == 0 ? " --report '" + (folder / "r.html") + "'" : ""));
    REQUIRE_MESSAGE(run.status == 0, run.err);
    std::vector<double> sum, count; // of the steps: ut2 - ut1 of all pairs
    for (const std::string& line : test::lines_of(test::read_file(folder / "c.csv"))) {
      std::vector<std::string> columns;
      std::istringstream in(line);
      for (std::string column; columns.size() < 13 && std::getline(in, column, ',');) columns.push_back(column);
      if (columns.size() < 13 || columns[0] == "mu") continue;
      const size_t step = std::stoul(columns[1]);
      if (step >= sum.size()) sum.resize(step + 1), count.resize(step + 1);
      sum[step] += std::stod(columns[12]) - std::stod(columns[10]), ++count[step];
    }
    REQUIRE(sum.size() > static_cast<size_t>(2 * positions));
    const auto mean = [&](size_t step) { return sum[step] / count[step]; };
    const size_t last = sum.size() - 1;
    const std::string page =
        i == 0 ? test::read_file(folder / "r.html") : "traction, cases 2, 6, 10, ..."; // strokes, not cases
    CHECK(test::contains(page, "traction, cases 2, 6, 10, ..."));
    CHECK(!test::contains(page, "case 11"));
    CHECK(std::fabs(mean(last) - mean(last - static_cast<size_t>(positions)) - walk) < 1e-6);
  }
}

TEST_CASE("moving loads: positions are doubled until their number does not matter") {
  const std::string roller =
      "parameter K 4\nbody r E 1000 nu 0.3\nfrom -10 10\narc side to 10 10 radius 10\nline top close\n"
      "body b E 1000 nu 0.3\nfrom -10 -10\nline s to 10 -10\nline e to 10 0\nline n to -10 0\nline w close\n"
      "contact r.side b.n mu 0.3\nfix b.s\ncase press\nplaten r.top fy -100 turn 0\n"
      "case shake round 0 0 positions K\nplaten r.top fx 20 fy 0 turn 0\n"
      "history press 1; shake 1; shake to 1\nwant dissipation " +
      test::effort<std::string>("20 %", "10 %") + "\n";
  const test::Folder folder;
  test::write_file(folder / "r.c2s", roller);
  const auto run = [&](const std::string& more) {
    const test::Result done = test::run_shell("'" + paths::program() + "' run -q '" + (folder / "r.c2s") + "' " + more +
                                              " --json '" + (folder / "r.json") + "'");
    REQUIRE_MESSAGE(done.status == 0, done.err);
    return test::read_file(folder / "r.json");
  };
  const auto dissipated = [](const std::string& json) {
    const size_t at = json.rfind("\"quantity\": \"dissipated\"");
    REQUIRE(at != std::string::npos);
    const auto number = [&](const char* key) { return std::stod(json.substr(json.find(key, at) + std::string(key).size())); };
    return std::make_pair(number("\"value\": "), number("\"error\": "));
  };
  const std::string few = run(""), many = run("K=" + std::to_string(test::effort(16, 64)));
  const size_t at = few.find("\"positions\": ");
  REQUIRE(at != std::string::npos);
  CHECK(std::stoi(few.substr(at + 13)) >= 16);
  const auto [value, error] = dissipated(few);
  CHECK(error > 0);
  CHECK(error <= test::effort(0.2, 0.1) * value);
  CHECK(std::fabs(value - dissipated(many).first) < error);
  test::write_file(folder / "less.c2s", roller + "limit work 1e8\n"); // enough for a mesh, not for more positions on it
  const test::Result less = test::run_shell("'" + paths::program() + "' run -q '" + (folder / "less.c2s") + "'");
  CHECK(less.status == 5);
  CHECK_MESSAGE(test::contains(less.err, "dissipated: its error is unknown"), less.err);
  CHECK(test::contains(less.err, "more positions of the moving loads would exceed the work limit"));
}

TEST_CASE("moving loads: what is wrong has its place") {
  const std::string load = "pressure c.n {exp(-x^2)}\n", moves = "history roll 1; roll to 1\n";
  const auto fault = [&](const std::string& words, const std::string& rest) {
    return fault_of(kTied + "case roll " + words + "\n" + rest);
  };
  CHECK(fault("travel 2 0 positions 4", load + moves) == "none");
  has(fault("turns 2 0 positions 4", load + moves), "16:11 'turns': expected round, travel or along");
  has(fault("round 0 0", load + moves), "16:20 the statement ends here, expected positions and their number");
  has(fault("round 0 0 positions 2", load + moves), "16:31 fewer than three positions, expected at least 3");
  has(fault("round 0 0 positions 1 loads 2", load + moves), "expected at least 2");
  has(fault("travel 0 0 positions 4", load + moves), "16:20 the way has no length");
  has(fault("along c.n+e positions 4", load + moves), "several curves are named");
  has(fault("round 0 0 positions 4 loads 3 shares 1 2", load + moves), "expected the share of each load");
  has(fault("round 0 0 positions 4 loads 3 shares 0 0 0", load + moves), "16:1 all shares are 0 at position 1 of 12");
  has(fault("round 0 0 positions 4 loads 3 shares {1/(a - a)}", load + moves), "is not a finite number");
  has(fault("travel 9 0 positions 4", "pressure c.n {max(0, 1 - x^2)}\n" + moves),
      "17:1 the load has left its curves at position 3 of 5");
  has(fault("travel 2 0 positions 4", "pressure c.n {1/(x - 1)}\n" + moves), "no finite value");
  has(fault("travel 2 0 positions 4", "pressure c.n 3\n" + moves), "17:1 this pressure is the same in every position");
  has(fault("travel 2 0 positions 4", "move c.n x 1\n" + moves), "17:1 a displacement does not move");
  has(fault("travel 9 0 positions 4", "force c at 0 0.5 fx 1\n" + moves),
      "17:1 at position 3 of 5 the force acts at (4.5, 0.5)");
  CHECK(
      test::contains(fault("travel 2 0 positions 4", "weight c fy 1\n" + moves), "of the loads of a body its weight can turn"));
  has(fault("travel 2 0 positions 4", "platen c.n fx 1 fy 1\n" + moves), "can turn, not travel");
  has(fault("round 0 0 positions 4", "platen c.n fx 1 y 1\n" + moves), "what turns has two components");
  has(fault("travel 2 0 positions 4", load + "history roll 1\n"), "16:1 load case 'roll' never moves");
  has(fault("travel 2 0 positions 4", load + "history roll to 1; roll 1\n"), "moves while its factor is 0");
  has(fault("travel 2 0 positions 4", load + "history roll 1; roll to 1.5\n"),
      "18:25 1.5: expected a part of the course, from 0 to 1");
  has(fault("round 0 0 positions 4", load + "history roll 1; roll to 1e9\n"), "at most 10000 periods");
  has(fault_of(kTied + "case roll\n" + load + moves), "18:22 the loads of case 'roll' do not move");
  has(fault("travel 2 0 positions 4", load + moves + "case roll round 0 0 positions 4\n"), "'roll' has a course");
  has(fault_of("axisymmetric\nbody b E 1 nu 0\nfrom 0 0\nline s to 1 0\nline e to 1 1\nline n to 0 1\nfix "
               "b.s\ncase roll round 0 0 positions 4\n"),
      "do not go round in its half section");
}

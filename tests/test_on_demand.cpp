// Contact on demand: columns of the contact system are made when pairs are about to touch. Against the same models with all of
// the contact system formed.
#include "on_demand.hpp"

#include "paths.hpp"
#include "shell.hpp"
#include "solver_runs.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <memory>
#include <sstream>

using namespace demand;

TEST_CASE("on demand: a rough face as with the whole contact system, with friction and without" *
          doctest::skip(c2d::kSmallCode)) {
  for (double mu : {0.0, 0.3, 1.5}) {
    CAPTURE(mu);
    many::Model m = many::rough(300);
    m.friction = mu;
    check_alike(m, 100);
  }
}

TEST_CASE("on demand: functions of all orders" * doctest::skip(c2d::kSmallCode)) {
  for (int32_t nodes : {1, 3, 4}) {
    CAPTURE(nodes);
    check_alike(quadratic(many::rough(nodes == 1 ? 260 : 120), nodes), nodes == 1 ? 100 : 120);
  }
}

TEST_CASE("on demand: cyclic loads in two load cases, energies of each" * doctest::skip(c2d::kSmallCode)) {
  check_alike(pushed(many::rough(200)), 90);
}

TEST_CASE("on demand: unlike bodies, holes, nu = 1/2, body forces, point loads" * doctest::skip(c2d::kSmallCode)) {
  many::Model m = many::rough(200);
  m.body(1).youngs_modulus = 200, m.body(2).poisson_ratio = 0.45;
  for (double x : {0.3, 0.7})
    many::add_curve(m.body(1), 30, [x](double s, double& at, double& up) {
      at = x + 0.1 * std::cos(2 * 3.141592653589793 * s), up = -0.5 - 0.1 * std::sin(2 * 3.141592653589793 * s);
    });
  m.body(1).poisson_ratio = 0.5;
  m.body(2).force[1] = -0.01;
  m.point_loads.push_back({2, 0.5, 0.6, 0.01, -0.02});
  check_alike(m, 100);
}

TEST_CASE("on demand: a rigid body, two zones, overlaps that are closed" * doctest::skip(c2d::kSmallCode)) {
  SUBCASE("rigid") {
    many::Model m = many::rough(200);
    m.body(1).rigid = 1;
    check_alike(m, 100);
  }
  SUBCASE("zones") {
    many::Model m = many::rough(240);
    const many::Zone whole = m.zones[0];
    const int32_t half = 100;
    many::Zone left = whole, right = whole;
    left.side[0].last = left.side[0].first + half - 1;
    left.side[1].last = left.side[1].first - half + 1;
    right.side[0].first = left.side[0].last + 2, right.side[1].first = left.side[1].last - 2; // one element apart
    right.mu = 0.7;
    m.zones = {left, right};
    check_alike(m, 100);
  }
}

TEST_CASE("on demand: a part of the face that touches from the start, friction told after a preparation without" *
          doctest::skip(c2d::kSmallCode)) {
  many::Model m = many::rough(300);
  for (int32_t i = 100; i < 140; ++i) m.body(2).xy[2 * static_cast<size_t>(i) + 1] = 0;
  m.set(2, 3, many::end_of("1100", 0, 0, 2e-5, -5e-5));
  SUBCASE("touches") { check_alike(m, 120); }
  SUBCASE("told") {
    m.friction = 0;
    many::Machine whole(m), own(on_demand(m, 120));
    std::vector<double> result[2];
    for (int k = 0; k < 2; ++k) {
      c2d_solver* const s = (k == 0 ? whole : own).solver;
      REQUIRE(c2d_prepare(s) == C2D_OK);
      for (const double mu : {0.0, 0.4}) {
        REQUIRE(c2d_begin(s, &mu, 1) == C2D_OK);
        const double all = 1;
        c2d_outcome outcome = C2D_UNDECIDED;
        REQUIRE(c2d_advance(s, &all, 1, &outcome) == C2D_OK);
        CHECK(outcome == C2D_REACHED);
        for (const int32_t field : {C2D_TN, C2D_TT, C2D_STATUS}) {
          std::vector<double> of(300);
          REQUIRE(c2d_get(s, field, 0, 1, 300, of.data(), 1) == C2D_OK);
          result[k].insert(result[k].end(), of.begin(), of.end());
        }
      }
    }
    double size = 0, apart_by = 0;
    for (size_t i = 0; i < result[0].size(); ++i)
      size = std::max(size, std::fabs(result[0][i])), apart_by = std::max(apart_by, std::fabs(result[0][i] - result[1][i]));
    CHECK(apart_by < kNear * size);
    CHECK(std::any_of(result[0].begin() + 4 * 300, result[0].begin() + 5 * 300, [](double q) { return q != 0; }));
  }
}

TEST_CASE("on demand: points inside, the residual and forces are those of the state" * doctest::skip(c2d::kSmallCode)) {
  const many::Model m = many::rough(200);
  many::Machine whole(m), own(on_demand(m, 100));
  const many::Result a = whole.run(), b = own.run();
  REQUIRE(b.status == C2D_OK);
  std::vector<double> xy, in[2];
  for (int k = 0; k < 40; ++k) xy.insert(xy.end(), {0.02 + 0.024 * k, -0.01 - 0.02 * k});
  for (int k = 0; k < 2; ++k) {
    in[k].resize(40 * C2D_POINT_FIELDS);
    REQUIRE(c2d_interior((k == 0 ? whole : own).solver, 1, 40, xy.data(), 2, in[k].data(), C2D_POINT_FIELDS) == C2D_OK);
  }
  double size = 0, apart_by = 0;
  for (size_t i = 0; i < in[0].size(); ++i) {
    if (i % C2D_POINT_FIELDS < C2D_POINT_SXX) continue;
    size = std::max(size, std::fabs(in[0][i])), apart_by = std::max(apart_by, std::fabs(in[0][i] - in[1][i]));
  }
  CHECK(apart_by < 10 * kNear * size);
  CHECK(b.summary.compression_residual > 0);
  CHECK(b.summary.compression_residual < (kIsDouble ? 1e-10 : 1e-3));
  REQUIRE(a.bodies.size() == b.bodies.size());
  for (size_t k = 0; k < a.bodies.size(); ++k)
    for (int c = 0; c < 3; ++c) CHECK(a.bodies[k].contact[c] == doctest::Approx(b.bodies[k].contact[c]).epsilon(1e-7));
}

// ---- where there is no room --------------------------------------------------------------------------------------------

TEST_CASE("on demand: too many pairs end the path with what would do, and that does" * doctest::skip(c2d::kSmallCode)) {
  many::Model m = on_demand(many::rough(300), 80); // 160 columns
  m.set(2, 3, many::end_of("1100", 0, 0, 0, -6e-4));
  many::Machine machine(m);
  REQUIRE(machine.status == C2D_OK);
  const many::Result stopped = machine.run();
  CHECK(stopped.status == C2D_ERR_MEMORY);
  c2d_error last = C2D_INIT(c2d_error);
  c2d_last_error(machine.solver, &last);
  CHECK(last.bytes_needed > 0);
  CHECK(std::string(last.text).find("than the 80 of c2d_limits.touching; room for 160 takes ") != std::string::npos);
  uint64_t minimum = 0;
  std::vector<c2d_body_limits> list;
  many::Model more = m;
  more.touching = 160;
  const c2d_limits limits = many::limits_of(more, list);
  REQUIRE(c2d_memory_need(&limits, &minimum, nullptr, nullptr) == C2D_OK);
  CHECK(last.bytes_needed == minimum);
  // The state that was reached is whole, and the same is said again.
  const many::Result here = machine.look();
  CHECK(here.status == C2D_OK);
  const double target = 1;
  c2d_outcome outcome = C2D_REACHED;
  CHECK(c2d_advance(machine.solver, &target, 1, &outcome) == C2D_ERR_MEMORY);
  check_alike(
      [&] {
        many::Model whole = m;
        whole.elimination = whole.touching = 0;
        return whole;
      }(),
      160);
}

TEST_CASE("on demand: more pairs than there is room for at the start, and no state is left to go on with" *
          doctest::skip(c2d::kSmallCode)) {
  many::Model m = on_demand(many::rough(300), 80);
  for (int32_t i = 50; i < 250; ++i) m.body(2).xy[2 * static_cast<size_t>(i) + 1] = 0;
  many::Machine machine(m);
  REQUIRE(c2d_prepare(machine.solver) == C2D_OK);
  const double mu = 0.3, all = 1;
  c2d_outcome outcome = C2D_REACHED;
  CHECK(c2d_begin(machine.solver, &mu, 1) == C2D_ERR_MEMORY);
  CHECK(c2d_get_state(machine.solver) == C2D_STATE_PREPARED);
  CHECK(c2d_advance(machine.solver, &all, 1, &outcome) == C2D_ERR_STATE);
  CHECK(c2d_run(machine.solver, nullptr, nullptr) == C2D_ERR_MEMORY);
  CHECK(c2d_get_state(machine.solver) == C2D_STATE_PREPARED);
  CHECK(c2d_begin(machine.solver, &mu, 1) == C2D_ERR_MEMORY);
}

TEST_CASE("on demand: what cannot be so is refused by name, what is small is formed whole" * doctest::skip(c2d::kSmallCode)) {
  const auto refused = [](many::Model m) {
    many::Machine machine(m);
    REQUIRE(machine.status == C2D_OK);
    const many::Result r = machine.run();
    CHECK(r.status == C2D_ERR_LIMIT);
    CHECK(c2d_get_state(machine.solver) == C2D_STATE_MODEL);
    CHECK_MESSAGE(r.told_of("cannot be on demand"), r.messages());
  };
  many::Model m = on_demand(many::rough(200), 80), other = m;
  other.elimination = C2D_ELIMINATION_DENSE;
  refused(other);
  other = m;
  other.set(2, 3, many::end_of(many::kPulled, 0, -1e-3));
  other.friction = 0; // along x it is held by hardly anything
  refused(other);
  refused(hinged(m, 1e-4));
  other = m;
  other.zones[0].kind = C2D_ZONE_TIED;
  refused(other);
  // By size it is compressed.
  other = m;
  other.elimination = C2D_ELIMINATION_BY_SIZE;
  many::Machine by_size(other);
  CHECK(by_size.run().status == C2D_OK);
  CHECK(by_size.solver->made > 0);
  // No more pairs than there is room for.
  other = on_demand(many::rough(90), 90);
  many::Machine small(other);
  CHECK(small.run().status == C2D_OK);
  CHECK(small.solver->model.columns == 0);
  // The deck's own stepping has all pairs awake.
  many::Machine deck(m, 0, C2D_STEPPING_DECK);
  CHECK(deck.run().status == C2D_ERR_MEMORY);
  // A limit that cannot be meant.
  std::vector<c2d_body_limits> list;
  c2d_limits limits = many::limits_of(m, list);
  limits.touching = 201;
  c2d_error why = C2D_INIT(c2d_error);
  CHECK(c2d_memory_need(&limits, nullptr, nullptr, &why) == C2D_ERR_ARGUMENT);
  CHECK(std::string(why.text).find("touching") != std::string::npos);
}

TEST_CASE("on demand: a face that never touches" * doctest::skip(c2d::kSmallCode)) {
  many::Model m = many::rough(200);
  m.set(2, 3, many::end_of("1100", 0, 0, 0, 1e-4));
  m.body(2).force[1] = -0.01;
  check_alike(m, 100);
}

// ---- saved, moved, failing, cut off ------------------------------------------------------------------------------------

namespace {

many::Model little() { return on_demand(many::rough(100), 80); }

} // namespace

TEST_CASE("on demand: a state saved on the way is taken up by another process, moved memory goes on; same bits" *
          doctest::skip(c2d::kSmallCode)) {
  Host first(little());
  REQUIRE(first.begin() == C2D_OK);
  REQUIRE(first.go(0.4) == C2D_OK);
  const int32_t made = first.solver()->made;
  CHECK(made > 2);
  REQUIRE(c2d_save(first.solver()) == C2D_OK);
  runs::RamStore kept = first.own;
  const runs::Bytes image = first.machine->workspace();
  REQUIRE(first.go(1) == C2D_OK);
  CHECK(first.solver()->made > made);
  const std::vector<double> expected = first.results();

  Host second(little(), &kept);
  REQUIRE(c2d_restore(second.solver()) == C2D_OK);
  CHECK(second.solver()->made == made);
  REQUIRE(second.go(1) == C2D_OK);
  CHECK(second.results() == expected);
  CHECK(second.machine->guards_are_whole());
  // Back to what was saved, in the same solver.
  REQUIRE(c2d_restore(second.solver()) == C2D_OK);
  REQUIRE(second.go(1) == C2D_OK);
  CHECK(second.results() == expected);
  // Limits with room for another number of columns are of another run.
  many::Model other = little();
  other.touching = 85;
  Host third(other, &kept);
  const c2d_status refused = c2d_restore(third.solver());
  CHECK((refused == C2D_ERR_MISMATCH || refused == C2D_ERR_STORE_FORMAT));
  other = little();
  other.touching = 0;
  Host fourth(other, &kept);
  CHECK(c2d_restore(fourth.solver()) != C2D_OK);

  runs::RamStore before = first.own; // (columns that were made since are there, too)
  std::vector<unsigned char> memory(image.size() + 64);
  unsigned char* const at = memory.data() + 24;
  std::memcpy(at, image.data(), image.size());
  c2d_port port = first.port;
  c2d_solver* moved = nullptr;
  REQUIRE(c2d_attach(&moved, at, image.size(), &port, nullptr) == C2D_OK);
  c2d_outcome outcome = C2D_REACHED;
  const double all = 1;
  REQUIRE(c2d_advance(moved, &all, 1, &outcome) == C2D_OK);
  std::vector<double> tn(100);
  REQUIRE(c2d_get(moved, C2D_TN, 0, 1, 100, tn.data(), 1) == C2D_OK);
  CHECK(std::equal(tn.begin(), tn.end(), expected.begin()));
  CHECK(c2d_close(moved) == C2D_OK);
}

TEST_CASE("on demand: numbers of columns that a stranger wrote into a state are refused" * doctest::skip(c2d::kSmallCode)) {
  Host first(little());
  REQUIRE(first.begin() == C2D_OK);
  REQUIRE(first.go(0.6) == C2D_OK);
  c2d_solver* s = first.solver();
  c2d::Pair* const pairs = c2d::array_of<c2d::Pair>(s, c2d::kPairs);
  int32_t awake = 0;
  while (pairs[awake].status == C2D_OPEN) ++awake;
  const auto saved_with = [&](int32_t& number, int32_t forged) {
    const int32_t kept = number;
    number = forged;
    REQUIRE(c2d_save(s) == C2D_OK);
    number = kept;
    runs::RamStore copy = first.own;
    Host second(little(), &copy);
    return c2d_restore(second.solver());
  };
  for (int32_t forged : {160, -2, 1 << 30}) {
    if (forged != 160 && !test::in_full()) break;
    CAPTURE(forged);
    CHECK(saved_with(pairs[awake].made, forged) == C2D_ERR_STORE_FORMAT);
    CHECK(saved_with(s->made, forged == 160 ? 161 : forged) == C2D_ERR_STORE_FORMAT);
  }
  CHECK(saved_with(pairs[awake].made, -1) == C2D_ERR_STORE_FORMAT); // it is awake
  CHECK(saved_with(s->made, s->made) == C2D_OK);
}

TEST_CASE("on demand: a store that fails at any operation is told, and nothing is made up" * doctest::skip(c2d::kSmallCode)) {
  check_failing_store(little(), 8);
}

TEST_CASE("on demand: cancelled at any chance it goes on to the same bits" * doctest::skip(c2d::kSmallCode)) {
  check_cancelled(little());
}

// ---- the program ----------------------------------------------------------------------------------------------------------

namespace {

// Tables of numbers between commas and ends of lines, but for their last digits.
bool same_numbers(const std::string& one, const std::string& other) {
  std::istringstream a(one), b(other);
  std::string line, other_line;
  int numbers = 0;
  while (std::getline(a, line)) {
    if (!std::getline(b, other_line)) return false;
    std::istringstream x(line), y(other_line);
    for (std::string word, other_word; std::getline(x, word, ',') && std::getline(y, other_word, ',');) {
      char *end = nullptr, *other_end = nullptr;
      const double p = std::strtod(word.c_str(), &end), q = std::strtod(other_word.c_str(), &other_end);
      if (end == word.c_str()) {
        if (word != other_word) return false;
      } else {
        ++numbers;
        if (std::fabs(p - q) > 1e-6 * std::max(std::fabs(p), std::fabs(q)) + 1e-9) return false;
      }
    }
  }
  return numbers > 1000;
}

} // namespace

TEST_CASE("on demand: the program's option" * doctest::skip(c2d::kSmallCode)) {
  const test::Folder folder;
  std::vector<int32_t> order;
  std::ofstream(folder / "rough.dat") << many::deck_of(many::rough(200), "rough", order);
  const auto run = [&](const std::string& words) {
    return test::run_shell("cd '" + folder.path() + "' && '" + paths::program() + "' " + words);
  };
  const test::Result check = run("check rough.dat --touching 90"), whole = run("check rough.dat");
  CHECK(check.out.find("contact on demand           room for 90 pairs in or near contact\n") != std::string::npos);
  CHECK(check.out.find("elimination                 compressed") != std::string::npos);
  CHECK(whole.out.find("contact on demand") == std::string::npos);
  REQUIRE(run("run rough.dat -q --touching 90 --csv a.csv --json a").status == 0);
  REQUIRE(run("run rough.dat -q --csv b.csv --json b").status == 0);
  CHECK(test::read_file(folder / "a").find("\"elimination\": \"compressed") != std::string::npos);
  CHECK(same_numbers(test::read_file(folder / "a.csv"), test::read_file(folder / "b.csv")));
  for (const char* wrong : {"-1", "x", "3.5", ""}) {
    const test::Result out = run(std::string("run rough.dat --touching '") + wrong + "'");
    CHECK(out.status == 64);
    CHECK_MESSAGE(out.err.find("--touching") != std::string::npos, out.err);
  }
  const test::Result dense = run("run rough.dat --touching 90 --elimination dense");
  CHECK(dense.status == 2);
  CHECK_MESSAGE(dense.err.find("cannot be on demand") != std::string::npos, dense.err);
  const test::Result few = run("run rough.dat --touching 1 --memory 300M --stepping deck");
  CHECK(few.status == 4);
  CHECK_MESSAGE(few.err.find("of c2d_limits.touching; room for 160 takes ") != std::string::npos, few.err);
  REQUIRE(run("run rough.dat --touching 160 -q --csv c.csv").status == 0); // (there was room for 80 with 1)
  CHECK(same_numbers(test::read_file(folder / "c.csv"), test::read_file(folder / "b.csv")));
  CHECK(few.err.find("--elimination dense takes less memory") == std::string::npos);
}

TEST_CASE("on demand: by size, and from the beginning with the whole contact where that cannot be" *
          doctest::skip(c2d::kSmallCode)) {
  const test::Folder folder;
  std::vector<int32_t> order;
  many::Model m = many::rough(1501);
  std::ofstream(folder / "held.dat") << many::deck_of(m, "held", order);
  std::ofstream(folder / "hinged.dat") << many::deck_of(hinged(m, 1e-5), "hinged", order);
  m.set(2, 3, many::end_of(many::kPulled, 0, -0.01));
  std::ofstream(folder / "free.dat") << many::deck_of(m, "free", order);
  const auto run = [&](const std::string& words) {
    return test::run_shell("cd '" + folder.path() + "' && '" + paths::program() + "' " + words);
  };
  const test::Result check = run("check held.dat");
  CHECK_MESSAGE(check.out.find("room for 300 pairs") != std::string::npos, check.out);
  CHECK(run("check held.dat --elimination dense").out.find("room for") == std::string::npos);
  CHECK(run("check - <held.dat").out.find("room for") == std::string::npos); // (it could not begin anew)
  CHECK(check.out.find("compressed (contact on demand)\n") != std::string::npos);
  for (const std::string name : {"held", "free"}) {
    const test::Result there = run("run " + name + ".dat --json " + name);
    CHECK_MESSAGE(there.status == 0, there.err);
    CHECK_MESSAGE(there.err.find("restarts from the beginning") == std::string::npos, there.err);
    CHECK(test::read_file(folder / name).find("\"elimination\": \"compressed") != std::string::npos);
  }
  const test::Result hinge = run("run hinged.dat --json hinged");
  CHECK_MESSAGE(hinge.status == 0, hinge.err);
  CHECK_MESSAGE(hinge.err.find("the contact cannot be on demand; the run restarts from the beginning") != std::string::npos,
                hinge.err);
  CHECK(hinge.err.find("error") == std::string::npos);
}

// Every kind of model ended at one of its steps and taken up by another solver: the same bytes and the same messages.
#include "family_runs.hpp"
#include "is_resumed.hpp"
#include "memory/config.hpp"
#include "shell.hpp"

#include <doctest/doctest.h>

#include <string>

using interrupted::also_with;
using interrupted::is_resumed;
using interrupted::Job;
using interrupted::job_of;

namespace {

using many::end_of;
using many::Model;

Job by_deck_stepping(Job job) {
  job.options.stepping = C2D_STEPPING_DECK;
  return job;
}

Job in_little_memory(Job job) {
  job.in_core = false;
  return job;
}

Job family(const std::string& name, const std::vector<std::string>& settings) {
  std::string deck, error;
  REQUIRE_MESSAGE(families::make_deck(name, settings, deck, error), error);
  return job_of(deck);
}

// A block on a foundation that is held below, pressed down and to the right, pushed back, pressed again.
Model block(int32_t kind = C2D_ZONE_MATCHING) {
  Model m;
  m.add(many::rectangle(-1, -2, 3, 0, {6, 3, 8, 3}));
  m.add(many::rectangle(0, 0, 2, 1, {4, 3, 4, 3}, 400, 0.25));
  m.set(1, 1, end_of(many::kHeld));
  const many::Range top = m.side(1, 3), low = m.side(2, 1);
  m.zones.push_back({kind, {{1, top.first + 2, top.first + 5}, {2, low.last, low.first}}});
  m.set(2, 3, end_of("1100", 0, 0, 0.004, -0.01));
  m.friction = 0.3;
  m.paths = {{2, 1.0}, {2, 0.4}, {1, 0.9}};
  return m;
}
Model with_platen(Model m) {
  m.set(2, 3, end_of(many::kPulled));
  many::Platen& p = m.move(2, 3);
  p.load[0] = 0.5, p.load[1] = -3, p.load[2] = 0.2;
  p.point[0] = p.point[1] = 1;
  return m;
}
// A second block is tied on the first, and pressed.
Model with_tie(int32_t kind) {
  Model m = block(kind);
  m.set(2, 3, end_of(many::kPulled));
  m.add(many::rectangle(0, 1, 2, 1.5, {4, 2, 4, 2}, 2000, 0.2));
  m.set(3, 3, end_of(many::kPulled, 0.4, -3));
  m.join(kind + C2D_ZONE_TIED, 2, 3, 3, 1);
  return m;
}
Model with_two_load_cases(Model m) {
  m.cases = 2;
  for (many::Body& b : m.bodies) b.second = b.ends;
  m.set_second(2, 3, end_of("1100", 0, 0, -0.003, 0));
  m.paths = {{2, 1.0, 0.0}, {2, 1.0, 1.0}, {1, 0.6, -0.5}};
  return m;
}
// The foundation stands still, or the block is rigid and carries a force.
Model with_rigid(int32_t body) {
  Model m = block(C2D_ZONE_FREE);
  m.body(body).rigid = 1;
  if (body == 1) return m;
  m = with_swapped_sides(m, 1);
  m.set(2, 3, end_of(many::kPulled));
  many::Body& b = m.body(2);
  for (int32_t& free : b.is_free) free = 1;
  b.load[0] = 0.3, b.load[1] = -2, b.point[0] = b.point[1] = 1;
  return m;
}
Model above(Model m, double gap) {
  for (size_t i = 1; i < m.body(2).xy.size(); i += 2) m.body(2).xy[i] += gap;
  return m;
}
Model with_overlap() {
  Model m = above(block(), -0.002);
  m.set(2, 3, end_of("1100", 0, 0, 0.004, -0.002));
  m.cases = m.interference = 2;
  for (many::Body& b : m.bodies) b.second = b.ends;
  m.set_second(2, 3, end_of("1100"));
  return m;
}
// A slot closes.
Model slotted_block() {
  Model m;
  m.function_nodes = 3;
  m.add(
      many::polygon({{0, 0, 6}, {4, 0, 2}, {4, 0.95, 5}, {1, 0.95, 1}, {1, 1.05, 5}, {4, 1.05, 2}, {4, 2, 6}, {0, 2, 4}}, 100));
  m.set(1, 1, end_of(many::kPulled, 0.1, 1.2));
  m.set(1, 7, end_of(many::kPulled, 0, -1.2));
  m.set(1, 8, end_of(many::kHeld));
  m.join(C2D_ZONE_MATCHING + C2D_ZONE_SELF, 1, 3, 1, 5);
  m.friction = 0.3;
  m.paths = {{4, 1.0}};
  return m;
}
Model of_order(Model m, int32_t function_nodes) {
  m.function_nodes = function_nodes;
  for (many::Body& b : m.bodies) {
    std::vector<many::End> ends;
    for (size_t e = 0; e < b.ends.size(); e += 2) ends.insert(ends.end(), static_cast<size_t>(function_nodes), b.ends[e]);
    b.ends = ends;
  }
  return m;
}
Model compressed(Model m, int32_t touching) {
  m.elimination = C2D_ELIMINATION_COMPRESSED;
  m.touching = touching;
  m.paths = {{2, 1.0}, {1, 0.5}};
  return m;
}

const int32_t kKinds[] = {C2D_ZONE_MATCHING, C2D_ZONE_FREE};

} // namespace

TEST_CASE("interrupted: ties and platens") {
  for (const int32_t kind : kKinds) {
    is_resumed("a tie", job_of(with_tie(kind)));
    is_resumed("a tie and two coefficients", also_with(0.1, job_of(with_tie(kind))));
    is_resumed("a tie, smooth at first", also_with(0, job_of(with_tie(kind))));
    is_resumed("a platen", job_of(with_platen(block(kind))));
  }
  is_resumed("a platen and two coefficients", also_with(0.6, job_of(with_platen(block()))));
  is_resumed("a platen, stepping of decks", by_deck_stepping(job_of(with_platen(block()))));
  is_resumed("a tie, little memory", in_little_memory(job_of(with_tie(C2D_ZONE_MATCHING))));
  is_resumed("a tie and no contact", family("bimaterial", {"n=4"}), 1);
  is_resumed("a tie and contact by a family", family("coating", {"n=3", "L=8", "ratio=2"}), 1);
}

TEST_CASE("interrupted: friction, smooth contact, load cases, orders") {
  for (const int32_t kind : kKinds) is_resumed("friction", job_of(block(kind)));
  Model smooth = block();
  smooth.friction = 0;
  smooth.zones[0].mu = 0;
  is_resumed("smooth", job_of(smooth));
  smooth.zones[0].mu = -1;
  is_resumed("smooth, then rough", also_with(0, job_of(block())));
  is_resumed("rough, then smooth", also_with(0.4, job_of(smooth)));
  is_resumed("adhesion, then friction", also_with(HUGE_VAL, job_of(block())));
  is_resumed("two load cases", job_of(with_two_load_cases(block())));
  is_resumed("two load cases and coefficients", also_with(0.8, job_of(with_two_load_cases(block()))));
  is_resumed("stepping of decks", by_deck_stepping(job_of(with_two_load_cases(block()))));
  for (const int32_t nodes : {1, 3, 4}) is_resumed("functions of another order", job_of(of_order(block(), nodes)));
}

TEST_CASE("interrupted: rigid bodies, body forces, overlaps, self-contact, symmetry") {
  is_resumed("a rigid foundation", job_of(with_rigid(1)));
  is_resumed("a rigid block with a force", job_of(with_rigid(2)));
  Model heavy = block();
  heavy.body(2).force[1] = -0.5;
  heavy.point_loads.push_back({2, 0.5, 0.5, 0.1, -0.2});
  is_resumed("weight and a point load", job_of(heavy));
  is_resumed("overlaps", job_of(with_overlap()));
  is_resumed("self-contact", job_of(slotted_block()));
  is_resumed("a line of symmetry", family("hertz", {"n=4", "L=5", "ratio=2"}), 1);
  is_resumed("a press fit", family("shrink", {"n=4"}), 1);
}

TEST_CASE("interrupted: paths that stop, that cannot begin, that begin apart") {
  Model loose = with_platen(block());
  loose.platens[0].load[0] = 2;
  is_resumed("it slides away", job_of(loose), 1);
  is_resumed("it slides away, then it does not", also_with(0.2, job_of(with_platen(block()))));
  for (const double gap : {0.001, 0.02}) is_resumed("a gap", job_of(above(block(), gap)));
  is_resumed("a gap below a platen", job_of(above(with_platen(block()), 0.01)), 1);
  loose.platens[0].load[1] = 3;
  is_resumed("it is pulled off", job_of(loose), 1);
  Model lifted = block();
  lifted.paths = {{1, 1.0}, {2, -1.0}, {2, 0.8}};
  is_resumed("lifted and put back", job_of(lifted));
  lifted.set(2, 3, end_of("0110", 0, 0, 0, -0.01));
  is_resumed("lifted while it is free sideways", job_of(lifted));
  for (const char* name : {"W3_lifted_free_in_x_1-116", "F5_lets_go_of_friction", "nonunique_9", "D2_unload_3-41"})
    is_resumed(name, job_of(test::read_file(paths::root() + "/tests/data/hard/" + name + ".dat")), 1);
}

TEST_CASE("interrupted: compressed bodies, contact on demand" * doctest::skip(c2d::kSmallCode)) {
  for (const int32_t touching : {0, 40}) {
    Job job = job_of(compressed(many::rough(40), touching));
    job.bytes = 4 << 20;
    is_resumed("compressed, with columns on demand where there are any", job, 3, 2);
    is_resumed("the same with two coefficients", also_with(0.1, job), 6, 2);
  }
}

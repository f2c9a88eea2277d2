// What a mesh that the loop solved leaves in a store: a run of the same model need not prepare again.
#include "paths.hpp"
#include "shell.hpp"

#include "program/estimate/trial.hpp"
#include "program/session.hpp"

#include <doctest/doctest.h>

namespace {

app::StoreChoice& store_of(void* context) { return *static_cast<app::StoreChoice*>(context); }

// The first mesh of a sketch.
std::string deck_of(const std::string& sketch) {
  app::DeckFile file;
  app::MeshLoop loop;
  const std::vector<std::string> none;
  file.replace(sketch);
  REQUIRE(app::take_sketch(file, {none, false}, loop) == 0);
  return file.text();
}

// Another run of that deck in the same store.
c2d_status restore(const std::string& deck, app::StoreChoice& store, double* force) {
  app::Session session;
  const std::vector<std::string> none;
  REQUIRE(session.read_text("deck", deck, {none}) == 0);
  REQUIRE(session.take_memory(0, C2D_ELIMINATION_BY_SIZE) == 0);
  c2d_port port = C2D_INIT(c2d_port);
  port.context = &store;
  app::connect<store_of>(port);
  REQUIRE(session.read_model(port) == 0);
  const c2d_status status = c2d_restore(session.solver);
  if (status != C2D_OK) return status;
  c2d_outcome outcome = C2D_UNDECIDED;
  const double load = 1, mu = 0;
  REQUIRE(c2d_begin(session.solver, &mu, 1) == C2D_OK);
  REQUIRE(c2d_advance(session.solver, &load, 1, &outcome) == C2D_OK);
  c2d_zone_state zone = C2D_INIT(c2d_zone_state);
  REQUIRE(c2d_get_zone_state(session.solver, 1, &zone) == C2D_OK);
  *force = zone.force[1];
  return outcome == C2D_REACHED ? status : c2d_status{C2D_ERR_INTERNAL};
}

std::string with(std::string text, const std::string& what, const std::string& instead) {
  const size_t at = text.find(what);
  REQUIRE(at != std::string::npos);
  return text.replace(at, what.size(), instead);
}

} // namespace

TEST_CASE("trial: a run of the same model takes up what a mesh has left, whatever the lines of its cards") {
  const std::string deck = deck_of(test::read_file(paths::root() + "/examples/families/hertz.c2s"));
  app::StoreChoice store;
  estimate::Demand demand;
  demand.store = &store;
  estimate::Trial trial;
  std::string why;
  REQUIRE(estimate::solve(deck, demand, trial, why) == C2D_OK);
  CHECK(store.bytes_in_memory() > 0);
  CHECK(store.file_of(C2D_TAPE_UPPER) == "");
  double force = 0, moved = 0;
  CHECK(restore(deck, store, &force) == C2D_OK);
  CHECK(force != 0);
  CHECK(restore(with(deck, "\n*ZONE", "\n! a line more\n*ZONE"), store, &moved) == C2D_OK);
  CHECK(moved == force);
  CHECK(restore(with(deck, " 1000 0.3", " 1001 0.3"), store, &moved) == C2D_ERR_MISMATCH);
  estimate::Trial again; // in the same memory
  REQUIRE(estimate::solve(deck, demand, again, why) == C2D_OK);
  REQUIRE(again.states.size() == trial.states.size());
  CHECK(again.states.back().work == trial.states.back().work);
  CHECK(again.states.back().ends[0][estimate::kHoop].empty()); // nobody has asked for them
  store.drop_tapes();
  CHECK(store.bytes_in_memory() == 0);
}

// Rare decks with every element bisected: open curves one after the other, many coefficients, a solver at work.
#include "paths.hpp"
#include "shell.hpp"

#include "program/estimate/mesh/halved.hpp"
#include "program/session.hpp"

#include <c2d_posix.h>
#include <doctest/doctest.h>

#include <cmath>

using namespace test;

namespace {

const std::string kProgram = "'" + paths::program() + "' ";

app::StoreChoice& store_of(void* context) { return *static_cast<app::StoreChoice*>(context); }

} // namespace

TEST_CASE("halved edges: more than five coefficients go on in another card") {
  const Folder folder;
  std::string deck = run_shell(kProgram + "make cylinder_friction n=4").out;
  const std::string one = "1 0.4";
  const size_t at = deck.find("\n" + one + "\n");
  if (at == std::string::npos) FAIL(deck.substr(0, 800));
  deck.replace(at + 1, one.size(), "7 0.1 0.2 0.3 0.4 0.5\n0.6 0.7");
  write_file(folder / "d.dat", deck);
  const Result halved = run_shell(kProgram + "mesh --halve '" + (folder / "d.dat") + "'");
  REQUIRE_MESSAGE(halved.status == 0, halved.err);
  CHECK(contains(halved.out, "7 0.1 0.2 0.3 0.4 0.5\n 0.6 0.7\n"));
  write_file(folder / "h.dat", halved.out);
  const Result run = run_shell(kProgram + "run '" + (folder / "h.dat") + "' -q --summary -");
  CHECK_MESSAGE(run.status == 0, run.err);
}

TEST_CASE("halved edges: the deck is that of the model, whatever its solver has done") {
  const std::string deck = read_file(paths::data() + "/decks/sample.dat");
  app::Session session;
  const std::vector<std::string> none;
  std::string error;
  REQUIRE(session.read_text("deck", deck, {none}) == 0);
  REQUIRE(session.take_memory(0, C2D_ELIMINATION_BY_SIZE) == 0);
  app::StoreChoice store;
  REQUIRE(store.choose("memory", 0, false, error));
  c2d_port port = C2D_INIT(c2d_port);
  port.context = &store;
  app::connect<store_of>(port);
  REQUIRE(session.read_model(port) == 0);
  const std::string first = estimate::halved_deck(session.solver, session.deck.text(), error);
  CHECK(error.empty());
  REQUIRE(c2d_prepare(session.solver) == C2D_OK);
  CHECK(estimate::halved_deck(session.solver, session.deck.text(), error) == first);
  const double mu = 0.1;
  REQUIRE(c2d_begin(session.solver, &mu, 1) == C2D_OK);
  CHECK(estimate::halved_deck(session.solver, session.deck.text(), error) == first);
  CHECK(error.empty());
}

// Models drawn at random in forms that must not matter, and interrupted.
#include "is_resumed.hpp"
#include "lifted_block.hpp"
#include "random/forms.hpp"
#include "random/resumed.hpp"
#include "random/three_bodies.hpp"
#include "solver_runs.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace lifted;
using interrupted::job_of;

TEST_CASE("let go: equivalent decks have the same place") {
  random_decks::Model model;
  model.problem = from_text(hard("W3_lifted_free_in_x_1-116"));
  model.same_surfaces = true;
  const Result deck = solve(model.problem);
  REQUIRE(deck.outcome == C2D_REACHED);
  CHECK(no_force(deck.recorded().back()));
  REQUIRE(told(deck) != nullptr);
  CHECK_FALSE(deck.warned(C2D_WARN_NOT_UNIQUE));
  for (uint64_t seed = 1; seed <= 3; ++seed)
    for (const random_decks::Form& form : random_decks::forms_of(model, seed)) {
      CAPTURE(form.name);
      const Result other = solve(form.problem, form.setup);
      CHECK(random_decks::difference(model, deck, form, other) == "");
      CHECK(told(other) != nullptr);
    }
}

TEST_CASE("let go: blocks on blocks of many shapes, in all their forms") {
  int said = 0;
  for (const uint64_t seed : {3u, 9u, 12u, 40u, 56u, 77u, 101u, 122u, 152u, 180u, 222u, 251u}) {
    CAPTURE(seed);
    random_decks::Model model;
    model.problem = drawn(seed);
    const Result r = solve(model.problem);
    REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
    CHECK((r.outcome == C2D_REACHED || r.outcome == C2D_GROSS_SLIDING));
    CHECK(coulomb_breach(model.problem, r) == "");
    said += told(r) != nullptr;
    for (const random_decks::Form& form : random_decks::forms_of(model, seed)) {
      CAPTURE(form.name);
      const Result other = solve(form.problem, form.setup);
      if (r.warned(C2D_WARN_NOT_UNIQUE) && other.warned(C2D_WARN_NOT_UNIQUE)) continue;
      CHECK(random_decks::difference(model, r, form, other) == "");
    }
  }
  CHECK(said > 9);
}

TEST_CASE("interrupted: random models of three bodies") {
  for (uint64_t seed = 1; seed <= 12; ++seed) {
    std::string title;
    const many::Model m = random_decks::generate_three(seed, title);
    interrupted::is_resumed(title, seed % 2 == 0 ? interrupted::also_with(0.1, job_of(m)) : job_of(m), 1);
  }
}

TEST_CASE("interrupted: random decks") {
  for (uint64_t seed = 1; seed <= 4; ++seed) {
    const random_decks::Verdict v = random_decks::judge_resumed(seed);
    CHECK_MESSAGE(v.findings.empty(), "make random N=1 KIND=resume SEED=" << seed << ": " << v.findings.front());
    CHECK(v.status == C2D_OK);
  }
}

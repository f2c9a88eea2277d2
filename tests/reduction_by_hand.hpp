#pragma once
// The reduction of a solver that is prepared, called by hand.
#include "callable.hpp"
#include "contact/reduction/reduction.hpp"
#include "linalg/kernel.hpp"
#include "solver/solver.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace runs {

// So many numbers from a multiple of 64 bytes on.
class Numbers64 {
public:
  explicit Numbers64(int64_t count) : all_(static_cast<size_t>(count) + 64 / sizeof(c2d::Real)) {}
  c2d::Real* at() {
    void* from = all_.data();
    size_t space = all_.size() * sizeof(c2d::Real);
    return static_cast<c2d::Real*>(std::align(64, sizeof(c2d::Real), from, space));
  }

private:
  std::vector<c2d::Real> all_;
};

// Over its tape; `longer`: the columns of the strip than they must be.
struct ByHand {
  c2d::Model model;
  int64_t m, n, ld;
  Numbers64 first, second, strip, scratch, buffer;
  std::vector<int32_t> pivots;
  int64_t used = 0;
  int32_t step = 0;
  test::Callable<c2d_status(int32_t step)> before = [](int32_t) { return c2d_status{C2D_OK}; };
  c2d::Reduction r;

  ByHand(c2d_solver* s, bool sliding, int64_t longer = 0)
      : model(c2d::model_of(s)), m(model.head->contact), n(m + model.head->motions), ld(n + longer), first(n * n),
        second(n * n), strip(ld * c2d::kStripColumns), scratch(c2d::full_scratch(ld, ld)), buffer(m + 3 + 64),
        pivots(static_cast<size_t>(n)), r{c2d::ContactTape{&s->tapes, &model, buffer.at()},
                                          model,
                                          first.at(),
                                          second.at(),
                                          strip.at(),
                                          pivots.data(),
                                          ld,
                                          this,
                                          [](void* self) {
                                            ByHand& own = *static_cast<ByHand*>(self);
                                            return own.before(own.step++);
                                          },
                                          c2d::Engine{c2d::kernel_for(s->instructions), scratch.at(), c2d::full_scratch(ld, ld),
                                                      &used, c2d::kAlone},
                                          sliding} {}
  ByHand(const ByHand&) = delete;
  // T and b.
  std::vector<c2d::Real> tableau() {
    std::vector<c2d::Real> out(static_cast<size_t>(m * (m + model.head->load_cases)));
    REQUIRE(read_matrix(r.tape, c2d::ContactMatrix::stiffness, out.data(), m) == C2D_OK);
    REQUIRE(read_matrix(r.tape, c2d::ContactMatrix::stiffness_load, out.data() + m * m, m) == C2D_OK);
    return out;
  }
};

} // namespace runs

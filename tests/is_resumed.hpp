#pragma once
#include "interrupted.hpp"

#include <doctest/doctest.h>

namespace interrupted {

// The job ends alike wherever it is interrupted, at `places` of its steps.
inline void is_resumed(const std::string& kind, const Job& job, size_t least_steps = 3, size_t places = 4) {
  CAPTURE(kind);
  const Verdict v = end_and_resume(job, places);
  CHECK_MESSAGE(v.difference == "", v.difference);
  CHECK_MESSAGE(v.status == C2D_OK, v.messages);
  CHECK(v.steps >= least_steps);
}

} // namespace interrupted

// The library's summary, and what it tells of each body.
#pragma once

#include <contact2d.h>

#include <vector>

namespace app {

// By any kind of number, from 0.
class Bodies {
public:
  template <class Number> const c2d_body_result& operator[](Number i) const { return list_[static_cast<size_t>(i)]; }
  std::vector<c2d_body_result>& list() { return list_; }

private:
  std::vector<c2d_body_result> list_;
};

struct Summary : c2d_summary {
  Summary() : c2d_summary(C2D_INIT(c2d_summary)) {}
  Bodies body;
};
c2d_status get_summary(c2d_solver* solver, Summary& out);

} // namespace app

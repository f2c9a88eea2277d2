#include "bie/batch.hpp"

namespace c2d {

const BatchKernel* batch_for(Instructions set) {
  switch (set) {
  case Instructions::avx512:
    return avx512_batch();
  case Instructions::avx2:
    return avx2_batch();
  case Instructions::baseline:
    return baseline_batch();
  default:
    return nullptr;
  }
}

bool is_batched(const Integrator& in, bool want_g) {
  return in.mode == Quadrature::accurate && !in.degenerate && in.element.straight && (!want_g || in.closed_form_g);
}

} // namespace c2d

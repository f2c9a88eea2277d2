#include "solver/model_hash.hpp"

#include "bie/columns.hpp"
#include "model/rigid.hpp"

namespace c2d {

namespace {

struct Hash {
  uint64_t value;
  void add(const void* data, size_t bytes);
  template <class T> void add_array(const T* data, int32_t count) { add(data, static_cast<size_t>(count) * sizeof(T)); }
};

[[gnu::noinline]] void Hash::add(const void* data, size_t bytes) { value = checksum(value, data, bytes); }

} // namespace

uint64_t hash_model(const Model& m, const c2d_options& options) {
  Hash hash{sizeof(Real)};
  hash.add(&options.quadrature, sizeof options.quadrature);
  hash.add(&m.head->plane, sizeof m.head->plane);
  if (m.head->symmetry != 0) {
    hash.add(&m.head->symmetry, sizeof m.head->symmetry);
    hash.add_array(m.head->line_at, 2);
  }
  for (int b = 0; b < m.head->bodies; ++b) {
    const Body& body = m.head->body[b];
    const int32_t ends = body.elements * m.head->function_nodes;
    const size_t pairs_of_numbers = 2 * sizeof(double) * static_cast<size_t>(m.head->load_cases);
    hash.add(&body.youngs_modulus, 2 * sizeof(double));
    hash.add(m.xy[b], 2 * sizeof(double) * static_cast<size_t>(body.geometry_nodes));
    hash.add(m.end_traction[b], pairs_of_numbers * static_cast<size_t>(ends));
    hash.add(m.node_disp[b], pairs_of_numbers * static_cast<size_t>(body.nodes));
    hash.add_array(m.end_code[b], ends);
    hash.add_array(m.region[b], body.regions);
  }
  if (m.head->rigid != 0) hash.add_array(m.rigid_motion, m.head->load_cases);
  if (m.head->interference != 0) hash.add(&m.head->interference, sizeof m.head->interference);
  if (m.head->body_forces != 0) hash.add(m.body_force, 2 * sizeof(BodyForce) * static_cast<size_t>(m.head->load_cases));
  hash.add_array(m.zone, m.head->zones);
  hash.add_array(m.curve, m.head->curves);
  hash.add_array(m.point_load, m.head->point_loads);
  return hash.value;
}

PhaseSizes model_sizes(const Model& m) {
  PhaseSizes sizes{};
  sizes.m = m.head->contact;
  sizes.cases = m.head->load_cases;
  for (int b = 0; b < m.head->bodies; ++b) {
    const Body& body = m.head->body[b];
    sizes.nodes[b] = body.nodes;
    sizes.ends[b] = static_cast<int64_t>(body.elements) * m.head->function_nodes;
    if (is_rigid(m, b)) continue;
    sizes.rows[b] = system_rows(m, b);
    sizes.outer[b] = outer_columns(m, b);
  }
  return sizes;
}

} // namespace c2d

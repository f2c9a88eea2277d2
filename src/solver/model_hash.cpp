#include "solver/model_hash.hpp"

#include <stddef.h>

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
  if (!kSmallCode && options.elimination != 0) hash.add(&options.elimination, sizeof options.elimination);
  if (m.head->symmetry != 0) {
    hash.add(&m.head->symmetry, sizeof m.head->symmetry);
    hash.add_array(m.head->line_at, 2);
  }
  for (int b = 0; b < m.head->bodies; ++b) {
    const Body& body = m.body[b];
    const int32_t ends = body.elements * m.head->function_nodes;
    const size_t pairs_of_numbers = 2 * sizeof(double) * static_cast<size_t>(m.head->load_cases);
    hash.add(&body.youngs_modulus, 2 * sizeof(double));
    hash.add(m.xy[b], 2 * sizeof(double) * static_cast<size_t>(body.geometry_nodes));
    hash.add(m.end_traction[b], pairs_of_numbers * static_cast<size_t>(ends));
    hash.add(m.node_disp[b], pairs_of_numbers * static_cast<size_t>(body.nodes));
    hash.add_array(m.end_code[b], ends);
    hash.add_array(m.region[b], body.regions);
    if (body.rigid != 0) hash.add_array(m.rigid_motion[b], m.head->load_cases);
    if (body.free_rigidly != 0) {
      hash.add(&body.free_rigidly, sizeof body.free_rigidly);
      hash.add_array(body.centre, 2);
    }
    if (body.has_force != 0) hash.add_array(m.body_force[b], m.head->load_cases);
  }
  if (is_on_demand(m)) hash.add(&m.head->columns, sizeof m.head->columns);
  if (m.head->interference != 0) hash.add(&m.head->interference, sizeof m.head->interference);
  // Names and the lines of cards decide nothing.
  for (int32_t z = 0; z < m.head->zones; ++z) {
    hash.add(&m.zone[z], offsetof(Zone, line));
    hash.add(&m.zone[z].facing, offsetof(Zone, name) - offsetof(Zone, facing));
  }
  for (int32_t i = 0; i < m.head->curves; ++i) {
    hash.add(&m.curve[i], offsetof(Curve, line));
    hash.add(m.curve[i].centre, sizeof(Curve) - offsetof(Curve, centre));
  }
  for (int32_t i = 0; i < m.head->point_loads; ++i) {
    hash.add(&m.point_load[i], offsetof(PointLoad, line));
    hash.add(&m.point_load[i].x, sizeof(PointLoad) - offsetof(PointLoad, x));
  }
  return hash.value;
}

} // namespace c2d

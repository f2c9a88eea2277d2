#include "report/drawn/scene.hpp"

namespace app {
namespace {

c2d_status gather_point_loads(Scene& scene) {
  double at[2], force[2];
  int32_t body = 0, load_case = 0;
  for (int32_t i = 1; i <= scene.summary.point_loads; ++i) {
    const c2d_status status = c2d_get_point_load(scene.solver, i, &body, &load_case, at, force);
    if (status != C2D_OK) return status;
    scene.point_loads.push_back({body, {at[0], at[1]}, {force[0], force[1]}, static_cast<size_t>(load_case) - 1});
  }
  return C2D_OK;
}

c2d_status gather_body_forces(Scene& scene, int32_t load_case) {
  for (int32_t body = 1; body <= scene.summary.bodies; ++body) {
    double force[2], rho_omega2 = 0.0, axis[2];
    const c2d_status status = c2d_get_body_force(scene.solver, body, load_case, force, &rho_omega2, axis);
    if (status != C2D_OK) return status;
    if (force[0] != 0.0 || force[1] != 0.0 || rho_omega2 != 0.0)
      scene.body_forces.push_back(
          {body, static_cast<size_t>(load_case) - 1, {force[0], force[1]}, rho_omega2, {axis[0], axis[1]}});
  }
  return C2D_OK;
}

c2d_status gather_motions(Scene& scene, int32_t load_case) {
  for (int32_t body = 1; body <= scene.summary.bodies; ++body) {
    int32_t is_rigid = 0;
    double motion[3], axis[2];
    const c2d_status status = c2d_get_rigid(scene.solver, body, load_case, &is_rigid, motion, axis);
    if (status != C2D_OK) return status;
    scene.bodies[static_cast<size_t>(body) - 1].rigid = is_rigid != 0;
    if (motion[0] != 0.0 || motion[1] != 0.0 || motion[2] != 0.0)
      scene.motions.push_back(
          {body, static_cast<size_t>(load_case) - 1, {motion[0], motion[1]}, motion[2], {axis[0], axis[1]}});
  }
  return C2D_OK;
}

void find_images(Scene& scene) {
  const Summary& s = scene.summary;
  const Point line{s.symmetry_at[0], s.symmetry_at[1]};
  for (int y = 0; y <= (s.symmetry >> 1 & 1); ++y)
    for (int x = 0; x <= (s.symmetry & 1); ++x) scene.images.push_back({{x == 0 ? 1.0 : -1.0, y == 0 ? 1.0 : -1.0}, line});
  scene.zone_images = {scene.images[0]};
  for (const int axis : {1, 2})
    for (const ZoneScene& zone : scene.zones)
      if (zone.has_images && scene.pairs[zone.origin].image_line == axis) {
        scene.zone_images.push_back({{axis == 1 ? -1.0 : 1.0, axis == 2 ? -1.0 : 1.0}, line});
        break;
      }
}

} // namespace

c2d_status gather_loads(Scene& scene) {
  scene.cases = static_cast<size_t>(scene.summary.load_cases);
  find_images(scene);
  c2d_status status = gather_point_loads(scene);
  for (int32_t k = 1; status == C2D_OK && k <= scene.summary.load_cases; ++k) {
    status = gather_body_forces(scene, k);
    if (status == C2D_OK) status = gather_motions(scene, k);
  }
  int32_t closing = 0;
  if (status == C2D_OK) status = c2d_get_interference(scene.solver, &closing);
  scene.interference = static_cast<size_t>(closing);
  return status;
}

} // namespace app

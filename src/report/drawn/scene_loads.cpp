#include "report/drawn/scene.hpp"

#include <algorithm>
#include <cmath>

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

// The states of bodies are known at the recorded steps alone.
void gather_rigid_loads(Scene& scene) {
  if (scene.record->coefficients.empty()) return;
  std::vector<double> most(scene.bodies.size(), 0.0);
  std::vector<RigidLoad> largest(scene.bodies.size());
  for (const StepRecord& step : scene.record->coefficients.back().steps)
    for (size_t b = 0; b < std::min(step.bodies.size(), scene.bodies.size()); ++b) {
      const c2d_body_state& s = step.bodies[b];
      // Without free rotation the moment is no load, and given as 0.
      const double moment = s.load[2] == 0.0 ? 0.0 : s.load[2] - s.point[0] * s.load[1] + s.point[1] * s.load[0];
      const double size = std::hypot(s.load[0], s.load[1]) + std::fabs(moment);
      if (s.is_rigid == 0 || size <= most[b]) continue;
      most[b] = size;
      const double none =
          1e-12 * (std::fabs(s.load[2]) + std::fabs(s.point[0] * s.load[1]) + std::fabs(s.point[1] * s.load[0]));
      largest[b] = {static_cast<int32_t>(b) + 1,
                    {s.point[0], s.point[1]},
                    {s.load[0], s.load[1]},
                    std::fabs(moment) > none ? moment : 0.0};
    }
  for (const RigidLoad& load : largest)
    if (load.body > 0) scene.rigid_loads.push_back(load);
}

void find_images(Scene& scene) {
  const Summary& s = scene.summary;
  const Point line{s.symmetry_at[0], s.symmetry_at[1]};
  for (int y = 0; y <= (s.symmetry >> 1 & 1); ++y)
    for (int x = 0; x <= (s.symmetry & 1); ++x) scene.images.push_back({{x == 0 ? 1.0 : -1.0, y == 0 ? 1.0 : -1.0}, line});
  scene.zone_images = {scene.images[0]};
  for (const ZoneScene& zone : scene.zones)
    for (const Image& image : images_of(scene, zone)) {
      const auto same = [&](const Image& other) { return other.turn.x == image.turn.x && other.turn.y == image.turn.y; };
      if (std::none_of(scene.zone_images.begin(), scene.zone_images.end(), same)) scene.zone_images.push_back(image);
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
  gather_rigid_loads(scene);
  int32_t closing = 0;
  if (status == C2D_OK) status = c2d_get_interference(scene.solver, &closing);
  scene.interference = static_cast<size_t>(closing);
  return status;
}

} // namespace app

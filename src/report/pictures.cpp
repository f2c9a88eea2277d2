#include "report/pictures.hpp"

namespace app {

std::string chart_title(const Scene& scene, double mu, size_t zone) {
  std::string out = "&#956; = " + figure(mu);
  if (scene.zones.size() > 1) out += ", zone " + std::to_string(zone + 1);
  return out;
}

std::string chart_suffix(const Scene& scene, size_t coefficient, size_t zone) {
  std::string out;
  if (scene.summary.coefficients > 1) out += "_" + std::to_string(coefficient + 1);
  if (scene.zones.size() > 1) out += "_zone" + std::to_string(zone + 1);
  return out;
}

std::string position_name(const ZoneScene& zone) {
  return zone.symmetric_origin ? "distance s from the line of symmetry, along body 1"
                               : "distance s from pair " + std::to_string(zone.origin + 1) + ", along body 1";
}

c2d_status draw_pictures(const Scene& scene, Pictures& out) {
  draw_model(scene, out);
  draw_tractions(scene, out);
  draw_status_map(scene, out);
  draw_gap(scene, out);
  c2d_status status = C2D_OK;
  if (scene.solved) {
    draw_deformed(scene, out);
    draw_boundary_stress(scene, out);
    status = draw_stress(scene, out);
  }
  draw_path(scene, out);
  draw_energy(scene, out);
  if (scene.solved) draw_balance(scene, out);
  return status;
}

} // namespace app

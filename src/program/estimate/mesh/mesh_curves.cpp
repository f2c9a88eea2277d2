#include "program/estimate/mesh/mesh_curves.hpp"

namespace estimate {

std::vector<app::MeshCurve> curves_of(const sketch::Mesh& mesh) {
  std::vector<app::MeshCurve> out;
  for (size_t b = 0; b < mesh.bodies.size(); ++b)
    for (const sketch::MeshedOutline& outline : mesh.bodies[b]) {
      app::MeshCurve curve;
      curve.body = static_cast<int32_t>(b) + 1;
      curve.closed = !outline.open;
      for (const sketch::MeshedCurve& part : outline.curves)
        for (size_t e = curve.ends.empty() ? 0 : 1; e < part.ends.size(); ++e) {
          const sketch::Point p = part.curve->shape->at(part.measure.u_at(part.ends[e]));
          curve.ends.push_back({p.x, p.y});
        }
      out.push_back(curve);
    }
  return out;
}

} // namespace estimate

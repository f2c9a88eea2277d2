// Queries of load cases as given: conditions, point loads, body forces, motions of rigid bodies.
#include "interface/model/refuse.hpp"
#include "solver/solver.hpp"

using namespace c2d;

extern "C" c2d_status c2d_get_condition(c2d_solver* s, int32_t body, int32_t element, int32_t local, int32_t load_case,
                                        int32_t codes[4], double values[4]) {
  c2d_status status = enter(s, kComplete);
  if (status == C2D_OK) status = check_ranges(s, {{"body", body, 1, s->model.bodies}});
  if (status == C2D_OK)
    status = check_ranges(s, {{"element", element, 1, body_numbered(s, body).elements},
                              {"local", local, 1, s->model.function_nodes},
                              {"load_case", load_case, 1, s->model.load_cases}});
  if (status == C2D_OK) status = check_pointers(s, {{"codes", codes}, {"values", values}});
  if (status != C2D_OK) return status;
  const Model m = model_of(s);
  const int b = body - 1;
  const int64_t ends = static_cast<int64_t>(m.body[b].elements) * m.head->function_nodes, nodes = m.body[b].nodes;
  const int32_t end = (element - 1) * s->model.function_nodes + local - 1;
  const int32_t node = functional_node(m, b, element - 1, local - 1);
  const uint8_t code = m.end_code[b][end] & kGiven ? m.end_code[b][end] : static_cast<uint8_t>(kKnownTx | kKnownTy);
  for (int c = 0; c < 2; ++c) {
    codes[c] = code & (kKnownTx << c) ? 0 : 1;
    codes[2 + c] = code & (kKnownUx << c) ? 0 : 1;
    values[c] = m.end_traction[b][2 * ((load_case - 1) * ends + end) + c];
    values[2 + c] = codes[2 + c] == 0 ? m.node_disp[b][2 * ((load_case - 1) * nodes + node) + c] : 0.0;
  }
  return C2D_OK;
}

extern "C" c2d_status c2d_get_point_load(c2d_solver* s, int32_t i, int32_t* body, int32_t* load_case, double xy[2],
                                         double force[2]) {
  c2d_status status = enter(s, kComplete);
  if (status == C2D_OK) status = check_ranges(s, {{"i", i, 1, s->model.point_loads}});
  if (status == C2D_OK) status = check_pointers(s, {{"body", body}, {"load_case", load_case}, {"xy", xy}, {"force", force}});
  if (status != C2D_OK) return status;
  const PointLoad& p = array_of<PointLoad>(s, kPointLoads)[i - 1];
  *body = p.body + 1;
  xy[0] = p.x;
  xy[1] = p.y;
  force[0] = p.fx;
  force[1] = p.fy;
  *load_case = p.load_case + 1;
  return C2D_OK;
}

extern "C" c2d_status c2d_get_body_force(c2d_solver* s, int32_t body, int32_t load_case, double force[2], double* rho_omega2,
                                         double axis[2]) {
  c2d_status status = enter(s, kComplete);
  if (status == C2D_OK)
    status = check_ranges(s, {{"body", body, 1, s->model.bodies}, {"load_case", load_case, 1, s->model.load_cases}});
  if (status == C2D_OK) status = check_pointers(s, {{"force", force}, {"rho_omega2", rho_omega2}, {"axis", axis}});
  if (status != C2D_OK) return status;
  const BodyForce& given = model_of(s).body_force[body - 1][load_case - 1];
  force[0] = given.bx;
  force[1] = given.by;
  *rho_omega2 = given.rho_omega2;
  axis[0] = given.x0;
  axis[1] = given.y0;
  return C2D_OK;
}

extern "C" c2d_status c2d_get_rigid(c2d_solver* s, int32_t body, int32_t load_case, int32_t* is_rigid, double motion[3],
                                    double axis[2]) {
  c2d_status status = enter(s, kComplete);
  if (status == C2D_OK)
    status = check_ranges(s, {{"body", body, 1, s->model.bodies}, {"load_case", load_case, 1, s->model.load_cases}});
  if (status == C2D_OK) status = check_pointers(s, {{"is_rigid", is_rigid}, {"motion", motion}, {"axis", axis}});
  if (status != C2D_OK) return status;
  const Model m = model_of(s);
  const bool rigid = c2d::is_rigid(m, body - 1);
  const RigidMotion given = rigid ? m.rigid_motion[body - 1][load_case - 1] : RigidMotion{0, 0, 0, 0, 0, {0, 0, 0}};
  *is_rigid = rigid ? 1 : 0;
  motion[0] = given.ux;
  motion[1] = given.uy;
  motion[2] = given.rotation;
  axis[0] = given.x0;
  axis[1] = given.y0;
  return C2D_OK;
}

extern "C" c2d_status c2d_get_interference(c2d_solver* s, int32_t* load_case) {
  c2d_status status = enter(s, kComplete);
  if (status == C2D_OK) status = check_pointers(s, {{"load_case", load_case}});
  if (status != C2D_OK) return status;
  *load_case = s->model.interference;
  return C2D_OK;
}

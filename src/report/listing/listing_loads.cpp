#include "report/listing/listing_items.hpp"
#include "report/text.hpp"

#include <cstddef>
#include <vector>

namespace app {
namespace {

bool is_free(const int32_t codes[4], const double values[4]) {
  return codes[0] == 0 && codes[1] == 0 && values[0] == 0.0 && values[1] == 0.0;
}

void append_numbers(std::string& out, const double* values, int count) {
  for (int k = 0; k < count; ++k) append_general(out, values[k], 15, 8);
}

c2d_status append_point_loads(std::string& out, c2d_solver* solver, const Summary& s) {
  int32_t body = 0, load_case = 0;
  double xy[2], force[2];
  for (int32_t i = 1; i <= s.point_loads; ++i) {
    const c2d_status status = c2d_get_point_load(solver, i, &body, &load_case, xy, force);
    if (status != C2D_OK) return status;
    if (i == 1) {
      append_section(out, "Point loads");
      out += "    body    case              x              y             fx             fy\n";
    }
    append_column(out, body, 8);
    append_column(out, load_case, 8);
    append_numbers(out, xy, 2);
    append_numbers(out, force, 2);
    out += '\n';
  }
  return C2D_OK;
}

c2d_status append_body_forces(std::string& out, c2d_solver* solver, const Summary& s) {
  bool first = true;
  for (int32_t load_case = 1; load_case <= s.load_cases; ++load_case)
    for (int32_t body = 1; body <= s.bodies; ++body) {
      double force[2], rho_omega2 = 0.0, axis[2];
      const c2d_status status = c2d_get_body_force(solver, body, load_case, force, &rho_omega2, axis);
      if (status != C2D_OK) return status;
      if (force[0] == 0.0 && force[1] == 0.0 && rho_omega2 == 0.0) continue;
      if (first) {
        append_section(out, "Body forces");
        out += "    body    case             bx             by     rho omega2             x0             y0\n";
      }
      first = false;
      append_column(out, body, 8);
      append_column(out, load_case, 8);
      append_numbers(out, force, 2);
      append_numbers(out, &rho_omega2, 1);
      append_numbers(out, axis, 2);
      out += '\n';
    }
  return C2D_OK;
}

c2d_status append_rigid(std::string& out, c2d_solver* solver, const Summary& s, int32_t body) {
  for (int32_t load_case = 1; load_case <= s.load_cases; ++load_case) {
    int32_t rigid = 0;
    double motion[3], axis[2];
    const c2d_status status = c2d_get_rigid(solver, body, load_case, &rigid, motion, axis);
    if (status != C2D_OK || rigid == 0) return status;
    if (load_case == 1) {
      append_body_section(out, s, body, " is rigid");
      out += "    case             ux             uy       rotation             x0             y0\n";
    }
    append_column(out, load_case, 8);
    append_numbers(out, motion, 3);
    append_numbers(out, axis, 2);
    out += '\n';
  }
  return C2D_OK;
}

} // namespace

c2d_status append_conditions(std::string& out, c2d_solver* solver, const Summary& s, int32_t body) {
  const bool several = s.load_cases > 1;
  out += several ? "\n    case" : "\n";
  out += " element     end   codes             tx             ty             ux             uy"
         "    (ends not listed: free or contact)\n";
  for (int32_t load_case = 1; load_case <= s.load_cases; ++load_case)
    for (int32_t e = 1; e <= s.body[body - 1].elements; ++e)
      for (int32_t local = 1; local <= s.function_nodes; ++local) {
        int32_t codes[4];
        double values[4];
        const c2d_status status = c2d_get_condition(solver, body, e, local, load_case, codes, values);
        if (status != C2D_OK) return status;
        const bool zero = values[0] == 0.0 && values[1] == 0.0 && values[2] == 0.0 && values[3] == 0.0;
        if (is_free(codes, values) || (load_case > 1 && zero)) continue; // supports were listed with case 1
        if (several) append_column(out, load_case, 8);
        append_column(out, e, 8);
        append_column(out, local, 8);
        out += "    ";
        for (int k = 0; k < 4; ++k) append_integer(out, codes[k]);
        for (int k = 0; k < 4; ++k)
          if (codes[k] == 0)
            append_general(out, values[k], 15, 8);
          else
            append_column(out, "-", 15);
        out += '\n';
      }
  return C2D_OK;
}

c2d_status append_other_loads(std::string& out, c2d_solver* solver, const Summary& s) {
  c2d_status status = append_point_loads(out, solver, s);
  if (status == C2D_OK) status = append_body_forces(out, solver, s);
  for (int32_t body = 1; status == C2D_OK && body <= s.bodies; ++body) status = append_rigid(out, solver, s, body);
  int32_t closing = 0;
  if (status == C2D_OK) status = c2d_get_interference(solver, &closing);
  if (status != C2D_OK || closing == 0) return status;
  append_section(out, "Press fit");
  append_item(out, "load case that closes the overlaps", static_cast<int64_t>(closing));
  return C2D_OK;
}

c2d_status append_path(std::string& out, c2d_solver* solver, const Summary& s) {
  append_section(out, "Friction and loads");
  append_name(out, "coefficients of friction");
  for (int32_t i = 1; i <= s.coefficients; ++i) {
    double mu = 0.0;
    if (const c2d_status status = c2d_get_friction(solver, 0, i, &mu); status != C2D_OK) return status;
    if (i > 1) out += ", ";
    append_number(out, mu);
  }
  out += s.load_cases > 1 ? "\n\n    path      increments    load factors of all cases\n"
                          : "\n\n    path      increments    load factor\n";
  std::vector<double> loads(static_cast<size_t>(s.load_cases));
  for (int32_t i = 1; i <= s.paths; ++i) {
    int32_t increments = 0;
    const c2d_status status = c2d_get_path(solver, i, &increments, loads.data(), s.load_cases);
    if (status != C2D_OK) return status;
    append_column(out, i, 8);
    append_column(out, increments, 16);
    append_numbers(out, loads.data(), s.load_cases);
    out += '\n';
  }
  return C2D_OK;
}

} // namespace app

#include "report/csv.hpp"

#include "report/text.hpp"

namespace app {

void append_contact_header(std::string& out) {
  out += "mu,step,load,pair,x,y,status,tn,tt,un1,ut1,un2,ut2,gap,slip,zone,body1,body2\n";
}

void append_contact_rows(std::string& out, const c2d_step& step, const Summary& summary) {
  std::string head;
  append_number(head, step.mu);
  head += ',';
  append_integer(head, step.step);
  head += ',';
  append_number(head, step.load);
  head += ',';
  for (int32_t p = 0; p < step.pairs; ++p) {
    const double* row = step.table + p * step.stride;
    out += head;
    append_integer(out, p + 1);
    out += ',';
    append_number(out, row[C2D_X]);
    out += ',';
    append_number(out, row[C2D_Y]);
    out += ',';
    out += status_word(static_cast<int32_t>(row[C2D_STATUS]));
    for (int32_t k = C2D_TN; k <= C2D_SLIP_SUM; ++k) {
      out += ',';
      append_number(out, row[k]);
    }
    const size_t zone = static_cast<size_t>(row[C2D_PAIR_ZONE]);
    const c2d_zone& z = summary.zone[zone - 1];
    for (const int64_t number : {static_cast<int64_t>(zone), int64_t{z.side1.body}, int64_t{z.side2.body}}) {
      out += ',';
      append_integer(out, number);
    }
    out += '\n';
  }
}

void append_bodies_header(std::string& out) { out += "mu,step,load,body,fx,fy,moment,ux,uy,rotation\n"; }

void append_bodies_rows(std::string& out, const c2d_step& step, c2d_solver* solver) {
  c2d_body_state state = C2D_INIT(c2d_body_state);
  for (int32_t body = 1; c2d_get_body_state(solver, body, &state) == C2D_OK; ++body) {
    append_number(out, step.mu);
    out += ',';
    append_integer(out, step.step);
    out += ',';
    append_number(out, step.load);
    out += ',';
    append_integer(out, body);
    for (const double number :
         {state.contact[0], state.contact[1], state.contact[2], state.motion[0], state.motion[1], state.motion[2]}) {
      out += ',';
      append_number(out, number);
    }
    out += '\n';
  }
}

void append_boundary_header(std::string& out) { out += "body,element,node,x,y,ux,uy,tx,ty\n"; }

c2d_status append_boundary(std::string& out, c2d_solver* solver, const Summary& summary) {
  const int32_t fields[] = {C2D_END_NODE, C2D_END_X, C2D_END_Y, C2D_END_UX, C2D_END_UY, C2D_END_TX, C2D_END_TY};
  std::vector<std::vector<double>> values;
  for (int32_t body = 1; body <= summary.bodies; ++body) {
    const c2d_status status = get_ends(solver, summary, body, fields, 7, values);
    if (status != C2D_OK) return status;
    for (size_t i = 0; i < values[0].size(); ++i) {
      append_integer(out, body);
      out += ',';
      append_integer(out, static_cast<int32_t>(i) / summary.function_nodes + 1);
      out += ',';
      append_integer(out, static_cast<int64_t>(values[0][i]));
      for (size_t f = 1; f < values.size(); ++f) {
        out += ',';
        append_number(out, values[f][i]);
      }
      out += '\n';
    }
  }
  return C2D_OK;
}

} // namespace app

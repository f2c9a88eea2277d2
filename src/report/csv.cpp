#include "report/csv.hpp"

#include "report/text.hpp"

namespace app {

void append_contact_header(std::string& out) { out += "mu,step,load,pair,x,y,status,tn,tt,un1,ut1,un2,ut2,gap,slip\n"; }

void append_contact_rows(std::string& out, const c2d_step& step) {
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

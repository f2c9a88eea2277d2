#include "report/csv.hpp"

#include "report/text.hpp"

#include <cmath>

namespace app {

namespace {

void add(std::string& out, double number) {
  out += ',';
  append_number(out, number);
}
void add(std::string& out, int64_t number) {
  out += ',';
  append_integer(out, number);
}
// "mu,step,load", with which the rows of a step begin.
std::string head_of(const c2d_step& step) {
  std::string head;
  append_number(head, step.mu);
  add(head, int64_t{step.step});
  add(head, step.load);
  return head;
}

// The factors of the other load cases, with which they end.
void end_heading(std::string& out, int32_t load_cases) {
  for (int32_t k = 2; k <= load_cases; ++k) out += ",load" + std::to_string(k);
  out += '\n';
}
std::string tail_of(const double* loads, int32_t load_cases) {
  std::string tail;
  for (int32_t k = 1; k < load_cases; ++k) add(tail, loads[k]);
  return tail + '\n';
}

// A table is a list of columns: the name, and what adds the value of a row with a comma before it. Behind them stand the
// factors of the other load cases.
template <class Row> struct TableColumn {
  const char* name;
  void (*add)(std::string& out, const Row& row);
};

template <class Row, size_t N> void append_heading(std::string& out, const TableColumn<Row> (&columns)[N], int32_t load_cases) {
  out += "mu,step,load";
  for (const TableColumn<Row>& column : columns) (out += ',') += column.name;
  end_heading(out, load_cases);
}

template <class Row, size_t N>
void append_row(std::string& out, const TableColumn<Row> (&columns)[N], const Row& row, const std::string& head,
                const std::string& tail) {
  out += head;
  for (const TableColumn<Row>& column : columns) column.add(out, row);
  out += tail;
}

struct PairRow {
  int64_t pair;        // from 1
  const double* value; // of the library's table
  const c2d_zone* zone;
};
template <int32_t Field> void add_value(std::string& out, const PairRow& row) { add(out, row.value[Field]); }
constexpr TableColumn<PairRow> kContactColumns[] = {
    {"pair", [](std::string& out, const PairRow& row) { add(out, row.pair); }},
    {"x", add_value<C2D_X>},
    {"y", add_value<C2D_Y>},
    {"status",
     [](std::string& out, const PairRow& row) { (out += ',') += status_word(static_cast<int32_t>(row.value[C2D_STATUS])); }},
    {"tn", add_value<C2D_TN>},
    {"tt", add_value<C2D_TT>},
    {"un1", add_value<C2D_UN1>},
    {"ut1", add_value<C2D_UT1>},
    {"un2", add_value<C2D_UN2>},
    {"ut2", add_value<C2D_UT2>},
    {"gap", add_value<C2D_GAP>},
    {"slip", add_value<C2D_SLIP_SUM>},
    {"zone", [](std::string& out, const PairRow& row) { add(out, static_cast<int64_t>(row.value[C2D_PAIR_ZONE])); }},
    {"body1", [](std::string& out, const PairRow& row) { add(out, int64_t{row.zone->side1.body}); }},
    {"body2", [](std::string& out, const PairRow& row) { add(out, int64_t{row.zone->side2.body}); }},
};

struct BodyRow {
  int64_t body; // from 1
  const c2d_body_state* state;
};
template <int32_t Component> void add_contact(std::string& out, const BodyRow& row) { add(out, row.state->contact[Component]); }
template <int32_t Component> void add_motion(std::string& out, const BodyRow& row) { add(out, row.state->motion[Component]); }
constexpr TableColumn<BodyRow> kBodyColumns[] = {
    {"body", [](std::string& out, const BodyRow& row) { add(out, row.body); }},
    {"fx", add_contact<0>},
    {"fy", add_contact<1>},
    {"moment", add_contact<2>},
    {"ux", add_motion<0>},
    {"uy", add_motion<1>},
    {"rotation", add_motion<2>},
};

} // namespace

void append_contact_header(std::string& out, int32_t load_cases) { append_heading(out, kContactColumns, load_cases); }

void append_contact_rows(std::string& out, const c2d_step& step, const Summary& summary) {
  const std::string head = head_of(step), tail = tail_of(step.loads, step.cases);
  for (int32_t p = 0; p < step.pairs; ++p) {
    const double* value = step.table + p * step.stride;
    const c2d_zone& zone = summary.zone[static_cast<size_t>(value[C2D_PAIR_ZONE]) - 1];
    append_row(out, kContactColumns, PairRow{int64_t{p} + 1, value, &zone}, head, tail);
  }
}

void append_bodies_header(std::string& out, int32_t load_cases) { append_heading(out, kBodyColumns, load_cases); }

void append_bodies_rows(std::string& out, const c2d_step& step, c2d_solver* solver) {
  const std::string head = head_of(step), tail = tail_of(step.loads, step.cases);
  c2d_body_state state = C2D_INIT(c2d_body_state);
  for (int32_t body = 1; c2d_get_body_state(solver, body, &state) == C2D_OK; ++body)
    append_row(out, kBodyColumns, BodyRow{body, &state}, head, tail);
}

namespace {

// A name as a field; names are free of control characters, but not of commas.
void add_name(std::string& out, const std::string& name) {
  const bool plain = name.find_first_of(",\"") == std::string::npos;
  out += ',';
  if (!plain) out += '"';
  for (const char c : name) out.append(c == '"' ? 2 : 1, c);
  if (!plain) out += '"';
}

void add_if_known(std::string& out, double number) {
  if (std::isfinite(number))
    add(out, number);
  else
    out += ',';
}

// "mu,step,load", of a step that was kept.
std::string head_of(const CoefficientRecord& c, const StepRecord& step) {
  std::string head;
  append_number(head, c.mu);
  add(head, int64_t{step.step});
  add(head, step.loads.empty() ? 0.0 : step.loads.front());
  return head;
}

std::string tail_of(const StepRecord& step) { return tail_of(step.loads.data(), static_cast<int32_t>(step.loads.size())); }

// A number that no step has: of a body, or of the last cycle of the whole contact.
bool is_stated_alone(const Stated& s) { return s.body != 0 || s.what == Measure::kCycleDissipated; }

// What stands behind the factors of the load cases, where columns are new: the plane of a fatigue parameter, and how far
// tolerances of parameters move a number.
constexpr char kAddedColumns[] = ",plane_angle,worst_case,root_of_squares\n";
std::string with_added(std::string tail, double angle, const ToleranceTable& table, const Toleranced* t) {
  tail.pop_back();
  add_if_known(tail, angle);
  add_if_known(tail, t != nullptr ? table.worst_case(*t) : NAN);
  add_if_known(tail, t != nullptr ? table.root_of_squares(*t) : NAN);
  return tail + '\n';
}

// A number in the table of tolerances; null: it is not there.
const Toleranced* find_toleranced(const ToleranceTable& table, const Stated& s) {
  const auto is_same = [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); };
  for (const Toleranced& t : table.numbers) {
    const Stated& n = t.number;
    if (n.what == s.what && n.of == s.of && n.body == s.body && is_same(n.at[0], s.at[0]) && is_same(n.at[1], s.at[1]))
      return &t;
  }
  return nullptr;
}
const Toleranced* find_toleranced(const ToleranceTable& table, const Quantity& q) {
  for (const Toleranced& t : table.numbers)
    if (t.number.what == q.what && t.number.zone == q.zone && t.number.item == q.item && t.number.body == 0) return &t;
  return nullptr;
}

// The requested stresses and the friction loss of the last cycle, of the first coefficient.
void append_wanted(std::string& out, const RunRecord& record, const Summary& summary) {
  if (record.coefficients.empty() || record.coefficients.front().steps.empty()) return;
  const StepRecord& last = record.coefficients.front().steps.back();
  const std::string head = head_of(record.coefficients.front(), last);
  for (const Stated& s : record.meshes.stated) {
    if (!is_stated_alone(s)) continue;
    out += head + (s.body != 0 ? "," : ",0");
    add_name(out, s.body != 0 ? summary.body_name[static_cast<size_t>(s.body) - 1] : std::string());
    add_name(out, s.name());
    out += ',';
    add(out, s.value);
    for (const double number : {s.at[0], s.at[1], s.error, double{NAN}, double{NAN}}) add_if_known(out, number);
    const ToleranceTable& tolerances = record.meshes.tolerances;
    out += with_added(tail_of(last), s.angle, tolerances, find_toleranced(tolerances, s));
  }
}

// Of what the number is.
std::string name_for(const Quantity& q, const Summary& summary) {
  if (q.is_of_body()) return summary.body_name[static_cast<size_t>(q.item) - 1];
  return q.zone > 0 ? summary.zone_name[static_cast<size_t>(q.zone) - 1] : std::string();
}

} // namespace

void append_summary(std::string& out, const RunRecord& record, const Summary& summary) {
  out += "mu,step,load,zone,name,quantity,item,value,x,y,error,s,along";
  end_heading(out, summary.load_cases);
  out.pop_back();
  out += kAddedColumns;
  const ToleranceTable& tolerances = record.meshes.tolerances;
  for (const CoefficientRecord& c : record.coefficients)
    for (size_t i = 0; i < c.steps.size(); ++i) {
      if (is_repeated(c, i)) continue;
      const bool has_tolerances = &c == &record.coefficients.front() && i + 1 == c.steps.size();
      for (const Quantity& q : c.steps[i].quantities) {
        out += head_of(c, c.steps[i]);
        add(out, int64_t{q.zone});
        add_name(out, name_for(q, summary));
        add_name(out, name_of(q.what));
        add(out, int64_t{q.item});
        add(out, q.value);
        for (const double number : {q.at[0], q.at[1], q.error, q.s, q.along}) add_if_known(out, number);
        out += with_added(tail_of(c.steps[i]), NAN, tolerances, has_tolerances ? find_toleranced(tolerances, q) : nullptr);
      }
    }
  append_wanted(out, record, summary);
}

void append_boundary_header(std::string& out) { out += "body,element,node,x,y,ux,uy,tx,ty\n"; }

c2d_status append_boundary(std::string& out, c2d_solver* solver, const Summary& summary) {
  const int32_t fields[] = {C2D_END_NODE, C2D_END_X, C2D_END_Y, C2D_END_UX, C2D_END_UY, C2D_END_TX, C2D_END_TY};
  std::vector<std::vector<double>> values;
  for (int32_t body = 1; body <= summary.bodies; ++body) {
    if (const c2d_status status = get_ends(solver, summary, body, fields, 7, values); status != C2D_OK) return status;
    for (size_t i = 0; i < values[0].size(); ++i) {
      append_integer(out, body);
      add(out, static_cast<int64_t>(i) / summary.function_nodes + 1);
      add(out, static_cast<int64_t>(values[0][i]));
      for (size_t f = 1; f < values.size(); ++f) add(out, values[f][i]);
      out += '\n';
    }
  }
  return C2D_OK;
}

} // namespace app

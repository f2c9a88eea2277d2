// The model by calls: every call checks its arguments, changes nothing if they are wrong, and says why.
#include <math.h>
#include <string.h>

#include "bie/columns.hpp"
#include "contact/frames.hpp"
#include "memory/characters.hpp"
#include "memory/text.hpp"
#include "model/unknowns.hpp"
#include "solver/solver.hpp"

namespace c2d {

namespace {

constexpr uint32_t kBuilding = state_bit(C2D_STATE_EMPTY) | state_bit(C2D_STATE_BUILDING);

// A refused call: told like a fault of the deck, with the place that c2d_set_line gave.
struct Refusal {
  c2d_error error;
  Text text;
};
void start_refusal(Refusal& r, c2d_solver* s, c2d_status status) {
  r.error = blank_error();
  r.error.status = status;
  r.error.severity = C2D_FAULT;
  r.error.line = s->model.line;
  r.error.column = s->model.column;
  r.error.column_end = s->model.column_end;
  r.text = text_in(r.error.text);
}
c2d_status refuse(c2d_solver* s, c2d_status status, const char* text) {
  Refusal r;
  start_refusal(r, s, status);
  put(r.text, text);
  report_fault(s, r.error);
  return status;
}
// "what is VALUE, expected FIRST to LAST"
c2d_status refuse_number(c2d_solver* s, c2d_status status, const char* what, int64_t value, int64_t first,
                         int64_t last) {
  Refusal r;
  start_refusal(r, s, status);
  put(r.text, what);
  put(r.text, " is ");
  put(r.text, value);
  put(r.text, ", expected ");
  put(r.text, first);
  if (last != first) {
    put(r.text, " to ");
    put(r.text, last);
  }
  report_fault(s, r.error);
  return status;
}
c2d_status refuse_value(c2d_solver* s, const char* what, double value, const char* expected) {
  Refusal r;
  start_refusal(r, s, C2D_ERR_ARGUMENT);
  put(r.text, what);
  put(r.text, " is ");
  put(r.text, value);
  put(r.text, ", expected ");
  put(r.text, expected);
  report_fault(s, r.error);
  return C2D_ERR_ARGUMENT;
}

c2d_status enter_building(c2d_solver* s) { return enter(s, kBuilding); }
// The call changed something: the model is no longer empty.
c2d_status built(c2d_solver* s) {
  s->state = C2D_STATE_BUILDING;
  return C2D_OK;
}

bool in_range(int64_t value, int64_t first, int64_t last) { return value >= first && value <= last; }

c2d_status check_body_number(c2d_solver* s, int32_t body) {
  if (in_range(body, 1, s->sizes.bodies)) return C2D_OK;
  return refuse_number(s, C2D_ERR_ARGUMENT, "body number", body, 1, s->sizes.bodies);
}

} // namespace
} // namespace c2d

using namespace c2d;

extern "C" c2d_status c2d_set_line(c2d_solver* s, int32_t line, int32_t column, int32_t column_end) {
  const c2d_status status = enter(s, kBuilding);
  if (status != C2D_OK) return status;
  s->model.line = line;
  s->model.column = column;
  s->model.column_end = column_end;
  return C2D_OK;
}

extern "C" c2d_status c2d_set_options(c2d_solver* s, const c2d_options* options) {
  c2d_status status = enter(s, kBuilding | state_bit(C2D_STATE_MODEL));
  c2d_options ours;
  if (status != C2D_OK) return status;
  if (!options || !copy_in(options, &ours, sizeof ours)) return fail(s, C2D_ERR_ARGUMENT, "no options given");
  if (!in_range(ours.quadrature, 0, 1) || !in_range(ours.stepping, 0, 1) || !in_range(ours.every_change, 0, 1) ||
      !in_range(ours.symmetry, 0, 1))
    return fail(s, C2D_ERR_ARGUMENT, "an option is out of range");
  if (s->state == C2D_STATE_MODEL && ours.symmetry != s->options.symmetry)
    return fail(s, C2D_ERR_STATE, "symmetry by images is chosen before the model is complete");
  s->options = ours;
  return C2D_OK;
}

extern "C" c2d_status c2d_set_problem(c2d_solver* s, const c2d_problem* problem) {
  c2d_status status = enter_building(s);
  c2d_problem ours;
  if (status != C2D_OK) return status;
  if (!problem || !copy_in(problem, &ours, sizeof ours)) return refuse(s, C2D_ERR_ARGUMENT, "no problem given");
  if (!in_range(ours.plane, 0, 1))
    return refuse_number(s, C2D_ERR_ARGUMENT, "plane strain or stress (IPTYPE)", ours.plane, 0, 1);
  if (ours.iteration_limit < 0)
    return refuse_number(s, C2D_ERR_ARGUMENT, "iteration limit", ours.iteration_limit, 1, INT32_MAX);
  ModelHeader& m = s->model;
  m.bodies = s->sizes.bodies;
  m.function_nodes = s->sizes.function_nodes;
  m.load_cases = s->sizes.load_cases;
  m.plane = ours.plane;
  m.analysis = ours.analysis;
  if (m.analysis < C2D_ANALYSIS_CHECK) m.analysis = C2D_ANALYSIS_CHECK;
  if (m.analysis > C2D_ANALYSIS_ITERATIONS) m.analysis = C2D_ANALYSIS_ITERATIONS;
  m.iteration_limit = ours.iteration_limit == 0 ? 50 : ours.iteration_limit;
  ours.title[sizeof ours.title - 1] = '\0';
  memcpy(m.title, ours.title, sizeof m.title);
  return built(s);
}

extern "C" c2d_status c2d_set_units(c2d_solver* s, const char* length, const char* force) {
  constexpr uint32_t kWithModel =
      state_bit(C2D_STATE_MODEL) | state_bit(C2D_STATE_PREPARED) | state_bit(C2D_STATE_RUNNING);
  const c2d_status status = enter(s, kBuilding | kWithModel);
  if (status != C2D_OK) return status;
  const char* const names[2] = {length ? length : "", force ? force : ""};
  char* const places[2] = {s->model.unit_length, s->model.unit_force};
  static_assert(sizeof s->model.unit_length == 16 && sizeof s->model.unit_force == 16, "as the header says");
  for (const char* name : names)
    if (place_of('\0', name, 16) == 16)
      return refuse(s, C2D_ERR_ARGUMENT, "the name of a unit is too long, expected at most 15 characters");
  for (int i = 0; i < 2; ++i) {
    memset(places[i], 0, 16);
    memcpy(places[i], names[i], static_cast<size_t>(text_length(names[i])));
  }
  if (s->state != C2D_STATE_EMPTY) return C2D_OK;
  return built(s);
}

namespace {

c2d_status check_body(c2d_solver* s, int32_t body, const c2d_body& data) {
  const BodySizes& sizes = s->sizes.body[body - 1];
  if (!in_range(data.element_nodes, 2, 4))
    return refuse_number(s, C2D_ERR_ARGUMENT, "geometry nodes per element", data.element_nodes, 2, 4);
  if (!in_range(data.elements, 1, sizes.elements))
    return refuse_number(s, C2D_ERR_LIMIT, "number of elements", data.elements, 1, sizes.elements);
  if (!in_range(data.regions, 1, sizes.regions))
    return refuse_number(s, C2D_ERR_LIMIT, "number of regions", data.regions, 1, sizes.regions);
  if (!in_range(data.open_regions, 0, data.regions))
    return refuse_number(s, C2D_ERR_ARGUMENT, "number of open regions", data.open_regions, 0, data.regions);
  const int64_t points = static_cast<int64_t>(data.elements) * (data.element_nodes - 1) + data.open_regions;
  if (points > sizes.geometry_nodes)
    return refuse_number(s, C2D_ERR_LIMIT, "number of boundary points", points, 1, sizes.geometry_nodes);
  if (!is_usable(data.youngs_modulus) || data.youngs_modulus <= 0.0)
    return refuse_value(s, "Young's modulus", data.youngs_modulus, "a positive number");
  if (!is_usable(data.poisson_ratio) || data.poisson_ratio <= -1.0 || data.poisson_ratio > 0.5)
    return refuse_value(s, "Poisson's ratio", data.poisson_ratio, "more than -1 and at most 0.5");
  return C2D_OK;
}

} // namespace

extern "C" c2d_status c2d_set_body(c2d_solver* s, int32_t body, const c2d_body* data) {
  c2d_status status = enter_building(s);
  c2d_body ours;
  if (status != C2D_OK) return status;
  if (!data || !copy_in(data, &ours, sizeof ours)) return refuse(s, C2D_ERR_ARGUMENT, "no body given");
  status = check_body_number(s, body);
  if (status == C2D_OK) status = check_body(s, body, ours);
  if (status != C2D_OK) return status;
  Body& b = s->model.body[body - 1];
  const bool same = ours.element_nodes == b.element_nodes && ours.elements == b.elements &&
                    ours.regions == b.regions && ours.open_regions == b.open_regions;
  if (b.is_set && !same)
    return refuse(s, C2D_ERR_ARGUMENT, "this body was given before, with other numbers of elements or regions");
  b.youngs_modulus = ours.youngs_modulus;
  b.poisson_ratio = ours.poisson_ratio;
  if (b.is_set) return built(s);
  b.element_nodes = ours.element_nodes;
  b.elements = ours.elements;
  b.open_regions = ours.open_regions;
  b.geometry_nodes = ours.elements * (ours.element_nodes - 1) + b.open_regions;
  b.regions = ours.regions;
  b.nodes = s->sizes.function_nodes == 1 ? ours.elements
                                         : ours.elements * (s->sizes.function_nodes - 1) + b.open_regions;
  b.region_count = 0;
  b.is_set = 1;
  return built(s);
}

extern "C" c2d_status c2d_add_region(c2d_solver* s, int32_t body, int32_t first, int32_t last) {
  c2d_status status = enter_building(s);
  if (status == C2D_OK) status = check_body_number(s, body);
  if (status != C2D_OK) return status;
  Body& b = s->model.body[body - 1];
  if (!b.is_set) return refuse(s, C2D_ERR_ARGUMENT, "give the body before its regions");
  if (b.region_count >= b.regions)
    return refuse_number(s, C2D_ERR_LIMIT, "number of regions", b.region_count + 1, b.regions, b.regions);
  Region* regions = array_of<Region>(s, kRegions + body - 1);
  const int32_t expected = b.region_count == 0 ? 1 : regions[b.region_count - 1].last + 2;
  if (first != expected)
    return refuse_number(s, C2D_ERR_ARGUMENT, "first element of the region", first, expected, expected);
  if (!in_range(last, first, b.elements))
    return refuse_number(s, C2D_ERR_ARGUMENT, "last element of the region", last, first, b.elements);
  if (b.region_count + 1 == b.regions && last != b.elements)
    return refuse_number(s, C2D_ERR_ARGUMENT, "last element of the last region", last, b.elements, b.elements);
  const int32_t index = b.region_count, open = b.open_regions;
  regions[b.region_count++] = Region{first - 1, last - 1, index < open ? 1 : 0, index < open ? index : open};
  return built(s);
}

extern "C" c2d_status c2d_set_nodes(c2d_solver* s, int32_t body, int32_t first, int32_t count, const double* xy,
                                    int64_t stride) {
  c2d_status status = enter_building(s);
  if (status == C2D_OK) status = check_body_number(s, body);
  if (status != C2D_OK) return status;
  const Body& b = s->model.body[body - 1];
  if (!b.is_set) return refuse(s, C2D_ERR_ARGUMENT, "give the body before its boundary points");
  if (count < 0 || (count > 0 && !xy)) return refuse(s, C2D_ERR_ARGUMENT, "no coordinates given");
  if (count == 0) return built(s);
  if (!in_range(first, 1, b.geometry_nodes))
    return refuse_number(s, C2D_ERR_ARGUMENT, "boundary point number", first, 1, b.geometry_nodes);
  if (count > b.geometry_nodes - first + 1)
    return refuse_number(s, C2D_ERR_ARGUMENT, "last boundary point number", static_cast<int64_t>(first) + count - 1,
                         1, b.geometry_nodes);
  for (int32_t i = 0; i < count; ++i)
    for (int k = 0; k < 2; ++k)
      if (!is_usable(xy[i * stride + k])) return refuse_value(s, "a coordinate", xy[i * stride + k], "a finite number");
  const Model m = model_of(s);
  for (int32_t i = 0; i < count; ++i) {
    double* to = m.xy[body - 1] + 2 * static_cast<int64_t>(first - 1 + i);
    to[0] = xy[i * stride];
    to[1] = xy[i * stride + 1];
    m.node_line[body - 1][first - 1 + i] = s->model.line;
  }
  return built(s);
}

namespace {

c2d_status check_condition(c2d_solver* s, int32_t body, int32_t element, int32_t local, const int32_t codes[4],
                           const double values[4], int32_t load_case) {
  const Body& b = s->model.body[body - 1];
  if (!b.is_set || b.region_count < b.regions)
    return refuse(s, C2D_ERR_ARGUMENT, "give the body and all its regions before its conditions");
  if (!in_range(element, 1, b.elements))
    return refuse_number(s, C2D_ERR_ARGUMENT, "element number", element, 1, b.elements);
  if (!in_range(local, 1, s->sizes.function_nodes))
    return refuse_number(s, C2D_ERR_ARGUMENT, "local functional node", local, 1, s->sizes.function_nodes);
  if (!in_range(load_case, 1, s->sizes.load_cases))
    return refuse_number(s, C2D_ERR_ARGUMENT, "load case", load_case, 1, s->sizes.load_cases);
  if (!codes || !values) return refuse(s, C2D_ERR_ARGUMENT, "no codes or values given");
  for (int k = 0; k < 4; ++k) {
    if (!in_range(codes[k], 0, 1)) return refuse_number(s, C2D_ERR_ARGUMENT, "condition code", codes[k], 0, 1);
    if (codes[k] == 0 && !is_usable(values[k]))
      return refuse_value(s, "a prescribed value", values[k], "a finite number");
  }
  return C2D_OK;
}

// The other end at this node may have said something else about the same displacement.
bool displacement_agrees(const Model& m, int b, int32_t node, int32_t end, int component, int32_t load_case,
                         double value) {
  int32_t ends[2];
  const int count = ends_at_node(m, b, node, ends);
  for (int i = 0; i < count; ++i) {
    if (ends[i] == end) continue;
    if ((m.end_code[b][ends[i]] & (component == 0 ? kKnownUx : kKnownUy)) == 0) continue;
    const int64_t at = (static_cast<int64_t>(load_case) * m.head->body[b].nodes + node) * 2 + component;
    const double known = m.node_disp[b][at];
    if (load_case > 0 && known == 0.0) continue; // the codes are older than this case's values
    if (known != value) return false;
  }
  return true;
}

} // namespace

extern "C" c2d_status c2d_set_condition(c2d_solver* s, int32_t body, int32_t element, int32_t local,
                                        const int32_t codes[4], const double values[4], int32_t load_case) {
  c2d_status status = enter_building(s);
  if (status == C2D_OK) status = check_body_number(s, body);
  if (status == C2D_OK) status = check_condition(s, body, element, local, codes, values, load_case);
  if (status != C2D_OK) return status;
  const Model m = model_of(s);
  const int b = body - 1;
  const int32_t end = (element - 1) * s->sizes.function_nodes + local - 1;
  const int32_t node = functional_node(m, b, element - 1, local - 1);
  for (int c = 0; c < 2; ++c)
    if (codes[2 + c] == 0 && !displacement_agrees(m, b, node, end, c, load_case - 1, values[2 + c]))
      return refuse(s, C2D_ERR_ARGUMENT,
                    c == 0 ? "the two ends at this node prescribe different x-displacements"
                           : "the two ends at this node prescribe different y-displacements");
  const int64_t ends = static_cast<int64_t>(m.head->body[b].elements) * s->sizes.function_nodes;
  uint8_t code = kGiven;
  for (int k = 0; k < 4; ++k)
    if (codes[k] == 0) code = static_cast<uint8_t>(code | (1 << k));
  m.end_code[b][end] = code;
  m.end_line[b][end] = s->model.line;
  for (int c = 0; c < 2; ++c) {
    m.end_traction[b][((load_case - 1) * ends + end) * 2 + c] = codes[c] == 0 ? values[c] : 0.0;
    if (codes[2 + c] == 0)
      m.node_disp[b][(static_cast<int64_t>(load_case - 1) * m.head->body[b].nodes + node) * 2 + c] = values[2 + c];
  }
  return built(s);
}

extern "C" c2d_status c2d_add_point_load(c2d_solver* s, int32_t body, double x, double y, double fx, double fy,
                                         int32_t load_case) {
  c2d_status status = enter_building(s);
  if (status == C2D_OK) status = check_body_number(s, body);
  if (status != C2D_OK) return status;
  if (!in_range(load_case, 1, s->sizes.load_cases))
    return refuse_number(s, C2D_ERR_ARGUMENT, "load case", load_case, 1, s->sizes.load_cases);
  const double numbers[4] = {x, y, fx, fy};
  for (double number : numbers)
    if (!is_usable(number)) return refuse_value(s, "a number of the point load", number, "a finite number");
  if (s->model.point_loads >= s->sizes.point_loads)
    return refuse_number(s, C2D_ERR_LIMIT, "number of point loads", s->model.point_loads + 1, 0, s->sizes.point_loads);
  array_of<PointLoad>(s, kPointLoads)[s->model.point_loads++] =
      PointLoad{body - 1, load_case - 1, s->model.line, s->model.column, x, y, fx, fy};
  return built(s);
}

extern "C" c2d_status c2d_set_rigid(c2d_solver* s, int32_t load_case, double ux, double uy, double rotation, double x0,
                                    double y0) {
  const c2d_status status = enter_building(s);
  if (status != C2D_OK) return status;
  if (s->sizes.bodies < 2) return refuse(s, C2D_ERR_ARGUMENT, "a rigid body 1 needs a second one that is not");
  if (!in_range(load_case, 0, s->sizes.load_cases))
    return refuse_number(s, C2D_ERR_ARGUMENT, "load case", load_case, 0, s->sizes.load_cases);
  const double numbers[5] = {ux, uy, rotation, x0, y0};
  for (double number : numbers)
    if (!is_usable(number)) return refuse_value(s, "a number of the rigid motion", number, "a finite number");
  s->model.rigid = 1;
  if (load_case > 0) array_of<RigidMotion>(s, kRigidMotions)[load_case - 1] = RigidMotion{ux, uy, rotation, x0, y0};
  return built(s);
}

extern "C" c2d_status c2d_set_interference(c2d_solver* s, int32_t load_case) {
  const c2d_status status = enter_building(s);
  if (status != C2D_OK) return status;
  if (!in_range(load_case, 1, s->sizes.load_cases))
    return refuse_number(s, C2D_ERR_ARGUMENT, "load case", load_case, 1, s->sizes.load_cases);
  s->model.interference = load_case;
  return built(s);
}

extern "C" c2d_status c2d_set_body_force(c2d_solver* s, int32_t body, int32_t load_case, double bx, double by,
                                         double rho_omega2, double x0, double y0) {
  c2d_status status = enter_building(s);
  if (status == C2D_OK) status = check_body_number(s, body);
  if (status != C2D_OK) return status;
  if (!in_range(load_case, 1, s->sizes.load_cases))
    return refuse_number(s, C2D_ERR_ARGUMENT, "load case", load_case, 1, s->sizes.load_cases);
  const double numbers[5] = {bx, by, rho_omega2, x0, y0};
  for (double number : numbers)
    if (!is_usable(number)) return refuse_value(s, "a number of the body force", number, "a finite number");
  array_of<BodyForce>(s, kBodyForces)[2 * static_cast<int64_t>(load_case - 1) + body - 1] =
      BodyForce{bx, by, rho_omega2, x0, y0};
  s->model.body_forces |= 1 << (body - 1);
  return built(s);
}

namespace {

// Steps of +1 or -1 that lead from first to last in count-1 steps, round the ring [start, start + size) if there is one;
// 0: none does. `preferred` decides where both do.
int32_t range_step(int64_t first, int64_t last, int64_t count, int64_t start, int64_t size, int32_t preferred) {
  for (int32_t sign = 1; sign >= -1; sign -= 2)
    if (first + sign * (count - 1) == last && (count > 1 || sign == preferred)) return sign;
  for (int32_t sign = 1; sign >= -1 && size > 0; sign -= 2) {
    const int64_t turned = ((first - start + sign * (count - 1)) % size + size) % size + start;
    if (count <= size && turned == last) return sign;
  }
  return 0;
}

c2d_status fill_zone(c2d_solver* s, const Model& m, const c2d_zone& given, Zone& z) {
  for (int b = 0; b < 2; ++b) {
    const Body& body = m.head->body[b];
    const int32_t elements[2] = {given.first_element[b], given.last_element[b]};
    const int32_t nodes[2] = {given.first_node[b], given.last_node[b]};
    for (int32_t element : elements)
      if (!in_range(element, 1, body.elements))
        return refuse_number(s, C2D_ERR_ARGUMENT, b == 0 ? "contact element of body 1" : "contact element of body 2",
                             element, 1, body.elements);
    for (int32_t node : nodes)
      if (!in_range(node, 1, body.nodes))
        return refuse_number(s, C2D_ERR_ARGUMENT, b == 0 ? "contact node of body 1" : "contact node of body 2", node, 1,
                             body.nodes);
    z.first_element[b] = given.first_element[b] - 1;
    z.first_node[b] = given.first_node[b] - 1;
    z.region[b] = region_of_element(m, b, z.first_element[b]);
    const Region region = m.region[b][z.region[b]];
    int32_t first_node, last_node;
    nodes_of_region(m, b, z.region[b], &first_node, &last_node);
    // An open region is no ring to go round.
    const int64_t ring = region.open ? 0 : region.last - region.first + 1;
    const int64_t node_ring = region.open ? 0 : last_node - first_node + 1;
    const int32_t by_nodes = given.last_node[b] >= given.first_node[b] ? 1 : -1;
    z.element_step[b] =
        range_step(z.first_element[b], given.last_element[b] - 1, given.elements, region.first, ring, by_nodes);
    z.node_step[b] = range_step(z.first_node[b], given.last_node[b] - 1, given.pairs,
                                first_node, node_ring,
                                z.element_step[b] == 0 ? 1 : z.element_step[b]);
    if (z.element_step[b] == 0)
      return refuse(s, C2D_ERR_ARGUMENT,
                    b == 0 ? "the element range of body 1 does not hold the number of elements given"
                           : "the element range of body 2 does not hold the number of elements given");
    if (z.node_step[b] == 0)
      return refuse(s, C2D_ERR_ARGUMENT, b == 0 ? "the node range of body 1 does not hold the number of nodes given"
                                                : "the node range of body 2 does not hold the number of nodes given");
  }
  return C2D_OK;
}

} // namespace

namespace {

// What any kind of zone needs: two bodies that are known, and room.
c2d_status check_room_for_zone(c2d_solver* s) {
  const ModelHeader& head = s->model;
  if (s->sizes.bodies < 2) return refuse(s, C2D_ERR_ARGUMENT, "a contact zone needs two bodies");
  for (const Body& body : head.body)
    if (!body.is_set || body.region_count < body.regions)
      return refuse(s, C2D_ERR_ARGUMENT, "give both bodies and all their regions before the contact zones");
  if (head.zones >= s->sizes.zones)
    return refuse_number(s, C2D_ERR_LIMIT, "number of contact zones", head.zones + 1, 0, s->sizes.zones);
  return C2D_OK;
}

} // namespace

extern "C" c2d_status c2d_add_zone(c2d_solver* s, const c2d_zone* zone) {
  c2d_status status = enter_building(s);
  c2d_zone given;
  if (status != C2D_OK) return status;
  if (!zone || !copy_in(zone, &given, sizeof given)) return refuse(s, C2D_ERR_ARGUMENT, "no zone given");
  ModelHeader& head = s->model;
  status = check_room_for_zone(s);
  if (status != C2D_OK) return status;
  if (!in_range(given.pairs, 1, s->sizes.pairs - head.pairs))
    return refuse_number(s, C2D_ERR_LIMIT, "number of contact pairs", given.pairs, 1, s->sizes.pairs - head.pairs);
  if (!in_range(given.elements, 1, s->sizes.contact_elements - head.contact_elements))
    return refuse_number(s, C2D_ERR_LIMIT, "number of contact elements", given.elements, 1,
                         s->sizes.contact_elements - head.contact_elements);
  const Model m = model_of(s);
  Zone z;
  memset(&z, 0, sizeof z);
  z.pairs = given.pairs;
  z.elements = given.elements;
  z.first_pair = head.pairs;
  z.line = head.line;
  status = fill_zone(s, m, given, z);
  if (status != C2D_OK) return status;
  m.zone[head.zones++] = z;
  head.pairs += z.pairs;
  head.contact_elements += z.elements;
  return built(s);
}

namespace {

// Ranges of a free zone: body 2's runs against body 1's, whichever way they were given.
c2d_status fill_free_zone(c2d_solver* s, const Model& m, const c2d_free_zone& given, Zone& z) {
  for (int b = 0; b < 2; ++b) {
    const Body& body = m.head->body[b];
    const int32_t ends[2] = {given.first_element[b], given.last_element[b]};
    for (int32_t element : ends)
      if (!in_range(element, 1, body.elements))
        return refuse_number(s, C2D_ERR_ARGUMENT, b == 0 ? "contact element of body 1" : "contact element of body 2",
                             element, 1, body.elements);
    const int32_t distance = ends[1] > ends[0] ? ends[1] - ends[0] : ends[0] - ends[1];
    const int32_t count = given.elements[b] == 0 ? distance + 1 : given.elements[b];
    z.region[b] = region_of_element(m, b, ends[0] - 1);
    const Region& region = m.region[b][z.region[b]];
    const int64_t ring = region.open ? 0 : region.last - region.first + 1;
    z.first_element[b] = ends[0] - 1;
    z.element_step[b] = count < 1 ? 0 : range_step(ends[0] - 1, ends[1] - 1, count, region.first, ring, 1);
    (b == 0 ? z.facing : z.elements) = count;
    if (z.element_step[b] == 0 || region_of_element(m, b, ends[1] - 1) != z.region[b])
      return refuse(s, C2D_ERR_ARGUMENT,
                    b == 0 ? "the element range of body 1 does not hold the number of elements given, in one region"
                           : "the element range of body 2 does not hold the number of elements given, in one region");
  }
  if (z.element_step[1] == z.element_step[0]) {
    z.first_element[1] = given.last_element[1] - 1;
    z.element_step[1] = -z.element_step[1];
  }
  return C2D_OK;
}

} // namespace

extern "C" c2d_status c2d_add_free_zone(c2d_solver* s, const c2d_free_zone* zone) {
  c2d_status status = enter_building(s);
  c2d_free_zone given;
  if (status != C2D_OK) return status;
  if (!zone || !copy_in(zone, &given, sizeof given)) return refuse(s, C2D_ERR_ARGUMENT, "no zone given");
  ModelHeader& head = s->model;
  status = check_room_for_zone(s);
  if (status != C2D_OK) return status;
  const Model m = model_of(s);
  Zone z;
  memset(&z, 0, sizeof z);
  status = fill_free_zone(s, m, given, z);
  if (status != C2D_OK) return status;
  const int32_t f = s->sizes.function_nodes;
  const int64_t pairs = f == 1 ? z.elements : static_cast<int64_t>(z.elements) * (f - 1) + 1;
  int64_t others = 0; // pairs of the other free zones
  for (int32_t i = 0; i < head.zones; ++i) others += m.zone[i].is_free != 0 ? m.zone[i].pairs : 0;
  if (pairs > s->sizes.pairs - head.pairs)
    return refuse_number(s, C2D_ERR_LIMIT, "number of contact pairs", pairs, 1, s->sizes.pairs - head.pairs);
  if (pairs > s->sizes.free_pairs - others)
    return refuse_number(s, C2D_ERR_LIMIT, "number of pairs of free zones", pairs, 1, s->sizes.free_pairs - others);
  if (z.elements > s->sizes.contact_elements - head.contact_elements)
    return refuse_number(s, C2D_ERR_LIMIT, "number of contact elements", z.elements, 1,
                         s->sizes.contact_elements - head.contact_elements);
  z.is_free = 1;
  z.pairs = static_cast<int32_t>(pairs);
  z.node_step[1] = z.element_step[1];
  z.first_node[1] = functional_node(m, 1, z.first_element[1], z.element_step[1] > 0 ? 0 : f - 1);
  z.first_pair = head.pairs;
  z.line = head.line;
  m.zone[head.zones++] = z;
  head.pairs += z.pairs;
  head.contact_elements += z.elements;
  return built(s);
}

namespace c2d {
// Zero or more; infinity is full adhesion. Not-a-numbers are told apart without comparing them.
bool is_coefficient(double mu) { return isinf(mu) ? mu > 0.0 : (is_usable(mu) && mu >= 0.0); }
double* zone_friction(c2d_solver* s, int32_t i) {
  return array_of<double>(s, kFriction) + s->sizes.coefficients + i * s->sizes.zones;
}
double coefficient_of_zone(c2d_solver* s, int32_t zone, int32_t i) {
  if (s->model.coefficients == 0) return 0.0;
  const double own = zone < s->model.zones ? zone_friction(s, i)[zone] : -1.0;
  return own < 0.0 ? array_of<double>(s, kFriction)[i] : own;
}
} // namespace c2d

extern "C" c2d_status c2d_set_symmetry(c2d_solver* s, int32_t axis, double value) {
  const c2d_status status = enter_building(s);
  if (status != C2D_OK) return status;
  if (!in_range(axis, 0, 1)) return refuse_number(s, C2D_ERR_ARGUMENT, "axis of symmetry", axis, 0, 1);
  if (!is_usable(value)) return refuse_value(s, "place of the line of symmetry", value, "a finite number");
  ModelHeader& m = s->model;
  if ((m.symmetry_asked >> axis & 1) != 0)
    return refuse(s, C2D_ERR_ARGUMENT,
                  axis == 0 ? "a second line of symmetry x = value, expected one at most"
                            : "a second line of symmetry y = value, expected one at most");
  m.symmetry_asked |= 1 << axis;
  m.line_at[axis] = value;
  return built(s);
}

extern "C" c2d_status c2d_add_friction(c2d_solver* s, double mu) {
  const c2d_status status = enter_building(s);
  if (status != C2D_OK) return status;
  if (!is_coefficient(mu)) return refuse_value(s, "coefficient of friction", mu, "zero or more");
  if (s->model.coefficients >= s->sizes.coefficients)
    return refuse_number(s, C2D_ERR_LIMIT, "number of coefficients of friction", s->model.coefficients + 1, 0,
                         s->sizes.coefficients);
  const int32_t i = s->model.coefficients++;
  array_of<double>(s, kFriction)[i] = mu;
  double* zones = zone_friction(s, i);
  for (int64_t z = 0; z < s->sizes.zones; ++z) zones[z] = -1.0;
  return built(s);
}

extern "C" c2d_status c2d_set_zone_friction(c2d_solver* s, int32_t zone, int32_t i, double mu) {
  const c2d_status status = enter_building(s);
  if (status != C2D_OK) return status;
  if (!is_coefficient(mu)) return refuse_value(s, "coefficient of friction", mu, "zero or more");
  if (!in_range(zone, 1, s->model.zones))
    return refuse_number(s, C2D_ERR_ARGUMENT, "contact zone", zone, 1, s->model.zones);
  if (!in_range(i, 1, s->model.coefficients))
    return refuse_number(s, C2D_ERR_ARGUMENT, "number of the coefficient of friction", i, 1, s->model.coefficients);
  zone_friction(s, i - 1)[zone - 1] = mu;
  return built(s);
}

extern "C" c2d_status c2d_add_path(c2d_solver* s, int32_t increments, double load) {
  const c2d_status status = enter_building(s);
  if (status != C2D_OK) return status;
  if (increments < 1)
    return refuse_number(s, C2D_ERR_ARGUMENT, "number of increments", increments, 1, INT32_MAX);
  if (!is_usable(load)) return refuse_value(s, "load factor", load, "a finite number");
  if (s->model.paths >= s->sizes.paths)
    return refuse_number(s, C2D_ERR_LIMIT, "number of load cards", s->model.paths + 1, 0, s->sizes.paths);
  double* factors = array_of<double>(s, kPathLoads) + static_cast<int64_t>(s->model.paths) * s->sizes.load_cases;
  for (int32_t k = 0; k < s->sizes.load_cases; ++k) factors[k] = k == 0 ? load : 0.0;
  array_of<Path>(s, kPaths)[s->model.paths++] = Path{increments, 0, load};
  return built(s);
}

extern "C" c2d_status c2d_add_path_point(c2d_solver* s, int32_t increments, const double* load, int32_t cases) {
  c2d_status status = enter_building(s);
  if (status != C2D_OK) return status;
  if (cases != s->sizes.load_cases)
    return refuse_number(s, C2D_ERR_ARGUMENT, "number of load factors", cases, s->sizes.load_cases,
                         s->sizes.load_cases);
  if (!load) return refuse(s, C2D_ERR_ARGUMENT, "no load factors given");
  for (int32_t k = 0; k < cases; ++k)
    if (!is_usable(load[k])) return refuse_value(s, "load factor", load[k], "a finite number");
  status = c2d_add_path(s, increments, load[0]);
  if (status != C2D_OK) return status;
  double* factors = array_of<double>(s, kPathLoads) + static_cast<int64_t>(s->model.paths - 1) * cases;
  for (int32_t k = 0; k < cases; ++k) factors[k] = load[k];
  return built(s);
}

extern "C" c2d_status c2d_clear_paths(c2d_solver* s) {
  const c2d_status status = enter_building(s);
  if (status != C2D_OK) return status;
  s->model.paths = 0;
  return built(s);
}

extern "C" c2d_status c2d_complete(c2d_solver* s) {
  const c2d_status status = enter(s, state_bit(C2D_STATE_BUILDING));
  if (status != C2D_OK) return status;
  s->model.line = s->model.column = s->model.column_end = 0;
  Reporter reporter{s, [](void* solver, const c2d_error& e) { report_fault(static_cast<c2d_solver*>(solver), e); }, 0};
  const Model m = model_of(s);
  m.head->images = s->options.symmetry == C2D_SYMMETRY_IMAGES;
  if (!complete_model(m, reporter)) {
    const c2d_error first = s->error;
    clear_model(s);
    s->error = first;
    return C2D_ERR_INPUT;
  }
  for (int b = 0; b < m.head->bodies; ++b) number_unknowns(m, b);
  s->state = C2D_STATE_MODEL;
  return C2D_OK;
}

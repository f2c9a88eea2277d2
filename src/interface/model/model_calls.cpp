// Model calls: problem, bodies, regions, completion. Every call checks its arguments; if they are wrong it changes nothing
// and reports the reason.
#include <string.h>

#include "bie/columns.hpp"
#include "contact/pairs/frames.hpp"
#include "interface/model/refuse.hpp"
#include "memory/characters.hpp"
#include "memory/parts.hpp"
#include "model/symmetry.hpp"

namespace c2d {
C2D_MEETS(SymmetryPart, c2d_set_symmetry); // c2d_set_options can request images
C2D_MEETS(HolePart, c2d_link_holes);
C2D_MEETS(RingPart, c2d_link_axisymmetric);
C2D_MEETS(CompressedPart, c2d_link_compressed);
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
  status = take(s, "c2d_options", options, ours);
  if (status != C2D_OK) return status;
  if (!in_range(ours.quadrature, 0, 1) || !in_range(ours.stepping, 0, 1) || !in_range(ours.every_change, 0, 1) ||
      !in_range(ours.symmetry, 0, 1) || !in_range(ours.keep_factors, 0, 1) || !in_range(ours.elimination, 0, 2))
    return fail(s, C2D_ERR_ARGUMENT, "an option is out of range");
  if (ours.elimination == C2D_ELIMINATION_BY_SIZE)
    ours.elimination = kSmallCode ? C2D_ELIMINATION_DENSE : kCompressedPart.elimination_by_size(sizes_of(s));
  if (ours.symmetry == C2D_SYMMETRY_IMAGES && !kSymmetryPart.linked)
    return refuse_part(s, "symmetry by images", "c2d_set_symmetry");
  if (ours.elimination != C2D_ELIMINATION_DENSE && !kCompressedPart.linked)
    return fail(s, C2D_ERR_ARGUMENT,
                "this program is linked without compressed elimination: c2d_link_compressed links it, but not in small code");
  if (s->state == C2D_STATE_MODEL && ours.symmetry != s->options.symmetry)
    return fail(s, C2D_ERR_STATE, "symmetry by images can be chosen only before c2d_complete");
  if (ours.quadrature != s->options.quadrature || ours.keep_factors != s->options.keep_factors ||
      (!kSmallCode && ours.elimination != s->options.elimination))
    s->factors = 0;
  s->options = ours;
  return C2D_OK;
}

extern "C" c2d_status c2d_set_problem(c2d_solver* s, const c2d_problem* problem) {
  c2d_status status = enter_building(s);
  c2d_problem ours;
  if (status != C2D_OK) return status;
  status = take(s, "c2d_problem", problem, ours);
  if (status != C2D_OK) return status;
  if (!in_range(ours.plane, 0, kRings ? 2 : 1))
    return refuse_number(s, C2D_ERR_ARGUMENT, "plane strain or stress, or axisymmetric (IPTYPE)", ours.plane, 0,
                         kRings ? 2 : 1);
  if (kRings && ours.plane == C2D_AXISYMMETRIC && !kRingPart.linked)
    return refuse_part(s, "a body of revolution", "c2d_link_axisymmetric");
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
  const c2d_status status = enter(s, kBuilding | kComplete);
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
  const BodySizes sizes = sizes_of_body(sizes_of(s), body - 1);
  if (!in_range(data.element_nodes, 2, 4))
    return refuse_number(s, C2D_ERR_ARGUMENT, "geometry nodes per element", data.element_nodes, 2, 4);
  const int64_t points = static_cast<int64_t>(data.elements) * (data.element_nodes - 1) + data.open_regions;
  const Ranged counts[] = {{"number of elements", data.elements, 1, INT32_MAX},
                           {"number of regions", data.regions, 1, INT32_MAX},
                           {"number of open regions", data.open_regions, 0, data.regions}};
  const c2d_status status = check_ranges(s, counts);
  if (status != C2D_OK) return status;
  if (data.elements > sizes.elements) return refuse_body_limit(s, body, "elements", sizes.elements, data.elements);
  if (data.regions > sizes.regions) return refuse_body_limit(s, body, "regions", sizes.regions, data.regions);
  if (data.regions > 1 && !kHolePart.linked) return refuse_part(s, "more than one region", "c2d_link_holes");
  if (points > sizes.geometry_nodes) return refuse_body_limit(s, body, "points", sizes.geometry_nodes, points);
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
  status = take(s, "c2d_body", data, ours);
  if (status == C2D_OK) status = check_body_number(s, body);
  if (status == C2D_OK) status = check_body(s, body, ours);
  if (status != C2D_OK) return status;
  Body& b = body_numbered(s, body);
  const bool same = ours.element_nodes == b.element_nodes && ours.elements == b.elements && ours.regions == b.regions &&
                    ours.open_regions == b.open_regions;
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
  b.nodes = s->sizes.function_nodes == 1 ? ours.elements : ours.elements * (s->sizes.function_nodes - 1) + b.open_regions;
  b.region_count = 0;
  b.is_set = 1;
  return built(s);
}

extern "C" c2d_status c2d_add_region(c2d_solver* s, int32_t body, int32_t first, int32_t last) {
  c2d_status status = enter_building(s);
  if (status == C2D_OK) status = check_body_number(s, body);
  if (status != C2D_OK) return status;
  Body& b = body_numbered(s, body);
  if (!b.is_set) return refuse(s, C2D_ERR_ARGUMENT, "give the body before its regions");
  if (b.region_count >= b.regions)
    return refuse_number(s, C2D_ERR_LIMIT, "number of regions", b.region_count + 1, b.regions, b.regions);
  Region* regions = model_of(s).region[body - 1];
  const int32_t expected = b.region_count == 0 ? 1 : regions[b.region_count - 1].last + 2;
  if (first != expected) return refuse_number(s, C2D_ERR_ARGUMENT, "first element of the region", first, expected, expected);
  if (!in_range(last, first, b.elements))
    return refuse_number(s, C2D_ERR_ARGUMENT, "last element of the region", last, first, b.elements);
  if (b.region_count + 1 == b.regions && last != b.elements)
    return refuse_number(s, C2D_ERR_ARGUMENT, "last element of the last region", last, b.elements, b.elements);
  const int32_t index = b.region_count, open = b.open_regions;
  regions[b.region_count++] = Region{first - 1, last - 1, index < open ? 1 : 0, index < open ? index : open};
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
    clear_model(s);
    return C2D_ERR_INPUT;
  }
  for (int b = 0; b < m.head->bodies; ++b) number_unknowns(m, b);
  s->state = C2D_STATE_MODEL;
  return C2D_OK;
}

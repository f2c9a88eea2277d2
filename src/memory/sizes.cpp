// Sizes that follow from the caller's limits, and the layout of the workspace. c2d_memory_need and the solver use the same
// functions, so the size reported and the size used cannot differ. All products are checked for overflow: limits come from the
// caller and may be any number.
#include "memory/sizes.hpp"

namespace c2d {

bool add_bytes(uint64_t& sum, uint64_t count, uint64_t size) {
  if (count >> 32 != 0 && size >> 32 != 0) return false;
  // One factor is below 2^32, so two partial products suffice.
  const uint64_t wide = count > size ? count : size, narrow = count > size ? size : count; // below 2^32
  const uint64_t high = (wide >> 32) * narrow, low = (wide & UINT32_MAX) * narrow;
  const uint64_t bytes = (high << 32) + low;
  if (high >> 32 != 0 || bytes < low || bytes > UINT64_MAX - sum) return false;
  sum += bytes;
  return true;
}

// A failed sum stays failed, so one check at the end is enough.
uint64_t Carver::carve(uint64_t count, uint64_t size) {
  const uint64_t at = used;
  fits = fits && add_bytes(used, count, size) && used <= UINT64_MAX - 2 * kAlignment;
  if (fits) used = (used + 7) / 8 * 8;
  return at;
}
uint64_t round_up(uint64_t bytes) { return (bytes + kAlignment - 1) / kAlignment * kAlignment; }

namespace {

bool is_wrong(WrongLimit& out, const char* member, int32_t body, int32_t value, int32_t least, int32_t most = INT32_MAX) {
  out = WrongLimit{member, body, value, least, most};
  return value < least || value > most;
}

} // namespace

bool find_wrong_limit(const c2d_limits& l, WrongLimit& out) {
  if (is_wrong(out, "bodies", -1, l.bodies, 1) || is_wrong(out, "function_nodes", -1, l.function_nodes, 1, 4)) return true;
  if (l.body == nullptr) {
    out = WrongLimit{nullptr, -1, 0, 0, 0};
    return true;
  }
  for (int b = 0; b < l.bodies; ++b)
    if (is_wrong(out, "points", b, l.body[b].points, 1) || is_wrong(out, "elements", b, l.body[b].elements, 1) ||
        is_wrong(out, "regions", b, l.body[b].regions, 1))
      return true;
  const struct {
    const char* member;
    int32_t value;
  } counts[] = {{"zones", l.zones},
                {"pairs", l.pairs},
                {"contact_elements", l.contact_elements},
                {"point_loads", l.point_loads},
                {"coefficients", l.coefficients},
                {"paths", l.paths},
                {"load_cases", l.load_cases},
                {"panel_columns", l.panel_columns},
                {"point_sets", l.point_sets},
                {"curves", l.curves},
                {"cycle_states", l.cycle_states}};
  for (const auto& count : counts)
    if (is_wrong(out, count.member, -1, count.value, 0)) return true;
  // (each platen has a zone of its own)
  const int32_t most_platens = l.zones < INT32_MAX - l.bodies ? l.zones : INT32_MAX - l.bodies;
  return is_wrong(out, "free_pairs", -1, l.free_pairs, 0, l.pairs) ||
         is_wrong(out, "platens", -1, l.platens, 0, most_platens) || is_wrong(out, "touching", -1, l.touching, 0, l.pairs);
}

BodySizes sizes_of_body(const Sizes& sizes, int b) {
  BodySizes body{};
  // Platens are rigid and have no mesh.
  if (b >= sizes.bodies - sizes.platens) return body;
  const int64_t per_element = sizes.function_nodes == 1 ? 1 : sizes.function_nodes - 1;
  body.geometry_nodes = sizes.body[b].points;
  body.elements = sizes.body[b].elements;
  body.regions = sizes.body[b].regions;
  // A closed region has as many points as elements. Points beyond that may be ends of open regions, with a functional node
  // each.
  const int64_t beyond = body.geometry_nodes - body.elements;
  const int64_t open = beyond < body.regions ? beyond : body.regions;
  body.nodes = body.elements * per_element + (sizes.function_nodes > 1 && open > 0 ? open : 0);
  body.ends = body.elements * sizes.function_nodes;
  body.rows = 2 * body.nodes + 3 + 2 * sizes.free_pairs;
  return body;
}

int32_t elimination_by_size(const Sizes& sizes) {
  // Free zones add equations that compressed elimination does not support.
  for (int b = 0; b < sizes.bodies && sizes.free_pairs == 0; ++b)
    if (columns_of(sizes) < sizes.contact || C2D_COMPRESSES(sizes_of_body(sizes, b).nodes, sizes.pairs))
      return C2D_ELIMINATION_COMPRESSED;
  return C2D_ELIMINATION_DENSE;
}

c2d_status derive_sizes(const c2d_limits& limits, Sizes& out) {
  WrongLimit wrong;
  if (find_wrong_limit(limits, wrong)) return C2D_ERR_ARGUMENT;
  out = Sizes{};
  out.bodies = limits.bodies + limits.platens;
  out.platens = limits.platens;
  out.body = limits.body;
  out.function_nodes = limits.function_nodes;
  out.load_cases = limits.load_cases == 0 ? 1 : limits.load_cases;
  out.panel_columns = limits.panel_columns;
  out.zones = limits.zones;
  out.pairs = limits.pairs;
  out.contact_elements = limits.contact_elements;
  out.point_loads = limits.point_loads;
  out.coefficients = limits.coefficients;
  out.paths = limits.paths;
  out.contact = 2 * out.pairs;
  const int64_t motions = int64_t{3} * (out.bodies - 1); // at most: those of all bodies together are not
  out.motions = motions < out.contact ? motions : out.contact;
  out.free_pairs = limits.free_pairs;
  out.point_sets = limits.point_sets;
  out.curves = limits.curves;
  out.touching = limits.touching;
  out.cycle_states = limits.cycle_states;
  return C2D_OK;
}

c2d_limits limits_of(const Sizes& sizes) {
  c2d_limits out = c2d_limits();
  out.struct_size = static_cast<uint32_t>(sizeof out);
  const auto number = [](int64_t size) { return static_cast<int32_t>(size); };
  const uint64_t bodies = static_cast<uint64_t>(sizes.bodies) - static_cast<uint64_t>(sizes.platens); // a stranger's are any
  out.bodies = number(static_cast<int64_t>(bodies));
  out.platens = number(sizes.platens);
  out.body = sizes.body;
  out.function_nodes = sizes.function_nodes;
  out.zones = number(sizes.zones);
  out.pairs = number(sizes.pairs);
  out.contact_elements = number(sizes.contact_elements);
  out.point_loads = number(sizes.point_loads);
  out.coefficients = number(sizes.coefficients);
  out.paths = number(sizes.paths);
  out.load_cases = sizes.load_cases;
  out.panel_columns = sizes.panel_columns;
  out.free_pairs = number(sizes.free_pairs);
  out.point_sets = number(sizes.point_sets);
  out.curves = number(sizes.curves);
  out.touching = number(sizes.touching);
  out.cycle_states = number(sizes.cycle_states);
  return out;
}

namespace {

// Counts in the lists have 31 bits, so `each` fits into 64 bits; so do element ends, which are fewer than 2^34.
void carve_body(Carver& carver, const BodySizes& body, uint64_t cases, int64_t place[kBodyArrays]) {
  const uint64_t points = static_cast<uint64_t>(body.geometry_nodes), ends = static_cast<uint64_t>(body.ends),
                 nodes = static_cast<uint64_t>(body.nodes), regions = static_cast<uint64_t>(body.regions);
#define C2D_CARVE(type, name, count, each)                                                                                     \
  place[k##name] = static_cast<int64_t>(carver.carve(count, (each)*C2D_BYTES_OF_##type));
  C2D_BODY_ARRAYS_(C2D_CARVE, points, ends, nodes, regions, cases)
#undef C2D_CARVE
}

void carve_model(Carver& carver, const Sizes& s, Layout& out) {
  const uint64_t zones = static_cast<uint64_t>(s.zones), pairs = static_cast<uint64_t>(s.pairs),
                 loads = static_cast<uint64_t>(s.point_loads), coefficients = static_cast<uint64_t>(s.coefficients),
                 paths = static_cast<uint64_t>(s.paths), cases = static_cast<uint64_t>(s.load_cases),
                 sets = static_cast<uint64_t>(s.point_sets), curves = static_cast<uint64_t>(s.curves);
#define C2D_CARVE(type, name, count, each) out.offset[k##name] = carver.carve(count, (each)*C2D_BYTES_OF_##type);
  C2D_MODEL_ARRAYS_(C2D_CARVE, zones, pairs, loads, coefficients, paths, cases, sets, curves)
  const uint64_t states = static_cast<uint64_t>(s.cycle_states);
  C2D_CYCLE_ARRAYS_(C2D_CARVE, pairs, states)
#undef C2D_CARVE
}

static_assert(C2D_PAIR_FIELDS == 16, "columns of PairTable in contact2d_memory.h");

} // namespace

c2d_status lay_out(const Sizes& sizes, uint64_t header, Layout& out) {
  out = Layout{};
  Carver carver{header, true};
  const uint64_t bodies = static_cast<uint64_t>(sizes.bodies), cases = static_cast<uint64_t>(sizes.load_cases);
#define C2D_CARVE(type, name, count, each) out.offset[k##name] = carver.carve(count, (each)*C2D_BYTES_OF_##type);
  C2D_BODY_LISTS_(C2D_CARVE, bodies)
#undef C2D_CARVE
  // Arrays of one body stay together, so that a body's places follow from one number.
  out.offset[kArraysOfBodies] = carver.used;
  int64_t place[kBodyArrays];
  for (int b = 0; b < sizes.bodies && carver.fits; ++b) carve_body(carver, sizes_of_body(sizes, b), cases, place);
  carve_model(carver, sizes, out);
  carver.align();
  out.persistent = out.offset[kPhase] = carver.used;
  return carver.fits ? C2D_OK : C2D_ERR_OVERFLOW;
}

uint64_t lay_out_body(const Sizes& sizes, int b, uint64_t at, int64_t place[kBodyArrays]) {
  Carver carver{at, true};
  carve_body(carver, sizes_of_body(sizes, b), static_cast<uint64_t>(sizes.load_cases), place);
  return carver.used;
}

} // namespace c2d

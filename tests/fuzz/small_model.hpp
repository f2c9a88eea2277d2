#pragma once
// What fuzz targets and tests of the interface share: a model of two blocks made by calls, in a workspace of its own, and a
// block store in memory whose blocks can be changed and sealed again.
#include "../../include/contact2d.h"
#include "../../src/store/block.hpp"

#include <cstring>
#include <vector>

namespace small_model {

using Bytes = std::vector<unsigned char>;

// Tapes of blocks. What asks for more than a few megabytes is refused.
struct Store {
  std::vector<Bytes> tape[C2D_TAPES];
  uint64_t block_bytes[C2D_TAPES] = {};
  static Store& self(void* context) { return *static_cast<Store*>(context); }
  static int32_t open(void* context, int32_t t, uint64_t count, uint64_t bytes) {
    Store& s = self(context);
    if (t < 0 || t >= C2D_TAPES || bytes > 1 << 22 || count > (1 << 22) / (bytes + 1)) return 28;
    s.tape[t].resize(static_cast<size_t>(count));
    s.block_bytes[t] = bytes;
    for (Bytes& block : s.tape[t]) block.resize(static_cast<size_t>(bytes), 0);
    return 0;
  }
  static int32_t read(void* context, int32_t t, uint64_t block, void* data, uint64_t bytes) {
    const Store& s = self(context);
    if (block >= s.tape[t].size() || bytes > s.block_bytes[t]) return 5;
    std::memcpy(data, s.tape[t][static_cast<size_t>(block)].data(), static_cast<size_t>(bytes));
    return 0;
  }
  static int32_t write(void* context, int32_t t, uint64_t block, const void* data, uint64_t bytes) {
    Store& s = self(context);
    if (block >= s.tape[t].size() || bytes > s.block_bytes[t]) return 5;
    std::memcpy(s.tape[t][static_cast<size_t>(block)].data(), data, static_cast<size_t>(bytes));
    return 0;
  }
  static int32_t nothing(void*, int32_t) { return 0; }
  void serve(c2d_port& port) {
    port.context = this;
    port.open = open, port.read = read, port.write = write, port.sync = nothing, port.close = nothing;
  }
};

enum Variant { kPlain = 0, kKeepFactors = 1, kTied = 2, kFree = 4, kStreamed = 8, kDeckStepping = 16, kVariants = 32 };

struct Limits {
  c2d_body_limits body[2] = {{6, 6, 1, 0}, {6, 6, 1, 0}};
  c2d_limits limits = C2D_INIT(c2d_limits);
  explicit Limits(int variant) {
    limits.bodies = 2;
    limits.body = body;
    limits.function_nodes = 2;
    limits.zones = limits.paths = limits.coefficients = limits.load_cases = 2;
    limits.pairs = 3;
    limits.free_pairs = (variant & kFree) != 0 ? 3 : 0;
    limits.contact_elements = 2;
    limits.point_loads = limits.point_sets = limits.curves = 1;
    limits.panel_columns = (variant & kStreamed) != 0 ? 5 : 0;
  }
};

inline uint64_t memory_for(const c2d_limits& limits) {
  uint64_t least = 0, most = 0;
  if (c2d_memory_need(&limits, &least, &most, nullptr) != C2D_OK) return 0;
  return limits.panel_columns > 0 ? least : most;
}

// A block, 2 wide and 1 high, that stands on y = `bottom`: elements 1, 2 below, 3 on the right, 4, 5 above, 6 on the left.
inline c2d_status add_block(c2d_solver* s, int32_t b, double bottom) {
  c2d_body body = C2D_INIT(c2d_body);
  body.element_nodes = 2, body.elements = 6, body.regions = 1;
  body.youngs_modulus = 1000.0 * b, body.poisson_ratio = 0.3;
  const double xy[] = {0, bottom, 1, bottom, 2, bottom, 2, bottom + 1, 1, bottom + 1, 0, bottom + 1};
  c2d_status status = c2d_set_body(s, b, &body);
  if (status == C2D_OK) status = c2d_add_region(s, b, 1, 6);
  return status == C2D_OK ? c2d_set_nodes(s, b, 1, 6, xy, 2) : status;
}

// The lower block is held below, the upper one is pressed on it (case 1) and pushed (case 2).
inline c2d_status build(c2d_solver* s, int variant) {
  c2d_problem problem = C2D_INIT(c2d_problem);
  problem.analysis = C2D_ANALYSIS_FULL;
  c2d_options options = C2D_INIT(c2d_options);
  options.keep_factors = (variant & kKeepFactors) != 0;
  options.stepping = (variant & kDeckStepping) != 0 ? C2D_STEPPING_DECK : C2D_STEPPING_EVENTS;
  c2d_status status = c2d_set_options(s, &options);
  if (status == C2D_OK) status = c2d_set_problem(s, &problem);
  if (status == C2D_OK) status = add_block(s, 1, -1.0);
  if (status == C2D_OK) status = add_block(s, 2, 0.0);
  for (int32_t end = 0; end < 4 && status == C2D_OK; ++end) {
    const int32_t held[] = {1, 1, 0, 0}, loaded[] = {0, 0, 1, 1}, element = end / 2, local = end % 2 + 1;
    const double zero[4] = {}, pressed[] = {0, -2, 0, 0}, pushed[] = {0.5, 0, 0, 0};
    status = c2d_set_condition(s, 1, 1 + element, local, 1, held, zero);
    if (status == C2D_OK) status = c2d_set_condition(s, 2, 4 + element, local, 1, loaded, pressed);
    if (status == C2D_OK) status = c2d_set_condition(s, 2, 4 + element, local, 2, loaded, pushed);
  }
  c2d_zone zone = C2D_INIT(c2d_zone);
  zone.kind = ((variant & kFree) != 0 ? C2D_ZONE_FREE : C2D_ZONE_MATCHING) + ((variant & kTied) != 0 ? C2D_ZONE_TIED : 0);
  zone.pairs = 3;
  zone.side1 = {1, 4, 5, 0, 4, 6};
  zone.side2 = {2, 2, 1, 0, 3, 1};
  if (status == C2D_OK) status = c2d_add_zone(s, &zone);
  if (status == C2D_OK) status = c2d_add_friction(s, 0.3);
  const double pressed[] = {1, 0}, pushed[] = {1, 1};
  if (status == C2D_OK) status = c2d_add_path(s, 1, pressed, 2);
  if (status == C2D_OK) status = c2d_add_path(s, 2, pushed, 2);
  return status == C2D_OK ? c2d_complete(s) : status;
}

// A workspace of exactly the bytes asked for, so that nothing beyond it is touched unseen.
struct Machine {
  Limits limits;
  std::vector<unsigned char> memory;
  c2d_solver* solver = nullptr;
  c2d_status created;
  Machine(int variant, const c2d_port* port, unsigned char fill = 0xA5)
      : limits(variant), memory(static_cast<size_t>(memory_for(limits.limits)), fill),
        created(c2d_create(&solver, memory.data(), memory.size(), &limits.limits, port, nullptr)) {}
  Machine(const Machine&) = delete;
  Machine& operator=(const Machine&) = delete;
};

// Bytes from a stranger, taken one after another; zeros where there are no more.
struct Source {
  const uint8_t* data;
  size_t size, next = 0;
  bool is_empty() const { return next >= size; }
  uint8_t byte() { return next < size ? data[next++] : uint8_t{0}; }
  uint32_t word() {
    uint32_t out = 0;
    for (int i = 0; i < 4; ++i) out |= static_cast<uint32_t>(byte()) << (8 * i);
    return out;
  }
};

} // namespace small_model

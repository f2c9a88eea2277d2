// Attaching to a solver whose memory was moved, or stored and reloaded.
#include <stddef.h>
#include <string.h>

#include "contact2d_image.h"
#include "interface/entry.hpp"
#include "linalg/kernel.hpp"
#include "memory/characters.hpp"
#include "memory/parts.hpp"
#include "solver/port.hpp"
#include "solver/solver.hpp"
#include "store/block.hpp"

namespace c2d {

// The solver may use parts of the library that no call of this program links.
C2D_MEETS(FreeZonePart, c2d_link_free_zones);
C2D_MEETS(HolePart, c2d_link_holes);
C2D_MEETS(RingPart, c2d_link_axisymmetric);
C2D_MEETS(BodyForcePart, c2d_set_body_force);
C2D_MEETS(RigidPart, c2d_set_rigid);
C2D_MEETS(SymmetryPart, c2d_set_symmetry);
C2D_MEETS(EnergyPart, c2d_get_summary);
C2D_MEETS(CompressedPart, c2d_link_compressed);
C2D_MEETS_IN_FULL(CyclePart, c2d_repeat_paths);

namespace {

template <class T> T member_at(const char* solver, size_t offset) {
  T value;
  memcpy(static_cast<void*>(&value), solver + offset, sizeof value);
  return value;
}
#define C2D_MEMBER(name) member_at<decltype(c2d_solver::name)>(at, offsetof(c2d_solver, name))

// The list of body limits is the first array after the struct.
constexpr uint64_t list_place() { return sizeof(c2d_solver); }

// Bytes from `at` to the end of that list according to the struct at `at`; 0: impossible for a valid struct.
uint64_t list_end(const char* at) {
  const int32_t bodies = C2D_MEMBER(sizes).bodies;
  return bodies < 1 ? 0 : list_place() + static_cast<uint64_t>(bodies) * sizeof(c2d_body_limits);
}

// All sizes except the pointer to the list of bodies, which is not stored.
bool same_sizes(const Sizes& a, const Sizes& b) {
  constexpr size_t kRest = offsetof(Sizes, zones);
  static_assert(offsetof(Sizes, body) == 4 * 4 && sizeof(Sizes) - kRest == 14 * 8, "no padding");
  const char *first = reinterpret_cast<const char*>(&a), *other = reinterpret_cast<const char*>(&b);
  return same_bytes(first, other, offsetof(Sizes, body)) && same_bytes(first + kRest, other + kRest, sizeof(Sizes) - kRest);
}

// Is the struct at `at`, of any alignment, consistent with these body limits, as only a complete solver can be?
bool says_the_same(const char* at, c2d_body_limits* body) {
  const int32_t state = C2D_MEMBER(state);
  if (state < C2D_STATE_EMPTY || state > C2D_STATE_BROKEN) return false;
  Sizes found = C2D_MEMBER(sizes);
  if (found.body != nullptr) return false;
  found.body = body;
  const c2d_limits limits = limits_of(found);
  const Layout layout = C2D_MEMBER(layout);
  Sizes sizes;
  if (derive_sizes(limits, sizes) != C2D_OK || !same_sizes(found, sizes)) return false;
  uint64_t minimum = 0;
  if (c2d_memory_need(&limits, &minimum, nullptr, nullptr) != C2D_OK || C2D_MEMBER(bytes) < minimum - (kAlignment - 1))
    return false;
  Layout expected;
  static_assert(sizeof(Layout) == 8 * (kArrays + 1), "no padding");
  lay_out(sizes, sizeof(c2d_solver), expected); // sizes with a computable need have a layout
  return same_bytes(&layout, &expected, sizeof layout);
}

// The list lies within the memory. To read it at an aligned address it is moved down by a few bytes if necessary, and moved
// back afterwards.
template <class Check> bool look_at(char* at, Check check) {
  char* const list = at + list_place();
  const size_t bytes = static_cast<size_t>(list_end(at) - list_place());
  const size_t shift = reinterpret_cast<uintptr_t>(list) % alignof(c2d_body_limits);
  char covered[alignof(c2d_body_limits)];
  memcpy(covered, list - shift, shift);
  memmove(list - shift, list, bytes);
  const bool consistent = check(at, reinterpret_cast<c2d_body_limits*>(list - shift));
  memmove(list, list - shift, bytes);
  memcpy(list - shift, covered, shift);
  return consistent;
}

// Does platen b (`found`) share the mesh of an earlier body from one of its regions on, with other arrays of its own?
bool borrows(const char* at, int32_t b, const Body& found, int64_t place[kBodyArrays]) {
  const char* const bodies = at + C2D_MEMBER(layout).offset[kBodies];
  for (int32_t i = 0; i < b; ++i) {
    const Body from = member_at<Body>(bodies, static_cast<size_t>(i) * sizeof(Body));
    if (from.array[kXy] != found.array[kXy] || from.elements == 0) continue;
    const int64_t shift = found.array[kRegions] - from.array[kRegions], size = static_cast<int64_t>(sizeof(Region));
    if (shift < 0 || shift % size != 0 || shift / size >= from.regions) return false;
    for (const int32_t array : kMeshArrays) place[array] = from.array[array];
    place[kRegions] += shift;
    return same_bytes(found.array, place, kBodyArrays * sizeof place[0]);
  }
  return false;
}

// Are the arrays of the bodies at the offsets that these limits imply? The memory must contain the list of bodies.
bool has_its_arrays(const char* at, c2d_body_limits* body) {
  Sizes sizes = C2D_MEMBER(sizes);
  const Layout layout = C2D_MEMBER(layout);
  sizes.body = body;
  uint64_t end = layout.offset[kArraysOfBodies];
  for (int b = 0; b < sizes.bodies; ++b) {
    int64_t place[kBodyArrays];
    end = lay_out_body(sizes, b, end, place);
    for (int64_t& array : place) array -= static_cast<int64_t>(layout.offset[kBodies]);
    const Body found = member_at<Body>(at + layout.offset[kBodies], static_cast<size_t>(b) * sizeof(Body));
    if (b >= sizes.bodies - sizes.platens && found.is_set != 0) {
      if (!borrows(at, b, found, place)) return false;
    } else if (!same_bytes(found.array, place, sizeof place)) {
      return false;
    }
  }
  return true;
}

const char kOtherMaker[] = "the solver in this memory is of another version of the library, size of pointers or number type";
const char kNoEnergies[] = "the solver in this memory was prepared by a program linked without energies: "
                           "call c2d_get_summary, c2d_run, c2d_attach or c2d_restore in that program to link them";
const char kNoPart[] = "the solver in this memory needs a part of the library that this program does not link "
                       "(C2D_PARTS_BY_CALL); it is linked by ";

// The call that links a part that the consistent solver at `at` uses and this program lacks; null: none.
const char* missing_part(const char* at) {
  const ModelHeader head = C2D_MEMBER(model);
  const Layout layout = C2D_MEMBER(layout);
  const bool images = C2D_MEMBER(options).symmetry == C2D_SYMMETRY_IMAGES;
  if (!kSymmetryPart.linked && (head.symmetry_asked != 0 || images)) return "c2d_set_symmetry";
  if (kRings && !kRingPart.linked && head.plane == C2D_AXISYMMETRIC) return "c2d_link_axisymmetric";
  if (!kSmallCode && !kCompressedPart.linked && C2D_MEMBER(options).elimination != 0) return "c2d_link_compressed";
  const char* const bodies = at + layout.offset[kBodies];
  for (int32_t b = 0; b < C2D_MEMBER(sizes).bodies; ++b) {
    const Body body = member_at<Body>(bodies, static_cast<size_t>(b) * sizeof(Body));
    if (!kHolePart.linked && body.regions > 1) return "c2d_link_holes";
    if (!kRigidPart.linked && body.rigid != 0) return "c2d_set_rigid";
    if (!kBodyForcePart.linked && body.has_force != 0) return "c2d_set_body_force";
  }
  const char* const zones = at + layout.offset[kZones];
  for (int32_t i = 0; !kFreeZonePart.linked && i < head.zones; ++i)
    if (member_at<Zone>(zones, static_cast<size_t>(i) * sizeof(Zone)).is_free != 0) return "c2d_link_free_zones";
  const char* const paths = at + layout.offset[kPaths];
  for (int32_t p = 0; !kSmallCode && !kCyclePart.linked && p < head.paths; ++p)
    if (member_at<Path>(paths, static_cast<size_t>(p) * sizeof(Path)).cycle != 0) return "c2d_repeat_paths";
  const int32_t state = C2D_MEMBER(state);
  const bool prepared = state == C2D_STATE_PREPARED || state == C2D_STATE_RUNNING;
  return !kEnergyPart.linked && prepared && C2D_MEMBER(keeps_energy) != 0 ? "c2d_get_summary" : nullptr;
}

// Reason for refusing a solver: a text and its ending.
struct Reason {
  const char *text, *end;
};

// Offset of the solver in memory[0 .. bytes): *slack. MEMORY with *needed if the memory ends too early; MISMATCH with
// the reason.
c2d_status find_solver(char* memory, size_t bytes, uint32_t* slack, uint64_t* needed, Reason& why) {
  c2d_status status = C2D_ERR_ARGUMENT;
  for (uint32_t i = 0; i < kAlignment && bytes >= sizeof(c2d_solver) && i <= bytes - sizeof(c2d_solver); ++i) {
    char* const at = memory + i;
    if (!same_bytes(at, &kSolverMagic, sizeof kSolverMagic) || C2D_MEMBER(slack) != i) continue;
    if (C2D_MEMBER(maker) != solver_maker()) {
      status = C2D_ERR_MISMATCH;
      why.text = kOtherMaker;
      continue;
    }
    const uint64_t room = bytes - i, end = list_end(at), claimed = C2D_MEMBER(bytes);
    if (end == 0 || claimed < end || claimed > SIZE_MAX - kAlignment) continue;
    if (end <= room && !look_at(at, says_the_same)) continue;
    *slack = i;
    *needed = claimed + kAlignment - 1;
    if (end > room) { // too little memory to examine the rest
      why = Reason{nullptr, nullptr};
      return C2D_ERR_MEMORY;
    }
    const int32_t state = C2D_MEMBER(state);
    if (kEnergyPart.linked && (state == C2D_STATE_PREPARED || state == C2D_STATE_RUNNING) && C2D_MEMBER(keeps_energy) == 0) {
      status = C2D_ERR_MISMATCH;
      why.text = kNoEnergies;
      continue;
    }
    why = Reason{nullptr, nullptr};
    if (bytes < *needed) return C2D_ERR_MEMORY;
    if (!look_at(at, has_its_arrays)) return C2D_ERR_ARGUMENT;
    why.end = missing_part(at);
    if (why.end) {
      why.text = kNoPart;
      return C2D_ERR_MISMATCH;
    }
    return C2D_MEMBER(busy) != 0 ? C2D_ERR_BUSY : C2D_OK;
  }
  return status;
}
#undef C2D_MEMBER

const char kOtherSum[] = "the memory does not match its checksum";

// Checksum of the image of a solver at `at`, except the cancel flag, which may change at any moment.
uint64_t sum_of(const char* at, uint64_t bytes) {
  constexpr size_t kCancel = offsetof(c2d_solver, cancelled), kBehind = kCancel + sizeof(c2d_solver::cancelled);
  return checksum(checksum(0, at, kCancel), at + kBehind, bytes - kBehind);
}

// Moves the solver to the aligned address in this memory; returns its offset.
uint32_t move_into_place(char* memory, uint32_t found, uint64_t bytes) {
  const uint32_t slack = static_cast<uint32_t>((kAlignment - reinterpret_cast<uintptr_t>(memory) % kAlignment) % kAlignment);
  if (slack == found) return slack;
  memmove(memory + slack, memory + found, static_cast<size_t>(bytes));
  if (slack > found) memset(memory + found, 0, slack - found); // erase the old beginning, so that it is not found again
  return slack;
}

// `sum`: required checksum; null: not checked.
c2d_status attach(c2d_solver** out, void* memory, size_t bytes, const c2d_port* port, const uint64_t* sum, c2d_error* why) {
  if (!out) return C2D_ERR_ARGUMENT;
  *out = nullptr;
  c2d_port our_port;
  char what[128] = "memory is null";
  Text fault = text_in(what);
  uint32_t found = 0;
  uint64_t needed = 0;
  Reason reason{nullptr, nullptr};
  char* const base = static_cast<char*>(memory);
  c2d_status status = (why && !is_begun(why)) || !memory || !take_port(port, our_port, fault) ? C2D_ERR_ARGUMENT : C2D_OK;
  if (status != C2D_OK) reason.text = what;
  if (status == C2D_OK) status = find_solver(base, bytes, &found, &needed, reason);
  const uint64_t image = needed - (kAlignment - 1);
  if (status == C2D_OK && sum && sum_of(base + found, image) != *sum) {
    status = C2D_ERR_STORE_CHECKSUM;
    reason.text = kOtherSum;
  }
  if (status != C2D_OK) {
    explain(why, status, status == C2D_ERR_MEMORY ? needed : 0, reason.text, reason.end);
    return status;
  }
  const uint32_t slack = move_into_place(base, found, image);
  c2d_solver* s = reinterpret_cast<c2d_solver*>(base + slack);
  s->slack = slack;
  s->port = our_port;
  s->instructions = best_instructions();
  connect_port(s);
  if (s->state == C2D_STATE_BROKEN) memset(s->tapes.is_open, 0, sizeof s->tapes.is_open); // c2d_restore opens the tapes again
  status = reopen_tapes(s->tapes);
  if (status != C2D_OK) {
    if (why) copy_out(&s->tapes.error, sizeof s->tapes.error, why);
    return status;
  }
  *out = s;
  return C2D_OK;
}

} // namespace
} // namespace c2d

using namespace c2d;

extern "C" c2d_status c2d_attach(c2d_solver** out, void* memory, size_t bytes, const c2d_port* port, c2d_error* why) {
  return attach(out, memory, bytes, port, nullptr, why);
}

extern "C" c2d_status c2d_attach_image(c2d_solver** out, void* memory, size_t bytes, const c2d_port* port, uint64_t sum,
                                       c2d_error* why) {
  return attach(out, memory, bytes, port, &sum, why);
}

extern "C" c2d_status c2d_image_sum(const c2d_solver* s, uint64_t* sum) {
  if (!s || s->magic != kSolverMagic || !sum) return C2D_ERR_ARGUMENT;
  if (s->busy) return C2D_ERR_BUSY;
  *sum = sum_of(reinterpret_cast<const char*>(s), s->bytes);
  return C2D_OK;
}

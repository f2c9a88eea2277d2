// The state of the path kept on tape CONTROL, so that a crash in the middle of keeping leaves the state kept before
// (store/FORMAT.md: saved states).
#include <stddef.h>
#include <string.h>

#include "contact/basis.hpp"
#include "contact/frictionless.hpp"
#include "contact/let_go.hpp"
#include "contact/reduction/open_form.hpp"
#include "memory/characters.hpp"
#include "memory/parts.hpp"
#include "solver/energy/energy.hpp"
#include "solver/model_hash.hpp"
#include "solver/prepare.hpp"
#include "solver/save.hpp"
#include "solver/session.hpp"

namespace c2d {

// The model that a state belongs to is there already, with its parts; its energies may be those of another program.
C2D_USES(CompressedPart);
C2D_USES(EnergyPart);

namespace {

// What stands in the block of a slot, as the machine has it.
struct SaveRecord {
  uint64_t number; // of the save within its run, from 1
  uint64_t count;  // of tape CONTROL: other tapes since then are not those of this state
  uint64_t run_id;
  uint64_t model_hash;
  uint64_t image_bytes; // kept from c2d_solver::model on
  uint64_t image_sum;   // checksum over all pieces
  uint64_t path_bytes;  // the phase area must have them
  uint32_t maker;
  int32_t state;
  uint32_t generation[C2D_TAPES];
  uint32_t is_open[C2D_TAPES];
  uint64_t blocks[C2D_TAPES], block_bytes[C2D_TAPES];
  uint64_t writes[C2D_TAPES], reads[C2D_TAPES], bytes_written[C2D_TAPES], bytes_read[C2D_TAPES];
};
static_assert(sizeof(SaveRecord) <= kPieceBytes, "a record is one block");

struct Piece {
  alignas(8) unsigned char bytes[kBlockHeaderBytes + kPieceBytes];
  unsigned char* data() { return bytes + kBlockHeaderBytes; }
};

// Two slots behind the run's count: their records are blocks 1 and 2, their pieces follow.
struct Slots {
  uint64_t pieces; // of a slot, enough for every state of this model
  uint64_t blocks; // of the tape
  uint64_t record(uint64_t number) const { return 1 + number % 2; }
  uint64_t piece(uint64_t number, uint64_t i) const { return 3 + number % 2 * pieces + i; }
};

constexpr uint64_t kImageStart = offsetof(c2d_solver, model);

// From the model in the header to the last of what the path keeps: tableau, values and rates, contact displacements.
uint64_t image_bytes(c2d_solver* s, bool running) {
  if (!running) return s->layout.persistent - kImageStart;
  const Model m = model_of(s);
  PathArea area;
  open_path_area(s, m, false, area);
  const char* end = reinterpret_cast<const char*>(area.motion + model_sizes(m).widest);
  return static_cast<uint64_t>(end - reinterpret_cast<const char*>(s)) - kImageStart;
}

Slots slots_of(c2d_solver* s) {
  const uint64_t bytes = image_bytes(s, true);
  return Slots{save_pieces(bytes), save_blocks(bytes)};
}

unsigned char* image_of(c2d_solver* s) { return reinterpret_cast<unsigned char*>(s) + kImageStart; }

// The model, and for a state of the path that path and how it is followed: a factorisation alone serves any other.
uint64_t hash_state(c2d_solver* s, bool running) {
  const Model m = model_of(s);
  uint64_t hash = hash_model(m, s->options);
  if (!kEnergyPart.linked) hash = ~hash; // of no use to a program with energies, and the other way round
  hash = checksum(hash, &s->layout, sizeof s->layout);
  if (!running) return hash;
  hash = checksum(hash, &s->options.stepping, sizeof s->options.stepping);
  hash = checksum(hash, &m.head->iteration_limit, sizeof m.head->iteration_limit);
  hash = checksum(hash, m.friction, static_cast<uint64_t>(s->sizes.coefficients * (1 + s->sizes.zones)) * sizeof(double));
  hash = checksum(hash, array_of<PointSet>(s, kPointSets), static_cast<uint64_t>(m.head->point_sets) * sizeof(PointSet));
  hash = checksum(hash, m.path, static_cast<uint64_t>(m.head->paths) * sizeof(Path));
  return checksum(hash, m.path_load,
                  static_cast<uint64_t>(m.head->paths) * static_cast<uint64_t>(m.head->load_cases) * sizeof(double));
}

// Saving and restoring is not counted among the transfers of the solution.
struct Uncounted {
  Tapes& tapes;
  uint64_t writes, reads, bytes_written, bytes_read;
  explicit Uncounted(Tapes& t)
      : tapes(t), writes(t.writes[0]), reads(t.reads[0]), bytes_written(t.bytes_written[0]), bytes_read(t.bytes_read[0]) {}
  void done() const {
    tapes.writes[0] = writes, tapes.reads[0] = reads;
    tapes.bytes_written[0] = bytes_written, tapes.bytes_read[0] = bytes_read;
  }
};

// Tape CONTROL with room for two slots.
c2d_status open_slots(c2d_solver* s, const Slots& slots) {
  Tapes& tapes = s->tapes;
  const bool is_open = tapes.is_open[C2D_TAPE_CONTROL] != 0;
  if (is_open && tapes.blocks[C2D_TAPE_CONTROL] == slots.blocks) return C2D_OK;
  const c2d_status status = is_open ? close_tape(tapes, C2D_TAPE_CONTROL) : c2d_status{C2D_OK};
  // Whatever a store that has died says to being closed, it may come back.
  if (status != C2D_OK && s->state != C2D_STATE_BROKEN) return status;
  return open_tape(tapes, C2D_TAPE_CONTROL, slots.blocks, kPieceBytes);
}

uint64_t length_of(uint64_t image, uint64_t i) {
  const uint64_t left = image - i * kPieceBytes;
  return left < kPieceBytes ? left : kPieceBytes;
}

// ---- save ---------------------------------------------------------------------------------------------------------

void describe(c2d_solver* s, SaveRecord& out) {
  const Tapes& tapes = s->tapes;
  memset(&out, 0, sizeof out);
  out.number = s->saves + 1;
  out.count = tapes.count;
  out.run_id = tapes.run_id;
  const bool running = s->state == C2D_STATE_RUNNING;
  out.model_hash = hash_state(s, running);
  out.image_bytes = image_bytes(s, running);
  PathArea area;
  out.path_bytes = open_path_area(s, model_of(s), s->keeps_flexibility != 0, area);
  out.maker = solver_maker();
  out.state = s->state;
  for (int32_t tape = 0; tape < C2D_TAPES; ++tape) {
    out.generation[tape] = tapes.generation[tape];
    out.is_open[tape] = tapes.is_open[tape];
    out.blocks[tape] = tapes.blocks[tape];
    out.block_bytes[tape] = tapes.block_bytes[tape];
    out.writes[tape] = tapes.writes[tape];
    out.reads[tape] = tapes.reads[tape];
    out.bytes_written[tape] = tapes.bytes_written[tape];
    out.bytes_read[tape] = tapes.bytes_read[tape];
  }
}

c2d_status write_image(c2d_solver* s, const Slots& slots, SaveRecord& record, Piece& piece) {
  const uint64_t pieces = (record.image_bytes + kPieceBytes - 1) / kPieceBytes;
  s->tapes.generation[C2D_TAPE_CONTROL] = static_cast<uint32_t>(record.number);
  record.image_sum = 0;
  for (uint64_t i = 0; i < pieces; ++i) {
    const uint64_t bytes = length_of(record.image_bytes, i);
    memcpy(piece.data(), image_of(s) + i * kPieceBytes, static_cast<size_t>(bytes));
    record.image_sum = checksum(record.image_sum, piece.data(), bytes);
    const c2d_status status = write_block(s->tapes, C2D_TAPE_CONTROL, slots.piece(record.number, i), piece.bytes, bytes);
    if (status != C2D_OK) return status;
    tell_progress(s, C2D_PHASE_WRITE, 0, static_cast<int64_t>(i + 1), static_cast<int64_t>(pieces));
  }
  return sync_tape(s->tapes, C2D_TAPE_CONTROL);
}

c2d_status save(c2d_solver* s) {
  Tapes& tapes = s->tapes;
  const Slots slots = slots_of(s);
  Piece piece;
  SaveRecord record;
  const Uncounted uncounted(tapes);
  c2d_status status = open_slots(s, slots);
  if (status == C2D_OK)
    status =
        tapes.run_id == 0 ? begin_run(tapes, hash_model(model_of(s), s->options), piece.bytes) : keep_count(tapes, piece.bytes);
  // A state is worth as much as the tapes it goes with.
  for (int32_t tape = C2D_TAPE_LOWER; tape < C2D_TAPES && status == C2D_OK; ++tape)
    if (tapes.is_open[tape]) status = sync_tape(tapes, tape);
  if (status != C2D_OK) return status;
  uncounted.done();
  describe(s, record);
  status = write_image(s, slots, record, piece);
  memcpy(piece.data(), &record, sizeof record);
  if (status == C2D_OK) status = write_record(tapes, slots.record(record.number), piece.bytes, sizeof record);
  if (status == C2D_OK) status = sync_tape(tapes, C2D_TAPE_CONTROL);
  if (status == C2D_OK) s->saves = record.number;
  uncounted.done();
  return status;
}

// ---- restore ------------------------------------------------------------------------------------------------------

// A piece of an image on its way to bytes first ... end - 1 of the solver's memory.
struct Arrival {
  unsigned char* solver;
  const unsigned char* piece;
  uint64_t first, end;
  void take(uint64_t from, uint64_t to) const {
    if (from < first) from = first;
    if (to > end) to = end;
    if (from < to) memcpy(solver + from, piece + (from - first), static_cast<size_t>(to - from));
  }
};

// Takes up what preparation and path made, and texts: numbers, and what is_possible looks at. The model is there already, and
// stays.
void take_up(c2d_solver* s, const Arrival& arrived) {
  const uint64_t* const at = s->layout.offset;
  const auto upto = [&](uint64_t from, uint64_t to) { arrived.take(from, to); };
  upto(offsetof(c2d_solver, model) + offsetof(ModelHeader, title), offsetof(c2d_solver, options));
  upto(offsetof(c2d_solver, options), sizeof *s);
  if (!s->blocked) upto(at[kPlans], at[kBodyResults]);
  upto(at[kBodyResults], at[kArraysOfBodies]);
  for (int32_t b = 0; b < s->model.bodies; ++b) {
    const uint64_t work = at[kBodies] + static_cast<uint64_t>(array_of<Body>(s, kBodies)[b].array[kLoadWork]);
    upto(work, work + 4 * sizeof(double) * static_cast<uint64_t>(s->model.load_cases));
    const uint64_t name = at[kBodies] + static_cast<uint64_t>(b) * sizeof(Body) + offsetof(Body, name);
    upto(name, name + sizeof Body::name);
  }
  for (int32_t i = 0; i < s->model.zones; ++i) {
    const uint64_t name = at[kZones] + static_cast<uint64_t>(i) * sizeof(Zone) + offsetof(Zone, name);
    upto(name, name + sizeof Zone::name);
  }
  const bool pairs = arrived.first < at[kPointLoads] && arrived.end > at[kPairs];
  for (int32_t i = 0; i < s->model.pairs && pairs; ++i) {
    const uint64_t pair = at[kPairs] + static_cast<uint64_t>(i) * sizeof(Pair);
    if (!kSmallCode && s->model.columns > 0) upto(pair + offsetof(Pair, made), pair + offsetof(Pair, made) + sizeof Pair::made);
    upto(pair + offsetof(Pair, status), pair + sizeof(Pair));
  }
  upto(at[kPairTable], at[kPathLoads]);
  upto(at[kEnergy], at[kPointSets]);
  upto(at[kJudge], at[kCurves]);
  upto(at[kCycles], at[kPhase]);
  upto(at[kPhase], s->bytes);
}

struct Span {
  int64_t value, first, last;
};
template <int count> bool all_within(const Span (&spans)[count]) {
  for (const Span& span : spans)
    if (span.value < span.first || span.value > span.last) return false;
  return true;
}

bool is_status(int8_t status, int8_t sign) { return all_within({{status, C2D_OPEN, C2D_SLIP}, {sign, -1, 1}}); }

bool may_be_guided(const Model& m, int32_t guided) { return guided == 0 || m.pair[guided - 1].tangential != 0; }

bool are_possible_pairs(const Model& m) {
  for (int32_t i = 0; i < m.head->pairs; ++i) {
    const Pair& pair = m.pair[i];
    if (!is_status(pair.status, pair.sign) || !is_status(pair.saved_status, pair.saved_sign) ||
        !is_status(pair.good_status, pair.good_sign))
      return false;
    if (is_on_demand(m) && !all_within({{pair.made, -1, m.head->columns - 1 - pair.tangential}})) return false;
  }
  return true;
}

// Of the tableau, which stands where any model has room for it: each pair's are among those in use, or there is room for them.
bool are_possible_columns(c2d_solver* s, const Model& m) {
  Session session;
  open_session(s, session);
  const Tableau& t = session.tableau;
  const bool none_used = !kSmallCode && (s->floating != 0 || is_let_go(t)); // none sleeps, and no pair's column is looked at
  int64_t columns = s->awake;
  for (int32_t i = 0; i < t.pairs && delays(t); ++i) {
    const int32_t own = 1 + last_slot(t, m.pair[i]);
    if (!all_within({{t.column[i], -1, s->awake - own}})) return false;
    if (t.column[i] < 0 && m.pair[i].status != C2D_OPEN) return false;
    if (t.column[i] < 0) columns += own;
    if (t.column[i] >= 0 && is_on_demand(m) && m.pair[i].made < 0 && !none_used) return false;
  }
  return columns <= all_columns_of(t);
}

template <int32_t size> bool ends(const char (&text)[size]) { return place_of('\0', text, size) < size; }

bool are_possible_texts(const Model& m) {
  bool all = ends(m.head->title) && ends(m.head->unit_length) && ends(m.head->unit_force);
  for (int b = 0; b < m.head->bodies && all; ++b) all = ends(m.body[b].name) && !fault_of_name(m.body[b].name);
  for (int32_t i = 0; i < m.head->zones && all; ++i) all = ends(m.zone[i].name) && !fault_of_name(m.zone[i].name);
  return all;
}

// Sums can be made to be right. Could what was taken up have been left by a path? Every number that leads to a place in memory
// or chooses a way is looked at; the others may be any. `blocked` is what the model says.
bool is_possible(c2d_solver* s, const Model& m, int32_t blocked, bool running) {
  constexpr int64_t kMany = int64_t{1} << 60, kSome = 1 << 30; // counts, with room to go on
  const ModelHeader& head = s->model;
  const PathStats& stats = s->stats;
  const bool within = all_within({{s->blocked, blocked, blocked},
                                  {s->keeps_flexibility, 0, 1},
                                  {s->keeps_energy, 0, 1},
                                  {s->sliding, 0, has_sliding_form(m) ? 1 : 0},
                                  {s->open, 0, has_open_form(m) ? 1 : 0},
                                  {s->options.keep_factors, 0, 1},
                                  {s->factors, 0, s->options.keep_factors},
                                  {s->loads_changed, 0, 0},
                                  {s->mean_motions, 0, 1},
                                  {s->warnings, 0, kSome},
                                  {s->floating, 0, 1},
                                  {s->good_floating, 0, 1},
                                  {s->outcome, C2D_REACHED, C2D_BEYOND_LIMITS},
                                  {s->outcome_body, 0, head.bodies},
                                  {s->last_pair, -1, head.pairs > 0 ? head.pairs - 1 : 0},
                                  {s->may_rest, 0, 1},
                                  {s->resting, 0, kSome},
                                  {s->delayed, 0, delayed_exchanges(head.contact)},
                                  {s->awake, 0, is_on_demand(m) ? head.columns : head.path_unknowns},
                                  {s->made, 0, kSmallCode ? 0 : head.columns},
                                  {s->guided, 0, head.path_pairs},
                                  {s->good_guided, 0, head.path_pairs},
                                  {s->table_is_current, 0, 1},
                                  {s->idle, 0, 1},
                                  {s->goes_on, 0, 1},
                                  {s->coefficient, 0, kSome},
                                  {s->run_step, -kSome, kSome},
                                  {s->run_outcome, C2D_REACHED, C2D_BEYOND_LIMITS},
                                  {s->unsound, 0, 1},
                                  {s->careful, 0, 0},
                                  {s->breach, C2D_BREACH_NONE, C2D_BREACHES - 1},
                                  {s->turns, 0, kMany},
                                  {s->exchanges, 0, kMany},
                                  {s->judged_exchanges, 0, kMany},
                                  {s->built_exchanges, 0, kMany},
                                  {s->rebuilds, 0, kMany},
                                  {stats.events, 0, kMany},
                                  {stats.changes, 0, kMany},
                                  {stats.iterations, 0, kSome},
                                  {stats.unconverged, 0, kSome}});
  if (!within || (s->run_step > 0 && s->coefficient == 0) || !are_possible_texts(m) ||
      (s->keeps_energy != 0) != kEnergyPart.linked || !are_possible_pairs(m) || !may_be_guided(m, s->guided) ||
      !may_be_guided(m, s->good_guided))
    return false;
  const PhaseSizes sizes = model_sizes(m);
  for (int b = 0; b < head.bodies && !blocked; ++b)
    if (!is_plan_of(sizes, b, plan_of(s, b)) || plan_of(s, b).keep_lower > s->options.keep_factors) return false;
  if (running && !s->blocked && !are_possible_columns(s, m)) return false;
  PathArea area;
  return open_path_area(s, m, s->keeps_flexibility != 0, area) <= s->bytes - s->layout.persistent;
}

// Are these the tapes that the state was made with?
bool are_its_tapes(c2d_solver* s, const Model& m, const SaveRecord& record) {
  TapeShapes shape = {};
  if (!s->blocked) shape = shape_tapes(s, m);
  for (int32_t tape = C2D_TAPE_LOWER; tape < C2D_TAPES; ++tape) {
    const bool is_open = record.is_open[tape] != 0;
    if (is_open != (shape.blocks[tape] > 0)) return false;
    if (is_open &&
        (record.blocks[tape] != shape.blocks[tape] || record.block_bytes[tape] != shape.data[tape] + kBlockHeaderBytes))
      return false;
  }
  return true;
}

// Is the state of this record whole, piece by piece? With `load` it is put in its place.
c2d_status read_image(c2d_solver* s, const Slots& slots, const SaveRecord& record, Piece& piece, bool load) {
  Tapes& tapes = s->tapes;
  const uint64_t run_id = tapes.run_id;
  const uint32_t generation = tapes.generation[C2D_TAPE_CONTROL];
  tapes.run_id = record.run_id;
  tapes.generation[C2D_TAPE_CONTROL] = static_cast<uint32_t>(record.number);
  c2d_status status = C2D_OK;
  uint64_t sum = 0;
  for (uint64_t i = 0; i * kPieceBytes < record.image_bytes; ++i) {
    const uint64_t bytes = length_of(record.image_bytes, i);
    status = read_block(tapes, C2D_TAPE_CONTROL, slots.piece(record.number, i), piece.bytes, bytes);
    if (status != C2D_OK) break;
    sum = checksum(sum, piece.data(), bytes);
    tell_progress(s, C2D_PHASE_READ, 0, static_cast<int64_t>(i + 1), 0);
    const uint64_t first = kImageStart + i * kPieceBytes;
    if (load) take_up(s, Arrival{reinterpret_cast<unsigned char*>(s), piece.data(), first, first + bytes});
  }
  tapes.run_id = run_id;
  tapes.generation[C2D_TAPE_CONTROL] = generation;
  return status == C2D_OK && sum != record.image_sum ? c2d_status{C2D_ERR_STORE_STALE} : status;
}

// May this state become that of the solver?
c2d_status compare(c2d_solver* s, const SaveRecord& record, uint64_t count) {
  const bool running = record.state == C2D_STATE_RUNNING;
  if (record.maker != solver_maker() || record.model_hash != hash_state(s, running)) return C2D_ERR_MISMATCH;
  if (record.count != count) return C2D_ERR_STORE_STALE;
  // Sums can be made to be right: what is read goes into the workspace.
  if ((!running && record.state != C2D_STATE_PREPARED) || record.image_bytes != image_bytes(s, running))
    return C2D_ERR_MISMATCH;
  return record.path_bytes > s->bytes - s->layout.persistent ? C2D_ERR_MEMORY : C2D_OK;
}

// The more a reason says, the higher.
int weight(c2d_status status) {
  switch (status) {
  case C2D_ERR_STORE_READ: return 0; // a file that is not as long
  case C2D_ERR_STORE_FORMAT: return 1;
  case C2D_ERR_STORE_STALE: return 2;
  case C2D_ERR_MISMATCH: return 4;
  case C2D_ERR_MEMORY: return 5;
  default: return 3;
  }
}

// The newest state that is whole and belongs to the tapes and the model. The solver is not touched. *needed: bytes of
// workspace that would do, with C2D_ERR_MEMORY.
c2d_status find_state(c2d_solver* s, const Slots& slots, Piece& piece, SaveRecord& best, uint64_t* needed) {
  Tapes& tapes = s->tapes;
  uint64_t count = 0;
  best.number = 0;
  c2d_status reason = read_count(tapes, &count, piece.bytes);
  if (reason != C2D_OK) return reason == C2D_ERR_STORE_VERSION ? c2d_status{C2D_ERR_MISMATCH} : reason;
  reason = C2D_ERR_STORE_READ;
  for (uint64_t slot = 0; slot < 2; ++slot) {
    c2d_status status = read_record(tapes, slots.record(slot), piece.bytes, sizeof(SaveRecord));
    if (status == C2D_ERR_STORE_VERSION) status = C2D_ERR_MISMATCH;
    SaveRecord found;
    if (status == C2D_OK) {
      memcpy(&found, piece.data(), sizeof found);
      status = compare(s, found, count);
    }
    if (status == C2D_OK && found.number % 2 != slot) status = C2D_ERR_STORE_SWAPPED;
    if (status == C2D_OK && found.number < best.number) continue;
    if (status == C2D_OK) status = read_image(s, slots, found, piece, false);
    if (status == C2D_OK)
      best = found;
    else if (status == C2D_ERR_MEMORY)
      *needed = s->layout.persistent + found.path_bytes + kAlignment - 1;
    if (weight(status) > weight(reason)) reason = status;
  }
  return best.number > 0 ? c2d_status{C2D_OK} : reason;
}

// What was half taken up, or from a stranger, is looked at no more: c2d_restore begins with plans, the summary tells texts.
void forget(c2d_solver* s, const Model& m) {
  ModelHeader& head = s->model;
  memset(&plan_of(s, 0), 0, static_cast<size_t>(head.bodies) * sizeof(EliminationPlan));
  head.title[0] = head.unit_length[0] = head.unit_force[0] = '\0';
  for (int b = 0; b < head.bodies; ++b) m.body[b].name[0] = '\0';
  for (int32_t i = 0; i < head.zones; ++i) m.zone[i].name[0] = '\0';
  s->outcome_body = 0;
}

// The contact system on the tape becomes that of the state, which is read again where that took its place in memory.
c2d_status take_up_form(c2d_solver* s, const Slots& slots, Piece& piece, const SaveRecord& record) {
  const c2d_options options = s->options;
  const int32_t factors = s->factors;
  bool again = false;
  c2d_status status = match_saved(s, &again);
  if (status == C2D_OK && again) status = read_image(s, slots, record, piece, true);
  if (status == C2D_OK && again && is_on_demand(model_of(s))) status = kCompressedPart.remake_columns(s);
  if (status != C2D_OK) return status;
  s->options = options;
  s->factors = factors;
  return C2D_OK;
}

// The tapes that belong to the state are opened, and it takes the place of what the solver holds.
c2d_status load_state(c2d_solver* s, const Slots& slots, Piece& piece, const SaveRecord& record) {
  Tapes& tapes = s->tapes;
  for (int32_t tape = C2D_TAPE_LOWER; tape < C2D_TAPES; ++tape) {
    const c2d_status status = tapes.is_open[tape] ? close_tape(tapes, tape) : c2d_status{C2D_OK};
    if (status != C2D_OK && s->state != C2D_STATE_BROKEN) return status;
  }
  const Model m = model_of(s);
  const c2d_options options = s->options;
  plan_bodies(s, m);
  const int32_t blocked = s->blocked;
  c2d_status status = read_image(s, slots, record, piece, true);
  if (status == C2D_OK && (!is_possible(s, m, blocked, record.state == C2D_STATE_RUNNING) || !are_its_tapes(s, m, record))) {
    tapes.error.status = C2D_OK; // the tape has nothing to say of blocks that are whole
    status = C2D_ERR_STORE_FORMAT;
  }
  const int32_t keep_factors = s->options.keep_factors;
  s->options = options;
  if (status != C2D_OK) {
    forget(s, m);
    return status;
  }
  s->options.keep_factors = keep_factors;
  // New loads go through the factors where the memory is no less than it was.
  if (s->factors && phases_use(model_sizes(m), &plan_of(s, 0), false) > s->bytes - s->layout.persistent) s->factors = 0;
  tapes.run_id = record.run_id;
  tapes.count = record.count;
  s->saves = record.number;
  for (int32_t tape = 0; tape < C2D_TAPES; ++tape) {
    tapes.generation[tape] = record.generation[tape];
    if (tape != C2D_TAPE_CONTROL && record.is_open[tape])
      status = open_tape(tapes, tape, record.blocks[tape], record.block_bytes[tape] - kBlockHeaderBytes);
    if (status != C2D_OK) return status;
  }
  if (!kSmallCode) status = take_up_form(s, slots, piece, record);
  if (status != C2D_OK) return status;
  for (int32_t tape = 0; tape < C2D_TAPES; ++tape) {
    tapes.writes[tape] = record.writes[tape];
    tapes.reads[tape] = record.reads[tape];
    tapes.bytes_written[tape] = record.bytes_written[tape];
    tapes.bytes_read[tape] = record.bytes_read[tape];
  }
  s->back_substituted = 0; // those results were not kept
  s->state = record.state;
  if (s->state != C2D_STATE_RUNNING || s->blocked) return C2D_OK;
  Session session;
  open_session(s, session);
  uint64_t* const reads = &tapes.reads[C2D_TAPE_CONTACT];
  uint64_t* const bytes_read = &tapes.bytes_read[C2D_TAPE_CONTACT];
  const uint64_t counted[2] = {*reads, *bytes_read}; // when the path began
  status = load_flexibility(session);
  *reads = counted[0], *bytes_read = counted[1];
  return status;
}

// Nothing can be taken up, and the solver is as before.
c2d_status refuse_state(c2d_solver* s, c2d_status status, uint64_t needed) {
  const c2d_error& block = s->tapes.error;
  c2d_error e = blank_error();
  e.tape = C2D_TAPE_CONTROL;
  e.host_code = status == C2D_ERR_STORE_READ ? block.host_code : 0;
  e.bytes_needed = status == C2D_ERR_MEMORY ? needed : 0;
  // A block of another machine says more than that there is a mismatch.
  const bool foreign = status == C2D_ERR_MISMATCH && block.status == C2D_ERR_STORE_VERSION;
  return fail_with(s, e, status, foreign ? block.text : status_text(status));
}

} // namespace

c2d_status save_state(c2d_solver* s) {
  const c2d_status status = save(s);
  return status == C2D_OK ? c2d_status{C2D_OK} : fail_store(s, status);
}

c2d_status restore_state(c2d_solver* s) {
  // What the model's numbers are is told by its plans: those of one that has not been prepared here.
  if (!kSmallCode && s->sizes.touching > 0 && s->state != C2D_STATE_PREPARED && s->state != C2D_STATE_RUNNING)
    plan_bodies(s, model_of(s));
  const Slots slots = slots_of(s);
  Piece piece;
  SaveRecord record;
  c2d_status status = open_slots(s, slots);
  if (status != C2D_OK) return fail_store(s, status);
  const Uncounted uncounted(s->tapes);
  s->tapes.error.status = C2D_OK;
  uint64_t needed = 0;
  status = find_state(s, slots, piece, record, &needed);
  uncounted.done();
  if (status != C2D_OK) {
    return refuse_state(s, status, needed);
  }
  status = load_state(s, slots, piece, record);
  return status == C2D_OK ? c2d_status{C2D_OK} : fail_store(s, status);
}

} // namespace c2d

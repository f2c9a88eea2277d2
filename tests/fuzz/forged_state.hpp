#pragma once
// A saved state and its tapes, changed as bytes of a stranger say and, if they say so, sealed again with right checksums; then
// taken up, and everything asked for that a host may ask. Nothing may be read or written outside the workspace.
#include "small_model.hpp"

namespace forged {

using namespace small_model;

// As solver/save.cpp and store/FORMAT.md have them.
constexpr size_t kHeader = c2d::kBlockHeaderBytes, kPiece = 512, kImageBytes = 32, kImageSum = 40;

inline uint64_t number_at(const Bytes& block, size_t offset) {
  uint64_t out;
  std::memcpy(&out, block.data() + kHeader + offset, sizeof out);
  return out;
}

// Blocks without their end marks, as the library has them in memory.
class Opened {
public:
  explicit Opened(Store& store) : store_(store) {}
  // The data of a block that has some, opened once.
  Bytes* data(int32_t tape, size_t block) {
    if (tape < 0 || tape >= C2D_TAPES || block >= store_.tape[tape].size()) return nullptr;
    Bytes& bytes = store_.tape[tape][block];
    for (const Block& known : blocks_)
      if (known.tape == tape && known.block == block) return &bytes;
    c2d::BlockLabel label = {};
    if (bytes.size() < kHeader) return nullptr;
    const uint64_t most = bytes.size() - kHeader;
    c2d::inspect_block(bytes.data(), most, &label);
    if (label.length == 0 || label.length > most ||
        c2d::inspect_block(bytes.data(), label.length, &label).fault != c2d::BlockFault::none)
      return nullptr;
    c2d::unseal_block(bytes.data(), label.length);
    blocks_.push_back({tape, block, label});
    return &bytes;
  }
  uint64_t length(int32_t tape, size_t block) const {
    for (const Block& known : blocks_)
      if (known.tape == tape && known.block == block) return known.label.length;
    return 0;
  }
  void seal() {
    for (const Block& known : blocks_) c2d::seal_block(known.label, store_.tape[known.tape][known.block].data());
    blocks_.clear();
  }

private:
  struct Block {
    int32_t tape;
    size_t block;
    c2d::BlockLabel label;
  };
  Store& store_;
  std::vector<Block> blocks_;
};

// Where the pieces of the state in slot 1 are (the first one saved): its record is block 2.
struct Image {
  Opened& opened;
  size_t first = 0, pieces = 0, bytes = 0;
  Image(Store& store, Opened& o) : opened(o) {
    Bytes* record = opened.data(C2D_TAPE_CONTROL, 2);
    if (!record) return;
    bytes = static_cast<size_t>(number_at(*record, kImageBytes));
    first = 3 + (store.tape[C2D_TAPE_CONTROL].size() - 3) / 2;
    pieces = (bytes + kPiece - 1) / kPiece;
  }
  unsigned char* at(size_t offset) {
    Bytes* block = opened.data(C2D_TAPE_CONTROL, first + offset / kPiece);
    return block ? block->data() + kHeader + offset % kPiece : nullptr;
  }
  // The sum over all pieces, which stands in the record.
  void sum() {
    uint64_t value = 0;
    for (size_t i = 0; i < pieces; ++i) {
      Bytes* block = opened.data(C2D_TAPE_CONTROL, first + i);
      if (!block) return;
      value = c2d::checksum(value, block->data() + kHeader, opened.length(C2D_TAPE_CONTROL, first + i));
    }
    Bytes* record = opened.data(C2D_TAPE_CONTROL, 2);
    if (record) std::memcpy(record->data() + kHeader + kImageSum, &value, sizeof value);
  }
};

// What is written in a place: a byte, or an integer or a number at the end of its range, as aligned as the place allows.
inline void change(unsigned char* at, size_t room, Source& in) {
  static const int64_t integers[] = {-1, 1, 2, 3, 127, INT32_MAX, INT32_MIN, INT64_MAX, 255, 4096, 0, -2, 7, 100000};
  const uint8_t kind = in.byte(), value = in.byte();
  const double inf = 1e308 * 10, numbers[] = {inf, -inf, inf - inf, 0.0, 1e300, -1.0, 1e-300, 1.0};
  if (kind % 4 == 0 && room >= 4) {
    const int32_t number = static_cast<int32_t>(integers[value % 14]);
    std::memcpy(at, &number, 4);
  } else if (kind % 4 == 1 && room >= 8) {
    std::memcpy(at, value % 2 == 0 ? static_cast<const void*>(&integers[value / 2 % 14]) : &numbers[value / 2 % 8], 8);
  } else if (kind % 4 == 2) {
    *at = static_cast<unsigned char>(*at ^ (1u << value % 8));
  } else {
    *at = value;
  }
}

// Changes, up to a few: of the image, of its record, of the data of a block of any tape, or of any byte with the seal broken.
inline void forge(Store& store, Source& in) {
  Opened opened(store);
  Image image(store, opened);
  if (image.pieces == 0) return;
  struct Raw {
    size_t tape, block, offset;
    uint8_t value;
  };
  std::vector<Raw> broken;
  for (int i = 0; i < 8 && !in.is_empty(); ++i) {
    const uint8_t where = in.byte();
    const size_t place = in.byte() + 256u * in.byte();
    if (where % 8 < 4) {
      const size_t offset = (place + 65536u * (where / 8 % 4)) % image.bytes / (where % 2 ? 1 : 4) * (where % 2 ? 1 : 4);
      unsigned char* at = image.at(offset);
      const size_t left = image.bytes - offset, piece = kPiece - offset % kPiece;
      if (at) change(at, left < piece ? left : piece, in);
    } else if (where % 8 == 4) {
      Bytes* record = opened.data(C2D_TAPE_CONTROL, 2);
      const size_t length = record ? static_cast<size_t>(opened.length(C2D_TAPE_CONTROL, 2)) : 0;
      if (length > 0) change(record->data() + kHeader + place % length, length - place % length, in);
    } else if (where % 8 < 7) {
      const int32_t tape = 1 + where / 8 % 3;
      const size_t blocks = store.tape[tape].size(), number = blocks > 0 ? place % blocks : 0;
      Bytes* block = blocks > 0 ? opened.data(tape, number) : nullptr;
      const size_t length = block ? static_cast<size_t>(opened.length(tape, number)) : 0;
      const size_t offset = length > 0 ? (in.byte() + 256u * in.byte()) % length / 4 * 4 : 0;
      if (length > 0) change(block->data() + kHeader + offset, length - offset, in);
    } else {
      const size_t tape = where / 8 % 4, blocks = store.tape[tape].size(), number = blocks > 0 ? place % blocks : 0;
      if (blocks > 0 && !store.tape[tape][number].empty())
        broken.push_back({tape, number, (in.byte() + 256u * in.byte()) % store.tape[tape][number].size(), in.byte()});
    }
  }
  image.sum();
  opened.seal();
  for (const Raw& raw : broken) store.tape[raw.tape][raw.block][raw.offset] = raw.value;
}

struct Saved {
  Store store;
  bool running = false;
};

// States of each variant: prepared, and in the middle of its path.
inline const Saved& saved(int variant, bool running) {
  static Saved all[kVariants][2];
  static bool there[kVariants][2] = {};
  Saved& out = all[variant][running];
  if (there[variant][running]) return out;
  there[variant][running] = true;
  c2d_port port = C2D_INIT(c2d_port);
  out.store.serve(port);
  Machine machine(variant, &port);
  const double mu = 0.3, load[] = {1.0, 0.6};
  c2d_outcome outcome = -1;
  c2d_solver* s = machine.solver;
  bool ok = machine.created == C2D_OK && build(s, variant) == C2D_OK && c2d_prepare(s) == C2D_OK;
  if (running) ok = ok && c2d_begin(s, &mu, 1) == C2D_OK && c2d_advance(s, load, 2, &outcome) == C2D_OK;
  ok = ok && c2d_save(s) == C2D_OK;
  out.running = running && ok;
  if (!ok) __builtin_trap(); // the model is at fault, not the library
  return out;
}

// Everything that may be asked of a solver in any state that a restore can leave. Statuses may be any.
inline void ask_everything(c2d_solver* s) {
  static double out[32 * C2D_OFF_FIELDS];
  c2d_summary summary = C2D_INIT(c2d_summary);
  c2d_error error = C2D_INIT(c2d_error);
  c2d_get_summary(s, &summary);
  c2d_last_error(s, &error);
  c2d_message(error.status), c2d_outcome_message(summary.outcome);
  for (int32_t field = 0; field < 64; ++field)
    for (int32_t body = 1; body <= 2; ++body)
      if (c2d_get(s, field, body, 1, 12, out, 1) != C2D_OK) c2d_get(s, field, body, 1, 3, out, 1);
  for (int32_t body = 1; body <= 2; ++body) {
    c2d_body_state body_state = C2D_INIT(c2d_body_state);
    c2d_body_result result = C2D_INIT(c2d_body_result);
    c2d_get_body_state(s, body, &body_state);
    c2d_get_body_result(s, body, &result);
    c2d_indicators(s, body, 1, 6, out, C2D_OFF_FIELDS);
  }
  c2d_zone_state zone = C2D_INIT(c2d_zone_state);
  c2d_get_zone_state(s, 1, &zone);
  const double points[] = {0.5, -0.5, 1.0, 0.5, 1.99, 0.01};
  c2d_interior(s, 0, 3, points, 2, out, C2D_POINT_FIELDS);
}

inline void take_up(Store& store, int variant) {
  c2d_port port = C2D_INIT(c2d_port);
  store.serve(port);
  Machine machine(variant, &port);
  c2d_solver* s = machine.solver;
  if (build(s, variant) != C2D_OK) __builtin_trap();
  const c2d_status status = c2d_restore(s);
  const int32_t state = c2d_get_state(s);
  if (status == C2D_OK ? state != C2D_STATE_PREPARED && state != C2D_STATE_RUNNING
                       : state != C2D_STATE_MODEL && state != C2D_STATE_BROKEN)
    __builtin_trap();
  ask_everything(s);
  const double mu = 0.2, loads[][2] = {{1.0, 0.9}, {0.5, -0.4}, {0.0, 0.0}, {1.0, 0.0}};
  const double values[] = {0, -3, 0, 0};
  double step = 0.0;
  c2d_outcome outcome = 0;
  c2d_next_event(s, loads[0], 2, &step);
  for (const double* load : loads) c2d_advance(s, load, 2, &outcome);
  c2d_save(s);
  c2d_begin(s, &mu, 1);
  c2d_advance(s, loads[0], 2, &outcome);
  if (c2d_change_loads(s) == C2D_OK) c2d_set_values(s, 2, 4, 1, 1, values), c2d_prepare(s);
  c2d_run(s, nullptr, nullptr);
  c2d_restore(s);
  c2d_close(s);
}

inline void run(const uint8_t* data, size_t size) {
  Source in{data, size};
  const uint8_t first = in.byte();
  const int variant = first % kVariants;
  Store store = saved(variant, first / kVariants % 2 != 0).store;
  forge(store, in);
  take_up(store, variant);
}

} // namespace forged

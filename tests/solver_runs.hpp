// Whole runs through the C interface, for tests: decks in memory, a block store of vectors that can be interfered
// with, a solver in a workspace of its own, and every number it gives, to be compared bit by bit.
#pragma once

#include "callable.hpp"
#include "contact2d.h"
#include "host_structs.hpp"
#include "paths.hpp"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace runs {

using Bytes = std::vector<unsigned char>;

struct Deck {
  std::vector<std::string> lines;
  size_t next = 0;
  static int32_t read(void* context, char* text, int32_t size) {
    Deck& deck = *static_cast<Deck*>(context);
    if (deck.next == deck.lines.size()) return -1;
    const std::string& line = deck.lines[deck.next++];
    const size_t fits = line.size() < static_cast<size_t>(size) ? line.size() : static_cast<size_t>(size) - 1;
    std::memcpy(text, line.data(), fits);
    text[fits] = '\0';
    return static_cast<int32_t>(line.size());
  }
  host::Limits limits() const {
    Deck copy = *this;
    copy.next = 0;
    host::Limits out;
    out.bodies = host::Limits::kRoom;
    if (c2d_scan_deck(read, &copy, &out, nullptr) != C2D_OK) out.bodies = -1;
    return out;
  }
};

inline Deck deck_named(const std::string& name) {
  std::ifstream file(paths::root() + "/tests/data/decks/" + name + ".dat");
  Deck deck;
  for (std::string line; std::getline(file, line);) deck.lines.push_back(line);
  return deck;
}
inline const std::vector<std::string>& deck_names() {
  static const std::vector<std::string> names = {"plate", "ring3",    "hertz_lin_l", "sample",        "layer_t",
                                                 "rect",  "layer_mu", "block",       "half_cylinder", "sample56"};
  return names;
}

// A store of byte strings that counts what it is asked for. `before` may return a code, which the operation then
// fails with; `after_read` may spoil what was read; `keep` is how many bytes of a write arrive.
struct RamStore {
  struct Operation {
    char kind; // o, r, w, s, c
    int32_t tape;
    uint64_t block, bytes;
  };
  std::vector<Bytes> tape[C2D_TAPES];
  uint64_t blocks[C2D_TAPES] = {}, writes[C2D_TAPES] = {}, reads[C2D_TAPES] = {};
  uint64_t bytes_written[C2D_TAPES] = {}, bytes_read[C2D_TAPES] = {};
  std::vector<Operation> done;
  test::Callable<int32_t(const Operation&, size_t n)> before;
  test::Callable<void(const Operation&, size_t n, unsigned char* data)> after_read;
  test::Callable<uint64_t(const Operation&, size_t n)> keep;

  int32_t begin(const Operation& operation) {
    done.push_back(operation);
    return before ? before(operation, done.size() - 1) : 0;
  }
  static RamStore& self(void* context) { return *static_cast<RamStore*>(context); }
  static int32_t open(void* context, int32_t t, uint64_t count, uint64_t bytes) {
    RamStore& s = self(context);
    const int32_t code = s.begin({'o', t, count, bytes});
    if (code != 0) return code;
    s.blocks[t] = count;
    s.tape[t].resize(count);
    for (Bytes& block : s.tape[t]) block.resize(bytes, 0);
    return 0;
  }
  static int32_t read(void* context, int32_t t, uint64_t block, void* data, uint64_t bytes) {
    RamStore& s = self(context);
    const Operation operation{'r', t, block, bytes};
    const int32_t code = s.begin(operation);
    if (code != 0) return code;
    const Bytes& from = s.tape[t].at(block);
    if (bytes > from.size()) return 99;
    std::memcpy(data, from.data(), bytes);
    s.reads[t] += 1;
    s.bytes_read[t] += bytes;
    if (s.after_read) s.after_read(operation, s.done.size() - 1, static_cast<unsigned char*>(data));
    return 0;
  }
  static int32_t write(void* context, int32_t t, uint64_t block, const void* data, uint64_t bytes) {
    RamStore& s = self(context);
    const Operation operation{'w', t, block, bytes};
    const int32_t code = s.begin(operation);
    if (code != 0) return code;
    if (bytes > s.tape[t].at(block).size()) return 99;
    std::memcpy(s.tape[t].at(block).data(), data, s.keep ? s.keep(operation, s.done.size() - 1) : bytes);
    s.writes[t] += 1;
    s.bytes_written[t] += bytes;
    return 0;
  }
  static int32_t sync(void* context, int32_t t) { return self(context).begin({'s', t, 0, 0}); }
  static int32_t close(void* context, int32_t t) { return self(context).begin({'c', t, 0, 0}); }
  void serve(c2d_port& port) {
    port.context = this;
    port.open = open, port.read = read, port.write = write, port.sync = sync, port.close = close;
  }
};

// A solver in a workspace of `bytes` bytes that starts `offset` bytes after a multiple of 64, between guards.
class Machine {
public:
  static constexpr size_t kGuard = 128;

  Machine(const c2d_limits& limits, uint64_t bytes, const c2d_port* port, size_t offset = 0)
      : room_(static_cast<size_t>(bytes) + 2 * kGuard + 128, kMark), bytes_(static_cast<size_t>(bytes)) {
    const size_t past = reinterpret_cast<uintptr_t>(room_.data() + kGuard) % 64;
    start_ = kGuard + (64 - past) % 64 + offset;
    create(limits, port);
  }
  ~Machine() {
    if (c2d_get_state(solver) >= 0) c2d_close(solver);
  }
  Machine(const Machine&) = delete;
  Machine& operator=(const Machine&) = delete;

  void create(const c2d_limits& limits, const c2d_port* port) {
    created = c2d_create(&solver, room_.data() + start_, bytes_, &limits, port, &why);
  }
  bool guards_are_whole() const {
    const unsigned char *const begin = room_.data(), *const end = begin + room_.size();
    const auto is_mark = [](unsigned char byte) { return byte == kMark; };
    return std::all_of(begin, begin + start_, is_mark) && std::all_of(begin + start_ + bytes_, end, is_mark);
  }
  Bytes workspace() const { return Bytes(room_.begin() + static_cast<long>(start_), room_.end()); }

  c2d_solver* solver = nullptr;
  c2d_error why = C2D_INIT(c2d_error);
  c2d_status created = C2D_OK;

private:
  static constexpr unsigned char kMark = 0xA5;
  Bytes room_;
  size_t bytes_, start_ = 0;
};

// Every number of a run: result rows of every recorded step, then the whole boundary.
struct Numbers {
  std::vector<double> steps, boundary;
  int32_t outcome = 0;
  bool operator==(const Numbers& other) const {
    return outcome == other.outcome && same(steps, other.steps) && same(boundary, other.boundary);
  }
  static bool same(const std::vector<double>& a, const std::vector<double>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0);
  }
  static int32_t take(void* context, const c2d_step* step) {
    Numbers& to = *static_cast<Numbers*>(context);
    to.steps.push_back(step->load);
    for (int32_t pair = 0; pair < step->pairs; ++pair)
      to.steps.insert(to.steps.end(), step->table + pair * step->stride, step->table + pair * step->stride + C2D_PAIR_FIELDS);
    return 0;
  }
};

inline c2d_status get_boundary(c2d_solver* s, Numbers& out) {
  host::Summary summary;
  host::get_summary(s, summary);
  out.outcome = summary.outcome;
  for (int32_t body = 1; body <= summary.bodies; ++body) {
    c2d_body_result own = C2D_INIT(c2d_body_result);
    c2d_status status = c2d_get_body_result(s, body, &own);
    const int32_t ends = own.elements * summary.function_nodes;
    for (int32_t field = C2D_END_X; field <= C2D_END_STATUS && status == C2D_OK; ++field) {
      const size_t at = out.boundary.size();
      out.boundary.resize(at + static_cast<size_t>(ends));
      status = c2d_get(s, field, body, 1, ends, out.boundary.data() + at, 1);
    }
    if (status != C2D_OK) return status;
  }
  return C2D_OK;
}

inline c2d_status run_prepared(c2d_solver* s, Numbers& out) {
  out = Numbers();
  const c2d_status status = c2d_run(s, Numbers::take, &out);
  return status == C2D_OK ? get_boundary(s, out) : status;
}
inline c2d_status read_deck(c2d_solver* s, Deck deck) {
  deck.next = 0;
  return c2d_read_deck(s, Deck::read, &deck);
}
// Deck, prepare, run, boundary.
inline c2d_status run_all(c2d_solver* s, const Deck& deck, Numbers& out, const c2d_options* options = nullptr) {
  c2d_status status = options ? c2d_set_options(s, options) : C2D_OK;
  if (status == C2D_OK) status = read_deck(s, deck);
  if (status == C2D_OK) status = c2d_prepare(s);
  return status == C2D_OK ? run_prepared(s, out) : status;
}

inline host::Summary summary_of(c2d_solver* s) {
  host::Summary out;
  host::get_summary(s, out);
  return out;
}
inline c2d_error error_of(c2d_solver* s) {
  c2d_error out = C2D_INIT(c2d_error);
  c2d_last_error(s, &out);
  return out;
}

} // namespace runs

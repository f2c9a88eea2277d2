// Format of one block on a tape (FORMAT.md): header, checks and end mark.
//
// A store may return a block that is torn, short, old, from another place, or changed. Each of these has its own evidence:
// 1. The header has a check of its own, so its numbers can be used before the data are read.
// 2. The last 8 bytes of data are replaced by a mark that depends on the label; the header keeps them. If the tail of the
//    block was not written, the mark is another one: torn.
// 3. A checksum covers header and data: a flipped bit.
// 4. The label (run, tape, generation, block, length) is compared by tapes.cpp: stale or swapped.
// The checksum is no protection against intent: whoever reads numbers that address memory checks them as well.
#include "store/block.hpp"
#include "memory/config.hpp"
#include <string.h>

namespace c2d {
namespace {

// Offsets in the header. All numbers are little-endian but the byte-order mark, which is written as the
// machine writes it, like the data.
enum : size_t {
  kMagic = 0,        // 4 bytes
  kVersion = 4,      // 2
  kByteOrder = 6,    // 2
  kScalar = 8,       // 1, then 3 zero bytes
  kHeaderCheck = 12, // 4
  kRun = 16,         // 8
  kTape = 24,        // 4
  kGeneration = 28,  // 4
  kBlock = 32,       // 8
  kLength = 40,      // 8
  kDisplaced = 48,   // 8
  kSum = 56,         // 8
};
const unsigned char kMagicBytes[4] = {'C', '2', 'D', 'B'};
constexpr uint16_t kByteOrderMark = 0x0102;
constexpr uint64_t kMultiplier = 0x9E3779B97F4A7C15u; // odd, hence invertible modulo 2^64

uint64_t load(const unsigned char* p, size_t bytes) {
  uint64_t value = 0;
  for (size_t i = 0; i < bytes; ++i) value |= static_cast<uint64_t>(p[i]) << (8 * i);
  return value;
}
void store(unsigned char* p, size_t bytes, uint64_t value) {
  for (size_t i = 0; i < bytes; ++i) p[i] = static_cast<unsigned char>(value >> (8 * i));
}

// load(p, 8) in a form that compiles to one instruction on little-endian machines.
uint64_t load_word(const unsigned char* p) {
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
  uint64_t value;
  memcpy(&value, p, 8);
  return value;
#else
  return load(p, 8);
#endif
}

// One step of the sum: for a fixed word a bijection of the state, for a fixed state a bijection of the word. So a change of
// one word always changes the sum.
uint64_t take(uint64_t state, uint64_t word) {
  state = (state ^ word) * kMultiplier;
  return state ^ (state >> 32);
}

// One word in each lane; written out, so that the lanes stay in registers.
inline void take_four(uint64_t lane[4], const unsigned char* p) {
  if (kSmallCode) {
    for (int i = 0; i < 4; ++i) lane[i] = take(lane[i], load_word(p + 8 * i));
    return;
  }
  lane[0] = take(lane[0], load_word(p));
  lane[1] = take(lane[1], load_word(p + 8));
  lane[2] = take(lane[2], load_word(p + 16));
  lane[3] = take(lane[3], load_word(p + 24));
}

uint64_t end_bytes(uint64_t length) { return length < 8 ? length : 8; }

// The mark at the end of a block depends on its whole label. So neither the end of an older block in the same place nor a
// place that was never written is accepted.
uint64_t end_mark(const unsigned char* header) { return mix(checksum(1, header + kRun, kDisplaced - kRun)); }

uint32_t header_check(const unsigned char* header) {
  uint64_t sum = checksum(2, header, kHeaderCheck);
  sum = checksum(sum, header + kRun, kSum - kRun);
  return static_cast<uint32_t>(sum >> 32);
}

// Covers the header without the sum itself, then the data as they are on the tape.
uint64_t block_sum(const unsigned char* block, uint64_t length) {
  return checksum(checksum(3, block, kSum), block + kBlockHeaderBytes, length);
}

int32_t equal_bytes(const unsigned char* a, const unsigned char* b, uint64_t count) {
  int32_t equal = 0;
  for (uint64_t i = 0; i < count; ++i) equal += a[i] == b[i];
  return equal;
}

// Is the end of the data the one written with this header? One wrong byte is left to the checksum: that is a flipped bit
// rather than a torn block.
bool torn(const unsigned char* block, uint64_t length) {
  unsigned char mark[8];
  store(mark, 8, end_mark(block));
  const uint64_t count = end_bytes(length);
  const unsigned char* end = block + kBlockHeaderBytes + length - count;
  return equal_bytes(end, mark, count) + 1 < static_cast<int32_t>(count);
}

// Version, byte order and size of a number, of a header whose own check has passed: a sound block of another build.
bool foreign(const unsigned char* header, BlockReport* report) {
  uint16_t order;
  memcpy(&order, header + kByteOrder, sizeof order);
  const uint64_t found[3] = {load(header + kVersion, 2), order, header[kScalar]};
  const uint64_t expected[3] = {kBlockVersion, kByteOrderMark, sizeof(Real)};
  static const char* const names[3] = {"format version (another version of the library)",
                                       "byte order mark (a machine of the other byte order)",
                                       "bytes of a stored number (a library with another C2D_REAL)"};
  for (int32_t i = 0; i < 3; ++i) {
    if (found[i] == expected[i]) continue;
    *report = {BlockFault::version, found[i], expected[i], names[i]};
    return true;
  }
  return false;
}

} // namespace

uint64_t mix(uint64_t word) {
  word = (word ^ (word >> 32)) * kMultiplier;
  word = (word ^ (word >> 29)) * kMultiplier;
  return word ^ (word >> 32);
}

uint64_t checksum(uint64_t start, const void* bytes, uint64_t count) {
  const unsigned char* p = static_cast<const unsigned char*>(bytes);
  // Four lanes: a multiplication then need not wait for the result of the previous one.
  uint64_t lane[4] = {start, ~start, start + kMultiplier, start - kMultiplier};
  uint64_t left = count;
  for (; left >= 32; left -= 32, p += 32) take_four(lane, p);
  uint64_t sum = mix(take(take(take(lane[0], lane[1]), lane[2]), lane[3]));
  for (; left >= 8; left -= 8, p += 8) sum = take(sum, load_word(p));
  sum = take(sum, load(p, static_cast<size_t>(left)));
  return mix(take(sum, count));
}

void seal_block(const BlockLabel& label, void* buffer) {
  unsigned char* block = static_cast<unsigned char*>(buffer);
  const uint16_t order = kByteOrderMark;
  // Unused bytes are zero, so that the same block has the same bytes in every run.
  memset(block, 0, kBlockHeaderBytes);
  memcpy(block + kMagic, kMagicBytes, sizeof kMagicBytes);
  store(block + kVersion, 2, kBlockVersion);
  memcpy(block + kByteOrder, &order, sizeof order);
  block[kScalar] = sizeof(Real);
  store(block + kRun, 8, label.run_id);
  store(block + kTape, 4, static_cast<uint32_t>(label.tape));
  store(block + kGeneration, 4, label.generation);
  store(block + kBlock, 8, label.block);
  store(block + kLength, 8, label.length);
  unsigned char mark[8];
  store(mark, 8, end_mark(block));
  // The end of the data moves into the header; the mark takes its place.
  const size_t count = static_cast<size_t>(end_bytes(label.length));
  unsigned char* end = block + kBlockHeaderBytes + label.length - count;
  memcpy(block + kDisplaced, end, count);
  memcpy(end, mark, count);
  // The checks come last, because they cover everything above.
  store(block + kHeaderCheck, 4, header_check(block));
  store(block + kSum, 8, block_sum(block, label.length));
}

void unseal_block(void* buffer, uint64_t data_bytes) {
  unsigned char* block = static_cast<unsigned char*>(buffer);
  const size_t count = static_cast<size_t>(end_bytes(data_bytes));
  memcpy(block + kBlockHeaderBytes + data_bytes - count, block + kDisplaced, count);
}

BlockReport inspect_block(const void* buffer, uint64_t data_bytes, BlockLabel* label) {
  const unsigned char* block = static_cast<const unsigned char*>(buffer);
  BlockReport report = {BlockFault::none, 0, 0, ""};
  // One wrong byte of the magic number: a damaged block of this library. Two or more: other data.
  if (equal_bytes(block, kMagicBytes, 4) < 3) {
    report.fault = BlockFault::format;
    return report;
  }
  const uint64_t check = load(block + kHeaderCheck, 4);
  if (check != header_check(block)) {
    return {BlockFault::checksum, check, header_check(block), "header check"};
  }
  if (foreign(block, &report)) return report;
  label->run_id = load(block + kRun, 8);
  label->tape = static_cast<int32_t>(static_cast<uint32_t>(load(block + kTape, 4)));
  label->generation = static_cast<uint32_t>(load(block + kGeneration, 4));
  label->block = load(block + kBlock, 8);
  label->length = load(block + kLength, 8);
  if (label->length > data_bytes) return report; // longer than requested: the data were not read
  if (torn(block, label->length)) {
    report.fault = BlockFault::torn;
    return report;
  }
  const uint64_t found = load(block + kSum, 8), expected = block_sum(block, label->length);
  if (found != expected) return {BlockFault::checksum, found, expected, "checksum"};
  return report;
}

} // namespace c2d

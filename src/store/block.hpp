#pragma once
// One block on a tape: a header of 64 bytes, then the data. FORMAT.md in this folder describes it for other programs; block.cpp
// is the only file that knows the offsets.
#include <stddef.h>
#include <stdint.h>

namespace c2d {

constexpr size_t kBlockHeaderBytes = 64;
constexpr uint16_t kBlockVersion = 3; // of the format page; any change of a byte on the tape raises it

// The label of a block, in its header.
struct BlockLabel {
  uint64_t run_id;     // identifies the run: a hash of the model and of the run's number
  uint64_t block;      // place on the tape, from 0
  uint64_t length;     // bytes of data behind the header
  int32_t tape;        // C2D_TAPE_...
  uint32_t generation; // how often the tape's contents were started anew within the run
};

enum class BlockFault {
  none,
  format,   // no block of this library: never written, or overwritten by other data
  version,  // sound, but of another format version, byte order or scalar size
  torn,     // the header is sound, the end of the block is not the end that was written with it
  checksum, // header or data differ from what was written
};

// The fault of a block, for a message; only the fields that belong to the fault are set.
struct BlockReport {
  BlockFault fault;
  uint64_t found, expected; // version: the differing numbers; checksum: the two sums
  const char* what;         // which part differs
};

// A 64-bit checksum of bytes[0 .. count), continued from `start`. Every step is a bijection of the state and of the word
// added, so a change within one 64-bit word is always detected; any other change is missed with probability 2^-64. The value
// does not depend on the machine's byte order.
uint64_t checksum(uint64_t start, const void* bytes, uint64_t count);

// A bijection of 64-bit numbers that spreads every bit over the whole word.
uint64_t mix(uint64_t word);

// Makes buffer[0 .. 64 + label.length) a block as it goes to the tape: fills in the header and replaces the last (up to) 8
// bytes of data by an end mark; the header keeps them.
void seal_block(const BlockLabel& label, void* buffer);
// Removes the end mark: the data are as they were before seal_block.
void unseal_block(void* buffer, uint64_t data_bytes);

// Checks a block of which buffer[0 .. 64 + data_bytes) was read. Except for the faults `format` and `version`, *label is the
// label in the header. With fault `none` the block is sound (if label->length > data_bytes: its header is; the data were not
// examined). The caller decides whether it is the requested block. The end mark stays in place.
BlockReport inspect_block(const void* buffer, uint64_t data_bytes, BlockLabel* label);

} // namespace c2d

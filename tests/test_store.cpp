#include "c2d_memory.h"
#include "c2d_posix.h"
#include "c2d_stdio.h"
#include "callable.hpp"
#include "memory/config.hpp"
#include "store/tapes.hpp"
#include <cerrno>
#include <cstring>
#include <doctest/doctest.h>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <sys/wait.h>
#include <type_traits>
#include <unistd.h>
#include <vector>

using namespace c2d;

static_assert(std::is_trivially_copyable<Tapes>::value, "tapes move with the workspace");

namespace {

using Bytes = std::vector<unsigned char>;

// A store of byte strings whose every operation can be interfered with.
struct TestStore {
  std::vector<Bytes> tape[C2D_TAPES];
  int32_t operations = 0;
  int32_t fail_at = -1;               // the operation that returns 77
  uint64_t fill_at_most = UINT64_MAX; // bytes that a read really delivers
  char failed = ' ';

  bool fails(char kind) {
    if (operations++ != fail_at) return false;
    failed = kind;
    return true;
  }
  static TestStore* self(void* context) { return static_cast<TestStore*>(context); }
  static int32_t open(void* context, int32_t tape, uint64_t blocks, uint64_t block_bytes) {
    if (self(context)->fails('o')) return 77;
    self(context)->tape[tape].resize(blocks, Bytes(block_bytes, 0));
    return 0;
  }
  static int32_t read(void* context, int32_t tape, uint64_t block, void* data, uint64_t bytes) {
    if (self(context)->fails('r')) return 77;
    const uint64_t count = bytes < self(context)->fill_at_most ? bytes : self(context)->fill_at_most;
    std::memcpy(data, self(context)->tape[tape].at(block).data(), count);
    return 0;
  }
  static int32_t write(void* context, int32_t tape, uint64_t block, const void* data, uint64_t bytes) {
    if (self(context)->fails('w')) return 77;
    std::memcpy(self(context)->tape[tape].at(block).data(), data, bytes);
    return 0;
  }
  static int32_t sync(void* context, int32_t) { return self(context)->fails('s') ? 77 : 0; }
  static int32_t close(void* context, int32_t) { return self(context)->fails('c') ? 77 : 0; }
  c2d_port port() {
    c2d_port port = C2D_INIT(c2d_port);
    port.context = this;
    port.open = open, port.read = read, port.write = write, port.sync = sync, port.close = close;
    return port;
  }
};

Bytes pattern(size_t count, unsigned seed) {
  Bytes bytes(count);
  for (size_t i = 0; i < count; ++i) bytes[i] = static_cast<unsigned char>(37 * i + 11 * seed + (i >> 3) * seed);
  return bytes;
}

// A tape of 4 blocks of up to `bytes` bytes, with blocks 0 and 1 written.
struct Written {
  TestStore store;
  c2d_port port;
  Tapes tapes;
  uint64_t bytes;
  Bytes buffer;
  explicit Written(uint64_t data_bytes) : port(store.port()), bytes(data_bytes) {
    std::memset(&tapes, 0, sizeof tapes);
    tapes.port = &port;
    tapes.run_id = 4711;
    REQUIRE(open_tape(tapes, C2D_TAPE_UPPER, 4, bytes + 8) == C2D_OK);
    write(0, 1);
    write(1, 2);
  }
  void write(uint64_t block, unsigned seed) {
    const Bytes data = pattern(bytes, seed);
    buffer.assign(kBlockHeaderBytes, 0xEE);
    buffer.insert(buffer.end(), data.begin(), data.end());
    REQUIRE(write_block(tapes, C2D_TAPE_UPPER, block, buffer.data(), bytes) == C2D_OK);
    REQUIRE(Bytes(buffer.begin() + kBlockHeaderBytes, buffer.end()) == data);
  }
  c2d_status read(uint64_t block) { return read(block, bytes); }
  c2d_status read(uint64_t block, uint64_t count) {
    buffer.assign(kBlockHeaderBytes + count, 0xDD);
    return read_block(tapes, C2D_TAPE_UPPER, block, buffer.data(), count);
  }
  bool holds(unsigned seed) const { return Bytes(buffer.begin() + kBlockHeaderBytes, buffer.end()) == pattern(bytes, seed); }
  Bytes& on_tape(uint64_t block) { return store.tape[C2D_TAPE_UPPER].at(block); }
};

uint64_t mix_by_the_page(uint64_t w) {
  constexpr uint64_t k = 0x9E3779B97F4A7C15u;
  w = (w ^ w >> 32) * k;
  w = (w ^ w >> 29) * k;
  return w ^ w >> 32;
}

// The sum of FORMAT.md, byte by byte, from the page and not from the code.
uint64_t sum_by_the_page(uint64_t start, const Bytes& bytes) {
  constexpr uint64_t k = 0x9E3779B97F4A7C15u;
  const auto mixed = mix_by_the_page;
  auto taken = [](uint64_t s, uint64_t w) {
    s = (s ^ w) * k;
    return s ^ s >> 32;
  };
  auto number = [&bytes](size_t from, size_t to) {
    uint64_t value = 0;
    for (size_t i = to; i > from; --i) value = value * 256 + bytes[i - 1];
    return value;
  };
  uint64_t lane[4] = {start, ~start, start + k, start - k};
  size_t at = 0;
  for (; bytes.size() - at >= 32; at += 32) {
    for (size_t i = 0; i < 4; ++i) lane[i] = taken(lane[i], number(at + 8 * i, at + 8 * i + 8));
  }
  uint64_t s = mixed(taken(taken(taken(lane[0], lane[1]), lane[2]), lane[3]));
  for (; bytes.size() - at >= 8; at += 8) s = taken(s, number(at, at + 8));
  return mixed(taken(taken(s, number(at, bytes.size())), bytes.size()));
}

// A fresh folder that goes away with its files.
struct Folder {
  std::string path;
  Folder() {
    char name[] = "/tmp/contact2d_store_XXXXXX";
    REQUIRE(mkdtemp(name) != nullptr);
    path = name;
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
  std::string name(const std::string& file) const { return path + "/" + file; }
  bool has(const std::string& file) const { return access(name(file).c_str(), F_OK) == 0; }
};

// Run the same checks against each of the ready ports.
void with_every_port(const test::Callable<void(c2d_port&, const std::string&)>& check) {
  Bytes region(100000);
  c2d_memory_store memory;
  c2d_port port = C2D_INIT(c2d_port);
  c2d_memory_store_init(&memory, region.data() + 1, region.size() - 1); // misaligned on purpose
  c2d_memory_store_port(&memory, &port);
  check(port, "memory");
  Folder folder;
  {
    c2d_stdio_store store;
    REQUIRE(c2d_stdio_store_init(&store, folder.path.c_str()) == 0);
    c2d_stdio_store_port(&store, &port);
    check(port, "stdio");
    CHECK(folder.has("tape1.c2d"));
    CHECK(c2d_stdio_store_remove(&store) == 0);
    CHECK_FALSE(folder.has("tape1.c2d"));
  }
  c2d_posix_store store;
  REQUIRE(c2d_posix_store_init(&store, folder.path.c_str()) == 0);
  c2d_posix_store_port(&store, &port);
  check(port, "posix");
  CHECK(folder.has("contact2d.store/tape1.c2d"));
  CHECK(c2d_posix_store_remove(&store) == 0);
  CHECK_FALSE(folder.has("contact2d.store/tape1.c2d"));
  CHECK(c2d_posix_store_done(&store) == 0);
}

} // namespace

TEST_CASE("checksum agrees with the format page and sees every single flipped bit") {
  for (size_t count : std::vector<size_t>{0, 1, 7, 8, 9, 31, 32, 33, 64, 100, 200}) {
    Bytes bytes = pattern(count, 3);
    const uint64_t sum = checksum(5, bytes.data(), bytes.size());
    CHECK(sum == sum_by_the_page(5, bytes));
    for (size_t bit = 0; bit < 8 * count; ++bit) {
      bytes[bit / 8] = static_cast<unsigned char>(bytes[bit / 8] ^ (1u << bit % 8));
      REQUIRE(checksum(5, bytes.data(), bytes.size()) != sum);
      bytes[bit / 8] = static_cast<unsigned char>(bytes[bit / 8] ^ (1u << bit % 8));
    }
  }
}

TEST_CASE("blocks of every length come back as they were written") {
  for (uint64_t bytes : std::vector<uint64_t>{0, 1, 4, 7, 8, 9, 63, 64, 1000}) {
    Written w(bytes);
    CHECK(w.read(1) == C2D_OK);
    CHECK(w.holds(2));
    CHECK(w.read(0) == C2D_OK);
    CHECK(w.holds(1));
    CHECK(w.tapes.writes[C2D_TAPE_UPPER] == 2);
    CHECK(w.tapes.reads[C2D_TAPE_UPPER] == 2);
    CHECK(w.tapes.bytes_written[C2D_TAPE_UPPER] == 2 * (bytes + 64));
    CHECK(w.tapes.bytes_read[C2D_TAPE_UPPER] == 2 * (bytes + 64));
    CHECK(w.tapes.reads[C2D_TAPE_LOWER] == 0);
  }
}

TEST_CASE("the header stands on the tape as the format page says") {
  Written w(20);
  w.tapes.generation[C2D_TAPE_UPPER] = 0x01020304;
  w.tapes.run_id = 0x1122334455667788u;
  w.write(3, 9);
  const Bytes block(w.on_tape(3).begin(), w.on_tape(3).begin() + 84);
  auto number = [&block](size_t at, size_t count) {
    uint64_t value = 0;
    for (size_t i = count; i > 0; --i) value = value * 256 + block[at + i - 1];
    return value;
  };
  CHECK(std::string(block.begin(), block.begin() + 4) == "C2DB");
  CHECK(number(4, 2) == 3);
  CHECK(number(8, 4) == sizeof(Real));
  CHECK(number(16, 8) == 0x1122334455667788u);
  CHECK(number(24, 4) == C2D_TAPE_UPPER);
  CHECK(number(28, 4) == 0x01020304u);
  CHECK(number(32, 8) == 3);
  CHECK(number(40, 8) == 20);
  const Bytes data = pattern(20, 9);
  CHECK(Bytes(block.begin() + 48, block.begin() + 56) == Bytes(data.end() - 8, data.end()));
  CHECK(Bytes(block.begin() + 64, block.begin() + 76) == Bytes(data.begin(), data.end() - 8));
  const uint64_t mark = mix_by_the_page(sum_by_the_page(1, Bytes(block.begin() + 16, block.begin() + 48)));
  CHECK(number(76, 8) == mark);
  const uint64_t sum = sum_by_the_page(3, Bytes(block.begin(), block.begin() + 56));
  CHECK(number(56, 8) == sum_by_the_page(sum, Bytes(block.begin() + 64, block.end())));
}

TEST_CASE("a flipped bit or a changed byte anywhere in a block is a checksum error") {
  for (uint64_t bytes : std::vector<uint64_t>{0, 4, 24}) {
    Written w(bytes);
    for (size_t i = 0; i < kBlockHeaderBytes + bytes; ++i) {
      for (unsigned change : {1u, 2u, 4u, 8u, 16u, 32u, 64u, 128u, 255u}) {
        unsigned char& byte = w.on_tape(1)[i];
        byte = static_cast<unsigned char>(byte ^ change);
        REQUIRE(w.read(1) == C2D_ERR_STORE_CHECKSUM);
        REQUIRE(w.tapes.error.block == 1);
        REQUIRE(w.tapes.error.tape == C2D_TAPE_UPPER);
        byte = static_cast<unsigned char>(byte ^ change);
      }
    }
    CHECK(w.read(1) == C2D_OK);
  }
}

TEST_CASE("a block of which only the front reached the tape is torn, whatever stood there before") {
  for (bool old_block : {false, true}) {
    Written w(40);
    Bytes before(112, 0);
    if (old_block) before = w.on_tape(1);
    w.tapes.generation[C2D_TAPE_UPPER] += 1; // written anew
    w.write(1, 5);
    const Bytes after = w.on_tape(1);
    const size_t total = 64 + 40;
    for (size_t front = 0; front < total; ++front) {
      std::copy(before.begin(), before.end(), w.on_tape(1).begin());
      std::copy(after.begin(), after.begin() + static_cast<std::ptrdiff_t>(front), w.on_tape(1).begin());
      const c2d_status status = w.read(1);
      if (front == 0)
        CHECK(status == (old_block ? C2D_ERR_STORE_STALE : C2D_ERR_STORE_FORMAT));
      else if (front >= 64 && front + 2 <= total)
        CHECK(status == C2D_ERR_STORE_SHORT);
      else
        CHECK(status != C2D_OK); // inside the header, or a single byte is missing
    }
  }
}

TEST_CASE("two bytes that are wrong at the end are a torn block, whatever stands behind it in memory") {
  Written w(40);
  w.on_tape(1)[64 + 38] ^= 1;
  w.on_tape(1)[64 + 39] ^= 1;
  for (int behind = 0; behind < 256; ++behind) {
    w.buffer.assign(kBlockHeaderBytes + 40 + 1, static_cast<unsigned char>(behind));
    CHECK(read_block(w.tapes, C2D_TAPE_UPPER, 1, w.buffer.data(), 40) == C2D_ERR_STORE_SHORT);
  }
}

TEST_CASE("a port that fills less than it says is found out") {
  Written w(40);
  w.buffer.clear();
  for (uint64_t count = 0; count < 104; ++count) {
    REQUIRE(w.read(1) == C2D_OK); // the buffer now holds the very block
    w.store.fill_at_most = count;
    const c2d_status status = read_block(w.tapes, C2D_TAPE_UPPER, 1, w.buffer.data(), 40);
    if (count < 3)
      CHECK(status == C2D_ERR_STORE_FORMAT);
    else if (count >= 64 && count <= 102)
      CHECK(status == C2D_ERR_STORE_SHORT);
    else
      CHECK(status != C2D_OK);
    w.store.fill_at_most = UINT64_MAX;
  }
}

TEST_CASE("a port that fills all but the end is found out, though the end was in the buffer") {
  Written w(40);
  const size_t all = kBlockHeaderBytes + 40;
  for (uint64_t missing = 3; missing <= 8; ++missing) { // (a single byte is left to the checksum, and so is the last of two)
    Bytes buffer = w.on_tape(1);
    buffer.resize(all);
    buffer.insert(buffer.end(), 16, 0xAB);
    w.store.fill_at_most = all - missing;
    CHECK(read_block(w.tapes, C2D_TAPE_UPPER, 1, buffer.data(), 40) == C2D_ERR_STORE_SHORT);
    CHECK(Bytes(buffer.begin() + static_cast<long>(all), buffer.end()) == Bytes(16, 0xAB));
  }
}

TEST_CASE("a sound block of another length is short") {
  Written w(40);
  CHECK(w.read(1, 48) == C2D_ERR_STORE_SHORT);
  CHECK(w.read(1, 32) == C2D_ERR_STORE_SHORT);
  CHECK(std::string(w.tapes.error.text).find("length in bytes is 40, expected 32") != std::string::npos);
}

TEST_CASE("a sound block in the wrong place is swapped") {
  Written w(40);
  std::swap(w.on_tape(0), w.on_tape(1));
  CHECK(w.read(0) == C2D_ERR_STORE_SWAPPED);
  CHECK(w.read(1) == C2D_ERR_STORE_SWAPPED);
  CHECK(std::string(w.tapes.error.text) == "block store: tape 2 (upper factors, for back substitution), "
                                           "block 1: block 0 of tape 2 was found in its "
                                           "place");
  REQUIRE(open_tape(w.tapes, C2D_TAPE_LOWER, 2, 40) == C2D_OK);
  w.store.tape[C2D_TAPE_LOWER][1] = w.on_tape(0); // block 1 of UPPER
  w.buffer.resize(104);
  CHECK(read_block(w.tapes, C2D_TAPE_LOWER, 1, w.buffer.data(), 40) == C2D_ERR_STORE_SWAPPED);
}

TEST_CASE("a sound block of an earlier generation or another run is stale") {
  Written w(40);
  w.tapes.generation[C2D_TAPE_UPPER] += 1; // written anew
  CHECK(w.read(1) == C2D_ERR_STORE_STALE);
  w.write(1, 7);
  CHECK(w.read(1) == C2D_OK);
  CHECK(w.read(0) == C2D_ERR_STORE_STALE);
  w.tapes.run_id += 1;
  CHECK(w.read(1) == C2D_ERR_STORE_STALE);
  CHECK(w.tapes.error.status == C2D_ERR_STORE_STALE);
}

TEST_CASE("a place never written holds no block") {
  Written w(40);
  CHECK(w.read(2) == C2D_ERR_STORE_FORMAT);
  w.on_tape(2) = pattern(112, 8);
  CHECK(w.read(2) == C2D_ERR_STORE_FORMAT);
}

TEST_CASE("another format version, byte order or scalar size is refused as such") {
  struct Change {
    size_t at;
    unsigned char value;
  };
  Written w(40);
  const Bytes sound = w.on_tape(1);
  const unsigned char other_scalar = sizeof(Real) == 8 ? 4 : 8;
  for (const std::vector<Change>& changes :
       std::vector<std::vector<Change>>{{{4, 1}}, {{4, 2}}, {{4, 4}}, {{6, sound[7]}, {7, sound[6]}}, {{8, other_scalar}}}) {
    Bytes& block = w.on_tape(1);
    block = sound;
    for (const Change& change : changes) block[change.at] = change.value;
    // A writer of that kind would have made its sums right.
    const Bytes front(block.begin(), block.begin() + 12), back(block.begin() + 16, block.begin() + 56);
    const uint64_t check = sum_by_the_page(sum_by_the_page(2, front), back) >> 32;
    for (size_t i = 0; i < 4; ++i) block[12 + i] = static_cast<unsigned char>(check >> 8 * i);
    CHECK(w.read(1) == C2D_ERR_STORE_VERSION);
  }
}

TEST_CASE("asking for what is not there is an error of ours, and the port is not called") {
  Written w(40);
  const int32_t before = w.store.operations;
  CHECK(w.read(4) == C2D_ERR_INTERNAL);
  CHECK(w.read(0, 49) == C2D_ERR_INTERNAL);
  CHECK(open_tape(w.tapes, C2D_TAPE_UPPER, 1, 1) == C2D_ERR_INTERNAL);
  CHECK(open_tape(w.tapes, C2D_TAPES, 1, 1) == C2D_ERR_INTERNAL);
  CHECK(open_tape(w.tapes, C2D_TAPE_LOWER, UINT64_MAX / 2, 8) == C2D_ERR_OVERFLOW);
  CHECK(open_tape(w.tapes, C2D_TAPE_LOWER, 1, UINT64_MAX - 8) == C2D_ERR_OVERFLOW);
  CHECK(sync_tape(w.tapes, C2D_TAPE_LOWER) == C2D_ERR_INTERNAL);
  CHECK(close_tape(w.tapes, C2D_TAPE_LOWER) == C2D_ERR_INTERNAL);
  CHECK(write_block(w.tapes, -1, 0, w.buffer.data(), 8) == C2D_ERR_INTERNAL);
  CHECK(w.store.operations == before);
  w.port.sync = nullptr;
  CHECK(open_tape(w.tapes, C2D_TAPE_LOWER, 1, 8) == C2D_ERR_STORE_OPEN);
}

TEST_CASE("an error of the store is about a tape, perhaps a block, and nothing else") {
  Written w(40);
  std::memset(&w.tapes.error, 0x5A, sizeof w.tapes.error); // of something else
  REQUIRE(open_tape(w.tapes, C2D_TAPE_UPPER, 1, 1) == C2D_ERR_INTERNAL);
  const c2d_error& e = w.tapes.error;
  CHECK((e.status == C2D_ERR_INTERNAL && e.severity == C2D_FAULT && e.tape == C2D_TAPE_UPPER && e.block == 0));
  CHECK((e.host_code == 0 && e.line == 0 && e.column == 0 && e.column_end == 0));
  CHECK((e.body == 0 && e.zone == 0 && e.pair == 0 && e.element == 0 && e.node == 0));
  CHECK((e.bytes_needed == 0 && e.load == 0.0));
  REQUIRE(w.read(4) == C2D_ERR_INTERNAL);
  CHECK(e.block == 4);
}

TEST_CASE("the count of runs stands on its tape as a number of eight bytes, the lowest first") {
  TestStore store;
  const c2d_port port = store.port();
  Tapes tapes;
  std::memset(&tapes, 0, sizeof tapes);
  tapes.port = &port;
  Bytes buffer(kBlockHeaderBytes + kControlBytes);
  REQUIRE(begin_run(tapes, 1, buffer.data()) == C2D_OK);
  tapes.count = 0x0807060504030201u;
  REQUIRE(keep_count(tapes, buffer.data()) == C2D_OK);
  for (size_t i = 0; i < 8; ++i) CHECK(buffer[kBlockHeaderBytes + i] == i + 1);
  uint64_t found = 0;
  REQUIRE(read_count(tapes, &found, buffer.data()) == C2D_OK);
  CHECK(found == 0x0807060504030201u);
}

TEST_CASE("runs are counted on the control tape, and no two have the same id") {
  TestStore store;
  c2d_port port = store.port();
  Bytes buffer(kBlockHeaderBytes + kControlBytes);
  std::set<uint64_t> ids;
  for (int run = 0; run < 6; ++run) {
    Tapes tapes = {};
    tapes.port = &port;
    if (run == 3) store.tape[C2D_TAPE_CONTROL][0][66] ^= 0x10; // damaged
    REQUIRE(begin_run(tapes, 99, buffer.data()) == C2D_OK);
    CHECK(tapes.error.status == C2D_OK);
    ids.insert(tapes.run_id);
    REQUIRE(begin_run(tapes, 100, buffer.data()) == C2D_OK);
    ids.insert(tapes.run_id);
    REQUIRE(close_all(tapes) == C2D_OK);
  }
  CHECK(ids.size() == 12);
}

TEST_CASE("the n-th operation of the store fails, for every n: the right error with the port's code") {
  int32_t n = 0;
  for (bool done = false; !done; ++n) {
    TestStore store;
    store.fail_at = n;
    c2d_port port = store.port();
    Tapes tapes = {};
    tapes.port = &port;
    Bytes buffer(kBlockHeaderBytes + 16);
    c2d_status status = begin_run(tapes, 1, buffer.data());
    if (status == C2D_OK) status = open_tape(tapes, C2D_TAPE_LOWER, 2, 16);
    for (uint64_t i = 0; i < 2 && status == C2D_OK; ++i) {
      status = write_block(tapes, C2D_TAPE_LOWER, i, buffer.data(), 16);
    }
    if (status == C2D_OK) status = sync_tape(tapes, C2D_TAPE_LOWER);
    if (status == C2D_OK) status = read_block(tapes, C2D_TAPE_LOWER, 1, buffer.data(), 16);
    const bool before_close = status == C2D_OK;
    const c2d_error first = tapes.error;
    const c2d_status closed = close_all(tapes);
    if (before_close) status = closed;
    for (uint8_t open : tapes.is_open) CHECK(open == 0);
    const char kinds[] = "orwsc";
    const c2d_status expected[] = {C2D_ERR_STORE_OPEN, C2D_ERR_STORE_READ, C2D_ERR_STORE_WRITE, C2D_ERR_STORE_SYNC,
                                   C2D_ERR_STORE_CLOSE};
    if (n == 1) { // nothing readable on the control tape: a new store
      CHECK(store.failed == 'r');
      CHECK(status == C2D_OK);
    } else if (store.failed == ' ') {
      CHECK(status == C2D_OK);
      done = true;
    } else {
      CHECK(status == expected[std::strchr(kinds, store.failed) - kinds]);
      const c2d_error& error = before_close ? tapes.error : first;
      CHECK(error.status == status);
      CHECK(error.host_code == 77);
      CHECK(error.severity == C2D_FAULT);
      CHECK(std::strlen(error.text) > 20);
    }
  }
  CHECK(n == 12); // 4 to begin the run, 5 with the tape, 2 to close: 11 that can fail
}

TEST_CASE("every ready port keeps blocks, also over closing and opening, and refuses what is out of range") {
  with_every_port([](c2d_port& port, const std::string& name) {
    CAPTURE(name);
    Tapes tapes = {};
    tapes.port = &port;
    Bytes buffer(kBlockHeaderBytes + 100);
    REQUIRE(begin_run(tapes, 1, buffer.data()) == C2D_OK);
    const uint64_t run = tapes.run_id;
    REQUIRE(open_tape(tapes, C2D_TAPE_LOWER, 5, 100) == C2D_OK);
    REQUIRE(open_tape(tapes, C2D_TAPE_CONTACT, 3, 30) == C2D_OK);
    for (uint64_t block : std::vector<uint64_t>{4, 0, 2}) {
      const uint64_t bytes = 100 - block;
      const Bytes data = pattern(bytes, static_cast<unsigned>(block));
      std::copy(data.begin(), data.end(), buffer.begin() + kBlockHeaderBytes);
      REQUIRE(write_block(tapes, C2D_TAPE_LOWER, block, buffer.data(), bytes) == C2D_OK);
      REQUIRE(read_block(tapes, C2D_TAPE_LOWER, block, buffer.data(), bytes) == C2D_OK);
    }
    for (uint64_t block = 0; block < 3; ++block) {
      REQUIRE(write_block(tapes, C2D_TAPE_CONTACT, block, buffer.data(), 30) == C2D_OK);
    }
    CHECK(sync_tape(tapes, C2D_TAPE_LOWER) == C2D_OK);
    REQUIRE(close_all(tapes) == C2D_OK);
    REQUIRE(open_tape(tapes, C2D_TAPE_LOWER, 5, 100) == C2D_OK);
    for (uint64_t block : std::vector<uint64_t>{0, 2, 4}) {
      REQUIRE(read_block(tapes, C2D_TAPE_LOWER, block, buffer.data(), 100 - block) == C2D_OK);
      const Bytes data = pattern(100 - block, static_cast<unsigned>(block));
      CHECK(std::equal(data.begin(), data.end(), buffer.begin() + kBlockHeaderBytes));
    }
    // A block never written is either refused by the port or not taken for a block.
    const c2d_status hole = read_block(tapes, C2D_TAPE_LOWER, 1, buffer.data(), 99);
    CHECK((hole == C2D_ERR_STORE_READ || hole == C2D_ERR_STORE_FORMAT));
    CHECK(port.read(port.context, C2D_TAPE_LOWER, 5, buffer.data(), 8) != 0);
    CHECK(port.write(port.context, C2D_TAPE_LOWER, 0, buffer.data(), 165) != 0);
    CHECK(port.read(port.context, C2D_TAPE_UPPER, 0, buffer.data(), 8) != 0);
    CHECK(port.sync(port.context, C2D_TAPES) != 0);
    CHECK(port.close(port.context, -1) != 0);
    CHECK(port.open(port.context, C2D_TAPES, 1, 1) != 0);
    REQUIRE(begin_run(tapes, 1, buffer.data()) == C2D_OK);
    CHECK(tapes.run_id != run);
    CHECK(read_block(tapes, C2D_TAPE_LOWER, 2, buffer.data(), 98) == C2D_ERR_STORE_STALE);
    CHECK(close_all(tapes) == C2D_OK);
  });
}

TEST_CASE("the memory store says how much would have been enough, and then it is") {
  Bytes region(2000);
  for (uint64_t bytes = 0; bytes < 2000; bytes += 1) {
    c2d_memory_store store;
    c2d_port port = C2D_INIT(c2d_port);
    c2d_memory_store_init(&store, region.data(), bytes);
    c2d_memory_store_port(&store, &port);
    const int32_t first = port.open(port.context, 1, 7, 100), second = port.open(port.context, 2, 3, 200);
    REQUIRE(c2d_memory_store_need(&store) == 1300);
    REQUIRE((first == 0 && second == 0) == (bytes >= 1300));
    if (bytes < 1300) REQUIRE((first == C2D_MEMORY_STORE_FULL || second == C2D_MEMORY_STORE_FULL));
  }
  c2d_memory_store store;
  c2d_port port = C2D_INIT(c2d_port);
  c2d_memory_store_init(&store, region.data(), 2000);
  c2d_memory_store_port(&store, &port);
  CHECK(port.open(port.context, 1, UINT64_MAX / 2, 1000) == C2D_MEMORY_STORE_FULL);
  CHECK(c2d_memory_store_need(&store) == UINT64_MAX);
}

TEST_CASE("a tape of the memory store that is opened with another shape holds nothing of the old one") {
  Bytes region(2000);
  c2d_memory_store store;
  c2d_port port = C2D_INIT(c2d_port);
  c2d_memory_store_init(&store, region.data(), region.size());
  c2d_memory_store_port(&store, &port);
  Tapes tapes = {};
  tapes.port = &port;
  Bytes buffer(kBlockHeaderBytes + 100);
  REQUIRE(open_tape(tapes, 1, 4, 100) == C2D_OK);
  REQUIRE(write_block(tapes, 1, 0, buffer.data(), 60) == C2D_OK);
  REQUIRE(close_tape(tapes, 1) == C2D_OK);
  REQUIRE(open_tape(tapes, 1, 6, 60) == C2D_OK);
  CHECK(read_block(tapes, 1, 0, buffer.data(), 60) == C2D_ERR_STORE_FORMAT);
}

TEST_CASE("stdio and posix stores report folders that cannot be used") {
  Folder folder;
  std::ofstream(folder.name("lock")) << "a file, not a folder\n";
  for (const std::string& bad : {folder.name("missing/deeper"), folder.name("lock")}) {
    c2d_stdio_store stdio_store;
    c2d_port port = C2D_INIT(c2d_port);
    REQUIRE(c2d_stdio_store_init(&stdio_store, bad.c_str()) == 0);
    c2d_stdio_store_port(&stdio_store, &port);
    Tapes tapes = {};
    tapes.port = &port;
    CHECK(open_tape(tapes, C2D_TAPE_LOWER, 1, 8) == C2D_ERR_STORE_OPEN);
    const bool right = tapes.error.host_code == ENOENT || tapes.error.host_code == ENOTDIR;
    CHECK(right);
    c2d_posix_store posix_store;
    const int32_t code = c2d_posix_store_init(&posix_store, bad.c_str());
    CHECK((code == ENOENT || code == ENOTDIR));
    CHECK(c2d_posix_store_done(&posix_store) == 0);
  }
  c2d_stdio_store store;
  CHECK(c2d_stdio_store_init(&store, "") == C2D_STDIO_STORE_NAME);
  CHECK(c2d_stdio_store_init(&store, nullptr) == C2D_STDIO_STORE_NAME);
  CHECK(c2d_stdio_store_init(&store, std::string(1000, 'x').c_str()) == C2D_STDIO_STORE_NAME);
  CHECK(c2d_stdio_store_init(&store, std::string(999, 'x').c_str()) == 0);
}

TEST_CASE("a full disk is reported with its errno") {
  if (access("/dev/full", W_OK) != 0) return; // only Linux has it
  Folder folder;
  REQUIRE(symlink("/dev/full", folder.name("tape1.c2d").c_str()) == 0);
  Bytes buffer(kBlockHeaderBytes + 100000);
  for (uint64_t bytes : std::vector<uint64_t>{8, 100000}) { // the smaller one waits in stdio's buffer until sync
    c2d_stdio_store store;
    c2d_port port = C2D_INIT(c2d_port);
    REQUIRE(c2d_stdio_store_init(&store, folder.path.c_str()) == 0);
    c2d_stdio_store_port(&store, &port);
    Tapes tapes = {};
    tapes.port = &port;
    REQUIRE(open_tape(tapes, C2D_TAPE_LOWER, 1, bytes) == C2D_OK);
    c2d_status status = write_block(tapes, C2D_TAPE_LOWER, 0, buffer.data(), bytes);
    const bool late = status == C2D_OK;
    if (late) status = sync_tape(tapes, C2D_TAPE_LOWER);
    CHECK(status == (late ? C2D_ERR_STORE_SYNC : C2D_ERR_STORE_WRITE));
    CHECK(tapes.error.host_code == ENOSPC);
    close_all(tapes);
  }
}

TEST_CASE("the posix store takes nothing for its own that it has not made") {
  Folder folder;
  const std::string own = folder.name("contact2d.store"), theirs = folder.name("theirs");
  std::ofstream(theirs) << "a user's file, long enough to be a mark";
  const auto text = [&] {
    std::ifstream file(theirs);
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  const std::string before = text();
  c2d_posix_store store;
  const auto init = [&] { return c2d_posix_store_init(&store, folder.path.c_str()); };
  const auto link = [&](const std::string& name, bool hard) {
    REQUIRE((hard ? ::link(theirs.c_str(), name.c_str()) : symlink(theirs.c_str(), name.c_str())) == 0);
  };
  SUBCASE("a file in the place of its folder") {
    link(own, true);
    CHECK(init() == C2D_POSIX_STORE_FOREIGN);
  }
  SUBCASE("a link in the place of its folder") {
    REQUIRE(mkdir(folder.name("elsewhere").c_str(), 0777) == 0);
    REQUIRE(symlink("elsewhere", own.c_str()) == 0);
    CHECK(init() == C2D_POSIX_STORE_FOREIGN);
  }
  SUBCASE("a folder of its name that has things in it, and no mark") {
    REQUIRE(mkdir(own.c_str(), 0777) == 0);
    link(own + "/tape0.c2d", true);
    CHECK(init() == C2D_POSIX_STORE_FOREIGN);
    CHECK_FALSE(folder.has("contact2d.store/lock"));
  }
  SUBCASE("a lock that says something else, or is a link") {
    REQUIRE(mkdir(own.c_str(), 0777) == 0);
    std::ofstream(own + "/lock") << "mine";
    CHECK(init() == C2D_POSIX_STORE_FOREIGN);
    for (bool hard : {false, true}) {
      REQUIRE(unlink((own + "/lock").c_str()) == 0);
      link(own + "/lock", hard);
      CHECK(init() == C2D_POSIX_STORE_FOREIGN);
    }
  }
  SUBCASE("a tape that is a link, or a folder") {
    c2d_port port = C2D_INIT(c2d_port);
    for (int kind = 0; kind < 3; ++kind) {
      CAPTURE(kind);
      REQUIRE(init() == 0);
      c2d_posix_store_port(&store, &port);
      const std::string tape = own + "/tape1.c2d";
      if (kind < 2)
        link(tape, kind == 1);
      else
        REQUIRE(mkdir(tape.c_str(), 0777) == 0);
      CHECK(port.open(port.context, 1, 1, 100) == C2D_POSIX_STORE_FOREIGN);
      REQUIRE((kind < 2 ? unlink(tape.c_str()) : rmdir(tape.c_str())) == 0);
      CHECK(c2d_posix_store_discard(&store, nullptr) == 0);
    }
  }
  CHECK(text() == before);
  CHECK(c2d_posix_store_done(&store) == 0); // after a failure nothing is held
}

TEST_CASE("the posix store goes on where one was killed while it was made") {
  Folder folder;
  const std::string own = folder.name("contact2d.store");
  const char* const left[] = {nullptr, "", "contact2d blo"}; // no lock yet, an empty one, half of the mark
  for (const char* mark : left) {
    REQUIRE(mkdir(own.c_str(), 0777) == 0);
    if (mark) std::ofstream(own + "/lock") << mark;
    c2d_posix_store store;
    CHECK(c2d_posix_store_init(&store, folder.path.c_str()) == 0);
    CHECK(c2d_posix_store_done(&store) == 0);
    std::ifstream lock(own + "/lock");
    CHECK(std::string(std::istreambuf_iterator<char>(lock), {}) == "contact2d block store\n");
    CHECK(c2d_posix_store_init(&store, folder.path.c_str()) == 0);
    CHECK(c2d_posix_store_discard(&store, nullptr) == 0);
    CHECK_FALSE(folder.has("contact2d.store"));
  }
}

TEST_CASE("the posix store finds a full disk when it opens a tape") {
  Folder folder;
  c2d_posix_store store;
  REQUIRE(c2d_posix_store_init(&store, folder.path.c_str()) == 0);
  c2d_port port = C2D_INIT(c2d_port);
  c2d_posix_store_port(&store, &port);
  struct statvfs disk;
  REQUIRE(statvfs(folder.path.c_str(), &disk) == 0);
  const uint64_t room = static_cast<uint64_t>(disk.f_blocks) * disk.f_frsize;
  const int32_t code = port.open(port.context, 1, 2, room); // more than the whole disk
  CHECK((code == ENOSPC || code == EFBIG));
  struct stat tape;
  REQUIRE(stat(folder.name("contact2d.store/tape1.c2d").c_str(), &tape) == 0);
  CHECK(tape.st_blocks < 2048); // and has not taken the rest of it from others
  CHECK(port.open(port.context, 1, 2, 100) == 0);
  // Of a tape most of which will not be written only what is expected is reserved; all of it may be written.
  for (const int32_t none : {-1, int32_t{C2D_TAPES}}) c2d_posix_store_expect(&store, none, 0);
  c2d_posix_store_expect(&store, 1, 8192);
  REQUIRE(port.open(port.context, 1, room, 2) == 0);
  REQUIRE(stat(folder.name("contact2d.store/tape1.c2d").c_str(), &tape) == 0);
  CHECK(tape.st_blocks * 512 < 1 << 20);
  char two[2] = {'a', 'b'};
  CHECK(port.write(port.context, 1, 100000, two, 2) == 0);
  two[0] = 0;
  CHECK(port.read(port.context, 1, 100000, two, 2) == 0);
  CHECK(two[0] == 'a');
  c2d_posix_store_expect(&store, 1, UINT64_MAX);
  const int32_t all = port.open(port.context, 1, 2, room);
  CHECK((all == ENOSPC || all == EFBIG));
  CHECK(c2d_posix_store_discard(&store, nullptr) == 0);
}

TEST_CASE("a block whose file was cut off is a failed read") {
  Folder folder;
  for (bool posix : {false, true}) {
    c2d_stdio_store stdio_store;
    c2d_posix_store posix_store;
    c2d_port port = C2D_INIT(c2d_port);
    REQUIRE(c2d_posix_store_init(&posix_store, folder.path.c_str()) == 0);
    REQUIRE(c2d_stdio_store_init(&stdio_store, folder.path.c_str()) == 0);
    if (posix)
      c2d_posix_store_port(&posix_store, &port);
    else
      c2d_stdio_store_port(&stdio_store, &port);
    Tapes tapes = {};
    tapes.port = &port;
    Bytes buffer(kBlockHeaderBytes + 100);
    REQUIRE(open_tape(tapes, C2D_TAPE_LOWER, 2, 100) == C2D_OK);
    REQUIRE(write_block(tapes, C2D_TAPE_LOWER, 0, buffer.data(), 100) == C2D_OK);
    REQUIRE(write_block(tapes, C2D_TAPE_LOWER, 1, buffer.data(), 100) == C2D_OK);
    REQUIRE(sync_tape(tapes, C2D_TAPE_LOWER) == C2D_OK);
    REQUIRE(truncate(folder.name(posix ? "contact2d.store/tape1.c2d" : "tape1.c2d").c_str(), 164 + 80) == 0);
    CHECK(read_block(tapes, C2D_TAPE_LOWER, 1, buffer.data(), 100) == C2D_ERR_STORE_READ);
    CHECK(tapes.error.host_code == (posix ? int32_t(C2D_POSIX_STORE_END) : int32_t(C2D_STDIO_STORE_END)));
    CHECK(read_block(tapes, C2D_TAPE_LOWER, 0, buffer.data(), 100) == C2D_OK);
    CHECK(close_all(tapes) == C2D_OK);
    CHECK(c2d_posix_store_done(&posix_store) == 0);
  }
}

TEST_CASE("a folder in use is locked to a second store, here and in another process") {
  Folder folder;
  c2d_posix_store first, second;
  REQUIRE(c2d_posix_store_init(&first, folder.path.c_str()) == 0);
  CHECK(c2d_posix_store_init(&second, folder.path.c_str()) == C2D_POSIX_STORE_LOCKED);
  const pid_t child = fork();
  if (child == 0) {
    c2d_posix_store other;
    _exit(c2d_posix_store_init(&other, folder.path.c_str()) == C2D_POSIX_STORE_LOCKED ? 0 : 1);
  }
  int how = -1;
  REQUIRE(waitpid(child, &how, 0) == child);
  CHECK(how == 0);
  CHECK(c2d_posix_store_done(&first) == 0);
  REQUIRE(c2d_posix_store_init(&second, folder.path.c_str()) == 0);
  CHECK(c2d_posix_store_done(&second) == 0);
  CHECK(c2d_posix_store_done(&second) == 0); // nothing is left to let go of
}

TEST_CASE("the posix store makes its folder, and takes away no more than its own") {
  Folder folder;
  const std::string inner = folder.name("inner");
  c2d_posix_store store;
  REQUIRE(c2d_posix_store_init(&store, inner.c_str()) == 0);
  CHECK(folder.has("inner/contact2d.store/lock"));
  c2d_port port = C2D_INIT(c2d_port);
  c2d_posix_store_port(&store, &port);
  CHECK(port.open(port.context, 3, 1, 100) == 0);
  CHECK(folder.has("inner/contact2d.store/tape3.c2d"));
  std::ofstream(inner + "/other") << "the user's\n";
  std::ofstream(inner + "/tape0.c2d") << "the user's\n";
  CHECK(c2d_posix_store_discard(&store, inner.c_str()) == 0);
  CHECK(folder.has("inner/other")); // what is not the store's stays, and so does the folder
  CHECK(folder.has("inner/tape0.c2d"));
  CHECK(unlink((inner + "/tape0.c2d").c_str()) == 0);
  CHECK_FALSE(folder.has("inner/contact2d.store/lock"));
  CHECK_FALSE(folder.has("inner/contact2d.store/tape3.c2d"));
  CHECK(unlink((inner + "/other").c_str()) == 0);
  REQUIRE(c2d_posix_store_init(&store, inner.c_str()) == 0);
  CHECK(c2d_posix_store_discard(&store, inner.c_str()) == 0);
  CHECK_FALSE(folder.has("inner"));
}

TEST_CASE("blocks beyond 4 GiB have a place of their own") {
  Folder folder;
  c2d_posix_store posix_store;
  REQUIRE(c2d_posix_store_init(&posix_store, folder.path.c_str()) == 0);
  c2d_stdio_store stdio_store;
  REQUIRE(c2d_stdio_store_init(&stdio_store, folder.path.c_str()) == 0);
  for (bool posix : {false, true}) {
    c2d_port port = C2D_INIT(c2d_port);
    if (posix)
      c2d_posix_store_port(&posix_store, &port);
    else
      c2d_stdio_store_port(&stdio_store, &port);
    const uint64_t bytes = 1 << 20, far_block = 5000; // 4.9 GiB, nearly all of it a hole in the file
    unsigned char data[16] = "far away", back[16] = "";
    REQUIRE(port.open(port.context, 1, far_block + 1, bytes) == 0);
    REQUIRE(port.write(port.context, 1, far_block, data, 16) == 0);
    REQUIRE(port.sync(port.context, 1) == 0);
    struct stat info;
    const std::string tape = folder.name(posix ? "contact2d.store/tape1.c2d" : "tape1.c2d");
    REQUIRE(stat(tape.c_str(), &info) == 0);
    REQUIRE(unlink(tape.c_str()) == 0); // so much room is not to outlive a killed test
    CHECK(static_cast<uint64_t>(info.st_size) == far_block * bytes + 16);
    REQUIRE(port.read(port.context, 1, far_block, back, 16) == 0);
    CHECK(std::memcmp(data, back, 16) == 0);
    REQUIRE(port.close(port.context, 1) == 0);
  }
  CHECK(c2d_posix_store_done(&posix_store) == 0);
}

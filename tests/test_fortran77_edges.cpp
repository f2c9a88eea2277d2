// The FORTRAN 77 names at the ends of what they take: arrays overwritten or too short, numbers that INTEGER*4 cannot count,
// calls at the wrong moment, files that fail.
#include "fortran77_calls.hpp"

#include <doctest/doctest.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <unistd.h>

using namespace test;
using c2d::fortran::host_of;

namespace {

struct Why {
  int32_t info[20];
  std::string text;
  explicit Why(void* work) {
    for (int32_t& i : info) i = -9;
    char words[320];
    c2why_(work, info, I{20}, words, I{320});
    text.assign(words, 320);
  }
};

// A path in files, or in an array behind.
struct Sample {
  Odd memory, blocks;
  void* work;
  int32_t error = -1;
  explicit Sample(const std::string& file = "hertz.dat", int32_t words = kWords, size_t odd = 4)
      : memory(8 * static_cast<size_t>(words), odd), blocks(1 << 20, odd), work(memory.at()) {
    REQUIRE(open(work, words) == 0);
    c2core_(work, blocks.at(), I{(1 << 20) / 8}, &error);
    deck(file);
    REQUIRE(error == 0);
  }
  void deck(const std::string& file) {
    const std::string name = paths::root() + "/examples/" + file;
    c2deck_(work, name.data(), I{static_cast<int32_t>(name.size())}, &error);
  }
  void prepare() {
    c2prep_(work, &error);
    REQUIRE(error == 0);
  }
  void begin() {
    prepare();
    c2begn_(work, R{0.3}, I{1}, &error);
    REQUIRE(error == 0);
  }
};

} // namespace

TEST_CASE("fortran77: an array that is overwritten is told from one that is open") {
  Sample sample;
  int32_t error = 0;
  uint64_t mark[2];
  std::memcpy(mark, sample.work, sizeof mark);
  for (const uint64_t place : {uint64_t{80}, UINT64_MAX}) { // where the host cannot stand
    const uint64_t wrong[2] = {mark[0], place};
    std::memcpy(sample.work, wrong, sizeof wrong);
    c2prep_(sample.work, &error);
    CHECK(error == 54);
    c2atch_(sample.work, I{kWords}, kIntegers, kLiteral, sample.blocks.at(), &error);
    CHECK(error == 54);
    c2card_(sample.work, "1", I{1}, I{0}, &error);
    CHECK(error == 54);
    c2solv_(sample.work, c2none_, &error);
    CHECK(error == 54);
  }
  Sample other;
  int32_t isum[21] = {-7};
  double rsum[28] = {-7};
  std::memset(static_cast<char*>(other.work) + host_of(other.work)->solver_at, 0, 64);
  c2summ_(other.work, isum, I{21}, rsum, I{28}, &error);
  CHECK(error == C2D_ERR_ARGUMENT);
  CHECK((isum[0] == -7 && rsum[0] == -7));
  // Check values that are neither 4 nor 8 bytes long.
  const int32_t none[2] = {0, 64};
  c2open_(other.work, I{kWords}, none, kLiteral, &error);
  CHECK(error == 53);
}

TEST_CASE("fortran77: sizes beyond what INTEGER*4 counts") {
  std::vector<double> work(1000);
  int32_t error = open(work.data(), 1000), least = -1, most = -1, blocks = -1, words = -1;
  const auto need = [&](int32_t nodes) {
    const int32_t sizes[] = {1, 2, nodes, 0, nodes, 0, 1};
    least = most = -1;
    c2neds_(work.data(), sizes, I{7}, &least, &most, &error);
  };
  need(1000);
  CHECK((error == 0 && least < most && most < INT32_MAX));
  need(100000); // in core it would take 320 GB, 160 of them that INTEGER*4 can count
  CHECK((error == 0 && least > 2000000 && most == INT32_MAX));
  need(99000000); // the least is more than that
  CHECK((error == C2D_ERR_OVERFLOW && least == -1 && most == -1));
  need(2000000000);
  CHECK((error == C2D_ERR_OVERFLOW && least == -1));
  // Tapes of an array as long as can be (only its head is written).
  REQUIRE(open(work.data(), INT32_MAX) == 0);
  const int32_t sizes[] = {1, 2, 1000000, 0, 1000000, 0, 1};
  c2tnds_(work.data(), sizes, I{7}, I{C2D_TAPE_UPPER}, &blocks, &words, &error);
  CHECK(error == 0);
  CHECK(static_cast<double>(blocks) * words > 0.5 * 2e6 * 2e6); // half of the matrix, at least
  CHECK(static_cast<double>(blocks) * words < 2.0 * 2e6 * 2e6);
}

TEST_CASE("fortran77: the words of C2CORE are told until they do, and one less does not") {
  std::vector<double> memory(kWords), blocks(1 << 17);
  int32_t error = -1, told = 10, rounds = 0, tried = 0;
  const auto prepare = [&](int32_t words) {
    REQUIRE(open(memory.data()) == 0);
    c2core_(memory.data(), blocks.data(), I{words}, &error);
    const std::string name = paths::root() + "/examples/hertz.dat";
    c2deck_(memory.data(), name.data(), I{static_cast<int32_t>(name.size())}, &error);
    REQUIRE(error == 0);
    c2prep_(memory.data(), &error);
    return error;
  };
  for (; prepare(told) == C2D_ERR_STORE_OPEN && rounds < 10; ++rounds) {
    tried = told;
    told = Why(memory.data()).info[12];
    REQUIRE(told > tried);
  }
  CHECK(error == 0);
  CHECK(rounds > 0);
  CHECK(prepare(told - 1) == C2D_ERR_STORE_OPEN);
  CHECK(Why(memory.data()).info[12] == told);
}

TEST_CASE("fortran77: files that cannot be, with C2TAPE") {
  const Folder folder;
  std::vector<double> memory(kWords);
  void* work = memory.data();
  int32_t error = -1;
  const auto tape = [&](const std::string& path) {
    REQUIRE(open(work) == 0);
    c2tape_(work, path.data(), I{static_cast<int32_t>(path.size())}, &error);
    const std::string name = paths::root() + "/examples/hertz.dat";
    c2deck_(work, name.data(), I{static_cast<int32_t>(name.size())}, &error);
    REQUIRE(error == 0);
    c2prep_(work, &error);
  };
  tape(folder / "none");
  CHECK(error == C2D_ERR_STORE_OPEN);
  CHECK(Why(work).info[2] == ENOENT);
  CHECK(Why(work).info[12] == 0); // no number of words helps
  c2clos_(work, &error);
  CHECK(error == 0);
  // A tape's name is taken by a folder that is not empty: C2DROP leaves it, and says so. That a file fails is said first.
  for (const bool fails : {false, true}) {
    tape(folder.path());
    REQUIRE(error == 0);
    if (fails) ::close(::fileno(static_cast<FILE*>(host_of(work)->store.files.file[0])));
    fs::remove(folder / "tape3.c2d");
    fs::create_directories(folder / "tape3.c2d/full");
    c2drop_(work, &error);
    CHECK(error == C2D_ERR_STORE_CLOSE);
    CHECK(folder.names().size() == 1);
    fs::remove_all(folder / "tape3.c2d");
    c2clos_(work, &error);
    CHECK(error == 54);
  }
  // In an array nothing is left to be deleted.
  Sample inside;
  inside.prepare();
  c2drop_(inside.work, &error);
  CHECK(error == 0);
}

namespace {

void* g_work = nullptr; // a STEP routine has no context
int32_t g_error[4], g_case;

void call_step(const int32_t*, const int32_t*, const int32_t*, const int32_t*, const double*, const double*, const int32_t*,
               const double*, const int32_t*, int32_t*, const int32_t*, const double*, const double*) {
  int32_t isum[1] = {-1};
  c2clos_(g_work, &g_error[0]);
  c2drop_(g_work, &g_error[1]);
  c2gint_(g_work, &g_case, &g_error[2]);
  c2summ_(g_work, isum, I{1}, isum, I{0}, &g_error[3]);
  CHECK(isum[0] == C2D_STATE_RUNNING);
}

} // namespace

TEST_CASE("fortran77: STEP may not close what runs, and the run goes on") {
  Sample sample;
  sample.prepare();
  g_work = sample.work, g_case = -7;
  int32_t error = -1;
  c2solv_(sample.work, call_step, &error);
  CHECK(error == 0);
  CHECK((g_error[0] == C2D_ERR_BUSY && g_error[1] == C2D_ERR_BUSY && g_error[2] == C2D_ERR_BUSY && g_error[3] == 0));
  CHECK(g_case == -7);
  c2clos_(sample.work, &error);
  CHECK(error == 0);
}

TEST_CASE("fortran77: of more bodies than two the summary has the first two") {
  Sample sample("three_bodies.dat", 1 << 18);
  int32_t isum[21], of_body[7], error = -1;
  double rsum[28], numbers[8];
  c2summ_(sample.work, isum, I{21}, rsum, I{28}, &error);
  CHECK((error == 0 && isum[4] == 3));
  for (int32_t b = 0; b < 2; ++b) {
    c2bsta_(sample.work, I{b + 1}, of_body, numbers, &error);
    CHECK((error == 0 && isum[10 + b] == of_body[1] && isum[12 + b] == of_body[5]));
  }
}

TEST_CASE("fortran77: a deck that is read and then refused leaves room for another") {
  Sample sample;
  c2clos_(sample.work, &sample.error);
  REQUIRE(open(sample.work) == 0);
  std::vector<std::string> cards = cards_of("hertz.dat");
  const std::string good = padded(cards);
  const I count{static_cast<int32_t>(cards.size())};
  int32_t state = -1;
  cards[21] = "10000000.0    0.7000"; // Poisson's ratio
  c2card_(sample.work, padded(cards).data(), I{80}, count, &sample.error);
  CHECK(sample.error == C2D_ERR_INPUT);
  CHECK(contains(Why(sample.work).text, "0.7"));
  CHECK(Why(sample.work).info[13] == -9); // there are thirteen numbers
  c2stat_(sample.work, &state);
  CHECK(state == C2D_STATE_EMPTY);
  c2card_(sample.work, good.data(), I{80}, count, &sample.error);
  CHECK(sample.error == 0);
}

TEST_CASE("fortran77: numbers at odd addresses are refused as those in their place are") {
  Sample sample, begun;
  begun.begin();
  void *work = sample.work, *running = begun.work;
  Odd odd(8 * 200, 4);
  void* array = odd.at();
  int32_t error = -1, outcome = -1;
  const auto refused = [&](const char* what, c2d_status status = C2D_ERR_ARGUMENT) {
    CHECK(error == status);
    CHECK_MESSAGE(contains(Why(work).text, what), Why(work).text);
  };
  // Nodes, of a solver that is being described.
  REQUIRE(open(work) == 0);
  const int32_t sizes[] = {1, 2, 4, 0, 4, 0, 1, 0, 0, 0, 0, 1, 1, 1, 70};
  c2size_(work, sizes, I{15}, &error);
  REQUIRE(error == 0);
  c2prob_(work, I{0}, I{0}, I{0}, " ", I{1}, &error);
  c2body_(work, I{1}, I{2}, I{4}, I{1}, I{0}, R{1.0}, R{0.3}, &error);
  REQUIRE(error == 0);
  for (int32_t i = 0; i < 200; ++i) put_real(array, 0.125 * i, i);
  c2node_(work, I{1}, I{1}, I{0}, array, I{2}, &error);
  CHECK(error == 0); // none is none
  c2node_(work, I{1}, I{1}, I{4}, array, I{1}, &error);
  refused("stride is 1"); // and not that there are none
  c2node_(work, I{1}, I{1}, I{5}, array, I{2}, &error);
  CHECK(error == C2D_ERR_ARGUMENT); // there are four
  c2node_(work, I{1}, I{INT32_MAX}, I{2}, array, I{2}, &error);
  CHECK(error == C2D_ERR_ARGUMENT);
  c2node_(work, I{1}, I{1}, I{4}, array, I{2}, &error);
  CHECK(error == 0);
  // Load cases: sixty-four are copied.
  c2path_(work, I{1}, array, I{65}, &error);
  CHECK(error == C2D_ERR_LIMIT);
  c2path_(work, I{1}, array, I{64}, &error);
  refused("64");
  c2path_(work, I{1}, array, I{0}, &error);
  CHECK(error == C2D_ERR_ARGUMENT);
  c2advn_(running, array, I{65}, &outcome, &error);
  CHECK(error == C2D_ERR_LIMIT);
  c2next_(running, array, I{65}, array, &error);
  CHECK(error == C2D_ERR_LIMIT);
  // Fields and indicators.
  for (int32_t i = 0; i < 200; ++i) put_real(array, -7.0, i);
  for (const int32_t first : {0, 92, INT32_MAX}) {
    c2get_(running, I{C2D_END_UX}, I{1}, I{first}, I{2}, array, I{1}, &error);
    CHECK(error == C2D_ERR_ARGUMENT);
    c2indi_(running, I{1}, I{first}, I{2}, array, I{C2D_OFF_FIELDS}, &error);
    CHECK(error == C2D_ERR_ARGUMENT);
  }
  c2indi_(running, I{1}, I{1}, I{0}, array, I{C2D_OFF_FIELDS}, &error);
  CHECK(error == 0);
  for (int32_t i = 0; i < 200; ++i) CHECK(real_at(array, i) == -7.0);
}

TEST_CASE("fortran77: points of a set at odd addresses, asked for beyond its end") {
  Sample sample;
  REQUIRE(open(sample.work) == 0);
  std::vector<std::string> cards = cards_of("hertz.dat");
  for (const char* card : {"*POINTS", "GRID 1 0 -2 1 -1 3 3"}) cards.push_back(card);
  int32_t error = -1, total = -1;
  c2card_(sample.work, padded(cards).data(), I{80}, I{static_cast<int32_t>(cards.size())}, &error);
  REQUIRE(error == 0);
  double straight[18];
  c2xpts_(sample.work, I{1}, I{1}, I{9}, straight, I{2}, &total, &error);
  REQUIRE((error == 0 && total == 9));
  for (const size_t odd : {size_t{0}, size_t{4}}) {
    Odd places(8 * 18, odd);
    const auto ask = [&](int32_t first, int32_t count) {
      for (int32_t i = 0; i < 18; ++i) put_real(places.at(), -7.0, i);
      c2xpts_(sample.work, I{1}, I{first}, I{count}, places.at(), I{2}, &total, &error);
    };
    for (const auto& range : {std::pair<int32_t, int32_t>{9, 2}, {INT32_MAX, 2}, {1, -1}, {0, 1}}) {
      const int32_t first = range.first, count = range.second;
      CAPTURE(first);
      ask(first, count);
      CHECK(error == C2D_ERR_ARGUMENT);
      for (int32_t i = 0; i < 18; ++i) CHECK(real_at(places.at(), i) == -7.0);
    }
    ask(8, 2);
    CHECK((error == 0 && total == 9));
    for (int32_t i = 0; i < 4; ++i) CHECK(real_at(places.at(), i) == straight[14 + i]);
  }
}

TEST_CASE("fortran77: C2ATCH of an array without a solver, with too few words, over files, over blocks that changed") {
  std::vector<double> memory(kWords), nothing(1);
  int32_t error = -1, state = -1;
  const auto attach = [&](void* work, int32_t words, void* store) {
    c2atch_(work, I{words}, kIntegers, kLiteral, store, &error);
    return error;
  };
  REQUIRE(open(memory.data()) == 0);
  CHECK(attach(memory.data(), kWords, nothing.data()) == 0); // there is none yet
  c2stat_(memory.data(), &state);
  CHECK(state == C2D_STATE_EMPTY);
  CHECK(attach(memory.data(), 100, nothing.data()) == C2D_ERR_MEMORY);

  Sample sample;
  sample.begin();
  CHECK(attach(sample.work, 1000, sample.blocks.at()) == C2D_ERR_MEMORY); // of which the solver has some hundred
  CHECK(Why(sample.work).info[0] == C2D_ERR_MEMORY);
  CHECK(attach(sample.work, kWords, sample.blocks.at()) == 0);
  c2advn_(sample.work, R{0.5}, I{1}, &state, &error);
  CHECK(error == 0);

  // A copy of the array and of the files, in which it goes on.
  const Folder folder;
  const std::string name = paths::root() + "/examples/hertz.dat", path = folder.path();
  double here[15], there[15];
  REQUIRE(open(memory.data()) == 0);
  c2tape_(memory.data(), path.data(), I{static_cast<int32_t>(path.size())}, &error);
  c2deck_(memory.data(), name.data(), I{static_cast<int32_t>(name.size())}, &error);
  c2prep_(memory.data(), &error);
  c2begn_(memory.data(), R{0.4}, I{1}, &error);
  c2save_(memory.data(), &error);
  REQUIRE(error == 0);
  std::vector<double> copy = memory;
  c2advn_(memory.data(), R{0.7}, I{1}, &state, &error);
  c2get_(memory.data(), I{C2D_TN}, I{0}, I{1}, I{15}, here, I{1}, &error);
  REQUIRE(error == 0);
  c2clos_(memory.data(), &error);
  REQUIRE(attach(copy.data(), kWords, nothing.data()) == 0);
  c2advn_(copy.data(), R{0.7}, I{1}, &state, &error);
  c2get_(copy.data(), I{C2D_TN}, I{0}, I{1}, I{15}, there, I{1}, &error);
  CHECK(error == 0);
  CHECK(std::memcmp(here, there, sizeof here) == 0);
  c2drop_(copy.data(), &error);
  CHECK(error == 0);
}

TEST_CASE("fortran77: six of the warnings are kept, the first ones") {
  Sample sample;
  int32_t error = -1, kept = 0, info[2];
  char text[80];
  c2d::fortran::Host* host = host_of(sample.work);
  const c2d_port port = c2d::fortran::port_of(host);
  host->entries = 0;
  for (int32_t line = 1; line <= 9; ++line) {
    c2d_error entry = c2d::fortran::blank_error();
    entry.status = C2D_WARN_NORMALS, entry.severity = C2D_WARNING, entry.line = line;
    port.log(port.context, &entry);
  }
  for (int32_t i = 1; i <= 9; ++i) {
    int32_t all[13];
    c2note_(sample.work, I{i}, all, I{13}, text, I{80}, &error);
    if (error == 0) CHECK((all[0] == C2D_WARN_NORMALS && all[3] == ++kept));
  }
  CHECK(kept == c2d::fortran::kEntriesKept);
  std::vector<double> closed(100);
  c2note_(closed.data(), I{1}, info, I{2}, text, I{80}, &error);
  CHECK(error == 54);
}

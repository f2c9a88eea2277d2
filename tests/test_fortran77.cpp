// The FORTRAN 77 names, called as a compiler of FORTRAN calls them: arrays at odd addresses, texts padded
// with blanks, everything by reference. What comes out is compared with the C interface.
#include "fortran77_calls.hpp"
#include "host_structs.hpp"
#include "paths.hpp"
#include "shell.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <regex>
#include <set>
#include <tuple>
#include <utility>

using namespace test;

namespace {

const std::string kRoot = paths::root();

std::string message(int32_t code) {
  char text[60];
  c2msg_(&code, text, I{60});
  const std::string all(text, 60);
  return all.substr(0, all.find_last_not_of(' ') + 1);
}

} // namespace

TEST_CASE("fortran77: C2OPEN tells integers and reals of other lengths, whichever end is first") {
  std::vector<double> work(1000, -1.0);
  const std::vector<double> before = work;
  union {
    int32_t narrow[2];
    int64_t wide;
  } error;
  const int64_t words = 1000;
  const int64_t wide[2] = {1987, 64};
  error.wide = -1;
  c2open_(work.data(), &words, wide, kLiteral, &error);
  CHECK(error.wide == 51);                     // all of the caller's 8 bytes
  const int32_t swapped[4] = {0, 1987, 0, 64}; // the same as a machine with the high end first has it
  error.wide = -1;
  c2open_(work.data(), &words, swapped, kLiteral, &error);
  CHECK(error.wide == 51);

  const float shorter[2] = {1987.015625F, 0.0F};
  const long double longer[1] = {1987.015625L};
  const double others[2] = {1987.0, 0.015625}; // the array of 0.1
  for (const void* reals :
       {static_cast<const void*>(shorter), static_cast<const void*>(longer), static_cast<const void*>(others)}) {
    if (sizeof(long double) == sizeof(double) && reals == longer) continue;
    error.narrow[0] = error.narrow[1] = -1;
    c2open_(work.data(), I{1000}, kIntegers, reals, &error);
    CHECK(error.narrow[0] == 52);
    CHECK(error.narrow[1] == -1); // an IERR of 4 bytes has nothing of ours behind it
  }
  const int32_t nonsense[2] = {1987, 63};
  c2open_(work.data(), I{1000}, nonsense, kLiteral, &error);
  CHECK(error.narrow[0] == 53);
  CHECK(error.narrow[1] == -1);
  CHECK(std::memcmp(work.data(), before.data(), 1000 * sizeof(double)) == 0);
  CHECK(open(work.data(), 1000) == 0);
}

TEST_CASE("fortran77: an array that was not opened, was moved, or is too short") {
  Odd memory(8 * kWords, 4), other(8 * kWords, 4);
  int32_t error = 0, state = 0;
  c2prep_(memory.at(), &error);
  CHECK(error == 54);
  c2stat_(memory.at(), &state);
  CHECK(state == -1);
  CHECK(open(memory.at(), 100) == C2D_ERR_MEMORY);
  c2prep_(memory.at(), &error);
  CHECK(error == 54);
  REQUIRE(open(memory.at()) == 0);
  c2prep_(memory.at(), &error);
  CHECK(error == C2D_ERR_STATE); // open, and nothing in it
  c2stat_(memory.at(), &state);
  CHECK(state == C2D_STATE_EMPTY);
  std::memcpy(other.at(), memory.at(), 8 * kWords);
  c2prep_(other.at(), &error);
  CHECK(error == 54);
  c2clos_(memory.at(), &error);
  CHECK(error == 0);
  c2clos_(memory.at(), &error);
  CHECK(error == 54);
  CHECK(message(54).substr(0, 6) == "C2OPEN");
  for (int32_t code = -3; code < 300; ++code) CHECK(message(code) != "");
  CHECK(message(C2D_ERR_LIMIT) == c2d_message(C2D_ERR_LIMIT));
}

namespace {

struct Trace {
  std::vector<double> numbers;
};
Trace* g_trace = nullptr; // a FORTRAN step routine has no context either

void trace_step(const int32_t* kind, const int32_t* imu, const int32_t* istep, const int32_t* iout, const double* fmu,
                const double* factor, const int32_t* npairs, const double* table, const int32_t* ldt, int32_t*,
                const int32_t* ncases, const double* works, const double* energy) {
  for (const double x : {1.0 * *kind, 1.0 * *imu, 1.0 * *istep, 1.0 * *iout, *fmu, *factor}) g_trace->numbers.push_back(x);
  g_trace->numbers.insert(g_trace->numbers.end(), factor, factor + *ncases);
  g_trace->numbers.insert(g_trace->numbers.end(), works, works + *ncases);
  g_trace->numbers.insert(g_trace->numbers.end(), energy, energy + 4);
  for (int32_t p = 0; p < *npairs; ++p)
    for (int32_t c = 0; c < C2D_PAIR_FIELDS; ++c) g_trace->numbers.push_back(table[p * *ldt + c]);
}
void stop_step(const int32_t*, const int32_t*, const int32_t* istep, const int32_t*, const double*, const double*,
               const int32_t*, const double*, const int32_t*, int32_t* istop, const int32_t*, const double*, const double*) {
  if (*istep == 3) *istop = 77;
}

int32_t keep_step(void* context, const c2d_step* s) {
  Trace& trace = *static_cast<Trace*>(context);
  for (const double x : {1.0 * s->kind, 1.0 * s->coefficient, 1.0 * s->step, 1.0 * s->outcome, s->mu, s->load})
    trace.numbers.push_back(x);
  trace.numbers.insert(trace.numbers.end(), s->loads, s->loads + s->cases);
  trace.numbers.insert(trace.numbers.end(), s->work_by_case, s->work_by_case + s->cases);
  for (const double x : {s->work, s->dissipated, s->elastic, s->energy_defect}) trace.numbers.push_back(x);
  for (int32_t p = 0; p < s->pairs; ++p)
    for (int32_t c = 0; c < C2D_PAIR_FIELDS; ++c) trace.numbers.push_back(s->table[p * s->stride + c]);
  return 0;
}

int32_t next_line(void* context, char* text, int32_t size) {
  auto& in = *static_cast<std::istringstream*>(context);
  std::string card;
  if (!std::getline(in, card)) return -1;
  text[card.copy(text, static_cast<size_t>(size) - 1)] = '\0';
  return static_cast<int32_t>(card.size());
}

// A solver of the C interface with a deck, in as many bytes as the FORTRAN one has.
struct Desktop {
  std::vector<unsigned char> memory, blocks = std::vector<unsigned char>(1 << 20);
  c2d_memory_store store;
  c2d_solver* solver = nullptr;
  Desktop(const std::string& file, size_t bytes) : memory(bytes) {
    host::Limits limits;
    c2d_port port = C2D_INIT(c2d_port);
    c2d_memory_store_init(&store, blocks.data(), blocks.size());
    c2d_memory_store_port(&store, &port);
    const std::string deck = read_file(kRoot + "/examples/" + file);
    std::istringstream first(deck), second(deck);
    REQUIRE(c2d_scan_deck(next_line, &first, &limits, nullptr) == C2D_OK);
    REQUIRE(c2d_create(&solver, memory.data(), memory.size(), &limits, &port, nullptr) == C2D_OK);
    REQUIRE(c2d_read_deck(solver, next_line, &second) == C2D_OK);
    REQUIRE(c2d_prepare(solver) == C2D_OK);
  }
};

} // namespace

TEST_CASE("fortran77: a deck at every odd address gives the bits of the C interface") {
  Desktop desktop("hertz.dat", 8 * kWords);
  Trace expected, found;
  REQUIRE(c2d_run(desktop.solver, keep_step, &expected) == C2D_OK);
  const std::string cards = padded(cards_of("hertz.dat"));
  const I count{static_cast<int32_t>(cards.size() / 80)};
  for (const size_t odd : {size_t{0}, size_t{4}, size_t{33}}) {
    Odd memory(8 * kWords, odd), store(1 << 20, odd), numbers(8 * 1000, odd), integer(4, odd);
    void* work = memory.at();
    int32_t error = open(work);
    c2core_(work, store.at(), I{(1 << 20) / 8}, &error);
    REQUIRE(error == 0);
    c2card_(work, cards.data(), I{80}, count, integer.at());
    REQUIRE(integer_at(integer.at()) == 0);
    c2prep_(work, &error);
    REQUIRE(error == 0);
    found.numbers.clear();
    g_trace = &found;
    c2solv_(work, trace_step, &error);
    CHECK(error == 0);
    CHECK(found.numbers == expected.numbers);

    // Fields of the bodies, with a stride, at the same odd address.
    for (const int32_t field : {static_cast<int32_t>(C2D_END_UX), static_cast<int32_t>(C2D_END_TY)}) {
      std::vector<double> straight(92);
      REQUIRE(c2d_get(desktop.solver, field, 1, 1, 92, straight.data(), 1) == C2D_OK);
      c2get_(work, I{field}, I{1}, I{1}, I{92}, numbers.at(), I{3}, &error);
      REQUIRE(error == 0);
      for (int32_t i = 0; i < 92; ++i) CHECK(real_at(numbers.at(), 3 * i) == straight[static_cast<size_t>(i)]);
    }
    const double points[6] = {0.5, 4.0, 0.0, 1.0, 6.0, 0.0};
    double inside[2 * C2D_POINT_FIELDS];
    REQUIRE(c2d_interior(desktop.solver, 2, 2, points, 3, inside, C2D_POINT_FIELDS) == C2D_OK);
    c2intr_(work, I{2}, I{2}, points, I{3}, numbers.at(), I{12}, &error);
    REQUIRE(error == 0);
    for (int32_t k = 0; k < 2 * C2D_POINT_FIELDS; ++k) CHECK(real_at(numbers.at(), k + k / C2D_POINT_FIELDS) == inside[k]);
    std::vector<double> off(3 * C2D_OFF_FIELDS);
    REQUIRE(c2d_indicators(desktop.solver, 1, 7, 3, off.data(), C2D_OFF_FIELDS) == C2D_OK);
    c2indi_(work, I{1}, I{7}, I{3}, numbers.at(), I{10}, &error);
    REQUIRE(error == 0);
    for (int32_t k = 0; k < 3 * C2D_OFF_FIELDS; ++k)
      CHECK(real_at(numbers.at(), k + k / C2D_OFF_FIELDS) == off[static_cast<size_t>(k)]);
    c2indi_(work, I{1}, I{7}, I{INT32_MAX}, numbers.at(), I{10}, &error);
    CHECK(error == C2D_ERR_ARGUMENT);
    c2indi_(work, I{1}, I{7}, I{3}, numbers.at(), I{8}, &error);
    CHECK(error == C2D_ERR_ARGUMENT);
    c2clos_(work, &error);
    CHECK(error == 0);
  }
}

TEST_CASE("fortran77: a path of the caller's own, events, summary, lists and zones as in C") {
  Desktop desktop("hertz.dat", 8 * kWords);
  Odd memory(8 * kWords, 4), store(1 << 20, 4), real(8 * 40, 4);
  void* work = memory.at();
  int32_t error = open(work), outcome = -1, increments = 0, ours = 0, i1[6], i2[6], a = 0, b = 0;
  c2core_(work, store.at(), I{(1 << 20) / 8}, &error);
  const std::string name = kRoot + "/examples/hertz.dat   ";
  c2deck_(work, name.data(), I{static_cast<int32_t>(name.size())}, &error);
  REQUIRE(error == 0);
  c2prep_(work, &error);
  REQUIRE(error == 0);
  c2begn_(work, R{0.4}, I{1}, &error);
  REQUIRE(error == 0);
  const double mu = 0.4, load = 0.7, up = 1.0;
  REQUIRE(c2d_begin(desktop.solver, &mu, 1) == C2D_OK);
  REQUIRE(c2d_advance(desktop.solver, &load, 1, &ours) == C2D_OK);
  put_real(real.at(), load);
  c2advn_(work, real.at(), I{1}, &outcome, &error);
  CHECK(error == 0);
  CHECK(outcome == ours);
  double step = 0;
  REQUIRE(c2d_next_event(desktop.solver, &up, 1, &step) == C2D_OK);
  c2next_(work, R{1.0}, I{1}, real.at(), &error);
  CHECK(error == 0);
  CHECK(real_at(real.at()) == step);

  host::Summary summary;
  REQUIRE(host::get_summary(desktop.solver, summary) == C2D_OK);
  int32_t isum[22];
  isum[20] = -7;
  c2summ_(work, isum, I{20}, real.at(), I{28}, &error);
  CHECK(error == 0);
  CHECK(isum[0] == C2D_STATE_RUNNING);
  CHECK(isum[6] == summary.pairs);
  CHECK(isum[15] == summary.body[1].unknowns);
  CHECK(isum[17] == summary.paths);
  CHECK(isum[19] == summary.warnings);
  CHECK(isum[20] == -7); // only as many as asked for
  CHECK(real_at(real.at(), 0) == summary.load);
  CHECK(real_at(real.at(), 12) == summary.tension_ratio);
  CHECK(real_at(real.at(), 14) == summary.body[0].applied[1]);
  CHECK(real_at(real.at(), 24) == summary.body[1].contact[2]);

  c2d_zone_state zone_state = C2D_INIT(c2d_zone_state);
  REQUIRE(c2d_get_zone_state(desktop.solver, 1, &zone_state) == C2D_OK);
  c2zsta_(work, I{1}, i1, real.at(), &error);
  CHECK(error == 0);
  CHECK(i1[1] == zone_state.stick);
  CHECK(real_at(real.at(), 3) == zone_state.approach);
  CHECK(real_at(real.at(), 7) == zone_state.length);
  REQUIRE(host::get_summary(desktop.solver, summary) == C2D_OK); // forces are known by now

  c2gpth_(work, I{14}, &increments, real.at(), I{1}, &error);
  CHECK(increments == 2);
  CHECK(real_at(real.at()) == 1.03);
  c2gmu_(work, I{0}, I{2}, real.at(), &error);
  CHECK(real_at(real.at()) == 0.3);
  c2gmu_(work, I{1}, I{1}, real.at(), &error);
  CHECK(real_at(real.at()) == 0.4);
  c2gzon_(work, I{1}, &a, &b, i1, i2, &error);
  CHECK((a == C2D_ZONE_MATCHING && b == 15));
  CHECK((i1[0] == 1 && i1[1] == 24 && i1[2] == 37 && i1[3] == 14 && i1[4] == 24 && i1[5] == 38)); // as on the cards
  CHECK((i2[0] == 2 && i2[1] == 48 && i2[2] == 35 && i2[3] == 14 && i2[4] == 49 && i2[5] == 35));
  int32_t sizes_of_body[7];
  double numbers_of_body[8];
  c2bsta_(work, I{2}, sizes_of_body, numbers_of_body, &error);
  CHECK((error == 0 && sizes_of_body[6] == summary.body[1].unknowns));
  CHECK(numbers_of_body[7] == summary.body[1].contact[2]);
  c2bsta_(work, I{3}, sizes_of_body, numbers_of_body, &error);
  CHECK(error == C2D_ERR_ARGUMENT);
  c2d_body_state body_state = C2D_INIT(c2d_body_state);
  REQUIRE(c2d_get_body_state(desktop.solver, 2, &body_state) == C2D_OK);
  double state_of_body[12] = {};
  state_of_body[11] = -7;
  a = -1;
  c2bnow_(work, I{2}, &a, state_of_body, &error);
  CHECK((error == 0 && a == 0));
  for (int i = 0; i < 3; ++i) CHECK(state_of_body[i] == body_state.contact[i]);
  CHECK(state_of_body[1] != 0);
  CHECK(state_of_body[11] == -7); // eleven numbers
  c2greg_(work, I{1}, I{1}, &a, &b, &error);
  CHECK((a == 1 && b == 46));
  int32_t codes[4];
  double values[4];
  REQUIRE(c2d_get_condition(desktop.solver, 1, 8, 1, 1, codes, values) == C2D_OK);
  c2gcon_(work, I{1}, I{8}, I{1}, I{1}, i1, real.at(), &error);
  CHECK(std::memcmp(i1, codes, sizeof codes) == 0);
  c2gpld_(work, I{1}, &a, &b, real.at(), real.at(), &error);
  CHECK(error == C2D_ERR_ARGUMENT); // the deck has none

  c2solv_(work, stop_step, &error);
  CHECK(error == C2D_ERR_CALLBACK);
  int32_t info[13];
  char text[40];
  c2why_(work, info, I{13}, text, I{40});
  CHECK(info[0] == C2D_ERR_CALLBACK);
  CHECK(info[2] == 77);
  c2solv_(work, c2none_, &error);
  CHECK(error == 0);
  c2clos_(work, &error);
}

TEST_CASE("fortran77: what broke the solver is told, and arrays at odd addresses are left alone by a refused call") {
  Odd memory(8 * kWords, 4), store(1 << 20, 4), array(8 * 200, 4);
  void* work = memory.at();
  int32_t error = open(work), info[13];
  char text[60];
  const std::string cards = padded(cards_of("hertz.dat"));
  c2core_(work, store.at(), I{10}, &error);
  c2card_(work, cards.data(), I{80}, I{static_cast<int32_t>(cards.size() / 80)}, &error);
  REQUIRE(error == 0);
  c2prep_(work, &error);
  REQUIRE(error == C2D_ERR_STORE_OPEN); // ten words are no store
  c2prep_(work, &error);
  CHECK(error == C2D_ERR_STATE);
  c2why_(work, info, I{13}, text, I{60});
  CHECK(info[0] == C2D_ERR_STORE_OPEN);
  c2clos_(work, &error);

  REQUIRE(open(work) == 0);
  c2core_(work, store.at(), I{(1 << 20) / 8}, &error);
  c2card_(work, cards.data(), I{80}, I{static_cast<int32_t>(cards.size() / 80)}, &error);
  c2prep_(work, &error);
  c2begn_(work, R{0.3}, I{1}, &error);
  REQUIRE(error == 0);
  for (int32_t i = 0; i < 200; ++i) put_real(array.at(), -7.0, i);
  const auto refused = [&](const char* what) {
    c2why_(work, info, I{13}, text, I{60});
    CHECK_MESSAGE(std::string(text, 60).find(what) != std::string::npos, std::string(text, 60));
    CHECK(error == C2D_ERR_ARGUMENT);
    for (int32_t i = 0; i < 200; ++i) CHECK(real_at(array.at(), i) == -7.0);
  };
  c2get_(work, I{C2D_END_UX}, I{1}, I{1}, I{100}, array.at(), I{1}, &error); // of 92: the first 64 would do
  refused("first is 100, expected 1 to 92");
  for (int32_t stride : {0, -1}) {
    c2get_(work, I{C2D_END_UX}, I{1}, I{1}, I{10}, array.at(), I{stride}, &error);
    refused("stride is");
  }
  Odd places(8 * 4, 4);
  const double nan = std::nan(""), points[4] = {0.5, 4.0, 0.5, nan};
  for (int32_t i = 0; i < 4; ++i) put_real(places.at(), points[i], i);
  c2intr_(work, I{0}, I{2}, places.at(), I{2}, array.at(), I{11}, &error);
  refused("a coordinate in xy is nan");
  c2intr_(work, I{0}, I{1}, places.at(), I{1}, array.at(), I{11}, &error);
  refused("xy_stride is 1");
  c2intr_(work, I{0}, I{1}, places.at(), I{2}, array.at(), I{10}, &error);
  refused("out_stride is 10");
  c2clos_(work, &error);
}

TEST_CASE("fortran77: faults of a deck, words that would do, names") {
  Odd memory(8 * kWords, 4);
  void* work = memory.at();
  int32_t error = open(work), info[13], least = 0, most = 0;
  char text[320];
  std::vector<std::string> cards = cards_of("hertz.dat");
  cards[28] = "   16  5.00x0000 0.0000000"; // two faults
  cards[29] = "   18  4.00y0000 0.0000000";
  const std::string bad = padded(cards);
  c2card_(work, bad.data(), I{80}, I{static_cast<int32_t>(cards.size())}, &error);
  CHECK(error == C2D_ERR_INPUT);
  c2why_(work, info, I{13}, text, I{320});
  CHECK(info[0] == C2D_ERR_INPUT);
  CHECK(info[3] == 29);
  CHECK(info[4] == 7);
  CHECK(contains(std::string(text, 320), "5.00x0000"));

  const std::string name = kRoot + "/examples/hertz.dat", none = "/nowhere/at/all";
  c2deck_(work, none.data(), I{static_cast<int32_t>(none.size())}, &error);
  CHECK(error == C2D_ERR_READ);
  c2why_(work, info, I{13}, text, I{320});
  CHECK(info[2] == ENOENT);
  c2deck_(work, "   ", I{3}, &error);
  CHECK(error == 55);

  // Exactly the words that are said to do, and one less.
  c2need_(work, name.data(), I{static_cast<int32_t>(name.size())}, &least, &most, &error);
  CHECK(error == 0);
  CHECK(least < most);
  // And of the tapes: those of the array as it was opened, or a word why not.
  int32_t blocks = -1, block_words = -1;
  REQUIRE(open(work, least) == 0);
  for (int32_t tape = 0; tape < C2D_TAPES; ++tape) {
    blocks = block_words = -1;
    c2tned_(work, name.data(), I{static_cast<int32_t>(name.size())}, I{tape}, &blocks, &block_words, &error);
    CHECK(error == 0);
    CHECK((blocks > 0 && block_words > 0));
  }
  blocks = -1;
  c2tned_(work, name.data(), I{static_cast<int32_t>(name.size())}, I{4}, &blocks, &block_words, &error);
  CHECK((error == C2D_ERR_ARGUMENT && blocks == -1));
  c2why_(work, info, I{13}, text, I{320});
  CHECK(contains(std::string(text, 320), "tape is 4, expected 0 to 3"));
  const int32_t none_at_all[1] = {0};
  c2tnds_(work, none_at_all, I{1}, I{0}, &blocks, &block_words, &error);
  CHECK((error == C2D_ERR_ARGUMENT && blocks == -1));
  c2why_(work, info, I{13}, text, I{320});
  CHECK(contains(std::string(text, 320), "c2d_limits.bodies is 0"));
  c2neds_(work, none_at_all, I{1}, &blocks, &block_words, &error);
  c2why_(work, info, I{13}, text, I{320});
  CHECK(contains(std::string(text, 320), "c2d_limits.bodies is 0"));
  // Three bodies: points of each, elements of each, curves of each, then the rest.
  const int32_t three[] = {3, 2, 8, 9, 10, 8, 9, 10, 1, 2, 3, 2, 4, 3};
  host::Limits limits;
  limits.bodies = three[0], limits.function_nodes = three[1];
  for (int32_t b = 0; b < 3; ++b) limits.body[b] = {three[2 + b], three[5 + b], three[8 + b], 0};
  limits.zones = three[11], limits.pairs = three[12], limits.contact_elements = three[13];
  uint64_t need = 0;
  REQUIRE(c2d_memory_need(&limits, &need, nullptr, nullptr) == C2D_OK);
  int32_t of_three = 0, all_of_three = 0;
  c2neds_(work, three, I{14}, &of_three, &all_of_three, &error);
  CHECK(error == 0);
  CHECK(static_cast<uint64_t>(of_three) == (need + c2d::fortran::kHostSlack + 7) / 8);
  const int32_t many[1] = {c2d::fortran::kMostBodies + 1};
  c2neds_(work, many, I{1}, &blocks, &block_words, &error);
  CHECK((error == C2D_ERR_ARGUMENT && blocks == -1));

  for (const int32_t words : {least - 1, least}) {
    REQUIRE(open(work, words) == 0);
    c2deck_(work, name.data(), I{static_cast<int32_t>(name.size())}, &error);
    c2why_(work, info, I{13}, text, I{320});
    if (words == least) CHECK(error == 0);
    if (words < least - 16) CHECK(error == C2D_ERR_MEMORY); // the slack of the address may do without
    if (error != 0) CHECK(info[12] == least);
  }
  // Warnings are kept.
  REQUIRE(open(work) == 0);
  const std::string whole = padded(cards_of("hertz.dat"));
  c2card_(work, whole.data(), I{80}, I{static_cast<int32_t>(whole.size() / 80)}, &error);
  REQUIRE(error == 0);
  c2note_(work, I{1}, info, I{2}, text, I{320}, &error);
  CHECK(error == 0);
  CHECK(info[0] == C2D_WARN_NORMALS);
  CHECK(info[1] == C2D_WARNING);
  c2note_(work, I{7}, info, I{2}, text, I{320}, &error);
  CHECK(error == C2D_ERR_ARGUMENT);
  // Without a store there is nothing to prepare with; with one that is too short the words are told.
  c2prep_(work, &error);
  CHECK(error != 0);
  std::vector<double> small(100);
  REQUIRE(open(work) == 0);
  c2core_(work, small.data(), I{100}, &error);
  c2card_(work, whole.data(), I{80}, I{static_cast<int32_t>(whole.size() / 80)}, &error);
  c2prep_(work, &error);
  CHECK(error == C2D_ERR_STORE_OPEN);
  c2why_(work, info, I{13}, text, I{320});
  CHECK(info[12] > 100);
}

TEST_CASE("fortran77: blocks in files, which C2DROP deletes and C2CLOS leaves") {
  const Folder folder;
  Odd memory(8 * kWords, 4);
  void* work = memory.at();
  int32_t error = 0;
  const std::string name = kRoot + "/examples/hertz.dat", path = folder.path();
  for (const bool drop : {false, true}) {
    REQUIRE(open(work) == 0);
    c2tape_(work, path.data(), I{static_cast<int32_t>(path.size())}, &error);
    REQUIRE(error == 0);
    c2deck_(work, name.data(), I{static_cast<int32_t>(name.size())}, &error);
    c2prep_(work, &error);
    REQUIRE(error == 0);
    const size_t files = folder.names().size();
    CHECK(files > 2);
    drop ? c2drop_(work, &error) : c2clos_(work, &error);
    CHECK(error == 0);
    CHECK(folder.names().size() == (drop ? 0U : files));
  }
}

TEST_CASE("fortran77: a workspace moved with its blocks goes on with the same bits") {
  const std::string name = kRoot + "/examples/hertz.dat";
  Odd memory(8 * kWords, 4), store(1 << 20, 4), moved(8 * kWords, 49), moved_store(1 << 20, 8);
  int32_t error = open(memory.at()), outcome = 0;
  c2core_(memory.at(), store.at(), I{(1 << 20) / 8}, &error);
  c2deck_(memory.at(), name.data(), I{static_cast<int32_t>(name.size())}, &error);
  c2prep_(memory.at(), &error);
  c2begn_(memory.at(), R{0.4}, I{1}, &error);
  c2advn_(memory.at(), R{0.5}, I{1}, &outcome, &error);
  REQUIRE(error == 0);
  std::memcpy(moved.at(), memory.at(), 8 * kWords);
  std::memcpy(moved_store.at(), store.at(), 1 << 20);
  double here[15], there[15];
  c2advn_(memory.at(), R{1.0}, I{1}, &outcome, &error);
  c2get_(memory.at(), I{C2D_END_UY}, I{2}, I{1}, I{15}, here, I{1}, &error);
  REQUIRE(error == 0);
  std::memset(memory.at(), 255, 8 * kWords); // nothing may be left there
  std::memset(store.at(), 255, 1 << 20);
  c2advn_(moved.at(), R{1.0}, I{1}, &outcome, &error);
  CHECK(error == 54); // not attached
  const double single[2] = {0, 0};
  c2atch_(moved.at(), I{kWords}, kIntegers, single, moved_store.at(), &error);
  CHECK(error == 52);
  c2atch_(moved.at(), I{kWords}, kIntegers, kLiteral, moved_store.at(), &error);
  REQUIRE(error == 0);
  c2advn_(moved.at(), R{1.0}, I{1}, &outcome, &error);
  c2get_(moved.at(), I{C2D_END_UY}, I{2}, I{1}, I{15}, there, I{1}, &error);
  CHECK(error == 0);
  CHECK(std::memcmp(here, there, sizeof here) == 0);
  c2clos_(moved.at(), &error);
  CHECK(error == 0);
}

TEST_CASE("fortran77: what was saved is restored by another workspace over the same files") {
  const Folder folder;
  const std::string name = kRoot + "/examples/hertz.dat", path = folder.path();
  Odd first(8 * kWords, 4), second(8 * kWords, 20);
  double before[15], after[15];
  for (const bool restored : {false, true}) {
    void* work = restored ? second.at() : first.at();
    int32_t error = open(work), outcome = 0;
    c2tape_(work, path.data(), I{static_cast<int32_t>(path.size())}, &error);
    c2deck_(work, name.data(), I{static_cast<int32_t>(name.size())}, &error);
    REQUIRE(error == 0);
    if (restored) {
      c2rest_(work, &error);
      REQUIRE(error == 0);
    } else {
      c2prep_(work, &error);
      c2begn_(work, R{0.4}, I{1}, &error);
      c2advn_(work, R{0.6}, I{1}, &outcome, &error);
      c2save_(work, &error);
      REQUIRE(error == 0);
    }
    c2get_(work, I{C2D_TN}, I{0}, I{1}, I{15}, restored ? after : before, I{1}, &error);
    CHECK(error == 0);
    c2clos_(work, &error);
  }
  CHECK(std::memcmp(before, after, sizeof before) == 0);
  CHECK(before[14] > 100.0);
}

TEST_CASE("fortran77: a model by calls is checked as in C, and every call reaches its function") {
  Odd memory(8 * kWords, 4), real(8 * 40, 4);
  void* work = memory.at();
  REQUIRE(open(work) == 0);
  int32_t error = 0, least = 0, most = 0, state = 0;
  //                    bodies  nodes points  elements curves zones pairs ce loads mu paths cases
  const int32_t sizes[] = {2, 2, 16, 16, 16, 16, 1, 1, 1, 5, 4, 1, 2, 2, 2};
  c2neds_(work, sizes, I{15}, &least, &most, &error);
  CHECK(error == 0);
  CHECK(least < most);
  c2size_(work, sizes, I{99}, &error);
  CHECK(error == C2D_ERR_ARGUMENT);
  c2size_(work, sizes, I{15}, &error);
  REQUIRE(error == 0);
  c2size_(work, sizes, I{15}, &error);
  CHECK(error == C2D_ERR_STATE);
  const auto ok = [&error](int line) { CHECK_MESSAGE(error == 0, "line " << line); };
  c2opts_(work, I{0}, I{0}, I{0}, I{0}, &error), ok(__LINE__);
  c2prob_(work, I{0}, I{1}, I{0}, "blocks    ", I{10}, &error), ok(__LINE__);
  c2line_(work, I{12}, I{1}, I{3}, &error), ok(__LINE__);
  const int32_t fix_x[4] = {1, 0, 0, 1}, fix_y[4] = {0, 1, 1, 0};
  for (int32_t body = 1; body <= 2; ++body) {
    c2body_(work, I{body}, I{2}, I{16}, I{1}, I{0}, R{1000.0}, R{0.3}, &error), ok(__LINE__);
    c2regn_(work, I{body}, I{1}, I{16}, &error), ok(__LINE__);
    for (int32_t i = 0; i < 4; ++i) {
      const double s = 0.25 * i, y = body - 2;
      const double x[4] = {s, 1, 1 - s, 0}, ys[4] = {y, y + s, y + 1, y + 1 - s};
      for (int32_t side = 0; side < 4; ++side) {
        put_real(real.at(), x[side]), put_real(real.at(), ys[side], 1);
        c2node_(work, I{body}, I{4 * side + i + 1}, I{1}, real.at(), I{2}, &error), ok(__LINE__);
      }
    }
    for (int32_t k = 0; k < 5; ++k) put_real(real.at(), 0.0, k);
    for (int32_t e = 1; e <= 4; ++e)
      for (int32_t local = 1; local <= 2; ++local) {
        c2cond_(work, I{body}, I{12 + e}, I{local}, I{1}, fix_x, real.at(), &error), ok(__LINE__);
        c2cond_(work, I{body}, I{body == 1 ? e : 8 + e}, I{local}, I{1}, fix_y, real.at(), &error), ok(__LINE__);
      }
  }
  put_real(real.at(), -0.01, 3);
  for (int32_t e = 9; e <= 12; ++e) c2case_(work, I{2}, I{e}, I{0}, I{2}, real.at(), &error), ok(__LINE__);
  c2load_(work, I{1}, I{1}, R{0.5}, R{-0.5}, R{0.0}, R{-1.0}, &error), ok(__LINE__);
  const double weight[2] = {0.0, -2.0}, still[3] = {0.0, 0.0, 0.0};
  c2bfor_(work, I{1}, I{1}, weight, R{0.0}, still, &error), ok(__LINE__);
  const int32_t side1[6] = {1, 9, 12, 4, 9, 13}, side2[6] = {2, 4, 1, 0, 5, 1};
  c2zone_(work, I{0}, I{5}, side1, side2, &error), ok(__LINE__);
  c2mu_(work, R{0.0}, &error), ok(__LINE__);
  c2mu_(work, R{0.2}, &error), ok(__LINE__);
  c2muz_(work, I{1}, I{2}, R{0.1}, &error), ok(__LINE__);
  const double factors[2] = {0.25, 1.0};
  c2path_(work, I{1}, factors, I{2}, &error), ok(__LINE__);
  c2clrp_(work, &error), ok(__LINE__);
  c2path_(work, I{3}, factors, I{2}, &error), ok(__LINE__);
  c2unit_(work, "mm  ", I{4}, "N", I{1}, &error), ok(__LINE__);
  c2name_(work, I{C2D_NAME_BODY}, I{2}, "bolt (M8)     ", I{14}, &error), ok(__LINE__);
  c2name_(work, I{C2D_NAME_BODY}, I{1}, "12345678901234567890123456789012        ", I{40}, &error);
  CHECK(error == C2D_ERR_ARGUMENT); // too long
  c2name_(work, I{C2D_NAME_BODY}, I{3}, "bolt", I{4}, &error);
  CHECK(error == C2D_ERR_ARGUMENT); // no such body
  char name[12];
  c2gnam_(work, I{C2D_NAME_BODY}, I{2}, name, I{12}, &error), ok(__LINE__);
  CHECK(std::string(name, 12) == "bolt (M8)   ");
  c2gnam_(work, I{C2D_NAME_BODY}, I{1}, name, I{3}, &error), ok(__LINE__);
  CHECK(std::string(name, 12) == "   t (M8)   ");
  c2intf_(work, I{3}, &error);
  CHECK(error == C2D_ERR_ARGUMENT); // no such case
  c2symm_(work, I{5}, R{0.0}, &error);
  CHECK(error == C2D_ERR_ARGUMENT); // no such axis
  c2zone_(work, I{1}, I{0}, side1, side2, &error);
  CHECK(error != 0); // the limits have no room for one
  c2rigd_(work, I{1}, I{7}, still, still, &error);
  CHECK(error == C2D_ERR_ARGUMENT); // no such case
  c2rgld_(work, I{1}, I{7}, side1, still, still, &error);
  CHECK(error == C2D_ERR_ARGUMENT); // no such case
  c2tie_(work, I{2}, &error);
  CHECK(error == C2D_ERR_ARGUMENT); // no such zone
  c2done_(work, &error);
  CHECK(error == 0);
  c2stat_(work, &state);
  CHECK(state == C2D_STATE_MODEL);

  int32_t body = 0, increments = 0, load_case = 0, rigid = -1, codes[4];
  double xy[2], force[2];
  c2gpld_(work, I{1}, &body, &load_case, xy, force, &error);
  CHECK((body == 1 && load_case == 1 && xy[1] == -0.5 && force[1] == -1.0));
  c2gcon_(work, I{2}, I{10}, I{1}, I{2}, codes, real.at(), &error);
  CHECK((codes[3] == 0 && real_at(real.at(), 3) == -0.01));
  double turning = -1.0;
  c2gbfo_(work, I{1}, I{1}, force, &turning, xy, &error);
  CHECK((error == 0 && force[1] == -2.0 && turning == 0.0));
  c2grig_(work, I{1}, I{1}, &rigid, real.at(), xy, &error);
  CHECK((error == 0 && rigid == 0));
  c2gint_(work, &load_case, &error);
  CHECK((error == 0 && load_case == 0));
  c2gpth_(work, I{1}, &increments, real.at(), I{2}, &error);
  CHECK((increments == 3 && real_at(real.at(), 1) == 1.0));
  c2gmu_(work, I{1}, I{2}, real.at(), &error);
  CHECK(real_at(real.at()) == 0.1);
  c2canc_(work, &error);
  CHECK(error == 0);
  c2done_(work, &error);
  CHECK(error == C2D_ERR_STATE);
}

TEST_CASE("fortran77: other loads through kept factors, as in C and as from the beginning") {
  // With the right side pulled twice as hard everything doubles; numbers stand at odd addresses.
  Odd memory(8 * kWords, 4), store(1 << 20, 4), real(8 * 4, 4);
  void* work = memory.at();
  int32_t error = open(work);
  const auto ok = [&error](int line) { CHECK_MESSAGE(error == 0, "line " << line); };
  c2core_(work, store.at(), I{(1 << 20) / 8}, &error), ok(__LINE__);
  c2keep_(work, I{2}, &error); // kept for a solver to come, which refuses it
  const std::string cards = padded(cards_of("plate_tension.dat"));
  const I count{static_cast<int32_t>(cards.size() / 80)};
  c2card_(work, cards.data(), I{80}, count, &error);
  CHECK(error == C2D_ERR_ARGUMENT);
  error = open(work);
  c2core_(work, store.at(), I{(1 << 20) / 8}, &error), ok(__LINE__);
  c2keep_(work, I{1}, &error), ok(__LINE__);
  c2card_(work, cards.data(), I{80}, count, &error), ok(__LINE__);
  c2chld_(work, &error);
  CHECK(error == C2D_ERR_STATE); // nothing is prepared
  c2prep_(work, &error), ok(__LINE__);
  c2keep_(work, I{2}, &error);
  CHECK(error == C2D_ERR_STATE); // options are for the model
  c2solv_(work, c2none_, &error), ok(__LINE__);
  double once[48], twice[48];
  c2get_(work, I{C2D_END_UX}, I{1}, I{1}, I{48}, once, I{1}, &error), ok(__LINE__);
  c2chld_(work, &error), ok(__LINE__);
  int32_t codes[4], state = 0, pulled = 0;
  c2stat_(work, &state);
  CHECK(state == C2D_STATE_MODEL);
  for (int32_t element = 1; element <= 24; ++element)
    for (int32_t local = 1; local <= 2; ++local) {
      c2gcon_(work, I{1}, I{element}, I{local}, I{1}, codes, real.at(), &error), ok(__LINE__);
      if (real_at(real.at()) == 0) continue;
      ++pulled;
      put_real(real.at(), 2 * real_at(real.at()));
      c2case_(work, I{1}, I{element}, I{local}, I{1}, real.at(), &error), ok(__LINE__);
    }
  CHECK(pulled == 8); // both ends of four elements
  c2prep_(work, &error), ok(__LINE__);
  c2solv_(work, c2none_, &error), ok(__LINE__);
  c2get_(work, I{C2D_END_UX}, I{1}, I{1}, I{48}, twice, I{1}, &error), ok(__LINE__);
  double largest = 0;
  for (const double u : twice) largest = std::max(largest, std::fabs(u));
  CHECK(largest == doctest::Approx(0.004).epsilon(1e-6)); // 200 / 1e5 of a length of 2
  for (int i = 0; i < 48; ++i) CHECK(std::fabs(twice[i] - 2 * once[i]) < 1e-12 * largest);
  c2clos_(work, &error), ok(__LINE__);
}

TEST_CASE("fortran77: loads of a rigid body, and how bodies stand") {
  std::vector<double> memory(1 << 20), tapes(1 << 20);
  void* work = memory.data();
  int32_t error = open(work, 1 << 20), rigid = -1;
  const auto ok = [&error](int line) { CHECK_MESSAGE(error == 0, "line " << line); };
  const std::string name = kRoot + "/examples/three_bodies.dat";
  c2core_(work, tapes.data(), I{1 << 20}, &error), ok(__LINE__);
  c2deck_(work, name.data(), I{static_cast<int32_t>(name.size())}, &error), ok(__LINE__);
  c2tie_(work, I{1}, &error);
  CHECK(error == C2D_ERR_STATE); // the model is complete
  c2prep_(work, &error), ok(__LINE__);
  c2chld_(work, &error), ok(__LINE__);
  const int32_t none_free[3] = {0, 0, 0};
  const double force[3] = {0, -100, 50}, point[2] = {0, 0};
  c2rgld_(work, I{3}, I{0}, none_free, force, point, &error);
  CHECK(error == C2D_ERR_STATE); // what is free stays
  c2rgld_(work, I{3}, I{1}, none_free, force, point, &error), ok(__LINE__);
  c2prep_(work, &error), ok(__LINE__);
  c2solv_(work, c2none_, &error), ok(__LINE__);
  double block[11], shoe[11];
  c2bnow_(work, I{1}, &rigid, block, &error), ok(__LINE__);
  CHECK((rigid == 0 && std::fabs(block[1] + 100) < 1e-8 && block[4] == 0 && block[9] == 0));
  c2bnow_(work, I{3}, &rigid, shoe, &error), ok(__LINE__);
  CHECK((rigid == 1 && std::fabs(shoe[1] - 100) < 1e-8 && shoe[9] == -100 && shoe[10] == 50));
  CHECK((shoe[4] < -1e-3 && shoe[5] > 1e-5)); // down, and round to the left
  CHECK((shoe[6] == 0 && shoe[7] == 0));
  c2clos_(work, &error), ok(__LINE__);
}

TEST_CASE("fortran77: a platen pulls a square") {
  std::vector<double> memory(1 << 18), tapes(1 << 18);
  void* work = memory.data();
  int32_t error = open(work, 1 << 18), rigid = -1;
  const auto ok = [&error](int line) { CHECK_MESSAGE(error == 0, "line " << line); };
  c2core_(work, tapes.data(), I{1 << 18}, &error), ok(__LINE__);
  //                       one body           zones pairs ce         mu paths cases        sets curves platens
  const int32_t sizes[20] = {1, 2, 4, 0, 4, 0, 1, 0, 1, 2, 1, 0, 1, 1, 1, 0, 0, 0, 0, 1};
  c2size_(work, sizes, I{20}, &error), ok(__LINE__);
  c2prob_(work, I{1}, I{1}, I{0}, "square    ", I{10}, &error), ok(__LINE__);
  c2body_(work, I{1}, I{2}, I{4}, I{1}, I{0}, R{1000.0}, R{0.3}, &error), ok(__LINE__);
  c2regn_(work, I{1}, I{1}, I{4}, &error), ok(__LINE__);
  const double corners[8] = {0, 0, 1, 0, 1, 1, 0, 1}, none[4] = {0, 0, 0, 0};
  c2node_(work, I{1}, I{1}, I{4}, corners, I{2}, &error), ok(__LINE__);
  const int32_t held[4] = {1, 1, 0, 0}, moved[3] = {3, 3, 0}, all_free[3] = {1, 1, 1}, beyond[3] = {3, 5, 0};
  for (int32_t local = 1; local <= 2; ++local) c2cond_(work, I{1}, I{1}, I{local}, I{1}, held, none, &error), ok(__LINE__);
  const double point[2] = {0.5, 1}, pull[3] = {0, 2, 0};
  c2plat_(work, I{1}, beyond, all_free, point, &error);
  CHECK(error == C2D_ERR_ARGUMENT);
  c2plat_(work, I{1}, moved, all_free, point, &error), ok(__LINE__);
  c2rgld_(work, I{2}, I{1}, all_free, pull, point, &error), ok(__LINE__);
  c2mu_(work, R{0.0}, &error), ok(__LINE__);
  c2path_(work, I{1}, R{1.0}, I{1}, &error), ok(__LINE__);
  c2done_(work, &error), ok(__LINE__);
  c2prep_(work, &error), ok(__LINE__);
  c2solv_(work, c2none_, &error), ok(__LINE__);
  double now[11];
  c2bnow_(work, I{2}, &rigid, now, &error), ok(__LINE__);
  CHECK((rigid == 1 && std::fabs(now[1] + 2) < 1e-12 && now[9] == 2));
  CHECK((std::fabs(now[3]) < 1e-12 && std::fabs(now[4] - 1.9e-3) < 1e-4 && std::fabs(now[5]) < 1e-12));
  c2clos_(work, &error), ok(__LINE__);
}

TEST_CASE("fortran77: nodes on lines and arcs, points and a point load as the C interface has them") {
  Odd memory(8 * kWords, 12), real(8 * 8, 4), places(8 * 60, 4);
  void* work = memory.at();
  REQUIRE(open(work) == 0);
  int32_t error = 0;
  const auto ok = [&error](int line) { CHECK_MESSAGE(error == 0, "line " << line); };
  const int32_t sizes[] = {1, 2, 12, 0, 12, 0, 1, 0, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 1}; // a quarter of a ring
  c2size_(work, sizes, I{19}, &error), ok(__LINE__);
  c2prob_(work, I{0}, I{0}, I{0}, " ", I{1}, &error), ok(__LINE__);
  c2body_(work, I{1}, I{2}, I{12}, I{1}, I{0}, R{1000.0}, R{0.3}, &error), ok(__LINE__);
  c2regn_(work, I{1}, I{1}, I{12}, &error), ok(__LINE__);
  const double ends[6] = {0, 0, 1, 0, 2, 0}, high[6] = {0, 0, 0, 2, 0, 1};
  std::memcpy(real.at(), ends, sizeof ends);
  char* at = static_cast<char*>(real.at());
  c2nlin_(work, I{1}, I{1}, I{3}, at, at + 16, at + 32, &error), ok(__LINE__);
  c2narc_(work, I{1}, I{3}, I{7}, at, R{2.0}, R{0.0}, R{90.0}, &error), ok(__LINE__);
  std::memcpy(real.at(), high, sizeof high);
  c2nlin_(work, I{1}, I{7}, I{9}, at, at + 16, at + 32, &error), ok(__LINE__);
  c2narc_(work, I{1}, I{9}, I{12}, at, R{1.0}, R{90.0}, R{22.5}, &error), ok(__LINE__);
  c2narc_(work, I{1}, I{9}, I{9}, at, R{1.0}, R{90.0}, R{22.5}, &error);
  CHECK(error == C2D_ERR_ARGUMENT); // the last is not behind the first
  const int32_t fix_x[4] = {1, 0, 0, 1}, fix_y[4] = {0, 1, 1, 0};
  const double none[4] = {0, 0, 0, 0};
  for (int32_t i = 0; i < 4; ++i) {
    c2cond_(work, I{1}, I{1 + i / 2}, I{1 + i % 2}, I{1}, fix_y, none, &error), ok(__LINE__);
    c2cond_(work, I{1}, I{7 + i / 2}, I{1 + i % 2}, I{1}, fix_x, none, &error), ok(__LINE__);
  }
  c2load_(work, I{1}, I{1}, R{1.2}, R{0.9}, R{0.0}, R{1.0}, &error), ok(__LINE__);
  const int32_t three_by_two[2] = {3, 2}, few[2] = {0, 0};
  std::memcpy(real.at(), ends, sizeof ends);
  c2apts_(work, I{C2D_POINTS_GRID}, I{1}, three_by_two, at, at + 32, &error), ok(__LINE__);
  c2apts_(work, I{C2D_POINTS_LINE}, I{1}, few, at, at + 32, &error);
  CHECK(error == C2D_ERR_ARGUMENT);
  c2apts_(work, I{C2D_POINTS_ONE}, I{1}, few, at + 16, at, &error), ok(__LINE__);
  c2apts_(work, I{C2D_POINTS_ONE}, I{1}, few, at + 16, at, &error);
  CHECK(error == C2D_ERR_LIMIT);
  const double circle[3] = {0, 0, 2};
  const int32_t outer[2] = {3, 6};
  std::memcpy(real.at(), circle, sizeof circle);
  c2acrv_(work, I{C2D_CURVE_ARC}, I{1}, outer, at, &error), ok(__LINE__);
  c2acrv_(work, I{C2D_CURVE_ARC}, I{1}, outer, at, &error);
  CHECK(error == C2D_ERR_LIMIT);
  c2path_(work, I{1}, R{1.0}, I{1}, &error), ok(__LINE__);
  c2done_(work, &error), ok(__LINE__);

  // Nodes: the field of the bodies' points is that of a line and of an arc.
  c2get_(work, I{C2D_END_X}, I{1}, I{1}, I{24}, places.at(), I{1}, &error), ok(__LINE__);
  CHECK(real_at(places.at(), 2) == 1.5);                                               // node 2
  CHECK(real_at(places.at(), 6) == doctest::Approx(2 * std::cos(std::atan(1.0) / 2))); // node 4: 22.5 degrees
  CHECK(real_at(places.at(), 22) == doctest::Approx(std::cos(std::atan(1.0) / 2)));    // node 12

  int32_t kind = -1, body = 0, of[2], line = -1, total = 0, load_case = 0;
  double xy[4], force[2], inside[12];
  c2gpts_(work, I{1}, &kind, &body, of, &line, at, at + 16, &error), ok(__LINE__);
  CHECK((kind == C2D_POINTS_GRID && body == 1 && of[0] == 3 && of[1] == 2 && line == 0 && real_at(at, 2) == 2));
  c2gpts_(work, I{3}, &kind, &body, of, &line, at, at + 16, &error);
  CHECK(error == C2D_ERR_ARGUMENT);
  c2gcrv_(work, I{1}, &kind, &body, of, &line, at, &error), ok(__LINE__);
  CHECK((kind == C2D_CURVE_ARC && body == 1 && of[0] == 3 && of[1] == 6 && line == 0 && real_at(at, 2) == 2));
  c2gcrv_(work, I{2}, &kind, &body, of, &line, at, &error);
  CHECK(error == C2D_ERR_ARGUMENT);
  c2d_points grid = C2D_INIT(c2d_points);
  grid.kind = C2D_POINTS_GRID, grid.body = 1, grid.count[0] = 3, grid.count[1] = 2, grid.to[0] = 2;
  REQUIRE(c2d_expand_points(&grid, 1, 6, inside, 2, nullptr) == C2D_OK);
  for (const bool odd : {false, true}) {
    double aligned[18];
    void* to = odd ? places.at() : aligned;
    put_real(to, -9, 15);
    c2xpts_(work, I{1}, I{2}, I{5}, to, I{3}, &total, &error), ok(__LINE__);
    CHECK(total == 6);
    for (int i = 0; i < 10; ++i) CHECK(real_at(to, i / 2 * 3 + i % 2) == inside[i + 2]);
    CHECK(real_at(to, 15) == -9); // five points, not six
    c2xpts_(work, I{1}, I{2}, I{6}, to, I{3}, &total, &error);
    CHECK(error == C2D_ERR_ARGUMENT); // there are no more
    c2xpts_(work, I{1}, I{1}, I{2}, to, I{1}, &total, &error);
    CHECK(error == C2D_ERR_ARGUMENT); // they would overlap
  }
  c2xpts_(work, I{2}, I{1}, I{0}, xy, I{2}, &total, &error), ok(__LINE__);
  CHECK(total == 1);

  c2rpld_(work, I{1}, R{1.1}, R{1.0}, R{3.0}, R{4.0}, &error), ok(__LINE__);
  c2gpld_(work, I{1}, &body, &load_case, xy, force, &error), ok(__LINE__);
  CHECK((xy[0] == 1.1 && xy[1] == 1.0 && force[0] == 3.0 && force[1] == 4.0));
  c2rpld_(work, I{2}, R{1.1}, R{1.0}, R{3.0}, R{4.0}, &error);
  CHECK(error == C2D_ERR_ARGUMENT);
}

TEST_CASE("fortran77: IERR from 50 on is what the page says, and nothing else is") {
  const std::string page = read_file(kRoot + "/port/fortran/README.md");
  std::set<std::string> words;
  for (int32_t code = 50; code < 60; ++code) {
    const bool listed = contains(page, "\n| " + std::to_string(code) + " | ");
    CHECK((message(code) != message(50)) == listed); // 50 itself is in nobody's list
    words.insert(message(code));
  }
  CHECK(words.size() == 6); // 51 ... 55, and what is said of all others

  // A name too long, for a file and for a folder; the checks of C2ATCH are those of C2OPEN.
  std::vector<double> work(kWords);
  const std::string name(1200, 'n');
  int32_t error = open(work.data()), least = 0, most = 0;
  c2deck_(work.data(), name.data(), I{1200}, &error);
  CHECK(error == 55);
  c2need_(work.data(), name.data(), I{1200}, &least, &most, &error);
  CHECK(error == 55);
  c2tape_(work.data(), name.data(), I{1200}, &error);
  CHECK(error == 55);
  c2tape_(work.data(), name.data(), I{0}, &error);
  CHECK(error == 55);
  int64_t wide_error = -1;
  const int64_t wide[2] = {1987, 64};
  c2atch_(work.data(), I{kWords}, wide, kLiteral, work.data(), &wide_error);
  CHECK(wide_error == 51);
  const int32_t nonsense[2] = {1986, 64};
  c2atch_(work.data(), I{kWords}, nonsense, kLiteral, work.data(), &error);
  CHECK(error == 53);
  work[0] = 0; // overwritten
  c2atch_(work.data(), I{kWords}, kIntegers, kLiteral, work.data(), &error);
  CHECK(error == 54);
}

TEST_CASE("fortran77: the page has every name with its arguments, and every function of the header") {
  const std::string page = read_file(kRoot + "/port/fortran/README.md"),
                    declarations = read_file(kRoot + "/port/fortran/fortran77.hpp"),
                    header = read_file(kRoot + "/include/contact2d.h") + read_file(kRoot + "/include/contact2d_cards.h");
  const std::regex declared("void (c2[a-z0-9]+)_\\(([^;]*)\\);"), argument("(\\w+)(,|$)");
  int names = 0;
  for (std::sregex_iterator i(declarations.begin(), declarations.end(), declared), end; i != end; ++i) {
    std::string call = (*i)[1].str() + "(", arguments = (*i)[2].str();
    if (call == "c2none(") continue;
    CHECK((*i)[1].str().size() <= 6);
    ++names;
    for (std::sregex_iterator a(arguments.begin(), arguments.end(), argument); a != end; ++a)
      call += (call.back() == '(' ? "" : ", ") + (*a)[1].str();
    for (char& c : call) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    CHECK_MESSAGE(contains(page, "| `" + call + ")` |"), call);
  }
  CHECK(names > 50);
  const std::regex function("\\n(?:c2d_status|const char\\*|int32_t) (c2d_\\w+)\\(");
  for (std::sregex_iterator i(header.begin(), header.end(), function), end; i != end; ++i)
    CHECK_MESSAGE(contains(page, "`" + (*i)[1].str() + "`"), (*i)[1].str() << " is not in port/fortran/README.md");
}

namespace {

// Arguments of one kind for every call: what is read holds `value` everywhere, what is written has room for as many.
struct Sweep {
  std::vector<int32_t> read;
  std::vector<unsigned char> written = std::vector<unsigned char>(1 << 20);
  int32_t error = -1;
  explicit Sweep(int32_t value) : read(1 << 14, value) {}
  const void* argument(const void*) { return read.data(); }
  void* argument(void*) { return written.data(); }
  template <class First, class... Between> int32_t operator()(void (*call)(First, Between...), void* work) {
    return with(call, work, std::make_index_sequence<sizeof...(Between) - 1>(), std::tuple<Between...>());
  }
  template <class Call, size_t... I, class Types> int32_t with(Call call, void* work, std::index_sequence<I...>, const Types&) {
    error = -1;
    call(work, argument(typename std::tuple_element<I, Types>::type())..., &error);
    return error;
  }
};

// The `which`-th name that takes the work array and tells an error, and what it tells; no name: there are no more.
std::pair<std::string, int32_t> sweep_one(void* work, int32_t value, size_t which) {
  size_t at = 0;
#define SWEEP(name)                                                                                                            \
  if (at++ == which) return {#name, Sweep(value)(name, work)}
  SWEEP(c2tape_);
  SWEEP(c2core_);
  SWEEP(c2opts_);
  SWEEP(c2keep_);
  SWEEP(c2deck_);
  SWEEP(c2need_);
  SWEEP(c2neds_);
  SWEEP(c2tned_);
  SWEEP(c2tnds_);
  SWEEP(c2size_);
  SWEEP(c2prob_);
  SWEEP(c2body_);
  SWEEP(c2regn_);
  SWEEP(c2node_);
  SWEEP(c2nlin_);
  SWEEP(c2narc_);
  SWEEP(c2cond_);
  SWEEP(c2case_);
  SWEEP(c2load_);
  SWEEP(c2rigd_);
  SWEEP(c2plat_);
  SWEEP(c2rgld_);
  SWEEP(c2intf_);
  SWEEP(c2bfor_);
  SWEEP(c2zone_);
  SWEEP(c2tie_);
  SWEEP(c2mu_);
  SWEEP(c2muz_);
  SWEEP(c2symm_);
  SWEEP(c2path_);
  SWEEP(c2clrp_);
  SWEEP(c2acrv_);
  SWEEP(c2apts_);
  SWEEP(c2unit_);
  SWEEP(c2name_);
  SWEEP(c2line_);
  SWEEP(c2done_);
  SWEEP(c2prep_);
  SWEEP(c2save_);
  SWEEP(c2rest_);
  SWEEP(c2chld_);
  SWEEP(c2rpld_);
  SWEEP(c2begn_);
  SWEEP(c2advn_);
  SWEEP(c2next_);
  SWEEP(c2canc_);
  SWEEP(c2get_);
  SWEEP(c2intr_);
  SWEEP(c2indi_);
  SWEEP(c2summ_);
  SWEEP(c2bsta_);
  SWEEP(c2zsta_);
  SWEEP(c2bnow_);
  SWEEP(c2gmu_);
  SWEEP(c2gpth_);
  SWEEP(c2gzon_);
  SWEEP(c2greg_);
  SWEEP(c2gcon_);
  SWEEP(c2gpld_);
  SWEEP(c2gbfo_);
  SWEEP(c2grig_);
  SWEEP(c2gint_);
  SWEEP(c2gnam_);
  SWEEP(c2gcrv_);
  SWEEP(c2gpts_);
  SWEEP(c2xpts_);
  SWEEP(c2note_);
#undef SWEEP
  return {"", 0};
}

// What needs no array that was opened.
bool tells_sizes(const std::string& name) {
  return name == "c2tnds_" || name == "c2neds_" || name == "c2tned_" || name == "c2need_";
}

} // namespace

TEST_CASE("fortran77: every call with the same number everywhere, in every state, tells what it is, and breaks nothing") {
  size_t refused = 0;
  for (int state = 0; state < 5; ++state) {
    CAPTURE(state);
    for (int32_t value : {0, 1, 2, -1, 4000}) {
      CAPTURE(value);
      for (size_t which = 0;; ++which) {
        Odd memory(8 * kWords, 4);
        void* const work = memory.at();
        std::memset(work, 0, 8 * kWords);
        std::vector<double> tapes(60000);
        int32_t error = 0;
        if (state > 0) REQUIRE(open(work) == 0);
        if (state > 1) {
          c2core_(work, tapes.data(), I{60000}, &error);
          REQUIRE(error == 0);
          const std::string cards = padded(cards_of("plate_tension.dat"));
          c2card_(work, cards.data(), I{80}, I{static_cast<int32_t>(cards.size() / 80)}, &error);
          REQUIRE(error == 0);
        }
        if (state > 2) c2prep_(work, &error);
        if (state > 3) c2begn_(work, R{0.0}, I{0}, &error);
        REQUIRE(error == 0);
        const auto told = sweep_one(work, value, which);
        if (told.first.empty()) break;
        CAPTURE(told.first);
        CHECK(told.second != -1);
        if (state == 0 && !tells_sizes(told.first)) CHECK(told.second == 54);
        CHECK_FALSE(message(told.second).empty());
        refused += told.second != 0;
        if (state > 0) c2clos_(work, &error);
      }
    }
  }
  CHECK(refused > 500);
}

TEST_CASE("fortran77: C2WHY and C2NOTE of an array that was not opened, whatever room there is for the answer") {
  Odd memory(8 * kWords, 4);
  std::memset(memory.at(), 0, 8 * kWords);
  for (int32_t room : {-1, 0, 1, 5, c2d::fortran::kInfo + 0, 40}) {
    CAPTURE(room);
    std::vector<int32_t> info(41, -7);
    char text[61];
    std::memset(text, '#', sizeof text);
    c2why_(memory.at(), info.data(), I{room}, text, I{60});
    const int32_t filled = std::max(0, std::min(room, c2d::fortran::kInfo + 0));
    for (int32_t i = 0; i < filled; ++i) CHECK(info[static_cast<size_t>(i)] == (i == 0 ? 54 : 0));
    CHECK(info[static_cast<size_t>(filled)] == -7);
    CHECK(std::string(text, 6) == "C2OPEN");
    CHECK(text[60] == '#');
    int32_t error = 0;
    c2note_(memory.at(), I{1}, info.data(), I{room}, text, I{60}, &error);
    CHECK(error == 54);
  }
}

TEST_CASE("fortran77: arrays at odd addresses, with places and counts at the ends of their ranges") {
  Odd memory(8 * kWords, 4), store(480000, 4), room(8 * 4096, 4);
  void* const work = memory.at();
  void* const a = room.at();
  int32_t error = 0, total = 0, increments = 0;
  REQUIRE(open(work) == 0);
  c2core_(work, store.at(), I{60000}, &error);
  std::string cards = padded(cards_of("plate_tension.dat"));
  c2card_(work, cards.data(), I{80}, I{static_cast<int32_t>(cards.size() / 80)}, &error);
  REQUIRE(error == 0);
  c2card_(work, cards.data(), I{80}, I{1}, &error); // there is a solver already
  CHECK(error == C2D_ERR_STATE);
  c2card_(work, cards.data(), I{0}, I{1}, &error);
  CHECK(error == C2D_ERR_ARGUMENT);
  c2card_(work, cards.data(), I{80}, I{0}, &error);
  CHECK(error == C2D_ERR_ARGUMENT);
  c2prep_(work, &error);
  c2begn_(work, R{0.0}, I{0}, &error);
  REQUIRE(error == 0);
  std::vector<double> many(200, 1.0);
  std::memcpy(a, many.data(), 200 * sizeof(double));
  int32_t outcome = 0;
  double step = 0;
  c2advn_(work, a, I{100}, &outcome, &error); // more than are copied
  CHECK(error == C2D_ERR_LIMIT);
  c2next_(work, a, I{100}, &step, &error);
  CHECK(error == C2D_ERR_LIMIT);
  c2begn_(work, a, I{100}, &error);
  CHECK(error == C2D_ERR_LIMIT);
  c2gpth_(work, I{1}, &increments, a, I{100}, &error);
  CHECK(error == C2D_ERR_LIMIT);
  c2advn_(work, a, I{1}, &outcome, &error);
  REQUIRE(error == 0);

  const auto is_left_alone = [&] { return std::memcmp(a, many.data(), 200 * sizeof(double)) == 0; };
  for (int32_t first : {0, INT32_MAX}) {
    CAPTURE(first);
    c2get_(work, I{C2D_END_X}, I{1}, I{first}, I{5}, a, I{1}, &error);
    CHECK(error == C2D_ERR_ARGUMENT);
    c2indi_(work, I{1}, I{first}, I{2}, a, I{C2D_OFF_FIELDS}, &error);
    CHECK(error == C2D_ERR_ARGUMENT);
  }
  c2get_(work, I{C2D_END_X}, I{1}, I{1}, I{-1}, a, I{1}, &error);
  CHECK(error == C2D_ERR_ARGUMENT);
  c2get_(work, I{C2D_END_X}, I{1}, I{1}, I{4}, a, I{0}, &error);
  CHECK(error == C2D_ERR_ARGUMENT);
  c2get_(work, I{C2D_END_X}, I{1}, I{1}, I{0}, a, I{1}, &error); // none is no fault
  CHECK(error == 0);
  c2indi_(work, I{1}, I{1}, I{4000}, a, I{C2D_OFF_FIELDS}, &error);
  CHECK(error == C2D_ERR_ARGUMENT);
  c2indi_(work, I{1}, I{1}, I{1}, a, I{1}, &error);
  CHECK(error == C2D_ERR_ARGUMENT);
  c2xpts_(work, I{1}, I{1}, I{1}, a, I{2}, &total, &error); // no sets of points
  CHECK(error == C2D_ERR_ARGUMENT);
  CHECK(is_left_alone());
  // Points: one that is none, and a body that is none.
  double xy[4] = {0.5, 0.5, std::nan(""), 0.5};
  Odd points(64, 4);
  std::memcpy(points.at(), xy, sizeof xy);
  c2intr_(work, I{1}, I{2}, points.at(), I{2}, a, I{C2D_POINT_FIELDS}, &error);
  CHECK(error == C2D_ERR_ARGUMENT);
  c2intr_(work, I{9}, I{1}, points.at(), I{2}, a, I{C2D_POINT_FIELDS}, &error);
  CHECK(error == C2D_ERR_ARGUMENT);
  CHECK(is_left_alone());
  c2intr_(work, I{1}, I{1}, points.at(), I{2}, a, I{C2D_POINT_FIELDS}, &error);
  CHECK(error == 0);
  CHECK_FALSE(is_left_alone());
  c2clos_(work, &error);
}

TEST_CASE("fortran77: decks in files with lines of any length and end") {
  const Folder folder;
  const std::vector<std::string> lines = cards_of("plate_tension.dat");
  Odd memory(8 * kWords, 4), store(480000, 4);
  void* const work = memory.at();
  std::vector<double> expected;
  for (int kind = 0; kind < 4; ++kind) {
    CAPTURE(kind);
    std::string text;
    for (size_t i = 0; i < lines.size(); ++i) {
      text += lines[i];
      if (kind == 2) text += std::string(600, ' '); // longer than a card may be, of blanks
      text += kind == 1 ? "\r\n" : i + 1 == lines.size() && kind == 3 ? "" : "\n";
    }
    const std::string name = folder / "deck.dat";
    write_file(name, text);
    int32_t error = 0;
    REQUIRE(open(work) == 0);
    c2core_(work, store.at(), I{60000}, &error);
    c2deck_(work, name.data(), I{static_cast<int32_t>(name.size())}, &error);
    CHECK(error == 0);
    c2deck_(work, name.data(), I{static_cast<int32_t>(name.size())}, &error);
    CHECK(error == C2D_ERR_STATE);
    std::vector<double> x(8);
    c2prep_(work, &error);
    c2begn_(work, R{0.0}, I{0}, &error);
    REQUIRE(error == 0);
    c2get_(work, I{C2D_END_X}, I{1}, I{1}, I{8}, x.data(), I{1}, &error);
    CHECK(error == 0);
    if (kind == 0) expected = x;
    CHECK(x == expected);
    c2clos_(work, &error);
  }
  int32_t error = 0;
  REQUIRE(open(work) == 0);
  c2deck_(work, folder.path().data(), I{static_cast<int32_t>(folder.path().size())}, &error); // a folder is no deck
  CHECK(error != 0);
  c2clos_(work, &error);
}

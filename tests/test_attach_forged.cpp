// c2d_attach and memory in which somebody has changed numbers of the solver: whatever no solver can say of itself is refused,
// and the memory stays as it was.
#include "contact2d_image.h"
#include "solver/solver.hpp"
#include "solver_runs.hpp"

#include <doctest/doctest.h>

#include <cstddef>
#include <sstream>

using namespace runs;

namespace {

// Two squares, a punch on the upper one.
const char kDeck[] = "*FREE\n1\nPUNCH\n0 2\n2 1 2\n1 2 4 4\n1 2 4 4\n1 4\n1 4\n1000 0.3\n2000 0.25\n2 0.3 0\n0 0\n"
                     "1 0 0\n2 1 0\n3 1 1\n4 0 1\n0 1\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n2\n1 1 1100 0 0 0 0\n1 2 1100 0 0 0 0\n"
                     "0\n0\n0\n1 2 2 1\n3 3 1 1\n4 3 1 2\n2 1\n2 1\n1 10\n2 1\n*PLATEN 2 3 3 0.5 2\n1 FY -1 TURN 0\n";

struct Image {
  RamStore store;
  c2d_port port = C2D_INIT(c2d_port);
  Bytes bytes, whole;
  size_t at = 0; // where the solver is
  c2d::Layout layout;

  explicit Image(bool broken = false, bool empty = false) {
    Deck deck;
    std::istringstream lines(kDeck);
    for (std::string line; std::getline(lines, line);) deck.lines.push_back(line);
    host::Limits limits = deck.limits();
    REQUIRE(limits.bodies == 2);
    store.serve(port);
    uint64_t in_core = 0;
    REQUIRE(c2d_memory_need(&limits, nullptr, &in_core, nullptr) == C2D_OK);
    bytes.resize(static_cast<size_t>(in_core));
    c2d_solver* s = nullptr;
    REQUIRE(c2d_create(&s, bytes.data(), bytes.size(), &limits, &port, nullptr) == C2D_OK);
    if (!empty) {
      const c2d_status read = read_deck(s, deck);
      REQUIRE_MESSAGE(read == C2D_OK, error_of(s).text);
    }
    if (broken) {
      store.before = [](const RamStore::Operation& operation, size_t) { return operation.kind == 'w' ? 5 : 0; };
      REQUIRE(c2d_prepare(s) == C2D_ERR_STORE_WRITE);
      REQUIRE(c2d_get_state(s) == C2D_STATE_BROKEN);
      store.before = nullptr;
    }
    at = static_cast<size_t>(reinterpret_cast<unsigned char*>(s) - bytes.data());
    layout = s->layout;
    whole = bytes;
  }
  template <class T> T get(size_t place) const {
    T value;
    std::memcpy(&value, bytes.data() + at + place, sizeof value);
    return value;
  }
  template <class T> void set(size_t place, T value) { std::memcpy(bytes.data() + at + place, &value, sizeof value); }
  size_t body(int32_t number) const {
    return static_cast<size_t>(layout.offset[c2d::kBodies]) + static_cast<size_t>(number - 1) * sizeof(c2d::Body);
  }
  size_t array(int32_t number, int32_t which) const {
    return body(number) + offsetof(c2d::Body, array) + sizeof(int64_t) * static_cast<size_t>(which);
  }
  // With what was set; then it is as before.
  c2d_status attach(size_t size = 0) {
    const Bytes before = bytes;
    c2d_solver* out = reinterpret_cast<c2d_solver*>(1);
    c2d_error why = C2D_INIT(c2d_error);
    const c2d_status status = c2d_attach(&out, bytes.data(), size == 0 ? bytes.size() : size, &port, &why);
    CHECK((out != nullptr) == (status == C2D_OK));
    if (status != C2D_OK) {
      CHECK(bytes == before);
      CHECK(why.status == status);
      CHECK(why.text[0] != '\0');
    }
    bytes = whole;
    return status;
  }
};

#define PLACE(member) offsetof(c2d_solver, member)

} // namespace

TEST_CASE("attach: numbers that no solver has are refused") {
  Image image;
  REQUIRE(image.attach() == C2D_OK);
  const size_t sizes = PLACE(sizes);
  for (int32_t state : {C2D_STATE_EMPTY - 1, C2D_STATE_BROKEN + 1}) {
    image.set<int32_t>(PLACE(state), state);
    CHECK(image.attach() == C2D_ERR_ARGUMENT);
  }
  image.set<int32_t>(sizes + offsetof(c2d::Sizes, load_cases), 0); // there is always one
  CHECK(image.attach() == C2D_ERR_ARGUMENT);
  image.set<int32_t>(sizes + offsetof(c2d::Sizes, function_nodes), 9);
  CHECK(image.attach() == C2D_ERR_ARGUMENT);
  image.set<int64_t>(sizes + offsetof(c2d::Sizes, curves), int64_t{1} << 40);
  CHECK(image.attach() == C2D_ERR_ARGUMENT);
  const auto pairs = [&](int64_t n) { // and all that goes with them: more memory than there can be
    image.set<int64_t>(sizes + offsetof(c2d::Sizes, pairs), n);
    image.set<int64_t>(sizes + offsetof(c2d::Sizes, contact), 2 * n);
  };
  pairs(INT32_MAX);
  CHECK(image.attach() == C2D_ERR_ARGUMENT);
  for (uint64_t claimed : {uint64_t{0}, uint64_t{100}, uint64_t{sizeof(c2d_solver)} + 200, UINT64_MAX}) {
    image.set<uint64_t>(PLACE(bytes), claimed);
    CHECK(image.attach() == C2D_ERR_ARGUMENT);
  }
  image.set<uint64_t>(PLACE(bytes), image.get<uint64_t>(PLACE(bytes)) + 4096); // it claims more than there is
  CHECK(image.attach() == C2D_ERR_MEMORY);
}

TEST_CASE("attach: memory that ends within the solver's own struct, or before its list of bodies does") {
  Image image;
  for (size_t size : {sizeof(c2d_solver), sizeof(c2d_solver) + 5, image.at + sizeof(c2d_solver) - 1})
    if (size < image.at + sizeof(c2d_solver)) CHECK(image.attach(size) == C2D_ERR_ARGUMENT);
  for (size_t size : {image.at + sizeof(c2d_solver), image.at + sizeof(c2d_solver) + sizeof(c2d_body_limits)})
    CHECK(image.attach(size) == C2D_ERR_MEMORY);
  image.set<uint64_t>(PLACE(magic), 0);
  CHECK(image.attach(sizeof(c2d_solver) + 5) == C2D_ERR_ARGUMENT); // nothing of it, wherever one looks
}

TEST_CASE("attach: the sum of an image is that of a whole solver, between calls") {
  Image image;
  c2d_solver* const s = reinterpret_cast<c2d_solver*>(image.bytes.data() + image.at);
  uint64_t sum = 7, again = 8;
  REQUIRE(c2d_image_sum(s, &sum) == C2D_OK);
  s->busy = 1;
  CHECK(c2d_image_sum(s, &again) == C2D_ERR_BUSY);
  s->busy = 0;
  const auto magic = s->magic;
  s->magic = 0;
  CHECK(c2d_image_sum(s, &again) == C2D_ERR_ARGUMENT);
  CHECK(again == 8);
  s->magic = magic;
  CHECK(c2d_image_sum(nullptr, &again) == C2D_ERR_ARGUMENT);
  CHECK(c2d_image_sum(s, nullptr) == C2D_ERR_ARGUMENT);
  REQUIRE(c2d_image_sum(s, &again) == C2D_OK);
  CHECK(again == sum);
}

TEST_CASE("attach: a punch has the mesh of a body before it, and no other memory") {
  Image image;
  const int32_t punch = 3;
  REQUIRE(image.get<int64_t>(image.array(punch, c2d::kXy)) == image.get<int64_t>(image.array(2, c2d::kXy)));
  const int64_t regions = image.get<int64_t>(image.array(punch, c2d::kRegions)), one = sizeof(c2d::Region);
  for (int64_t by : {-one, int64_t{1}, one, 100 * one}) {
    CAPTURE(by);
    image.set<int64_t>(image.array(punch, c2d::kRegions), regions + by);
    CHECK(image.attach() == C2D_ERR_ARGUMENT);
  }
  image.set<int32_t>(image.body(2) + offsetof(c2d::Body, elements), 0); // nothing to borrow there
  CHECK(image.attach() == C2D_ERR_ARGUMENT);
  image.set<int64_t>(image.array(punch, c2d::kXy), 8); // nobody's
  CHECK(image.attach() == C2D_ERR_ARGUMENT);
  image.set<int64_t>(image.array(punch, c2d::kEndCode), 8);
  CHECK(image.attach() == C2D_ERR_ARGUMENT);
  Image unused(false, true); // a punch that is not there yet has arrays of no length
  unused.set<int64_t>(unused.array(punch, c2d::kXy), 8);
  CHECK(unused.attach() == C2D_ERR_ARGUMENT);
  CHECK(unused.attach() == C2D_OK);
}

TEST_CASE(
    "attach: a broken solver is taken up, and can be restored or made anew alone; where nothing is told nothing is written") {
  Image broken(true);
  c2d_solver* s = nullptr;
  REQUIRE(c2d_attach(&s, broken.bytes.data(), broken.bytes.size(), &broken.port, nullptr) == C2D_OK);
  CHECK(c2d_get_state(s) == C2D_STATE_BROKEN);
  CHECK(c2d_prepare(s) == C2D_ERR_STATE);
  Image image;
  c2d_error blank = {};
  CHECK(c2d_attach(&s, image.bytes.data(), image.bytes.size(), &image.port, &blank) == C2D_ERR_ARGUMENT);
  CHECK(blank.status == 0);
  Image prepared;
  REQUIRE(c2d_attach(&s, prepared.bytes.data(), prepared.bytes.size(), &prepared.port, nullptr) == C2D_OK);
  REQUIRE(c2d_prepare(s) == C2D_OK);
  prepared.store.before = [](const RamStore::Operation& operation, size_t) { return operation.kind == 'o' ? 17 : 0; };
  CHECK(c2d_attach(&s, prepared.bytes.data(), prepared.bytes.size(), &prepared.port, nullptr) == C2D_ERR_STORE_OPEN);
}

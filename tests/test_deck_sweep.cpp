// Decks with one word, one card or one line end other than it should be, at every place of decks that have every card: each is
// read, or refused with faults that have a place; and the reader that only looks says the same as the one that makes a model.
#include "deck_recorder.hpp"
#include "solver_runs.hpp"

#include <doctest/doctest.h>

#include <cctype>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

namespace {

using Lines = std::vector<std::string>;

// Two squares in free form, and every keyword card.
Lines rich() {
  return {"*FREE",
          "1",
          "EVERY CARD",
          "0 1",
          "2 1 2",
          "1 2 4 4",
          "1 2 4 4",
          "1 4",
          "1 4",
          "100.0 0.3",
          "200.0 0.2",
          "2 0.5 0.6",
          "0 0",
          "1 0 0",
          "2 1 0",
          "3 1 1",
          "4 0 1",
          "0 1",
          "1 0 0",
          "2 1 0",
          "3 1 1",
          "4 0 1",
          "2",
          "1 1 1100 0 0 0 0",
          "1 1 2 1100 0 0 0 0",
          "0",
          "1",
          "3 1 0011 0.0 -1.0 0 0",
          "1",
          "1 0.5 0.5 0.0 -2.0",
          "1 2 2 1",
          "3 3 1 1",
          "3 4 2 1",
          "2 1",
          "2 1",
          "1 10",
          "4 1.0",
          "*UNITS mm N",
          "*NAME BODY 2 bolt head, M8",
          "*NAME ZONE 1 thread",
          "*CASES 2",
          "case 2",
          "condition 2 3-3 0 0.1 0 0 0",
          "condition 2 3 1 0.1 0 0 0",
          "load 2 0.4 1.5 0.0 -0.1",
          "*BODY FORCE 1 3 0 -1e-3 1e-6 0 0",
          "*BODY FORCE 2 4 0 -1e-3",
          "*INTERFERENCE 5",
          "*PATH",
          "2 1.0 0.0 0 0 0",
          "3 1.0 0.5 0 0 0",
          "*FRICTION",
          "1 0.3 INF",
          "*PLATEN 2 2 2 1 1.5",
          "1 FX 2 MOMENT 1",
          "2 FX 40",
          "*CURVE LINE 1 1 1",
          "*POINTS",
          "POINT 1 0.5 0.5",
          "LINE 1 0.2 0.2 0.8 0.8 5",
          "GRID 1 0.2 0.2 0.8 0.8 3 3"};
}

// A rigid body, symmetry, free zones, ties.
Lines rigid() {
  return {"*FREE",
          "1",
          "RIGID AND FREE",
          "0 1",
          "3 0 2",
          "1 2 4 4",
          "1 2 4 4",
          "1 2 4 4",
          "1 4",
          "1 4",
          "1 4",
          "100.0 0.3",
          "200.0 0.2",
          "200.0 0.2",
          "1 0.5",
          "0 0",
          "1 0 0",
          "2 1 0",
          "3 1 1",
          "4 0 1",
          "0 1",
          "1 0 0",
          "2 1 0",
          "3 1 1",
          "4 0 1",
          "0 2",
          "1 0 0",
          "2 1 0",
          "3 1 1",
          "4 0 1",
          "2",
          "1 1 1100 0 0 0 0",
          "1 1 2 1100 0 0 0 0",
          "0",
          "0",
          "0",
          "0",
          "0",
          "0 0",
          "0 0",
          "0 0",
          "1 10",
          "4 1.0",
          "*ZONE 3 3 1 1",
          "*TIE 1",
          "*ZONE BODIES 3 2 1 1 3 3",
          "*RIGID 3",
          "1 0 0 0 0 2",
          "*RIGID LOAD 3 0.5 2.5 X Y",
          "1 0 -5 0"};
}

struct Faults {
  std::vector<c2d_error> all;
  static void take(void* context, const c2d_error* fault) { static_cast<Faults*>(context)->all.push_back(*fault); }
};

// Reads a deck in both ways; how many faults it has.
size_t look_at(const Lines& lines) {
  runs::Deck deck;
  deck.lines = lines;
  Faults faults;
  host::Limits room;
  room.bodies = host::Limits::kRoom;
  const c2d_status checked = c2d_check_deck(runs::Deck::read, &deck, &room, Faults::take, &faults);
  for (const c2d_error& fault : faults.all) {
    CHECK(fault.text[0] != '\0');
    CHECK(fault.line >= 0);
    CHECK(fault.line <= static_cast<int32_t>(lines.size()) + 1);
    CHECK(fault.column <= fault.column_end);
  }
  size_t told = 0;
  for (const c2d_error& fault : faults.all) told += fault.severity == C2D_FAULT;
  if (checked != C2D_OK) {
    CHECK(told > 0);
    return told;
  }
  CHECK(told == 0);
  uint64_t need = 0;
  room.bodies = room.bodies < 0 ? 0 : room.bodies;
  if (c2d_memory_need(&room, &need, nullptr, nullptr) != C2D_OK || need > (1 << 22)) return 0;
  runs::RamStore store;
  c2d_port port = C2D_INIT(c2d_port);
  store.serve(port);
  runs::Machine machine(room, need, &port);
  REQUIRE(machine.created == C2D_OK);
  const c2d_status read = runs::read_deck(machine.solver, deck);
  CHECK((read == C2D_OK || read == C2D_ERR_INPUT));
  CHECK(c2d_get_state(machine.solver) == (read == C2D_OK ? C2D_STATE_MODEL : C2D_STATE_EMPTY));
  return 0;
}

struct Word {
  size_t first, end;
};
std::vector<Word> words_of(const std::string& line) {
  std::vector<Word> out;
  for (size_t i = 0; i < line.size();) {
    if (std::isspace(static_cast<unsigned char>(line[i])) != 0) {
      ++i;
      continue;
    }
    const size_t first = i;
    while (i < line.size() && std::isspace(static_cast<unsigned char>(line[i])) == 0) ++i;
    out.push_back({first, i});
  }
  return out;
}

const char* const kWrong[] = {"x",     "-1",  "0",     "2",   "7",  "99999999999", "2147483647",    "1.5",
                              "1e999", "INF", "-",     "2-1", "1-", "5-7x",        "1-99999999999", "~",
                              "*",     "[a",  "BODIES"};

} // namespace

TEST_CASE("deck sweep: any word otherwise, anywhere, is read or refused at its place") {
  const std::vector<Lines> decks = {rich(), rigid(), deck_test::squares()};
  size_t tried = 0, refused = 0;
  for (size_t d = 0; d < decks.size(); ++d) {
    CAPTURE(d);
    const Lines& sound = decks[d];
    for (size_t i = 0; i < sound.size(); ++i) {
      CAPTURE(i);
      for (const Word& word : words_of(sound[i])) {
        for (const char* wrong : kWrong) {
          Lines lines = sound;
          std::string text = wrong;
          CAPTURE(text);
          if (d == 2 && text.size() < word.end - word.first) text.insert(0, word.end - word.first - text.size(), ' ');
          lines[i].replace(word.first, word.end - word.first, text);
          refused += look_at(lines) > 0;
          ++tried;
        }
      }
    }
  }
  MESSAGE("words tried: " << tried << ", of them refused: " << refused);
  CHECK(refused > tried / 3);
}

TEST_CASE("deck sweep: a card too short, too long, missing, twice, and a deck that ends anywhere") {
  const std::vector<Lines> decks = {rich(), rigid(), deck_test::squares()};
  size_t tried = 0, refused = 0;
  for (size_t d = 0; d < decks.size(); ++d) {
    CAPTURE(d);
    const Lines& sound = decks[d];
    for (size_t i = 0; i < sound.size(); ++i) {
      CAPTURE(i);
      for (int how = 0; how < 10; ++how) {
        CAPTURE(how);
        Lines lines = sound;
        const std::vector<Word> words = words_of(lines[i]);
        if (how == 0) lines.resize(i);
        if (how == 1) lines.erase(lines.begin() + static_cast<long>(i));
        if (how == 2) lines.insert(lines.begin() + static_cast<long>(i), lines[i]);
        if (how == 3) lines[i] += " 9";
        if (how == 4) lines[i] += " x y z";
        if (how == 5 && !words.empty()) lines[i].resize(words.back().first);
        if (how == 6) lines[i] = "";
        if (how == 7) lines[i] += "\r";
        if (how == 8) lines[i] = "\t" + lines[i] + " \t";
        if (how == 9) lines[i] += std::string(300, '1');
        refused += look_at(lines) > 0;
        ++tried;
      }
    }
  }
  CHECK(refused > tried / 3);
}

TEST_CASE("deck sweep: the decks themselves are sound") {
  for (const Lines& lines : {rich(), rigid(), deck_test::squares()}) {
    runs::Deck deck;
    deck.lines = lines;
    Faults faults;
    host::Limits room;
    room.bodies = host::Limits::kRoom;
    const c2d_status status = c2d_check_deck(runs::Deck::read, &deck, &room, Faults::take, &faults);
    for (const c2d_error& fault : faults.all) MESSAGE(fault.line << ": " << fault.text);
    CHECK(status == C2D_OK);
  }
}

TEST_CASE("deck sweep: a solver whose limits are too small by one anywhere refuses the deck by the limit's name") {
  size_t refused = 0;
  for (const Lines& lines : {rich(), rigid(), deck_test::squares()}) {
    runs::Deck deck;
    deck.lines = lines;
    for (int which = 0; which < 12; ++which) {
      CAPTURE(which);
      host::Limits limits = deck.limits();
      REQUIRE(limits.bodies > 0);
      int32_t* const member[] = {&limits.zones,        &limits.pairs,  &limits.contact_elements, &limits.point_loads,
                                 &limits.coefficients, &limits.paths,  &limits.load_cases,       &limits.free_pairs,
                                 &limits.point_sets,   &limits.curves, &limits.list[0].elements, &limits.list[0].points};
      if (*member[which] < 1) continue;
      --*member[which];
      uint64_t need = 0;
      if (c2d_memory_need(&limits, &need, nullptr, nullptr) != C2D_OK) continue; // these limits contradict each other
      runs::RamStore store;
      c2d_port port = C2D_INIT(c2d_port);
      store.serve(port);
      runs::Machine machine(limits, need, &port);
      REQUIRE(machine.created == C2D_OK);
      const c2d_status read = runs::read_deck(machine.solver, deck);
      if (read == C2D_OK) { // one is the least that a limit may be
        CHECK(*member[which] == 0);
        continue;
      }
      CHECK((read == C2D_ERR_LIMIT || read == C2D_ERR_INPUT));
      CHECK(c2d_get_state(machine.solver) == C2D_STATE_EMPTY);
      CHECK(runs::error_of(machine.solver).text[0] != '\0');
      ++refused;
    }
  }
  CHECK(refused > 15);
}

TEST_CASE("deck sweep: a deck of nothing but faults is given up after some, with and without anybody to tell") {
  Lines lines = rich();
  for (int i = 0; i < 500; ++i) lines.push_back("*NO SUCH CARD");
  for (int i = 0; i < 500; ++i) lines.push_back("*RIGID 99 x");
  runs::Deck deck;
  deck.lines = lines;
  Faults faults;
  host::Limits room;
  room.bodies = host::Limits::kRoom;
  CHECK(c2d_check_deck(runs::Deck::read, &deck, &room, Faults::take, &faults) == C2D_ERR_INPUT);
  CHECK(faults.all.size() > 50);
  CHECK(faults.all.size() < 300);
  deck.next = 0;
  room.bodies = host::Limits::kRoom;
  CHECK(c2d_check_deck(runs::Deck::read, &deck, &room, nullptr, nullptr) == C2D_ERR_INPUT);
}

TEST_CASE("deck sweep: a model that refuses the n-th call, for every n: reading ends there, or goes on to tell all faults") {
  std::vector<std::string> decks;
  for (const char* folder : {"/tests/fuzz/seeds/deck", "/examples"})
    for (const auto& entry : std::filesystem::directory_iterator(paths::root() + folder)) {
      const std::string name = entry.path().filename().string();
      if (entry.is_regular_file() && (name.find('.') == std::string::npos || entry.path().extension() == ".dat") &&
          entry.file_size() < 12000)
        decks.push_back(entry.path().string());
    }
  REQUIRE(decks.size() > 10);
  std::set<std::string> refused; // by the call's name
  for (const std::string& path : decks) {
    CAPTURE(path);
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    bool wrong = false;
    for (const c2d_status refusal : {C2D_OK, C2D_ERR_LIMIT, C2D_ERR_INPUT})
      for (int n = 0, end = 1; n<end; n += end> 200 ? 7 : 1) {
        deck_test::Bytes deck;
        deck.bytes = text.str();
        deck_test::Recorder model;
        model.refuse_call = n, model.refusal = refusal;
        c2d::DeckSink sink = deck_test::recording_sink(model);
        std::vector<deck_test::Fault> faults;
        host::Limits room;
        const c2d_status status =
            c2d::read_deck_cards(&sink, deck_test::read_bytes, &deck, deck_test::keep_fault, &faults, &room);
        CAPTURE(n);
        end = static_cast<int>(model.calls.size());
        if (refusal == C2D_OK && status != C2D_OK) wrong = true; // of itself
        if (wrong || refusal == C2D_OK) break;
        if (n >= end) break; // the deck makes fewer calls
        CAPTURE(model.calls[static_cast<size_t>(n)].name);
        refused.insert(model.calls[static_cast<size_t>(n)].name);
        CHECK(status == refusal);
        if (refusal == C2D_ERR_LIMIT) {
          CHECK(end == n + 1); // nothing more is asked of it
          end = n + 2;
        }
      }
  }
  CHECK(refused.size() > 12);
}

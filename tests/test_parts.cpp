// A library compiled with C2D_PARTS_BY_CALL: a program has the parts whose calls it names, and is told of the others
// where a deck, an option, a workspace or a saved state wants one. (The bytes: test_embedded.cpp.)
#include "deck_recorder.hpp"
#include "many_bodies.hpp"
#include "memory/parts.hpp"
#include "model/model.hpp"
#include "paths.hpp"
#include "shell.hpp"
#include "solver_runs.hpp"

#include <c2d_posix.h>
#include <doctest/doctest.h>

using namespace test;

namespace {

struct Part {
  const char* card;
  const char* call;
  int columns; // of the keyword
};
const Part kParts[] = {{"*RIGID", "c2d_set_rigid", 6},
                       {"*Body Force 1 1 0.0 -1.0", "c2d_set_body_force", 5},
                       {"*SYMMETRY X 0.0", "c2d_set_symmetry", 9},
                       {"*ZONE 3 3 1 1", "c2d_link_free_zones", 5}};

std::string needs(const std::string& what, const std::string& call) {
  return what + " needs a part of the library that this program does not link (C2D_PARTS_BY_CALL): " + call + " links it\n";
}
// What the deck reader says at a card of a part that is not there.
std::string missing(const Part& part) {
  std::string name;
  for (const char* c = part.card + 1; *c != '\0' && !(*c >= '0' && *c <= '9'); ++c) name += c2d::capital(*c);
  if (name.compare(0, 8, "SYMMETRY") == 0) name = "SYMMETRY";
  while (name.back() == ' ') name.pop_back();
  const std::string line = needs("*" + name, part.call);
  return line.substr(0, line.size() - 1);
}

} // namespace

TEST_CASE("parts: a keyword whose part is not linked is a fault of its card, and its cards are passed over") {
  for (const Part& part : kParts) {
    CAPTURE(part.card);
    std::vector<std::string> lines = deck_test::squares();
    const int line = static_cast<int>(lines.size()) + 1;
    lines.insert(lines.end(), {part.card, "1 2 3", "*UNITS mm N"});
    deck_test::Bytes deck;
    deck.bytes = deck_test::joined(lines);
    deck_test::Recorder model;
    c2d::DeckSink sink = deck_test::recording_sink(model);
    sink.set_rigid = nullptr;
    sink.set_body_force = nullptr;
    sink.set_symmetry = nullptr;
    sink.has_free_zones = false;
    std::vector<deck_test::Fault> faults;
    host::Limits room;
    CHECK(c2d::read_deck_cards(&sink, deck_test::read_bytes, &deck, deck_test::keep_fault, &faults, &room) == C2D_ERR_INPUT);
    REQUIRE(faults.size() == 1);
    CHECK(faults[0].text == missing(part));
    CHECK(faults[0].line == line);
    CHECK(faults[0].column == 1);
    CHECK(faults[0].column_end == part.columns);
    CHECK(faults[0].status == C2D_ERR_INPUT);
    CHECK(model.units == "mm N");
  }
}

TEST_CASE("parts: an empty table does nothing, says nothing is there, and refuses what has a status") {
  const c2d::EnergyPart energies;
  CHECK_FALSE(energies.linked);
  CHECK(energies.build_energy(nullptr) == C2D_ERR_INTERNAL);
  CHECK((energies.work_by_case(nullptr) == nullptr));
  const c2d::SymmetryPart symmetry;
  c2d::ModelHeader head;
  double p[2] = {-1.0, 2.0};
  symmetry.fold_across(head, p);
  CHECK(p[0] == -1.0);
  CHECK((symmetry.set_symmetry == nullptr));
}

TEST_CASE("parts: a file of the core that calls through a table says so, but where the part is brought") {
  int seen = 0;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(paths::root()) / "src")) {
    if (entry.path().extension() != ".cpp") continue;
    const std::string text = read_file(entry.path().string());
    for (const char* name : {"SymmetryPart", "FreeZonePart", "BodyForcePart", "RigidPart", "EnergyPart", "NewLoadsPart",
                             "WarningPart", "SearchPart", "HolePart", "CurvePart", "CompressedPart", "RingPart"}) {
      const std::string part = name;
      if (!contains(text, "k" + part + ".")) continue;
      ++seen;
      CHECK_MESSAGE((contains(text, "C2D_USES(" + part + ")") || contains(text, "C2D_MEETS(" + part + ",") ||
                     (part == "EnergyPart" && contains(text, "C2D_BRINGS(c2d_get_summary)"))),
                    entry.path() << " calls through k" << part);
    }
  }
  CHECK(seen > 25);
}

#if defined(__ELF__)
namespace {

// The program of tests/embedded/parts.cpp: the files that C2D_PARTS_BY_CALL changes in place of the library's own.
class Program {
public:
  explicit Program(const std::string& calls = "") {
    const std::string root = paths::root();
    std::string command = "cd '" + root + "' && " + paths::cxx_compiler() +
                          " -std=c++17 -Wall -Wextra -Werror -ffp-contract=off " + calls +
                          " -DC2D_PARTS_BY_CALL -Isrc -Iinclude -Iport/posix tests/embedded/parts.cpp";
    for (const char* file : {"interface/read_deck", "interface/model/model_calls", "interface/attach", "interface/save_calls",
                             "interface/model/zone_calls", "interface/advance", "solver/save"})
      command += std::string(" src/") + file + ".cpp";
    built_ = run_shell(command + " '" + paths::library() + "' -lm -pthread -o '" + (folder_ / "parts") + "'");
    // A build that counts branches reads the counters with the program (tests/coverage).
    const std::string kept = paths::build() + "/counted";
    if (std::getenv("LLVM_PROFILE_FILE") == nullptr || built_.status != 0) return;
    fs::create_directories(kept);
    fs::copy_file(folder_ / "parts", kept + (calls.empty() ? "/without_parts" : "/with_parts"),
                  fs::copy_options::overwrite_existing);
  }
  const Result& built() const { return built_; }
  std::string operator/(const std::string& name) const { return folder_ / name; }
  std::string path() const { return folder_.path(); }
  std::string run(const std::string& arguments) const {
    const Result result = run_shell("cd '" + folder_.path() + "' && ./parts " + arguments);
    CHECK_MESSAGE(result.status == 0, arguments << "\n" << result.out << result.err);
    return result.out;
  }

private:
  Folder folder_;
  Result built_;
};

// A ring on its lower side.
std::string ring_deck() {
  many::Model m;
  m.plane = C2D_AXISYMMETRIC;
  m.add(many::rectangle(1, 0, 2, 1, {1, 1, 1, 1}));
  m.set(1, 1, many::end_of("0110"));
  std::vector<int32_t> order;
  return many::deck_of(m, "RING", order);
}

std::string deck_with(const std::string& card) { return deck_test::joined(deck_test::squares()) + card + "\n"; }

// The two squares with a free zone in place of their pairs.
std::string free_zone_deck() {
  std::vector<std::string> lines = deck_test::squares();
  lines[3] = "    2    0    2";
  const auto zone = std::find(lines.begin(), lines.end(), "    1    2    2    1");
  REQUIRE(zone != lines.end());
  zone[3] = zone[4] = "    0    0"; // nodes and elements of each body
  lines.erase(zone, zone + 3);
  lines.push_back("*ZONE 3 3 1 1");
  return deck_test::joined(lines);
}

// A plate of two closed curves.
const char kHoleDeck[] =
    "*FREE\n1\nPLATE WITH A HOLE\n0 0\n1 0 2\n2 2 8 8\n1 4\n5 8\n1000 0.3\n1 0\n0 0\n1 0 0\n2 4 0\n3 4 4\n4 0 4\n"
    "5 1 1\n6 1 3\n7 3 3\n8 3 1\n0\n0\n0 0\n1 50\n1 1\n";

// A solver of this program, which has every part, in a workspace of its own.
struct Whole {
  std::vector<unsigned char> memory;
  c2d_solver* solver = nullptr;
  Whole(const std::string& text, const c2d_port* port, bool images = false) {
    runs::Deck deck;
    deck.lines = deck_test::lines_of(text);
    const host::Limits limits = deck.limits();
    uint64_t least = 0;
    REQUIRE(c2d_memory_need(&limits, &least, nullptr, nullptr) == C2D_OK);
    memory.resize(static_cast<size_t>(least));
    REQUIRE(c2d_create(&solver, memory.data(), memory.size(), &limits, port, nullptr) == C2D_OK);
    c2d_options options = C2D_INIT(c2d_options);
    options.symmetry = images ? C2D_SYMMETRY_IMAGES : C2D_SYMMETRY_DECK;
    REQUIRE(c2d_set_options(solver, &options) == C2D_OK);
    c2d_error why = C2D_INIT(c2d_error);
    const c2d_status status = runs::read_deck(solver, deck);
    c2d_last_error(solver, &why);
    REQUIRE_MESSAGE(status == C2D_OK, why.text);
  }
  void write(const std::string& name) const {
    write_file(name, std::string(reinterpret_cast<const char*>(memory.data()), memory.size()));
  }
};

std::string status_line(c2d_status status) { return "status " + std::to_string(status) + "\n"; }

} // namespace

TEST_CASE("parts: a program without them, and the same with their calls") {
  if (paths::sanitized() || !has_command("nm")) return;
  const Program without;
  REQUIRE_MESSAGE(without.built().status == 0, without.built().err);
  const Program with("-Wl,-u,c2d_set_rigid -Wl,-u,c2d_set_body_force -Wl,-u,c2d_set_symmetry -Wl,-u,c2d_link_free_zones "
                     "-Wl,-u,c2d_get_summary -Wl,-u,c2d_link_search -Wl,-u,c2d_link_holes -Wl,-u,c2d_link_compressed "
                     "-Wl,-u,c2d_link_axisymmetric");
  REQUIRE_MESSAGE(with.built().status == 0, with.built().err);
  const std::string names = run_shell("nm '" + (without / "parts") + "'").out;
  for (const char* call : {"T c2d_set_rigid", "T c2d_set_body_force", "T c2d_set_symmetry", "T c2d_link_free_zones",
                           "T c2d_get_summary", "T c2d_link_search", "T c2d_link_warnings", "T c2d_link_holes"})
    CHECK_FALSE(contains(names, call));

  SUBCASE("decks") {
    for (const Program* program : {&without, &with}) {
      write_file(*program / "plain.dat", deck_with("*UNITS mm N"));
      CHECK(program->run("deck plain.dat") == status_line(C2D_OK));
    }
    for (const Part& part : kParts) {
      write_file(without / "deck.dat", deck_with(part.card));
      const std::string told = without.run("deck deck.dat");
      CHECK_MESSAGE(contains(told, "columns 1-" + std::to_string(part.columns) + ": " + missing(part) + "\n"), told);
      CHECK_MESSAGE(contains(told, status_line(C2D_ERR_INPUT)), told);
      write_file(with / "deck.dat", deck_with(part.card)); // whatever the model's faults are
      CHECK_FALSE(contains(with.run("deck deck.dat"), "C2D_PARTS_BY_CALL"));
    }
  }
  SUBCASE("holes") {
    write_file(without / "deck.dat", kHoleDeck);
    write_file(with / "deck.dat", kHoleDeck);
    const std::string told = without.run("deck deck.dat");
    CHECK_MESSAGE(contains(told, needs("more than one region", "c2d_link_holes")), told);
    CHECK(contains(told, status_line(C2D_ERR_INPUT)));
    CHECK(with.run("deck deck.dat") == status_line(C2D_OK));
  }
  if (c2d::kRings) {
    SUBCASE("bodies of revolution") {
      write_file(without / "deck.dat", ring_deck());
      write_file(with / "deck.dat", ring_deck());
      const std::string told = without.run("deck deck.dat");
      CHECK_MESSAGE(contains(told, needs("a body of revolution", "c2d_link_axisymmetric")), told);
      CHECK(contains(told, status_line(C2D_ERR_INPUT)));
      CHECK(with.run("deck deck.dat") == status_line(C2D_OK));
    }
  }
  SUBCASE("options") {
    CHECK(without.run("images") == needs("symmetry by images", "c2d_set_symmetry") + status_line(C2D_ERR_ARGUMENT));
    CHECK(with.run("images") == status_line(C2D_OK));
    CHECK(without.run("compressed") ==
          "this program is linked without compressed elimination: c2d_link_compressed links it, but "
          "not in small code\n" +
              status_line(C2D_ERR_ARGUMENT));
    if (!c2d::kSmallCode) CHECK(with.run("compressed") == status_line(C2D_OK));
    CHECK(without.run("free") == needs("a free zone", "c2d_link_free_zones") + status_line(C2D_ERR_ARGUMENT));
    CHECK(with.run("free") == status_line(C2D_OK));
  }
  SUBCASE("workspaces of another program") {
    const auto refused = [](const char* call) {
      return std::string("the solver in this memory needs a part of the library that this program does not link "
                         "(C2D_PARTS_BY_CALL); it is linked by ") +
             call + '\n' + status_line(C2D_ERR_MISMATCH);
    };
    const struct {
      std::string deck;
      bool images;
      const char* call;
    } models[] = {{deck_with("*UNITS mm N"), false, nullptr},
                  {deck_with("*BODY FORCE 1 1 0.0 -1.0"), false, "c2d_set_body_force"},
                  {deck_with("*RIGID"), false, "c2d_set_rigid"},
                  {read_file(made("hertz")), false, "c2d_set_symmetry"},
                  {free_zone_deck(), false, "c2d_link_free_zones"},
                  {kHoleDeck, false, "c2d_link_holes"},
                  {read_file(paths::root() + "/tests/data/decks/plate.dat"), true, "c2d_set_symmetry"}};
    for (const auto& model : models) {
      Whole whole(model.deck, nullptr, model.images);
      whole.write(without / "workspace");
      whole.write(with / "workspace");
      CHECK(without.run("attach workspace") == (model.call == nullptr ? status_line(C2D_OK) : refused(model.call)));
      CHECK(with.run("attach workspace") == status_line(C2D_OK));
    }
    if (c2d::kRings) {
      Whole ring(ring_deck(), nullptr);
      ring.write(without / "workspace");
      ring.write(with / "workspace");
      CHECK(without.run("attach workspace") == refused("c2d_link_axisymmetric"));
      CHECK(with.run("attach workspace") == status_line(C2D_OK));
    }
    Whole compressed(deck_with(""), nullptr);
    c2d_options options = C2D_INIT(c2d_options);
    options.elimination = C2D_ELIMINATION_COMPRESSED;
    if (c2d_set_options(compressed.solver, &options) == C2D_OK) { // (not in small code)
      compressed.write(without / "workspace");
      compressed.write(with / "workspace");
      CHECK(without.run("attach workspace") == refused("c2d_link_compressed"));
      CHECK(with.run("attach workspace") == status_line(C2D_OK));
    }
    // A prepared one keeps energies, which a program without them would let go stale.
    runs::RamStore store;
    c2d_port port = C2D_INIT(c2d_port);
    store.serve(port);
    Whole whole(deck_with(""), &port);
    REQUIRE(c2d_prepare(whole.solver) == C2D_OK);
    whole.write(without / "workspace");
    CHECK(without.run("attach workspace") == refused("c2d_get_summary"));
  }
  SUBCASE("saved states of another program") {
    const std::string text = deck_with("");
    write_file(without / "deck.dat", text);
    write_file(with / "deck.dat", text);
    for (const Program* program : {&without, &with}) {
      c2d_posix_store store;
      c2d_port port = C2D_INIT(c2d_port);
      REQUIRE(c2d_posix_store_init(&store, (*program / "tapes").c_str()) == 0);
      c2d_posix_store_port(&store, &port);
      Whole whole(text, &port);
      REQUIRE(c2d_prepare(whole.solver) == C2D_OK);
      REQUIRE(c2d_save(whole.solver) == C2D_OK);
      REQUIRE(c2d_close(whole.solver) == C2D_OK);
      REQUIRE(c2d_posix_store_done(&store) == 0);
    }
    CHECK(contains(without.run("restore deck.dat tapes"), status_line(C2D_ERR_MISMATCH)));
    CHECK(with.run("restore deck.dat tapes") == status_line(C2D_OK));
  }
  // A program that changed the loads leaves factors that one without new loads does not know to use: it begins anew.
  SUBCASE("factors of another program") {
    write_file(with / "deck.dat", read_file(paths::root() + "/examples/hertz.dat"));
    c2d_posix_store store;
    c2d_port port = C2D_INIT(c2d_port);
    REQUIRE(c2d_posix_store_init(&store, (with / "tapes").c_str()) == 0);
    c2d_posix_store_port(&store, &port);
    Whole whole(read_file(with / "deck.dat"), &port);
    c2d_options options = C2D_INIT(c2d_options);
    options.keep_factors = 1;
    REQUIRE(c2d_set_options(whole.solver, &options) == C2D_OK);
    REQUIRE(c2d_prepare(whole.solver) == C2D_OK);
    REQUIRE(c2d_change_loads(whole.solver) == C2D_OK);
    whole.write(with / "workspace");
    REQUIRE(c2d_posix_store_done(&store) == 0);
    const std::string told = with.run("prepare workspace tapes 0.3 1");
    CHECK(contains(told, "outcome 0\n"));
    CHECK(contains(with.run("follow deck.dat others 0.3 1"), told)); // (which reading the deck warns before)
  }
  // Without search and proofs a path ends undecided where rounds of changes lead nowhere; it never takes another way.
  SUBCASE("paths") {
    const auto follow = [](const Program& program, const char* deck, const char* mu) {
      return program.run("follow '" + paths::root() + "/" + std::string(deck) + "' tapes " + mu + " 1");
    };
    const auto ends = [](const std::string& told, c2d_outcome outcome) {
      return contains(told, "outcome " + std::to_string(outcome) + "\n");
    };
    const char* const arc = "tests/data/hard/D4_no_rows_arc.dat";
    const char* const hertz = "examples/hertz.dat";
    CHECK(ends(follow(with, arc, "0.3"), C2D_GROSS_SLIDING));
    CHECK(ends(follow(without, arc, "0.3"), C2D_UNDECIDED));
    CHECK(ends(follow(with, hertz, "0.4"), C2D_REACHED));
    CHECK(follow(without, hertz, "0.4") == follow(with, hertz, "0.4"));
    const char* const strip = "tests/data/hard/D9_strip_1e-05_nf3.dat";
    const std::string warning = "warning " + std::to_string(C2D_WARN_CONDITION) + "\n";
    CHECK(follow(with, strip, "0.3") == warning + follow(without, strip, "0.3"));
    // Without energies nothing is known of what friction took, and what does not keep them may be taken up without them.
    for (const Program* program : {&without, &with}) {
      const std::string told = program->run("state '" + paths::root() + "/" + hertz + "' tapes 0.05 1");
      CAPTURE(told);
      CHECK(contains(told, std::string("slips 1, dissipated ") + (program == &with ? "more" : "nothing") + "\n"));
      CHECK(contains(told, status_line(C2D_OK)));
    }
  }
}
#endif

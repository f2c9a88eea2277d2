// Words, points and shares of work that the program reads or tells, at the ends of what they may be.
#include "paths.hpp"
#include "shell.hpp"

#include "program/estimate/mesh/keyword_cards.hpp"
#include "program/exit_code.hpp"
#include "program/files/deck_file.hpp"
#include "program/files/points_file.hpp"
#include "program/files/store_choice.hpp"
#include "program/option_table.hpp"
#include "program/options.hpp"
#include "program/progress.hpp"
#include "program/sweep/responses.hpp"
#include "program/sweep/table.hpp"
#include "program/words/real_in_columns.hpp"
#include "program/words/voice.hpp"

#include <cstdlib>
#include <cstring>
#include <doctest/doctest.h>

using namespace test;

namespace {

std::string fault_of(const std::vector<const char*>& words, app::Options& options) {
  std::vector<const char*> argv = {"contact2d"};
  argv.insert(argv.end(), words.begin(), words.end());
  std::string error;
  options = app::Options();
  return app::read_options(static_cast<int>(argv.size()), argv.data(), options, error) ? "" : error;
}

} // namespace

TEST_CASE("options: sizes of memory in all their units") {
  const struct {
    const char* text;
    uint64_t bytes; // 0: refused
  } cases[] = {{"64", 64},       {"64B", 64},
               {"2k", 2048},     {"2KB", 2048},
               {"2KiB", 2048},   {"3m", 3u << 20},
               {"1G", 1u << 30}, {"1TiB", 1ull << 40},
               {"1GBB", 0},      {"1KIX", 0},
               {"1XIB", 0},      {"1KX", 0},
               {"1X", 0},        {"KB", 0},
               {"", 0},          {"-1", 0},
               {"16777216T", 0}, {"99999999999999999999", 0}};
  for (const auto& c : cases) {
    CAPTURE(c.text);
    uint64_t bytes = 7;
    CHECK(app::read_size(c.text, bytes) == (c.bytes != 0));
    CHECK(bytes == (c.bytes != 0 ? c.bytes : 7));
  }
}

TEST_CASE("options: numbers that are none, or out of their range") {
  app::Options o;
  for (const char* wrong : {"0", "65", "2x", "x", "-1"}) {
    CAPTURE(wrong);
    CHECK(fault_of({"run", "deck", "--threads", wrong}, o).find("expected a whole number from 1 to 64") != std::string::npos);
  }
  for (const char* wrong : {"0", "-1", "1x", "x", "1e100", "1e999"}) {
    CAPTURE(wrong);
    CHECK(fault_of({"sketch", "drawing.dxf", "--join", wrong}, o).find("expected a distance above 0") != std::string::npos);
  }
  CHECK(fault_of({"sketch", "drawing.dxf", "--join", "0.5"}, o) == "");
  CHECK(o.join == 0.5);
  for (const char* wrong : {"-1", "1e10", "1x", "x"}) {
    CAPTURE(wrong);
    CHECK(fault_of({"run", "deck", "--store", "file:d", "--save-every", wrong}, o)
              .find("expected a number of seconds, 0 or more") != std::string::npos);
  }
}

TEST_CASE("options: what --out leaves to names that are given") {
  app::Options o;
  REQUIRE(fault_of({"run", "deck", "--out", "all", "--figures", "mine", "--interior", "i.csv"}, o) == "");
  CHECK(o.figures == "mine");
  CHECK(o.file(app::Output::kInterior) == "i.csv");
  CHECK_FALSE(o.interior_if_any);
  REQUIRE(fault_of({"run", "deck", "--out", "all"}, o) == "");
  CHECK(o.figures == "all/figures");
  CHECK(o.interior_if_any);
  REQUIRE(fault_of({"run", "deck", "--points", "p.csv", "--vtk", "v.vtk"}, o) == ""); // seen there
  CHECK(fault_of({"run", "deck", "--points", "p.csv", "--quiet"}, o) != "");
  REQUIRE(fault_of({"run", "deck", "--quiet", "--listing", "a.lst"}, o) == "");
  CHECK(app::has_listing(o));
}

TEST_CASE("options: what is asked of a run, and how it may be told") {
  app::Options o;
  CHECK(fault_of({"run", "deck", "--response", "max nothing"}, o).find("--response 'max nothing': expected max or min of tn") ==
        0);
  CHECK(fault_of({"run", "deck", "--response", " ; "}, o).find("--response no response is given") == 0);
  for (const char* none :
       {"contact edge 1x", "contact edge 0", "contact edge 1 2", "max tn zone 1 zone 2", "big tn", "stress", "stress 1 zone 2",
        "load zone 1", "load 2", "max tn 3", "max tn zone", "zone 1", "touching 1", "tn max", "max min tn"}) {
    CAPTURE(none);
    std::vector<app::Response> responses;
    std::string error;
    CHECK_FALSE(app::read_responses(none, responses, error));
    CHECK(error.find(none) == 1);
    CHECK(responses.empty());
  }
  CHECK(fault_of({"run", "deck", "--quiet", "--ranges", "r.csv", "--points", "p.csv"}, o) == "");
  std::string error;
  CHECK_FALSE(app::read_options(0, nullptr, o, error));
  CHECK(error != "");
  o = app::Options();
  o.command = app::Command::kSweep;
  CHECK_FALSE(app::has_listing(o));
  for (const app::OptionRow& option : app::all_options()) // zsh's completion would take brackets for its own
    CHECK(std::string(option.help).find_first_of("[]") == std::string::npos);
}

TEST_CASE("responses: numbers of pairs, zones and points that are there, and that are not") {
  const auto value = [](const std::string& text, const app::RunRecord& record) {
    std::vector<app::Response> responses;
    std::string error;
    REQUIRE(app::read_responses(text, responses, error));
    return app::csv_number(app::evaluate(responses.at(0), record));
  };
  app::RunRecord record;
  CHECK(value("max tn", record) == ""); // nothing was followed
  CHECK(value("stress 1", record) == "");
  app::CoefficientRecord c;
  c.load = 0.5;
  c.table.resize(3 * C2D_PAIR_FIELDS);
  const double tn[3] = {-3, 2, -1};
  for (size_t i = 0; i < 3; ++i) {
    double* row = c.table.data() + i * C2D_PAIR_FIELDS;
    row[C2D_TN] = tn[i], row[C2D_PAIR_ZONE] = i == 0 ? 1 : 2, row[C2D_STATUS] = i == 2 ? C2D_OPEN : C2D_STICK;
  }
  record.coefficients = {c};
  CHECK(value("tn", record) == "3");
  CHECK(value("max tn", record) == "2");
  CHECK(value("min tn", record) == "-3");
  CHECK(value("min tn zone 2", record) == "-1");
  CHECK(value("touching", record) == "2");
  CHECK(value("sticking zone 2", record) == "1");
  CHECK(value("slipping", record) == "0");
  CHECK(value("max tn zone 3", record) == "");
  CHECK(value("load", record) == "0.5");
  const std::string edge = app::name_of(app::Measure::kContactEdge);
  CHECK(value(edge, record) == ""); // no increment
  app::StepRecord step;
  const double where[4][3] = {{1, 1, 0.25}, {1, 2, 0.75}, {2, 1, 4}, {2, 2, 5}}; // zone, item, value
  for (const auto& w : where) {
    app::Quantity q;
    q.what = app::Measure::kContactEdge, q.zone = static_cast<int32_t>(w[0]), q.item = static_cast<int32_t>(w[1]);
    q.value = w[2];
    step.quantities.push_back(q);
  }
  record.coefficients[0].steps = {step};
  CHECK(value(edge, record) == "0.25");
  CHECK(value(edge + " 2", record) == "0.75");
  CHECK(value(edge + " zone 2", record) == "4");
  CHECK(value(edge + " 2 zone 2", record) == "5");
  CHECK(value(edge + " zone 2 2", record) == "5");
  CHECK(value(edge + " 3", record) == "");
  app::Interior interior;
  interior.points.resize(2);
  interior.points[0].values[C2D_POINT_VON_MISES] = 7;
  interior.points[0].values[C2D_POINT_FLAG] = C2D_POINT_INSIDE;
  interior.points[1].values[C2D_POINT_FLAG] = C2D_POINT_OUTSIDE;
  record.interior = &interior;
  CHECK(value("stress 1", record) == "7");
  CHECK(value("stress 2", record) == "");
  CHECK(value("stress 3", record) == "");
  std::vector<app::Response> both;
  std::string error;
  REQUIRE(app::read_responses("load; stress 3", both, error));
  CHECK(app::results_text(both, {0.5, NAN}) == "0.5 load\nnan stress 3\n"); // a value and its words
  CHECK(app::failure_text("") == "FAIL reason unknown\n");
  CHECK(app::failure_text("\nwhy") == "FAIL reason unknown\n");
  CHECK(app::csv_field("a \"b\"") == "\"a \"\"b\"\"\"");
}

TEST_CASE("responses: numbers that a sketch requests, by the names of the listing, with places and planes") {
  app::RunRecord record;
  const auto add = [&](app::Measure what, const std::string& of, double value, double x, double angle = NAN) {
    app::Stated s;
    s.what = what, s.of = of, s.body = 1, s.value = value, s.at[0] = x, s.at[1] = -x, s.angle = angle;
    record.meshes.stated.push_back(s);
  };
  add(app::Measure::kTractions, "", 0, NAN);
  add(app::Measure::kSwt, " of top", 1, 10, 45);
  add(app::Measure::kSwt, " of top at depth 2", 2, 20, 60);
  add(app::Measure::kSwt, " of x", 3, 30, 75);
  add(app::Measure::kStressXX, "", 4, 40);
  add(app::Measure::kStressXX, "", 5, 50);
  add(app::Measure::kLargestAlong, "hole", 6, 60);
  add(app::Measure::kCrackRange, " of top, depth 0.1", 7, 70);
  add(app::Measure::kCycleDissipated, "", 8, NAN);
  const struct {
    const char* words;
    double value;
  } cases[] = {{"SWT of top", 1},
               {"SWT of top x", 10},
               {"SWT of top plane", 45},
               {"SWT of top at depth 2", 2}, // not the second of its name
               {"SWT of top at depth 2 y", -20},
               {"SWT of x", 3}, // not a place
               {"SWT of x x", 30},
               {"SWT of x plane", 75},
               {"stress xx", 4},
               {"stress xx 2", 5},
               {"stress xx 2 x", 50},
               {"stress xx 3", NAN},
               {"largest stress along hole", 6},
               {"largest stress along hole plane", NAN},
               {"largest stress along slot", NAN},
               {"crack range of K of top, depth 0.1", 7},
               {"dissipated in the last cycle", 8},
               {"dissipated in the last cycle x", NAN},
               {"tractions", NAN}}; // it has no value
  for (const auto& c : cases) {
    CAPTURE(c.words);
    std::vector<app::Response> responses;
    std::string error;
    REQUIRE_MESSAGE(app::read_responses(c.words, responses, error), error);
    CHECK(responses.at(0).words == c.words);
    const double value = app::evaluate(responses.at(0), record);
    CHECK((std::isnan(c.value) ? std::isnan(value) : value == c.value));
  }
  for (const char* none : {"SWT on top", "of top", "plane", "stress zx", "dissipated in the last cycle plain"}) {
    CAPTURE(none);
    std::vector<app::Response> responses;
    std::string error;
    CHECK_FALSE(app::read_responses(none, responses, error));
    CHECK(error.find(none) == 1);
  }
  // Of a fatigue parameter, a worst case; a depth is part of the name.
  record.meshes.tolerances.parameters = {{"R", 5, 0.5, ""}};
  for (const app::Stated& s : record.meshes.stated)
    record.meshes.tolerances.numbers.push_back(app::Toleranced{s, {{2 * s.value, ""}}});
  std::vector<app::Response> worst;
  std::string error;
  REQUIRE(app::read_responses("worst case SWT of top; derivative SWT of top at depth 2 by R", worst, error));
  CHECK(app::evaluate(worst[0], record) == 1);
  CHECK(app::evaluate(worst[1], record) == 4);
}

TEST_CASE("sweep: cells of a table with blanks, tabs and quotes around them") {
  const app::Muted muted;
  const auto read = [](const std::string& text) {
    app::DeckFile file;
    file.replace(text);
    app::Messages messages(file);
    app::SweepTable table;
    return app::read_table(file, {"a", "b"}, messages, table) ? table : app::SweepTable();
  };
  const app::SweepTable table = read("\xef\xbb\xbf a\t,\t\"b\" \n\n,,\n 1 , \"2\"\t\r\n");
  CHECK(table.names == std::vector<std::string>{"a", "b"});
  REQUIRE(table.rows.size() == 1);
  CHECK(table.rows[0] == std::vector<std::string>{"1", "2"});
  CHECK(read("a,b\n1,\"\"\n").rows.empty()); // no value
  CHECK(read("a,b\n1,\"\n").rows.empty());
}

TEST_CASE("keyword cards: words as the deck reader takes them") {
  using Words = std::vector<std::string>;
  CHECK(estimate::words_of("*zone,,3 \t4 ! five") == Words{"*zone", "0", "3", "4"});
  CHECK(estimate::words_of("  ") == Words{});
  CHECK_FALSE(estimate::is_keyword({}, "*ZONE"));
  CHECK(estimate::is_keyword({"*zOnE"}, "*ZONE"));
  CHECK_FALSE(estimate::is_keyword({"*zon{"}, "*ZONE"));
  estimate::CutBody square;
  square.element_nodes = square.function_nodes = 2;
  square.regions = {{0, 3, false}};
  square.in_contact.assign(4, false);
  for (int32_t i = 0; i <= 4; ++i) square.children.push_back(2 * i);
  const estimate::FreeZoneCard self = estimate::free_zone_card({"*ZONE", "+1", "1", "3", "3", "BODIES", "1", "-1"}, {0});
  CHECK(self.is_self);
  CHECK(estimate::free_zone_card(self, {square}) == "*ZONE BODIES 1 -1 1 2 5 6");
  CHECK(estimate::platen_card({"*PLATEN", "1", "2", "2"}, {0}, {square}) == "*PLATEN 1 3 4 0 0");
  CHECK(estimate::platen_card({"*PLATEN", "1", "2", "2", ".5", "1", "1"}, {0}, {square}) == "*PLATEN 1 3 4 .5 1 2");
}

TEST_CASE("exit statuses: of every kind of failed call") {
  const int expected[][2] = {
      {C2D_OK, 0},        {C2D_ERR_MEMORY, 4}, {C2D_ERR_OVERFLOW, 4}, {C2D_ERR_CANCELLED, 130}, {C2D_ERR_SINGULAR, 1},
      {C2D_ERR_INPUT, 2}, {C2D_ERR_LIMIT, 2},  {C2D_ERR_READ, 2},     {C2D_ERR_STORE_READ, 3},  {C2D_ERR_STATE, 3}};
  for (const auto& e : expected) CHECK(app::exit_code(e[0]) == e[1]);
}

// In memory as far as the budget goes, and in files beyond; what is too large for either is refused.
TEST_CASE("store choice: tapes go where there is room, and what goes wrong is told") {
  std::string error;
  unsigned char block[64] = {1, 2, 3}, back[64] = {};
  int32_t ticket = 0;
  {
    app::StoreChoice store;
    REQUIRE(store.choose("memory", 1000, false, error));
    CHECK(store.open(-1, 1, 64) != 0);
    const int32_t none = store.open(C2D_TAPES, 1, 64);
    CHECK(store.system_text(none) == "no such tape");
    REQUIRE(store.open(0, 4, 64) == 0);
    CHECK(store.start_write(0, 3, block, 64, &ticket) == 0);
    CHECK(store.wait(ticket) == 0);
    CHECK(store.start_read(0, 3, back, 64, &ticket) == 0);
    CHECK(store.wait(ticket) == 0);
    CHECK(std::memcmp(block, back, 64) == 0);
    CHECK(store.file_of(0) == "");
    CHECK(store.close(0) == 0);
    REQUIRE(store.open(0, 8, 64) == 0); // more than it had
    CHECK(store.sync(0) == 0);
  }
  const Folder folder;
  app::StoreChoice store;
  const char* before = std::getenv("TMPDIR");
  const std::string kept = before != nullptr ? before : "";
  REQUIRE(::setenv("TMPDIR", (folder / "none").c_str(), 1) == 0);
  {
    app::StoreChoice lost;
    REQUIRE(lost.choose("", 100, false, error));
    const int32_t code = lost.open(1, 2, 64);
    CHECK(lost.system_text(code) == "No such file or directory");
    CHECK(contains(lost.file_of(1), folder / "none/contact2d-"));
  }
  fs::create_directory(folder / "tmp");
  REQUIRE(::setenv("TMPDIR", (folder / "tmp").c_str(), 1) == 0);
  REQUIRE(store.choose("", 1000, false, error));
  REQUIRE(store.open(0, 10, 64) == 0); // in memory
  CHECK(store.folder().empty());
  REQUIRE(store.open(1, 10, 64) == 0); // beyond the budget: in a file
  CHECK(contains(store.folder(), folder / "tmp/contact2d-"));
  CHECK(store.file_of(0) == "");
  CHECK(contains(store.file_of(1), "/tape1.c2d"));
  CHECK(store.file_of(-1) == "");
  CHECK(store.file_of(C2D_TAPES) == "");
  CHECK(store.start_write(1, 9, block, 64, &ticket) == 0);
  CHECK(store.wait(ticket) == 0);
  CHECK(store.read(1, 9, back, 64) == 0);
  REQUIRE(store.open(2, 2, 2000) == 0);          // larger than all of it
  CHECK(store.open(3, UINT64_MAX / 2, 64) != 0); // no such number of bytes
  CHECK(store.system_text(-12345) == "error -12345");
  CHECK(store.remove_tapes(error));
  REQUIRE((kept.empty() ? ::unsetenv("TMPDIR") : ::setenv("TMPDIR", kept.c_str(), 1)) == 0);
}

TEST_CASE("deck file: a fault is shown at its place, whatever stands there") {
  app::DeckFile file;
  CHECK(file.heading().empty());
  file.replace("a\tb\x01"
               "c\nlast");
  const auto shown = [&file](int32_t line, int32_t column, int32_t end) {
    c2d_error entry = C2D_INIT(c2d_error);
    entry.line = line, entry.column = column, entry.column_end = end;
    const std::string text = app::quote(file, entry, "error");
    return text.substr(text.find('\n') + 1);
  };
  CHECK(shown(1, 3, 3) == "a\tb?c\n \t^\n");
  CHECK(shown(2, 7, 8) == "last\n      ^~\n"); // behind the end of the card
  CHECK(shown(2, 0, 0) == "last\n^\n");
  CHECK(shown(2, 300, 300) == "last\n    ^\n");
  CHECK(shown(2, 1, 1000) == "last\n^" + std::string(199, '~') + "\n");
}

TEST_CASE("points: rows with tabs and signs, and what is wrong in others") {
  const app::Muted muted;
  const auto faults = [](const std::string& text, int32_t bodies, std::vector<app::WantedPoint>& points) {
    app::DeckFile file;
    file.replace(text);
    app::Messages messages(file);
    points.clear();
    app::forget_reason();
    return app::read_points(file, bodies, messages, points) ? std::string() : app::reason_told();
  };
  std::vector<app::WantedPoint> points;
  CHECK(faults("BODY,X,Y\n+1\t,\t+1.5d0\t,-2D1\n\n", 1, points) == "");
  REQUIRE(points.size() == 1);
  CHECK(points[0].x == 1.5);
  CHECK(points[0].y == -20);
  CHECK(points[0].line == 2);
  const struct {
    const char* text;
    int32_t bodies;
    const char* told;
  } wrong[] = {{"2,0,0\n", 1, "body is '2', expected 1, the only body"},
               {"0,0,0\n", 2, "body is '0', expected 1 or 2"},
               {"4,0,0\n", 3, "body is '4', expected 1 to 3"},
               {"+-1,0,0\n", 1, "body is '+-1', expected 1, the only body"},
               {"+,0,0\n", 1, "body is '+', expected 1, the only body"},
               {"body,y,x\n", 1, "body is 'body', expected 1, the only body"},
               {"body,x,z\n", 1, "body is 'body', expected 1, the only body"},
               {"bod,x,y\n", 1, "body is 'bod', expected 1, the only body"},
               {"1,\x01\xc3,0\n", 1, "x is '\?\?', expected a number"},
               {"1,0,inf\n", 1, "y is 'inf', expected a number"},
               {"1\n", 1, "the row has 1 field, expected 3 separated by commas: body,x,y"},
               {"1,0,0,0\n", 1, "the row has 4 fields, expected 3 separated by commas: body,x,y"}};
  for (const auto& w : wrong) {
    CAPTURE(w.text);
    CHECK(faults(w.text, w.bodies, points) == w.told);
  }
  CHECK(faults("body,x,y\n", 1, points) != ""); // no row at all
}

TEST_CASE("convert: numbers in columns of any width") {
  const struct {
    double value;
    size_t width;
    const char* text;
  } cases[] = {{0, 0, ""},       {0, 5, "0"},     {1e60, 10, "1+60"},  {-1e-60, 10, "-1-60"}, {1e60, 3, ""},
               {12, 2, "12"},    {12, 3, "12"},   {12, 4, "12.0"},     {0.5, 2, ".5"},        {0.5, 3, "0.5"},
               {-0.5, 3, "-.5"}, {123456, 5, ""}, {120000, 4, "12+4"}, {1.25, 10, "1.25"}};
  for (const auto& c : cases) {
    CAPTURE(c.value);
    CAPTURE(c.width);
    CHECK(app::real_in_columns(c.value, c.width) == c.text);
  }
}

TEST_CASE("progress: shares where there is nothing to be done, or nothing is known") {
  app::WorkDone work;
  c2d_progress now = C2D_INIT(c2d_progress);
  now.phase = C2D_PHASE_ASSEMBLE;
  CHECK(work.share(now) == 0); // of no body
  now.phase = C2D_PHASE_CONTACT;
  CHECK(work.share(now) == 0); // of no increment
  app::WorkDone some;
  some.expect({100, 100}, 2, 1);
  now.phase = C2D_PHASE_ASSEMBLE, now.body = 0, now.total = 0;
  CHECK(some.share(now) == 1); // what belongs to no body comes behind them
  now.phase = C2D_PHASE_CONTACT, now.load = 0, now.target = 0;
  CHECK(some.share(now) == 0);
  some.reached(1, 1, 1);
  now.load = 0.5, now.target = 2; // backwards
  CHECK(some.share(now) == 0.5);
  now.load = 5; // beyond
  CHECK(some.share(now) == 1);
}

TEST_CASE("progress: what the line says, and after a while how much longer") {
  app::ProgressLine line(app::Progress::kNever);
  CHECK_FALSE(line.active());
  c2d_progress now = C2D_INIT(c2d_progress);
  now.phase = -1;
  CHECK(line.text(now, 0) == "working");
  now.phase = C2D_PHASES;
  CHECK(line.text(now, 0) == "working");
  now.phase = C2D_PHASE_READ;
  CHECK(line.text(now, 0) == "reading");
  line.work.expect({100}, 4, 1);
  now.phase = C2D_PHASE_CONTACT;
  now.load = 0, now.target = 1;
  CHECK(line.text(now, 10) == "following the load, increment 1 of 4: 0 %");
  CHECK(line.text(now, 12) == "following the load, increment 1 of 4: 0 %"); // nobody knows yet
  line.work.reached(1, 2, 1);
  now.load = 1, now.target = 2;
  CHECK(line.text(now, 14) == "following the load, increment 3 of 4: 50 %, 4 s left");
}

TEST_CASE("program: outputs that go where nothing can be written") {
  const Folder folder;
  const std::string deck = paths::data() + "/decks/sample.dat",
                    run = "'" + paths::program() + "' run '" + deck + "' --no-progress -q ";
  fs::create_directory(folder / "taken");
  const struct {
    std::string words, told;
  } cases[] = {{"--csv '" + (folder / "taken") + "'", folder / "taken: cannot be written: Is a directory"},
               {"--csv '" + (folder / "none/a.csv") + "'", folder / "none/a.csv: cannot be written: No such file or directory"},
               {"--csv '" + deck + "/a.csv'", deck + "/a.csv: cannot be written: Not a directory"},
               {"--csv /dev/full", "/dev/full: write failed: No space left on device"},
               {"--figures '" + deck + "'", deck + ": cannot be written: Not a directory"},
               {"--listing - >/dev/full", "standard output: write failed: No space left on device"},
               {"--listing - >&-", "standard output: cannot be written: Bad file descriptor"}};
  for (const auto& c : cases) {
    CAPTURE(c.words);
    const Result ended = run_shell(run + c.words);
    CHECK(ended.status == 3);
    CHECK_MESSAGE(contains(ended.err, c.told), ended.err);
  }
  for (const char* words : {"check", "make hertz", "--version", "completion bash"}) {
    CAPTURE(words);
    const std::string what = std::string(words) == "check" ? "check '" + deck + "'" : words;
    CHECK(run_shell("'" + paths::program() + "' " + what + " >/dev/full").status == 3);
  }
}

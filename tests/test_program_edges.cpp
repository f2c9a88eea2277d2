// Words, points and shares of work that the program reads or tells, at the ends of what they may be.
#include "paths.hpp"
#include "shell.hpp"

#include "program/options.hpp"
#include "program/points_file.hpp"
#include "program/progress.hpp"
#include "program/real_in_columns.hpp"
#include "program/voice.hpp"

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
               {"1\n", 1, "the row has 1 field, expected 3 with commas between them: body,x,y"},
               {"1,0,0,0\n", 1, "the row has 4 fields, expected 3 with commas between them: body,x,y"}};
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

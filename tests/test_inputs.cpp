// Every output names its inputs, and a run repeated with them gives the same digits; totals of models with lines of symmetry;
// what `check` says of memory.
#include "json.hpp"
#include "paths.hpp"
#include "program/files/sha256.hpp"
#include "program/sweep/parameters.hpp"
#include "program/sweep/row_inputs.hpp"
#include "report/inputs.hpp"
#include "report/totals.hpp"
#include "shell.hpp"

#include <cmath>
#include <doctest/doctest.h>

namespace {

const char kSketch[] =
    "parameter P 8  mu 0.25  half {P/2}\nsymmetry x 1\nbody block E 1000 nu 0.3\nfrom 1 -2\nline base to 3 -2\n"
    "line right to 3 0\nline top to 1 0\nbody pad E 1000 nu 0.3\nfrom 1 0\nline face to 2 0\nline side to 2 1\n"
    "line lid to 1 1\ncontact pad.face block.top mu mu\nfix block.base\ntraction pad.lid x 0 y {-half}\n"
    "steps 2\n";

std::string program() { return "'" + paths::program() + "' "; }

// The value of a key in a text of inputs.
std::string value_of(const std::string& text, const std::string& key) {
  for (const std::string& line : test::lines_of(text))
    if (line.compare(0, key.size() + 3, key + " = ") == 0) return line.substr(key.size() + 3);
  return "none";
}

} // namespace

TEST_CASE("inputs: SHA-256 of the standard's examples, and of a text of several blocks") {
  CHECK(app::sha256_of("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  CHECK(app::sha256_of("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  CHECK(app::sha256_of(std::string(1000, 'a')) == "41edece42d63e8d9bf515a9ba6932e1c20cbc9f5a5d134645adb5db1b9737ea3");
}

TEST_CASE("inputs: numbers are written with the digits that give the same bits") {
  for (const double v : {0.1, 1.0 / 3, 1e-300, 123456789.123456789}) CHECK(std::stod(app::exact_number(v)) == v);
  CHECK(app::exact_number(0.1) == "0.1");
}

TEST_CASE("inputs: of a sketch in listing, JSON, page and beside tables; its friction is its friction") {
  const test::Folder folder;
  const std::string drawn = kSketch + std::string("want forces\n");
  test::write_file(folder / "a.c2s", drawn);
  const std::string in = "cd '" + folder.path() + "' && " + program();
  const test::Result run =
      test::run_shell(in + "run a.c2s P=7.3 --touching 0 --threads 2 --listing l --json j --report r.html --csv "
                           "c.csv --summary s.csv");
  REQUIRE_MESSAGE(run.status == 0, run.err);
  const std::string text = test::read_file(folder / "c.csv.inputs");
  CHECK(text == test::read_file(folder / "s.csv.inputs"));
  CHECK(value_of(text, "file") == "a.c2s");
  CHECK(value_of(text, "sha256") == app::sha256_of(drawn));
  CHECK(value_of(text, "parameter P") == "7.3");
  CHECK(value_of(text, "parameter mu") == "0.25");
  CHECK(value_of(text, "option") == "--touching=0"); // threads change no digit
  CHECK(value_of(text, "build") == app::build_text());
  const test::Json json = test::JsonReader::read(test::read_file(folder / "j"));
  CHECK(json["inputs"]["parameters"]["P"].text == "7.3");
  CHECK(json["inputs"]["files"][0]["sha256"].text == app::sha256_of(drawn));
  CHECK((json["mu"][0].number == 0.25 && json["runs"][0]["mu"].number == 0.25 && json["zones"][0]["mu"].number == 0.25));
  const std::string listing = test::read_file(folder / "l"), page = test::read_file(folder / "r.html");
  for (const std::string& each : {listing, page}) {
    CHECK(test::contains(each, app::sha256_of(drawn)));
    CHECK(test::contains(each, "parameter P"));
    CHECK(test::contains(each, "lines of symmetry"));
  }
  const std::string table = test::read_file(folder / "c.csv");
  CHECK(table.compare(0, 8, "mu,step,") == 0);
  // The sketch with these values in its statements gives the same table.
  std::string again = drawn;
  again.replace(again.find("P 8"), 3, "P " + value_of(text, "parameter P"));
  test::write_file(folder / "b.c2s", again);
  REQUIRE(test::run_shell(in + "run b.c2s --csv d.csv").status == 0);
  CHECK(test::read_file(folder / "d.csv") == table);
}

TEST_CASE("inputs: contacts with frictions of their own, and with one that is infinite") {
  const test::Folder folder;
  const std::string other =
      "body foot E 1000 nu 0.3\nfrom 4 0\nline face to 5 0\nline side to 5 1\nline lid to 4 1\nline in close\n"
      "body floor E 1000 nu 0.3\nfrom 4 -1\nline base to 5 -1\nline right to 5 0\nline top to 4 0\nline left "
      "close\nfix floor.base\ntraction foot.lid x 0 y -1\n";
  const auto coefficients = [&](const std::string& contact) {
    test::write_file(folder / "a.c2s", kSketch + other + contact + "tolerance off\n");
    const test::Result run = test::run_shell(program() + "mesh '" + (folder / "a.c2s") + "'");
    const size_t at = run.out.find("! coefficients of friction\n") + 27;
    return run.out.substr(at, run.out.find('\n', at) - at) + (test::contains(run.out, "*FRICTION") ? ", *FRICTION" : "");
  };
  CHECK(coefficients("contact foot.face floor.top mu 0.25\n") == "1 0.25");
  CHECK(coefficients("contact foot.face floor.top mu 0.5\n") == "1 0, *FRICTION");
  CHECK(coefficients("tie foot.face floor.top\n") == "1 0.25");
}

TEST_CASE("inputs: values of a deck's parameters, given or not; of a sweep") {
  const std::string deck = "*FREE\n{a=1} {b=2.50} ! {c}\n{a=1}\n";
  const auto used = app::values_of_parameters(deck, {{"b", "7"}});
  CHECK(used == std::vector<app::Setting>{{"a", "1"}, {"b", "7"}});
  const test::Folder folder;
  test::write_file(folder / "a.c2s", kSketch + std::string("tolerance off\n"));
  test::write_file(folder / "t.csv", "P\n3\n4\n");
  const std::string in = "cd '" + folder.path() + "' && " + program();
  REQUIRE(test::run_shell(in + "sweep t.csv a.c2s mu=0.1 --response 'contact width; force y' --results r.csv").status == 0);
  const std::string text = test::read_file(folder / "r.csv.inputs");
  CHECK(value_of(text, "parameter mu") == "0.1");
  CHECK(test::contains(text, "file = t.csv\nsha256 = " + app::sha256_of("P\n3\n4\n")));
  CHECK(value_of(text, "parameter P") == "none"); // which the table moves, and half with it
  CHECK(value_of(text, "parameter half") == "none");
  CHECK(test::contains(test::read_file(folder / "r.csv"), "row,P,contact width,force y,outcome\n1,3,2,"));
  test::write_file(folder / "m.csv", "mu\n0.1\n0.2\n");
  REQUIRE(test::run_shell(in + "sweep m.csv a.c2s --response load --results m").status == 0);
  const std::string defaults = test::read_file(folder / "m.inputs");
  CHECK((value_of(defaults, "parameter P") == "8" && value_of(defaults, "parameter half") == "4"));
  // A row that the sketch refuses leaves at least what was given.
  test::write_file(folder / "b.c2s", kSketch + std::string("tolerance off\nrequire {P - 1} \"P is below 1\"\n"));
  test::write_file(folder / "n.csv", "P\n0\n4\n");
  CHECK(test::run_shell(in + "sweep n.csv b.c2s mu=0.1 --response load --results n").status == 0);
  CHECK(test::contains(test::read_file(folder / "n"), "P is below 1"));
  CHECK(value_of(test::read_file(folder / "n.inputs"), "parameter mu") == "0.1");
}

TEST_CASE("inputs: of rows, those that they have in common; from a row on, other ones") {
  app::Inputs a;
  a.files = {{"a.c2s", "1234"}};
  a.parameters = {{"P", "3"}, {"half", "1.5"}};
  const std::string first = app::inputs_of_rows("", a, 1);
  CHECK(first == app::inputs_text(a));
  a.parameters[1].second = "2"; // it follows from one that has a column
  const std::string second = app::inputs_of_rows(first, a, 2);
  CHECK((value_of(second, "parameter P") == "3" && value_of(second, "parameter half") == "none"));
  CHECK(app::inputs_of_rows(second, a, 3) == second);
  app::Inputs b = a;
  b.files[0].sha256 = "5678";
  const std::string other = app::inputs_of_rows(second, b, 4);
  CHECK(other == second + "row = 4\n" + app::inputs_text(b));
  b.parameters[0].second = "4";
  const std::string more = app::inputs_of_rows(other, b, 5);
  CHECK(more.compare(0, second.size(), second) == 0); // the rows before keep theirs
  CHECK(more.size() == other.size() - std::string("parameter P = 3\n").size());
  CHECK(app::inputs_of_rows(more, a, 6) == more + "row = 6\n" + app::inputs_text(a));
  CHECK(app::inputs_of_rows("", a, 7) == "row = 7\n" + app::inputs_text(a)); // rows of an earlier version have none
}

TEST_CASE("inputs: beside requested numbers and rows of runs") {
  const test::Folder folder;
  const std::string drawn = kSketch + std::string("tolerance off\n");
  test::write_file(folder / "a.c2s", drawn);
  const std::string run = "cd '" + folder.path() + "' && " + program() + "run a.c2s -q --response 'contact width' ";
  REQUIRE(test::run_shell(run + "P=3 --results r --row t.csv").status == 0);
  REQUIRE(test::run_shell(run + "P=4 --row t.csv").status == 0);
  const std::string alone = test::read_file(folder / "r.inputs"), rows = test::read_file(folder / "t.csv.inputs");
  CHECK(value_of(alone, "sha256") == app::sha256_of(drawn));
  CHECK((value_of(alone, "parameter P") == "3" && value_of(alone, "parameter half") == "1.5"));
  CHECK(value_of(rows, "sha256") == app::sha256_of(drawn));
  CHECK((value_of(rows, "parameter P") == "none" && value_of(rows, "parameter half") == "none"));
  CHECK(value_of(rows, "parameter mu") == "0.25");
  CHECK(value_of(rows, "row") == "none");
  test::write_file(folder / "a.c2s", drawn + "! changed\n");
  REQUIRE(test::run_shell(run + "P=4 --row t.csv").status == 0);
  CHECK(value_of(test::read_file(folder / "t.csv.inputs"), "row") == "3");
  CHECK(test::lines_of(test::read_file(folder / "t.csv")).size() == 4);
  // A run that fails has the numbers of no other run beside it.
  CHECK(test::run_shell(run + "P=0/ --results r --row t.csv").status != 0);
  CHECK(test::contains(test::read_file(folder / "r"), "FAIL"));
  CHECK(value_of(test::read_file(folder / "r.inputs"), "parameter P") == "none");
  CHECK(value_of(test::read_file(folder / "t.csv.inputs"), "row") == "3");
  // Places that are taken, or are no files.
  const test::Result clash = test::run_shell(run + "P=3 --results r --csv r.inputs");
  CHECK((clash.status == 64 && test::contains(clash.err, "the inputs of --results")));
  CHECK(test::run_shell(run + "P=3 --results /dev/null").status == 0);
  REQUIRE(test::run_shell("mkdir '" + (folder / "s.inputs") + "' '" + (folder / "u.inputs") + "'").status == 0);
  CHECK(test::run_shell(run + "P=3 --results s").status == 3);
  const test::Result row = test::run_shell(run + "P=3 --row u");
  CHECK((row.status == 3 && test::contains(row.err, "u.inputs: ")));
}

TEST_CASE("inputs: the deck of a sketch says what it was made from, and is the deck of a run") {
  const test::Folder folder;
  const std::string drawn = kSketch + std::string("tolerance off\n");
  test::write_file(folder / "a.c2s", drawn);
  const std::string in = "cd '" + folder.path() + "' && " + program();
  REQUIRE(test::run_shell(in + "mesh a.c2s P=3 -o m.dat").status == 0);
  const std::string deck = test::read_file(folder / "m.dat");
  CHECK(test::contains(deck, "! file a.c2s, sha256 " + app::sha256_of(drawn) + "\n"));
  CHECK(test::contains(deck, "! parameter P = 3\n"));
  CHECK(test::contains(deck, "! parameter half = 1.5\n"));
  CHECK(test::run_shell(in + "run m.dat -q --csv -").out == test::run_shell(in + "run a.c2s P=3 -q --csv -").out);
}

TEST_CASE("inputs: nothing stands beside a table that goes down a pipe, and a name that is taken is refused") {
  const test::Folder folder;
  test::write_file(folder / "a.c2s", kSketch + std::string("tolerance off\n"));
  const std::string in = "cd '" + folder.path() + "' && " + program();
  CHECK(test::run_shell(in + "run a.c2s -q --csv - | head -1").out.compare(0, 3, "mu,") == 0);
  const test::Result clash = test::run_shell(in + "run a.c2s --csv c.csv --summary c.csv.inputs");
  CHECK(clash.status == 64);
  CHECK(test::contains(clash.err, "are the same file"));
}

TEST_CASE("totals: a line of symmetry completes the balance of the part; the whole has the image") {
  app::Summary s;
  s.bodies = 2, s.pairs = 1, s.symmetry = 1, s.symmetry_at[0] = 2;
  s.body.list().assign(2, C2D_INIT(c2d_body_result));
  s.cut = {1, 0};
  c2d_body_result& cut = s.body.list()[0];
  // At (5, 3): fx 2, fy 7; contact at (4, 0): fx 0, fy -7.
  cut.applied[0] = 2, cut.applied[1] = 7, cut.applied[2] = 5 * 7 - 3 * 2;
  cut.contact[1] = -7, cut.contact[2] = 4 * -7;
  const std::vector<app::BodyTotal> rows = app::totals_of(s, 1);
  REQUIRE(rows.size() == 6);
  CHECK((rows[2].of == "lines of symmetry" && rows[2].force[0] == -2 && rows[2].force[1] == 0));
  CHECK((rows[3].force[0] == 0 && rows[3].force[1] == 14 && rows[3].force[2] == 2 * 14)); // acts at x = 2
  CHECK((rows[5].is_sum && rows[5].force[0] == 0 && rows[5].force[1] == 0 && rows[5].force[2] == 0));
  CHECK((app::totals_of(s, 2).size() == 3 && app::totals_of(s, 2)[2].of == "sum")); // beside the line
  s.symmetry = 2, s.symmetry_at[1] = 2, s.cut = {2, 0};
  CHECK((app::totals_of(s, 1)[3].force[0] == 4 && app::totals_of(s, 1)[3].force[2] == -8)); // at y = 2
  s.symmetry = 3, s.cut = {1, 0};                                                           // one of two lines
  CHECK((app::totals_of(s, 1)[3].force[1] == 14 && app::totals_of(s, 1)[2].force[1] == 0));
  s.cut = {3, 0}; // all four parts of the whole cancel
  const std::vector<app::BodyTotal> quarter = app::totals_of(s, 1);
  REQUIRE(quarter.size() == 6);
  for (size_t row = 3; row < 6; ++row)
    for (const double value : quarter[row].force) CHECK(value == 0);
}

TEST_CASE("totals: of a quarter with two lines of symmetry each body is cut by the lines at which its outline ends") {
  const test::Folder folder;
  test::write_file(folder / "a.c2s", "symmetry x 0\nsymmetry y 0\n"
                                     "body low E 1000 nu 0.3\n  from 3 0\n  line side to 3 1\n  line top to 0 1\n"
                                     "body high E 1000 nu 0.3\n  from 0 1\n  line foot to 2 1\n  line free to 2 3\n"
                                     "  line head to 0 3\ncontact low.top high.foot\npressure high.head 4\ntolerance off\n");
  const std::string in = "cd '" + folder.path() + "' && " + program();
  const test::Result run = test::run_shell(in + "run a.c2s --listing - --report r.html --csv c.csv --figures f --json j");
  REQUIRE_MESSAGE(run.status == 0, run.err);
  // In the JSON each body that a line cuts has its whole, too.
  const test::Json json = test::JsonReader::read(test::read_file(folder / "j"));
  const test::Json& upper = json["force"]["bodies"].items.at(1);
  CHECK(upper["contact"].items.at(1).number == doctest::Approx(8).epsilon(1e-6));
  CHECK(upper["whole"]["contact"].items.at(1).number == doctest::Approx(16).epsilon(1e-6));
  CHECK(upper["whole"]["applied"].items.at(1).number == doctest::Approx(-16).epsilon(1e-6));
  CHECK(json["force"]["bodies"].items.at(0)["whole"]["contact"].items.at(1).number == 0);
  const std::string balance = run.out.substr(run.out.find("Balance of forces"));
  // The load of 8 on the upper body: 4 N/mm on the 2 mm that are drawn, 16 with the image; of the lower body all four cancel.
  const auto row = [&](size_t from, const std::string& name) {
    const size_t at = balance.find(name, from);
    REQUIRE_MESSAGE(at != std::string::npos, name);
    std::istringstream in_row(balance.substr(at + name.size(), 60));
    double x = 1e9, y = 1e9;
    in_row >> x >> y;
    return std::make_pair(x, y);
  };
  const size_t low = balance.find("(low)"), high = balance.find("(high)");
  REQUIRE((low != std::string::npos && high != std::string::npos));
  CHECK(row(low, "whole: contact").second == 0);
  CHECK(row(low, "lines of symmetry").second == doctest::Approx(8).epsilon(1e-6));
  CHECK(row(high, "whole: loads and supports").second == doctest::Approx(-16).epsilon(1e-6));
  CHECK(row(high, "whole: contact").second == doctest::Approx(16).epsilon(1e-6));
  // Nothing on the page reads as unbalanced.
  const std::string picture = test::read_file(folder / "f/balance.svg");
  CHECK(test::contains(picture, "lines of symmetry"));
  CHECK_FALSE(test::contains(picture, ">8 <"));
  CHECK_FALSE(test::contains(picture, ">-8 <"));
}

TEST_CASE("check: bounds of the memory of a search, which ends with status 5 where a mesh has not enough") {
  const test::Folder folder;
  test::write_file(folder / "a.c2s", kSketch);
  test::write_file(folder / "off.c2s", kSketch + std::string("tolerance off\n"));
  const std::string in = "cd '" + folder.path() + "' && " + program();
  const test::Result check = test::run_shell(in + "check a.c2s");
  const size_t at = check.out.find("memory, search of run       minimum ");
  REQUIRE(at != std::string::npos);
  long long least = 0, most = 0;
  REQUIRE(std::sscanf(check.out.c_str() + at, "memory, search of run       minimum %lld to %lld, all in RAM", &least, &most) ==
          2);
  CHECK((least > 10000 && most > 4 * least));
  CHECK_FALSE(test::contains(test::run_shell(in + "check off.c2s").out, "search of run"));
  const test::Result run = test::run_shell(in + "run a.c2s --memory " + std::to_string(least) + " --json j 2>&1");
  CHECK(run.status == 5);
  CHECK(test::contains(run.out, "is too small"));
}

// Files of points for splines: what is read, and which line is refused.
#include "program/sketch/read/point_rows.hpp"
#include "program/sketch/read/read.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <string>

namespace {

// The points of a text as "x y" each, or what is wrong with it behind its line.
std::string rows_of(const std::string& text) {
  std::string out;
  try {
    for (const sketch::PointRow& row : sketch::point_rows(text))
      out += (out.empty() ? "" : "; ") + sketch::show(row.at.x) + " " + sketch::show(row.at.y);
  } catch (const sketch::Fault& fault) {
    out = std::to_string(fault.at.line) + ": " + fault.text;
  }
  return out;
}

} // namespace

TEST_CASE("points: separators, headings, comments, and whose marks stand before a text") {
  const std::string two = "-1.5 2; 3 0.25";
  for (const char* text :
       {"-1.5,2\n3,0.25\n", "-1.5 2\n3 0.25", "-1.5\t2\r\n3\t0.25\r\n", "-1.5;2\r3;0.25\r", "  -1.5 , 2 \n\n\t3  0.25 \n",
        "\xef\xbb\xbf-1.5,2\n3,0.25\n", "x,y\n-1.5,2\n3,0.25\n", "Profile 7\nx;y\nmm;mm\n-1.5;2\n3;0.25\n",
        "! of a profile\n# x y\n-1.5,2 ! first\n3,0.25 # last\n", "\"x\",\"y\"\n\"-1.5\",\"2\"\n\"3\",\"0.25\"\n",
        "-1.5,2,\n3,0.25,\n", "-1.5;2;\n3;0.25;\n", "-15e-1 +2\n3D0 0.25d+0\n",
        "\xef\xbb\xbf"
        "x\ty\n-1.5\t2\n3\t0.25\n"}) {
    CAPTURE(text);
    CHECK(rows_of(text) == two);
  }
  CHECK(rows_of("") == "");
  CHECK(rows_of("x,y\n! nothing\n") == "");
}

TEST_CASE("points: decimal commas where something else separates") {
  for (const char* text : {"-1,5;2\n3;0,25\n", "-1,5;2,0\n3,00;0,25\n", "-1,5\t2,0\n3,0\t0,25\n", "-1,5 2,0\n3,0 0,25\n",
                           "-1,5 ; 2,0\n3,0 ; 0,25\n", "x;y\n\"-1,5\";\"2,0\"\n3,0;0,25\n", "-1,5;2,0;\n3,0;0,25;\n"}) {
    CAPTURE(text);
    CHECK(rows_of(text) == "-1.5 2; 3 0.25");
  }
  CHECK(rows_of("1,5\n") == "1 5"); // a comma that alone separates
  CHECK(rows_of("1,5,2,5\n") == "1: 4 columns, expected two numbers: x and y");
  CHECK(rows_of("1,5,0;2,5\n") == "1: x is '1,5,0', expected a number");
  CHECK(rows_of("1.000,5;2,5\n") == "1: x is '1.000,5', expected a number");
}

TEST_CASE("points: every other row is refused by its line") {
  const struct {
    const char *text, *told;
  } cases[] = {{"0,0\nabc,def\n", "2: x is 'abc', expected a number"},
               {"0,0\nabc\n", "2: 1 column, expected two numbers: x and y"},
               {"0,0\n1,abc\n", "2: y is 'abc', expected a number"},
               {"x,y\n1,abc\n", "2: y is 'abc', expected a number"},
               {"0,0\n\n\nnan,nan\n", "4: x is 'nan', expected a number"},
               {"nan,nan\n0,0\n", "1: x is 'nan', expected a number"},
               {"0,0\n1,inf\n", "2: y is 'inf', expected a number"},
               {"0,0\n1e999,0\n", "2: x is '1e999', expected a number"},
               {"0,0\n1\n", "2: 1 column, expected two numbers: x and y"},
               {"0,0,0\n1,1,0\n", "1: 3 columns, expected two numbers: x and y"},
               {"0 0 0\n", "1: 3 columns, expected two numbers: x and y"},
               {"0;0;0\n", "1: 3 columns, expected two numbers: x and y"},
               {"x,y,z\n0,0,0\n", "2: 3 columns, expected two numbers: x and y"},
               {",0,0\n", "1: 3 columns, expected two numbers: x and y"},
               {"0,\n", "1: 1 column, expected two numbers: x and y"},
               {";1\n", "1: x is '', expected a number"},
               {"O.5 1\n", "1: x is 'O.5', expected a number"},
               {"1.2.3 1\n", "1: x is '1.2.3', expected a number"},
               {"0,0\n2*3,1\n", "2: x is '2*3', expected a number"},
               {"0,0\n--1,1\n", "2: x is '--1', expected a number"},
               {"0,0\n+-1,1\n", "2: x is '+-1', expected a number"}};
  for (const auto& c : cases) {
    CAPTURE(c.text);
    CHECK(rows_of(c.text) == c.told);
  }
  CHECK(rows_of(std::string("\xff\xfe"
                            "0\0,\0",
                            6)) == "1: the file has two bytes per character, expected text in UTF-8 or ASCII");
  CHECK(rows_of(std::string("0\0,\0"
                            "0\0",
                            6)) == "1: the file has two bytes per character, expected text in UTF-8 or ASCII");
}

TEST_CASE("points: a spline from a file, and the line of a point that stands there twice") {
  std::string rows;
  const auto file = [&](const std::string&, std::string& text) {
    text = rows;
    return true;
  };
  const std::string text = "body b E 1 nu 0.3\nspline top file p.csv\nline l to -2 -1\nline d to 2 -1\nline r close\nfix b.d\n"
                           "traction b.top x 0 y 1\n";
  rows = "\xef\xbb\xbf";
  for (int i = 10; i >= -10; --i) {
    const double x = 0.2 * i, y = x * x / 20;
    std::string row = sketch::show(x) + ";" + sketch::show(y) + "\r\n";
    for (char& c : row)
      if (c == '.') c = ',';
    rows += row;
  }
  for (const bool turned : {false, true}) { // run through as it stands: clockwise
    std::string one = text;
    if (turned) one.replace(one.find("file p.csv"), 10, "file p.csv reversed");
    const sketch::Reading reading = sketch::read_sketch(one, {}, file);
    CHECK(reading.faults.empty() != turned);
    if (turned) continue;
    const sketch::ShapePtr spline = reading.sketch.bodies[0].outlines[0].curves[0].shape;
    CHECK(spline->at(0.5).y == doctest::Approx(0).epsilon(1e-12));
    CHECK(spline->at(0).y == 0.2);
  }
  rows = "x,y\n2,0\n1,0.5\n1,0.5\n-2,0\n";
  const sketch::Reading twice = sketch::read_sketch(text, {}, file);
  REQUIRE(twice.faults.size() >= 1);
  CHECK(twice.faults[0].text == "file 'p.csv', line 4: the point repeats the one before it, expected another place");
  CHECK(twice.faults[0].at.line == 2);
}

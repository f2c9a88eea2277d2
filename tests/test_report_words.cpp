// Numbers, words, characters, axes and strokes of the reports, at the ends of what they take.
#include "report/csv.hpp"
#include "report/drawn/axes.hpp"
#include "report/drawn/svg.hpp"
#include "report/listing/listing_items.hpp"
#include "report/record.hpp"
#include "report/text.hpp"
#include "report/warnings.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

using namespace app;

TEST_CASE("report: numbers as printf prints them, also where it is not done quickly") {
  for (const double value :
       {0.0, -0.0, 1e-40, -9.999999999999e29, 2e30, 1e-45, 5e-324, 1.7976931348623157e308, 123456.7890123, -1.5e-5}) {
    CAPTURE(value);
    char expected[64];
    std::snprintf(expected, sizeof expected, "%.12g", value + 0.0);
    std::string out;
    append_number(out, value);
    CHECK(out == expected);
    for (const int digits : {3, 17}) {
      out.clear();
      append_general(out, value, 30, digits);
      std::snprintf(expected, sizeof expected, "%30.*g", digits, value + 0.0);
      CHECK(out == expected);
    }
  }
}

TEST_CASE("report: a word for every number that the library may come to give") {
  CHECK(std::string(status_word(-1)) == "none");
  CHECK(std::string(tape_word(99)) == "unknown");
  const char* const outcomes[] = {"reached",
                                  "free motion",
                                  "gross sliding",
                                  "no admissible change",
                                  "changes without progress",
                                  "could not be decided",
                                  "tipping",
                                  "beyond the limits of accuracy"};
  const int32_t outcome[] = {C2D_REACHED,     C2D_FREE_MOTION, C2D_GROSS_SLIDING, C2D_NO_ADMISSIBLE_CHANGE,
                             C2D_NO_PROGRESS, C2D_UNDECIDED,   C2D_TIPPING,       C2D_BEYOND_LIMITS};
  for (size_t i = 0; i < 8; ++i) CHECK(std::string(outcome_word(outcome[i])) == outcomes[i]);
  CHECK(std::string(outcome_word(99)) == "unknown");
  const char* const breaches[] = {"none",
                                  "residual of the contact tableau",
                                  "residual of the contact equations",
                                  "balance of forces",
                                  "pressure or gap below zero",
                                  "friction above its bound",
                                  "slip along its friction",
                                  "no unique solution"};
  const int32_t breach[] = {C2D_BREACH_NONE, C2D_BREACH_TABLEAU, C2D_BREACH_EQUATIONS, C2D_BREACH_BALANCE,
                            C2D_BREACH_SIGN, C2D_BREACH_CONE,    C2D_BREACH_SLIP,      C2D_BREACH_SINGULAR};
  for (size_t i = 0; i < 8; ++i) CHECK(std::string(breach_word(breach[i])) == breaches[i]);
}

TEST_CASE("report: names of bodies and zones, where there are some") {
  Summary s;
  s.body_name = {"bolt", ""};
  CHECK(body_text(s, 1) == "body 1 (bolt)");
  CHECK(body_text(s, 2) == "body 2");
  for (const int64_t none : {0, 3}) CHECK(body_text(s, none) == "body " + std::to_string(none));
}

TEST_CASE("report: characters of UTF-8, and what is none") {
  const struct {
    const char* text;
    size_t bytes;
  } cases[] = {{"a", 1},
               {" ", 1},
               {"\x1f", 0},
               {"\x7f", 0},
               {"\x80", 0},             // goes on with nothing
               {"\xc1\x81", 0},         // in more bytes than it needs
               {"\xc2\x9f", 0},         // a control character
               {"\xc2\xa0", 2},         //
               {"\xdf\xbf", 2},         //
               {"\xe0\x9f\xbf", 0},     //
               {"\xe0\xa0\x80", 3},     //
               {"\xe3\x81\x82", 3},     //
               {"\xed\x9f\xbf", 3},     //
               {"\xed\xa0\x80", 0},     // half of a pair
               {"\xed\xbf\xbf", 0},     //
               {"\xee\x80\x80", 3},     //
               {"\xef\xbf\xbd", 3},     //
               {"\xef\xbf\xbe", 0},     // never a character
               {"\xef\xbf\xbf", 0},     //
               {"\xf0\x8f\xbf\xbf", 0}, //
               {"\xf0\x9f\x94\xa9", 4}, //
               {"\xf4\x8f\xbf\xbd", 4}, //
               {"\xf4\x90\x80\x80", 0}, // beyond the last
               {"\xf5\x80\x80\x80", 0}, //
               {"\xe3\x81", 0},         // cut off
               {"\xe3(\x82", 0}};       //
  for (const auto& c : cases) {
    CAPTURE(std::string(c.text));
    CHECK(character_at(c.text, 0) == c.bytes);
  }
  CHECK(character_at("", 0) == 0);
  CHECK(characters_in("\xe3\x81\x82\x80z") == 3);
  CHECK(text_width("\xe3\x81\x82", 10) == doctest::Approx(12)); // as wide as two
  CHECK(text_width("&#8722;1", 10) == doctest::Approx(12));
  CHECK(text_width("&", 10) == doctest::Approx(6));
}

namespace {

Range range_of(std::initializer_list<double> values) {
  Range out;
  for (const double value : values) out.include(value);
  return out;
}

} // namespace

TEST_CASE("report: axes of what has no extent, no sign, no number") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(range_of({nan, INFINITY, -INFINITY}).empty);
  const struct {
    Range range;
    double low, high;
  } linear[] = {{range_of({nan}), 0, 1},
                {range_of({0}), 0, 1},
                {range_of({0, 1e-300}), 0, 1},
                {range_of({2}), 1, 3},
                {range_of({-2}), -3, -1}};
  for (const auto& c : linear) {
    const Axis axis = make_axis(c.range, "p", "", 5);
    CHECK(axis.low == doctest::Approx(c.low));
    CHECK(axis.high == doctest::Approx(c.high));
    CHECK(axis.ticks >= 2);
    CHECK(axis.name == "p");
  }
  const struct {
    Range range;
    double low, high;
  } logarithmic[] = {{range_of({}), 1, 2}, {range_of({-1}), 1, 2}, {range_of({-1, 10}), 10, 20}, {range_of({3, 70}), 2, 100}};
  for (const auto& c : logarithmic) {
    const Axis axis = make_log_axis(c.range, "n");
    CHECK(axis.low == doctest::Approx(c.low));
    CHECK(axis.high == doctest::Approx(c.high));
  }
  const Axis wide = make_log_axis(range_of({1e-5, 1e7}), "n");
  CHECK(wide.label(0) == "10&#8315;&#8309;");
  CHECK(wide.label(wide.ticks - 1) == "10&#8311;");
  CHECK(make_log_axis(range_of({2e-5, 5e-5}), "n").label(0) == "2&#183;10&#8315;&#8309;");
  // A view of a single point still has a scale.
  const Chart view = make_view({0, 0, 100, 100}, range_of({1}), range_of({2}), 10, "mm");
  CHECK(view.x.high > view.x.low);
  CHECK(view.at(1, 2).x == doctest::Approx(50));
  CHECK(view_height(range_of({1}), range_of({0, 1}), 100, 20, 80) == 80);
  CHECK(view_height(range_of({0, 2}), range_of({0, 1}), 100, 20, 80) == 50);
}

TEST_CASE("report: labels of an axis stand apart") {
  Chart chart;
  chart.frame = {0, 0, 40, 20};
  chart.x = make_axis(range_of({1000, 2000}), "x", "mm", 8), chart.y = make_axis(range_of({0, 1}), "y", "", 8);
  Svg svg("labels", 100, 100);
  draw_axes(svg, chart);
  const std::string text = svg.finish("", "");
  CHECK(text.find(">1000</text>") != std::string::npos);
  CHECK(text.find(">1200</text>") == std::string::npos); // no room
  CHECK(text.find(">0.2</text>") == std::string::npos);
}

TEST_CASE("report: of shapes only what lies within 5e4 pixels is written") {
  const auto drawn = [](void (*draw)(Svg&)) {
    Svg svg("s", 10, 10);
    const std::string empty = svg.finish("", "");
    draw(svg);
    const std::string text = svg.finish("", "");
    return text == empty ? std::string() : text;
  };
  CHECK(drawn([](Svg& s) { s.line({1e6, 0}, {1e6, 9}, {"red"}); }) == "");
  CHECK(drawn([](Svg& s) { s.line({0, 0}, {1e6, 0}, {"red"}); }).find("x2=\"50000\"") != std::string::npos);
  CHECK(drawn([](Svg& s) { s.line({0, -1e6}, {0, 0}, {"red"}); }).find("y1=\"-50000\"") != std::string::npos);
  CHECK(drawn([](Svg& s) { s.polyline({}, {"red"}); }) == "");
  CHECK(drawn([](Svg& s) { s.rectangle({6e4, 0, 7e4, 9}, "red", {}); }) == "");
  CHECK(drawn([](Svg& s) { s.rectangle({0, 6e4, 9, 7e4}, "red", {}); }) == "");
  CHECK(drawn([](Svg& s) { s.arrow({0, 0}, {0.05, 0}, {"red"}); }) == "");
  CHECK(drawn([](Svg& s) { s.text({0, 6e4}, "far", 9); }) == "");
  CHECK(drawn([](Svg& s) { s.mark(Mark::kCircle, {-6e4, 0}, 9, "red"); }) == "");
  CHECK(drawn([](Svg& s) { s.mark(Mark::kNone, {0, 0}, 9, "red"); }) == "");
  CHECK(drawn([](Svg& s) { s.mark(Mark::kCross, {0, 0}, 9, "red"); }) != "");
}

TEST_CASE("report: why a path ended, with all that is known") {
  Summary model;
  model.body_name = {"", "shoe"};
  c2d_summary now = C2D_INIT(c2d_summary);
  CoefficientRecord c;
  c.outcome = C2D_FREE_MOTION;
  const std::string message = c2d_outcome_message(c.outcome);
  explain(c, now, model, "");
  CHECK(c.why == message);
  explain(c, now, model, message);
  CHECK(c.why == message);
  now.breach = C2D_BREACH_CONE, now.breach_size = 0.25, now.outcome_body = 2, now.outcome_pair = 7;
  explain(c, now, model, "said");
  CHECK(c.why == message + ": said: friction above its bound, relative 0.25; body 2 (shoe) can move; last pair 7");
  for (int i = 0; i < 3; ++i) {
    for (double& part : now.free_motion) part = 0;
    now.free_motion[i] = 2;
    explain(c, now, model, "");
    const char* const by[] = {"(2, 0) and turn by 0", "(0, 2) and turn by 0", "(0, 0) and turn by 2"};
    CHECK(c.why.find(std::string("body 2 (shoe) can move by ") + by[i] + " about the origin") != std::string::npos);
  }
}

TEST_CASE("report: too many increments, in words") {
  c2d_summary model = C2D_INIT(c2d_summary);
  model.steps = static_cast<int32_t>(kMostSteps), model.coefficients = 1;
  CHECK(fault_of_steps(model) == "");
  model.steps += 1;
  CHECK(fault_of_steps(model) == "the load cards make " + std::to_string(kMostSteps + 1) +
                                     " increments, with 1 coefficient of friction; expected at most " +
                                     std::to_string(kMostSteps) + " in all, each of which is kept and printed");
  model.coefficients = 2, model.steps = INT32_MAX;
  CHECK(fault_of_steps(model).find("2147483647 increments or more, with 2 coefficients of friction") != std::string::npos);
}

TEST_CASE("report: warnings that matter most come first, and of a kind in the order in which they came") {
  std::vector<c2d_error> warnings;
  for (const int32_t kind :
       {C2D_WARN_CORNER, C2D_WARN_FEW_PAIRS, C2D_WARN_TIE_END, C2D_WARN_ZONE_END, C2D_WARN_CORNER, C2D_WARN_ENERGY}) {
    c2d_error warning = C2D_INIT(c2d_error);
    warning.status = kind, warning.line = static_cast<int32_t>(warnings.size());
    warnings.push_back(warning);
  }
  order_warnings(warnings);
  std::vector<int32_t> lines;
  for (const c2d_error& warning : warnings) lines.push_back(warning.line);
  CHECK(lines == std::vector<int32_t>{5, 3, 1, 0, 4, 2});
}

TEST_CASE("report: what a run that came to nothing leaves") {
  RunRecord record;
  record.take_stated_errors(); // of no coefficient
  record.coefficients.resize(1);
  record.take_stated_errors(); // of no step
  CHECK(record.incomplete() == nullptr);
  CHECK(std::string(record.outcome()) == "reached");
  record.coefficients[0].singular = true;
  CHECK(record.incomplete() == &record.coefficients[0]);
  CHECK(std::string(record.outcome()) == "singular");
  record.coefficients[0].singular = false, record.coefficients[0].outcome = C2D_TIPPING;
  CHECK(std::string(record.outcome()) == "tipping");
  record.checked_only = true;
  CHECK(std::string(record.outcome()) == "checked");

  Summary summary;
  const std::string heading =
      "mu,step,load,zone,name,quantity,item,value,x,y,error,s,along,plane_angle,worst_case,root_of_squares\n";
  std::string out;
  append_summary(out, RunRecord(), summary);
  CHECK(out == heading);
  // Steps whose quantities are the same: a path that ended where its last row was has that row once.
  summary.zone_name = {"a \"b\", c"};
  CoefficientRecord& c = record.coefficients[0];
  c.steps.resize(2);
  Quantity q;
  q.zone = 1, q.value = 2.5;
  for (StepRecord& step : c.steps) step.quantities = {q}, step.step = 1;
  const auto rows = [&] {
    out.clear();
    append_summary(out, record, summary);
    size_t count = 0;
    for (const char character : out) count += character == '\n';
    return count - 1;
  };
  CHECK(rows() == 1);
  CHECK(out.find(",\"a \"\"b\"\", c\",") != std::string::npos);
  c.outcome = C2D_REACHED;
  CHECK(rows() == 2);
  c.outcome = C2D_TIPPING;
  c.steps[1].loads = {1}, c.steps[0].loads = {0.5};
  CHECK(rows() == 2);
  CHECK(out.find("nan") == std::string::npos);

  // Behind the factors of the load cases: the plane of a fatigue parameter, and what tolerances of parameters do, at the end.
  c.outcome = C2D_REACHED;
  for (StepRecord& step : c.steps) step.loads = {1, 7};
  summary.load_cases = 2, summary.body_name = {"block"};
  Stated swt, stress;
  swt.what = Measure::kSwt, swt.of = " of top", swt.body = 1, swt.value = 3, swt.angle = 12.5;
  stress.what = Measure::kStressXX, stress.body = 1, stress.at[0] = 1, stress.at[1] = 2;
  ToleranceTable& table = record.meshes.tolerances;
  table.parameters = {{"R", 5, 0.5, ""}, {"P", 1, 0.25, ""}};
  const auto toleranced = [](const Stated& s, double by_r, double by_p) { return Toleranced{s, {{by_r, ""}, {by_p, ""}}}; };
  Stated peak, elsewhere = stress;
  peak.what = q.what, peak.zone = 1, elsewhere.at[0] = 0;
  table.numbers = {toleranced(peak, 6, 16), toleranced(elsewhere, 1, 1), toleranced(stress, -2, NAN), toleranced(swt, -6, -16)};
  record.meshes.stated = {swt, stress};
  REQUIRE(rows() == 4);
  CHECK(out.find("along,load2,plane_angle,worst_case,root_of_squares\n") != std::string::npos);
  CHECK(out.find("2.5,,,,,,7,,,\n") != std::string::npos);   // the first step
  CHECK(out.find("2.5,,,,,,7,,7,5\n") != std::string::npos); // 0.5 6 + 0.25 16, and the root of 9 + 16
  CHECK(out.find("SWT of top,,3,,,,,,7,12.5,7,5\n") != std::string::npos);
  CHECK(out.find("stress xx,,0,1,2,,,,7,,,\n") != std::string::npos); // without a derivative by P
}

TEST_CASE("report: what is wrong with all results is told first, with a place alone last") {
  std::vector<c2d_error> warnings;
  for (int32_t kind = C2D_WARN_SLIT; kind >= C2D_WARN_ZONE_END; --kind) {
    c2d_error entry = C2D_INIT(c2d_error);
    entry.status = kind;
    warnings.push_back(entry);
  }
  order_warnings(warnings);
  std::vector<int32_t> order;
  for (const c2d_error& entry : warnings) order.push_back(entry.status);
  const auto place = [&](int32_t kind) { return std::find(order.begin(), order.end(), kind) - order.begin(); };
  CHECK(order.front() == C2D_WARN_INCREMENT);
  CHECK(order.back() == C2D_WARN_TIE_END);
  CHECK(place(C2D_WARN_COMPRESSED) < place(C2D_WARN_ZONE_END));
  CHECK(place(C2D_WARN_ZONE_END) < place(C2D_WARN_SURFACE));
  CHECK(place(C2D_WARN_SURFACE) < place(C2D_WARN_FEW_PAIRS));
  CHECK(place(C2D_WARN_SIZES) < place(C2D_WARN_POINT_LOAD));
}

// The page of --report and its pictures: what a reader sees at the width of a telephone and of a desk, and that drawings are
// true: bodies that touch are neither drawn over each other nor apart, ties are no contacts, every load has its symbol.
#include "paths.hpp"
#include "picture_runs.hpp"

using namespace test;

namespace {

using Curve = std::vector<app::Point>;

// The closed curves of a path's data "M x yL x y ... Z".
std::vector<Curve> curves_of(const std::string& data) {
  std::vector<Curve> out;
  std::istringstream in(data);
  for (char letter = 0; in >> letter;) {
    if (letter == 'M') out.emplace_back();
    if (letter == 'Z') continue;
    app::Point p;
    in >> p.x >> p.y;
    out.back().push_back(p);
  }
  return out;
}

bool lies_in(const std::vector<Curve>& curves, app::Point p) {
  bool inside = false;
  for (const Curve& c : curves)
    for (size_t i = 0, j = c.size() - 1; i < c.size(); j = i++)
      if ((c[i].y > p.y) != (c[j].y > p.y) && p.x < c[i].x + (p.y - c[i].y) / (c[j].y - c[i].y) * (c[j].x - c[i].x))
        inside = !inside;
  return inside;
}

double distance_to(const std::vector<Curve>& curves, app::Point p) {
  double least = 1e9;
  for (const Curve& c : curves)
    for (size_t i = 0, j = c.size() - 1; i < c.size(); j = i++) {
      const app::Point a = c[j], way{c[i].x - a.x, c[i].y - a.y};
      const double square = way.x * way.x + way.y * way.y;
      double part = square > 0 ? ((p.x - a.x) * way.x + (p.y - a.y) * way.y) / square : 0;
      part = std::min(1.0, std::max(0.0, part));
      least = std::min(least, std::hypot(p.x - a.x - part * way.x, p.y - a.y - part * way.y));
    }
  return least;
}

// How many pixels the nodes and middles of one body's outline lie inside another body, within a frame.
double depth(const std::vector<Curve>& a, const std::vector<Curve>& b, const app::Box& frame) {
  double most = 0;
  for (const Curve& c : a)
    for (size_t i = 0, j = c.size() - 1; i < c.size(); j = i++)
      for (const app::Point& p : {c[i], app::Point{0.5 * (c[i].x + c[j].x), 0.5 * (c[i].y + c[j].y)}})
        if (p.x > frame.left && p.x < frame.right && p.y > frame.top && p.y < frame.bottom && lies_in(b, p))
          most = std::max(most, distance_to(b, p));
  return most;
}

// How many pixels a corner of the curve lies within the smallest convex shape around it.
double largest_dent(Curve points) {
  const auto before = [](app::Point a, app::Point b) { return a.x < b.x || (a.x == b.x && a.y < b.y); };
  const Curve all = points;
  std::sort(points.begin(), points.end(), before);
  Curve around;
  for (int way = 0; way < 2; ++way, std::reverse(points.begin(), points.end())) {
    const size_t first = around.size();
    for (const app::Point& p : points) {
      while (around.size() > first + 1) {
        const app::Point a = around[around.size() - 2], b = around.back();
        if ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) > 0) break;
        around.pop_back();
      }
      around.push_back(p);
    }
    around.pop_back();
  }
  double most = 0;
  for (const app::Point& p : all) most = std::max(most, distance_to({around}, p));
  return most;
}

// The shapes of the bodies in a picture (the first paths with a fill of a body), and its frame.
struct Shapes {
  std::vector<std::vector<Curve>> bodies;
  app::Box frame;
};

Shapes shapes_of(const std::string& svg) {
  static const std::set<std::string> kFills{"#dce9f5", "#e6c88c", "#f6f3ea", "#a4b494", "#e8d0dc", "#b4b8cc"};
  std::vector<Element> elements;
  REQUIRE(read_xml(svg, elements).empty());
  Shapes out;
  for (const Element& e : elements) {
    if (e.name == "path" && e.attributes.count("fill") != 0 && kFills.count(e.attributes.at("fill")) != 0)
      out.bodies.push_back(curves_of(e.attributes.at("d")));
    if (e.name == "rect" && e.attributes.count("x") != 0 && e.attributes.at("fill") == "none" && out.frame.right == 0)
      out.frame = {number_of(e, "x"), number_of(e, "y"), number_of(e, "x") + number_of(e, "width"),
                   number_of(e, "y") + number_of(e, "height")};
  }
  return out;
}

// To scale a picture is the result itself, whose gaps are measured on the undeformed surfaces.
void check_no_overlap(const std::string& name, const std::string& svg) {
  const Shapes s = shapes_of(svg);
  const double most = contains(svg, "&#215;") && !contains(svg, "to scale") ? 1.0 : 1.5;
  CHECK_MESSAGE(s.frame.right > s.frame.left, name);
  for (size_t a = 0; a < s.bodies.size(); ++a)
    for (size_t b = 0; b < s.bodies.size(); ++b) {
      if (a == b) continue;
      const double deep = depth(s.bodies[a], s.bodies[b], s.frame);
      CHECK_MESSAGE(deep <= most, name << ": body " << a + 1 << " lies " << deep << " pixels in body " << b + 1);
    }
}

size_t count_of(const std::string& text, const std::string& part) {
  size_t count = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

const char kShoe[] = "units mm N\nbody plate E 3000 nu 0.4\nfrom -30 -20\nline base to 30 -20\nline side to 30 0\n"
                     "line top to -30 0\nline left close\nbody shoe rigid\nfrom -20 20\narc face to 20 20 centre 0 20\n"
                     "line waist close\ncontact plate.top shoe.face mu 0.2\nfix plate.base\ntolerance off\n"
                     "drive shoe about 0 20 fx 8 fy -100 moment -60\n";

} // namespace

TEST_CASE("page: bodies that touch are not drawn over each other, whatever the magnification") {
  const std::map<std::string, std::string> problems{{"roller", example("roller.c2s") + " "},
                                                    {"press fit", example("press_fit.c2s")},
                                                    {"hertz", example("hertz.dat")},
                                                    {"layers", example("three_bodies.dat")},
                                                    {"receding", example("layer_receding.dat")},
                                                    {"block", example("sliding_block.dat")}};
  for (const auto& problem : problems) {
    CAPTURE(problem.first);
    Shown shown;
    std::string file = problem.second;
    if (file.back() == ' ') file.pop_back();
    show(shown, file);
    REQUIRE(shown.result.status != 2);
    size_t drawn = 0;
    for (const auto& figure : shown.figures)
      if (figure.first == "deformed" || figure.first.compare(0, 7, "contact") == 0)
        check_no_overlap(problem.first + " " + figure.first, figure.second), ++drawn;
    CHECK(drawn >= 2);
    // One factor for displacements and gaps, or none.
    const std::string& deformed = shown.figures["deformed"];
    CHECK((contains(deformed, "displacements and gaps &#215;") || contains(deformed, "to scale")));
    // Magnified gaps leave a roller its shape, beside the contact as well.
    if (problem.first == "roller") CHECK(largest_dent(shapes_of(deformed).bodies[1].front()) < 0.1);
  }
}

TEST_CASE("page: the measure of overlap finds one") {
  const std::vector<Curve> square{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}}, beside{{{10, 0}, {20, 0}, {20, 10}, {10, 10}}},
      over{{{7, 2}, {20, 2}, {20, 8}, {7, 8}}};
  const app::Box frame{-100, -100, 100, 100};
  CHECK(depth(beside, square, frame) == 0);
  CHECK(depth(over, square, frame) == doctest::Approx(3));
  CHECK(depth(over, square, {-100, -100, 0, 0}) == 0);
  CHECK(largest_dent(square.front()) == 0);
  CHECK(largest_dent({{0, 0}, {10, 0}, {10, 10}, {6, 7}, {0, 10}}) == doctest::Approx(3));
}

TEST_CASE("page: first the contact on the deformed bodies, then numbers with units, each with its meaning") {
  Shown shown;
  show(shown, example("roller.c2s"));
  REQUIRE(shown.result.status == 0);
  check_page(shown);
  const std::string& page = shown.page;
  const size_t first = page.find("<section id=\""), numbers = page.find("<section id=\"numbers\">");
  CHECK(page.compare(first, 22, "<section id=\"contact\">") == 0);
  CHECK(numbers < page.find("<section id=\"model\">"));
  // The highest pressure stands at the diagram, and no picture is wider than a telephone makes it.
  CHECK(contains(shown.figures["contact"], "N/mm&#178;</text>"));
  CHECK(contains(page, "svg{display:block;width:100%"));
  CHECK(!contains(page, "width:680px"));
  CHECK(count_of(page, "viewBox=\"0 0 480 ") == shown.figures.size() + count_of(page, "<input type=\"radio\""));
  for (const char* term : {"peak-pressure", "contact-edge", "approach"})
    CHECK_MESSAGE(
        (contains(page, "<a href=\"#term-" + std::string(term)) && contains(page, "<dt id=\"term-" + std::string(term))), term);
  CHECK(contains(page, " N/mm&#178;</td>"));
  CHECK(contains(page, "<th>x, mm</th>"));
  // Every section stands in the contents, every table in a box that scrolls.
  CHECK(count_of(page, "<li><a href=\"#") == count_of(page, "<section id=\""));
  CHECK(count_of(page, "<table>") == count_of(page, "<div class=\"wide\"><table>"));
  CHECK(contains(page, "@media screen and (min-width:1000px)"));
}

TEST_CASE("page: coordinates and forces that are round-off are 0") {
  Shown shown;
  show(shown, example("roller.c2s"));
  for (const char* name : {"deformed", "stress", "stress_zone", "contact"}) {
    const std::string caption = caption_of(shown, name);
    CHECK_MESSAGE(!contains(caption, "e-1"), caption);
    CHECK_MESSAGE(!contains(caption, "e-0"), caption);
  }
  CHECK(contains(caption_of(shown, "stress"), ") mm"));
  CHECK(contains(caption_of(shown, "stress"), "undeformed"));
}

// Under moments alone the resultants are round-off, beside the tractions that make them.
TEST_CASE("page: a body under tractions that cancel is balanced in words and bars") {
  for (const char* name : {"plate_tension.dat", "families/cantilever.c2s"}) {
    CAPTURE(name);
    Shown shown;
    show(shown, example(name));
    const std::string caption = caption_of(shown, "balance");
    const size_t at = caption.find(" to within ");
    REQUIRE(at != std::string::npos);
    CHECK(std::strtod(caption.c_str() + at + 11, nullptr) < 1e-12);
  }
}

TEST_CASE("page: a rigid body is drawn rigid, whatever the magnification") {
  Shown shown;
  show(shown, example("tutorial/t9_shoe.c2s"));
  const Shapes shapes = shapes_of(shown.figures["deformed"]);
  REQUIRE(shapes.bodies.size() == 3);
  CHECK(largest_dent(shapes.bodies[2].front()) < 0.1);
}

TEST_CASE("page: with a line of symmetry the whole force stands below that of the part") {
  Shown shown;
  show(shown, example("tutorial/t1_roller.c2s"), "--json -");
  for (const char* part : {">force y</a></td><td>100", ">force y</a>, whole</td><td>200", "are those of the modelled part."})
    CHECK_MESSAGE(contains(shown.page, part), part);
  CHECK(!contains(shown.page, ">force x</a>, whole")); // its images are opposite
  const Result listing =
      run_shell("'" + paths::program() + "' run " + quoted(example("tutorial/t1_roller.c2s")) + " --listing -");
  CHECK(contains(listing.out, "force y, whole               200"));
}

TEST_CASE("page: the load path in frames, one of which is shown, with one axis for all") {
  const Folder folder;
  write_file(folder / "deck", read_file(example("sliding_block.dat")) + "*CASES 2\ncase 2\n condition 2 25-48 0 0.05 0 0 0\n"
                                                                        "*PATH\n 2, 1, 0\n 16 1 0.3\n 16 1 -0.5\n");
  Shown shown;
  show(shown, folder / "deck");
  REQUIRE_MESSAGE(shown.result.status == 0, shown.result.err);
  check_page(shown);
  const size_t from = shown.page.find("<fieldset class=\"frames\">");
  REQUIRE(from != std::string::npos);
  std::vector<Element> elements;
  const std::string end = "</fieldset>";
  REQUIRE(read_xml(shown.page.substr(from, shown.page.find(end, from) + end.size() - from), elements) == "");
  std::vector<std::string> buttons, labels, axes;
  std::string ticks, checked;
  int pictures = 0;
  for (const Element& e : elements) {
    if (e.name == "input") buttons.push_back(e.attributes.at("id"));
    if (e.name == "input" && e.attributes.count("checked") != 0) checked += e.attributes.at("id");
    if (e.name == "label") labels.push_back(e.attributes.at("for"));
    if (e.name == "svg" && ++pictures > 1) axes.push_back(ticks), ticks.clear();
    if (e.name == "text") ticks += e.text + "|";
  }
  CHECK(buttons == labels);
  CHECK(buttons.size() == 21); // 20 of 34 recorded steps, and that where case 2 turns
  CHECK(pictures == 21);
  CHECK(buttons.back() == "frames_34");
  CHECK(checked == buttons.back());
  for (const std::string& one : axes) CHECK(one == axes[0]);
  CHECK(contains(shown.page, "Step 2, load factors 1, 0: the largest pressure of a pair is ")); // where case 2 begins
}

TEST_CASE("page: a path of two steps has no frames") {
  const Folder folder;
  write_file(folder / "deck", read_file(example("sliding_block.dat")) + "*PATH\n 2, 1\n");
  Shown shown;
  show(shown, folder / "deck");
  REQUIRE_MESSAGE(shown.result.status == 0, shown.result.err);
  CHECK(!contains(shown.page, "class=\"frames\""));
}

TEST_CASE("page: a tie is drawn as a tie, without friction and its bounds") {
  Shown shown;
  show(shown, made("bimaterial"));
  REQUIRE(shown.result.status == 0);
  check_page(shown);
  CHECK(contains(shown.figures["model"], ">tie</text>"));
  CHECK(!contains(shown.figures["model"], ">contact zone</text>"));
  for (const char* name : {"tractions", "contact"}) {
    const std::string& svg = shown.figures[name];
    for (const char* never : {"Coulomb", "riction", "stick", "slip"}) CHECK_MESSAGE(!contains(svg, never), never);
    CHECK(contains(svg, "shear stress"));
  }
}

TEST_CASE("page: loads of a free rigid body are drawn, the moment as an arc") {
  const Folder folder;
  write_file(folder / "shoe.c2s", kShoe);
  Shown shown;
  show(shown, folder / "shoe.c2s");
  REQUIRE_MESSAGE(shown.result.status == 0, shown.result.err);
  check_page(shown);
  for (const char* entry : {">force on a rigid body</text>", ">moment on a rigid body</text>"})
    CHECK_MESSAGE(contains(shown.figures["model"], entry), entry);
  write_file(folder / "pushed.c2s", std::string(kShoe).replace(std::string(kShoe).find("moment -60"), 10, "turn 0"));
  Shown pushed;
  show(pushed, folder / "pushed.c2s");
  REQUIRE_MESSAGE(pushed.result.status == 0, pushed.result.err);
  CHECK(contains(pushed.figures["model"], ">force on a rigid body</text>"));
  CHECK(!contains(pushed.figures["model"], ">moment on a rigid body</text>"));
}

TEST_CASE("page: all charts along a zone have one axis") {
  Shown shown;
  show(shown, example("roller.c2s"));
  const auto name_of_axis = [&](const char* figure) {
    std::vector<Element> elements;
    REQUIRE(read_xml(shown.figures[figure], elements).empty());
    std::string out;
    for (const Element& e : elements)
      if (e.name == "text" && contains(e.text, "along body")) out = e.text;
    return out;
  };
  CHECK(name_of_axis("tractions") == "x, along body 1 [mm]");
  for (const char* other : {"status", "gap"}) CHECK(name_of_axis(other) == name_of_axis("tractions"));
}

TEST_CASE("page: a second view of the model only where it shows something else") {
  Shown small, large;
  show(small, example("roller.c2s"));
  show(large, example("three_bodies.dat"));
  CHECK(small.figures.count("model_zone") == 1);
  CHECK(large.figures.count("model_zone") == 0);
}

TEST_CASE("page: the diagrams of pressure and friction stay within the frame, all round a contact too") {
  const std::string files[] = {example("press_fit.c2s"),
                               example("pin.c2s"),
                               example("roller.c2s"),
                               example("fretting_pad.c2s"),
                               example("families/shrink.c2s"),
                               example("families/disc_in_hole.c2s"),
                               example("revolution/belleville.c2s")};
  for (const std::string& file : files) {
    CAPTURE(file);
    Shown shown;
    show(shown, file);
    size_t diagrams = 0;
    for (const auto& [name, svg] : shown.figures) {
      if (name.compare(0, 7, "contact") != 0) continue;
      CAPTURE(name);
      const size_t before = diagrams;
      const app::Box frame = shapes_of(svg).frame;
      const std::string mark = "<g fill-opacity=\"0.3\">\n<path d=\"";
      for (size_t at = svg.find(mark); at != std::string::npos; at = svg.find(mark, at + 1))
        for (const Curve& curve : curves_of(svg.substr(at + mark.size(), svg.find('"', at + mark.size()) - at - mark.size()))) {
          const auto is_in = [&](app::Point p) {
            return p.x >= frame.left - 1 && p.x <= frame.right + 1 && p.y >= frame.top - 1 && p.y <= frame.bottom + 1;
          };
          const auto in = std::count_if(curve.begin(), curve.end(), is_in);
          if (in == 0) continue; // an image of the contact that lies elsewhere
          CHECK(in == static_cast<ptrdiff_t>(curve.size()));
          ++diagrams;
        }
      CHECK(diagrams > before); // a contact that is not in its own picture shows nothing
    }
    CHECK(diagrams > 0);
  }
}

// The polylines of a chart in the order in which they are drawn, one of each look.
static std::vector<Element> curves_drawn(const std::string& svg) {
  std::vector<Element> elements, out;
  REQUIRE(read_xml(svg, elements).empty());
  std::set<std::string> looks;
  const auto dash = [](const Element& e) {
    const auto found = e.attributes.find("stroke-dasharray");
    return found != e.attributes.end() ? found->second : std::string();
  };
  for (const Element& e : elements)
    if (e.name == "polyline" && looks.insert(e.attributes.at("stroke") + dash(e)).second) out.push_back(e);
  return out;
}

TEST_CASE("page: a curve that others cover is seen beside them") {
  // The largest pressure of a symmetric contact does not depend on friction: the curves of all coefficients coincide.
  Shown shown;
  show(shown, example("hertz.dat"));
  for (const char* name : {"path", "energy"}) {
    CAPTURE(name);
    const std::vector<Element> curves = curves_drawn(shown.figures[name]);
    REQUIRE(curves.size() >= 2);
    CHECK(number_of(curves[0], "stroke-width") >= number_of(curves[1], "stroke-width") + 1);
    CHECK(curves[1].attributes.count("stroke-dasharray") == 1);
  }
  // Earlier states lie over the curve of the end, and none is drawn that equals it.
  Shown press;
  show(press, example("press_fit.c2s"));
  CHECK(!contains(press.figures["tractions"], ">load 1</text>"));
  show(shown, example("roller.c2s"));
  const std::vector<Element> all = curves_drawn(shown.figures["tractions"]);
  REQUIRE(all.size() >= 4);
  CHECK(all[0].attributes.at("stroke") == "#0060a8");
  CHECK(all[1].attributes.at("stroke-dasharray") == "2 3");
}

TEST_CASE("page: numbers have their places along the second side, and steps their widths") {
  Shown shown;
  show(shown, example("roller.c2s"));
  CHECK(contains(shown.page, "<th><a href=\"#term-along\">along</a>, mm</th>"));
  CHECK(contains(shown.page, "<dt id=\"term-along\">"));
  for (const char* name : {"contact width", "stuck width", "eccentricity", "peak along"})
    CHECK_MESSAGE(contains(shown.page, "<th>" + std::string(name) + "</th>"), name);
  // Of the roller's right half: from the line of symmetry to the edge.
  const size_t edge = shown.page.find("#term-contact-edge\">contact edge</a> 1</td>");
  const std::string row = shown.page.substr(edge, shown.page.find("</tr>", edge) - edge);
  CHECK(std::stod(row.substr(row.rfind("<td>") + 4)) == doctest::Approx(0.8438).epsilon(5e-3));
  CHECK(std::stod(row.substr(row.find("<td>") + 4)) == std::stod(row.substr(row.rfind("<td>") + 4))); // which is its value, too
}

TEST_CASE("page: forces of bodies of revolution are those of the whole circumference, not per length") {
  const Folder folder;
  write_file(folder / "fit.c2s",
             "units mm N\naxisymmetric\nsymmetry y 0\nbody shaft E 210e3 nu 0.3\n  from 20 0\n  line seat to 20 20\n"
             "  line end to 0 20\nbody hub E 210e3 nu 0.3\n  from 40 0\n  line outer to 40 20\n"
             "  line face to 19.98 20\n  line bore to 19.98 0\ncontact shaft.seat hub.bore\ninterference\ntolerance off\n");
  Shown shown;
  show(shown, folder / "fit.c2s");
  REQUIRE_MESSAGE(shown.result.status == 0, shown.result.err);
  check_page(shown);
  CHECK(contains(shown.page, "force x</a></td><td>"));
  for (const std::string& text : {shown.page, shown.figures["balance"], shown.figures["energy"]}) {
    CHECK(!contains(text, "N/mm<"));
    CHECK(!contains(text, "N/mm]"));
    CHECK(!contains(text, "per thickness"));
    CHECK(!contains(text, "per unit thickness"));
  }
  CHECK(contains(shown.page, "<th>moment about the origin, N mm</th>"));
}

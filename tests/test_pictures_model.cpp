// What pictures show of load cases, symmetry by images, zones of meshes that do not match, rigid bodies and
// several coefficients of friction.
#include "json.hpp"
#include "paths.hpp"
#include "picture_runs.hpp"

using namespace test;

namespace {

const std::string kHatched = "patternTransform";

Result contact2d(const std::string& arguments) { return run_shell("'" + paths::program() + "' " + arguments); }

// Elements of a picture with this name and attribute value.
std::vector<Element> with(const std::string& svg, const std::string& name, const std::string& attribute,
                          const std::string& value) {
  std::vector<Element> all, out;
  CHECK(read_xml(svg, all).empty());
  for (const Element& e : all) {
    const auto found = e.attributes.find(attribute);
    if (e.name == name && found != e.attributes.end() && found->second == value) out.push_back(e);
  }
  return out;
}

std::vector<app::Point> points_of(const Element& polyline) {
  std::vector<app::Point> out;
  std::istringstream in(polyline.attributes.at("points"));
  char comma;
  for (app::Point p; in >> p.x >> comma >> p.y;) out.push_back(p);
  return out;
}

// Of a curve from left to right.
double height_at(const std::vector<app::Point>& curve, double x) {
  size_t i = 1;
  while (i + 1 < curve.size() && curve[i].x < x) ++i;
  const app::Point a = curve[i - 1], b = curve[i];
  return a.y + (x - a.x) / (b.x - a.x) * (b.y - a.y);
}

// The polyline drawn with this colour and width.
std::vector<app::Point> curve(const std::string& svg, const char* colour, const char* width) {
  for (const Element& e : with(svg, "polyline", "stroke", colour))
    if (e.attributes.at("stroke-width") == width) return points_of(e);
  return {};
}

// A deck whose zone joins meshes that do not match: nodes 29 and 31 of body 1 are moved.
std::string free_deck() {
  std::vector<std::string> lines = lines_of(read_file(paths::root() + "/tests/data/decks/hertz_lin_l.dat"));
  lines[5] = "    2    0    2";
  lines[42] = "   29 1.250000000.00000000";
  lines[44] = "   31 0.830000000.00000000";
  const size_t first = lines.size() - 7;
  lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(first), lines.begin() + static_cast<std::ptrdiff_t>(first) + 3);
  lines[first] = lines[first + 1] = "    0    0";
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text + "*ZONE 26 34 43 35\n*UNITS mm, kN\n";
}

} // namespace

TEST_CASE("pictures: the loads of all cases are drawn and named") {
  const Folder folder;
  write_file(folder / "deck", read_file(example("sliding_block.dat")) +
                                  "*CASES 3\ncase 2\ncondition 2 25-48 0 0.05 0 0 0\nload 2 0 0.5 0.02 -0.01\n"
                                  "*BODY FORCE 2 3 0 -0.02 0.001 0 0.6\n*PATH\n2 1 0 0\n6 1 0.3 0.5\n"
                                  "6 1 -0.5 1\n");
  Shown shown;
  show(shown, folder / "deck");
  REQUIRE_MESSAGE(shown.result.status == 0, shown.result.err);
  check_page(shown);
  const std::string& model = shown.figures["model"];
  for (const char* entry :
       {">traction, case 1<", ">traction, case 2<", ">point load, case 2<", ">body force, case 3<", ">rotation, case 3<"})
    CHECK_MESSAGE(contains(model, entry), entry);
  CHECK(!contains(model, "point load, case 1"));
  CHECK(!contains(model, "traction, case 3"));
  for (const char* name : {"tractions", "gap", "status", "deformed", "stress", "balance", "path", "energy"})
    CHECK_MESSAGE(contains(caption_of(shown, name), "step 14 (load factors 1, -0.5, 1)"), name);
  CHECK(contains(shown.figures["tractions"], ">step 11: load 1, -0.1, 0.75<"));
  CHECK(contains(shown.figures["path"], "factor of load case 3"));

  Shown one; // a single case needs no number
  show(one, example("sliding_block.dat"));
  CHECK(contains(one.figures["model"], ">traction<"));
  CHECK(!contains(one.figures["model"], ", case"));
}

TEST_CASE("pictures: the listing has the loads of all cases") {
  const Folder folder;
  write_file(folder / "deck", read_file(example("sliding_block.dat")) +
                                  "*CASES 2\ncase 2\ncondition 2 25-26 0 0.0625 0 0 0\nload 2 0 0.5 0.02 -0.01\n"
                                  "*BODY FORCE 2 2 0 -0.03125 0 0 0\n*PATH\n2 1 0\n1 1 0.375\n");
  const Result run = contact2d("run " + quoted(folder / "deck") + " --listing -");
  REQUIRE(run.status == 0);
  int conditions = 0;
  for (const std::string& line : lines_of(run.out)) {
    std::istringstream in(line);
    std::vector<std::string> words;
    for (std::string word; in >> word;) words.push_back(word);
    if (words.size() == 8 && words[0] == "2" && words[4] == "0.0625") ++conditions;
  }
  CHECK(conditions == 4); // two elements with two ends
  for (const char* part : {"Point loads", "Body forces", "-0.03125", "0.375", "symmetry by images"})
    CHECK_MESSAGE(contains(run.out, part), part);
}

TEST_CASE("pictures: a zone on a line of symmetry goes on beyond it") {
  Shown shown;
  show(shown, example("hertz.dat"), "--symmetry images --json -");
  REQUIRE_MESSAGE(shown.result.status == 0, shown.result.err);
  check_page(shown);
  const std::string& svg = shown.figures["tractions_1"];
  const std::vector<app::Point> pressure = curve(svg, "#0060a8", "2"), friction = curve(svg, "#d55e00", "2");
  const double left = pressure.front().x, right = pressure.back().x, middle = 0.5 * (left + right);
  const double zero = height_at(friction, middle), apart = 0.2; // pixels; points that nobody sees are not written
  for (int i = 1; i <= 40; ++i) {
    const double off = i / 41.0 * (right - middle), one = height_at(friction, middle + off);
    CHECK(height_at(pressure, middle + off) == doctest::Approx(height_at(pressure, middle - off)).scale(1).epsilon(apart));
    CHECK(one - zero == doctest::Approx(zero - height_at(friction, middle - off)).scale(1).epsilon(apart));
  }
  const double quarter = 0.25 * (right - middle);
  CHECK(height_at(friction, middle + quarter) < zero - 1.0); // tt > 0 on the side that is modelled, and < 0 on the other
  CHECK(height_at(friction, middle - quarter) > zero + 1.0);
  CHECK(contains(caption_of(shown, "tractions_1"), "is the image"));
}

TEST_CASE("pictures: loads and supports stand on all sides of a symmetric model") {
  Shown shown;
  show(shown, made("disc_in_hole"));
  REQUIRE_MESSAGE(shown.result.status == 0, shown.result.err);
  check_page(shown);
  std::vector<Element> arrows, lines;
  for (const Element& e : with(shown.figures["model"], "line", "stroke", "#d55e00")) arrows.push_back(e);
  for (const Element& e : with(shown.figures["model"], "line", "stroke-dasharray", "14 4 3 4"))
    if (number_of(e, "x1") == number_of(e, "x2")) lines.push_back(e);
  REQUIRE(!lines.empty());
  const double axis = number_of(lines[0], "x1");
  int left = 0, right = 0;
  for (const Element& e : arrows) {
    if (e.attributes.count("stroke-dasharray") || number_of(e, "y1") > 350.0) continue; // the legend's
    if (number_of(e, "x2") > axis) {
      ++right;
      CHECK(number_of(e, "x2") > number_of(e, "x1")); // pulled outwards
    } else {
      ++left;
      CHECK(number_of(e, "x2") < number_of(e, "x1"));
    }
  }
  CHECK(left == right);
  CHECK(left > 5);
  CHECK(contains(shown.figures["tractions"], "from the line of symmetry x = 0"));
}

TEST_CASE("pictures: hoop stress of a ring by images is Lame's, without the lines") {
  Shown shown;
  show(shown, example("thick_ring.dat"), "--symmetry images");
  REQUIRE_MESSAGE(shown.result.status == 0, shown.result.err);
  // p (a a + b b) / (b b - a a) with a = 1, b = 2, p = 100: 166.67 at the inner side.
  const std::string caption = caption_of(shown, "boundary"), words = "the largest in size is ";
  const size_t at = caption.find(words);
  REQUIRE(at != std::string::npos);
  CHECK(std::stod(caption.substr(at + words.size())) == doctest::Approx(166.67).epsilon(0.005));
}

TEST_CASE("pictures: the number of a curve stands on no axis") {
  Shown shown;
  show(shown, example("families/hole.c2s"));
  REQUIRE_MESSAGE(shown.result.status == 0, shown.result.err);
  std::vector<Element> all;
  REQUIRE(read_xml(shown.figures["boundary"], all) == "");
  int numbers = 0;
  for (const Element& e : all) {
    if (e.name != "text" || (e.text != "1" && e.text != "2") || e.attributes.count("stroke") == 0) continue; // of ticks
    CHECK_MESSAGE(std::stod(e.attributes.at("x")) > 66.0 + 8.0, e.text); // the axis is at 66
    ++numbers;
  }
  CHECK(numbers == 2);
}

TEST_CASE("pictures: a press fit is drawn so large that its overlap is not seen, and the hub is not drawn moved inwards") {
  const Folder folder;
  write_file(folder / "ring.c2s", "symmetry x 0\nsymmetry y 0\nbody shaft E 210e3 nu 0.3\nfrom 25.025 0\n"
                                  "arc face centre 0 0 turn 90\noutline\nfrom 0 10\narc bore centre 0 0 turn -90\n"
                                  "body hub E 70e3 nu 0.33\nfrom 50 0\narc rim centre 0 0 turn 90\noutline\nfrom 0 25\n"
                                  "arc seat centre 0 0 turn -90\ncontact hub.seat shaft.face\ninterference\ntolerance off\n");
  Shown shown;
  show(shown, folder / "ring.c2s");
  REQUIRE_MESSAGE(shown.result.status == 0, shown.result.err);
  // The overlap of 0.025 mm is half a pixel at 5, a pixel at 10.
  CHECK(contains(caption_of(shown, "deformed"), "displacements and gaps &#215; 5:"));
  CHECK(contains(caption_of(shown, "contact"), "gaps &#215; 5."));
}

TEST_CASE("pictures: zones of meshes that do not match say what tractions are measured by") {
  const Folder folder;
  write_file(folder / "deck", free_deck());
  Shown shown;
  show(shown, folder / "deck");
  REQUIRE_MESSAGE(shown.result.status == 0, shown.result.err);
  check_page(shown);
  CHECK(contains(shown.figures["tractions"], ">contact pressure tn [kN/mm&#178;]<"));
  CHECK(contains(caption_of(shown, "tractions"), "Stresses are forces on body 2 per undeformed length of body 2"));
  CHECK(contains(caption_of(shown, "model"), "Zone 1 joins nodes of body 2 to points of body 1"));
  Shown matching;
  show(matching, example("hertz.dat"));
  CHECK(contains(caption_of(matching, "tractions_1"), "per undeformed length of body 1"));

  const Result run = contact2d("run " + quoted(folder / "deck") + " --listing -");
  REQUIRE(run.status == 0);
  CHECK(contains(run.out, "      points  "));
  const size_t zone = run.out.find("Contact zone of body 1");
  REQUIRE(zone != std::string::npos);
  int whole = 0, between = 0; // pair, element, place
  for (const std::string& line : lines_of(run.out.substr(zone, run.out.find("Contact zone of body 2") - zone))) {
    std::istringstream in(line);
    int pair = 0, element = 0;
    double place = 9.0;
    if (!(in >> pair >> element >> place)) continue;
    CHECK(element >= 26);
    CHECK(element <= 34);
    (std::fabs(place) == 1.0 ? whole : between)++;
  }
  CHECK(whole == 8);
  CHECK(between == 2);
}

TEST_CASE("pictures: a rigid body is shown as one, with its motion") {
  const Folder folder;
  write_file(folder / "deck", read_file(example("hertz.dat")) + "*CASES 2\n*RIGID\n2 0 0.02 0 0 0\n*PATH\n4 0.5 0\n4 0.5 1\n");
  Shown shown;
  show(shown, folder / "deck");
  REQUIRE_MESSAGE(shown.result.status == 0, shown.result.err);
  check_page(shown);
  const std::string& model = shown.figures["model"];
  for (const char* entry : {">body 1, rigid<", ">motion of the rigid body, case 2<"})
    CHECK_MESSAGE(contains(model, entry), entry);
  CHECK(contains(model, kHatched));
  CHECK(contains(caption_of(shown, "model"), "body 1 has 46 elements, rigid; body 2 has 58 elements, E = 1000"));
  const Result run = contact2d("run " + quoted(folder / "deck") + " --listing -");
  CHECK(contains(run.out, "Body 1 is rigid"));
}

TEST_CASE("pictures: energy of every coefficient, as the JSON says") {
  Shown shown;
  show(shown, example("rough_plates.dat"), "--json " + quoted(shown.folder / "r.json"));
  REQUIRE(shown.result.status == 0);
  const Json json = JsonReader::read(read_file(shown.folder / "r.json"));
  std::map<double, const Json*> last;
  for (const Json& step : json["steps_detail"].items) last[step["mu"].number] = &step;
  REQUIRE(last.size() == 4);
  const std::string caption = caption_of(shown, "energy");
  for (const auto& entry : last) {
    for (const char* key : {"work", "elastic", "dissipated"})
      CHECK_MESSAGE(contains(caption, six((*entry.second)[key].number)), caption << " lacks " << key);
    CHECK(contains(shown.figures["energy"], "dissipated, &#956; = " + six(entry.first)));
  }
  check_page(shown);
}

TEST_CASE("pictures: a peak at an edge leaves the rest of the zone to be seen") {
  Shown shown;
  show(shown, made("punch"));
  REQUIRE(shown.result.status == 0);
  check_page(shown);
  const std::vector<PairRow> rows = last_rows(read_file(shown.folder / "c.csv"), 0.265);
  REQUIRE(rows.size() == 145);
  double largest = 0.0, centre = 0.0;
  for (const PairRow& row : rows) {
    largest = std::max(largest, row.tn);
    if (row.x == 0.0) centre = row.tn;
  }
  REQUIRE(largest > 100.0 * centre);
  char text[40];
  std::snprintf(text, sizeof text, "up to %.4g at x = 1<", largest);
  CHECK_MESSAGE(contains(shown.figures["tractions"], text), text);
  const std::vector<app::Point> pressure = curve(shown.figures["tractions"], "#0060a8", "2");
  REQUIRE(pressure.size() > 2);
  const std::vector<Element> frames = with(shown.figures["tractions"], "rect", "height", "210");
  REQUIRE(frames.size() >= 2);
  const double bottom = number_of(frames[0], "y") + 210.0;
  CHECK(bottom - height_at(pressure, 0.5 * (pressure.front().x + pressure.back().x)) >
        0.05 * 210.0); // the middle stands clear of the axis
}

TEST_CASE("pictures: lines of symmetry are told by check, listing and JSON") {
  const std::string ring = quoted(example("thick_ring.dat"));
  const Result images = contact2d("check " + ring + " --symmetry images"), plain = contact2d("check " + ring);
  CHECK(images.status == 0);
  CHECK(contains(images.out, "symmetry by images          x = 0, y = 0\n"));
  CHECK(contains(plain.out, "symmetry by images          none\n"));
  CHECK(contact2d("check " + ring + " --symmetry=images").status == 0);
  CHECK(contact2d("check --symmetry mirror " + ring).status == 64);
  CHECK(contact2d("check " + quoted(example("plate_tension.dat")) + " --symmetry images").status == 0);
  const Result listing = contact2d("run " + ring + " --symmetry images --listing -");
  CHECK(contains(listing.out, "symmetry by images ....................... x = 0, y = 0\n"));
  CHECK(contains(listing.out, "totals of a body that a line of symmetry cuts cover the modelled part"));
  CHECK_FALSE(contains(contact2d("run " + ring + " --listing -").out, "a line of symmetry"));
  const Json json = JsonReader::read(contact2d("run " + ring + " --symmetry images --json -").out);
  REQUIRE(json["symmetry"].items.size() == 2);
  CHECK(json["symmetry"].items[0]["axis"].text == "x");
  CHECK(json["symmetry"].items[0]["at"].number == 0.0);
  CHECK(json["symmetry"].items[1]["axis"].text == "y");
  CHECK(JsonReader::read(contact2d("run " + ring + " --json -").out)["symmetry"].items.empty());
}

TEST_CASE("pictures: a zone that stands upright, that sticks for ever, and forces and motions beyond what is seen") {
  const Folder folder;
  const std::string squares =
      "body b E 1000 nu 0.3\nfrom 0 0\nline s to 1 0\nline e to 1 1\nline n to 0 1\nline w close\nfix b.w\n"
      "copy c of b shift 1 0\n";
  write_file(folder / "adhesion.c2s", squares + "contact b.e c.w mu inf\ncase one\ntraction c.e x -1\nweight c y -0.1\n"
                                                "spin c 0.0001 about 50 50\ncase two\nweight c x -0.2\nhistory one 1; two 1\n");
  Shown shown;
  show(shown, folder / "adhesion.c2s");
  REQUIRE_MESSAGE(shown.result.status == 0, shown.result.err);
  check_page(shown);
  const std::string& tractions = shown.figures["tractions"];
  CHECK(contains(tractions, ">y"));
  CHECK(!contains(tractions, "mu tn"));
  CHECK(contains(shown.figures["model"], ">body force, case 1<"));
  // A rigid body that is turned, about a point that is seen and one that is not.
  for (const char* about : {"1.5 0.5", "60 0.5"}) {
    CAPTURE(about);
    write_file(folder / "rigid.c2s", "plane stress\n" + squares.substr(0, squares.find("copy")) +
                                         "body r rigid\nfrom 1 0\nline f to 2 0\nline g to 2 1\nline h to 1 1\nline i close\n"
                                         "contact b.e r.i mu 0.3\ndrive r about " +
                                         about + " x -0.001 turn -0.0001\n");
    Shown turned;
    show(turned, folder / "rigid.c2s");
    REQUIRE_MESSAGE(turned.result.status == 0, turned.result.err); // its peak, without bound, is not asked for
    check_page(turned);
    CHECK(contains(turned.figures["model"], ">motion of the rigid body<"));
    CHECK(contains(caption_of(turned, "model"), "plane stress"));
  }
}

TEST_CASE("pictures: elements with one node each, and how far such a mesh may be off") {
  const Folder folder;
  write_file(folder / "deck",
             "*FREE\n1\nSQUARES\n0 3\n2 1 1\n1 2 4 4\n1 2 4 4\n1 4\n5 8\n100 0.3\n200 0.2\n1 0.5\n0 0\n"
             "1 0 0\n2 1 0\n3 1 1\n4 0 1\n0 1\n5 0 0\n6 1 0\n7 1 1\n8 0 1\n2\n1 1 1100 0 0 0 0\n4 1 1100 0 0 0 0\n0\n"
             "2\n7 1 1100 0 0 0 -0.001\n8 1 1100 0 0 0 -0.001\n0\n1 2 1 1\n3 3 5 5\n3 3 5 5\n1 1\n1 1\n1 10\n4 1\n");
  Shown shown;
  show(shown, folder / "deck", "--estimate --json " + quoted(folder / "r.json"));
  REQUIRE_MESSAGE(shown.result.status == 0, shown.result.err);
  check_page(shown);
  CHECK(contains(shown.figures["model"], ">body 2<"));
  CHECK(JsonReader::read(read_file(folder / "r.json"))["accuracy"]["rounds"].items.size() == 2);
}

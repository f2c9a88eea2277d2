// Pictures and the report page: well-formed, legible, and in agreement with the CSV.
#include "json.hpp"
#include "paths.hpp"
#include "picture_runs.hpp"

using namespace test;

TEST_CASE("pictures: contact with two coefficients of friction") {
  Shown shown;
  show(shown, example("hertz.dat"));
  REQUIRE(shown.result.status == 0);
  const std::set<std::string> expected = {"model",    "tractions_1", "tractions_2", "status_1", "status_2", "gap_2",
                                          "deformed", "stress",      "stress_zone", "path",     "balance"};
  for (const std::string& name : expected) CHECK_MESSAGE(shown.figures.count(name) == 1, name);
  CHECK(shown.figures.count("gap_1") == 0); // all pairs touch, and none has slipped: zero everywhere
  for (const PairRow& row : last_rows(read_file(shown.folder / "c.csv"), 0.4)) CHECK(row.status == "stick");
  check_page(shown);
  CHECK(contains(shown.page, "the last pair at an end of a contact zone is closed"));
  CHECK(contains(shown.page, "&#956; = 0.3: reached load factor 1.03 in 28 steps."));
}

TEST_CASE("pictures: captions say what the CSV says") {
  Shown shown;
  show(shown, example("hertz.dat"));
  REQUIRE(shown.result.status == 0);
  int index = 0;
  for (const double mu : {0.4, 0.3}) {
    const std::vector<PairRow> rows = last_rows(read_file(shown.folder / "c.csv"), mu);
    REQUIRE(rows.size() == 15);
    const auto peak =
        std::max_element(rows.begin(), rows.end(), [](const PairRow& a, const PairRow& b) { return a.tn < b.tn; });
    double half_width = 0.0;
    int touching = 0, slipping = 0;
    for (const PairRow& row : rows) {
      if (row.status == "open") continue;
      half_width = std::max(half_width, row.x); // flat body, axis at x = 0
      ++touching;
      if (row.status == "slip") ++slipping;
    }
    const std::string caption = caption_of(shown, "tractions_" + std::to_string(++index));
    CHECK(contains(caption, "the largest pressure of a pair is " + six(peak->tn) + " at x = "));
    CHECK(contains(caption, "(pair " + std::to_string(peak->pair) + ")"));
    CHECK(contains(caption, std::to_string(touching) + " of 15 pairs touch"));
    CHECK(contains(caption, "contact half width " + six(half_width)));
    CHECK(contains(caption, std::to_string(slipping) + " pairs slip"));
  }
}

TEST_CASE("pictures: other contacts, and a single body") {
  const std::map<std::string, std::set<std::string>> expected = {
      {"sliding_block.dat", {"model", "tractions", "status", "gap", "deformed", "stress", "path", "balance"}},
      {"layer_receding.dat", {"model", "tractions", "status", "gap", "deformed", "stress", "path", "balance"}},
      {"thick_ring.dat", {"model", "deformed", "boundary", "stress", "balance"}},
      {"rough_plates.dat", {"model", "tractions_4", "status_4", "deformed", "stress", "path"}}};
  for (const auto& kind : expected) {
    Shown shown;
    show(shown, example(kind.first));
    REQUIRE(shown.result.status == 0);
    for (const std::string& name : kind.second) CHECK_MESSAGE(shown.figures.count(name) == 1, kind.first << ": " << name);
    check_page(shown);
    if (kind.first != "rough_plates.dat") continue; // all its pairs are closed: there is no gap to draw
    CHECK(shown.figures.count("gap_4") == 0);
    CHECK(read_file(shown.folder / "c.csv").find(",open,") == std::string::npos);
  }
}

TEST_CASE("pictures: stick and slip of the sliding block as in the CSV") {
  Shown shown;
  show(shown, example("sliding_block.dat"));
  REQUIRE(shown.result.status == 0);
  const std::vector<PairRow> rows = last_rows(read_file(shown.folder / "c.csv"), 0.3);
  int stick = 0, slip = 0;
  double last_stick = -1e9;
  for (const PairRow& row : rows) {
    if (row.status == "slip") ++slip;
    if (row.status != "stick") continue;
    ++stick;
    last_stick = std::max(last_stick, row.x);
  }
  REQUIRE(stick > 0);
  REQUIRE(slip > 0);
  const std::string caption = caption_of(shown, "status");
  CHECK(contains(caption, std::to_string(stick) + " of 25 pairs stick, " + std::to_string(slip) + " slip, 0 are open"));
  char text[40];
  std::snprintf(text, sizeof text, "to %.4g.", last_stick); // side 1 is straight: x is the abscissa
  CHECK_MESSAGE(contains(caption, text), caption << " lacks " << text);
}

TEST_CASE("pictures: units of the deck stand at the axes") {
  const Folder folder;
  write_file(folder / "deck", read_file(example("hertz.dat")) + "*UNITS cm, kN\n");
  Shown shown;
  show(shown, folder / "deck");
  REQUIRE_MESSAGE(shown.result.status == 0, shown.result.err);
  CHECK(contains(shown.figures["tractions_1"], "contact pressure tn [kN/cm&#178;]"));
  CHECK(contains(shown.figures["model"], ">x [cm]<"));
  check_page(shown);
}

TEST_CASE("pictures: a load that goes down again is drawn over its steps") {
  std::string deck = read_file(example("hertz.dat"));
  const size_t last = deck.find("    2     1.0300");
  REQUIRE(last != std::string::npos);
  deck.replace(last, 16, "    2     0.4000");
  const Folder folder;
  write_file(folder / "deck", deck);
  Shown shown;
  show(shown, folder / "deck");
  REQUIRE(shown.result.status == 0);
  CHECK(contains(shown.figures["status_1"], ">step<"));
  check_page(shown);
}

TEST_CASE("pictures: a path through two load cases is drawn over its steps") {
  const Folder folder;
  write_file(folder / "deck", read_file(example("sliding_block.dat")) + "*CASES 2\ncase 2\n condition 2 25-48 0 0.05 0 0 0\n"
                                                                        "*PATH\n 2, 1, 0\n 6 1 0.3\n 6 1 -0.5\n");
  Shown shown;
  show(shown, folder / "deck");
  REQUIRE_MESSAGE(shown.result.status == 0, shown.result.err);
  for (const char* name : {"status", "path", "energy"}) CHECK_MESSAGE(contains(shown.figures[name], ">step<"), name);
  check_page(shown);
}

TEST_CASE("pictures: images make the whole body") {
  Shown shown;
  show(shown, example("thick_ring.dat"), "--symmetry images");
  REQUIRE_MESSAGE(shown.result.status == 0, shown.result.err);
  CHECK(contains(shown.figures["model"], "line of symmetry"));
  CHECK(contains(shown.figures["model"], "&#8722;2")); // the axis reaches the other side
  CHECK(contains(shown.figures["stress"], "&#8722;2"));
  check_page(shown);
}

TEST_CASE("pictures: work is stored or dissipated, as the JSON says") {
  Shown shown;
  show(shown, example("sliding_block.dat"), "--json " + quoted(shown.folder / "r.json"));
  REQUIRE(shown.result.status == 0);
  const Json json = JsonReader::read(read_file(shown.folder / "r.json"));
  REQUIRE(!json["steps_detail"].items.empty());
  const Json& last = json["steps_detail"].items.back();
  const std::string caption = caption_of(shown, "energy");
  for (const char* key : {"work", "elastic", "dissipated"})
    CHECK_MESSAGE(contains(caption, six(last[key].number)), caption << " lacks " << key);
}

TEST_CASE("pictures: a run that stops early still has its page, which says so") {
  const Folder folder; // a horizontal load that friction cannot carry
  std::string deck = read_file(example("sliding_block.dat"));
  const size_t mu = deck.find("    1     0.3000\n");
  REQUIRE(mu != std::string::npos);
  deck.replace(mu, 17, "    1     0.0500\n");
  write_file(folder / "deck", deck);
  Shown shown;
  show(shown, folder / "deck");
  REQUIRE(shown.result.status == 1);
  CHECK(contains(shown.page, "<b>incomplete</b>, stopped at load factor"));
  CHECK(names_of(shown).count("model") == 1);
  check_page(shown);
}

TEST_CASE("pictures: outputs that cannot be written end with 3 and leave nothing") {
  const Folder folder;
  write_file(folder / "file", "x");
  const std::string run = "'" + paths::program() + "' run " + quoted(example("hertz.dat")) + " --csv " +
                          quoted(folder / "c.csv") + " --listing /dev/null ";
  for (const std::string& option : {"--report " + quoted(folder / "none/r.html"), "--vtk " + quoted(folder / "none/b.vtk"),
                                    "--figures " + quoted(folder / "none/figures"), "--figures " + quoted(folder / "file"),
                                    "--figures " + quoted(folder / "new") + " --report " + quoted(folder / "none/r.html"),
                                    "--figures " + quoted(folder / "new") + " --report /dev/full"}) {
    CHECK_MESSAGE(run_shell(run + option).status == 3, option);
    CHECK_MESSAGE(folder.names() == std::vector<std::string>{"file"}, option);
  }
  CHECK(read_file(folder / "file") == "x");
}

TEST_CASE("pictures: a bad deck leaves neither page nor folder") {
  const Folder folder;
  write_file(folder / "deck", "    1\nnot a deck\n  x\n");
  CHECK(run_shell("'" + paths::program() + "' run " + quoted(folder / "deck") + " --report " + quoted(folder / "r.html") +
                  " --figures " + quoted(folder / "figures") + " --vtk " + quoted(folder / "b.vtk"))
            .status == 2);
  CHECK(folder.names() == std::vector<std::string>{"deck"});
}

TEST_CASE("pictures: the same output as without them") {
  const Folder folder;
  const std::string run = "'" + paths::program() + "' run " + quoted(example("hertz.dat")) + " --csv ";
  REQUIRE(run_shell(run + quoted(folder / "a.csv") + " --listing " + quoted(folder / "a.lst")).status == 0);
  REQUIRE(run_shell(run + quoted(folder / "b.csv") + " --listing " + quoted(folder / "b.lst") + " --report " +
                    quoted(folder / "r.html"))
              .status == 0);
  CHECK(read_file(folder / "a.csv") == read_file(folder / "b.csv"));
  CHECK(read_file(folder / "a.lst") == read_file(folder / "b.lst"));
}

TEST_CASE("pictures: words of the user cannot break a page") {
  CHECK(app::escape_xml("a<b & \"c\">\x01\xe4") == "a&lt;b &amp; &quot;c&quot;&gt;??");
  const Folder folder;
  std::string deck = read_file(example("thick_ring.dat"));
  std::vector<std::string> cards = lines_of(deck);
  const size_t title = static_cast<size_t>(std::stoi(cards[0]));
  cards[title] = "<script>alert(1)</script> & \"x\"";
  std::string changed;
  for (const std::string& card : cards) changed += card + "\n";
  write_file(folder / "deck", changed);
  Shown shown;
  show(shown, folder / "deck");
  REQUIRE(shown.result.status == 0);
  check_page(shown);
  CHECK(contains(shown.page, "&lt;script&gt;"));
}

TEST_CASE("pictures: where side 1 is straight along an axis that is the abscissa, else the length along it") {
  Shown flat, round;
  show(flat, made("mindlin"));
  show(round, made("disc_in_hole"));
  CHECK(contains(flat.figures["tractions"], ">x, along body 1"));
  CHECK(contains(round.figures["tractions"], ">s from "));
}

TEST_CASE("pictures: where slip at the edges of contact is narrow it is drawn again, magnified") {
  const Folder folder;
  const std::string made = run_shell("'" + paths::program() + "' make mindlin n=80 steps=2").out;
  write_file(folder / "narrow", made);
  write_file(folder / "smooth", run_shell("'" + paths::program() + "' make hertz n=40").out);
  Shown narrow, smooth;
  show(narrow, folder / "narrow");
  show(smooth, folder / "smooth");
  REQUIRE(narrow.figures.count("edges") == 1);
  CHECK(smooth.figures.count("edges") == 0);
  check_page(narrow);
  const std::string& picture = narrow.figures["edges"];
  size_t headings = 0;
  for (size_t at = picture.find(">Friction<"); at != std::string::npos; at = picture.find(">Friction<", at + 1)) ++headings;
  CHECK(headings == 2);
  CHECK(contains(caption_of(narrow, "edges"), "The same around the first and the last edge of contact"));
}

TEST_CASE("pictures: a platen is glued, and no contact to look at; a tie neither sticks nor slips") {
  const Folder folder;
  write_file(folder / "pad.c2s",
             "body block E 200e3 nu 0.3\n  from -30 -30\n  line bottom to 30 -30\n  line right to 30 0\n"
             "  line top to -30 0\n  line left close\nbody pad E 200e3 nu 0.3\n  from -10 1.0102051443364402\n"
             "  arc face to 10 1.0102051443364402 radius 50\n  line right to 10 20\n  line top to -10 20\n  line left close\n"
             "contact block.top pad.face mu 0.3\nfix block.bottom\n"
             "platen pad.top about 0 20 force 0 -200 turn 0\nwant pressure 20 %\n");
  Shown shown;
  show(shown, folder / "pad.c2s");
  REQUIRE_MESSAGE(shown.result.status == 0, shown.result.err);
  check_page(shown);
  CHECK(shown.figures.count("status_zone1") == 1);
  CHECK(shown.figures.count("status_zone2") == 0);
  REQUIRE(shown.figures.count("tractions_zone2") == 1);
  CHECK(contains(shown.figures["tractions_zone2"], ">tied</text>"));
  CHECK(!contains(shown.figures["tractions_zone2"], ">open</text>"));
  CHECK(contains(shown.figures["tractions_zone1"], ">open</text>"));
  CHECK(!contains(shown.figures["tractions_zone1"], ">tied</text>"));
  // The views of the contact end far below the platen, at y = 20.
  const std::string& deformed = shown.figures["deformed"];
  CHECK(contains(deformed, "Whole model"));
  CHECK(!contains(deformed.substr(deformed.find(">Whole model")), ">20</text>"));
  REQUIRE(shown.figures.count("stress_zone") == 1);
  for (const char* far : {">10</text>", ">20</text>", ">&#8722;20</text>"})
    CHECK(!contains(shown.figures["stress_zone"], std::string("text-anchor=\"end\" fill=\"#222222\"") + far));

  Shown tied;
  show(tied, made("bimaterial"));
  REQUIRE(tied.result.status == 0);
  for (const auto& figure : tied.figures) CHECK_MESSAGE(figure.first.compare(0, 6, "status") != 0, figure.first);
  CHECK(contains(tied.figures["tractions"], ">tied</text>"));
}

TEST_CASE("pictures: bodies around a contact are magnified as far as what is in view moves, not the contact alone") {
  Shown shown;
  show(shown, example("families/stack.c2s"));
  CHECK(contains(caption_of(shown, "contact_zone1"), "gaps &#215; 200")); // by the contact alone 500, a shear of 45 degrees
}

TEST_CASE("listing: lengths that are round-off are 0, as on the page") {
  const std::string listing =
      run_shell("'" + paths::program() + "' run " + quoted(example("press_fit.c2s")) + " --listing -").out;
  const size_t at = listing.find("slip range", listing.find("Contact in numbers"));
  REQUIRE(at != std::string::npos);
  CHECK(std::stod(listing.substr(at + 10)) == 0);
}

// A crack that closes without shear, between ties of larger stresses.
TEST_CASE("pictures: friction of round-off is none, and a contact comes before ties") {
  Shown shown;
  show(shown, example("crack.c2s"), "--summary " + quoted(shown.folder / "s.csv"));
  REQUIRE_MESSAGE(shown.result.status == 0, shown.result.err);
  check_page(shown);
  CHECK(!contains(shown.figures["tractions_zone1"], ">Friction<"));
  CHECK(shown.page.find("<section id=\"") == shown.page.find("<section id=\"contact_zone1\""));
  CHECK(contains(caption_of(shown, "path"), "a largest nodal pressure of 9")); // of the crack: 96; ties have thousands
  const std::string summary = read_file(shown.folder / "s.csv");
  CHECK(contains(summary, ",friction force,0,0,"));
  CHECK(contains(summary, ",force x,0,0,"));
  CHECK(!contains(summary, "edge friction"));
}

// The tutorial and the other pages with commands: these run, and print what the page shows; a lesson's file is the one shipped.
#include "page_runs.hpp"

using namespace test;

namespace {

const std::string kRoot = paths::root(), kLessons = kRoot + "/examples/tutorial";

std::string page(const std::string& name) { return read_file(kRoot + "/" + name); }

// A page says this number, and a formula gives `value`, which is it as written.
void check_formula(const std::string& text, const std::string& written, double value) {
  CHECK_MESSAGE(contains(text, written), written);
  const double number = std::strtod(written.c_str(), nullptr);
  const size_t point = written.find('.'),
               digits = point == std::string::npos ? 0 : written.find_first_of(" e", point) - point - 1;
  CHECK_MESSAGE(std::fabs(value - number) <= 0.501 * std::pow(10.0, -static_cast<double>(digits)), written << ": " << value);
}

} // namespace

TEST_CASE("tutorial: its commands run and print what it shows") { run_page(page("examples/TUTORIAL.md"), false); }

TEST_CASE("tutorial: fifteen lessons, each with its file; what it shows of a file is the file's") {
  const std::string text = page("examples/TUTORIAL.md");
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(kLessons)) files.push_back(entry.path().filename().string());
  CHECK(files.size() == 15);
  for (const std::string& file : files) CHECK_MESSAGE(contains(text, file), file);
  for (int lesson = 1; lesson <= 15; ++lesson) CHECK(contains(text, "\n## " + std::to_string(lesson) + " "));
  int seen = 0;
  for (const Block& block : blocks_of(text)) {
    if (!block.language.empty()) continue;
    ++seen;
    bool found = false;
    for (const std::string& file : files) found = found || contains(read_file(kLessons + "/" + file), block.text);
    CHECK_MESSAGE(found, block.text);
  }
  CHECK(seen >= 5);
}

TEST_CASE("tutorial: its formulas") {
  const std::string text = page("examples/TUTORIAL.md");
  const double pi = std::acos(-1.0), modulus = 206000 / (2 * (1 - 0.3 * 0.3));
  const double a = std::sqrt(4 * 200 * 5 / (pi * modulus)), p0 = 2 * 200 / (pi * a);
  check_formula(text, "0.10606 mm", a);
  check_formula(text, "1200.5 MPa", p0);
  check_formula(text, "362.8 MPa", (943.754 - 218.116) / 2);
  check_formula(text, "360 MPa", 0.300 * p0);
  // Kirsch: above the hole, at 6 of a radius 5.
  const double q = 25.0 / 36;
  check_formula(text, "207.1 MPa", 100 * (1 + 0.5 * q + 1.5 * q * q));
  // Lame: shaft 10 to 25, hub 25 to 50, one material, interference 0.01, plane strain.
  const double r2 = 25 * 25, i2 = 10 * 10, o2 = 50 * 50;
  check_formula(text, "30.288 MPa", 210e3 / 0.91 * 0.01 / 25 * (o2 - r2) * (r2 - i2) / (2 * r2 * (o2 - i2)));
  // Hertz: 5 in a groove of 60.
  check_formula(text, "-126.6 =", -1160.65 / (2 * 25 * (1.0 / 5 - 1.0 / 60)));
  // A bed of springs.
  const double bed = 3000 * (1 - 0.4) / ((1 + 0.4) * (1 - 2 * 0.4)) / 2;
  check_formula(text, "3214 N/mm^3", bed);
  check_formula(text, "0.0052 mm", 200 / 11.9 / bed);
}

TEST_CASE("pages: the program's commands on other pages run") {
  for (const char* name : {"examples/README.md", "src/report/OUTPUT.md", "include/README.md"}) {
    CAPTURE(name);
    run_page(page(name), true);
  }
}

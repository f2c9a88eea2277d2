// The gallery (examples/gallery): it is made from the sketches as they are; made again it is the same.
#include "page_runs.hpp"

#include <regex>
#include <set>

using namespace test;

namespace {

const std::string kRoot = paths::root(), kGallery = kRoot + "/examples/gallery";

std::set<std::string> files_of(const std::string& folder, const std::string& ending) {
  std::set<std::string> out;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ending) out.insert(entry.path().filename().string());
  return out;
}

std::vector<double> numbers_of(const std::string& svg) {
  std::vector<double> out;
  // Without its checksum and colours.
  const std::string text = std::regex_replace(svg.substr(0, svg.rfind("<!--")), std::regex("#[0-9a-f]{6}"), "#");
  const std::regex number("-?[0-9]+\\.?[0-9]*(e-?[0-9]+)?");
  for (std::sregex_iterator i(text.begin(), text.end(), number), end; i != end; ++i) out.push_back(std::stod(i->str()));
  return out;
}

} // namespace

TEST_CASE("gallery: it is made from the sketches as they are (else: make gallery)") {
  const std::string page = read_file(kGallery + "/README.md"), start = "<!-- made from\n";
  const Result inputs = run_shell("cd '" + kRoot + "' && sh examples/gallery/gallery.sh inputs");
  REQUIRE(inputs.status == 0);
  REQUIRE(contains(page, start));
  const std::string made_from = page.substr(page.find(start) + start.size());
  CHECK_MESSAGE(made_from == inputs.out + "-->\n", "the gallery is older than what it shows: make gallery");

  std::set<std::string> pictures; // shown; there are no others
  size_t bytes = page.size();
  const std::regex shown("\\n!\\[[^\\]]*\\]\\((\\w+\\.svg)\\)");
  for (std::sregex_iterator i(page.begin(), page.end(), shown), end; i != end; ++i) pictures.insert((*i)[1].str());
  CHECK(pictures == files_of(kGallery, ".svg"));
  for (const std::string& name : pictures) bytes += read_file(kGallery + "/" + name).size();
  CHECK(bytes < 2000000);
  for (const char* folder : {"examples/", "examples/families/"})
    for (const std::string& name : files_of(kRoot + "/" + folder, ".c2s"))
      CHECK_MESSAGE(contains(page, "\n`" + (folder + name) + "`\n"), folder << name);
  for (const auto& lesson : fs::directory_iterator(kRoot + "/examples/tutorial")) {
    const std::string name = "tutorial/" + lesson.path().filename().string();
    CHECK_MESSAGE((contains(page, "`examples/" + name + "`") || contains(page, "](../" + name + ")")), name);
  }
}

TEST_CASE("gallery: made again it is the same") {
  const Folder folder;
  const Result run = run_shell("cd '" + kRoot + "' && sh examples/gallery/gallery.sh '" + paths::program() + "' '" +
                               (folder / "gallery") + "'");
  REQUIRE_MESSAGE(run.status == 0, run.err);
  const std::vector<std::string> kept = lines_of(read_file(kGallery + "/README.md")),
                                 made = lines_of(read_file(folder / "gallery/README.md"));
  REQUIRE(kept.size() == made.size());
  for (size_t i = 0; i < kept.size(); ++i) {
    const bool is_row = kept[i].compare(0, 2, "| ") == 0; // with numbers, which another compiler may change
    CHECK_MESSAGE((is_row ? shows_line(kept[i], made[i]) : kept[i] == made[i]), kept[i] << "\nnow: " << made[i]);
  }
  for (const std::string& name : files_of(kGallery, ".svg")) {
    CAPTURE(name);
    const std::vector<double> a = numbers_of(read_file(kGallery + "/" + name)),
                              b = numbers_of(read_file(folder / ("gallery/" + name)));
    REQUIRE(a.size() == b.size());
    double worst = 0;
    for (size_t i = 0; i < a.size(); ++i) worst = std::max(worst, std::fabs(a[i] - b[i]) - 1e-3 * std::fabs(a[i]));
    CHECK(worst < 1.0); // a pixel
  }
}

// make_mutants FOLDER SEED SHARE: copies src into FOLDER with mutants in it that a number switches on (switch.hpp), and lists
// them in FOLDER/mutants.txt. Of all sites those with the smallest hash of file, line and change are taken: a change elsewhere
// leaves them as they are. FOLDER/dropped.txt has the numbers of those that do not compile.
#include "sites.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

namespace fs = std::filesystem;
using mutants::Site;

namespace {

struct Part {
  const char* name;
  std::vector<std::string> folders;
  int count; // at SHARE = 100
};
const Part kParts[] = {
    {"kernels", {"src/bie", "src/quadrature"}, 160}, {"exchange", {"src/linalg"}, 90}, {"events", {"src/contact"}, 140},
    {"elimination", {"src/elimination"}, 60},        {"blocks", {"src/store"}, 60},    {"deck", {"src/deck"}, 100}};
constexpr int kNumbersPerFile = 4000;

struct Found {
  std::string file;
  Site site;
  int number;
  uint64_t hash;
  const char* part;
};

std::string read(const fs::path& name) {
  std::ifstream in(name, std::ios::binary);
  std::ostringstream all;
  all << in.rdbuf();
  return all.str();
}

// A file that stays the same keeps its date.
void write(const fs::path& name, const std::string& text) {
  if (fs::exists(name) && read(name) == text) return;
  fs::create_directories(name.parent_path());
  std::ofstream(name, std::ios::binary) << text;
}

uint64_t hash(const std::string& s) {
  uint64_t h = 0xcbf29ce484222325u;
  for (const char c : s) h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  h = (h ^ (h >> 32)) * 0x9E3779B97F4A7C15u;
  return h ^ (h >> 29);
}

std::vector<std::string> sources_in(const std::string& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string end = entry.path().extension().string();
    if (end == ".cpp" || end == ".hpp") names.push_back(entry.path().generic_string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<Found> choose(const Part& part, int& files, const std::string& seed, int share) {
  std::vector<Found> all;
  for (const std::string& folder : part.folders)
    for (const std::string& file : sources_in(folder)) {
      int number = kNumbersPerFile * files++;
      if (number + kNumbersPerFile > C2D_MUTANTS_MOST)
        std::fprintf(stderr, "no numbers left for %s\n", file.c_str()), std::exit(1);
      for (const Site& s : mutants::sites_of(read(file)))
        all.push_back({file, s, number++, hash(seed + file + s.text + s.shown()), part.name});
    }
  std::stable_sort(all.begin(), all.end(), [](const Found& a, const Found& b) { return a.hash < b.hash; });
  std::printf("%s: %zu sites", part.name, all.size());
  const size_t count = static_cast<size_t>(part.count) * static_cast<size_t>(share) / 100;
  if (all.size() > count) all.resize(count);
  std::printf(", %zu taken\n", all.size());
  return all;
}

void copy(const fs::path& to, const std::map<std::string, std::vector<const Found*>>& chosen) {
  for (const auto& entry : fs::recursive_directory_iterator("src")) {
    const std::string name = entry.path().generic_string(), end = entry.path().extension().string();
    if (end != ".cpp" && end != ".hpp") continue;
    std::string text = read(name);
    const auto found = chosen.find(name);
    if (found != chosen.end()) {
      std::vector<Site> sites;
      std::vector<int> numbers;
      for (const Found* f : found->second) sites.push_back(f->site), numbers.push_back(f->number);
      text = mutants::with_sites(text, sites, numbers);
    }
    write(to / name, text);
  }
}

} // namespace

int main(int argc, char** argv) {
  if (argc != 4) return std::fprintf(stderr, "usage: make_mutants FOLDER SEED SHARE\n"), 64;
  const fs::path folder = argv[1];
  std::set<int> dropped;
  std::istringstream numbers(read(folder / "dropped.txt"));
  for (int n; numbers >> n;) dropped.insert(n);

  int files = 0;
  std::map<std::string, std::vector<const Found*>> chosen;
  std::ostringstream list;
  std::vector<std::vector<Found>> kept;
  for (const Part& part : kParts) kept.push_back(choose(part, files, argv[2], std::atoi(argv[3])));
  for (const auto& part : kept)
    for (const Found& f : part) {
      if (dropped.count(f.number)) continue;
      chosen[f.file].push_back(&f);
      list << f.number << '\t' << f.part << '\t' << f.file << '\t' << f.site.line << '\t' << f.site.shown() << '\t'
           << f.site.text << '\n';
    }
  copy(folder, chosen);
  write(folder / "mutants.txt", list.str());
  return 0;
}

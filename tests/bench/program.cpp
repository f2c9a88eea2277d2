// Whole jobs as processes, listing and CSV written, against an empty process.
#include "bench.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <unistd.h>

namespace bench {

namespace {

// One run of a process.
struct Spent {
  double wall, processor, kibibytes; // milliseconds
};

Spent run_once(const Options& options, const std::vector<std::string>& words) {
  std::string command = "'" + options.spawn + "' 1";
  for (const std::string& word : words) command += " '" + word + "'";
  FILE* out = popen(command.c_str(), "r");
  Spent s = {};
  const int read = out ? std::fscanf(out, "%lf %lf %lf", &s.wall, &s.processor, &s.kibibytes) : 0;
  if (!out || pclose(out) != 0 || read != 3) give_up("failed: " + command);
  return {s.wall * 1e3, s.processor * 1e3, s.kibibytes};
}

struct Case {
  std::string name, deck, store;                           // store: memory, or the folder of the tapes
  double most_more, most_mebibytes, most_all, old_program; // what was asked, 0: nothing; milliseconds
};

std::vector<std::string> command(const Options& options, const Case& c, const std::string& folder) {
  return {options.program,
          "run",
          c.deck,
          "--listing",
          folder + "/listing",
          "--csv",
          folder + "/csv",
          "--store",
          c.store == "memory" ? c.store : "file:" + c.store};
}

// A file system in memory, where a sync costs nothing; empty: none is there.
std::string quick_folder() {
  return access("/dev/shm", W_OK) == 0 ? "/dev/shm/contact2d-bench-" + std::to_string(getpid()) : "";
}

void tell(const Case& c, const std::vector<Spent>& runs, const std::vector<double>& empty) {
  std::vector<double> more, all, processor, memory;
  for (size_t i = 0; i < runs.size(); ++i) {
    more.push_back(runs[i].wall - empty[i]);
    all.push_back(runs[i].wall);
    processor.push_back(runs[i].processor);
    memory.push_back(runs[i].kibibytes / 1024);
  }
  const std::string key = "program." + c.name;
  char least[40];
  std::snprintf(least, sizeof least, "  least %.3g", *std::min_element(more.begin(), more.end()));
  row(key, median(more), "ms", judged(key + ".more", median(more), "<=", c.most_more, "") + least);
  if (c.most_all > 0) row(key + ".whole", median(all), "ms", judged(key + ".all", median(all), "<=", c.most_all, ""));
  if (c.old_program > 0)
    row(key + ".whole", median(all), "ms",
        judged(key + ".over_1987", c.old_program / median(all), ">=", 100, "times as fast as the program of 1987 (1.75 s)"));
  row(key + ".processor", median(processor), "ms", "processor time, user and system");
  row(key + ".memory", median(memory), "MiB", judged(key + ".mebibytes", median(memory), "<=", c.most_mebibytes, ""));
}

void compare(const Options& options, const std::vector<Case>& cases, const std::string& folder, int runs) {
  std::vector<double> empty;
  std::vector<std::vector<Spent>> spent(cases.size());
  for (int i = 0; i < runs + 1; ++i) { // in turns; the first round warms the caches
    const double nothing = run_once(options, {options.empty}).wall;
    if (i > 0) empty.push_back(nothing);
    for (size_t c = 0; c < cases.size(); ++c) {
      std::filesystem::remove(folder + "/listing"); // to replace a file takes some disks a while
      std::filesystem::remove(folder + "/csv");
      const Spent all = run_once(options, command(options, cases[c], folder));
      if (i > 0) spent[c].push_back(all);
    }
  }
  row("program.empty_process." + std::to_string(runs), median(empty), "ms");
  for (size_t c = 0; c < cases.size(); ++c) tell(cases[c], spent[c], empty);
}

double number_after(const std::string& text, const std::string& name, size_t from = 0) {
  const size_t at = text.find("\"" + name + "\": ", from);
  return at == std::string::npos ? 0 : std::atof(text.c_str() + at + name.size() + 4);
}

std::string summary_of(const Options& options, const Case& c, const std::string& folder) {
  std::vector<std::string> words = command(options, c, folder);
  words.push_back("--json");
  words.push_back(folder + "/json");
  run_once(options, words);
  std::ifstream file(folder + "/json");
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

// What the job says of itself: phases (medians), transfers, workspace.
void tell_phases(const Options& options, const Case& c, const std::string& folder) {
  const char* phases[] = {"read", "assemble", "eliminate", "reduce", "contact", "back", "write"};
  std::vector<double> spent[7];
  std::string json;
  for (int run = 0; run < 5; ++run) {
    json = summary_of(options, c, folder);
    for (int i = 0; i < 7; ++i) spent[i].push_back(number_after(json, phases[i], json.find("\"seconds\"")) * 1e3);
  }
  const std::string key = "program." + c.name;
  for (int i = 0; i < 7; ++i) row(key + ".phase." + phases[i], median(spent[i]), "ms");
  double moved = 0;
  for (size_t at = json.find("\"tapes\""); (at = json.find("\"bytes_written\"", at)) != std::string::npos; ++at)
    moved += number_after(json, "bytes_written", at) + number_after(json, "bytes_read", at);
  row(key + ".moved", moved / 1048576, "MiB", "to and from the block store");
  row(key + ".workspace", number_after(json, "peak_workspace_bytes") / 1048576, "MiB", "used of the workspace");
  row(key + ".events", number_after(json, "events"), "events");
}

void make_deck(const Options& options, const std::string& file, const std::string& what) {
  const std::string shell = "'" + options.program + "' make " + what + " > '" + file + "'";
  if (std::system(shell.c_str()) != 0) give_up("failed: " + shell);
}

} // namespace

void whole_program(const Options& options) {
  const std::string folder = std::filesystem::temp_directory_path() / ("contact2d-bench-" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  heading("Whole jobs, listing and CSV written: milliseconds more than an empty process, medians");
  const std::string disk = folder + "/tapes", quick = quick_folder(), examples = options.examples + "/",
                    large = folder + "/hertz.dat";
  std::vector<Case> small = {
      {"sample.memory", examples + "hertz.dat", "memory", 5, 8, 0, 0},
      {"sample.file", examples + "hertz.dat", disk, 0, 0, 0, 0},
      {"sample56", options.decks + "/sample56.dat", "memory", 0, 0, 0, 1750},
      {"half_cylinder", examples + "half_cylinder.dat", "memory", 0, 0, 10, 0},
  };
  if (!quick.empty()) small.push_back({"sample.file_without_sync", examples + "hertz.dat", quick, 0, 0, 0, 0});
  compare(options, small, folder, 30);
  make_deck(options, large, "hertz n=200 ratio=1.0075");
  const std::vector<Case> models = {{"nodes2000", large, "memory", 0, 0, 0, 0}};
  compare(options, models, folder, 3);
  for (const Case& c : {small[0], small[2], small[3], models[0]}) tell_phases(options, c, folder);
  const std::string cycle = folder + "/mindlin.dat", wide = folder + "/wide.dat";
  make_deck(options, cycle, "mindlin n=250");
  make_deck(options, wide, "hertz n=1000");
  compare(options, {{"mindlin629", cycle, "memory", 800, 0, 0, 0}, {"hertz1253", wide, "memory", 3400, 0, 0, 0}}, folder, 3);
  if (!quick.empty()) std::filesystem::remove_all(quick);
  std::filesystem::remove_all(folder);
}

} // namespace bench

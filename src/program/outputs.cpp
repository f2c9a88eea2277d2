#include "program/outputs.hpp"

#include <filesystem>
#include <sys/stat.h>

namespace app {
namespace {

// One spelling for names that lead to the same place, whether or not anything is there yet.
std::string spelled_out(const std::string& name) {
  std::error_code error;
  const std::filesystem::path path = std::filesystem::weakly_canonical(name, error);
  return error ? name : path.string();
}

constexpr size_t kInputs = 2, kNamed = kInputs + kOutputs; // the deck and the points; then the outputs that are single files
struct Named {
  const std::string* name;
  const char* what;
};

} // namespace

bool Outputs::open(const Options& o, std::string& error) {
  if (o.file(Output::kListing).empty() && has_listing(o) && !file(Output::kListing).open("-", error)) return false;
  for (size_t i = 0; i < kOutputs; ++i)
    if (!o.files[i].empty() && !files[i].open(o.files[i], error)) return false;
  return o.figures.empty() || figures.open(o.figures, error);
}

bool Outputs::flush(std::string& error) {
  for (OutputFile& file : files)
    if (file.is_open() && !file.flush(error)) return false;
  return true;
}

bool Outputs::publish(std::string& error) {
  std::vector<OutputFile*> all = figures.files();
  for (OutputFile& file : files) all.push_back(&file);
  for (OutputFile* file : all) // what can be taken back first
    if (file->renames() && !file->finish(error)) return false;
  for (OutputFile* file : all)
    if (!file->finish(error)) return false;
  for (OutputFile* file : all)
    if (!file->publish(error)) return false;
  figures.keep();
  return true;
}

std::string find_clash(const Options& o) {
  Named all[kNamed] = {{&o.deck, "the deck"}, {&o.points, "--points"}};
  for (size_t i = 0; i < kOutputs; ++i) all[kInputs + i] = {&o.files[i], kOutputTable[i].option};
  if (o.deck == "-" && o.points == "-") return "the deck and --points both come from standard input";
  struct stat about[kNamed];
  bool regular[kNamed];
  for (size_t i = 0; i < kNamed; ++i) {
    const std::string& name = *all[i].name;
    regular[i] = !name.empty() && name != "-" && ::stat(name.c_str(), &about[i]) == 0 && S_ISREG(about[i].st_mode);
  }
  for (size_t i = 0; i < kNamed; ++i)
    for (size_t k = i + 1; k < kNamed; ++k) {
      const std::string &a = *all[i].name, &b = *all[k].name;
      if (i >= kInputs && a == "-" && b == "-")
        return std::string(all[i].what) + " and " + all[k].what + " both go to standard output";
      const bool names = i >= kInputs && !a.empty() && !b.empty() && a != "-" && b != "-";
      const bool same_name = names && ::stat(a.c_str(), &about[i]) != 0 && spelled_out(a) == spelled_out(b);
      const bool same_file =
          regular[i] && regular[k] && about[i].st_dev == about[k].st_dev && about[i].st_ino == about[k].st_ino;
      if (same_name || (same_file && k >= kInputs))
        return std::string(all[i].what) + " and " + all[k].what + " are the same file";
    }
  return std::string();
}

} // namespace app

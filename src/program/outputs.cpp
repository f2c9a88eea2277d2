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

constexpr int kInputs = 2, kNamed = 9; // the deck and the points; then the outputs that are single files
struct Named {
  const std::string* name;
  const char* what;
};

} // namespace

bool Outputs::open(const Options& o, std::string& error) {
  const auto wanted = [&](const std::string& name, OutputFile& file) {
    return name.empty() || file.open(name, error);
  };
  if (o.listing.empty() && has_listing(o) && !listing.open("-", error)) return false;
  return wanted(o.listing, listing) && wanted(o.csv, csv) && wanted(o.boundary, boundary) &&
         wanted(o.interior, interior) && wanted(o.json, json) && wanted(o.report, report) && wanted(o.vtk, vtk) &&
         (o.figures.empty() || figures.open(o.figures, error));
}

bool Outputs::flush(std::string& error) {
  for (OutputFile* file : {&listing, &csv, &boundary, &interior, &json, &report, &vtk})
    if (file->is_open() && !file->flush(error)) return false;
  return true;
}

bool Outputs::publish(std::string& error) {
  std::vector<OutputFile*> files = figures.files();
  for (OutputFile* file : {&listing, &csv, &boundary, &interior, &json, &report, &vtk}) files.push_back(file);
  for (OutputFile* file : files) // what can be taken back first
    if (file->renames() && !file->finish(error)) return false;
  for (OutputFile* file : files)
    if (!file->finish(error)) return false;
  for (OutputFile* file : files)
    if (!file->publish(error)) return false;
  figures.keep();
  return true;
}

std::string find_clash(const Options& o) {
  const Named all[kNamed] = {
      {&o.deck, "the deck"},         {&o.points, "--points"},     {&o.listing, "--listing"},
      {&o.csv, "--csv"},             {&o.boundary, "--boundary"}, {&o.interior, "--interior"},
      {&o.json, "--json"},           {&o.report, "--report"},     {&o.vtk, "--vtk"}};
  if (o.deck == "-" && o.points == "-") return "the deck and --points both come from standard input";
  struct stat about[kNamed];
  bool regular[kNamed];
  for (int i = 0; i < kNamed; ++i) {
    const std::string& name = *all[i].name;
    regular[i] =
        !name.empty() && name != "-" && ::stat(name.c_str(), &about[i]) == 0 && S_ISREG(about[i].st_mode);
  }
  for (int i = 0; i < kNamed; ++i)
    for (int k = i + 1; k < kNamed; ++k) {
      const std::string &a = *all[i].name, &b = *all[k].name;
      if (i >= kInputs && a == "-" && b == "-")
        return std::string(all[i].what) + " and " + all[k].what + " both go to standard output";
      const bool names = i >= kInputs && !a.empty() && !b.empty() && a != "-" && b != "-";
      const bool same_name = names && ::stat(a.c_str(), &about[i]) != 0 && spelled_out(a) == spelled_out(b);
      const bool same_file = regular[i] && regular[k] && about[i].st_dev == about[k].st_dev &&
                             about[i].st_ino == about[k].st_ino;
      if (same_name || (same_file && k >= kInputs))
        return std::string(all[i].what) + " and " + all[k].what + " are the same file";
    }
  return std::string();
}

} // namespace app

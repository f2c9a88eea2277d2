#include "program/outputs.hpp"

#include <sys/stat.h>

namespace app {

bool Outputs::open(const Options& options, std::string& error) {
  const bool taken = options.csv == "-" || options.boundary == "-" || options.json == "-";
  const std::string& wanted = options.listing;
  if (!wanted.empty() && !listing.open(wanted, error)) return false;
  if (wanted.empty() && !taken && !listing.open("-", error)) return false;
  if (!options.csv.empty() && !csv.open(options.csv, error)) return false;
  if (!options.boundary.empty() && !boundary.open(options.boundary, error)) return false;
  return options.json.empty() || json.open(options.json, error);
}

bool Outputs::flush(std::string& error) {
  for (OutputFile* file : {&listing, &csv, &boundary, &json})
    if (file->is_open() && !file->flush(error)) return false;
  return true;
}

bool Outputs::publish(std::string& error) {
  OutputFile* const files[] = {&listing, &csv, &boundary, &json};
  for (OutputFile* file : files) // what can be taken back first
    if (file->renames() && !file->finish(error)) return false;
  for (OutputFile* file : files)
    if (!file->finish(error)) return false;
  for (OutputFile* file : files)
    if (!file->publish(error)) return false;
  return true;
}

std::string find_clash(const Options& options) {
  const std::string* const names[] = {&options.deck, &options.listing, &options.csv, &options.boundary,
                                      &options.json};
  static const char* const kWhat[] = {"the deck", "--listing", "--csv", "--boundary", "--json"};
  struct stat about[5];
  bool regular[5];
  for (int i = 0; i < 5; ++i)
    regular[i] = !names[i]->empty() && *names[i] != "-" && ::stat(names[i]->c_str(), &about[i]) == 0 &&
                 S_ISREG(about[i].st_mode);
  for (int i = 0; i < 5; ++i)
    for (int k = i + 1; k < 5; ++k) {
      const bool same_name = i > 0 && *names[i] == *names[k] && !names[i]->empty() && *names[i] != "-" &&
                             ::stat(names[i]->c_str(), &about[i]) != 0;
      const bool same_file = regular[i] && regular[k] && about[i].st_dev == about[k].st_dev &&
                             about[i].st_ino == about[k].st_ino;
      if (same_name || same_file) return std::string(kWhat[i]) + " and " + kWhat[k] + " are the same file";
    }
  return std::string();
}

} // namespace app

#include "program/outputs/outputs.hpp"

#include "program/files/system_file.hpp"
#include "program/outputs/results.hpp"
#include "report/interior.hpp"

#include <c2d_posix.h>

#include <filesystem>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

namespace app {
namespace {

// Is it a regular file, or will it be one?
bool is_regular_file(const std::string& name) {
  struct stat about = {};
  return !name.empty() && name != "-" && (::stat(name.c_str(), &about) != 0 || S_ISREG(about.st_mode));
}

// Is it a regular file without a place for its inputs? They go into a file beside it.
bool has_inputs(size_t output, const std::string& name) {
  return (kOutputTable[output].needs & kInputsBeside) != 0 && is_regular_file(name);
}

// One spelling for names that lead to the same place, whether or not anything is there yet.
std::string spelled_out(const std::string& name) {
  std::error_code error;
  const std::filesystem::path path =
      std::filesystem::weakly_canonical(std::filesystem::absolute(std::filesystem::u8path(name), error), error);
  if (error) return name;
  std::string text = path.lexically_normal().generic_u8string();
  const bool any_case = std::filesystem::path::preferred_separator != '/'; // Windows, of letters of ASCII
  for (char& c : text)
    if (any_case && c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

// A file that the run reads or writes.
struct Named {
  std::string name, what;
  bool is_output;
  std::string place; // spelled out; empty for a standard stream
  bool exists, regular;
  struct stat about;

  Named(const std::string& name_, const std::string& what_, bool is_output_) : name(name_), what(what_), is_output(is_output_) {
    about = {};
    exists = name != "-" && ::stat(name.c_str(), &about) == 0;
    regular = exists && S_ISREG(about.st_mode);
    if (name != "-") place = spelled_out(name);
  }
  bool is_same(const Named& other) const {
    if (regular && other.regular) return about.st_dev == other.about.st_dev && about.st_ino == other.about.st_ino;
    return !exists && !place.empty() && place == other.place;
  }
  bool is_within(const std::string& folder) const { return place.compare(0, folder.size() + 1, folder + "/") == 0; }
};

std::vector<Named> named_files(const Options& o, const std::vector<std::string>& also_read) {
  std::vector<Named> all;
  if (o.job == nullptr) { // else they stand in the job
    all.emplace_back(o.deck, "the deck", false);
    if (!o.points.empty()) all.emplace_back(o.points, "--points", false);
    if (!o.params.empty()) all.emplace_back(o.params, "--params", false);
    if (!o.table.empty()) all.emplace_back(o.table, "the table", false);
  }
  for (const std::string& name : also_read) all.emplace_back(name, "the file " + name + " of the sketch", false);
  for (size_t i = 0; i < kOutputs; ++i) {
    const char* const option = kOutputTable[i].option;
    if (!o.files[i].empty()) all.emplace_back(o.files[i], option, true);
    if (has_inputs(i, o.files[i])) all.emplace_back(o.files[i] + kInputsEnding, std::string("the inputs of ") + option, true);
  }
  for (const auto& [name, option] : {std::make_pair(&o.results, "--results"), std::make_pair(&o.row, "--row")}) {
    if (!name->empty()) all.emplace_back(*name, option, true);
    if (is_regular_file(*name)) all.emplace_back(*name + kInputsEnding, std::string("the inputs of ") + option, true);
  }
  return all;
}

std::string clash_of(const Named& a, const Named& b) {
  if (!b.is_output)
    return a.name == "-" && b.name == "-" ? a.what + " and " + b.what + " both come from standard input" : std::string();
  if (a.is_output && a.name == "-" && b.name == "-") return a.what + " and " + b.what + " both go to standard output";
  return a.is_same(b) ? a.what + " and " + b.what + " are the same file" : std::string();
}

// Folders that the run fills itself: that of its store, and that of its figures, whose names are known at the end only.
std::string folder_clash(const Options& o, const std::vector<Named>& files) {
  const bool in_files = o.store.compare(0, 5, "file:") == 0;
  const std::string store = in_files ? spelled_out(o.store.substr(5) + "/" C2D_POSIX_STORE_FOLDER) : std::string();
  const std::string figures = o.figures.empty() ? std::string() : spelled_out(o.figures);
  const auto within = [&store](const std::string& what) { return what + " lies in " + store + ", the folder of --store"; };
  for (const Named& file : files) {
    if (in_files && file.is_within(store)) return within(file.what);
    const bool picture = file.place.size() > 4 && file.place.compare(file.place.size() - 4, 4, ".svg") == 0;
    if (!figures.empty() && picture && file.is_within(figures))
      return file.what + " is an SVG file in the folder of --figures: a picture may have the same name";
  }
  const bool figures_within = in_files && (figures + "/").compare(0, store.size() + 1, store + "/") == 0;
  return figures_within ? within("--figures") : std::string();
}

// Does the name have points of a run? In the folder of --out an earlier one may have left them, which this one, without points,
// then writes anew: with no rows.
bool is_interior(const std::string& name) {
  std::string header, there;
  std::error_code none;
  append_interior_header(header);
  return !name.empty() && name != "-" && std::filesystem::is_regular_file(std::filesystem::u8path(name), none) &&
         read_file(name, there) == 0 && there.compare(0, header.size(), header) == 0;
}

} // namespace

bool Outputs::open(const Options& o, bool has_points, std::string& error) {
  if (!o.out.empty() && !out.open(o.out, error)) return false;
  if (o.file(Output::kListing).empty() && has_listing(o)) {
    if (!file(Output::kListing).open("-", error)) return false;
    shows_end_alone = ::isatty(1) == 1;
  }
  for (size_t i = 0; i < kOutputs; ++i) {
    const bool left_out =
        o.interior_if_any && !has_points && i == static_cast<size_t>(Output::kInterior) && !is_interior(o.files[i]);
    if (!o.files[i].empty() && !left_out && !files[i].open(o.files[i], error)) return false;
    if (files[i].is_open() && has_inputs(i, o.files[i]) && !inputs[i].open(o.files[i] + kInputsEnding, error)) return false;
  }
  return o.figures.empty() || figures.open(o.figures, error);
}

uint32_t Outputs::needs() const {
  uint32_t all = figures.is_open() ? kOutputTable[static_cast<size_t>(Output::kReport)].needs : 0;
  for (size_t i = 0; i < kOutputs; ++i) all |= files[i].is_open() ? kOutputTable[i].needs : 0;
  return all;
}

c2d_status Outputs::begin(RunResults& run) {
  run.has_short_listing = shows_end_alone;
  c2d_status status = C2D_OK;
  for (size_t i = 0; i < kOutputs && status == C2D_OK; ++i)
    if (files[i].is_open() && kOutputTable[i].begin != nullptr) status = kOutputTable[i].begin(run, files[i].text);
  return status;
}

void Outputs::step(RunResults& run, const StepResults& now) {
  for (size_t i = 0; i < kOutputs; ++i)
    if (files[i].is_open() && kOutputTable[i].step != nullptr) kOutputTable[i].step(run, now, files[i].text);
}

c2d_status Outputs::end(RunResults& run, std::string& error) {
  for (const Picture& picture : run.pictures)
    if (figures.is_open() && !figures.add(picture.name + ".svg", picture.svg, error)) return C2D_ERR_CALLBACK;
  c2d_status status = run.refresh();
  for (const bool with_times : {false, true})
    for (size_t i = 0; i < kOutputs && status == C2D_OK; ++i) {
      const OutputRow& row = kOutputTable[i];
      if (!files[i].is_open() || row.end == nullptr || ((row.needs & kNeedsTimes) != 0) != with_times) continue;
      status = row.end(run, files[i].text);
      if (status == C2D_OK) status = run.refresh(); // with what this output has taken
    }
  for (OutputFile& file : inputs)
    if (file.is_open()) file.text = inputs_text(run.record.inputs);
  return status;
}

bool Outputs::flush(std::string& error) {
  for (OutputFile& file : files)
    if (file.is_open() && !file.flush(error)) return false;
  return true;
}

bool Outputs::publish(std::string& error) {
  std::vector<OutputFile*> all = figures.files();
  for (OutputFile& file : files) all.push_back(&file);
  for (OutputFile& file : inputs) all.push_back(&file);
  if (!publish_all(all, error)) return false;
  return figures.remove_earlier(error) && figures.keep(error) && out.keep(error);
}

std::string find_clash(const Options& o, const std::vector<std::string>& also_read) {
  const std::vector<Named> files = named_files(o, also_read);
  for (size_t i = 0; i < files.size(); ++i)
    for (size_t k = i + 1; k < files.size(); ++k)
      if (const std::string clash = clash_of(files[i], files[k]); !clash.empty()) return clash;
  return folder_clash(o, files);
}

} // namespace app

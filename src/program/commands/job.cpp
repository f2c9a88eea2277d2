#include "program/commands/job.hpp"

#include "program/commands/archive.hpp"
#include "program/estimate/kept.hpp"
#include "program/exit_code.hpp"
#include "program/files/sealed_file.hpp"
#include "program/files/sha256.hpp"
#include "program/files/system_file.hpp"
#include "program/option_table.hpp"

#include <c2d_posix.h>

#include <filesystem>
#include <memory>

namespace app {

template <class Archive> void members(Archive& a, NamedText& file) { a(file.name), a(file.text); }
template <class Archive> void members(Archive& a, InputFile& file) { a(file.name), a(file.sha256); }
template <class Archive> void members(Archive& a, std::pair<std::string, std::string>& p) { a(p.first), a(p.second); }
template <class Archive> void members(Archive& a, Inputs& i) { a(i.files), a(i.parameters), a(i.options); }

namespace {

const char kName[] = "/job", kJobKind[] = "contact2d job 5";

template <class Archive> void members(Archive& a, Job& job, std::string& meshes) {
  a(job.form), a(job.begun), a(job.deck_name), a(job.deck), a(job.settings), a(job.files), a(job.has_points), a(job.points),
      a(job.workspace), a(job.words), a(job.inputs), a(meshes);
}

std::string text_of(Job job) {
  std::string meshes = estimate::text_of(job.meshes);
  ArchiveWriter writer;
  members(writer, job, meshes);
  return writer.take();
}

bool read_text(const std::string& text, Job& job) {
  std::string meshes;
  ArchiveReader reader(text);
  members(reader, job, meshes);
  return reader.is_sound_to_the_end() && estimate::read_meshes(meshes, job.meshes);
}

bool is_file_name(const std::string& option) {
  const OptionRow* const row = find_option(Command::kRun, option);
  return row != nullptr && row->value != nullptr && (row->value == std::string("FILE") || row->value == std::string("DIR"));
}
// Options that the job contains itself or that apply to one call only.
bool is_left_out(const std::string& name) {
  return name == "--store" || name == "--memory" || name == "--progress" || name == "--no-progress" || name == "--points" ||
         name == "--set" || name == "--params";
}

std::string absolute(const std::string& name) {
  std::error_code failed;
  const std::filesystem::path path = std::filesystem::absolute(std::filesystem::u8path(name), failed);
  return failed || name == "-" ? name : path.u8string();
}

} // namespace

std::vector<std::string> words_of(const Options& options) {
  std::vector<std::string> words;
  for (const auto& [name, value] : options.given) {
    if (is_left_out(name)) continue;
    words.push_back(value.empty() ? name : name + "=" + (is_file_name(name) ? absolute(value) : value));
  }
  return words;
}

std::vector<std::string> words_that_change_digits(const Options& options) {
  const char* const names[] = {"--memory",      "--stepping", "--quadrature", "--symmetry",
                               "--elimination", "--touching", "--estimate",   "--points"};
  std::vector<std::string> out;
  for (const auto& [name, value] : options.given)
    for (const char* one : names)
      if (name == one) out.push_back(value.empty() ? name : name + "=" + value);
  return out;
}

Inputs inputs_of(const Options& options, const Inputs& of_deck, const std::string& points) {
  if (options.job != nullptr) return options.job->inputs;
  Inputs out = of_deck;
  out.options = words_that_change_digits(options);
  if (!options.points.empty()) out.files.push_back(input_file(options.points, points));
  return out;
}

std::string id_of(const Job& job) { return sum_of(text_of(job)); }

bool keep_job(const std::string& store_folder, const Job& job, std::string& error) {
  return write_sealed(store_folder + kName, kJobKind, text_of(job), error);
}

int find_job(Options& options, std::string& error) {
  const std::string path = options.folder + "/" + C2D_POSIX_STORE_FOLDER + kName;
  std::string text;
  const Sealed found = read_sealed(path, kJobKind, text, error);
  if (found == Sealed::kAbsent)
    error = options.folder +
            ": no run to resume: none was started there, it has finished, or it was interrupted before it saved "
            "anything (no file " +
            path + ")";
  if (found != Sealed::kWhole) return found == Sealed::kAbsent ? kExitInput : kExitFiles;
  const auto job = std::make_shared<Job>();
  std::vector<const char*> words = {"contact2d", "run"};
  bool sound = read_text(text, *job);
  for (const std::string& word : job->words) words.push_back(word.c_str());
  const std::string store = "--store=file:" + options.folder, points = "--points=" + path;
  words.push_back(store.c_str());
  if (job->has_points) words.push_back(points.c_str());
  words.insert(words.end(), {"--", "deck"});
  Options read;
  sound = sound && read_options(static_cast<int>(words.size()), words.data(), read, error);
  if (!sound) return error = path + ": has another version" + (error.empty() ? "" : ": " + error), kExitFiles;
  read.deck = job->deck_name;
  read.folder = options.folder;
  read.memory = job->workspace;
  read.progress = options.progress;
  read.settings = job->settings;
  read.job = job;
  options = read;
  return 0;
}

bool is_kept(const std::string& store_folder, const Job& job) {
  std::string text, ignored;
  return read_sealed(store_folder + kName, kJobKind, text, ignored) == Sealed::kWhole && text == text_of(job);
}

bool remove_way(const std::string& store_folder, std::string& error) {
  std::vector<std::string> names;
  const int code = list_folder(store_folder, names);
  if (code != 0) error = store_folder + ": cannot be read: " + system_text(code);
  if (code != 0) return false;
  for (const std::string& name : names) {
    const bool is_of_way = name.compare(0, 4, "path") == 0 || name.compare(0, 4, "mesh") == 0;
    if (is_of_way && !remove_file(store_folder + "/" + name, error)) return false;
  }
  return true;
}

bool remove_job(const std::string& store_folder, std::string& error) { return remove_sealed(store_folder + kName, error); }

} // namespace app

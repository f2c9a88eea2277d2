#include "program/files/figure_folder.hpp"

#include "program/files/sealed_file.hpp"
#include "program/files/system_file.hpp"

#include <cerrno>
#include <filesystem>
#include <sys/stat.h>
#include <unistd.h>

namespace app {
namespace {

// The last line of a file: its name and checksum identify an unchanged file of a run.
std::string mark_of(const std::string& name, const std::string& text) {
  return "<!-- contact2d " + name + " " + sum_of(text) + " -->\n";
}

bool is_picture(const std::string& name) { return name.size() > 4 && name.compare(name.size() - 4, 4, ".svg") == 0; }

bool is_as_written(const std::string& path, const std::string& name) {
  std::error_code error;
  if (std::filesystem::symlink_status(std::filesystem::u8path(path), error).type() != std::filesystem::file_type::regular)
    return false;
  std::string text;
  if (read_file(path, text) != 0) return false;
  const size_t length = mark_of(name, "").size();
  if (text.size() < length) return false;
  const std::string mark = text.substr(text.size() - length);
  text.resize(text.size() - length);
  return mark == mark_of(name, text);
}

} // namespace

FigureFolder::~FigureFolder() {
  files_.clear(); // what lies aside goes first
  if (made_) ::rmdir(folder_.c_str());
}

bool FigureFolder::open(const std::string& folder, std::string& error) {
  made_ = ::mkdir(folder.c_str(), 0777) == 0;
  int code = made_ || errno == EEXIST ? 0 : errno;
  if (code == 0 && ::access((folder + "/.").c_str(), W_OK | X_OK) != 0) code = errno; // (also where it is a file)
  folder_ = folder;
  if (code != 0) error = folder + ": cannot be written: " + system_text(code);
  return code == 0;
}

bool FigureFolder::add(const std::string& name, const std::string& text, std::string& error) {
  files_.push_back(std::make_unique<OutputFile>());
  if (!files_.back()->open(folder_ + "/" + name, error)) return false;
  files_.back()->text = text + mark_of(name, text);
  names_.insert(name);
  return files_.back()->flush(error);
}

bool FigureFolder::remove_earlier(std::string& error) const {
  if (!is_open() || made_) return true;
  std::vector<std::string> there;
  if (const int code = list_folder(folder_, there); code != 0)
    return error = folder_ + ": cannot be read: " + system_text(code), false;
  for (const std::string& name : there) {
    const std::string path = folder_ + "/" + name;
    if (!is_picture(name) || names_.count(name) > 0 || !is_as_written(path, name)) continue;
    if (!remove_file(path, error)) return false;
  }
  return true;
}

bool FigureFolder::keep(std::string& error) {
  const int code = made_ ? sync_folder(folder_ + "/..") : 0;
  made_ = false;
  if (code != 0) error = folder_ + ": cannot be flushed to disk: " + system_text(code);
  return code == 0;
}

std::vector<OutputFile*> FigureFolder::files() const {
  std::vector<OutputFile*> out;
  for (const auto& file : files_) out.push_back(file.get());
  return out;
}

} // namespace app

#include "program/figure_folder.hpp"

#include "program/system_file.hpp"

#include <cerrno>
#include <sys/stat.h>
#include <unistd.h>

namespace app {

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
  files_.back()->text = text;
  return files_.back()->flush(error);
}

bool FigureFolder::keep(std::string& error) {
  const int code = made_ ? sync_folder(folder_ + "/..") : 0;
  made_ = false;
  if (code != 0) error = folder_ + ": cannot be made safe: " + system_text(code);
  return code == 0;
}

std::vector<OutputFile*> FigureFolder::files() const {
  std::vector<OutputFile*> out;
  for (const auto& file : files_) out.push_back(file.get());
  return out;
}

} // namespace app

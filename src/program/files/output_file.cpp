#include "program/files/output_file.hpp"

#include "program/files/system_file.hpp"

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <functional>
#include <memory>
#include <set>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace app {
namespace {

const char* const kNotWritten = "cannot be written";
// Temporary files are written in pieces. Direct output stays in memory up to a limit, so that a cancelled or failed run
// prints nothing.
const size_t kPiece = size_t{1} << 18, kDirectPiece = size_t{1} << 26;

std::atomic<bool> broken_pipe{false};

// Locks the file; 0: this process has the lock, and the file still has its name.
int lock(int file) {
  while (::flock(file, LOCK_EX | LOCK_NB) != 0)
    if (errno != EINTR) return errno;
  struct stat about;
  if (::fstat(file, &about) != 0) return errno;
  return about.st_nlink > 0 ? 0 : ENOENT;
}

// A running process locks its temporary file: an unlocked one was left by a killed process.
void remove_left(const std::string& name) {
  const int file = open_file(name, O_WRONLY | O_NOFOLLOW | O_NONBLOCK);
  if (file < 0) return;
  if (lock(file) == 0) ::unlink(name.c_str());
  ::close(file);
}

// A new locked file; below 0 with errno.
int make_held(const std::string& name) {
  const int file = open_file(name, O_RDWR | O_CREAT | O_EXCL);
  if (file < 0) return file;
  const int code = lock(file);
  if (code == 0 || code == ENOLCK || code == EOPNOTSUPP) return file; // without locks no other run removes it
  ::close(file);
  if (code != EWOULDBLOCK && code != ENOENT) ::unlink(name.c_str()); // these: another run is removing it as abandoned
  errno = code;
  return -1;
}

} // namespace

OutputFile::~OutputFile() {
  if (file_ > 2) ::close(file_);
  if (!aside_.empty()) ::unlink(aside_.c_str());
}

bool OutputFile::succeeds(int code, const char* what, std::string& error) const {
  if (code != 0) error = name_ + ": " + what + ": " + system_text(code);
  return code == 0;
}

bool OutputFile::open(const std::string& name, std::string& error) {
  name_ = name == "-" ? "standard output" : name;
  target_ = name;
  struct stat about;
  if (name == "-") {
    direct_ = true;
    file_ = 1;
    // One that was closed leads to nothing (open_standard_files); it is found before the work. No other reason is one yet.
    const bool is_closed = ::write(1, "", size_t{0}) < 0 && errno == EBADF;
    return succeeds(is_closed ? EBADF : 0, kNotWritten, error);
  }
  const bool exists = ::stat(name.c_str(), &about) == 0;
  if (exists && !S_ISREG(about.st_mode)) {
    direct_ = true;
    file_ = open_file(name, O_WRONLY | O_NOCTTY);
    return succeeds(file_ >= 0 ? 0 : errno, kNotWritten, error);
  }
  if (!exists && errno != ENOENT) return succeeds(errno, kNotWritten, error);
  if (exists) { // through symbolic links; and not if the file itself may not be written
    if (::access(name.c_str(), W_OK) != 0) return succeeds(errno, kNotWritten, error);
    const std::unique_ptr<char, decltype(&std::free)> real(::realpath(name.c_str(), nullptr), std::free);
    if (real == nullptr) return succeeds(errno, kNotWritten, error);
    target_ = real.get();
  }
  if (!open_aside(error)) return false;
  if (exists) (void)!::fchmod(file_, about.st_mode & 07777);
  return true;
}

bool OutputFile::open_aside(std::string& error) {
  char mark[24]; // of the name alone: a run that is resumed may know the folder by another path
  const size_t own = std::hash<std::string>()(target_.substr(begin_of_name(target_)));
  std::snprintf(mark, sizeof mark, ".contact2d-%08x-", static_cast<unsigned>(own & 0xffffffffu));
  for (int i = 0; file_ < 0 && i < 1000; ++i) {
    aside_ = folder_of(target_) + "/" + mark + std::to_string(i);
    file_ = make_held(aside_);
    if (file_ >= 0) return true;
    if (errno == EEXIST) {
      remove_left(aside_);
      file_ = make_held(aside_);
    }
    if (file_ < 0 && errno != EEXIST && errno != EWOULDBLOCK && errno != ENOENT) break; // these: another run's
  }
  if (file_ >= 0) return true;
  const int code = errno;
  aside_.clear();
  return succeeds(code, kNotWritten, error);
}

bool OutputFile::so_far(std::string& all, std::string& error) {
  all.clear();
  if (is_gone_) return false;
  const int code = direct_ ? 0 : read_from_start(file_, all);
  all += text;
  return succeeds(code, "cannot be read back", error);
}

bool OutputFile::write_text(std::string& error) {
  is_gone_ = direct_ && (is_gone_ || !text.empty());
  int code = write_all(file_, text);
  text.clear();
  if (code == EPIPE) { // nobody reads any more: the other outputs are still wanted
    broken_pipe = true;
    code = 0;
  }
  return succeeds(code, "write failed", error);
}

bool OutputFile::flush(std::string& error) { return text.size() < (direct_ ? kDirectPiece : kPiece) || write_text(error); }

bool OutputFile::finish(std::string& error) {
  if (file_ < 0) return true;
  if (!write_text(error)) return false;
  if (renames()) return succeeds(sync_file(file_), "cannot be flushed to disk", error); // and locked until it is renamed
  const int file = file_;
  file_ = -1;
  return succeeds(file > 2 ? close_file(file) : 0, "close failed", error);
}

bool OutputFile::publish(std::string& error) {
  if (aside_.empty()) return true;
  if (::rename(aside_.c_str(), target_.c_str()) != 0) return succeeds(errno, "rename failed", error);
  aside_.clear();
  ::close(file_); // nothing is left to be written
  file_ = -1;
  return true;
}

std::string OutputFile::folder() const { return folder_of(target_); }

bool publish_all(const std::vector<OutputFile*>& files, std::string& error) {
  for (OutputFile* file : files) // what can be taken back first
    if (file->renames() && !file->finish(error)) return false;
  for (OutputFile* file : files)
    if (!file->renames() && !file->finish(error)) return false;
  std::set<std::string> folders;
  for (OutputFile* file : files) {
    if (file->renames()) folders.insert(file->folder());
    if (!file->publish(error)) return false;
  }
  for (const std::string& folder : folders)
    if (const int code = sync_folder(folder); code != 0)
      return error = folder + ": names of outputs cannot be flushed to disk: " + system_text(code), false;
  return true;
}

bool pipe_is_broken() { return broken_pipe; }

bool write_output(const std::string& name, const std::string& text, std::string& error) {
  OutputFile out;
  if (!out.open(name.empty() ? "-" : name, error)) return false;
  out.text = text;
  return publish_all({&out}, error);
}

} // namespace app

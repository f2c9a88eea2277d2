#include "program/files/system_file.hpp"

#include "program/interrupt.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <dirent.h>
#include <fcntl.h>
#include <filesystem>
#include <memory>
#include <new>
#include <sys/stat.h>
#include <unistd.h>

namespace app {
namespace {

// Windows separates by either, and has drives.
constexpr bool kWindows = std::filesystem::path::preferred_separator != '/';
constexpr const char* kSeparators = kWindows ? "/\\" : "/";
size_t begin_without_drive(const std::string& path) { return kWindows && path.size() > 1 && path[1] == ':' ? 2 : 0; }

} // namespace

void open_standard_files() {
  int file;
  do file = ::open("/dev/null", O_RDONLY);
  while (file >= 0 && file <= 2); // the lowest that is free
  if (file > 2) ::close(file);
}

int open_file(const std::string& path, int flags) {
  int file;
  do {
    file = ::open(path.c_str(), flags | O_CLOEXEC, 0666);
  } while (file < 0 && errno == EINTR && !interrupted());
  return file;
}

int read_all(int file, std::string& text) {
  std::vector<char> chunk(size_t{1} << 16);
  for (;;) {
    const ssize_t got = ::read(file, chunk.data(), chunk.size());
    if (got == 0) return 0;
    if (got > 0)
      text.append(chunk.data(), static_cast<size_t>(got));
    else if (errno != EINTR)
      return errno;
  }
}

int read_from_start(int file, std::string& text) {
  std::vector<char> chunk(size_t{1} << 16);
  for (off_t at = 0;;) {
    const ssize_t got = ::pread(file, chunk.data(), chunk.size(), at);
    if (got == 0) return 0;
    if (got > 0)
      text.append(chunk.data(), static_cast<size_t>(got)), at += got;
    else if (errno != EINTR)
      return errno;
  }
}

int write_all(int file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t put = ::write(file, text.data(), text.size());
    if (put == 0) return EIO; // no bytes taken, and no reason given
    if (put > 0)
      text.remove_prefix(static_cast<size_t>(put));
    else if (errno != EINTR)
      return errno;
  }
  return 0;
}

int sync_file(int file) {
  while (::fsync(file) != 0)
    if (errno != EINTR) return errno;
  return 0;
}

int close_file(int file) { return ::close(file) == 0 || errno == EINTR ? 0 : errno; }

int sync_folder(const std::string& folder) {
  const int file = open_file(folder, O_RDONLY | O_DIRECTORY);
  if (file < 0) return errno == EACCES ? 0 : errno; // one may write into folders that one may not read
  const int code = sync_file(file);
  ::close(file);
  return code == EINVAL || code == ENOTSUP ? 0 : code;
}

int read_file(const std::string& path, std::string& text) {
  const int file = open_file(path, O_RDONLY);
  if (file < 0) return errno;
  const int code = read_all(file, text);
  ::close(file);
  return code;
}

std::string read_text(int file, std::string& text) {
  const int code = file < 0 ? errno : read_all(file, text);
  return code == 0 ? "" : "cannot be read: " + system_text(code);
}

std::string read_named(const std::string& path, std::string& text) {
  constexpr off_t kMostBytes = off_t{64} << 20;
  struct stat about;
  // before it is opened, which may wait for a writer or move a tape, and afterwards, as another may have taken its name
  if (::stat(path.c_str(), &about) == 0 && !S_ISREG(about.st_mode)) return "is no regular file";
  const int file = open_file(path, O_RDONLY);
  std::string why;
  if (file >= 0 && ::fstat(file, &about) == 0) {
    if (!S_ISREG(about.st_mode)) why = "is no regular file";
    if (about.st_size > kMostBytes) why = "has more than 64 MiB";
  }
  if (why.empty()) why = read_text(file, text);
  if (file >= 0) ::close(file);
  return why;
}

// (The iterators of <filesystem> end the process where there is no memory.)
int list_folder(const std::string& folder, std::vector<std::string>& names) {
  struct Close {
    void operator()(DIR* list) const { ::closedir(list); }
  };
  std::unique_ptr<DIR, Close> list;
  do list.reset(::opendir(folder.c_str()));
  while (list == nullptr && errno == EINTR && !interrupted());
  if (list == nullptr) return errno;
  for (errno = 0; const dirent* entry = ::readdir(list.get()); errno = 0) {
    const std::string_view name = entry->d_name;
    if (name != "." && name != "..") names.emplace_back(name);
  }
  return errno;
}

std::string system_text(int code) {
  if (code == ENOMEM) throw std::bad_alloc();
  return std::strerror(code);
}

size_t begin_of_name(const std::string& path) {
  return std::max(path.find_last_of(kSeparators) + 1, begin_without_drive(path)); // npos + 1: 0
}

bool is_absolute(const std::string& path) {
  const size_t begin = begin_without_drive(path);
  return begin > 0 || path.find_first_of(kSeparators) == 0;
}

std::string folder_of(const std::string& path) {
  const size_t begin = begin_of_name(path), drive = begin_without_drive(path);
  if (begin == drive) return path.substr(0, drive) + ".";
  return path.substr(0, std::max(begin - 1, drive + (begin - 1 == drive)));
}

} // namespace app

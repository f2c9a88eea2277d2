#include "program/output_file.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace app {
namespace {

// What is written aside goes out in pieces; what is written directly waits in memory, so that a cancelled or
// failed run has printed nothing, as long as that is reasonable.
const size_t kPiece = size_t{1} << 18, kDirectPiece = size_t{1} << 26;

std::string folder_of(const std::string& path) {
  const size_t slash = path.rfind('/');
  return slash == std::string::npos ? std::string() : path.substr(0, slash + 1);
}

} // namespace

OutputFile::~OutputFile() {
  if (file_ > 2) ::close(file_);
  if (!aside_.empty()) ::unlink(aside_.c_str());
}

bool OutputFile::fail(const char* what, int code, std::string& error) const {
  error = name_ + ": " + what + ": " + std::strerror(code);
  return false;
}

bool OutputFile::open(const std::string& name, std::string& error) {
  name_ = name == "-" ? "standard output" : name;
  target_ = name;
  struct stat about;
  if (name == "-") {
    direct_ = true;
    file_ = 1;
    return ::fstat(1, &about) == 0 || fail("cannot be written", errno, error);
  }
  const bool exists = ::stat(name.c_str(), &about) == 0;
  if (exists && !S_ISREG(about.st_mode)) {
    direct_ = true;
    file_ = ::open(name.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY);
    return file_ >= 0 || fail("cannot be written", errno, error);
  }
  if (!exists && errno != ENOENT) return fail("cannot be written", errno, error);
  if (exists) { // through symbolic links; and not if the file itself may not be written
    if (::access(name.c_str(), W_OK) != 0) return fail("cannot be written", errno, error);
    if (char* real = ::realpath(name.c_str(), nullptr)) {
      target_ = real;
      std::free(real);
    }
  }
  for (int i = 0; file_ < 0 && i < 1000; ++i) {
    aside_ = folder_of(target_) + ".contact2d-" + std::to_string(::getpid()) + "-" + std::to_string(i);
    file_ = ::open(aside_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file_ < 0 && errno != EEXIST) break;
  }
  if (file_ < 0) {
    const int code = errno;
    aside_.clear();
    return fail("cannot be written", code, error);
  }
  if (exists) (void)!::fchmod(file_, about.st_mode & 07777);
  return true;
}

bool OutputFile::write_all(std::string& error) {
  size_t done = 0;
  while (done < text.size()) {
    const ssize_t put = ::write(file_, text.data() + done, text.size() - done);
    if (put < 0 && errno == EINTR) continue;
    if (put < 0) return fail("write failed", errno, error);
    done += static_cast<size_t>(put);
  }
  text.clear();
  return true;
}

bool OutputFile::flush(std::string& error) { return text.size() < (direct_ ? kDirectPiece : kPiece) || write_all(error); }

bool OutputFile::finish(std::string& error) {
  if (file_ < 0) return true;
  const bool written = write_all(error);
  const int file = file_;
  file_ = -1;
  if (file > 2 && ::close(file) != 0 && written) return fail("close failed", errno, error);
  return written;
}

bool OutputFile::publish(std::string& error) {
  if (aside_.empty()) return true;
  if (::rename(aside_.c_str(), target_.c_str()) != 0) return fail("rename failed", errno, error);
  aside_.clear();
  return true;
}

bool write_output(const std::string& name, const std::string& text, std::string& error) {
  OutputFile out;
  if (!out.open(name.empty() ? "-" : name, error)) return false;
  out.text = text;
  return out.finish(error) && out.publish(error);
}

} // namespace app

#include "program/sweep/journal.hpp"

#include "program/exit_code.hpp"
#include "program/files/sealed_file.hpp"
#include "program/files/system_file.hpp"

#include <cerrno>
#include <charconv>
#include <cstdio>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace app {
namespace {

std::string hexadecimal(uint64_t number) {
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(number));
  return text;
}

// "row checksum text", the checksum of row and text.
std::string line_of(size_t row, const std::string& text) {
  const std::string number = std::to_string(row), all = number + " " + text;
  return number + " " + hexadecimal(checksum_of(all, all.size())) + " " + text + "\n";
}

bool read_line(const std::string& line, size_t& row, std::string& text) {
  const auto read = std::from_chars(line.data(), line.data() + line.size(), row);
  const size_t at = static_cast<size_t>(read.ptr - line.data());
  if (read.ec != std::errc() || line.size() < at + 18) return false;
  text = line.substr(at + 18);
  return line_of(row, text) == line + "\n";
}

} // namespace

Journal::~Journal() {
  if (file_ >= 0) ::close(file_);
}

int Journal::open(const std::string& path, uint64_t inputs, bool resume, std::string& error) {
  path_ = path;
  const std::string heading = "contact2d sweep " + hexadecimal(inputs) + "\n";
  file_ = open_file(path, O_RDWR | O_APPEND | O_CREAT | (resume ? 0 : O_EXCL));
  if (file_ < 0 && errno == EEXIST)
    return error = path + ": contains rows of an interrupted sweep, expected --resume, or the file removed", kExitInput;
  if (file_ < 0 || ::flock(file_, LOCK_EX | LOCK_NB) != 0) {
    const bool busy = file_ >= 0 && errno == EWOULDBLOCK;
    error = path + ": " + (busy ? "another process is running this sweep" : system_text(errno));
    return busy ? kExitBusy : kExitFiles;
  }
  if (const int exit = take_rows(heading, error); exit != 0) return exit;
  return 0;
}

int Journal::take_rows(const std::string& heading, std::string& error) {
  std::string all;
  int code = read_all(file_, all);
  const bool torn = !all.empty() && all.back() != '\n';
  // An empty file or an incomplete heading; after a power loss, data not yet on disk may read as zeros.
  const std::string known = all.substr(0, all.find_last_not_of('\0') + 1);
  if (code == 0 && heading.compare(0, known.size(), known) == 0) {
    if (::ftruncate(file_, 0) != 0) code = errno;
    if (code == 0) code = write_all(file_, heading);
    all = heading;
  } else if (code == 0 && torn) {
    code = write_all(file_, "\n");
  }
  if (code != 0) return error = path_ + ": " + system_text(code), kExitFiles;
  if (all.compare(0, heading.size(), heading) != 0)
    return error = path_ + ": contains rows of another sweep: the table, the deck, the options or the program differ",
           kExitInput;
  for (size_t at = heading.size(); at < all.size();) {
    const size_t end = std::min(all.find('\n', at), all.size());
    size_t row = 0;
    std::string text;
    if (read_line(all.substr(at, end - at), row, text)) rows_[row] = text;
    at = end + 1;
  }
  return 0;
}

bool Journal::add(size_t row, const std::string& text, std::string& error) {
  rows_[row] = text;
  const int code = write_all(file_, line_of(row, text));
  if (code != 0) error = path_ + ": a row cannot be added: " + system_text(code);
  return code == 0;
}

void Journal::remove() {
  if (file_ >= 0) ::unlink(path_.c_str());
}

} // namespace app

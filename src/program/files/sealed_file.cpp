#include "program/files/sealed_file.hpp"

#include "program/files/system_file.hpp"

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <fcntl.h>
#include <unistd.h>

namespace app {
namespace {

bool seal_failed(const std::string& path, const char* what, int code, std::string& error) {
  error = path + ": " + what + ": " + system_text(code);
  return false;
}
std::string aside_of(const std::string& path) { return path + ".new"; }

constexpr size_t kSealLength = 42; // "end ", 20 digits, " ", 16 digits, "\n"
std::string seal_of(const std::string& text, size_t count) {
  char seal[kSealLength + 1];
  std::snprintf(seal, sizeof seal, "end %020zu %016llx\n", count, static_cast<unsigned long long>(checksum_of(text, count)));
  return seal;
}

int write_aside(const std::string& aside, const std::string& text) {
  ::unlink(aside.c_str()); // remains of an interrupted write
  const int file = open_file(aside, O_WRONLY | O_CREAT | O_EXCL);
  if (file < 0) return errno;
  int code = write_all(file, text);
  if (code == 0) code = sync_file(file);
  const int closed = close_file(file);
  return code != 0 ? code : closed;
}

} // namespace

// Fowler, Noll and Vo's: multiplication with an odd number can be undone.
uint64_t checksum_of(const std::string& text, size_t count) {
  uint64_t sum = 14695981039346656037u;
  for (size_t i = 0; i < count; ++i) sum = (sum ^ static_cast<unsigned char>(text[i])) * 1099511628211u;
  return sum;
}

std::string sum_of(const std::string& text) {
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(checksum_of(text, text.size())));
  return digits;
}

bool write_sealed(const std::string& path, const std::string& kind, const std::string& text, std::string& error) {
  std::string all = kind + '\n' + text;
  all += seal_of(all, all.size());
  const std::string aside = aside_of(path);
  int code = write_aside(aside, all);
  if (code == 0 && ::rename(aside.c_str(), path.c_str()) != 0) code = errno;
  if (code != 0) {
    ::unlink(aside.c_str());
    return seal_failed(path, "cannot be written", code, error);
  }
  code = sync_folder(folder_of(path));
  if (code == 0) return true;
  return seal_failed(path, "cannot be flushed to disk", code, error);
}

Sealed read_sealed(const std::string& path, const std::string& kind, std::string& text, std::string& error) {
  text.clear();
  const int code = read_file(path, text);
  if (code == ENOENT || code == ENOTDIR) return Sealed::kAbsent;
  if (code != 0) return seal_failed(path, "cannot be read", code, error), Sealed::kFailed;
  const std::string first = kind + '\n';
  const size_t length = text.size() < kSealLength ? 0 : text.size() - kSealLength;
  const bool whole = length >= first.size() && text.compare(length, kSealLength, seal_of(text, length)) == 0;
  if (!whole) {
    error = path + ": is damaged or incomplete";
    return Sealed::kFailed;
  }
  if (text.compare(0, first.size(), first) != 0) {
    error = path + ": has another version: '" + text.substr(0, text.find('\n')) + "', expected '" + kind + "'";
    return Sealed::kFailed;
  }
  text = text.substr(first.size(), length - first.size());
  return Sealed::kWhole;
}

bool remove_file(const std::string& path, std::string& error) {
  if (::unlink(path.c_str()) == 0 || errno == ENOENT) return true;
  return seal_failed(path, "cannot be removed", errno, error);
}

bool remove_sealed(const std::string& path, std::string& error) {
  return remove_file(path, error) && remove_file(aside_of(path), error);
}

} // namespace app

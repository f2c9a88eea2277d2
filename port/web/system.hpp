// Features missing in the C and C++ libraries of Debian for wasm32, included before everything else: signals, which never
// occur; links and permissions of files, which a page has not; std::from_chars for double.
#pragma once
#include <charconv>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <string>
#include <sys/stat.h>

struct sigaction {
  void (*sa_handler)(int);
  int sa_flags, sa_mask;
};
constexpr int SA_RESETHAND = 0;
inline int sigemptyset(int*) { return 0; }
inline int sigaction(int, const struct sigaction*, struct sigaction*) { return 0; }
inline char* realpath(const char* name, char*) { return strdup(name); }
inline int fchmod(int, mode_t) { return 0; }
inline char* mkdtemp(char* name) { return mkdir(name, 0700) == 0 ? name : nullptr; } // no other process exists

namespace web {

inline const char* digits(const char* at, const char* end) {
  while (at != end && *at >= '0' && *at <= '9') ++at;
  return at;
}
inline const char* word(const char* at, const char* end, const char* expected) {
  for (; *expected != '\0'; ++at, ++expected)
    if (at == end || (*at | 0x20) != *expected) return nullptr;
  return at;
}
// The end of the longest number that begins there; null: none.
inline const char* end_of_number(const char* at, const char* end) {
  if (at != end && *at == '-') ++at;
  for (const char* each : {"infinity", "inf", "nan"})
    if (const char* behind = word(at, end, each)) return behind;
  const char* whole = digits(at, end);
  const char* behind = whole != end && *whole == '.' ? digits(whole + 1, end) : whole;
  if (behind - at - (behind != whole) == 0) return nullptr;
  if (behind == end || (*behind | 0x20) != 'e') return behind;
  const char* power = behind + 1;
  if (power != end && (*power == '+' || *power == '-')) ++power;
  return digits(power, end) == power ? behind : digits(power, end);
}

} // namespace web

namespace std {
inline from_chars_result from_chars(const char* first, const char* last, double& value) {
  const char* end = web::end_of_number(first, last);
  if (end == nullptr) return {first, errc::invalid_argument};
  const string text(first, end);
  const double read = strtod(text.c_str(), nullptr); // strtod is correctly rounded and has no locales here
  const bool is_special = text.find_first_of("iInN") != string::npos;
  const bool zero = text.find_first_of("123456789") >= text.find_first_of("eE");
  if (!is_special && (std::isinf(read) || (read == 0 && !zero))) return {end, errc::result_out_of_range};
  value = read;
  return {end, errc()};
}
} // namespace std

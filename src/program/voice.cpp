#include "program/voice.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <unistd.h>

namespace app {
namespace {
thread_local bool muted = false;
thread_local std::string reason;
} // namespace

void say(const std::string& text) {
  const std::string error = coloured(Colour::kError, "error:") + " ";
  const size_t at = text.find(error);
  if (reason.empty() && at != std::string::npos) {
    const size_t begin = at + error.size();
    reason = text.substr(begin, std::min(text.find('\n', begin), text.size()) - begin);
  }
  if (!muted) std::fwrite(text.data(), 1, text.size(), stderr);
}

std::string reason_told() { return reason; }
void forget_reason() { reason.clear(); }

Muted::Muted() { muted = true; }
Muted::~Muted() { muted = false; }

std::string coloured(Colour colour, const std::string& text) {
  const char *no = std::getenv("NO_COLOR"), *terminal = std::getenv("TERM");
  const bool plain = (no != nullptr && *no != '\0') || terminal == nullptr || std::string(terminal) == "dumb";
  if (plain || muted || ::isatty(2) != 1) return text;
  static const char* const kCodes[] = {"1;31", "1;35", "1;36", "1;32"}; // in the order of Colour
  return std::string("\033[") + kCodes[static_cast<size_t>(colour)] + "m" + text + "\033[0m";
}

} // namespace app

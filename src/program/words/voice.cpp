#include "program/words/voice.hpp"

#include "report/text.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <unistd.h>

namespace app {
namespace {
thread_local bool muted = false;
thread_local char reason[8192]; // (not a string: the C library ends the process if it has no memory for the destructor of one)

constexpr const char* kColours[] = {"\033[1;31m", "\033[1;35m", "\033[1;36m", "\033[1;32m"}; // in the order of Colour
constexpr const char* kPlain = "\033[0m";

// Of what the program itself sends to a terminal: a colour, the end of a line, a tab; 0: nothing of it begins there.
size_t own_code_at(const std::string& text, size_t i) {
  if (text[i] == '\n' || text[i] == '\t') return 1;
  if (text[i] != '\033' && text[i] != '\r') return 0;
  for (const char* code : {kColours[0], kColours[1], kColours[2], kColours[3], kPlain, kClearLine})
    if (text.compare(i, std::strlen(code), code) == 0) return std::strlen(code);
  return 0;
}
// Is it neither a printable character of ASCII nor the end of a line?
bool is_odd(char c) { return (c < ' ' || c > '~') && c != '\n'; }

} // namespace

void say(const std::string& text) {
  const std::string error = coloured(Colour::kError, "error:") + " ";
  const size_t at = text.find(error);
  if (reason[0] == '\0' && at != std::string::npos) {
    const size_t begin = at + error.size(), end = std::min({text.find('\n', begin), text.size(), begin + sizeof reason - 1});
    text.copy(reason, end - begin, begin);
    reason[end - begin] = '\0';
  }
  if (muted) return;
  const size_t odd = static_cast<size_t>(std::find_if(text.begin(), text.end(), is_odd) - text.begin());
  std::string out = text.substr(0, odd);
  for (size_t i = odd, next = 0; i < text.size(); i = next) {
    const size_t stays = std::max<size_t>(own_code_at(text, i), character_at(text, i));
    next = i + std::max<size_t>(stays, 1);
    stays > 0 ? out.append(text, i, stays) : out.append(1, '?');
  }
  std::fwrite(out.data(), 1, out.size(), stderr);
}

int fail(const std::string& text, int exit) {
  say("contact2d: " + coloured(Colour::kError, "error:") + " " + shown(text) + "\n");
  return exit;
}

std::string reason_told() { return reason; }
void forget_reason() { reason[0] = '\0'; }

Muted::Muted() { muted = true; }
Muted::~Muted() { muted = false; }

std::string coloured(Colour colour, const std::string& text) {
  const char *no = std::getenv("NO_COLOR"), *terminal = std::getenv("TERM");
  const bool plain = (no != nullptr && *no != '\0') || terminal == nullptr || std::string(terminal) == "dumb";
  if (plain || muted || ::isatty(2) != 1) return text;
  return kColours[static_cast<size_t>(colour)] + text + kPlain;
}

} // namespace app

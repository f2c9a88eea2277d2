#include "program/drawing/formats/names.hpp"

#include "program/drawing/text.hpp"

namespace drawing {
namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Letters, digits, _ and - behind a letter; at most as long as a name of a body may be.
std::string cleaned(const std::string& raw) {
  constexpr size_t kLongest = 27; // and a number where two become the same
  std::string out;
  for (const char c : raw) {
    const bool inside = (static_cast<unsigned char>(c) & 0xC0) == 0x80; // a letter of several bytes becomes one _
    if (!inside) out += is_letter(c) || is_digit(c) || c == '_' || c == '-' ? c : '_';
  }
  if (out.empty() || !is_letter(out[0])) out.insert(0, out.empty() || out[0] != '_' ? "c_" : "c");
  return out.substr(0, kLongest);
}

// Words that stand behind `line` or `arc` where a curve has no name.
bool is_reserved(const std::string& name) {
  for (const char* word : {"to", "by", "through", "centre", "close", "radius", "cut", "turn", "t", "file"})
    if (name == word) return true;
  return false;
}

} // namespace

std::string Names::name(const std::string& raw) {
  const auto found = known_.find(raw);
  if (found != known_.end()) return found->second;
  std::string out = cleaned(raw);
  if (is_reserved(out)) out += "_";
  const std::string stem = out;
  for (int i = 2; taken_.count(out) > 0; ++i) out = stem + "-" + std::to_string(i);
  taken_.insert(out);
  return known_[raw] = out;
}

std::string Names::numbered(const std::string& stem) {
  std::string out;
  do out = stem + std::to_string(++last_[stem]);
  while (taken_.count(out) > 0);
  taken_.insert(out);
  return out;
}

std::vector<std::string> Names::changes() const {
  std::vector<std::string> out;
  for (const auto& [raw, name] : known_)
    if (raw != name) out.push_back("name " + shown(raw) + " is changed to " + name);
  return out;
}

} // namespace drawing

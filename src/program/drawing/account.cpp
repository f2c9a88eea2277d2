#include "program/drawing/account.hpp"

#include "program/drawing/text.hpp"

#include <algorithm>

namespace drawing {
namespace {

constexpr size_t kMostReasons = 20;

std::string counted(int count, const std::string& kind) {
  const bool plural =
      count != 1 && kind.back() >= 'a' && kind.back() <= 'z' && kind.back() != 's'; // not of types of a DXF file
  return std::to_string(count) + " " + printable(kind) + (plural ? "s" : "");
}

} // namespace

void Account::add(std::vector<Entry>& entries, std::string_view kind, const std::string& why, int line) {
  const auto known =
      std::find_if(entries.begin(), entries.end(), [&](const Entry& e) { return e.kind == kind && e.why == why; });
  if (known != entries.end())
    ++known->count;
  else if (entries.size() < kMostReasons)
    entries.push_back({std::string(kind), why, 1, line});
  else if (entries.size() == kMostReasons)
    entries.push_back({"other entities", "for other reasons", 1, line});
  else
    ++entries.back().count;
}

void Account::append(std::vector<std::string>& out, const char* what, const std::vector<Entry>& entries) {
  for (const Entry& e : entries) {
    std::string text = what + counted(e.count, e.kind);
    if (e.line > 0) text += (e.count > 1 ? " (from line " : " (line ") + std::to_string(e.line) + ")";
    out.push_back(text + ": " + e.why);
  }
}

std::vector<std::string> Account::notes() const {
  std::vector<std::string> out;
  std::string read;
  for (const auto& [kind, count] : read_) read += (read.empty() ? "read: " : ", ") + counted(count, kind);
  if (!read.empty()) out.push_back(read);
  append(out, "left out: ", left_out_);
  append(out, "repaired: ", repaired_);
  return out;
}

} // namespace drawing

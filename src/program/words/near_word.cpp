#include "program/words/near_word.hpp"

#include <algorithm>
#include <cctype>

namespace app {
namespace {

char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

// Letters that are inserted, deleted or replaced on the way from one word to the other.
size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<size_t> row(b.size() + 1); // distances between the first letters of both words
  for (size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (const char c : a) {
    size_t corner = row[0]++;
    for (size_t j = 0; j < b.size(); ++j) {
      const size_t changed = corner + (lower(c) == lower(b[j]) ? 0 : 1);
      corner = row[j + 1];
      row[j + 1] = std::min({changed, corner + 1, row[j] + 1});
    }
  }
  return row.back();
}

} // namespace

std::string nearest(const std::string& word, const std::vector<std::string>& words) {
  std::string best;
  size_t least = std::min<size_t>(3, word.size() / 2 + 1);
  for (const std::string& other : words)
    if (const size_t distance = edit_distance(word, other); distance < least) least = distance, best = other;
  return best;
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& words) {
  const std::string near = nearest(word, words);
  return near.empty() ? near : ", did you mean '" + near + "'?";
}

std::string offer(const std::string& word, const std::vector<std::string>& words) {
  const std::string near = did_you_mean(word, words);
  if (!near.empty() || words.empty()) return near;
  std::string list = ", expected one of";
  for (const std::string& known : words) list += " " + known;
  return list;
}

} // namespace app

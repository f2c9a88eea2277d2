// Suggestions for misspelt words: commands, options, parameters, keys, statements.
#pragma once

#include <string>
#include <vector>

namespace app {

// The word that differs from `word` by at most two letters, ignoring case; empty: none.
std::string nearest(const std::string& word, const std::vector<std::string>& words);
// ", did you mean 'run'?", to be appended to a message; empty: no word is near.
std::string did_you_mean(const std::string& word, const std::vector<std::string>& words);
// The same, or ", expected one of run check" with all words; empty: there are none.
std::string offer(const std::string& word, const std::vector<std::string>& words);

} // namespace app

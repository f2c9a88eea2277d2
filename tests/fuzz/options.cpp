// Words of the command line, one per line; those of `make` make the deck of a family, which is then read.
#include "fuzz.hpp"

#include "program/commands/families.hpp"
#include "program/options.hpp"

#include <algorithm>

namespace {

// Numbers of elements are asked for: a large one makes a large deck.
bool is_modest(const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    size_t digits = 0;
    for (const char c : word) digits += c >= '0' && c <= '9';
    if (digits > 2 || word.find_first_of("eE", word.find('=')) != std::string::npos) return false;
  }
  return words.size() <= 12;
}

void make(const std::vector<std::string>& words) {
  if (words.front() == "--list" || !is_modest(words)) return;
  std::string deck, error;
  if (!families::make_deck(words.front(), {words.begin() + 1, words.end()}, deck, error))
    return fuzz::require(!error.empty(), "what is refused is told");
  std::vector<c2d_body_limits> bodies(1000);
  c2d_limits limits = C2D_INIT(c2d_limits);
  limits.bodies = 1000, limits.body = bodies.data();
  fuzz::Lines lines(deck);
  fuzz::require(c2d_scan_deck(fuzz::Lines::read, &lines, &limits, nullptr) == C2D_OK, "a family's deck is a deck");
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  std::vector<std::string> words = {"contact2d"};
  const std::string text = fuzz::text_of(data, size);
  for (size_t at = 0; at < text.size();) {
    const size_t end = std::min(text.find('\n', at), text.size());
    words.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  std::vector<const char*> argv;
  for (const std::string& word : words) argv.push_back(word.c_str());
  argv.push_back(nullptr);
  app::Options options;
  std::string error;
  const bool read = app::read_options(static_cast<int>(words.size()), argv.data(), options, error);
  fuzz::require(read == error.empty(), "read, or told why not");
  if (!read) return 0;
  using app::Command;
  const Command command = options.command;
  const bool reads = command == Command::kRun || command == Command::kCheck || command == Command::kSketch ||
                     command == Command::kMesh || command == Command::kConvert;
  fuzz::require(!reads || !options.deck.empty(), "a file that is read has a name");
  fuzz::require(command != Command::kResume || !options.folder.empty(), "a folder that is resumed has a name");
  fuzz::require(options.threads >= 0 && options.threads <= 64, "a number of threads");
  if (command == Command::kMake) make(options.words);
  return 0;
}

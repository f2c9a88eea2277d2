// Arithmetic of sketches and values of their parameters. The first byte chooses what the rest is.
#include "fuzz.hpp"

#include "program/commands/drawn_deck.hpp"
#include "program/estimate/loop.hpp"
#include "program/sketch/read/statement.hpp"

#include <algorithm>
#include <cmath>

namespace {

const sketch::Parameters kParameters = {{"a", 2.5}, {"b", -1}, {"r0", 0}};

void evaluate(const std::string& text) {
  for (const bool quoted : {false, true})
    for (const char* variable : {"", "t"}) try {
        const sketch::Expression expression({text, {1, 1, static_cast<int>(text.size())}, quoted}, kParameters,
                                            {variable, "y"});
        const double value = expression.value(), again = expression.value();
        fuzz::require(value == again || (std::isnan(value) && std::isnan(again)), "a value that stays");
        expression.at(0.5);
        expression.at(0.25, -3);
      } catch (const sketch::Fault& fault) {
        fuzz::require(!fault.text.empty() && fault.at.line == 1 && fault.at.column >= 1 && fault.at.end >= fault.at.column - 1,
                      "a fault with its place");
      }
}

// All words of a line, each taken as everything it may be.
void split(const std::string& text) {
  try {
    const std::vector<sketch::Word> words = sketch::words_of(text, 1);
    for (const sketch::Word& word : words)
      fuzz::require(word.at.column >= 1 && static_cast<size_t>(word.at.end) <= text.size(), "a word within its line");
    if (words.empty()) return;
    sketch::Statement s(words, kParameters);
    while (s.has_more()) {
      if (s.is_share())
        s.share("a share");
      else if (s.is_number())
        s.field("a number");
      else
        s.take("a word");
    }
  } catch (const sketch::Fault& fault) {
    fuzz::require(!fault.text.empty() && fault.at.line == 1, "a fault with its line");
  }
}

// NAME=VALUE for a sketch that has such parameters.
void set(const std::string& text) {
  app::DeckFile deck;
  deck.call("fuzz.c2s");
  deck.replace("parameter w = 2, h = 1\nbody plate E = 1000 nu = 0.3\n  from 0 0\n  line base to w 0\n  line right to w h\n"
               "  line top to 0 h\n  line left to 0 0\nfix plate base\npressure plate top 1\n");
  std::vector<std::string> settings;
  for (size_t at = 0; at <= text.size();) {
    const size_t end = std::min(text.find('\n', at), text.size());
    settings.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  app::MeshLoop loop;
  const int status = app::take_sketch(deck, {settings, false}, loop);
  fuzz::require(status == 0 || status == 2 || status == 64, "a deck, a bad sketch or bad usage");
  if (status != 0) return;
  std::vector<c2d_body_limits> bodies(4);
  c2d_limits limits = C2D_INIT(c2d_limits);
  limits.bodies = 4, limits.body = bodies.data();
  fuzz::Lines lines(deck.text());
  fuzz::require(c2d_scan_deck(fuzz::Lines::read, &lines, &limits, nullptr) == C2D_OK, "the mesh of a sketch is a deck");
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  if (size == 0) return 0;
  const std::string text = fuzz::text_of(data + 1, size - 1);
  if (data[0] % 3 == 0) evaluate(text);
  if (data[0] % 3 == 1 && text.find('\n') == std::string::npos) split(text);
  if (data[0] % 3 == 2) set(text);
  return 0;
}

// A deck through the words of the program: check, convert there and back, mesh --halve.
#include "fuzz.hpp"

#include "program/commands/commands.hpp"
#include "program/estimate/mesh/halved.hpp"
#include "program/exit_code.hpp"
#include "program/session.hpp"
#include "program/sketch/read/read.hpp"

#include <contact2d_cards.h>

#include <unistd.h>

namespace {

// A file for the whole process.
class Scratch {
public:
  Scratch() {
    const char* const folder = std::getenv("TMPDIR");
    std::string path = (folder != nullptr ? std::string(folder) : std::string("/tmp")) + "/c2d_fuzz_XXXXXX";
    const int file = ::mkstemp(path.data());
    fuzz::require(file >= 0, "a file for the deck");
    ::close(file);
    name = path;
  }
  ~Scratch() { ::unlink(name.c_str()); }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  void write(std::string_view text) const {
    std::FILE* const file = std::fopen(name.c_str(), "wb");
    fuzz::require(file != nullptr && std::fwrite(text.data(), 1, text.size(), file) == text.size(), "the deck is written");
    std::fclose(file);
  }
  std::string read() const {
    std::string text;
    std::FILE* const file = std::fopen(name.c_str(), "rb");
    fuzz::require(file != nullptr, "what was written is there");
    char part[4096];
    for (size_t got; (got = std::fread(part, 1, sizeof part, file)) > 0;) text.append(part, got);
    std::fclose(file);
    return text;
  }
  std::string name;
};

int convert(const Scratch& from, const Scratch& to, const char* form) {
  app::Options options;
  options.deck = from.name, options.output = to.name, options.convert_to = form;
  const int exit = app::convert_deck(options);
  fuzz::require(exit == app::kExitSolved || exit == app::kExitInput, "converted, or refused as a bad deck");
  return exit;
}

// What a deck says, its comments left out.
std::string meaning(const std::string& text) {
  struct Said {
    std::string text;
    static void add(void* context, const c2d_card* card) {
      if (card->kind == C2D_CARD_REMARK || card->kind == C2D_CARD_COMMENT || card->kind == C2D_CARD_FREE) return;
      char field[80];
      std::snprintf(field, sizeof field, "%d %d %a ", static_cast<int>(card->kind), static_cast<int>(card->column),
                    card->value);
      const std::string_view words(card->text, static_cast<size_t>(card->length));
      const bool is_text = card->kind == C2D_CARD_HEADING || card->kind == C2D_CARD_EXTENSION;
      const std::string_view kept = card->kind == C2D_CARD_EXTENSION ? words.substr(0, words.find('!')) : words;
      const size_t first = kept.find_first_not_of(" \t"), last = kept.find_last_not_of(" \t");
      static_cast<Said*>(context)->text +=
          field + (is_text && first != kept.npos ? std::string(kept.substr(first, last + 1 - first)) : std::string()) + '\n';
    }
  } said;
  std::vector<c2d_body_limits> bodies(text.size() / 8 + 1);
  fuzz::Lines lines(text);
  fuzz::require(c2d_walk_deck(fuzz::Lines::read, &lines, bodies.data(), static_cast<int32_t>(bodies.size()), Said::add, &said,
                              nullptr, nullptr) == C2D_OK,
                "what was converted is a deck");
  return said.text;
}

// Once it is in a form, a deck goes to the other and back and says the same.
void convert_there_and_back(const Scratch& deck) {
  static const Scratch free, fixed, again;
  if (convert(deck, free, "free") != 0 || convert(free, fixed, "fixed") != 0) return;
  fuzz::require(convert(fixed, again, "free") == 0, "what was converted can be converted back");
  fuzz::require(meaning(free.read()) == meaning(again.read()), "converted there and back it says the same");
}

bool is_small(const app::Session& session) {
  int64_t elements = 0;
  for (int32_t b = 0; b < session.limits.bodies; ++b) elements += session.limits.body[b].elements;
  return elements <= 200;
}

void halve(app::Session& session) {
  std::string error;
  const std::string halved = estimate::halved_deck(session.solver, session.deck.text(), error);
  if (halved.empty()) return fuzz::require(!error.empty(), "what cannot be halved is told");
  std::vector<c2d_body_limits> bodies(static_cast<size_t>(session.limits.bodies) + 1);
  c2d_limits limits = C2D_INIT(c2d_limits);
  limits.bodies = static_cast<int32_t>(bodies.size()), limits.body = bodies.data();
  fuzz::Lines lines(halved);
  fuzz::require(c2d_scan_deck(fuzz::Lines::read, &lines, &limits, nullptr) == C2D_OK, "a halved deck is a deck");
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  static const Scratch deck;
  const std::string text = fuzz::text_of(data, size);
  if (sketch::is_sketch(text)) return 0;
  deck.write(text);
  app::Session session;
  const std::vector<std::string> none;
  int exit = session.read_file(deck.name, {none, false});
  const bool is_deck = exit == 0;
  fuzz::require(is_deck || exit == app::kExitInput, "accepted or refused as a bad deck");
  if (!is_deck) {
    fuzz::require(!session.messages.latest().empty() || text.find('\0') != std::string::npos, "what is refused is told");
    return 0;
  }
  convert_there_and_back(deck);
  uint64_t minimum = 0;
  if (c2d_memory_need(&session.limits, &minimum, nullptr, nullptr) != C2D_OK || minimum > (8u << 20)) return 0;
  exit = session.read_model_alone();
  fuzz::require(exit == 0 || exit == app::kExitInput, "a model, or a bad deck");
  if (exit == 0 && is_small(session)) halve(session);
  return 0;
}

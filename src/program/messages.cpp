#include "program/messages.hpp"

#include "program/commands/drawn_words.hpp"
#include "program/exit_code.hpp"
#include "program/files/output_file.hpp"
#include "program/words/voice.hpp"
#include "report/text.hpp"

#include <algorithm>
#include <cstdio>

namespace app {

namespace {
const int kMostFaults = 1000; // printed; a file that is no deck at all has one on every card

// Faults of the deck are printed as they come, there may be many. Another failure belongs to the call that returns it,
// whose caller knows whether it is one for the user: a state that cannot be taken up is not.
bool is_of_deck(const c2d_error& fault) {
  return (fault.status >= C2D_ERR_ARGUMENT && fault.status <= C2D_ERR_READ && fault.status != C2D_ERR_MEMORY) ||
         fault.status == C2D_ERR_STORE_CLOSE; // after that there is no solver to ask
}
} // namespace

bool Messages::is_end_of_platen(const c2d_error& entry) const {
  return entry.status == C2D_WARN_TIE_END && first_platen_zone > 0 && entry.zone >= first_platen_zone;
}

bool Messages::has_warned(c2d_status kind) const {
  return std::any_of(warnings_.begin(), warnings_.end(), [&](const c2d_error& w) { return w.status == kind; });
}

void Messages::log(void* context, const c2d_error* reported) {
  Messages& m = *static_cast<Messages*>(context);
  c2d_error in_words = *reported;
  const c2d_error* const entry = &in_words;
  if (m.deck_.is_made())
    std::snprintf(in_words.text, sizeof in_words.text, "%s", in_words_of_drawing(reported->text, m.deck_.text()).c_str());
  if (entry->severity == C2D_WARNING) {
    if (m.is_end_of_platen(*entry)) return;
    if (m.deck_.is_made() &&
        (is_about_mesh(*reported) || is_at_natural_end(*entry, m.deck_.text()) || m.has_warned(entry->status)))
      return;
    m.warnings_.push_back(*entry);
    if (m.print_warnings && !m.quiet) say(quote(m.deck_, *entry, "warning"));
    return;
  }
  if (entry->severity == C2D_FAULT && !is_of_deck(*entry)) return;
  m.latest_ = entry->text;
  if (entry->severity != C2D_FAULT) return;
  ++m.faults_;
  if (m.faults_ <= kMostFaults) say(quote(m.deck_, *entry, "error"));
  if (m.faults_ == kMostFaults + 1) m.fail("too many errors; the others are not printed");
}

void Messages::log_cards(void* context, const c2d_error* entry) {
  c2d_error error = *entry;
  if (error.status == C2D_ERR_LIMIT)
    std::snprintf(error.text, sizeof error.text, "more bodies than the cards of the deck can describe, %zu",
                  most_bodies(static_cast<Messages*>(context)->deck_));
  log(context, &error);
}

int Messages::fault(const c2d_error& error, int exit) {
  if (faults_ > 0) return exit;
  c2d_error shown = error;
  if (shown.text[0] == '\0') std::snprintf(shown.text, sizeof shown.text, "%s", c2d_message(shown.status));
  if (deck_.is_made())
    std::snprintf(shown.text, sizeof shown.text, "%s", in_words_of_drawing(std::string(shown.text), deck_.text()).c_str());
  say(quote(deck_, shown, "error"));
  faults_ = 1;
  return exit;
}

int Messages::fail(const std::string& text, int exit) const {
  const std::string words = deck_.is_made() ? in_words_of_drawing(text, deck_.text()) : text;
  say("contact2d: " + shown(deck_.name()) + ": " + coloured(Colour::kError, "error:") + " " + shown(words) + '\n');
  return exit;
}

void Messages::note(const std::string& text) const {
  if (!quiet) say("contact2d: " + shown(deck_.name()) + ": " + coloured(Colour::kNote, "note:") + " " + shown(text) + '\n');
}

int write_or_fail(const std::string& name, const std::string& text, const Messages& messages) {
  std::string error;
  return write_output(name, text, error) ? static_cast<int>(kExitSolved) : messages.fail(error, kExitFiles);
}

} // namespace app

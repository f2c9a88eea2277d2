// Messages of the library: faults and warnings go to standard error at once, with the quoted card; warnings are also stored
// for the reports.
#pragma once

#include "program/files/deck_file.hpp"

#include <contact2d.h>

#include <string>
#include <vector>

namespace app {

class Messages {
public:
  explicit Messages(const DeckFile& deck) : deck_(deck) {}

  // For c2d_port.log and c2d_report; `context` is the Messages.
  static void log(void* context, const c2d_error* entry);
  // The same while cards are read with room_for_bodies().
  static void log_cards(void* context, const c2d_error* entry);
  // Prints the error of a failed call, unless the call has reported faults itself. Returns `exit`.
  int fault(const c2d_error& error, int exit = 0);
  // A line `contact2d: DECK: error: text` of the program's own. Returns `exit`.
  int fail(const std::string& text, int exit = 0) const;
  // Information below a warning: `contact2d: DECK: note: text`.
  void note(const std::string& text) const;

  const std::vector<c2d_error>& warnings() const { return warnings_; }
  // Text of the latest fault or note; empty if there was none.
  const std::string& latest() const { return latest_; }
  void forget_latest() { latest_.clear(); }
  // Forgets the warnings: the deck is read a second time.
  void restart() { warnings_.clear(); }
  // Restores those of a resumed run.
  void take(std::vector<c2d_error> warnings, std::string latest) {
    warnings_ = std::move(warnings);
    latest_ = std::move(latest);
  }
  // Warnings are printed only if set (they are kept anyway).
  bool print_warnings = true;
  bool quiet = false; // errors alone are printed
  // The zones from this one on, if it is above 0, tie platens of a sketch: they begin and end where loads and supports do,
  // which is not worth a warning.
  int32_t first_platen_zone = 0;

private:
  bool is_end_of_platen(const c2d_error& entry) const;
  bool has_warned(c2d_status kind) const; // of a sketch each kind is printed once
  const DeckFile& deck_;
  std::vector<c2d_error> warnings_;
  std::string latest_;
  int faults_ = 0;
};

// Writes a text as an output (write_output). Returns the exit status of the program; a failure is printed.
int write_or_fail(const std::string& name, const std::string& text, const Messages& messages);

} // namespace app

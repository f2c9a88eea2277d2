#include "program/commands/commands.hpp"

#include "contact2d_memory.h"
#include "post/summary.hpp"
#include "program/exit_code.hpp"
#include "program/files/output_file.hpp"
#include "program/session.hpp"
#include "report/text.hpp"

#include <vector>

namespace app {
namespace {

void append_line(std::string& out, const char* name, const std::string& value) {
  out += name;
  const size_t length = std::char_traits<char>::length(name);
  out.append(length < 28 ? 28 - length : 1, ' ');
  out += value;
  out += '\n';
}

// One number of each body.
std::string of_bodies(const Summary& s, int32_t c2d_body_result::*member) {
  std::string out;
  for (int32_t b = 0; b < s.bodies; ++b) out += (b > 0 ? ", " : "") + std::to_string(s.body[b].*member);
  return out;
}

// "body 1 (plate), zone 2 (thread)"; empty: nothing has a name.
std::string names_of(const Summary& s) {
  std::string out;
  for (size_t b = 0; b < s.body_name.size(); ++b)
    if (!s.body_name[b].empty()) out += (out.empty() ? "" : ", ") + body_text(s, static_cast<int64_t>(b) + 1);
  for (size_t z = 0; z < s.zone_name.size(); ++z)
    if (!s.zone_name[z].empty()) out += (out.empty() ? "" : ", ") + zone_text(s, static_cast<int64_t>(z) + 1);
  return out;
}

// Tape sizes with the minimum workspace and with the whole matrix of a body in memory, or with compressed elimination.
void append_tapes(std::string& out, const Session& session, int32_t elimination) {
  c2d_options options = C2D_INIT(c2d_options);
  options.elimination = elimination;
  std::vector<uint64_t> memory = {session.workspace.minimum, session.workspace.in_core};
  if (elimination == C2D_ELIMINATION_COMPRESSED) memory = {compressed_bytes(session.workspace.minimum)};
  const char* const names[C2D_TAPES] = {"tape control", "tape lower", "tape upper", "tape contact"};
  for (int32_t tape = 0; tape < C2D_TAPES; ++tape) {
    std::string text;
    for (const uint64_t bytes : memory) {
      uint64_t blocks = 0, each = 0;
      c2d_tape_need(&session.limits, &options, bytes, tape, &blocks, &each, nullptr);
      text += text.empty() ? "" : "; all in RAM: ";
      text += std::to_string(blocks) + " blocks of " + std::to_string(each) + " bytes";
    }
    append_line(out, names[tape], text);
  }
}

// The elimination, and the size from which it is compressed.
std::string elimination_text(const Session& session, int32_t wanted) {
  const std::string chosen = elimination_of(session.limits, wanted) == C2D_ELIMINATION_COMPRESSED ? "compressed" : "dense";
  if (wanted != C2D_ELIMINATION_BY_SIZE) return chosen;
  if (session.limits.free_pairs > 0) return chosen + " (the model has free zones)";
  if (session.limits.touching > 0) return chosen + " (contact on demand)";
  return chosen + " by size (compressed from " + std::to_string(C2D_COMPRESSED_FROM(session.limits.pairs)) + " nodes per body)";
}

// The smallest workspace for a deck, and the one with all in RAM; 0: unknown.
struct Need {
  uint64_t minimum = 0, in_core = 0;
};
Need need_of(const std::string& text) {
  DeckFile deck;
  deck.replace(text);
  std::vector<c2d_body_limits> bodies = room_for_bodies(deck);
  c2d_limits limits = C2D_INIT(c2d_limits);
  limits.bodies = static_cast<int32_t>(bodies.size()), limits.body = bodies.data();
  Need need;
  const bool sound = c2d_scan_deck(DeckFile::read_line, &deck, &limits, nullptr) == C2D_OK &&
                     c2d_memory_need(&limits, &need.minimum, &need.in_core, nullptr) == C2D_OK;
  return sound ? need : Need();
}

// Of a sketch `run` seeks a mesh. `expected`: the decks of a coarse and a fine one.
void append_search(std::string& out, const std::vector<std::string>& expected) {
  if (expected.size() != 2) return;
  const Need least = need_of(expected[0]), most = need_of(expected[1]);
  if (least.minimum == 0 || most.minimum == 0) return;
  const auto range = [](uint64_t from, uint64_t to) { return std::to_string(from) + " to " + std::to_string(to); };
  append_line(out, "memory, search of run",
              "minimum " + range(least.minimum, most.minimum) + ", all in RAM " + range(least.in_core, most.in_core) +
                  " bytes (estimate for 1 %; the other lines: mesh of this check)");
}

void append_check(std::string& out, const Session& session, const Summary& s, int32_t wanted,
                  const std::vector<std::string>& expected) {
  const int32_t elimination = elimination_of(session.limits, wanted);
  append_line(out, "file", shown(session.deck.name()));
  append_line(out, "title", s.title);
  append_line(out, "bodies", std::to_string(s.bodies));
  append_line(out, "elements", of_bodies(s, &c2d_body_result::elements));
  append_line(out, "functional nodes", of_bodies(s, &c2d_body_result::nodes));
  append_line(out, "equations", of_bodies(s, &c2d_body_result::unknowns));
  append_line(out, "symmetry by images", symmetry_text(s));
  append_line(out, "contact zones", std::to_string(s.zones));
  if (!names_of(s).empty()) append_line(out, "names", names_of(s));
  append_line(out, "pairs", std::to_string(s.pairs));
  if (session.limits.touching > 0)
    append_line(out, "contact on demand", "room for " + std::to_string(session.limits.touching) + " pairs in or near contact");
  append_line(out, "coefficients of friction", std::to_string(s.coefficients));
  if (session.limits.point_sets > 0) append_line(out, "sets of interior points", std::to_string(session.limits.point_sets));
  if (session.limits.curves > 0) append_line(out, "prescribed surfaces", std::to_string(session.limits.curves));
  append_line(out, "increments", std::to_string(s.steps));
  append_line(out, "elimination", elimination_text(session, wanted));
  append_line(out, "memory, minimum", std::to_string(session.workspace.minimum) + " bytes");
  append_line(out, "memory, all in RAM", std::to_string(session.workspace.in_core) + " bytes");
  if (elimination == C2D_ELIMINATION_COMPRESSED)
    append_line(out, "memory, compressed",
                std::to_string(compressed_bytes(session.workspace.minimum)) + " bytes; minimum " +
                    std::to_string(least_bytes(session.limits, wanted, session.workspace.minimum)));
  append_search(out, expected);
  append_tapes(out, session, elimination);
  append_line(out, "warnings", std::to_string(session.messages.warnings().size()));
}

} // namespace

namespace {

int check_one(const std::string& deck, const Options& options) {
  Session session;
  session.messages.quiet = options.quiet;
  std::vector<std::string> expected;
  Drawing drawing{options.settings, false};
  drawing.expected = &expected;
  int exit = session.read_file(deck, drawing);
  const int32_t chosen = options.touching < 0 && deck == "-" ? 0 : options.touching; // as for run
  session.limits.touching = touching_of(session.limits, chosen, options.elimination, C2D_STEPPING_EVENTS);
  if (exit == 0) exit = session.read_model_alone(options.symmetry);
  if (exit != 0) return exit;

  Summary summary;
  if (const c2d_status status = get_summary(session.solver, summary); status != C2D_OK) return session.failed(status);
  std::string text;
  if (!options.quiet) append_check(text, session, summary, options.elimination, expected);
  return write_or_fail("-", text, session.messages);
}

} // namespace

int check_decks(const Options& options) {
  int first = check_one(options.deck, options);
  for (const std::string& deck : options.more_decks) {
    std::string error;
    const bool parted = options.quiet || write_output("-", "\n", error);
    const int exit = parted ? check_one(deck, options) : static_cast<int>(kExitFiles);
    if (first == 0) first = exit;
  }
  return first;
}

} // namespace app

#pragma once
// One fault or warning while it is being put together. The text is written in place, so a Finding never moves.
#include "memory/config.hpp"
#include "memory/text.hpp"
#include "model/validate/validate.hpp"

namespace c2d {

// Location of a fault: numbers from 1 as in c2d_error, 0 if not applicable.
struct Where {
  int32_t line, body, zone, pair, element, node;
};
// The arguments count from 0.
inline Where in_body(int b) { return {0, b + 1, 0, 0, 0, 0}; }
Where at_point(const Model& m, int b, int32_t geometry_point);
Where at_element(const Model& m, int b, int32_t element);
Where at_node(const Model& m, int b, int32_t node); // functional
Where in_zone(const Model& m, int32_t zone);
Where in_zone(const Model& m, int32_t zone, int b, int32_t element);
Where at_pair(const Model& m, int32_t pair); // with its zone

// Bodies and zones with their names for messages: "zone ", zone_named(m, zone).
struct NamedBody {
  const Model& m;
  int b;
};
struct NamedZone {
  const Model& m;
  int32_t zone;
};
inline NamedBody body_named(const Model& m, int b) { return {m, b}; }
inline NamedZone zone_named(const Model& m, int32_t zone) { return {m, zone}; }
template <> inline constexpr bool kIsNamed<NamedBody> = true;
template <> inline constexpr bool kIsNamed<NamedZone> = true;
Text& put_body(Text& text, const char* characters, const Model& m, int b);
Text& put_zone(Text& text, const char* characters, const Model& m, int32_t zone);
inline Text& put_with_name(Text& text, const char* characters, NamedBody of) { return put_body(text, characters, of.m, of.b); }
inline Text& put_with_name(Text& text, const char* characters, NamedZone of) {
  return put_zone(text, characters, of.m, of.zone);
}

struct Finding {
  explicit Finding(const Where& where = Where());           // a fault
  explicit Finding(int32_t number, const Where& = Where()); // a warning, C2D_WARN_...; 0: a fault
  Finding(const Finding&) = delete;
  Finding& operator=(const Finding&) = delete;
  c2d_error entry;
  Text text; // in entry.text
};
// A finding whose text begins with "zone 3 (name)".
struct ZoneFinding : Finding {
  ZoneFinding(const Model& m, int32_t zone);
  ZoneFinding(int32_t number, const Model& m, int32_t zone, int32_t pair); // a warning, about a pair of the zone
};
// Appends characters and numbers.
template <class... Parts> C2D_IN_PLACE inline void say(Finding& finding, Parts... parts) { put_all(finding.text, parts...); }

// Passes the finding to the reporter and counts faults.
void report(Reporter& reporter, const Finding& finding);
// A fault, or a warning, with a text composed of these parts.
template <class... Parts> C2D_IN_PLACE inline void report(Reporter& reporter, const Where& where, Parts... parts) {
  Finding finding(where);
  say(finding, parts...);
  report(reporter, finding);
}
template <class... Parts>
C2D_IN_PLACE inline void report_zone(Reporter& reporter, const Model& m, int32_t zone, Parts... parts) {
  ZoneFinding finding(m, zone);
  say(finding, parts...);
  report(reporter, finding);
}
template <class... Parts>
C2D_IN_PLACE inline void warn(Reporter& reporter, int32_t number, const Where& where, Parts... parts) {
  Finding finding(number, where);
  say(finding, parts...);
  report(reporter, finding);
}

// ---- optional parts of validate_loads and validate_conditions (memory/parts.hpp) ----
// Body forces of a body on a line of symmetry must be symmetric.
void check_body_force(const Model& m, int b, int32_t load_case, Reporter& reporter);
// A rigid body has no tractions or forces, and its prescribed and free motions respect the lines of symmetry.
void check_rigid(const Model& m, int b, Reporter& reporter);
// Its free zones have no more pairs than nodes of the other body that can follow them. Needs frames.
void check_rigid_zones(const Model& m, int b, Reporter& reporter);

} // namespace c2d

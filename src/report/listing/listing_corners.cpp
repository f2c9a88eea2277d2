#include "report/listing/listing.hpp"

#include "report/listing/listing_items.hpp"
#include "report/text.hpp"

#include <cmath>

namespace app {
namespace {

std::string exponent_text(const Complex& lambda) {
  std::string text;
  append_general(text, lambda.real(), 0);
  if (lambda.imag() != 0) append_general(text += "+-", lambda.imag(), 0, 4), text += 'i';
  return text;
}

void append_value(std::string& out, double value) {
  if (std::isfinite(value))
    append_general(out, value, 13, 5);
  else
    append_column(out, "-", 13);
}

} // namespace

void append_corners(std::string& out, const RunRecord& record, const Summary& s) {
  if (record.corners.empty()) return;
  append_section(out, "Sharp corners, where stress has no bound: stress = K distance^(exponent - 1)");
  out += "           x            y  state             exponent            K        error           K2        error   what\n";
  for (const CornerState& c : record.corners) {
    for (const double v : {c.at[0], c.at[1]}) append_general(out, v, 13);
    out += "  ";
    out += c.joint;
    append_column(out, exponent_text(c.exponents.front()).c_str(), 25 - static_cast<int>(std::string(c.joint).size()));
    for (const double v : {c.K, c.K_error, c.K2, c.K2_error}) append_value(out, v);
    out += "   ";
    out += name_of(c.kind);
    out += c.zone > 0 ? " in " + zone_text(s, c.zone) : " of " + body_text(s, c.body[0]);
    if (!c.why.empty()) out += "; no K: " + c.why;
    out += '\n';
  }
}

} // namespace app

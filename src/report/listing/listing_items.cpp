#include "report/listing/listing_items.hpp"

#include "report/text.hpp"

namespace app {

void append_rule(std::string& out) { out.append(100, '-') += '\n'; }

void append_body_section(std::string& out, const Summary& s, int32_t body, const char* more) {
  std::string title = body_text(s, body) + more;
  title[0] = 'B';
  append_section(out, title);
}

void append_section(std::string& out, const std::string& title) {
  out += '\n';
  out += title;
  out += '\n';
  append_rule(out);
}

// "  name ............ value"
std::string& append_name(std::string& out, const char* name) {
  const size_t start = out.size();
  out += "  ";
  out += name;
  out += ' ';
  const size_t used = out.size() - start;
  if (used < 44) out.append(44 - used, '.');
  return out += ' ';
}
void append_item(std::string& out, const char* name, int64_t value) {
  append_integer(append_name(out, name), value);
  out += '\n';
}
void append_item(std::string& out, const char* name, double value) {
  append_number(append_name(out, name), value);
  out += '\n';
}
void append_item(std::string& out, const char* name, const char* value) {
  append_name(out, name) += value;
  out += '\n';
}

void append_loads(std::string& out, const std::vector<double>& factors) {
  append_name(out, factors.size() > 1 ? "load factors" : "load factor");
  for (size_t k = 0; k < factors.size(); ++k) append_number(k > 0 ? out += ", " : out, factors[k]);
  out += '\n';
}

} // namespace app

#include "deck_text.hpp"

#include <cmath>
#include <cstdio>

namespace random_decks {

namespace {

using namespace problem;

std::string number(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

class Writer {
public:
  explicit Writer(const Problem& p) : p_(p) {}
  std::string write(const std::string& title);

private:
  template <class... Parts> void card(const Parts&... parts) {
    std::string line;
    (add(line, parts), ...);
    out_ += line + "\n";
  }
  void add(std::string& line, const std::string& part) { separate(line) += part; }
  void add(std::string& line, int32_t part) { separate(line) += std::to_string(part); }
  void add(std::string& line, size_t part) { separate(line) += std::to_string(part); }
  void add(std::string& line, double part) { separate(line) += number(part); }
  static std::string& separate(std::string& line) { return line += line.empty() ? "" : " "; }

  void sizes();
  void nodes();
  void conditions(int32_t body);
  void zones();
  void second_case();

  const Problem& p_;
  std::string out_;
};

void Writer::sizes() {
  for (size_t b = 0; b < 2; ++b)
    card(p_.bodies[b].regions.size(), p_.bodies[b].element_nodes, p_.elements(static_cast<int>(b) + 1),
         p_.bodies[b].xy.size() / 2);
  for (const Body& body : p_.bodies)
    for (const Range& r : body.regions) card(r.first, r.last);
  for (const Body& body : p_.bodies) card(body.youngs_modulus, body.poisson_ratio);
  std::string friction = std::to_string(p_.friction.size());
  for (double mu : p_.friction) add(friction, std::isfinite(mu) ? mu : 0.0);
  card(friction);
}

void Writer::nodes() {
  for (const Body& body : p_.bodies) {
    card(0, 0);
    for (size_t i = 0; 2 * i < body.xy.size(); ++i) card(i + 1, body.xy[2 * i], body.xy[2 * i + 1]);
  }
}

void Writer::conditions(int32_t number) {
  const Body& body = p_.bodies[static_cast<size_t>(number - 1)];
  std::string cards;
  int32_t count = 0, loads = 0;
  for (size_t i = 0; i < body.ends.size(); ++i) {
    const End& end = body.ends[i];
    const int32_t e = static_cast<int32_t>(i) / p_.function_nodes + 1, l = static_cast<int32_t>(i) % p_.function_nodes + 1;
    std::string codes;
    bool plain = true;
    for (int k = 0; k < 4; ++k) {
      codes += end.codes[k] != 0 ? '1' : '0';
      plain = plain && end.codes[k] == k / 2 && end.values[k] == 0;
    }
    if (plain) continue;
    ++count;
    std::string line;
    add(line, e), add(line, l), add(line, codes);
    for (double v : end.values) add(line, v);
    cards += line + "\n";
  }
  card(count);
  out_ += cards;
  std::string forces;
  for (const PointLoad& f : p_.point_loads) {
    if (f.body != number || f.load_case != 1) continue;
    std::string line;
    add(line, ++loads), add(line, f.x), add(line, f.y), add(line, f.fx), add(line, f.fy);
    forces += line + "\n";
  }
  card(loads);
  out_ += forces;
}

void Writer::zones() {
  for (const problem::Zone& z : p_.zones) {
    card(1, 2, z.pairs, z.elements);
    card(z.first_element[0], z.last_element[0], z.first_element[1], z.last_element[1]);
    card(z.first_node[0], z.last_node[0], z.first_node[1], z.last_node[1]);
  }
  int32_t pairs = 0, elements = 0;
  for (const problem::Zone& z : p_.zones) pairs += z.pairs, elements += z.elements;
  for (int b = 0; b < 2; ++b) card(pairs, elements);
}

void Writer::second_case() {
  card(std::string("*CASES"), 2);
  card(std::string("case"), 2);
  for (int32_t b = 1; b <= 2; ++b) {
    const std::vector<End>& ends = p_.bodies[static_cast<size_t>(b - 1)].second_case;
    for (size_t i = 0; i < ends.size(); ++i) {
      const double* v = ends[i].values;
      if (v[0] == 0 && v[1] == 0 && v[2] == 0 && v[3] == 0) continue;
      const int32_t end = static_cast<int32_t>(i);
      card(std::string("condition"), b, end / p_.function_nodes + 1, end % p_.function_nodes + 1, v[0], v[1], v[2], v[3]);
    }
  }
  card(std::string("*PATH"));
  for (const Path& path : p_.paths) card(path.increments, path.load, path.second);
}

std::string Writer::write(const std::string& title) {
  card(std::string("*FREE"));
  card(1);
  card(title);
  card(p_.plane == C2D_PLANE_STRESS ? 1 : 0, p_.analysis);
  card(2, p_.zones.size(), p_.function_nodes);
  sizes();
  nodes();
  for (int32_t b = 1; b <= 2; ++b) conditions(b);
  zones();
  card(p_.paths.size(), p_.iteration_limit);
  for (const Path& path : p_.paths) card(path.increments, path.load);
  if (p_.two_cases()) second_case();
  if (p_.interference > 0) card(std::string("*INTERFERENCE"), p_.interference);
  for (const problem::FreeZone& z : p_.free_zones)
    card(std::string("*ZONE"), z.first_element[0], z.last_element[0], z.first_element[1], z.last_element[1]);
  if (!p_.friction.empty() && !std::isfinite(p_.friction[0])) {
    card(std::string("*FRICTION"));
    for (size_t z = 1; z <= p_.zones.size() + p_.free_zones.size(); ++z) card(z, std::string("INF"));
  }
  return out_;
}

} // namespace

std::string deck_of(const Problem& problem, const std::string& title) { return Writer(problem).write(title); }

} // namespace random_decks

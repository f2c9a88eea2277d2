// Writes a deck with every element bisected (METHOD 16.5). Phases: read heading, sizes and trailing cards of the deck; query
// the model from the solver; bisect elements, boundary points and conditions (cut_*.cpp); write all cards in the free form.
#include "program/estimate/mesh/halved.hpp"

#include "program/estimate/mesh/keyword_cards.hpp"
#include "program/sketch/deck/deck_number.hpp"

#include <contact2d_cards.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace estimate {
namespace {

using sketch::deck_number;

// Data read from the cards: heading, sizes, and the cards after the last load card.
struct Cards {
  std::vector<std::string> heading, extensions;
  std::vector<int32_t> integers; // fields after the heading, in order
  bool headings_done = false;

  static void keep(void* context, const c2d_card* card) {
    Cards& cards = *static_cast<Cards*>(context);
    const std::string text(card->text == nullptr ? "" : card->text, static_cast<size_t>(card->length));
    if (card->kind == C2D_CARD_HEADING) {
      cards.heading.push_back(text);
      cards.integers.clear();
    }
    if (card->kind == C2D_CARD_EXTENSION) cards.extensions.push_back(text);
    if (card->kind == C2D_CARD_INTEGER) cards.integers.push_back(static_cast<int32_t>(card->value));
  }
};

struct Lines {
  const std::string& text;
  size_t at;
  static int32_t read(void* context, char* line, int32_t size) {
    Lines& deck = *static_cast<Lines*>(context);
    if (deck.at >= deck.text.size()) return -1;
    const size_t end = std::min(deck.text.find('\n', deck.at), deck.text.size()), length = end - deck.at;
    const size_t fits = std::min(length, static_cast<size_t>(size) - 1);
    std::memcpy(line, deck.text.data() + deck.at, fits);
    line[fits] = '\0';
    deck.at = end + 1;
    return static_cast<int32_t>(length);
  }
};

Cards cards_of(const std::string& deck) {
  Cards out;
  Lines lines{deck, 0};
  std::vector<c2d_body_limits> room(static_cast<size_t>(std::count(deck.begin(), deck.end(), '\n')) + 1);
  need(c2d_walk_deck(Lines::read, &lines, room.data(), static_cast<int32_t>(room.size()), Cards::keep, &out, nullptr, nullptr));
  return out;
}

class Writer {
public:
  Writer(c2d_solver* solver, const std::string& deck);
  std::string write();

private:
  void card(const std::string& text) { out_ += text + "\n"; }
  void read_numbering();
  void read_contact();
  void heading();
  void control();
  void points(size_t b);
  void conditions(size_t b);
  void point_loads(size_t b, int32_t load_case, bool keyword);
  void zones();
  void loads();
  void extensions();
  void cases();
  bool is_matching(const c2d_zone& zone) const;
  bool has_keyword(const char* name) const;

  c2d_solver* const solver_;
  const Cards cards_;
  c2d_summary summary_ = C2D_INIT(c2d_summary);
  std::vector<CutBody> bodies_;
  std::vector<int32_t> element_offset_; // of the deck that is read; the new deck numbers the elements of every body from 1
  std::vector<c2d_curve> curves_;
  std::vector<c2d_zone> matching_; // with the numbers of the interface
  std::vector<CutPoints> points_;
  std::vector<std::vector<EndCondition>> ends_;
  std::string out_;
};

// Fields: 2 of the problem, 3 of sizes, 4 per body, 2 per region.
constexpr size_t kSizesAt = 2, kBodiesAt = 5;

Writer::Writer(c2d_solver* solver, const std::string& deck) : solver_(solver), cards_(cards_of(deck)) {
  need(c2d_get_summary(solver_, &summary_));
  const int32_t bodies = cards_.integers.at(kSizesAt);
  for (int32_t b = 1; b <= bodies; ++b) bodies_.push_back(cut_body(solver_, b, summary_.function_nodes));
  read_numbering();
  for (int32_t i = 1; i <= summary_.curves; ++i) {
    c2d_curve curve = C2D_INIT(c2d_curve);
    need(c2d_get_curve(solver_, i, &curve));
    std::vector<int32_t>& of = bodies_[CutBody::at(curve.body - 1)].curve;
    std::fill(of.begin() + curve.first_element - 1, of.begin() + curve.last_element, i - 1);
    curves_.push_back(curve);
  }
  read_contact();
  int32_t overlaps = 0; // load case that closes overlaps
  need(c2d_get_interference(solver_, &overlaps));
  for (const CutBody& body : bodies_) points_.push_back(cut_points(body, curves_));
  for (const c2d_zone& zone : matching_) match_points(zone, bodies_, overlaps > 0, points_);
  for (int32_t b = 1; b <= bodies; ++b)
    ends_.push_back(cut_conditions(solver_, b, bodies_[CutBody::at(b - 1)], summary_.load_cases));
}

// The first element of the first region of body 2 shows whether its numbers continue those of body 1.
void Writer::read_numbering() {
  const size_t at = kBodiesAt + 4 * bodies_.size() + 2 * bodies_[0].regions.size();
  const bool go_on = bodies_.size() > 1 && cards_.integers.at(at) != 1;
  int32_t before = 0;
  for (const CutBody& body : bodies_) {
    element_offset_.push_back(go_on ? before : 0);
    before += body.elements();
  }
}

bool Writer::is_matching(const c2d_zone& zone) const {
  const int32_t bodies = static_cast<int32_t>(bodies_.size());
  return (zone.kind & C2D_ZONE_FREE) == 0 && zone.side1.body <= bodies && zone.side2.body <= bodies;
}

void Writer::read_contact() {
  for (int32_t i = 1; i <= summary_.zones; ++i) {
    c2d_zone zone = C2D_INIT(c2d_zone);
    need(c2d_get_zone(solver_, i, &zone));
    if (!is_matching(zone)) continue;
    matching_.push_back(zone);
    for (int s = 1; s <= 2; ++s) {
      const c2d_side& side = s == 1 ? zone.side1 : zone.side2;
      CutBody& body = bodies_[CutBody::at(side.body - 1)];
      const Range range{side.first_element - 1, side.last_element - 1};
      for (const int32_t e : elements_of(body, range, goes_up(body, zone, s))) body.in_contact[CutBody::at(e)] = true;
    }
  }
  for (const std::string& text : cards_.extensions) {
    const std::vector<std::string> words = words_of(text);
    if (!is_keyword(words, "*ZONE")) continue;
    const FreeZoneCard zone = free_zone_card(words, element_offset_);
    for (int s = 0; s < 2; ++s) {
      CutBody& body = bodies_[CutBody::at(zone.body[s])];
      const bool up = goes_up(body, zone.elements[s], zone.count[s]);
      for (const int32_t e : elements_of(body, zone.elements[s], up)) body.in_contact[CutBody::at(e)] = true;
    }
  }
}

bool Writer::has_keyword(const char* name) const {
  return std::any_of(cards_.extensions.begin(), cards_.extensions.end(),
                     [&](const std::string& text) { return is_keyword(words_of(text), name); });
}

void Writer::heading() {
  card("*FREE");
  card(std::to_string(cards_.heading.size()));
  for (const std::string& line : cards_.heading) card(line);
}

void Writer::control() {
  card(std::to_string(summary_.plane) + " " + std::to_string(summary_.analysis));
  card(std::to_string(bodies_.size()) + " " + std::to_string(matching_.size()) + " " + std::to_string(summary_.function_nodes));
  for (const CutBody& body : bodies_) {
    int32_t points = body.children.back() * (body.element_nodes - 1);
    for (const CutRegion& region : body.regions) points += region.open ? 1 : 0;
    card(std::to_string(body.regions.size()) + " " + std::to_string(body.element_nodes) + " " +
         std::to_string(body.children.back()) + " " + std::to_string(points));
  }
  for (const CutBody& body : bodies_)
    for (const CutRegion& region : body.regions)
      card(std::to_string(body.children[CutBody::at(region.first)] + 1) + " " +
           std::to_string(body.children[CutBody::at(region.last) + 1]));
  for (const CutBody& body : bodies_) card(deck_number(body.youngs_modulus) + deck_number(body.poisson_ratio));
  std::string friction = std::to_string(summary_.coefficients);
  for (int32_t i = 0; i < summary_.coefficients; ++i) {
    double mu = 0;
    need(c2d_get_friction(solver_, 0, i + 1, &mu));
    if (i > 0 && i % 5 == 0) card(friction), friction.clear();
    friction += deck_number(mu);
  }
  card(friction);
}

void Writer::points(size_t b) {
  card("0 0");
  int32_t node = 0;
  for (const Point& p : points_[b].points) card(std::to_string(++node) + deck_number(p.x) + deck_number(p.y));
}

void Writer::point_loads(size_t b, int32_t load_case, bool keyword) {
  std::vector<std::string> loads;
  for (int32_t i = 1; i <= summary_.point_loads; ++i) {
    int32_t body = 0, own_case = 0;
    double xy[2], force[2];
    need(c2d_get_point_load(solver_, i, &body, &own_case, xy, force));
    if (body - 1 != static_cast<int32_t>(b) || own_case != load_case) continue;
    const std::string first = keyword ? "load " + std::to_string(body) : std::to_string(loads.size() + 1);
    loads.push_back(first + deck_number(xy[0]) + deck_number(xy[1]) + deck_number(force[0]) + deck_number(force[1]));
  }
  if (!keyword) card(std::to_string(loads.size()));
  for (const std::string& text : loads) card(text);
}

void Writer::conditions(size_t b) {
  const std::vector<EndCondition>& all = ends_[b];
  const size_t nodes = static_cast<size_t>(summary_.function_nodes);
  std::vector<std::string> texts, cards;
  for (const EndCondition& end : all) {
    std::string text = " ";
    for (const int32_t code : end.codes) text += code == 0 ? '0' : '1';
    for (const double value : end.values[0]) text += deck_number(value);
    texts.push_back(text);
  }
  for (size_t k = 0, next; k < all.size(); k = next) {
    for (next = k + 1; next < all.size() && texts[next] == texts[k];) ++next;
    if (texts[k] == " 0011 0 0 0 0") continue; // as for an end without a card
    const auto add = [&](size_t i, bool range) {
      cards.push_back((range ? "1 " : "") + std::to_string(i / nodes + 1) + " " + std::to_string(i % nodes + 1) + texts[k]);
    };
    add(k, false);
    if (next - k > 1) add(next - 1, next - k > 2);
  }
  card(std::to_string(cards.size()));
  for (const std::string& text : cards) card(text);
  point_loads(b, 1, false);
}

void Writer::zones() {
  std::vector<int32_t> pairs(bodies_.size(), 0), elements(bodies_.size(), 0);
  for (const c2d_zone& zone : matching_) {
    Range of_elements[2], of_nodes[2];
    int32_t count = 0; // of elements, equal on both sides
    for (int s = 0; s < 2; ++s) {
      const c2d_side& side = s == 0 ? zone.side1 : zone.side2;
      const CutBody& body = bodies_[CutBody::at(side.body - 1)];
      const Range range{side.first_element - 1, side.last_element - 1};
      const bool up = goes_up(body, zone, s + 1);
      of_elements[s] = cut_elements(body, range, up),
      of_nodes[s] = cut_nodes(body, range, {side.first_node - 1, side.last_node - 1}, up);
      count = count_cut(body, range, up);
    }
    const int32_t nodes = std::abs(of_nodes[0].last - of_nodes[0].first) + 1;
    const bool is_self = (zone.kind & C2D_ZONE_SELF) != 0;
    card(std::to_string(zone.side1.body) + " " + std::to_string(is_self ? -zone.side1.body : zone.side2.body) + " " +
         std::to_string(nodes) + " " + std::to_string(count));
    for (const Range* const range : {of_elements, of_nodes})
      card(std::to_string(range[0].first + 1) + " " + std::to_string(range[0].last + 1) + " " +
           std::to_string(range[1].first + 1) + " " + std::to_string(range[1].last + 1));
    for (const c2d_side* const side : {&zone.side1, &zone.side2}) {
      pairs[CutBody::at(side->body - 1)] += nodes;
      elements[CutBody::at(side->body - 1)] += count;
    }
  }
  for (size_t b = 0; b < bodies_.size(); ++b) card(std::to_string(pairs[b]) + " " + std::to_string(elements[b]));
}

// A *PATH card overrides the load cards, which are still required.
void Writer::loads() {
  const bool elsewhere = has_keyword("*PATH");
  card(std::to_string(elsewhere ? 1 : summary_.paths) + " " + std::to_string(summary_.iteration_limit));
  if (elsewhere) return card("1 1");
  for (int32_t i = 1; i <= summary_.paths; ++i) {
    int32_t increments = 0;
    std::vector<double> load(static_cast<size_t>(summary_.load_cases));
    need(c2d_get_path(solver_, i, &increments, load.data(), summary_.load_cases));
    card(std::to_string(increments) + deck_number(load[0]));
  }
}

void Writer::cases() {
  const size_t nodes = static_cast<size_t>(summary_.function_nodes);
  card("*CASES " + std::to_string(summary_.load_cases));
  for (int32_t k = 2; k <= summary_.load_cases; ++k) {
    card("case " + std::to_string(k));
    for (size_t b = 0; b < bodies_.size(); ++b) {
      for (size_t i = 0; i < ends_[b].size(); ++i) {
        const std::array<double, 4>& values = ends_[b][i].values[CutBody::at(k - 1)];
        if (values == std::array<double, 4>{}) continue;
        std::string text =
            "condition " + std::to_string(b + 1) + " " + std::to_string(i / nodes + 1) + " " + std::to_string(i % nodes + 1);
        for (const double value : values) text += deck_number(value);
        card(text);
      }
      point_loads(b, k, true);
    }
  }
}

void Writer::extensions() {
  size_t curve = 0;
  bool skipping = false; // cards after *CASES, which are written from the model
  for (const std::string& text : cards_.extensions) {
    const std::vector<std::string> words = words_of(text);
    const bool keyword = !words.empty() && words[0][0] == '*';
    if (keyword) skipping = is_keyword(words, "*CASES");
    if (is_keyword(words, "*CASES"))
      cases();
    else if (is_keyword(words, "*ZONE"))
      card(free_zone_card(free_zone_card(words, element_offset_), bodies_));
    else if (is_keyword(words, "*CURVE"))
      card(curve_card(curves_[curve], bodies_[CutBody::at(curves_[curve].body - 1)])), ++curve;
    else if (is_keyword(words, "*PLATEN"))
      card(platen_card(words, element_offset_, bodies_));
    else if (!skipping)
      card(text);
  }
}

std::string Writer::write() {
  heading();
  control();
  for (size_t b = 0; b < bodies_.size(); ++b) points(b);
  for (size_t b = 0; b < bodies_.size(); ++b) conditions(b);
  zones();
  loads();
  extensions();
  return out_;
}

} // namespace

std::string halved_deck(c2d_solver* solver, const std::string& deck, std::string& error) {
  error.clear();
  const int32_t state = c2d_get_state(solver);
  if (state != C2D_STATE_MODEL && state != C2D_STATE_PREPARED && state != C2D_STATE_RUNNING) {
    error = "the deck cannot be halved: the solver has no model";
    return std::string();
  }
  try {
    return Writer(solver, deck).write();
  } catch (const std::exception& failure) {
    error = std::string("the deck cannot be halved: ") + failure.what();
    return std::string();
  }
}

} // namespace estimate

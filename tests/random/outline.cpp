#include "outline.hpp"

#include <cmath>
#include <stdexcept>

namespace random_decks {

namespace {

size_t index(int64_t i) { return static_cast<size_t>(i); }

// Functional nodes of a body, from 0: every element's first node is its own.
int32_t node_of(int32_t first, int32_t count, int32_t element, int32_t local, int32_t function_nodes) {
  if (function_nodes == 1) return element;
  const int32_t per = function_nodes - 1, next = element + 1 == first + count ? first : element + 1;
  return local == per ? next * per : element * per + local;
}

struct Held { // displacement of a functional node
  bool fixed[2] = {false, false};
  double value[2][2] = {{0, 0}, {0, 0}};
};

class Builder {
public:
  Builder(const Outlines& outlines, int32_t element_nodes, int32_t function_nodes, bool two_cases)
      : outlines_(outlines), function_nodes_(function_nodes), two_cases_(two_cases) {
    body_.element_nodes = element_nodes;
  }
  problem::Body build() {
    for (const std::vector<Side>& region : outlines_.regions) add_region(region);
    held_.resize(index(elements_) * index(std::max(1, function_nodes_ - 1)));
    for_ends([this](const Side& side, int32_t, int32_t node) { hold(side, node); });
    hold_pins();
    for_ends([this](const Side& side, int32_t end, int32_t node) { add_end(side, end, node); });
    release_pins();
    return body_;
  }

private:
  void add_region(const std::vector<Side>& region) {
    const int32_t first = elements_ + 1;
    for (const Side& side : region)
      for (int32_t e = 0; e < side.elements(); ++e) {
        ++elements_;
        for (int32_t k = 0; k < body_.element_nodes - 1; ++k) {
          const Point at = side.at(e, k / (body_.element_nodes - 1.0));
          body_.xy.push_back(at.x);
          body_.xy.push_back(at.y);
        }
      }
    body_.regions.push_back({first, elements_});
  }
  template <class Visit> void for_ends(Visit visit) {
    int32_t element = 0;
    for (size_t r = 0; r < outlines_.regions.size(); ++r) {
      const int32_t first = body_.regions[r].first - 1, count = body_.regions[r].last - first;
      for (const Side& side : outlines_.regions[r])
        for (int32_t e = 0; e < side.elements(); ++e, ++element)
          for (int32_t l = 0; l < function_nodes_; ++l)
            visit(side, element * function_nodes_ + l, node_of(first, count, element, l, function_nodes_));
    }
  }
  void hold(const Side& side, int32_t node) {
    Held& held = held_[index(node)];
    for (int c = 0; c < 2; ++c) {
      if (!side.condition.fixed[c]) continue;
      held.fixed[c] = true;
      for (int k = 0; k < 2; ++k) held.value[k][c] = side.condition.value[k][c];
    }
  }
  int32_t pin_end(const Pin& pin) const { // first end of the first element of the side
    int32_t element = body_.regions[index(pin.region)].first - 1;
    for (int32_t i = 0; i < pin.side; ++i) element += outlines_.regions[index(pin.region)][index(i)].elements();
    return element * function_nodes_;
  }
  void hold_pins() {
    for (const Pin& pin : outlines_.pins) {
      const int32_t element = pin_end(pin) / function_nodes_;
      held_[index(function_nodes_ == 1 ? element : element * (function_nodes_ - 1))].fixed[pin.component] = true;
    }
  }
  void add_end(const Side& side, int32_t, int32_t node) {
    const Held& held = held_[index(node)];
    for (int k = 0; k < (two_cases_ ? 2 : 1); ++k) {
      problem::End end;
      for (int c = 0; c < 2; ++c) {
        end.codes[c] = side.condition.fixed[c] ? 1 : 0;
        end.codes[2 + c] = held.fixed[c] ? 0 : 1;
        if (end.codes[c] == 0) end.values[c] = side.condition.value[k][c];
        if (end.codes[2 + c] == 0) end.values[2 + c] = held.value[k][c];
      }
      (k == 0 ? body_.ends : body_.second_case).push_back(end);
    }
  }
  void release_pins() {
    for (const Pin& pin : outlines_.pins)
      for (std::vector<problem::End>* ends : {&body_.ends, &body_.second_case})
        if (!ends->empty()) {
          problem::End& end = (*ends)[index(pin_end(pin))];
          end.codes[pin.component] = 1;
          end.values[pin.component] = 0;
        }
  }

  const Outlines& outlines_;
  const int32_t function_nodes_;
  const bool two_cases_;
  problem::Body body_;
  int32_t elements_ = 0;
  std::vector<Held> held_;
};

} // namespace

Point Curve::at(double s) const {
  if (s <= 0) return a;
  if (s >= 1) return b;
  const double dx = b.x - a.x, dy = b.y - a.y, length = std::hypot(dx, dy);
  if (bulge == 0) return {a.x + s * dx, a.y + s * dy};
  const double h = bulge * length, radius = (0.25 * length * length + h * h) / (2 * h);
  double along = (s - 0.5) * length, aside = 0;
  if (by_angle) {
    const double angle = (2 * s - 1) * 2 * std::atan(2 * bulge);
    along = radius * std::sin(angle), aside = radius * std::cos(angle) - (radius - h);
  } else {
    const double root = std::sqrt(radius * radius - along * along);
    aside = std::copysign(root, radius) - (radius - h);
  }
  return {a.x + (0.5 + along / length) * dx + aside * dy / length, a.y + (0.5 + along / length) * dy - aside * dx / length};
}

Point Side::at(int32_t element, double s) const {
  const size_t n = index(elements()), e = index(element);
  if (!backwards) return curve.at(breaks[e] + s * (breaks[e + 1] - breaks[e]));
  const double from = breaks[n - e - 1], to = breaks[n - e];
  return curve.at(s == 0 ? to : from + (1 - s) * (to - from));
}

std::vector<double> equal_breaks(int32_t elements) {
  std::vector<double> breaks(index(elements) + 1);
  for (int32_t i = 0; i <= elements; ++i) breaks[index(i)] = i / static_cast<double>(elements);
  return breaks;
}

Side line(Point from, Point to, int32_t elements) { return arc(from, to, elements, 0); }

Side arc(Point from, Point to, int32_t elements, double bulge) {
  Side side;
  side.curve = {from, to, bulge, false};
  side.breaks = equal_breaks(elements);
  return side;
}

Side opposite(const Side& side) {
  Side out = side;
  out.backwards = !side.backwards;
  return out;
}

problem::Body make_body(const Outlines& outlines, int32_t element_nodes, int32_t function_nodes, bool two_cases) {
  return Builder(outlines, element_nodes, function_nodes, two_cases).build();
}

Run run_of(const Outlines& outlines, int zone) {
  int32_t element = 1;
  Run run = {0, 0};
  for (const std::vector<Side>& region : outlines.regions)
    for (const Side& side : region) {
      if (side.zone == zone && run.elements == 0) run.first_element = element;
      if (side.zone == zone) run.elements += side.elements();
      element += side.elements();
    }
  if (run.elements == 0) throw std::runtime_error("no such zone");
  return run;
}

} // namespace random_decks

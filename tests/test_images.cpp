// Symmetry by images where bodies do not meet every line: what is modelled against the whole, made from it by reflection.
#include "bie/diagonal.hpp"
#include "bie/integrals/batch.hpp"
#include "bie/panel.hpp"
#include "many_bodies.hpp"
#include "memory/config.hpp"
#include "solver/solver.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

using namespace many;

namespace {

size_t at(int64_t i) { return static_cast<size_t>(i); }

// ---- the whole of a model

// Where an element of the part stands in the whole, and its image; body 0: it has none.
struct Place {
  int32_t body, element;
};
struct Whole {
  Model model;
  std::vector<std::vector<Place>> here, image; // [body - 1][element - 1] of the part
};

struct Unfolding {
  const Model& part;
  const int axis;
  Whole out;

  double mirrored(double v) const { return 2 * part.symmetry_at[axis] - v; }
  bool is_on(double v) const { return v == part.symmetry_at[axis]; }
  bool meets(const Body& b) const {
    for (size_t i = at(axis); i < b.xy.size(); i += 2)
      if (is_on(b.xy[i])) return true;
    return false;
  }
  End mirrored(End e) const {
    e.values[axis] = -e.values[axis], e.values[2 + axis] = -e.values[2 + axis];
    return e;
  }
  // The points of region r of a body, its end as well if it is open.
  std::vector<std::array<double, 2>> points(const Body& b, int32_t r) const {
    std::vector<std::array<double, 2>> list;
    const int32_t steps = b.element_nodes - 1, open = std::min(r, b.open_regions);
    const Range& range = b.regions[at(r)];
    const int32_t count = (range.last - range.first + 1) * steps + (r < b.open_regions ? 1 : 0);
    for (int32_t i = 0; i < count; ++i) {
      const size_t p = at(2 * ((range.first - 1) * steps + open + i));
      list.push_back({b.xy[p], b.xy[p + 1]});
    }
    return list;
  }

  struct Piece { // of the whole's boundary: elements of the part, negative ones are images
    std::vector<int32_t> elements;
    std::vector<std::array<double, 2>> points;
    bool open;
  };
  Piece piece(const Body& b, int32_t r) const {
    Piece p{{}, points(b, r), r < b.open_regions};
    for (int32_t e = b.regions[at(r)].first; e <= b.regions[at(r)].last; ++e) p.elements.push_back(e);
    return p;
  }
  Piece mirrored(Piece p) const {
    std::reverse(p.elements.begin(), p.elements.end());
    std::reverse(p.points.begin(), p.points.end());
    if (!p.open) std::rotate(p.points.begin(), p.points.end() - 1, p.points.end()); // the first is the last
    for (int32_t& e : p.elements) e = -e;
    for (std::array<double, 2>& x : p.points) x[at(axis)] = mirrored(x[at(axis)]);
    return p;
  }
  // Curves that end on the line go on as their images.
  std::vector<Piece> pieces_of_whole(const Body& b) const {
    std::vector<Piece> list;
    for (int32_t r = 0; r < static_cast<int32_t>(b.regions.size()); ++r) {
      Piece p = piece(b, r), q = mirrored(p);
      const bool starts = p.open && is_on(p.points.front()[at(axis)]), ends = p.open && is_on(p.points.back()[at(axis)]);
      if (!starts && !ends) {
        list.push_back(p), list.push_back(q);
        continue;
      }
      if (!ends) std::swap(p, q);
      p.elements.insert(p.elements.end(), q.elements.begin(), q.elements.end());
      p.points.insert(p.points.end(), q.points.begin() + 1, q.points.end() - (starts && ends ? 1 : 0));
      p.open = !(starts && ends);
      list.push_back(p);
    }
    std::stable_partition(list.begin(), list.end(), [](const Piece& p) { return p.open; });
    return list;
  }
  void add_body(const Body& from, int32_t part_number, std::vector<Piece> pieces) {
    const int32_t number = static_cast<int32_t>(out.model.bodies.size()) + 1, nf = part.function_nodes;
    Body b = from;
    b.regions.clear(), b.sides.clear(), b.xy.clear(), b.ends.clear();
    b.open_regions = 0;
    int32_t element = 0;
    for (const Piece& p : pieces) {
      b.regions.push_back({element + 1, element + static_cast<int32_t>(p.elements.size())});
      b.open_regions += p.open;
      for (const std::array<double, 2>& x : p.points) b.xy.insert(b.xy.end(), {x[0], x[1]});
      for (const int32_t e : p.elements) {
        ++element;
        const size_t own = at(part_number - 1), old = at(std::abs(e) - 1);
        (e > 0 ? out.here : out.image)[own][old] = {number, element};
        for (int32_t l = 0; l < nf; ++l)
          b.ends.push_back(e > 0 ? from.ends[at((e - 1) * nf + l)] : mirrored(from.ends[at((-e - 1) * nf + nf - 1 - l)]));
      }
    }
    out.model.bodies.push_back(b);
  }
  Body mirrored(Body b) const { // what is not of its boundary
    b.motion[axis] = -b.motion[axis], b.motion[2] = -b.motion[2];
    b.load[axis] = -b.load[axis], b.load[2] = -b.load[2];
    b.point[axis] = mirrored(b.point[axis]);
    b.force[axis] = -b.force[axis];
    return b;
  }
  void add_bodies() {
    out.here.resize(part.bodies.size()), out.image.resize(part.bodies.size());
    for (size_t i = 0; i < part.bodies.size(); ++i)
      out.here[i].resize(at(part.bodies[i].elements())), out.image[i].resize(at(part.bodies[i].elements()));
    for (int32_t n = 1; n <= static_cast<int32_t>(part.bodies.size()); ++n) {
      Body b = part.body(n);
      if (!meets(b)) {
        std::vector<Piece> own;
        for (int32_t r = 0; r < static_cast<int32_t>(b.regions.size()); ++r) own.push_back(piece(b, r));
        add_body(b, n, own);
        continue;
      }
      for (double& load : b.load) load *= 2; // on the part
      b.load[axis] = b.load[2] = 0;
      add_body(b, n, pieces_of_whole(b));
    }
    for (int32_t n = 1; n <= static_cast<int32_t>(part.bodies.size()); ++n) {
      const Body& b = part.body(n);
      if (meets(b)) continue;
      std::vector<Piece> images;
      for (int32_t r = 0; r < static_cast<int32_t>(b.regions.size()); ++r) images.push_back(mirrored(piece(b, r)));
      add_body(mirrored(b), n, images);
    }
  }

  Place here(const Side& s, int32_t element) const { return out.here[at(s.body - 1)][at(element - 1)]; }
  Place image(const Side& s, int32_t element) const { return out.image[at(s.body - 1)][at(element - 1)]; }
  // Does the side begin (k = 0) or end (k = 1) on the line?
  bool is_end_on(const Side& s, int k) const {
    const int32_t e = k == 0 ? s.first : s.last;
    const bool up = s.first < s.last, begins = (k == 0) == up;
    double x[2];
    part.place(s.body, e, begins ? 0 : part.function_nodes - 1, x[0], x[1]);
    return is_on(x[axis]);
  }
  void add_zones() {
    for (const Zone& z : part.zones) { // of the part, with their images where they end on the line
      Zone whole = z;
      for (int k = 0; k < 2; ++k) {
        const Side& s = z.side[k];
        const int32_t first = is_end_on(s, 0) ? image(s, s.last).element : here(s, s.first).element,
                      last = is_end_on(s, 1) ? image(s, s.first).element : here(s, s.last).element;
        const bool doubled = is_end_on(s, 0) || is_end_on(s, 1);
        whole.side[k] = {here(s, s.first).body, first, last, doubled ? 2 * z.count(k) : z.side[k].elements};
      }
      out.model.zones.push_back(whole);
    }
    for (const Zone& z : part.zones) {
      if (is_end_on(z.side[0], 0) || is_end_on(z.side[0], 1)) continue;
      Zone whole = z;
      for (int k = 0; k < 2; ++k) {
        const Side& s = z.side[k]; // run through the other way, so that side 1 still runs with its elements
        whole.side[k] = {image(s, s.last).body, image(s, s.last).element, image(s, s.first).element, z.side[k].elements};
      }
      out.model.zones.push_back(whole);
    }
    for (const PointLoad& p : part.point_loads)
      for (int k = 0; k < 2; ++k) {
        PointLoad load = p;
        double& x = axis == 0 ? load.x : load.y;
        load.body = (k == 0 ? out.here : out.image)[at(p.body - 1)][0].body;
        if (k == 1) x = mirrored(x), (axis == 0 ? load.fx : load.fy) *= -1;
        out.model.point_loads.push_back(load);
      }
  }
};

// What the line holds, something else has to hold in the whole: the points on the line of sides that are supported along it.
// (Points without a load beside would be as good, but round-off of a reaction that is zero decides how stresses are smoothed.)
void hold_on_line(const Model& part, int axis, Whole& whole) {
  const int32_t nf = part.function_nodes;
  for (int32_t n = 1; n <= static_cast<int32_t>(part.bodies.size()); ++n)
    for (int32_t i = 0; i < part.body(n).elements() * nf; ++i) {
      double x[2];
      part.place(n, i / nf + 1, i % nf, x[0], x[1]);
      const Place p = whole.here[at(n - 1)][at(i / nf)];
      End& end = whole.model.body(p.body).ends[at((p.element - 1) * nf + i % nf)];
      if (x[axis] != part.symmetry_at[axis] || end.codes[3 - axis] != 0) continue;
      end.codes[axis] = 1, end.codes[2 + axis] = 0;
    }
}

Whole unfolded(const Model& part, int axis) {
  Unfolding u{part, axis, {}};
  u.out.model = part;
  u.out.model.bodies.clear(), u.out.model.zones.clear(), u.out.model.point_loads.clear();
  u.out.model.symmetry &= ~(1 << axis);
  u.add_bodies();
  u.add_zones();
  hold_on_line(part, axis, u.out);
  return u.out;
}

// ---- comparison

void count_statuses(const Result& r, int (&count)[4]) {
  for (const Row& row : r.last().rows) ++count[static_cast<int>(row[C2D_STATUS])];
}

// Largest difference of what the boundary's ends have, of each kind over its largest.
double boundary_difference(const Model& part, const Result& a, const Whole& whole, const Result& b) {
  const int32_t nf = part.function_nodes;
  double worst[3] = {0, 0, 0}, most[3] = {0, 0, 0};
  double EndResult::*const fields[3][3] = {{&EndResult::ux, &EndResult::uy, &EndResult::uy},
                                           {&EndResult::tx, &EndResult::ty, &EndResult::ty},
                                           {&EndResult::sxx, &EndResult::syy, &EndResult::sxy}};
  for (size_t n = 0; n < part.bodies.size(); ++n)
    for (size_t i = 0; i < a.boundary[n].size(); ++i) {
      const Place p = whole.here[n][i / at(nf)];
      const EndResult &x = a.boundary[n][i], &y = b.boundary[at(p.body - 1)][at((p.element - 1) * nf) + i % at(nf)];
      REQUIRE(std::hypot(x.x - y.x, x.y - y.y) < 1e-12);
      for (int kind = 0; kind < 3; ++kind)
        for (double EndResult::*const f : fields[kind]) {
          worst[kind] = std::max(worst[kind], std::fabs(x.*f - y.*f));
          most[kind] = std::max(most[kind], std::fabs(y.*f));
        }
    }
  double largest = 0;
  for (int kind = 0; kind < 3; ++kind)
    if (most[kind] > 0) largest = std::max(largest, worst[kind] / most[kind]);
  return largest;
}

// The part against the whole, which does `times` its work.
void check_against_whole(const Model& part, Result a, const Whole& whole, Result b, double times) {
  // (Moments on a rigid body in a free zone balance as far as METHOD 10.5 says.)
  const bool exact = std::none_of(part.bodies.begin(), part.bodies.end(), [](const Body& body) { return body.rigid != 0; }) ||
                     part.zones[0].kind == C2D_ZONE_MATCHING;
  if (exact) CHECK(imbalance(whole.model, b) < 1e-11);
  CHECK(std::fabs(b.last().work - times * a.last().work) <= 1e-9 * b.last().work);
  CHECK(std::fabs(b.last().elastic - times * a.last().elastic) <= 1e-9 * b.last().work);
  CHECK(std::fabs(b.last().dissipated - times * a.last().dissipated) <= 1e-9 * b.last().work);
  CHECK(boundary_difference(part, a, whole, b) < 1e-9);
  for (Result* r : {&a, &b})
    for (Step& s : r->steps) s.work = s.elastic = s.dissipated = s.defect = 0;
  const auto beyond = [&](const Row& row) {
    for (int c = 0; c < 2; ++c)
      if ((part.symmetry >> c & 1) != 0 && row[at(c == 0 ? C2D_X : C2D_Y)] < part.symmetry_at[c] - 1e-9) return true;
    return false;
  };
  for (Step& s : b.steps) s.rows.erase(std::remove_if(s.rows.begin(), s.rows.end(), beyond), s.rows.end());
  CHECK(difference(a, b) < 1e-9);
  CHECK(status_differences(a, b) == 0);
}

// Displacements and stresses at points all over the whole, as the part and the whole tell them.
void check_interior(Machine& part, Machine& whole, double low, double high) {
  const int32_t side = 23, count = side * side;
  std::vector<double> xy;
  for (int32_t i = 0; i < count; ++i)
    for (const int32_t k : {i % side, i / side}) xy.push_back(low + (high - low) * (k + 0.37) / side);
  std::vector<double> a(at(count * C2D_POINT_FIELDS)), b(a);
  REQUIRE(c2d_interior(part.solver, 0, count, xy.data(), 2, a.data(), C2D_POINT_FIELDS) == C2D_OK);
  REQUIRE(c2d_interior(whole.solver, 0, count, xy.data(), 2, b.data(), C2D_POINT_FIELDS) == C2D_OK);
  int32_t inside = 0;
  for (const int32_t field : {C2D_POINT_UX, C2D_POINT_UY, C2D_POINT_SXX, C2D_POINT_SYY, C2D_POINT_SXY, C2D_POINT_FLAG}) {
    double worst = 0, most = 0;
    for (int32_t i = 0; i < count; ++i) {
      const size_t k = at(i * C2D_POINT_FIELDS);
      if (field == C2D_POINT_FLAG && static_cast<int>(a[k + at(field)]) != C2D_POINT_OUTSIDE) ++inside;
      worst = std::max(worst, std::fabs(a[k + at(field)] - b[k + at(field)]));
      most = std::max(most, std::fabs(b[k + at(field)]));
    }
    CAPTURE(field);
    CHECK(worst <= 1e-9 * most);
  }
  CHECK(inside > count / 4);
}

Whole unfolded_twice(const Model& part) {
  Whole once = unfolded(part, 0), twice = unfolded(once.model, 1);
  for (std::vector<Place>& body : once.here)
    for (Place& p : body) p = twice.here[at(p.body - 1)][at(p.element - 1)];
  twice.here = once.here;
  return twice;
}

// A model with lines of symmetry against the wholes across one and, if there are two, across both of them.
void check_unfolded(const Model& part) {
  Machine machine(part);
  const Result a = machine.run();
  REQUIRE_MESSAGE(a.status == C2D_OK, a.messages());
  REQUIRE_MESSAGE(a.outcome == C2D_REACHED, c2d_outcome_message(a.outcome) << "\n" << a.messages());
  int statuses[4] = {0, 0, 0, 0};
  count_statuses(a, statuses);
  CHECK(statuses[C2D_STICK] > 0);
  CHECK(statuses[C2D_SLIP] > 0);
  for (int axis = 0; axis < 3; ++axis) {
    if (axis == 2 ? part.symmetry != 3 : (part.symmetry >> axis & 1) == 0) continue;
    CAPTURE(axis);
    const Whole whole = axis == 2 ? unfolded_twice(part) : unfolded(part, axis);
    Machine all(whole.model);
    const Result b = all.run();
    REQUIRE_MESSAGE(b.status == C2D_OK, b.messages());
    REQUIRE_MESSAGE(b.outcome == C2D_REACHED, c2d_outcome_message(b.outcome) << "\n" << b.messages());
    check_against_whole(part, a, whole, b, axis == 2 ? 4 : 2);
    check_interior(machine, all, -part.scale(), part.scale());
  }
}

// ---- models

// A polygon with a flat foot and a flat top, like a roller, about (x, y).
Body roller(double x, double y, double R, double E) {
  return polygon({{x - 0.3 * R, y - R, 6},
                  {x + 0.3 * R, y - R, 3},
                  {x + R, y - 0.3 * R, 3},
                  {x + R, y + 0.3 * R, 3},
                  {x + 0.3 * R, y + R, 6},
                  {x - 0.3 * R, y + R, 3},
                  {x - R, y + 0.3 * R, 3},
                  {x - R, y - 0.3 * R, 3}},
                 E);
}

// Two rollers between two plates, of which the right half is modelled: the plates meet the line, the roller does not.
// rigid: a body that is rigid and free, or 0.
Model rollers_between_plates(int32_t kind, int32_t rigid) {
  Model m;
  m.add(open_polygon({{0, -2, 4}, {3, -2, 4}, {3, 0, 3}, {1.8, 0, 6}, {1.2, 0, 4}, {0, 0, 0}}, 500));
  m.add(roller(1.5, 1, 1, 300));
  m.add(open_polygon({{0, 2, 4}, {1.2, 2, 6}, {1.8, 2, 3}, {3, 2, 4}, {3, 4, 4}, {0, 4, 0}}, 700));
  m.set(1, 1, end_of("0110"));
  m.set(3, 5, end_of("0110", 1, 0, 0, -0.01));
  m.join(kind, 2, 1, 1, 4); // a rigid body is better side 1 of a free zone
  m.join(kind, 2, 5, 3, 2);
  m.symmetry = 1;
  m.friction = 0.14;
  m.paths = {{3, 1.0}, {2, 0.4}};
  m.set(2, 3, end_of(kPulled, 0, 0.2)); // a couple, which friction withstands
  m.set(2, 7, end_of(kPulled, 0, -0.2));
  if (rigid == 0) return m;
  Body& body = m.body(rigid);
  std::fill(body.ends.begin(), body.ends.end(), End()); // nothing else holds it
  body.rigid = 1;
  if (rigid == 3) { // it meets the line and moves along it
    body.is_free[1] = 1, body.load[1] = -1;
    return m;
  }
  body.is_free[0] = body.is_free[1] = body.is_free[2] = 1;
  body.load[0] = 0.2, body.load[2] = 0.05;
  body.point[0] = 1.4, body.point[1] = 1.1;
  return m;
}

// A cross of which a quarter is modelled: a block that meets both lines, beside it one that meets y = 0, above it a roller with
// a hole that meets none, and on that a plate that meets x = 0.
Model cross(int32_t function_nodes) {
  Model m;
  m.function_nodes = function_nodes;
  m.add(open_polygon({{2, 0, 3}, {2, 0.5, 2}, {2, 1, 3}, {1.5, 1, 6}, {0.9, 1, 4}, {0, 1, 0}}, 500));
  m.add(open_polygon({{4, 0, 2}, {4, 0.5, 6}, {2, 0.5, 3}, {2, 0, 0}}, 800));
  Body holed = roller(1.2, 2, 1, 300);
  add_polygon(holed, {{1, 1.8, 2}, {1, 2.3, 2}, {1.5, 2.3, 2}, {1.5, 1.8, 2}});
  holed.force[0] = 0.02, holed.force[1] = -0.05;
  m.add(holed);
  m.add(open_polygon({{0, 3, 4}, {0.9, 3, 6}, {1.5, 3, 3}, {3, 3, 4}, {3, 5, 4}, {0, 5, 0}}, 700));
  m.set(2, 1, end_of("1001", 0, 0.01, -0.02));
  m.set(4, 5, end_of("0110", 0.2, 0, 0, -0.01));
  m.join(C2D_ZONE_MATCHING, 1, 1, 2, 3);
  m.join(C2D_ZONE_MATCHING, 1, 4, 3, 1);
  m.join(C2D_ZONE_FREE, 3, 5, 4, 2);
  m.point_loads.push_back({3, 0.65, 2, 0.1, -0.05});
  m.symmetry = 3;
  m.friction = 0.15;
  m.paths = {{2, 1.0}, {2, 0.3}};
  return m;
}

} // namespace

TEST_CASE("images: a roller beside the line is one of two") {
  for (const int32_t kind : {C2D_ZONE_MATCHING, C2D_ZONE_FREE})
    for (const int32_t rigid : {0, 2, 3}) {
      CAPTURE(kind);
      CAPTURE(rigid);
      check_unfolded(rollers_between_plates(kind, rigid));
    }
}

TEST_CASE("images: bodies that meet both lines, one or the other, and none") {
  for (const int32_t function_nodes : {1, 2, 3}) {
    CAPTURE(function_nodes);
    check_unfolded(cross(function_nodes));
  }
}

// It is what keeps the cost of a compressed body with images from growing with the square of its nodes.
TEST_CASE("images: the diagonal in closed form is the sum over the elements and their images" *
          doctest::skip(c2d::kSmallCode)) {
  for (const int32_t function_nodes : {1, 2, 3, 4}) {
    CAPTURE(function_nodes);
    Machine machine(cross(function_nodes));
    REQUIRE(machine.status == C2D_OK);
    const c2d::Model model = c2d::model_of(machine.solver);
    const auto scratch = std::make_unique<c2d::AssemblyScratch>();
    for (int b = 0; b < model.head->bodies; ++b) {
      CAPTURE(b);
      const int32_t nodes = model.body[b].nodes;
      std::vector<double> closed(at(4 * nodes)), summed(closed), point(at(2 * nodes));
      std::vector<int32_t> twin(at(nodes));
      c2d::ColumnSystem system{model,
                               b,
                               c2d::Quadrature::accurate,
                               closed.data(),
                               point.data(),
                               twin.data(),
                               scratch.get(),
                               c2d::batch_for(c2d::best_instructions())};
      system.some_passed_over = c2d::place_sources(system);
      REQUIRE(c2d::fill_diagonal_closed(system, 0, nodes));
      system.diagonal = summed.data(), system.batch = nullptr;
      c2d::fill_diagonal(system, 0, nodes);
      double most = 0;
      for (size_t i = 0; i < closed.size(); ++i) most = std::max(most, std::fabs(closed[i] - summed[i]));
      CHECK(most < 2e-15 * 8); // entries below 1, some dozen elements
    }
  }
}

TEST_CASE("images: a body that crosses a line, touches it at a point or leaves it is told, and a line that meets none") {
  const auto told = [](const Model& m, const char* words) {
    const Result r = solve(m);
    CHECK(r.status == C2D_ERR_INPUT);
    CHECK_MESSAGE(r.told_of(words), r.messages());
  };
  const Model good = rollers_between_plates(C2D_ZONE_FREE, 2);
  Model m = good;
  for (size_t i = 0; i < m.body(2).xy.size(); i += 2) m.body(2).xy[i] -= 0.6;
  told(m, "of body 2 lies beyond the line of symmetry x = 0, expected everything on one side of it");
  m = good;
  m.body(2).xy[2 * 19] = 0;
  told(m, "of body 2 at (0, 2) touches a line of symmetry, expected that only at the ends of an open region");
  m = good;
  m.body(3).rigid = 1, m.body(3).is_free[0] = 1;
  m.set(3, 5, End());
  told(m, "the rigid body 3 may move freely across a line of symmetry, expected motions along it");
  m = good;
  m.body(1).force[0] = 1; // of body 2 it would be no fault
  told(m, "the body force of body 1 in load case 1 acts across the line of symmetry x = 0, expected one along it");
  m = good;
  m.bodies = {rectangle(1, 0, 2, 1, {2, 2, 2, 2})};
  m.zones.clear();
  m.body(1).ends.assign(16, End());
  told(m, "the line of symmetry x = 0 meets no body, expected an open region that ends on it");
}

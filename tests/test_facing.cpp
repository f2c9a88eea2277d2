// Which points of two surfaces face each other: what bounds leave out is nowhere near, against all points of all elements.
#include "bie/transfer.hpp"
#include "dice.hpp"
#include "model/facing.hpp"
#include "model_fixture.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace c2d;
using fixture::ModelData;
using fixture::Points;
using random_decks::Dice;

namespace {

// A surface over 0 < x < 4: waves, and notches with steep sides.
class Profile {
public:
  explicit Profile(Dice& dice) {
    for (double& a : wave_) a = dice.between(-0.05, 0.05);
    for (int i = dice.whole(0, 2); i > 0; --i)
      notches_.push_back({dice.between(0.3, 3.7), dice.between(0.05, 0.4), dice.between(0.1, 0.8)});
  }
  double at(double x) const {
    double y = 0;
    for (int k = 0; k < 3; ++k) y += wave_[k] * std::sin((k + 1) * x + k);
    for (const Notch& n : notches_) y -= n.depth * std::exp(-std::pow((x - n.x) / n.width, 2));
    return y;
  }

private:
  struct Notch {
    double x, width, depth;
  };
  double wave_[3];
  std::vector<Notch> notches_;
};

// Elements from x0 to x1 of uneven lengths, all their points but the last one.
void add_profile(Points& out, Dice& dice, const Profile& profile, double lift, int side, double x0, double x1, int elements,
                 int nodes) {
  std::vector<double> ends = {0};
  for (int e = 0; e < elements; ++e) ends.push_back(ends.back() + dice.power(-1, 0));
  for (int e = 0; e < elements; ++e)
    for (int k = 0; k < nodes - 1; ++k) {
      const double from = ends[static_cast<size_t>(e)], to = ends[static_cast<size_t>(e) + 1];
      const double x = x0 + (x1 - x0) * (from + (to - from) * k / (nodes - 1)) / ends.back();
      out.push_back(x);
      out.push_back(lift + side * profile.at(x));
    }
}

// Body 1 below, body 2 above, and a zone between the top of the one and the bottom of the other.
struct Pair2 {
  ModelData data;
  Zone zone = {};
  static Pair2 random(Dice& dice) {
    Pair2 out{ModelData(dice.whole(1, 4))};
    const int nodes[2] = {dice.whole(2, 4), dice.whole(2, 4)}, elements[2] = {dice.whole(5, 25), dice.whole(5, 25)};
    const Profile low(dice), high(dice);
    Points p, q;
    fixture::line_to(p, 0, -3, 4, -3, nodes[0] - 1);
    fixture::line_to(p, 4, -3, 4, low.at(4), nodes[0] - 1);
    add_profile(p, dice, low, 0, 1, 4, 0, elements[0], nodes[0]);
    fixture::line_to(p, 0, low.at(0), 0, -3, nodes[0] - 1);
    const double gap = dice.power(-3, -0.5), left = dice.between(-0.5, 1.5), right = dice.between(2, 4.5);
    add_profile(q, dice, high, gap + 0.2, -1, left, right, elements[1], nodes[1]);
    fixture::line_to(q, right, gap + 0.2 - high.at(right), right, 4, nodes[1] - 1);
    fixture::line_to(q, right, 4, left, 4, nodes[1] - 1);
    fixture::line_to(q, left, 4, left, gap + 0.2 - high.at(left), nodes[1] - 1);
    out.data.body(nodes[0], {p});
    out.data.body(nodes[1], {q});
    out.join(2, elements[0], 0, elements[1]);
    return out;
  }
  // Elements of side 0 going up, of side 1 going down.
  void join(int first1, int count1, int first2, int count2) {
    zone.is_free = 1;
    zone.body[1] = 1;
    zone.first_element[0] = first1, zone.element_step[0] = 1, zone.facing = count1;
    zone.first_element[1] = first2 + count2 - 1, zone.element_step[1] = -1, zone.elements = count2;
    data.zones = {zone};
    data.zones[0].normal_part = find_normal_part(data.view(), data.zones[0]);
    zone = data.zones[0];
  }
};

// All elements, without a bound; the zero by halving.
struct Everywhere {
  const Model& m;
  const Zone& z;

  FacePoint point(int side, int32_t place, double eta) const { return {zone_element(m, z, side, place), place, eta}; }
  // How far a point of side 1 lies ahead of the line through one of side 0.
  double ahead(const FacePoint& at1, const FacePoint& at2) const {
    double n1[2], n2[2];
    const SurfacePoint p = normal_in_zone(m, z, 0, at1, n1), q = normal_in_zone(m, z, 1, at2, n2);
    const double part = z.normal_part, n[2] = {part * n1[0] - (1 - part) * n2[0], part * n1[1] - (1 - part) * n2[1]};
    return (q.y - p.y) * n[0] - (q.x - p.x) * n[1];
  }
  double ahead(int side, const FacePoint& at, int32_t place, double eta) const {
    const FacePoint other = point(1 - side, place, eta);
    return side == 0 ? ahead(at, other) : ahead(other, at);
  }
  // How often it changes sign in an element of the other side.
  int zeros(int side, const FacePoint& at, int32_t place) const {
    int count = 0;
    for (int i = -100; i < 100; ++i)
      count += (ahead(side, at, place, 0.01 * i) > 0) != (ahead(side, at, place, 0.01 * (i + 1)) > 0) ? 1 : 0;
    return count;
  }
  // The distance to the nearest point of the other side that a point of `side` faces; -1: there is none. Side 0 looks for a
  // change of sign, side 1 for one that comes from above.
  double distance(int side, const FacePoint& at) const {
    double least = -1;
    for (int32_t place = 0; place < zone_elements(z, 1 - side); ++place) {
      const auto value = [&](double eta) { return ahead(side, at, place, eta); };
      double a = -1, b = 1;
      const double fa = value(a), fb = value(b);
      const double close = 1e-9 * element_length(m, z.body[1 - side], zone_element(m, z, 1 - side, place));
      if (std::fabs(fa) <= close) {
        b = a;
      } else if (side == 0 && std::fabs(fb) <= close) {
        a = b;
      } else if (side == 1 ? fa < 0 || fb > close : (fa > 0) == (fb > 0)) {
        continue;
      } else if (std::fabs(fb) <= close) {
        a = b;
      }
      for (int i = 0; i < 60 && a != b; ++i) {
        const double middle = 0.5 * (a + b);
        ((value(middle) > 0) == (fa > 0) ? a : b) = middle;
      }
      const SurfacePoint p = surface_point(m, z.body[side], at.element, at.eta);
      const SurfacePoint q = surface_point(m, z.body[1 - side], zone_element(m, z, 1 - side, place), b);
      const double d = std::hypot(q.x - p.x, q.y - p.y);
      if (least < 0 || d < least) least = d;
    }
    return least;
  }
};

double length_of(int nodes, const double* x, const double* y) {
  constexpr int kChordsOf = 3000;
  double sum = 0;
  CurvePoint from = curve_point(nodes, x, y, -1);
  for (int i = 1; i <= kChordsOf; ++i) {
    const CurvePoint to = curve_point(nodes, x, y, -1 + 2.0 * i / kChordsOf);
    sum += std::hypot(to.x - from.x, to.y - from.y);
    from = to;
  }
  return sum;
}

// From a point to the surface over an element, over 400 points of it: not below the true one, and hardly above.
double nearest_of_all(const Model& m, int b, int32_t element, const SurfacePoint& from) {
  const SurfaceElement surface = surface_element(m, b, element);
  double least = HUGE_VAL;
  for (int i = 0; i <= 400; ++i) {
    const SurfacePoint p = surface_point(surface, -1 + i / 200.0);
    least = std::min(least, std::hypot(p.x - from.x, p.y - from.y));
  }
  return least;
}

} // namespace

TEST_CASE("facing: the bound of an element's length is one, and is near") {
  Dice dice(1);
  double nearest = HUGE_VAL;
  for (int i = 0; i < 2000; ++i) {
    const int nodes = dice.whole(2, 4);
    double x[4], y[4], chords = 0;
    const double wild = dice.power(-3, 0.5);
    for (int k = 0; k < nodes; ++k) x[k] = k + wild * dice.between(-1, 1), y[k] = wild * dice.between(-1, 1);
    for (int k = 1; k < nodes; ++k) chords += std::hypot(x[k] - x[k - 1], y[k] - y[k - 1]);
    const double bound = facing::length_at_most(nodes, x, y), length = length_of(nodes, x, y);
    CAPTURE(i);
    CHECK(bound >= length * (1 - 1e-12));
    CHECK(bound <= (nodes == 2 ? 1 : nodes == 3 ? 1.26 : 2.02) * chords * (1 + 1e-12));
    if (nodes > 2) nearest = std::min(nearest, bound / length);
  }
  CHECK(nearest < 1.3); // there are elements for which it is hardly too large
}

TEST_CASE("facing: what is told to be beyond a distance is, on random bodies, and what is far is told") {
  int beyond = 0, missed = 0;
  for (uint64_t seed = 1; seed <= 12; ++seed) {
    CAPTURE(seed);
    Dice dice(seed);
    Pair2 pair = Pair2::random(dice);
    const Model m = pair.data.view();
    for (int b = 0; b < 2; ++b)
      for (int32_t e = 0; e < body_of(m, b).elements; ++e) {
        const double length = element_length(m, b, e);
        for (int i = 0; i < 12; ++i) {
          SurfacePoint from = surface_point(m, b, e, dice.between(-1, 1)); // from within it to ten lengths away
          const double off = length * dice.power(-4, 1), angle = dice.between(0, 7);
          from.x += off * std::cos(angle), from.y += off * std::sin(angle);
          const double least = nearest_of_all(m, b, e, from);
          CHECK_FALSE(facing::is_beyond(m, b, e, from, least * least * (1 + 1e-9))); // a near miss
          for (const double part : {1e-3, 0.3, 0.9, 0.999, 1.001, 2.0}) {
            const bool told = facing::is_beyond(m, b, e, from, part * part * least * least);
            beyond += told ? 1 : 0, missed += !told && part < 1 ? 1 : 0;
            if (told) CHECK(part < 1);
            if (least > 8 * length && part <= 0.3) CHECK(told);
          }
        }
      }
  }
  CHECK(beyond > 1000);
  CHECK(missed > 0); // near it the bound does not know
}

TEST_CASE("facing: the nearest point that is faced is found whatever bounds leave out: all points against all elements") {
  int found = 0, none = 0, several = 0;
  for (uint64_t seed = 1; seed <= 25; ++seed) {
    CAPTURE(seed);
    Dice dice(seed);
    Pair2 pair = Pair2::random(dice);
    const Model m = pair.data.view();
    const Zone& z = m.zone[0];
    const Everywhere all{m, z};
    for (int side = 0; side < 2; ++side)
      for (int32_t place = 0; place < zone_elements(z, side); ++place)
        for (const double eta : {-1.0, dice.between(-1, 1), dice.between(-1, 1), 1.0}) {
          const FacePoint at = all.point(side, place, eta);
          FacePoint faced;
          const bool any = side == 0 ? facing_point(m, z, at, faced) : face_point(m, z, at, faced);
          const double expected = all.distance(side, at);
          CAPTURE(side);
          CAPTURE(place);
          CAPTURE(eta);
          CHECK(any == (expected >= 0));
          (any ? found : none) += 1;
          if (!any || expected < 0) continue;
          const SurfacePoint p = surface_point(m, z.body[side], at.element, at.eta);
          const SurfacePoint q = surface_point(m, z.body[1 - side], faced.element, faced.eta);
          CHECK(faced.element == zone_element(m, z, 1 - side, faced.place));
          const bool is_nearest = std::fabs(std::hypot(q.x - p.x, q.y - p.y) - expected) < 1e-8;
          CHECK((is_nearest || all.zeros(side, at, faced.place) > 1)); // of several in one element any may be taken
          several += is_nearest ? 0 : 1;
        }
  }
  CHECK(found > 1000);
  CHECK(none > 100);
  CHECK(several < 5);
}

TEST_CASE("facing: ends that nothing faces are marked, those alone: all of them against all elements") {
  int marked = 0, faced = 0;
  for (uint64_t seed = 101; seed <= 130; ++seed) {
    CAPTURE(seed);
    Dice dice(seed);
    Pair2 pair = Pair2::random(dice);
    const Model m = pair.data.view();
    const Zone& z = m.zone[0];
    const Everywhere all{m, z};
    const int f = m.head->function_nodes;
    std::vector<uint8_t>& codes = pair.data.end_code[0];
    for (uint8_t& code : codes) code = static_cast<uint8_t>(dice.whole(0, 255));
    const std::vector<uint8_t> before = codes;
    facing::mark_unfaced_ends(m, 0);
    for (size_t i = 0; i < codes.size(); ++i) {
      const int32_t element = static_cast<int32_t>(i) / f, place = element - z.first_element[0];
      CAPTURE(i);
      CHECK((codes[i] & ~kFacesNothing) == (before[i] & ~kFacesNothing));
      if (place < 0 || place >= zone_elements(z, 0)) {
        CHECK(codes[i] == before[i]);
        continue;
      }
      const bool none = all.distance(0, all.point(0, place, node_eta(f, static_cast<int>(i) % f))) < 0;
      CHECK(((codes[i] & kFacesNothing) != 0) == none);
      (none ? marked : faced) += 1;
    }
  }
  CHECK(marked > 50);
  CHECK(faced > 500);
}

// Flats one above the other, the upper one's end a little to the left or right of the lower one's nodes.
TEST_CASE("facing: an end that misses by less than 1e-9 of an element's length is faced, by more is not") {
  for (int nodes = 2; nodes <= 4; ++nodes)
    for (const double off : {0.0, 0.4, -0.4, 3.0, -3.0}) {
      CAPTURE(nodes);
      CAPTURE(off);
      const double end = 2 + off * 1e-9; // elements of side 1 are 1 long
      Pair2 pair{ModelData(2)};
      Points p = fixture::rectangle(0, -1, 4, 1, 4 * (nodes - 1), nodes - 1), q;
      fixture::line_to(q, 0, 0.5, end, 0.5, 2 * (nodes - 1));
      fixture::line_to(q, end, 0.5, end, 2, nodes - 1);
      fixture::line_to(q, end, 2, 0, 2, nodes - 1);
      fixture::line_to(q, 0, 2, 0, 0.5, nodes - 1);
      pair.data.body(nodes, {p});
      pair.data.body(nodes, {q});
      pair.join(5, 4, 0, 2);
      facing::mark_unfaced_ends(pair.data.view(), 0);
      const double x[4][2] = {{4, 3}, {3, 2}, {2, 1}, {1, 0}};
      for (size_t e = 0; e < 4; ++e)
        for (size_t l = 0; l < 2; ++l) {
          CAPTURE(x[e][l]);
          const bool none = x[e][l] > 2 || (x[e][l] == 2 && off < -1);
          CHECK(((pair.data.end_code[0][2 * (5 + e) + l] & kFacesNothing) != 0) == none);
        }
    }
}

namespace {

// Flats: elements 5 ... 8 of body 1 from x = 4 to 0, above them 0 ... 2 of body 2 from `left` to `right`.
Pair2 flats(int32_t functions, double left, double right) {
  Pair2 pair{ModelData(functions)};
  Points q;
  fixture::line_to(q, left, 0.5, right, 0.5, 3);
  fixture::line_to(q, right, 0.5, right, 2, 1);
  fixture::line_to(q, right, 2, left, 2, 1);
  fixture::line_to(q, left, 2, left, 0.5, 1);
  pair.data.body(2, {fixture::rectangle(0, -1, 4, 1, 4, 1)});
  pair.data.body(2, {q});
  pair.join(5, 4, 0, 3);
  return pair;
}

} // namespace

// Elements of side 1 from x = 5 to 3, which faces nothing where it begins, from 3 to 1, and from 1 to -1.
TEST_CASE("facing: an element has pieces as far as it faces something, from its start on") {
  Pair2 pair = flats(1, -1, 5);
  const Model m = pair.data.view();
  const size_t expected[3] = {0, 4, 2}; // cut at nodes and ends
  for (int32_t place = 0; place < 3; ++place) {
    CAPTURE(place);
    PieceWalk walk = start_pieces(m, m.zone[0], place);
    FacingPiece piece;
    std::vector<double> x;
    while (next_piece(walk, piece))
      for (int i = 0; i < 2; ++i) {
        const SurfacePoint p = surface_point(m, 0, piece.element1, piece.eta1[i]),
                           q = surface_point(m, 1, 2 - place, piece.eta2[i]);
        CHECK(p.x == doctest::Approx(q.x));
        x.push_back(p.x);
      }
    REQUIRE(x.size() == 2 * expected[place]);
    for (size_t i = 0; i < x.size(); ++i)
      CHECK(x[i] == doctest::Approx(5 - 2 * place - 0.5 * static_cast<double>((i + 1) / 2)));
  }
}

TEST_CASE("facing: an end that nothing faces takes nothing, whether that has been noted or not") {
  Pair2 pair = flats(2, 0, 3);
  const Model m = pair.data.view();
  for (const bool noted : {false, true}) {
    if (noted) facing::mark_unfaced_ends(m, 0);
    TransferredEnd end;
    CHECK(!transferred_end(m, 0, 5, 0, end)); // at x = 4
  }
}

// The upper side of a body above: lines along its normal meet it from behind.
TEST_CASE("facing: a surface that is averted hands its traction over as it is") {
  Pair2 pair = flats(2, 0, 4);
  pair.join(5, 4, 4, 1);
  Zone& z = pair.data.zones[0];
  z.pairs = 2, z.first_node[1] = 5, z.node_step[1] = -1;
  pair.data.pairs.resize(2);
  for (size_t i = 0; i < 2; ++i) pair.data.pairs[i].element = 8 - static_cast<int32_t>(i), pair.data.pairs[i].eta = 0;
  const Model m = pair.data.view();
  for (int32_t element = 5; element <= 8; ++element)
    for (int l = 0; l < 2; ++l) {
      TransferredEnd end;
      REQUIRE(transferred_end(m, 0, element, l, end));
      CHECK(end.ratio == 1);
      CHECK(end.weight[0] + end.weight[1] == doctest::Approx(1));
    }
}

TEST_CASE("facing: beside a pair at the end of a zone there is no element, at other ends the next one") {
  Pair2 pair = flats(1, 0, 4);
  const Model m = pair.data.view();
  const int32_t expected[4][3] = {{-1, -1, 6}, {5, -1, 7}, {6, -1, 8}, {7, -1, -1}};
  Pair at = {};
  for (int32_t e = 0; e < 4; ++e)
    for (int32_t k = 0; k < 3; ++k) {
      at.element = 5 + e, at.eta = k - 1;
      CHECK(element_beside_pair(m, at) == expected[e][k]);
    }
}

TEST_CASE("facing: between ends of one value no zero is looked for") {
  Pair2 pair = flats(2, 0, 4);
  const Model m = pair.data.view();
  const facing::Place from = facing::place_at(m, m.zone[0], 0, FacePoint{6, 1, 0.0});
  const facing::Search off = facing::search_in(m, m.zone[0], from, 1, 0);
  CHECK(facing::zero_between(-0.5, 1.0, 0.25, 0.25, off) == -0.5);
}

namespace {

// Places the pairs of a zone that has been cut down to what faces.
void place_pairs(ModelData& data) {
  const Model& m = data.view();
  const Zone& z = m.zone[0];
  const int steps = m.head->function_nodes - 1;
  data.pairs.assign(static_cast<size_t>(z.pairs), Pair());
  for (int32_t k = 0; k < z.pairs; ++k) {
    const int32_t place = std::min(k / steps, z.elements - 1);
    const double eta = z.element_step[1] * node_eta(steps + 1, k - place * steps);
    FacePoint faced;
    REQUIRE(face_point(m, z, FacePoint{zone_element(m, z, 1, place), place, eta}, faced));
    data.pairs[static_cast<size_t>(k)].element = faced.element;
    data.pairs[static_cast<size_t>(k)].eta = faced.eta;
  }
}

// How many ends of side 0 face something, by the search of the whole zone. By its pairs the same point is found.
int compare_by_pairs(const Model& m) {
  const Zone& z = m.zone[0];
  int faced = 0;
  for (int32_t place = 0; place < zone_elements(z, 0); ++place)
    for (int l = 0; l < m.head->function_nodes; ++l) {
      const FacePoint at{zone_element(m, z, 0, place), place, node_eta(m.head->function_nodes, l)};
      FacePoint one, other;
      CAPTURE(place);
      CAPTURE(l);
      const bool any = facing_point(m, z, at, one);
      CHECK(facing_point_by_pairs(m, z, at, other) == any);
      if (!any) continue;
      ++faced;
      const SurfacePoint p = surface_point(m, z.body[1], one.element, one.eta),
                         q = surface_point(m, z.body[1], other.element, other.eta);
      CHECK(std::hypot(p.x - q.x, p.y - q.y) < 1e-9);
    }
  return faced;
}

} // namespace

TEST_CASE("facing: where pairs are placed they say where to look, on random bodies and round a ring") {
  int faced = 0, zones = 0;
  for (uint64_t seed = 201; seed <= 240; ++seed) {
    CAPTURE(seed);
    Dice dice(seed);
    Pair2 pair = Pair2::random(dice);
    if (pair.data.head.function_nodes < 2) continue;
    Reporter reporter = {&pair.data, ModelData::keep, 0};
    if (!fit_free_zone(pair.data.view(), 0, reporter)) continue;
    place_pairs(pair.data);
    faced += compare_by_pairs(pair.data.view()), ++zones;
  }
  CHECK(zones > 10);
  CHECK(faced > 300);
  for (const int elements : {7, 24}) { // bore of body 1 around body 2, which begins elsewhere
    ModelData data(3);
    const auto circle = [](double r, double start, int count, int way) {
      Points out;
      for (int i = 0; i < 2 * count; ++i) {
        const double angle = start + way * M_PI * i / count;
        out.push_back(r * std::cos(angle)), out.push_back(r * std::sin(angle));
      }
      return out;
    };
    data.body(3, {circle(2, 0, 8, 1), circle(1, 0.3, 13, -1)});
    data.body(3, {circle(0.98, 1, elements, 1)});
    Zone z = {};
    z.is_free = 1, z.body[1] = 1, z.region[0] = 1, z.first_element[0] = 8 + 5, z.element_step[0] = -1, z.facing = 13;
    z.element_step[1] = 1, z.elements = elements;
    data.zones = {z};
    data.zones[0].normal_part = find_normal_part(data.view(), data.zones[0]);
    Reporter reporter = {&data, ModelData::keep, 0};
    REQUIRE(fit_free_zone(data.view(), 0, reporter));
    place_pairs(data);
    CHECK(compare_by_pairs(data.view()) == 3 * 13);
  }
}

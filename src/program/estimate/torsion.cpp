// Phases:
//   1. matched: the element ends of both sides of every contact are placed opposite each other.
//   2. Builder: elements, pairs with the limits mu p of the last state, given angles and tractions.
//   3. Follower: the history of the cases round the axis, event by event; what the table shows.
#include "program/estimate/torsion.hpp"

#include "program/sketch/place_ends.hpp"
#include "program/sketch/torsion.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace estimate {
namespace {

using sketch::Point;

constexpr double kSamePlace = 1e-6; // of the length of a curve: ends nearer than this are one

constexpr size_t kMostTwistNodes = 3000; // of all bodies: the equations are dense
constexpr double kUnlike = 0.2;          // largest difference of the lengths of elements that face each other
const char* const kNotOpposite = "the elements of both sides of a contact could not be placed opposite each other";

class SectionCurve : public app::TwistCurve {
public:
  SectionCurve(const sketch::MeshedCurve& curve, double unit)
      : shape_(curve.curve->shape), measure_(curve.measure), unit_(unit), is_line_(shape_->form() == sketch::Form::kLine) {
    first_ = shape_->at(0), along_ = shape_->tangent(0);
  }
  Local local(double length) const override {
    if (is_line_) return {(1 / unit_) * first_ + length * along_, along_, 0};
    const double u = measure_.u_at(length * unit_);
    return {(1 / unit_) * shape_->at(u), shape_->tangent(u), unit_ * shape_->curvature(u)};
  }
  bool is_straight() const override { return is_line_; }

private:
  sketch::ShapePtr shape_;
  sketch::Measure measure_;
  double unit_;
  bool is_line_;
  Point first_, along_;
};

template <class AnyMesh, class Visit> void on_side_of(AnyMesh& mesh, size_t contact, int side, const Visit& visit) {
  for (auto& outlines : mesh.bodies)
    for (auto& outline : outlines)
      for (auto& curve : outline.curves)
        if (curve.curve->contact == static_cast<int>(contact) && curve.curve->side == side) visit(curve);
}

Point place_of(const sketch::MeshedCurve& curve, double s) { return curve.curve->shape->at(curve.measure.u_at(s)); }

// Adds an element end to the nearest of some curves, unless one is there.
void add_opposite(const std::vector<sketch::MeshedCurve*>& curves, Point p) {
  sketch::MeshedCurve* nearest = nullptr;
  double at = 0, least = HUGE_VAL;
  for (sketch::MeshedCurve* curve : curves) {
    const double s = sketch::nearest_length(*curve, p), away = app::distance(place_of(*curve, s), p);
    if (away < least) nearest = curve, at = s, least = away;
  }
  if (nearest == nullptr) return;
  std::vector<double>& ends = nearest->ends;
  const double room = kSamePlace * ends.back();
  const auto above = std::lower_bound(ends.begin(), ends.end(), at);
  if ((above != ends.end() && *above - at < room) || (above != ends.begin() && at - *(above - 1) < room)) return;
  ends.insert(above, at);
}

sketch::Mesh matched(const sketch::Sketch& sketch, const sketch::Mesh& mesh) {
  sketch::Mesh out = mesh;
  for (size_t c = 0; c < sketch.contacts.size(); ++c) {
    std::vector<sketch::MeshedCurve*> one, two;
    on_side_of(out, c, 1, [&](sketch::MeshedCurve& curve) { one.push_back(&curve); });
    on_side_of(out, c, 0, [&](sketch::MeshedCurve& curve) { two.push_back(&curve); });
    for (sketch::MeshedCurve* curve : two) {
      curve->ends = {0, curve->measure.length()};
      if (two.size() > 1) // where its curves meet
        for (const double s : std::vector<double>(curve->ends)) add_opposite(one, place_of(*curve, s));
    }
    for (const sketch::MeshedCurve* curve : one)
      for (const double s : curve->ends) add_opposite(two, place_of(*curve, s));
  }
  return out;
}

// Pressure at lengths along a curve of the side with pairs, from the solution on the mesh of the history.
class Pressures {
public:
  Pressures(const sketch::Mesh& mesh, const Trial& trial) : mesh_(mesh), trial_(trial) {}
  // Negative where the contact is open.
  double at(size_t body, const sketch::Curve* curve, double s) const {
    size_t first = 0;
    for (const sketch::MeshedOutline& outline : mesh_.bodies[body])
      for (const sketch::MeshedCurve& c : outline.curves) {
        if (c.curve == curve) return on(body, c, first, s);
        first += c.elements();
      }
    return -1;
  }

private:
  double on(size_t body, const sketch::MeshedCurve& curve, size_t first, double s) const {
    const std::vector<double>& ends = curve.ends;
    const auto above = std::upper_bound(ends.begin() + 1, ends.end() - 1, s);
    const auto e = static_cast<size_t>(above - ends.begin()) - 1;
    const auto nodes = static_cast<size_t>(trial_.nodes);
    const double eta = -1 + 2 * (s - ends[e]) / (ends[e + 1] - ends[e]);
    double shape[app::kTwistNodes];
    app::twist_shapes(nodes - 1, eta, shape);
    const State& state = trial_.states.back();
    double pressure = 0;
    bool closed = true;
    for (size_t i = 0; i < nodes; ++i) {
      const size_t end = (first + e) * nodes + i;
      const double at = -1 + 2.0 * static_cast<double>(i) / static_cast<double>(nodes - 1);
      const Point along = curve.curve->shape->tangent(curve.measure.u_at(ends[e] + (1 + at) / 2 * (ends[e + 1] - ends[e])));
      const auto& f = state.ends[body];
      const bool here = f[kStatus][end] > 0;
      pressure += shape[i] * (-(f[kTx][end] * along.y - f[kTy][end] * along.x));
      if (std::fabs(eta - at) < 1e-9) return here ? std::max(0.0, shape_value(f, end, along)) : -1;
      closed = closed && here;
    }
    return closed || pressure > 0 ? std::max(0.0, pressure) : -1;
  }
  static double shape_value(const std::array<std::vector<double>, kFields>& f, size_t end, Point along) {
    return -(f[kTx][end] * along.y - f[kTy][end] * along.x);
  }

  const sketch::Mesh& mesh_;
  const Trial& trial_;
};

// A part of the table: turns of one statement or of several on the same curves.
struct Part {
  const sketch::Turn* turn;
  std::vector<const sketch::Turn*> all;
};

bool same_part(const sketch::Turn& a, const sketch::Turn& b) {
  if (a.body != b.body || a.side.has_value() != b.side.has_value()) return false;
  return !a.side || a.side->names == b.side->names;
}

// What the model refers to.
struct Kept {
  sketch::Mesh mesh;
  std::vector<std::unique_ptr<SectionCurve>> curves;
};

class Builder {
public:
  Builder(const sketch::Sketch& sketch, const sketch::Mesh& mesh, const Trial& trial, Twisted& out)
      : s_(sketch), trial_(trial), pressures_(mesh, trial), kept_(std::make_shared<Kept>()), out_(out) {
    kept_->mesh = matched(sketch, mesh);
    out_.kept = kept_;
  }
  void build();
  double unit() const { return unit_; }
  double stress() const { return stress_; }
  const std::vector<Part>& parts() const { return parts_; }
  bool is_on(const Part& part, size_t body, size_t element) const {
    if (part.turn->body != static_cast<int>(body)) return false;
    return !part.turn->side || part.turn->side->has(out_.curves[body][element]->name);
  }

private:
  void scale();
  void bodies();
  void conditions();
  void pairs();
  void pair_up(size_t contact);

  const sketch::Sketch& s_;
  const Trial& trial_;
  Pressures pressures_;
  std::shared_ptr<Kept> kept_;
  Twisted& out_;
  double unit_ = 1, stress_ = 1; // powers of two near the largest coordinate and shear modulus
  std::vector<Part> parts_;
};

void Builder::scale() {
  double size = 0, modulus = 0;
  for (size_t b = 0; b < s_.bodies.size(); ++b) {
    if (!s_.bodies[b].rigid) modulus = std::max(modulus, s_.bodies[b].youngs_modulus / (2 * (1 + s_.bodies[b].poisson_ratio)));
    for (const sketch::MeshedOutline& outline : kept_->mesh.bodies[b])
      for (const sketch::MeshedCurve& curve : outline.curves) size = std::max(size, curve.measure.length());
  }
  unit_ = std::ldexp(1.0, std::ilogb(size)), stress_ = std::ldexp(1.0, std::ilogb(modulus));
}

void Builder::bodies() {
  app::TwistModel& m = out_.model;
  m.cases = s_.torsion.cases.size();
  for (size_t b = 0; b < s_.bodies.size(); ++b) {
    const sketch::Body& body = s_.bodies[b];
    app::TwistBody twist;
    twist.order = static_cast<size_t>(s_.order);
    twist.modulus = body.rigid ? 1 : body.youngs_modulus / (2 * (1 + body.poisson_ratio)) / stress_;
    out_.curves.emplace_back();
    for (const sketch::MeshedOutline& outline : kept_->mesh.bodies[b]) {
      const size_t begin = twist.nodes, first = twist.elements.size();
      for (const sketch::MeshedCurve& curve : outline.curves) {
        kept_->curves.push_back(std::make_unique<SectionCurve>(curve, unit_));
        for (size_t e = 0; e < curve.elements(); ++e) {
          app::TwistElement element;
          element.curve = kept_->curves.back().get();
          element.from = curve.ends[e] / unit_, element.to = curve.ends[e + 1] / unit_;
          for (size_t i = 0; i <= twist.order; ++i) element.node[i] = twist.nodes + i;
          twist.nodes += twist.order;
          twist.elements.push_back(element);
          out_.curves.back().push_back(curve.curve);
        }
      }
      if (outline.open)
        ++twist.nodes;
      else if (twist.elements.size() > first)
        twist.elements.back().node[twist.order] = begin;
      if (!outline.open || !s_.symmetry[1]) continue;
      for (const Point& p : {outline.curves.front().curve->shape->at(0), outline.curves.back().curve->shape->at(1)})
        if (std::fabs(p.y - *s_.symmetry[1]) < 1e-6 * unit_) twist.mirror = *s_.symmetry[1] / unit_;
    }
    m.rigid.push_back(static_cast<char>(body.rigid));
    m.bodies.push_back(std::move(twist));
  }
}

void Builder::conditions() {
  app::TwistModel& m = out_.model;
  for (const sketch::Turn& t : s_.torsion.turns) {
    const auto same = std::find_if(parts_.begin(), parts_.end(), [&](const Part& p) { return same_part(*p.turn, t); });
    if (same == parts_.end())
      parts_.push_back({&t, {&t}});
    else
      same->all.push_back(&t);
  }
  for (size_t b = 0; b < m.bodies.size(); ++b) {
    const app::TwistBody& body = m.bodies[b];
    const size_t local = body.order + 1;
    m.ends.emplace_back(body.elements.size() * local);
    m.angle.emplace_back(body.nodes);
    if (m.rigid[b] != 0) m.angle.back().assign(body.nodes, std::vector<double>(m.cases, 0.0));
    for (size_t e = 0; e < m.ends[b].size(); ++e) {
      const size_t element = e / local, node = body.elements[element].node[e % local];
      app::TwistEnd& end = m.ends[b][e];
      std::vector<double> angle(m.cases, 0.0);
      bool is_held = false;
      for (const Part& part : parts_) {
        if (!is_on(part, b, element)) continue;
        for (const sketch::Turn* t : part.all) {
          if (!t->is_traction) {
            is_held = true;
            if (t->load_case >= 0) angle[static_cast<size_t>(t->load_case)] += t->value;
            continue;
          }
          if (t->load_case < 0) continue;
          if (end.traction.empty()) end.traction.assign(m.cases, 0.0);
          const Point p =
              unit_ * body.elements[element].at(-1 + 2.0 * static_cast<double>(e % local) / static_cast<double>(body.order)).at;
          end.traction[static_cast<size_t>(t->load_case)] += (t->field ? t->field->at(p.x, p.y) : t->value) / stress_;
        }
      }
      if (m.rigid[b] != 0 && is_held) m.angle[b][node] = angle;
      if (m.rigid[b] != 0 || !is_held) continue;
      end.kind = app::TwistEnd::kHeld, end.traction.clear();
      if (m.angle[b][node].empty()) m.angle[b][node] = angle;
    }
  }
}

void Builder::pair_up(size_t contact) {
  app::TwistModel& m = out_.model;
  struct FacingElement {
    size_t body, element;
    Point middle;
  };
  std::vector<FacingElement> side[2];
  for (size_t b = 0; b < m.bodies.size(); ++b)
    for (size_t e = 0; e < m.bodies[b].elements.size(); ++e)
      if (out_.curves[b][e]->contact == static_cast<int>(contact))
        side[out_.curves[b][e]->side].push_back({b, e, m.bodies[b].elements[e].at(0).at});
  const sketch::Interface& interface = s_.interfaces[s_.contacts[contact].interface];
  const double mu = sketch::friction_round(interface);
  std::map<std::array<size_t, 4>, size_t> known; // pairs by their nodes
  for (const FacingElement& own : side[1]) {
    app::TwistElement& one = m.bodies[own.body].elements[own.element];
    const size_t order = m.bodies[own.body].order;
    std::vector<double> limit; // of |tau| at the nodes; below 0: open, or without friction
    for (size_t i = 0; i <= order; ++i) {
      const double s = unit_ * (one.from + (one.to - one.from) * static_cast<double>(i) / static_cast<double>(order));
      const double p = interface.tied ? 1 : pressures_.at(own.body, out_.curves[own.body][own.element], s);
      limit.push_back(interface.tied ? HUGE_VAL : p > 0 && mu > 0 ? mu * p / stress_ : -1);
    }
    if (*std::max_element(limit.begin(), limit.end()) < 0) continue;
    const FacingElement* other = nullptr;
    for (const FacingElement& f : side[0])
      if (other == nullptr || app::distance(f.middle, own.middle) < app::distance(other->middle, own.middle)) other = &f;
    if (other == nullptr) return void(out_.table.why = kNotOpposite);
    app::TwistElement& two = m.bodies[other->body].elements[other->element];
    if (two.facing != nullptr || std::fabs(two.half() - one.half()) > kUnlike * one.half())
      return void(out_.table.why = kNotOpposite);
    two.facing = &one;
    for (size_t i = 0; i <= order; ++i) {
      const size_t end1 = own.element * (order + 1) + i, end0 = other->element * (order + 1) + (order - i);
      if (limit[i] < 0) continue;
      const std::array<size_t, 4> nodes{own.body, one.node[i], other->body, two.node[order - i]};
      const auto [at, is_new] = known.emplace(nodes, m.pairs.size());
      if (is_new) m.pairs.push_back({{other->body, own.body}, {nodes[3], nodes[1]}, s_.contacts[contact].interface, limit[i]});
      for (const auto& [body, end] : {std::pair{own.body, end1}, std::pair{other->body, end0}}) {
        m.ends[body][end].kind = app::TwistEnd::kPair, m.ends[body][end].pair = at->second;
        m.ends[body][end].traction.clear();
      }
    }
  }
}

void Builder::build() {
  scale(), bodies();
  out_.unit = unit_;
  size_t nodes = 0;
  for (const app::TwistBody& body : out_.model.bodies) nodes += body.nodes;
  if (nodes > kMostTwistNodes) {
    out_.table.why =
        "the mesh has more than " + std::to_string(kMostTwistNodes) + " nodes, which loads round the axis are limited to";
    return;
  }
  conditions();
  for (size_t c = 0; c < s_.contacts.size() && out_.table.why.empty(); ++c) pair_up(c);
}

class Follower {
public:
  Follower(const sketch::Sketch& sketch, const Builder& builder, Twisted& out)
      : s_(sketch), b_(builder), out_(out), system_(out.model), torque_unit_(std::pow(builder.unit(), 3) * builder.stress()) {}
  void run();

private:
  void name();
  void weigh();
  void note(const app::SlipState& state);
  void look(const app::SlipState& state);
  std::vector<double> carried(const std::vector<double>& pair) const;
  double torque_on(const Part& part, const app::TwistField& field) const;
  double angle_of(const Part& part, const app::TwistField& field) const;
  void end(const app::SlipState& state);
  void borders(const app::SlipState& state);
  void numbers();
  double shear_on(const sketch::Want& want, Point& at) const;

  const sketch::Sketch& s_;
  const Builder& b_;
  Twisted& out_;
  app::TwistSystem system_;
  double torque_unit_;
  std::vector<double> weight_; // torque of a unit traction of each pair
  std::vector<int> count_;     // pairs that may slip, of each interface
  std::vector<size_t> shown_;  // interfaces of the table
};

void Follower::name() {
  app::TorsionTable& t = out_.table;
  for (const sketch::LoadCase& c : s_.torsion.cases) t.cases.push_back(c.name);
  for (const Part& part : b_.parts()) {
    std::string name = s_.bodies[static_cast<size_t>(part.turn->body)].name;
    for (size_t i = 0; part.turn->side && i < part.turn->side->names.size(); ++i)
      name += (i == 0 ? "." : "+") + part.turn->side->names[i];
    t.parts.push_back({name, part.turn->body + 1, part.turn->is_traction});
  }
  for (const sketch::Interface& i : s_.interfaces) {
    app::TorsionContact contact;
    contact.name = !i.name.empty() ? i.name : i.side[0].names[0] + " on " + i.side[1].names[0];
    contact.tied = i.tied;
    t.contacts.push_back(contact);
  }
}

void Follower::weigh() {
  const app::TwistModel& m = out_.model;
  weight_.assign(m.pairs.size(), 0.0);
  for (size_t b = 0; b < m.bodies.size(); ++b)
    for (size_t e = 0; e < m.ends[b].size(); ++e) {
      if (m.ends[b][e].kind != app::TwistEnd::kPair) continue;
      const app::TwistPair& pair = m.pairs[m.ends[b][e].pair];
      const size_t local = m.bodies[b].order + 1;
      if (pair.body[1] == b && pair.node[1] == m.bodies[b].elements[e / local].node[e % local])
        weight_[m.ends[b][e].pair] += system_.equations(b).torque[e];
    }
  count_.assign(s_.interfaces.size(), 0);
  for (const size_t k : system_.slipping()) {
    const size_t i = m.pairs[k].interface;
    ++count_[i];
    double& sum = out_.table.contacts[i].turns_through;
    sum = (std::isnan(sum) ? 0 : sum) + m.pairs[k].limit * weight_[k] * torque_unit_;
  }
}

std::vector<double> Follower::carried(const std::vector<double>& pair) const {
  std::vector<double> out(s_.interfaces.size(), 0.0);
  for (size_t k = 0; k < pair.size(); ++k) out[out_.model.pairs[k].interface] += pair[k] * weight_[k] * torque_unit_;
  return out;
}

// On the body by what turns it; of a rigid body what its contacts need.
double Follower::torque_on(const Part& part, const app::TwistField& field) const {
  const app::TwistModel& m = out_.model;
  const auto body = static_cast<size_t>(part.turn->body);
  const size_t local = m.bodies[body].order + 1;
  double sum = 0;
  for (size_t e = 0; e < m.ends[body].size(); ++e) {
    const bool is_pair = m.ends[body][e].kind == app::TwistEnd::kPair;
    if (!b_.is_on(part, body, e / local) || is_pair != (m.rigid[body] != 0)) continue;
    sum += (is_pair ? -1 : 1) * system_.equations(body).torque[e] * field.traction[body][e];
  }
  return sum * torque_unit_;
}

// Mean angle with the weight of the areas times the squared radius, the one that the torque does work on.
double Follower::angle_of(const Part& part, const app::TwistField& field) const {
  const app::TwistModel& m = out_.model;
  const auto body = static_cast<size_t>(part.turn->body);
  const size_t local = m.bodies[body].order + 1;
  double sum = 0, all = 0;
  for (size_t e = 0; e < m.ends[body].size(); ++e) {
    if (!b_.is_on(part, body, e / local)) continue;
    const app::TwistElement& element = m.bodies[body].elements[e / local];
    const double weight = system_.equations(body).torque[e] *
                          element.at(-1 + 2.0 * static_cast<double>(e % local) / static_cast<double>(local - 1)).at.x;
    sum += weight * field.angle[body][element.node[e % local]], all += weight;
  }
  return all != 0 ? sum / all : field.angle[body][m.bodies[body].elements[0].node[0]];
}

void Follower::note(const app::SlipState& state) {
  const app::TwistField field = system_.field(state);
  app::TorsionStep step;
  step.loads = state.factors;
  for (const Part& part : b_.parts()) {
    step.angle.push_back(angle_of(part, field));
    step.torque.push_back(torque_on(part, field));
  }
  step.carried = carried(field.pair);
  step.slipping.assign(s_.interfaces.size(), 0);
  for (size_t i = 0; i < state.status.size(); ++i)
    if (state.status[i] != 0) ++step.slipping[out_.model.pairs[system_.slipping()[i]].interface];
  out_.table.steps.push_back(step);
}

// At an event: has slip started in a contact, do all of its pairs slip?
void Follower::look(const app::SlipState& state) {
  std::vector<int> slips(s_.interfaces.size(), 0);
  std::vector<size_t> last(s_.interfaces.size(), 0);
  for (size_t i = 0; i < state.status.size(); ++i)
    if (state.status[i] != 0) {
      const size_t of = out_.model.pairs[system_.slipping()[i]].interface;
      ++slips[of], last[of] = system_.slipping()[i];
    }
  bool any = false;
  for (size_t i = 0; i < slips.size(); ++i) {
    app::TorsionContact& c = out_.table.contacts[i];
    const bool starts = slips[i] > 0 && std::isnan(c.start),
               through = slips[i] > 0 && slips[i] == count_[i] && std::isnan(c.through);
    if (!starts && !through) continue;
    const double torque = carried(system_.field(state).pair)[i];
    if (starts) {
      const app::TwistPair& pair = out_.model.pairs[last[i]];
      const Point at = system_.equations(pair.body[1]).at[pair.node[1]];
      c.start = torque, c.start_at[0] = at.x * b_.unit(), c.start_at[1] = at.y * b_.unit();
    }
    if (through) c.through = torque;
    any = true;
  }
  if (any) note(state);
}

// The square of the spare friction falls about linearly toward a border.
void Follower::borders(const app::SlipState& state) {
  const app::TwistModel& m = out_.model;
  std::vector<double> spare(m.pairs.size(), NAN);
  std::vector<int> slips(m.pairs.size(), 0);
  for (size_t i = 0; i < state.status.size(); ++i) {
    const size_t k = system_.slipping()[i];
    spare[k] = state.status[i] != 0 ? 0 : 1 - std::fabs(state.traction[i]) / m.pairs[k].limit;
    slips[k] = state.status[i];
  }
  const auto pair_at = [&](size_t b, size_t end) {
    return m.ends[b][end].kind == app::TwistEnd::kPair ? static_cast<int64_t>(m.ends[b][end].pair) : int64_t{-1};
  };
  for (size_t b = 0; b < m.bodies.size(); ++b) {
    const size_t order = m.bodies[b].order, local = order + 1;
    for (size_t e = 0; e < m.ends[b].size(); ++e) {
      if (e % local == order) continue;
      const int64_t p = pair_at(b, e), q = pair_at(b, e + 1);
      if (p < 0 || q < 0) continue;
      const app::TwistElement& element = m.bodies[b].elements[e / local];
      const auto& one = m.pairs[static_cast<size_t>(p)];
      if (one.body[1] != b || one.node[1] != element.node[e % local]) continue; // the other side
      const double a = spare[static_cast<size_t>(p)], c = spare[static_cast<size_t>(q)];
      if (std::isnan(a) || std::isnan(c) || (slips[static_cast<size_t>(p)] != 0) == (slips[static_cast<size_t>(q)] != 0))
        continue;
      const double step = 2.0 / static_cast<double>(order), first = -1 + step * static_cast<double>(e % local);
      const bool up = slips[static_cast<size_t>(p)] == 0; // stick first
      const double stuck = up ? a : c;
      double part = 0.5;                        // from the stuck node, in steps
      const size_t behind = up ? e - 1 : e + 2; // within the element
      if ((up && e % local > 0) || (!up && e % local + 1 < order)) {
        const int64_t k = pair_at(b, behind);
        const double next = k >= 0 ? spare[static_cast<size_t>(k)] : NAN;
        if (next > stuck) part = std::min(1.0, stuck * stuck / (next * next - stuck * stuck));
      }
      const Point at = element.at(up ? first + part * step : first + step - part * step).at;
      out_.table.borders.push_back({static_cast<int32_t>(one.interface) + 1, {at.x * b_.unit(), at.y * b_.unit()}});
    }
  }
}

void Follower::end(const app::SlipState& state) {
  out_.field = system_.field(state);
  borders(state);
  const app::TwistModel& m = out_.model;
  double largest = 0;
  std::vector<double> sums(m.bodies.size(), 0.0);
  for (size_t b = 0; b < m.bodies.size(); ++b) {
    if (m.rigid[b] != 0) continue;
    double whole = 0;
    for (size_t e = 0; e < m.ends[b].size(); ++e) {
      const double torque = system_.equations(b).torque[e] * out_.field.traction[b][e];
      sums[b] += torque, whole += std::fabs(torque);
    }
    largest = std::max(largest, whole);
  }
  for (const double sum : sums)
    if (largest > 0) out_.table.imbalance = std::max(out_.table.imbalance, std::fabs(sum) / largest);
}

// The resultant of the traction and of the shear stress along the surface, at the nodes: means of both elements.
double Follower::shear_on(const sketch::Want& want, Point& at) const {
  const app::TwistModel& m = out_.model;
  const auto b = static_cast<size_t>(want.body);
  const app::TwistBody& body = m.bodies[b];
  const size_t local = body.order + 1;
  double largest = 0;
  std::map<std::pair<size_t, const sketch::Curve*>, std::array<double, 5>> at_node; // sums: tau, along, count; place
  for (size_t e = 0; e < m.ends[b].size(); ++e) {
    const sketch::Curve* curve = out_.curves[b][e / local];
    if (!want.side->has(curve->name)) continue;
    const app::TwistElement& element = body.elements[e / local];
    const double eta = -1 + 2.0 * static_cast<double>(e % local) / static_cast<double>(body.order);
    double slope[app::kTwistNodes], change = 0;
    app::twist_slopes(body.order, eta, slope);
    for (size_t i = 0; i < local; ++i) change += slope[i] * out_.field.angle[b][element.node[i]];
    const Point p = element.at(eta).at;
    auto& sum = at_node[{element.node[e % local], curve}];
    sum[0] += out_.field.traction[b][e], sum[1] += body.modulus * p.x * change / element.half(), sum[2] += 1, sum[3] = p.x,
                                                                                                              sum[4] = p.y;
  }
  for (const auto& [node, sum] : at_node)
    if (const double stress = std::hypot(sum[0], sum[1]) / sum[2]; stress >= largest)
      largest = stress, at = {sum[3] * b_.unit(), sum[4] * b_.unit()};
  return largest * b_.stress();
}

// In the order: parts, contacts, requests along curves.
void Follower::numbers() {
  const app::TorsionTable& t = out_.table;
  const app::TorsionStep& last = t.steps.back();
  double torque = 0, angle = 0;
  for (const app::TorsionStep& step : t.steps)
    for (size_t i = 0; i < t.parts.size(); ++i)
      torque = std::max(torque, std::fabs(step.torque[i])), angle = std::max(angle, std::fabs(step.angle[i]));
  const auto add = [&](app::Measure what, const std::string& of, int32_t body, double value, double scale) -> app::Stated& {
    app::Stated s;
    s.what = what, s.of = of, s.body = body, s.value = value, s.scale = scale;
    for (const sketch::Want& w : s_.wants)
      if (w.of == sketch::WantOf::kTorsion && !w.side) {
        const std::vector<app::Measure>& all = sketch::want_row(w.word).quantities;
        if (std::count(all.begin(), all.end(), what) > 0)
          s.tolerance = std::fmin(s.tolerance, w.tolerance.value_or(s_.tolerance));
      }
    if (s_.wants.empty() && what != app::Measure::kSlipStart) s.tolerance = s_.tolerance;
    out_.numbers.push_back(s);
    return out_.numbers.back();
  };
  for (size_t i = 0; i < t.parts.size(); ++i) {
    add(app::Measure::kTorque, t.parts[i].name, t.parts[i].body, last.torque[i], torque);
    if (t.parts[i].is_loaded) add(app::Measure::kAngle, t.parts[i].name, t.parts[i].body, last.angle[i], angle);
  }
  for (const app::TorsionContact& c : t.contacts) {
    if (c.tied || std::isnan(c.turns_through)) continue;
    if (!std::isnan(c.start)) add(app::Measure::kSlipStart, c.name, 0, std::fabs(c.start), torque);
    add(app::Measure::kTurnsThrough, c.name, 0, c.turns_through, c.turns_through);
  }
  for (const sketch::Want& w : s_.wants)
    if (w.of == sketch::WantOf::kTorsion && w.side) {
      Point at;
      const double shear = shear_on(w, at);
      app::Stated& s = add(app::Measure::kShear, w.side->names[0], w.body + 1, shear, shear);
      s.tolerance = w.tolerance.value_or(s_.tolerance), s.at[0] = at.x, s.at[1] = at.y;
    }
}

void Follower::run() {
  name();
  if (system_.is_singular()) {
    out_.table.why =
        "a body can turn without resistance: expected a contact with friction that is closed, a tie or a given angle";
    return;
  }
  weigh();
  app::SlipPath path(system_.problem());
  note(path.state());
  const sketch::Torsion& t = s_.torsion;
  for (int piece = 0; piece < t.pieces && out_.table.ended.empty(); ++piece) {
    const std::vector<double> from = path.state().factors;
    const int steps = s_.steps[std::min(static_cast<size_t>(t.first_piece + piece), s_.steps.size() - 1)];
    for (int k = 1; k <= steps; ++k) {
      std::vector<double> to(from.size());
      for (size_t c = 0; c < to.size(); ++c) {
        const double end = t.cases[c].factors[static_cast<size_t>(piece)];
        to[c] = k == steps ? end : from[c] + (end - from[c]) * k / steps;
      }
      const bool goes_on = path.go_to(to, [&](const app::SlipState& state) { look(state); });
      note(path.state());
      if (goes_on) continue;
      out_.table.ended = "a body turns through: its contacts carry no more torque";
      break;
    }
  }
  out_.table.residual = path.residual();
  end(path.state());
  numbers();
}

} // namespace

Twisted twist(const sketch::Sketch& sketch, const sketch::Mesh& mesh, const Trial& trial) {
  Twisted out;
  if (trial.outcome != C2D_REACHED || trial.states.empty()) {
    out.table.why = "the history in the plane of the section ended early: " + trial.why;
    return out;
  }
  Builder builder(sketch, mesh, trial, out);
  builder.build();
  if (out.table.why.empty()) Follower(sketch, builder, out).run();
  return out;
}

namespace {

// Angle slope along the boundary and traction of a field at a length of a curve.
struct TwistValues {
  double slope = 0, traction = 0;
};

TwistValues values_at(const Twisted& t, size_t b, const sketch::Curve* curve, double length) {
  const app::TwistBody& body = t.model.bodies[b];
  for (size_t e = 0; e < body.elements.size(); ++e) {
    const app::TwistElement& element = body.elements[e];
    if (t.curves[b][e] != curve || length < element.from || length > element.to) continue;
    const double eta = (length - element.from) / element.half() - 1;
    double shape[app::kTwistNodes], slope[app::kTwistNodes];
    app::twist_shapes(body.order, eta, shape), app::twist_slopes(body.order, eta, slope);
    TwistValues out;
    for (size_t i = 0; i <= body.order; ++i) {
      out.slope += slope[i] * t.field.angle[b][element.node[i]] / element.half();
      out.traction += shape[i] * t.field.traction[b][e * (body.order + 1) + i];
    }
    return out;
  }
  return {};
}

constexpr double kLargestShare = 0.2; // of the largest share: elements marked

} // namespace

void mark_torsion(const sketch::Sketch& sketch, const Twisted& coarse, const Twisted& fine, const sketch::Mesh& mesh,
                  sketch::Levels& levels) {
  if (!coarse.table.why.empty() || !fine.table.why.empty()) return;
  struct Marked {
    size_t body, element;
    double share;
  };
  std::vector<Marked> all;
  double worst = 0;
  for (size_t b = 0; b < coarse.model.bodies.size(); ++b) {
    if (sketch.bodies[b].rigid) continue;
    for (size_t e = 0; e < coarse.curves[b].size(); ++e) {
      const app::TwistElement& element = coarse.model.bodies[b].elements[e];
      const double modulus = coarse.model.bodies[b].modulus;
      double sum = 0;
      for (const double eta : {-0.9, -0.6, -0.3, 0.3, 0.6, 0.9}) {
        const double s = element.from + (1 + eta) * element.half(), r = element.at(eta).at.x;
        const TwistValues p = values_at(coarse, b, coarse.curves[b][e], s), q = values_at(fine, b, coarse.curves[b][e], s);
        sum += std::pow(p.traction - q.traction, 2) * r / modulus + modulus * std::pow((p.slope - q.slope) * r, 2) * r;
      }
      all.push_back({b, e, sum * element.half() * element.half()});
      worst = std::max(worst, all.back().share);
    }
  }
  for (const Marked& m : all) {
    if (m.share < kLargestShare * worst) continue;
    const app::TwistElement& element = coarse.model.bodies[m.body].elements[m.element];
    size_t first = 0;
    for (const sketch::MeshedOutline& outline : mesh.bodies[m.body])
      for (const sketch::MeshedCurve& curve : outline.curves) {
        if (curve.curve == coarse.curves[m.body][m.element]) {
          const double s = coarse.unit * (element.from + element.half());
          const auto above = std::upper_bound(curve.ends.begin() + 1, curve.ends.end() - 1, s);
          sketch::Bisection& own = levels[m.body][first + static_cast<size_t>(above - curve.ends.begin()) - 1];
          own.level = std::max(own.level, 1);
        }
        first += curve.elements();
      }
  }
}

} // namespace estimate

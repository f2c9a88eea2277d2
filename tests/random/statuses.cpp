#include "statuses.hpp"

#include "elastic.hpp"

#include <algorithm>
#include <cmath>

namespace random_decks {

namespace {

using namespace problem;

constexpr size_t kMostPairs = 5;
constexpr double kClear = 1e-6;      // margins of a solution beyond doubt
constexpr double kDoubtful = -1e-8;  // and of one that may be one
constexpr double kLeastPivot = 1e-7; // a set of equations beyond doubt
constexpr double kSingular = 1e-12;

size_t index(int64_t i) { return static_cast<size_t>(i); }

// What a pair of the model is, from the library's table.
struct Contact {
  int32_t node[2];
  double n[2], t[2];
};

// ---- response of both bodies ------------------------------------------------------------------------------------------
// With springs between the bodies, w + k tau = s at every pair and direction: w = w0 + W s for any supports.

struct Response {
  double spring = 0;
  double no_motion = 0, no_force = 0; // what a motion of both leaves as round-off is far below 1e-6 of these
  std::vector<double> w0;             // by the loads
  Matrix w;                           // by s
};

class Reduction {
public:
  Reduction(const Problem& p, const std::vector<Contact>& contacts) : p_(p), contacts_(contacts) {}
  bool reduce(Response& out);

private:
  void number_body(int b);
  void add_body(int b);
  void add_springs(double spring);
  void note_sizes(Response& out) const;

  const Problem& p_;
  const std::vector<Contact>& contacts_;
  Equations equations_[2];
  std::vector<int64_t> u_[2], t_[2]; // column of each displacement and traction; -1: known
  size_t columns_ = 0;
  size_t motion_[2] = {0, 0};
  Matrix a_, b_; // right-hand sides: loads, then s
};

void Reduction::number_body(int b) {
  const Body& body = p_.bodies[index(b)];
  equations_[b] = equations_of(p_, b + 1);
  u_[b].assign(index(2 * equations_[b].nodes), -2);
  t_[b].assign(index(2 * equations_[b].ends), -1);
  for (size_t end = 0; end < body.ends.size(); ++end)
    for (int c = 0; c < 2; ++c) {
      const int32_t e = static_cast<int32_t>(end) / p_.function_nodes + 1, l = static_cast<int32_t>(end) % p_.function_nodes;
      int64_t& u = u_[b][index(2 * node_of_end(p_, body, e, l) + c)];
      if (body.ends[end].codes[2 + c] == 0) u = -1;
    }
  for (int64_t& u : u_[b])
    if (u == -2) u = static_cast<int64_t>(columns_++);
  // A node whose displacement is known has one unknown traction, shared by its ends where both are unknown.
  std::vector<int64_t> shared(u_[b].size(), -1);
  for (size_t end = 0; end < body.ends.size(); ++end)
    for (int c = 0; c < 2; ++c) {
      if (body.ends[end].codes[c] == 0) continue;
      const int32_t e = static_cast<int32_t>(end) / p_.function_nodes + 1, l = static_cast<int32_t>(end) % p_.function_nodes;
      int64_t& column = shared[index(2 * node_of_end(p_, body, e, l) + c)];
      if (column < 0) column = static_cast<int64_t>(columns_++);
      t_[b][2 * end + index(c)] = column;
    }
  motion_[b] = columns_;
  columns_ += 3;
}

bool is_contact_end(const Problem& p, int b, int32_t element) {
  for (const problem::Zone& z : p.zones)
    if ((element - z.first_element[b]) * (element - z.last_element[b]) <= 0) return true;
  return false;
}

void Reduction::add_body(int b) {
  const Body& body = p_.bodies[index(b)];
  const Equations& q = equations_[b];
  const size_t forces = columns_ - 2 * contacts_.size();
  for (const std::vector<double>& row : q.rows) {
    std::vector<double> line(columns_, 0);
    double known = 0;
    for (size_t end = 0; end < body.ends.size(); ++end) {
      const int32_t e = static_cast<int32_t>(end) / p_.function_nodes + 1, l = static_cast<int32_t>(end) % p_.function_nodes;
      const int32_t node = node_of_end(p_, body, e, l);
      for (int c = 0; c < 2; ++c) {
        const double coefficient = row[q.t(static_cast<int32_t>(end), c)];
        const int64_t column = t_[b][2 * end + index(c)];
        if (column >= 0)
          line[index(column)] += coefficient;
        else
          known += coefficient * body.ends[end].values[c];
        for (size_t i = 0; i < contacts_.size() && is_contact_end(p_, b, e); ++i) {
          if (contacts_[i].node[b] != node) continue;
          const double sign = b == 0 ? -1 : 1; // force on body 2 is positive
          line[forces + 2 * i] += sign * coefficient * contacts_[i].n[c];
          line[forces + 2 * i + 1] += sign * coefficient * contacts_[i].t[c];
        }
      }
    }
    std::vector<bool> seen(u_[b].size(), false);
    for (size_t end = 0; end < body.ends.size(); ++end)
      for (int c = 0; c < 2; ++c) {
        const int32_t e = static_cast<int32_t>(end) / p_.function_nodes + 1, l = static_cast<int32_t>(end) % p_.function_nodes;
        const size_t i = index(2 * node_of_end(p_, body, e, l) + c);
        if (seen[i]) continue;
        seen[i] = true;
        if (u_[b][i] >= 0)
          line[index(u_[b][i])] += row[i];
        else
          known += row[i] * body.ends[end].values[2 + c];
      }
    for (int k = 0; k < 3; ++k) line[motion_[b] + index(k)] += row[q.motion(k)];
    std::vector<double> right(1 + 2 * contacts_.size(), 0);
    right[0] = -known;
    a_.push_back(line);
    b_.push_back(right);
  }
}

void Reduction::add_springs(double spring) {
  const size_t forces = columns_ - 2 * contacts_.size();
  for (size_t i = 0; i < contacts_.size(); ++i)
    for (size_t d = 0; d < 2; ++d) {
      std::vector<double> line(columns_, 0), right(1 + 2 * contacts_.size(), 0);
      const double* along = d == 0 ? contacts_[i].n : contacts_[i].t;
      for (int b = 0; b < 2; ++b)
        for (int c = 0; c < 2; ++c) line[index(u_[b][index(2 * contacts_[i].node[b] + c)])] += (b == 0 ? -1 : 1) * along[c];
      line[forces + 2 * i + d] = spring;
      right[1 + 2 * i + d] = 1;
      a_.push_back(line);
      b_.push_back(right);
    }
}

// From the solution with springs: bodies that go along with each other have neither relative motions nor forces.
void Reduction::note_sizes(Response& out) const {
  double way = 0, length = 0, stiffness = 0;
  for (int b = 0; b < 2; ++b) {
    const Body& body = p_.bodies[index(b)];
    for (int64_t column : u_[b])
      if (column >= 0) way = std::max(way, std::fabs(b_[index(column)][0]));
    for (const End& end : body.ends)
      for (size_t c = 2; c < 4; ++c)
        if (end.codes[c] == 0) way = std::max(way, std::fabs(end.values[c]));
    for (double x : body.xy) length = std::max(length, std::fabs(x));
    stiffness = std::max(stiffness, body.youngs_modulus);
  }
  out.no_motion = 1e-6 * way;
  out.no_force = 1e-6 * stiffness * way / length;
}

bool Reduction::reduce(Response& out) {
  for (int b = 0; b < 2; ++b) number_body(b);
  for (const Contact& contact : contacts_)
    for (int b = 0; b < 2; ++b)
      for (int c = 0; c < 2; ++c)
        if (u_[b][index(2 * contact.node[b] + c)] < 0) return false; // symmetry
  columns_ += 2 * contacts_.size();
  for (int b = 0; b < 2; ++b) add_body(b);
  out.spring = 1 / std::min(p_.bodies[0].youngs_modulus, p_.bodies[1].youngs_modulus);
  add_springs(out.spring);
  if (a_.size() != columns_) return false;
  // Tractions are as large as moduli times displacements.
  const double stress = std::max(p_.bodies[0].youngs_modulus, p_.bodies[1].youngs_modulus);
  std::vector<double> scale(columns_, 1);
  for (int b = 0; b < 2; ++b)
    for (int64_t column : t_[b])
      if (column >= 0) scale[index(column)] = stress;
  for (size_t i = columns_ - 2 * contacts_.size(); i < columns_; ++i) scale[i] = 1 / out.spring;
  for (std::vector<double>& line : a_) {
    double largest = 0;
    for (size_t j = 0; j < columns_; ++j) line[j] *= scale[j], largest = std::max(largest, std::fabs(line[j]));
    for (double& value : line) value /= largest;
    for (double& value : b_[static_cast<size_t>(&line - a_.data())]) value /= largest;
  }
  if (!solve_dense(a_, b_, kSingular)) return false;
  note_sizes(out);
  const size_t forces = columns_ - 2 * contacts_.size(), m = 2 * contacts_.size();
  out.w0.assign(m, 0);
  out.w.assign(m, std::vector<double>(m, 0));
  for (size_t i = 0; i < m; ++i) { // w = s - k tau
    out.w0[i] = -b_[forces + i][0];
    for (size_t j = 0; j < m; ++j) out.w[i][j] = (i == j ? 1 : 0) - b_[forces + i][1 + j];
  }
  return true; // scaled with 1/k, b holds k tau
}

// ---- sets of statuses -------------------------------------------------------------------------------------------------

enum Choice { kOpen, kStick, kUp, kDown, kChoices }; // slip with friction along t or against it

struct Trier {
  const Response& response;
  double mu;
  std::vector<Choice> choice;

  bool solve(std::vector<double>& w, std::vector<double>& tau, double* pivot) const;
  double margin(const std::vector<double>& w, const std::vector<double>& tau) const;
};

bool Trier::solve(std::vector<double>& w, std::vector<double>& tau, double* pivot) const {
  const size_t m = 2 * choice.size();
  Matrix a(m, std::vector<double>(m, 0)), right(m, std::vector<double>(1, 0));
  for (size_t i = 0; i < choice.size(); ++i) {
    const double slope = choice[i] == kUp ? mu : -mu;
    for (size_t d = 0; d < 2; ++d) { // row of w, or of k tau = s - w
      const size_t r = 2 * i + d;
      const bool force = choice[i] == kOpen || (d == 1 && choice[i] != kStick);
      const double sign = force ? -1 : 1;
      for (size_t j = 0; j < m; ++j) a[r][j] = sign * response.w[r][j] + (force && j == r ? 1 : 0);
      right[r][0] = -sign * response.w0[r];
      if (!force || choice[i] == kOpen) continue;
      for (size_t j = 0; j < m; ++j) a[r][j] -= slope * (-response.w[r - 1][j] + (j == r - 1 ? 1 : 0));
      right[r][0] -= slope * response.w0[r - 1];
    }
  }
  if (!solve_dense(a, right, kSingular, pivot)) return false;
  w.assign(m, 0), tau.assign(m, 0);
  for (size_t i = 0; i < m; ++i) {
    w[i] = response.w0[i];
    for (size_t j = 0; j < m; ++j) w[i] += response.w[i][j] * right[j][0];
    tau[i] = (right[i][0] - w[i]) / response.spring;
  }
  return true;
}

double Trier::margin(const std::vector<double>& w, const std::vector<double>& tau) const {
  double force = response.no_force, way = response.no_motion, least = HUGE_VAL;
  for (double value : tau) force = std::max(force, std::fabs(value));
  for (double value : w) way = std::max(way, std::fabs(value));
  way = std::max(way, response.spring * force); // where nothing moves
  force = std::max(force, way / response.spring * 1e-9);
  if (way == 0) return HUGE_VAL;
  for (size_t i = 0; i < choice.size(); ++i) {
    const double tn = tau[2 * i] / force, tt = tau[2 * i + 1] / force;
    const double wn = w[2 * i] / way, wt = w[2 * i + 1] / way;
    if (choice[i] == kOpen) least = std::min(least, wn);
    if (choice[i] == kStick) least = std::min({least, tn, mu * tn - std::fabs(tt)});
    if (choice[i] == kUp) least = std::min({least, tn, -wt});
    if (choice[i] == kDown) least = std::min({least, tn, wt});
  }
  return least;
}

// `no_force`: what a motion without forces leaves of them as round-off is no more than 1e-6 of this.
bool same_state(const std::vector<double>& a, const std::vector<double>& b, double no_force) {
  double size = no_force, worst = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    size = std::max({size, std::fabs(a[i]), std::fabs(b[i])});
    worst = std::max(worst, std::fabs(a[i] - b[i]));
  }
  return worst <= 1e-6 * size;
}

void keep(Trial& trial, const Trier& trier, const std::vector<double>& tau, double margin, double pivot) {
  for (Solution& other : trial.found) {
    if (!same_state(other.forces, tau, trial.no_force)) continue;
    if (margin > other.margin) other.margin = margin, other.pivot = pivot;
    return;
  }
  Solution s;
  for (Choice c : trier.choice) s.status.push_back(c == kOpen ? C2D_OPEN : c == kStick ? C2D_STICK : C2D_SLIP);
  s.forces = tau;
  s.margin = margin;
  s.pivot = pivot;
  trial.found.push_back(s);
}

std::vector<Contact> contacts_of(const Step& frames) {
  std::vector<Contact> out;
  for (int i = 0; i < frames.pairs(); ++i) {
    const double nx = frames.at(i, C2D_NX), ny = frames.at(i, C2D_NY);
    out.push_back(
        {{static_cast<int32_t>(frames.at(i, C2D_PAIR_NODE1)) - 1, static_cast<int32_t>(frames.at(i, C2D_PAIR_NODE2)) - 1},
         {nx, ny},
         {ny, -nx}});
  }
  return out;
}

bool is_of_the_kind(const Model& model, const Step& frames) {
  const Problem& p = model.problem;
  for (int i = 0; i < frames.pairs(); ++i) {
    const double gap = frames.at(i, C2D_GAP) - (frames.at(i, C2D_UN2) - frames.at(i, C2D_UN1));
    const double size = std::max(std::fabs(frames.at(i, C2D_UN1)), std::fabs(frames.at(i, C2D_UN2)));
    if (std::fabs(gap) > 1e-9 * (1 + size)) return false;
  }
  // Constant functions do not hold the balance of a free body: its matrices look as if something held it a little.
  return p.function_nodes > 1 && model.proportional && frames.pairs() > 0 && frames.pairs() <= static_cast<int>(kMostPairs) &&
         p.friction[0] > 0 && std::isfinite(p.friction[0]) && p.bodies[0].regions.size() == 1 &&
         p.bodies[1].regions.size() == 1 && p.point_loads.empty() && p.free_zones.empty();
}

} // namespace

int32_t Trial::clear() const {
  int32_t count = 0;
  for (const Solution& s : found) count += s.margin > kClear && s.pivot > kLeastPivot;
  return count;
}

Trial try_statuses(const Model& model, const Step& frames) {
  Trial trial;
  if (!is_of_the_kind(model, frames)) return trial;
  Response response;
  if (!Reduction(model.problem, contacts_of(frames)).reduce(response)) return trial;
  trial.done = true;
  trial.no_force = response.no_force;
  Trier trier = {response, model.problem.friction[0], std::vector<Choice>(index(frames.pairs()), kOpen)};
  for (bool more = true; more;) {
    std::vector<double> w, tau;
    double pivot = 0;
    if (trier.solve(w, tau, &pivot)) {
      const double margin = trier.margin(w, tau);
      if (margin > kDoubtful) keep(trial, trier, tau, margin, pivot);
    }
    more = false;
    for (Choice& c : trier.choice) { // the next set
      c = static_cast<Choice>(c + 1);
      more = c != kChoices;
      if (more) break;
      c = kOpen;
    }
  }
  return trial;
}

std::string against_trial(const Model& model, const Trial& trial, const Result& deck, bool warned) {
  (void)model;
  if (!trial.done) return "";
  const std::vector<Step> rows = deck.recorded();
  if (rows.empty() || rows[0].load == 0)
    return trial.clear() > 0 ? "solvable, but not solved: " + std::string(c2d_outcome_message(deck.outcome)) : "";
  if (trial.found.empty()) return "solved, but no set of statuses is a solution";
  std::vector<double> forces;
  for (int i = 0; i < rows[0].pairs(); ++i)
    for (int field : {C2D_TN, C2D_TT}) forces.push_back(rows[0].at(i, field) / rows[0].load);
  bool known = false;
  for (const Solution& s : trial.found) known = known || same_state(s.forces, forces, trial.no_force);
  if (!known) return "the state is none of the " + std::to_string(trial.found.size()) + " solutions found by trying all";
  if (trial.clear() > 1 && !warned) return "not unique without a word: " + std::to_string(trial.clear()) + " solutions";
  if (trial.found.size() == 1 && trial.clear() == 1 && warned) return "said to be not unique: one solution";
  return "";
}

double elastic_residual(const Model& model, const Step& row) {
  const Problem& p = model.problem;
  double moved = 0; // a body that nothing touches has but round-off of what the other moves
  for (const std::vector<EndResult>& ends : row.boundary)
    for (const EndResult& e : ends) moved = std::max(moved, std::hypot(e.ux, e.uy));
  const int passed = model.same_surfaces ? -1 : p.free_zones.empty() ? 1 : 0;
  double worst = 0;
  for (int b = 0; b < 2; ++b) {
    const Body& body = p.bodies[index(b)];
    if (b == passed || body.regions.size() > 1 || row.boundary[b].empty()) continue;
    for (const PointLoad& l : p.point_loads)
      if (l.body == b + 1) return 0;
    const Equations q = equations_of(p, b + 1);
    std::vector<double> values(q.columns(), 0), left;
    for (size_t end = 0; end < body.ends.size(); ++end) {
      const EndResult& e = row.boundary[b][end];
      const int32_t node = node_of_end(p, body, e.element, static_cast<int32_t>(end) % p.function_nodes);
      values[q.u(node, 0)] = e.ux, values[q.u(node, 1)] = e.uy;
      values[q.t(static_cast<int32_t>(end), 0)] = e.tx, values[q.t(static_cast<int32_t>(end), 1)] = e.ty;
    }
    double size = 0;
    Matrix normal(3, std::vector<double>(3, 0)), right(3, std::vector<double>(1, 0));
    for (int32_t i = 0; i < 2 * q.nodes; ++i) {
      const std::vector<double>& r = q.rows[index(i)];
      double sum = 0;
      for (size_t j = 0; j < q.motion(0); ++j) sum += r[j] * values[j], size = std::max(size, std::fabs(r[j] * values[j]));
      for (size_t j = 0; j < index(2 * q.nodes); ++j) size = std::max(size, std::fabs(1e-3 * r[j] * moved));
      left.push_back(sum);
      for (size_t k = 0; k < 3; ++k) { // the motions that fit best
        right[k][0] -= r[q.motion(static_cast<int>(k))] * sum;
        for (size_t j = 0; j < 3; ++j) normal[k][j] += r[q.motion(static_cast<int>(k))] * r[q.motion(static_cast<int>(j))];
      }
    }
    if (size == 0 || !solve_dense(normal, right, kSingular)) continue;
    for (int32_t i = 0; i < 2 * q.nodes; ++i) {
      double rest = left[index(i)];
      for (size_t k = 0; k < 3; ++k) rest += q.rows[index(i)][q.motion(static_cast<int>(k))] * right[k][0];
      worst = std::max(worst, std::fabs(rest) / size);
    }
  }
  return worst;
}

} // namespace random_decks

// Bodies of revolution in torsion that are tied to each other or in contact, as one system of equations (METHOD 21.10).
#pragma once

#include "post/torsion/slip_path.hpp"

#include <cstdint>

namespace app {

// A pair of nodes that face each other; body[1] has the shear traction tau, body[0] the opposite one.
struct TwistPair {
  size_t body[2], node[2];
  size_t interface = 0;
  double limit = HUGE_VAL; // of |tau|; infinite: tied
};

// What is given at an element end.
struct TwistEnd {
  enum Kind { kTraction, kHeld, kPair } kind = kTraction;
  size_t pair = 0;              // of kPair
  std::vector<double> traction; // of kTraction, in each load case; empty: zero
};

struct TwistModel {
  size_t cases = 1;
  std::vector<TwistBody> bodies;
  std::vector<char> rigid;                             // of each body: it has no equations, all of its nodes are given
  std::vector<std::vector<std::vector<double>>> angle; // [body][node]: given in each load case; empty: not given
  std::vector<std::vector<TwistEnd>> ends;             // [body][element * (order + 1) + local]
  std::vector<TwistPair> pairs;
};

struct TwistField {
  std::vector<std::vector<double>> angle, traction; // [body][node], [body][element end]
  std::vector<double> pair;                         // tau of each pair
};

class TwistSystem {
public:
  explicit TwistSystem(const TwistModel& model);
  bool is_singular() const { return singular_; } // a body can turn without resistance
  // The pairs that may slip, in the order of the model, and their problem.
  const std::vector<size_t>& slipping() const { return may_slip_; }
  const SlipProblem& problem() const { return problem_; }
  TwistField field(const SlipState& state) const;
  const TwistEquations& equations(size_t body) const { return equations_[body]; }

private:
  struct Offset {
    size_t pair;
    double sign;
  };
  void link();
  void number();
  void assemble();
  void add_node(double* row, double* right, size_t body, size_t node, double factor) const;
  void add_end(double* row, double* right, size_t body, size_t end, double factor) const;
  void reduce();
  size_t global(size_t body, size_t node) const { return first_[body] + node; }

  const TwistModel& model_;
  std::vector<TwistEquations> equations_;
  std::vector<size_t> first_;                                    // global number of the first node of a body
  std::vector<size_t> root_;                                     // of each node: one with the same angle, but for slip
  std::vector<std::vector<Offset>> offset_;                      // its angle less that of the root: slip of these pairs
  std::vector<std::vector<double>> known_;                       // of each root: its angle, if given
  std::vector<char> linked_;                                     // of each pair
  std::vector<int64_t> angle_at_, held_at_, pair_at_, twist_at_; // unknowns of roots, nodes, pairs, bodies; -1: none
  std::vector<int64_t> slip_at_;                                 // of each pair: among those that may slip; -1: it may not
  std::vector<size_t> may_slip_;
  size_t unknowns_ = 0;
  TwistMatrix matrix_{0, 0}, right_{0, 0}; // right: load cases, slips; afterwards the solution
  SlipProblem problem_{TwistMatrix(0, 0), TwistMatrix(0, 0), {}};
  bool singular_ = false;
};

} // namespace app

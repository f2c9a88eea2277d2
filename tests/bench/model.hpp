// Models by calls of the C interface, of any size.
#pragma once
#include "../host_structs.hpp"
#include "contact2d.h"

#include "c2d_memory.h"
#include "c2d_threads.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace bench {

// Of the system, as the program does: tableaux are read along their rows, which costs as much in small pages as all else.
void ask_for_huge_pages(void* memory, uint64_t bytes);

// A solver with its workspace, all in memory, and its store. Its times are those of the processor, or, with a number of
// threads, those of the clock.
class Solver {
public:
  explicit Solver(const c2d_limits& limits, int32_t threads = 0);
  ~Solver();
  Solver(const Solver&) = delete;
  Solver& operator=(const Solver&) = delete;
  operator c2d_solver*() const { return solver_; }
  // Ends the benchmarks with the solver's own words if the call failed.
  void must(c2d_status status) const;
  host::Summary summary() const;

private:
  std::vector<unsigned char> memory_, tapes_;
  c2d_memory_store store_;
  std::unique_ptr<c2d_threads> pool_;
  c2d_solver* solver_ = nullptr;
};

// The cylinder of examples/hertz.dat on its foundation: half of the model, this many pairs from x = 0 to 2.8.
struct Cylinder {
  int32_t pairs;
  std::vector<double> foundation, disc;   // boundary points, x y x y ...
  int32_t floor, side, top, zone1, axis1; // first elements (from 1) of the foundation's parts
  int32_t loaded, axis2, zone2, disc_elements, foundation_elements;
  explicit Cylinder(int32_t pairs);
  host::Limits limits() const;
  void build(const Solver& solver) const; // up to c2d_complete
};

// A ring of `elements` elements round its bore and as many outside, radii 1 and 2, pressure 1 in the bore.
struct Ring {
  int32_t elements, element_nodes, function_nodes;
  bool round; // curved elements on the circles, or straight ones with the ends there
  host::Limits limits() const;
  void build(const Solver& solver) const;
};

// A disc of straight elements, radius 1: held on a quarter of its boundary, pressed on another.
struct Disc {
  int32_t elements;
  double radius = 0; // above 0: a ring of revolution, of its middle
  int32_t function_nodes = 2;
  host::Limits limits() const;
  void build(const Solver& solver) const;
};

} // namespace bench

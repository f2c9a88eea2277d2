// Solves a deck from C++, with a wrapper of 30 lines that owns the memory and closes the solver.
//
//   g++ -std=c++17 raii.cpp $(pkg-config --cflags --libs contact2d) -o raii
//   ./raii hertz.dat
#include "c2d_memory.h"
#include "contact2d.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

// The wrapper: memory, blocks, solver, and statuses as exceptions. Library calls accept it as a c2d_solver*.
class Contact {
public:
  Contact(const c2d_limits& limits, uint64_t tape_bytes) : blocks_(tape_bytes) {
    uint64_t in_core = 0;
    check(c2d_memory_need(&limits, nullptr, &in_core, nullptr));
    memory_.resize(in_core);
    c2d_memory_store_init(&store_, blocks_.data(), blocks_.size());
    c2d_port port = C2D_INIT(c2d_port);
    c2d_memory_store_port(&store_, &port);
    check(c2d_create(&solver_, memory_.data(), memory_.size(), &limits, &port, nullptr));
  }
  ~Contact() { c2d_close(solver_); }
  Contact(const Contact&) = delete;
  Contact& operator=(const Contact&) = delete;
  operator c2d_solver*() { return solver_; }

  void check(c2d_status status) const {
    if (status == C2D_OK) return;
    c2d_error why = C2D_INIT(c2d_error);
    if (solver_) c2d_last_error(solver_, &why);
    throw std::runtime_error(std::string(c2d_message(status)) + ": " + why.text);
  }

private:
  c2d_memory_store store_;
  std::vector<unsigned char> memory_, blocks_;
  c2d_solver* solver_ = nullptr;
};

namespace {

int32_t next_card(void* context, char* text, int32_t size) {
  std::string card;
  if (!std::getline(*static_cast<std::ifstream*>(context), card)) return -1;
  if (!card.empty() && card.back() == '\r') card.pop_back();
  text[card.copy(text, static_cast<size_t>(size) - 1)] = '\0';
  return static_cast<int32_t>(card.size());
}

// No exception may leave a callback: this one throws none.
int32_t show_step(void*, const c2d_step* step) {
  double peak = 0.0;
  for (int32_t pair = 0; pair < step->pairs; ++pair) peak = std::max(peak, step->table[pair * step->stride + C2D_TN]);
  std::printf("mu %.4f  step %d  load %.5f  peak pressure %.10f\n", step->mu, static_cast<int>(step->step), step->load, peak);
  return 0;
}

void solve(const char* name) {
  c2d_body_limits bodies[2];
  c2d_limits limits = C2D_INIT(c2d_limits);
  limits.bodies = 2; // room for two bodies
  limits.body = bodies;
  c2d_error why = C2D_INIT(c2d_error);
  std::ifstream deck(name);
  if (c2d_scan_deck(next_card, &deck, &limits, &why) != C2D_OK) throw std::runtime_error(why.text);
  deck.clear();
  deck.seekg(0);
  Contact contact(limits, 4 << 20);
  contact.check(c2d_read_deck(contact, next_card, &deck));
  contact.check(c2d_prepare(contact));
  contact.check(c2d_run(contact, show_step, nullptr));
}

} // namespace

int main(int argc, char** argv) {
  try {
    solve(argc > 1 ? argv[1] : "examples/hertz.dat");
  } catch (const std::exception& error) {
    std::printf("%s\n", error.what());
    return 1;
  }
  return 0;
}

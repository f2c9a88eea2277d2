// The number of the mutant that is on, for this process and the programs it starts: C2D_MUTANT. C2D_MUTANTS_MET names a file
// that is kept in memory by all of them: the places met.
#include <fcntl.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <unistd.h>

#include "switch.hpp"

namespace {
unsigned char nowhere[C2D_MUTANTS_MOST];
}

extern "C" {
int c2d_mutant = -1;
unsigned char* c2d_mutant_met = nowhere;

__attribute__((constructor)) void c2d_mutant_begin() {
  const char* number = getenv("C2D_MUTANT");
  if (number) c2d_mutant = atoi(number);
  const char* name = getenv("C2D_MUTANTS_MET");
  const int file = name ? open(name, O_RDWR) : -1;
  if (file < 0) return;
  void* map = mmap(nullptr, C2D_MUTANTS_MOST, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  close(file);
  if (map != MAP_FAILED) c2d_mutant_met = static_cast<unsigned char*>(map);
}
}

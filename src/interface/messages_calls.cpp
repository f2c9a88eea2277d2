#include "solver/solver.hpp"

using namespace c2d;

extern "C" const char* c2d_message(int32_t status) { return status_text(status); }
extern "C" const char* c2d_outcome_message(int32_t outcome) { return outcome_text(outcome); }
extern "C" const char* c2d_version(void) { return "0.2.0"; }

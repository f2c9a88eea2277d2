// c2d_link_warnings.
#include "memory/parts.hpp"
#include "results/warnings/warnings.hpp"
#include "solver/judge.hpp"
#include "solver/unheld.hpp"

const c2d::WarningPart c2d::kWarningPart = {true,        warn_contact,   warn_facing_meshes, warn_not_unique,
                                            warn_breach, find_condition, warn_condition,     tell_unheld};

extern "C" void c2d_link_warnings(void) {}

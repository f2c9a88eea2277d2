#pragma once
// Is the mesh fine enough for the work of friction? What the loads do between two states and elastic energy does not take up,
// friction must have dissipated (METHOD 15). The two are compared where they can be: from one turn of the loads to the next,
// and over two such pieces, a cycle of loads that go to and fro. In a first loading elastic energy is nearly all, and its error
// says nothing about friction: compared is only where friction takes a tenth of what elastic energy gains or loses.
#include "memory/text.hpp"
#include "solver/session.hpp"

namespace c2d {

// Appends by how much they differ, if it is more than a tenth of what was dissipated. `at_end`: the path may end here, not only
// at a turn. False: nothing is to be told.
bool tell_friction_work(const Session& session, bool at_end, Text& out);

} // namespace c2d

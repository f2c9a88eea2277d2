// The curves of one entity of a DXF file.
#pragma once

#include "program/drawing/account.hpp"
#include "program/drawing/formats/dxf_groups.hpp"
#include "program/drawing/placing.hpp"

namespace drawing {

bool is_curve(std::string_view type);

// Is the plane of an entity seen from behind? Throws a Fault if it is inclined.
bool is_seen_from_behind(const Entity& e);
extern const Motion kFromBehind; // x goes to -x

// Where `motion` puts them; `corners` are the VERTEX entities of a POLYLINE. Throws a Fault that says why there are none.
std::vector<Curve> curves_of(const Entity& e, const std::vector<Entity>& corners, const Motion& motion, Account& account);

} // namespace drawing

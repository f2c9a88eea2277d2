// c2d_link_search.
#include "contact/let_go.hpp"
#include "contact/rates/search.hpp"
#include "contact/start.hpp"
#include "memory/parts.hpp"

const c2d::SearchPart c2d::kSearchPart = {true,       try_all,    decide,     place_in_range, place_body,
                                          may_rest,   rest_along, rest_again, note_idle,      slides_without_force,
                                          try_let_go, hold_again, seat};

extern "C" void c2d_link_search(void) {}

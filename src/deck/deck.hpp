#pragma once
// The card deck of the 1987 program (Appendix B of the thesis): reads all its cards, section by
// section, validates every number, counts sizes, and passes the model to a sink. It stores
// none of it, so the deck may be as large as the workspace of the sink allows.
#include "contact2d_cycle.h"
#include "deck/cards.hpp"

namespace c2d {

// Receiver of the model: the calls of section 5 of the C interface, or replacements.
// Differences from a model built by calls, due to the order of the cards:
// - set_problem is called twice: the iteration limit is on one of the last cards;
// - set_body is called twice for each body: the elastic constants follow the regions. The first call has constants
//   that are only legal (E = 1, nu = 0), the second, after the regions, those of the deck.
struct DeckSink {
  c2d_solver* solver;
  int32_t function_nodes;         // per element, for which the workspace was created; 0: any
  int32_t bodies;                 // the same, without platens
  double (*origin)[2];            // [bodies], used by the reader only: origin of the coordinates of each body
  void (*refused)(void* context); // may be null; called after every call below that returned an error
  void* context;
  decltype(&c2d_set_line) set_line = c2d_set_line;
  decltype(&c2d_set_problem) set_problem = c2d_set_problem;
  decltype(&c2d_set_body) set_body = c2d_set_body;
  decltype(&c2d_add_region) add_region = c2d_add_region;
  decltype(&c2d_set_nodes) set_nodes = c2d_set_nodes;
  decltype(&c2d_set_condition) set_condition = c2d_set_condition;
  decltype(&c2d_add_point_load) add_point_load = c2d_add_point_load;
  decltype(&c2d_add_zone) add_zone = c2d_add_zone;
  decltype(&c2d_add_friction) add_friction = c2d_add_friction;
  decltype(&c2d_set_values) set_values = c2d_set_values;
  decltype(&c2d_clear_paths) clear_paths = c2d_clear_paths;
  decltype(&c2d_set_zone_friction) set_zone_friction = c2d_set_zone_friction;
  decltype(&c2d_set_units) set_units = c2d_set_units;
  decltype(&c2d_set_interference) set_interference = c2d_set_interference;
  decltype(&c2d_add_points) add_points = c2d_add_points;
  decltype(&c2d_add_curve) add_curve = c2d_add_curve;
  decltype(&c2d_tie_zone) tie_zone = c2d_tie_zone;
  decltype(&c2d_set_name) set_name = c2d_set_name;
  c2d_status (*add_load_card)(c2d_solver*, int32_t increments, double load); // factor of case 1, all others zero
  // Like c2d_add_path, with `count` of the factors after the first `given`; `last`: the segment has no more.
  c2d_status (*add_factors)(c2d_solver*, int32_t increments, int32_t given, const double* load, int32_t count, bool last);
  // for keywords whose part of the library may not be linked: null or false
  decltype(&c2d_set_symmetry) set_symmetry;
  decltype(&c2d_set_rigid) set_rigid;
  decltype(&c2d_set_rigid_load) set_rigid_load;
  decltype(&c2d_add_platen) add_platen;
  decltype(&c2d_set_body_force) set_body_force;
  decltype(&c2d_repeat_paths) repeat_paths;
  bool has_free_zones;
};

// Set of numbers from 1 that have appeared on a card; only the first kNoted are recorded.
struct NumbersSeen {
  static constexpr int32_t kNoted = 256;
  uint32_t bits[kNoted / 32];
  // Records a number; true if it was recorded before.
  bool again(int32_t number) {
    if (number > kNoted) return false;
    uint32_t& word = bits[(number - 1) / 32];
    const uint32_t bit = uint32_t{1} << ((number - 1) % 32);
    const bool before = (word & bit) != 0;
    word |= bit;
    return before;
  }
};

// Data that later sections need from earlier ones. Bodies are counted from 0 here.
// `body` is the caller's list; until the deck ends its member `reserved` stores what body_line() and element_nodes() return.
struct Deck {
  Cards cards;
  const DeckSink* sink; // null: only checks and counts
  c2d_limits sizes;     // without the list of bodies, which is `body`
  c2d_body_limits* body;
  int32_t room; // number of bodies for which it has room
  c2d_problem problem;
  int32_t symmetry;                // lines from *SYMMETRY: 1: x, 2: y
  bool elements_continue;          // element numbers continue from body to body
  bool nodes_continue;             // node numbers continue from body to body
  int64_t elements;                // of all bodies read so far
  int64_t pairs, contact_elements; // of all zones
  int64_t self_pairs;              // of these, in self-contact
  const char* counted;             // name of the last number of cards given by a card, with its position
  int32_t counted_cards, counted_line, counted_body, zones_line;
  uint32_t keywords_seen;  // bit: index in the table of keywords.cpp
  NumbersSeen body_forces; // from *BODY FORCE: load cases of all bodies, interleaved
  NumbersSeen rigid;       // bodies of *RIGID
  NumbersSeen names;       // bodies and zones of *NAME, interleaved
};

// With at most this many elements, numbers of elements, boundary points and functional nodes fit in 32 bits.
constexpr int32_t kMostElements = INT32_MAX / 4 - 1;

// Reads a deck to its end. Every fault goes to `report` (may be null), except those of the calls of the sink, which
// reports them. Returns C2D_OK; C2D_ERR_INPUT after any fault; C2D_ERR_READ; C2D_ERR_LIMIT; or the status of the sink,
// if that is neither ARGUMENT nor INPUT. `sizes` has a list for the number of bodies in it, which is used as work space; it
// receives the sizes after C2D_OK, and only the number of bodies after C2D_ERR_LIMIT for a short list. `card` receives every
// field of every card, in order.
c2d_status read_deck_cards(const DeckSink* sink, c2d_read_line read, void* context, c2d_report report, void* report_context,
                           c2d_limits* sizes, c2d_card_fn card = nullptr, void* card_context = nullptr);

// The sections, in order. Each returns false if reading cannot continue; faults have then been reported.
bool read_heading(Deck& deck);           // control.cpp
bool read_control(Deck& deck);           //   problem type, bodies, regions
bool read_materials(Deck& deck);         //   elastic constants, friction
bool read_nodes(Deck& deck, int b);      // nodes.cpp
bool read_conditions(Deck& deck, int b); // conditions.cpp
bool read_point_loads(Deck& deck, int b);
bool read_zones(Deck& deck);      // zones.cpp: zones and the counts per body
bool read_loads(Deck& deck);      // loads.cpp: load path
void read_extensions(Deck& deck); // keywords.cpp: cards after the last load card

// ---- shared by the sections ----
// Sets the columns of the current card to which faults of the next call of the sink refer.
void place(Deck& deck, int32_t column, int32_t column_end);
// The same for all fields of a free-form card.
void place_words(Deck& deck, const Words& words);
// Records the status of a call of the sink; false if the reading must end.
bool accept(Deck& deck, c2d_status status);
// A card with the number of following cards of a kind. If their number does not match, only this is reported, at its card: the
// following cards are misread. Both return false then.
bool read_count(Deck& deck, const char* name, int32_t* value);
bool fits_count(Deck& deck, bool fits, int32_t read_so_far);
// Number of fields of the current card that begin like a number.
int32_t numbers_on(const Cards& cards);
// A sum limited to the 32 bits of c2d_limits.
int32_t bounded(int64_t size); // free_zones.cpp
// Data of the card of body b; keep_body_card stores them for the two others.
void keep_body_card(Deck& deck, int b, int32_t element_nodes);
int32_t body_line(const Deck& deck, int b);
int32_t element_nodes(const Deck& deck, int b); // NBN
int32_t open_regions(const Deck& deck, int b);  // from NBP: boundary points beyond those of closed curves
// Offset from the number of an element, boundary point or functional node within body b to that on the cards.
int32_t element_offset(const Deck& deck, int b);
int32_t point_offset(const Deck& deck, int b);
int32_t function_node_offset(const Deck& deck, int b);
// Functional nodes of body b: successive elements share a node if they have more than one.
int32_t function_node_count(const Deck& deck, int b);

} // namespace c2d

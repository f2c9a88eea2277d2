#pragma once
// The card deck of the 1987 program (Appendix B of the thesis): a walk over all its cards, section by
// section. The walk validates every number where it stands, counts sizes, and hands the model to a sink; it
// keeps none of it, so a deck may be as large as the workspace behind the sink.
#include "deck/cards.hpp"

namespace c2d {

// Where the model goes: the calls of section 5 of the C interface, unless somebody else's stand in their places.
// What differs from a model built by hand, because of the order of the cards:
// - set_problem comes twice: the iteration limit stands on one of the last cards;
// - set_body comes twice for each body: the elastic constants stand behind the regions. The first call carries constants
//   that are merely legal (E = 1, nu = 0) and the second, after the regions, those of the deck.
struct DeckSink {
  c2d_solver* solver;
  int32_t function_nodes;         // per element, as the workspace was made for; 0: any
  int32_t bodies;                 // likewise, without platens
  double (*origin)[2];            // [bodies], for the reader alone: of each body's coordinates
  void (*refused)(void* context); // may be null; told after every call below that returned an error
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
  decltype(&c2d_add_path) add_path = c2d_add_path;
  decltype(&c2d_set_zone_friction) set_zone_friction = c2d_set_zone_friction;
  decltype(&c2d_set_units) set_units = c2d_set_units;
  decltype(&c2d_set_interference) set_interference = c2d_set_interference;
  decltype(&c2d_add_points) add_points = c2d_add_points;
  decltype(&c2d_add_curve) add_curve = c2d_add_curve;
  decltype(&c2d_tie_zone) tie_zone = c2d_tie_zone;
  decltype(&c2d_set_name) set_name = c2d_set_name;
  c2d_status (*add_load_card)(c2d_solver*, int32_t increments, double load); // factor of case 1, all others zero
  // of keywords whose part of the library may be missing: null or false
  decltype(&c2d_set_symmetry) set_symmetry;
  decltype(&c2d_set_rigid) set_rigid;
  decltype(&c2d_set_rigid_load) set_rigid_load;
  decltype(&c2d_add_platen) add_platen;
  decltype(&c2d_set_body_force) set_body_force;
  bool has_free_zones;
};

// Which numbers from 1 have stood on a card already; only the first kNoted are looked after.
struct NumbersSeen {
  static constexpr int32_t kNoted = 256;
  uint32_t bits[kNoted / 32];
  // Notes it; true if it was there before.
  bool again(int32_t number) {
    if (number > kNoted) return false;
    uint32_t& word = bits[(number - 1) / 32];
    const uint32_t bit = uint32_t{1} << ((number - 1) % 32);
    const bool before = (word & bit) != 0;
    word |= bit;
    return before;
  }
};

// What later sections must know of earlier ones. Bodies are counted from 0 in here.
// `body` is the caller's list; its member `reserved` holds what body_line() and element_nodes() tell until the deck ends.
struct Deck {
  Cards cards;
  const DeckSink* sink; // null: only check and count
  c2d_limits sizes;     // without the list of bodies, which is
  c2d_body_limits* body;
  int32_t room; // bodies that it can hold
  c2d_problem problem;
  int32_t symmetry;                // lines that *SYMMETRY gave: 1: x, 2: y
  bool elements_continue;          // each body's elements are numbered on from those of the bodies before
  bool nodes_continue;             // so are its nodes
  int64_t elements;                // of all bodies whose cards were read
  int64_t pairs, contact_elements; // of all zones
  int64_t self_pairs;              // of them, of zones of a body with itself
  const char* counted;             // the last number of cards that a card gave, with its place
  int32_t counted_cards, counted_line, counted_body, zones_line;
  uint32_t keywords_seen;  // bit: place in the table of keywords.cpp
  NumbersSeen body_forces; // that *BODY FORCE gave: load cases of the first body, the second ... interleaved
  NumbersSeen rigid;       // bodies that *RIGID named
  NumbersSeen names;       // bodies and zones, interleaved, that *NAME named
};

// With so many elements in all no number of a deck's elements, boundary points and functional nodes leaves its 32 bits.
constexpr int32_t kMostElements = INT32_MAX / 4 - 1;

// Read a deck to its end. Every fault goes to `report` (may be null), those of the sink's calls excepted: the
// sink has told them. Returns C2D_OK; C2D_ERR_INPUT after any fault; C2D_ERR_READ; C2D_ERR_LIMIT; or what the sink returned,
// if that was neither ARGUMENT nor INPUT. `sizes` comes with a list for so many bodies as it says, which is worked in; it
// receives the sizes after C2D_OK, and after C2D_ERR_LIMIT for a list that is too short their number. `card` is told every
// field of every card, in order.
c2d_status read_deck_cards(const DeckSink* sink, c2d_read_line read, void* context, c2d_report report, void* report_context,
                           c2d_limits* sizes, c2d_card_fn card = nullptr, void* card_context = nullptr);

// The sections, in order. Each returns false if the deck cannot be read on; faults have then been reported.
bool read_heading(Deck& deck);           // control.cpp
bool read_control(Deck& deck);           //   problem type, bodies, regions
bool read_materials(Deck& deck);         //   elastic constants, friction
bool read_nodes(Deck& deck, int b);      // nodes.cpp
bool read_conditions(Deck& deck, int b); // conditions.cpp
bool read_point_loads(Deck& deck, int b);
bool read_zones(Deck& deck);      // zones.cpp: zones and the counts per body
bool read_loads(Deck& deck);      // loads.cpp: load path
void read_extensions(Deck& deck); // keywords.cpp: what follows the last load card

// ---- shared by the sections ----
// Faults of the sink's next call are in these columns of the card at hand.
void place(Deck& deck, int32_t column, int32_t column_end);
// The same for all fields of a free-form card.
void place_words(Deck& deck, const Words& words);
// Take note of what a call of the sink returned; false if the reading must end.
bool accept(Deck& deck, c2d_status status);
// A card that says how many cards of a kind follow. Where they do not fit their number, that alone is told, at its card: what
// follows is read as something else than it is. Both return false then.
bool read_count(Deck& deck, const char* name, int32_t* value);
bool fits_count(Deck& deck, bool fits, int32_t read_so_far);
// Fields of the card at hand that begin like a number.
int32_t numbers_on(const Cards& cards);
// Of the limits, which are 32-bit: the largest there is where a sum is beyond.
int32_t bounded(int64_t size); // free_zones.cpp
// What the card of body b said. (keep_body_card: so that the two others know.)
void keep_body_card(Deck& deck, int b, int32_t element_nodes);
int32_t body_line(const Deck& deck, int b);
int32_t element_nodes(const Deck& deck, int b); // NBN
int32_t open_regions(const Deck& deck, int b);  // NBP says how many: boundary points beyond those of closed curves
// Added to the number of an element, boundary point or functional node within body b to get that of the cards.
int32_t element_offset(const Deck& deck, int b);
int32_t point_offset(const Deck& deck, int b);
int32_t function_node_offset(const Deck& deck, int b);
// Functional nodes of body b: an element shares its last with the next one's first, if it has more than one.
int32_t function_node_count(const Deck& deck, int b);

} // namespace c2d

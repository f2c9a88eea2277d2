// ASCII MSH, of formats 2.2 and 4.1.
#pragma once

#include "program/drawing/drawing.hpp"

#include <cstdint>
#include <string_view>

namespace drawing {

bool is_msh(std::string_view text);

// An element with its nodes; a line has its ends first, a face its corners.
struct Element {
  int type;
  int line;           // of the file
  int64_t group = 0;  // physical; 0: none
  int64_t entity = 0; // elementary
  std::vector<int64_t> nodes;
};

struct Mesh {
  std::string format;
  std::vector<int64_t> tags; // of nodes, rising
  std::vector<Point> nodes;
  struct Name {
    int dimension;
    int64_t group;
    std::string name;
  };
  std::vector<Name> names;
  std::vector<Element> lines, faces;
  std::vector<std::string> notes;

  std::string name(int dimension, int64_t group) const; // empty: none
  Point at(int64_t tag) const;                          // of a node that is there
};

// Throws a Fault.
Mesh read_mesh(std::string_view text);

// The order of line elements and faces, 0 for other types; corners of a face.
int order_of(int type);
int corners_of(int type);

// Bodies of physical surfaces, and curves of line elements that bound none of them. Throws a Fault.
Drawing drawing_of(const Mesh& mesh);

} // namespace drawing

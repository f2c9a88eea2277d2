// The pairs of lines that a DXF file is made of, and entities of them.
#pragma once

#include "program/drawing/text.hpp"

namespace drawing {

struct Group {
  int code;
  std::string_view value;
  int line; // of the value
};

class Entity {
public:
  std::string_view type;
  int line = 0;
  const Group *first = nullptr, *last = nullptr; // behind its type

  bool has(int code) const { return find(code) != nullptr; }
  double number(int code, const char* what) const; // Fault if it is missing
  double number(int code, double other, const char* what) const;
  int64_t flags(int code) const; // 0 if it is missing
  Point point(int code, const char* what) const;
  std::string_view text(int code) const; // empty if it is missing
  // Every value of a group, in order.
  std::vector<double> numbers(int code, const char* what) const;
  std::vector<Point> points(int code, const char* what) const;

private:
  const Group* find(int code) const;
};

std::vector<Group> groups_of(std::string_view text);

} // namespace drawing

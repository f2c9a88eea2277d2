// A source file of this project as tokens: enough to find operators and what they act on. clang-format has set blanks around
// binary operators and none inside the brackets of templates, which tells them apart.
#pragma once

#include <string>
#include <vector>

namespace mutants {

struct Token {
  enum Kind { name, number, text, sign };
  Kind kind;
  std::string is;
  size_t from, to;    // in the source
  int line;           // from 1
  bool blank, blanks; // white space before; before and after
  int partner;        // of a bracket, those of templates included; else -1
  bool inside;        // in the body of a function that runs: no template argument, constant expression, attribute, assertion
};

std::vector<Token> tokens_of(const std::string& source);

} // namespace mutants

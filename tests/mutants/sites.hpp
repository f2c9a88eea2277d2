// Where a source file can be changed, and into what.
#pragma once

#include <string>
#include <vector>

namespace mutants {

// The part from .. to of the source becomes a choice at run time between `changed` and what stands there.
struct Site {
  size_t from, to;
  int line;
  std::string kind;    // "+ becomes -"
  std::string changed; // an expression
  std::string text;    // the line of the source, without blanks around it
  int occurrence;      // of the kind in lines of this text, from 1
  std::string shown() const;
};

std::vector<Site> sites_of(const std::string& source);

// The source with the chosen sites in it; the first has the number `first`. A line of the compiler's messages that is
// kLineOfSites or above less that is a site's number.
constexpr int kLineOfSites = 1000000;
std::string with_sites(const std::string& source, const std::vector<Site>& chosen, const std::vector<int>& numbers);

} // namespace mutants

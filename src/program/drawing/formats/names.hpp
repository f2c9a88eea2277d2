// Valid names of a sketch for the names of a drawing.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

namespace drawing {

class Names {
public:
  // The same name for the same one each time; different ones for different ones.
  std::string name(const std::string& raw);
  // An unused name: `stem` and a number.
  std::string numbered(const std::string& stem);
  // The changes, as notes.
  std::vector<std::string> changes() const;

private:
  std::map<std::string, std::string> known_;
  std::set<std::string> taken_;
  std::map<std::string, int> last_;
};

} // namespace drawing

#include "program/sweep/row_inputs.hpp"

#include <algorithm>
#include <sstream>
#include <vector>

namespace app {
namespace {

using Lines = std::vector<std::string>;

constexpr char kFromRow[] = "row = ";

bool has_start(const std::string& line, const char* start) { return line.rfind(start, 0) == 0; }
bool is_of_parameter(const std::string& line) { return has_start(line, "parameter "); }

Lines lines_in(const std::string& text) {
  Lines out;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) out.push_back(line);
  return out;
}

Lines without_parameters(Lines lines) {
  lines.erase(std::remove_if(lines.begin(), lines.end(), is_of_parameter), lines.end());
  return lines;
}

} // namespace

std::string inputs_of_rows(const std::string& there, const Inputs& inputs, size_t row) {
  Lines all = lines_in(there);
  const Lines now = lines_in(inputs_text(inputs));
  auto first = all.end(); // of the lines of the latest rows
  while (first != all.begin() && !has_start(*(first - 1), kFromRow)) --first;
  if (without_parameters(Lines(first, all.end())) != without_parameters(now)) {
    if (row > 1) all.push_back(kFromRow + std::to_string(row));
    all.insert(all.end(), now.begin(), now.end());
  } else {
    const auto differs = [&](const std::string& line) {
      return is_of_parameter(line) && std::find(now.begin(), now.end(), line) == now.end();
    };
    all.erase(std::remove_if(first, all.end(), differs), all.end());
  }
  std::string out;
  for (const std::string& line : all) out += line + "\n";
  return out;
}

} // namespace app

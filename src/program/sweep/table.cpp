#include "program/sweep/table.hpp"

#include "program/sweep/parameters.hpp"

#include <algorithm>

namespace app {
namespace {

struct Cell {
  std::string text;
  int32_t column, column_end; // from 1
};

std::vector<Cell> cells_of(const std::string& line) {
  std::vector<Cell> cells;
  for (size_t at = 0; at <= line.size();) {
    const size_t comma = std::min(line.find(',', at), line.size());
    size_t begin = at, end = comma;
    while (begin < end && (line[begin] == ' ' || line[begin] == '\t' || line[begin] == '"')) ++begin;
    while (end > begin && (line[end - 1] == ' ' || line[end - 1] == '\t' || line[end - 1] == '"')) --end;
    cells.push_back({line.substr(begin, end - begin), static_cast<int32_t>(begin) + 1, static_cast<int32_t>(end)});
    at = comma + 1;
  }
  return cells;
}

class TableReader {
public:
  TableReader(const std::set<std::string>& parameters, Messages& messages) : parameters_(parameters), messages_(messages) {}
  void heading(const std::vector<Cell>& cells, int32_t line, SweepTable& table);
  void row(const std::vector<Cell>& cells, int32_t line, SweepTable& table);
  void fault(int32_t line, const Cell& cell, const std::string& text);
  bool sound() const { return sound_; }

private:
  const std::set<std::string>& parameters_;
  Messages& messages_;
  bool sound_ = true;
};

void TableReader::fault(int32_t line, const Cell& cell, const std::string& text) {
  const c2d_error entry = fault_in(line, cell.column, cell.column_end, text);
  Messages::log(&messages_, &entry);
  sound_ = false;
}

void TableReader::heading(const std::vector<Cell>& cells, int32_t line, SweepTable& table) {
  Setting setting;
  for (const Cell& cell : cells) {
    if (!read_setting(cell.text + "=0", setting))
      fault(line, cell, "'" + cell.text + "': expected the name of a parameter");
    else if (std::count(table.names.begin(), table.names.end(), cell.text) > 0)
      fault(line, cell, cell.text + " is the name of two columns");
    else if (parameters_.count(cell.text) == 0)
      fault(line, cell, "no parameter " + cell.text + offer_parameters(cell.text, parameters_));
    table.names.push_back(cell.text);
  }
}

void TableReader::row(const std::vector<Cell>& cells, int32_t line, SweepTable& table) {
  if (cells.size() != table.names.size())
    return fault(line, cells.back(), std::to_string(cells.size()) + " values, expected " + std::to_string(table.names.size()));
  table.rows.emplace_back();
  Setting setting;
  for (const Cell& cell : cells) {
    if (!read_setting("a=" + cell.text, setting)) fault(line, cell, "'" + cell.text + "': expected a value without blanks");
    table.rows.back().push_back(cell.text);
  }
}

} // namespace

bool read_table(const DeckFile& file, const std::set<std::string>& parameters, Messages& messages, SweepTable& table) {
  TableReader reader(parameters, messages);
  for (size_t i = 1; i <= file.cards(); ++i) {
    std::string line(file.card(i));
    if (i == 1 && line.compare(0, 3, "\xef\xbb\xbf") == 0) line.erase(0, 3); // a byte order mark
    if (line.find_first_not_of(" \t,") == std::string::npos) continue;
    if (table.names.empty())
      reader.heading(cells_of(line), static_cast<int32_t>(i), table);
    else
      reader.row(cells_of(line), static_cast<int32_t>(i), table);
  }
  if (reader.sound() && table.rows.empty())
    messages.fail("no rows, expected a heading with names of parameters and one row for each run");
  return reader.sound() && !table.rows.empty();
}

} // namespace app

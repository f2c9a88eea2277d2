// compare A.csv B.csv TOLERANCE: two tables of contact results, of A as many columns as B has. Rows, statuses and all
// integers must agree, every other number within TOLERANCE times the largest of its column over the whole table. Prints
// the largest difference by column.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace {

using Row = std::vector<std::string>;

std::vector<Row> table(const char* name) {
  std::vector<Row> rows;
  std::ifstream file(name);
  for (std::string line, cell; std::getline(file, line);) {
    Row row;
    for (std::istringstream cells(line); std::getline(cells, cell, ',');) row.push_back(cell);
    rows.push_back(row);
  }
  return rows;
}

// Quantities of one kind are measured alike: tractions, displacements.
const std::vector<std::vector<std::string>> kKinds = {{"tn", "tt"}, {"un1", "ut1", "un2", "ut2", "gap", "slip"}, {"x", "y"}};

struct Column {
  double largest = 0.0, difference = 0.0;
  bool words = false;
};

} // namespace

int main(int count, char** argument) {
  if (count != 4) return 64;
  std::vector<Row> a = table(argument[1]);
  const std::vector<Row> b = table(argument[2]);
  for (Row& row : a) // of a program with more columns behind those
    if (!b.empty() && row.size() > b[0].size()) row.resize(b[0].size());
  const double tolerance = std::atof(argument[3]);
  if (a.size() < 2 || a.size() != b.size() || a[0] != b[0]) {
    std::printf("%s has %zu rows, %s %zu, or their headers differ\n", argument[1], a.size(), argument[2], b.size());
    return 1;
  }
  std::vector<Column> columns(a[0].size());
  size_t words = 0;
  for (size_t i = 1; i < a.size(); ++i)
    for (size_t c = 0; c < columns.size(); ++c) {
      if (c >= a[i].size() || c >= b[i].size()) return std::printf("row %zu is short\n", i), 1;
      char *end_a, *end_b;
      const double x = std::strtod(a[i][c].c_str(), &end_a), y = std::strtod(b[i][c].c_str(), &end_b);
      if (*end_a != '\0' || *end_b != '\0') {
        words += a[i][c] != b[i][c];
        columns[c].words = true;
        continue;
      }
      columns[c].largest = std::max(columns[c].largest, std::fabs(x));
      const double difference = std::fabs(x - y);
      if (!(difference <= columns[c].difference)) columns[c].difference = difference;
    }
  for (const std::vector<std::string>& kind : kKinds) {
    double largest = 0.0;
    for (size_t c = 0; c < columns.size(); ++c)
      if (std::find(kind.begin(), kind.end(), a[0][c]) != kind.end()) largest = std::max(largest, columns[c].largest);
    for (size_t c = 0; c < columns.size(); ++c)
      if (std::find(kind.begin(), kind.end(), a[0][c]) != kind.end()) columns[c].largest = largest;
  }
  bool good = words == 0;
  std::printf("  %zu rows, %zu statuses differ; difference over the largest of its kind:", a.size() - 1, words);
  for (size_t c = 0; c < columns.size(); ++c) {
    if (columns[c].words) continue;
    const double relative = columns[c].largest > 0.0 ? columns[c].difference / columns[c].largest : columns[c].difference;
    good = good && relative <= tolerance;
    if (columns[c].difference != 0.0) std::printf(" %s %.1e", a[0][c].c_str(), relative);
  }
  std::printf("; allowed %.0e: %s\n", tolerance, good ? "agrees" : "DIFFERS");
  return good ? 0 : 1;
}

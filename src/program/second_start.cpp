#include "program/second_start.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

std::string lower_case_of(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

// Pressures and friction, relative to the largest pressure of both.
double difference(const std::vector<double>& table, const std::vector<double>& tractions) {
  double most = 0, largest = 0;
  for (size_t p = 0; 2 * p < tractions.size() && p * C2D_PAIR_FIELDS < table.size(); ++p) {
    const double* row = table.data() + p * C2D_PAIR_FIELDS;
    largest = std::max({largest, row[C2D_TN], tractions[2 * p]});
    most = std::max({most, std::fabs(row[C2D_TN] - tractions[2 * p]), std::fabs(row[C2D_TT] - tractions[2 * p + 1])});
  }
  return largest > 0 ? most / largest : 0.0;
}

} // namespace

std::string with_other_start(const std::string& deck) {
  const std::string word = "compare", text = lower_case_of(deck);
  for (size_t line = 0; line < text.size();) {
    const size_t end = std::min(text.find('\n', line), text.size()), at = text.find(word, line);
    const size_t first = text.find_first_not_of(" \t", line), comment = std::min(text.find('!', line), end);
    if (text.compare(first, 5, "cycle") == 0 && at < comment)
      return deck.substr(0, at) + "frictionless" + deck.substr(at + word.size());
    line = end + 1;
  }
  return deck;
}

void compare_starts(const std::string& deck, int32_t digits, const estimate::Demand& demand, RunRecord& record) {
  constexpr double kSteadyStates = 1e3, kLeast = 1e-7; // what two steady states may differ by, over the change of a cycle
  std::vector<estimate::EndOfCycles> ends;
  std::string why;
  estimate::follow_cycles(with_other_start(deck), demand, ends, why);
  for (size_t i = 0; i < record.coefficients.size(); ++i) {
    CoefficientRecord& c = record.coefficients[i];
    if (c.cycles.empty() || c.outcome != C2D_REACHED) continue;
    OtherStart other;
    const auto end = std::find_if(ends.begin(), ends.end(), [i](const estimate::EndOfCycles& e) {
      return e.coefficient == static_cast<int32_t>(i) + 1 && !e.tractions.empty();
    });
    if (end != ends.end()) {
      other.last = end->last;
      other.apart = difference(c.table, end->tractions);
      other.same = other.last.result != C2D_CYCLE_NOT_STEADY && c.cycles.back().result != C2D_CYCLE_NOT_STEADY &&
                   other.apart <= std::max(kLeast, kSteadyStates * std::pow(10.0, -digits));
    } else {
      other.why = why.empty() ? "its path ends before the last load" : why;
    }
    c.other_start.assign(1, other);
  }
}

} // namespace app

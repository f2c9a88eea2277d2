// Requested numbers of a run: --response "max tn; contact edge 1; stress 3".
#pragma once

#include "report/interior.hpp"
#include "report/record.hpp"

#include <string>
#include <vector>

namespace app {

// One number of the last recorded state of the last coefficient of friction.
struct Response {
  enum class Of { kPairs, kQuantity, kPoint, kCount, kLoad, kTolerance, kWanted };
  std::string words; // as it is called in tables
  Of of = Of::kLoad;
  int32_t which = 0; // kPairs: a column of the pairs' table; kQuantity: a Measure; kPoint: C2D_POINT_...; kCount: a status, -1:
                     // all that touch
  bool least = false;                                             // kPairs: the smallest instead of the largest
  bool size = false;                                              // kPairs: of its absolute value
  enum class Part { kValue, kX, kY, kAlong } part = Part::kValue; // kQuantity: the number, or where its place is
  int32_t zone = 0;                                               // 0: all
  enum class Effect { kDerivative, kShare, kWorstCase, kRootOfSquares } effect = Effect::kDerivative; // kTolerance: which,
  std::string number, by; // of what, by what; kWanted: all words
  int32_t item = 0;       // kQuantity: which of several; kPoint: which point; 0: the only one
};

// Reads a list with semicolons. False with an error text.
bool read_responses(const std::string& text, std::vector<Response>& responses, std::string& error);

// Description of the words for --help and pages.
extern const char kResponseWords[];

// NaN: the state has no such number.
double evaluate(const Response& response, const RunRecord& record);

// "name value" and a line each.
std::string results_text(const std::vector<Response>& responses, const std::vector<double>& values);
// The first line of the file of a failed run: FAIL and the reason.
std::string failure_text(const std::string& why);

// A field of a CSV file, in quotes where it has to be.
std::string csv_field(const std::string& text);
std::string csv_number(double value); // empty where there is none

} // namespace app

#include "program/sweep/tolerance_response.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

using Effect = Response::Effect;

struct EffectWords {
  std::vector<std::string> words;
  Effect effect;
  bool by; // of one parameter
};
const EffectWords* find_effect(const std::vector<std::string>& words) {
  static const std::vector<EffectWords> kEffects = {{{"derivative"}, Effect::kDerivative, true},
                                                    {{"share"}, Effect::kShare, true},
                                                    {{"worst", "case"}, Effect::kWorstCase, false},
                                                    {{"root", "of", "squares"}, Effect::kRootOfSquares, false}};
  for (const EffectWords& e : kEffects)
    if (words.size() > e.words.size() && std::equal(e.words.begin(), e.words.end(), words.begin())) return &e;
  return nullptr;
}

double effect_of(const Response& r, const ToleranceTable& table, const Toleranced& t) {
  if (r.effect == Effect::kWorstCase) return table.worst_case(t);
  if (r.effect == Effect::kRootOfSquares) return table.root_of_squares(t);
  for (size_t p = 0; p < t.by.size(); ++p)
    if (table.parameters[p].name == r.by) return r.effect == Effect::kShare ? table.share(t, p) : t.by[p].derivative;
  return NAN;
}

} // namespace

bool take_tolerance_words(std::vector<std::string>& words, Response& r) {
  const EffectWords* const e = find_effect(words);
  if (e == nullptr) return false;
  const bool has_by = words.size() > e->words.size() + 2 && words[words.size() - 2] == "by";
  if (e->by != has_by) return false;
  r.of = Response::Of::kTolerance, r.effect = e->effect;
  if (has_by) r.by = words.back(), words.resize(words.size() - 2);
  words.erase(words.begin(), words.begin() + static_cast<std::ptrdiff_t>(e->words.size()));
  return true;
}

double of_tolerances(const Response& r, const ToleranceTable& table) {
  const std::string with_item =
      r.number + " " + std::to_string(r.item); // a depth at the end of a name: "SWT of top at depth 1"
  for (const Toleranced& t : table.numbers) {
    if (t.number.name() == with_item) return effect_of(r, table, t);
    const bool zone = r.zone == 0 || t.number.zone == r.zone, item = r.item == 0 ? t.number.item <= 1 : t.number.item == r.item;
    if (zone && item && t.number.name() == r.number) return effect_of(r, table, t);
  }
  return NAN;
}

std::vector<std::string> tolerance_words() { return {"derivative", "share", "worst", "case", "root", "of", "squares", "by"}; }

} // namespace app

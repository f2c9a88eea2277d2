#include "resumed.hpp"

#include "../dice.hpp"
#include "../interrupted.hpp"
#include "deck_text.hpp"
#include "generator.hpp"
#include "three_bodies.hpp"

namespace random_decks {

namespace {

constexpr size_t kPlaces = 5;
constexpr uint64_t kCompressedBytes = 64 << 20;

interrupted::Job drawn_job(uint64_t seed, Dice& dice, std::string& title) {
  if (dice.whole(0, 2) == 0) {
    const interrupted::Job three = interrupted::job_of(generate_three(seed, title));
    return dice.chance(0.5) ? three : interrupted::also_with(dice.between(0, 1), three);
  }
  const int kind = dice.whole(0, 3);
  const Model model = kind == 0   ? generate_few_pairs(seed)
                      : kind == 1 ? generate_lifted(seed)
                      : kind == 2 ? generate_symmetric(seed)
                                  : generate(seed);
  title = model.title;
  return interrupted::job_of(deck_of(model.problem, model.title));
}

} // namespace

Verdict judge_resumed(uint64_t seed) {
  Verdict out;
  Dice dice(seed ^ 0x5A5A5A5A5A5Au);
  interrupted::Job job = drawn_job(seed, dice, out.title);
  if (dice.chance(0.3)) job.in_core = false;
  if (dice.chance(0.2)) job.options.stepping = C2D_STEPPING_DECK;
  if (dice.chance(0.2)) job.options.elimination = C2D_ELIMINATION_COMPRESSED, job.bytes = kCompressedBytes;
  const interrupted::Verdict v = interrupted::end_and_resume(job, kPlaces);
  out.status = v.status;
  if (v.status != C2D_OK && v.status != C2D_ERR_INPUT) out.findings.push_back("not run: " + v.messages);
  if (!v.difference.empty()) out.findings.push_back("resumed: " + v.difference);
  return out;
}

} // namespace random_decks

// make chapter9: figures 36 to 41 of the dissertation of 1987, and what event following makes of them.
//   chapter9 FOLDER
// writes a deck per curve, curves.csv and chapter9.svg into the folder, which exists, and prints a table.
#include "figures.hpp"

#include <cstdio>
#include <deque>
#include <fstream>

using namespace chapter9;

namespace {

using Settings = std::vector<std::string>;
struct Curve {
  std::string name;
  Stepping stepping;
  int increments;
  Run run;
};

class Study {
public:
  explicit Study(const std::string& folder) : folder_(folder), table_(folder + "/curves.csv") {
    table_ << "curve,x_over_a,pressure_over_p0,friction_over_p0,continuum_adhesion\n";
  }
  // Solves one deck and keeps it; a deck that cannot be solved ends the study.
  const Run& add(const std::string& name, const Settings& settings, Stepping stepping,
                 const LoadCards& cards) {
    const std::string deck = make_deck(settings, cards);
    std::ofstream(folder_ + "/" + name + ".dat") << deck;
    curves_.push_back({name, stepping, count_of(cards), follow(deck, stepping)});
    const Run& run = curves_.back().run;
    good_ = good_ && run.error.empty();
    if (!run.error.empty()) std::fprintf(stderr, "chapter9: %s: %s\n", name.c_str(), run.error.c_str());
    char line[128];
    for (const Node& node : run.nodes) {
      std::snprintf(line, sizeof line, ",%.6f,%.6f,%.6f,%.6f\n", node.x, node.pressure, node.friction,
                    continuum.friction(node.x));
      table_ << name << line;
    }
    return run;
  }
  const Run& events(const std::string& name, const Settings& settings) {
    return add(name, settings, Stepping::kEvents, equal(1));
  }
  const Run& stepped(const std::string& name, const Settings& settings, const LoadCards& cards) {
    return add(name, settings, Stepping::kIncrements, cards);
  }
  // The last curve against event following on its mesh, and against the continuum if it is one of adhesion.
  Difference print(const Run& exact, bool adhesion = true) const {
    const Curve& c = curves_.back();
    const Difference d = compare(c.run, exact);
    std::printf("%-22s %-10s %6d  %8.3f %8.3f", c.name.c_str(),
                c.stepping == Stepping::kEvents ? "events" : "increments", c.increments, 100 * d.rms,
                100 * d.largest);
    if (adhesion) {
      const Difference limit = compare(c.run, continuum);
      std::printf("  %8.3f %8.3f", 100 * limit.rms, 100 * limit.largest);
    }
    std::printf("%s\n", c.run.by_events ? "  *" : "");
    return d;
  }
  bool finish(const std::string& sheet) {
    std::ofstream picture(folder_ + "/chapter9.svg");
    picture << sheet;
    picture.close();
    table_.close();
    return good_ && picture && table_;
  }
  bool good() const { return good_; }
  const Adhesion continuum{0.3};

private:
  std::string folder_;
  std::ofstream table_;
  std::deque<Curve> curves_; // runs stay where they are
  bool good_ = true;
};

void print_head() {
  std::printf(
      "Friction under a cylinder that adheres to a half plane; 14 linear elements over a, as in 1987.\n"
      "Differences in per cent of the largest friction, for x within %.2f of the contact.\n\n"
      "                                             from events         from the continuum\n"
      "%-22s %-10s %6s  %8s %8s  %8s %8s\n",
      kInside, "curve", "followed", "steps", "rms", "largest", "rms", "largest");
}

Settings with(Settings settings, const std::string& more) {
  settings.push_back(more);
  return settings;
}

const Settings kAdhesion = {"mu=inf", "n=15", "edge=0"}, kFriction = {"mu=0.4", "n=15", "edge=0"};

// The figures in their order; each may use curves of those before it.
class Sheet {
public:
  explicit Sheet(const std::string& folder) : study_(folder) {}
  bool draw() {
    print_head();
    exact_ = &study_.events("events", kAdhesion);
    study_.print(*exact_);
    if (!study_.good()) return false;
    equal_increments();
    coarse_at_first();
    pair_after_pair();
    sizes_of_elements();
    with_slip();
    quadratic_elements();
    std::printf("\n* an increment had no solution and was finished by following events\n");
    return study_.finish(draw_sheet(panels_, study_.continuum, convergence_));
  }

private:
  void equal_increments() { // figures 36, 37
    Convergence falling{"equal increments", {}, {}, Look::kFirst};
    std::vector<const Run*> equals;
    for (const int count : {25, 50, 100, 200, 400, 800, 1600, 3200}) {
      equals.push_back(&study_.stepped("equal_" + std::to_string(count), kAdhesion, equal(count)));
      falling.increments.push_back(count);
      falling.difference.push_back(study_.print(*exact_).rms);
    }
    equal_200_ = equals[3];
    panels_.push_back({"Figure 36: 25, 50 and 200 equal increments",
                       {{"25", equals[0], Look::kFirst},
                        {"50", equals[1], Look::kSecond},
                        {"200", equal_200_, Look::kThird},
                        {"events", exact_, Look::kEvents}},
                       Against::kContinuum});
    panels_.push_back({"Figure 37: 100 and 200 equal increments",
                       {{"100", equals[2], Look::kFirst},
                        {"200", equal_200_, Look::kThird},
                        {"events", exact_, Look::kEvents}},
                       Against::kContinuum});
    convergence_.push_back(falling);
  }
  void coarse_at_first() { // figure 38
    const Run& first_coarse = study_.stepped("first_coarse", kAdhesion, {{4, 0.16}, {168, 1.0}});
    study_.print(*exact_);
    panels_.push_back({"Figure 38: the first 16 % of the load in 4 increments",
                       {{"4 and 168", &first_coarse, Look::kFirst},
                        {"200 equal", equal_200_, Look::kThird},
                        {"events", exact_, Look::kEvents}},
                       Against::kContinuum});
  }
  void pair_after_pair() { // figure 39
    Convergence falling{"pair by pair, divided", {}, {}, Look::kSecond};
    const LoadCards cards = pair_by_pair(kAdhesion, exact_->touching);
    std::vector<const Run*> runs;
    for (const int parts : {1, 2, 4, 8, 16, 32, 64}) {
      const LoadCards all = divided(cards, parts);
      runs.push_back(&study_.stepped("pairs_" + std::to_string(parts), kAdhesion, all));
      falling.increments.push_back(count_of(all));
      falling.difference.push_back(study_.print(*exact_).rms);
    }
    panels_.push_back({"Figure 39: each increment brings one pair into contact",
                       {{"as they are", runs[0], Look::kFirst},
                        {"halved", runs[1], Look::kSecond},
                        {"quartered", runs[2], Look::kThird},
                        {"events", exact_, Look::kEvents}},
                       Against::kContinuum});
    convergence_.push_back(falling);
  }
  void sizes_of_elements() { // figure 40
    Panel sizes{"The same sizes, event following", {}, Against::kDifference};
    const Look looks[] = {Look::kEvents, Look::kFirst, Look::kThird};
    const char* const names[] = {"equal", "jump", "gradual"};
    Panel sizes_200{"Figure 40: sizes of elements, 200 equal increments", {}, Against::kDifference};
    for (int i = 0; i < 3; ++i) {
      const Settings mesh = with(kAdhesion, std::string("sizes=") + names[i]);
      const Run& by_events = study_.events(std::string("sizes_") + names[i] + "_events", mesh);
      study_.print(by_events);
      const Run& by_200 = study_.stepped(std::string("sizes_") + names[i] + "_200", mesh, equal(200));
      study_.print(by_events);
      const std::string name = std::string(names[i]) + (i == 1 ? " 2.5 : 1 at 0.71" : "");
      sizes.series.push_back({name, &by_events, looks[i]});
      sizes_200.series.push_back({name, &by_200, looks[i]});
    }
    panels_.push_back(sizes_200);
    panels_.push_back(sizes);
  }
  void with_slip() { // figure 41
    const Run& slipping = study_.events("mu_0.4_events", kFriction);
    study_.print(slipping, false);
    const Run& slipping_20 = study_.stepped("mu_0.4_equal_20", kFriction, equal(20));
    study_.print(slipping, false);
    const Run& slipping_pairs =
        study_.stepped("mu_0.4_pairs", kFriction, pair_by_pair(kFriction, slipping.touching));
    study_.print(slipping, false);
    panels_.push_back({"Figure 41: friction coefficient 0.4 and adhesion",
                       {{"0.4: 20 equal", &slipping_20, Look::kFirst},
                        {"0.4: pair by pair", &slipping_pairs, Look::kSecond},
                        {"events, both", &slipping, Look::kEvents},
                        {"adhesion: 200 equal", equal_200_, Look::kThird},
                        {"", exact_, Look::kEvents}},
                       Against::kNothing});
  }
  void quadratic_elements() {
    const Run& quadratic = study_.events("quadratic_events", {"mu=inf", "n=8", "edge=0", "order=2"});
    study_.print(quadratic);
    panels_.push_back(
        {"Beyond 1987: quadratic elements, events",
         {{"7 quadratic elements", &quadratic, Look::kFirst}, {"14 linear elements", exact_, Look::kEvents}},
         Against::kDifference});
  }

  Study study_;
  const Run *exact_ = nullptr, *equal_200_ = nullptr;
  std::vector<Panel> panels_;
  std::vector<Convergence> convergence_;
};

} // namespace

int main(int count, char** words) {
  if (count != 2) {
    std::fprintf(stderr, "usage: chapter9 FOLDER\n");
    return 64;
  }
  if (Sheet(words[1]).draw()) return 0;
  std::fprintf(stderr, "chapter9: not all of it could be done or written\n");
  return 1;
}

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

bool run_study(const std::string& folder) {
  Study study(folder);
  const Settings adhesion = {"mu=inf", "n=15", "edge=0"}, friction = {"mu=0.4", "n=15", "edge=0"};
  std::vector<Panel> panels;
  print_head();

  const Run& exact = study.events("events", adhesion);
  study.print(exact);
  if (!study.good()) return false;
  Convergence equal_ones{"equal increments", {}, {}, Look::kFirst},
      pairs{"pair by pair, divided", {}, {}, Look::kSecond};
  std::vector<const Run*> equals;
  for (const int count : {25, 50, 100, 200, 400, 800, 1600, 3200}) {
    equals.push_back(&study.stepped("equal_" + std::to_string(count), adhesion, equal(count)));
    equal_ones.increments.push_back(count);
    equal_ones.difference.push_back(study.print(exact).rms);
  }
  panels.push_back({"Figure 36: 25, 50 and 200 equal increments",
                    {{"25", equals[0], Look::kFirst},
                     {"50", equals[1], Look::kSecond},
                     {"200", equals[3], Look::kThird},
                     {"events", &exact, Look::kEvents}},
                    Against::kContinuum});
  panels.push_back({"Figure 37: 100 and 200 equal increments",
                    {{"100", equals[2], Look::kFirst},
                     {"200", equals[3], Look::kThird},
                     {"events", &exact, Look::kEvents}},
                    Against::kContinuum});

  const Run& first_coarse = study.stepped("first_coarse", adhesion, {{4, 0.16}, {168, 1.0}});
  study.print(exact);
  panels.push_back({"Figure 38: the first 16 % of the load in 4 increments",
                    {{"4 and 168", &first_coarse, Look::kFirst},
                     {"200 equal", equals[3], Look::kThird},
                     {"events", &exact, Look::kEvents}},
                    Against::kContinuum});

  const LoadCards cards = pair_by_pair(adhesion, exact.touching);
  std::vector<const Run*> runs;
  for (const int parts : {1, 2, 4, 8, 16, 32, 64}) {
    const LoadCards all = divided(cards, parts);
    runs.push_back(&study.stepped("pairs_" + std::to_string(parts), adhesion, all));
    pairs.increments.push_back(count_of(all));
    pairs.difference.push_back(study.print(exact).rms);
  }
  panels.push_back({"Figure 39: each increment brings one pair into contact",
                    {{"as they are", runs[0], Look::kFirst},
                     {"halved", runs[1], Look::kSecond},
                     {"quartered", runs[2], Look::kThird},
                     {"events", &exact, Look::kEvents}},
                    Against::kContinuum});

  Panel sizes{"The same sizes, event following", {}, Against::kDifference};
  const Look looks[] = {Look::kEvents, Look::kFirst, Look::kThird};
  const char* const names[] = {"equal", "jump", "gradual"};
  Panel sizes_200{"Figure 40: sizes of elements, 200 equal increments", {}, Against::kDifference};
  for (int i = 0; i < 3; ++i) {
    const Settings mesh = with(adhesion, std::string("sizes=") + names[i]);
    const Run& by_events = study.events(std::string("sizes_") + names[i] + "_events", mesh);
    study.print(by_events);
    const Run& by_200 = study.stepped(std::string("sizes_") + names[i] + "_200", mesh, equal(200));
    study.print(by_events);
    const std::string name = std::string(names[i]) + (i == 1 ? " 2.5 : 1 at 0.71" : "");
    sizes.series.push_back({name, &by_events, looks[i]});
    sizes_200.series.push_back({name, &by_200, looks[i]});
  }
  panels.push_back(sizes_200);
  panels.push_back(sizes);

  const Run& slipping = study.events("mu_0.4_events", friction);
  study.print(slipping, false);
  const Run& slipping_20 = study.stepped("mu_0.4_equal_20", friction, equal(20));
  study.print(slipping, false);
  const Run& slipping_pairs =
      study.stepped("mu_0.4_pairs", friction, pair_by_pair(friction, slipping.touching));
  study.print(slipping, false);
  panels.push_back({"Figure 41: friction coefficient 0.4 and adhesion",
                    {{"0.4: 20 equal", &slipping_20, Look::kFirst},
                     {"0.4: pair by pair", &slipping_pairs, Look::kSecond},
                     {"events, both", &slipping, Look::kEvents},
                     {"adhesion: 200 equal", equals[3], Look::kThird},
                     {"", &exact, Look::kEvents}},
                    Against::kNothing});

  const Run& quadratic = study.events("quadratic_events", {"mu=inf", "n=8", "edge=0", "order=2"});
  study.print(quadratic);
  panels.push_back(
      {"Beyond 1987: quadratic elements, events",
       {{"7 quadratic elements", &quadratic, Look::kFirst}, {"14 linear elements", &exact, Look::kEvents}},
       Against::kDifference});
  std::printf("\n* an increment had no solution and was finished by following events\n");
  return study.finish(draw_sheet(panels, study.continuum, {equal_ones, pairs}));
}

} // namespace

int main(int count, char** words) {
  if (count != 2) {
    std::fprintf(stderr, "usage: chapter9 FOLDER\n");
    return 64;
  }
  if (run_study(words[1])) return 0;
  std::fprintf(stderr, "chapter9: not all of it could be done or written\n");
  return 1;
}

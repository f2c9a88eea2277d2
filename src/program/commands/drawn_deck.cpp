#include "program/commands/drawn_deck.hpp"

#include "program/estimate/fatigue.hpp"
#include "program/estimate/positions.hpp"
#include "program/estimate/tolerances.hpp"
#include "program/estimate/torsion.hpp"
#include "program/estimate/wanted.hpp"
#include "program/exit_code.hpp"
#include "program/files/sha256.hpp"
#include "program/files/system_file.hpp"
#include "program/interrupt.hpp"
#include "program/messages.hpp"
#include "program/progress.hpp"
#include "program/sketch/mesh.hpp"
#include "program/sketch/read/read.hpp"
#include "program/sketch/read/words.hpp"
#include "program/sweep/parameters.hpp"
#include "program/words/read_number.hpp"
#include "program/words/voice.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace app {
namespace {

void print(const DeckFile& deck, const sketch::Fault& fault) {
  say(quote(deck, fault_in(fault.at.line, fault.at.column, fault.at.end, fault.text), "error"));
}

// Values of parameters on the command line, and their tolerances.
struct Given {
  sketch::Parameters values, tolerances;
};

// "0.01", or "1%" of a value.
bool read_tolerance(std::string_view text, double of, double& size) {
  const bool percent = !text.empty() && text.back() == '%';
  if (percent) text.remove_suffix(1);
  const bool is_read = read_number(text, size) && size >= 0 && std::isfinite(size) && std::isfinite(of);
  if (percent) size *= std::fabs(of) / 100;
  return is_read;
}

std::string expected_tolerance(const std::string& word) {
  return word.find("+-") == std::string::npos ? "" : ", or a number, +- and a tolerance not below 0, in percent or not";
}

// "R=50" or "R=50+-0.01".
bool read_given(const std::string& word, Given& given) {
  const size_t equals = word.find('=');
  if (equals == std::string::npos || equals == 0) return false;
  const std::string name = word.substr(0, equals);
  const std::string_view text = std::string_view(word).substr(equals + 1);
  const size_t mark = text.find("+-");
  double value = 0;
  if (!read_number(text.substr(0, mark), value) || std::isnan(value)) return false;
  given.values[name] = value;
  return mark == std::string_view::npos || read_tolerance(text.substr(mark + 2), value, given.tolerances[name]);
}

// File names in a sketch are relative to the folder of the sketch.
std::string beside(const std::string& sketch, const std::string& name) {
  return name.empty() || is_absolute(name) ? name : sketch.substr(0, begin_of_name(sketch)) + name;
}

bool find_text(const std::vector<NamedText>& files, const std::string& name, std::string& text) {
  for (const NamedText& file : files)
    if (file.name == name) return text = file.text, true;
  return false;
}

// Numbers of one kind and zone whose errors are too large: how many, and the one with the largest error.
struct Misses {
  const Stated* worst;
  size_t count;
};

bool is_worse(const Stated& a, const Stated& b) {
  const double error = a.relative_error(), other = b.relative_error();
  return std::isnan(error) ? !std::isnan(other) : error > other;
}

std::vector<Misses> misses_of(const MeshLoop& loop) {
  std::vector<Misses> out;
  for (const Stated& s : loop.stated) {
    if (s.is_met()) continue;
    const auto same = std::find_if(out.begin(), out.end(), [&](const Misses& m) {
      return m.worst->what == s.what && m.worst->of == s.of && m.worst->zone == s.zone && m.worst->body == s.body;
    });
    if (same == out.end()) {
      out.push_back({&s, 1});
      continue;
    }
    ++same->count;
    if (is_worse(s, *same->worst)) same->worst = &s;
  }
  return out;
}

// Prints the results whose tolerances were not met.
void print_misses(const DeckFile& deck, const MeshLoop& loop) {
  if (loop.stopped.empty()) return;
  const Messages messages(deck);
  if (loop.stated.empty()) messages.note("no errors are stated: " + loop.stopped);
  for (const Misses& m : misses_of(loop)) {
    const Stated& s = *m.worst;
    std::string text = s.name();
    if (m.count == 1 && s.item > 0) text += " " + std::to_string(s.item);
    if (s.zone > 0) text += " of zone " + std::to_string(s.zone);
    if (m.count > 1) text += ", " + std::to_string(m.count) + " of them, the worst";
    char numbers[120];
    if (std::isfinite(s.at[0]) && std::isfinite(s.at[1])) {
      std::snprintf(numbers, sizeof numbers, " at (%.6g, %.6g)", s.at[0], s.at[1]);
      text += numbers;
    }
    text += ": its error is ";
    std::snprintf(numbers, sizeof numbers, "about %.2g %%", 100 * s.relative_error());
    text += std::isnan(s.relative_error()) ? "unknown" : numbers;
    std::snprintf(numbers, sizeof numbers, ", the tolerance is %.2g %%", 100 * s.tolerance);
    messages.note(text + numbers + ", " + loop.stopped);
  }
}

void show(const MeshRound& round, size_t number) {
  std::fprintf(stderr, "contact2d: mesh %zu: %d elements, %d pairs, %.2g s", number, round.elements, round.pairs,
               round.seconds);
  if (!std::isnan(round.pressure)) std::fprintf(stderr, ", tractions changed by %.2g %%", 100 * round.pressure);
  std::fputc('\n', stderr);
}

// A valid sketch and what it was read from.
struct Drawn {
  const sketch::Sketch& sketch;
  const std::string text;
  const Given& given;
  const std::vector<NamedText>& files;
  estimate::Redraw redraw(const std::string& name) const; // `name` of the sketch
};

// Reads the sketch again, from the same files.
estimate::Redraw Drawn::redraw(const std::string& name) const {
  return [this, name](const sketch::Parameters& changed) {
    sketch::Parameters values = given.values;
    for (const auto& [parameter, value] : changed) values[parameter] = value;
    return sketch::read_sketch(text, values, [&](const std::string& file, std::string& content) {
      return find_text(files, beside(name, file), content);
    });
  };
}

// Can the sketch be drawn with its parameters changed? Throws a sketch::Fault at a tolerance with which it cannot.
void check_tolerances(const Drawn& drawn, const std::string& name) {
  for (const sketch::Tolerance& t : drawn.sketch.tolerances)
    for (const double step : {estimate::first_step(t), -estimate::first_step(t)}) {
      const sketch::Reading reading = drawn.redraw(name)({{t.parameter, t.value + step}});
      if (reading.faults.empty()) continue;
      const sketch::Fault& f = reading.faults.front();
      throw sketch::Fault{t.at, "the tolerance of " + t.parameter + " cannot be used: with the value " +
                                    sketch::rounded(t.value + step) +
                                    (f.at.line > 0 ? ", line " + std::to_string(f.at.line) : "") + ": " + f.text};
    }
}

// Derivatives by the parameters with tolerances, on the mesh of the results.
void add_tolerances(const Drawn& drawn, const DeckFile& deck, const estimate::Nominal& at, estimate::Demand demand,
                    estimate::TrialKeeper* keeper, MeshLoop& loop) {
  demand.store = nullptr; // has the tapes of the results
  loop.tolerances = estimate::tolerances_of(at, loop.stated, drawn.redraw(deck.name()), demand, keeper);
}

// The same on a mesh that was not searched for.
void add_tolerances(const Drawn& drawn, const DeckFile& deck, const sketch::Mesh& mesh, estimate::Demand demand,
                    MeshLoop& loop) {
  estimate::Trial trial;
  demand.drawn = true, demand.store = nullptr;
  estimate::ask_below(drawn.sketch, mesh, demand.cycle);
  std::string why;
  if (estimate::solve(sketch::deck_of(drawn.sketch, mesh), demand, trial, why) == C2D_OK)
    return add_tolerances(drawn, deck, {drawn.sketch, mesh, trial}, demand, nullptr, loop);
  for (const sketch::Tolerance& t : drawn.sketch.tolerances)
    loop.tolerances.parameters.push_back({t.parameter, t.value, t.size, ""});
  loop.tolerances.why = why;
}

// Loads round the axis, on a mesh that was not searched for.
void add_torsion(const Drawn& drawn, const sketch::Mesh& mesh, estimate::Demand demand, MeshLoop& loop) {
  estimate::Trial trial;
  demand.drawn = true, demand.store = nullptr;
  if (estimate::solve(sketch::deck_of(drawn.sketch, mesh), demand, trial, loop.torsion.why) == C2D_OK)
    loop.torsion = estimate::twist(drawn.sketch, mesh, trial).table;
}

// Replaces a valid sketch by its deck. Throws a sketch::Fault.
int mesh_sketch(DeckFile& deck, const Drawn& drawn, const Drawing& drawing, MeshLoop& loop) {
  const sketch::Sketch& sketch = drawn.sketch;
  constexpr double kCoarser = 0.5, kFiner = 5; // than the mesh without a search, of most problems
  if (drawing.expected != nullptr && sketch.adapts)
    for (const double factor : {kCoarser, kFiner})
      drawing.expected->push_back(sketch::deck_of(sketch, sketch::first_mesh(sketch, factor * sketch::kWithoutSearch)));
  estimate::Demand demand;
  demand.memory = drawing.memory;
  demand.store = drawing.store;
  estimate::ask(sketch, demand);
  const bool toleranced = drawing.tolerances && !sketch.tolerances.empty();
  if (!drawing.adapts || !sketch.adapts) {
    const sketch::Mesh mesh = sketch.adapts ? sketch::first_mesh(sketch, sketch::kWithoutSearch) : sketch::given_mesh(sketch);
    if (toleranced) add_tolerances(drawn, deck, mesh, demand, loop);
    if (sketch.torsion.any() && (drawing.store != nullptr || drawing.keeper != nullptr)) add_torsion(drawn, mesh, demand, loop);
    deck.replace_by_deck(sketch::deck_of(sketch, mesh));
    return toleranced && interrupted() ? kExitCancelled : 0;
  }
  if (const int status = drawing.before_search ? drawing.before_search(drawn.files) : 0; status != 0) return status;
  size_t meshes = 0;
  const auto on_round = [&](const MeshRound& round) {
    if (drawing.shows) show(round, ++meshes);
  };
  estimate::Adapted adapted = estimate::adapt_positions(sketch, demand, on_round, drawing.keeper);
  if (toleranced && adapted.loop.ran() && !interrupted())
    add_tolerances(drawn, deck, {adapted.sketch, adapted.mesh, adapted.trial}, demand, drawing.keeper, adapted.loop);
  if (interrupted() && (!drawing.ends_in_results || !adapted.loop.ran())) return kExitCancelled;
  if (interrupted()) put_off_interrupt();
  if (drawing.keeper != nullptr && !drawing.keeper->error().empty())
    return Messages(deck).fail(drawing.keeper->error(), kExitFiles);
  deck.replace_by_deck(adapted.deck);
  print_misses(deck, adapted.loop);
  loop = std::move(adapted.loop);
  return 0;
}

} // namespace

namespace {

// Replaces the parameters of a deck by their values.
int fill_deck(DeckFile& deck, const Drawing& drawing) {
  std::vector<Setting> settings;
  for (const std::string& word : drawing.settings) {
    settings.emplace_back();
    if (read_setting(word, settings.back())) continue;
    print(deck, {{}, word + ": expected the name of a parameter, = and a value without blanks"});
    return kExitUsage;
  }
  if (settings.empty() && deck.text().find('{') == std::string::npos) return 0;
  std::string text = deck.text();
  std::vector<DeckFault> faults;
  if (put_parameters(text, settings, faults)) {
    deck.inputs.parameters = values_of_parameters(deck.text(), settings);
    deck.replace(text);
    return 0;
  }
  for (const DeckFault& fault : faults) print(deck, {{fault.line, fault.column, fault.column_end}, fault.text});
  return faults.back().line == 0 ? kExitUsage : kExitInput;
}

} // namespace

std::set<std::string> parameters_of(const DeckFile& deck) {
  if (!sketch::is_sketch(deck.text(), deck.name())) return parameters_of(deck.text());
  return sketch::read_sketch(deck.text(), {}, [](const std::string&, std::string&) { return false; }).parameters;
}

std::vector<Setting> parameters_used(const DeckFile& deck, const std::vector<std::string>& settings) {
  std::vector<Setting> out;
  if (!sketch::is_sketch(deck.text(), deck.name())) {
    for (const std::string& word : settings)
      if (Setting setting; read_setting(word, setting)) out.push_back(setting);
    return values_of_parameters(deck.text(), out);
  }
  Given given;
  for (const std::string& word : settings)
    if (!read_given(word, given)) return {};
  const auto file = [&](const std::string& name, std::string& text) {
    const std::string why = read_named(beside(deck.name(), name), text);
    if (!why.empty()) text = why;
    return why.empty();
  };
  const sketch::Reading reading = sketch::read_sketch(deck.text(), given.values, file);
  if (!reading.faults.empty()) return {};
  for (const auto& [name, value] : reading.sketch.parameters) out.emplace_back(name, exact_number(value));
  return out;
}

int take_sketch(DeckFile& deck, const Drawing& drawing, MeshLoop& loop) {
  deck.inputs.files = {input_file(deck.name(), deck.text())};
  if (!sketch::is_sketch(deck.text(), deck.name())) return fill_deck(deck, drawing);
  Given given;
  for (const std::string& word : drawing.settings)
    if (!read_given(word, given)) {
      print(deck, {{}, word + ": expected the name of a parameter, = and a number" + expected_tolerance(word)});
      return kExitUsage;
    }
  std::vector<std::string> read;
  std::vector<NamedText> files;
  const auto file = [&](const std::string& name, std::string& text) {
    read.push_back(beside(deck.name(), name));
    if (drawing.files == nullptr) {
      if (const std::string why = read_named(read.back(), text); !why.empty()) return text = why, false;
    }
    if (drawing.files != nullptr && !find_text(*drawing.files, read.back(), text)) return false;
    files.push_back({read.back(), text});
    return true;
  };
  const sketch::Reading reading = sketch::read_sketch(deck.text(), given.values, file, given.tolerances);
  if (interrupted()) return kExitCancelled; // an interrupted read is not a file error
  for (const sketch::Fault& fault : reading.faults) print(deck, fault);
  if (!reading.faults.empty()) return kExitInput;
  for (const NamedText& named : files) deck.inputs.files.push_back(input_file(named.name, named.text));
  for (const auto& [name, value] : reading.sketch.parameters) deck.inputs.parameters.emplace_back(name, exact_number(value));
  int exit = 0;
  for (const auto& [name, value] : given.values)
    if (reading.parameters.count(name) == 0) {
      print(deck,
            {{},
             "no parameter of this sketch is called " + sketch::in_quotes(name) + offer_parameters(name, reading.parameters)});
      exit = kExitUsage;
    }
  if (exit != 0) return exit;
  if (const std::string clash = drawing.find_clash ? drawing.find_clash(read) : ""; !clash.empty()) {
    print(deck, {{}, clash});
    return kExitUsage;
  }
  try {
    const Drawn drawn{reading.sketch, deck.text(), given, files};
    check_tolerances(drawn, deck.name());
    return mesh_sketch(deck, drawn, drawing, loop);
  } catch (const sketch::Fault& fault) {
    print(deck, fault);
    return kExitInput;
  }
}

// The deck with what it was made from, as comments behind its title.
static std::string with_inputs(const DeckFile& deck) {
  constexpr int kTitleLines = 4; // *FREE, how many lines of title follow, two of them
  std::string comments = std::string("! made by contact2d ") + c2d_version() + "\n";
  for (const InputFile& file : deck.inputs.files) comments += "! file " + shown(file.name) + ", sha256 " + file.sha256 + "\n";
  for (const auto& [name, value] : deck.inputs.parameters) comments += "! parameter " + name + " = " + value + "\n";
  std::string text = deck.text();
  size_t at = 0;
  for (int line = 0; line < kTitleLines && at != std::string::npos; ++line) at = text.find('\n', at == 0 ? 0 : at + 1);
  return at == std::string::npos ? text : text.insert(at + 1, comments);
}

int write_mesh(const Options& options) {
  DeckFile deck;
  MeshLoop loop;
  Messages messages(deck);
  c2d_error fault = C2D_INIT(c2d_error);
  if (!deck.read(options.deck, fault)) return messages.fault(fault, kExitInput);
  if (!sketch::is_sketch(deck.text(), deck.name()))
    return messages.fail("the file is a deck and has a mesh, expected a sketch", kExitInput);
  if (const int status =
          take_sketch(deck, {options.settings, true, options.memory, ProgressLine(options.progress).active(), true}, loop);
      status != 0)
    return status;
  if (const int exit = write_or_fail(options.output, with_inputs(deck), messages); exit != 0) return exit;
  return exit_put_off() != 0 ? exit_put_off() : loop.missed() ? kExitInaccurate : kExitSolved;
}

} // namespace app

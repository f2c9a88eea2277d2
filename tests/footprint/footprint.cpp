// footprint TARGET FOLDER TABLE: the bill of one target as rows of a table (port/cortex-m/README.md).
// FOLDER holds what `make footprint` put there: obj/*.ci (call graphs), <configuration>.size (size -A of an
// image), whole.dis and whole.nm (of the image with every function; not on the desktop, whose libm is apart),
// calls (the functions of the header), run.log (what the emulator run told; not on the desktop). Every call's
// deepest chain goes to FOLDER/stacks. Ends with 1 if the stack cannot be bounded or painted use exceeds the
// bound.
#include "stack.hpp"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

namespace fs = std::filesystem;
using namespace footprint;

namespace {

struct Sizes {
  long code = 0, constants = 0, data = 0;
};

// Lines "section size address" of `size -A`; constants that hold addresses are constants too.
Sizes read_sizes(const std::string& file) {
  Sizes out;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string section;
    long bytes;
    if (!(words >> section >> bytes)) continue;
    const auto begins = [&](const char* with) { return section.compare(0, std::strlen(with), with) == 0; };
    if (begins(".text"))
      out.code += bytes;
    else if (begins(".rodata") || begins(".data.rel.ro"))
      out.constants += bytes;
    else if (begins(".data") || begins(".bss"))
      out.data += bytes;
  }
  return out;
}

// The number behind `word` in a file; -1 without one.
long number_in(const std::string& file, const std::string& word) {
  std::ifstream in(file);
  const std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  const size_t at = text.find(word);
  return at == std::string::npos ? -1 : std::atol(text.c_str() + at + word.size());
}

Graph read_graph(const std::string& folder, const std::string& table, const std::vector<std::string>& host) {
  Graph graph;
  const Indirect indirect = read_table(table, graph.faults);
  for (const auto& entry : fs::directory_iterator(folder + "/obj"))
    if (entry.path().extension() == ".ci") read_call_graph(entry.path().string(), indirect, host, graph);
  if (fs::exists(folder + "/whole.dis"))
    read_disassembly(folder + "/whole.dis", folder + "/whole.nm", graph);
  else
    graph.libraries_apart = true;
  return graph;
}

void show_chain(const char* what, const Worst& worst) {
  std::printf("  %s: %ld bytes:", what, worst.bytes);
  for (const std::string& step : worst.chain) std::printf(" %s", step.c_str());
  std::printf("\n");
}

bool tell_faults(const Graph& graph) {
  std::set<std::string> once(graph.faults.begin(), graph.faults.end());
  for (const std::string& fault : once) std::printf("  stack: %s\n", fault.c_str());
  return once.empty();
}

} // namespace

int main(int count, char** argument) {
  if (count != 4) return 64;
  const std::string target = argument[1], folder = argument[2], table = argument[3];
  bool good = true;

  Graph graph = read_graph(folder, table, {});
  Worst worst;
  std::vector<std::pair<long, std::string>> calls;
  std::ifstream names(folder + "/calls");
  std::ofstream chains(folder + "/stacks");
  for (std::string name; names >> name;) {
    const Worst here = worst_stack(graph, name);
    chains << here.bytes;
    for (const std::string& step : here.chain) chains << ' ' << step;
    chains << '\n';
    calls.emplace_back(here.bytes, name);
    if (here.bytes > worst.bytes) worst = here;
  }
  good = tell_faults(graph) && good;
  std::sort(calls.rbegin(), calls.rend());
  std::printf("%s: stack of the calls that need most, callbacks apart:", target.c_str());
  for (size_t i = 0; i < calls.size() && i < 12; ++i)
    std::printf("%s %s %ld", i == 0 ? "" : ",", calls[i].second.c_str(), calls[i].first);
  std::printf("\n");
  show_chain("deepest", worst);

  const std::string log = folder + "/run.log";
  const long painted = number_in(log, "painted over ");
  if (fs::exists(log)) {
    Graph image = read_graph(folder, table,
                             {"port/cortex-m/:open_tape", "port/cortex-m/:read_block", "port/cortex-m/:write_block",
                              "port/cortex-m/:sync_tape", "port/cortex-m/:close_tape", "port/cortex-m/:print_step",
                              "port/cortex-m/:tell", "c2d_semihosting_next_card"});
    const Worst whole = worst_stack(image, "c2d_reset");
    good = tell_faults(image) && good;
    show_chain("sample with its callbacks", whole);
    std::printf("  painted over in the emulator: %ld, computed %ld\n", painted, whole.bytes);
    if (painted < 0 || painted > whole.bytes) {
      std::printf("  the painted stack exceeds what was computed\n");
      good = false;
    }
  }
  const long workspace = number_in(log, "workspace ");
  for (const char* configuration : {"whole", "no-deck", "no-points", "solver", "solver-told", "solver-run", "solver-deck"}) {
    const Sizes sizes = read_sizes(folder + "/" + configuration + ".size");
    std::printf("| %s | %s | %ld | %ld | %ld | %ld |", target.c_str(), configuration, sizes.code, sizes.constants, sizes.data,
                worst.bytes);
    if (workspace >= 0)
      std::printf(" %ld | %ld |\n", workspace, painted);
    else
      std::printf(" | |\n");
  }
  return good ? 0 : 1;
}

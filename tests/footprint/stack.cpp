#include "stack.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace footprint {
namespace {

// The text behind `word` up to the next quote.
std::string quoted(const std::string& line, const std::string& word) {
  const size_t at = line.find(word + " \"");
  if (at == std::string::npos) return "";
  const size_t begin = at + word.size() + 2, end = line.find('"', begin);
  return line.substr(begin, end - begin);
}

// "c2d_status c2d::{anonymous}::fill(const Panel&)" -> "fill"
std::string plain_name(const std::string& signature) {
  std::string text = signature.substr(0, signature.find("\\n"));
  for (size_t at = text.find("{anonymous}"); at != std::string::npos; at = text.find("{anonymous}")) text.erase(at, 11);
  text = text.substr(0, text.find('('));
  const size_t template_begin = text.find('<');
  if (template_begin != std::string::npos && template_begin > 0) text = text.substr(0, template_begin);
  size_t begin = text.size();
  while (begin > 0 && (std::isalnum(static_cast<unsigned char>(text[begin - 1])) || text[begin - 1] == '_')) --begin;
  return text.substr(begin);
}

std::string file_of(const std::string& location) { return location.substr(0, location.find(':')); }

// "file:line:column" of a call through the table of an optional part (src/memory/parts.hpp): the function, which has the
// name of its place in the table. Empty: another call.
std::string function_of_part(const std::string& place) {
  std::ifstream in(file_of(place));
  std::string line;
  for (long n = std::atol(place.substr(place.find(':') + 1).c_str()); n > 0; --n)
    if (!std::getline(in, line)) return "";
  const size_t table = line.find("Part."), end = line.find('(', table);
  return table == std::string::npos || end == std::string::npos ? "" : line.substr(table + 5, end - table - 5);
}

} // namespace

Indirect read_table(const std::string& file, std::vector<std::string>& faults) {
  Indirect table;
  std::ifstream in(file);
  if (!in) faults.push_back(file + " cannot be read");
  for (std::string line; std::getline(in, line);) {
    const size_t colon = line.find(':');
    if (line.empty() || line[0] == '#' || colon == std::string::npos) continue;
    const std::string source = line.substr(0, colon);
    std::istringstream words(line.substr(colon + 1));
    for (std::string word; words >> word;) {
      if (word == "host")
        table.host.insert(source);
      else
        table.targets[source].insert(word);
    }
  }
  return table;
}

void read_call_graph(const std::string& file, const Indirect& table, const std::vector<std::string>& host, Graph& graph) {
  std::ifstream in(file);
  if (!in) graph.faults.push_back(file + " cannot be read");
  for (std::string line; std::getline(in, line);) {
    if (line.compare(0, 5, "node:") == 0) {
      const std::string key = quoted(line, "title:"), label = quoted(line, "label:");
      if (line.find("shape : ellipse") != std::string::npos) continue; // defined elsewhere
      Function& f = graph.function[key];
      f.name = plain_name(label);
      const size_t bytes = label.find(" bytes (");
      if (bytes == std::string::npos) continue;
      f.frame = std::max(f.frame, std::stol(label.substr(label.rfind("\\n", bytes) + 2)));
      // "dynamic,bounded" frames move the pointer by constants only: the number is their maximum.
      if (label.compare(bytes, 16, " bytes (dynamic)") == 0) f.faults.insert(f.name + ": dynamic frame");
    } else if (line.compare(0, 5, "edge:") == 0) {
      const std::string from = quoted(line, "sourcename:"), to = quoted(line, "targetname:");
      if (to != "__indirect_call") {
        graph.function[from].calls.insert(to);
        continue;
      }
      const std::string place = quoted(line, "label:"), source = file_of(place), function = function_of_part(place);
      if (!function.empty()) {
        graph.function[from].calls.insert("=" + function);
        continue;
      }
      const auto known = table.targets.find(source);
      if (known != table.targets.end())
        for (const std::string& target : known->second) graph.function[from].calls.insert("=" + target);
      if (table.host.count(source) != 0)
        for (const std::string& target : host) graph.function[from].calls.insert("=" + target);
      if (known == table.targets.end() && table.host.count(source) == 0)
        graph.function[from].faults.insert(place + ": indirect call that the table does not know");
    }
  }
}

namespace {

// Registers of "{r4, r5, lr}", "{d8-d15}", in bytes.
long saved_bytes(const std::string& list) {
  long bytes = 0;
  std::istringstream parts(list);
  for (std::string part; std::getline(parts, part, ',');) {
    part.erase(std::remove_if(part.begin(), part.end(), [](char c) { return c == ' ' || c == '{' || c == '}'; }), part.end());
    const long size = !part.empty() && part[0] == 'd' ? 8 : 4;
    const size_t dash = part.find('-');
    const long count = dash == std::string::npos ? 1 : std::stol(part.substr(dash + 2)) - std::stol(part.substr(1)) + 1;
    bytes += size * count;
  }
  return bytes;
}

long number_after(const std::string& text, const char* mark) {
  const size_t at = text.find(mark);
  return at == std::string::npos ? 0 : std::labs(std::stol(text.substr(at + std::string(mark).size())));
}

// One instruction: what it takes of the stack, whom it calls, whether the next one can be reached from it.
void take_instruction(const std::string& op, const std::string& rest, const std::string& own, Function& f, bool& goes_on,
                      std::vector<std::string>& faults) {
  const bool went_on = goes_on;
  goes_on = true;
  const bool stores = rest.compare(0, 3, "sp!") == 0;
  if (op == "push" || op == "push.w" || op == "vpush") {
    f.frame += saved_bytes(rest);
  } else if (op.compare(0, 5, "stmdb") == 0 && stores) {
    f.frame += saved_bytes(rest.substr(rest.find('{')));
  } else if (op.compare(0, 3, "sub") == 0 && rest.compare(0, 3, "sp,") == 0) {
    if (rest.find('#') == std::string::npos) faults.push_back(own + ": dynamic frame");
    f.frame += number_after(rest, "#");
  } else if (op.compare(0, 3, "str") == 0 && rest.find("[sp, #-") != std::string::npos &&
             rest.find("]!") != std::string::npos) {
    f.frame += number_after(rest, "[sp, #-");
  }
  if (op.compare(0, 3, "nop") == 0 || (op == "movs" && rest == "r0, r0")) {
    goes_on = went_on; // padding
    return;
  }
  const bool returns = (op.compare(0, 3, "pop") == 0 || op.compare(0, 5, "ldmia") == 0) && rest.find("pc") != std::string::npos;
  if (returns || op == "bx" || op == "b.n" || op == "b.w" || op == "b" || op == "udf") goes_on = false;
  if (op == "ldr.w" && rest.compare(0, 3, "pc,") == 0) goes_on = false;
  if (op == "blx" && rest.find('<') == std::string::npos) faults.push_back(own + ": indirect call in the library");
  const size_t open = rest.find('<');
  if (op[0] == 'b' && open != std::string::npos) {
    const std::string target = rest.substr(open + 1, rest.find_first_of("+>", open) - open - 1);
    if (op.compare(0, 2, "bl") == 0 && op.compare(0, 3, "ble") != 0 && op.compare(0, 3, "blt") != 0 &&
        op.compare(0, 3, "bls") != 0)
      f.calls.insert(target);
    else if (target != own)
      f.jumps.insert(target);
  }
}

} // namespace

namespace {

std::set<std::string> reached_by_jumps(const std::map<std::string, Function>& all, const std::string& from) {
  std::set<std::string> seen;
  std::vector<std::string> open{from};
  while (!open.empty()) {
    const auto at = all.find(open.back());
    open.pop_back();
    if (at == all.end()) continue;
    for (const std::string& next : at->second.jumps)
      if (seen.insert(next).second) open.push_back(next);
  }
  return seen;
}

// Labels that jump to each other are one function: its frame is the sum of theirs. All other jumps become
// calls.
void join_labels(std::map<std::string, Function>& all, std::map<std::string, std::string>& alias) {
  std::map<std::string, std::set<std::string>> reach;
  for (const auto& entry : all) reach[entry.first] = reached_by_jumps(all, entry.first);
  std::map<std::string, std::string> owner;
  for (const auto& entry : all) {
    owner[entry.first] = entry.first;
    for (const std::string& other : reach[entry.first])
      if (reach[other].count(entry.first) != 0 && other < owner[entry.first]) owner[entry.first] = other;
  }
  std::map<std::string, Function> joined;
  for (const auto& entry : all) {
    Function& f = joined[owner[entry.first]];
    if (f.frame == -1) f = Function{owner[entry.first], 0, {}, {}, {}};
    f.frame = f.frame < 0 || entry.second.frame < 0 ? -2 : f.frame + entry.second.frame;
    for (const std::string& call : entry.second.calls) f.calls.insert(owner.count(call) ? owner[call] : call);
    for (const std::string& jump : entry.second.jumps)
      if (!owner.count(jump) || owner[jump] != owner[entry.first]) f.calls.insert(owner.count(jump) ? owner[jump] : jump);
    if (owner[entry.first] != entry.first) alias[entry.first] = owner[entry.first];
  }
  for (auto& entry : alias)
    if (owner.count(entry.second)) entry.second = owner[entry.second];
  all = joined;
}

} // namespace

void read_disassembly(const std::string& file, const std::string& nm, Graph& graph) {
  std::map<unsigned long, std::string> label; // by address
  std::map<std::string, Function> found;
  std::ifstream in(file);
  if (!in) graph.faults.push_back(file + " cannot be read");
  std::string own;
  bool goes_on = false;
  for (std::string line; std::getline(in, line);) {
    const size_t open = line.find(" <");
    if (!line.empty() && line.back() == ':' && open != std::string::npos) {
      const std::string next = line.substr(open + 2, line.size() - open - 4);
      if (goes_on && !own.empty()) found[own].jumps.insert(next); // falls through
      own = next;
      label[std::stoul(line, nullptr, 16)] = own;
      found[own] = Function{own, 0, {}, {}, {}};
      goes_on = true;
      continue;
    }
    const size_t tab = line.find('\t'), tab2 = line.find('\t', tab + 1);
    if (own.empty() || tab == std::string::npos || tab2 == std::string::npos) continue;
    const size_t tab3 = line.find('\t', tab2 + 1);
    const std::string op = line.substr(tab2 + 1, tab3 == std::string::npos ? tab3 : tab3 - tab2 - 1);
    if (op.empty() || op[0] == '.') continue;
    std::vector<std::string> faults; // only those of functions that are asked for would matter: see below
    take_instruction(op, tab3 == std::string::npos ? "" : line.substr(tab3 + 1), own, found[own], goes_on, faults);
    if (!faults.empty()) found[own].frame = -2;
  }
  std::ifstream names(nm);
  for (std::string line; std::getline(names, line);) {
    std::istringstream words(line);
    std::string address, kind, name;
    if (!(words >> address >> kind >> name)) continue;
    const auto at = label.find(std::stoul(address, nullptr, 16) & ~1ul);
    if (at != label.end() && at->second != name) graph.alias[name] = at->second;
  }
  join_labels(found, graph.alias);
  for (auto& entry : found) graph.function.emplace(entry.first, entry.second);
}

namespace {

struct Walk {
  Graph& graph;
  std::map<std::string, Worst> known;
  std::vector<std::string> path;
};

// Keys of the graph for what a call names (several for a name of the table, "=name"); with a fault if there
// is none.
std::vector<std::string> resolve(Walk& walk, const std::string& target) {
  std::vector<std::string> keys;
  if (target[0] == '=') {
    const size_t colon = target.find(':'); // "=folder/:name": only in files of a folder
    const std::string name = target.substr(colon == std::string::npos ? 1 : colon + 1),
                      folder = colon == std::string::npos ? "" : target.substr(1, colon - 1);
    for (const auto& entry : walk.graph.function)
      if (entry.second.name == name && entry.second.frame >= 0 && entry.first.compare(0, folder.size(), folder) == 0)
        keys.push_back(entry.first);
  } else {
    const auto alias = walk.graph.alias.find(target);
    if (walk.graph.function.count(target) != 0)
      keys.push_back(target);
    else if (alias != walk.graph.alias.end() && walk.graph.function.count(alias->second) != 0)
      keys.push_back(alias->second);
    for (const char* part : {"C1E", "D1E"}) { // whole constructors and destructors are other names of C2, D2
      const size_t at = keys.empty() ? target.find(part) : std::string::npos;
      if (at == std::string::npos) continue;
      std::string same = target;
      same[at + 1] = '2';
      if (walk.graph.function.count(same) != 0) keys.push_back(same);
    }
  }
  if (keys.empty() && walk.graph.libraries_apart && target[0] != '=' && target.find("c2d") == std::string::npos) return keys;
  if (keys.empty()) walk.graph.faults.push_back((walk.path.empty() ? "" : walk.path.back() + " calls ") + target + ": unknown");
  return keys;
}

const Worst& visit(Walk& walk, const std::string& key) {
  static const Worst none;
  const auto before = walk.known.find(key);
  if (before != walk.known.end()) return before->second;
  if (std::find(walk.path.begin(), walk.path.end(), key) != walk.path.end()) {
    walk.graph.faults.push_back(walk.graph.function[key].name + ": recursion");
    return none;
  }
  walk.path.push_back(key);
  const Function f = walk.graph.function[key];
  for (const std::string& fault : f.faults) walk.graph.faults.push_back(fault);
  if (f.frame < 0) walk.graph.faults.push_back(f.name + " (" + key + "): frame not known");
  Worst worst;
  for (const std::string& call : f.calls)
    for (const std::string& target : resolve(walk, call)) {
      const Worst& below = visit(walk, target);
      if (below.bytes > worst.bytes || worst.chain.empty()) worst = below;
    }
  worst.bytes += std::max(0L, f.frame);
  worst.chain.insert(worst.chain.begin(), f.name + " " + std::to_string(f.frame));
  walk.path.pop_back();
  return walk.known[key] = worst;
}

} // namespace

Worst worst_stack(Graph& graph, const std::string& root) {
  Walk walk{graph, {}, {}};
  Worst worst;
  for (const std::string& key : resolve(walk, root)) worst = visit(walk, key);
  return worst;
}

} // namespace footprint

#pragma once
// Worst-case stack from the compiler's call graph: g++ -fstack-usage -fcallgraph-info=su writes a .ci file
// per object, with every function's frame and every call. What is not the project's (libm, the compiler's
// run-time) is read from a disassembly. Indirect calls are resolved by a table, source file by source file.
#include <map>
#include <set>
#include <string>
#include <vector>

namespace footprint {

struct Function {
  std::string name;             // as a reader knows it
  long frame = -1;              // bytes; -1: not known
  std::set<std::string> calls;  // keys of other functions
  std::set<std::string> faults; // told when it is reached
  std::set<std::string> jumps;  // labels of a library's assembler that it goes on at; empty once read
};

struct Graph {
  std::map<std::string, Function> function; // by the compiler's key: "file:symbol" for local ones
  std::map<std::string, std::string> alias; // symbols of one address: the label that the disassembly shows
  std::vector<std::string> faults;
  bool libraries_apart = false; // where the C library is the system's: its stack is not counted
};

// What an indirect call in a source file may reach: names of functions, or the caller's callbacks.
struct Indirect {
  std::map<std::string, std::set<std::string>> targets; // by file; names without arguments
  std::set<std::string> host;                           // files whose indirect calls are all the caller's callbacks
};

Indirect read_table(const std::string& file, std::vector<std::string>& faults);
// Adds the functions of a .ci file. Dynamic frames, and indirect calls that the table does not know, are
// faults. `host`: names of what the caller's callbacks lead to; none: they are not counted.
void read_call_graph(const std::string& file, const Indirect& table, const std::vector<std::string>& host, Graph& graph);
// Adds functions that the graph lacks; names of equal addresses from `nm`.
void read_disassembly(const std::string& file, const std::string& nm, Graph& graph);

struct Worst {
  long bytes = 0;
  std::vector<std::string> chain; // from the function asked for to the deepest, with frames
};
// Recursion and unknown callees are faults.
Worst worst_stack(Graph& graph, const std::string& root);

} // namespace footprint

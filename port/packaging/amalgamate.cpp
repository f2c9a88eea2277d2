// Joins all sources named on the command line into one file, for vendoring the library:
//   amalgamate VERSION SOURCE... > contact2d.cpp          (from the root of the sources)
// Private headers are inlined where they are first needed. Two files may use one name in their unnamed
// namespaces; in one file that would be a clash, or worse another overload, so such names get the name of their
// file behind them: `larger` of model/element.cpp becomes `larger_model_element`.
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace {

using Names = std::set<std::string>;

std::vector<std::string> lines_of(const std::string& path) {
  std::ifstream in(path);
  if (!in) {
    std::cerr << "amalgamate: cannot read " << path << '\n';
    std::exit(1);
  }
  std::vector<std::string> out;
  for (std::string line; std::getline(in, line);) out.push_back(line);
  return out;
}

bool begins(const std::string& text, const std::string& with) { return text.compare(0, with.size(), with) == 0; }

// Path of a header named in an #include; empty: not one of this library.
std::string header_path(const std::string& name) {
  for (const char* folder : {"src/", "port/memory/"})
    if (std::ifstream(folder + name)) return folder + name;
  return "";
}

// The name declared by a line that begins at the margin: a type, a function, a constant. Empty: none.
std::string declared(const std::string& whole) {
  static const std::regex attributes("^(?:\\[\\[[^\\]]*\\]\\] ?)+");
  const std::string line = std::regex_replace(whole, attributes, "");
  static const std::regex type("^(?:struct|class|enum class|enum|union|using) (\\w+)(?: \\{| =|;| :).*"),
      function("^[A-Za-z][\\w:<>, ]*?[ *&]+(\\w+)\\(.*"),
      constant("^(?:static |inline )*(?:constexpr|const) [\\w:<>* ]*?[ *](\\w+)(?:\\[.*?\\])*(?: =|\\{|;).*");
  if (begins(line, "template") || begins(line, "namespace") || begins(line, "return")) return "";
  std::smatch match;
  for (const std::regex* pattern : {&type, &constant, &function})
    if (std::regex_match(line, match, *pattern)) return match[1];
  return "";
}

// Names that a file declares: all of them, or those of its unnamed namespaces and static ones.
Names names_of(const std::string& path, bool only_own) {
  Names out;
  bool own = !only_own;
  const std::vector<std::string> lines = lines_of(path);
  for (size_t i = 0; i < lines.size(); ++i) {
    const std::string& line = lines[i];
    const bool of_one_line = line == "}" && i >= 2 && lines[i - 2] == "namespace {"; // clang-format adds no comment there
    if (only_own && line == "namespace {") own = true;
    if (only_own && (line == "} // namespace" || of_one_line)) own = false;
    if (!own && !begins(line, "static ")) continue;
    const std::string name = declared(line);
    if (!name.empty()) out.insert(name);
  }
  return out;
}

// The line with `tag` appended to every word of `names`, except members (`x.name`, `x->name`), text and comments.
std::string renamed(const std::string& line, const Names& names, const std::string& tag) {
  std::string out;
  for (size_t i = 0; i < line.size();) {
    if (line[i] == '/' && i + 1 < line.size() && line[i + 1] == '/') return out + line.substr(i);
    const size_t start = i++;
    if (line[start] == '"' || (line[start] == '\'' && (start == 0 || !std::isalnum(line[start - 1])))) {
      while (i < line.size() && line[i] != line[start]) i += line[i] == '\\' ? 2 : 1;
      ++i;
    } else if (std::isalpha(line[start]) || line[start] == '_') {
      while (i < line.size() && (std::isalnum(line[i]) || line[i] == '_')) ++i;
      const bool member =
          (start > 0 && line[start - 1] == '.') || (start > 1 && line[start - 1] == '>' && line[start - 2] == '-');
      const std::string word = line.substr(start, i - start);
      out += !member && names.count(word) ? word + tag : word;
      continue;
    } else if (std::isdigit(line[start])) {
      while (i < line.size() && std::isalnum(line[i])) ++i; // 0x1f, 1e5f
    }
    out += line.substr(start, i - start);
  }
  return out;
}

struct Amalgamation {
  Names seen;                             // headers that need not come again
  std::map<std::string, int> declared_in; // by how many files
  void count(const std::string& source);
  void put(const std::string& path, const Names& names, const std::string& tag);
  void include(const std::string& line, const Names& names, const std::string& tag);
  void source(const std::string& path);

private:
  Names counted_;
  void count_headers(const std::string& path);
};

void Amalgamation::count_headers(const std::string& path) {
  for (const std::string& line : lines_of(path)) {
    if (!begins(line, "#include \"")) continue;
    const std::string header = header_path(line.substr(10, line.rfind('"') - 10));
    if (header.empty() || !counted_.insert(header).second) continue;
    for (const std::string& name : names_of(header, false)) ++declared_in[name];
    count_headers(header);
  }
}

void Amalgamation::count(const std::string& source) {
  for (const std::string& name : names_of(source, true)) ++declared_in[name];
  count_headers(source);
}

void Amalgamation::include(const std::string& line, const Names& names, const std::string& tag) {
  const std::string header = line[9] == '"' ? header_path(line.substr(10, line.rfind('"') - 10)) : "";
  if (header.empty()) { // of the system, or a public one; cpuid.h stands within a condition
    if (seen.insert(line).second) std::cout << line << '\n';
  } else if (seen.insert(header).second) {
    const bool loops = header.find("_loops.") != std::string::npos; // is part of the source
    put(header, loops ? names : Names(), tag);
  }
}

void Amalgamation::put(const std::string& path, const Names& names, const std::string& tag) {
  std::cout << "\n/* ---- " << path << " */\n";
  for (const std::string& line : lines_of(path)) {
    if (line == "#pragma once") continue;
    if (begins(line, "#include"))
      include(line, names, tag);
    else
      std::cout << renamed(line, names, tag) << '\n';
  }
}

void Amalgamation::source(const std::string& path) {
  const std::string from = begins(path, "src/") ? path.substr(4) : path;
  const std::string tag = "_" + std::regex_replace(from.substr(0, from.rfind('.')), std::regex("[/-]"), "_");
  Names names;
  for (const std::string& name : names_of(path, true))
    if (declared_in[name] > 1) names.insert(name);
  if (path.find("/kernel_avx") == std::string::npos) return put(path, names, tag);
  // Other instruction sets need other flags, which one file cannot have: define that there are none.
  std::cout << "\n/* ---- " << path << " */\n";
  bool otherwise = false;
  for (const std::string& line : lines_of(path)) {
    if (line == "#endif") otherwise = false;
    if (otherwise) std::cout << line << '\n';
    if (line == "#else") otherwise = true;
  }
}

void heading(const std::string& version) {
  std::cout << "// contact2d " << version
            << " in one file, made by `make amalgamation`: change the files it names, not this one.\n"
               "//   g++ -std=c++17 -O2 -ffp-contract=off -c contact2d.cpp\n"
               "// With -fno-exceptions -fno-rtti -fno-threadsafe-statics it links with a plain cc. contact2d.h is the\n"
               "// manual, c2d_memory.h the block store in memory, the only port in here.\n//\n";
  for (const std::string& line : lines_of("LICENSE")) std::cout << (line.empty() ? "//" : "// " + line) << '\n';
}

} // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::cerr << "use: amalgamate VERSION SOURCE... > contact2d.cpp\n";
    return 64;
  }
  const std::vector<std::string> sources(argv + 2, argv + argc);
  Amalgamation all;
  for (const std::string& path : sources) all.count(path);
  heading(argv[1]);
  std::cout << "#define C2D_ONE_FILE\n"; // memory/parts.hpp
  for (const std::string& path : sources) all.source(path);
  return std::cout.flush() ? 0 : 1;
}

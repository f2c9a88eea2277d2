// Commands of the pages, run as a reader types them, and what the pages show of their output.
#pragma once

#include "paths.hpp"
#include "shell.hpp"

#include <doctest/doctest.h>

#include <cmath>

namespace test {

// Fenced blocks of a page in their order: the word behind the fence, and the lines.
struct Block {
  std::string language, text;
};
inline std::vector<Block> blocks_of(const std::string& page) {
  std::vector<Block> out;
  bool inside = false;
  for (const std::string& line : lines_of(page)) {
    if (line.compare(0, 3, "```") == 0) {
      inside = !inside;
      if (inside) out.push_back({line.substr(3), ""});
    } else if (inside) {
      out.back().text += line + "\n";
    }
  }
  return out;
}

// A project's folder with nothing but what the pages need.
class PageFolder {
public:
  PageFolder() {
    fs::create_directories(folder_ / "build");
    fs::create_directory_symlink(paths::root() + "/examples", folder_ / "examples");
    fs::create_symlink(paths::program(), folder_ / "build/contact2d");
  }
  Result run(const std::string& command) const { return run_shell("cd '" + folder_.path() + "'\n" + command); }
  std::string operator/(const std::string& name) const { return folder_ / name; }

private:
  Folder folder_;
};

inline std::vector<std::string> words_of(const std::string& line) {
  std::vector<std::string> out;
  std::istringstream in(line);
  for (std::string word; in >> word;) out.push_back(word);
  return out;
}

// Numbers, also with a mark behind them.
inline bool is_number(const std::string& word, double* value) {
  char* end = nullptr;
  *value = std::strtod(word.c_str(), &end);
  return end != word.c_str() && std::string(end).find_first_not_of(",;:)%") == std::string::npos;
}

// The same words; numbers to a percent, and stated errors, which follow "+-", to a factor of two: another compiler may lead to
// another mesh. The word "..." is any.
inline bool shows_line(const std::string& shown, const std::string& printed) {
  const std::vector<std::string> a = words_of(shown), b = words_of(printed);
  if (a.size() != b.size()) return false;
  for (size_t i = 0; i < a.size(); ++i) {
    if (a[i] == b[i] || a[i] == "...") continue;
    double p = 0, q = 0;
    if (!is_number(a[i], &p) || !is_number(b[i], &q)) return false;
    const double part = i > 0 && a[i - 1] == "+-" ? 0.5 : 0.01;
    if (std::fabs(p - q) > part * std::fmax(std::fabs(p), std::fabs(q)) + 1e-12) return false;
  }
  return true;
}

// Lines of a page that the output does not have in this order, from the first of them on; "" if it has all.
inline std::string missing_from(const std::string& printed, const std::string& shown) {
  const std::vector<std::string> out = lines_of(printed);
  size_t at = 0;
  for (const std::string& line : lines_of(shown)) {
    if (line == "...") continue;
    while (at < out.size() && !shows_line(line, out[at])) ++at;
    if (at++ == out.size()) return line;
  }
  return "";
}

// Runs the program's commands of a page in their order. A command fails only where the page shows it; so with warnings, unless
// the page is not about results.
inline void run_page(const std::string& page, bool may_warn) {
  const PageFolder folder;
  const std::vector<Block> blocks = blocks_of(page);
  for (size_t i = 0; i < blocks.size(); ++i) {
    if (blocks[i].language != "sh") continue;
    const std::string shown = i + 1 < blocks.size() && blocks[i + 1].language == "text" ? blocks[i + 1].text : "";
    std::string printed;
    for (const std::string& command : lines_of(blocks[i].text)) {
      const std::string first = words_of(command)[0];
      if (first != "build/contact2d" && first != "printf" && first != "sed" && first != "cat" && first != "tail") continue;
      CAPTURE(command);
      const Result run = folder.run(command);
      const std::string output = run.err + run.out;
      CHECK((run.status == 0) == !contains(output, ": error:"));
      for (const std::string& line : lines_of(run.err))
        if (contains(line, ": error:") || (!may_warn && contains(line, ": warning:")))
          CHECK_MESSAGE(contains(shown, line), line);
      printed += output;
    }
    CHECK_MESSAGE(missing_from(printed, shown) == "", blocks[i].text << "does not print " << missing_from(printed, shown));
  }
}

} // namespace test

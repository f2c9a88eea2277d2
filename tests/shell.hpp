// Running commands and handling files, for tests of the program and of the build.
#pragma once

#include "paths.hpp"

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace test {

namespace fs = std::filesystem;

// A folder of its own, removed at the end of the scope. (Tests that were killed leave theirs, and numbers of processes return.)
class Folder {
public:
  Folder() {
    do path_ = fs::temp_directory_path() / ("contact2d-test-" + std::to_string(::getpid()) + "-" + std::to_string(next()));
    while (!fs::create_directory(path_));
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  std::string path() const { return path_.string(); }
  std::vector<std::string> names() const {
    std::vector<std::string> out;
    for (const auto& entry : fs::directory_iterator(path_)) out.push_back(entry.path().filename().string());
    return out;
  }

private:
  static int next() { // (in a constructor compilers do not name it alike, and so do not share it)
    static std::atomic<int> count{0};
    return count++;
  }
  fs::path path_;
};

inline std::string read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

inline void write_file(const std::string& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

inline std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> out;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) out.push_back(line);
  return out;
}

struct Result {
  int status = -1; // exit status, 128 + signal
  std::string out, err;
};

// Runs a command of the shell; standard output and error are caught.
inline Result run_shell(const std::string& command) {
  const Folder folder;
  const std::string out = folder / "out", err = folder / "err";
  const int raw = std::system(("{ " + command + "\n} >'" + out + "' 2>'" + err + "'").c_str());
  Result result;
  result.status = WIFEXITED(raw) ? WEXITSTATUS(raw) : WIFSIGNALED(raw) ? 128 + WTERMSIG(raw) : -1;
  result.out = read_file(out);
  result.err = read_file(err);
  return result;
}

// A file with the deck that contact2d make writes with a family's defaults.
inline std::string made(const std::string& family) {
  static const Folder folder;
  const std::string file = folder / (family + ".dat");
  run_shell("'" + paths::program() + "' make " + family + " > '" + file + "'");
  return file;
}

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

inline bool has_command(const std::string& name) { return run_shell("command -v " + name).status == 0; }

} // namespace test

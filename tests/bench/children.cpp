#include "children.hpp"

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace bench {

namespace {

std::vector<std::string> changed_environment(const std::vector<std::string>& changes) {
  std::vector<std::string> out;
  for (char** e = environ; *e; ++e) {
    const std::string entry = *e, name = entry.substr(0, entry.find('=') + 1);
    bool kept = true;
    for (const std::string& change : changes) kept &= change.compare(0, name.size(), name) != 0;
    if (kept) out.push_back(entry);
  }
  for (const std::string& change : changes)
    if (change.back() != '=') out.push_back(change);
  return out;
}

std::vector<char*> pointers(const std::vector<std::string>& words) {
  std::vector<char*> out;
  for (const std::string& word : words) out.push_back(const_cast<char*>(word.c_str()));
  out.push_back(nullptr);
  return out;
}

} // namespace

Child::Child(const std::vector<std::string>& words, const std::vector<std::string>& changes) {
  int down[2], up[2];
  if (pipe2(down, O_CLOEXEC) != 0 || pipe2(up, O_CLOEXEC) != 0) return;
  std::signal(SIGPIPE, SIG_IGN);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, down[0], 0);
  posix_spawn_file_actions_adddup2(&actions, up[1], 1);
  posix_spawn_file_actions_addopen(&actions, 2, "/dev/null", O_WRONLY, 0);
  const std::vector<std::string> environment = changed_environment(changes);
  alive_ = posix_spawn(&pid_, words[0].c_str(), &actions, nullptr, pointers(words).data(), pointers(environment).data()) == 0;
  posix_spawn_file_actions_destroy(&actions);
  close(down[0]), close(up[1]);
  to_ = down[1], from_ = up[0];
  if (alive_) alive_ = read_line() == "ready";
}

Child::~Child() {
  if (to_ >= 0) close(to_);
  if (from_ >= 0) close(from_);
  if (pid_ > 0) waitpid(pid_, nullptr, 0);
}

std::string Child::read_line() {
  std::string line;
  for (char c = 0;;) {
    if (read(from_, &c, 1) != 1) {
      alive_ = false;
      return "";
    }
    if (c == '\n') return line;
    line += c;
  }
}

std::string Child::ask(const std::string& line) {
  const std::string all = line + "\n";
  if (!alive_ || write(to_, all.data(), all.size()) != static_cast<ssize_t>(all.size())) return "";
  return read_line();
}

Answer ask(Child& child, const std::string& what, const std::string& matrix, int n) {
  Answer answer;
  const std::string line = child.ask(what + " " + matrix + " " + std::to_string(n));
  answer.ok =
      std::sscanf(line.c_str(), "%lf %lf %lf %lf", &answer.wall, &answer.processor, &answer.peak, &answer.residual) == 4;
  return answer;
}

bool is_program(const std::string& file) { return !file.empty() && access(file.c_str(), X_OK) == 0; }

} // namespace bench

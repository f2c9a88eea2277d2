#include "child.hpp"

#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <sys/wait.h>
#include <unistd.h>

namespace faults {
namespace {

std::string read_bytes(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::string below(const std::string& work, const std::string& path) {
  if (path.compare(0, work.size(), work) != 0) return path;
  const std::filesystem::path normal = std::filesystem::path(path).lexically_normal();
  std::string out = normal.string();
  while (out.size() > work.size() && out.back() == '/') out.pop_back();
  return out.size() > work.size() ? out.substr(work.size() + 1) : std::string();
}

void read_journal(const Place& place, Ended& out) {
  const std::string log = read_bytes(place.base + "/log");
  for (size_t at = 0; at + sizeof(fault_record) <= log.size();) {
    fault_record raw;
    std::memcpy(&raw, log.data() + at, sizeof raw);
    at += sizeof raw;
    const auto next = [&](uint32_t bytes) {
      at += bytes;
      return log.substr(at - bytes, bytes);
    };
    Record r;
    r.op = raw.op, r.struck = raw.struck, r.file = raw.file, r.flags = raw.flags, r.error = raw.error;
    r.number = raw.number, r.offset = raw.offset, r.bytes = raw.bytes;
    r.path = below(place.work(), next(raw.path_bytes));
    r.path2 = raw.path2_bytes > 0 ? below(place.work(), next(raw.path2_bytes)) : std::string();
    r.data = next(raw.data_bytes);
    if (raw.op != OP_MEMORY) out.operations = raw.number;
    if (raw.op == OP_END) out.allocations = raw.offset;
    if (raw.op == OP_MEMORY) out.places.insert({raw.number, raw.offset});
    if (raw.op < OP_MEMORY) out.journal.push_back(std::move(r));
  }
}

void enter(const Place& place, const Command& command) {
  if (::chdir(place.work().c_str()) != 0) ::_exit(126);
  const int in = ::open(command.input.empty() ? "/dev/null" : command.input.c_str(), O_RDONLY);
  const int out = ::open((place.base + "/out").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  const int err = ::open((place.base + "/err").c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_APPEND, 0600);
  if (in < 0 || out < 0 || err < 0) ::_exit(126);
  ::dup2(in, 0), ::dup2(out, 1), ::dup2(err, 2);
  for (const int file : {in, out, err})
    if (file > 2) ::close(file);
  ::alarm(120); // a run that hangs ends by this signal
}

} // namespace

const Record* Ended::struck() const {
  for (const Record& r : journal)
    if (r.struck != 0) return &r;
  return nullptr;
}

Ended run(const Place& place, const Command& command, const Strike& strike, bool with_data) {
  std::vector<std::string> settings = {"LD_PRELOAD=" + place.library,
                                       "PATH=/usr/bin:/bin",
                                       "TMPDIR=" + place.work() + "/tmp",
                                       C2D_FAULT_ROOT "=" + place.work(),
                                       C2D_FAULT_LOG "=" + place.base + "/log",
                                       C2D_FAULT_KIND "=" + std::to_string(strike.kind),
                                       C2D_FAULT_AT "=" + std::to_string(strike.at),
                                       C2D_FAULT_EVER "=" + std::to_string(strike.ever ? 1 : 0),
                                       C2D_FAULT_WHERE "=" + strike.where,
                                       C2D_FAULT_DATA "=" + std::to_string(with_data ? 1 : 0),
                                       C2D_FAULT_THREADS "=" + std::to_string(command.threads ? 1 : 0),
                                       C2D_FAULT_FREE "=" + std::to_string(command.free_memory)};
  std::vector<char*> environment, words = {const_cast<char*>("contact2d")};
  // where a build that counts branches puts its counters
  if (const char* counters = std::getenv("LLVM_PROFILE_FILE")) settings.push_back("LLVM_PROFILE_FILE=" + std::string(counters));
  for (std::string& s : settings) environment.push_back(s.data());
  for (const std::string& w : command.words) words.push_back(const_cast<char*>(w.c_str()));
  environment.push_back(nullptr);
  words.push_back(nullptr);
  const pid_t child = ::fork();
  if (child == 0) {
    enter(place, command);
    ::execve(place.program.c_str(), words.data(), environment.data());
    ::_exit(127);
  }
  int raw = 0;
  while (::waitpid(child, &raw, 0) < 0 && errno == EINTR) {
  }
  Ended out;
  out.status = WIFEXITED(raw) ? WEXITSTATUS(raw) : 128 + WTERMSIG(raw);
  out.out = read_bytes(place.base + "/out");
  out.err = read_bytes(place.base + "/err");
  read_journal(place, out);
  return out;
}

} // namespace faults

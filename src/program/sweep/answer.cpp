#include "program/sweep/answer.hpp"

#include "program/exit_code.hpp"
#include "program/files/output_file.hpp"
#include "program/files/system_file.hpp"
#include "program/sweep/parameters.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace app {
namespace {

// The heading that a file of `size` bytes has to begin with: 0 or errno, EINVAL if it begins otherwise.
int compare_heading(int file, const std::string& heading) {
  std::string there(heading.size(), '\0');
  const ssize_t got = ::pread(file, &there[0], there.size(), 0);
  if (got < 0) return errno;
  return static_cast<size_t>(got) == heading.size() && there == heading ? 0 : EINVAL;
}

int append_locked(int file, const std::string& heading, const std::string& row) {
  while (::flock(file, LOCK_EX) != 0)
    if (errno != EINTR) return errno;
  struct stat about;
  if (::fstat(file, &about) != 0) return errno;
  const bool fresh = about.st_size == 0;
  if (!fresh && S_ISREG(about.st_mode))
    if (const int code = compare_heading(file, heading); code != 0) return code;
  return write_all(file, fresh ? heading + row : row);
}

} // namespace

bool append_row(const std::string& name, const std::string& heading, const std::string& row, std::string& error) {
  const int file = open_file(name, O_RDWR | O_APPEND | O_CREAT);
  int code = file < 0 ? errno : append_locked(file, heading, row);
  if (file >= 0) {
    if (code == 0) code = sync_file(file);
    const int closed = close_file(file);
    if (code == 0) code = closed;
  }
  if (code == 0) return true;
  error = name + ": " +
          (code == EINVAL ? "has other columns, expected " + heading.substr(0, heading.size() - 1)
                          : std::string("a row cannot be added: ") + system_text(code));
  return false;
}

std::string outcome_of(const Answer& answer) {
  if (answer.exit == kExitSolved) return "ok";
  if (answer.exit == kExitInaccurate) return "a requested tolerance is not met";
  std::string text = failure_text(answer.reason);
  text.pop_back();
  return text;
}

bool write_answer(const Options& options, const Answer& answer, std::string& error) {
  const bool solved = has_results(answer.exit);
  const std::string results = solved ? results_text(options.responses, answer.values) : failure_text(answer.reason);
  if (!options.results.empty() && !write_output(options.results, results, error)) return false;
  if (options.row.empty()) return true;
  std::string heading = "outcome", row = csv_field(outcome_of(answer));
  for (const std::string& word : options.settings) {
    Setting setting;
    read_setting(word, setting);
    heading += "," + csv_field(setting.first), row += "," + csv_field(setting.second);
  }
  for (size_t i = 0; i < options.responses.size(); ++i) {
    heading += "," + csv_field(options.responses[i].words);
    row += "," + (solved ? csv_number(answer.values[i]) : std::string());
  }
  return append_row(options.row, heading + "\n", row + "\n", error);
}

} // namespace app

#include "program/sweep/answer.hpp"

#include "program/exit_code.hpp"
#include "program/files/output_file.hpp"
#include "program/files/system_file.hpp"
#include "program/sweep/parameters.hpp"
#include "program/sweep/row_inputs.hpp"

#include <algorithm>
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

// The inputs of all rows; without a place where rows go into no regular file.
struct RowInputs {
  const Inputs& inputs;
  bool written = true;
  std::string error;
};

// Under the lock of the rows.
void write_row_inputs(const std::string& name, int file, bool fresh, RowInputs& r) {
  std::string rows, there;
  if (const int code = read_from_start(file, rows); code != 0) {
    r.error = name + ": cannot be read: " + system_text(code), r.written = false;
    return;
  }
  const auto row = static_cast<size_t>(std::count(rows.begin(), rows.end(), '\n')) - 1; // but the heading
  if (!fresh) read_file(name + kInputsEnding, there);                                   // none: the rows before have none
  r.written = write_output(name + kInputsEnding, inputs_of_rows(there, r.inputs, row), r.error);
}

int append_locked(const std::string& name, int file, const std::string& heading, const std::string& row, RowInputs& inputs) {
  while (::flock(file, LOCK_EX) != 0)
    if (errno != EINTR) return errno;
  struct stat about;
  if (::fstat(file, &about) != 0) return errno;
  const bool fresh = about.st_size == 0, regular = S_ISREG(about.st_mode);
  if (!fresh && regular)
    if (const int code = compare_heading(file, heading); code != 0) return code;
  if (const int code = write_all(file, fresh ? heading + row : row); code != 0) return code;
  if (!regular) return 0; // a device or a pipe cannot be synchronised
  if (const int code = sync_file(file); code != 0) return code;
  if (!inputs.inputs.files.empty()) write_row_inputs(name, file, fresh, inputs);
  return 0;
}

// Parameters that were given have a column.
Inputs without_given(Inputs inputs, const std::vector<std::string>& settings) {
  for (const std::string& word : settings) {
    Setting given;
    read_setting(word, given);
    const auto is_given = [&](const auto& parameter) { return parameter.first == given.first; };
    inputs.parameters.erase(std::remove_if(inputs.parameters.begin(), inputs.parameters.end(), is_given),
                            inputs.parameters.end());
  }
  return inputs;
}

bool write_results(const std::string& name, const std::string& text, const Inputs& inputs, std::string& error) {
  if (!write_output(name, text, error)) return false;
  struct stat about = {};
  const bool regular = name != "-" && ::stat(name.c_str(), &about) == 0 && S_ISREG(about.st_mode);
  return !regular || write_output(name + kInputsEnding, inputs_text(inputs), error);
}

} // namespace

bool append_row(const std::string& name, const std::string& heading, const std::string& row, const Inputs& inputs,
                std::string& error) {
  const int file = open_file(name, O_RDWR | O_APPEND | O_CREAT);
  RowInputs beside{inputs, true, {}};
  int code = file < 0 ? errno : append_locked(name, file, heading, row, beside);
  if (file >= 0) {
    const int closed = close_file(file);
    if (code == 0) code = closed;
  }
  error = beside.error;
  if (code == 0) return beside.written;
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
  if (!options.results.empty() && !write_results(options.results, results, answer.inputs, error)) return false;
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
  return append_row(options.row, heading + "\n", row + "\n", without_given(answer.inputs, options.settings), error);
}

} // namespace app

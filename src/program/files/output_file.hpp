// An output that appears under its name only when it is complete.
#pragma once

#include <string>
#include <vector>

namespace app {

// A new name or a regular file is written aside, in the same folder, and renamed by publish(); anything else
// that already has the name (a device, a pipe) and standard output ("-") are written directly, as late as
// possible. What was not published leaves nothing behind; what a killed process left aside goes when the same
// name is opened again. All functions return false with an error text on failure.
class OutputFile {
public:
  OutputFile() = default;
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  bool open(const std::string& name, std::string& error);
  bool is_open() const { return file_ >= 0; }
  // Append here, then call flush().
  std::string text;
  // Everything so far, written or not. False with an error text on failure, without one if it is gone: to a pipe, say.
  bool so_far(std::string& all, std::string& error);
  // Writes `text` if there is enough of it.
  bool flush(std::string& error);
  // Writes the rest and flushes a temporary file to disk; the final name is not set yet.
  bool finish(std::string& error);
  // Renames the finished file; the name is on disk after sync_folder(folder()).
  bool publish(std::string& error);
  std::string folder() const; // of a file that lies aside
  // Another name of the same file, or the same standard output?
  const std::string& name() const { return name_; }
  bool renames() const { return !aside_.empty(); }

private:
  bool write_text(std::string& error);
  bool open_aside(std::string& error);
  bool succeeds(int code, const char* what, std::string& error) const;

  std::string name_, target_, aside_; // aside_ is empty if written directly
  int file_ = -1;
  bool direct_ = false, is_gone_ = false; // is_gone_: some has been written directly
};

// Completes all files and flushes them to disk, then renames them all and flushes the names. On a failure before the first
// rename no file has appeared.
bool publish_all(const std::vector<OutputFile*>& files, std::string& error);

// Has the reader of an output gone (a pipe to head, to a pager)? Such an output ends there, without an error.
bool pipe_is_broken();

// A text as an output, to standard output without a name. False with an error text on failure.
bool write_output(const std::string& name, const std::string& text, std::string& error);

} // namespace app

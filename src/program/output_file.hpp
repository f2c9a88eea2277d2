// An output that appears under its name only when it is complete.
#pragma once

#include <string>

namespace app {

// A new name or a regular file is written aside, in the same folder, and renamed by publish(); anything else
// that already has the name (a device, a pipe) and standard output ("-") are written directly, as late as
// possible. What was not published leaves nothing behind. All functions return false with an error text on
// failure.
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
  // Writes `text` if there is enough of it.
  bool flush(std::string& error);
  // Writes what is left and closes; the name is still the old one.
  bool finish(std::string& error);
  // Gives the finished file its name.
  bool publish(std::string& error);
  // Another name of the same file, or the same standard output?
  const std::string& name() const { return name_; }
  bool renames() const { return !aside_.empty(); }

private:
  bool write_all(std::string& error);
  bool fail(const char* what, int code, std::string& error) const;

  std::string name_, target_, aside_; // aside_ is empty if written directly
  int file_ = -1;
  bool direct_ = false;
};

// A text as an output, to standard output without a name. False with an error text on failure.
bool write_output(const std::string& name, const std::string& text, std::string& error);

} // namespace app

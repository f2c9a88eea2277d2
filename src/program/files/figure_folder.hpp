// A folder of outputs whose names are known only at the end of a run.
#pragma once

#include "program/files/output_file.hpp"

#include <memory>
#include <set>
#include <string>
#include <vector>

namespace app {

// The folder is made at once if it is not there, and removed again if nothing was published. Every file
// follows OutputFile's rule, and ends with a comment of XML that has its name and a checksum. Functions return false with an
// error text on failure.
class FigureFolder {
public:
  FigureFolder() = default;
  ~FigureFolder();
  FigureFolder(const FigureFolder&) = delete;
  FigureFolder& operator=(const FigureFolder&) = delete;

  // Fails if the folder can neither be made nor written into.
  bool open(const std::string& folder, std::string& error);
  bool is_open() const { return !folder_.empty(); }
  bool add(const std::string& name, const std::string& text, std::string& error);
  // All files; finished and published by the caller with his others, who then calls keep().
  std::vector<OutputFile*> files() const;
  bool keep(std::string& error); // safely
  // Pictures that an earlier run has left and this one has not, as they would pass for pictures of this model. What is not as a
  // run wrote it stays.
  bool remove_earlier(std::string& error) const;

private:
  std::string folder_;
  bool made_ = false;
  std::set<std::string> names_;
  std::vector<std::unique_ptr<OutputFile>> files_;
};

} // namespace app

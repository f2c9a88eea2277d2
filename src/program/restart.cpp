#include "program/restart.hpp"

#include "program/estimate/kept.hpp"
#include "report/text.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <unistd.h>

namespace app {
namespace {

const char kDeck[] = "/deck.dat", kOptions[] = "/options", kPoints[] = "/points.csv", kMeshes[] = "/meshes",
           kFirstLine[] = "contact2d run 1";

bool fail(const std::string& path, const char* what, std::string& error) {
  error = path + ": " + what + ": " + std::strerror(errno);
  return false;
}

// Under its name only when it is whole, also after a power failure.
bool write_safely(const std::string& path, const std::string& text, std::string& error) {
  const std::string aside = path + ".new";
  const int file = ::open(aside.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) return fail(path, "cannot be written", error);
  size_t done = 0;
  while (done < text.size()) {
    const ssize_t put = ::write(file, text.data() + done, text.size() - done);
    if (put < 0 && errno == EINTR) continue;
    if (put <= 0) break;
    done += static_cast<size_t>(put);
  }
  const bool written = done == text.size() && ::fsync(file) == 0;
  const int code = errno;
  if (::close(file) == 0 && written && ::rename(aside.c_str(), path.c_str()) == 0) return true;
  if (!written) errno = code;
  return fail(path, "write failed", error);
}

bool read_whole(const std::string& path, std::string& text) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream out;
  out << file.rdbuf();
  text = out.str();
  return file.good();
}

// A value on one line: a line end in it is written as \n, a backslash twice.
std::string escaped(const std::string& value) {
  std::string out;
  for (char c : value) {
    if (c == '\\')
      out += "\\\\";
    else if (c == '\n')
      out += "\\n";
    else
      out += c;
  }
  return out;
}
std::string unescaped(const std::string& text) {
  std::string out;
  for (size_t i = 0; i < text.size(); ++i) {
    const bool pair = text[i] == '\\' && i + 1 < text.size();
    out += !pair ? text[i] : (text[i + 1] == 'n' ? '\n' : text[i + 1]);
    i += pair ? 1 : 0;
  }
  return out;
}

// Options whose value is no name of a file; store and memory are told in another way.
bool is_word(const std::string& name) {
  return name == "--stepping" || name == "--quadrature" || name == "--symmetry" || name == "--threads";
}
bool is_left_out(const std::string& name) {
  return name == "--store" || name == "--memory" || name == "--progress" || name == "--no-progress" || name == "--points" ||
         name == "--set"; // the deck that is kept is the sketch's own
}

std::string absolute(const std::string& name) {
  std::error_code failed;
  const std::filesystem::path path = std::filesystem::absolute(name, failed);
  return failed || name == "-" ? name : path.string();
}

} // namespace

bool leave_restart(const std::string& folder, const Options& options, const std::string& deck_name,
                   const std::string& deck_text, const std::string& points_text, const MeshLoop& meshes, uint64_t workspace,
                   std::string& error) {
  if (!remove_restart(folder, error) || !write_safely(folder + kDeck, deck_text, error)) return false;
  if (!options.points.empty() && !write_safely(folder + kPoints, points_text, error)) return false;
  if (meshes.ran() && !write_safely(folder + kMeshes, estimate::text_of(meshes), error)) return false;
  std::string text =
      std::string(kFirstLine) + "\ndeck=" + escaped(deck_name) + "\n--memory=" + std::to_string(workspace) + "\n";
  if (!options.points.empty()) text += "points\n";
  for (const auto& given : options.given) {
    if (is_left_out(given.first)) continue;
    text += given.first;
    if (!given.second.empty()) text += "=" + escaped(is_word(given.first) ? given.second : absolute(given.second));
    text += "\n";
  }
  return write_safely(folder + kOptions, text, error);
}

bool read_restart(Options& options, std::string& error) {
  const std::string folder = options.folder;
  std::string text, line;
  const bool found = read_whole(folder + kOptions, text);
  std::istringstream lines(text);
  if (!found || !std::getline(lines, line) || line != kFirstLine) {
    error = folder + ": holds no run that could go on (no file options, or of another version)";
    return false;
  }
  std::string shown = "deck.dat";
  std::vector<std::string> words = {"contact2d", "run"};
  while (std::getline(lines, line)) {
    if (line.compare(0, 5, "deck=") == 0)
      shown = unescaped(line.substr(5));
    else if (line == "points")
      words.push_back("--points=" + folder + kPoints);
    else
      words.push_back(unescaped(line));
  }
  words.insert(words.end(), {"--store=file:" + folder, "--", folder + kDeck});
  std::vector<const char*> arguments;
  for (const std::string& word : words) arguments.push_back(word.c_str());
  Options read;
  if (!read_options(static_cast<int>(arguments.size()), arguments.data(), read, error)) {
    error = folder + kOptions + ": " + error;
    return false;
  }
  read.deck_name = shown;
  read.folder = folder;
  read.resume = true;
  read.progress = options.progress;
  options = read;
  return true;
}

bool read_kept_meshes(const std::string& folder, MeshLoop& out, std::string& error) {
  const std::string path = folder + kMeshes;
  std::string text;
  if (!std::filesystem::exists(path)) return true;
  if (read_whole(path, text) && estimate::read_meshes(text, out)) return true;
  error = path + ": cannot be read, or is not whole";
  return false;
}

bool remove_restart(const std::string& folder, std::string& error) {
  for (const char* name : {kOptions, kDeck, kPoints, kMeshes}) {
    const std::string path = folder + name;
    for (const std::string& file : {path, path + ".new"})
      if (::unlink(file.c_str()) != 0 && errno != ENOENT) return fail(file, "cannot be removed", error);
  }
  return true;
}

} // namespace app

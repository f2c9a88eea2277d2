#include "tree.hpp"

#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>

namespace faults {
namespace fs = std::filesystem;

namespace {

std::string read_bytes(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

const char kAside[] = ".contact2d-";

std::string without_process(const std::string& path) {
  const size_t at = path.find(kAside);
  if (at == std::string::npos) return path;
  const size_t from = at + sizeof kAside - 1, to = path.find('-', from);
  return to == std::string::npos ? path : path.substr(0, from) + path.substr(to);
}

} // namespace

Tree take_tree(const std::string& folder) {
  Tree out;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    Entry& e = out[entry.path().string().substr(folder.size() + 1)];
    e.kind = entry.is_symlink() ? 'l' : entry.is_directory() ? 'd' : 'f';
    if (e.kind == 'l') e.bytes = fs::read_symlink(entry.path()).string();
    if (e.kind == 'f') e.bytes = read_bytes(entry.path());
  }
  return out;
}

void put_tree(const std::string& folder, const Tree& tree) {
  fs::remove_all(folder);
  fs::create_directories(folder);
  for (const auto& [path, entry] : tree) { // a folder comes before what is in it
    const std::string whole = folder + "/" + path;
    if (entry.kind == 'd') fs::create_directory(whole);
    if (entry.kind == 'l') fs::create_symlink(entry.bytes, whole);
    if (entry.kind == 'f') std::ofstream(whole, std::ios::binary) << entry.bytes;
  }
}

void add_file(Tree& tree, const std::string& path, const std::string& bytes) {
  for (size_t at = path.find('/'); at != std::string::npos; at = path.find('/', at + 1)) tree[path.substr(0, at)].kind = 'd';
  tree[path] = {'f', bytes};
}

const Entry* find(const Tree& tree, const std::string& path) {
  const auto at = tree.find(path);
  return at == tree.end() ? nullptr : &at->second;
}

bool is_below(const std::string& path, const std::string& folder) {
  if (folder.empty() || path.compare(0, folder.size(), folder) != 0) return false;
  return path.size() == folder.size() || path[folder.size()] == '/';
}

bool is_aside(const std::string& path) {
  const size_t slash = path.rfind('/');
  return path.compare(slash == std::string::npos ? 0 : slash + 1, sizeof kAside - 1, kAside) == 0;
}

size_t hash_of(const Tree& tree) {
  std::string all;
  for (const auto& [path, entry] : tree) {
    all += without_process(path) + '\0' + entry.kind + std::to_string(entry.bytes.size()) + '\0';
    all += entry.bytes;
  }
  return std::hash<std::string>()(all);
}

} // namespace faults

#include "disk.hpp"

#include <algorithm>

namespace faults {
namespace {

uint32_t roll(uint32_t& dice) {
  dice = dice * 1664525u + 1013904223u;
  return dice >> 16;
}

void change(std::string& bytes, bool sets_length, uint64_t offset, const std::string& data) {
  if (sets_length) {
    bytes.resize(static_cast<size_t>(offset), '\0');
    return;
  }
  const size_t from = static_cast<size_t>(offset);
  if (bytes.size() < from + data.size()) bytes.resize(from + data.size(), '\0');
  bytes.replace(from, data.size(), data);
}

} // namespace

Disk::Disk(const Tree& tree) : nodes_(1), names_(1) {
  nodes_[0].kind = 'd';
  for (const auto& [path, entry] : tree) nodes_[static_cast<size_t>(add(path, entry.kind))].safe = entry.bytes;
  changes_.clear();
  for (size_t i = 0; i < nodes_.size(); ++i) nodes_[i].names = names_[i];
}

int Disk::node_at(const std::string& path) const {
  int node = 0;
  for (size_t at = 0; at < path.size() && node != kNone;) {
    const size_t end = std::min(path.find('/', at), path.size());
    const auto& names = names_[static_cast<size_t>(node)];
    const auto found = names.find(path.substr(at, end - at));
    node = found == names.end() ? kNone : found->second;
    at = end + 1;
    // (the jobs have links in one folder only, to a neighbour)
    if (node != kNone && nodes_[static_cast<size_t>(node)].kind == 'l')
      node = node_at(path.substr(0, path.rfind('/') + 1) + nodes_[static_cast<size_t>(node)].safe);
  }
  return node;
}

int Disk::folder_of(const std::string& path, std::string& name) const {
  const size_t slash = path.rfind('/');
  name = slash == std::string::npos ? path : path.substr(slash + 1);
  return slash == std::string::npos ? 0 : node_at(path.substr(0, slash));
}

void Disk::name(const Rename& change) {
  for (const Name& n : change) {
    auto& names = names_[static_cast<size_t>(n.folder)];
    if (n.node == kNone)
      names.erase(n.name);
    else
      names[n.name] = n.node;
  }
  changes_.push_back(change);
}

int Disk::add(const std::string& path, char kind) {
  std::string own;
  const int folder = folder_of(path, own), node = static_cast<int>(nodes_.size());
  nodes_.emplace_back();
  names_.emplace_back();
  nodes_.back().kind = kind;
  if (folder == kNone) wrong_ = true;
  if (folder != kNone) name({{folder, own, node}});
  return node;
}

void Disk::remove(const std::string& path) {
  std::string own;
  const int folder = folder_of(path, own);
  if (folder == kNone) wrong_ = true;
  if (folder != kNone) name({{folder, own, kNone}});
}

void Disk::sync(int node) {
  Node& n = nodes_[static_cast<size_t>(node)];
  for (const Bytes& b : n.changes) change(n.safe, b.sets_length, b.offset, b.data);
  n.changes.clear();
  if (n.kind != 'd') return;
  n.names = names_[static_cast<size_t>(node)];
  std::vector<Rename> left;
  for (const Rename& r : changes_) {
    const bool touches = std::any_of(r.begin(), r.end(), [node](const Name& name) { return name.folder == node; });
    if (!touches) left.push_back(r);
    // Of a rename from one folder to another the other half is safe with it.
    for (const Name& name : r) {
      if (!touches || name.folder == node) continue;
      auto& safe = nodes_[static_cast<size_t>(name.folder)].names;
      if (name.node == kNone)
        safe.erase(name.name);
      else
        safe[name.name] = name.node;
    }
  }
  changes_ = left;
}

bool Disk::apply(const Record& r) {
  const auto file = open_.find(r.file);
  const int node = file == open_.end() ? kNone : file->second;
  if (r.error != 0 && r.op != OP_CLOSE) return false;
  switch (r.op) {
  case OP_OPEN: {
    const bool creates = (r.flags & OPENED_CREATES) != 0;
    const int opened = creates ? add(r.path, 'f') : node_at(r.path);
    open_[r.file] = opened;
    const bool truncates = (r.flags & OPENED_TRUNCATES) != 0 && opened != kNone;
    if (truncates) nodes_[static_cast<size_t>(opened)].changes.push_back({true, 0, ""});
    return creates || truncates;
  }
  case OP_WRITE:
    if (node == kNone) return false; // standard output
    nodes_[static_cast<size_t>(node)].changes.push_back({false, r.offset, r.data});
    return r.bytes > 0;
  case OP_TRUNCATE:
  case OP_RESERVE: {
    if (node == kNone) return false;
    uint64_t length = r.offset;
    if (r.op == OP_RESERVE) { // never shorter
      uint64_t now = nodes_[static_cast<size_t>(node)].safe.size();
      for (const Bytes& b : nodes_[static_cast<size_t>(node)].changes)
        now = b.sets_length ? b.offset : std::max(now, b.offset + b.data.size());
      length = std::max(length, now);
    }
    nodes_[static_cast<size_t>(node)].changes.push_back({true, length, ""});
    return true;
  }
  case OP_SYNC:
    if (node != kNone) sync(node);
    return node != kNone;
  case OP_CLOSE: open_.erase(r.file); return false;
  case OP_MKDIR: add(r.path, 'd'); return true;
  case OP_UNLINK:
  case OP_RMDIR: remove(r.path); return true;
  case OP_RENAME:
  case OP_LINK: {
    std::string from, to;
    const int from_folder = folder_of(r.path, from), to_folder = folder_of(r.path2, to), moved = node_at(r.path);
    if (from_folder == kNone || to_folder == kNone || moved == kNone) return wrong_ = true;
    if (r.op == OP_RENAME)
      name({{from_folder, from, kNone}, {to_folder, to, moved}});
    else
      name({{to_folder, to, moved}});
    return true;
  }
  default: return false;
  }
}

std::string Disk::bytes_of(const Node& node, Loss loss, uint32_t& dice) {
  std::string out = node.safe;
  size_t left = loss == Loss::kHalf ? node.changes.size() / 2 : node.changes.size();
  if (loss == Loss::kAllUnsynced || loss == Loss::kData || loss == Loss::kNewestEmpty) left = 0;
  for (size_t i = 0; i < left; ++i) {
    const Bytes& b = node.changes[i];
    std::string data = b.data;
    if (loss == Loss::kZeros) data.assign(data.size(), '\0');
    if (loss == Loss::kRandom) {
      const uint32_t side = roll(dice) % 6;
      if (side < 2) continue;                        // lost
      if (side == 2) data.resize(data.size() / 2);   // torn
      if (side == 3) data.assign(data.size(), '\0'); // the length alone
    }
    change(out, b.sets_length, b.offset, data);
  }
  if (loss == Loss::kHalf && left < node.changes.size() && !node.changes[left].sets_length) {
    const Bytes& b = node.changes[left];
    change(out, false, b.offset, b.data.substr(0, b.data.size() / 2));
  }
  return out;
}

void Disk::put(Tree& tree, const std::vector<std::map<std::string, int>>& names, int folder, const std::string& path, Loss loss,
               uint32_t& dice) const {
  for (const auto& [own, node] : names[static_cast<size_t>(folder)]) {
    const Node& n = nodes_[static_cast<size_t>(node)];
    const std::string whole = path.empty() ? own : path + "/" + own;
    Entry& entry = tree[whole];
    entry.kind = n.kind;
    entry.bytes = n.kind == 'f' ? bytes_of(n, loss, dice) : n.safe;
    if (n.kind == 'd') put(tree, names, node, whole, loss, dice);
  }
}

Tree Disk::after_crash(Loss loss, uint32_t seed) const {
  uint32_t dice = seed * 2654435761u + 12345u;
  std::vector<std::map<std::string, int>> names(nodes_.size());
  for (size_t i = 0; i < nodes_.size(); ++i) names[i] = nodes_[i].names;
  for (size_t i = 0; i < changes_.size(); ++i) {
    const bool last = std::none_of(changes_.begin() + static_cast<long>(i) + 1, changes_.end(),
                                   [&](const Rename& later) { return later.back().folder == changes_[i].back().folder; });
    bool there = loss != Loss::kAllUnsynced;
    if (loss == Loss::kEarlyNames || loss == Loss::kNewestEmpty) there = last;
    if (loss == Loss::kLateNames) there = !last;
    if (loss == Loss::kRandom) there = roll(dice) % 2 == 0;
    if (!there) continue;
    for (const Name& n : changes_[i])
      if (n.node == kNone)
        names[static_cast<size_t>(n.folder)].erase(n.name);
      else
        names[static_cast<size_t>(n.folder)][n.name] = n.node;
  }
  Tree tree;
  put(tree, names, 0, "", loss, dice);
  return tree;
}

} // namespace faults

#include "program/estimate/kept.hpp"

#include <charconv>

namespace estimate {
namespace {

// One list of members for writing and reading, a line each.
template <class Archive> void members(Archive& a, std::array<double, 2>& point) { a(point[0]), a(point[1]); }
template <class Archive> void members(Archive& a, app::MeshCurve& c) { a(c.body), a(c.closed), a(c.ends); }
template <class Archive> void members(Archive& a, app::Stated& s) {
  a(s.name), a(s.zone), a(s.body), a(s.item), a(s.value), a(s.error), a(s.scale), a(s.tolerance), a(s.at[0]), a(s.at[1]);
}
template <class Archive> void members(Archive& a, app::MeshRound& r) {
  a(r.elements), a(r.pairs), a(r.equations), a(r.seconds), a(r.pressure), a(r.energy), a(r.adapted), a(r.curves), a(r.stated);
}
template <class Archive> void members(Archive& a, app::MeshLoop& l) { a(l.rounds), a(l.taken), a(l.stated), a(l.stopped); }

class Writer {
public:
  template <class Number> void operator()(Number number) {
    char digits[32];
    text_.append(digits, std::to_chars(digits, digits + sizeof digits, number).ptr) += '\n';
  }
  void operator()(bool yes) { (*this)(yes ? 1 : 0); }
  void operator()(const std::string& words) { // by its length, as line ends may be in it
    (*this)(words.size());
    text_ += words + '\n';
  }
  template <class Item> void operator()(std::vector<Item>& list) {
    (*this)(list.size());
    for (Item& item : list) members(*this, item);
  }
  std::string take() { return std::move(text_); }

private:
  std::string text_;
};

class Reader {
public:
  explicit Reader(const std::string& text) : at_(text.data()), end_(text.data() + text.size()) {}
  template <class Number> void operator()(Number& number) {
    const std::from_chars_result read = std::from_chars(at_, end_, number);
    if (read.ec != std::errc()) fail();
    at_ = sound_ ? read.ptr : at_;
    end_line();
  }
  void operator()(bool& yes) {
    int number = 0;
    (*this)(number);
    yes = number == 1;
  }
  void operator()(std::string& words) {
    size_t size = 0;
    (*this)(size);
    if (size > left()) return fail();
    words.assign(at_, size);
    at_ += size;
    end_line();
  }
  template <class Item> void operator()(std::vector<Item>& list) {
    size_t size = 0;
    (*this)(size);
    if (size > left()) return fail(); // an item is a line at least
    list.resize(size);
    for (Item& item : list) members(*this, item);
  }
  bool is_sound_to_the_end() const { return sound_ && at_ == end_; }

private:
  size_t left() const { return static_cast<size_t>(end_ - at_); }
  void fail() { sound_ = false, at_ = end_; }
  void end_line() {
    if (left() == 0 || *at_ != '\n') return fail();
    ++at_;
  }
  const char *at_, *end_;
  bool sound_ = true;
};

} // namespace

std::string text_of(app::MeshLoop loop) {
  Writer writer;
  members(writer, loop);
  return writer.take();
}

bool read_meshes(const std::string& text, app::MeshLoop& out) {
  Reader reader(text);
  members(reader, out);
  return reader.is_sound_to_the_end() && (out.rounds.empty() || out.taken < out.rounds.size());
}

} // namespace estimate

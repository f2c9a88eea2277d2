// Numbers, words and lists as a text, one line each, read back with all bits. A struct declares its members once, for both
// directions:
//   template <class Archive> void members(Archive& a, Thing& thing) { a(thing.number), a(thing.list); }
// in the namespace of Thing.
#pragma once

#include <array>
#include <charconv>
#include <cstddef>
#include <cstring>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace app {

class ArchiveWriter {
public:
  template <class Thing> void operator()(Thing& thing) {
    if constexpr (std::is_same_v<Thing, bool>)
      digits(thing ? 1 : 0);
    else if constexpr (std::is_enum_v<Thing>)
      digits(static_cast<long long>(thing));
    else if constexpr (std::is_arithmetic_v<Thing>)
      digits(thing);
    else if constexpr (std::is_same_v<Thing, std::string>)
      words(thing);
    else
      members(*this, thing);
  }
  template <class Item> void operator()(std::vector<Item>& list) {
    digits(list.size());
    for (Item& item : list) (*this)(item);
  }
  template <class Item, size_t n> void operator()(Item (&list)[n]) {
    for (Item& item : list) (*this)(item);
  }
  std::string take() { return std::move(text_); }

private:
  void words(const std::string& text) { // with its length, because it may contain line ends
    digits(text.size());
    text_ += text;
    text_ += '\n';
  }
  template <class Number> void digits(Number number) {
    char text[32];
    text_.append(text, std::to_chars(text, text + sizeof text, number).ptr) += '\n';
  }
  std::string text_;
};

class ArchiveReader {
public:
  explicit ArchiveReader(const std::string& text) : at_(text.data()), end_(text.data() + text.size()) {}
  template <class Thing> void operator()(Thing& thing) {
    if constexpr (std::is_same_v<Thing, bool> || std::is_enum_v<Thing>) {
      long long number = 0;
      digits(number);
      thing = static_cast<Thing>(number);
    } else if constexpr (std::is_arithmetic_v<Thing>) {
      digits(thing);
    } else if constexpr (std::is_same_v<Thing, std::string>) {
      words(thing);
    } else {
      members(*this, thing);
    }
  }
  template <class Item> void operator()(std::vector<Item>& list) {
    size_t size = 0;
    digits(size);
    if (size > left()) return fail(); // an item is a line at least
    list.resize(size);
    for (Item& item : list) (*this)(item);
  }
  template <class Item, size_t n> void operator()(Item (&list)[n]) {
    for (Item& item : list) (*this)(item);
  }
  bool is_sound_to_the_end() const { return sound_ && at_ == end_; }

private:
  void words(std::string& text) {
    size_t size = 0;
    digits(size);
    if (size > left()) return fail();
    text.assign(at_, size);
    at_ += size;
    end_line();
  }
  size_t left() const { return static_cast<size_t>(end_ - at_); }
  void fail() { sound_ = false, at_ = end_; }
  void end_line() {
    if (left() == 0 || *at_ != '\n') return fail();
    ++at_;
  }
  template <class Number> void digits(Number& number) {
    const std::from_chars_result read = std::from_chars(at_, end_, number);
    if (read.ec != std::errc()) return fail();
    at_ = read.ptr;
    end_line();
  }
  const char *at_, *end_;
  bool sound_ = true;
};

template <class Archive, class Item, size_t n> void members(Archive& a, std::array<Item, n>& list) {
  for (Item& item : list) a(item);
}

} // namespace app

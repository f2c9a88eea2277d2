// A small reader of JSON, strict enough to refuse what is none.
#pragma once

#include <cstdlib>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace test {

struct Json {
  enum Kind { kNull, kBool, kNumber, kString, kArray, kObject } kind = kNull;
  double number = 0.0; // 1 of true
  std::string text;
  std::vector<Json> items;
  std::map<std::string, Json> members;

  bool has(const std::string& key) const { return members.count(key) == 1; }
  const Json& operator[](const std::string& key) const { return members.at(key); }
  const Json& operator[](size_t i) const { return items.at(i); }
};

class JsonReader {
public:
  // The value that the whole of `text` is; throws std::runtime_error if it is none.
  static Json read(const std::string& text) {
    JsonReader reader(text);
    Json value = reader.value();
    reader.blanks();
    if (reader.at_ != text.size()) reader.fail();
    return value;
  }

private:
  explicit JsonReader(const std::string& text) : text_(text) {}
  [[noreturn]] void fail() const { throw std::runtime_error("no JSON at byte " + std::to_string(at_)); }
  void blanks() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\n')) ++at_;
  }
  char peek() {
    blanks();
    if (at_ >= text_.size()) fail();
    return text_[at_];
  }
  void expect(char c) {
    if (peek() != c) fail();
    ++at_;
  }
  bool take(const std::string& word) {
    if (text_.compare(at_, word.size(), word) != 0) return false;
    at_ += word.size();
    return true;
  }
  std::string string() {
    expect('"');
    std::string out;
    while (at_ < text_.size() && text_[at_] != '"') {
      if (static_cast<unsigned char>(text_[at_]) < 32) fail();
      if (text_[at_] != '\\') {
        out += text_[at_++];
        continue;
      }
      const char c = at_ + 1 < text_.size() ? text_[at_ + 1] : '\0';
      at_ += 2;
      if (c == 'u') {
        if (at_ + 4 > text_.size()) fail();
        out += static_cast<char>(std::stoi(text_.substr(at_, 4), nullptr, 16));
        at_ += 4;
      } else if (c == '"' || c == '\\' || c == '/') {
        out += c;
      } else {
        fail();
      }
    }
    if (at_ >= text_.size()) fail();
    ++at_;
    return out;
  }
  Json value() {
    Json v;
    const char c = peek();
    if (c == '{') {
      v.kind = Json::kObject;
      ++at_;
      while (peek() != '}') {
        if (!v.members.empty()) expect(',');
        const std::string key = string();
        expect(':');
        if (!v.members.emplace(key, value()).second) fail(); // a key twice
      }
      ++at_;
    } else if (c == '[') {
      v.kind = Json::kArray;
      ++at_;
      while (peek() != ']') {
        if (!v.items.empty()) expect(',');
        v.items.push_back(value());
      }
      ++at_;
    } else if (c == '"') {
      v.kind = Json::kString;
      v.text = string();
    } else if (take("null")) {
      v.kind = Json::kNull;
    } else if (take("true")) {
      v.kind = Json::kBool;
      v.number = 1.0;
    } else if (take("false")) {
      v.kind = Json::kBool;
    } else {
      const char* begin = text_.c_str() + at_;
      if (c != '-' && (c < '0' || c > '9')) fail();
      char* end = nullptr;
      v.kind = Json::kNumber;
      v.number = std::strtod(begin, &end);
      at_ += static_cast<size_t>(end - begin);
    }
    return v;
  }

  const std::string& text_;
  size_t at_ = 0;
};

} // namespace test

// How objects and strings of JSON are written.
#pragma once

#include "report/text.hpp"

#include <cmath>
#include <cstdint>
#include <string>

namespace app {

// Members of an object one after another; `separator` puts the comma before all but the first.
class Object {
public:
  Object(std::string& out, const char* begin, const char* between) : out_(out), between_(between) { out_ += begin; }
  std::string& key(const char* name) {
    if (!first_) out_ += between_;
    first_ = false;
    out_ += '"';
    out_ += name;
    out_ += "\": ";
    return out_;
  }
  void number(const char* name, double value) {
    key(name);
    if (std::isfinite(value))
      append_number(out_, value);
    else
      out_ += "null"; // JSON knows no infinity
  }
  void integer(const char* name, int64_t value) { append_integer(key(name), value); }
  void bytes(const char* name, uint64_t value) { integer(name, static_cast<int64_t>(value)); }
  void word(const char* name, const char* text) { append_string(key(name), text); }

  static void append_string(std::string& out, const std::string& text) {
    static const char kHex[] = "0123456789abcdef";
    out += '"';
    for (size_t i = 0; i < text.size(); ++i) {
      const unsigned char c = static_cast<unsigned char>(text[i]);
      const size_t bytes = character_at(text, i);
      if (c == '"' || c == '\\') {
        out += '\\';
        out += text[i];
      } else if (bytes > 1) { // as it is: UTF-8
        out.append(text, i, bytes);
        i += bytes - 1;
      } else if (bytes == 0) {
        out += "\\u00";
        out += kHex[c >> 4];
        out += kHex[c & 15];
      } else {
        out += text[i];
      }
    }
    out += '"';
  }

private:
  std::string& out_;
  const char* between_;
  bool first_ = true;
};

} // namespace app

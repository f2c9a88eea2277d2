#include "tokens.hpp"

#include <algorithm>
#include <cctype>
#include <cstring>

namespace mutants {
namespace {

bool in_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

// Past white space, comments and lines of the preprocessor.
size_t skip(const std::string& s, size_t at) {
  while (at < s.size()) {
    const bool starts_line = at == 0 || s[at - 1] == '\n';
    if (starts_line && s[std::min(s.find_first_not_of(' ', at), s.size() - 1)] == '#') {
      do at = std::min(s.find('\n', at), s.size() - 1) + 1;
      while (at >= 2 && at < s.size() && s[at - 2] == '\\');
    } else if (std::isspace(static_cast<unsigned char>(s[at]))) {
      ++at;
    } else if (s.compare(at, 2, "//") == 0) {
      at = std::min(s.find('\n', at), s.size());
    } else if (s.compare(at, 2, "/*") == 0) {
      at = std::min(s.find("*/", at), s.size() - 2) + 2;
    } else {
      break;
    }
  }
  return at;
}

size_t end_of_quoted(const std::string& s, size_t at) {
  const char quote = s[at++];
  while (at < s.size() && s[at] != quote) at += s[at] == '\\' ? 2 : 1;
  return at + 1;
}

size_t end_of_number(const std::string& s, size_t at) {
  while (at < s.size()) {
    const bool exponent = (s[at] == '+' || s[at] == '-') && std::strchr("eEpP", s[at - 1]) != nullptr;
    if (!in_name(s[at]) && s[at] != '.' && s[at] != '\'' && !exponent) break;
    ++at;
  }
  return at;
}

size_t end_of_sign(const std::string& s, size_t at) {
  for (const char* known : {"<<=", ">>=", "...", "->", "++", "--", "<<", "<=", ">=", "==", "!=", "&&",
                            "||",  "+=",  "-=",  "*=", "/=", "%=", "&=", "|=", "^=", "::", ">>"})
    if (s.compare(at, std::strlen(known), known) == 0) return at + std::strlen(known);
  return at + 1;
}

Token next(const std::string& s, size_t at) {
  Token t{Token::sign, "", at, at, 0, false, false, -1, false};
  const bool digit = std::isdigit(static_cast<unsigned char>(s[at])) != 0;
  if (s[at] == '"' || s[at] == '\'') {
    t.kind = Token::text, t.to = end_of_quoted(s, at);
  } else if (digit || (s[at] == '.' && std::isdigit(static_cast<unsigned char>(s[at + 1])))) {
    t.kind = Token::number, t.to = end_of_number(s, at);
  } else if (in_name(s[at])) {
    t.kind = Token::name;
    while (in_name(s[t.to])) ++t.to;
  } else {
    t.to = end_of_sign(s, at);
  }
  t.is = s.substr(t.from, t.to - t.from);
  return t;
}

bool space_at(const std::string& s, size_t at) {
  return at >= s.size() || std::isspace(static_cast<unsigned char>(s[at])) != 0;
}

void split(const std::string& s, std::vector<Token>& out) {
  int line = 1;
  size_t counted = 0;
  for (size_t at = skip(s, 0); at < s.size(); at = skip(s, at)) {
    Token t = next(s, at);
    t.blank = at == 0 || space_at(s, at - 1);
    if (t.is == ">>" && !t.blank) t.is = ">", t.to = at + 1; // of templates
    t.blanks = t.blank && space_at(s, t.to);
    line += static_cast<int>(std::count(s.begin() + static_cast<long>(counted), s.begin() + static_cast<long>(at), '\n'));
    counted = at;
    t.line = line;
    out.push_back(t);
    at = t.to;
  }
}

void pair_brackets(std::vector<Token>& t) {
  std::vector<int> open;
  for (int i = 0; i < static_cast<int>(t.size()); ++i) {
    Token& now = t[static_cast<size_t>(i)];
    if (now.kind != Token::sign) continue;
    const bool angle = (now.is == "<" && !now.blanks) || (now.is == ">" && !now.blank);
    if (now.is == "(" || now.is == "[" || now.is == "{" || (angle && now.is == "<")) open.push_back(i);
    if ((now.is == ")" || now.is == "]" || now.is == "}" || (angle && now.is == ">")) && !open.empty()) {
      now.partner = open.back();
      t[static_cast<size_t>(open.back())].partner = i;
      open.pop_back();
    }
  }
}

// ---- what runs -----------------------------------------------------------------------------------------------------------

class Bodies {
public:
  explicit Bodies(std::vector<Token>& t) : t_(t) {}
  void mark() {
    for (int i = 0; i < size(); ++i)
      if (is(i, "{") && starts_function(i)) {
        if (!has(statement_start(i), i, "constexpr")) mark_body(i + 1, partner(i));
        i = partner(i);
      }
  }

private:
  std::vector<Token>& t_;
  int size() const { return static_cast<int>(t_.size()); }
  Token& at(int i) { return t_[static_cast<size_t>(i)]; }
  bool is(int i, const char* what) { return i >= 0 && i < size() && at(i).is == what; }
  int partner(int i) { return at(i).partner > i ? at(i).partner : size() - 1; }
  bool has(int from, int to, const char* what) {
    for (int i = from; i < to; ++i)
      if (is(i, what)) return true;
    return false;
  }
  bool starts_function(int i) { return is(i - 1, ")") || (is(i - 1, "const") && is(i - 2, ")")) || is(i - 1, "noexcept"); }
  int statement_start(int i) {
    while (i > 0 && !is(i - 1, ";") && !is(i - 1, "{") && !is(i - 1, "}")) --i;
    return i;
  }
  int semicolon(int i) {
    while (i < size() && !is(i, ";")) i = at(i).partner > i ? partner(i) + 1 : i + 1;
    return i;
  }
  static bool is_macro(const std::string& name) {
    return name.size() > 3 && std::none_of(name.begin(), name.end(), [](char c) { return c >= 'a' && c <= 'z'; });
  }
  // Constants do not run; nor, in this build, what is there for small code or for other machines.
  int end_of_constant(int i) {
    const std::string& word = at(i).is;
    if (word == "constexpr" && is(i - 1, "if")) return partner(i + 1) + 1;
    if (word == "constexpr" || word == "static_assert" || word == "enum" || word == "using") return semicolon(i);
    if (word == "sizeof" || word == "decltype" || word == "__attribute__" || word == "__builtin_shufflevector" ||
        word == "__builtin_prefetch" || (is_macro(word) && is(i + 1, "(")))
      return is(i + 1, "(") ? partner(i + 1) + 1 : i + 1;
    if (word == "if" && is(i + 2, "kSmallCode") && is(i + 3, ")")) return is(i + 4, "{") ? partner(i + 4) + 1 : semicolon(i);
    if (word == "case")
      while (!is(i, ":")) ++i;
    if (word == "<" && at(i).partner > i) return partner(i) + 1;
    return i;
  }
  void mark_body(int from, int to) {
    for (int i = from; i < to;) {
      const int end = end_of_constant(i);
      if (end == i)
        at(i++).inside = true;
      else
        i = end;
    }
  }
};

} // namespace

std::vector<Token> tokens_of(const std::string& source) {
  std::vector<Token> t;
  split(source, t);
  pair_brackets(t);
  Bodies(t).mark();
  return t;
}

} // namespace mutants

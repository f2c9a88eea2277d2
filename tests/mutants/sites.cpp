#include "sites.hpp"
#include "tokens.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

namespace mutants {
namespace {

// How tight a binary operator binds; 0: anything that ends an operand.
int rank(const std::string& op) {
  static const std::map<std::string, int> ranks = {{"||", 1}, {"&&", 2}, {"|", 3},  {"^", 4},  {"&", 5},  {"==", 6},
                                                   {"!=", 6}, {"<", 7},  {"<=", 7}, {">", 7},  {">=", 7}, {"<<", 8},
                                                   {">>", 8}, {"+", 9},  {"-", 9},  {"*", 10}, {"/", 10}, {"%", 10}};
  const auto found = ranks.find(op);
  return found == ranks.end() ? 0 : found->second;
}

bool ends_operand(const std::string& s) {
  static const std::set<std::string> ends = {
      ",", ";", "?", ":", "=", "+=", "-=", "*=", "/=", "%=", "|=", "&=", "^=", "<<=", ">>=", "return", "case", "else", "do"};
  return ends.count(s) != 0;
}

class Finder {
public:
  explicit Finder(const std::string& source) : source_(source), t_(tokens_of(source)) {}
  std::vector<Site> find() {
    for (int i = 1; i + 1 < static_cast<int>(t_.size()); ++i)
      if (at(i).inside) look(i);
    count_occurrences();
    return sites_;
  }

private:
  const std::string& source_;
  std::vector<Token> t_;
  std::vector<Site> sites_;

  const Token& at(int i) const { return t_[static_cast<size_t>(i)]; }
  bool binary(int i) const { return at(i).kind == Token::sign && at(i).blanks && at(i).partner < 0 && rank(at(i).is) > 0; }
  std::string tokens(int from, int to) const { // on one line, without comments
    std::string out = "(";
    for (int i = from; i <= to; ++i) out += (at(i).blank && i > from ? " " : "") + at(i).is;
    return out + ")";
  }

  // The first token of the left operand of the operator i, the last of the right one.
  int left(int i) const {
    const int own = rank(at(i).is);
    int j = i - 1;
    for (; j >= 0; --j) {
      if (at(j).partner >= 0 && at(j).partner < j) {
        j = at(j).partner;
        continue;
      }
      if (at(j).partner > j || ends_operand(at(j).is) || (binary(j) && rank(at(j).is) < own)) break;
    }
    return j + 1;
  }
  int right(int i, int own) const {
    int j = i + 1;
    for (; j < static_cast<int>(t_.size()); ++j) {
      if (at(j).partner > j) {
        j = at(j).partner;
        continue;
      }
      if (at(j).partner >= 0 || ends_operand(at(j).is) || (binary(j) && rank(at(j).is) <= own)) break;
    }
    return j - 1;
  }
  int end_of_unary(int i) const {
    while (at(i).is == "-" || at(i).is == "!" || at(i).is == "*" || at(i).is == "+") ++i;
    const bool group = at(i).partner > i;
    if (group) i = at(i).partner;
    const bool cast = group && !at(i + 1).blank && (at(i + 1).kind != Token::sign || at(i + 1).is == "(");
    if (cast) return end_of_unary(i + 1);
    for (;;) {
      const Token& next = at(i + 1);
      if (next.partner > i + 1 && !next.blank)
        i = next.partner;
      else if (next.is == "." || next.is == "->" || next.is == "::")
        i += 2;
      else
        return i;
    }
  }

  void add(int first, int last, int op, const std::string& kind, const std::string& changed) {
    const size_t begin = source_.rfind('\n', at(op).from) + 1; // (npos + 1 is 0)
    std::string text = source_.substr(begin, source_.find('\n', begin) - begin);
    text.erase(0, text.find_first_not_of(' '));
    sites_.push_back({at(first).from, at(last).to, at(op).line, kind, changed, text, 0});
  }

  void look(int i) {
    const Token& t = at(i);
    if (binary(i))
      look_at_binary(i);
    else if (t.is == "+=" || t.is == "-=" || t.is == "*=" || t.is == "/=")
      look_at_assignment(i);
    else if (t.is == "-" && !t.blanks && t.kind == Token::sign)
      look_at_minus(i);
    else if (t.is == "[" && t.partner > i + 1)
      look_at_index(i);
    else if (t.kind == Token::number)
      look_at_number(i);
  }

  void look_at_binary(int i) {
    const std::string op = at(i).is;
    const int from = left(i), to = right(i, rank(op));
    if (from >= i || to <= i) return;
    const std::string l = tokens(from, i - 1), r = tokens(i + 1, to);
    const auto becomes = [&](const std::string& other) {
      add(from, to, i, op + " becomes " + other, l + " " + other + " " + r);
    };
    const auto dropped = [&] { add(from, to, i, "term after " + op + " dropped", l); };
    static const std::map<std::string, std::string> others = {{"+", "-"},   {"-", "+"},   {"*", "/"},   {"/", "*"},
                                                              {"==", "!="}, {"!=", "=="}, {"&&", "||"}, {"||", "&&"}};
    static const std::map<std::string, std::string> bounds = {{"<", "<="}, {"<=", "<"}, {">", ">="}, {">=", ">"}};
    if (others.count(op)) becomes(others.at(op));
    if (op == "+" || op == "-" || op == "&&" || op == "||") dropped();
    if (bounds.count(op)) {
      const std::string& other = bounds.at(op);
      const bool zero = to == i + 1 && (at(to).is == "0.0" || at(to).is == "0");
      if (zero)
        becomes(other);
      else
        add(from, to, i, op + " becomes " + other, "C2D_BOUND(" + l + ", " + op + ", " + other + ", " + r + ")");
    }
  }

  void look_at_assignment(int i) {
    const int to = right(i, 0);
    if (to <= i) return;
    const std::string e = tokens(i + 1, to), op = at(i).is;
    if (op == "+=" || op == "-=") {
      add(i + 1, to, i, op + (op == "+=" ? " becomes -=" : " becomes +="), "-" + e);
      add(i + 1, to, i, "term after " + op + " dropped", "c2d_zero" + e);
    } else {
      add(i + 1, to, i, op + (op == "*=" ? " becomes /=" : " becomes *="), "1 / " + e);
    }
  }

  void look_at_minus(int i) {
    const Token& before = at(i - 1);
    const bool operand = before.kind == Token::number || (before.kind == Token::name && before.is != "return") ||
                         before.is == ")" || before.is == "]";
    if (operand) return;
    const int to = end_of_unary(i + 1);
    add(i, to, i, "- dropped", tokens(i + 1, to));
  }

  // double x[4], y[4]: more room changes nothing.
  bool declares(int i) const {
    int first = i;
    for (; first > 0 && at(first - 1).is != ";" && at(first - 1).is != "{" && at(first - 1).is != "}"; --first)
      if (at(first).is == "=" || at(first).is == "(") return false;
    if (at(first).is == "const" || at(first).is == "static") ++first;
    return at(first).kind == Token::name && at(first).is != "return" && at(first + 1).kind == Token::name;
  }
  void look_at_index(int i) {
    const Token& before = at(i - 1);
    if (before.kind != Token::name && before.is != "]" && before.is != ")") return;
    if (declares(i)) return;
    const std::string e = tokens(i + 1, at(i).partner - 1);
    add(i + 1, at(i).partner - 1, i, "index + 1", e + " + 1");
    add(i + 1, at(i).partner - 1, i, "index - 1", e + " - 1");
  }

  void look_at_number(int i) {
    const std::string& n = at(i).is;
    if (at(i - 1).is == "[" && at(i + 1).is == "]") return; // an index
    if (at(i - 1).is == "-" && !at(i - 1).blanks) return;
    if (at(i - 1).is == "[" || at(i + 1).is == "]") {
      int open = i; // of an index or of the size of an array
      while (at(open).is != "[") --open;
      if (declares(open)) return;
    }
    const bool plain = n.size() < 9 &&
                       std::all_of(n.begin(), n.end(), [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; });
    if (plain) {
      add(i, i, i, n + " becomes " + n + " + 1", std::to_string(std::stol(n) + 1));
      if (n != "0") add(i, i, i, n + " becomes " + n + " - 1", std::to_string(std::stol(n) - 1));
    } else if (n.find('.') != std::string::npos && n.find('x') == std::string::npos) {
      add(i, i, i, n + " becomes " + n + " + 1", n + " + 1");
      if (n != "0.0") add(i, i, i, n + " becomes -" + n, "-" + n);
    }
  }

  void count_occurrences() {
    std::map<std::pair<std::string, std::string>, int> seen;
    for (Site& s : sites_) s.occurrence = ++seen[{s.text, s.kind}];
  }
};

// ---- writing ---------------------------------------------------------------------------------------------------------------

int line_at(const std::string& source, size_t at) {
  return 1 + static_cast<int>(std::count(source.begin(), source.begin() + static_cast<long>(at), '\n'));
}

class Writer {
public:
  Writer(const std::string& source, const std::vector<Site>& sites, const std::vector<int>& numbers) : source_(source) {
    for (size_t i = 0; i < sites.size(); ++i) order_.push_back({&sites[i], numbers[i]});
    std::stable_sort(order_.begin(), order_.end(), [](const Numbered& a, const Numbered& b) {
      return a.site->from != b.site->from ? a.site->from < b.site->from : a.site->to > b.site->to;
    });
  }
  std::string write() { return part(0, source_.size(), 0); }

private:
  struct Numbered {
    const Site* site;
    int number;
  };
  const std::string& source_;
  std::vector<Numbered> order_;
  size_t next_ = 0;

  // Messages about a site name its number as their line, others the line of the source.
  std::string part(size_t from, size_t to, int around) {
    std::string out;
    while (next_ < order_.size() && order_[next_].site->from >= from && order_[next_].site->to <= to) {
      const Numbered now = order_[next_++];
      const std::string number = std::to_string(now.number);
      out += source_.substr(from, now.site->from - from);
      out +=
          "\n#line " + std::to_string(kLineOfSites + now.number) + "\n(c2d_is(" + number + ") ? " + now.site->changed + " : (";
      out += part(now.site->from, now.site->to, now.number) + "))";
      out += "\n#line " + std::to_string(around ? kLineOfSites + around : line_at(source_, now.site->to)) + "\n";
      from = now.site->to;
    }
    return out + source_.substr(from, to - from);
  }
};

} // namespace

std::string Site::shown() const { return kind + (occurrence > 1 ? " (" + std::to_string(occurrence) + ")" : ""); }

std::vector<Site> sites_of(const std::string& source) { return Finder(source).find(); }

std::string with_sites(const std::string& source, const std::vector<Site>& chosen, const std::vector<int>& numbers) {
  return Writer(source, chosen, numbers).write();
}

} // namespace mutants

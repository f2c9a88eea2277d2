#include "program/sketch/read/expression.hpp"

#include "program/words/near_word.hpp"

#include <cctype>
#include <charconv>
#include <cmath>

namespace sketch {
namespace {

// The chain rule: f(a) from f, f' and f'' at a.v.
Jet chain(const Jet& a, double f, double f1, double f2) { return {f, f1 * a.d, f2 * a.d * a.d + f1 * a.dd}; }

Jet add(const Jet& a, const Jet& b) { return {a.v + b.v, a.d + b.d, a.dd + b.dd}; }
Jet negate(const Jet& a) { return {-a.v, -a.d, -a.dd}; }
Jet subtract(const Jet& a, const Jet& b) { return add(a, negate(b)); }
Jet multiply(const Jet& a, const Jet& b) { return {a.v * b.v, a.d * b.v + a.v * b.d, a.dd * b.v + 2 * a.d * b.d + a.v * b.dd}; }
Jet invert(const Jet& a) { return chain(a, 1 / a.v, -1 / (a.v * a.v), 2 / (a.v * a.v * a.v)); }
Jet divide(const Jet& a, const Jet& b) { return multiply(a, invert(b)); }
Jet exponential(const Jet& a) { return chain(a, std::exp(a.v), std::exp(a.v), std::exp(a.v)); }
Jet logarithm(const Jet& a) { return chain(a, std::log(a.v), 1 / a.v, -1 / (a.v * a.v)); }
Jet power(const Jet& a, const Jet& b) {
  if (b.d != 0 || b.dd != 0) return exponential(multiply(b, logarithm(a)));
  const double n = b.v; // 0^n has derivatives where n is 0 or 1
  const double f1 = n == 0 ? 0 : n * std::pow(a.v, n - 1), f2 = n == 0 || n == 1 ? 0 : n * (n - 1) * std::pow(a.v, n - 2);
  return chain(a, std::pow(a.v, n), f1, f2);
}
Jet square_root(const Jet& a) {
  const double r = std::sqrt(a.v);
  return a.d == 0 && a.dd == 0 ? Jet{r, 0, 0} : chain(a, r, 0.5 / r, -0.25 / (r * a.v));
}
Jet sine(const Jet& a) { return chain(a, std::sin(a.v), std::cos(a.v), -std::sin(a.v)); }
Jet cosine(const Jet& a) { return chain(a, std::cos(a.v), -std::sin(a.v), -std::cos(a.v)); }
Jet tangent(const Jet& a) { return divide(sine(a), cosine(a)); }
Jet arc_tangent(const Jet& a) {
  const double q = 1 + a.v * a.v;
  return chain(a, std::atan(a.v), 1 / q, -2 * a.v / (q * q));
}
Jet arc_sine(const Jet& a) {
  const double r = std::sqrt(1 - a.v * a.v);
  return a.d == 0 && a.dd == 0 ? Jet{std::asin(a.v), 0, 0} : chain(a, std::asin(a.v), 1 / r, a.v / (r * r * r));
}
Jet arc_cosine(const Jet& a) { return subtract({std::acos(a.v), 0, 0}, subtract(arc_sine(a), {std::asin(a.v), 0, 0})); }
Jet absolute(const Jet& a) { return a.v < 0 ? negate(a) : a; }
Jet whole(const Jet& a) { return {std::floor(a.v), 0, 0}; }
Jet lesser(const Jet& a, const Jet& b) { return a.v < b.v ? a : b; }
Jet greater(const Jet& a, const Jet& b) { return a.v > b.v ? a : b; }
Jet angle_of(const Jet& y, const Jet& x) { // derivatives are those of atan(y/x), in any quadrant
  Jet out = std::fabs(x.v) > std::fabs(y.v) ? arc_tangent(divide(y, x)) : negate(arc_tangent(divide(x, y)));
  out.v = std::atan2(y.v, x.v);
  return out;
}

struct Function {
  const char* name;
  int arguments;
  Jet (*one)(const Jet&);
  Jet (*two)(const Jet&, const Jet&);
};
const Function kFunctions[] = {{"sin", 1, sine, nullptr},         {"cos", 1, cosine, nullptr},
                               {"tan", 1, tangent, nullptr},      {"asin", 1, arc_sine, nullptr},
                               {"acos", 1, arc_cosine, nullptr},  {"atan", 1, arc_tangent, nullptr},
                               {"sqrt", 1, square_root, nullptr}, {"exp", 1, exponential, nullptr},
                               {"log", 1, logarithm, nullptr},    {"abs", 1, absolute, nullptr},
                               {"atan2", 2, nullptr, angle_of},   {"min", 2, nullptr, lesser},
                               {"max", 2, nullptr, greater},      {"floor", 1, whole, nullptr},
                               {"-", 1, negate, nullptr},         {"+", 2, nullptr, add},
                               {"-", 2, nullptr, subtract},       {"*", 2, nullptr, multiply},
                               {"/", 2, nullptr, divide},         {"^", 2, nullptr, power}};

int find_function(const std::string& name, int arguments) { // 0: any number
  for (int i = 0; i < static_cast<int>(std::size(kFunctions)); ++i)
    if (name == kFunctions[i].name && (arguments == 0 || arguments == kFunctions[i].arguments)) return i;
  return -1;
}

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

} // namespace

class Parser {
public:
  Parser(const Word& word, const Parameters& parameters, const Expression::Variables& variables,
         std::vector<Expression::Step>& steps)
      : word_(word), parameters_(parameters), variables_(variables), steps_(steps) {}
  void read() {
    sum();
    if (at_ < word_.text.size()) fail(at_, at_, "expected an operator");
  }

private:
  struct Depth { // nesting of brackets, signs and exponents
    explicit Depth(Parser& p) : parser(p) {
      if (++parser.depth_ > 100) parser.fail(parser.at_, parser.at_, "expected at most 100 nested brackets");
    }
    ~Depth() { --parser.depth_; }
    Parser& parser;
  };
  [[noreturn]] void fail(size_t first, size_t last, const std::string& text) const {
    const int begin = word_.at.column + (word_.quoted ? 1 : 0);
    throw Fault{{word_.at.line, begin + static_cast<int>(first), begin + static_cast<int>(last)},
                in_quotes(word_.text) + ": " + text};
  }
  char peek() {
    while (at_ < word_.text.size() && (word_.text[at_] == ' ' || word_.text[at_] == '\t')) ++at_;
    return at_ < word_.text.size() ? word_.text[at_] : '\0';
  }
  bool accept(char c) {
    if (peek() != c) return false;
    ++at_;
    return true;
  }
  void apply(const std::string& name, int arguments) {
    steps_.push_back({Expression::Step::kFunction, 0, find_function(name, arguments)});
  }
  void sum() {
    product();
    for (char c = peek(); c == '+' || c == '-'; c = peek()) {
      ++at_;
      product();
      apply(std::string(1, c), 2);
    }
  }
  void product() {
    factor();
    for (char c = peek(); c == '*' || c == '/'; c = peek()) {
      ++at_;
      factor();
      apply(std::string(1, c), 2);
    }
  }
  void factor() { // -2^2 is -(2^2)
    const Depth depth(*this);
    if (accept('+')) return factor();
    if (accept('-')) {
      factor();
      return apply("-", 1);
    }
    primary();
    if (!accept('^')) return;
    factor();
    apply("^", 2);
  }
  void primary() {
    const char c = peek();
    if (c == '(' || c == '{') {
      ++at_;
      sum();
      if (peek() == ',') fail(at_, at_, "a bracket contains one value, expected no comma");
      if (!accept(c == '(' ? ')' : '}')) fail(at_, at_, "expected a closing bracket");
    } else if (is_digit(c) || c == '.') {
      number();
    } else if (is_letter(c)) {
      name();
    } else {
      fail(at_, at_, "expected a number or a name");
    }
  }
  void number() {
    double value = 0;
    const char* const begin = word_.text.data() + at_;
    const auto result = std::from_chars(begin, word_.text.data() + word_.text.size(), value);
    const size_t length = static_cast<size_t>(result.ptr - begin);
    if (result.ec != std::errc())
      fail(at_, at_ + (length > 0 ? length - 1 : 0), "expected a number in the range of double precision");
    at_ += length;
    steps_.push_back({Expression::Step::kConstant, value, 0});
  }
  void name() {
    const size_t first = at_;
    while (at_ < word_.text.size() && (is_letter(word_.text[at_]) || is_digit(word_.text[at_]))) ++at_;
    const std::string name = word_.text.substr(first, at_ - first);
    if (peek() == '(') return call(name, first);
    const auto known = parameters_.find(name);
    if (name == variables_[0] || name == variables_[1])
      steps_.push_back({Expression::Step::kVariable, 0, name == variables_[0] ? 0 : 1});
    else if (known != parameters_.end())
      steps_.push_back({Expression::Step::kConstant, known->second, 0});
    else if (name == "pi" || name == "deg")
      steps_.push_back({Expression::Step::kConstant, std::acos(-1.0) / (name == "pi" ? 1 : 180), 0});
    else if (name == "inf")
      steps_.push_back({Expression::Step::kConstant, HUGE_VAL, 0});
    else
      unknown(name, first);
  }
  void unknown(const std::string& name, size_t first) {
    std::vector<std::string> names;
    for (const auto& parameter : parameters_) names.push_back(parameter.first);
    const std::string near = app::did_you_mean(name, names);
    fail(first, at_ - 1,
         "no parameter is called " + in_quotes(name) +
             (near.empty() ? ", expected a number, a parameter or an expression of them" : near));
  }
  void call(const std::string& name, size_t first) {
    const int index = find_function(name, 0);
    if (index < 0) fail(first, first + name.size() - 1, "no function is called " + in_quotes(name));
    accept('(');
    sum();
    for (int i = 1; i < kFunctions[index].arguments; ++i) {
      if (!accept(',')) fail(at_, at_, in_quotes(name) + " has two arguments, expected a comma between them");
      sum();
    }
    if (!accept(')')) fail(at_, at_, "expected a closing bracket");
    steps_.push_back({Expression::Step::kFunction, 0, index});
  }

  const Word& word_;
  const Parameters& parameters_;
  const Expression::Variables& variables_;
  std::vector<Expression::Step>& steps_;
  size_t at_ = 0;
  int depth_ = 0;
};

Expression::Expression(const Word& word, const Parameters& parameters, const Variables& variables) {
  Parser(word, parameters, variables, steps_).read();
}

bool Expression::varies() const {
  for (const Step& step : steps_)
    if (step.kind == Step::kVariable) return true;
  return false;
}

Jet Expression::result(const Jet& first, const Jet& second) const {
  std::vector<Jet> stack;
  for (const Step& step : steps_) {
    if (step.kind == Step::kConstant) stack.push_back({step.value, 0, 0});
    if (step.kind == Step::kVariable) stack.push_back(step.index == 0 ? first : second);
    if (step.kind != Step::kFunction) continue;
    const Function& f = kFunctions[step.index];
    const Jet last = stack.back();
    stack.pop_back();
    if (f.arguments == 1) {
      stack.push_back(f.one(last));
    } else {
      stack.back() = f.two(stack.back(), last);
    }
  }
  return stack.back();
}

} // namespace sketch

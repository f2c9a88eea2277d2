#include "program/sketch/read/statement.hpp"

#include "program/sketch/deck/deck_number.hpp"
#include "program/words/near_word.hpp"

#include <cctype>
#include <cmath>
#include <limits>
#include <sstream>

namespace sketch {

bool Statement::is_next(const char* word, size_t ahead) const {
  return next_ + ahead < words_.size() && words_[next_ + ahead].is(word);
}

bool Statement::is_number(size_t ahead) const { return next_ + ahead < words_.size() && begins_number(words_[next_ + ahead]); }

bool Statement::is_side() const {
  return has_more() && !words_[next_].quoted && words_[next_].text.find('.') != std::string::npos && !is_number();
}

bool Statement::accept(const char* word) {
  if (!is_next(word)) return false;
  ++next_;
  return true;
}

// May a word begin an expression: a digit, a sign, a bracket, a parameter or a function?
bool Statement::begins_number(const Word& word) const {
  if (word.quoted || word.text.empty()) return false;
  const char c = word.text[0];
  if (std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-' || c == '+' || c == '(' || c == '{') return true;
  size_t end = 0;
  while (end < word.text.size() && (std::isalnum(static_cast<unsigned char>(word.text[end])) != 0 || word.text[end] == '_'))
    ++end;
  const std::string name = word.text.substr(0, end);
  return parameters_.count(name) > 0 || name == "pi" || name == "inf" || (end < word.text.size() && word.text[end] == '(');
}

bool Statement::accept_number(double& value) {
  if (!is_number()) return false;
  value = number("a number");
  return true;
}

const Word& Statement::take(const std::string& expected) {
  if (!has_more()) missing(expected);
  return words_[next_++];
}

std::string Statement::name(const std::string& expected) {
  const Word& word = take(expected);
  bool fits = !word.text.empty() && std::isalpha(static_cast<unsigned char>(word.text[0])) != 0;
  for (const char c : word.text) fits = fits && (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-');
  if (!fits || word.quoted) throw Fault{word.at, in_quotes(word.text) + ": expected " + expected};
  return word.text;
}

double Statement::number(const std::string& what, bool may_be_infinite) {
  const Expression expression = arithmetic(what, {});
  return may_be_infinite && std::isinf(expression.value()) ? expression.value() : finite(expression, what);
}

Expression Statement::field(const std::string& what) {
  const auto free = [this](const char* name) { return parameters_.count(name) > 0 ? std::string() : std::string(name); };
  Expression value = arithmetic(what, {free("x"), free("y")});
  if (!value.varies()) finite(value, what);
  return value;
}

Expression Statement::arithmetic(const std::string& what, const Expression::Variables& variables) {
  const Word& word = take(what);
  if (!begins_number(word)) throw Fault{word.at, in_quotes(word.text) + ": expected " + what + like_parameter(word)};
  return Expression(word, parameters_, variables);
}

// ", did you mean 'load'?"; empty for short words, which are like many.
std::string Statement::like_parameter(const Word& word) const {
  if (word.quoted || word.text.size() < 3) return "";
  std::vector<std::string> names;
  for (const auto& parameter : parameters_) names.push_back(parameter.first);
  return app::did_you_mean(word.text, names);
}

double Statement::finite(const Expression& expression, const std::string& what) const {
  const double value = expression.value();
  if (!std::isfinite(value)) fail(in_quotes(words_[next_ - 1].text) + " is not a finite number, expected " + what);
  if (std::fabs(value) >= kMostInDeck)
    fail(in_quotes(words_[next_ - 1].text) + " is too large, expected a magnitude below 1e100: " + what);
  return std::fabs(value) < std::numeric_limits<double>::min() ? 0.0 : value; // as in decks
}

double Statement::positive(const std::string& what) {
  const double value = number(what);
  if (!(value > 0)) fail(show(value) + ": expected " + what + ", above 0");
  return value;
}

int Statement::whole(const std::string& what, int least, int most) {
  const double value = number(what);
  if (!(value >= least && value <= most) || value != static_cast<int>(value))
    fail(show(value) + ": expected " + what + ", a whole number from " + std::to_string(least) + " to " + std::to_string(most));
  return static_cast<int>(value);
}

bool Statement::is_share() const {
  if (!is_number()) return false;
  return words_[next_].text.back() == '%' || is_next("%", 1);
}

double Statement::share(const std::string& what) {
  const bool glued = is_share() && words_[next_].text.back() == '%';
  if (glued) words_[next_].text.pop_back(), --words_[next_].at.end;
  const double value = number(what);
  return glued || accept("%") ? value / 100 : value;
}

Point Statement::point(const std::string& what) {
  const double x = number("x of " + what);
  return {x, number("y of " + what)};
}

Expression Statement::formula(const std::string& what, const std::string& variable) {
  return Expression(take(what), parameters_, {variable, ""});
}

size_t Statement::choice(const std::vector<const char*>& words) {
  std::string expected;
  for (const char* word : words) expected += (expected.empty() ? "" : word == words.back() ? " or " : ", ") + std::string(word);
  const Word& word = take(expected);
  size_t index = 0;
  for (const char* one : words) {
    if (word.is(one)) return index;
    ++index;
  }
  constexpr size_t kTooShort = 3; // two letters make any other word of one that is no longer
  const std::vector<std::string> known(words.begin(), words.end());
  const std::string meant = word.text.size() > kTooShort ? app::did_you_mean(word.text, known) : "";
  throw Fault{word.at, in_quotes(word.text) + ": expected " + expected + meant};
}

bool Statement::accept_phrase(const std::string& phrase) {
  std::istringstream in(phrase);
  size_t ahead = 0;
  for (std::string word; in >> word; ++ahead)
    if (!is_next(word.c_str(), ahead)) return false;
  next_ += ahead;
  return ahead > 0;
}

bool Statement::accept_prefix(const std::string& mark) {
  if (!has_more() || words_[next_].quoted || words_[next_].text.compare(0, mark.size(), mark) != 0) return false;
  words_[next_].text.erase(0, mark.size());
  words_[next_].at.column += static_cast<int>(mark.size());
  return true;
}

void Statement::divide_at(const std::string& mark) {
  if (!has_more() || words_[next_].quoted) return;
  const Word whole = words_[next_];
  int depth = 0;
  size_t at = 0;
  for (; at < whole.text.size(); ++at) {
    const char c = whole.text[at];
    depth += c == '(' || c == '{' ? 1 : c == ')' || c == '}' ? -1 : 0;
    if (at > 0 && depth == 0 && whole.text.compare(at, mark.size(), mark) == 0) break;
  }
  if (at >= whole.text.size()) return;
  const int first = whole.at.column + static_cast<int>(at), behind = first + static_cast<int>(mark.size());
  const int line = whole.at.line;
  std::vector<Word> parts{{whole.text.substr(0, at), {line, whole.at.column, first - 1}, false},
                          {mark, {line, first, behind - 1}, false}};
  const std::string after = whole.text.substr(at + mark.size());
  if (!after.empty()) parts.push_back({after, {line, behind, whole.at.end}, false});
  const auto place = words_.erase(words_.begin() + static_cast<std::ptrdiff_t>(next_));
  words_.insert(place, parts.begin(), parts.end());
}

std::string Statement::rest() {
  std::string out;
  for (; has_more(); ++next_) out += (out.empty() ? "" : " ") + words_[next_].text;
  return out;
}

void Statement::end() const {
  if (has_more())
    throw Fault{words_[next_].at, in_quotes(words_[next_].text) + " is not expected here: the statement is complete before it"};
}

void Statement::missing(const std::string& expected) const {
  if (has_more()) throw Fault{words_[next_].at, in_quotes(words_[next_].text) + ": expected " + expected};
  const Place last = words_.back().at;
  throw Fault{{last.line, last.end + 1, last.end + 1}, "the statement ends here, expected " + expected};
}

void Statement::fail(const std::string& text) const { throw Fault{words_[next_ - 1].at, text}; }

} // namespace sketch

// A statement that is being read: its words in turn, and what is expected where one is missing or wrong.
#pragma once

#include "program/sketch/shape.hpp"

#include <initializer_list>
#include <optional>

namespace sketch {

class Statement {
public:
  Statement(std::vector<Word> words, const Parameters& parameters) : words_(std::move(words)), parameters_(parameters) {}
  const Word& keyword() const { return words_.front(); }
  Place at() const { return keyword().at; }

  bool has_more() const { return next_ < words_.size(); }
  bool is_next(const char* word, size_t ahead = 0) const;
  bool accept(const char* word);          // takes it if it is next
  bool is_number(size_t ahead = 0) const; // is the next word one, or one behind it?
  bool accept_number(double& value);
  const Word& take(const std::string& expected);
  std::string name(const std::string& expected); // a letter first, then letters, digits, _ and -
  double number(const std::string& what, bool may_be_infinite = false);
  double positive(const std::string& what);
  int whole(const std::string& what, int least, int most);
  bool is_share() const;                 // is the next word a number in percent?
  double share(const std::string& what); // a number, or one in percent: `1 %`, `1%`, 0.01
  Point point(const std::string& what);
  Expression formula(const std::string& what, const std::string& variable);
  Expression field(const std::string& what); // a number, or a formula of x and y, unless parameters are called so
  // One of these words, by its index.
  size_t choice(std::initializer_list<const char*> words);
  std::string rest(); // what is left, as it was written, with a blank between two words
  void end() const;   // nothing more is expected

  [[noreturn]] void missing(const std::string& expected) const; // at the next word, or where the statement ends
  [[noreturn]] void fail(const std::string& text) const;        // at the last word that was taken
  const Parameters& parameters() const { return parameters_; }

private:
  Expression arithmetic(const std::string& what, const Expression::Variables& variables);
  double finite(const Expression& expression, const std::string& what) const;
  bool begins_number(const Word& word) const;
  std::vector<Word> words_;
  size_t next_ = 1;
  const Parameters& parameters_;
};

} // namespace sketch

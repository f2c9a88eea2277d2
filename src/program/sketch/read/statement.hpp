// The words of a statement being read, with errors for missing and wrong ones.
#pragma once

#include "program/sketch/shapes/shape.hpp"

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
  bool is_side() const;                        // does the next word have a dot that is not in a number: body.curve?
  bool accept(const char* word);               // takes the word if it is next
  bool accept_prefix(const std::string& mark); // takes the mark off the next word if more follows it there
  const Place& last() const { return words_[next_ - 1].at; } // of the last word taken
  bool accept_phrase(const std::string& phrase);             // the same of words with blanks between them
  bool is_number(size_t ahead = 0) const;                    // may the next word, or a later one, begin an expression?
  bool accept_number(double& value);
  const Word& take(const std::string& expected);
  std::string name(const std::string& expected); // a letter first, then letters, digits, _ and -
  double number(const std::string& what, bool may_be_infinite = false);
  double positive(const std::string& what);
  int whole(const std::string& what, int least, int most);
  bool is_share() const;                 // is the next value in percent?
  double share(const std::string& what); // a number or a percentage: `1 %`, `1%`, 0.01
  Point point(const std::string& what);
  Expression formula(const std::string& what, const std::string& variable);
  Expression field(const std::string& what); // a number or a formula of x and y; parameters of these names take precedence
  // The index of the next word among these.
  size_t choice(const std::vector<const char*>& words);
  // Divides the next word at a mark inside it, which becomes a word: "50+-0.01" at "+-". Not where the word begins with it.
  void divide_at(const std::string& mark);
  std::string rest(); // the remaining words, separated by blanks
  void end() const;   // error if words remain

  [[noreturn]] void missing(const std::string& expected) const; // at the next word, or at the end of the statement
  [[noreturn]] void fail(const std::string& text) const;        // at the last word taken
  const Parameters& parameters() const { return parameters_; }

private:
  Expression arithmetic(const std::string& what, const Expression::Variables& variables);
  double finite(const Expression& expression, const std::string& what) const;
  std::string like_parameter(const Word& word) const;
  bool begins_number(const Word& word) const;
  std::vector<Word> words_;
  size_t next_ = 1;
  const Parameters& parameters_;
};

} // namespace sketch

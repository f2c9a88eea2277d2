#include "program/sweep/sweep.hpp"

#include "program/commands/drawn_deck.hpp"
#include "program/commands/job.hpp"
#include "program/exit_code.hpp"
#include "program/files/output_file.hpp"
#include "program/files/sealed_file.hpp"
#include "program/files/sha256.hpp"
#include "program/files/system_file.hpp"
#include "program/interrupt.hpp"
#include "program/messages.hpp"
#include "program/outputs/outputs.hpp"
#include "program/progress.hpp"
#include "program/run.hpp"
#include "program/sweep/journal.hpp"
#include "program/sweep/parameters.hpp"
#include "program/sweep/table.hpp"
#include "program/words/voice.hpp"
#include "report/text.hpp"

#include <contact2d.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <memory>
#include <mutex>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

namespace app {
namespace {

class Sweep {
public:
  explicit Sweep(const Options& options) : options_(options) {}
  int go();

private:
  int read();
  std::vector<std::string> settings_of(size_t row) const;
  void name_parameters(const DeckFile& deck);
  uint64_t inputs() const;
  std::string heading() const;
  std::string row_text(size_t row, const Answer& answer) const;
  void work();
  void take(size_t row, const Answer& answer);
  void show() const;
  int write();

  const Options& options_;
  std::shared_ptr<std::string> deck_ = std::make_shared<std::string>();
  SweepTable table_;
  Journal journal_;
  bool keeps_ = false;
  std::vector<std::string> rows_; // of the results; empty: not yet
  std::vector<size_t> missing_;
  std::atomic<size_t> next_{0};
  std::mutex mutex_; // of what follows, and of rows_ and journal_
  size_t done_ = 0, failed_ = 0;
  double begun_ = 0.0;
  Inputs named_; // for the file beside the table
  std::string error_;
};

int Sweep::read() {
  if (const std::string clash = find_clash(options_); !clash.empty()) return fail(clash, kExitUsage);
  DeckFile file;
  Messages messages(file);
  c2d_error why = C2D_INIT(c2d_error);
  if (!file.read(options_.table, why)) return messages.fault(why, kExitInput);
  DeckFile deck;
  Messages deck_messages(deck);
  if (!deck.read(options_.deck, why)) return deck_messages.fault(why, kExitInput);
  *deck_ = deck.text();
  named_.files = {input_file(deck.name(), deck.text()), input_file(file.name(), file.text())};
  named_.options = words_that_change_digits(options_);
  const std::set<std::string> parameters = parameters_of(deck);
  for (const std::string& word : options_.settings)
    if (const std::string name = word.substr(0, word.find('=')); parameters.count(name) == 0)
      return fail(deck.name() + ": no parameter " + name + offer_parameters(name, parameters), kExitUsage);
  if (!read_table(file, parameters, messages, table_)) return kExitInput;
  name_parameters(deck);
  return 0;
}

std::vector<std::string> Sweep::settings_of(size_t row) const {
  std::vector<std::string> out = options_.settings;
  for (size_t k = 0; k < table_.names.size(); ++k) out.push_back(table_.names[k] + "=" + table_.rows[row][k]);
  return out;
}

// Those that the rows have in common: given ones, and defaults that the table does not move, if its first and last row can be
// read.
void Sweep::name_parameters(const DeckFile& deck) {
  std::set<std::string> named(table_.names.begin(), table_.names.end());
  for (const std::string& word : options_.settings) {
    named.insert(word.substr(0, word.find('=')));
    named_.parameters.emplace_back(word.substr(0, word.find('=')), word.substr(word.find('=') + 1));
  }
  if (table_.rows.empty()) return;
  const auto first = parameters_used(deck, settings_of(0)), last = parameters_used(deck, settings_of(table_.rows.size() - 1));
  for (const auto& parameter : first)
    if (named.count(parameter.first) == 0 && std::find(last.begin(), last.end(), parameter) != last.end())
      named_.parameters.push_back(parameter);
}

// Checksum of everything that the results depend on.
uint64_t Sweep::inputs() const {
  std::string all = c2d_version() + std::string("\n") + *deck_, points;
  for (const std::string& name : table_.names) all += name + ",";
  for (const auto& row : table_.rows)
    for (const std::string& value : row) all += value + ",";
  for (const std::string& word : options_.settings) all += word + "\n";
  for (const Response& response : options_.responses) all += response.words + ";";
  if (!options_.points.empty()) read_named(options_.points, points); // the run itself reports a failure
  for (const int32_t choice :
       {options_.stepping, options_.quadrature, options_.symmetry, options_.elimination, options_.touching})
    all += std::to_string(choice) + " ";
  all += std::to_string(options_.memory) + "\n" + points;
  return checksum_of(all, all.size());
}

std::string Sweep::heading() const {
  std::string out = "row";
  for (const std::string& name : table_.names) out += "," + name;
  for (const Response& response : options_.responses) out += "," + csv_field(response.words);
  return out + ",outcome\n";
}

std::string Sweep::row_text(size_t row, const Answer& answer) const {
  std::string out = std::to_string(row + 1);
  for (const std::string& value : table_.rows[row]) out += "," + csv_field(value);
  for (size_t i = 0; i < options_.responses.size(); ++i)
    out += "," + (has_results(answer.exit) ? csv_number(answer.values[i]) : std::string());
  return out + "," + csv_field(outcome_of(answer));
}

void Sweep::show() const {
  const double share = static_cast<double>(done_) / static_cast<double>(missing_.size());
  const double gone = clock_seconds(nullptr) - begun_;
  std::string line =
      kClearLine + std::string("contact2d: ") + std::to_string(done_) + " of " + std::to_string(missing_.size()) + " rows";
  if (failed_ > 0) line += ", " + std::to_string(failed_) + " failed";
  if (gone > 1.0 && done_ < missing_.size()) line += ", " + duration_text(gone * (1.0 - share) / share) + " left";
  say(line);
}

void Sweep::take(size_t row, const Answer& answer) {
  const std::lock_guard<std::mutex> lock(mutex_);
  rows_[row] = row_text(row, answer);
  ++done_;
  if (!has_results(answer.exit)) ++failed_;
  if (keeps_ && error_.empty()) journal_.add(row, rows_[row], error_);
  const bool terminal = options_.progress == Progress::kAutomatic && !options_.quiet && ::isatty(2) == 1;
  if (options_.progress == Progress::kAlways || terminal) show();
}

// One row after another, until there are none.
void Sweep::work() {
  auto store = std::make_unique<StoreChoice>();
  for (size_t i = next_++; i < missing_.size() && !interrupted(); i = next_++) {
    const size_t row = missing_[i];
    Options options = options_;
    options.command = Command::kRun;
    options.threads = 1;
    options.progress = Progress::kNever;
    options.store = "memory";
    options.quiet = true; // no listing and no files
    options.results.clear(), options.table.clear();
    options.text = deck_;
    options.settings = settings_of(row);
    Answer answer;
    try {
      answer = answer_of(options, *store);
    } catch (const std::bad_alloc&) {
      store = std::make_unique<StoreChoice>();
      answer.exit = kExitMemory, answer.reason = "no memory left";
    }
    if (answer.exit != kExitCancelled) take(row, answer);
  }
}

int Sweep::write() {
  std::string all = heading(), error;
  for (const std::string& row : rows_) all += row + "\n";
  if (!write_output(options_.results, all, error)) return fail(error, kExitFiles);
  if (keeps_ && !write_output(options_.results + kInputsEnding, inputs_text(named_), error)) return fail(error, kExitFiles);
  journal_.remove();
  return 0;
}

int Sweep::go() {
  if (const int exit = read(); exit != 0) return exit;
  const bool named = !options_.results.empty() && options_.results != "-";
  struct stat about = {};
  const bool there = named && ::stat(options_.results.c_str(), &about) == 0;
  if (there && S_ISDIR(about.st_mode)) // reported before the work
    return fail(options_.results + ": cannot be written: " + system_text(EISDIR), kExitFiles);
  keeps_ = named && (!there || S_ISREG(about.st_mode)); // no journal beside a device or a pipe
  if (options_.resume && !keeps_)
    return fail("--resume: expected --results FILE; solved rows are stored beside it", kExitUsage);
  std::string error;
  if (keeps_)
    if (const int exit = journal_.open(options_.results + ".rows", inputs(), options_.resume, error); exit != 0)
      return fail(error, exit);
  rows_.resize(table_.rows.size());
  for (const auto& [row, text] : journal_.rows())
    if (row < rows_.size()) rows_[row] = text;
  for (size_t row = 0; row < rows_.size(); ++row)
    if (rows_[row].empty()) missing_.push_back(row);
  begun_ = clock_seconds(nullptr);
  const size_t processors = std::max(1u, std::thread::hardware_concurrency());
  const size_t wanted = options_.threads > 0 ? static_cast<size_t>(options_.threads) : processors;
  std::vector<std::thread> threads;
  for (size_t i = 1; i < std::min(wanted, missing_.size()); ++i) threads.emplace_back([this] { work(); });
  work();
  for (std::thread& thread : threads) thread.join();
  if (done_ > 0 && options_.progress == Progress::kAlways) say("\n");
  if (!error_.empty()) return fail(error_, kExitFiles);
  if (done_ < missing_.size()) {
    if (!keeps_) return fail("cancelled", kExitCancelled);
    return fail("cancelled: sweep --resume solves the missing rows", told_to_end() ? kExitStopped : kExitCancelled);
  }
  return write();
}

} // namespace

int sweep_table(const Options& options) { return Sweep(options).go(); }

} // namespace app

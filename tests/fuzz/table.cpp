// What a sweep reads, behind lines of %%: its table, a file of parameters, a deck that takes them, names of responses. What is
// taken is put into the deck, and nothing in braces is left of it.
#include "fuzz.hpp"

#include "program/sweep/parameters.hpp"
#include "program/sweep/responses.hpp"
#include "program/sweep/table.hpp"

#include <algorithm>
#include <set>

namespace {

std::vector<std::string> sections_of(const std::string& text) {
  static const std::string mark = "\n%%\n";
  std::vector<std::string> sections;
  for (size_t at = 0; sections.size() < 4;) {
    const size_t end = std::min(text.find(mark, at), text.size());
    sections.push_back(text.substr(at, end - at));
    at = std::min(end + mark.size(), text.size());
  }
  return sections;
}

app::SweepTable table_of(const std::string& text, const std::set<std::string>& parameters) {
  app::DeckFile file;
  file.call("table.csv");
  file.replace(text);
  app::Messages messages(file);
  app::SweepTable table;
  const bool sound = app::read_table(file, parameters, messages, table);
  fuzz::require(sound || table.rows.empty() || !messages.latest().empty(), "what is refused is told");
  if (!sound) return {};
  fuzz::require(!table.rows.empty() && table.rows.size() < file.cards(), "a row of the file each");
  fuzz::require(std::set<std::string>(table.names.begin(), table.names.end()).size() == table.names.size(), "names of columns");
  for (const auto& row : table.rows) fuzz::require(row.size() == table.names.size(), "a value for each name");
  return table;
}

std::vector<app::Setting> settings_of(const std::string& text) {
  std::vector<std::string> words;
  std::string error;
  std::vector<app::Setting> settings;
  const bool sound = app::read_parameters(text, words, error);
  fuzz::require(sound == error.empty(), "what is refused is told");
  for (const std::string& word : words) {
    settings.emplace_back();
    fuzz::require(app::read_setting(word, settings.back()), "each word is a setting");
  }
  return settings;
}

void put_into(std::string deck, const std::vector<app::Setting>& settings) {
  const size_t lines = fuzz::count_lines(deck);
  std::vector<app::DeckFault> faults;
  const bool sound = app::put_parameters(deck, settings, faults);
  fuzz::require(sound == faults.empty(), "what is refused is told");
  for (const app::DeckFault& fault : faults)
    fuzz::require(!fault.text.empty() && static_cast<size_t>(fault.line) <= lines && fault.column <= fault.column_end,
                  "a fault with its place");
  fuzz::require(fuzz::count_lines(deck) == lines, "no line comes or goes");
  if (!sound) return;
  const std::string once = deck;
  fuzz::require(app::put_parameters(deck, {}, faults) && deck == once, "nothing is left to be put in");
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::vector<std::string> section = sections_of(fuzz::text_of(data, size));
  std::vector<app::Setting> settings = settings_of(section[1]);
  put_into(section[2], settings);
  const app::SweepTable table = table_of(section[0], app::parameters_of(section[2]));
  for (const auto& row : table.rows) {
    std::vector<app::Setting> of_row = settings;
    for (size_t i = 0; i < row.size(); ++i) of_row.emplace_back(table.names[i], row[i]);
    put_into(section[2], of_row);
  }
  std::vector<app::Response> responses;
  std::string error;
  const bool sound = app::read_responses(section[3], responses, error);
  fuzz::require(sound == error.empty(), "what is refused is told");
  return 0;
}

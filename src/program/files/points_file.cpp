#include "program/files/points_file.hpp"

#include "program/words/read_number.hpp"

#include <cmath>
#include <string>

namespace app {
namespace {

constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf"; // some editors begin a file with it

// A field of a row without its outer blanks, and its columns (from 1).
struct Field {
  std::string_view text;
  int32_t column, column_end;
};

std::vector<Field> split(std::string_view row) {
  std::vector<Field> fields;
  for (size_t at = 0; at <= row.size();) {
    size_t end = row.find(',', at), next = end;
    if (end == std::string_view::npos) next = end = row.size();
    while (at < end && (row[at] == ' ' || row[at] == '\t')) ++at;
    while (end > at && (row[end - 1] == ' ' || row[end - 1] == '\t')) --end;
    fields.push_back({row.substr(at, end - at), static_cast<int32_t>(at) + 1, static_cast<int32_t>(end)});
    at = next + 1;
  }
  return fields;
}

bool is_word(const Field& field, const char* word) {
  size_t i = 0;
  for (; word[i] != '\0'; ++i)
    if (i >= field.text.size() || (field.text[i] | 0x20) != word[i]) return false;
  return i == field.text.size();
}

class PointsReader {
public:
  PointsReader(int32_t bodies, Messages& messages) : bodies_(bodies), messages_(messages) {}
  bool row(const std::vector<Field>& fields, int32_t line, WantedPoint& point);
  void fault(int32_t line, const Field* field, const std::string& text) {
    const c2d_error entry =
        field != nullptr ? fault_in(line, field->column, field->column_end, text) : fault_in(line, 0, 0, text);
    Messages::log(&messages_, &entry);
    sound_ = false;
  }
  bool sound() const { return sound_; }

private:
  bool coordinate(const Field& field, const char* name, int32_t line, double& value);

  int32_t bodies_;
  Messages& messages_;
  bool sound_ = true;
};

std::string in_quotes(const Field& field) {
  std::string text(field.text.substr(0, 40));
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) >= 0x7f) c = '?';
  return "'" + text + "'";
}

bool PointsReader::coordinate(const Field& field, const char* name, int32_t line, double& value) {
  if (read_fortran_number(std::string(field.text), value) && std::isfinite(value)) return true;
  fault(line, &field, std::string(name) + " is " + in_quotes(field) + ", expected a number");
  return false;
}

bool PointsReader::row(const std::vector<Field>& fields, int32_t line, WantedPoint& point) {
  if (fields.size() != 3) {
    fault(line, fields.size() > 3 ? &fields[3] : nullptr,
          "the row has " + std::to_string(fields.size()) + (fields.size() == 1 ? " field" : " fields") +
              ", expected 3 separated by commas: body,x,y");
    return false;
  }
  bool good = read_fortran_number(std::string(fields[0].text), point.body) && point.body >= 1 && point.body <= bodies_;
  if (!good)
    fault(line, &fields[0],
          "body is " + in_quotes(fields[0]) + ", expected " +
              (bodies_ == 1   ? "1, the only body"
               : bodies_ == 2 ? "1 or 2"
                              : "1 to " + std::to_string(bodies_)));
  good = coordinate(fields[1], "x", line, point.x) && good;
  good = coordinate(fields[2], "y", line, point.y) && good;
  point.line = line;
  return good;
}

} // namespace

bool read_points(const DeckFile& file, int32_t bodies, Messages& messages, std::vector<WantedPoint>& points) {
  PointsReader reader(bodies, messages);
  bool first = true;
  for (size_t line = 1; line <= file.cards(); ++line) {
    std::string_view text = file.card(line);
    if (line == 1 && text.compare(0, kByteOrderMark.size(), kByteOrderMark) == 0) text.remove_prefix(kByteOrderMark.size());
    const std::vector<Field> fields = split(text);
    if (fields.size() == 1 && fields[0].text.empty()) continue;
    const bool heading =
        first && fields.size() == 3 && is_word(fields[0], "body") && is_word(fields[1], "x") && is_word(fields[2], "y");
    first = false;
    WantedPoint point{};
    if (!heading && reader.row(fields, static_cast<int32_t>(line), point)) points.push_back(point);
  }
  if (reader.sound() && points.empty()) reader.fault(0, nullptr, "no points, expected rows body,x,y");
  return reader.sound();
}

} // namespace app

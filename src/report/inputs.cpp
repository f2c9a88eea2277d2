#include "report/inputs.hpp"

#include "report/listing/listing_items.hpp"
#include "report/text.hpp"

#include <contact2d.h>

#include <cstdio>
#include <cstdlib>

namespace app {

std::string build_text() {
#if defined(__clang__)
  std::string out = "clang " __clang_version__;
  while (!out.empty() && out.back() == ' ') out.pop_back();
#elif defined(__VERSION__)
  std::string out = "gcc " __VERSION__;
#else
  std::string out = "unknown compiler";
#endif
#if defined(__x86_64__)
  return out + ", x86_64";
#elif defined(__aarch64__)
  return out + ", aarch64";
#elif defined(__wasm__)
  return out + ", wasm";
#else
  return out + ", " + std::to_string(8 * sizeof(void*)) + " bits";
#endif
}

std::string exact_number(double value) {
  char text[40] = "";
  for (int digits = 12; digits <= 17; ++digits) {
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    if (std::strtod(text, nullptr) == value) break;
  }
  return text;
}

std::vector<std::pair<std::string, std::string>> rows_of(const Inputs& inputs) {
  std::vector<std::pair<std::string, std::string>> out = {{"version", c2d_version()}, {"build", build_text()}};
  for (const InputFile& file : inputs.files) out.insert(out.end(), {{"file", file.name}, {"sha256", file.sha256}});
  for (const auto& [name, value] : inputs.parameters) out.emplace_back("parameter " + name, value);
  for (const std::string& word : inputs.options) out.emplace_back("option", word);
  return out;
}

std::string inputs_text(const Inputs& inputs) {
  std::string out;
  for (const auto& [key, value] : rows_of(inputs)) out += key + " = " + shown(value) + "\n";
  return out;
}

void append_inputs(std::string& listing, const Inputs& inputs) {
  if (inputs.files.empty()) return;
  append_section(listing, "Inputs");
  for (const auto& [key, value] : rows_of(inputs)) append_name(listing, key.c_str()) += shown(value) + "\n";
}

} // namespace app

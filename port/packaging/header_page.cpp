// Public headers as one page of HTML:
//   header_page VERSION HEADER... > contact2d.html
// Comments at the margin become text, the rest stays code; every declared name is a link to its
// declaration, and the functions are listed first.
#include <fstream>
#include <iostream>
#include <map>
#include <regex>
#include <string>
#include <vector>

namespace {

using Names = std::map<std::string, bool>; // declared names: has its anchor been written? (some names have two declarations)

struct Header {
  std::string name;
  std::vector<std::string> lines;
};

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text)
    out += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : c == '"' ? "&quot;" : std::string(1, c);
  return out;
}

// Names declared by a line outside comments: functions and types at the margin, macros, enum constants; not used names.
std::vector<std::string> declared(const std::string& line) {
  static const std::regex function("^[a-z][A-Za-z0-9_ *]*\\b(c2d_[a-z0-9_]+)\\("),
      type("^typedef .*\\b(c2d_[a-z0-9_]+)( \\{|;)"), macro("^#define (C2D_[A-Za-z0-9_]+)"), constant("\\b(C2D_[A-Z0-9_]+) = "),
      pointer("^typedef .*\\(\\*(c2d_[a-z0-9_]+)\\)");
  std::vector<std::string> out;
  std::smatch found;
  for (const std::regex* kind : {&function, &type, &macro, &pointer})
    if (std::regex_search(line, found, *kind)) out.push_back(found[1]);
  const std::string code = line.substr(0, line.find("/*"));
  for (std::sregex_iterator i(code.begin(), code.end(), constant), end; i != end; ++i) out.push_back((*i)[1]);
  return out;
}

// The text with a link at every known name, or with an anchor if `here` is set.
std::string linked(const std::string& text, Names& known, const std::vector<std::string>& here) {
  static const std::regex word("\\b[cC]2[dD]_[A-Za-z0-9_]+");
  std::string out;
  size_t done = 0;
  for (std::sregex_iterator i(text.begin(), text.end(), word), end; i != end; ++i) {
    const std::string name = i->str();
    const size_t at = static_cast<size_t>(i->position());
    out += escaped(text.substr(done, at - done));
    done = at + name.size();
    bool defines = false;
    for (const std::string& one : here) defines = defines || one == name;
    const auto found = known.find(name);
    if (found == known.end()) {
      out += name;
    } else if (defines && !found->second) {
      found->second = true;
      out += "<b id=\"" + name + "\">" + name + "</b>";
    } else {
      out += "<a href=\"#" + name + "\">" + name + "</a>";
    }
  }
  return out + escaped(text.substr(done));
}

// A paragraph of a comment: a table (columns of blanks) keeps its lines.
void put_paragraph(const std::vector<std::string>& lines, Names& known) {
  if (lines.empty()) return;
  bool is_table = false;
  for (const std::string& line : lines) is_table = is_table || line.find("   ") != std::string::npos;
  std::cout << (is_table ? "<pre class=\"text\">" : "<p>");
  for (const std::string& line : lines) std::cout << linked(line, known, {}) << '\n';
  std::cout << (is_table ? "</pre>\n" : "</p>\n");
}

// The lines of a comment at the margin, without its marks; a ruler "-- 3 the port --" is a heading.
void put_comment(const std::vector<std::string>& lines, Names& known) {
  static const std::regex ruler("^-{8,} (([0-9]+) .*[^- ]) *-*$"), edge("^ {1,3}");
  std::vector<std::string> paragraph;
  for (const std::string& raw : lines) {
    const std::string line = std::regex_replace(raw, edge, "");
    std::smatch found;
    if (std::regex_match(line, found, ruler)) {
      put_paragraph(paragraph, known);
      paragraph.clear();
      std::cout << "<h2 id=\"section" << found[2] << "\">" << escaped(found[1]) << "</h2>\n";
    } else if (line.find_first_not_of(' ') == std::string::npos) {
      put_paragraph(paragraph, known);
      paragraph.clear();
    } else
      paragraph.push_back(line);
  }
  put_paragraph(paragraph, known);
}

void put_code(std::vector<std::string>& lines, Names& known) {
  while (!lines.empty() && lines.back().empty()) lines.pop_back();
  if (lines.empty()) return;
  std::cout << "<pre>";
  for (const std::string& line : lines) std::cout << linked(line, known, declared(line)) << '\n';
  std::cout << "</pre>\n";
  lines.clear();
}

void put_header(const Header& header, Names& known) {
  std::cout << "<h1>" << header.name << "</h1>\n";
  std::vector<std::string> code, comment;
  bool in_comment = false;
  for (std::string line : header.lines) {
    if (!in_comment && line.compare(0, 2, "/*") == 0) {
      put_code(code, known);
      in_comment = true;
      line = line.substr(line.size() > 2 && line[2] == ' ' ? 3 : 2);
    }
    if (!in_comment) {
      if (!line.empty() || !code.empty()) code.push_back(line);
      continue;
    }
    const size_t end = line.find("*/");
    comment.push_back(line.substr(0, end));
    if (end == std::string::npos) continue;
    put_comment(comment, known);
    comment.clear();
    in_comment = false;
  }
  put_code(code, known);
}

const char* const kStyle = R"(
:root { color-scheme: light dark }
body { max-width: 62rem; margin: auto; padding: 0 1rem; font: 1rem/1.5 system-ui, sans-serif }
pre { overflow-x: auto; padding: .6rem; border: 1px solid #8884; border-radius: .3rem; font-size: .85rem; line-height: 1.35 }
pre.text { border: none; padding: 0 }
h1 { border-top: 2px solid #8888; padding-top: 1rem }
nav { columns: 16rem; font-size: .9rem }
nav a { display: block }
:target { background: #fc06 }
)";

} // namespace

int main(int count, char** words) {
  std::vector<Header> headers;
  Names known;
  std::vector<std::string> functions;
  for (int i = 2; i < count; ++i) {
    const std::string path = words[i];
    std::ifstream in(path);
    if (!in) {
      std::cerr << "header_page: cannot read " << path << '\n';
      return 1;
    }
    headers.push_back({path.substr(path.rfind('/') + 1), {}});
    for (std::string line; std::getline(in, line);) {
      for (const std::string& name : declared(line))
        if (known.emplace(name, false).second && line.compare(0, 7, "typedef") != 0 && name[0] == 'c')
          functions.push_back(name);
      headers.back().lines.push_back(line);
    }
  }
  if (headers.empty()) {
    std::cerr << "usage: header_page VERSION HEADER...\n";
    return 1;
  }
  std::cout << "<!DOCTYPE html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n<title>contact2d " << words[1]
            << "</title>\n<meta name=\"viewport\" content=\"width=device-width\">\n<style>" << kStyle
            << "</style>\n<p>contact2d " << words[1] << ", the headers of its C interface. Functions:</p>\n<nav>\n";
  for (const std::string& name : functions) std::cout << "<a href=\"#" << name << "\">" << name << "</a>\n";
  std::cout << "</nav>\n";
  for (const Header& header : headers) put_header(header, known);
  std::cout << "</html>\n";
  return std::cout.good() ? 0 : 1;
}

// The Fortran module, and the structs of the Python package, against the headers: the same functions with the same arguments,
// the same constants, the same structs, member by member. What the headers get and the module lacks is told here.
#include "hosts.hpp"
#include "paths.hpp"

#include <map>
#include <set>

using namespace test;

namespace {

const std::string kRoot = paths::root();
const char* const kHeaders[] = {"/include/contact2d.h",       "/include/contact2d_codes.h", "/include/contact2d_cards.h",
                                "/include/contact2d_image.h", "/include/contact2d_cycle.h", "/port/memory/c2d_memory.h",
                                "/port/stdio/c2d_stdio.h",    "/port/posix/c2d_posix.h",    "/port/threads/c2d_threads.h"};

using Words = std::vector<std::string>;

struct Argument {
  std::string name, type; // type as Fortran declares it: integer(c_int32_t), type(c_ptr), ...
  bool by_value = false;
};
struct Function {
  std::string result;
  std::vector<Argument> arguments;
};
struct Interface {
  std::map<std::string, Function> functions;
  std::map<std::string, std::string> constants;
  std::map<std::string, Words> structs; // members in their order
};

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

std::string trimmed(const std::string& text) {
  const size_t first = text.find_first_not_of(" \n\t"), last = text.find_last_not_of(" \n\t");
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

std::string last_word(const std::string& text) {
  size_t end = text.size();
  while (end > 0 && !is_word(text[end - 1])) --end;
  size_t begin = end;
  while (begin > 0 && is_word(text[begin - 1])) --begin;
  return text.substr(begin, end - begin);
}

// Parts between separators outside of parentheses.
Words split(const std::string& text, char separator) {
  Words out(1);
  int depth = 0;
  for (const char c : text) {
    if (c == '(' || c == '[' || c == '{') ++depth;
    if (c == ')' || c == ']' || c == '}') --depth;
    if (c == separator && depth == 0)
      out.emplace_back();
    else
      out.back() += c;
  }
  for (std::string& part : out) part = trimmed(part);
  if (out.back().empty()) out.pop_back();
  return out;
}

std::string between(const std::string& text, char open, char close) {
  const size_t first = text.find(open), last = text.rfind(close);
  return first == std::string::npos || last == std::string::npos ? "" : text.substr(first + 1, last - first - 1);
}

// ---- C
// ---------------------------------------------------------------------------------------------------------------

// Without comments, lines of the preprocessor, and what only C++ sees.
std::string plain_c(const std::string& text) {
  std::string code, out;
  for (size_t i = 0; i < text.size(); ++i) {
    if (text.compare(i, 2, "/*") == 0) i = text.find("*/", i) + 2;
    code += text[i];
  }
  bool directive = false, cpp = false;
  for (const std::string& line : lines_of(code)) {
    const bool begins = !directive && !line.empty() && line[0] == '#';
    if (begins) cpp = contains(line, "#ifdef __cplusplus") || (cpp && !contains(line, "#e"));
    if (!begins && !directive && !cpp) out += line + "\n";
    directive = (begins || directive) && !line.empty() && line.back() == '\\';
  }
  return out;
}

std::string fortran_type(const std::string& declaration) {
  static const std::map<std::string, std::string> kTypes = {
      {"int32_t", "integer(c_int32_t)"},    {"uint32_t", "integer(c_int32_t)"},
      {"c2d_status", "integer(c_int32_t)"}, {"c2d_outcome", "integer(c_int32_t)"},
      {"int64_t", "integer(c_int64_t)"},    {"uint64_t", "integer(c_int64_t)"},
      {"size_t", "integer(c_size_t)"},      {"double", "real(c_double)"},
      {"char", "character(kind=c_char)"},   {"void", "type(c_ptr)"},
      {"c2d_solver", "type(c_ptr)"},        {"c2d_read_line", "type(c_funptr)"},
      {"c2d_report", "type(c_funptr)"},     {"c2d_card_fn", "type(c_funptr)"},
      {"c2d_step_fn", "type(c_funptr)"},    {"c2d_threads_task", "type(c_funptr)"},
      {"c2d_cycle_fn", "type(c_funptr)"}};
  std::string word = declaration.compare(0, 6, "const ") == 0 ? declaration.substr(6) : declaration;
  word = word.substr(0, word.find_first_of(" *"));
  const auto known = kTypes.find(word);
  return known != kTypes.end() ? known->second : "type(" + word + ")";
}

Argument c_argument(const std::string& declaration) {
  Argument a;
  a.name = last_word(declaration.substr(0, declaration.find('[')));
  a.type = fortran_type(declaration);
  const bool pointer = contains(declaration, "*") || contains(declaration, "[");
  a.by_value = pointer ? a.type == "type(c_ptr)" && !contains(declaration, "**") : true;
  return a;
}

void read_c_statement(const std::string& statement, Interface& out) {
  if (statement.compare(0, 4, "enum") == 0) {
    for (const std::string& each : split(between(statement, '{', '}'), ','))
      out.constants[trimmed(each.substr(0, each.find('=')))] = trimmed(each.substr(each.find('=') + 1));
  } else if (statement.compare(0, 14, "typedef struct") == 0 && contains(statement, "{")) {
    Words members;
    for (const std::string& each : split(between(statement, '{', '}'), ';')) {
      if (contains(each, "(*"))
        members.push_back(last_word(each.substr(0, each.find(")("))));
      else
        for (const std::string& one : split(each, ',')) members.push_back(last_word(one.substr(0, one.find('['))));
    }
    out.structs[last_word(statement)] = members;
  } else if (statement.compare(0, 7, "typedef") != 0 && contains(statement, "(")) {
    Function f;
    const std::string head = statement.substr(0, statement.find('('));
    f.result = contains(head, "char*") ? "type(c_ptr)" : head.compare(0, 5, "void ") == 0 ? "" : fortran_type(head);
    for (const std::string& each : split(between(statement, '(', ')'), ','))
      if (each != "void") f.arguments.push_back(c_argument(each));
    out.functions[last_word(head)] = f;
  }
}

Interface read_headers() {
  Interface out;
  for (const char* header : kHeaders) {
    std::string code = plain_c(read_file(kRoot + header));
    for (const std::string& statement : split(code, ';')) read_c_statement(statement, out);
  }
  return out;
}

// ---- Fortran
// ---------------------------------------------------------------------------------------------------------

// Statements without comments, continued lines in one piece.
Words statements_of(const std::string& text) {
  Words out;
  bool continued = false;
  for (std::string line : lines_of(text)) {
    line = trimmed(line.substr(0, line.find('!')));
    if (line.empty()) continue;
    const bool goes_on = line.back() == '&';
    if (goes_on) line.pop_back();
    if (continued)
      out.back() += line;
    else
      out.push_back(line);
    continued = goes_on;
  }
  return out;
}

// "real(c_double), intent(in) :: a, b(n)": type, whether by value, and names.
struct Declaration {
  std::string type;
  bool by_value;
  Words names, values;
};
Declaration declaration_of(const std::string& statement) {
  Declaration d;
  const size_t colons = statement.find("::");
  const Words attributes = split(statement.substr(0, colons), ',');
  d.type = attributes.empty() ? "" : attributes[0];
  d.by_value = !attributes.empty() && attributes.back() == "value";
  for (const std::string& each : split(statement.substr(colons + 2), ',')) {
    d.names.push_back(trimmed(each.substr(0, each.find_first_of("(= "))));
    d.values.push_back(contains(each, "=") ? trimmed(each.substr(each.find('=') + 1)) : "");
  }
  return d;
}

class ModuleReader {
public:
  Interface read(const std::string& text) {
    for (const std::string& statement : statements_of(text)) read_statement(statement);
    return out_;
  }

private:
  void read_statement(const std::string& s) {
    if (s == "contains") done_ = true;
    if (done_ || s.compare(0, 8, "abstract") == 0) abstract_ = true;
    if (s == "interface") abstract_ = false;
    if (s.compare(0, 13, "type, bind(C)") == 0) {
      struct_ = declaration_of(s).names[0];
    } else if (s == "end type") {
      struct_.clear();
    } else if (s.compare(0, 9, "function ") == 0 || s.compare(0, 11, "subroutine ") == 0) {
      begin_function(s);
    } else if (s.compare(0, 4, "end ") == 0) {
      function_.clear();
    } else if (contains(s, "::")) {
      read_declaration(declaration_of(s), contains(s, "parameter"));
    }
  }

  void begin_function(const std::string& s) {
    if (abstract_) return;
    const size_t name = s.find(' ') + 1, open = s.find('('), close = s.find(')');
    function_ = s.substr(name, open - name);
    const size_t other = s.find("name='"); // bound to another name
    if (other != std::string::npos) function_ = s.substr(other + 6, s.find('\'', other + 6) - other - 6);
    Function f;
    for (const std::string& each : split(s.substr(open + 1, close - open - 1), ',')) f.arguments.push_back({each, "", false});
    const size_t result = s.rfind("result(");
    result_ = result == std::string::npos ? "" : s.substr(result + 7, s.find(')', result) - result - 7);
    out_.functions[function_] = f;
  }

  void read_declaration(const Declaration& d, bool parameter) {
    for (size_t i = 0; i < d.names.size(); ++i) {
      if (!struct_.empty()) {
        out_.structs[struct_].push_back(d.names[i]);
      } else if (!function_.empty()) {
        if (d.names[i] == result_) out_.functions[function_].result = d.type;
        for (Argument& a : out_.functions[function_].arguments)
          if (a.name == d.names[i]) a.type = d.type, a.by_value = d.by_value;
      } else if (parameter && !done_) {
        out_.constants[d.names[i]] = d.values[i];
      }
    }
  }

  Interface out_;
  std::string struct_, function_, result_;
  bool abstract_ = false, done_ = false;
};

const Interface& headers() {
  static const Interface read = read_headers();
  return read;
}
const Interface& module() {
  static const Interface read = ModuleReader().read(read_file(kRoot + "/port/fortran/contact2d.f90"));
  return read;
}

} // namespace

TEST_CASE("bindings: every function of the headers is in the Fortran module, argument by argument") {
  REQUIRE(headers().functions.size() > 55);
  for (const auto& each : headers().functions) {
    const std::string& name = each.first;
    const Function& c = each.second;
    const auto found = module().functions.find(name);
    CHECK_MESSAGE(found != module().functions.end(), name << " is not in contact2d.f90");
    if (found == module().functions.end()) continue;
    const Function& f = found->second;
    CHECK_MESSAGE(f.result == c.result, name << ": " << f.result << ", not " << c.result);
    CHECK_MESSAGE(f.arguments.size() == c.arguments.size(), name);
    for (size_t i = 0; i < f.arguments.size() && i < c.arguments.size(); ++i) {
      const std::string what = name + ": " + c.arguments[i].name;
      CHECK_MESSAGE(f.arguments[i].name == c.arguments[i].name, what);
      CHECK_MESSAGE(f.arguments[i].type == c.arguments[i].type, what << " is " << f.arguments[i].type);
      CHECK_MESSAGE(f.arguments[i].by_value == c.arguments[i].by_value, what << " by value, by reference");
    }
  }
  for (const auto& each : module().functions)
    CHECK_MESSAGE(headers().functions.count(each.first) == 1, each.first << " is in no header");
}

TEST_CASE("bindings: the Fortran module is what the headers make of it") {
  if (!can_host("python3")) return;
  const Result run = run_shell("cd / && PYTHONDONTWRITEBYTECODE=1 python3 '" + kRoot + "/port/fortran/generate.py' --check");
  CHECK_MESSAGE(run.status == 0, run.out << run.err);
}

TEST_CASE("bindings: every constant of the headers is in the Fortran module, with its value") {
  REQUIRE(headers().constants.size() > 120);
  for (const auto& each : headers().constants) {
    const std::string& name = each.first;
    const std::string& value = each.second;
    const auto found = module().constants.find(name);
    CHECK_MESSAGE(found != module().constants.end(), name << " is not in contact2d.f90");
    if (found != module().constants.end()) CHECK_MESSAGE(found->second == value, name);
  }
  for (const auto& each : module().constants) CHECK_MESSAGE(headers().constants.count(each.first) == 1, each.first);
}

TEST_CASE("bindings: every struct of the headers is in the Fortran module, member by member") {
  REQUIRE(headers().structs.size() > 14);
  for (const auto& each : headers().structs) {
    const std::string& name = each.first;
    const Words& members = each.second;
    const auto found = module().structs.find(name);
    CHECK_MESSAGE(found != module().structs.end(), name << " is not in contact2d.f90");
    if (found == module().structs.end()) continue;
    CHECK_MESSAGE(found->second.size() == members.size(), name);
    for (size_t i = 0; i < members.size() && i < found->second.size(); ++i)
      CHECK_MESSAGE(found->second[i] == members[i], name << ": " << found->second[i] << ", not " << members[i]);
  }
}

namespace {

// Two programs that print, for every struct, its size, what it holds as struct_size, and where its members
// lie.
std::string c_layout() {
  std::string text = "#include <stddef.h>\n#include <stdio.h>\n";
  for (const char* header : kHeaders) text += "#include \"" + kRoot + header + "\"\n";
  text += "int main(void) {\n";
  for (const auto& each : headers().structs) {
    const std::string& name = each.first;
    const Words& members = each.second;
    text += "  printf(\"" + name + " %d\\n\", (int)sizeof(" + name + "));\n";
    for (const std::string& member : members)
      text += "  printf(\"" + name + " " + member + " %d\\n\", (int)offsetof(" + name + ", " + member + "));\n";
    if (members[0] == "struct_size")
      text += "  { " + name + " x = C2D_INIT(" + name + "); printf(\"" + name + " holds %d\\n\", (int)x.struct_size); }\n";
  }
  return text + "  return 0;\n}\n";
}

std::string fortran_layout() {
  std::string declared, text;
  for (const auto& each : headers().structs) {
    const std::string& name = each.first;
    const Words& members = each.second;
    declared += "  type(" + name + "), target :: " + name + "_\n";
    const std::string x = name + "_";
    text += "  print '(a,1x,i0)', '" + name + "', c_sizeof(" + x + ")\n";
    for (const std::string& member : members)
      text +=
          "  print '(a,1x,i0)', '" + name + " " + member + "', at(c_loc(" + x + "%" + member + ")) - at(c_loc(" + x + "))\n";
    if (members[0] == "struct_size") text += "  print '(a,1x,i0)', '" + name + " holds', " + x + "%struct_size\n";
  }
  return "program layout\n  use contact2d\n  implicit none\n" + declared + text +
         "contains\n  integer(c_intptr_t) function at(address)\n    type(c_ptr), intent(in) :: address\n"
         "    at = transfer(address, 0_c_intptr_t)\n  end function\nend program\n";
}

} // namespace

TEST_CASE("bindings: structs have the same size, default and places of members in C and in Python") {
  if (!can_host("python3")) return;
  const Folder folder;
  write_file(folder / "c.c", c_layout());
  std::string script = "import sys\nsys.path.insert(0, '" + kRoot + "/port/python/contact2d')\nimport header\n";
  for (const auto& each : headers().structs) {
    const std::string& name = each.first;
    script += "s = header." + name + "\nprint('" + name + "', header.sizeof(s))\n";
    for (const std::string& member : each.second)
      script += "print('" + name + " " + member + "', getattr(s, '" + member + "').offset)\n";
    if (each.second[0] == "struct_size") script += "print('" + name + " holds', s().struct_size)\n";
  }
  write_file(folder / "layout.py", script);
  const Result c = run_shell(paths::c_compiler() + " -std=c99 -I'" + kRoot + "/include' '" + (folder / "c.c") + "' -o '" +
                             (folder / "c") + "' && '" + (folder / "c") + "'");
  const Result python = run_shell("PYTHONDONTWRITEBYTECODE=1 python3 '" + (folder / "layout.py") + "'");
  REQUIRE_MESSAGE(c.status == 0, c.err);
  REQUIRE_MESSAGE(python.status == 0, python.err);
  REQUIRE(lines_of(c.out).size() > 150);
  CHECK(c.out == python.out);
}

TEST_CASE("bindings: structs have the same size, default and places of members in C and in Fortran") {
  if (!can_host("gfortran")) return;
  const Folder folder;
  write_file(folder / "c.c", c_layout());
  write_file(folder / "f.f90", fortran_layout());
  const Result c = run_shell(paths::c_compiler() + " -std=c99 -I'" + kRoot + "/include' '" + (folder / "c.c") + "' -o '" +
                             (folder / "c") + "' && '" + (folder / "c") + "'");
  const Result f = run_shell("cd '" + folder.path() + "' && gfortran -w '" + kRoot + "/port/fortran/contact2d.f90' f.f90 '" +
                             paths::library() + "' -o f && ./f");
  REQUIRE_MESSAGE(c.status == 0, c.err);
  REQUIRE_MESSAGE(f.status == 0, f.err);
  const Words in_c = lines_of(c.out), in_fortran = lines_of(f.out);
  REQUIRE(in_c.size() > 150);
  REQUIRE(in_c.size() == in_fortran.size());
  for (size_t i = 0; i < in_c.size(); ++i) CHECK(in_c[i] == in_fortran[i]);
}

// The program's contract: exit statuses, messages, outputs that are whole or not there, stores, JSON and CSV.
#include "json.hpp"
#include "paths.hpp"
#include "shell.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

using namespace test;

namespace {

const std::string kExamples = paths::root() + "/examples/";
const std::string kHertz = kExamples + "hertz.dat", kProgram = "'" + paths::program() + "' ";

Result contact2d(const std::string& arguments) { return run_shell("'" + paths::program() + "' " + arguments); }

std::string quoted(const std::string& path) { return "'" + path + "'"; }

// The sample deck with its text `from`, which must be there, replaced once.
std::string changed_hertz(const std::string& from, const std::string& to) {
  std::string deck = read_file(kHertz);
  const size_t at = deck.find(from);
  REQUIRE(at != std::string::npos);
  return deck.replace(at, from.size(), to);
}

// The number that stands right before " bytes" after `word`.
unsigned long long bytes_after(const std::string& text, const std::string& word) {
  const size_t start = text.find(word);
  REQUIRE(start != std::string::npos);
  const size_t digit = text.find_first_of("0123456789", start + word.size());
  REQUIRE(digit != std::string::npos);
  return std::stoull(text.substr(digit));
}

std::vector<std::string> columns_of(const std::string& row) {
  std::vector<std::string> out;
  std::istringstream in(row);
  for (std::string field; std::getline(in, field, ',');) out.push_back(field);
  return out;
}

const std::string kCsvHeader = "mu,step,load,pair,x,y,status,tn,tt,un1,ut1,un2,ut2,gap,slip,zone,body1,body2";

} // namespace

TEST_CASE("program: --version and --help") {
  const Result version = contact2d("--version");
  CHECK(version.status == 0);
  CHECK(version.out == "contact2d 0.2.0\n");
  const Result help = contact2d("--help");
  CHECK(help.status == 0);
  for (const char* word : {"--listing", "--csv", "--boundary", "--json", "--stepping", "--quadrature", "--memory", "--store",
                           "--threads", "--progress", "--no-progress", "--keep", "--estimate", "--halve"})
    CHECK_MESSAGE(contains(help.out, word), word);
}

TEST_CASE("program: bad usage ends with 64 and says why") {
  const std::string deck = " " + quoted(kHertz) + " ";
  const std::string wrong[] = {"",
                               "walk",
                               "run",
                               "check",
                               "check --csv x" + deck,
                               "run --nonsense" + deck,
                               "run --csv",
                               "run" + deck + "--csv",
                               "run" + deck + deck,
                               "run --stepping sometimes" + deck,
                               "run --quadrature exact" + deck,
                               "run --memory lots" + deck,
                               "run --memory 0" + deck,
                               "run --memory 1X" + deck,
                               "run --memory 99999999999999999999" + deck,
                               "run --memory 99999999999T" + deck,
                               "run --store disk" + deck,
                               "run --store file:" + deck,
                               "run --threads 0" + deck,
                               "run --threads two" + deck,
                               "run --keep=1" + deck,
                               "run --estimate=1" + deck,
                               "run --estimate --store file:x" + deck,
                               "check --estimate" + deck,
                               "convert --halve" + deck,
                               "run --csv=" + deck};
  for (const std::string& arguments : wrong) {
    const Result result = contact2d(arguments);
    CHECK_MESSAGE(result.status == 64, arguments);
    CHECK_MESSAGE(result.err.compare(0, 11, "contact2d: ") == 0, arguments);
    CHECK_MESSAGE(result.out.empty(), arguments);
  }
}

TEST_CASE("program: what a misspelt word may have been, and where the words of a command are explained") {
  const std::string deck = " " + quoted(kHertz), roller = quoted(paths::root() + "/examples/roller.c2s");
  const struct {
    std::string arguments, said;
  } misspelt[] = {
      {"rn" + deck, "unknown command rn, did you mean 'run'?\ncontact2d: --help lists commands"},
      {"walk" + deck, "unknown command walk: expected a file, run, check, "},
      {"help chekc", "help: unknown command chekc, did you mean 'check'?"},
      {"run --lisitng l" + deck, "run takes no option --lisitng, did you mean '--listing'?\ncontact2d: run --help"},
      {"check --memory 1M" + deck, "check takes no option --memory\ncontact2d: check --help explains this command\n"},
      {"run " + roller + " muu=1", "no parameter of this sketch is called 'muu', did you mean 'mu'?\n"},
      {"run " + roller + " p=1", "no parameter of this sketch is called 'p', did you mean 'P'?\n"},
      {"run " + roller + " weight=1", "is called 'weight', expected one of P R mu\n"}};
  for (const auto& each : misspelt) {
    const Result result = contact2d(each.arguments);
    CHECK_MESSAGE(result.status == 64, each.arguments);
    CHECK_MESSAGE(contains(result.err, each.said), result.err);
  }
}

TEST_CASE("program: a file in the place of a command is run") {
  const Folder folder;
  fs::copy(kHertz, folder / "sample");
  const auto here = [&](const std::string& words) {
    return run_shell("cd " + quoted(folder.path()) + " && '" + paths::program() + "' " + words);
  };
  const std::string whole = here("run sample --quiet --csv -").out;
  CHECK(here("sample --quiet --csv -").out == whole);
  CHECK(here("./sample --quiet --csv -").out == whole);
  const Result missing = here("sample.dat");
  CHECK(missing.status == 2);
  CHECK_MESSAGE(contains(missing.err, "sample.dat: error: cannot be read"), missing.err);
}

TEST_CASE("program: an unreadable deck ends with 2 and leaves no output") {
  const Folder in, out;
  write_file(in / "empty", "");
  write_file(in / "binary", std::string("PK\x03\x04\x14") + std::string(3, '\0') + "\x08\xff\n");
  write_file(in / "prose", "It was a dark and stormy night.\nThe rain fell in torrents.\n");
  write_file(in / "cut", read_file(kHertz).substr(0, 2000));
  for (const std::string& deck : {in / "missing", in.path(), in / "empty", in / "binary", in / "prose", in / "cut"}) {
    const Result result = contact2d("run " + quoted(deck) + " --listing " + quoted(out / "l") + " --csv " + quoted(out / "c") +
                                    " --boundary " + quoted(out / "b") + " --json " + quoted(out / "j"));
    CHECK_MESSAGE(result.status == 2, deck);
    CHECK_MESSAGE(result.err.compare(0, 12 + deck.size(), "contact2d: " + deck + ":") == 0, result.err);
    CHECK_MESSAGE(contains(result.err, "error: "), result.err);
    CHECK_MESSAGE(out.names().empty(), deck);
    CHECK_MESSAGE(contact2d("check " + quoted(deck)).status == 2, deck);
  }
}

TEST_CASE("program: every fault of a deck is told with its card and a caret") {
  const Folder folder;
  // Two fields spoiled: the number of an interior node card, and a value of a condition card.
  std::string deck = changed_hertz("   16  5.0000000 0.0000000", "   16  5.00x0000 0.0000000");
  const std::string from = "   14    1 0011     0.0000-1820.0000";
  const size_t at = deck.find(from);
  REQUIRE(at != std::string::npos);
  deck.replace(at, from.size(), "   14    1 0011     0.0000-18 0.0000");
  write_file(folder / "deck", deck);
  const Result result = contact2d("run " + quoted(folder / "deck"));
  CHECK(result.status == 2);
  CHECK(result.out.empty());

  const std::vector<std::string> lines = lines_of(result.err);
  const std::vector<std::string> cards = lines_of(deck);
  int faults = 0;
  for (size_t i = 0; i < lines.size(); ++i) {
    int line = 0, column = 0;
    const std::string start = "contact2d: " + (folder / "deck") + ":";
    if (lines[i].compare(0, start.size(), start) != 0) continue;
    REQUIRE(std::sscanf(lines[i].c_str() + start.size(), "%d:%d: error: ", &line, &column) == 2);
    REQUIRE(i + 2 < lines.size());
    CHECK(lines[i + 1] == cards[static_cast<size_t>(line) - 1]);
    CHECK(lines[i + 2].find('^') == static_cast<size_t>(column) - 1);
    const bool first = contains(lines[i + 1], "5.00x0000"), second = contains(lines[i + 1], "-18 0.0000");
    if (first) CHECK((column >= 7 && column <= 16));
    if (second) CHECK((column >= 27 && column <= 36));
    faults += first || second;
  }
  CHECK(faults == 2);
}

TEST_CASE("program: the sample is solved, with every output in its format") {
  const Folder folder;
  const Result result =
      contact2d("run " + quoted(kHertz) + " --csv " + quoted(folder / "c") + " --boundary " + quoted(folder / "b") +
                " --json " + quoted(folder / "j") + " --listing " + quoted(folder / "l"));
  CHECK_MESSAGE(result.status == 0, result.err);
  CHECK(result.out.empty());
  CHECK(folder.names().size() == 6); // beside each table its inputs

  const std::vector<std::string> rows = lines_of(read_file(folder / "c"));
  REQUIRE(rows.size() == 1 + 2 * 28 * 15); // two coefficients, 14 cards of 2 increments, 15 pairs
  CHECK(rows[0] == kCsvHeader);
  for (size_t i = 1; i < rows.size(); ++i) {
    const std::vector<std::string> fields = columns_of(rows[i]);
    REQUIRE(fields.size() == 18);
    CHECK((fields[15] == "1" && fields[16] == "1" && fields[17] == "2"));
    const size_t n = i - 1;
    CHECK(std::stod(fields[0]) == (n < 28 * 15 ? 0.4 : 0.3));
    CHECK(std::stoul(fields[1]) == n / 15 % 28 + 1);
    CHECK(std::stoul(fields[3]) == n % 15 + 1);
    CHECK((fields[6] == "open" || fields[6] == "stick" || fields[6] == "slip"));
  }
  CHECK(columns_of(rows[28 * 15])[2] == "1.03");

  const std::vector<std::string> ends = lines_of(read_file(folder / "b"));
  REQUIRE(ends.size() == 1 + 2 * 46 + 2 * 58);
  CHECK(ends[0] == "body,element,node,x,y,ux,uy,tx,ty");
  CHECK(ends[1].compare(0, 6, "1,1,1,") == 0);
  CHECK(ends[2].compare(0, 6, "1,1,2,") == 0);
  CHECK(ends[92].compare(0, 7, "1,46,1,") == 0);
  CHECK(ends[93].compare(0, 6, "2,1,1,") == 0);

  const std::string listing = read_file(folder / "l");
  for (const char* text : {"HERTZ'S PROBLEM. F= 0.4 & 0.3", "1000", "Contact zone of body 1", "Contact zone of body 2",
                           "Body 2 in global components", "Balance of forces", "reached"})
    CHECK_MESSAGE(contains(listing, text), text);
  CHECK_FALSE(contains(listing, "incomplete"));
}

TEST_CASE("program: the JSON summary has its keys") {
  const Folder folder;
  REQUIRE(contact2d("run " + quoted(kHertz) + " --listing /dev/null --json " + quoted(folder / "j")).status == 0);
  const Json json = JsonReader::read(read_file(folder / "j"));
  for (const char* key : {"version", "outcome", "title", "mu", "steps", "unknowns", "memory", "tapes", "seconds", "events",
                          "exchanges", "tableau_rebuilds", "max_residual", "force", "warnings"})
    CHECK_MESSAGE(json.has(key), key);
  CHECK(json["version"].text == "0.2.0");
  CHECK(json["outcome"].text == "reached");
  CHECK_FALSE(json.has("incomplete"));
  REQUIRE(json["mu"].items.size() == 2);
  CHECK(json["mu"][0].number == 0.4);
  CHECK(json["mu"][1].number == 0.3);
  CHECK(json["steps"].number == 28);
  CHECK(json["unknowns"]["body1"].number == 2 * 46 + 3);
  CHECK(json["unknowns"]["body2"].number == 2 * 58 + 3);
  CHECK(json["unknowns"]["contact"].number > 0);
  const double minimum = json["memory"]["minimum_bytes"].number, in_core = json["memory"]["in_core_bytes"].number;
  CHECK(minimum > 0);
  CHECK(in_core >= minimum);
  CHECK(json["memory"]["peak_workspace_bytes"].number <= in_core);
  CHECK(json["tapes"].items.size() == 4);
  for (const Json& tape : json["tapes"].items)
    for (const char* key : {"name", "bytes_written", "bytes_read", "blocks"}) CHECK_MESSAGE(tape.has(key), key);
  for (const char* key : {"read", "assemble", "eliminate", "reduce", "contact", "back", "write"}) {
    REQUIRE_MESSAGE(json["seconds"].has(key), key);
    CHECK_MESSAGE(json["seconds"][key].number >= 0.0, key);
  }
  CHECK(json["events"].number > 0);
  CHECK(json["max_residual"].number < 1e-9);
  // 455.06 per unit load factor, 1.03 of it; balanced by construction.
  CHECK(std::abs(json["force"]["applied"].number) == doctest::Approx(455.06 * 1.03).epsilon(1e-4));
  CHECK(std::abs(json["force"]["error"].number) < 1e-6);
}

// Of plates with many corners, whose exponents take longer than all else. By one thread its seconds are at least those of a
// processor that it used, however many others run beside it, and at most those that went by.
TEST_CASE("program: the seconds of the JSON summary are those of the run") {
  const auto used_by_children = [] {
    rusage used{};
    getrusage(RUSAGE_CHILDREN, &used);
    return static_cast<double>(used.ru_utime.tv_sec) + 1e-6 * static_cast<double>(used.ru_utime.tv_usec);
  };
  const Folder folder;
  REQUIRE(contact2d("make stack plates=7 n=3 >" + quoted(folder / "d")).status == 0);
  const auto start = std::chrono::steady_clock::now();
  const double before = used_by_children();
  REQUIRE(
      contact2d("run " + quoted(folder / "d") + " -q --threads 1 --listing /dev/null --json " + quoted(folder / "j")).status ==
      0);
  const double used = used_by_children() - before;
  const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const Json json = JsonReader::read(read_file(folder / "j"));
  double sum = 0;
  for (const char* key : {"read", "assemble", "eliminate", "reduce", "contact", "back", "write"})
    sum += json["seconds"][key].number;
  CHECK(sum <= elapsed);
  CHECK(sum >= 0.6 * used);
}

TEST_CASE("program: a listing by default, and a dash for standard output") {
  const Result listing = contact2d("run " + quoted(kHertz));
  CHECK(listing.status == 0);
  CHECK(contains(listing.out, "Contact zone of body 1"));
  const Result csv = contact2d("run " + quoted(kHertz) + " --csv -");
  CHECK(csv.status == 0);
  CHECK(csv.out.compare(0, kCsvHeader.size() + 1, kCsvHeader + "\n") == 0);
  CHECK(lines_of(csv.out).size() == 1 + 2 * 28 * 15);
  const Result json = contact2d("run --listing=/dev/null --json=- -- " + quoted(kHertz));
  CHECK(json.status == 0);
  CHECK(JsonReader::read(json.out)["outcome"].text == "reached");
}

TEST_CASE("program: standard output that is a file is added to, under whatever name") {
  const Folder folder;
  const std::string run = "'" + paths::program() + "' run " + quoted(kHertz) + " --csv ",
                    csv = contact2d("run " + quoted(kHertz) + " --csv -").out;
  for (const std::string& name : {std::string("-"), std::string("/dev/stdout"), folder / "all"}) {
    const std::string all = quoted(folder / "all"), to = name == folder / "all" ? all : name;
    REQUIRE(run_shell("echo before > " + all + "; " + run + to + " >> " + all + " && echo after >> " + all).status == 0);
    CHECK(read_file(folder / "all") == "before\n" + csv + "after\n");
    CHECK(folder.names() == std::vector<std::string>{"all"});
  }
}

TEST_CASE("program: a deck may come from a pipe, with CRLF and without a last line end") {
  const std::string expected = contact2d("run " + quoted(kHertz) + " --csv -").out;
  REQUIRE(!expected.empty());
  CHECK(run_shell("'" + paths::program() + "' run - --csv - <" + quoted(kHertz)).out == expected);
  const Folder folder;
  std::string deck;
  for (const std::string& line : lines_of(read_file(kHertz))) deck += line + "\r\n";
  write_file(folder / "crlf", deck.substr(0, deck.size() - 2));
  CHECK(contact2d("run " + quoted(folder / "crlf") + " --csv -").out == expected);
}

TEST_CASE("program: outputs that cannot be written end with 3, and none of the others appears") {
  const Folder folder;
  fs::create_directory(folder / "taken");
  std::vector<std::string> bad = {folder / "nowhere/file", folder / "taken", folder / std::string(300, 'x')};
  if (fs::exists("/dev/full")) bad.push_back("/dev/full");
  if (::geteuid() != 0) { // root may write anywhere
    fs::create_directory(folder / "closed");
    fs::permissions(folder / "closed", fs::perms::owner_read | fs::perms::owner_exec);
    bad.push_back(folder / "closed/file");
    write_file(folder / "readonly", "old");
    fs::permissions(folder / "readonly", fs::perms::owner_read);
    bad.push_back(folder / "readonly");
  }
  const size_t before = folder.names().size();
  const char* const options[] = {"--listing", "--csv", "--boundary", "--json"};
  for (const std::string& name : bad)
    for (const char* option : options) {
      std::string arguments = "run " + quoted(kHertz);
      for (const char* other : options)
        arguments += std::string(" ") + other + " " + quoted(other == option ? name : folder / (other + 2));
      const Result result = contact2d(arguments);
      CHECK_MESSAGE(result.status == 3, option << " " << name);
      CHECK_MESSAGE(contains(result.err, name), result.err);
      CHECK_MESSAGE(folder.names().size() == before, option << " " << name);
    }
  if (fs::exists("/dev/full")) CHECK(run_shell("'" + paths::program() + "' run " + quoted(kHertz) + " >/dev/full").status == 3);
  if (fs::exists("/dev/full"))
    CHECK(run_shell("'" + paths::program() + "' check " + quoted(kHertz) + " >/dev/full").status == 3);
  if (fs::exists("/dev/full")) CHECK(run_shell("'" + paths::program() + "' --help >/dev/full").status == 3);
}

TEST_CASE("program: a file size limit ends with 3; a closed pipe quietly with 141, and the other outputs are written") {
  const Folder folder;
  const std::string run = "'" + paths::program() + "' run " + quoted(kHertz) + " --listing /dev/null --csv ";
  // ulimit counts in blocks of 512 or 1024 bytes; the CSV has more than 60 KiB.
  const Result limited = run_shell("ulimit -f 8; " + run + quoted(folder / "c") + " 2>/dev/null");
  CHECK(limited.status == 3);
  CHECK(folder.names().empty());
  for (const std::string& words :
       {"run " + quoted(kHertz) + " --quiet --json " + quoted(folder / "json") + " --csv -",
        "check " + quoted(paths::root() + "/examples/plate_tension.dat"), std::string("make hertz"), std::string("--help")}) {
    INFO(words);
    run_shell("cd " + quoted(folder.path()) + "; rm -f closed; mkfifo closed; { read word <closed; '" + paths::program() +
              "' " + words + " 2>said; echo $? >status; } | { exec 0<&-; echo now >closed; }"); // once nobody reads its output
    CHECK(read_file(folder / "status") == "141\n");
    CHECK(read_file(folder / "said") == "");
  }
  CHECK(contains(read_file(folder / "json"), "\"outcome\""));
}

TEST_CASE("program: an old output is replaced only by a complete one") {
  const Folder folder;
  write_file(folder / "c", "old");
  write_file(folder / "bad", "nonsense\n");
  fs::permissions(folder / "c", fs::perms::owner_read | fs::perms::owner_write);
  CHECK(contact2d("run " + quoted(folder / "bad") + " --csv " + quoted(folder / "c")).status == 2);
  CHECK(read_file(folder / "c") == "old");
  CHECK(contact2d("run " + quoted(kHertz) + " --memory 1K --csv " + quoted(folder / "c")).status == 4);
  CHECK(read_file(folder / "c") == "old");
  fs::create_symlink("c", folder / "link");
  CHECK(contact2d("run " + quoted(kHertz) + " --csv " + quoted(folder / "link")).status == 0);
  CHECK(read_file(folder / "c").compare(0, kCsvHeader.size(), kCsvHeader) == 0);
  CHECK(fs::is_symlink(folder / "link"));
  CHECK(fs::status(folder / "c").permissions() == (fs::perms::owner_read | fs::perms::owner_write));
  CHECK(folder.names().size() == 4); // the inputs stand beside the link
}

TEST_CASE("program: devices and pipes are written to, never replaced") {
  const Folder folder;
  const std::string fifo = folder / "fifo";
  REQUIRE(::mkfifo(fifo.c_str(), 0600) == 0);
  const Result result = run_shell(
      "cat " + quoted(fifo) + " >" + quoted(folder / "copy") + " & '" + paths::program() + "' run " + quoted(kHertz) +
      " --listing /dev/null --boundary /dev/null --json /dev/null --csv " + quoted(fifo) + "; status=$?; wait; exit $status");
  CHECK(result.status == 0);
  CHECK(fs::is_fifo(fifo));
  CHECK(lines_of(read_file(folder / "copy")).size() == 1 + 2 * 28 * 15);
  CHECK(fs::is_character_file("/dev/null"));
  CHECK(folder.names().size() == 2);
}

TEST_CASE("program: the deck is not overwritten, nor one output by another") {
  const Folder folder;
  const std::string text = read_file(kHertz), deck = folder / "deck";
  write_file(deck, text);
  fs::create_hard_link(deck, folder / "same");
  CHECK(contact2d("run " + quoted(deck) + " --csv " + quoted(deck)).status == 64);
  CHECK(contact2d("run " + quoted(deck) + " --csv " + quoted(folder / "same")).status == 64);
  CHECK(contact2d("run " + quoted(deck) + " --csv " + quoted(folder / "x") + " --json " + quoted(folder / "x")).status == 64);
  CHECK(read_file(deck) == text);
  CHECK(folder.names().size() == 2);
}

TEST_CASE("program: check tells the memory, and that memory is enough") {
  const Result check = contact2d("check " + quoted(kHertz));
  CHECK(check.status == 0);
  const unsigned long long minimum = bytes_after(check.out, "minimum"), in_core = bytes_after(check.out, "all in RAM");
  CHECK(minimum <= in_core);
  for (const char* tape : {"tape control", "tape lower", "tape upper", "tape contact"}) {
    unsigned long long blocks = 0, bytes = 0, few = 0, wide = 0; // with the minimum, and all in RAM
    const size_t at = check.out.find(std::string("\n") + tape);
    REQUIRE(at != std::string::npos);
    CHECK(std::sscanf(check.out.c_str() + at + 1 + std::strlen(tape),
                      " %llu blocks of %llu bytes; all in RAM: %llu blocks of %llu bytes", &blocks, &bytes, &few, &wide) == 4);
    CHECK((blocks >= few && blocks > 0));
    CHECK((few == 0 || bytes <= wide)); // a whole matrix leaves no lower factor to keep
  }
  const std::string run = "run " + quoted(kHertz) + " --listing /dev/null --memory ";
  CHECK(contact2d(run + std::to_string(minimum)).status == 0);
  CHECK(contact2d(run + std::to_string(in_core)).status == 0);
  CHECK(contact2d(run + "1G").status == 0);
  const Result small = contact2d(run + std::to_string(minimum - 1));
  CHECK(small.status == 4);
  CHECK(bytes_after(small.err, "too small:") == minimum);
  CHECK(contact2d(run + "1").status == 4);
  CHECK(contact2d(run + "1K").status == 4);
}

TEST_CASE("program: stepping and quadrature are chosen") {
  const Folder folder;
  CHECK(contact2d("run " + quoted(kHertz) + " --stepping deck --listing " + quoted(folder / "l")).status == 0);
  CHECK(contains(read_file(folder / "l"), "deck increments"));
  CHECK(contact2d("run " + quoted(kHertz) + " --quadrature thesis --listing " + quoted(folder / "l")).status == 0);
  CHECK(contains(read_file(folder / "l"), "2, 4 and 10 points"));
  CHECK(contact2d("run " + quoted(kHertz) +
                  " --stepping events --quadrature accurate --symmetry deck --threads 1 "
                  "--no-progress --listing /dev/null")
            .status == 0);
}

TEST_CASE("program: every store gives the same numbers, and files go after success") {
  const Folder folder;
  const std::string run = "run " + quoted(kHertz) + " --listing /dev/null --csv ", store = folder / "tapes";
  REQUIRE(contact2d(run + quoted(folder / "a") + " --store memory").status == 0);
  REQUIRE(contact2d(run + quoted(folder / "b") + " --store file:" + quoted(store)).status == 0);
  CHECK(read_file(folder / "a") == read_file(folder / "b"));
  CHECK_FALSE(fs::exists(store)); // made by the program, so it goes too
  REQUIRE(contact2d(run + quoted(folder / "b") + " --keep --store file:" + quoted(store)).status == 0);
  REQUIRE(fs::is_directory(store));
  CHECK(fs::exists(store + "/contact2d.store/tape0.c2d"));
  // A second run in a folder full of another run's tapes, which the user made: tapes go, the folder stays.
  write_file(store + "/mine", "text");
  REQUIRE(contact2d(run + quoted(folder / "b") + " --store file:" + quoted(store)).status == 0);
  CHECK(read_file(folder / "a") == read_file(folder / "b"));
  CHECK(read_file(store + "/mine") == "text");
  CHECK(std::distance(fs::directory_iterator(store), fs::directory_iterator()) == 1);
}

TEST_CASE("program: a store leaves alone whatever bears its names") {
  const Folder folder;
  const std::vector<std::string> names = {"deck.dat",  "options",   "meshes",    "lock",
                                          "tape0.c2d", "tape1.c2d", "tape3.c2d", "job"};
  for (const std::string& name : names) write_file(folder / name, "the user's " + name);
  fs::copy_file(kHertz, folder / "deck.dat", fs::copy_options::overwrite_existing);
  write_file(folder / "points.csv", "1,50,-20\n");
  const std::string deck = read_file(folder / "deck.dat");
  const Result result = run_shell("cd '" + folder.path() + "' && " + kProgram +
                                  "run deck.dat --points points.csv --interior i.csv --csv tape2.c2d --store file:.");
  CHECK(result.status == 0);
  CHECK(read_file(folder / "deck.dat") == deck);
  CHECK(read_file(folder / "points.csv") == "1,50,-20\n");
  for (size_t i = 1; i < names.size(); ++i) CHECK(read_file(folder / names[i]) == "the user's " + names[i]);
  CHECK(!read_file(folder / "tape2.c2d").empty());
  CHECK_FALSE(fs::exists(folder / "contact2d.store"));
}

TEST_CASE("program: what clashes with the folders that a run fills is found beforehand") {
  const Folder folder;
  fs::copy_file(kHertz, folder / "deck.dat");
  fs::copy_file(paths::root() + "/examples/rough_profile.c2s", folder / "r.c2s");
  fs::copy_file(paths::root() + "/examples/rough_profile.csv", folder / "rough_profile.csv");
  const std::string profile = read_file(folder / "rough_profile.csv");
  const auto refused = [&](const std::string& command, const std::string& expected) {
    CAPTURE(command);
    const Result result = run_shell("cd '" + folder.path() + "' && " + kProgram + "run " + command);
    CHECK(result.status == 64);
    CHECK_MESSAGE(contains(result.err, expected), result.err);
    CHECK(result.out.empty());
  };
  refused("deck.dat --store file:. --csv contact2d.store/tape0.c2d", "--csv lies in ");
  refused("deck.dat --store file:x --csv ./x/../x/contact2d.store/a", "--csv lies in ");
  refused("deck.dat --store file:. --figures contact2d.store", "--figures lies in ");
  refused("deck.dat --store file:. --figures contact2d.store/a/b", "--figures lies in ");
  refused("contact2d.store/deck --store file:.", "the deck lies in ");
  refused("deck.dat --store file:. --interior i --points contact2d.store/job", "--points lies in ");
  refused("deck.dat --figures f --report f/pressure.svg", "--report is an SVG file in the folder of --figures");
  refused("r.c2s --csv rough_profile.csv", "the file rough_profile.csv of the sketch and --csv are the same file");
  CHECK(read_file(folder / "rough_profile.csv") == profile);
  CHECK(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()) == 3);
}

TEST_CASE("program: what killed runs left aside goes when the same output is written again, and not before its writer ends") {
  const Folder folder;
  const std::string run = "run " + quoted(kHertz) + " --listing " + quoted(folder / "l");
  const std::string pipe = folder / "pipe", mine = folder / ".contact2d-mine";
  write_file(mine, "not the program's");
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  const auto aside = [&] {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder.path())) {
      const std::string name = entry.path().filename();
      if (name.compare(0, 11, ".contact2d-") == 0 && entry.path() != mine) names.push_back(entry.path());
    }
    return names;
  };
  const pid_t child = ::fork(); // it waits for someone to read the pipe, with its listing lying aside
  if (child == 0) {
    const int nowhere = ::open("/dev/null", O_WRONLY);
    ::dup2(nowhere, 2);
    ::execl(paths::program().c_str(), "contact2d", "run", kHertz.c_str(), "--listing", (folder / "l").c_str(), "--csv",
            pipe.c_str(), static_cast<char*>(nullptr));
    ::_exit(127);
  }
  const auto is_held = [&] { // not merely there: until it is locked another run may take it for one that was left
    if (aside().empty()) return false;
    const int file = ::open(aside()[0].c_str(), O_WRONLY);
    const bool held = file >= 0 && ::flock(file, LOCK_EX | LOCK_NB) != 0;
    ::close(file);
    return held;
  };
  for (int wait = 0; !is_held() && wait < 5000; ++wait) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  const std::vector<std::string> held = aside();
  REQUIRE(held.size() == 1);
  REQUIRE(contact2d(run).status == 0);
  CHECK(aside() == held); // another run wrote the same name meanwhile: what is held stays
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  CHECK(aside() == held);
  REQUIRE(contact2d(run).status == 0);
  CHECK(aside().empty());
  CHECK(read_file(mine) == "not the program's");
}

TEST_CASE("program: a folder of tapes belongs to one process, else exit status 75; a store that fails ends with 3") {
  const Folder folder;
  const std::string store = folder / "tapes", own = store + "/contact2d.store";
  fs::create_directory(store);
  fs::create_directory(own);
  const int lock = ::open((own + "/lock").c_str(), O_RDWR | O_CREAT, 0600);
  REQUIRE(lock >= 0);
  REQUIRE(::flock(lock, LOCK_EX) == 0);
  const std::string run = "run " + quoted(kHertz) + " --csv " + quoted(folder / "c") + " --store file:";
  const Result locked = contact2d(run + quoted(store));
  CHECK(locked.status == 75);
  CHECK(contains(locked.err, "in use"));
  ::close(lock);
  CHECK(contact2d(run + quoted(folder / "no/such/parent")).status == 3);
  write_file(folder / "file", "");
  CHECK(contact2d(run + quoted(folder / "file")).status == 3);
  fs::create_directory(own + "/tape0.c2d"); // in the way of a tape
  const Result blocked = contact2d(run + quoted(store));
  CHECK(blocked.status == 3);
  CHECK(contains(blocked.err, "error: "));
  CHECK_FALSE(fs::exists(folder / "c"));
}

TEST_CASE("program: a path that ends early leaves its rows and says where and why, exit 1") {
  const Folder folder;
  // The last load card pulls the cylinder away: the contact opens at load 0 and nothing holds the body.
  write_file(folder / "deck", changed_hertz("    2     1.0300", "    4    -1.0300"));
  const Result result = contact2d("run " + quoted(folder / "deck") + " --csv " + quoted(folder / "c") + " --json " +
                                  quoted(folder / "j") + " --listing " + quoted(folder / "l"));
  CHECK(result.status == 1);
  CHECK(contains(result.err, "incomplete"));
  CHECK(contains(read_file(folder / "l"), "incomplete"));
  const Json json = JsonReader::read(read_file(folder / "j"));
  CHECK(json["outcome"].text != "reached");
  REQUIRE(json.has("incomplete"));
  CHECK(json["incomplete"]["mu"].number == 0.4);
  CHECK(json["incomplete"]["step"].number == 28);
  CHECK(std::abs(json["incomplete"]["load"].number) < 1e-6);
  CHECK(!json["incomplete"]["why"].text.empty());
  // 26 increments of the other cards, one at 0.41; the third, to -0.07, ends at 0.
  const std::vector<std::string> rows = lines_of(read_file(folder / "c"));
  REQUIRE(rows.size() > 1);
  CHECK(rows[0] == kCsvHeader);
  CHECK((rows.size() - 1) % 15 == 0);
  CHECK(rows.size() >= 1 + 2 * 27 * 15);
  for (size_t i = 1; i < rows.size(); ++i) CHECK(std::stod(columns_of(rows[i])[2]) > -1e-6);
}

TEST_CASE("program: where a path ends is told by the factors of all load cases") {
  const Folder folder;
  std::string deck = read_file(kExamples + "sliding_block.dat");
  for (size_t at; (at = deck.find("0.2000   -1.0000")) != std::string::npos;) deck.replace(at, 6, "0.0000");
  write_file(folder / "deck", deck + "*CASES 2\ncase 2\ncondition 2 33-48 0 1 0 0 0\n*PATH\n1 1 0\n10 1 1\n");
  const Result result = contact2d("run " + quoted(folder / "deck") + " --json " + quoted(folder / "j") + " --listing " +
                                  quoted(folder / "l") + " --report " + quoted(folder / "r"));
  REQUIRE(result.status == 1);
  // mu = 0.3: sliding begins at 0.3 of the sideward load, straight to the right.
  CHECK(contains(result.err, "load factors 1, 0.3: gross sliding"));
  CHECK(contains(result.err, "can move by (1, 0) and turn by 0 about"));
  CHECK(contains(read_file(folder / "l"), "at load factors 1, 0.3, step"));
  CHECK(contains(read_file(folder / "r"), "stopped at load factors 1, 0.3 in step"));
  const Json json = JsonReader::read(read_file(folder / "j"));
  CHECK(json["incomplete"]["load"].number == 1.0);
  REQUIRE(json["incomplete"]["loads"].items.size() == 2);
  CHECK(json["incomplete"]["loads"][0].number == 1.0);
  CHECK(json["incomplete"]["loads"][1].number == doctest::Approx(0.3).epsilon(1e-9));
}

namespace {

// Two squares; body 2 on body 1, which a card for it holds or not.
std::string two_squares(const std::string& conditions1, const std::string& youngs_modulus = "100",
                        const std::string& order = "2", const std::string& mu = "0.5") {
  const std::string square = "1 0 0\n2 1 0\n3 1 1\n4 0 1\n", points = order == "1" ? "1" : "2";
  const std::string pairs = order == "1" ? "1 2 1 1\n3 3 1 1\n3 3 1 1\n1 1\n1 1\n" : "1 2 2 1\n3 3 1 1\n3 4 2 1\n2 1\n2 1\n";
  const std::string load = order == "1" ? "1\n3 1 0011 0 -1 0 0\n" : "2\n3 1 0011 0 -1 0 0\n1 3 2 0011 0 -1 0 0\n";
  return "*FREE\n1\nTWO SQUARES\n0 1\n2 1 " + order + "\n1 2 4 4\n1 2 4 4\n1 4\n1 4\n" + youngs_modulus + " 0.3\n200 0.2\n1 " +
         mu + "\n0 0\n" + square + "0 1\n" + square + conditions1 + "0\n" + load + "0\n" + pairs + "1 10\n4 1\n";
}

Result run_text(const std::string& deck) {
  Folder folder;
  write_file(folder / "deck.dat", deck);
  return contact2d("run " + quoted(folder / "deck.dat") + " --listing /dev/null");
}

} // namespace

TEST_CASE("program: the body that nothing holds is the one that is named") {
  CHECK(contains(run_text(two_squares("0\n")).err, "body 1 can move"));
  const Result held = run_text(two_squares("2\n1 1 1100 0 0 0 0\n1 1 2 1100 0 0 0 0\n"));
  CHECK(held.status == 0);
  CHECK(held.err == "");
}

TEST_CASE("program: strains that are not small, very high friction and constant functions are warned of") {
  const std::string held = "2\n1 1 1100 0 0 0 0\n1 1 2 1100 0 0 0 0\n";
  const Result soft = run_text(two_squares(held, "10"));
  CHECK(soft.status == 0);
  CHECK(contains(soft.err, "strains reach 0."));
  CHECK(contains(run_text(two_squares(held, "100", "2", "3.5")).err, "coefficient of friction is above 3"));
  CHECK(!contains(run_text(two_squares(held, "100", "2", "3")).err, "coefficient of friction"));
  const Result constant = run_text(two_squares("1\n1 1 1100 0 0 0 0\n", "100", "1"));
  CHECK(contains(constant.err, "with constant functions even a uniform stress"));
}

TEST_CASE("program: coarse contact is told once, with how much may be off") {
  const auto made = [](const std::string& arguments) {
    return run_shell("'" + paths::program() + "' make " + arguments + " | '" + paths::program() +
                     "' run - --listing /dev/null");
  };
  const Result two = made("hertz n=2");
  CHECK(two.status == 0);
  CHECK(contains(
      two.err,
      "only 2 elements between the contact edge and the highest pressure; the edge is uncertain by 0.667 (67 % of the width), "
      "this pressure by 38 %"));
  CHECK(two.err.find("coarse contact") == two.err.rfind("coarse contact"));
  // The mesh is made for what slips at Q; with a smaller motion less does.
  CHECK(contains(made("mindlin move=0.0006").err, "coarse contact: the slip zone of pairs"));
  for (const char* fine :
       {"hertz", "hertz n=6", "mindlin", "mindlin Q=0.1", "cylinder_friction", "receding_layer", "disc_in_hole"})
    CHECK_MESSAGE(!contains(made(fine).err, "coarse contact"), fine);
}

TEST_CASE("program: one body without contact") {
  const Folder folder;
  const Result result = contact2d("run " + quoted(kExamples + "plate_tension.dat") + " --csv " + quoted(folder / "c") +
                                  " --json " + quoted(folder / "j") + " --boundary " + quoted(folder / "b"));
  CHECK(result.status == 0);
  CHECK(contains(result.out, "Body 1 in global components"));
  CHECK(read_file(folder / "c") == kCsvHeader + "\n");
  CHECK(JsonReader::read(read_file(folder / "j"))["unknowns"]["body2"].number == 0);
  CHECK(lines_of(read_file(folder / "b")).size() == 1 + 2 * 24);
}

TEST_CASE("program: the deck says how much is printed") {
  const Folder folder;
  const auto run_with = [&](const std::string& iout) { // IPTYPE and IOUT, then the card of NB, MCP, NFNODE
    write_file(folder / "deck", changed_hertz("    0    2\n    2    1    2", "    0" + iout + "\n    2    1    2"));
    return contact2d("run " + quoted(folder / "deck") + " --listing - --json " + quoted(folder / "j") + " --csv " +
                     quoted(folder / "c"));
  };
  const Result contact = run_with("    1");
  CHECK(contact.status == 0);
  CHECK(contains(contact.out, "Contact zone of body 2"));
  CHECK_FALSE(contains(contact.out, "in global components"));
  CHECK_FALSE(contains(contact.out, "\n  change "));
  const Result changes = run_with("    3");
  CHECK(changes.status == 0);
  CHECK(contains(changes.out, "in global components"));
  CHECK(contains(changes.out, "\n  change "));
  // After a change every touching pair tells its answers: after the first one, pair 15 and the one that closed.
  const std::vector<std::string> lines = lines_of(changes.out);
  size_t at = 0;
  while (at < lines.size() && !contains(lines[at], "  change ")) ++at;
  REQUIRE(at + 3 < lines.size());
  CHECK(contains(lines[at + 1], "tn"));
  CHECK(lines[at + 2].substr(0, 16) == "              14");
  CHECK(lines[at + 3].substr(0, 16) == "              15");
  CHECK(lines_of(read_file(folder / "c")).size() == 1 + 2 * 28 * 15); // changes are no rows
  const Result check = run_with("   -1");
  CHECK(check.status == 0);
  CHECK(contains(check.out, "data check only"));
  CHECK(read_file(folder / "c") == kCsvHeader + "\n");
  CHECK(JsonReader::read(read_file(folder / "j"))["outcome"].text == "checked");
}

TEST_CASE("program: two outputs cannot be one file, however it is spelled") {
  const Folder folder;
  const std::string run = "run " + quoted(kHertz), name = folder / "a";
  for (const std::string& outputs :
       {" --csv " + quoted(name) + " --json " + quoted(name), " --csv " + quoted(name) + " --json " + quoted(folder / "./a"),
        std::string(" --csv - --json -")}) {
    const Result result = contact2d(run + outputs);
    CHECK_MESSAGE(result.status == 64, outputs);
    CHECK_FALSE(fs::exists(name));
  }
  CHECK(contact2d(run + " --csv /dev/null --json /dev/null").status == 0);
}

TEST_CASE("program: every example is in order") {
  for (const auto& entry : fs::directory_iterator(kExamples)) {
    if (entry.path().extension() != ".dat") continue;
    CHECK_MESSAGE(contact2d("check " + quoted(entry.path().string())).status == 0, entry.path().string());
  }
}

TEST_CASE("program: an interrupt ends with 130 and leaves nothing") {
  const Folder folder;
  const std::string fifo = folder / "deck", csv = folder / "c", program = paths::program();
  REQUIRE(::mkfifo(fifo.c_str(), 0600) == 0);
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    ::signal(SIGINT, SIG_DFL);
    const int null = ::open("/dev/null", O_WRONLY);
    ::dup2(null, 2);
    ::execl(program.c_str(), program.c_str(), "run", fifo.c_str(), "--csv", csv.c_str(), static_cast<char*>(nullptr));
    ::_exit(127);
  }
  const int writer = ::open(fifo.c_str(), O_WRONLY); // returns when the program has opened the deck
  REQUIRE(writer >= 0);
  // By then its handlers are in place; a moment more and it waits in read().
  ::usleep(50000);
  ::kill(child, SIGINT);
  int raw = 0;
  REQUIRE(::waitpid(child, &raw, 0) == child);
  ::close(writer);
  CHECK(WIFEXITED(raw));
  CHECK(WEXITSTATUS(raw) == 130);
  CHECK(folder.names().size() == 1);
}

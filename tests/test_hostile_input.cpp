// Hostile input and hosts: control characters, special files, closed descriptors, a store that was cut off, names with dashes.
#include "paths.hpp"
#include "program/files/system_file.hpp"
#include "report/text.hpp"
#include "shell.hpp"

#include <c2d_posix.h>
#include <doctest/doctest.h>
#include <sys/stat.h>

using namespace test;

namespace {

const std::string kHertzDeck = paths::root() + "/examples/hertz.dat", kSample = paths::data() + "/decks/sample.dat";

// A name that would clear the terminal; with a lone byte of 8 bits, and a control character in two bytes of UTF-8.
const std::string kEvil = "a\x1b[2Jb\x07\x7f\x9b\xc2\x9b\x01";

bool has_controls(const std::string& text) {
  for (size_t i = 0; i < text.size();) {
    const size_t bytes = app::character_at(text, i);
    if (bytes == 0 && text[i] != '\n' && text[i] != '\t') return true;
    i += bytes == 0 ? 1 : bytes;
  }
  return false;
}

// A run in a folder of its own; standard input is empty.
Result in_folder(const Folder& folder, const std::string& words) {
  return run_shell("cd '" + folder.path() + "' && '" + paths::program() + "' " + words + " </dev/null");
}

} // namespace

TEST_CASE("hostile input: no control character of an input comes out on a terminal") {
  const Folder folder;
  const std::string body = "body x E 1 nu .3\nfrom 0 0\n";
  write_file(folder / "word.c2s", kEvil + "\n");
  write_file(folder / "parameter.c2s", "parameter " + kEvil + " 3\n");
  write_file(folder / "body.c2s", "body \"" + kEvil + "\" E 1 nu .3\n");
  write_file(folder / "file.c2s", body + "spline s file \"" + kEvil + "\"\n");
  write_file(folder / "rows.c2s", body + "spline s file rows.csv\n");
  write_file(folder / "rows.csv", "0,1\n0," + kEvil + "\n");
  write_file(folder / "title.dat", "1\nHEADING\n" + kEvil + "\n");
  write_file(folder / "comment.dat", read_file(kSample) + "! a comment " + kEvil + "\n*UNITS mm N ! and " + kEvil + "\n");
  write_file(folder / kEvil, read_file(kSample));
  write_file(folder / "points.csv", "body,x,y\n1," + kEvil + ",2\n");
  write_file(folder / "table", kEvil + ",P\n1,2\n");
  write_file(folder / "with", kEvil + "\n");
  write_file(folder / "square.dxf", "0\nSECTION\n2\nENTITIES\n0\nCIRCLE\n8\n" + kEvil + "\n10\n0\n20\n0\n40\n1\n0\n" + kEvil +
                                        "\n0\nENDSEC\n0\nEOF\n");
  const std::string evil = "'" + kEvil + "'";
  for (const std::string& words : {std::string("check word.c2s"),
                                   std::string("run parameter.c2s"),
                                   std::string("mesh body.c2s"),
                                   std::string("check file.c2s"),
                                   std::string("check rows.c2s"),
                                   std::string("check title.dat"),
                                   std::string("convert --to free comment.dat"),
                                   std::string("convert --to fixed comment.dat"),
                                   "check " + evil,
                                   "check none" + evil,
                                   "run " + evil + " --points points.csv",
                                   "run " + evil + " --csv none/" + evil,
                                   "run " + evil + " --points none" + evil,
                                   "run " + evil + " --" + evil,
                                   "run " + evil + " --threads " + evil,
                                   "run " + evil + " " + evil + "=1",
                                   "run " + evil + " --params none" + evil,
                                   "resume none" + evil,
                                   evil,
                                   "help " + evil,
                                   "make " + evil,
                                   "make hertz " + evil + "=1",
                                   "make hertz n=" + evil,
                                   "sweep table " + evil + " --response load",
                                   "sweep table " + evil + " --response " + evil,
                                   std::string("sketch square.dxf"),
                                   std::string("sketch square.dxf --with with"),
                                   "sketch square.dxf --output none/" + evil}) {
    CAPTURE(words);
    const Result result = in_folder(folder, words);
    CHECK_MESSAGE(!has_controls(result.out), result.out);
    CHECK_MESSAGE(!has_controls(result.err), result.err);
    CHECK(!(result.out + result.err).empty());
  }
  CHECK(contains(in_folder(folder, "check word.c2s").err,
                 std::string("'a?[2Jb") + std::string(6, '?') + "': expected a statement"));
  CHECK(contains(in_folder(folder, "sketch square.dxf --with with").err, "with:1:2: error: column 2 has the byte 27"));
  // outputs of a run under such a name
  write_file(folder / "deck.dat", read_file(kSample));
  const Result run = in_folder(folder, "run " + evil + " --out out --vtk out/v.vtk");
  CHECK(run.status == 0);
  CHECK(!has_controls(run.err));
  for (const auto& entry : fs::recursive_directory_iterator(folder / "out"))
    if (entry.is_regular_file()) CHECK_MESSAGE(!has_controls(read_file(entry.path())), entry.path().string());
}

TEST_CASE("hostile input: files that a sketch or an option names are regular and not too large") {
  const Folder folder;
  write_file(folder / "deck.dat", read_file(kHertzDeck));
  write_file(folder / "zero.c2s", "body a E 1 nu 0.3\nfrom 0 0\nspline s file /dev/zero\nline b close\nfix a.b\n");
  write_file(folder / "large.c2s", "body a E 1 nu 0.3\nfrom 0 0\nspline s file large\nline b close\nfix a.b\n");
  write_file(folder / "large", "1 2\n");
  fs::resize_file(folder / "large", (uintmax_t{64} << 20) + 1); // which takes no room on the disk
  REQUIRE(::mkfifo((folder / "pipe").c_str(), 0600) == 0);      // nobody writes into it: it is not waited for
  const struct {
    std::string words, told;
    int status;
  } cases[] = {{"check zero.c2s", "zero.c2s:3:15: error: the file '/dev/zero' is no regular file", 2},
               {"check large.c2s", "the file 'large' has more than 64 MiB", 2},
               {"run deck.dat --points /dev/zero", "/dev/zero: error: is no regular file", 2},
               {"run deck.dat --points pipe", "pipe: error: is no regular file", 2},
               {"run deck.dat --points large", "large: error: has more than 64 MiB", 2},
               {"run deck.dat --points .", ".: error: is no regular file", 2},
               {"run deck.dat --params /dev/zero", "/dev/zero: is no regular file", 2},
               {"run deck.dat --params none", "none: cannot be read: No such file or directory", 2},
               {"sketch deck.dat --with pipe", "pipe: error: is no regular file", 2}};
  for (const auto& c : cases) {
    CAPTURE(c.words);
    const Result result = in_folder(folder, c.words);
    CHECK(result.status == c.status);
    CHECK_MESSAGE(contains(result.err, c.told), result.err);
  }
  // A field is shown, not the line; standard input is anything; outputs may be anything.
  write_file(folder / "points.csv", "1,0.5,3\n1,secret,of somebody else\n");
  const std::string told = in_folder(folder, "run deck.dat --points points.csv").err;
  CHECK_MESSAGE(contains(told, "points.csv:2:3: error: x is 'secret', expected a number\n"), told);
  CHECK(!contains(told, "somebody else\n"));
  const Result piped = run_shell("echo 2,0.5,3 | '" + paths::program() + "' run '" + (folder / "deck.dat") +
                                 "' --points - --interior /dev/stdout --listing /dev/null -q");
  CHECK(piped.status == 0);
  CHECK(lines_of(piped.out).size() == 2);
}

TEST_CASE("hostile hosts: descriptors that are closed get no output of the run") {
  const Folder folder;
  const std::string deck = paths::root() + "/examples/roller.dat"; // it warns
  const Result open = in_folder(folder, "run '" + deck + "' --csv a --json b --listing l");
  CHECK(contains(open.err, "warning"));
  const std::string csv = read_file(folder / "a");
  for (const char* closed : {"2>&-", ">&- 2>&-", "<&- >&- 2>&-"}) {
    CAPTURE(closed);
    const Result result = run_shell("cd '" + folder.path() + "' && '" + paths::program() + "' run '" + deck +
                                    "' --csv c --json d --listing m " + closed);
    CHECK(result.status == 0);
    CHECK(read_file(folder / "c") == csv);
    CHECK(read_file(folder / "d").substr(0, 1) == "{");
    CHECK(read_file(folder / "m").find("contact2d: ") == std::string::npos);
  }
  // What was to be written there is missed, and what was to be read is empty.
  CHECK(run_shell("'" + paths::program() + "' make hertz >&-").status == 3);
  CHECK(contains(run_shell("'" + paths::program() + "' check - <&-").err, "standard input:1:1: error: the deck is empty"));
}

TEST_CASE("hostile hosts: a lock that was cut off beside nothing else is a store that was never begun") {
  const std::string mark = "contact2d block store\n";
  const struct {
    std::string lock;
    bool beside;
    int32_t code;
  } cases[] = {{"", false, 0},
               {std::string(1, '\0'), false, 0},
               {std::string(mark.size(), '\0'), false, 0},
               {mark.substr(0, 7), false, 0},
               {mark.substr(0, 7) + std::string(mark.size() - 7, '\0'), false, 0},
               {mark, true, 0},
               {"", true, C2D_POSIX_STORE_FOREIGN},
               {std::string(mark.size(), '\0'), true, C2D_POSIX_STORE_FOREIGN},
               {mark.substr(0, 7), true, C2D_POSIX_STORE_FOREIGN},
               {std::string(mark.size() + 1, '\0'), false, C2D_POSIX_STORE_FOREIGN},
               {std::string(3, '\0') + "x", false, C2D_POSIX_STORE_FOREIGN},
               {"somebody's", false, C2D_POSIX_STORE_FOREIGN}};
  for (const auto& c : cases) {
    CAPTURE(c.lock);
    CAPTURE(c.beside);
    const Folder folder;
    const std::string own = folder / C2D_POSIX_STORE_FOLDER;
    fs::create_directory(own);
    write_file(own + "/lock", c.lock);
    if (c.beside) write_file(own + "/tape1.c2d", "data");
    for (int time = 0; time < 2; ++time) {
      c2d_posix_store store;
      CHECK(c2d_posix_store_init(&store, folder.path().c_str()) == c.code);
      c2d_posix_store_done(&store);
    }
    CHECK(read_file(own + "/lock") == (c.code == 0 ? mark : c.lock));
  }
}

TEST_CASE("hostile hosts: rows of a sweep whose heading was cut off are those of one that was never begun") {
  const Folder folder;
  write_file(folder / "E", "E\n1\n2\n");
  write_file(folder / "s.c2s", "parameter E 1\nbody b E E nu 0.3\nfrom 0 0\nline s to 1 0\nline e to 1 1\nline n to 0 1\n"
                               "line w close\nfix b.s\ntraction b.e x 1\ntolerance off\n");
  for (const std::string& left : {std::string(), std::string(40, '\0'), "contact2d sw" + std::string(20, '\0')}) {
    CAPTURE(left.size());
    write_file(folder / "table.rows", left);
    const Result swept = in_folder(folder, "sweep E s.c2s --response load --results table --resume");
    CHECK_MESSAGE(swept.status == 0, swept.err);
    CHECK(lines_of(read_file(folder / "table")).size() == 3);
  }
  write_file(folder / "table.rows", "somebody's");
  CHECK(in_folder(folder, "sweep E s.c2s --response load --results table --resume").status == 2);
}

TEST_CASE("hostile input: names of files that begin with a dash") {
  const Folder folder;
  write_file(folder / "-q", read_file(kHertzDeck));
  for (const char* words : {"check ./-q", "check -- -q", "run --csv ./-c -- -q", "run --csv=-d ./-q", "run ./-q --json -j"}) {
    CAPTURE(words);
    const Result result = in_folder(folder, words);
    CHECK_MESSAGE(result.status == 0, result.err);
  }
  for (const char* name : {"-c", "-d", "-j"}) CHECK_MESSAGE(fs::exists(folder / name), name);
  write_file(folder / "-p", "1 1\n0.5 1.1\n0 1\n");
  write_file(folder / "-s.c2s", "parameter E 1\nbody b E E nu 0.3\nfrom 0 0\nline s to 1 0\nline e to 1 1\n"
                                "spline n file -p\nline w close\nfix b.s\ntraction b.e x 1\ntolerance off\n");
  write_file(folder / "-t", "E\n1\n");
  const Result swept = in_folder(folder, "sweep --response load -- -t -s.c2s");
  CHECK_MESSAGE(swept.status == 0, swept.err);
}

TEST_CASE("hostile input: a contact that is a point but for round-off refuses no picture") {
  const Folder folder;
  // A round pad with a flat, pressed, and sheared one way and back: the contact ends at one corner of the flat.
  write_file(folder / "pad.c2s", "parameter R 100  b 0.8  a 1  f0 {asin(b/a)}  w 40  h {R - sqrt(R^2 - (w - b)^2)}\n"
                                 "parameter P {200e3/(2*(1 - 0.3^2)) * a^2/R * (pi - 2*f0 - sin(2*f0))/4}\n"
                                 "body block E 200e3 nu 0.3\n from -160 -160\n line bottom to 160 -160\n line right to 90 0\n"
                                 " line top to -160 0\n line left close\n"
                                 "body pad E 200e3 nu 0.3\n from {-w} h\n line face to b 0\n line right to w 60\n"
                                 " line top to {-w} 60\n line left close\n"
                                 "fix block.bottom\ncase normal\ncontact block.top pad.face mu 0.6\n"
                                 "platen pad.top about 0 60 force 0 {-P} turn 0\n"
                                 "case shear\nplaten pad.top about 0 60 force {0.36*P} 0\n"
                                 "history normal 1; shear 1, -1, 1\ntolerance off\n");
  const Result result = in_folder(folder, "run pad.c2s --figures figures --listing /dev/null");
  CHECK_MESSAGE(result.status == 0, result.err);
  CHECK(fs::exists(folder / "figures/stress.svg"));
}

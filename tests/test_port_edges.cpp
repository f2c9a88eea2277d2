// The stores of the ports at the ends of what they take: nothing at all, tapes that are closed or were never opened, sizes
// beyond all that can be counted, files that fail.
#include "shell.hpp"

#include <contact2d.h>

#include <c2d_memory.h>
#include <c2d_posix.h>
#include <c2d_stdio.h>
#include <c2d_threads.h>

#include <doctest/doctest.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <unistd.h>

using namespace test;

TEST_CASE("port/memory: tapes that are closed, blocks of no bytes, more than can be counted") {
  char region[256], data[64] = "twelve bytes";
  c2d_memory_store store;
  c2d_port port = C2D_INIT(c2d_port);
  c2d_memory_store_init(&store, region, sizeof region);
  c2d_memory_store_port(&store, &port);
  for (const int32_t tape : {-1, 0, int32_t{C2D_TAPES}}) { // none is open
    CHECK(port.read(&store, tape, 0, data, 1) == C2D_MEMORY_STORE_TAPE);
    CHECK(port.write(&store, tape, 0, data, 1) == C2D_MEMORY_STORE_TAPE);
    CHECK(port.sync(&store, tape) == C2D_MEMORY_STORE_TAPE);
    CHECK(port.close(&store, tape) == C2D_MEMORY_STORE_TAPE);
  }
  REQUIRE(port.open(&store, 1, 3, 4) == 0); // blocks shorter than a mark
  CHECK(std::string(region, 12) == std::string(12, '\0'));
  CHECK(port.write(&store, 1, 2, data, 4) == 0);
  CHECK(port.write(&store, 1, 2, data, 0) == 0);
  CHECK(port.write(&store, 1, 3, data, 1) == C2D_MEMORY_STORE_RANGE);
  CHECK(port.write(&store, 1, 0, data, 5) == C2D_MEMORY_STORE_RANGE);
  char back[4] = "";
  CHECK(port.read(&store, 1, 2, back, 0) == 0);
  CHECK(port.read(&store, 1, 2, back, 4) == 0);
  CHECK(std::memcmp(back, "twel", 4) == 0);
  for (const int32_t tape : {0, 2}) CHECK(port.open(&store, tape, UINT64_MAX, 8) == C2D_MEMORY_STORE_FULL);
  CHECK(c2d_memory_store_need(&store) == UINT64_MAX);
  c2d_memory_store_init(&store, nullptr, 256); // nothing is there, whatever is said
  CHECK(port.open(&store, 0, 1, 1) == C2D_MEMORY_STORE_FULL);
}

TEST_CASE("port/stdio: tapes that are opened again, files that fail") {
  const Folder folder;
  c2d_stdio_store store;
  c2d_port port = C2D_INIT(c2d_port);
  REQUIRE(c2d_stdio_store_init(&store, folder.path().c_str()) == 0);
  c2d_stdio_store_port(&store, &port);
  CHECK(port.open(&store, 0, UINT64_MAX / 2, 16) == C2D_STDIO_STORE_RANGE);
  CHECK(port.open(&store, 0, 0, UINT64_MAX) == 0); // of no blocks
  char data[8] = "seven..";
  REQUIRE(port.open(&store, 0, 2, 8) == 0); // and once more, left open
  REQUIRE(port.write(&store, 0, 1, data, 8) == 0);
  REQUIRE(port.sync(&store, 0) == 0);
  REQUIRE(port.open(&store, 0, 2, 8) == 0);
  char back[8] = "";
  CHECK(port.read(&store, 0, 1, back, 8) == 0);
  CHECK(std::memcmp(back, data, 8) == 0);
  // Whose descriptor is taken away under them.
  const auto take_away = [&] { ::close(::fileno(static_cast<FILE*>(store.file[0]))); };
  take_away();
  CHECK(port.read(&store, 0, 0, back, 8) == EBADF);
  CHECK(port.close(&store, 0) == EBADF);
  REQUIRE(port.open(&store, 0, 2, 8) == 0);
  take_away();
  CHECK(port.open(&store, 0, 2, 8) == EBADF);
  CHECK(port.sync(&store, 0) == C2D_STDIO_STORE_TAPE); // it is closed all the same
  // A file that can be gone about in, and not read.
  REQUIRE(port.open(&store, 0, 2, 8) == 0);
  const FILE* whole = std::freopen((folder / "tape0.c2d").c_str(), "ab", static_cast<FILE*>(store.file[0]));
  REQUIRE(whole != nullptr);
  CHECK(port.read(&store, 0, 0, back, 8) == EBADF);
  CHECK(port.close(&store, 0) == 0);
  // Folders that are called as tapes are: the first failure is told.
  CHECK(c2d_stdio_store_remove(&store) == 0);
  for (const char* name : {"tape1.c2d", "tape2.c2d"}) {
    fs::create_directory(folder / name);
    write_file(folder / name + "/full", "x");
  }
  CHECK(c2d_stdio_store_remove(&store) == ENOTEMPTY);
  CHECK(port.open(&store, 1, 2, 8) == EISDIR);
}

TEST_CASE("port/posix: tickets that nobody has, folders that cannot be, tapes that are links") {
  const Folder folder;
  c2d_posix_store store;
  CHECK(c2d_posix_store_init(&store, nullptr) == ENOENT);
  CHECK(c2d_posix_store_init(&store, "") == ENOENT);
  CHECK(c2d_posix_store_init(&store, (folder / "none/of/these").c_str()) == ENOENT);
  write_file(folder / "file", "x");
  CHECK(c2d_posix_store_init(&store, (folder / "file").c_str()) == ENOTDIR);
  REQUIRE(c2d_posix_store_init(&store, (folder / "store").c_str()) == 0);
  c2d_port port = C2D_INIT(c2d_port);
  c2d_posix_store_port(&store, &port);
  for (const int32_t ticket : {-2, 0, 1, 99}) CHECK(port.wait(&store, ticket) == C2D_POSIX_STORE_TICKET);
  char data[8] = "seven..";
  for (const int32_t tape : {-1, 0, int32_t{C2D_TAPES}}) {
    CHECK(port.read(&store, tape, 0, data, 8) == C2D_POSIX_STORE_TAPE);
    CHECK(port.write(&store, tape, 0, data, 8) == C2D_POSIX_STORE_TAPE);
    CHECK(port.sync(&store, tape) == C2D_POSIX_STORE_TAPE);
    CHECK(port.close(&store, tape) == C2D_POSIX_STORE_TAPE);
  }
  for (const int32_t tape : {-1, int32_t{C2D_TAPES}}) CHECK(port.open(&store, tape, 1, 8) == C2D_POSIX_STORE_TAPE);
  CHECK(port.open(&store, 0, UINT64_MAX / 2, 16) == C2D_POSIX_STORE_RANGE);
  CHECK(port.open(&store, 0, 0, UINT64_MAX) == 0);
  REQUIRE(port.open(&store, 0, 4, 8) == 0);
  CHECK(port.read(&store, 0, 4, data, 8) == C2D_POSIX_STORE_RANGE);
  CHECK(port.read(&store, 0, 0, data, 9) == C2D_POSIX_STORE_RANGE);
  CHECK(port.read(&store, 0, 0, data, 8) == C2D_POSIX_STORE_END); // nothing is written yet
  int32_t ticket = -1;
  REQUIRE(port.start_write(&store, 0, 2, data, 8, &ticket) == 0);
  CHECK(port.wait(&store, ticket) == 0);
  CHECK(port.wait(&store, ticket) == C2D_POSIX_STORE_TICKET); // once
  for (const int32_t none : {-2, 99, INT32_MAX}) CHECK(port.wait(&store, none) == C2D_POSIX_STORE_TICKET);
  CHECK(port.wait(&store, -1) == 0); // what was done at once
  REQUIRE(port.start_read(&store, 0, 4, data, 8, &ticket) == 0);
  CHECK(port.wait(&store, ticket) == C2D_POSIX_STORE_RANGE); // its failure comes when it is waited for
  // A tape that is a link, a folder, or has two names, is somebody else's.
  const std::string own = folder / "store/" C2D_POSIX_STORE_FOLDER "/";
  fs::create_symlink(folder / "file", own + "tape1.c2d");
  CHECK(port.open(&store, 1, 4, 8) == C2D_POSIX_STORE_FOREIGN);
  fs::create_directory(own + "tape2.c2d");
  CHECK(port.open(&store, 2, 4, 8) == C2D_POSIX_STORE_FOREIGN);
  fs::create_hard_link(folder / "file", own + "tape3.c2d");
  CHECK(port.open(&store, 3, 4, 8) == C2D_POSIX_STORE_FOREIGN);
  CHECK(read_file(folder / "file") == "x");
  // Whose descriptor is taken away under it.
  ::close(store.file[0]);
  CHECK(port.sync(&store, 0) == EBADF);
  CHECK(port.write(&store, 0, 0, data, 8) == EBADF);
  CHECK(port.read(&store, 0, 0, data, 8) == EBADF);
  CHECK(port.open(&store, 0, 4, 8) == EBADF);
  CHECK(c2d_posix_store_discard(&store, nullptr) == EISDIR);
  c2d_posix_store_done(&store);
  // What has no mark and is not empty is not ours.
  const std::string other = folder / "other";
  fs::create_directories(other + "/" C2D_POSIX_STORE_FOLDER);
  write_file(other + "/" C2D_POSIX_STORE_FOLDER "/theirs", "x");
  CHECK(c2d_posix_store_init(&store, other.c_str()) == C2D_POSIX_STORE_FOREIGN);
  fs::remove(other + "/" C2D_POSIX_STORE_FOLDER "/theirs");
  fs::create_directory(other + "/" C2D_POSIX_STORE_FOLDER "/lock");
  CHECK(c2d_posix_store_init(&store, other.c_str()) == C2D_POSIX_STORE_FOREIGN);
  fs::remove_all(other + "/" C2D_POSIX_STORE_FOLDER);
  write_file(other + "/" C2D_POSIX_STORE_FOLDER, "x");
  CHECK(c2d_posix_store_init(&store, other.c_str()) == C2D_POSIX_STORE_FOREIGN);
}

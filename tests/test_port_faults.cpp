// Every call of the system that a store makes in its life fails, one after the other and in every way: what is interrupted or
// half done goes on, what fails is told by its number, and nothing is held.
#include "shell.hpp"
#include "system_calls.hpp"

#include <contact2d.h>

#include <c2d_posix.h>
#include <c2d_stdio.h>
#include <c2d_threads.h>

#include <doctest/doctest.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <map>
#include <set>

using namespace test;

namespace {

constexpr uint64_t kBytes = 3000;

std::string block(char of) { return std::string(kBytes, of); }

size_t open_files() {
  size_t count = 0;
  for ([[maybe_unused]] const auto& entry : fs::directory_iterator("/proc/self/fd")) ++count;
  return count;
}

// Blocks are written in both ways, and read again after the tape was closed; all is removed. The first failure ends it.
int32_t live(c2d_posix_store& store, const std::string& folder) {
  c2d_port port = C2D_INIT(c2d_port);
  int32_t code = c2d_posix_store_init(&store, folder.c_str()), ticket = -1;
  const auto go = [&code](int32_t next) { return code == 0 ? code = next : code; };
  if (code != 0) return code;
  c2d_posix_store_port(&store, &port);
  std::string first = block('a'), second = block('b'), found(kBytes, ' ');
  if (go(port.open(&store, 0, 4, kBytes)) != 0) return code;
  go(port.write(&store, 0, 1, first.data(), kBytes));
  if (code != 0) return code; // nothing is begun that would be under way when `second` is gone
  if (go(port.start_write(&store, 0, 2, second.data(), kBytes, &ticket)) == 0) go(port.wait(&store, ticket));
  if (code != 0) return code;
  go(port.sync(&store, 0));
  if (go(port.close(&store, 0)) != 0) return code;
  if (go(port.open(&store, 0, 4, kBytes)) != 0) return code;
  if (go(port.start_read(&store, 0, 1, &found[0], kBytes, &ticket)) == 0) go(port.wait(&store, ticket));
  if (code == 0) CHECK(found == first);
  if (go(port.read(&store, 0, 2, &found[0], kBytes)) == 0) CHECK(found == second);
  return code == 0 ? c2d_posix_store_discard(&store, folder.c_str()) : code;
}

// Calls that a signal may interrupt.
bool can_wait(const std::string& call) {
  return call.find("open") == 0 || call.find("p") == 0 || call == "flock" || call == "fsync" || call == "fallocate64" ||
         call == "close";
}

} // namespace

TEST_CASE("port/posix: every call of the system fails once, in every way") {
  if (!can_judge_calls()) return;
  const Folder folder;
  const std::string place = folder / "store";
  const auto judged_life = [&](const SystemJudge& judge) {
    c2d_posix_store store;
    const size_t before = open_files();
    int32_t code;
    {
      const SystemCalls calls(judge);
      code = live(store, place);
    }
    c2d_posix_store_done(&store);
    CHECK(open_files() == before);
    // Whatever was left: another store takes it up, and leaves nothing.
    REQUIRE(live(store, place) == 0);
    CHECK(folder.names().empty());
    return code;
  };
  std::map<int64_t, std::string> names;
  REQUIRE(judged_life([&](const SystemCall& call) {
            if (std::strcmp(call.name, "calloc") != 0)
              names[call.number] = call.name; // that one is of counters (make coverage)
            return kDone;
          }) == 0);
  CHECK(names.size() > 40);
  // Of the folder above, so that a new name is found again: one that may not be read cannot be helped.
  std::set<int64_t> above;
  for (auto call = ++names.find(2); call->second != "mkdirat"; ++call) above.insert(call->first);
  REQUIRE((names[2] == "open64" && above.size() == 3));
  // Reads before a tape has its room are of the store's mark. One that finds nothing: it is written, and read again.
  int64_t room_at = 0;
  for (const auto& entry : names)
    if (room_at == 0 && entry.second == "fallocate64") room_at = entry.first;
  REQUIRE(room_at > 0);
  const auto fates_of = [](const std::string& name) {
    std::vector<int> fates = {EINTR, EIO};
    if (name == "fsync") fates.insert(fates.end(), {EINVAL, ENOTSUP});
    if (name == "fallocate64") fates.insert(fates.end(), {ENOSPC, EDQUOT, EFBIG});
    if (name == "unlinkat" || name == "rmdir") fates.push_back(ENOTEMPTY);
    if (name == "fstatvfs64") fates.push_back(0);
    if (name == "pread64" || name == "pwrite64") fates.insert(fates.end(), {0, kHalf});
    return fates;
  };
  for (const auto& entry : names)
    for (const int fate : fates_of(entry.second)) {
      const auto& name = entry.second;
      const auto number = entry.first;
      CAPTURE(name);
      CAPTURE(number);
      CAPTURE(fate);
      std::string struck;
      const int64_t wanted = number;
      const int32_t code = judged_life([&](const SystemCall& call) {
        if (call.number != wanted) return int{kDone};
        struck = call.name;
        return fate;
      });
      if (struck != name) continue; // the thread and its caller have changed turns
      if (fate == kHalf || (fate == EINTR && can_wait(name))) CHECK(code == 0);
      if (code > 0) CHECK(code == fate);
      const bool of_mark = name == "pread64" && number < room_at;
      if (code < 0) CHECK((fate == 0 && code == (name == "pread64" && !of_mark ? C2D_POSIX_STORE_END : C2D_POSIX_STORE_STUCK)));
      const bool room = name == "fallocate64" && fate != ENOSPC && fate != EDQUOT && fate != EFBIG;
      const bool folder_only = name == "fsync" && (fate == EINVAL || fate == ENOTSUP); // some cannot sync folders
      const bool helped =
          name == "fstatvfs64" || name == "pthread_create" || name == "malloc" || fate == ENOTEMPTY || (of_mark && fate == 0);
      if (code == 0 && fate != EINTR && fate != kHalf && above.count(number) == 0) CHECK((room || folder_only || helped));
    }
}

TEST_CASE("port/posix: a full disk gives back what was found of a tape's room, once it can") {
  if (!can_judge_calls()) return;
  const Folder folder;
  c2d_posix_store store;
  c2d_port port = C2D_INIT(c2d_port);
  REQUIRE(c2d_posix_store_init(&store, folder.path().c_str()) == 0);
  c2d_posix_store_port(&store, &port);
  for (const int trouble : {int{kDone}, EINTR, EIO}) {
    int asked = 0;
    const SystemCalls calls([&](const SystemCall& call) {
      if (std::string(call.name) == "fallocate64") return ENOSPC;
      if (std::string(call.name) != "ftruncate64") return int{kDone};
      return ++asked < 3 ? trouble : int{kDone};
    });
    CHECK(port.open(&store, 1, 4, kBytes) == ENOSPC);
    CHECK(asked == (trouble == EINTR ? 3 : 1));
    CHECK(port.sync(&store, 1) == C2D_POSIX_STORE_TAPE); // it is not open
  }
  // What is told to be there is not asked for.
  CHECK(port.open(&store, 1, uint64_t(1) << 50, 4096) == ENOSPC);
  CHECK(c2d_posix_store_discard(&store, nullptr) == 0);
}

TEST_CASE("port/posix: locks' files that are removed before they are locked, and folders that are not ours") {
  if (!can_judge_calls()) return;
  const Folder folder;
  const std::string lock = folder / C2D_POSIX_STORE_FOLDER "/lock";
  c2d_posix_store store;
  for (const int times : {1, 9, 10}) {
    int turns = 0;
    const SystemCalls calls([&](const SystemCall& call) {
      if (std::string(call.name) == "flock" && ++turns <= times) fs::remove(lock); // by the one who held it
      return int{kDone};
    });
    CHECK(c2d_posix_store_init(&store, folder.path().c_str()) == (times < 10 ? 0 : C2D_POSIX_STORE_LOCKED));
    CHECK(turns == (times < 10 ? times + 1 : 10));
    if (times < 10) CHECK(c2d_posix_store_discard(&store, nullptr) == 0);
  }
  fs::remove_all(folder / C2D_POSIX_STORE_FOLDER);
  fs::create_directory(folder / C2D_POSIX_STORE_FOLDER);
  for (const char* name : {"/one", "/two", "/three"}) write_file(folder / C2D_POSIX_STORE_FOLDER + name, "x");
  CHECK(c2d_posix_store_init(&store, folder.path().c_str()) == C2D_POSIX_STORE_FOREIGN);
  CHECK(!fs::exists(lock));
}

TEST_CASE("port/posix: blocks of more bytes than systems take at once go in parts; of failures the first is told") {
  if (!can_judge_calls()) return;
  const Folder folder;
  c2d_posix_store store;
  c2d_port port = C2D_INIT(c2d_port);
  REQUIRE(c2d_posix_store_init(&store, folder.path().c_str()) == 0);
  c2d_posix_store_port(&store, &port);
  constexpr uint64_t kGigabyte = uint64_t(1) << 30, kLarge = 2 * kGigabyte + 5;
  std::vector<uint64_t> parts;
  char none = 0;
  {
    const SystemCalls calls([&](const SystemCall& call) {
      const std::string name = call.name;
      if (name == "fallocate64" || name == "fstatvfs64") return ENOTSUP;
      if (name != "pread64" && name != "pwrite64") return int{kDone};
      parts.push_back(call.bytes);
      return int{kPretended};
    });
    REQUIRE(port.open(&store, 0, 3, kLarge) == 0);
    CHECK(port.write(&store, 0, 2, &none, kLarge) == 0);
    CHECK(port.read(&store, 0, 2, &none, kLarge) == 0);
  }
  const uint64_t expected[] = {kGigabyte, kGigabyte, 5};
  REQUIRE(parts.size() == 6);
  for (size_t i = 0; i < 6; ++i) CHECK(parts[i] == expected[i % 3]);
  const auto fails_from = [](int first) {
    return [next = first](const SystemCall& call) mutable { return std::string(call.name) == "close" ? next++ : int{kDone}; };
  };
  for (int32_t tape = 1; tape < C2D_TAPES; ++tape) REQUIRE(port.open(&store, tape, 1, 8) == 0);
  {
    const SystemCalls calls(fails_from(1000));
    CHECK(c2d_posix_store_discard(&store, nullptr) == 1000);
  }
  CHECK(folder.names().size() == 1); // what was not closed well is not thrown away
  REQUIRE(c2d_posix_store_init(&store, folder.path().c_str()) == 0);
  {
    const SystemCalls calls(fails_from(1000));
    CHECK(c2d_posix_store_done(&store) == 1000);
  }
  REQUIRE(live(store, folder.path()) == 0);
}

namespace {
void add_one(void* sum, int32_t) { ++*static_cast<std::atomic<int32_t>*>(sum); }
} // namespace

TEST_CASE("port/threads: a thread that cannot be had is told, and those before it end") {
  if (!can_judge_calls()) return;
  static c2d_threads room;
  std::atomic<int32_t> sum{0};
  for (const int which : {1, 2, 3, 4}) {
    int made = 0;
    const SystemCalls calls([&](const SystemCall& call) {
      return std::string(call.name) == "pthread_create" && ++made == which ? EAGAIN : int{kDone};
    });
    CHECK(c2d_threads_start(&room, 4) == (which < 4 ? EAGAIN : 0));
    CHECK(made == (which < 4 ? which : 3));
    c2d_threads_run(&room, 10, add_one, &sum); // alone, if so
    CHECK(sum == 10 * which);
    if (which == 4) c2d_threads_stop(&room);
  }
}

TEST_CASE("port/stdio: every call of the C library fails once, and most do not say why") {
  if (!can_judge_calls()) return;
  const Folder folder;
  const auto live_in_stdio = [&](const SystemJudge& judge) {
    const SystemCalls calls(judge);
    c2d_stdio_store store;
    c2d_port port = C2D_INIT(c2d_port);
    std::string data = block('a'), found(kBytes, ' ');
    int32_t code = c2d_stdio_store_init(&store, folder.path().c_str());
    const auto go = [&code](int32_t next) { return code == 0 ? code = next : code; };
    c2d_stdio_store_port(&store, &port);
    go(port.open(&store, 0, 4, kBytes));
    if (code == 0) go(port.write(&store, 0, 1, data.data(), kBytes));
    if (code == 0) go(port.sync(&store, 0));
    if (code == 0) go(port.open(&store, 0, 4, kBytes)); // left open
    if (code == 0) go(port.read(&store, 0, 1, &found[0], kBytes));
    if (code == 0) CHECK(found == data);
    const int32_t closed = port.close(&store, 0);
    if (closed != C2D_STDIO_STORE_TAPE) go(closed);
    go(c2d_stdio_store_remove(&store));
    return code;
  };
  std::map<int64_t, std::string> names;
  REQUIRE(live_in_stdio([&](const SystemCall& call) {
            if (std::strcmp(call.name, "calloc") != 0)
              names[call.number] = call.name; // that one is of counters (make coverage)
            return kDone;
          }) == 0);
  CHECK(folder.names().empty());
  CHECK(names.size() > 12);
  for (const auto& entry : names)
    for (const int fate : {EIO, 0}) {
      const auto& name = entry.second;
      const auto number = entry.first;
      CAPTURE(name);
      CAPTURE(number);
      const int64_t wanted = number;
      CHECK(live_in_stdio([&](const SystemCall& call) { return call.number == wanted ? fate : int{kDone}; }) ==
            (fate != 0 ? fate : C2D_STDIO_STORE_FAILED));
      REQUIRE(live_in_stdio([](const SystemCall&) { return kDone; }) == 0); // the next one finds no harm
      CHECK(folder.names().empty());
    }
}

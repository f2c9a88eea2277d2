// Calls of POSIX as port/windows makes them, where the program's outputs do not tell: offsets beyond 4 GiB, what is open and
// renamed or removed, locks, links. Prints what fails; argument: an empty folder.
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <dirent.h>
#include <fcntl.h>
#include <memory>
#include <string>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

namespace {

int failed = 0;
void check(bool holds, const char* what) {
  if (holds) return;
  std::printf("%s (errno %d)\n", what, errno);
  ++failed;
}
#define CHECK(condition) check((condition), #condition)

std::string folder;
std::string in(const char* name) { return folder + "/" + name; }
int made(const char* name) { return open(in(name).c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666); }
bool is_there(const char* name) { return access(in(name).c_str(), F_OK) == 0; }

void check_offsets() {
  const int file = made("large");
  const off_t far = (off_t{5} << 30) + 3;
  char text[8] = {};
  CHECK(write(file, "ab", size_t{2}) == 2);
  CHECK(pwrite(file, "far", 3, far) == 3);
  CHECK(pread(file, text, sizeof text, far) == 3);
  CHECK(std::strcmp(text, "far") == 0);
  CHECK(pread(file, text, sizeof text, far + 3) == 0);
  CHECK(write(file, "c\n", size_t{2}) == 2); // where the first had ended
  CHECK(pread(file, text, 4, 0) == 4);
  CHECK(std::memcmp(text, "abc\n", 4) == 0);
  struct stat about;
  CHECK(fstat(file, &about) == 0);
  CHECK(about.st_size == far + 3);
  CHECK(ftruncate(file, 4) == 0);
  CHECK(fallocate(file, FALLOC_FL_KEEP_SIZE, 0, 2) == 0); // less than there is
  fallocate(file, FALLOC_FL_KEEP_SIZE, 0, 1 << 20);       // not in wine
  CHECK((fstat(file, &about) == 0 && about.st_size == 4));
  CHECK(fsync(file) == 0);
  struct statvfs disk = {};
  CHECK((fstatvfs(file, &disk) == 0 && disk.f_blocks >= disk.f_bavail && disk.f_bavail > 0));
  CHECK(close(file) == 0);
  CHECK((sysconf(_SC_AVPHYS_PAGES) > 0 && sysconf(_SC_PAGESIZE) > 0));
}

void check_names() {
  const int aside = made("aside"), old = made("name");
  CHECK((aside >= 0 && old >= 0));
  CHECK((made("name") < 0 && errno == EEXIST));
  CHECK(write(aside, "new", size_t{3}) == 3);
  close(old);
  CHECK(rename(in("aside").c_str(), in("name").c_str()) == 0); // what is open, over what is there
  CHECK((!is_there("aside") && is_there("name")));
  struct stat by_name, by_number;
  CHECK((stat(in("name").c_str(), &by_name) == 0 && fstat(aside, &by_number) == 0));
  CHECK((by_name.st_ino == by_number.st_ino && by_name.st_ino != 0 && by_name.st_size == 3));
  CHECK((S_ISREG(by_name.st_mode) && by_name.st_nlink == 1));
  close(aside);
  CHECK(unlink(in("name").c_str()) == 0);
  CHECK((unlink(in("name").c_str()) != 0 && errno == ENOENT));
  CHECK((open(folder.c_str(), O_RDONLY) < 0 && errno == EISDIR));
  const std::string text = in("large");
  CHECK((open(text.c_str(), O_RDONLY | O_DIRECTORY) < 0 && errno == ENOTDIR));
  CHECK((rmdir(text.c_str()) != 0 && errno == ENOTDIR));
  CHECK((open(in("no/such").c_str(), O_RDONLY) < 0 && errno == ENOENT));
  char* real = realpath(in("./large").c_str(), nullptr);
  CHECK((real != nullptr && std::string(real).find("\\large") != std::string::npos));
  std::string pattern = in("temporary-XXXXXX");
  CHECK((mkdtemp(&pattern[0]) != nullptr && rmdir(pattern.c_str()) == 0));
}

void check_long_names() {
  std::string text = "Gr\u00f6\u00dfe ";
  while (text.size() < 200) text += "very long ";
  text.pop_back(); // no name ends in a blank here
  const std::string first = folder + "\\" + text, second = first + "/" + text, name = second + "\\f"; // longer than 260
  CHECK((mkdir(first.c_str(), 0777) == 0 && mkdir(second.c_str(), 0777) == 0));
  CHECK((mkdir(second.c_str(), 0777) != 0 && errno == EEXIST));
  close(open(name.c_str(), O_WRONLY | O_CREAT, 0666));
  CHECK((rmdir(second.c_str()) != 0 && errno == ENOTEMPTY));
  CHECK((rename(name.c_str(), (name + "1").c_str()) == 0 && unlink((name + "1").c_str()) == 0));
  CHECK((rmdir(second.c_str()) == 0 && rmdir(first.c_str()) == 0));
}

void check_folders() {
  const std::string text = in("Ma\u00df");
  CHECK((mkdir(text.c_str(), 0777) == 0 && mkdir((text + "/own").c_str(), 0777) == 0));
  const int above = open(text.c_str(), O_RDONLY | O_DIRECTORY), own = openat(above, "own", O_RDONLY | O_DIRECTORY);
  const int lock = openat(own, "lock", O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW);
  CHECK((above >= 0 && own >= 0 && lock >= 0));
  CHECK((fsync(own) != 0 && errno == EINVAL));
  DIR* list = fdopendir(openat(own, ".", O_RDONLY | O_DIRECTORY));
  CHECK(list != nullptr);
  if (list == nullptr) return;
  std::string names;
  while (const dirent* entry = readdir(list)) names += std::string(entry->d_name) + ";";
  closedir(list);
  CHECK(names == ".;..;lock;");
  CHECK((unlinkat(above, "own", AT_REMOVEDIR) != 0 && errno == ENOTEMPTY));
  CHECK(unlinkat(own, "lock", 0) == 0); // all of it is open, and goes
  CHECK(unlinkat(above, "own", AT_REMOVEDIR) == 0);
  close(own), close(lock), close(above);
  CHECK(rmdir(text.c_str()) == 0);
}

void check_locks() {
  const int one = made("lock"), other = open(in("lock").c_str(), O_RDWR);
  CHECK(flock(one, LOCK_EX | LOCK_NB) == 0);
  CHECK((flock(other, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK));
  CHECK(write(other, "x", size_t{1}) == 1); // nobody is kept from the bytes
  CHECK(close(one) == 0);
  CHECK(flock(other, LOCK_EX | LOCK_NB) == 0);
  const int more = open(in("lock").c_str(), O_RDWR | O_APPEND);
  char text[4] = {};
  CHECK((write(more, "yz", size_t{2}) == 2 && pread(more, text, sizeof text, 0) == 3));
  CHECK(std::strcmp(text, "xyz") == 0);
  close(other), close(more);
  CHECK((isatty(1) == 0 && isatty(2) == 0));
}

} // namespace

int contact2d_main(int, char** words) {
  folder = words[1];
  check_offsets();
  check_names();
  check_long_names();
  check_folders();
  check_locks();
  CHECK((unlink(in("large").c_str()) == 0 && unlink(in("lock").c_str()) == 0 && rmdir(folder.c_str()) == 0)); // nothing is left
  std::printf("%d failed\n", failed);
  return failed == 0 ? 0 : 1;
}

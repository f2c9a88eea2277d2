// POSIX calls on open files, implemented by Windows calls.
#include "wide.hpp"

#include "console.hpp"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <io.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

using windows::fail;
using windows::handle_of;

namespace {

constexpr size_t kMost = size_t{1} << 30;
DWORD part(size_t bytes) { return static_cast<DWORD>(std::min(bytes, kMost)); }

OVERLAPPED place_of(uint64_t at) {
  OVERLAPPED place = {};
  place.Offset = static_cast<DWORD>(at);
  place.OffsetHigh = static_cast<DWORD>(at >> 32);
  return place;
}

// Transfers at a given offset move the file position; it is restored here.
class Kept {
public:
  explicit Kept(HANDLE file) : file_(file) { SetFilePointerEx(file_, LARGE_INTEGER{}, &place_, FILE_CURRENT); }
  ~Kept() { SetFilePointerEx(file_, place_, nullptr, FILE_BEGIN); }
  Kept(const Kept&) = delete;
  Kept& operator=(const Kept&) = delete;

private:
  HANDLE file_;
  LARGE_INTEGER place_ = {};
};

ssize_t read_code() {
  const DWORD error = GetLastError();
  return error == ERROR_HANDLE_EOF || error == ERROR_BROKEN_PIPE ? 0 : fail();
}

} // namespace

// An interrupted console read returns no bytes.
ssize_t read(int file, void* data, size_t bytes) {
  const windows::Waiting waiting(file == 0);
  DWORD got = 0;
  SetLastError(0);
  const bool done = ReadFile(handle_of(file), data, part(bytes), &got, nullptr) != 0;
  if (done && (got > 0 || GetLastError() != ERROR_OPERATION_ABORTED)) return got;
  return read_code();
}

ssize_t write(int file, const void* data, size_t bytes) { return _write(file, data, part(bytes)); }

ssize_t pread(int file, void* data, size_t bytes, off_t at) {
  const HANDLE handle = handle_of(file);
  const Kept kept(handle);
  OVERLAPPED place = place_of(static_cast<uint64_t>(at));
  DWORD got = 0;
  return ReadFile(handle, data, part(bytes), &got, &place) != 0 ? static_cast<ssize_t>(got) : read_code();
}

ssize_t pwrite(int file, const void* data, size_t bytes, off_t at) {
  const HANDLE handle = handle_of(file);
  const Kept kept(handle);
  OVERLAPPED place = place_of(static_cast<uint64_t>(at));
  DWORD put = 0;
  return WriteFile(handle, data, part(bytes), &put, &place) != 0 ? static_cast<ssize_t>(put) : fail();
}

// Folders need no sync: the system keeps a journal of names.
int fsync(int file) {
  struct stat about;
  if (fstat(file, &about) != 0) return -1;
  if (S_ISDIR(about.st_mode)) return fail(EINVAL);
  return FlushFileBuffers(handle_of(file)) != 0 ? 0 : fail();
}

// A byte beyond any file: locks block access to the locked bytes here.
int flock(int file, int how) {
  OVERLAPPED place = place_of(uint64_t{1} << 62);
  const DWORD flags = LOCKFILE_EXCLUSIVE_LOCK | ((how & LOCK_NB) != 0 ? LOCKFILE_FAIL_IMMEDIATELY : 0);
  if (LockFileEx(handle_of(file), flags, 0, 1, 0, &place) != 0) return 0;
  fail();
  return fail(errno == EINVAL ? EOPNOTSUPP : errno); // a file system without locks
}

int fallocate(int file, int, off_t, off_t bytes) {
  struct stat about;
  if (fstat(file, &about) != 0) return -1;
  if (bytes <= about.st_size) return 0; // smaller sizes would truncate it
  FILE_ALLOCATION_INFO room;
  room.AllocationSize.QuadPart = bytes;
  return SetFileInformationByHandle(handle_of(file), FileAllocationInfo, &room, sizeof room) != 0 ? 0 : fail();
}

int fstatvfs(int file, struct statvfs* disk) {
  const std::wstring name = windows::name_of(handle_of(file)), folder = name.substr(0, name.rfind(L'\\') + 1);
  ULARGE_INTEGER mine, all;
  if (GetDiskFreeSpaceExW(folder.c_str(), &mine, &all, nullptr) == 0) return fail();
  constexpr uint64_t kUnit = 512;
  *disk = {all.QuadPart / kUnit, kUnit, mine.QuadPart / kUnit};
  return 0;
}

long sysconf(int what) {
  constexpr long kPage = 4096;
  MEMORYSTATUSEX memory = {};
  memory.dwLength = sizeof memory;
  if (what == _SC_PAGESIZE) return kPage;
  if (GlobalMemoryStatusEx(&memory) == 0) return fail();
  return static_cast<long>(std::min<uint64_t>(memory.ullAvailPhys / kPage, 0x7fffffff));
}

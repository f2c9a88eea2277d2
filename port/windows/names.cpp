// POSIX calls on file names, in UTF-8, implemented by Windows calls.
#include "wide.hpp"

#include <cerrno>
#include <cstring>
#include <dirent.h>
#include <fcntl.h>
#include <io.h>
#include <new>
#include <sys/stat.h>
#include <unistd.h>

using windows::fail;
using windows::Handle;
using windows::handle_of;
using windows::narrow;
using windows::open_shared;
using windows::wide;

namespace {

bool is_folder(HANDLE file) {
  FILE_STANDARD_INFO about;
  return GetFileInformationByHandleEx(file, FileStandardInfo, &about, sizeof about) != 0 && about.Directory;
}

// A link; other specially stored files (in a cloud, compressed) are ordinary files.
bool is_link(const std::wstring& name) {
  const Handle file(open_shared(name, FILE_READ_ATTRIBUTES, OPEN_EXISTING, FILE_FLAG_OPEN_REPARSE_POINT));
  FILE_ATTRIBUTE_TAG_INFO about = {};
  if (!file.is_open() || GetFileInformationByHandleEx(file, FileAttributeTagInfo, &about, sizeof about) == 0) return false;
  const bool leads = about.ReparseTag == IO_REPARSE_TAG_SYMLINK || about.ReparseTag == IO_REPARSE_TAG_MOUNT_POINT;
  return (about.FileAttributes & FILE_ATTRIBUTE_REPARSE_POINT) != 0 && leads;
}

DWORD access_of(int flags) {
  const int way = flags & O_ACCMODE;
  return way == O_RDONLY ? GENERIC_READ : way == O_WRONLY ? GENERIC_WRITE : GENERIC_READ | GENERIC_WRITE;
}

DWORD creation_of(int flags) {
  if ((flags & O_CREAT) == 0) return (flags & O_TRUNC) != 0 ? TRUNCATE_EXISTING : OPEN_EXISTING;
  if ((flags & O_EXCL) != 0) return CREATE_NEW;
  return (flags & O_TRUNC) != 0 ? CREATE_ALWAYS : OPEN_ALWAYS;
}

int open_wide(const std::wstring& name, int flags) {
  if ((flags & O_NOFOLLOW) != 0 && is_link(name)) return fail(ELOOP);
  Handle file(open_shared(name, access_of(flags), creation_of(flags)));
  if (!file.is_open()) {
    fail();
    if ((flags & O_CREAT) != 0 && errno == ENOENT && GetLastError() == ERROR_ACCESS_DENIED) errno = EEXIST; // deletion pending
    return -1;
  }
  const bool folder = GetFileType(file) == FILE_TYPE_DISK && is_folder(file), expected = (flags & O_DIRECTORY) != 0;
  if (folder != expected) return fail(folder ? EISDIR : ENOTDIR);
  const int number = _open_osfhandle(reinterpret_cast<intptr_t>(static_cast<HANDLE>(file)), flags & (O_APPEND | O_CLOEXEC));
  if (number >= 0) file.release(); // the number owns it now
  return number;
}

// A name in an open folder.
std::wstring name_in(int folder, const char* name) {
  std::wstring path = windows::name_of(handle_of(folder));
  if (path.empty() || std::strcmp(name, ".") == 0) return path;
  if (std::strcmp(name, "..") == 0) return path.substr(0, path.rfind(L'\\') + 1);
  if (path.back() != L'\\') path += L'\\';
  return path + wide(name);
}

// Removes the name at once, even of an open file, if the system supports it; else when it is closed for the last time.
bool discard(HANDLE file, bool& at_once) {
  constexpr auto kDispositionEx = static_cast<FILE_INFO_BY_HANDLE_CLASS>(21);
  DWORD how = 1 | 2 | 16; // delete with POSIX semantics, also read-only files
  at_once = SetFileInformationByHandle(file, kDispositionEx, &how, sizeof how) != 0;
  if (at_once) return true;
  if (GetLastError() == ERROR_DIR_NOT_EMPTY || GetLastError() == ERROR_ACCESS_DENIED) return false;
  FILE_DISPOSITION_INFO old = {TRUE};
  return SetFileInformationByHandle(file, FileDispositionInfo, &old, sizeof old) != 0;
}

// Moves it out of its folder, so that the folder can be removed.
void move_up(HANDLE file) {
  std::wstring name = windows::name_of(file), folder = name.substr(0, name.rfind(L'\\'));
  name = folder + L"-" + std::to_wstring(GetCurrentProcessId()) + L"-" + std::to_wstring(GetTickCount64());
  const size_t bytes = name.size() * sizeof(wchar_t);
  std::string room(sizeof(FILE_RENAME_INFO) + bytes, '\0');
  auto* to = new (&room[0]) FILE_RENAME_INFO();
  to->FileNameLength = static_cast<DWORD>(bytes);
  std::memcpy(to->FileName, name.c_str(), bytes);
  SetFileInformationByHandle(file, FileRenameInfo, to, static_cast<DWORD>(room.size()));
}

int remove_wide(const std::wstring& name, bool folder, bool frees_folder) {
  const Handle file(open_shared(name, DELETE | FILE_READ_ATTRIBUTES, OPEN_EXISTING, FILE_FLAG_OPEN_REPARSE_POINT));
  if (!file.is_open()) return fail();
  if (is_folder(file) != folder) return fail(folder ? ENOTDIR : EISDIR);
  bool at_once = false;
  if (!discard(file, at_once)) return fail();
  if (!at_once && frees_folder) move_up(file);
  return 0;
}

int make_folder(const std::wstring& name) { return CreateDirectoryW(name.c_str(), nullptr) != 0 ? 0 : fail(); }

int describe(HANDLE file, struct windows_stat* about) {
  *about = {};
  about->st_nlink = 1;
  const DWORD type = GetFileType(file);
  if (type == FILE_TYPE_UNKNOWN) return fail(EBADF);
  about->st_mode = type == FILE_TYPE_PIPE ? S_IFIFO | 0666u : S_IFCHR | 0666u;
  if (type != FILE_TYPE_DISK) return 0;
  FILE_STANDARD_INFO more;
  if (GetFileInformationByHandleEx(file, FileStandardInfo, &more, sizeof more) == 0) return fail();
  BY_HANDLE_FILE_INFORMATION found = {}; // may be unavailable for inherited handles (wine)
  GetFileInformationByHandle(file, &found);
  const bool fixed = (found.dwFileAttributes & FILE_ATTRIBUTE_READONLY) != 0;
  about->st_mode = more.Directory ? S_IFDIR | 0777u : S_IFREG | (fixed ? 0444u : 0666u);
  about->st_dev = found.dwVolumeSerialNumber;
  about->st_ino = static_cast<uint64_t>(found.nFileIndexHigh) << 32 | found.nFileIndexLow;
  about->st_nlink = more.DeletePending ? 0 : more.NumberOfLinks;
  about->st_size = more.EndOfFile.QuadPart;
  about->st_blocks = (more.AllocationSize.QuadPart + 511) / 512;
  return 0;
}

} // namespace

extern "C" int open(const char* name, int flags, ...) {
  if (std::strcmp(name, "/dev/stdin") == 0) return _dup(0);
  return open_wide(wide(name), flags);
}
int openat(int folder, const char* name, int flags, int) {
  const std::wstring path = name_in(folder, name);
  return path.empty() ? fail() : open_wide(path, flags);
}

extern "C" int unlink(const char* name) { return remove_wide(wide(name), false, false); }
extern "C" int rmdir(const char* name) { return remove_wide(wide(name), true, false); }
int unlinkat(int folder, const char* name, int flags) {
  const std::wstring path = name_in(folder, name);
  const bool of_folder = (flags & AT_REMOVEDIR) != 0;
  return path.empty() ? fail() : remove_wide(path, of_folder, !of_folder);
}

// Replaces an existing name; virus scanners or indexers may have it open for a moment.
extern "C" int rename(const char* from, const char* to) {
  const std::wstring old = wide(from), now = wide(to);
  for (int turn = 0;; ++turn) {
    if (MoveFileExW(old.c_str(), now.c_str(), MOVEFILE_REPLACE_EXISTING | MOVEFILE_WRITE_THROUGH) != 0) return 0;
    const DWORD error = GetLastError();
    if (turn == 20 || (error != ERROR_ACCESS_DENIED && error != ERROR_SHARING_VIOLATION)) return fail();
    Sleep(10);
  }
}

extern "C" int access(const char* name, int mode) {
  struct windows_stat about;
  if (windows_stat(name, &about) != 0) return -1;
  if ((mode & W_OK) == 0) return 0;
  const Handle file(open_shared(wide(name), S_ISDIR(about.st_mode) ? FILE_ADD_FILE : GENERIC_WRITE));
  return file.is_open() ? 0 : fail();
}

int windows_stat(const char* name, struct windows_stat* about) {
  const Handle file(open_shared(wide(name), FILE_READ_ATTRIBUTES));
  return file.is_open() ? describe(file, about) : fail();
}
int fstat(int file, struct windows_stat* about) { return describe(handle_of(file), about); }
int fchmod(int, unsigned) { return 0; } // permissions are inherited from the folder

int mkdir(const char* name, int) { return make_folder(wide(name)); }
int mkdirat(int folder, const char* name, int) {
  const std::wstring path = name_in(folder, name);
  return path.empty() ? fail() : make_folder(path);
}
char* mkdtemp(char* pattern) {
  char* const digits = pattern + std::strlen(pattern) - 6;
  ULONGLONG number = GetTickCount64() * 7919 + GetCurrentProcessId();
  for (int turn = 0; turn < 1000; ++turn, number += 104729) {
    ULONGLONG rest = number;
    for (int i = 0; i < 6; ++i, rest /= 36) digits[i] = "0123456789abcdefghijklmnopqrstuvwxyz"[rest % 36];
    if (mkdir(pattern, 0700) == 0) return pattern;
    if (errno != EEXIST) return nullptr;
  }
  return nullptr;
}

char* realpath(const char* name, char*) {
  const Handle file(open_shared(wide(name), FILE_READ_ATTRIBUTES));
  const std::wstring path = file.is_open() ? windows::name_of(file) : std::wstring();
  if (!path.empty()) return strdup(narrow(path).c_str());
  fail();
  return nullptr;
}

struct DIR {
  HANDLE search;
  WIN32_FIND_DATAW next;
  bool has_next;
  dirent entry;
};

namespace {
DIR* list(const std::wstring& folder) {
  auto* out = new (std::nothrow) DIR{};
  if (out == nullptr) return fail(ENOMEM), nullptr;
  out->search = FindFirstFileW((folder + L"\\*").c_str(), &out->next);
  out->has_next = out->search != INVALID_HANDLE_VALUE;
  if (out->has_next) return out;
  fail();
  delete out;
  return nullptr;
}
} // namespace

DIR* opendir(const char* name) { return list(wide(name)); }
DIR* fdopendir(int folder) {
  DIR* const out = list(windows::name_of(handle_of(folder)));
  if (out != nullptr) _close(folder);
  return out;
}
dirent* readdir(DIR* list) {
  if (!list->has_next) return nullptr;
  const std::string name = narrow(list->next.cFileName);
  std::strncpy(list->entry.d_name, name.c_str(), sizeof list->entry.d_name - 1);
  list->has_next = FindNextFileW(list->search, &list->next) != 0;
  return &list->entry;
}
int closedir(DIR* list) {
  FindClose(list->search);
  delete list;
  return 0;
}

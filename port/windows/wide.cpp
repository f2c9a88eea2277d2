#include "wide.hpp"

#include <cerrno>
#include <io.h>

extern "C" __declspec(dllimport) long __stdcall RtlGetLastNtStatus();

namespace windows {
namespace {

constexpr long kDeletePending = static_cast<long>(0xC0000056u); // not a separate error for names

int code_of(DWORD error) {
  switch (error) {
  case ERROR_FILE_NOT_FOUND:
  case ERROR_PATH_NOT_FOUND:
  case ERROR_INVALID_NAME:
  case ERROR_BAD_NETPATH:
  case ERROR_BAD_NET_NAME:
  case ERROR_NOT_READY:
  case ERROR_INVALID_DRIVE: return ENOENT;
  case ERROR_FILE_EXISTS:
  case ERROR_ALREADY_EXISTS: return EEXIST;
  case ERROR_ACCESS_DENIED: return RtlGetLastNtStatus() == kDeletePending ? ENOENT : EACCES;
  case ERROR_SHARING_VIOLATION:
  case ERROR_WRITE_PROTECT: return EACCES;
  case ERROR_LOCK_VIOLATION:
  case ERROR_IO_PENDING: return EWOULDBLOCK;
  case ERROR_DIR_NOT_EMPTY: return ENOTEMPTY;
  case ERROR_DIRECTORY: return ENOTDIR;
  case ERROR_DISK_FULL:
  case ERROR_HANDLE_DISK_FULL: return ENOSPC;
  case ERROR_FILE_TOO_LARGE: return EFBIG;
  case ERROR_NOT_ENOUGH_MEMORY:
  case ERROR_OUTOFMEMORY: return ENOMEM;
  case ERROR_TOO_MANY_OPEN_FILES: return EMFILE;
  case ERROR_INVALID_HANDLE: return EBADF;
  case ERROR_BROKEN_PIPE:
  case ERROR_NO_DATA: return EPIPE;
  case ERROR_OPERATION_ABORTED: return EINTR;
  case ERROR_NOT_SAME_DEVICE: return EXDEV;
  case ERROR_FILENAME_EXCED_RANGE: return ENAMETOOLONG;
  case ERROR_CANT_RESOLVE_FILENAME: return ELOOP;
  case ERROR_NOT_SUPPORTED:
  case ERROR_INVALID_FUNCTION:
  case ERROR_INVALID_PARAMETER: return EINVAL;
  default: return EIO;
  }
}

// Longer names are accepted only in their full form.
std::wstring whole(const std::wstring& name) {
  constexpr size_t kShort = 240; // a folder's may have 247
  if (name.size() < kShort || name.compare(0, 4, L"\\\\?\\") == 0) return name;
  std::wstring full(32768, L'\0');
  const DWORD length = GetFullPathNameW(name.c_str(), static_cast<DWORD>(full.size()), &full[0], nullptr);
  if (length == 0 || length >= full.size()) return name;
  full.resize(length);
  return full.compare(0, 2, L"\\\\") == 0 ? L"\\\\?\\UNC" + full.substr(1) : L"\\\\?\\" + full;
}

} // namespace

std::wstring wide(const char* name) {
  const int length = MultiByteToWideChar(CP_UTF8, 0, name, -1, nullptr, 0);
  std::wstring text(length > 0 ? static_cast<size_t>(length) : 1, L'\0');
  MultiByteToWideChar(CP_UTF8, 0, name, -1, &text[0], length);
  text.pop_back(); // the end
  return whole(text);
}

std::string narrow(const std::wstring& text) {
  const int length = WideCharToMultiByte(CP_UTF8, 0, text.c_str(), -1, nullptr, 0, nullptr, nullptr);
  std::string out(length > 0 ? static_cast<size_t>(length) : 1, '\0');
  WideCharToMultiByte(CP_UTF8, 0, text.c_str(), -1, &out[0], length, nullptr, nullptr);
  out.pop_back();
  return out;
}

int fail(int code) {
  errno = code;
  return -1;
}
int fail() { return fail(code_of(GetLastError())); }

HANDLE handle_of(int file) { return reinterpret_cast<HANDLE>(_get_osfhandle(file)); }

std::wstring name_of(HANDLE file) {
  std::wstring name(32768, L'\0');
  const DWORD length = GetFinalPathNameByHandleW(file, &name[0], static_cast<DWORD>(name.size()), 0);
  name.resize(length < name.size() ? length : 0);
  if (name.compare(0, 8, L"\\\\?\\UNC\\") == 0) return whole(L"\\" + name.substr(7));
  return name.size() > 5 && name[5] == L':' ? whole(name.substr(4)) : name;
}

HANDLE open_shared(const std::wstring& name, DWORD access, DWORD how, DWORD flags) {
  constexpr DWORD kShared = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;
  return CreateFileW(name.c_str(), access, kShared, nullptr, how, FILE_ATTRIBUTE_NORMAL | FILE_FLAG_BACKUP_SEMANTICS | flags,
                     nullptr);
}

} // namespace windows

// Conversion of names and errors between Windows and the program.
#pragma once

#ifndef WIN32_LEAN_AND_MEAN
#define WIN32_LEAN_AND_MEAN
#endif
#ifndef NOMINMAX
#define NOMINMAX
#endif
#include <windows.h>

#include <string>

namespace windows {

// A name in the form of the system, of any length.
std::wstring wide(const char* name);
std::string narrow(const std::wstring& text);
// Sets errno from the last error of the system. Returns -1.
int fail();
int fail(int code);
HANDLE handle_of(int file);
// The full current name of an open file or folder; empty, with the last error set, if there is none.
std::wstring name_of(HANDLE file);

// A handle that is closed at the end of the scope.
class Handle {
public:
  explicit Handle(HANDLE handle) : handle_(handle) {}
  ~Handle() {
    if (is_open()) CloseHandle(handle_);
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  bool is_open() const { return handle_ != INVALID_HANDLE_VALUE; }
  operator HANDLE() const { return handle_; }
  HANDLE release() {
    const HANDLE handle = handle_;
    handle_ = INVALID_HANDLE_VALUE;
    return handle;
  }

private:
  HANDLE handle_;
};

// Others may read, write, rename and remove it meanwhile, as on POSIX systems; folders can be opened, too.
HANDLE open_shared(const std::wstring& name, DWORD access, DWORD how = OPEN_EXISTING, DWORD flags = 0);

} // namespace windows

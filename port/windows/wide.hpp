// Names and errors as Windows has them, and as the program has them.
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

// A name as the system takes it, of any length.
std::wstring wide(const char* name);
std::string narrow(const std::wstring& text);
// Sets errno to what the last error of the system means. Returns -1.
int fail();
int fail(int code);
HANDLE handle_of(int file);
// The whole name under which a file or folder that is open can be found now; empty, and the last error is set: none.
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

// Everybody may read, write, rename and remove it meanwhile, as on other systems; folders can be opened, too.
HANDLE open_shared(const std::wstring& name, DWORD access, DWORD how = OPEN_EXISTING, DWORD flags = 0);

} // namespace windows

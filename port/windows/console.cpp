// The console: arguments and text in UTF-8, what a terminal is, signals; and the beginning of the program.
#include "console.hpp"

#include "wide.hpp"

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <io.h>
#include <signal.h>
#include <string>
#include <unistd.h>
#include <vector>

int contact2d_main(int argc, char** argv); // src/program/main.cpp, which is compiled under this name here

namespace {

constexpr int kSignals = 32;
std::atomic<void (*)(int)> handlers[kSignals];
bool once[kSignals]; // the next signal of this kind ends the program
std::atomic<bool> waiting{false};
HANDLE first_thread = nullptr;

int signal_of(DWORD event) { return event == CTRL_C_EVENT ? SIGINT : event == CTRL_BREAK_EVENT ? SIGTERM : SIGHUP; }

// In a thread of its own. After the last kinds of events the system ends the program when this returns, or some seconds later.
BOOL WINAPI on_event(DWORD event) {
  const int number = signal_of(event);
  void (*const handler)(int) = once[number] ? handlers[number].exchange(SIG_DFL) : handlers[number].load();
  if (handler == SIG_DFL) return FALSE;
  if (handler != SIG_IGN) handler(number);
  if (waiting) CancelSynchronousIo(first_thread);
  if (number == SIGHUP) Sleep(INFINITE);
  return TRUE;
}

// Does the terminal support escape sequences? Enables them if necessary.
bool is_terminal(HANDLE file) {
  DWORD mode = 0;
  return GetConsoleMode(file, &mode) != 0 &&
         SetConsoleMode(file, mode | ENABLE_PROCESSED_OUTPUT | ENABLE_VIRTUAL_TERMINAL_PROCESSING) != 0;
}

void set_unless_set(const char* name, const std::string& value) {
  const char* now = std::getenv(name);
  if (now == nullptr || *now == '\0') _putenv((name + ("=" + value)).c_str());
}

std::string folder_for_temporary_files() {
  std::wstring name(MAX_PATH + 2, L'\0');
  name.resize(GetTempPathW(static_cast<DWORD>(name.size()), &name[0]));
  while (!name.empty() && name.back() == L'\\') name.pop_back();
  return windows::narrow(name);
}

void ignore(const wchar_t*, const wchar_t*, const wchar_t*, unsigned, uintptr_t) {} // reported like other errors, in errno

UINT code_page = 0;
void restore_console() { SetConsoleOutputCP(code_page); }

void prepare() {
  for (int file = 0; file < 3; ++file) _setmode(file, _O_BINARY);
  _set_invalid_parameter_handler(ignore);
  code_page = GetConsoleOutputCP();
  if (code_page != 0 && SetConsoleOutputCP(CP_UTF8) != 0) std::atexit(restore_console);
  if (isatty(2) == 1) set_unless_set("TERM", "windows");
  set_unless_set("TMPDIR", folder_for_temporary_files());
  DuplicateHandle(GetCurrentProcess(), GetCurrentThread(), GetCurrentProcess(), &first_thread, 0, FALSE, DUPLICATE_SAME_ACCESS);
  SetConsoleCtrlHandler(on_event, TRUE);
}

} // namespace

namespace windows {
Waiting::Waiting(bool for_input) { waiting = for_input; }
Waiting::~Waiting() { waiting = false; }
} // namespace windows

int sigaction(int number, const struct sigaction* action, struct sigaction* old) {
  if (number <= 0 || number >= kSignals) return windows::fail(EINVAL);
  if (old != nullptr) *old = {handlers[number].load(), 0, 0};
  if (action == nullptr) return 0;
  once[number] = (static_cast<unsigned>(action->sa_flags) & SA_RESETHAND) != 0;
  handlers[number] = action->sa_handler;
  return 0;
}

extern "C" int isatty(int file) { return is_terminal(windows::handle_of(file)) ? 1 : 0; }

extern "C" int wmain(int argc, wchar_t** argv) {
  prepare();
  std::vector<std::string> words;
  for (int i = 0; i < argc; ++i) words.push_back(windows::narrow(argv[i]));
  std::vector<char*> list;
  for (std::string& word : words) list.push_back(&word[0]);
  list.push_back(nullptr);
  return contact2d_main(argc, list.data());
}

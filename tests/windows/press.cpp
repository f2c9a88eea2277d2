// press KEY FILE PROGRAM WORDS...: runs a program in a console of its own, presses Ctrl-C (KEY: c) or Ctrl-Break (b) when there
// is a file of that name, or, with "-", when the program has read the first line of its standard input, and ends as it
// ends. KEY 2: the program a second time meanwhile, as whose end this ends. A program that has ended before is a failure: 99.
#define WIN32_LEAN_AND_MEAN
#include <windows.h>

#include <cstdio>
#include <string>

namespace {

BOOL WINAPI pass(DWORD) { return TRUE; }

struct Input {
  HANDLE from = nullptr, to = nullptr;
};

// For the program, whatever becomes of ours with the console.
HANDLE kept(DWORD which) {
  HANDLE out = nullptr;
  DuplicateHandle(GetCurrentProcess(), GetStdHandle(which), GetCurrentProcess(), &out, 0, TRUE, DUPLICATE_SAME_ACCESS);
  return out;
}

Input open_input() {
  SECURITY_ATTRIBUTES inherited = {sizeof inherited, nullptr, TRUE};
  Input input;
  CreatePipe(&input.from, &input.to, &inherited, 0);
  SetHandleInformation(input.to, HANDLE_FLAG_INHERIT, 0);
  DWORD put = 0;
  WriteFile(input.to, "A DECK\n", 7, &put, nullptr);
  return input;
}

bool is_time(const std::wstring& file, const Input& input) {
  if (file != L"-") return GetFileAttributesW(file.c_str()) != INVALID_FILE_ATTRIBUTES;
  DWORD left = 1;
  return PeekNamedPipe(input.from, nullptr, 0, nullptr, &left, nullptr) != 0 && left == 0;
}

PROCESS_INFORMATION start(std::wstring words, STARTUPINFOW& how) {
  PROCESS_INFORMATION program = {};
  CreateProcessW(nullptr, &words[0], nullptr, nullptr, TRUE, 0, nullptr, nullptr, &how, &program);
  return program;
}

int end_of(const PROCESS_INFORMATION& program) {
  DWORD exit = 96;
  if (WaitForSingleObject(program.hProcess, 120000) == WAIT_OBJECT_0) GetExitCodeProcess(program.hProcess, &exit);
  return static_cast<int>(exit);
}

// As the console does it where the system's call does not know the key (wine, Ctrl-Break): by a thread of the program's.
void press(DWORD key, HANDLE program) {
  if (key == CTRL_C_EVENT && GenerateConsoleCtrlEvent(key, 0) != 0) return;
  const auto routine = GetProcAddress(GetModuleHandleA("kernelbase"), "CtrlRoutine");
  void* const event = reinterpret_cast<void*>(static_cast<uintptr_t>(key));
  const HANDLE thread = CreateRemoteThread(
      program, nullptr, 0, reinterpret_cast<LPTHREAD_START_ROUTINE>(reinterpret_cast<void*>(routine)), event, 0, nullptr);
  if (thread == nullptr) std::fprintf(stderr, "press: no thread: %lu\n", GetLastError());
}

} // namespace

extern "C" int wmain(int argc, wchar_t** argv) {
  if (argc < 4) return 98;
  const Input input = open_input();
  STARTUPINFOW how = {};
  how.cb = sizeof how;
  how.dwFlags = STARTF_USESTDHANDLES;
  how.hStdInput = input.from, how.hStdOutput = kept(STD_OUTPUT_HANDLE), how.hStdError = kept(STD_ERROR_HANDLE);
  FreeConsole();
  if (AllocConsole() == 0) std::fprintf(stderr, "press: no console: %lu\n", GetLastError());
  SetConsoleCtrlHandler(pass, TRUE);
  std::wstring words;
  for (int i = 3; i < argc; ++i) words += L"\"" + std::wstring(argv[i]) + L"\" ";
  const PROCESS_INFORMATION program = start(words, how);
  while (!is_time(argv[2], input))
    if (WaitForSingleObject(program.hProcess, 1) != WAIT_TIMEOUT) return 99;
  if (argv[1][0] != L'2') {
    press(argv[1][0] == L'c' ? CTRL_C_EVENT : CTRL_BREAK_EVENT, program.hProcess);
    return end_of(program);
  }
  SuspendThread(program.hThread);
  const int second = end_of(start(words, how));
  TerminateProcess(program.hProcess, 0);
  return second;
}

#pragma once
// Services of a debugger or emulator for a Cortex-M program without operating system (Arm
// semihosting): files of the host, its console, the command line, the end of the program. Without a
// debugger the first call faults.
#include <stdint.h>

namespace host {

enum class Mode : int32_t { read = 1, update = 3, write = 5, create = 7 }; // fopen's rb, r+b, wb, w+b

// A handle, or -1. The name ":tt" is the console.
int32_t open(const char* name, Mode mode);
int32_t close(int32_t file); // 0, or -1
// Returns the bytes that could not be transferred: 0 on success.
uint32_t read(int32_t file, void* data, uint32_t bytes);
uint32_t write(int32_t file, const void* data, uint32_t bytes);
int32_t seek(int32_t file, uint32_t offset); // from the start of the file; 0, or a negative number
int32_t length(int32_t file);                // of a file, in bytes, or -1
// The program's command line, ended by a zero byte; false if there is none or it does not fit.
bool command_line(char* text, uint32_t size);
void say(const char* text); // to the host's messages
[[noreturn]] void end(int32_t status);

} // namespace host

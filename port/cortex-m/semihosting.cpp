// The calls: number in r0, one argument or the address of a block of them in r1, breakpoint 0xAB, answer in
// r0.
#include "semihosting.hpp"

#include <string.h>

namespace host {
namespace {

enum Call : int32_t {
  kOpen = 0x01,
  kClose = 0x02,
  kSay = 0x04,
  kWrite = 0x05,
  kRead = 0x06,
  kSeek = 0x0A,
  kLength = 0x0C,
  kCommandLine = 0x15,
  kEnd = 0x20 // with a status, "extended"
};
constexpr uint32_t kApplicationExit = 0x20026;

int32_t call(Call number, const void* argument) {
  register int32_t r0 asm("r0") = number;
  register const void* r1 asm("r1") = argument;
  asm volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
  return r0;
}

uint32_t address(const void* p) { return static_cast<uint32_t>(reinterpret_cast<uintptr_t>(p)); }
uint32_t word(int32_t number) { return static_cast<uint32_t>(number); }

} // namespace

int32_t open(const char* name, Mode mode) {
  const uint32_t block[3] = {address(name), word(static_cast<int32_t>(mode)), static_cast<uint32_t>(strlen(name))};
  return call(kOpen, block);
}

int32_t close(int32_t file) {
  const uint32_t block[1] = {word(file)};
  return call(kClose, block);
}

uint32_t read(int32_t file, void* data, uint32_t bytes) {
  const uint32_t block[3] = {word(file), address(data), bytes};
  return word(call(kRead, block));
}

uint32_t write(int32_t file, const void* data, uint32_t bytes) {
  const uint32_t block[3] = {word(file), address(data), bytes};
  return word(call(kWrite, block));
}

int32_t seek(int32_t file, uint32_t offset) {
  const uint32_t block[2] = {word(file), offset};
  return call(kSeek, block);
}

int32_t length(int32_t file) {
  const uint32_t block[1] = {word(file)};
  return call(kLength, block);
}

bool command_line(char* text, uint32_t size) {
  const uint32_t block[2] = {address(text), size};
  if (call(kCommandLine, block) == 0) return true;
  text[0] = '\0';
  return false;
}

void say(const char* text) { call(kSay, text); }

void end(int32_t status) {
  const uint32_t block[2] = {kApplicationExit, word(status)};
  call(kEnd, block);
  for (;;) {
  }
}

} // namespace host

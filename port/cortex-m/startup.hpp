#pragma once
// Startup of a board program around main, and measurement of its stack.
#include <stdint.h>

// Bytes between the end of the static data and the top of RAM, and how many of them were ever written to.
uint32_t stack_size();
uint32_t stack_used();

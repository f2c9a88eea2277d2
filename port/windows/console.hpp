// What the console interrupts.
#pragma once

namespace windows {

// While there is one for standard input, the first thread waits: the system is told to wait no longer when a signal comes.
class Waiting {
public:
  explicit Waiting(bool for_input);
  ~Waiting();
};

} // namespace windows

// Interrupts from the console.
#pragma once

namespace windows {

// While there is one for standard input, the first thread waits: a signal ends that wait.
class Waiting {
public:
  explicit Waiting(bool for_input);
  ~Waiting();
};

} // namespace windows

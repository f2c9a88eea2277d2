// Memory as a host hands it over: nobody has set it. (A vector sets all of its bytes, which takes longer than to solve a small
// model.)
#pragma once

#include <cstddef>
#include <memory>

namespace test {

class Room {
public:
  explicit Room(size_t bytes = 0) { resize(bytes); }
  void resize(size_t bytes) { // what was in it is lost
    bytes_.reset(new unsigned char[bytes]);
    size_ = bytes;
  }
  unsigned char* data() const { return bytes_.get(); }
  size_t size() const { return size_; }

private:
  std::unique_ptr<unsigned char[]> bytes_;
  size_t size_ = 0;
};

} // namespace test

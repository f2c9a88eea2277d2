// Where the tapes live: in memory, or in a locked folder of files.
#pragma once

#include <c2d_memory.h>
#include <c2d_posix.h>
#include <contact2d.h>

#include <cstdint>
#include <string>

namespace app {

// A block store that forwards every tape to a memory store of its own or to the files of one folder.
class StoreChoice {
public:
  StoreChoice() = default;
  ~StoreChoice();
  StoreChoice(const StoreChoice&) = delete;
  StoreChoice& operator=(const StoreChoice&) = delete;

  // `wanted` as --store says; "": a tape goes to memory while all of them stay below `budget` bytes, else to
  // a new folder under $TMPDIR. Tapes and folder outlive this object only if `keep`, or if remove_tapes() was
  // not called on a folder the user named. False with an error text if the folder cannot be made or is in
  // use.
  bool choose(const std::string& wanted, uint64_t budget, bool keep, std::string& error);
  // The functions of c2d_port.
  int32_t open(int32_t tape, uint64_t blocks, uint64_t block_bytes);
  int32_t read(int32_t tape, uint64_t block, void* data, uint64_t bytes) const;
  int32_t write(int32_t tape, uint64_t block, const void* data, uint64_t bytes) const;
  int32_t start_read(int32_t tape, uint64_t block, void* data, uint64_t bytes, int32_t* ticket) const;
  int32_t start_write(int32_t tape, uint64_t block, const void* data, uint64_t bytes, int32_t* ticket) const;
  int32_t wait(int32_t ticket) const;
  int32_t sync(int32_t tape) const;
  int32_t close(int32_t tape) const;
  // Removes the files of the tapes. False with an error text if that failed.
  bool remove_tapes(std::string& error);
  // What the system said to a store call that came back with `host_code`.
  std::string system_text(int32_t host_code) const;
  // The folder that --keep leaves behind; empty if all tapes were in memory.
  const std::string& folder() const { return folder_; }
  // The folder that --store names; empty if there is none.
  std::string named_folder() const { return temporary_ ? std::string() : folder_; }

private:
  struct Tape {
    bool in_memory = false;
    void* region = nullptr;
    uint64_t bytes = 0;
    c2d_memory_store store;
    c2d_port port;
  };
  const c2d_port& port_of(int32_t tape) const;
  bool place_in_memory(Tape& tape, uint64_t blocks, uint64_t block_bytes);
  int32_t open_folder(const std::string& folder);
  int32_t open_temporary_folder();

  Tape tapes_[C2D_TAPES];
  c2d_posix_store files_;
  c2d_port files_port_;
  uint64_t budget_ = 0;
  std::string folder_;
  bool has_folder_ = false, made_folder_ = false, temporary_ = false, keep_ = false, may_use_folder_ = false;
};

} // namespace app

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
  // Expected bytes of a tape opened from now on, if much less than its largest size: only they count in the budget and are
  // reserved in files, and its memory does not use large pages. UINT64_MAX: the whole size.
  void expect(int32_t tape, uint64_t bytes) { tapes_[tape].expected = bytes; }
  // Allocates memory for the largest size of a tape, before it is opened. False: no memory.
  bool reserve(int32_t tape, uint64_t blocks, uint64_t block_bytes) {
    return place_in_memory(tapes_[tape], blocks, block_bytes);
  }
  // Gives the memory of all tapes back. None of them is open.
  void drop_tapes();
  uint64_t bytes_in_memory() const; // that count
  // The functions of c2d_port.
  int32_t open(int32_t tape, uint64_t blocks, uint64_t block_bytes);
  int32_t read(int32_t tape, uint64_t block, void* data, uint64_t bytes) const;
  int32_t write(int32_t tape, uint64_t block, const void* data, uint64_t bytes) const;
  int32_t start_read(int32_t tape, uint64_t block, void* data, uint64_t bytes, int32_t* ticket) const;
  int32_t start_write(int32_t tape, uint64_t block, const void* data, uint64_t bytes, int32_t* ticket) const;
  int32_t wait(int32_t ticket) const;
  int32_t sync(int32_t tape) const;
  int32_t close(int32_t tape) const;
  bool is_busy() const { return busy_; } // choose() failed because another process has the folder
  // Removes the files of the tapes. False with an error text if that failed.
  bool remove_tapes(std::string& error);

  // The system message of a store call that returned `host_code`.
  std::string system_text(int32_t host_code) const;
  // The file of a tape, or the folder that could not be made for it; empty if it is in memory, or there is no such tape.
  std::string file_of(int32_t tape) const;
  // Why a call of the store failed: with the file, or what the system says; empty: neither is known.
  std::string why_failed(const c2d_error& error, c2d_status status) const;
  // The folder that --keep leaves behind; empty if all tapes were in memory.
  const std::string& folder() const { return folder_; }
  // The folder of the store inside the folder of --store, with the data for resuming a run; empty: none.
  std::string kept_folder() const { return temporary_ || folder_.empty() ? std::string() : own_folder(folder_); }
  static std::string own_folder(const std::string& folder) { return folder + "/" C2D_POSIX_STORE_FOLDER; }

private:
  struct Tape {
    bool in_memory = false;
    void* region = nullptr;
    uint64_t bytes = 0, expected = UINT64_MAX, counted = 0;
    c2d_memory_store store;
    c2d_port port;
  };
  const c2d_port& port_of(int32_t tape) const;
  bool place_in_memory(Tape& tape, uint64_t blocks, uint64_t block_bytes);
  int32_t open_folder(const std::string& folder);
  int32_t open_temporary_folder();
  int32_t discard();

  Tape tapes_[C2D_TAPES];
  c2d_posix_store files_;
  c2d_port files_port_;
  uint64_t budget_ = 0;
  std::string folder_, tried_;
  bool has_folder_ = false, made_folder_ = false, temporary_ = false, keep_ = false, may_use_folder_ = false, busy_ = false;
};

// Sets the functions of a port that have to do with tapes: to those of the store that is found from the port's context.
template <StoreChoice& (*store_of)(void* context)> void connect(c2d_port& port) {
  port.open = [](void* c, int32_t tape, uint64_t blocks, uint64_t bytes) { return store_of(c).open(tape, blocks, bytes); };
  port.read = [](void* c, int32_t tape, uint64_t block, void* data, uint64_t bytes) {
    return store_of(c).read(tape, block, data, bytes);
  };
  port.write = [](void* c, int32_t tape, uint64_t block, const void* data, uint64_t bytes) {
    return store_of(c).write(tape, block, data, bytes);
  };
  port.start_read = [](void* c, int32_t tape, uint64_t block, void* data, uint64_t bytes, int32_t* ticket) {
    return store_of(c).start_read(tape, block, data, bytes, ticket);
  };
  port.start_write = [](void* c, int32_t tape, uint64_t block, const void* data, uint64_t bytes, int32_t* ticket) {
    return store_of(c).start_write(tape, block, data, bytes, ticket);
  };
  port.wait = [](void* c, int32_t ticket) { return store_of(c).wait(ticket); };
  port.sync = [](void* c, int32_t tape) { return store_of(c).sync(tape); };
  port.close = [](void* c, int32_t tape) { return store_of(c).close(tape); };
}

} // namespace app

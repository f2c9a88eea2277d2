#include "program/files/store_choice.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

#include "program/files/system_file.hpp"
#include "program/workspace.hpp"

namespace app {
namespace {

const int32_t kNoTape = 1000, kNoMemory = 1001; // host codes of our own
const int32_t kDoneAtOnce = 1000;               // a ticket of our own

} // namespace

StoreChoice::~StoreChoice() {
  if (temporary_ && !keep_) discard();
  if (has_folder_) c2d_posix_store_done(&files_);
  for (Tape& tape : tapes_) std::free(tape.region);
}

bool StoreChoice::choose(const std::string& wanted, uint64_t budget, bool keep, std::string& error) {
  keep_ = keep;
  budget_ = wanted == "memory" ? UINT64_MAX : budget;
  may_use_folder_ = wanted.empty();
  if (wanted.compare(0, 5, "file:") != 0) return true;
  budget_ = 0;
  const int32_t code = open_folder(wanted.substr(5));
  if (code == 0) return true;
  busy_ = code == C2D_POSIX_STORE_LOCKED;
  error = "store " + wanted + ": " + system_text(code);
  return false;
}

int32_t StoreChoice::open_folder(const std::string& folder) {
  struct stat about;
  const bool existed = ::stat(folder.c_str(), &about) == 0;
  const int32_t code = c2d_posix_store_init(&files_, folder.c_str());
  if (code != 0) return code;
  files_port_ = C2D_INIT(c2d_port);
  c2d_posix_store_port(&files_, &files_port_);
  folder_ = folder;
  has_folder_ = true;
  made_folder_ = !existed;
  return 0;
}

// A temporary folder without tapes.
static void remove_temporary(const std::string& folder) {
  const std::string own = folder + "/" C2D_POSIX_STORE_FOLDER;
  ::unlink((own + "/lock").c_str());
  ::rmdir(own.c_str());
  ::rmdir(folder.c_str());
}

int32_t StoreChoice::open_temporary_folder() {
  const char* base = std::getenv("TMPDIR");
  std::string pattern = base != nullptr && *base != '\0' ? base : "/tmp";
  pattern += "/contact2d-XXXXXX";
  std::vector<char> name(pattern.begin(), pattern.end());
  name.push_back('\0');
  tried_ = pattern;
  if (::mkdtemp(name.data()) == nullptr) return errno;
  const int32_t code = open_folder(name.data());
  if (code != 0) { // all that is in it was made just now
    tried_ = name.data();
    remove_temporary(tried_);
  }
  made_folder_ = temporary_ = code == 0;
  return code;
}

bool StoreChoice::place_in_memory(Tape& tape, uint64_t blocks, uint64_t block_bytes) {
  if (budget_ == 0) return false;
  const uint64_t bytes = blocks * block_bytes;
  if (block_bytes != 0 && bytes / block_bytes != blocks) return false;
  if (tape.region != nullptr && tape.bytes >= bytes) return true; // it takes no more than it has
  const uint64_t counted = std::min(bytes, tape.expected);
  uint64_t others = 0;
  for (const Tape& t : tapes_)
    if (&t != &tape) others += t.counted;
  if (bytes > SIZE_MAX || others > budget_ || counted > budget_ - others) return false;
  std::free(tape.region);
  tape.counted = 0;
  tape.region = std::calloc(bytes > 0 ? static_cast<size_t>(bytes) : 1, 1);
  tape.bytes = tape.region != nullptr ? bytes : 0;
  if (tape.region == nullptr) return false;
  if (counted == bytes) ask_for_huge_pages(tape.region, tape.bytes);
  c2d_memory_store_init(&tape.store, tape.region, bytes);
  tape.port = C2D_INIT(c2d_port);
  c2d_memory_store_port(&tape.store, &tape.port);
  tape.counted = counted;
  return true;
}

void StoreChoice::drop_tapes() {
  for (Tape& tape : tapes_) {
    std::free(tape.region);
    tape = Tape();
  }
}

uint64_t StoreChoice::bytes_in_memory() const {
  uint64_t sum = 0;
  for (const Tape& tape : tapes_) sum += tape.counted;
  return sum;
}

const c2d_port& StoreChoice::port_of(int32_t tape) const { return tapes_[tape].in_memory ? tapes_[tape].port : files_port_; }

int32_t StoreChoice::open(int32_t tape, uint64_t blocks, uint64_t block_bytes) {
  if (tape < 0 || tape >= C2D_TAPES) return kNoTape;
  Tape& t = tapes_[tape];
  t.in_memory = place_in_memory(t, blocks, block_bytes);
  if (!t.in_memory && !has_folder_) {
    const int32_t code = may_use_folder_ ? open_temporary_folder() : kNoMemory;
    if (code != 0) return code;
  }
  if (!t.in_memory) c2d_posix_store_expect(&files_, tape, t.expected);
  const c2d_port& port = port_of(tape);
  return port.open(port.context, tape, blocks, block_bytes);
}

int32_t StoreChoice::read(int32_t tape, uint64_t block, void* data, uint64_t bytes) const {
  const c2d_port& port = port_of(tape);
  return port.read(port.context, tape, block, data, bytes);
}

int32_t StoreChoice::write(int32_t tape, uint64_t block, const void* data, uint64_t bytes) const {
  const c2d_port& port = port_of(tape);
  return port.write(port.context, tape, block, data, bytes);
}

// A tape in memory is read and written at once.
int32_t StoreChoice::start_read(int32_t tape, uint64_t block, void* data, uint64_t bytes, int32_t* ticket) const {
  const c2d_port& port = port_of(tape);
  if (port.start_read != nullptr) return port.start_read(port.context, tape, block, data, bytes, ticket);
  *ticket = kDoneAtOnce;
  return port.read(port.context, tape, block, data, bytes);
}

int32_t StoreChoice::start_write(int32_t tape, uint64_t block, const void* data, uint64_t bytes, int32_t* ticket) const {
  const c2d_port& port = port_of(tape);
  if (port.start_write != nullptr) return port.start_write(port.context, tape, block, data, bytes, ticket);
  *ticket = kDoneAtOnce;
  return port.write(port.context, tape, block, data, bytes);
}

int32_t StoreChoice::wait(int32_t ticket) const {
  return ticket == kDoneAtOnce ? 0 : files_port_.wait(files_port_.context, ticket);
}

int32_t StoreChoice::sync(int32_t tape) const {
  // Tapes that are removed after the run are worth nothing after a crash: no need to wait for the disk.
  if (!keep_) return 0;
  const c2d_port& port = port_of(tape);
  return port.sync(port.context, tape);
}

int32_t StoreChoice::close(int32_t tape) const {
  const c2d_port& port = port_of(tape);
  return port.close(port.context, tape);
}

int32_t StoreChoice::discard() {
  if (!has_folder_) return 0;
  has_folder_ = false;
  const int32_t code = c2d_posix_store_discard(&files_, made_folder_ ? folder_.c_str() : nullptr);
  if (code != 0 && temporary_) remove_temporary(folder_);
  return code;
}

bool StoreChoice::remove_tapes(std::string& error) {
  const int32_t code = discard();
  if (code != 0) error = folder_ + ": tapes cannot be removed: " + system_text(code);
  return code == 0;
}

std::string StoreChoice::file_of(int32_t tape) const {
  if (folder_.empty()) return tried_;
  if (tape < 0 || tape >= C2D_TAPES || tapes_[tape].in_memory) return std::string();
  return folder_ + "/" C2D_POSIX_STORE_FOLDER "/tape" + std::to_string(tape) + ".c2d";
}

std::string StoreChoice::why_failed(const c2d_error& error, c2d_status status) const {
  const std::string file = file_of(error.tape);
  if (error.host_code == 0 && file.empty()) return "";
  return (file.empty() ? "" : file + ": ") + (error.host_code != 0 ? system_text(error.host_code) : c2d_message(status));
}

std::string StoreChoice::system_text(int32_t host_code) const {
  switch (host_code) {
  case kNoMemory: return "not enough memory for the tapes; --store file:DIR keeps them in files";
  case kNoTape: return "no such tape";
  case C2D_POSIX_STORE_LOCKED: return "in use by another process";
  case C2D_POSIX_STORE_END: return "a file of the store is truncated";
  case C2D_POSIX_STORE_FOREIGN: return "the existing " C2D_POSIX_STORE_FOLDER " or a tape in it was not made by a store";
  default: return host_code > 0 ? app::system_text(host_code) : "error " + std::to_string(host_code);
  }
}

} // namespace app

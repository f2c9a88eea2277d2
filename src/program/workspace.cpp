#include "program/workspace.hpp"

#include "contact2d_memory.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

namespace app {

uint64_t free_memory() {
  char text[1024];
  const int file = ::open("/proc/meminfo", O_RDONLY | O_CLOEXEC);
  if (file >= 0) {
    const ssize_t got = ::read(file, text, sizeof text - 1);
    ::close(file);
    text[got > 0 ? got : 0] = '\0';
    const char* line = std::strstr(text, "MemAvailable:");
    unsigned long long kilobytes = 0;
    if (line != nullptr && std::sscanf(line, "MemAvailable: %llu", &kilobytes) == 1) return kilobytes << 10;
  }
#ifdef _SC_AVPHYS_PAGES
  const long pages = ::sysconf(_SC_AVPHYS_PAGES), page = ::sysconf(_SC_PAGESIZE);
  if (pages > 0 && page > 0) return static_cast<uint64_t>(pages) * static_cast<uint64_t>(page);
#endif
  return uint64_t{1} << 30;
}

void ask_for_huge_pages(void* memory, uint64_t bytes) {
#ifdef MADV_HUGEPAGE
  const uint64_t page = uint64_t{2} << 20; // of all usual machines; elsewhere it is a multiple of theirs, or refused
  const uint64_t start = reinterpret_cast<uintptr_t>(memory), skipped = (page - start % page) % page;
  if (bytes < skipped + page) return;
  ::madvise(static_cast<char*>(memory) + skipped, static_cast<size_t>((bytes - skipped) / page * page), MADV_HUGEPAGE);
#else
  static_cast<void>(memory), static_cast<void>(bytes);
#endif
}

// (The minimum grows with the nodes, as what compressed elimination lists of them.)
uint64_t compressed_bytes(uint64_t minimum) { return 2 * minimum + (uint64_t{128} << 20); }

uint64_t least_bytes(const c2d_limits& limits, int32_t elimination, uint64_t minimum) {
  if (elimination_of(limits, elimination) != C2D_ELIMINATION_COMPRESSED) return minimum;
  c2d_options options = C2D_INIT(c2d_options);
  options.elimination = C2D_ELIMINATION_COMPRESSED;
  c2d_error why = C2D_INIT(c2d_error);
  const c2d_status status = c2d_tape_need(&limits, &options, minimum, C2D_TAPE_UPPER, nullptr, nullptr, &why);
  return status == C2D_ERR_MEMORY ? std::max(why.bytes_needed, minimum) : minimum;
}

uint64_t expected_bytes(const c2d_limits& limits, int32_t elimination, uint64_t minimum, int32_t tape) {
  if (elimination_of(limits, elimination) != C2D_ELIMINATION_COMPRESSED) return UINT64_MAX;
  c2d_options options = C2D_INIT(c2d_options);
  options.elimination = C2D_ELIMINATION_COMPRESSED;
  uint64_t blocks = 0, each = 0;
  const c2d_status status =
      c2d_tape_need(&limits, &options, least_bytes(limits, elimination, minimum), tape, &blocks, &each, nullptr);
  constexpr uint64_t kWritten = 4; // that is for cells of rank 256 throughout; an eighth of it was written
  return status == C2D_OK ? blocks * each / kWritten : UINT64_MAX;
}

int32_t elimination_of(const c2d_limits& limits, int32_t chosen) {
  const auto count = [](int32_t limit) { return static_cast<uint64_t>(limit); };
  if (chosen != C2D_ELIMINATION_BY_SIZE) return chosen;
  if (limits.touching > 0) return C2D_ELIMINATION_COMPRESSED;
  for (int32_t b = 0; b < limits.bodies && limits.free_pairs == 0; ++b) {
    const c2d_body_limits& body = limits.body[b];
    const uint64_t nodes =
        C2D_NODES_(count(limits.function_nodes), count(body.points), count(body.elements), count(body.regions));
    if (C2D_COMPRESSES(nodes, count(limits.pairs))) return C2D_ELIMINATION_COMPRESSED;
  }
  return C2D_ELIMINATION_DENSE;
}

int32_t touching_of(const c2d_limits& limits, int32_t chosen, int32_t elimination, int32_t stepping) {
  const bool whole =
      limits.free_pairs > 0 || limits.platens > 0 || elimination == C2D_ELIMINATION_DENSE || stepping == C2D_STEPPING_DECK;
  if (chosen >= 0) return std::min(chosen, limits.pairs);
  return whole || limits.pairs <= kManyPairs ? 0 : limits.pairs / 5;
}

c2d_status take_workspace(const c2d_limits& limits, uint64_t wanted, int32_t elimination, Workspace& out, std::string& error) {
  c2d_error why = C2D_INIT(c2d_error);
  const c2d_status status = c2d_memory_need(&limits, &out.minimum, &out.in_core, &why);
  if (status != C2D_OK) {
    error = why.text;
    return status;
  }
  const bool compressed = elimination_of(limits, elimination) == C2D_ELIMINATION_COMPRESSED;
  const uint64_t useful = compressed ? compressed_bytes(out.minimum) : std::max(out.in_core, out.minimum);
  if (wanted != 0)
    out.bytes = compressed ? wanted : std::min(wanted, useful);
  else if (compressed)
    out.bytes = useful;
  else
    out.bytes = std::max(std::min(useful, free_memory() / 2), out.minimum);
  if (out.bytes < out.minimum)
    return error = "workspace of " + std::to_string(wanted) +
                   " bytes is too small: " + std::to_string(least_bytes(limits, elimination, out.minimum)) + " bytes would do",
           C2D_ERR_MEMORY;
  if (out.bytes <= SIZE_MAX) out.memory.reset(std::malloc(static_cast<size_t>(out.bytes)));
  if (out.memory == nullptr)
    return error = "cannot allocate " + std::to_string(out.bytes) + " bytes of memory: a workspace of " +
                   std::to_string(least_bytes(limits, elimination, out.minimum)) + " bytes would do (--memory)",
           C2D_ERR_MEMORY;
  ask_for_huge_pages(out.memory.get(), out.bytes);
  return C2D_OK;
}

} // namespace app

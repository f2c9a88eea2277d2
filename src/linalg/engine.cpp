// Sharing of work items between threads. Items own the numbers that they write and are summed in a fixed order, so the number
// of threads changes no bit; only who computes an item depends on timing.
#include "linalg/engine.hpp"

namespace c2d {
namespace {

// The narrowest right factor that is worth packing for.
constexpr int64_t kLeastWidth = 32;

// Any free task takes the next item. Without a counter that tasks can share there is one task.
#if defined(__GCC_ATOMIC_INT_LOCK_FREE) && __GCC_ATOMIC_INT_LOCK_FREE == 2
constexpr bool kShared = !kSmallCode;
int32_t take(int32_t* next) { return __atomic_fetch_add(next, 1, __ATOMIC_RELAXED); }
int32_t one_less(int32_t* left) { return __atomic_sub_fetch(left, 1, __ATOMIC_ACQ_REL); }
#else
constexpr bool kShared = false;
int32_t take(int32_t* next) { return (*next)++; }
int32_t one_less(int32_t* left) { return --*left; }
#endif

struct Items {
  const Engine& engine;
  int32_t parts, count;
  ItemWork work;
  void* argument;
  int32_t taken, front, back;
};

// Odd parts take items from the back, even ones from the front: columns that are used again and again are then mostly
// processed by the worker whose cache contains them.
int32_t next_item(Items& items, int32_t part) {
  if (take(&items.taken) >= items.count) return items.count;
  return part % 2 == 0 ? take(&items.front) : items.count - 1 - take(&items.back);
}

void take_items(void* argument, int32_t part) {
  Items& items = *static_cast<Items*>(argument);
  // Each part gets its own share of the scratch memory, so no part waits for another.
  const int64_t numbers = items.engine.numbers / items.parts / 8 * 8;
  const Engine own = {items.engine.kernel, items.engine.scratch + part * numbers, numbers, nullptr, kAlone};
  for (int32_t i = next_item(items, part); i < items.count; i = next_item(items, part)) items.work(items.argument, own, i);
}

} // namespace

int32_t parts_of(const Engine& engine) {
  if (!kShared || !engine.kernel || engine.workers.count <= 1) return 1;
  // A part with less scratch than full depth would sum in another order, hence give other bits: rather fewer parts.
  const int64_t each = kDepth * (engine.kernel->rows + kLeastWidth) + 8;
  const int64_t most = engine.numbers / each;
  return most < 1 ? 1 : (most < engine.workers.count ? static_cast<int32_t>(most) : engine.workers.count);
}

void run_items(const Engine& engine, int32_t items, ItemWork work, void* argument) {
  const int32_t most = parts_of(engine), parts = most < items ? most : items;
  if (parts <= 1) {
    for (int32_t i = 0; i < items; ++i) work(argument, engine, i);
    return;
  }
  if (engine.used) *engine.used = engine.numbers;
  Items all = {engine, parts, items, work, argument, 0, 0, 0};
  run_tasks(engine.workers, parts, take_items, &all);
}

bool is_last(int32_t* left) { return one_less(left) == 0; }

} // namespace c2d

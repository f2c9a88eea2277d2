// C++ exceptions in WebAssembly: the functions called by compiled code under -fwasm-exceptions. The C++ library of Debian for
// wasm32 lacks them. One thread; caught exceptions form a stack. An exception is passed as the address of its Header,
// which precedes the object.
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <new>
#include <typeinfo>

namespace {

struct alignas(16) Header {
  const std::type_info* type;
  void* (*destroy)(void*); // destructors return their argument on this target
  Header* below;           // on the stack of caught exceptions
  void* adjusted;          // the object as the handler sees it
  int32_t handlers;        // number of active handlers
};
Header* caught = nullptr;

void* object_of(Header* header) { return header + 1; }

// A type of libc++abi: does a handler for it catch an exception of another type, and at which address?
class Catcher : public std::type_info {
public:
  virtual void noop1() const = 0;
  virtual void noop2() const = 0;
  virtual bool can_catch(const Catcher* thrown, void*& adjusted) const = 0;
};

uintptr_t read_unsigned(const uint8_t*& at) {
  uintptr_t value = 0;
  for (int shift = 0;; shift += 7) {
    const uint8_t byte = *at++;
    value |= static_cast<uintptr_t>(byte & 0x7f) << shift;
    if ((byte & 0x80) == 0) return value;
  }
}
intptr_t read_signed(const uint8_t*& at) {
  uintptr_t value = 0;
  int shift = 0;
  uint8_t byte = 0;
  do {
    byte = *at++;
    value |= static_cast<uintptr_t>(byte & 0x7f) << shift;
    shift += 7;
  } while ((byte & 0x80) != 0);
  if ((byte & 0x40) != 0 && shift < 32) value |= ~uintptr_t{0} << shift;
  return static_cast<intptr_t>(value);
}

// The table of a function: its types, of which number k stands k places before their end, and for every landing pad the first
// of a chain of actions; an action is the number of a type (0: only clean up) and the way to the next.
struct Table {
  const uint8_t *sites, *actions;
  const uintptr_t* types_end = nullptr;

  explicit Table(const uint8_t* at) {
    constexpr uint8_t kOmitted = 0xff;
    if (*at++ != kOmitted) read_unsigned(at);
    if (*at++ != kOmitted) {
      const uintptr_t offset = read_unsigned(at);
      types_end = reinterpret_cast<const uintptr_t*>(at + offset);
    }
    ++at; // encoding of call sites: always the same
    const uintptr_t bytes = read_unsigned(at);
    sites = at, actions = at + bytes;
  }
  const uint8_t* first_action(uintptr_t pad) const {
    const uint8_t* at = sites;
    for (uintptr_t i = 0; i < pad; ++i) read_unsigned(at), read_unsigned(at);
    read_unsigned(at);
    const uintptr_t action = read_unsigned(at);
    return action == 0 ? nullptr : actions + action - 1;
  }
};

// The number of the first type that catches it; 0: none.
intptr_t find_handler(Header* header, uintptr_t pad, const uint8_t* lsda) {
  const Table table(lsda);
  const uint8_t* at = table.first_action(pad);
  while (at != nullptr) {
    const intptr_t number = read_signed(at);
    const uint8_t* here = at;
    const intptr_t next = read_signed(at);
    if (number > 0) {
      const auto* type = reinterpret_cast<const Catcher*>(table.types_end[-number]);
      header->adjusted = object_of(header);
      if (type == nullptr || type->can_catch(static_cast<const Catcher*>(header->type), header->adjusted)) return number;
    }
    at = next == 0 ? nullptr : here + next;
  }
  return 0;
}

} // namespace

extern "C" {

// Request and answer of a landing pad.
struct LandingPad {
  uintptr_t pad;
  const uint8_t* lsda;
  uintptr_t selector;
};
thread_local LandingPad __wasm_lpad_context;

int __gxx_wasm_personality_v0() { return 0; } // named by every function, never called

int _Unwind_CallPersonality(void* exception) {
  __wasm_lpad_context.selector =
      static_cast<uintptr_t>(find_handler(static_cast<Header*>(exception), __wasm_lpad_context.pad, __wasm_lpad_context.lsda));
  return 0;
}

void* __cxa_allocate_exception(size_t bytes) {
  void* memory = std::malloc(sizeof(Header) + bytes);
  if (memory == nullptr) std::abort();
  return static_cast<Header*>(memory) + 1;
}
void __cxa_free_exception(void* object) { std::free(static_cast<Header*>(object) - 1); }

void __cxa_throw(void* object, std::type_info* type, void* (*destroy)(void*)) {
  Header* header = static_cast<Header*>(object) - 1;
  *header = Header{type, destroy, nullptr, object, 0};
  __builtin_wasm_throw(0, header);
}

void* __cxa_begin_catch(void* exception) {
  auto* header = static_cast<Header*>(exception);
  if (header->handlers++ == 0) header->below = caught, caught = header;
  return header->adjusted;
}

void __cxa_end_catch() {
  Header* header = caught;
  if (--header->handlers > 0) return;
  caught = header->below;
  if (header->destroy != nullptr) header->destroy(object_of(header));
  std::free(header);
}

void __cxa_rethrow() {
  Header* header = caught;
  caught = header->below;
  header->handlers = 0;
  __builtin_wasm_throw(0, header);
}
}

// That of the library would end the program when memory is exhausted.
void* operator new(size_t bytes) {
  void* memory = std::malloc(bytes == 0 ? 1 : bytes);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}
void* operator new[](size_t bytes) { return operator new(bytes); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, size_t) noexcept { std::free(memory); }

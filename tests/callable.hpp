#pragma once
// Callable<R(A...)>: what std::function is, without its traits, which take longer to compile than most tests do.
namespace test {

template <class Signature> class Callable;

template <class R, class... A> class Callable<R(A...)> {
public:
  Callable() = default;
  Callable(decltype(nullptr)) {}
  Callable(const Callable& other)
      : object_(other.object_ == nullptr ? nullptr : other.copy_(other.object_)), call_(other.call_), copy_(other.copy_),
        drop_(other.drop_) {}
  template <class F, class = decltype((*static_cast<F*>(nullptr))(static_cast<A (*)()>(nullptr)()...))>
  Callable(F f)
      : object_(new F(static_cast<F&&>(f))),
        call_([](void* o, A... a) -> R { return (*static_cast<F*>(o))(static_cast<A&&>(a)...); }),
        copy_([](const void* o) -> void* { return new F(*static_cast<const F*>(o)); }),
        drop_([](void* o) { delete static_cast<F*>(o); }) {}
  Callable& operator=(Callable other) {
    swap(object_, other.object_), swap(call_, other.call_), swap(copy_, other.copy_), swap(drop_, other.drop_);
    return *this;
  }
  ~Callable() {
    if (object_ != nullptr) drop_(object_);
  }
  R operator()(A... a) const { return call_(object_, static_cast<A&&>(a)...); }
  explicit operator bool() const { return object_ != nullptr; }
  friend bool operator==(const Callable& f, decltype(nullptr)) { return f.object_ == nullptr; }
  friend bool operator!=(const Callable& f, decltype(nullptr)) { return f.object_ != nullptr; }

private:
  template <class T> static void swap(T& a, T& b) {
    T c = a;
    a = b, b = c;
  }
  void* object_ = nullptr;
  R (*call_)(void*, A...) = nullptr;
  void* (*copy_)(const void*) = nullptr;
  void (*drop_)(void*) = nullptr;
};

} // namespace test

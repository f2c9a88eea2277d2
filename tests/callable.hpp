#pragma once
// Callable<R(A...)>: what std::function is, without its traits, which take longer to compile than most tests do.
namespace test {

template <class Signature> class Callable;

template <class R, class... A> class Callable<R(A...)> {
public:
  Callable() = default;
  Callable(decltype(nullptr)) {}
  Callable(const Callable& other)
      : object_(other.object_ == nullptr ? nullptr : other.keep_(other.object_, true)), call_(other.call_), keep_(other.keep_) {
  }
  template <class F, class = decltype((*static_cast<F*>(nullptr))(static_cast<A (*)()>(nullptr)()...))>
  Callable(F f) : object_(new F(static_cast<F&&>(f))), call_(&call<F>), keep_(&keep<F>) {}
  Callable& operator=(Callable other) {
    swap(object_, other.object_), swap(call_, other.call_), swap(keep_, other.keep_);
    return *this;
  }
  ~Callable() {
    if (object_ != nullptr) keep_(object_, false);
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
  // (Functions, not lambdas: a lambda is three of them to a compiler that does not optimise.)
  template <class F> static R call(void* object, A... a) { return (*static_cast<F*>(object))(static_cast<A&&>(a)...); }
  // Copies the object, or deletes it.
  template <class F> static void* keep(void* object, bool copies) {
    if (copies) return new F(*static_cast<const F*>(object));
    delete static_cast<F*>(object);
    return nullptr;
  }
  void* object_ = nullptr;
  R (*call_)(void*, A...) = nullptr;
  void* (*keep_)(void*, bool) = nullptr;
};

} // namespace test

// Seen before everything else by sources that hold mutants: which of them is on.
#ifndef C2D_MUTANTS_SWITCH
#define C2D_MUTANTS_SWITCH

extern "C" {
extern int c2d_mutant;
extern unsigned char* c2d_mutant_met; // a byte for each: has its place been met?
}

static inline __attribute__((always_inline)) bool c2d_is(int number) {
  c2d_mutant_met[number] = 1;
  return __builtin_expect(c2d_mutant == number, 0);
}

template <class T> static inline __attribute__((always_inline)) T c2d_zero(const T&) { return T{}; }

// A bound of integers is moved by one. That two computed numbers are equal is a case that no test should hang on: there the
// comparison is turned round.
template <class T> struct c2d_rounded { static constexpr bool value = false; };
template <> struct c2d_rounded<double> { static constexpr bool value = true; };
template <> struct c2d_rounded<float> { static constexpr bool value = true; };
#define C2D_BOUND(l, op, other, r) (c2d_rounded<decltype((l) - (r))>::value ? !((l)op(r)) : ((l)other(r)))

#endif

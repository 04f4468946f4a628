// Hosts may set the processor to take denormals for 0, going in and coming out.
#pragma once

#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

namespace hatbox::test {

/// Denormals are 0 in this thread for as long as it lives. On x86 alone; elsewhere it changes nothing.
class FlushedDenormals {
 public:
  explicit FlushedDenormals(bool flush = true) {
    if (flush) set(mode_ | 0x8040u);  // flush to zero, denormals are zeros
  }
  ~FlushedDenormals() { set(mode_); }
  FlushedDenormals(const FlushedDenormals&) = delete;
  FlushedDenormals& operator=(const FlushedDenormals&) = delete;

 private:
#if defined(__x86_64__)
  static unsigned get() { return _mm_getcsr(); }
  static void set(unsigned mode) { _mm_setcsr(mode); }
#else
  static unsigned get() { return 0; }
  static void set(unsigned) {}
#endif

  const unsigned mode_ = get();
};

}  // namespace hatbox::test

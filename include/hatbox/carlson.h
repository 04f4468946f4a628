/// \file
/// Elliptic integrals for whole arrays: Carlson's symmetric ones and, made of them, Legendre's.
///
/// All calls work on n elements, are thread-safe, allocate nothing (those of `parallel`: what TBB does), and throw
/// std::invalid_argument, before anything is written, if spans disagree in length or HATBOX_ISA is no instruction set
/// (isa.h); the message names which. `out` may not overlap an argument. An element's bits depend on its own arguments
/// alone: not on its place, its neighbours, the number of threads, nor (but for sse4_2, see isa.h) on the instruction
/// set.
///
/// Here and nowhere else NaN comes out: of an element whose arguments are outside the domain, infinite or NaN.
///
/// Errors are in ulp of the result, wherever that is a normal float; tests/carlson_accuracy_test.cpp holds them against
/// values of mpmath. Carlson's: for arguments from 1e-30 to 1e30, in any combination, and 0. The two smallest
/// floats count as 0.
///
/// Legendre's integrals of the amplitude phi (radians, |phi| <= 2^20) and the parameter m = k². The floats nearest to
/// ±π/2 stand for ±π/2 themselves: they give the complete integrals. m sin²φ <= 1, and m <= 1 where |phi| > π/2. The
/// errors hold for -1e6 <= m <= 1 and |phi| <= 1000, and for m > 1 as long as m sin²φ < 0.9: near 1 the integrals are
/// ill-conditioned.
#pragma once

#include <hatbox/export.h>

#include <cstddef>
#include <span>

namespace hatbox {

/// R_F(x, y, z), x, y, z >= 0, at most one of them 0. Max error: 8 ulp.
///
/// Source of all four: Carlson 1995, by duplication (src/carlson.h).
HATBOX_API void carlson_rf(std::span<const float> x, std::span<const float> y, std::span<const float> z,
                           std::span<float> out);

/// R_C(x, y) = R_F(x, y, y), x >= 0, y > 0: no Cauchy principal values. Max error: 8 ulp.
HATBOX_API void carlson_rc(std::span<const float> x, std::span<const float> y, std::span<float> out);

/// R_D(x, y, z) = R_J(x, y, z, z), x, y >= 0, at most one of them 0, z > 0. Max error: 8 ulp.
HATBOX_API void carlson_rd(std::span<const float> x, std::span<const float> y, std::span<const float> z,
                           std::span<float> out);

/// R_J(x, y, z, p), x, y, z >= 0, at most one of them 0, p > 0: no Cauchy principal values. Max error: 16 ulp.
HATBOX_API void carlson_rj(std::span<const float> x, std::span<const float> y, std::span<const float> z,
                           std::span<const float> p, std::span<float> out);

/// F(φ|m) = ∫ (1 − m sin²θ)^(-1/2) dθ from 0 to φ. ±infinity for m = 1 at ±π/2, NaN beyond. Max error: 8 ulp.
///
/// Source of all three: Carlson's integrals, DLMF 19.25.5, 9-11 and 14 (src/ellint.h).
///
/// Cost of all seven: a tenth to a thirtieth of Boost.Math in scalar double. The README has the numbers.
HATBOX_API void ellint_f(std::span<const float> phi, std::span<const float> m, std::span<float> out);

/// E(φ|m) = ∫ (1 − m sin²θ)^(1/2) dθ from 0 to φ. Max error: 12 ulp.
HATBOX_API void ellint_e(std::span<const float> phi, std::span<const float> m, std::span<float> out);

/// Π(n; φ|m) = ∫ (1 − n sin²θ)^-1 (1 − m sin²θ)^(-1/2) dθ from 0 to φ, n sin²φ < 1, and n < 1 where |phi| > π/2: no
/// Cauchy principal values. ±infinity for m = 1 or n = 1 at ±π/2, NaN beyond. Max error: 16 ulp, for n >= -1e6.
HATBOX_API void ellint_pi(std::span<const float> n, std::span<const float> phi, std::span<const float> m,
                          std::span<float> out);

namespace parallel {

/// @{
/// The same calls, the arrays split into blocks by TBB, in the caller's task arena and isolated from its other tasks.
/// `grain` is the least number of elements a block (0: chosen by the library); a job of one block runs in the caller's
/// thread. All threads flush denormals if that does.
HATBOX_API void carlson_rf(std::span<const float> x, std::span<const float> y, std::span<const float> z,
                           std::span<float> out, std::size_t grain = 0);
HATBOX_API void carlson_rc(std::span<const float> x, std::span<const float> y, std::span<float> out,
                           std::size_t grain = 0);
HATBOX_API void carlson_rd(std::span<const float> x, std::span<const float> y, std::span<const float> z,
                           std::span<float> out, std::size_t grain = 0);
HATBOX_API void carlson_rj(std::span<const float> x, std::span<const float> y, std::span<const float> z,
                           std::span<const float> p, std::span<float> out, std::size_t grain = 0);
HATBOX_API void ellint_f(std::span<const float> phi, std::span<const float> m, std::span<float> out,
                         std::size_t grain = 0);
HATBOX_API void ellint_e(std::span<const float> phi, std::span<const float> m, std::span<float> out,
                         std::size_t grain = 0);
HATBOX_API void ellint_pi(std::span<const float> n, std::span<const float> phi, std::span<const float> m,
                          std::span<float> out, std::size_t grain = 0);
/// @}

}  // namespace parallel

}  // namespace hatbox

// The loops of the elliptic integrals: packets of arguments in, packets of integrals out.
#pragma once

#include "ellint.h"
#include "kernel_table.h"
#include "packets.h"

namespace hatbox::HATBOX_ISA {
namespace {

template <class Function>
HATBOX_INLINE inline void for_each_argument(const CarlsonJob& job, std::size_t begin, std::size_t end,
                                            const Function& function) {
  for_each_packet(begin, end, [&](const auto& memory, std::size_t i) HATBOX_INLINE {
    const auto argument = [&](int which) HATBOX_INLINE { return memory.load(job.in[which] + i); };
    memory.store(job.out + i, function(argument));
  });
}

void rf_kernel(const CarlsonJob& job, std::size_t begin, std::size_t end) {
  for_each_argument(job, begin, end, [](const auto& of) HATBOX_INLINE { return carlson_rf(of(0), of(1), of(2)); });
}
void rc_kernel(const CarlsonJob& job, std::size_t begin, std::size_t end) {
  for_each_argument(job, begin, end, [](const auto& of) HATBOX_INLINE { return carlson_rc(of(0), of(1)); });
}
void rd_kernel(const CarlsonJob& job, std::size_t begin, std::size_t end) {
  for_each_argument(job, begin, end,
                    [](const auto& of) HATBOX_INLINE { return carlson_rf_rd<Wanted::third>(of(0), of(1), of(2)).rj; });
}
void rj_kernel(const CarlsonJob& job, std::size_t begin, std::size_t end) {
  for_each_argument(job, begin, end,
                    [](const auto& of) HATBOX_INLINE { return carlson_rj(of(0), of(1), of(2), of(3)); });
}
void ellint_f_kernel(const CarlsonJob& job, std::size_t begin, std::size_t end) {
  for_each_argument(job, begin, end, [](const auto& of) HATBOX_INLINE { return ellint_f(of(0), of(1)); });
}
void ellint_e_kernel(const CarlsonJob& job, std::size_t begin, std::size_t end) {
  for_each_argument(job, begin, end, [](const auto& of) HATBOX_INLINE { return ellint_e(of(0), of(1)); });
}
void ellint_pi_kernel(const CarlsonJob& job, std::size_t begin, std::size_t end) {
  for_each_argument(job, begin, end, [](const auto& of) HATBOX_INLINE { return ellint_pi(of(0), of(1), of(2)); });
}

}  // namespace
}  // namespace hatbox::HATBOX_ISA

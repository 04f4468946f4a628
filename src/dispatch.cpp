#include "dispatch.h"

#include <hatbox/isa.h>

#include "isa_list.h"

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <string_view>

#define HATBOX_ROW(isa, supported) extern "C" const hatbox::KernelTable hatbox_kernels_##isa;
HATBOX_ISA_LIST(HATBOX_ROW)
#undef HATBOX_ROW

namespace hatbox {
namespace {

/// Those instruction sets of the build that this CPU has, and their tables, slowest first.
class Available {
 public:
  Available() {
#if defined(__x86_64__)
    __builtin_cpu_init();  // we may run before the constructors that would have done it
#endif
#define HATBOX_ROW(isa, supported) \
  if (supported) add(Isa::isa, hatbox_kernels_##isa);
    HATBOX_ISA_LIST(HATBOX_ROW)
#undef HATBOX_ROW
  }

  std::span<const Isa> isas() const { return std::span(isas_).first(count_); }
  const KernelTable& best() const { return *tables_[count_ - 1]; }

  const KernelTable* find(std::string_view wanted) const {
    for (std::size_t i = 0; i < count_; ++i)
      if (wanted == name(isas_[i])) return tables_[i];
    return nullptr;
  }

  Isa isa_of(const KernelTable& table) const {
    std::size_t i = 0;
    while (tables_[i] != &table) ++i;
    return isas_[i];
  }

  const KernelTable& find_or_throw(const char* who_asks, std::string_view wanted) const {
    if (const KernelTable* table = find(wanted)) return *table;
    std::string message =
        std::string(who_asks) + ": no instruction set \"" + std::string(wanted) + "\" here; there are";
    const char* separator = " ";
    for (const Isa isa : isas()) {
      message += separator;
      message += name(isa);
      separator = ", ";
    }
    throw std::invalid_argument(message);
  }

 private:
#define HATBOX_ROW(isa, supported) Isa::isa,
  static constexpr std::array built{HATBOX_ISA_LIST(HATBOX_ROW)};
#undef HATBOX_ROW

  void add(Isa isa, const KernelTable& table) {
    isas_[count_] = isa;
    tables_[count_] = &table;
    ++count_;
  }

  std::array<Isa, built.size()> isas_{};
  std::array<const KernelTable*, built.size()> tables_{};
  std::size_t count_ = 0;
};

const Available& available() {
  static const Available instance;
  return instance;
}

// The tables are constants, so nothing but the pointer itself is handed from thread to thread: relaxed order will do.
std::atomic<const KernelTable*> active_table{nullptr};

/// The table for the first call. Nothing is remembered when HATBOX_ISA is wrong: every call throws until it is mended
/// or `force_isa` overrides it.
const KernelTable& resolve() {
  const char* wanted = std::getenv("HATBOX_ISA");
  const bool named = wanted != nullptr && *wanted != '\0';
  const KernelTable& table = named ? available().find_or_throw("HATBOX_ISA", wanted) : available().best();
  const KernelTable* current = nullptr;
  // Lost only to another thread that resolved or forced in the meantime: then that one's choice stands.
  return active_table.compare_exchange_strong(current, &table, std::memory_order_relaxed) ? table : *current;
}

}  // namespace

const KernelTable& active_kernels() {
  const KernelTable* table = active_table.load(std::memory_order_relaxed);
  return table != nullptr ? *table : resolve();
}

Isa active_isa() { return available().isa_of(active_kernels()); }

std::span<const Isa> available_isas() { return available().isas(); }

void force_isa(Isa isa) {
  active_table.store(&available().find_or_throw("force_isa", name(isa)), std::memory_order_relaxed);
}

const char* name(Isa isa) noexcept {
  switch (isa) {
    case Isa::scalar: return "scalar";
    case Isa::sse4_2: return "sse4_2";
    case Isa::avx2: return "avx2";
    case Isa::avx512: return "avx512";
    case Isa::neon: return "neon";
  }
  return "unknown";
}

}  // namespace hatbox

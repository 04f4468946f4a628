#include "progress.h"

#include <unistd.h>

#include <cstdio>
#include <utility>

namespace wavefront {

Progress::Progress(std::string label, std::uint64_t total)
    : label_(std::move(label)), total_(total), visible_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (visible_) std::fputs("\r\033[K", stderr);
}

void Progress::advance(std::uint64_t steps) {
  done_ += steps;
  if (!visible_ || Clock::now() < next_draw_) return;
  next_draw_ = Clock::now() + std::chrono::milliseconds(100);
  constexpr int width = 40;
  const auto filled = static_cast<int>(done_ * width / total_);
  const auto percent = static_cast<int>(done_ * 100 / total_);
  std::fprintf(stderr, "\r%-16s [%s%*s] %3d %%", label_.c_str(),
               std::string(static_cast<std::size_t>(filled), '#').c_str(), width - filled, "", percent);
}

}  // namespace wavefront

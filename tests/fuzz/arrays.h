// The arrays of one call, each exactly as long as it says, so that the address sanitizer sees what lies beyond.
#pragma once

#include "fuzz/input.h"
#include "support/workloads.h"

#include <algorithm>
#include <cstddef>
#include <deque>
#include <utility>
#include <vector>

namespace hatbox::fuzz {

class Arrays {
 public:
  const std::vector<float>& in(std::vector<float> values) { return keep(std::move(values)); }

  std::vector<float>& out(std::size_t count) {
    std::vector<float>& array = keep(std::vector<float>(count, test::SampleArrays::untouched));
    outputs_.push_back(&array);
    return array;
  }

  /// Gives one of the arrays another length, now and then. Spans of them are to be made afterwards.
  void bend(Input& input) {
    if (kept_.empty() || !input.one_in(6)) return;
    std::vector<float>& array = kept_[input.below(kept_.size())];
    const std::size_t length = input.one_in(2) ? 0 : input.below(2 * array.size() + 3);
    if (length == array.size()) return;
    array = std::vector<float>(length, test::SampleArrays::untouched);
    bent_ = &array;
  }

  /// Whether a call must refuse them. `optional`: an empty output is one that is not wanted.
  bool refused(bool optional = false) const {
    const bool output = std::ranges::find(outputs_, bent_) != outputs_.end();
    return bent_ != nullptr && !(optional && output && bent_->empty());
  }

  const std::vector<const std::vector<float>*>& outputs() const { return outputs_; }

 private:
  std::vector<float>& keep(std::vector<float> values) { return kept_.emplace_back(std::move(values)); }

  std::deque<std::vector<float>> kept_;
  std::vector<const std::vector<float>*> outputs_;
  const std::vector<float>* bent_ = nullptr;
};

}  // namespace hatbox::fuzz

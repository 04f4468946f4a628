// The integral of a positive function from 0 to π/2 and its inverse, by Gauss–Legendre panels that double in width.
#pragma once

#include <functional>
#include <vector>

namespace hatbox::reference {

class PanelIntegral {
 public:
  /// `width` of the first panel: no further than the nearest singularity is from 0.
  PanelIntegral(std::function<double(double)> density, double width);

  double whole() const { return sums_.back(); }

  /// The share of the whole from 0 to x.
  double share(double x) const;

  /// Its inverse, to 1e-14 or what rounding leaves; adds the Newton steps taken to `iterations`.
  double inverse(double share, int& iterations) const;

 private:
  std::function<double(double)> density_;
  std::vector<double> ends_;  // of the panels, 0 … π/2
  std::vector<double> sums_;  // of the integral, from 0 to each end
};

}  // namespace hatbox::reference

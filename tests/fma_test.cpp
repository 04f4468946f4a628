// `fma` is fused on every instruction set: the residual of a product is exact.
#include "dispatch.h"
#include "support/isa_fixture.h"
#include "support/random.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace hatbox::test {
namespace {

class Fma : public IsaTest {};

TEST_P(Fma, ProductResidualIsExact) {
  const std::size_t n = 1 << 16;
  Random random(7);
  std::vector<float> x(n), y(n), residual(n);
  for (std::size_t i = 0; i < n; ++i) {
    x[i] = static_cast<float>(random.uniform(-3, 3));
    y[i] = static_cast<float>(random.uniform(0.01, 100));
  }
  const KernelTable& kernels = active_kernels();
  ASSERT_STREQ(kernels.isa, name(GetParam()));
  ASSERT_EQ(n % kernels.lanes, 0u);
  kernels.product_residual(x.data(), y.data(), residual.data(), n);
  std::size_t inexact_products = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const float rounded = x[i] * y[i];
    const double exact = double{x[i]} * double{y[i]} - double{rounded};
    ASSERT_EQ(double{residual[i]}, exact) << x[i] << " * " << y[i];
    inexact_products += exact != 0;
  }
  EXPECT_GT(inexact_products, n / 2);
}

HATBOX_FOR_EVERY_ISA(Fma);

}  // namespace
}  // namespace hatbox::test

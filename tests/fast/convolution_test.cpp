// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/convolution.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <limits>
#include <new>
#include <random>

#include "tests/check.hpp"
#include "tests/quadrature.hpp"
#include "tests/sanitizer.hpp"

using namespace ehd;
using verification::Tolerance;

/// FFTW's own allocation, which its planner calls.
extern "C" void* fftw_malloc_plain(std::size_t bytes);

namespace {

const Tolerance quadrature = Tolerance::discretisation(1e-13, 20);

}  // namespace

BOOST_AUTO_TEST_SUITE(convolution)

// The whole hat is judged by the claim kernel/fast-weights.
BOOST_AUTO_TEST_CASE(half_hat_moments_are_the_integrals_of_the_log_kernel) {
  int rows = 0;
  for (const int k : {0, 1, 2, 3, 7, 23, 24, 25, 26, 100, 4096}) {
    const double half = testing::singular_integral([k](double t) { return (1 + t) * std::log(k - t); }, -1, 0);
    EHD_CHECK(error(fast::half_hat_moment(k), half), quadrature);
    ++rows;
  }
  BOOST_REQUIRE_EQUAL(rows, 11);
}

BOOST_AUTO_TEST_CASE(series_and_closed_form_meet_where_they_change_over) {
  // Third differences of g are smooth, about 2/k^3: a jump at 24/25 would stand out of the neighbours' trend.
  for (int k = 20; k < 30; ++k) {
    const double third =
        fast::hat_moment(k + 2) - 3 * fast::hat_moment(k + 1) + 3 * fast::hat_moment(k) - fast::hat_moment(k - 1);
    const double expected = 2 / std::pow(k + 0.5, 3);
    EHD_CHECK(error(third, expected), Tolerance::asymptotic(3.0 / (k * k), "next term of the difference, ~ 2.5/k^2"));
  }
}

BOOST_AUTO_TEST_CASE(fft_product_equals_the_dense_sum) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  int rows = 0;
  for (const int n : {16, 17, 100, 128, 333, 1024, 4096}) {  // the last: in place
    fast::Convolution kernel(n);
    Array x(n + 1), y;
    for (int i = 0; i < n; ++i) x[i] = uniform(random);
    x[n] = 0;
    kernel.apply(x, y);
    double worst = 0, size = 0;
    for (int i = 0; i <= n; i += std::max(1, n / 300)) {
      double sum = 0, absolute = 0;
      for (int j = 0; j < n; ++j) {
        sum += fast::hat_moment(std::abs(i - j)) * x[j];
        absolute += std::abs(fast::hat_moment(std::abs(i - j)) * x[j]);
      }
      worst = std::max(worst, std::abs(y[i] - sum));
      size = std::max(size, absolute);
    }
    // Three transforms of log2(2n) butterflies, and a dense sum whose own rounding grows as sqrt(n).
    EHD_CHECK(worst / size, Tolerance::round_off(3 * std::log2(2.0 * n) + std::sqrt(n)));
    ++rows;
  }
  BOOST_REQUIRE_EQUAL(rows, 7);
}

BOOST_AUTO_TEST_CASE(a_second_plan_of_the_same_length_does_the_same_arithmetic) {
  for (const int n : {64, 100, 512, 4096}) {
    const Array x = Array::LinSpaced(n + 1, 1, 3).sin();
    Array first, second;
    fast::Convolution one(n), other(n);
    one.apply(x, first);
    other.apply(x, second);
    BOOST_TEST_CONTEXT(n) BOOST_CHECK((first == second).all());
  }
}

BOOST_AUTO_TEST_CASE(a_plan_without_memory_is_an_exception, *testing::needs_measurable_memory()) {
  BOOST_CHECK_THROW(fast::require_plan_memory(std::numeric_limits<int>::max()), std::bad_alloc);
}

/// In a child, since nothing else may follow.
BOOST_AUTO_TEST_CASE(fftw_without_memory_ends_in_terminate_and_not_in_abort, *testing::needs_measurable_memory()) {
  constexpr int terminated = 7;
  const pid_t child = ::fork();
  BOOST_REQUIRE(child >= 0);
  if (child == 0) {
    std::set_terminate([] { ::_exit(terminated); });
    (void)fftw_malloc_plain(std::size_t{1} << 60);
    ::_exit(0);
  }
  int status = 0;
  BOOST_REQUIRE(::waitpid(child, &status, 0) == child);
  BOOST_TEST(WIFEXITED(status));
  BOOST_TEST(WEXITSTATUS(status) == terminated);
}

BOOST_AUTO_TEST_SUITE_END()

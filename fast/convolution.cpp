// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/convolution.hpp"

#include <fftw3.h>

#include <chrono>
#include <cmath>
#include <exception>
#include <mutex>
#include <new>
#include <numbers>

/// Takes the place of FFTW's own function, which aborts. FFTW calls it where it gets no memory, which after
/// require_plan_memory happens only if another thread takes the memory in between. A plan cannot be given up half-way.
extern "C" void fftw_assertion_failed(const char* /*what*/, int /*line*/, const char* /*file*/) { std::terminate(); }

namespace ehd::fast {

namespace {

std::mutex planner;                   // FFTW's planner is not thread-safe; its execution is
unsigned plan_flags = FFTW_ESTIMATE;  // guarded by the planner's mutex

/// Beyond so many spacings the closed forms of the weights cancel, and their series take over.
constexpr int closed_form_up_to = 24;
/// What planning takes at most, measured up to length 3e6: 24 bytes for each number and 0.2 MB with FFTW_ESTIMATE, 30
/// bytes and 0.3 MB with FFTW_MEASURE (up to 1.3e5). Execution takes none.
constexpr std::size_t plan_bytes_per_number = 32, plan_bytes = 1 << 20;
/// Terms of the series of half a hat.
constexpr int half_hat_terms = 12;

/// G(u) = u^2 ln|u|/2 - 3u^2/4.
double antiderivative(double u) { return u == 0 ? 0 : u * u * (std::log(std::abs(u)) / 2 - 0.75); }

/// The smallest length >= `least` without prime factors above 5.
int friendly_length(int least) {
  for (int length = least;; ++length) {
    int rest = length;
    for (const int prime : {2, 3, 5}) {
      while (rest % prime == 0) rest /= prime;
    }
    if (rest == 1 && length % 2 == 0) return length;
  }
}

}  // namespace

double hat_moment(int k) {
  if (k <= closed_form_up_to) return antiderivative(k + 1) - 2 * antiderivative(k) + antiderivative(k - 1);
  const double q = 1.0 / (static_cast<double>(k) * k);
  // 2 Sum_m G^(2m)(k)/(2m)!, m = 1..6.
  return std::log(static_cast<double>(k)) -
         q * (1.0 / 12 + q * (1.0 / 60 + q * (1.0 / 168 + q * (1.0 / 360 + q / 660))));
}

double half_hat_moment(int k) {
  // Int_0^1 (1-s) ln(k+s) ds = G(k+1) - G(k) - G'(k), G' = u ln u - u.
  if (k == 0) return -0.75;
  if (k <= closed_form_up_to)
    return antiderivative(k + 1) - antiderivative(k) - k * (std::log(static_cast<double>(k)) - 1);
  const double r = 1.0 / k;
  // Taylor: Sum_m (-1)^(m+1) r^m Int (1-s) s^m ds / m, Int = 1/((m+1)(m+2)).
  double sum = 0, power = 1;
  for (int m = 1; m <= half_hat_terms; ++m) {
    power *= -r;
    sum -= power / (static_cast<double>(m) * (m + 1) * (m + 2));
  }
  return std::log(static_cast<double>(k)) / 2 + sum;
}

double trapezoid_weight(int k) {
  constexpr double c = 0.030448457058393271;  // zeta(3)/(4 pi^2) = -zeta'(-2)
  if (k == 0) return -std::log(2 * std::numbers::pi) + 2 * c;
  return k == 1 ? -c : std::log(static_cast<double>(k));
}

bool measure_plans(const std::string& wisdom) {
  const std::lock_guard lock(planner);
  require_plan_memory(0);
  if (!wisdom.empty() && fftw_import_wisdom_from_string(wisdom.c_str()) == 0) return false;
  plan_flags = FFTW_MEASURE;
  return true;
}

std::string measured_plans() {
  const std::lock_guard lock(planner);
  require_plan_memory(0);
  char* const text = fftw_export_wisdom_to_string();
  if (!text) return {};
  std::string wisdom = text;
  fftw_free(text);
  return wisdom;
}

void require_plan_memory(int length) {
  // A direct call: the compiler may leave out a pair of new and delete.
  ::operator delete(::operator new(plan_bytes + plan_bytes_per_number * static_cast<std::size_t>(length)));
}

struct Convolution::Plans {
  int length = 0;
  double* real = nullptr;
  fftw_complex* modes = nullptr;
  fftw_plan forward = nullptr;
  fftw_plan backward = nullptr;

  Plans() = default;
  Plans(const Plans&) = delete;
  Plans& operator=(const Plans&) = delete;
  ~Plans() {
    const std::lock_guard lock(planner);
    if (forward) fftw_destroy_plan(forward);
    if (backward) fftw_destroy_plan(backward);
    fftw_free(real);
    fftw_free(modes);
  }
};

Convolution::Convolution(int intervals, Rule rule) : intervals_(intervals), plans_(std::make_unique<Plans>()) {
  const int length = friendly_length(2 * intervals);
  weights_.resize(length / 2 + 1);
  spectrum_.resize(length / 2 + 1);
  const bool hats = rule == Rule::piecewise_linear;
  for (int k = 0; k <= length / 2; ++k) weights_[k] = hats ? hat_moment(k) : trapezoid_weight(k);

  inner_half_.resize(intervals + 1);
  for (int k = 0; k <= intervals; ++k) inner_half_[k] = hats ? weights_[k] - half_hat_moment(k) : weights_[k] / 2;

  plans_->length = length;
  plans_->real = fftw_alloc_real(static_cast<std::size_t>(length));
  plans_->modes = fftw_alloc_complex(static_cast<std::size_t>(length) / 2 + 1);
  if (!plans_->real || !plans_->modes) throw std::bad_alloc();
  {
    const auto begin = std::chrono::steady_clock::now();
    const std::lock_guard lock(planner);
    require_plan_memory(length);
    plans_->forward = fftw_plan_dft_r2c_1d(length, plans_->real, plans_->modes, plan_flags);
    plans_->backward = fftw_plan_dft_c2r_1d(length, plans_->modes, plans_->real, plan_flags);
    planning_s_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  }
  for (int k = 0; k < length; ++k) plans_->real[k] = weights_[std::min(k, length - k)];
  fftw_execute(plans_->forward);
  for (int k = 0; k <= length / 2; ++k) spectrum_[k] = plans_->modes[k][0] / length;
}

Convolution::~Convolution() = default;

void Convolution::apply(const Array& x, Array& y) {
  double* const real = plans_->real;
  fftw_complex* const modes = plans_->modes;
  for (int i = 0; i < intervals_; ++i) real[i] = x[i];
  for (int i = intervals_; i < plans_->length; ++i) real[i] = 0;
  fftw_execute(plans_->forward);
  for (int k = 0; k <= plans_->length / 2; ++k) {
    modes[k][0] *= spectrum_[k];
    modes[k][1] *= spectrum_[k];
  }
  fftw_execute(plans_->backward);
  y.resize(intervals_ + 1);
  for (int i = 0; i <= intervals_; ++i) y[i] = real[i];
}

}  // namespace ehd::fast

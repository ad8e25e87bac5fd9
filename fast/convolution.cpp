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
/// Visible from outside, since else FFTW would not find it. libehd.so hides it: other users of FFTW have their own way.
extern "C" [[gnu::visibility("default")]] void fftw_assertion_failed(const char* /*what*/, int /*line*/,
                                                                     const char* /*file*/) {
  std::terminate();
}

namespace ehd::fast {

namespace {

/// FFTW's planner is one for the whole process, and not thread-safe; its execution is. Another user of FFTW in the
/// process (a program that loads this code as a library) does not know the mutex below. FFTW's own lock serves both: it
/// is switched on before this code or its caller can plan.
[[maybe_unused]] const bool planner_is_shared = (fftw_make_planner_thread_safe(), true);

std::mutex planner;               // guards FFTW's wisdom, which its own lock leaves out
unsigned effort = FFTW_ESTIMATE;  // guarded by the planner's mutex

/// Beyond so many spacings the closed forms of the weights cancel, and their series take over.
constexpr int closed_form_up_to = 24;
/// Memory that planning takes at most, measured up to length 3e6. FFTW_ESTIMATE: 24 bytes for each number and 0.2 MB
/// for real transforms, which the bench plans; 9 bytes for complex ones. FFTW_MEASURE: 30 bytes and 0.4 MB (up to
/// 1.3e5). Execution takes none.
constexpr std::size_t plan_bytes_per_number = 32, plan_bytes = 1 << 20;
/// Complex transforms whose length is a multiple of this run in place and without buffers. From one array to another
/// FFTW's estimate takes twice as long there (8192, 16384, 32768), since its large strides meet in the same lines of
/// the cache. At other lengths it takes .4 to .9 of the time.
constexpr int in_place_multiple = 4096;
/// Terms of the series of half a hat.
constexpr int half_hat_terms = 12;

/// G(u) = u^2 ln|u|/2 - 3u^2/4.
double antiderivative(double u) { return u == 0 ? 0 : u * u * (std::log(std::abs(u)) / 2 - 0.75); }

/// The smallest even length >= `least` without prime factors above 5.
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
  effort = FFTW_MEASURE;
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

// Two neighbours make one complex number, z_j = x_2j + i x_2j+1. So a complex transform of half the length does; FFTW
// plans it in a twentieth of the time of a real one. Modes Z_k of x become p_k Z_k + i q_k conj(Z_N-k), with p_k = a_k
// - b_k sin(pi k/N), q_k = b_k cos(pi k/N), a_k = (S_k + S_N-k)/2, b_k = (S_k - S_N-k)/2, where S is the spectrum of
// the weights, which is real. As 2N real numbers, i conj(Z_N-k) is Z read backwards (Z_0 by itself).
struct Convolution::Plans {
  int modes = 0;  ///< N
  bool in_place = false;
  double *first = nullptr, *second = nullptr;  ///< 2N numbers each; x goes into the first, the product into the second
  fftw_plan forward = nullptr, backward = nullptr;

  Plans() = default;
  Plans(const Plans&) = delete;
  Plans& operator=(const Plans&) = delete;
  ~Plans() {
    const std::lock_guard lock(planner);
    if (forward) fftw_destroy_plan(forward);
    if (backward) fftw_destroy_plan(backward);
    fftw_free(first);
    fftw_free(second);
  }

  void make() {
    const auto plan = [this](double* from, double* to, int sign) {
      const unsigned how = effort | FFTW_DESTROY_INPUT | (in_place ? FFTW_NO_BUFFERING : 0);
      return fftw_plan_dft_1d(modes, reinterpret_cast<fftw_complex*>(from), reinterpret_cast<fftw_complex*>(to), sign,
                              how);
    };
    forward = plan(first, in_place ? first : second, FFTW_FORWARD);
    backward = plan(in_place ? second : first, second, FFTW_BACKWARD);
  }
  [[nodiscard]] auto transformed() const { return numbers(in_place ? first : second); }
  [[nodiscard]] auto multiplied() const { return numbers(in_place ? second : first); }
  [[nodiscard]] Eigen::Map<Array> numbers(double* of) const { return {of, Eigen::Index{2} * modes}; }
};

Convolution::Convolution(int intervals, Rule rule) : intervals_(intervals) {
  const int length = friendly_length(2 * intervals);
  weights_.resize(length / 2 + 1);
  const bool hats = rule == Rule::piecewise_linear;
  for (int k = 0; k <= length / 2; ++k) weights_[k] = hats ? hat_moment(k) : trapezoid_weight(k);

  inner_half_.resize(intervals + 1);
  for (int k = 0; k <= intervals; ++k) inner_half_[k] = hats ? weights_[k] - half_hat_moment(k) : weights_[k] / 2;
}

void Convolution::plan() {
  if (plans_) return;
  const int N = static_cast<int>(weights_.size()) - 1, length = 2 * N;
  same_.resize(length);
  mirrored_.resize(length);
  auto plans = std::make_unique<Plans>();
  plans->modes = N;
  plans->in_place = N % in_place_multiple == 0;
  plans->first = fftw_alloc_real(static_cast<std::size_t>(length));
  plans->second = fftw_alloc_real(static_cast<std::size_t>(length));
  if (!plans->first || !plans->second) throw std::bad_alloc();
  {
    const auto begin = std::chrono::steady_clock::now();
    const std::lock_guard lock(planner);
    require_plan_memory(length);
    plans->make();
    planning_s_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  }
  for (int k = 0; k < length; ++k) plans->first[k] = weights_[std::min(k, length - k)];
  fftw_execute(plans->forward);
  plans_ = std::move(plans);
  make_factors();
}

void Convolution::make_factors() {
  const int N = plans_->modes;
  const auto Z = plans_->transformed();
  for (int k = 0; k < N; ++k) {
    const Eigen::Index at = Eigen::Index{2} * k, mirrored = Eigen::Index{2} * ((N - k) % N);
    const double angle = std::numbers::pi * k / N, cosine = std::cos(angle), sine = std::sin(angle);
    // Z_k = E_k + i O_k with the transforms of the even and of the odd weights; S_k = E_k + exp(-i angle) O_k.
    const double a = (Z[at] + Z[mirrored]) / 2;
    const double b = (cosine * (Z[at + 1] + Z[mirrored + 1]) - sine * (Z[at] - Z[mirrored])) / 2;
    same_[at] = same_[at + 1] = (a - b * sine) / N;
    mirrored_[at] = mirrored_[at + 1] = b * cosine / N;
  }
}

Convolution::~Convolution() = default;

void Convolution::apply(const Array& x, Array& y) {
  plan();
  const int N = plans_->modes;
  auto padded = plans_->numbers(plans_->first);
  padded.head(intervals_) = x.head(intervals_);
  padded.tail(2 * N - intervals_).setZero();
  fftw_execute(plans_->forward);
  const auto Z = plans_->transformed();
  auto product = plans_->multiplied();
  product.head(2) = same_.head(2) * Z.head(2) + mirrored_.head(2) * Z.head(2).reverse();
  const auto rest = 2 * N - 2;
  product.tail(rest) = same_.tail(rest) * Z.tail(rest) + mirrored_.tail(rest) * Z.tail(rest).reverse();
  fftw_execute(plans_->backward);
  y = plans_->numbers(plans_->second).head(intervals_ + 1);
}

}  // namespace ehd::fast

// SPDX-License-Identifier: GPL-3.0-or-later
// Several threads, a second user of FFTW, and the callback that cancels.
#include <fftw3.h>

#include <atomic>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>
#include <thread>
#include <vector>

#include "contact/nondimensional.hpp"
#include "tests/bindings/held.hpp"
#include "tests/check.hpp"
#include "workflow/batch.hpp"
#include "workflow/contact_run.hpp"

using namespace ehd::c::test;
using ehd::verification::Tolerance;

namespace {

struct Calls {
  int count = 0, cancel_at = 0;  ///< 0: never
  bool cancel_when_some_are_done = false;
  double last = -1;
  bool falls = false;
  std::thread::id thread = std::this_thread::get_id();
  bool elsewhere = false;
};

int on_progress(double done, void* user) {
  auto& calls = *static_cast<Calls*>(user);
  calls.falls = calls.falls || done < calls.last;
  calls.last = done;
  calls.elsewhere = calls.elsewhere || std::this_thread::get_id() != calls.thread;
  const bool cancel = ++calls.count == calls.cancel_at || (calls.cancel_when_some_are_done && done > 0);
  return cancel ? 1 : 0;
}

/// The callback is there while this lives.
struct WithProgress {
  explicit WithProgress(Calls& calls) { ehd_set_progress(on_progress, &calls); }
  ~WithProgress() { ehd_set_progress(nullptr, nullptr); }
  WithProgress(const WithProgress&) = delete;
  WithProgress& operator=(const WithProgress&) = delete;
};

struct FilmBatch {
  std::vector<double> M, L, minimum, minimum_error, central, central_error;
  std::vector<int> status;

  explicit FilmBatch(std::size_t n)
      : M(n), L(n, 8), minimum(n), minimum_error(n), central(n), central_error(n), status(n) {
    for (std::size_t i = 0; i < n; ++i) M[i] = 5 * std::pow(1.2, static_cast<double>(i % 17));
  }
  int solve(int threads, double tolerance = 1e-3) {
    return ehd_films(M.size(), M.data(), L.data(), nullptr, tolerance, threads, minimum.data(), minimum_error.data(),
                     central.data(), central_error.data(), status.data());
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(threads)

BOOST_AUTO_TEST_CASE(eight_threads_get_the_bits_of_one) {
  constexpr int count = 8;
  const auto film_at = [](int k) { return solve_moes(10 + 3 * k, 9, nullptr, "fast", 1e-3).get("film.minimum.hertz"); };
  std::vector<double> alone, together(count);
  for (int k = 0; k < count; ++k) alone.push_back(film_at(k));
  std::atomic<int> wrong_errors = 0;
  {
    std::vector<std::jthread> threads;
    for (int k = 0; k < count; ++k)
      threads.emplace_back([&, k] {
        together[static_cast<std::size_t>(k)] = film_at(k);
        const std::string name = "solver" + std::to_string(k);  // the last error is the thread's own
        (void)solve_moes(10, 9, nullptr, name.c_str());
        if (std::string(ehd_last_error()).find(name + ":") == std::string::npos) ++wrong_errors;
      });
  }
  for (std::size_t k = 0; k < count; ++k) BOOST_TEST(together[k] == alone[k]);
  BOOST_TEST(wrong_errors == 0);
}

BOOST_AUTO_TEST_CASE(films_are_those_of_single_solves_for_every_number_of_threads) {
  FilmBatch one(12), four(12);
  BOOST_TEST(one.solve(1) == EHD_OK);
  BOOST_TEST(four.solve(4) == EHD_OK);
  BOOST_TEST(one.minimum == four.minimum, boost::test_tools::per_element());
  BOOST_TEST(one.central_error == four.central_error, boost::test_tools::per_element());
  std::vector<ehd::Problem> problems;
  for (const double M : one.M) {
    problems.push_back(
        ehd::nondimensionalise(ehd::MoesGroups{.M = M, .L = 8}, ehd::Lubricant{}, ehd::Flooded{}).problem);
    problems.back().wanted = {ehd::Quantity::film_minimum, ehd::Quantity::film_central};
  }
  const auto batch = ehd::solve_all(ehd::default_solver(), problems, {.tolerance = 1e-3}, 1);
  for (std::size_t i = 0; i < batch.size(); ++i) {
    BOOST_TEST(one.status[i] == EHD_CONVERGED);
    BOOST_TEST(one.minimum[i] == batch[i].observables.at(ehd::Quantity::film_minimum).value);
    BOOST_TEST(one.minimum_error[i] == *batch[i].observables.at(ehd::Quantity::film_minimum).error);
    BOOST_TEST(one.central[i] == batch[i].observables.at(ehd::Quantity::film_central).value);
    EHD_CHECK(one.minimum_error[i], Tolerance::required(1e-3, "the tolerance asked for"));
  }
}

// The test itself uses FFTW, without a lock: so does a program that loads the library. Each solve of a new thread
// plans.
BOOST_AUTO_TEST_CASE(a_second_user_of_fftw_may_plan_meanwhile) {
  std::atomic<bool> solving = true;
  std::atomic<long> planned = 0;
  constexpr long enough = 100;
  constexpr int most_solves = 3000;
  const auto plan = [&](int first) {
    for (int n = first; solving; n = n < 4000 ? n + 2 : first) {
      auto* const numbers = fftw_alloc_complex(static_cast<std::size_t>(n));
      const fftw_plan made = fftw_plan_dft_1d(n, numbers, numbers, FFTW_FORWARD, FFTW_ESTIMATE);
      if (made) ++planned;
      fftw_destroy_plan(made);
      fftw_free(numbers);
    }
  };
  const double alone = solve_moes(20, 10).get("film.minimum.hertz");
  std::atomic<int> wrong = 0;
  {
    std::jthread even(plan, 64), odd(plan, 65);
    // On a busy machine the planning threads may have to wait for their turn.
    for (int k = 0; k < 12 || (planned <= enough && k < most_solves); ++k)
      std::jthread([&] { wrong += solve_moes(20, 10).get("film.minimum.hertz") == alone ? 0 : 1; });
    solving = false;
  }
  BOOST_TEST(wrong == 0);
  BOOST_TEST(planned > enough);
}

BOOST_AUTO_TEST_CASE(the_callback_hears_how_far_the_films_are) {
  Calls calls;
  const WithProgress scope(calls);
  FilmBatch films(1500);  // longer than the time between two calls
  BOOST_TEST(films.solve(2) == EHD_OK);
  BOOST_TEST(calls.count >= 2);
  BOOST_TEST(calls.last > 0);
  BOOST_TEST(calls.last <= 1);
  BOOST_TEST(!calls.falls);
  BOOST_TEST(!calls.elsewhere);
}

BOOST_AUTO_TEST_CASE(the_callback_cancels_a_solve) {
  // At once, and in the middle of a solve: `reference` takes seconds for this contact.
  for (const int at : {1, 3}) {
    Calls calls{.cancel_at = at};
    const WithProgress scope(calls);
    const Held cancelled = solve_moes(500, 14, nullptr, "reference", 1e-9);
    BOOST_TEST(cancelled.code == EHD_NOT_MET);
    BOOST_TEST(calls.count == at);
    BOOST_REQUIRE(cancelled.result);
    BOOST_TEST(cancelled.json()["status"] == "limit-reached");
    BOOST_TEST(std::string(ehd_last_error()).find("cancelled") != std::string::npos);
  }
  for (const char* solver : {"fast", "fast.uniform", "reference.linear", "reference.uniform"}) {
    Calls calls{.cancel_at = 1};
    const WithProgress scope(calls);
    const Held cancelled = solve_moes(20, 10, nullptr, solver, 1e-3);
    BOOST_TEST(cancelled.code == EHD_NOT_MET, solver);
    BOOST_TEST(cancelled.json()["status"] == "limit-reached", solver);
  }
  BOOST_TEST(solve_moes(20, 10).code == EHD_OK);  // the next call begins anew
}

BOOST_AUTO_TEST_CASE(the_callback_cancels_films_and_bearings) {
  {
    Calls calls{.cancel_when_some_are_done = true};
    const WithProgress scope(calls);
    FilmBatch films(3000);
    BOOST_TEST(films.solve(2) == EHD_NOT_MET);
    BOOST_TEST(std::string(ehd_last_error()).starts_with("ehd: cancelled by the caller; "));
    BOOST_TEST(calls.last > 0);
    BOOST_TEST(films.status.back() == EHD_LIMIT_REACHED);
    int kept = 0, wrong = 0;
    for (std::size_t i = 0; i < films.status.size(); ++i) {
      const bool converged = films.status[i] == EHD_CONVERGED;
      kept += converged ? 1 : 0;
      // A solve that was cancelled on its way may have a film of a coarse grid.
      wrong += converged ? std::isnan(films.minimum[i]) : films.status[i] != EHD_LIMIT_REACHED;
    }
    BOOST_TEST(kept > 0);
    BOOST_TEST(wrong == 0);
  }
  Calls calls{.cancel_at = 1};
  const WithProgress scope(calls);
  const Held cancelled = bearing(case_text("na4908"), "ehd");
  BOOST_TEST(cancelled.code == EHD_NOT_MET);
  BOOST_TEST(cancelled.json()["status"] == "limit-reached");
  double number = 0;
  const double approach_m = 1e-6;
  BOOST_TEST(ehd_law(cancelled.result.get(), "inner", 1, &approach_m, &number, &number) == EHD_NOT_MET);
}

BOOST_AUTO_TEST_CASE(an_exception_of_the_callback_does_not_come_through) {
  ehd_set_progress([](double, void*) -> int { throw 7; }, nullptr);
  BOOST_TEST(solve_moes(20, 10).code == EHD_NOT_MET);
  BOOST_TEST(std::string(ehd_last_error()).find("callback") != std::string::npos);
  ehd_set_progress(nullptr, nullptr);
}

BOOST_AUTO_TEST_CASE(a_result_made_and_freed_ten_thousand_times) {
  const std::string dry = case_text("dry-steel");
  int failed = 0;
  for (int k = 0; k < 10000; ++k) failed += solve(dry).code == EHD_OK ? 0 : 1;
  for (int k = 0; k < 100; ++k) failed += solve_moes(20, 10, nullptr, "fast", 1e-2).code == EHD_OK ? 0 : 1;
  BOOST_TEST(failed == 0);
}

BOOST_AUTO_TEST_SUITE_END()

// SPDX-License-Identifier: GPL-3.0-or-later
// One bearing, and the contact force law that it was balanced with.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bearing/force_law.hpp"
#include "bearing/law_table.hpp"
#include "bindings/c/call.hpp"
#include "bindings/c/ehd/ehd.h"
#include "bindings/c/result.hpp"
#include "contact/interruption.hpp"
#include "contact/text.hpp"
#include "io/case_reader.hpp"
#include "io/near_miss.hpp"
#include "workflow/bearing_run.hpp"
#include "workflow/registry.hpp"

namespace ehd::c {

namespace {

bearing::Law law_named(const char* name) {
  require_pointer(name, "law");
  if (const auto law = bearing::law_from(name)) return *law;
  throw unknown_name("law", name, is_unknown(name, bearing::names_of(bearing::Laws::all)));
}

/// The default solver under the caller's callback. After that has cancelled, nothing more is solved.
Solution solved(const Problem& problem, const Request& request) {
  if (!interrupted()) return default_solver().solve(problem, request);
  Solution none;
  none.record.status = StopReason::limit_reached;
  none.record.reason = interrupted_reason;
  return none;
}

BearingResult balance(const Case& one, bearing::Law law) {
  Progress progress;
  const Interruptible scope([&progress] { return progress.cancelled(); });
  ContactMemory memory(solved);
  std::vector<BearingResult> results = run_bearing(one, {.laws = {law}, .explicitly = true}, memory);
  return std::move(results.at(0));
}

bearing::Raceway raceway_named(const char* name) {
  require_pointer(name, "raceway");
  if (const auto raceway = word_from<bearing::Raceway>(name)) return *raceway;
  throw unknown_name("raceway", name, is_unknown(name, "inner, outer"));
}

}  // namespace

}  // namespace ehd::c

int ehd_bearing(const char* case_toml, const char* law, ehd_result** result) {
  using namespace ehd;
  using namespace ehd::c;
  return guarded([&] {
    require_pointer(result, "result");
    *result = nullptr;
    require_pointer(case_toml, "case_toml");
    const bearing::Law by = law_named(law);
    const Case one = read_case_in_memory(case_toml);
    if (!std::holds_alternative<BearingCase>(one.body))
      throw case_error(one, "", "this is a contact; allowed is a bearing case (ehd_solve takes this one)");
    BearingResult balanced = balance(one, by);
    const StopReason status = balanced.status;
    const std::string why = balanced.why;
    std::optional<bearing::LawPair> laws;
    if (!balanced.rollers.empty()) laws = laws_of(std::get<BearingCase>(one.body), balanced);
    *result = std::make_unique<ehd_result>(std::move(balanced), std::move(laws)).release();
    return ended(one.id + ": " + law, status, why);
  });
}

int ehd_law(const ehd_result* bearing, const char* raceway, size_t n, const double* approach_m, double* force_N,
            double* stiffness_N_per_m) {
  using namespace ehd;
  using namespace ehd::c;
  return guarded([&] {
    require_pointer(bearing, "bearing");
    const bool inner = raceway_named(raceway) == bearing::Raceway::inner;
    if (n == 0) throw BadArgument("n = 0: there are no approaches; allowed is 1 or more");
    require_pointer(approach_m, "approach_m");
    require_pointer(force_N, "force_N");
    require_pointer(stiffness_N_per_m, "stiffness_N_per_m");
    if (!bearing->of_bearing()) throw BadArgument("bearing: is the result of a contact; allowed is one of ehd_bearing");
    if (const double* const bad =
            std::find_if_not(approach_m, approach_m + n, [](double x) { return std::isfinite(x); });
        bad != approach_m + n)
      throw BadArgument(
          fmt::format("approach_m[{}] = {}: is not finite; allowed is a length in m", bad - approach_m, plain(*bad)));
    if (!bearing->laws) {
      set_last_error("ehd: the bearing has no balance, and so no law");
      return EHD_NOT_MET;
    }
    const bearing::ForceLaw& law = inner ? bearing->laws->inner : bearing->laws->outer;
    const auto range = domain(law);
    size_t outside = 0;
    for (size_t i = 0; i < n; ++i) {
      force_N[i] = force(law, approach_m[i]);
      stiffness_N_per_m[i] = stiffness(law, approach_m[i]);
      if (range && force_N[i] > range->second) ++outside;
    }
    if (outside == 0) return EHD_OK;
    set_last_error(fmt::format("ehd: {} of {} forces are above {} N, where the range of the law ends", outside, n,
                               plain(range->second)));
    return EHD_NOT_MET;
  });
}

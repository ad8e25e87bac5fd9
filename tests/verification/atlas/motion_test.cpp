// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/atlas/motion.hpp"

#include <atomic>
#include <complex>
#include <fstream>
#include <string>

#include "io/case_reader.hpp"
#include "tests/check.hpp"
#include "tests/files.hpp"
#include "verification/studies/motion_maps.hpp"

using namespace ehd;
using namespace ehd::verification;

namespace {

/// Solves nothing; counts. kappa_0 = 4 + M/1000, kappa_1 = L/100; damping is -0.02/Omega at Omega = 2 and 0.1
/// elsewhere; of waves a half is left, a little more of heavier contacts.
struct FakeResponse {
  std::atomic<int> solves = 0;

  [[nodiscard]] RegisteredSolver solver() {
    RegisteredSolver fake = *find_solver("reference");
    fake.name = "fake";
    fake.respond = [this](const Problem& problem, const ResponseRequest& request) {
      const bool of_the_version = problem.groups.M == 4 || problem.groups.M == 9;
      if (!of_the_version) ++solves;
      const double M = problem.groups.M, L = problem.groups.L;
      Response found{.status = StopReason::converged, .reason = {}};
      found.slow = SlowStiffness{.kappa_0 = 4 + M / 1000, .kappa_1 = L / 100 + 0.01, .error_0 = 1e-9, .error_1 = 1e-8};
      for (const double Omega : request.frequencies)
        found.frequencies.push_back({.Omega = Omega,
                                     .kappa = {4.5, Omega == 2 ? -0.02 : 0.1 * Omega},
                                     .error = 1e-6,
                                     .status = StopReason::converged});
      for (const Waviness& wave : request.waviness)
        found.waviness.push_back({.waviness = wave,
                                  .film = std::polar(0.5 + M / 1000, 0.25),
                                  .error = 1e-6,
                                  .status = StopReason::converged});
      return found;
    };
    return fake;
  }
};

AtlasRequest motion_in(const test::Folder& folder) {
  return {.folder = folder.path() / "atlas", .points = motion_points(), .only = {}, .threads = 2};
}

}  // namespace

BOOST_AUTO_TEST_SUITE(atlas_motion)

BOOST_AUTO_TEST_CASE(waves_of_all_contacts_have_the_same_similar_wavelengths) {
  std::size_t waves = 0;
  for (const AtlasPoint& point : motion_points()) {
    for (const Waviness& wave : motion_request(point).waviness) {
      const double similar = similar_wavelength({point.M, point.L}, wave.wavelength);
      double nearest = 1;
      for (const double listed : similar_wavelengths) nearest = std::min(nearest, std::abs(similar / listed - 1));
      EHD_CHECK(nearest, Tolerance::required(1e-3, "waves have four digits"));
      ++waves;
    }
  }
  BOOST_TEST(waves > 100u);
  BOOST_TEST(similar_wavelength({16, 4}, 3) == 12.0);  // 3 16^(3/4)/4^(1/2)
}

BOOST_AUTO_TEST_CASE(a_motion_run_writes_tables_that_are_read_back_and_goes_on_from_its_records) {
  const test::Folder folder;
  FakeResponse fake;
  const AtlasResult result = run_motion_atlas(motion_in(folder), fake.solver());
  const int all = static_cast<int>(motion_points().size());
  BOOST_TEST(fake.solves == all);
  BOOST_TEST(result.entries.size() == motion_points().size());
  const auto rows = read_motion_table(kappa_table(), folder.path() / "atlas");
  std::size_t expected = 0;
  for (const AtlasPoint& point : motion_points()) expected += 1 + motion_request(point).frequencies.size();
  BOOST_TEST(rows.size() == expected);
  BOOST_TEST(motion_csv_text(kappa_table(), rows) == test::read(folder.path() / "atlas" / "kappa.csv"));
  const auto waves = read_motion_table(waviness_table(), folder.path() / "atlas");
  BOOST_TEST(waves.front().at("phase_deg").substr(0, 6) == "14.324");  // 0.25 rad
  (void)run_motion_atlas(motion_in(folder), fake.solver());
  BOOST_TEST(fake.solves == all);  // nothing is solved again
  AtlasRequest one = motion_in(folder);
  one.only = "atlas-barus-m5-l5-flooded", one.fresh = true;
  (void)run_motion_atlas(one, fake.solver());
  BOOST_TEST(fake.solves == all + 1);
  BOOST_TEST(read_motion_table(kappa_table(), folder.path() / "atlas").size() == expected);  // the others stay
}

BOOST_AUTO_TEST_CASE(a_damaged_table_of_motion_is_refused_with_its_line) {
  const test::Folder folder;
  FakeResponse fake;
  AtlasRequest request = motion_in(folder);
  request.points = {{AtlasLaws::roelands, 20, 10, Flooded{}}};
  (void)run_motion_atlas(request, fake.solver());
  const std::string text = test::read(folder.path() / "atlas" / "kappa.csv");
  const auto refused = [&](const std::string& before, const std::string& now, const std::string& message) {
    std::string damaged = text;
    damaged.replace(damaged.find(before), before.size(), now);
    std::ofstream(folder.path() / "atlas" / "kappa.csv", std::ios::binary) << damaged;
    try {
      (void)read_motion_table(kappa_table(), folder.path() / "atlas");
      BOOST_ERROR("not refused: " << now);
    } catch (const CaseError& error) {
      BOOST_TEST(std::string(error.what()).find(message) != std::string::npos, error.what());
    }
  };
  refused("id,laws", "id,rules", "kappa.csv:2: ");
  refused("flooded,roelands", "flooded,lawless", "kappa.csv:3: laws = lawless: is unknown; allowed is isoviscous");
  refused(",20,10,0,", ",20,10,-1,", "kappa.csv:3: Omega = -1: is out of range");
  refused(",20,10,0,", ",20,nan,0,", "L = nan: is not finite");
  refused(",0.11", ",x0.11", "kappa.csv:3: damping = x0.11");
  refused(",0.11", ",,0.11", "kappa.csv:3: ");
  BOOST_CHECK_THROW((void)read_motion_table(waviness_table(), folder.path()), CaseError);
}

BOOST_AUTO_TEST_CASE(motion_maps_show_where_damping_is_negative_and_how_far_waves_are_one_curve) {
  const test::Folder folder;
  FakeResponse fake;
  AtlasRequest request = motion_in(folder);
  request.points = {{AtlasLaws::roelands, 20, 10, Flooded{}}, {AtlasLaws::roelands, 200, 5, Flooded{}}};
  (void)run_motion_atlas(request, fake.solver());
  const MotionMaps maps = motion_maps(folder.path() / "atlas");
  BOOST_TEST((driven_frequencies(maps, AtlasLaws::roelands, {20, 10}) == std::vector<double>{2}));
  BOOST_TEST(driven_frequencies(maps, AtlasLaws::roelands, {2, 10}).empty());  // not in the table
  const std::string text = human_motion_maps(maps);
  for (const char* part : {"kappa_1, roelands", "0.11",
                           "Omega with negative damping, of 0, 1, 2, 3, 4, 5, 6, 7, 8; 0: slow motion; roelands",
                           "similar wavelength 4", "1.35"})  // 0.7/0.52
    BOOST_TEST(text.find(part) != std::string::npos, part);
}

BOOST_AUTO_TEST_SUITE_END()

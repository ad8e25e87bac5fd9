// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/files.hpp"
#include "tests/verification/atlas/made_atlas.hpp"
#include "verification/atlas/atlas.hpp"

using namespace ehd;
using namespace ehd::verification;

namespace {

void replace_in(const std::filesystem::path& file, const std::string& before, const std::string& now) {
  std::string text = test::read(file);
  const auto at = text.find(before);
  BOOST_REQUIRE_MESSAGE(at != std::string::npos, before << " is not in " << file);
  std::ofstream(file, std::ios::binary) << text.replace(at, before.size(), now);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(atlas_check)

using namespace made_atlas;

BOOST_AUTO_TEST_CASE(a_case_without_a_point_is_reported_and_left) {
  const test::Folder folder;
  Fake fake;
  AtlasRequest request = request_in(folder);
  (void)run_atlas(request, fake.solver());
  request.points.pop_back();
  const AtlasResult result = run_atlas(request, fake.solver());
  BOOST_REQUIRE(result.left_over.size() == 1u);
  BOOST_TEST(result.left_over.front() == few_points().back().id() + ".toml");
  BOOST_TEST(atlas_disagreements(request.folder).size() == 1u);
}

BOOST_AUTO_TEST_CASE(an_edited_file_disagrees) {
  const auto points = few_points();
  const std::string light = points[3].id() + ".toml", heavy = points[4].id() + ".toml";
  const struct {
    std::string file, before, now, said;
  } edits[] = {
      {light, "\nM = 20", "\nM = 21", "id is atlas-barus-m21-l5-cut4, not atlas-barus-m20-l5-cut4"},
      {light, "inlet = -4", "inlet = \"flooded\"", "id is"},
      {heavy, "z = 0.68", "z = 0.67", "has another lubricant"},
      {heavy, "p0_Pa = 1.96e8", "p0_Pa = 1.97e8", "has another lubricant"},
      {heavy, "value = \"2", "value = \"3", "H_min is"},
      {heavy, "uncertainty = ", "uncertainty = 0.1 # ", "the uncertainty of H_min"},
      {heavy, "scaling = \"hertz\"", "scaling = \"moes\"", "is not a computed one in Hertz units"},
      {heavy, "quantity = \"pressure.spike\"", "quantity = \"pressure.maximum\"", "P_spike is absent"},
      {heavy, "title = \"Atlas", "title = \"atlas", "is called"},
      {heavy, "version = 1", "version = one", "toml:3: "},
      {"atlas.csv", "barus,20,5,-4", "barus,20,5,flooded", "inlet is -4, not flooded"},
      {"atlas.csv", "atlas-barus-m20-l5-cut4,barus", "atlas-barus-m20-l5-cut4,roelands", "differs from the table"},
  };
  for (const auto& edit : edits) {
    BOOST_TEST_CONTEXT(edit.file << ": " << edit.before << " -> " << edit.now) {
      const test::Folder folder;
      Fake fake;
      const AtlasRequest request = request_in(folder);
      (void)run_atlas(request, fake.solver());
      replace_in(request.folder / edit.file, edit.before, edit.now);
      const auto found = atlas_disagreements(request.folder);
      BOOST_REQUIRE(found.size() == 1u);
      BOOST_TEST(found.front().find(edit.said) != std::string::npos, found.front());
    }
  }
  const test::Folder folder;
  Fake fake;
  const AtlasRequest request = request_in(folder);
  (void)run_atlas(request, fake.solver());
  std::filesystem::remove(request.folder / light);
  BOOST_TEST(atlas_disagreements(request.folder).size() == 1u);
}

BOOST_AUTO_TEST_SUITE_END()

// SPDX-License-Identifier: GPL-3.0-or-later
// The topics of the suite, a file a topic. A new topic is one file here, which defines NAME_topics, and one line below.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "verification/claim.hpp"
#include "workflow/case.hpp"

/// In the order of the suite. LINE(name, parameters, arguments): what NAME_topics takes, and what suite.cpp gives it
/// from its request and the cases.
#define EHD_TOPICS(LINE)                                                                        \
  LINE(input, (), ())                                                                           \
  LINE(oil_grade, (), ())                                                                       \
  LINE(law, (), ())                                                                             \
  LINE(property, (), ())                                                                        \
  LINE(kernel, (), ())                                                                          \
  LINE(exact, (), ())                                                                           \
  LINE(reynolds, (), ())                                                                        \
  LINE(coupled, (), ())                                                                         \
  LINE(iteration, (), ())                                                                       \
  /* One for each case, bearings left out; a case that could not be read is a failing claim. */ \
  LINE(contact, (const std::vector<LoadedCase>& cases), (cases))                                \
  LINE(twin, (), ())                                                                            \
  LINE(box, (), ())                                                                             \
  LINE(heavy, (), ())                                                                           \
  /* Random runs for each law set and question; of fast five times as many points. */           \
  LINE(random, (int runs), (request.random_runs))                                               \
  LINE(grid, (), ())                                                                            \
  LINE(truncation, (), ())                                                                      \
  LINE(stated_error, (), ())                                                                    \
  LINE(film_table, (), ())                                                                      \
  LINE(regime, (), ())                                                                          \
  LINE(response, (), ())                                                                        \
  LINE(response_motion, (), ())                                                                 \
  LINE(fast_response, (), ())                                                                   \
  LINE(atlas, (), ())                                                                           \
  LINE(atlas_motion, (), ())                                                                    \
  LINE(literature, (), ())                                                                      \
  LINE(bearing, (const std::vector<LoadedCase>& cases), (cases))                                \
  /* Parts of NA4908 where it is in the list; both forms of balance of every bearing case. */   \
  LINE(bearing_part, (const std::vector<LoadedCase>& cases), (cases))

namespace ehd::verification {

/// A piece of work that ends in claims. Topics run in threads side by side; each keeps its own state.
struct Topic {
  std::string name;
  std::set<int> rungs;       ///< that its claims stand on
  std::string case_id = {};  ///< the case that it is about; empty for none
  bool slow = false;         ///< left out with --quick
  std::function<Findings()> judge;
  double expected_s = 0;  ///< roughly, on one core, where more than a second; for the order and the time left
};

/// A case file: the case, or the error that reading gave.
struct LoadedCase {
  std::string id;  ///< the file's name where it could not be read
  std::variant<Case, CaseError> content;
};

#define EHD_DECLARE_TOPICS(NAME, PARAMETERS, ARGUMENTS) [[nodiscard]] std::vector<Topic> NAME##_topics PARAMETERS;
EHD_TOPICS(EHD_DECLARE_TOPICS)
#undef EHD_DECLARE_TOPICS

}  // namespace ehd::verification

// SPDX-License-Identifier: GPL-3.0-or-later
// Runs that are interrupted, damaged or repeated.
#include "io/sweep_run.hpp"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <string>

#include "io/output_file.hpp"
#include "io/sweep_file.hpp"
#include "io/sweep_shards.hpp"
#include "tests/io/sweeps.hpp"

using namespace ehd;
using namespace ehd::verification;
using namespace ehd::verification::test;

namespace {

/// The cheapest sweep of contacts.
const char* contact_sweep = R"(case = "own-moes-20-10"
combine = "product"
tolerance = 1e-2
[keys]
"moes.M" = [10.0, 20.0, 30.0]
)";

}  // namespace

BOOST_AUTO_TEST_SUITE(sweep_run)

BOOST_AUTO_TEST_CASE(a_row_that_lacked_time_is_tried_again_unless_it_is_to_be_kept) {
  const Folder folder;
  const Sweep read = read_sweep(folder.write("s.toml", contact_sweep));
  const auto out = folder.path() / "out";
  constexpr double too_short_s = 1e-9;
  const auto again = [&](bool keep) {
    return run_sweep(read, {.time_limit_s = too_short_s, .keep_limits = keep}, out);
  };
  BOOST_TEST(again(false).failures.rows == 3u);
  BOOST_TEST(again(false).computed == 3u);
  BOOST_TEST(again(true).computed == 0u);
}

// A row that ended in time does not depend on the time that it might have had.
BOOST_AUTO_TEST_CASE(another_time_limit_keeps_the_rows_that_ended_in_time) {
  const Folder folder;
  const Sweep read = read_sweep(folder.write("s.toml", contact_sweep));
  const auto out = folder.path() / "out", cut = folder.path() / "cut";
  BOOST_TEST(run_sweep(read, {.time_limit_s = 100}, out).computed == 3u);
  const Files before(out);
  BOOST_TEST(run_sweep(read, {.time_limit_s = 200}, out).computed == 0u);
  BOOST_TEST((Files(out) == before));
  BOOST_TEST(run_sweep(read, {.time_limit_s = 1e-9}, cut).failures.rows == 3u);
  const SweepCost whole = run_sweep(read, {.time_limit_s = 200}, cut);
  BOOST_TEST(whole.computed == 3u);
  BOOST_TEST(whole.failures.rows == 0u);
  BOOST_TEST((Files(cut) == before));
}

// Film curves may end where one of their contacts lacked time. Their row then says no more than that.
BOOST_AUTO_TEST_CASE(a_row_whose_film_curves_were_cut_by_a_limit_is_tried_again) {
  const Folder folder;
  const Sweep read = read_sweep(folder.write("s.toml", dry_sweep));
  const std::string why = std::string(limit_ended_film_curves) + "; and more";
  BOOST_TEST(lacked_time_or_memory(row_not_computed(read, 0, std::string(32, '0'), why).text));
  BOOST_TEST(!lacked_time_or_memory(row_not_computed(read, 0, std::string(32, '0'), "50 iterations").text));
}

BOOST_AUTO_TEST_CASE(rows_after_the_deadline_are_named_and_run_by_the_next_run) {
  const Folder folder;
  const Sweep read = read_sweep(folder.write("s.toml", contact_sweep));
  const auto out = folder.path() / "out";
  constexpr double passed_s = -1;
  const SweepCost cut = run_sweep(read, {.deadline = Deadline(passed_s)}, out);
  BOOST_TEST(cut.computed == 0u);
  BOOST_TEST(cut.not_run == 3u);
  BOOST_TEST(cut.failures.rows == 3u);
  BOOST_TEST(cut.failures.first == "row 0: limit-reached: " + std::string(Deadline::not_run));
  BOOST_TEST(lines_of_text(test::read(out / "rows.csv")).size() == 4u);
  const SweepCost whole = run_sweep(read, {}, out);
  BOOST_TEST(whole.computed == 3u);
  BOOST_TEST(whole.failures.rows == 0u);
  (void)run_sweep(read, {}, folder.path() / "at once");
  BOOST_TEST((Files(out) == Files(folder.path() / "at once")));
}

BOOST_AUTO_TEST_CASE(a_killed_run_goes_on_where_it_was_and_ends_in_the_same_files) {
  const Folder folder;
  const auto file = folder.write("s.toml", dry_sweep);
  const Sweep read = read_sweep(file);
  (void)run_sweep(read, {.threads = 1}, folder.path() / "whole");
  constexpr std::size_t finished = 4;
  const auto out = folder.path() / "killed";
  const pid_t child = ::fork();
  BOOST_REQUIRE(child >= 0);
  if (child == 0) {  // kill -9 in the middle
    SweepRequest request{.threads = 1};
    request.progress = [](std::size_t, std::size_t, std::size_t computed) {
      if (computed == finished) ::kill(::getpid(), SIGKILL);
    };
    (void)run_sweep(read, request, out);
    ::_exit(0);
  }
  int status = 0;
  BOOST_REQUIRE(::waitpid(child, &status, 0) == child);
  BOOST_TEST(WIFSIGNALED(status));
  BOOST_TEST(!std::filesystem::exists(out / "rows.csv"));
  // As if it had been killed in the middle of a line.
  const auto journal = out / "rows/journal";
  const std::string kept = test::read(journal);
  std::ofstream(journal, std::ios::binary | std::ios::app) << kept.substr(kept.size() / 2, 300);
  const SweepCost cost = run_sweep(read, {.threads = 1}, out);
  BOOST_TEST(cost.rows == 15u);
  BOOST_TEST(cost.computed == 15u - finished);
  BOOST_TEST((Files(out) == Files(folder.path() / "whole")));
  BOOST_TEST(run_sweep(read, {.threads = 1}, out).computed == 0u);
  BOOST_TEST(run_sweep(read, {.threads = 1, .fresh = true}, out).computed == 15u);
  BOOST_TEST((Files(out) == Files(folder.path() / "whole")));
}

BOOST_AUTO_TEST_CASE(a_damaged_row_is_computed_again) {
  const Folder folder;
  const Sweep read = read_sweep(folder.write("s.toml", dry_sweep));
  const auto out = folder.path() / "out";
  (void)run_sweep(read, {}, out);
  const Files before(out);
  std::string journal = test::read(out / "rows/journal");
  const std::size_t digit = journal.find("\"force_N\":", journal.size() / 2) + 11;
  journal[digit] = journal[digit] == '7' ? '8' : '7';
  std::ofstream(out / "rows/journal", std::ios::binary | std::ios::trunc) << journal;
  BOOST_TEST(run_sweep(read, {}, out).computed == 1u);
  BOOST_TEST((Files(out) == before));
}

// A journal of a version that hashed with SHA-256: its rows are computed again.
BOOST_AUTO_TEST_CASE(a_journal_of_an_older_version_is_computed_again) {
  const Folder folder;
  const Sweep read = read_sweep(folder.write("s.toml", dry_sweep));
  (void)run_sweep(read, {}, folder.path() / "new");
  const auto out = folder.path() / "old";
  std::filesystem::create_directories(out / "rows");
  std::ofstream(out / "rows/journal", std::ios::binary)
      << R"(b75049c001e4c984 {"schema":"ehd-sweep-journal-1",)"
      << R"("sweep":"241a47365650322f1e678965bf74253946eb7e6c460633bf6d265aa2b5be6b3b","shard":1,"of":1})"
      << "\n03fc809bdfa4a470 02b6a970740a6ac4f6057771f12bccc9c6b4ea391c202a765ae9aa81bbdc96a6 {\"keys\":{}}\n";
  const SweepCost cost = run_sweep(read, {}, out);
  BOOST_TEST(cost.computed == read.rows());
  BOOST_TEST((Files(out) == Files(folder.path() / "new")));
  BOOST_TEST(test::read(out / "rows/journal").find("ehd-sweep-journal-1") == std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_file_of_that_name_that_is_no_journal_is_kept) {
  const Folder folder;
  const Sweep read = read_sweep(folder.write("s.toml", dry_sweep));
  const std::string precious = "measured on 3 May: 1.0 2.0 3.0\n";
  const auto elsewhere = folder.write("precious.txt", precious);
  for (const bool linked : {false, true}) {
    const auto out = folder.path() / (linked ? "linked" : "plain");
    std::filesystem::create_directories(out / "rows");
    if (linked)
      std::filesystem::create_symlink(elsewhere, out / "rows/journal");
    else
      std::ofstream(out / "rows/journal") << precious;
    std::string refusal;
    try {
      (void)run_sweep(read, {}, out);
    } catch (const OutputError& error) {
      refusal = error.what();
    }
    BOOST_TEST(refusal.find(linked ? "is a link" : "is no journal") != std::string::npos, refusal);
    BOOST_TEST(test::read(out / "rows/journal") == precious);
  }
}

BOOST_AUTO_TEST_CASE(what_a_row_follows_from_is_in_its_hash) {
  const Folder folder;
  const auto other = [&](const std::string& text) { return read_sweep(folder.write("s.toml", text)); };
  std::set<std::string> hashes;
  const auto add = [&](const Sweep& one, const SweepRequest& request) { hashes.insert(row_hash(one, request, 0)); };
  const std::string key = "[keys]\n\"operation.radial_load_N\" = ";
  add(other(head("laws = [\"hertz\"]\ncombine = \"zip\"\n" + key + "[1e3]\n")), {});
  add(other(head("laws = [\"hertz\"]\ncombine = \"product\"\n" + key + "[1e3, 2e3]\n")), {});  // the same row
  BOOST_TEST(hashes.size() == 1u);
  add(other(head("laws = [\"iso\"]\ncombine = \"zip\"\n" + key + "[1e3]\n")), {});
  add(other(head("laws = [\"hertz\"]\ncombine = \"zip\"\n" + key + "[1001.0]\n")), {});
  add(other(head("laws = [\"hertz\"]\nsolver = \"reference\"\ncombine = \"zip\"\n" + key + "[1e3]\n")), {});
  add(other(head("laws = [\"hertz\"]\ncombine = \"zip\"\n" + key + "[1e3]\n")), {.max_iterations = 7});
  add(other(head("laws = [\"hertz\"]\ncombine = \"zip\"\n" + key + "[1e3]\n")), {.time_limit_s = 7});  // no other row
  add(other("case = \"na4908-10um\"\nlaws = [\"hertz\"]\ncombine = \"zip\"\n" + key + "[1e3]\n"), {});
  BOOST_TEST(hashes.size() == 6u);
}

BOOST_AUTO_TEST_CASE(a_second_run_in_the_same_folder_is_refused_while_the_first_works) {
  const Folder folder;
  const Sweep read = read_sweep(folder.write("s.toml", dry_sweep));
  const auto out = folder.path() / "out";
  std::string refusal;
  SweepRequest request{.threads = 1};
  request.progress = [&](std::size_t, std::size_t, std::size_t computed) {
    if (computed != 1) return;
    try {
      (void)run_sweep(read, {}, out);
    } catch (const OutputError& error) {
      refusal = error.what();
    }
  };
  (void)run_sweep(read, request, out);
  BOOST_TEST(refusal.find("another run") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()

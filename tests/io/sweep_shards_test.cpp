// SPDX-License-Identifier: GPL-3.0-or-later
// The shards of several processes, and their merged files.
#include "io/sweep_shards.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "io/output_file.hpp"
#include "io/sweep_file.hpp"
#include "tests/io/sweeps.hpp"
#include "tests/process.hpp"

using namespace ehd;
using namespace ehd::verification;
using namespace ehd::verification::test;

BOOST_AUTO_TEST_SUITE(sweep_shards)

BOOST_AUTO_TEST_CASE(the_first_wrong_row_is_refused_whatever_the_threads_do) {
  const Folder folder;
  const Sweep read =
      read_sweep_statement(folder.write("s.toml", keys("\"bearing.rollers\" = [22, 20, -1, 18, -2, -3]\n")));
  const auto refusal = [&](const std::vector<std::size_t>& rows, unsigned threads) -> std::string {
    try {
      require_cases(read, rows, threads);
    } catch (const CaseError& error) {
      return error.what();
    }
    return "";
  };
  for (const unsigned threads : {1u, 2u, 8u}) {
    BOOST_TEST(refusal({0, 1, 2, 3, 4, 5}, threads).find("row 2 ") != std::string::npos);
    BOOST_TEST(refusal(rows_of(read, {2, 2}), threads).find("row 5 ") != std::string::npos);
    BOOST_TEST(refusal({0, 1, 3}, threads) == "");
  }
}

BOOST_AUTO_TEST_CASE(a_shard_reads_the_cases_of_its_own_rows) {
  const Folder folder;
  const auto file = folder.write("s.toml", keys("\"bearing.rollers\" = [22, -1]\n") + "");
  const auto shard = [&](const char* part) {
    return test::ehd_run(
        folder, fmt::format("sweep {} --output {} --shard {}", quoted(file), quoted(folder.path() / "out"), part));
  };
  BOOST_TEST(shard("1/2").exit_code == 0);
  BOOST_TEST(shard("2/2").exit_code == 2);
  test::check_refused(folder, fmt::format("sweep {} --output {} --merge", quoted(file), quoted(folder.path() / "out")),
                      "2-of-2");
}

BOOST_AUTO_TEST_CASE(shards_take_every_row_once) {
  const Folder folder;
  const Sweep read = read_sweep(folder.write("s.toml", dry_sweep));
  for (const std::size_t of : {1u, 2u, 4u, 15u, 40u}) {
    std::vector<int> taken(read.rows());
    for (std::size_t number = 1; number <= of; ++number)
      for (const std::size_t row : rows_of(read, {number, of})) ++taken[row];
    BOOST_TEST(std::count(taken.begin(), taken.end(), 1) == static_cast<long>(read.rows()));
  }
}

BOOST_AUTO_TEST_CASE(merged_shards_are_the_unsharded_files_bit_for_bit) {
  const Folder folder;
  const auto file = folder.write("s.toml", small_sweep);
  const auto whole = folder.path() / "whole", parts = folder.path() / "parts";
  BOOST_TEST(test::ehd_run(folder, fmt::format("sweep {} --output {}", quoted(file), quoted(whole))).exit_code == 0);
  for (const char* shard : {"3/4", "1/4", "4/4", "2/4"}) {
    const auto ended =
        test::ehd_run(folder, fmt::format("sweep {} --output {} --shard {}", quoted(file), quoted(parts), shard));
    BOOST_TEST(ended.exit_code == 0);
    BOOST_TEST(!std::filesystem::exists(parts / "rows.csv"));
  }
  const auto merged = test::ehd_run(folder, fmt::format("sweep {} --output {} --merge", quoted(file), quoted(parts)));
  BOOST_TEST(merged.exit_code == 0);
  BOOST_TEST(merged.err == "");
  BOOST_TEST((Files(parts) == Files(whole)));
}

BOOST_AUTO_TEST_CASE(shards_that_are_missing_unfinished_damaged_or_foreign_are_named) {
  const Folder folder;
  const Sweep read = read_sweep(folder.write("s.toml", dry_sweep));
  const auto out = folder.path() / "out";
  for (const std::size_t number : {1u, 2u, 3u}) (void)run_shard(read, {}, out, {number, 3});
  const auto refusal = [&](const Sweep& of) -> std::string {
    try {
      (void)merge_shards(of, {}, out);
    } catch (const OutputError& error) {
      BOOST_TEST(!std::filesystem::exists(out / "rows.csv"));
      BOOST_TEST(std::string(error.what()).find('\n') == std::string::npos);
      return error.what();
    }
    return "merged";
  };
  const auto says = [&](const std::string& message, const std::string& text) {
    BOOST_TEST(message.find(text) != std::string::npos, message);
    BOOST_TEST(message.find("2-of-3") != std::string::npos, message);
    BOOST_TEST(message.find("--shard 2/3") != std::string::npos, message);
  };
  const auto second = out / "shards/2-of-3/journal";
  const std::string whole = test::read(second);
  const auto put = [&](const std::string& text) { std::ofstream(second, std::ios::binary | std::ios::trunc) << text; };

  std::filesystem::remove(second);
  says(refusal(read), "missing");
  put(whole.substr(0, whole.rfind('\n', whole.size() - 2) + 1));
  says(refusal(read), "holds 4 of 5 rows");
  put(whole.substr(0, whole.size() - 40));
  says(refusal(read), "damaged at line 6");
  std::string flipped = whole;
  flipped[whole.size() / 2] ^= 1;
  put(flipped);
  says(refusal(read), "damaged at line");
  put(test::read(out / "shards/1-of-3/journal"));
  says(refusal(read), "another part");
  put(whole);
  const Sweep other = read_sweep(folder.write("s.toml", keys("\"operation.radial_load_N\" = [1e3]\n")));
  BOOST_TEST(refusal(other).find("another sweep") != std::string::npos);
  (void)run_shard(read, {}, out, {1, 2});
  BOOST_TEST(refusal(read).find("side by side") != std::string::npos);
  std::filesystem::remove_all(out / "shards/1-of-2");
  BOOST_TEST(refusal(read) == "merged");
  BOOST_TEST(std::filesystem::exists(out / "rows.csv"));
}

// The launchers themselves: tests/engines/.

BOOST_AUTO_TEST_CASE(a_rank_of_a_launcher_is_its_shard) {
  const Folder folder;
  const auto file = folder.write("s.toml", dry_sweep);
  const auto parts = folder.path() / "parts";
  const std::string script = fmt::format("sh '{}/examples/sweeps/rank.sh' {} {} > /dev/null 2>&1", EHD_SOURCE_DIR,
                                         quoted(file), quoted(parts));
  const std::string program = "EHD='" + std::string(EHD_PROGRAM) + "' ";
  // As srun, Open MPI and MPICH tell a process which one it is.
  for (const char* rank :
       {"SLURM_PROCID=0 SLURM_NTASKS=3", "OMPI_COMM_WORLD_RANK=1 OMPI_COMM_WORLD_SIZE=3", "PMI_RANK=2 PMI_SIZE=3"})
    BOOST_TEST(std::system(
                   fmt::format("env -u SLURM_PROCID -u OMPI_COMM_WORLD_RANK -u PMI_RANK {}{} {}", program, rank, script)
                       .c_str()) == 0,
               rank);
  for (const char* name : {"1-of-3", "2-of-3", "3-of-3"})
    BOOST_TEST(std::filesystem::exists(parts / "shards" / name / "journal"), name);
  BOOST_TEST(std::system(("env -u SLURM_PROCID -u OMPI_COMM_WORLD_RANK -u PMI_RANK " + program + script).c_str()) != 0);
}

BOOST_AUTO_TEST_SUITE_END()

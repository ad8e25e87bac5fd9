# SPDX-License-Identifier: GPL-3.0-or-later
# A thin front for CMake: what a new user types. Variables: BUILD (folder), JOBS, CMAKE_FLAGS (passed to CMake),
# CTEST_FLAGS (passed to ctest), FUZZ_SECONDS.

BUILD ?= build
JOBS ?= $(shell nproc 2>/dev/null || echo 2)
CMAKE_FLAGS ?=
CTEST_FLAGS ?=
FUZZ_SECONDS ?= 60
# Ninja where it is installed; a build folder keeps the generator that it was made with.
GENERATOR = $(if $(wildcard $(BUILD)/CMakeCache.txt),,$(if $(shell command -v ninja 2>/dev/null),-G Ninja))

# -O1: with the checks in, higher levels cost more to build than they save. Lines are enough to read a finding.
SANITIZER_FLAGS = -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=RelWithDebInfo \
  -DCMAKE_CXX_FLAGS_RELWITHDEBINFO='-O1 -gline-tables-only'

SANITIZED ?= contact reference fast bearing workflow io verification
space := $() $()

.DEFAULT_GOAL := help
.PHONY: help setup configure build verify test fuzz sanitize sanitize-threads bench callgrind kernels mutants stress report browser-test atlas format clean

help:       ## List the targets
	@sed -n 's/^\([a-z][a-z-]*\):[^#]*## \(.*\)/  make \1\t\2/p' $(firstword $(MAKEFILE_LIST)) | expand -t 25

setup:      ## Install the apt packages that are missing (as root; otherwise say which)
	@sh cmake/setup.sh

configure: setup
	@mkdir -p $(BUILD)
	@cmake -S . -B $(BUILD) $(GENERATOR) $(CMAKE_FLAGS) > $(BUILD)/configure.log 2>&1 \
	  || { cat $(BUILD)/configure.log >&2; exit 2; }

build: configure  ## Build the program: build/ehd (4 minutes)
	@cmake --build $(BUILD) --parallel $(JOBS) --target ehd_program

verify: build  ## Balance the paper's bearing, run the verification suite; results in out/verify/results.json (5 minutes and the build)
	@$(BUILD)/ehd bearing na4908 na4908-2.5um na4908-10um
	@$(BUILD)/ehd verify --output out/verify

test: configure  ## Build and run every test (8 minutes)
	@cmake --build $(BUILD) --parallel $(JOBS)
	@ctest --test-dir $(BUILD) --output-on-failure --parallel $(JOBS) $(CTEST_FLAGS)

fuzz:       ## Make up case files for the reader until one breaks a promise, by libFuzzer (needs clang; 3 minutes, 1 of it fuzzing)
	@sh cmake/setup.sh clang libclang-rt-dev
	@$(MAKE) --no-print-directory configure BUILD=$(BUILD)-fuzz \
	  CMAKE_FLAGS="-DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=Debug -DEHD_NATIVE=OFF $(CMAKE_FLAGS)"
	@cmake --build $(BUILD)-fuzz --parallel $(JOBS) --target ehd_case_fuzz
	@tests/fuzz/run.sh $(BUILD)-fuzz/ehd_case_fuzz $(FUZZ_SECONDS)

# SANITIZED: folders of tests/. A test that takes minutes here has the label slow-sanitized, with its reason in
# tests/CMakeLists.txt.
sanitize:   ## Tests with AddressSanitizer and UndefinedBehaviorSanitizer by clang (SANITIZED="contact fast": some; 15 minutes)
	@sh cmake/setup.sh clang libclang-rt-dev
	@$(MAKE) --no-print-directory configure BUILD=$(BUILD)-sanitize \
	  CMAKE_FLAGS="$(SANITIZER_FLAGS) -DEHD_SANITIZE=address,undefined $(CMAKE_FLAGS)"
	@cmake --build $(BUILD)-sanitize --parallel $(JOBS) --target $(SANITIZED:%=test_%)
	@ctest --test-dir $(BUILD)-sanitize --output-on-failure --parallel $(JOBS) --label-exclude '^slow-sanitized$$' --no-tests=error \
	  --tests-regex '^($(subst $(space),|,$(strip $(SANITIZED))))\.' $(CTEST_FLAGS)

sanitize-threads:  ## The tests that use threads, and part of the suite, with ThreadSanitizer by clang (8 minutes)
	@sh cmake/setup.sh clang libclang-rt-dev
	@$(MAKE) --no-print-directory configure BUILD=$(BUILD)-threads \
	  CMAKE_FLAGS="$(SANITIZER_FLAGS) -DEHD_SANITIZE=thread $(CMAKE_FLAGS)"
	@cmake --build $(BUILD)-threads --parallel $(JOBS) --target test_workflow test_io test_verification ehd_program
	@ctest --test-dir $(BUILD)-threads --output-on-failure --label-regex '^threads$$' --no-tests=error $(CTEST_FLAGS)
	@$(BUILD)-threads/ehd verify --quick --rung 7

bench: build  ## Run time and work against achieved error, scaling, batches; results in out/bench (10 minutes)
	@$(BUILD)/ehd bench --output out/bench

stress: build  ## Numerical stability: starts, precision, rounding, extremes, random bearings; results in out/stress (half an hour)
	@$(BUILD)/ehd stress --output out/stress

report: build  ## Make out/verify/report.html from what verify, bench and stress left in out/ (2 seconds)
	@mkdir -p out/verify
	@for part in bench stress; do if [ -f out/$$part/$$part.json ]; then cp out/$$part/$$part.json out/verify/; fi; done
	@$(BUILD)/ehd report out/verify

browser-test: configure  ## Look at the report in headless Chromium, where it is installed (15 s)
	@cmake --build $(BUILD) --parallel $(JOBS) --target ehd_program --target made_report
	@ctest --test-dir $(BUILD) --output-on-failure -R report_browser --no-tests=error

# Without this machine's vector instructions, which valgrind may not know; in a folder of its own for that.
callgrind:  ## Count instructions of three solves, name the functions that moved (KEEP=1 keeps the counts; 5 minutes)
	@sh cmake/setup.sh valgrind
	@$(MAKE) --no-print-directory build BUILD=$(BUILD)-callgrind CMAKE_FLAGS="-DEHD_NATIVE=OFF -DBUILD_TESTING=OFF"
	@verification/bench/callgrind/count.sh $(if $(KEEP),--keep) $(BUILD)-callgrind/ehd

kernels: configure  ## Time the kernels of fast/ in multiples of one FFT convolution (needs libbenchmark-dev; 1 minute)
	@cmake --build $(BUILD) --parallel $(JOBS) --target ehd_kernels
	@$(BUILD)/ehd_kernels

# Built in out/mutants, from a copy of the tree: nothing wrong is left behind.
mutants:    ## Build each wrong program of verification/mutants, run the quick suite with it (40 minutes; ONLY=part of an id)
	@sh cmake/setup.sh python3
	@python3 verification/mutants/run.py $(if $(ONLY),--only $(ONLY)) --jobs $(JOBS)

atlas: build  ## Solve the atlas of line contacts into cases/atlas (goes on where an earlier run ended; an hour)
	@$(BUILD)/ehd atlas

format:     ## Format every source file with clang-format
	@command -v clang-format > /dev/null || { echo "clang-format is missing: apt-get install clang-format" >&2; exit 2; }
	@find contact reference fast bearing workflow io verification cli tests -name '*.[ch]pp' -exec clang-format -i {} +

clean:      ## Remove the build folder
	@rm -rf $(BUILD)

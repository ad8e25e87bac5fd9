# SPDX-License-Identifier: GPL-3.0-or-later
# The commands that a user types; CMake does the work. Variables: BUILD (folder), JOBS, CMAKE_FLAGS (passed to CMake),
# CTEST_FLAGS (passed to ctest), PREFIX (of make install), FUZZ_SECONDS (of each target), FILES (for tidy), SINCE (for
# tidy-changed), CHECKS (words in the names of the steps that check-all runs). Times in brackets are of two idle cores,
# rounded; docs/checks.md says where measured ones stand.

BUILD ?= build
JOBS ?= $(shell nproc 2>/dev/null || echo 2)
CMAKE_FLAGS ?=
CTEST_FLAGS ?=
FUZZ_SECONDS ?= 60
PREFIX ?= /usr/local
# Ninja where it is installed; a build folder keeps the generator that it was made with.
GENERATOR = $(if $(wildcard $(BUILD)/CMakeCache.txt),,$(if $(shell command -v ninja 2>/dev/null),-G Ninja))

# -O1: with the checks in, higher levels cost more to build than they save. Lines are enough to read a finding.
SANITIZER_FLAGS = -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=RelWithDebInfo \
  -DCMAKE_CXX_FLAGS_RELWITHDEBINFO='-O1 -gline-tables-only'

FUZZED ?= case sweep row results atlas
SANITIZED ?= contact reference fast bearing workflow io bindings verification
space := $() $()
# What clang-tidy reads, and what clang-format formats.
TIDY_ROOMS = contact reference fast bearing workflow
FORMAT_ROOMS = $(TIDY_ROOMS) io bindings verification cli tests
FORMATTED = find $(FORMAT_ROOMS) -name '*.[ch]pp' -o -name '*.ipp' -o -path bindings/c/ehd/ehd.h

.DEFAULT_GOAL := help
.PHONY: help setup configure program build install deb verify verify-full test sanitizer-build sanitizer-program \
  sanitize sanitize-slow sanitize-threads fuzz faults engines sweep-million check-all bench callgrind in-process \
  kernels mutants stress report browser-test atlas submissions results results-check results-full format format-check \
  tidy tidy-changed clean

help:       ## List the targets
	@sed -n 's/^\([a-z][a-z-]*\):[^#]*## \(.*\)/  make \1\t\2/p' $(firstword $(MAKEFILE_LIST)) | expand -t 25

setup:      ## Install the apt packages that are missing (as root; otherwise say which)
	@sh cmake/setup.sh

configure: setup
	@mkdir -p $(BUILD)
	@cmake -S . -B $(BUILD) $(GENERATOR) $(CMAKE_FLAGS) > $(BUILD)/configure.log 2>&1 \
	  || { cat $(BUILD)/configure.log >&2; exit 2; }

# CMake counts the steps: [done/all] with Ninja, percents with make.
program: configure
	@cmake --build $(BUILD) --parallel $(JOBS) --target ehd_program

build: program  ## Build the program: build/ehd
	@echo "$(BUILD)/ehd is built. Next: make verify (the paper's bearing and the quick suite), or $(BUILD)/ehd --help"

verify: program  ## Balance the paper's bearing, run the quick suite into out/verify
	@$(BUILD)/ehd bearing na4908
	@$(BUILD)/ehd verify --quick --output out/verify
	@echo "Left out: the slow topics of the suite and the paper's statements (make verify-full), the tests (make test)."

verify-full: program  ## The paper's bearing at three clearances, and the whole suite (after the build 6 minutes)
	@$(BUILD)/ehd bearing na4908 na4908-2.5um na4908-10um
	@$(BUILD)/ehd verify --output out/verify

install: program  ## Install program, library and cases under PREFIX (/usr/local)
	@cmake --build $(BUILD) --parallel $(JOBS) --target ehd_shared
	@cmake --install $(BUILD) --prefix $(PREFIX)

# A build folder of its own: packages run on every machine of the architecture.
deb:        ## Make Debian packages in build-deb/deb: ehd, libehd0, libehd-dev, python3-ehd; try them (5 minutes)
	@sh cmake/setup.sh dpkg-dev help2man lintian
	@$(MAKE) --no-print-directory configure BUILD=$(BUILD)-deb \
	  CMAKE_FLAGS="-DEHD_NATIVE=OFF -DBUILD_TESTING=OFF -DCMAKE_INSTALL_PREFIX=/usr $(CMAKE_FLAGS)"
	@cmake --build $(BUILD)-deb --parallel $(JOBS) --target ehd_program --target ehd_shared
	@cd $(BUILD)-deb && cpack > cpack.log 2>&1 || { cat cpack.log >&2; exit 1; }
	@lintian --allow-root --fail-on error $(BUILD)-deb/deb/*.deb
	@cmake/deb/try.sh $(BUILD)-deb/deb
	@ls $(BUILD)-deb/deb/*.deb

test: configure  ## Build and run every test
	@sh cmake/setup.sh gfortran
	@cmake --build $(BUILD) --parallel $(JOBS)
	@ctest --test-dir $(BUILD) --output-on-failure --parallel $(JOBS) $(CTEST_FLAGS)

# One build by clang serves the sanitizers and the fuzz targets.
sanitizer-build:
	@sh cmake/setup.sh clang libclang-rt-dev
	@$(MAKE) --no-print-directory configure BUILD=$(BUILD)-sanitize \
	  CMAKE_FLAGS="$(SANITIZER_FLAGS) -DEHD_SANITIZE=address,undefined $(CMAKE_FLAGS)"

sanitizer-program: sanitizer-build  ## Build the program by clang with the sanitizers (6 minutes)
	@cmake --build $(BUILD)-sanitize --parallel $(JOBS) --target ehd_program

# SANITIZED: folders of tests/. A test that takes minutes here has the label slow-sanitized, with its reason in
# tests/CMakeLists.txt.
sanitize: sanitizer-build  ## Tests with clang's sanitizers of addresses and behaviour (SANITIZED=io: some; 15 minutes)
	@cmake --build $(BUILD)-sanitize --parallel $(JOBS) --target $(SANITIZED:%=test_%)
	@ctest --test-dir $(BUILD)-sanitize --output-on-failure --parallel $(JOBS) --no-tests=error \
	  --label-exclude '^slow-sanitized$$' --tests-regex '^($(subst $(space),|,$(strip $(SANITIZED))))\.' $(CTEST_FLAGS)

sanitize-slow: sanitizer-build  ## The tests that make sanitize leaves out, because they take minutes there (10 minutes)
	@cmake --build $(BUILD)-sanitize --parallel $(JOBS) --target test_reference
	@ctest --test-dir $(BUILD)-sanitize --output-on-failure --no-tests=error --label-regex '^slow-sanitized$$' \
	  $(CTEST_FLAGS)

fuzz: sanitizer-build  ## Feed random bytes to all that is read, by libFuzzer (FUZZED="case row": some; 8 minutes)
	@cmake --build $(BUILD)-sanitize --parallel $(JOBS) --target $(FUZZED:%=ehd_fuzz_%)
	@JOBS=$(JOBS) tests/fuzz/run.sh $(BUILD)-sanitize $(FUZZ_SECONDS) $(FUZZED)

sanitize-threads:  ## The tests that use threads, and part of the suite, with ThreadSanitizer by clang (8 minutes)
	@sh cmake/setup.sh clang libclang-rt-dev
	@$(MAKE) --no-print-directory configure BUILD=$(BUILD)-threads \
	  CMAKE_FLAGS="$(SANITIZER_FLAGS) -DEHD_SANITIZE=thread $(CMAKE_FLAGS)"
	@cmake --build $(BUILD)-threads --parallel $(JOBS) \
	  --target test_workflow test_io test_bindings test_verification ehd_program
	@ctest --test-dir $(BUILD)-threads --output-on-failure --label-regex '^threads$$' --no-tests=error $(CTEST_FLAGS)
	@$(BUILD)-threads/ehd verify --quick --rung 7

faults: program  ## Attack the program with bad input, faults, signals; a table in docs/results/faults.md (2 minutes)
	@sh cmake/setup.sh python3
	@python3 tests/faults/run.py $(BUILD)/ehd --page docs/results/faults.md

engines: program  ## Sweeps under GNU parallel, Open MPI and Slurm: the rows of one process, bit for bit (2 minutes)
	@sh cmake/setup.sh python3 parallel openmpi-bin slurm-wlm munge
	@python3 tests/engines/run.py $(BUILD)/ehd

sweep-million: program  ## A sweep of a million rows into docs/results/sweep-million.md (half an hour, 11 GB)
	@sh cmake/setup.sh python3
	@python3 verification/bench/sweeps/million.py $(BUILD)/ehd --page docs/results/sweep-million.md

check-all:  ## Every check of .ci/steps.toml, red where one is left out; times in docs/results/checks.md (hours)
	@sh cmake/setup.sh python3
	@python3 .ci/steps.py all --page docs/results/checks.md $(foreach part,$(CHECKS),--only '$(part)')

bench: program  ## Run time and work against achieved error, scaling, batches; results in out/bench (10 to 15 minutes)
	@$(BUILD)/ehd bench --output out/bench

stress: program  ## Stability: starts, precision, rounding, extremes, random bearings; in out/stress (half an hour)
	@$(BUILD)/ehd stress --output out/stress

report: program  ## Make out/verify/report.html from what verify, bench and stress left in out/ (2 seconds)
	@mkdir -p out/verify
	@for part in bench stress; do if [ -f out/$$part/$$part.json ]; then cp out/$$part/$$part.json out/verify/; fi; done
	@$(BUILD)/ehd report out/verify

browser-test: configure  ## Open the report in headless Chromium, with axe-core of npm, where they are there (20 s)
	@cmake --build $(BUILD) --parallel $(JOBS) --target ehd_program --target made_report
	@tests/verification/report/axe_test.sh $(BUILD)/ehd $(BUILD)/made_report $(BUILD)/axe || [ $$? -eq 77 ]

.PHONY: library abi python octave site dist dist-check
PYTHON_PACKAGES = python3-numpy python3-pytest python3-matplotlib python3-distributed python3-mypy python3-nbconvert \
  python3-ipykernel python3-pandas
library: configure  ## Build the library that Python and C load: build/libehd.so.0
	@cmake --build $(BUILD) --parallel $(JOBS) --target ehd_shared

python: program library  ## Test the Python package, its figures, Dask, notebooks, types: nothing skipped (2 minutes)
	@sh cmake/setup.sh $(PYTHON_PACKAGES)
	@EHD_PYTHON_COMPLETE=1 ctest --test-dir $(BUILD) --output-on-failure -R '^bindings\.python$$' --no-tests=error

octave: program  ## Test all that needs Octave: functions, page, template, exported law (installs 219 MB; 30 s)
	@sh cmake/setup.sh octave gfortran python3-numpy
	@tests/bindings/octave/run.sh $(BUILD)/ehd
	@EHD_REQUIRE_OCTAVE=1 python3 tests/cli/templates.py $(BUILD)/ehd
	@cmake --build $(BUILD) --parallel $(JOBS) --target test_io
	@EHD_REQUIRE_OCTAVE=1 $(BUILD)/test_io --run_test=law_export_text/the_matlab_form_agrees_in_octave

# valgrind may not know this machine's vector instructions: built without them, in a folder of its own.
callgrind:  ## Count instructions of three solves, name the functions that changed (KEEP=1 keeps the counts; 5 minutes)
	@sh cmake/setup.sh valgrind
	@$(MAKE) --no-print-directory program BUILD=$(BUILD)-callgrind CMAKE_FLAGS="-DEHD_NATIVE=OFF -DBUILD_TESTING=OFF"
	@verification/bench/callgrind/count.sh $(if $(KEEP),--keep) $(BUILD)-callgrind/ehd

abi: configure  ## Compare the library's interface with the one that is kept, by libabigail (KEEP=1 keeps it; 30 s)
	@sh cmake/setup.sh abigail-tools
	@cmake --build $(BUILD) --parallel $(JOBS) --target ehd_abi
	@tests/bindings/abidiff.sh $(if $(KEEP),--keep) $(BUILD)/abi/libehd.so.0 bindings/c/ehd/ehd.h

in-process:  ## Count what a call of libehd costs above the solve in it, as instructions; fails from 5 % on (5 minutes)
	@sh cmake/setup.sh valgrind
	@$(MAKE) --no-print-directory library BUILD=$(BUILD)-callgrind CMAKE_FLAGS="-DEHD_NATIVE=OFF -DBUILD_TESTING=OFF"
	@python3 verification/bench/callgrind/in_process.py $(BUILD)-callgrind

kernels: configure  ## Time the kernels of fast/ in multiples of one FFT convolution (needs libbenchmark-dev; 1 minute)
	@cmake --build $(BUILD) --parallel $(JOBS) --target ehd_kernels
	@$(BUILD)/ehd_kernels

# Built in out/mutants, from a copy of the tree: the tree itself is never changed.
mutants:    ## Run each wrong program of verification/mutants (an hour; ONLY=part of an id; PART=3/10: a tenth)
	@sh cmake/setup.sh python3
	@python3 verification/mutants/run.py $(if $(ONLY),--only $(ONLY)) $(if $(PART),--part $(PART)) --jobs $(JOBS)

submissions: program  ## Remake cases/submissions: this project's solvers and the templates, for ehd judge (2 minutes)
	@sh cmake/setup.sh python3-numpy gfortran octave
	@/usr/bin/python3 cases/submissions/make.py $(BUILD)/ehd

atlas: program  ## Solve the atlas of line contacts into cases/atlas (goes on where an earlier run ended; an hour)
	@$(BUILD)/ehd atlas
	@$(BUILD)/ehd atlas --motion

results: program  ## Remake docs/results, docs/figures and what the pages show of the program (1 minute)
	@sh cmake/setup.sh python3 python3-numpy python3-matplotlib
	@python3 docs/results/make.py $(BUILD)/ehd

results-check: program  ## Fail where one of those, or of cases/submissions, is not as the program finds it (2 minutes)
	@sh cmake/setup.sh python3 python3-numpy python3-matplotlib
	@python3 docs/results/make.py --check $(BUILD)/ehd
	@/usr/bin/python3 cases/submissions/make.py --check $(BUILD)/ehd

start-minutes:  ## Clone, build and compute as docs/start.md says, with minutes: docs/results/start.md (git; 7 minutes)
	@python3 tests/docs/minutes.py docs/results/start.md

results-full: program  ## Make the slow pages of docs/results: ladder, stress, bench (15 minutes; nobody compares them)
	@sh cmake/setup.sh python3
	@python3 docs/results/make.py --full $(BUILD)/ehd

site:       ## Make the site of the pages and of the report, build/site/html/index.html (mkdocs; 5 s)
	@sh cmake/setup.sh python3 mkdocs mkdocs-material libjs-katex
	@python3 docs/site/make.py $(BUILD)/site

VERSION = $(shell sed -n 's/^project.ehd VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
dist:       ## Make out/dist/ehd-VERSION.tar.gz of the last commit (a second)
	@mkdir -p out/dist
	@git archive --prefix=ehd-$(VERSION)/ --format=tar.gz --output=out/dist/ehd-$(VERSION).tar.gz HEAD
	@echo out/dist/ehd-$(VERSION).tar.gz

dist-check: dist  ## Unpack that tarball, without a network build and test it, remake its pages and compare (15 minutes)
	@sh cmake/setup.sh gfortran iproute2
	@cd out/dist && rm -rf ehd-$(VERSION) && tar xzf ehd-$(VERSION).tar.gz && cd ehd-$(VERSION) && \
	offline=; if unshare --net true 2> /dev/null; then offline="unshare --net"; loopback="ip link set lo up"; \
	else echo "the network stays: unshare needs root"; loopback=true; fi && \
	$$offline sh -c "$$loopback && $(MAKE) --no-print-directory test results-check JOBS=$(JOBS)"

format:     ## Format every source file with clang-format 14
	@sh cmake/setup.sh clang-format
	@$(FORMATTED) | xargs clang-format -i

format-check:  ## Name the source files that clang-format 14 would change; fails if there are any (2 s)
	@sh cmake/setup.sh clang-format
	@$(FORMATTED) | xargs -P $(JOBS) -n 50 clang-format --dry-run --Werror --ferror-limit=1 \
	  || { echo "not formatted (make format does it): the files above"; exit 1; }

# Without precompiled headers, because clang-tidy cannot read those of gcc; file by file, because it looks each file up
# in compile_commands.json. Findings go to standard output; standard error only
# counts the warnings in system headers.
tidy:       ## Check the rooms that compute with clang-tidy (FILES="contact/text.cpp": some; 10 minutes)
	@sh cmake/setup.sh clang clang-tidy
	@$(MAKE) --no-print-directory configure BUILD=$(BUILD)-tidy \
	  CMAKE_FLAGS="-DCMAKE_CXX_COMPILER=clang++ -DEHD_PRECOMPILE=OFF -DEHD_UNITY=OFF -DBUILD_TESTING=OFF $(CMAKE_FLAGS)"
	@printf '%s\n' $(if $(FILES),$(FILES),$(foreach room,$(TIDY_ROOMS),$(wildcard $(room)/*.cpp $(room)/*/*.cpp))) \
	  | xargs -P $(JOBS) -n 1 clang-tidy --quiet --warnings-as-errors='*' -p $(BUILD)-tidy 2> /dev/null

# The commits since SINCE count: what origin/main does not have, or, where it has all or is not known, ten commits. Of a
# changed header the sources that include it themselves are read.
SINCE ?= $(shell base=$$(git merge-base HEAD origin/main 2> /dev/null); head=$$(git rev-parse HEAD); \
  if [ -n "$$base" ] && [ "$$base" != "$$head" ]; then echo "$$base"; else git rev-parse --quiet --verify HEAD~10; fi)
tidy-changed:  ## make tidy on what the last commits changed (SINCE=commit: since then; nothing: says so)
	@since=$(SINCE); [ -n "$$since" ] || { echo "no commit to compare with: every source"; \
	  exec $(MAKE) --no-print-directory tidy; }; \
	changed=$$(git diff --name-only --diff-filter=d "$$since" -- $(TIDY_ROOMS) | grep '\.[chi]pp$$'); \
	sources=$$(for file in $$changed; do case $$file in \
	  *.cpp) echo "$$file" ;; \
	  *) grep -rlF --include='*.cpp' "#include \"$$file\"" $(TIDY_ROOMS) ;; \
	esac; done | sort -u | tr '\n' ' '); \
	if [ -z "$$sources" ]; then echo "no source of $(TIDY_ROOMS) has changed since $$since"; \
	else echo "changed since $$since: $$sources"; $(MAKE) --no-print-directory tidy FILES="$$sources"; fi

clean:      ## Remove the build folder
	@rm -rf $(BUILD)

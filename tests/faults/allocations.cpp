// SPDX-License-Identifier: GPL-3.0-or-later
// For LD_PRELOAD: allocation number EHD_FAILS of the program finds no memory; the static objects before main do not
// count. At the end, the number of all allocations goes into the file EHD_ALLOCATIONS.
#include <dlfcn.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <new>

namespace {

using Main = int (*)(int, char**, char**);
using Start = int (*)(Main, int, char**, void (*)(), void (*)(), void (*)(), void*);

std::atomic<long> allocations = 0;
bool counts = false;
Main program = nullptr;

int counted_main(int argc, char** argv, char** environment) {
  counts = true;
  return program(argc, argv, environment);
}

/// 0: none.
long failing() {
  static const char* const text = std::getenv("EHD_FAILS");
  return text ? std::atol(text) : 0;
}

[[gnu::destructor]] void tell() {
  const char* const name = std::getenv("EHD_ALLOCATIONS");
  std::FILE* const file = name ? std::fopen(name, "w") : nullptr;
  if (!file) return;
  std::fprintf(file, "%ld\n", allocations.load());
  std::fclose(file);
}

}  // namespace

extern "C" int __libc_start_main(Main main, int argc, char** argv, void (*begin)(), void (*end)(), void (*loaded)(),
                                 void* stack) {
  program = main;
  const auto start = reinterpret_cast<Start>(dlsym(RTLD_NEXT, "__libc_start_main"));
  return start(counted_main, argc, argv, begin, end, loaded, stack);
}

void* operator new(std::size_t bytes) {
  if (counts && ++allocations == failing()) throw std::bad_alloc();
  void* const memory = std::malloc(bytes > 0 ? bytes : 1);
  if (!memory) throw std::bad_alloc();
  return memory;
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t /*bytes*/) noexcept { std::free(memory); }

// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/temporary_files.hpp"

#include <unistd.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstring>
#include <utility>

namespace ehd {

namespace {

constexpr std::size_t most_notes = 64, longest_name = 4096;

enum State : int { empty, being_written, noted };
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler may not wait for a lock");

struct Note {
  std::atomic<int> state = empty;
  char name[longest_name];
};

std::array<Note, most_notes> notes;
std::atomic<bool> process_ends = false;

}  // namespace

TemporaryNote::TemporaryNote(const std::string& name) {
  if (name.size() >= longest_name) return;
  for (std::size_t i = 0; i < notes.size(); ++i) {
    int expected = empty;
    if (!notes[i].state.compare_exchange_strong(expected, being_written)) continue;
    // Two orders are possible. The handler comes later: it sees `being_written` and does not read the name. The handler
    // came first: this thread waits for the end of the process.
    while (process_ends) ::pause();
    std::memcpy(notes[i].name, name.c_str(), name.size() + 1);
    notes[i].state = noted;
    place_ = static_cast<int>(i);
    return;
  }
}

TemporaryNote::TemporaryNote(TemporaryNote&& other) noexcept : place_(std::exchange(other.place_, -1)) {}

TemporaryNote& TemporaryNote::operator=(TemporaryNote&& other) noexcept {
  forget();
  place_ = std::exchange(other.place_, -1);
  return *this;
}

void TemporaryNote::forget() {
  if (place_ >= 0) notes[static_cast<std::size_t>(place_)].state = empty;
  place_ = -1;
}

void remove_temporary_files() noexcept {
  process_ends = true;
  for (const Note& note : notes)
    if (note.state == noted) ::unlink(note.name);
  // A folder goes when its files have gone. rmdir leaves a file as it is.
  for (const Note& note : notes)
    if (note.state == noted) ::rmdir(note.name);
}

}  // namespace ehd

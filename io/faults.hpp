// SPDX-License-Identifier: GPL-3.0-or-later
// Several faults of one input, named at once.
#pragma once

#include <string>
#include <vector>

#include "workflow/case.hpp"

namespace ehd {

class Faults {
 public:
  /// Reads a part of the input, and keeps its refusal for later. True where there is none.
  template <class Read>
  bool none_in(const Read& read) {
    try {
      read();
    } catch (const CaseError& error) {
      add(error);
      return false;
    }
    return true;
  }
  void add(const CaseError& error) {
    lines_.emplace_back(error.what());
    lines_.insert(lines_.end(), error.more().begin(), error.more().end());
  }
  void add(std::string line) { lines_.push_back(std::move(line)); }
  [[nodiscard]] std::size_t size() const { return lines_.size(); }
  /// Throws one CaseError with a line for each fault; nothing where there is none.
  void refuse() const {
    if (!lines_.empty()) throw CaseError(lines_);
  }

 private:
  std::vector<std::string> lines_;
};

}  // namespace ehd

// SPDX-License-Identifier: GPL-3.0-or-later
// The file that `--plot` names: SVG, or PNG by the end of its name.
#pragma once

#include <optional>
#include <string>

#include "io/output_file.hpp"

namespace ehd::cli {

/// A picture that appears whole or not at all, like every output. A name that ends in .png has PNG, which the program
/// rsvg-convert makes of the SVG (Debian's package librsvg2-bin); one that ends in .svg or has no ending has SVG.
/// Without the option there is no file.
class PictureFile {
 public:
  /// Call before any work. Throws UsageError for another ending, and where PNG is asked for and the program is missing;
  /// OutputError where the file cannot be written.
  explicit PictureFile(const std::optional<std::string>& option);
  explicit operator bool() const { return file_.has_value(); }
  /// Throws OutputError where the SVG does not become PNG.
  void write(const std::string& svg);
  /// For commit_together(); null without the option.
  [[nodiscard]] OutputFile* file() { return file_ ? &*file_ : nullptr; }

 private:
  std::string name_;
  bool png_ = false;
  std::optional<OutputFile> file_;
};

}  // namespace ehd::cli

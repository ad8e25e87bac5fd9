// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/picture_file.hpp"

#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "cli/output.hpp"
#include "cli/usage.hpp"
#include "verification/judge/command.hpp"

namespace ehd::cli {

namespace {

constexpr const char* converter = "rsvg-convert";
constexpr double converter_limit_s = 60;  ///< the largest picture, 60 bearings, takes 1 s
constexpr int pixels_per_unit = 2;        ///< figures are 560 to 1250 units wide; at 1 their letters are coarse

/// A file in memory, which another program opens under path().
class MemoryFile {
 public:
  MemoryFile() : descriptor_(::memfd_create("picture", MFD_CLOEXEC)) {
    if (descriptor_ < 0) throw failed("no file in memory");
  }
  ~MemoryFile() { ::close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  [[nodiscard]] std::string path() const { return fmt::format("/proc/{}/fd/{}", ::getpid(), descriptor_); }
  void write(const std::string& text) const {
    for (std::size_t done = 0; done < text.size();) {
      const auto count = ::write(descriptor_, text.data() + done, text.size() - done);
      if (count >= 0) done += static_cast<std::size_t>(count);
      if (count < 0 && errno != EINTR) throw failed("a file in memory cannot be written");
    }
  }
  /// What another program wrote.
  [[nodiscard]] std::string content() const {
    std::string text;
    for (char buffer[1 << 16];;) {
      const auto count = ::pread(descriptor_, buffer, sizeof buffer, static_cast<off_t>(text.size()));
      if (count > 0) text.append(buffer, static_cast<std::size_t>(count));
      if (count == 0) return text;
      if (count < 0 && errno != EINTR) throw failed("a file in memory cannot be read");
    }
  }

 private:
  static OutputError failed(const char* what) {
    return OutputError(
        fmt::format("--plot: {} ({}); allowed without it is a name that ends in .svg", what, std::strerror(errno)));
  }
  int descriptor_;
};

void require_converter(const std::string& name) {
  const auto ended = judging::run_command(std::string(converter) + " --version", converter_limit_s);
  if (!ended.exit_code)
    throw option_error("--plot", name,
                       fmt::format("{} {}; allowed without it is a name that ends in .svg", converter, ended.words));
  if (ended.exit_code != 0)
    throw option_error("--plot", name,
                       std::string("PNG needs the program ") + converter +
                           " (apt-get install librsvg2-bin); allowed without it is a name that ends in .svg");
}

std::string png_of(const std::string& svg, const std::string& name) {
  const MemoryFile from, to;
  from.write(svg);
  const auto ended = judging::run_command(
      fmt::format("{} --format=png --zoom={} < {} > {}", converter, pixels_per_unit, from.path(), to.path()),
      converter_limit_s);
  if (ended.exit_code != 0)
    throw OutputError(fmt::format("{}: {}: {}{}", name, converter, ended.words,
                                  ended.last_line.empty() ? "" : ": " + ended.last_line));
  return to.content();
}

}  // namespace

PictureFile::PictureFile(const std::optional<std::string>& option) : name_(option.value_or("")) {
  const std::string ending = ending_of(name_);
  png_ = ending == ".png";
  if (!png_ && !ending.empty() && ending != ".svg")
    throw option_error("--plot", name_, "ends in " + ending + "; allowed is .svg or .png");
  if (png_) require_converter(name_);
  if (option) file_.emplace(*option);
}

void PictureFile::write(const std::string& svg) {
  if (file_) file_->append(png_ ? png_of(svg, name_) : svg);
}

}  // namespace ehd::cli

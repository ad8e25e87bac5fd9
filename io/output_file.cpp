// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/output_file.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include "contact/text.hpp"

namespace ehd {

namespace {

[[noreturn]] void cannot_write(const std::filesystem::path& path, const std::string& why) {
  throw OutputError(one_line(path.string() + ": cannot be written (" + why + "); allowed is a file in a folder that " +
                             "exists and may be written"));
}

}  // namespace

OutputFile::OutputFile(std::filesystem::path path) : path_(std::move(path)) {
  std::error_code error;
  const auto status = std::filesystem::status(path_, error);
  if (path_.empty()) cannot_write(path_, "the name is empty");
  if (std::filesystem::is_directory(status)) cannot_write(path_, "it is a directory");
  if (status.type() == std::filesystem::file_type::none) cannot_write(path_, error.message());  // a loop of links
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    if (!std::ofstream(path_)) cannot_write(path_, std::strerror(errno));
    return;
  }
  if (std::filesystem::exists(status)) {
    if (::access(path_.c_str(), W_OK) != 0) cannot_write(path_, std::strerror(errno));
    path_ = std::filesystem::canonical(path_, error);  // through a link, so that the link stays one
  }
  const auto temporary = path_.string() + ".partial-" + std::to_string(::getpid());
  if (!std::ofstream(temporary)) cannot_write(path_, std::strerror(errno));
  temporary_ = temporary;
}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : path_(std::move(other.path_)), temporary_(std::move(other.temporary_)) {
  other.temporary_.clear();
}

OutputFile::~OutputFile() {
  std::error_code ignored;
  if (!temporary_.empty()) std::filesystem::remove(temporary_, ignored);
}

void OutputFile::commit(const std::string& text) {
  std::ofstream stream(temporary_.empty() ? path_ : temporary_, std::ios::binary | std::ios::trunc);
  stream << text;
  stream.close();
  if (!stream) cannot_write(path_, "the device is full or failed");
  commit();
}

void OutputFile::append(const std::string& text) {
  std::ofstream stream(temporary_.empty() ? path_ : temporary_, std::ios::binary | std::ios::app);
  stream << text;
  stream.close();
  if (!stream) cannot_write(path_, "the device is full or failed");
}

void OutputFile::commit() {
  if (temporary_.empty()) return;
  std::error_code error;
  std::filesystem::rename(temporary_, path_, error);
  if (error) cannot_write(path_, error.message());
  temporary_.clear();
}

}  // namespace ehd

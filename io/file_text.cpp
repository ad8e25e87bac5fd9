// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/file_text.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include "contact/text.hpp"
#include "workflow/case.hpp"

namespace ehd {

namespace {

constexpr std::uintmax_t KiB = 1024, MiB = 1024 * KiB;

std::string size_text(std::uintmax_t bytes) {
  return bytes >= MiB ? fmt::format("{} MiB", bytes / MiB) : fmt::format("{} KiB", bytes / KiB);
}

}  // namespace

std::string fault_of_file(const std::filesystem::path& file) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (status.type() == std::filesystem::file_type::not_found)
    return file == "-" ? "standard input is not read here" : "there is no such file";
  if (status.type() == std::filesystem::file_type::none) return "cannot be read (" + error.message() + ")";
  if (std::filesystem::is_directory(status)) return "is a directory";
  if (!std::filesystem::is_regular_file(status)) return "is not a regular file";
  if (::access(file.c_str(), R_OK) != 0) return std::string("cannot be read (") + std::strerror(errno) + ")";
  return "";
}

std::string text_of_file(const std::filesystem::path& file, const FileKind& kind) {
  const auto refuse = [&](const std::string& fault) {
    return CaseError(one_line(fmt::format("{}: {}; allowed is {}", file.string(), fault, kind.name)));
  };
  if (const std::string fault = fault_of_file(file); !fault.empty()) throw refuse(fault);
  std::error_code error;
  const std::uintmax_t stated = std::filesystem::file_size(file, error);
  // A file may grow while it is read: so many bytes are read, and no more.
  std::string bytes(std::min(error ? 0 : stated, kind.most_bytes) + 1, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!stream.is_open() || stream.bad() || error) throw refuse("cannot be read");
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  if (std::max<std::uintmax_t>(stated, bytes.size()) > kind.most_bytes)
    throw refuse("is larger than " + size_text(kind.most_bytes));
  return bytes;
}

std::optional<std::string> text_if_there(const std::filesystem::path& file, const FileKind& kind) {
  std::error_code error;
  if (std::filesystem::status(file, error).type() == std::filesystem::file_type::not_found) return std::nullopt;
  return text_of_file(file, kind);
}

}  // namespace ehd

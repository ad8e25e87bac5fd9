// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/output_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <random>
#include <system_error>
#include <utility>

#include "contact/text.hpp"

namespace ehd {

namespace {

// A temporary file is called NAME.partial-DIGITS. NAME is cut where the whole would be too long for a folder.
constexpr std::string_view temporary_mark = ".partial-";
constexpr std::size_t temporary_digits = 16;
constexpr mode_t mode_bits = 07777;

[[noreturn]] void cannot_write(const std::filesystem::path& path, const std::string& why) {
  throw OutputError(
      one_line(fmt::format("{}: cannot be written ({}); allowed is a file in a folder that exists and may be written",
                           path.empty() ? "\"\"" : path.string(), why)));
}

std::string temporary_prefix(const std::filesystem::path& path) {
  const std::string name = path.filename().string();
  return name.substr(0, NAME_MAX - temporary_mark.size() - temporary_digits) + std::string(temporary_mark);
}

std::filesystem::path folder_of(const std::filesystem::path& path) {
  return path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
}

/// The path that a chain of links leads to. The chain must not be a loop.
std::filesystem::path behind_links(std::filesystem::path path) {
  std::error_code error;
  while (std::filesystem::is_symlink(std::filesystem::symlink_status(path, error))) {
    const auto target = std::filesystem::read_symlink(path, error);
    if (error) break;
    path = folder_of(path) / target;  // an absolute target stands for the whole
  }
  return path;
}

/// Digits that nobody can foresee.
std::string random_digits() {
  std::random_device device;
  const std::uint64_t number = (std::uint64_t{device()} << 32U) | device();
  return fmt::format("{:016x}", number);
}

bool is_temporary_of(const std::string& prefix, const std::string& name) {
  return name.size() == prefix.size() + temporary_digits && name.starts_with(prefix) &&
         name.find_first_not_of("0123456789abcdef", prefix.size()) == std::string::npos;
}

/// Removes the temporary files of killed runs. A run that lives holds a lock on its own.
void remove_leftovers(const std::filesystem::path& path) {
  const std::string prefix = temporary_prefix(path);
  std::error_code error;
  std::filesystem::directory_iterator entry(folder_of(path), error);
  for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
    if (!is_temporary_of(prefix, entry->path().filename().string())) continue;
    const int file = ::open(entry->path().c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (file < 0) continue;
    struct stat status {};
    if (::fstat(file, &status) == 0 && S_ISREG(status.st_mode) && ::flock(file, LOCK_EX | LOCK_NB) == 0)
      ::unlink(entry->path().c_str());
    ::close(file);
  }
}

/// The error of fsync; 0 also where the file system cannot fsync.
int synced(int descriptor) {
  if (::fsync(descriptor) == 0 || errno == EINVAL || errno == EROFS || errno == ENOTSUP) return 0;
  return errno;
}

/// A new name of a file is on the disk only after fsync of its folder.
void sync_folder_of(const std::filesystem::path& path) {
  const int folder = ::open(folder_of(path).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder < 0) return;  // a folder that may be written but not read
  const int error = synced(folder);
  ::close(folder);
  if (error != 0) cannot_write(path, std::strerror(error));
}

/// Each file gets the other's name; false where the file system cannot.
bool exchange_names(const std::filesystem::path& one, const std::filesystem::path& other) {
  return ::renameat2(AT_FDCWD, one.c_str(), AT_FDCWD, other.c_str(), RENAME_EXCHANGE) == 0;
}

/// While this lives, no signal interrupts this thread.
class SignalsHeld {
 public:
  SignalsHeld() {
    sigset_t all;
    ::sigfillset(&all);
    ::pthread_sigmask(SIG_SETMASK, &all, &before_);
  }
  ~SignalsHeld() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  SignalsHeld(const SignalsHeld&) = delete;
  SignalsHeld& operator=(const SignalsHeld&) = delete;

 private:
  sigset_t before_{};
};

/// Why no folder can be where something is already; empty where a folder or nothing is there.
std::string fault_of_folder(const std::filesystem::path& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (std::filesystem::exists(status)) return std::filesystem::is_directory(status) ? "" : "is no folder";
  std::error_code none;
  if (!std::filesystem::is_symlink(std::filesystem::symlink_status(path, none))) return "";
  const std::string target = std::filesystem::read_symlink(path, none).string();
  const bool absent = status.type() == std::filesystem::file_type::not_found;
  return fmt::format("is a link to {}, which {}", target,
                     absent ? "does not exist" : fmt::format("cannot be followed ({})", error.message()));
}

}  // namespace

OutputFile::OutputFile(std::filesystem::path path, Replaces replaces) : path_(std::move(path)) {
  std::error_code error;
  const auto status = std::filesystem::status(path_, error);
  if (path_.empty()) cannot_write(path_, "the name is empty");
  if (std::filesystem::is_directory(status)) cannot_write(path_, "it is a directory");
  if (status.type() == std::filesystem::file_type::none) cannot_write(path_, error.message());  // a loop of links
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    if (replaces == Replaces::file) cannot_write(path_, "it is a pipe or a device");
    descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor_ < 0) cannot_write(path_, std::strerror(errno));
    return;
  }
  if (std::filesystem::exists(status)) {
    if (::access(path_.c_str(), W_OK) != 0) cannot_write(path_, std::strerror(errno));
    path_ = std::filesystem::canonical(path_, error);  // through a link, so that the link stays one
  } else {
    path_ = behind_links(path_);  // to a file that is not there yet
  }
  remove_leftovers(path_);
  open_temporary();
}

void OutputFile::open_temporary() {
  struct stat old {};
  const bool replaces = ::stat(path_.c_str(), &old) == 0;
  constexpr mode_t usual = 0666, private_mode = 0600;
  for (;;) {
    temporary_ = folder_of(path_) / (temporary_prefix(path_) + random_digits());
    note_ = TemporaryNote(temporary_.string());
    descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC,
                         replaces ? private_mode : usual);
    if (descriptor_ < 0) {
      const int why = errno;
      note_ = {};
      temporary_.clear();
      if (why == EEXIST) continue;
      cannot_write(path_, std::strerror(why));
    }
    // Another run may have taken the new file for a leftover before it was locked. That run holds the lock while it
    // removes the file, so this waits.
    while (::flock(descriptor_, LOCK_EX) != 0 && errno == EINTR) continue;
    struct stat mine {};
    if (::fstat(descriptor_, &mine) == 0 && mine.st_nlink > 0) break;
    ::close(descriptor_);
  }
  if (replaces && ::fchmod(descriptor_, old.st_mode & mode_bits) != 0) {
    const int why = errno;
    ::close(descriptor_);
    ::unlink(temporary_.c_str());
    cannot_write(path_, std::strerror(why));
  }
}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : path_(std::move(other.path_)),
      temporary_(std::move(other.temporary_)),
      appeared_(other.appeared_),
      note_(std::move(other.note_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      written_(other.written_) {
  other.temporary_.clear();
}

OutputFile::~OutputFile() {
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
  if (descriptor_ >= 0) ::close(descriptor_);
}

void OutputFile::append(const std::string& text) {
  written_ = true;
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t put = ::write(descriptor_, text.data() + done, text.size() - done);
    if (put < 0 && errno == EINTR) continue;
    if (put < 0) cannot_write(path_, std::strerror(errno));
    done += static_cast<std::size_t>(put);
  }
}

void OutputFile::settle() {
  if (temporary_.empty()) return;
  if (const int error = synced(descriptor_); error != 0) cannot_write(path_, std::strerror(error));
}

void OutputFile::appear() {
  if (temporary_.empty()) return;
  struct stat old {};
  const bool replaces = ::lstat(path_.c_str(), &old) == 0 && S_ISREG(old.st_mode);
  if (replaces && exchange_names(temporary_, path_)) {
    appeared_ = Appeared::exchanged;
  } else {
    std::error_code error;
    std::filesystem::rename(temporary_, path_, error);
    if (error) cannot_write(path_, error.message());
    appeared_ = replaces ? Appeared::replaced : Appeared::as_new;
  }
  sync_folder_of(path_);
}

void OutputFile::withdraw() noexcept {
  if (appeared_ == Appeared::exchanged) exchange_names(temporary_, path_);
  if (appeared_ == Appeared::as_new) ::rename(path_.c_str(), temporary_.c_str());
  appeared_ = Appeared::not_yet;
}

void OutputFile::finish() noexcept {
  if (temporary_.empty()) return;
  if (appeared_ == Appeared::exchanged) ::unlink(temporary_.c_str());
  temporary_.clear();
  note_ = {};
}

void OutputFile::commit() {
  settle();
  appear();
  finish();
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!error) return;
  std::filesystem::path above;
  for (const auto& name : folder) {
    above /= name;
    if (const std::string fault = fault_of_folder(above); !fault.empty())
      throw OutputError(
          one_line(fmt::format("{}: {}, and a folder is needed there; allowed is to move or remove it, "
                               "or another --output",
                               above.string(), fault)));
  }
  throw OutputError(one_line(fmt::format("{}: cannot be made ({}); allowed is a folder that exists or can be made",
                                         folder.string(), error.message())));
}

void write_new_file(const std::filesystem::path& path, const std::string& text) {
  constexpr mode_t readable_by_all = 0644;
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, readable_by_all);
  if (descriptor < 0 && errno == EEXIST)
    throw OutputError(one_line(path.string() + ": exists, and is never overwritten; allowed is a new file"));
  if (descriptor < 0) cannot_write(path, std::strerror(errno));
  const auto written = ::write(descriptor, text.data(), text.size());
  const int error = written == static_cast<ssize_t>(text.size()) ? synced(descriptor) : written < 0 ? errno : ENOSPC;
  ::close(descriptor);
  if (error == 0) return;
  ::unlink(path.c_str());
  cannot_write(path, std::strerror(error));
}

void commit_together(const std::vector<OutputFile*>& files) {
  std::vector<OutputFile*> written;
  std::copy_if(files.begin(), files.end(), std::back_inserter(written),
               [](const OutputFile* file) { return file && file->written_; });
  for (OutputFile* file : written) file->settle();
  const SignalsHeld held;
  try {
    for (OutputFile* file : written) file->appear();
  } catch (...) {
    for (OutputFile* file : written) file->withdraw();
    throw;
  }
  for (OutputFile* file : written) file->finish();
}

}  // namespace ehd

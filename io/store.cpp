// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/store.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "contact/text.hpp"
#include "io/content_hash.hpp"
#include "io/file_text.hpp"
#include "io/json.hpp"
#include "io/output_file.hpp"

namespace ehd {

namespace {

constexpr const char* journal_name = "journal";
constexpr const char* journal_schema = "ehd-journal-3";
constexpr std::size_t check_digits = 16, hash_digits = content_hash_digits;
/// Between two calls of fdatasync, so that a million quick rows do not wait for the disk a million times.
constexpr std::chrono::milliseconds sync_pause{200};
constexpr std::size_t before_text = check_digits + 1 + hash_digits + 1;

/// A line of the file: CHECKSUM CONTENT. The content of a row is HASH TEXT. CHECKSUM: the first digits of the content's
/// hash.
std::string journal_line(const std::string& content) {
  return fmt::format("{} {}\n", content_hash(content).substr(0, check_digits), content);
}

/// The next line, as std::getline. A line longer than any row ends the reading, as if the file ended within it: the
/// file is no journal, and may be larger than the memory.
bool read_line(std::istream& stream, std::string& line) {
  constexpr std::size_t longest_line = 1 << 26;
  line.clear();
  if (stream.eof()) return false;
  constexpr int end = std::char_traits<char>::eof();
  for (int c = stream.rdbuf()->sbumpc(); c != end && line.size() < longest_line; c = stream.rdbuf()->sbumpc()) {
    if (c == '\n') return true;
    line += static_cast<char>(c);
  }
  stream.setstate(std::ios::eofbit);
  return !line.empty();
}

std::string content_of(const JournalHeader& header) {
  return Json{{"schema", journal_schema}, {"owner", header.owner}, {"shard", header.shard}, {"of", header.of}}.dump();
}

std::vector<HashNumber> in_order(std::vector<HashNumber> hashes) {
  std::sort(hashes.begin(), hashes.end());
  hashes.erase(std::unique(hashes.begin(), hashes.end()), hashes.end());
  return hashes;
}

/// Each line of a journal begins with its hash, 16 hexadecimal digits. The first line may be torn.
bool begins_as_journal(const std::filesystem::path& file) {
  constexpr std::size_t digits = 16;
  std::string begin(digits, '0');
  std::ifstream(file, std::ios::binary).read(begin.data(), digits);
  return begin.find_first_not_of("0123456789abcdef") == std::string::npos;
}

[[noreturn]] void refuse(const std::filesystem::path& where, const std::string& what) {
  throw OutputError(one_line(where.string() + ": " + what));
}

}  // namespace

Journal::Journal(const std::filesystem::path& folder, const JournalHeader& header, std::vector<HashNumber> wanted,
                 bool fresh)
    : folder_(folder), file_(folder / journal_name), wanted_(in_order(std::move(wanted))) {
  make_folder(folder_);
  lock_ = ::open(folder_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (lock_ < 0) refuse(folder_, fmt::format("cannot be opened ({}); allowed is a folder", std::strerror(errno)));
  if (::flock(lock_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    ::close(lock_);
    refuse(folder_, "another run is at work there; allowed is one at a time, or another --output");
  }
  try {
    std::error_code error;
    if (fresh) std::filesystem::remove(file_, error);
    require_file_or_none();
    const std::string first = content_of(header);
    const Read found = read();
    if (!found.whole || found.header != first) rewrite(first);
    open_file(O_RDWR | O_APPEND);
  } catch (...) {
    if (descriptor_ >= 0) ::close(descriptor_);
    ::close(lock_);
    throw;
  }
}

Journal::Journal(const std::filesystem::path& folder, const JournalHeader& header, std::vector<HashNumber> wanted)
    : folder_(folder), file_(folder / journal_name), wanted_(in_order(std::move(wanted))) {
  const std::string again = fmt::format("; required is to run again --shard {}/{}", header.shard, header.of);
  require_file_or_none();
  if (!fault_of_file(file_).empty()) refuse(file_, "the shard is missing" + again);
  const Read found = read();
  if (found.bad_line > 0) refuse(file_, fmt::format("the shard is damaged at line {}{}", found.bad_line, again));
  if (found.header != content_of(header)) {
    const Json stated = Json::parse(found.header, nullptr, false);
    const bool other = !stated.is_object() || !stated.contains("owner") || stated["owner"] != header.owner;
    refuse(file_, (other ? "the shard belongs to another sweep, case, --max-iterations or build of the program"
                         : "the shard is another part than its folder says") +
                      again);
  }
  open_file(O_RDONLY);
}

Journal::~Journal() {
  if (unsynced_) ::fdatasync(descriptor_);
  if (descriptor_ >= 0) ::close(descriptor_);
  if (lock_ >= 0) ::close(lock_);
}

/// Refuses a journal that is no regular file: a pipe or a device may have no end. Refuses a link and a file that begins
/// otherwise than a journal does: it is someone else's, and would be overwritten.
void Journal::require_file_or_none() const {
  std::error_code error;
  const auto type = std::filesystem::symlink_status(file_, error).type();
  if (type == std::filesystem::file_type::not_found) return;
  std::string fault = type == std::filesystem::file_type::symlink ? "is a link" : fault_of_file(file_);
  if (fault.empty() && !begins_as_journal(file_)) fault = "is no journal";
  if (!fault.empty()) refuse(file_, fault + "; allowed is a journal of finished rows, or none");
}

void Journal::open_file(int flags) {
  descriptor_ = ::open(file_.c_str(), flags | O_CLOEXEC);
  if (descriptor_ < 0) refuse(file_, std::string("cannot be opened (") + std::strerror(errno) + ")");
}

std::optional<std::size_t> Journal::index_of(std::string_view hash) const {
  const auto number = hash_number(hash);
  if (!number) return std::nullopt;
  const auto at = std::lower_bound(wanted_.begin(), wanted_.end(), *number);
  if (at == wanted_.end() || *at != *number) return std::nullopt;
  return static_cast<std::size_t>(at - wanted_.begin());
}

bool Journal::holds(const std::string& hash) const {
  const auto index = index_of(hash);
  return index && places_[*index].bytes > 0;
}

Journal::Read Journal::read() {
  Read found;
  places_.assign(wanted_.size(), {});
  end_ = 0;
  std::ifstream stream(file_, std::ios::binary);
  if (!stream) {
    found.whole = false;
    return found;
  }
  std::size_t number = 0;
  for (std::string line; read_line(stream, line); end_ += line.size() + 1) {
    ++number;
    const bool ended = !stream.eof();  // the last line may have been cut
    const std::string content = line.size() > check_digits ? line.substr(check_digits + 1) : "";
    if (!ended || line.size() <= check_digits || journal_line(content) != line + "\n") {
      found.whole = false;
      if (found.bad_line == 0) found.bad_line = number;
      continue;
    }
    if (content.starts_with('{')) {
      found.header = content;
      found.whole = found.whole && number == 1;
      continue;
    }
    const auto index = index_of(std::string_view(content).substr(0, hash_digits));
    if (content.size() <= hash_digits + 1 || !index) {
      found.whole = false;
      continue;
    }
    places_[*index] = {.begin = end_ + before_text, .bytes = line.size() - before_text};
  }
  return found;
}

void Journal::rewrite(const std::string& header) {
  OutputFile file(file_);
  std::vector<Place> places(wanted_.size());
  std::string text = journal_line(header);
  std::size_t written = 0;
  const bool rows_to_keep = std::any_of(places_.begin(), places_.end(), [](const Place& at) { return at.bytes > 0; });
  if (rows_to_keep) open_file(O_RDONLY);
  for (std::size_t i = 0; i < wanted_.size(); ++i) {
    if (places_[i].bytes == 0) continue;
    const std::string hash = digits_of(wanted_[i]);
    const std::string content = hash + " " + row(hash);
    places[i] = {.begin = written + text.size() + before_text, .bytes = places_[i].bytes};
    text += journal_line(content);
    constexpr std::size_t enough = 1 << 20;
    if (text.size() < enough) continue;
    file.append(text);
    written += text.size();
    text.clear();
  }
  file.append(text);
  file.commit();
  if (descriptor_ >= 0) ::close(descriptor_);
  descriptor_ = -1;
  end_ = written + text.size();
  places_ = std::move(places);
}

std::string Journal::row(const std::string& hash) const {
  const Place& place = places_.at(index_of(hash).value());
  std::string text(place.bytes, '\0');
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t got =
        ::pread(descriptor_, text.data() + done, text.size() - done, static_cast<off_t>(place.begin + done));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) refuse(file_, "cannot be read any more; it has been changed while it was in use");
    done += static_cast<std::size_t>(got);
  }
  return text;
}

void Journal::add(const std::string& hash, const std::string& text) {
  const std::string line = journal_line(hash + " " + text);
  for (std::size_t done = 0; done < line.size();) {
    const ssize_t put = ::write(descriptor_, line.data() + done, line.size() - done);
    if (put < 0 && errno == EINTR) continue;
    if (put < 0) refuse(file_, std::string("cannot be written (") + std::strerror(errno) + ")");
    done += static_cast<std::size_t>(put);
  }
  places_.at(index_of(hash).value()) = {.begin = end_ + before_text, .bytes = text.size()};
  end_ += line.size();
  unsynced_ = true;
  if (std::chrono::steady_clock::now() - synced_ >= sync_pause) sync();
}

void Journal::sync() {
  if (::fdatasync(descriptor_) != 0 && errno != EINVAL)
    refuse(file_, std::string("cannot be written (") + std::strerror(errno) + ")");
  synced_ = std::chrono::steady_clock::now();
  unsynced_ = false;
}

}  // namespace ehd

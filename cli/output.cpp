// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <iostream>
#include <nlohmann/json.hpp>
#include <system_error>

#include "cli/usage.hpp"
#include "contact/text.hpp"
#include "io/near_miss.hpp"
#include "workflow/case.hpp"

namespace ehd::cli {

void hold_closed_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    const bool closed = ::fcntl(stream, F_GETFD) < 0 && errno == EBADF;
    const int wrong_way = stream == STDIN_FILENO ? O_WRONLY : O_RDONLY;
    if (closed && ::open("/dev/null", wrong_way) < 0) return;  // the lowest free number: that of the stream
  }
}

void complain(const std::string& line) {
  constexpr std::size_t longest = 4000;  // the mistake stands at the begin, what is allowed at the end
  std::string text = one_line(line);
  if (text.size() > longest) {
    std::size_t end = text.size() - longest / 2;
    while (end < text.size() && utf8_length(std::string_view(text).substr(end)) == 0) ++end;  // within a character
    text = shortened(text, longest / 2) + " " + text.substr(end);
  }
  std::cerr << text << std::endl;
}

void print(const std::string& text) {
  std::cout << text << std::flush;
  if (!std::cout) throw OutputError("standard output: cannot be written (the device is full or closed)");
}

std::vector<NamedFile> files_of(const std::vector<Case>& cases) {
  std::vector<NamedFile> files;
  for (const Case& one : cases) files.push_back({"the case " + one.id, one.file});
  return files;
}

void require_distinct(const std::vector<NamedFile>& inputs, const std::vector<NamedFile>& outputs) {
  const auto whole = [](const std::filesystem::path& path) {
    std::error_code error;
    const auto absolute = std::filesystem::absolute(path, error);
    const auto canonical = std::filesystem::weakly_canonical(absolute, error);
    return error ? absolute.lexically_normal() : canonical;  // a path that cannot be followed cannot be written either
  };
  std::vector<NamedFile> taken;
  for (const NamedFile& input : inputs) taken.push_back({input.name, whole(input.path)});
  for (const NamedFile& output : outputs) {
    if (output.path == "-" && output.name != "--json")
      throw option_error(output.name, "-", "is no file; allowed is a file's name (only --json knows standard output)");
    if (output.path.empty() || output.path == "-") continue;  // nothing, standard output
    const auto path = whole(output.path);
    for (const NamedFile& other : taken) {
      if (other.path == path)
        throw option_error(output.name, output.path.string(),
                           "is the same file as " + other.name + "; allowed is a file of its own");
    }
    taken.push_back({output.name, path});
  }
}

std::string ending_of(const std::filesystem::path& name) { return in_small_letters(name.extension().string()); }

std::optional<OutputFile> opened(const std::optional<std::string>& name) {
  return name ? std::optional<OutputFile>(std::in_place, *name) : std::nullopt;
}

bool styled_output() {
  const char* no_color = std::getenv("NO_COLOR");
  const char* terminal = std::getenv("TERM");
  const bool dumb = terminal && std::string_view(terminal) == "dumb";
  return ::isatty(STDOUT_FILENO) && !(no_color && *no_color) && !dumb;
}

OutputFolder::OutputFolder(const std::optional<std::string>& option) : path_(option.value_or("")) {
  if (!option) return;
  std::error_code error;
  const auto whole = std::filesystem::absolute(path_, error).lexically_normal();
  // A link that leads nowhere is there, and is not ours to remove.
  const auto is_there = [&](const auto& path) {
    return std::filesystem::exists(std::filesystem::symlink_status(path, error));
  };
  for (auto above = whole; !above.empty() && !is_there(above); above = above.parent_path()) made_.push_back(above);
  try {
    make_folder(path_);
  } catch (...) {
    remove_empty();
    throw;
  }
}

OutputFolder::~OutputFolder() {
  files_.clear();  // their temporary files are in the folder
  remove_empty();
}

void OutputFolder::open(const std::vector<std::string>& names) {
  if (path_.empty()) return;
  for (const std::string& name : names) files_.try_emplace(name, path_ / name, Replaces::file);
}

void OutputFolder::write(const std::string& name, const std::string& text) {
  if (const auto file = files_.find(name); file != files_.end()) file->second.append(text);
}

void OutputFolder::commit() {
  std::vector<OutputFile*> all;
  for (auto& file : files_) all.push_back(&file.second);
  commit_together(all);
}

void OutputFolder::remove_empty() {
  std::error_code not_empty;
  for (const auto& folder : made_) std::filesystem::remove(folder, not_empty);  // the deepest first
  made_.clear();
}

JsonTarget::JsonTarget(const std::optional<std::string>& option) : asked_(option.has_value()) {
  if (option && *option != "-") file_.emplace(*option);
}

void JsonTarget::commit(const Json& json, const std::vector<OutputFile*>& others) {
  const std::string text = json_text(json);
  if (file_) {
    file_->append(text);
  } else if (asked_) {
    print(text);
  }
  std::vector<OutputFile*> all = others;
  if (file_) all.push_back(&*file_);
  commit_together(all);
}

}  // namespace ehd::cli

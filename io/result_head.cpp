// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/result_head.hpp"

#include <nlohmann/json.hpp>

#include "io/provenance.hpp"

namespace ehd {

namespace {

constexpr std::size_t most_members = 24;  // of a result, at its top level

}  // namespace

Json result_head(std::string_view schema) {
  static const Json program = provenance();  // it reads the machine too: once is enough
  Json head = object_of(most_members);
  head["schema"] = schema;
  for (const char* key : {"version", "commit"})
    if (program.contains(key)) head["provenance"][key] = program[key];
  return head;
}

}  // namespace ehd

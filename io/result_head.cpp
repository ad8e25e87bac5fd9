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
  Json& short_provenance = head["provenance"] = Json::object();
  for (const char* key : {"version", "commit"})
    if (program.contains(key)) short_provenance[key] = program[key];
  return head;
}

}  // namespace ehd

// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/result_head.hpp"

#include <nlohmann/json.hpp>

#include "io/provenance.hpp"

namespace ehd {

Json result_head(std::string_view schema) {
  static const Json program = provenance();  // it reads the machine too: once is enough
  Json head;
  head["schema"] = schema;
  for (const char* key : {"version", "commit"})
    if (program.contains(key)) head["provenance"][key] = program[key];
  return head;
}

}  // namespace ehd

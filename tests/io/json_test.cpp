// SPDX-License-Identifier: GPL-3.0-or-later
// JSON as it is written and read back.
#include "io/json.hpp"

#include <boost/test/unit_test.hpp>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>

using namespace ehd;

namespace {

std::string json_refusal(const std::string& text) {
  try {
    (void)json_from(text);
  } catch (const JsonError& error) {
    return error.what();
  }
  return "read";
}

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(json)

BOOST_AUTO_TEST_CASE(a_text_that_is_written_is_read_back) {
  const std::string text = R"({"b":1,"a":[0.1,-2.5e-300,true,"x\n"],"c":{"b":{}}})";
  BOOST_TEST(json_from(text).dump() == text);
}

BOOST_AUTO_TEST_CASE(a_text_that_this_project_never_writes_is_refused) {
  BOOST_TEST(json_refusal("{\"a\":1e400}") == "holds a number that is out of range");
  BOOST_TEST(json_refusal("{\"a\":-1e999}") == "holds a number that is out of range");
  BOOST_TEST(json_refusal("{\"a\":1,\"b\":{\"a\":1},\"a\":1}") == "has a key twice: a");
  for (const std::string word : {"nan", "NaN", "inf", "-inf", "Infinity", "-Infinity"})
    BOOST_TEST(json_refusal("{\"a\":" + word + "}").starts_with("is no JSON: " + word + " at byte 6; "));
  for (const std::string word : {"nano", "tnan", "infinite", "1inf", "-info"})
    BOOST_TEST(json_refusal("{\"a\":" + word + "}").starts_with("is no JSON (it breaks at byte "), word);
  BOOST_TEST(json_refusal("{\"a\":no}") == "is no JSON (it breaks at byte 7)");
  BOOST_TEST(json_refusal("{}{}") == "is no JSON (it breaks at byte 3)");
  BOOST_TEST(json_refusal("") == "is no JSON (it breaks at byte 1)");
  BOOST_TEST(json_refusal(std::string("{}\0", 3)) == "is no JSON (it breaks at byte 3)");
  BOOST_TEST(json_refusal("\xEF\xBB\xBF{}") == "is no JSON (it breaks at byte 1)");
  BOOST_TEST(json_refusal("\"\xff\"").starts_with("is no JSON"));
  BOOST_TEST(json_refusal(repeated("[", 64) + repeated("]", 64)) == "read");
  BOOST_TEST(json_refusal(repeated("[", 66) + repeated("]", 66)) == "has more than 64 levels");
  BOOST_TEST(json_refusal(repeated("{\"a\":", 200000)) == "has more than 64 levels");
  std::string keys;
  for (int i = 0; i <= 10000; ++i) keys += "\"" + std::to_string(i) + "\":0,";
  BOOST_TEST(json_refusal("{" + keys + "\"\":0}") == "has an object of more than 10000 keys");
}

BOOST_AUTO_TEST_CASE(what_is_not_finite_is_absent) {
  constexpr double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  Json object = Json::object();
  put(object, "a", nan);
  put(object, "b", {1.0, inf});
  put(object, "c", {1.0, 2.0});
  BOOST_TEST(object.dump() == R"({"c":[1.0,2.0]})");
}

BOOST_AUTO_TEST_SUITE_END()

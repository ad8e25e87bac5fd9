// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/content_hash.hpp"

#include <set>
#include <sstream>
#include <string>

#include "tests/check.hpp"

BOOST_AUTO_TEST_SUITE(content_hash)

// Published: the empty text and short ones, as xxh128sum prints them.
BOOST_AUTO_TEST_CASE(the_hash_is_xxh3_of_128_bits) {
  BOOST_TEST(::ehd::content_hash("") == "99aa06d3014798d86001c324468d497f");
  BOOST_TEST(::ehd::content_hash("a") == "a96faf705af16834e6c632b61e964e1f");
  BOOST_TEST(::ehd::content_hash("abc") == "06b05ab6733a618578af5f94892f3950");
}

// The lengths are those of pieces, and their neighbours.
BOOST_AUTO_TEST_CASE(a_stream_has_the_hash_of_its_bytes) {
  for (const std::size_t length : {0u, 1u, 16383u, 16384u, 16385u, 50000u}) {
    std::string content;
    for (std::size_t i = 0; i < length; ++i) content += static_cast<char>(i * i % 251);
    std::istringstream stream(content);
    BOOST_TEST(::ehd::content_hash(stream) == ::ehd::content_hash(content));
  }
}

// Invariant: a byte more, less or other is another hash, for every length that the algorithm treats differently.
BOOST_AUTO_TEST_CASE(any_change_of_a_byte_is_another_hash) {
  std::set<std::string> contents, hashes;
  for (const std::size_t length : {1u, 3u, 8u, 16u, 17u, 128u, 129u, 240u, 241u, 5000u})
    for (const std::size_t changed : {std::size_t{0}, length / 2, length - 1})
      for (const char byte : {'a', 'b', '\0'}) {
        std::string content(length, 'a');
        content[changed] = byte;
        contents.insert(content);
        hashes.insert(::ehd::content_hash(content));
      }
  BOOST_TEST(contents.size() > 50u);
  BOOST_TEST(hashes.size() == contents.size());
  for (const std::string& hash : hashes) BOOST_TEST(hash.size() == ::ehd::content_hash_digits);
}

BOOST_AUTO_TEST_SUITE_END()

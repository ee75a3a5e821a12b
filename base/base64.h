#pragma once

#include <cstring>
#include <string>
#include <vector>

#include "base/errors.h"

namespace geneva::base {

/// Bytes in base 64, and back.
/// @throws base::InputError if the text is not in base 64
std::string encoded_bytes(const std::vector<unsigned char>& bytes);
std::vector<unsigned char> decoded_bytes(const std::string& text);

/// The little-endian bytes of numbers in base 64.
template <typename Number>
std::string encoded(const std::vector<Number>& numbers) {
  std::vector<unsigned char> bytes(sizeof(Number) * numbers.size());
  if (!bytes.empty()) std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return encoded_bytes(bytes);
}

/// @throws base::InputError if the text does not hold whole numbers
template <typename Number>
std::vector<Number> decoded(const std::string& text) {
  const std::vector<unsigned char> bytes = decoded_bytes(text);
  if (bytes.size() % sizeof(Number) != 0) throw InputError("encoded numbers are cut off");
  std::vector<Number> numbers(bytes.size() / sizeof(Number));
  if (!bytes.empty()) std::memcpy(numbers.data(), bytes.data(), bytes.size());
  return numbers;
}

}  // namespace geneva::base

#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

// What libFuzzer calls again and again; each target defines it for one of the readers.

/// Gives the bytes to the reader as the content of its file.
/// @throws what a finding is: everything but the refusals that the reader promises
/// @return 0
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace geneva::fuzz {

inline std::string text_of(const std::uint8_t* const data, const std::size_t size) {
  return {data, data + size};
}

}  // namespace geneva::fuzz

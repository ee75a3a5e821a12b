#pragma once

#include <string>
#include <string_view>

namespace geneva::base {

/// CRC-64 of ECMA-182 with the conventions of XZ, as 16 hexadecimal digits: tells whether bytes
/// are the same, unless somebody forged them.
std::string checksum(std::string_view bytes);

}  // namespace geneva::base

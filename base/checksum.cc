#include "base/checksum.h"

#include <fmt/format.h>

#include <boost/crc.hpp>

namespace geneva::base {

std::string checksum(const std::string_view bytes) {
  boost::crc_optimal<64, 0x42F0E1EBA9EA3693, ~0ULL, ~0ULL, true, true> sum;
  sum.process_bytes(bytes.data(), bytes.size());
  return fmt::format("{:016x}", sum.checksum());
}

}  // namespace geneva::base

#include "base/base64.h"

#include <algorithm>
#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/binary_from_base64.hpp>
#include <boost/archive/iterators/dataflow_exception.hpp>
#include <boost/archive/iterators/transform_width.hpp>

namespace geneva::base {

namespace iterators = boost::archive::iterators;

std::string encoded_bytes(const std::vector<unsigned char>& bytes) {
  using Digits = iterators::base64_from_binary<
      iterators::transform_width<std::vector<unsigned char>::const_iterator, 6, 8>>;
  // room for all digits, which the text would otherwise take one by one
  std::string text((4 * bytes.size() + 2) / 3, '\0');
  std::copy(Digits(bytes.begin()), Digits(bytes.end()), text.begin());
  text.append((3 - bytes.size() % 3) % 3, '=');
  return text;
}

std::vector<unsigned char> decoded_bytes(const std::string& text) try {
  using Bytes =
      iterators::transform_width<iterators::binary_from_base64<std::string::const_iterator>, 8, 6>;
  // without the padding, whose digits stand for nothing
  std::vector<unsigned char> bytes(3 * (text.find_last_not_of('=') + 1) / 4);
  std::copy_n(Bytes(text.begin()), bytes.size(), bytes.begin());
  return bytes;
} catch (const boost::archive::iterators::dataflow_exception&) {
  throw InputError("the text is not in base 64");
}

}  // namespace geneva::base

#include "post/view/encoded_numbers.h"

#include <algorithm>
#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/binary_from_base64.hpp>
#include <boost/archive/iterators/dataflow_exception.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <cmath>
#include <limits>

#include "base/errors.h"

namespace geneva::post {

namespace iterators = boost::archive::iterators;

std::string encoded_bytes(const std::vector<unsigned char>& bytes) {
  using Digits = iterators::base64_from_binary<
      iterators::transform_width<std::vector<unsigned char>::const_iterator, 6, 8>>;
  std::string text(Digits(bytes.begin()), Digits(bytes.end()));
  text.append((3 - bytes.size() % 3) % 3, '=');
  return text;
}

std::vector<unsigned char> decoded_bytes(const std::string& text) try {
  using Bytes =
      iterators::transform_width<iterators::binary_from_base64<std::string::const_iterator>, 8, 6>;
  std::vector<unsigned char> bytes(Bytes(text.begin()), Bytes(text.end()));
  const auto padding = text.size() - (text.find_last_not_of('=') + 1);
  bytes.resize(bytes.size() - std::min(bytes.size(), padding));
  return bytes;
} catch (const boost::archive::iterators::dataflow_exception&) {
  throw base::InputError("the text is not in base 64");
}

namespace {
constexpr std::uint16_t no_number = 65535;
constexpr double maximum_step = 65534.;
}  // namespace

Quantised quantised(const std::vector<float>& values) {
  Quantised result{0.F, 0.F, {}};
  bool is_first = true;
  for (const float value : values) {
    if (!std::isfinite(value)) continue;
    result.low = is_first ? value : std::min(result.low, value);
    result.high = is_first ? value : std::max(result.high, value);
    is_first = false;
  }
  const double range = static_cast<double>(result.high) - result.low;
  for (const float value : values)
    result.steps.push_back(!std::isfinite(value) ? no_number
                           : range == 0.         ? std::uint16_t{0}
                                                 : static_cast<std::uint16_t>(std::lround(
                                                       maximum_step * (value - result.low) / range)));
  return result;
}

std::vector<float> restored(const Quantised& values) {
  std::vector<float> result;
  const double range = static_cast<double>(values.high) - values.low;
  for (const std::uint16_t step : values.steps)
    result.push_back(step == no_number
                         ? std::numeric_limits<float>::quiet_NaN()
                         : static_cast<float>(values.low + range * step / maximum_step));
  return result;
}

}  // namespace geneva::post

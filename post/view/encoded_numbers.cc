#include "post/view/encoded_numbers.h"

#include <deal.II/base/utilities.h>
#include <boost/archive/iterators/dataflow_exception.hpp>

namespace geneva::post {

std::string encoded_bytes(const std::vector<unsigned char>& bytes) {
  return dealii::Utilities::encode_base64(bytes);
}

std::vector<unsigned char> decoded_bytes(const std::string& text) try {
  return dealii::Utilities::decode_base64(text);
} catch (const boost::archive::iterators::dataflow_exception&) {
  throw std::invalid_argument("the text is not in base 64");
}

}  // namespace geneva::post

#include <cstdlib>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>

#include "base/errors.h"
#include "web/calculation.h"

namespace {

using nlohmann::json;

json answer_to(const char* inputs) try {
  return geneva::web::calculated(geneva::web::read_inputs(json::parse(inputs)));
} catch (const geneva::base::InputError& error) {
  return {{"refused", error.what()}};
}

}  // namespace

extern "C" {

/// What the page's script calls.
/// @param inputs as geneva::web::read_inputs() takes them, in JSON
/// @return what geneva::web::calculated() says, or {"refused": the sentence that says why not}, in
/// JSON; to be freed by the caller
char* geneva_calculate(const char* inputs) {
  const std::string text = answer_to(inputs).dump();
  auto* const copy = static_cast<char*>(std::malloc(text.size() + 1));
  if (copy != nullptr) std::memcpy(copy, text.c_str(), text.size() + 1);
  return copy;
}
}

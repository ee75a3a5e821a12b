#include <nlohmann/json.hpp>

#include "base/errors.h"
#include "mesh/mesh_data.h"
#include "mesh/mesher_exchange.h"
#include "tests/fuzz/reader.h"

// The mesh that the mesher answers with, which is not trusted: it has run what a stranger wrote.

namespace {

template <int dim>
void read(const nlohmann::json& answer) {
  try {
    check(geneva::mesh::mesh_of<dim>(answer));
  } catch (const geneva::base::InputError&) {  // a refusal, in words
  }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* const data, const std::size_t size) {
  const auto answer = nlohmann::json::parse(data, data + size, nullptr, false);
  read<2>(answer);
  read<3>(answer);
  return 0;
}

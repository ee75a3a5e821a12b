#include "model/together.h"

#include <cstddef>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "base/errors.h"
#include "fem/discretisation/gather.h"

namespace geneva::model {

namespace {

enum class Failure { none, input, limit, memory, bug };

[[noreturn]] void fail(const Failure failure, const std::string& text) {
  switch (failure) {
    case Failure::input:
      throw base::InputError(text);
    case Failure::limit:
      throw base::LimitReached(text);
    case Failure::memory:
      throw std::bad_alloc();
    default:
      throw std::runtime_error(text);
  }
}

std::pair<Failure, std::string> outcome_of(const std::function<void()>& task) {
  try {
    task();
  } catch (const base::InputError& error) {
    return {Failure::input, error.what()};
  } catch (const std::filesystem::filesystem_error& error) {
    return {Failure::input, error.what()};
  } catch (const base::LimitReached& error) {
    return {Failure::limit, error.what()};
  } catch (const std::bad_alloc&) {
    return {Failure::memory, ""};
  } catch (const std::exception& error) {
    return {Failure::bug, error.what()};
  }
  return {Failure::none, ""};
}

}  // namespace

void together(const MPI_Comm communicator, const std::function<void()>& task) {
  const auto [failure, text] = outcome_of(task);
  const std::vector<Failure> failures = fem::gathered_one(communicator, failure);
  const std::vector<std::string> texts = fem::gathered_texts(communicator, text);
  for (std::size_t rank = 0; rank < failures.size(); ++rank)
    if (failures[rank] != Failure::none) fail(failures[rank], texts[rank]);
}

}  // namespace geneva::model

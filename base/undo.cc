#include "base/undo.h"

#include <utility>

namespace geneva::base {

namespace {

struct Actions {
  std::recursive_mutex mutex;
  std::list<std::function<void()>> list;
};

/// Never destroyed: a thread that waits for signals may outlive main().
Actions& actions() {
  static auto* const all = new Actions;
  return *all;
}

}  // namespace

Undo::Undo(std::function<void()> action) {
  const auto held = not_to_be_interrupted();
  place_ = actions().list.insert(actions().list.end(), std::move(action));
}

Undo::~Undo() {
  const auto held = not_to_be_interrupted();
  actions().list.erase(place_);
}

std::unique_lock<std::recursive_mutex> not_to_be_interrupted() {
  return std::unique_lock(actions().mutex);
}

void undo_all() {
  // Never given back: what comes after the end of an Undo must not be done any more.
  not_to_be_interrupted().release();
  auto& list = actions().list;
  for (auto action = list.rbegin(); action != list.rend(); ++action) (*action)();
}

}  // namespace geneva::base

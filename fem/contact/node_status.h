#pragma once

#include <vector>

namespace geneva::fem {

/// What a node of a contact's source does.
enum class NodeStatus {
  open,   ///< does not touch the target
  stick,  ///< touches it and is held by friction
  slip    ///< touches it and may slide along it
};

constexpr bool is_closed(const NodeStatus status) { return status != NodeStatus::open; }

/// Which nodes touch the target.
inline std::vector<bool> closed(const std::vector<NodeStatus>& status) {
  std::vector<bool> result;
  result.reserve(status.size());
  for (const NodeStatus of_node : status) result.push_back(is_closed(of_node));
  return result;
}

}  // namespace geneva::fem

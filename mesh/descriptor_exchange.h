#pragma once

#include <sys/types.h>

#include <optional>

namespace geneva::mesh {

/// What a process of the mesher is given for its task.
struct TaskDescriptors {
  int talk;      ///< a socket: the request comes there, the answer goes there
  int messages;  ///< what it prints
};

/// @return whether they were sent; they stay open here
bool send_descriptors(int socket, const TaskDescriptors& descriptors);
/// @return none at the end
std::optional<TaskDescriptors> receive_descriptors(int socket);

/// @param id of the task's process, or less than 0: the error, with its sign changed
/// @return whether it was sent
bool send_process_id(int socket, pid_t id);
/// @return none at the end
std::optional<pid_t> receive_process_id(int socket);

}  // namespace geneva::mesh

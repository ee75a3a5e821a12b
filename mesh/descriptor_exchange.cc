#include "mesh/descriptor_exchange.h"

#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

namespace geneva::mesh {

namespace {

/// A message of one byte with room for two descriptors.
struct Message {
  char byte = 0;
  iovec content{&byte, 1};
  alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(TaskDescriptors))> room{};
  msghdr header{};

  Message() {
    header.msg_iov = &content;
    header.msg_iovlen = 1;
    header.msg_control = room.data();
    header.msg_controllen = room.size();
  }
  Message(const Message&) = delete;
  Message& operator=(const Message&) = delete;
};

/// Calls once more while a signal interrupts it.
template <typename Call>
ssize_t uninterrupted(const Call& call) {
  ssize_t count = call();
  while (count < 0 && errno == EINTR) count = call();
  return count;
}

}  // namespace

bool send_descriptors(const int socket, const TaskDescriptors& descriptors) {
  Message message;
  cmsghdr* const header = CMSG_FIRSTHDR(&message.header);
  header->cmsg_level = SOL_SOCKET;
  header->cmsg_type = SCM_RIGHTS;
  header->cmsg_len = CMSG_LEN(sizeof descriptors);
  std::memcpy(CMSG_DATA(header), &descriptors, sizeof descriptors);
  return uninterrupted([&] { return sendmsg(socket, &message.header, MSG_NOSIGNAL); }) == 1;
}

std::optional<TaskDescriptors> receive_descriptors(const int socket) {
  Message message;
  if (uninterrupted([&] { return recvmsg(socket, &message.header, MSG_CMSG_CLOEXEC); }) != 1)
    return std::nullopt;
  const cmsghdr* const header = CMSG_FIRSTHDR(&message.header);
  if (header == nullptr || header->cmsg_type != SCM_RIGHTS ||
      header->cmsg_len != CMSG_LEN(sizeof(TaskDescriptors)))
    return std::nullopt;
  TaskDescriptors descriptors{};
  std::memcpy(&descriptors, CMSG_DATA(header), sizeof descriptors);
  return descriptors;
}

bool send_process_id(const int socket, const pid_t id) {
  return uninterrupted([&] { return send(socket, &id, sizeof id, MSG_NOSIGNAL); }) == sizeof id;
}

std::optional<pid_t> receive_process_id(const int socket) {
  pid_t id = -1;
  if (uninterrupted([&] { return recv(socket, &id, sizeof id, MSG_WAITALL); }) != sizeof id)
    return std::nullopt;
  return id;
}

}  // namespace geneva::mesh

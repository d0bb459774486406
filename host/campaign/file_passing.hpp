// SPDX-License-Identifier: MIT
// Datagrams with file descriptors between processes (SCM_RIGHTS; unix(7)).
#pragma once

#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

#include "campaign/file_descriptor.hpp"

namespace regista::campaign {

inline constexpr std::size_t most_passed_files = 8;

// False when nobody can receive it.
bool send_bytes(int socket, std::span<const std::byte> bytes, std::span<const int> files);

// Waits for a datagram of just so many bytes. False at the end of the connection, and for any other datagram. The files
// are closed at exec.
bool receive_bytes(int socket, std::span<std::byte> bytes, std::vector<FileDescriptor>& files);

template <class T>
requires std::is_trivially_copyable_v<T>
bool send_with_files(int socket, const T& message, std::span<const int> files) {
  return send_bytes(socket, std::as_bytes(std::span<const T, 1>(&message, 1)), files);
}

template <class T>
requires std::is_trivially_copyable_v<T>
bool receive_with_files(int socket, T& message, std::vector<FileDescriptor>& files) {
  return receive_bytes(socket, std::as_writable_bytes(std::span<T, 1>(&message, 1)), files);
}

}  // namespace regista::campaign

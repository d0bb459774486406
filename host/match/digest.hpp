// SPDX-License-Identifier: MIT
// A hash over the course of a match (XXH3, 64 bits): two runs that agree in it agreed in every state of every body,
// every command, every packet and every decision of the referee.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <type_traits>

namespace regista::match {

class Digest {
 public:
  Digest();
  ~Digest();
  Digest(Digest&&) noexcept;
  Digest& operator=(Digest&&) noexcept;

  void add(std::span<const std::byte> bytes);

  // Values are taken byte by byte, so they must have no padding: scalars and arrays of structs of one scalar type.
  template <class T>
  requires std::is_arithmetic_v<T>
  void add(T value) { add(std::as_bytes(std::span(&value, 1))); }

  std::uint64_t value() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// 16 hexadecimal digits, as hashes are printed.
std::string hash_text(std::uint64_t hash);

}  // namespace regista::match

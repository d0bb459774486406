// SPDX-License-Identifier: MIT
// Values as bytes and back, between processes of this program on this machine: numbers as they lie in memory, texts and
// lists with their length before them. One function a type, `visit(archive, value)`, says both directions.
//
//   template <class Archive> void visit(Archive& archive, Pose& pose) { archive(pose.x, pose.y, pose.heading); }
#pragma once

#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace regista::texts {

// Values that are copied as they are.
template <class T>
concept PlainNumber = std::is_arithmetic_v<T> || std::is_enum_v<T>;

// Appends to memory that grows to what is needed and is then used again.
class BytesOut {
 public:
  void clear() { bytes_.clear(); }
  std::span<const std::uint8_t> bytes() const { return bytes_; }

  template <class... Values>
  void operator()(Values&... values) {
    (put(values), ...);
  }
  void raw(const void* data, std::size_t size) {
    const std::size_t before = bytes_.size();
    bytes_.resize(before + size);
    if (size != 0) std::memcpy(bytes_.data() + before, data, size);
  }

 private:
  template <class T>
  void put(T& value) {
    if constexpr (PlainNumber<std::remove_const_t<T>>) {
      raw(&value, sizeof value);
    } else {
      // A visit takes what it may fill; this archive only reads.
      visit(*this, const_cast<std::remove_const_t<T>&>(value));
    }
  }
  std::vector<std::uint8_t> bytes_;
};

// Reads what BytesOut wrote. Throws std::out_of_range at the end of the bytes.
class BytesIn {
 public:
  explicit BytesIn(std::span<const std::uint8_t> bytes) : rest_(bytes) {}
  bool empty() const { return rest_.empty(); }

  template <class... Values>
  void operator()(Values&... values) {
    (take(values), ...);
  }
  std::span<const std::uint8_t> raw(std::size_t size) {
    if (size > rest_.size()) throw std::out_of_range("bytes end too early");
    const auto out = rest_.first(size);
    rest_ = rest_.subspan(size);
    return out;
  }

 private:
  template <class T>
  void take(T& value) {
    if constexpr (std::is_same_v<T, bool>) {
      value = raw(1).front() != 0;  // the other side may have written anything
    } else if constexpr (PlainNumber<T>) {
      std::memcpy(&value, raw(sizeof value).data(), sizeof value);
    } else {
      visit(*this, value);
    }
  }
  std::span<const std::uint8_t> rest_;
};

inline void visit(BytesOut& archive, std::string& text) {
  const auto size = static_cast<std::uint32_t>(text.size());
  archive(size);
  archive.raw(text.data(), text.size());
}
inline void visit(BytesIn& archive, std::string& text) {
  std::uint32_t size = 0;
  archive(size);
  const auto bytes = archive.raw(size);
  text.assign(bytes.begin(), bytes.end());
}

template <class T>
void visit(BytesOut& archive, std::vector<T>& list) {
  const auto size = static_cast<std::uint32_t>(list.size());
  archive(size);
  for (T& each : list) archive(each);
}
template <class T>
void visit(BytesIn& archive, std::vector<T>& list) {
  std::uint32_t size = 0;
  archive(size);
  list.clear();
  for (std::uint32_t i = 0; i < size; ++i) archive(list.emplace_back());
}

template <class T>
void visit(BytesOut& archive, std::optional<T>& value) {
  const bool has = value.has_value();
  archive(has);
  if (has) archive(*value);
}
template <class T>
void visit(BytesIn& archive, std::optional<T>& value) {
  bool has = false;
  archive(has);
  value.reset();
  if (has) archive(value.emplace());
}

}  // namespace regista::texts

// SPDX-License-Identifier: MIT
// Converts values to bytes and back, for exchange between processes of this program on one machine. The bytes of a
// number are its bytes in memory. The length of a text or list precedes the content. One function `visit(archive,
// value)` for each type serves both directions.
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

// Types whose values are copied byte by byte.
template <class T>
concept PlainNumber = std::is_arithmetic_v<T> || std::is_enum_v<T>;

// Writes values as bytes into memory that grows as needed and is reused.
class BytesOut {
 public:
  static constexpr bool reads = false;
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
      // visit() takes a mutable value, because readers fill it; this archive only reads the value.
      visit(*this, const_cast<std::remove_const_t<T>&>(value));
    }
  }
  std::vector<std::uint8_t> bytes_;
};

// Reads what BytesOut wrote. Throws std::out_of_range at the end of the bytes.
class BytesIn {
 public:
  static constexpr bool reads = true;
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
      value = raw(1).front() != 0;  // the other side may have written any byte
    } else if constexpr (PlainNumber<T>) {
      std::memcpy(&value, raw(sizeof value).data(), sizeof value);
    } else {
      visit(*this, value);
    }
  }
  std::span<const std::uint8_t> rest_;
};

template <class Archive>
void visit(Archive& archive, std::string& text) {
  auto size = static_cast<std::uint32_t>(text.size());
  archive(size);
  if constexpr (Archive::reads) {
    const auto bytes = archive.raw(size);
    text.assign(bytes.begin(), bytes.end());
  } else {
    archive.raw(text.data(), text.size());
  }
}

template <class Archive, class T>
void visit(Archive& archive, std::vector<T>& list) {
  auto size = static_cast<std::uint32_t>(list.size());
  archive(size);
  if constexpr (Archive::reads) list.clear();
  for (std::uint32_t i = 0; i < size; ++i) archive(Archive::reads ? list.emplace_back() : list[i]);
}

template <class Archive, class T>
void visit(Archive& archive, std::optional<T>& value) {
  bool has = value.has_value();
  archive(has);
  if (Archive::reads && has) value.emplace();
  if (Archive::reads && !has) value.reset();
  if (has) archive(*value);
}

}  // namespace regista::texts

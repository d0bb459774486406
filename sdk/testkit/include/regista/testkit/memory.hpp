// SPDX-License-Identifier: MIT
// Memory that a plugin is given, from the heap or on pages of its own. On pages it ends where the next page may not be
// touched, and it can be made read-only or taken away: who reads or writes what is not his is stopped in that very
// instruction. A line on standard error says then what it was, and the process ends as it does for any such fault.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace regista::testkit {

// How a host lays out what it gives.
struct Layout {
  std::uint32_t growth = 0;  // bytes by which structs and elements are longer than in this version; a multiple of 8
  bool guarded = false;      // on pages of its own
};

// Words of 8 bytes, all bits set at first: a double there is NaN.
class Memory {
 public:
  Memory() = default;
  Memory(std::size_t bytes, const Layout& layout);

  std::uint64_t* data() { return pages_ ? pages_->words : heap_.data(); }
  const std::uint64_t* data() const { return pages_ ? pages_->words : heap_.data(); }
  std::span<const std::uint64_t> words() const { return {data(), count_}; }
  bool empty() const { return count_ == 0; }
  std::size_t bytes() const { return 8 * count_; }

  void fill_with_ones();
  // From here on. Nothing on the heap.
  void make_read_only();
  void take_away();

 private:
  friend class FaultReport;
  enum class Access { write, read, none };
  struct Pages {
    Pages(std::size_t words_in_it);
    ~Pages();
    Pages(const Pages&) = delete;
    Pages& operator=(const Pages&) = delete;
    void allow(Access access);
    unsigned char* begin;
    std::size_t length;  // bytes, without the page behind it
    std::uint64_t* words;
    Access access = Access::write;
  };

  std::vector<std::uint64_t> heap_;
  std::unique_ptr<Pages> pages_;
  std::size_t count_ = 0;
};

}  // namespace regista::testkit

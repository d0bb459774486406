// SPDX-License-Identifier: MIT
#include "plugin/address_ranges.hpp"

#include <dlfcn.h>
#include <link.h>

#include <algorithm>
#include <atomic>
#include <string_view>

namespace regista::plugin {
namespace {

struct Range {
  std::uintptr_t first = 0, last = 0;  // [first, last)
  ObjectName name{};
};

std::array<Range, 256> ranges;
std::atomic<std::size_t> known_ranges{0};

struct Wanted {
  ElfW(Addr) base;
  const char* path;
};

int look(dl_phdr_info* object, std::size_t, void* raw) {
  const auto& wanted = *static_cast<const Wanted*>(raw);
  if (object->dlpi_addr != wanted.base || std::string_view(object->dlpi_name) != wanted.path) return 0;
  Range range{UINTPTR_MAX, 0, {}};
  for (int i = 0; i < object->dlpi_phnum; ++i) {
    const ElfW(Phdr)& segment = object->dlpi_phdr[i];
    if (segment.p_type != PT_LOAD) continue;
    const std::uintptr_t first = object->dlpi_addr + segment.p_vaddr;
    range.first = std::min(range.first, first);
    range.last = std::max(range.last, first + segment.p_memsz);
  }
  std::string_view name = wanted.path;
  name.remove_prefix(name.rfind('/') + 1);
  std::copy_n(name.data(), std::min(name.size(), range.name.size() - 1), range.name.data());
  const std::size_t count = known_ranges.load();
  for (std::size_t i = 0; i < count; ++i) {
    if (ranges[i].first == range.first) return 1;
  }
  if (count == ranges.size()) return 1;
  ranges[count] = range;
  known_ranges.store(count + 1);  // only now: a handler sees whole entries
  return 1;
}

}  // namespace

void note_address_range(void* handle) {
  link_map* map = nullptr;
  if (dlinfo(handle, RTLD_DI_LINKMAP, &map) != 0 || map == nullptr) return;
  Wanted wanted{map->l_addr, map->l_name};
  dl_iterate_phdr(look, &wanted);
}

std::vector<const void*> noted_objects() {
  std::vector<const void*> out;
  for (std::size_t i = 0; i < known_ranges.load(); ++i) out.push_back(reinterpret_cast<const void*>(ranges[i].first));
  return out;
}

const ObjectName* object_at(std::uintptr_t address) {
  const std::size_t count = known_ranges.load();
  for (std::size_t i = 0; i < count; ++i) {
    if (address >= ranges[i].first && address < ranges[i].last) return &ranges[i].name;
  }
  return nullptr;
}

}  // namespace regista::plugin

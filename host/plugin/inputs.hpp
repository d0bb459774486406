// SPDX-License-Identifier: MIT
// What a call reads: every byte that its arguments lead to, by fingerprints that are taken before the call and compared
// after it. A plugin that writes to its input changes what others compute, and is found out here.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <regista/abi.h>

namespace regista::plugin {

class Inputs {
 public:
  // Names must be literals. Null is no input.
  void add(const char* name, const void* data, std::size_t bytes) { add(name, "", data, bytes); }
  template <class T>
  void add(const char* name, const T* value) {
    add(name, value, value == nullptr ? 0 : sizeof(T));
  }
  void add(const char* name, const regista_span& elements) { add(name, "", elements); }
  void add(const char* name, const char* text);
  // With worlds, tasks, waypoints and whatever else it leads to. `name`: "frame".
  void add(const char* name, const regista_frame* frame);
  // With its values.
  void add(const char* name, const regista_matrix* matrix);
  // With its bytes.
  void add(const char* name, const regista_message* message);
  // With the robots near.
  void add(const char* name, const regista_body* body);
  // With landmarks, roles and kicks.
  void add(const char* name, const regista_environment* environment);

  // The innermost part that is not what it was, "frame.mine.robots"; empty when all is as it was. Follows no pointer
  // that the plugin could have changed.
  std::string changed() const;

 private:
  struct Part {
    const char *whole, *part;  // "frame", ".mine.robots"
    const void* data;
    std::size_t bytes;
    std::uint64_t fingerprint;
  };

  void add(const char* whole, const char* part, const void* data, std::size_t bytes);
  void add(const char* whole, const char* part, const regista_span& elements);
  void add(const char* whole, const char* part, const regista_matrix& matrix);
  void add_world(const char* whole, const char* const (&parts)[4], const regista_world* world);

  std::vector<Part> parts_;
};

}  // namespace regista::plugin

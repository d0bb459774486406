// SPDX-License-Identifier: MIT
// Reading a plugin's descriptor: what it must hold before the host touches the plugin, and the small questions that
// are asked of it later. <regista/abi.h> says what each field means.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <regista/abi.h>

namespace regista::plugin {

// What is wrong with a descriptor, in one line; empty when nothing is. `index`: its number in the shared object. Reads
// no field beyond those that the version it declares promises.
std::string what_is_wrong(const regista_descriptor& descriptor, std::uint32_t index);

// The same of an id, or of the name of a parameter: "is not lower_snake_case".
std::string wrong_with_name(std::string_view name);

// Parameter number `index`, < descriptor.parameter_count.
const regista_parameter& parameter(const regista_descriptor& descriptor, std::uint32_t index);

// Names of a sender's own reasons, in their order.
std::vector<std::string> reasons_of(const regista_sender& sender);

// Whether the plugin has a table of calls for this kind.
bool implements(const regista_descriptor& descriptor, int kind);

// Its kinds, ascending.
std::vector<int> kinds(const regista_descriptor& descriptor);

// The table of calls of this kind, or null. `Table` is the struct of <regista/abi.h> for that kind.
template <class Table>
const Table* table(const regista_descriptor& descriptor, int kind) {
  return static_cast<const Table*>(descriptor.table(kind));
}

// "predictor", "context", ...; with an article, "an assigner"; and back.
std::string_view kind_name(int kind);
std::string_view kind_with_article(int kind);
std::optional<int> kind_of_name(std::string_view name);

// "real", "integer", ...
std::string_view type_name(std::int32_t type);

// "0.5 to 20 m", the closed range of a real or integer parameter
std::string range_text(const regista_parameter& parameter);

// "self", "ball", ... of one REGISTA_SUBJECT_*; "ball, opponents" of several.
std::string subject_names(std::uint32_t subjects);

}  // namespace regista::plugin

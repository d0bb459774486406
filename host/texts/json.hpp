// SPDX-License-Identifier: MIT
// nlohmann::json and ordered_json for all rooms. Parser, writer and the values' own functions are compiled once, in
// json.cpp and ordered_json.cpp: a file that includes <nlohmann/json.hpp> itself pays two seconds of the compiler for
// them.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace regista::texts::json {

using Characters = nlohmann::detail::iterator_input_adapter<const char*>;
using Text = nlohmann::detail::iterator_input_adapter<std::string::const_iterator>;

}  // namespace regista::texts::json

extern template class nlohmann::basic_json<>;
extern template class nlohmann::basic_json<nlohmann::ordered_map>;
extern template class nlohmann::detail::serializer<nlohmann::json>;
extern template class nlohmann::detail::serializer<nlohmann::ordered_json>;
extern template class nlohmann::detail::parser<nlohmann::json, regista::texts::json::Characters>;
extern template class nlohmann::detail::parser<nlohmann::json, regista::texts::json::Text>;
extern template class nlohmann::detail::parser<nlohmann::ordered_json, regista::texts::json::Characters>;
extern template class nlohmann::detail::parser<nlohmann::ordered_json, regista::texts::json::Text>;

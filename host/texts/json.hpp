// SPDX-License-Identifier: MIT
// nlohmann::json and ordered_json for all folders of host/. Only json.cpp compiles the parser, the writer and the
// functions of values. A file that includes <nlohmann/json.hpp> directly costs the compiler two more seconds.
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

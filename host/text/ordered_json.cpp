// SPDX-License-Identifier: MIT
#include "text/json.hpp"

template class nlohmann::basic_json<nlohmann::ordered_map>;
template class nlohmann::detail::serializer<nlohmann::ordered_json>;
template class nlohmann::detail::parser<nlohmann::ordered_json, regista::text::json::Characters>;
template class nlohmann::detail::parser<nlohmann::ordered_json, regista::text::json::Text>;

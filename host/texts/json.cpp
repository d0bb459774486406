// SPDX-License-Identifier: MIT
#include "texts/json.hpp"

template class nlohmann::basic_json<>;
template class nlohmann::detail::serializer<nlohmann::json>;
template class nlohmann::detail::parser<nlohmann::json, regista::texts::json::Characters>;
template class nlohmann::detail::parser<nlohmann::json, regista::texts::json::Text>;

template class nlohmann::basic_json<nlohmann::ordered_map>;
template class nlohmann::detail::serializer<nlohmann::ordered_json>;
template class nlohmann::detail::parser<nlohmann::ordered_json, regista::texts::json::Characters>;
template class nlohmann::detail::parser<nlohmann::ordered_json, regista::texts::json::Text>;

// SPDX-License-Identifier: MIT
#include "config/json.hpp"

template class nlohmann::basic_json<>;
template class nlohmann::detail::serializer<nlohmann::json>;
template class nlohmann::detail::parser<nlohmann::json, regista::config::json::Characters>;
template class nlohmann::detail::parser<nlohmann::json, regista::config::json::Text>;

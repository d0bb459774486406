// SPDX-License-Identifier: MIT
#include "text/json.hpp"

template class nlohmann::basic_json<>;
template class nlohmann::detail::serializer<nlohmann::json>;
template class nlohmann::detail::parser<nlohmann::json, regista::text::json::Characters>;
template class nlohmann::detail::parser<nlohmann::json, regista::text::json::Text>;

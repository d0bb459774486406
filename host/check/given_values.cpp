// SPDX-License-Identifier: MIT
#include "check/given_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include <regista/abi.h>

#include "config/document_files.hpp"
#include "config/errors.hpp"
#include "config/scalar.hpp"
#include "plugin/description.hpp"
#include "texts/message.hpp"

namespace regista::check {
namespace {

std::variant<double, std::string> value_of(const regista_parameter& declared, const std::string& text) {
  const auto wrong = [&](std::string expected) {
    return config::BadInput(
        fmt::format("--set {}={}: expected {}", declared.name, texts::in_quotes(text), std::move(expected)));
  };
  switch (declared.type) {
    case REGISTA_TYPE_BOOLEAN:
      if (text == "true") return 1.0;
      if (text == "false") return 0.0;
      throw wrong("true or false");
    case REGISTA_TYPE_REAL:
    case REGISTA_TYPE_INTEGER: {
      const std::optional<double> number = config::typed_number(text);
      const bool whole = declared.type == REGISTA_TYPE_INTEGER;
      if (number && *number >= declared.minimum && *number <= declared.maximum &&
          (!whole || *number == std::round(*number))) {
        return *number;
      }
      throw wrong(fmt::format("a {}number from {} to {}", whole ? "whole " : "", declared.minimum, declared.maximum));
    }
    case REGISTA_TYPE_CHOICE: {
      const std::vector<std::string> choices(declared.choices, declared.choices + declared.choice_count);
      const auto found = std::ranges::find(choices, text);
      if (found == choices.end()) {
        throw config::BadInput(texts::unknown("value", text, fmt::format("--set {}", declared.name), choices));
      }
      return static_cast<double>(found - choices.begin());
    }
    case REGISTA_TYPE_FILE:
      return config::read_file(text);
    default:
      return text;
  }
}

}  // namespace

GivenValues::GivenValues(const GivenTexts& texts, const plugin::ScannedFile& surveyed,
                         const std::vector<std::string>& plugins) {
  for (const auto& plugin : surveyed.plugins) {
    const std::string id = plugin->declared().id;
    if (!plugins.empty() && std::ranges::find(plugins, id) == plugins.end()) continue;
    for (std::uint32_t i = 0; i < plugin->declared().parameter_count; ++i) {
      const regista_parameter& declared = plugin::parameter(plugin->declared(), i);
      texts::add_once(known_, declared.name);
      for (const auto& [name, text] : texts) {
        if (name == declared.name) of_[id].emplace_back(name, value_of(declared, text));
      }
    }
  }
}

void GivenValues::give(const std::string& id, testkit::Values& values) const {
  const auto own = of_.find(id);
  if (own == of_.end()) return;
  for (const auto& [name, value] : own->second) {
    std::visit([&, &to = name](const auto& each) { values.set(to, each); }, value);
  }
}

}  // namespace regista::check

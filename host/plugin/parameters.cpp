// SPDX-License-Identifier: MIT
#include "plugin/parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <string_view>
#include <system_error>

#include "config/document_files.hpp"
#include "config/renamed_keys.hpp"
#include "config/scalar.hpp"
#include "plugin/description.hpp"
#include "plugin/shared_object.hpp"
#include "texts/message.hpp"

namespace regista::plugin {
namespace {

namespace fs = std::filesystem;
using config::Node;

constexpr std::uintmax_t largest_parameter_file = 16'000'000;  // bytes

struct Reading {
  const regista_parameter& declared;
  const Node& node;
  std::string what;  // names the parameter in messages

  [[noreturn]] void wrong(const std::string& reason) const { throw config::Error(node.where(), what + ": " + reason); }
};

double in_range(const Reading& reading, double value) {
  const regista_parameter& p = reading.declared;
  if (!(value >= p.minimum && value <= p.maximum)) {
    reading.wrong(fmt::format("{} is outside {}", reading.node.text(), range_text(p)));
  }
  return value;
}

double read_choice(const Reading& reading) {
  const regista_parameter& p = reading.declared;
  const std::string text = config::to_text(reading.node, reading.what);
  for (std::uint32_t i = 0; i < p.choice_count; ++i) {
    if (text == p.choices[i]) return i;
  }
  reading.wrong(texts::unknown("choice", text, "", std::vector<std::string>(p.choices, p.choices + p.choice_count)));
}

std::string content(const Reading& reading, const fs::path& path) {
  std::error_code error;
  const auto wrong = [&](const std::string& reason) { reading.wrong(fmt::format("{}: {}", path.string(), reason)); };
  const std::uintmax_t size = fs::file_size(path, error);
  if (error) wrong(error.message());
  if (size > largest_parameter_file) {
    wrong(fmt::format("has {} bytes; at most {} are read", size, largest_parameter_file));
  }
  std::ifstream stream(path, std::ios::binary);
  if (!stream) wrong(fmt::format("cannot be read: {}", std::generic_category().message(errno)));
  std::string bytes(static_cast<std::size_t>(size), '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(size));
  if (static_cast<std::uintmax_t>(stream.gcount()) != size) wrong("became shorter while it was read");
  return bytes;
}

// Reads the value of a parameter. Writes the value of a text parameter to `text`, and adds a parameter file to `files`.
regista_value read(const Reading& reading, std::string& text, std::vector<FileUsed>& files) {
  regista_value value{};
  switch (reading.declared.type) {
    case REGISTA_TYPE_REAL:
      value.number = in_range(reading, config::to_real(reading.node, reading.what));
      break;
    case REGISTA_TYPE_INTEGER:
      value.number = in_range(reading, static_cast<double>(config::to_integer(reading.node, reading.what)));
      break;
    case REGISTA_TYPE_BOOLEAN:
      value.number = config::to_boolean(reading.node, reading.what) ? 1.0 : 0.0;
      break;
    case REGISTA_TYPE_CHOICE:
      value.number = read_choice(reading);
      break;
    case REGISTA_TYPE_TEXT:
      text = config::to_text(reading.node, reading.what);
      break;
    default: {
      const fs::path path = config::existing_file(reading.node, reading.what);
      text = content(reading, path);
      files.push_back({reading.declared.name, path, content_hash(text)});
    }
  }
  return value;
}

void check_names(const regista_descriptor& plugin, const Node& params, config::Mistakes& mistakes) {
  std::vector<std::string> known;
  for (std::uint32_t i = 0; i < plugin.parameter_count; ++i) known.emplace_back(parameter(plugin, i).name);
  for (const Node::Entry& entry : params.entries()) {
    if (std::ranges::find(known, entry.key) != known.end()) continue;
    if (const std::string_view present = config::present_name(plugin.id, entry.key);
        std::ranges::find(known, present) != known.end()) {
      mistakes.add(config::Error(entry.key_where,
                                 fmt::format("parameter {} of plugin {} is now {}", entry.key, plugin.id, present)),
                   "");
      continue;
    }
    std::string message = texts::unknown("parameter", entry.key, fmt::format("plugin {}", plugin.id), known);
    if (known.empty()) message += "; it has none";
    mistakes.add(config::Error(entry.key_where, message), "");
  }
}

}  // namespace

Parameters resolve(const regista_descriptor& plugin, const config::PluginUse& use) {
  config::Mistakes first(config::Mistakes::After::stop);
  return resolve(plugin, use, first);
}

Parameters resolve(const regista_descriptor& plugin, const config::PluginUse& use, config::Mistakes& mistakes) {
  const Node& params = use.params;
  const Node::Kind kind = params.kind();
  if (kind == Node::Kind::map) {
    check_names(plugin, params, mistakes);
  } else if (kind != Node::Kind::absent && kind != Node::Kind::null) {
    mistakes.attempt("", [&] { config::refuse_kind(params, fmt::format("params of plugin {}", plugin.id), "a map"); });
  }

  auto data = std::make_shared<Parameters::Data>();
  data->values.resize(plugin.parameter_count);
  data->texts.resize(plugin.parameter_count);
  for (std::uint32_t i = 0; i < plugin.parameter_count; ++i) {
    const regista_parameter& declared = parameter(plugin, i);
    regista_value& value = data->values[i];
    std::string& text = data->texts[i];
    const Node node = params[declared.name];
    const bool given = node.kind() != Node::Kind::absent && node.kind() != Node::Kind::null;
    value = {declared.initial, nullptr, 0};
    if (declared.type == REGISTA_TYPE_TEXT) text = declared.initial_text;
    if (given) {
      const Reading reading{declared, node, fmt::format("parameter \"{}\" of plugin {}", declared.name, plugin.id)};
      mistakes.attempt("", [&] { value = read(reading, text, data->files); });
    }
    if (declared.type == REGISTA_TYPE_TEXT || (declared.type == REGISTA_TYPE_FILE && given)) {
      value.text = text.c_str();
      value.text_size = text.size();
    }
  }
  return Parameters(std::move(data));
}

}  // namespace regista::plugin

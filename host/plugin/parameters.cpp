// SPDX-License-Identifier: MIT
#include "plugin/parameters.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string_view>
#include <system_error>

#include "plugin/content_hash.hpp"
#include "plugin/descriptor.hpp"

namespace regista::plugin {
namespace {

namespace fs = std::filesystem;
using config::Node;

// One parameter with the YAML value that is to become its value.
struct Reading {
  const regista_descriptor& plugin;
  const regista_parameter& declared;
  const Node& node;

  [[noreturn]] void wrong(const std::string& what) const {
    throw config::Error(node.where(), fmt::format("parameter \"{}\" of plugin {}: {}", declared.name, plugin.id, what));
  }
};

std::string with_unit(const regista_parameter& declared, const std::string& text) {
  const std::string_view unit = declared.unit;
  return unit.empty() || unit == "1" ? text : fmt::format("{} {}", text, unit);
}

const std::string& scalar(const Reading& reading, std::string_view wanted) {
  if (reading.node.kind() != Node::Kind::scalar) {
    reading.wrong(
        fmt::format("wants {}, not a {}", wanted, reading.node.kind() == Node::Kind::map ? "map" : "sequence"));
  }
  return reading.node.text();
}

template <class Number>
bool parsed(std::string_view text, Number& out, std::errc& error) {
  if (text.starts_with('+')) text.remove_prefix(1);
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), out);
  error = code;
  return !text.empty() && end == text.data() + text.size();
}

double in_range(const Reading& reading, double value) {
  const regista_parameter& p = reading.declared;
  if (!(value >= p.minimum && value <= p.maximum)) {
    reading.wrong(fmt::format("{} is outside {}", value, with_unit(p, fmt::format("{} to {}", p.minimum, p.maximum))));
  }
  return value;
}

double read_real(const Reading& reading) {
  const std::string& text = scalar(reading, "a number");
  double value = 0.0;
  std::errc error{};
  if (text == ".nan" || text == ".inf" || text == "-.inf" || text == "+.inf") {
    reading.wrong(fmt::format("{} is not finite", text));
  }
  if (reading.node.quoted() || !parsed(text, value, error) || (error == std::errc{} && !std::isfinite(value))) {
    reading.wrong(fmt::format("\"{}\" is not a number", text));
  }
  if (error != std::errc{}) reading.wrong(fmt::format("{} is too large or too small for a number", text));
  return in_range(reading, value);
}

double read_integer(const Reading& reading) {
  const std::string& text = scalar(reading, "an integer");
  long long value = 0;
  std::errc error{};
  if (reading.node.quoted() || !parsed(text, value, error)) {
    reading.wrong(fmt::format("\"{}\" is not an integer", text));
  }
  if (error != std::errc{}) reading.wrong(fmt::format("{} is too large for an integer", text));
  return in_range(reading, static_cast<double>(value));
}

double read_boolean(const Reading& reading) {
  const std::string& text = scalar(reading, "true or false");
  if (reading.node.quoted() || (text != "true" && text != "false")) {
    reading.wrong(fmt::format("\"{}\" is neither true nor false", text));
  }
  return text == "true" ? 1.0 : 0.0;
}

double read_choice(const Reading& reading) {
  const regista_parameter& p = reading.declared;
  const std::string& text = scalar(reading, "one word");
  for (std::uint32_t i = 0; i < p.choice_count; ++i) {
    if (text == p.choices[i]) return i;
  }
  const std::span<const char* const> choices(p.choices, p.choice_count);
  reading.wrong(fmt::format("\"{}\" is not one of: {}", text, fmt::join(choices, ", ")));
}

// A relative path is meant from the folder of the YAML file that names it; from the command line, from where one is.
fs::path resolved(const fs::path& name, const config::Location& where) {
  if (name.is_absolute() || where.column == 0) return name;
  return (fs::path(where.file).parent_path() / name).lexically_normal();
}

std::string content(const Reading& reading, const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) reading.wrong(fmt::format("file {} does not exist", path.string()));
  if (!fs::is_regular_file(status)) reading.wrong(fmt::format("{} is not a file", path.string()));
  const std::uintmax_t size = fs::file_size(path, error);
  if (!error && size > largest_parameter_file) {
    reading.wrong(fmt::format("file {} has {:.1f} MB; at most {} MB are read", path.string(),
                              static_cast<double>(size) / 1e6, largest_parameter_file / 1'000'000));
  }
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream bytes;
  if (size > 0) bytes << stream.rdbuf();
  if (!stream) reading.wrong(fmt::format("file {} cannot be read", path.string()));
  return std::move(bytes).str();
}

// The value of `declared` when the YAML says nothing.
regista_value default_of(const regista_parameter& declared, std::string& text) {
  if (declared.type == REGISTA_TYPE_TEXT) text = declared.initial_text;
  return {declared.initial, nullptr, 0};
}

void check_names(const regista_descriptor& plugin, const Node& params) {
  std::vector<std::string_view> known;
  for (std::uint32_t i = 0; i < plugin.parameter_count; ++i) known.emplace_back(parameter(plugin, i).name);
  std::vector<std::string_view> given;
  for (const Node::Entry& entry : params.entries()) {
    if (std::ranges::find(known, entry.key) == known.end()) {
      throw config::Error(entry.key_where, known.empty() ? fmt::format("plugin {} has no parameter \"{}\"; it has none",
                                                                       plugin.id, entry.key)
                                                         : fmt::format("plugin {} has no parameter \"{}\"; it has: {}",
                                                                       plugin.id, entry.key, fmt::join(known, ", ")));
    }
    if (std::ranges::find(given, entry.key) != given.end()) {
      throw config::Error(entry.key_where,
                          fmt::format("parameter \"{}\" of plugin {} is given twice", entry.key, plugin.id));
    }
    given.push_back(entry.key);
  }
}

}  // namespace

Parameters resolve(const regista_descriptor& plugin, const config::PluginUse& use) {
  const Node& params = use.params;
  const bool given = params && params.kind() != Node::Kind::null;
  if (given && params.kind() != Node::Kind::map) {
    throw config::Error(params.where(), fmt::format("params of plugin {} must be a map", plugin.id));
  }
  if (given) check_names(plugin, params);

  auto data = std::make_shared<Parameters::Data>();
  data->values.resize(plugin.parameter_count);
  data->texts.resize(plugin.parameter_count);
  for (std::uint32_t i = 0; i < plugin.parameter_count; ++i) {
    const regista_parameter& declared = parameter(plugin, i);
    regista_value& value = data->values[i];
    std::string& text = data->texts[i];
    const Node node = given ? params[declared.name] : Node();
    bool has_text = declared.type == REGISTA_TYPE_TEXT;
    if (!node || node.kind() == Node::Kind::null) {
      value = default_of(declared, text);
    } else {
      const Reading reading{plugin, declared, node};
      switch (declared.type) {
        case REGISTA_TYPE_REAL:
          value.number = read_real(reading);
          break;
        case REGISTA_TYPE_INTEGER:
          value.number = read_integer(reading);
          break;
        case REGISTA_TYPE_BOOLEAN:
          value.number = read_boolean(reading);
          break;
        case REGISTA_TYPE_CHOICE:
          value.number = read_choice(reading);
          break;
        case REGISTA_TYPE_TEXT:
          text = scalar(reading, "text");
          break;
        default: {
          const fs::path path = resolved(scalar(reading, "the name of a file"), node.where());
          text = content(reading, path);
          has_text = true;
          data->files.push_back({declared.name, path, content_hash(text)});
        }
      }
    }
    if (has_text) {
      value.text = text.c_str();
      value.text_size = text.size();
    }
  }
  return Parameters(std::move(data));
}

}  // namespace regista::plugin

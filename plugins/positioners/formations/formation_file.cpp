// SPDX-License-Identifier: MIT
#include "formation_file.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "formation_text.hpp"
#include "role_list.hpp"

namespace formations {
namespace {

using nlohmann::json;

// Tells how far the parser has come, so that a message can say where.
struct Character {
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;
  const char* at;
  const char** reached;
  const char& operator*() const { return *at; }
  Character& operator++() {
    *reached = ++at;
    return *this;
  }
  friend bool operator==(const Character& a, const Character& b) { return a.at == b.at; }
};

std::string place_in(std::string_view bytes, std::size_t offset) {
  const std::string_view before = bytes.substr(0, offset);
  const std::size_t line = static_cast<std::size_t>(std::ranges::count(before, '\n')) + 1;
  const std::size_t start = before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
  return place(line, offset - start + 1);
}

// Where the text in quotes begins whose end the parser has just passed.
std::string place_of_text(std::string_view bytes, std::size_t passed) {
  std::size_t begin = passed < 2 ? 0 : std::min(bytes.rfind('"', passed - 2), passed);
  while (begin > 0 && bytes[begin - 1] == '\\') begin = bytes.rfind('"', begin - 1);  // a quote inside of the text
  return place_in(bytes, begin);
}

json parsed(std::string_view bytes, std::string& method_place) {
  const char* reached = bytes.data();
  const auto passed = [&] { return static_cast<std::size_t>(reached - bytes.data()); };
  bool is_method = false;
  std::vector<std::set<std::string>> keys;  // of the objects that the parser is in
  const auto look = [&](int depth, json::parse_event_t event, json& value) {
    if (event == json::parse_event_t::object_start) keys.emplace_back();
    if (event == json::parse_event_t::object_end) keys.pop_back();
    if (event == json::parse_event_t::key) {
      if (const auto& key = value.get_ref<const std::string&>(); !keys.back().insert(key).second)
        refuse(place_of_text(bytes, passed()) + ": \"" + key + "\" is given twice");
    }
    if (depth != 1) return true;
    if (event == json::parse_event_t::key) is_method = value == "method";
    if (is_method && value.is_string()) method_place = place_of_text(bytes, passed());
    return true;
  };
  try {
    return json::parse(Character{bytes.data(), &reached}, Character{bytes.data() + bytes.size(), &reached}, look);
  } catch (const json::parse_error& error) {
    refuse(place_in(bytes, std::min(bytes.size(), std::max<std::size_t>(error.byte, 1) - 1)) +
           ": not JSON; expected a formation file of librcsc, in JSON or as text that begins with \"Formation\"");
  } catch (const json::exception&) {
    refuse("a number in it is out of range");
  }
}

const json& member(const json& object, const char* name, const std::string& where) {
  if (!object.is_object()) refuse(where + " is no object");
  const auto found = object.find(name);
  if (found == object.end()) refuse(where + " has no \"" + name + "\"");
  return *found;
}

double coordinate(const json& point, const char* name, const std::string& where) {
  const json& value = member(point, name, where);
  if (!value.is_number()) refuse(where + ": " + name + " is no number");
  return value.get<double>();
}

bool is_static(const json& file, const std::string& where) {
  const json& method = member(file, "method", "the file");
  return method_of(method.is_string() ? method.get<std::string>() : method.dump(), where) == Method::fixed;
}

std::size_t count_positions(const json& file, const json& first) {
  std::size_t count = 0;
  while (first.contains(std::to_string(count + 1))) ++count;
  if (count == 0) refuse("data[0] has no position \"1\"");
  if (count > most_positions) {
    refuse("data[0] has " + std::to_string(count) + " positions; at most " + std::to_string(most_positions) +
           " are read");
  }
  if (file.contains("role")) {
    const json& roles = file["role"];
    if (!roles.is_array()) refuse("\"role\" is no list");
    if (roles.size() != count) {
      refuse("\"role\" names " + std::to_string(roles.size()) + " positions, data[0] has " + std::to_string(count));
    }
  }
  return count;
}

// Git writes a symbolic link so where links cannot be: one short line, a path.
void refuse_link(std::string_view bytes) {
  const std::string_view line = bytes.substr(0, std::min(bytes.find_last_not_of("\r\n") + 1, bytes.size()));
  if (line.size() > 250 || line.find_first_of("{}[]\"<>,: \t\r\n") != std::string_view::npos) return;
  if (line.find_first_of("./") == std::string_view::npos) return;
  refuse("is a symbolic link of git that was checked out as text; name the file that it leads to, " + quoted(line));
}

// The form between text and JSON, of 2019 to 2022.
void refuse_csv(std::string_view bytes) {
  while (bytes.starts_with('#')) bytes.remove_prefix(std::min(bytes.find('\n'), bytes.size() - 1) + 1);
  if (!bytes.starts_with("Method,")) return;
  refuse("has the form " + quoted(bytes.substr(0, bytes.find_first_of("\r\n"))) +
         " of librcsc; read are JSON and text that begins with \"Formation\"");
}

}  // namespace

void refuse(const std::string& message) { throw std::invalid_argument("formation: " + message); }

std::string place(std::size_t line, std::size_t column) {
  return "line " + std::to_string(line) + ", column " + std::to_string(column);
}

Method method_of(std::string_view name, const std::string& where) {
  if (name == "DelaunayTriangulation") return Method::delaunay_triangulation;
  if (name == "Static") return Method::fixed;
  refuse(where + ": its method is " + quoted(name) + "; read are DelaunayTriangulation and Static");
}

Position position_at(double x, double right, const std::string& where) {
  for (const auto& [name, value] : {std::pair('x', x), {'y', right}}) {
    if (!(std::abs(value) <= farthest)) refuse(where + ": " + name + " is farther than 1000 m from the centre");
  }
  return {x + 0.0, 0.0 - right};
}

Sample sample_at(double x, double right, const std::string& where) {
  const Position ball = position_at(x, right, where);
  return {{std::llround(ball.x / grid_step), std::llround(ball.y / grid_step)}, {}};
}

void refuse_repeated_balls(const std::vector<Sample>& samples, std::span<const std::string> names) {
  std::vector<std::size_t> order(samples.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return samples[i].ball; });
  for (std::size_t k = 0; k + 1 < order.size(); ++k) {
    if (samples[order[k]].ball == samples[order[k + 1]].ball) {
      refuse(names[order[k]] + " and " + names[order[k + 1]] + " have the ball at the same place");
    }
  }
}

std::vector<Sample> read_formation(std::string_view bytes) {
  if (bytes.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    refuse("the file is empty; expected a formation file of librcsc");
  }
  if (bytes.size() > most_bytes) {
    refuse("has " + std::to_string(bytes.size()) + " bytes; at most " + std::to_string(most_bytes) + " are read");
  }
  if (is_text_form(bytes)) return read_text_form(bytes);
  refuse_link(bytes);
  refuse_csv(bytes);
  std::string method_place = place(1, 1);
  const json file = parsed(bytes, method_place);
  const bool only_one = is_static(file, method_place);
  const json& data = member(file, "data", "the file");
  if (!data.is_array() || data.empty()) refuse("\"data\" holds no samples");
  if (data.size() > most_samples) {
    refuse("has " + std::to_string(data.size()) + " samples; at most " + std::to_string(most_samples) + " are read");
  }
  if (only_one && data.size() != 1) refuse("is static but has " + std::to_string(data.size()) + " samples");
  const std::size_t count = count_positions(file, data[0]);

  std::vector<Sample> samples;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < data.size(); ++i) {
    const std::string& where = names.emplace_back("data[" + std::to_string(i) + "]");
    const auto at = [&](const std::string& name, const auto& read) {
      const std::string path = where + "." + name;
      const json& point = member(data[i], name.c_str(), where);
      return read(coordinate(point, "x", path), coordinate(point, "y", path), path);
    };
    Sample& sample = samples.emplace_back(at("ball", sample_at));
    for (std::size_t number = 1; number <= count; ++number) {
      sample.positions.push_back(at(std::to_string(number), position_at));
    }
    if (data[i].contains(std::to_string(count + 1))) {
      refuse(where + " has more positions than data[0], which has " + std::to_string(count));
    }
  }
  refuse_repeated_balls(samples, names);
  return samples;
}

}  // namespace formations

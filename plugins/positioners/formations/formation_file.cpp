// SPDX-License-Identifier: MIT
#include "formation_file.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "role_list.hpp"

namespace formations {
namespace {

using nlohmann::json;

[[noreturn]] void wrong(const std::string& message) { throw std::invalid_argument("formation: " + message); }

json parsed(std::string_view bytes) {
  if (bytes.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    wrong("nothing is in it; wanted is a formation file of librcsc (JSON)");
  }
  if (bytes.size() > most_bytes) {
    wrong("has " + std::to_string(bytes.size()) + " bytes; at most " + std::to_string(most_bytes) + " are read");
  }
  try {
    return json::parse(bytes);
  } catch (const json::parse_error& error) {
    const std::string_view before = bytes.substr(0, std::min(bytes.size(), std::max<std::size_t>(error.byte, 1) - 1));
    const auto line = std::ranges::count(before, '\n') + 1;
    const std::size_t start = before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
    wrong("line " + std::to_string(line) + ", column " + std::to_string(before.size() - start + 1) +
          ": no JSON; wanted is a formation file of librcsc in its JSON form");
  } catch (const json::exception&) {
    wrong("a number in it is out of range");
  }
}

const json& member(const json& object, const char* name, const std::string& where) {
  if (!object.is_object()) wrong(where + " is no object");
  const auto found = object.find(name);
  if (found == object.end()) wrong(where + " has no \"" + name + "\"");
  return *found;
}

double coordinate(const json& point, const char* name, const std::string& where) {
  const json& value = member(point, name, where);
  if (!value.is_number()) wrong(where + ": " + name + " is no number");
  const double number = value.get<double>();
  if (!(std::abs(number) <= farthest)) wrong(where + ": " + name + " is farther than 1000 m from the centre");
  return number + 0.0;
}

Position point(const json& value, const std::string& where) {
  const double x = coordinate(value, "x", where), right = coordinate(value, "y", where);
  return {x, 0.0 - right};
}

bool is_static(const json& file) {
  const json& method = member(file, "method", "the file");
  const std::vector<std::string> known{"DelaunayTriangulation", "Static"};
  const std::string name = method.is_string() ? method.get<std::string>().substr(0, 40) : "";
  if (std::ranges::find(known, name) == known.end()) {
    wrong("its \"method\" is not read; the nearest that is: \"" + nearest_name(name, known) + "\"");
  }
  return name == "Static";
}

std::size_t count_positions(const json& file, const json& first) {
  std::size_t count = 0;
  while (first.contains(std::to_string(count + 1))) ++count;
  if (count == 0) wrong("data[0] has no position \"1\"");
  if (count > most_positions) {
    wrong("data[0] has " + std::to_string(count) + " positions; at most " + std::to_string(most_positions) +
          " are read");
  }
  if (file.contains("role")) {
    const json& roles = file["role"];
    if (!roles.is_array()) wrong("\"role\" is no list");
    if (roles.size() != count) {
      wrong("\"role\" names " + std::to_string(roles.size()) + " positions, data[0] has " + std::to_string(count));
    }
  }
  return count;
}

void refuse_repeated_balls(const std::vector<Sample>& samples) {
  std::vector<std::size_t> order(samples.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return samples[i].ball; });
  for (std::size_t k = 0; k + 1 < order.size(); ++k) {
    if (samples[order[k]].ball == samples[order[k + 1]].ball) {
      wrong("data[" + std::to_string(order[k]) + "] and data[" + std::to_string(order[k + 1]) +
            "] have the ball at the same place");
    }
  }
}

}  // namespace

std::vector<Sample> read_formation(std::string_view bytes) {
  const json file = parsed(bytes);
  const bool only_one = is_static(file);
  const json& data = member(file, "data", "the file");
  if (!data.is_array() || data.empty()) wrong("\"data\" holds no samples");
  if (data.size() > most_samples) {
    wrong("has " + std::to_string(data.size()) + " samples; at most " + std::to_string(most_samples) + " are read");
  }
  if (only_one && data.size() != 1) wrong("is static but has " + std::to_string(data.size()) + " samples");
  const std::size_t count = count_positions(file, data[0]);

  std::vector<Sample> samples;
  for (std::size_t i = 0; i < data.size(); ++i) {
    const std::string where = "data[" + std::to_string(i) + "]";
    const Position ball = point(member(data[i], "ball", where), where + ".ball");
    Sample& sample =
        samples.emplace_back(Sample{{std::llround(ball.x / grid_step), std::llround(ball.y / grid_step)}, {}});
    for (std::size_t number = 1; number <= count; ++number) {
      const std::string name = std::to_string(number);
      sample.positions.push_back(point(member(data[i], name.c_str(), where), where + "." + name));
    }
    if (data[i].contains(std::to_string(count + 1))) {
      wrong(where + " has more positions than data[0], which has " + std::to_string(count));
    }
  }
  refuse_repeated_balls(samples);
  return samples;
}

}  // namespace formations

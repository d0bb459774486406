// SPDX-License-Identifier: MIT
#include "campaign/metric_json.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "texts/json.hpp"

namespace regista::campaign {
namespace {

using Json = nlohmann::ordered_json;

constexpr auto roles = "roles";

Json json_of(std::optional<double> number) {
  constexpr double largest = 1e15;  // of whole numbers that are written without a point
  if (!number) return nullptr;
  if (std::abs(*number) < largest && *number == std::round(*number)) return static_cast<std::int64_t>(*number);
  return *number;
}

// What stands at "ball.nees" of an object.
Json& at(Json& object, std::string_view path) {
  const std::size_t point = path.find('.');
  Json& first = object[std::string(path.substr(0, point))];
  return point == std::string_view::npos ? first : at(first, path.substr(point + 1));
}

class Numbers {
 public:
  void read(const Json& object) {
    if (!object.is_object()) refuse("an object");
    for (const auto& [name, member] : object.items()) {
      if (is_number(member)) {
        add({.name = name}, member);
        continue;
      }
      if (!member.is_array() || member.size() != match::both_sides.size()) refuse("a number or an array of two");
      for (const match::Side side : match::both_sides) {
        const Json &own = member[match::index(side)], &other = member[match::index(opposite(side))];
        if (own.is_null() && !is_number(other)) continue;  // only the other side has such numbers
        if (name == roles)
          read_roles(side, own);
        else
          read(match::MetricName{.side = side, .name = name}, own);
      }
    }
  }

  match::MetricNumbers numbers() && {
    return {std::make_shared<const match::MetricNames>(std::move(names_)), std::move(values_)};
  }

 private:
  [[noreturn]] static void refuse(const char* wanted) {
    throw std::invalid_argument(std::string("metrics without ") + wanted + " where there has to be one");
  }
  static bool is_number(const Json& json) { return json.is_number() || json.is_null(); }

  void add(match::MetricName name, const Json& number) {
    names_.push_back(std::move(name));
    values_.push_back(number.is_null() ? std::numeric_limits<double>::quiet_NaN() : number.get<double>());
  }

  void read_roles(match::Side side, const Json& object) {
    if (!object.is_object()) refuse("an object of roles");
    for (const auto& [role, members] : object.items()) {
      if (!members.is_object()) refuse("an object for each role");
      for (const auto& [name, member] : members.items()) {
        read(match::MetricName{.side = side, .role = role, .name = name}, member);
      }
    }
  }

  void read(match::MetricName name, const Json& json) {
    if (is_number(json)) {
      add(std::move(name), json);
    } else if (json.is_array() && name.place == 0) {
      for (const Json& each : json) {
        ++name.place;
        if (!is_number(each)) refuse("a list of numbers");
        add(name, each);
      }
    } else if (json.is_object()) {
      for (const auto& [member, value] : json.items()) {
        match::MetricName below = name;
        below.name += '.' + member;
        read(std::move(below), value);
      }
    } else {
      refuse("a number");
    }
  }

  std::vector<match::MetricName> names_;
  std::vector<double> values_;
};

}  // namespace

void add_metrics(Json& object, const match::MetricNumbers& numbers) {
  if (numbers.empty()) return;
  for (std::size_t i = 0; i < numbers.names().size(); ++i) {
    const match::MetricName& name = numbers.names()[i];
    Json value = json_of(numbers.at(i));
    if (!name.side) {
      object[name.name] = std::move(value);
      continue;
    }
    const std::size_t point = name.role.empty() ? name.name.find('.') : std::string::npos;
    Json& sides = object[name.role.empty() ? name.name.substr(0, point) : roles];
    if (!sides.is_array()) sides = Json::array({nullptr, nullptr});
    Json* place = &sides[match::index(*name.side)];
    if (!name.role.empty()) place = &(*place)[name.role][name.name];
    if (point != std::string::npos) place = &at(*place, std::string_view(name.name).substr(point + 1));
    if (name.place == 0)
      *place = std::move(value);
    else
      place->push_back(std::move(value));
  }
}

match::MetricNumbers metrics_from_json(const Json& object) {
  Numbers numbers;
  numbers.read(object);
  return std::move(numbers).numbers();
}

match::MetricNumbers metrics_from_json(const std::string& text) {
  try {
    return metrics_from_json(Json::parse(text));
  } catch (const Json::exception& error) {
    throw std::invalid_argument(error.what());
  }
}

}  // namespace regista::campaign

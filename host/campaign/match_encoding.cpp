// SPDX-License-Identifier: MIT
#include "campaign/match_encoding.hpp"

#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "match/game_state.hpp"
#include "match/side.hpp"
#include "texts/json.hpp"

namespace regista::campaign {
namespace {

using Json = nlohmann::ordered_json;

constexpr auto roles = "roles";

Json json_of(std::optional<double> number) {
  constexpr double largest = 1e15;  // whole numbers below this limit are written without a point
  if (!number) return nullptr;
  if (std::abs(*number) < largest && *number == std::round(*number)) return static_cast<std::int64_t>(*number);
  return *number;
}

// Returns the member of an object at a path such as "ball.nees".
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
        if (own.is_null() && !is_number(other)) continue;  // only the other side has these numbers
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

constexpr double unit = 1e6;
constexpr double most_units = 9e15;  // in millionths; a double represents whole numbers up to this limit exactly
constexpr std::uint64_t none = 0, raw = 1, first_code = 2;
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

void write(std::string& out, std::uint64_t number) {
  for (; number >= 0x80; number >>= 7) out += static_cast<char>(number | 0x80);
  out += static_cast<char>(number);
}

constexpr double value_of(std::uint64_t code) {
  if (code == none) return nothing;
  const std::uint64_t zigzag = code - first_code;
  const std::int64_t whole = static_cast<std::int64_t>(zigzag >> 1) ^ -static_cast<std::int64_t>(zigzag & 1);
  return static_cast<double>(whole) / unit;
}

// The values of all codes of one byte. Most codes have one byte, and a table is faster than value_of().
constexpr std::array<double, 0x80> values_of_bytes = [] {
  std::array<double, 0x80> out{};
  for (std::uint64_t code = 0; code < out.size(); ++code) out[code] = value_of(code);
  return out;
}();

class Reader {
 public:
  explicit Reader(std::string_view bytes) : at_(bytes.data()), end_(bytes.data() + bytes.size()) {}

  std::uint64_t number() {
    std::uint64_t out = next();
    if (out < 0x80) return out;  // most numbers have one byte
    out &= 0x7f;
    for (int shift = 7; shift < 64; shift += 7) {
      const std::uint64_t byte = next();
      out |= (byte & 0x7f) << shift;
      if (byte < 0x80) return out;
    }
    throw std::invalid_argument("a number of more than 64 bits");
  }

  double real() {
    std::uint64_t bits = 0;
    for (int shift = 0; shift < 64; shift += 8) bits |= next() << shift;
    return std::bit_cast<double>(bits);
  }

  bool at_end() const { return at_ == end_; }

 private:
  std::uint64_t next() {
    if (at_ == end_) throw std::invalid_argument("fewer numbers than names");
    return static_cast<unsigned char>(*at_++);
  }

  const char *at_, *end_;
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

std::string names_text(const match::MetricNames& names) {
  Json out = Json::array();
  for (std::size_t i = 0; i < names.size(); ++i) {
    const match::MetricName& each = names[i];
    Json name = Json::object();
    if (each.side) name["side"] = match::name(*each.side);
    if (!each.role.empty()) name["role"] = each.role;
    name["name"] = each.name;
    if (each.place > 0) name["place"] = each.place;
    out.push_back(std::move(name));
  }
  return out.dump();
}

std::shared_ptr<const match::MetricNames> names_of(const std::string& text) {
  try {
    std::vector<match::MetricName> names;
    for (const Json& each : Json::parse(text)) {
      match::MetricName name{.role = each.value("role", ""), .name = each.at("name"), .place = each.value("place", 0)};
      if (each.contains("side")) {
        const std::string side = each.at("side");
        if (side != match::name(match::Side::home) && side != match::name(match::Side::away)) {
          throw std::invalid_argument("no side is called " + side);
        }
        name.side = side == match::name(match::Side::home) ? match::Side::home : match::Side::away;
      }
      names.push_back(std::move(name));
    }
    return std::make_shared<const match::MetricNames>(std::move(names));
  } catch (const Json::exception& error) {
    throw std::invalid_argument(error.what());
  }
}

std::string number_bytes(std::span<const double> values) {
  std::string out;
  for (const double value : values) {
    const double units = std::round(value * unit);
    if (std::isnan(value)) {
      write(out, none);
    } else if (std::abs(units) < most_units &&
               same_bits(static_cast<double>(static_cast<std::int64_t>(units)) / unit, value)) {
      const auto whole = static_cast<std::int64_t>(units);
      const std::uint64_t zigzag = (static_cast<std::uint64_t>(whole) << 1) ^ static_cast<std::uint64_t>(whole >> 63);
      write(out, zigzag + first_code);
    } else {
      write(out, raw);
      const auto bits = std::bit_cast<std::uint64_t>(value);
      for (int shift = 0; shift < 64; shift += 8) out += static_cast<char>(bits >> shift);
    }
  }
  return out;
}

std::vector<double> numbers_of(std::string_view bytes, std::size_t count) {
  Reader reader(bytes);
  std::vector<double> out(count);
  for (double& value : out) {
    const std::uint64_t code = reader.number();
    value = code == raw ? reader.real() : code < values_of_bytes.size() ? values_of_bytes[code] : value_of(code);
  }
  if (!reader.at_end()) throw std::invalid_argument("more numbers than names");
  return out;
}

std::optional<double> packets_share_of(const match::Setup& setup) {
  if (setup.rules.messages.short_games == config::ShortGames::share) return std::nullopt;  // these rules reduce budgets
  const config::Durations& durations = setup.rules.durations;
  const double whole = durations.half * durations.halves;
  const std::optional<double> length = match::limit_of(setup);
  if (!length || !(*length < whole)) return std::nullopt;
  return setup.rules.messages.budget * *length / whole;
}

match::MetricNumbers numbers_of(const PlayedMatch& match, std::span<const match::MetricRow> table) {
  return match::metric_numbers(table, {match.result, match.packets_share}, match.role_names);
}

nlohmann::ordered_json summary_json(const PlayedMatch& match, std::span<const match::MetricRow> table) {
  const match::Result& result = match.result;
  nlohmann::ordered_json out;
  out["teams"] = match.teams;
  out["score"] = nullptr;  // reserves the place: add_metrics() sets the number
  out["seed"] = match.seed;
  if (!match.opening.empty()) out["opening"] = match.opening;
  out["ended"] = match::name(result.ended);
  out["simulated_seconds"] = nullptr;
  out["wall_seconds"] = match.wall_seconds;
  out["state_hash"] = match::hash_text(result.hash);
  out["failures"] = nlohmann::ordered_json::array();
  add_metrics(out, numbers_of(match, table));
  // Adds an empty list for both sides where a list metric has no values.
  for (const match::MetricRow& row : table) {
    if (row.is_list() && row.of == match::MetricRow::Of::team && !out.contains(row.name)) {
      out[row.name] = {nlohmann::ordered_json::array(), nlohmann::ordered_json::array()};
    }
  }
  return out;
}

}  // namespace regista::campaign

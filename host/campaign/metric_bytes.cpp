// SPDX-License-Identifier: MIT
#include "campaign/metric_bytes.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "match/side.hpp"
#include "texts/json.hpp"

namespace regista::campaign {
namespace {

using Json = nlohmann::ordered_json;

constexpr double unit = 1e6;
constexpr double most_units = 9e15;  // whole numbers up to here are exact as doubles
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

// Of codes of one byte, which most are: a table is faster than to work them out.
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
    if (out < 0x80) return out;  // most
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

}  // namespace regista::campaign

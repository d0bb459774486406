// SPDX-License-Identifier: MIT
#include "study/packets_spent.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace regista::study {
namespace {

using Json = nlohmann::json;

// Takes pairs of numbers from the members of the outermost object, and stops when it has all: the metrics of a match
// are some kilobytes, and these stand near the front.
class PairsOfNumbers : public Json::json_sax_t {
 public:
  const PacketMetrics& found() const { return numbers_; }

  bool null() override { return skip(); }
  bool boolean(bool) override { return skip(); }
  bool string(string_t&) override { return skip(); }
  bool binary(binary_t&) override { return skip(); }
  bool number_integer(number_integer_t value) override { return number(static_cast<double>(value)); }
  bool number_unsigned(number_unsigned_t value) override { return number(static_cast<double>(value)); }
  bool number_float(number_float_t value, const string_t&) override { return number(value); }
  bool start_object(std::size_t) override { return begin(); }
  bool start_array(std::size_t) override { return begin(); }
  bool end_object() override { return end(); }
  bool end_array() override { return end(); }
  bool key(string_t& name) override {
    if (depth_ == 1)
      member_ = static_cast<std::size_t>(std::ranges::find(packet_metrics, name) - packet_metrics.begin());
    return true;
  }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception& error) override {
    throw std::invalid_argument(error.what());
  }

 private:
  bool skip() {
    if (depth_ == 2) ++place_;
    return true;
  }
  bool begin() {
    skip();
    if (++depth_ == 2) place_ = 0;
    return true;
  }
  bool end() {
    --depth_;
    return true;
  }
  bool number(double value) {
    if (depth_ == 2 && member_ < numbers_.size() && place_ < 2) {
      numbers_[member_][place_] = value;
      --left_;
    }
    skip();
    return left_ > 0;
  }

  PacketMetrics numbers_;
  std::size_t left_ = 2 * packet_metrics.size(), depth_ = 0, place_ = 0;
  std::size_t member_ = packet_metrics.size();  // of the outermost object; this: another one
};

}  // namespace

PacketMetrics packet_metrics_of(const std::string& metrics) {
  PairsOfNumbers pairs;
  Json::sax_parse(metrics, &pairs);
  return pairs.found();
}

std::optional<std::array<ShortGamePackets, 2>> short_game_packets(const std::string& metrics) {
  const auto [spent, share, over] = packet_metrics_of(metrics);
  std::array<ShortGamePackets, 2> out;
  for (const std::size_t side : {0u, 1u}) {
    if (!spent[side] || !share[side] || !over[side]) return std::nullopt;
    out[side] = {*spent[side], *share[side], *over[side]};
  }
  return out;
}

void PacketsSpent::add(const ShortGamePackets& game) {
  spent_.add(game.spent);
  share_.add(game.share);
  over_.add(game.over);
}

}  // namespace regista::study

// SPDX-License-Identifier: MIT
#include "cluster/batch.hpp"

#include <algorithm>
#include <stdexcept>

#include "config/json.hpp"

namespace regista::cluster {

std::uint64_t Batch::matches() const {
  std::uint64_t out = 0;
  for (const Slice& each : slices) out += each.end - each.begin;
  return out;
}

std::vector<Slice> divided(const std::vector<Slice>& places, std::uint64_t matches, std::uint64_t tasks) {
  std::vector<Slice> out;
  for (Slice rest : places) {
    while (rest.begin < rest.end) {
      if (out.size() == tasks) return out;
      const std::uint64_t end = std::min(rest.begin + matches, rest.end);
      out.push_back({rest.begin, end});
      rest.begin = end;
    }
  }
  return out;
}

std::string to_json(const Batch& batch) {
  nlohmann::ordered_json slices = nlohmann::ordered_json::array();
  for (const Slice& each : batch.slices) slices.push_back({each.begin, each.end});
  return nlohmann::ordered_json{{"first_row", batch.first_row}, {"slices", slices}}.dump() + '\n';
}

Batch batch_from_json(const std::string& text) {
  try {
    const auto json = nlohmann::json::parse(text);
    Batch out;
    json.at("first_row").get_to(out.first_row);
    for (const auto& each : json.at("slices")) {
      const Slice slice{each.at(0).get<std::uint64_t>(), each.at(1).get<std::uint64_t>()};
      if (slice.begin >= slice.end) throw std::invalid_argument("a slice without a match");
      out.slices.push_back(slice);
    }
    return out;
  } catch (const nlohmann::json::exception&) {
    throw std::invalid_argument("no batch of a study");
  }
}

}  // namespace regista::cluster

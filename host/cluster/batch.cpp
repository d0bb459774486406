// SPDX-License-Identifier: MIT
#include "cluster/batch.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "texts/json.hpp"

namespace regista::cluster {

std::uint64_t matches_of(const Slices& slices) {
  std::uint64_t out = 0;
  for (const Slice& each : slices) out += each.end - each.begin;
  return out;
}

std::uint64_t Batch::matches() const {
  std::uint64_t out = 0;
  for (const Slices& each : tasks) out += matches_of(each);
  return out;
}

std::vector<Slices> shared_out(const Slices& places, const std::vector<std::uint64_t>& twice, std::uint64_t most,
                               std::uint64_t tasks) {
  const std::uint64_t all = matches_of(places) + (weight_of_twice - 1) * twice.size();
  const std::uint64_t load = std::min(all, most * tasks);
  std::vector<Slices> out;
  std::uint64_t before = 0;  // weight of all places before this one
  std::uint64_t last = 0;    // the task of the one before it
  auto heavy = twice.begin();
  for (const Slice& places_in_a_row : places) {
    for (std::uint64_t place = places_in_a_row.begin; place < places_in_a_row.end; ++place) {
      if (before >= load) return out;
      const std::uint64_t task = before * tasks / load;
      if (out.empty() || task != last) out.emplace_back();
      last = task;
      if (!out.back().empty() && out.back().back().end == place)
        ++out.back().back().end;
      else
        out.back().push_back({place, place + 1});
      const bool is_heavy = heavy != twice.end() && *heavy == place;
      if (is_heavy) ++heavy;
      before += is_heavy ? weight_of_twice : 1;
    }
  }
  return out;
}

std::string to_json(const Batch& batch) {
  nlohmann::ordered_json tasks = nlohmann::ordered_json::array();
  for (const Slices& slices : batch.tasks) {
    nlohmann::ordered_json task = nlohmann::ordered_json::array();
    for (const Slice& each : slices) task.push_back({each.begin, each.end});
    tasks.push_back(task);
  }
  return nlohmann::ordered_json{
             {"first_row", batch.first_row}, {"may_end_early", batch.may_end_early}, {"tasks", tasks}}
             .dump() +
         '\n';
}

Batch batch_from_json(const std::string& text) {
  try {
    const auto json = nlohmann::json::parse(text);
    Batch out;
    json.at("first_row").get_to(out.first_row);
    json.at("may_end_early").get_to(out.may_end_early);
    for (const auto& task : json.at("tasks")) {
      Slices slices;
      for (const auto& each : task) {
        const Slice slice{each.at(0).get<std::uint64_t>(), each.at(1).get<std::uint64_t>()};
        if (slice.begin >= slice.end || (!slices.empty() && slice.begin < slices.back().end))
          throw std::invalid_argument("the slices of a task do not ascend");
        slices.push_back(slice);
      }
      if (slices.empty()) throw std::invalid_argument("a task without a match");
      out.tasks.push_back(std::move(slices));
    }
    return out;
  } catch (const nlohmann::json::exception&) {
    throw std::invalid_argument("no batch of a study");
  }
}

}  // namespace regista::cluster

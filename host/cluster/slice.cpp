// SPDX-License-Identifier: MIT
#include "cluster/slice.hpp"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "study/study.hpp"
#include "texts/json.hpp"

namespace regista::cluster {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Course, done, all, fresh, failed, seconds, ended, node)

namespace {

// The fixtures that these places need, and no others: a league has thousands. Their numbers in the file, by their place
// in the round.
std::vector<std::int64_t> numbers_of(const study::Round& round, const Slices& slices, campaign::Store& part) {
  std::vector<bool> needed(round.fixtures.size());
  for (const Slice& slice : slices) {
    for (std::uint64_t index = slice.begin; index < slice.end; ++index) {
      if (const auto place = round.at(index)) needed[place->fixture] = true;
    }
  }
  std::vector<campaign::Store::Fixture> fixtures;
  for (std::size_t i = 0; i < needed.size(); ++i) {
    if (needed[i]) fixtures.push_back(round.fixtures[i]);
  }
  const std::vector<std::int64_t> added = part.add(fixtures);
  std::vector<std::int64_t> out(needed.size());
  for (std::size_t i = 0, next = 0; i < needed.size(); ++i) {
    if (needed[i]) out[i] = added[next++];
  }
  return out;
}

// A schedule from the first place to the last. What lies between two slices is not wanted.
campaign::Finish play(const study::Round& round, const study::Study& study, campaign::Store& part,
                      const SliceOrder& order) {
  const Slices& slices = order.slices;
  if (slices.empty()) throw study::StudyError("the task has no match");
  if (slices.back().end > round.matches)
    throw study::StudyError("the study asks for fewer matches than the batch says");
  const std::vector<std::int64_t> numbers = numbers_of(round, slices, part);
  const std::uint64_t first = slices.front().begin;
  const auto is_wanted = [&](std::uint64_t place) {
    const auto after = std::ranges::upper_bound(slices, place, {}, &Slice::begin);
    return after != slices.begin() && place < std::prev(after)->end;
  };
  const auto row = [&](std::uint64_t index) { return round.first_row + first + index + 1; };
  const auto began = std::chrono::steady_clock::now();
  Course course;
  course.all = matches_of(slices);
  campaign::Schedule schedule;
  schedule.matches = slices.back().end - first;
  schedule.first_row = round.first_row + first;
  schedule.at = [&](std::uint64_t index) -> std::optional<campaign::MatchKey> {
    if (!is_wanted(first + index)) return std::nullopt;
    const auto place = round.at(first + index);
    if (!place) return std::nullopt;
    return campaign::MatchKey{numbers[place->fixture], place->seed};
  };
  schedule.job = [&](std::uint64_t index) { return order.job(round.job(first + index), row(index)); };
  schedule.take = [&](std::uint64_t index, const campaign::Decided* decided, bool fresh) {
    if (!is_wanted(first + index)) return true;
    ++course.done;
    course.fresh += fresh ? 1 : 0;
    if (decided != nullptr && (decided->failure || decided->set_aside())) ++course.failed;
    course.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    course.ended = course.done == course.all;
    if (order.course) order.course(course);
    return true;
  };
  if (round.first_of_pairing) {
    schedule.twice = [&](std::uint64_t index) { return round.first_of_pairing(first + index); };
  }
  if (order.record_failure) {
    schedule.record_failure = [&](std::uint64_t index) { return order.record_failure(row(index)); };
  }
  schedule.asked_to_stop = order.asked_to_stop;
  return campaign::run(schedule, part, order.workers, study.limits());
}

}  // namespace

campaign::Finish play_slice(study::Study& study, const campaign::Store& known, campaign::Store& part,
                            const SliceOrder& order) {
  struct Played {
    campaign::Finish finish;
  };
  const study::PlayRound answer = [&](const study::Round& round) {
    if (round.first_row >= order.first_row) throw Played{play(round, study, part, order)};
    if (!study::answer_from(known, round, study.metrics()))
      throw study::StudyError("a match of an earlier round is missing");
  };
  try {
    study.run(answer);
  } catch (const Played& played) {
    return played.finish;
  }
  throw study::StudyError("the study has ended before the round of this batch");
}

std::string to_json(const Course& course) {
  return nlohmann::json(course).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
}

Course course_from_json(const std::string& text) {
  try {
    return nlohmann::json::parse(text).get<Course>();
  } catch (const nlohmann::json::exception&) {
    throw std::invalid_argument("no course of a task");
  }
}

}  // namespace regista::cluster

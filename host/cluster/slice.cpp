// SPDX-License-Identifier: MIT
#include "cluster/slice.hpp"

#include <chrono>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "config/json.hpp"
#include "study/study.hpp"

namespace regista::cluster {
namespace {

campaign::Finish play(const study::Round& round, const study::Study& study, campaign::Store& part,
                      const SliceOrder& order) {
  const Slice slice = order.slice;
  if (slice.end > round.matches) throw study::StudyError("the study asks for fewer matches than the batch says");
  const std::vector<std::int64_t> numbers = part.add(round.fixtures);
  const auto row = [&](std::uint64_t index) { return round.first_row + slice.begin + index + 1; };
  const auto began = std::chrono::steady_clock::now();
  Course course;
  course.all = slice.end - slice.begin;
  campaign::Schedule schedule;
  schedule.matches = course.all;
  schedule.first_row = round.first_row + slice.begin;
  schedule.at = [&](std::uint64_t index) -> std::optional<campaign::MatchKey> {
    const auto place = round.at(slice.begin + index);
    if (!place) return std::nullopt;
    return campaign::MatchKey{numbers[place->fixture], place->seed};
  };
  schedule.job = [&](std::uint64_t index) { return order.job(round.job(slice.begin + index), row(index)); };
  schedule.take = [&](std::uint64_t, const campaign::Decided* decided, bool fresh) {
    ++course.done;
    course.fresh += fresh ? 1 : 0;
    if (decided != nullptr && (decided->failure || decided->set_aside())) ++course.failed;
    course.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    course.ended = course.done == course.all;
    if (order.course) order.course(course);
    return true;
  };
  if (round.first_of_pairing) {
    schedule.twice = [&](std::uint64_t index) { return round.first_of_pairing(slice.begin + index); };
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
  return nlohmann::ordered_json{{"done", course.done},     {"all", course.all},         {"fresh", course.fresh},
                                {"failed", course.failed}, {"seconds", course.seconds}, {"ended", course.ended},
                                {"node", course.node}}
             .dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) +
         '\n';
}

Course course_from_json(const std::string& text) {
  try {
    const auto json = nlohmann::json::parse(text);
    Course out;
    json.at("done").get_to(out.done);
    json.at("all").get_to(out.all);
    json.at("fresh").get_to(out.fresh);
    json.at("failed").get_to(out.failed);
    json.at("seconds").get_to(out.seconds);
    json.at("ended").get_to(out.ended);
    json.at("node").get_to(out.node);
    return out;
  } catch (const nlohmann::json::exception&) {
    throw std::invalid_argument("no course of a task");
  }
}

}  // namespace regista::cluster

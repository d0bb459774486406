// SPDX-License-Identifier: MIT
#include "report/evaluation_report.hpp"

#include <fmt/format.h>

#include <string_view>
#include <utility>
#include <vector>

#include "config/values.hpp"
#include "report/number.hpp"
#include "texts/json.hpp"
#include "texts/message.hpp"

namespace regista::report {
namespace {

constexpr double per_metre = 1000.0;  // millimetres per metre

template <class Value>
std::string row(std::string_view name, const study::Evaluation& evaluation, Value value) {
  std::string line = fmt::format("  {:<24}", name);
  for (const study::AtHorizon& each : evaluation.horizons) line += fmt::format("{:>19}", value(each));
  return line + '\n';
}

std::string both(const study::Errors& errors, std::size_t answers) {
  if (answers == 0) return "-";
  return fmt::format("{:.1f} / {:.0f}", per_metre * errors.median, per_metre * errors.ninetieth);
}

template <class Value>
std::string consistency_row(std::string_view name, const study::Evaluation& evaluation, Value value) {
  return row(name, evaluation, [&](const study::AtHorizon& each) {
    return each.answers == 0 ? std::string("-") : value(each.consistency);
  });
}

Json document_of(config::PredictorStudy study) { return config::to_json(config::values_of(declare(study))); }

Json errors_json(const study::Errors& errors) {
  return {{"median", errors.median}, {"ninetieth_percentile", errors.ninetieth}};
}

// What a reader must not overlook: questions without an answer, errors above the baseline, ellipses that do not hold.
std::vector<std::string> notes(const config::PredictorStudy& study, const study::Evaluation& evaluation) {
  constexpr double few = 0.95, least = 0.9, most = 0.98;  // shares: of answers, and inside 95 % ellipses
  const bool is_ball = study.subject == config::PredictorStudy::Subject::ball;
  std::vector<std::string> out;
  for (const study::AtHorizon& at : evaluation.horizons) {
    const double answered = at.truths == 0 ? 1.0 : static_cast<double>(at.answers) / static_cast<double>(at.truths);
    if (answered < few) {
      out.push_back(
          fmt::format("{:g} s ahead: {} reported no track for {:.0f} % of the truths; it had too little to go by",
                      at.horizon, study.predictor.plugin, 100.0 * (1.0 - answered)));
    }
    if (at.answers == 0) continue;
    const study::ErrorRatio& median = at.to_decayed.median;
    const bool is_worse = median.low > 1.0;
    const double inside = is_ball && at.untouched > 0 ? at.untouched_within_95 : at.consistency.within_95;
    if (!is_worse && (!is_ball || at.untouched == 0 || (inside >= least && inside <= most))) continue;
    std::string note = fmt::format("{:g} s ahead: ", at.horizon);
    if (is_worse) note += fmt::format("median error {:.2f} of that of decayed velocity", median.value);
    const std::string_view whose = is_ball && at.untouched > 0 ? " of untouched balls" : "";
    if (inside < least) {
      note += fmt::format("{}its 95 % ellipses hold {:.0f} %{}: it takes the motion for more regular than it is",
                          is_worse ? "; " : "", 100.0 * inside, whose);
    } else if (inside > most) {
      note += fmt::format("{}its 95 % ellipses hold {:.0f} %{}: it takes the motion for less regular than it is",
                          is_worse ? "; " : "", 100.0 * inside, whose);
    }
    out.push_back(std::move(note));
  }
  return out;
}

}  // namespace

std::string evaluation_text(const config::PredictorStudy& study, const Evaluated& evaluated,
                            const study::Evaluation& evaluation) {
  using study::AtHorizon;
  using study::Consistency;
  std::string out = fmt::format(
      "Evaluated: {} ({}, version {:.8}) by {} ({}) on {}, with Regista {}\n{} detections, {} of them shown; {} "
      "starts\n\n",
      study.predictor.plugin, texts::visible(evaluated.predictor), evaluated.hash, study.name,
      texts::visible(evaluated.file), texts::visible(evaluated.data), evaluated.program, evaluation.detections,
      evaluation.observations, evaluation.starts);
  out += row("seconds ahead", evaluation, [](const AtHorizon& at) { return fmt::format("{:g}", at.horizon); });
  out += "error in mm: median / 90th percentile\n";
  out += row(study.predictor.plugin, evaluation, [](const AtHorizon& at) { return both(at.predictor, at.answers); });
  out += row("hold last", evaluation, [](const AtHorizon& at) { return both(at.hold, at.truths); });
  out += row("constant velocity", evaluation, [](const AtHorizon& at) { return both(at.constant, at.truths); });
  out += row("decayed velocity", evaluation, [](const AtHorizon& at) { return both(at.decayed, at.truths); });
  const auto ratio = [&](std::string_view name, study::ErrorRatio study::ErrorRatios::*quantile) {
    return row(name, evaluation, [&](const AtHorizon& at) {
      const study::ErrorRatio& each = at.to_decayed.*quantile;
      return at.answers == 0 ? "-" : fmt::format("{:.2f} [{:.2f}, {:.2f}]", each.value, each.low, each.high);
    });
  };
  out += fmt::format("{} / decayed velocity [95 % interval, blocks of play drawn anew]\n", study.predictor.plugin);
  out += ratio("median", &study::ErrorRatios::median);
  out += ratio("90th percentile", &study::ErrorRatios::ninetieth);
  out += row("truths", evaluation, [](const AtHorizon& at) { return fmt::format("{}", at.truths); });
  out += row("answered", evaluation, [](const AtHorizon& at) {
    const double share = at.truths == 0 ? 0.0 : static_cast<double>(at.answers) / static_cast<double>(at.truths);
    return fmt::format("{:.1f} %", 100.0 * share);
  });
  out += "covariance: share of truths within its ellipses; normalised error squared (2, median 1.39)\n";
  const auto percent = [](double share) { return fmt::format("{:.1f} %", 100.0 * share); };
  out += consistency_row("50 %", evaluation, [&](const Consistency& each) { return percent(each.within_50); });
  out += consistency_row("90 %", evaluation, [&](const Consistency& each) { return percent(each.within_90); });
  out += consistency_row("95 %", evaluation, [&](const Consistency& each) { return percent(each.within_95); });
  if (study.subject == config::PredictorStudy::Subject::ball) {
    out += row("95 %, ball not touched", evaluation, [&](const AtHorizon& at) {
      return at.untouched == 0 ? std::string("-") : percent(at.untouched_within_95);
    });
  }
  out += consistency_row("NEES mean / median", evaluation, [](const Consistency& each) {
    return fmt::format("{:.2f} / {:.2f}", each.nees_mean, each.nees_median);
  });
  for (const std::string& each : notes(study, evaluation)) out += "note: " + each + '\n';
  return out;
}

std::string evaluation_json(const config::PredictorStudy& study, const Evaluated& evaluated,
                            const study::Evaluation& evaluation) {
  Json out{{"study", study.name},
           {"predictor", study.predictor.plugin},
           {"data", evaluated.data},
           {"evaluated",
            {{"file", evaluated.file},
             {"predictor", {{"file", evaluated.predictor}, {"hash", evaluated.hash}}},
             {"program", evaluated.program},
             {"document", document_of(study)}}},
           {"detections", evaluation.detections},
           {"observations", evaluation.observations},
           {"starts", evaluation.starts},
           {"horizons", Json::array()}};
  for (const study::AtHorizon& at : evaluation.horizons) {
    Json each{{"seconds", at.horizon}, {"truths", at.truths}, {"answers", at.answers}};
    each["error_m"] = {
        {"hold", errors_json(at.hold)}, {"constant", errors_json(at.constant)}, {"decayed", errors_json(at.decayed)}};
    if (at.answers > 0) {
      const study::Consistency& c = at.consistency;
      each["error_m"]["predictor"] = errors_json(at.predictor);
      const auto ratio = [](const study::ErrorRatio& of) -> Json {
        return {{"value", of.value}, {"interval", {of.low, of.high}}};
      };
      each["to_decayed"] = {{"median", ratio(at.to_decayed.median)},
                            {"ninetieth_percentile", ratio(at.to_decayed.ninetieth)}};
      each["covariance"] = {{"within_50", c.within_50},
                            {"within_90", c.within_90},
                            {"within_95", c.within_95},
                            {"nees_mean", c.nees_mean},
                            {"nees_median", c.nees_median}};
      if (at.untouched > 0) {
        each["covariance"]["untouched"] = at.untouched;
        each["covariance"]["untouched_within_95"] = at.untouched_within_95;
      }
    }
    out["horizons"].push_back(std::move(each));
  }
  out["notes"] = notes(study, evaluation);
  return text_of(out, 2);
}

}  // namespace regista::report

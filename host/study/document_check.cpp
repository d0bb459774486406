// SPDX-License-Identifier: MIT
#include "study/document_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <optional>
#include <sstream>
#include <string_view>

#include "config/bad_input.hpp"
#include "config/file.hpp"
#include "config/team_size.hpp"
#include "mind/mind.hpp"
#include "mind/team_plan.hpp"
#include "plugin/failure.hpp"
#include "study/experiment_setup.hpp"
#include "study/prediction/forecast.hpp"
#include "study/scenes_check.hpp"
#include "study/tournament_setup.hpp"
#include "study/tuning/tuning_setup.hpp"
#include "texts/message.hpp"

namespace regista::study {
namespace {

DocumentMistake of_file(const std::string& file, const std::string& message, const std::string& line) {
  DocumentMistake out;
  out.where.file = file;
  out.message = message;
  out.line = line;
  return out;
}

// What a document says of itself in its head: "# Sketch: what is not right yet".
std::optional<config::Warning> sketch_remark(const std::string& file) {
  if (!std::filesystem::is_regular_file(file)) return std::nullopt;  // a pipe is read once
  std::istringstream head(config::file_content(file).value_or(""));
  constexpr std::string_view mark = "# Sketch: ";
  std::string line;
  for (int number = 1; std::getline(head, line) && line.starts_with('#'); ++number) {
    if (line.starts_with(mark))
      return config::Warning{{file, number, 1}, "a sketch: " + texts::one_line(line.substr(mark.size()))};
  }
  return std::nullopt;
}

class Checker {
 public:
  Checker(const Profiles& by, const plugin::Catalogue& catalogue, std::span<const StudyCheck> studies)
      : by_(by), catalogue_(catalogue), studies_(studies) {}

  DocumentCheck check(const std::string& file) const {
    DocumentCheck out;
    out.file = file;
    if (const auto remark = sketch_remark(file)) out.warnings.push_back(*remark);
    config::Mistakes mistakes(config::Mistakes::After::go_on);
    std::vector<DocumentMistake> others;
    try {
      mistakes.attempt("", [&] { look_at(config::load(file), out, mistakes); });
    } catch (const config::BadInput& error) {
      others.push_back(of_file(file, error.what(), error.what()));
    } catch (const plugin::Failure& failure) {
      others.push_back(of_file(file, failure.what(), fmt::format("{}: {}", file, failure.what())));
    }
    for (const config::Error& each : mistakes.in_order(file)) {
      out.mistakes.push_back({each.where(), each.message(), each.what()});
    }
    out.more = mistakes.total() - out.mistakes.size();
    std::ranges::move(others, std::back_inserter(out.mistakes));
    return out;
  }

 private:
  void look_at(const config::Node& document, DocumentCheck& out, config::Mistakes& mistakes) const {
    using config::DocumentKind;
    const auto study = std::ranges::find_if(
        studies_, [&](const StudyCheck& each) { return static_cast<bool>(document[each.document.name]); });
    const DocumentKind& kind = study != studies_.end() ? study->document : config::kind_of(document);
    out.kind = kind.name;
    if (kind == DocumentKind::team) return look_at_team(document, out, mistakes);
    kind.with_values(document, mistakes, [](const config::Map&) {});
    if (kind == DocumentKind::opening)
      config::check(config::read_document<config::Opening>(document, mistakes), by_.rules, by_.robots, document,
                    mistakes);
    if (!mistakes.none()) return;
    // What is sound in itself: whether it can be planned.
    if (kind == DocumentKind::predictor_study)
      const Forecaster forecaster(config::read_document<config::PredictorStudy>(document), catalogue_);
    if (study != studies_.end()) study->check(document, mistakes);
  }

  void look_at_team(const config::Node& document, DocumentCheck& out, config::Mistakes& mistakes) const {
    const config::Team team = config::read_document<config::Team>(document, mistakes);
    config::check(team, by_.rules, document, mistakes);
    const mind::TeamPlan plan(team, by_.rules, by_.robots[0], catalogue_, mistakes);  // what is wrong with plugins
    if (!mistakes.none()) return;
    const mind::Mind first(plan, 1, 0);  // and what they refuse, files too
    std::ranges::move(config::warnings(team, by_.rules, document), std::back_inserter(out.warnings));
    std::ranges::move(scenes_check(plan), std::back_inserter(out.warnings));
  }

  const Profiles& by_;
  const plugin::Catalogue& catalogue_;
  std::span<const StudyCheck> studies_;
};

}  // namespace

DocumentCheck check_document(const std::string& file, const Profiles& played_by, const plugin::Catalogue& catalogue,
                             std::span<const StudyCheck> studies) {
  return Checker(played_by, catalogue, studies).check(file);
}

}  // namespace regista::study

#include "report/tuning.hpp"
#include "report/tuning_figures.hpp"
#include "report/tuning_page.hpp"
#include <fmt/format.h>
namespace regista::report {
std::string tuning_standing(const TuningView& v) { return fmt::format("stage {}\n", v.record.stage ? (int)*v.record.stage : -1); }
std::string tuning_text(const TuningView& v) {
  std::string out;
  for (const auto& f : v.record.finalists) out += fmt::format("finalist {} selected {}\n", fmt::format("{}", f.values.front()), f.selected.score.mean);
  for (std::size_t i = 0; i < v.record.verification.of().size(); ++i) { const auto& d = v.record.verification.of()[i]; out += fmt::format("candidate {} base {} diff {} [{}, {}] p {} pairs {}\n", d.candidate().mean(), d.base().mean(), d.estimate().value, d.estimate().interval.low, d.estimate().interval.high, d.p(), v.record.verification.pairs()); }
  for (const auto& s : v.record.slices) { out += fmt::format("slice {} importance {} p {}:", v.plan.parameters[s.parameter].path, s.importance, s.p.value_or(-1)); for (auto& p : s.points) out += fmt::format(" {}:{:.3f}", p.value, p.score.mean); out += "\n"; }
  for (const auto& c : v.record.compared) out += fmt::format("{} {} judged {}\n", study::name(c.algorithm), c.repeat, c.judged.mean);
  return out; }
std::string tuning_json(const TuningView&) { return "{}\n"; }
std::string tuning_csv(const TuningView& v) { std::string out; for (const auto& s : v.record.trace) { out += fmt::format("{},{},{},{},{}", s.evaluation, s.pairs_from, s.played.counted, s.best, s.matches); for (double x : s.values) out += fmt::format(",{}", x); out += "\n"; } return out; }
std::vector<std::string> tuning_arguments(const study::TuningPlan& p) { return {"tune", p.file}; }
std::vector<Figure> tuning_figures(const TuningView&) { return {}; }
std::string tuning_page(const TuningPage&) { return ""; }
}

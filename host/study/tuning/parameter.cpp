// SPDX-License-Identifier: MIT
#include "study/tuning/parameter.hpp"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "config/overlay.hpp"
#include "config/scalar.hpp"
#include "config/team_document.hpp"
#include "texts/message.hpp"

namespace regista::study {
namespace {

using config::Node;
using config::PluginParameter;

class Collector {
 public:
  explicit Collector(std::span<const config::PluginDeclaration> plugins) : plugins_(plugins) {}

  // Adds the parameters of one plugin. use: the node at `path`. said(key): whether the document sets `key` below
  // `path`. usual: id of the plugin if `use` names none.
  template <class Said>
  void plugin(const std::string& path, const char* kind, const Node& use, Said said, const std::string& usual = "") {
    const Node named = use["plugin"];
    const std::string id = named ? named.text() : usual;
    const auto declared = std::ranges::find_if(
        plugins_, [&](const config::PluginDeclaration& each) { return each.id == id && each.kind == kind; });
    if (declared == plugins_.end()) return;
    for (const PluginParameter& each : declared->parameters) {
      const bool number = each.type == PluginParameter::Type::real || each.type == PluginParameter::Type::integer;
      const Node value = use["params"][each.name];
      const std::string at = fmt::format("{}.params.{}", path, each.name);
      const double start = number && value.kind() == Node::Kind::scalar ? config::to_real(value, at) : each.initial;
      Tunable& out = found_.emplace_back(
          Tunable{{at, start, each.minimum, each.maximum, each.type == PluginParameter::Type::integer, each.log_scale,
                   each.unit, each.doc},
                  "",
                  said("plugin") || said("params." + each.name)});
      if (!number) {
        out.refusal = fmt::format("plugin {} declares it as something else than a number", declared->id);
      } else if (!each.tunable) {
        out.refusal = fmt::format("plugin {} does not declare it tunable", declared->id);
      }
    }
  }

  // Adds the parameters of a coordination. before: beginning of all paths: "" for the team, "contexts.search.use." for
  // a context. use: the context's own values.
  void coordination(const std::string& before, const Node& values, const Node& use) {
    const auto below = [&](const std::string& path) {
      return [&before, &use, path](const std::string& key) {
        return before.empty() || config::value_at(use, fmt::format("{}.{}", path, key));
      };
    };
    plugin(fmt::format("{}positioner", before), "positioner", values["positioner"], below("positioner"));
    for (const Node::Entry& term : values["utility"]["terms"].entries()) {
      const std::string path = fmt::format("utility.terms.{}", term.key);
      const std::string whole = fmt::format("{}{}", before, path);
      const auto said = below(path);
      weight(whole, term.value, said("plugin") || said("weight") || said("tune"));
      plugin(whole, "utility", term.value, said);
    }
    plugin(fmt::format("{}assigner", before), "assigner", values["assigner"], below("assigner"));
    plugin(fmt::format("{}sender", before), "sender", values["sender"], below("sender"));
  }

  // First adds the behaviours that the document lists, then the other behaviours that its roles may use.
  void behaviours(const Node& team) {
    const auto path_of = [](const std::string& name) { return fmt::format("behaviours.{}", name); };
    const Node written = team["behaviours"];
    for (const Node::Entry& each : written.entries()) {
      plugin(
          path_of(each.key), "behaviour", each.value, [](const std::string&) { return true; }, each.key);
    }
    const Node without_role = team["behaviour_without_role"];
    std::set<std::string> named{without_role ? without_role.text() : config::Team{}.behaviour_without_role};
    for (const Node::Entry& list : team["roles"].entries()) {
      for (const Node& role : list.value.elements()) {
        if (role["behaviour"]) {
          named.insert(role["behaviour"].text());
        } else {
          named.insert({"keep_goal", "play_ball", "support"});
        }
      }
    }
    for (const std::string& each : named) {
      if (!written[each])
        plugin(
            path_of(each), "behaviour", {}, [](const std::string&) { return false; }, each);
    }
  }

  std::vector<Tunable> take() { return std::move(found_); }

 private:
  void weight(const std::string& path, const Node& term, bool said) {
    Tunable& out = found_.emplace_back();
    out.path = fmt::format("{}.weight", path);
    out.start = term["weight"] ? config::to_real(term["weight"], out.path) : config::UtilityTerm{}.weight;
    const auto range = term["tune"].elements();
    if (range.size() == 2) {
      out.least = config::to_real(range[0], out.path);
      out.most = config::to_real(range[1], out.path);
    } else {
      out.refusal = "its term has no `tune: [least, largest]`";
    }
    out.unit = "1";
    out.doc = "weight of this term in the sum";
    out.said = said;
  }

  std::span<const config::PluginDeclaration> plugins_;
  std::vector<Tunable> found_;
};

bool is_pattern(const std::string& path) { return path.find_first_of("*?[") != std::string::npos; }

[[noreturn]] void refuse_unknown(const config::TunedPath& asked, std::span<const Tunable> all) {
  constexpr std::size_t shown = 3;
  std::vector<std::string> known;
  for (const Tunable& each : all) {
    if (each.refusal.empty()) known.push_back(each.path);
  }
  std::string message =
      fmt::format("parameters: {} {}", texts::in_quotes(asked.pattern),
                  is_pattern(asked.pattern) ? "matches nothing that can be tuned" : "is no number of this team");
  if (known.empty()) {
    message += "; nothing of it can be: no term has a `tune`, no plugin declares a tunable parameter";
  } else {
    std::ranges::stable_sort(known, {},
                             [&](const std::string& each) { return texts::edit_distance(asked.pattern, each); });
    known.resize(std::min(known.size(), shown));
    message += fmt::format("; nearest: {}", texts::join(known));
  }
  throw config::Error(asked.where, message);
}

void narrow(Parameter& parameter, const config::TunedPath& asked) {
  const auto [least, most] = *asked.range;
  const auto text = [](double low, double high) {
    return fmt::format("{} to {}", config::real_text(low), config::real_text(high));
  };
  if (least < parameter.least || most > parameter.most) {
    throw config::Error(
        asked.range_where,
        fmt::format("parameters: {}: {} is wider than what is declared, {}; a range can be narrowed only",
                    parameter.path, text(least, most), text(parameter.least, parameter.most)));
  }
  parameter.least = parameter.integer ? std::ceil(least) : least;
  parameter.most = parameter.integer ? std::floor(most) : most;
  if (parameter.least > parameter.most) {
    throw config::Error(asked.range_where, fmt::format("parameters: {}: empty: no whole number is in {}",
                                                       parameter.path, text(least, most)));
  }
}

void require_sound(const Parameter& parameter, const config::TunedPath& asked) {
  const config::Location& where = asked.range ? asked.range_where : asked.where;
  if (parameter.start < parameter.least || parameter.start > parameter.most) {
    throw config::Error(where, fmt::format("parameters: {}: the team's own {} is outside {} to {}", parameter.path,
                                           config::real_text(parameter.start), config::real_text(parameter.least),
                                           config::real_text(parameter.most)));
  }
  if (parameter.log_scale && !parameter.fixed() && parameter.least <= 0.0) {
    throw config::Error(where,
                        fmt::format("parameters: {}: its scale is logarithmic, so that its range cannot begin at "
                                    "{}; `range` can narrow it",
                                    parameter.path, config::real_text(parameter.least)));
  }
}

}  // namespace

std::vector<Tunable> tunables(const Node& team, std::span<const config::PluginDeclaration> plugins) {
  Collector collector(plugins);
  const auto all_said = [](const std::string&) { return true; };
  for (const Node::Entry& each : team["predictors"].entries()) {
    collector.plugin(fmt::format("predictors.{}", each.key), "predictor", each.value, all_said);
  }
  collector.coordination("", team, {});
  for (const Node& context : team["contexts"].elements()) {
    const std::string path = fmt::format("contexts.{}", context["name"].text());
    collector.plugin(path, "context", context, all_said);
    collector.coordination(fmt::format("{}.use.", path), config::in_context(team, context["use"]), context["use"]);
  }
  collector.behaviours(team);
  return collector.take();
}

std::vector<Parameter> chosen_parameters(std::span<const config::TunedPath> paths, std::span<const Tunable> all) {
  std::vector<const config::TunedPath*> by(all.size());  // for each number, the path that chose it; null: not chosen
  std::vector<Parameter> found(all.size());
  for (const config::TunedPath& asked : paths) {
    bool any = false;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Tunable& each = all[i];
      const bool exact = each.path == asked.pattern;
      const bool matched = each.said && each.refusal.empty() && is_pattern(asked.pattern) &&
                           fnmatch(asked.pattern.c_str(), each.path.c_str(), 0) == 0;
      if (!exact && !matched) continue;
      if (!each.refusal.empty()) {
        throw config::Error(asked.where, fmt::format("parameters: {} cannot be tuned: {}", each.path, each.refusal));
      }
      any = true;
      Parameter& parameter = found[i];
      parameter = each;
      if (asked.range) narrow(parameter, asked);
      // If this path has no range, the range of an earlier pattern stays.
      if (!asked.range && by[i] != nullptr && by[i]->range) {
        narrow(parameter, *by[i]);
        continue;
      }
      by[i] = &asked;
    }
    if (!any) refuse_unknown(asked, all);
  }
  std::vector<Parameter> out;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (by[i] == nullptr) continue;
    require_sound(found[i], *by[i]);
    out.push_back(std::move(found[i]));
  }
  return out;
}

double rounded(const Parameter& parameter, double value) {
  if (parameter.integer) return std::clamp(std::round(value), parameter.least, parameter.most);
  constexpr int most_digits = 17;
  int digits = 6;
  const double width = 10.0 * (parameter.most - parameter.least);
  double size = std::max(std::abs(parameter.least), std::abs(parameter.most));
  for (; digits < most_digits && size > width; size /= 10.0) ++digits;
  const std::string text = fmt::format("{:.{}g}", value, digits);
  return std::clamp(config::to_real(Node::scalar(text, false, {}), ""), parameter.least, parameter.most);
}

std::string text_of(const Parameter& parameter, double value) {
  return parameter.integer ? fmt::format("{:.0f}", value) : config::real_text(value);
}

double share_of(const Parameter& parameter, double value) {
  if (parameter.fixed()) return 0.0;
  const double share = parameter.log_scale
                           ? std::log(value / parameter.least) / std::log(parameter.most / parameter.least)
                           : (value - parameter.least) / (parameter.most - parameter.least);
  return std::clamp(share, 0.0, 1.0);
}

double value_at_share(const Parameter& parameter, double share) {
  if (parameter.fixed() || share <= 0.0) return parameter.least;
  if (share >= 1.0) return parameter.most;
  const double value = parameter.log_scale ? parameter.least * std::pow(parameter.most / parameter.least, share)
                                           : parameter.least + share * (parameter.most - parameter.least);
  return rounded(parameter, value);
}

}  // namespace regista::study

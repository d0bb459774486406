// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "report/experiment_figure_parts.hpp"

namespace regista::report {
namespace {

struct Panel {
  const char* last;   // of the measure's path
  const char* title;  // with its unit
  const char* name;
  const char* meaning;
};
constexpr std::array panels{
    Panel{"overlap_seconds", "overlap, min per 60 min", "overlap",
          "minutes in 60 minutes of play in which two robots or more held the role"},
    Panel{"uncovered_seconds", "uncovered, min per 60 min", "uncovered time",
          "minutes in 60 minutes of play in which no robot held it although it was wanted"},
    Panel{"switches", "switches per match", "switches", "how often a robot took it, in a match"}};

// Those that a measure names.
std::vector<Panel> panels_of(const study::ExperimentPlan& plan) {
  std::vector<Panel> out;
  for (const Panel& panel : panels) {
    const std::string end = std::string(".") + panel.last;
    if (std::ranges::any_of(plan.measures, [&](const auto& measure) { return measure.ends_with(end); })) {
      out.push_back(panel);
    }
  }
  return out;
}

std::string capital(std::string words) {
  words.front() = static_cast<char>(words.front() - 'a' + 'A');
  return words;
}

// "Overlap, uncovered time and switches by role"
std::string title_of(const std::vector<Panel>& shown) {
  std::string out;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    out += i == 0 ? "" : i + 1 == shown.size() ? " and " : ", ";
    out += shown[i].name;
  }
  return capital(out) + " by role";
}

std::optional<std::size_t> measure_index(const study::ExperimentPlan& plan, const std::string& path) {
  const auto found = std::ranges::find(plan.measures, path);
  if (found == plan.measures.end()) return std::nullopt;
  return static_cast<std::size_t>(found - plan.measures.begin());
}

// Of the roles that the measures name, in their order.
std::vector<std::string> roles_of(const study::ExperimentPlan& plan) {
  std::vector<std::string> out;
  for (const std::string& measure : plan.measures) {
    for (const Panel& panel : panels) {
      const std::string end = std::string(".") + panel.last;
      if (!measure.ends_with(end)) continue;
      const std::string role = measure.substr(0, measure.size() - end.size());
      if (std::ranges::find(out, role) == out.end()) out.push_back(role);
    }
  }
  return out;
}

// "playing.goalkeeper" is told from that of another list by its path; in a picture the role is enough.
std::string short_name(const std::string& role) { return role.substr(role.rfind('.') + 1); }

// Bars of all arms for each role, the first arm's on top, with their intervals as whiskers.
std::string panel_commands(const ExperimentView& view, std::size_t first_column, const char* title,
                           const std::string& tics, double most) {
  const std::size_t arms = view.plan.asked.arms.size();
  const double height = 0.8 / static_cast<double>(arms);
  std::string out = fmt::format("set title '{}' offset 0, -0.7\nset xrange [0:{:.6g}]\nset xtics {}\n{}", title,
                                most > 0.0 ? 1.05 * most : 1.0, tic_step(most, 5), tics);
  std::string plot = "plot ";
  for (std::size_t arm = 0; arm < arms; ++arm) {
    const std::size_t column = first_column + 3 * arm;
    const double centre = 0.4 - (static_cast<double>(arm) + 0.5) * height;
    plot += fmt::format(
        "'roles.csv' using {0}:(-$0{1:+.4f}):(0):{0}:(-$0{2:+.4f}):(-$0{3:+.4f}) with boxxyerror lc rgb "
        "'{4}' fs solid noborder notitle, \\\n     ",
        column, centre, centre - 0.46 * height, centre + 0.46 * height, arm_colour(arm));
  }
  for (std::size_t arm = 0; arm < arms; ++arm) {
    const std::size_t column = first_column + 3 * arm;
    const double centre = 0.4 - (static_cast<double>(arm) + 0.5) * height;
    plot += fmt::format("'' using {0}:(-$0{1:+.4f}):{2}:{3} with xerrorbars pt 0 lw 1 lc rgb '{4}' notitle{5}", column,
                        centre, column + 1, column + 2, colours[7], arm + 1 < arms ? ", \\\n     " : "\n");
  }
  return out + plot;
}

// Names and colours of the arms over the whole width, as a plot of nothing.
std::string key_commands(const study::ExperimentPlan& plan, int height, int top) {
  std::string out = fmt::format(
      "set lmargin at screen 0.01\nset rmargin at screen 0.99\nset tmargin at screen 0.995\n"
      "set bmargin at screen {:.4f}\nunset border\nunset tics\nset key center top horizontal Left reverse maxcols "
      "{}\nplot ",
      1.0 - static_cast<double>(top - 30) / height, key_columns(plan));
  for (std::size_t arm = 0; arm < plan.asked.arms.size(); ++arm) {
    out +=
        fmt::format("NaN with boxes lc rgb '{}' fs solid noborder title {}{}", arm_colour(arm),
                    gnuplot_text(plan.asked.arms[arm].name), arm + 1 < plan.asked.arms.size() ? ", \\\n     " : "\n");
  }
  return out + "unset key\nset border 3\nset xtics nomirror\nset bmargin 2.5\n";
}

std::string name_tics(const std::vector<std::string>& names, bool shown) {
  std::string out = "set ytics scale 0 (";
  for (std::size_t i = 0; i < names.size(); ++i) {
    std::string each = shown ? short_name(names[i]) : std::string();
    std::ranges::replace(each, '_', ' ');
    out += fmt::format("{}{} {}", i == 0 ? "" : ", ", gnuplot_mark(each), -static_cast<int>(i));
  }
  return out + ")\n";
}

}  // namespace

bool is_in_role_figure(std::string_view measure) {
  return std::ranges::any_of(panels,
                             [&](const Panel& panel) { return measure.ends_with(std::string(".") + panel.last); });
}

std::optional<Figure> role_figure(const ExperimentView& view) {
  const study::ExperimentPlan& plan = view.plan;
  const std::vector<std::string> names = roles_of(plan);
  if (names.empty() || view.course.taken() == 0) return std::nullopt;
  const std::vector<Panel> shown = panels_of(plan);
  Figure out;
  out.name = "roles";
  out.title = title_of(shown);
  for (const Panel& panel : shown) {
    out.description += fmt::format("{}{}: {}", out.description.empty() ? "" : "; ", panel.name, panel.meaning);
  }
  out.description =
      capital(out.description) + fmt::format(". Whiskers: intervals of {:.4g} %.", 100.0 * plan.asked.confidence);
  out.csv = "role";
  for (const Panel& panel : shown) {
    for (const config::Experiment::Arm& arm : plan.asked.arms) {
      for (const char* end : {"", " low", " high"}) {
        out.csv += ',' + figure_field(fmt::format("{} {}{}", arm.name, panel.last, end));
      }
    }
  }
  out.csv += '\n';
  std::vector<double> most(shown.size(), 0.0);
  for (const std::string& role : names) {
    out.csv += figure_field(role);
    for (std::size_t i = 0; i < shown.size(); ++i) {
      const auto measure = measure_index(plan, role + '.' + shown[i].last);
      for (std::size_t arm = 0; arm < plan.asked.arms.size(); ++arm) {
        const study::MeanEstimate mean = measure ? view.course.mean(arm, *measure) : study::MeanEstimate{};
        out.csv += ',' + mean_fields(mean);
        most[i] = std::max({most[i], mean.mean, mean.interval ? mean.interval->high : 0.0});
      }
    }
    out.csv += '\n';
  }
  std::size_t widest = 0;
  for (const std::string& role : names) widest = std::max(widest, gnuplot_mark(short_name(role)).size() - 2);
  const auto rows = static_cast<double>(names.size());
  out.width = page_width;
  const int top = 50 + 20 * key_rows(plan);
  out.height = 50 + top + static_cast<int>(rows * std::max(24.0, 10.0 * static_cast<double>(plan.asked.arms.size())));
  out.commands = fmt::format(
      "set grid noytics\nset grid xtics lt 1 lc rgb '{}' lw 0.7\nset yrange [{:.1f}:0.6]\n"
      "set style fill solid noborder\nset bars 0.4\nset multiplot\n",
      grid_colour, -rows + 0.4);
  out.commands += key_commands(plan, out.height, top);
  out.commands += fmt::format("set tmargin at screen {:.4f}\n", 1.0 - static_cast<double>(top) / out.height);
  const double left = (8.2 * static_cast<double>(widest) + 16.0) / out.width;
  const double panel_width = (1.01 - left) / static_cast<double>(shown.size());
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const double begin = left + panel_width * static_cast<double>(i);
    out.commands +=
        fmt::format("set lmargin at screen {:.4f}\nset rmargin at screen {:.4f}\n", begin, begin + panel_width - 0.03);
    out.commands +=
        panel_commands(view, 2 + 3 * plan.asked.arms.size() * i, shown[i].title, name_tics(names, i == 0), most[i]);
  }
  out.commands += "unset multiplot\n";
  return out;
}

}  // namespace regista::report

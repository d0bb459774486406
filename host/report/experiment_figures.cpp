// SPDX-License-Identifier: MIT
#include "report/experiment_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include "report/visible_text.hpp"

namespace regista::report {
namespace {

struct Panel {
  const char* last;   // of the measure's path
  const char* title;  // with its unit
};
constexpr std::array panels{Panel{"overlap_seconds", "overlap, min per 60 min"},
                            Panel{"uncovered_seconds", "uncovered, min per 60 min"},
                            Panel{"switches", "switches per match"}};

constexpr std::size_t most_curves = 40;

// Gnuplot takes an empty field for a missing value.
std::string field(bool known, double value) {
  return known && std::isfinite(value) ? fmt::format("{}", value) : std::string();
}

std::string fields(const study::MeanEstimate& mean) {
  const bool known = mean.pairs > 0, bounded = mean.interval.has_value();
  return fmt::format("{},{},{}", field(known, mean.mean), field(known, bounded ? mean.interval->low : mean.mean),
                     field(known, bounded ? mean.interval->high : mean.mean));
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

std::string colour(std::size_t arm) { return std::string(colours[arm % colours.size()]); }

// So many names of arms stand beside each other.
int key_columns(const study::ExperimentPlan& plan) {
  std::size_t widest = 0;
  for (const study::Arm& arm : plan.arms) widest = std::max(widest, gnuplot_text(arm.name).size() - 2);
  return std::clamp(static_cast<int>(1000.0 / (8.2 * static_cast<double>(widest) + 50.0)), 1,
                    static_cast<int>(plan.arms.size()));
}

// Bars of all arms for each role, the first arm's on top, with their intervals as whiskers.
std::string panel_commands(const ExperimentView& view, std::size_t first_column, const char* title,
                           const std::string& tics, double most) {
  const std::size_t arms = view.plan.arms.size();
  const double height = 0.8 / static_cast<double>(arms);
  std::string out = fmt::format("set title '{}'\nset xrange [0:{:.6g}]\nset xtics {}\n{}", title,
                                most > 0.0 ? 1.05 * most : 1.0, tic_step(most, 5), tics);
  std::string plot = "plot ";
  for (std::size_t arm = 0; arm < arms; ++arm) {
    const std::size_t column = first_column + 3 * arm;
    const double centre = 0.4 - (static_cast<double>(arm) + 0.5) * height;
    plot += fmt::format(
        "'roles.csv' using {0}:(-$0{1:+.4f}):(0):{0}:(-$0{2:+.4f}):(-$0{3:+.4f}) with boxxyerror lc rgb "
        "'{4}' fs solid noborder notitle, \\\n     ",
        column, centre, centre - 0.46 * height, centre + 0.46 * height, colour(arm));
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
      "set bmargin at screen {:.4f}\nunset border\nunset tics\nset key center center horizontal maxcols {}\nplot ",
      1.0 - static_cast<double>(top - 30) / height, key_columns(plan));
  for (std::size_t arm = 0; arm < plan.arms.size(); ++arm) {
    out += fmt::format("NaN with boxes lc rgb '{}' fs solid noborder title {}{}", colour(arm),
                       gnuplot_text(plan.arms[arm].name), arm + 1 < plan.arms.size() ? ", \\\n     " : "\n");
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

std::optional<Figure> roles(const ExperimentView& view) {
  const study::ExperimentPlan& plan = view.plan;
  const std::vector<std::string> names = roles_of(plan);
  if (names.empty() || view.course.taken() == 0) return std::nullopt;
  Figure out;
  out.name = "roles";
  out.title = "Overlap, uncovered time and switches by role";
  out.description = fmt::format(
      "Overlap: minutes in 60 minutes of play in which two robots or more held the role; uncovered: in which nobody "
      "held it although it was wanted; switches: how often a robot took it, in a match. Whiskers: what holds with "
      "{:.4g} %.",
      100.0 * plan.confidence);
  out.csv = "role";
  for (const Panel& panel : panels) {
    for (const study::Arm& arm : plan.arms) {
      for (const char* end : {"", " low", " high"}) {
        out.csv += ',' + figure_field(fmt::format("{} {}{}", arm.name, panel.last, end));
      }
    }
  }
  out.csv += '\n';
  std::array<double, panels.size()> most{};
  for (const std::string& role : names) {
    out.csv += figure_field(role);
    for (std::size_t i = 0; i < panels.size(); ++i) {
      const auto measure = measure_index(plan, role + '.' + panels[i].last);
      for (std::size_t arm = 0; arm < plan.arms.size(); ++arm) {
        const study::MeanEstimate mean = measure ? view.course.mean(arm, *measure) : study::MeanEstimate{};
        out.csv += ',' + fields(mean);
        most[i] = std::max({most[i], mean.mean, mean.interval ? mean.interval->high : 0.0});
      }
    }
    out.csv += '\n';
  }
  std::size_t widest = 0;
  for (const std::string& role : names) widest = std::max(widest, gnuplot_mark(short_name(role)).size() - 2);
  const auto rows = static_cast<double>(names.size());
  out.width = 1130;
  const int columns = key_columns(plan), key_rows = (static_cast<int>(plan.arms.size()) + columns - 1) / columns;
  const int top = 40 + 20 * key_rows;
  out.height = 50 + top + static_cast<int>(rows * std::max(24.0, 10.0 * static_cast<double>(plan.arms.size())));
  out.commands = fmt::format(
      "set grid noytics\nset grid xtics lt 1 lc rgb '{}' lw 0.7\nset yrange [{:.1f}:0.6]\n"
      "set style fill solid noborder\nset bars 0.4\nset multiplot\n",
      grid_colour, -rows + 0.4);
  out.commands += key_commands(plan, out.height, top);
  out.commands += fmt::format("set tmargin at screen {:.4f}\n", 1.0 - static_cast<double>(top) / out.height);
  const double left = (8.2 * static_cast<double>(widest) + 16.0) / out.width;
  const double panel_width = (1.01 - left) / static_cast<double>(panels.size());
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const double begin = left + panel_width * static_cast<double>(i);
    out.commands +=
        fmt::format("set lmargin at screen {:.4f}\nset rmargin at screen {:.4f}\n", begin, begin + panel_width - 0.03);
    out.commands +=
        panel_commands(view, 2 + 3 * plan.arms.size() * i, panels[i].title, name_tics(names, i == 0), most[i]);
  }
  out.commands += "unset multiplot\n";
  return out;
}

std::optional<double> number_of(const std::string& text) {
  try {
    std::size_t end = 0;
    const double value = std::stod(text, &end);
    if (end == text.size() && std::isfinite(value)) return value;
  } catch (const std::exception&) {
  }
  return std::nullopt;
}

// From the least value to the largest; by powers of ten where these are far apart.
std::string x_axis(const study::ExperimentPlan& plan) {
  double least = *number_of(plan.values.front()), most = least;
  for (const std::string& each : plan.values) {
    least = std::min(least, *number_of(each));
    most = std::max(most, *number_of(each));
  }
  if (!(most > least)) return {};
  const bool logarithmic = least > 0.0 && most / least >= 50.0;
  const double room = logarithmic ? 1.0 : 0.02 * (most - least);
  return fmt::format("{}set xrange [{:.6g}:{:.6g}]\n", logarithmic ? "set logscale x\n" : "",
                     logarithmic ? least / 1.1 : least - room, logarithmic ? most * 1.1 : most + room);
}

// Values that are numbers stand where they belong; others one beside the other, in their order.
std::optional<Figure> curve(const ExperimentView& view, std::size_t measure, std::size_t number) {
  const study::ExperimentPlan& plan = view.plan;
  bool any = false;
  const bool numbers = std::ranges::all_of(plan.values, [](const auto& each) { return number_of(each).has_value(); });
  const std::string& path = plan.measures[measure];
  Figure out;
  out.name = fmt::format("sweep_{}", number);
  out.title = fmt::format("{} over {}", visible(path), visible(plan.sweep));
  out.description =
      fmt::format("{}, with what holds with {:.4g} %.",
                  study::is_time(path) ? "Minutes in 60 minutes of play" : "Mean of a match", 100.0 * plan.confidence);
  out.csv = "x," + figure_field(plan.sweep);
  for (const study::Arm& arm : plan.arms) {
    for (const char* end : {"", " low", " high"}) out.csv += ',' + figure_field(arm.name + end);
  }
  out.csv += '\n';
  for (std::size_t value = 0; value < plan.values.size(); ++value) {
    const double x = numbers ? *number_of(plan.values[value]) : static_cast<double>(value);
    out.csv += fmt::format("{},{}", x, figure_field(plan.values[value]));
    for (std::size_t arm = 0; arm < plan.arms.size(); ++arm) {
      const study::MeanEstimate mean = view.course.mean(plan.condition(arm, value), measure);
      any = any || mean.pairs > 0;
      out.csv += ',' + fields(mean);
    }
    out.csv += '\n';
  }
  if (!any) return std::nullopt;
  out.height = 330;
  out.commands = fmt::format(
      "set key outside top center horizontal\nset xlabel {}\nset ylabel '{}'\nset offsets 0, 0, graph 0.05, graph "
      "0.02\n",
      gnuplot_text(plan.sweep), study::unit_of(path));
  if (numbers) out.commands += x_axis(plan);
  if (!numbers) {
    out.commands += fmt::format("set xrange [-0.5:{}.5]\nset xtics (", plan.values.size() - 1);
    for (std::size_t i = 0; i < plan.values.size(); ++i) {
      out.commands += fmt::format("{}{} {}", i == 0 ? "" : ", ", gnuplot_mark(plan.values[i]), i);
    }
    out.commands += ")\n";
  }
  std::string plot = "plot ";
  for (std::size_t arm = 0; numbers && arm < plan.arms.size(); ++arm) {
    plot += fmt::format(
        "'{0}.csv' using 1:{1}:{2} with filledcurves lc rgb '{3}' fs transparent solid 0.18 noborder "
        "notitle, \\\n     ",
        out.name, 3 * arm + 4, 3 * arm + 5, colour(arm));
  }
  for (std::size_t arm = 0; arm < plan.arms.size(); ++arm) {
    const std::string title = gnuplot_text(plan.arms[arm].name);
    const double shift =
        numbers ? 0.0 : 0.08 * (static_cast<double>(arm) - (static_cast<double>(plan.arms.size()) - 1.0) / 2.0);
    plot += fmt::format("'{0}.csv' using ($1{1:+.4f}):{2}{3} with {4} lc rgb '{5}' lw 2 pt {6} ps 0.7 title {7}{8}",
                        out.name, shift, 3 * arm + 3, numbers ? "" : fmt::format(":{}:{}", 3 * arm + 4, 3 * arm + 5),
                        numbers ? "linespoints" : "yerrorbars", colour(arm), 5 + 2 * (arm % 5), title,
                        arm + 1 < plan.arms.size() ? ", \\\n     " : "\n");
  }
  out.commands += plot;
  return out;
}

}  // namespace

bool is_experiment_figure(std::string_view name) {
  if (name == "roles") return true;
  const std::string_view prefix = "sweep_";
  if (!name.starts_with(prefix)) return false;
  const std::string_view number = name.substr(prefix.size());
  return !number.empty() && number.size() <= 3 && number.find_first_not_of("0123456789") == number.npos;
}

std::vector<Figure> experiment_figures(const ExperimentView& view) {
  std::vector<Figure> out;
  if (!view.plan.swept()) {
    if (auto figure = roles(view)) out.push_back(std::move(*figure));
    return out;
  }
  for (std::size_t measure = 0; measure < std::min(view.plan.measures.size(), most_curves); ++measure) {
    if (auto figure = curve(view, measure, measure + 1)) out.push_back(std::move(*figure));
  }
  return out;
}

}  // namespace regista::report

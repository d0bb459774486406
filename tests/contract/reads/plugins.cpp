// SPDX-License-Identifier: MIT
// Utilities that read one part of a frame each: one plugin declares that part alone, another everything but that part.
// They read past the views, as a plugin in C would, and so also what is empty.
#include <cstdint>

#include <regista/utility.hpp>

namespace {

using regista::Frame;

template <class T>
const T& first(const regista_span& span) {
  return *static_cast<const T*>(span.data);
}

struct OpponentsMine {
  static constexpr unsigned part = REGISTA_READS_OPPONENTS_MINE;
  static constexpr auto declares = "declares_opponents_mine", hides = "hides_opponents_mine";
  static double read(const Frame& frame) { return static_cast<double>(frame.mine().opponents().size()); }
};
struct OpponentsCommon {
  static constexpr unsigned part = REGISTA_READS_OPPONENTS_COMMON;
  static constexpr auto declares = "declares_opponents_common", hides = "hides_opponents_common";
  static double read(const Frame& frame) { return static_cast<double>(frame.common().opponents().size()); }
};
struct CovarianceOfRobots {
  static constexpr unsigned part = REGISTA_READS_COVARIANCES;
  static constexpr auto declares = "declares_covariance_of_robots", hides = "hides_covariance_of_robots";
  static double read(const Frame& frame) { return frame.common().robots()[0].covariance[5]; }
};
struct CovarianceOfOpponents {
  static constexpr unsigned part = REGISTA_READS_COVARIANCES;
  static constexpr auto declares = "declares_covariance_of_opponents", hides = "hides_covariance_of_opponents";
  static constexpr unsigned beside = REGISTA_READS_OPPONENTS_MINE;
  static double read(const Frame& frame) {
    double sum = 0.0;
    for (const regista::Opponent& opponent : frame.mine().opponents()) sum += opponent.covariance[2];
    return sum;
  }
};
struct CovarianceOfTheBall {
  static constexpr unsigned part = REGISTA_READS_COVARIANCES;
  static constexpr auto declares = "declares_covariance_of_the_ball", hides = "hides_covariance_of_the_ball";
  static double read(const Frame& frame) { return frame.mine().ball().covariance[9]; }
};
struct FacingsBefore {
  static constexpr unsigned part = REGISTA_READS_FACINGS;
  static constexpr auto declares = "declares_facings_before", hides = "hides_facings_before";
  static double read(const Frame& frame) { return 10.0 + frame.tasks()[0].before[2]; }
};
struct FacingsAfter {
  static constexpr unsigned part = REGISTA_READS_FACINGS;
  static constexpr auto declares = "declares_facings_after", hides = "hides_facings_after";
  static double read(const Frame& frame) { return 10.0 + frame.tasks()[0].after[2]; }
};
struct Times {
  static constexpr unsigned part = REGISTA_READS_TIMES;
  static constexpr auto declares = "declares_times", hides = "hides_times";
  static double read(const Frame& frame) { return frame.raw().time_to_task.values[0]; }
};
struct SizeOfTimes {
  static constexpr unsigned part = REGISTA_READS_TIMES;
  static constexpr auto declares = "declares_size_of_times", hides = "hides_size_of_times";
  static double read(const Frame& frame) { return frame.raw().time_to_task.rows; }
};
struct Waypoints {
  static constexpr unsigned part = REGISTA_READS_WAYPOINTS;
  static constexpr auto declares = "declares_waypoints", hides = "hides_waypoints";
  static double read(const Frame& frame) {
    double sum = 0.0;
    for (const regista::Waypoint& waypoint : frame.waypoints()) sum += waypoint.score;
    return sum;
  }
};
struct Edges {
  static constexpr unsigned part = REGISTA_READS_EDGES;
  static constexpr auto declares = "declares_edges", hides = "hides_edges";
  static double read(const Frame& frame) { return static_cast<double>(frame.edges().size()); }
};
struct Previous {
  static constexpr unsigned part = REGISTA_READS_PREVIOUS;
  static constexpr auto declares = "declares_previous", hides = "hides_previous";
  static double read(const Frame& frame) { return 1.0 + first<std::int32_t>(frame.raw().previous); }
};

template <class Part>
constexpr unsigned beside() {
  if constexpr (requires { Part::beside; }) {
    return Part::beside;
  } else {
    return REGISTA_READS_NOTHING;
  }
}

template <class Part>
struct Declares {
  static constexpr auto id = Part::declares, version = "1.0.0", summary = "Says what it reads";
  static constexpr unsigned reads = Part::part | beside<Part>();
  void score(const Frame& frame, regista::Utilities out) { out(0, 0) = Part::read(frame); }
};
template <class Part>
struct Hides {
  static constexpr auto id = Part::hides, version = "1.0.0", summary = "Wrong on purpose: reads one part more";
  static constexpr unsigned reads = REGISTA_READS_ALL & ~Part::part;
  void score(const Frame& frame, regista::Utilities out) { out(0, 0) = Part::read(frame); }
};

template <class... Parts>
const regista_descriptor* of_index(std::uint32_t index) {
  return regista::detail::nth_descriptor<regista::Plugin<Declares<Parts>, regista::utility>...,
                                         regista::Plugin<Hides<Parts>, regista::utility>...>(index);
}

}  // namespace

extern "C" const regista_descriptor* regista_plugin_entry(std::uint32_t, std::uint32_t, std::uint32_t index) {
  return of_index<OpponentsMine, OpponentsCommon, CovarianceOfRobots, CovarianceOfOpponents, CovarianceOfTheBall,
                  FacingsBefore, FacingsAfter, Times, SizeOfTimes, Waypoints, Edges, Previous>(index);
}

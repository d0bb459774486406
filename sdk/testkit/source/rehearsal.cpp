// SPDX-License-Identifier: MIT
// Every tenth of a second each robot hears what has arrived, decides on its own view, and speaks when its packet is
// due.
#include <regista/testkit/rehearsal.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <utility>

#include <regista/testkit/frame_builder.hpp>
#include <regista/testkit/instance.hpp>

namespace regista::testkit {

namespace {

constexpr double decision_period = 0.1;  // s
constexpr double shortest_act = 20.0;    // s, where nothing is lost
constexpr double news_of_penalty = 0.3;  // s until all have heard of it from the game controller
constexpr double never = std::numeric_limits<double>::infinity();
constexpr std::uint32_t segment_heading = 2, bytes_for_segments = 64;
constexpr std::size_t most_pending = 64;

constexpr int most_robots = 11;

// What becomes of a robot when an act begins. Who leaves stays away until somebody returns.
enum class Change { none, first_is_penalised, first_leaves_range, robot_1_leaves_range, returns };

struct Plan {
  std::string name;
  int tasks;
  int new_tasks = 0;            // above 0: as many are others, and all robots and tasks are elsewhere
  bool one_knows_less = false;  // robot 2 does not know the task in the middle
  Change change = Change::none;
};

std::vector<Plan> plans(int robots) {
  const int left = robots - 1;  // robots when one is away: a task for each, so whoever had none takes over
  const int most = 5;           // what was agreed before says little
  return {{"they begin", robots, most},
          {"robots and tasks have moved", robots, 1},
          {"robot 2 does not know one of the tasks", robots, 1, true},
          {"more tasks than robots", robots + 2, 1},
          {"fewer tasks than robots", left, 1},
          {"the robot with the first task is penalised", left, 0, false, Change::first_is_penalised},
          {"other tasks while it is penalised", left, most},
          {"the penalised robot is back", left, 0, false, Change::returns},
          {"robot 1 is out of range", left, 0, false, Change::robot_1_leaves_range},
          {"other tasks while robot 1 is out of range", left, most},
          {"robot 1 is in range again", left, 0, false, Change::returns},
          {"the robot with the first task is out of range", left, 0, false, Change::first_leaves_range},
          {"it is in range again", left, 0, false, Change::returns}};
}

struct Place {
  double x = 0.0, y = 0.0;
};

// An instance and its mailbox.
class Speaker {
 public:
  Speaker(const Loaded& plugin, const Values& values, int number, int robots)
      : number_(number),
        talks_(plugin.implements(REGISTA_KIND_MAILBOX)),
        instance_(plugin, EnvironmentBuilder{}.team_size(static_cast<unsigned>(robots)).own(number), values) {
    instance_.host().set_bytes_free(bytes_for_segments);
    instance_.host().set_most_pending(most_pending);
  }

  // What has expired is dropped.
  void begin(double now) {
    instance_.host().set_time(now);
    for (RecordingHost::Offered& each : waiting()) {
      if (each.expiry <= now) each.withdrawn = true;
    }
    settle_offers();
  }
  void receive(const Packet& packet, double now) {
    if (!talks_) return;
    for (const std::vector<std::uint8_t>& segment : packet.segments) {
      instance_.receive(packet.sender, segment, packet.time_sent, now);
      settle_offers();
    }
  }
  std::vector<std::int32_t> assign(const Scene& scene, const Matrix& utilities) {
    std::vector<std::int32_t> out = instance_.assign(scene, utilities);
    settle_offers();
    return out;
  }
  // What a packet takes along: the most urgent first, of equally urgent ones the oldest.
  std::vector<std::vector<std::uint8_t>> speak() {
    std::vector<RecordingHost::Offered> ready = waiting();
    std::ranges::stable_sort(ready, std::ranges::greater{}, &RecordingHost::Offered::urgency);
    std::vector<std::vector<std::uint8_t>> out;
    std::size_t free = bytes_for_segments;
    for (const RecordingHost::Offered& each : ready) {
      const std::size_t bytes = each.bytes.size() + segment_heading;
      const auto found = std::ranges::find(waiting(), each.handle, &RecordingHost::Offered::handle);
      if (bytes > free || found == waiting().end()) continue;
      free -= bytes;
      out.push_back(each.bytes);
      waiting().erase(found);
      if (talks_) instance_.transmitted(each.handle);
      settle_offers();
    }
    return out;
  }
  // What it may ask about: the newest packet of a robot, the own one too; the budget.
  void tell(const Packet& packet) {
    auto& told = instance_.host().told;
    const auto index = static_cast<std::size_t>(packet.sender - 1);
    if (told.size() <= index) told.resize(index + 1);
    if (told[index] && told[index]->time_sent > packet.time_sent) return;
    regista_told_packet& out = told[index].emplace();
    out.size = sizeof out;
    out.time_sent = packet.time_sent;
    std::ranges::copy(packet.pose, out.pose);
    std::copy_n(packet.pose.begin(), 2, out.target);
    out.role = packet.role;
    out.role_since = packet.role_since;
    double& newest = packet.sender == number_ ? own_sent_ : team_sent_;
    newest = std::max(newest, packet.time_sent);
  }
  // At its radio's pace a team sends more than in a match: its budget is that of so long a rehearsal.
  void budget(int left, double line, double time_left, double now) {
    regista_budget& out = instance_.host().budget;
    out.packets_left = left;
    out.line = line;
    out.match_time_left = time_left;
    out.since_own = now - own_sent_;
    out.since_team = now - std::max(own_sent_, team_sent_);
  }
  std::uint64_t offers() const { return last_handle_; }

 private:
  std::vector<RecordingHost::Offered>& waiting() { return instance_.host().offers; }

  // Tells it what became of its offers: it may answer with others.
  void settle_offers() {
    for (const RecordingHost::Offered& each : waiting()) last_handle_ = std::max(last_handle_, each.handle);
    for (;;) {
      const auto gone = std::ranges::find_if(waiting(), [](const auto& each) { return !each.waits(); });
      if (gone == waiting().end()) return;
      const std::uint64_t handle = gone->handle;
      waiting().erase(gone);
      if (talks_) instance_.dropped(handle);
    }
  }

  int number_;
  bool talks_;
  double own_sent_ = 0.0, team_sent_ = 0.0;  // s
  Instance instance_;
  std::uint64_t last_handle_ = 0;
};

struct Player {
  int number;
  std::unique_ptr<Speaker> speaker;
  std::int32_t task = REGISTA_NO_TASK;  // id
  double task_since = 0.0;
  double next_packet = 0.0;
  std::vector<std::int32_t> previous;  // task id of each robot, as it decided last
  SceneData view;                      // of this act
  std::vector<double> utilities;       // of this act: robots x the tasks that it knows
};

class Stage {
 public:
  Stage(const Loaded& plugin, const Values& values, const RehearsalConditions& conditions)
      : conditions_(conditions),
        robots_(static_cast<std::size_t>(conditions.robots)),
        dice_(conditions.seed),
        radio_(conditions.robots, conditions.radio, conditions.seed + 0x5eed),
        poses_(robots_),
        last_heard_(robots_ * robots_, 0.0),
        parted_since_(robots_ * robots_, -never) {
    if (conditions.robots < 3 || conditions.robots > most_robots) {
      throw std::logic_error("a rehearsal takes 3 to " + std::to_string(most_robots) + " robots");
    }
    for (int number = 1; number <= conditions.robots; ++number) {
      Player& player = team_.emplace_back();
      player.number = number;
      player.speaker = std::make_unique<Speaker>(plugin, values, number, conditions.robots);
      player.next_packet = dice_.real(0.0, conditions.packet_period);
      player.previous.assign(robots_, REGISTA_NO_TASK);
      between(parted_since_, number, number) = never;
    }
  }

  Rehearsal play() {
    const double length = shortest_act / (1.0 - std::min(conditions_.radio.loss, 0.9));
    const auto ticks = static_cast<std::uint64_t>(std::lround(length / decision_period));
    whole_ = length * static_cast<double>(plans(conditions_.robots).size());
    // A little more than is sent, so that the team keeps above its line.
    budget_ = static_cast<int>(std::ceil(1.2 * whole_ * conditions_.robots / conditions_.packet_period));
    for (const Plan& plan : plans(conditions_.robots)) {
      Act act{begin_act(plan), length, 0.0, {}};
      std::uint64_t last_without = 0;
      for (std::uint64_t tick = 1; tick <= ticks; ++tick, ++tick_) {
        step();
        std::string disagreement = disagree();
        if (disagreement.empty()) continue;
        last_without = tick;
        act.disagreement = std::move(disagreement);
      }
      act.settled_after = decision_period * static_cast<double>(last_without);
      if (5 * last_without > 4 * ticks) act.settled_after.reset();
      out_.acts.push_back(std::move(act));
      out_.robot_seconds += length * static_cast<double>(robots_);
    }
    for (const Player& player : team_) out_.offers += player.speaker->offers();
    return std::move(out_);
  }

 private:
  double now() const { return decision_period * static_cast<double>(tick_); }
  // Of a matrix receiver x sender.
  double& between(std::vector<double>& matrix, int receiver, int sender) const {
    return matrix[static_cast<std::size_t>(receiver - 1) * robots_ + static_cast<std::size_t>(sender - 1)];
  }

  // --- Acts

  std::string begin_act(const Plan& plan) {
    act_began_ = now();
    penalised_before_ = penalised_;
    if (plan.change == Change::returns) {
      penalised_ = 0;
      if (out_of_range_ != 0) radio_.into_range(std::exchange(out_of_range_, 0));
    }
    if (plan.new_tasks > 0) move(plan);
    std::string name = plan.name;
    if (plan.change == Change::first_is_penalised) {
      penalised_ = doer_of_first_task();
      name += " (robot " + std::to_string(penalised_) + ')';
    } else if (plan.change == Change::first_leaves_range) {
      leave_range(doer_of_first_task());
      name += " (robot " + std::to_string(out_of_range_) + ')';
    } else if (plan.change == Change::robot_1_leaves_range) {
      leave_range(1);
    }
    for (Player& player : team_) look(player, plan);
    return name;
  }

  void leave_range(int number) {
    out_of_range_ = number;
    radio_.out_of_range(number);
    for (int other = 1; other <= conditions_.robots; ++other) {
      if (other == number) continue;
      between(parted_since_, other, number) = between(parted_since_, number, other) = now();
    }
  }

  int doer_of_first_task() const {
    for (const Player& player : team_) {
      if (player.task == task_id(0)) return player.number;
    }
    return conditions_.robots;
  }

  // Ids are neither columns nor in their order.
  int task_id(int task) const {
    const int roles = static_cast<int>(usual_roles().size());
    return (3 * (task + first_task_) + 1) % roles;
  }

  void move(const Plan& plan) {
    const auto anywhere = [this] { return Place{dice_.real(-3.0, 3.0), dice_.real(-2.0, 2.0)}; };
    for (Place& each : poses_) each = anywhere();
    places_.resize(static_cast<std::size_t>(plan.tasks));
    for (Place& each : places_) each = anywhere();
    first_task_ += plan.new_tasks;
  }

  // What a robot believes through this act, a little beside the truth, and what it computes from that.
  void look(Player& player, const Plan& plan) {
    FrameBuilder frame;
    frame.team_size(conditions_.robots).own(player.number).ball(places_[0].x, places_[0].y);
    std::vector<Place> believed;
    for (int number = 1; number <= conditions_.robots; ++number) {
      const double error = number == player.number ? 0.05 : 0.5;  // m
      const Place& pose = poses_[static_cast<std::size_t>(number - 1)];
      believed.push_back({pose.x + dice_.real(-error, error), pose.y + dice_.real(-error, error)});
      frame.robot(number).at(believed.back().x, believed.back().y);
    }
    const auto middle = static_cast<int>(places_.size() / 2);
    std::vector<int> known;
    for (int task = 0; task < static_cast<int>(places_.size()); ++task) {
      if (plan.one_knows_less && player.number == 2 && task == middle) continue;
      known.push_back(task);
      const Place& place = places_[static_cast<std::size_t>(task)];
      frame.task(task_id(task)).at(place.x, place.y);
    }
    SceneData view = frame.build().data();
    constexpr int tasks_a_group = 2;  // for who heeds groups
    for (std::size_t k = 0; k < known.size(); ++k) view.tasks[k].group = known[k] / tasks_a_group;
    for (std::size_t i = 0; i < player.view.mine.robots.size(); ++i) {
      const regista_robot& before = player.view.mine.robots[i];
      view.mine.robots[i].role = before.role;
      view.mine.robots[i].role_since = before.role_since;
    }
    player.view = std::move(view);
    player.utilities.clear();
    for (const Place& robot : believed) {
      for (const int task : known) {
        const Place& place = places_[static_cast<std::size_t>(task)];
        const double importance = task == 0 ? 1.0 : 0.6;  // all want the first
        player.utilities.push_back(importance / (1.0 + std::hypot(place.x - robot.x, place.y - robot.y)));
      }
    }
  }

  // --- Decisions

  void step() {
    for (Player& player : team_) {
      for (const Packet& packet : radio_.arrived(player.number, now())) {
        double& heard = between(last_heard_, player.number, packet.sender);
        const bool is_newest = packet.time_sent >= heard;
        heard = std::max(heard, packet.time_sent);
        // What was on its way when they parted is no sign that they have met again.
        double& parted = between(parted_since_, player.number, packet.sender);
        if (packet.time_sent > parted) parted = never;
        if (is_newest) {
          regista_robot& sender = player.view.mine.robots[static_cast<std::size_t>(packet.sender - 1)];
          sender.role = packet.role;
          sender.role_since = packet.role_since;
        }
        player.speaker->tell(packet);
        player.speaker->receive(packet, now());
      }
      player.speaker->budget(budget_ - sent_, budget_ * (1.0 - now() / whole_), whole_ - now(), now());
      player.speaker->begin(now());
      decide(player);
    }
    for (Player& player : team_) {
      if (player.next_packet > now()) continue;
      player.next_packet += conditions_.packet_period * dice_.real(0.9, 1.1);
      if (player.number == penalised_) continue;
      const regista_robot& self = player.view.mine.robots[static_cast<std::size_t>(player.number - 1)];
      const Packet packet{player.number,           now(),
                          player.speaker->speak(), player.task,
                          player.task_since,       {self.pose[0], self.pose[1], self.pose[2]}};
      player.speaker->tell(packet);
      ++sent_;
      for (const auto& segment : packet.segments) out_.bytes += segment.size() + segment_heading;
      radio_.send(packet);
    }
  }

  // Penalties are told by the game controller. Who was never heard does not play, and who is out of range is given up,
  // by each after a time of its own.
  bool is_active(int observer, int number) {
    const bool told = observer == number || now() - act_began_ >= news_of_penalty;
    if (number == (told ? penalised_ : penalised_before_)) return false;
    const double patience = 4.0 + 0.3 * observer;  // s
    return now() - between(parted_since_, observer, number) <= patience;
  }

  void decide(Player& player) {
    SceneData& view = player.view;
    view.tick = tick_;
    view.time = now();
    view.previous = player.previous;
    std::vector<int> active;
    for (regista_robot& robot : view.mine.robots) {
      const bool is = is_active(player.number, robot.number);
      robot.flags = is ? robot.flags | REGISTA_ROBOT_ACTIVE : robot.flags & ~std::uint32_t{REGISTA_ROBOT_ACTIVE};
      robot.age = robot.number == player.number ? 0.0 : now() - between(last_heard_, player.number, robot.number);
      if (is) active.push_back(robot.number);
    }
    regista_robot& self = view.mine.robots[static_cast<std::size_t>(player.number - 1)];
    self.role = player.task;
    self.role_since = player.task_since;
    view.common = view.mine;
    const std::size_t columns = view.tasks.size();
    Matrix utilities(static_cast<std::uint32_t>(active.size()), static_cast<std::uint32_t>(columns));
    for (std::size_t row = 0; row < active.size(); ++row) {
      for (std::size_t column = 0; column < columns; ++column) {
        utilities(row, column) = player.utilities[static_cast<std::size_t>(active[row] - 1) * columns + column];
      }
    }
    const Scene scene(view);
    const std::vector<std::int32_t> chosen = player.speaker->assign(scene, utilities);
    if (!scene.unchanged()) broke("assign: wrote to its input");
    std::vector<std::int32_t> tasks(robots_, REGISTA_NO_TASK);
    for (std::size_t row = 0; row < active.size(); ++row) {
      const auto robot = static_cast<std::size_t>(active[row] - 1);
      tasks[robot] = task_of(chosen[row], player.previous[robot], view.tasks);
    }
    player.previous = std::move(tasks);
    const std::int32_t own = player.previous[static_cast<std::size_t>(player.number - 1)];
    if (own != player.task) player.task_since = now();
    player.task = own;
  }

  // A robot that does not know yet goes on with what it did, as long as that is a task.
  std::int32_t task_of(std::int32_t column, std::int32_t before, const std::vector<regista_task>& tasks) {
    if (column == REGISTA_NO_TASK) return REGISTA_NO_TASK;
    if (column == REGISTA_UNKNOWN_TASK) {
      const bool still = std::ranges::any_of(tasks, [&](const regista_task& each) { return each.id == before; });
      return still ? before : REGISTA_NO_TASK;
    }
    if (column < 0 || column >= static_cast<std::int32_t>(tasks.size())) {
      broke("assign: gave column " + std::to_string(column) + " of " + std::to_string(tasks.size()));
      return REGISTA_NO_TASK;
    }
    return tasks[static_cast<std::size_t>(column)].id;
  }

  void broke(std::string promise) {
    if (std::ranges::find(out_.broken, promise) == out_.broken.end()) out_.broken.push_back(std::move(promise));
  }

  // --- Judgement

  std::string disagree() const {
    const auto& roles = usual_roles();
    std::vector<const Player*> doer(roles.size(), nullptr);
    for (const Player& player : team_) {
      if (is_away(player.number) || player.task == REGISTA_NO_TASK) continue;
      const Player*& other = doer[static_cast<std::size_t>(player.task)];
      if (other != nullptr) {
        return "robots " + std::to_string(other->number) + " and " + std::to_string(player.number) + " both do \"" +
               roles[static_cast<std::size_t>(player.task)] + '"';
      }
      other = &player;
    }
    if (std::ranges::count(doer, nullptr) == static_cast<std::ptrdiff_t>(doer.size())) return "nobody has a task";
    if (conditions_.may_idle) return {};
    for (const Player& player : team_) {
      if (is_away(player.number) || player.task != REGISTA_NO_TASK) continue;
      for (const regista_task& task : player.view.tasks) {
        if (doer[static_cast<std::size_t>(task.id)] != nullptr) continue;
        return "robot " + std::to_string(player.number) + " has no task, and nobody does \"" +
               roles[static_cast<std::size_t>(task.id)] + '"';
      }
    }
    return {};
  }
  bool is_away(int number) const { return number == penalised_ || number == out_of_range_; }

  RehearsalConditions conditions_;
  std::size_t robots_;
  Dice dice_;
  Radio radio_;
  std::vector<Place> poses_, places_;  // of robots and of tasks, in truth
  std::vector<double> last_heard_;     // receiver x sender: when that was sent
  std::vector<double> parted_since_;   // the same: since when they cannot hear each other
  std::vector<Player> team_;
  std::uint64_t tick_ = 0;
  double act_began_ = 0.0;
  int first_task_ = 0;
  int penalised_ = 0, penalised_before_ = 0, out_of_range_ = 0;  // 0: nobody
  double whole_ = 0.0;                                           // s of the rehearsal
  int budget_ = 0, sent_ = 0;                                    // packets
  Rehearsal out_;
};

}  // namespace

Rehearsal rehearse(const Loaded& plugin, const Values& values, const RehearsalConditions& conditions) {
  return Stage(plugin, values, conditions).play();
}

}  // namespace regista::testkit

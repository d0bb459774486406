// SPDX-License-Identifier: MIT
#include "campaign/fork_server.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <map>
#include <memory>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <vector>

#include "campaign/match_setup.hpp"
#include "campaign/play_job.hpp"
#include "config/document_files.hpp"
#include "config/errors.hpp"
#include "config/overlay.hpp"
#include "config/robot.hpp"
#include "config/rules.hpp"
#include "config/values.hpp"
#include "plugin/catalogue.hpp"
#include "plugin/fatal_signal.hpp"
#include "plugin/process_state.hpp"
#include "plugin/shared_object.hpp"

namespace regista::campaign {

struct ForkReply {
  enum class State : std::int32_t {
    ready,  // the server is ready for the next request
    stale,  // the server ends, because a file has changed; a new server may be started
    unfit,  // the server ends, because a plugin changed the process; no new server may be started
  };
  std::uint64_t number = 0;
  std::int32_t process = -1;  // -1: the server has not started the worker
  State state = State::ready;
};

namespace {

constexpr int server_descriptor = 3;

// A request to the server is one datagram: its number, which the reply repeats, with four or five file descriptors: job
// (a file with a Job), answer, note, output, and the trail if the job has a trail.

// --- Teams that are read once for many matches: opened plugins, the teams' documents, and the lists of inputs. The
// only code of plugins that runs here: initialization of the shared objects, and the functions that declare plugins.

// Thrown if this process must play no more matches.
struct ServerEnds {
  ForkReply::State why;
};

// Limit of teams in memory: the plan of a team has some hundred kilobytes, which enlarge the page tables of each copy.
constexpr std::size_t most_teams = 64;

constexpr std::size_t most_output = std::size_t{1} << 16;  // kept bytes of what plugins write when they are loaded

using Files = std::vector<std::pair<std::filesystem::path, plugin::FileStamp>>;  // stamps made before reading

template <class Paths>
Files stamped(const Paths& paths) {
  Files out;
  for (const auto& path : paths) out.emplace_back(path, plugin::stamp_of(path));
  return out;
}

void demand_unchanged(const Files& files) {
  for (const auto& [path, stamp] : files) {
    if (plugin::stamp_of(path) != stamp) throw ServerEnds{ForkReply::State::stale};
  }
}

template <class Profile>
std::string shown(Profile profile) {
  return config::show(config::declare(profile), config::Node(), {}, config::Remarks::without);
}

class PreparedTeams {
 public:
  struct Match {
    MatchSetup setup;         // must not outlive this object, which owns the plugins
    std::string changed;      // result of what_changed() (match_setup.hpp)
    std::string_view output;  // what plugins wrote to standard error when they were loaded
  };

  // Precondition: the job names its plugin files. Throws ServerEnds, config::Error, config::BadInput and
  // std::runtime_error. A team that pins the file of a plugin is an error, too, because two loaded versions of a plugin
  // may share variables.
  Match prepare(const Job& job) {
    const Plugins& plugins = plugins_of(job);
    std::vector<std::vector<Input>> inputs;  // of home and away
    std::string shared;                      // inputs that both plans depend on
    Match out;
    out.output = plugins.output;
    out.setup = match_setup(job, config::typed_overrides(job.overrides),
                            [&](const std::string& file, const config::Overrides& overrides, const config::Rules& rules,
                                const config::Robot& robot) {
                              if (shared.empty())
                                shared = fmt::format("{}\n{}\n{}\n{}", job.root, fmt::join(job.plugin_files, "\n"),
                                                     shown(rules), shown(robot));
                              std::string key = fmt::format("{}\n{}", shared, file);
                              for (const config::Override& each : overrides) key += '\n' + to_string(each);
                              const Team& team =
                                  team_of(key, file, overrides, rules, robot, plugins.catalogue, job.root);
                              inputs.push_back(team.inputs);
                              return team.setup;
                            });
    if (job.common_inputs.empty()) return out;  // the job has no list of inputs
    // Takes two hashes from the job, because the coordinator uses the same program and mathematics library.
    out.changed = what_changed(
        job, {inputs.at(0), inputs.at(1),
              common_inputs(out.setup.setup, input_of(job, program_input), input_of(job, mathematics_input))});
    return out;
  }

 private:
  struct Plugins {
    plugin::Catalogue catalogue;
    Files files;
    std::string output;
  };
  struct Team {
    TeamSetup setup;
    std::vector<Input> inputs;
    Files files;
  };
  const Plugins& plugins_of(const Job& job) {
    auto& opened = plugins_[fmt::format("{}", fmt::join(job.plugin_files, "\n"))];
    if (opened) {
      demand_unchanged(opened->files);
      return *opened;
    }
    Files files = stamped(job.plugin_files);
    const process::FileDescriptor output = process::memory_file({});
    const process::RedirectedStream errors(STDERR_FILENO, output.number);
    const plugin::ProcessState before = plugin::ProcessState::now();
    const pid_t here = getpid();
    const std::vector<std::filesystem::path> paths(job.plugin_files.begin(), job.plugin_files.end());
    plugin::Catalogue catalogue = plugin::Catalogue::of_files(paths, plugin::Catalogue::Looking::here);
    if (getpid() != here) _exit(EXIT_FAILURE);  // this is the child of a fork() by a plugin
    if (!plugin::changes_since(before).empty()) throw ServerEnds{ForkReply::State::unfit};
    if (!catalogue.refused().empty()) throw std::runtime_error(to_string(catalogue.refused().front()));
    opened.reset(new Plugins{std::move(catalogue), std::move(files),
                             process::everything_in(output.number).substr(0, most_output)});
    return *opened;
  }

  const Team& team_of(const std::string& key, const std::string& file, const config::Overrides& overrides,
                      const config::Rules& rules, const config::Robot& robot, const plugin::Catalogue& catalogue,
                      const std::string& root) {
    if (const auto known = teams_.find(key); known != teams_.end()) {
      demand_unchanged(known->second.files);
      return known->second;
    }
    const std::array<std::filesystem::path, 1> document{file};
    const std::vector<std::filesystem::path> named = config::named_files(document, overrides);
    for (const std::filesystem::path& each : named) {
      if (each.extension() == ".so") throw std::runtime_error(each.string() + " is pinned");
    }
    Files files = stamped(named);
    TeamSetup setup = team_setup(file, overrides, rules, robot, catalogue, KeyNames::former_too);
    std::vector<Input> inputs = team_inputs(*setup.plan, *setup.document, catalogue, root);
    demand_unchanged(files);
    if (teams_.size() >= most_teams) teams_.clear();
    return teams_.emplace(key, Team{std::move(setup), std::move(inputs), std::move(files)}).first->second;
  }

  std::map<std::string, std::unique_ptr<Plugins>> plugins_;  // by names of files; must outlive teams_
  std::map<std::string, Team> teams_;                        // by all inputs of the plan
};

// After this number of deaths in a row, no new server is started.
constexpr int most_deaths = 3;

constexpr double longest_wait = 60.0;  // s; limit for a server that does not answer, because a plugin sleeps

// Moves the socket to a high number, out of the reach of plugins that write to a low number by mistake.
process::FileDescriptor away_from_plugins(int socket) {
  process::FileDescriptor kept(::fcntl(socket, F_DUPFD_CLOEXEC, 100));
  const process::FileDescriptor nothing(::open("/dev/null", O_RDWR | O_CLOEXEC));
  if (!kept.is_open() || !nothing.is_open()) throw config::BadInput("cannot keep the connection to the coordinator");
  ::dup2(nothing.number, socket);
  return kept;
}

// Like fork(), but the copy is a child of this process's parent, so the parent can wait for the copy. The C library
// does not notice the copy, which is harmless with a single thread. Fork handlers of plugins' libraries do not run.
// The kernel sets the C library's number of the thread, as for fork().
pid_t copy_for_parent() {
  unsigned long flags = CLONE_PARENT | SIGCHLD;
  int* number = nullptr;
  if (::prctl(PR_GET_TID_ADDRESS, &number) == 0 && number != nullptr)
    flags |= CLONE_CHILD_SETTID | CLONE_CHILD_CLEARTID;
#if defined(__x86_64__)
  return static_cast<pid_t>(::syscall(SYS_clone, flags, nullptr, nullptr, number, nullptr));
#else  // this architecture has the last two arguments in the other order
  return static_cast<pid_t>(::syscall(SYS_clone, flags, nullptr, nullptr, nullptr, number));
#endif
}

// Changes the name of this process in lists of processes. Works only in a server or a worker.
void be_called(std::string_view name) {
  char* const command = program_invocation_name + std::strlen(program_invocation_name) + 1;
  if (std::string_view(command) != server_command && std::string_view(command) != worker_command) return;
  static_assert(std::string_view(worker_command).size() <= std::string_view(server_command).size());
  std::memset(command, 0, std::string_view(server_command).size());
  std::memcpy(command, name.data(), name.size());
}

struct Connection {
  process::FileDescriptor socket;
  pid_t coordinator;
};

// Plays the match in the copy, which is the worker and ends by _exit: the destructors belong to the server.
[[noreturn]] void play_in_copy(const Job& job, PreparedTeams::Match match, const WorkerFiles& files,
                               const Connection& connection, const std::string& program) {
  ::close(connection.socket.number);
  if (!process::become_child(worker_setting(files, job.limits), connection.coordinator))
    ::_exit(process::Child::never_began);
  for (const int each : {files.answer, files.note, files.output, files.trail}) {
    if (each > trail_descriptor) ::close(each);
  }
  process::write_all(STDERR_FILENO, match.output);
  try {
    const SharedNote shared{process::FileDescriptor(note_descriptor)};
    WorkerNote& note = *shared;
    plugin::note_fatal_signals(note.fatal);
    const Answer answer = answer_of([&] { return play_job(job, std::move(match.setup), program, note); });
    ::_exit(hand_over(answer) ? 0 : 1);
  } catch (const std::exception&) {  // the note cannot be mapped into memory
    ::_exit(process::Child::never_began);
  }
}

// Starts a copy and returns the reply to a request. In the copy, the function does not return.
ForkReply answer(std::uint64_t number, std::vector<process::FileDescriptor>& files, PreparedTeams& teams,
                 const Connection& connection, const std::string& program) {
  ForkReply reply;
  reply.number = number;
  const bool has_trail = files.size() == 5;
  if (files.size() != 4 && !has_trail) return reply;
  try {
    const Job job = job_from_json(process::everything_in(files[0].number));
    PreparedTeams::Match match = teams.prepare(job);
    if (!match.changed.empty()) return reply;
    // The copy has the name of a worker from its start, so that a user who kills servers by name kills no match.
    be_called(worker_command);
    reply.process = copy_for_parent();
    if (reply.process != 0) be_called(server_command);
    if (reply.process == 0) {
      files[0].reset();
      play_in_copy(job, std::move(match),
                   {files[1].number, files[2].number, files[3].number, has_trail ? files[4].number : -1, -1},
                   connection, program);
    }
    if (reply.process == -1 && errno != EAGAIN && errno != ENOMEM) reply.state = ForkReply::State::unfit;
  } catch (const ServerEnds& ends) {
    reply.state = ends.why;
  } catch (const std::exception&) {  // ignored: the coordinator then starts a new program, which will report the error
  }
  return reply;
}

}  // namespace

void ForkServer::begin() {
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) == -1) return;
  socket_.reset(ends[0]);
  const process::FileDescriptor theirs(ends[1]);
  process::Setting setting;
  setting.files = {{theirs.number, server_descriptor}};
  setting.limits = memory_limits(limits_);
  const std::vector<char*> variables = environment(false);
  begun_ = true;
  try {
    server_ = process::Child::program(setting, {process::Child::this_program, {"regista", server_command}, variables});
  } catch (const std::system_error&) {
    // The error is ignored, because without a server each worker is a newly started program.
  }
}

void ForkServer::end() {
  socket_.reset();
  if (!begun_) return;
  begun_ = false;
  if (server_.runs()) {
    server_.kill();
    server_.wait();
  }
  end_strays_();
}

bool ForkServer::ask(const WorkerFiles& files) {
  std::vector<int> passed{files.job, files.answer, files.note, files.output};
  if (files.trail != -1) passed.push_back(files.trail);
  return process::send_with_files(socket_.number, ++number_, passed);
}

// Waits for the reply. Returns nothing if the server has died, hangs while it loads a plugin, or sends no valid reply.
std::optional<ForkReply> ForkServer::hear() {
  constexpr int patience = 100;  // ms between two checks of the server
  process::CallWatch<int> watch({limits_.processor_seconds, longest_wait});
  for (;;) {
    pollfd watched{socket_.number, POLLIN, 0};
    if (poll(&watched, 1, patience) == 1) break;
    const bool too_long = watch.look(0, true, server_.process()) != process::Exceeded::nothing;
    if (too_long || server_.look()) return std::nullopt;  // look(): the server has died or is stopped
  }
  ForkReply reply;
  std::vector<process::FileDescriptor> none;
  if (!process::receive_with_files(socket_.number, reply, none) || reply.number != number_) return std::nullopt;
  return reply;
}

process::Child ForkServer::start(const Job& job, const WorkerFiles& files) {
  // A match with minds in other processes and a perturbed match need a newly started program.
  if (job.is_apart() || job.perturbed || job.plugin_files.empty() || deaths_ >= most_deaths) return {};
  if (!server_.runs()) begin();
  const std::optional<ForkReply> reply = server_.runs() && ask(files) ? hear() : std::optional<ForkReply>();
  if (!reply) {
    ++deaths_;
    end();
    return {};
  }
  // Gives the worker its own process group, because the server's group is killed with the server.
  if (reply->process != -1) ::setpgid(reply->process, reply->process);
  deaths_ = reply->state == ForkReply::State::unfit ? most_deaths : 0;
  if (reply->state != ForkReply::State::ready) end();
  return process::Child(reply->process);
}

void serve_matches(const std::string& program) {
  int kind = 0;
  socklen_t size = sizeof kind;
  if (::getsockopt(server_descriptor, SOL_SOCKET, SO_TYPE, &kind, &size) == -1 || kind != SOCK_SEQPACKET) {
    throw config::BadInput(fmt::format("{}: is for the program itself, which starts it for a study", server_command));
  }
  const Connection connection{away_from_plugins(server_descriptor), ::getppid()};
  PreparedTeams teams;
  for (;;) {
    std::uint64_t number = 0;
    std::vector<process::FileDescriptor> files;
    if (!process::receive_with_files(connection.socket.number, number, files)) return;
    const ForkReply reply = answer(number, files, teams, connection, program);
    if (!process::send_with_files(connection.socket.number, reply, {}) || reply.state != ForkReply::State::ready)
      return;
  }
}

}  // namespace regista::campaign

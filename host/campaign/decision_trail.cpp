// SPDX-License-Identifier: MIT
#include "campaign/decision_trail.hpp"

#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <map>
#include <span>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "config/bytes.hpp"

namespace regista::campaign {
namespace {

constexpr std::size_t room = std::size_t{1} << 16;

struct Entry {
  double time = 0.0;
  std::int32_t side = 0, robot = 0;
  match::DecisionDigest steps{};
};

template <class Archive>
void visit(Archive& archive, Entry& entry) {
  archive(entry.time, entry.side, entry.robot);
  for (std::uint64_t& each : entry.steps) archive(each);
}

std::span<const std::uint8_t> bytes_of(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

using Plugins = std::array<std::vector<std::string>, 2>;  // by side, then step

Plugins read_plugins(config::BytesIn& bytes) {
  Plugins out;
  for (std::vector<std::string>& side : out) bytes(side);
  for (std::vector<std::string>& side : out) side.resize(match::decision_steps);
  return out;
}

}  // namespace

TrailWriter::TrailWriter(int descriptor, const std::array<const mind::TeamPlan*, 2>& plans) : descriptor_(descriptor) {
  config::BytesOut head;
  for (const mind::TeamPlan* plan : plans) {
    std::vector<std::string> plugins;
    for (std::size_t step = 0; step < match::decision_steps; ++step) {
      plugins.push_back(match::plugins_of_step(*plan, step));
    }
    head(plugins);
  }
  waiting_.assign(head.bytes().begin(), head.bytes().end());
}

void TrailWriter::add(const match::Decision& decision, const match::DecisionDigest& digest) {
  config::BytesOut bytes;
  Entry entry{decision.time, static_cast<std::int32_t>(match::index(decision.side)), decision.number, digest};
  bytes(entry);
  waiting_.append(bytes.bytes().begin(), bytes.bytes().end());
  if (waiting_.size() >= room) flush();
}

void TrailWriter::flush() {
  std::string_view rest = waiting_;
  while (!rest.empty()) {
    const ssize_t count = ::write(descriptor_, rest.data(), rest.size());
    if (count == -1 && errno == EINTR) continue;
    if (count <= 0) break;  // then the trail ends early, which is seen
    rest.remove_prefix(static_cast<std::size_t>(count));
  }
  waiting_.clear();
}

void TrailWriter::close() { flush(); }

TrailFile::TrailFile() : descriptor_(memfd_create("regista-trail", MFD_CLOEXEC)) {
  if (descriptor_ == -1) throw std::system_error(errno, std::generic_category(), "cannot make a trail");
}

TrailFile::~TrailFile() { ::close(descriptor_); }

void TrailFile::clear() {
  if (ftruncate(descriptor_, 0) == 0) lseek(descriptor_, 0, SEEK_SET);
}

std::string TrailFile::content() const {
  std::string out(static_cast<std::size_t>(std::max<off_t>(lseek(descriptor_, 0, SEEK_END), 0)), '\0');
  std::size_t done = 0;
  while (done < out.size()) {
    const ssize_t count = pread(descriptor_, out.data() + done, out.size() - done, static_cast<off_t>(done));
    if (count == -1 && errno == EINTR) continue;
    if (count <= 0) break;
    done += static_cast<std::size_t>(count);
  }
  out.resize(done);
  return out;
}

std::string first_difference(const std::string& first, const std::string& second) {
  if (first == second) return {};
  config::BytesIn a(bytes_of(first)), b(bytes_of(second));
  try {
    const Plugins plugins = read_plugins(a);
    if (read_plugins(b) != plugins) return "the teams differ";
    std::map<std::pair<std::int32_t, std::int32_t>, std::uint64_t> decisions;  // of each robot so far
    while (!a.empty() && !b.empty()) {
      Entry one, other;
      a(one);
      b(other);
      const std::uint64_t tick = decisions[{one.side, one.robot}]++;
      const std::string who =
          fmt::format("{}, robot {}, tick {} ({:.2f} s)", one.side == 0 ? "home" : "away", one.robot, tick, one.time);
      if (one.time != other.time || one.side != other.side || one.robot != other.robot) {
        return fmt::format("{}: it was not its turn in the second play", who);
      }
      for (std::size_t step = 0; step < match::decision_steps; ++step) {
        if (one.steps[step] == other.steps[step]) continue;
        const std::string& ids = plugins[one.side == 0 ? 0 : 1][step];
        return fmt::format("{}: {} first differed{}", who, match::step_name(step),
                           ids.empty() ? "" : ", computed by " + ids);
      }
    }
  } catch (const std::out_of_range&) {
  }
  return "one of the plays ended earlier";
}

}  // namespace regista::campaign

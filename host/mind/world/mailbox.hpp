// SPDX-License-Identifier: MIT
// The mailboxes of one robot's plugins: what they offer for the next packets, what left, what arrived. Every plugin
// instance has a place, numbered in the order of the team's page, so that bytes find the same place in the minds of the
// teammates. Segments: see packet.hpp. What becomes of them is counted, and kept in a journal where somebody records.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "mind/extensions/extensions.hpp"
#include "mind/world/packet.hpp"
#include "mind/world/segment_counts.hpp"
#include "mind/world/segment_journal.hpp"
#include "plugin/kinds.hpp"

namespace regista::mind {

class Mailboxes {
 public:
  // `packet_size` in bytes; room is kept for the largest core. `keeps_journal`: see journal().
  explicit Mailboxes(std::size_t packet_size, bool keeps_journal = false);
  ~Mailboxes();
  Mailboxes(const Mailboxes&) = delete;
  Mailboxes& operator=(const Mailboxes&) = delete;

  // The way out for the next instance, to be given to its create; then connect() that instance.
  // `extensions`: what it is given when it asks for one; outlives the mailboxes. Null: it gets none.
  const regista_host* open(const InstanceExtensions* extensions = nullptr);
  void connect(const std::shared_ptr<plugin::Instance>& instance);

  // Sets the time and drops what has expired. Plugins hear of what was dropped here and in pending().
  void begin(double now);
  // All that waits, oldest first. Valid until the next call.
  std::span<const regista_offer> pending();
  // Bytes for segments in a packet with the largest core.
  std::uint32_t bytes_free() const;
  // Appends the granted offers that fit to the packet and tells their plugins.
  void load(std::span<const std::uint64_t> granted, std::vector<std::uint8_t>& packet);
  // `at`: which segment of its packet, from 0.
  void deliver(const Segment& segment, int at, int sender, double time_sent, double time_heard);
  // The segments of a packet do not end where it does: nobody gets them.
  void wrong_length(int sender, double time_sent, double time_heard);

  // What was counted since the last call.
  SegmentCounts take_counts();
  // What became of segments since begin(), in the order in which it happened; nothing where no journal is kept.
  std::span<const SegmentEvent> journal() const;
  // At the end of a decision: asks plugins what their offers say. Throws plugin::Failure.
  void complete_journal();

 private:
  struct Endpoint;
  struct Waiting {
    regista_offer offer{};
    std::size_t place = 0;
    std::array<std::uint8_t, 255> bytes{};  // `offer.bytes` of them, less the heading
  };
  struct Dropped {
    std::uint64_t handle;
    std::size_t place;
  };
  std::uint64_t offer(std::size_t place, std::span<const std::uint8_t> bytes, double urgency, double expiry, int medium,
                      std::uint64_t replaces);
  std::vector<Waiting>::iterator drop(std::vector<Waiting>::iterator offer, SegmentEvent::Why why);
  void refuse(std::size_t place, std::span<const std::uint8_t> bytes, double urgency, double expiry,
              SegmentEvent::Why why);
  SegmentEvent* note(SegmentEvent::Kind kind, SegmentEvent::Why why, std::size_t place);  // null: nobody records
  void tell_dropped();
  std::size_t longest_segment() const;

  std::size_t packet_size_;
  double now_ = 0.0;
  bool describing_ = false;
  std::uint64_t last_handle_ = 0;
  std::vector<Waiting> waiting_;
  std::vector<Dropped> dropped_, telling_;
  std::vector<regista_offer> listed_;
  SegmentCounts counts_;
  std::unique_ptr<SegmentJournal> journal_;
  std::vector<std::unique_ptr<Endpoint>> endpoints_;  // last: an instance may withdraw while it is destroyed
};

}  // namespace regista::mind

// SPDX-License-Identifier: MIT
// Mailboxes passes segments (see packet.hpp) between the plugins of teammates: a plugin offers a segment, a packet
// carries this segment, and the teammates' plugins receive it. Every plugin instance has a place: its number in the
// order of creation. The order is the same for all teammates, so a segment reaches the same plugin in each mind.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "mind/extensions/extensions.hpp"
#include "mind/world/packet.hpp"
#include "plugin/kinds.hpp"

namespace regista::mind {

class Mailboxes {
 public:
  // `packet_size`: most bytes of a packet; the largest core and all segments must fit. `keeps_journal`: see journal().
  explicit Mailboxes(std::size_t packet_size, bool keeps_journal = false);
  ~Mailboxes();
  Mailboxes(const Mailboxes&) = delete;
  Mailboxes& operator=(const Mailboxes&) = delete;

  // open() returns the host functions for creating the next instance. The caller must then call connect() with this
  // instance. `extensions` must outlive the mailboxes; null: the instance gets no extensions.
  const regista_host* open(const InstanceExtensions* extensions = nullptr);
  void connect(const std::shared_ptr<plugin::Instance>& instance);

  // Begins a decision: sets the match time, drops expired offers. begin() and pending() report drops to the plugins.
  void begin(double now);
  std::span<const regista_offer> pending();  // Returns the waiting offers, the oldest first. Valid until the next call.
  // Returns the number of bytes that a packet with the largest core has for segments.
  std::uint32_t bytes_free() const;
  // Appends to `packet` those granted offers that fit, and tells their plugins. `granted`: handles of offers.
  void load(std::span<const std::uint64_t> granted, std::vector<std::uint8_t>& packet);
  // Gives a teammate's segment to the plugin at the segment's place. `at`: index of the segment in its packet, from 0.
  void deliver(const Segment& segment, int at, int sender, double time_sent, double time_heard);
  // Records that the last segment of a packet is longer than the packet. No plugin gets this segment.
  void wrong_length(int sender, double time_sent, double time_heard);

  SegmentCounts take_counts();  // Returns the counts since the last take_counts().
  // Returns the events since begin() in order of time; nothing if `keeps_journal` was false.
  std::span<const SegmentEvent> journal() const { return journal_; }
  // Asks plugins at the end of a decision to describe their offers in the journal. A failure's text is the description.
  void complete_journal();

 private:
  struct Endpoint;
  struct Waiting {
    regista_offer offer{};
    std::size_t place = 0;
    std::array<std::uint8_t, 255> bytes{};  // the first offer.bytes - segment_heading elements are used
  };
  struct Dropped {
    std::uint64_t handle;
    std::size_t place;
  };
  std::uint64_t offer(std::size_t place, std::span<const std::uint8_t> bytes, double urgency, double expiry, int medium,
                      std::uint64_t replaces);
  std::vector<Waiting>::iterator drop(std::vector<Waiting>::iterator offer, SegmentEvent::Why why);
  // note() returns null without a journal, and where the journal of this decision is full. add() requires a journal.
  SegmentEvent* note(SegmentEvent::Kind kind, SegmentEvent::Why why, std::size_t place);
  SegmentEvent& add(SegmentEvent::Kind kind, SegmentEvent::Why why, int place);
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
  bool keeps_journal_, begun_ = false;  // begun_: begin() has been called
  std::vector<SegmentEvent> journal_;
  std::vector<std::unique_ptr<Endpoint>> endpoints_;  // last member: a destroyed instance may withdraw offers
};

}  // namespace regista::mind

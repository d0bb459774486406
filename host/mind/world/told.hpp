// SPDX-License-Identifier: MIT
// delta of the paper for one object class of OLM_j (Affinita et al. 2023): "merges the OLM of the previous step with
// any received event". A packet holds what its sender believes now of the objects that it tells, so a told track takes
// the place of the known one that it continues: both rest on the same sightings, and fusing them would count these
// twice. What a packet leaves out is kept while the sender may have left it out for its age, with less weight where its
// camera may have looked in vain; between packets the predictor's own law carries all of it forward.
#pragma once

#include <span>
#include <vector>

#include "mind/geometry.hpp"
#include "regista/abi.h"

namespace regista::mind {

// What the sender of a packet can have seen of late, and what it would have told. Field frame.
struct SenderView {
  Pose pose;
  double half_angle = 0.0;   // rad: of the image, and what the head turns
  double range = 0.0;        // m
  double probability = 0.0;  // of seeing what is there
  double tells_up_to = 0.0;  // s: it tells what it has seen since then
  bool tells_all = true;     // the packet had room for more
};

// Both lists are of the same moment, that of the packet's arrival. Replaces `out`, which must be neither. Told tracks
// that continue a known one take its label, others get labels that neither list has; known ones keep theirs.
void merge_told(std::span<const regista_track> known, std::span<const regista_track> told, const SenderView& sender,
                std::vector<regista_track>& out);

}  // namespace regista::mind

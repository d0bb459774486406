// SPDX-License-Identifier: MIT
// The formats of recordings, a reader each; read_recording() of recording.hpp chooses.
#pragma once

#include "study/prediction/recording.hpp"

namespace regista::study {

// Raw detections of the cameras of the Small Size League, millimetres: `event,t,x_mm,y_mm` for the ball,
// `event,t,team,id,x_mm,y_mm,theta` for robots (teams b and y); states of the referee: `event,t,state`. Events are the
// stretches; they may overlap in time.
GameRecording read_ssl_ball(const std::filesystem::path& data, const std::filesystem::path& referee,
                            const Progress& progress);
GameRecording read_ssl_robots(const std::filesystem::path& data, const std::filesystem::path& referee,
                              const Progress& progress);

// Tracking of the 2D simulation league, one line per cycle of 0.1 s: `#,playmode,b_x,b_y,l1_x,l1_y,...,r11_x,r11_y`.
// Its y points to the right and is turned. The game runs while the mode is play_on. `subject` says who is taken.
GameRecording read_simulation_2d(const std::filesystem::path& data, config::PredictorStudy::Subject subject,
                                 const Progress& progress);

}  // namespace regista::study

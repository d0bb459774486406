// SPDX-License-Identifier: MIT
#include "study/prediction/observations.hpp"

#include <Random123/philox.h>

#include <cstdint>
#include <map>

namespace regista::study {

std::vector<bool> shown(const Stretch& stretch, const config::PredictorStudy::Observations& observations) {
  constexpr double slack = 1e-6;  // s: recordings round their times
  std::vector<bool> out(stretch.samples.size(), false);
  std::map<int, double> last;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const Sample& sample = stretch.samples[i];
    if (observations.every > 0.0) {
      const auto [place, first] = last.emplace(sample.object, sample.time);
      if (!first && sample.time - place->second < observations.every - slack) continue;
      place->second = sample.time;
    }
    const r123::Philox4x32::ctr_type counter{{static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(sample.object),
                                              static_cast<std::uint32_t>(stretch.number), 0}};
    const r123::Philox4x32::key_type key{{static_cast<std::uint32_t>(observations.seed), 0}};
    out[i] = r123::Philox4x32{}(counter, key)[0] * 0x1p-32 >= observations.drop;
  }
  return out;
}

}  // namespace regista::study

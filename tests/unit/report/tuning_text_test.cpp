// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include "report/tuning_sentences.hpp"
#include "tuning_course.hpp"

namespace regista::report {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

TEST(TuningText, AClearWin) {
  const TunedCourse course(tuning_plan());
  const std::string text = tuning_text(course.view());
  if (std::getenv("SHOW")) fmt::print("{}\n{}", text, course.standings.substr(course.standings.size() - 2000));
  EXPECT_TRUE(course.record.verified());
  EXPECT_THAT(text, HasSubstr("The tuned team is better than the base team, on seeds that nobody has chosen by."));
}

}  // namespace
}  // namespace regista::report

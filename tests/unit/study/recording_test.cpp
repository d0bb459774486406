// SPDX-License-Identifier: MIT
// Recordings as they should be, and all that may be wrong with them: what is said, and at which place.
#include "study/prediction/game_recording.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>
#include <zlib.h>

#include <filesystem>
#include <fstream>
#include <limits>
#include <string>

namespace regista::study {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

using Study = config::PredictorStudy;

GameRecording read(const fs::path& file, Study::Format format, Study::Subject subject = Study::Subject::ball,
                   const Progress& progress = {}) {
  Study study;
  study.format = format;
  study.subject = subject;
  return read_recording(study, file, {}, progress);
}

class Recordings : public testing::Test {
 protected:
  Recordings()
      : folder_(fs::temp_directory_path() / ("regista_recordings_" + std::to_string(getpid()) + "_" +
                                             testing::UnitTest::GetInstance()->current_test_info()->name())) {
    fs::create_directories(folder_);
    write("m_referee.csv", "event,t,state\n3,1.5,Stop\n3,2.0,GameRunning\n3,4,Halt\n4,0,GameRunning\n");
  }
  ~Recordings() override { fs::remove_all(folder_); }

  fs::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }
  fs::path compress(const std::string& name, const std::string& text) const {
    const gzFile file = gzopen((folder_ / name).c_str(), "wb");
    gzwrite(file, text.data(), static_cast<unsigned>(text.size()));
    gzclose(file);
    return folder_ / name;
  }

  // What is said about a recording of the ball with this text, without the folder.
  std::string complaint(const std::string& text, const std::string& name = "m_ball_raw.csv") const {
    return complaint_of(write(name, text));
  }
  std::string complaint_of(const fs::path& file) const {
    try {
      config::PredictorStudy study;
      read_recording(study, file, {});
    } catch (const config::Error& error) {
      std::string said = error.what();
      const std::size_t place = said.find(folder_.string() + "/");
      if (place == 0) said.erase(0, folder_.string().size() + 1);
      return said;
    }
    return "";
  }

  fs::path folder_;
};

TEST_F(Recordings, OfTheBallAreReadInMetresWithTheStatesOfTheReferee) {
  const std::string text = "event,t,x_mm,y_mm\r\n3,1.9,-1500,250.5\r\n3,2.5,-1400,0\n\n4,0.5,0,0";
  for (const fs::path& file : {write("m_ball_raw.csv", text), compress("m_ball_raw.csv.gz", text)}) {
    const GameRecording recording = read(file, Study::Format::ssl_ball);
    ASSERT_EQ(recording.stretches.size(), 2u);
    const Stretch& first = recording.stretches[0];
    EXPECT_EQ(first.number, 3);
    ASSERT_EQ(first.samples.size(), 2u);
    EXPECT_EQ(first.samples[0].time, 1.9);
    EXPECT_DOUBLE_EQ(first.samples[0].x, -1.5);
    EXPECT_DOUBLE_EQ(first.samples[0].y, 0.2505);
    EXPECT_FALSE(first.runs_at(1.0)) << "before the referee said anything";
    EXPECT_FALSE(first.runs_at(1.9));
    EXPECT_TRUE(first.runs_at(2.0));
    EXPECT_TRUE(first.runs_at(3.99));
    EXPECT_FALSE(first.runs_at(4.0));
    EXPECT_EQ(recording.stretches[1].samples.size(), 1u);
  }
}

TEST_F(Recordings, OfRobotsTellThemApart) {
  const fs::path file =
      write("m_robots_raw.csv", "event,t,team,id,x_mm,y_mm,theta\n3,2,b,7,1000,0,0\n3,2,y,7,0,1000,0\n");
  const GameRecording recording = read(file, Study::Format::ssl_robots, Study::Subject::opponents);
  ASSERT_EQ(recording.stretches.at(0).samples.size(), 2u);
  EXPECT_EQ(recording.stretches[0].samples[0].object, robot_object(1, 7));
  EXPECT_EQ(recording.stretches[0].samples[1].object, robot_object(2, 7));
}

TEST_F(Recordings, OfTheSimulationAreTurnedToTheLeft) {
  const fs::path file =
      write("s.csv", "#,playmode,b_x,b_y\n1,kick_off_l,0,0\n2,play_on,1,2\n4,play_on,2,-3\n5,goal_l,0,0\n");
  const GameRecording recording = read(file, Study::Format::simulation_2d);
  const Stretch& all = recording.stretches.at(0);
  ASSERT_EQ(all.samples.size(), 4u);
  EXPECT_DOUBLE_EQ(all.samples[1].time, 0.2);
  EXPECT_EQ(all.samples[1].y, -2.0) << "its y points to the right";
  EXPECT_FALSE(all.runs_at(0.1));
  EXPECT_TRUE(all.runs_at(0.25));
  EXPECT_FALSE(all.runs_at(0.5));
  try {
    read(file, Study::Format::simulation_2d, Study::Subject::opponents);
    FAIL() << "there are no players in it";
  } catch (const config::Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("unknown column \"l1_x\" in this file"));
  }
}

TEST_F(Recordings, ThatAreWrongAreRefusedAtThePlace) {
  const std::string head = "event,t,x_mm,y_mm\n3,1,0,0\n";
  EXPECT_EQ(complaint(head + "3,2,nan,0\n"), "m_ball_raw.csv:3:5: x_mm: \"nan\" is not finite");
  EXPECT_EQ(complaint(head + "3,2,0,-inf\n"), "m_ball_raw.csv:3:7: y_mm: \"-inf\" is not finite");
  EXPECT_EQ(complaint(head + "3,2,1e999,0\n"), "m_ball_raw.csv:3:5: x_mm: \"1e999\" is beyond all numbers");
  EXPECT_EQ(complaint(head + "3,2,12a,0\n"), "m_ball_raw.csv:3:5: x_mm: \"12a\" is no number");
  EXPECT_EQ(complaint(head + "3,2,,0\n"), "m_ball_raw.csv:3:5: x_mm: \"\" is no number");
  EXPECT_EQ(complaint(head + "x,2,0,0\n"), "m_ball_raw.csv:3:1: event: \"x\" is no whole number from 0 to 1000000000");
  EXPECT_EQ(complaint(head + "3,0.5,0,0\n"), "m_ball_raw.csv:3:3: t: \"0.5\" runs backwards: the line before says 1");
  EXPECT_EQ(complaint(head + "4,0,0,0\n3,5,0,0\n"),
            "m_ball_raw.csv:4:1: event: \"3\" comes back; its lines began at line 2");
  EXPECT_EQ(complaint(head + "3,2,200000,0\n"),
            "m_ball_raw.csv:3:5: x_mm: \"200000\" is more than 100 m from the centre");
  EXPECT_EQ(complaint(head + "3,2,0\n"), "m_ball_raw.csv:3:1: 3 values, but the first line names 4 columns");
  EXPECT_EQ(complaint("event,t,team,id,x_mm,y_mm,theta\n"),
            "m_ball_raw.csv:1:1: is a recording of robots; expected one of the ball");
}

TEST_F(Recordings, ThatAreNoneAreRefused) {
  EXPECT_EQ(complaint(""), "m_ball_raw.csv: is empty; expected a first line with the names of columns");
  EXPECT_EQ(complaint("event,t,x_mm,y_mm\n"), "m_ball_raw.csv: holds no detection");
  EXPECT_THAT(complaint("\x89PNG\r\n\x1a\n\0\0\0\rIHDR"), HasSubstr("m_ball_raw.csv:1:1: byte 0x89 is not UTF-8"));
  EXPECT_EQ(
      complaint("a,b\n1,2\n"),
      "m_ball_raw.csv:1:1: unknown column \"x_mm\" in this file; known: a, b; a recording of the ball has the columns "
      "event, t, x_mm, y_mm");
  EXPECT_THAT(complaint(std::string(100'000, 'x')), HasSubstr("m_ball_raw.csv:1:1: is longer than 65536 bytes"));
  EXPECT_THAT(complaint("\x1f\x8b\x08" + std::string(300, 'x')), HasSubstr("m_ball_raw.csv:1:1: cannot be read on"));
  EXPECT_THAT(complaint_of(folder_), HasSubstr("is a folder, not a table"));
  EXPECT_THAT(complaint_of(folder_ / "none.csv"), HasSubstr("none.csv: cannot be opened: No such file"));
  EXPECT_THAT(complaint("event,t,x_mm,y_mm\n3,1,0,0\n", "other.csv"),
              HasSubstr("the states of the referee are missing"));
}

TEST_F(Recordings, AreRefusedWithTheRefereeOfAnotherMatch) {
  // Event 3 has states from 1.5 to 4 s, event 4 at 0 s.
  EXPECT_EQ(
      complaint("event,t,x_mm,y_mm\n3,11,0,0\n3,12,0,0\n"),
      "m_referee.csv: belongs to another match: its states of event 3 are from 1.5 to 4.0 s, the detections from 11.0 "
      "to 12.0 s");
  EXPECT_EQ(complaint("event,t,x_mm,y_mm\n4,0,0,0\n5,0,0,0\n6,0,0,0\n"),
            "m_referee.csv: belongs to another match: it has no states of 2 of 3 events");
  EXPECT_EQ(complaint("event,t,x_mm,y_mm\n3,5.5,0,0\n4,1.5,0,0\n5,0,0,0\n"), "")
      << "clocks differ, and an event is short";
}

TEST_F(Recordings, ThatWereCutOffAreRefused) {
  std::string text = "event,t,x_mm,y_mm\n";
  for (int i = 0; i < 5000; ++i) text += "3," + std::to_string(i) + "," + std::to_string(i * i % 977) + ",0\n";
  const fs::path whole = compress("m_ball_raw.csv.gz", text);
  EXPECT_EQ(complaint_of(whole), "");
  fs::resize_file(whole, fs::file_size(whole) / 2);
  const std::string said = complaint_of(whole);
  EXPECT_THAT(said, HasSubstr("cannot be read on: "));
  EXPECT_THAT(said, HasSubstr("unexpected end of file"));
}

TEST_F(Recordings, CanBeStoppedWhileTheyAreRead) {
  std::string text = "event,t,x_mm,y_mm\n";
  for (int i = 0; i < 40'000; ++i) text += "3," + std::to_string(i) + ",0,0\n";
  struct Stopped {};
  std::size_t calls = 0;
  EXPECT_THROW(read(write("m_ball_raw.csv", text), Study::Format::ssl_ball, Study::Subject::ball,
                    [&](std::size_t) {
                      if (++calls == 2) throw Stopped{};
                    }),
               Stopped);
}

}  // namespace
}  // namespace regista::study

// SPDX-License-Identifier: BSD-3-Clause
#include "sim/record/run_reader.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "models/support/config_error.h"
#include "tests/support/synthetic_run.h"

namespace sidestep::run_reader_test {
namespace {

using ::sidestep::testing::FreshTestDir;
using ::sidestep::testing::WriteSyntheticRun;

std::string ErrorOf(const std::function<void()>& work) {
  try {
    work();
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "no error";
}

std::filesystem::path CsvFile(const std::string& text) {
  auto file = FreshTestDir("csv") / "table.csv";
  std::ofstream(file, std::ios::binary) << text;
  return file;
}

TEST(CsvTableTest, ColumnsAreFoundByName) {
  const CsvTable table = CsvTable::Read(CsvFile("foot,x_m\nleft,0.5\nright,-1e-3\n"));
  ASSERT_EQ(table.num_rows(), 2U);
  EXPECT_EQ(table.Text(1, "foot"), "right");
  EXPECT_EQ(table.Numbers("x_m"), (std::vector<double>{0.5, -1e-3}));
  EXPECT_TRUE(table.has("x_m"));
  EXPECT_FALSE(table.has("x"));
}

TEST(CsvTableTest, AnEmptyCellOrAWordIsNoNumber) {
  const CsvTable table = CsvTable::Read(CsvFile("a,b\n,1\nfast,2\n3,\n"));
  const auto a = table.Numbers("a");
  EXPECT_TRUE(std::isnan(a[0]));
  EXPECT_TRUE(std::isnan(a[1]));
  EXPECT_EQ(a[2], 3.0);
  EXPECT_TRUE(std::isnan(table.Numbers("b")[2]));
}

TEST(CsvTableTest, ALastRowThatWasCutShortIsDropped) {
  EXPECT_EQ(CsvTable::Read(CsvFile("a,b\n1,2\n3")).num_rows(), 1U);
  EXPECT_EQ(CsvTable::Read(CsvFile("a,b\n1,2\n3,4.1")).num_rows(), 1U)
      << "4.1 may have been going to be 4.12";
  EXPECT_EQ(CsvTable::Read(CsvFile("a,b\n1,2\n3,4\n")).num_rows(), 2U);
}

TEST(CsvTableTest, ARowOfAnotherWidthIsAnErrorWithItsLine) {
  const auto file = CsvFile("a,b\n1,2\n3\n5,6\n");
  EXPECT_EQ(ErrorOf([&] { CsvTable::Read(file); }),
            file.string() + ":3:1: error: expected 2 cells, found 1");
}

TEST(CsvTableTest, AMissingColumnIsNamedWithItsFile) {
  const auto file = CsvFile("a,b\n1,2\n");
  EXPECT_EQ(ErrorOf([&] { CsvTable::Read(file).Numbers("c"); }),
            file.string() + ": error: has no column 'c'");
}

TEST(RunReaderTest, StatesComeBackAsTheyWereWritten) {
  const auto dir = FreshTestDir("states");
  WriteSyntheticRun(dir);
  const StateLog log = ReadStates(dir);
  ASSERT_EQ(log.rows.size(), 50U);
  EXPECT_EQ(log.feet, (std::vector<std::string>{"left", "right"}));
  EXPECT_NEAR(log.duration_s(), 0.5, 1e-12);
  const StateRow& row = log.rows[25];
  EXPECT_NEAR(row.time_s, 0.25, 1e-12);
  EXPECT_EQ(row.qpos.size(), 13);
  EXPECT_TRUE(row.push_force_W.isApprox(Eigen::Vector3d(0, 40, 0)));
  EXPECT_TRUE(row.feet[1].nominal_p_WF.isApprox(Eigen::Vector3d(0, -0.08, 0)));
  EXPECT_NEAR(row.feet[0].f_F_W.z(), 0.5 * 9.81 * 20.0, 1e-9);
}

TEST(RunReaderTest, ATruncatedLastRowOfStatesIsIgnored) {
  const auto dir = FreshTestDir("states_truncated");
  WriteSyntheticRun(dir);
  const auto file = dir / "states.bin";
  std::filesystem::resize_file(file, std::filesystem::file_size(file) - 1);
  EXPECT_EQ(ReadStates(dir).rows.size(), 49U);
}

TEST(RunReaderTest, StatesThatAreNoneAreRefusedWithTheReason) {
  const auto dir = FreshTestDir("states_bad");
  const auto error_for = [&](const std::string& bytes) {
    std::ofstream(dir / "states.bin", std::ios::binary) << bytes;
    return ErrorOf([&] { ReadStates(dir); });
  };
  const std::string name = (dir / "states.bin").string() + ": error: ";
  EXPECT_EQ(error_for("sidestep-states 2\n"), name + "is not a states.bin of version 1");
  EXPECT_EQ(error_for("sidestep-states 1\nnq\n"),
            (dir / "states.bin").string() + ":1:2: error: the JSON breaks off here");
  EXPECT_EQ(error_for("sidestep-states 1\n"
                      R"({"nq": 3, "feet": ["f"], "row_doubles": 9, "dt_s": 0.1})"
                      "\n"),
            name + "its header says row_doubles = 9, expected 22");
  EXPECT_EQ(error_for("sidestep-states 1\n"
                      R"({"nq": 3, "feet": ["f"], "row_doubles": 22, "dt_s": 0.1})"
                      "\nabc"),
            name + "holds no state");
}

TEST(RunReaderTest, StatesThatWouldAskForTheImpossibleAreRefused) {
  const auto dir = FreshTestDir("states_hostile");
  const auto error_for = [&](const std::string& header, double time_s = 0.0) {
    std::ofstream out(dir / "states.bin", std::ios::binary);
    out << "sidestep-states 1\n" << header << "\n";
    std::vector<double> row(22, 0.0);
    row[0] = time_s;
    for (int i = 0; i < 2; ++i) {
      out.write(reinterpret_cast<const char*>(row.data()), 22 * sizeof(double));
    }
    out.close();
    return ErrorOf([&] { ReadStates(dir); });
  };
  const auto header = [](const std::string& nq, const std::string& row, const std::string& dt) {
    return "{\"nq\": " + nq + R"(, "feet": ["f"], "row_doubles": )" + row + ", \"dt_s\": " + dt +
           "}";
  };
  const std::string name = (dir / "states.bin").string() + ": error: ";
  const std::string nq = name + "its header's nq must be a whole number from 0 to 10000";
  EXPECT_EQ(error_for(header("2147483600", "2147483619", "0.1")), nq) << "34 GB";
  EXPECT_EQ(error_for(header("2147483647", "-2147483630", "0.1")), nq) << "overflows";
  EXPECT_EQ(error_for(header("1e10", "22", "0.1")), nq);
  EXPECT_EQ(error_for(header("3", "22", "1e-300")),
            name + "its header's dt_s must be from 1e-6 to 10 s");
  EXPECT_EQ(error_for(header("3", "22", "0.1"), std::nan("")),
            name + "its row 0 is of another time than nan s");
  EXPECT_EQ(error_for(header("3", "22", "0.1")),
            name + "its row 1 is of another time than 0.100000 s");
  EXPECT_EQ(error_for(std::string(200000, '[') + std::string(200000, ']')),
            name + "is nested deeper than 32");
}

TEST(RunReaderTest, FootstepsKeepTheirOrderAndAnUnlandedOneHasNoPlace) {
  const auto dir = FreshTestDir("footsteps");
  WriteSyntheticRun(dir, {.duration_s = 1.0});
  std::ofstream(dir / "footsteps.csv", std::ios::app)
      << "left,1,1.0,1.5,0.1,0.08,0,0.1,0.09,0,,,,0,-0.05,-0.03,0.05,0.07,0.2\n";
  const std::vector<Footstep> steps = ReadFootsteps(dir);
  ASSERT_EQ(steps.size(), 4U);
  EXPECT_EQ(steps[2].foot, "right");
  EXPECT_EQ(steps[2].index, 1);
  EXPECT_EQ(steps[2].yaw_rad, 0.3);
  EXPECT_TRUE(steps[2].adjusted_p_WF.isApprox(Eigen::Vector3d(0.12, -0.03, 0)));
  ASSERT_TRUE(steps[2].realised_p_WF.has_value());
  EXPECT_FALSE(steps[3].realised_p_WF.has_value());
  EXPECT_TRUE(steps[3].box_upper_m.isApprox(Eigen::Vector2d(0.05, 0.07)));
}

TEST(RunReaderTest, AStepThatTheGaitDoesNotHaveAndANumberOfNoneAreMinusOne) {
  const auto dir = FreshTestDir("numbers");
  WriteSyntheticRun(dir, {.duration_s = 1.0});
  for (const char* index : {"-1", "1e18", "-1e18", "nan", "-3", ""}) {
    std::ofstream(dir / "footsteps.csv", std::ios::app)
        << "left," << index << ",1.0,1.5,0.1,0.08,0,0.1,0.09,0,,,,0,-0.05,-0.03,0.05,0.07,0.2\n";
    EXPECT_EQ(ReadFootsteps(dir).back().index, -1) << index;
  }
}

TEST(RunReaderTest, MissingFilesAreNamed) {
  const auto dir = FreshTestDir("nothing");
  const std::vector<std::pair<std::string, std::function<void()>>> readers{
      {"states.bin", [&] { ReadStates(dir); }}, {"footsteps.csv", [&] { ReadFootsteps(dir); }}};
  for (const auto& [file, read] : readers) {
    EXPECT_EQ(ErrorOf(read), (dir / file).string() + ": error: can't be read");
  }
}

TEST(RunReaderTest, TheFeetAreReadOffTheTrajectorysHeader) {
  const auto dir = FreshTestDir("feet");
  WriteSyntheticRun(dir);
  EXPECT_EQ(FeetOf(CsvTable::Read(dir / "trajectory.csv")),
            (std::vector<std::string>{"left", "right"}));
}

}  // namespace
}  // namespace sidestep::run_reader_test

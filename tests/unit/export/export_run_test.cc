// SPDX-License-Identifier: BSD-3-Clause
#include "sim/export/export_run.h"

#include <gtest/gtest.h>
#include <matio.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "models/support/config_error.h"
#include "tests/support/run_files.h"
#include "tests/support/synthetic_run.h"

namespace sidestep {
namespace {

namespace fs = std::filesystem;

struct CloseMat {
  void operator()(mat_t* file) const { Mat_Close(file); }
};
struct FreeVar {
  void operator()(matvar_t* variable) const { Mat_VarFree(variable); }
};

class ExportRunTest : public ::testing::Test {
 protected:
  ExportRunTest() : run_dir_(testing::FreshTestDir("export_run")) {
    testing::WriteSyntheticRun(run_dir_);
  }

  std::string ErrorOf(const fs::path& file) const {
    try {
      ExportRun(run_dir_, file);
    } catch (const ConfigError& error) {
      return error.what();
    }
    return {};
  }

  fs::path run_dir_;
};

TEST_F(ExportRunTest, ACsvHasTheSameCellsUnderOtherNames) {
  const fs::path file = run_dir_ / "out.csv";
  ExportRun(run_dir_, file);
  const CsvTable from = CsvTable::Read(run_dir_ / "trajectory.csv"), to = CsvTable::Read(file);
  ASSERT_EQ(to.num_rows(), from.num_rows());
  EXPECT_EQ(to.header().front(), "time_s");
  EXPECT_EQ(to.Numbers("truth/com/position/x_m"), from.Numbers("truth_p_WC_x_m"));
}

TEST_F(ExportRunTest, AMatFileHoldsTheSameNumbersInTheTreeOfICubsViewer) {
  const fs::path file = run_dir_ / "out.mat";
  ExportRun(run_dir_, file);
  const std::unique_ptr<mat_t, CloseMat> mat(Mat_Open(file.c_str(), MAT_ACC_RDONLY));
  ASSERT_TRUE(mat);
  EXPECT_EQ(Mat_GetVersion(mat.get()), MAT_FT_MAT73);
  const std::unique_ptr<matvar_t, FreeVar> root(Mat_VarRead(mat.get(), "robot_logger_device"));
  ASSERT_TRUE(root);
  EXPECT_NE(Mat_VarGetStructFieldByName(root.get(), "description_list", 0), nullptr);
  EXPECT_NE(Mat_VarGetStructFieldByName(root.get(), "yarp_robot_name", 0), nullptr);
  matvar_t* at = root.get();
  for (const char* name : {"truth", "com", "position", "data"}) {
    at = Mat_VarGetStructFieldByName(at, name, 0);
    ASSERT_NE(at, nullptr) << name;
  }
  const CsvTable table = CsvTable::Read(run_dir_ / "trajectory.csv");
  const std::vector<double> x = table.Numbers("truth_p_WC_x_m"),
                            z = table.Numbers("truth_p_WC_z_m");
  ASSERT_EQ(at->rank, 3);
  ASSERT_EQ(at->dims[0], 3u);
  ASSERT_EQ(at->dims[2], table.num_rows());
  const auto* data = static_cast<const double*>(at->data);
  for (std::size_t row = 0; row < table.num_rows(); ++row) {
    ASSERT_EQ(data[3 * row], x[row]);
    ASSERT_EQ(data[3 * row + 2], z[row]);
  }
}

TEST_F(ExportRunTest, ARunThatWasCutShortKeepsItsWholeRows) {
  const fs::path trajectory = run_dir_ / "trajectory.csv";
  const std::size_t rows = CsvTable::Read(trajectory).num_rows();
  fs::resize_file(trajectory, fs::file_size(trajectory) - 40);
  ExportRun(run_dir_, run_dir_ / "out.csv");
  EXPECT_EQ(CsvTable::Read(run_dir_ / "out.csv").num_rows(), rows - 1);
}

TEST_F(ExportRunTest, RefusesOtherEndingsFilesOfTheRunAndPlacesThatCantBeWritten) {
  EXPECT_NE(ErrorOf(run_dir_ / "out.txt").find("expected a name in .mat or .csv"),
            std::string::npos);
  EXPECT_NE(ErrorOf(run_dir_ / "mpc.csv").find("is a file of the run itself"), std::string::npos);
  for (const char* name : {"out.csv", "out.mat"}) {
    EXPECT_NE(ErrorOf(run_dir_ / "missing" / name).find("error: "), std::string::npos) << name;
  }
}

TEST_F(ExportRunTest, TellsWhichColumnHasANameThatNoRunGave) {
  const fs::path trajectory = run_dir_ / "trajectory.csv";
  const auto error_of = [&](const std::string& header) {
    std::ofstream(trajectory) << header << "\n0,0,0\n1,1,1\n";
    std::string error = ErrorOf(run_dir_ / "out.csv");
    EXPECT_EQ(ErrorOf(run_dir_ / "out.mat"), error);
    EXPECT_FALSE(fs::exists(run_dir_ / "out.csv") || fs::exists(run_dir_ / "out.mat"));
    return error.substr(std::min(error.size(), trajectory.string().size()));
  };
  const std::string rule = "a column's name must be of letters, digits, '_', '-' or '.', found ";
  EXPECT_EQ(error_of("time_s,wea\x1bther,b"), ":1:8: error: " + rule + "'wea?ther'");
  EXPECT_EQ(error_of("time_s,b,x\ry"), ":1:10: error: " + rule + "'x y'");
  EXPECT_EQ(error_of("time_s,\"b\",c"), ":1:8: error: " + rule + "'\"b\"'");
  EXPECT_EQ(error_of("time_s,,c"), ":1:8: error: " + rule + "''");
  EXPECT_EQ(error_of("time_s,b,b"), ":1:10: error: there is a column 'b' already");
}

TEST_F(ExportRunTest, AMatFileThatCantBeWrittenLeavesTheOlderOne) {
  const fs::path folder = run_dir_ / "out.mat.part";  // HDF5 can't write there
  fs::create_directory(folder);
  std::ofstream(run_dir_ / "out.mat") << "older";
  const std::string error = ErrorOf(run_dir_ / "out.mat");
  EXPECT_EQ(error, (run_dir_ / "out.mat").string() + ": error: can't be written: Is a directory");
  EXPECT_EQ(TextOf(run_dir_ / "out.mat"), "older");
}

TEST_F(ExportRunTest, RefusesATrajectoryWithoutARow) {
  std::ofstream(run_dir_ / "trajectory.csv") << "time_s\n";
  EXPECT_NE(ErrorOf(run_dir_ / "out.mat").find("holds no row"), std::string::npos);
}

}  // namespace
}  // namespace sidestep

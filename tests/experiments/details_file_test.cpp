#include "experiments/details_file.h"

#include <fstream>

#include <gtest/gtest.h>

#include "schemes/algebra/rational.h"
#include "tests/experiments/temporary_folder.h"
#include "tests/schemes/input_errors.h"

namespace subdiv {
namespace {

TEST(DetailsFile, LevelIndexAndDisplacement) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "details.csv";
  std::ofstream(path) << "level,index,dx,dy\n2,5,1/2,-3\n0,1,0,1e-1\n";
  const auto details = read_details<Rational>(path, 2);
  ASSERT_EQ(details.size(), 2U);
  EXPECT_EQ(details[0].level, 2);
  EXPECT_EQ(details[0].index, 5);
  EXPECT_EQ(details[0].displacement, (std::vector<Rational>{Rational(1, 2), -3}));
  EXPECT_EQ(read_details<double>(path, 2)[1].displacement, (std::vector<double>{0, 0.1}));
}

TEST(DetailsFile, WhatIsNoDetailIsNamed) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "details.csv";
  const auto rejects = [&](const char* text, std::initializer_list<const char*> parts) {
    std::ofstream(path) << text;
    testing::expect_input_error([&] { (void)read_details<double>(path, 2); }, parts);
    testing::expect_input_error([&] { (void)read_details<Rational>(path, 2); }, parts);
  };
  rejects("2,5,1\n", {"details.csv", "3 numbers", "4"});
  rejects("1,1,1,1\n2.5,5,1,1\n", {"detail 2", "whole numbers"});
  rejects("-1,5,1,1\n", {"detail 1", "whole numbers"});
  rejects("1,1e30,1,1\n", {"detail 1", "whole numbers"});
  rejects("63,1,1,1\n", {"detail 1"});
  testing::expect_input_error([] { (void)read_details<double>("details.obj", 2); }, {".csv"});
}

}  // namespace
}  // namespace subdiv

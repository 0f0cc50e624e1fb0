#include "experiments/polygon_file.h"

#include <fstream>

#include <gtest/gtest.h>

#include "schemes/algebra/rational.h"
#include "tests/experiments/temporary_folder.h"
#include "tests/schemes/input_errors.h"

namespace subdiv {
namespace {

using testing::expect_input_error;

class PolygonFileTest : public ::testing::Test {
 protected:
  std::filesystem::path file(const std::string& name, const std::string& text) const {
    const auto path = folder_.path() / name;
    std::ofstream(path, std::ios::binary) << text;
    return path;
  }
  void rejects(const std::string& name, const std::string& text,
               const std::initializer_list<const char*> parts) const {
    const auto path = file(name, text);
    expect_input_error([&] { (void)read_points<double>(path); }, parts);
    expect_input_error([&] { (void)read_points<Rational>(path); }, parts);
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(PolygonFileTest, CsvWithAndWithoutHeader) {
  for (const char* text : {"\xef\xbb\xbfx,y\n+1,+2\n-3/4,1/2\n",
                           "\xef\xbb\xbf"
                           "1,2\n-3/4,1/2\n",
                           "x,y\n1,2\n-3/4, 5e-1\n", "# points\n1,2\r\n\n-0.75,1/2", "1,2\n-.75,.5\n"}) {
    const auto points = read_points<Rational>(file("p.csv", text));
    ASSERT_EQ(points.dimension(), 2U);
    EXPECT_EQ(points.coordinates[0], (std::vector<Rational>{1, Rational(-3, 4)}));
    EXPECT_EQ(points.coordinates[1], (std::vector<Rational>{2, Rational(1, 2)}));
    const auto doubles = read_points<double>(file("p.csv", text));
    EXPECT_EQ(doubles.coordinates[0], (std::vector<double>{1, -0.75}));
    EXPECT_FALSE(doubles.closed);
  }
}

TEST_F(PolygonFileTest, ObjVerticesInTheOrderOfTheLineElement) {
  const std::string vertices = "o loop\nv 0 0 0\nv 1 0 0\nv 0 1/2 1e0\n";
  EXPECT_EQ(read_points<double>(file("p.obj", vertices)).coordinates[2], (std::vector<double>{0, 0, 1}));
  const auto closed = read_points<double>(file("p.obj", vertices + "l 3 1 -2 3\n"));
  EXPECT_EQ(closed.closed, true);
  EXPECT_EQ(closed.coordinates[0], (std::vector<double>{0, 0, 1}));
  EXPECT_EQ(closed.coordinates[1], (std::vector<double>{0.5, 0, 0}));
  EXPECT_EQ(read_points<double>(file("p.obj", vertices + "l 1 2\n")).closed, false);
}

TEST_F(PolygonFileTest, WhatIsWrongIsNamedWithItsLine) {
  rejects("p.csv", "", {"p.csv", "no points"});
  rejects("p.csv", "x,y\n", {"no points"});
  rejects("p.csv", "1,2\n3\n", {"p.csv:2", "1 coordinates", "2"});
  rejects("p.csv", "1,2\n3,4,5\n", {"p.csv:2", "3 coordinates"});
  rejects("p.csv", "x,y\n1,2\n3,\n", {"p.csv:3", "coordinate 2"});
  rejects("p.csv", "1,2\n3,four\n", {"p.csv:2", "coordinate 2", "four"});
  rejects("p.csv", "1,2\nnan,1\n", {"p.csv:2", "coordinate 1", "nan"});
  for (const char* line : {"O,O\n1,2\n", "0x1,0x2\n1,2\n", "-.5.1,+2\n1,2\n", "x,3\n1,2\n"})
    rejects("p.csv", line, {"p.csv:1", "coordinate 1"});
  rejects("p.csv", "nan,-inf\n1,2\n", {"p.csv:1", "coordinate 1", "nan"});
  rejects("p.csv", "1,2\n1,-inf\n", {"p.csv:2", "coordinate 2", "inf"});
  rejects("p.csv", "1,2\n1,1/0\n", {"p.csv:2", "coordinate 2"});
  rejects("p.obj", "v 1 2\n", {"p.obj:1", "v x y z"});
  rejects("p.obj", "v 1 2 z\n", {"p.obj:1", "coordinate 3"});
  rejects("p.obj", "v 1 2 3\nl 1 2\n", {"p.obj:2", "'2'", "1"});
  rejects("p.obj", "v 1 2 3\nv 1 2 3\nl 1 2\nl 1 2\n", {"p.obj:4", "second"});
  rejects("p.obj", "v 1 2 3\nf 1 1 1\n", {"p.obj:2", "face"});
  rejects("p.obj", "# nothing\n", {"no points"});
  rejects("p.txt", "1,2\n", {".csv or .obj"});
  expect_input_error([] { (void)read_points<double>("absent.csv"); }, {"absent.csv", "cannot be read"});
  expect_input_error([&] { (void)read_points<double>(std::filesystem::temp_directory_path() / "."); },
                     {".csv or .obj"});
}

TEST_F(PolygonFileTest, NumbersThatNoDoubleHolds) {
  const auto path = file("p.csv", "1,1e999\n");
  expect_input_error([&] { (void)read_points<double>(path); }, {"p.csv:1", "coordinate 2", "does not fit"});
}

}  // namespace
}  // namespace subdiv

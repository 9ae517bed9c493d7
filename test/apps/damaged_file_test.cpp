// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: files that are cut off, garbage or lie about their size.
#include <pcl/io/pcd_io.h>

#include <gtest/gtest.h>

#include "app_runner.h"
#include "cli/run_facts.h"
#include "io/model_io.h"
#include "model_samples.h"
#include "support/random_source.h"

#include <sstream>

namespace app_test {
namespace {

bool
reads(const std::string& path)
{
  app::Model model;
  const bool is_cloud =
      path.substr(path.size() - 4) == ".pcd" || path.substr(path.size() - 4) == ".xyz";
  const app::Status status =
      is_cloud ? app::readCloud(path, model) : app::readMesh(path, model);
  EXPECT_TRUE(status.ok() || !status.message().empty());
  return status.ok();
}

/** The same for bytes that stand for a file of this name. */
bool
readsBytes(const std::string& name, const std::string& bytes)
{
  app::Model model;
  const app::FileFormat format = app::formatOfPath(name);
  const bool is_cloud =
      format == app::FileFormat::PCD || format == app::FileFormat::XYZ;
  const app::Status status =
      is_cloud ? app::parseCloud(format, bytes.data(), bytes.size(), model)
               : app::parseMesh(format, bytes.data(), bytes.size(), model);
  EXPECT_TRUE(status.ok() || !status.message().empty());
  return status.ok();
}

/** A small sound file of the format; "c.pcd" stands for a compressed one. */
std::string
soundFile(const TemporaryFolder& folder, const std::string& name)
{
  const std::string path = folder.path(name);
  if (name == "c.pcd")
  // Through a stream: what PCL writes to a file has a tail of unused bytes.
  {
    std::ostringstream stream;
    pcl::PCDWriter().writeBinaryCompressed(stream, colouredCloud(40));
    writeFile(path, stream.str());
  }
  else if (name == "a.pcd")
    pcl::PCDWriter().writeASCII(path, colouredCloud(40));
  else if (name.find(".pcd") != std::string::npos ||
           name.find(".xyz") != std::string::npos)
    save(path, colouredCloud(40));
  else
    save(path, colouredSphere());
  return readFile(path);
}

class DamagedFile : public testing::TestWithParam<std::string> {
protected:
  TemporaryFolder folder_;
  std::string bytes_ = soundFile(folder_, GetParam());
};

TEST_P(DamagedFile, CutOffAnywhereNeverCrashes)
{
  ASSERT_TRUE(readsBytes(GetParam(), bytes_));
  const std::size_t step = std::max<std::size_t>(1, bytes_.size() / 400);
  for (std::size_t length = 0; length < bytes_.size(); length += step)
    readsBytes(GetParam(), bytes_.substr(0, length));
}

TEST_P(DamagedFile, BinaryFormatsRefuseAnyCut)
{
  const std::string name = GetParam();
  if (name == "b.xyz" || name == "b.obj" || name == "a.pcd")
    GTEST_SKIP() << "text without a length: the part before the cut is a sound file";
  // A cut of the last point data of VTK may still leave its line end behind.
  for (const std::size_t lost : {3U, 20U, 200U, 2000U}) {
    // The last number of OFF may lose a digit without anybody knowing.
    if (lost >= bytes_.size() || (name == "b.off" && lost < 20))
      continue;
    EXPECT_FALSE(readsBytes(name, bytes_.substr(0, bytes_.size() - lost)))
        << lost << " bytes cut off";
  }
}

TEST_P(DamagedFile, ChangedBytesNeverCrash)
{
  pcl::ccaa::test::RandomSource random(7);
  for (int round = 0; round < 300; ++round) {
    std::string damaged = bytes_;
    for (int i = 0; i < 1 + round % 8; ++i) {
      // Mostly in the header, where the damage is worst.
      const std::size_t range = round % 3 == 0 ? damaged.size() : 300;
      damaged[random.below(std::min(range, damaged.size()))] =
          static_cast<char>(random.below(256));
    }
    readsBytes(GetParam(), damaged);
  }
}

TEST_P(DamagedFile, GarbageIsRefused)
{
  const std::string path = folder_.path(GetParam());
  pcl::ccaa::test::RandomSource random(3);
  std::string garbage(5000, '\0');
  for (char& byte : garbage)
    byte = static_cast<char>(random.below(256));
  writeFile(path, garbage);
  EXPECT_FALSE(reads(path));
  writeFile(path, "This is a letter.\nIt has nothing to do with points.\n");
  EXPECT_FALSE(reads(path));
  writeFile(path, "");
  EXPECT_FALSE(reads(path));
  writeFile(path, std::string(5000, '\0'));
  EXPECT_FALSE(reads(path));
}

INSTANTIATE_TEST_SUITE_P(Formats,
                         DamagedFile,
                         testing::Values("b.ply",
                                         "b.vtk",
                                         "b.obj",
                                         "b.off",
                                         "b.stl",
                                         "b.pcd",
                                         "a.pcd",
                                         "c.pcd",
                                         "b.xyz"),
                         [](const auto& test) {
                           std::string name = test.param;
                           name[1] = '_';
                           return name;
                         });

/** Header, then nothing that could fill it. */
class LyingHeader : public testing::TestWithParam<std::pair<const char*, const char*>> {
};

TEST_P(LyingHeader, IsRefusedBeforeMemoryIsTaken)
{
  const TemporaryFolder folder;
  const auto [name, bytes] = GetParam();
  writeFile(folder.path(name), bytes);
  const std::size_t before = app::peakMemoryBytes();
  EXPECT_FALSE(reads(folder.path(name)));
  EXPECT_LT(app::peakMemoryBytes() - before, 50U << 20);
}

INSTANTIATE_TEST_SUITE_P(
    Formats,
    LyingHeader,
    testing::Values(
        std::pair("a.ply",
                  "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\n"
                  "property float x\nproperty float y\nproperty float z\nend_header\n"),
        std::pair("b.ply",
                  "ply\nformat ascii 1.0\nelement vertex 18446744073709551615\n"
                  "property float x\nproperty float y\nproperty float z\nend_header\n"),
        std::pair(
            "c.ply",
            "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
            "property float y\nproperty float z\nelement face 1\n"
            "property list uint int vertex_indices\nend_header\n0 0 0\n4000000000 1"),
        std::pair("d.ply",
                  "ply\nformat ascii 1.0\nelement nothing 99999999999999\n"
                  "element vertex 900000000\nproperty float x\nproperty float y\n"
                  "property float z\nend_header\n"),
        std::pair("a.pcd",
                  "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 2000000000\nHEIGHT 1\n"
                  "DATA binary\n"),
        std::pair("b.pcd",
                  "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 99999999999\n"
                  "HEIGHT 99999999999\nDATA ascii\n1 2 3\n"),
        std::pair(
            "c.pcd",
            "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 4000000000\nWIDTH 1\n"
            "HEIGHT 1\nDATA ascii\n1 2 3\n"),
        std::pair("d.pcd",
                  "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 300000000\nHEIGHT 1\n"
                  "DATA binary_compressed\n\x01\x01\x01\x01\x01\x01\x01\x01"),
        std::pair("e.pcd",
                  "FIELDS x y z a b c d e\nSIZE 4 4 4 4 4 4 4 4\n"
                  "TYPE F F F F F F F F\nCOUNT 1 1 1 99999 99999 99999 99999 99999\n"
                  "WIDTH 0\nHEIGHT 1\nDATA ascii\n"),
        std::pair("f.ply",
                  "ply\nformat binary_little_endian 1.0\n"
                  "element vertex 1000000000000000000\nproperty list uint int a\n"
                  "property float x\nproperty float y\nproperty float z\n"
                  "end_header\n\xff\xff\xff\xff"),
        std::pair("g.ply",
                  "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
                  "property float y\nproperty float z\nelement tristrips 1\n"
                  "property list int int vertex_indices\nend_header\n0 0 0\n"
                  "2147483647 0 0 0\n"),
        std::pair("a.off", "OFF\n2000000000 1 0\n0 0 0\n"),
        std::pair("b.off", "OFF\n1e308 1e308 0\n0 0 0\n"),
        std::pair("c.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4000000000 0 1 2\n"),
        std::pair("c.vtk",
                  "# vtk DataFile Version 5.1\nx\nASCII\nDATASET POLYDATA\n"
                  "POINTS 1 float\n0 0 0\nPOLYGONS 4000000000000000000 6\n"
                  "OFFSETS vtktypeint64\n0 3\n"),
        std::pair("a.vtk",
                  "# vtk DataFile Version 3.0\nx\nBINARY\nDATASET POLYDATA\n"
                  "POINTS 1500000000 float\n"),
        std::pair(
            "b.vtk",
            "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 1 float\n"
            "0 0 0\nPOLYGONS 1 9000000000000000000\n3 0 0 0\n")));

/** A run of equal bytes packs 88 to one: what is announced may be true. */
TEST(LyingCompression, IsFoundBeforeMemoryIsTaken)
{
  std::string packed("\x00\x00", 2); // one byte to copy
  for (int i = 0; i < 100000; ++i)
    packed += std::string("\xe0\xff\x00", 3); // 264 bytes each
  packed.back() = '\x07';                     // beyond what is there
  packed += std::string("\xff\xff\xff", 3);
  const auto unpacked = std::uint32_t{12} * ((100001 * 264 + 1) / 12);
  const auto size = static_cast<std::uint32_t>(packed.size());
  std::string bytes = "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH " +
                      std::to_string(unpacked / 12) +
                      "\nHEIGHT 1\nDATA binary_compressed\n";
  bytes.append(reinterpret_cast<const char*>(&size), sizeof(size));
  bytes.append(reinterpret_cast<const char*>(&unpacked), sizeof(unpacked));
  bytes += packed;
  const std::size_t before = app::peakMemoryBytes();
  app::Model model;
  EXPECT_FALSE(
      app::parseCloud(app::FileFormat::PCD, bytes.data(), bytes.size(), model).ok());
  EXPECT_LT(app::peakMemoryBytes() - before, 10U << 20);
}

/** Sound but for one index. */
class BadIndex : public testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(BadIndex, IsRefused)
{
  const TemporaryFolder folder;
  const auto [name, bytes] = GetParam();
  writeFile(folder.path(name), bytes);
  EXPECT_FALSE(reads(folder.path(name)));
}

INSTANTIATE_TEST_SUITE_P(
    Formats,
    BadIndex,
    testing::Values(
        std::pair("a.ply",
                  "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                  "property float y\nproperty float z\nelement face 1\n"
                  "property list uchar int vertex_indices\nend_header\n"
                  "0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"),
        std::pair("b.ply",
                  "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                  "property float y\nproperty float z\nelement face 1\n"
                  "property list uchar int vertex_indices\nend_header\n"
                  "0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n"),
        std::pair("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n"),
        std::pair("b.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 0\n"),
        std::pair("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 99\n"),
        std::pair(
            "a.vtk",
            "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n"
            "0 0 0 1 0 0 0 1 0\nPOLYGONS 1 4\n3 0 1 3\n")));

} // namespace
} // namespace app_test

// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: small clouds and meshes with all kinds of fields, for
// tests.
#pragma once

#include "io/model.h"

#include <cstdint>
#include <string>

namespace app_test {

/** \brief A closed mesh of a sphere with 162 points that have rgb, normals, intensity
 * and a whole-number label, all different from point to point. */
pcl::PolygonMesh
colouredSphere();

/** \brief The cloud of a bumpy surface, `points` of them, with rgb, normals, intensity.
 */
pcl::PCLPointCloud2
colouredCloud(std::size_t points, std::uint64_t seed = 1);

/** \brief 500 points along a curve: no surface, but ten points enclose a volume. */
pcl::PolygonMesh
helix();

/** \brief Points of two spheres of radius 1, so many each. */
pcl::PolygonMesh
spheresThatTouch(std::size_t count, double gap);

/** \brief Value of a field as double, for fields of any type. */
double
valueOf(const pcl::PCLPointCloud2& cloud, std::size_t point, const std::string& field);

/** \brief The same bytes in this field for all points of both clouds; fails the test
 * when the field is missing, has another type or the numbers of points differ. */
void
expectSameField(const pcl::PCLPointCloud2& expected,
                const pcl::PCLPointCloud2& actual,
                const std::string& field);

/** \brief The same polygons with the same corners in the same order. */
void
expectSamePolygons(const pcl::PolygonMesh& expected, const pcl::PolygonMesh& actual);

/** \brief Write with the app's own writers; fails the test when that does not work. */
void
save(const std::string& path, const pcl::PolygonMesh& mesh);
void
save(const std::string& path, const pcl::PCLPointCloud2& cloud);

/** \brief Read with the app's own readers; fails the test when that does not work. */
app::Model
loadMesh(const std::string& path);
app::Model
loadCloud(const std::string& path);

} // namespace app_test

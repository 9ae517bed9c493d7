// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: reading polygons and meshes wherever they lie.
#pragma once

#include <pcl/PolygonMesh.h>

#include "mesh/triangle.h"

#include <cstddef>
#include <vector>

namespace pcl::ccaa {

/** \brief Read-only view of polygons: PCL's, or the rows of an array, so that no block
 * of memory is needed for each of them. What it looks at must outlive it and stay where
 * it is. Const methods may be called from several threads. */
class PolygonView {
public:
  /** \brief The corners of one polygon. */
  class Corners {
  public:
    Corners(const pcl::index_t* first, std::size_t size) : first_(first), size_(size) {}

    std::size_t
    size() const
    {
      return size_;
    }
    const pcl::index_t*
    begin() const
    {
      return first_;
    }
    const pcl::index_t*
    end() const
    {
      return first_ + size_;
    }
    pcl::index_t
    operator[](std::size_t corner) const
    {
      return first_[corner];
    }

  private:
    const pcl::index_t* first_;
    std::size_t size_;
  };

  /** \brief A view of nothing. */
  PolygonView() = default;

  PolygonView(const std::vector<pcl::Vertices>& polygons)
  : polygons_(polygons.data()), size_(polygons.size())
  {}

  /** \brief View of `size` rows that follow each other, of `corners` corners each. */
  PolygonView(const pcl::index_t* rows, std::size_t size, std::size_t corners)
  : rows_(rows), corners_(corners), size_(size)
  {}

  std::size_t
  size() const
  {
    return size_;
  }
  bool
  empty() const
  {
    return size_ == 0;
  }

  /** \brief The index must be below size(). */
  Corners
  operator[](std::size_t index) const
  {
    if (polygons_ == nullptr)
      return {rows_ + index * corners_, corners_};
    const pcl::Indices& corners = polygons_[index].vertices;
    return {corners.data(), corners.size()};
  }

private:
  const pcl::Vertices* polygons_ = nullptr; /**< else they are rows */
  const pcl::index_t* rows_ = nullptr;
  std::size_t corners_ = 0;
  std::size_t size_ = 0;
};

/** \brief View of triangles. */
inline PolygonView
viewOf(const Triangles& triangles)
{
  return {triangles.empty() ? nullptr : triangles.front().data(), triangles.size(), 3};
}

/** \brief Read-only view of a mesh, as PolygonView. */
struct MeshView {
  MeshView(const pcl::PCLPointCloud2& points, const PolygonView& faces)
  : cloud(&points), polygons(faces)
  {}
  MeshView(const pcl::PolygonMesh& mesh) : MeshView(mesh.cloud, mesh.polygons) {}
  template <typename Mesh>
  MeshView(const pcl::shared_ptr<Mesh>& mesh)
  {
    if (mesh)
      *this = MeshView(*mesh);
  }

  const pcl::PCLPointCloud2* cloud = nullptr; /**< null: there is no mesh */
  PolygonView polygons;
};

} // namespace pcl::ccaa

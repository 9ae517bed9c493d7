// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a mesh taken apart into what a picture shows of it.
#pragma once

#include <pcl/surface_ccaa/global_shift.h>
#include <pcl/PolygonMesh.h>

#include <Eigen/Core>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include "inspect/inspection.h"

#include <vector>

namespace app {

/** \brief The drawable parts of a mesh; all share one list of points. */
struct MeshParts {
  vtkSmartPointer<vtkPolyData> faces;       /**< all polygons with valid corners */
  vtkSmartPointer<vtkPolyData> boundaries;  /**< edges with one polygon */
  vtkSmartPointer<vtkPolyData> overfull;    /**< edges with three or more polygons */
  vtkSmartPointer<vtkPolyData> free_points; /**< points of no polygon */
  vtkSmartPointer<vtkPolyData> boundary_points; /**< ends of boundary edges */
  vtkSmartPointer<vtkPolyData> internal_points; /**< all others */
  std::vector<Eigen::Vector3d> positions;       /**< all finite points */
  vtkSmartPointer<vtkUnsignedCharArray> colors; /**< of these; null without colours */
  vtkSmartPointer<vtkPolyData> earlier_faces; /**< of the same mesh before something was
                                                   done to it; null: not asked for */
};

/** \brief Take \a mesh apart, its positions less the shift. A cloud is a mesh without
 * polygons. Points that are not finite, and polygons that use one or an index out of
 * range, are left out. */
MeshParts
takeApart(const pcl::PolygonMesh& mesh, const pcl::GlobalShift& shift = {});

/** \brief The same for the points of \a cloud with some polygons. */
MeshParts
takeApart(const pcl::PCLPointCloud2& cloud,
          const std::vector<pcl::Vertices>& polygons,
          const pcl::GlobalShift& shift = {});

/** \brief The lines and faces of a layer, or a dot a point where it has neither, with a
 * colour a point. */
vtkSmartPointer<vtkPolyData>
makePart(const InspectionLayer& layer);

/** \brief Red, green and blue of each point from the field rgb or rgba; empty without
 * it.
 */
vtkSmartPointer<vtkUnsignedCharArray>
makeColors(const pcl::PCLPointCloud2& cloud);

std::vector<Eigen::Vector3d>
positionsOf(const InspectionLayer& layer);

} // namespace app

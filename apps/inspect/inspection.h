// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what a survey found, as coloured points, lines and faces.
#pragma once

#include <pcl/surface_ccaa/global_shift.h>
#include <pcl/surface_repair/repair_report.h>
#include <pcl/PCLPointCloud2.h>
#include <pcl/PolygonMesh.h>

#include "inspection_colors.h"
#include "survey/model_survey.h"

#include <string>
#include <vector>

namespace app {

/** \brief A colour and what it stands for. */
struct LegendEntry {
  Rgb color{};
  std::string meaning;
};

/** \brief The content of one file: coloured points, and lines or faces along them. */
struct InspectionLayer {
  std::string name;    /**< of the file */
  std::string title;   /**< what it shows, for people */
  std::string columns; /**< what the fields of the points mean */
  std::vector<LegendEntry> legend;
  pcl::PCLPointCloud2 cloud; /**< with the field rgb */
  std::vector<pcl::Vertices> lines;
  std::vector<pcl::Vertices> faces;
};

/** \brief The boundary loops, coloured by class. */
InspectionLayer
showLoops(const pcl::repair::ModelSurvey& survey);

/** \brief The triangles, coloured by what told the outer side of their island. */
InspectionLayer
showIslands(const pcl::repair::ModelSurvey& survey);

/** \brief The points without a triangle. */
InspectionLayer
showFreePoints(const pcl::repair::ModelSurvey& survey);

/** \brief The force lines, coloured by how they ended and how good they are. */
InspectionLayer
showLines(const pcl::repair::ModelSurvey& survey);

/** \brief Hairs for the normals along the bridges, a few on each. */
InspectionLayer
showLineNormals(const pcl::repair::ModelSurvey& survey);

/** \brief The points of the bridges with normals, as input for other programs of PCL.
 */
InspectionLayer
showLinePoints(const pcl::repair::ModelSurvey& survey);

/** \brief The boundary points that the field acts on, coloured by attraction. */
InspectionLayer
showOrigins(const pcl::repair::ModelSurvey& survey);

/** \brief The tension of the field on a plane. */
InspectionLayer
showSlice(const pcl::repair::FieldSlice& slice);

/** \brief Where that plane cuts the surface. */
InspectionLayer
showSection(const pcl::repair::ModelSurvey& survey,
            const pcl::repair::FieldSlice& slice);

/** \brief The bridges as they were built, less the shift, coloured by quality,
 * with their normals, the islands that they join and whether they divide a
 * hole. */
InspectionLayer
showBridges(const std::vector<pcl::RepairBridge>& bridges,
            const pcl::GlobalShift& shift);

/** \brief What boundaries and bridges enclose, as it lies in the repaired mesh: the
 * contours of closed holes by the method that closed them, those that stay open by
 * their reason.
 * \param[in] mesh the repaired one */
InspectionLayer
showContours(const pcl::RepairReport& report, const pcl::PolygonMesh& mesh);

/** \brief The lines of a survey that have a length, between islands first, then those
 * within holes; points at equal distances of about the source spacing. */
std::vector<pcl::repair::ForceLine>
visibleLines(const pcl::repair::ModelSurvey& survey);

} // namespace app

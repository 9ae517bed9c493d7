// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what the help of pcl_repair_holes says besides the options.
#include "io/model_io.h"
#include "repair_options.h"

namespace app {

Usage
repairUsage()
{
  Usage usage;
  usage.program = "pcl_repair_holes";
  usage.synopsis =
      "INPUT_MESH [OUTPUT_MESH] [options]\n"
      "       pcl_repair_holes INPUT_MESH... --output-folder DIR [options]";
  usage.summary =
      R"(Repairs a mesh: turns its islands outside out, joins them by bridges along
force lines and closes the holes, smoothly and in the density of what is
around. All points and triangles of the mesh are kept, with all fields. Points
without a triangle are free points, samples of the missing regions. With
--inspect it shows what is missing. Any mesh will do: it is cut where more than
two triangles meet in an edge.

INPUT_MESH   )" +
      std::string(mesh_endings) + "\nOUTPUT_MESH  " + mesh_output_endings +
      R"(; .ply keeps most; may be left out with
             --inspect and --dry-run
'-' stands for standard input (the first bytes tell the format) and standard output
(PLY unless --format is given); what is for people then goes to standard error.)";
  usage.examples = R"(  pcl_repair_holes scan.ply repaired.ply
  pcl_repair_holes scan.ply repaired.ply --free-points sparse.pcd --report r.json
  pcl_repair_holes scan.ply --dry-run
  pcl_repair_holes a.ply b.ply c.ply --output-folder repaired
  pcl_repair_holes - - < scan.ply | pcl_mesh_quality -
  pcl_repair_holes scan.ply --inspect found --report found.json
  pcl_viewer found/origins.pcd found/islands.vtk found/loops.vtk
)";
  return usage;
}

} // namespace app

// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: VTK's hole filling as a rival.
#include "rival_vtk_filling.h"

#ifdef PSR_HAVE_VTK_FILLING
#include <vtkCellArray.h>
#include <vtkFillHolesFilter.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#endif

namespace bench {

#ifdef PSR_HAVE_VTK_FILLING

pcl::ccaa::test::Shape
fillByVtk(const pcl::ccaa::test::Shape& shape)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const pcl::ccaa::Position& p : shape.vertices)
    points->InsertNextPoint(p.data());
  vtkNew<vtkCellArray> triangles;
  for (const pcl::ccaa::Triangle& t : shape.triangles) {
    const vtkIdType corners[] = {t[0], t[1], t[2]};
    triangles->InsertNextCell(3, corners);
  }
  vtkNew<vtkPolyData> mesh;
  mesh->SetPoints(points);
  mesh->SetPolys(triangles);
  vtkNew<vtkFillHolesFilter> filter;
  filter->SetInputData(mesh);
  filter->SetHoleSize(1e9);
  filter->Update();
  vtkPolyData* const filled = filter->GetOutput();
  pcl::ccaa::test::Shape result;
  for (vtkIdType i = 0; i < filled->GetNumberOfPoints(); ++i)
    result.vertices.emplace_back(filled->GetPoint(i));
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < filled->GetNumberOfCells(); ++i) {
    filled->GetCellPoints(i, corners);
    if (corners->GetNumberOfIds() == 3)
      result.triangles.push_back({static_cast<pcl::index_t>(corners->GetId(0)),
                                  static_cast<pcl::index_t>(corners->GetId(1)),
                                  static_cast<pcl::index_t>(corners->GetId(2))});
  }
  return result;
}

#else

pcl::ccaa::test::Shape
fillByVtk(const pcl::ccaa::test::Shape&)
{
  return {};
}

#endif

} // namespace bench

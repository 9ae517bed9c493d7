#include <pcl/surface_repair/fairing/refinement.h>
#include <pcl/surface_repair/fairing/relaxation.h>
#include <pcl/surface_repair/subdivision/hole_subdivision.h>
namespace pcl {
namespace repair {
__attribute__((weak)) void
refinePatch(const IncompleteModel&, const RefinementParameters&, Patch&)
{}
__attribute__((weak)) RelaxationReport
relaxPatch(const IncompleteModel&,
           const Positions&,
           const RelaxationParameters&,
           Patch&)
{
  return {};
}
__attribute__((weak)) DividedHole
divideHole(const HolePolygon& h,
           pcl::index_t,
           const SurveyParameters&,
           const SubdivisionGuides&,
           const ccaa::LoopContext&)
{
  return {{h}, {}, {}};
}
} // namespace repair
} // namespace pcl

#pragma once
#include <pcl/surface_repair/darning/darning_method.h>
namespace pcl {
namespace repair {
class CompletionDarning : public DarningMethod {
public:
  const char*
  name() const override
  {
    return "completion";
  }
  std::size_t
  simpleEdges() const override
  {
    return 100;
  }
  Darn
  close(const DarningTask&) const override
  {
    Darn d;
    d.problem = "stub";
    return d;
  }
};
} // namespace repair
} // namespace pcl

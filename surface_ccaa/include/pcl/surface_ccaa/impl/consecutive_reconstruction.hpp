// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: consecutive application of algorithms (thesis 3.1).
#pragma once

#include <pcl/console/print.h>
#include <pcl/surface_ccaa/consecutive_reconstruction.h>
#include <pcl/surface_ccaa/greedy_start.h>
#include <pcl/surface_ccaa/impl/checked_construction.hpp>
#include <pcl/surface_ccaa/impl/cloud_view.h>
#include <pcl/surface_ccaa/projection_completion.h>
#include <pcl/surface_ccaa/umbrella_filter.h>
#include <pcl/conversions.h>

#include <memory>
#include <typeinfo>
#include <utility>

namespace pcl {

namespace ccaa {

/** \brief An algorithm of a chain on a cloud of this point type. */
template <typename PointT>
class CloudPart : public ChainPart {
public:
  using CloudConstPtr = typename PointCloud<PointT>::ConstPtr;
  using TreePtr = typename search::Search<PointT>::Ptr;

  /** \param[in] tree null: the algorithm keeps its own */
  CloudPart(MeshConstruction<PointT>& algorithm, CloudConstPtr cloud, TreePtr tree)
  : algorithm_(algorithm)
  , completion_(dynamic_cast<MeshCompletion<PointT>*>(&algorithm))
  , handing_(handing(algorithm))
  , cloud_(std::move(cloud))
  , tree_(std::move(tree))
  {}

  StageSettings
  settings() const override
  {
    return StageSettings::of(&algorithm_);
  }
  bool
  takesHandoff() const override
  {
    return handing_ != nullptr;
  }
  bool
  completes() const override
  {
    return completion_ != nullptr;
  }
  const std::vector<index_t>*
  keptTriangles() const override
  {
    return completion_ == nullptr ? nullptr : completion_->keptTriangles();
  }
  TopologyDoubts
  topologyDoubts() const override
  {
    return completion_ == nullptr ? TopologyDoubts() : completion_->topologyDoubts();
  }

  /** A cloud of some of the points is no longer organised: an algorithm whose search
   * method needs that loses it. */
  bool
  construct(const ChainSelection& points, StageOutput& made) override
  {
    const LentHandoff lent(handing_, made.handoff);
    if (tree_)
      algorithm_.setSearchMethod(tree_);
    const bool honours_indices = settings().run != nullptr;
    if (honours_indices || !needsCloudOfItsOwn(points)) {
      algorithm_.setInputCloud(cloud_);
      algorithm_.setIndices(honours_indices ? points.chosen : IndicesPtr());
      algorithm_.reconstruct(made.polygons);
      return false;
    }
    const auto part = std::make_shared<PointCloud<PointT>>(*cloud_, *points.chosen);
    part->is_dense = true;
    if (!canSearch(algorithm_.getSearchMethod().get(), *part))
      algorithm_.setSearchMethod(nullptr); // it chooses one that can
    algorithm_.setInputCloud(part);
    algorithm_.setIndices(IndicesPtr());
    algorithm_.reconstruct(made.polygons);
    return true;
  }

  void
  complete(const PolygonMeshConstPtr& partial_mesh,
           const IndicesPtr& usable,
           StageOutput& made) override
  {
    const LentHandoff lent(handing_, made.handoff);
    if (tree_)
      completion_->setSearchMethod(tree_);
    const std::shared_ptr<void> restore(
        nullptr, [this, own_mesh = completion_->getPartialMesh()](void*) {
          completion_->setPartialMesh(own_mesh);
        });
    completion_->setInputCloud(cloud_);
    completion_->setIndices(usable);
    completion_->setPartialMesh(partial_mesh);
    completion_->reconstruct(made.polygons);
  }

private:
  /** Who derives from one of these may do more with the polygons. */
  static TakesHandoff*
  handing(MeshConstruction<PointT>& algorithm)
  {
    const std::type_info& type = typeid(algorithm);
    return type == typeid(GreedyStart<PointT>) ||
                   type == typeid(ProjectionCompletion<PointT>)
               ? dynamic_cast<TakesHandoff*>(&algorithm)
               : nullptr;
  }

  /** A class of PCL may mix up indices and positions among them (gp3 does), and need
   * not expect points that are not finite. Of organised clouds it does. */
  bool
  needsCloudOfItsOwn(const ChainSelection& points) const
  {
    const bool knows_gaps = cloud_->isOrganized() && !cloud_->is_dense;
    return points.is_part || (points.has_gaps && !knows_gaps);
  }

  MeshConstruction<PointT>& algorithm_;
  MeshCompletion<PointT>* completion_;
  TakesHandoff* handing_; /**< null: it works with polygons */
  CloudConstPtr cloud_;
  TreePtr tree_;
};

} // namespace ccaa

template <typename PointT>
ConsecutiveReconstruction<PointT>::ConsecutiveReconstruction()
: filter_(std::make_shared<UmbrellaFilter>())
{
  side_hints_.try_origin = true;
  side_hints_.guess_plane = true; // the start algorithm winds in any way
  const auto start = std::make_shared<GreedyStart<PointT>>();
  start->setSearchMethod(std::make_shared<search::BlockSearch<PointT>>());
  starts_.push_back(start);
  const auto base = std::make_shared<ProjectionCompletion<PointT>>();
  base->setKeepGiven(false); // a start algorithm has a right of mistake
  base_ = base;
}

template <typename PointT>
ConsecutiveReconstruction<PointT>::~ConsecutiveReconstruction() = default;

template <typename PointT>
void
ConsecutiveReconstruction<PointT>::performReconstruction(pcl::PolygonMesh& output)
{
  ccaa::ChainOutput result;
  ccaa::runChain(chainInput(), true, output, result);
  take(std::move(result));
}

template <typename PointT>
void
ConsecutiveReconstruction<PointT>::performReconstruction(
    std::vector<pcl::Vertices>& polygons)
{
  pcl::PolygonMesh output;
  ccaa::ChainOutput result;
  ccaa::runChain(chainInput(), false, output, result);
  take(std::move(result));
  polygons = std::move(output.polygons);
}

template <typename PointT>
SpeedupReport
ConsecutiveReconstruction<PointT>::measureSpeedup()
{
  take({});
  if (!base_)
    PCL_ERROR("[pcl::%s::measureSpeedup] no base algorithm to compare with\n",
              getClassName().c_str());
  if (!base_ || !this->hasUsableCloud("measureSpeedup") || !this->initCompute())
    return {};
  ccaa::ChainOutput result;
  const SpeedupReport measured = ccaa::measureChain(chainInput(), result);
  take(std::move(result));
  this->deinitCompute();
  return measured;
}

template <typename PointT>
ccaa::ChainInput
ConsecutiveReconstruction<PointT>::chainInput() const
{
  using Part = ccaa::CloudPart<PointT>;
  ccaa::ChainInput input;
  input.points = ccaa::pointArrayOf(*input_);
  input.selection = indices_;
  input.threads = threads_;
  input.progress = progress_;
  input.has_viewpoints = ccaa::viewpointArrayOf(*input_).size > 0;
  input.sides = ccaa::sidesOf(*input_, side_hints_);
  for (const StartPtr& start : starts_)
    input.starts.push_back(start ? std::make_shared<Part>(*start, input_, tree_)
                                 : nullptr);
  input.filter = filter_.get();
  if (base_)
    input.base = std::make_shared<Part>(*base_, input_, tree_);
  input.compute_normals = compute_normals_;
  input.write_cloud = [this](PCLPointCloud2& cloud) {
    pcl::toPCLPointCloud2(*input_, cloud);
  };
  return input;
}

template <typename PointT>
void
ConsecutiveReconstruction<PointT>::take(ccaa::ChainOutput result)
{
  labels_ = std::move(result.labels);
  normals_ = std::move(result.normals);
  report_ = std::move(result.report);
  side_tally_ = result.sides;
}

} // namespace pcl

#define PCL_INSTANTIATE_ConsecutiveReconstruction(T)                                   \
  template class PCL_EXPORTS pcl::ConsecutiveReconstruction<T>;

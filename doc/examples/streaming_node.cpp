// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: example, clouds arrive, meshes go out.
//
// Usage: streaming_node FRAME.pcd... [-o LAST_MESH.ply] [-period MILLISECONDS]
//
// The middle of a node of ROS, or of any other pipeline, without ROS: clouds arrive on
// the thread of a subscriber, a worker makes meshes of them, and a cloud that arrives
// meanwhile cancels the work on the one before, so that meshes are never old. Here
// files stand for the clouds, and come one every -period milliseconds (100).
#include <pcl/console/parse.h>
#include <pcl/console/print.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>
#include <pcl/surface_ccaa/consecutive_reconstruction.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

//! [node]
/** \brief Makes a mesh of the cloud that came last. */
class MeshNode {
public:
  /** \brief Called on the worker's thread with the number of a cloud and its mesh,
   * which has no polygons where the cloud had too few points. */
  using Publish = std::function<void(std::size_t number, const pcl::PolygonMesh& mesh)>;

  explicit MeshNode(Publish publish)
  : publish_(std::move(publish)), worker_([this] { work(); })
  {}

  /** \brief Waits for the mesh of the last cloud. */
  ~MeshNode()
  {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      closing_ = true;
    }
    changed_.notify_one();
    worker_.join();
  }
  MeshNode(const MeshNode&) = delete;
  MeshNode&
  operator=(const MeshNode&) = delete;

  /** \brief What a subscriber calls; returns at once. The cloud must not change. */
  void
  push(const Cloud::ConstPtr& cloud)
  {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      next_ = cloud;
      ++arrived_; // which cancels the run on the one before
    }
    changed_.notify_one();
  }

private:
  void
  work()
  {
    pcl::ConsecutiveReconstruction<pcl::PointXYZ> chain; // used again for each cloud
    while (true) {
      std::unique_lock<std::mutex> lock(mutex_);
      changed_.wait(lock, [this] { return next_ || closing_; });
      if (!next_)
        return;
      chain.setInputCloud(std::exchange(next_, nullptr));
      const std::size_t number = arrived_;
      lock.unlock();
      chain.setProgressCallback(
          [this, number](const std::string&, double) { return arrived_ == number; });
      pcl::PolygonMesh mesh;
      chain.reconstruct(mesh);
      if (!chain.getReport().cancelled)
        publish_(number, mesh);
    }
  }

  Publish publish_;
  std::mutex mutex_;
  std::condition_variable changed_;
  Cloud::ConstPtr next_;
  std::atomic<std::size_t> arrived_{0};
  bool closing_ = false;
  std::thread worker_; // last: all else is there when it starts
};
//! [node]

/** \brief The clouds that can be read; each on its time. */
void
play(const std::vector<std::string>& files, int period, MeshNode& node)
{
  for (const std::string& file : files) {
    const Cloud::Ptr cloud(new Cloud);
    if (pcl::io::loadPCDFile(file, *cloud) < 0)
      std::fprintf(stderr, "streaming_node: cannot read %s\n", file.c_str());
    else
      node.push(cloud);
    std::this_thread::sleep_for(std::chrono::milliseconds(period));
  }
}

} // namespace

int
main(int argc, char** argv)
{
  std::vector<std::string> files;
  for (const int i : pcl::console::parse_file_extension_argument(argc, argv, ".pcd"))
    files.emplace_back(argv[i]);
  std::string output;
  int period = 100;
  pcl::console::parse_argument(argc, argv, "-o", output);
  pcl::console::parse_argument(argc, argv, "-period", period);
  if (files.empty() || period < 0) {
    std::fprintf(stderr,
                 "usage: streaming_node FRAME.pcd... [-o LAST_MESH.ply] [-period "
                 "MILLISECONDS]\n");
    return 1;
  }
  pcl::console::setVerbosityLevel(pcl::console::L_ERROR);
  //! [use]
  pcl::PolygonMesh last;
  {
    MeshNode node([&last](std::size_t number, const pcl::PolygonMesh& mesh) {
      std::printf("cloud %zu: %zu triangles\n", number, mesh.polygons.size());
      last = mesh;
    });
    play(files, period, node);
  }
  //! [use]
  if (last.polygons.empty()) {
    std::fprintf(stderr, "streaming_node: no mesh\n");
    return 1;
  }
  if (!output.empty() && pcl::io::savePLYFileBinary(output, last) < 0) {
    std::fprintf(stderr, "streaming_node: cannot write %s\n", output.c_str());
    return 1;
  }
}

// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how soon the window of the viewer answers for a large mesh.
//
// Usage: bench_viewer [MILLIONS [FRAMES]]
// Opens a torus of so many million triangles (5) with eight holes in a window, on
// $DISPLAY or else on a virtual one, and does with the mouse what somebody does.
// Nothing passes or fails.
#include <pcl/conversions.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <vtkCommand.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>

#include "cli/cli.h"
#include "measuring.h"
#include "render/display.h"
#include "repair/decision_proposal.h"
#include "support/shapes.h"
#include "viewer/decision_desk.h"
#include "viewer/stage_view.h"
#include "viewer/stages.h"
#include "viewer/viewer_run.h"
#include "viewer/viewer_window.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <thread>

namespace {

constexpr int WIDTH = 1280;
constexpr int HEIGHT = 800;
constexpr int HOLES = 8;

/** A torus with holes around its upper side. */
pcl::PolygonMesh
torusWithHoles(double millions)
{
  const int across = static_cast<int>(std::sqrt(millions * 1e6 / 4));
  const auto torus = pcl::ccaa::test::torus(2 * across, across);
  pcl::PolygonMesh mesh;
  pcl::PointCloud<pcl::PointXYZ> cloud;
  for (const auto& v : torus.vertices)
    cloud.push_back(pcl::PointXYZ(float(v.x()), float(v.y()), float(v.z())));
  pcl::toPCLPointCloud2(cloud, mesh.cloud);
  for (const auto& triangle : torus.triangles) {
    const auto& corner = torus.vertices[static_cast<std::size_t>(triangle[0])];
    const double turns = std::atan2(corner.y(), corner.x()) * HOLES / (2 * M_PI);
    const double aside = (turns - std::round(turns)) * 2 * M_PI / HOLES;
    if (corner.z() > 0 && std::hypot(aside, corner.head<2>().norm() - 1) < 0.03)
      continue;
    mesh.polygons.emplace_back();
    mesh.polygons.back().vertices.assign(triangle.begin(), triangle.end());
  }
  return mesh;
}

/** The mouse in the window. */
class Mouse {
public:
  explicit Mouse(vtkRenderWindowInteractor& interactor) : interactor_(interactor) {}

  void
  send(int x, int y, unsigned long event)
  {
    interactor_.SetEventInformation(x, y);
    interactor_.InvokeEvent(event);
  }

  /** Seconds of a step, each of which is drawn; the first one drawn is left out. */
  double
  turn(int frames, double& first)
  {
    const int x = WIDTH / 2, y = HEIGHT / 2;
    first = bench::secondsOf([&] {
      send(x, y, vtkCommand::LeftButtonPressEvent);
      send(x + 1, y, vtkCommand::MouseMoveEvent);
    });
    const double seconds = bench::secondsOf([&] {
      for (int i = 0; i < frames; ++i)
        send(x + 4 + 4 * i, y, vtkCommand::MouseMoveEvent);
    });
    send(x + 4 * frames, y, vtkCommand::LeftButtonReleaseEvent);
    return seconds / frames;
  }

  /** Seconds until what a click chooses is shown. */
  double
  click(const Eigen::Vector3d& place, vtkRenderer& model)
  {
    model.SetWorldPoint(place.x(), place.y(), place.z(), 1.0);
    model.WorldToDisplay();
    const double* const pixel = model.GetDisplayPoint();
    const int x = static_cast<int>(std::lround(pixel[0]));
    const int y = static_cast<int>(std::lround(pixel[1]));
    return bench::secondsOf([&] {
      send(x, y, vtkCommand::LeftButtonPressEvent);
      send(x, y, vtkCommand::LeftButtonReleaseEvent);
    });
  }

private:
  vtkRenderWindowInteractor& interactor_;
};

/** Seconds from a key of an X server, sent while a full picture is being drawn, until
 * it is answered. */
double
answerWhileDrawing(app::ViewerWindow& window, const app::DecisionDesk& desk)
{
  using Clock = std::chrono::steady_clock;
  window.press("period"); // the full picture follows
  const std::size_t before = desk.editor().chosen();
  Clock::time_point sent = Clock::time_point::max();
  std::thread sender([&sent] {
    std::this_thread::sleep_for(std::chrono::milliseconds(600));
    sent = Clock::now();
    if (std::system("xdotool search --name '^bench_viewer$' key --window %1 period") !=
        0)
      std::printf("no key was sent: is there xdotool?\n");
  });
  const auto end = Clock::now() + std::chrono::seconds(20);
  while (desk.editor().chosen() == before && Clock::now() < end)
    window.update();
  const auto answered = Clock::now();
  sender.join();
  return std::chrono::duration<double>(answered - sent).count();
}

void
measure(double millions, int frames)
{
  app::ViewerTask task;
  task.repairs = false;
  app::ViewerRun run;
  run.input.mesh = torusWithHoles(millions);
  std::printf(
      "%zu triangles, %d x %d pixels\n", run.input.mesh.polygons.size(), WIDTH, HEIGHT);
  app::ProgressBar bar(true);
  app::runForViewer(task, bar, run);
  const app::StageCamera camera{
      run.survey.model.positions, Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitY()};
  app::StageView view(app::makeStages(run, camera.view), camera, "torus");
  app::ViewerWindow window(view, WIDTH, HEIGHT, "bench_viewer", {});
  app::DecisionDesk desk(proposeDecisions(run.survey, task.method),
                         run.survey,
                         app::repairTask(task, run),
                         view,
                         {});
  window.setDesk(desk);
  window.goTo(1);
  vtkRenderWindow& drawn = *view.model().GetRenderWindow();
  window.picture(); // all is there
  std::printf("a full picture         %8.3f s\n",
              bench::secondsOf([&] { drawn.Render(); }));
  Mouse mouse(*drawn.GetInteractor());
  double first = 0.0;
  double seconds = mouse.turn(frames, first);
  std::printf("a drag, until drawn    %8.3f s, then %.1f frames a second\n",
              first,
              1 / seconds);
  const auto& loops = desk.editor().decisions().loops;
  seconds = mouse.click(loops.back().key.center, view.model());
  if (desk.editor().chosen() + 1 != loops.size())
    std::printf("the click has chosen nothing\n");
  std::printf("a click on a loop      %8.3f s\n", seconds);
  window.picture();
  std::printf("next loop, by a key    %8.3f s\n",
              bench::secondsOf([&] { window.press("period"); }));
  window.picture();
  std::printf("its result             %8.3f s\n",
              bench::secondsOf([&] { window.press("v"); }));
  window.picture();
  std::printf("a key meanwhile        %8.3f s\n", answerWhileDrawing(window, desk));
  window.picture();
  std::printf("another stage          %8.3f s\n",
              bench::secondsOf([&] { window.goTo(0); }));
}

} // namespace

int
main(int argc, char** argv)
{
  const double millions = argc > 1 ? std::atof(argv[1]) : 5.0;
  const int frames = argc > 2 ? std::atoi(argv[2]) : 20;
  const app::Display display;
  if (!display.ready() || !(millions > 0.001) || frames < 1) {
    std::fprintf(stderr,
                 "usage: bench_viewer [MILLIONS [FRAMES]], with a display or Xvfb\n");
    return 1;
  }
  measure(millions, frames);
  return 0;
}

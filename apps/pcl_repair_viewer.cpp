// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: program that shows a repair stage by stage.
#include "cli/cli.h"
#include "cli/progress.h"
#include "io/decisions_file.h"
#include "io/interrupt.h"
#include "io/model_io.h"
#include "io/output_file.h"
#include "io/output_folder.h"
#include "io/overwriting.h"
#include "io/point_columns.h"
#include "render/camera.h"
#include "render/display.h"
#include "render/drawing.h"
#include "repair/decision_proposal.h"
#include "report/hole_report.h"
#include "report/verdict.h"
#include "viewer/decision_desk.h"
#include "viewer/file_dialog.h"
#include "viewer/stage_view.h"
#include "viewer/stages.h"
#include "viewer/viewer_files.h"
#include "viewer/viewer_options.h"
#include "viewer/viewer_window.h"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <utility>

namespace app {
namespace {

namespace fs = std::filesystem;

/** Picture files of a folder, numbered so that they sort like the stages. */
std::string
pictureName(std::size_t stage, const std::vector<Stage>& stages)
{
  return std::to_string(stage + 1) + "_" + stages[stage].name + ".png";
}

/** All that can be known to fail before the work begins. */
void
checkOutputs(const ViewerSettings& settings)
{
  if (!settings.offScreen() && !hasDisplay())
    throw Failure(
        "no X display to open a window on: set DISPLAY, or use --screenshot FILE.png");
  checkDifferentFiles({settings.task.input, settings.task.free_points},
                      {settings.screenshot, settings.decisions, settings.output});
  for (const std::string& file : {settings.screenshot, settings.decisions})
    if (!file.empty())
      require(OutputFile::check(file));
  if (!settings.output.empty()) {
    require(checkReplaceable(settings.output));
    require(checkMeshOutput(settings.output));
  }
  if (!settings.folder.empty())
    require(OutputFolder::check(settings.folder));
}

/** A stage that this input does not have is told before the long work. */
void
checkStage(const ViewerSettings& settings, bool from_cloud)
{
  const auto& names = stageNames();
  const std::string name = "'" + settings.task.input + "'";
  const bool of_mesh = settings.stage == names.back();
  const bool of_cloud =
      std::find(names.begin(), names.begin() + 4, settings.stage) != names.begin() + 4;
  if (from_cloud && of_mesh)
    throw Failure(name + " is a cloud; it has no stage 'mesh' (try base)");
  if (from_cloud && !settings.decisions.empty())
    throw Failure(name + " is a cloud; --decisions are about a mesh");
  if (!from_cloud && of_cloud)
    throw Failure(name + " is a mesh; it has no stage '" + settings.stage +
                  "' (try mesh, or --points-only)");
}

StageCamera
aim(const InspectionView& view, const ViewerRun& run)
{
  StageCamera camera;
  camera.positions = run.survey.model.positions;
  if (camera.positions.empty())
    for (const auto& position : readPositions(run.input.mesh.cloud, run.input.shift))
      if (position.allFinite())
        camera.positions.push_back(position.cast<double>());
  camera.view = view.view ? *view.view : chooseView(run.survey);
  camera.up = view.up ? *view.up : chooseUp(run.survey, camera.view);
  return camera;
}

StageView
makeView(const ViewerSettings& settings, const ViewerRun& run)
{
  const StageCamera camera = aim(settings.view, run);
  return {makeStages(run, camera.view),
          camera,
          fs::path(settings.task.input).filename().string()};
}

/** Bridges and what follows take longest: a picture of what comes before needs none. */
bool
needsRepair(const ViewerSettings& settings)
{
  if (settings.screenshot.empty() || !settings.folder.empty() || settings.stage.empty())
    return true;
  for (const char* stage : {"bridges", "holes", "result"})
    if (settings.stage == stage)
      return true;
  return false;
}

/** The stage asked for, else the given one. */
std::size_t
chosenStage(const ViewerSettings& settings,
            const std::vector<Stage>& stages,
            std::size_t otherwise)
{
  for (std::size_t i = 0; i < stages.size(); ++i)
    if (stages[i].name == settings.stage)
      return i;
  return otherwise;
}

/** Pictures of the stages appear together or not at all: not after a signal either.
 * \return whether one came */
bool
writePictures(const ViewerSettings& settings, StageView& view)
{
  const auto& stages = view.stages();
  const Display display;
  if (!display.ready())
    throw Failure("no X display to draw with: set DISPLAY or install Xvfb");
  Painter painter(settings.view.width, settings.view.height);
  OutputFolder folder;
  const auto draw = [&](std::size_t stage, OutputFile& file) {
    const std::string bytes =
        drawStage(view, stage, settings.view.width, settings.view.height, painter);
    if (bytes.empty())
      throw Failure("the picture could not be drawn");
    file.text(bytes);
  };
  if (!settings.folder.empty())
    require(folder.open(settings.folder));
  if (!settings.screenshot.empty())
    draw(chosenStage(settings, stages, stages.size() - 1),
         folder.addElsewhere(settings.screenshot));
  const std::size_t pictures = settings.folder.empty() ? 0 : stages.size();
  for (std::size_t i = 0; !interrupted() && i < pictures; ++i)
    draw(i, folder.add(pictureName(i, stages)));
  if (interrupted())
    return true;
  require(folder.commit());
  return false;
}

void
sumUp(const ViewerSettings& settings, const ViewerRun& run)
{
  if (settings.quiet || (run.problem.empty() && !run.repaired))
    return;
  std::cout << settings.task.input << ": "
            << (run.repaired ? summarizeRepair(run.repair) : run.problem) << std::endl;
}

/** Whether something stays open is no matter of this program's exit code. */
std::string
tellVerdict(const ViewerRun& run)
{
  return run.repaired ? tellSurface(surfaceFacts(run.repair)) : "shown";
}

/** A file that is open. The view looks into the run. */
struct Session {
  ViewerSettings settings;
  ViewerRun run;
  std::unique_ptr<StageView> view;
};

/** Everything up to what is drawn. \return null after a signal */
std::unique_ptr<Session>
load(const ViewerSettings& settings)
{
  auto session = std::make_unique<Session>();
  session->settings = settings;
  ViewerTask& task = session->settings.task;
  require(readDecisionsIfAny(settings.decisions, task.method.survey.decisions));
  task.repairs = needsRepair(settings);
  ProgressBar bar(settings.quiet);
  bar.show("reading", 0);
  readForViewer(task, session->run);
  checkStage(settings, session->run.from_cloud);
  runForViewer(task, bar, session->run);
  if (!bar.show("drawing", 0))
    return nullptr;
  session->view =
      std::make_unique<StageView>(makeView(session->settings, session->run));
  bar.clear();
  sumUp(settings, session->run);
  return session;
}

/** Ask for a file until one can be read, or none is chosen: null then, and after a
 * signal. */
std::unique_ptr<Session>
askAndLoad(ViewerSettings settings)
{
  if (settings.offScreen() || !hasFileDialog())
    throw Failure("INPUT is missing (try --help)");
  for (std::string title = "Open a cloud or mesh";;) {
    settings.task.input = askForFile(title, "");
    if (settings.task.input.empty())
      return nullptr;
    try {
      return load(settings);
    }
    catch (const std::exception& error) {
      title = error.what();
    }
  }
}

/** Another file in place of one that is open, with the same options but those that name
 * files or a stage. Null where none is chosen or it cannot be read: the window says
 * why. */
std::unique_ptr<Session>
loadAnother(const Session& session, ViewerWindow& window)
{
  if (!hasFileDialog()) {
    window.tell("Without Qt this program has no dialog to open files.");
    return nullptr;
  }
  ViewerSettings settings = session.settings;
  std::string& input = settings.task.input;
  input = askForFile("Open a cloud or mesh", input);
  if (input.empty())
    return nullptr;
  for (std::string* name : {&settings.stage,
                            &settings.decisions,
                            &settings.output,
                            &settings.task.free_points})
    name->clear();
  settings.task.method.survey.decisions = nullptr;
  window.tell("Opening " + input + ".");
  try {
    return load(settings);
  }
  catch (const std::exception& error) {
    window.tell(error.what());
    return nullptr;
  }
}

/** \return what was opened in its place; null when it was closed, or by a signal */
std::unique_ptr<Session>
showWindow(const Session& session)
{
  const ViewerSettings& settings = session.settings;
  const ViewerRun& run = session.run;
  const ViewerFiles files(settings, run);
  const auto say = [&](const Written& written) {
    if (!settings.quiet)
      std::cout << written.told << std::endl;
    return written;
  };
  ViewerWindow window(*session.view,
                      settings.view.width,
                      settings.view.height,
                      "pcl_repair_viewer: " + settings.task.input,
                      [&](const std::string& stage, const std::string& bytes) {
                        say(files.savePicture(stage, bytes));
                      });
  std::optional<DecisionDesk> desk;
  if (!run.from_cloud && run.problem.empty()) {
    desk.emplace(proposeDecisions(run.survey, settings.task.method),
                 run.survey,
                 repairTask(settings.task, run),
                 *session.view,
                 DecisionSavers{[&](const pcl::repair::Decisions& decisions) {
                                  return say(files.saveDecisions(decisions));
                                },
                                [&](const pcl::repair::Decisions& decisions) {
                                  return say(files.saveMesh(decisions));
                                }});
    window.setDesk(*desk);
  }
  window.goTo(chosenStage(settings, session.view->stages(), 0));
  std::unique_ptr<Session> next;
  while (!next && !interrupted() && window.update())
    if (window.takeOpenWish())
      next = loadAnother(session, window);
  return next;
}

Outcome
run(const ViewerSettings& settings)
{
  checkOutputs(settings);
  std::unique_ptr<Session> session =
      settings.task.input.empty() ? askAndLoad(settings) : load(settings);
  if (interrupted())
    return {INTERRUPTED, stopped_by_signal, {}};
  if (!session)
    return {DONE, "", {}, {"nothing was opened", &std::cout}};
  if (settings.offScreen() && writePictures(settings, *session->view))
    return {INTERRUPTED, stopped_by_signal, {}};
  if (!settings.offScreen())
    while (std::unique_ptr<Session> next = showWindow(*session))
      session = std::move(next);
  if (interrupted())
    return {INTERRUPTED, "stopped by a signal", {}};
  const ViewerRun& shown = session->run;
  return {DONE, "", shown.input.warnings, {tellVerdict(shown), &std::cout}};
}

} // namespace
} // namespace app

int
main(int argc, char** argv)
{
  app::ViewerSettings settings;
  app::CommandLine line(app::viewerUsage(), settings.quiet);
  app::addViewerOptions(line, settings);
  return app::runApp(line, argc, argv, [&] { return app::run(settings); });
}

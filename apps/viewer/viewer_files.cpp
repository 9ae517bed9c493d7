// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the files that keys of the viewer write.
#include "viewer/viewer_files.h"

#include "cli/cli.h"
#include "io/decisions_file.h"
#include "io/interrupt.h"
#include "io/model_io.h"
#include "io/output_file.h"
#include "io/overwriting.h"
#include "report/verdict.h"

#include <exception>
#include <filesystem>
#include <memory>

namespace app {
namespace {

namespace fs = std::filesystem;

/** A name that is not taken, with a number if need be. */
std::string
freeName(const std::string& stem, const std::string& ending)
{
  std::string name = stem + ending;
  std::error_code ignored;
  for (int i = 2; fs::exists(name, ignored); ++i)
    name = stem + "_" + std::to_string(i) + ending;
  return name;
}

/** The input without its ending. */
std::string
stemOf(const std::string& input)
{
  return fs::path(input).replace_extension().string();
}

/** \param[in] write what the file is to hold */
template <typename Write>
Written
writeFile(const std::string& name, const Write& write)
{
  OutputFile file;
  Status status = file.open(name);
  if (status.ok()) {
    write(file);
    status = file.commit();
  }
  return {status.ok(), status.ok() ? "Written to " + name + "." : status.message()};
}

} // namespace

ViewerFiles::ViewerFiles(const ViewerSettings& settings, const ViewerRun& run)
: settings_(settings), run_(run), decisions_(settings.decisions)
{
  if (decisions_.empty())
    decisions_ = freeName(stemOf(settings.task.input) + "_decisions", ".json");
}

Written
ViewerFiles::savePicture(const std::string& stage, const std::string& bytes) const
{
  const std::string stem = fs::path(settings_.task.input).stem().string() + "_" + stage;
  return writeFile(freeName(stem, ".png"), [&](OutputFile& file) { file.text(bytes); });
}

Written
ViewerFiles::saveDecisions(const pcl::repair::Decisions& decisions) const
{
  return writeFile(decisions_, [&](OutputFile& file) {
    writeDecisions(settings_.task.input, decisions, file);
  });
}

Written
ViewerFiles::saveMesh(const pcl::repair::Decisions& decisions) const
{
  const std::string output = settings_.output.empty()
                                 ? stemOf(settings_.task.input) + "_repaired.ply"
                                 : settings_.output;
  try {
    checkDifferentFiles({settings_.task.input, settings_.task.free_points},
                        {output, decisions_});
    require(checkReplaceable(output));
    require(checkMeshOutput(output));
    return repairTo(output, decisions);
  }
  catch (const std::exception& error) {
    return {false, error.what()};
  }
}

Written
ViewerFiles::repairTo(const std::string& output,
                      const pcl::repair::Decisions& decisions) const
{
  Model model = run_.input;
  checkCoordinates(output, model);
  RepairTask task = repairTask(settings_.task, run_);
  task.method.survey.decisions =
      std::make_shared<const pcl::repair::Decisions>(decisions);
  ProgressBar bar(settings_.quiet);
  pcl::RepairReport report;
  repairMesh(task, model.viewpoint, bar, model.mesh, report);
  if (interrupted() || !report.finished)
    return {false, stopped_by_signal};
  Written written = writeFile(output, [&](OutputFile& file) {
    writeMesh(
        output, model.mesh, {{}, model.viewpoint, model.remarks}, file, model.warnings);
  });
  bar.clear();
  written.told += (report.complete() ? " complete: " : " incomplete: ") +
                  tellSurface(surfaceFacts(report));
  return written;
}

} // namespace app

// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: asks for a file in a window of its own.
#include "viewer/file_dialog.h"

#ifdef PSR_HAS_QT

#include "io/interrupt.h"
#include "io/model_io.h"

#include <clocale>
#include <filesystem>
#include <QApplication>
#include <QFile>
#include <QFileDialog>
#include <QTimer>
#include <sstream>

namespace app {
namespace {

/** Milliseconds between looks for a signal. */
constexpr int SIGNAL_INTERVAL = 50;

/** "*.pcd *.ply" and so on. */
std::string
patterns()
{
  std::string list;
  std::istringstream endings(cloud_endings);
  for (std::string ending; endings >> ending;) {
    const std::size_t dot = ending.find('.');
    list += "*" + ending.substr(dot, ending.find(')') - dot) + " ";
  }
  return list;
}

} // namespace

bool
hasFileDialog()
{
  return true;
}

std::string
askForFile(const std::string& title, const std::string& beside)
{
  int count = 1;
  char name[] = "pcl_repair_viewer";
  char* arguments[] = {name, nullptr};
  const QApplication application(count, arguments);
  std::setlocale(LC_ALL, "C"); // Qt has set that of the user: commas in numbers
  QTimer timer;                // nothing else of Qt's loop sees a signal
  QObject::connect(&timer, &QTimer::timeout, [] {
    if (interrupted())
      QApplication::closeAllWindows(); // what the dialog has to say before it
  });
  timer.start(SIGNAL_INTERVAL);
  const std::string filter = "Clouds and meshes (" + patterns() + ");;All files (*)";
  // Qt's own dialog: that of a desktop is another one everywhere.
  const QString chosen = QFileDialog::getOpenFileName(
      nullptr,
      QString::fromStdString(title),
      QFile::decodeName(std::filesystem::path(beside).parent_path().c_str()),
      QString::fromStdString(filter),
      nullptr,
      QFileDialog::DontUseNativeDialog);
  return QFile::encodeName(chosen).toStdString();
}

} // namespace app

#else

namespace app {

bool
hasFileDialog()
{
  return false;
}

std::string
askForFile(const std::string& /*title*/, const std::string& /*beside*/)
{
  return "";
}

} // namespace app

#endif

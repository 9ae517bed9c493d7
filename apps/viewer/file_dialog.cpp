// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: asks for a file in a window of its own.
#include "viewer/file_dialog.h"

#ifdef PSR_HAS_QT

#include "io/model_io.h"

#include <clocale>
#include <filesystem>
#include <QApplication>
#include <QFile>
#include <QFileDialog>
#include <sstream>

namespace app {
namespace {

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

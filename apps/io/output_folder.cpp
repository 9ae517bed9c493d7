// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: several output files that appear together or not at all.
#include "output_folder.h"

#include "interrupt.h"
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

namespace app {
namespace {

namespace fs = std::filesystem;

Status
cannotUse(const std::string& path, const std::string& why)
{
  return Status::error("cannot write to the folder '" + path + "': " + why);
}

/** The folder above \a path, which may end with a slash. */
fs::path
folderAbove(const std::string& path)
{
  const fs::path whole(path);
  const fs::path parent =
      (whole.has_filename() ? whole : whole.parent_path()).parent_path();
  return parent.empty() ? fs::path(".") : parent;
}

} // namespace

OutputFolder::~OutputFolder()
{
  files_.clear();
  if (!made_.empty())
    rmdir(made_.c_str());
}

Status
OutputFolder::check(const std::string& path)
{
  if (path.empty())
    return Status::error("the name of the folder to write to is empty");
  std::error_code ignored;
  const bool is_there = fs::exists(path, ignored);
  const fs::path folder = is_there ? fs::path(path) : folderAbove(path);
  if (is_there && !fs::is_directory(path, ignored))
    return cannotUse(path, "it is a file");
  if (access(folder.c_str(), W_OK | X_OK) != 0)
    return cannotUse(path, std::strerror(errno));
  return {};
}

bool
OutputFolder::bringsAlong(const std::string& path, const std::string& file)
{
  std::error_code ignored;
  if (path.empty() || fs::exists(path, ignored))
    return false;
  const auto folder_of = [&](const std::string& name) {
    return fs::weakly_canonical(name, ignored).parent_path();
  };
  return folder_of(file) == folder_of(path + "/any");
}

Status
OutputFolder::open(const std::string& path)
{
  std::error_code error;
  if (fs::create_directory(path, error))
    made_ = path;
  path_ = path;
  status_ = error ? cannotUse(path, error.message()) : check(path);
  return status_;
}

OutputFile&
OutputFolder::add(const std::string& name)
{
  return addElsewhere((fs::path(path_) / name).string());
}

OutputFile&
OutputFolder::addElsewhere(const std::string& path)
{
  files_.push_back(std::make_unique<OutputFile>());
  const Status opened = files_.back()->open(path);
  if (status_.ok() && !opened.ok())
    status_ = opened;
  return *files_.back();
}

void
OutputFolder::drop(const std::string& name)
{
  dropped_.push_back(name);
}

Status
OutputFolder::commit()
{
  if (status_.ok() && interrupted())
    status_ = Status::error("stopped by a signal");
  for (const auto& file : files_)
    if (status_.ok())
      status_ = file->finish();
  for (const bool is_standard_output : {true, false})
    for (const auto& file : files_)
      if (status_.ok() && file->isStandardOutput() == is_standard_output)
        status_ = file->commit();
  if (!status_.ok())
    return status_;
  made_.clear();
  for (const std::string& name : dropped_) {
    std::error_code ignored;
    fs::remove(fs::path(path_) / name, ignored);
  }
  return status_;
}

} // namespace app

// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: files between the steps of a run tile by tile.
#include "out_of_core/step_file.h"

#include <filesystem>

namespace app {
namespace {

/** Tells the file, its layout and, by the number behind it, the byte order. */
constexpr char MARK[8] = {'P', 'S', 'R', 't', 'i', 'l', 'e', '3'};
constexpr std::uint32_t ORDER = 0x01020304;

} // namespace

StepWriter::StepWriter(const std::string& path, const std::string& key)
{
  require(file_.open(path));
  put(MARK);
  put(ORDER);
  put(static_cast<std::uint32_t>(key.size()));
  file_.text(key);
}

void
StepWriter::commit()
{
  require(file_.commit());
}

StepReader::StepReader(const std::string& path, const std::string& key) : path_(path)
{
  require(file_.open(path));
  at_ = file_.begin();
  left_ = file_.size();
  if (std::memcmp(take(sizeof(MARK)), MARK, sizeof(MARK)) != 0 ||
      get<std::uint32_t>() != ORDER)
    fail("is no file of a run tile by tile, or of a machine of other byte order");
  const std::size_t length = get<std::uint32_t>();
  const char* const own = take(length);
  if (std::string(own, length) != key)
    failAsForeign(path);
}

const char*
StepReader::take(std::size_t bytes)
{
  if (bytes > left_)
    fail("is cut off");
  const char* const taken = at_;
  at_ += bytes;
  left_ -= bytes;
  return taken;
}

void
StepReader::fail(const std::string& what) const
{
  throw Failure("'" + path_ + "' " + what);
}

void
failAsForeign(const std::string& path)
{
  throw Failure("'" + path +
                "' belongs to a run with other inputs, other parameters or another "
                "version of the program; use another folder");
}

bool
isDone(const std::string& path, const std::string& key)
{
  std::error_code error;
  if (!std::filesystem::exists(path, error))
    return false;
  StepReader(path, key);
  return true;
}

} // namespace app

// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: an output file that is either whole or not there.
#include "output_file.h"

#include "file_format.h"
#include "interrupt.h"
#include "overwriting.h"
#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

namespace app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t buffer_bytes = std::size_t{1} << 20;

Status
cannotWrite(const std::string& path, const std::string& why)
{
  return Status::error("cannot write " + nameForPeople(path, "standard output") + ": " +
                       why);
}

/** A link is followed, so that renaming replaces what it points to and not the link. */
std::string
resolveLinks(const std::string& path)
{
  std::error_code error;
  const fs::path resolved = fs::weakly_canonical(path, error);
  return error || resolved.empty() ? path : resolved.string();
}

std::string
temporaryName(const std::string& path)
{
  const fs::path target(path);
  const std::string name = "." + target.filename().string().substr(0, 200) + ".part-" +
                           std::to_string(getpid());
  return (target.parent_path() / name).string();
}

bool
isDevice(const std::string& path)
{
  struct stat info {};
  return stat(path.c_str(), &info) == 0 && !S_ISREG(info.st_mode) &&
         !S_ISDIR(info.st_mode);
}

/** What is at \a path now must be nothing, a device, or a file that may be replaced. */
Status
checkTarget(const std::string& path)
{
  struct stat info {};
  if (stat(path.c_str(), &info) != 0)
    return errno == ENOENT || errno == ENOTDIR
               ? Status()
               : cannotWrite(path, std::strerror(errno));
  if (S_ISDIR(info.st_mode))
    return cannotWrite(path, "it is a folder");
  if (access(path.c_str(), W_OK) != 0)
    return cannotWrite(path, std::strerror(errno));
  return checkReplaceable(path);
}

/** What has been begun is brought to its end, lest a reader gets half a result; after a
 * signal only as long as the reader takes it. \return an errno, or 0. */
int
writeToStream(int descriptor, const std::vector<char>& bytes)
{
  constexpr int patience_ms = 200;
  constexpr std::size_t portion = 4096; // what poll() promises to fit into a pipe
  std::size_t done = 0;
  while (done < bytes.size()) {
    pollfd request{descriptor, POLLOUT, 0};
    const int ready = poll(&request, 1, patience_ms);
    if (ready == 0 && interrupted())
      return EINTR;
    if (ready == 0 || (ready < 0 && errno == EINTR))
      continue;
    const ssize_t written = ::write(
        descriptor, bytes.data() + done, std::min(portion, bytes.size() - done));
    if (written < 0 && errno != EINTR && errno != EAGAIN)
      return errno;
    done += written > 0 ? static_cast<std::size_t>(written) : 0;
  }
  return 0;
}

} // namespace

OutputFile::~OutputFile() { discard(); }

Status
OutputFile::check(const std::string& path)
{
  if (isStandardStream(path))
    return {};
  if (isDevice(path))
    return checkTarget(path);
  OutputFile probe;
  return probe.open(path);
}

Status
OutputFile::open(const std::string& path)
{
  discard();
  is_stream_ = isStandardStream(path);
  if (is_stream_) {
    path_ = path;
    error_ = 0;
    buffer_.reserve(buffer_bytes);
    return {};
  }
  Status status = checkTarget(path);
  if (!status.ok())
    return status;
  path_ = resolveLinks(path);
  const bool is_device = isDevice(path);
  const std::string opened = is_device ? path : temporaryName(path_);
  const int flags = O_WRONLY | O_CLOEXEC | (is_device ? 0 : O_CREAT | O_TRUNC);
  descriptor_ = ::open(opened.c_str(), flags, 0666);
  if (descriptor_ < 0)
    return cannotWrite(path, std::strerror(errno));
  error_ = 0;
  if (!is_device) {
    temporary_ = opened;
    slot_ = addTemporaryFile(temporary_);
  }
  buffer_.reserve(buffer_bytes);
  return {};
}

void
OutputFile::write(const void* bytes, std::size_t count)
{
  const auto* first = static_cast<const char*>(bytes);
  if (buffer_.size() + count > buffer_bytes)
    flush();
  buffer_.insert(buffer_.end(), first, first + count);
}

void
OutputFile::flush()
{
  if (is_stream_) {
    held_back_.push_back(std::move(buffer_));
    buffer_ = {};
    buffer_.reserve(buffer_bytes);
    return;
  }
  std::size_t done = 0;
  while (done < buffer_.size() && error_ == 0) {
    const ssize_t written =
        ::write(descriptor_, buffer_.data() + done, buffer_.size() - done);
    if (interrupted())
      error_ = EINTR;
    else if (written < 0 && errno != EINTR)
      error_ = errno;
    else if (written > 0)
      done += static_cast<std::size_t>(written);
  }
  buffer_.clear();
}

Status
OutputFile::finish()
{
  if (descriptor_ < 0)
    return {};
  flush();
  if (::close(descriptor_) != 0 && error_ == 0)
    error_ = errno;
  descriptor_ = -1;
  return error_ == 0 ? Status() : cannotWrite(path_, std::strerror(error_));
}

Status
OutputFile::commitStream()
{
  flush();
  for (const std::vector<char>& bytes : held_back_)
    if (error_ == 0)
      error_ = writeToStream(STDOUT_FILENO, bytes);
  held_back_.clear();
  return error_ == 0 ? Status() : cannotWrite(path_, std::strerror(error_));
}

Status
OutputFile::commit()
{
  if (is_stream_)
    return commitStream();
  if (!finish().ok())
    discard();
  if (error_ == 0 && !temporary_.empty() &&
      std::rename(temporary_.c_str(), path_.c_str()) != 0)
    error_ = errno;
  if (error_ == 0) {
    temporary_.clear();
    removeTemporaryFile(slot_);
  }
  discard();
  return error_ == 0 ? Status() : cannotWrite(path_, std::strerror(error_));
}

void
OutputFile::discard()
{
  if (descriptor_ >= 0)
    ::close(descriptor_);
  descriptor_ = -1;
  if (!temporary_.empty()) {
    unlink(temporary_.c_str());
    removeTemporaryFile(slot_);
  }
  temporary_.clear();
  held_back_.clear();
}

} // namespace app

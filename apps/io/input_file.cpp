// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the bytes of an input file, mapped into memory.
#include "input_file.h"

#include "file_format.h"
#include "interrupt.h"
#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace app {
namespace {

/** A signal does not end a read() that waits, so the wait is done here.
 * \return false when a signal has come. */
bool
waitForBytes(int descriptor)
{
  constexpr int patience_ms = 200;
  pollfd request{descriptor, POLLIN, 0};
  while (!interrupted()) {
    const int ready = poll(&request, 1, patience_ms);
    if (ready > 0 || (ready < 0 && errno != EINTR))
      return true; // read() will tell what is wrong
  }
  return false;
}

} // namespace

InputFile::~InputFile()
{
  if (mapped_)
    munmap(const_cast<char*>(data_), size_);
}

Status
InputFile::open(const std::string& path)
{
  Status status = isStandardStream(path) ? readAll(STDIN_FILENO, "standard input")
                                         : openNamed(path);
  if (status.ok() && size_ == 0)
    status = Status::error(nameForPeople(path) + " is empty");
  return status;
}

Status
InputFile::openNamed(const std::string& path)
{
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0)
    return Status::error("cannot open '" + path + "': " + std::strerror(errno));
  struct stat info {};
  Status status;
  if (fstat(descriptor, &info) != 0)
    status = Status::error("cannot read '" + path + "': " + std::strerror(errno));
  else if (S_ISDIR(info.st_mode))
    status = Status::error("'" + path + "' is a folder, not a file");
  else if (S_ISREG(info.st_mode) && info.st_size > 0) {
    size_ = static_cast<std::size_t>(info.st_size);
    void* bytes = mmap(nullptr, size_, PROT_READ, MAP_PRIVATE, descriptor, 0);
    mapped_ = bytes != MAP_FAILED;
    if (mapped_)
      data_ = static_cast<const char*>(bytes);
  }
  if (status.ok() && !mapped_)
    status = readAll(descriptor, "'" + path + "'");
  ::close(descriptor);
  return status;
}

Status
InputFile::readAll(int descriptor, const std::string& name)
{
  constexpr std::size_t block = std::size_t{1} << 20;
  std::size_t used = 0;
  for (;;) {
    if (!waitForBytes(descriptor))
      return Status::error("stopped by a signal while reading " + name);
    buffer_.resize(used + block);
    const ssize_t got = ::read(descriptor, buffer_.data() + used, block);
    if (got < 0 && errno == EINTR)
      continue;
    if (got < 0)
      return Status::error("cannot read " + name + ": " + std::strerror(errno));
    if (got == 0)
      break;
    used += static_cast<std::size_t>(got);
  }
  data_ = buffer_.data();
  size_ = used;
  return {};
}

} // namespace app

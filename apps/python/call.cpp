// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: one call from Python: without its lock, with its signals.
#include "call.h"

#include <pcl/console/print.h>

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <stdexcept>
#include <utility>

namespace {

thread_local app::python::Messages* sink_of_thread = nullptr;

/** More often nobody can see it. */
constexpr std::chrono::milliseconds interval{50};

struct Stopped : std::runtime_error {
  using std::runtime_error::runtime_error;
};

std::string
formatted(const char* format, std::va_list arguments)
{
  std::va_list again;
  va_copy(again, arguments);
  const int size = std::vsnprintf(nullptr, 0, format, arguments);
  std::string text(static_cast<std::size_t>(std::max(size, 0)) + 1, '\0');
  std::vsnprintf(text.data(), text.size(), format, again);
  va_end(again);
  text.pop_back();
  while (!text.empty() && text.back() == '\n')
    text.pop_back();
  return text;
}

std::string
joined(const std::vector<std::string>& lines)
{
  std::string text;
  for (const std::string& line : lines)
    text += (text.empty() ? "" : "\n") + line;
  return text;
}

} // namespace

namespace pcl::console {

/** The libraries loaded with this module find this function before PCL's own, which
 * knows no other place for messages than the terminal. */
__attribute__((visibility("default"))) void
print(VERBOSITY_LEVEL level, const char* format, ...)
{
  if (!isVerbosityLevelEnabled(level))
    return;
  std::va_list arguments;
  va_start(arguments, format);
  if (sink_of_thread == nullptr)
    std::vfprintf(level <= L_WARN ? stderr : stdout, format, arguments);
  else if (level <= L_ERROR)
    sink_of_thread->errors.push_back(formatted(format, arguments));
  else if (level == L_WARN)
    sink_of_thread->warnings.push_back(formatted(format, arguments));
  va_end(arguments);
}

} // namespace pcl::console

namespace app::python {

namespace py = pybind11;

MessageSink::MessageSink(Messages& messages)
: before_(std::exchange(sink_of_thread, &messages))
{}

MessageSink::~MessageSink() { sink_of_thread = before_; }

pcl::ccaa::ProgressCallback
Call::callback()
{
  return
      [this](const std::string& stage, double share) { return report(stage, share); };
}

bool
Call::report(const std::string& stage, double share)
{
  const Clock::time_point now = Clock::now();
  if (stage == stage_ && share < 1.0 && now - last_ < interval)
    return true;
  last_ = now;
  stage_ = stage;
  const py::gil_scoped_acquire locked;
  try {
    if (PyErr_CheckSignals() != 0)
      throw py::error_already_set();
    cancelled_ = !progress_.is_none() && progress_(stage, share).is(py::bool_(false));
  }
  catch (const py::error_already_set&) {
    raised_ = std::current_exception();
  }
  return !cancelled_ && !raised_;
}

void
Call::finish() const
{
  if (raised_)
    std::rethrow_exception(raised_);
  if (cancelled_)
    throw Stopped("the progress function returned False during '" + stage_ + "'");
  for (const std::string& warning : messages_.warnings)
    if (PyErr_WarnEx(PyExc_RuntimeWarning, warning.c_str(), 2) != 0)
      throw py::error_already_set();
  std::string errors = joined(messages_.errors);
  const bool is_memory = errors.find("out of memory") != std::string::npos ||
                         errors.find("bad_alloc") != std::string::npos;
  if (errors.empty())
    return;
  if (!options_.empty())
    errors += "; options: " + py::repr(options_).cast<std::string>();
  PyErr_SetString(is_memory ? PyExc_MemoryError : PyExc_ValueError, errors.c_str());
  throw py::error_already_set();
}

void
addCancelled(py::module_& module)
{
  py::register_exception<Stopped>(module, "Cancelled", PyExc_RuntimeError).doc() =
      "A progress function returned False; nothing has been made.";
}

} // namespace app::python

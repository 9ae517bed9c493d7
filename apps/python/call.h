// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: one call from Python: without its lock, with its signals.
#pragma once

#include <pcl/surface_ccaa/run_settings.h>

#include <pybind11/pybind11.h>

#include <chrono>
#include <exception>
#include <string>
#include <utility>
#include <vector>

namespace app::python {

/** \brief What the libraries have told during a run, a message an item. */
struct Messages {
  std::vector<std::string> errors;
  std::vector<std::string> warnings;
};

/** \brief From now on what PCL's console is told on this thread goes there. */
class MessageSink {
public:
  explicit MessageSink(Messages& messages);
  ~MessageSink();
  MessageSink(const MessageSink&) = delete;
  MessageSink&
  operator=(const MessageSink&) = delete;

private:
  Messages* before_;
};

/** \brief Runs what computes without the interpreter's lock. Ctrl-C and a progress
 * function that returns False or raises stop it. Used by one thread, which holds the
 * lock. */
class Call {
public:
  /** \param[in] progress called with stage and share; None: nobody is told
   * \param[in] options that were given, for messages */
  Call(pybind11::object progress, pybind11::dict options)
  : progress_(std::move(progress)), options_(std::move(options))
  {}

  /** \brief For the run; must not outlive the call. */
  pcl::ccaa::ProgressCallback
  callback();

  /** \brief Run \a body. Throws what the progress function has raised,
   * KeyboardInterrupt after Ctrl-C, Cancelled, ValueError or MemoryError with what the
   * libraries tell. Their warnings become Python's. */
  template <typename Body>
  void
  run(const Body& body)
  {
    {
      const pybind11::gil_scoped_release released;
      const MessageSink sink(messages_);
      const Clock::time_point begin = Clock::now();
      body();
      seconds_ = std::chrono::duration<double>(Clock::now() - begin).count();
    }
    finish();
  }

  /** \brief Wall-clock seconds that the body took, with nothing of Python's. */
  double
  seconds() const
  {
    return seconds_;
  }

private:
  using Clock = std::chrono::steady_clock;

  bool
  report(const std::string& stage, double share);
  void
  finish() const;

  pybind11::object progress_;
  pybind11::dict options_;
  Messages messages_;
  std::exception_ptr raised_;
  bool cancelled_ = false;
  double seconds_ = 0.0;
  std::string stage_;
  Clock::time_point last_ = Clock::now();
};

/** \brief Make the exception Cancelled of a module. */
void
addCancelled(pybind11::module_& module);

} // namespace app::python

// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: files between the steps of a run tile by tile.
#pragma once

#include <Eigen/Geometry>

#include "io/input_file.h"
#include "io/output_file.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

namespace app {

/** \brief Writes numbers and arrays of them in the byte order of the machine, behind a
 * mark and the key of the run. The file has its name when it is whole. Throws a Failure
 * where it cannot be written. */
class StepWriter {
public:
  StepWriter(const std::string& path, const std::string& key);

  template <typename T>
  void
  put(const T& value)
  {
    static_assert(std::is_trivially_copyable_v<T>);
    file_.write(&value, sizeof(T));
  }

  template <typename T>
  void
  putAll(const std::vector<T>& values)
  {
    static_assert(std::is_trivially_copyable_v<T>);
    put(std::uint64_t{values.size()});
    file_.write(values.data(), values.size() * sizeof(T));
  }

  void
  commit();

private:
  OutputFile file_;
};

/** \brief Reads what a StepWriter has written. Throws a Failure for a file that is not
 * there, is cut off, or belongs to another run. */
class StepReader {
public:
  StepReader(const std::string& path, const std::string& key);

  template <typename T>
  T
  get()
  {
    T value;
    std::memcpy(&value, take(sizeof(T)), sizeof(T));
    return value;
  }

  template <typename T>
  std::vector<T>
  getAll()
  {
    const std::size_t count = size<T>();
    std::vector<T> values(count);
    if (count > 0)
      std::memcpy(values.data(), take(count * sizeof(T)), count * sizeof(T));
    return values;
  }

  /** \brief Elements of an array from one up to but without another. */
  template <typename T>
  std::vector<T>
  getPart(std::uint64_t begin, std::uint64_t end)
  {
    std::size_t count = 0;
    const char* const all = skipAll<T>(count);
    if (begin > end || end > count)
      fail("is no file of such a step");
    std::vector<T> values(static_cast<std::size_t>(end - begin));
    if (!values.empty())
      std::memcpy(values.data(), all + begin * sizeof(T), values.size() * sizeof(T));
    return values;
  }

  /** \brief Step over an array. \return where it begins in the file */
  template <typename T>
  const char*
  skipAll(std::size_t& count)
  {
    count = size<T>();
    return take(count * sizeof(T));
  }

private:
  template <typename T>
  std::size_t
  size()
  {
    const auto count = get<std::uint64_t>();
    if (count > left_ / sizeof(T))
      fail("is cut off");
    return static_cast<std::size_t>(count);
  }
  const char*
  take(std::size_t bytes);
  [[noreturn]] void
  fail(const std::string& what) const;

  std::string path_;
  InputFile file_;
  const char* at_ = nullptr;
  std::size_t left_ = 0;
};

/** \brief Throws a Failure: the file is of another run. */
[[noreturn]] void
failAsForeign(const std::string& path);

/** \brief Whether the file of a step is there, whole, and of this run: the step need
 * not be done again. Fails for one of another run. */
bool
isDone(const std::string& path, const std::string& key);

/** \brief A box as files have it, and back: Eigen's types are not for copying bytes. */
inline std::array<double, 6>
storedBox(const Eigen::AlignedBox3d& box)
{
  std::array<double, 6> result{};
  Eigen::Map<Eigen::Vector3d>(result.data()) = box.min();
  Eigen::Map<Eigen::Vector3d>(result.data() + 3) = box.max();
  return result;
}

inline Eigen::AlignedBox3d
boxOf(const std::array<double, 6>& from)
{
  return {Eigen::Vector3d(from.data()), Eigen::Vector3d(from.data() + 3)};
}

} // namespace app

// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: columns of numbers in a file become the fields of a cloud.
#pragma once

#include <pcl/PCLPointCloud2.h>

#include "scalar_types.h"
#include "status.h"
#include "text_scanner.h"

#include <string>
#include <vector>

namespace app {

/** \brief Numbers that a point may have; the plan for them takes memory. */
constexpr std::size_t most_numbers = 100000;

/** \brief One named column of a file's point records. */
struct SourceColumn {
  std::string name;
  ScalarType type = 0;
  std::size_t count = 1; /**< numbers in it; more than one for descriptors in PCD */
};

/** \brief Whose names the columns bear. */
enum class Naming {
  PCL, /**< normal_x, rgb: taken as they are */
  PLY  /**< nx and red, green, blue: turned into PCL's fields */
};

/** \brief Where one number of a record goes; target_type 0 drops it. */
struct Slot {
  std::size_t source_offset = 0; /**< bytes, in a binary record */
  ScalarType source_type = 0;
  std::size_t target_offset = 0; /**< bytes, in the point */
  ScalarType target_type = 0;
};

/** \brief How records become points. Positions become float32, as PCL wants them, or
 * double where one of them is a double or a long whole number; every other number keeps
 * its type. Fields are aligned to their size. */
struct TablePlan {
  std::vector<pcl::PCLPointField> fields;
  std::size_t point_step = 0;    /**< bytes of a point */
  std::size_t source_stride = 0; /**< bytes of a binary record */
  std::vector<Slot> slots;       /**< in the order of the columns */
};

/** \brief Plan the cloud for \a columns. Columns named "_" are padding and left out.
 * Throws a Failure when x, y or z is missing or a name occurs twice. */
TablePlan
planTable(const std::vector<SourceColumn>& columns, Naming naming);

/** \brief Turn x, y and z into doubles where the text of \a points records has more
 * digits than floats can hold. */
void
widenForText(TextScanner scanner,
             std::size_t points,
             std::vector<SourceColumn>& columns);

/** \brief Set fields and size of \a cloud and take its memory (zeroed).
 * Throws a Failure for more points than PCL can index. Call it only for counts which
 * the file is long enough for. */
void
allocateCloud(const TablePlan& plan, std::size_t points, pcl::PCLPointCloud2& cloud);

/** \brief Fill \a cloud from as many binary records as it has points. */
void
decodeBinary(const TablePlan& plan,
             const char* records,
             bool swapped,
             pcl::PCLPointCloud2& cloud);

/** \brief Parse \a word as a number of type \a type into \a target; type 0 checks only
 * that it is a number. */
bool
decodeWord(std::string_view word, ScalarType type, std::uint8_t* target);

/** \brief Fill \a cloud from as many records of words as it has points; throws a
 * Failure for words that are no numbers, or too few. */
void
decodeText(const TablePlan& plan, TextScanner& scanner, pcl::PCLPointCloud2& cloud);

/** \brief The point records of a file that is in memory, to be decoded in portions. */
struct PointRecords {
  TablePlan plan;
  std::size_t left = 0;               /**< records not yet decoded */
  TextScanner rows = TextScanner({}); /**< at the next of them */
  bool is_text = false;
  bool swapped = false; /**< binary, of the other byte order */

  /** \brief Make \a cloud the next \a points points, at most those that are left.
   * Throws a Failure for words that are no numbers. */
  void
  decode(std::size_t points, pcl::PCLPointCloud2& cloud);
};

} // namespace app

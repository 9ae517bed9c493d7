// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: reads points from plain text, a line each.
#include "point_table.h"
#include "readers.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace app {
namespace {

using Field = pcl::PCLPointField;
using Words = std::vector<std::string_view>;

bool
isSeparator(char c)
{
  return c == ',' || c == ';' || TextScanner::isSpace(c);
}

void
splitLine(std::string_view line, Words& words)
{
  words.clear();
  for (std::size_t at = 0; at < line.size();) {
    const std::size_t first = at;
    while (at < line.size() && !isSeparator(line[at]))
      ++at;
    if (at > first)
      words.push_back(line.substr(first, at - first));
    ++at;
  }
}

/** The comment sign cut off; \return whether there was one. */
bool
stripComment(std::string_view& line)
{
  while (!line.empty() && TextScanner::isSpace(line.front()))
    line.remove_prefix(1);
  const bool hash = line.substr(0, 1) == "#";
  const bool slashes = line.substr(0, 2) == "//";
  line.remove_prefix(hash ? 1 : slashes ? 2 : 0);
  return hash || slashes;
}

/** What the numbers of one column have been like. */
struct ColumnRange {
  bool is_whole = true;
  double lowest = 0;
  double highest = 0;

  void
  add(double value)
  {
    is_whole = is_whole && value == std::trunc(value);
    lowest = std::min(lowest, value);
    highest = std::max(highest, value);
  }
  bool
  isByte() const
  {
    return is_whole && lowest >= 0 && highest <= 255;
  }
  bool
  isInt() const
  {
    return is_whole && lowest >= -2147483648.0 && highest <= 2147483647.0;
  }
};

/** First pass: how many points, how many columns, and what is in them. */
struct Survey {
  std::size_t points = 0;
  std::vector<std::string> heading;
  std::vector<ColumnRange> columns;
  std::size_t skipped_lines = 0; /**< heading and count at the beginning */
  bool is_wide = false;          /**< positions have digits that floats do not hold */
};

std::string
headingName(std::string_view word)
{
  std::string name(word);
  name.erase(std::remove(name.begin(), name.end(), '"'), name.end());
  std::string lower = name;
  for (char& c : lower)
    c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  if (lower == "r")
    return "red";
  if (lower == "g")
    return "green";
  if (lower == "b")
    return "blue";
  const bool is_usual = lower.size() == 1 || lower == "nx" || lower == "ny" ||
                        lower == "nz" || lower == "red" || lower == "green" ||
                        lower == "blue" || lower == "intensity";
  return is_usual ? lower : name;
}

void
takeHeading(const Words& words, Survey& survey)
{
  std::vector<std::string> names;
  for (const std::string_view word : words)
    names.push_back(headingName(word));
  if (names.size() >= 3 && names[0] == "x" && names[1] == "y" && names[2] == "z")
    survey.heading = names;
}

[[noreturn]] void
failAt(std::size_t line_number, const std::string& what)
{
  throw Failure("line " + std::to_string(line_number) + " " + what);
}

[[noreturn]] void
failAtWord(std::size_t line_number, std::string_view word)
{
  failAt(line_number,
         "has '" + std::string(word.substr(0, 40)) + "' where a number should be");
}

void
surveyPoint(const Words& words, std::size_t line_number, Survey& survey)
{
  if (words.size() > most_numbers)
    failAt(line_number, "has too many numbers for a point");
  if (words.size() < 3)
    failAt(line_number, "has fewer than three numbers");
  if (survey.points == 0)
    survey.columns.resize(words.size());
  if (words.size() != survey.columns.size())
    failAt(line_number,
           "has " + std::to_string(words.size()) + " numbers where the first has " +
               std::to_string(survey.columns.size()));
  double value = 0;
  for (std::size_t i = 0; i < 3 && !survey.is_wide; ++i)
    survey.is_wide = parseNumber(words[i], value) && needsDouble(words[i], value);
  for (std::size_t i = 3; i < words.size(); ++i) {
    if (!parseNumber(words[i], value))
      failAtWord(line_number, words[i]);
    survey.columns[i].add(value);
  }
  ++survey.points;
}

/** A heading without comment sign, or the count of a .pts file. */
bool
isPreamble(const Words& words, Survey& survey)
{
  double number = 0;
  const bool is_count = words.size() == 1 && parseNumber(words[0], number);
  const bool is_heading = words.size() >= 3 && !parseNumber(words[0], number);
  if (is_heading)
    takeHeading(words, survey);
  return is_count || (is_heading && !survey.heading.empty());
}

Survey
surveyFile(const InputFile& file)
{
  Survey survey;
  TextScanner scanner(file.bytes());
  std::string_view line;
  Words words;
  for (std::size_t number = 1; scanner.nextLine(line); ++number) {
    const bool is_comment = stripComment(line);
    if (is_comment && survey.points > 0)
      continue;
    splitLine(line, words);
    if (is_comment)
      takeHeading(words, survey);
    if (is_comment || words.empty())
      continue;
    if (survey.points == 0 && survey.skipped_lines < 2 && isPreamble(words, survey))
      ++survey.skipped_lines;
    else
      surveyPoint(words, number, survey);
  }
  if (survey.points == 0)
    throw Failure("it holds no points");
  return survey;
}

bool
areBytes(const Survey& survey, std::size_t first)
{
  return survey.columns[first].isByte() && survey.columns[first + 1].isByte() &&
         survey.columns[first + 2].isByte();
}

std::vector<std::string>
guessNames(const Survey& survey)
{
  const std::size_t count = survey.columns.size();
  std::vector<std::string> names{"x", "y", "z"};
  for (std::size_t i = 3; i < count; ++i)
    names.push_back("field_" + std::to_string(i + 1));
  const bool has_colour = (count == 6 || count == 7) && areBytes(survey, count - 3);
  if (has_colour)
    std::copy_n(
        std::array<const char*, 3>{"red", "green", "blue"}.begin(), 3, names.end() - 3);
  else if (count == 6)
    std::copy_n(
        std::array<const char*, 3>{"nx", "ny", "nz"}.begin(), 3, names.end() - 3);
  if (count == 4 || (count == 7 && has_colour))
    names[3] = "intensity";
  return names;
}

ScalarType
columnType(const std::string& name, const ColumnRange& range)
{
  if (name == "red" || name == "green" || name == "blue")
    return range.isByte() ? Field::UINT8 : Field::FLOAT32;
  const bool is_usual = name.size() == 1 || name == "nx" || name == "ny" ||
                        name == "nz" || name == "intensity" || name == "curvature";
  if (is_usual)
    return Field::FLOAT32;
  return range.isInt() ? Field::INT32 : Field::FLOAT64;
}

/** Second pass: the numbers themselves. */
void
readPoints(const InputFile& file,
           std::size_t skipped_lines,
           const TablePlan& plan,
           pcl::PCLPointCloud2& cloud)
{
  TextScanner scanner(file.bytes());
  std::string_view line;
  Words words;
  std::uint8_t* point = cloud.data.data();
  for (std::size_t number = 1; scanner.nextLine(line); ++number) {
    if (stripComment(line))
      continue;
    splitLine(line, words);
    if (words.empty() || skipped_lines > 0) {
      skipped_lines -= words.empty() ? 0 : 1;
      continue;
    }
    for (std::size_t i = 0; i < words.size(); ++i) {
      const Slot& slot = plan.slots[i];
      if (!decodeWord(words[i], slot.target_type, point + slot.target_offset))
        failAtWord(number, words[i]);
    }
    point += plan.point_step;
  }
}

} // namespace

void
readXyz(const InputFile& file, Model& model)
{
  const Survey survey = surveyFile(file);
  const bool is_named = survey.heading.size() == survey.columns.size();
  const auto names = is_named ? survey.heading : guessNames(survey);
  std::vector<SourceColumn> columns;
  for (std::size_t i = 0; i < names.size(); ++i)
    columns.push_back({names[i], columnType(names[i], survey.columns[i]), 1});
  if (survey.is_wide)
    columns.front().type = Field::FLOAT64; // and so all three
  const TablePlan plan = planTable(columns, Naming::PLY);
  allocateCloud(plan, survey.points, model.mesh.cloud);
  readPoints(file, survey.skipped_lines, plan, model.mesh.cloud);
}

} // namespace app

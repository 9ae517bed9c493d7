// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the lines of a file that are for people.
#include "remarks.h"

#include "text_scanner.h"

#include <algorithm>
#include <array>

namespace app {
namespace {

/** As long as VTK allows a title to be. */
constexpr std::size_t longest_title = 255;

char
lower(char c)
{
  return static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
}

bool
isLetter(char c)
{
  return lower(c) >= 'a' && lower(c) <= 'z';
}

std::string_view
trimmed(std::string_view text)
{
  while (!text.empty() && TextScanner::isSpace(text.front()))
    text.remove_prefix(1);
  while (!text.empty() && TextScanner::isSpace(text.back()))
    text.remove_suffix(1);
  return text;
}

/** Names of lengths; "unit sphere" is no unit. */
bool
isLength(std::string_view word)
{
  static const std::array<std::string_view, 31> names{
      "m",          "mm",          "cm",         "dm",         "km",     "um",
      "nm",         "in",          "ft",         "yd",         "inch",   "inches",
      "foot",       "feet",        "yard",       "yards",      "micron", "microns",
      "meter",      "meters",      "metre",      "metres",     "mile",   "miles",
      "millimeter", "millimeters", "millimetre", "centimeter", "mils",   "millimetres",
      "centimeters"};
  std::string small(word);
  std::transform(small.begin(), small.end(), small.begin(), lower);
  return std::find(names.begin(), names.end(), small) != names.end();
}

/** What stands behind the word "unit" or "units". */
std::string_view
unitsBehind(std::string_view rest)
{
  if (!rest.empty() && lower(rest.front()) == 's')
    rest.remove_prefix(1);
  if (rest.empty() || isLetter(rest.front()))
    return {};
  rest = trimmed(rest);
  if (!rest.empty() && (rest.front() == ':' || rest.front() == '='))
    return trimmed(rest.substr(1));
  TextScanner words(rest.data(), rest.data() + rest.size());
  std::string_view word;
  words.nextWord(word);
  if (word == "are" || word == "is")
    words.nextWord(word);
  return isLength(word) ? word : std::string_view();
}

std::string_view
unitsIn(std::string_view text)
{
  constexpr std::string_view word = "unit";
  const auto same = [](char a, char b) { return lower(a) == b; };
  auto from = text.begin();
  for (;;) {
    const auto found = std::search(from, text.end(), word.begin(), word.end(), same);
    if (found == text.end())
      return {};
    const auto at = static_cast<std::size_t>(found - text.begin());
    from = found + 1;
    if (at > 0 && isLetter(text[at - 1]))
      continue;
    const std::string_view units = unitsBehind(text.substr(at + word.size()));
    if (!units.empty())
      return units;
  }
}

/** Without the sign of a comment; \return whether it was one. */
bool
takeComment(std::string_view& line)
{
  line = trimmed(line);
  const std::size_t sign = line.substr(0, 2) == "//" ? 2 : 1;
  if (sign == 1 && line.substr(0, 1) != "#")
    return false;
  line = trimmed(line.substr(sign));
  return true;
}

/** In a title other text follows behind it. */
constexpr std::string_view mark_end = "; ";

/** Cut off our mark; \return whether it was there. */
bool
takeMark(std::string_view& text)
{
  if (text.substr(0, our_mark.size()) != our_mark)
    return false;
  const std::string_view rest = text.substr(our_mark.size());
  if (!rest.empty() && rest.substr(0, mark_end.size()) != mark_end)
    return false;
  text = trimmed(rest.substr(std::min(rest.size(), mark_end.size())));
  return true;
}

} // namespace

bool
carriesOurMark(std::string_view beginning)
{
  constexpr int lines_with_mark = 3; // what a format must begin with, and the mark
  constexpr std::string_view ply_keyword = "comment ";
  TextScanner scanner(beginning.data(), beginning.data() + beginning.size());
  std::string_view line;
  for (int i = 0; i < lines_with_mark && scanner.nextLine(line); ++i) {
    takeComment(line);
    if (line.substr(0, ply_keyword.size()) == ply_keyword)
      line.remove_prefix(ply_keyword.size());
    if (takeMark(line))
      return true;
  }
  return false;
}

void
addComment(std::string_view text, Remarks& remarks)
{
  text = trimmed(text);
  takeMark(text);
  if (!text.empty())
    remarks.comments.emplace_back(text);
}

void
readUnitComments(const InputFile& file, std::size_t lines_before, Remarks& remarks)
{
  TextScanner scanner(file.begin(), file.end());
  std::string_view line;
  while (scanner.nextLine(line)) {
    if (trimmed(line).empty())
      continue;
    if (!takeComment(line)) {
      if (lines_before == 0)
        return;
      --lines_before;
      continue;
    }
    if (!unitsIn(line).empty())
      addComment(line, remarks);
  }
}

std::vector<std::string>
asComments(const Remarks& remarks)
{
  std::vector<std::string> lines{std::string(our_mark)};
  if (!remarks.title.empty())
    lines.push_back(remarks.title);
  lines.insert(lines.end(), remarks.comments.begin(), remarks.comments.end());
  lines.insert(lines.end(), remarks.infos.begin(), remarks.infos.end());
  return lines;
}

std::string
asTitle(const Remarks& remarks)
{
  std::string title;
  for (const std::string& line : asComments(remarks))
    if (title.size() + line.size() + 2 <= longest_title)
      title += (title.empty() ? "" : mark_end.data()) + line;
  return title;
}

std::string
namedUnits(const Remarks& remarks)
{
  for (const std::string& line : asComments(remarks)) {
    const std::string_view units = unitsIn(line);
    if (!units.empty())
      return std::string(units);
  }
  return "";
}

} // namespace app

// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: comments of files, and the units they name.
#include "remarks.h"

#include "text_scanner.h"

#include <algorithm>

namespace app {
namespace {

/** As long as VTK allows a title to be. */
constexpr std::size_t longest_title = 255;

/** In a title other text follows behind our mark. */
constexpr std::string_view mark_end = "; ";

std::string_view
trimmed(std::string_view text)
{
  while (!text.empty() && TextScanner::isSpace(text.front()))
    text.remove_prefix(1);
  while (!text.empty() && TextScanner::isSpace(text.back()))
    text.remove_suffix(1);
  return text;
}

bool
isLetter(char c)
{
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

std::string
inSmallLetters(std::string_view text)
{
  std::string small(text);
  for (char& c : small)
    c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  return small;
}

/** Names of lengths; "unit sphere" is no unit. */
bool
isLength(std::string_view word)
{
  constexpr std::string_view names =
      " m mm cm dm km um nm in ft yd inch inches foot feet yard yards micron microns "
      "meter meters metre metres mile millimeter millimeters millimetre millimetres "
      "centimeter centimeters mils ";
  return !word.empty() &&
         names.find(" " + inSmallLetters(word) + " ") != std::string_view::npos;
}

/** What stands behind the word "unit" or "units". */
std::string_view
unitsBehind(std::string_view rest)
{
  if (!rest.empty() && (rest.front() == 's' || rest.front() == 'S'))
    rest.remove_prefix(1);
  if (rest.empty() || isLetter(rest.front()))
    return {};
  rest = trimmed(rest);
  if (!rest.empty() && (rest.front() == ':' || rest.front() == '='))
    return trimmed(rest.substr(1));
  TextScanner words(rest);
  std::string_view word = words.word();
  if (word == "are" || word == "is")
    word = words.word();
  return isLength(word) ? word : std::string_view();
}

std::string_view
unitsIn(std::string_view text)
{
  constexpr std::string_view word = "unit";
  const std::string small = inSmallLetters(text);
  for (std::size_t at = small.find(word); at != std::string::npos;
       at = small.find(word, at + 1)) {
    const bool is_word = at == 0 || !isLetter(small[at - 1]);
    const std::string_view units = unitsBehind(text.substr(at + word.size()));
    if (is_word && !units.empty())
      return units;
  }
  return {};
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

bool
hasMark(std::string_view text)
{
  const std::string_view rest = text.substr(std::min(text.size(), our_mark.size()));
  return text.substr(0, our_mark.size()) == our_mark &&
         (rest.empty() || rest.substr(0, mark_end.size()) == mark_end);
}

} // namespace

bool
carriesOurMark(std::string_view beginning)
{
  constexpr int lines_with_mark = 3; // what a format must begin with, and the mark
  constexpr std::string_view ply_keyword = "comment ";
  TextScanner scanner(beginning);
  std::string_view line;
  for (int i = 0; i < lines_with_mark && scanner.nextLine(line); ++i) {
    takeComment(line);
    if (line.substr(0, ply_keyword.size()) == ply_keyword)
      line.remove_prefix(ply_keyword.size());
    if (hasMark(line))
      return true;
  }
  return false;
}

void
addComment(std::string_view text, std::vector<std::string>& lines)
{
  text = trimmed(text);
  if (hasMark(text))
    text = trimmed(text.substr(std::min(text.size(), our_mark.size() + 1)));
  if (!text.empty())
    lines.emplace_back(text);
}

void
readUnitComments(const InputFile& file, std::size_t lines_before, Remarks& remarks)
{
  TextScanner scanner(file.bytes());
  std::string_view line;
  while (scanner.nextLine(line)) {
    const bool is_blank = trimmed(line).empty();
    if (!is_blank && takeComment(line)) {
      if (!unitsIn(line).empty())
        addComment(line, remarks.comments);
    }
    else if (!is_blank && lines_before-- == 0)
      return;
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

void
writeComments(const Remarks& remarks, OutputFile& file)
{
  for (const std::string& line : asComments(remarks))
    file.text("# " + line + "\n");
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
  for (const std::string& line : asComments(remarks))
    if (const std::string_view units = unitsIn(line); !units.empty())
      return std::string(units);
  return "";
}

} // namespace app

// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: reads STL.
#include "cloud_assembler.h"
#include "polygon_builder.h"
#include "readers.h"
#include "text_scanner.h"

#include <algorithm>
#include <array>
#include <unordered_map>

namespace app {
namespace {

constexpr std::size_t header_bytes = 84;
constexpr std::size_t facet_bytes = 50;

using Corner = std::array<float, 3>;

struct CornerHash {
  std::size_t
  operator()(const Corner& corner) const
  {
    std::uint64_t hash = 0;
    for (const float value : corner) {
      std::uint32_t bits = 0;
      std::memcpy(&bits, &value, sizeof(bits));
      hash = (hash ^ bits) * 0x9E3779B97F4A7C15ULL;
      hash ^= hash >> 29;
    }
    return static_cast<std::size_t>(hash);
  }
};

/** Gives corners at the same position the same index. */
class CornerMerger {
public:
  std::int64_t
  indexOf(Corner corner)
  {
    for (float& value : corner)
      value += 0.0F; // -0 and 0 are the same place
    const auto next = static_cast<std::int64_t>(positions_.size() / 3);
    const auto [entry, is_new] = index_.try_emplace(corner, next);
    if (is_new)
      positions_.insert(positions_.end(), corner.begin(), corner.end());
    return entry->second;
  }

  const std::vector<float>&
  positions() const
  {
    return positions_;
  }

private:
  std::vector<float> positions_;
  std::unordered_map<Corner, std::int64_t, CornerHash> index_;
};

void
readBinary(const InputFile& file,
           std::size_t facets,
           CornerMerger& merger,
           Model& model)
{
  PolygonBuilder builder(model.mesh.polygons);
  model.mesh.polygons.reserve(facets);
  std::vector<std::int64_t> corners(3);
  const char* facet = file.begin() + header_bytes;
  for (std::size_t i = 0; i < facets; ++i, facet += facet_bytes) {
    for (std::size_t c = 0; c < 3; ++c) {
      const char* at = facet + 12 * (c + 1);
      corners[c] = merger.indexOf({loadScalar<float>(at, false),
                                   loadScalar<float>(at + 4, false),
                                   loadScalar<float>(at + 8, false)});
    }
    builder.addPolygon(corners);
  }
}

/** STL is written in small letters, and by some programs in capitals. */
bool
isWord(std::string_view word, std::string_view small)
{
  return std::equal(
      word.begin(), word.end(), small.begin(), small.end(), [](char a, char b) {
        return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b;
      });
}

/** Binary data has bytes among the first that no text has. */
bool
looksLikeText(const InputFile& file)
{
  const bool has_zero =
      file.bytes().substr(0, 512).find('\0') != std::string_view::npos;
  return !has_zero && isWord(TextScanner(file.bytes()).word(), "solid");
}

void
readAscii(const InputFile& file, CornerMerger& merger, Model& model)
{
  TextScanner scanner(file.bytes());
  PolygonBuilder builder(model.mesh.polygons);
  std::vector<std::int64_t> corners;
  std::string_view word = scanner.word();
  std::string_view line;
  scanner.nextLine(line); // a name of any kind
  bool is_closed = false;
  while (scanner.nextWord(word)) {
    is_closed = isWord(word, "endsolid");
    if (is_closed || isWord(word, "solid"))
      scanner.nextLine(line);
    if (isWord(word, "vertex")) {
      Corner corner{};
      for (float& value : corner)
        if (!nextNumber(scanner, value))
          throw Failure("a vertex behind its facet " +
                        std::to_string(model.mesh.polygons.size()) +
                        " is damaged or cut off");
      corners.push_back(merger.indexOf(corner));
    }
    if (isWord(word, "endloop")) {
      builder.addPolygon(corners);
      corners.clear();
    }
  }
  if (!is_closed)
    throw Failure("it has no 'endsolid' (truncated?)");
  builder.finish(model.warnings);
}

} // namespace

void
readStl(const InputFile& file, Model& model)
{
  CornerMerger merger;
  const bool is_text = looksLikeText(file);
  const bool has_header = file.size() >= header_bytes;
  const std::size_t facets =
      has_header ? loadScalar<std::uint32_t>(file.begin() + 80, false) : 0;
  // Many binary files begin with "solid", too, and some have a tail; the length tells.
  const std::size_t body = has_header ? file.size() - header_bytes : 0;
  const bool is_exact = has_header && body == facets * facet_bytes;
  const bool has_tail = !is_text && facets > 0 && body > facets * facet_bytes;
  if (is_exact || has_tail)
    readBinary(file, facets, merger, model);
  else if (is_text)
    readAscii(file, merger, model);
  else
    throw Failure("it is neither ASCII STL nor as long as the header of binary STL "
                  "announces (truncated?)");
  assembleCloud(merger.positions(), {}, model.mesh.cloud);
}

} // namespace app

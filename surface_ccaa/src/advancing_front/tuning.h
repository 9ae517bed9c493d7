// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: all constants by which the room is tuned.
#pragma once

#include <array>
#include <cstddef>

namespace pcl::ccaa::tuning {

// Numbers.

/** Of the squared radius: a point this close to a ball lies on it. */
constexpr double BALL_TOLERANCE = 1e-5;
/** Radians by which sectors between fans may overlap: with 0 spheres with noise of 0.4
 * spacings keep 6 open borders, not 3. */
constexpr double FAN_TOLERANCE = 0.1;
/** Least height of a triangle over its front edge, in lengths of the edge. */
constexpr double LEAST_HEIGHT = 1e-3;

// Which triangles the samples support.

/** Neighbors whose distance tells the spacing at a point. */
constexpr unsigned int SPACING_NEIGHBORS = 6;
/** Share of the longest edge in closed parts close by that counts as spacing: with 0
 * lordquas keeps 2 open borders, not none. */
constexpr double CLOSED_EDGE_SHARE = 0.5;
/** Ratio of spacings between neighboring samples beyond which they do not belong
 * together: outliers would tie themselves to the surface. */
constexpr double MOST_SPACING_RATIO = 5.0;
/** Smallest empty ball in circumradii beyond which a triangle covers points that lie
 * all but in its plane: without it spheres with noise of 0.4 spacings keep 4 open
 * borders, not 3. */
constexpr double LARGEST_BALL = 10.0;
/** Cosine of the angle (70 degrees) from which on a triangle is steep to the surface:
 * one between three points of a terrain's outer border passes all other tests. */
constexpr double COS_STEEP = 0.3420201433256687;
/** Thickest neighborhood (see neighborhoodThickness()) in which a surface begins: noise
 * of half a spacing stays below it, points scattered in space do not. */
constexpr double MOST_THICKNESS = 0.15;

// Which gaps are closed as a whole.

/** Edges of the longest loop: cubic cost. */
constexpr std::size_t LONGEST_LOOP = 40;
/** Largest distance from samples inside a gap that is closed, in spacings. */
constexpr double LARGEST_ROOM = 1.5;
/** The same in the square of what 95 of 100 given triangles stay below: with 1.2 the
 * gaps of random samples are closed, and no hole of Bunny, whose samples lie on grids.
 */
constexpr double LARGEST_ROOM_OF_SAMPLES = 1.2;
constexpr double ROOM_SHARE = 0.95;
/** Given triangles that tell it. */
constexpr std::size_t ROOM_TRIANGLES = 500;
/** What it is at most, in spacings: points that lie at random in a surface leave gaps
 * of 2.5 among 100 000. */
constexpr double MOST_ROOM = 2.5;
/** The same for loops of few edges: if so few triangles stand around a gap, they are as
 * wide as it is, and the sampling was no denser there. */
constexpr double LARGEST_ROOM_OF_SMALL_LOOP = 3.0;
constexpr std::size_t SMALL_LOOP = 5;

// Which points and pieces are scattered.

/** Times the usual spacing beyond which points whose neighbors fill space are. */
constexpr double SCATTERED_SPACING = 2.5;
/** Times that beyond which they are however flat they lie. */
constexpr double FAR_RATIO = 2.0;
/** Times that scattered points are looked for: 100 change one cloud of 26 that were
 * tried (table_scene_lms400). */
constexpr int SCATTER_ROUNDS = 4;

// Which given triangles are not to be trusted (decision 0005).

/** Radians of a fold, 55 degrees. */
constexpr double SHARP_FOLD = 0.9599310885968813;
/** Share of the edges up to which sharp folds are rare. */
constexpr double RARE_SHARE = 0.01;
/** Median fold of a crumpled island: more than 35 degrees, in radians, and than so
 * often that of a surface that is to be trusted: without the latter spheres with noise
 * of 0.4 spacings keep 132 open borders, not 3. */
constexpr double CRUMPLED_FOLD = 0.6108652381980153;
constexpr double CRUMPLED_RATIO = 1.5;
/** The same of a piece that grew by itself. Growth prefers smooth triangles even among
 * scattered points, so the limit is lower: 15 degrees. */
constexpr double CRUMPLED_GROWTH = 0.2617993877991494;
constexpr double CRUMPLED_GROWTH_RATIO = 3.0;
/** Largest share of a contact's length that may point out of either tangent plane. */
constexpr double LARGEST_RISE = 0.5;

// Where growth is tried again.

/** Rings tried around a group when there are few groups, and when there are many, as in
 * noise: then each is worth less and all together cost more. */
constexpr int RINGS = 4;
constexpr int RINGS_OF_MANY = 2;
constexpr std::size_t MANY_GROUPS = 200;
/** Points a group from which they are many, too: plates 1.2 spacings thick have one for
 * 40, and take four times as long with the rings of few, for the same result. */
constexpr std::size_t POINTS_OF_MANY = 80;
/** Improvements after which one of few groups is left as it is. */
constexpr int IMPROVEMENTS = 1;
/** Open points beyond which a group is left as it is: growth would take too long for
 * the little that it can win. */
constexpr std::size_t LARGEST_GROUP = 200;
/** Open points up to which both orders of growth are tried: each takes the time again.
 */
constexpr std::size_t LARGEST_TWICE = 60;
/** Cosine between normals of the two sides of a thin place: the tip of a blade. */
constexpr float OPPOSITE = -0.3f;
/** Rings of triangles around a thin place that are grown anew: the next number where
 * that took at least a third of the flaws away, and some are left. With ten first skull
 * keeps 5 handles, with four 2 or 3. */
constexpr std::array<int, 3> AROUND = {4, 10, 20};
/** Rings of triangles around a thin place that a handle may pass through to be told
 * there: with none 29 of 42 reconstructions with doubtful handles have such a place,
 * with one 35, with two or four 36. */
constexpr int AROUND_HANDLE = 2;
/** Share of points at thin places from which the second number comes first: with four
 * rings first plates 0.9 spacings thick keep 40 handles, with ten 3. */
constexpr double THIN_ALL_OVER = 0.02;
/** Work of each such try in that of the completion before: with 1 plates 0.9 spacings
 * thick keep 60 handles, with 1.5 they have 1 to 4; noise always gives in vain. */
constexpr double MOST_WORK_ANEW = 1.5;
/** The same of opening handles one by one: with 1.5 half the points of building keep 83
 * handles, not 51. */
constexpr double MOST_WORK_OF_HANDLES = 3.0;
/** Points at thin places from which so many of them are tried first: of 10 nothing can
 * be told. */
constexpr std::size_t MANY_THIN = 1000, PROBED = 250;
/** Handles left one by one beyond which, as in noisy scans, boundaries do not grow once
 * more (of four scans none is other for it, in 1.1 times the time), nor all places
 * together (of four one keeps 163, not 183, in 1.5 times the time). */
constexpr long MANY_HANDLES = 10;
/** Flaws fewer after that from which all are tried: blades and plates have 120 to 250
 * fewer, three noisy scans 80 to 160 more. */
constexpr std::size_t PROMISING = 25;

// Speed alone: no result depends on these.

/** Open points that one thread completes in the time it takes to wake others. */
constexpr std::size_t SMALL_GAP = 100;
/** Operations for a triangle that is added or a seed that is looked for. */
constexpr std::size_t GROWTH_WORK = 3000;
/** Of the given triangles one in so many tells the usual spacing, and whether they come
 * in order. */
constexpr std::size_t SPACING_STRIDE = 16;
/** Median distances of neighbors to a cell of the grid that chooses triangles. */
constexpr double CELL_FACTOR = 4.0;
/** Edges between triangles that follow each other, on the average, where they come in
 * order: of the start's there are 0.7 to 0.9. */
constexpr double MOST_BETWEEN = 2.0;

} // namespace pcl::ccaa::tuning

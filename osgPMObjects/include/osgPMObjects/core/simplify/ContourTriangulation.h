// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include <osgPMObjects/core/Triangle.h>

namespace osgPMObjects::core
{

/// Contours with more corners are refused: a candidate is tried against all sides for each triangle.
constexpr std::size_t kMostContourCorners = 128;

/// Twice the area that a triangle must have, and twice the area by which a point must lie off a line, as a share of the square
/// of the contour's size. Below, coordinates that come from a projection have no digits left to tell a triangle from a line.
constexpr double kContourFlatness = 1e-10;

/// Whether a contour encloses an area, counter-clockwise, and touches itself nowhere.
bool isSimpleContour(std::span<const glm::dvec2> contour);

/// Triangulates a contour by the step-by-step Delaunay method: the line that closes it, from the last corner to the first, is the
/// base line AB; of the corners P on its inner side that are seen from A and from B the one with the largest angle APB makes a
/// triangle, whose two new sides become base lines. Appends size - 2 triangles of corner numbers, counter-clockwise.
/// `contour`: coordinates of magnitude 2^-200 to 2^200, or zero. Errors: false, and nothing appended, when the contour is not
/// simple, has more than kMostContourCorners corners, or a base line has no such corner; of equal angles the first corner wins.
/// Cost: quadratic in the corners for a typical contour, their fourth power at worst.
/// Source: paper 004, §3 and figure 12, after Skvortsov, "Algorithms of constrained triangulation" (2002). The paper speaks of
/// all points P; we take those that the rest of the contour does not hide, so what comes out is the constrained Delaunay
/// triangulation, and no triangle leaves a concave contour.
bool triangulateContour(std::span<const glm::dvec2> contour, std::vector<Triangle>& triangles);

} // namespace osgPMObjects::core

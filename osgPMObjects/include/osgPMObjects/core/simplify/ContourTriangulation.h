// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include <osgPMObjects/core/Triangle.h>

namespace osgPMObjects::core
{

/// The most corners of a contour. Each triangle tests every candidate against all sides.
constexpr std::size_t kMostContourCorners = 128;

/// The least double area of a triangle, and of a side with a point off it, as a share of the squared size of
/// the contour. With less, projected coordinates have too few digits to tell a triangle from a line.
constexpr double kContourFlatness = 1e-10;

/// Whether a contour is counter-clockwise, encloses an area, and does not touch itself.
bool isSimpleContour(std::span<const glm::dvec2> contour);

/// Triangulates a contour by the step-by-step Delaunay method. The base line AB is first the closing side,
/// from the last corner to the first. Of the corners P on its inner side that are visible from A and B, the
/// one with the largest angle APB makes a triangle; the two new sides become base lines. Appends size - 2
/// triangles of corner numbers, counter-clockwise.
/// `contour`: coordinates of magnitude 2^-200 to 2^200, or zero. Of equal angles the first corner is taken.
/// Errors: returns false and appends nothing when the contour is not simple, has more than
/// kMostContourCorners corners, or a base line has no visible corner.
/// Cost: quadratic in the corners for a typical contour, their fourth power at worst.
/// Source: Sadykov & Zakharov, *Choosing the level of detail in continuous simplification of polygonal
/// objects* (2002), section 3, figure 12, after Skvortsov, *Algorithms of constrained triangulation* (2002).
/// Differs: the source takes all points P; we take visible ones only, so the result is the constrained
/// Delaunay triangulation and no triangle leaves a concave contour.
bool triangulateContour(std::span<const glm::dvec2> contour, std::vector<Triangle>& triangles);

} // namespace osgPMObjects::core

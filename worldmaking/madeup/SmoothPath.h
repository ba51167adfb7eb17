// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <glm/vec2.hpp>

namespace worldmaking
{

/// Turns the steps of a search on a grid into a course with wide bends: the cubic B-spline of points some 150
/// m apart, through both ends, as points kCourseStepM apart. Source: Farin, *Curves and surfaces for CAGD*,
/// 2002, ch. 8.
std::vector<glm::dvec2> smoothPath(const std::vector<glm::dvec2>& steps);

/// Rounds the corners of a course by the same spline over its own points, through both ends.
std::vector<glm::dvec2> roundedPath(const std::vector<glm::dvec2>& path);

/// The length of a line.
double lengthOf(const std::vector<glm::dvec2>& line);

/// The points of a line, a distance apart, both ends among them.
std::vector<glm::dvec2> evenPoints(const std::vector<glm::dvec2>& line, double stepM);

inline constexpr double kCourseStepM = 25.0;

} // namespace worldmaking

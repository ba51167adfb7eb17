// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>

#include <osgMultiTriangulation/core/check/SurfaceCheck.h>
#include <osgMultiTriangulation/core/follow/DrawnSurface.h>

namespace osgMultiTriangulation::core
{

/// Returns a drawn surface as a mesh on the lattice, each point once. Heights have the rounding of vertices.
SurfaceMesh latticeMeshOf(const DrawnSurface& surface, const DrawnFrame& frame);

/// Tells why a drawn surface is no triangulation within `outline` (SurfaceCheck.h), or why its cells do not
/// have each triangle once within their boxes, or nothing.
std::optional<std::string> checkDrawn(const DrawnSurface& surface, const DrawnFrame& frame,
                                      std::span<const OutlineSide> outline);

/// Returns the greatest error that an eye may see on a surface, as a share of its distance: times the pixels
/// of a unit of tangent, pixels. Frame of `eye`: that of the surface. `nearest`: distance nearer than which
/// nothing counts.
double seenErrorPerDistance(const DrawnSurface& surface, const DrawnFrame& frame, const glm::dvec3& eye,
                            double nearest);

} // namespace osgMultiTriangulation::core

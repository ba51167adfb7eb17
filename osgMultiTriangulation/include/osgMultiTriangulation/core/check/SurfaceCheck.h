// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <osgMultiTriangulation/core/surface/SurfaceMesh.h>

namespace osgMultiTriangulation::core
{

/// A straight piece of an outline, the surface on its left; both ends in the plan.
using OutlineSide = std::array<std::int32_t, 4>;

/// Returns what triangles enclose: their sides without those that two triangles share in opposite directions,
/// with straight runs of them joined; sorted. Triangulations of one area have equal outlines. A crack or a
/// T-junction adds sides.
std::vector<OutlineSide> outlineOf(const SurfaceMesh& mesh);

/// Tells why a mesh is no triangulation of the area within `outline`, or nothing. Exact: every triangle is
/// counter-clockwise and has an area, no two have the same side in the same direction, and together they have
/// that outline, which means that they cover each place inside it once.
/// `outline`: outlineOf() a triangulation, such as the root of a multi-triangulation.
std::optional<std::string> checkSurface(const SurfaceMesh& mesh, std::span<const OutlineSide> outline);

/// Tells why a mesh cannot be the input of a multi-triangulation, or nothing: points beyond the lattice,
/// heights that are no numbers, numbers of corners that do not exist, triangles without area or clockwise,
/// sides used twice. Triangles that overlap without a common side are not found.
std::optional<std::string> checkInput(const SurfaceMesh& mesh);

} // namespace osgMultiTriangulation::core

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <foundation/Result.h>

#include <osgMultiTriangulation/core/surface/PlanFrame.h>
#include <osgMultiTriangulation/core/surface/SurfaceMesh.h>

namespace osgMultiTriangulation::core
{

/// Returns what a file of triangles says of the place of its coordinates, a line each: the reference system,
/// how places in it follow, its well-known text. Empty where the frame has no reference.
std::vector<std::string> placeLines(const PlanFrame& frame);

/// Returns a surface as the text of a Wavefront OBJ file: placeLines() as comments; vertices (x east, y
/// north, z up, in the units of the plan) and triangles. Numbers are as short as they can be and read back
/// alike.
std::string objOf(const SurfaceMesh& mesh, const PlanFrame& frame);

/// Returns the same as a PLY file, binary, the lowest byte first: vertices as f64, faces as lists of i32.
/// Source: Turk, *The PLY Polygon File Format* (1994).
std::string plyOf(const SurfaceMesh& mesh, const PlanFrame& frame);

/// Writes a surface by the extension of a file: .ply, else OBJ. It appears under its name when it is
/// complete.
/// Errors: no such folder, no permission, no room.
foundation::Outcome writeTin(const std::filesystem::path& file, const SurfaceMesh& mesh,
                             const PlanFrame& frame);

} // namespace osgMultiTriangulation::core

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace osgPMObjects
{

/// Returns the text of a Wavefront .obj file with the normals that its smoothing groups ask for: `vn` lines
/// at its beginning, since OSG's loader wants them before the faces that name them. Faces of one group (`s
/// NUMBER`) are smoothed together across edges of any angle, whatever their material and object; faces of
/// different groups share no normal; faces of no group (`s off`, `s 0`, or before the first `s`) are flat.
/// Returns nothing where nothing is to be done: the file names no group, has normals of its own, or a line is
/// not of the format, which the loader then judges.
/// OSG's loader smooths faces of the same group, material and object, and those of no group like one group.
/// Cost: some 2 µs a corner. Source: Wavefront, *Advanced Visualizer* manual, appendix B1, "Object files",
/// `s`; the weights are those of core::computeNormals().
std::optional<std::string> withGroupNormals(std::string_view obj);

} // namespace osgPMObjects

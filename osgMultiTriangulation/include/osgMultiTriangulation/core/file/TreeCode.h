// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include <osgMultiTriangulation/core/structure/TreeRecord.h>

namespace osgMultiTriangulation::core
{

/// Returns the greatest power of two, 1 to 2^-20, of which all heights are multiples that fit in 30 bits; 0:
/// there is none.
double commonHeightStep(std::span<const SurfacePoint> points);

/// Returns a tree as bytes; docs/reference/mt-file.md describes them. `heightStep`: as above, of all points
/// of the file.
std::vector<std::byte> encodeTree(const TreeRecord& record, double heightStep);

/// Reads what encodeTree() wrote; nothing when the bytes are no tree. Stars follow from floors, so whatever
/// is returned keeps the invariant of MultiTriangulation.
/// `fragments`: at most so many are read; the rest is left out, and with it childRoots.
std::optional<TreeRecord> decodeTree(std::span<const std::byte> bytes, double heightStep,
                                     std::size_t fragments = std::numeric_limits<std::size_t>::max());

} // namespace osgMultiTriangulation::core

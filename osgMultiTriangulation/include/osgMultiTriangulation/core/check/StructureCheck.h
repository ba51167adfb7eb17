// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include <osgMultiTriangulation/core/structure/Forest.h>

namespace osgMultiTriangulation::core
{

/// Tells why a multi-triangulation breaks its invariant, or nothing: sizes of its lists, numbers out of
/// range, a triangle in two floors, links that do not agree, a floor that does not cover what its star
/// covers, a star that is no star.
std::optional<std::string> checkStructure(const MultiTriangulation& tree);

/// The same for all trees of a forest, and for how they hang together: the root of a tree lies in its
/// parent's drain, with the same corners, and in no other tree's root.
std::optional<std::string> checkStructure(const Forest& forest);

} // namespace osgMultiTriangulation::core

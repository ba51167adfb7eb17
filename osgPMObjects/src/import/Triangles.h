// -*- c++ -*-
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>

#include <osg/PrimitiveSet>

namespace osgPMObjects
{

/// Returns whether primitives of this mode cover areas; points, lines and patches do not.
bool isSurface(GLenum mode);

/// Calls `take` with the vertex numbers of each triangle of a primitive set, front sides counter-clockwise,
/// cut as Mesa draws them, so that renderings of warped or shaded quads do not change: quads along 1-3, quad
/// strips along 1-2, polygons as fans. Incomplete primitives at the end are not taken, and triangles of
/// strips that repeat a vertex, which join strips, neither. Of a set without an index array at most one
/// triangle beyond `vertexCount` vertices is taken: a damaged file may ask for billions. Returns false if the
/// indices are not in memory (indirect drawing).
bool forEachTriangle(const osg::PrimitiveSet& set, unsigned vertexCount,
                     const std::function<void(const std::array<unsigned, 3>&)>& take);

} // namespace osgPMObjects

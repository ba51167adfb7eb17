// -*- c++ -*-
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>

#include <osg/PrimitiveSet>

namespace osgPMObjects
{

/// Whether primitives of this mode cover areas; points, lines and patches do not.
bool isSurface(GLenum mode);

/// Calls `take` with the vertex numbers of each triangle of a primitive set, fronts counter-clockwise, cut as Mesa draws them,
/// so that pictures of warped or shaded quads stay: quads along 1-3, quad strips along 1-2, polygons as fans. Incomplete primitives at the end are not drawn, so not
/// taken. Triangles of strips that repeat a vertex, which join strips, are left out. Of a set without an index array at most
/// one triangle is taken that goes beyond `vertexCount` vertices: a damaged file may ask for billions.
/// Returns false where the indices are not in memory (indirect drawing).
bool forEachTriangle(const osg::PrimitiveSet& set, unsigned vertexCount,
                     const std::function<void(const std::array<unsigned, 3>&)>& take);

} // namespace osgPMObjects

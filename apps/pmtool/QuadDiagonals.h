// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include <osg/Node>
#include <osg/ref_ptr>
#include <osgDB/Options>

#include <osgPMObjects/core/tessellate/QuadDiagonal.h>

namespace pmtool
{

/// What cutQuads() did.
struct QuadCounts
{
    std::size_t cut = 0;    ///< quads that were cut as the rule says
    std::size_t turned = 0; ///< of these, the ones that OpenGL would cut along the other diagonal
    std::size_t left = 0; ///< quads without a diagonal inside (crossed, or without area), cut as OpenGL does
};

/// Cuts the quads of every osg::Geometry below a node into triangles: GL_QUADS, GL_QUAD_STRIP, and polygons
/// and fans of four corners. The rule sees them in the root's frame; a geometry with several parents is cut
/// as below the first one. Other primitives stay, and so do sets with an index beyond the vertices.
QuadCounts cutQuads(osg::Node& root, osgPMObjects::core::DiagonalRule rule);

/// Makes OpenSceneGraph's .obj reader keep quads, as long as this object lives; otherwise that reader cuts
/// them itself.
class KeptQuads
{
public:
    KeptQuads();
    ~KeptQuads();
    KeptQuads(const KeptQuads&) = delete;
    KeptQuads& operator=(const KeptQuads&) = delete;

private:
    osg::ref_ptr<osgDB::Options> _before;
};

} // namespace pmtool

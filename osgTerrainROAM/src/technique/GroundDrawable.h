// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <mutex>

#include <osg/Drawable>

#include "../view/ClippedTriangles.h"
#include "TileGround.h"

namespace osgTerrainROAM
{

/// The true ground of a tile for intersections: two triangles for each cell, without the cells that touch a
/// void. It is never drawn. The triangles are made on first use, 36 B a sample; where osgDB's registry builds
/// KdTrees, at once and with a KdTree.
/// Frame: the tile's. Threads: any.
class GroundDrawable : public osg::Drawable
{
public:
    explicit GroundDrawable(const TileGround& ground);

    osg::BoundingBox computeBoundingBox() const override;
    using osg::Drawable::accept;
    bool supports(const osg::PrimitiveFunctor&) const override { return true; }
    void accept(osg::PrimitiveFunctor& functor) const override { triangles().accept(functor); }

protected:
    ~GroundDrawable() override = default;

private:
    const ClippedTriangles& triangles() const;
    void buildKdTree();

    std::shared_ptr<const core::RoamTile> _tile;
    std::shared_ptr<const ElevationSamples> _samples;
    mutable std::once_flag _made;
    mutable ClippedTriangles _triangles;
};

} // namespace osgTerrainROAM

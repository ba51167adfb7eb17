// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Drawable>

#include <osgPMObjects/ProgressiveShape>

#include "MorphArrays.h"

namespace osgPMObjects
{

/// A drawable that cull puts into the render graph: the faces of one material at some level. It never
/// changes, so a frame may be culled while the frame before is drawn.
class GroupPart : public osg::Drawable
{
public:
    /// `morph`: null if vertices do not move.
    GroupPart(osg::ref_ptr<const ProgressiveShape> shape, std::uint32_t group, MorphArraysPtr morph);

    std::uint32_t group() const { return _group; }

    void drawImplementation(osg::RenderInfo& renderInfo) const override;
    osg::BoundingBox computeBoundingBox() const override;

    using osg::Drawable::accept;
    bool supports(const osg::PrimitiveFunctor&) const override { return true; }
    bool supports(const osg::PrimitiveIndexFunctor&) const override { return true; }

protected:
    ~GroupPart() override = default;

    /// Draws the faces from the vertex arrays that are set.
    virtual void drawFaces(osg::State& state) const = 0;

    const ProgressiveShape& shape() const { return *_shape; }

private:
    osg::ref_ptr<const ProgressiveShape> _shape;
    std::uint32_t _group;
    MorphArraysPtr _morph;
};

} // namespace osgPMObjects

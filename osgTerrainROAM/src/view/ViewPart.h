// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <osg/Drawable>

#include "ViewGroup.h"

namespace osgTerrainROAM
{

/// The drawable that one cull traversal puts into the render graph: the part of a group's mesh that one camera sees in one
/// frame. Each traversal makes a new one, which never changes, so a frame may be culled while the last is drawn.
class ViewPart : public osg::Drawable
{
public:
    ViewPart(std::shared_ptr<ViewGroup> group, ViewAnswer answer, const viewlod::Frustum& frustum,
             const osg::BoundingBox& bounds);

    void drawImplementation(osg::RenderInfo& renderInfo) const override;
    osg::BoundingBox computeBoundingBox() const override { return _bounds; }

    using osg::Drawable::accept;
    bool supports(const osg::PrimitiveFunctor&) const override { return true; }
    /// The triangles of the ranges, clipped at the data's edge.
    void accept(osg::PrimitiveFunctor& functor) const override;

protected:
    ~ViewPart() override = default;

private:
    std::shared_ptr<ViewGroup> _group;
    ViewAnswer _answer;
    viewlod::Frustum _frustum;
    osg::BoundingBox _bounds;
};

} // namespace osgTerrainROAM

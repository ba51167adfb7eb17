// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <osgTraversal/CulledPart>

#include "ViewGroup.h"

namespace osgTerrainROAM
{

/// The part of a group's mesh that one camera sees in one frame.
class ViewPart : public osgTraversal::CulledPart
{
public:
    ViewPart(std::shared_ptr<ViewGroup> group, ViewAnswer answer, const viewlod::Frustum& frustum,
             const osg::BoundingBox& bounds);

    void drawImplementation(osg::RenderInfo& renderInfo) const override;

    using CulledPart::accept;
    /// The triangles of the ranges, clipped at the data's edge.
    void accept(osg::PrimitiveFunctor& functor) const override;

protected:
    ~ViewPart() override = default;

private:
    std::shared_ptr<ViewGroup> _group;
    ViewAnswer _answer;
    viewlod::Frustum _frustum;
};

} // namespace osgTerrainROAM

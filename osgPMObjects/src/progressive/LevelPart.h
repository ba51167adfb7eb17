// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <osg/Drawable>

#include "ViewLevel.h"

namespace osgPMObjects
{

/// What cull traversals put into the render graph: the faces of one material at one level. A fresh one is made when the level
/// changes, and none is ever changed, so a frame may be culled while the last is drawn.
class LevelPart : public osg::Drawable
{
public:
    LevelPart(std::shared_ptr<ViewLevel> level, DrawnLevelPtr drawn, std::uint32_t group);

    std::uint32_t group() const { return _group; }

    void drawImplementation(osg::RenderInfo& renderInfo) const override;
    osg::BoundingBox computeBoundingBox() const override;

    using osg::Drawable::accept;
    bool supports(const osg::PrimitiveFunctor&) const override { return true; }
    /// The faces that the view group has by then.
    void accept(osg::PrimitiveFunctor& functor) const override;
    bool supports(const osg::PrimitiveIndexFunctor&) const override { return true; }
    void accept(osg::PrimitiveIndexFunctor& functor) const override;

protected:
    ~LevelPart() override = default;

private:
    std::shared_ptr<ViewLevel> _level;
    DrawnLevelPtr _drawn;
    std::uint32_t _group;
};

/// Gives a functor the faces of one group, or of all.
void showFaces(const ViewLevel& level, std::optional<std::uint32_t> group, osg::PrimitiveFunctor& functor);
void showFaces(const ViewLevel& level, std::optional<std::uint32_t> group,
               osg::PrimitiveIndexFunctor& functor);

} // namespace osgPMObjects

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "GroupPart.h"
#include "ViewLevel.h"

namespace osgPMObjects
{

/// The faces that a group has in the index buffer of a view group. A fresh one is made when the level changes.
class LevelPart : public GroupPart
{
public:
    LevelPart(std::shared_ptr<ViewLevel> level, DrawnLevelPtr drawn, std::uint32_t group,
              MorphArraysPtr morph = nullptr);

    using GroupPart::accept;
    /// The faces that the view group has by then.
    void accept(osg::PrimitiveFunctor& functor) const override;
    void accept(osg::PrimitiveIndexFunctor& functor) const override;

protected:
    ~LevelPart() override = default;

private:
    void drawFaces(osg::State& state) const override;

    std::shared_ptr<ViewLevel> _level;
    DrawnLevelPtr _drawn;
};

/// Gives a functor the faces of one group, or of all.
void showFaces(const ViewLevel& level, std::optional<std::uint32_t> group, osg::PrimitiveFunctor& functor);
void showFaces(const ViewLevel& level, std::optional<std::uint32_t> group,
               osg::PrimitiveIndexFunctor& functor);

} // namespace osgPMObjects

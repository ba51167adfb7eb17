// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "GroupPart.h"
#include "ViewLevel.h"

namespace osgPMObjects
{

/// The faces of one group in the index buffer of a view group. A new part is made when the level changes.
class LevelPart : public GroupPart
{
public:
    LevelPart(std::shared_ptr<ViewLevel> level, DrawnLevelPtr drawn, std::uint32_t group,
              MorphArraysPtr morph = nullptr);

    using GroupPart::accept;
    /// Shows the faces that the view group has when it is called.
    void accept(osg::PrimitiveFunctor& functor) const override;
    void accept(osg::PrimitiveIndexFunctor& functor) const override;

protected:
    ~LevelPart() override = default;

private:
    void drawFaces(osg::State& state) const override;

    std::shared_ptr<ViewLevel> _level;
    DrawnLevelPtr _drawn;
};

/// Passes the faces of one group, or of all groups, to a functor.
void showFaces(const ViewLevel& level, std::optional<std::uint32_t> group, osg::PrimitiveFunctor& functor);
void showFaces(const ViewLevel& level, std::optional<std::uint32_t> group,
               osg::PrimitiveIndexFunctor& functor);

} // namespace osgPMObjects

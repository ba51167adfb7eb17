// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <osgPMObjects/core/selection/Switch.h>

#include "LevelPart.h"
#include "StillLevel.h"

namespace osgPMObjects
{

/// What draws the levels of one view group of an object: its index buffer and, only while it switches, a copy
/// of the other level of a blend or the targets of a morph.
class GroupLevels
{
public:
    using Parts = StillLevel::Parts;

    explicit GroupLevels(osg::ref_ptr<const ProgressiveShape> shape)
        : _level(std::make_shared<ViewLevel>(std::move(shape)))
    {
    }

    /// Makes the levels. `contextId`: as for ViewLevel::at().
    void make(const core::DrawnLevels& drawn, unsigned int frame, std::optional<unsigned int> contextId);

    /// Returns the parts of a level that has been made; the same parts as long as nothing changes.
    const Parts& partsOf(std::uint32_t steps) const;

    bool isMade() const { return _drawn != nullptr; }
    const std::shared_ptr<ViewLevel>& level() const { return _level; }
    const MorphArrays* morph() const { return _morph.get(); } ///< null: no morph
    const StillLevel* still() const { return _still.get(); }  ///< null: only one level is drawn

    void releaseGLObjects(osg::State* state);

private:
    void makeLevel(std::uint32_t steps, unsigned int frame, std::optional<unsigned int> contextId);
    void makeStill(const core::DrawnLevels& drawn, unsigned int frame, std::optional<unsigned int> contextId);
    void makeMorph(const core::DrawnLevels& drawn);

    std::shared_ptr<ViewLevel> _level;
    DrawnLevelPtr _drawn;
    MorphArraysPtr _morph, _partsMorph;
    Parts _parts; ///< of `_drawn`, with `_partsMorph`
    std::shared_ptr<const StillLevel> _still;
};

} // namespace osgPMObjects

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <mutex>

#include <osgPMObjects/ProgressiveDrawable>

#include "EyeGroups.h"
#include "GroupSwitch.h"
#include "ShownLevels.h"

namespace osgPMObjects
{

/// Chooses a level for a view; `held` is the state of the camera's last choice.
using LevelChoice = std::function<core::Selection(const CullView& view, core::HeldLevel& held)>;

/// The view groups of one drawable. Cameras whose eyes coincide share the finest level that one of them
/// needs. Threads: any.
class ViewLevelTable
{
public:
    explicit ViewLevelTable(osg::ref_ptr<const ProgressiveShape> shape) : _shape(shape) {}

    /// Returns what to draw for a view; no levels if the object has faded away.
    ShownLevels find(const CullView& view, const LevelChoice& choice,
                     const ProgressiveDrawable::Switching& switching);

    /// Returns the level of the group that asked last, or, before any, one at `steps` that belongs to no
    /// group.
    std::shared_ptr<ViewLevel> latest(std::uint32_t steps);
    std::vector<ProgressiveViewStatistics> statistics() const;
    void releaseGLObjects(osg::State* state);

private:
    struct PerCamera
    {
        core::HeldLevel held;
        core::Selection selection;
    };
    struct Group
    {
        explicit Group(const osg::ref_ptr<const ProgressiveShape>& shape) : levels(shape) {}

        GroupLevels levels;
        GroupSwitch switching;
        core::DrawnLevels drawn; ///< without the alpha range
        bool byDoor = false;
        core::Selection latest;
    };
    using Groups = EyeGroups<Group, PerCamera>;

    static std::uint32_t finestSteps(const Groups::Entry& entry);
    static ShownLevels shownOf(Groups::Entry& entry, float alpha, const CullView& view);

    osg::ref_ptr<const ProgressiveShape> _shape;
    mutable std::mutex _mutex;
    Groups _groups;
    std::shared_ptr<ViewLevel> _latest;
};

} // namespace osgPMObjects

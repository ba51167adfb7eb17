// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <mutex>

#include <osg/observer_ptr>

#include <osgPMObjects/ProgressiveDrawable>

#include "CullView.h"
#include "GroupSwitch.h"
#include "ShownLevels.h"

namespace osgPMObjects
{

/// Chooses a level for a view; `held` is what the camera's last choice left.
using LevelChoice = std::function<core::Selection(const CullView& view, core::HeldLevel& held)>;

/// The view groups of one drawable, found by eye and camera. Cameras whose eyes coincide share one, and the finest level that
/// they ask for; a camera that moves takes its group along. One camera may see the drawable at several places in a frame
/// (below several transforms): each is an eye of its own.
/// A group that nobody has asked for during kUnusedFrames frames, or whose cameras are gone, is dropped.
/// Threads: any.
class ViewLevelTable
{
public:
    static constexpr unsigned int kUnusedFrames = 30;
    /// Eyes of channels differ by the rounding of their matrices. Of their distance.
    static constexpr double kSameEye = 1e-6;

    explicit ViewLevelTable(osg::ref_ptr<const ProgressiveShape> shape) : _shape(std::move(shape)) {}

    /// What to draw for a view; nothing of an object that has faded away.
    ShownLevels find(const CullView& view, const LevelChoice& choice,
                     const ProgressiveDrawable::Switching& switching);

    /// The group asked for last; before any, one at `steps` for nobody in particular.
    std::shared_ptr<ViewLevel> latest(std::uint32_t steps);
    std::vector<ProgressiveViewStatistics> statistics() const;
    void releaseGLObjects(osg::State* state);

private:
    struct Member
    {
        osg::Camera* identity = nullptr; ///< compared only
        osg::observer_ptr<osg::Camera> camera;
        unsigned int frame = 0; ///< last asked in
        core::HeldLevel held;
        core::Selection selection;
    };
    struct Entry
    {
        explicit Entry(const osg::ref_ptr<const ProgressiveShape>& shape) : levels(shape) {}

        GroupLevels levels;
        GroupSwitch switching;
        core::DrawnLevels drawn; ///< regardless of the alpha range
        bool byDoor = false;
        glm::dvec3 eye{0.0};
        unsigned int frame = 0;
        std::vector<Member> members;
        core::Selection latest;

        Member* memberOf(const osg::Camera* camera);
        std::uint32_t finestSteps() const;
    };

    Entry* borrowedEntry(const CullView& view);
    Entry& entryFor(const CullView& view);
    void dropUnused(unsigned int frame);
    static ShownLevels shownOf(Entry& entry, float alpha, const CullView& view);

    osg::ref_ptr<const ProgressiveShape> _shape;
    mutable std::mutex _mutex;
    std::vector<Entry> _entries;
    std::shared_ptr<ViewLevel> _latest;
};

} // namespace osgPMObjects

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include <osgMultiTriangulation/core/follow/SurfaceFollower.h>

#include <osgMultiTriangulation/MtDrawable>
#include <osgTraversal/EyeGroups>

#include "MtBuffers.h"

namespace osgMultiTriangulation
{

/// What a camera draws in one frame.
struct MtAnswer
{
    std::shared_ptr<const core::DrawnSurface> surface;
    std::shared_ptr<MtBuffers> buffers;
};

/// The view groups of one drawable, by the rules of osgTraversal/EyeSharing.
/// Threads: any.
class MtViewTable
{
public:
    /// `reachM`: how far the surface reaches from its origin.
    MtViewTable(std::shared_ptr<core::SurfaceFollower> follower, double reachM)
        : _follower(std::move(follower)), _groups(reachM)
    {
    }
    ~MtViewTable();

    /// Returns the surface of the camera's group, which is the same for all its cameras in one frame.
    MtAnswer answer(const osgTraversal::EyeRequest& request, bool waits);

    /// The surface that was answered last; null: none yet.
    std::shared_ptr<const core::DrawnSurface> latest() const;
    std::vector<MtViewStatistics> statistics() const;
    void releaseGLObjects(osg::State* state);

private:
    struct Detail
    {
        std::size_t view = 0;                              ///< of the follower
        std::shared_ptr<const core::DrawnSurface> surface; ///< of the group's frame
        std::shared_ptr<MtBuffers> buffers;
        double stallUs = 0.0;
    };
    using Groups = osgTraversal::EyeGroups<Detail>;

    static core::FollowTarget targetOf(const Groups::Group& group);

    std::shared_ptr<core::SurfaceFollower> _follower;
    mutable std::mutex _mutex;
    Groups _groups;
    std::shared_ptr<const core::DrawnSurface> _latest;
};

} // namespace osgMultiTriangulation

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include <osg/Camera>
#include <osg/observer_ptr>

#include <osgMultiTriangulation/core/follow/SurfaceFollower.h>

#include <osgMultiTriangulation/MtDrawable>

#include "MtBuffers.h"

namespace osgMultiTriangulation
{

/// The request of one camera in one frame.
struct MtRequest
{
    osg::Camera* camera = nullptr;
    const osg::Camera* mainCamera =
        nullptr; ///< whose surface a shadow or reflection camera uses, once there is one
    unsigned int frame = 0;
    core::FollowTarget target;
};

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
        : _follower(std::move(follower)), _reachM(reachM)
    {
    }
    ~MtViewTable();

    /// Returns the surface of the camera's group, which is the same for all its cameras in one frame.
    MtAnswer answer(const MtRequest& request, bool waits);

    /// The surface that was answered last; null: none yet.
    std::shared_ptr<const core::DrawnSurface> latest() const;
    std::vector<MtViewStatistics> statistics() const;
    void releaseGLObjects(osg::State* state);

private:
    struct Member
    {
        osg::Camera* identity; ///< compared only
        osg::observer_ptr<osg::Camera> camera;
        core::FollowTarget target; ///< as last asked
    };
    struct Group
    {
        std::size_t view = 0; ///< of the follower
        glm::dvec3 eye{0.0};
        unsigned int frame = 0; ///< last asked in, by a camera of its own
        std::vector<Member> members;
        std::shared_ptr<const core::DrawnSurface> surface; ///< of that frame
        bool hasMoved = false;                             ///< since it was taken
        std::shared_ptr<MtBuffers> buffers;
        double stallUs = 0.0;

        bool has(const osg::Camera* camera) const;
    };

    Group* groupOf(const osg::Camera* camera);
    Group& groupFor(const MtRequest& request);
    void dropUnused(unsigned int frame);
    static core::FollowTarget strictest(const Group& group);

    std::shared_ptr<core::SurfaceFollower> _follower;
    double _reachM;
    mutable std::mutex _mutex;
    std::vector<std::unique_ptr<Group>> _groups;
    std::shared_ptr<const core::DrawnSurface> _latest;
};

} // namespace osgMultiTriangulation

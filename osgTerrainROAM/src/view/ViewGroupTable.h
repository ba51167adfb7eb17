// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include <osg/Camera>
#include <osg/observer_ptr>

#include <osgTerrainROAM/core/roam/PreparedTerrain.h>

#include "ViewGroup.h"

namespace osgTerrainROAM
{

/// The request of one camera in one frame.
struct ViewRequest
{
    osg::Camera* camera = nullptr;
    const osg::Camera* mainCamera =
        nullptr; ///< of a shadow or reflection camera: whose mesh it uses, once there is one
    unsigned int frame = 0;
    RefineTarget target;
};

/// The view groups of one drawable, found by eye and camera.
/// Cameras whose eyes coincide share a group; a camera that moves away from its group leaves it; a group that
/// no camera has asked for lately (osgTraversal::isUnused), or whose cameras are gone, is dropped.
/// Threads: any.
class ViewGroupTable
{
public:
    /// Without `terrain`, find() must not be called.
    explicit ViewGroupTable(core::PreparedPtr terrain);

    /// The group for a request, and the target with the strictest scale among the group's cameras and what
    /// all of them see.
    struct Match
    {
        std::shared_ptr<ViewGroup> group;
        RefineTarget target;
        bool borrowed; ///< another camera's: to be used as it is
    };
    Match find(const ViewRequest& request);

    /// The group that was asked for last; before the first request, one refined to `defaultErrorM` for no
    /// camera.
    std::shared_ptr<ViewGroup> latest(double defaultErrorM);
    std::vector<ViewGroupStatistics> statistics() const;
    void releaseGLObjects(osg::State* state);

private:
    struct Member
    {
        osg::Camera* identity; ///< compared only
        osg::observer_ptr<osg::Camera> camera;
        RefineTarget target; ///< as last asked
    };
    struct Entry
    {
        std::shared_ptr<ViewGroup> group;
        glm::dvec3 eye{0.0};
        unsigned int frame = 0; ///< last asked in, by a camera of its own
        std::vector<Member> members;

        Member* memberOf(const osg::Camera* camera);
    };

    std::shared_ptr<ViewGroup> newGroup() const;
    Entry& entryFor(const ViewRequest& request);
    Entry* entryOf(const osg::Camera* camera);
    void leave(const osg::Camera* camera, const Entry* except);
    void dropUnused(unsigned int frame);
    static RefineTarget strictest(const Entry& entry);

    core::PreparedPtr _terrain;
    double _reachM = 0.0; ///< of the tile from its origin
    mutable std::mutex _mutex;
    std::vector<Entry> _entries;
    std::shared_ptr<ViewGroup> _latest;
};

} // namespace osgTerrainROAM

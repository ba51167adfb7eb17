// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include <osg/Geometry>

#include <osgTerrainROAM/core/bisection/BisectionModel.h>

#include <osgTerrainROAM/BisectionDrawable>
#include <osgTraversal/EyeGroups>

namespace osgTerrainROAM
{

/// The view groups of one drawable. Threads: any; one at a time.
class BisectionViewTable
{
public:
    /// `reach`: how far the surface reaches from its origin. The model must stay.
    BisectionViewTable(const core::BisectionModel& model, double reach) : _model(model), _groups(reach) {}

    /// Returns what the camera's group draws, which is the same for all its cameras in one frame.
    osg::ref_ptr<osg::Geometry> answer(const osgTraversal::EyeRequest& request);

    /// What was answered last; null: nothing yet.
    osg::ref_ptr<osg::Geometry> latest() const;
    std::vector<BisectionViewStatistics> statistics() const;
    void releaseGLObjects(osg::State* state);

private:
    struct Detail
    {
        std::unique_ptr<core::BisectionMesh> mesh;
        osg::ref_ptr<osg::Geometry> geometry;
        core::BisectionChanges changes{};
    };

    void refine(osgTraversal::EyeGroups<Detail>::Group& group);

    const core::BisectionModel& _model;
    mutable std::mutex _mutex;
    osgTraversal::EyeGroups<Detail> _groups;
    osg::ref_ptr<osg::Geometry> _latest;
};

/// Makes the triangles of a mesh drawable: with a normal for each vertex, the mean of those of its triangles
/// by area, and TINs in another colour.
osg::ref_ptr<osg::Geometry> geometryOf(const core::BisectionMesh& mesh);

} // namespace osgTerrainROAM

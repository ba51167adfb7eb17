// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <vector>

#include <foundation/Heights.h>

#include <osg/Geometry>
#include <osg/MatrixTransform>

#include "scenery/nodes/SkyShadePatches.h"

namespace scenery
{

/// Darkens the ground around the eye where trees, parked vehicles and walls hide the sky, up to kReachM:
/// patches on the ground, which take away light of the sky and none of the sun. What moves has a patch of its
/// own (ContactShadow.h).
/// Frame: the scene's. Threads: the update phase.
class SkyShadeNode
{
public:
    static constexpr double kReachM = 80.0; ///< they fade out over its last two fifths

    SkyShadeNode(SkyOccluders occluders, foundation::HeightInPlan ground);

    osg::Node* node() const { return _placed.get(); }

    /// Shows it or not, from the next follow() on.
    void setShown(bool isShown);

    /// Brings the patches around the eye when it has come into another cell of 16 m. Cost: some milliseconds
    /// then; 10 ms for each half a million occluders where the eye has moved on by a kilometre.
    void follow(const glm::dvec3& eye);

    std::size_t patchCount() const { return _patches.size(); }

private:
    using Cell = std::pair<int, int>;

    const SkyShadePatch& patchOf(std::size_t occluder);
    void gather(const glm::dvec3& eye);

    SkyOccluders _occluders;
    foundation::HeightInPlan _ground;
    std::map<Cell, std::vector<std::size_t>> _inCell; ///< bodies, then walls by their middle, near _sortedAt
    std::optional<glm::dvec2> _sortedAt;
    std::map<std::size_t, SkyShadePatch> _patches; ///< of what is near
    std::optional<Cell> _eye;
    bool _isShown = true;
    osg::ref_ptr<osg::Geometry> _geometry;
    osg::ref_ptr<osg::MatrixTransform> _placed;
};

/// The program of the patches.
osg::ref_ptr<osg::Program> makeSkyShadeProgram();

} // namespace scenery

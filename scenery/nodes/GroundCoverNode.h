// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <map>
#include <utility>

#include <osg/Group>

#include <osgPMObjects/ProgressiveField>
#include <osgTerrainROAM/TerrainMaterial>

#include "scenery/placement/GroundCover.h"

namespace scenery
{

/// Grass, herbs, stones and twigs around the eye as one ProgressiveField, up to 80 m. They fade out at
/// distances of their own, so that they have no edge; they cast no shadow into maps, which would cost more
/// than they do, and receive it. Colours follow the ground's palette. Frame: the scene's. Threads: the update
/// phase.
class GroundCoverNode
{
public:
    /// `material`: of the ground that they stand on.
    GroundCoverNode(CoverQuery query, const osgTerrainROAM::TerrainMaterial& material);

    const osg::ref_ptr<osg::Group>& node() const { return _root; }

    /// How far it reaches: a number of kCoverReachesM; 0: there is none. From the next follow() on.
    void setReaches(int reaches);

    /// Brings what stands around the eye, when it has come into another cell. Cost: some 10 ms then, a tenth
    /// of a second at first.
    void follow(const glm::dvec3& eye);

    std::size_t count() const { return _field->instanceCount(); }

private:
    struct Cell
    {
        std::uint8_t leastReach = 0;
        std::vector<CoverThing> things;
    };

    void plant(glm::ivec2 middle);

    CoverQuery _query;
    osg::ref_ptr<osg::Group> _root;
    osg::ref_ptr<osgPMObjects::ProgressiveField> _field;
    std::vector<osgPMObjects::FieldKind> _kinds; ///< by shape and reach
    std::map<std::pair<int, int>, Cell> _cells;
    std::optional<glm::ivec2> _middle; ///< the cell of the eye
    bool _isHigh = false;              ///< above the last ground that was known
    int _reaches = static_cast<int>(kCoverReachesM.size());
};

} // namespace scenery

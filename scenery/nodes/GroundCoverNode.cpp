// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/GroundCoverNode.h"

#include <cmath>

#include <glm/geometric.hpp>

#include <osgSky/SunShadows>

#include "scenery/nodes/CoverModels.h"

namespace scenery
{

namespace
{

constexpr double kHighestM = 60.0; ///< of an eye above the ground that sees blades

glm::ivec2 cellAt(glm::dvec2 place)
{
    return glm::ivec2(glm::floor(place / kCoverCellM));
}

osgPMObjects::FieldKind kindOf(const osg::ref_ptr<const osgPMObjects::ProgressiveShape>& shape, double reachM)
{
    osgPMObjects::FieldKind kind{shape};
    kind.selection.alpha = {0.6 * reachM, reachM};
    kind.switching = {osgPMObjects::core::SwitchMethod::blend, osgPMObjects::core::BlendProfile::cross};
    return kind;
}

} // namespace

GroundCoverNode::GroundCoverNode(CoverQuery query, const osgTerrainROAM::TerrainMaterial& material)
    : _query(std::move(query)), _root(new osg::Group), _field(new osgPMObjects::ProgressiveField)
{
    _root->setName("ground cover");
    _root->setNodeMask(osgSky::SunShadows::kCastsNone);
    _root->addChild(_field);
    for (const auto& shape : coverModels(material))
        for (const double reachM : kCoverReachesM)
            _kinds.push_back(kindOf(shape, reachM));
}

void GroundCoverNode::setReaches(int reaches)
{
    if (reaches == _reaches) return;
    _reaches = reaches;
    _cells.clear();
    _middle.reset();
}

void GroundCoverNode::follow(const glm::dvec3& eye)
{
    const glm::ivec2 middle = cellAt(glm::dvec2(eye));
    if (_middle == middle) return;
    _middle = middle;
    if (const auto below = _query(glm::dvec2(eye))) _isHigh = eye.z - below->heightM > kHighestM;
    if (!_isHigh && _reaches > 0) return plant(middle);
    _cells.clear();
    (void)_field->setContents({}, {}); // nothing is valid
}

void GroundCoverNode::plant(glm::ivec2 middle)
{
    const double farM = kCoverReachesM[static_cast<std::size_t>(_reaches - 1)];
    const int around = static_cast<int>(std::ceil(farM / kCoverCellM)) + 1;
    std::map<std::pair<int, int>, Cell> cells;
    std::vector<osgPMObjects::FieldInstance> instances;
    for (int y = -around; y <= around; ++y)
        for (int x = -around; x <= around; ++x)
        {
            // From anywhere in the middle cell to the nearest point of this one.
            const double nearM =
                kCoverCellM * std::hypot(std::max(std::abs(x) - 1, 0), std::max(std::abs(y) - 1, 0));
            if (nearM >= farM) continue;
            const glm::ivec2 at = middle + glm::ivec2(x, y);
            std::uint8_t least = 0;
            while (kCoverReachesM[least] <= nearM)
                ++least;
            Cell& cell = cells[{at.x, at.y}];
            const auto known = _cells.find({at.x, at.y});
            if (known != _cells.end() && known->second.leastReach <= least)
                cell = std::move(known->second);
            else
                cell = {least, coverOf(at, least, _query)};
            for (const CoverThing& thing : cell.things)
            {
                if (thing.reach < least || thing.reach >= _reaches) continue;
                osgPMObjects::FieldInstance& instance = instances.emplace_back();
                instance.position.set(thing.position.x, thing.position.y, thing.position.z);
                instance.attitude = osg::Quat(thing.headingRad, osg::Vec3d(0.0, 0.0, 1.0));
                instance.scale = thing.scale;
                instance.kind = static_cast<std::uint32_t>(thing.shape) * kCoverReachesM.size() + thing.reach;
            }
        }
    _cells = std::move(cells);
    (void)_field->setContents(_kinds, std::move(instances)); // kinds with shapes and valid settings
}

} // namespace scenery

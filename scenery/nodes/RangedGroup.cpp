// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/RangedGroup.h"

#include <osgUtil/CullVisitor>

#include <osgTraversal/CullFacts>
#include <osgTraversal/EyeSharing>

namespace scenery
{

RangedGroup::RangedGroup(double farM)
    : _ranges(osgPMObjects::core::OverlappingRanges::around({{farM}, {0, 1}}))
{
}

bool RangedGroup::isShown(osgUtil::CullVisitor& visitor)
{
    const double distanceM = visitor.getDistanceToViewPoint(getBound().center(), true);
    const unsigned int frame = osgTraversal::frameOf(visitor);
    const osg::Camera* const main = osgTraversal::mainCameraOf(visitor);
    const std::lock_guard<std::mutex> lock(_mutex);
    const auto found = _held.find(main ? main : visitor.getCurrentCamera());
    const auto before = found == _held.end() ? osgPMObjects::core::HeldLevel() : found->second.level;
    const std::uint32_t row = osgPMObjects::core::overlappingRangeAt(_ranges, distanceM, before);
    if (main) return row == 0;
    std::erase_if(_held, [=](const auto& one) { return osgTraversal::isUnused(one.second.frame, frame); });
    _held[visitor.getCurrentCamera()] = {{row}, frame};
    return row == 0;
}

void RangedGroup::traverse(osg::NodeVisitor& visitor)
{
    osgUtil::CullVisitor* const cull = visitor.asCullVisitor();
    if (!cull || isShown(*cull)) osg::Group::traverse(visitor);
}

} // namespace scenery

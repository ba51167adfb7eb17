// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <mutex>

#include <osg/Camera>
#include <osg/Group>

#include <osgPMObjects/core/selection/OverlappingRanges.h>

namespace scenery
{

/// A group that is drawn up to a distance from the middle of its bound. The ranges "drawn" and "not drawn"
/// overlap, so an eye that lingers at the boundary does not let it flicker: each camera remembers what it
/// showed last. Cameras of shadow maps show what their main camera does.
/// Source: Sadykov & Zakharov, *Choosing the level of detail in continuous simplification of polygonal
/// objects* (2002), section 2.3.2.
/// Threads: several cull traversals at a time.
class RangedGroup : public osg::Group
{
public:
    RangedGroup() : RangedGroup(1e9) {}

    /// `farM`: the middle of the overlap.
    explicit RangedGroup(double farM);

    RangedGroup(const RangedGroup& other, const osg::CopyOp& copyOp = osg::CopyOp::SHALLOW_COPY)
        : osg::Group(other, copyOp), _ranges(other._ranges)
    {
    }

    META_Node(scenery, RangedGroup)

    void traverse(osg::NodeVisitor& visitor) override;

    const osgPMObjects::core::OverlappingRanges& ranges() const { return _ranges; }

protected:
    ~RangedGroup() override = default;

private:
    struct Held
    {
        osgPMObjects::core::HeldLevel level;
        unsigned int frame = 0;
    };
    bool isShown(osgUtil::CullVisitor& visitor);

    osgPMObjects::core::OverlappingRanges _ranges; ///< row 0: drawn
    std::mutex _mutex;
    std::map<const osg::Camera*, Held> _held;
};

} // namespace scenery

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <osg/PrimitiveSet>

#include "GroupPart.h"
#include "ViewLevel.h"

namespace osgPMObjects
{

/// The faces that a group had when they were copied.
class StillPart : public GroupPart
{
public:
    StillPart(osg::ref_ptr<const ProgressiveShape> shape, std::uint32_t group,
              osg::ref_ptr<const osg::DrawElements> faces);

    using GroupPart::accept;
    void accept(osg::PrimitiveFunctor& functor) const override;
    void accept(osg::PrimitiveIndexFunctor& functor) const override;

protected:
    ~StillPart() override = default;

private:
    void drawFaces(osg::State& state) const override;

    osg::ref_ptr<const osg::DrawElements> _faces;
};

/// A copy of a level for as long as a blend lasts, while its index buffer goes on to the other level: no second progressive level is
/// needed, and no step is played for it.
/// Memory: the indices of the level's faces, once here and once in each context. Threads: immutable once made.
class StillLevel
{
public:
    using Parts = std::vector<osg::ref_ptr<GroupPart>>;

    /// Of the level that `level` is at, `steps`. Cost: linear in its faces.
    StillLevel(const ViewLevel& level, std::uint32_t steps);

    std::uint32_t steps() const { return _steps; }
    std::uint32_t triangles() const { return _triangles; }
    const Parts& parts() const { return _parts; }

private:
    std::uint32_t _steps, _triangles = 0;
    Parts _parts;
};

} // namespace osgPMObjects

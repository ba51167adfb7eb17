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

/// A copy of a level that lives as long as a blend, while the index buffer goes on to the other level. So a
/// blend needs no second progressive level and applies no steps for it.
/// Memory: the indices of the faces, once here and once in each context. Threads: immutable once made.
class StillLevel
{
public:
    using Parts = std::vector<osg::ref_ptr<GroupPart>>;

    /// Copies the level that `level` is at, `steps`. Cost: linear in its faces.
    StillLevel(const ViewLevel& level, std::uint32_t steps);

    std::uint32_t steps() const { return _steps; }
    std::uint32_t triangles() const { return _triangles; }
    const Parts& parts() const { return _parts; }

private:
    std::uint32_t _steps, _triangles = 0;
    Parts _parts;
};

} // namespace osgPMObjects

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include <osg/Geometry>

#include <osgPMObjects/core/field/FieldLevels.h>

#include <osgPMObjects/ProgressiveShape>

namespace osgPMObjects
{

/// A shape as a field draws it: its ladder, with the index lists of all rungs in one element buffer, and,
/// where instances morph, the vertices' targets, and what leaf cards grow by. OSG's own buffer objects hold
/// both. It never changes once the targets are there.
class FieldMesh : public osg::Referenced
{
public:
    explicit FieldMesh(osg::ref_ptr<const ProgressiveShape> shape);

    /// Every vertex's target is what it becomes on the way to the first rung that does not have it. In the
    /// update phase.
    void addTargets();

    const ProgressiveShape& shape() const { return *_shape; }
    const core::LevelLadder& ladder() const { return _levels->ladder; }

    /// Whether leaf cards of a group grow.
    bool hasLeaves(std::uint32_t group) const;

    /// The arrays of a group; with targets if they are there and asked for.
    const osg::Geometry& arrays(std::uint32_t group, bool withTargets) const;

    /// Whether a group of a rung has faces, and so takes a draw.
    bool hasFaces(std::uint32_t rung, std::uint32_t group) const
    {
        return _levels->ladder.facesOf(rung, group).count > 0;
    }

    /// Draws a group of a rung so many times, from the arrays that are set; sets what leaves grow by.
    void draw(osg::State& state, std::uint32_t rung, std::uint32_t group, std::uint32_t instances) const;

    /// finestFaces(), made when first asked for.
    const std::vector<osg::ref_ptr<osg::Geometry>>& finest() const;

    void resizeGLObjectBuffers(unsigned int contexts) const;
    void releaseGLObjects(osg::State* state) const;

protected:
    ~FieldMesh() override = default;

private:
    void addArrays();

    osg::ref_ptr<const ProgressiveShape> _shape;
    std::shared_ptr<const core::FieldLevels> _levels;
    osg::ref_ptr<osg::DrawElements> _indices;
    std::vector<osg::ref_ptr<osg::Geometry>> _settled, _morphing; ///< by group
    mutable std::once_flag _finestMade;
    mutable std::vector<osg::ref_ptr<osg::Geometry>> _finest;
};

} // namespace osgPMObjects

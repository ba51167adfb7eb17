// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include <osg/Geometry>

#include <osgPMObjects/ProgressiveShape>

namespace osgPMObjects
{

/// The vertices of a level that morphs to a coarser one: the arrays of the shape, and target arrays with the
/// attributes that the coarser level has, in a vertex buffer of their own, by the numbers of ObjectAttribute.
/// It lives as long as the morph; OSG uploads it to each context and removes it there.
/// Memory: 12 to 56 B for each wedge of the finer level, once here and once in each context. Threads:
/// immutable once made.
class MorphArrays
{
public:
    /// Cost: linear in the wedges of the finer level.
    MorphArrays(const ProgressiveShape& shape, std::uint32_t finerSteps, std::uint32_t coarserSteps);

    bool isBetween(std::uint32_t finerSteps, std::uint32_t coarserSteps) const
    {
        return _finer == finerSteps && _coarser == coarserSteps;
    }
    std::uint32_t firstVertex() const { return _firstVertex; } ///< vertices before it do not move

    /// Sets the vertex arrays of a group; unset() disables those that only a morph has.
    void set(osg::RenderInfo& renderInfo, std::uint32_t group) const;
    static void unset(osg::State& state);

private:
    std::uint32_t _finer, _coarser, _firstVertex = 0;
    std::vector<osg::ref_ptr<osg::Geometry>> _groups;
};

using MorphArraysPtr = std::shared_ptr<const MorphArrays>;

} // namespace osgPMObjects

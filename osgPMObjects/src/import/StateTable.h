// -*- c++ -*-
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include <osg/StateSet>

#include <osgPMObjects/core/mesh/Mesh.h>

namespace osgPMObjects
{

/// The StateSets that draw the faces: merged along the path from the root, one for each content.
class StateTable
{
public:
    /// Returns the state that draws what lies below a node with the StateSet `own`, if `above` draws what
    /// lies above it (null: nothing is set). The same arguments give the same pointer.
    osg::ref_ptr<osg::StateSet> below(const osg::ref_ptr<osg::StateSet>& above, osg::StateSet* own);

    /// Returns the material of faces with these attributes that are drawn with `state` (may be null).
    core::Material materialOf(const osg::ref_ptr<osg::StateSet>& state, std::uint32_t attributes);

    const std::vector<osg::ref_ptr<osg::StateSet>>& states() const { return _states; }

private:
    std::uint32_t handleOf(const osg::ref_ptr<osg::StateSet>& state);

    /// Compares everything that affects drawing; names do not count.
    struct LessByContent
    {
        bool operator()(const osg::StateSet* a, const osg::StateSet* b) const;
    };

    using Pair = std::pair<osg::ref_ptr<osg::StateSet>, osg::ref_ptr<osg::StateSet>>;
    std::map<Pair, osg::ref_ptr<osg::StateSet>> _merged;
    std::map<const osg::StateSet*, std::uint32_t, LessByContent> _handles;
    std::vector<osg::ref_ptr<osg::StateSet>> _states;
    osg::ref_ptr<osg::StateSet> _nothing = new osg::StateSet;
};

} // namespace osgPMObjects

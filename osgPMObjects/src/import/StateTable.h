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

/// The StateSets that faces are drawn with: merged along the path from the root, one for each content.
class StateTable
{
public:
    /// What is drawn with below a node whose own StateSet is `own`, where `above` is drawn with above it (null: nothing is
    /// set). The same arguments give the same pointer.
    osg::ref_ptr<osg::StateSet> below(const osg::ref_ptr<osg::StateSet>& above, osg::StateSet* own);

    /// A material that is drawn with `state` (may be null) by faces that have these attributes.
    core::Material materialOf(const osg::ref_ptr<osg::StateSet>& state, std::uint32_t attributes);

    const std::vector<osg::ref_ptr<osg::StateSet>>& states() const { return _states; }

private:
    std::uint32_t handleOf(const osg::ref_ptr<osg::StateSet>& state);

    /// By all that is drawn with; names do not count.
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

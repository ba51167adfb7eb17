// -*- c++ -*-
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Program>
#include <osg/StateSet>
#include <osg/Texture2D>

#include <osgPMObjects/core/bake/BakeMaps.h>

#include "SurfaceColours.h"

namespace osgPMObjects
{

/// The look that all states of one baked model share.
class BakedLook
{
public:
    /// `gutterPx`: of the maps. Normals are read only from mipmap levels in which no texel reaches from one
    /// chart into the next, as the mean of two charts is meaningless; colours from all levels, where a mean
    /// of neighbours does less harm than flicker.
    BakedLook(const core::BakedMaps& maps, int gutterPx);

    /// Makes a state that draws with the maps what `state` drew with its own textures and colours.
    osg::ref_ptr<osg::StateSet> stateFor(const osg::StateSet& state, const Finish& finish,
                                         bool hasNormals) const;

private:
    osg::ref_ptr<osg::Texture2D> _colours, _normals;
    osg::ref_ptr<osg::Program> _program;
};

} // namespace osgPMObjects

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

/// What all states of one baked model share.
class BakedLook
{
public:
    /// `gutterPx`: that of the maps. Normals are taken from copies so small only that no texel reaches from one chart into the
    /// next, for a mean of two says nothing; colours from any, for a mean of neighbours does less harm than flicker.
    BakedLook(const core::BakedMaps& maps, int gutterPx);

    /// A state that draws with the maps what `state` drew with its own textures and colours.
    osg::ref_ptr<osg::StateSet> stateFor(const osg::StateSet& state, const Finish& finish,
                                         bool hasNormals) const;

private:
    osg::ref_ptr<osg::Texture2D> _colours, _normals;
    osg::ref_ptr<osg::Program> _program;
};

} // namespace osgPMObjects

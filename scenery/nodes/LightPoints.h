// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <osg/Array>
#include <osg/Group>
#include <osg/Program>
#include <osg/Uniform>

#include "scenery/lights/LightPoint.h"

namespace scenery
{

/// Lamps as points, drawn with one vertex each, 15 000 of them in one draw: one square of `tileM` is one
/// draw. Cull leaves out squares whose groups are all off or from which no lamp can be seen.
/// Frame: the scene's, or that of the vehicle which bears the lamps; needs the uniforms of an Atmosphere and
/// of LightUniforms above it. Threads: made anywhere; light() in the update phase.
class LightPoints
{
public:
    /// `tileM`: the side of a square; 0: all are one draw.
    explicit LightPoints(std::span<const LightPoint> lights, double tileM = 8000.0);

    /// Null without lights.
    osg::Group* node() const { return _node.get(); }

    /// Hides the squares of whose groups none is on.
    void light(const LightLevels& levels);

    /// Sets what share of its intensity each lamp has, in the order of the constructor. All are one draw.
    void dim(std::span<const float> shares);

private:
    struct Tile
    {
        osg::ref_ptr<osg::Node> node;
        unsigned groups = 0; ///< a bit for each
    };
    osg::ref_ptr<osg::Group> _node;
    std::vector<Tile> _tiles;
    std::vector<float> _candela;           ///< of one draw
    osg::ref_ptr<osg::Vec4Array> _colours; ///< the same
};

/// What all light points of a scene share: their beams, the eye's threshold, the time of flashes and of the
/// day, and steps.
/// Threads: show() in the update phase.
class LightUniforms
{
public:
    /// `scene`: the state above all light points.
    explicit LightUniforms(osg::StateSet& scene);

    /// `leastLx`: what an eye just sees (leastIlluminanceLx). `dayS`: since midnight, local solar time.
    void show(double leastLx, double timeS, double dayS, const LightLevels& levels);

private:
    osg::ref_ptr<osg::Uniform> _leastLx, _timeS, _dayS, _levels;
};

/// The program of light points.
osg::ref_ptr<osg::Program> makeLightPointProgram();

} // namespace scenery

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Node>
#include <osg/Vec2f>

namespace scenery
{

/// How an object answers to light.
enum class Finish
{
    matt,       ///< rubber, cloth, bare loaded models
    lacquered,  ///< car paint, glass: mirrors the sky more at grazing angles
    seeThrough, ///< as matt, blended by its colour's alpha, writes no depth
    foliage, ///< leaves: cut out by texture unit 0's alpha, one normal for both sides, light comes round and through
};

/// Round holes in both flanks of a body, such as wheel wells: what lies within `radiusM` of one of two axes that run
/// across the body, and farther than `innerYM` from its middle, is left out. Frame: the object's. Units: metres.
struct FlankHoles
{
    osg::Vec2f firstXz, secondXz;
    float radiusM = 0.0F;
    float innerYM = 0.0F;
};

/// Lights everything below `node` with the atmosphere's sun and sky and hazes it exactly as the terrain is hazed
/// (osgTerrainROAM::Atmosphere). Colour: the vertex colours or, in a loaded model without, its material's diffuse
/// colour, taken as display values, times texture unit 0 where a model has one.
/// Where a state below sets the uniform `objectTintMask` to 1, the texture's alpha says how far the vertex colour counts.
/// Objects of a field and such as are on their way between two levels are shaded by it, too (osgPMObjects/ObjectShader).
/// Needs the uniforms of an Atmosphere above it in the graph.
void setObjectShading(osg::Node& node, Finish finish, const FlankHoles& holes = {});

} // namespace scenery

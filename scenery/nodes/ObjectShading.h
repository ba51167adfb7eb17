// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Node>

namespace scenery
{

/// How an object reflects light.
enum class Finish
{
    matt,       ///< rubber, cloth, bare loaded models
    lacquered,  ///< car paint, glass: mirrors the sky more at grazing angles
    lit,        ///< a sheet with a lamp behind it: its colour shines by itself, which the eye sees by night
    seeThrough, ///< as matt, blended by the alpha of its colour, writes no depth
    /// a crown: cut out by texture unit 0's alpha, one normal for both sides, light comes round and through
    foliage,
    blades, ///< of grass: as foliage, but what they stand in the shadow of is not their own crown
};

/// Lights everything below `node` with the sun and the sky of the atmosphere, and adds the haze of the
/// terrain (osgSky::Atmosphere). Colour: the vertex colours, or the diffuse colour of the material in
/// a loaded model without them, as display values, times texture unit 0 if there is one. A state below may
/// set the uniform `objectTintMask` to 1: then the alpha of the texture is the share of the vertex colour,
/// and that of the vertex colour the share of the sky that is seen there. It also shades objects of a field
/// and objects that switch between levels (osgPMObjects/ObjectShader). Needs the uniforms of an Atmosphere
/// above it in the graph.
void setObjectShading(osg::Node& node, Finish finish);

} // namespace scenery

// SPDX-License-Identifier: Apache-2.0
#include <osgPMObjects/ObjectShader>

namespace osgPMObjects
{

const char* glslVertexFunctions()
{
    return R"(
#pragma import_defines ( OSGPM_INSTANCED, OSGPM_SWITCHED, OSGPM_MORPH, OSGPM_LEAVES )

#ifdef OSGPM_INSTANCED
in vec4 pmPlace; // from the eye, along the field's axes; scale
in vec4 pmTurn;
vec3 pmTurned(vec3 v) { return v + 2.0 * cross(pmTurn.xyz, cross(pmTurn.xyz, v) + pmTurn.w * v); }
// The eye stands at 0, so the translation of the model-view matrix, which floats would not hold, is not needed.
vec4 pmInView(vec3 position)
{
    return vec4(mat3(gl_ModelViewMatrix) * (pmPlace.xyz + pmPlace.w * pmTurned(position)), 1.0);
}
vec3 pmNormalInView(vec3 normal) { return gl_NormalMatrix * pmTurned(normal); }
#else
vec4 pmInView(vec3 position) { return gl_ModelViewMatrix * vec4(position, 1.0); }
vec3 pmNormalInView(vec3 normal) { return gl_NormalMatrix * normal; }
#endif

#ifdef OSGPM_SWITCHED
#ifdef OSGPM_INSTANCED
in vec4 pmShown; // door's lower and upper edge, morph, first vertex that morphs
#else
uniform vec4 pmShown;
#endif
flat out vec2 pmDoor;
void pmShow() { pmDoor = pmShown.xy; }
#else
void pmShow() {}
#endif

#if defined(OSGPM_SWITCHED) && defined(OSGPM_MORPH)
in vec3 pmTargetPosition;
in vec3 pmTargetNormal;
in vec4 pmTargetColour;
in vec4 pmTargetTexCoords;
// Vertices that the coarser level has, too, stay: their targets are those of a level that is coarser still.
float pmMorph() { return float(gl_VertexID) >= pmShown.w ? pmShown.z : 0.0; }
vec3 pmUngrown() { return mix(gl_Vertex.xyz, pmTargetPosition, pmMorph()); }
// A normal of 0: vertices have none.
vec3 pmNormal() { return pmTargetNormal == vec3(0.0) ? gl_Normal : mix(gl_Normal, pmTargetNormal, pmMorph()); }
// A red below 0: the colour is the material's, which vertices do not have.
vec4 pmColour() { return pmTargetColour.r < 0.0 ? gl_Color : mix(gl_Color, pmTargetColour, pmMorph()); }
vec2 pmTexCoord0() { return mix(gl_MultiTexCoord0.xy, pmTargetTexCoords.xy, pmMorph()); }
vec2 pmTexCoord1() { return mix(gl_MultiTexCoord1.xy, pmTargetTexCoords.zw, pmMorph()); }
#else
vec3 pmUngrown() { return gl_Vertex.xyz; }
vec3 pmNormal() { return gl_Normal; }
vec4 pmColour() { return gl_Color; }
vec2 pmTexCoord0() { return gl_MultiTexCoord0.xy; }
vec2 pmTexCoord1() { return gl_MultiTexCoord1.xy; }
#endif

#ifdef OSGPM_LEAVES
in vec3 pmLeafOffset;
in vec2 pmLeafScale; // on this rung and on the next coarser one
#if defined(OSGPM_SWITCHED) && defined(OSGPM_MORPH)
float pmGrowth() { return mix(pmLeafScale.x, pmLeafScale.y, pmShown.z) - 1.0; }
#else
float pmGrowth() { return pmLeafScale.x - 1.0; }
#endif
vec3 pmPosition() { return pmUngrown() + pmGrowth() * pmLeafOffset; }
#else
vec3 pmPosition() { return pmUngrown(); }
#endif
)";
}

const char* glslFragmentFunctions()
{
    return R"(
#pragma import_defines ( OSGPM_SWITCHED, OSGPM_BLENDED )

#ifdef OSGPM_SWITCHED
flat in vec2 pmDoor;
#ifdef OSGPM_BLENDED
float pmAlpha() { return pmDoor.y - pmDoor.x; }
#else
// A pixel's place in the order in which a door opens: its bits, from the coarsest grid down.
float pmPixelOrder()
{
    int x = int(gl_FragCoord.x) & 7;
    int y = int(gl_FragCoord.y) & 7;
    int d = x ^ y;
    int order = (d & 1) << 5 | (y & 1) << 4 | (d & 2) << 2 | (y & 2) << 1 | (d & 4) >> 1 | (y & 4) >> 2;
    return (float(order) + 0.5) / 64.0;
}
float pmAlpha()
{
    float order = pmPixelOrder();
    if (order < pmDoor.x || order >= pmDoor.y) discard;
    return 1.0;
}
#endif
#else
float pmAlpha() { return 1.0; }
#endif
)";
}

} // namespace osgPMObjects

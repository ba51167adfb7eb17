// SPDX-License-Identifier: Apache-2.0
// Defines the functions by which a vertex shader reads its vertex; the header ObjectShader lists them.
// Defines of the state choose: an instance of a field, a change of level (cross-fade or morph), leaf cards. GLSL 1.30.

#pragma import_defines ( OSGPM_INSTANCED, OSGPM_SWITCHED, OSGPM_MORPH, OSGPM_LEAVES )

#ifdef OSGPM_INSTANCED
in vec4 pmPlace; // position from the eye, along the field's axes; scale
in vec4 pmTurn; // quaternion
vec3 pmTurned(vec3 v) { return v + 2.0 * cross(pmTurn.xyz, cross(pmTurn.xyz, v) + pmTurn.w * v); }
// The eye is the origin, so the translation of the model-view matrix is not needed; floats could not hold it.
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
in vec4 pmShown; // lower and upper threshold of the screen door; morph 0 ... 1; first vertex that morphs
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
// Vertices that the coarser level also has do not move: their targets are those of a still coarser level.
float pmMorph() { return float(gl_VertexID) >= pmShown.w ? pmShown.z : 0.0; }
vec3 pmUngrown() { return mix(gl_Vertex.xyz, pmTargetPosition, pmMorph()); }
// A target normal of 0 means that vertices have no normals.
vec3 pmNormal() { return pmTargetNormal == vec3(0.0) ? gl_Normal : mix(gl_Normal, pmTargetNormal, pmMorph()); }
// A red below 0 means that vertices have no colours: the material's colour counts.
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

// SPDX-License-Identifier: Apache-2.0
// Tells what share of the sun reaches a place, by the maps of the class SunShadows: four squares across the rays, each wider than the one
// before, in one texture. Each map ends softly in the next. Follows Atmosphere.glsl. GLSL 1.30.
// SUN_SHADOWS: there are maps. SUN_SHADOW_MAP: this is the picture of one: main() computes no colour, only what it discards.
// SUN_SHADOW_HARD: one sample in place of four. PICTURE_LOW, PICTURE_MEDIUM: pictures that leave out detail to be quick; for all parts of
// a program.

#pragma import_defines(SUN_SHADOWS, SUN_SHADOW_MAP, SUN_SHADOW_HARD, PICTURE_LOW, PICTURE_MEDIUM)

#ifdef SUN_SHADOWS
uniform sampler2DShadow sunShadowMap;
uniform mat3 sunShadowAxes;     // from world axes to across, across, towards the sun
uniform vec4 sunShadowMaps[4];  // centre from the eye across, across and along the rays, and half side, metres
uniform float sunShadowTexels;  // of a map's side
uniform float sunShadowDepthM;  // from the eye to either end of the maps' depth

// Returns the place in its map, -1 ...  1.
vec2 inSunShadowMap(vec2 place, int map)
{
    return (place - sunShadowMaps[map].xy) / sunShadowMaps[map].w;
}

float sunShareOfMap(vec3 place, vec3 normal, int map)
{
    float texelM = 2.0 * sunShadowMaps[map].w / sunShadowTexels;
    // On a slope a texel is as deep as it is wide: the place is looked up as far off the surface.
    place += normal * (texelM * (0.8 + 1.6 * sqrt(max(1.0 - normal.z * normal.z, 0.0))));
    float depth = 0.5 - 0.5 * (place.z - sunShadowMaps[map].z + 0.5 * texelM) / sunShadowDepthM;
    float margin = 1.5 / sunShadowTexels;
    vec2 at = clamp(0.5 + 0.5 * inSunShadowMap(place.xy, map), margin, 1.0 - margin);
    vec2 tile = vec2(float(map & 1), float(map >> 1));
#ifdef SUN_SHADOW_HARD
    return texture(sunShadowMap, vec3(0.5 * (tile + at), depth)); // an edge one texel wide
#else
    // The mean of four texels, weighted by the sampler, at four places: an edge two texels wide.
    float share = 0.0;
    for (int i = 0; i < 4; ++i)
    {
        vec2 beside = (vec2(float(i & 1), float(i >> 1)) - 0.5) / sunShadowTexels;
        share += texture(sunShadowMap, vec3(0.5 * (tile + at + beside), depth));
    }
    return 0.25 * share;
#endif
}
#endif

float sunShare(vec3 fromEyeWorld, vec3 normalWorld, float beyond)
{
#ifdef SUN_SHADOWS
    const float kFade = 0.12; // of a map's half side: within it, it ends in the next
    // Surfaces that lie on each other, as a road on the ground, may be drawn some pixels apart.
    const float kPixels = 0.003; // as a tangent
    vec3 place = sunShadowAxes * fromEyeWorld;
    place.z += kPixels * length(fromEyeWorld) / max(sunDirection().z, 0.1);
    vec3 normal = sunShadowAxes * normalWorld;
    int map = 0;
    float edge = 2.0;
    for (int i = 0; i < 4; ++i)
    {
        vec2 at = abs(inSunShadowMap(place.xy, i));
        edge = max(at.x, at.y);
        map = i;
        if (edge < 0.99) break;
    }
    if (edge >= 0.99) return beyond;
    float share = sunShareOfMap(place, normal, map);
    float fade = clamp((edge - 0.99 + kFade) / kFade, 0.0, 1.0);
    // No branch: software drawing leaves out a loop that no pixel of a group enters.
    for (int i = fade > 0.0 ? 0 : 1; i < 1; ++i)
        share = mix(share, map < 3 ? sunShareOfMap(place, normal, min(map + 1, 3)) : beyond, fade);
    return share;
#else
    return beyond;
#endif
}

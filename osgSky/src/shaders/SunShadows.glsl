// SPDX-License-Identifier: Apache-2.0
// Tells what share of the sun reaches a place, by the maps of the class SunShadows: four squares across the rays, each wider than the one
// before, in one texture. Each map ends softly in the next. Follows Atmosphere.glsl. GLSL 1.30.
// SUN_SHADOWS: there are maps. SUN_SHADOW_MAP: this is the picture of one: main() computes no colour, only what it discards.
// CLOUD_SHADOWS: clouds above take light, too.
// SUN_SHADOW_HARD: one sample in place of four. PICTURE_LOW, PICTURE_MEDIUM: pictures that leave out detail to be quick; for all parts of
// a program.

#pragma import_defines(SUN_SHADOWS, SUN_SHADOW_MAP, SUN_SHADOW_HARD, PICTURE_LOW, PICTURE_MEDIUM, CLOUD_SHADOWS)

#ifdef SUN_SHADOWS
uniform sampler2DShadow sunShadowMap;
uniform mat3 sunShadowAxes;     // from world axes to across, across, towards the sun
uniform vec4 sunShadowMaps[4];  // centre from the eye across, across and along the rays, and half side, metres
uniform float sunShadowTexels;  // of a map's side
uniform float sunShadowDepthM;  // from the eye to either end of the maps' depth

// `map`: one of sunShadowMaps; `tile`: its place in the texture, 0 or 1 to the right and up.
float sunShareOfMap(vec3 place, vec3 normal, vec4 map, vec2 tile)
{
    float texelM = 2.0 * map.w / sunShadowTexels;
    // On a slope a texel is as deep as it is wide: the place is looked up as far off the surface.
    place += normal * (texelM * (0.8 + 1.6 * sqrt(max(1.0 - normal.z * normal.z, 0.0))));
    float depth = 0.5 - 0.5 * (place.z - map.z + 0.5 * texelM) / sunShadowDepthM;
    float margin = 1.5 / sunShadowTexels;
    vec2 at = clamp(0.5 + 0.5 * (place.xy - map.xy) / map.w, margin, 1.0 - margin);
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

// How far from the middle of a map, in half sides.
float edgeOfMap(vec2 place, vec4 map)
{
    vec2 at = abs(place - map.xy);
    return max(at.x, at.y) / map.w;
}
#endif

#ifdef CLOUD_SHADOWS
uniform sampler2D cloudShade;    // share of the sun below the clouds, on the plane of their base; repeats
uniform vec3 cloudShadeSlab;     // base and top in the world, metres; how much of the shadow counts
uniform vec2 cloudShadeDrift;    // metres

float cloudShare(vec3 fromEyeWorld)
{
    const float kTileM = 20480.0, kLowestSun = 0.105;
    vec3 place = osg_ViewMatrixInverse[3].xyz + fromEyeWorld;
    vec2 at = place.xy + sunDirection().xy * ((cloudShadeSlab.x - place.z) / max(sunDirection().z, kLowestSun));
    float within = smoothstep(cloudShadeSlab.x, cloudShadeSlab.y, place.z);
    return mix(1.0, texture(cloudShade, (at - cloudShadeDrift) / kTileM).r, cloudShadeSlab.z * (1.0 - within));
}
#endif

float shareOfMaps(vec3 fromEyeWorld, vec3 normalWorld, float beyond)
{
#ifdef SUN_SHADOWS
    const float kFade = 0.12; // of a map's half side: within it, it ends in the next
    const float kLast = 0.99; // of it: the last place that is looked up in it
    // Surfaces that lie on each other, as a road on the ground, may be drawn some pixels apart.
    const float kPixels = 0.003; // as a tangent
    vec3 place = sunShadowAxes * fromEyeWorld;
    place.z += kPixels * length(fromEyeWorld) / max(sunDirection().z, 0.1);
    vec3 normal = sunShadowAxes * normalWorld;
    // The nearest map with the place in it, and the next. Chosen, not indexed: software drawing reads an array pixel by pixel.
    vec4 map = sunShadowMaps[3], next = sunShadowMaps[3];
    vec2 tile = vec2(1.0), nextTile = vec2(1.0);
    float edge = edgeOfMap(place.xy, map);
    bool isLast = true;
    for (int i = 2; i >= 0; --i)
    {
        float nearer = edgeOfMap(place.xy, sunShadowMaps[i]);
        bool isIn = nearer < kLast;
        next = isIn ? map : next;
        nextTile = isIn ? tile : nextTile;
        map = isIn ? sunShadowMaps[i] : map;
        tile = isIn ? vec2(float(i & 1), float(i >> 1)) : tile;
        edge = isIn ? nearer : edge;
        isLast = isLast && !isIn;
    }
    float share = sunShareOfMap(place, normal, map, tile);
    float fade = clamp((edge - kLast + kFade) / kFade, 0.0, 1.0);
    // No branch: software drawing leaves out a loop that no pixel of a group enters.
    for (int i = fade > 0.0 ? 0 : 1; i < 1; ++i)
        share = mix(share, isLast ? beyond : sunShareOfMap(place, normal, next, nextTile), fade);
    return share;
#else
    return beyond;
#endif
}

float sunShare(vec3 fromEyeWorld, vec3 normalWorld, float beyond)
{
    float share = shareOfMaps(fromEyeWorld, normalWorld, beyond);
#ifdef CLOUD_SHADOWS
    share *= cloudShare(fromEyeWorld);
#endif
    return share;
}

// SPDX-License-Identifier: Apache-2.0
// What weather has left on a surface: how deep snow lies, how much of the surface it covers, how dark and how bright water makes it.
// Follows Atmosphere.glsl, which declares surfaceWeather. Without SURFACE_WEATHER there is nothing of it. GLSL 1.30.
//   float snowDepth(vec3 fromEyeWorld, float upright)       cm; `upright`: z of the normal. Steep faces hold none
//   float snowShare(float depthCm, float roughCm, float noise)   of a surface, 0 ... 1; `noise`: -0.5 ... 0.5
//   vec3 wetAlbedo(vec3 albedo, float lost)                 `lost`: share of the light that it keeps when it is wet
//   vec3 filmOfWater(vec3 lit, vec3 towards, vec3 normal, float share)   a film of water that mirrors the sky
// Sources: Niu and Yang, An observation-based formulation of snow cover fraction (2007), equation 4, for fresh snow; Warren, Optical
// properties of snow (1982): the reflectance; Schlick, An inexpensive BRDF model for physically-based rendering (1994), section 4.

#ifdef SURFACE_WEATHER
const vec3 kFreshSnow = vec3(0.830, 0.845, 0.860);

float snowDepth(vec3 fromEyeWorld, float upright)
{
    const float kHalfOfEarth = 7.85e-8; // 1 / (2 radii)
    vec3 place = osg_ViewMatrixInverse[3].xyz + fromEyeWorld;
    float height = place.z + dot(place.xy, place.xy) * kHalfOfEarth;
    float there = smoothstep(0.0, 1.0, 1.0 + (height - surfaceSnowLine.x) * surfaceSnowLine.y);
    return surfaceWeather.y * there * smoothstep(0.35, 0.75, upright); // 70 to 41 degrees
}

float snowShare(float depthCm, float roughCm, float noise)
{
    float mean = tanh(depthCm / (2.5 * roughCm));
    // What sticks out is bare until the mean is 1; steady in both.
    return clamp(mean + 2.0 * noise * mean * (1.0 - mean), 0.0, 1.0);
}

vec3 wetAlbedo(vec3 albedo, float lost) { return albedo * (1.0 - lost * surfaceWeather.x); }

vec3 filmOfWater(vec3 lit, vec3 towards, vec3 normal, float share)
{
    float grazing = 1.0 - max(-dot(normal, towards), 0.0);
    vec3 mirrored = reflect(towards, normal);
    vec3 sky = skyColour(vec3(mirrored.xy, max(mirrored.z, 0.0)));
    return mix(lit, sky, share * (0.02 + 0.98 * pow(grazing, 5.0)));
}
#endif

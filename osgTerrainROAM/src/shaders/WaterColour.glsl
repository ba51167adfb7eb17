// SPDX-License-Identifier: Apache-2.0
// Colours water: the mirrored sky over light from below the surface. Source: Schlick, An inexpensive BRDF model for
// physically-based rendering (1994), section 4: the Fresnel term.

vec3 waterColour(vec3 directionWorld, Grain g)
{
    // The ripples are small, so that the reflection of the sky stays whole; they fade with the grain's mip levels.
    vec3 normal = normalize(vec3(0.10 * g.metres2.xy + 0.05 * g.metres28.xy, 1.0));
    vec3 mirrored = reflect(directionWorld, normal);
    mirrored.z = abs(mirrored.z);
    float facing = clamp(-dot(directionWorld, normal), 0.0, 1.0);
    float away = 1.0 - facing;
    float away2 = away * away;
    float fresnel = 0.02 + 0.98 * away2 * away2 * away;
    vec3 deep = terrainWater * lightOn(vec3(0.0, 0.0, 1.0), max(sunDirection().z, 0.0), 1.0);
    return mix(deep, skyColour(normalize(mirrored)), fresnel * 0.85);
}

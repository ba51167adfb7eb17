// SPDX-License-Identifier: Apache-2.0
// What a pixel of the ground is multiplied by where it gets less light. After Atmosphere.glsl. GLSL 1.30.

// Returns it for level ground of a medium colour, `before` and `after` the light was taken; paler in haze.
vec3 darkening(vec3 before, vec3 after, vec3 fromEyeWorld)
{
    const float kAlbedo = 0.15;
    vec3 left = displayColour(kAlbedo * after) / max(displayColour(kAlbedo * before), vec3(1e-4));
    float distanceM = length(fromEyeWorld);
    vec3 towards = fromEyeWorld / distanceM;
    float through = (applyHaze(vec3(1.0), towards, distanceM) - applyHaze(vec3(0.0), towards, distanceM)).g;
    return mix(vec3(1.0), left, through);
}

// SPDX-License-Identifier: Apache-2.0
// Takes light of the sky from ground that sees less of it: maskAt.x is the share that is hidden. The sun's light is left as it is there.
// After Occlusion.glsl.

in vec3 fromEye;
in vec2 maskAt;
uniform float skyShadeReachM;
void main()
{
    const vec3 kUp = vec3(0.0, 0.0, 1.0);
    float sunlit = max(sunDirection().z, 0.0) * sunShare(fromEye, kUp, 1.0);
    float hidden = maskAt.x * (1.0 - smoothstep(0.6 * skyShadeReachM, skyShadeReachM, length(fromEye)));
    // Grey: what hides the blue of the sky sends light of its own colour down, and snow must not turn brown.
    vec3 before = lightOn(kUp, sunlit, 1.0);
    float left = lightOn(kUp, sunlit, 1.0 - hidden).g / max(before.g, 1e-6);
    gl_FragColor = vec4(darkening(before, before * left, fromEye), 1.0);
}

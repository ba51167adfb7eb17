// SPDX-License-Identifier: Apache-2.0
// Darkens the ground where a body keeps the sun away: what is drawn is multiplied by the light that is left, as ground of a medium
// colour shows it. In haze the shadow pales (Occlusion.glsl, before this). Where there is no sun there is no shadow.

in vec3 fromEye;
in vec2 maskAt;
uniform sampler2D shadowMask;
void main()
{
    const vec3 kUp = vec3(0.0, 0.0, 1.0);
    vec3 left = darkening(lightOn(kUp, max(sunDirection().z, 0.0), 1.0), lightOn(kUp, 0.0, 1.0), fromEye);
    gl_FragColor = vec4(mix(vec3(1.0), left, texture(shadowMask, maskAt).r), 1.0);
}

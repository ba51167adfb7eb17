// SPDX-License-Identifier: Apache-2.0
// Darkens the ground where a body keeps the sun away: what is drawn is multiplied by the light that is left, as ground of a medium
// colour shows it. In haze the shadow pales. Where there is no sun there is no shadow.

in vec3 fromEye;
in vec2 maskAt;
uniform sampler2D shadowMask;
void main()
{
    const float kAlbedo = 0.15;
    const vec3 kUp = vec3(0.0, 0.0, 1.0);
    vec3 lit = displayColour(kAlbedo * lightOn(kUp, max(sunDirection().z, 0.0), 1.0));
    vec3 left = displayColour(kAlbedo * lightOn(kUp, 0.0, 1.0)) / max(lit, vec3(1e-4));
    float distanceM = length(fromEye);
    vec3 towards = fromEye / distanceM;
    float through = (applyHaze(vec3(1.0), towards, distanceM) - applyHaze(vec3(0.0), towards, distanceM)).g;
    float hidden = texture(shadowMask, maskAt).r * through;
    gl_FragColor = vec4(mix(vec3(1.0), left, hidden), 1.0);
}

// SPDX-License-Identifier: Apache-2.0
// Colours a drop by the light of the sky that it gathers, a flake by the light that falls on it. After the functions of the atmosphere.

uniform vec4 dropsLook; // 1: snow
in vec3 fromEye;
in float share;
in vec2 inFlake;

void main()
{
    vec3 up = vec3(0.0, 0.0, 1.0);
    vec3 towards = normalize(fromEye);
    vec3 gathered = 0.5 * (skyColour(vec3(towards.xy, 0.2)) + skyColour(up));
    vec3 white = 0.95 * lightOn(up, 0.25 * max(sunDirection().z, 0.0), 1.0);
    float edge = 1.0 - smoothstep(0.6, 1.0, dropsLook.x > 0.5 ? length(inFlake) : abs(inFlake.x));
    float alpha = share * edge * mix(0.45, 0.95, dropsLook.x);
    gl_FragColor = vec4(displayColour(mix(gathered, white, dropsLook.x)), alpha);
}

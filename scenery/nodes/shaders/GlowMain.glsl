// SPDX-License-Identifier: Apache-2.0
// The glow about a lamp, added to what is behind it. By day the eye is adapted to so much light that hardly any is seen.

in vec3 fromEye;
in vec3 light;
in vec2 across;
void main()
{
    float away = length(across);
    float core = exp(-8.0 * away * away), halo = 0.22 * pow(max(1.0 - away, 0.0), 2.0);
    float distanceM = length(fromEye);
    vec3 towards = fromEye / distanceM;
    vec3 air = applyHaze(vec3(0.0), towards, distanceM);
    vec3 through = applyHaze(light, towards, distanceM) - air;
    float day = dot(ambientLight(vec3(0.0, 0.0, 1.0)) + sunLight(), vec3(0.33));
    vec3 added = through * ((core + halo) * mix(1.0, 0.12, clamp(day, 0.0, 1.0)));
    gl_FragColor = vec4(displayColour(added), 1.0);
}

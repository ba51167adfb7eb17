// SPDX-License-Identifier: Apache-2.0
// Lights the moon's disc by the sun: its phase. By day it is as pale as the sky before it lets it be.

in vec2 onDisc;
in vec3 discRight;
in vec3 discUp;
uniform vec3 moonDirection;
uniform float moonInDay; // 0 night, 1 day
void main()
{
    float r2 = dot(onDisc, onDisc);
    float edge = 1.0 - smoothstep(1.0 - fwidth(r2), 1.0 + 0.5 * fwidth(r2), r2);
    vec3 normal = onDisc.x * discRight + onDisc.y * discUp - sqrt(max(1.0 - r2, 0.0)) * moonDirection;
    float lit = smoothstep(-0.03, 0.20, dot(normal, sunDirection()));
    // The seas, roughly where they are.
    float seas = smoothstep(0.45, 0.2, length(onDisc - vec2(-0.25, 0.25))) + smoothstep(0.35, 0.15, length(onDisc - vec2(0.35, 0.2)));
    float surface = lit * (1.0 - 0.22 * min(seas, 1.0)) + 0.015 * (1.0 - moonInDay);
    float low = smoothstep(0.0, 0.25, moonDirection.z); // red near the horizon, as the sun is
    vec3 colour = mix(vec3(0.95, 0.62, 0.38), vec3(1.0, 0.98, 0.92), low) * surface * edge;
    gl_FragColor = vec4(colour * mix(1.0, 0.22, moonInDay), edge * (1.0 - moonInDay));
}

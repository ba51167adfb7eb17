// SPDX-License-Identifier: Apache-2.0
// The spread of a lamp over pixels, added to what is behind it: a quadratic B-spline, whose weights at the middles of all pixels sum up to one wherever
// the lamp falls between them. So a lamp neither twinkles nor blinks as it moves. Source: Unser, Splines: a perfect fit (1999). GLSL 1.30.

flat in vec3 exposed;
flat in float spreadPx;

void main()
{
    vec2 at = abs(gl_PointCoord - 0.5) * ((3.0 * spreadPx + 1.0) / spreadPx);
    vec2 outer = max(1.5 - at, 0.0);
    vec2 weight = mix(0.75 - at * at, 0.5 * outer * outer, step(0.5, at));
    // A glaring lamp is round.
    float away = length(at), out1 = max(1.5 - away, 0.0);
    float round1 = away < 0.5 ? 0.75 - away * away : 0.5 * out1 * out1;
    vec3 light = exposed * mix(weight.x * weight.y, 0.75 * round1, smoothstep(1.4, 3.0, spreadPx));
    gl_FragColor = vec4(displayColour(light / atmosphereExposure), 1.0);
}

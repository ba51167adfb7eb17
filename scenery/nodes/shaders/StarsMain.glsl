// SPDX-License-Identifier: Apache-2.0
// Draws a star as a small soft disc; what does not fit below white makes it wider.

in vec3 starColour;
in float sizePx;
void main()
{
    vec2 awayPx = (gl_PointCoord - 0.5) * sizePx;
    gl_FragColor = vec4(starColour * exp(-1.1 * dot(awayPx, awayPx)), 0.0);
}

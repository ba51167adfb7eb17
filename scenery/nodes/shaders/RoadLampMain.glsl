// SPDX-License-Identifier: Apache-2.0
// A lamp of a traffic light: shines by itself, in haze; a dark one is left out, so that the lens behind it is seen.

in vec3 fromEye;
in vec4 colour;
void main()
{
    if (colour.a < 0.5) discard;
    float distanceM = length(fromEye);
    gl_FragColor = vec4(displayColour(applyHaze(colour.rgb, fromEye / distanceM, distanceM)), 1.0);
}

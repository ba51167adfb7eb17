// SPDX-License-Identifier: Apache-2.0
// The light of a room through two sashes: frame and bars stay dark, the lamp hangs high in the room. GLSL 1.30.

in vec3 fromEye;
in vec3 light;
in vec2 across;
void main()
{
    vec2 edge = abs(across - 0.5);
    // Bars as wide as a pixel at least would vanish far away: there their share is left.
    vec2 soft = max(fwidth(across), vec2(0.004));
    vec2 pane = smoothstep(vec2(0.0), soft, 0.455 - edge);
    float bar = mix(1.0, smoothstep(0.0, soft.x, edge.x - 0.028), min(0.056 / soft.x, 1.0));
    float room = 0.62 + 0.38 * across.y - 0.25 * edge.x;
    float distanceM = length(fromEye);
    vec3 shown = light * (pane.x * pane.y * bar * room) + vec3(0.004);
    gl_FragColor = vec4(displayColour(applyHaze(shown, fromEye / distanceM, distanceM)), 1.0);
}

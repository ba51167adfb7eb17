// SPDX-License-Identifier: Apache-2.0
// Writes the logarithm of the distance from the eye, 16 bits in red and green; blue is 1 where there is ground.

in vec3 fromEye;
in vec2 grid;

void main()
{
    float v = clamp((log2(length(fromEye)) + 2.0) / 22.0, 0.0, 1.0) * 255.0;
    gl_FragColor = vec4(floor(v) / 255.0, fract(v), 1.0, 1.0);
}

// SPDX-License-Identifier: Apache-2.0
// Colours the sky by direction: atmosphere and sun.

in vec3 direction;

void main()
{
    vec3 towards = normalize(direction);
    vec3 colour = skyColour(towards) + sunDisc(towards);
    gl_FragColor = vec4(displayColour(colour), 1.0);
}

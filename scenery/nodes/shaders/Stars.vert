// SPDX-License-Identifier: Apache-2.0
// Places a star on the far plane, as large and bright as its magnitude says.

#version 130
out vec3 starColour;
out float sizePx;
uniform mat3 worldFromStars;
uniform float faintestSeen;
uniform float drawnPixels; // along each side of a pixel of the picture
uniform mat4 osg_ViewMatrix;
void main()
{
    vec3 world = worldFromStars * gl_Vertex.xyz;
    vec4 eye = vec4(mat3(osg_ViewMatrix) * world, 0.0);
    gl_Position = gl_ProjectionMatrix * eye;
    gl_Position.z = gl_Position.w;
    // A quarter of a magnitude for the air overhead, more for a longer way through it.
    float magnitude = gl_Vertex.w + 0.25 * (1.0 / max(world.z, 0.06) - 1.0);
    float seen = clamp((faintestSeen - magnitude) / 1.5, 0.0, 1.0) * smoothstep(0.0, 0.03, world.z);
    // A display value: its root stands for the eye, which sees a hundredfold as some four times.
    float peak = pow(10.0, -0.15 * (magnitude + 0.2)) * seen;
    sizePx = 2.6 + 0.8 * max(2.0 - magnitude, 0.0);
    starColour = gl_Color.rgb * min(peak, 1.3);
    gl_PointSize = drawnPixels * sizePx;
    if (peak < 0.01) gl_Position = vec4(2.0, 2.0, 2.0, 1.0); // outside the picture
}

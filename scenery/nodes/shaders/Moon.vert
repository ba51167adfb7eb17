// SPDX-License-Identifier: Apache-2.0
// Places a square around the moon on the far plane.

#version 130
out vec2 onDisc;
out vec3 discRight;
out vec3 discUp;
uniform vec3 moonDirection;
uniform float moonRadius; // radians
uniform mat4 osg_ViewMatrix;
void main()
{
    const float kMargin = 1.3;
    discRight = normalize(cross(moonDirection, vec3(0.0, 0.0, 1.0)) + vec3(1e-5, 0.0, 0.0));
    discUp = cross(discRight, moonDirection);
    onDisc = kMargin * gl_Vertex.xy;
    vec3 world = moonDirection + moonRadius * (onDisc.x * discRight + onDisc.y * discUp);
    gl_Position = gl_ProjectionMatrix * vec4(mat3(osg_ViewMatrix) * world, 0.0);
    gl_Position.z = gl_Position.w;
}

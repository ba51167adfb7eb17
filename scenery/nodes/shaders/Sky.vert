// SPDX-License-Identifier: Apache-2.0
// Draws a rectangle on the far plane. The direction of a pixel is exact at any field of view, on or off the axis.

#version 130
out vec3 direction;
uniform mat4 osg_ViewMatrixInverse;
void main()
{
    vec4 farPoint = gl_ProjectionMatrixInverse * vec4(gl_Vertex.xy, 1.0, 1.0);
    direction = mat3(osg_ViewMatrixInverse) * (farPoint.xyz / farPoint.w);
    gl_Position = vec4(gl_Vertex.xy, 1.0, 1.0);
}

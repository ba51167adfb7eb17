// SPDX-License-Identifier: Apache-2.0
// Draws a rectangle over the whole picture. Gives the direction of a pixel, exact at any field of view, on or off the axis, and its place.

#version 130
out vec3 direction;
out vec2 place;
uniform mat4 osg_ViewMatrixInverse;
void main()
{
    vec4 farPoint = gl_ProjectionMatrixInverse * vec4(gl_Vertex.xy, 1.0, 1.0);
    direction = mat3(osg_ViewMatrixInverse) * (farPoint.xyz / farPoint.w);
    place = 0.5 * gl_Vertex.xy + 0.5;
    gl_Position = vec4(gl_Vertex.xy, 1.0, 1.0);
}

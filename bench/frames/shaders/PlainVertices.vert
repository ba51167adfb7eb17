// SPDX-License-Identifier: Apache-2.0
// Takes the vertices of osgTerrain's geometry to the camera, and computes the outputs of Terrain.vert from them.

#version 330 compatibility
uniform vec3 benchEye;
uniform vec2 benchSpacing;
out vec3 fromEye;
out vec2 grid;

void main()
{
    fromEye = gl_Vertex.xyz - gl_ModelViewMatrixInverse[3].xyz;
    grid = (fromEye.xy + benchEye.xy) / benchSpacing;
    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
    gl_ClipDistance[0] = 1.0;
    gl_ClipDistance[1] = 1.0;
}

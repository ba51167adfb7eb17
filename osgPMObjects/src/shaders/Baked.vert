// SPDX-License-Identifier: Apache-2.0
// Takes a vertex of a baked model to the camera.

#version 120
varying vec3 bakedPlace; // position from the eye
varying vec2 bakedTexel;
void main()
{
    vec4 inView = gl_ModelViewMatrix * gl_Vertex;
    bakedPlace = inView.xyz;
    bakedTexel = gl_MultiTexCoord0.xy;
    gl_ClipVertex = inView;
    gl_Position = ftransform();
}

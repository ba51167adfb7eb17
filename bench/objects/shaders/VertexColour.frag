// SPDX-License-Identifier: Apache-2.0
// Writes the colour of the vertex stage.

#version 120
varying vec3 colour;
void main() { gl_FragColor = vec4(colour, 1.0); }

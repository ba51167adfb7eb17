// SPDX-License-Identifier: Apache-2.0
// Takes a vertex to the camera, for objects without a program of their own.

out vec3 normalInView;
out vec3 inView;
out vec4 colour;
out vec2 textureAt;
void main()
{
    vec4 placed = pmInView(pmPosition());
    inView = placed.xyz;
    normalInView = pmNormalInView(pmNormal());
    colour = pmColour();
    textureAt = (gl_TextureMatrix[0] * vec4(pmTexCoord0(), 0.0, 1.0)).xy;
    gl_Position = gl_ProjectionMatrix * placed;
    pmShow();
}

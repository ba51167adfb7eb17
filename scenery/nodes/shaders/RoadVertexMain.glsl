// SPDX-License-Identifier: Apache-2.0
// Takes a vertex of the road to the camera.

void main()
{
    gl_Position = gl_ProjectionMatrix * vec4(roadInView(), 1.0);
}

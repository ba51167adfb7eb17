// SPDX-License-Identifier: Apache-2.0
// Takes a vertex of an object to the camera. All positions are relative to the eye: floats do not hold positions in a world
// of tens of kilometres.

out vec3 fromEye;      // world axes, origin at the eye
out vec3 normalWorld;
out vec4 colour;
out vec2 textureAt;
uniform mat4 osg_ViewMatrixInverse;
void main()
{
    vec4 inView = pmInView(pmPosition());
    mat3 worldFromView = mat3(osg_ViewMatrixInverse);
    fromEye = worldFromView * inView.xyz;
    normalWorld = worldFromView * pmNormalInView(pmNormal());
    colour = pmColour();
    textureAt = pmTexCoord0();
    gl_Position = gl_ProjectionMatrix * inView;
    pmShow();
}

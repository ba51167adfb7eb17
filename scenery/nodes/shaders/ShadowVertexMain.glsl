// SPDX-License-Identifier: Apache-2.0
// A shadow that lies on the ground. Its vertices are on the true surface; the drawn one may differ by a pixel, so the shadow is
// drawn a little nearer to the eye, along the line of sight: it keeps its place in the picture, and does not fight for depth. GLSL 1.30.

out vec3 fromEye;
out vec2 maskAt;
uniform mat4 osg_ViewMatrixInverse;
const float kNearerM = 0.03;
const float kNearerShare = 0.012;
void main()
{
    vec4 inView = gl_ModelViewMatrix * gl_Vertex;
    float distanceM = max(length(inView.xyz), 0.1);
    fromEye = mat3(osg_ViewMatrixInverse) * inView.xyz;
    maskAt = gl_MultiTexCoord0.xy;
    inView.xyz *= 1.0 - min((kNearerM + kNearerShare * distanceM) / distanceM, 0.3);
    gl_Position = gl_ProjectionMatrix * inView;
}

// SPDX-License-Identifier: Apache-2.0
// The ground that a street lamp lights: a square that lies on it. Colour: of the lamp. Texture coordinates: metres from below the lamp, and its height.
// GLSL 1.30.

out vec3 fromEye;
out vec3 light;
out vec3 fromLampM;
uniform mat4 osg_ViewMatrixInverse;
void main()
{
    vec4 inView = gl_ModelViewMatrix * gl_Vertex;
    float distanceM = max(length(inView.xyz), 0.1);
    inView.xyz *= 1.0 - min(0.3, (0.25 + 0.004 * distanceM) / distanceM); // before ground and roads, which are drawn some pixels apart
    fromEye = mat3(osg_ViewMatrixInverse) * inView.xyz;
    light = gl_Color.rgb;
    fromLampM = vec3(gl_MultiTexCoord0.xyz);
    gl_Position = gl_ProjectionMatrix * inView;
}

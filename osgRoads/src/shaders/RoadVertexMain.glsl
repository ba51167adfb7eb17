// SPDX-License-Identifier: Apache-2.0
// The main function of the program for roads without an atmosphere.

out vec3 roadNormalInView;
void main()
{
    vec3 inView = roadInView();
    roadNormalInView = roadEyeFromLocal * roadNormal.xyz;
    gl_Position = gl_ProjectionMatrix * vec4(inView, 1.0);
}

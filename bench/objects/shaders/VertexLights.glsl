// SPDX-License-Identifier: Apache-2.0
// Lights each vertex by LAMPS lamps: a load for the vertex stage that the benchmark can choose.

uniform vec4 lamps[LAMPS];
varying vec3 colour;
void main()
{
    vec3 place = gl_Vertex.xyz;
    vec3 normal = normalize(gl_Normal);
    vec3 toEye = normalize(gl_ModelViewMatrixInverse[3].xyz - place);
    vec3 sum = vec3(0.05);
    for (int i = 0; i < LAMPS; ++i)
    {
        vec3 toLamp = normalize(lamps[i].xyz - place);
        float shine = max(dot(normal, normalize(toLamp + toEye)), 0.0);
        vec3 tint = vec3(0.6 + 0.4 * lamps[i].w, 0.8, 1.0 - 0.4 * lamps[i].w);
        sum += tint * (max(dot(normal, toLamp), 0.0) + 0.3 * pow(shine, 16.0));
    }
    colour = sum * (2.0 / float(LAMPS));
    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
}

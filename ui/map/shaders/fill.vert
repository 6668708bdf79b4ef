#version 440

layout(location = 0) in vec2 point;
layout(location = 0) out vec2 pixel;

layout(std140, binding = 0) uniform buf {
    mat4 matrix;
    vec4 color;
    vec4 hatch;  // pixels per unit, distance of the lines (0: none), their width, device pixels per pixel
};

void main() {
    gl_Position = matrix * vec4(point, 0.0, 1.0);
    pixel = point * hatch.x;
}

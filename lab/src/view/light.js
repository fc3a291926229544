// How surfaces are lit: one light from above and the left of the first view, as in the films.
import { Matrix3, Vector2, Vector3 } from "three";

/** Towards the light, world. */
export const LIGHT = new Vector3(0.5, -0.42, 0.85).normalize();

/**
 * What all materials share: the light, how normals turn from the data's world to the drawn one, the picture's size, px,
 * how many of them a CSS px is, and how clearly what lies flat on the plate is seen.
 */
export const sharedUniforms = () => ({
  uLight: { value: LIGHT }, uTurn: { value: new Matrix3() }, uViewport: { value: new Vector2(1, 1) },
  uRatio: { value: 1 }, uClear: { value: 1 }, uEye: { value: new Vector3() },
});

/** GLSL for vertices: halfway between the light and the eye; every lit surface hands it on with its normal. */
export const HALFWAY = /* glsl */ `
  uniform vec3 uLight, uEye;
  varying vec3 vNormal, vHalfway;
  void face(vec3 normal, vec3 at) {
    vNormal = normal;
    vHalfway = normalize(uLight + normalize(uEye - at));
  }
`;

/** GLSL: how light a matt surface is, ambient and diffuse. @param {string} normal its name there */
export const MATT = (normal) => `(0.56 + 0.06 * ${normal}.z + 0.46 * max(dot(${normal}, uLight), 0.0))`;

/** GLSL for fragments: how light a surface is, matt and in its shine. */
export const LIT = /* glsl */ `
  uniform vec3 uLight;
  varying vec3 vNormal, vHalfway;
  float matt(vec3 normal) {
    return ${MATT("normal")};
  }
  float shine(vec3 normal) {
    float s = max(dot(normal, vHalfway), 0.0);
    s *= s; s *= s; s *= s; s *= s;
    return s * s;
  }
`;
